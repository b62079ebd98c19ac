//! What is asked of a search, what it answers, and why it does not.

use serde::Serialize;
use thiserror::Error;

use super::verdict::Mechanism;
use crate::exec::ExecError;
use crate::plan::shown::Shown;
use crate::run::bracket::State;
use crate::run::engine::BuildError;

/// How the search is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// Width of the answer, SI.
    pub width: f64,
    /// Interfaces whose strength is reduced, by name; empty: all.
    pub interfaces: Vec<String>,
    /// Materials: only strengths between a block of one of these and any other are reduced; empty: all.
    pub materials: Vec<String>,
    /// Groups of blocks: only strengths between a block of one of these and any other are reduced; empty: all.
    pub groups: Vec<String>,
    /// Displacement in a trial from which on it may count as failing, m; `None`: a thousandth of the size of the middle one of the blocks.
    pub moved: Option<f64>,
    /// Ratio of unbalanced forces at which a trial is stable.
    pub balance: f64,
    /// Steps of a trial after which it is undecided.
    pub steps: u64,
    /// Whether every trial runs the scene from its start with the reduced strengths, instead of going on from the last stable state.
    pub from_start: bool,
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            width: 0.01,
            interfaces: Vec::new(),
            materials: Vec::new(),
            groups: Vec::new(),
            moved: None,
            balance: 1e-5,
            steps: 100_000,
            from_start: false,
        }
    }
}

/// One trial.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// Factor that strengths are divided by, or value of the quantity, SI.
    pub value: f64,
    /// What came of it.
    pub state: State,
    /// Largest displacement of a block in the trial, m.
    pub moved: f64,
    /// The block that has it.
    pub block: String,
    /// Unbalanced forces over all forces at the end.
    pub unbalanced: f64,
    /// Steps.
    pub steps: u64,
    /// Wall time, s.
    pub seconds: f64,
    /// Why the physics stopped it, and what else is to be known.
    pub note: String,
    /// Number of the phase of the scene in which it failed already.
    #[serde(skip)]
    pub phase: Option<usize>,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The key of the quantity that was searched for; `None`: a factor of safety.
    pub quantity: Option<String>,
    /// SI unit of the values; empty for plain numbers.
    pub unit: String,
    /// The unit in which they are shown.
    #[serde(skip)]
    pub shown: Shown,
    /// Width that was asked for, SI.
    #[serde(skip)]
    pub width: f64,
    /// The value nearest to the limit that is stable; `None`: no value that was tried.
    pub stable_at: Option<f64>,
    /// The value nearest to the limit that fails; `None`: no value that was tried.
    pub fails_at: Option<f64>,
    /// Whether there is an undecided trial between both, so that the range is wider than was asked for.
    pub undecided: bool,
    /// All trials, in order.
    pub trials: Vec<Trial>,
    /// Blocks that move at `fails_at`, the farthest first, with their displacement in m.
    pub moving: Vec<(String, f64)>,
    /// How they move.
    pub mechanism: Option<Mechanism>,
}

/// Why there is no answer.
#[derive(Debug, Error)]
pub enum SafetyError {
    /// The engine cannot build the model.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// No threads.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// The name of nothing.
    #[error("unknown {what} `{name}`; valid names: {known}")]
    Unknown {
        /// An interface, a material or a group.
        what: &'static str,
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// Nothing can be reduced.
    #[error(
        "none of the selected interfaces has a strength to reduce (friction angle, cohesion or tension): {0}"
    )]
    NoStrength(String),
    /// A number that is none.
    #[error("the width, the unbalanced-force ratio and the displacement must be above zero")]
    NotANumber,
    /// A range that is none.
    #[cfg(feature = "scenario")]
    #[error(transparent)]
    Range(#[from] RangeError),
    /// A value that the scene cannot have.
    #[cfg(feature = "scenario")]
    #[error("{0}")]
    Scene(crate::scenario::Diagnostics),
    /// The user stopped it.
    #[error("stopped by the user")]
    Stopped,
}

/// A range or a width that cannot be read.
#[cfg(feature = "scenario")]
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RangeError {
    /// Not two values.
    #[error(
        "{0:?} is not a range; write two values with units, for example '20 deg..45 deg' or '0.5..3'"
    )]
    Range(String),
    /// A width of another kind, or not above zero.
    #[error("{given:?} is not a valid width for this range; write for example {example:?}")]
    Width {
        /// What was given.
        given: String,
        /// What could be.
        example: String,
    },
}
