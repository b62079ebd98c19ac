//! What is known of contacts that are found anew in each step.

use serde::{Deserialize, Serialize};

use crate::broad::search::Search;
use crate::kernel::offset::Offset;
use crate::kernel::{Memory, Role};

/// Found contacts of all rigid blocks; empty where no blocks can meet but those that patches join.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FoundContacts {
    /// Who can meet whom, per block.
    pub roles: Vec<Role>,
    /// What the candidate list is made of.
    pub search: Search,
    /// The candidates, sorted by their blocks.
    pub pairs: Vec<FoundPair>,
    /// Pairs near each other that joints held at the last look, so that they are no candidates; sorted.
    pub held: Vec<[u32; 2]>,
    /// What contacts of blocks that are built into each other store at the start at most, which no work has put in, J.
    pub at_start: f64,
    /// Longest step that the contacts allowed at the last evaluation, s; `None` before the first. State, so that a run that goes
    /// on from a checkpoint takes the steps of one that never stopped.
    pub longest_step: Option<f64>,
    /// Edges of contacts so far that no plane has made, so that a part of the surface may be missing: none, or the program is wrong.
    pub unlabelled: u64,
    /// Those of deformable blocks.
    pub deformable: super::deformable::DeformableContacts,
    /// What each block has to do with terrain; empty without terrain.
    pub terrain: Vec<OnTerrain>,
}

/// A block that terrain acts on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OnTerrain {
    /// Way that its points can go before it can touch, m.
    pub clear: f64,
    /// Whether its centroid has been beside all terrain: it falls for ever.
    pub left: bool,
    /// Its contacts, by terrain and facet.
    pub facets: Vec<FacetContact>,
}

/// A block on a facet of terrain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FacetContact {
    /// What it is on and with which piece, see [`FacetContact::key`].
    pub key: [u32; 2],
    /// Springs along the contact.
    pub memory: Memory,
    /// Energy in these springs, J.
    pub stored: f64,
    /// Force of the terrain on the block at the last evaluation, N.
    pub force: riprap_geom::Vec3,
    /// How deep the block lies in the terrain there, m.
    pub depth: f64,
    /// Area across the normal, m².
    pub area: f64,
}

impl FacetContact {
    /// Bits for the place of the terrain; those above are for the piece.
    const PIECE: u32 = 16;

    /// Key of a piece of a block on a facet: place of the terrain among all with the number of the piece (0 for convex blocks) above it, and
    /// number of the facet.
    #[must_use]
    pub fn key(terrain: usize, piece: u16, facet: u32) -> [u32; 2] {
        [terrain as u32 | u32::from(piece) << Self::PIECE, facet]
    }

    /// Number of the piece of a block of glued parts; 0 for a convex block.
    #[must_use]
    pub fn piece(&self) -> u16 {
        (self.key[0] >> Self::PIECE) as u16
    }

    /// Place of the terrain among all.
    #[must_use]
    pub fn terrain(&self) -> usize {
        (self.key[0] & ((1 << Self::PIECE) - 1)) as usize
    }
}

/// Two blocks that can touch.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FoundPair {
    /// The blocks; the smaller number first.
    pub ends: [u32; 2],
    /// Springs along the contact.
    pub memory: Memory,
    /// What goes on of the load of a joint that has let go (boxed: few have any).
    pub offset: Option<Box<Offset>>,
    /// Energy in these springs, J.
    pub stored: f64,
    /// Faces of both from which the walk of the last evaluation began; `None` for the peak.
    pub start: Option<[u16; 2]>,
    /// Faces of both from which the next one begins.
    pub next: Option<[u16; 2]>,
    /// Force of the first on the second at the last evaluation, N; 0 when apart.
    pub force: riprap_geom::Vec3,
    /// How far the blocks lie in each other, m; 0 when apart.
    pub depth: f64,
    /// They are at least so far apart, m; 0 where that is not known. State, since the length of steps hangs on it.
    pub gap: f64,
    /// Whether joints held the two in place, and they have not been far apart since.
    pub seated: bool,
    /// Of blocks of glued parts: what each two convex pieces of them share, sorted; springs are in these. `memory` is that of the one
    /// that presses most, `stored` the sum.
    pub pieces: Vec<PieceContact>,
}

/// What two convex pieces of two blocks share.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PieceContact {
    /// Numbers of the pieces.
    pub pieces: [u16; 2],
    /// Springs along the contact.
    pub memory: Memory,
    /// Energy in these springs, J.
    pub stored: f64,
    /// Force of pressure and springs of the first on the second at the last evaluation, N.
    pub force: riprap_geom::Vec3,
    /// How far the pieces lie in each other, m.
    pub depth: f64,
    /// Area across the normal, m².
    pub area: f64,
}
