//! What a charge along a line has of its hole: a detonation that runs along it, and stemming that the gas may blow out.
//!
//! **Detonation.** It runs both ways from the primer at its velocity D (the lighting times of programmed burn: Wilkins 1964, Methods in Computational Physics 3,
//! 211-263). A wall is pushed once the front has passed its centre, and carries what the charge carried until then. What has burned is one gas: its share of the
//! charge grows with the burned length, and each part brings its own volume and energy along.
//! Deviation: behind the front the pressure is even, as in a charge that turns to gas at once; new gas that mixes with gas which has expanded loses
//! a little energy, since the adiabat holds no more.
//!
//! **Stemming.** A stiff column of length L, section A and mass m in the hole above the charge, by velocity Verlet:
//!
//! ```text
//!     m x'' = (P - P_air) A - tau pi d (L - x) + m g.axis        x' >= 0
//! ```
//!
//! Its way makes room, `A x`. At x = L it is out, and the gas leaves through the section A as through a nozzle: at the velocity of sound in its throat,
//! `h(rho) - h(rho*) = c*²/2`, or with the pressure of the air there once that is above the throat's.
//! Deviation: rock carries neither the friction of the column nor less pressure where its foot is: the section of a hole is small against its walls.

use std::f64::consts::PI;

use crate::flow::Fluid;
use crate::push::charge::{EARLY, walls};
use crate::setup::{Place, Source, Stemming};
use crate::state::cavity::{Burn, Cavity, Column, Gas};
use crate::state::world::World;

impl Source {
    /// The detonation before it begins; none in a charge that turns to gas at once.
    pub(crate) fn burn(&self) -> Option<Burn> {
        let detonation = self.hole.detonation?;
        let Place::Line { from, to } = &self.place else { return None };
        let rest = (from.distance(*to) - detonation.primer).max(0.0);
        let ends = [detonation.primer, rest].map(|way| way / detonation.velocity);
        Some(Burn { ends, reached: -1.0, given: 0.0 })
    }
}

impl Stemming {
    /// Section of the hole, m².
    #[must_use]
    pub fn section(&self) -> f64 {
        0.25 * PI * self.diameter * self.diameter
    }

    /// Mass of the column, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.density * self.section() * self.length
    }

    /// Friction that it can meet after a way (m), N.
    fn friction_after(&self, way: f64) -> f64 {
        self.friction * PI * self.diameter * (self.length - way).max(0.0)
    }

    /// Acceleration (m/s²) by a pressure (Pa) of the gas; `weight` is what of gravity acts outwards, m/s².
    fn acceleration(&self, column: &Column, pressure: f64, weight: f64) -> f64 {
        let drive = (pressure - self.air) * self.section() / self.mass() + weight;
        let left = drive - self.friction_after(column.way) / self.mass();
        // At rest friction carries what it can.
        if column.speed > 0.0 { left } else { left.max(0.0) }
    }
}

/// Volume of a cavity besides what its walls have swept, m³: what has burned, and the way of the stemming.
pub(crate) fn room(source: &Source, cavity: &Cavity, gas: &Gas) -> f64 {
    let burned = cavity.burn.map_or(gas.start, |burn| gas.start * burn.share());
    match (cavity.column, source.hole.stemming) {
        (Some(column), Some(stemming)) => burned + stemming.section() * column.way,
        (Some(_) | None, _) => burned,
    }
}

/// Takes the detonation of cavity `k` along to the present time: walls that it has reached are the gas's from here on.
///
/// Calling it again without moving changes nothing.
pub(crate) fn run_on(world: &mut World, k: usize) {
    let cavity = &world.cavities[k];
    let (Some(burn), Some(ignited)) = (cavity.burn, cavity.ignited) else { return };
    // What those that it had not reached have done since.
    let work = walls::held(world, cavity);
    let before = walls::swept(world, cavity);
    world.works.gas += work - cavity.held;
    let reached = (world.time - ignited + EARLY * world.last_dt).max(burn.reached);
    world.cavities[k].burn = Some(Burn { reached, ..burn });
    // A wall begins where it is now.
    let after = walls::swept(world, &world.cavities[k]);
    let held = walls::held(world, &world.cavities[k]);
    let cavity = &mut world.cavities[k];
    cavity.base += after - before;
    cavity.held = held;
}

/// Share of the coming kick in which the gas pushes a wall that the detonation reached `after` (s) the ignition; `dt` is the coming step (s).
pub(crate) fn share_of_kick(world: &World, cavity: &Cavity, after: f64, dt: f64) -> f64 {
    let Some(ignited) = cavity.ignited.filter(|_| cavity.burn.is_some()) else { return 1.0 };
    let since = (world.time - ignited - after).max(0.0);
    let first = dt > 0.0 && since < (1.0 - EARLY) * world.last_dt || world.last_dt == 0.0;
    if first && dt > 0.0 { (since + 0.5 * dt) / (0.5 * (world.last_dt + dt)) } else { 1.0 }
}

/// First half of a step of the stemming of cavity `k`: its way.
pub(crate) fn push_out(world: &mut World, k: usize) {
    let (time, dt) = (world.time, world.pending);
    let cavity = &mut world.cavities[k];
    let Some(stemming) = world.setup.sources[cavity.source as usize].hole.stemming else { return };
    let Some(column) = cavity.column.as_mut().filter(|c| c.out.is_none() && dt > 0.0) else {
        return;
    };
    let step = column.speed * dt + 0.5 * column.acceleration * dt * dt;
    let way = (column.way + step.max(0.0)).min(stemming.length);
    let passed = way - column.way;
    let friction = stemming.friction_after(column.way + 0.5 * passed);
    column.friction += friction * passed;
    column.way = way;
    column.passed = passed;
    if way >= stemming.length {
        column.out = Some(time);
    }
}

/// Second half: its speed, from the pressures (Pa) before and after its way. The work of the step on it, J.
pub(crate) fn speed_up(world: &mut World, k: usize, [before, pressure]: [f64; 2]) -> f64 {
    // What has passed before the ignition is none of its time.
    let dt = if world.cavities[k].ignited == Some(world.time) { 0.0 } else { world.pending };
    let source = world.cavities[k].source as usize;
    let (Some(stemming), Place::Line { from, to }) =
        (world.setup.sources[source].hole.stemming, &world.setup.sources[source].place)
    else {
        return 0.0;
    };
    let weight = world.gravity.dot((*from - *to).normalize_or_zero());
    let Some(column) = &mut world.cavities[k].column else { return 0.0 };
    if column.out.is_some_and(|out| out != world.time) {
        return 0.0;
    }
    let now = stemming.acceleration(column, pressure, weight);
    let passed = std::mem::take(&mut column.passed);
    let work = 0.5 * (before + pressure) * stemming.section() * passed;
    column.work += work;
    column.speed = (column.speed + 0.5 * (column.acceleration + now) * dt).max(0.0);
    column.acceleration = stemming.acceleration(column, pressure, weight);
    work
}

impl Cavity {
    /// Gas that has burned and that has left through the open hole in `dt` (s), and the pressure of what is there; for gas that does not enter cracks.
    pub(crate) fn keep(&mut self, source: &Source, gas: &Gas, charge: f64, dt: f64) {
        if let Some(burn) = &mut self.burn {
            let share = burn.share();
            self.kept += share - std::mem::replace(&mut burn.given, share);
        }
        let fluid = Fluid { adiabat: gas.adiabat, mass: charge };
        let mass = self.kept * charge;
        let rate = outflow(source, self, &fluid, mass / self.volume);
        if rate > 0.0 && dt > 0.0 {
            let stays = libm::exp(-rate * dt / mass);
            self.kept *= stays;
            if let Some(column) = &mut self.column {
                column.vented += mass * (1.0 - stays);
            }
        }
        let volume = if self.kept > 0.0 { self.volume / self.kept } else { gas.start };
        self.pressure = gas.adiabat.pressure(volume);
    }
}

/// Rate at which gas leaves through the open hole of a cavity, kg/s.
pub(crate) fn outflow(source: &Source, cavity: &Cavity, fluid: &Fluid, density: f64) -> f64 {
    match (cavity.column, source.hole.stemming) {
        (Some(Column { out: Some(_), .. }), Some(stemming)) => {
            stemming.section() * fluid.nozzle(density, stemming.air)
        }
        (Some(_) | None, _) => 0.0,
    }
}
