//! The stable step with dashpots.

use riprap::Vec3;
use riprap::spatial::setup::{BlockSpec, JointLaw, Motion, Stiffness, Support};
use riprap::spatial::stable::stable_step;
use riprap::spatial::topology::renew_laws;

use crate::spatial::rock::{CP, Run, brick, elastic, rock};

/// Two cubes of edge `a`, one on the other, at `x`.
fn tower(a: f64, x: f64) -> Vec<BlockSpec> {
    let half = Vec3::splat(0.5 * a);
    [0.5, 1.5].map(|z| brick(Vec3::new(x, 0.0, z * a), half)).to_vec()
}

fn limit(blocks: Vec<BlockSpec>, damping: f64) -> f64 {
    let joint = JointLaw { damping, contact_damping: damping, ..elastic() };
    let run = Run::new(rock(blocks, joint));
    stable_step(&run.world, &run.scratch, 0.0).dt
}

/// Two cubes on each other rock fastest: w = beta w² ... the root of w² dt² + 2 beta w² dt = 4.
#[test]
fn dashpots_shorten_the_step_by_the_closed_form() {
    let (a, xi) = (0.5, 0.3);
    let free = limit(tower(a, 0.0), 0.0);
    let beta = xi * a / CP;
    let w2 = 4.0 / (free * free);
    let exact = (-beta * w2 + (beta * beta * w2 * w2 + 4.0 * w2).sqrt()) / w2;
    let found = limit(tower(a, 0.0), xi);
    assert!((found / exact - 1.0).abs() < 0.01, "{found} {exact}");
}

/// Dashpots grow with the size of the blocks; those of large blocks must not set the step of small ones.
#[test]
fn coarse_dashpots_leave_fine_blocks_alone() {
    let alone = limit(tower(0.1, 0.0), 0.3);
    let mut both = tower(0.1, 0.0);
    both.extend(tower(3.2, 50.0));
    let found = limit(both, 0.3);
    assert!((found / alone - 1.0).abs() < 0.01, "{found} {alone}");
}

/// Blocks that are held in some freedoms still move in the others: they count for the step and for the
/// balance of forces.
#[test]
fn what_is_left_free_of_held_blocks_counts() {
    let held = |translation, rotation| {
        let mut setup = rock(tower(1.0, 0.0), elastic());
        setup.gravity = -10.0 * Vec3::Z;
        setup
            .supports
            .push(Support { blocks: vec![0, 1], motion: Motion::Fixed { translation, rotation } });
        let mut run = Run::new(setup);
        run.evaluate(0.0);
        let limit = stable_step(&run.world, &run.scratch, 0.0).dt;
        (limit, run.view().unbalanced())
    };
    let (free, falling) = held([false; 3], [false; 3]);
    assert!((free / limit(tower(1.0, 0.0), 0.0) - 1.0).abs() < 1e-12);
    assert!(falling > 0.5, "{falling}");
    // Only along the normal: w² = 2 Kn A/m, dt = 2/w = sqrt(2) L/c_P, with a margin.
    let (along, falling) = held([true, true, false], [true; 3]);
    let exact = 2.0f64.sqrt() / CP;
    assert!((along / exact - 1.0).abs() < 0.01, "{along} {exact}");
    assert!(falling > 0.5, "{falling}");
    assert_eq!(held([true; 3], [true; 3]).1, 0.0);
}

/// A phase that changes a law changes the patches that were built with it.
#[test]
fn renewed_laws_reach_the_patches() {
    let mut run = Run::new(rock(tower(1.0, 0.0), elastic()));
    let before = run.world.classes[0].stiffness;
    let joint = &mut run.world.setup.interfaces[0].joint;
    joint.damping = 0.2;
    joint.stiffness = Stiffness::Given { normal: 1e9, shear: 2e9 };
    renew_laws(&mut run.world);
    let class = &run.world.classes[0];
    assert_ne!(before, class.stiffness);
    assert_eq!(class.stiffness, [1e9, 2e9]);
    assert!((class.beta * CP / 0.2 - 1.0).abs() < 1e-9, "{}", class.beta);
}
