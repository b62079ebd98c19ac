//! Formulas in scenarios: arithmetic, functions, comparisons and a choice, of named numbers.

mod parse;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Longest formula text accepted, bytes.
pub const MAX_LENGTH: usize = 2000;
/// Deepest nesting accepted: parentheses, functions, signs and powers.
pub const MAX_DEPTH: usize = 64;
/// Functions that formulas know.
pub const FUNCTIONS: &str = "sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, asinh, acosh, atanh, exp, ln (= log), \
     log2, log10, sqrt, cbrt, abs, sign, floor, ceil, round, trunc, fract, min, max, if";

/// Numbers that are always known, unless a name of the same spelling is given.
const CONSTANTS: [(&str, f64); 8] = [
    ("pi", std::f64::consts::PI),
    ("deg", std::f64::consts::PI / 180.0),
    ("π", std::f64::consts::PI),
    ("PI", std::f64::consts::PI),
    ("e", std::f64::consts::E),
    ("E", std::f64::consts::E),
    ("τ", std::f64::consts::TAU),
    ("TAU", std::f64::consts::TAU),
];

/// Why a formula could not be used.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FormulaError {
    /// Too long or too deeply nested.
    #[error(
        "the formula is too long or too deeply nested (at most {MAX_LENGTH} characters, {MAX_DEPTH} levels)"
    )]
    TooLarge,
    /// The text is not a formula.
    #[error("this is not a formula: {message}")]
    Syntax {
        /// Bytes of the text before the place.
        at: usize,
        /// What is wrong there.
        message: String,
    },
    /// A name stands for nothing.
    #[error("unknown name `{name}` in this formula; valid names: {known}")]
    UnknownName {
        /// Bytes of the text before the name.
        at: usize,
        /// The name.
        name: String,
        /// What could stand there.
        known: String,
    },
}

impl FormulaError {
    /// Bytes of the text before the place that is wrong, where there is one.
    #[must_use]
    pub fn at(&self) -> Option<usize> {
        match self {
            Self::TooLarge => None,
            Self::Syntax { at, .. } | Self::UnknownName { at, .. } => Some(*at),
        }
    }
}

/// One instruction of a compiled formula, which works on a stack.
#[derive(Clone, Copy, Debug)]
enum Op {
    Number(f64),
    /// The value of that name.
    Name(usize),
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    /// Takes a condition: goes on if it holds, at `otherwise` if it is zero; NaN for all of it, at `end`, if it is NaN.
    Branch {
        otherwise: usize,
        end: usize,
    },
    Jump(usize),
}

/// A compiled text.
#[derive(Clone, Debug, Default)]
struct Program {
    ops: Vec<Op>,
    /// Names in it, each with its first place.
    names: Vec<(String, usize)>,
}

/// A compiled formula of named numbers, e.g. `0.5*g*t^2`.
///
/// `pi` and `deg` (= pi/180) are always known. Operators + - * / ^ and `< <= > >= == !=` (1 if it holds, 0 if not), functions
/// [`FUNCTIONS`]; `if(condition, then, otherwise)` finds only the value it takes. A sign binds looser than a power:
/// `-t^2` is `-(t^2)`. A value that does not exist (`sqrt(-1)`) is NaN, and so is what is made from it, minima and choices included.
#[derive(Clone, Debug)]
pub struct Formula {
    text: String,
    // Boxed: it is large beside the other time functions.
    program: Box<Program>,
}

impl Formula {
    /// Compiles `text`; `known` lists the names that [`Formula::value`] will be given.
    ///
    /// # Errors
    /// Text that is no formula, is too large, or uses a name that is not in `known`.
    /// # Examples
    ///
    /// ```
    /// use riprap_core::dynamics::Formula;
    ///
    /// let fall = Formula::new("0.5*g*min(t, 3)^2", &["t", "g"])?;
    /// assert_eq!(fall.value(&[("t", 2.0), ("g", 10.0)]), 20.0);
    /// # Ok::<(), riprap_core::dynamics::formula::FormulaError>(())
    /// ```
    pub fn new(text: &str, known: &[&str]) -> Result<Self, FormulaError> {
        let formula = Self::compiled(text)?;
        for (name, at) in &formula.program.names {
            if !known.contains(&name.as_str()) && constant(name).is_none() {
                let mut list: Vec<&str> = known.to_vec();
                list.extend(["pi", "deg"]);
                return Err(FormulaError::UnknownName {
                    at: *at,
                    name: name.clone(),
                    known: list.join(", "),
                });
            }
        }
        Ok(formula)
    }

    fn compiled(text: &str) -> Result<Self, FormulaError> {
        Ok(Self { text: text.to_owned(), program: Box::new(parse::parse(text)?) })
    }

    /// The text it was compiled from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Value with the given names; NaN if one of its names is missing.
    #[must_use]
    pub fn value(&self, values: &[(&str, f64)]) -> f64 {
        let Program { ops, names } = &*self.program;
        let named = |index: usize| {
            let name = names.get(index).map_or("", |(name, _)| name.as_str());
            let given = values.iter().find(|(n, _)| *n == name);
            given.map(|(_, value)| *value).or_else(|| constant(name)).unwrap_or(f64::NAN)
        };
        let mut stack: Vec<f64> = Vec::with_capacity(8);
        let mut at = 0;
        while let Some(op) = ops.get(at) {
            at += 1;
            let value = match op {
                Op::Number(value) => *value,
                Op::Name(index) => named(*index),
                Op::One(apply) => apply(taken(&mut stack)),
                Op::Two(apply) => {
                    let second = taken(&mut stack);
                    apply(taken(&mut stack), second)
                }
                Op::Branch { otherwise, end } => {
                    let condition = taken(&mut stack);
                    if condition.is_nan() {
                        at = *end;
                        condition
                    } else {
                        if condition == 0.0 {
                            at = *otherwise;
                        }
                        continue;
                    }
                }
                Op::Jump(to) => {
                    at = *to;
                    continue;
                }
            };
            stack.push(value);
        }
        taken(&mut stack)
    }
}

/// The number on top; the compiler leaves one wherever one is taken.
fn taken(stack: &mut Vec<f64>) -> f64 {
    stack.pop().unwrap_or(f64::NAN)
}

fn constant(name: &str) -> Option<f64> {
    let found = CONSTANTS.iter().find(|(known, _)| *known == name);
    found.map(|(_, value)| *value)
}

impl PartialEq for Formula {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Serialize for Formula {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.text.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Formula {
    /// Reads a formula whose names were checked when it was made.
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::compiled(&text).map_err(serde::de::Error::custom)
    }
}
