//! The run folder: created, filled, marked for checkpoints, reopened for resuming.
//!
//! `docs/src/run-folder.md` is the contract. A checkpoint stores [`Marks`]; [`RunFolder::reopen`] cuts every file
//! back to them, so that a resumed run leaves the same bytes as one that was never stopped (`manifest.json` with
//! its wall times excepted).

use super::checkpoint;
use super::conditions::Conditions;
use super::disk::{AppendFile, AtPath, OutputError, write_whole};
use super::frame::Frame;
use super::manifest::{Manifest, ManifestError};
use super::names::Names;
use super::vtu;
use riprap_core::exec::Exec;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

mod files;
mod series;
#[cfg(test)]
mod tests;

pub use files::{block_file, bolt_file, contact_file, crack_file, in_use, tetrahedron_file};
use files::{clear, frame_files, lock, only_begun, remove_if_there};
use series::{Series, append, begin};

/// What to do with a folder that is already there. An empty one is always fine, and one in which a run was begun that was stopped
/// before it had computed anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existing {
    /// Leave anything alone.
    Refuse,
    /// An earlier run is replaced; other folders are left alone.
    ReplaceRun,
    /// Write into any folder. Files that are not of a run stay where they are.
    Force,
}

/// Why a run folder cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum FolderError {
    /// There is something in it that is not a run.
    #[error("{} is not empty and not a run folder; choose another folder, or force writing there", path.display())]
    Occupied {
        /// The folder.
        path: PathBuf,
    },
    /// There is a run in it.
    #[error("{} already contains a run; choose another folder, or have it replaced", path.display())]
    Run {
        /// The folder.
        path: PathBuf,
    },
    /// It is a file.
    #[error("{} is a file, but a run needs a folder", path.display())]
    NotAFolder {
        /// The path.
        path: PathBuf,
    },
    /// Another process writes it.
    #[error("{} is being written by another riprap process; wait for it or choose another folder", path.display())]
    InUse {
        /// The folder.
        path: PathBuf,
    },
    /// A frame that the checkpoint names is missing.
    #[error("{} is missing, but the checkpoint depends on it; the run cannot be continued, start it again", path.display())]
    FrameMissing {
        /// The file.
        path: PathBuf,
    },
    /// The manifest of a run to continue.
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    /// The disk.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// One written frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameEntry {
    /// Number in the file name, from 1.
    pub index: u32,
    /// Step count.
    pub step: u64,
    /// Model time in s.
    pub time: f64,
}

/// How far each file had come: part of every checkpoint.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Marks {
    /// Step count.
    pub step: u64,
    /// Bytes of `histories.csv`; 0 if not begun.
    pub histories: u64,
    /// Bytes of `energy.csv`; 0 if not begun.
    pub energy: u64,
    /// Bytes of `events.jsonl`.
    pub events: u64,
    /// Columns of `histories.csv` after `step` and `time`.
    pub history_columns: u32,
    /// Columns of `energy.csv` after `step` and `time`.
    pub energy_columns: u32,
    /// Frames written.
    pub frames: Vec<FrameEntry>,
}

/// A run folder being written.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    /// Held as long as the folder is written; the system releases it when the process dies. None where nothing is written.
    lock: Option<File>,
    histories: Option<Series>,
    energy: Option<Series>,
    /// None where nothing is written.
    events: Option<AppendFile>,
    frames: Vec<FrameEntry>,
}

impl RunFolder {
    /// The first of `name`, `name-2`, `name-3`, ... that is not taken by more than a run that was stopped before it had computed
    /// anything: `slope.run`, `slope-2.run`.
    pub fn free_name(wanted: &Path) -> PathBuf {
        let stem = wanted.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let extension =
            wanted.extension().map(|e| format!(".{}", e.to_string_lossy())).unwrap_or_default();
        let mut path = wanted.to_owned();
        let mut n = 2u32;
        while path.exists() && !only_begun(&path) {
            path = wanted.with_file_name(format!("{stem}-{n}{extension}"));
            n += 1;
        }
        path
    }

    /// Makes a run folder and writes its first manifest.
    ///
    /// # Errors
    /// A folder that `existing` does not allow, or the disk.
    pub fn create(
        path: &Path,
        existing: Existing,
        manifest: &Manifest,
    ) -> Result<Self, FolderError> {
        if path.exists() && !path.is_dir() {
            return Err(FolderError::NotAFolder { path: path.to_owned() });
        }
        if path.is_dir() && fs::read_dir(path).at(path)?.next().is_some() {
            // A manifest of a newer format is still a run that must not be lost.
            let run = matches!(Manifest::read(path), Ok(_) | Err(ManifestError::Newer { .. }));
            match (existing, run) {
                _ if only_begun(path) => clear(path)?,
                (Existing::Refuse, true) => {
                    return Err(FolderError::Run { path: path.to_owned() });
                }
                (Existing::Refuse | Existing::ReplaceRun, false) => {
                    return Err(FolderError::Occupied { path: path.to_owned() });
                }
                (Existing::ReplaceRun, true) | (Existing::Force, _) => {
                    // Refuses a folder that another process writes; not held, since its file goes too.
                    drop(lock(path)?);
                    clear(path)?;
                }
            }
        }
        fs::create_dir_all(path).at(path)?;
        let lock = lock(path)?;
        for sub in ["frames", "checkpoints"] {
            let folder = path.join(sub);
            fs::create_dir_all(&folder).at(&folder)?;
        }
        manifest.write(path)?;
        let events = AppendFile::create(&path.join("events.jsonl"))?;
        let run = RunFolder {
            path: path.to_owned(),
            lock: Some(lock),
            histories: None,
            energy: None,
            events: Some(events),
            frames: Vec::new(),
        };
        run.write_pvd()?;
        Ok(run)
    }

    /// Opens a run folder to continue from a checkpoint: every file is cut back to the checkpoint's marks, frames
    /// and checkpoints after it are removed.
    ///
    /// # Errors
    /// Files that are shorter than their marks or changed, missing frames, the disk.
    pub fn reopen(path: &Path, marks: &Marks) -> Result<Self, FolderError> {
        Self::reopen_beside(path, marks, &[]).map(|(run, _)| run)
    }

    /// As [`RunFolder::reopen`] where checkpoints of other runs or programs lie in the folder: these are given other names, not removed. The
    /// names, in their order.
    ///
    /// # Errors
    /// As [`RunFolder::reopen`].
    pub fn reopen_beside(
        path: &Path,
        marks: &Marks,
        others: &[&Path],
    ) -> Result<(Self, Vec<PathBuf>), FolderError> {
        Manifest::read(path)?;
        let lock = lock(path)?;
        let frames = marks.frames.iter().map(|entry| entry.index);
        let mut files = frames.flat_map(|k| [block_file(k), contact_file(k)]).map(|f| path.join(f));
        if let Some(path) = files.find(|file| !file.is_file()) {
            return Err(FolderError::FrameMissing { path });
        }
        let series =
            |name: &str, bytes: u64, columns: u32| -> Result<Option<Series>, OutputError> {
                if bytes == 0 {
                    return Ok(None);
                }
                Ok(Some(Series {
                    file: AppendFile::look(&path.join(name), bytes)?,
                    columns: columns as usize,
                }))
            };
        let mut run = RunFolder {
            path: path.to_owned(),
            lock: Some(lock),
            histories: series("histories.csv", marks.histories, marks.history_columns)?,
            energy: series("energy.csv", marks.energy, marks.energy_columns)?,
            events: Some(AppendFile::look(&path.join("events.jsonl"), marks.events)?),
            frames: marks.frames.clone(),
        };
        let old = frame_files(path)?;
        // All that may be refused has been looked at: nothing is cut in a folder that is not continued.
        for (name, series) in
            [("histories.csv", &mut run.histories), ("energy.csv", &mut run.energy)]
        {
            match series {
                Some(series) => series.file.cut()?,
                // The run had not begun this file: it will, and then creates it.
                None => remove_if_there(&path.join(name))?,
            }
        }
        if let Some(events) = &mut run.events {
            events.cut()?;
        }
        // The lists first: they must never name a file that is gone.
        run.write_pvd()?;
        let kept = |index: u32| marks.frames.iter().any(|f| f.index == index);
        for (index, file) in old {
            if !kept(index) {
                fs::remove_file(&file).at(&file)?;
            }
        }
        let aside = others.iter().map(|file| checkpoint::set_aside(file));
        let aside = aside.collect::<Result<Vec<_>, _>>()?;
        for (step, file) in checkpoint::all(path).at(path)? {
            if step > marks.step {
                fs::remove_file(&file).at(&file)?;
            }
        }
        checkpoint::remove_unfinished(path)?;
        Ok((run, aside))
    }

    /// A folder in which nothing is written: that of a rank beside the one that writes. It counts its `frames` from those of a checkpoint on.
    #[must_use]
    pub fn silent(frames: Vec<FrameEntry>) -> Self {
        let path = PathBuf::new();
        Self { path, lock: None, histories: None, energy: None, events: None, frames }
    }

    /// Whether nothing is written.
    #[must_use]
    pub fn is_silent(&self) -> bool {
        self.lock.is_none()
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Frames written so far.
    pub fn frames(&self) -> &[FrameEntry] {
        &self.frames
    }

    /// Replaces `manifest.json`.
    ///
    /// # Errors
    /// The disk.
    pub fn write_manifest(&self, manifest: &Manifest) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        manifest.write(&self.path)
    }

    /// Writes `scenario.resolved.toml`: the scene with all overrides, runnable as it stands.
    ///
    /// # Errors
    /// The disk.
    pub fn write_scenario(&self, toml: &str) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        write_whole(&self.path.join("scenario.resolved.toml"), toml.as_bytes())
    }

    /// Writes any further whole file of the run, for example `checks.json` or `sweep.csv`.
    ///
    /// # Errors
    /// The disk.
    pub fn write_file(&self, name: &str, bytes: &[u8]) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        write_whole(&self.path.join(name), bytes)
    }

    /// Begins `histories.csv` with a head of `(name, unit)`; does nothing in a run continued after that.
    ///
    /// # Errors
    /// The disk.
    pub fn begin_histories<S: AsRef<str>>(
        &mut self,
        columns: &[(S, S)],
    ) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        begin(&mut self.histories, &self.path.join("histories.csv"), columns)
    }

    /// Begins `energy.csv` with a head of `(name, unit)`; does nothing in a run continued after that.
    ///
    /// # Errors
    /// The disk.
    pub fn begin_energy<S: AsRef<str>>(&mut self, columns: &[(S, S)]) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        begin(&mut self.energy, &self.path.join("energy.csv"), columns)
    }

    /// Appends a row to `histories.csv`; `None` leaves a cell empty (not due at this step).
    ///
    /// # Errors
    /// The disk; a row without [`RunFolder::begin_histories`] or of another length is `InvalidInput`.
    pub fn history_row(
        &mut self,
        step: u64,
        time: f64,
        row: &[Option<f64>],
    ) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        append(&mut self.histories, &self.path.join("histories.csv"), step, time, row)
    }

    /// Appends a row to `energy.csv`.
    ///
    /// # Errors
    /// As [`RunFolder::history_row`].
    pub fn energy_row(&mut self, step: u64, time: f64, row: &[f64]) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        let row: Vec<Option<f64>> = row.iter().copied().map(Some).collect();
        append(&mut self.energy, &self.path.join("energy.csv"), step, time, &row)
    }

    /// Appends an event, one JSON object, to `events.jsonl`.
    ///
    /// # Errors
    /// The disk, or a value that JSON cannot hold.
    pub fn event<T: Serialize>(&mut self, event: &T) -> Result<(), OutputError> {
        let path = self.path.join("events.jsonl");
        let text = serde_json::to_string(event).map_err(io::Error::from).at(&path)?;
        match &mut self.events {
            Some(events) => events.line(&text),
            None => Ok(()),
        }
    }

    /// Writes what holds, moves and loads the model.
    ///
    /// # Errors
    /// The disk.
    pub fn write_conditions(&self, conditions: &Conditions) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        super::conditions::write(conditions, &self.path)
    }

    /// Writes the names of blocks and groups.
    ///
    /// # Errors
    /// The disk.
    pub fn write_names(&self, names: &Names) -> Result<(), OutputError> {
        if self.is_silent() {
            return Ok(());
        }
        names.write(&self.path)
    }

    /// Counts a frame that another rank writes.
    pub fn count_frame(&mut self, step: u64, time: f64) {
        let index = self.frames.last().map_or(1, |f| f.index + 1);
        self.frames.push(FrameEntry { index, step, time });
    }

    /// Writes a frame (up to five `.vtu` files), compressed by the threads of `exec`, and then names it in the two `.pvd` files.
    ///
    /// # Errors
    /// The disk, or a frame whose parts do not fit together.
    pub fn frame(&mut self, frame: &Frame, exec: &Exec) -> Result<&FrameEntry, OutputError> {
        let index = self.frames.last().map_or(1, |f| f.index + 1);
        let (blocks, contacts) =
            (self.path.join(block_file(index)), self.path.join(contact_file(index)));
        write_whole(&blocks, &vtu::blocks(frame, exec).at(&blocks)?)?;
        write_whole(&contacts, &vtu::contacts(frame, exec).at(&contacts)?)?;
        let cracks = self.path.join(crack_file(index));
        if let Some(bytes) = vtu::cracks(frame, exec).at(&cracks)? {
            write_whole(&cracks, &bytes)?;
        }
        let bolts = self.path.join(bolt_file(index));
        if let Some(bytes) = vtu::bolts(frame, exec).at(&bolts)? {
            write_whole(&bolts, &bytes)?;
        }
        let tetrahedra = self.path.join(tetrahedron_file(index));
        if let Some(bytes) = vtu::tetrahedra(frame, exec).at(&tetrahedra)? {
            write_whole(&tetrahedra, &bytes)?;
        }
        self.count_frame(frame.step, frame.time);
        // Last, so that the lists never name a file that is not whole.
        files::extend_lists(&self.path, &self.frames)?;
        Ok(&self.frames[self.frames.len() - 1])
    }

    /// How far each file has come. Store it inside the checkpoint.
    pub fn marks(&self, step: u64) -> Marks {
        let bytes = |s: &Option<Series>| s.as_ref().map_or(0, |s| s.file.len());
        // A table of 2^32 columns does not fit into a file.
        let columns = |s: &Option<Series>| {
            s.as_ref().map_or(0, |s| u32::try_from(s.columns).unwrap_or(u32::MAX))
        };
        Marks {
            step,
            histories: bytes(&self.histories),
            energy: bytes(&self.energy),
            events: self.events.as_ref().map_or(0, AppendFile::len),
            history_columns: columns(&self.histories),
            energy_columns: columns(&self.energy),
            frames: self.frames.clone(),
        }
    }

    /// Writes a checkpoint, after everything that its marks count has reached the disk, and keeps only it and the
    /// one before it.
    ///
    /// # Errors
    /// The disk.
    pub fn checkpoint<T: Serialize>(
        &self,
        kind: &str,
        step: u64,
        state: &T,
    ) -> Result<PathBuf, OutputError> {
        self.checkpoint_as(kind, step, state, checkpoint::Packing::Small)
    }

    /// As [`RunFolder::checkpoint`], packed as wanted.
    ///
    /// # Errors
    /// The disk.
    pub fn checkpoint_as<T: Serialize>(
        &self,
        kind: &str,
        step: u64,
        state: &T,
        packing: checkpoint::Packing,
    ) -> Result<PathBuf, OutputError> {
        // The marks in a checkpoint count bytes that must be on the disk before it is.
        for series in [&self.histories, &self.energy].into_iter().flatten() {
            series.file.sync()?;
        }
        if let Some(events) = &self.events {
            events.sync()?;
        }
        checkpoint::write_and_prune(&self.path, kind, step, state, packing)
    }

    fn write_pvd(&self) -> Result<(), OutputError> {
        files::write_lists(&self.path, &self.frames)
    }
}
