//! State of static phases of deformable blocks.

use serde::{Deserialize, Serialize};

pub use crate::dynamics::relaxation::{Breaks, Relaxation};

/// State of a relaxing phase.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Relax {
    /// Damping c of the coming iterations.
    pub damping: f64,
    /// Ratio of net to external forces at which it is converged.
    pub tolerance: f64,
    /// Iterations since the last look.
    pub since: u32,
    /// Iterations since loads or bonds last changed.
    pub iterations: u64,
    /// Ratio at the last look.
    pub ratio: f64,
    /// Whether the last look found it converged.
    pub converged: bool,
    /// Whether what points remember has been committed since.
    pub settled: bool,
    /// Model time that passes in the coming iteration, s: load steps.
    pub increment: f64,
    /// Displacements (m) and net forces (N) at the last look.
    pub last: Option<Seen>,
    /// Largest norm of the external forces or reactions so far in the phase, N.
    pub largest: f64,
    /// How it relaxes.
    pub relaxation: Relaxation,
    /// Elastic energy at the last look, J, where it decides.
    pub energy: Option<f64>,
}

/// What the last look saw.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Seen {
    /// Displacements of the nodes, m.
    pub displacement: Vec<[f64; 3]>,
    /// Net forces on them, N.
    pub net: Vec<[f64; 3]>,
}
