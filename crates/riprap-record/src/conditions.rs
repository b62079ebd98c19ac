//! `conditions.json`: what holds, moves and loads a model, for pictures of it.

use super::disk::{OutputError, write_whole};
pub use riprap_core::frame::conditions::{
    Conditions, FaceCondition, FaceKind, GivenLoad, LoadKind, Support, Table,
};
use std::path::{Path, PathBuf};

/// Its file in a run folder.
pub const FILE: &str = "conditions.json";

/// Reads the file of a run; `None` where there is none, as in runs of earlier versions.
///
/// # Errors
/// A file that cannot be read or is damaged: its path and why.
pub fn read(folder: &Path) -> Result<Option<Conditions>, ConditionsError> {
    let path = folder.join(FILE);
    let unusable = |reason: String| ConditionsError { path: path.clone(), reason };
    let text = match crate::read_plain_text(&path) {
        Ok(text) => text,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(e) => return Err(unusable(e.to_string())),
    };
    let found: Conditions = serde_json::from_str(&text).map_err(|e| unusable(e.to_string()))?;
    let whole = |c: &FaceCondition| {
        c.blocks.len() == c.centres.len()
            && [0, c.blocks.len()].contains(&c.tractions.len())
            && [0, c.count].contains(&c.blocks.len())
    };
    if found.faces.iter().all(whole) {
        return Ok(Some(found));
    }
    Err(unusable("its lists have different lengths".to_owned()))
}

/// Writes the file; the old one stays until the new one is complete.
///
/// # Errors
/// Whatever the disk says.
pub fn write(conditions: &Conditions, folder: &Path) -> Result<(), OutputError> {
    let path = folder.join(FILE);
    let mut text = serde_json::to_string(conditions)
        .map_err(|e| OutputError { path: path.clone(), source: e.into() })?;
    text.push('\n');
    write_whole(&path, text.as_bytes())
}

/// Why the conditions of a run cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{} cannot be used: {reason}", path.display())]
pub struct ConditionsError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub reason: String,
}
