//! Scenes that check themselves: found, run side by side, reported in order.

use std::path::{Path, PathBuf};

use super::checks::{CheckResult, Status, Watch};
use super::drive::{Control, Ending, Look};
use super::job::{Job, watch_only};
use super::scene::Scene;
use super::trials;
use crate::exec::side_by_side;
use crate::plan::Check;
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

/// A case to run, or why the scene cannot be read.
type Item = Result<(Scene, Case), String>;

/// Runs every case of `scenes` on `jobs` threads and hands the results to `report`, scene by scene
/// and case by case in the order of the files. `stop` is asked about ten times a second.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::run::verify::{scenes_under, verify};
///
/// let path = Path::new("scenes/verify/planar/rest.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let tally = verify(&scenes_under(path)?, false, 1, &|| false, |result| println!("{}", result.words));
/// assert!(tally.passed > 0 && tally.failed == 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn verify(
    scenes: &[PathBuf],
    strict: bool,
    jobs: usize,
    stop: &(dyn Fn() -> bool + Sync),
    mut report: impl FnMut(CheckResult),
) -> Tally {
    let mut work: Vec<(PathBuf, Item)> = Vec::new();
    for path in scenes {
        match Scene::load(path, &[]) {
            Ok(scene) => {
                let cases = scene.cases.clone();
                work.extend(cases.into_iter().map(|c| (path.clone(), Ok((scene.clone(), c)))));
            }
            Err(wrong) => work.push((path.clone(), Err(wrong.render()))),
        }
    }
    let mut tally = Tally::default();
    side_by_side(
        jobs,
        &work,
        |(path, item)| match item {
            Ok((scene, case)) => verify_case(scene, case, strict, stop),
            Err(wrong) => vec![broken(path, "", "the scene can be read", wrong)],
        },
        |results| {
            for result in results {
                tally.add(&result);
                report(result);
            }
        },
    );
    tally
}

fn verify_case(
    scene: &Scene,
    case: &Case,
    strict: bool,
    stop: &(dyn Fn() -> bool + Sync),
) -> Vec<CheckResult> {
    let name = if scene.cases.len() > 1 { case.name.as_str() } else { "" };
    let failed = |what: &str, why: String| vec![broken(&scene.path, name, what, &why)];
    if stop() {
        return failed("the scene runs", "stopped by the user".to_owned());
    }
    let prepared = match scene.prepare(case) {
        Ok(prepared) => prepared,
        Err(wrong) => return failed("the model can be built", wrong.render()),
    };
    let of_limit = prepared.model.bisect.as_ref().map(|b| b.checks.clone());
    let job = prepared.job();
    let mut results = Vec::new();
    if !job.checks.is_empty() {
        results.extend(verify_run(scene, name, job, strict, stop));
    }
    if let Some(checks) = of_limit.filter(|checks| !checks.is_empty()) {
        results.extend(verify_limit(scene, case, name, checks, strict, stop));
    }
    results
}

/// Searches for the limit of `[bisect]` and holds it against the checks that read it.
fn verify_limit(
    scene: &Scene,
    case: &Case,
    name: &str,
    checks: Vec<Check>,
    strict: bool,
    stop: &(dyn Fn() -> bool + Sync),
) -> Vec<CheckResult> {
    match trials::search(scene, case, 1, stop, &mut |_| {}, &mut |_| {}) {
        Err(wrong) => {
            let why = wrong.to_string();
            vec![broken(&scene.path, name, "the limit is found", &why)]
        }
        Ok(found) => {
            let path = scene.path.display().to_string();
            let limit = found.limit();
            let compare = |check: Check| {
                let mut watch = Watch::new(check);
                watch.observe(0.0, limit);
                watch.finish(&path, name, strict)
            };
            checks.into_iter().map(compare).collect()
        }
    }
}

fn verify_run(
    scene: &Scene,
    name: &str,
    job: Job,
    strict: bool,
    stop: &(dyn Fn() -> bool + Sync),
) -> Vec<CheckResult> {
    let failed = |what: &str, why: String| vec![broken(&scene.path, name, what, &why)];
    let mut look = |_: &mut Look<'_>| {
        if stop() { Control::Stop } else { Control::Continue }
    };
    match watch_only(job, 1, &mut look) {
        Err(wrong) => failed("the scene runs", wrong.to_string()),
        Ok(outcome) => {
            let mut results = outcome.checks;
            if strict {
                for result in &mut results {
                    if result.status == Status::Skipped {
                        result.status = Status::Failed;
                    }
                }
            }
            match outcome.ending {
                Ending::Finished => {}
                Ending::Stopped => {
                    results.extend(failed("the scene runs", "stopped by the user".to_owned()));
                }
                Ending::Unstable(why) => {
                    results.extend(failed("the physics holds", why.to_string()));
                }
            }
            results
        }
    }
}

/// A scene that did not come to its checks counts as one failed check.
fn broken(path: &Path, case: &str, check: &str, why: &str) -> CheckResult {
    CheckResult {
        scene: path.display().to_string(),
        case: case.to_owned(),
        check: check.to_owned(),
        status: Status::Failed,
        measured: None,
        expected: String::new(),
        words: String::new(),
        tolerance: String::new(),
        unit: String::new(),
        note: why.trim_end().to_owned(),
    }
}
