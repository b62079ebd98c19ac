//! How good a shape a block has: edges, corners, widths, room inside; the sliver measure.

use std::collections::BinaryHeap;

use serde::{Deserialize, Serialize};

use crate::Vec2;
use crate::polygon::{Aabb, Side, distance_to_boundary, edges, locate, mass_properties};

/// A block that is too thin, or has too short an edge, for its neighbours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SliverReport {
    /// Block number in the list it was found in.
    pub block: usize,
    /// Shortest edge, m.
    pub edge: f64,
    /// Width of the block over the median width of all.
    pub ratio: f64,
    /// Centroid, m.
    pub at: [f64; 2],
}

/// Measures of one outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    /// Shortest edge, m.
    pub shortest_edge: f64,
    /// Longest edge, m.
    pub longest_edge: f64,
    /// Smallest inner angle at a corner, rad.
    pub smallest_angle: f64,
    /// Width, m: twice the area over the diameter. A square of side a gives 1.41 a, a thin strip its
    /// thickness times two at most.
    pub width: f64,
    /// Largest distance between two vertices, or the diagonal of the box beyond 500 vertices, m.
    pub diameter: f64,
}

/// Measures of an outline of either orientation.
pub fn shape(vertices: &[Vec2]) -> Shape {
    let n = vertices.len();
    let lengths = || edges(vertices).map(|(a, b)| a.distance(b));
    let ccw = mass_properties(vertices).area >= 0.0;
    let mut smallest_angle = f64::INFINITY;
    for i in 0..n {
        let to_next = vertices[(i + 1) % n] - vertices[i];
        let to_last = vertices[(i + n - 1) % n] - vertices[i];
        let angle = libm::atan2(to_next.perp_dot(to_last), to_next.dot(to_last));
        let inner = if ccw { angle } else { -angle };
        let inner = if inner < 0.0 { inner + std::f64::consts::TAU } else { inner };
        smallest_angle = f64::min(smallest_angle, inner);
    }
    let mut diameter = 0.0;
    if n <= 500 {
        for i in 0..n {
            for j in i + 1..n {
                diameter = f64::max(diameter, vertices[i].distance(vertices[j]));
            }
        }
    } else {
        diameter = Aabb::of(vertices).size();
    }
    let area = mass_properties(vertices).area.abs();
    Shape {
        shortest_edge: lengths().fold(f64::INFINITY, f64::min),
        longest_edge: lengths().fold(0.0, f64::max),
        smallest_angle,
        width: if diameter > 0.0 { 2.0 * area / diameter } else { 0.0 },
        diameter,
    }
}

/// Pole of inaccessibility of a simple outline: the centre of the largest circle inside, and its
/// radius, to 1 % of the radius or 1e-6 of the size.
///
/// *Source*: best-first search over squares, each bounded by the distance at its centre plus half
/// its diagonal (Agafonkin, polylabel, 2016).
pub fn in_circle(vertices: &[Vec2]) -> (Vec2, f64) {
    let bounds = Aabb::of(vertices);
    let size = bounds.size();
    if vertices.len() < 3 || !(size > 0.0 && size.is_finite()) {
        return (vertices.first().copied().unwrap_or(Vec2::ZERO), 0.0);
    }
    let signed = |p: Vec2| {
        let d = distance_to_boundary(vertices, p);
        if locate(vertices, p) == Side::Inside { d } else { -d }
    };
    let start = mass_properties(vertices).centroid;
    let mut best = (start, signed(start));
    let half = 0.5 * (bounds.max - bounds.min).max_element();
    let first = Square { centre: bounds.centre(), half, bound: f64::INFINITY };
    let mut queue = BinaryHeap::from([first]);
    // The cap is far above what shapes of blocks need; it ends the search for pathological ones.
    for _ in 0..20_000 {
        let Some(square) = queue.pop() else { break };
        if square.bound - best.1 <= (0.01 * best.1).max(1e-6 * size) {
            break;
        }
        for quarter in [(-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5)] {
            let centre = square.centre + square.half * Vec2::from(quarter);
            let distance = signed(centre);
            if distance > best.1 {
                best = (centre, distance);
            }
            let half = 0.5 * square.half;
            let bound = distance + half * std::f64::consts::SQRT_2;
            if bound > best.1 {
                queue.push(Square { centre, half, bound });
            }
        }
    }
    (best.0, best.1.max(0.0))
}

/// A square still to be looked at; ordered by what it can offer at best.
struct Square {
    centre: Vec2,
    half: f64,
    bound: f64,
}

impl PartialEq for Square {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Square {}
impl PartialOrd for Square {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Square {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

/// Blocks whose width is below `ratio` times the median width, or whose shortest edge is below
/// `ratio` times the median width; smallest ratio first.
pub fn slivers(blocks: &[Vec<Vec2>], ratio: f64) -> Vec<SliverReport> {
    let shapes: Vec<Shape> = blocks.iter().map(|b| shape(b)).collect();
    let mut widths: Vec<f64> = shapes.iter().map(|s| s.width).collect();
    widths.sort_by(f64::total_cmp);
    let Some(&median) = widths.get(widths.len() / 2) else {
        return Vec::new();
    };
    let mut found: Vec<SliverReport> = shapes
        .iter()
        .enumerate()
        .filter(|(_, s)| s.width.min(s.shortest_edge) < ratio * median)
        .map(|(block, s)| SliverReport {
            block,
            edge: s.shortest_edge,
            ratio: s.width.min(s.shortest_edge) / median,
            at: mass_properties(&blocks[block]).centroid.into(),
        })
        .collect();
    found.sort_by(|a, b| a.ratio.total_cmp(&b.ratio).then(a.block.cmp(&b.block)));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_a_rectangle() {
        let r = crate::shapes::rectangle(Vec2::ZERO, Vec2::new(4.0, 1.0));
        let s = shape(&r);
        assert_eq!((s.shortest_edge, s.longest_edge), (1.0, 4.0));
        assert!((s.smallest_angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert!((in_circle(&r).1 - 0.5).abs() < 0.006);
    }

    #[test]
    fn pole_of_an_l_is_in_its_corner() {
        let l: Vec<Vec2> =
            [(0., 0.), (9., 0.), (9., 1.), (1., 1.), (1., 9.), (0., 9.)].map(Vec2::from).to_vec();
        // Circle touching x = 0, y = 0 and the inner corner (1, 1): r (1 + 1/sqrt 2) sqrt 2 = sqrt 2.
        let (_, radius) = in_circle(&l);
        assert!((radius - (2.0 - 2.0f64.sqrt())).abs() < 0.01, "{radius}");
        assert_eq!(in_circle(&[]).1, 0.0);
        assert_eq!(in_circle(&[Vec2::NAN; 3]).1, 0.0);
    }

    #[test]
    fn finds_the_sliver() {
        let size = |w: f64, h: f64| crate::shapes::rectangle(Vec2::ZERO, Vec2::new(w, h));
        let blocks = vec![size(1.0, 1.0), size(1.0, 0.01), size(1.1, 1.0)];
        let found = slivers(&blocks, 0.05);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].block, found[0].edge), (1, 0.01));
        assert!(slivers(&[], 0.1).is_empty());
    }
}
