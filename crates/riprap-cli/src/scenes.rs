//! From the words on the command line to a scene.

use std::path::Path;

use riprap::scenario::{self, Parsed};

use crate::args::{Change, Scene};
use crate::failure::Failure;

/// Reads the scene with the changes the user asked for.
pub fn load(scene: &Scene) -> Result<Parsed, Failure> {
    load_changed(&scene.file, &scene.change)
}

/// Reads `file` with `change`.
pub fn load_changed(file: &Path, change: &Change) -> Result<Parsed, Failure> {
    let parsed = scenario::load(file, &change.set)?;
    let Some(wanted) = &change.case else {
        return Ok(parsed);
    };
    let cases = scenario::cases(&parsed.source, &parsed.scenario)?;
    let Some(case) = cases.iter().find(|case| case.name == *wanted) else {
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        return Err(Failure::Input(format!(
            "{} has no case {wanted:?}; its cases are {}",
            file.display(),
            names.join(", ")
        )));
    };
    let mut chosen = scenario::parse(case.source(&parsed.source)?)?;
    chosen.folder = parsed.folder;
    Ok(chosen)
}
