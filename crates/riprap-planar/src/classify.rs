//! The source's four contact types and its classification threshold.
//!
//! The engine does not need them: its rule over boundary pieces holds all four and everything between.
//! They are told by `probe-contact`, for comparison with hand calculations.
//!
//! Source: mutual penetration potentials, claim 2 (a candidate exists below `2 d0`).
//! Deviation: the source leaves "nearly parallel" open; here it is [`PARALLEL`] radians.

use riprap_geom::Vec2;
use serde::Serialize;

use super::convex::Turned;

/// Angle below which two edges count as parallel: 1 degree, rad.
pub const PARALLEL: f64 = 0.017_453_292_519_943_295;

/// The four types.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ContactType {
    /// Two convex corners.
    ConvexConvex,
    /// A reflex corner and a convex corner.
    ConcaveConvex,
    /// A convex corner and an edge.
    ConvexEdge,
    /// Two nearly parallel edges.
    EdgeEdge,
}

/// A classified pair of features.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Classified {
    /// Type.
    pub kind: ContactType,
    /// Corner or edge number of the first block.
    pub first: usize,
    /// Corner or edge number of the second block.
    pub second: usize,
    /// Whether the corner of a convex-edge contact belongs to the second block.
    pub corner_is_second: bool,
    /// Distance between the features, m (edge-edge: mean over the common length; below 0 overlapping).
    pub distance: f64,
}

/// Classifies all feature pairs closer than `2 d0`; `shift` is the centroid of i minus that of j.
///
/// An edge pair takes precedence over its corners' contacts with the other edge, a corner pair over
/// the corners' contacts with the edges next to the other corner.
#[must_use]
pub fn classify(i: &[Turned], j: &[Turned], shift: Vec2, d0: f64) -> Vec<Classified> {
    let reach = 2.0 * d0;
    let mut found = edge_pairs(i, j, shift, reach);
    let corners = corner_pairs(i, j, shift, reach, &found);
    let taken: Vec<Classified> = found.iter().chain(&corners).copied().collect();
    found.extend(corner_edges([i, j], shift, reach, false, &taken));
    found.extend(corner_edges([j, i], -shift, reach, true, &taken));
    found.extend(corners);
    found.sort_by_key(|c| (c.kind, c.first, c.second));
    found
}

fn edge_pairs(i: &[Turned], j: &[Turned], shift: Vec2, reach: f64) -> Vec<Classified> {
    let mut found = Vec::new();
    for (first, own) in i.iter().enumerate() {
        for (second, other) in j.iter().enumerate() {
            let gap = parallel_gap(own, other, shift).filter(|gap| gap.abs() < reach);
            found.extend(gap.map(|distance| Classified {
                kind: ContactType::EdgeEdge,
                first,
                second,
                corner_is_second: false,
                distance,
            }));
        }
    }
    found
}

/// Pairs of corners, but for those of `edges` that are in contact.
fn corner_pairs(
    i: &[Turned],
    j: &[Turned],
    shift: Vec2,
    reach: f64,
    edges: &[Classified],
) -> Vec<Classified> {
    let (a, b) = (i.len(), j.len());
    let mut found = Vec::new();
    for (first, own) in i.iter().enumerate() {
        for (second, other) in j.iter().enumerate() {
            let distance = (own.start + shift - other.start).length();
            let taken = edges.iter().any(|e| {
                (e.first == first || e.first == (first + a - 1) % a)
                    && (e.second == second || e.second == (second + b - 1) % b)
            });
            if distance >= reach || (own.reflex && other.reflex) || taken {
                continue;
            }
            let kind = if own.reflex || other.reflex {
                ContactType::ConcaveConvex
            } else {
                ContactType::ConvexConvex
            };
            found.push(Classified { kind, first, second, corner_is_second: false, distance });
        }
    }
    found
}

/// Convex corners of the first of two blocks near edges of the other, but for those of the pairs `taken`; `swapped` where that block is the second one.
fn corner_edges(
    [own, other]: [&[Turned]; 2],
    shift: Vec2,
    reach: f64,
    swapped: bool,
    taken: &[Classified],
) -> Vec<Classified> {
    let (n, o) = (own.len(), other.len());
    let mut found = Vec::new();
    for (k, corner) in own.iter().enumerate().filter(|(_, c)| !c.reflex) {
        for (m, edge) in other.iter().enumerate() {
            let x = corner.start + shift - edge.start;
            let along = edge.normal.perp().dot(x);
            let distance = edge.normal.dot(x);
            if along < 0.0 || along > edge.length || distance.abs() >= reach {
                continue;
            }
            let taken = taken.iter().any(|c| {
                let (e, f) = if swapped { (c.second, c.first) } else { (c.first, c.second) };
                match c.kind {
                    ContactType::EdgeEdge => f == m && (e == k || e == (k + n - 1) % n),
                    ContactType::ConvexConvex
                    | ContactType::ConcaveConvex
                    | ContactType::ConvexEdge => e == k && (f == m || f == (m + 1) % o),
                }
            });
            if !taken {
                let (first, second) = if swapped { (m, k) } else { (k, m) };
                let kind = ContactType::ConvexEdge;
                found.push(Classified { kind, first, second, corner_is_second: swapped, distance });
            }
        }
    }
    found
}

/// Mean gap between two nearly antiparallel edges over their common length, m.
fn parallel_gap(own: &Turned, other: &Turned, shift: Vec2) -> Option<f64> {
    let facing = -own.normal.dot(other.normal);
    if facing < libm::cos(PARALLEL) {
        return None;
    }
    let along = other.normal.perp();
    let start = own.start + shift - other.start;
    let end = start + own.length * own.normal.perp();
    // Edges that face each other run in opposite ways: the end of the one comes first along the other.
    let (s0, s1) = (along.dot(end), along.dot(start));
    let (low, high) = (s0.max(0.0), s1.min(other.length));
    if high - low <= 1e-9 * own.length.min(other.length) {
        return None;
    }
    let middle = 0.5 * (low + high);
    let share = (s1 - middle) / (s1 - s0);
    Some(other.normal.dot(start + share * (end - start)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Edge;

    fn polygon(points: &[(f64, f64)]) -> Vec<Turned> {
        let p: Vec<Vec2> = points.iter().map(|&(x, y)| Vec2::new(x, y)).collect();
        let n = p.len();
        (0..n)
            .map(|k| {
                let d = p[(k + 1) % n] - p[k];
                let before = p[k] - p[(k + n - 1) % n];
                let normal = Vec2::new(d.y, -d.x) / d.length();
                let edge = Edge {
                    start: p[k],
                    normal,
                    length: d.length(),
                    reflex: before.perp_dot(d) < 0.0,
                };
                Turned::new(&edge, 1.0, 0.0)
            })
            .collect()
    }

    fn kinds(a: &[(f64, f64)], b: &[(f64, f64)]) -> Vec<ContactType> {
        classify(&polygon(a), &polygon(b), Vec2::ZERO, 1e-3).iter().map(|c| c.kind).collect()
    }

    const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

    #[test]
    fn brick_on_brick_is_edge_edge() {
        let above = SQUARE.map(|(x, y)| (x + 0.5, y + 1.0 - 1e-6));
        assert_eq!(kinds(&SQUARE, &above), [ContactType::EdgeEdge]);
    }

    #[test]
    fn corner_on_face_is_convex_edge() {
        let corner = [(0.5, 0.9999), (1.0, 1.4), (0.0, 1.4)];
        assert_eq!(kinds(&SQUARE, &corner), [ContactType::ConvexEdge]);
        assert_eq!(kinds(&corner, &SQUARE), [ContactType::ConvexEdge]);
    }

    #[test]
    fn corner_to_corner_is_convex_convex() {
        let other = [(1.0, 1.0001), (2.0, 1.6), (1.4, 2.0)];
        assert_eq!(kinds(&SQUARE, &other), [ContactType::ConvexConvex]);
    }

    #[test]
    fn corner_in_a_notch_is_concave_convex() {
        let notched = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.0, 0.0), (-1.0, 1.0)];
        let wedge = [(0.0, 1e-4), (0.3, 1.0), (-0.3, 1.0)];
        assert_eq!(kinds(&notched, &wedge), [ContactType::ConcaveConvex]);
    }

    #[test]
    fn far_features_are_none() {
        let above = SQUARE.map(|(x, y)| (x, y + 1.01));
        assert!(kinds(&SQUARE, &above).is_empty());
    }
}
