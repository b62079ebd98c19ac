//! Simulation loop: phases, schedule, stop criteria, checks, sweeps.
