//! `riprap self-test`, and the scenes in the program that `riprap verify --shipped` runs.

use std::path::{Path, PathBuf};

use riprap::record::field::nearest;
use riprap::run::checks::CheckResult;
use riprap::run::study::{Executor, verify};

use super::scratch::Scratch;
use crate::commands::{check_line, cores};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::screen;
use crate::templates::SHIPPED;

/// One scene of each engine and of what most users need, all within seconds.
const SCENES: [&str; 10] = [
    "planar/slide.toml",
    "planar/bolted_tunnel.toml",
    "verify/spatial-rigid/b4_patch.toml",
    "verify/spatial-deformable/c1_patch.toml",
    "verify/spatial-contact/fall_floor.toml",
    "verify/engineering/joint_softening.toml",
    "verify/engineering/water_dam.toml",
    "verify/fluid/detonation.toml",
    "verify/implicit/stack.toml",
    "fracture/spall.toml",
];

/// Scenes of the program in a temporary folder.
pub struct Shipped {
    folder: Scratch,
    /// The scenes with checks among them.
    pub scenes: Vec<PathBuf>,
}

impl Shipped {
    /// Writes the scenes that names mean: `servo`, `planar/servo`, a folder as `verify/planar`, or `all`.
    ///
    /// # Errors
    /// A name that means nothing; a folder that cannot be written.
    pub fn named(names: &[String]) -> Result<Self, Failure> {
        Self::written(&Self::wanted(names)?)
    }

    fn wanted(names: &[String]) -> Result<Vec<&'static str>, Failure> {
        let mut wanted = Vec::new();
        for name in names {
            let mut found: Vec<&str> = scenes().filter(|path| means(name, path)).collect();
            if found.is_empty() {
                // The last word of a folder's path, as `engineering` of verify/engineering.
                found.extend(scenes().filter(|path| is_below(name, path)));
            }
            if found.is_empty() {
                return Err(unknown(name));
            }
            wanted.extend(found);
        }
        Ok(wanted)
    }

    fn written(wanted: &[&str]) -> Result<Self, Failure> {
        let failed = |path: &Path, error: std::io::Error| {
            Failure::Output(format!("could not write {}: {error}", path.display()))
        };
        let folder = Scratch::new().map_err(|error| failed(&std::env::temp_dir(), error))?;
        // With all others: scenes read files beside them and in other folders.
        for (path, text) in SHIPPED {
            let target = folder.path().join(path);
            let parent = target.parent().unwrap_or(folder.path());
            std::fs::create_dir_all(parent).map_err(|error| failed(parent, error))?;
            std::fs::write(&target, text).map_err(|error| failed(&target, error))?;
        }
        let all = wanted.iter().map(|path| folder.path().join(path));
        let mut scenes = Vec::new();
        for path in all {
            // Those without checks are left out, as in a folder.
            let found = verify::scenes_under(&path).map_err(|error| failed(&path, error))?;
            scenes.extend(found.into_iter().filter(|path| has_checks(path)));
        }
        Ok(Self { folder, scenes })
    }

    /// A result, with the name of its scene in the program in place of that of the temporary file.
    pub fn told(&self, mut result: CheckResult) -> CheckResult {
        let folder = self.folder.path();
        if let Ok(name) = Path::new(&result.scene).strip_prefix(folder) {
            result.scene = name.display().to_string();
        }
        result
    }
}

fn has_checks(path: &Path) -> bool {
    std::fs::read_to_string(path).is_ok_and(|text| text.contains("[[checks]]"))
}

/// All scenes of the program, with their folders.
fn scenes() -> impl Iterator<Item = &'static str> + Clone {
    SHIPPED.iter().map(|(path, _)| *path).filter(|path| path.ends_with(".toml"))
}

/// Whether a name means a scene.
fn means(name: &str, path: &str) -> bool {
    let name = name.trim_start_matches("scenes/").trim_end_matches('/');
    let bare = path.trim_end_matches(".toml");
    let name = name.trim_end_matches(".toml");
    // Long ones only by their names.
    let of_folder = |folder: &str| {
        path.strip_prefix(folder)
            .is_some_and(|rest| rest.starts_with('/') && !rest.contains("/long/"))
    };
    (name == "all" && !path.contains("/long/"))
        || bare == name
        || bare.strip_suffix(name).is_some_and(|before| before.ends_with('/'))
        || of_folder(name)
}

/// Whether a scene is in a folder of that name, somewhere on its path. Long ones are run by their names only.
fn is_below(name: &str, path: &str) -> bool {
    let name = name.trim_matches('/');
    !name.is_empty() && path.contains(&format!("/{name}/")) && !path.contains("/long/")
}

fn unknown(name: &str) -> Failure {
    let words = |path: &'static str| path.trim_end_matches(".toml").split('/');
    let meant = match nearest(name, scenes().flat_map(words)) {
        Some(near) => format!("; did you mean {near}?"),
        None => ".".to_owned(),
    };
    Failure::Input(format!(
        "the program has no scene {name:?}{meant} Names are those of files and folders under scenes/, for example planar/slide, verify/planar or all"
    ))
}

pub fn run() -> Result<(), Failure> {
    let shipped = Shipped::written(&SCENES)?;
    let interrupt = Interrupt::listen()?;
    let begun = std::time::Instant::now();
    let executor = Executor { threads: cores(), stop: &|| interrupt.asked() };
    let tally = verify::verify(&shipped.scenes, &[], true, &executor, |result| {
        screen::line(&check_line(&shipped.told(result), true));
    });
    let seconds = begun.elapsed().as_secs_f64();
    screen::line(&format!("{tally} in {} scenes, {seconds:.1} s", shipped.scenes.len()));
    if interrupt.asked() {
        return Err(Failure::Interrupted("not all scenes were run".to_owned()));
    }
    if tally.failed > 0 { Err(Failure::Checks) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_mean_scenes_and_folders() {
        let found = |name: &str| scenes().filter(|path| means(name, path)).count();
        assert_eq!(found("servo"), 1);
        assert_eq!(found("planar/slide"), 1);
        assert_eq!(found("scenes/planar/slide.toml"), 1);
        assert!(found("verify/planar") > 30 && found("all") > 150);
        assert_eq!(found("slid"), 0);
        let shipped = |name: &str| Shipped::wanted(&[name.to_owned()]).map(|s| s.len());
        let count = |name: &str| shipped(name).unwrap();
        assert_eq!(count("engineering"), count("verify/engineering"));
        assert_eq!(count("implicit/"), count("verify/implicit"));
        // The folder itself goes before one of its name inside another.
        assert!(count("planar") < count("verify/planar") + count("planar"));
        for name in ["engin", "long", ""] {
            assert!(shipped(name).is_err(), "{name}");
        }
        let Err(Failure::Input(text)) = Shipped::wanted(&["zzzz".to_owned()]) else {
            panic!("a name that is none was taken");
        };
        assert!(text.contains("\"zzzz\". Names"), "{text}");
        let Err(Failure::Input(text)) = Shipped::wanted(&["slidee".to_owned()]) else {
            panic!("a name that is none was taken");
        };
        assert!(text.contains("did you mean slide?"), "{text}");
    }

    #[test]
    fn scenes_of_the_self_test_are_in_the_program_and_check_themselves() {
        let shipped = Shipped::written(&SCENES).unwrap();
        assert_eq!(shipped.scenes.len(), SCENES.len());
        let quick = &shipped.scenes[2..4];
        let mut told = Vec::new();
        let tally = verify::verify(quick, &[], true, &Executor::ALONE, |result| {
            told.push(shipped.told(result).scene);
        });
        assert!(tally.passed > 20 && tally.failed == 0, "{tally}");
        assert!(told.iter().all(|scene| scene.starts_with("verify/spatial-")), "{told:?}");
    }
}
