//! What is known of contacts that are found again in each step.

use serde::{Deserialize, Serialize};

use crate::broad::search::Search;
use crate::kernel::offset::Offset;
use crate::kernel::{Image, Memory, PairKey, Role};
use crate::state::clock::{Clock, Levels};

/// Found contacts of all rigid blocks; empty where no blocks can meet but those that patches join.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FoundContacts {
    /// Who can meet whom, per block.
    pub roles: Vec<Role>,
    /// What the candidate list is made of.
    pub search: Search,
    /// The candidates, sorted by their blocks; then each block that terrain acts on with each terrain, sorted by block.
    pub pairs: Vec<FoundPair>,
    /// Pairs near each other that joints held at the last look, so that they are no candidates; sorted.
    pub held: Vec<PairKey>,
    /// What contacts of blocks that are built into each other store at the start at most, which no work has put in, J.
    pub at_start: f64,
    /// Longest step that the contacts allowed at the last evaluation, s; `None` before the first. State, so that a run that goes
    /// on from a checkpoint takes the steps of one that never stopped.
    pub longest_step: Option<f64>,
    /// Edges of contacts so far that no plane has made, so that a part of the surface may be missing: none, or the program is wrong.
    pub unlabelled: u64,
    /// Implicit steps so far in which the limits of friction did not come to rest, and all implicit steps.
    pub unsettled: [u64; 2],
    /// How pairs are stepped by levels; `None` where each is evaluated at each step.
    pub levels: Option<Box<Levels>>,
    /// Those of deformable blocks.
    pub deformable: super::deformable::DeformableContacts,
    /// Blocks whose centroid has been beside all terrain, which fall for ever; empty without terrain.
    pub left_terrain: Vec<bool>,
}

/// Two bodies that can touch: blocks, or terrain and a block.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FoundPair {
    /// The blocks; the smaller number first, or terrain.
    pub ends: [u32; 2],
    /// Which image of the second block it is in a periodic model.
    pub image: Image,
    /// What goes on of the load of a joint that has let go (boxed: few have any).
    pub offset: Option<Box<Offset>>,
    /// Faces of both from which the walk of the last evaluation began; `None` for the peak.
    pub start: Option<[u16; 2]>,
    /// Faces of both from which the next one begins.
    pub next: Option<[u16; 2]>,
    /// How far they lie in each other, m; 0 when apart.
    pub depth: f64,
    /// They are at least so far apart, m; 0 where that is not known. State, since the length of steps hangs on it.
    pub gap: f64,
    /// Whether joints held the two in place, and they have not been far apart since.
    pub seated: bool,
    /// How it is stepped while it touches and is not evaluated at each step (boxed: where steps have levels alone).
    pub clock: Option<Box<Clock>>,
    /// What they share, in the order of the narrow phase: nothing while they are apart, one patch of two convex blocks, one of each two
    /// pieces of glued parts, one of each facet of terrain and piece.
    pub patches: Vec<ContactPatch>,
}

impl FoundPair {
    /// A pair of which nothing is known yet.
    #[must_use]
    pub fn new(PairKey { ends, image }: PairKey) -> Self {
        Self { ends, image, ..Self::default() }
    }

    /// The pair among all.
    #[must_use]
    pub fn key(&self) -> PairKey {
        PairKey { ends: self.ends, image: self.image }
    }

    /// Adds a patch. Most pairs have one at most: a list of its own accord would take room for four.
    pub fn push(&mut self, patch: ContactPatch) {
        if self.patches.capacity() == 0 {
            self.patches.reserve_exact(1);
        }
        self.patches.push(patch);
    }

    /// The patch that presses most, the first of equal ones; `None` when apart.
    #[must_use]
    pub fn leading(&self) -> Option<&ContactPatch> {
        let most = |a: &'_ ContactPatch, b: &'_ ContactPatch| b.pressed > a.pressed;
        self.patches.iter().reduce(|a, b| if most(a, b) { b } else { a })
    }

    /// Energy in the springs along all patches, J.
    #[must_use]
    pub fn stored(&self) -> f64 {
        self.patches.iter().map(|patch| patch.stored).sum()
    }

    /// Force of the first on the second at the last evaluation without dashpots, N.
    #[must_use]
    pub fn force(&self) -> riprap_geom::Vec3 {
        self.patches.iter().map(|patch| patch.force).sum()
    }
}

/// A patch of the surface that two bodies share, with springs of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ContactPatch {
    /// Pieces of both blocks (0 for convex ones); on terrain the piece and the facet.
    pub key: [u32; 2],
    /// Springs along the contact.
    pub memory: Memory,
    /// Energy in these springs, J.
    pub stored: f64,
    /// Force of pressure and springs of the first on the second at the last evaluation, N.
    pub force: riprap_geom::Vec3,
    /// Size of the force of the pressure, N.
    pub pressed: f64,
    /// How far they lie in each other there, m.
    pub depth: f64,
    /// Area across the normal, m².
    pub area: f64,
}
