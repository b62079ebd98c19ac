//! Points that join two faces of deformable blocks whose nodes need not match.
//!
//! A face is a fan of triangles (centre, a, b) with linear fields. [`overlay`] cuts every triangle of one face by
//! every triangle of the other: on each piece both fields are linear, so three points at the corners of a triangle
//! integrate a uniform traction exactly, and a patch test passes to round-off. Faces whose fans match give one point
//! per node pair with the tributary areas.
//!
//! [`node_to_face`] is what Han, Liu & Li (2010) do, equations (21) and (22): it conserves momentum, but not the
//! force of a uniform traction where faces overlap in part.

use crate::polyhedron::{Tetrahedra, area_vector, flatten, frame};
use crate::{Vec2, Vec3};

/// Triangles with less than this share of the smaller face's area are dropped from an overlay.
const SLIVER: f64 = 1e-10;
/// Points nearer than this, times the size of the faces, are one point.
const SAME: f64 = 1e-9;
/// Weights below this are round-off.
const NO_WEIGHT: f64 = 1e-12;

/// A face as a fan of triangles (centre, corner k, corner k + 1).
#[derive(Clone, Debug, PartialEq)]
pub struct Fan {
    /// Nodes: the centre, then the corners, anticlockwise seen from outside the block.
    pub nodes: Vec<u32>,
    /// Where they are, m. *Shape* `[n_nodes]`.
    pub at: Vec<Vec3>,
}

/// A point of a face: a mean of up to three nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Nodes; those past `count` repeat the first.
    pub nodes: [u32; 3],
    /// Weights, which add up to 1; 0 past `count`.
    pub weights: [f64; 3],
    /// Number of nodes with a weight, 1 to 3.
    pub count: u8,
}

/// A spring between two faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointPoint {
    /// Where it is on the first face, m.
    pub at: Vec3,
    /// Area it stands for, m².
    pub area: f64,
    /// Its place on both faces.
    pub sides: [Anchor; 2],
}

impl Tetrahedra {
    /// The fan of a face.
    #[must_use]
    pub fn face_fan(&self, face: usize) -> Fan {
        let mut nodes: Vec<u32> = self.fan(face).take(1).map(|[m, _, _]| m).collect();
        nodes.extend(self.fan(face).map(|[_, a, _]| a));
        let at = nodes.iter().map(|&k| self.nodes[k as usize]).collect();
        Fan { nodes, at }
    }
}

impl Fan {
    fn corners(&self) -> usize {
        self.nodes.len().saturating_sub(1)
    }

    /// Places of the nodes of triangle `k` in the lists.
    fn triangle(&self, k: usize) -> [usize; 3] {
        [0, k + 1, (k + 1) % self.corners() + 1]
    }

    /// Normal times area, m².
    #[must_use]
    pub fn area_vector(&self) -> Vec3 {
        area_vector(self.at.get(1..).unwrap_or_default())
    }

    /// Sum of the areas of the triangles, m².
    #[must_use]
    pub fn area(&self) -> f64 {
        (0..self.corners()).map(|k| self.triangle_area(k)).sum()
    }

    fn triangle_area(&self, k: usize) -> f64 {
        let [m, a, b] = self.triangle(k).map(|n| self.at[n]);
        0.5 * (a - m).cross(b - m).length()
    }

    /// Triangles in a plane with the normal `n`, anticlockwise, from the places of the nodes there.
    fn flat(&self, n: Vec3, places: &[Vec2]) -> Vec<Flat> {
        let turned = self.area_vector().dot(n) < 0.0;
        (0..self.corners())
            .map(|k| {
                let [m, a, b] = self.triangle(k);
                let nodes = if turned { [m, b, a] } else { [m, a, b] };
                let at = nodes.map(|k| places[k]);
                let low = at[0].min(at[1]).min(at[2]);
                let high = at[0].max(at[1]).max(at[2]);
                Flat { nodes, at, low, high }
            })
            // Weights divide by it.
            .filter(|triangle| triangle.twice() > 0.0)
            .collect()
    }
}

/// A triangle of a fan in its plane.
struct Flat {
    nodes: [usize; 3],
    at: [Vec2; 3],
    low: Vec2,
    high: Vec2,
}

impl Flat {
    /// Twice the area, m².
    fn twice(&self) -> f64 {
        let [a, b, c] = self.at;
        (b - a).perp_dot(c - a)
    }

    /// Weights of the corners at a point.
    fn weights(&self, p: Vec2) -> [f64; 3] {
        let [a, b, c] = self.at;
        let whole = self.twice();
        let wb = (p - a).perp_dot(c - a) / whole;
        let wc = (b - a).perp_dot(p - a) / whole;
        [1.0 - wb - wc, wb, wc]
    }

    fn anchor(&self, fan: &Fan, p: Vec2) -> Anchor {
        let weights = self.weights(p);
        let (mut nodes, mut kept, mut count) = ([0; 3], [0.0; 3], 0);
        for (place, weight) in self.nodes.into_iter().zip(weights) {
            if weight.abs() > NO_WEIGHT {
                (nodes[count], kept[count]) = (fan.nodes[place], weight);
                count += 1;
            }
        }
        let sum = kept[0] + kept[1] + kept[2];
        for k in 0..3 {
            if k < count {
                // What was dropped must not be missing: a shift of the whole face would stretch the spring.
                kept[k] /= sum;
            } else {
                nodes[k] = nodes[0];
            }
        }
        Anchor { nodes, weights: kept, count: count as u8 }
    }
}

/// Points that join two faces lying in one plane: the first face's normal is about `normal`, the second's the opposite.
/// None when the faces share at most `smallest` (m²), such as an edge.
///
/// The areas add up to the shared area; with equal fans there is one point per node.
#[must_use]
pub fn overlay(a: &Fan, b: &Fan, normal: Vec3, smallest: f64) -> Vec<JointPoint> {
    let (Some(&origin), true) = (a.at.first(), b.corners() >= 3) else {
        return Vec::new();
    };
    let axes = frame(normal);
    let places = [a, b].map(|fan| flatten(&fan.at, origin, axes[1], axes[2]));
    let boxes = places.each_ref().map(|p| bounds(p));
    // Equal bounds count: faces that meet along a line have no area in common.
    if boxes[0].0.cmpge(boxes[1].1).any() || boxes[1].0.cmpge(boxes[0].1).any() {
        return Vec::new();
    }
    let (flat_a, flat_b) = (a.flat(normal, &places[0]), b.flat(normal, &places[1]));
    let sliver = SLIVER * a.area().min(b.area());
    let mut points = Points::new(a);
    for ta in &flat_a {
        for tb in &flat_b {
            if apart(ta, tb) {
                continue;
            }
            let mut piece = Piece::new(&ta.at);
            for k in 0..3 {
                piece.keep_left(tb.at[k], tb.at[(k + 1) % 3]);
            }
            let (area, shares) = piece.shares();
            if area <= sliver {
                continue;
            }
            for (&at, share) in piece.at[..piece.count].iter().zip(shares) {
                points.add(at, share, || [ta.anchor(a, at), tb.anchor(b, at)]);
            }
        }
    }
    let total: f64 = points.list.iter().map(|(_, p)| p.area).sum();
    if total <= smallest {
        return Vec::new();
    }
    points.finish(origin, axes)
}

/// Points that join two faces by interpolation at the nodes of the smaller one, with its tributary areas.
///
/// Source: Han, Liu & Li (2010), equations (21) and (22). For comparison: where faces overlap in part, area is lost.
#[must_use]
pub fn node_to_face(a: &Fan, b: &Fan, normal: Vec3, smallest: f64) -> Vec<JointPoint> {
    let total: f64 = overlay(a, b, normal, smallest).iter().map(|p| p.area).sum();
    if total <= smallest {
        return Vec::new();
    }
    let swapped = a.area() > b.area();
    let (slave, master) = if swapped { (b, a) } else { (a, b) };
    let (origin, axes) = (slave.at[0], frame(normal));
    let triangles = master.flat(normal, &flatten(&master.at, origin, axes[1], axes[2]));
    let mut areas = vec![0.0; slave.nodes.len()];
    for k in 0..slave.corners() {
        for node in slave.triangle(k) {
            areas[node] += slave.triangle_area(k) / 3.0;
        }
    }
    let mut points = Vec::new();
    for (k, &at) in slave.at.iter().enumerate() {
        let r = at - origin;
        let p = Vec2::new(r.dot(axes[1]), r.dot(axes[2]));
        let inside = triangles.iter().find(|t| {
            let low = t.weights(p).into_iter().fold(f64::INFINITY, f64::min);
            low >= -SAME
        });
        if let Some(triangle) = inside {
            let own = Anchor { nodes: [slave.nodes[k]; 3], weights: [1.0, 0.0, 0.0], count: 1 };
            let other = triangle.anchor(master, p);
            points.push(JointPoint {
                at,
                area: areas[k],
                sides: if swapped { [other, own] } else { [own, other] },
            });
        }
    }
    points
}

/// Lowest and highest corner of the box around places.
fn bounds(places: &[Vec2]) -> (Vec2, Vec2) {
    places
        .iter()
        .fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)))
}

fn apart(a: &Flat, b: &Flat) -> bool {
    a.low.cmpge(b.high).any() || b.low.cmpge(a.high).any()
}

/// What is left of a triangle that is cut by three lines: at most six corners.
struct Piece {
    at: [Vec2; 8],
    count: usize,
}

impl Piece {
    fn new(triangle: &[Vec2; 3]) -> Self {
        let mut at = [Vec2::ZERO; 8];
        at[..3].copy_from_slice(triangle);
        Self { at, count: 3 }
    }

    fn keep_left(&mut self, p: Vec2, q: Vec2) {
        let along = q - p;
        let count = self.count;
        let mut sides = [0.0; 8];
        let (mut all, mut none) = (true, true);
        for (side, at) in sides.iter_mut().zip(&self.at[..count]) {
            *side = along.perp_dot(*at - p);
            all &= *side >= 0.0;
            none &= *side <= 0.0;
        }
        if all {
            return;
        }
        let old = self.at;
        self.count = 0;
        if none {
            return;
        }
        for k in 0..count {
            let next = if k + 1 < count { k + 1 } else { 0 };
            let (s, t) = (sides[k], sides[next]);
            if s >= 0.0 {
                self.push(old[k]);
            }
            if s * t < 0.0 {
                self.push(old[k] + (s / (s - t)) * (old[next] - old[k]));
            }
        }
    }

    fn push(&mut self, p: Vec2) {
        // Round-off cannot make a convex piece cross a line more than twice, but a NaN could.
        if self.count < self.at.len() {
            self.at[self.count] = p;
            self.count += 1;
        }
    }

    /// Area of the piece and what each corner gets of it: a third of each triangle from the first corner.
    fn shares(&self) -> (f64, [f64; 8]) {
        let (mut area, mut shares) = (0.0, [0.0; 8]);
        for k in 2..self.count {
            let (p, q) = (self.at[k - 1] - self.at[0], self.at[k] - self.at[0]);
            let third = p.perp_dot(q) / 6.0;
            area += 3.0 * third;
            shares[0] += third;
            shares[k - 1] += third;
            shares[k] += third;
        }
        (area, shares)
    }
}

/// Points found so far; coincident ones are one.
struct Points {
    list: Vec<(Vec2, JointPoint)>,
    same: f64,
}

impl Points {
    fn new(fan: &Fan) -> Self {
        let reach = fan.at.iter().map(|p| p.distance(fan.at[0]));
        Self { list: Vec::new(), same: SAME * reach.fold(0.0, f64::max) }
    }

    fn add(&mut self, at: Vec2, area: f64, sides: impl FnOnce() -> [Anchor; 2]) {
        let near = |(p, _): &&mut (Vec2, JointPoint)| {
            (p.x - at.x).abs() <= self.same && (p.y - at.y).abs() <= self.same
        };
        match self.list.iter_mut().find(near) {
            // Fields are continuous: the same place has the same weights, in whichever triangle it was found.
            Some((_, point)) => point.area += area,
            None => self.list.push((at, JointPoint { at: Vec3::ZERO, area, sides: sides() })),
        }
    }

    fn finish(self, origin: Vec3, [_, e, f]: [Vec3; 3]) -> Vec<JointPoint> {
        let place =
            |(p, point): (Vec2, JointPoint)| JointPoint { at: origin + p.x * e + p.y * f, ..point };
        self.list.into_iter().filter(|(_, point)| point.area > 0.0).map(place).collect()
    }
}

#[cfg(test)]
mod tests;
