//! Water tables.

use riprap_keys::Keys;
use serde::Deserialize;

use super::ground::Side;
use super::solids::BoxRegion;
use crate::quantity::{Angle, Density, Length, Name, PositiveLength, Quantity, Viscosity};
use crate::vectors::Vector;

/// Below the table all faces of blocks are pressed by `density` times gravity times depth.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("level", "points", "csv"))]
pub struct Water {
    /// Height of a level table, m.
    pub level: Option<Quantity<Length>>,
    /// Corners [distance, height] of the table, m, distances (x in the plane) ascending; level beyond both ends.
    pub points: Option<Vec<[Quantity<Length>; 2]>>,
    /// Path of a CSV file: `x_m`, `y_m`, `z_m` of a rectangular grid; beyond it as at its rim.
    #[key(space = "spatial", instead = "give its corners (`points`)")]
    pub csv: Option<Name>,
    /// Bearing, clockwise from north (y), in which distances from the origin grow: 90 deg is along x.
    #[key(default = "90 deg", space = "spatial", instead = "distances run along x")]
    #[key(only_with("points"))]
    pub azimuth: Option<Quantity<Angle>>,
    /// Density of the water, kg/m3.
    #[key(default = "1000 kg/m3")]
    pub density: Option<Quantity<Density>>,
    /// Box in which faces of blocks lie at the start that the table presses on. Default everywhere.
    #[key(excludes(
        "seepage",
        help = "with seepage the table is the head on all open faces: leave one of them out"
    ))]
    pub within: Option<BoxRegion>,
    /// Steady flow through the joints: the table is then the head on open faces alone.
    pub seepage: Option<Seepage>,
}

/// Steady seepage through the joints of the start, laminar in each of them; part of it dry where the pressure is nothing.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Seepage {
    /// Hydraulic aperture of joints at the start, m; their opening adds to it.
    pub aperture: Quantity<PositiveLength>,
    /// Smallest hydraulic aperture, m. Default a tenth of `aperture`.
    pub aperture_min: Option<Quantity<PositiveLength>>,
    /// Largest hydraulic aperture, m. Default ten times `aperture`.
    pub aperture_max: Option<Quantity<PositiveLength>>,
    /// Dynamic viscosity of the water, Pa s.
    #[key(default = "1e-3 Pa s")]
    pub viscosity: Option<Quantity<Viscosity>>,
    /// Sides of the model through which no water goes. Default `["y-min"]`, in space `["z-min"]`.
    pub closed: Option<Vec<Side>>,
    /// Steps after which heads are found anew with the apertures of the moment.
    #[key(default = 100, min = 1)]
    pub every: Option<u64>,
    /// Drains.
    #[serde(default)]
    pub drains: Vec<Drain>,
}

/// A line of drain holes: it takes water out of the joints that it crosses.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Drain {
    /// One end, m.
    pub from: Vector<Length>,
    /// The other end, m.
    pub to: Vector<Length>,
    /// Where the last hole of the row begins, m: all holes are as long and as steep as that from `from` to `to`.
    #[key(space = "spatial", instead = "a line drains along all of its length")]
    pub row_end: Option<Vector<Length>>,
    /// Head that it holds, m. Default none: there is no pressure at the drain.
    pub head: Option<Quantity<Length>>,
}
