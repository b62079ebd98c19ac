//! Checks of a scene: what is watched during a run, and what it must come out as.
//!
//! A [`Check`] of the plan is resolved (block numbers, SI values); a [`Watch`] is fed one value a step and
//! reduces them as it goes, so that no history has to be kept; [`Watch::finish`] compares.
//! Nothing here knows an engine: whoever advances the world reads the field and calls
//! [`Watch::observe`].

mod watch;

use serde::{Deserialize, Serialize};

pub use watch::Watch;

#[cfg(doc)]
use crate::plan::Check;

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// As expected.
    Passed,
    /// Not as expected, or marked known and yet as expected.
    Failed,
    /// Known to fail, and it does.
    Skipped,
}

/// The result of one check, as `riprap verify --json` prints it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CheckResult {
    /// Scene file.
    pub scene: String,
    /// Case of the scene (variant, values of the sweep); empty where there is only one.
    pub case: String,
    /// What is checked, in words.
    pub check: String,
    /// How it ended.
    pub status: Status,
    /// What came out; absent when there was nothing to read.
    pub measured: Option<f64>,
    /// What was expected, SI, where that is one number; not written.
    #[serde(skip)]
    pub target: Option<f64>,
    /// What was expected, in words (`5.31 m`, `0.254 to 0.275 m`).
    pub expected: String,
    /// Allowed difference, in words.
    pub tolerance: String,
    /// Unit of `measured`.
    pub unit: String,
    /// What came out and what was expected, for reading: in the unit of the scene.
    pub words: String,
    /// Why it failed or was skipped.
    pub note: String,
}

impl CheckResult {
    /// Of a run that was stopped at a model time (s) before its end: nothing of it has passed.
    pub fn cut_short(&mut self, time: f64) {
        match self.status {
            Status::Passed => {
                self.status = Status::Failed;
                self.note = format!("the run was stopped at t = {time:.4e} s, before its end");
            }
            Status::Failed | Status::Skipped => {}
        }
    }

    /// Of a run that its user stopped at a model time (s): nothing of it is judged, it can go on.
    pub fn left_open(&mut self, time: f64) {
        self.status = Status::Skipped;
        self.note =
            format!("not evaluated: the run was stopped at t = {time:.4e} s and can be resumed");
    }
}
