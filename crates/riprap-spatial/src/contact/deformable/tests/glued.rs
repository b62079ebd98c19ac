//! Deformable blocks against blocks of glued parts: as against convex ones, as between rigid ones, in flight, in a clamp, refused.

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Quat, Vec3};

use super::{Run, brick, cube, fixed, model, spec};
use crate::exec::Exec;
use crate::faces::deformable::centred;
use crate::kernel::Pose;
use crate::kernel::glued::{Glued, Gluer, Placed, Touch};
use crate::setup::error::BuildError;
use crate::setup::{BlockSpec, Setup, Shape, Solid};
use crate::state::scratch::Scratch;
use crate::state::world::World;

type Box3 = ([f64; 3], [f64; 3]);

/// A U, open upwards: base, left, right.
const U: [Box3; 3] = [
    ([-0.9, -0.3, -0.6], [0.9, 0.3, 0.0]),
    ([-0.9, -0.3, 0.0], [-0.4, 0.3, 0.7]),
    ([0.3, -0.3, 0.0], [0.9, 0.3, 0.9]),
];
/// An L.
const L: [Box3; 2] = [([-0.8, -0.3, -0.4], [0.8, 0.3, 0.2]), ([0.2, -0.3, 0.2], [0.8, 0.3, 0.9])];

fn solids(parts: &[Box3], turn: Quat, shift: Vec3) -> Vec<Polyhedron> {
    let solid = |(low, high): &Box3| {
        let [low, high] = [low, high].map(|v| Vec3::from_array(*v));
        let mut solid = Polyhedron::brick(0.5 * (low + high), 0.5 * (high - low));
        solid.vertices.iter_mut().for_each(|v| *v = turn * *v + shift);
        solid
    };
    parts.iter().map(solid).collect()
}

fn glued(parts: &[Box3], turn: Quat, shift: Vec3) -> BlockSpec {
    let parts = solids(parts, turn, shift).into_iter();
    let parts = parts.map(|s| Solid { vertices: s.vertices, faces: s.faces });
    spec(Shape::Glued(parts.collect()))
}

/// Far from the origin as well; the slopes of heaps are read from it.
#[test]
fn the_solid_of_glued_parts_is_about_their_centroid() {
    let far = Vec3::new(10.0, -20.0, 30.0);
    let (solid, centroid) = centred(&glued(&L, Quat::IDENTITY, far).shape);
    assert!(solid.moments().centroid.length() < 1e-12);
    assert!((centroid - far).length() < 1.0, "{centroid}");
}

/// A cube that falls askew on a brick, and on the same brick of two and of four parts: the same forces, the same motion.
#[test]
fn a_brick_of_parts_is_the_brick() {
    let run = |floor: BlockSpec| {
        let turn = Quat::from_scaled_axis(Vec3::new(0.3, -0.2, 0.5));
        let mut falling = cube(Vec3::new(0.1, 0.05, 0.62), turn);
        falling.velocity = Vec3::new(1.0, 0.3, -3.0);
        let mut setup = fixed(model(vec![floor, falling], &[1], 0.3, 0.1), &[0]);
        setup.gravity = Vec3::new(0.0, 0.0, -9.81);
        let mut run = Run::new(setup, 1, 4e-5);
        run.evaluate();
        let pair = &run.world.found.deformable.pairs[0];
        let start = (pair.force, pair.energy);
        run.until(0.04);
        (start, run.view().velocity(1))
    };
    let ((force, energy), velocity) = run(brick([-2.0, -2.0, -1.0], [4.0, 4.0, 1.0]));
    assert!(force.length() > 0.0 && velocity.z > -2.5, "{force} {velocity}");
    let halves = [([-2.0, -2.0, -1.0], [0.1, 2.0, 0.0]), ([0.1, -2.0, -1.0], [2.0, 2.0, 0.0])];
    let quarters = [
        ([-2.0, -2.0, -1.0], [0.1, 0.0, 0.0]),
        ([0.1, -2.0, -1.0], [2.0, 0.0, 0.0]),
        ([-2.0, 0.0, -1.0], [0.1, 2.0, 0.0]),
        ([0.1, 0.0, -1.0], [2.0, 2.0, 0.0]),
    ];
    for parts in [&halves[..], &quarters] {
        let ((f, e), v) = run(glued(parts, Quat::IDENTITY, Vec3::ZERO));
        assert!((f - force).length() < 1e-9 * force.length(), "{f} {force}");
        assert!((e - energy).abs() < 1e-9 * energy, "{e} {energy}");
        // Friction acts at the centres of the pieces of the surface, which are divided otherwise.
        assert!((v - velocity).length() < 1e-5, "{v} {velocity}");
    }
}

/// A cube that has not been bent yet gets the force that a rigid one gets from the same block: an L and a U in many positions, on and
/// under it, in the corner of the one and between the walls of the other.
#[test]
fn the_force_is_that_on_a_rigid_cube() {
    let rigid = |parts: &[Polyhedron], centre: Vec3, at: Vec3, turn: Quat| -> Vec3 {
        let block = Glued::new(parts, centre).unwrap();
        let half = crate::kernel::Shape::brick(Vec3::splat(0.5)).unwrap();
        let cube = Glued::convex(&half);
        let poses = [Pose::at(centre), Pose { position: at, rotation: turn }];
        let placed = Placed { blocks: [&block, &cube], poses };
        let mut gluer = Gluer::default();
        gluer.place(&placed);
        let touches = (0..block.pieces()).map(|piece| gluer.find(&placed, [piece, 0]));
        let forces = touches.filter_map(|touch| match touch {
            Touch::Touching(sums, _) => Some(sums.force),
            _ => None,
        });
        forces.sum()
    };
    let mut touching = 0;
    for k in 0..24_u32 {
        let x = f64::from(k);
        let parts: &[Box3] = if k % 2 == 0 { &L } else { &U };
        let turn = Quat::from_scaled_axis(
            0.3 * Vec3::new(libm::sin(0.9 * x), libm::cos(x), libm::sin(1.7 * x)),
        );
        let up = if k % 3 == 0 { -1.0 } else { 1.0 };
        let at =
            Vec3::new(-0.3 + 0.3 * libm::sin(1.3 * x), 0.1, up * (0.72 + 0.1 * libm::cos(0.7 * x)));
        let block = glued(parts, Quat::IDENTITY, Vec3::ZERO);
        let blocks = vec![block, cube(at, turn)];
        let mut run = Run::new(model(blocks, &[1], 0.0, 0.0), 1, 1e-5);
        run.evaluate();
        let solids = solids(parts, Quat::IDENTITY, Vec3::ZERO);
        let law = run.scratch.deformable.constants.first().map(|c| c.law);
        let stiffness = law.map_or(0.0, |law| law.normal_stiffness);
        let wanted = 2.0 * stiffness * rigid(&solids, run.world.reference[0], at, turn);
        let found = run.world.found.deformable.pairs.first().map_or(Vec3::ZERO, |p| p.force);
        assert!((found - wanted).length() <= 1e-8 * wanted.length(), "{k}: {found} {wanted}");
        touching += u32::from(wanted.length() > 0.0);
    }
    assert!(touching > 12, "{touching}");
}

/// A U and a deformable cube that is thrown into it: energy to the second order in the step, and the momenta.
#[test]
fn a_bounce_in_a_u_keeps_energy_and_momenta() {
    let collision = |dt: f64| {
        let turn = Quat::from_scaled_axis(Vec3::new(0.1, 0.6, 0.2));
        let mut blocks =
            vec![glued(&U, Quat::IDENTITY, Vec3::ZERO), cube(Vec3::new(0.05, 0.1, 1.6), turn)];
        blocks[0].velocity = Vec3::new(0.0, 0.0, 3.0);
        blocks[1].velocity = Vec3::new(0.5, 0.0, -4.0);
        let mut run = Run::new(model(blocks, &[1], 0.0, 0.0), 1, dt);
        run.evaluate();
        let start = run.view().kinetic_energy();
        let before = [run.view().momentum(), run.view().angular_momentum()];
        let (mut worst, mut pressed, mut drift) = (0.0_f64, 0.0_f64, [0.0_f64; 2]);
        run.watch(0.12, |run| {
            let now = [run.view().momentum(), run.view().angular_momentum()];
            for k in 0..2 {
                drift[k] = drift[k].max((now[k] - before[k]).length() / before[k].length());
            }
            let balance = run.view().balance();
            worst = worst.max((balance.residual() / start).abs());
            pressed = pressed.max(balance.contact_normal / start);
        });
        assert!(pressed > 0.01, "{pressed}");
        // Also while they press, and before the U has turned enough for finite rotations.
        assert!(drift.iter().all(|drift| *drift < 1e-12), "{drift:?}");
        worst
    };
    let [coarse, fine] = [4e-5, 2e-5].map(collision);
    assert!(coarse < 1e-4, "{coarse:e}");
    assert!((coarse / fine - 4.0).abs() < 1.0, "{coarse:e} {fine:e}");
}

/// A cube between the arms of a clamp, which press it from both sides: it has no one normal, but friction on either arm. It holds where that is
/// more than the weight, and slips else.
#[test]
fn a_clamp_holds_a_cube_by_friction() {
    let clamp = [
        ([-0.7, -0.5, 0.5], [0.7, 0.5, 0.9]),
        ([-0.7, -0.5, -0.5], [-0.5, 0.5, 0.5]),
        ([0.5, -0.5, -0.5], [0.7, 0.5, 0.5]),
    ];
    let fall = |friction: f64| {
        let half = Vec3::new(0.5002, 0.4, 0.4);
        let block = brick((-half - Vec3::new(0.0, 0.0, 0.05)).to_array(), (2.0 * half).to_array());
        let clamp = glued(&clamp, Quat::IDENTITY, Vec3::ZERO);
        let mut setup = fixed(model(vec![clamp, block], &[1], friction, 0.5), &[0]);
        setup.gravity = Vec3::new(0.0, 0.0, -9.81);
        let mut run = Run::new(setup, 1, 5e-5);
        run.until(0.06);
        assert_eq!(run.view().contacts().count(), 2);
        -run.view().displacement(1).z
    };
    // Pressed by about 35 kPa on 0.64 m² on either side, 22 kN; the weight is 15.7 kN.
    let (held, slipped) = (fall(0.6), fall(0.1));
    assert!(held < 5e-4, "{held}");
    assert!(slipped > 5e-3, "{slipped}");
}

/// An L as a floor, a U and cubes that fall on it: the same bits with threads and after a restart.
#[test]
fn threads_and_restart_change_no_bit_beside_glued_parts() {
    let setup = || {
        let floor = [([-3.0, -2.0, -1.0], [3.0, 2.0, 0.0]), ([2.0, -2.0, 0.0], [3.0, 2.0, 2.0])];
        let mut blocks = vec![glued(&floor, Quat::IDENTITY, Vec3::ZERO)];
        let turn = Quat::from_scaled_axis(Vec3::new(0.2, 0.1, 0.4));
        blocks.push(glued(&U, turn, Vec3::new(-1.5, 0.0, 0.95)));
        for (k, x) in [-1.4, 0.2, 1.4].into_iter().enumerate() {
            let at = Vec3::new(x, 0.1, if k == 0 { 2.1 } else { 0.95 });
            let mut block = cube(at, turn);
            block.velocity = Vec3::new(2.0, 0.0, -3.0);
            blocks.push(block);
        }
        let mut setup = fixed(model(blocks, &[2, 3, 4], 0.5, 0.1), &[0]);
        setup.gravity = Vec3::new(0.0, 0.0, -9.81);
        setup
    };
    let dt = 5e-5;
    let mut one = Run::new(setup(), 1, dt);
    one.until(0.06);
    let mut world = one.world.clone();
    one.until(0.1);
    let contacts = one.world.found.deformable.pairs.iter().map(|p| p.contacts.len());
    assert!(contacts.sum::<usize>() > 0);
    let mut two = Run::new(setup(), 2, dt);
    two.until(0.1);
    assert!(one.world.hash() == two.world.hash(), "threads change bits");
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut again = Run { world, scratch, dt };
    again.until(0.1);
    assert!(one.world.hash() == again.world.hash(), "a restart changes bits");
}

#[test]
fn a_block_of_glued_parts_that_should_deform_is_refused_by_name() {
    let refused = |setup: Setup| -> String {
        let error = World::new(setup, Exec::serial()).unwrap_err();
        assert!(matches!(error, BuildError::Glued { .. }), "{error}");
        error.to_string()
    };
    let blocks =
        vec![glued(&L, Quat::IDENTITY, Vec3::ZERO), brick([-2.0, -2.0, -3.0], [4.0, 4.0, 1.0])];
    let error = refused(model(blocks, &[0, 1], 0.5, 0.1));
    assert!(error.starts_with("block `rock.1`") && error.contains("cannot deform"), "{error}");
}
