//! Stable time step: which block sets it, and why.
//!
//! Gershgorin bound per block: `w² <= 2 max(sum k / m, sum k (r² + L²/12) / I)` over all candidate
//! contacts at their largest possible length and all active joints, `k = kn L (1 + ks/kn)`; then
//! `dt = 2/w (sqrt(1 + xi²) - xi)` for damping ratio xi.

use riprap_geom::Vec2;

use super::search::{Candidate, Candidates, is_held};
use super::setup::Interface;
use super::shapes::Shapes;
use super::world::World;

/// The largest stable step and the block that sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stable {
    /// Stable time step (safety 1), s; infinite when nothing can touch.
    pub dt: f64,
    /// Index of the block with the highest frequency.
    pub block: Option<u32>,
}

/// Finds the stable step for the present candidate list and laws.
#[must_use]
pub fn stable_step(world: &World, shapes: &Shapes, candidates: &Candidates) -> Stable {
    let n = shapes.len();
    let mut translation = vec![0.0_f64; n];
    let mut rotation = vec![0.0_f64; n];
    let mut damping = 0.0_f64;
    let mut add = |block: usize, k: f64, arm: f64, length: f64| {
        translation[block] += k;
        rotation[block] += k * (arm * arm + length * length / 12.0);
    };
    let sum = |i: &Interface| {
        (
            i.contact.normal_stiffness + i.contact.shear_stiffness,
            i.contact,
        )
    };
    for c in candidates.convex.iter().chain(&candidates.general) {
        let (stiffness, law) = sum(&world.setup.interfaces[c.row as usize]);
        let k = stiffness * c.longest * source_factor(&law);
        damping = damping.max(law.damping_ratio);
        for block in [c.i as usize, c.j as usize] {
            let arm = arm(world, shapes, c, block);
            add(block, k, arm, c.longest);
        }
    }
    for bond in world.bonds.iter().filter(|b| b.active) {
        let Some(law) = &world.setup.interfaces[bond.row as usize].bond else {
            continue;
        };
        damping = damping.max(law.damping_ratio);
        for point in &bond.points {
            let k = (law.normal_stiffness + law.shear_stiffness) * point.weight;
            add(bond.i as usize, k, point.on_i.length(), 0.0);
            add(bond.j as usize, k, point.on_j.length(), 0.0);
        }
    }
    // A block may come into contact along its longest edge between two looks at the list.
    let stiffest = world
        .setup
        .interfaces
        .iter()
        .map(|i| sum(i).0 * source_factor(&i.contact));
    let stiffest = stiffest.fold(0.0, f64::max);
    for (b, k) in translation.iter_mut().enumerate() {
        let longest = shapes.of(b).iter().map(|e| e.length).fold(0.0, f64::max);
        *k = k.max(stiffest * longest);
    }
    let mut worst = Stable {
        dt: f64::INFINITY,
        block: None,
    };
    let factor = (1.0 + damping * damping).sqrt() - damping;
    for b in 0..n {
        if !world.alive[b] || is_held(world.motion[b].as_deref()) {
            continue;
        }
        let squared = 2.0 * (translation[b] / shapes.mass[b]).max(rotation[b] / shapes.inertia[b]);
        if squared > 0.0 {
            let dt = 2.0 / squared.sqrt() * factor;
            if dt < worst.dt {
                worst = Stable {
                    dt,
                    block: Some(b as u32),
                };
            }
        }
    }
    worst
}

/// The source's potentials press on both sides: 1.5 times as stiff on flat contact.
fn source_factor(law: &super::setup::ContactLaw) -> f64 {
    match law.normal {
        super::setup::NormalLaw::DistancePotential => 1.0,
        super::setup::NormalLaw::PenetrationPotential { .. } => 1.5,
    }
}

/// Lever arm of a candidate contact: to the middle of the boxes' common part, at most the radius.
fn arm(world: &World, shapes: &Shapes, c: &Candidate, block: usize) -> f64 {
    let (a, b) = (c.i as usize, c.j as usize);
    let low = |k: usize| world.search_pose[k].0 - Vec2::splat(shapes.radius[k]);
    let high = |k: usize| world.search_pose[k].0 + Vec2::splat(shapes.radius[k]);
    let middle = 0.5 * (low(a).max(low(b)) + high(a).min(high(b)));
    (middle - world.search_pose[block].0)
        .length()
        .min(shapes.radius[block])
}
