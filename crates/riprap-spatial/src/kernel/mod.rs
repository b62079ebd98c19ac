//! Contact of convex blocks that is found anew in each step: the equal-pressure law.
//!
//! Two convex blocks A and B overlap in `O`. With `phi` the depth of a point below the faces of its own block, the contact
//! stores `U = 2 kn int_O min(phi_A, phi_B) dV` and acts as a pressure `2 kn phi` on the one surface `S` where both depths
//! are equal. `S` consists of plane pieces, one for each pair of faces (f of A, g of B) that are the nearest ones there.
//! Only planes are needed: no overlap polyhedron is ever made.
//!
//! `shape` knows a block, `planes` those of a pair about a common origin, `peak` whether they touch and where to start,
//! `frame` the plane of a piece, `piece` its polygon (`octagon` the same in vector registers), `remnant` whether a face can have one, `sums` what pieces carry, `surface` all of them, `friction` the forces that follow;
//! `glued` is a block of convex parts, `terrain` one on a height field; `grid` finds boxes that touch; `limits` knows how long a step may be.
//!
//! Source: the pressure fields of Elandt, Drumwright, Sherman and Ruina (2019, arXiv 1904.11433), here with the exact depth
//! of a convex block instead of a field on tetrahedra.

pub mod cells;
pub mod frame;
pub mod friction;
pub mod glued;
pub mod grid;
mod lateral;
mod lever;
pub mod limits;
#[cfg(target_arch = "x86_64")]
mod octagon;
pub mod offset;
pub mod peak;
pub mod piece;
pub mod planes;
mod remnant;
pub mod ridges;
pub mod shape;
pub(crate) mod slip;
pub(crate) mod springs;
pub mod sums;
pub mod surface;
pub mod terrain;
pub mod tetra;

pub(crate) use friction::part;
pub use friction::{
    ContactLaw, Memory, Motion, Pieces, Pressing, Question, Reply, Shared, Wrench, pressing,
    respond, share,
};
pub use grid::Role;
pub use peak::{Peak, peak};
pub use planes::Planes;
pub use shape::{Body, Pose, Shape, ShapeError, turn};
pub use sums::Sums;
pub use surface::{Found, Pair, Walker};
pub use terrain::{Reached, Terrain, Under};

#[cfg(test)]
mod impacts;
#[cfg(test)]
pub(crate) mod kit;
#[cfg(test)]
mod tests;
