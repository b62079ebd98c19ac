//! Geometry for blocky rock: polygons, clipping, mass properties, Voronoi cells and joint-set
//! cutting. No mechanics, no units, no files: numbers in, numbers out.

/// Vector in the plane, f64. Re-exported so that the version of the vector crate is named here only.
pub use glam::DVec2 as Vec2;
