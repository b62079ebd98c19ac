//! Damping that is not part of a contact law.

use serde::{Deserialize, Serialize};

/// Damping of a phase besides that of the contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Damping {
    /// Mass-proportional: force = -mass * m * v, 1/s.
    pub mass: f64,
    /// As `mass`, for rotation: moment = -rotation * I * w, 1/s; `None` is the same as `mass`.
    #[serde(default)]
    pub rotation: Option<f64>,
    /// Stiffness-proportional part added to the contact dashpots, s.
    pub stiffness: f64,
    /// Local non-viscous: share of the unbalanced force, against the velocity (Cundall 1987).
    pub local: f64,
}
