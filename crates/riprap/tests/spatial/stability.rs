//! The stable step with dashpots.

use riprap::Vec3;
use riprap::spatial::setup::{BlockSpec, JointLaw};
use riprap::spatial::stable::stable_step;

use crate::rock::{CP, Run, brick, elastic, rock};

/// Two cubes of edge `a`, one on the other, at `x`.
fn tower(a: f64, x: f64) -> Vec<BlockSpec> {
    let half = Vec3::splat(0.5 * a);
    [0.5, 1.5]
        .map(|z| brick(Vec3::new(x, 0.0, z * a), half))
        .to_vec()
}

fn limit(blocks: Vec<BlockSpec>, damping: f64) -> f64 {
    let joint = JointLaw {
        damping,
        ..elastic()
    };
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
