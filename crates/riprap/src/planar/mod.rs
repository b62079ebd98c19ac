//! The 2D engine: rigid polygons with mutual-potential contact.

pub mod setup;
