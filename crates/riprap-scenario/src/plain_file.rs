//! Bytes of the files that a scene names.
//!
//! Only plain files are read: a pipe would keep the reader waiting for a writer, a device has no end. No file is read
//! beyond its limit, whatever its length says.

use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Why the bytes of a file could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct NotRead {
    /// What is wrong, with the name of the file.
    pub(crate) message: String,
    /// What to do.
    pub(crate) help: Option<String>,
}

/// All bytes of a plain file of at most `most` bytes.
///
/// # Errors
/// No such file, a folder, a pipe or a device, a file that is too large, or what the system says.
pub(crate) fn read(path: &Path, most: u64) -> Result<Vec<u8>, NotRead> {
    let shown = path.display();
    let refused = |message: String, help: &str| NotRead { message, help: Some(help.to_owned()) };
    let cannot = |error: io::Error| NotRead {
        help: (error.kind() == ErrorKind::NotFound)
            .then(|| "paths are seen from the folder of the scenario file".to_owned()),
        message: format!("cannot read `{shown}`: {error}"),
    };
    let plain = |found: &Metadata| {
        if found.is_dir() {
            let message = format!("`{shown}` is a folder, not a file");
            return Err(refused(message, "give the path of a file"));
        }
        if !found.is_file() {
            let message = format!("`{shown}` is not a plain file");
            let help = "a pipe or a device is not read: write its content to a file first";
            return Err(refused(message, help));
        }
        if found.len() > most {
            return Err(too_large(path, most));
        }
        Ok(())
    };
    // Before it is opened, since opening a pipe waits; and after, since another may have taken its place.
    plain(&std::fs::metadata(path).map_err(cannot)?)?;
    let file = File::open(path).map_err(cannot)?;
    plain(&file.metadata().map_err(cannot)?)?;
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > most {
        return Err(too_large(path, most));
    }
    Ok(bytes)
}

fn too_large(path: &Path, most: u64) -> NotRead {
    NotRead {
        message: format!("`{}` is larger than {} MiB", path.display(), most >> 20),
        help: Some("make it smaller: leave out what the scene does not need".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_files_within_the_limit_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        std::fs::write(&file, vec![7; 3 << 20]).unwrap();
        assert_eq!(read(&file, 3 << 20).unwrap().len(), 3 << 20);
        let refused = read(&file, 2 << 20).unwrap_err();
        assert!(refused.message.contains("larger than 2 MiB"));
        let refused = read(folder.path(), 9).unwrap_err();
        assert!(refused.message.contains("is a folder"));
        let refused = read(&folder.path().join("b"), 9).unwrap_err();
        assert!(refused.help.unwrap().contains("seen from the folder"));
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_end_is_no_file() {
        let refused = read(Path::new("/dev/zero"), 9).unwrap_err();
        assert!(refused.message.contains("not a plain file"), "{refused:?}");
    }
}
