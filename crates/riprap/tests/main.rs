//! The library through its public face: one program, a module a file.

#![allow(
    clippy::disallowed_methods,
    reason = "tests may compare with the functions of the platform"
)]

mod accounts;
mod common;
mod model_files;
mod planar_corner_cases;
mod planar_degenerate;
mod planar_energy;
mod planar_engine;
mod planar_flush;
mod planar_handover;
mod planar_invariance;
mod planar_joints;
mod planar_services;
mod planar_source_law;
mod ranks;
mod safety;
mod spatial;
mod spatial_steady;
mod tilted;
mod water;

use riprap_testkit::Counting;

/// Counts for the tests of steady steps.
#[global_allocator]
static ALLOCATOR: Counting = Counting::new();
