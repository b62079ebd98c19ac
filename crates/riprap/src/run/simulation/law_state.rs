//! What a checkpoint holds of the laws of code ([`law`](super::law)).

use serde::{Deserialize, Serialize};

/// A law as a checkpoint holds it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Held {
    /// Its name.
    pub name: String,
    /// The group whose contacts it is of, or the two between which they are.
    pub of: Vec<String>,
    /// Numbers it remembers of each contact.
    pub width: usize,
    /// Step at which it was asked last.
    pub step: Option<u64>,
    /// Its contacts then.
    pub contacts: Vec<Acting>,
}

/// A contact at which a law acts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Acting {
    pub(super) ends: [u32; 2],
    pub(super) joint: bool,
    /// Which of the contacts of these blocks.
    pub(super) nth: u32,
    pub(super) normal: [f64; 3],
    pub(super) displacement: [f64; 3],
    pub(super) memory: Vec<f64>,
    pub(super) arms: [[f64; 3]; 2],
    pub(super) force: [f64; 3],
}
