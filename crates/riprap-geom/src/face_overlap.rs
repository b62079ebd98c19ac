//! The polygon that two flat convex faces share, and its moments.

use crate::polyhedron::{area_vector, flatten, frame};
use crate::{Vec2, Vec3};

/// The shared part of two faces.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap {
    /// Corners, anticlockwise about the normal, m.
    pub outline: Vec<Vec3>,
    /// Area, m².
    pub area: f64,
    /// Centroid, m.
    pub centroid: Vec3,
    /// Normal, then the principal axes b and c of the area: right-handed.
    pub frame: [Vec3; 3],
    /// Radii of gyration `sqrt(int b² dA / A)` and the same for c, m: four points at these distances from the
    /// centroid have the exact area, centroid and second moments.
    pub gyration: [f64; 2],
}

/// Overlap of two convex outlines that lie in one plane with the unit normal `normal`, whichever way round they are
/// listed; `None` when the shared area is at most `smallest` (m²).
///
/// Heights above the plane through the first outline are ignored: the shared part lies halfway between the two.
#[must_use]
pub fn face_overlap(a: &[Vec3], b: &[Vec3], normal: Vec3, smallest: f64) -> Option<Overlap> {
    let [n, e, f] = frame(normal);
    let origin = *a.first()?;
    let height = 0.5 * n.dot(*b.first()? - origin);
    let flat = |outline: &[Vec3]| {
        let mut points = flatten(outline, origin, e, f);
        if area_vector(outline).dot(n) < 0.0 {
            points.reverse();
        }
        points
    };
    let (mut shared, other) = (flat(a), flat(b));
    for k in 0..other.len() {
        shared = left_of(&shared, other[k], other[(k + 1) % other.len()]);
        if shared.len() < 3 {
            return None;
        }
    }
    let sums = Sums::of(&shared);
    if sums.area <= smallest {
        return None;
    }
    let at = |p: Vec2| origin + height * n + p.x * e + p.y * f;
    let (axis, gyration) = sums.principal();
    let along = axis.x * e + axis.y * f;
    Some(Overlap {
        outline: shared.iter().map(|&p| at(p)).collect(),
        area: sums.area,
        centroid: at(sums.centroid),
        frame: [n, along, n.cross(along)],
        gyration,
    })
}

/// The part of a convex outline on the left of the line from `p` to `q`.
fn left_of(outline: &[Vec2], p: Vec2, q: Vec2) -> Vec<Vec2> {
    let along = q - p;
    let side = |r: Vec2| along.perp_dot(r - p);
    let mut kept = Vec::with_capacity(outline.len() + 1);
    for k in 0..outline.len() {
        let (a, b) = (outline[k], outline[(k + 1) % outline.len()]);
        let (s, t) = (side(a), side(b));
        if s >= 0.0 {
            kept.push(a);
        }
        if s * t < 0.0 {
            kept.push(a + (s / (s - t)) * (b - a));
        }
    }
    kept
}

/// Moments of an outline.
struct Sums {
    area: f64,
    centroid: Vec2,
    /// `int x² dA`, `int y² dA`, `int x y dA` about the centroid, m⁴.
    second: [f64; 3],
}

impl Sums {
    fn of(outline: &[Vec2]) -> Self {
        let origin = outline[0];
        let (mut twice, mut first, mut second) = (0.0, Vec2::ZERO, [0.0; 3]);
        for pair in outline[1..].windows(2) {
            let (a, b) = (pair[0] - origin, pair[1] - origin);
            let w = a.perp_dot(b);
            let sum = a + b;
            twice += w;
            first += w * sum;
            // Triangle (0, a, b): int x x^T = A/12 (a a^T + b b^T + (a + b)(a + b)^T).
            second[0] += w * (a.x * a.x + b.x * b.x + sum.x * sum.x);
            second[1] += w * (a.y * a.y + b.y * b.y + sum.y * sum.y);
            second[2] += w * (a.x * a.y + b.x * b.y + sum.x * sum.y);
        }
        let area = 0.5 * twice;
        let centre = first / (3.0 * twice);
        Self {
            area,
            centroid: origin + centre,
            second: [
                second[0] / 24.0 - area * centre.x * centre.x,
                second[1] / 24.0 - area * centre.y * centre.y,
                second[2] / 24.0 - area * centre.x * centre.y,
            ],
        }
    }

    /// First principal axis and the radii of gyration along it and across it; the given axes when all are principal.
    fn principal(&self) -> (Vec2, [f64; 2]) {
        let [xx, yy, xy] = self.second;
        let radius = |moment: f64| (moment.max(0.0) / self.area).sqrt();
        // Below this share the axes are round-off.
        if Vec2::new(0.5 * (xx - yy), xy).length() <= 1e-9 * (xx + yy)
            || xy.abs() <= 1e-12 * (xx + yy)
        {
            return (Vec2::X, [radius(xx), radius(yy)]);
        }
        let angle = 0.5 * libm::atan2(2.0 * xy, xx - yy);
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let along = c * c * xx + 2.0 * s * c * xy + s * s * yy;
        (Vec2::new(c, s), [radius(along), radius(xx + yy - along)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64, z: f64) -> Vec<Vec3> {
        [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Vec3::new(x, y, z)).to_vec()
    }

    #[test]
    fn rectangles_share_a_rectangle() {
        let a = rectangle(0.0, 0.0, 4.0, 2.0, 1.0);
        let mut b = rectangle(1.0, -1.0, 9.0, 1.0, 1.0);
        b.reverse();
        let o = face_overlap(&a, &b, Vec3::Z, 0.0).unwrap();
        assert!((o.area - 3.0).abs() < 1e-14);
        assert!(o.centroid.distance(Vec3::new(2.5, 0.5, 1.0)) < 1e-14);
        assert_eq!(o.frame, [Vec3::Z, Vec3::X, Vec3::Y]);
        // Gauss points of a rectangle: L / (2 sqrt 3).
        assert!((o.gyration[0] - 3.0 / 12f64.sqrt()).abs() < 1e-14);
        assert!((o.gyration[1] - 1.0 / 12f64.sqrt()).abs() < 1e-14);
        assert!(face_overlap(&a, &rectangle(4.0, 0.0, 5.0, 2.0, 1.0), Vec3::Z, 1e-12).is_none());
        assert!(face_overlap(&a, &rectangle(5.0, 0.0, 6.0, 2.0, 1.0), Vec3::Z, 0.0).is_none());
        assert!(face_overlap(&a, &a, Vec3::Z, 0.0).is_some());
    }

    proptest! {
        /// A turned rectangle keeps its area, its radii and the direction of its axes.
        #[test]
        fn moments_turn_with_the_face(
            turn in prop::array::uniform4(-1.0..1.0f64),
            length in 1.0..5.0f64,
            place in prop::array::uniform3(-50.0..50.0f64),
            angle in 0.1..1.4f64,
        ) {
            let q = crate::Quat::from_array(turn);
            prop_assume!(q.length() > 0.1);
            let q = q.normalize();
            let t = Vec3::from_array(place);
            let spin = crate::Quat::from_rotation_z(angle);
            let a: Vec<Vec3> = rectangle(-length, -0.5, length, 0.5, 0.0)
                .iter().map(|&p| t + q * (spin * p)).collect();
            let b: Vec<Vec3> = rectangle(-9.0, -9.0, 9.0, 9.0, 0.0).iter().map(|&p| t + q * p).collect();
            let o = face_overlap(&a, &b, q * Vec3::Z, 0.0).unwrap();
            prop_assert!((o.area - 2.0 * length).abs() < 1e-11);
            prop_assert!(o.centroid.distance(t) < 1e-11);
            prop_assert!((o.gyration[0] - length / 3f64.sqrt()).abs() < 1e-9, "{:?}", o.gyration);
            prop_assert!((o.gyration[1] - 0.5 / 3f64.sqrt()).abs() < 1e-9);
            prop_assert!(o.frame[1].cross(q * (spin * Vec3::X)).length() < 1e-7);
            let handed = o.frame[0].cross(o.frame[1]).dot(o.frame[2]);
            prop_assert!((handed - 1.0).abs() < 1e-12);
        }
    }
}
