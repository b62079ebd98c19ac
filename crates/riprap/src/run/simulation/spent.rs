//! What forces have done in a phase: whether long steps may have driven blocks into each other.

use serde::{Deserialize, Serialize};

use super::Simulation;

/// Share of the work of weight, loads and supports that friction has taken beyond which Newton's method may have driven a wedge: blocks have slid in its long steps,
/// and friction then locks in more than the weight asks for.
const RUBBED: f64 = 0.02;

/// What forces have done, J.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spent {
    friction: f64,
    gravity: f64,
    loads: f64,
    supports: f64,
}

impl Spent {
    /// So far, at the present, prepared state.
    #[must_use]
    pub fn of(simulation: &Simulation) -> Self {
        let works = simulation.view().balance().works;
        Self {
            friction: works.friction,
            gravity: works.gravity,
            loads: works.loads,
            supports: works.supports,
        }
    }

    /// After an earlier state.
    #[must_use]
    pub fn since(self, from: Self) -> Self {
        Self {
            friction: self.friction - from.friction,
            gravity: self.gravity - from.gravity,
            loads: self.loads - from.loads,
            supports: self.supports - from.supports,
        }
    }

    /// Friction over the work of what drives the model by itself.
    #[must_use]
    pub fn rubbed(self) -> f64 {
        let driven = self.gravity.abs() + self.loads.abs() + self.supports.abs();
        if driven > 0.0 { self.friction / driven } else { 0.0 }
    }

    /// Whether blocks have slid by what weight and loads have done. What supports drive slides as it is told.
    #[must_use]
    pub fn strays(self) -> bool {
        self.rubbed() > RUBBED && self.supports.abs() < 0.5 * self.friction
    }
}
