//! Where and in which direction a block is about to break: Griffith's and Mohr-Coulomb's criteria on its mean stress.
//!
//! In this file **compression is positive** and `s1 >= s2 >= s3`, as in the source; stresses come in with tension
//! positive and are turned here. The angle psi is that between the plane of a
//! crack and the direction of s1.
//!
//! Source: Han, Liu & Li (2010), equations (13) to (17). Deviations, each with a test that shows why: the second branch
//! of (13) has `(s1 - s3)²`; (14) has `s1 - s3`; (16) is `psi = pi/4 - phi/2`; the margins of (17) both make cutting
//! earlier; [`Criterion::Larger`] looks at the tensile strength also where `s1 + 3 s3 > 0`.

use riprap_keys::Words;
use serde::{Deserialize, Serialize};

use super::mohr_coulomb::shear_limit;
use super::norm;
use super::tetrahedron::Gradient;
use crate::Vec3;
use crate::geom::Mat3;
use crate::geom::polyhedron;

#[cfg(test)]
mod tests;

/// Principal stresses nearer than this, times the largest, leave the direction between them open.
pub const DEGENERATE: f64 = 0.05;
/// Conjugate planes whose sliding differs by less than this share are equal: the first is taken.
const TIE: f64 = 1e-9;

/// Strength of rock.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rock {
    /// Tensile strength, Pa.
    pub tension: f64,
    /// Cohesion, Pa.
    pub cohesion: f64,
    /// tan of the friction angle.
    pub friction: f64,
}

impl Rock {
    /// 1/cos of the friction angle.
    fn secant(&self) -> f64 {
        (1.0 + self.friction * self.friction).sqrt()
    }

    /// Half the difference of the principal stresses `s1` and `s3` on the scale of the shear strength, and the shear that the
    /// rock bears at their mean, Pa: the plane that is nearest to failure fails when both are equal.
    fn shear(&self, s1: f64, s3: f64) -> [f64; 2] {
        let (r, s) = (0.5 * (s1 - s3), 0.5 * (s1 + s3));
        [r * self.secant(), shear_limit(self.cohesion, self.friction, -s)]
    }
}

/// How much before its strength a block is cut, Pa (both at least 0).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Margins {
    /// In tension.
    pub tension: f64,
    /// In shear.
    pub shear: f64,
}

/// When a block is cut, by its average stress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Criterion {
    /// Tension where s1 + 3 s3 < 0 (compression positive), Mohr-Coulomb elsewhere: the source.
    ///
    /// Equation (17).
    Source,
    /// Griffith, in tension and compression.
    ///
    /// Equation (13).
    Griffith,
    /// Mohr-Coulomb.
    ///
    /// Equation (15).
    MohrCoulomb,
    /// Tension and Mohr-Coulomb, whichever is used more.
    #[default]
    Larger,
}

/// FractureMode of breaking.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FractureMode {
    /// Across s3.
    Tension,
    /// By Griffith's criterion under compression, on inclined planes.
    Griffith,
    /// By Mohr-Coulomb's criterion, on inclined planes.
    Shear,
}

/// Principal stresses, compression positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// `s1 >= s2 >= s3`, Pa; with an out-of-plane direction s2 is the stress along it.
    pub values: [f64; 3],
    /// Unit vectors along them.
    pub axes: [Vec3; 3],
}

/// What a criterion says of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// FractureMode of breaking that is nearest.
    pub mode: FractureMode,
    /// Stress beyond the limit (less the margin), Pa: at least 0 when the block is to be cut.
    pub excess: f64,
    /// Load over the limit (less the margin); at least 1 when the block is to be cut.
    pub utilisation: f64,
}

impl Verdict {
    /// Whether the block is to be cut.
    #[must_use]
    pub fn cut(&self) -> bool {
        self.excess >= 0.0
    }
}

/// Principal stresses of a stress (tension positive). `out` is a unit vector that one principal direction shall have,
/// for plane strain: s1 and s3 are then those of the plane across it.
#[must_use]
pub fn principal(stress: &Mat3, out: Option<Vec3>) -> Principal {
    let matrix = -*stress;
    let Some(out) = out else {
        let (v, axes) = polyhedron::principal(&matrix);
        return Principal {
            // Ascending there, descending here.
            values: [v.z, v.y, v.x],
            axes: [axes.z_axis, axes.y_axis, axes.x_axis].map(upward),
        };
    };
    let [_, b, c] = polyhedron::frame(out);
    let (bb, cc, bc) = (b.dot(matrix * b), c.dot(matrix * c), b.dot(matrix * c));
    let (middle, radius) = (0.5 * (bb + cc), norm(0.5 * (bb - cc), bc));
    let angle = 0.5 * libm::atan2(2.0 * bc, bb - cc);
    let first = libm::cos(angle) * b + libm::sin(angle) * c;
    Principal {
        values: [middle + radius, out.dot(matrix * out), middle - radius],
        axes: [first, out, out.cross(first)].map(upward),
    }
}

/// The one of two opposite vectors whose largest component is positive.
fn upward(v: Vec3) -> Vec3 {
    let a = v.abs();
    let largest = if a.x >= a.y && a.x >= a.z {
        v.x
    } else if a.y >= a.z {
        v.y
    } else {
        v.z
    };
    if largest < 0.0 { -v } else { v }
}

/// Griffith's equivalent tension, Pa: reaches the tensile strength at failure. `-s3` where `s1 + 3 s3 < 0`, else
/// `(s1 - s3)²/(8 (s1 + s3))`; (13), corrected.
#[must_use]
pub fn griffith(s1: f64, s3: f64) -> f64 {
    if s1 + 3.0 * s3 < 0.0 || s1 + s3 <= 0.0 {
        -s3
    } else {
        (s1 - s3) * (s1 - s3) / (8.0 * (s1 + s3))
    }
}

/// Mohr-Coulomb's excess `R/cos(phi) - S tan(phi) - c`, Pa, with `R = (s1 - s3)/2`, `S = (s1 + s3)/2`: the largest over all
/// planes of `tau - sigma tan(phi) - c`.
#[must_use]
pub fn mohr_coulomb(rock: &Rock, s1: f64, s3: f64) -> f64 {
    let [load, limit] = rock.shear(s1, s3);
    load - limit
}

/// What `criterion` says of principal stresses.
#[must_use]
pub fn assess(
    rock: &Rock,
    criterion: Criterion,
    margins: &Margins,
    principal: &Principal,
) -> Verdict {
    let [s1, _, s3] = principal.values;
    let verdict = |mode, load: f64, limit: f64| Verdict {
        mode,
        excess: load - limit,
        // Without any strength left the ratio says nothing: what is beyond the limit is so wholly, what is not stays out of the way
        // of the other criterion.
        utilisation: if limit > 0.0 {
            load / limit
        } else if load >= limit {
            f64::INFINITY
        } else {
            0.0
        },
    };
    let pulled = s1 + 3.0 * s3 < 0.0;
    let limit = rock.tension - margins.tension;
    let tension = verdict(FractureMode::Tension, -s3, limit);
    let shear = {
        let [load, limit] = rock.shear(s1, s3);
        verdict(FractureMode::Shear, load, limit - margins.shear)
    };
    match criterion {
        Criterion::Source if pulled => tension,
        Criterion::Griffith if pulled => tension,
        Criterion::Griffith => verdict(FractureMode::Griffith, griffith(s1, s3), limit),
        Criterion::Source | Criterion::MohrCoulomb => shear,
        Criterion::Larger if tension.utilisation >= shear.utilisation => tension,
        Criterion::Larger => shear,
    }
}

/// Angle psi between a plane of breaking and the direction of s1, rad: 0 in tension, (14) for Griffith, (16) for
/// Mohr-Coulomb, both corrected.
#[must_use]
pub fn plane_angle(rock: &Rock, mode: FractureMode, principal: &Principal) -> f64 {
    let [s1, _, s3] = principal.values;
    match mode {
        FractureMode::Tension => 0.0,
        FractureMode::Griffith => {
            let cosine = (s1 - s3) / (2.0 * (s1 + s3));
            // Outside the compressive branch the plane contains s1.
            let cosine = if cosine >= 0.0 { cosine.min(1.0) } else { 1.0 };
            0.5 * libm::acos(cosine)
        }
        // Half of what the friction angle lacks to a right one.
        FractureMode::Shear => 0.5 * libm::atan2(1.0, rock.friction),
    }
}

/// Unit normal of the plane in which a block breaks.
///
/// The plane contains the direction of s2. Of two conjugate planes, whose tractions are equal, the one is taken along
/// which the block slides more: `|s . H n|` with the mean displacement gradient `H`, whose rotation breaks the
/// tie, and `s` the direction of sliding; of equal ones the first. Where s2 is about s1 or s3 and `hint` is given
/// (the direction that s2 shall have, say that of the last cut), s2 is turned as near to it as it can be.
#[must_use]
pub fn cut_normal(
    rock: &Rock,
    mode: FractureMode,
    principal: &Principal,
    gradient: &Gradient,
    hint: Option<Vec3>,
) -> Vec3 {
    let principal = hint.map_or(*principal, |hint| settle(principal, hint));
    let [e1, _, e3] = principal.axes;
    let psi = plane_angle(rock, mode, &principal);
    if psi == 0.0 {
        return e3;
    }
    let (sine, cosine) = (libm::sin(psi), libm::cos(psi));
    let sliding = |sign: f64| {
        let (n, s) = (sine * e1 + sign * cosine * e3, -cosine * e1 + sign * sine * e3);
        let moved = Vec3::from_array(gradient.map(|row| Vec3::from_array(row).dot(n)));
        (n, s.dot(moved).abs())
    };
    let ((n, a), (m, b)) = (sliding(1.0), sliding(-1.0));
    if b - a > TIE * a.max(b) { m } else { n }
}

/// Principal axes with that of s2 as near to `hint` as the stresses leave open.
#[must_use]
pub fn settle(principal: &Principal, hint: Vec3) -> Principal {
    let ([s1, s2, s3], [e1, _, e3]) = (principal.values, principal.axes);
    let open = DEGENERATE * s1.abs().max(s3.abs());
    // Turn about the axis that stays.
    // Of two pairs that are both near, the nearer one.
    let (kept, turn_third) = if s2 - s3 < open && s2 - s3 <= s1 - s2 {
        (e1, true)
    } else if s1 - s2 < open {
        (e3, false)
    } else {
        return *principal;
    };
    let across = hint - hint.dot(kept) * kept;
    // A hint along the axis that stays says nothing of how to turn about it.
    if across.length() <= 1e-6 * hint.length() {
        return *principal;
    }
    let second = across.normalize();
    let other = upward(kept.cross(second));
    let axes = if turn_third { [e1, second, other] } else { [other, second, e3] };
    Principal { values: principal.values, axes }
}
