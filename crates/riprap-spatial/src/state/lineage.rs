//! Where blocks come from.

use serde::{Deserialize, Serialize};

/// Where a block comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// The block it was split from; [`Origin::NONE`] for a block as given.
    pub parent: u32,
    /// Octant in the parent.
    pub octant: u8,
    /// Number of splits since the block as given.
    pub level: u8,
}

impl Origin {
    /// No parent.
    pub const NONE: u32 = u32::MAX;
    /// Origin of a block as given.
    pub const GIVEN: Self = Self { parent: Self::NONE, octant: 0, level: 0 };
}
