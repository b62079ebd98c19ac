//! The parts of a run.

use riprap_keys::{Keys, Words};
use serde::Deserialize;

use super::interfaces::InterfaceChange;
use super::regions::HalfSpace;
use super::solids::BoxRegion;
use crate::quantity::{
    Acceleration, Down, EnergyPerLength, Name, Names, NotNegativeTime, PositiveLength,
    PositivePlain, PositiveTime, Quantity, Rate, Share, ShareBelowOne, Speed, Strength, Table,
    TimeStep,
};
use riprap_core::dynamics::relaxation::{Breaks, Integration, PhaseKind};
use riprap_core::laws::fracture::Criterion;
use riprap_core::laws::parameters::CutAnchor;
use riprap_core::laws::tetrahedron::Strain;

/// A part of the run.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Phase {
    /// Name of the phase, once in the file.
    pub name: Name,
    /// How the phase is calculated.
    #[key(default)]
    pub kind: Option<PhaseKind>,
    /// When the phase ends: the first condition that is reached.
    pub until: Until,
    /// How the phase steps through time.
    #[key(space = "spatial")]
    #[key(default)]
    pub integration: Option<Integration>,
    /// Time step, s. Default automatic: `safety` times the stable one; 1 ms in an implicit phase, less where blocks approach each other fast.
    pub time_step: Option<Quantity<TimeStep>>,
    /// Largest error of an implicit step, m: steps are halved until each block lies within it of where two steps of half the length bring it, its turn counted at its
    /// farthest corner. Default none: steps are as long as `time_step`.
    #[key(space = "spatial")]
    #[key(only_with("integration = implicit & !kind = static"))]
    pub step_error: Option<Quantity<PositiveLength>>,
    /// Share of the stable time step that is used. Contacts that are found in space have a share of their own, which
    /// goes down with this one below 0.5 and does not grow above.
    #[key(planar = "0.2", spatial = "0.5")]
    #[key(only_with("!time_step & !integration = implicit"))]
    pub safety: Option<Quantity<Share>>,
    /// Found contacts of blocks that allow steps 2, 4, 8 ... times as long as the shortest are evaluated once in as many steps, up to 2 to the power of this number.
    /// Joints, gas and all else are found at each step.
    #[key(space = "spatial")]
    #[key(default = 0, min = 0, max = 8)]
    #[key(only_with("!integration = implicit & !integration = automatic & !kind = static"))]
    pub levels: Option<u64>,
    /// Damping of the motion besides that of the contacts. Default none in a `dynamic` phase.
    pub damping: Option<Damping>,
    /// Largest energy residual, as a share of the largest energy that moved; beyond it the run is stopped.
    #[key(default = "0.1")]
    pub max_residual: Option<Quantity<PositivePlain>>,
    /// Groups or blocks that are taken away when the phase begins.
    #[serde(default)]
    pub remove: Vec<Name>,
    /// Time over which the forces that removed blocks gave to those that stay fade to nothing, s; rest before that does not end
    /// the phase. Default 0 s: at once.
    #[key(only_with("remove"))]
    pub removal_ramp: Option<Quantity<NotNegativeTime>>,
    /// Free rigid blocks are taken away as soon as their centroid leaves the model. What they take along is booked: `model.left_mass`,
    /// `model.left_momentum`, `energy.left`. Default: none is.
    pub leavers: Option<Leavers>,
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
    /// Water table from this phase on, `none`, or several tables, each `within` a box. Default unchanged, in the first phase the only table.
    pub water: Option<Names>,
    /// What is set to zero when the phase begins.
    #[serde(default)]
    pub reset: Vec<Reset>,
    /// Interfaces that change from this phase on, by name.
    #[serde(default)]
    pub interfaces: Table<InterfaceChange>,
    /// Whether bonds of deformable blocks may break.
    #[key(space = "spatial")]
    #[key(default = true)]
    pub breaking: Option<bool>,
    /// Measure of strain of all deformable blocks from this phase on. Default: that of the blocks, or of the phase before.
    #[key(space = "spatial")]
    pub strain: Option<Strain>,
    /// Number of steps in which time passes for deformable blocks: loads and
    /// driven nodes follow it, and each step is relaxed to `until.unbalanced`.
    #[key(space = "spatial")]
    #[key(default = 1, min = 1, max = 1_000_000)]
    #[key(needs(
        "until.time",
        help = "say how much time passes in these steps: until = { time = \"1 s\" }"
    ))]
    #[key(only_with("kind = static"))]
    pub load_steps: Option<u64>,
    /// Iterations after which a load step of deformable blocks that does not converge ends a `static` phase.
    #[key(space = "spatial")]
    #[key(default = 200_000, min = 1)]
    #[key(only_with("kind = static"))]
    pub iterations: Option<u64>,
    /// Rules of Han, Liu & Li (2010) for a `static` phase of deformable blocks. Default: adaptive damping, equilibrium by forces, breaking event by event.
    #[key(space = "spatial")]
    pub relaxation: Option<Relaxation>,
    /// Lets deformable blocks be cut where they are about to break. Default: none is cut.
    #[key(space = "spatial")]
    pub cut: Option<Cutting>,
}

/// Where the model ends for blocks that fly or fall out of it.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(any_of("outside", "beyond"))]
pub struct Leavers {
    /// Blocks outside this box leave.
    pub outside: Option<BoxRegion>,
    /// Blocks on the side of a plane (in the plane of a line) to which its normal points leave.
    pub beyond: Option<HalfSpace>,
}

/// How a static phase of deformable blocks relaxes, where it is not by default.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Relaxation {
    /// Constant damping c of `v' = ((2 - c) v + 2 r/m)/(2 + c)`. Default adaptive.
    pub damping: Option<Quantity<ShareBelowOne>>,
    /// Equilibrium where the elastic energy changes by less than this share in 25 iterations, whatever the forces. Default:
    /// by the forces (`until.unbalanced`).
    pub energy: Option<Quantity<PositivePlain>>,
    /// When bonds break.
    #[key(default)]
    pub breaks: Option<Breaks>,
}

/// Cutting of deformable blocks by parallel planes, in `static` phases whenever the forces have converged, in `dynamic` ones
/// every ten steps. The strength is
/// that of the bonds within the material.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Cutting {
    /// Planes per cut, 1 to 7: one part more.
    #[key(default = 3, min = 1, max = 7)]
    pub planes: Option<u64>,
    /// What decides.
    #[key(default)]
    pub criterion: Option<Criterion>,
    /// How much before the tensile strength a block is cut, Pa.
    #[key(default = "0 Pa")]
    pub margin_tension: Option<Quantity<Strength>>,
    /// How much before the shear strength a block is cut, Pa.
    #[key(default = "0 Pa")]
    pub margin_shear: Option<Quantity<Strength>>,
    /// How often a block and its parts may be cut: (planes + 1)^generations parts at most, which must not be above
    /// 4096.
    #[key(default = 1, min = 1, max = 12)]
    pub generations: Option<u64>,
    /// Edge of a cube as large as the smallest part that may be made, m. Default none.
    pub smallest: Option<Quantity<PositiveLength>>,
    /// Where the planes lie.
    #[key(default)]
    pub anchor: Option<CutAnchor>,
    /// Whether only facets between parts of one block break. Default false.
    #[serde(default)]
    #[key(only_with("anchor = tip"))]
    pub only_cut: bool,
    /// Axis that lies in all planes of cuts, for plane strain across it. Default: the direction of the middle principal
    /// stress.
    pub along: Option<CutAxis>,
    /// Corners nearer than this share of the spacing of the planes to a plane are on it.
    #[key(default = "0.03")]
    pub snap: Option<Quantity<ShareBelowOne>>,
    /// Most times that blocks are cut in the phase. Default: no limit.
    #[key(min = 1)]
    pub stages: Option<u64>,
    /// In `dynamic` phases a block is not cut if a part would need a time step below this share of that of the block.
    #[key(default = "0.1")]
    pub step_floor: Option<Quantity<ShareBelowOne>>,
}

/// An axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Words)]
pub enum CutAxis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

/// End of a phase: the first condition that is reached counts.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(any_of("time", "unbalanced", "kinetic", "rest", "steps"))]
pub struct Until {
    /// Duration of the phase in model time, s.
    pub time: Option<Quantity<PositiveTime>>,
    /// Ratio of unbalanced to applied forces, for example 1e-5.
    pub unbalanced: Option<Quantity<PositivePlain>>,
    /// Kinetic energy of all blocks, J; in the plane per metre of thickness, J/m.
    pub kinetic: Option<Quantity<EnergyPerLength>>,
    /// The model rests: its kinetic energy is a small share of the largest so far and no block is fast, for some time, and no charge is
    /// still to go off. `rest = {}` has the defaults.
    pub rest: Option<Rest>,
    /// Number of steps, at least 1.
    #[key(min = 1)]
    pub steps: Option<u64>,
}

/// When a model rests after it has moved: a muckpile, a slide, a collapse.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Rest {
    /// Kinetic energy as a share of the largest of the run so far, at most.
    #[key(default = "1e-6")]
    pub share: Option<Quantity<ShareBelowOne>>,
    /// Speed of the fastest block, at most, m/s.
    #[key(default = "1 cm/s")]
    pub speed: Option<Quantity<Speed>>,
    /// How long both must hold, s: longer than a block stands still at the top of its flight.
    #[key(default = "0.1 s")]
    pub hold: Option<Quantity<NotNegativeTime>>,
}

/// Damping of the motion of blocks.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Damping {
    /// Force against the velocity, proportional to mass, 1/s.
    #[key(default = "0 1/s")]
    pub mass: Option<Quantity<Rate>>,
    /// The same for turning: moment against the spin, proportional to inertia, 1/s. Default as
    /// `mass`.
    #[key(space = "spatial", instead = "`mass` damps turning too")]
    pub rotation: Option<Quantity<Rate>>,
    /// Proportional to contact stiffness, s.
    #[key(default = "0 s")]
    pub stiffness: Option<Quantity<NotNegativeTime>>,
    /// Share of the unbalanced force taken off, against the motion. For static questions.
    #[key(default = "0")]
    pub local: Option<Quantity<ShareBelowOne>>,
}

/// What a phase can set to zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Words)]
pub enum Reset {
    /// Velocities and spins of all blocks.
    Velocities,
    /// Displacements and rotations of all blocks as outputs report them.
    Displacements,
}
