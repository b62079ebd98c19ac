//! Barton-Bandis: shear strength, dilation and closure of rough joints.

use serde::{Deserialize, Serialize};

/// Length of the laboratory samples that JRC and JCS belong to, m.
pub const LAB_LENGTH: f64 = 0.1;

/// Largest angle of friction, rad (70 degrees): the logarithm has no bound where pressure goes to nothing.
const STEEPEST: f64 = 70.0 * std::f64::consts::PI / 180.0;

/// Share of JRC that is mobilised after a slip over that at the peak (Barton, Bandis & Bakhtar 1985). What comes before the first line
/// is straight from the friction angle 0.
const MOBILISED: [[f64; 2]; 8] = [
    [0.3, 0.0],
    [0.6, 0.75],
    [1.0, 1.0],
    [2.0, 0.85],
    [4.0, 0.7],
    [10.0, 0.5],
    [25.0, 0.4],
    [100.0, 0.0],
];

/// Friction of rough surfaces, `tau = s tan(phi_r + JRC log10(JCS/s))`; phi_r is the residual friction of the strength.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BartonBandis {
    /// Joint roughness coefficient of the joint, 0 to 20.
    pub jrc: f64,
    /// Compressive strength of its walls, Pa.
    pub jcs: f64,
    /// Plastic slip at the peak, m; `None`: the peak strength acts at every slip.
    ///
    /// Deviation: the source counts all of the displacement, with that of the shear spring.
    pub peak_slip: Option<f64>,
    /// Share of the strength that acts: below 1 where strengths are reduced.
    pub share: f64,
}

impl BartonBandis {
    /// `JRC log10(JCS/s)`, rad: none from s = JCS on, and no more than brings the friction angle to 70 degrees.
    fn roughness(&self, residual: f64, s: f64) -> f64 {
        if s >= self.jcs || s <= 0.0 {
            // Without pressure the logarithm has no value; its bound is the limit.
            return if s > 0.0 { 0.0 } else { STEEPEST - residual };
        }
        (self.jrc * libm::log10(self.jcs / s)).to_radians().min(STEEPEST - residual)
    }

    /// Angle that roughness adds to the residual one after the plastic slip `accumulated`, rad.
    fn mobilised(&self, residual: f64, s: f64, accumulated: f64) -> f64 {
        let full = self.roughness(residual, s);
        let Some(peak) = self.peak_slip else {
            return full;
        };
        let x = accumulated / peak;
        let [first, _] = MOBILISED[0];
        if x < first {
            // Less than nothing: all of the angle, the residual one too, grows from 0.
            return -residual * (1.0 - x / first);
        }
        let after = MOBILISED.iter().position(|row| x < row[0]);
        let Some(k) = after else { return 0.0 };
        let [[x0, y0], [x1, y1]] = [MOBILISED[k - 1], MOBILISED[k]];
        full * (y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    }

    /// phi_r, rad, from the residual friction of a [`super::Strength`] that has been reduced as the share says: the strength of rough
    /// surfaces is divided as a whole, not its parameters.
    fn residual_angle(&self, residual: f64) -> f64 {
        libm::atan(residual / self.share)
    }

    /// Shear strength (Pa) under the pressure `s` (Pa) after the plastic slip `accumulated` (m); `residual` is tan(phi_r), where strengths are
    /// reduced divided as they are.
    #[must_use]
    pub fn strength(&self, residual: f64, s: f64, accumulated: f64) -> f64 {
        if s <= 0.0 {
            return 0.0;
        }
        let angle = self.residual_angle(residual);
        self.share * s * libm::tan(angle + self.mobilised(angle, s, accumulated))
    }

    /// Tangent of the angle of dilation: half of the angle that roughness adds, and no more than the friction that is left where strengths
    /// are reduced. Deviation: contraction before roughness is mobilised is left out.
    #[must_use]
    pub fn dilation(&self, residual: f64, s: f64, accumulated: f64) -> f64 {
        if s <= 0.0 {
            return 0.0;
        }
        let angle = self.residual_angle(residual);
        let added = self.mobilised(angle, s, accumulated).max(0.0);
        libm::tan(0.5 * added).min(self.share * libm::tan(angle + added))
    }

    /// Whether the peak strength has been passed.
    #[must_use]
    pub fn is_past_peak(&self, accumulated: f64) -> bool {
        accumulated > self.peak_slip.unwrap_or(0.0)
    }
}

/// JRC and JCS (Pa) of a joint of the given length (m), from those of laboratory samples (Barton, Bandis & Bakhtar 1985).
#[must_use]
pub fn scaled(jrc: f64, jcs: f64, length: f64) -> [f64; 2] {
    let ratio = length / LAB_LENGTH;
    [jrc * libm::pow(ratio, -0.02 * jrc), jcs * libm::pow(ratio, -0.03 * jrc)]
}

/// Slip (m) at the peak of a joint of the given length (m) with its own JRC: `L/500 (JRC/L)^0.33`.
#[must_use]
pub fn slip_at_peak(jrc: f64, length: f64) -> f64 {
    length / 500.0 * libm::pow(jrc / length, 0.33)
}

/// Initial normal stiffness (Pa/m) and largest closure (m) in the first loading cycle, from JRC, JCS and the strength of the rock
/// (Pa); `None` where the formulas leave their range: a stiffness or a closure of nothing, or a closure above the aperture.
///
/// Bandis et al. (1983): `k = -7.15 + 1.75 JRC + 0.02 JCS/a`, `V_m = -0.296 - 0.0056 JRC + 2.241 (JCS/a)^-0.245`, aperture
/// `a = JRC/5 (0.2 sigma_c/JCS - 0.1)`; mm and MPa.
#[must_use]
pub fn closure_of(jrc: f64, jcs: f64, rock: f64) -> Option<[f64; 2]> {
    let aperture = jrc / 5.0 * (0.2 * rock / jcs - 0.1);
    let ratio = 1e-6 * jcs / aperture;
    let stiffness = -7.15 + 1.75 * jrc + 0.02 * ratio;
    let most = -0.296 - 0.0056 * jrc + 2.241 * libm::pow(ratio, -0.245);
    let sound = aperture > 0.0 && stiffness > 0.0 && most > 0.0 && most <= aperture;
    sound.then_some([1e9 * stiffness, 1e-3 * most])
}
