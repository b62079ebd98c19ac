//! What planes leave of a face: only whether anything is left.

use riprap_geom::Vec3;

use crate::kernel::planes::Planes;
use crate::kernel::shape::Body;
use crate::lanes::{LANES, Lanes, dot, plus, same, scaled};

/// A convex polygon of which nothing is known but how far its corners lie beyond each of a set of planes. That is enough to cut it:
/// the distances of a crossing are between those of the two corners.
#[derive(Clone, Debug, Default)]
pub(super) struct FaceClip {
    planes: usize,
    /// How far each corner is beyond each plane, m: corner by corner.
    beyond: Vec<f64>,
    spare: Vec<f64>,
}

impl FaceClip {
    /// A face with so many corners, before so many planes.
    pub(super) fn begin(&mut self, planes: usize, corners: usize) {
        self.planes = planes;
        self.beyond.clear();
        self.beyond.resize(planes * corners, 0.0);
    }

    /// Says how far a corner lies beyond planes from `plane` on, m.
    #[inline]
    pub(super) fn set(&mut self, corner: usize, plane: usize, beyond: &[f64]) {
        let first = corner * self.planes + plane;
        self.beyond[first..first + beyond.len()].copy_from_slice(beyond);
    }

    /// Whether anything lies inside all planes, each moved outward by `slack` (m).
    pub(super) fn is_left(&mut self, slack: f64) -> bool {
        (0..self.planes).all(|plane| self.cut(plane, slack))
    }

    /// Keeps what is inside one plane; whether anything is.
    fn cut(&mut self, plane: usize, slack: f64) -> bool {
        let corners = || self.beyond.chunks_exact(self.planes);
        let is_inside = |corner: &[f64]| corner[plane] <= slack;
        if corners().all(is_inside) {
            return true;
        }
        self.spare.clear();
        for (corner, next) in corners().zip(corners().cycle().skip(1)) {
            let (here, there) = (is_inside(corner), is_inside(next));
            if here {
                self.spare.extend_from_slice(corner);
            }
            if here != there {
                let share = (corner[plane] - slack) / (corner[plane] - next[plane]);
                let between = corner.iter().zip(next).map(|(a, b)| a + share * (b - a));
                self.spare.extend(between);
            }
        }
        std::mem::swap(&mut self.beyond, &mut self.spare);
        !self.beyond.is_empty()
    }
}

/// Whether all corners of a face lie beyond plane `k` of the other block, by the operations of [`cut_face`].
pub(super) fn is_beyond(planes: &Planes, k: usize, body: &Body, shift: Vec3, face: &[u16]) -> bool {
    let normal = planes.normal(k).to_array();
    let back = body.turn.transpose();
    let [x, y, z] = [back.x_axis, back.y_axis, back.z_axis].map(|axis| axis.to_array());
    let own = plus(&plus(&scaled(normal[0], &x), &scaled(normal[1], &y)), &scaled(normal[2], &z));
    let room = planes.d[k] - dot(&normal, &shift.to_array());
    let mut corners = face.iter().map(|v| body.shape.vertices[*v as usize].to_array());
    corners.all(|corner| dot(&own, &corner) - room >= 0.0)
}

/// Finds how far the corners of a face lie beyond planes of the other block, `shift` (m) being where its block is from their origin; a plane
/// that has all of them beyond it, if any.
#[inline(always)]
pub(super) fn cut_face(
    planes: &Planes,
    others: std::ops::Range<usize>,
    body: &Body,
    shift: Vec3,
    face: &[u16],
    clip: &mut FaceClip,
) -> Option<usize> {
    // Planes are turned back into the body once, instead of every corner into space: eight at a time.
    let back = body.turn.transpose();
    let axes = [back.x_axis, back.y_axis, back.z_axis].map(|axis| same(&axis.to_array()));
    let shift = same(&shift.to_array());
    clip.begin(others.len(), face.len());
    for column in (0..others.len()).step_by(LANES) {
        let from = others.start + column;
        let normal = [&planes.x, &planes.y, &planes.z].map(|list| Lanes::at(list, from));
        let own = plus(
            &plus(&scaled(normal[0], &axes[0]), &scaled(normal[1], &axes[1])),
            &scaled(normal[2], &axes[2]),
        );
        let room = Lanes::at(&planes.d, from) - dot(&normal, &shift);
        let there = (others.len() - column).min(LANES);
        let mut beyond = [true; LANES];
        for (row, v) in face.iter().enumerate() {
            let corner = same(&body.shape.vertices[*v as usize].to_array());
            let height = (dot(&own, &corner) - room).0;
            clip.set(row, column, &height[..there]);
            for (beyond, height) in beyond.iter_mut().zip(height) {
                *beyond &= height >= 0.0;
            }
        }
        if let Some(lane) = beyond[..there].iter().position(|all| *all) {
            return Some(from + lane);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether something of the unit square is left by planes `[a, b, c]`, `a x + b y <= c`.
    fn left(planes: &[[f64; 3]], slack: f64) -> bool {
        let mut clip = FaceClip::default();
        clip.begin(planes.len(), 4);
        for (corner, [x, y]) in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].iter().enumerate()
        {
            for (plane, [a, b, c]) in planes.iter().enumerate() {
                clip.set(corner, plane, &[a * x + b * y - c]);
            }
        }
        clip.is_left(slack)
    }

    #[test]
    fn a_square_is_cut_by_lines_that_leave_each_corner_alone() {
        assert!(left(&[], 0.0));
        // Each line crosses the square; together they leave nothing.
        let (left_half, right_half) = ([1.0, 0.0, 0.4], [-1.0, 0.0, -0.6]);
        assert!(left(&[left_half], 0.0) && left(&[right_half], 0.0));
        assert!(!left(&[left_half, right_half], 0.0));
        assert!(left(&[left_half, right_half], 0.11));
        // A strip between two slanted lines, closed by a third.
        let strip = [[1.0, -1.0, 0.1], [-1.0, 1.0, 0.1]];
        assert!(left(&strip, 0.0));
        assert!(!left(&[strip[0], strip[1], [-1.0, 1.0, -0.11]], 0.0));
    }
}
