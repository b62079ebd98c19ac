//! Words and keys of the scenario language, declared once, where the laws are.
//!
//! A choice of a law is an enum; with `#[derive(Words)]` its variants are the words that a scenario
//! may use, and the first paragraph of a variant's documentation is what `riprap explain` and the
//! reference page say about it.
//!
//! This crate knows no law, no engine and no scenario.

mod words;

pub use riprap_keys_derive::{Keys, Words};
pub use words::Words;

/// What derived code uses; not for anybody else.
#[doc(hidden)]
pub mod derived {
    #[cfg(feature = "schema")]
    pub use crate::words::schema;
    pub use crate::words::{deserialize, serialize};
    #[cfg(feature = "schema")]
    pub use schemars;
    pub use serde;
}
