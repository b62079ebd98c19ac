//! Simulation loop: phases, schedule, stop criteria, checks, sweeps.

pub mod bisect;
pub mod checks;
pub mod compare;
pub mod drive;
pub mod job;
pub mod plan;
pub mod probe;
pub mod recorder;
pub mod resolve;
pub mod simulation;
