//! Damping of a phase, beside that of its contacts.

use super::{Rules, Simulation};
use crate::plan::Damping;

impl Simulation {
    /// Damping in the coming step.
    pub(super) fn damping(&self, phase: &Rules) -> Damping {
        if phase.settles { self.forgetting(self.dt) } else { phase.damping }
    }

    /// Damping that makes blocks forget their velocities in the coming step of `dt` (s): what is solved is the equilibrium of what they
    /// reach, with masses against too long a way.
    pub(super) fn forgetting(&self, dt: f64) -> Damping {
        Damping { mass: 4.0 / (self.view().last_dt() + dt), ..Damping::default() }
    }
}
