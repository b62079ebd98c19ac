//! The 2D engine: rigid polygons with mutual-potential contact.

// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod bolts;
pub mod bond;
pub mod classify;
pub mod conditions;
mod contact;
mod convex;
mod depths;
mod energy;
pub mod fields;
mod fragments;
mod handover;
mod hash;
mod heap;
mod loads;
mod parting;
pub mod picture;
mod pieces;
mod potential;
pub mod removal;
mod scratch;
mod search;
mod seepage;
pub mod setup;
pub mod shapes;
pub mod stable;
pub mod step;
mod stress;
pub mod view;
mod water;
pub mod world;

use riprap_core::{accounts, dynamics, exec, field, frame, laws, ledger, sums};
