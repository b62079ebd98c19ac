//! Stable time step: which block sets it, and why.
//!
//! With the velocity of half a step before in the dashpots the leapfrog is stable while
//! `x . (dt² K + 2 dt C) x <= 4 x . M x` for every motion x. `fastest` finds the motion that comes nearest, with the springs and
//! dashpots of all patches and boundaries and their masses. One damping ratio for the whole model would let the dashpots of its
//! coarsest blocks shorten the step of its finest.

pub mod deformable;

mod fastest;
mod springs;
#[cfg(test)]
mod tests;

use riprap_geom::Vec3;

use crate::push::bolts;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use fastest::Fastest;
use springs::{Springs, Weights};

/// Sweeps for a motion. In a lattice of a hundred thousand blocks, whose highest frequencies lie close together, its squared
/// frequency is then known to 1 %, elsewhere to far less.
const SWEEPS: usize = 18;
/// The estimate of the highest squared frequency comes from below; what is added to it.
const MARGIN: f64 = 1.0075;
/// Sweeps of a round that looks for the motion with springs and dashpots of a step.
const ROUND: usize = 8;
/// Most rounds.
const ROUNDS: usize = 12;
/// Share of a step that its own motion must allow.
const SETTLED: f64 = 0.997;
/// Share of the dashpots at full ratio that a motion must have for all to count with that ratio.
const FULL: f64 = 0.98;

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
    let (square, block) = deformable::highest(world, deform, work, &scratch.exec);
    if square == 0.0 {
        return rigid;
    }
    let (bolts, on) = bolts::stiffness::on_masses(world, &work.masses);
    let (block, why) = match on {
        Some(node) if bolts > square => {
            let body = deform.bodies.partition_point(|b| b.first <= node) - 1;
            (Some(deform.bodies[body].block), "nodes on the springs of bolts")
        }
        _ => (block, "nodes on the springs of bonds and tetrahedra"),
    };
    let square = square + deformable::on_bonds(world, deform) + bolts;
    // The largest eigenvalue of a sum is at most the sum of the largest ones.
    let own = 2.0 / rigid.dt;
    let dt = 2.0 / (square + own * own).sqrt();
    if 2.0 / square.sqrt() > rigid.dt {
        return Stable { dt, ..rigid };
    }
    Stable { dt, block, why }
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
        None => Stable { dt, block, why: "floating" },
    }
}

/// The same for the rigid blocks and their patches.
fn rigid_step(world: &World, scratch: &Scratch, stiffness_damping: f64) -> Stable {
    let springs = Springs::new(world);
    let mut motion = Fastest::new(world, &springs, &scratch.exec, scratch.width);
    let ck = stiffness_damping;
    let [least, most] = springs.ratios(world, ck);
    let one_ratio = least >= FULL * most;
    motion.start(Weights::SPRINGS);
    sweep(&mut motion, if one_ratio { SWEEPS } else { ROUND });
    let k = motion.value();
    let mut dt = longest(k, 0.0);
    if most > 0.0 {
        let c = motion.quotient(Weights::dashpots(ck));
        dt = if one_ratio && c >= FULL * most * k {
            // Dashpots are at most `most` times the springs, and those of this motion are.
            longest(k, most * k)
        } else {
            with_dashpots(&mut motion, longest(k, c), ck)
        };
    }
    if dt.is_infinite() {
        return Stable { dt, block: None, why: "no springs act on the blocks" };
    }
    name(world, &springs, &motion, dt)
}

fn sweep(motion: &mut Fastest, most: usize) {
    for _ in 0..most {
        if !motion.improve() {
            break;
        }
    }
}

/// The step with dashpots, from one that the motion allows. It comes from above: a motion that is fast with the springs and dashpots of a step
/// allows no more than that step, and at the end hardly less.
fn with_dashpots(motion: &mut Fastest, from: f64, ck: f64) -> f64 {
    let mut dt = from;
    for _ in 0..ROUNDS {
        if dt.is_infinite() {
            break;
        }
        motion.start(Weights::step(dt, ck));
        sweep(motion, ROUND);
        let both = motion.value();
        let k = motion.quotient(Weights::SPRINGS);
        let c = ((both - dt * dt * k) / (2.0 * dt)).max(0.0);
        let before = std::mem::replace(&mut dt, longest(k, c));
        if dt >= SETTLED * before {
            break;
        }
    }
    dt
}

/// The longest step for `x . K x` and `x . C x` of a motion of length one.
fn longest(springs: f64, dashpots: f64) -> f64 {
    // k dt² + 2 c dt = 4, in the form without cancellation.
    let (k, c) = (MARGIN * springs, MARGIN * dashpots);
    4.0 / (c + (c * c + 4.0 * k).sqrt())
}

/// Says which block moves most in the fastest motion.
fn name(world: &World, springs: &Springs, motion: &Fastest, dt: f64) -> Stable {
    let size = |b: usize| {
        let [u, w] = motion.of(b);
        u.length_squared() + w.length_squared()
    };
    let mut block = 0;
    for b in 0..world.alive.len() {
        if world.alive[b] && size(b) > size(block) {
            block = b;
        }
    }
    let [moving, turning] = motion.of(block).map(Vec3::length_squared);
    let why = if springs.faces.iter().any(|f| f.block as usize == block) {
        "springs of patches and of a boundary"
    } else if turning > moving {
        "rotation on the springs of its patches"
    } else {
        "translation on the springs of its patches"
    };
    Stable { dt, block: Some(block as u32), why }
}
