//! Bounds that let a number that is none through, so that it is found where forces are looked at: the comparisons of the
//! standard library hide it (`max`, `min`) or panic (`clamp`).

/// `x` between `-limit` and `limit`; no number when `limit` is none or negative.
#[must_use]
pub fn within(x: f64, limit: f64) -> f64 {
    if limit >= 0.0 { x.clamp(-limit, limit) } else { f64::NAN }
}

/// `x`, or 0 where it is negative.
#[must_use]
pub fn not_negative(x: f64) -> f64 {
    if x.is_nan() { x } else { x.max(0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_stays_none() {
        assert_eq!([within(3.0, 2.0), within(-3.0, 2.0), within(1.0, 2.0)], [2.0, -2.0, 1.0]);
        assert_eq!([not_negative(-1.0), not_negative(2.0)], [0.0, 2.0]);
        for x in [
            within(1.0, f64::NAN),
            within(f64::NAN, 1.0),
            within(1.0, -1.0),
            not_negative(f64::NAN),
        ] {
            assert!(x.is_nan());
        }
    }
}
