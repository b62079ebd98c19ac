//! Water tables.

use riprap_keys::Keys;
use serde::Deserialize;

use crate::quantity::{Angle, Density, Length, Quantity};

/// Standing water: below the table all faces of blocks are pressed by `density` times gravity times depth, in joints and
/// in the open. Exactly one of `level` and `points`.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Water {
    /// Height of a level table, m.
    pub level: Option<Quantity<Length>>,
    /// Corners [distance, height] of the table, m, distances (x in the plane) ascending; level beyond both ends.
    pub points: Option<Vec<[Quantity<Length>; 2]>>,
    /// Bearing, clockwise from north (y), in which distances from the origin grow. Default 90 deg: along x.
    #[key(space = "spatial", instead = "distances run along x")]
    pub azimuth: Option<Quantity<Angle>>,
    /// Density of the water, kg/m3.
    #[key(default = "1000 kg/m3")]
    pub density: Option<Quantity<Density>>,
}
