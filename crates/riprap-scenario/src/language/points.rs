//! Points of both spaces, as lists of lengths.

use crate::quantity::{Length, Quantity};

/// A point of the plane: [x, y], x to the right, y up, m.
pub type Point = [Quantity<Length>; 2];

/// A point of space: [x, y, z], x east, y north, z up, m.
pub type Point3 = [Quantity<Length>; 3];
