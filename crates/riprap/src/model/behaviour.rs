//! Joints that soften, are rough, close along a curve or dilate: the same keys in both spaces.

use super::builder::Builder;
use crate::laws::behaviour::{
    BartonBandis, Closure, JointModel, Softening, Weakening, scaled, slip_at_peak,
};
use crate::laws::mohr_coulomb::Strength;
use crate::scenario::Quantity;
use crate::scenario::language::{Interface, curve};
use crate::scenario::read::{Provenance, Read};

impl Builder<'_> {
    /// What the joints of an interface do beyond brittle failure and a linear spring.
    pub(super) fn behaviour(&mut self, name: &str, said: &Interface) -> JointModel {
        let mut behaviour = JointModel::default();
        if let Some(softening) = &said.softening {
            let mut read = self.reading(format!("interfaces.{name}.softening"), softening);
            let slip = read.slip();
            let opening = read.opening_or(slip, Provenance::Default, "`slip`");
            // Looked at with the rules of the language.
            let curve = softening.curve.as_ref().and_then(|c| curve(c).ok());
            let softening = Softening { slip, opening, curve };
            behaviour.weakening = Weakening::Softening(softening);
        }
        if let Some(rough) = &said.barton_bandis {
            let mut read = self.reading(format!("interfaces.{name}.barton_bandis"), rough);
            let [jrc, jcs] = [read.jrc(), read.jcs()];
            let length = read.length();
            let [jrc, jcs] = match length {
                Some(length) => scaled(jrc, jcs, length),
                None => [jrc, jcs],
            };
            let peak_slip = match length {
                Some(length) => {
                    let of_length = slip_at_peak(jrc, length);
                    let why = "L/500 (JRC/L)^0.33, JRC corrected for the length";
                    Some(read.peak_slip_or(of_length, Provenance::Derived, why))
                }
                None => read.peak_slip(),
            };
            behaviour.weakening =
                Weakening::BartonBandis(BartonBandis { jrc, jcs, peak_slip, share: 1.0 });
        }
        if let Some(closure) = &said.closure {
            let mut read = self.reading(format!("interfaces.{name}.closure"), closure);
            behaviour.closure =
                Closure::Hyperbolic { limit: read.limit(), stiffest: read.stiffest() };
        }
        behaviour
    }
}

/// The strength with the dilation of an interface.
pub(super) fn dilates(strength: Strength, read: &mut Read<'_, Interface>) -> Strength {
    Strength {
        dilation: read.said().dilation_angle.as_ref().map_or(0.0, Quantity::tangent),
        dilation_end: read.dilation_end().unwrap_or(0.0),
        ..strength
    }
}
