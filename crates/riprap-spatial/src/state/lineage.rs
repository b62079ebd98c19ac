//! Where blocks come from.

use serde::{Deserialize, Serialize};

use crate::setup::Setup;

/// Where a block comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// The block it was split from; [`Origin::NONE`] for a block as given.
    pub parent: u32,
    /// Octant in the parent; of a block without one 0, or [`u8::MAX`] where it was added ([`Origin::ADDED`]).
    pub octant: u8,
    /// Number of splits since the block as given.
    pub level: u8,
}

impl Origin {
    /// No parent.
    pub const NONE: u32 = u32::MAX;
    /// Origin of a block as given.
    pub const GIVEN: Self = Self { parent: Self::NONE, octant: 0, level: 0 };
    /// Of a block that was added while the model ran.
    pub const ADDED: Self = Self { parent: Self::NONE, octant: u8::MAX, level: 0 };
}

/// The block with a number below `first`, or without a parent, that block `b` comes from: itself if it is one.
#[must_use]
pub(crate) fn ancestor(lineage: &[Origin], b: u32, first: u32) -> u32 {
    let mut b = b;
    while b >= first && lineage[b as usize].parent != Origin::NONE {
        b = lineage[b as usize].parent;
    }
    b
}

/// Name of block `b`: `rock.17/3` is octant 3 of `rock.17`.
#[must_use]
pub(crate) fn name(setup: &Setup, lineage: &[Origin], b: usize) -> String {
    let spec = setup.blocks[b].name;
    let mut text = setup.names.get(spec.base as usize).cloned().unwrap_or_default();
    if spec.number > 0 {
        text.push_str(&format!(".{}", spec.number));
    }
    let mut octants = Vec::new();
    let mut origin = lineage.get(b).copied().unwrap_or(Origin::GIVEN);
    while origin.parent != Origin::NONE {
        octants.push(origin.octant);
        origin = lineage[origin.parent as usize];
    }
    for octant in octants.iter().rev() {
        text.push_str(&format!("/{octant}"));
    }
    text
}
