//! Flow through a flat piece of a joint in space, between the stretches of its rim.
//!
//! The head is linear in a piece of one aperture that nothing feeds. With the middles `r_i` of the stretches of its rim from the centroid, their lengths
//! `l_i`, outward normals `n_i` in its plane, and its area `A`, the rates into it are
//!
//! ```text
//!     q = S h        S = N N^T/A + P X P        N: rows l_i n_i,    P = 1 - Q Q^T,    Q: orthonormal basis of (1, r)
//! ```
//!
//! times `w^3`: exact for every linear head, whatever the symmetric matrix `X` is; nothing flows where all heads are equal. The usual choice is
//! `X = 2 (mean l^2)/A`; a square then is the plain cross of four pipes. For the search of the wet part every `-S_ij` must be the conductance of a pipe,
//! nothing or more. So that number is moved to where this holds; where no number serves, as where two stretches share one side, `X` is looked for by
//! alternate projections on matrices of that form and on those without negative pipes. In triangles with an obtuse angle there is no choice (`P = 0`), and
//! very slender pieces have none that serves: what is negative then is left out, and [`Sheet::lost`] says how much it was.
//!
//! Source: mimetic differences, L. Beirao da Veiga, K. Lipnikov and G. Manzini, The Mimetic Finite Difference Method for Elliptic Problems (2014), with the
//! head in the middle of the piece eliminated.

use riprap_geom::Vec2;

/// A stretch of the rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Its middle from the centroid, m.
    pub middle: Vec2,
    /// Its length along the outward normal, m.
    pub normal: Vec2,
}

/// Pipes between the stretches of the rim of one piece.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// Two stretches and the conductance over the cube of the aperture; pairs ascending.
    pub pipes: Vec<(u16, u16, f64)>,
    /// What of the sum of all conductances, in size, would have been negative and is left out.
    pub lost: f64,
}

/// Directions shorter than this, over the size of the piece, are none.
const NO_DIRECTION: f64 = 1e-9;
/// Negative conductances smaller than this, over the largest, count as none.
const NEARLY: f64 = 1e-6;
/// Most turns of the search for them.
const MOST_TURNS: usize = 200;
/// Conductances smaller than this, over the largest, are round-off.
const ROUND_OFF: f64 = 1e-12;

/// The pipes of a piece of this `area` (m²).
#[must_use]
pub fn sheet(rim: &[Rim], area: f64) -> Sheet {
    let n = rim.len();
    let basis = basis(rim);
    let direct = |i: usize, j: usize| rim[i].normal.dot(rim[j].normal) / area;
    let rest = |i: usize, j: usize| -basis.iter().map(|q| q[i] * q[j]).sum::<f64>();
    let pairs = || (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)));
    let squares = rim.iter().map(|r| r.normal.length_squared()).sum::<f64>();
    let (mut low, mut high) = (0.0_f64, f64::INFINITY);
    for (i, j) in pairs() {
        let (s, p) = (direct(i, j), rest(i, j));
        if p < -ROUND_OFF {
            low = low.max(s / -p);
        } else if p > ROUND_OFF {
            high = high.min(-s / p);
        }
    }
    let usual = 2.0 * squares / (n as f64 * area);
    let serves = low <= high;
    let factor = if serves { usual.clamp(low, high) } else { usual };
    let mut matrix = Square::of(n, |i, j| {
        let own = if i == j { 1.0 } else { 0.0 };
        direct(i, j) + factor * (own + rest(i, j))
    });
    if !serves && n > 4 {
        let fixed = Square::of(n, direct);
        let free = Square::of(n, |i, j| rest(i, j) + if i == j { 1.0 } else { 0.0 });
        matrix.project(&fixed, &free);
    }
    let all: Vec<(usize, usize, f64)> = pairs().map(|(i, j)| (i, j, -matrix.at(i, j))).collect();
    let largest = all.iter().map(|p| p.2.abs()).fold(0.0, f64::max);
    let whole: f64 = all.iter().map(|p| p.2.abs()).sum();
    let negative = all.iter().map(|p| p.2).filter(|c| *c < -NEARLY * largest);
    let lost = negative.sum::<f64>().abs() / whole.max(f64::MIN_POSITIVE);
    let kept = all.into_iter().filter(|p| p.2 > ROUND_OFF * largest);
    Sheet { pipes: kept.map(|(i, j, c)| (i as u16, j as u16, c)).collect(), lost }
}

/// A square matrix, by rows.
struct Square {
    n: usize,
    list: Vec<f64>,
}

impl Square {
    fn of(n: usize, get: impl Fn(usize, usize) -> f64) -> Self {
        let list = (0..n * n).map(|k| get(k / n, k % n)).collect();
        Self { n, list }
    }

    fn at(&self, i: usize, j: usize) -> f64 {
        self.list[i * self.n + j]
    }

    fn times(&self, other: &Self) -> Self {
        Self::of(self.n, |i, j| (0..self.n).map(|k| self.at(i, k) * other.at(k, j)).sum())
    }

    /// Goes to the nearest matrix `fixed + free X free` whose entries beside the diagonal are not positive, by turns.
    fn project(&mut self, fixed: &Self, free: &Self) {
        for _ in 0..MOST_TURNS {
            let change = Self::of(self.n, |i, j| {
                let clipped = if i == j { self.at(i, j) } else { self.at(i, j).min(0.0) };
                clipped - fixed.at(i, j)
            });
            let inside = free.times(&change).times(free);
            *self = Self::of(self.n, |i, j| fixed.at(i, j) + inside.at(i, j));
            let size = self.list.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            let above = |k: &usize| k / self.n != k % self.n && self.list[*k] > 0.1 * NEARLY * size;
            if !(0..self.list.len()).any(|k| above(&k)) {
                return;
            }
        }
    }
}

/// Orthonormal basis of ones and of both coordinates of the middles.
fn basis(rim: &[Rim]) -> Vec<Vec<f64>> {
    let columns = [
        rim.iter().map(|_| 1.0).collect::<Vec<f64>>(),
        rim.iter().map(|r| r.middle.x).collect(),
        rim.iter().map(|r| r.middle.y).collect(),
    ];
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for column in columns {
        let size = dot(&column, &column).sqrt();
        let mut rest = column;
        // Twice: what is left of round-off goes, too.
        for q in basis.iter().chain(&basis) {
            let share = dot(q, &rest);
            rest.iter_mut().zip(q).for_each(|(r, q)| *r -= share * q);
        }
        let length = dot(&rest, &rest).sqrt();
        if length > NO_DIRECTION * size {
            basis.push(rest.iter().map(|r| r / length).collect());
        }
    }
    basis
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rim_of(corners: &[Vec2]) -> (Vec<Rim>, f64) {
        let n = corners.len();
        let next = |k: usize| corners[(k + 1) % n];
        let twice: f64 = (0..n).map(|k| corners[k].perp_dot(next(k))).sum();
        let centre =
            (0..n).map(|k| (corners[k] + next(k)) * corners[k].perp_dot(next(k))).sum::<Vec2>()
                / (3.0 * twice);
        let rim = (0..n).map(|k| Rim {
            middle: 0.5 * (corners[k] + next(k)) - centre,
            normal: -(next(k) - corners[k]).perp(),
        });
        (rim.collect(), 0.5 * twice)
    }

    /// Largest error of the rates of a linear head, over the largest rate.
    fn error(corners: &[Vec2]) -> (f64, Sheet) {
        let (rim, area) = rim_of(corners);
        let sheet = sheet(&rim, area);
        let mut worst = 0.0_f64;
        for slope in [Vec2::new(1.0, 0.0), Vec2::new(0.3, -2.0)] {
            let heads: Vec<f64> = rim.iter().map(|r| 5.0 + slope.dot(r.middle)).collect();
            let mut rates = vec![0.0; rim.len()];
            for &(i, j, c) in &sheet.pipes {
                let rate = c * (heads[i as usize] - heads[j as usize]);
                rates[i as usize] += rate;
                rates[j as usize] -= rate;
            }
            for (r, rate) in rim.iter().zip(rates) {
                let exact = slope.dot(r.normal);
                worst = worst.max((rate - exact).abs() / slope.length());
            }
        }
        (worst, sheet)
    }

    fn points<const N: usize>(list: [[f64; 2]; N]) -> [Vec2; N] {
        list.map(Vec2::from)
    }

    #[test]
    fn linear_heads_are_exact() {
        let shapes: [&[Vec2]; 5] = [
            &points([[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]]),
            // 60 deg.
            &points([[0.0, 0.0], [2.0, 0.0], [3.0, 3.0f64.sqrt()], [1.0, 3.0f64.sqrt()]]),
            // Acute.
            &points([[0.0, 0.0], [1.0, 0.1], [0.4, 0.9]]),
            // A side of a square that two stretches share.
            &points([[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]),
            &points([[0.0, 0.0], [2.0, 0.0], [2.5, 1.0], [1.0, 2.0], [-0.3, 1.0]]),
        ];
        for corners in shapes {
            let (error, sheet) = error(corners);
            assert!(error < 1e-5 && sheet.lost == 0.0, "{error:e} {corners:?} {sheet:?}");
            assert!(corners.len() > 4 || error < 1e-12, "{error:e} {corners:?}");
        }
    }

    #[test]
    fn a_square_is_a_cross_of_pipes() {
        let (rim, area) = rim_of(&points([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]));
        // Four pipes of conductance 2 to the middle make six of 1/2 without it.
        let all = sheet(&rim, area).pipes;
        assert_eq!(all.len(), 6);
        assert!(all.iter().all(|p| (p.2 - 0.5).abs() < 1e-14), "{all:?}");
    }

    #[test]
    fn what_an_obtuse_triangle_loses_is_told() {
        let (error, sheet) = error(&points([[0.0, 0.0], [2.0, 0.0], [0.2, 0.3]]));
        assert!(error > 1e-3 && sheet.lost > 1e-3, "{error} {sheet:?}");
        assert!(sheet.pipes.iter().all(|p| p.2 > 0.0));
    }
}
