//! What a joint carried beyond the pressure of the found contact that takes over from it.
//!
//! A joint that lets go can press harder or softer than the law of found contact at the same overlap: it has another stiffness, carried
//! stress from the start, or rocked. The difference, of both signs, goes on as a normal force and a rocking couple; it turns with
//! the contact, fades while the blocks slide or rock on, and goes with the overlap when they part:
//!
//! ```text
//! H = H_0 max(0, 1 - slip/(0.1 sqrt A) - turned/0.0002) min(1, |S_F|/|S_F|_0)
//! ```
//!
//! The rocking is ours: a couple that stayed would move the hinge of a block for good, which the found contact has at its edge.
//!
//! Its work is booked as what the edit has made.

use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use super::friction::Motion;

/// Slip over the root of the area at which nothing is left.
const FADED: f64 = 0.1;
/// Rotation across the normal at which nothing is left, rad.
const TURNED: f64 = 2e-4;

/// The difference, and how much of it is left.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Offset {
    /// What the joint carried, until the contact has been found for the first time.
    pub joint: Option<Carried>,
    /// Normal force at the hand-over, N.
    pub normal: f64,
    /// Couple on B across the normal at the hand-over, turned with the contact since, N m.
    pub rocking: Vec3,
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
            rocking: Vec3::ZERO,
            overlap: 0.0,
            slip: 0.0,
            turned: 0.0,
            force: Vec3::ZERO,
            couple: Vec3::ZERO,
        }
    }

    /// Goes on to this instant, `dt` (s) later; finds the difference when the contact is found for the first time.
    pub(super) fn advance(&mut self, here: &Here, dt: f64) {
        let n = here.normal;
        if let Some(joint) = self.joint.take() {
            let arm = joint.at - here.point;
            let rocking = joint.rocking + arm.cross(joint.normal * n);
            self.normal = joint.normal - here.elastic;
            self.rocking = rocking - rocking.dot(n) * n;
            self.overlap = here.overlap;
        } else if dt > 0.0 {
            self.slip += here.sliding * dt;
            self.turned += here.turning * dt;
            let length = self.rocking.length();
            let turned = self.rocking + here.before.cross(n).cross(self.rocking);
            let across = turned - turned.dot(n) * n;
            let now = across.length();
            self.rocking = if now > 0.0 {
                (length / now) * across
            } else {
                across
            };
        }
        let left = self.left(here.area);
        let share = if here.overlap < self.overlap {
            left * here.overlap / self.overlap
        } else {
            left
        };
        // The contact never pulls.
        self.force = (share * self.normal).max(-here.elastic) * n;
        self.couple = share * self.rocking;
    }

    /// The share of it that sliding and rocking have left.
    fn left(&self, area: f64) -> f64 {
        (1.0 - self.slip / (FADED * area.sqrt()) - self.turned / TURNED).max(0.0)
    }

    /// Whether nothing is left of it for good.
    #[must_use]
    pub fn is_gone(&self, area: f64) -> bool {
        self.joint.is_none() && self.left(area) == 0.0
    }

    /// Work on both blocks in half a step of `dt` (s) with the force it has, J; `arms` are those of its point from the centroids, m.
    #[must_use]
    pub fn work(&self, [a, b]: &[Motion; 2], arms: [Vec3; 2], dt: f64) -> f64 {
        let velocity = (b.velocity + b.spin.cross(arms[1])) - (a.velocity + a.spin.cross(arms[0]));
        0.5 * dt * (self.force.dot(velocity) + self.couple.dot(b.spin - a.spin))
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
    let tilt = if filled.determinant() > 0.0 {
        e.dot(filled.inverse() * e)
    } else {
        0.0
    };
    0.5 * force * force / stiffness * (1.0 / area + tilt)
}
