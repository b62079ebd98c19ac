//! Stress of the rock at the start.

use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use super::tetrahedron::tensor;

/// Stress at the start, linear in height (z in space, y in the plane); all joints carry it at t = 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct InSitu {
    /// xx, yy, zz, yz, zx, xy at height `datum`, Pa, tension-positive.
    pub stress: [f64; 6],
    /// Change for each metre of depth below `datum`, Pa/m, tension-positive.
    pub gradient: [f64; 6],
    /// Height (local), m.
    pub datum: f64,
}

impl InSitu {
    /// Stress tensor at a height (m), Pa, tension-positive.
    #[must_use]
    pub fn at(&self, height: f64) -> Mat3 {
        let depth = self.datum - height;
        tensor(std::array::from_fn(|k| self.stress[k] + self.gradient[k] * depth))
    }

    /// Change of the stress tensor for each metre upward, Pa/m.
    #[must_use]
    pub fn upward(&self) -> Mat3 {
        -tensor(self.gradient)
    }

    /// Traction (Pa) at a height (m) on a plane with the unit normal `n`.
    #[must_use]
    pub fn traction(&self, height: f64, n: Vec3) -> Vec3 {
        self.at(height) * n
    }
}
