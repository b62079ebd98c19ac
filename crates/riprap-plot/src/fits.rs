//! Laws fitted to recorded numbers: attenuation with distance, rise and decay of a pressure, fragment sizes, spectrum of a history.
//!
//! Pure functions: numbers in, numbers out. Logarithms and exponentials come from `libm`, sums run in the order of
//! the samples, so that a fit is the same on every machine.

mod exponentials;
mod passing;
mod power;
mod sieve;
mod spectrum;

pub use exponentials::{TwoExponential, two_exponential};
pub use passing::Passing;
pub use power::{PowerLaw, power_law};
pub use sieve::{RosinRammler, Swebrec, rosin_rammler_fit, swebrec_fit};
pub use spectrum::{Spectrum, amplitude_spectrum};

/// Why there is no fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    /// Not enough usable samples.
    #[error("only {found} usable samples, but {needed} are needed")]
    TooFew {
        /// Usable samples.
        found: usize,
        /// How many it takes.
        needed: usize,
    },
    /// All abscissae or all values are the same.
    #[error("all {what} are the same")]
    Constant {
        /// Which.
        what: &'static str,
    },
    /// Times must ascend.
    #[error("the times do not increase")]
    NotAscending,
}

/// Pairs of which both numbers are finite and `keep` holds.
fn usable(x: &[f64], y: &[f64], keep: impl Fn(f64, f64) -> bool) -> (Vec<f64>, Vec<f64>) {
    x.iter()
        .zip(y)
        .filter(|(x, y)| x.is_finite() && y.is_finite() && keep(**x, **y))
        .map(|(x, y)| (*x, *y))
        .unzip()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Sum of products of the deviations from the means.
fn spread(a: &[f64], b: &[f64]) -> f64 {
    let (ma, mb) = (mean(a), mean(b));
    a.iter().zip(b).map(|(x, y)| (x - ma) * (y - mb)).sum()
}
