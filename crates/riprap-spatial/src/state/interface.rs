//! What all interfaces between two blocks have, whatever acts in them.
//!
//! An **interface** has two sides, an origin, a frame, points, a row of the table of laws
//! ([`InterfaceLaw`](crate::setup::InterfaceLaw)) and a memory (slip, normal offset, damage, failure). Its runs have kernels of their own:
//!
//! | run | sides | kernels |
//! |---|---|---|
//! | [`Patches`](super::patches::Patches) | rigid blocks that shared a face | `wide` eight at a time, `patch` for any state |
//! | [`Facet`](super::deform::Facet)s | at least one deformable block | `InterfaceLaw::bond` |
//! | [`FoundPair`](super::found::FoundPair)s | rigid blocks that have met | `found` |

use serde::{Deserialize, Serialize};

/// Where an interface comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// Built with the model, or a part of one that was.
    #[default]
    Built,
    /// Made inside a block that was split or cut.
    Cut,
    /// Found by the search for contacts.
    Found,
}

impl Origin {
    /// Number in outputs.
    #[must_use]
    pub fn code(self) -> u8 {
        match self {
            Self::Built => 0,
            Self::Cut => 1,
            Self::Found => 2,
        }
    }
}
