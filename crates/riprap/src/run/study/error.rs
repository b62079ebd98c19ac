//! Why a study has no result.

use thiserror::Error;

use super::compare::CompareError;
use crate::run::job::JobError;

/// Why a study has no result.
#[derive(Debug, Error)]
pub enum StudyError {
    /// The scene, or a variant of it.
    #[cfg(feature = "scenario")]
    #[error("{0}")]
    Scene(crate::scenario::Diagnostics),
    /// A run that could not be carried out.
    #[error(transparent)]
    Job(#[from] JobError),
    /// The user stopped it.
    #[error("stopped by the user")]
    Stopped,
    /// The scene has no `[bisect]`.
    #[error(
        "{} has no [bisect] table; `riprap explain bisect` says what to write", path.display()
    )]
    NoBisect {
        /// The scene.
        path: std::path::PathBuf,
    },
    /// The scene says nothing that could have an error.
    #[cfg(feature = "scenario")]
    #[error(
        "{} has no named result: give it [[checks]], or a `history` in [[outputs]], each with a name", path.display()
    )]
    NoResults {
        /// The scene.
        path: std::path::PathBuf,
    },
    /// The scene as it stands has no results.
    #[error("the scene as it stands does not come to its end: {0}")]
    Ended(String),
    /// In space there is one normal law.
    #[error(
        "{} uses [space.spatial], but compare works in the plane, which has two normal laws; to study a law or a value in space write [variants] and \
         run `riprap sweep`", path.display()
    )]
    OneLaw {
        /// The scene.
        path: std::path::PathBuf,
    },
    /// Both ends of the search behave the same.
    #[error("no limit between the two ends: {0}")]
    NoLimit(String),
    /// What is wanted does not lie between the ends, or is no value of the result.
    #[cfg(feature = "scenario")]
    #[error("{0}")]
    Outside(String),
    /// The runs could not be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// The name of nothing.
    #[error("unknown {what} `{name}`; valid names: {known}")]
    Unknown {
        /// An interface, a material or a group.
        what: &'static str,
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// Nothing can be reduced.
    #[error(
        "none of the selected interfaces has a strength to reduce (friction angle, cohesion or tension): {0}"
    )]
    NoStrength(String),
    /// A number that is none.
    #[error("the width, the unbalanced-force ratio and the displacement must be above zero")]
    NotANumber,
    /// A range that is none.
    #[cfg(feature = "scenario")]
    #[error(transparent)]
    Range(#[from] RangeError),
}

#[cfg(feature = "scenario")]
impl From<crate::scenario::Diagnostics> for StudyError {
    fn from(wrong: crate::scenario::Diagnostics) -> Self {
        Self::Scene(wrong)
    }
}

/// A range or a width that cannot be read.
#[cfg(feature = "scenario")]
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RangeError {
    /// Not two values.
    #[error(
        "{0:?} is not a range; write two values with units, for example '20 deg..45 deg' or '0.5..3'"
    )]
    Range(String),
    /// A width of another kind, or not above zero.
    #[error("{given:?} is not a valid width for this range; write for example {example:?}")]
    Width {
        /// What was given.
        given: String,
        /// What could be.
        example: String,
    },
}
