//! Simulation loop: phases, schedule, stop criteria, checks, sweeps.

pub mod plan;
