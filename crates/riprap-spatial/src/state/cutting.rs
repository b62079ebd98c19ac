//! State of cutting deformable blocks.

use serde::{Deserialize, Serialize};

use crate::setup::deform::CutRules;

/// State of cutting in a phase.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cutting {
    /// The rules.
    pub rules: CutRules,
    /// Step at which blocks were last looked at.
    pub last_check_step: u64,
    /// Times that blocks were cut.
    pub stages: u64,
}

/// What a cut had to make: of the model only what is about the cut blocks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Kinds: shapes of parts with their elements.
    pub classes: usize,
    /// Facets of cut blocks.
    pub facets: usize,
    /// Highest frequencies of parts and of blocks that share facets with them; none where everything relaxes.
    pub frequencies: usize,
}
