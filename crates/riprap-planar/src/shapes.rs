//! Body geometry: what never changes while a block moves.
//!
//! Corners are stored relative to the centroid in the body frame. Edge `k` runs from corner `k` to
//! corner `k + 1`. The frame of a block is turned by its angle; numbers that do not depend on the
//! turn (edge length, distance of the edge line from the centroid) are stored once.

use riprap_geom::Vec2;

use super::setup::{BlockSpec, Setup};

/// Constants of one edge, in the body frame of its block.
#[derive(Clone, Copy, Debug, Default)]
pub struct Edge {
    /// Start corner, m.
    pub start: Vec2,
    /// Outward unit normal.
    pub normal: Vec2,
    /// Length, m.
    pub length: f64,
    /// Whether the start corner is reflex (interior angle above 180 degrees).
    pub reflex: bool,
}

/// Geometry and mass of all blocks.
#[derive(Clone, Debug, Default)]
pub struct Shapes {
    /// Edges of block `b` are `edges[first[b]..first[b + 1]]`.
    pub first: Vec<u32>,
    /// Edges of all blocks, anticlockwise per block.
    pub edges: Vec<Edge>,
    /// Whether the block is convex.
    pub convex: Vec<bool>,
    /// Largest distance of a corner from the centroid, m.
    pub radius: Vec<f64>,
    /// A lower bound of the largest inscribed circle's radius, m.
    pub inradius: Vec<f64>,
    /// Mass per metre, kg/m.
    pub mass: Vec<f64>,
    /// Moment of inertia about the centroid per metre, kg m.
    pub inertia: Vec<f64>,
    /// Initial centroid, m.
    pub centroid: Vec<Vec2>,
}

impl Shapes {
    /// Computes the geometry of all blocks.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        let mut shapes = Self { first: vec![0], ..Self::default() };
        for block in &setup.blocks {
            shapes.push(block);
        }
        for (b, inertia) in &setup.inertias {
            shapes.inertia[*b as usize] = *inertia;
        }
        shapes
    }

    /// Appends the geometry of a block.
    pub(crate) fn push(&mut self, block: &BlockSpec) {
        // About a corner of its own: far from the origin areas would
        // be small differences of large products.
        let base = block.vertices.first().copied().unwrap_or(Vec2::ZERO);
        let local: Vec<Vec2> = block.vertices.iter().map(|v| *v - base).collect();
        let (area, centroid, second) = area_moments(&local);
        let n = local.len();
        let corners: Vec<Vec2> = local.iter().map(|v| *v - centroid).collect();
        let turn = |k: usize| {
            let before = corners[k] - corners[(k + n - 1) % n];
            let after = corners[(k + 1) % n] - corners[k];
            before.perp_dot(after)
        };
        for k in 0..n {
            let d = corners[(k + 1) % n] - corners[k];
            let length = d.length();
            let normal = Vec2::new(d.y, -d.x) / length;
            self.edges.push(Edge { start: corners[k], normal, length, reflex: turn(k) < 0.0 });
        }
        self.first.push(self.edges.len() as u32);
        // A corner on a straight side turns to either side by round-off.
        let convex = (0..n).all(|k| turn(k) >= -1e-12 * area);
        self.convex.push(convex);
        self.radius.push(corners.iter().map(|c| c.length()).fold(0.0, f64::max));
        self.inradius.push(inradius(&corners, convex));
        self.mass.push(block.density * area);
        self.inertia.push(block.density * second);
        self.centroid.push(centroid + base);
    }

    /// Number of blocks.
    #[must_use]
    pub fn len(&self) -> usize {
        self.mass.len()
    }

    /// Whether there is no block.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.mass.is_empty()
    }

    /// Index range of the edges of block `b`.
    #[must_use]
    pub fn range(&self, b: usize) -> std::ops::Range<usize> {
        self.first[b] as usize..self.first[b + 1] as usize
    }

    /// Edges of block `b`, body frame.
    #[must_use]
    pub fn of(&self, b: usize) -> &[Edge] {
        &self.edges[self.range(b)]
    }
}

/// Area, centroid and polar second moment about the centroid of an anticlockwise polygon.
fn area_moments(p: &[Vec2]) -> (f64, Vec2, f64) {
    let (mut twice, mut first, mut second) = (0.0, Vec2::ZERO, 0.0);
    for k in 0..p.len() {
        let (a, b) = (p[k], p[(k + 1) % p.len()]);
        let cross = a.perp_dot(b);
        twice += cross;
        first += cross * (a + b);
        second += cross * (a.dot(a) + a.dot(b) + b.dot(b));
    }
    let area = 0.5 * twice;
    let centroid = first / (3.0 * twice);
    (area, centroid, second / 12.0 - area * centroid.dot(centroid))
}

/// Radius of a circle that surely fits inside: at the centroid for convex blocks, else the best of
/// the centroid and points just inside each edge's middle.
fn inradius(corners: &[Vec2], convex: bool) -> f64 {
    let n = corners.len();
    let distance = |x: Vec2| {
        (0..n)
            .map(|k| {
                let (a, d) = (corners[k], corners[(k + 1) % n] - corners[k]);
                let t = ((x - a).dot(d) / d.dot(d)).clamp(0.0, 1.0);
                (x - a - t * d).length()
            })
            .fold(f64::INFINITY, f64::min)
    };
    let inside = |x: Vec2| {
        let mut odd = false;
        for k in 0..n {
            let (a, b) = (corners[k], corners[(k + 1) % n]);
            if (a.y > x.y) != (b.y > x.y) && x.x < a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x) {
                odd = !odd;
            }
        }
        odd
    };
    if convex {
        // The centroid of a convex block is inside, and a lower bound is all that is asked.
        return distance(Vec2::ZERO);
    }
    let mut best = if inside(Vec2::ZERO) { distance(Vec2::ZERO) } else { 0.0 };
    for k in 0..n {
        let d = corners[(k + 1) % n] - corners[k];
        let (mid, inward) = (corners[k] + 0.5 * d, Vec2::new(-d.y, d.x));
        for share in [0.5, 0.25, 0.1, 0.02] {
            let x = mid + share * inward;
            if inside(x) {
                best = best.max(distance(x));
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setup(vertices: &[(f64, f64)]) -> Setup {
        Setup {
            blocks: vec![BlockSpec {
                name: "b".into(),
                vertices: vertices.iter().map(|&(x, y)| Vec2::new(x, y)).collect(),
                material: 0,
                density: 1000.0,
                velocity: Vec2::ZERO,
                spin: 0.0,
            }],
            ..Setup::default()
        }
    }

    #[test]
    fn rectangle_far_from_the_origin() {
        let x = 1e6;
        let s = Shapes::new(&setup(&[(x, x), (x + 2.0, x), (x + 2.0, x + 1.0), (x, x + 1.0)]));
        assert_eq!(s.mass[0], 2000.0);
        assert!((s.inertia[0] - 2000.0 * 5.0 / 12.0).abs() < 1e-9);
        assert_eq!(s.centroid[0], Vec2::new(x + 1.0, x + 0.5));
        assert!(s.convex[0] && (s.inradius[0] - 0.5).abs() < 1e-12);
    }

    #[test]
    fn reflex_corner_is_found() {
        let s = Shapes::new(&setup(&[
            (0.0, 0.0),
            (2.0, 0.0),
            (2.0, 1.0),
            (1.0, 1.0),
            (1.0, 2.0),
            (0.0, 2.0),
        ]));
        let reflex: Vec<bool> = s.of(0).iter().map(|e| e.reflex).collect();
        assert_eq!(reflex, [false, false, false, true, false, false]);
        assert!(!s.convex[0] && s.inradius[0] > 0.2);
    }
}
