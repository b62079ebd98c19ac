//! The search of `[bisect]`: the value of a key at which a scene begins to fail.

use std::sync::Mutex;

use super::bracket::{State, Task, drive};
use super::range::Quantity;
use super::{Executor, StudyError};
use crate::plan::shown::digits_for;
use crate::run::checks::Status;
use crate::run::drive::{Control, Ending, Look};
use crate::run::job::{Outcome, watch_only};
use crate::run::scene::Scene;
use crate::run::simulation::PhaseEnd;
use crate::scenario::Case;

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
    /// How the run ended when it was not at its end, or what is wrong with the end of one of its phases.
    pub note: String,
}

/// What a search found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The key and the values that were searched.
    pub range: Quantity,
    /// The value nearest to the limit that holds, SI.
    pub holds_at: f64,
    /// The value nearest to the limit that fails, SI.
    pub fails_at: f64,
}

impl Found {
    /// The middle between the value that holds and the one that fails.
    #[must_use]
    pub fn limit(&self) -> f64 {
        0.5 * (self.holds_at + self.fails_at)
    }
}

/// A value for reading: in the unit of the scene, with the digits that the tolerance of the search makes meaningful.
#[must_use]
pub fn words(range: &Quantity, value: f64) -> String {
    range.shown.text(value, digits_for(range.width / range.low.abs().max(range.high.abs())))
}

/// Searches for the value at which a case of `scene` begins to fail; `look` sees the runs that are needed.
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
/// use riprap::run::study::Executor;
/// use riprap::run::study::bisect::bisect;
///
/// let path = Path::new("scenes/verify/planar/g1_plane_failure.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let scene = Scene::load(path, &[])?;
/// let mut trials = 0;
/// let found = bisect(&scene, &scene.plain(), &Executor::ALONE, &mut |_| {}, &mut |_| trials += 1)?;
/// assert!(trials > 3 && (found.holds_at - found.fails_at).abs() < 0.01 * found.limit());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bisect(
    scene: &Scene,
    case: &Case,
    executor: &Executor<'_>,
    look: &mut (dyn FnMut(&mut Look<'_>) + Send),
    report: &mut dyn FnMut(&Trial),
) -> Result<Found, StudyError> {
    let Some(wanted) = scene.prepare(case)?.model.bisect else {
        return Err(StudyError::NoBisect { path: scene.path.clone() });
    };
    let range = Quantity::from(&wanted);
    // Trials that are made ahead leave it alone.
    let look = Mutex::new(look);
    let one = |task: &Task<'_, Trial>| {
        let mut job = range.prepare(scene, case, task.value)?.job();
        job.checks = vec![wanted.holds.clone()];
        let mut here = |now: &mut Look<'_>| {
            if task.needed
                && let Ok(mut look) = look.lock()
            {
                look(now);
            }
            Control::stop_if((task.cancelled)())
        };
        let Outcome { ending, mut checks, ends, .. } = watch_only(job, task.threads, &mut here)?;
        let (stopped, note) = match ending {
            Ending::Finished => {
                (false, ends.iter().find_map(PhaseEnd::warning).unwrap_or_default())
            }
            Ending::Stopped => return Err(StudyError::Stopped),
            Ending::Unstable(why) => (true, why.to_string()),
        };
        let failed = stopped || checks.iter().any(|check| check.status != Status::Passed);
        let check = checks.pop();
        let trial = Trial {
            value: task.value,
            words: words(&range, task.value),
            measured: check.as_ref().and_then(|check| check.measured),
            measured_words: check.map_or_else(String::new, |check| check.words),
            failed,
            note,
        };
        Ok((if failed { State::Failing } else { State::Stable }, trial))
    };
    let search = range.search().map_err(|wrong| StudyError::NoLimit(wrong.to_string()))?;
    let found = drive(search, false, executor, one, |_, _, trial| report(trial))?.search;
    match (found.holds_at(), found.fails_at()) {
        (Some(holds_at), Some(fails_at)) => Ok(Found { range, holds_at, fails_at }),
        (holds_at, _) => {
            let what = if holds_at.is_some() { "holds" } else { "fails" };
            let [low, high] = [range.low, range.high].map(|end| words(&range, end));
            Err(StudyError::NoLimit(format!("it {what} at both, {low} and {high}")))
        }
    }
}
