//! `.pvd`: which file belongs to which time.

use super::read::{ReadError, Tag, tags};
use super::write::escape;
use std::collections::BTreeSet;
use std::path::Path;

/// One time of a `.pvd`.
#[derive(Debug, Clone, PartialEq)]
pub struct PvdEntry {
    /// Model time in s.
    pub time: f64,
    /// File, relative to the `.pvd`.
    pub file: String,
}

/// The text of a `.pvd`.
pub fn write_pvd(entries: &[PvdEntry]) -> String {
    let mut out = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for e in entries {
        out.push_str(&pvd_entry(e));
    }
    out.push_str(PVD_END);
    out
}

/// What a `.pvd` of ours ends with.
pub const PVD_END: &str = "</Collection>\n</VTKFile>\n";

/// The line of one entry.
pub fn pvd_entry(entry: &PvdEntry) -> String {
    format!(
        // All digits of the time: it is compared with that in the frame itself.
        "<DataSet timestep=\"{:?}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
        entry.time,
        escape(&entry.file)
    )
}

/// Bytes from which on reading a list again takes time.
const LONG: u64 = 4 << 20;
/// Letters of a name that a message shows.
const NAME: usize = 60;
/// A list that is damaged each of so many times is damaged.
const READS: usize = 5;

/// Reads a `.pvd` of ours. One that a run is adding to may be read half written: it is read again then.
///
/// # Errors
/// Missing, foreign or damaged files.
pub fn read_pvd(path: &Path) -> Result<Vec<PvdEntry>, ReadError> {
    let length = || std::fs::metadata(path).ok().map(|found| found.len());
    let mut before = length();
    let mut read = read_pvd_once(path);
    for _ in 1..READS {
        match read {
            Err(ReadError::Damaged { .. } | ReadError::Foreign { .. }) => {
                // A long list that stays as it is stays damaged.
                let now = length();
                if before == now && now.is_none_or(|now| now > LONG) {
                    break;
                }
                before = now;
                read = read_pvd_once(path);
            }
            Ok(_) | Err(_) => break,
        }
    }
    read
}

fn read_pvd_once(path: &Path) -> Result<Vec<PvdEntry>, ReadError> {
    let text = crate::read_plain_text(path)
        .map_err(|source| ReadError::Read { path: path.to_owned(), source })?;
    let damaged =
        |reason: &str| ReadError::Damaged { path: path.to_owned(), reason: reason.to_owned() };
    let tags: Vec<Tag> = tags(&text).ok_or_else(|| damaged("it is not well-formed XML"))?;
    if !tags.iter().any(|t| t.name == "Collection") {
        return Err(ReadError::Foreign { path: path.to_owned() });
    }
    if !tags.iter().any(|t| t.name == "/VTKFile") {
        return Err(damaged("it is truncated"));
    }
    let entries = tags.iter().filter(|t| t.name == "DataSet").map(|t| {
        let time = t.attribute("timestep").and_then(|v| v.parse().ok());
        match (time, t.attribute("file")) {
            (Some(time), Some(file)) => Ok(PvdEntry { time, file }),
            (_, _) => Err(damaged("a DataSet lacks its time or file")),
        }
    });
    let entries = entries.collect::<Result<Vec<_>, _>>()?;
    // A frame is of one time. A list that names it again and again would have it read as often.
    let mut seen = BTreeSet::new();
    if let Some(twice) = entries.iter().find(|entry| !seen.insert(&entry.file)) {
        let reason = format!("it names {} twice", shown(&twice.file));
        return Err(damaged(&reason));
    }
    Ok(entries)
}

/// The first letters of a name of a file, for messages.
fn shown(name: &str) -> String {
    name.chars().take(NAME).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disk::insert_before_end;

    #[test]
    fn a_list_that_a_run_adds_to_can_be_read_at_any_time() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("run.pvd");
        std::fs::write(&path, write_pvd(&[])).unwrap();
        let count = 600;
        std::thread::scope(|scope| {
            let writer = scope.spawn(|| {
                for k in 0..count {
                    let entry =
                        PvdEntry { time: f64::from(k), file: format!("frames/frame_{k:06}.vtu") };
                    assert!(insert_before_end(&path, &pvd_entry(&entry), PVD_END).unwrap());
                }
            });
            while !writer.is_finished() {
                read_pvd(&path).unwrap();
            }
        });
        assert_eq!(read_pvd(&path).unwrap().len(), count as usize);
    }
}
