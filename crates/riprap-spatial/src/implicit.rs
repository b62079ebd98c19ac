//! Implicit steps of rigid blocks: the law of found contact with steps of a millisecond.
//!
//! Here are the pieces of a pair ([`geometry`], of glued parts [`glued`]), what they answer to a motion ([`patch`], [`pair`]), joints and bolts that tie blocks ([`joint`], [`face`] where they fail as one, [`tie`]), what holds a block from outside ([`hold`]), and Newton's method for all pairs and
//! blocks ([`solve`]). What it takes from the world and gives back is in [`crate::rigid`].
//!
//! The theory is on the page `theory-implicit-step`.

pub(crate) mod face;
pub(crate) mod geometry;
pub(crate) mod glued;
pub(crate) mod hold;
pub(crate) mod joint;
pub(crate) mod memory;
pub(crate) mod pair;
pub(crate) mod patch;
pub(crate) mod solve;
#[cfg(test)]
mod tests;
pub(crate) mod tie;
