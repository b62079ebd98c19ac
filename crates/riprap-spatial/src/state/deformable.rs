//! What is known of contacts that deformable blocks find anew in each step.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::broad::search::Search;
use crate::kernel::Role;

/// Found contacts of deformable blocks with each other and with rigid ones.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformableContacts {
    /// Who can meet whom, per block.
    pub roles: Vec<Role>,
    /// What the list of pairs is made of.
    pub search: DeformableSearch,
    /// Pairs of blocks that can touch, sorted by their blocks.
    pub pairs: Vec<DeformablePair>,
    /// Longest step that these contacts allowed at the last evaluation, s; `None` before the first.
    pub longest_step: Option<f64>,
}

/// Where everything was at the last look, and how far it may go until the next one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformableSearch {
    /// Displacements of all nodes, m.
    pub displacement: Vec<[f64; 3]>,
    /// Poses of all blocks, of use for rigid ones, and margins.
    pub blocks: Search,
}

/// Two blocks that can touch, at least one of them deformable.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformablePair {
    /// The blocks; the smaller number first.
    pub ends: [u32; 2],
    /// Whether the pair has been evaluated before: what a new one stores already comes from an edit.
    pub known: bool,
    /// Its contacts that touch, by their keys: one, or on terrain one for each facet.
    pub contacts: Vec<DeformableContact>,
    /// Energy in their springs, J.
    pub stored: f64,
    /// Energy of the pressure, J.
    pub energy: f64,
    /// Force of the first on the second at the last evaluation, N; 0 when apart.
    pub force: Vec3,
    /// How far the blocks lie in each other, m; 0 when apart.
    pub depth: f64,
}

impl DeformablePair {
    /// The contact with this key, a fresh one where there is none.
    pub fn contact(&mut self, key: u32) -> &mut DeformableContact {
        let at = self.contacts.partition_point(|c| c.key < key);
        if self.contacts.get(at).is_none_or(|c| c.key != key) {
            self.contacts.insert(at, DeformableContact { key, ..DeformableContact::default() });
        }
        &mut self.contacts[at]
    }
}

/// A contact of two blocks with one normal and one limit of friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformableContact {
    /// Number of the facet of terrain; 0 for the only contact of two blocks.
    pub key: u32,
    /// Springs along it.
    pub memory: DeformableMemory,
}

/// What a contact remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformableMemory {
    /// Shear force on the second block, N.
    pub shear: Vec3,
    /// Torsion on the second block about the normal, N m.
    pub torsion: f64,
    /// Unit normal of the last step, from the first to the second; zero before the first.
    pub normal: Vec3,
    /// Area of the last step, m².
    pub area: f64,
    /// Polar second moment of the area of the last step, m⁴.
    pub polar: f64,
    /// Whether it slid in the last step.
    pub sliding: bool,
}
