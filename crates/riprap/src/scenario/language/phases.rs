//! The parts of a run.

use schemars::JsonSchema;
use serde::Deserialize;

use super::interfaces::InterfaceChange;
use crate::scenario::quantity::{
    Acceleration, Down, EnergyPerLength, Name, NotNegativeTime, PositivePlain, PositiveTime,
    Quantity, Rate, Share, ShareBelowOne, Table, TimeStep,
};

/// A part of the run.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Phase {
    /// Name of the phase, once in the file.
    pub name: Name,
    /// How the phase is calculated. Default `dynamic`.
    pub kind: Option<PhaseKind>,
    /// When the phase ends: the first condition that is reached.
    pub until: Until,
    /// Time step, s. Default automatic: `safety` times the stable one.
    pub time_step: Option<Quantity<TimeStep>>,
    /// Share of the stable time step that is used when `time_step` is not given, greater than 0
    /// and at most 1. Default 0.2 in `[space.planar]` and 0.5 in `[space.spatial]`.
    pub safety: Option<Quantity<Share>>,
    /// Damping of the motion besides that of the contacts. Default none in a `dynamic` phase.
    pub damping: Option<Damping>,
    /// Groups or blocks that are taken away when the phase begins.
    #[serde(default)]
    pub remove: Vec<Name>,
    /// Groups or blocks that are fixed when the phase begins.
    #[serde(default)]
    pub fix: Vec<Name>,
    /// Groups or blocks whose supports are taken away when the phase begins.
    #[serde(default)]
    pub release: Vec<Name>,
    /// Gravity from this phase on, m/s2; in `[space.spatial]` a vector or the one value that points
    /// down. Default unchanged.
    pub gravity: Option<Down<Acceleration>>,
    /// Time over which gravity grows from its old value (zero in the first phase), s.
    /// Default 0 s: at once.
    pub gravity_ramp: Option<Quantity<NotNegativeTime>>,
    /// What is set to zero when the phase begins.
    #[serde(default)]
    pub reset: Vec<Reset>,
    /// Interfaces that change from this phase on, by name.
    #[serde(default)]
    pub interfaces: Table<InterfaceChange>,
    /// Whether bonds of deformable blocks may break. Default true.
    #[schemars(extend("x-space" = "spatial"))]
    pub breaking: Option<bool>,
    /// Number of steps in which time passes in a `static` phase of deformable blocks with `until.time`: loads and driven
    /// nodes follow it, and each step is relaxed to `until.unbalanced`. Default 1.
    #[schemars(extend("x-space" = "spatial"))]
    pub load_steps: Option<u64>,
    /// Iterations after which a load step of deformable blocks that does not converge ends a `static` phase. Default
    /// 200000.
    #[schemars(extend("x-space" = "spatial"))]
    pub iterations: Option<u64>,
}

/// How a phase is calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PhaseKind {
    /// Towards rest, with automatic damping (dynamic relaxation); time has no meaning.
    Static,
    /// Motion in time.
    Dynamic,
}

/// End of a phase; at least one condition, the first that is reached counts.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Until {
    /// Duration of the phase in model time, s.
    pub time: Option<Quantity<PositiveTime>>,
    /// Ratio of unbalanced to applied forces, for example 1e-5; greater than zero.
    pub unbalanced: Option<Quantity<PositivePlain>>,
    /// Kinetic energy of all blocks, J; in the plane per metre of thickness, J/m.
    pub kinetic: Option<Quantity<EnergyPerLength>>,
    /// Number of steps, at least 1.
    pub steps: Option<u64>,
}

/// Damping of the motion of blocks.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Damping {
    /// Force against the velocity, proportional to mass, 1/s; zero or more. Default 0 1/s.
    pub mass: Option<Quantity<Rate>>,
    /// The same for turning: moment against the spin, proportional to inertia, 1/s. Default as
    /// `mass`.
    #[schemars(extend("x-space" = "spatial", "x-instead" = "`mass` damps turning too"))]
    pub rotation: Option<Quantity<Rate>>,
    /// Proportional to contact stiffness, s; zero or more. Default 0 s.
    pub stiffness: Option<Quantity<NotNegativeTime>>,
    /// Share of the unbalanced force taken off, against the motion; at least 0, less than 1.
    /// Default 0. For static questions.
    pub local: Option<Quantity<ShareBelowOne>>,
}

/// What a phase can set to zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reset {
    /// Velocities and spins of all blocks.
    Velocities,
    /// Displacements and rotations of all blocks as outputs report them.
    Displacements,
}
