//! Exact integrals of Coulomb friction over a polygon under a traction that is linear in it.
//!
//! Two faces that turn on each other about a centre `c` of their plane rub at every point along `n x u`, with `u = (x - c)/|x - c|`. Force,
//! moment and their derivatives follow from
//!
//! ```text
//! value = int p |x - c| dS,   pull = int p u dS,   stiffness = int p u uᵀ/|x - c| dS.
//! ```
//!
//! Edge by edge: with the distance h of `c` from an edge, s along it and `R² = h² + s²`, the triangle from `c` to the edge has
//! `int p r dA = h int R (p_c/3 + (p - p_c)/4) ds`, and the others alike; all end in `asinh(s/h)`, R and powers of s.

use crate::kernel::piece::Polygon;
use crate::lanes::{LANES, Lanes};

/// An edge whose line passes nearer by a point than this, times its length, makes no triangle with it.
const THROUGH: f64 = 1e-14;

/// The integrals about a centre of rotation, in the coordinates of the polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Lever {
    /// Of traction times distance, N m for tractions in Pa.
    pub(crate) value: f64,
    /// Of traction times the unit vector away from the centre, N.
    pub(crate) pull: [f64; 2],
    /// Of `p u uᵀ/|x - c|`: ss, st and tt, N/m.
    pub(crate) stiffness: [f64; 3],
}

impl Lever {
    /// Adds another one.
    pub(crate) fn add(&mut self, other: &Self) {
        self.value += other.value;
        self.pull = [0, 1].map(|i| self.pull[i] + other.pull[i]);
        self.stiffness = [0, 1, 2].map(|i| self.stiffness[i] + other.stiffness[i]);
    }

    /// The same along other axes, given in those of now.
    #[must_use]
    pub(crate) fn turned(&self, axes: [[f64; 2]; 2]) -> Self {
        let [ss, st, tt] = self.stiffness;
        let entry = |[i, k]: [usize; 2]| {
            let (a, b) = (axes[i], axes[k]);
            ss * a[0] * b[0] + st * (a[0] * b[1] + a[1] * b[0]) + tt * a[1] * b[1]
        };
        Self {
            value: self.value,
            pull: axes.map(|e| e[0] * self.pull[0] + e[1] * self.pull[1]),
            stiffness: [[0, 0], [0, 1], [1, 1]].map(entry),
        }
    }
}

/// An edge seen from the centre.
struct Edge {
    /// Distance of its line, with the sign of the triangle to it, and its ends along the line, m.
    height: f64,
    ends: [f64; 2],
    /// Distances of its ends, m.
    reach: [f64; 2],
    /// Unit vectors: outward (for a positive height) and along.
    axes: [[f64; 2]; 2],
}

impl Edge {
    /// `None` where it makes no triangle with the centre.
    fn new(from: [f64; 2], to: [f64; 2]) -> Option<Self> {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = (dx * dx + dy * dy).sqrt();
        if length <= 0.0 {
            return None;
        }
        let along = [dx / length, dy / length];
        let outward = [along[1], -along[0]];
        // With its sign: triangles of edges that turn their back on the centre count as negative, so that it may lie outside.
        let height = from[0] * outward[0] + from[1] * outward[1];
        if height.abs() < THROUGH * length {
            return None;
        }
        let first = from[0] * along[0] + from[1] * along[1];
        let ends = [first, first + length];
        Some(Self {
            height,
            ends,
            reach: ends.map(|s| (height * height + s * s).sqrt()),
            axes: [outward, along],
        })
    }

    /// `asinh(s/h)` between the ends, from the side on which nothing cancels.
    fn angle(&self) -> f64 {
        let ([a, b], [ra, rb]) = (self.ends, self.reach);
        libm::log(if a >= 0.0 {
            (b + rb) / (a + ra)
        } else if b <= 0.0 {
            (ra - a) / (rb - b)
        } else {
            (b + rb) * (ra - a) / (self.height * self.height)
        })
    }

    /// Adds the triangle to this edge; the traction is `centre` at the centre of rotation and rises by `slope` along the axes.
    fn add(&self, centre: f64, slope: [f64; 2], to: &mut Lever) {
        let (h, [a, b], [ra, rb]) = (self.height, self.ends, self.reach);
        let angle = self.angle();
        let square = h * h;
        // int s/R, s²/R, R, s R; that of 1/R is the angle.
        let first = rb - ra;
        let second = 0.5 * ((b * rb - a * ra) - square * angle);
        let whole = 0.5 * ((b * rb - a * ra) + square * angle);
        let lifted = (rb * rb * rb - ra * ra * ra) / 3.0;
        let [across, along] = slope;
        to.value += h * (centre * whole / 3.0 + (across * h * whole + along * lifted) / 4.0);
        let half = 0.5 * centre * h;
        let third = h / 3.0;
        let n = half * h * angle + third * h * (across * h * angle + along * first);
        let t = half * first + third * (across * h * first + along * second);
        let [e, g] = self.axes;
        to.pull[0] += n * e[0] + t * g[0];
        to.pull[1] += n * e[1] + t * g[1];
        // h² int 1/R³, int s/R³, s²/R³, s³/R³, with the traction halved away from the centre.
        let cosine = b / rb - a / ra;
        let inverse = 1.0 / ra - 1.0 / rb;
        let bent = angle - cosine;
        let cubic = first - square * inverse;
        let (level, rise) = (centre + 0.5 * across * h, 0.5 * along);
        let nn = h * (level * cosine + rise * square * inverse);
        let nt = square * (level * inverse + rise * bent);
        let tt = h * (level * bent + rise * cubic);
        for (sum, [i, k]) in to.stiffness.iter_mut().zip([[0, 0], [0, 1], [1, 1]]) {
            *sum += nn * e[i] * e[k] + nt * (e[i] * g[k] + e[k] * g[i]) + tt * g[i] * g[k];
        }
    }
}

/// Integrals over a polygon about `at` (plane coordinates, m) under the traction `share[0]` times the depth plus `share[1]`.
#[must_use]
pub(crate) fn lever(polygon: &Polygon, at: [f64; 2], share: [f64; 2]) -> Lever {
    let [w, u, v] = polygon.slope;
    let centre = share[0] * (w - u * at[0] - v * at[1]) + share[1];
    let slope = [-share[0] * u, -share[0] * v];
    let (s, t) = (polygon.s(), polygon.t());
    let mut sum = Lever::default();
    let n = polygon.len();
    for i in 0..n {
        let next = if i + 1 < n { i + 1 } else { 0 };
        let corner = |k: usize| [s[k] - at[0], t[k] - at[1]];
        if let Some(edge) = Edge::new(corner(i), corner(next)) {
            let own = edge.axes.map(|e| slope[0] * e[0] + slope[1] * e[1]);
            edge.add(centre, own, &mut sum);
        }
    }
    sum
}

/// Points of Gauss and Legendre on [0, 1] with their weights: the lower half, and the middle one where there is one.
const POINTS: [&[[f64; 2]]; 3] = [
    &[
        [0.069_431_844_202_973_71, 0.173_927_422_568_726_9],
        [0.330_009_478_207_571_87, 0.326_072_577_431_273_05],
    ],
    &[
        [0.033_765_242_898_423_975, 0.085_662_246_189_585_25],
        [0.169_395_306_766_867_7, 0.180_380_786_524_069_3],
        [0.380_690_406_958_401_5, 0.233_956_967_286_345_52],
    ],
    &[
        [0.015_919_880_246_186_957, 0.040_637_194_180_787_32],
        [0.081_984_446_336_682_06, 0.090_324_080_347_428_74],
        [0.193_314_283_649_704_77, 0.130_305_348_201_467_72],
        [0.337_873_288_298_095_54, 0.156_173_538_520_001_26],
        [0.5, 0.165_119_677_500_629_9],
    ],
];
/// Eight points of the unit square that stands for a triangle: both coordinates of each, and its weight.
type Packet = [Lanes; 3];

/// All points of a list of `count` along one side by those of the other. Behind the last one it stands again, without a weight.
const fn packets<const N: usize>(half: &[[f64; 2]], count: usize) -> [Packet; N] {
    let mut packets = [[Lanes([0.0; LANES]); 3]; N];
    let mut at = 0;
    while at < N * LANES {
        let there = at < count * count;
        let k = if there { at } else { count * count - 1 };
        let ([x, along], [y, across]) =
            (point(half, count, k / count), point(half, count, k % count));
        let packet = &mut packets[at / LANES];
        packet[0].0[at % LANES] = x;
        packet[1].0[at % LANES] = y;
        // The triangle narrows towards its first corner.
        packet[2].0[at % LANES] = if there { x * along * across } else { 0.0 };
        at += 1;
    }
    packets
}

/// Point `k` of a list of which the lower half is given, and its weight.
const fn point(half: &[[f64; 2]], count: usize, k: usize) -> [f64; 2] {
    let upper = 2 * k >= count;
    let [x, weight] = half[if upper { count - 1 - k } else { k }];
    // The middle one of an odd number is 1/2.
    [if upper { 1.0 - x } else { x }, weight]
}

static FOUR: [Packet; 2] = packets(POINTS[0], 4);
static SIX: [Packet; 5] = packets(POINTS[1], 6);
static NINE: [Packet; 11] = packets(POINTS[2], 9);
/// Lists of points, and the ratio up to which they do: the error of n points along a side is some `(ratio/2)^(2 n)`, since the place that does not
/// move lies at that distance over half the side.
static ENOUGH: [(&[Packet], f64); 3] = [(&FOUR, 0.0178), (&SIX, 0.1), (&NINE, FAR)];
/// A centre of rotation whose distance is more than the extent of the surface over this is far: the integrals about it lose digits with the cube
/// of its distance, and points take their place.
pub(crate) const FAR: f64 = 0.32;

/// Hands out points of a polygon from `at` (plane coordinates, m) by eights, each with what it carries of the traction `share[0]` times the depth
/// plus `share[1]`. `ratio`: extent of the surface over the distance of the centre of rotation, at most [`FAR`].
#[inline(always)]
pub(crate) fn for_points(
    polygon: &Polygon,
    ratio: f64,
    at: [f64; 2],
    share: [f64; 2],
    mut to: impl FnMut(Lanes, [Lanes; 2]),
) {
    let [w, u, v] = polygon.slope;
    let (s, t) = (polygon.s(), polygon.t());
    let corner = |k: usize| [s[k] - at[0], t[k] - at[1]];
    let level = Lanes::all(share[0] * (w - u * at[0] - v * at[1]) + share[1]);
    let (along_s, along_t) = (Lanes::all(share[0] * u), Lanes::all(share[0] * v));
    let list = ENOUGH.iter().position(|(_, most)| ratio <= *most);
    let (packets, _) = ENOUGH[list.unwrap_or(ENOUGH.len() - 1)];
    for i in 1..polygon.len().saturating_sub(1) {
        let [a, b, c] = [corner(0), corner(i), corner(i + 1)];
        let [ab, bc] = [[b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]];
        let twice = Lanes::all(ab[0] * bc[1] - ab[1] * bc[0]);
        let place = |k: usize, x: Lanes, y: Lanes| {
            Lanes::all(a[k]) + x * (Lanes::all(ab[k]) + y * Lanes::all(bc[k]))
        };
        for &[x, y, weight] in packets {
            let (s, t) = (place(0, x, y), place(1, x, y));
            let traction = level - (along_s * s + along_t * t);
            to(twice * weight * traction, [s, t]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every integral over `[0, 2] x [0, 1]` under a traction that grows along it, about places inside, on the rim and outside, against sums
    /// over small squares.
    #[test]
    fn integrals_are_those_of_small_squares() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
        let polygon = Polygon::of(corners, [1.0, -3.0, 0.5]);
        let share = [0.7, 0.4];
        for at in [[1.2, 0.4], [0.0, 0.5], [2.0, 1.0], [-1.5, 3.0], [40.0, -7.0]] {
            let mut sum = Lever::default();
            let n = 500;
            let side = 1.0 / f64::from(n);
            for i in 0..2 * n {
                for k in 0..n {
                    let place = [i, k].map(|i| (f64::from(i) + 0.5) * side);
                    let traction = share[0] * (1.0 + 3.0 * place[0] - 0.5 * place[1]) + share[1];
                    let p = traction * side * side;
                    let arm = [0, 1].map(|i| place[i] - at[i]);
                    let r = (arm[0] * arm[0] + arm[1] * arm[1]).sqrt().max(1e-9);
                    let u = arm.map(|x| x / r);
                    let stiffness = [u[0] * u[0], u[0] * u[1], u[1] * u[1]];
                    sum.add(&Lever {
                        value: p * r,
                        pull: u.map(|x| p * x),
                        stiffness: stiffness.map(|x| p * x / r),
                    });
                }
            }
            let found = lever(&polygon, at, share);
            let near =
                |a: f64, b: f64, slack: f64| assert!((a - b).abs() < slack, "{at:?} {a} {b}");
            near(found.value, sum.value, 1e-5 * sum.value);
            for (a, b) in found.pull.into_iter().zip(sum.pull) {
                near(a, b, 1e-4);
            }
            // 1/r is summed badly near the centre.
            for (a, b) in found.stiffness.into_iter().zip(sum.stiffness) {
                near(a, b, 3e-2);
            }
        }
    }

    /// Mean radius of uniform pressure on rectangles 1:1, 2:1 and 10:1, over their radius of gyration.
    #[test]
    fn mean_radius_of_rectangles() {
        for (a, exact) in [(1.0, 0.9372), (2.0, 0.9190), (10.0, 0.8727)] {
            let corners = [[0.0, 0.0], [a, 0.0], [a, 1.0], [0.0, 1.0]];
            let polygon = Polygon::of(corners, [1.0, 0.0, 0.0]);
            let gyration = ((a * a + 1.0) / 12.0_f64).sqrt();
            let all = lever(&polygon, [0.5 * a, 0.5], [1.0, 0.0]);
            let ratio = all.value / (a * gyration);
            assert!((ratio - exact).abs() < 5e-5, "{ratio}");
            assert!(all.pull[0].abs() + all.pull[1].abs() < 1e-12);
        }
    }
}
