//! The error of each named result of a scene: its checks, and its histories at their end.
//!
//! A result has errors from several [causes](Cause), and each is measured by changing it and nothing else:
//!
//! | cause | what is changed | towards |
//! |---|---|---|
//! | step | the time step, `safety`, load steps: a half, a quarter | 0, extrapolated where an order is seen |
//! | equilibrium | the limits at which static phases end: a quarter | 0 |
//! | stiffness | stiffness per area of contacts and joints that is given as a number: twice, four times | rigid contact |
//! | damping | dashpots and damping of phases: a half | none |
//! | size | size of cells that the scene generates: twice, a half | 0, extrapolated where an order is seen |
//! | seed | seeds of generated blocks | spread of the realisations |
//! | search | nothing: half the range that a search leaves | |
//!
//! The variants are runs of the same scene side by side; `reduce` makes an interval of what they give. A step that is a thousandth
//! shorter shows what is chaotic: where such a change moves a result as much as half the step does, an order means nothing and the runs are
//! samples of a distribution.
//!
//! Not seen by it: what the scene itself leaves out (joints that were not mapped, a law that is none), and values that were measured with
//! an error, which `[distributions]` and [`monte_carlo`](super::monte_carlo) are for.

mod causes;
mod question;
mod record;
mod reduce;

use std::time::{Duration, Instant};

use serde::Serialize;

use super::range::Source;
use super::{Executor, StudyError};
use crate::plan::shown::Shown;
use crate::plan::{Check, Expected, Window};
use crate::record::field;
use crate::run::checks::CheckResult;
use crate::run::drive::{Control, Ending, Look};
use crate::run::engine::Kind;
use crate::run::job::{Job, JobError, watch_only};
use crate::run::scene::{Prepared, Scene};
use crate::scenario::Case;
pub use causes::Cause;
use causes::Variant;
pub use question::Question;
use question::Searched;
pub use record::{SUMMARY, TABLE, TRIALS};

/// How a study of errors is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// Wall time that all runs may take, s: what is forecast to take longer is left out, and what does is stopped.
    pub budget: f64,
    /// Causes that are left alone: a stiffness that was measured is no error.
    pub without: Vec<Cause>,
}

impl Default for Rules {
    fn default() -> Self {
        Self { budget: 600.0, without: Vec::new() }
    }
}

/// One run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// What was changed; `None`: the scene as it stands.
    pub cause: Option<Cause>,
    /// By what it was multiplied; of a seed the number of the realisation.
    pub factor: f64,
    /// The results, SI, in the order of [`Answer::results`]; absent where the run has none.
    pub values: Vec<Option<f64>>,
    /// Steps.
    pub steps: u64,
    /// Wall time, s.
    pub seconds: f64,
    /// Half the range in which a search has left the value, SI.
    pub half: Option<f64>,
    /// Why it has no results.
    pub note: String,
}

/// What one cause adds to the error of a result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Part {
    /// The cause.
    pub cause: Cause,
    /// Its error, SI.
    pub error: f64,
    /// What the value was moved by, SI: by extrapolation.
    pub moved: f64,
    /// The order that was seen.
    pub order: Option<f64>,
}

/// Distribution of a chaotic result over the runs, SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Number of runs.
    pub samples: usize,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Smallest.
    pub least: f64,
    /// Largest.
    pub largest: f64,
}

/// A named result with its error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Result {
    /// Name of the check; of a history with the words `at the end`.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// The value of the scene as it stands, SI.
    pub as_run: f64,
    /// The value, extrapolated where an order was seen, SI.
    pub value: f64,
    /// Its error, SI: the sum of the parts; not a number where nothing was varied.
    pub error: f64,
    /// What each cause adds, in the order of [`Cause::ALL`].
    pub parts: Vec<Part>,
    /// The runs with other steps as samples, where the result is chaotic.
    pub chaotic: Option<Spread>,
    /// What to change to halve the error, or what else is to be known, in words.
    pub advice: String,
    /// What the check of the scene expects, SI, if that is one number.
    pub expected: Option<f64>,
    /// Difference that the check allows, SI.
    #[serde(skip)]
    pub tolerance: f64,
    /// Unit for reading.
    #[serde(skip)]
    pub shown: Shown,
}

impl Result {
    /// Whether what the check expects lies inside the interval; `None` where either is not known.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        let expected = self.expected.filter(|_| self.error.is_finite());
        expected.map(|truth| (truth - self.value).abs() <= self.error)
    }
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The results, in the order of the scene.
    pub results: Vec<Result>,
    /// All runs, the scene as it stands first.
    pub trials: Vec<Trial>,
    /// Causes that were not varied, and why.
    pub left_out: Vec<(Cause, String)>,
}

/// Runs the scene and its variants and gives each named result its error; `report` is told of every run.
///
/// # Errors
/// A scene without named results, one that cannot be built or whose physics stops it as it stands, the user.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::run::scene::Scene;
/// use riprap::run::study::Executor;
/// use riprap::run::study::trust::{Rules, trust};
///
/// let path = Path::new("scenes/verify/planar/a3_corner_impact.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let scene = Scene::load(path, &[])?;
/// let answer = trust(&scene, &scene.plain(), &Rules::default(), &Executor::ALONE, &mut |_| {})?;
/// let rebound = &answer.results[0];
/// assert!(rebound.name == "rebound speed" && rebound.holds() == Some(true), "{rebound:?}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trust(
    scene: &Scene,
    case: &Case,
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> std::result::Result<Answer, StudyError> {
    trust_in((scene, case), Question::Results, rules, executor, report)
}

/// Whether a scene has named results, before anything is run.
///
/// # Errors
/// It has none.
pub fn has_results(scene: &Scene, prepared: Prepared) -> std::result::Result<(), StudyError> {
    match results(&prepared.job()).is_empty() {
        true => Err(StudyError::NoResults { path: scene.path.clone() }),
        false => Ok(()),
    }
}

/// The same for what [`Question`] asks: results of the scene, or the answer of a search in it, each trial of which is a search with
/// something changed.
///
/// # Errors
/// As [`trust`], and those of the search with the scene as it stands.
pub fn trust_in(
    (scene, case): (&Scene, &Case),
    question: Question<'_>,
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> std::result::Result<Answer, StudyError> {
    let prepared = scene.prepare(case)?;
    let asks = match question.result() {
        Some(one) => vec![one],
        None => results(&prepared.clone().job()),
    };
    if asks.is_empty() {
        return Err(StudyError::NoResults { path: scene.path.clone() });
    }
    let begun = Instant::now();
    let end = begun + Duration::try_from_secs_f64(rules.budget).unwrap_or(Duration::MAX / 4);
    let maker = Maker { scene, case, question, asks: &asks, stop: executor.stop, end: None };
    let (base, first) = maker.run(&Variant::NONE, executor.threads)?;
    if (executor.stop)() {
        return Err(StudyError::Stopped);
    }
    if !base.note.is_empty() {
        return Err(StudyError::Ended(base.note));
    }
    report(&base);
    let (variants, mut left_out) = causes::variants(&prepared, question, rules);
    let mut cost = base.seconds;
    let (here, there): (Vec<Variant>, Vec<Variant>) = variants.into_iter().partition(|one| {
        let fits = cost + one.cost * base.seconds <= rules.budget;
        cost += if fits { one.cost * base.seconds } else { 0.0 };
        fits
    });
    let maker = Maker { end: Some(end), ..maker };
    let mut trials = vec![base];
    maker.all(&here, executor, &mut trials, report)?;
    let chaotic = reduce::chaotic(&trials, &asks);
    if chaotic.iter().any(|is| *is) {
        maker.all(&causes::samples(), executor, &mut trials, report)?;
    }
    for cause in Cause::ALL {
        let of = |list: &[Variant]| list.iter().any(|one| one.cause == Some(cause));
        let ran = trials.iter().any(|one| one.cause == Some(cause) && one.note.is_empty());
        if of(&there) && !of(&here) {
            left_out.push((cause, "its runs do not fit into the budget".to_owned()));
        } else if of(&here) && !ran {
            let why = trials.iter().find(|one| one.cause == Some(cause));
            let why = why.map_or("stopped", |one| one.note.as_str());
            left_out.push((cause, format!("no run came to its end: {why}")));
        }
    }
    let (keys, size) = (causes::Keys::of(&prepared), causes::reach(&prepared.model.setup));
    let results = asks.iter().zip(&first).enumerate().map(|(k, (ask, ran))| {
        let ran = (ran.0, &ran.1[..]);
        reduce::result(k, ask, ran, &trials, chaotic[k], (&keys, size))
    });
    let results = results.collect();
    Ok(Answer { results, trials, left_out })
}

/// The named results: checks but for those of the ledger, which measure an error themselves, and histories at their end.
pub(super) fn results(job: &Job) -> Vec<Check> {
    let of_ledger = |check: &Check| check.gauge.field.starts_with("energy.residual");
    let mut all: Vec<Check> = Vec::new();
    for check in job.checks.iter().filter(|check| !of_ledger(check)) {
        // A result that is checked twice is one result; the first that says a number has the say.
        let same = all.iter_mut().find(|one| {
            one.gauge == check.gauge && one.window == check.window && one.unit == check.unit
        });
        match same {
            Some(one) if matches!(one.expected, Expected::Between(..)) => *one = check.clone(),
            Some(_) => {}
            None => all.push(check.clone()),
        }
    }
    for history in histories(job) {
        let last = |one: &Check| one.gauge == history.gauge && one.window == Window::End;
        if !all.iter().any(last) {
            all.push(history);
        }
    }
    all
}

/// Histories as what is read at the end.
pub(super) fn histories(job: &Job) -> Vec<Check> {
    let kind = Kind::of(&job.setup);
    let of = |history: &crate::plan::History| {
        let (info, _) = field::find(kind.fields(), &history.gauge.field).ok()?;
        Some(Check {
            name: format!("{} at the end", history.name),
            gauge: history.gauge.clone(),
            unit: info.unit.to_owned(),
            shown: None,
            window: Window::End,
            expected: Expected::Between(f64::NEG_INFINITY, f64::INFINITY),
            relative: None,
            absolute: None,
            known: None,
        })
    };
    job.plan.histories.iter().filter_map(of).collect()
}

/// What checks of a run expect, and why they have no value.
type First = Vec<(Option<f64>, String)>;

/// Makes runs.
#[derive(Clone, Copy)]
struct Maker<'a> {
    scene: &'a Scene,
    case: &'a Case,
    question: Question<'a>,
    /// Results of the scene as it stands.
    asks: &'a [Check],
    stop: &'a (dyn Fn() -> bool + Sync),
    /// When the budget is used up.
    end: Option<Instant>,
}

impl Maker<'_> {
    /// Makes the runs of a list side by side.
    fn all(
        &self,
        variants: &[Variant],
        executor: &Executor<'_>,
        trials: &mut Vec<Trial>,
        report: &mut dyn FnMut(&Trial),
    ) -> std::result::Result<(), StudyError> {
        let mut wrong = None;
        executor.each(
            variants,
            |one| self.run(one, 1),
            |ran| match ran {
                Ok((trial, _)) => {
                    report(&trial);
                    trials.push(trial);
                }
                Err(error) => {
                    wrong.get_or_insert(error);
                }
            },
        );
        match wrong {
            _ if (self.stop)() => Err(StudyError::Stopped),
            Some(wrong) => Err(wrong),
            None => Ok(()),
        }
    }

    /// Makes one run. What does not come to its end has no values.
    fn run(
        &self,
        variant: &Variant,
        threads: usize,
    ) -> std::result::Result<(Trial, First), StudyError> {
        let begun = Instant::now();
        let mut trial = Trial {
            cause: variant.cause,
            factor: variant.factor,
            values: vec![None; self.asks.len()],
            steps: 0,
            seconds: 0.0,
            half: None,
            note: String::new(),
        };
        let over = || self.end.is_some_and(|end| Instant::now() >= end);
        if over() {
            trial.note = "the budget was used up".to_owned();
            return Ok((trial, Vec::new()));
        }
        let mut of = self.case.clone();
        of.trial.extend(variant.keys.iter().cloned());
        if !matches!(self.question, Question::Results) {
            return self.search((&of, variant), threads, trial);
        }
        let mut job = match self.scene.prepare(&of) {
            Ok(prepared) => prepared.job(),
            Err(wrong) => {
                trial.note = wrong.render().trim_end().to_owned();
                return Ok((trial, Vec::new()));
            }
        };
        variant.apply(&mut job);
        job.checks = results(&job);
        let mut look = |_: &mut Look<'_>| Control::stop_if((self.stop)() || over());
        let ran = match watch_only(job.clone(), threads, &mut look) {
            // What is stiffer may need a shorter step than the one that is given.
            Err(JobError::Step(_)) if variant.cause == Some(Cause::Stiffness) => {
                causes::shorten(&mut job.plan, 1.0 / libm::sqrt(variant.factor));
                watch_only(job, threads, &mut look)
            }
            ran => ran,
        };
        trial.seconds = begun.elapsed().as_secs_f64();
        let outcome = match ran {
            Ok(outcome) => outcome,
            Err(wrong) if variant.cause.is_none() => return Err(wrong.into()),
            Err(wrong) => {
                trial.note = wrong.to_string();
                return Ok((trial, Vec::new()));
            }
        };
        trial.steps = outcome.manifest.steps;
        trial.note = match &outcome.ending {
            Ending::Finished => String::new(),
            Ending::Stopped => "stopped when the budget was used up".to_owned(),
            Ending::Unstable(why) => why.to_string(),
        };
        if trial.note.is_empty() {
            let value = |(k, ask): (usize, &Check)| {
                let named = |ran: &&CheckResult| ran.check == ask.name;
                // Names need not be unique, places are in scenes that ask the same.
                let here = outcome.checks.get(k).filter(named);
                here.or_else(|| outcome.checks.iter().find(named))?.measured
            };
            trial.values = self.asks.iter().enumerate().map(value).collect();
        }
        let first = outcome.checks.into_iter().map(|ran| (ran.target, ran.note));
        Ok((trial, first.collect()))
    }

    /// Makes a search.
    fn search(
        &self,
        (case, variant): (&Case, &Variant),
        threads: usize,
        mut trial: Trial,
    ) -> std::result::Result<(Trial, First), StudyError> {
        let begun = Instant::now();
        let over = || self.end.is_some_and(|end| Instant::now() >= end);
        let stop = || (self.stop)() || over();
        let edit = |job: &mut Job| variant.apply(job);
        let of = Source { scene: self.scene, case, edit: &edit };
        let known = self.question.known().filter(|_| variant.cause.is_none());
        let found = match known {
            Some(known) => known,
            None => match self.question.search(&of, &Executor { threads, stop: &stop }) {
                Err(StudyError::Stopped) if over() => Searched {
                    note: "stopped when the budget was used up".to_owned(),
                    ..Searched::default()
                },
                Err(wrong) if variant.cause.is_none() => return Err(wrong),
                Err(wrong) => Searched { note: wrong.to_string(), ..Searched::default() },
                Ok(found) => found,
            },
        };
        trial.seconds = found.seconds.unwrap_or_else(|| begun.elapsed().as_secs_f64());
        trial.values = vec![found.value];
        trial.half = Some(found.half).filter(|_| found.value.is_some());
        trial.steps = found.steps;
        trial.note = found.note;
        Ok((trial, vec![(None, String::new())]))
    }
}

#[cfg(test)]
mod tests;
