//! Bolts follow blocks that are split, cut or taken out.

use crate::anchor::Anchor;
use crate::laws::bolt::{Bar, Chain};
use crate::region::holds;
use crate::state::bolts::{Bolt, Pin};
use crate::state::lineage::Origin;
use crate::state::world::World;

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
    let kept: Vec<Option<Pin>> = bolt.pins.iter().map(|pin| heir(world, pin)).collect();
    let nodes: Vec<usize> = (0..kept.len()).filter(|k| kept[*k].is_some()).collect();
    // Bar `k` becomes the one behind the last node that is left up to it.
    let place = |k: usize| nodes.partition_point(|n| *n <= k).checked_sub(1);
    bolt.dowels.retain_mut(|dowel| {
        let heirs = [0, 1].map(|s| heir(world, &dowel.sides[s]));
        let bar = place(dowel.bar as usize).filter(|bar| bar + 1 < nodes.len());
        match (heirs, bar) {
            ([Some(a), Some(b)], Some(bar)) => {
                dowel.sides = [a, b];
                dowel.bar = bar as u32;
                true
            }
            _ => false,
        }
    });
    let old = std::mem::take(&mut bolt.chain);
    let of = |list: &[f64]| nodes.iter().map(|k| list[*k]).collect::<Vec<f64>>();
    let mut chain = Chain::new(nodes.iter().map(|k| old.holds[*k]).collect(), Vec::new());
    (chain.motion, chain.slip) = (of(&old.motion), of(&old.slip));
    for ends in nodes.windows(2) {
        let bars = ends[0]..ends[1];
        chain.bars.push(in_series(&old.bars[bars.clone()]));
        chain.plastic.push(old.plastic[bars.clone()].iter().sum());
        chain.path.push(old.path[bars.clone()].iter().sum());
        chain.force.push(old.force[bars.start]);
    }
    bolt.chain = chain;
    bolt.pins = kept.into_iter().flatten().collect();
}

/// Bars one behind the other as one.
fn in_series(bars: &[Bar]) -> Bar {
    let mut all = bars[0];
    if bars.iter().any(|bar| bar.stiffness == 0.0) {
        all.stiffness = 0.0;
        return all;
    }
    all.stiffness = 1.0 / bars.iter().map(|bar| 1.0 / bar.stiffness).sum::<f64>();
    if all.hardening > 0.0 {
        all.hardening = 1.0 / bars.iter().map(|bar| 1.0 / bar.hardening).sum::<f64>();
    }
    all
}

/// The same point on a block that is there: on the part of a divided block that holds it.
fn heir(world: &World, pin: &Pin) -> Option<Pin> {
    if world.alive[pin.block as usize] {
        return Some(*pin);
    }
    let Anchor::Block { arm, .. } = pin.anchor else {
        return None;
    };
    let start = world.reference[pin.block as usize] + arm;
    let descends = |b: u32| {
        let mut of = b;
        while of != Origin::NONE && of != pin.block {
            of = world.lineage[of as usize].parent;
        }
        of == pin.block
    };
    // Of parts that share the point the first.
    let after = pin.block as usize + 1;
    let part = (after..world.alive.len()).find(|b| {
        let shape = &world.setup.blocks[*b].shape;
        world.alive[*b] && descends(*b as u32) && holds(shape, start)
    })?;
    let anchor = Anchor::Block {
        block: part as u32,
        arm: start - world.reference[part],
    };
    let freedoms = world.all_freedoms();
    let jump = freedoms.displacement(&anchor) - freedoms.displacement(&pin.anchor);
    Some(Pin {
        block: part as u32,
        anchor,
        base: pin.base + jump,
        ..*pin
    })
}
