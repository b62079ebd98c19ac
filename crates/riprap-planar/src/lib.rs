//! The 2D engine: rigid polygons with mutual-potential contact.

// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod bond;
pub mod classify;
pub mod contact;
pub mod convex;
pub mod depths;
pub mod energy;
pub mod fields;
mod fragments;
pub mod handover;
mod hash;
mod heap;
pub mod loads;
mod parting;
pub mod picture;
pub mod pieces;
pub mod potential;
pub mod search;
pub mod setup;
pub mod shapes;
pub mod stable;
pub mod step;
pub mod view;
pub mod world;

use riprap_core::{dynamics, exec, field, frame, laws, ledger, sums};
