//! What every engine of riprap stands on.
//!
//! - [`exec`]: the one place that names the thread pool; [`peers`]: ranks that compute one model together; [`lanes`]: eight numbers at a time;
//! - [`ledger`]: energy; [`accounts`]: the work of single conditions; [`profile`]: stage timers;
//! - [`state_hash`]: equal hashes, equal states;
//! - [`laws`]: pure functions on numbers; [`dynamics`]: time functions, formulas, damping;
//! - [`condition`]: `and`, `or`, `not` on names of blocks;
//! - [`distribution`]: random numbers and what a count of failures says;
//! - [`sparse`]: linear systems of bodies that share contacts;
//! - [`flow`]: gas that flows through a network of cracks;
//! - [`rhythm`]: how often something is done;
//! - [`field`], [`frame`]: the vocabulary in which an engine tells what it can be asked, and one picture of its blocks.
//!
//! This crate knows no engine, no file and no scenario.

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod accounts;
pub mod condition;
pub mod distribution;
pub mod dynamics;
pub mod exec;
pub mod failed;
pub mod field;
pub mod flow;
pub mod frame;
pub mod lanes;
pub mod laws;
pub mod ledger;
pub mod numbers;
pub mod peers;
pub mod profile;
pub mod rhythm;
pub mod sets;
pub mod sparse;
pub mod state_hash;
pub mod sums;

pub use riprap_geom as geom;
pub use riprap_geom::{Vec2, Vec3};
