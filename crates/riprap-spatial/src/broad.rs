//! Broad phase: which pairs of blocks may touch, and with which of their faces.

pub(crate) mod covered;
mod images;
pub(crate) mod search;
