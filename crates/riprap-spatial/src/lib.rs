//! The 3D engine: rigid blocks joined by face patches, boundaries, gas cavities, splitting.

pub mod anchor;
pub mod boundary;
pub mod build;
pub mod cavity;
pub mod crater;
pub mod deform;
pub mod edit;
pub mod fields;
pub mod forces;
pub mod found;
mod fragments;
mod gather;
mod integrate;
pub mod kick;
mod layout;
pub mod meet;
pub mod meet_solids;
pub mod overlap;
pub mod patch;
pub mod peaks;
pub mod picture;
pub mod push;
pub mod readings;
pub mod refine;
pub mod region;
pub mod setup;
pub mod stable;
pub mod state;
pub mod step;
pub mod survey;
pub mod tiles;
pub mod wide;

pub use riprap_core::lanes;
use riprap_core::{dynamics, exec, field, frame, laws, ledger, profile};
pub use state::{sums, world};
