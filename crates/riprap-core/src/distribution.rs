//! Distributions of random numbers, samples of several of them, and what a count of failures says.
//!
//! A sample is a quantile of a number between 0 and 1 (inversion), so that the same seed gives the same samples on every machine,
//! and a stratified number gives a stratified sample. All transcendental functions are those of `libm`.

use libm::{erfc, exp, lgamma, log, sqrt};
use riprap_geom::random::Chance;

/// Distribution of a real number.
#[derive(Clone, Debug, PartialEq)]
pub enum Distribution {
    /// Gauss's.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation, > 0.
        deviation: f64,
    },
    /// That of a positive number whose logarithm is normal.
    Lognormal {
        /// Mean of the number itself, > 0.
        mean: f64,
        /// Standard deviation of the number itself, > 0.
        deviation: f64,
    },
    /// All values between two are alike.
    Uniform {
        /// Lowest.
        low: f64,
        /// Highest.
        high: f64,
    },
    /// Density that rises linearly to the mode and falls linearly from there.
    Triangular {
        /// Lowest.
        low: f64,
        /// Most likely.
        mode: f64,
        /// Highest.
        high: f64,
    },
    /// Beta distribution, stretched from `low` to `high`.
    Beta {
        /// Lowest.
        low: f64,
        /// Highest.
        high: f64,
        /// First shape parameter, > 0.
        alpha: f64,
        /// Second shape parameter, > 0.
        beta: f64,
    },
    /// Measured values in growing order, at least two: straight lines between the quantiles `k / (n - 1)`.
    Measured(Vec<f64>),
    /// Whole numbers from the first to the last, all alike.
    Whole {
        /// Lowest.
        low: u64,
        /// Highest.
        high: u64,
    },
}

impl Distribution {
    /// The value below which the share `u` (0 < u < 1) of all values lies.
    #[must_use]
    pub fn quantile(&self, u: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation } => mean + deviation * normal_quantile(u),
            Self::Lognormal { mean, deviation } => {
                let (centre, spread) = logarithmic(*mean, *deviation);
                exp(centre + spread * normal_quantile(u))
            }
            Self::Uniform { low, high } => low + (high - low) * u,
            Self::Triangular { low, mode, high } => {
                let (width, rise) = (high - low, mode - low);
                if u * width < rise {
                    low + sqrt(u * width * rise)
                } else {
                    high - sqrt((1.0 - u) * width * (high - mode))
                }
            }
            Self::Beta { low, high, alpha, beta } => {
                low + (high - low) * beta_quantile(*alpha, *beta, u)
            }
            Self::Measured(values) => {
                let at = u * (values.len() - 1) as f64;
                let below = (at as usize).min(values.len() - 2);
                values[below] + (at - below as f64) * (values[below + 1] - values[below])
            }
            Self::Whole { low, high } => {
                let count = (high - low + 1) as f64;
                (*low as f64 + libm::floor(u * count)).min(*high as f64)
            }
        }
    }

    /// The share of all values up to `x`.
    #[must_use]
    pub fn cumulative(&self, x: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation } => normal_cumulative((x - mean) / deviation),
            Self::Lognormal { .. } if x <= 0.0 => 0.0,
            Self::Lognormal { mean, deviation } => {
                let (centre, spread) = logarithmic(*mean, *deviation);
                normal_cumulative((log(x) - centre) / spread)
            }
            Self::Uniform { low, high } => ((x - low) / (high - low)).clamp(0.0, 1.0),
            Self::Triangular { low, mode, high } => {
                let width = high - low;
                if x <= *low {
                    0.0
                } else if x < *mode {
                    (x - low) * (x - low) / (width * (mode - low))
                } else if x < *high {
                    1.0 - (high - x) * (high - x) / (width * (high - mode))
                } else {
                    1.0
                }
            }
            Self::Beta { low, high, alpha, beta } => {
                beta_cumulative(*alpha, *beta, ((x - low) / (high - low)).clamp(0.0, 1.0))
            }
            Self::Measured(values) => {
                let above = values.partition_point(|value| *value <= x);
                if above == 0 || above == values.len() {
                    return if above == 0 { 0.0 } else { 1.0 };
                }
                let (left, right) = (values[above - 1], values[above]);
                ((above - 1) as f64 + (x - left) / (right - left)) / (values.len() - 1) as f64
            }
            Self::Whole { low, high } => {
                let count = (high - low + 1) as f64;
                ((libm::floor(x) - *low as f64 + 1.0) / count).clamp(0.0, 1.0)
            }
        }
    }
}

/// Mean and standard deviation of the logarithm of a lognormal number with that mean and standard deviation.
fn logarithmic(mean: f64, deviation: f64) -> (f64, f64) {
    let variance = libm::log1p((deviation / mean) * (deviation / mean));
    (log(mean) - 0.5 * variance, sqrt(variance))
}

/// The share of a standard normal number below `z`.
#[must_use]
pub fn normal_cumulative(z: f64) -> f64 {
    0.5 * erfc(-z * std::f64::consts::FRAC_1_SQRT_2)
}

/// The standard normal number below which the share `u` (0 < u < 1) lies.
#[must_use]
pub fn normal_quantile(u: f64) -> f64 {
    // The tail is halved, where `erfc` keeps its relative precision.
    let (tail, sign) = if u < 0.5 { (u, -1.0) } else { (1.0 - u, 1.0) };
    if tail >= 0.5 {
        return 0.0;
    }
    -sign * lower_half(|z| normal_cumulative(z) < tail, -40.0, 0.0)
}

/// Regularised incomplete beta function I_x(a, b): the share of a beta distributed number below `x`.
///
/// Source: continued fraction 8.17.22 of the NIST Digital Library of Mathematical Functions, evaluated by Lentz's method.
#[must_use]
pub fn beta_cumulative(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 || x >= 1.0 {
        return if x <= 0.0 { 0.0 } else { 1.0 };
    }
    // The fraction converges fast on this side of the mean.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - beta_cumulative(b, a, 1.0 - x);
    }
    let front = exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * libm::log1p(-x)) / a;
    let away = |value: f64| if value.abs() < 1e-300 { 1e-300 } else { value };
    let mut d = 1.0 / away(1.0 - (a + b) * x / (a + 1.0));
    let (mut c, mut fraction) = (1.0, d);
    for m in 1..500 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        d = 1.0 / away(1.0 + even * d);
        c = away(1.0 + even / c);
        fraction *= c * d;
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        d = 1.0 / away(1.0 + odd * d);
        c = away(1.0 + odd / c);
        fraction *= c * d;
        if (c * d - 1.0).abs() < 1e-15 {
            break;
        }
    }
    front * fraction
}

/// The beta distributed number below which the share `u` lies.
#[must_use]
pub fn beta_quantile(a: f64, b: f64, u: f64) -> f64 {
    lower_half(|x| beta_cumulative(a, b, x) < u, 0.0, 1.0)
}

/// Where `below` ceases to hold between two numbers, by bisection down to neighbouring numbers.
fn lower_half(below: impl Fn(f64) -> bool, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..1100 {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high {
            break;
        }
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// The interval in which a probability lies with the confidence `level`, after `failed` of `all` independent trials failed.
///
/// Source: Clopper and Pearson, Biometrika 26 (1934), the exact interval; it covers at least `level`.
#[must_use]
pub fn failure_interval(failed: usize, all: usize, level: f64) -> [f64; 2] {
    let (k, n, tail) = (failed as f64, all as f64, 0.5 * (1.0 - level));
    let low = if failed == 0 { 0.0 } else { beta_quantile(k, n - k + 1.0, tail) };
    let high = if failed == all { 1.0 } else { beta_quantile(k + 1.0, n - k, 1.0 - tail) };
    [low, high]
}

/// Rank correlation of two lists of the same length (Spearman): 1 where both grow together, -1 where one falls as the other
/// grows; `None` where one of them has a single value. Equal values share their mean rank.
#[must_use]
pub fn rank_correlation(x: &[f64], y: &[f64]) -> Option<f64> {
    let [x, y] = [ranks(x), ranks(y)];
    let middle = 0.5 * (x.len() as f64 - 1.0);
    let product = |a: &[f64], b: &[f64]| -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - middle) * (b - middle)).sum()
    };
    let scale = sqrt(product(&x, &x) * product(&y, &y));
    (scale > 0.0).then(|| product(&x, &y) / scale)
}

/// Ranks from 0, equal values with the mean of theirs.
fn ranks(values: &[f64]) -> Vec<f64> {
    let order = ascending(values);
    let mut ranks = vec![0.0; values.len()];
    let mut begin = 0;
    while begin < order.len() {
        let same = |k: &&usize| values[**k] == values[order[begin]];
        let end = begin + order[begin..].iter().take_while(same).count().max(1);
        for k in &order[begin..end] {
            ranks[*k] = 0.5 * (begin + end - 1) as f64;
        }
        begin = end;
    }
    ranks
}

/// Numbers of the values from the smallest to the largest, equal ones in their order.
fn ascending(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    order
}

/// How numbers between 0 and 1 are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// One number in each of as many equal strata as there are samples, the strata of each variable in random order.
    ///
    /// Source: McKay, Beckman and Conover, Technometrics 21 (1979).
    LatinHypercube,
    /// Independent numbers.
    Random,
}

/// A square matrix of correlations that no set of numbers has: it is not positive definite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoCorrelation;

/// Numbers between 0 and 1, a list of `samples` for each of `variables`; those of variables that `correlations` (pair and
/// coefficient between normal numbers of the same ranks) names are correlated.
///
/// With the Latin hypercube each variable keeps its strata: normal numbers with just these correlations, those by chance taken out,
/// give the order only (after Iman and Conover, Communications in Statistics B11 (1982)).
///
/// # Errors
/// Correlations that contradict each other.
///
/// # Examples
///
/// ```
/// use riprap_core::distribution::{Sampling, unit_samples};
///
/// let drawn = unit_samples(2, 4, 1, Sampling::LatinHypercube, &[]).unwrap();
/// let mut strata: Vec<usize> = drawn[0].iter().map(|u| (u * 4.0) as usize).collect();
/// strata.sort_unstable();
/// assert_eq!(strata, [0, 1, 2, 3]);
/// ```
pub fn unit_samples(
    variables: usize,
    samples: usize,
    seed: u64,
    sampling: Sampling,
    correlations: &[(usize, usize, f64)],
) -> Result<Vec<Vec<f64>>, NoCorrelation> {
    let wanted = cholesky(&matrix_of(variables, correlations))?;
    let mut chance = Chance::new(seed);
    let mut drawn: Vec<Vec<f64>> =
        (0..variables).map(|_| column(&mut chance, samples, sampling)).collect();
    if sampling == Sampling::Random && correlations.is_empty() {
        return Ok(drawn);
    }
    let mut normal: Vec<Vec<f64>> =
        drawn.iter().map(|column| column.iter().map(|u| normal_quantile(*u)).collect()).collect();
    if sampling == Sampling::LatinHypercube {
        uncorrelate(&mut normal);
    }
    for (i, row) in wanted.iter().enumerate() {
        let mixed: Vec<f64> = (0..samples)
            .map(|k| row[..=i].iter().zip(&normal).map(|(share, z)| share * z[k]).sum())
            .collect();
        drawn[i] = match sampling {
            Sampling::Random => mixed.iter().map(|z| inside(normal_cumulative(*z))).collect(),
            Sampling::LatinHypercube => in_order_of(&drawn[i], &mixed),
        };
    }
    Ok(drawn)
}

/// Takes out the correlation that columns have by chance: some hundredths between hundreds of samples, as much as what is asked for.
/// Fewer samples than columns stay as they are.
fn uncorrelate(columns: &mut [Vec<f64>]) {
    let n = columns.len();
    for column in columns.iter_mut() {
        let count = column.len() as f64;
        let mean = column.iter().sum::<f64>() / count;
        column.iter_mut().for_each(|z| *z -= mean);
        let size = sqrt(column.iter().map(|z| z * z).sum::<f64>() / count);
        column.iter_mut().for_each(|z| *z /= size);
    }
    let product =
        |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / a.len() as f64;
    let chance: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| product(&columns[i], &columns[j])).collect()).collect();
    let Ok(factor) = cholesky(&chance) else {
        return;
    };
    for (i, row) in factor.iter().enumerate() {
        let (before, from) = columns.split_at_mut(i);
        for (k, z) in from[0].iter_mut().enumerate() {
            let others: f64 = row.iter().zip(before.iter()).map(|(share, of)| share * of[k]).sum();
            *z = (*z - others) / row[i];
        }
    }
}

/// Numbers of one variable.
fn column(chance: &mut Chance, samples: usize, sampling: Sampling) -> Vec<f64> {
    if sampling == Sampling::Random {
        return (0..samples).map(|_| inside(chance.unit())).collect();
    }
    let mut strata: Vec<usize> = (0..samples).collect();
    for k in (1..samples).rev() {
        strata.swap(k, chance.whole(0, k));
    }
    let share = 1.0 / samples as f64;
    strata.iter().map(|stratum| inside((*stratum as f64 + chance.unit()) * share)).collect()
}

/// Quantiles of 0 and 1 may be infinite.
fn inside(u: f64) -> f64 {
    u.clamp(1e-16, 1.0 - 1e-16)
}

/// `values` in the order of the ranks of `leader`.
fn in_order_of(values: &[f64], leader: &[f64]) -> Vec<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let mut placed = vec![0.0; values.len()];
    for (value, k) in sorted.iter().zip(ascending(leader)) {
        placed[k] = *value;
    }
    placed
}

/// The symmetric matrix of correlations.
fn matrix_of(n: usize, correlations: &[(usize, usize, f64)]) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; n]; n];
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    for (i, j, coefficient) in correlations {
        matrix[*i][*j] = *coefficient;
        matrix[*j][*i] = *coefficient;
    }
    matrix
}

/// Lower triangle L with L L^T equal to a matrix of correlations.
fn cholesky(matrix: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, NoCorrelation> {
    let n = matrix.len();
    let mut factor = vec![vec![0.0; n]; n];
    for j in 0..n {
        for i in j..n {
            let dot: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = matrix[i][j] - dot;
            if i > j {
                factor[i][j] = rest / factor[j][j];
            } else if rest > 1e-12 {
                factor[i][i] = sqrt(rest);
            } else {
                return Err(NoCorrelation);
            }
        }
    }
    Ok(factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<Distribution> {
        vec![
            Distribution::Normal { mean: 3.0, deviation: 2.0 },
            Distribution::Lognormal { mean: 3.0, deviation: 2.0 },
            Distribution::Uniform { low: -1.0, high: 5.0 },
            Distribution::Triangular { low: 1.0, mode: 2.0, high: 6.0 },
            Distribution::Triangular { low: 1.0, mode: 1.0, high: 6.0 },
            Distribution::Beta { low: 1.0, high: 3.0, alpha: 2.5, beta: 0.7 },
            Distribution::Measured(vec![1.0, 2.0, 4.0, 4.5]),
        ]
    }

    #[test]
    fn quantiles_undo_the_cumulative_share() {
        for distribution in all() {
            for u in [1e-6, 0.01, 0.3, 0.5, 0.77, 0.999] {
                let back = distribution.cumulative(distribution.quantile(u));
                assert!((back - u).abs() < 1e-11, "{distribution:?} {u} {back}");
            }
        }
        let whole = Distribution::Whole { low: 3, high: 5 };
        assert_eq!([0.01, 0.4, 0.99].map(|u| whole.quantile(u)), [3.0, 4.0, 5.0]);
        assert!((whole.cumulative(4.0) - 2.0 / 3.0).abs() < 1e-15);
    }

    /// Values of published tables.
    #[test]
    fn known_numbers() {
        assert!((normal_quantile(0.975) - 1.959_963_984_540_054).abs() < 1e-13);
        assert!((normal_quantile(1e-9) + 5.997_807_015_007_686).abs() < 1e-10);
        assert_eq!(normal_quantile(0.5), 0.0);
        // Binomial tail: P(X <= 3) of 10 trials with p = 0.3.
        assert!((beta_cumulative(7.0, 4.0, 0.7) - 0.649_610_717_9).abs() < 1e-9);
        // 0 of 10: 1 - 0.025^(1/10).
        let [low, high] = failure_interval(0, 10, 0.95);
        assert!(low == 0.0 && (high - (1.0 - libm::pow(0.025, 0.1))).abs() < 1e-12);
        assert_eq!(failure_interval(10, 10, 0.95)[1], 1.0);
    }

    #[test]
    fn the_mean_and_deviation_of_samples_are_those_asked_for() {
        let drawn = unit_samples(1, 10_000, 7, Sampling::LatinHypercube, &[]).unwrap();
        for (distribution, mean, deviation) in [
            (Distribution::Normal { mean: 3.0, deviation: 2.0 }, 3.0, 2.0),
            (Distribution::Lognormal { mean: 3.0, deviation: 2.0 }, 3.0, 2.0),
            (Distribution::Uniform { low: -1.0, high: 5.0 }, 2.0, sqrt(3.0)),
            (Distribution::Triangular { low: 1.0, mode: 2.0, high: 6.0 }, 3.0, sqrt(21.0 / 18.0)),
        ] {
            let values: Vec<f64> = drawn[0].iter().map(|u| distribution.quantile(*u)).collect();
            let n = values.len() as f64;
            let found = values.iter().sum::<f64>() / n;
            let spread = sqrt(values.iter().map(|v| (v - found) * (v - found)).sum::<f64>() / n);
            assert!((found - mean).abs() < 2e-3 * deviation, "{distribution:?}: {found}");
            assert!((spread / deviation - 1.0).abs() < 0.02, "{distribution:?}: {spread}");
        }
    }

    #[test]
    fn correlated_samples_keep_their_strata() {
        for (sampling, tolerance) in [(Sampling::LatinHypercube, 0.005), (Sampling::Random, 0.05)] {
            let pairs = [(0, 1, -0.6), (1, 2, 0.3)];
            let drawn = unit_samples(3, 2000, 5, sampling, &pairs).unwrap();
            for (i, j, wanted) in pairs {
                // Pearson's coefficient of normal numbers and Spearman's of their ranks.
                let wanted = 6.0 / std::f64::consts::PI * libm::asin(0.5 * wanted);
                let found = rank_correlation(&drawn[i], &drawn[j]).unwrap();
                assert!((found - wanted).abs() < tolerance, "{sampling:?}: {found} of {wanted}");
            }
            if sampling == Sampling::LatinHypercube {
                for column in &drawn {
                    let mut sorted = column.clone();
                    sorted.sort_by(f64::total_cmp);
                    assert!(sorted.iter().enumerate().all(|(k, u)| (u * 2000.0) as usize == k));
                }
            }
        }
        let impossible = [(0, 1, 0.9), (1, 2, 0.9), (0, 2, -0.9)];
        assert_eq!(unit_samples(3, 10, 1, Sampling::Random, &impossible), Err(NoCorrelation));
    }

    #[test]
    fn ranks_of_equal_values_are_shared() {
        assert_eq!(ranks(&[2.0, 1.0, 2.0, 5.0]), [1.5, 0.0, 1.5, 3.0]);
        assert_eq!(rank_correlation(&[1.0, 2.0, 3.0], &[1.0, 1.0, 1.0]), None);
        assert_eq!(rank_correlation(&[1.0, 2.0, 3.0], &[9.0, 4.0, 1.0]), Some(-1.0));
    }
}
