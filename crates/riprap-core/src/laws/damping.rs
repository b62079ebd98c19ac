//! Contact dashpots and the restitution they give.

/// Dashpot coefficient (N s/m) for a share `ratio` of critical damping of a spring `stiffness`
/// (N/m per m of thickness) on `mass` (kg/m): `2 ratio sqrt(k m)`.
#[inline]
#[must_use]
pub fn dashpot(ratio: f64, stiffness: f64, mass: f64) -> f64 {
    2.0 * ratio * (stiffness * mass).sqrt()
}

/// The stable step with a share `ratio` of critical damping, over that without: `sqrt(1 + xi^2) - xi`, for dashpots that act on the velocity of half
/// a step before.
#[inline]
#[must_use]
pub fn stable_share(ratio: f64) -> f64 {
    (1.0 + ratio * ratio).sqrt() - ratio
}

/// Restitution of free blocks that meet, where a scene gives neither `restitution` nor `damping_ratio`: what rocking and tumbling blocks of rock
/// keep of their speed at flat impacts (0.13 to 0.2, see the page on choosing).
pub const FREE_RESTITUTION: f64 = 0.2;

/// Least restitution that [`ratio_of`] is asked for: a dashpot always gives some, and the stable step shrinks with it (0.1 of the
/// undamped one here).
pub const LEAST_RESTITUTION: f64 = 0.01;

/// Restitution of a linear contact with damping ratio `ratio` that ends when the force falls to zero:
/// `exp(-(xi/q)(pi - atan(2 xi q / (1 - 2 xi^2))))`, `q = sqrt(1 - xi^2)` below the critical damping,
/// `exp(-(xi/q) ln((xi + q)/(xi - q)))`, `q = sqrt(xi^2 - 1)` above.
///
/// Source: Schwager & Poeschel (2007), Granular Matter 9, 465-469 (no attractive force).
#[inline]
#[must_use]
pub fn restitution(ratio: f64) -> f64 {
    let square = 1.0 - ratio * ratio;
    let q = square.abs().sqrt();
    // `angle / q`; both forms tend to 2 at the critical damping.
    let over_q = if q < 1e-8 {
        2.0
    } else if square > 0.0 {
        let angle = libm::atan2(2.0 * ratio * q, 1.0 - 2.0 * ratio * ratio);
        (std::f64::consts::PI - angle) / q
    } else {
        2.0 * libm::log(ratio + q) / q
    };
    libm::exp(-ratio * over_q)
}

/// Damping ratio that gives a linear contact the restitution `wanted`, from [`LEAST_RESTITUTION`] to 1: the inverse of
/// [`restitution`], to the last bits.
#[must_use]
pub fn ratio_of(wanted: f64) -> f64 {
    let (mut low, mut high) = (0.0, 8.0);
    if wanted >= 1.0 {
        return low;
    }
    // Falls with the ratio; 8 gives 0.004. Enough halvings for neighbouring numbers.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if restitution(middle) > wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn restitution_matches_the_catalogue() {
        for (ratio, e) in [(0.05, 0.858_758), (0.1, 0.744_079), (0.2, 0.571_740), (0.3, 0.450_975)]
        {
            assert!((restitution(ratio) - e).abs() < 1e-6, "{ratio}");
        }
    }

    /// The motion itself, `m a = -(k x + c v)` until the force would pull.
    fn bounced(ratio: f64) -> f64 {
        let (mut x, mut v, dt) = (0.0_f64, 1.0_f64, 1e-5);
        loop {
            let force = x + 2.0 * ratio * v;
            if x > 0.0 && force <= 0.0 {
                return -v;
            }
            let middle = v - 0.5 * dt * force;
            let half = x + 0.5 * dt * v;
            x += dt * middle;
            v -= dt * (half + 2.0 * ratio * middle);
        }
    }

    #[test]
    fn restitution_is_that_of_the_motion_on_both_sides_of_the_critical_damping() {
        for ratio in [0.01, 0.3, 0.7, 0.8, 0.999, 1.0, 1.001, 1.5, 4.0] {
            let (found, expected) = (restitution(ratio), bounced(ratio));
            assert!((found - expected).abs() < 1e-4, "{ratio}: {found}, {expected}");
        }
        let across = restitution(1.0 - 1e-9) - restitution(1.0 + 1e-9);
        assert!((0.0..1e-8).contains(&across), "{across}");
    }

    #[test]
    fn ratio_and_restitution_are_inverse() {
        assert_eq!(ratio_of(1.0), 0.0);
        for wanted in [0.99, 0.9, 0.6, 0.3, 0.2, 0.1, LEAST_RESTITUTION] {
            let ratio = ratio_of(wanted);
            assert!((restitution(ratio) - wanted).abs() < 1e-14, "{wanted}");
        }
    }
}
