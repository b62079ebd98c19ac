//! Contact of convex blocks that is found anew in each step: the equal-pressure law.
//!
//! Two convex blocks A and B overlap in `O`. With `phi` the depth of a point below the faces of its own block, the contact
//! stores `U = 2 kn int_O min(phi_A, phi_B) dV` and acts as a pressure `2 kn phi` on the one surface `S` where both depths
//! are equal. `S` consists of plane pieces, one for each pair of faces (f of A, g of B) that are the nearest ones there.
//! Only planes are needed: no overlap polyhedron is ever made.
//!
//! `shape` knows a block, `planes` those of a pair about a common origin, `peak` whether they touch and where to start,
//! `frame` the plane of a piece, `piece` its polygon (`octagon` the same in vector registers), `face_clip` whether a face can have one, `sums` what pieces carry, `stiffening` what they carry beyond the depth, `surface` all of them, `walls` what other blocks cover of it, `friction` the forces that follow;
//! `glued` is a block of convex parts, `terrain` one on a height field; `grid` finds boxes that touch, `image` names those of a periodic model; `limits` knows how long a step may be.
//!
//! Source: the pressure fields of Elandt, Drumwright, Sherman and Ruina (2019, arXiv 1904.11433), here with the exact depth
//! of a convex block instead of a field on tetrahedra.

pub(crate) mod cells;
mod face_clip;
pub(crate) mod frame;
pub(crate) mod friction;
pub(crate) mod glued;
pub(crate) mod grid;
pub(crate) mod image;
mod lateral;
mod lever;
pub mod limits;
#[cfg(target_arch = "x86_64")]
mod octagon;
pub(crate) mod offset;
pub(crate) mod peak;
pub(crate) mod piece;
pub(crate) mod planes;
pub(crate) mod ridges;
pub(crate) mod shape;
pub(crate) mod slip;
pub(crate) mod springs;
mod stiffening;
pub(crate) mod sums;
pub(crate) mod surface;
pub(crate) mod terrain;
pub(crate) mod tetra;
mod walls;

pub(crate) use friction::part;
pub(crate) use friction::{ContactInput, ContactLaw, Memory, Motion, contact_force};
pub(crate) use grid::Role;
pub(crate) use image::{Image, PairKey, Periods};
pub(crate) use shape::{Body, Pose, Shape, turn};
pub(crate) use sums::Sums;
pub(crate) use surface::{Found, Pair};
pub(crate) use terrain::{Reached, Terrain};

#[cfg(test)]
#[path = "tests/impacts.rs"]
mod impacts;
#[cfg(test)]
#[path = "tests/kit.rs"]
pub(crate) mod kit;
#[cfg(test)]
mod tests;
