//! Rock bridges: what is left whole where a joint ends in the rock, and a cut along it goes on.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

/// Largest difference of two normals that are the same.
const SAME: f64 = 1e-6;

/// Largest distance of a face from the plane of a joint, over the size of the joint.
const ON_PLANE: f64 = 1e-6;

/// The joints of some blocks that have an end, and the law beyond it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Bridges {
    /// Row of `interfaces` for the parts of cuts that lie beyond the ends.
    pub row: u16,
    /// The joints, ascending by the x of their normals.
    joints: Vec<Ended>,
}

/// A joint that has an end: a disk or a convex polygon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ended {
    /// Unit normal.
    pub normal: Vec3,
    /// Centre, m (local).
    pub at: Vec3,
    /// Radius, of a polygon that of its farthest corner, m.
    pub radius: f64,
    /// Corners of a polygon, anticlockwise about the normal, m (local); none of a disk.
    pub corners: Vec<Vec3>,
}

impl Bridges {
    /// Bridges beyond joints, with the row of their law.
    #[must_use]
    pub fn new(row: u16, mut joints: Vec<Ended>) -> Self {
        joints.sort_by(|a, b| a.normal.x.total_cmp(&b.normal.x));
        Self { row, joints }
    }

    /// Whether a face with this centre (m, local) and unit normal lies on the plane of a joint, but within none.
    #[must_use]
    pub fn hold(&self, at: Vec3, normal: Vec3) -> bool {
        let mut on_plane = false;
        for along in [normal, -normal] {
            let from = (self.joints).partition_point(|j| j.normal.x < along.x - SAME);
            let near = self.joints[from..].iter();
            for joint in near.take_while(|j| j.normal.x <= along.x + SAME) {
                let arm = at - joint.at;
                if (joint.normal - along).length() > SAME
                    || joint.normal.dot(arm).abs() > ON_PLANE * joint.radius
                {
                    continue;
                }
                if joint.covers(at) {
                    return false;
                }
                on_plane = true;
            }
        }
        on_plane
    }
}

impl Ended {
    /// A plane of which no part is a joint: all cuts along it are rock that is still whole. `size` (m) says how exactly a face lies on it.
    #[must_use]
    pub fn none(normal: Vec3, at: Vec3, size: f64) -> Self {
        // An edge beyond the radius, and back: nothing lies within.
        let far = at + 2.0 * size * normal.any_orthonormal_vector();
        let corners = vec![far, far + size * normal.cross(far - at).normalize(), far];
        Self { normal, at, radius: size, corners }
    }

    /// Whether a point of its plane lies in it.
    fn covers(&self, at: Vec3) -> bool {
        let edges = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let inside = |(a, b): (&Vec3, &Vec3)| (*b - *a).cross(at - *a).dot(self.normal) >= 0.0;
        (at - self.at).length() <= self.radius && edges.into_iter().all(inside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_beyond_the_end_of_a_joint_are_held() {
        let disk = Ended {
            normal: Vec3::Z,
            at: Vec3::new(1.0, 0.0, 2.0),
            radius: 0.5,
            corners: Vec::new(),
        };
        let square = [(1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0)];
        let polygon = Ended {
            normal: Vec3::X,
            at: Vec3::new(4.0, 1.5, 0.5),
            radius: 0.5_f64.sqrt(),
            corners: square.map(|(y, z)| Vec3::new(4.0, y, z)).to_vec(),
        };
        let other = Ended { at: Vec3::new(3.0, 0.0, 2.0), ..disk.clone() };
        let bridges = Bridges::new(1, vec![disk, polygon, other]);
        let hold = |x: f64, y: f64, z: f64, normal: Vec3| bridges.hold(Vec3::new(x, y, z), normal);
        for normal in [Vec3::Z, -Vec3::Z] {
            assert!(!hold(1.2, 0.2, 2.0, normal) && !hold(3.2, 0.0, 2.0, normal));
            assert!(hold(2.0, 0.0, 2.0, normal));
        }
        let whole = Bridges::new(1, vec![Ended::none(Vec3::Z, Vec3::ZERO, 3.0)]);
        for (x, y) in [(0.0, 0.0), (1.0, 2.0), (-5.0, 0.1), (6.0, 0.0), (7.0, 7.0)] {
            assert!(whole.hold(Vec3::new(x, y, 0.0), -Vec3::Z));
        }
        // On another plane, or across.
        assert!(!hold(2.0, 0.0, 2.1, Vec3::Z) && !hold(2.0, 0.0, 2.0, Vec3::Y));
        assert!(!hold(4.0, 1.9, 0.9, Vec3::X) && hold(4.0, 2.1, 0.9, -Vec3::X));
    }
}
