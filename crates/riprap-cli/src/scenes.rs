//! From the words on the command line to a scene and one of its cases.

use std::path::{Path, PathBuf};

use riprap::record::field::nearest;
use riprap::run::scene::{Prepared, Scene};
use riprap::scenario::{Case, Diagnostics};

use crate::args::{self, Change};
use crate::diagnostics::{self, Style};
use crate::failure::Failure;

/// Reads the scene and prepares the case the user asked for; prints its warnings, and unless `quiet` notes.
pub fn prepare(scene: &args::Scene, style: Style, quiet: bool) -> Result<Prepared, Failure> {
    prepare_file(&scene.file, &scene.change, style, quiet)
}

/// Reads the scene and finds the case the user asked for.
pub fn chosen(scene: &args::Scene) -> Result<(Scene, Case), Failure> {
    let read = load(&scene.file, &scene.change)?;
    let case = case(&read, &scene.change)?;
    Ok((read, case))
}

/// Reads a scene. A file that is not there is answered with the one beside it that was meant, if there is one.
pub fn load(file: &Path, change: &Change) -> Result<Scene, Failure> {
    Scene::load(file, &change.set).map_err(|error| match meant(file) {
        Some(_) => Failure::Input(missing(file)),
        None => Failure::from(error),
    })
}

/// What is said of a file that is not there, with the one beside it that was meant, if there is one.
pub fn missing(file: &Path) -> String {
    let meant = meant(file).map(|meant| format!("; did you mean {}?", meant.display()));
    format!("{} does not exist{}", file.display(), meant.unwrap_or_default())
}

/// The scene whose name is nearest to that of a file which does not exist.
fn meant(file: &Path) -> Option<PathBuf> {
    if file.exists() {
        return None;
    }
    let folder = file.parent().filter(|p| !p.as_os_str().is_empty());
    let entries = std::fs::read_dir(folder.unwrap_or(Path::new("."))).ok()?;
    let mut names: Vec<String> = entries
        .flatten()
        .filter_map(|entry| entry.file_name().into_string().ok())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    // A folder is listed in any order; of names that are as near the same one is to be offered.
    names.sort();
    let name = file.file_name()?.to_string_lossy();
    let with_end = format!("{}.toml", name.trim_end_matches(".toml"));
    let near = nearest(&with_end, names.iter().map(String::as_str))?;
    Some(folder.map_or_else(|| PathBuf::from(near), |f| f.join(near)))
}

/// Cases that a note names.
const NAMED: usize = 6;

/// As [`prepare`], for a file and changes.
pub fn prepare_file(
    file: &Path,
    change: &Change,
    style: Style,
    quiet: bool,
) -> Result<Prepared, Failure> {
    let scene = load(file, change)?;
    prepare_case(&scene, &case(&scene, change)?, change, style, quiet)
}

/// As [`prepare`], for a scene that has been read.
pub fn prepare_case(
    scene: &Scene,
    case: &Case,
    change: &Change,
    style: Style,
    quiet: bool,
) -> Result<Prepared, Failure> {
    let prepared = scene.prepare(case)?;
    // Whoever asks for quiet wants warnings all the same.
    warn(&prepared, style);
    if !quiet {
        let random = &scene.parsed.scenario.distributions;
        if let (Some(wanted), false) = (&scene.parsed.scenario.monte_carlo, random.is_empty()) {
            let count = random.names().count();
            let values = if count == 1 { "value" } else { "values" };
            diagnostics::print_line(
                "note",
                &format!(
                    "this scene has {count} random {values}; `riprap monte-carlo` runs its {} samples, this command the scene as it stands",
                    wanted.samples
                ),
            );
        }
        if change.case.is_none() && scene.cases.len() > 1 {
            let names: Vec<&str> = scene.cases.iter().map(|case| case.name.as_str()).collect();
            let count = names.len();
            let more = if count > NAMED { ", ..." } else { "" };
            let names = names[..count.min(NAMED)].join(", ");
            diagnostics::print_line(
                "note",
                &format!(
                    "this scene has {count} cases; `riprap sweep` runs all, `--case` runs one: {names}{more}"
                ),
            );
        }
    }
    Ok(prepared)
}

/// Prints the warnings of a prepared case.
pub fn warn(prepared: &Prepared, style: Style) {
    let warnings = prepared.model.warnings.clone();
    if !warnings.is_empty() {
        diagnostics::print(&Diagnostics::new(prepared.parsed.source.clone(), warnings), style);
    }
}

/// The case the user asked for; without a name the scene as it stands.
pub fn case(scene: &Scene, change: &Change) -> Result<Case, Failure> {
    let Some(wanted) = &change.case else {
        return Ok(scene.plain());
    };
    scene.case(wanted).ok_or_else(|| {
        let names: Vec<&str> = scene.cases.iter().map(|case| case.name.as_str()).collect();
        Failure::Input(format!(
            "{} has no case {wanted:?}; valid cases: {}",
            scene.path.display(),
            names.join(", ")
        ))
    })
}
