//! Pairs that are not evaluated at each step.

use serde::{Deserialize, Serialize};

use crate::kernel::Pose;
use crate::kernel::friction::Wrench;

/// Steps by level.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Levels {
    /// Levels beyond the lowest: pairs of the highest are evaluated once in 2 to this power steps.
    pub most: u8,
    /// Step that the joints of each block allow, s, at the last instant common to all levels. State, since plans hang on it.
    pub joints: Vec<f64>,
    /// Evaluations of contacts that touched so far.
    pub evaluated: u64,
    /// Those that one level would have made.
    pub touching: u64,
}

impl Levels {
    /// Steps between two instants at which every pair is evaluated.
    #[must_use]
    pub fn cycle(&self) -> u64 {
        1 << self.most
    }

    /// Steps for which a pair can be planned at step number `step`: plans end at multiples of themselves.
    #[must_use]
    pub fn plannable(&self, step: u64) -> u32 {
        let most = u32::from(self.most);
        1 << step.trailing_zeros().min(most)
    }
}

/// Where a pair stands between two of its evaluations.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Clock {
    /// Steps until it is evaluated again; 0: at this instant.
    pub left: u32,
    /// Steps between its evaluations, a power of two above 1.
    pub every: u32,
    /// Time of the last one, s.
    pub at: f64,
    /// Time beyond it for which its force has been given in advance, s.
    pub given: f64,
    /// Where both blocks were then.
    pub poses: [Pose; 2],
    /// Pressure with what goes on of a joint's load, springs along the contact, and dashpots then.
    pub forces: [Wrench; 3],
    /// Work of the pressure that was booked in advance, J.
    pub booked: f64,
}
