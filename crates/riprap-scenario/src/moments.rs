//! Words for moments and intervals: `"1 ms"`, `"10 steps"`, `"1 phase"`, `"start"`, `"end"`.

use riprap_core::rhythm::Every;

use super::quantity::Raw;
use super::units::{self, Dim, UnitError};

/// What [`super::language::Every`] says: `"1 ms"`, `"10 steps"`, `"1 phase"` or `"never"`.
///
/// # Errors
/// Anything else; a time that is not greater than zero.
pub(crate) fn read_interval(raw: &Raw) -> Result<Every, UnitError> {
    let help =
        "write a time (\"1 ms\"), a number of steps (\"10 steps\"), \"1 phase\" or \"never\"";
    let wrong =
        |message: &str| UnitError { message: message.to_owned(), help: Some(help.to_owned()) };
    let Raw::Text(text) = raw else {
        return Err(wrong("a bare number: is it a time or a number of steps?"));
    };
    let words: Vec<&str> = text.split_whitespace().collect();
    match words[..] {
        ["never"] => Ok(Every::Never),
        ["phase"] | ["1", "phase"] => Ok(Every::Phase),
        [count, "step" | "steps"] => match count.parse::<u64>() {
            Ok(count) if count > 0 => Ok(Every::Steps(count)),
            _ => Err(wrong("the number of steps must be a whole number of at least 1")),
        },
        _ => match units::parse(text) {
            Ok((time, Dim::TIME)) if time > 0.0 => Ok(Every::Time(time)),
            Ok((_, Dim::TIME)) => Err(wrong("the time between outputs must be greater than zero")),
            Ok((_, Dim::NONE)) => Err(wrong("the unit is missing")),
            Ok((_, dim)) => {
                Err(wrong(&format!("this is {}, an interval is expected", dim.describe())))
            }
            // What begins with a digit was meant as a time, whose own error says more.
            Err(error) if text.starts_with(|c: char| c.is_ascii_digit()) => Err(error),
            Err(_) => Err(wrong("this is no interval")),
        },
    }
}

/// What [`super::language::Period`] says: a period in m, or none.
///
/// # Errors
/// Anything else; a length that is not greater than zero.
pub(crate) fn read_period(raw: &Raw, bare_is_si: bool) -> Result<Option<f64>, UnitError> {
    let wrong = |message: &str| UnitError {
        message: message.to_owned(),
        help: Some("write a length (\"32 m\") or \"none\"".to_owned()),
    };
    let (length, dim) = match raw {
        Raw::Number(length) if bare_is_si => (*length, Dim::LENGTH),
        Raw::Number(_) => return Err(wrong("the unit is missing")),
        Raw::Text(text) if text.trim() == "none" => return Ok(None),
        Raw::Text(text) => units::parse(text).map_err(|error| {
            if text.starts_with(|c: char| c.is_ascii_digit()) {
                error
            } else {
                wrong("this is no period")
            }
        })?,
    };
    if dim == Dim::NONE {
        Err(wrong("the unit is missing"))
    } else if dim != Dim::LENGTH {
        Err(wrong(&format!("this is {}", dim.describe())))
    } else if !length.is_finite() || length <= 0.0 {
        Err(wrong("a period is greater than zero"))
    } else {
        Ok(Some(length))
    }
}

/// What [`super::language::Moment`] says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    /// Model time, s.
    Time(f64),
    /// Before the first step.
    Start,
    /// After the last step.
    End,
}

impl When {
    /// Reads `"1.5 s"`, `"start"` or `"end"`.
    ///
    /// # Errors
    /// Anything else; a negative time.
    pub fn read(raw: &Raw, bare_is_si: bool) -> Result<Self, UnitError> {
        let wrong = |message: &str| UnitError {
            message: message.to_owned(),
            help: Some("write a time (\"1.5 s\"), \"start\" or \"end\"".to_owned()),
        };
        let (time, dim) = match raw {
            Raw::Number(time) if bare_is_si => (*time, Dim::TIME),
            Raw::Number(_) => return Err(wrong("the unit is missing")),
            Raw::Text(text) => match text.trim() {
                "start" => return Ok(When::Start),
                "end" => return Ok(When::End),
                other => units::parse(other).map_err(|error| {
                    if other.starts_with(|c: char| c.is_ascii_digit()) {
                        error
                    } else {
                        wrong("this is no moment of the run")
                    }
                })?,
            },
        };
        if dim == Dim::NONE {
            Err(wrong("the unit is missing"))
        } else if dim != Dim::TIME {
            Err(wrong(&format!("this is {}, a time is expected", dim.describe())))
        } else if !time.is_finite() || time < 0.0 {
            Err(wrong("a moment of the run is zero or more"))
        } else {
            Ok(When::Time(time))
        }
    }
}
