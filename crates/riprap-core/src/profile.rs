//! Stage timers, always on: two clock readings a stage and step.

use std::time::Duration;

/// Accumulated time per named stage.
#[derive(Clone, Debug, Default)]
pub struct Profile {
    stages: Vec<(&'static str, Duration)>,
}

impl Profile {
    /// Books time under `name`.
    pub fn add(&mut self, name: &'static str, spent: Duration) {
        match self.stages.iter_mut().find(|(n, _)| *n == name) {
            Some((_, total)) => *total += spent,
            None => self.stages.push((name, spent)),
        }
    }

    /// Stages in the order of first use, with seconds spent.
    #[must_use]
    pub fn seconds(&self) -> Vec<(String, f64)> {
        self.stages.iter().map(|(name, time)| ((*name).to_owned(), time.as_secs_f64())).collect()
    }
}
