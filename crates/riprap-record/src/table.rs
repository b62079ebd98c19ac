//! Reading the CSV files of a run folder.

use super::field::{nearest, split_unit};
use std::path::{Path, PathBuf};

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name without the unit.
    pub name: String,
    /// Unit, `-` for none.
    pub unit: String,
    /// Values; an empty cell is NaN.
    pub values: Vec<f64>,
}

/// A CSV file of numbers whose heads are `name [unit]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Where it came from.
    pub path: PathBuf,
    /// Columns of equal length.
    pub columns: Vec<Series>,
    /// The file ended inside a line, which was left out: its writer was stopped there.
    pub cut: bool,
}

/// Why a table cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TableError {
    /// The system would not let us read it.
    #[error("could not read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A cell is not a number, or a row has the wrong length.
    #[error("{} line {line}: {reason}", path.display())]
    Row {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// What is wrong.
        reason: String,
    },
    /// No such column.
    #[error(
        "{} has no column `{name}`{}; columns are: {}",
        path.display(),
        suggestion.as_ref().map_or_else(String::new, |s| format!(" (did you mean `{s}`?)")),
        if known.is_empty() { "(none)".to_owned() } else { known.join(", ") }
    )]
    NoColumn {
        /// The file.
        path: PathBuf,
        /// What was asked for.
        name: String,
        /// The nearest there is.
        suggestion: Option<String>,
        /// All names.
        known: Vec<String>,
    },
}

impl Table {
    /// Reads a table. A last line without its end is left out, since its writer was stopped inside it.
    ///
    /// # Errors
    /// Unreadable files and cells that are not numbers.
    pub fn read(path: &Path) -> Result<Self, TableError> {
        let bytes = crate::read_plain(path)
            .map_err(|source| TableError::Read { path: path.to_owned(), source })?;
        Self::parse(&bytes, path)
    }

    /// Reads the bytes of a table; `path` is only for the messages.
    ///
    /// # Errors
    /// As [`Table::read`].
    /// # Examples
    ///
    /// ```
    /// use std::path::Path;
    ///
    /// use riprap_record::table::Table;
    ///
    /// let table = Table::parse(b"time [s],speed [m/s]\n0,0\n0.5,4.9\n", Path::new("histories.csv"))?;
    /// let speed = table.column("speed")?;
    /// assert_eq!((speed.unit.as_str(), speed.values[1]), ("m/s", 4.9));
    /// # Ok::<(), riprap_record::table::TableError>(())
    /// ```
    pub fn parse(bytes: &[u8], path: &Path) -> Result<Self, TableError> {
        let whole = bytes.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
        let cut = whole < bytes.len();
        let wrong =
            |line: usize, reason: String| TableError::Row { path: path.to_owned(), line, reason };
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(&bytes[..whole]);
        let mut columns: Vec<Series> = Vec::new();
        for (i, record) in reader.records().enumerate() {
            let record = record.map_err(|e| wrong(i + 1, e.to_string()))?;
            let line =
                record.position().map_or(i + 1, |p| usize::try_from(p.line()).unwrap_or(i + 1));
            if i == 0 {
                columns = record
                    .iter()
                    .map(|head| {
                        let (name, unit) = split_unit(head);
                        Series { name: name.to_owned(), unit: unit.to_owned(), values: Vec::new() }
                    })
                    .collect();
                continue;
            }
            for (column, cell) in columns.iter_mut().zip(record.iter()) {
                column.values.push(if cell.is_empty() {
                    f64::NAN
                } else {
                    cell.trim()
                        .parse()
                        .map_err(|_| wrong(line, format!("`{cell}` is not a number")))?
                });
            }
        }
        Ok(Table { path: path.to_owned(), columns, cut })
    }

    /// Finds a column by its name, or by its whole head.
    ///
    /// # Errors
    /// [`TableError::NoColumn`] with the nearest name and all names.
    pub fn column(&self, name: &str) -> Result<&Series, TableError> {
        let (bare, _) = split_unit(name);
        self.columns.iter().find(|c| c.name == name || c.name == bare).ok_or_else(|| {
            let known: Vec<String> = self.columns.iter().map(|c| c.name.clone()).collect();
            TableError::NoColumn {
                path: self.path.clone(),
                name: name.to_owned(),
                suggestion: nearest(bare, known.iter().map(String::as_str)).map(str::to_owned),
                known,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn parsed(text: &str) -> Result<Table, TableError> {
        Table::parse(text.as_bytes(), Path::new("histories.csv"))
    }

    #[test]
    fn heads_units_and_gaps() {
        let t = parsed("step,time [s],\"slip, left [m]\"\n0,0,\n1,1e-3,-2.5\n").unwrap();
        assert!(!t.cut);
        assert_eq!(t.column("time").unwrap().values, vec![0.0, 1e-3]);
        let slip = t.column("slip, left [m]").unwrap();
        assert_eq!((slip.unit.as_str(), slip.values[1]), ("m", -2.5));
        assert!(slip.values[0].is_nan());
    }

    #[test]
    fn a_cut_last_line_is_left_out() {
        for tail in ["2", "2,", "2,0.00", "2,0.002"] {
            let t = parsed(&format!("step,time [s]\n1,0.001\n{tail}")).unwrap();
            assert!(t.cut);
            assert_eq!(t.column("step").unwrap().values, vec![1.0], "{tail}");
        }
        assert!(parsed("step,ti").unwrap().columns.is_empty());
    }

    #[test]
    fn errors_say_where_and_what_instead() {
        let e = parsed("step,time [s]\n1,0.1\n2,abc\n").unwrap_err().to_string();
        assert!(e.contains("line 3") && e.contains("abc"), "{e}");
        assert!(parsed("a,b\n1\n").unwrap_err().to_string().contains("line 2"));
        let t = parsed("step,time [s],slip [m]\n").unwrap();
        let e = t.column("slp").unwrap_err().to_string();
        assert!(e.contains("did you mean `slip`?") && e.contains("step, time, slip"), "{e}");
    }

    proptest! {
        #[test]
        fn random_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            let _ = Table::parse(&bytes, Path::new("x"));
        }
    }
}
