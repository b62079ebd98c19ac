//! The error of a step.

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
}
