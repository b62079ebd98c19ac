//! State of the 2D engine: what a checkpoint holds.
//!
//! Leapfrog: velocities and spins belong to half a step before `time`, except before the first
//! step, when they belong to `time` itself (`last_dt` is 0).

use riprap_geom::Vec2;
use serde::{Deserialize, Serialize};

use super::seepage::state::Seepage;
use super::setup::{Motion, Setup};
use crate::accounts::{self, Account, Holder};
use crate::failed::FailedPoints;
use crate::laws::bolt::{Chain, Toll};
use crate::ledger::{Left, Works};

/// Whole state of a planar model.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct World {
    /// The model as built (interfaces and supports as changed by phases since).
    pub setup: Setup,
    /// Model time, s.
    pub time: f64,
    /// Steps done.
    pub step: u64,
    /// Length of the last step, s; 0 before the first.
    pub last_dt: f64,
    /// Time moved since the forces were last evaluated, s.
    pub pending: f64,
    /// Motion of the blocks.
    pub bodies: Vec<Body>,
    /// Positions that displacements are measured from, m.
    pub reference: Vec<Vec2>,
    /// Angles that rotations are measured from, rad.
    pub reference_angle: Vec<f64>,
    /// Removed blocks stay in the list, so that numbers keep their meaning.
    pub alive: Vec<bool>,
    /// Prescribed motion of each block, if any (boxed: few blocks have one).
    pub motion: Vec<Option<Box<Motion>>>,
    /// Gravity now, m/s².
    pub gravity: Vec2,
    /// The water table that stands now, an index into `setup.water`.
    pub water: Option<u16>,
    /// The network of joints through which it seeps; `None` before the first evaluation, and where water stands.
    pub seepage: Option<Box<Seepage>>,
    /// Poses at the last rebuild of the candidate list: the list is a function of these alone.
    pub search_pose: Vec<(Vec2, f64)>,
    /// State of found contacts between convex blocks, in candidate order.
    pub pairs: Vec<PairState>,
    /// State of found contacts where a block is concave or the law works piece by piece.
    pub general: Vec<GeneralState>,
    /// Built patches.
    pub bonds: Vec<Bond>,
    /// Failed points of joints whose blocks were removed.
    pub failed: FailedPoints,
    /// Bolts in the rock.
    pub bolts: Vec<Bolt>,
    /// Running sums of the energy ledger.
    pub works: Works,
    /// Blocks that have left the model.
    pub left: Left,
    /// Work of the conditions in `setup.accounts`.
    pub accounts: Vec<Account>,
    /// Kinetic and stored energy at the start, J/m; set by the first evaluation.
    pub start_energy: Option<f64>,
}

impl World {
    /// Measures displacements and rotations from the present positions on.
    pub fn zero_displacements(&mut self) {
        for (b, body) in self.bodies.iter().enumerate() {
            self.reference[b] = body.position;
            self.reference_angle[b] = body.angle;
        }
    }

    /// Whether the model begins here: no step was done, and its energy is not counted yet.
    pub(crate) fn begins(&self) -> bool {
        self.start_energy.is_none() && self.last_dt == 0.0
    }

    /// Work of the condition on account number `k` since the start, J/m.
    #[must_use]
    pub fn work(&self, k: usize) -> f64 {
        self.accounts.get(k).map_or(f64::NAN, Account::work)
    }

    /// Work of boundary number `k` of the scene since the start, J/m.
    #[must_use]
    pub fn work_of_boundary(&self, k: usize) -> f64 {
        let account = accounts::of(&self.setup.accounts, Holder::Boundary(k as u16));
        account.map_or(f64::NAN, |account| self.work(usize::from(account)))
    }

    /// Present place (local, m) of a point of a block, given from its centroid in the body frame.
    #[must_use]
    pub fn on_body(&self, block: u32, arm: Vec2) -> Vec2 {
        self.bodies[block as usize].place(arm)
    }
}

/// Motion of one block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Centroid, m.
    pub position: Vec2,
    /// Velocity of the centroid, m/s.
    pub velocity: Vec2,
    /// Angle since the start, rad.
    pub angle: f64,
    /// Angular velocity, rad/s.
    pub spin: f64,
}

impl Body {
    /// Present place (local, m) of a point of it, given from its centroid in the body frame.
    #[must_use]
    pub fn place(&self, arm: Vec2) -> Vec2 {
        self.position + self.turned(arm)
    }

    /// A vector of the body frame in the present one.
    #[must_use]
    pub fn turned(&self, v: Vec2) -> Vec2 {
        let (s, c) = libm::sincos(self.angle);
        Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
    }
}

/// Force on the first block of a pair and moments on both about their centroids.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Wrench {
    /// Force on the first block (the second gets the opposite), N/m.
    pub force: Vec2,
    /// Moment on the first block, N.
    pub moment_i: f64,
    /// Moment on the second block, N.
    pub moment_j: f64,
}

impl Wrench {
    /// Force `force` on the first block at `arm_i` from its centroid and `arm_j` from the second's.
    #[must_use]
    pub fn at(force: Vec2, arm_i: Vec2, arm_j: Vec2) -> Self {
        Self { force, moment_i: arm_i.perp_dot(force), moment_j: -arm_j.perp_dot(force) }
    }

    /// Sum of two wrenches.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            force: self.force + other.force,
            moment_i: self.moment_i + other.moment_i,
            moment_j: self.moment_j + other.moment_j,
        }
    }

    /// The wrench times a number.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self {
            force: factor * self.force,
            moment_i: factor * self.moment_i,
            moment_j: factor * self.moment_j,
        }
    }

    /// Power (W/m) for relative velocity `dv` of the centroids (first minus second) and both spins.
    #[must_use]
    pub fn power(&self, dv: Vec2, spin_i: f64, spin_j: f64) -> f64 {
        self.force.dot(dv) + self.moment_i * spin_i + self.moment_j * spin_j
    }
}

/// One found contact region: everything its law remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Elastic shear force on the first block along its tangent, N/m.
    pub shear: f64,
    /// Elastic energy in the shear spring, J/m.
    pub shear_energy: f64,
    /// Length that the shear spring stands for, m: the longest that the contact has been since it slid. Where it grows, unloaded springs are
    /// added, and what the force stores falls (that is friction); where it shrinks, the spring stays what it is, and no energy
    /// comes of it; where it slides, its springs become those of its present length, and friction pays for what they store.
    ///
    /// Deviation: Cundall & Strack's spring (see [`coulomb`](crate::laws::coulomb)) has one stiffness; one that follows the length is usual, with
    /// the force kept. A contact that sticks while it shrinks then makes energy: a brick that tumbled over its corners made 10 % of
    /// all that it had, and 2 % with an eighth of the step. Tried and left: dropping the share of what has opened, as
    /// contacts in space do, or keeping the energy and scaling the force with the root of the length lets a block that rocks
    /// on a slope walk down it below the angle of friction (`a1_incline`), since the pressure at an edge that opens is none and no
    /// shear goes with it; a spring that stays long while it slides is too stiff at a corner (`g3_goodman_bray`: a slope fails
    /// under 1.1 times the anchor force that holds it).
    pub springs: f64,
    /// Elastic normal energy by path, J/m (only for laws without potential).
    pub path_energy: f64,
    /// Normal force beyond the elastic one, taken over from a joint, N/m; fades with slip.
    pub offset: f64,
    /// Slip over which the offset still fades, m.
    pub offset_left: f64,
    /// Elastic normal part at the last evaluation.
    pub normal: Wrench,
    /// Shear part at the last evaluation.
    pub tangential: Wrench,
    /// Damping part at the last evaluation.
    pub damping: Wrench,
    /// Offset part at the last evaluation.
    pub handed: Wrench,
    /// Contact length (chord), m.
    pub length: f64,
    /// Largest depth of a boundary point, m.
    pub depth: f64,
    /// Centre of pressure relative to the first block's centroid, m.
    pub centre: Vec2,
    /// Whether it slid in the last step.
    pub slipping: bool,
}

impl Contact {
    /// Whether the blocks touch in this region.
    #[must_use]
    pub fn touches(&self) -> bool {
        self.normal.force != Vec2::ZERO
    }
}

/// Found contact between two convex blocks: one region at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PairState {
    /// First block; the smaller index.
    pub i: u32,
    /// Second block.
    pub j: u32,
    /// The contact.
    pub contact: Contact,
}

/// Found contacts of a pair with any number of regions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GeneralState {
    /// First block; the smaller index.
    pub i: u32,
    /// Second block.
    pub j: u32,
    /// Regions, in the order of their first piece.
    pub regions: Vec<Region>,
}

/// One region of a general pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Region {
    /// Edges that have a piece in the region, as bits (edge number modulo 32; first block low).
    pub edges: u64,
    /// The contact.
    pub contact: Contact,
}

/// A bolt in the rock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bolt {
    /// Index into `Setup::bolts`.
    pub number: u32,
    /// Bar, grout and plate with all that they remember, per metre of thickness.
    pub chain: Chain,
    /// Where each node of the chain sits in the rock.
    pub pins: Vec<Pin>,
    /// Shear springs where it crosses joints.
    pub dowels: Vec<Dowel>,
    /// Unit direction from the head to the toe when it was installed.
    pub axis: Vec2,
    /// What it has gone through so far, per metre of thickness.
    pub toll: Toll,
}

/// A point of the rock that a bolt holds on to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pin {
    /// The block.
    pub block: u32,
    /// From its centroid, body frame, m.
    pub arm: Vec2,
    /// Distance from the head, m.
    pub along: f64,
    /// Place when the bolt was installed, local, m.
    pub place: Vec2,
}

/// A bolt as a dowel between the two sides of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dowel {
    /// The bar that crosses the joint.
    pub bar: u32,
    /// The same point on both sides.
    pub sides: [Pin; 2],
    /// What has slipped, m, across the axis.
    pub slip: Vec2,
    /// Force on the side behind, N/m.
    pub force: Vec2,
}

/// A joint between two blocks along one shared edge.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Bond {
    /// First block; the smaller index.
    pub i: u32,
    /// Second block.
    pub j: u32,
    /// Row of the interface table.
    pub row: u16,
    /// Normal from i to j in the initial frame.
    pub normal: Vec2,
    /// Length of the shared edge, m.
    pub length: f64,
    /// Effective mass of the pair, kg/m.
    pub mass: f64,
    /// The points.
    pub points: Vec<BondPoint>,
    /// Whether it still acts; a joint that has slid or opened hands over to found contact.
    pub active: bool,
    /// Whether a point has failed and slid or opened too far for the others to hold.
    pub torn: bool,
    /// Elastic and frictional part at the last evaluation.
    pub stress: Wrench,
    /// Damping part at the last evaluation.
    pub damping: Wrench,
    /// Stored elastic energy, J/m.
    pub energy: f64,
    /// Step at which its last point failed.
    pub broken_at: Option<u64>,
}

/// What a point remembers that softens, is rough or dilates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Wear {
    /// Accumulated slip, m.
    pub accumulated_slip: f64,
    /// Largest opening beyond the elastic one while it softened, m.
    pub parted: f64,
    /// How far the roughness of its sides has parted them, m.
    pub dilated: f64,
    /// How far it is open beyond that at the last evaluation, m; negative where it is closed.
    pub gap: f64,
    /// Whether it is open.
    pub open: bool,
}

/// A point of a joint.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BondPoint {
    /// Place on the first block, body frame, m.
    pub on_i: Vec2,
    /// Place on the second block, body frame, m.
    pub on_j: Vec2,
    /// Length it stands for, m.
    pub weight: f64,
    /// Plastic shear displacement, m.
    pub slip: f64,
    /// What it remembers beyond that; nothing where its law is plain.
    pub wear: Wear,
    /// Opening at the last evaluation, m.
    pub opening: f64,
    /// Normal stress, Pa, tension positive.
    pub sigma: f64,
    /// Shear stress, Pa.
    pub tau: f64,
    /// Whether it has failed.
    pub failed: bool,
}
