//! The tolerances of this crate, all relative to the size (diagonal of the box) of what is looked at.

/// Points nearer than this, times the size, are one point.
///
/// Crossing points carry a round-off of about 1e-16 sizes over the sine of the crossing angle, so
/// this merges what is meant to be one point down to angles of 1e-6 rad.
pub const SNAP: f64 = 1e-10;

/// Points of outlines and of single traces nearer than this, times the size, are one point.
///
/// Files write coordinates with a few digits, and programs compute what should be one point twice: edges of
/// nanometres are no shape of a block. A tenth of a micrometre in a block of 10 m.
pub const DRAWN: f64 = 1e-8;

/// A vertex nearer than this, times the size, to the line through its neighbours is not a corner.
///
/// Much smaller than `SNAP`: dropping a vertex changes the area by distance times edge length, and
/// the parts of a region must add up to its area within 1e-12.
pub const COLLINEAR: f64 = 1e-14;

/// An outline whose area is below this, times its size squared, has none.
pub const ZERO_AREA: f64 = 1e-12;

/// No outline may have more vertices.
pub const MAX_VERTICES: usize = 20_000;

/// No generator makes more blocks (or joint traces).
pub const MAX_BLOCKS: usize = 1_000_000;
