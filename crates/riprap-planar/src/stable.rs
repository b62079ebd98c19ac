//! Stable time step: which block sets it, and why.
//!
//! Bound per block, over all candidate contacts at their largest possible length, all active joints and bolts:
//! `K = 2 sum k (1/m + (r² + L²/12)/I)` with `k = max(kn, ks) L`, and the same sum of the dashpots for `C`. The
//! leapfrog with the velocity of half a step before in the dashpots is stable up to
//! `dt = (sqrt(C² + 4 K) - C) / K`, which is `2/w (sqrt(1 + xi²) - xi)` for a single oscillator.

use riprap_geom::Vec2;

use super::search::{Candidate, Candidates, is_held};
use super::setup::{ContactLaw, NormalLaw};
use super::shapes::Shapes;
use super::world::World;
use crate::laws::damping;

/// The largest stable step and the block that sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stable {
    /// Stable time step (safety 1), s; infinite when nothing can touch.
    pub dt: f64,
    /// Index of the block with the highest frequency.
    pub block: Option<u32>,
}

/// Finds the stable step for the present candidate list and laws; `stiffness_damping` is that of the
/// phase, s.
#[must_use]
pub fn stable_step(
    world: &World,
    shapes: &Shapes,
    candidates: &Candidates,
    stiffness_damping: f64,
) -> Stable {
    let mut sums = vec![Sums::default(); shapes.len()];
    for c in candidates.convex.iter().chain(&candidates.general) {
        let law = &world.setup.interfaces[c.row as usize].contact;
        let k = stiffness(law) * c.longest;
        let dash = c.dashpots[0].max(c.dashpots[1]) * c.longest.sqrt() + stiffness_damping * k;
        for block in [c.i as usize, c.j as usize] {
            let arm = arm(world, shapes, c, block);
            let reach = arm * arm + c.longest * c.longest / 12.0;
            sums[block].add(shapes, block, reach, k, dash);
        }
    }
    add_joints(&mut sums, world, shapes, stiffness_damping);
    for (block, reach, k) in world.bolt_springs() {
        sums[block].add(shapes, block, reach, k, 0.0);
    }
    // A block may come into contact along its longest edge between two looks at the list.
    let laws = world.setup.interfaces.iter().map(|i| &i.contact);
    let stiffest = laws.clone().map(stiffness).fold(0.0, f64::max);
    let ratio = laws.map(|l| l.damping_ratio).fold(0.0, f64::max);
    let table = world.table();
    let water = table.map_or(0.0, |table| table.stiffness(-world.setup.gravity[1]));
    let mut worst = Stable { dt: f64::INFINITY, block: None };
    for (b, sum) in sums.iter().enumerate() {
        if !world.alive[b] || is_held(world.motion[b].as_deref()) {
            continue;
        }
        let longest = shapes.of(b).iter().map(|e| e.length).fold(0.0, f64::max);
        let k = stiffest * longest;
        let dash = damping::dashpot(ratio, k, shapes.mass[b]) + stiffness_damping * k;
        let mut alone = Sums::default();
        alone.add(shapes, b, longest * longest / 12.0, k, dash);
        // What floats has the stiffness of the water over the length that the table cuts.
        let mut sum = *sum;
        let radius = shapes.radius[b];
        for sum in [&mut sum, &mut alone] {
            sum.add(shapes, b, radius * radius / 3.0, 2.0 * radius * water, 0.0);
        }
        let dt = sum.stable().min(alone.stable());
        if dt < worst.dt {
            worst = Stable { dt, block: Some(b as u32) };
        }
    }
    worst
}

fn add_joints(sums: &mut [Sums], world: &World, shapes: &Shapes, stiffness_damping: f64) {
    for bond in world.bonds.iter().filter(|b| b.active) {
        let Some(law) = &world.setup.interfaces[bond.row as usize].bond else {
            continue;
        };
        for point in &bond.points {
            let [kn, ks] = law.stiffest();
            let k = kn.max(ks) * point.weight;
            let mass = bond.mass * point.weight / bond.length;
            let dash = damping::dashpot(law.damping_ratio, k, mass) + stiffness_damping * k;
            for (block, place) in [(bond.i, point.on_i), (bond.j, point.on_j)] {
                sums[block as usize].add(shapes, block as usize, place.length_squared(), k, dash);
            }
        }
    }
}

/// Sums over the contacts of one block, per mass.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    stiffness: f64,
    damping: f64,
}

impl Sums {
    /// Adds a contact at the root of `reach` (m²) from the centroid.
    fn add(&mut self, shapes: &Shapes, block: usize, reach: f64, k: f64, dash: f64) {
        let ease = 2.0 * (1.0 / shapes.mass[block] + reach / shapes.inertia[block]);
        self.stiffness += ease * k;
        self.damping += ease * dash;
    }

    fn stable(&self) -> f64 {
        if self.stiffness > 0.0 {
            let c = self.damping;
            ((c * c + 4.0 * self.stiffness).sqrt() - c) / self.stiffness
        } else {
            f64::INFINITY
        }
    }
}

/// Larger stiffness of a law. The source's potentials press on both sides: 1.5 times as stiff on flat
/// contact.
fn stiffness(law: &ContactLaw) -> f64 {
    let normal = match law.normal {
        NormalLaw::DistancePotential => law.normal_stiffness,
        NormalLaw::PenetrationPotential => 1.5 * law.normal_stiffness,
    };
    normal.max(law.shear_stiffness)
}

/// Lever arm of a candidate contact: to the middle of the boxes' common part, at most the radius.
fn arm(world: &World, shapes: &Shapes, c: &Candidate, block: usize) -> f64 {
    let (a, b) = (c.i as usize, c.j as usize);
    let low = |k: usize| world.search_pose[k].0 - Vec2::splat(shapes.radius[k]);
    let high = |k: usize| world.search_pose[k].0 + Vec2::splat(shapes.radius[k]);
    let middle = 0.5 * (low(a).max(low(b)) + high(a).min(high(b)));
    (middle - world.search_pose[block].0).length().min(shapes.radius[block])
}
