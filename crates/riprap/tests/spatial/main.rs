//! The spatial engine against closed answers, without scenario files.

mod bits;
mod conserve;
mod rock;
mod runs;
mod stability;
mod statics;
mod turning;
mod waves;
