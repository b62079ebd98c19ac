//! When a frame is, read from the first lines of its file.

use std::io::Read;
use std::path::Path;

use super::read::{ReadError, Vtu, array, tags};

/// The field data stand within so many bytes of the start of a file.
const HEAD: u64 = 16 << 10;

/// When a frame is. Model time stands still in static phases; the step tells their frames apart.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Moment {
    /// Model time in s.
    pub time: f64,
    /// Step count: of a static phase, iterations.
    pub step: u64,
    /// Phase name.
    pub phase: String,
}

/// Reads when the frame in a `.vtu` file of ours is, without its numbers.
///
/// # Errors
/// As [`super::read()`], as far as the first lines tell.
pub fn read_moment(path: &Path) -> Result<Moment, ReadError> {
    let mut bytes = Vec::new();
    crate::open_plain(path)
        .and_then(|file| file.take(HEAD).read_to_end(&mut bytes))
        .map_err(|source| ReadError::Read { path: path.to_owned(), source })?;
    let damaged =
        |reason: &str| ReadError::Damaged { path: path.to_owned(), reason: reason.to_owned() };
    let end = b"</FieldData>";
    let at = bytes.windows(end.len()).position(|w| w == end);
    let head = at.and_then(|at| str::from_utf8(&bytes[..at + end.len()]).ok());
    let tags = head.and_then(tags).ok_or_else(|| damaged("its field data are missing"))?;
    let mut found = Vtu::default();
    for tag in tags.iter().filter(|t| ["DataArray", "Array"].contains(&t.name)) {
        let unit = String::new();
        array(&mut found, tag, "FieldData", unit, &[], (0, 0)).map_err(|e| damaged(&e))?;
    }
    Ok(Moment { time: found.time, step: found.step, phase: found.phase })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exec::Exec;
    use riprap_testkit::sample;

    #[test]
    fn the_moment_stands_at_the_head() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("frame.vtu");
        let bytes = super::super::blocks(&sample(), &Exec::serial()).unwrap();
        std::fs::write(&path, &bytes).unwrap();
        let moment = read_moment(&path).unwrap();
        assert_eq!((moment.time, moment.step), (0.125, 120));
        assert_eq!(moment.phase, "slide");
        for cut in [0, 10, 200, 400] {
            std::fs::write(&path, &bytes[..cut]).unwrap();
            assert!(read_moment(&path).is_err());
        }
    }
}
