//! Blocks on terrain in the engine: against a floor of one brick and on slopes; threads and restart; the ledger.

use riprap_geom::height_field::HeightField;
use riprap_geom::{Quat, Vec3};

use crate::contact::tests::{Run, above_floor, brick, turned};
use crate::exec::Exec;
use crate::setup::{BlockSpec, Setup, Shape, Surface};
use crate::state::found::FoundPair;
use crate::state::scratch::Scratch;

/// Instead of the floor a grid over a square of 8 m.
pub(crate) fn above_ground(
    blocks: Vec<BlockSpec>,
    friction: f64,
    damping: f64,
    cells: usize,
    height: impl Fn(f64, f64) -> f64,
) -> Setup {
    let mut setup = above_floor(blocks, friction, damping);
    let line: Vec<f64> = (0..=cells).map(|k| -4.0 + 8.0 * k as f64 / cells as f64).collect();
    let field = HeightField::grid(&line, &line, |i, j| Some(height(line[i], line[j]))).unwrap();
    setup.blocks[0].shape =
        Shape::Terrain(Box::new(Surface { points: field.points, triangles: field.triangles }));
    // Terrain needs no support.
    setup.supports.clear();
    setup
}

/// A block that falls askew, slides and spins: the same motion on 338 triangles as on one brick.
#[test]
fn a_flat_terrain_is_a_floor() {
    let blocks = || {
        let tilt = Quat::from_rotation_x(0.1) * Quat::from_rotation_y(0.07);
        let mut falling = turned([-0.9, -0.25, 0.1], [0.5, 0.6, 0.3], tilt);
        falling.velocity = Vec3::new(1.5, 0.3, 0.0);
        falling.spin = Vec3::new(0.0, 0.0, 2.0);
        let mut second = brick([1.5, 1.0, 0.0001], [0.5, 0.6, 0.3]);
        second.velocity = Vec3::new(-1.0, 0.0, 0.0);
        vec![falling, second]
    };
    let mut floor = Run::new(above_floor(blocks(), 0.5, 0.2), 1, 1e-4);
    let mut ground = Run::new(above_ground(blocks(), 0.5, 0.2, 13, |_, _| 0.0), 1, 1e-4);
    floor.until(0.4);
    ground.until(0.4);
    for b in [1, 2] {
        let way = floor.place(b) - floor.world.reference[b];
        assert!(way.length() > 0.1);
        let [v, w] = [&floor, &ground].map(|run| run.world.bodies.velocity(b));
        assert!((v - w).length() < 1e-9, "{v} {w}");
        assert!((floor.place(b) - ground.place(b)).length() < 1e-9);
    }
    let [a, b] = [&floor, &ground].map(|run| run.view().balance());
    assert!((a.works.friction / b.works.friction - 1.0).abs() < 1e-8);
    assert!(b.residual_relative().abs() < 1e-4, "{:e}", b.residual_relative());
    let force = floor.world.found.pairs.iter().find(|p| p.ends == [0, 2]);
    let force = force.map_or(Vec3::ZERO, FoundPair::force);
    let facet = &ground.patches([0, 2])[0];
    assert!((facet.force - force).length() < 1e-9 * force.length());
}

/// Blocks that come to terrain from outside, below its surface: at an edge, at a corner, at a notch of its rim, and one that has gone
/// over the rim and hits the side below. None makes energy; each goes back.
#[test]
fn what_comes_from_outside_meets_a_wall() {
    let come = |at: [f64; 3], velocity: [f64; 3], turn: f64| {
        let mut block = turned(at, [0.5, 0.6, 0.4], Quat::from_rotation_z(turn));
        block.velocity = Vec3::from_array(velocity);
        let hills = |x: f64, y: f64| 0.1 * libm::sin(3.0 * x) * libm::cos(2.0 * y);
        let mut setup = above_ground(vec![block], 0.0, 0.0, 16, hills);
        setup.gravity = Vec3::ZERO;
        let mut run = Run::new(setup, 1, 5e-5);
        let start = run.view().kinetic_energy();
        run.until(0.35);
        let most = run.view().balance();
        let loss = most.residual().abs() / start;
        assert!(loss < 2e-3, "{at:?}: {loss:e}");
        let kinetic = run.view().kinetic_energy();
        assert!((kinetic / start - 1.0).abs() < 5e-3, "{at:?}: {kinetic} {start}");
        let (before, after) = (Vec3::from_array(velocity), run.world.bodies.velocity(1));
        assert!(after.dot(before) < 0.0, "{at:?}: {after}");
    };
    come([-5.2, 0.3, -0.3], [4.0, 0.0, 0.0], 0.2);
    come([-5.0, -5.0, -0.35], [3.0, 3.0, 0.0], 0.0);
    come([1.0, 4.8, -3.0], [0.0, -4.0, 0.0], 0.4);
}

/// On 30 degrees: slides as fast as it should at 20 degrees of friction, stays at 31.
#[test]
fn a_block_on_a_slope() {
    let angle = 30_f64.to_radians();
    let (sine, cosine) = libm::sincos(angle);
    let run = |friction: f64, time: f64| {
        let rotation = Quat::from_rotation_y(-angle);
        let normal = rotation * Vec3::Z;
        let stiffness = 1e9 * 2.0 / (cosine + 1.0);
        let depth = 2500.0 * 0.5 * 9.81 * cosine / stiffness;
        let mut block = turned([0.0; 3], [1.0, 0.8, 0.5], rotation);
        let at = Vec3::new(0.9, 0.1, 0.9 * sine / cosine) + (0.25 - depth) * normal;
        if let Shape::Polyhedron(solid) = &mut block.shape {
            let middle = Vec3::new(0.5, 0.4, 0.25);
            solid.vertices.iter_mut().for_each(|v| *v += at - middle);
        }
        let slope = |x: f64, _| x * sine / cosine;
        let friction = libm::tan(f64::to_radians(friction));
        let mut run = Run::new(above_ground(vec![block], friction, 0.2, 11, slope), 1, 1e-4);
        run.until(0.5 * time);
        let (place, velocity) = (run.place(1), run.world.bodies.velocity(1));
        run.until(time);
        let gained = run.world.bodies.velocity(1) - velocity;
        (gained / (0.5 * time), run.place(1) - place)
    };
    let (acceleration, way) = run(20.0, 0.3);
    let down = Vec3::new(-cosine, 0.0, -sine);
    let exact = 9.81 * (sine - cosine * libm::tan(20_f64.to_radians()));
    assert!((acceleration.dot(down) / exact - 1.0).abs() < 1e-5, "{acceleration} {exact}");
    assert!(way.y.abs() < 1e-9 && way.length() > 0.05, "{way}");
    let (_, way) = run(31.0, 0.4);
    assert!(way.length() < 1e-9, "{:e}", way.length());
}

/// In a notch both flanks resist: with a half angle of 45 degrees sliding needs sqrt 2 times the slope.
#[test]
fn both_flanks_of_a_notch_resist() {
    let stays = |slope: f64| {
        let rotation = Quat::from_rotation_x(std::f64::consts::FRAC_PI_4);
        let mut block = turned([-0.2; 3], [0.4; 3], rotation);
        if let Shape::Polyhedron(solid) = &mut block.shape {
            let up = 0.2 * 2.0_f64.sqrt() - 2e-6;
            solid.vertices.iter_mut().for_each(|v| v.z += up);
        }
        let mut setup = above_ground(vec![block], 0.5, 0.2, 8, |_, y| y.abs());
        let (sine, cosine) = libm::sincos(libm::atan(slope));
        setup.gravity = 9.81 * Vec3::new(sine, 0.0, -cosine);
        let mut run = Run::new(setup, 1, 1e-4);
        run.until(0.3);
        let half = run.place(1).x;
        run.until(0.4);
        assert!(run.patches([0, 1]).len() >= 2);
        run.place(1).x - half < 1e-6
    };
    assert!(stays(0.5 * 2.0_f64.sqrt() - 0.02));
    assert!(!stays(0.5 * 2.0_f64.sqrt() + 0.02));
}

fn hills(x: f64, y: f64) -> f64 {
    0.3 * x + 0.15 * libm::sin(2.0 * x) * libm::cos(1.7 * y)
}

fn rocks(count: u32) -> Vec<BlockSpec> {
    let rock = |k: u32| {
        let at = |p: u32| f64::from(p);
        let (x, y, z) = (at(k % 8), at(k / 8 % 8), at(k / 64));
        let spin = Quat::from_rotation_y(0.3 * x) * Quat::from_rotation_x(0.2 * y + z);
        let [x, y] = [0.8 * x - 3.2, 0.8 * y - 3.2];
        let low = [x, y, hills(x + 0.2, y + 0.15) + 0.3 + 0.8 * z];
        let mut block = turned(low, [0.4, 0.3, 0.35], spin);
        block.velocity = Vec3::new(0.0, 0.0, -3.0);
        block
    };
    (0..count).map(rock).collect()
}

#[test]
fn threads_and_restart_change_no_bit_on_terrain() {
    let setup = || above_ground(rocks(640), 0.5, 0.2, 24, hills);
    let mut one = Run::new(setup(), 1, 2e-4);
    one.until(0.2);
    let world = one.world.clone();
    one.until(0.26);
    let touching = one.world.found.pairs.iter().filter(|p| p.ends[0] == 0 && !p.patches.is_empty());
    assert!(touching.count() > 30);
    let mut two = Run::new(setup(), 2, 2e-4);
    two.until(0.26);
    assert_eq!(one.world.hash(), two.world.hash(), "threads change bits");
    let mut world = world;
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut again = Run { world, scratch, dt: 2e-4 };
    again.until(0.26);
    assert_eq!(one.world.hash(), again.world.hash(), "a restart changes bits");
}

/// Without friction and dashpots a rock keeps its energy over many impacts on rough ground.
#[test]
fn bounces_keep_energy() {
    let mut run = Run::new(above_ground(rocks(16), 0.0, 0.0, 24, hills), 1, 1e-4);
    run.until(0.6);
    let balance = run.view().balance();
    let lost = (balance.total() - balance.start).abs() / balance.kinetic;
    assert!(run.world.works.friction == 0.0);
    // Measured: 1.4e-5, the error of the step over some thirty impacts.
    assert!(lost < 3e-5, "{lost:e}");
}

/// Dashpots of both flanks of a ridge hold back nothing that slides over it.
#[test]
fn a_plate_slides_over_ridges_with_dashpots() {
    let acceleration = |friction: f64, damping: f64| {
        let ridges = |x: f64, _| {
            let cells = (4.0 * x).abs();
            let crest = libm::fmod(libm::round(cells), 2.0);
            0.02 * crest
        };
        let plate = brick([-2.0, -0.5, 0.02 - 2e-5], [1.2, 1.0, 0.3]);
        let mut setup = above_ground(vec![plate], friction, damping, 32, ridges);
        setup.gravity = 9.81 * Vec3::new(0.6, 0.0, -0.8);
        let mut run = Run::new(setup, 1, 2e-5);
        run.until(0.1);
        let before = run.world.bodies.velocity(1);
        run.until(0.5);
        let facets = run.patches([0, 1]).len();
        assert!(facets >= 4, "{facets} facets");
        (run.world.bodies.velocity(1) - before).x / 0.4
    };
    for (friction, damping) in [(0.0, 0.0), (0.0, 0.1), (0.0, 0.5), (0.3, 0.1)] {
        let exact = 9.81 * (0.6 - 0.8 * friction);
        let measured = acceleration(friction, damping) / exact;
        // Measured: within 0.0062; the plate rocks as its ends go over crests.
        assert!((measured - 1.0).abs() < 0.01, "{friction} {damping}: {measured}");
    }
}
