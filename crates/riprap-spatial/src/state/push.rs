//! What acts on a rigid block.

use riprap_geom::Vec3;

/// Force (N) and moment (N m) about the centroid on the block of a face.
#[derive(Clone, Copy, Debug, Default)]
pub struct Push {
    /// Force, N.
    pub force: Vec3,
    /// Moment, N m.
    pub moment: Vec3,
}

impl Push {
    /// Adds a force (N) at an arm (m) from the centroid.
    pub fn add(&mut self, force: Vec3, arm: Vec3) {
        self.force += force;
        self.moment += arm.cross(force);
    }

    /// Power (W) on a block with this velocity and spin.
    #[must_use]
    pub fn power(&self, velocity: Vec3, spin: Vec3) -> f64 {
        self.force.dot(velocity) + self.moment.dot(spin)
    }
}
