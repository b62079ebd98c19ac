//! Brittle joint point of the plane: tension cut-off, Mohr-Coulomb peak, residual friction (see [`super::mohr_coulomb`]).
//!
//! Tension is positive.

use super::bounds::within;
use super::mohr_coulomb::shear_limit;
use super::parameters::BondLaw;

/// State of a joint point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Response {
    /// Normal stress, Pa, tension positive.
    pub sigma: f64,
    /// Shear stress, Pa.
    pub tau: f64,
    /// Plastic (irrecoverable) part of the shear displacement, m.
    pub slip: f64,
    /// Whether the point has failed, now or before.
    pub failed: bool,
}

/// Stresses at opening `un` and shear displacement `us` (m) of a point with plastic slip `slip`.
///
/// Failure is brittle: the trial stress that exceeds the peak strength is returned to the residual
/// one in the same call.
#[inline]
#[must_use]
pub fn joint_point(law: &BondLaw, un: f64, us: f64, slip: f64, failed: bool) -> Response {
    let sigma = law.normal_stiffness * un;
    let tau = law.shear_stiffness * (us - slip);
    let strength = &law.strength;
    let intact = !failed && strength.holds(sigma, tau.abs());
    if intact {
        return Response { sigma, tau, slip, failed: false };
    }
    // Open: it carries nothing, and its shear spring begins anew where it is.
    if sigma >= 0.0 {
        return Response { sigma: 0.0, tau: 0.0, slip: us, failed: true };
    }
    let (cohesion, friction) = (strength.residual_cohesion, strength.residual_friction);
    // Not that of `Strength::residual`, which would hide a number that is none.
    let tau = within(tau, shear_limit(cohesion, friction, sigma));
    Response { sigma, tau, slip: us - tau / law.shear_stiffness, failed: true }
}

#[cfg(test)]
mod tests {
    use super::super::mohr_coulomb::Strength;
    use super::*;

    /// C5 of the verification catalogue: k_s = 1e10 Pa/m, sigma_n = 1 MPa, phi = 35 deg, c = 0.2 MPa.
    fn law() -> BondLaw {
        let mu = 35f64.to_radians().tan();
        BondLaw {
            normal_stiffness: 1e11,
            shear_stiffness: 1e10,
            strength: Strength {
                tension: 0.1e6,
                cohesion: 0.2e6,
                friction: mu,
                residual_friction: mu,
                ..Strength::default()
            },
            behaviour: Default::default(),
            damping_ratio: 0.0,
            points: 2,
        }
    }

    #[test]
    fn direct_shear_peak_and_residual() {
        let (law, un) = (law(), -1e6 / 1e11);
        let (mut slip, mut failed, mut peak, mut last) = (0.0, false, 0.0_f64, 0.0);
        for k in 0..=100_000 {
            let us = f64::from(k) * 1e-8;
            let r = joint_point(&law, un, us, slip, failed);
            (slip, failed, last) = (r.slip, r.failed, r.tau);
            peak = peak.max(r.tau);
        }
        assert!((peak / 900_207.5 - 1.0).abs() < 1e-3, "{peak}");
        assert!((last / 700_207.5 - 1.0).abs() < 1e-6, "{last}");
    }

    #[test]
    fn tension_cut_off_opens_for_good() {
        let law = law();
        let open = joint_point(&law, 2e-6, 0.0, 0.0, false);
        assert!(open.failed && open.sigma == 0.0);
        assert_eq!(joint_point(&law, 1e-7, 1e-6, open.slip, true).tau, 0.0);
        assert!(!joint_point(&law, 0.9e-6, 0.0, 0.0, false).failed);
    }
}
