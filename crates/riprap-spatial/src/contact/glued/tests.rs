//! Blocks of glued parts: against whole ones, at rest, in flight, in collision, after a restart, refused.

use std::collections::BTreeSet;

use riprap_geom::height_field::HeightField;
use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Quat, Vec3};

use crate::contact::terrain::tests::above_ground;
use crate::contact::tests::{Run, above_floor, brick};
use crate::exec::Exec;
use crate::kernel::glued::{Glued, Gluer, Placed, Touch};
use crate::kernel::surface::Walker;
use crate::kernel::terrain::Under;
use crate::kernel::{Body, Found, Pair, Pose, Reached, Shape, Terrain, turn};
use crate::laws::bolt::Design;
use crate::setup;
use crate::setup::error::BuildError;
use crate::setup::{BlockSpec, Setup, Solid};
use crate::state::world::World;

pub(in crate::contact) type Box3 = ([f64; 3], [f64; 3]);

/// A U, open upwards: base, left, right.
const U: [Box3; 3] = [
    ([0.0, 0.0, 0.0], [0.9, 0.3, 0.3]),
    ([0.0, 0.0, 0.3], [0.3, 0.3, 0.9]),
    ([0.6, 0.0, 0.3], [0.9, 0.3, 0.9]),
];

fn solid((low, high): Box3, shift: Vec3) -> Polyhedron {
    let [low, high] = [low, high].map(Vec3::from_array);
    Polyhedron::brick(0.5 * (low + high) + shift, 0.5 * (high - low))
}

pub(in crate::contact) fn glued(parts: &[Box3], shift: Vec3) -> BlockSpec {
    let parts = parts.iter().map(|part| {
        let solid = solid(*part, shift);
        Solid { vertices: solid.vertices, faces: solid.faces }
    });
    BlockSpec { shape: setup::Shape::Glued(parts.collect()), ..brick([0.0; 3], [1.0; 3]) }
}

/// Turns a block of parts about a point.
fn turned(mut block: BlockSpec, about: Vec3, by: Quat) -> BlockSpec {
    if let setup::Shape::Glued(parts) = &mut block.shape {
        for v in parts.iter_mut().flat_map(|part| &mut part.vertices) {
            *v = about + by * (*v - about);
        }
    }
    block
}

/// Force on the second of two blocks over 2 kn, and its moment about the origin.
fn force(blocks: [&Glued; 2], poses: [Pose; 2]) -> (Vec3, Vec3) {
    let placed = Placed { blocks, poses };
    let mut gluer = Gluer::default();
    gluer.place(&placed);
    let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
    for a in 0..blocks[0].pieces() {
        for b in 0..blocks[1].pieces() {
            if let Touch::Touching(sums, origin) = gluer.find(&placed, [a, b]) {
                force += sums.force;
                moment += sums.moment + origin.cross(sums.force);
            }
        }
    }
    (force, moment)
}

/// A bar of two bricks and a pillar, as an L: whatever touches only the bar feels the bar as one brick, at the seam too.
#[test]
fn a_seam_in_the_middle_of_a_contact_is_not_felt() {
    let (whole, pillar) = (([0.0, 0.0, 0.0], [3.0, 1.0, 1.0]), ([0.0, 0.0, 1.0], [0.6, 1.0, 3.0]));
    let parts = [([0.0, 0.0, 0.0], [1.7, 1.0, 1.0]), ([1.7, 0.0, 0.0], [3.0, 1.0, 1.0]), pillar];
    let parts = parts.map(|part| solid(part, Vec3::ZERO));
    let centre = Vec3::new(1.5, 0.5, 0.5);
    let l = Glued::new(&parts, centre).unwrap();
    let bar = Shape::new(&solid(whole, Vec3::ZERO), centre).unwrap();
    let tool = Shape::brick(Vec3::new(0.2, 0.3, 0.2)).unwrap();
    let mut walker = Walker::default();
    for k in 0..40 {
        let at = Vec3::new(1.2 + 0.025 * f64::from(k), 0.45, -0.19);
        let rotation = Quat::from_axis_angle(Vec3::new(0.6, 0.64, 0.48), 0.02 * f64::from(k));
        let poses = [Pose::at(centre), Pose { position: at, rotation }];
        let mut normals = [Vec::new(), Vec::new()];
        let turns = [
            turn(&bar, poses[0].rotation, &mut normals[0]),
            turn(&tool, poses[1].rotation, &mut normals[1]),
        ];
        let shapes = [&bar, &tool];
        let bodies = [0, 1].map(|s: usize| Body {
            shape: shapes[s],
            normals: &normals[s],
            turn: turns[s],
            position: poses[s].position,
        });
        let faces: Vec<u16> = (0..6).collect();
        let found = walker.find(&Pair {
            bodies: [&bodies[0], &bodies[1]],
            faces: [&faces, &faces],
            ties: true,
            hint: None,
            covered: [0; 2],
            witnesses: &[],
        });
        let Found::Touching(sums) = found else {
            panic!("{k}: {found:?}");
        };
        let (of_l, moment) = force([&l, &Glued::convex(&tool)], poses);
        let error = (of_l - sums.force).length() / sums.force.length();
        assert!(error < 1e-9, "{k}: {error:e}");
        let origin = crate::kernel::planes::origin(&bodies[0], &bodies[1]);
        let exact = sums.moment + origin.cross(sums.force);
        let error = (moment - exact).length() / sums.force.length();
        assert!(error < 1e-9, "{k}: {error:e}");
    }
}

/// The force is the gradient of an energy: no work along a closed way of a brick about the reflex edge of an L.
#[test]
fn a_closed_way_about_a_reflex_edge_takes_no_work() {
    let parts = [([0.0, 0.0, 0.0], [3.0, 1.0, 1.0]), ([0.0, 0.0, 1.0], [1.0, 1.0, 3.0])];
    let parts = parts.map(|part| solid(part, Vec3::ZERO));
    let l = Glued::new(&parts, Vec3::ZERO).unwrap();
    let tool = Glued::convex(&Shape::brick(Vec3::new(0.4, 0.3, 0.35)).unwrap());
    let rotation = Quat::from_axis_angle(Vec3::new(0.48, 0.6, 0.64), 0.5);
    let (mut work, mut all) = (0.0, 0.0);
    let steps = 4000;
    let place = |k: i32| {
        let angle = std::f64::consts::TAU * f64::from(k) / f64::from(steps);
        // It lies in the bar, the pillar, both and across the edge.
        Vec3::new(1.4, 0.5, 1.4) + 0.15 * Vec3::new(libm::cos(angle), 0.3, libm::sin(angle))
    };
    for k in 0..steps {
        let (from, to) = (place(k), place(k + 1));
        // Two points of Gauss in each step.
        for share in [0.5 - 0.75f64.sqrt() / 3.0, 0.5 + 0.75f64.sqrt() / 3.0] {
            let position = from + share * (to - from);
            let pose = Pose { position, rotation };
            let (on_tool, _) = force([&l, &tool], [Pose::at(Vec3::ZERO), pose]);
            let done = 0.5 * on_tool.dot(to - from);
            work += done;
            all += done.abs();
        }
    }
    assert!(all > 0.0 && work.abs() < 1e-7 * all, "{work:e} of {all:e}");
}

#[test]
fn a_table_stands_on_four_legs() {
    let mut run = Run::new(above_floor(vec![table()], 0.5, 0.3), 1, 5e-5);
    let volume = 1.2 * 0.8 * 0.1 + 4.0 * 0.006;
    let solid = run.world.solid_of(1);
    assert!((solid.mass / (2500.0 * volume) - 1.0).abs() < 1e-14);
    run.until(0.5);
    let weight = 2500.0 * volume * 9.81;
    let pair = &run.world.found.pairs[0];
    assert_eq!(pair.patches.len(), 4);
    for leg in &pair.patches {
        assert!((4.0 * leg.force.z / weight - 1.0).abs() < 1e-6, "{leg:?}");
        assert!((leg.area / 0.01 - 1.0).abs() < 1e-3, "{leg:?}");
    }
    assert!((pair.force().z / weight - 1.0).abs() < 1e-6);
    let (found, force) = run.view().contact_between(1, 0).unwrap();
    assert!((force.z / weight - 1.0).abs() < 1e-6 && (found.area - 0.04).abs() < 1e-4);
}

fn table() -> BlockSpec {
    let mut parts: Vec<Box3> = vec![([0.0, 0.0, 0.6], [1.2, 0.8, 0.7])];
    for (x, y) in [(0.0, 0.0), (1.1, 0.0), (0.0, 0.7), (1.1, 0.7)] {
        parts.push(([x, y, 0.0], [x + 0.1, y + 0.1, 0.6]));
    }
    glued(&parts, Vec3::new(-0.6, -0.4, 0.0))
}

/// What falls askew on its legs, slides and spins moves on 338 triangles as on one brick. The triangles of the middle lie under no leg.
#[test]
fn a_flat_terrain_is_a_floor_for_glued_parts() {
    let block = || {
        let tilt = Quat::from_rotation_x(0.1) * Quat::from_rotation_y(0.07);
        let mut block = turned(table(), Vec3::new(0.0, 0.0, 0.3), tilt);
        if let setup::Shape::Glued(parts) = &mut block.shape {
            let corners = parts.iter_mut().flat_map(|part| &mut part.vertices);
            corners.for_each(|v| v.z += 0.1);
        }
        block.velocity = Vec3::new(1.5, 0.3, 0.0);
        block.spin = Vec3::new(0.0, 0.0, 2.0);
        vec![block]
    };
    let mut floor = Run::new(above_floor(block(), 0.5, 0.0), 1, 5e-5);
    let mut ground = Run::new(above_ground(block(), 0.5, 0.0, 13, |_, _| 0.0), 1, 5e-5);
    let mut legs = BTreeSet::new();
    for k in 1..=80 {
        floor.until(0.005 * f64::from(k));
        ground.until(0.005 * f64::from(k));
        let [v, w] = [&floor, &ground].map(|run| run.world.bodies.velocity(1));
        // Impacts enlarge the last digits in which friction of sliding and spinning is found.
        assert!((v - w).length() < 1e-8, "{v} {w}");
        legs.extend(ground.patches([0, 1]).iter().map(|f| f.key));
    }
    assert!(legs.len() >= 2, "{legs:?}");
    let [a, b] = [&floor, &ground].map(|run| run.view().balance());
    assert!((a.works.friction / b.works.friction - 1.0).abs() < 1e-8);
    assert!(b.residual_relative().abs() < 1e-4);
}

/// With dashpots: four legs come to rest, each with its share of the weight.
#[test]
fn a_table_stands_on_terrain() {
    let mut run = Run::new(above_ground(vec![table()], 0.5, 0.3, 13, |_, _| 0.0), 1, 5e-5);
    run.until(0.5);
    let weight = run.world.solid_of(1).mass * 9.81;
    let facets = run.patches([0, 1]);
    assert_eq!(facets.len(), 4);
    for leg in facets {
        assert!((4.0 * leg.force.z / weight - 1.0).abs() < 1e-6, "{leg:?}");
        assert!((leg.area / 0.01 - 1.0).abs() < 1e-3, "{leg:?}");
    }
    assert!(run.world.bodies.velocity(1).length() < 1e-9);
}

/// Two bars glued end to end and a pillar, as an L, on rough ground: the bar feels it as one brick does, and the force is the gradient
/// of an energy.
#[test]
fn rough_ground_does_not_feel_seams_and_takes_no_work_along_a_closed_way() {
    let wave = |x: f64, y: f64| 0.1 * libm::sin(2.0 * x) * libm::cos(1.5 * y);
    let line: Vec<f64> = (0..=16).map(|k| -4.0 + 0.5 * f64::from(k)).collect();
    let field = HeightField::grid(&line, &line, |i, j| Some(wave(line[i], line[j]))).unwrap();
    let terrain = Terrain::new(field);
    let parts = [
        ([0.0, 0.0, 0.0], [1.7, 1.0, 1.0]),
        ([1.7, 0.0, 0.0], [3.0, 1.0, 1.0]),
        ([0.0, 0.0, 1.0], [0.6, 1.0, 3.0]),
    ];
    let parts = parts.map(|part| solid(part, Vec3::ZERO));
    let centre = Vec3::new(1.5, 0.5, 0.5);
    let l = Glued::new(&parts, centre).unwrap();
    let whole = solid(([0.0, 0.0, 0.0], [3.0, 1.0, 1.0]), Vec3::ZERO);
    let bar = Glued::convex(&Shape::new(&whole, centre).unwrap());
    let mut under = Under::default();
    let mut force = |block: &Glued, pose: &Pose| {
        let reached = under.find_glued(&terrain, block, pose, 1.0);
        assert_eq!(reached, Reached::Touching);
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        for on in &under.facets {
            force += on.sums.force;
            moment += on.sums.moment;
        }
        (force, moment)
    };
    let (mut work, mut all) = (0.0, 0.0);
    let steps = 2000;
    let rotation = Quat::from_axis_angle(Vec3::new(0.6, 0.64, 0.48), 0.06);
    // Upside down the L stands on its pillar, and its bar reaches into a hill.
    let over = Quat::from_rotation_y(2.6);
    let place = |k: i32, height: f64| {
        let angle = std::f64::consts::TAU * f64::from(k) / f64::from(steps);
        Vec3::new(0.2, 0.3, height) + 0.1 * Vec3::new(libm::cos(angle), 0.3, libm::sin(angle))
    };
    for k in 0..steps {
        let mut pose = Pose { position: place(k, 0.45), rotation };
        let [(f, m), (g, n)] = [&l, &bar].map(|block| force(block, &pose));
        assert!((f - g).length() < 1e-9 * g.length(), "{f} {g}");
        assert!((m - n).length() < 1e-9 * g.length(), "{m} {n}");
        pose.rotation = over;
        let (from, to) = (place(k, 1.3), place(k + 1, 1.3));
        for share in [0.5 - 0.75f64.sqrt() / 3.0, 0.5 + 0.75f64.sqrt() / 3.0] {
            pose.position = from + share * (to - from);
            let done = 0.5 * force(&l, &pose).0.dot(to - from);
            work += done;
            all += done.abs();
        }
    }
    assert!(all > 0.0 && work.abs() < 1e-6 * all, "{work:e} of {all:e}");
}

#[test]
fn an_l_rests_slides_and_is_stopped_by_friction() {
    let l = [([0.0, 0.0, 0.0], [0.9, 0.3, 0.3]), ([0.0, 0.0, 0.3], [0.3, 0.3, 0.9])];
    let mut block = glued(&l, Vec3::new(-0.5, 0.0, -1e-5));
    block.velocity = Vec3::new(0.8, 0.0, 0.0);
    let mut run = Run::new(above_floor(vec![block], 0.5, 0.3), 1, 5e-5);
    let start = run.place(1);
    run.until(0.6);
    let weight = 2500.0 * 5.0 * 0.027 * 9.81;
    let force = run.world.found.pairs[0].force();
    assert!((force.z / weight - 1.0).abs() < 1e-6, "{force}");
    let way = run.place(1).x - start.x;
    let exact = 0.8 * 0.8 / (2.0 * 0.5 * 9.81);
    assert!((way / exact - 1.0).abs() < 0.05, "{way} {exact}");
    assert!(run.view().balance().residual_relative().abs() < 1e-6);
}

fn interlocked() -> Setup {
    let first = glued(&U, Vec3::new(0.0, 0.0, 1.0));
    // The other one hangs with an arm in the opening, turned upside down and by a right angle.
    let about = Vec3::new(0.45, 0.15, 1.45);
    let half = Quat::from_axis_angle(Vec3::X, std::f64::consts::PI);
    let quarter = Quat::from_axis_angle(Vec3::Z, 1.45);
    let mut second = turned(glued(&U, Vec3::new(0.0, 0.0, 1.0)), about, quarter * half);
    if let setup::Shape::Glued(parts) = &mut second.shape {
        let corners = parts.iter_mut().flat_map(|part| &mut part.vertices);
        corners.for_each(|v| *v += Vec3::new(0.0, 0.0, 0.37));
    }
    second.velocity = Vec3::new(1.0, 0.2, 0.5);
    second.spin = Vec3::new(0.5, -1.0, 0.7);
    let mut setup = above_floor(vec![first, second], 0.0, 0.0);
    setup.gravity = Vec3::ZERO;
    setup
}

/// Momentum and angular momentum about the origin of blocks 1 and 2.
fn momenta(run: &Run) -> (Vec3, Vec3) {
    let (mut linear, mut angular) = (Vec3::ZERO, Vec3::ZERO);
    for b in 1..run.world.alive.len() {
        let solid = run.world.solid_of(b);
        let pose = run.world.pose(b);
        let turn = riprap_geom::Mat3::from_quat(pose.rotation);
        let spin = run.world.bodies.spin(b);
        let momentum = solid.mass * run.world.bodies.velocity(b);
        linear += momentum;
        angular +=
            pose.position.cross(momentum) + turn * (solid.inertia * (turn.transpose() * spin));
    }
    (linear, angular)
}

#[test]
fn interlocked_us_keep_energy_and_momentum() {
    let mut run = Run::new(interlocked(), 1, 2e-5);
    run.until(2e-5);
    let (linear, angular) = momenta(&run);
    let mut touched = 0;
    for k in 1..=40 {
        run.until(0.01 * f64::from(k));
        touched += u32::from(run.world.found.pairs.iter().any(|p| p.depth > 0.0));
    }
    let impacts = run.world.bodies.velocity(1).length();
    assert!(impacts > 0.1, "{touched} {impacts}");
    let (linear_now, angular_now) = momenta(&run);
    let error = (linear_now - linear).length() / linear.length();
    assert!(error < 1e-12, "{error:e}");
    let error = (angular_now - angular).length() / angular.length();
    assert!(error < 1e-5, "{error:e}");
    let residual = run.view().balance().residual_relative();
    assert!(residual.abs() < 1e-6, "{residual:e}");
}

#[test]
fn an_l_tumbles_freely() {
    let l = [([0.0, 0.0, 0.0], [0.9, 0.3, 0.3]), ([0.0, 0.0, 0.3], [0.3, 0.4, 0.9])];
    // They share a face only in part: one is wider.
    let mut block = glued(&l, Vec3::new(0.0, 0.0, 3.0));
    block.spin = Vec3::new(2.0, 3.0, -1.0);
    block.velocity = Vec3::new(0.1, 0.0, 0.0);
    let mut setup = above_floor(vec![block], 0.0, 0.0);
    setup.gravity = Vec3::ZERO;
    let mut run = Run::new(setup, 1, 1e-4);
    run.until(1e-4);
    let (linear, angular) = momenta(&run);
    run.until(1.0);
    let (linear_now, angular_now) = momenta(&run);
    assert!((linear_now - linear).length() < 1e-12 * linear.length());
    let error = (angular_now - angular).length() / angular.length();
    assert!(error < 1e-3, "{error:e}");
    let spin = run.world.bodies.spin(1);
    assert!((spin - Vec3::new(2.0, 3.0, -1.0)).length() > 0.1, "{spin}");
}

#[test]
fn laying_out_anew_changes_no_bit() {
    let mut setup = interlocked();
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    let [mut one, mut other] = [0, 1].map(|_| Run::new(setup.clone(), 1, 1e-4));
    one.until(0.15);
    other.until(0.05);
    other.until_laid_out_each_step(0.15);
    assert!(one.world.found.pairs.iter().any(|p| !p.patches.is_empty()));
    assert_eq!(one.world.hash(), other.world.hash());
    assert_eq!(one.world.found.pairs, other.world.found.pairs);
}

#[test]
fn what_takes_no_glued_parts_refuses_them_by_name() {
    let refused = |change: &dyn Fn(&mut Setup)| -> String {
        let mut setup = interlocked();
        change(&mut setup);
        let error = World::new(setup, Exec::serial()).unwrap_err();
        assert!(matches!(error, BuildError::Glued { .. }), "{error}");
        error.to_string()
    };
    let off = refused(&|setup| setup.found_contacts = false);
    assert!(off.starts_with("block `rock.2`, made of glued parts"), "{off}");
    let plane = setup::FaceSet::Plane { normal: Vec3::NEG_Z, offset: -1.0 };
    let boundary = refused(&|setup| {
        setup.boundaries.push(setup::Boundary {
            name: "side".into(),
            on: plane.clone(),
            kind: setup::BoundaryKind::Viscous { half_cell: true },
            in_situ: false,
        });
    });
    assert!(boundary.contains("[[boundaries]]"), "{boundary}");
    let bolted = |head: [f64; 3], toe: [f64; 3]| {
        move |setup: &mut Setup| {
            let elastic = f64::INFINITY;
            let design = Design {
                axial: 1e8,
                yields: elastic,
                hardening: 0.0,
                breaks: elastic,
                grout: 1e9,
                bond: elastic,
                grouted: elastic,
                plate: None,
                pretension: 0.0,
                dowel: None,
                piece: 0.1,
            };
            let [head, toe] = [head, toe].map(Vec3::from_array);
            setup.bolts.push(setup::Bolt { name: "bar".into(), head, toe, design });
        }
    };
    let through = refused(&bolted([0.15, 0.15, 3.0], [0.15, 0.15, 1.1]));
    assert!(through.contains("cannot be bolted"), "{through}");
    // Beside it and in the opening of the U bolts are none of its business.
    for (head, toe) in
        [([-1.5, -1.5, 0.0], [-1.5, -1.5, -0.8]), ([0.45, 0.15, 1.31], [0.45, 0.15, 1.35])]
    {
        let mut setup = interlocked();
        setup.blocks.truncate(2);
        bolted(head, toe)(&mut setup);
        let error = World::new(setup, Exec::serial()).err();
        assert!(!matches!(error, Some(BuildError::Glued { .. })), "{error:?}");
    }
}
