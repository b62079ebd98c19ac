//! Mohr-Coulomb's limit with tension cut-off: one definition for points, faces, eight points at a time, bounds and cuts.
//!
//! Tension is positive. Whole: `sigma <= tension` and `|tau| <= cohesion - sigma tan(phi)`; failed: no tension, and the same
//! limit with the residual values. Angles of friction come as their tangents everywhere.
//!
//! Source: Tian & Li, equations (17) and (18); Han, Liu & Li (2010), (10) and (11), read with the sign of the normal force, so
//! that tension does not raise the shear strength.

use std::ops::{Mul, Sub};

use serde::{Deserialize, Serialize};

use super::norm;

/// Shear that a plane with this cohesion and tan of the friction angle bears under the normal traction `sigma` (tension
/// positive); negative beyond the tip of the cone. Of numbers or of lanes of numbers; in stresses, or in forces with the
/// cohesion of the whole area.
#[inline(always)]
#[must_use]
pub fn shear_limit<T>(cohesion: T, friction: T, sigma: T) -> T
where
    T: Mul<Output = T> + Sub<Output = T>,
{
    cohesion - sigma * friction
}

/// [`shear_limit`] as a size: nothing beyond the tip of the cone.
#[inline(always)]
#[must_use]
pub fn shear_strength(cohesion: f64, friction: f64, sigma: f64) -> f64 {
    let limit = shear_limit(cohesion, friction, sigma);
    if limit > 0.0 { limit } else { 0.0 }
}

/// Mohr-Coulomb strength with tension cut-off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Strength {
    /// Cohesion, Pa.
    pub cohesion: f64,
    /// Tensile strength, Pa.
    pub tension: f64,
    /// tan of the friction angle before failure.
    pub friction: f64,
    /// tan of the friction angle after failure.
    pub residual_friction: f64,
    /// Cohesion after failure, Pa.
    pub residual_cohesion: f64,
    /// tan of the dilation angle of a joint that slides, as it was given ([`Strength::dilating`] is what acts); bonds of
    /// deformable blocks do not dilate.
    pub dilation: f64,
    /// Slip from where the joint was built at which dilation ends, m.
    pub dilation_end: f64,
}

/// How a point failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FailureMode {
    /// Beyond the tensile strength.
    Tension,
    /// Beyond the shear strength.
    Shear,
}

impl Strength {
    /// Shear strength of a whole point under the normal traction `sigma`, Pa.
    #[inline(always)]
    #[must_use]
    pub fn peak(&self, sigma: f64) -> f64 {
        shear_strength(self.cohesion, self.friction, sigma)
    }

    /// Shear strength of a failed point under the normal traction `sigma`, Pa.
    #[inline(always)]
    #[must_use]
    pub fn residual(&self, sigma: f64) -> f64 {
        shear_strength(self.residual_cohesion, self.residual_friction, sigma)
    }

    /// Whether a whole point bears the normal traction `sigma` and shear of the size `tau`, Pa.
    #[inline(always)]
    #[must_use]
    pub fn holds(&self, sigma: f64, tau: f64) -> bool {
        sigma <= self.tension && tau <= self.peak(sigma)
    }

    /// Tension at which no shear strength is left, `c cot(phi)`, Pa: a larger tensile strength is never reached.
    #[inline]
    #[must_use]
    pub fn apex(&self) -> f64 {
        self.cohesion / self.friction
    }

    /// Traction (n, b, c) over strength, of the mode that is nearer to failure: above 1 the point fails.
    ///
    /// `sigma/tension` and `(|tau| + sigma tan(phi))/cohesion`: a traction u times as large as it may be has the utilisation u,
    /// so that 1/u is the share of a load at which a linear body would begin to fail.
    #[inline]
    #[must_use]
    pub fn utilisation(&self, t: &[f64; 3]) -> (f64, FailureMode) {
        // What is left of the shear when friction has taken its part, which is more than nothing in tension.
        let beyond = -shear_limit(-norm(t[1], t[2]), self.friction, t[0]);
        let in_tension = ratio(t[0].max(0.0), self.tension);
        let in_shear = ratio(beyond.max(0.0), self.cohesion);
        if in_tension >= in_shear {
            (in_tension, FailureMode::Tension)
        } else {
            (in_shear, FailureMode::Shear)
        }
    }

    /// How a point under this traction fails, if it does.
    #[inline]
    #[must_use]
    pub fn failure(&self, t: &[f64; 3]) -> Option<FailureMode> {
        let (used, mode) = self.utilisation(t);
        (used > 1.0).then_some(mode)
    }

    /// tan of the angle at which a joint that slides dilates: the given one, at most that of friction, before and after failure.
    ///
    /// Sliding loses `s (tan(phi) - tan(psi))` per area and slip under the pressure s, so with more dilation than friction it would make
    /// energy. A scene cannot ask for that, but strengths that are reduced and phases that lower friction come to it.
    #[inline]
    #[must_use]
    pub fn dilating(&self) -> f64 {
        self.dilation.min(self.friction).min(self.residual_friction)
    }

    /// The strength divided by `factor` (Zienkiewicz, Humpheson and Lewis 1975), residual values too; dilation stays as far as friction
    /// lets it ([`Strength::dilating`]).
    #[must_use]
    pub fn reduced(self, factor: f64) -> Self {
        Self {
            cohesion: self.cohesion / factor,
            tension: self.tension / factor,
            friction: self.friction / factor,
            residual_friction: self.residual_friction / factor,
            residual_cohesion: self.residual_cohesion / factor,
            ..self
        }
    }
}

/// Load over strength; nothing over no strength is 0.
#[inline]
fn ratio(load: f64, strength: f64) -> f64 {
    if load == 0.0 { 0.0 } else { load / strength }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::Lanes;

    const STRENGTH: Strength = Strength {
        cohesion: 2e6,
        tension: 1e6,
        friction: 0.7,
        residual_friction: 0.5,
        residual_cohesion: 0.1e6,
        dilation: 0.0,
        dilation_end: 0.0,
    };

    #[test]
    fn numbers_and_lanes_have_the_same_limit() {
        for k in 0..100 {
            let sigma = 1e5 * (f64::from(k) - 70.3);
            let one = shear_limit(STRENGTH.cohesion, STRENGTH.friction, sigma);
            let [c, f, s] = [STRENGTH.cohesion, STRENGTH.friction, sigma].map(Lanes::all);
            assert!(shear_limit(c, f, s).0.iter().all(|x| x.to_bits() == one.to_bits()));
            assert_eq!(STRENGTH.peak(sigma), one.max(0.0));
        }
    }

    #[test]
    fn utilisation_is_one_on_the_limit() {
        for k in 0..40 {
            let sigma = 1e5 * (f64::from(k) - 30.5);
            let tau = STRENGTH.peak(sigma);
            let (used, mode) = STRENGTH.utilisation(&[sigma, 0.6 * tau, 0.8 * tau]);
            assert!((used - 1.0).abs() < 1e-12 && mode == FailureMode::Shear, "{sigma} {used}");
            assert!(STRENGTH.holds(sigma, tau) && !STRENGTH.holds(sigma, 1.001 * tau));
        }
        assert_eq!(STRENGTH.utilisation(&[2e6, 0.0, 0.0]), (2.0, FailureMode::Tension));
        assert_eq!(STRENGTH.utilisation(&[-2e6, 0.0, 0.0]).0, 0.0);
    }

    #[test]
    fn reduced_strength_fails_under_the_reduced_load() {
        let half = STRENGTH.reduced(2.0);
        assert_eq!(half.peak(-1e6), 0.5 * STRENGTH.peak(-1e6));
        assert_eq!(half.residual(-1e6), 0.5 * STRENGTH.residual(-1e6));
        assert_eq!(half.tension, 0.5e6);
    }

    #[test]
    fn dilation_stays_below_the_friction_that_is_left() {
        let steep = Strength { dilation: 0.4, ..STRENGTH };
        assert_eq!(steep.dilating(), 0.4);
        assert_eq!(steep.reduced(1.2).dilating(), 0.4);
        assert_eq!(steep.reduced(2.0).dilating(), 0.25);
        // Divided and given back it is what it was.
        assert_eq!(steep.reduced(2.0).reduced(0.5).dilating(), 0.4);
    }
}
