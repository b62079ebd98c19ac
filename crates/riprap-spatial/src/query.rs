//! Readings by which mechanics itself computes (motion, tractions, energies, balance); what only reports is in [`crate::read`].

pub(crate) mod deformable;
pub mod view;
