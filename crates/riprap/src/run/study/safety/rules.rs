//! What is asked of a search, and what it answers.

use serde::Serialize;

use super::verdict::Mechanism;
use crate::plan::Integration;
use crate::plan::shown::Shown;
use crate::run::study::bracket::State;

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
    /// How trials seek their equilibrium, and with `Automatic` static phases of the scene that leave it open: implicitly by Newton's method where the model
    /// can take it, else by relaxation.
    pub integration: Integration,
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
            integration: Integration::Automatic,
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
    /// How it sought its equilibrium: explicitly by relaxation, or implicitly by Newton's method.
    pub integration: Integration,
    /// Model time, s.
    #[serde(skip)]
    pub span: f64,
    /// Wall time, s.
    pub seconds: f64,
    /// Why the physics stopped it, and what else is to be known.
    pub note: String,
    /// Whether it came to rest although a block has moved by what counts as moved ([`Rules::moved`]).
    pub far: bool,
    /// Points of joints that had failed when it began, in the phases of the scene, and lost strength by it; 0 where it goes on from another trial.
    pub lost_before: u64,
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
