//! What bolts add to the springs of the model, for the stable time step: the elastic chain as it was built.
//!
//! A chain in equilibrium is a spring between all points that it holds; yield, slip, lifting plates and rupture only make it softer.

use riprap_geom::Vec3;

use crate::anchor::Anchor;
use crate::laws::bolt::Factors;
use crate::state::bolts::{Bolt, Pin};
use crate::state::world::World;

/// The elastic springs of all bolts between rigid blocks.
pub struct BoltSprings<'a> {
    world: &'a World,
    factors: Vec<Factors>,
}

impl<'a> BoltSprings<'a> {
    /// Those of a world.
    #[must_use]
    pub fn new(world: &'a World) -> Self {
        let factors = world.bolts.iter().map(|b| b.chain.factors()).collect();
        Self { world, factors }
    }

    /// Adds forces and moments on blocks for a motion of them (translation and rotation of each).
    pub fn pull(&mut self, at: &[[Vec3; 2]], sum: &mut [[Vec3; 2]]) {
        let world = self.world;
        for (bolt, factors) in world.bolts.iter().zip(&mut self.factors) {
            let bars = bolt.chain.bars.len();
            let moved = |pin: &Pin| -> Vec3 {
                let [u, turn] = at[pin.block as usize];
                u + turn.cross(arm(world, pin))
            };
            let mut add = |pin: &Pin, force: Vec3| {
                let to = &mut sum[pin.block as usize];
                to[0] += force;
                to[1] += arm(world, pin).cross(force);
            };
            let ends = |k: usize| (&bolt.pins[k], &bolt.pins[k + 1]);
            let apart: Vec<f64> = (0..bars)
                .map(|k| {
                    let (from, to) = ends(k);
                    if from.block == to.block {
                        0.0
                    } else {
                        bolt.axis.dot(moved(to) - moved(from))
                    }
                })
                .collect();
            if apart.iter().any(|x| *x != 0.0) {
                let mut forces = vec![0.0; bars];
                factors.elastic_forces(&bolt.chain, &apart, &mut forces);
                for (k, force) in forces.into_iter().enumerate() {
                    let (from, to) = ends(k);
                    if from.block != to.block {
                        // As a patch: the force that holds the motion up.
                        add(from, -force * bolt.axis);
                        add(to, force * bolt.axis);
                    }
                }
            }
            let Some([stiffness, _]) = dowel(world, bolt) else {
                continue;
            };
            for dowel in &bolt.dowels {
                let [behind, ahead] = &dowel.sides;
                let jump = moved(ahead) - moved(behind);
                let force = stiffness * (jump - jump.dot(bolt.axis) * bolt.axis);
                add(behind, -force);
                add(ahead, force);
            }
        }
    }
}

/// Stiffness and limit of the dowels of a bolt.
fn dowel(world: &World, bolt: &Bolt) -> Option<[f64; 2]> {
    world.setup.bolts[bolt.number as usize].design.dowel
}

/// Present arm of a pin on a rigid block, m.
fn arm(world: &World, pin: &Pin) -> Vec3 {
    match pin.anchor {
        Anchor::Block { block, arm } => world.all_freedoms().arm(block, arm),
        Anchor::Nodes { .. } => Vec3::ZERO,
    }
}
