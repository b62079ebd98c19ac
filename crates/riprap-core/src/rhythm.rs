//! How often something is done: the word of the scenario language and of a plan.

use serde::{Deserialize, Serialize};

/// A rhythm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Every {
    /// Model time, s.
    Time(f64),
    /// Steps.
    Steps(u64),
    /// At the end of each phase.
    Phase,
    /// Not at all.
    Never,
}
