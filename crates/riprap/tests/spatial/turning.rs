//! Finite rotations: free tops, spinning bodies, the change from small to finite.

use riprap::Vec3;
use riprap::spatial::setup::{Kinematics, Setup};

use crate::spatial::rock::{CP, Draws, Run, brick, elastic, lattice, rock};

/// A bonded body of 4 x 3 x 2 cubes that spins about a slanted axis, with some vibration.
fn spinning(kinematics: Kinematics, vibration: f64) -> Run {
    let mut blocks = lattice([4, 3, 2], 1.0);
    let centre = Vec3::new(2.0, 1.5, 1.0);
    let spin = 20.0 * Vec3::new(0.3, 0.2, 1.0).normalize();
    let mut draws = Draws::new(5);
    for block in &mut blocks {
        let riprap::spatial::setup::Shape::Brick { centre: at, .. } = &block.shape else {
            unreachable!("the lattice is made of bricks");
        };
        block.velocity = spin.cross(*at - centre) + vibration * draws.vector();
        block.spin = spin + vibration * draws.vector();
    }
    Run::new(Setup { kinematics, ..rock(blocks, elastic()) })
}

#[test]
fn a_bonded_body_turns_through_twelve_radians() {
    for vibration in [0.0, 0.05] {
        let mut run = spinning(Kinematics::Finite, vibration);
        let dt = 0.2 * 0.6325 / CP;
        run.evaluate(dt);
        let (p0, l0, e0) = {
            let v = run.view();
            (v.momentum(), v.angular_momentum(), v.balance().total())
        };
        run.steps((12.0 / 20.0 / dt) as usize, dt);
        let view = run.view();
        let turned = (view.angular_momentum() - l0).length() / l0.length();
        let moved = (view.momentum() - p0).length();
        let drift = view.balance().total() / e0 - 1.0;
        println!("vibration {vibration}: |dL|/L {turned:.1e}, dP {moved:.1e}, dE/E {drift:.1e}");
        assert!(turned < 1e-10 && drift.abs() < 1e-4, "{turned:e} {drift:e}");
    }
}

#[test]
fn small_changes_to_finite_with_continuous_force() {
    let mut run = spinning(Kinematics::Automatic, 0.05);
    let dt = 0.2 * 0.6325 / CP;
    run.evaluate(dt);
    let (mut biggest, mut changed) = (0.0f64, 0);
    let mut before: Vec<Vec3> = Vec::new();
    let mut finite = 0;
    let mut typical = 0.0f64;
    for _ in 0..60 {
        run.steps(1, dt);
        let now = run.world.turned.iter().flatten().count();
        let forces: Vec<Vec3> = (0..24).map(|b| run.scratch.net.force(b)).collect();
        if !before.is_empty() {
            let jump =
                forces.iter().zip(&before).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max);
            if now > finite {
                biggest = biggest.max(jump);
                changed += 1;
            } else {
                typical = typical.max(jump);
            }
        }
        finite = now;
        before = forces;
    }
    println!("{changed} changes, jump {biggest:.2e} N against {typical:.2e} N in other steps");
    assert!(changed > 0 && finite == 24);
    assert!(biggest < 3.0 * typical);
}

#[test]
fn angular_momentum_is_kept_where_a_block_changes_to_finite_rotations() {
    let mut block = brick(Vec3::ZERO, Vec3::new(0.5, 1.0, 1.5));
    block.spin = Vec3::new(0.6, 0.4, 2.0);
    let mut setup = rock(vec![block], elastic());
    setup.kinematics = Kinematics::Automatic;
    let mut run = Run::new(setup);
    let dt = 1e-4;
    run.evaluate(dt);
    let (l0, e0) = {
        let view = run.view();
        (view.angular_momentum(), view.balance().kinetic)
    };
    let (mut worst, mut jump) = (0.0f64, None);
    for _ in 0..100 {
        let before = run.view().balance().kinetic;
        run.steps(1, dt);
        let view = run.view();
        worst = worst.max((view.angular_momentum() - l0).length() / l0.length());
        if run.world.turned[0].is_some() && jump.is_none() {
            jump = Some((view.balance().kinetic - before) / e0);
        }
    }
    let jump = jump.expect("it has turned beyond the bound");
    let balance = run.view().balance();
    println!("|dL|/L {worst:.1e}, dE/E {jump:.1e}, residual {:.1e}", balance.residual_relative());
    assert!(worst < 1e-12 && jump.abs() < 1e-4, "{worst:e} {jump:e}");
    assert!(balance.residual_relative().abs() < 1e-6);
}
