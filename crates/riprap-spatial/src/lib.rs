//! The 3D engine: rigid blocks joined by face patches, boundaries, gas cavities, splitting.

// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

mod anchor;
pub mod bolts;
mod boundary;
pub mod build;
pub mod cavity;
pub mod contacts;
pub mod deform;
pub mod divisible;
pub mod edit;
mod entries;
mod forces;
pub mod found;
mod gather;
mod integrate;
mod kick;
mod layout;
mod meet;
mod meet_solids;
mod overlap;
mod patch;
mod push;
pub mod read;
mod refine;
pub mod region;
pub mod setup;
pub mod stable;
mod state;
pub mod step;
pub mod tiles;
mod wide;

pub use read::{fields, view};
pub use riprap_core::lanes;
use riprap_core::{accounts, dynamics, exec, field, frame, laws, ledger, profile};
pub use state::{sums, world};
