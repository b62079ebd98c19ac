//! Records of earthquakes of the PEER centre: accelerations (`.AT2`), velocities (`.VT2`) and displacements (`.DT2`).
//!
//! Three lines of text, of which the third names the unit, a line with the number of values and their distance in time, then
//! the values, several in a line.
//!
//! Source: PEER NGA strong motion database, files of records; `NPTS=  4000, DT=  .0050 SEC` since 2005, `4000  0.0050  NPTS, DT` before.

use super::{FileError, at_line, shown};
use crate::units::{self, Dim};

/// Most values of a record.
const MOST: usize = 10_000_000;

/// A record.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Distance in time of two values, s.
    pub dt: f64,
    /// What the values are.
    pub dim: Dim,
    /// SI values, the first at time 0.
    pub values: Vec<f64>,
}

/// The record that the bytes of a file describe.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_at2(bytes: &[u8]) -> Result<Record, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    let mut lines = (1..).zip(text.lines());
    let mut unit = None;
    let (line, count, dt) = loop {
        let Some((line, text)) = lines.next() else {
            return Err(at_line(1, "there is no line with NPTS and DT: this is not a PEER record"));
        };
        let upper = text.to_uppercase();
        if upper.contains("NPTS") && upper.contains("DT") {
            let (count, dt) = count_and_step(line, &upper)?;
            break (line, count, dt);
        }
        if let Some((_, said)) = upper.split_once("UNITS OF") {
            unit = Some(unit_of(line, said)?);
        }
    };
    let (factor, dim) = unit
        .ok_or_else(|| at_line(line, "no line above says `IN UNITS OF`, so the unit is unknown"))?;
    let mut values = Vec::new();
    let mut last = line;
    for (line, text) in lines {
        last = line;
        for word in text.split_whitespace() {
            let value = word.parse::<f64>().ok().filter(|x| x.is_finite());
            let value = value.ok_or_else(|| {
                at_line(line, format!("`{}` is not a finite number", shown(word)))
            })?;
            if values.len() == count {
                let text = format!("NPTS declares {count} values, but more follow here");
                return Err(at_line(line, text));
            }
            values.push(factor * value);
        }
    }
    if values.len() != count {
        let text = format!(
            "NPTS declares {count} values, but the file has {}: it is truncated",
            values.len()
        );
        return Err(at_line(last, text));
    }
    Ok(Record { dt, dim, values })
}

/// Number of values and their distance, s.
fn count_and_step(line: usize, text: &str) -> Result<(usize, f64), FileError> {
    let numbers: Vec<&str> = text
        .split(|c: char| c.is_whitespace() || c == ',' || c == '=')
        .filter(|word| word.starts_with(|c: char| c.is_ascii_digit() || c == '.'))
        .collect();
    let count = numbers.first().and_then(|word| word.parse::<usize>().ok());
    let dt = numbers.get(1).and_then(|word| word.parse::<f64>().ok());
    match (count, dt) {
        (Some(count @ 2..=MOST), Some(dt)) if dt > 0.0 && dt.is_finite() => Ok((count, dt)),
        (_, _) => Err(at_line(
            line,
            format!("NPTS (2 to {MOST} values) and DT (a time above 0 s) are expected here"),
        )),
    }
}

/// SI value of 1 in the unit of a record.
fn unit_of(line: usize, said: &str) -> Result<(f64, Dim), FileError> {
    let word: String = said.trim().trim_end_matches('.').replace(' ', "");
    let read = match word.as_str() {
        "G" => Ok((crate::csv_columns::GRAVITY, Dim::ACCELERATION)),
        // Of inches nobody thinks here.
        word => units::parse(&format!("1 {}", word.replace("SEC", "S").to_lowercase())),
    };
    match read {
        Ok((factor, dim)) if [Dim::ACCELERATION, Dim::VELOCITY, Dim::LENGTH].contains(&dim) => {
            Ok((factor, dim))
        }
        Ok(_) | Err(_) => Err(at_line(
            line,
            format!("unknown unit `{}`; valid units: g, cm/s/s, cm/s, cm", shown(said.trim())),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEW: &str = "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/1/1999, Station 1, 090\n\
        ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   5, DT=   .0050 SEC,\n  .1E-02  -.2E-02  .3E-02\n 4.0E-3 0.0\n";

    #[test]
    fn records_of_all_times_are_read() {
        let read = parse_at2(NEW.as_bytes()).unwrap();
        assert_eq!((read.dt, read.dim, read.values.len()), (0.005, Dim::ACCELERATION, 5));
        assert!((read.values[1] + 0.002 * 9.80665).abs() < 1e-15);
        let old = NEW.replace("NPTS=   5, DT=   .0050 SEC,", "    5    0.0050    NPTS, DT");
        assert_eq!(parse_at2(old.as_bytes()).unwrap(), read);
        let velocity = NEW.replace("ACCELERATION", "VELOCITY").replace("OF G", "OF CM/S");
        let velocity = parse_at2(velocity.as_bytes()).unwrap();
        assert_eq!((velocity.dim, velocity.values[0]), (Dim::VELOCITY, 1e-2 * 1e-3));
        let far = NEW.replace("ACCELERATION", "DISPLACEMENT").replace("OF G", "OF CM.");
        assert_eq!(parse_at2(far.as_bytes()).unwrap().dim, Dim::LENGTH);
    }

    #[test]
    fn says_what_is_wrong() {
        let wrong = |from: &str, to: &str| {
            let text = NEW.replace(from, to);
            assert_ne!(text, NEW);
            parse_at2(text.as_bytes()).unwrap_err().to_string()
        };
        assert!(parse_at2(b"hello\n").unwrap_err().to_string().contains("not a PEER record"));
        assert!(wrong("OF G", "OF KG").contains("line 3: unknown unit `KG`"));
        assert!(wrong("IN UNITS OF G", "").contains("line 4: no line above says"));
        assert!(wrong(".0050", "0.0").contains("line 4: NPTS"));
        assert!(wrong("5, DT", "99999999999, DT").contains("line 4: NPTS"));
        assert!(wrong(" 4.0E-3 0.0", " 4.0E-3").contains("declares 5 values, but the file has 4"));
        assert!(
            wrong(" 0.0\n", " 0.0 1.0\n")
                .contains("line 6: NPTS declares 5 values, but more follow here")
        );
        assert!(wrong("4.0E-3", "nan").contains("line 6: `nan` is not a finite number"));
    }
}
