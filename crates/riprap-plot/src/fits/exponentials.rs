//! Rise and decay `p0 (exp(-a t) - exp(-b t)) + plateau`.

use super::{FitError, mean, spread, usable};

/// A pressure that rises, decays and stays: `p0 (exp(-a t) - exp(-b t)) + plateau`, `a < b`.
///
/// Source: Duvall (1953), Geophysics 18, 310-323, for the two exponentials. Deviation: the plateau is ours; the gas of
/// a sealed cavity keeps a pressure, on which the rise and decay stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoExponential {
    /// Amplitude, in the unit of the values.
    pub p0: f64,
    /// Rate of the decay, 1/s.
    pub a: f64,
    /// Rate of the rise, 1/s.
    pub b: f64,
    /// Value after a long time.
    pub plateau: f64,
    /// Time of `t = 0`, s: that of the first sample, or a step before it where the rise is over by then.
    pub start: f64,
    /// Share of the variance that the fit explains.
    pub r2: f64,
    /// The rate of the rise is at the limit of the search: the samples do not resolve the rise.
    pub rise_unresolved: bool,
    /// The rate of the decay is at the limit of the search: the samples end long before the decay does.
    pub decay_unresolved: bool,
}

impl TwoExponential {
    /// Value at a time in s on the clock of the samples.
    pub fn at(&self, time: f64) -> f64 {
        let t = time - self.start;
        self.p0 * (libm::exp(-self.a * t) - libm::exp(-self.b * t)) + self.plateau
    }
}

/// Rates of the grid of the search.
const RATES: usize = 48;
/// Share of the top that the first sample reaches where the rise is over by then.
const RISEN: f64 = 0.9;

/// Fits `p0 (exp(-a t) - exp(-b t)) + plateau` by least squares; every sample counts alike.
///
/// For given `a` and `b` the rest is linear and solved exactly. The rates are looked for on a logarithmic grid from a
/// tenth of 1/duration to ten times 1/(smallest step), then refined by a simplex (Nelder & Mead 1965, Computer
/// Journal 7, 308-313).
///
/// # Errors
/// Fewer than six samples, times that do not ascend, values that are all the same.
pub fn two_exponential(time: &[f64], values: &[f64]) -> Result<TwoExponential, FitError> {
    let (time, y) = usable(time, values, |_, _| true);
    let (found, needed) = (time.len(), 6);
    if found < needed {
        return Err(FitError::TooFew { found, needed });
    }
    let step = time.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    if step <= 0.0 {
        return Err(FitError::NotAscending);
    }
    // A record that begins at its peak has risen within the step before.
    let start = if risen(&y) { time[0] - step } else { time[0] };
    let t: Vec<f64> = time.iter().map(|v| v - start).collect();
    let syy = spread(&y, &y);
    let size = y.iter().fold(0.0, |s: f64, v| s.max(v.abs()));
    // The round-off of a constant.
    if syy <= 1e-24 * size * size * found as f64 {
        return Err(FitError::Constant { what: "values" });
    }
    // From a tenth of one decay in the whole record to ten in one step: beyond, rates cannot be told from each other.
    let limits = [libm::log(0.1 / t[found - 1]), libm::log((10.0 / step).max(1.0 / t[found - 1]))];
    let cost = |rates: [f64; 2]| -> f64 {
        let inside = rates.iter().all(|r| (limits[0]..=limits[1]).contains(r));
        // Equal rates leave nothing of the curve, and a factor without bounds.
        if !inside || rates[1] - rates[0] < 1e-3 {
            return f64::INFINITY;
        }
        let f = shape(&t, rates);
        let (sff, sfy) = (spread(&f, &f), spread(&f, &y));
        if sff > 0.0 { syy - sfy * sfy / sff } else { syy }
    };
    let spacing = (limits[1] - limits[0]) / (RATES - 1) as f64;
    let mut best = on_grid(&t, &y, limits[0], spacing);
    for width in [0.7 * spacing, 0.1 * spacing] {
        best = simplex(best, width, cost);
    }
    let f = shape(&t, best);
    let p0 = spread(&f, &y) / spread(&f, &f);
    let plateau = mean(&y) - p0 * mean(&f);
    let rest: f64 = f.iter().zip(&y).map(|(f, y)| y - p0 * f - plateau).map(|e| e * e).sum();
    Ok(TwoExponential {
        p0,
        a: libm::exp(best[0]),
        b: libm::exp(best[1]),
        plateau,
        start,
        r2: 1.0 - rest / syy,
        rise_unresolved: limits[1] - best[1] < 0.5 * spacing,
        decay_unresolved: best[0] - limits[0] < 0.5 * spacing,
    })
}

/// Whether the first sample stands near the top already, seen from the last one: the law begins with its plateau, so
/// that the rise must come before.
fn risen(y: &[f64]) -> bool {
    let last = y.last().copied().unwrap_or(0.0);
    let top = y.iter().fold(0.0, |s: f64, v| s.max((v - last).abs()));
    y.first().is_some_and(|first| (first - last).abs() >= RISEN * top)
}

/// `exp(-a t) - exp(-b t)` for the logarithms of the rates.
fn shape(t: &[f64], rates: [f64; 2]) -> Vec<f64> {
    let [a, b] = rates.map(libm::exp);
    t.iter().map(|t| libm::exp(-a * t) - libm::exp(-b * t)).collect()
}

/// The best pair of the grid. Sums of products of the exponentials are made once, so a pair costs nothing.
fn on_grid(t: &[f64], y: &[f64], low: f64, spacing: f64) -> [f64; 2] {
    let rate = |i: usize| low + i as f64 * spacing;
    let decays: Vec<Vec<f64>> = (0..RATES)
        .map(|i| {
            let a = libm::exp(rate(i));
            t.iter().map(|t| libm::exp(-a * t)).collect()
        })
        .collect();
    let with_y: Vec<f64> = decays.iter().map(|d| spread(d, y)).collect();
    let own: Vec<f64> = decays.iter().map(|d| spread(d, d)).collect();
    let (mut best, mut found) = (0.0, [rate(RATES / 2), rate(RATES / 2 + 1)]);
    for i in 0..RATES {
        for j in i + 1..RATES {
            let sff = own[i] - 2.0 * spread(&decays[i], &decays[j]) + own[j];
            let sfy = with_y[i] - with_y[j];
            let explained = sfy * sfy / sff;
            // What is left of two curves that are nearly the same is round-off.
            if sff > 1e-9 * (own[i] + own[j]) && explained > best {
                (best, found) = (explained, [rate(i), rate(j)]);
            }
        }
    }
    found
}

/// Nelder and Mead's simplex in two dimensions.
pub(super) fn simplex(start: [f64; 2], width: f64, cost: impl Fn([f64; 2]) -> f64) -> [f64; 2] {
    let mut corners: Vec<([f64; 2], f64)> =
        [[0.0, 0.0], [width, 0.3 * width], [-0.3 * width, -width]]
            .iter()
            .map(|d| [start[0] + d[0], start[1] + d[1]])
            .map(|p| (p, cost(p)))
            .collect();
    for _ in 0..400 {
        corners.sort_by(|a, b| a.1.total_cmp(&b.1));
        let (p, q, worst) = (corners[0].0, corners[1].0, corners[2].0);
        let size =
            (0..2).map(|k| (p[k] - worst[k]).abs().max((p[k] - q[k]).abs())).fold(0.0, f64::max);
        if size < 1e-12 {
            break;
        }
        let along = |s: f64| [0, 1].map(|k| 0.5 * (p[k] + q[k]) * (1.0 + s) - s * worst[k]);
        let tried = |s: f64| (along(s), cost(along(s)));
        let mirrored = tried(1.0);
        let next = if mirrored.1 < corners[0].1 {
            let far = tried(2.0);
            if far.1 < mirrored.1 { far } else { mirrored }
        } else if mirrored.1 < corners[1].1 {
            mirrored
        } else {
            let near = tried(if mirrored.1 < corners[2].1 { 0.5 } else { -0.5 });
            if near.1 < corners[2].1.min(mirrored.1) {
                near
            } else {
                for c in &mut corners[1..] {
                    c.0 = [0, 1].map(|k| 0.5 * (c.0[k] + p[k]));
                    c.1 = cost(c.0);
                }
                continue;
            }
        };
        corners[2] = next;
    }
    corners.sort_by(|a, b| a.1.total_cmp(&b.1));
    corners[0].0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(n: usize, end: f64, law: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
        let t: Vec<f64> = (0..n).map(|i| end * i as f64 / (n - 1) as f64).collect();
        let y = t.iter().map(|t| law(*t)).collect();
        (t, y)
    }

    #[test]
    fn known_parameters_come_back() {
        for (p0, a, b, plateau) in [
            (2.0e9, 1500.0, 40_000.0, 4.0e8),
            (1.0, 2000.0, 3000.0, -0.2),
            (-5.0, 800.0, 9000.0, 3.0),
            (1e8, 3000.0, 3600.0, 0.0),
        ] {
            let (t, y) = samples(400, 4e-3, |t| p0 * ((-a * t).exp() - (-b * t).exp()) + plateau);
            let later: Vec<f64> = t.iter().map(|t| t + 0.25).collect();
            let f = two_exponential(&later, &y).unwrap();
            let near = |found: f64, wanted: f64| (found / wanted - 1.0).abs() < 1e-4;
            assert!(near(f.a, a) && near(f.b, b) && near(f.p0, p0), "{f:?}");
            assert!((f.plateau - plateau).abs() < 1e-6 * p0.abs(), "{f:?}");
            assert!(f.r2 > 1.0 - 1e-10 && !f.rise_unresolved && !f.decay_unresolved);
            assert!((f.at(later[50]) - y[50]).abs() < 1e-6 * p0.abs());
        }
    }

    #[test]
    fn scatter_lowers_r2() {
        let law = |t: f64| 3.0 * ((-500.0 * t).exp() - (-20_000.0 * t).exp()) + 1.0;
        let (t, y) = samples(1000, 0.01, |t| law(t) + 0.3 * (9e5 * t).sin());
        let f = two_exponential(&t, &y).unwrap();
        let exact: Vec<f64> = t.iter().map(|t| law(*t)).collect();
        let wanted = 1.0 - 1000.0 * 0.045 / spread(&y, &y);
        assert!((f.r2 - wanted).abs() < 0.01, "{} {wanted}", f.r2);
        assert!((f.a / 500.0 - 1.0).abs() < 0.1 && (f.plateau - 1.0).abs() < 0.1);
        assert!(spread(&exact, &exact) > 0.0);
    }

    #[test]
    fn a_jump_is_an_unresolved_rise() {
        let (t, mut y) = samples(200, 0.01, |t| 2.0 * (-1000.0 * t).exp() + 0.5);
        y[0] = 0.5;
        let f = two_exponential(&t, &y).unwrap();
        assert!(f.rise_unresolved && f.r2 > 0.999, "{f:?}");
        assert!((f.a / 1000.0 - 1.0).abs() < 0.01);
    }

    #[test]
    fn a_fall_from_the_start_has_its_rise_before() {
        let law =
            |t: f64| 2.0 * (-1000.0 * t).exp() + 0.5 + 0.1 * (-300.0 * t).exp() * (9e3 * t).sin();
        let (t, y) = samples(500, 0.01, law);
        let f = two_exponential(&t, &y).unwrap();
        assert!(f.r2 > 0.98, "{f:?}");
        assert!((f.plateau / 0.5 - 1.0).abs() < 0.02 && f.p0 > 0.0, "{f:?}");
    }

    #[test]
    fn what_cannot_be_fitted_is_said() {
        let t: Vec<f64> = (0..10).map(f64::from).collect();
        let constant = Err(FitError::Constant { what: "values" });
        assert_eq!(two_exponential(&t, &[3.0; 10]), constant);
        assert!(matches!(
            two_exponential(&t[..4], &[1.0, 2.0, 3.0, 4.0]),
            Err(FitError::TooFew { found: 4, .. })
        ));
        let back = [0.0, 1.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        assert_eq!(two_exponential(&back, &t[..7]), Err(FitError::NotAscending));
    }
}
