//! Contact dashpots and the restitution they give.

/// Dashpot coefficient (N s/m) for a share `ratio` of critical damping of a spring `stiffness`
/// (N/m per m of thickness) on `mass` (kg/m): `2 ratio sqrt(k m)`.
#[inline]
#[must_use]
pub fn dashpot(ratio: f64, stiffness: f64, mass: f64) -> f64 {
    2.0 * ratio * (stiffness * mass).sqrt()
}

/// Restitution of a linear contact with damping ratio `ratio` (< 1/sqrt 2) that ends when the force
/// falls to zero: `exp(-(xi/q)(pi - atan(2 xi q / (1 - 2 xi^2))))`, `q = sqrt(1 - xi^2)`.
///
/// Source: Schwager & Poeschel (2007), Granular Matter 9, 465-469 (no attractive force).
#[inline]
#[must_use]
pub fn restitution(ratio: f64) -> f64 {
    let q = (1.0 - ratio * ratio).sqrt();
    let angle = libm::atan2(2.0 * ratio * q, 1.0 - 2.0 * ratio * ratio);
    libm::exp(-(ratio / q) * (std::f64::consts::PI - angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn restitution_matches_the_catalogue() {
        for (ratio, e) in [
            (0.05, 0.858_758),
            (0.1, 0.744_079),
            (0.2, 0.571_740),
            (0.3, 0.450_975),
        ] {
            assert!((restitution(ratio) - e).abs() < 1e-6, "{ratio}");
        }
    }
}
