//! Further things that can be read from a spatial model: average stress of one block, the free surface,
//! displacements since a reset.

use riprap_geom::Vec3;

use crate::query::view::View;
use crate::setup::BoundaryKind;
use crate::state::cavity::Cavity;
use crate::state::world::World;

/// Least cosine between the outward normal of a face and the direction against gravity for the face to be
/// part of the free surface: 45 deg.
const UPWARD: f64 = 0.7;

impl View<'_> {
    /// Direction against gravity; z without gravity.
    #[must_use]
    pub fn up(&self) -> Vec3 {
        let gravity = self.world.setup.gravity;
        (-gravity).try_normalize().unwrap_or(Vec3::Z)
    }

    /// Sum over the blocks of `m dv² + dL·dw` of the coming kick: what the ledger needs where the step changes.
    #[must_use]
    pub fn half_kick(&self) -> f64 {
        let one = |b: usize| {
            if let Some(deformable) = self.deformable(b) {
                return deformable.half_kick();
            }
            let solid = self.world.solid_of(b);
            let change = (self.world).ungiven(b, self.scratch.change(self.world, b));
            solid.mass * change.velocity.length_squared() + change.spin.dot(change.momentum)
        };
        let alive = &self.world.alive;
        let of = |b: usize| if alive[b] { one(b) } else { 0.0 };
        self.scratch.exec.sum(alive.len(), of)
    }

    /// Displacement (m) and rotation vector (rad) of every block since the start.
    #[must_use]
    pub fn present_poses(&self) -> Vec<[Vec3; 2]> {
        let pose = |b: usize| match self.deformable(b) {
            Some(deformable) => [deformable.displacement(), deformable.rotation()],
            None => [self.world.bodies.displacement(b), self.world.bodies.rotation(b)],
        };
        (0..self.world.bodies.len()).map(pose).collect()
    }

    /// Charges and other pressures inside the rock, in the order of the sources.
    #[must_use]
    pub fn cavities(&self) -> &[Cavity] {
        &self.world.cavities
    }

    /// What gas and other pressures in cavities push with, on walls and on the sides of cracks: block, present arm from its centroid (m), force (N).
    pub fn cavity_forces(&self) -> impl Iterator<Item = (usize, Vec3, Vec3)> + '_ {
        let world = self.world;
        let walls = world.cavities.iter().flat_map(|c| c.forces(world));
        walls.chain(world.gas.iter().flat_map(|gas| gas.forces(world)))
    }

    /// Whether each block has a face in the free surface: one that looks up and on which nothing but a traction
    /// acts.
    #[must_use]
    pub fn surface(&self) -> Vec<bool> {
        let (world, up) = (self.world, self.up());
        let mut surface = vec![false; world.alive.len()];
        for face in &world.faces {
            let free = !face.parted
                && face.boundary.is_none_or(|k| {
                    matches!(world.setup.boundaries[k as usize].kind, BoundaryKind::Traction { .. })
                });
            if free && face.frame[0].dot(up) > UPWARD {
                surface[face.block as usize] = world.alive[face.block as usize];
            }
        }
        surface
    }

    /// A vector of the start turned with a block.
    pub(super) fn turned(&self, b: usize, v: Vec3) -> Vec3 {
        match &self.world.turned[b] {
            Some(turned) => turned.attitude * v,
            None => v,
        }
    }
}

impl World {
    /// Number of splits between a block as given and block `b`.
    #[must_use]
    pub fn level(&self, b: usize) -> u8 {
        self.lineage[b].level
    }

    /// Measures displacements (m) and rotations (rad) from these on; [`View::present_poses`] gives the present ones.
    pub fn zero_displacements(&mut self, poses: Vec<[Vec3; 2]>) {
        self.datum = poses;
        let nodes = self.deform.as_deref().map(|deform| deform.nodes.displacement.clone());
        self.node_datum = nodes.unwrap_or_default();
    }

    /// Displacement (m) and rotation vector (rad) at which those of outputs are zero.
    #[must_use]
    pub fn datum(&self, b: usize) -> [Vec3; 2] {
        self.datum.get(b).copied().unwrap_or_default()
    }

    /// Stops all blocks.
    pub fn halt(&mut self) {
        for b in 0..self.bodies.len() {
            self.bodies.set_velocity(b, Vec3::ZERO, Vec3::ZERO);
            if let Some(turned) = &mut self.turned[b] {
                turned.momentum = Vec3::ZERO;
            }
        }
        if let Some(deform) = &mut self.deform {
            deform.nodes.velocity.fill([0.0; 3]);
        }
        self.last_dt = 0.0;
    }
}
