//! Joints that are released: what goes on of their loads.

use riprap_geom::Vec3;

use super::release_pairs;
use crate::contact::tests::{Run, above_floor, brick};
use crate::dynamics::TimeFunction;
use crate::exec::Exec;
use crate::kernel::PairKey;
use crate::kernel::offset::{Carried, Offset};
use crate::setup::{Load, LoadKind};
use crate::state::patches::flag;
use crate::state::scratch::Scratch;
use crate::topology::split;

/// A brick of half a metre on the floor, whose edge is at x = 4 m, joined to it without strength.
fn joined(x: f64, velocity: Vec3, friction: f64) -> Run {
    let mut block = brick([x, -0.25, 0.0], [0.5; 3]);
    block.velocity = velocity;
    let run = Run::new(above_floor(vec![block], friction, 0.1), 1, 1e-4);
    assert_eq!(run.world.patches.len(), 1);
    run
}

#[test]
fn a_brick_that_slides_off_the_edge_falls() {
    let mut run = joined(2.5, Vec3::new(3.0, 0.0, 0.0), 0.0);
    run.until(0.2);
    assert!(run.world.patches.is_empty());
    // Still on the floor, and carried by it.
    let place = run.place(1);
    assert!((place.z - 0.25).abs() < 1e-3 && (place.x - 3.35).abs() < 1e-3, "{place}");
    let weight = 2500.0 * 0.125 * 9.81;
    let carried = run.world.found.pairs[0].force().z;
    assert!((carried / weight - 1.0).abs() < 0.02, "{carried}");
    run.until(0.9);
    assert!(run.place(1).z < -0.5, "{}", run.place(1));
    let balance = run.view().balance();
    assert!(balance.residual_relative().abs() < 1e-3, "{balance:?}");
}

/// A brick whose joint to the floor holds at two of four points turns about them by a quarter turn and more.
#[test]
fn a_joint_that_has_partly_failed_lets_go_when_it_folds() {
    let mut block = brick([2.0, -0.25, 0.0], [0.5; 3]);
    let rate = 4.0;
    block.spin = Vec3::new(0.0, rate, 0.0);
    let hinge = Vec3::new(2.25 + 0.25 / 3.0f64.sqrt(), 0.0, 0.0);
    block.velocity = block.spin.cross(Vec3::new(2.25, 0.0, 0.25) - hinge);
    let mut setup = above_floor(vec![block], 0.5, 0.1);
    setup.gravity = Vec3::ZERO;
    let strength = setup.interfaces[0].joint.strength.as_mut().unwrap();
    (strength.cohesion, strength.tension) = (1e9, 1e9);
    let mut run = Run::new(setup, 1, 2e-5);
    let class = run.world.classes[run.world.patches.class[0] as usize];
    for q in 0..4 {
        if crate::joint::patch::place(&class, q).dot(Vec3::X) < 0.0 {
            run.world.patches.flags[0] |= flag::of(flag::BROKEN, q) | flag::of(flag::OPEN, q);
        }
    }
    run.until(0.3 / rate - 0.01);
    assert_eq!(run.world.patches.len(), 1);
    run.until(0.3 / rate + 0.01);
    assert!(run.world.patches.is_empty());
    let works = run.world.works;
    let energy = run.view().balance().kinetic;
    assert!(works.fracture > 0.0, "{works:?}");
    run.until(3.0 / rate);
    let balance = run.view().balance();
    assert!(balance.residual_relative().abs() < 1e-3, "{balance:?}");
    // Nothing but a blow on the floor takes from it what the hinge left.
    assert!(balance.kinetic <= 1.001 * energy, "{balance:?} {energy}");
}

#[test]
fn friction_goes_on_when_the_joint_gives_way() {
    let mut run = joined(-2.0, Vec3::new(1.5, 0.0, 0.0), 0.5);
    run.until(0.5);
    assert!(run.world.patches.is_empty());
    let way = run.place(1).x + 1.75;
    let wanted = 1.5 * 1.5 / (2.0 * 0.5 * 9.81);
    assert!((way / wanted - 1.0).abs() < 0.02, "{way} {wanted}");
    assert!((run.place(1).z - 0.25).abs() < 1e-4);
    let balance = run.view().balance();
    assert!(balance.residual_relative().abs() < 1e-2, "{balance:?}");
}

/// A slab of a metre on a joint that is softer (0.4) than found contact and carries its weight; the joint lets go and the slab is
/// pushed with 0.7 of its weight, where friction holds 0.5. Without what is kept of the joint's load it would jump up by 1.5
/// weights. Expected: `1/2 0.2 g t²`.
#[test]
fn the_load_of_a_joint_goes_on_when_it_lets_go() {
    let g = 10.0;
    let mut setup = above_floor(vec![brick([-0.5, -0.5, 0.0], [1.0, 1.0, 0.1])], 0.5, 0.2);
    setup.gravity = Vec3::new(0.7 * g, 0.0, -g);
    let mut run = Run::new(setup, 1, 2e-5);
    for class in &mut run.world.classes {
        class.stiffness = class.stiffness.map(|k| 0.4 * k);
    }
    run.scratch = Scratch::new(&mut run.world, Exec::serial());
    let weight = 250.0 * g;
    run.world.bodies.displacement[2][1] = -weight / 0.4e9;
    // Its shear is at the limit: it slides from the first instant.
    let start = 0.5 * weight / (0.4 * 5e8);
    run.world.bodies.displacement[0][1] = start;
    run.world.patches.flags[0] |= flag::BROKEN;
    run.evaluate();
    run.world.start_energy = Some(run.view().balance().total());
    release_pairs(&mut run.world, &mut run.scratch, &[PairKey::plain([0, 1])]);
    run.world.pending = 0.0;
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for step in 1..=300 {
        run.until(1e-3 * f64::from(step));
        let normal = run.world.found.pairs[0].force().z / weight;
        (least, most) = (least.min(normal), most.max(normal));
    }
    assert!(least > 0.99 && most < 1.01, "{least} {most}");
    let way = run.place(1).x - start;
    assert!((way - 0.09).abs() < 1e-4, "{way}");
    assert!(run.world.found.pairs[0].offset.is_some());
    let balance = run.view().balance();
    assert!(balance.residual_relative().abs() < 1e-6, "{balance:?}");
    // What the hand-over has made: nothing across the joint, and along it springs of the law's stiffness hold the same force.
    let shear = 0.5 * weight;
    let wanted = 0.5 * shear * shear * (1.0 / 0.5e9 - 1.0 / (0.4 * 0.5e9));
    let made = balance.works.edit_defect;
    assert!((made / wanted - 1.0).abs() < 0.02, "{made} {wanted}");
}

#[test]
fn nothing_is_left_of_a_joint_that_has_opened() {
    let mut run = joined(2.0, Vec3::new(0.5, 0.0, 4.0), 0.5);
    run.until(0.3);
    assert!(run.world.patches.is_empty());
    let place = run.place(1);
    let height = 0.25 + 4.0 * 0.3 - 0.5 * 9.81 * 0.09;
    assert!((place.z - height).abs() < 1e-2 && (place.x - 2.4).abs() < 5e-3, "{place}");
    // And it comes down on the floor again.
    run.until(2.0);
    let height = run.place(1).z;
    assert!(height > 0.249 && height < 0.4, "{height}");
}

#[test]
fn the_layout_after_a_joint_has_gone_is_that_of_a_restart() {
    // Bricks side by side in a lattice on the floor, each pushed off in its own way.
    let start = || {
        let mut blocks = Vec::new();
        for k in 0..12 {
            let [x, y] = [f64::from(k % 4), f64::from(k / 4)];
            let mut block = brick([0.5 * x - 1.0, 0.5 * y - 1.0, 0.0], [0.5; 3]);
            block.velocity = Vec3::new(0.9 * (x - 1.4), 0.7 * (y - 0.9), 0.1 * f64::from(k % 3));
            blocks.push(block);
        }
        let mut setup = above_floor(blocks, 0.3, 0.1);
        setup.loads.push(Load {
            blocks: vec![3, 5],
            kind: LoadKind::Point { force: Vec3::new(0.0, 0.0, -500.0), at: None },
            account: None,
            time: TimeFunction::Constant(1.0),
        });
        Run::new(setup, 1, 1e-4)
    };
    let (mut usual, mut laid) = (start(), start());
    let before = usual.world.patches.len();
    let mut some_are_left = false;
    for k in 1..=12 {
        usual.until(0.005 * f64::from(k));
        laid.until_laid_out_each_step(0.005 * f64::from(k));
        assert_eq!(usual.world.hash(), laid.world.hash(), "{k}");
        let tiles = format!("{:?}", usual.scratch.tiles);
        let anew = Scratch::new(&mut usual.world.clone(), Exec::serial());
        assert_eq!(tiles, format!("{:?}", anew.tiles), "{k}");
        some_are_left |= (1..before).contains(&usual.world.patches.len());
    }
    assert!(some_are_left, "{before}");
}

/// Two bricks on each other on the floor, the joints between them gone.
fn parted() -> Run {
    let blocks = vec![brick([0.0, 0.0, 0.0], [0.5; 3]), brick([0.0, 0.0, 0.5], [0.5; 3])];
    let mut run = Run::new(above_floor(blocks, 0.5, 0.1), 1, 1e-4);
    assert_eq!(run.world.patches.len(), 2);
    run.evaluate();
    run.world.start_energy = Some(run.view().balance().total());
    release_pairs(&mut run.world, &mut run.scratch, &[PairKey::plain([1, 2])]);
    run.evaluate();
    run
}

#[test]
fn faces_in_joints_that_have_given_way_are_no_surface() {
    let run = parted();
    assert_eq!(run.view().surface(), [true, false, true]);
}

#[test]
fn blocks_whose_joint_has_given_way_can_be_split() {
    let mut run = parted();
    split(&mut run.world, &mut run.scratch, &[1, 2], run.dt).unwrap();
    // Twelve joints inside each, four to the floor, none between the two.
    assert_eq!(run.world.patches.len(), 2 * 12 + 4);
    let surface = run.view().surface();
    assert_eq!(surface.iter().filter(|s| **s).count(), 5, "{surface:?}");
    // The parts of the upper one lie on those of the lower one.
    run.until(0.2);
    for b in 3..19 {
        let sunk = run.view().displacement(b).z;
        assert!(sunk.abs() < 1e-4, "{b}: {sunk}");
    }
    let residual = run.view().balance().residual_relative();
    assert!(residual.abs() < 1e-2, "{residual}");
}

/// What blocks hide of their pressure, their parts hide too: nothing is thrown up when blocks that lie deep in each other are split.
#[test]
fn parts_of_blocks_hide_what_these_did() {
    let mut run = parted();
    let depth = 0.02;
    for b in [1, 2] {
        run.world.bodies.displacement[2][b] = -depth * (b as f64 - 1.0);
    }
    for pair in &mut run.world.found.pairs {
        pair.offset = Some(Box::new(Offset::new(Carried::default())));
    }
    run.evaluate();
    let hidden = run.world.found.pairs[0].offset.as_ref().unwrap().hidden;
    let whole = 0.5 * 1e9 * 0.25 * depth * depth;
    assert!((hidden / whole - 1.0).abs() < 0.2, "{hidden} {whole}");
    run.world.start_energy = Some(run.view().balance().total());
    split(&mut run.world, &mut run.scratch, &[1, 2], run.dt).unwrap();
    run.until(0.1);
    let hiding = run.world.found.pairs.iter().filter(|p| p.offset.is_some());
    assert!(hiding.count() >= 4);
    let balance = run.view().balance();
    // Falling onto each other by their weight is all that moves them.
    assert!(balance.kinetic < 1e-3 * whole, "{balance:?} {whole}");
    assert!(balance.works.edit_defect.abs() < 0.1 * whole, "{balance:?} {whole}");
}

#[test]
fn what_opens_and_closes_in_place_stays_a_joint() {
    let mut run = joined(2.0, Vec3::new(0.0, 0.0, 0.02), 0.5);
    run.until(0.3);
    assert_eq!(run.world.patches.len(), 1);
    assert!(run.world.found.pairs.is_empty() || run.world.found.pairs[0].depth == 0.0);
}

#[test]
fn what_rocks_gives_way_at_once_and_comes_to_rest() {
    let mut run = joined(2.0, Vec3::new(0.02, 0.0, 0.02), 0.5);
    run.until(0.3);
    assert!(run.world.patches.is_empty());
    let height = run.place(1).z;
    assert!((height - 0.25).abs() < 1e-4, "{height}");
}
