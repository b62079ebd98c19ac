//! Simulation loop: phases, schedule, stop criteria, checks, sweeps.

pub mod ask;
pub mod bracket;
pub mod checks;
pub mod compare;
pub mod cpu;
pub mod drive;
pub mod engine;
pub mod forecast;
pub mod given_step;
pub mod job;
pub mod meeting;
pub mod origin;
mod overruled;
pub mod probe;
pub mod recorder;
mod rough;
pub mod safety;
#[cfg(feature = "scenario")]
pub mod scene;
pub mod simulation;
#[cfg(feature = "scenario")]
pub mod sweep;
#[cfg(feature = "scenario")]
pub mod trials;
#[cfg(feature = "scenario")]
pub mod verify;
