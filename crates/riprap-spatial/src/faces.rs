//! Faces that two solids share, and what of a face is free: rectangles of bricks, polygons of polyhedra, places and boxes that find them.

pub(crate) mod bricks;
pub(crate) mod deformable;
pub mod divisible;
pub(crate) mod overlap;
pub mod region;
pub(crate) mod solids;
