//! Names of columns: which cell of a head is the column that is wanted, and in what unit it is.

use super::{Column, CsvError};
use crate::units::{self, Dim};

/// Standard gravity, m/s2: `g` of an acceleration.
pub(crate) const GRAVITY: f64 = 9.806_65;

/// A cell of the head that names a column.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// Its place.
    pub at: usize,
    /// SI value of 1.
    pub factor: f64,
    /// Whether it says no unit.
    pub bare: bool,
}

/// How a cell of the head fits a column.
enum Fit {
    /// It is another column.
    Not,
    /// It is the column.
    Is(Cell),
    /// It would be, but for its unit.
    Refused(CsvError),
}

/// The cell of the head that names the column; none where it is not there.
pub(super) fn find(head: &[String], column: &Column) -> Result<Option<Cell>, CsvError> {
    let mut refused = None;
    let mut found: Option<Cell> = None;
    // A name that the user gives as it stands means that cell, whatever else is like it.
    let exact: Vec<usize> =
        (0..head.len()).filter(|k| column.chosen && head[*k] == column.names[0]).collect();
    let places = if exact.is_empty() { (0..head.len()).collect() } else { exact };
    for at in places {
        match fit(&head[at], at, column) {
            Fit::Not => {}
            Fit::Is(cell) => {
                if let Some(first) = found {
                    return Err(both(&head[first.at], &head[at], column.names[0]));
                }
                found = Some(cell);
            }
            Fit::Refused(error) => {
                refused.get_or_insert(error);
            }
        }
    }
    match (found, refused) {
        (None, Some(refused)) => Err(refused),
        (found, _) => Ok(found),
    }
}

fn fit(cell: &str, at: usize, column: &Column) -> Fit {
    let known = |name: &str| {
        let name = plain(name);
        column.names.iter().any(|known| plain(known) == name)
    };
    let bare = |factor: f64| Fit::Is(Cell { at, factor, bare: true });
    let whole = known(without_unit(cell));
    // The scene says it: what stands in the head is not looked at.
    if let Some(factor) = column.given {
        let named = |(name, ..): &(&str, &str, bool)| known(name);
        return match whole || name_and_unit(cell).iter().any(named) {
            true => Fit::Is(Cell { at, factor, bare: false }),
            false => Fit::Not,
        };
    }
    let mut wrong = None;
    for (name, unit, bracketed) in name_and_unit(cell) {
        if !whole && !known(name) {
            continue;
        }
        match unit_of(unit, column.dim) {
            Ok((factor, dim)) if dim == column.dim => {
                return Fit::Is(Cell { at, factor, bare: false });
            }
            Ok((_, dim)) => {
                let message = format!("the column `{cell}` is {}", dim.describe());
                // The longest unit that can be read is the one that is meant: `v_mm_s` is no time.
                wrong = Some(CsvError::new(&message, &remedy(column)));
            }
            // `center_x`: what stands behind the underscore need be no unit.
            Err(_) if !bracketed && (whole || !column.needed) => {}
            Err(error) => {
                let message = format!("the column `{cell}`: {}", error.message);
                let help = error.help.unwrap_or_default();
                wrong.get_or_insert(CsvError::new(&message, &help));
            }
        }
    }
    match (wrong, whole) {
        (Some(error), _) => Fit::Refused(error),
        (None, false) => Fit::Not,
        (None, true) => match column.usual {
            Some(usual) => match unit_of(usual, column.dim) {
                Ok((factor, _)) => bare(factor),
                Err(_) => bare(1.0),
            },
            None => {
                let message = format!("the column `{cell}` has no unit");
                Fit::Refused(CsvError::new(&message, &remedy(column)))
            }
        },
    }
}

/// How to write the name of a column.
fn remedy(column: &Column) -> String {
    let what = column.dim.describe();
    let name = column.names[0];
    let examples: &[&str] = match column.dim {
        Dim::NONE => return format!("expected: {what}; leave the unit out of the name"),
        Dim::ANGLE => &["deg", "rad"],
        Dim::TIME => &["ms", "s"],
        Dim::LENGTH => &["mm", "m"],
        Dim::MASS => &["kg"],
        dim => {
            return format!("expected: {what}; name it for example `{name} [{}]`", dim.unit());
        }
    };
    let names: Vec<String> = examples.iter().map(|unit| format!("`{name} [{unit}]`")).collect();
    format!("expected: {what}; name it for example {}", names.join(" or "))
}

/// Two columns of which either could be meant.
fn both(first: &str, second: &str, wanted: &str) -> CsvError {
    let message = if first == second {
        format!("the column `{first}` is given twice")
    } else {
        format!("the columns `{first}` and `{second}` both give `{wanted}`")
    };
    CsvError::new(&message, "remove one of them, or rename it")
}

/// A cell of the head whose last part stands in brackets.
fn bracketed(cell: &str) -> Option<(&str, &str)> {
    let parts = [['[', ']'], ['(', ')']]
        .into_iter()
        .find_map(|[open, close]| cell.strip_suffix(close)?.split_once(open));
    parts.map(|(name, unit)| (name.trim(), unit.trim()))
}

/// A cell without brackets that hold no unit.
fn without_unit(cell: &str) -> &str {
    match bracketed(cell) {
        Some((name, "" | "-")) => name,
        Some(_) | None => cell,
    }
}

/// Ways to read a cell of the head as a name and a unit, the longest name first; whether the unit stands in brackets.
fn name_and_unit(cell: &str) -> Vec<(&str, &str, bool)> {
    match bracketed(cell) {
        Some((_, "" | "-")) => return Vec::new(),
        Some((name, unit)) => return vec![(name, unit, true)],
        None => {}
    }
    let ends = cell.rmatch_indices(['_', ' ']);
    let parts = ends.map(|(at, _)| (&cell[..at], &cell[at + 1..]));
    let parts = parts.filter(|(name, unit)| !name.is_empty() && !unit.is_empty());
    parts.map(|(name, unit)| (name, unit, false)).collect()
}

/// SI value of 1 of a unit as it stands in a head: an underscore divides (`a_m_s2` is in m/s2), words may be spelled
/// out, capitals make no difference where only one unit has these letters. `g` is gravity where an acceleration is
/// wanted.
pub(super) fn unit_of(text: &str, dim: Dim) -> Result<(f64, Dim), units::UnitError> {
    let text = text.trim();
    if dim == Dim::ACCELERATION {
        let share = match text.to_lowercase().as_str() {
            "g" | "g0" => Some(1.0),
            "mg" => Some(1e-3),
            "%g" | "% g" => Some(1e-2),
            _ => None,
        };
        if let Some(share) = share {
            return Ok((share * GRAVITY, dim));
        }
    }
    let text = text.replace('_', "/");
    match units::parse(&format!("1 {text}")) {
        Ok(read) => Ok(read),
        Err(error) => units::parse(&format!("1 {}", units::spelled(&text))).map_err(|_| error),
    }
}

/// A name without what makes no difference.
pub(super) fn plain(name: &str) -> String {
    let kept = name.chars().filter(|c| !matches!(c, ' ' | '_' | '-' | '.'));
    kept.flat_map(char::to_lowercase).collect()
}
