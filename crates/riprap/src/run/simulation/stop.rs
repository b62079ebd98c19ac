//! When a phase is over, and when a run is stopped.

use super::{Rules, RunError, Simulation};
use crate::run::plan::Relaxing;

/// Overlap over the smaller inscribed radius at which a run is stopped: beyond 1 blocks pass through.
const WORST_OVERLAP: f64 = 0.5;
/// Steps between two looks at guards and at costly stop criteria.
const LOOK: u64 = 50;

impl Simulation {
    /// Whether the present phase is over.
    pub(super) fn phase_over(&self, phase: &Rules) -> bool {
        let until = &phase.until;
        let steps = self.steps() - self.cursor.start_step;
        if until.steps.is_some_and(|n| steps >= n) {
            return true;
        }
        if let Some(rules) = phase.relax {
            return self.relaxed(phase, rules);
        }
        let elapsed = self.elapsed();
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
                || until.kinetic.is_some_and(|x| self.view().kinetic() <= x))
    }

    /// Whether a relaxing phase is over: all its time has passed and nothing moves or breaks any more, or it does
    /// not converge.
    fn relaxed(&self, phase: &Rules, rules: Relaxing) -> bool {
        let now = self.engine.relaxing();
        now.is_none_or(|now| {
            let all = phase
                .until
                .time
                .is_none_or(|span| self.elapsed() >= span * (1.0 - 1e-9));
            (now.converged && all) || now.iterations >= rules.iterations
        })
    }

    /// Stops runs that have left the range in which they mean anything.
    pub(super) fn guard(&self) -> Result<(), RunError> {
        let (step, time) = (self.steps(), self.time());
        if !step.is_multiple_of(LOOK) || step == 0 {
            return Ok(());
        }
        let view = self.view();
        if let Some((ratio, i, j)) = view.worst_overlap()
            && ratio > WORST_OVERLAP
        {
            return Err(RunError::Overlap {
                first: view.name(i),
                second: view.name(j),
                percent: 100.0 * ratio,
                step,
                time,
            });
        }
        let (kinetic, put_in) = (view.kinetic(), view.put_in());
        if kinetic > 5.0 * put_in + 1e-12 {
            return Err(RunError::BlowUp {
                block: view.fastest().map_or_else(String::new, |(name, _)| name),
                kinetic,
                ratio: kinetic / put_in.max(f64::MIN_POSITIVE),
                step,
                time,
            });
        }
        Ok(())
    }
}
