//! What pushes blocks from outside: loads, tractions, water, cavities, bolts, springs of faces.
//!
//! All of it goes into one buffer, [`Pushes`](crate::state::push::Pushes), through anchors or as force and moment on a rigid block:
//!
//! 1. `begin` clears the buffer at the head of an evaluation.
//! 2. Writers add to it, one after the other in the order of `step::evaluate`: loads, tractions on deformable blocks, water, cavities, bolts,
//!    bonds on rigid blocks; last, block by block in the gathering, faces of rigid blocks. A writer that comes later goes behind
//!    those that are there, so that their sums stay the same bits. What a writer adds must not depend on the number of threads.
//! 3. The account says who books the work. `loads`: given forces; the kick books `f . v` of both half steps as work of
//!    loads. `own`: the writer knows the potential or the dissipation behind its forces and books that itself.
//! 4. The kick adds to each block and node: patches or bonds, weight, `loads`, `own`.
//!
//! Rigid blocks that somebody may push are never done in rows: [`World::pushed`] names them when the pieces are laid
//! out (`Tiles::make_rows`), and only those are cleared. A writer that can push other blocks names them there.

pub mod bolts;
pub(crate) mod boundary;
pub mod charge;

pub(crate) mod cavity;
pub(crate) mod gas;
pub(crate) mod loads;
pub(crate) mod seepage;
pub(crate) mod surface;
pub(crate) mod traction;
pub(crate) mod water;

use crate::state::bolts::Bolt;
use crate::state::push::Wrench;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Clears the buffer for a new evaluation.
pub(crate) fn begin(scratch: &mut Scratch) {
    if std::mem::take(&mut scratch.pushes.wet) {
        scratch.pushes.loads.blocks.fill(Wrench::default());
    }
    for account in [&mut scratch.pushes.loads, &mut scratch.pushes.own] {
        account.clear(&scratch.tiles.special);
    }
}

impl World {
    /// Whether somebody may push each rigid block from outside, faces with a condition and water apart: that pushes blocks in rows, too.
    #[must_use]
    pub fn pushed(&self) -> Vec<bool> {
        let mut pushed = vec![false; self.alive.len()];
        let loads = self.setup.loads.iter().flat_map(|l| &l.blocks);
        let walls = self.cavities.iter().flat_map(|c| &c.walls);
        let facets = self.deform.iter().flat_map(|d| &d.facets);
        let bolts = self.bolts.iter().flat_map(Bolt::blocks);
        let cracks = self.gas.iter().flat_map(|gas| gas.cracks.iter().filter(|c| c.open));
        let all = loads.copied().chain(walls.map(|w| w.block)).chain(bolts);
        let all = all.chain(cracks.flat_map(|c| c.blocks));
        for b in all.chain(facets.flat_map(|f| f.blocks)) {
            pushed[b as usize] = true;
        }
        pushed
    }
}
