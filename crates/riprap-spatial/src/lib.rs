//! The 3D engine: rigid blocks joined by face patches, boundaries, gas cavities, splitting.

// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod anchor;
pub mod boundary;
pub mod build;
pub mod cavity;
pub mod contacts;
pub mod deform;
pub mod edit;
pub mod forces;
pub mod found;
mod gather;
mod integrate;
pub mod kick;
mod layout;
pub mod meet;
pub mod meet_solids;
pub mod overlap;
pub mod patch;
pub mod push;
pub mod read;
pub mod refine;
pub mod region;
pub mod setup;
pub mod stable;
pub mod state;
pub mod step;
pub mod tiles;
pub mod wide;

pub use read::{fields, view};
pub use riprap_core::lanes;
use riprap_core::{dynamics, exec, field, frame, laws, ledger, profile};
pub use state::{sums, world};
