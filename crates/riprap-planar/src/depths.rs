//! Depth of a straight piece below any simple boundary: exact integrals.
//!
//! The depth is the distance to the nearest edge or corner. Along the piece each edge contributes a
//! linear part where the foot of the perpendicular lies on it and a hyperbola beyond its ends. The
//! piece is split at all kinks; between them one feature is nearest and the integral is closed.

use riprap_geom::Vec2;

use super::convex::Side;
use super::pieces::TOUCH;
use super::search::segment_distance;

/// Integrals of the depth over a piece, parameter `s` 0..1 along it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Depths {
    /// Integral of the depth, m.
    pub integral: f64,
    /// Integral of `s` times the depth, m.
    pub first_moment: f64,
    /// Largest depth at a kink, m.
    pub peak: f64,
}

#[derive(Clone, Copy, Debug)]
enum Feature {
    /// Distance `a + b s` from an edge line.
    Line { a: f64, b: f64 },
    /// Distance `sqrt((c s - d)² + h²)` from a corner.
    Corner { c: f64, d: f64, h: f64 },
}

impl Feature {
    fn at(self, s: f64) -> f64 {
        match self {
            Self::Line { a, b } => a + b * s,
            Self::Corner { c, d, h } => Vec2::new(c * s - d, h).length(),
        }
    }

    /// Smallest distance from `s0` to `s1`.
    fn least(self, s0: f64, s1: f64) -> f64 {
        match self {
            Self::Line { .. } => self.at(s0).min(self.at(s1)),
            Self::Corner { c, d, .. } => self.at((d / c).clamp(s0, s1)),
        }
    }

    /// Integrals of the distance and of `s` times it from `s0` to `s1`.
    fn integrals(self, s0: f64, s1: f64) -> (f64, f64) {
        let (f0, f1, w) = (self.at(s0), self.at(s1), s1 - s0);
        match self {
            Self::Line { .. } => {
                let sum = 0.5 * w * (f0 + f1);
                (sum, s0 * sum + w * w * (f0 + 2.0 * f1) / 6.0)
            }
            Self::Corner { c, d, h } => {
                let primitive = |s: f64, f: f64| {
                    let u = c * s - d;
                    let log = if h > 0.0 { h * h * libm::asinh(u / h) } else { 0.0 };
                    (0.5 * (u * f + log) / c, f * f * f / (3.0 * c * c))
                };
                let ((i0, m0), (i1, m1)) = (primitive(s0, f0), primitive(s1, f1));
                let integral = i1 - i0;
                (integral, (m1 - m0) + d / c * integral)
            }
        }
    }
}

/// What edge `m` of `block` contributes at parameter `s`.
fn feature(block: Side<'_>, m: u16, p: Vec2, q: Vec2, s: f64) -> Feature {
    let m = m as usize;
    let (start, normal) = (block.turned[m].start, block.turned[m].normal);
    let x = p + s * (q - p);
    let along = normal.perp().dot(x - start);
    let corner = if along <= 0.0 {
        start
    } else if along >= block.turned[m].length {
        block.turned[(m + 1) % block.turned.len()].start
    } else {
        let (a, b) = (normal.dot(start - p), -normal.dot(q - p));
        // The distance, on whichever side of the line the piece runs here.
        let sign = if a + b * s >= 0.0 { 1.0 } else { -1.0 };
        return Feature::Line { a: sign * a, b: sign * b };
    };
    let direction = q - p;
    let c = direction.length();
    let unit = direction / c;
    Feature::Corner { c, d: unit.dot(corner - p), h: unit.perp_dot(corner - p).abs() }
}

/// Longest list of edges whose features are all set against each other. A longer one is first cut down to
/// those that can be nearest, without which its cost grows with the cube of the list.
const FEW: usize = 8;

/// Scratch of [`spans`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Kinks {
    /// Where the nearest feature can change, as parameters.
    at: Vec<f64>,
    /// Edges that can be nearest to the piece.
    near: Vec<u16>,
    /// Features that can be nearest between two kinks.
    features: Vec<Feature>,
}

/// A part of a piece along which one feature is nearest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    /// Start and end as parameters on the piece.
    pub s: [f64; 2],
    /// The edge whose line or corner is nearest.
    pub edge: u16,
    feature: Feature,
}

impl Span {
    /// Distance at the start and at the end, m.
    pub(crate) fn depths(&self) -> [f64; 2] {
        self.s.map(|s| self.feature.at(s))
    }

    /// Integral of the distance over the parameter, m.
    pub(crate) fn integral(&self) -> f64 {
        self.feature.integrals(self.s[0], self.s[1]).0
    }

    /// Whether an end of the edge is nearest, not a place between.
    pub(crate) fn at_corner(&self) -> bool {
        matches!(self.feature, Feature::Corner { .. })
    }
}

/// Depth integrals of the piece `p q` (relative to the centroid of `block`) below `block`'s listed
/// edges.
pub(crate) fn along(block: Side<'_>, p: Vec2, q: Vec2, kinks: &mut Kinks) -> Depths {
    let mut sum = Depths::default();
    spans(block, p, q, kinks, |span| {
        let (i, m) = span.feature.integrals(span.s[0], span.s[1]);
        sum.integral += i;
        sum.first_moment += m;
        let [start, end] = span.depths();
        sum.peak = sum.peak.max(start).max(end);
    });
    sum.integral = sum.integral.max(0.0);
    sum
}

/// Calls `each` with the parts of the piece `p q` (relative to the centroid of `block`) that have one
/// nearest feature of `block`'s listed edges, in their order along the piece.
pub(crate) fn spans(
    block: Side<'_>,
    p: Vec2,
    q: Vec2,
    kinks: &mut Kinks,
    mut each: impl FnMut(Span),
) {
    if p == q {
        return;
    }
    let Kinks { at, near, features } = kinks;
    can_be_nearest(block, p, q, near);
    feet(block, p, q, near, at);
    let feet = at.len();
    for w in 0..feet - 1 {
        let (s0, s1) = (at[w], at[w + 1]);
        let middle = 0.5 * (s0 + s1);
        features.clear();
        features.extend(near.iter().map(|&m| feature(block, m, p, q, middle)));
        if block.nearest.len() > FEW {
            keep_lowest(features, s0, s1);
        }
        for (k, &a) in features.iter().enumerate() {
            for &b in &features[..k] {
                for s in equal_at(a, b) {
                    if s > s0 && s < s1 {
                        at.push(s);
                    }
                }
            }
        }
    }
    at.sort_by(f64::total_cmp);
    for w in at.windows(2) {
        let (s0, s1) = (w[0], w[1]);
        if s1 <= s0 {
            continue;
        }
        let middle = 0.5 * (s0 + s1);
        let mut nearest: Option<(f64, u16, Feature)> = None;
        for &m in near.iter() {
            let feature = feature(block, m, p, q, middle);
            let distance = feature.at(middle);
            if nearest.is_none_or(|(least, ..)| distance.total_cmp(&least).is_lt()) {
                nearest = Some((distance, m, feature));
            }
        }
        if let Some((_, edge, feature)) = nearest {
            let s = [s0, s1];
            each(Span { s, edge, feature });
        }
    }
}

/// Sorted parameters where the foot on a listed edge begins or ends, or the piece crosses its line.
fn feet(block: Side<'_>, p: Vec2, q: Vec2, near: &[u16], at: &mut Vec<f64>) {
    at.clear();
    at.extend([0.0, 1.0]);
    let mut add = |s: f64| {
        if s > 0.0 && s < 1.0 {
            at.push(s);
        }
    };
    for &m in near {
        let m = m as usize;
        let (start, normal) = (block.turned[m].start, block.turned[m].normal);
        let (a0, a1) = (normal.perp().dot(p - start), normal.perp().dot(q - start));
        add(a0 / (a0 - a1));
        add((a0 - block.turned[m].length) / (a0 - a1));
        let (d0, d1) = (normal.dot(p - start), normal.dot(q - start));
        add(d0 / (d0 - d1));
    }
    at.sort_by(f64::total_cmp);
}

/// Of the listed edges those that can be nearest to the piece `p q` somewhere; all of a short list.
///
/// The distance to an edge is convex along the piece, so some edge is everywhere nearer than the larger of
/// its distances at both ends. Edges that keep farther off than that are never nearest.
fn can_be_nearest(block: Side<'_>, p: Vec2, q: Vec2, near: &mut Vec<u16>) {
    near.clear();
    if block.nearest.len() <= FEW {
        near.extend_from_slice(block.nearest);
        return;
    }
    let ends = |m: u16| {
        let m = m as usize;
        let next = (m + 1) % block.turned.len();
        (block.turned[m].start, block.turned[next].start)
    };
    let farthest = |m: u16| {
        let (a, b) = ends(m);
        segment_distance(a, b, p).max(segment_distance(a, b, q))
    };
    let bound = block.nearest.iter().map(|&m| farthest(m)).fold(f64::INFINITY, f64::min);
    // Round-off of a distance is one of the coordinates.
    let bound = bound + TOUCH * (q - p).length();
    near.extend(block.nearest.iter().copied().filter(|&m| {
        let (a, b) = ends(m);
        segments_apart(p, q, a, b) <= bound
    }));
}

/// Distance between the segments `p q` and `a b`.
fn segments_apart(p: Vec2, q: Vec2, a: Vec2, b: Vec2) -> f64 {
    let (d, e) = (q - p, b - a);
    let crosses = (d.perp_dot(a - p) > 0.0) != (d.perp_dot(b - p) > 0.0)
        && (e.perp_dot(p - a) > 0.0) != (e.perp_dot(q - a) > 0.0);
    if crosses {
        return 0.0;
    }
    segment_distance(a, b, p)
        .min(segment_distance(a, b, q))
        .min(segment_distance(p, q, a))
        .min(segment_distance(p, q, b))
}

/// Drops the features that are nowhere nearest from `s0` to `s1`; each is convex there.
fn keep_lowest(features: &mut Vec<Feature>, s0: f64, s1: f64) {
    let highest = |f: &Feature| f.at(s0).max(f.at(s1));
    let bound = features.iter().map(highest).fold(f64::INFINITY, f64::min);
    features.retain(|f| f.least(s0, s1) <= bound);
}

/// Parameters where two features are equally near (NaN where they are not).
fn equal_at(a: Feature, b: Feature) -> [f64; 2] {
    match (a, b) {
        (Feature::Line { a, b }, Feature::Line { a: c, b: d }) => [(c - a) / (b - d), f64::NAN],
        (Feature::Line { a, b }, Feature::Corner { c, d, h })
        | (Feature::Corner { c, d, h }, Feature::Line { a, b }) => {
            // (a + b s)² = (c s - d)² + h²
            let (qa, qb, qc) = (b * b - c * c, 2.0 * (a * b + c * d), a * a - d * d - h * h);
            if qa == 0.0 {
                return [-qc / qb, f64::NAN];
            }
            let root = (qb * qb - 4.0 * qa * qc).sqrt();
            let s = -0.5 * (qb + qb.signum() * root);
            [s / qa, qc / s]
        }
        (Feature::Corner { c, d, h }, Feature::Corner { d: e, h: g, .. }) => {
            // Same piece, same c: the squares differ by a linear function.
            [((d * d + h * h) - (e * e + g * g)) / (2.0 * c * (d - e)), f64::NAN]
        }
    }
}
