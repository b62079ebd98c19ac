//! Bolts follow blocks that are split, cut or taken out.

use crate::anchor::Anchor;
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
    bolt.pins = heirs.into_iter().flatten().collect();
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
