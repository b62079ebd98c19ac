//! Values that change with time, as the user writes them.

use schemars::JsonSchema;
use serde::Deserialize;

use super::quantity::{
    Angle, Frequency, Kind, Name, NotNegativeTime, Plain, PositivePlain, PositiveRate,
    PositiveTime, Quantity, Time,
};

/// What formulas over time know.
pub const OF_TIME: [&str; 1] = ["t"];
/// What formulas of a motion that is prescribed point by point know: the place at the start (m) beside the time.
pub const OF_PLACE_AND_TIME: [&str; 4] = ["t", "x", "y", "z"];

/// A value over time; `K` is the kind of the value.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", bound(deserialize = "K: Kind"))]
pub enum TimeFunction<K: Kind> {
    /// The same value at all times, for example `constant = "1 m/s2"`.
    Constant(Quantity<K>),
    /// `from` before `start`, `to` after `end`, a straight line between.
    Ramp(Ramp<K>),
    /// A sine wave.
    Sine(Sine<K>),
    /// `value` between `start` and `end`, zero outside.
    Pulse(Pulse<K>),
    /// Two exponentials (Duvall): zero at time 0, a fast rise to `peak`, a slow decay.
    Duvall(Duvall<K>),
    /// A triangle: zero at time 0, straight up to `peak`, straight down to zero.
    Triangle(Triangle<K>),
    /// A column of a CSV file over a time column: straight lines between the rows, the first and
    /// last value outside. Units are those that the names of the columns say.
    Csv(CsvFunction),
    /// A record of the PEER database (`.AT2`, `.VT2`, `.DT2`): straight lines between its values, the first and last value outside.
    At2(RecordFunction),
    /// A formula in `t` (seconds of model time), result in SI units, for example `"if(t < 2, 3*sin(2*pi*t), 0)"`.
    Formula(Name),
}

/// Straight line in time between two constant values.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, bound(deserialize = "K: Kind"))]
pub struct Ramp<K: Kind> {
    /// Value up to `start`.
    pub from: Quantity<K>,
    /// Value after `end`.
    pub to: Quantity<K>,
    /// Time at which the change begins, s. Default 0 s.
    pub start: Option<Quantity<Time>>,
    /// Time at which the change is complete, s; after `start`.
    pub end: Quantity<Time>,
}

/// Sine wave: offset + amplitude sin(2 pi frequency (t - start) + phase).
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, bound(deserialize = "K: Kind"))]
pub struct Sine<K: Kind> {
    /// Largest distance from `offset`.
    pub amplitude: Quantity<K>,
    /// Full waves per second, Hz.
    pub frequency: Quantity<Frequency>,
    /// Angle of the wave at `start`. Default 0 deg.
    pub phase: Option<Quantity<Angle>>,
    /// Time at which it begins, s; `offset` before. Default 0 s.
    pub start: Option<Quantity<NotNegativeTime>>,
    /// Value about which it swings. Default 0.
    pub offset: Option<Quantity<K>>,
    /// Number of full waves, then the value stays at `offset`. Default: never ends.
    pub cycles: Option<Quantity<PositivePlain>>,
}

/// A value for a limited time.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, bound(deserialize = "K: Kind"))]
pub struct Pulse<K: Kind> {
    /// Value during the pulse; zero outside.
    pub value: Quantity<K>,
    /// Beginning of the pulse, s. Default 0 s.
    pub start: Option<Quantity<NotNegativeTime>>,
    /// End of the pulse, s; after `start`.
    pub end: Quantity<Time>,
}

/// amplitude (exp(-decay t) - exp(-rise t)), the amplitude such that the largest value is `peak`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, bound(deserialize = "K: Kind"))]
pub struct Duvall<K: Kind> {
    /// Largest value.
    pub peak: Quantity<K>,
    /// Rate of the slow exponential, 1/s; below `rise`.
    pub decay: Quantity<PositiveRate>,
    /// Rate of the fast exponential, 1/s.
    pub rise: Quantity<PositiveRate>,
}

/// Up and down along straight lines.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, bound(deserialize = "K: Kind"))]
pub struct Triangle<K: Kind> {
    /// Largest value.
    pub peak: Quantity<K>,
    /// Time from zero to the peak, s.
    pub rise: Quantity<PositiveTime>,
    /// Time from the peak back to zero, s.
    pub fall: Quantity<PositiveTime>,
}

/// Values from two columns of a CSV file.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CsvFunction {
    /// Path of the CSV file.
    pub file: Name,
    /// Name of the column with the time, with or without its unit (`t_ms`, or `t`); s where it names none. It must grow.
    pub time: Name,
    /// Name of the column with the values, with or without their unit (`a_g`, or `a`); SI where it names none.
    pub column: Name,
    /// Unit of the values, stronger than that of their name, for example "g" or "cm/s2"; "1" for plain numbers.
    pub unit: Option<Name>,
    /// Factor on the values. Default 1.
    pub scale: Option<Quantity<Plain>>,
}

/// Values from a record of an earthquake, in the unit that it names.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordFunction {
    /// Path of the record.
    pub file: Name,
    /// Factor on the values. Default 1.
    pub scale: Option<Quantity<Plain>>,
}
