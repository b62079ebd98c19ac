//! The browser viewer of run folders.
//!
//! `riprap view RUN` serves one page and the answers it asks for, on this machine only. The page (TypeScript, in
//! `viewer/`) is built by `npm run build` there and embedded here, so that nothing but this program is needed to look
//! at a run. A run is read through `riprap_record` alone.
//!
//! - [`run`]: a run folder opened for looking, and what can be wrong with it;
//! - [`shape`], [`motion`]: blocks at rest, and how they moved, as compact arrays;
//! - [`contacts`]: what is between the blocks;
//! - [`wire`]: the binary answers; [`answer`]: which question gives which;
//! - [`report`]: the same page with its answers in one file;
//! - [`server`]: HTTP on the loopback address.

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
#![allow(
    clippy::disallowed_methods,
    reason = "pictures only: no result depends on the functions of the platform here"
)]

pub mod answer;
pub mod contacts;
pub mod crosses;
#[cfg(test)]
mod fixture;
pub mod motion;
mod parts;
mod problem;
pub mod report;
pub mod run;
pub mod server;
pub mod shape;
pub mod wire;

pub use server::{Server, ServerError};
