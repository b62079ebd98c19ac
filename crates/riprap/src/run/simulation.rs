//! The loop: phases and time steps.
//!
//! [`Simulation::prepare`] finds the forces at the present time (entering the next phase when one is
//! due), so that the state can be read and recorded; [`Simulation::step`] moves on. A checkpoint
//! can be taken at any moment: a simulation made from it goes on with the same bits.

mod add;
mod advance;
mod automatic;
mod cause;
mod change;
mod control;
mod cursor;
mod damping;
mod ends;
mod error;
mod law;
mod law_state;
mod leavers;
mod noted;
mod shorter;
mod spent;
mod steer;
mod step_error;
mod stop;
#[cfg(all(test, feature = "scenario"))]
mod tests;
mod unread;

pub use advance::Reached;
pub use change::{Change, ChangeError};
pub use cursor::{
    Cursor, PhaseEnd, Reason, Residual, Snapshot, SnapshotRef, Stage, Thrown, Unconverged,
};
pub use error::RunError;
pub use law::{ContactLaw, Contacts, LawCost};
pub use spent::Spent;
pub(crate) use spent::middle_size;

use self::control::Servos;
use self::shorter::Shorter;
use super::engine::{BuildError, Engine, Kind, Stable, View};
use crate::exec::Exec;
use crate::ledger::Balance;
use crate::plan::{
    Damping, IMPLICIT_STEP, Integration, Phase, PhaseKind, Plan, Relaxing, STATIC_STEP, TimeStep,
    Until,
};
use crate::setup::Setup;

/// A model being advanced through its plan.
#[derive(Debug)]
pub struct Simulation {
    plan: Plan,
    cursor: Cursor,
    engine: Engine,
    stable: Option<(u64, Stable)>,
    dt: f64,
    /// Whether the present state has been prepared by an advance that has come so far.
    standing: bool,
    /// Whether nobody is going to read the coming state.
    unread: bool,
    /// Relative residual of the ledger when it was last drawn up.
    residual: Option<f64>,
    /// Why the present phase is over, once it is.
    reason: Option<Reason>,
    /// The shortest step in place of a given one.
    shorter: Option<Shorter>,
    /// The servos of the plan, once they have begun.
    servos: Option<Servos>,
    /// Laws of code.
    laws: Vec<law::Attached>,
}

impl Simulation {
    /// A run from the start.
    ///
    /// # Errors
    /// A model that the engine cannot build.
    pub fn new(setup: impl Into<Setup>, plan: Plan, exec: Exec) -> Result<Self, BuildError> {
        let mut engine = Engine::new(setup.into(), exec)?;
        let cursor = Cursor { gravity_after: engine.gravity(), ..Cursor::default() };
        if plan.phases.first().is_some_and(|p| p.gravity_ramp.is_some()) {
            // No phase before it has had a gravity that the ramp could begin from.
            engine.set_gravity([0.0; 3]);
        }
        Ok(Self::at(plan, cursor, engine))
    }

    fn at(plan: Plan, cursor: Cursor, engine: Engine) -> Self {
        Self {
            // With the engine's present revision, so that it is not searched for again: joints that have failed
            // since then would make it longer than that of a run that was not stopped.
            stable: cursor.stable.map(|stable| (engine.revision(), stable)),
            plan,
            cursor,
            engine,
            dt: 0.0,
            standing: false,
            unread: false,
            residual: None,
            reason: None,
            shorter: None,
            servos: None,
            laws: Vec::new(),
        }
    }

    /// A run that goes on from a snapshot.
    #[must_use]
    pub fn resume(snapshot: Snapshot, exec: Exec) -> Self {
        let Snapshot { plan, cursor, state } = snapshot;
        Self::at(plan, cursor, Engine::resume(state, exec))
    }

    /// What a checkpoint holds. A run goes on from it with the same bits where it is taken between a step and the next
    /// [`Simulation::prepare`], or at the end of a phase.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            plan: self.plan.clone(),
            cursor: self.cursor.clone(),
            state: self.engine.state(),
        }
    }

    /// What a checkpoint holds, to be written.
    #[must_use]
    pub fn snapshot_ref(&self) -> SnapshotRef<'_> {
        SnapshotRef { plan: &self.plan, cursor: &self.cursor, state: self.engine.state_ref() }
    }

    /// The engine.
    #[must_use]
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Which engine it is.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.engine.kind()
    }

    /// Model time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.engine.view().time()
    }

    /// Steps done.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.engine.view().step()
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
        self.engine.view()
    }

    /// Whether the present state means something: not one on the way to an equilibrium.
    #[must_use]
    pub fn settled(&self) -> bool {
        let now = self.engine.relaxing();
        // A load step that is about to begin has cleared `converged`, but the state it leaves is the equilibrium.
        now.is_none_or(|now| now.converged || now.leaving)
    }

    /// Whether the present phase relaxes deformable blocks.
    #[must_use]
    pub fn relaxes(&self) -> bool {
        self.engine.relaxing().is_some()
    }

    /// The energy ledger at the present, prepared state, in the unit of energies of its kind. Costs as much as some steps.
    pub fn balance(&mut self) -> Balance {
        let balance = self.view().balance().times(self.view().slice());
        self.residual = Some(balance.residual_relative());
        balance
    }

    /// Energy residual over the largest energy exchanged when [`Simulation::balance`] was last asked for.
    #[must_use]
    pub fn residual(&self) -> Option<f64> {
        self.residual
    }

    /// The coming time step, s; known after [`Simulation::prepare`].
    #[must_use]
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// The stable time step of the present contacts, with the damping of the phase.
    pub fn stable(&mut self) -> Stable {
        let stiffness_damping = self.phase().map_or(0.0, |p| p.damping.stiffness);
        match self.stable {
            Some((revision, stable)) if revision == self.engine.revision() => stable,
            _ => {
                let found = self.engine.stable(stiffness_damping);
                self.stable = Some((self.engine.revision(), found));
                self.cursor.stable = Some(found);
                found
            }
        }
    }

    /// Finds the forces at the present time, entering the phase when it is new.
    ///
    /// # Errors
    /// The physics stopped the run; the state is still the last one.
    pub fn prepare(&mut self) -> Result<Stage, RunError> {
        if self.servos.is_none() {
            self.begin_controls()?;
        }
        if !self.cursor.entered {
            self.enter_phase()?;
        }
        let implicit = self.engine.is_implicit();
        let Some(phase) = self.phase().map(|phase| Rules::of(phase, implicit)) else {
            let (last, dt) = (self.plan.phases.last(), self.cursor.closing_dt);
            let damping = match last {
                Some(last) if self.settles(last) => self.forgetting(dt),
                Some(last) => last.damping,
                None => Damping::default(),
            };
            self.evaluate(&damping, dt)?;
            return Ok(Stage::Done);
        };
        // Before the forces are found: weight is that of the instant at which they are.
        self.ramp_gravity(phase.gravity_ramp);
        let damping = phase.damping;
        self.dt = match self.checked_step(&phase) {
            // What bounds the first step may be contacts alone, which nobody has looked for yet.
            Err(RunError::NoStep { dt, .. }) if dt == f64::INFINITY => {
                self.evaluate(&damping, 0.0)?;
                self.checked_step(&phase)?
            }
            found => found?,
        };
        let revision = self.engine.revision();
        self.evaluate_unread(&phase)?;
        self.divide()?;
        self.let_leave()?;
        let sudden = self.engine.contact_step_limit(phase.time_step) < SUDDEN * self.dt;
        if self.engine.revision() != revision || sudden {
            // New neighbours can shorten the step.
            let dt = self.checked_step(&phase)?;
            if dt != self.dt {
                self.dt = dt;
                self.evaluate_step(&phase)?;
            }
        }
        // The next load step waits until nothing breaks: bonds that this one
        // breaks must be gone before there is more load.
        if self.fracture()? == 0 && self.relax(&phase) {
            self.evaluate(&damping, self.dt)?;
        }
        // Asked before the guard, which judges the last state of a phase whatever its step.
        let reason = self.phase_over(&phase);
        self.guard(reason.is_some())?;
        if reason.is_some() {
            self.cursor.closing_dt = self.dt;
        }
        self.reason = reason;
        Ok(if reason.is_some() { Stage::PhaseEnd } else { Stage::Within })
    }

    /// Moves on by one step; call [`Simulation::prepare`] before.
    pub fn step(&mut self) {
        self.standing = false;
        self.book_step_change();
        let asked = self.asked_by_controls();
        self.engine.advance(self.dt);
        self.control(asked);
        self.cursor.crossed += self.engine.crossed(self.dt);
    }

    /// Books what the coming step, if it has another length than the last one, makes of the energy of motion at half steps
    /// ([`crate::ledger`]). The first one of a motion grows from nothing.
    fn book_step_change(&mut self) {
        if self.engine.start_energy().is_none() {
            let start = self.view().balance().at_start();
            *self.engine.start_energy() = Some(start);
        }
        let (last, coming) = (self.view().last_dt(), self.dt);
        if last != coming {
            // The kick `dv` over the mean of both steps is `a (last + coming)/2`.
            let share = 0.5 * (last - coming) / (last + coming);
            let energy = share * self.view().half_kick();
            self.engine.works().change_step(energy, last == 0.0);
        }
    }

    /// Takes what has happened since the last look; `again`: the step has been looked at before.
    pub fn take_events(&mut self, again: bool) -> Vec<serde_json::Value> {
        let left = self.cursor.departed.drain(..).map(|one| one.event());
        self.engine.take_events(again).into_iter().chain(left).collect()
    }

    /// Goes to the next phase; the present state stays as it is until the next `prepare`.
    pub fn next_phase(&mut self) {
        self.standing = false;
        self.cursor.phase += 1;
        self.reason = None;
        self.stable = None;
        self.cursor.stable = None;
        self.cursor.entered = false;
    }

    /// Share of the present phase that is done, if its end is known.
    #[must_use]
    pub fn progress(&self) -> Option<f64> {
        let until = self.phase()?.until;
        let steps =
            until.steps.map(|n| (self.steps() - self.cursor.start_step) as f64 / n.max(1) as f64);
        let time = until.time.map(|t| (self.time() - self.cursor.start_time) / t);
        match (steps, time) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        }
    }

    fn divide(&mut self) -> Result<(), RunError> {
        let divided = self.engine.divide(self.dt);
        divided.map_err(|reason| RunError::Edit { reason, step: self.steps(), time: self.time() })
    }

    /// Whether a phase, which is the present one or has just ended, seeks its equilibrium by implicit steps.
    fn settles(&self, phase: &Phase) -> bool {
        phase.kind == PhaseKind::Static && self.engine.is_implicit()
    }

    /// Applies what the phase changes; the energy this adds is booked as an edit.
    fn enter_phase(&mut self) -> Result<(), RunError> {
        self.cursor.entered = true;
        self.cursor.start_time = self.time();
        self.cursor.start_step = self.steps();
        self.cursor.gravity_before = self.engine.gravity();
        let Some(phase) = self.phase().cloned() else {
            return Ok(());
        };
        if let Some(gravity) = phase.gravity {
            self.cursor.gravity_after = gravity;
        }
        let before = self.cursor.phase.checked_sub(1);
        let before = before.and_then(|k| self.plan.phases.get(k)).cloned();
        self.end_motion(before, &phase)?;
        self.choose_integration(&phase)?;
        self.engine.step_by_levels(phase.levels);
        if self.settles(&phase) {
            self.cursor.spent = Spent::of(&self.view().balance().works);
        }
        self.apply(phase)
    }

    /// Changes what the beginning of a phase changes; the energy this adds is booked as an edit.
    fn apply(&mut self, mut phase: Phase) -> Result<(), RunError> {
        if phase.gravity_ramp.is_none() {
            self.engine.set_gravity(self.cursor.gravity_after);
        }
        if phase.zero_displacements {
            self.engine.zero_displacements();
        }
        if !phase.edits() {
            return Ok(());
        }
        let damping = phase.damping_in(self.engine.is_implicit());
        self.evaluate(&damping, 0.0)?;
        // Nothing moves until `after`: the residual changes by what the edit adds
        // to stored and kinetic energy, and by nothing else.
        let before = self.view().balance().residual();
        // Before the edit, while the forces on the others are those that the blocks to be removed have given them.
        if let Some(span) = phase.removal_ramp {
            let blocks = std::mem::take(&mut phase.remove);
            let removed = self.engine.remove_gradually(&blocks, span, &damping);
            removed.map_err(|block| self.no_force(block))?;
        }
        let edited = self.engine.edit(&phase);
        edited.map_err(|reason| RunError::Phase {
            phase: phase.name.clone(),
            reason,
            step: self.steps(),
            time: self.time(),
        })?;
        self.evaluate(&damping, 0.0)?;
        let after = self.view().balance().residual();
        self.engine.works().edit_defect += after - before;
        Ok(())
    }

    /// Ends the motion under `before` with the half kick of its own step and forces where those of `phase` are others: velocities are
    /// those of the instant then, and `phase` begins with a half kick of its own.
    fn end_motion(&mut self, before: Option<Phase>, phase: &Phase) -> Result<(), RunError> {
        let Some(before) = before else {
            return Ok(());
        };
        let relaxes = phase.deform.is_some_and(|d| d.relax.is_some());
        // Velocities of a static phase are those of its steps, and no motion that goes on.
        let settled = self.settles(&before) && self.view().last_dt() > 0.0;
        if relaxes || !(settled || self.forces_jump(&before, phase)) {
            return Ok(());
        }
        let implicit = self.engine.is_implicit();
        let damping = if settled { self.forgetting(0.0) } else { before.damping_in(implicit) };
        self.meet_laws(&damping)?;
        let ended = self.engine.end_motion(&damping);
        ended.map_err(|block| self.no_force(block))
    }

    /// Whether forces at the first instant of `phase` are others than at the last one of the phase `before` it.
    fn forces_jump(&self, before: &Phase, phase: &Phase) -> bool {
        let gravity = phase.gravity_ramp.is_none_or(|span| span <= 0.0)
            && self.engine.gravity() != self.cursor.gravity_after;
        let strain = |phase: &Phase| phase.deform.and_then(|d| d.strain);
        let damping = |phase: &Phase| phase.damping_in(phase.integration == Integration::Implicit);
        gravity
            || before.integration != phase.integration
            || before.levels != phase.levels
            || damping(before) != damping(phase)
            || phase.edits_forces()
            || strain(phase).is_some_and(|now| strain(before) != Some(now))
    }

    fn ramp_gravity(&mut self, ramp: Option<f64>) {
        let Some(span) = ramp else {
            return;
        };
        let share = if span > 0.0 {
            ((self.time() - self.cursor.start_time) / span).clamp(0.0, 1.0)
        } else {
            1.0
        };
        let (from, to) = (self.cursor.gravity_before, self.cursor.gravity_after);
        self.engine.set_gravity(std::array::from_fn(|k| from[k] + share * (to[k] - from[k])));
    }

    /// Lets time pass in a relaxing phase whose present load step has converged and breaks nothing more; whether the
    /// forces must be re-evaluated.
    fn relax(&mut self, phase: &Rules) -> bool {
        let (Some(rules), Some(now)) = (phase.relax, self.engine.relaxing()) else {
            return false;
        };
        let Some(span) = phase.until.time else {
            return false;
        };
        // The time that has passed is a sum of load steps and may miss the span by
        // round-off: no sliver of a load step is made for that.
        if !now.converged || self.elapsed() >= span * (1.0 - 1e-9) {
            return false;
        }
        let step = span / rules.load_steps.max(1) as f64;
        self.engine.load_step(step.min(span - self.elapsed()));
        true
    }

    fn fracture(&mut self) -> Result<usize, RunError> {
        self.engine.fracture(self.dt).map_err(|block| self.not_finite(block, "the force on it"))
    }

    /// Model time since the start of the phase, s.
    fn elapsed(&self) -> f64 {
        self.time() - self.cursor.start_time
    }

    /// Length of the coming step, which is a number above zero.
    fn checked_step(&mut self, phase: &Rules) -> Result<f64, RunError> {
        let dt = self.next_step(phase);
        if dt > 0.0 && dt.is_finite() {
            return Ok(dt);
        }
        // After the last step of a phase that nothing but its end bounds: any number will do, it is not used.
        let last = self.view().last_dt();
        if dt == f64::INFINITY && phase.until.time.is_some() && last > 0.0 && last.is_finite() {
            return Ok(last);
        }
        Err(RunError::NoStep { dt, step: self.steps(), time: self.time() })
    }

    /// Length of the coming step: the rule of the phase, shortened for fast blocks and for the end.
    fn next_step(&mut self, phase: &Rules) -> f64 {
        if phase.relax.is_some() {
            // Fictitious masses are chosen so that a step of one is stable.
            return 1.0;
        }
        let stable = match phase.time_step {
            TimeStep::Given { .. } => f64::INFINITY,
            TimeStep::Auto { .. } => self.stable().dt,
        };
        let wanted = match phase.time_step {
            TimeStep::Auto { .. } if phase.settles => STATIC_STEP,
            TimeStep::Auto { .. } if self.engine.is_implicit() => IMPLICIT_STEP,
            rule => rule.wanted(stable, &phase.until, phase.gravity_ramp),
        };
        let limit = self.engine.step_limit(phase.time_step);
        let mut dt = wanted;
        if phase.settles {
            dt = wanted.min(limit).min(self.engine.settling_step());
        } else if limit < dt {
            dt = limit;
            self.cursor.shortened += 1;
            let why = self.engine.limited_by(phase.time_step);
            self.note_shorter(phase.time_step, limit, why);
        }
        dt = self.after_short_steps(phase, dt);
        dt = self.within_cycle(dt);
        if let Some(span) = phase.until.time {
            let left = self.cursor.start_time + span - self.time();
            // A little longer rather than a tiny last step.
            if left <= 1.001 * dt && left > 0.0 {
                dt = left;
            }
        }
        dt
    }
}

/// Contacts whose longest step has fallen below this share of the coming one count at once, not from the next step on: those of
/// the first instant, and of blocks that a change of the model has set free.
const SUDDEN: f64 = 0.5;

/// What the loop needs of a phase at each step.
#[derive(Clone, Copy, Debug)]
struct Rules {
    until: Until,
    time_step: TimeStep,
    damping: Damping,
    gravity_ramp: Option<f64>,
    /// Time before which it cannot end at rest, s.
    ramp: Option<f64>,
    relax: Option<Relaxing>,
    /// Whether implicit steps seek an equilibrium.
    settles: bool,
    /// Largest error of an implicit step, m.
    step_error: Option<f64>,
}

/// The longer of two times that may be given.
fn longest(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::max)
}

impl Rules {
    fn of(phase: &Phase, implicit: bool) -> Self {
        Self {
            until: phase.until,
            time_step: phase.time_step,
            damping: phase.damping_in(implicit),
            gravity_ramp: phase.gravity_ramp,
            ramp: longest(phase.gravity_ramp, phase.removal_ramp),
            relax: phase.deform.and_then(|d| d.relax),
            settles: implicit && phase.kind == PhaseKind::Static,
            step_error: phase.step_error.filter(|_| implicit && phase.kind != PhaseKind::Static),
        }
    }
}
