//! Where each number of a model came from.

use serde::Serialize;

/// Where a value came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Provenance {
    /// The scenario says so.
    Given,
    /// Nobody said anything.
    Default,
    /// Computed from other values.
    Derived,
}

/// One resolved key.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Explained {
    /// Key as in the scenario, `interfaces.default.normal_stiffness`; blocks, phases and checks by
    /// name.
    pub key: String,
    /// Value with its unit; as written if it was given.
    pub value: String,
    /// Where it came from.
    pub from: Provenance,
    /// How it was derived, or what the default means; may be empty.
    pub why: String,
}

/// A number with its unit, short.
pub(super) fn with_unit(value: f64, unit: &str) -> String {
    let size = value.abs();
    let number = if value != 0.0 && !(1e-3..1e6).contains(&size) {
        format!("{value:.6e}")
    } else {
        // At most six digits after the point, without trailing zeros.
        let text = format!("{value:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    if unit.is_empty() || unit == "-" {
        number
    } else {
        format!("{number} {unit}")
    }
}
