//! Files of other tools with blocks or traces: tessellations of Neper, surfaces in STL, drawings in DXF, heights as
//! ASCII raster.
//!
//! As for the meshes of [`super::msh`]: a broken file gives an error with its line or byte, and no count in it is
//! trusted with more memory than the file itself has.

pub mod asc;
pub mod dxf;
mod dxf_pairs;
pub mod stl;
pub mod tess;
#[cfg(test)]
mod tests;

use std::io::Read;
use std::path::Path;

pub use super::msh::{FileError, Place};

/// Largest file accepted, bytes.
pub const MAX_FILE_SIZE: u64 = 64 << 20;

/// Reads a file and gives its bytes to `parse`.
///
/// # Errors
/// A text for the user: no file, too large, what is wrong and where.
pub fn read<T>(
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, FileError>,
) -> Result<T, String> {
    let shown = path.display();
    let cannot = |error: std::io::Error| format!("cannot read {shown}: {error}");
    if path.is_dir() {
        return Err(format!("{shown} is a folder, not a file"));
    }
    let mut bytes = Vec::new();
    std::fs::File::open(path)
        .map_err(cannot)?
        .take(MAX_FILE_SIZE + 1)
        .read_to_end(&mut bytes)
        .map_err(cannot)?;
    if bytes.len() as u64 > MAX_FILE_SIZE {
        return Err(format!(
            "{shown} is larger than {} MiB",
            MAX_FILE_SIZE >> 20
        ));
    }
    parse(&bytes).map_err(|error| format!("{shown}, {error}"))
}

/// An error at a line, counted from 1.
fn at_line(line: usize, text: impl Into<String>) -> FileError {
    FileError {
        place: Place::Line(line),
        text: text.into(),
    }
}

/// An error at a byte, counted from 0.
fn at_byte(byte: usize, text: impl Into<String>) -> FileError {
    FileError {
        place: Place::Byte(byte),
        text: text.into(),
    }
}

/// The bytes of a text without a byte order mark, which editors on Windows put before it.
fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(MARK).unwrap_or(bytes)
}

/// The byte order mark of UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// The first letters of a word of a file, for messages.
fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}
