//! What is wrong with a run, and what to do about it.

use riprap_record::vtu::ReadError;
use serde::Serialize;

/// Why something cannot be shown, in words for the person in front of the page.
#[derive(Debug, Clone, Serialize, thiserror::Error)]
#[error("{what}")]
pub struct Problem {
    /// What is wrong, with the file.
    pub what: String,
    /// What to do about it.
    pub hint: String,
    /// Whether it is not there, rather than broken.
    pub missing: bool,
}

impl Problem {
    /// Something that does not exist.
    pub fn missing(what: impl Into<String>, hint: impl Into<String>) -> Self {
        Problem { what: what.into(), hint: hint.into(), missing: true }
    }

    /// Something that is there and cannot be read.
    pub fn broken(what: impl Into<String>, hint: impl Into<String>) -> Self {
        Problem { what: what.into(), hint: hint.into(), missing: false }
    }
}

impl From<ReadError> for Problem {
    fn from(error: ReadError) -> Self {
        let hint = match &error {
            ReadError::Read { .. } => {
                "The file is missing or cannot be read. Copy the complete run folder again."
            }
            ReadError::Foreign { .. } => "Frames of other programs can be viewed in ParaView.",
            ReadError::Damaged { .. } => {
                "The other frames can still be shown. Copy the run folder again, or run the scene again."
            }
        };
        Problem::broken(error.to_string(), hint)
    }
}
