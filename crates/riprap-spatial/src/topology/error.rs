//! Why an edit failed.

use crate::setup::error::BuildError;
use crate::setup::error::RefineError;
use crate::state::scratch::NonFinite;

/// Why an edit failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EditError {
    /// Forces after the edit are not finite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// Patches cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// Too many blocks.
    #[error(transparent)]
    Refine(#[from] RefineError),
    /// What must not change has changed: our mistake.
    #[error("{what} changed from {before:e} to {after:e} when block {block} was edited")]
    Audit {
        /// What.
        what: &'static str,
        /// Name of the block.
        block: String,
        /// Before the edit.
        before: f64,
        /// After it.
        after: f64,
    },
}
