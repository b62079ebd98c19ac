//! Checkpoints: a state to resume from, in a container that knows when it is damaged.
//!
//! Layout, little endian: magic `RIPRAPCK` (8 bytes), format version `u32`, kind (16 bytes, ASCII, zero padded),
//! uncompressed length `u64`, compressed length `u64`, blake3 of all that and of the payload (32 bytes), then the
//! payload: a postcard-encoded serde value in one zlib stream. The checksum is tested before anything is
//! decompressed or decoded, and the lengths before anything is allocated.
//!
//! The two newest checkpoints are kept; [`latest`] falls back to the older one and says why.

use super::disk::{AtPath, OutputError};
use flate2::read::ZlibDecoder;
pub use pack::{Packing, encode, write};
use pack::{checksum, write_as};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::cmp::Ordering;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

const MAGIC: &[u8; 8] = b"RIPRAPCK";
/// Version of the container and of the layout of what the engines put into it; raised whenever a state gains, loses or moves a
/// number. Another version is refused: states have no names in them, and would be read as something else.
pub const FORMAT_VERSION: u32 = 26;
const KIND_BYTES: usize = 16;
const SUM_AT: usize = 8 + 4 + KIND_BYTES + 8 + 8;
const HEAD: usize = SUM_AT + 32;
/// Deflate cannot expand more than 1032:1, so more than this is a lie about the length.
const MAX_RATIO: u64 = 1100;

/// Why a checkpoint cannot be used. Every message names the file and what to do.
#[derive(Debug, thiserror::Error)]
pub enum CheckpointError {
    /// The system would not let us read it.
    #[error("could not read checkpoint {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// It does not begin like a checkpoint.
    #[error("{} is not a riprap checkpoint; give a file from a run folder's checkpoints/", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// Made by a later riprap.
    #[error(
        "checkpoint {} has format version {found}, this riprap reads {FORMAT_VERSION}; resume with the riprap that wrote it or a newer one",
        path.display()
    )]
    Newer {
        /// The file.
        path: PathBuf,
        /// Its format version.
        found: u32,
    },
    /// Made by an earlier riprap.
    #[error(
        "checkpoint {} has format version {found}, this riprap reads {FORMAT_VERSION}; resume with the riprap that wrote it, or run the scene again",
        path.display()
    )]
    Older {
        /// The file.
        path: PathBuf,
        /// Its format version.
        found: u32,
    },
    /// Shorter than it says: the writer or a copy was cut off.
    #[error(
        "checkpoint {} is truncated: it has {found} of {expected} bytes; copy it again or resume from the previous one",
        path.display()
    )]
    Truncated {
        /// The file.
        path: PathBuf,
        /// Bytes there.
        found: u64,
        /// Bytes there should be.
        expected: u64,
    },
    /// Longer than it says.
    #[error(
        "checkpoint {} has {extra} bytes after its end; it was changed after writing, resume from the previous one",
        path.display()
    )]
    Trailing {
        /// The file.
        path: PathBuf,
        /// Bytes too many.
        extra: u64,
    },
    /// The bytes are not those that were written.
    #[error(
        "checkpoint {} is damaged: its checksum does not match; copy it again or resume from the previous one",
        path.display()
    )]
    Checksum {
        /// The file.
        path: PathBuf,
    },
    /// The length in the head cannot be true.
    #[error(
        "checkpoint {} claims to unpack to {claimed} bytes from {compressed}, which is impossible; it is damaged or forged, do not use it",
        path.display()
    )]
    Absurd {
        /// The file.
        path: PathBuf,
        /// Uncompressed length in its head.
        claimed: u64,
        /// Compressed bytes.
        compressed: u64,
    },
    /// A state of something else.
    #[error("checkpoint {} holds a `{found}` state, but a `{wanted}` state is needed", path.display())]
    Kind {
        /// The file.
        path: PathBuf,
        /// What it holds.
        found: String,
        /// What was asked for.
        wanted: String,
    },
    /// A run of another scene wrote it.
    #[error(
        "checkpoint {} belongs to another scene: {found}, but this run is of {wanted}; move it back to the folder of its own run",
        path.display()
    )]
    OtherScene {
        /// The file.
        path: PathBuf,
        /// Its scene.
        found: String,
        /// The scene of the run.
        wanted: String,
    },
    /// Sound container, but the value inside is of another shape.
    #[error(
        "checkpoint {} does not hold the state this riprap ({}) expects ({reason}); resume with the riprap that wrote it (its manifest.json says which)",
        path.display(), env!("CARGO_PKG_VERSION")
    )]
    Decode {
        /// The file.
        path: PathBuf,
        /// What the decoder said.
        reason: String,
    },
    /// No usable checkpoint.
    #[error("{} has no usable checkpoint{}; start the run again", folder.display(), list(broken))]
    None {
        /// The run folder.
        folder: PathBuf,
        /// What was wrong with those there are, newest first.
        broken: Vec<CheckpointError>,
    },
}

impl CheckpointError {
    /// The file, where it may well be whole but is not of this run or this program: nothing for us to remove.
    #[must_use]
    pub fn of_another(&self) -> Option<&Path> {
        match self {
            Self::Foreign { path }
            | Self::Newer { path, .. }
            | Self::Older { path, .. }
            | Self::Kind { path, .. }
            | Self::OtherScene { path, .. }
            | Self::Decode { path, .. } => Some(path),
            Self::Read { .. }
            | Self::Truncated { .. }
            | Self::Trailing { .. }
            | Self::Checksum { .. }
            | Self::Absurd { .. }
            | Self::None { .. } => None,
        }
    }
}

/// Gives a file a name that is free and that no checkpoint has (`.aside`, `.aside2`, ...), so that it is neither read nor replaced.
///
/// # Errors
/// What the system says when renaming.
pub(crate) fn set_aside(path: &Path) -> Result<PathBuf, OutputError> {
    let name = |k: u32| {
        let mut name = path.as_os_str().to_owned();
        name.push(match k {
            1 => ".aside".to_owned(),
            k => format!(".aside{k}"),
        });
        PathBuf::from(name)
    };
    let mut k = 1;
    while name(k).exists() {
        k += 1;
    }
    fs::rename(path, name(k)).at(path)?;
    Ok(name(k))
}

fn list(broken: &[CheckpointError]) -> String {
    broken.iter().map(|b| format!("\n  {b}")).collect()
}

/// The newest good checkpoint of a run folder.
#[derive(Debug)]
pub struct Latest<T> {
    /// Its file.
    pub path: PathBuf,
    /// The state.
    pub value: T,
    /// What was wrong with newer ones, newest first: show these as warnings.
    pub broken: Vec<CheckpointError>,
}

/// Reads a checkpoint of the given kind.
///
/// # Errors
/// See [`CheckpointError`]; never panics, never allocates more than the file can unpack to.
pub fn read<T: DeserializeOwned>(path: &Path, kind: &str) -> Result<T, CheckpointError> {
    let bytes = crate::read_plain(path)
        .map_err(|source| CheckpointError::Read { path: path.to_owned(), source })?;
    decode(&bytes, kind, path)
}

/// Decodes the bytes of a checkpoint file; `path` is only for the messages.
///
/// # Errors
/// As [`read`].
pub fn decode<T: DeserializeOwned>(
    bytes: &[u8],
    kind: &str,
    path: &Path,
) -> Result<T, CheckpointError> {
    let path = || path.to_owned();
    let have = bytes.len() as u64;
    let truncated =
        |expected: u64| CheckpointError::Truncated { path: path(), found: have, expected };
    // Cut off within its first bytes: ours all the same, and not of another program.
    if bytes.len() < MAGIC.len() && MAGIC.starts_with(bytes) {
        return Err(truncated(HEAD as u64));
    }
    if !bytes.starts_with(MAGIC) {
        return Err(CheckpointError::Foreign { path: path() });
    }
    // The version comes before the length: a newer format may have another head.
    if let Some(version) = number::<4>(bytes, 8) {
        let found = u32::from_le_bytes(version);
        let path = path();
        match found.cmp(&FORMAT_VERSION) {
            Ordering::Equal => {}
            Ordering::Greater => return Err(CheckpointError::Newer { path, found }),
            Ordering::Less => return Err(CheckpointError::Older { path, found }),
        }
    }
    let (Some(claimed), Some(packed)) =
        (number::<8>(bytes, SUM_AT - 16), number::<8>(bytes, SUM_AT - 8))
    else {
        return Err(truncated(HEAD as u64));
    };
    let (claimed, packed) = (u64::from_le_bytes(claimed), u64::from_le_bytes(packed));
    let expected = packed.saturating_add(HEAD as u64);
    if have < expected {
        return Err(truncated(expected));
    }
    if have > expected {
        return Err(CheckpointError::Trailing { path: path(), extra: have - expected });
    }
    // Before anything is unpacked by what the head claims.
    if claimed > packed.saturating_mul(MAX_RATIO) {
        return Err(CheckpointError::Absurd { path: path(), claimed, compressed: packed });
    }
    let payload = &bytes[HEAD..];
    // Before the head is believed any further: it is in the sum.
    if checksum(&bytes[..SUM_AT], payload) != bytes[SUM_AT..HEAD] {
        return Err(CheckpointError::Checksum { path: path() });
    }
    let name = &bytes[12..12 + KIND_BYTES];
    let name = &name[..name.iter().position(|b| *b == 0).unwrap_or(KIND_BYTES)];
    if name != kind.as_bytes() {
        let found = String::from_utf8_lossy(name).into_owned();
        return Err(CheckpointError::Kind { path: path(), found, wanted: kind.to_owned() });
    }
    unpacked(payload, claimed).map_err(|reason| CheckpointError::Decode { path: path(), reason })
}

/// The value in a payload that unpacks to so many bytes.
fn unpacked<T: DeserializeOwned>(payload: &[u8], claimed: u64) -> Result<T, String> {
    let mut plain = Vec::new();
    ZlibDecoder::new(payload)
        // One byte beyond what is claimed shows that there is more, and no more than that is held.
        .take(claimed.saturating_add(1))
        .read_to_end(&mut plain)
        .map_err(|e| e.to_string())?;
    if plain.len() as u64 != claimed {
        return Err(format!("{} bytes instead of {claimed}", plain.len()));
    }
    let (value, rest) = postcard::take_from_bytes(&plain).map_err(|e| e.to_string())?;
    if rest.is_empty() { Ok(value) } else { Err(format!("{} bytes left over", rest.len())) }
}

fn number<const N: usize>(bytes: &[u8], at: usize) -> Option<[u8; N]> {
    bytes.get(at..at + N)?.try_into().ok()
}

/// The file of the checkpoint after `step` steps inside `folder/checkpoints/`.
pub fn path_for(folder: &Path, step: u64) -> PathBuf {
    folder.join("checkpoints").join(format!("checkpoint_{step:012}.rck"))
}

/// All checkpoint files of a run folder with their steps, oldest first. A missing folder has none.
///
/// # Errors
/// Whatever the system says when listing.
pub fn all(folder: &Path) -> io::Result<Vec<(u64, PathBuf)>> {
    let mut found = Vec::new();
    let entries = match fs::read_dir(folder.join("checkpoints")) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(found),
        Err(e) => return Err(e),
    };
    for entry in entries {
        let path = entry?.path();
        let step = path
            .file_name()
            .and_then(|n| n.to_str())
            .and_then(|n| n.strip_prefix("checkpoint_"))
            .and_then(|n| n.strip_suffix(".rck"))
            .and_then(|n| n.parse::<u64>().ok());
        if let Some(step) = step {
            found.push((step, path));
        }
    }
    found.sort();
    Ok(found)
}

/// Whether a file is a checkpoint that was being written when its process ended.
pub(crate) fn is_unfinished(file: &Path) -> bool {
    let name = file.file_name().and_then(|n| n.to_str()).unwrap_or("");
    let step = name.strip_prefix("checkpoint_");
    let step = step.and_then(|n| n.strip_suffix(".rck.tmp"));
    step.is_some_and(|n| n.parse::<u64>().is_ok())
}

/// Removes checkpoints that were being written when their process ended: as large as others, and of no use.
pub(crate) fn remove_unfinished(folder: &Path) -> Result<(), OutputError> {
    let folder = folder.join("checkpoints");
    let entries = match fs::read_dir(&folder) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(()),
        entries => entries.at(&folder)?,
    };
    for entry in entries {
        let file = entry.at(&folder)?.path();
        if is_unfinished(&file) {
            fs::remove_file(&file).at(&file)?;
        }
    }
    Ok(())
}

/// Reads the newest good checkpoint of a run folder.
///
/// # Errors
/// [`CheckpointError::None`] with the reasons when there is none.
pub fn latest<T: DeserializeOwned>(
    folder: &Path,
    kind: &str,
) -> Result<Latest<T>, CheckpointError> {
    latest_of(folder, kind, |_, _| Ok(()))
}

/// As [`latest`], of those that `admit` lets pass.
///
/// # Errors
/// As [`latest`].
pub fn latest_of<T: DeserializeOwned>(
    folder: &Path,
    kind: &str,
    admit: impl Fn(&Path, &T) -> Result<(), CheckpointError>,
) -> Result<Latest<T>, CheckpointError> {
    let files =
        all(folder).map_err(|source| CheckpointError::Read { path: folder.to_owned(), source })?;
    let mut broken = Vec::new();
    for (_, path) in files.into_iter().rev() {
        let found = read(&path, kind).and_then(|value| admit(&path, &value).map(|()| value));
        match found {
            Ok(value) => {
                return Ok(Latest { path, value, broken });
            }
            Err(e) => broken.push(e),
        }
    }
    Err(CheckpointError::None { folder: folder.to_owned(), broken })
}

/// Writes the checkpoint after `step` steps and keeps only it and the one before it.
pub(crate) fn write_and_prune<T: Serialize>(
    folder: &Path,
    kind: &str,
    step: u64,
    value: &T,
    packing: Packing,
) -> Result<PathBuf, OutputError> {
    let path = path_for(folder, step);
    write_as(&path, kind, value, packing)?;
    let files = all(folder).at(folder)?;
    let before = files.iter().rev().find(|f| f.0 < step).map(|f| f.0);
    for (other, file) in &files {
        if *other < step && Some(*other) != before {
            fs::remove_file(file).at(file)?;
        }
    }
    Ok(path)
}

mod behind;
mod pack;
mod stored;
mod sum;
#[cfg(test)]
mod tests;
