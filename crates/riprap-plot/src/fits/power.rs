//! Attenuation `y = K x^-n`.

use super::{FitError, mean, spread, usable};

/// 95 % of a normal distribution lie below its mean and this many standard deviations.
const UPPER_95: f64 = 1.644_853_626_951_472_7;

/// A power law `y = K x^-n`, for example the site law of blast vibration: `y` the peak particle velocity, `x` the
/// scaled distance.
///
/// Source: Duvall & Fogelson, USBM RI 5968 (1962); Siskind et al., USBM RI 8507 (1980).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    /// `K`: value of `y` at `x = 1`.
    pub factor: f64,
    /// `n`, positive for a quantity that falls.
    pub exponent: f64,
    /// Standard error of `n`.
    pub exponent_error: f64,
    /// Share of the variance of `ln y` that the law explains.
    pub r2: f64,
    /// Standard deviation of `ln y` about the line, with two degrees of freedom taken off.
    pub deviation: f64,
    /// `K` of the upper 95 % line.
    pub upper_factor: f64,
    /// Samples that were used.
    pub count: usize,
}

impl PowerLaw {
    /// Value on the line.
    pub fn at(&self, x: f64) -> f64 {
        self.factor * libm::pow(x, -self.exponent)
    }

    /// Value on the upper 95 % line.
    pub fn upper(&self, x: f64) -> f64 {
        self.upper_factor * libm::pow(x, -self.exponent)
    }
}

/// Fits `y = K x^-n` by least squares in `ln y`; samples that are not positive and finite are left out.
///
/// The upper line is parallel to the fit, 1.645 standard deviations of `ln y` above it: 95 % of samples with
/// log-normal scatter lie below. Deviation: the prediction line of a small sample (Student's t, error of slope and
/// mean) lies higher, in the middle of 30 samples by 5 % of the distance between the lines.
///
/// # Errors
/// Fewer than three samples, or all at one distance.
pub fn power_law(x: &[f64], y: &[f64]) -> Result<PowerLaw, FitError> {
    let (x, y) = usable(x, y, |x, y| x > 0.0 && y > 0.0);
    let (count, needed) = (x.len(), 3);
    if count < needed {
        return Err(FitError::TooFew { found: count, needed });
    }
    let logs = |v: &[f64]| -> Vec<f64> { v.iter().map(|v| libm::log(*v)).collect() };
    let (lx, ly) = (logs(&x), logs(&y));
    let (sxx, sxy, syy) = (spread(&lx, &lx), spread(&lx, &ly), spread(&ly, &ly));
    if sxx <= 1e-24 * count as f64 {
        return Err(FitError::Constant { what: "distances" });
    }
    let slope = sxy / sxx;
    let start = mean(&ly) - slope * mean(&lx);
    let rest: f64 = lx.iter().zip(&ly).map(|(x, y)| y - start - slope * x).map(|e| e * e).sum();
    let variance = rest / (count - 2) as f64;
    let deviation = variance.sqrt();
    Ok(PowerLaw {
        factor: libm::exp(start),
        exponent: -slope,
        exponent_error: (variance / sxx).sqrt(),
        r2: if syy > 0.0 { 1.0 - rest / syy } else { 1.0 },
        deviation,
        upper_factor: libm::exp(start + UPPER_95 * deviation),
        count,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exact_law_is_found() {
        let x: Vec<f64> = (1..20).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| 700.0 * x.powf(-1.6)).collect();
        let f = power_law(&x, &y).unwrap();
        assert!((f.factor / 700.0 - 1.0).abs() < 1e-12 && (f.exponent - 1.6).abs() < 1e-13);
        assert!(f.deviation < 1e-13 && f.exponent_error < 1e-13 && (f.r2 - 1.0).abs() < 1e-14);
        assert!((f.at(2.0) / y[1] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn errors_follow_the_textbook() {
        // ln x = 0, 1, 2, 3; ln y = 0, -2, -1, -3: slope -0.8, rest 1.8, variance 0.9, sxx 5.
        let x: Vec<f64> = [0.0f64, 1.0, 2.0, 3.0].iter().map(|v| v.exp()).collect();
        let y: Vec<f64> = [0.0f64, -2.0, -1.0, -3.0].iter().map(|v| v.exp()).collect();
        let f = power_law(&x, &y).unwrap();
        assert!((f.exponent - 0.8).abs() < 1e-12);
        assert!((f.exponent_error - (0.9f64 / 5.0).sqrt()).abs() < 1e-12);
        assert!((f.r2 - (1.0 - 1.8 / 5.0)).abs() < 1e-12);
        assert!((f.deviation - 0.9f64.sqrt()).abs() < 1e-12);
        let gap = (f.upper(5.0) / f.at(5.0)).ln();
        assert!((gap - 1.644_853_6 * 0.9f64.sqrt()).abs() < 1e-6);
    }

    #[test]
    fn the_upper_line_leaves_a_twentieth_above() {
        // Normal scatter by sums of twelve numbers of a linear congruence.
        let mut state = 12_345_u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let n = 20_000;
        let x: Vec<f64> = (0..n).map(|_| (4.0 * uniform()).exp()).collect();
        let y: Vec<f64> = x
            .iter()
            .map(|x| {
                let normal = (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
                1e3 * x.powf(-1.5) * (0.4 * normal).exp()
            })
            .collect();
        let f = power_law(&x, &y).unwrap();
        let above = x.iter().zip(&y).filter(|(x, y)| **y > f.upper(**x)).count();
        assert!((above as f64 / f64::from(n) - 0.05).abs() < 0.005, "{above}");
        assert!((f.exponent - 1.5).abs() < 3.0 * f.exponent_error, "{f:?}");
    }

    #[test]
    fn what_cannot_be_used_is_left_out() {
        let y = [1.0, 0.5, f64::NAN, -1.0, 0.25, 7.0];
        let f = power_law(&[1.0, 2.0, 3.0, 3.5, 4.0, 0.0], &y).unwrap();
        assert_eq!(f.count, 3);
        assert!((f.exponent - 1.0).abs() < 1e-12);
        let few = power_law(&[1.0, 2.0], &[1.0, 1.0]);
        assert_eq!(few, Err(FitError::TooFew { found: 2, needed: 3 }));
        let same = power_law(&[2.0; 5], &[1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(same, Err(FitError::Constant { what: "distances" }));
    }
}
