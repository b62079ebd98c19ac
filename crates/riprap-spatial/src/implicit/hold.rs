//! What holds a block from outside in an implicit step: springs and dashpots at points of its faces.
//!
//! ```text
//!   force = -(pull + drag v)      v: velocity of the point; a quadratic term, exact in one iteration
//! ```

#![expect(clippy::needless_range_loop, reason = "indices are rows and columns of several matrices")]

use riprap_geom::{Mat3, Vec3};

use crate::implicit::pair::Answer;
use crate::implicit::patch::{Stepping, Twist};

/// A point that is held.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Point {
    /// From the centroid of the block, m.
    pub arm: Vec3,
    /// What pulls it back where it does not move, N.
    pub pull: Vec3,
    /// What more where it does, N s/m.
    pub drag: Mat3,
}

/// The points of a face.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Hold {
    pub points: [Point; 4],
    /// Whether what it takes is lost: dashpots without springs.
    pub dashpots: bool,
}

impl Point {
    fn speed(&self, twist: &Twist) -> Vec3 {
        let [x, y, z, p, q, r] = *twist;
        Vec3::new(x, y, z) + Vec3::new(p, q, r).cross(self.arm)
    }
}

impl Hold {
    /// Adds what it exerts on the block about its centroid and, where asked for, the rate of its impulse.
    pub(crate) fn add(
        &self,
        twist: &Twist,
        step: &Stepping,
        soft: f64,
        with_rate: bool,
        answer: &mut Answer,
    ) {
        answer.acts = true;
        for point in &self.points {
            let force = -soft * (point.pull + point.drag * point.speed(twist));
            let moment = point.arm.cross(force);
            for (k, x) in force.to_array().into_iter().chain(moment.to_array()).enumerate() {
                answer.wrench[k] += x;
            }
            if !with_rate {
                continue;
            }
            // The point moves by v + w x arm for each of the six rates.
            let moves: [Vec3; 6] = std::array::from_fn(|k| match k {
                0..3 => Vec3::AXES[k],
                _ => Vec3::AXES[k - 3].cross(point.arm),
            });
            for i in 0..6 {
                let pulled = soft * step.span * (point.drag * moves[i]);
                for k in 0..6 {
                    answer.rate[k][i] += moves[k].dot(pulled);
                }
            }
        }
    }

    /// Power that its dashpots take, W.
    pub(crate) fn taken(&self, twist: &Twist) -> f64 {
        let of = |point: &Point| {
            let v = point.speed(twist);
            v.dot(point.drag * v)
        };
        if self.dashpots { self.points.iter().map(of).sum() } else { 0.0 }
    }
}
