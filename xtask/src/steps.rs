//! The steps of `cargo xtask test`, in the order in which they are worth knowing.

use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

use crate::shell::{Counts, cargo};
use crate::{browser, licences, modules, python, shell, tidy, verify, vtk};

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
    run: fn(&Path) -> Result<Outcome, String>,
}

/// All steps.
pub const STEPS: &[Step] = &[
    Step {
        name: "modules",
        about: "which crate uses which, circles of modules, forbidden words",
        run: modules_step,
    },
    Step {
        name: "tidy",
        about: "file lengths, trailing blanks, paths outside",
        run: tidy_step,
    },
    Step {
        name: "fmt",
        about: "rustfmt --check",
        run: fmt_step,
    },
    Step {
        name: "clippy",
        about: "clippy on all targets, warnings denied",
        run: clippy_step,
    },
    Step {
        name: "tests",
        about: "unit, property, CLI and doc tests",
        run: tests_step,
    },
    Step {
        name: "docs",
        about: "cargo doc, warnings denied; the book",
        run: docs_step,
    },
    Step {
        name: "scenes",
        about: "riprap verify on the fast scenes (release)",
        run: verify::fast,
    },
    Step {
        name: "vtk",
        about: "VTK opens the frames of a run",
        run: vtk::step,
    },
    Step {
        name: "browser",
        about: "the viewer in Chromium, over real runs",
        run: browser::step,
    },
    Step {
        name: "python",
        about: "the wheel, installed and tested with pytest",
        run: python::step,
    },
    Step {
        name: "licences",
        about: "licences of all dependencies",
        run: licences_step,
    },
];

/// Runs the steps named in `only` (all when empty). All run even if one fails.
pub fn run(root: &Path, only: &[&str]) -> ExitCode {
    if let Some(unknown) = only
        .iter()
        .find(|name| STEPS.iter().all(|s| s.name != **name))
    {
        let names: Vec<&str> = STEPS.iter().map(|s| s.name).collect();
        eprintln!(
            "there is no step {unknown:?}; the steps are {}",
            names.join(", ")
        );
        return ExitCode::from(2);
    }
    let begun = Instant::now();
    let mut total = Counts::default();
    let mut report = Vec::new();
    for step in STEPS
        .iter()
        .filter(|s| only.is_empty() || only.contains(&s.name))
    {
        println!("\n== {}: {}", step.name, step.about);
        let start = Instant::now();
        let result = (step.run)(root);
        let seconds = start.elapsed().as_secs_f64();
        let said = match result {
            Ok(Outcome::Counted(counts)) => {
                total.add(counts);
                let word = if counts.failed == 0 { "ok" } else { "FAILED" };
                format!(
                    "{word:<7} {} passed, {} failed",
                    counts.passed, counts.failed
                )
            }
            Ok(Outcome::Skipped(why)) => {
                total.skipped += 1;
                format!("skipped {why}")
            }
            Err(why) => {
                total.failed += 1;
                format!("FAILED  {why}")
            }
        };
        println!("-- {}: {said} ({seconds:.1} s)", step.name);
        report.push(format!("{:<9} {seconds:>7.1} s  {said}", step.name));
    }
    println!("\n== summary ({:.0} s)", begun.elapsed().as_secs_f64());
    for line in report {
        println!("{line}");
    }
    println!(
        "{} passed, {} failed, {} skipped",
        total.passed, total.failed, total.skipped
    );
    if total.failed == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// `cargo xtask docs`.
pub fn docs_only(root: &Path) -> ExitCode {
    match docs_step(root) {
        Ok(Outcome::Counted(counts)) if counts.failed == 0 => {
            println!("open target/doc/riprap/index.html");
            ExitCode::SUCCESS
        }
        Ok(Outcome::Counted(_) | Outcome::Skipped(_)) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// One check, or as many failures as were found.
fn one_check(failures: u64) -> Outcome {
    Outcome::Counted(Counts {
        passed: u64::from(failures == 0),
        failed: failures,
        skipped: 0,
    })
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
        Command::new(cargo())
            .args([tool, "--version"])
            .output()
            .is_ok_and(|o| o.status.success())
    };
    if there() {
        return Ok(());
    }
    println!("{tool} is missing; asking rustup for it");
    let _ = Command::new("rustup")
        .args(["component", "add", component])
        .status();
    if there() {
        Ok(())
    } else {
        Err(format!("install it: rustup component add {component}"))
    }
}

fn fmt_step(root: &Path) -> Result<Outcome, String> {
    component("fmt", "rustfmt")?;
    cargo_check(root, &["fmt", "--all", "--", "--check"], &[])
}

fn clippy_step(root: &Path) -> Result<Outcome, String> {
    component("clippy", "clippy")?;
    let words = [
        "clippy",
        "--workspace",
        "--all-targets",
        "--locked",
        "--",
        "-D",
        "warnings",
    ];
    cargo_check(root, &words, &[])
}

fn tests_step(root: &Path) -> Result<Outcome, String> {
    let mut command = Command::new(cargo());
    command.args(["test", "--workspace", "--locked", "--no-fail-fast"]);
    let done = shell::run(root, &mut command)?;
    let mut counts = done.counts;
    if !done.success && counts.failed == 0 {
        // It did not compile, or a test process died before it could say its result.
        counts.failed = 1;
    }
    Ok(Outcome::Counted(counts))
}

fn docs_step(root: &Path) -> Result<Outcome, String> {
    let words = [
        "doc",
        "--workspace",
        "--no-deps",
        "--locked",
        "--document-private-items",
    ];
    let api = cargo_check(root, &words, &[("RUSTDOCFLAGS", "-D warnings")])?;
    let has_book = root.join("docs/book.toml").exists();
    let mdbook = Command::new("mdbook").arg("--version").output();
    if has_book && mdbook.is_ok_and(|o| o.status.success()) {
        let mut command = Command::new("mdbook");
        command.args(["build", "docs", "--dest-dir", "../target/book"]);
        if !shell::run(root, &mut command)?.success {
            return Err("mdbook build docs failed".to_owned());
        }
    }
    Ok(api)
}
