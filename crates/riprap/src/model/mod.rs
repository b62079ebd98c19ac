//! Scenario to SI numbers: block generation, material and interface tables, resolved plan.
//!
//! ```text
//! Parsed --origin--> generate blocks --> names, groups --> interfaces --> supports, loads
//!                                                              --> water --> phases, outputs, checks
//!        --> inspect (overlaps, slivers, nothing to move) --> Model
//! ```
//!
//! Everything the scenario leaves open is decided here and written down in `Model::explained`, with
//! where it came from. All errors are collected, each with its place in the file; what is accepted
//! although it is odd (clockwise polygons, far coordinates) is a note among the warnings.
//!
//! Not here: the stable time step and everything else that needs the engine.

mod accounts;
mod assertions;
mod behaviour;
mod blocks;
mod bolts;
mod build;
mod builder;
mod control;
mod drawn;
mod fields;
mod generated;
mod in_situ;
mod inspect;
mod interfaces;
mod leavers;
mod loose;
pub(crate) mod memory;
mod motion;
mod names;
mod phases;
mod pins;
mod regions;
mod solid;
mod start;
mod summary;
mod surface;
mod unused;
mod water;

pub use crate::scenario::read::{Explained, Provenance};
pub use assertions::{Bisection, Failing, LIMIT, PROBABILITY};
pub use build::build;
pub use summary::{Charge, Region, Summary};

use crate::plan::Check;
use crate::plan::Plan;
use crate::scenario::Diagnostic;
pub use crate::setup::Setup;

/// A scenario in numbers, ready to be run.
#[derive(Clone, Debug)]
pub struct Model {
    /// What the engine is built from.
    pub setup: Setup,
    /// Phases and outputs.
    pub plan: Plan,
    /// Checks that apply to this case.
    pub checks: Vec<Check>,
    /// The search of `[bisect]`, if there is one.
    pub bisect: Option<Bisection>,
    /// What the samples of `[monte_carlo]` are asked, where it says what fails.
    pub monte_carlo: Option<Failing>,
    /// Every key with its value and where it came from.
    pub explained: Vec<Explained>,
    /// Counts and sizes, for `riprap check`.
    pub summary: Summary,
    /// Warnings and notes, those of the scenario included.
    pub warnings: Vec<Diagnostic>,
}

#[cfg(test)]
mod tests;
