//! The spatial engine against closed answers.

mod bits;
mod conserve;
mod rock;
mod runs;
mod statics;
mod turning;
mod waves;
