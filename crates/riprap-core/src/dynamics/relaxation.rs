//! How static phases find rest.

use riprap_keys::Words;
use serde::{Deserialize, Serialize};

/// How a phase is calculated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum PhaseKind {
    /// Towards rest, with automatic damping (dynamic relaxation); time has no meaning.
    Static,
    /// Motion in time.
    #[default]
    Dynamic,
}

/// How a phase steps through time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Integration {
    /// Short steps, each from the forces of its start: waves, blasts, impacts, fracture.
    #[default]
    Explicit,
    /// Long steps that find the forces of their end: stiff blocks that move slowly.
    Implicit,
    /// Implicit where its step is 20 times the explicit one or more and all of the model can take it; in a static phase without damping wherever the model can.
    Automatic,
}

/// How a static phase of deformable blocks relaxes; the default is adaptive damping, equilibrium by the forces and
/// breaking event by event.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Relaxation {
    /// A constant c, 0 to 2, instead of the adaptive damping.
    pub damping: Option<f64>,
    /// Converged when the elastic energy changes by less than this share between two looks, instead of by the forces.
    pub energy: Option<f64>,
    /// When bonds break.
    pub breaks: Breaks,
}

/// When bonds break in a static phase.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Breaks {
    /// At an equilibrium what is used most, with what is used nearly as much; then a new equilibrium.
    #[default]
    Most,
    /// At an equilibrium everything beyond its strength.
    All,
    /// In every iteration every spring beyond its strength; only with `failure = "spring"`.
    Always,
}
