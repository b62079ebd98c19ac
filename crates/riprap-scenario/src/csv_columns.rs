//! Columns of numbers from a CSV file, with errors that say where and what.

use std::io::Read;
use std::path::Path;

use super::diagnostic::suggest;
use super::units::{self, Dim};

/// Largest CSV file accepted, bytes.
pub const MAX_CSV_SIZE: u64 = 64 << 20;

/// Columns in the order in which they were asked for; all of the same, non-zero length.
pub type Columns = Vec<Vec<f64>>;

/// Reads the named columns. The first line that is not empty and does not begin with `#` is the
/// header.
///
/// # Errors
/// A text for the user: no file, too large, no such column, a cell that is no finite number.
pub fn csv_columns(path: &Path, names: &[&str]) -> Result<Columns, CsvError> {
    let text = read_text(path)?;
    read_columns(&text, names).map_err(|error| error.of(path))
}

/// A column that names its unit: `delay_ms` or `delay [ms]` is the column `delay` in ms.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// Names that a file may give it, the usual one first. Capitals, spaces and underscores make no difference.
    pub names: &'a [&'a str],
    /// What it measures.
    pub dim: Dim,
    /// Unit of a column that names none; `None` refuses such a column.
    pub bare: Option<&'a str>,
}

/// Reads columns that are named with their unit: `delay_ms` or `delay [ms]` is the column `delay`, in s.
/// The answer has one entry for each needed column and one for each optional one, SI values; those of the
/// needed ones are always there.
///
/// # Errors
/// As [`csv_columns`]; a unit that is missing, unknown or of another dimension.
pub fn csv_quantities(
    path: &Path,
    needed: &[(&str, Dim)],
    optional: &[(&str, Dim)],
) -> Result<Vec<Option<Vec<f64>>>, CsvError> {
    let text = read_text(path)?;
    let all = || needed.iter().chain(optional);
    let names: Vec<[&str; 1]> = all().map(|(name, _)| [*name]).collect();
    let columns = all().zip(&names).map(|((_, dim), names)| Column {
        names,
        dim: *dim,
        bare: None,
    });
    let columns: Vec<Column> = columns.collect();
    let found = read_table(&text, &columns).and_then(|found| {
        match found[..needed.len()].iter().position(Option::is_none) {
            Some(missing) => Err(missing_column(&text, needed[missing].0)),
            None => Ok(found.into_iter().map(|f| f.map(|f| f.values)).collect()),
        }
    });
    found.map_err(|error| error.of(path))
}

/// A column of a table as it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Its numbers, SI.
    pub values: Vec<f64>,
    /// Whether its name says no unit, so that the usual one was taken.
    pub bare: bool,
}

/// Reads those of the columns that are there.
///
/// # Errors
/// As [`csv_quantities`], but for columns that are missing.
pub fn csv_table<const N: usize>(
    path: &Path,
    columns: &[Column; N],
) -> Result<[Option<Found>; N], CsvError> {
    let text = read_text(path)?;
    let found = read_table(&text, columns).map_err(|error| error.of(path))?;
    let mut found = found.into_iter();
    Ok(std::array::from_fn(|_| found.next().flatten()))
}

/// The texts of a column, and whether the file has other columns.
///
/// # Errors
/// A file that cannot be read, no such column, a row without a text there.
pub fn csv_labels(path: &Path, name: &str) -> Result<Vec<String>, CsvError> {
    let text = read_text(path)?;
    labels(&text, name).map_err(|error| error.of(path))
}

fn labels(text: &str, name: &str) -> Result<Vec<String>, CsvError> {
    let header = header_of(text)?;
    let Some(place) = header.iter().position(|cell| plain(cell) == plain(name)) else {
        return Err(CsvError {
            message: format!("there is no column `{name}`"),
            help: suggest(name, header.iter().map(String::as_str)),
        });
    };
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let records = reader.records().map(|record| {
        let record = record.map_err(|error| CsvError {
            message: error.to_string(),
            help: None,
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        match record.get(place) {
            Some(cell) if !cell.is_empty() => Ok(cell.to_owned()),
            Some(_) | None => Err(CsvError {
                message: format!("line {line} says nothing in the column `{name}`"),
                help: None,
            }),
        }
    });
    records.collect()
}

/// The columns of a text; see [`csv_table`].
fn read_table(text: &str, columns: &[Column]) -> Result<Vec<Option<Found>>, CsvError> {
    let header = header_of(text)?;
    let cells: Vec<Option<Cell>> = columns
        .iter()
        .map(|column| find(&header, column))
        .collect::<Result<_, _>>()?;
    let names: Vec<&str> = cells.iter().flatten().map(|cell| cell.name).collect();
    let mut read = read_columns(text, &names)?.into_iter();
    let found = cells.into_iter().map(|cell| {
        let Cell { factor, bare, .. } = cell?;
        let values = read.next()?.into_iter().map(|v| v * factor).collect();
        Some(Found { values, bare })
    });
    Ok(found.collect())
}

/// A cell of the header that names a column.
struct Cell<'h> {
    name: &'h str,
    /// Of its unit.
    factor: f64,
    /// Whether it says no unit.
    bare: bool,
}

/// The cell of the header that names the column.
fn find<'h>(header: &'h [String], column: &Column) -> Result<Option<Cell<'h>>, CsvError> {
    let mut refused = None;
    let mut found: Option<Cell> = None;
    'cells: for cell in header {
        for (name, unit) in name_and_unit(cell) {
            let alike = |known: &&str| plain(known) == plain(name);
            if !column.names.iter().any(alike) {
                continue;
            }
            let usual = column.bare.filter(|_| unit.is_empty());
            // In names of columns an underscore divides: `a_m_s2` is `a` in m/s2.
            match units::parse(&format!("1 {}", usual.unwrap_or(unit).replace('_', "/"))) {
                Ok((factor, dim)) if dim == column.dim => {
                    if let Some(first) = found {
                        return Err(both(first.name, cell, column.names[0]));
                    }
                    found = Some(Cell {
                        name: cell,
                        factor,
                        bare: usual.is_some(),
                    });
                    continue 'cells;
                }
                Ok((_, dim)) => {
                    // Told only where no other way to read a cell, and no other cell, fits.
                    refused.get_or_insert_with(|| CsvError {
                        message: format!("the column `{cell}` is {}", dim.describe()),
                        help: Some(format!(
                            "{} is expected, with its unit behind an underscore",
                            column.dim.describe()
                        )),
                    });
                }
                Err(error) => {
                    refused.get_or_insert_with(|| CsvError {
                        message: format!("the column `{cell}`: {}", error.message),
                        help: error.help,
                    });
                }
            }
        }
    }
    match (found, refused) {
        (Some(cell), _) => Ok(Some(cell)),
        (None, Some(refused)) => Err(refused),
        (None, None) => Ok(None),
    }
}

/// Two columns of which either could be meant.
fn both(first: &str, second: &str, wanted: &str) -> CsvError {
    CsvError {
        message: if first == second {
            format!("the column `{first}` is there twice")
        } else {
            format!("the columns `{first}` and `{second}` are both `{wanted}`")
        },
        help: Some("take one of them out, or give it another name".to_owned()),
    }
}

/// Ways to read a cell of the header as a name and a unit, the longest name first.
fn name_and_unit(cell: &str) -> Vec<(&str, &str)> {
    for [open, close] in [['[', ']'], ['(', ')']] {
        if let Some((name, unit)) = cell.strip_suffix(close).and_then(|c| c.split_once(open)) {
            return vec![(name.trim_end(), unit)];
        }
    }
    let ends = cell.rmatch_indices('_');
    let parts = ends.map(|(at, _)| (&cell[..at], &cell[at + 1..]));
    std::iter::once((cell, "")).chain(parts).collect()
}

/// A name without what makes no difference.
fn plain(name: &str) -> String {
    let kept = name.chars().filter(|c| !matches!(c, ' ' | '_' | '-'));
    kept.flat_map(char::to_lowercase).collect()
}

fn missing_column(text: &str, name: &str) -> CsvError {
    let header = header_of(text).unwrap_or_default();
    let known: Vec<&str> = header.iter().map(String::as_str).collect();
    CsvError {
        message: format!("there is no column `{name}` with its unit behind it"),
        help: suggest(name, known),
    }
}

/// The names of the columns.
fn header_of(text: &str) -> Result<Vec<String>, CsvError> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| CsvError {
        message: error.to_string(),
        help: None,
    })?;
    Ok(header.iter().map(str::to_owned).collect())
}

fn read_text(path: &Path) -> Result<String, CsvError> {
    let shown = path.display();
    let fail = |message: String, help: Option<String>| CsvError { message, help };
    let io = |error: std::io::Error| {
        let help = (error.kind() == std::io::ErrorKind::NotFound)
            .then(|| "paths are seen from the folder of the scenario file".to_owned());
        fail(format!("cannot read `{shown}`: {error}"), help)
    };
    if path.is_dir() {
        return Err(fail(format!("`{shown}` is a folder, not a CSV file"), None));
    }
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path).map_err(io)?;
    if file.metadata().map_err(io)?.len() > MAX_CSV_SIZE {
        let size = MAX_CSV_SIZE >> 20;
        return Err(fail(format!("`{shown}` is larger than {size} MiB"), None));
    }
    // What is no plain file may say nothing of its length.
    file.take(MAX_CSV_SIZE + 1)
        .read_to_end(&mut bytes)
        .map_err(io)?;
    let text = String::from_utf8(bytes).map_err(|_| {
        fail(
            format!("`{shown}` is not a text file"),
            Some("save it as CSV in UTF-8".to_owned()),
        )
    })?;
    Ok(text.trim_start_matches('\u{feff}').to_owned())
}

/// Why a CSV file could not be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct CsvError {
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
}

impl CsvError {
    /// With the name of the file.
    fn of(self, path: &Path) -> Self {
        CsvError {
            message: format!("`{}`: {}", path.display(), self.message),
            help: self.help,
        }
    }
}

/// Reads the named columns of a text.
///
/// # Errors
/// As [`csv_columns`].
pub fn read_columns(text: &str, names: &[&str]) -> Result<Columns, CsvError> {
    let fail = |message: String, help: Option<&str>| CsvError {
        message,
        help: help.map(str::to_owned),
    };
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let header = reader
        .headers()
        .map_err(|error| fail(error.to_string(), None))?
        .clone();
    if header.is_empty() || header.iter().all(str::is_empty) {
        return Err(fail(
            "the file is empty".to_owned(),
            Some("the first line names the columns, for example `t_s,a_m_s2`"),
        ));
    }
    let mut at = Vec::new();
    for name in names {
        let mut places = (0..header.len()).filter(|k| header.get(*k) == Some(*name));
        match places.next() {
            Some(_) if places.next().is_some() => return Err(both(name, name, name)),
            Some(index) => at.push(index),
            None => {
                let only: Vec<&str> = header.iter().collect();
                let help = if only.len() == 1 && (only[0].contains(';') || only[0].contains('\t')) {
                    Some("separate the columns with commas".to_owned())
                } else if only.iter().all(|cell| cell.parse::<f64>().is_ok()) {
                    Some("the first line must name the columns".to_owned())
                } else {
                    let known = super::values::short(&only.join(", "));
                    suggest(name, only.iter().copied().filter(|c| c.len() < 60)).map(|help| {
                        if help.starts_with("did") {
                            format!("{help} the columns are {known}")
                        } else {
                            help
                        }
                    })
                };
                return Err(CsvError {
                    message: format!("there is no column `{name}`"),
                    help,
                });
            }
        }
    }
    let mut columns: Columns = vec![Vec::new(); names.len()];
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(0, csv::Position::line);
            fail(
                format!("line {line} does not have as many cells as the header"),
                Some("every line needs one cell for each column"),
            )
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        for ((column, index), name) in columns.iter_mut().zip(&at).zip(names) {
            let cell = record.get(*index).unwrap_or_default();
            let bad = |what: &str| {
                let cell = super::values::short(cell);
                fail(
                    format!("line {line}, column `{name}`: \"{cell}\" is not {what}"),
                    None,
                )
            };
            let number: f64 = cell.parse().map_err(|_| bad("a number"))?;
            if !number.is_finite() {
                return Err(bad("a finite number"));
            }
            column.push(number);
        }
    }
    if columns.iter().any(Vec::is_empty) {
        return Err(fail(
            "there are no lines of numbers under the header".to_owned(),
            None,
        ));
    }
    Ok(columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        let error = read_columns(text, &["t_s", "a"]).unwrap_err();
        format!("{error} | {}", error.help.clone().unwrap_or_default())
    }

    #[test]
    fn reads_columns_in_order() {
        let text = "# recorded somewhere\n\na, t_s ,x\n1,0,z\n2,1e-1,z\n";
        assert_eq!(
            read_columns(text, &["t_s", "a"]).unwrap(),
            [[0.0, 0.1], [1.0, 2.0]]
        );
    }

    #[test]
    fn says_what_is_wrong() {
        assert!(error("").contains("empty"));
        assert!(error("# only a comment\n").contains("empty"));
        assert!(error("t_s,b\n1,2\n").contains("no column `a`"));
        assert!(error("t_s;a\n1;2\n").contains("separate the columns with commas"));
        assert!(error("0,1\n1,2\n").contains("must name the columns"));
        assert!(error("t_s,a,a\n1,2,3\n").contains("the column `a` is there twice"));
        assert!(error("t_s,a\n").contains("no lines"));
        assert!(error("t_s,a\n1,x\n").contains("line 2, column `a`: \"x\" is not a number"));
        assert!(
            error("t_s,a\n1,2\n1,nan\n").contains("line 3"),
            "{}",
            error("t_s,a\n1,2\n1,nan\n")
        );
        assert!(error("t_s,a\n1\n").contains("line 2"));
        assert!(error("t_s,a\n\"1,2\n").contains("line 2"));
    }

    #[test]
    fn a_column_has_several_names_and_says_its_unit_in_several_ways() {
        let dip = |bare| Column {
            names: &["dip"],
            dim: Dim::ANGLE,
            bare,
        };
        let direction = Column {
            names: &["dip_direction", "dip_azimuth"],
            dim: Dim::ANGLE,
            bare: Some("deg"),
        };
        for (text, bare) in [
            ("dip_direction_deg,dip_deg\n90,90\n", false),
            ("DipDirection[deg],Dip [deg]\n90,90\n", false),
            ("Dip Azimuth (deg), Dip (deg)\n90,90\n", false),
            ("dip_direction,dip\n90,90\n", true),
        ] {
            let values = vec![std::f64::consts::FRAC_PI_2];
            let right = Some(Found { values, bare });
            let found = read_table(text, &[dip(Some("deg")), direction]).unwrap();
            assert_eq!(found, [right.clone(), right], "{text}");
        }
        for (text, says) in [
            (
                "dip_direction_deg,Dip Azimuth [deg],dip\n90,80,90\n",
                "the columns `dip_direction_deg` and `Dip Azimuth [deg]` are both `dip_direction`",
            ),
            (
                "dip_direction,dip,dip\n90,80,90\n",
                "the column `dip` is there twice",
            ),
        ] {
            let refused = read_table(text, &[dip(Some("deg")), direction]).unwrap_err();
            assert_eq!(refused.message, says);
        }
        let refused = read_table("dip\n90\n", &[dip(None)]).unwrap_err();
        assert!(refused.message.contains("the column `dip`"), "{refused}");
        assert_eq!(read_table("a\n1\n", &[direction]).unwrap(), [None]);
    }

    #[test]
    fn names_a_missing_file() {
        let error = csv_columns(Path::new("/nowhere/x.csv"), &["a"]).unwrap_err();
        assert!(error.message.contains("/nowhere/x.csv"));
        assert!(csv_columns(&std::env::temp_dir(), &["a"]).is_err());
    }
}
