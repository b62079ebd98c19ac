//! The largest ball inside both blocks, or the proof that they are apart.
//!
//! `max h  subject to  n_k . x + h <= d_k` for all planes of both blocks, by the dual simplex method in the four unknowns
//! (x, h). The basis has four planes with `sum l n = 0`, `sum l = 1`, `l >= 0`; it starts from a tetrahedron of planes far
//! away. In each pivot the most violated plane enters and the one with the smallest `l / mu` leaves, `mu` being the
//! barycentric coordinates of the entering normal. `h` only falls, so an optimum at or below zero, or a basis on the way
//! there, proves that the blocks are apart.

use riprap_geom::Vec3;

use super::planes::Planes;

/// A plane counts as violated beyond this, times `far`. No criterion of contact: it only ends the search.
const VIOLATED: f64 = 1e-13;
/// Barycentric coordinates below this are round-off and never choose the plane that leaves.
const PIVOT: f64 = 1e-10;
/// After so many pivots the plane with the lowest number enters and leaves (Bland's rule), which cannot cycle.
const BLAND: usize = 60;
/// Weights below this are round-off.
const WEIGHT: f64 = 1e-12;

/// What two blocks have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Peak {
    /// Nothing.
    Apart {
        /// They are at least so far from each other, m; 0 where that is not known.
        gap: f64,
        /// Unit vector from the first to the second, normal to a plane between them; zero where `gap` is 0 and none is known.
        axis: Vec3,
    },
    /// A ball fits into both.
    Overlap {
        /// Its radius, m.
        depth: f64,
        /// Its centre from the origin of the planes, m.
        at: Vec3,
        /// Planes of the first and of the second block (numbers in [`Planes`]) that hold it most: their piece of the surface of
        /// equal pressure is not empty. `None` when one block alone holds it.
        start: Option<[u16; 2]>,
    },
}

/// Four planes that hold the ball; numbers of planes from `usize::MAX` downward are those far away.
struct Basis {
    id: [usize; 4],
    n: [Vec3; 4],
    d: [f64; 4],
    /// Cofactors over the determinant: rows of the inverse of the differences to the first normal.
    inverse: [Vec3; 3],
    x: Vec3,
    h: f64,
}

impl Basis {
    fn far(offset: f64) -> Self {
        let c = 1.0 / 3.0_f64.sqrt();
        let n = [[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]]
            .map(|v| c * Vec3::from_array(v));
        let mut basis = Self {
            id: [usize::MAX - 3, usize::MAX - 2, usize::MAX - 1, usize::MAX],
            n,
            d: [offset; 4],
            inverse: [Vec3::ZERO; 3],
            x: Vec3::ZERO,
            h: 0.0,
        };
        basis.solve();
        basis
    }

    fn solve(&mut self) {
        let [n, m, k, l] = self.n;
        let (a, b, c) = (m - n, k - n, l - n);
        let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
        let scale = 1.0 / a.dot(bc);
        self.inverse = [scale * bc, scale * ca, scale * ab];
        self.x = (self.d[1] - self.d[0]) * self.inverse[0]
            + (self.d[2] - self.d[0]) * self.inverse[1]
            + (self.d[3] - self.d[0]) * self.inverse[2];
        self.h = self.d[0] - n.dot(self.x);
    }

    /// Coordinates c with `sum c n = v`, `sum c = 1`.
    fn barycentric(&self, v: Vec3) -> [f64; 4] {
        let arm = v - self.n[0];
        let [p, q, r] = self.inverse.map(|row| row.dot(arm));
        [1.0 - (p + q + r), p, q, r]
    }

    fn is_far(&self, position: usize) -> bool {
        self.id[position] >= usize::MAX - 3
    }

    /// The position whose plane leaves when one with this normal enters.
    fn leaving(&self, normal: Vec3, bland: bool) -> usize {
        let weights = self.barycentric(Vec3::ZERO);
        let entering = self.barycentric(normal);
        let mut best: Option<(f64, usize)> = None;
        for position in 0..4 {
            if entering[position] <= PIVOT {
                continue;
            }
            // A weight that is negative by round-off would send a plane away that holds the ball.
            let ratio = weights[position].max(0.0) / entering[position];
            // Among equals a far plane leaves first, then (Bland) the lowest number, else the surest pivot.
            let better = best.is_none_or(|(least, at)| {
                ratio < least
                    || ratio == least
                        && !self.is_far(at)
                        && (self.is_far(position)
                            || if bland {
                                self.id[position] < self.id[at]
                            } else {
                                entering[position] > entering[at]
                            })
            });
            if better {
                best = Some((ratio, position));
            }
        }
        // The coordinates add up to 1, so one is at least a quarter.
        best.map_or(0, |(_, position)| position)
    }
}

/// The plane that cuts deepest into the ball, or the first one that does.
fn entering(planes: &Planes, basis: &Basis, tolerance: f64, bland: bool) -> Option<usize> {
    let mut worst = tolerance;
    let mut plane = None;
    let (x, h) = (basis.x, basis.h);
    for k in 0..planes.len() {
        let over = (planes.x[k] * x.x + planes.y[k] * x.y + planes.z[k] * x.z) + h - planes.d[k];
        if over > worst && !basis.id.contains(&k) {
            plane = Some(k);
            if bland {
                break;
            }
            worst = over;
        }
    }
    plane
}

/// The largest ball inside both blocks. `far` is four times the sum of their radii, m.
///
/// # Panics
/// Never; a search that does not end (round-off) gives what its last basis proves.
#[must_use]
pub fn peak(planes: &Planes, far: f64) -> Peak {
    let mut basis = Basis::far(far);
    let tolerance = VIOLATED * far;
    for pivot in 0..BLAND + 20 * planes.len() {
        let bland = pivot >= BLAND;
        let Some(k) = entering(planes, &basis, tolerance, bland) else {
            break;
        };
        let position = basis.leaving(planes.normal(k), bland);
        basis.id[position] = k;
        basis.n[position] = planes.normal(k);
        basis.d[position] = planes.d[k];
        basis.solve();
    }
    verdict(planes, &basis)
}

fn verdict(planes: &Planes, basis: &Basis) -> Peak {
    let weights = basis.barycentric(Vec3::ZERO);
    if basis.h > 0.0 {
        let mut start = [(WEIGHT, None); 2];
        for (position, &weight) in weights.iter().enumerate() {
            let id = basis.id[position];
            let side = usize::from(id >= planes.split);
            if weight > start[side].0 && !basis.is_far(position) {
                start[side] = (weight, Some(id as u16));
            }
        }
        return Peak::Overlap {
            depth: basis.h,
            at: basis.x,
            start: start[0].1.zip(start[1].1).map(|(f, g)| [f, g]),
        };
    }
    let mut axis = Vec3::ZERO;
    let mut exact = true;
    for (position, &weight) in weights.iter().enumerate() {
        // What a far plane still holds is proved of the tetrahedron at the start, not of the blocks.
        if basis.is_far(position) {
            exact &= weight <= WEIGHT;
        } else if basis.id[position] < planes.split {
            axis += weight * basis.n[position];
        }
    }
    // For x in A: axis . x <= sum over A of l d; for x in B: axis . x >= -(sum over B of l d); their difference is -h.
    let length = axis.length();
    if exact && length > WEIGHT {
        Peak::Apart {
            gap: -basis.h / length,
            axis: axis / length,
        }
    } else {
        Peak::Apart {
            gap: 0.0,
            axis: Vec3::ZERO,
        }
    }
}

#[cfg(test)]
mod tests {
    use riprap_geom::Quat;

    use super::*;
    use crate::found::{Body, Pose, Shape, planes, turn};

    fn of(shapes: [&Shape; 2], poses: [Pose; 2]) -> (Peak, Planes, Vec3) {
        let mut normals = [Vec::new(), Vec::new()];
        let turns = [0, 1].map(|s: usize| turn(shapes[s], poses[s].rotation, &mut normals[s]));
        let bodies = [0, 1].map(|s| Body {
            shape: shapes[s],
            normals: &normals[s],
            turn: turns[s],
            position: poses[s].position,
        });
        let mut lists = Planes::default();
        let origin = planes::origin(&bodies[0], &bodies[1]);
        lists.gather_all([&bodies[0], &bodies[1]], origin);
        let far = 4.0 * (shapes[0].radius + shapes[1].radius);
        (peak(&lists, far), lists, origin)
    }

    #[test]
    fn bricks_face_to_face_at_any_gap() {
        let shape = Shape::brick(Vec3::new(0.5, 0.4, 0.3)).unwrap();
        for gap in [1e-9, 1e-3, 0.1, 1.0] {
            let poses = [
                Pose::at(Vec3::new(7.0, -3.0, 2.0)),
                Pose::at(Vec3::new(7.0, -2.9, 2.6 + gap)),
            ];
            let (Peak::Apart { gap: found, axis }, ..) = of([&shape, &shape], poses) else {
                panic!("they are apart")
            };
            assert!((found - gap).abs() < 1e-14, "{found} for {gap}");
            assert!((axis - Vec3::Z).length() < 1e-14);
        }
    }

    #[test]
    fn overlapping_bricks_hold_a_ball_of_half_the_depth() {
        let shape = Shape::brick(Vec3::new(0.5, 0.4, 0.3)).unwrap();
        let poses = [
            Pose::at(Vec3::ZERO),
            Pose::at(Vec3::new(0.1, 0.1, 0.6 - 0.01)),
        ];
        let (Peak::Overlap { depth, start, .. }, lists, _) = of([&shape, &shape], poses) else {
            panic!("they overlap")
        };
        assert!((depth - 0.005).abs() < 1e-15);
        let [f, g] = start.unwrap().map(usize::from);
        assert_eq!([lists.normal(f), lists.normal(g)], [Vec3::Z, -Vec3::Z]);
    }

    #[test]
    fn sizes_of_one_to_ten_thousand() {
        let small = Shape::brick(Vec3::splat(0.5)).unwrap();
        let large = Shape::brick(Vec3::splat(5000.0)).unwrap();
        for d in [-1e-3, 1e-3] {
            let poses = [
                Pose::at(Vec3::new(0.0, 0.0, -5000.0)),
                Pose::at(Vec3::new(1234.0, 567.0, 0.5 + d)),
            ];
            match of([&large, &small], poses).0 {
                Peak::Apart { gap, .. } => assert!(d > 0.0 && (gap - d).abs() < 1e-11),
                Peak::Overlap { depth, .. } => assert!(d < 0.0 && (depth + 0.5 * d).abs() < 1e-11),
            }
        }
    }

    /// Distance of the separating plane against the corners, and the ball against the planes.
    #[test]
    fn random_turned_bricks_are_judged_rightly() {
        let mut seed = 1_u64;
        let mut unit = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut apart, mut overlap) = (0, 0);
        for _ in 0..2000 {
            let mut shape =
                || Shape::brick(Vec3::new(0.2 + unit(), 0.2 + unit(), 0.2 + unit()) / 2.0);
            let shapes = [shape().unwrap(), shape().unwrap()];
            let mut pose = || {
                let q = [unit(), unit(), unit(), unit()].map(|u| 2.0 * u - 1.0);
                Pose {
                    position: 1.2 * Vec3::new(unit(), unit(), unit()),
                    rotation: Quat::from_array(q).normalize(),
                }
            };
            let poses = [pose(), pose()];
            match of([&shapes[0], &shapes[1]], poses).0 {
                Peak::Apart { gap, axis } => {
                    apart += 1;
                    let reach = |s: usize, axis: Vec3| {
                        let along = |v: &Vec3| axis.dot(poses[s].place(*v));
                        let all = shapes[s].vertices.iter().map(along);
                        all.fold(f64::NEG_INFINITY, f64::max)
                    };
                    let between = -reach(1, -axis) - reach(0, axis);
                    assert!(between >= gap - 1e-12, "{between} {gap}");
                    assert!(gap > 0.0);
                }
                Peak::Overlap { depth, at, .. } => {
                    overlap += 1;
                    let (_, lists, _) = of([&shapes[0], &shapes[1]], poses);
                    let room = |k: usize| lists.d[k] - lists.normal(k).dot(at);
                    let least = (0..lists.len()).map(room).fold(f64::INFINITY, f64::min);
                    assert!((least - depth).abs() < 1e-11);
                }
            }
        }
        assert!(apart > 300 && overlap > 300, "{apart} {overlap}");
    }
}
