//! What two runs of one scene have in common: histories, energies and last frames side by side.
//!
//! The runs may have different time steps: the second is read linearly at the times of the first.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::laws::norm;
use crate::record::folder::block_file;
use crate::record::table::{Series, Table, TableError};
use crate::record::vtu;

/// One number of both runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// History, energy or frame quantity.
    pub what: String,
    /// Unit, `-` for none.
    pub unit: String,
    /// Last value of the first run.
    pub first: f64,
    /// Last value of the second run.
    pub second: f64,
    /// Largest difference over the common time, or over the blocks of the last frame.
    pub largest: f64,
    /// `largest` as a share of the largest size in either run; 0 when both are zero throughout.
    pub share: f64,
    /// Where the largest difference is: a time or a block.
    pub place: String,
}

/// Why two runs cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// A CSV file.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A frame.
    #[error(transparent)]
    Frame(#[from] vtu::ReadError),
    /// A folder without its frames.
    #[error("could not read {}: {source}", path.display())]
    Folder {
        /// What was read.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
}

/// Compares two run folders.
///
/// # Errors
/// Files that cannot be read. Files that neither run has are left out.
pub fn folders(first: &Path, second: &Path) -> Result<Vec<Difference>, CompareError> {
    let mut found = Vec::new();
    for name in ["histories.csv", "energy.csv"] {
        let (a, b) = (first.join(name), second.join(name));
        if a.exists() && b.exists() {
            let prefix = if name == "energy.csv" { "energy." } else { "" };
            found.extend(tables(&Table::read(&a)?, &Table::read(&b)?, prefix)?);
        }
    }
    found.extend(last_frames(first, second)?);
    Ok(found)
}

/// Compares the columns both tables have, `step` and `time` excepted; names get `prefix` in front.
///
/// # Errors
/// A table without `time`.
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::record::table::Table;
/// use riprap::run::study::compare::tables;
///
/// let first = Table::parse(b"time [s],x [m]\n0,0\n1,2\n", Path::new("first.csv"))?;
/// let second = Table::parse(b"time [s],x [m]\n0,0\n1,3\n", Path::new("second.csv"))?;
/// assert_eq!(tables(&first, &second, "")?.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn tables(first: &Table, second: &Table, prefix: &str) -> Result<Vec<Difference>, TableError> {
    let (t, u) = (first.column("time")?, second.column("time")?);
    let mut found = Vec::new();
    for a in &first.columns {
        if a.name == "step" || a.name == "time" {
            continue;
        }
        let Ok(b) = second.column(&a.name) else {
            continue;
        };
        let name =
            if a.name.starts_with(prefix) { a.name.clone() } else { format!("{prefix}{}", a.name) };
        found.extend(series(name, (t, a), (u, b)));
    }
    Ok(found)
}

/// Compares two columns over their times; `None` when one of them is empty.
fn series(
    name: String,
    first: (&Series, &Series),
    second: (&Series, &Series),
) -> Option<Difference> {
    let a = samples(first.0, first.1);
    let b = samples(second.0, second.1);
    let (first_end, second_end) = (a.last()?.1, b.last()?.1);
    let common_end = a.last()?.0.min(b.last()?.0);
    let (mut largest, mut at) = (0.0, a.first()?.0);
    for (time, value) in a.iter().filter(|(time, _)| *time <= common_end) {
        let difference = (value - read_at(&b, *time)).abs();
        // What is no number is the largest of all, and no comparison would say so.
        if difference > largest || difference.is_nan() {
            (largest, at) = (difference, *time);
        }
    }
    let size = a.iter().chain(&b).map(|(_, v)| v.abs()).fold(0.0, f64::max);
    Some(Difference {
        what: name,
        unit: first.1.unit.clone(),
        first: first_end,
        second: second_end,
        largest,
        share: if size > 0.0 { largest / size } else { 0.0 },
        place: format!("t = {at:.6} s"),
    })
}

/// Times and values of the rows in which the column was written.
fn samples(time: &Series, values: &Series) -> Vec<(f64, f64)> {
    let rows = time.values.iter().copied().zip(values.values.iter().copied());
    rows.filter(|(_, value)| !value.is_nan()).collect()
}

/// Linear between samples, constant outside.
fn read_at(samples: &[(f64, f64)], time: f64) -> f64 {
    let after = samples.partition_point(|(t, _)| *t <= time);
    match (after.checked_sub(1).map(|i| samples[i]), samples.get(after)) {
        (Some((t0, v0)), Some((t1, v1))) => v0 + (v1 - v0) * (time - t0) / (t1 - t0),
        (Some((_, v)), None) | (None, Some(&(_, v))) => v,
        (None, None) => f64::NAN,
    }
}

/// Displacements of the blocks in the last frames, if both runs have the same blocks left.
fn last_frames(first: &Path, second: &Path) -> Result<Option<Difference>, CompareError> {
    let (Some(a), Some(b)) = (last_frame(first)?, last_frame(second)?) else {
        return Ok(None);
    };
    let (a, b) = (vtu::read_frame(&a, None)?, vtu::read_frame(&b, None)?);
    let column = |frame: &crate::record::Frame| {
        frame.block_columns.iter().find(|c| c.name == "displacement" && c.components == 2).cloned()
    };
    let (Some(da), Some(db)) = (column(&a), column(&b)) else {
        return Ok(None);
    };
    if da.data.len() != db.data.len() {
        return Ok(None);
    }
    let size = |data: &[f64]| data.chunks_exact(2).map(|v| norm(v[0], v[1])).fold(0.0, f64::max);
    let (mut largest, mut block) = (0.0, 0);
    let pairs = da.data.chunks_exact(2).zip(db.data.chunks_exact(2));
    for (i, (v, w)) in pairs.enumerate() {
        let difference = norm(v[0] - w[0], v[1] - w[1]);
        if difference > largest || difference.is_nan() {
            (largest, block) = (difference, i);
        }
    }
    let (first, second) = (size(&da.data), size(&db.data));
    let scale = first.max(second);
    Ok(Some(Difference {
        what: "largest displacement in the last frame".to_owned(),
        unit: da.unit,
        first,
        second,
        largest,
        share: if scale > 0.0 { largest / scale } else { 0.0 },
        place: format!("block {}", block + 1),
    }))
}

/// The frame with the highest number.
fn last_frame(folder: &Path) -> Result<Option<PathBuf>, CompareError> {
    let mut last = None;
    for index in 1.. {
        let path = folder.join(block_file(index));
        match path.try_exists() {
            Ok(true) => last = Some(path),
            Ok(false) => break,
            Err(source) => return Err(CompareError::Folder { path, source }),
        }
    }
    Ok(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> Table {
        Table::parse(text.as_bytes(), Path::new("x.csv")).unwrap()
    }

    #[test]
    fn different_time_steps_are_read_at_the_times_of_the_first() {
        let a = table("step,time [s],slip [m],only\n0,0,0,1\n1,1,2,1\n2,2,4,1\n");
        let b = table("step,time [s],slip [m]\n0,0,0\n1,0.5,1\n2,1.5,3.5\n3,2,4\n");
        let found = tables(&a, &b, "").unwrap();
        assert_eq!(found.len(), 1);
        let slip = &found[0];
        assert_eq!((slip.first, slip.second), (4.0, 4.0));
        assert_eq!((slip.largest, slip.share), (0.25, 0.0625));
        assert_eq!((slip.unit.as_str(), slip.place.as_str()), ("m", "t = 1.000000 s"));
    }

    #[test]
    fn empty_cells_and_unequal_ends() {
        let a = table("step,time [s],x [m]\n0,0,1\n1,1,\n2,2,1\n3,9,100\n");
        let b = table("step,time [s],x [m]\n0,0,1\n1,2,1\n");
        let found = tables(&a, &b, "energy.").unwrap();
        assert_eq!((found[0].largest, found[0].share), (0.0, 0.0));
        assert_eq!(found[0].what, "energy.x");
        let none = table("step,time [s],x [m]\n");
        assert!(tables(&a, &none, "").unwrap().is_empty());
        assert!(tables(&a, &table("step\n1\n"), "").is_err());
    }

    #[test]
    fn folders_without_anything_have_no_differences() {
        let (a, b) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        assert_eq!(folders(a.path(), b.path()).unwrap(), []);
    }
}
