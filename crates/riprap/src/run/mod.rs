//! Simulation loop: phases, schedule, stop criteria, checks, sweeps.

pub mod bisect;
pub mod checks;
pub mod compare;
pub mod drive;
pub mod engine;
pub mod forecast;
pub mod given_step;
pub mod hash;
pub mod job;
pub mod plan;
pub mod probe;
pub mod recorder;
pub mod scene;
pub mod simulation;
pub mod sweep;
pub mod trials;
pub mod verify;
