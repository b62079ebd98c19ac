//! Numbers that a run must reproduce, and the search for a limit.

use riprap_keys::{Keys, Words};
use serde::Deserialize;

use super::outputs::Moment;
use crate::quantity::{
    Any, Direction, Length, Name, Names, NotNegativePlain, NotNegativeTime, NumberOrKey, Quantity,
    Table, Vector,
};
use crate::time_function::CsvFunction;

/// Search for the value of a key at which the scene begins to fail.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Bisect {
    /// Key with dots, for example `interfaces.default.friction_angle`.
    pub key: Name,
    /// One end of the interval, with the unit of the key.
    pub low: Quantity<Any>,
    /// Other end of the interval.
    pub high: Quantity<Any>,
    /// Width of the interval at which the search stops.
    pub tolerance: Quantity<Any>,
    /// What counts as failure, evaluated at the end of the run.
    pub fails_when: Criterion,
}

/// A field compared with a limit.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("above", "below"))]
#[keys(at_most_one("of", "at_point", "pins"))]
pub struct Criterion {
    /// Field, for example `model.max_displacement`.
    pub field: Name,
    /// Block, two blocks of a pair, group or source; not for fields of the whole model.
    pub of: Option<Names>,
    /// Instead of a block: the point, m, that lies in it at the start.
    pub at_point: Option<Vector<Length>>,
    /// Two points of the rock, m, in place of two blocks: for `pair.convergence`, `displacement`, `velocity`.
    pub pins: Option<[Vector<Length>; 2]>,
    /// Blocks and groups whose mean displacement or velocity is taken off: for `displacement` and `velocity` of blocks,
    /// groups and nodes.
    pub relative_to: Option<Names>,
    /// Direction in which a vector is measured: in the plane an angle from the x axis, in space a
    /// vector such as `[0, 0, 1]`.
    pub along: Option<Direction>,
    /// How values over the whole run become one number. Default: the value at the end.
    pub reduce: Option<Reduce>,
    /// Fails if the number is larger.
    pub above: Option<Quantity<Any>>,
    /// Fails if the number is smaller.
    pub below: Option<Quantity<Any>>,
}

/// A number that the run must reproduce.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("value", "formula", "csv", "between"))]
#[keys(at_most_one("of", "at_point", "pins"))]
#[keys(at_most_one("at", "over"))]
#[keys(any_of(
    "relative",
    "absolute",
    when = "!between",
    help = "write for example relative = 1e-3"
))]
pub struct Check {
    /// What is checked, in words; printed by `riprap verify`.
    pub name: Name,
    /// Field, for example `block.displacement`; `riprap fields` lists them.
    pub field: Name,
    /// Block, two blocks of a pair, group or source; not for fields of the whole model.
    pub of: Option<Names>,
    /// Instead of a block: the point, m, that lies in it at the start.
    pub at_point: Option<Vector<Length>>,
    /// Two points of the rock, m, in place of two blocks: for `pair.convergence`, `displacement`, `velocity`.
    pub pins: Option<[Vector<Length>; 2]>,
    /// Blocks and groups whose mean displacement or velocity is taken off: for `displacement` and `velocity` of blocks,
    /// groups and nodes.
    pub relative_to: Option<Names>,
    /// Direction in which a vector is measured: in the plane an angle from the x axis, in space a
    /// vector such as `[0, 0, 1]`.
    pub along: Option<Direction>,
    /// Name of a phase: `"start"`, `"end"` and the interval of `reduce` are then those of the phase.
    #[key(excludes(
        "over",
        help = "keep one of them: at = \"start\" and \"end\" go with `phase`, and `reduce`"
    ))]
    pub phase: Option<Name>,
    /// Moment of the check: a time, `"start"` or `"end"`. Default `"end"`.
    pub at: Option<Moment>,
    /// First and last time of an interval, s. Default the whole run.
    #[key(needs(
        "reduce",
        help = "say how the values become one number, for example reduce = \"max\""
    ))]
    pub over: Option<[Quantity<NotNegativeTime>; 2]>,
    /// How values over an interval become one number.
    pub reduce: Option<Reduce>,
    /// Limit, in the unit of the field.
    #[key(needs("reduce = first_above, first_below, share_above"))]
    #[key(required("reduce = first_above, first_below, share_above"))]
    pub threshold: Option<Quantity<Any>>,
    /// Expected number, in the unit of the field.
    pub value: Option<Quantity<Any>>,
    /// Expected number as a [formula](conventions.md#formulas), result in SI units. Names: `t` (s), those of `let`. Example:
    /// `"0.5*g*min(t, 3)^2"`.
    pub formula: Option<Name>,
    /// Expected numbers from a column of a CSV file.
    pub csv: Option<CsvFunction>,
    /// Lowest and highest allowed number, in the unit of the field.
    pub between: Option<[Quantity<Any>; 2]>,
    /// Names for the formula: a number, a value with unit, or a key of the scenario whose SI
    /// value is taken, for example `{ phi = "interfaces.default.friction_angle", g = 9.81 }`.
    #[serde(default, rename = "let")]
    pub names: Table<Quantity<NumberOrKey>>,
    /// Allowed difference as a share of the expected number. With `absolute`, either is enough.
    pub relative: Option<Quantity<NotNegativePlain>>,
    /// Allowed difference, in the unit of the field.
    pub absolute: Option<Quantity<Any>>,
    /// Only in cases of a sweep where these keys have one of these values.
    #[serde(default)]
    #[schemars(with = "std::collections::BTreeMap<String, Vec<serde_json::Value>>")]
    pub when: Table<Vec<toml::Value>>,
    /// Only in these variants. Default all.
    #[serde(default)]
    pub only: Vec<Name>,
    /// Reason why this check is known to fail: it is run and shown, but does not count as failed.
    #[key(excludes(
        "exact",
        help = "an exact check cannot be known to fail: remove `known` and correct the cause"
    ))]
    pub known: Option<Name>,
    /// The quantity is exact or conserved. Default false.
    #[serde(default)]
    pub exact: bool,
}

/// How values over an interval become one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Words)]
pub enum Reduce {
    /// Largest value.
    Max,
    /// Smallest value.
    Min,
    /// Mean over time.
    Mean,
    /// Root of the mean square over time.
    Rms,
    /// Largest less smallest value.
    Range,
    /// First time at which the value is above `threshold`, s.
    FirstAbove,
    /// First time at which it is below `threshold`, s.
    FirstBelow,
    /// Share of the time during which the value is above `threshold`.
    ShareAbove,
}
