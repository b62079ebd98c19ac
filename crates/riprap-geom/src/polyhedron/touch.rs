//! Whether a convex solid has a point in common with a point, a segment, a plane, a ball or another convex solid.

use super::Polyhedron;
use crate::Vec3;

/// Directions that are nearer to parallel than this have no cross product to speak of.
const PARALLEL: f64 = 1e-9;

impl Polyhedron {
    /// Distance of a point from the solid, 0 inside, m.
    #[must_use]
    pub fn distance(&self, point: Vec3) -> f64 {
        let mut nearest = f64::INFINITY;
        let mut outside = false;
        for face in 0..self.faces.len() {
            let (normal, offset) = self.plane(face);
            let height = normal.dot(point) - offset;
            if height > 0.0 {
                outside = true;
                nearest = nearest.min(from_polygon(&self.outline(face), normal, height, point));
            }
        }
        if outside { nearest } else { 0.0 }
    }

    /// Whether a segment comes within `slack` (m) of all faces on their inner side.
    #[must_use]
    pub fn meets_segment(&self, from: Vec3, to: Vec3, slack: f64) -> bool {
        self.part_of_segment(from, to, slack).is_some()
    }

    /// The part of a segment that lies within `slack` (m) of all faces on their inner side, as shares of its length.
    #[must_use]
    pub fn part_of_segment(&self, from: Vec3, to: Vec3, slack: f64) -> Option<[f64; 2]> {
        let along = to - from;
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for face in 0..self.faces.len() {
            let (normal, offset) = self.plane(face);
            let (height, rate) = (normal.dot(from) - offset - slack, normal.dot(along));
            if rate > 0.0 {
                leave = leave.min(-height / rate);
            } else if rate < 0.0 {
                enter = enter.max(-height / rate);
            } else if height > 0.0 {
                return None;
            }
        }
        (enter <= leave).then_some([enter, leave])
    }

    /// Whether a plane through a point comes within `slack` (m) of the solid.
    #[must_use]
    pub fn meets_plane(&self, through: Vec3, normal: Vec3, slack: f64) -> bool {
        let [low, high] = self.reach(normal);
        let height = normal.dot(through);
        low - slack <= height && height <= high + slack
    }

    /// Whether two convex solids are nowhere farther apart than `slack` (m) along a normal of a face or across two edges.
    #[must_use]
    pub fn meets(&self, other: &Self, slack: f64) -> bool {
        let apart = |axis: Vec3| {
            let ([a, b], [c, d]) = (self.reach(axis), other.reach(axis));
            c - b > slack || a - d > slack
        };
        let normals = |solid: &Self| -> Vec<Vec3> {
            (0..solid.faces.len()).map(|f| solid.plane(f).0).collect()
        };
        if normals(self).into_iter().chain(normals(other)).any(apart) {
            return false;
        }
        let (own, others) = (self.directions(), other.directions());
        !own.iter()
            .flat_map(|a| others.iter().map(move |b| a.cross(*b)))
            .filter(|cross| cross.length() > PARALLEL)
            .any(|cross| apart(cross.normalize()))
    }

    /// Lowest and highest corner along a direction, m.
    #[must_use]
    pub fn reach(&self, along: Vec3) -> [f64; 2] {
        let heights = self.vertices.iter().map(|v| along.dot(*v));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)])
    }

    /// Unit directions of the edges, parallel ones once.
    #[must_use]
    pub fn directions(&self) -> Vec<Vec3> {
        let mut found: Vec<Vec3> = Vec::new();
        for face in &self.faces {
            for (k, &from) in face.iter().enumerate() {
                let to = face[(k + 1) % face.len()];
                // Every edge is in two faces, once each way.
                if from < to {
                    let edge = self.vertices[to as usize] - self.vertices[from as usize];
                    let along = edge.normalize_or_zero();
                    if !found.iter().any(|f| f.cross(along).length() <= PARALLEL) {
                        found.push(along);
                    }
                }
            }
        }
        found
    }
}

/// Distance of a point from a convex polygon, `height` (m) above its plane.
fn from_polygon(outline: &[Vec3], normal: Vec3, height: f64, point: Vec3) -> f64 {
    let mut nearest = f64::INFINITY;
    let mut above = true;
    for (k, &from) in outline.iter().enumerate() {
        let edge = outline[(k + 1) % outline.len()] - from;
        let arm = point - from;
        above &= normal.dot(edge.cross(arm)) >= 0.0;
        let share = (edge.dot(arm) / edge.length_squared()).clamp(0.0, 1.0);
        nearest = nearest.min((arm - share * edge).length());
    }
    if above { height } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mat3;

    fn v(x: f64, y: f64, z: f64) -> Vec3 {
        Vec3::new(x, y, z)
    }

    /// A brick of 2 x 4 x 6 m about the origin, turned.
    fn turned() -> (Polyhedron, Mat3) {
        let turn = Mat3::from_axis_angle(v(0.6, 0.0, 0.8), 0.7);
        let mut solid = Polyhedron::brick(Vec3::ZERO, v(1.0, 2.0, 3.0));
        solid.vertices.iter_mut().for_each(|p| *p = turn * *p);
        (solid, turn)
    }

    #[test]
    fn distances_to_faces_edges_and_corners() {
        let (solid, turn) = turned();
        for (point, distance) in [
            (v(0.3, -1.0, 2.9), 0.0),
            (v(1.5, 0.1, 0.2), 0.5),
            (v(1.3, 2.4, 0.2), 0.5),
            (v(2.0, 4.0, 5.0), 3.0),
            (v(-2.0, -4.0, -5.0), 3.0),
        ] {
            let found = solid.distance(turn * point);
            assert!((found - distance).abs() < 1e-14, "{point}: {found}");
        }
    }

    #[test]
    fn segments_planes_and_solids() {
        let (solid, turn) = turned();
        let line = |from: Vec3, to: Vec3| solid.meets_segment(turn * from, turn * to, 1e-9);
        assert!(line(v(1.0, -9.0, 3.0), v(1.0, 9.0, 3.0)));
        assert!(line(v(-5.0, 0.5, 0.5), v(2.0, 0.6, 0.5)));
        assert!(!line(v(1.5, -9.0, 3.0), v(1.5, 9.0, 3.0)));
        assert!(!line(v(2.0, 0.0, 0.0), v(3.0, 0.0, 0.0)));
        let plane = |at: Vec3, n: Vec3| solid.meets_plane(turn * at, turn * n, 1e-9);
        assert!(plane(v(7.0, 8.0, 3.0), Vec3::Z));
        assert!(!plane(v(7.0, 8.0, 3.1), Vec3::Z));
        let other = |centre: Vec3, half: Vec3| {
            let mut other = Polyhedron::brick(centre, half);
            other.vertices.iter_mut().for_each(|p| *p = turn * *p);
            solid.meets(&other, 1e-9)
        };
        assert!(other(v(2.0, 3.0, 4.0), Vec3::ONE));
        assert!(!other(v(2.0, 3.0, 4.1), Vec3::ONE));
        // A cube on its edge, across an edge of the brick: only the cross product of the two parts them.
        let across = v(1.0, 0.0, 1.0).normalize();
        let (first, second) = ((across + Vec3::Y).normalize(), (across - Vec3::Y).normalize());
        let stand = Mat3::from_cols(v(1.0, 0.0, -1.0).normalize(), first, second);
        for (gap, touching) in [(-0.05, true), (0.02, false)] {
            let centre = v(1.0, 0.0, 3.0) + (2f64.sqrt() + gap) * across;
            let mut cube = Polyhedron::brick(Vec3::ZERO, Vec3::ONE);
            let place = |p: &mut Vec3| *p = turn * (stand * *p + centre);
            cube.vertices.iter_mut().for_each(place);
            assert_eq!(solid.meets(&cube, 1e-9), touching, "{gap}");
        }
    }
}
