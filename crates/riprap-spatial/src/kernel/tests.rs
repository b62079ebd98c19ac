//! The law against closed forms, against all pairs of all faces, and along closed paths.

use riprap_geom::polyhedron::hull;
use riprap_geom::{Quat, Vec3};

use crate::kernel::frame::Frame;
use crate::kernel::kit::{Chance, KINDS, Kind, Placed, all_faces, overlapping};
use crate::kernel::piece::{Cutter, Polygon, UNTIED};
use crate::kernel::planes::{Planes, origin};
use crate::kernel::sums::integrate;
use crate::kernel::surface::Walker;
use crate::kernel::{Found, Pair, Pose, Shape, Sums};
use crate::lanes::Width;

mod closed_forms;

/// Depth integral with normal, moment and weight over all pieces of all pairs of faces, with no lists and no walk.
fn brute(placed: &Placed) -> (Vec3, Vec3, f64) {
    let [a, b] = placed.bodies();
    let mut planes = Planes::default();
    planes.gather_all([&a, &b], origin(&a, &b));
    let radius = a.shape.radius.min(b.shape.radius);
    let (mut cutter, mut polygon) = (Cutter::default(), Polygon::default());
    let (mut force, mut moment, mut weight) = (Vec3::ZERO, Vec3::ZERO, 0.0);
    for f in 0..planes.split {
        for g in planes.split..planes.len() {
            let Some(frame) = Frame::between(&planes, f, g, radius) else {
                continue;
            };
            if !cutter.make(&planes, &frame, [f, g], radius, UNTIED, &mut polygon) {
                continue;
            }
            let i = integrate(&polygon);
            let [e, h] = frame.axes;
            let first = frame.foot * i.depth + e * i.depth_first[0] + h * i.depth_first[1];
            force += i.depth * frame.normal;
            moment += first.cross(frame.normal);
            weight += i.depth;
        }
    }
    (force, moment, weight)
}

#[test]
fn the_walk_finds_what_all_pairs_of_faces_find() {
    let mut walker = Walker::default();
    for (seed, kind) in KINDS.into_iter().enumerate() {
        let mut chance = Chance::new(seed as u64 + 1);
        let mut pieces = 0;
        for _ in 0..1500 {
            let depth = 0.0005 * 60.0_f64.powf(chance.unit());
            let (shapes, poses) = overlapping(kind, depth, &mut chance);
            let placed = Placed::new([&shapes[0], &shapes[1]], poses);
            let sums = placed.touch(&mut walker);
            let (force, moment, weight) = brute(&placed);
            let scale = weight * shapes[0].radius;
            assert!((sums.weight - weight).abs() < 1e-11 * weight, "{kind:?}");
            assert!((sums.force - force).length() < 1e-11 * weight, "{kind:?}");
            assert!((sums.moment - moment).length() < 1e-11 * scale, "{kind:?}");
            assert_eq!(sums.unlabelled, 0);
            pieces += sums.pieces;
        }
        println!("{kind:?}: {:.2} pieces a pair", f64::from(pieces) / 1500.0);
    }
}

/// Two blocks about one middle, corners of each outside the other: the surface has two parts, and each of the faces of the smaller part has a
/// piece of the larger one too. The sums hung on the piece from which the walk began, and with it on the order of the blocks.
#[test]
fn blocks_deep_in_each_other_push_alike_wherever_the_walk_begins() {
    let h = 0.5;
    let cut_off = [
        [-h, -h, -h],
        [-h, -h, h],
        [-h, h, -h],
        [-h, h, h],
        [h, -h, -h],
        [h, -h, h],
        [h, h, -h],
        [h, 0.0078125, 0.0],
    ];
    let spiky = [
        [-h, -h, -h],
        [-h, h, -h],
        [h, h, h],
        [-h, -0.734375, 0.0],
        [0.0, 0.0546875, 0.6640625],
        [0.9765625, 0.0, 0.0],
        [0.046875, -0.375, 0.4765625],
        [-1.0, 0.0, 0.0],
    ];
    let shape = |points: [[f64; 3]; 8]| {
        let solid = hull(&points.map(Vec3::from_array)).unwrap();
        Shape::new(&solid, solid.moments().centroid).unwrap()
    };
    let shapes = [shape(cut_off), shape(spiky)];
    let placed = Placed::new([&shapes[0], &shapes[1]], [Pose::at(Vec3::ZERO); 2]);
    let (force, moment, weight) = brute(&placed);
    let bodies = placed.bodies();
    let faces = [all_faces(&shapes[0]), all_faces(&shapes[1])];
    let mut walker = Walker::default();
    for f in 0..shapes[0].faces() as u16 {
        for g in 0..shapes[1].faces() as u16 {
            let pair = Pair {
                bodies: [&bodies[0], &bodies[1]],
                faces: [&faces[0], &faces[1]],
                ties: true,
                hint: Some([f, g]),
                covered: [0; 2],
                witnesses: &[],
            };
            let Found::Touching(sums) = walker.find(&pair) else { panic!("they overlap") };
            assert!((sums.weight - weight).abs() < 1e-11 * weight, "{f} {g}");
            assert!((sums.force - force).length() < 1e-11 * weight, "{f} {g}");
            assert!((sums.moment - moment).length() < 1e-11 * weight, "{f} {g}");
        }
    }
}

/// Bricks with sides in one plane included, whose strips are tied, and blocks with more planes than registers have room for.
#[test]
fn wide_instructions_find_the_same_bits() {
    if !Width::detect().is_eight() {
        println!("this machine has no wide instructions: nothing to compare");
        return;
    }
    let (mut plain, mut wide) = (Walker::default(), Walker::default());
    wide.cutter.limit_width(Width::detect());
    let mut compare = |placed: &Placed| {
        let (first, second) = (placed.find_all(&mut plain), placed.find_all(&mut wide));
        assert_eq!(first, second);
        let Found::Touching(sums) = first else {
            return 0;
        };
        assert_eq!(plain.largest.label(), wide.largest.label());
        assert_eq!(plain.largest.depth(), wide.largest.depth());
        sums.pieces
    };
    let mut pieces = 0;
    // Two of the last kind have up to 40 planes, which is left to the plain form.
    for (seed, kind) in KINDS.into_iter().chain([Kind::Planes(20)]).enumerate() {
        let mut chance = Chance::new(seed as u64 + 11);
        for _ in 0..300 {
            let depth = 0.0005 * 400.0_f64.powf(chance.unit());
            let (shapes, poses) = overlapping(kind, depth, &mut chance);
            pieces += compare(&Placed::new([&shapes[0], &shapes[1]], poses));
        }
    }
    let shape = Shape::brick(Vec3::new(0.5, 0.25, 0.2)).unwrap();
    let mut chance = Chance::new(3);
    for _ in 0..300 {
        let shift = Vec3::new(chance.unit(), 1e-6 * (chance.unit() - 0.5), 0.4 - 1e-3);
        let turned =
            |chance: &mut Chance| Quat::from_axis_angle(chance.direction(), 1e-6 * chance.unit());
        let poses =
            [Vec3::ZERO, shift].map(|position| Pose { position, rotation: turned(&mut chance) });
        pieces += compare(&Placed::new([&shape, &shape], poses));
    }
    assert!(pieces > 3000, "{pieces}");
}

/// What one evaluation of a pair costs: `cargo test --release -p riprap-spatial --lib time_of_a_pair -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn time_of_a_pair() {
    let mut walker = Walker::default();
    for kind in KINDS {
        let mut chance = Chance::new(7);
        let scenes: Vec<_> = (0..200).map(|_| overlapping(kind, 0.001, &mut chance)).collect();
        let (mut tried, mut pieces, mut best) = (0, 0, f64::INFINITY);
        for _ in 0..15 {
            let mut hints = Vec::new();
            let placed: Vec<_> = (scenes.iter())
                .map(|(shapes, poses)| Placed::new([&shapes[0], &shapes[1]], *poses))
                .collect();
            let lists: Vec<_> = (scenes.iter())
                .map(|(shapes, _)| [all_faces(&shapes[0]), all_faces(&shapes[1])])
                .collect();
            for (placed, lists) in placed.iter().zip(&lists) {
                if let Found::Touching(sums) =
                    placed.find(&mut walker, [&lists[0], &lists[1]], None)
                {
                    hints.push(sums.hint);
                }
            }
            (tried, pieces) = (0, 0);
            let start = std::time::Instant::now();
            for ((placed, lists), hint) in placed.iter().zip(&lists).zip(&hints) {
                if let Found::Touching(sums) =
                    placed.find(&mut walker, [&lists[0], &lists[1]], *hint)
                {
                    tried += sums.tried;
                    pieces += sums.pieces;
                }
            }
            best = start.elapsed().as_secs_f64().min(best);
        }
        let each = |n: u32| f64::from(n) / 200.0;
        println!(
            "{kind:?}: {:.2} us, {:.2} pieces of {:.2} tried",
            best / 200.0 * 1e6,
            each(pieces),
            each(tried)
        );
    }
}

fn brick(x: f64, y: f64, z: f64) -> Shape {
    Shape::brick(0.5 * Vec3::new(x, y, z)).unwrap()
}

/// Sums of a pair of which the first lies still at the origin.
fn pressed(a: &Shape, b: &Shape, position: Vec3, rotation: Quat) -> Sums {
    let poses = [Pose::at(Vec3::ZERO), Pose { position, rotation }];
    Placed::new([a, b], poses).touch(&mut Walker::default())
}

fn near(found: f64, exact: f64, relative: f64) {
    assert!((found - exact).abs() <= relative * exact.abs(), "{found:e} instead of {exact:e}");
}

const DEPTHS: [f64; 3] = [1e-1, 1e-2, 1e-3];

/// Force over kn is twice the integral of the depth along the normal.
#[test]
fn rectangle_on_a_face() {
    let floor = brick(4.0, 4.0, 1.0);
    for (a, b) in [(1.0, 0.7), (0.8, 0.8), (2.0, 0.3)] {
        for d in DEPTHS {
            let at = Vec3::new(0.3, -0.2, 1.0 - d);
            let sums = pressed(&floor, &brick(a, b, 1.0), at, Quat::from_rotation_z(0.4));
            let exact = a * b * d - (a + b) * d * d / 2.0 + d * d * d / 3.0;
            near(2.0 * sums.force.z, exact, 1e-9);
            assert!(sums.force.truncate().length() < 1e-13);
            near(sums.vector_area.z, a * b, 1e-9);
            near(sums.depth, d, 1e-9);
        }
    }
}

#[test]
fn equal_faces() {
    let block = brick(1.0, 0.7, 1.0);
    for d in DEPTHS {
        let sums = pressed(&block, &block, Vec3::new(0.0, 0.0, 1.0 - d), Quat::IDENTITY);
        near(2.0 * sums.force.z, 0.7 * d - 1.7 * d * d / 2.0 + d * d * d / 3.0, 1e-9);
        assert!(sums.force.truncate().length() < 1e-14);
    }
}

#[test]
fn right_angled_edge_on_a_face() {
    let floor = brick(4.0, 4.0, 1.0);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for d in DEPTHS {
        let at = Vec3::new(0.0, 0.0, 0.5 + half - d);
        let sums = pressed(
            &floor,
            &brick(1.0, 1.0, 1.0),
            at,
            Quat::from_rotation_x(std::f64::consts::FRAC_PI_4),
        );
        let (tan, rho) = (1.0, half / (1.0 + half));
        let exact = 2.0 * rho * tan * d * d - 4.0 / 3.0 * rho * rho * tan * d * d * d;
        near(2.0 * sums.force.z, exact, 1e-9);
    }
}

#[test]
fn corner_of_a_cube_on_a_face() {
    let floor = brick(4.0, 4.0, 1.0);
    let upright = Quat::from_rotation_arc(Vec3::ONE.normalize(), Vec3::Z);
    for d in DEPTHS {
        let at = Vec3::new(0.1, 0.2, 0.5 + 0.75_f64.sqrt() - d);
        let sums = pressed(&floor, &brick(1.0, 1.0, 1.0), at, upright);
        near(2.0 * sums.force.z, (3.0 - 3.0_f64.sqrt()) / 2.0 * d * d * d, 1e-9);
        near(sums.vector_area.length(), 0.75 * 12.0_f64.sqrt() * d * d, 1e-9);
    }
}

#[test]
fn crossed_right_angled_edges() {
    let block = brick(2.0, 2.0, 2.0);
    let tilt = Quat::from_rotation_x(std::f64::consts::FRAC_PI_4);
    let across = Quat::from_rotation_z(std::f64::consts::FRAC_PI_2) * tilt;
    for d in DEPTHS {
        let poses = [
            Pose { position: Vec3::ZERO, rotation: tilt },
            Pose { position: Vec3::new(0.0, 0.0, 8.0_f64.sqrt() - d), rotation: across },
        ];
        let sums = Placed::new([&block, &block], poses).touch(&mut Walker::default());
        near(2.0 * sums.force.z, 2.0_f64.sqrt() / 3.0 * d * d * d, 1e-9);
        near(sums.vector_area.length(), 2.0 * d * d, 1e-9);
    }
}

/// A thin slab pushes back until it is pressed in to its whole thickness: `F/(kn A d) = 1 - P d/(4 A) + d²/(3 A)`, the numbers of the note.
#[test]
fn thin_slab() {
    let (floor, slab) = (brick(4.0, 4.0, 2.0), brick(1.0, 1.0, 0.05));
    for (share, noted) in [
        (0.1, 0.995),
        (0.25, 0.988),
        (0.5, 0.975),
        (0.6, 0.970),
        (0.8, 0.961),
        (0.9, 0.956),
        // At its whole thickness its upper side is in one plane with the surface.
        (0.9999, 0.951),
    ] {
        let d = 0.05 * share;
        let at = Vec3::new(0.0, 0.0, 1.025 - d);
        let ratio = 2.0 * pressed(&floor, &slab, at, Quat::IDENTITY).force.z / d;
        near(ratio, 1.0 - d + d * d / 3.0, 1e-9);
        assert!((ratio - noted).abs() <= 5e-4, "{ratio} at {share}");
    }
}

/// A block of 1 m on blocks up to 20 km large, 1e-6 m deep, beside their middles. The depth is as exact as its coordinate, half of the last
/// digit of the height of a block over the other, and the force as exact as the depth.
#[test]
fn far_apart_sizes_lose_no_digits() {
    let small = brick(1.0, 1.0, 1.0);
    for size in [2.0, 20.0, 200.0, 2000.0, 20_000.0] {
        let d = 1e-6;
        let large = brick(size, size, size);
        let at = Vec3::new(0.13 * size, -0.2 * size, 0.5 * size + 0.5 - d);
        let sums = pressed(&large, &small, at, Quat::IDENTITY);
        let exact = |d: f64| d - d * d + d * d * d / 3.0;
        // Both differences are exact.
        let placed = 0.5 - (at.z - 0.5 * size);
        println!("{size}: {:e}", 2.0 * sums.force.z / exact(placed) - 1.0);
        near(2.0 * sums.force.z, exact(placed), 1e-9);
        near(2.0 * sums.force.z, exact(d), 0.5 * f64::EPSILON * at.z / d + 1e-9);
    }
}

#[test]
fn exchanged_blocks_feel_opposite_forces() {
    let mut walker = Walker::default();
    for (seed, kind) in KINDS.into_iter().enumerate() {
        let mut chance = Chance::new(seed as u64 + 20);
        for _ in 0..100 {
            let (shapes, poses) = overlapping(kind, 0.01, &mut chance);
            let sums = Placed::new([&shapes[0], &shapes[1]], poses).touch(&mut walker);
            let other =
                Placed::new([&shapes[1], &shapes[0]], [poses[1], poses[0]]).touch(&mut walker);
            // Round-off of a coordinate on the whole surface.
            let allowed = 1e-14 * sums.area;
            assert!((sums.force + other.force).length() < allowed);
            assert!((sums.moment + other.moment).length() < allowed);
        }
    }
}

/// Work of the elastic wrench round closed paths in all six freedoms: none, to the error of the quadrature.
#[test]
fn no_work_is_done_round_closed_paths() {
    let mut walker = Walker::default();
    for (seed, kind) in KINDS.into_iter().enumerate() {
        let mut chance = Chance::new(seed as u64 + 40);
        for _ in 0..6 {
            let (shapes, poses) = overlapping(kind, 0.02, &mut chance);
            let amplitude: Vec<f64> = (0..12).map(|_| chance.between(-0.004, 0.004)).collect();
            let (mut sum, mut size) = (0.0, 0.0);
            let intervals = 2000;
            let step = std::f64::consts::TAU / f64::from(intervals);
            for n in 0..intervals {
                for gauss in [-0.5, 0.5] {
                    let tau = (f64::from(n) + 0.5 + gauss / 3.0_f64.sqrt()) * step;
                    let (s, c) = libm::sincos(tau);
                    let at = |k: usize| amplitude[k] * (c - 1.0) + amplitude[k + 6] * s;
                    let rate = |k: usize| -amplitude[k] * s + amplitude[k + 6] * c;
                    let [rx, ry] = [Quat::from_rotation_x(at(3)), Quat::from_rotation_y(at(4))];
                    let rotation = rx * ry * Quat::from_rotation_z(at(5)) * poses[1].rotation;
                    let spin = rate(3) * Vec3::X
                        + rx * (rate(4) * Vec3::Y)
                        + rx * (ry * (rate(5) * Vec3::Z));
                    let position = poses[1].position + Vec3::new(at(0), at(1), at(2));
                    let moved = [poses[0], Pose { position, rotation }];
                    let placed = Placed::new([&shapes[0], &shapes[1]], moved);
                    let super::Found::Touching(sums) = placed.find_all(&mut walker) else {
                        continue;
                    };
                    let moment = sums.moment + (placed.origin() - position).cross(sums.force);
                    let work =
                        sums.force.dot(Vec3::new(rate(0), rate(1), rate(2))) + moment.dot(spin);
                    sum += work;
                    size += work.abs();
                }
            }
            assert!(size > 0.0);
            assert!(sum.abs() < 1e-9 * size, "{kind:?}: {:e}", sum.abs() / size);
        }
    }
}
