//! The same case under both normal laws of the plane, to be compared.

use std::path::{Path, PathBuf};

use super::compare::{self, Difference};
use super::{Executor, StudyError};
use crate::record::folder::Existing;
use crate::run::drive::{Ending, Look};
use crate::run::job::{self, Outcome};
use crate::run::scene::Scene;
use crate::scenario::Case;
use crate::scenario::language::Space;

/// Both normal laws, in the order in which they are compared.
pub const LAWS: [&str; 2] = ["distance_potential", "penetration_potential"];

/// One run of a comparison.
#[derive(Clone, Debug)]
pub struct Side {
    /// Normal law.
    pub law: &'static str,
    /// Its folder.
    pub folder: PathBuf,
    /// How it came out.
    pub outcome: Outcome,
}

/// Whether the scene has two normal laws to compare.
///
/// # Errors
/// A scene in space.
pub fn comparable(scene: &Scene) -> Result<(), StudyError> {
    match scene.parsed.scenario.space {
        Space::Planar(_) => Ok(()),
        Space::Spatial(_) => Err(StudyError::OneLaw { path: scene.path.clone() }),
    }
}

/// Runs a case of `scene` under both laws, one after the other, each on all threads, into sub-folders of `folder` and compares.
///
/// # Errors
/// The scene, the runs, the files.
pub fn both_laws(
    scene: &Scene,
    case: &Case,
    folder: &Path,
    existing: Existing,
    executor: &Executor<'_>,
    look: &mut dyn FnMut(&str, &mut Look<'_>),
) -> Result<(Vec<Side>, Vec<Difference>), StudyError> {
    comparable(scene)?;
    let mut sides = Vec::new();
    for law in LAWS {
        let mut variant = case.clone();
        let interfaces = scene.parsed.scenario.interfaces.names();
        // After the changes of the case, which may name a law themselves.
        variant.trial.extend(
            interfaces.map(|name| (format!("interfaces.{name}.law"), format!("\"{law}\""))),
        );
        let job = scene.prepare(&variant)?.job();
        let sub = folder.join(law);
        let outcome = job::run(job, &sub, existing, executor.threads, &mut |now| {
            look(law, now);
            executor.control()
        })?;
        if outcome.ending == Ending::Stopped {
            return Err(StudyError::Stopped);
        }
        sides.push(Side { law, folder: sub, outcome });
    }
    let differences = compare::folders(&sides[0].folder, &sides[1].folder)?;
    Ok((sides, differences))
}
