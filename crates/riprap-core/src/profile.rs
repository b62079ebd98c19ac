//! Stage timers, always on: two readings of the clock a stage and step.

use std::time::{Duration, Instant};

use crate::exec::Exec;

/// What a stage has taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spent {
    /// Wall time.
    pub wall: Duration,
    /// The part of it in which several threads had work; the rest is serial.
    pub pooled: Duration,
}

/// When a stage began.
#[derive(Clone, Copy, Debug)]
pub struct Begun {
    wall: Instant,
    pooled: Duration,
}

impl Begun {
    /// Now.
    #[must_use]
    pub fn now(exec: &Exec) -> Self {
        Self { wall: Instant::now(), pooled: exec.pooled() }
    }

    /// What has been spent since.
    #[must_use]
    pub fn spent(self, exec: &Exec) -> Spent {
        Spent { wall: self.wall.elapsed(), pooled: exec.pooled() - self.pooled }
    }
}

/// Accumulated time per named stage.
#[derive(Clone, Debug, Default)]
pub struct Profile {
    stages: Vec<(&'static str, Spent)>,
}

impl Profile {
    /// Books time under `name`.
    pub fn add(&mut self, name: &'static str, spent: Spent) {
        let total = match self.stages.iter().position(|(n, _)| *n == name) {
            Some(at) => &mut self.stages[at].1,
            None => {
                self.stages.push((name, Spent::default()));
                let last = self.stages.len() - 1;
                &mut self.stages[last].1
            }
        };
        total.wall += spent.wall;
        total.pooled += spent.pooled;
    }

    /// Stages in the order of first use, with seconds of wall time.
    #[must_use]
    pub fn seconds(&self) -> Vec<(String, f64)> {
        let seconds =
            |(name, spent): &(&str, Spent)| ((*name).to_owned(), spent.wall.as_secs_f64());
        self.stages.iter().map(seconds).collect()
    }

    /// Stages in the order of first use, with what they have taken.
    #[must_use]
    pub fn stages(&self) -> &[(&'static str, Spent)] {
        &self.stages
    }
}
