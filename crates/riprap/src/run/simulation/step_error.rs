//! Steps of a phase that gives their largest error: halved until a step and two of half its length agree, and doubled at most from step to step.

use super::{Rules, Simulation};

/// A step over the last one at most.
const GROWTH: f64 = 2.0;
/// How often a step is halved at most: an impact has its error in any step, and what is left of it is the speed times the step.
const HALVINGS: usize = 12;

impl Simulation {
    /// The length `dt` (s) of the coming step, not much longer than that of the last one.
    pub(super) fn after_short_steps(&self, phase: &Rules, dt: f64) -> f64 {
        let last = self.view().last_dt();
        if phase.step_error.is_some() && last > 0.0 { dt.min(GROWTH * last) } else { dt }
    }

    /// Halves the coming step until its error is below what the phase gives.
    pub(super) fn keep_within_error(&mut self, phase: &Rules) {
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
