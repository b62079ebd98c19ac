//! Why block theory has no answer.

use crate::run::engine::BuildError;
use crate::run::job::JobError;
use crate::run::simulation::RunError;

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum RemovableError {
    /// In the plane.
    #[error(
        "block theory needs blocks in space ([space.spatial]); for a section run `riprap safety`"
    )]
    Planar,
    /// No such phase.
    #[error("there is no phase `{name}`; valid names: {known}")]
    Phase {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// A factor that is none.
    #[error("the factor of safety must be above zero and finite")]
    Factor,
    /// A model that cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// Forces that cannot be found.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A picture that cannot be written.
    #[error(transparent)]
    Picture(Box<JobError>),
}

impl From<JobError> for RemovableError {
    fn from(error: JobError) -> Self {
        Self::Picture(Box::new(error))
    }
}
