//! Writing so that a crash or a full disk never leaves a half-written file under its final name.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Something could not be written (or, for resuming, not be read or truncated). Exit code 3.
#[derive(Debug, thiserror::Error)]
#[error("could not write {}: {source}", path.display())]
pub struct OutputError {
    /// The file or folder.
    pub path: PathBuf,
    /// What the system said.
    pub source: io::Error,
}

/// Attaches the path to an io error.
pub(crate) trait AtPath<T> {
    fn at(self, path: &Path) -> Result<T, OutputError>;
}

impl<T> AtPath<T> for io::Result<T> {
    fn at(self, path: &Path) -> Result<T, OutputError> {
        self.map_err(|source| OutputError { path: path.to_owned(), source })
    }
}

/// Opens a plain file for reading. A pipe would keep the reader waiting for a writer, a device has no end.
///
/// # Errors
/// What the system says; something that is no file.
pub fn open_plain(path: &Path) -> io::Result<File> {
    let plain = |found: &fs::Metadata| match found.is_file() {
        true => Ok(()),
        false => Err(io::Error::other("it is not a regular file")),
    };
    // Before it is opened, since opening a pipe waits; and after, since another may have taken its place.
    plain(&fs::metadata(path)?)?;
    let file = File::open(path)?;
    plain(&file.metadata()?)?;
    Ok(file)
}

/// Bytes of a plain file.
///
/// # Errors
/// As [`open_plain`].
pub fn read_plain(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open_plain(path)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Text of a plain file.
///
/// # Errors
/// As [`open_plain`]; what is no text.
pub fn read_plain_text(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    open_plain(path)?.read_to_string(&mut text)?;
    Ok(text)
}

/// Makes a rename or removal in `folder` durable. Only Unix can sync a folder.
fn sync_folder(folder: &Path) -> io::Result<()> {
    if cfg!(unix) {
        File::open(folder)?.sync_all()?;
    }
    Ok(())
}

/// Replaces `path` by `bytes`: written beside it, synced, renamed. Readers see the old or the new, never a part.
///
/// # Errors
/// The disk.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    write_whole_with(path, |file| file.write_all(bytes))
}

/// As [`write_whole`], by what `write` writes.
pub(crate) fn write_whole_with(
    path: &Path,
    write: impl FnOnce(&mut File) -> io::Result<()>,
) -> Result<(), OutputError> {
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        Some(_) | None => Path::new("."),
    };
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".tmp");
    let aside = folder.join(name);
    let result = (|| {
        let mut file = File::create(&aside)?;
        write(&mut file)?;
        file.sync_all()?;
        drop(file);
        fs::rename(&aside, path)?;
        sync_folder(folder)
    })();
    if result.is_err() {
        // Best effort: the error that matters is the one above.
        let _ = fs::remove_file(&aside);
    }
    result.at(path)
}

/// Puts `line` in front of `end`, with which the file at `path` closes, in one write: the cost does not grow with the file.
/// False when there is no such file or it closes otherwise; it is as it was then.
pub(crate) fn insert_before_end(path: &Path, line: &str, end: &str) -> Result<bool, OutputError> {
    let mut file = match OpenOptions::new().read(true).write(true).open(path) {
        Ok(file) => file,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(false),
        Err(e) => return Err(e).at(path),
    };
    let length = file.metadata().at(path)?.len();
    let Some(at) = length.checked_sub(end.len() as u64) else {
        return Ok(false);
    };
    let mut found = vec![0u8; end.len()];
    file.seek(SeekFrom::Start(at)).at(path)?;
    file.read_exact(&mut found).at(path)?;
    if found != end.as_bytes() {
        return Ok(false);
    }
    file.seek(SeekFrom::Start(at)).at(path)?;
    let written = file.write_all(format!("{line}{end}").as_bytes());
    if written.is_err() {
        // Best effort: the error that matters is that of the write.
        let _ = file.set_len(at);
        let _ = file.seek(SeekFrom::Start(at));
        let _ = file.write_all(end.as_bytes());
    }
    written.at(path)?;
    file.sync_data().at(path)?;
    Ok(true)
}

/// A file that only grows, by whole lines.
#[derive(Debug)]
pub(crate) struct AppendFile {
    path: PathBuf,
    file: File,
    length: u64,
}

impl AppendFile {
    /// Starts an empty file.
    pub(crate) fn create(path: &Path) -> Result<Self, OutputError> {
        let file = File::create(path).at(path)?;
        Ok(AppendFile { path: path.to_owned(), file, length: 0 })
    }

    /// Opens a file and cuts it back to `length` bytes, which must be the end of a line.
    #[cfg(test)]
    pub(crate) fn reopen(path: &Path, length: u64) -> Result<Self, OutputError> {
        let mut file = Self::look(path, length)?;
        file.cut()?;
        Ok(file)
    }

    /// Opens a file to continue it after `length` bytes, which must be the end of a line. It stays as it is until [`AppendFile::cut`].
    pub(crate) fn look(path: &Path, length: u64) -> Result<Self, OutputError> {
        let bad = |text: String| OutputError {
            path: path.to_owned(),
            source: io::Error::new(io::ErrorKind::InvalidData, text),
        };
        let mut options = OpenOptions::new();
        options.read(true).write(true);
        let mut file = if length == 0 {
            options.create(true).truncate(false).open(path).at(path)?
        } else {
            options.open(path).at(path)?
        };
        let there = file.metadata().at(path)?.len();
        if there < length {
            return Err(bad(format!(
                "this file had {length} bytes when the checkpoint was written and now has {there}; \
                 it was truncated or replaced, so the run cannot continue it"
            )));
        }
        if length > 0 {
            let mut last = [0u8];
            file.seek(SeekFrom::Start(length - 1)).at(path)?;
            file.read_exact(&mut last).at(path)?;
            if last != *b"\n" {
                return Err(bad(format!(
                    "byte {length} is no longer the end of a line, as recorded in the checkpoint; \
                     the file was changed, so the run cannot continue it"
                )));
            }
        }
        Ok(AppendFile { path: path.to_owned(), file, length })
    }

    /// Cuts the file back to where it is continued.
    pub(crate) fn cut(&mut self) -> Result<(), OutputError> {
        self.file.set_len(self.length).at(&self.path)?;
        self.file.seek(SeekFrom::Start(self.length)).at(&self.path)?;
        Ok(())
    }

    /// Appends one line (without its end). On failure the file is cut back to its last complete line if it lets us.
    pub(crate) fn line(&mut self, text: &str) -> Result<(), OutputError> {
        let mut bytes = Vec::with_capacity(text.len() + 1);
        bytes.extend_from_slice(text.as_bytes());
        bytes.push(b'\n');
        if let Err(source) = self.file.write_all(&bytes) {
            // Best effort: readers skip a part of a line anyway, and the write error is what the user must see.
            let _ = self.file.set_len(self.length);
            let _ = self.file.seek(SeekFrom::Start(self.length));
            return Err(OutputError { path: self.path.clone(), source });
        }
        self.length += bytes.len() as u64;
        Ok(())
    }

    /// Bytes written so far.
    pub(crate) fn len(&self) -> u64 {
        self.length
    }

    /// Waits until the disk has it.
    pub(crate) fn sync(&self) -> Result<(), OutputError> {
        self.file.sync_data().at(&self.path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_files_are_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.json");
        write_whole(&path, b"one").unwrap();
        write_whole(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1, "nothing left aside");
        let error = write_whole(&dir.path().join("no/such/a.json"), b"x").unwrap_err();
        assert!(error.to_string().contains("a.json"), "{error}");
    }

    #[test]
    fn appended_lines_can_be_cut_back() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.csv");
        let mut f = AppendFile::create(&path).unwrap();
        f.line("a,b").unwrap();
        let mark = f.len();
        f.line("1,2").unwrap();
        f.sync().unwrap();
        drop(f);
        let mut f = AppendFile::reopen(&path, mark).unwrap();
        f.line("3,4").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "a,b\n3,4\n");
        assert!(AppendFile::reopen(&path, 99).unwrap_err().to_string().contains("99 bytes"));
        assert!(AppendFile::reopen(&path, 2).unwrap_err().to_string().contains("end of a line"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_an_error() {
        let full = Path::new("/dev/full");
        if full.exists() {
            let mut f = AppendFile::create(full).unwrap();
            let error = f.line("1,2").unwrap_err();
            assert_eq!(error.source.kind(), io::ErrorKind::StorageFull);
            assert_eq!(f.len(), 0);
        }
    }
}
