//! What the evaluation of found contacts works with; can be dropped and laid out anew without changing a result.

use std::cmp::Ordering;

use riprap_core::sets::Sets;
use riprap_core::sums::GROUP;
use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use crate::broad::covered::{Cover, Covered};
use crate::broad::search::Candidates;
use crate::kernel::friction::{ContactLaw, Wrench};
use crate::kernel::glued::{Glued, Gluer};
use crate::kernel::grid::Role;
use crate::kernel::ridges::Ridges;
use crate::kernel::shape::{Pose, Shape};
use crate::kernel::surface::Walker;
use crate::kernel::terrain::{Terrain, Under};
use crate::state::found::ContactPatch;

/// Workspace for all found contacts of a model.
#[derive(Debug, Default)]
pub struct ContactScratch {
    /// Whether the candidate list is that of the state.
    pub ready: bool,
    /// Shapes, one for each mass class.
    pub shapes: Vec<Shape>,
    /// Blocks of glued parts by their terms, and all others as one term each, one for each mass class; empty where no block has parts.
    pub glued: Vec<Glued>,
    /// Faces of held blocks that other held blocks cover.
    pub covered: Covered,
    /// In implicit phases: what may cover faces until the next search.
    pub seats: Seats,
    /// Pairs that can touch.
    pub candidates: Candidates,
    /// What is the same in all steps, per pair.
    pub constants: Vec<Constants>,
    /// What of the law is the same for all pairs of an interface, by its place in the setup.
    pub rows: Vec<ContactLaw>,
    /// Faces that can come flat onto each other, of the pairs that have such.
    pub facings: Vec<FacePair>,
    /// 1 over the mass of each block of the model, 1/kg; 0 for what no contact can move.
    pub inverse_masses: Vec<f64>,
    /// Blocks that are in a pair, ascending.
    pub blocks: Vec<u32>,
    /// Place of a block in `blocks`, per block; `u32::MAX` for others.
    pub place: Vec<u32>,
    /// Where the normals of each of `blocks` begin; one entry more.
    pub first_normal: Vec<u32>,
    /// Normals of all faces of `blocks`, turned into space.
    pub normals: Vec<Vec3>,
    /// Rotation of each of `blocks` as a matrix.
    pub turns: Vec<Mat3>,
    /// Pose of each of `blocks`.
    pub poses: Vec<Pose>,
    /// How each pair touches.
    pub slots: Vec<Slot>,
    /// What the pairs exert, by groups of [`GROUP`] of them.
    pub groups: Vec<PairGroup>,
    /// Workspace: the impacts of an instant.
    pub impacts: Vec<Impact>,
    /// Bound of the speed of the points of each of `blocks` against its centroid, m/s.
    pub turning: Vec<f64>,
    /// Whether all of them together are negligible.
    pub all_negligible: bool,
    /// Pairs (place in the list, and whether the block is the second) of each of `blocks`.
    pub incidence: Vec<(u32, bool)>,
    /// Where the pairs of each of `blocks` begin; one entry more.
    pub first_pair: Vec<u32>,
    /// What their pairs do to each of `blocks`.
    pub acting: Vec<Acting>,
    /// Where steps have levels: how the instant differs from the kick for each of `blocks`.
    pub between: Vec<Between>,
    /// Workspace of steps by level: step that each of `blocks` allows, s; infinite where it is not known since it is long.
    pub limits: Vec<f64>,
    /// Workspace of each piece of the pairs.
    pub workspaces: Vec<Workspace>,
    /// Workspace: sums over groups of pairs.
    pub sums: Vec<PairSums>,
    /// Whether any contact has dashpots.
    pub damped: bool,
    /// The contact that is deepest for its blocks; `None` where none touch.
    pub deepest: Option<Deepest>,
    /// What is terrain.
    pub terrain: Grounds,
    /// Workspace of the looks at who can meet whom.
    pub who: RoleScratch,
}

/// What may cover faces until the next search.
#[derive(Debug, Default)]
pub struct Seats {
    /// Joints in place, and what each covers.
    pub joints: Vec<(u32, Cover)>,
    /// Faces of candidates that can come to lie flush on each other.
    pub contacts: Vec<Seat>,
}

/// Two faces that can come to lie flush on each other.
#[derive(Clone, Copy, Debug)]
pub struct Seat {
    /// Place of the pair among the candidates.
    pub pair: u32,
    /// A face of each block.
    pub faces: [u16; 2],
}

/// Workspace for a look at who can meet whom; kept, so that a look takes no memory.
#[derive(Debug, Default)]
pub struct RoleScratch {
    /// What was found, per block.
    pub roles: Vec<Role>,
    /// Whether all joints of a block are whole.
    pub whole: Vec<bool>,
    /// The same at the look before.
    pub were_whole: Vec<bool>,
    /// Blocks that patches join.
    pub joined: Sets,
}

/// What a block is pressed into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Pressed {
    /// A block that it was found to touch.
    Contact,
    /// Blocks that overlap while no surface was found on which they could press each other: no force can be given.
    NoSurface,
    /// A block that a joint ties it to.
    Joint,
    /// The half block behind a face with this condition.
    Condition(u16),
}

/// How deep two blocks lie in each other.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deepest {
    /// The blocks; twice the same one that is pressed into what a condition has put behind its face.
    pub ends: [u32; 2],
    /// What is pressed.
    pub pressed: Pressed,
    /// Depth, m.
    pub depth: f64,
    /// How deep it may be at most: the radius of the largest ball in the thinner block, m.
    pub reach: f64,
    /// Depth over that; what is not a number counts as infinite.
    pub ratio: f64,
}

impl ContactScratch {
    /// Radius of the largest ball in a block of a mass class, m: of glued parts in the thinnest piece.
    #[must_use]
    pub fn inradius(&self, class: u32) -> f64 {
        let class = class as usize;
        let glued = self.glued.get(class);
        glued.map_or(self.shapes[class].inradius, |glued| glued.inradius)
    }

    /// What contacts do to block `b`, nil where none is near; `None` where nothing is looked for.
    pub(crate) fn on_block(&self, b: usize) -> Option<Acting> {
        let place = self.place.get(b)?;
        Some(self.acting.get(*place as usize).copied().unwrap_or_default())
    }

    /// How block `b` stands between evaluations of its pairs; `None` where all pairs are evaluated at each step.
    pub(crate) fn between(&self, b: usize) -> Option<&Between> {
        let place = self.place.get(b)?;
        self.between.get(*place as usize)
    }

    /// What pair `k` exerts, if it does.
    #[must_use]
    pub fn exerted(&self, k: usize) -> Option<&Exerted> {
        exerted(&self.groups, &self.slots[k], k)
    }
}

/// What pair `k` with this slot exerts, if it does.
#[must_use]
pub(crate) fn exerted<'a>(groups: &'a [PairGroup], slot: &Slot, k: usize) -> Option<&'a Exerted> {
    Some(&groups[k / GROUP].exerted[usize::from(slot.at?)])
}

impl Deepest {
    /// Of two blocks that lie so deep (m) in each other, the largest ball in the thinner one having this radius (m).
    #[must_use]
    pub fn new(ends: [u32; 2], pressed: Pressed, depth: f64, reach: f64) -> Self {
        let ratio = depth / reach;
        Self {
            ends,
            pressed,
            depth,
            reach,
            // What is not a number must not pass for shallow.
            ratio: if ratio.is_nan() { f64::INFINITY } else { ratio },
        }
    }

    /// The deeper of two, the first where they are equal. One without a force is above all others, whatever its depth.
    #[must_use]
    pub fn deeper(a: Option<Self>, b: Option<Self>) -> Option<Self> {
        match (a, b) {
            (Some(x), Some(y)) => {
                let rank = |d: &Self| (d.pressed == Pressed::NoSurface, d.ratio);
                Some(if rank(&y) > rank(&x) { y } else { x })
            }
            (a, b) => a.or(b),
        }
    }
}

/// Terrain of a model, ready for contact.
#[derive(Debug, Default)]
pub struct Grounds {
    /// Blocks that are terrain, ascending.
    pub blocks: Vec<u32>,
    /// Their surfaces.
    pub grounds: Vec<Terrain>,
}

/// What the bodies of a pair are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairKind {
    /// Two convex blocks.
    Convex,
    /// Two blocks of which one at least is made of glued parts.
    Glued,
    /// Terrain (its place among all) and a block.
    Terrain(u16),
}

/// What is the same in all steps for a pair. There are many pairs that do not touch: what can be looked up does not stand here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Normal and shear stiffness, Pa/m.
    pub stiffness: [f64; 2],
    /// Smaller inradius, m.
    pub inradius: f64,
    /// Smaller one of the largest listed faces of both, m².
    pub largest: f64,
    /// Place in [`ContactScratch::facings`]; [`Constants::NO_FACING`] for none.
    pub facing: u32,
    /// The interface, a place in [`ContactScratch::rows`].
    pub row: u16,
    /// What the two are.
    pub kind: PairKind,
}

impl Constants {
    /// No faces can come flat onto each other.
    pub const NO_FACING: u32 = u32::MAX;

    /// The law.
    #[must_use]
    pub fn law(&self, rows: &[ContactLaw]) -> ContactLaw {
        let row = rows[usize::from(self.row)].with_stiffness(self.stiffness);
        ContactLaw { growth: row.growth / (self.inradius * self.inradius), ..row }
    }

    /// Faces that can come flat onto each other.
    #[must_use]
    pub fn facing<'a>(&self, facings: &'a [FacePair]) -> Option<&'a FacePair> {
        facings.get(self.facing as usize)
    }
}

/// Two faces that can come flat onto each other, and the smaller one of them in the frame of its block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePair {
    /// Largest area that they can share, m².
    pub area: f64,
    /// Whether the smaller one is of the first or of the second block.
    pub side: usize,
    /// Unit outward normal.
    pub normal: Vec3,
    /// Its centroid, m.
    pub centre: Vec3,
    /// Its area, m².
    pub face: f64,
    /// Its polar second moment about the centroid over its area, m².
    pub polar: f64,
    /// Square of the distance of its farthest corner from its centroid, m².
    pub corner: f64,
    /// Bound of the squared frequency of the slower of both blocks on this face, 1/s²; 0 where nothing holds them.
    pub square: f64,
}

/// What a pair exerts that touches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Exerted {
    /// Pressure, and what goes on of a joint's load.
    pub elastic: Wrench,
    /// Springs along the contact.
    pub spring: Wrench,
    /// Dashpots.
    pub drag: Wrench,
}

impl Exerted {
    /// Adds what another patch exerts.
    pub fn add(&mut self, other: &Self) {
        self.elastic = self.elastic.plus(&other.elastic);
        self.spring = self.spring.plus(&other.spring);
        self.drag = self.drag.plus(&other.drag);
    }
}

/// What the pairs of a group of [`GROUP`] exert, in their order: of those that touch only, which are few among all.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct PairGroup {
    /// By [`Slot::at`].
    pub exerted: Vec<Exerted>,
    /// Their impacts.
    pub impacts: Vec<Impact>,
    /// Sums over the group.
    pub sums: PairSums,
}

impl PairGroup {
    /// Empties it.
    pub fn begin(&mut self) {
        self.exerted.clear();
        self.impacts.clear();
        self.sums = PairSums::default();
    }

    /// Adds an impact.
    pub fn note(&mut self, impact: Impact) {
        self.sums.impacts += impact.energy;
        self.impacts.push(impact);
    }

    /// Adds what a pair exerts; its place.
    pub fn push(&mut self, exerted: Exerted) -> Option<u8> {
        if self.exerted.len() == self.exerted.capacity() {
            // Little at a time: doubling would leave half of it empty.
            self.exerted.reserve_exact(GROUP / 8);
        }
        self.exerted.push(exerted);
        Some((self.exerted.len() - 1) as u8)
    }
}

/// How a pair touches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slot {
    /// Place of what it exerts in its group; `None` where it exerts nothing.
    pub at: Option<u8>,
    /// Whether they touch.
    pub touching: bool,
    /// Area across the normal, m².
    pub area: f64,
    /// Bound of the speed at which points of the two blocks come nearer to each other, m/s.
    pub nearing: f64,
    /// Whether the energy of its impact is so small that a step need not resolve it, where not that of all is.
    pub negligible_impact: bool,
    /// What its forces are multiplied by in the coming kick: 1 but where steps have levels.
    pub weight: f64,
    /// Time that its forces have still to be given at this instant, s; below 0 where they have been given in advance.
    pub late: f64,
    /// Steps until it is evaluated again.
    pub every: u32,
}

impl Default for Slot {
    fn default() -> Self {
        Self {
            at: None,
            touching: false,
            area: 0.0,
            nearing: 0.0,
            negligible_impact: false,
            weight: 1.0,
            late: 0.0,
            every: 1,
        }
    }
}

/// An impact that is going on, or will within a step. In order of stiffness, the first of equal pairs above the others.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Impact {
    /// Squared frequency of the contact, 1/s².
    pub square: f64,
    /// Its energy, J.
    pub energy: f64,
    /// The pair.
    pub pair: u32,
}

impl Ord for Impact {
    fn cmp(&self, other: &Self) -> Ordering {
        let softer = self.square.total_cmp(&other.square);
        softer.then(other.pair.cmp(&self.pair))
    }
}

impl PartialOrd for Impact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Impact {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Impact {}

/// Force (N) and moment about the centroid (N m).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// N.
    pub force: Vec3,
    /// N m.
    pub moment: Vec3,
}

impl Share {
    /// Adds another share.
    pub fn plus(&mut self, other: &Self) {
        self.force += other.force;
        self.moment += other.moment;
    }

    /// Adds what a contact does to its first or second block.
    pub fn add(&mut self, wrench: &Wrench, second: bool) {
        if second {
            self.force += wrench.force;
            self.moment += wrench.moment_b;
        } else {
            self.force -= wrench.force;
            self.moment += wrench.moment_a;
        }
    }
}

/// What all found contacts of a block do to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Acting {
    /// Pressure.
    pub elastic: Share,
    /// Springs along the contacts.
    pub spring: Share,
    /// Dashpots.
    pub drag: Share,
}

/// How a block stands at an instant at which not all of its pairs are evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Between {
    /// Force and moment of its pairs without dashpots, less those of the coming kick.
    pub lag: Share,
    /// Impulse (N s, N m s) that its pairs have still to give until this instant.
    pub late: Share,
}

/// Workspace of a piece of the pairs.
#[derive(Debug, Default)]
pub struct Workspace {
    /// Walks over surfaces.
    pub walker: Walker,
    /// For blocks of glued parts.
    pub gluer: Gluer,
    /// For terrain.
    pub under: Under,
    /// Normals of a block on terrain, turned into space.
    pub normals: Vec<Vec3>,
    /// Dashpots of ridges under a block.
    pub ridges: Ridges,
    /// Patches of the pair at the last evaluation that have not been found again yet.
    pub old: Vec<ContactPatch>,
    /// Blocks that are beside all terrain.
    pub beside: Vec<u32>,
}

/// Sums over a group of pairs in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PairSums {
    /// Heat of friction, J.
    pub friction: f64,
    /// What contacts store beyond what their forces have taken up ([`crate::kernel::friction::ContactOutput::booked`]), J.
    pub booked: f64,
    /// Energy of the normal springs of joints from which they have just taken over, J.
    pub left: f64,
    /// Edges of surfaces that no listed plane has made: none, or the lists are wrong.
    pub unlabelled: u32,
    /// Energy of impacts, J.
    pub impacts: f64,
    /// The deepest contact.
    pub deepest: Option<Deepest>,
}

impl PairSums {
    /// Adds those of the groups behind.
    pub fn add(&mut self, other: &Self) {
        self.friction += other.friction;
        self.booked += other.booked;
        self.left += other.left;
        self.unlabelled += other.unlabelled;
        self.impacts += other.impacts;
        self.deepest = Deepest::deeper(self.deepest, other.deepest);
    }
}
