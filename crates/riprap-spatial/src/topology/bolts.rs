//! Bolts follow blocks that are split, cut or taken out.

use riprap_geom::Vec3;

use crate::faces::region::holds;
use crate::push::bolts::inside::TetFan;
use crate::state::anchor::Inside;
use crate::state::bolts::{Bolt, Dowel, Pin};
use crate::state::lineage::ancestor;
use crate::state::world::World;

/// A point of a divided block that is no more than this share of a tetrahedron outside a part still belongs to it: faces may be a little
/// crooked.
const LOOSE: f64 = 1e-3;

/// Hangs bolts on the parts of blocks that have been split or cut; nodes in blocks that are gone go, and so does a bolt of which fewer than two
/// are left. Forces must be evaluated anew afterwards.
pub fn follow(world: &mut World) {
    let gone = |bolt: &Bolt| bolt.blocks().any(|b| !world.alive[b as usize]);
    if !world.bolts.iter().any(gone) {
        return;
    }
    let mut bolts = world.bolts.clone();
    for bolt in &mut bolts {
        hand_on(world, bolt);
    }
    bolts.retain(|bolt| bolt.pins.len() > 1);
    world.bolts = bolts;
}

fn hand_on(world: &World, bolt: &mut Bolt) {
    let heirs: Vec<Option<Pin>> = bolt.pins.iter().map(|pin| heir(world, pin)).collect();
    let stays: Vec<bool> = heirs.iter().map(Option::is_some).collect();
    let kept = bolt.chain.keep(&stays);
    bolt.dowels.retain_mut(|dowel| {
        let sides = [0, 1].map(|s| heir(world, &dowel.sides[s]));
        match (sides, kept.bar(dowel.bar as usize)) {
            ([Some(a), Some(b)], Some(bar)) => {
                dowel.sides = [a, b];
                dowel.bar = bar as u32;
                true
            }
            _ => false,
        }
    });
    bolt.chain = kept.chain;
    let before = std::mem::take(&mut bolt.pins);
    bolt.pins = heirs.iter().flatten().copied().collect();
    if world.setup.bolts[bolt.number as usize].design.dowel.is_none() {
        return;
    }
    let old: Vec<&Pin> = before.iter().zip(&stays).filter(|s| *s.1).map(|s| s.0).collect();
    for k in 0..bolt.chain.bars.len() {
        let (ends, parts) = ([old[k], old[k + 1]], [bolt.pins[k], bolt.pins[k + 1]]);
        let cut = ends[0].block == ends[1].block && parts[0].block != parts[1].block;
        if let Some(sides) = cut.then(|| across(world, ends, parts)).flatten() {
            bolt.dowels.push(Dowel { bar: k as u32, sides, slip: Vec3::ZERO, force: Vec3::ZERO });
        }
    }
    bolt.dowels.sort_by_key(|dowel| dowel.bar);
}

/// The two sides of the crack that a bolt crosses between two points of what was one deformable block, each on its part; `None` in rigid
/// ones, whose parts are held by their patches alone as the block was.
fn across(world: &World, ends: [&Pin; 2], parts: [Pin; 2]) -> Option<[Pin; 2]> {
    let stars = [0, 1].map(|s| TetFan::at_start(world, parts[s].block as usize));
    let [Some(behind), Some(ahead)] = stars else {
        return None;
    };
    let [from, to] = ends.map(|pin| start(world, pin));
    let length = from.distance(to);
    let spans = behind.spans(from, (to - from) / length, [0.0, length]);
    let share = spans.first()?[1] / length;
    let mid = |a: f64, b: f64| a + share * (b - a);
    let both = |a: Vec3, b: Vec3| a + share * (b - a);
    // A point of the block between those of the two nodes, which it was not divided at.
    let at = both(from, to);
    let side = |star: &TetFan, part: &Pin| {
        let (anchor, _) = star.point(at)?;
        Some(Pin {
            block: part.block,
            anchor,
            along: mid(ends[0].along, ends[1].along),
            place: both(ends[0].place, ends[1].place),
            base: world.all_freedoms().displacement_inside(&anchor),
        })
    };
    Some([side(&behind, &parts[0])?, side(&ahead, &parts[1])?])
}

/// The same point on a block that is there: on the part of a divided block that holds it.
fn heir(world: &World, pin: &Pin) -> Option<Pin> {
    if world.alive[pin.block as usize] {
        return Some(*pin);
    }
    let start = start(world, pin);
    let (part, anchor) = match pin.anchor {
        Inside::Block { .. } => {
            // Of parts that share the point the first.
            let part = parts(world, pin.block).find(|b| {
                let shape = &world.setup.blocks[*b].shape;
                holds(shape, start)
            })?;
            let arm = start - world.reference[part];
            let block = part as u32;
            (block, Inside::Block { block, arm })
        }
        Inside::Tetrahedron { .. } => {
            let found = parts(world, pin.block).filter_map(|b| {
                let (inside, least) = TetFan::at_start(world, b)?.point(start)?;
                (least > -LOOSE).then_some((b, inside, least))
            });
            // The one that it lies deepest in; of equals the first.
            let (part, inside, _) = found.reduce(|a, b| if b.2 > a.2 { b } else { a })?;
            (part as u32, inside)
        }
    };
    Some(handed(world, pin, part, anchor))
}

/// Where a pin is in the rock as it was at the start, m.
fn start(world: &World, pin: &Pin) -> Vec3 {
    match (pin.anchor, world.deform.as_deref()) {
        (Inside::Block { block, arm }, _) => world.reference[block as usize] + arm,
        (inside, Some(deform)) => {
            let places = inside.nodes();
            places.map(|(n, w)| w * deform.nodes.place[n as usize]).sum()
        }
        (_, None) => pin.place,
    }
}

/// What is left of a block that has been divided.
fn parts(world: &World, block: u32) -> impl Iterator<Item = usize> {
    let descends = move |b: &usize| ancestor(&world.lineage, *b as u32, block + 1) == block;
    let after = block as usize + 1..world.alive.len();
    after.filter(move |b| world.alive[*b] && descends(b))
}

/// A pin that hangs on another block from now on and has moved by as much as before.
fn handed(world: &World, pin: &Pin, block: u32, anchor: Inside) -> Pin {
    let freedoms = world.all_freedoms();
    let there = freedoms.displacement_inside(&anchor);
    let jump = there - freedoms.displacement_inside(&pin.anchor);
    Pin { block, anchor, base: pin.base + jump, ..*pin }
}
