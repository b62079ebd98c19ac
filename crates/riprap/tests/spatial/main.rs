//! The spatial engine against closed answers, without scenario files.

mod conserve;
mod rock;
mod runs;
mod stability;
