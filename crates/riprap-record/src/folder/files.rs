//! Names of the files of a run folder, the lists of frames, the lock, and what is removed when a run is replaced.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use super::super::disk::{AtPath, OutputError, insert_before_end, open_plain, write_whole};
use super::super::manifest::{Ended, Manifest};
use super::super::vtu::{self, PvdEntry};
use super::super::{checkpoint, conditions, names};
use super::{FolderError, FrameEntry};

/// File whose lock says that a process writes the folder.
const LOCK: &str = ".lock";

/// Names of the append-only and whole files in the order in which they are removed; the manifest, which marks the
/// folder as ours, goes last.
const FILES: [&str; 20] = [
    LOCK,
    names::FILE,
    conditions::FILE,
    // Of versions before its name was changed.
    "paraview.py",
    "paraview_state.py",
    "scenario.resolved.toml",
    "checks.jsonl",
    "histories.csv",
    "energy.csv",
    "events.jsonl",
    "fragments.csv",
    "fragment_blocks.csv",
    "final_states.csv",
    "bolts.csv",
    "run.pvd",
    "contacts.pvd",
    "cracks.pvd",
    "bolts.pvd",
    "tetrahedra.pvd",
    "manifest.json",
];

/// File of the blocks of frame `index`, relative to the run folder.
pub fn block_file(index: u32) -> String {
    format!("frames/frame_{index:06}.vtu")
}

/// File of the cracks of frame `index`, relative to the run folder; there only with deformable blocks.
pub fn crack_file(index: u32) -> String {
    format!("frames/cracks_{index:06}.vtu")
}

/// File of the bars of the bolts of frame `index`, relative to the run folder; there only with bolts in the rock.
pub fn bolt_file(index: u32) -> String {
    format!("frames/bolts_{index:06}.vtu")
}

/// File of the tetrahedra of frame `index`, relative to the run folder; there only where they are asked for.
pub fn tetrahedron_file(index: u32) -> String {
    format!("frames/tetrahedra_{index:06}.vtu")
}

/// File of the contacts of frame `index`, relative to the run folder.
pub fn contact_file(index: u32) -> String {
    format!("frames/contacts_{index:06}.vtu")
}

/// All frame files there are, with their numbers, in order of name.
pub(super) fn frame_files(path: &Path) -> Result<Vec<(u32, PathBuf)>, OutputError> {
    let folder = path.join("frames");
    let mut found = Vec::new();
    for entry in fs::read_dir(&folder).at(&folder)? {
        let file = entry.at(&folder)?.path();
        let name = file.file_name().and_then(|n| n.to_str()).unwrap_or_default();
        let number = name
            .strip_prefix("frame_")
            .or_else(|| name.strip_prefix("contacts_"))
            .or_else(|| name.strip_prefix("cracks_"))
            .or_else(|| name.strip_prefix("bolts_"))
            .or_else(|| name.strip_prefix("tetrahedra_"));
        if let Some(Ok(index)) = number.and_then(|n| n.strip_suffix(".vtu")).map(str::parse) {
            found.push((index, file));
        }
    }
    found.sort();
    Ok(found)
}

pub(super) fn remove_if_there(path: &Path) -> Result<(), OutputError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != io::ErrorKind::NotFound => {
            Err(OutputError { path: path.to_owned(), source: e })
        }
        Ok(()) | Err(_) => Ok(()),
    }
}

/// Takes the folder for this process.
pub(super) fn lock(path: &Path) -> Result<File, FolderError> {
    let file = path.join(LOCK);
    let handle = File::create(&file).at(&file)?;
    match handle.try_lock() {
        Ok(()) => Ok(handle),
        Err(TryLockError::WouldBlock) => Err(FolderError::InUse { path: path.to_owned() }),
        // File systems without locks: better unguarded than not at all.
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => Ok(handle),
        Err(TryLockError::Error(error)) => Err(error).at(&file).map_err(FolderError::from),
    }
}

/// Whether a process is writing into the run folder now. File systems without locks cannot tell: `None`.
pub fn in_use(path: &Path) -> Option<bool> {
    match open_plain(&path.join(LOCK)).ok()?.try_lock_shared() {
        Ok(()) => Some(false),
        Err(TryLockError::WouldBlock) => Some(true),
        Err(TryLockError::Error(_)) => None,
    }
}

/// Whether the folder is what a run leaves that was stopped before its first checkpoint: no process writes it, nothing in it was
/// computed, and nothing in it is of anybody else. Where the system cannot tell whether it is written, no.
pub(super) fn only_begun(path: &Path) -> bool {
    let manifest = path.join("manifest.json");
    let running = || Manifest::read(path).is_ok_and(|m| m.ended == Ended::Running);
    in_use(path) == Some(false)
        && (running() || !manifest.exists())
        && every_entry(path, |file| {
            let name = file.file_name().and_then(|n| n.to_str()).unwrap_or("");
            match name.strip_suffix(".tmp").unwrap_or(name) {
                "frames" => every_entry(file, |_| false),
                "checkpoints" => every_entry(file, checkpoint::is_unfinished),
                LOCK | "events.jsonl" => lines(file) == Some(0),
                "histories.csv" | "energy.csv" => lines(file).is_some_and(|n| n < 2),
                "manifest.json" | "scenario.resolved.toml" | "run.pvd" | "contacts.pvd" => {
                    file.is_file()
                }
                _ => false,
            }
        })
}

/// Whether all that is in a folder is so; not where it cannot be read.
fn every_entry(folder: &Path, is_so: impl Fn(&Path) -> bool) -> bool {
    fs::read_dir(folder)
        .is_ok_and(|mut entries| entries.all(|entry| entry.is_ok_and(|entry| is_so(&entry.path()))))
}

/// Lines of a file, counted up to two.
fn lines(file: &Path) -> Option<usize> {
    let file = open_plain(file).ok()?;
    Some(BufReader::new(file).split(b'\n').take(2).count())
}

/// Removes the files of an earlier run and nothing else.
pub(super) fn clear(path: &Path) -> Result<(), OutputError> {
    if path.join("frames").is_dir() {
        for (_, file) in frame_files(path)? {
            fs::remove_file(&file).at(&file)?;
        }
    }
    for (_, file) in checkpoint::all(path).at(path)? {
        fs::remove_file(&file).at(&file)?;
    }
    checkpoint::remove_unfinished(path)?;
    FILES.iter().try_for_each(|name| remove_if_there(&path.join(name)))
}

/// File of a frame by its number.
type FileOf = fn(u32) -> String;

/// The `.pvd` lists: name, file of a frame, whether every frame has one.
const LISTS: [(&str, FileOf, bool); 5] = [
    ("run.pvd", block_file, true),
    ("contacts.pvd", contact_file, true),
    ("cracks.pvd", crack_file, false),
    ("bolts.pvd", bolt_file, false),
    ("tetrahedra.pvd", tetrahedron_file, false),
];

fn entry(frame: &FrameEntry, file: FileOf) -> PvdEntry {
    PvdEntry { time: frame.time, file: file(frame.index) }
}

/// Writes the `.pvd` lists: files of cracks, bolts and tetrahedra as far as there are any. A list without any is removed: one of
/// frames that a continued run writes again would name them twice.
pub(super) fn write_lists(path: &Path, frames: &[FrameEntry]) -> Result<(), OutputError> {
    for (name, file, always) in LISTS {
        let there = |f: &&FrameEntry| always || path.join(file(f.index)).exists();
        let entries: Vec<PvdEntry> = frames.iter().filter(there).map(|f| entry(f, file)).collect();
        if always || !entries.is_empty() {
            write_whole(&path.join(name), vtu::write_pvd(&entries).as_bytes())?;
        } else {
            remove_if_there(&path.join(name))?;
        }
    }
    Ok(())
}

/// Adds the last of `frames` to the lists; the cost does not grow with their number.
pub(super) fn extend_lists(path: &Path, frames: &[FrameEntry]) -> Result<(), OutputError> {
    let Some(last) = frames.last() else {
        return Ok(());
    };
    for (name, file, always) in LISTS {
        if !always && !path.join(file(last.index)).exists() {
            continue;
        }
        let line = vtu::pvd_entry(&entry(last, file));
        if !insert_before_end(&path.join(name), &line, vtu::PVD_END)? {
            // The first of its kind, or a list that someone has changed.
            return write_lists(path, frames);
        }
    }
    Ok(())
}
