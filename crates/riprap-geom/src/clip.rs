//! Two outlines: clipping, common area, depth of overlap. For input checks and preparation; the
//! contact engine has its own, exact treatment.

use crate::arrangement::{self, Cut};
use crate::measure::in_circle;
use crate::polygon::{self, Aabb, Side, distance_to_boundary, edges, locate};
use crate::{GeomError, Vec2};

/// The half plane to the left of the directed line through `point` along `direction`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfPlane {
    /// A point on the line.
    pub point: Vec2,
    /// Direction of the line; its length does not matter.
    pub direction: Vec2,
}

impl HalfPlane {
    /// Height above the line times the length of `direction`.
    fn height(&self, p: Vec2) -> f64 {
        self.direction.perp_dot(p - self.point)
    }
}

/// The part of a convex anticlockwise outline in a half plane; fewer than three vertices if none.
pub fn clip_convex(vertices: &[Vec2], half: HalfPlane) -> Vec<Vec2> {
    let mut kept = Vec::with_capacity(vertices.len() + 1);
    for (a, b) in edges(vertices) {
        let (ha, hb) = (half.height(a), half.height(b));
        if ha >= 0.0 {
            kept.push(a);
        }
        if (ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0) {
            kept.push(a + (ha / (ha - hb)) * (b - a));
        }
    }
    kept
}

/// The common part of two convex anticlockwise outlines.
pub fn intersect_convex(a: &[Vec2], b: &[Vec2]) -> Vec<Vec2> {
    let mut part = a.to_vec();
    for (from, to) in edges(b) {
        if part.len() < 3 {
            return Vec::new();
        }
        part = clip_convex(&part, HalfPlane { point: from, direction: to - from });
    }
    if part.len() < 3 { Vec::new() } else { part }
}

/// The parts of a simple anticlockwise outline in a half plane.
///
/// *Errors*: as `arrangement::cut_region`.
pub fn clip_simple(vertices: &[Vec2], half: HalfPlane) -> Result<Vec<Vec<Vec2>>, GeomError> {
    polygon::validate(vertices)?;
    let bounds = Aabb::of(vertices);
    let direction = half.direction.normalize_or_zero();
    let foot = half.point + (bounds.centre() - half.point).dot(direction) * direction;
    let reach = bounds.size() * direction;
    let cut = Cut { from: foot - reach, to: foot + reach, family: None };
    let parts = arrangement::cut_region(vertices, &[cut])?.polygons();
    let farthest = |p: &Vec<Vec2>| {
        let heights = p.iter().map(|&v| half.height(v));
        heights.fold(0.0f64, |far, h| if h.abs() > far.abs() { h } else { far })
    };
    Ok(parts.into_iter().filter(|p| farthest(p) > 0.0).collect())
}

/// Area common to two simple anticlockwise outlines.
///
/// Each outline is the signed sum of triangles from its first vertex, so the common area is the
/// signed sum over pairs of triangles, each pair convex. *Cost*: product of the vertex counts.
pub fn intersection_area(a: &[Vec2], b: &[Vec2]) -> f64 {
    if a.len() < 3 || b.len() < 3 || !Aabb::of(a).touches(&Aabb::of(b)) {
        return 0.0;
    }
    let origin = a[0];
    let (fan_a, fan_b) = (fan(a, origin), fan(b, origin));
    let mut sum = 0.0;
    for (ta, sign_a, box_a) in &fan_a {
        for (tb, sign_b, box_b) in &fan_b {
            if box_a.touches(box_b) {
                sum += sign_a * sign_b * polygon::signed_area(&intersect_convex(ta, tb));
            }
        }
    }
    sum.max(0.0)
}

/// Anticlockwise triangles from the first vertex, with the sign they count with.
fn fan(vertices: &[Vec2], origin: Vec2) -> Vec<([Vec2; 3], f64, Aabb)> {
    let p0 = vertices[0] - origin;
    let mut triangles = Vec::with_capacity(vertices.len());
    for pair in vertices[1..].windows(2) {
        let (p, q) = (pair[0] - origin, pair[1] - origin);
        let sign = polygon::turn(p0, p, q);
        if sign != 0.0 {
            let t = if sign > 0.0 { [p0, p, q] } else { [p0, q, p] };
            triangles.push((t, sign.signum(), Aabb::of(&t)));
        }
    }
    triangles
}

/// How deep two outlines are in each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Largest distance of a point of one, inside the other, from the boundary of the other, m.
    pub depth: f64,
    /// Where that is.
    pub at: Vec2,
}

/// Depth of overlap of two simple outlines; 0 where they only touch.
///
/// Looked at: the boundary of each inside the other, and the centre of the largest circle of each
/// (one block wholly on top of its twin has no boundary inside). The largest value along a piece is
/// found by sampling and refining: an estimate good to a percent, and exact to round-off at 0.
pub fn overlap_depth(a: &[Vec2], b: &[Vec2]) -> Overlap {
    let mut worst = Overlap { depth: 0.0, at: a.first().copied().unwrap_or(Vec2::ZERO) };
    let (box_a, box_b) = (Aabb::of(a), Aabb::of(b));
    if a.len() < 3 || b.len() < 3 || !box_a.touches(&box_b) {
        return worst;
    }
    boundary_inside(a, b, box_b, &mut worst);
    boundary_inside(b, a, box_a, &mut worst);
    // Outlines that overlap with next to nothing of either boundary inside the other are twins; only
    // then the search for the largest circle, which is dear, can find more.
    let size = box_a.size().min(box_b.size());
    let apart = (box_a.min - box_b.min).abs().max((box_a.max - box_b.max).abs());
    if worst.depth <= 1e-3 * size && apart.max_element() <= 1e-2 * size {
        consider(b, in_circle(a).0, &mut worst);
        consider(a, in_circle(b).0, &mut worst);
    }
    worst
}

fn consider(outline: &[Vec2], p: Vec2, worst: &mut Overlap) -> f64 {
    if locate(outline, p) != Side::Inside {
        return 0.0;
    }
    let depth = distance_to_boundary(outline, p);
    if depth > worst.depth {
        *worst = Overlap { depth, at: p };
    }
    depth
}

/// Raise `worst` by the boundary pieces of `a` inside `b`.
fn boundary_inside(a: &[Vec2], b: &[Vec2], box_b: Aabb, worst: &mut Overlap) {
    // Outlines with many edges have short ones, along which the depth changes little.
    let samples = if a.len() > 64 { 2 } else { 8 };
    let mut stops: Vec<f64> = Vec::new();
    for (p, q) in edges(a) {
        if !Aabb::of(&[p, q]).touches(&box_b) {
            continue;
        }
        let along = q - p;
        stops.clear();
        stops.extend([0.0, 1.0]);
        for (c, d) in edges(b) {
            let (hc, hd) = (along.perp_dot(c - p), along.perp_dot(d - p));
            if (hc > 0.0) != (hd > 0.0) {
                let s = hc / (hc - hd);
                let t = (c + s * (d - c) - p).dot(along) / along.length_squared();
                if t > 0.0 && t < 1.0 {
                    stops.push(t);
                }
            }
        }
        stops.sort_by(f64::total_cmp);
        for pair in stops.windows(2) {
            deepest(b, p, along, (pair[0], pair[1]), samples, worst);
        }
    }
}

/// Raise `worst` by one piece. Its end is looked at as the start of the next edge, or is a crossing
/// with depth 0.
fn deepest(
    b: &[Vec2],
    p: Vec2,
    along: Vec2,
    (t0, t1): (f64, f64),
    samples: usize,
    worst: &mut Overlap,
) {
    if t1 <= t0 {
        return;
    }
    let step = (t1 - t0) / samples as f64;
    let before = worst.depth;
    let mut best = (0.0, t0);
    for k in 0..samples {
        let t = t0 + step * k as f64;
        let depth = consider(b, p + t * along, worst);
        if depth > best.0 {
            best = (depth, t);
        }
    }
    if best.0 == 0.0 || best.0 < 0.5 * before {
        return;
    }
    // The distance is piecewise smooth; between samples a ternary search closes in on the top.
    let (mut low, mut high) = ((best.1 - step).max(t0), (best.1 + step).min(t1));
    for _ in 0..12 {
        let (m0, m1) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if consider(b, p + m0 * along, worst) < consider(b, p + m1 * along, worst) {
            low = m0;
        } else {
            high = m1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{letter_u, rectangle, regular};
    use proptest::prelude::*;

    #[test]
    fn depth_of_simple_pairs() {
        let a = rectangle(Vec2::ZERO, Vec2::ONE);
        let moved = |x: f64, y: f64| rectangle(Vec2::new(x, y), Vec2::ONE);
        assert_eq!(overlap_depth(&a, &moved(1.0, 0.3)).depth, 0.0);
        assert_eq!(overlap_depth(&a, &moved(3.0, 0.3)).depth, 0.0);
        assert!((overlap_depth(&a, &moved(0.9, 0.0)).depth - 0.1).abs() < 1e-3);
        assert!((overlap_depth(&a, &moved(0.9, 0.2)).depth - 0.1).abs() < 1e-3);
        assert!((overlap_depth(&a, &a).depth - 0.5).abs() < 0.01);
        let small = rectangle(Vec2::splat(0.4), Vec2::splat(0.2));
        assert!((overlap_depth(&a, &small).depth - 0.4).abs() < 1e-3);
        let d = overlap_depth(&a, &moved(1.0 - 1e-9, 0.5)).depth;
        assert!((d / 1e-9 - 1.0).abs() < 1e-3, "{d}");
        assert_eq!(overlap_depth(&[], &a).depth, 0.0);
        assert_eq!(overlap_depth(&a, &[Vec2::NAN; 4]).depth, 0.0);
    }

    #[test]
    fn a_line_through_a_u_leaves_two_arms() {
        let u = letter_u();
        let half = HalfPlane { point: Vec2::new(0.0, 2.0), direction: Vec2::X };
        let parts = clip_simple(&u, half).unwrap();
        assert_eq!(parts.len(), 2);
        assert!(parts.iter().all(|p| (polygon::signed_area(p) - 2.0).abs() < 1e-12));
        let below = HalfPlane { direction: -Vec2::X, ..half };
        assert_eq!(clip_simple(&u, below).unwrap().len(), 1);
        assert_eq!(intersection_area(&u, &rectangle(Vec2::new(0.5, 2.0), Vec2::splat(4.0))), 2.0);
    }

    proptest! {
        #[test]
        fn areas_of_convex_pairs_agree(x in -1.5..1.5f64, y in -1.5..1.5f64, n in 3usize..9) {
            let a = regular(5, 1.0, Vec2::ZERO);
            let b = regular(n, 0.8, Vec2::new(x, y));
            let direct = polygon::signed_area(&intersect_convex(&a, &b));
            prop_assert!((intersection_area(&a, &b) - direct).abs() < 1e-13);
            prop_assert!((intersection_area(&b, &a) - direct).abs() < 1e-13);
            if direct > 1e-6 {
                prop_assert!(overlap_depth(&a, &b).depth > 0.0);
            }
        }
    }
}
