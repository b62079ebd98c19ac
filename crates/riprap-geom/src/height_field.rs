//! Surfaces with one height per place: terrain as triangles.
//!
//! A surface is a set of triangles whose projections along z do not overlap and hang together without gaps, so that every
//! vertical line inside its outline meets it once. Triangles run anticlockwise seen from above. [`HeightField::grid`] makes one from
//! heights on a grid, [`HeightField::new`] checks triangles from anywhere.

mod bins;
mod outline;

use std::collections::BTreeSet;

use crate::Vec3;
pub use bins::Bins;

/// Projections may overlap by this share of their size: coordinates in files have few digits.
const OVERLAP: f64 = 1e-6;
/// A projection whose height over its longest edge is less than this share of it is a vertical wall, or nothing.
const FLAT: f64 = 1e-9;
/// How far below its lowest point the body of a surface ends, over its size along the ground.
const FOOT: f64 = 0.02;

/// A surface with one height per place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeightField {
    /// Corners, m.
    pub points: Vec<Vec3>,
    /// Corners of each triangle, anticlockwise seen from above.
    pub triangles: Vec<[u32; 3]>,
}

/// Why triangles are no surface with one height per place. Places are x and y.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum HeightFieldError {
    /// Nothing is there.
    #[error("it has no triangles")]
    Empty,
    /// A corner without a number.
    #[error("corner {corner} has a non-finite coordinate")]
    NonFinite {
        /// Corner, counted from 0.
        corner: usize,
    },
    /// A triangle names a corner that is not there.
    #[error("triangle {triangle} names a corner that does not exist")]
    NoSuchCorner {
        /// Triangle, counted from 0.
        triangle: usize,
    },
    /// A triangle that stands upright or is a line.
    #[error("the triangle near ({}, {}) is vertical or has no area: a surface needs one height per point", .at[0], .at[1])]
    Upright {
        /// Its middle.
        at: [f64; 2],
    },
    /// Two heights at one place.
    #[error("it is folded near ({}, {}): two triangles lie above each other", .at[0], .at[1])]
    Folded {
        /// Middle of one of them.
        at: [f64; 2],
    },
    /// More than two triangles at an edge, or two on one side of it.
    #[error("three or more triangles share an edge near ({}, {}), or two lie on one side of it", .at[0], .at[1])]
    SharedEdge {
        /// Middle of the edge.
        at: [f64; 2],
    },
    /// A hole.
    #[error("it has a hole near ({}, {}), about {width} wide", .at[0], .at[1])]
    Hole {
        /// Middle of the hole.
        at: [f64; 2],
        /// Largest extent of the hole.
        width: f64,
    },
    /// Parts that do not hang together.
    #[error("it consists of {parts} separate parts, with a gap near ({}, {})", .at[0], .at[1])]
    Parts {
        /// How many.
        parts: usize,
        /// A corner of the smallest part.
        at: [f64; 2],
    },
}

impl HeightField {
    /// A checked surface. Triangles that run clockwise are turned, corners that no triangle has are left out.
    ///
    /// # Errors
    /// The first reason why it has not one height per place, or has gaps.
    pub fn new(points: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, HeightFieldError> {
        if triangles.is_empty() {
            return Err(HeightFieldError::Empty);
        }
        if let Some(corner) = points.iter().position(|p| !p.is_finite()) {
            return Err(HeightFieldError::NonFinite { corner });
        }
        let mut surface = Self { points, triangles };
        surface.turn_up()?;
        surface.drop_unused();
        // After all are turned one way: then neighbours run along their edge in opposite directions.
        surface.edges()?;
        let bins = Bins::new(&surface);
        surface.folds(&bins)?;
        outline::ring(&surface)?;
        Ok(surface)
    }

    /// Heights on the lines of a grid: `height(i, j)` at `(x[i], y[j])`, both ascending; a place without height has no triangle.
    /// Of the two diagonals of a cell the one whose ends differ less in height is taken, the rising one of equal ones.
    ///
    /// # Errors
    /// As [`HeightField::new`].
    pub fn grid(
        x: &[f64],
        y: &[f64],
        height: impl Fn(usize, usize) -> Option<f64>,
    ) -> Result<Self, HeightFieldError> {
        let mut points = Vec::with_capacity(x.len() * y.len());
        let mut number = vec![u32::MAX; x.len() * y.len()];
        for (j, &y) in y.iter().enumerate() {
            for (i, &at) in x.iter().enumerate() {
                if let Some(z) = height(i, j) {
                    number[j * x.len() + i] = points.len() as u32;
                    points.push(Vec3::new(at, y, z));
                }
            }
        }
        let mut triangles = Vec::new();
        for j in 1..y.len() {
            for i in 1..x.len() {
                let at = |di: usize, dj: usize| number[(j - 1 + dj) * x.len() + i - 1 + di];
                // Anticlockwise from the lower left one.
                let [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
                let there = [a, b, c, d].map(|k| k != u32::MAX);
                match there {
                    [true, true, true, true] => {
                        let z = |k: u32| points[k as usize].z;
                        if (z(a) - z(c)).abs() <= (z(b) - z(d)).abs() {
                            triangles.extend([[a, b, c], [a, c, d]]);
                        } else {
                            triangles.extend([[a, b, d], [b, c, d]]);
                        }
                    }
                    [false, true, true, true] => triangles.push([b, c, d]),
                    [true, false, true, true] => triangles.push([a, c, d]),
                    [true, true, false, true] => triangles.push([a, b, d]),
                    [true, true, true, false] => triangles.push([a, b, c]),
                    [_, _, _, _] => {}
                }
            }
        }
        Self::new(points, triangles)
    }

    /// Corners of a triangle, m.
    #[must_use]
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|k| self.points[k as usize])
    }

    /// Lowest and highest coordinates, m.
    #[must_use]
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let points = self.points.iter();
        points.fold(start, |(low, high), p| (low.min(*p), high.max(*p)))
    }

    /// The steepest triangle: its angle to the horizontal, rad, and its middle, m.
    #[must_use]
    pub fn steepest(&self) -> (f64, Vec3) {
        let mut worst = (0.0, Vec3::ZERO);
        for t in 0..self.triangles.len() {
            let [a, b, c] = self.corners(t);
            let normal = (b - a).cross(c - a);
            let angle = libm::atan2(normal.truncate().length(), normal.z);
            if angle >= worst.0 {
                worst = (angle, (a + b + c) / 3.0);
            }
        }
        worst
    }

    /// Height of the surface at a place, m; `None` outside its outline.
    #[must_use]
    pub fn height(&self, bins: &Bins, x: f64, y: f64) -> Option<f64> {
        bins.at(x, y).iter().find_map(|&t| {
            let [a, b, c] = self.corners(t as usize);
            let p = Vec3::new(x, y, 0.0);
            let normal = (b - a).cross(c - a);
            let inside = [(a, b), (b, c), (c, a)]
                .iter()
                // A place on an edge is in both triangles rather than in neither;
                // the first one has the same height there.
                .all(|(from, to)| cross(*from, *to, p) >= -FLAT * normal.z);
            inside.then(|| a.z - (normal.x * (x - a.x) + normal.y * (y - a.y)) / normal.z)
        })
    }

    /// A closed body under the surface, with upright sides and a flat foot: corners and faces, anticlockwise seen from outside.
    #[must_use]
    pub fn body(&self) -> (Vec<Vec3>, Vec<Vec<u32>>) {
        let (low, high) = self.bounds();
        let foot = low.z - FOOT * (high - low).truncate().max_element();
        let count = self.points.len() as u32;
        let mut points = self.points.clone();
        points.extend(self.points.iter().map(|p| Vec3::new(p.x, p.y, foot)));
        let mut faces: Vec<Vec<u32>> = self.triangles.iter().map(|t| t.to_vec()).collect();
        faces.extend(
            self.triangles
                .iter()
                // Anticlockwise from below.
                .map(|[a, b, c]| vec![a + count, c + count, b + count]),
        );
        for (a, b) in self.rim() {
            faces.push(vec![b, a, a + count, b + count]);
        }
        (points, faces)
    }

    /// The surface with a steep wall that goes down from its rim all round: with it, what comes from outside meets a side.
    /// Its first triangles are those of the surface.
    #[must_use]
    pub fn walled(&self) -> Self {
        outline::walled(self)
    }

    /// Edges with a triangle on one side only, which lies to their left.
    #[must_use]
    pub fn rim(&self) -> Vec<(u32, u32)> {
        let mut edges: Vec<(u32, u32)> =
            self.triangles.iter().flat_map(|[a, b, c]| [(*a, *b), (*b, *c), (*c, *a)]).collect();
        edges.sort_unstable();
        let lone = |(a, b): &(u32, u32)| edges.binary_search(&(*b, *a)).is_err();
        edges.iter().copied().filter(lone).collect()
    }

    fn turn_up(&mut self) -> Result<(), HeightFieldError> {
        for (triangle, corners) in self.triangles.iter_mut().enumerate() {
            if corners.iter().any(|k| *k as usize >= self.points.len()) {
                return Err(HeightFieldError::NoSuchCorner { triangle });
            }
            let [a, b, c] = corners.map(|k| self.points[k as usize]);
            let twice = cross(a, b, c);
            let longest = [b - a, c - b, a - c]
                .map(|e| e.truncate().length_squared())
                .into_iter()
                .fold(0.0, f64::max);
            if twice.abs() <= FLAT * longest {
                let at = middle(&[a, b, c]);
                return Err(HeightFieldError::Upright { at });
            }
            if twice < 0.0 {
                corners.swap(1, 2);
            }
        }
        Ok(())
    }

    fn drop_unused(&mut self) {
        let mut number = vec![u32::MAX; self.points.len()];
        for &k in self.triangles.iter().flatten() {
            number[k as usize] = 0;
        }
        let mut kept = 0;
        let mut points = Vec::with_capacity(self.points.len());
        for (k, slot) in number.iter_mut().enumerate() {
            if *slot == 0 {
                *slot = kept;
                kept += 1;
                points.push(self.points[k]);
            }
        }
        self.points = points;
        for k in self.triangles.iter_mut().flatten() {
            *k = number[*k as usize];
        }
    }

    /// Every edge has one triangle on each side at most.
    fn edges(&self) -> Result<(), HeightFieldError> {
        let mut seen: BTreeSet<(u32, u32)> = BTreeSet::new();
        for [a, b, c] in &self.triangles {
            for (from, to) in [(*a, *b), (*b, *c), (*c, *a)] {
                if !seen.insert((from, to)) {
                    let ends = [from, to].map(|k| self.points[k as usize]);
                    return Err(HeightFieldError::SharedEdge { at: middle(&ends) });
                }
            }
        }
        Ok(())
    }

    /// No two projections overlap.
    fn folds(&self, bins: &Bins) -> Result<(), HeightFieldError> {
        for list in bins.lists() {
            for (k, &a) in list.iter().enumerate() {
                for &b in &list[k + 1..] {
                    let (p, q) = (self.corners(a as usize), self.corners(b as usize));
                    if overlap(&p, &q) {
                        return Err(HeightFieldError::Folded { at: middle(&q) });
                    }
                }
            }
        }
        Ok(())
    }
}

/// Twice the area of the projection of a triangle, positive anticlockwise.
fn cross(a: Vec3, b: Vec3, c: Vec3) -> f64 {
    (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)
}

fn middle(points: &[Vec3]) -> [f64; 2] {
    let sum: Vec3 = points.iter().sum();
    let at = sum / points.len() as f64;
    [at.x, at.y]
}

/// Whether the projections of two triangles, both anticlockwise, have more than their rims in common.
fn overlap(p: &[Vec3; 3], q: &[Vec3; 3]) -> bool {
    let apart = |of: &[Vec3; 3], other: &[Vec3; 3]| {
        (0..3).any(|k| {
            let (a, b) = (of[k], of[(k + 1) % 3]);
            let slack = OVERLAP * (b - a).truncate().length_squared();
            other.iter().all(|c| cross(a, b, *c) <= slack)
        })
    };
    !apart(p, q) && !apart(q, p)
}

#[cfg(test)]
mod tests;
