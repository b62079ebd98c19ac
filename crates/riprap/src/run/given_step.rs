//! Time steps that the scene gives: refused before a run begins where they are longer than the stable one.
//!
//! Only in space, where the stable step is known to a fraction of a per cent. In the plane it is a safe bound, which a
//! scene may know better.

use thiserror::Error;

use super::engine::Kind;
use super::simulation::Simulation;
use crate::plan::TimeStep;

/// What the estimate of the stable step stays below the limit.
const MARGIN: f64 = 1.005;

/// A phase with a time step that is longer than the stable one.
#[derive(Clone, Debug, Error, PartialEq)]
#[error(
    "the time step {dt:.4e} s of phase `{name}` exceeds the stable step, {stable:.4e} s{}; leave `time_step` out or shorten it",
    .block.as_ref().map_or(String::new(), |b| format!(" (governed by block {b})"))
)]
pub struct TooLong {
    /// Index of the phase.
    pub phase: usize,
    /// Its name.
    pub name: String,
    /// Its time step, s.
    pub dt: f64,
    /// The longest stable step of the model at its start, s.
    pub stable: f64,
    /// Block that sets it.
    pub block: Option<String>,
}

/// Holds the steps that phases give against the stable one; phases after a change of joints are left out.
///
/// # Errors
/// The first phase whose step is too long.
pub fn check(simulation: &Simulation) -> Result<(), TooLong> {
    if simulation.kind() != Kind::Spatial {
        return Ok(());
    }
    for (k, phase) in simulation.plan().phases.iter().enumerate() {
        if !phase.joints.is_empty() {
            break;
        }
        let TimeStep::Given { dt } = phase.time_step else {
            continue;
        };
        let stable = simulation.engine().stable(phase.damping.stiffness);
        if dt > MARGIN * stable.dt {
            return Err(TooLong {
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
