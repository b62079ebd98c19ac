//! Formulas in scenarios: a thin wrapper over the `exmex` expression parser.

use exmex::prelude::*;
use exmex::{FloatOpsFactory, MakeOperators, Operator};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Longest formula text accepted, bytes; parsing is recursive, so the length bounds the depth.
pub const MAX_LENGTH: usize = 2000;
/// Deepest nesting of parentheses accepted.
pub const MAX_DEPTH: usize = 64;

/// Why a formula could not be used.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FormulaError {
    /// Too long or too deeply nested.
    #[error(
        "the formula is too long or too deeply nested (at most {MAX_LENGTH} characters, {MAX_DEPTH} levels)"
    )]
    TooLarge,
    /// The text is not a formula.
    #[error("this is not a formula: {0}")]
    Syntax(String),
    /// A name stands for nothing.
    #[error("`{name}` is not known in this formula; known names are {known}")]
    UnknownName {
        /// The name.
        name: String,
        /// What could stand there.
        known: String,
    },
}

/// A compiled formula of named numbers, e.g. `0.5*g*t^2`.
///
/// `pi` and `deg` (= pi/180) are always known. Functions: sin, cos, tan, asin, acos, atan, atan2,
/// exp, log/ln, sqrt, abs, floor, ceil, sign and the operators + - * / ^.
#[derive(Clone, Debug)]
pub struct Formula {
    text: String,
    // Boxed: the parsed expression is large beside the other time functions.
    expression: Box<FlatEx<f64, Portable>>,
    names: Vec<String>,
}

/// The operators of `exmex` with the functions of `libm`: those of the platform differ in bits from machine to machine.
#[derive(Clone, Debug)]
struct Portable;

impl MakeOperators<f64> for Portable {
    fn make<'a>() -> Vec<Operator<'a, f64>> {
        let given = FloatOpsFactory::<f64>::make().into_iter();
        given
            .map(|given| portable(&given).unwrap_or(given))
            .collect()
    }
}

/// What stands for an operator of `exmex` that would call the platform.
fn portable<'a>(given: &Operator<'a, f64>) -> Option<Operator<'a, f64>> {
    let binary: fn(f64, f64) -> f64 = match given.repr() {
        "^" => libm::pow,
        "atan2" => libm::atan2,
        _ => return Some(Operator::make_unary(given.repr(), unary(given.repr())?)),
    };
    let mut operator = given.bin().ok()?;
    operator.apply = binary;
    Some(Operator::make_bin(given.repr(), operator))
}

fn unary(name: &str) -> Option<fn(f64) -> f64> {
    let function: fn(f64) -> f64 = match name {
        "sin" => libm::sin,
        "cos" => libm::cos,
        "tan" => libm::tan,
        "asin" => libm::asin,
        "acos" => libm::acos,
        "atan" => libm::atan,
        "sinh" => libm::sinh,
        "cosh" => libm::cosh,
        "tanh" => libm::tanh,
        "asinh" => libm::asinh,
        "acosh" => libm::acosh,
        "atanh" => libm::atanh,
        "exp" => libm::exp,
        "cbrt" => libm::cbrt,
        "ln" | "log" => libm::log,
        "log2" => libm::log2,
        "log10" => libm::log10,
        _ => return None,
    };
    Some(function)
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
    /// let fall = Formula::new("0.5*g*t^2", &["t", "g"])?;
    /// assert_eq!(fall.value(&[("t", 2.0), ("g", 10.0)]), 20.0);
    /// # Ok::<(), riprap_core::dynamics::formula::FormulaError>(())
    /// ```
    pub fn new(text: &str, known: &[&str]) -> Result<Self, FormulaError> {
        let formula = Self::compiled(text)?;
        for name in &formula.names {
            if !known.contains(&name.as_str()) && !["pi", "deg"].contains(&name.as_str()) {
                let mut list: Vec<&str> = known.to_vec();
                list.extend(["pi", "deg"]);
                return Err(FormulaError::UnknownName {
                    name: name.clone(),
                    known: list.join(", "),
                });
            }
        }
        Ok(formula)
    }

    fn compiled(text: &str) -> Result<Self, FormulaError> {
        let (mut depth, mut deepest) = (0usize, 0usize);
        for c in text.chars() {
            match c {
                '(' | '{' => depth += 1,
                ')' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            deepest = deepest.max(depth);
        }
        if text.len() > MAX_LENGTH || deepest > MAX_DEPTH {
            return Err(FormulaError::TooLarge);
        }
        let expression = FlatEx::<f64, Portable>::parse(&without_exponents(text))
            .map_err(|e| FormulaError::Syntax(e.to_string()))?;
        let expression = Box::new(expression);
        let names: Vec<String> = expression.var_names().to_vec();
        Ok(Self {
            text: text.to_owned(),
            expression,
            names,
        })
    }

    /// The text it was compiled from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Names it uses besides `pi` and `deg`.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Value with the given names; NaN if one of its names is missing.
    #[must_use]
    pub fn value(&self, values: &[(&str, f64)]) -> f64 {
        let arguments: Vec<f64> = self
            .names
            .iter()
            .map(|name| match name.as_str() {
                "pi" => std::f64::consts::PI,
                "deg" => std::f64::consts::PI / 180.0,
                other => values
                    .iter()
                    .find(|(n, _)| *n == other)
                    .map_or(f64::NAN, |(_, value)| *value),
            })
            .collect();
        self.expression.eval(&arguments).unwrap_or(f64::NAN)
    }
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

/// Writes numbers such as `4e-3` without their exponent, which the parser does not know.
fn without_exponents(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut in_word = false;
    while let Some(c) = rest.chars().next() {
        if in_word || !(c.is_ascii_digit() || c == '.') {
            in_word = c.is_alphanumeric() || c == '_';
            out.push(c);
            rest = &rest[c.len_utf8()..];
            continue;
        }
        let digits =
            |from: &str| from.len() - from.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let mut length = rest.len()
            - rest
                .trim_start_matches(|c: char| c.is_ascii_digit() || c == '.')
                .len();
        if let Some(power) = rest[length..].strip_prefix(['e', 'E']) {
            let sign = usize::from(power.starts_with(['+', '-']));
            let count = digits(&power[sign..]);
            if count > 0 {
                length += 1 + sign + count;
            }
        }
        let (number, after) = rest.split_at(length);
        match number.parse::<f64>() {
            Ok(value) if number.contains(['e', 'E']) && value.is_finite() => {
                out.push_str(&value.to_string());
            }
            _ => out.push_str(number),
        }
        rest = after;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn evaluates_the_sliding_distance() {
        let formula = Formula::new(
            "0.5*g*(sin(35*deg)-cos(35*deg)*tan(phi))*t^2",
            &["g", "phi", "t"],
        )
        .unwrap();
        let phi = 15.0_f64.to_radians();
        let d = formula.value(&[("g", 10.0), ("phi", phi), ("t", 1.5)]);
        assert!((d - 3.983_460).abs() < 1e-6, "{d}");
    }

    #[test]
    fn numbers_may_have_exponents() {
        for (text, value) in [
            ("4e-3", 0.004),
            ("2*1.5E2+1", 301.0),
            ("x1e*2", 10.0),
            ("1e300*1e-300", 1.0),
        ] {
            let formula = Formula::new(text, &["x1e"]).unwrap();
            assert!(
                (formula.value(&[("x1e", 5.0)]) - value).abs() < 1e-12,
                "{text}"
            );
        }
    }

    /// Runs with a check against a formula of other names than `t` could not be resumed.
    #[test]
    fn a_formula_is_read_back_with_all_its_names() {
        let formula = Formula::new("g*t^2/2 + sin(a*deg)", &["t", "g", "a"]).unwrap();
        let bytes = postcard::to_stdvec(&formula).unwrap();
        let again: Formula = postcard::from_bytes(&bytes).unwrap();
        let values = [("t", 2.0), ("g", 10.0), ("a", 30.0)];
        assert_eq!(again.value(&values), formula.value(&values));
        assert!((again.value(&values) - 20.5).abs() < 1e-12);
        assert!(postcard::from_bytes::<Formula>(&[3, b'2', b'*', b'(']).is_err());
    }

    #[test]
    fn functions_are_those_of_libm() {
        // What is left to `exmex` is exact on every machine.
        let exact = [
            "*", "/", "+", "-", "min", "max", "abs", "signum", "floor", "round", "ceil", "trunc",
            "fract", "sqrt", "PI", "π", "E", "e", "TAU", "τ",
        ];
        let names: Vec<&str> = FloatOpsFactory::<f64>::make()
            .iter()
            .filter(|o| portable(o).is_none())
            .map(Operator::repr)
            .collect();
        assert_eq!(names, exact);
        let value = |text: &str| Formula::new(text, &["x"]).unwrap().value(&[("x", 0.37)]);
        for (text, expected) in [
            ("sin(x)", libm::sin(0.37)),
            ("log(x)", libm::log(0.37)),
            ("2*x^1.5", 2.0 * libm::pow(0.37, 1.5)),
            ("x atan2 2", libm::atan2(0.37, 2.0)),
        ] {
            assert_eq!(value(text).to_bits(), expected.to_bits(), "{text}");
        }
    }

    #[test]
    fn names_what_is_not_known() {
        let error = Formula::new("2*q", &["t"]).unwrap_err();
        assert!(error.to_string().contains("`q` is not known"), "{error}");
        assert!(Formula::new("2*(", &["t"]).is_err());
        assert_eq!(
            Formula::new(&"(".repeat(5000), &[]),
            Err(FormulaError::TooLarge)
        );
    }
}
