//! Fuzz targets: functions of bytes that must never panic, hang or give a wrong answer, whatever the bytes are.
//!
//! Two drivers call them: the test of this crate (a short run, the same in every run of CI) and `cargo run -p riprap-fuzz` (as long as one
//! likes). Both start from the files of `corpus/TARGET` and from those with which the readers are tested, damage them by chance, and go on
//! from what was taken. An input that was once a fault stays in the corpus.

pub mod damage;
#[cfg(feature = "targets")]
mod driver;
#[cfg(feature = "targets")]
mod kernels;
#[cfg(feature = "targets")]
mod readers;
#[cfg(feature = "targets")]
mod scenes;

#[cfg(feature = "targets")]
pub use driver::{Outcome, Seeds, Tally, attempt, bound_memory, campaign, campaign_after, seeds};

/// One way into the program.
#[cfg(feature = "targets")]
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Its name, and that of its folder in `corpus`.
    pub name: &'static str,
    /// What it does.
    pub about: &'static str,
    /// Whether its inputs are texts: lines, numbers and words are changed then, not bytes alone.
    pub text: bool,
    /// Takes the bytes; whether they were taken for what they should be. Panics where something is wrong.
    pub run: fn(&[u8]) -> bool,
    /// Makes inputs that no file can hold: those of a format that changes.
    pub made: fn() -> Vec<Vec<u8>>,
    /// Whether every change must be refused.
    pub sealed: bool,
    /// Executions in the short run: about a second each, a few for what builds models.
    pub short: u64,
}

/// All targets.
#[cfg(feature = "targets")]
pub const TARGETS: &[Target] = &[
    text(
        "formula",
        "formulas of time and place, compiled and evaluated",
        readers::formula,
        40_000,
    ),
    text("quantity", "numbers with units", readers::quantity, 40_000),
    text(
        "columns",
        "columns of a CSV file with units",
        readers::columns,
        20_000,
    ),
    text("table", "histories of a run", readers::table, 20_000),
    text("dxf", "drawings", readers::dxf, 10_000),
    text("tess", "cells of a tessellation", readers::tess, 5_000),
    text("asc", "grids of heights", readers::asc, 10_000),
    bytes(
        "stl",
        "surfaces, as solids and as terrain",
        readers::stl,
        10_000,
    ),
    bytes("msh", "meshes", readers::msh, 5_000),
    bytes("vtu", "frames of a run", readers::vtu, 5_000),
    Target {
        made: readers::sound_checkpoint,
        sealed: true,
        ..bytes(
            "checkpoint",
            "checkpoints of a run, of which every damaged one must be refused",
            readers::checkpoint,
            5_000,
        )
    },
    text(
        "scene",
        "scenes, from the text to the third step",
        scenes::first_steps,
        300,
    ),
    bytes(
        "clip",
        "polygons cut by a line and laid over each other: areas add up",
        kernels::clip,
        20_000,
    ),
    bytes(
        "cut",
        "polyhedra cut by planes: volumes add up, parts are sound",
        kernels::cut,
        4_000,
    ),
    bytes(
        "contact",
        "two polyhedra in each other: forces are finite, closed and do not depend on the order",
        kernels::contact,
        10_000,
    ),
];

#[cfg(feature = "targets")]
const fn text(
    name: &'static str,
    about: &'static str,
    run: fn(&[u8]) -> bool,
    short: u64,
) -> Target {
    Target {
        name,
        about,
        text: true,
        run,
        made: Vec::new,
        sealed: false,
        short,
    }
}

#[cfg(feature = "targets")]
const fn bytes(
    name: &'static str,
    about: &'static str,
    run: fn(&[u8]) -> bool,
    short: u64,
) -> Target {
    Target {
        text: false,
        ..text(name, about, run, short)
    }
}

/// The target of that name.
#[cfg(feature = "targets")]
#[must_use]
pub fn target(name: &str) -> Option<&'static Target> {
    TARGETS.iter().find(|target| target.name == name)
}

#[cfg(all(test, feature = "targets"))]
mod tests {
    use super::*;

    /// The same damage in every run: a failure comes again with `cargo run -p riprap-fuzz -- --target NAME FILE`.
    #[test]
    fn no_target_fails_in_a_short_run() {
        bound_memory().unwrap();
        for target in TARGETS {
            let seeds = seeds(target).unwrap();
            assert!(!seeds.files.is_empty(), "{}: no corpus", target.name);
            assert!(
                seeds.files.iter().any(|(_, bytes)| (target.run)(bytes)),
                "{}: no file of its corpus is taken",
                target.name
            );
            let tally = campaign(target, &seeds, 1, target.short);
            assert!(
                tally.failures.is_empty(),
                "{}: {:#?}",
                target.name,
                tally.failures
            );
            // Damage that is always refused tests the first line of a reader alone.
            assert!(
                tally.taken > 0 || target.sealed,
                "{}: nothing damaged was taken",
                target.name
            );
        }
    }

    #[test]
    fn a_panic_is_a_failure_that_is_kept() {
        fn fails(bytes: &[u8]) -> bool {
            assert!(bytes.len() != 3, "three bytes");
            true
        }
        let target = Target {
            run: fails,
            ..TARGETS[0]
        };
        assert_eq!(attempt(&target, b"ab"), Outcome::Taken);
        assert_eq!(
            attempt(&target, b"abc"),
            Outcome::Failed("three bytes".to_owned())
        );
    }
}
