//! Fuzz targets: functions of bytes that must never panic, hang or give a wrong answer, whatever the bytes are.
//!
//! Two drivers call them: the test of this crate (a short run, the same in every run of CI, or as long as one likes) and libFuzzer, through
//! the package `fuzz/` and cargo-fuzz. The test starts from the files of `corpus/TARGET` and from those with which the readers are tested,
//! damages them by chance, and goes on from what was taken. An input that was once a fault stays in the corpus.

pub mod corpus;
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
pub use driver::{Outcome, Seeds, Tally, altered, attempt, bound_memory, campaign, seeds};

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
    /// Executions in the short run: four seconds of processor time each, twice that for scenes, less where all damage is refused at once.
    pub short: u64,
}

/// All targets.
#[cfg(feature = "targets")]
pub const TARGETS: &[Target] = &[
    text(
        "formula",
        "formulas of time and place, compiled and evaluated",
        readers::formula,
        1_400_000,
    ),
    text("quantity", "numbers with units", readers::quantity, 1_400_000),
    text("columns", "columns of a CSV file with units", readers::columns, 180_000),
    text("table", "histories of a run", readers::table, 220_000),
    text("dxf", "drawings", readers::dxf, 90_000),
    text("tess", "cells of a tessellation", readers::tess, 150_000),
    text("asc", "grids of heights", readers::asc, 2_200_000),
    bytes("stl", "surfaces, as solids and as terrain", readers::stl, 420_000),
    bytes("msh", "meshes", readers::msh, 850_000),
    text(
        "network",
        "fractures of FracMan, dfnWorks and Itasca, records of PEER, solids in OBJ",
        readers::network,
        400_000,
    ),
    bytes("vtu", "frames of a run", readers::vtu, 430_000),
    Target {
        made: readers::sound_checkpoint,
        sealed: true,
        ..bytes(
            "checkpoint",
            "checkpoints of a run, of which every damaged one must be refused",
            readers::checkpoint,
            2_000_000,
        )
    },
    text("scene", "scenes, from the text to the third step", scenes::first_steps, 3_000),
    bytes(
        "clip",
        "polygons cut by a line and laid over each other: areas add up",
        kernels::clip,
        480_000,
    ),
    bytes("cut", "polyhedra cut by planes: volumes add up, parts are sound", kernels::cut, 150_000),
    bytes(
        "contact",
        "two polyhedra in each other: forces are finite, closed and do not depend on the order",
        kernels::contact,
        95_000,
    ),
];

#[cfg(feature = "targets")]
const fn text(
    name: &'static str,
    about: &'static str,
    run: fn(&[u8]) -> bool,
    short: u64,
) -> Target {
    Target { name, about, text: true, run, made: Vec::new, sealed: false, short }
}

#[cfg(feature = "targets")]
const fn bytes(
    name: &'static str,
    about: &'static str,
    run: fn(&[u8]) -> bool,
    short: u64,
) -> Target {
    Target { text: false, ..text(name, about, run, short) }
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

    /// The same damage in every run, unless the environment asks for another seed (`RIPRAP_FUZZ_SEED`), so many tries of each target
    /// (`RIPRAP_FUZZ_TRIES`), one target (`RIPRAP_FUZZ_TARGET`), or the last input in a file (`RIPRAP_FUZZ_LAST`).
    #[test]
    fn no_target_fails_in_a_short_run() {
        bound_memory().unwrap();
        let asked = |what: &str| std::env::var(format!("RIPRAP_FUZZ_{what}")).ok();
        let number = |what: &str| asked(what).map(|text| text.parse::<u64>().expect(what));
        let last = asked("LAST").map(std::path::PathBuf::from);
        let only = asked("TARGET").map(|name| target(&name).expect("a target of that name").name);
        for target in TARGETS.iter().filter(|t| only.is_none_or(|name| name == t.name)) {
            let seeds = seeds(target).unwrap();
            assert!(!seeds.files.is_empty(), "{}: no corpus", target.name);
            let (seed, tries) =
                (number("SEED").unwrap_or(1), number("TRIES").unwrap_or(target.short));
            let tally = campaign(target, &seeds, seed, tries, last.as_deref());
            println!("{}: {} tries, {} taken", target.name, tally.tries, tally.taken);
            assert!(tally.failures.is_empty(), "{}: {:#?}", target.name, tally.failures);
            assert!(tally.sound > 0, "{}: no file of its corpus is taken", target.name);
            // Damage that is always refused tests the first line of a reader alone.
            assert!(tally.taken > 0 || target.sealed, "{}: nothing damaged was taken", target.name);
        }
    }

    /// Each target is a program of the package that is guided by coverage, which CI does not compile.
    #[test]
    fn all_targets_can_be_guided() {
        let folder = corpus::folder().join("../../fuzz");
        let files = corpus::listed(&folder.join("fuzz_targets")).unwrap();
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        assert_eq!(files.len(), TARGETS.len());
        assert_eq!(manifest.matches("[[bin]]").count(), TARGETS.len());
        for Target { name, .. } in TARGETS {
            let program = format!("name = \"{name}\"\npath = \"fuzz_targets/{name}.rs\"");
            assert!(manifest.contains(&program), "fuzz/Cargo.toml: no {name}");
            assert!(folder.join(format!("fuzz_targets/{name}.rs")).exists());
        }
    }

    /// Lines `name = ...` of a lock file, each with its `version = ...`.
    fn locked(file: &std::path::Path) -> Vec<String> {
        let text = std::fs::read_to_string(file).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let named = lines.windows(2).filter(|w| w[0].starts_with("name = "));
        named.map(|w| w.join(", ")).collect()
    }

    #[test]
    fn the_guided_targets_are_built_of_the_same_versions() {
        // What only libFuzzer brings.
        const OWN: [&str; 4] = ["riprap-fuzz-guided", "libfuzzer-sys", "arbitrary", "jobserver"];
        let root = corpus::folder().join("../..");
        let all = locked(&root.join("Cargo.lock"));
        for package in locked(&root.join("fuzz/Cargo.lock")) {
            let own = OWN.iter().any(|name| package.contains(&format!("\"{name}\"")));
            assert!(
                own || all.contains(&package),
                "fuzz/Cargo.lock has {package}, Cargo.lock another: copy Cargo.lock over it, `cargo metadata --manifest-path fuzz/Cargo.toml` does the rest"
            );
        }
    }

    #[test]
    fn a_panic_is_a_failure_that_is_kept() {
        fn fails(bytes: &[u8]) -> bool {
            assert!(bytes.len() != 3, "three bytes");
            true
        }
        let target = Target { run: fails, ..TARGETS[0] };
        assert_eq!(attempt(&target, b"ab"), Outcome::Taken);
        assert_eq!(attempt(&target, b"abc"), Outcome::Failed("three bytes".to_owned()));
    }
}
