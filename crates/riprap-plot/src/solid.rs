//! Solid blocks of a frame: where they were before they moved, and cuts through them.

use riprap_geom::Vec3;
use riprap_record::frame::{Column, Frame};
use std::collections::BTreeMap;

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

    /// A direction of the block before it turned.
    pub(super) fn unturned(&self, direction: Vec3) -> Vec3 {
        turned(direction, -self.rotation)
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
        let all = points.iter().fold(Vec3::ZERO, |s, p| s + Vec3::from(*p) - origin);
        origin + all / points.len() as f64
    }
}

/// Cut of a block of any form by the plane `x[normal] = at`, through the block as it was before it moved: closed lines of corners in
/// unmoved position, those around material anticlockwise about the normal, those around holes clockwise. None: the plane misses the
/// block.
///
/// A plane that runs along faces between blocks cuts those below it, each once.
pub(super) fn cut(frame: &Frame, i: usize, body: &Body, normal: usize, at: f64) -> Vec<Vec<Vec3>> {
    let points: Vec<Vec3> = frame.outline(i).iter().map(|p| body.unmoved(Vec3::from(*p))).collect();
    let heights: Vec<f64> = points.iter().map(|p| p[normal] - at).collect();
    let size = heights.iter().fold(f64::NEG_INFINITY, |s, h| s.max(*h))
        - heights.iter().fold(f64::INFINITY, |s, h| s.min(*h));
    let below = |c: u32| heights[c as usize] < -ON_PLANE * size;
    let mut next = links(frame.solids.iter().flat_map(|s| s.of(i)), below);
    let corner = |(a, b): (u32, u32)| {
        let (ha, hb) = (heights[a as usize], heights[b as usize]);
        let share = (ha / (ha - hb)).clamp(0.0, 1.0);
        points[a as usize].lerp(points[b as usize], share)
    };
    let mut lines = Vec::new();
    while let Some((start, mut edge)) = next.pop_first() {
        let mut line = vec![corner(start)];
        while edge != start {
            line.push(corner(edge));
            match next.remove(&edge) {
                Some(further) => edge = further,
                // The faces of the block do not close; what there is of the line is drawn.
                None => break,
            }
        }
        if line.len() > 2 {
            lines.push(line);
        }
    }
    lines
}

/// Where the cut goes on: from an edge (its lower end, its upper end) that it crosses to the next one, across the face that has the
/// first of them downwards.
///
/// Each edge is in two faces, once in each direction; a face of any form is left where it was entered the last time.
fn links<'a>(
    faces: impl Iterator<Item = &'a [u32]>,
    below: impl Fn(u32) -> bool,
) -> BTreeMap<(u32, u32), (u32, u32)> {
    let mut next = BTreeMap::new();
    for face in faces {
        let edges = || (0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()]));
        // From an edge downwards to the next one upwards, around the face.
        let first = edges().position(|(a, b)| !below(a) && below(b));
        let mut down = None;
        for (a, b) in edges().cycle().skip(first.unwrap_or(0)).take(face.len()) {
            match (below(a), below(b)) {
                (false, true) => down = Some((b, a)),
                (true, false) => {
                    if let Some(from) = down.take() {
                        next.insert(from, (a, b));
                    }
                }
                (false, false) | (true, true) => {}
            }
        }
    }
    next
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_testkit::solid_sample;

    /// Signed about the normal: holes count as less.
    fn area(lines: &[Vec<Vec3>], normal: usize) -> f64 {
        let fan = |line: &Vec<Vec3>| {
            let pairs = line.windows(2).skip(1);
            let twice = pairs.map(|p| (p[0] - line[0]).cross(p[1] - line[0])[normal]);
            0.5 * twice.sum::<f64>()
        };
        lines.iter().map(fan).sum()
    }

    /// A body under heights on a grid of places 1 m apart, with its foot at `foot`.
    fn ground(heights: &[&[f64]], foot: f64) -> Frame {
        let (wide, long) = (heights[0].len(), heights.len());
        let axis = |n: usize| (0..n).map(|k| k as f64).collect::<Vec<_>>();
        let field =
            riprap_geom::height_field::HeightField::grid(&axis(wide), &axis(long), |i, j| {
                Some(heights[j][i])
            });
        let (mut points, faces) = field.unwrap().body();
        let lowest = points.iter().fold(f64::INFINITY, |l, p| l.min(p.z));
        for p in points.iter_mut().filter(|p| p.z == lowest) {
            p.z = foot;
        }
        let mut solids = riprap_record::frame::Solids {
            faces: vec![0, faces.len() as u32],
            ends: vec![0],
            corners: Vec::new(),
        };
        for face in &faces {
            solids.corners.extend(face);
            solids.ends.push(solids.corners.len() as u32);
        }
        Frame {
            offsets: vec![0, points.len() as u32],
            points: points.iter().map(Vec3::to_array).collect(),
            solids: Some(solids),
            ..Frame::default()
        }
    }

    #[test]
    fn a_section_of_a_valley_follows_its_floor() {
        // Two ridges along y with a valley between them: no convex outline.
        let row: &[f64] = &[2.0, 5.0, 1.0, 4.0, 3.0];
        let frame = ground(&[row, row, row], -1.0);
        let body = bodies(&frame)[0];
        let section = cut(&frame, 0, &body, 1, 0.7);
        assert_eq!(section.len(), 1, "one line");
        let trapezoids: f64 = row.windows(2).map(|z| 0.5 * (z[0] + z[1]) + 1.0).sum();
        let found = area(&section, 1);
        assert!((found - trapezoids).abs() < 1e-12, "{found}, {trapezoids}");
        let along: Vec<f64> = section[0].iter().map(|p| p.z).collect();
        for (x, z) in row.iter().enumerate() {
            let there = section[0].iter().any(|p| p.x == x as f64 && (p.z - z).abs() < 1e-12);
            assert!(there, "({x}, {z}) is no corner: {along:?}");
        }
    }

    #[test]
    fn a_plan_of_a_crater_has_a_hole_and_one_of_two_peaks_two_parts() {
        let crater: [&[f64]; 5] = [
            &[0.0; 5],
            &[0.0, 2.0, 2.0, 2.0, 0.0],
            &[0.0, 2.0, 0.0, 2.0, 0.0],
            &[0.0, 2.0, 2.0, 2.0, 0.0],
            &[0.0; 5],
        ];
        let frame = ground(&crater, -1.0);
        let plan = cut(&frame, 0, &bodies(&frame)[0], 2, 1.0);
        let mut areas: Vec<f64> = plan.iter().map(|l| area(std::slice::from_ref(l), 2)).collect();
        areas.sort_by(f64::total_cmp);
        assert_eq!(areas.len(), 2, "{areas:?}");
        assert!(areas[0] < -0.4 && areas[1] > 8.0, "{areas:?}");
        let peaks: [&[f64]; 3] = [&[0.0; 5], &[0.0, 3.0, 0.0, 3.0, 0.0], &[0.0; 5]];
        let frame = ground(&peaks, -1.0);
        let plan = cut(&frame, 0, &bodies(&frame)[0], 2, 1.0);
        assert_eq!(plan.len(), 2);
        let [a, b] = [0, 1].map(|k| area(&plan[k..=k], 2));
        assert!(a > 0.5 && (a - b).abs() < 1e-12, "{a}, {b}");
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
            assert_eq!((brick.len(), brick[0].len()), (1, 4));
            assert!((area(&brick, normal) - 4.0).abs() < 1e-12);
        }
        // At half its height a tetrahedron has a quarter of its base.
        let tip = cut(&frame, 1, &all[1], 2, 0.5);
        assert!(tip[0].len() == 3 && (area(&tip, 2) - 0.125).abs() < 1e-12);
        assert!(cut(&frame, 1, &all[1], 2, 1.5).is_empty());
    }

    #[test]
    fn a_plane_along_faces_cuts_the_lower_block() {
        let frame = solid_sample();
        let all = bodies(&frame);
        assert_eq!(cut(&frame, 0, &all[0], 0, 1.0 + 1e-9)[0].len(), 4);
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
        let (before, after) =
            (cut(&frame, 0, &bodies(&frame)[0], 1, 0.25), cut(&moved, 0, &body, 1, 0.25));
        for (a, b) in before[0].iter().zip(&after[0]) {
            assert!((*a - *b).length() < 1e-12);
            let now = turned(*a, turn) + shift;
            assert!((body.moved(*b, 1.0) - now).length() < 1e-12);
            assert!((body.moved(*b, 0.0) - *a).length() < 1e-12);
        }
    }
}
