//! Forces of the coming step, and steps that are halved for them: implicit ones that have no solution, and those of a phase that gives their largest error, until a step
//! and two of half its length agree.

use super::{Rules, RunError, Simulation};

/// A step over the last one at most.
const GROWTH: f64 = 2.0;
/// Share of the allowed step that steps by level begin with.
const SPARE: f64 = 0.97;
/// How often a step is halved at most: an impact has its error in any step, and what is left of it is the speed times the step.
const HALVINGS: usize = 12;

/// How often an implicit step that does not converge is halved before the run stops.
const UNSOLVED: usize = 6;

impl Simulation {
    /// Finds the forces for the coming step, which is halved where an implicit one does not converge.
    pub(super) fn evaluate_step(&mut self, phase: &Rules) -> Result<(), RunError> {
        if !self.cursor.laws.is_empty() {
            return self.evaluate(&self.damping(phase), self.dt);
        }
        self.keep_within_error(phase);
        for _ in 0..UNSOLVED {
            match self.engine.evaluate(&self.damping(phase), self.dt) {
                Ok(()) => return Ok(()),
                Err(_) if self.engine.not_solved().is_some_and(|failed| failed.rounds > 0) => {
                    self.dt *= 0.5;
                    self.cursor.shortened += 1;
                    let why = "contacts that did not come to balance in a longer implicit step";
                    self.note_shorter(phase.time_step, self.dt, why);
                }
                Err(block) => return Err(self.no_force(block)),
            }
        }
        self.evaluate(&self.damping(phase), self.dt)
    }

    /// The length `dt` (s) of the coming step, not much longer than that of the last one.
    pub(super) fn after_short_steps(&self, phase: &Rules, dt: f64) -> f64 {
        let last = self.view().last_dt();
        if phase.step_error.is_some() && last > 0.0 { dt.min(GROWTH * last) } else { dt }
    }

    /// The length `dt` (s) of the coming step where steps have levels: it grows at instants alone that all levels share, and is a little shorter
    /// than what is allowed there, so that most steps until the next one are as long.
    pub(super) fn within_cycle(&self, dt: f64) -> f64 {
        let Some(cycle) = self.engine.cycle() else {
            return dt;
        };
        let last = self.view().last_dt();
        if last > 0.0 && !self.steps().is_multiple_of(cycle) {
            return dt.min(last);
        }
        SPARE * dt
    }

    /// Halves the coming step until its error is below what the phase gives.
    fn keep_within_error(&mut self, phase: &Rules) {
        let Some(most) = phase.step_error else { return };
        let damping = self.damping(phase);
        for _ in 0..HALVINGS {
            let error = self.engine.step_error(&damping, self.dt);
            if error <= most {
                return;
            }
            self.dt *= 0.5;
            self.cursor.shortened += 1;
            self.note_shorter(phase.time_step, self.dt, "the error that `step_error` gives");
        }
    }
}
