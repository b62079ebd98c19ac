//! Deformable blocks: nodes, tetrahedra, bonds between faces; static relaxation, dynamics, breaking.
//!
//! A deformable block is a convex polyhedron with nodes **[vertices | face centres | centroid]**, contiguous in the lists, and
//! the tetrahedra between them. Blocks are joined by **facets**, the shared parts of two faces, each with a short
//! run of **points**; a point hangs on up to three nodes of a face on each side (or on a rigid block) with weights that sum to
//! one and place the point in the same spot from both sides, so that a bond force keeps momentum and angular
//! momentum to round-off. Everything that acts on nodes goes through such weights.
//!
//! One evaluation: points (jump, law, force to its slot) -> blocks (stress, gathered slots, loads, velocity change). Every sum is
//! in a fixed order. [`Deform`] is state, [`Workspace`] can be dropped and rebuilt.
//!
//! Cutting (the room `topology`) appends the nodes of the parts and makes their facets anew; [`store::Deform::retire`] takes blocks out.

pub(crate) mod area;
pub mod bonds;
pub mod build;
pub mod elements;
pub mod in_situ;
mod kick;
pub mod overlay;
pub mod phase;
pub mod relax;
pub mod step;
pub(crate) mod turn;
mod workspace;

use crate::state::world::World;

/// Lets `act` change the deformable blocks beside the rest of the world, in which they are missing meanwhile: for what lays out lists of both,
/// never within a step. `None` where nothing deforms.
pub(crate) fn beside<T>(
    world: &mut World,
    act: impl FnOnce(&mut World, &mut Deform) -> T,
) -> Option<T> {
    let mut deform = world.deform.take()?;
    let done = act(world, &mut deform);
    world.deform = Some(deform);
    Some(done)
}

pub use crate::state::deform::Deform;
pub use crate::state::workspace::Workspace;
pub use crate::state::{deform as store, hold};
