//! Solid blocks of a frame: where they were before they moved, and cuts through them.

use riprap_geom::Vec3;
use riprap_record::frame::{Column, Frame};

/// Corners nearer to the cutting plane than this share of the block's size count as lying on it.
const ON_PLANE: f64 = 1e-4;

/// Where a block is and how it came there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body {
    /// Centroid now, m.
    pub(super) now: Vec3,
    /// Displacement of the centroid, m; zero if the frame does not tell.
    pub(super) displacement: Vec3,
    /// Rotation vector, rad; zero if the frame does not tell.
    pub(super) rotation: Vec3,
}

impl Body {
    /// Centroid before it moved, m.
    pub(super) fn start(&self) -> Vec3 {
        self.now - self.displacement
    }

    /// Where a point of the block was before it moved.
    pub(super) fn unmoved(&self, p: Vec3) -> Vec3 {
        self.start() + turned(p - self.now, -self.rotation)
    }

    /// Where a point goes when displacement and rotation are multiplied by `factor`.
    pub(super) fn moved(&self, reference: Vec3, factor: f64) -> Vec3 {
        let arm = turned(reference - self.start(), factor * self.rotation);
        self.start() + factor * self.displacement + arm
    }
}

/// Rodrigues' formula.
fn turned(v: Vec3, rotation: Vec3) -> Vec3 {
    let angle = rotation.length();
    if angle == 0.0 {
        return v;
    }
    let k = rotation / angle;
    let (sin, cos) = libm::sincos(angle);
    v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
}

fn vector(column: Option<&Column>, i: usize) -> Vec3 {
    match column {
        Some(c) if c.components == 3 => Vec3::from_slice(&c.data[3 * i..3 * i + 3]),
        // In the plane a rotation is one number, about z.
        Some(c) if c.components == 1 => Vec3::new(0.0, 0.0, c.data[i]),
        Some(c) => Vec3::new(c.data[2 * i], c.data[2 * i + 1], 0.0),
        None => Vec3::ZERO,
    }
}

/// All blocks of a frame in space.
pub(super) fn bodies(frame: &Frame) -> Vec<Body> {
    let (u, r) = (frame.column("displacement"), frame.column("rotation"));
    (0..frame.blocks())
        .map(|i| Body {
            now: centroid(frame, i),
            displacement: vector(u, i),
            rotation: vector(r, i),
        })
        .collect()
}

/// Centroid of a block, by tetrahedra over its faces.
fn centroid(frame: &Frame, i: usize) -> Vec3 {
    let points = frame.outline(i);
    let Some(first) = points.first() else {
        return Vec3::NAN;
    };
    let origin = Vec3::from(*first);
    let at = |c: u32| Vec3::from(points[c as usize]) - origin;
    let (mut volume, mut sum) = (0.0, Vec3::ZERO);
    for face in frame.solids.iter().flat_map(|s| s.of(i)) {
        for pair in face.windows(2).skip(1) {
            let (a, b, c) = (at(face[0]), at(pair[0]), at(pair[1]));
            let six = a.dot(b.cross(c));
            volume += six;
            sum += six * 0.25 * (a + b + c);
        }
    }
    if volume > 0.0 {
        origin + sum / volume
    } else {
        let all = points
            .iter()
            .fold(Vec3::ZERO, |s, p| s + Vec3::from(*p) - origin);
        origin + all / points.len() as f64
    }
}

/// Cut of a convex block by the plane `x[normal] = at`, through the block as it was before it moved: corners in unmoved
/// position, anticlockwise about the normal. Fewer than three: the plane misses the block.
///
/// A plane that runs along faces between blocks cuts those below it, each once.
pub(super) fn cut(frame: &Frame, i: usize, body: &Body, normal: usize, at: f64) -> Vec<Vec3> {
    let points: Vec<Vec3> = frame
        .outline(i)
        .iter()
        .map(|p| body.unmoved(Vec3::from(*p)))
        .collect();
    let heights: Vec<f64> = points.iter().map(|p| p[normal] - at).collect();
    let size = heights.iter().fold(f64::NEG_INFINITY, |s, h| s.max(*h))
        - heights.iter().fold(f64::INFINITY, |s, h| s.min(*h));
    let below = |c: u32| heights[c as usize] < -ON_PLANE * size;
    let mut corners: Vec<Vec3> = Vec::new();
    for face in frame.solids.iter().flat_map(|s| s.of(i)) {
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            // Each edge is in two faces, once in each direction.
            if below(a) && !below(b) {
                let (ha, hb) = (heights[a as usize], heights[b as usize]);
                let share = (ha / (ha - hb)).clamp(0.0, 1.0);
                corners.push(points[a as usize].lerp(points[b as usize], share));
            }
        }
    }
    let middle = corners.iter().fold(Vec3::ZERO, |s, p| s + *p) / corners.len().max(1) as f64;
    let (h, v) = ((normal + 1) % 3, (normal + 2) % 3);
    let angle = |p: &Vec3| libm::atan2(p[v] - middle[v], p[h] - middle[h]);
    corners.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    corners
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_testkit::solid_sample;

    fn area(corners: &[Vec3]) -> f64 {
        let fan = corners.windows(2).skip(1);
        fan.map(|p| 0.5 * (p[0] - corners[0]).cross(p[1] - corners[0]).length())
            .sum()
    }

    #[test]
    fn centroids() {
        let frame = solid_sample();
        let all = bodies(&frame);
        assert!(all[0].now.length() < 1e-14);
        assert!((all[1].now - Vec3::new(1.25, 0.25, 0.25)).length() < 1e-14);
    }

    #[test]
    fn a_cut_has_the_area_of_the_block() {
        let frame = solid_sample();
        let all = bodies(&frame);
        for normal in 0..3 {
            let brick = cut(&frame, 0, &all[0], normal, 0.3);
            assert_eq!(brick.len(), 4);
            assert!((area(&brick) - 4.0).abs() < 1e-12);
        }
        // At half its height a tetrahedron has a quarter of its base.
        let tip = cut(&frame, 1, &all[1], 2, 0.5);
        assert!(tip.len() == 3 && (area(&tip) - 0.125).abs() < 1e-12);
        assert!(cut(&frame, 1, &all[1], 2, 1.5).is_empty());
    }

    #[test]
    fn a_plane_along_faces_cuts_the_lower_block() {
        let frame = solid_sample();
        let all = bodies(&frame);
        assert_eq!(cut(&frame, 0, &all[0], 0, 1.0 + 1e-9).len(), 4);
        assert!(cut(&frame, 1, &all[1], 0, 1.0 + 1e-9).is_empty());
    }

    #[test]
    fn a_moved_block_is_cut_where_it_was() {
        let frame = solid_sample();
        let mut body = bodies(&frame)[0];
        let (shift, turn) = (Vec3::new(0.4, -0.2, 3.0), Vec3::new(0.1, 0.3, -0.2));
        let mut moved = frame.clone();
        for p in &mut moved.points[..8] {
            *p = (turned(Vec3::from(*p), turn) + shift).to_array();
        }
        (body.now, body.displacement, body.rotation) = (shift, shift, turn);
        let (before, after) = (
            cut(&frame, 0, &bodies(&frame)[0], 1, 0.25),
            cut(&moved, 0, &body, 1, 0.25),
        );
        for (a, b) in before.iter().zip(&after) {
            assert!((*a - *b).length() < 1e-12);
            let now = turned(*a, turn) + shift;
            assert!((body.moved(*b, 1.0) - now).length() < 1e-12);
            assert!((body.moved(*b, 0.0) - *a).length() < 1e-12);
        }
    }
}
