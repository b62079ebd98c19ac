//! Gradual failure that takes a given energy per area, whatever the size of the blocks.
//!
//! A share D of the point is a contact: `t_n = (1 - D) k_n e_n` (whole in compression),
//! `t_s = (1 - D) k_s e_s + D t_f = t_f + (1 - D) k_s slip`, with `t_f` the traction of a Coulomb slider and
//! `slip = e_s - t_f/k_s`. So the bond carries what friction does not, and the peak shear is `c - t_n tan(phi)`.
//! Damage follows from `a = (e_n k_n/tension)²` (in tension), `b = (k_s |slip|/c)²`, `kappa = sqrt(a + b)`: none up to
//! kappa = 1, then along a softening curve whose length is set by the fracture energies of opening and shear. In a
//! constant direction the energies taken obey `G_I/G_Ic + G_II/G_IIc = 1`, elastic part included, and what friction
//! takes is on top.
//!
//! Source: bilinear law as in Camanho & Davila (2002), NASA/TM-2002-211737, with the linear energy criterion; curve of
//! Munjiza, Andrews & White (1999), Int. J. Numer. Meth. Engng 44, 41-57; Petersson (1981), report TVBM-1006, Lund;
//! Cornelissen, Hordijk & Reinhardt (1986), Heron 31 (2), 45-56.
//! Deviations: damage is driven by the slip of the slider, because with the whole `e_s` friction would count twice
//! at the peak; curves run over the displacement past the peak (the crack of the sources opens by that and by what the springs give
//! back, less than `strength/k`), with the whole area as fracture energy; D itself is remembered, not kappa, because the length of the curve changes with the direction.

use riprap_keys::Words;
use serde::{Deserialize, Serialize};

use super::{Springs, State, Strength, Traction, from_rest, norm, slider};
use crate::laws::softening_curve::Curve;

/// Softening curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Softening {
    /// A straight line.
    #[default]
    Linear,
    /// Measured on concrete (Munjiza): steep first, with a long tail.
    Munjiza,
    /// Two lines for concrete (Petersson): to a third of the strength at 0.8 G/f, to nothing at 3.6 G/f.
    Petersson,
    /// Measured on concrete (Cornelissen, Hordijk and Reinhardt): steeper than `munjiza` at first, nothing left at 5.136 G/f.
    Hordijk,
    /// Exponential, `exp(-w f/G)`; cut off where a thousandth is left.
    Exponential,
}

/// Strength and fracture energies; tension and cohesion are above 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cohesive {
    /// Peak strength. Friction is that after failure; the one before failure is not used.
    pub strength: Strength,
    /// Fracture energies of opening and of shear, J/m².
    pub energy: [f64; 2],
    /// Curve from the peak to nothing.
    pub softening: Softening,
    /// Curve by points; in the place of `softening`.
    pub curve: Option<Curve>,
}

/// Area under [`munjiza`].
pub(super) const MUNJIZA_AREA: f64 = 0.386_307_3;

/// Munjiza's curve: traction over strength at the share `x` (0 to 1) of the softening length.
#[must_use]
pub fn munjiza(x: f64) -> f64 {
    const A: f64 = 0.63;
    const B: f64 = 1.8;
    const C: f64 = 6.0;
    let sum = A + B;
    let fall = 1.0 - (sum - 1.0) / sum * libm::exp(x * (A + C * B) / (sum * (1.0 - sum)));
    let rest = 1.0 - x;
    let square = rest * rest;
    fall * (A * rest + B * square * square * square)
}

/// Share of the strength where Petersson's two lines meet, and of their length.
const PETERSSON: [f64; 2] = [0.8 / 3.6, 1.0 / 3.0];
/// Constants c_1 and c_2 of Cornelissen, Hordijk and Reinhardt, and the area under their curve.
const HORDIJK: [f64; 2] = [3.0, 6.93];
pub(super) const HORDIJK_AREA: f64 = 0.194_701_953_6;
/// Logarithm of the strength at which an exponential curve is cut off.
const CUT_OFF: f64 = 7.0;

/// Traction over strength at the share `x` (0 to 1) of the softening length, of a curve that is no straight line.
fn hordijk(x: f64) -> f64 {
    let [c, d] = HORDIJK;
    let cube = |x: f64| x * x * x;
    (1.0 + cube(c * x)) * libm::exp(-d * x) - x * (1.0 + cube(c)) * libm::exp(-d)
}

/// The same for an exponential curve.
fn exponential(x: f64) -> f64 {
    let end = libm::exp(-CUT_OFF);
    (libm::exp(-CUT_OFF * x) - end) / (1.0 - end)
}

/// The same for two lines.
fn petersson(x: f64) -> f64 {
    let [at, share] = PETERSSON;
    if x < at { 1.0 - (1.0 - share) * x / at } else { share * (1.0 - x) / (1.0 - at) }
}

impl Cohesive {
    /// Traction over strength at the share `x` (0 to 1) of the softening length.
    #[must_use]
    pub fn share(&self, x: f64) -> f64 {
        if let Some(curve) = &self.curve {
            return curve.at(x);
        }
        match self.softening {
            Softening::Linear => 1.0 - x,
            Softening::Munjiza => munjiza(x),
            Softening::Petersson => petersson(x),
            Softening::Hordijk => hordijk(x),
            Softening::Exponential => exponential(x),
        }
    }

    /// Area under the curve of [`Cohesive::share`].
    #[must_use]
    pub fn share_area(&self) -> f64 {
        if let Some(curve) = &self.curve {
            return curve.area();
        }
        match self.softening {
            Softening::Linear => 0.5,
            Softening::Munjiza => MUNJIZA_AREA,
            Softening::Petersson => 1.0 / 3.6,
            Softening::Hordijk => HORDIJK_AREA,
            Softening::Exponential => 1.0 / CUT_OFF - 1.0 / libm::expm1(CUT_OFF),
        }
    }

    /// Damage at `kappa`, where the whole curve has the area `area` (in units of the peak).
    #[inline]
    fn damage(&self, kappa: f64, area: f64) -> f64 {
        if kappa <= 1.0 {
            return 0.0;
        }
        if self.curve.is_none() && self.softening == Softening::Linear {
            // A triangle as high as the peak: half of its base is its area.
            let end = 2.0 * area;
            if kappa >= end {
                return 1.0;
            }
            return 1.0 - (end - kappa) / ((end - 1.0) * kappa);
        }
        // The rise to the peak has an area of one half.
        let length = (area - 0.5) / self.share_area();
        if kappa - 1.0 >= length {
            return 1.0;
        }
        1.0 - self.share((kappa - 1.0) / length) / kappa
    }
}

/// Traction of a softening point and its new state, both from the state `committed` at the last equilibrium (or step).
#[inline]
#[must_use]
pub fn cohesive(
    springs: Springs,
    law: &Cohesive,
    start: &Traction,
    at: &[f64; 3],
    committed: &State,
) -> (Traction, State) {
    let [kn, ks] = springs;
    let e = from_rest(springs, start, at);
    let strength = &law.strength;
    let (rubbed, slip) = slider(springs, strength, &e, &committed.slip);
    let peaks = [strength.tension, strength.cohesion];
    let opening = kn * e[0].max(0.0) / peaks[0];
    let shear = ks * norm(slip[0], slip[1]) / peaks[1];
    let (a, b) = (opening * opening, shear * shear);
    let mut damage = committed.damage;
    if a + b > 1.0 && damage < 1.0 {
        // Areas of the curves of opening and shear in units of their peaks.
        let area = [0, 1].map(|k| law.energy[k] * springs[k] / (peaks[k] * peaks[k]));
        let area = (a + b) / (a / area[0] + b / area[1]);
        // What is damaged does not heal when the direction changes.
        damage = damage.max(law.damage((a + b).sqrt(), area));
    }
    let whole = 1.0 - damage;
    let normal = if e[0] > 0.0 { whole * kn * e[0] } else { kn * e[0] };
    let t =
        [normal, whole * ks * e[1] + damage * rubbed[1], whole * ks * e[2] + damage * rubbed[2]];
    (t, State { damage, slip })
}
