//! Implicit steps of rigid blocks: the contact law of [`crate::contact`] with steps of a millisecond.

mod geometry;
mod pair;
mod patch;
mod solve;
#[cfg(test)]
mod tests;
