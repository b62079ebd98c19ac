//! Samples of the random values of a scene: probability of failure, spread of results, influence of each value.
//!
//! The samples are cases of a [sweep](super::sweep), so that what a sweep can do (parts on many machines, going on after a stop, rows that
//! are kept) is the same here. This module makes the cases before it and reduces the rows after it.

use std::path::Path;

use riprap_core::distribution::{failure_interval, rank_correlation};
use serde::Serialize;

use super::sweep::Row;
use super::{Executor, StudyError};
use crate::record::{OutputError, write_whole};
use crate::run::checks::Status;
use crate::run::drive::Ending;
use crate::run::job::watch_only;
use crate::run::scene::Scene;
use crate::scenario::units::Dim;
use crate::scenario::{Case, sampled_number, samples, units, varied_and_set};

/// The numbers of a study, in its folder.
pub const SUMMARY: &str = "monte_carlo.json";

/// Confidence with which the probability of failure lies in the reported interval.
const LEVEL: f64 = 0.95;

/// The scene with the samples of `case` as its cases.
///
/// # Errors
/// A scene without `[distributions]`, a change of the user that fixes a random value, values that cannot be drawn, a case that is no
/// sound model.
pub fn sampled(scene: &Scene, case: &Case) -> Result<Scene, StudyError> {
    let random: Vec<&str> = scene.parsed.scenario.distributions.names().collect();
    varied_and_set(&scene.parsed.source, ("distributions", &random), &scene.changes)?;
    let cases = samples(&scene.parsed, case)?;
    let asks = scene.prepare(case)?.model.monte_carlo.map(|failing| failing.holds);
    Ok(Scene { cases, asks, ..scene.clone() })
}

/// The share of the samples of `case` that fail, without a folder; a sample that the physics stops counts as one.
///
/// # Errors
/// As [`sampled`]; a run that could not be carried out; the user stopped it.
pub fn probability(scene: &Scene, case: &Case, executor: &Executor<'_>) -> Result<f64, StudyError> {
    let scene = sampled(scene, case)?;
    let one = |case: &Case| -> Result<bool, StudyError> {
        if (executor.stop)() {
            return Err(StudyError::Stopped);
        }
        let mut job = scene.prepare(case)?.job();
        job.checks = scene.asks.iter().cloned().collect();
        let outcome = watch_only(job, 1, &mut |_| executor.control())?;
        match outcome.ending {
            Ending::Stopped => Err(StudyError::Stopped),
            Ending::Unstable(_) => Ok(true),
            Ending::Finished => Ok(outcome.checks.iter().any(|c| c.status != Status::Passed)),
        }
    };
    let mut failed = Ok(0_usize);
    executor.each(&scene.cases, one, |fails| match (&mut failed, fails) {
        (Ok(count), Ok(fails)) => *count += usize::from(fails),
        (Ok(_), Err(wrong)) => failed = Err(wrong),
        (Err(_), _) => {}
    });
    Ok(failed? as f64 / scene.cases.len() as f64)
}

/// What the samples have in common.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Samples asked for.
    pub samples: usize,
    /// Those that ran to their end; all numbers below are about these.
    pub finished: usize,
    /// What failure means; absent where the scene does not say.
    pub failure: Option<Failure>,
    /// The random values.
    pub variables: Vec<Spread>,
    /// The histories of the scene, their last values.
    pub results: Vec<Outcome>,
}

/// How many samples failed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Failure {
    /// The check that a failing sample fails.
    pub check: String,
    /// Samples that failed.
    pub failed: usize,
    /// Their share.
    pub probability: f64,
    /// Interval in which the probability lies with a confidence of 95 % (Clopper and Pearson, for independent samples; those of a
    /// Latin hypercube scatter less).
    pub interval: [f64; 2],
    /// For each random value its rank correlation with failure; absent where all samples fail or none does.
    pub influence: Vec<Option<f64>>,
}

/// Mean, standard deviation and quantiles of a number over the samples, SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Key, or head of the column of the table.
    pub name: String,
    /// SI unit of a key; empty for plain numbers and for histories, whose heads have it.
    pub unit: String,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// 5 %, 50 % and 95 % quantiles.
    pub quantiles: [f64; 3],
}

/// Spread of a result, and what it depends on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// The numbers.
    pub spread: Spread,
    /// For each random value the rank correlation (Spearman) with the result; absent where the result has a single value.
    pub influence: Vec<Option<f64>>,
    /// For each random value the mean of the result in the fifth of the samples with its lowest values, and in that with its highest.
    pub swing: Vec<[f64; 2]>,
}

impl Summary {
    /// Reduces the rows of `scene`, which [`sampled`] made.
    #[must_use]
    pub fn of(scene: &Scene, rows: &[Row]) -> Self {
        let ran: Vec<&Row> = rows.iter().filter(|row| row.finished).collect();
        let keys: Vec<&str> = scene.parsed.scenario.distributions.names().collect();
        let drawn: Vec<Vec<f64>> = keys
            .iter()
            .map(|key| {
                ran.iter()
                    .map(|row| value_of(row, key).map_or(f64::NAN, |(value, _)| value))
                    .collect()
            })
            .collect();
        let unit = |key: &&str| {
            let dim = ran.first().and_then(|row| value_of(row, key)).map(|(_, dim)| dim);
            dim.filter(|dim| *dim != Dim::NONE).map_or_else(String::new, Dim::unit)
        };
        let variables = keys
            .iter()
            .zip(&drawn)
            .map(|(key, values)| Spread::of(key, unit(key), values.clone()))
            .collect();
        let failure = scene.asks.as_ref().map(|asks| Failure::of(&asks.name, &ran, &drawn));
        let mut heads: Vec<&str> = Vec::new();
        for (head, _) in ran.iter().flat_map(|row| &row.last) {
            if !heads.contains(&head.as_str()) {
                heads.push(head);
            }
        }
        let results = heads.iter().map(|head| Outcome::of(head, &ran, &drawn)).collect();
        Summary { samples: scene.cases.len(), finished: ran.len(), failure, variables, results }
    }

    /// Writes the numbers into `folder`.
    ///
    /// # Errors
    /// The disk.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        let path = folder.join(SUMMARY);
        let text = serde_json::to_string_pretty(self).map_err(|wrong| OutputError {
            path: path.clone(),
            source: std::io::Error::other(wrong.to_string()),
        })?;
        write_whole(&path, text.as_bytes())
    }
}

/// The value of a key in a sample, SI.
fn value_of(row: &Row, key: &str) -> Option<(f64, Dim)> {
    // A variant may have changed the key before the sample does.
    let (_, text) = row.changes.iter().rev().find(|(of, _)| of == key)?;
    let dim = units::parse(text.trim_matches('"')).map_or(Dim::NONE, |(_, dim)| dim);
    Some((sampled_number(text)?, dim))
}

impl Failure {
    fn of(check: &str, ran: &[&Row], drawn: &[Vec<f64>]) -> Self {
        let fails = |row: &&Row| {
            row.checks.iter().any(|found| found.check == check && found.status != Status::Passed)
        };
        let each: Vec<f64> = ran.iter().map(|row| f64::from(u8::from(fails(row)))).collect();
        let (failed, all) = (each.iter().filter(|one| **one > 0.0).count(), ran.len());
        Failure {
            check: check.to_owned(),
            failed,
            probability: failed as f64 / all.max(1) as f64,
            interval: failure_interval(failed, all, LEVEL),
            influence: drawn.iter().map(|values| rank_correlation(values, &each)).collect(),
        }
    }
}

impl Spread {
    fn of(name: &str, unit: String, mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
        let quantile = |share: f64| match values.len() {
            0 => f64::NAN,
            count => {
                let at = share * (count - 1) as f64;
                let below = at as usize;
                let above = (below + 1).min(count - 1);
                values[below] + (at - below as f64) * (values[above] - values[below])
            }
        };
        Spread {
            name: name.to_owned(),
            unit,
            mean,
            deviation: libm::sqrt(squares / (n - 1.0).max(1.0)),
            quantiles: [0.05, 0.5, 0.95].map(quantile),
        }
    }
}

impl Outcome {
    fn of(head: &str, ran: &[&Row], drawn: &[Vec<f64>]) -> Self {
        let last = |row: &&Row| row.last.iter().find(|(of, _)| of == head).map(|(_, value)| *value);
        // A history that a sample has not recorded is missing there alone.
        let there: Vec<(usize, f64)> =
            ran.iter().enumerate().filter_map(|(k, row)| Some((k, last(row)?))).collect();
        let values: Vec<f64> = there.iter().map(|(_, value)| *value).collect();
        let beside: Vec<Vec<f64>> =
            drawn.iter().map(|of| there.iter().map(|(k, _)| of[*k]).collect()).collect();
        Outcome {
            influence: beside.iter().map(|of| rank_correlation(of, &values)).collect(),
            swing: beside.iter().map(|of| swing(of, &values)).collect(),
            spread: Spread::of(head, String::new(), values),
        }
    }
}

/// Mean of `values` in the fifth of the samples with the lowest `drawn`, and in that with the highest.
fn swing(drawn: &[f64], values: &[f64]) -> [f64; 2] {
    let mut order: Vec<usize> = (0..drawn.len()).collect();
    order.sort_by(|a, b| drawn[*a].total_cmp(&drawn[*b]));
    let count = drawn.len().div_ceil(5);
    let mean = |of: &[usize]| of.iter().map(|k| values[*k]).sum::<f64>() / of.len() as f64;
    [mean(&order[..count]), mean(&order[order.len() - count..])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::folder::Existing;
    use crate::run::study::sweep::{Part, merged, sweep};
    use crate::scenario::Source;

    /// A block on a slope of 30 deg with random friction: it slides where the friction angle is less than the slope.
    const SLOPE: &str = r#"
riprap = 1
title = "a block on a slope with random friction"
[space.planar]
gravity = ["4.905 m/s2", "-8.4957 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "0.1 GPa/m"
friction_angle = "30 deg"
damping_ratio = 0.5
[distributions]
"interfaces.default.friction_angle" = { normal = { mean = "34 deg", deviation = "4 deg" } }
"materials.rock.density" = { uniform = ["2400 kg/m3", "2600 kg/m3"] }
[monte_carlo]
samples = 20
fails_when = { field = "block.speed", of = "stone", above = "3 cm/s" }
[[blocks]]
name = "ground"
material = "rock"
rectangle = { size = ["4 m", "1 m"], corner = ["-1 m", "-1 m"] }
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
[[supports]]
on.block = "ground"
fixed = {}
[[phases]]
name = "slide"
until = { time = "1 s" }
[[outputs]]
history = { name = "speed", field = "block.speed", of = "stone", every = "0.1 s" }
"#;

    fn scene() -> Scene {
        let source = Source::new("slope.toml", SLOPE);
        let scene = Scene::parse(source, ".".into(), &[]).map_err(|wrong| wrong.render()).unwrap();
        sampled(&scene, &scene.plain()).map_err(|wrong| wrong.to_string()).unwrap()
    }

    fn run(scene: &Scene, folder: &Path, threads: usize) -> Vec<Row> {
        let mut rows = Vec::new();
        sweep(scene, folder, Existing::Refuse, &Executor::ALONE.on(threads), |row| rows.push(row));
        rows
    }

    #[test]
    fn the_samples_that_slide_are_those_with_less_friction_than_slope() {
        let (scene, folder) = (scene(), tempfile::tempdir().unwrap());
        let rows = run(&scene, folder.path(), 2);
        let summary = Summary::of(&scene, &rows);
        let below =
            rows.iter().filter(|row| value_of(row, FRICTION).unwrap().0 < 30f64.to_radians());
        let failure = summary.failure.clone().unwrap();
        assert_eq!((summary.finished, failure.failed), (20, below.count()), "{rows:?}");
        // Of a normal distribution 15.87 % lie more than a deviation below the mean: 3 or 4 of 20 strata.
        assert!((3..=4).contains(&failure.failed), "{failure:?}");
        assert!(failure.interval[0] < 0.1587 && failure.interval[1] > 0.1587, "{failure:?}");
        assert!(failure.influence[0].unwrap() < -0.5, "{failure:?}");
        assert!(failure.influence[1].unwrap().abs() < 0.45, "{failure:?}");
        let speed = &summary.results[0];
        assert_eq!(speed.spread.name, "speed [m/s]");
        assert!(speed.swing[0][0] > 0.05 && speed.swing[0][1] < 1e-3, "{speed:?}");
        // Parts in any order are the same samples, and what is missing is reported.
        let parts = folder.path().join("parts");
        for number in [3, 1] {
            let cases = Part { number, of: 3 }.of(&scene.cases);
            run(&Scene { cases, ..scene.clone() }, &parts, 1);
        }
        let some = merged(&scene, &parts).map_err(|wrong| wrong.render()).unwrap();
        let missing = some.iter().filter(|row| row.ended == "not run").count();
        assert_eq!((some.len(), missing), (20, 7));
        run(
            &Scene { cases: Part { number: 2, of: 3 }.of(&scene.cases), ..scene.clone() },
            &parts,
            1,
        );
        let all = merged(&scene, &parts).map_err(|wrong| wrong.render()).unwrap();
        assert_eq!(Summary::of(&scene, &all), summary);
    }

    const FRICTION: &str = "interfaces.default.friction_angle";

    #[test]
    fn a_random_value_that_the_user_fixes_is_refused() {
        let changes = [(FRICTION.to_owned(), "20 deg".to_owned())];
        let source = Source::new("slope.toml", SLOPE);
        let scene =
            Scene::parse(source, ".".into(), &changes).map_err(|wrong| wrong.render()).unwrap();
        let wrong = sampled(&scene, &scene.plain()).unwrap_err().to_string();
        assert!(wrong.contains("fixes what the scene varies"), "{wrong}");
    }
}
