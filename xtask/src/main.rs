//! The tasks of the repository: `cargo xtask <task>`.
//!
//! `test` is exactly what CI runs. Every step is a plain function that prints what it finds; the
//! runner adds a headline, the time, and one closing line `N passed, N failed, N skipped`.

mod attack;
mod bench;
mod book;
mod browser;
mod cut;
mod fuzz;
mod licences;
mod modules;
mod mutate;
mod python;
mod shell;
mod soak;
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
  attack [ATTACK]...
                   damage, kill, crowd and hurry the program: attack / tries / failures; --tries N (1500), --page writes
                   docs/src/reliability.md, --binary FILE takes a program that is there
  fuzz [TARGET]... readers, scenes and kernels under bytes that are guided by the code that they reach: target / inputs / edges / failures;
                   needs a C++ compiler; --seconds N (600) for each, --seed K; --keep: what reached new code goes into crates/riprap-fuzz/found
  mutate [SCENE]...
                   break scenes on purpose (gravity, stiffness, friction, strength, loads, time ...) and list the checks that never fail;
                   --seconds S (3): only scenes as quick as that; --binary FILE
  soak             an hour of a run that never ends beside a viewer: memory, descriptors, speed; writes docs/src/soak.md;
                   --minutes N (60), --binary FILE; --table: run nothing, write the page from docs/src/soak.csv
  arrows CRATE [rooms]
                   print each module of a crate, or each room, with those that it uses
  bench            time the steps of both engines in three sizes; prints CSV, keeps it in target/
  wheel [portable] build the Python package: a release wheel in target/wheels; portable: for Linux from glibc 2.17 on
  docs             build the API documentation (and the book, where mdbook is installed)

Examples:
  cargo xtask test
  cargo xtask test modules fmt clippy
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let root = source_tree::root();
    match words.as_slice() {
        ["test", only @ ..] => steps::run(&root, only),
        ["steps"] => {
            for step in steps::STEPS {
                println!("{:<10} {}", step.name, step.about);
            }
            ExitCode::SUCCESS
        }
        ["verify-all", scenes @ ..] => verify::all(&root, scenes),
        ["attack", words @ ..] => attack::run(&root, words),
        ["fuzz", words @ ..] => fuzz::run(&root, words),
        ["mutate", words @ ..] => mutate::run(&root, words),
        ["soak", words @ ..] => soak::run(&root, words),
        ["arrows", name] | ["arrows", name, "rooms"] => {
            match modules::print_arrows(&root, name, words.len() == 3) {
                Ok(()) => ExitCode::SUCCESS,
                Err(why) => {
                    eprintln!("{why}");
                    ExitCode::FAILURE
                }
            }
        }
        ["bench"] => bench::run(&root),
        ["wheel"] | ["wheel", "portable"] => match python::wheel(&root, words.len() == 2) {
            Ok(path) => {
                println!("pip install {}", path.display());
                ExitCode::SUCCESS
            }
            Err(why) => {
                eprintln!("{why}");
                ExitCode::FAILURE
            }
        },
        ["docs"] => steps::docs_only(&root),
        [] | ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            ExitCode::SUCCESS
        }
        [other, ..] => {
            eprintln!("there is no task {other:?}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}
