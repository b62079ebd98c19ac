//! Depth of a straight piece below any simple boundary: exact integrals.
//!
//! The depth is the distance to the nearest edge or corner. Along the piece each edge contributes a
//! linear part where the foot of the perpendicular lies on it and a hyperbola beyond its ends. The
//! piece is split at all kinks; between them one feature is nearest and the integral is closed.

use riprap_geom::Vec2;

use super::convex::Side;

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

#[derive(Clone, Copy)]
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
                    let log = if h > 0.0 {
                        h * h * libm::asinh(u / h)
                    } else {
                        0.0
                    };
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
        return Feature::Line {
            a: sign * a,
            b: sign * b,
        };
    };
    let direction = q - p;
    let c = direction.length();
    let unit = direction / c;
    Feature::Corner {
        c,
        d: unit.dot(corner - p),
        h: unit.perp_dot(corner - p).abs(),
    }
}

/// Depth integrals of the piece `p q` (relative to the centroid of `block`) below `block`'s listed
/// edges. `kinks` is scratch.
pub(crate) fn along(block: Side<'_>, p: Vec2, q: Vec2, kinks: &mut Vec<f64>) -> Depths {
    kinks.clear();
    kinks.extend([0.0, 1.0]);
    let mut add = |s: f64| {
        if s > 0.0 && s < 1.0 {
            kinks.push(s);
        }
    };
    for &m in block.nearest {
        let m = m as usize;
        let (start, normal) = (block.turned[m].start, block.turned[m].normal);
        let (a0, a1) = (normal.perp().dot(p - start), normal.perp().dot(q - start));
        add(a0 / (a0 - a1));
        add((a0 - block.turned[m].length) / (a0 - a1));
        let (d0, d1) = (normal.dot(p - start), normal.dot(q - start));
        add(d0 / (d0 - d1));
    }
    kinks.sort_by(f64::total_cmp);
    let feet = kinks.len();
    for w in 0..feet - 1 {
        let (s0, s1) = (kinks[w], kinks[w + 1]);
        let middle = 0.5 * (s0 + s1);
        for (k, &m) in block.nearest.iter().enumerate() {
            let a = feature(block, m, p, q, middle);
            for &o in &block.nearest[..k] {
                let b = feature(block, o, p, q, middle);
                for s in equal_at(a, b) {
                    if s > s0 && s < s1 {
                        kinks.push(s);
                    }
                }
            }
        }
    }
    kinks.sort_by(f64::total_cmp);
    let mut sum = Depths::default();
    for w in kinks.windows(2) {
        let (s0, s1) = (w[0], w[1]);
        if s1 <= s0 {
            continue;
        }
        let middle = 0.5 * (s0 + s1);
        let nearest = block
            .nearest
            .iter()
            .map(|&m| feature(block, m, p, q, middle))
            .min_by(|a, b| a.at(middle).total_cmp(&b.at(middle)));
        if let Some(f) = nearest {
            let (i, m) = f.integrals(s0, s1);
            sum.integral += i;
            sum.first_moment += m;
            sum.peak = sum.peak.max(f.at(s0)).max(f.at(s1));
        }
    }
    sum.integral = sum.integral.max(0.0);
    sum
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
            [
                ((d * d + h * h) - (e * e + g * g)) / (2.0 * c * (d - e)),
                f64::NAN,
            ]
        }
    }
}
