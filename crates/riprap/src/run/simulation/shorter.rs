//! Time steps that a phase gives and the run makes shorter.

use super::Simulation;
use crate::plan::TimeStep;

/// The shortest step of a run in place of one that a phase gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shorter {
    /// Index of the phase.
    phase: usize,
    /// Step that is given, s.
    given: f64,
    /// Step that was made instead, s.
    dt: f64,
    /// Step count before it.
    step: u64,
    /// Model time before it, s.
    time: f64,
    /// What it was made shorter for, in words.
    why: &'static str,
}

impl Simulation {
    /// Notes a step of `dt` (s) that is shorter than the one that `rule` gives, because of `why`.
    pub(super) fn note_shorter(&mut self, rule: TimeStep, dt: f64, why: &'static str) {
        let TimeStep::Given { dt: given } = rule else {
            return;
        };
        if self.shorter.is_none_or(|known| dt / given < known.dt / known.given) {
            self.shorter = Some(Shorter {
                phase: self.cursor.phase,
                given,
                dt,
                step: self.steps(),
                time: self.time(),
                why,
            });
        }
    }

    /// The shortest step in place of one that a phase gives, in words. What it was before a run went on is in the manifest.
    pub(in crate::run) fn shorter(&self) -> Option<String> {
        let Shorter { phase, given, dt, step, time, why } = self.shorter?;
        let name = self.plan.phases.get(phase).map_or("", |p| p.name.as_str());
        Some(format!(
            "the `time_step` of phase `{name}`, {given:.3e} s, was reduced to as little as {dt:.3e} s because of {why} (step {step}, t = {time:.4e} \
             s)"
        ))
    }
}
