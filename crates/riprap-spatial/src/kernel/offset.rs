//! What a joint carried beyond the pressure of the found contact that takes over from it.
//!
//! A joint that lets go can press harder or softer than the law of found contact at the same overlap: it has another stiffness, carried
//! stress from the start, or rocked.
//!
//! **It pressed harder.** The difference goes on as a normal force; it turns with the contact, fades while the blocks slide or rock on, and
//! goes with the overlap when they part. So does the rocking couple in every case:
//!
//! ```text
//! H = H_0 max(0, 1 - slip/(0.1 sqrt A) - turned/t) min(1, |S_F|/|S_F|_0)
//!
//! t = 0.0002 for the force, at most 2 E_joint/|couple| for the couple
//! ```
//!
//! The rocking is ours: a couple that stayed would move the hinge of a block for good, which the found contact has at its edge. It has no
//! potential, so it does no more work than what the joint stored: with faces of 100 GPa/m blocks got many times that from it and were
//! thrown off slopes on which they stand (`leaning_block.toml`).
//!
//! **It pressed softer.** Then the joint has a smaller stiffness, or the blocks lie in each other deeper than any force has pressed them: a
//! hinge about the points of a joint folds its blocks into each other, and pairs that joints hold in place are not looked at. Let the
//! difference fade, and the blocks get the energy of that depth from nothing. Instead, a part `E_h` of the energy `E` of the pressure stays
//! hidden, what is left is as soft as the joint, and forces follow from that energy:
//!
//! ```text
//! U = s (sqrt E - sqrt E_h)²,  force and couple: dU/dE = s (1 - sqrt(E_h/E)) times those of the pressure
//!
//!   force               /
//!     |                /   /      flat faces, E = k A d²/2:
//!     |               /  /        s k A (d - d_h): the joint goes on with its own stiffness, s k, and its own depth, d - d_h
//!     |              / /
//!     |             //
//!     +-----------/+---------- depth d
//!                  d_h
//!
//! at the hand-over, r = N_joint/N and q = E_joint/E:  1 - sqrt(E_h/E) = q/r, at most 1, and s = r/(1 - sqrt(E_h/E)): force and energy go on
//! where q >= r² and q <= r. A joint that rocked has more energy than that (q > r): its force goes on, the rest of its energy with the
//! couple that fades. One that was stiffer than the law (q < r²) keeps its energy, not its force: s = 1, since steps are made for the law.
//! ```
//!
//! These forces have a potential, whatever slides, turns or rocks (a constant force at the point of the pressure has none: blocks begin to
//! rock on it by themselves). `E_h` never exceeds `E`: depth that the blocks have left by themselves is not hidden any more, nor is what then
//! presses soft; this changes no energy, since U is 0 there. Parts of a block that is split begin with its
//! share `E_h/E` and its `s`. `Deviation:` the note on free contact (section 6.2) fades the difference of both signs.
//!
//! Books: the pair stores the energy of the joint from the hand-over on, less what its pressure and these forces have done since. When
//! they end, the difference to what the law stores then (nothing, where the blocks have parted) is what the edit has made.

use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use crate::kernel::friction::Motion;

/// Slip over the root of the area at which nothing is left.
const FADED: f64 = 0.1;
/// Rotation across the normal at which nothing is left, rad.
const TURNED: f64 = 2e-4;

/// The difference, and how much of it is left.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Offset {
    /// What the joint carried, until the contact has been found for the first time.
    pub joint: Option<Carried>,
    /// Normal force beyond the pressure at the hand-over, N; 0 where the joint pressed softer.
    pub normal: f64,
    /// Energy of the pressure that stays hidden, J; 0 where the joint pressed harder.
    pub hidden: f64,
    /// Stiffness over that of the law; 1 where the joint pressed harder.
    pub softness: f64,
    /// Energy of the pressure now, J.
    pub energy: f64,
    /// Of parts of a block that was split: hidden share of the energy and stiffness over that of the law, until the contact has been found
    /// for the first time.
    pub begins: Option<[f64; 2]>,
    /// Couple on B across the normal at the hand-over, turned with the contact since, N m.
    pub rocking: Vec3,
    /// Rotation across the normal over which the couple fades, rad.
    pub rocks: f64,
    /// Length of |S_F| at the hand-over, m³.
    pub overlap: f64,
    /// Way slid since, m.
    pub slip: f64,
    /// Way turned across the normal since, rad.
    pub turned: f64,
    /// Force on B now, N.
    pub force: Vec3,
    /// Couple on B now, N m.
    pub couple: Vec3,
    /// Force of the pressure on B now, N.
    pub pressure: Vec3,
    /// Couple of the pressure on B about its point now, N m.
    pub moment: Vec3,
    /// What the pair stores across the contact, J.
    pub stored: f64,
}

/// What a joint carried across its plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Carried {
    /// Normal force, N; positive where it presses.
    pub normal: f64,
    /// Rocking couple on B about `at`, N m.
    pub rocking: Vec3,
    /// Point that the couple and the shear of the contact's memory belong to, m.
    pub at: Vec3,
    /// Energy of its normal springs, J.
    pub energy: f64,
}

/// What the contact is at this instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Here {
    /// Unit normal from A to B.
    pub normal: Vec3,
    /// Elastic normal force, N.
    pub elastic: f64,
    /// Force of the pressure on B, N, and its couple about the point, N m.
    pub pressure: [Vec3; 2],
    /// Energy of the pressure, J.
    pub energy: f64,
    /// |S_F|, m³.
    pub overlap: f64,
    /// Point of the pressure, m.
    pub point: Vec3,
    /// Area, m².
    pub area: f64,
    /// Speed along the contact, m/s.
    pub sliding: f64,
    /// Spin of the blocks against each other across the normal, rad/s.
    pub turning: f64,
    /// Normal of the step before; zero before the first.
    pub before: Vec3,
}

impl Offset {
    /// A joint has let go.
    #[must_use]
    pub fn new(joint: Carried) -> Self {
        Self {
            joint: Some(joint),
            normal: 0.0,
            hidden: 0.0,
            softness: 1.0,
            energy: 0.0,
            begins: None,
            rocking: Vec3::ZERO,
            rocks: TURNED,
            overlap: 0.0,
            slip: 0.0,
            turned: 0.0,
            force: Vec3::ZERO,
            couple: Vec3::ZERO,
            pressure: Vec3::ZERO,
            moment: Vec3::ZERO,
            stored: 0.0,
        }
    }

    /// What parts of its blocks begin with; `None` where nothing is missing.
    #[must_use]
    pub(crate) fn of_parts(&self) -> Option<[f64; 2]> {
        let missing = self.energy > 0.0 && (self.hidden > 0.0 || self.softness < 1.0);
        missing.then(|| [self.hidden / self.energy, self.softness])
    }

    /// Of parts of blocks that were split.
    #[must_use]
    pub(crate) fn begin(begins: [f64; 2]) -> Self {
        Self { joint: None, begins: Some(begins), ..Self::new(Carried::default()) }
    }

    /// Goes on to this instant, `dt` (s) later; finds the difference when the contact is found for the first time, and returns what it stores
    /// from there on, J (0 later).
    pub(super) fn advance(&mut self, here: &Here, dt: f64) -> f64 {
        let n = here.normal;
        let mut begun = 0.0;
        if let Some([share, softness]) = self.begins.take() {
            (self.hidden, self.softness) = (share * here.energy, softness);
            let depth = 1.0 - share.sqrt();
            self.stored = softness * depth * depth * here.energy;
            begun = self.stored;
        } else if let Some(joint) = self.joint.take() {
            let arm = joint.at - here.point;
            // From the point of the joint to that of the pressure, where all of this acts from now on.
            let rocking = joint.rocking + arm.cross(joint.normal * n);
            self.normal = (joint.normal - here.elastic).max(0.0);
            if joint.normal < here.elastic {
                self.soften(joint.normal.max(0.0) / here.elastic, joint.energy / here.energy);
                self.hidden *= here.energy;
            }
            self.rocking = rocking - rocking.dot(n) * n;
            let couple = self.rocking.length();
            // Fading evenly over this rotation it does half of couple times
            // rotation as work: no more than the joint had.
            if couple * TURNED > 2.0 * joint.energy {
                self.rocks = 2.0 * joint.energy / couple;
            }
            self.overlap = here.overlap;
            self.stored = joint.energy;
            begun = joint.energy;
        } else if dt > 0.0 {
            self.slip += here.sliding * dt;
            self.turned += here.turning * dt;
            let length = self.rocking.length();
            let turned = self.rocking + here.before.cross(n).cross(self.rocking);
            let across = turned - turned.dot(n) * n;
            let now = across.length();
            // As long as before: only slip and rotation fade it.
            self.rocking = if now > 0.0 { (length / now) * across } else { across };
        }
        let closed = if here.overlap < self.overlap { here.overlap / self.overlap } else { 1.0 };
        let [share, rocking] =
            [TURNED, self.rocks].map(|turned| closed * self.left(here.area, turned));
        if here.energy < self.hidden {
            (self.hidden, self.softness) = (here.energy, 1.0);
        }
        let missing = if self.hidden > 0.0 {
            1.0 - self.softness * (1.0 - (self.hidden / here.energy).sqrt())
        } else {
            1.0 - self.softness
        };
        let [pressure, moment] = here.pressure;
        self.force = share * self.normal * n - missing * pressure;
        self.couple = rocking * self.rocking - missing * moment;
        (self.pressure, self.moment) = (pressure, moment);
        self.energy = here.energy;
        begun
    }

    /// Finds the stiffness and the hidden share of the energy, from force and energy of the joint over those of the pressure.
    fn soften(&mut self, force: f64, energy: f64) {
        let (softness, depth) = if energy < force * force {
            // Stiffer than the law, which steps are made for, it does not get.
            (1.0, energy.max(0.0).sqrt())
        } else if force > 0.0 {
            let depth = (energy / force).min(1.0);
            (force / depth, depth)
        } else {
            (1.0, 0.0)
        };
        (self.softness, self.hidden) = (softness, (1.0 - depth) * (1.0 - depth));
    }

    /// The share of what was too much that sliding and rocking have left, where a rotation of `turned` (rad) leaves nothing.
    fn left(&self, area: f64, turned: f64) -> f64 {
        if self.turned < turned {
            (1.0 - self.slip / (FADED * area.sqrt()) - self.turned / turned).max(0.0)
        } else {
            0.0
        }
    }

    /// Whether nothing is left of it for good.
    pub(super) fn is_gone(&self, area: f64) -> bool {
        self.joint.is_none()
            && self.hidden == 0.0
            && self.softness == 1.0
            && self.left(area, TURNED) == 0.0
    }

    /// Goes on through half a step of `dt` (s) with the forces it has; `arms` are those of their point from the centroids, m.
    pub(crate) fn pass(&mut self, [a, b]: &[Motion; 2], arms: [Vec3; 2], dt: f64) {
        let velocity = (b.velocity + b.spin.cross(arms[1])) - (a.velocity + a.spin.cross(arms[0]));
        let (force, couple) = (self.force + self.pressure, self.couple + self.moment);
        self.stored -= 0.5 * dt * (force.dot(velocity) + couple.dot(b.spin - a.spin));
    }
}

/// Energy of a plane contact whose pressure is linear: `1/2 kn int d² = N²/(2 kn) (1/A + e . I⁻¹ e)`, `e` being the way from the
/// centroid of the area to the point of the pressure and `I` the second moments of the area about its centroid, J.
///
/// Exact for flat faces on each other, which is what a joint leaves behind, but for the rims: a share of depth over size.
pub(super) fn energy(
    stiffness: f64,
    force: f64,
    area: f64,
    eccentricity: Vec3,
    second: &Mat3,
    normal: Vec3,
) -> f64 {
    if !(area > 0.0 && stiffness > 0.0) {
        return 0.0;
    }
    // Across the normal the area has no extent: anything there makes the matrix invertible.
    let scale = second.x_axis.x + second.y_axis.y + second.z_axis.z;
    let across = Mat3::from_cols(
        scale * normal.x * normal,
        scale * normal.y * normal,
        scale * normal.z * normal,
    );
    let filled = *second + across;
    let e = eccentricity - eccentricity.dot(normal) * normal;
    let tilt = if filled.determinant() > 0.0 { e.dot(filled.inverse() * e) } else { 0.0 };
    0.5 * force * force / stiffness * (1.0 / area + tilt)
}

#[cfg(test)]
mod tests {
    use super::{Carried, Offset};

    /// Force and energy of the joint over those of the pressure, as they stand and as they go on.
    #[test]
    fn force_goes_on_and_energy_is_never_made() {
        for r in [0.0, 1e-3, 0.2, 0.5, 0.958, 0.999] {
            for q in [0.0, 1e-6, 0.04, 0.25, 0.5, 0.9, 1.03, 3.0] {
                let mut offset = Offset::new(Carried::default());
                offset.soften(r, q);
                let (s, depth) = (offset.softness, 1.0 - offset.hidden.sqrt());
                let (force, energy) = (s * depth, s * depth * depth);
                assert!((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&depth));
                assert!(energy <= q + 1e-12, "{r} {q}: {energy}");
                if q >= r * r {
                    assert!((force - r).abs() < 1e-9, "{r} {q}: {force}");
                } else {
                    assert!(force < r && (energy - q).abs() < 1e-9, "{r} {q}: {force}");
                }
                if q >= r * r && q <= r {
                    assert!((energy - q).abs() < 1e-9, "{r} {q}: {energy}");
                }
            }
        }
    }
}
