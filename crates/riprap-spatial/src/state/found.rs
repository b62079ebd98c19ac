//! What is known of contacts that are found anew in each step.

use serde::{Deserialize, Serialize};

use crate::found::offset::Offset;
use crate::found::{Memory, Role, Search};

/// Found contacts of all rigid blocks; empty where no blocks can meet but those that patches join.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FoundContacts {
    /// Who can meet whom, per block.
    pub roles: Vec<Role>,
    /// What the candidate list is made of.
    pub search: Search,
    /// The candidates, sorted by their blocks.
    pub pairs: Vec<FoundPair>,
    /// Longest step that the contacts allowed at the last evaluation, s; `None` before the first. State, so that a run that goes
    /// on from a checkpoint takes the steps of one that never stopped.
    pub longest_step: Option<f64>,
    /// Those of deformable blocks.
    pub soft: super::soft::SoftContacts,
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
}
