//! Spring between deformable blocks, per unit area: connected, breaking at once or gradually, in contact.
//!
//! Tractions (Pa) act on the first block, tension positive, in the frame (n, b, c) of the interface; `at` is the
//! displacement of the second block less that of the first (m). A traction `start` at zero displacement counts as
//! displacement of its own: everything below is written in `e = at + start / k`, so that closed and open are
//! told by the sign of the normal traction.
//!
//! An interface of thickness L has the springs `E/L` and `G/L`. A whole point is elastic, (8). One beyond its strength
//! breaks: at once, [`brittle`], or along a softening curve that takes the fracture energies, `cohesive`. A
//! broken point is a contact, [`contact`]: no tension, and a Coulomb slider in shear.
//!
//! Functions take the state at the last committed instant and return the new one; whoever iterates to equilibrium
//! commits when it has converged. [`stored`] and [`loss`] keep the energy ledger: work = change of stored + loss.
//!
//! Source: Han, Liu & Li (2010), equations (8) to (11). Deviations: (11) is read with the sign of the normal force, so
//! that tension does not raise the shear strength; (9) is a return mapping, so that reversals dissipate.

use serde::{Deserialize, Serialize};

use super::mohr_coulomb::shear_limit;
use super::norm;
use crate::lanes::{LANES, Lanes, Vectors, dot, minus, plus, scaled};

mod cohesive;
#[cfg(test)]
mod tests;

pub use super::mohr_coulomb::{FailureMode, Strength};
pub use super::softening_curve::{Curve, CurveError};
pub use cohesive::{Cohesive, Softening, cohesive, munjiza};

/// Traction: n, b, c, Pa.
pub type Traction = [f64; 3];
/// Normal and shear stiffness, Pa/m.
pub type Springs = [f64; 2];

/// Springs of an interface with Young's modulus, shear modulus (Pa) and thickness (m), (8).
#[must_use]
pub fn springs(young: f64, shear: f64, thickness: f64) -> Springs {
    [young / thickness, shear / thickness]
}

/// Normal stiffness (Pa/m) of a bond in series with what lies behind it on either side: half a rigid lattice block of
/// edge `L_r` has `2 M / L_r` in compression and `4 G / L_r` in shear; infinite for a deformable block.
#[must_use]
pub fn in_series(bond: f64, behind: [f64; 2]) -> f64 {
    1.0 / (1.0 / bond + 1.0 / behind[0] + 1.0 / behind[1])
}

/// What a point remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// 0: whole, 1: broken; between: a cohesive point that softens.
    pub damage: f64,
    /// Irrecoverable shear displacement (b, c), counted in `e`, m.
    pub slip: [f64; 2],
}

/// `e = at + start / k`: displacement from the place without traction, m.
#[inline]
fn from_rest(springs: Springs, start: &Traction, at: &[f64; 3]) -> [f64; 3] {
    let [kn, ks] = springs;
    [at[0] + start[0] / kn, at[1] + start[1] / ks, at[2] + start[2] / ks]
}

/// Traction of a whole point, (8).
#[inline]
#[must_use]
pub fn connect(springs: Springs, start: &Traction, at: &[f64; 3]) -> Traction {
    let [kn, ks] = springs;
    [start[0] + kn * at[0], start[1] + ks * at[1], start[2] + ks * at[2]]
}

/// Traction of a contact with tan(phi) `friction`, (9), and its new state.
///
/// A point that has just broken comes with the slip 0: its shear traction goes on from where it was, at most at the
/// friction limit.
#[inline]
#[must_use]
pub fn contact(
    springs: Springs,
    strength: &Strength,
    start: &Traction,
    at: &[f64; 3],
    before: &State,
) -> (Traction, State) {
    let e = from_rest(springs, start, at);
    let (t, slip) = slider(springs, strength, &e, &before.slip);
    (t, State { damage: 1.0, slip })
}

/// Return mapping of a frictional contact: traction and slip.
#[inline]
fn slider(
    [kn, ks]: Springs,
    strength: &Strength,
    e: &[f64; 3],
    slip: &[f64; 2],
) -> (Traction, [f64; 2]) {
    // Open: the shear spring follows without traction.
    if e[0] >= 0.0 {
        return ([0.0; 3], [e[1], e[2]]);
    }
    let normal = kn * e[0];
    let trial = [ks * (e[1] - slip[0]), ks * (e[2] - slip[1])];
    let (size, limit) = (norm(trial[0], trial[1]), strength.residual(normal));
    if size <= limit {
        return ([normal, trial[0], trial[1]], *slip);
    }
    let keep = limit / size;
    let shear = trial.map(|x| keep * x);
    ([normal, shear[0], shear[1]], [e[1] - shear[0] / ks, e[2] - shear[1] / ks])
}

/// Traction of a point that breaks at once where it is beyond its strength, (8) to (11), and its new state.
#[inline]
#[must_use]
pub fn brittle(
    springs: Springs,
    strength: &Strength,
    start: &Traction,
    at: &[f64; 3],
    before: &State,
) -> (Traction, State) {
    if before.damage < 1.0 {
        let t = connect(springs, start, at);
        if strength.failure(&t).is_none() {
            return (t, *before);
        }
    }
    contact(springs, strength, start, at, before)
}

/// Energy stored in the springs of a point, J/m².
///
/// Part of the damage `D` of a softening point is a contact: `(1 - D)` of the whole springs and `D` of the slider; in
/// compression the normal spring is whole.
#[inline]
#[must_use]
pub fn stored(springs: Springs, start: &Traction, at: &[f64; 3], state: &State) -> f64 {
    let [kn, ks] = springs;
    let e = from_rest(springs, start, at);
    let whole = 1.0 - state.damage;
    let normal = if e[0] > 0.0 { whole * kn } else { kn };
    let shear = |k: usize| {
        let (all, part) = (e[k + 1], e[k + 1] - state.slip[k]);
        whole * all * all + state.damage * part * part
    };
    0.5 * (normal * e[0] * e[0] + ks * (shear(0) + shear(1)))
}

/// Energy that left the springs of a point while it moved from one displacement to another, J/m²: the work (trapezoidal
/// rule) of the tractions less the change of what is stored.
///
/// `before` and `after` are displacement, traction and state. The traction resists, so its work counts as input.
#[inline]
#[must_use]
pub fn loss(
    springs: Springs,
    start: &Traction,
    before: (&[f64; 3], &Traction, &State),
    after: (&[f64; 3], &Traction, &State),
) -> f64 {
    let work: f64 =
        (0..3).map(|k| 0.5 * (before.1[k] + after.1[k]) * (after.0[k] - before.0[k])).sum();
    work - (stored(springs, start, after.0, after.2) - stored(springs, start, before.0, before.2))
}

/// Share of the strength up to which [`near_eight`] vouches for a point, without regard to round-off.
const NEAR: f64 = 1.0 - 1e-6;

/// Tractions (x, y, z) of eight whole points with unit normals `n` at displacements `at`, all in space and without
/// start tractions, (8): `t = ks at + (kn - ks)(n . at) n`.
#[inline(always)]
#[must_use]
pub fn connect_eight([kn, ks]: [Lanes; 2], n: &Vectors, at: &Vectors) -> Vectors {
    let along = scaled((kn - ks) * dot(at, n), n);
    plus(&scaled(ks, at), &along)
}

/// Whether one of eight tractions is beyond the strength or so near that [`Strength::failure`] must be asked; where
/// this is false, none fails.
#[inline(always)]
#[must_use]
pub fn near_eight(strength: &Strength, n: &Vectors, t: &Vectors) -> bool {
    let sigma = dot(t, n);
    let shear = minus(t, &scaled(sigma, n));
    let square = dot(&shear, &shear);
    let tension = NEAR * strength.tension;
    let cohesion = Lanes::all(NEAR * strength.cohesion);
    let limit = shear_limit(cohesion, Lanes::all(strength.friction), sigma);
    let mut fine = true;
    for k in 0..LANES {
        let limit = NEAR * limit.0[k];
        // Beyond the tip of the strength the limit is negative, and its square would let shear pass.
        fine &= (sigma.0[k] <= tension) & (limit >= 0.0) & (square.0[k] <= limit * limit);
    }
    !fine
}
