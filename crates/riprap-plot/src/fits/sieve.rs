//! Fragment-size distributions: Rosin-Rammler and Swebrec.

use super::exponentials::simplex;
use super::{FitError, mean};

/// `P(x) = 1 - 2^(-(x/x50)^n)`.
///
/// Source: Rosin & Rammler (1933), J. Inst. Fuel 7, 29-36, written with the median size as by Cunningham (2005),
/// Brighton conf. on explosives and blasting, eq. 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RosinRammler {
    /// Size that half of the mass passes, in the unit of the sizes.
    pub x50: f64,
    /// Uniformity.
    pub n: f64,
    /// Share of the variance of the passing that the fit explains.
    pub r2: f64,
}

impl RosinRammler {
    /// Share that passes a size.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        rosin_rammler(x, self.x50, self.n)
    }

    /// Size that a share passes.
    #[must_use]
    pub fn size(&self, share: f64) -> f64 {
        let doublings = -libm::log2(1.0 - share);
        self.x50 * libm::pow(doublings, 1.0 / self.n)
    }
}

fn rosin_rammler(x: f64, x50: f64, n: f64) -> f64 {
    1.0 - libm::exp2(-libm::pow(x / x50, n))
}

/// `P(x) = 1 / (1 + [ln(xmax/x) / ln(xmax/x50)]^b)`.
///
/// Source: Ouchterlony (2005), Mining Technology 114, A29-A44, eq. 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swebrec {
    /// Size that half of the mass passes, in the unit of the sizes.
    pub x50: f64,
    /// Size that everything passes.
    pub xmax: f64,
    /// Curve undulation parameter.
    pub b: f64,
    /// Share of the variance of the passing that the fit explains.
    pub r2: f64,
}

impl Swebrec {
    /// Share that passes a size.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        swebrec(x, self.x50, self.xmax, self.b)
    }

    /// Size that a share passes.
    #[must_use]
    pub fn size(&self, share: f64) -> f64 {
        let span = libm::log(self.xmax / self.x50);
        let odds = (1.0 - share) / share;
        self.xmax * libm::exp(-span * libm::pow(odds, 1.0 / self.b))
    }
}

fn swebrec(x: f64, x50: f64, xmax: f64, b: f64) -> f64 {
    if x >= xmax {
        return 1.0;
    }
    let ratio = libm::log(xmax / x) / libm::log(xmax / x50);
    1.0 / (1.0 + libm::pow(ratio, b))
}

/// Limits of the exponents.
const EXPONENTS: [f64; 2] = [0.05, 50.0];
/// `ln(xmax / largest size)` that are tried: the largest fragment of a sample is not the largest there can be.
const BEYOND: usize = 25;
const FARTHEST: f64 = 4.0;

/// Samples with sizes above 0 and shares in 0..=1, of which not all are equal; the sum of squares of the shares.
fn samples(size: &[f64], passing: &[f64], needed: usize) -> Result<(Samples, f64), FitError> {
    let keep = |x: f64, p: f64| x > 0.0 && (0.0..=1.0).contains(&p);
    let (x, p) = super::usable(size, passing, keep);
    let found = x.len();
    if found < needed {
        return Err(FitError::TooFew { found, needed });
    }
    let all = super::spread(&p, &p);
    if all <= 0.0 {
        return Err(FitError::Constant { what: "shares" });
    }
    if x.iter().all(|v| *v == x[0]) {
        return Err(FitError::Constant { what: "sizes" });
    }
    Ok(((x, p), all))
}

type Samples = (Vec<f64>, Vec<f64>);

fn squares((x, p): &Samples, at: impl Fn(f64) -> f64) -> f64 {
    let errors = x.iter().zip(p).map(|(x, p)| at(*x) - p);
    errors.map(|e| e * e).sum()
}

/// Middle of the sizes, logarithmic: where the search begins.
fn middle(x: &[f64]) -> f64 {
    let logs: Vec<f64> = x.iter().map(|x| libm::log(*x)).collect();
    mean(&logs)
}

/// The best `ln x50` and `ln` of the exponent, from several starts.
fn search(start: f64, cost: impl Fn([f64; 2]) -> f64) -> ([f64; 2], f64) {
    let guarded = |v: [f64; 2]| {
        let inside = (EXPONENTS[0]..=EXPONENTS[1]).contains(&libm::exp(v[1]));
        let cost = if inside { cost(v) } else { f64::INFINITY };
        if cost.is_nan() { f64::INFINITY } else { cost }
    };
    let starts = [0.0, 0.7, 1.6].map(|e| simplex([start, e], 0.5, guarded));
    let mut best = (starts[0], guarded(starts[0]));
    for v in starts {
        // A second simplex, in case the first has folded up too early.
        let v = simplex(v, 0.05, guarded);
        if guarded(v) < best.1 {
            best = (v, guarded(v));
        }
    }
    best
}

/// Fits a Rosin-Rammler curve to shares passing, by least squares of the shares.
///
/// # Errors
/// Fewer than three samples, all alike.
pub fn rosin_rammler_fit(size: &[f64], passing: &[f64]) -> Result<RosinRammler, FitError> {
    let (s, all) = samples(size, passing, 3)?;
    let curve = |v: [f64; 2]| {
        let [x50, n] = v.map(libm::exp);
        squares(&s, |x| rosin_rammler(x, x50, n))
    };
    let (best, rest) = search(middle(&s.0), curve);
    let [x50, n] = best.map(libm::exp);
    let r2 = 1.0 - rest / all;
    Ok(RosinRammler { x50, n, r2 })
}

/// Fits a Swebrec curve to shares passing, by least squares of the shares; `xmax` is looked for between the largest
/// size and 55 times it.
///
/// # Errors
/// Fewer than four samples, all alike.
pub fn swebrec_fit(size: &[f64], passing: &[f64]) -> Result<Swebrec, FitError> {
    let (s, all) = samples(size, passing, 4)?;
    let largest = s.0.iter().fold(0.0, |m: f64, x| m.max(*x));
    let with = |beyond: f64| {
        let xmax = largest * libm::exp(beyond);
        let curve = |v: [f64; 2]| {
            let [x50, b] = v.map(libm::exp);
            if x50 >= xmax {
                return f64::INFINITY;
            }
            squares(&s, |x| swebrec(x, x50, xmax, b))
        };
        let (v, cost) = search(middle(&s.0), curve);
        (v, cost, xmax)
    };
    // Distances beyond the largest size grow with their square: most of the change is near zero.
    let place = |k: f64| FARTHEST * (k / (BEYOND - 1) as f64) * (k / (BEYOND - 1) as f64);
    let tries: Vec<_> = (0..BEYOND).map(|k| with(place(k as f64))).collect();
    let k = (0..BEYOND).min_by(|a, b| tries[*a].1.total_cmp(&tries[*b].1)).unwrap_or(0);
    // Golden-section search between the neighbours of the best.
    let (mut low, mut high) = ((k as f64 - 1.0).max(0.0), (k as f64 + 1.0).min(24.0));
    let mut best = tries[k];
    for _ in 0..40 {
        let inner = [0.381_966, 0.618_034].map(|f| low + f * (high - low));
        let [a, b] = inner.map(|k| with(place(k)));
        if a.1 < b.1 {
            high = inner[1];
        } else {
            low = inner[0];
        }
        for t in [a, b] {
            if t.1 < best.1 {
                best = t;
            }
        }
    }
    let (v, rest, xmax) = best;
    let [x50, b] = v.map(libm::exp);
    let r2 = 1.0 - rest / all;
    Ok(Swebrec { x50, xmax, b, r2 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rosin_rammler_curve_is_found_again() {
        let true_one = RosinRammler { x50: 0.23, n: 1.3, r2: 1.0 };
        let x: Vec<f64> = (0..20).map(|k| 0.01 * 1.3f64.powi(k)).collect();
        let p: Vec<f64> = x.iter().map(|x| true_one.at(*x)).collect();
        let fit = rosin_rammler_fit(&x, &p).unwrap();
        assert!((fit.x50 / 0.23 - 1.0).abs() < 1e-6, "{fit:?}");
        assert!((fit.n / 1.3 - 1.0).abs() < 1e-6 && fit.r2 > 1.0 - 1e-9);
        assert!((fit.at(0.23) - 0.5).abs() < 1e-6);
        assert!((fit.at(fit.size(0.8)) - 0.8).abs() < 1e-12);
    }

    #[test]
    fn a_swebrec_curve_is_found_again() {
        let true_one = Swebrec { x50: 0.2, xmax: 1.5, b: 2.1, r2: 1.0 };
        let x: Vec<f64> = (0..24).map(|k| 0.004 * 1.28f64.powi(k)).collect();
        let p: Vec<f64> = x.iter().map(|x| true_one.at(*x)).collect();
        let fit = swebrec_fit(&x, &p).unwrap();
        assert!((fit.x50 / 0.2 - 1.0).abs() < 1e-3, "{fit:?}");
        assert!((fit.b / 2.1 - 1.0).abs() < 5e-3, "{fit:?}");
        assert!((fit.xmax / 1.5 - 1.0).abs() < 5e-3 && fit.r2 > 1.0 - 1e-7);
        assert!((fit.at(fit.size(0.8)) - 0.8).abs() < 1e-12);
        assert_eq!(fit.at(2.0), 1.0);
    }

    #[test]
    fn useless_samples() {
        assert!(rosin_rammler_fit(&[1.0, 2.0], &[0.1, 0.2]).is_err());
        assert!(rosin_rammler_fit(&[1.0, 2.0, 3.0], &[1.0; 3]).is_err());
        assert!(swebrec_fit(&[2.0; 5], &[0.1, 0.2, 0.3, 0.4, 0.5]).is_err());
        assert!(swebrec_fit(&[f64::NAN; 5], &[0.1; 5]).is_err());
    }
}
