//! Momentum, angular momentum and energy of free bodies.

use riprap::Vec3;
use riprap::spatial::setup::{Refinement, Region, Setup};

use crate::spatial::rock::{CP, Draws, Run, elastic, lattice, rock, strength};

/// A free body with blocks of two sizes.
fn two_levels(setup: Setup) -> Setup {
    Setup {
        refinements: vec![Refinement {
            around: Region::Point(Vec3::splat(3.0)),
            levels: 1,
            during: None,
        }],
        ..setup
    }
}

fn shaken(run: &mut Run, speed: f64) {
    let mut draws = Draws::new(7);
    for b in 0..run.world.alive.len() {
        run.world.bodies.set_velocity(b, speed * draws.vector(), speed * draws.vector());
    }
}

#[test]
fn momenta_and_energy_of_a_shaken_body_stay() {
    let setup = two_levels(rock(lattice([6, 5, 4], 1.0), elastic()));
    let mut run = Run::new(setup);
    let living = run.view().living().count();
    assert_eq!(living, 120 + 56);
    shaken(&mut run, 0.01);
    let dt = 0.3 * 0.6325 * 0.5 / CP;
    run.evaluate(dt);
    let (p0, l0, e0) = {
        let view = run.view();
        (view.momentum(), view.angular_momentum(), view.balance().total())
    };
    run.steps(20_000, dt);
    let view = run.view();
    let scale: f64 =
        view.living().map(|b| run.world.solid_of(b).mass * view.velocity(b).length()).sum();
    let moved = (view.momentum() - p0).length() / scale;
    let turned = (view.angular_momentum() - l0).length() / (6.0 * scale);
    let drift = view.balance().total() / e0 - 1.0;
    println!("dP/P {moved:.1e}, dL/L {turned:.1e}, dE/E {drift:.1e}");
    assert!(moved < 1e-12 && turned < 1e-12, "{moved:e} {turned:e}");
    assert!(drift.abs() < 1e-10, "{drift:e}");
}

#[test]
fn the_books_of_a_failing_body_close() {
    for (share, bound) in [(0.3, 2e-3), (0.1, 5e-4)] {
        let law = riprap::spatial::setup::JointLaw {
            strength: Some(strength(0.2e6, 30.0, 0.1e6)),
            ..elastic()
        };
        let mut run = Run::new(two_levels(rock(lattice([6, 5, 4], 1.0), law)));
        shaken(&mut run, 0.1);
        let dt = share * 0.6325 * 0.5 / CP;
        run.steps((2000.0 / share) as usize, dt);
        let balance = run.balance();
        let error = balance.residual() / balance.start;
        println!(
            "{share}: start {:.4e} kinetic {:.3e} stored {:.3e} friction {:.3e} fracture {:.3e} residual {error:.1e}",
            balance.start,
            balance.kinetic,
            balance.contact_normal + balance.contact_shear,
            balance.works.friction,
            balance.works.fracture
        );
        assert!(balance.works.friction > 0.01 * balance.start);
        assert!(error.abs() < bound, "{error:e}");
    }
}
