//! The tasks of the repository: `cargo xtask <task>`.
//!
//! `test` is exactly what CI runs. Every step is a plain function that prints what it finds; the
//! runner adds a headline, the time, and one closing line `N passed, N failed, N skipped`.

mod attack;
mod bench;
mod book;
mod browser;
mod cut;
mod licences;
mod modules;
mod mutate;
mod python;
mod release;
mod shell;
mod source_tree;
mod steps;
mod tidy;
mod venv;
mod verify;
mod vtk;

use std::process::ExitCode;

const HELP: &str = "\
The tasks of the repository.

Usage: cargo xtask <task> [step]...

Tasks:
  test [step]...   formatting, lints, unit, property, doc, CLI and scene tests, docs: what CI runs
  steps            list the steps of `test`
  verify-all [SCENE]...
                   run every scene, the long ones too, and write docs/src/verification.csv and .md;
                   with names: run these and replace their rows
                   --from FILE: take the lines that this program's `riprap verify --json` printed; --table: run nothing, show what is stale;
                   --probes: make the probes that are missing (docs/src/verification_probes.csv)
  pages            run the commands of the book that take minutes
  attack [ATTACK]...
                   damage, kill, crowd and hurry the program: attack / tries / failures; --tries N (1500), --page writes
                   docs/src/reliability.md, --binary FILE takes a program that is there
  mutate [SCENE]...
                   break scenes on purpose (gravity, stiffness, friction, strength, loads, time ...) and list the checks that never fail;
                   --seconds S (3): only scenes as quick as that; --binary FILE
  arrows CRATE [rooms]
                   print each module of a crate, or each room, with those that it uses
  bench            time the steps of both engines in three sizes; prints CSV, keeps it in target/
  bench gas        what gas in cracks costs of a step, beside the same blast with sealed gas
  bench threads    run six models on all threads: how much of each stage is serial, what 16 and 64 threads give at best
  wheel [portable] build the Python package: a release wheel in target/wheels; portable: for Linux from glibc 2.17 on
  release [TARGET]...
                   what a release offers, in target/packages: programs for Linux (static) and Windows with the licences of all libraries,
                   the portable wheel, a container file, checksums; --no-wheel, --profile P (release)
  docs             build the API documentation (and the book, where mdbook is installed)

Examples:
  cargo xtask test
  cargo xtask test modules fmt clippy
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let root = source_tree::root();
    let done = match words.as_slice() {
        ["test", only @ ..] => steps::run(&root, only),
        ["steps"] => {
            for step in steps::STEPS {
                println!("{:<10} {}", step.name, step.about);
            }
            Ok(true)
        }
        ["verify-all", words @ ..] => verify::all(&root, words),
        ["pages"] => steps::pages(&root),
        ["attack", words @ ..] => attack::run(&root, words),
        ["mutate", words @ ..] => mutate::run(&root, words).map(|()| true),
        ["arrows", name] => modules::print_arrows(&root, name, false).map(|()| true),
        ["arrows", name, "rooms"] => modules::print_arrows(&root, name, true).map(|()| true),
        ["bench"] => bench::run(&root),
        ["bench", "gas"] => bench::gas(&root),
        ["bench", "threads"] => bench::threads(&root),
        ["wheel"] => python::wheel(&root, false),
        ["wheel", "portable"] => python::wheel(&root, true),
        ["release", words @ ..] => release::run(&root, words),
        ["docs"] => steps::docs_only(&root),
        [] | ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            Ok(true)
        }
        [other, ..] => Err(format!("there is no task {other:?}\n\n{HELP}")),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::from(2)
        }
    }
}
