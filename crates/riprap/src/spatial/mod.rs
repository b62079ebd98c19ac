//! The 3D engine: rigid blocks joined by face patches, boundaries, gas cavities, splitting.

pub mod setup;
