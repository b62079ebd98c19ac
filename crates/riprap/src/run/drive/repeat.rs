//! Whether the time step is to blame for a stop: the last stretch is done over with half the step.
//!
//! A copy of the state is kept every [`EVERY`] steps and at the start of each phase, two of them, so that the older lies well
//! before whatever went wrong. When the physics stops the run, the stretch from there is repeated with half the step (half the stable
//! one where the step was above it), and only what comes of that may be said of the step.

use std::time::{Duration, Instant};

use crate::exec::Exec;
use crate::ledger::Unexplained;
use crate::plan::TimeStep;
use crate::run::simulation::{Reached, RunError, Simulation, Snapshot};

/// Steps between two copies of the state.
const EVERY: u64 = 500;
/// Blocks of a model above which no copies are kept: they would take memory and time that a large run needs itself.
const BLOCKS: usize = 20_000;
/// Steps that a repetition may take, and seconds.
const STEPS: u64 = 20 * EVERY;
const PATIENCE: Duration = Duration::from_secs(20);
/// A residual that half the step changes by less than this share of itself does not depend on the step.
const SAME: f64 = 0.25;

/// A state from which a stretch can be repeated.
#[derive(Debug)]
struct Kept {
    snapshot: Snapshot,
    step: u64,
    phase: usize,
}

/// The last states of a run.
#[derive(Debug, Default)]
pub(super) struct Keeper {
    /// The older one first.
    kept: Vec<Kept>,
}

impl Keeper {
    /// Keeps the present state where one is due; to be called before the forces at it are found.
    pub(super) fn keep(&mut self, simulation: &mut Simulation) {
        let (step, phase) = (simulation.steps(), simulation.cursor().phase);
        let due = match self.kept.last() {
            None => true,
            Some(last) => last.phase != phase || step >= last.step + EVERY,
        };
        if !due {
            return;
        }
        if self.kept.last().is_some_and(|last| last.phase != phase) {
            self.kept.clear();
        }
        if simulation.view().all_blocks() > BLOCKS || simulation.relaxes() {
            return;
        }
        if self.kept.len() > 1 {
            self.kept.remove(0);
        }
        simulation.settle();
        self.kept.push(Kept { snapshot: simulation.snapshot(), step, phase });
    }

    /// What half the step says of the error that stops the run; nothing where the step cannot be what is wrong.
    pub(super) fn judge(self, stopped: &mut Simulation, error: &RunError) -> Option<String> {
        if !error.doubts_the_step() || stopped.relaxes() {
            return None;
        }
        let Some(kept) = self.kept.into_iter().next() else {
            return Some(format!(
                "a shorter step was not tried because the model has more than {BLOCKS} blocks; run it with half the step to find out"
            ));
        };
        let energy = doubted(error).of(&stopped.balance());
        Some(repeat(kept, stopped, error, energy))
    }
}

/// The energy that is asked for in the repetition.
fn doubted(error: &RunError) -> Unexplained {
    match error {
        RunError::Residual { what, .. } => *what,
        _ => Unexplained::Residual,
    }
}

/// Goes from a kept state to the instant of the stop with half the step, and says what came of it.
fn repeat(kept: Kept, stopped: &Simulation, error: &RunError, energy: f64) -> String {
    let from = kept.step;
    let stable =
        stopped.engine().stable(stopped.phase().map_or(0.0, |phase| phase.damping.stiffness));
    let dt = 0.5 * stopped.dt().min(stable.dt);
    let what = if stopped.dt() > stable.dt { "half the stable step" } else { "half the step" };
    if !(dt > 0.0 && dt.is_finite()) {
        return "a shorter step was not tried: half the step is not a finite number".to_owned();
    }
    let mut snapshot = kept.snapshot;
    // Where the phase ends the repetition does.
    snapshot.plan.phases.truncate(kept.phase + 1);
    let Some(phase) = snapshot.plan.phases.get_mut(kept.phase) else {
        return "a shorter step was not tried: the phase has ended".to_owned();
    };
    phase.time_step = match phase.time_step {
        TimeStep::Auto { safety } if stopped.dt() <= stable.dt => {
            TimeStep::Auto { safety: 0.5 * safety }
        }
        TimeStep::Auto { .. } | TimeStep::Given { .. } => TimeStep::Given { dt },
    };
    phase.max_residual = f64::INFINITY;
    phase.until.steps = None;
    let mut trial = Simulation::resume(snapshot, Exec::serial());
    let doubted = doubted(error);
    match to(stopped.time(), &mut trial, doubted) {
        Ok(Some(before)) => {
            of_residual(error, what, from, [before, energy, doubted.of(&trial.balance())])
        }
        Ok(None) => format!(
            "the effect of a shorter step is unknown: the repeat from step {from} with {what} took too long"
        ),
        Err(again) => format!(
            "a repeat from step {from} with {what} stopped as well (t = {:.4e} s: {}), so the step alone is not the cause",
            trial.time(),
            again.kind()
        ),
    }
}

/// The verdict where the instant was reached: for a residual by how it has grown, `[at the kept state, when stopped, repeated]`.
fn of_residual(error: &RunError, what: &str, from: u64, values: [f64; 3]) -> String {
    let RunError::Residual { what: energy, unit, .. } = error else {
        return format!(
            "a repeat from step {from} with {what} did not stop, so the step is too long: shorten it (`safety`, `time_step`)"
        );
    };
    let [before, full, half] = values;
    let (full, half) = (full - before, half - before);
    let verdict = if full.abs() < SAME * before.abs() {
        "so the step is not the cause: it was there before"
    } else if (half - full).abs() < SAME * full.abs() {
        "so the step is not the cause"
    } else if half.abs() < full.abs() {
        "so the step is too long: shorten it (`safety`, `time_step`)"
    } else {
        "so a shorter step alone does not help"
    };
    format!(
        "from step {from} on, {energy} changed by {full:.3e} {unit}, and in a repeat with {what} by {half:.3e} {unit}, {verdict}"
    )
}

/// Advances within the phase to a model time: the energy that is doubted at the beginning; `None` where it takes too long.
fn to(time: f64, trial: &mut Simulation, doubted: Unexplained) -> Result<Option<f64>, RunError> {
    let begun = Instant::now();
    let first = trial.steps();
    let mut goes_on = trial.advance(0)? == Reached::Asked && trial.time() < time;
    let before = if goes_on { doubted.of(&trial.balance()) } else { 0.0 };
    while goes_on {
        let reached = trial.advance(1)?;
        if trial.steps() - first > STEPS || begun.elapsed() > PATIENCE {
            return Ok(None);
        }
        goes_on = reached == Reached::Asked && trial.time() < time;
    }
    Ok(Some(before))
}

#[cfg(test)]
mod tests {
    use super::{RunError, Unexplained, of_residual};

    #[test]
    fn what_was_there_before_is_not_blamed_on_the_step() {
        let error = RunError::Residual {
            what: Unexplained::Residual,
            percent: 25.0,
            allowed: 10.0,
            energy: 10.4,
            unit: "J",
            fastest: String::new(),
            ruled_out: String::new(),
            step: 203,
            time: 0.02,
        };
        let words = |values| of_residual(&error, "half the step", 0, values);
        assert!(words([10.4, 10.4 + 7e-14, 10.4 - 4e-14]).contains("it was there before"));
        // Grown in the stretch, and less with half the step.
        assert!(words([0.1, 10.4, 2.6]).contains("too long"));
        assert!(words([0.1, 10.4, 10.0]).ends_with("so the step is not the cause"));
    }
}
