//! Files of other tools with blocks, traces, fractures or records: tessellations of Neper, surfaces in STL and OBJ, drawings in DXF, heights as
//! ASCII raster.
//!
//! As for the meshes of [`super::msh`]: a broken file gives an error with its line or byte, and no count in it is
//! trusted with more memory than the file itself has.

pub mod asc;
pub mod at2;
pub mod dfn;
pub mod dfnworks;
pub mod dxf;
mod dxf_pairs;
pub mod itasca;
pub mod obj;
pub mod stl;
pub mod tess;
#[cfg(test)]
mod tests;

use std::path::Path;

pub use super::msh::{FileError, Place};
use super::plain_file;

/// Largest file accepted, bytes.
pub const MAX_FILE_SIZE: u64 = 64 << 20;

/// Why a file could not be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// What is wrong, with the name of the file and the place in it.
    pub message: String,
    /// What to do, where it does not depend on the format.
    pub help: Option<String>,
}

/// Reads a plain file and gives its bytes to `parse`.
///
/// # Errors
/// No plain file, too large, what is wrong and where.
pub fn read<T>(
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, FileError>,
) -> Result<T, Refused> {
    read_up_to(path, MAX_FILE_SIZE, parse)
}

/// As [`read`], for a file of up to `most` bytes.
///
/// # Errors
/// As [`read`].
pub fn read_up_to<T>(
    path: &Path,
    most: u64,
    parse: impl FnOnce(&[u8]) -> Result<T, FileError>,
) -> Result<T, Refused> {
    let bytes = plain_file::read(path, most)
        .map_err(|error| Refused { message: error.message, help: error.help })?;
    parse(&bytes)
        .map_err(|error| Refused { message: format!("`{}`, {error}", path.display()), help: None })
}

/// An error at a line, counted from 1.
fn at_line(line: usize, text: impl Into<String>) -> FileError {
    FileError { place: Place::Line(line), text: text.into() }
}

/// An error at a byte, counted from 0.
fn at_byte(byte: usize, text: impl Into<String>) -> FileError {
    FileError { place: Place::Byte(byte), text: text.into() }
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
