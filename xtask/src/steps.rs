//! The steps of `cargo xtask test`, in the order in which they are worth knowing.

use std::path::Path;
use std::process::Command;
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Instant;

use crate::shell::{Counts, cargo};
use crate::{attack, book, browser, licences, modules, python, shell, tidy, verify, vtk};

/// How a step ended, if it could run at all.
pub enum Outcome {
    /// What it counted. A step that counts nothing itself is one check.
    Counted(Counts),
    /// It did not run; the reason.
    Skipped(String),
}

/// One step.
pub struct Step {
    pub name: &'static str,
    pub about: &'static str,
    /// Steps that must be done before, where they are chosen.
    after: &'static [&'static str],
    /// What no two steps may use at once.
    uses: Option<&'static str>,
    run: fn(&Path) -> Result<Outcome, String>,
}

/// The Python environment in `target/venv`.
const VENV: Option<&str> = Some("target/venv");

const fn step(
    name: &'static str,
    about: &'static str,
    run: fn(&Path) -> Result<Outcome, String>,
) -> Step {
    Step { name, about, after: &[], uses: None, run }
}

/// A step that runs what `build` has compiled.
const fn built(
    name: &'static str,
    about: &'static str,
    uses: Option<&'static str>,
    run: fn(&Path) -> Result<Outcome, String>,
) -> Step {
    Step { name, about, after: &["build"], uses, run }
}

/// All steps, in the order in which they begin.
pub const STEPS: &[Step] = &[
    step(
        "build",
        "compiles tests, scenes' binary and examples once, with debug assertions",
        build_step,
    ),
    step("modules", "which crate uses which, circles of modules, forbidden words", modules_step),
    step("tidy", "file lengths, trailing blanks, paths outside", tidy_step),
    step("table", "the verification table shows which of its rows are stale", verify::table_step),
    step("fmt", "rustfmt --check", fmt_step),
    step("licences", "licences of all dependencies", licences_step),
    step("clippy", "clippy on all targets, warnings denied", clippy_step),
    step("docs", "cargo doc, warnings denied; the book", docs_step),
    // The browser begins first and the tests last of the long ones: it keeps one core busy, they use both.
    built("browser", "the viewer in Chromium, over real runs", VENV, browser::step),
    built(
        "scenes",
        "riprap verify on the fast scenes; the first steps of the long ones",
        None,
        verify::fast,
    ),
    built("tests", "unit, property, CLI and doc tests", None, tests_step),
    built(
        "attack",
        "damaged input, kills, threads and speed, a few tries each",
        None,
        attack::step,
    ),
    built("python", "the wheel, installed and tested with pytest", VENV, python::step),
    built("vtk", "VTK opens the frames of a run", VENV, vtk::step),
];

/// Runs the steps named in `only` (all when empty), two at a time where cores allow. All run even if one fails, but for
/// those that need its result.
pub fn run(root: &Path, only: &[&str]) -> Result<bool, String> {
    if let Some(unknown) = only.iter().find(|name| STEPS.iter().all(|s| s.name != **name)) {
        let names: Vec<&str> = STEPS.iter().map(|s| s.name).collect();
        return Err(format!("there is no step {unknown:?}; the steps are {}", names.join(", ")));
    }
    let begun = Instant::now();
    let chosen: Vec<&Step> =
        STEPS.iter().filter(|s| only.is_empty() || only.contains(&s.name)).collect();
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let reports = side_by_side(root, &chosen, cores.min(2));
    let mut total = Counts::default();
    println!("\n== summary ({:.0} s)", begun.elapsed().as_secs_f64());
    println!("{:<9} {:>9}  result", "step", "seconds");
    for (step, report) in chosen.iter().zip(&reports) {
        total.add(report.counts);
        println!("{:<9} {:>9.1}  {}", step.name, report.seconds, report.said);
        for line in &report.failures {
            println!("{:<9} {:>9}  {line}", "", "");
        }
    }
    println!("{} passed, {} failed, {} skipped", total.passed, total.failed, total.skipped);
    Ok(total.failed == 0)
}

/// How a step ended.
#[derive(Clone, Debug, Default)]
struct Report {
    counts: Counts,
    seconds: f64,
    said: String,
    /// The lines of its output that name what failed.
    failures: Vec<String>,
}

/// Where a step is.
#[derive(Clone, Debug)]
enum State {
    Waiting,
    Running,
    Done(Report),
}

/// Runs `steps` on `workers` threads, each step when all it needs are done; reports in the order of `steps`.
fn side_by_side(root: &Path, steps: &[&Step], workers: usize) -> Vec<Report> {
    let states = Mutex::new(vec![State::Waiting; steps.len()]);
    let changed = Condvar::new();
    // A step that panics is a mistake of ours: the lock then means nothing, and the panic is passed on.
    let lock = || states.lock().unwrap_or_else(PoisonError::into_inner);
    std::thread::scope(|scope| {
        for _ in 0..workers.max(1) {
            scope.spawn(|| {
                loop {
                    let mut now = lock();
                    let next = loop {
                        if let Some(k) = ready(steps, &now) {
                            break k;
                        }
                        if !now.iter().any(|s| matches!(s, State::Waiting)) {
                            return;
                        }
                        now = changed.wait(now).unwrap_or_else(PoisonError::into_inner);
                    };
                    let lost = lost(steps, &now, next);
                    now[next] = State::Running;
                    drop(now);
                    let report = match lost {
                        Some(before) => failed(&format!("`{before}` failed")),
                        None => shell::speaking_as(steps[next].name, || perform(root, steps[next])),
                    };
                    lock()[next] = State::Done(report);
                    changed.notify_all();
                }
            });
        }
    });
    let states = states.into_inner().unwrap_or_else(PoisonError::into_inner);
    let report = |state| match state {
        State::Done(report) => report,
        State::Waiting | State::Running => failed("did not finish"),
    };
    states.into_iter().map(report).collect()
}

/// The first waiting step that may begin.
fn ready(steps: &[&Step], states: &[State]) -> Option<usize> {
    let place = |name: &str| steps.iter().position(|s| s.name == name);
    (0..steps.len()).find(|&k| {
        let all_before = steps[k]
            .after
            .iter()
            .filter_map(|name| place(name))
            .all(|b| matches!(states[b], State::Done(_)));
        let in_use = steps[k].uses.is_some()
            && (0..steps.len())
                .any(|b| matches!(states[b], State::Running) && steps[b].uses == steps[k].uses);
        matches!(states[k], State::Waiting) && all_before && !in_use
    })
}

/// A step that `k` needs and that failed.
fn lost(steps: &[&Step], states: &[State], k: usize) -> Option<&'static str> {
    let bad = |name: &str| {
        let place = steps.iter().position(|s| s.name == name);
        place.is_some_and(|b| matches!(&states[b], State::Done(r) if r.counts.failed > 0))
    };
    steps[k].after.iter().copied().find(|name| bad(name))
}

fn failed(why: &str) -> Report {
    let counts = Counts { failed: 1, ..Counts::default() };
    Report { counts, said: format!("FAILED  {why}"), ..Report::default() }
}

fn perform(root: &Path, step: &Step) -> Report {
    println!("\n== {}: {}", step.name, step.about);
    let start = Instant::now();
    shell::failures();
    let result = (step.run)(root);
    let seconds = start.elapsed().as_secs_f64();
    let report = match result {
        Ok(Outcome::Counted(counts)) => {
            let word = if counts.failed == 0 { "ok" } else { "FAILED" };
            let said = format!("{word:<7} {} passed, {} failed", counts.passed, counts.failed);
            let failures = if counts.failed == 0 { Vec::new() } else { shell::failures() };
            Report { counts, seconds, said, failures }
        }
        Ok(Outcome::Skipped(why)) => Report {
            counts: Counts { skipped: 1, ..Counts::default() },
            seconds,
            said: format!("skipped {why}"),
            failures: Vec::new(),
        },
        Err(why) => Report { seconds, failures: shell::failures(), ..failed(&why) },
    };
    println!("-- {}: {} ({seconds:.1} s)", step.name, report.said);
    report
}

/// `cargo xtask docs`.
pub fn docs_only(root: &Path) -> Result<bool, String> {
    let good = matches!(docs_step(root)?, Outcome::Counted(Counts { failed: 0, .. }));
    if good {
        println!("open target/doc/riprap/index.html");
    }
    Ok(good)
}

/// `cargo xtask pages`: the tests of pages that `tests` leaves out.
pub fn pages(root: &Path) -> Result<bool, String> {
    let words = ["test", "--workspace", "--locked", "--profile", "ci", "--test", "all"];
    let mut command = Command::new(cargo());
    command.args(words).args(["--", "--ignored", "ten_problems_long"]);
    Ok(shell::run(root, &mut command)?.success)
}

/// One check, or as many failures as were found.
fn one_check(failures: u64) -> Outcome {
    Outcome::Counted(Counts { passed: u64::from(failures == 0), failed: failures, skipped: 0 })
}

fn modules_step(root: &Path) -> Result<Outcome, String> {
    modules::check(root).map(one_check)
}

fn tidy_step(root: &Path) -> Result<Outcome, String> {
    tidy::check(root).map(one_check)
}

fn licences_step(root: &Path) -> Result<Outcome, String> {
    licences::check(root).map(one_check)
}

/// Runs cargo with `words`; one check.
fn cargo_check(root: &Path, words: &[&str], env: &[(&str, &str)]) -> Result<Outcome, String> {
    let mut command = Command::new(cargo());
    command.args(words).envs(env.iter().copied());
    let done = shell::run(root, &mut command)?;
    Ok(one_check(u64::from(!done.success)))
}

/// Whether `cargo <tool>` exists; if not, rustup is asked for it once.
fn component(tool: &str, component: &str) -> Result<(), String> {
    let there = || {
        Command::new(cargo()).args([tool, "--version"]).output().is_ok_and(|o| o.status.success())
    };
    if there() {
        return Ok(());
    }
    println!("{tool} is missing; asking rustup for it");
    let _ = Command::new("rustup").args(["component", "add", component]).status();
    if there() { Ok(()) } else { Err(format!("install it: rustup component add {component}")) }
}

fn fmt_step(root: &Path) -> Result<Outcome, String> {
    component("fmt", "rustfmt")?;
    cargo_check(root, &["fmt", "--all", "--", "--check"], &[])
}

fn clippy_step(root: &Path) -> Result<Outcome, String> {
    component("clippy", "clippy")?;
    let words = ["clippy", "--workspace", "--all-targets", "--locked", "--", "-D", "warnings"];
    cargo_check(root, &words, &[])
}

/// Compiles with the one profile that tests, scenes, wheel and browser share. Always the same command: another choice of
/// packages would have other features and compile dependencies anew.
fn build_step(root: &Path) -> Result<Outcome, String> {
    let words = ["test", "--workspace", "--locked", "--profile", "ci", "--no-run"];
    cargo_check(root, &words, &[])
}

/// Property tests draw the same cases in every run of CI: what fails there fails everywhere, and only with the change that made it
/// fail. `PROPTEST_RNG_SEED=N cargo xtask test tests` and `cargo test` look elsewhere.
const PROPTEST_SEED: (&str, &str) = ("PROPTEST_RNG_SEED", "20261122");

fn tests_step(root: &Path) -> Result<Outcome, String> {
    let mut command = Command::new(cargo());
    command.args(["test", "--workspace", "--locked", "--profile", "ci"]);
    command.arg("--no-fail-fast");
    if std::env::var_os(PROPTEST_SEED.0).is_none() {
        command.env(PROPTEST_SEED.0, PROPTEST_SEED.1);
    }
    let done = shell::run(root, &mut command)?;
    let mut counts = done.counts;
    if !done.success && counts.failed == 0 {
        // It did not compile, or a test process died before it could say its result.
        counts.failed = 1;
    }
    Ok(Outcome::Counted(counts))
}

fn docs_step(root: &Path) -> Result<Outcome, String> {
    let words = ["doc", "--workspace", "--no-deps", "--locked", "--document-private-items"];
    let api = cargo_check(root, &words, &[("RUSTDOCFLAGS", "-D warnings")])?;
    book::build(root)?;
    Ok(api)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    static CLOCK: AtomicUsize = AtomicUsize::new(0);
    static IN_USE: AtomicUsize = AtomicUsize::new(0);

    fn good(_: &Path) -> Result<Outcome, String> {
        CLOCK.fetch_add(1, Ordering::SeqCst);
        Ok(one_check(0))
    }

    fn bad(_: &Path) -> Result<Outcome, String> {
        Err("no".to_owned())
    }

    fn alone(_: &Path) -> Result<Outcome, String> {
        let others = IN_USE.fetch_add(1, Ordering::SeqCst);
        std::thread::sleep(std::time::Duration::from_millis(20));
        IN_USE.fetch_sub(1, Ordering::SeqCst);
        Ok(one_check(others as u64))
    }

    #[test]
    fn steps_wait_for_what_they_need_and_never_share_what_they_use() {
        let mut steps = [
            step("build", "", bad),
            step("free", "", good),
            built("needs", "", None, good),
            built("needs too", "", None, good),
            step("x", "", alone),
            step("y", "", alone),
            step("z", "", alone),
        ];
        for step in &mut steps[4..] {
            step.uses = VENV;
        }
        let all: Vec<&Step> = steps.iter().collect();
        let reports = side_by_side(Path::new("."), &all, 2);
        let failed: Vec<u64> = reports.iter().map(|r| r.counts.failed).collect();
        assert_eq!(failed, [1, 0, 1, 1, 0, 0, 0]);
        // What needs a step that failed does not begin.
        assert_eq!(CLOCK.load(Ordering::SeqCst), 1);
        assert!(reports[2].said.contains("`build` failed"));
    }

    #[test]
    fn a_step_chosen_alone_waits_for_nothing() {
        let only = built("needs", "", None, |_| Ok(one_check(0)));
        let reports = side_by_side(Path::new("."), &[&only], 2);
        assert_eq!(reports[0].counts.passed, 1);
    }

    #[test]
    fn every_need_is_a_step() {
        for name in STEPS.iter().flat_map(|s| s.after) {
            assert!(STEPS.iter().any(|s| s.name == *name), "{name}");
        }
    }
}
