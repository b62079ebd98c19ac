//! One file a verb. Each turns arguments into calls of the library and answers into text.

pub mod doctor;
pub mod language;
pub mod new;

use std::path::{Path, PathBuf};

/// Where results of `scene` go when the user does not say: `hill.toml` gives `hill.run` in the
/// working folder, so that a scene library is never written into.
pub fn default_folder(scene: &Path, kind: &str) -> PathBuf {
    let stem = scene.file_stem().unwrap_or_default().to_string_lossy();
    PathBuf::from(format!("{stem}.{kind}"))
}
