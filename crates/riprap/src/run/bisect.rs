//! Search for the value at which something begins to fail, by halving.

/// What a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Bracket {
    /// Value nearest to the limit at which it holds.
    pub holds_at: f64,
    /// Value nearest to the limit at which it fails.
    pub fails_at: f64,
    /// Every trial, in order: value and whether it failed.
    pub trials: Vec<(f64, bool)>,
}

impl Bracket {
    /// The middle between the last value that holds and the first that fails.
    #[must_use]
    pub fn limit(&self) -> f64 {
        0.5 * (self.holds_at + self.fails_at)
    }
}

/// Why a search has no answer.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum BisectError<E> {
    /// Both ends behave the same, so that there is no limit between them.
    #[error("it {} at both ends, {low} and {high}", if *fails { "fails" } else { "holds" })]
    NoLimit {
        /// First end.
        low: f64,
        /// Second end.
        high: f64,
        /// What both do.
        fails: bool,
    },
    /// The interval or the tolerance is no number, or the tolerance is not positive.
    #[error("low, high and a positive tolerance must be numbers")]
    NotANumber,
    /// A trial could not be made.
    #[error("{0}")]
    Trial(E),
}

/// Halves the interval from `low` to `high` until it is not wider than `tolerance`.
///
/// Assumes one limit in between, in either direction; with several it finds one of them.
///
/// # Errors
/// Ends that behave the same, and whatever a trial returns.
/// # Examples
///
/// ```
/// use riprap::run::bisect::bisect;
///
/// // A column of width 1 m and height h topples on a slope of 20 degrees when h is greater than 1/tan(20 degrees).
/// let steepness = 20f64.to_radians().tan();
/// let found = bisect::<()>(1.0, 5.0, 1e-3, |height| Ok(height * steepness > 1.0)).unwrap();
/// assert!((found.limit() - 1.0 / steepness).abs() < 1e-3);
/// ```
pub fn bisect<E>(
    low: f64,
    high: f64,
    tolerance: f64,
    mut fails: impl FnMut(f64) -> Result<bool, E>,
) -> Result<Bracket, BisectError<E>> {
    let sound = low.is_finite() && high.is_finite() && tolerance.is_finite() && tolerance > 0.0;
    if !sound {
        return Err(BisectError::NotANumber);
    }
    let mut trials = Vec::new();
    let mut trial = |value: f64| -> Result<bool, BisectError<E>> {
        let failed = fails(value).map_err(BisectError::Trial)?;
        trials.push((value, failed));
        Ok(failed)
    };
    let (low_fails, high_fails) = (trial(low)?, trial(high)?);
    if low_fails == high_fails {
        return Err(BisectError::NoLimit {
            low,
            high,
            fails: low_fails,
        });
    }
    let (mut holds_at, mut fails_at) = if low_fails { (high, low) } else { (low, high) };
    while (fails_at - holds_at).abs() > tolerance {
        let middle = 0.5 * (holds_at + fails_at);
        if middle == holds_at || middle == fails_at {
            break; // The tolerance is finer than the numbers themselves.
        }
        if trial(middle)? {
            fails_at = middle;
        } else {
            holds_at = middle;
        }
    }
    Ok(Bracket {
        holds_at,
        fails_at,
        trials,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_found_from_both_sides() {
        for (low, high) in [(0.0, 1.0), (1.0, 0.0)] {
            let found = bisect::<()>(low, high, 1e-3, |x| Ok(x < 0.3)).unwrap();
            assert!((found.limit() - 0.3).abs() <= 0.5e-3, "{found:?}");
            assert!(found.holds_at >= 0.3 && found.fails_at < 0.3);
            assert_eq!(found.trials.len(), 2 + 10);
        }
    }

    #[test]
    fn no_limit_no_number_and_trials_that_break() {
        let same = bisect::<()>(0.0, 1.0, 0.1, |_| Ok(true));
        assert!(matches!(
            same,
            Err(BisectError::NoLimit { fails: true, .. })
        ));
        assert_eq!(
            bisect::<()>(0.0, 1.0, 0.0, |_| Ok(true)),
            Err(BisectError::NotANumber)
        );
        assert_eq!(
            bisect::<()>(f64::NAN, 1.0, 0.1, |_| Ok(true)),
            Err(BisectError::NotANumber)
        );
        assert_eq!(
            bisect(0.0, 1.0, 0.1, |_| Err("no")),
            Err(BisectError::Trial("no"))
        );
    }

    #[test]
    fn a_tolerance_finer_than_the_numbers_ends() {
        let found = bisect::<()>(0.0, 1.0, f64::MIN_POSITIVE, |x| Ok(x > 0.7)).unwrap();
        assert!(found.trials.len() < 1100, "{}", found.trials.len());
    }
}
