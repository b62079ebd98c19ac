//! One value against what its key expects: unit, dimension, range, and what to write instead.

use super::diagnostic::{Diagnostic, short};
use super::quantity::{KindInfo, Raw, Span};
use super::units::{self, Dim};

/// Smallest value in SI above zero of a key with a unit that takes no zero; see [`largest`].
const SMALLEST: f64 = 1e-30;

/// Largest value in SI that a key takes: products of several of them, such as energies and moments of inertia, are then numbers still. No block is
/// faster than light, or turns once in the time that a run can resolve. Numbers that a field is compared with have no such bounds.
fn largest(dim: Dim) -> f64 {
    match dim {
        Dim::VELOCITY | Dim::SPIN => 1e9,
        _ => 1e30,
    }
}

/// What is wrong with a value of a kind, if anything.
pub(super) fn check_quantity(
    raw: &Raw,
    span: Span,
    kind: &KindInfo,
    key: &str,
    si: bool,
) -> Option<Diagnostic> {
    let example = format!("write for example {}", assignment(key, kind.example));
    let refused = |code, what: &str| {
        Diagnostic::error(code, format!("`{key}` {what}")).at(span.clone()).help(example.clone())
    };
    let (value, dim) = match raw {
        Raw::Number(number) => {
            // Where any dimension will do, the number is looked at again once its field is known.
            let bare_allowed = si || kind.dim.is_none() || kind.dim == Some(Dim::NONE);
            if !bare_allowed {
                return Some(missing_unit(&number.to_string(), span.clone(), kind, key));
            }
            (*number, kind.dim.unwrap_or(Dim::NONE))
        }
        Raw::Text(text) => {
            let is_key = text.starts_with(|c: char| c.is_alphabetic());
            if kind.name == "NumberOrKey" && is_key && text.contains('.') {
                return None; // rules look it up
            }
            match units::parse(text) {
                Ok((_, Dim::NONE)) if kind.dim.is_some_and(|dim| dim != Dim::NONE) => {
                    return Some(missing_unit(text.trim(), span.clone(), kind, key));
                }
                Ok(read) => read,
                Err(error) => {
                    let unknown = error.message.starts_with("unknown unit");
                    let code = if unknown { "unit.unknown" } else { "value.number" };
                    let what = format!("= \"{}\": {}", short(text), error.message);
                    let refused = refused(code, &what).label(format!("{} is expected", kind.what));
                    return Some(match error.help {
                        // No example of another quantity than the key takes.
                        Some(help) if help.contains(units::ANY_EXAMPLE) => {
                            let one = format!("1 {}", text.trim());
                            match units::parse(&one) {
                                // A unit alone.
                                Ok((_, dim)) if kind.dim == Some(dim) && dim != Dim::NONE => {
                                    let help =
                                        format!("write for example {}", assignment(key, &one));
                                    refused.help(help)
                                }
                                _ => refused,
                            }
                        }
                        Some(help) => refused.help(help),
                        None => refused,
                    });
                }
            }
        }
    };
    if let Some(expected) = kind.dim
        && expected != dim
    {
        let (label, help) = wrong_dimension(raw, value, dim, kind, key);
        return Some(refused("unit.dimension", "has the wrong dimension").label(label).help(help));
    }
    if !value.is_finite() {
        return Some(refused("value.finite", "is not a finite number"));
    }
    let label = if kind.bounds.contains(value) {
        kind.dim.and_then(|dim| beyond(value, dim, kind))
    } else {
        Some(format!("must be {}", kind.bounds.text))
    };
    label.map(|label| refused("value.range", "is out of range").label(label))
}

/// What a finite value of a dimension has to be, where nothing could be calculated with it.
fn beyond(value: f64, dim: Dim, kind: &KindInfo) -> Option<String> {
    let positive = kind.bounds.low == 0.0 && !kind.bounds.low_closed && dim != Dim::NONE;
    let largest = largest(dim);
    if value.abs() > largest {
        Some(format!("must be at most {largest:e} in SI units"))
    } else if positive && value < SMALLEST {
        Some(format!("must be at least {SMALLEST:e} in SI units"))
    } else {
        None
    }
}

fn missing_unit(number: &str, span: Span, kind: &KindInfo, key: &str) -> Diagnostic {
    let unit = kind.example.split_once(' ').map_or("", |(_, unit)| unit);
    Diagnostic::error("unit.missing", format!("`{key}` has no unit"))
        .at(span)
        .label(format!("bare number, {} is expected", kind.what))
        .help(format!(
            "write {key} = \"{} {unit}\" (or set `units = \"SI\"` at the top of the file)",
            short(number)
        ))
}

/// Label and help for a value of the wrong dimension.
fn wrong_dimension(
    raw: &Raw,
    value: f64,
    dim: Dim,
    kind: &KindInfo,
    key: &str,
) -> (String, String) {
    let text = raw.to_string();
    let unit = text.trim_start_matches(|c: char| !c.is_alphabetic()).trim();
    let expected = kind.dim.unwrap_or(Dim::NONE);
    let label = |is: &str| format!("this is {is}, {} is expected", kind.what);
    let example = format!("for example {}", assignment(key, kind.example));
    match (expected, dim) {
        // Force per volume has the dimension of pressure per length.
        (Dim::DENSITY, Dim::STIFFNESS_PER_AREA) => (
            label("a unit weight (force per volume)"),
            format!("divide it by 9.81 m/s2: {key} = \"{:.0} kg/m3\"", value / 9.81),
        ),
        (Dim::STIFFNESS_PER_AREA, Dim::PRESSURE) => (
            label("a modulus or pressure"),
            format!("a joint stiffness is a pressure per metre of closure: {example}"),
        ),
        (Dim::STIFFNESS_PER_AREA, Dim::FORCE_PER_LENGTH) => (
            label("the stiffness of a single spring (force per length)"),
            format!("divide it by the area on which the spring acts: {example}"),
        ),
        (Dim::PRESSURE, Dim::STIFFNESS_PER_AREA) => {
            (label("a pressure per length"), format!("without the \"/m\": {example}"))
        }
        (Dim::FORCE_PER_LENGTH, Dim::FORCE) if kind.spatial.is_some() => (
            label("a force"),
            format!("in two dimensions forces are per metre of thickness: {example}"),
        ),
        (Dim::FORCE, Dim::ENERGY) if kind.spatial.is_some() => (
            label("an energy or moment"),
            format!("in two dimensions it is per metre of thickness: {example}"),
        ),
        (Dim::ACCELERATION, Dim::MASS) if unit == "g" => {
            (label("a mass: g is gram"), format!("write accelerations in m/s2: {example}"))
        }
        (Dim::SPIN, Dim::RATE) => {
            (label("a rate (1 per time)"), format!("say which angle: {example}"))
        }
        (Dim::RATE, Dim::SPIN) => {
            (label("a spin (angle per time)"), format!("count full waves: {example}"))
        }
        _ => (label(&dim.describe()), format!("write {example}")),
    }
}

/// `key = "10 MPa"`, or without quotes if it is a bare number.
pub(super) fn assignment(key: &str, example: &str) -> String {
    if example.parse::<f64>().is_ok() {
        format!("{key} = {example}")
    } else {
        format!("{key} = \"{example}\"")
    }
}
