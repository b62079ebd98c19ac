//! Columns of numbers from a CSV file: one convention for every file that a scene names.
//!
//! - Commas, semicolons or tabs stand between cells, whichever the head has most of. With semicolons and tabs the decimal
//!   sign may be a comma.
//! - The first line names the columns. Empty lines and lines that begin with `#` are left out; a comment right above
//!   rows of numbers may be the head.
//! - A name has its unit behind an underscore or in brackets: `delay_ms`, `delay [ms]`, `Delay (ms)`. Capitals, spaces,
//!   underscores and points make no difference. Without a unit places are in m, angles of planes in degrees, columns that
//!   the user chooses in SI; what was taken so is noted. Delays, charges and diameters of holes must name theirs.
//! - A second line of units is read too.

use std::path::Path;

use super::diagnostic::{short, suggest};
use super::plain_file;
use super::units::Dim;

mod head;
#[cfg(test)]
mod tests;
mod text;

pub(crate) use head::GRAVITY;
use head::{Cell, find, plain, unit_of};
use text::Rows;

/// Largest CSV file accepted, bytes.
pub const MAX_CSV_SIZE: u64 = 64 << 20;
/// Names of columns that a message lists.
const LISTED: usize = 60;

/// A column that is wanted.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// Names that a file may give it, the usual one first.
    pub names: &'a [&'a str],
    /// What it measures.
    pub dim: Dim,
    /// Unit of a column that names none; `None` refuses such a column.
    pub usual: Option<&'a str>,
    /// Whether a file without it is refused.
    pub needed: bool,
    /// Whether the user gave the name: a cell with just these letters is the column.
    pub chosen: bool,
    /// SI value of 1 where the scene says the unit; that of the head is not looked at then.
    pub given: Option<f64>,
}

impl<'a> Column<'a> {
    /// A column without which a file is of no use; `usual` is the unit of one that names none.
    #[must_use]
    pub const fn needed(names: &'a [&'a str], dim: Dim, usual: &'a str) -> Self {
        Column { names, dim, usual: Some(usual), needed: true, chosen: false, given: None }
    }

    /// A column that may be missing.
    #[must_use]
    pub const fn optional(names: &'a [&'a str], dim: Dim, usual: &'a str) -> Self {
        let mut column = Self::needed(names, dim, usual);
        column.needed = false;
        column
    }

    /// The same column without a usual unit: files differ, and it must name its own.
    #[must_use]
    pub const fn with_unit(mut self) -> Self {
        self.usual = None;
        self
    }

    /// A column whose name the user chose. Without a unit it is in SI; an angle must have one, since degrees are as
    /// usual as radians.
    #[must_use]
    pub fn chosen(name: &'a [&'a str; 1], dim: Dim, usual: &'a str) -> Self {
        Column {
            usual: (dim != Dim::ANGLE).then_some(usual),
            chosen: true,
            ..Self::needed(name, dim, usual)
        }
    }
}

/// A column of a table as it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// As the file calls it.
    pub name: String,
    /// Its numbers, SI.
    pub values: Vec<f64>,
    /// SI value of 1 in the file.
    pub factor: f64,
    /// Unit that was taken because its name says none.
    pub taken: Option<String>,
}

/// A table as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<const N: usize> {
    /// The columns in the order in which they were asked for; those that are needed are there.
    pub columns: [Option<Found>; N],
    /// Line of the file of each row, counted from 1.
    pub lines: Vec<usize>,
    /// Rows without any text, which were left out.
    pub empty: usize,
    /// Whether commas were decimal signs.
    pub decimal_comma: bool,
}

impl<const N: usize> Table<N> {
    /// Values of a column, which are empty where it is not there.
    #[must_use]
    pub fn values(&self, column: usize) -> &[f64] {
        let found = self.columns[column].as_ref();
        found.map_or(&[], |found| &found.values)
    }

    /// What a reader should know: rows read and left out, units that were taken, the decimal sign.
    #[must_use]
    pub fn note(&self) -> String {
        let rows = self.lines.len();
        let mut words = format!("read {rows} of {} rows", rows + self.empty);
        if self.empty > 0 {
            words.push_str(&format!("; left out {} because they are empty", self.empty));
        }
        let mut units: Vec<(&str, Vec<&str>)> = Vec::new();
        for found in self.columns.iter().flatten() {
            let Some(unit) = found.taken.as_deref().filter(|unit| !unit.is_empty()) else {
                continue;
            };
            match units.iter_mut().find(|(known, _)| *known == unit) {
                Some((_, names)) => names.push(&found.name),
                None => units.push((unit, vec![&found.name])),
            }
        }
        for (unit, names) in units {
            words.push_str(&format!("; {} without a unit, read in {unit}", names.join(", ")));
        }
        if self.decimal_comma {
            words.push_str("; decimal commas");
        }
        words
    }
}

/// Reads the columns of a file.
///
/// # Errors
/// A text for the user: no plain file, too large, a column that is missing or in a wrong unit, a cell that is no finite
/// number.
pub fn csv_table<const N: usize>(path: &Path, columns: &[Column; N]) -> Result<Table<N>, CsvError> {
    let bytes = plain_file::read(path, MAX_CSV_SIZE)
        .map_err(|error| CsvError { message: error.message, help: error.help })?;
    parse_table(&bytes, columns).map_err(|error| CsvError {
        message: format!("`{}`, {}", path.display(), error.message),
        help: error.help,
    })
}

/// The texts of a column with the line of each in the file, counted from 1.
///
/// # Errors
/// As [`csv_table`]; a row without a text there.
pub fn csv_labels(path: &Path, name: &str) -> Result<Vec<(usize, String)>, CsvError> {
    let bytes = plain_file::read(path, MAX_CSV_SIZE)
        .map_err(|error| CsvError { message: error.message, help: error.help })?;
    labels(&bytes, name).map_err(|error| CsvError {
        message: format!("`{}`, {}", path.display(), error.message),
        help: error.help,
    })
}

fn labels(bytes: &[u8], name: &str) -> Result<Vec<(usize, String)>, CsvError> {
    let text = text::decode(bytes)?;
    let mut rows = text::rows(&text)?;
    let at = rows.head.iter().position(|cell| plain(cell) == plain(name));
    let Some(at) = at else {
        let wanted = [name];
        return Err(missing(&rows.head, &Column::needed(&wanted, Dim::NONE, "")));
    };
    let mut found = Vec::new();
    while rows.next()? {
        let (line, cell) = (rows.line, rows.row.get(at).unwrap_or_default());
        found.push((line, cell.to_owned()));
    }
    Ok(found)
}

/// Reads the columns from the bytes of a file; see [`csv_table`].
///
/// # Errors
/// As [`csv_table`], but for the file.
pub fn parse_table<const N: usize>(
    bytes: &[u8],
    columns: &[Column; N],
) -> Result<Table<N>, CsvError> {
    let text = text::decode(bytes)?;
    let mut rows = text::rows(&text)?;
    let mut cells = [None; N];
    for (cell, column) in cells.iter_mut().zip(columns) {
        *cell = find(&rows.head, column)?;
        if cell.is_none() && column.needed {
            return Err(missing(&rows.head, column));
        }
    }
    let mut more = rows.next()?;
    if more && take_units(&rows, &mut cells, columns)? {
        more = rows.next()?;
    }
    let mut found = cells.map(|cell| cell.map(|cell| rows.found(&cell)));
    for ((found, cell), column) in found.iter_mut().zip(&cells).zip(columns) {
        if let (Some(found), Some(Cell { bare: true, .. })) = (found, cell) {
            found.taken = column.usual.map(str::to_owned);
        }
    }
    let mut decimals = Decimals::new(rows.separator);
    let mut lines = Vec::new();
    while more {
        for (found, cell) in found.iter_mut().zip(&cells) {
            if let (Some(found), Some(cell)) = (found, cell) {
                let text = rows.row.get(cell.at).unwrap_or_default();
                let number = decimals.number(rows.line, &found.name, text)?;
                found.values.push(number * cell.factor);
            }
        }
        lines.push(rows.line);
        more = rows.next()?;
    }
    if lines.is_empty() {
        return Err(CsvError::new(
            "there are no rows of numbers below the header",
            "give at least one row",
        ));
    }
    Ok(Table { columns: found, lines, empty: rows.empty, decimal_comma: decimals.comma.is_some() })
}

impl Rows<'_> {
    /// A column without numbers.
    fn found(&self, cell: &Cell) -> Found {
        Found {
            name: self.head[cell.at].clone(),
            values: Vec::new(),
            factor: cell.factor,
            taken: None,
        }
    }
}

/// Takes the units that the first row names for columns whose names say none. Whether it is a row of units.
fn take_units<const N: usize>(
    rows: &Rows,
    cells: &mut [Option<Cell>; N],
    columns: &[Column; N],
) -> Result<bool, CsvError> {
    let mut factors = [None; N];
    for ((factor, cell), column) in factors.iter_mut().zip(cells.iter()).zip(columns) {
        let Some(cell) = cell else { continue };
        let text = rows.row.get(cell.at).unwrap_or_default();
        let text = text.trim_matches(['[', ']', '(', ')']).trim();
        let plain = column.dim == Dim::NONE && matches!(text, "" | "-" | "1");
        match unit_of(text, column.dim) {
            _ if !cell.bare => return Ok(false),
            _ if plain => *factor = Some(1.0),
            // A row of numbers, or of what is looked at as a number.
            _ if !text.starts_with(|c: char| c.is_alphabetic() || c == '°') => return Ok(false),
            Ok((value, dim)) if dim == column.dim => *factor = Some(value),
            Ok((_, dim)) => {
                let (line, name) = (rows.line, short(&rows.head[cell.at]));
                let is = dim.describe();
                let message = format!("line {line}, column `{name}`: the unit `{text}` is {is}");
                let help = format!("expected: {}", column.dim.describe());
                return Err(CsvError::new(&message, &help));
            }
            Err(_) => return Ok(false),
        }
    }
    // Cells that are all plain numbers are a row of numbers.
    if !columns.iter().zip(&factors).any(|(c, f)| c.dim != Dim::NONE && f.is_some()) {
        return Ok(false);
    }
    for (cell, factor) in cells.iter_mut().zip(factors) {
        if let (Some(cell), Some(factor)) = (cell, factor) {
            (cell.factor, cell.bare) = (factor, false);
        }
    }
    Ok(true)
}

/// A column that is not there.
fn missing(head: &[String], column: &Column) -> CsvError {
    let name = column.names[0];
    let usual = column.usual.unwrap_or_default();
    let known: Vec<&str> = head.iter().map(String::as_str).collect();
    let like = suggest(name, known.iter().copied().filter(|c| c.len() < LISTED));
    let like = like.filter(|help| help.starts_with("did"));
    let example = match usual {
        "" => format!("`{name}`"),
        unit => format!("`{name}_{}`", unit.replace('/', "_")),
    };
    let columns = short(&known.join(", "));
    let help = match like {
        _ if known.len() == 1 => format!(
            "the only column is {columns}; separate columns by commas, semicolons or tabs, and name one {example}"
        ),
        Some(like) => format!("{like} the columns are {columns}"),
        None => format!("the columns are {columns}; name one {example}"),
    };
    CsvError::new(&format!("there is no column `{name}`"), &help)
}

/// Numbers with one decimal sign in the whole file.
struct Decimals {
    /// Whether a comma can be a decimal sign.
    commas: bool,
    /// Lines of the first number with each sign.
    point: Option<usize>,
    comma: Option<usize>,
}

impl Decimals {
    fn new(separator: u8) -> Self {
        Decimals { commas: separator != b',', point: None, comma: None }
    }

    fn number(&mut self, line: usize, name: &str, text: &str) -> Result<f64, CsvError> {
        let wrong = |what: &str, help: &str| {
            let (name, text) = (short(name), short(text));
            CsvError::new(&format!("line {line}, column `{name}`: \"{text}\" is {what}"), help)
        };
        let commas = text.matches(',').count();
        let number = match commas {
            1 if self.commas && !text.contains('.') => text.replacen(',', ".", 1).parse::<f64>(),
            _ => text.parse::<f64>(),
        };
        let number = match number {
            Ok(number) if number.is_finite() => number,
            Ok(_) => {
                return Err(wrong("not a finite number", "correct the row, or remove it"));
            }
            Err(_) if text.is_empty() => {
                let message = format!("line {line}, column `{}`: the cell is empty", short(name));
                let help = "give a number, or remove the row";
                return Err(CsvError::new(&message, help));
            }
            Err(_) if commas > 0 => {
                let help = "write the number without thousands separators; a decimal comma needs semicolons or tabs between cells";
                return Err(wrong("not a number", help));
            }
            Err(_) => return Err(wrong("not a number", "correct the row, or remove it")),
        };
        let sign = match (commas, text.contains('.')) {
            (0, false) => return Ok(number),
            (0, true) => &mut self.point,
            (_, _) => &mut self.comma,
        };
        sign.get_or_insert(line);
        if let (Some(point), Some(comma)) = (self.point, self.comma) {
            let message = format!(
                "line {line}, column `{}`: line {comma} has a decimal comma, and line {point} a decimal point",
                short(name)
            );
            let help = "use one decimal sign in the whole file, and no thousands separators";
            return Err(CsvError::new(&message, help));
        }
        Ok(number)
    }
}

/// SI value of 1 in a unit for values of a dimension, written as in a head; "1" and "-" are plain numbers.
///
/// # Errors
/// A text for the user: no unit, or one of another dimension.
pub fn unit(text: &str, dim: Dim) -> Result<f64, String> {
    let plain = matches!(text.trim(), "1" | "-" | "");
    match unit_of(text, dim) {
        _ if plain && dim == Dim::NONE => Ok(1.0),
        Ok((factor, found)) if found == dim => Ok(factor),
        Ok((_, found)) => Err(format!("\"{}\" is {}", short(text), found.describe())),
        Err(error) => Err(error.message),
    }
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
    fn new(message: &str, help: &str) -> Self {
        CsvError { message: message.to_owned(), help: (!help.is_empty()).then(|| help.to_owned()) }
    }
}
