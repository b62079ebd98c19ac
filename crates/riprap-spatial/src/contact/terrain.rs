//! Terrain: what is terrain, and which blocks it acts on.
//!
//! Every rigid block that can move is in a pair with each terrain ([`super::narrow::OnGround`]): such pairs need no candidate list, since
//! a block looks at the triangles near it when it has gone far enough.

use crate::contact::drop_pair;
use crate::kernel::{PairKey, Terrain};
use crate::ledger::Works;
use crate::setup;
use crate::state::contact_scratch::ContactScratch;
use crate::state::found::FoundPair;
use crate::state::world::World;

impl World {
    /// Whether there is terrain that blocks can meet.
    #[must_use]
    pub fn has_terrain(&self) -> bool {
        !self.found.left_terrain.is_empty()
    }

    /// Number of pairs of blocks that are near each other; those with terrain are not searched for.
    #[must_use]
    pub fn near_pairs(&self) -> usize {
        let pairs = self.found.pairs.iter();
        pairs.filter(|pair| !self.is_terrain(pair.ends[0] as usize)).count()
    }

    /// Whether terrain acts on block `b`.
    pub(crate) fn meets_terrain(&self, b: usize) -> bool {
        self.alive[b] && self.is_free(b) && !self.deforms(b) && !self.is_terrain(b)
    }
}

/// Makes the surfaces of terrain ready, where they have changed.
pub(super) fn prepare(world: &mut World, desk: &mut ContactScratch) {
    if !world.has_terrain() {
        return;
    }
    let n = world.alive.len();
    world.found.left_terrain.resize(n, false);
    if !world.fresh && !desk.terrain.blocks.is_empty() {
        return;
    }
    let there = |b: &usize| world.alive[*b] && world.is_terrain(*b);
    let blocks: Vec<u32> = (0..n).filter(there).map(|b| b as u32).collect();
    if blocks != desk.terrain.blocks {
        desk.terrain.grounds = blocks.iter().map(|b| ground(world, *b)).collect();
        desk.terrain.blocks = blocks;
        desk.ready = false;
    }
}

/// Adds the pairs of all blocks with terrain to those that were searched for, sorted by block; `old`: those until now.
pub(super) fn add_pairs(
    world: &World,
    grounds: &[u32],
    old: Vec<FoundPair>,
    pairs: &mut Vec<FoundPair>,
    dropped: &mut Works,
) {
    let by_block = |[ground, b]: [u32; 2]| [b, ground];
    let mut old = old.into_iter().peekable();
    let blocks = (0..world.alive.len()).filter(|b| !grounds.is_empty() && world.meets_terrain(*b));
    for ends in blocks.flat_map(|b| grounds.iter().map(move |ground| [*ground, b as u32])) {
        while let Some(gone) = old.next_if(|pair| by_block(pair.ends) < by_block(ends)) {
            drop_pair(dropped, &gone);
        }
        let known = old.next_if(|pair| pair.ends == ends);
        let mut pair = known.unwrap_or_else(|| FoundPair::new(PairKey::plain(ends)));
        if world.fresh {
            // An edit may have changed what lies near.
            pair.gap = 0.0;
        }
        pairs.push(pair);
    }
    old.for_each(|gone| drop_pair(dropped, &gone));
}

/// The surface of a terrain block, ready for contact.
fn ground(world: &World, b: u32) -> Terrain {
    match &world.setup.blocks[b as usize].shape {
        setup::Shape::Terrain(surface) => Terrain::new(surface.field()),
        setup::Shape::Brick { .. } | setup::Shape::Polyhedron(_) | setup::Shape::Glued(_) => {
            Terrain::default()
        }
    }
}

#[cfg(test)]
pub(super) mod tests;
