//! Broad phase: which pairs of blocks may touch, and with which of their faces.

mod images;
pub(crate) mod search;
