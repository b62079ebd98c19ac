//! How fast the pressure of a contact falls as one block moves along it.
//!
//! Where an edge or a tip presses on another one, the overlap shrinks as soon as one of them passes beside the other: the energy of the
//! pressure has a maximum there, and the pressure pushes them apart with a negative stiffness of the size of the normal one. The rate of
//! the force is exact: piece (f, g) of the surface, with the area P, moves by `h = -n_g . u / l`, `l = |n_f - n_g|`, along its normal m when B moves by u, and an
//! edge e of it by `s_e` in its plane:
//!
//! ```text
//! d/du int p m dS = sum m [ -(n_f . m) h P + sum_e s_e int_e p ds ]
//!
//!   edge made by plane k of A, q = n_k - n_f:   s_e = -(q . m) h / r         r: length of q along the plane
//!   edge made by plane k of B, q = n_k - n_g:   s_e = (q . u - (q . m) h) / r
//! ```
//!
//! (depths p instead of pressures; edges on the boundary of the overlap have none).

use riprap_geom::{Mat3, Vec3};

use crate::kernel::frame::Frame;
use crate::kernel::piece::{BOUNDARY, OPEN, Polygon};
use crate::kernel::planes::Planes;
use crate::kernel::sums::Sums;

/// The negative stiffness of a surface is at most this, times the square of its depth over its width, of the normal one (`cos² b/sin b` for two
/// edges of the half angle b, whose surface is `1/cos b` times as wide as deep).
const WIDE: f64 = 8.0;

/// Rate of the integral of depth times normal over a piece with the displacement of the second block, m².
pub(super) fn rate(planes: &Planes, frame: &Frame, polygon: &Polygon, [f, g]: [usize; 2]) -> Mat3 {
    let (of_f, of_g, m) = (planes.normal(f), planes.normal(g), frame.normal);
    let length = (of_f - of_g).length();
    let n = polygon.len();
    let (s, t, depth, label) = (polygon.s(), polygon.t(), polygon.depth(), polygon.label());
    let mut twice = 0.0;
    let mut moved = Vec3::ZERO;
    for i in 0..n {
        let next = if i + 1 < n { i + 1 } else { 0 };
        twice += s[i] * t[next] - s[next] * t[i];
        if label[i] == OPEN || label[i] == BOUNDARY {
            continue;
        }
        let k = label[i] as usize;
        let of_a = k < planes.split;
        let q = planes.normal(k) - if of_a { of_f } else { of_g };
        let across = q.dot(m);
        let along = (q - across * m).length();
        if along <= 0.0 {
            continue;
        }
        let (ds, dt) = (s[next] - s[i], t[next] - t[i]);
        let carried = 0.5 * (depth[i] + depth[next]) * (ds * ds + dt * dt).sqrt() / along;
        moved += (carried * across / length) * of_g;
        if !of_a {
            moved += carried * q;
        }
    }
    moved += (of_f.dot(m) * 0.5 * twice / length) * of_g;
    // Columns of the dyad of m and what moves it.
    Mat3::from_cols(moved.x * m, moved.y * m, moved.z * m)
}

/// Whether a surface may be so narrow that its pressure pushes aside what presses, with at least `least` times the normal stiffness.
pub(super) fn is_narrow(sums: &Sums, least: f64) -> bool {
    let centre = sums.area_first / sums.area;
    let [x, y, z] = sums.area_second;
    let of = |column: Vec3, k: usize| column - sums.area * centre[k] * centre;
    let (x, y, z) = (of(x, 0), of(y, 1), of(z, 2));
    // The moments along the surface are the larger two of three, the smallest is about nothing.
    let trace = x.x + y.y + z.z;
    let minors = x.x * y.y - x.y * x.y + y.y * z.z - y.z * y.z + z.z * x.x - z.x * z.x;
    let smaller = 0.5 * (trace - (trace * trace - 4.0 * minors).max(0.0).sqrt());
    // Of a strip of the width w it is A w²/12.
    12.0 * smaller * least < WIDE * sums.area * sums.depth * sums.depth
}

/// Negative stiffness of a pressure along its surface over the normal stiffness kn, m², from the rate of its integral of depth times
/// normal, which is `force`: of the worst direction, at the normal force that is there. 0 where the pressure holds.
pub(super) fn falls(rate: &Mat3, force: Vec3) -> f64 {
    let length = force.length();
    if length.is_nan() || length <= 0.0 {
        return 0.0;
    }
    let normal = force / length;
    // The matrix of second derivatives of the energy over kn; symmetric but for round-off.
    let energy = |a: Vec3, b: Vec3| -(a.dot(*rate * b) + b.dot(*rate * a));
    let [_, e, h] = riprap_geom::polyhedron::frame(normal);
    let (mut ee, mut eh, mut hh) = (energy(e, e), energy(e, h), energy(h, h));
    let across = energy(normal, normal);
    if across > 0.0 {
        // What gives way across goes on beside it.
        let (ne, nh) = (energy(normal, e), energy(normal, h));
        ee -= ne * ne / across;
        eh -= ne * nh / across;
        hh -= nh * nh / across;
    }
    let half = 0.5 * (ee - hh);
    let least = 0.5 * (ee + hh) - (half * half + eh * eh).sqrt();
    (-least).max(0.0)
}

#[cfg(test)]
mod tests {
    use riprap_geom::Quat;
    use riprap_geom::polyhedron::hull;

    use super::*;
    use crate::kernel::kit::{Chance, KINDS, Placed, overlapping};
    use crate::kernel::surface::Walker;
    use crate::kernel::{Pose, Shape};

    /// Against differences of the force itself, of random pairs.
    #[test]
    fn the_rate_of_the_force_is_exact() {
        let mut walker = Walker::default();
        for (seed, kind) in KINDS.into_iter().enumerate() {
            let mut chance = Chance::new(seed as u64 + 5);
            let mut off = Vec::new();
            for _ in 0..100 {
                let (shapes, poses) = overlapping(kind, 0.02, &mut chance);
                let shapes = [&shapes[0], &shapes[1]];
                let area = Placed::new(shapes, poses).touch(&mut walker).area;
                let rate = walker.rate();
                let mut worst = 0.0_f64;
                for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
                    let [before, after] = [-1e-8, 1e-8].map(|way| {
                        let moved = Pose { position: poses[1].position + way * axis, ..poses[1] };
                        Placed::new(shapes, [poses[0], moved]).touch(&mut walker).force
                    });
                    worst = worst.max(((after - before) / 2e-8 - rate * axis).length());
                }
                off.push(worst / area);
            }
            off.sort_by(f64::total_cmp);
            // Single pairs stand where a piece comes or goes between both places.
            assert!(off[95] < 1e-5, "{kind:?} {:?}", &off[90..]);
        }
    }

    /// A prism whose edge of the half angle `b` looks along `out` (1 or -1) x, and where the edge is from its centre.
    fn prism(b: f64, out: f64) -> (Shape, Vec3) {
        let (back, side) = (-out, b.tan());
        let corners = [-0.5, 0.5]
            .map(|y| [Vec3::new(0.0, y, 0.0), Vec3::new(back, y, side), Vec3::new(back, y, -side)]);
        let solid = hull(&corners.concat()).unwrap();
        let centre = Vec3::new(0.7 * back, 0.0, 0.0);
        (Shape::new(&solid, centre).unwrap(), -centre)
    }

    /// A body whose place `edge` is at `at`.
    fn with_edge(edge: Vec3, at: Vec3, rotation: Quat) -> Pose {
        Pose { position: at - rotation * edge, rotation }
    }

    /// Two equal edges of the length L with the depth d: the overlap is a rhombus with the diagonals d and d tan b, and the second derivative of its
    /// energy across is `-kn L d cos b`. They stand a little aside: right above each other, round-off chooses for each half of the surface which block's
    /// edge ends it, and where the choices differ the rate belongs to neither.
    #[test]
    fn edges_fall_aside_as_the_closed_form_says() {
        let mut walker = Walker::default();
        let turn = Quat::from_axis_angle(Vec3::new(0.3, -0.5, 0.8).normalize(), 0.7);
        for degrees in [10.0_f64, 30.0, 45.0, 60.0, 75.0] {
            let (b, d) = (degrees.to_radians(), 1e-4);
            let [(first, of_first), (second, of_second)] = [prism(b, 1.0), prism(b, -1.0)];
            let poses = [
                with_edge(of_first, Vec3::ZERO, turn),
                with_edge(of_second, turn * Vec3::new(-d, 0.0, 1e-5 * d), turn),
            ];
            let sums = Placed::new([&first, &second], poses).touch(&mut walker);
            let found = falls(&walker.rate(), sums.force);
            assert!((found / (d * b.cos()) - 1.0).abs() < 1e-3, "{degrees} {found}");
            assert!(is_narrow(&sums, b.cos() * b.cos() / b.sin()));
        }
    }

    /// An edge on a face slides along it freely, also a tilted one.
    #[test]
    fn an_edge_on_a_face_does_not_fall_aside() {
        let mut walker = Walker::default();
        let ((edge, at), floor) = (prism(0.6, 1.0), Shape::brick(Vec3::splat(2.0)).unwrap());
        let tilt = Quat::from_axis_angle(Vec3::Y, 0.3);
        let poses = [with_edge(at, Vec3::new(0.001, 0.3, -0.2), tilt), Pose::at(2.0 * Vec3::X)];
        let sums = Placed::new([&edge, &floor], poses).touch(&mut walker);
        assert!(falls(&walker.rate(), sums.force) < 1e-9 * sums.area);
    }
}
