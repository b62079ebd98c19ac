//! The plan of a run: phases, what to record, when to stop. SI numbers, no behaviour.

mod check;
pub mod shown;

use serde::{Deserialize, Serialize};

pub use check::{Check, Expected, Part, Reduce, Window};

use crate::Vec3;
pub use crate::dynamics::damping::Damping;
pub use crate::dynamics::relaxation::{Breaks, Integration, PhaseKind, Relaxation};
use crate::planar::setup::ContactLaw;
use crate::record::frame::Content;
pub use crate::rhythm::Every;
use crate::spatial::setup::JointLaw;
pub use crate::spatial::setup::deform::CutRules as Cutting;

/// Share of the stable time step that is used where nobody says anything: the one of the plane, whose stable step is a bound.
pub const SAFETY: f64 = 0.2;

/// The same in space. Contacts that are found there have limits of their own, which go with a smaller share.
pub const SAFETY_IN_SPACE: f64 = 0.5;

/// Everything the loop needs besides the model itself.
///
/// # Examples
///
/// ```
/// use riprap::plan::{Every, Phase, Plan};
///
/// let plan = Plan {
///     title: "settle, then shake".to_owned(),
///     phases: vec![Phase::settle("settle", 1e-5), Phase::dynamic("shake", 2.0)],
///     frames: Some(Every::Time(0.1)),
///     ..Plan::default()
/// };
/// assert_eq!(plan.phases[0].until.unbalanced, Some(1e-5));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// Title of the scenario.
    pub title: String,
    /// Phases in order.
    pub phases: Vec<Phase>,
    /// Histories to record.
    pub histories: Vec<History>,
    /// When frames are written besides the first and the last of each phase; [`Every::Never`] writes none at all.
    pub frames: Option<Every>,
    /// What frames hold.
    pub pictures: Content,
    /// When checkpoints are written besides the end of each phase.
    pub checkpoints: Option<Every>,
    /// When a line of `energy.csv` is written; `None` follows the frames.
    pub energy: Option<Every>,
    /// Servos, applied after every step in their order.
    pub controls: Vec<Control>,
}

/// A servo: a load or a motion of rigid blocks that keeps a field at a value.
///
/// With `c = (target - value)/(band target)`, at least -1 and at most 1, a support moves with `c` times its velocity, and the factor of a load grows by
/// `c dt/rise` but never below 0. Read from the forces of a step, it acts from the next one on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Control {
    /// Name of the load or support.
    pub name: String,
    /// What is kept.
    pub gauge: Gauge,
    /// At this value, SI; not zero.
    pub target: f64,
    /// Share of the target to either side of it within which the servo acts in proportion.
    pub band: f64,
    /// What acts.
    pub acts: Acts,
}

/// What a servo changes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Acts {
    /// The factor of a load, from nothing to 1 in `rise` (s).
    Load {
        /// s.
        rise: f64,
    },
    /// The velocity of a support, at most this, m/s.
    Velocity([f64; 3]),
}

/// One stretch of a run with its own rules.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Phase {
    /// Name, unique.
    pub name: String,
    /// Static (settles) or dynamic (true time).
    pub kind: PhaseKind,
    /// What ends it; whichever comes first.
    pub until: Until,
    /// How it steps through time.
    pub integration: Integration,
    /// Time step rule.
    pub time_step: TimeStep,
    /// Largest difference of an implicit step from two of half its length, m.
    pub step_error: Option<f64>,
    /// Found contacts are evaluated once in up to 2 to this power explicit steps; 0: at each one.
    pub levels: u8,
    /// Damping besides that of the contacts.
    pub damping: Damping,
    /// Blocks taken out at the start of the phase.
    pub remove: Vec<u32>,
    /// Time over which the forces that these gave to others fade, s; at once where it is not given.
    pub removal_ramp: Option<f64>,
    /// Where free rigid blocks leave the model in the course of it.
    pub leavers: Option<Leavers>,
    /// Blocks fixed at the start of the phase.
    pub fix: Vec<u32>,
    /// Blocks whose supports are taken away at the start of the phase.
    pub release: Vec<u32>,
    /// Bolts installed at the start of the phase, after blocks are taken out.
    pub install: Vec<u32>,
    /// New gravity, m/s².
    /// In the plane the third component is 0.
    pub gravity: Option<[f64; 3]>,
    /// Time over which gravity grows from its value before (zero in the first phase), s.
    pub gravity_ramp: Option<f64>,
    /// Water table that stands from the start of the phase on, an index into those of the setup, or none.
    pub water: Option<Option<u16>>,
    /// Rows of the interface table of the planar engine replaced at the start of the phase.
    pub contacts: Vec<(u16, ContactLaw)>,
    /// Rows of the interface table of the spatial engine replaced at the start of the phase.
    pub joints: Vec<(u16, JointLaw)>,
    /// Strengths divided at the start of the phase.
    pub reduction: Option<Reduction>,
    /// Sets all velocities to zero at the start.
    pub zero_velocities: bool,
    /// Measures displacements from the start of this phase on.
    pub zero_displacements: bool,
    /// Rules for deformable blocks; `None` where there are none.
    pub deform: Option<Deforming>,
    /// Energy residual over the largest energy exchanged at which the run is stopped.
    pub max_residual: f64,
}

/// Where the model ends for blocks that fly or fall out of it: at either of the two. Local coordinates, in the plane without z.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Leavers {
    /// Lowest and highest corner of a box that a block leaves, m.
    pub outside: Option<[Vec3; 2]>,
    /// A point of a plane (m), and its normal to the side that a block leaves to.
    pub beyond: Option<[Vec3; 2]>,
}

impl Leavers {
    /// Whether a block with its centroid at a place (m) leaves.
    #[must_use]
    pub fn take(&self, place: Vec3) -> bool {
        self.outside.is_some_and(|[min, max]| !(place.cmpge(min).all() && place.cmple(max).all()))
            || self.beyond.is_some_and(|[at, normal]| (place - at).dot(normal) > 0.0)
    }
}

/// Rules of a phase for deformable blocks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deforming {
    /// Whether bonds may break.
    pub breaking: bool,
    /// Measure of strain from this phase on; `None` leaves it as it is.
    pub strain: Option<crate::laws::tetrahedron::Strain>,
    /// How a static phase relaxes; `None` in dynamic phases, and where a rigid block is free.
    pub relax: Option<Relaxing>,
    /// How blocks are cut; `None` where none is.
    pub cut: Option<Cutting>,
}

/// A static phase of deformable blocks: dynamic relaxation with fictitious masses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Relaxing {
    /// Ratio of net to external forces at which it is converged.
    pub tolerance: f64,
    /// Load steps over `until.time`.
    pub load_steps: u64,
    /// Iterations after which a load step that has not converged ends the phase.
    pub iterations: u64,
    /// How it relaxes.
    pub relaxation: Relaxation,
}

/// Share of the unbalanced force that local damping takes in static phases, unless one is given.
const STATIC_DAMPING: f64 = 0.7;

impl Phase {
    /// Damping in its steps, `implicit` or explicit; static phases of explicit steps have local damping unless another is given.
    #[must_use]
    pub fn damping_in(&self, implicit: bool) -> Damping {
        let given = self.damping.local != 0.0 || self.damping.mass != 0.0;
        if implicit || given || self.kind != PhaseKind::Static {
            return self.damping;
        }
        Damping { local: STATIC_DAMPING, ..self.damping }
    }

    /// A phase of true dynamics that lasts `time` (s), with the automatic time step and nothing changed at its start.
    #[must_use]
    pub fn dynamic(name: &str, time: f64) -> Self {
        Self {
            name: name.to_owned(),
            kind: PhaseKind::Dynamic,
            until: Until { time: Some(time), ..Until::default() },
            integration: Integration::Explicit,
            time_step: TimeStep::Auto { safety: SAFETY },
            step_error: None,
            levels: 0,
            damping: Damping::default(),
            remove: Vec::new(),
            removal_ramp: None,
            leavers: None,
            fix: Vec::new(),
            release: Vec::new(),
            install: Vec::new(),
            gravity: None,
            gravity_ramp: None,
            water: None,
            contacts: Vec::new(),
            joints: Vec::new(),
            reduction: None,
            zero_velocities: false,
            zero_displacements: false,
            deform: None,
            max_residual: 0.1,
        }
    }

    /// As [`Phase::dynamic`], to be left once it has settled: a phase of dynamic relaxation that ends at the ratio
    /// `unbalanced` of unbalanced forces.
    #[must_use]
    pub fn settle(name: &str, unbalanced: f64) -> Self {
        Self {
            kind: PhaseKind::Static,
            until: Until { unbalanced: Some(unbalanced), ..Until::default() },
            ..Self::dynamic(name, 0.0)
        }
    }

    /// Whether blocks, supports or laws change when it begins.
    #[must_use]
    pub fn edits(&self) -> bool {
        self.edits_forces() || self.zero_velocities || self.deform.is_some()
    }

    /// Whether what it changes in blocks, supports or laws at its beginning makes forces jump.
    #[must_use]
    pub fn edits_forces(&self) -> bool {
        !self.remove.is_empty()
            || !self.fix.is_empty()
            || !self.release.is_empty()
            || !self.install.is_empty()
            || self.water.is_some()
            || !self.contacts.is_empty()
            || !self.joints.is_empty()
            || self.reduction.is_some()
    }
}

/// Division of the strengths of interfaces: cohesion, tension and the tangent of the friction angle, before and after failure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reduction {
    /// What they are divided by.
    pub factor: f64,
    /// Rows of the interface table.
    pub rows: Vec<u16>,
}

/// Stop criteria of a phase.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Until {
    /// Duration of the phase, s.
    pub time: Option<f64>,
    /// Unbalanced-force ratio at or below which it ends.
    pub unbalanced: Option<f64>,
    /// Kinetic energy at or below which it ends (after at least 10 steps), J/m.
    pub kinetic: Option<f64>,
    /// The model rests after it has moved.
    pub rest: Option<Rest>,
    /// Number of steps.
    pub steps: Option<u64>,
}

/// When a model rests after it has moved.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rest {
    /// Kinetic energy over the largest so far, at most.
    pub share: f64,
    /// Speed of the fastest block, at most, m/s.
    pub speed: f64,
    /// How long both must hold, s.
    pub hold: f64,
}

/// Time step rule.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum TimeStep {
    /// `safety` times the stable step, found at the start of the phase and whenever the contacts change.
    Auto {
        /// Share of the stable step, 0 to 1.
        safety: f64,
    },
    /// Given, s.
    Given {
        /// Time step, s.
        dt: f64,
    },
}

/// Length of an implicit step where none is given, s.
pub const IMPLICIT_STEP: f64 = 1e-3;

/// Longest step of a static implicit phase where none is given, s. Masses stand against the motion in a step as much as over its square, so that a long
/// one goes to equilibrium at once.
pub const STATIC_STEP: f64 = 1.0;

/// Steps that a phase, and the ramp of its gravity, are given at least where nothing bounds the step.
const FEWEST_STEPS: f64 = 100.0;

impl TimeStep {
    /// The step that this rule asks for in a phase where `stable` is the longest stable one now, s. Where nothing bounds it, blocks are apart: what
    /// gravity, loads and motions become in the course of the phase must not be stepped over.
    #[must_use]
    pub fn wanted(self, stable: f64, until: &Until, gravity_ramp: Option<f64>) -> f64 {
        match self {
            Self::Given { dt } => dt,
            Self::Auto { safety } if stable.is_finite() => safety * stable,
            Self::Auto { .. } => {
                let spans = [until.time, gravity_ramp.filter(|span| *span > 0.0)];
                spans.into_iter().flatten().fold(f64::INFINITY, f64::min) / FEWEST_STEPS
            }
        }
    }

    /// What this rule leaves of the longest step of contacts that are found in space: less where it asks for less than the usual share
    /// of the stable step.
    #[must_use]
    pub fn of_contacts(self) -> f64 {
        match self {
            Self::Auto { safety } => (safety / SAFETY_IN_SPACE).min(1.0),
            Self::Given { .. } => 1.0,
        }
    }
}

/// One number that can be read from a model.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Gauge {
    /// Field with its component, e.g. `block.displacement.x`.
    pub field: String,
    /// Where it is read: one block for block fields, two for pair fields, any number for group fields, one
    /// source for cavity fields.
    pub of: Vec<u32>,
    /// Groups among these names: blocks that join them while the model runs are read too.
    pub groups: Vec<String>,
    /// Point instead of a block, in local coordinates, m: the living block whose reference volume holds it.
    pub at: Option<[f64; 3]>,
    /// Unit direction onto which a vector field is projected.
    pub along: Option<[f64; 3]>,
    /// What it is relative to.
    pub against: Option<Against>,
    /// Two points instead of two blocks.
    pub pins: Option<[Pin; 2]>,
}

/// A point that moves with a block.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pin {
    /// The block.
    pub block: u32,
    /// Where it is at the start, local coordinates, m; in the plane z is 0.
    pub at: [f64; 3],
}

impl Pin {
    /// Fields that are read between two pins.
    pub const FIELDS: [&str; 3] = ["pair.convergence", "pair.displacement", "pair.velocity"];
}

/// Blocks whose mean is taken off a displacement or a velocity.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Against {
    /// Blocks, ascending.
    pub of: Vec<u32>,
    /// Groups among their names.
    pub groups: Vec<String>,
}

impl Against {
    /// The field of the mean that is taken off a field of blocks or groups, both without component; `None` where there is none.
    #[must_use]
    pub fn counterpart(field: &str) -> Option<&'static str> {
        match field {
            "block.displacement" | "block.node_displacement" | "group.displacement" => {
                Some("group.displacement")
            }
            "block.velocity" | "block.node_velocity" | "group.velocity" => Some("group.velocity"),
            _ => None,
        }
    }
}

/// One recorded history.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Column name.
    pub name: String,
    /// What is read.
    pub gauge: Gauge,
    /// Sampling.
    pub every: Every,
}
