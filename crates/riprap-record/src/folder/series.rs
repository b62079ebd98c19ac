//! Tables over time: `histories.csv` and `energy.csv`.

use std::io;
use std::path::Path;

use super::super::disk::{AppendFile, OutputError};
use super::super::field::{number, with_unit};

/// A CSV file whose first columns are `step` and `time [s]`.
#[derive(Debug)]
pub(super) struct Series {
    pub(super) file: AppendFile,
    pub(super) columns: usize,
}

/// Begins a table with a head of `(name, unit)`; does nothing if it has begun.
pub(super) fn begin<S: AsRef<str>>(
    slot: &mut Option<Series>,
    path: &Path,
    columns: &[(S, S)],
) -> Result<(), OutputError> {
    if slot.is_some() {
        return Ok(());
    }
    let mut head = String::from("step,time [s]");
    for (name, unit) in columns {
        head.push(',');
        head.push_str(&cell(&with_unit(name.as_ref(), unit.as_ref())));
    }
    let mut file = AppendFile::create(path)?;
    file.line(&head)?;
    *slot = Some(Series { file, columns: columns.len() });
    Ok(())
}

/// Appends a row; `None` leaves a cell empty.
pub(super) fn append(
    slot: &mut Option<Series>,
    path: &Path,
    step: u64,
    time: f64,
    row: &[Option<f64>],
) -> Result<(), OutputError> {
    let invalid = |text: String| OutputError {
        path: path.to_owned(),
        source: io::Error::new(io::ErrorKind::InvalidInput, text),
    };
    let Some(series) = slot else {
        return Err(invalid("a row before the header".to_owned()));
    };
    if row.len() != series.columns {
        return Err(invalid(format!(
            "a row of {} values for {} columns",
            row.len(),
            series.columns
        )));
    }
    let mut line = format!("{step},{}", number(time));
    for value in row {
        line.push(',');
        if let Some(v) = value {
            line.push_str(&number(*v));
        }
    }
    series.file.line(&line)
}

/// A text cell of a CSV file: quoted if it must be.
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\"").replace(['\n', '\r'], " "))
    } else {
        text.to_owned()
    }
}
