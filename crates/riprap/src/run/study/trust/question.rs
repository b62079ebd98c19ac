//! What the runs are asked for: named results of one run, or the answer of a search.

use crate::plan::shown::Shown;
use crate::plan::{Check, Expected, Gauge, Window};
use crate::run::study::find::{self, Found, Wanted};
use crate::run::study::range::{Quantity, Source};
use crate::run::study::safety::{self, Answer};
use crate::run::study::{Executor, StudyError};

/// What the runs are asked for.
#[derive(Clone, Copy, Debug)]
pub enum Question<'a> {
    /// The checks and histories of the scene.
    Results,
    /// The factor of safety, or with `over` the limit of a key.
    Safety {
        /// How the search is made.
        rules: &'a safety::Rules,
        /// The key.
        over: Option<&'a Quantity>,
        /// What the search gave for the scene as it stands, if that is known.
        known: Option<&'a Answer>,
    },
    /// The value of a key at which a result is as wanted.
    Find {
        /// The key and its range.
        range: &'a Quantity,
        /// The result and its value.
        wanted: &'a Wanted,
        /// How factors of safety are searched for.
        rules: &'a safety::Rules,
        /// What the search gave for the scene as it stands and its wall time, s, if that is known.
        known: Option<(&'a Found, f64)>,
    },
}

/// What a search gave.
#[derive(Clone, Debug, Default)]
pub(super) struct Searched {
    /// The middle of the range that it left, or a value in it; none where it found no range.
    pub(super) value: Option<f64>,
    /// Half the width of that range, with what the width of a search in each trial leaves open.
    pub(super) half: f64,
    /// Steps of all trials, where they are known.
    pub(super) steps: u64,
    /// Wall time of all trials, s, where it is known.
    pub(super) seconds: Option<f64>,
    /// Why there is no value.
    pub(super) note: String,
}

impl Searched {
    fn found(found: &Found, seconds: Option<f64>) -> Self {
        let half = 0.5 * (found.above[0] - found.below[0]).abs() + found.blur;
        Self { value: Some(found.at), half, seconds, ..Self::default() }
    }

    fn of(answer: &Answer) -> Self {
        let both = answer.stable_at.zip(answer.fails_at);
        Self {
            value: both.map(|(stable, fails)| 0.5 * (stable + fails)),
            half: both.map_or(0.0, |(stable, fails)| 0.5 * (fails - stable).abs()),
            steps: answer.trials.iter().map(|trial| trial.steps).sum(),
            seconds: Some(answer.trials.iter().map(|trial| trial.seconds).sum()),
            note: if both.is_some() { String::new() } else { answer.words() },
        }
    }
}

impl Question<'_> {
    /// The one result of a search, as a check that expects nothing; none of [`Self::Results`].
    pub(super) fn result(&self) -> Option<Check> {
        let (name, range) = match self {
            Self::Results => return None,
            Self::Safety { over: None, .. } => ("factor of safety".to_owned(), None),
            Self::Safety { over: Some(range), .. } => {
                (format!("limit of {}", range.key), Some(*range))
            }
            Self::Find { range, wanted, .. } => {
                let wants =
                    format!("{} for {} = {}", range.key, wanted.result, wanted.text(wanted.value));
                (wants, Some(*range))
            }
        };
        let unit = range.map_or("", |range| &range.unit);
        Some(Check {
            name,
            gauge: Gauge::default(),
            unit: if unit.is_empty() { "-".to_owned() } else { unit.to_owned() },
            shown: Some(range.map_or_else(|| Shown::si(""), |range| range.shown.clone())),
            window: Window::End,
            expected: Expected::Between(f64::NEG_INFINITY, f64::INFINITY),
            relative: None,
            absolute: None,
            known: None,
        })
    }

    /// Whether each trial asks if blocks stand or fail, from one equilibrium to the next.
    pub(super) fn is_of_rest(&self) -> bool {
        match self {
            Self::Results => false,
            Self::Safety { .. } => true,
            Self::Find { wanted, .. } => wanted.result == find::SAFETY,
        }
    }

    /// What is known of the scene as it stands.
    pub(super) fn known(&self) -> Option<Searched> {
        match self {
            Self::Safety { known, .. } => known.map(Searched::of),
            Self::Find { known, .. } => {
                known.map(|(found, seconds)| Searched::found(found, Some(seconds)))
            }
            Self::Results => None,
        }
    }

    /// Makes the search; one of [`Self::Results`] finds nothing.
    pub(super) fn search(
        &self,
        of: &Source<'_>,
        executor: &Executor<'_>,
    ) -> Result<Searched, StudyError> {
        match self {
            Self::Results => Ok(Searched::default()),
            Self::Safety { rules, over: Some(range), .. } => {
                let found = safety::over_changed(of, range, rules, executor, &mut |_| {})?;
                Ok(Searched::of(&found))
            }
            Self::Safety { rules, over: None, .. } => {
                let job = of.job(None)?;
                let found = safety::search(&job.setup, &job.plan, rules, executor, &mut |_| {})?;
                Ok(Searched::of(&found))
            }
            Self::Find { range, wanted, rules, .. } => {
                let found = find::find_changed(of, (range, wanted), rules, executor, &mut |_| {})?;
                Ok(Searched::found(&found, None))
            }
        }
    }
}
