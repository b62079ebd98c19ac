//! The value of a key at which a named result has a wanted value: `safety = 1.3`, `slip = 5 cm`.
//!
//! The machinery is the [bracket](super::bracket): the result lies below what is wanted at one end of the range and above it at the other. A
//! result need not be monotone; of several values that give it one is found, and what the trials show of it is said.

use super::bracket::{State, Task, drive};
use super::range::{Quantity, Source};
use super::safety::{self, Rules};
use super::trust::{histories, results};
use super::{Executor, StudyError};
use crate::plan::Check;
use crate::plan::shown::{Shown, digits_for};
use crate::run::drive::{Control, Ending, Look};
use crate::run::job::{Job, watch_only};
use crate::run::scene::Scene;
use crate::scenario::Case;
use crate::scenario::units::{self, Dim};

/// The name of the factor of safety among results.
pub const SAFETY: &str = "safety";

/// What a result is to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// Name of a check or of a history, or [`SAFETY`].
    pub result: String,
    /// The value, SI.
    pub value: f64,
    /// Its dimension.
    pub dim: Dim,
    /// The unit in which it was given.
    pub shown: Shown,
}

impl Wanted {
    /// Reads `safety = 1.3` or `slip = 5 cm`.
    ///
    /// # Errors
    /// A text for the user.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::study::find::Wanted;
    ///
    /// let wanted = Wanted::read("slip at the end = 5 cm")?;
    /// assert!(wanted.result == "slip at the end" && (wanted.value - 0.05).abs() < 1e-15);
    /// assert!(Wanted::read("slip").is_err() && Wanted::read("slip = much").is_err());
    /// # Ok::<(), String>(())
    /// ```
    pub fn read(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "{text:?} is not a condition; write for example 'safety = 1.3' or 'slip = 5 cm'"
            )
        };
        let (result, value) = text.rsplit_once('=').ok_or_else(wrong)?;
        let (number, dim) = units::parse(value.trim()).map_err(|_| wrong())?;
        let shown = match units::unit_of(value.trim()) {
            Some((unit, one)) => Shown { unit: unit.to_owned(), one },
            None => Shown::si(""),
        };
        let result = result.trim().trim_matches('`').to_owned();
        if result.is_empty() || !number.is_finite() {
            return Err(wrong());
        }
        Ok(Self { result, value: number, dim, shown })
    }

    /// A value of the result for reading.
    #[must_use]
    pub fn text(&self, value: f64) -> String {
        self.shown.text(value, digits_for(1e-4))
    }

    /// The check that reads it; `None` of the factor of safety.
    fn check(&self, job: &Job) -> Result<Option<Check>, StudyError> {
        let dimension = |unit: &str| units::dimension(unit).unwrap_or(Dim::NONE);
        let of = if self.result == SAFETY {
            None
        } else {
            let mut all = results(job);
            // A history that is a check as well is one result there; here it goes by its own name too.
            let own =
                histories(job).into_iter().filter(|one| !all.iter().any(|r| r.name == one.name));
            let own: Vec<Check> = own.collect();
            all.extend(own);
            let at_end = format!("{} at the end", self.result);
            let named = |name: &str| name == self.result || name == at_end;
            let Some(check) = all.iter().find(|check| named(&check.name)) else {
                let names = all.iter().map(|check| check.name.as_str());
                let known: Vec<&str> = std::iter::once(SAFETY).chain(names).collect();
                return Err(StudyError::Unknown {
                    what: "result",
                    name: self.result.clone(),
                    known: known.join(", "),
                });
            };
            Some(check.clone())
        };
        let unit = of.as_ref().map_or("", |check| check.window.unit(&check.unit));
        let plain = if unit == "-" { "" } else { unit };
        if dimension(plain) != self.dim {
            let unit = if plain.is_empty() { "a plain number" } else { plain };
            return Err(StudyError::Outside(format!(
                "`{}` is in {unit}, which {} is not",
                self.result,
                self.shown.text(self.value, 6)
            )));
        }
        Ok(of)
    }
}

/// One trial.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Value of the key, SI.
    pub value: f64,
    /// The result, SI; none where the run did not come to its end.
    pub result: Option<f64>,
    /// Why not.
    pub note: String,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The key and the range.
    pub range: Quantity,
    /// Value of the key with the result, SI, where the result lies at or below what is wanted, nearest to it.
    pub below: [f64; 2],
    /// The same above.
    pub above: [f64; 2],
    /// Linear between both: the value of the key, SI.
    pub at: f64,
    /// What the width of each factor of safety leaves open of the value of the key, SI; 0 of other results.
    pub blur: f64,
    /// Whether the result rises or falls all along the trials.
    pub monotone: bool,
    /// Whether runs inside the range did not come to their end, so that the range is wider than asked for.
    pub undecided: bool,
}

/// Searches for the value of a key of a case at which a result is as wanted; `report` is told of every trial.
///
/// # Errors
/// A name of no result, a value that the scene cannot have, a wanted value that does not lie between those at the ends (with both of them).
///
/// # Examples
///
/// The density at which a loaded block presses on its base with 102 kN/m.
///
/// ```
/// use std::path::Path;
///
/// use riprap::run::scene::Scene;
/// use riprap::run::study::Executor;
/// use riprap::run::study::find::{Wanted, find};
/// use riprap::run::study::range::Quantity;
/// use riprap::run::study::safety::Rules;
///
/// let path = Path::new("scenes/verify/planar/v6_eccentric.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let scene = Scene::load(path, &[])?;
/// let range = Quantity::read("materials.rock.density", "2000 kg/m3..3000 kg/m3", None)?;
/// let wanted = Wanted::read("normal force = 102 kN/m")?;
/// let found = find(&scene, &scene.plain(), (&range, &wanted), &Rules::default(), &Executor::ALONE, &mut |_| {})?;
/// // 75 kN/m and 10 m3/s2 of weight.
/// assert!((found.at - 2700.0).abs() < 1.0 && found.monotone);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn find(
    scene: &Scene,
    case: &Case,
    (range, wanted): (&Quantity, &Wanted),
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> Result<Found, StudyError> {
    find_changed(&Source::plain(scene, case), (range, wanted), rules, executor, report)
}

/// The same of a case whose jobs are changed.
pub(super) fn find_changed(
    of: &Source<'_>,
    (range, wanted): (&Quantity, &Wanted),
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> Result<Found, StudyError> {
    for end in [range.low, range.high] {
        wanted.check(&of.job(Some((range, end)))?)?;
    }
    let one = |task: &Task<'_, Trial>| {
        let job = of.job(Some((range, task.value)))?;
        let trial = match wanted.check(&job)? {
            Some(check) => measured(job, check, task)?,
            None => factor(job, rules, task)?,
        };
        let state = match trial.result {
            Some(result) if result <= wanted.value => State::Stable,
            Some(_) => State::Failing,
            None => State::Undecided,
        };
        Ok::<_, StudyError>((state, trial))
    };
    let mut trials: Vec<Trial> = Vec::new();
    let search = range.search().map_err(|wrong| StudyError::NoLimit(wrong.to_string()))?;
    let found = drive(search, false, executor, one, |_, _, trial: &Trial| {
        report(trial);
        trials.push(trial.clone());
    })?;
    let end = |trial: Option<Trial>| trial.and_then(|one| Some([one.value, one.result?]));
    let (Some(below), Some(above)) = (end(found.holding), end(found.failing)) else {
        return Err(outside(range, wanted, &trials));
    };
    let share = (wanted.value - below[1]) / (above[1] - below[1]);
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 };
    trials.sort_by(|a, b| a.value.total_cmp(&b.value));
    let results: Vec<f64> = trials.iter().filter_map(|one| one.result).collect();
    let rises = results.windows(2).all(|pair| pair[1] >= pair[0]);
    let falls = results.windows(2).all(|pair| pair[1] <= pair[0]);
    Ok(Found {
        range: range.clone(),
        below,
        above,
        at: below[0] + share * (above[0] - below[0]),
        blur: if wanted.result == SAFETY { blur(&trials, wanted.value, rules.width) } else { 0.0 },
        monotone: rises || falls,
        undecided: found.search.undecided(),
    })
}

/// Half the width of a factor over the slope between the nearest trials that lie clearly below and above what is wanted: nearer ones differ by
/// no more than the width. `trials` are sorted by the key.
fn blur(trials: &[Trial], wanted: f64, width: f64) -> f64 {
    let clear = |side: f64| {
        let of = move |one: &Trial| Some([one.value, one.result?]);
        let found =
            trials.iter().filter_map(of).filter(move |one| side * (one[1] - wanted) >= width);
        found.min_by(|a, b| (side * a[1]).total_cmp(&(side * b[1])))
    };
    let (Some(below), Some(above)) = (clear(-1.0), clear(1.0)) else {
        return 0.0;
    };
    0.5 * width * ((above[0] - below[0]) / (above[1] - below[1])).abs()
}

/// Both ends lie on one side of what is wanted, or have no result.
fn outside(range: &Quantity, wanted: &Wanted, trials: &[Trial]) -> StudyError {
    let end = |value: f64| {
        let key = range.shown.text(value, 6);
        match trials.iter().find(|one| one.value == value) {
            Some(Trial { result: Some(result), .. }) => {
                format!("{} at {key}", wanted.text(*result))
            }
            Some(Trial { note, .. }) => format!("nothing at {key} ({note})"),
            None => format!("nothing at {key}"),
        }
    };
    StudyError::Outside(format!(
        "`{}` is {} and {}, {} does not lie between them; give another range",
        wanted.result,
        end(range.low),
        end(range.high),
        wanted.text(wanted.value)
    ))
}

/// A run for a check.
fn measured(mut job: Job, check: Check, task: &Task<'_, Trial>) -> Result<Trial, StudyError> {
    job.checks = vec![check];
    let mut look = |_: &mut Look<'_>| Control::stop_if((task.cancelled)());
    let outcome = watch_only(job, task.threads.max(1), &mut look)?;
    let ran = outcome.checks.into_iter().next();
    let (result, note) = match outcome.ending {
        Ending::Stopped => return Err(StudyError::Stopped),
        Ending::Unstable(why) => (None, why.to_string()),
        Ending::Finished => ran.map_or((None, String::new()), |ran| {
            let result = ran.measured.filter(|value| value.is_finite());
            (result, if result.is_some() { String::new() } else { ran.note })
        }),
    };
    Ok(Trial { value: task.value, result, note })
}

/// A search for the factor of safety.
fn factor(job: Job, rules: &Rules, task: &Task<'_, Trial>) -> Result<Trial, StudyError> {
    let executor = Executor { threads: task.threads.max(1), stop: task.cancelled };
    let answer = safety::search(&job.setup, &job.plan, rules, &executor, &mut |_| {})?;
    let result = match (answer.stable_at, answer.fails_at) {
        // Somewhere in a range that no trial has narrowed.
        _ if answer.undecided => None,
        (Some(stable), Some(fails)) => Some(0.5 * (stable + fails)),
        // Beyond what is tried strength does not decide: it lies above or below whatever is wanted.
        (Some(stable), None) => Some(stable),
        (None, Some(fails)) => Some(fails),
        (None, None) => None,
    };
    let note = if result.is_some() { String::new() } else { answer.words() };
    Ok(Trial { value: task.value, result, note })
}
