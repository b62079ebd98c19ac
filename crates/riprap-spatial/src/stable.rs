//! Stable time step: which block sets it, and why.
//!
//! With the velocity of half a step before in the dashpots the leapfrog is stable while
//! `x . (dt² K + 2 dt C) x <= 4 x . M x` for every motion x. Power iteration finds the motion that comes nearest, with the
//! springs and dashpots of all patches and boundaries and their masses. One damping ratio for the whole model would
//! let the dashpots of its coarsest blocks shorten the step of its finest.

mod sweep;

use riprap_geom::Vec3;

use super::deform;
use super::state::scratch::Scratch;
use super::world::World;
use sweep::{Motion, Springs, Weights};

/// Sweeps of the power iteration for the springs alone.
const SWEEPS: usize = 60;
/// Rounds that bring in the dashpots, and sweeps in each.
const ROUNDS: (usize, usize) = (6, 12);
/// The estimate of the highest squared frequency comes from below; what is added to it.
const MARGIN: f64 = 1.005;

/// The largest stable step and the block that sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stable {
    /// Stable time step (safety 1), s; infinite when nothing holds the blocks.
    pub dt: f64,
    /// Index of the block that moves most in the fastest mode.
    pub block: Option<u32>,
    /// What makes the mode fast.
    pub why: &'static str,
}

/// Finds the stable step of the patches and boundaries as they were built; `stiffness_damping` is that of the
/// phase, s.
#[must_use]
pub fn stable_step(world: &World, scratch: &Scratch, stiffness_damping: f64) -> Stable {
    let rigid = rigid_step(world, scratch, stiffness_damping);
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref()) else {
        return rigid;
    };
    let (square, block) = deform::stable::highest(world, deform, work, &scratch.exec);
    if square == 0.0 {
        return rigid;
    }
    let square = square + deform::stable::on_bonds(world, deform);
    // The largest eigenvalue of a sum is at most the sum of the largest ones.
    let own = 2.0 / rigid.dt;
    let dt = 2.0 / (square + own * own).sqrt();
    if 2.0 / square.sqrt() > rigid.dt {
        return Stable { dt, ..rigid };
    }
    Stable {
        dt,
        block,
        why: "nodes against their bonds and tetrahedra",
    }
}

/// The same for the rigid blocks and their patches.
fn rigid_step(world: &World, scratch: &Scratch, stiffness_damping: f64) -> Stable {
    let springs = Springs::new(world);
    let mut motion = Motion::new(world, &springs, &scratch.exec, scratch.width);
    let ck = stiffness_damping;
    for _ in 0..SWEEPS {
        if !motion.iterate(Weights::SPRINGS) {
            return Stable {
                dt: f64::INFINITY,
                block: None,
                why: "nothing holds the blocks",
            };
        }
    }
    let mut dt = 2.0 / (MARGIN * motion.quotient(Weights::SPRINGS)).sqrt();
    if springs.damped(world, ck) {
        for _ in 0..ROUNDS.0 {
            for _ in 0..ROUNDS.1 {
                motion.iterate(Weights::step(dt, ck));
            }
            let k = MARGIN * motion.quotient(Weights::SPRINGS);
            let c = MARGIN * motion.quotient(Weights::dashpots(ck));
            // k dt² + 2 c dt = 4, in the form without cancellation.
            dt = 4.0 / (c + (c * c + 4.0 * k).sqrt());
        }
    }
    name(world, &springs, motion.shape(), dt)
}

/// Says which block moves most in the fastest motion.
fn name(world: &World, springs: &Springs, x: &[[Vec3; 2]], dt: f64) -> Stable {
    let size = |v: &[Vec3; 2]| v[0].length_squared() + v[1].length_squared();
    let mut block = 0;
    for (b, v) in x.iter().enumerate() {
        if world.alive[b] && size(v) > size(&x[block]) {
            block = b;
        }
    }
    let (turning, moving) = (x[block][1].length_squared(), x[block][0].length_squared());
    let why = if springs.faces.iter().any(|f| f.block as usize == block) {
        "springs of patches and of a boundary"
    } else if turning > moving {
        "rotation against the springs of its patches"
    } else {
        "translation against the springs of its patches"
    };
    Stable {
        dt,
        block: Some(block as u32),
        why,
    }
}
