//! The 3D engine: rigid blocks joined by face patches, boundaries, gas cavities, splitting.

pub mod refine;
pub mod region;
pub mod setup;
