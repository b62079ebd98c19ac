//! Steps that the scene asks for and a run cannot make, refused before it begins: time steps that are longer than the stable one, and
//! implicit phases of models that cannot take them.
//!
//! Time steps only in space, where the stable step is known to a fraction of a per cent. In the plane it is a safe bound, which a
//! scene may know better.

use thiserror::Error;

use super::engine::Kind;
use super::simulation::Simulation;
use crate::plan::{Integration, TimeStep};
use crate::spatial::Obstacle;

/// What the estimate of the stable step stays below the limit.
const MARGIN: f64 = 1.005;

/// A step that cannot be made.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RefusedStep {
    /// It is longer than the stable one.
    #[error(
        "the time step {dt:.4e} s of phase `{name}` exceeds the stable step, {stable:.4e} s{}; leave `time_step` out or shorten it",
        .block.as_ref().map_or(String::new(), |b| format!(" (governed by block {b})"))
    )]
    TooLong {
        /// Index of the phase.
        phase: usize,
        /// Its name.
        name: String,
        /// Its time step, s.
        dt: f64,
        /// The longest stable step of the model at its start, s.
        stable: f64,
        /// Block that sets it.
        block: Option<String>,
    },
    /// The model cannot be stepped implicitly.
    #[error(
        "phase `{name}` is implicit, but {what}, which implicit phases do not support yet; {remedy}, or use `integration = \"explicit\"`"
    )]
    Implicit {
        /// Index of the phase.
        phase: usize,
        /// Its name.
        name: String,
        /// What implicit phases do not take.
        what: String,
        /// What to do instead.
        remedy: &'static str,
    },
}

/// Holds the steps that phases give against the stable one; phases after a change of joints are left out.
///
/// # Errors
/// The first phase whose step is too long, or that is implicit and cannot be.
pub fn check(simulation: &Simulation) -> Result<(), RefusedStep> {
    if simulation.kind() != Kind::Spatial {
        return Ok(());
    }
    let mut changed = false;
    for (k, phase) in simulation.plan().phases.iter().enumerate() {
        changed |= !phase.joints.is_empty();
        if phase.integration == Integration::Implicit {
            if let Some(Obstacle { what, remedy }) = simulation.engine().obstacle() {
                let name = phase.name.clone();
                return Err(RefusedStep::Implicit { phase: k, name, what, remedy });
            }
            continue;
        }
        if changed || phase.integration == Integration::Automatic {
            continue;
        }
        let TimeStep::Given { dt } = phase.time_step else {
            continue;
        };
        let stable = simulation.engine().stable(phase.damping.stiffness);
        if dt > MARGIN * stable.dt {
            return Err(RefusedStep::TooLong {
                phase: k,
                name: phase.name.clone(),
                dt,
                stable: stable.dt,
                block: stable.block.map(|b| simulation.view().name(b)),
            });
        }
    }
    Ok(())
}
