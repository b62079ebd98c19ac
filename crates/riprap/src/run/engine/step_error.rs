//! The error of a step, and steps by level.

use super::Engine;
use crate::plan::Damping;
use crate::spatial;

impl Engine {
    /// How far from each other the blocks lie that one step of `dt` (s) moves and two of half of it, m; infinite where a step has no solution. The state stays.
    pub fn step_error(&mut self, damping: &Damping, dt: f64) -> f64 {
        match self {
            Self::Planar(_) => 0.0,
            Self::Spatial(e) => spatial::step::error(&e.world, &mut e.scratch, damping, dt),
        }
    }

    /// Evaluates found contacts once in up to 2 to the power `most` steps; 0: at each step.
    pub fn step_by_levels(&mut self, most: u8) {
        if let Self::Spatial(e) = self {
            e.world.step_by_levels(most);
        }
    }

    /// Steps between two instants at which all found contacts are evaluated, where steps have levels.
    #[must_use]
    pub fn cycle(&self) -> Option<u64> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(e) => e.world.found.levels.as_ref().map(|levels| levels.cycle()),
        }
    }
}
