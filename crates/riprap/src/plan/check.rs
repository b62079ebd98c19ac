//! Checks of a scene as a run takes them: what is read, when, and what it must come out as.

use serde::{Deserialize, Serialize};

use super::Gauge;
use super::shown::Shown;
use crate::dynamics::Formula;

/// One check with SI numbers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Check {
    /// What is checked, in words.
    pub name: String,
    /// What is read.
    pub gauge: Gauge,
    /// SI unit of the field.
    pub unit: String,
    /// Unit in which the author of the scene gave what is expected; `None` where there is none.
    pub shown: Option<Shown>,
    /// When it is read.
    pub window: Window,
    /// What it must be.
    pub expected: Expected,
    /// Allowed difference as a share of the expected number; with `absolute`, either is enough.
    pub relative: Option<f64>,
    /// Allowed difference.
    pub absolute: Option<f64>,
    /// Reason why it is known to fail.
    pub known: Option<String>,
}

/// When a check is read.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Window {
    /// Before the first step.
    Start,
    /// At a model time, s; between two steps linearly.
    At(f64),
    /// After the last step.
    End,
    /// Over an interval of model time, ends included.
    Over {
        /// First time, s.
        from: f64,
        /// Last time, s; infinite for the whole run.
        to: f64,
        /// How the values become one.
        reduce: Reduce,
    },
    /// Within one phase.
    Phase {
        /// Index of the phase.
        phase: u32,
        /// Which part of it.
        part: Part,
    },
}

/// The part of a phase in which a check is read.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Part {
    /// Its first state.
    Start,
    /// Its last state.
    End,
    /// All of it.
    Whole(Reduce),
}

impl Window {
    /// The only phase in which it is read.
    #[must_use]
    pub fn phase(self) -> Option<u32> {
        match self {
            Window::Phase { phase, .. } => Some(phase),
            Window::Start | Window::At(_) | Window::End | Window::Over { .. } => None,
        }
    }

    /// What it is for one who sees the states of that phase only.
    #[must_use]
    pub fn within(self) -> Self {
        match self {
            Window::Phase { part, .. } => match part {
                Part::Start => Window::Start,
                Part::End => Window::End,
                Part::Whole(reduce) => Window::Over { from: 0.0, to: f64::INFINITY, reduce },
            },
            Window::Start | Window::At(_) | Window::End | Window::Over { .. } => self,
        }
    }

    /// Unit of what is read of a field with this unit: a time is in s, a share is a number.
    #[must_use]
    pub fn unit(self, of_field: &str) -> &str {
        match self.within() {
            Window::Over { reduce: Reduce::FirstAbove(_) | Reduce::FirstBelow(_), .. } => "s",
            Window::Over { reduce: Reduce::ShareAbove(_), .. } => "-",
            Window::Start
            | Window::At(_)
            | Window::End
            | Window::Over { .. }
            | Window::Phase { .. } => of_field,
        }
    }
}

/// How values over an interval become one number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Reduce {
    /// Largest value.
    Max,
    /// Smallest value.
    Min,
    /// Mean over time (trapezoids).
    Mean,
    /// Root of the mean square over time (trapezoids of the square).
    Rms,
    /// Largest less smallest value.
    Range,
    /// First time at which the value is above the threshold, s.
    FirstAbove(f64),
    /// First time at which the value is below the threshold, s.
    FirstBelow(f64),
    /// Share of the time during which the value is above the threshold.
    ShareAbove(f64),
}

/// What a check must come out as.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Expected {
    /// A number.
    Value(f64),
    /// A formula in `t` (time of the reading, s) and fixed names.
    Formula {
        /// Compiled for `t` and the names.
        formula: Formula,
        /// Names and SI values besides `t`.
        names: Vec<(String, f64)>,
    },
    /// A table, linear between its points, read at the time of the reading.
    Table {
        /// Times, s, ascending.
        t: Vec<f64>,
        /// Values.
        v: Vec<f64>,
    },
    /// Lowest and highest allowed number.
    Between(f64, f64),
}
