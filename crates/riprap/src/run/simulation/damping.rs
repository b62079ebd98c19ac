//! Damping of a phase, beside that of its contacts.

use super::{Rules, Simulation};
use crate::plan::{Damping, Phase, PhaseKind};

/// Share of the unbalanced force that local damping takes in static phases, unless one is given.
const STATIC_DAMPING: f64 = 0.7;

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

/// Damping of a phase; static phases of explicit steps have local damping unless another is given. `implicit`: whether its steps are.
#[must_use]
pub fn damping_of(phase: &Phase, implicit: bool) -> Damping {
    let mut damping = phase.damping;
    if implicit {
        return damping;
    }
    if phase.kind == PhaseKind::Static && damping.local == 0.0 && damping.mass == 0.0 {
        damping.local = STATIC_DAMPING;
    }
    damping
}
