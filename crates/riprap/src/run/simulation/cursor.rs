//! Where a run is in its plan, and what it needs to go on.

use serde::{Deserialize, Serialize};

use crate::run::engine::State;
use crate::run::plan::Plan;

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
    pub gravity_before: [f64; 3],
    /// Gravity the phase ends with, m/s².
    pub gravity_after: [f64; 3],
    /// Steps shortened by the engine: fast blocks, expanding gas.
    pub shortened: u64,
    /// Relaxing phases that ended at their limit of iterations.
    pub unconverged: Vec<Unconverged>,
}

/// A relaxing phase that ended at its limit of iterations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unconverged {
    /// Name of the phase.
    pub phase: String,
    /// Iterations since loads or bonds last changed.
    pub iterations: u64,
    /// Ratio of net to external forces at the end.
    pub ratio: f64,
    /// Ratio that was asked for.
    pub wanted: f64,
}

impl std::fmt::Display for Unconverged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "phase `{}` ended after {} iterations without equilibrium: the unbalanced forces are {:.1e} of the external ones, \
             {:.1e} was asked for; either the rock has failed, or `iterations` is too small",
            self.phase, self.iterations, self.ratio, self.wanted
        )
    }
}

/// Everything a run needs to go on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Snapshot {
    /// Plan of the run.
    pub plan: Plan,
    /// Place in the plan.
    pub cursor: Cursor,
    /// State of the model.
    pub state: State,
}

/// What has just come to an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Within a phase: [`step`](super::Simulation::step) may be called.
    Within,
    /// A phase has reached its end: [`next_phase`](super::Simulation::next_phase) goes on.
    PhaseEnd,
    /// All phases are done.
    Done,
}
