//! Given tractions on faces.

use riprap_geom::Vec3;

use crate::setup::{Boundary, BoundaryKind, InSitu};

/// A point of a face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    /// Unit outward normal at the start.
    pub start: Vec3,
    /// Unit outward normal along which pressures act now.
    pub normal: Vec3,
    /// Height (local z) at which the in-situ stress is taken, m.
    pub stress_at: f64,
    /// Height (local z) at which a pressure that grows with depth is taken, m.
    pub pressure_at: f64,
}

/// Traction (Pa) that a condition gives at a point of a face in the kick at time `time` (s) that spans the `half` steps (s) before and after it,
/// that of the stress at the start included.
#[must_use]
pub(crate) fn traction(
    boundary: &Boundary,
    in_situ: Option<&InSitu>,
    spot: &Spot,
    (time, half): (f64, [f64; 2]),
) -> Vec3 {
    let start = match (boundary.in_situ, in_situ) {
        (true, Some(in_situ)) => in_situ.at(spot.stress_at) * spot.start,
        (true, None) | (false, _) => Vec3::ZERO,
    };
    match &boundary.kind {
        BoundaryKind::Traction { traction, pressure, gradient, datum, time: factor } => {
            let pressure = pressure + gradient * (datum - spot.pressure_at);
            start + factor.in_kick(time, half) * (*traction - pressure * spot.normal)
        }
        BoundaryKind::Held { .. } | BoundaryKind::Moved { .. } | BoundaryKind::Viscous { .. } => {
            start
        }
    }
}
