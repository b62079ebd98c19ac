//! The loop: phases, time steps, stop criteria, guards.
//!
//! [`Simulation::prepare`] finds the forces at the present time (entering the next phase when one is
//! due), so that the state can be read and recorded; [`Simulation::step`] moves on. A checkpoint
//! can be taken at any moment: a simulation made from it goes on with the same bits.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::plan::{Damping, Phase, PhaseKind, Plan, TimeStep, Until};
use crate::Vec2;
use crate::exec::Exec;
use crate::planar::fields::View;
use crate::planar::setup::{Motion, Setup};
use crate::planar::stable::{Stable, stable_step};
use crate::planar::step::{self, Scratch, hold_driven};
use crate::planar::world::World;

/// Share of the unbalanced force that local damping takes in static phases, unless one is given.
pub const STATIC_DAMPING: f64 = 0.7;
/// A block may cross at most this share of its neighbourhood's inscribed radius in one step.
const TRANSIT: f64 = 0.2;
/// Overlap over the smaller inscribed radius at which a run is stopped: beyond 1 blocks pass through.
const WORST_OVERLAP: f64 = 0.5;
/// Steps between two looks at guards and at costly stop criteria.
const LOOK: u64 = 50;

/// Why the physics stopped a run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RunError {
    /// A block's state is not a number any more.
    #[error(
        "block `{block}` has forces that are not finite at step {step} (t = {time:.6e} s); \
         the time step is probably too long for the stiffness"
    )]
    NonFinite {
        /// Name of the block.
        block: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Two blocks have gone too far into each other.
    #[error(
        "blocks `{first}` and `{second}` overlap by {percent:.0} % of the smaller one's inscribed \
         radius at step {step} (t = {time:.6e} s); use a stiffer contact or a smaller time step"
    )]
    Overlap {
        /// One block.
        first: String,
        /// The other.
        second: String,
        /// Depth over inscribed radius, per cent.
        percent: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Energy came from nowhere.
    #[error(
        "kinetic energy {kinetic:.3e} J/m at step {step} (t = {time:.6e} s) is {ratio:.1} times all \
         energy put in, fastest block `{block}`; the time step is probably too long"
    )]
    BlowUp {
        /// Fastest block.
        block: String,
        /// Kinetic energy, J/m.
        kinetic: f64,
        /// Over the energy put in.
        ratio: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
}

/// Where in the plan a run is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Cursor {
    /// Index of the phase.
    pub phase: usize,
    /// Whether the phase has been entered.
    pub entered: bool,
    /// Model time at the start of the phase, s.
    pub start_time: f64,
    /// Step count at the start of the phase.
    pub start_step: u64,
    /// Gravity before the phase, m/s².
    pub gravity_before: [f64; 2],
    /// Gravity the phase ends with, m/s².
    pub gravity_after: [f64; 2],
    /// Steps shortened by the tunnelling guard.
    pub shortened: u64,
}

/// Everything a run needs to go on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Snapshot {
    /// Plan of the run.
    pub plan: Plan,
    /// Place in the plan.
    pub cursor: Cursor,
    /// State of the model.
    pub world: World,
}

/// What has just come to an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Within a phase: [`Simulation::step`] may be called.
    Within,
    /// A phase has reached its end: [`Simulation::next_phase`] goes on.
    PhaseEnd,
    /// All phases are done.
    Done,
}

/// A model being advanced through its plan.
#[derive(Debug)]
pub struct Simulation {
    plan: Plan,
    cursor: Cursor,
    world: World,
    scratch: Scratch,
    stable: Option<(u64, Stable)>,
    dt: f64,
}

impl Simulation {
    /// A run from the start.
    #[must_use]
    pub fn new(setup: Setup, plan: Plan, exec: Exec) -> Self {
        let (mut world, scratch) = World::new(setup, exec);
        let cursor = Cursor {
            gravity_after: world.gravity.into(),
            ..Cursor::default()
        };
        if plan
            .phases
            .first()
            .is_some_and(|p| p.gravity_ramp.is_some())
        {
            world.gravity = Vec2::ZERO;
        }
        Self {
            plan,
            cursor,
            world,
            scratch,
            stable: None,
            dt: 0.0,
        }
    }

    /// A run that goes on from a snapshot.
    #[must_use]
    pub fn resume(snapshot: Snapshot, exec: Exec) -> Self {
        let Snapshot {
            plan,
            cursor,
            mut world,
        } = snapshot;
        let scratch = Scratch::new(&mut world, exec);
        Self {
            plan,
            cursor,
            world,
            scratch,
            stable: None,
            dt: 0.0,
        }
    }

    /// What a checkpoint holds.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            plan: self.plan.clone(),
            cursor: self.cursor.clone(),
            world: self.world.clone(),
        }
    }

    /// The plan.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The present phase, if any is left.
    #[must_use]
    pub fn phase(&self) -> Option<&Phase> {
        self.plan.phases.get(self.cursor.phase)
    }

    /// Place in the plan.
    #[must_use]
    pub fn cursor(&self) -> &Cursor {
        &self.cursor
    }

    /// The state, to be read after [`Simulation::prepare`].
    #[must_use]
    pub fn view(&self) -> View<'_> {
        View {
            world: &self.world,
            scratch: &self.scratch,
        }
    }

    /// The coming time step, s; known after [`Simulation::prepare`].
    #[must_use]
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// The stable time step of the present candidate list, with the damping of the phase.
    pub fn stable(&mut self) -> Stable {
        let stiffness_damping = self.phase().map_or(0.0, |p| p.damping.stiffness);
        match self.stable {
            Some((rebuilds, stable)) if rebuilds == self.scratch.rebuilds => stable,
            _ => {
                let found = stable_step(
                    &self.world,
                    &self.scratch.shapes,
                    &self.scratch.candidates,
                    stiffness_damping,
                );
                self.stable = Some((self.scratch.rebuilds, found));
                found
            }
        }
    }

    /// Finds the forces at the present time, entering the phase when it is new.
    ///
    /// # Errors
    /// The physics stopped the run; the state is still the last one.
    pub fn prepare(&mut self) -> Result<Stage, RunError> {
        if !self.cursor.entered {
            self.enter_phase()?;
        }
        let Some(phase) = self.phase().map(Rules::of) else {
            self.evaluate(&Damping::default(), 0.0)?;
            return Ok(Stage::Done);
        };
        self.ramp_gravity(phase.gravity_ramp);
        let damping = phase.damping;
        self.dt = self.next_step(&phase);
        let rebuilds = self.scratch.rebuilds;
        self.evaluate(&damping, self.dt)?;
        if self.scratch.rebuilds != rebuilds {
            // New neighbours can shorten the step.
            let dt = self.next_step(&phase);
            if dt != self.dt {
                self.dt = dt;
                self.evaluate(&damping, dt)?;
            }
        }
        self.guard()?;
        Ok(if self.phase_over(&phase) {
            Stage::PhaseEnd
        } else {
            Stage::Within
        })
    }

    /// Moves on by one step; call [`Simulation::prepare`] before.
    pub fn step(&mut self) {
        if self.world.last_dt == 0.0 {
            self.book_start();
        }
        step::advance(&mut self.world, &mut self.scratch, self.dt);
    }

    /// Books the start of a motion, after the half kick that begins it is known.
    ///
    /// What the leapfrog keeps is `m v(n-1/2)·v(n+1/2)/2` and the stored energy. At the start the two
    /// half-step velocities are `v - dv` and `v + dv` about the given one: `m dv²/2` less than `m v²/2`.
    fn book_start(&mut self) {
        let shapes = &self.scratch.shapes;
        let half_kick: f64 = self
            .view()
            .living()
            .map(|b| {
                let change = &self.scratch.changes[b];
                shapes.mass[b] * change.velocity.length_squared()
                    + shapes.inertia[b] * change.spin * change.spin
            })
            .sum();
        if self.world.start_energy.is_none() {
            self.world.start_energy = Some(self.view().balance().total() - 0.5 * half_kick);
        } else {
            self.world.works.edit_defect -= 0.5 * half_kick;
        }
    }

    /// Goes to the next phase; the present state stays as it is until the next `prepare`.
    pub fn next_phase(&mut self) {
        self.cursor.phase += 1;
        self.stable = None;
        self.cursor.entered = false;
    }

    /// Share of the present phase that is done, if its end is known.
    #[must_use]
    pub fn progress(&self) -> Option<f64> {
        let until = self.phase()?.until;
        let steps = until
            .steps
            .map(|n| (self.world.step - self.cursor.start_step) as f64 / n.max(1) as f64);
        let time = until
            .time
            .map(|t| (self.world.time - self.cursor.start_time) / t);
        match (steps, time) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        }
    }

    fn evaluate(&mut self, damping: &Damping, dt: f64) -> Result<(), RunError> {
        step::evaluate(&mut self.world, &mut self.scratch, damping, dt).map_err(|e| {
            RunError::NonFinite {
                block: self.name(e.block),
                step: self.world.step,
                time: self.world.time,
            }
        })?;
        Ok(())
    }

    fn name(&self, block: u32) -> String {
        self.world.setup.blocks[block as usize].name.clone()
    }

    /// Applies what the phase changes; the energy this adds is booked as an edit.
    fn enter_phase(&mut self) -> Result<(), RunError> {
        self.cursor.entered = true;
        self.cursor.start_time = self.world.time;
        self.cursor.start_step = self.world.step;
        self.cursor.gravity_before = self.world.gravity.into();
        let Some(phase) = self.phase().cloned() else {
            return Ok(());
        };
        if let Some(gravity) = phase.gravity {
            self.cursor.gravity_after = gravity;
        }
        if phase.gravity_ramp.is_none() {
            self.world.gravity = Vec2::from(self.cursor.gravity_after);
        }
        let edits = !phase.remove.is_empty()
            || !phase.fix.is_empty()
            || !phase.release.is_empty()
            || !phase.contacts.is_empty()
            || phase.zero_velocities;
        if phase.zero_displacements {
            for (b, body) in self.world.bodies.iter().enumerate() {
                self.world.reference[b] = body.position;
                self.world.reference_angle[b] = body.angle;
            }
        }
        if !edits {
            return Ok(());
        }
        let damping = damping_of(&phase);
        self.evaluate(&damping, 0.0)?;
        let before = self.view().balance().residual();
        self.edit(&phase);
        self.scratch.invalidate(&mut self.world);
        self.evaluate(&damping, 0.0)?;
        let after = self.view().balance().residual();
        self.world.works.edit_defect += after - before;
        Ok(())
    }

    fn edit(&mut self, phase: &Phase) {
        let world = &mut self.world;
        for &b in &phase.remove {
            world.alive[b as usize] = false;
        }
        let alive = std::mem::take(&mut world.alive);
        world
            .bonds
            .retain(|k| alive[k.i as usize] && alive[k.j as usize]);
        world.alive = alive;
        for &b in &phase.fix {
            world.motion[b as usize] = Some(Box::new(Motion::Fixed {
                x: true,
                y: true,
                rotation: true,
            }));
        }
        for &b in &phase.release {
            world.motion[b as usize] = None;
        }
        for (row, law) in &phase.contacts {
            world.setup.interfaces[*row as usize].contact = *law;
        }
        if phase.zero_velocities {
            for body in &mut world.bodies {
                body.velocity = Vec2::ZERO;
                body.spin = 0.0;
            }
            world.last_dt = 0.0;
        }
        hold_driven(world);
    }

    fn ramp_gravity(&mut self, ramp: Option<f64>) {
        let Some(span) = ramp else {
            return;
        };
        let share = if span > 0.0 {
            ((self.world.time - self.cursor.start_time) / span).clamp(0.0, 1.0)
        } else {
            1.0
        };
        let (from, to) = (
            Vec2::from(self.cursor.gravity_before),
            Vec2::from(self.cursor.gravity_after),
        );
        self.world.gravity = from + share * (to - from);
    }

    /// Length of the coming step: the rule of the phase, shortened for fast blocks and for the end.
    fn next_step(&mut self, phase: &Rules) -> f64 {
        let wanted = match phase.time_step {
            TimeStep::Given { dt } => dt,
            TimeStep::Auto { safety } => safety * self.stable().dt,
        };
        let transit = TRANSIT * self.scratch.transit;
        let mut dt = wanted;
        if transit < dt {
            dt = transit;
            self.cursor.shortened += 1;
        }
        if let Some(span) = phase.until.time {
            let left = self.cursor.start_time + span - self.world.time;
            // A little longer rather than a tiny last step.
            if left <= 1.001 * dt && left > 0.0 {
                dt = left;
            }
        }
        dt
    }

    fn phase_over(&self, phase: &Rules) -> bool {
        let (until, world) = (&phase.until, &self.world);
        let steps = world.step - self.cursor.start_step;
        if until.steps.is_some_and(|n| steps >= n) {
            return true;
        }
        let elapsed = world.time - self.cursor.start_time;
        if until.time.is_some_and(|t| elapsed >= t - 1e-9 * self.dt) {
            return true;
        }
        let settled = steps > 0 && steps.is_multiple_of(LOOK);
        let ramped = phase.gravity_ramp.is_none_or(|ramp| elapsed >= ramp);
        settled
            && ramped
            && (until
                .unbalanced
                .is_some_and(|x| self.view().unbalanced() <= x)
                || until.kinetic.is_some_and(|x| self.kinetic() <= x))
    }

    fn kinetic(&self) -> f64 {
        let view = self.view();
        view.living().map(|b| view.kinetic(b)).sum()
    }

    /// Stops runs that have left the range in which they mean anything.
    fn guard(&self) -> Result<(), RunError> {
        if !self.world.step.is_multiple_of(LOOK) || self.world.step == 0 {
            return Ok(());
        }
        let (step, time) = (self.world.step, self.world.time);
        if let Some((ratio, i, j)) = self.view().worst_overlap()
            && ratio > WORST_OVERLAP
        {
            return Err(RunError::Overlap {
                first: self.name(i),
                second: self.name(j),
                percent: 100.0 * ratio,
                step,
                time,
            });
        }
        let kinetic = self.kinetic();
        let works = &self.world.works;
        let start = self.world.start_energy.unwrap_or(0.0).abs();
        let put_in = start
            + works.gravity.max(0.0)
            + works.loads.abs()
            + works.supports.abs()
            + works.edit_defect.abs();
        if kinetic > 5.0 * put_in + 1e-12 {
            let view = self.view();
            let fastest = view.living().max_by(|&a, &b| {
                view.velocity(a)
                    .length()
                    .total_cmp(&view.velocity(b).length())
            });
            return Err(RunError::BlowUp {
                block: fastest.map_or_else(String::new, |b| self.name(b as u32)),
                kinetic,
                ratio: kinetic / put_in.max(f64::MIN_POSITIVE),
                step,
                time,
            });
        }
        Ok(())
    }
}

/// What the loop needs of a phase at each step.
#[derive(Clone, Copy, Debug)]
struct Rules {
    until: Until,
    time_step: TimeStep,
    damping: Damping,
    gravity_ramp: Option<f64>,
}

impl Rules {
    fn of(phase: &Phase) -> Self {
        Self {
            until: phase.until,
            time_step: phase.time_step,
            damping: damping_of(phase),
            gravity_ramp: phase.gravity_ramp,
        }
    }
}

/// Damping of a phase; static phases have local damping unless another is given.
#[must_use]
pub fn damping_of(phase: &Phase) -> Damping {
    let mut damping = phase.damping;
    if phase.kind == PhaseKind::Static && damping.local == 0.0 && damping.mass == 0.0 {
        damping.local = STATIC_DAMPING;
    }
    damping
}

/// blake3 of the state: equal hashes mean equal bits of motion and contact memory.
#[must_use]
pub fn state_hash(world: &World) -> String {
    let mut hasher = blake3::Hasher::new();
    let mut put = |x: f64| {
        hasher.update(&x.to_bits().to_le_bytes());
    };
    put(world.time);
    put(world.step as f64);
    for (b, body) in world.bodies.iter().enumerate() {
        let alive = f64::from(u8::from(world.alive[b]));
        let Vec2 { x, y } = body.position;
        for v in [
            alive,
            x,
            y,
            body.velocity.x,
            body.velocity.y,
            body.angle,
            body.spin,
        ] {
            put(v);
        }
    }
    let pairs = world.pairs.iter().map(|p| (p.i, p.j, &p.contact));
    let general = world
        .general
        .iter()
        .flat_map(|g| g.regions.iter().map(move |r| (g.i, g.j, &r.contact)));
    for (i, j, c) in pairs.chain(general).filter(|(_, _, c)| c.touches()) {
        for v in [f64::from(i), f64::from(j), c.shear, c.offset] {
            put(v);
        }
    }
    for bond in &world.bonds {
        for p in &bond.points {
            put(p.slip);
            put(f64::from(u8::from(p.failed)));
        }
    }
    hasher.finalize().to_hex().to_string()
}
