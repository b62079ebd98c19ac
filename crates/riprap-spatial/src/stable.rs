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
    let rigid = in_water(world, rigid_step(world, scratch, stiffness_damping));
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

/// Shortens the step of the rigid blocks by the stiffness of the water: what floats has it over the area that the table cuts, at
/// most that of a circle about the block. (Elements of deformable blocks are stiffer by far than water over their faces.)
fn in_water(world: &World, rigid: Stable) -> Stable {
    let Some(table) = world.table() else {
        return rigid;
    };
    let stiffness = table.stiffness(world.setup.gravity.length());
    let (mut square, mut block) = (0.0, None);
    for b in (0..world.alive.len()).filter(|&b| world.alive[b] && world.is_free(b)) {
        if world.deforms(b) || world.is_terrain(b) {
            continue;
        }
        let solid = world.solid_of(b);
        let area = std::f64::consts::PI * solid.radius * solid.radius;
        // The turning compliance of any axis is at most the sum of those about the three.
        let inverse = &solid.inverse;
        let ease = inverse.col(0).x + inverse.col(1).y + inverse.col(2).z;
        let own = stiffness * area * (1.0 / solid.mass + 0.25 * solid.radius * solid.radius * ease);
        if own > square {
            (square, block) = (own, Some(b as u32));
        }
    }
    // The largest eigenvalue of a sum is at most the sum of the largest ones; 2/dt is 0 where nothing holds the blocks.
    let own = 2.0 / rigid.dt;
    let dt = 2.0 / (square + own * own).sqrt();
    match rigid.block {
        Some(_) => Stable { dt, ..rigid },
        None => Stable {
            dt,
            block,
            why: "floating",
        },
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
