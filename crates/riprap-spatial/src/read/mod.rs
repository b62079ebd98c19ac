//! What can be read from a model: readings, pictures and after-thoughts. Nothing here changes a world, and no step needs it but
//! edits, which plan with what a [`crate::query::view::View`] says.

pub mod bars;
pub mod beyond;
pub mod bolts;
pub mod borne;
pub mod conditions;
pub mod contacts;
pub mod cracks;
pub mod crater;
pub mod depths;
pub mod fields;
mod fragments;
mod gas;
mod heap;
pub mod outlook;
pub mod peaks;
pub mod picture;
mod pins;
mod removed;
pub mod seams;
mod states;
mod stress;
mod supports;
pub mod survey;
pub mod tetrahedra;
pub mod toes;
mod water;
