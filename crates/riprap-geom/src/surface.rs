//! On which side of a surface of triangles a place lies: a closed surface has an inside, an open one an upper side.
//!
//! A vertical line crosses a triangle or not, and where it meets an edge or a corner it crosses exactly one of the triangles there: a place
//! on an edge of the projection counts as moved by (e, e²) for an e smaller than any number. So the number of crossings of a closed
//! surface is even for every line.
//!
//! Source: Edelsbrunner and Mücke (1990), Simulation of simplicity, ACM Transactions on Graphics 9, 66-104.

use std::collections::BTreeMap;

use crate::height_field::{Bins, HeightField};
use crate::{Vec2, Vec3};

/// Triangles that may hang together in any way.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulated {
    of: HeightField,
    bins: Bins,
}

/// Whether a place lies left of the line between two corners, the same for both triangles at an edge. `order`: numbers of the corners.
fn left(ends: [Vec3; 2], order: [u32; 2], place: Vec2) -> bool {
    let turned = order[0] > order[1];
    let [a, b] = if turned { [ends[1], ends[0]] } else { ends };
    let (way, arm) = ((b - a).truncate(), place - a.truncate());
    let side = way.x * arm.y - way.y * arm.x;
    let is_left = if side != 0.0 {
        side > 0.0
    } else if way.y != 0.0 {
        way.y < 0.0
    } else {
        way.x > 0.0
    };
    is_left != turned
}

impl Triangulated {
    /// A surface; `None` where a corner is no number or not there, or all lies on one vertical line.
    #[must_use]
    pub fn new(points: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Option<Self> {
        let known = |t: &[u32; 3]| t.iter().all(|k| (*k as usize) < points.len());
        let sound = !triangles.is_empty()
            && points.iter().all(|p| p.is_finite())
            && triangles.iter().all(known);
        let of = HeightField { points, triangles };
        let wide = |of: &HeightField| {
            let (low, high) = of.bounds();
            (high - low).truncate().max_element() > 0.0
        };
        (sound && wide(&of)).then(|| Self { bins: Bins::new(&of), of })
    }

    /// Middles of the edges with an odd number of triangles: a closed surface has none.
    #[must_use]
    pub fn open_edges(&self) -> Vec<Vec3> {
        let mut odd: BTreeMap<[u32; 2], bool> = BTreeMap::new();
        for [a, b, c] in &self.of.triangles {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                let edge = [*from.min(to), *from.max(to)];
                let is_odd = odd.entry(edge).or_insert(false);
                *is_odd = !*is_odd;
            }
        }
        let open = odd.into_iter().filter(|(_, is_odd)| *is_odd);
        open.map(|(edge, _)| 0.5 * edge.map(|k| self.of.points[k as usize]).iter().sum::<Vec3>())
            .collect()
    }

    /// Heights at which the vertical line through a place crosses the surface, m, ascending.
    #[must_use]
    pub fn heights(&self, x: f64, y: f64) -> Vec<f64> {
        let place = Vec2::new(x, y);
        let near = self.bins.at(x, y).iter();
        let mut heights: Vec<f64> = near.filter_map(|t| self.height(*t as usize, place)).collect();
        heights.sort_by(f64::total_cmp);
        heights
    }

    fn height(&self, triangle: usize, place: Vec2) -> Option<f64> {
        let [a, b, c] = self.of.triangles[triangle];
        let order = [[b, c], [c, a], [a, b]];
        let corner = |k: u32| self.of.points[k as usize];
        let sides = order.map(|[from, to]| left([corner(from), corner(to)], [from, to], place));
        if sides.iter().any(|side| *side != sides[0]) {
            return None;
        }
        let shares = order.map(|[from, to]| {
            let arms = [corner(from), corner(to)].map(|p| p.truncate() - place);
            arms[0].perp_dot(arms[1])
        });
        let whole: f64 = shares.iter().sum();
        let parts = [a, b, c].into_iter().zip(shares);
        let height = parts.map(|(k, share)| share / whole * corner(k).z).sum::<f64>();
        height.is_finite().then_some(height)
    }

    /// The middle of the box around it, m.
    #[must_use]
    pub fn middle(&self) -> Vec3 {
        let (low, high) = self.of.bounds();
        0.5 * (low + high)
    }
}

/// Whether a height lies inside of a closed surface that a vertical line crosses at these heights.
#[must_use]
pub fn is_inside(crossings: &[f64], height: f64) -> bool {
    crossings.iter().filter(|z| **z > height).count() % 2 == 1
}

/// Whether a height lies above the nearest of the crossings; `None` where there is none.
#[must_use]
pub fn is_above(crossings: &[f64], height: f64) -> Option<bool> {
    let distance = |z: &&f64| (**z - height).abs();
    let nearest = crossings.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map(|z| *z <= height)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An octahedron of half diagonal 1: the vertical line through its corners meets four triangles at once.
    fn octahedron() -> Triangulated {
        let points = [Vec3::X, Vec3::Y, -Vec3::X, -Vec3::Y, Vec3::Z, -Vec3::Z].to_vec();
        let ring = (0..4).map(|k| [k, (k + 1) % 4]);
        let triangles = ring.flat_map(|[a, b]| [[a, b, 4], [b, a, 5]]).collect();
        Triangulated::new(points, triangles).unwrap()
    }

    #[test]
    fn lines_through_edges_and_corners_cross_a_closed_surface_evenly() {
        let it = octahedron();
        assert!(it.open_edges().is_empty());
        for k in -12..=12 {
            for j in -12..=12 {
                let (x, y) = (f64::from(k) / 8.0, f64::from(j) / 8.0);
                let crossings = it.heights(x, y);
                let half = 1.0 - x.abs() - y.abs();
                let wanted = if half > 0.0 { 2 } else { 0 };
                // The outline itself counts as moved to one side.
                assert!(
                    crossings.len() == wanted || half == 0.0 && crossings.len() == 2,
                    "{x} {y}"
                );
                if half > 0.0 {
                    assert!((crossings[1] - half).abs() < 1e-15 && is_inside(&crossings, 0.0));
                    assert!(!is_inside(&crossings, half + 0.01));
                    assert!(!is_inside(&crossings, -half - 0.01));
                }
            }
        }
    }

    #[test]
    fn an_open_surface_has_open_edges_and_an_upper_side() {
        let closed = octahedron();
        let mut triangles = closed.of.triangles.clone();
        triangles.pop();
        let open = Triangulated::new(closed.of.points.clone(), triangles).unwrap();
        assert_eq!(open.open_edges().len(), 3);
        let crossings = open.heights(0.1, 0.1);
        assert_eq!(is_above(&crossings, 2.0), Some(true));
        assert_eq!(is_above(&crossings, 0.5), Some(false));
        assert_eq!(is_above(&open.heights(3.0, 0.0), 0.0), None);
        assert!(Triangulated::new(vec![Vec3::ZERO; 3], vec![[0, 1, 2]]).is_none());
        assert!(Triangulated::new(vec![Vec3::ZERO; 2], vec![[0, 1, 2]]).is_none());
    }
}
