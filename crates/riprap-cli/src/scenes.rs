//! From the words on the command line to a scene and one of its cases.

use std::path::Path;

use riprap::run::scene::{Prepared, Scene};
use riprap::scenario::{Case, Diagnostics};

use crate::args::{self, Change};
use crate::diagnostics::{self, Style};
use crate::failure::Failure;

/// Reads the scene and prepares the case the user asked for; prints warnings unless `quiet`.
pub fn prepare(scene: &args::Scene, style: Style, quiet: bool) -> Result<Prepared, Failure> {
    prepare_file(&scene.file, &scene.change, style, quiet)
}

/// As [`prepare`], for a file and changes.
pub fn prepare_file(
    file: &Path,
    change: &Change,
    style: Style,
    quiet: bool,
) -> Result<Prepared, Failure> {
    let scene = Scene::load(file, &change.set)?;
    let case = case(&scene, change)?;
    let prepared = scene.prepare(&case)?;
    if !quiet {
        warn(&prepared, style);
        if change.case.is_none() && scene.cases.len() > 1 {
            let count = scene.cases.len();
            diagnostics::print_line(
                "note",
                &format!("this scene has {count} cases; `riprap sweep` runs them all"),
            );
        }
    }
    Ok(prepared)
}

/// Prints the warnings of a prepared case.
pub fn warn(prepared: &Prepared, style: Style) {
    let warnings = prepared.model.warnings.clone();
    if !warnings.is_empty() {
        diagnostics::print(
            &Diagnostics::new(prepared.parsed.source.clone(), warnings),
            style,
        );
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
            "{} has no case {wanted:?}; its cases are {}",
            scene.path.display(),
            names.join(", ")
        ))
    })
}
