//! Incremental shear spring with a Coulomb slider.
//!
//! Source: Cundall & Strack (1979), Geotechnique 29, 47-65, with the limit taken from the *total*
//! normal force (damping included): with the elastic force alone a block at the limit angle drifts.

/// Result of one shear increment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shear {
    /// Elastic shear force after the slider, N/m.
    pub force: f64,
    /// Whether it slid.
    pub slipping: bool,
}

/// Shear force after a tangential increment `slip` (m) of a spring of stiffness `stiffness` (N/m per
/// m), limited to `limit` (N/m).
///
/// `force` is the force on the first body along the tangent; `slip` is the first body's motion
/// relative to the second, so that the force opposes it.
#[inline]
#[must_use]
pub fn shear_spring(force: f64, stiffness: f64, slip: f64, limit: f64) -> Shear {
    let trial = force - stiffness * slip;
    if trial > limit {
        Shear { force: limit, slipping: true }
    } else if trial < -limit {
        Shear { force: -limit, slipping: true }
    } else {
        Shear { force: trial, slipping: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sticks_below_and_slides_at_the_limit() {
        let s = shear_spring(0.0, 10.0, 0.05, 1.0);
        assert_eq!(s, Shear { force: -0.5, slipping: false });
        let s = shear_spring(s.force, 10.0, 0.2, 1.0);
        assert_eq!(s, Shear { force: -1.0, slipping: true });
        let s = shear_spring(s.force, 10.0, -0.2, 1.0);
        assert!(!s.slipping && (s.force - 1.0).abs() < 1e-15);
    }
}
