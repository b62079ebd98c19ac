//! A temporary folder that does not outlive its use for long: it goes with the value, and what processes that were killed have left
//! goes when the next one begins.

use std::fs::{self, DirBuilder, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// What the folders of all processes begin with; the number of the process follows.
const PREFIX: &str = "riprap-view-";
/// Locked as long as the process lives: the system releases it however the process ends.
const LOCK: &str = "in_use";

/// A folder of this process among the temporary files of the system.
#[derive(Debug)]
pub struct Scratch {
    path: PathBuf,
    _lock: File,
}

impl Scratch {
    /// Makes the folder, for this user alone, and removes those of processes that are gone.
    ///
    /// # Errors
    /// The folder cannot be made, or its place is taken.
    pub fn new() -> io::Result<Self> {
        Self::within(&std::env::temp_dir(), std::process::id())
    }

    fn within(parent: &Path, process: u32) -> io::Result<Self> {
        sweep(parent);
        let path = parent.join(format!("{PREFIX}{process}"));
        let mut builder = DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
        builder.create(&path)?;
        let lock = File::create(path.join(LOCK))?;
        match lock.try_lock() {
            Ok(()) => {}
            // Where the file system has no locks folders stay behind, as long as the system keeps temporary files.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {}
            Err(error) => return Err(error.into()),
        }
        Ok(Scratch { path, _lock: lock })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What cannot be removed now is when the next one begins.
        let _ = fs::remove_dir_all(&self.path);
    }
}

/// Removes the folders whose lock nobody holds. What cannot be read or removed belongs to others, or to a system without locks.
fn sweep(parent: &Path) {
    let entries = fs::read_dir(parent).into_iter().flatten().flatten();
    for entry in entries {
        // Links are not followed: their target is no folder of ours.
        let ours = entry.file_name().to_string_lossy().starts_with(PREFIX)
            && entry.file_type().is_ok_and(|kind| kind.is_dir());
        if !ours {
            continue;
        }
        let lock = File::open(entry.path().join(LOCK));
        if lock.is_ok_and(|lock| lock.try_lock().is_ok()) {
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_killed_process_left_goes_when_the_next_begins() {
        let parent = tempfile::tempdir().unwrap();
        let [mine, killed, foreign] = [1, 2, 3].map(|n| parent.path().join(format!("{PREFIX}{n}")));
        let first = Scratch::within(parent.path(), 1).unwrap();
        fs::create_dir_all(killed.join("hill/frames")).unwrap();
        fs::write(killed.join(LOCK), "").unwrap();
        fs::create_dir(&foreign).unwrap();
        let second = Scratch::within(parent.path(), 4).unwrap();
        assert!(mine.is_dir(), "one in use was removed");
        assert!(foreign.is_dir(), "one without a lock is not ours");
        assert!(!killed.exists());
        assert_eq!(second.path().file_name().unwrap(), "riprap-view-4");
        drop((first, second));
        assert!(!mine.exists());
        // A place that is taken is not used.
        assert!(Scratch::within(parent.path(), 3).is_err());
    }
}
