//! Everything of a spatial model that can be dropped and laid out anew without changing a result.

use std::ops::Range;
use std::sync::OnceLock;

use riprap_geom::Vec3;

use crate::accounts::{Account, Entries};
use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::flow::Desk;
use crate::implicit::pair::Pair;
use crate::implicit::solve::Solver;
use crate::kernel::cells::TetContactScratch;
use crate::lanes::Width;
use crate::laws::bolt::BoltScratch;
use crate::ledger::Works;
use crate::profile::Profile;
use crate::state::contact_scratch::{ContactScratch, Slot};
use crate::state::push::{Pushes, Wrench};
use crate::state::share::Share;
use crate::state::sums::Sums;
use crate::state::tiles::{Cut, Tiles};
use crate::state::wide::Wide;
use crate::state::workspace::Workspace;
use crate::state::world::World;

/// What a step works with.
#[derive(Debug)]
pub struct Scratch {
    /// Thread pool.
    pub exec: Exec,
    /// Stage timers.
    pub profile: Profile,
    /// Pieces of the model.
    pub tiles: Tiles,
    /// What of the model this rank computes, where there are others.
    pub(crate) share: Option<Share>,
    /// Whether nobody reads the state of the coming evaluation and of the step after it: ranks may keep to themselves then.
    pub unread: bool,
    /// Sums of forces and moments on blocks, without damping and supports.
    pub net: Sums,
    /// Sums of contact dashpots; empty without any.
    pub drag: Sums,
    /// What pushes blocks and nodes from outside.
    pub pushes: Pushes,
    /// Room for the flow of gas in cracks.
    pub flow: Desk,
    /// Length of the step that the kick was found for, s.
    pub coming_dt: f64,
    /// Damping that the kick was found with.
    pub damping: Damping,
    /// Number of times the patches were laid out; whoever keeps something derived from them looks here.
    pub rebuilds: u64,
    /// Of deformable blocks, where there are any.
    pub deform: Option<Box<Workspace>>,
    /// Of the contacts of implicit phases.
    pub(crate) implicit: ImplicitDesk,
    /// Of found contacts.
    pub desk: ContactScratch,
    /// Of found contacts of deformable blocks.
    pub deformable: TetContactScratch,
    /// Radius of the largest ball in a block of each mass class, m, where somebody has asked for it.
    pub inradii: Vec<OnceLock<f64>>,
    /// Of bolts.
    pub(crate) bolts: Vec<BoltScratch>,
    pub(crate) slots: [Sums; 2],
    pub(crate) wide: Vec<Wide>,
    pub(crate) strong: bool,
    pub(crate) width: Width,
    /// Works of the half step after the present time, booked by `advance`.
    pub(crate) departure: Works,
    /// Works of single conditions.
    pub(crate) entries: Entries,
    /// What the conditions on free faces have done in the kick; empty where nobody keeps accounts.
    pub(crate) face_entries: Vec<FaceEntry>,
    /// How the work is cut where that is prescribed.
    pub(crate) cut: Option<Cut>,
    pub(crate) lost: Vec<Lost>,
    pub(crate) partial: Vec<Partial>,
    /// Whether a block has turned beyond the bound of small kinematics.
    pub(crate) turning: bool,
}

/// What the contacts of an implicit step work with.
#[derive(Debug, Default)]
pub(crate) struct ImplicitDesk {
    pub(crate) solver: Solver,
    /// What was found of each pair of found contact.
    pub(crate) found: Vec<NearPair>,
    /// Places in the list of found contacts of the pairs of the solver.
    pub(crate) pairs: Vec<u32>,
    /// Patches of the pairs of the solver behind those.
    pub(crate) joints: Vec<u32>,
    /// Faces of the pairs of the solver behind those.
    pub(crate) faces: Vec<HeldFace>,
    /// Which blocks of the solver joints tie.
    pub(crate) tied: Vec<bool>,
    /// Places in the list of found contacts of blocks that lie in each other without a surface on which they could press each other.
    pub(crate) lost: Vec<u32>,
    /// The blocks of the solver.
    pub(crate) blocks: Vec<u32>,
    /// Place of each block of the model among these.
    pub(crate) place: Vec<Option<u32>>,
    /// Velocity and spin of each block of a pair after the kick of all other forces.
    pub(crate) given: Vec<[Vec3; 2]>,
    /// Energy in the pressure, and in the springs along the contacts, J.
    pub(crate) stored: [f64; 2],
    /// Whether the limits of friction of the last step had not come to rest when its solution was taken.
    pub(crate) unsettled: bool,
    /// That the last step was not solved.
    pub(crate) failed: Option<NotSolved>,
}

/// A face that springs or dashpots hold in an implicit step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct HeldFace {
    /// Its number.
    pub(crate) face: u32,
    /// What the far ends of its springs have done since the last instant.
    pub(crate) booked: Account,
    /// Power that dashpots without springs will take, W.
    pub(crate) taken: f64,
}

/// What was found of a pair of blocks for an implicit step.
#[derive(Debug, Default)]
pub(crate) struct NearPair {
    pub(crate) slot: Slot,
    /// Patches on which they may press within the step.
    pub(crate) near: usize,
    /// Those first; what stands behind is memory that others will use.
    pub(crate) patches: Vec<Pair>,
    /// Whether no surface was found between blocks that lie in each other.
    pub(crate) lost: bool,
}

impl ImplicitDesk {
    /// Empties the lists, for a model of so many blocks and `pairs` of them that can touch.
    pub(crate) fn begin(&mut self, blocks: usize, pairs: usize) {
        self.found.resize_with(pairs, NearPair::default);
        // Pairs of the step before give their memory back.
        for (k, pair) in self.pairs.drain(..).zip(self.solver.pairs.drain(..)) {
            let free = self.found.get_mut(k as usize).filter(|found| found.near > 0);
            if let Some(found) = free {
                found.near -= 1;
                found.patches[found.near] = pair;
            }
        }
        self.solver.begin();
        self.joints.clear();
        self.tied.clear();
        self.lost.clear();
        self.blocks.clear();
        self.place.clear();
        self.place.resize(blocks, None);
        self.given.clear();
        self.given.resize(blocks, [Vec3::ZERO; 2]);
        self.stored = [0.0; 2];
        self.unsettled = false;
    }
}

/// The contacts of an implicit step have not come to balance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotSolved {
    /// The pair whose force changed most in the last round; the same block twice where it is one block that is not a number.
    pub blocks: [u32; 2],
    /// Rounds of Newton's method.
    pub rounds: usize,
}

/// What the condition on a free face has done in a kick.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct FaceEntry {
    /// Given tractions on the block.
    pub(crate) dead: Wrench,
    /// Works before and after the present time, J.
    pub(crate) halves: [Account; 2],
}

/// Energy that left the patches of one group, J.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lost {
    /// By friction.
    pub friction: f64,
    /// By fracture.
    pub fracture: f64,
}

impl Lost {
    /// Adds another.
    pub(crate) fn add(&mut self, other: &Self) {
        self.friction += other.friction;
        self.fracture += other.fracture;
    }
}

/// Sums of one group of blocks.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Partial {
    pub(crate) arrival: Works,
    pub(crate) departure: Works,
    pub(crate) bad: Option<u32>,
    pub(crate) turning: bool,
}

impl Partial {
    /// Adds the works of another.
    pub(crate) fn add(&mut self, other: &Self) {
        self.arrival.add(&other.arrival);
        self.departure.add(&other.departure);
    }
}

/// A block whose state is no longer finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the forces on block {block} are not finite")]
pub struct NonFinite {
    /// Index of the block.
    pub block: u32,
}

impl Scratch {
    /// Uses no wider instructions than `width` from now on; results stay the same bits.
    pub fn limit_width(&mut self, width: Width) {
        self.width = width;
    }

    /// What kept the last implicit step from a solution, if anything did.
    #[must_use]
    pub fn not_solved(&self) -> Option<NotSolved> {
        self.implicit.failed
    }

    /// Pieces that this rank computes. An implicit step is computed by all alike: its contacts need the sums of all blocks.
    pub(crate) fn own(&self, world: &World) -> Range<usize> {
        match self.share(world) {
            Some(share) => share.own(),
            None => 0..self.tiles.list.len(),
        }
    }

    /// How the step is shared out, if it is.
    pub(crate) fn share(&self, world: &World) -> Option<&Share> {
        self.share.as_ref().filter(|_| world.implicit.is_none())
    }

    /// As [`Scratch::share`], to be changed.
    pub(crate) fn sharing(&mut self, world: &World) -> Option<&mut Share> {
        self.share.as_mut().filter(|_| world.implicit.is_none())
    }

    /// Whether nothing but patches and gravity acts on blocks in rows.
    pub(crate) fn plain(&self) -> bool {
        let d = &self.damping;
        d.mass == 0.0 && d.rotation.unwrap_or(0.0) == 0.0 && d.local == 0.0
    }
}
