//! Random values of keys, and how many samples of them are run.

use riprap_keys::{Keys, Words};
use serde::Deserialize;

use super::checks::Criterion;
use crate::quantity::{Any, Name, Plain, PositivePlain, Quantity};

/// Distribution of the value of a key, in its unit.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("normal", "lognormal", "uniform", "triangular", "beta", "whole", "csv"))]
pub struct RandomValue {
    /// Normal distribution.
    pub normal: Option<Moments>,
    /// Distribution of a positive number whose logarithm is normal; mean and standard deviation are those of the number itself.
    pub lognormal: Option<Moments>,
    /// Lowest and highest value, all between alike.
    pub uniform: Option<[Quantity<Any>; 2]>,
    /// Lowest, most likely and highest value.
    pub triangular: Option<[Quantity<Any>; 3]>,
    /// Beta distribution between two values.
    pub beta: Option<Beta>,
    /// First and last of whole numbers, all alike: for seeds of random joints and cells.
    pub whole: Option<[u64; 2]>,
    /// Measured values: a column of a CSV file. Between their quantiles are straight lines.
    pub csv: Option<MeasuredValues>,
    /// Only values above this one: the distribution is cut off there.
    #[key(excludes("whole"))]
    pub above: Option<Quantity<Any>>,
    /// Only values below this one.
    #[key(excludes("whole"))]
    pub below: Option<Quantity<Any>>,
}

/// Mean and standard deviation of a distribution.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("deviation", "variation"))]
pub struct Moments {
    /// Mean.
    pub mean: Quantity<Any>,
    /// Standard deviation.
    pub deviation: Option<Quantity<Any>>,
    /// Coefficient of variation: standard deviation as a share of the mean.
    pub variation: Option<Quantity<PositivePlain>>,
}

/// Beta distribution between two values.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Beta {
    /// Lowest and highest value.
    pub between: [Quantity<Any>; 2],
    /// First shape parameter: with `alpha` larger than `beta` most values are near the highest one.
    pub alpha: Quantity<PositivePlain>,
    /// Second shape parameter.
    pub beta: Quantity<PositivePlain>,
}

/// A column of measured values.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct MeasuredValues {
    /// Path of the CSV file.
    pub file: Name,
    /// Name of the column, with or without its unit (`phi_deg`, or `phi`).
    pub column: Name,
}

/// Random samples of the keys in `[distributions]` (`riprap monte-carlo`).
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct MonteCarlo {
    /// Number of samples.
    #[key(min = 2, max = 10_000)]
    pub samples: u32,
    /// Seed of the random numbers: the same seed gives the same samples.
    #[key(default = 1)]
    pub seed: Option<u64>,
    /// How the samples are drawn.
    #[key(default)]
    pub sampling: Option<Sampling>,
    /// Pairs of keys whose values are correlated.
    #[serde(default)]
    pub correlations: Vec<Correlation>,
    /// What counts as failure, evaluated at the end of each run: the probability of failure is reported.
    pub fails_when: Option<Criterion>,
}

/// Correlation of the values of two keys.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Correlation {
    /// Both keys, as `[distributions]` names them.
    pub between: [Name; 2],
    /// Coefficient of correlation, greater than -1 and less than 1, of the normal numbers with the same ranks (Gaussian copula).
    pub coefficient: Quantity<Plain>,
}

/// How samples are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Words)]
pub enum Sampling {
    /// One value of each key in each of as many equally likely intervals as there are samples: means converge faster.
    #[default]
    LatinHypercube,
    /// Independent values.
    Random,
}
