//! Field table, frames, run folder, checkpoints, plots.
