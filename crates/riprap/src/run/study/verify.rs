//! Scenes that check themselves: found, run side by side, reported in order.

use std::path::{Path, PathBuf};

use super::bisect::bisect;
use super::monte_carlo::probability;
use super::{Executor, StudyError};
use crate::plan::Check;
use crate::run::checks::{CheckResult, Status, Watch};
use crate::run::drive::Ending;
use crate::run::job::{Job, watch_only};
use crate::run::scene::Scene;
use crate::scenario::Case;

/// How many checks passed, failed and were skipped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// As expected.
    pub passed: usize,
    /// Not as expected.
    pub failed: usize,
    /// Known to fail.
    pub skipped: usize,
    /// Those of the failed that are no checks: scenes that cannot be read, models that cannot be built.
    pub unread: usize,
}

impl Tally {
    /// Counts one result.
    pub fn add(&mut self, result: &CheckResult) {
        match result.status {
            Status::Passed => self.passed += 1,
            Status::Failed => self.failed += 1,
            Status::Skipped => self.skipped += 1,
        }
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} passed, {} failed, {} skipped", self.passed, self.failed, self.skipped)
    }
}

/// Scene files under `path`: itself if it is a file, otherwise every scene with checks below it.
///
/// A `.toml` file in a folder is a scene when its first key is `riprap`.
///
/// # Errors
/// Folders that cannot be read.
pub fn scenes_under(path: &Path) -> std::io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        // Also what does not exist: reading it says so.
        return Ok(vec![path.to_owned()]);
    }
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(path)?.map(|e| e.map(|e| e.path())).collect::<Result<_, _>>()?;
    entries.sort();
    for entry in entries {
        let is_run = entry.join("manifest.json").exists();
        if entry.is_dir() && !is_run {
            found.extend(scenes_under(&entry)?);
        } else if entry.extension().is_some_and(|e| e == "toml") && has_checks(&entry) {
            found.push(entry);
        }
    }
    Ok(found)
}

fn has_checks(path: &Path) -> bool {
    let text = crate::record::read_plain_text(path).unwrap_or_default();
    let mut keys = text.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with('#'));
    keys.next().is_some_and(|first| first.starts_with("riprap"))
        && text.lines().any(|line| line.trim_start().starts_with("[[checks]]"))
}

/// Runs every case of `scenes` on one thread each and hands the results to `report`, scene by scene and case by case in the order of
/// the files; `set` changes keys of all of them, `strict` counts known failures as failed.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::run::study::Executor;
/// use riprap::run::study::verify::{scenes_under, verify};
///
/// let path = Path::new("scenes/verify/planar/rest.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let tally = verify(&scenes_under(path)?, &[], false, &Executor::ALONE, |result| println!("{}", result.words));
/// assert!(tally.passed > 0 && tally.failed == 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn verify(
    scenes: &[PathBuf],
    set: &[(String, String)],
    strict: bool,
    executor: &Executor<'_>,
    mut report: impl FnMut(CheckResult),
) -> Tally {
    // A case to run, or why the scene cannot be read.
    let mut work: Vec<Result<(Scene, Case), Box<CheckResult>>> = Vec::new();
    for path in scenes {
        match Scene::load(path, set) {
            Ok(scene) => work.extend(scene.cases.iter().map(|c| Ok((scene.clone(), c.clone())))),
            Err(wrong) => {
                let result = broken(path, "", (READ, wrong.render()));
                work.push(Err(Box::new(result)));
            }
        }
    }
    let mut tally = Tally::default();
    let one = |item: &Result<(Scene, Case), Box<CheckResult>>| match item {
        Ok((scene, case)) => verify_case(scene, case, executor),
        Err(wrong) => vec![(**wrong).clone()],
    };
    executor.each(&work, one, |results| {
        for mut result in results {
            if strict && result.status == Status::Skipped {
                result.status = Status::Failed;
            }
            tally.add(&result);
            tally.unread += usize::from(result.check == READ || result.check == BUILT);
            report(result);
        }
    });
    tally
}

/// Said of a scene that is bad input.
const READ: &str = "the scene can be read";
const BUILT: &str = "the model can be built";

/// What was to be, and why it is not.
type Broken = (&'static str, String);

fn verify_case(scene: &Scene, case: &Case, executor: &Executor<'_>) -> Vec<CheckResult> {
    let name = if scene.cases.len() > 1 { case.name.as_str() } else { "" };
    let mut results = Vec::new();
    let broken = |wrong| broken(&scene.path, name, wrong);
    if (executor.stop)() {
        return vec![broken(("the scene runs", "stopped by the user".to_owned()))];
    }
    let prepared = match scene.prepare(case) {
        Ok(prepared) => prepared,
        Err(wrong) => return vec![broken((BUILT, wrong.render()))],
    };
    let of_limit = prepared.model.bisect.as_ref().map_or_else(Vec::new, |b| b.checks.clone());
    let failing = prepared.model.monte_carlo.as_ref();
    let of_samples = failing.map_or_else(Vec::new, |f| f.checks.clone());
    let job = prepared.job();
    if !job.checks.is_empty()
        && let Err(wrong) = verify_run(job, executor, &mut results)
    {
        results.push(broken(wrong));
    }
    // The runs of a study are made one after the other, on the thread of the case.
    let alone = executor.on(1);
    let mut study = |checks: Vec<Check>, what, found: Result<f64, StudyError>| match found {
        Err(wrong) => results.push(broken((what, wrong.to_string()))),
        Ok(found) => results.extend(checks.into_iter().map(|check| {
            let mut watch = Watch::new(check);
            watch.observe(0.0, found);
            watch.finish(&scene.path.display().to_string(), name, false)
        })),
    };
    if !of_limit.is_empty() {
        let found = bisect(scene, case, &alone, &mut |_| {}, &mut |_| {});
        study(of_limit, "the limit is found", found.map(|found| found.limit()));
    }
    if !of_samples.is_empty() {
        study(of_samples, "the samples run", probability(scene, case, &alone));
    }
    results
}

/// Runs a job for its checks.
fn verify_run(
    job: Job,
    executor: &Executor<'_>,
    results: &mut Vec<CheckResult>,
) -> Result<(), Broken> {
    let outcome = watch_only(job, 1, &mut |_| executor.control());
    let outcome = outcome.map_err(|wrong| ("the scene runs", wrong.to_string()))?;
    results.extend(outcome.checks);
    match outcome.ending {
        Ending::Finished => Ok(()),
        Ending::Stopped => Err(("the scene runs", "stopped by the user".to_owned())),
        Ending::Unstable(why) => Err(("the physics holds", why.to_string())),
    }
}

/// A scene that did not come to its checks counts as one failed check.
fn broken(path: &Path, case: &str, (check, why): Broken) -> CheckResult {
    CheckResult {
        scene: path.display().to_string(),
        case: case.to_owned(),
        check: check.to_owned(),
        status: Status::Failed,
        measured: None,
        target: None,
        expected: String::new(),
        words: String::new(),
        tolerance: String::new(),
        unit: String::new(),
        note: why.trim_end().to_owned(),
    }
}
