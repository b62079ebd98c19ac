//! Contact across the ends of a periodic model, beside the same blocks unwrapped.

use riprap_geom::{Quat, Vec3};

use super::{Run, above_floor, brick, turned};
use crate::contact::glued::tests::glued;
use crate::contact::release::release_pairs;
use crate::kernel::{Image, PairKey};
use crate::rigid::implicit::choose;
use crate::setup::{BlockSpec, Setup};
use crate::state::found::FoundPair;
use crate::state::patches::flag;

/// Blocks in the air without weight; the first one is the floor, far below.
fn floating(blocks: Vec<BlockSpec>, friction: f64, period: Option<f64>) -> Setup {
    let mut setup = above_floor(blocks, friction, 0.0);
    setup.blocks[0] = brick([-0.5, -0.5, -50.0], [1.0; 3]);
    setup.gravity = Vec3::ZERO;
    setup.periodic[0] = period;
    setup
}

fn moving(mut block: BlockSpec, velocity: [f64; 3]) -> BlockSpec {
    block.velocity = Vec3::from_array(velocity);
    block
}

/// Largest difference of the motion of some blocks in two runs, over the largest speed of either.
fn difference(one: &Run, other: &Run, pairs: &[[usize; 2]]) -> f64 {
    let (mut most, mut speed) = (0.0_f64, 0.0_f64);
    for [a, b] in pairs {
        let [x, y] = [(one, *a), (other, *b)].map(|(run, b)| run.world.bodies.velocity(b));
        let [p, q] = [(one, *a), (other, *b)].map(|(run, b)| run.world.bodies.spin(b));
        most = most.max((x - y).length()).max((p - q).length());
        speed = speed.max(x.length()).max(y.length());
    }
    most / speed
}

/// A block that slides over the end of the floor onto its image, and strikes the one that lies there.
fn slides(threads: usize) -> Run {
    let blocks = vec![
        moving(brick([3.0, -0.3, 0.0005], [0.6, 0.6, 0.5]), [3.0, 0.1, 0.0]),
        brick([-3.2, -0.25, 0.0005], [0.5; 3]),
    ];
    let mut setup = above_floor(blocks, 0.3, 0.1);
    setup.periodic[0] = Some(8.0);
    Run::new(setup, threads, 1e-4)
}

#[test]
fn a_block_that_leaves_through_an_end_meets_what_is_at_the_other() {
    let mut across = slides(1);
    let blocks = vec![
        moving(brick([3.0, -0.3, 0.0005], [0.6, 0.6, 0.5]), [3.0, 0.1, 0.0]),
        brick([4.8, -0.25, 0.0005], [0.5; 3]),
        brick([4.0, -4.0, -1.0], [8.0, 8.0, 1.0]),
    ];
    let mut setup = above_floor(blocks, 0.3, 0.1);
    setup.supports[0].blocks.push(3);
    let mut unwrapped = Run::new(setup, 1, 1e-4);
    for k in 1..=8 {
        let time = 0.1 * f64::from(k);
        across.until(time);
        unwrapped.until(time);
        let apart = difference(&across, &unwrapped, &[[1, 1], [2, 2]]);
        assert!(apart < 1e-7, "{time}: {apart:e}");
    }
    // It has struck, and both lie on the image of the floor or the floor.
    assert!(across.place(2).x > -2.9, "{}", across.place(2));
    let images: Vec<Image> = across.world.found.pairs.iter().map(|p| p.image).collect();
    assert!(images.iter().any(|image| *image != Image::SELF), "{images:?}");
    let residual = across.view().balance().residual_relative();
    assert!(residual.abs() < 1e-3, "{residual:e}");
}

#[test]
fn threads_and_a_restart_give_the_same_bits_across_the_ends() {
    let [mut one, mut two, mut restarted] = [slides(1), slides(2), slides(1)];
    one.until(0.5);
    two.until(0.5);
    restarted.until(0.2);
    restarted.until_laid_out_each_step(0.5);
    assert!(one.world.found.pairs.iter().any(|p| p.depth > 0.0 && p.image != Image::SELF));
    assert_eq!(one.world.hash(), two.world.hash());
    assert_eq!(one.world.hash(), restarted.world.hash());
    assert_eq!(one.world.found, restarted.world.found);
    let mut other = one.world.clone();
    let touching = other.found.pairs.iter_mut().find(|p| p.image != Image::SELF);
    touching.unwrap().image.0[1] += 1;
    assert_ne!(other.hash(), one.world.hash());
}

/// A cube that turns in a cell hardly wider than itself meets its own images, as two such cubes meet each other in a cell of twice the length.
#[test]
fn a_block_meets_its_own_image() {
    let cube = |x: f64| {
        let spin = Vec3::new(0.3, 0.5, 2.0);
        BlockSpec { spin, ..turned([x, -0.25, 1.0], [0.5; 3], Quat::from_rotation_z(0.05)) }
    };
    let mut single = Run::new(floating(vec![cube(0.0)], 0.4, Some(0.55)), 1, 5e-5);
    let mut double = Run::new(floating(vec![cube(0.0), cube(0.55)], 0.4, Some(1.1)), 1, 5e-5);
    let key = PairKey { ends: [1, 1], image: Image([1, 0, 0]) };
    let mut touched = false;
    for k in 1..=400 {
        let time = 1e-3 * f64::from(k);
        single.until(time);
        double.until(time);
        if single.view().contacts_of(1).count() == 2 {
            touched = true;
            assert_eq!(single.world.found.pairs[0].key(), key);
        }
        let apart = difference(&single, &double, &[[1, 1], [1, 2]]);
        let of_spin = (single.world.bodies.spin(1) - double.world.bodies.spin(2)).length();
        assert!(of_spin < 1e-7, "{time}: {of_spin:e} {apart:e}");
        // What it does to itself moves it nowhere.
        assert!(single.world.bodies.velocity(1).length() < 1e-12);
    }
    assert!(touched);
    let turns = single.world.bodies.spin(1);
    assert!((turns - Vec3::new(0.3, 0.5, 2.0)).length() > 0.5, "{turns}");
    let residual = single.view().balance().residual_relative();
    assert!(residual.abs() < 1e-3, "{residual:e}");
}

/// Three cubes and a fixed one between the ends: the weight along the row presses them onto the fixed one's far side.
fn row(threads: usize) -> Run {
    let blocks = (0..3).map(|k| brick([0.501 * f64::from(k + 1), 0.0, 0.0], [0.5; 3])).collect();
    let mut setup = above_floor(blocks, 0.0, 0.5);
    setup.blocks[0] = brick([0.0; 3], [0.5; 3]);
    setup.gravity = Vec3::new(9.81, 0.0, 0.0);
    setup.periodic[0] = Some(4.0 * 0.501);
    Run::new(setup, threads, 1e-4)
}

#[test]
fn a_row_presses_on_the_image_of_what_holds_it() {
    let weight = 2500.0 * 0.125 * 9.81;
    let mut run = row(1);
    run.until(0.6);
    let force = run.view().contact_between(0, 3).map_or(Vec3::ZERO, |(_, force)| force);
    assert!((force.x / (3.0 * weight) - 1.0).abs() < 1e-3, "{force}");
    assert!(run.view().contact_between(0, 1).is_none());
    // The same in implicit steps.
    let mut run = row(1);
    choose(&mut run.world, &mut run.scratch, true);
    run.dt = 1e-3;
    run.until(0.6);
    let force = run.view().contact_between(0, 3).map_or(Vec3::ZERO, |(_, force)| force);
    assert!((force.x / (3.0 * weight) - 1.0).abs() < 1e-3, "implicit: {force}");
}

/// Momentum is that of the impulse of the weight, whatever presses whom across the ends.
#[test]
fn a_row_that_falls_through_its_cell_keeps_the_momentum_of_its_weight() {
    let mut blocks: Vec<BlockSpec> =
        (0..4).map(|k| brick([0.51 * f64::from(k), 0.0, 0.0], [0.5; 3])).collect();
    blocks[0].velocity = Vec3::new(2.0, 0.0, 0.0);
    let mut setup = floating(blocks, 0.3, Some(4.0 * 0.51));
    setup.gravity = Vec3::new(5.0, 0.0, 0.0);
    let mut run = Run::new(setup, 1, 5e-5);
    run.until(1.0);
    // Speeds are those of half a step before.
    let sum: Vec3 = (1..=4).map(|b| run.world.bodies.velocity(b)).sum();
    let wanted = 2.0 + 4.0 * 5.0 * (run.world.time - 0.5 * run.dt);
    assert!((sum - wanted * Vec3::X).length() < 1e-9, "{sum} {wanted}");
    // They have left the cell, and what struck the last one was the first or has been struck by it.
    assert!((1..=4).all(|b| run.place(b).x > 4.0 * 0.51), "{}", run.place(1));
    let alone = 3.0 * 0.51 + 0.25 + 0.5 * 5.0;
    assert!(run.place(4).x > alone + 0.1, "{}", run.place(4));
    let residual = run.view().balance().residual_relative();
    assert!(residual.abs() < 1e-3, "{residual:e}");
}

/// What has left its cell by many periods meets the same blocks.
#[test]
fn the_number_of_periods_does_not_matter() {
    let run = |periods: f64| {
        let blocks = vec![
            moving(brick([0.1 + 2.0 * periods, 0.1, 0.0], [0.5; 3]), [4.0, 0.0, 0.2]),
            brick([1.2, 0.0, 0.1], [0.5; 3]),
        ];
        let mut run = Run::new(floating(blocks, 0.3, Some(2.0)), 1, 1e-4);
        run.until(0.3);
        run
    };
    let here = run(0.0);
    assert!(here.world.bodies.velocity(2).x > 1.0);
    for periods in [3.0, -40.0] {
        let there = run(periods);
        let apart = difference(&here, &there, &[[1, 1], [2, 2]]);
        assert!(apart < 1e-7, "{periods}: {apart:e}");
    }
}

/// Joints on both sides of a block to the same other one: that across the end is released alone, and its pair pushes as its faces do.
#[test]
fn a_joint_across_the_ends_hands_over_to_its_image() {
    let blocks = [0.0, 1.0].map(|x| brick([x, 0.0, 0.0], [1.0; 3]));
    for [first, second] in [[0, 1], [1, 0]] {
        let blocks = [first, second].map(|k: usize| blocks[k].clone());
        let mut run = Run::new(floating(blocks.to_vec(), 0.3, Some(2.0)), 1, 1e-4);
        assert_eq!(run.world.patches.len(), 2);
        // Blocks of a lattice whose joints are whole meet nobody.
        for flags in &mut run.world.patches.flags {
            *flags |= flag::BROKEN;
        }
        run.evaluate();
        let key = |run: &Run, p: usize| crate::contact::held::pair_of_patch(&run.world, p).0;
        let keys = [0, 1].map(|p| key(&run, p));
        let (inner, outer) = match keys[0].image == Image::SELF {
            true => (keys[0], keys[1]),
            false => (keys[1], keys[0]),
        };
        assert_eq!([inner, outer].map(|k| k.ends), [[1, 2]; 2]);
        release_pairs(&mut run.world, &mut run.scratch, &[outer]);
        assert_eq!(run.world.patches.len(), 1);
        assert_eq!(key(&run, 0), inner);
        run.evaluate();
        let depth = 1e-4;
        // The one at the upper end goes on through it.
        let upper = if first == 0 { 2 } else { 1 };
        run.world.bodies.displacement[0][upper] = depth;
        run.evaluate();
        let pairs = &run.world.found.pairs;
        assert_eq!(pairs.iter().map(FoundPair::key).collect::<Vec<PairKey>>(), [outer]);
        let toward = if upper == 2 { -1.0 } else { 1.0 };
        let force = pairs[0].force().x;
        assert!((force / (toward * 1e9 * depth) - 1.0).abs() < 1e-2, "{force}");
    }
}

/// Glued parts: an L with its foot through the end, and a brick that falls into it.
#[test]
fn glued_parts_meet_across_the_ends() {
    let parts = [([0.0, 0.0, 0.0], [0.9, 0.3, 0.3]), ([0.0, 0.0, 0.3], [0.3, 0.3, 0.9])];
    let at = |x: f64| glued(&parts, Vec3::new(x, 0.0, 0.0005));
    let brick = |x: f64| moving(brick([x, 0.02, 0.35], [0.3, 0.2, 0.3]), [-1.0, 0.0, 0.0]);
    let run = |l: f64, b: f64, period: Option<f64>| {
        let mut setup = above_floor(vec![at(l), brick(b)], 0.3, 0.1);
        setup.periodic[0] = period;
        Run::new(setup, 1, 1e-4)
    };
    let mut across = run(3.5, -3.9 + 0.3, Some(8.0));
    // One floor is enough for the model that is not periodic.
    let mut setup = above_floor(vec![at(3.5), brick(4.4)], 0.3, 0.1);
    setup.blocks.push(super::brick([4.0, -4.0, -1.0], [8.0, 8.0, 1.0]));
    setup.supports[0].blocks.push(3);
    setup.blocks[3].name.number = 4;
    let mut unwrapped = Run::new(setup, 1, 1e-4);
    for k in 1..=6 {
        let time = 0.05 * f64::from(k);
        across.until(time);
        unwrapped.until(time);
        let apart = difference(&across, &unwrapped, &[[1, 1], [2, 2]]);
        assert!(apart < 1e-6, "{time}: {apart:e}");
    }
    let touches =
        |p: &crate::state::found::FoundPair| p.ends == [1, 2] && p.image == Image([1, 0, 0]);
    assert!(across.world.found.pairs.iter().any(touches));
    assert!(across.view().contact_between(1, 2).is_some());
}
