//! A scene run again and again with one key changed: the search of `[bisect]`, and the same scene
//! under both normal laws.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use thiserror::Error;

use super::bracket::{Search, State, Task, drive};
use super::checks::Status;
use super::compare::{self, CompareError, Difference};
use super::drive::{Control, Ending, Look};
use super::job::{self, JobError, Outcome, watch_only};
use super::safety::with_value;
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
        "{} uses [space.spatial], but compare works in the plane, which has two normal laws; to study a law or a value in space write [variants] and \
         run `riprap sweep`", path.display()
    )]
    OneLaw {
        /// The scene.
        path: PathBuf,
    },
    /// The user stopped it.
    #[error("stopped by the user")]
    Stopped,
    /// Both ends of the search behave the same.
    #[error("no limit between the two ends: {0}")]
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
    /// The value nearest to the limit that holds, SI.
    pub holds_at: f64,
    /// The value nearest to the limit that fails, SI.
    pub fails_at: f64,
    /// Digits that the tolerance of the search makes meaningful.
    pub digits: usize,
}

impl Found {
    /// The middle between the value that holds and the one that fails.
    #[must_use]
    pub fn limit(&self) -> f64 {
        0.5 * (self.holds_at + self.fails_at)
    }
}

/// Searches for the value at which a case of `scene` begins to fail, with `threads` trials side by side; `look` sees those
/// that are needed, `stop` is asked by all.
///
/// A run that the physics stops counts as failed.
///
/// # Errors
/// Scenes without `[bisect]`, ends that behave the same, a key whose values cannot be used.
///
/// # Examples
///
/// The friction at which a slope begins to slide: the factor of safety of its angle.
///
/// ```
/// use std::path::Path;
///
/// use riprap::run::scene::Scene;
/// use riprap::run::trials::search;
///
/// let path = Path::new("scenes/verify/planar/g1_plane_failure.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let scene = Scene::load(path, &[])?;
/// let mut trials = 0;
/// let found = search(&scene, &scene.plain(), 1, &|| false, &mut |_| {}, &mut |_| trials += 1)?;
/// assert!(trials > 3 && (found.holds_at - found.fails_at).abs() < 0.01 * found.limit());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn search(
    scene: &Scene,
    case: &Case,
    threads: usize,
    stop: &(dyn Fn() -> bool + Sync),
    look: &mut (dyn FnMut(&mut Look<'_>) + Send),
    report: &mut dyn FnMut(&Trial),
) -> Result<Found, TrialError> {
    let prepared = scene.prepare(case).map_err(TrialError::Scene)?;
    let Some(wanted) = prepared.model.bisect else {
        return Err(TrialError::NoBisect { path: scene.path.clone() });
    };
    let shown = shown(&wanted);
    let digits = digits_for(wanted.tolerance / wanted.low.abs().max(wanted.high.abs()));
    // Trials that are made ahead leave it alone.
    let look = Mutex::new(look);
    let one = |task: &Task<'_, Trial>| -> Result<Option<(State, Trial)>, TrialError> {
        let changed = with_value(case, &wanted.key, task.value, &wanted.unit);
        let mut job = scene.prepare(&changed).map_err(TrialError::Scene)?.job();
        job.checks = vec![wanted.holds.clone()];
        let mut here = |now: &mut Look<'_>| {
            if task.needed
                && let Ok(mut look) = look.lock()
            {
                look(now);
            }
            if stop() || (task.useless)() { Control::Stop } else { Control::Continue }
        };
        let Outcome { ending, checks, .. } = watch_only(job, task.threads, &mut here)?;
        let note = match ending {
            Ending::Finished => String::new(),
            Ending::Stopped if stop() => return Err(TrialError::Stopped),
            Ending::Stopped => return Ok(None),
            Ending::Unstable(why) => why.to_string(),
        };
        let holds = checks.iter().all(|check| check.status == Status::Passed);
        let failed = !note.is_empty() || !holds;
        let measured = checks.first().and_then(|check| check.measured);
        let measured_words = checks.first().map_or_else(String::new, |check| check.words.clone());
        let trial = Trial {
            value: task.value,
            words: shown.text(task.value, digits),
            measured,
            measured_words,
            failed,
            note,
        };
        let state = if failed { State::Failing } else { State::Stable };
        Ok(Some((state, trial)))
    };
    let search = Search::between(wanted.low, wanted.high, wanted.tolerance)
        .map_err(|wrong| TrialError::NoLimit(wrong.to_string()))?;
    let found = drive(search, threads, false, one, |_, _, trial| report(trial))?.search;
    let (Some(holds_at), Some(fails_at)) = (found.holds_at(), found.fails_at()) else {
        let what = match found.holds_at() {
            Some(_) => "holds",
            None => "fails",
        };
        let [low, high] = [wanted.low, wanted.high].map(|end| shown.text(end, digits));
        return Err(TrialError::NoLimit(format!("it {what} at both, {low} and {high}")));
    };
    Ok(Found { key: wanted.key, shown, unit: wanted.unit, holds_at, fails_at, digits })
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
        Space::Spatial(_) => Err(TrialError::OneLaw { path: scene.path.clone() }),
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
        let mut chosen = case.and_then(|name| scene.case(name)).unwrap_or_else(|| scene.plain());
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
        sides.push(Side { law, folder: sub, outcome });
    }
    let differences = compare::folders(&sides[0].folder, &sides[1].folder)?;
    Ok((sides, differences))
}
