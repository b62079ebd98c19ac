//! A scene run again and again with one key changed: the search of `[bisect]`, and the same scene
//! under both normal laws.

use std::path::{Path, PathBuf};

use thiserror::Error;

use super::bisect::{BisectError, Bracket, bisect};
use super::checks::Status;
use super::compare::{self, CompareError, Difference};
use super::drive::{Control, Ending, Look};
use super::job::{self, JobError, Outcome, watch_only};
use super::scene::Scene;
use crate::model::Bisection;
use crate::plan::shown::{Shown, digits_for};
use crate::record::folder::Existing;
use crate::scenario::language::Space;
use crate::scenario::{Case, Diagnostics};

/// Why trials could not be made.
#[derive(Debug, Error)]
pub enum TrialError {
    /// The scene, or the scene with the changed key.
    #[error("{0}")]
    Scene(Diagnostics),
    /// A run.
    #[error(transparent)]
    Job(#[from] JobError),
    /// The scene has no `[bisect]`.
    #[error(
        "{} has no [bisect] table; `riprap explain bisect` says what to write", path.display()
    )]
    NoBisect {
        /// The scene.
        path: PathBuf,
    },
    /// In space there is one normal law.
    #[error(
        "{} is in [space.spatial]: compare is for the plane, which has two normal laws; to see what a law or a number \
         does in space write [variants] and run `riprap sweep`", path.display()
    )]
    OneLaw {
        /// The scene.
        path: PathBuf,
    },
    /// The user stopped it.
    #[error("stopped by the user")]
    Stopped,
    /// Both ends of the search behave the same.
    #[error("no limit between the ends: {0}")]
    NoLimit(String),
    /// The runs could not be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
}

/// One trial of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Value of the key, SI.
    pub value: f64,
    /// The value, for reading: in the unit of the scene.
    pub words: String,
    /// What was read.
    pub measured: Option<f64>,
    /// What was read, for reading, beside the bound.
    pub measured_words: String,
    /// Whether the scene failed.
    pub failed: bool,
    /// How the run ended when it was not at its end.
    pub note: String,
}

/// What a search found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The key.
    pub key: String,
    /// SI unit of the values; empty for none.
    pub unit: String,
    /// How its values are shown: in the unit in which the scene gave the interval.
    pub shown: Shown,
    /// Values that hold and fail.
    pub bracket: Bracket,
    /// Digits that the tolerance of the search makes meaningful.
    pub digits: usize,
}

/// Searches for the value at which a case of `scene` begins to fail.
///
/// A run that the physics stops counts as failed.
///
/// # Errors
/// Scenes without `[bisect]`, ends that behave the same, a key whose values cannot be used.
pub fn search(
    scene: &Scene,
    case: &Case,
    threads: usize,
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    report: &mut dyn FnMut(&Trial),
) -> Result<Found, TrialError> {
    let prepared = scene.prepare(case).map_err(TrialError::Scene)?;
    let Some(wanted) = prepared.model.bisect else {
        return Err(TrialError::NoBisect {
            path: scene.path.clone(),
        });
    };
    let shown = shown(&wanted);
    let digits = digits_for(wanted.tolerance / wanted.low.abs().max(wanted.high.abs()));
    let trial = |value: f64| -> Result<bool, TrialError> {
        // After the changes of the case, which may name the key themselves.
        let mut changed = case.clone();
        let text = format!("{value} {}", wanted.unit);
        let quoted = if wanted.unit.is_empty() {
            format!("{value:?}")
        } else {
            format!("{text:?}")
        };
        changed.trial.push((wanted.key.clone(), quoted));
        let mut job = scene.prepare(&changed).map_err(TrialError::Scene)?.job();
        job.checks = vec![wanted.holds.clone()];
        let Outcome { ending, checks, .. } = watch_only(job, threads, look)?;
        let note = match ending {
            Ending::Finished => String::new(),
            Ending::Stopped => return Err(TrialError::Stopped),
            Ending::Unstable(why) => why.to_string(),
        };
        let holds = checks.iter().all(|check| check.status == Status::Passed);
        let failed = !note.is_empty() || !holds;
        let measured = checks.first().and_then(|check| check.measured);
        let measured_words = checks
            .first()
            .map_or_else(String::new, |check| check.words.clone());
        report(&Trial {
            value,
            words: shown.text(value, digits),
            measured,
            measured_words,
            failed,
            note,
        });
        Ok(failed)
    };
    let bracket =
        bisect(wanted.low, wanted.high, wanted.tolerance, trial).map_err(|wrong| match wrong {
            BisectError::Trial(why) => why,
            BisectError::NoLimit { .. } | BisectError::NotANumber => {
                TrialError::NoLimit(wrong.to_string())
            }
        })?;
    Ok(Found {
        key: wanted.key,
        shown: shown.clone(),
        unit: wanted.unit,
        bracket,
        digits,
    })
}

/// The unit of a search.
fn shown(wanted: &Bisection) -> Shown {
    let given = wanted.shown.clone();
    given.unwrap_or_else(|| Shown::suited(&wanted.unit, wanted.low.abs().max(wanted.high.abs())))
}

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
pub fn comparable(scene: &Scene) -> Result<(), TrialError> {
    match scene.parsed.scenario.space {
        Space::Planar(_) => Ok(()),
        Space::Spatial(_) => Err(TrialError::OneLaw {
            path: scene.path.clone(),
        }),
    }
}

/// Runs the plain case (or the one called `case`) of `scene` under both laws into sub-folders of
/// `folder` and compares.
///
/// # Errors
/// The scene, the runs, the files.
pub fn both_laws(
    scene: &Scene,
    case: Option<&str>,
    folder: &Path,
    existing: Existing,
    threads: usize,
    look: &mut dyn FnMut(&str, &mut Look<'_>) -> Control,
) -> Result<(Vec<Side>, Vec<Difference>), TrialError> {
    comparable(scene)?;
    let mut sides = Vec::new();
    for law in LAWS {
        let mut chosen = case
            .and_then(|name| scene.case(name))
            .unwrap_or_else(|| scene.plain());
        let interfaces = scene.parsed.scenario.interfaces.names();
        // After the changes of the case, which may name a law themselves.
        let changes =
            interfaces.map(|name| (format!("interfaces.{name}.law"), format!("\"{law}\"")));
        chosen.trial.extend(changes);
        let job = scene.prepare(&chosen).map_err(TrialError::Scene)?.job();
        let sub = folder.join(law);
        let mut look = |here: &mut Look<'_>| look(law, here);
        let outcome = job::run(job, &sub, existing, threads, &mut look)?;
        if outcome.ending == Ending::Stopped {
            return Err(TrialError::Stopped);
        }
        sides.push(Side {
            law,
            folder: sub,
            outcome,
        });
    }
    let differences = compare::folders(&sides[0].folder, &sides[1].folder)?;
    Ok((sides, differences))
}
