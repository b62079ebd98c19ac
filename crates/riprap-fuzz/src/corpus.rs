//! The files that damage starts from.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// Written by hand, or an input that was once a fault: a folder for each target.
const BY_HAND: &str = "corpus";
/// What guided runs found: few inputs that reach much of the code that they reached.
const FOUND: &str = "found";
/// Files that the tests of the readers have: those with the name of a target as their extension belong to its corpus too.
const DATA: [&str; 2] =
    ["../riprap-scenario/tests/data/msh", "../riprap-scenario/tests/data/shapes"];

/// The folder of this crate.
#[must_use]
pub fn folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files of a target: those that somebody wrote, sorted, then what was found.
///
/// # Errors
/// A folder cannot be read.
pub fn all(target: &str) -> io::Result<Vec<PathBuf>> {
    let mut paths = listed(&folder().join(BY_HAND).join(target))?;
    for data in DATA {
        let all = listed(&folder().join(data))?;
        let own = |path: &PathBuf| path.extension().is_some_and(|e| e == target);
        paths.extend(all.into_iter().filter(own));
    }
    paths.sort();
    paths.extend(listed(&folder().join(FOUND).join(target))?);
    Ok(paths)
}

/// The files in a folder, sorted; none if there is no such folder.
///
/// # Errors
/// It cannot be read.
pub fn listed(folder: &Path) -> io::Result<Vec<PathBuf>> {
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut paths = entries.collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}
