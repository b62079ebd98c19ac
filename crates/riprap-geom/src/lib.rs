//! Geometry for blocky rock: polygons, clipping, mass properties, Voronoi cells and joint-set
//! cutting. No mechanics, no units, no files: numbers in, numbers out.
//!
//! `polygon` knows one outline, `clip` two of them, `arrangement` a region cut by many segments.
//! `cut` (joint sets) and `voronoi` both make segments for `arrangement`, so that neighbouring
//! blocks share their vertices bit for bit; `heal` merges what is too small. `shapes` and `pack`
//! place ready-made blocks.
//!
//! `polyhedron` is the same for convex solids in space, `face_overlap` for the faces that two of them share;
//! `face_overlay` joins the nodes of such faces. `height_field` is terrain: a surface with one height per place.
//!
//! Random numbers come from one seeded generator and elementary functions from `libm`, so the same
//! input gives the same bits on every machine.

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod arrangement;
pub mod clip;
pub mod cut;
mod error;
pub mod face_overlap;
pub mod face_overlay;
pub mod heal;
pub mod height_field;
pub mod measure;
pub mod pack;
pub mod pairs;
pub mod polygon;
pub mod polyhedron;
pub mod random;
pub mod shapes;
pub mod surface;
pub mod symmetric;
pub mod tol;
pub mod voronoi;

/// 3 x 3 matrix, f64.
pub use glam::DMat3 as Mat3;
/// Unit quaternion, f64.
pub use glam::DQuat as Quat;
/// Vector in the plane, f64. Re-exported so that the version of the vector crate is named here only.
pub use glam::DVec2 as Vec2;
/// Vector in space, f64.
pub use glam::DVec3 as Vec3;

pub use error::GeomError;
