//! The largest ball inside both blocks, or the proof that they are apart.
//!
//! `max h  subject to  n_k . x + h <= d_k` for all planes of both blocks, by the dual simplex method in the four unknowns
//! (x, h). The basis has four planes with `sum l n = 0`, `sum l = 1`, `l >= 0`; it starts from a tetrahedron of planes far
//! away. In each pivot the most violated plane enters and the one with the smallest `l / mu` leaves, `mu` being the
//! barycentric coordinates of the entering normal. `h` only falls, so an optimum at or below zero, or a basis on the way
//! there, proves that the blocks are apart.
//!
//! Where blocks go on along one joint plane, planes of both are parallel but for round-off, and four of them can meet in a point that
//! round-off alone determines. Such a basis is solved with iterative refinement, and its verdict is checked against all planes: a ball that
//! does not fit is none.

use riprap_geom::Vec3;

use crate::kernel::planes::Planes;

/// A plane counts as violated beyond this, times `far`. No criterion of contact: it only ends the search.
const VIOLATED: f64 = 1e-13;
/// Barycentric coordinates below this are round-off and never choose the plane that leaves.
const PIVOT: f64 = 1e-10;
/// After so many pivots the plane with the lowest number enters and leaves (Bland's rule), which cannot cycle.
const BLAND: usize = 60;
/// Weights below this are round-off.
const WEIGHT: f64 = 1e-12;
/// A basis whose inverse has longer rows is refined: unrefined it misses its planes by this times round-off.
const ILL: f64 = 1e3;
/// Refinements of such a basis. Each takes off as many digits of the error as the basis leaves of an f64.
const REFINEMENTS: usize = 2;
/// A weight of an ill-conditioned basis that is more negative than this proves nothing.
const NEGATIVE: f64 = -1e-6;

/// What two blocks have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Peak {
    /// Nothing.
    Apart {
        /// They are at least so far from each other, m; 0 where that is not known.
        gap: f64,
        /// Unit vector from the first to the second, normal to a plane between them; zero where `gap` is 0 and none is known.
        axis: Vec3,
    },
    /// Round-off hides whether they have anything in common: no ball was found that fits into both, nor a proof that there is none.
    Unsure,
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
    /// Whether its normals are so near to dependent that its solutions are refined.
    ill: bool,
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
            ill: false,
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
        self.ill = self.inverse.iter().any(|row| row.length() > ILL);
        if self.ill {
            self.refine();
        }
    }

    /// Solves for what the planes of the basis are missed by.
    #[cold]
    fn refine(&mut self) {
        for _ in 0..REFINEMENTS {
            let (x, h) = (self.x, self.h);
            let left: [f64; 4] = std::array::from_fn(|k| (self.d[k] - h) - self.n[k].dot(x));
            let step = (left[1] - left[0]) * self.inverse[0]
                + (left[2] - left[0]) * self.inverse[1]
                + (left[3] - left[0]) * self.inverse[2];
            self.h += left[0] - self.n[0].dot(step);
            self.x += step;
        }
    }

    /// Coordinates c with `sum c n = v`, `sum c = 1`.
    fn barycentric(&self, v: Vec3) -> [f64; 4] {
        let arm = v - self.n[0];
        let [p, q, r] = self.inverse.map(|row| row.dot(arm));
        let coordinates = [1.0 - (p + q + r), p, q, r];
        if self.ill { self.refined(coordinates, v) } else { coordinates }
    }

    /// Barycentric coordinates of `v`, refined.
    #[cold]
    fn refined(&self, mut c: [f64; 4], v: Vec3) -> [f64; 4] {
        for _ in 0..REFINEMENTS {
            let (mut left, mut rest) = (v, 1.0);
            for (c, n) in c.iter().zip(self.n) {
                left -= *c * n;
                rest -= *c;
            }
            let arm = left - rest * self.n[0];
            let [p, q, r] = self.inverse.map(|row| row.dot(arm));
            for (c, more) in c.iter_mut().zip([rest - (p + q + r), p, q, r]) {
                *c += more;
            }
        }
        c
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
pub(crate) fn peak(planes: &Planes, far: f64) -> Peak {
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

/// Radius of the largest ball about `x` inside all planes, m.
fn room(planes: &Planes, x: Vec3) -> f64 {
    let of = |k: usize| planes.d[k] - planes.normal(k).dot(x);
    (0..planes.len()).map(of).fold(f64::INFINITY, f64::min)
}

fn verdict(planes: &Planes, basis: &Basis) -> Peak {
    let weights = basis.barycentric(Vec3::ZERO);
    // Of a basis that round-off determines nothing is believed that does not hold for all planes.
    let depth = if basis.ill { room(planes, basis.x).min(basis.h) } else { basis.h };
    let proved = weights.iter().all(|weight| *weight > NEGATIVE);
    let shared = depth > 0.0;
    if basis.ill && !shared && !(basis.h <= 0.0 && proved) {
        return Peak::Unsure;
    }
    if depth > 0.0 {
        let mut start = [(WEIGHT, None); 2];
        for (position, &weight) in weights.iter().enumerate() {
            let id = basis.id[position];
            let side = usize::from(id >= planes.split);
            if weight > start[side].0 && !basis.is_far(position) {
                start[side] = (weight, Some(id as u16));
            }
        }
        return Peak::Overlap {
            depth,
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
        Peak::Apart { gap: -basis.h / length, axis: axis / length }
    } else {
        Peak::Apart { gap: 0.0, axis: Vec3::ZERO }
    }
}

#[cfg(test)]
mod tests {
    use riprap_geom::Quat;

    use super::*;
    use crate::kernel::{Body, Pose, Shape, planes, turn};

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
            let poses =
                [Pose::at(Vec3::new(7.0, -3.0, 2.0)), Pose::at(Vec3::new(7.0, -2.9, 2.6 + gap))];
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
        let poses = [Pose::at(Vec3::ZERO), Pose::at(Vec3::new(0.1, 0.1, 0.6 - 0.01))];
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
                Peak::Unsure => panic!("{d}"),
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
                Peak::Unsure => panic!("two bricks at random are not along one plane"),
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

    /// Two blocks of a jointed rock mass that meet along an edge, their joint planes apart by 1e-12 and turned by as much: the four planes that
    /// meet there determine a point only but for round-off. Taken from a run that was stopped for blocks "pressed 2.2e-6 m into each other".
    #[test]
    fn planes_that_are_one_but_for_round_off_hold_no_ball() {
        const PLANES: [[f64; 4]; 12] = [
            [1.0, 6.9953250604037e-15, 9.70278279056129e-14, 1.6017298096109522],
            [-9.702782790561446e-14, 2.2390698151739426e-13, 1.0, 0.019177490668374597],
            [9.712636729018313e-14, -0.08715574274788115, -0.9961946980917259, 1.3816540631548255],
            [-9.699191616155628e-14, 0.08715574274788128, 0.9961946980917259, -0.01933144483413951],
            [-0.9361168066628484, -0.34071865342163615, -0.0871557427476726, -0.5082819795729836],
            [-0.3368240888334552, 0.925416578398282, -0.17364817766717017, 0.23245235402503972],
            [0.3368240888334552, -0.925416578398282, 0.1736481776671703, 1.6223191940943837],
            [-7.798741958017852e-13, 1.12301417130574e-11, 1.0, 0.019177490670480246],
            [7.469969413174206e-13, -0.08715574275884516, -0.9961946980907668, 0.01933144483201894],
            [-0.9361168066629071, -0.340718653422268, -0.08715574274457025, 0.8279052242720311],
            [0.9361168066629074, 0.3407186534222682, 0.0871557427445647, 0.5082819795729608],
            [-0.33682408883301285, 0.9254165783964887, -0.17364817767758461, 0.23245235402502556],
        ];
        let mut planes = Planes::default();
        planes.begin();
        for [x, y, z, d] in PLANES {
            planes.push_plane(Vec3::new(x, y, z), d);
        }
        planes.split = 7;
        match peak(&planes, 8.0 * 0.8667) {
            Peak::Apart { .. } | Peak::Unsure => {}
            Peak::Overlap { depth, .. } => assert!(depth < 1e-11, "{depth}"),
        }
    }

    /// Blocks between the planes of joint sets, each turned and shifted by 1e-16 to 1e-2 of its size: whatever round-off does to a basis, a ball
    /// that is said to be in both blocks fits, and blocks that are said to be apart have no larger one.
    #[test]
    fn verdicts_on_blocks_along_common_planes_hold() {
        let mut seed = 7_u64;
        let mut unit = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut overlaps, mut apart, mut unsure) = (0, 0, 0);
        for _ in 0..20_000 {
            let planes = along_common_planes(&mut unit);
            match peak(&planes, 8.0) {
                Peak::Overlap { depth, at, .. } => {
                    overlaps += 1;
                    let least = room(&planes, at);
                    assert!(least > depth - 1e-11, "{least:e} {depth:e}");
                }
                Peak::Apart { gap, axis } if gap > 0.0 => {
                    apart += 1;
                    assert!(axis.is_normalized());
                }
                Peak::Apart { .. } => apart += 1,
                Peak::Unsure => unsure += 1,
            }
        }
        assert!(overlaps > 2000 && apart > 2000, "{overlaps} {apart}");
        assert!(unsure < 400, "{unsure}");
    }

    /// Planes of two cells between planes of three to five joint sets at whole distances.
    fn along_common_planes(unit: &mut impl FnMut() -> f64) -> Planes {
        let vector = |unit: &mut dyn FnMut() -> f64| loop {
            let v = Vec3::new(unit(), unit(), unit()) * 2.0 - Vec3::ONE;
            if v.length() > 0.1 && v.length() < 1.0 {
                return v.normalize();
            }
        };
        let sets: Vec<Vec3> = (0..3 + (3.0 * unit()) as usize)
            .map(|k| match k {
                0..3 if unit() < 0.5 => Vec3::AXES[k],
                _ => vector(unit),
            })
            .collect();
        let first = 5.0 * vector(unit);
        let second = first + (0.3 + 1.5 * unit()) * vector(unit);
        let mut planes = Planes::default();
        planes.begin();
        for point in [first, second] {
            planes.split = planes.len();
            let size = libm::pow(10.0, 14.0 * unit() - 16.0);
            let (turn, shift) = (size * vector(unit), size * vector(unit));
            for normal in &sets {
                let below = normal.dot(point).floor();
                for (side, offset) in [(1.0, below + 1.0), (-1.0, -below)] {
                    let n = side * *normal;
                    let turned = (n + turn.cross(n)).normalize();
                    let room = offset - n.dot(point);
                    planes.push_plane(turned, room + turned.dot(point + shift - first));
                }
            }
        }
        planes
    }
}
