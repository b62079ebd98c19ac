//! Slabs that slide on an inclined plane: friction holds them back, dashpots do not.

use riprap::Vec3;
use riprap::spatial::setup::{
    Dashpots, Failure, InSitu, InterfaceLaw, JointLaw, Material, Motion, Setup, Support,
};
use riprap::spatial::step::advance;
use riprap::spatial::world::flag;

use crate::spatial::rock::{CP, DENSITY, Run, brick, elastic, rock, strength};

const G: f64 = 9.81;
const SLOPE: f64 = 31.0;
const FRICTION: f64 = 30.0;
const DAMPING: f64 = 0.1;
/// Thickness of a slab, m.
const THICK: f64 = 0.5;
/// Distance of its centroid from that of the plane, m.
const DISTANCE: f64 = 0.75;
const DT: f64 = 5e-5;

/// g (sin a - tan phi cos a), m/s².
fn excess() -> f64 {
    let (sine, cosine) = SLOPE.to_radians().sin_cos();
    G * (sine - FRICTION.to_radians().tan() * cosine)
}

/// Slabs of 1 m x 1 m side by side on a fixed plane, drawn level with gravity tilted towards x; their joints with the plane
/// carry their weight from the start. Each is joined by its own kind of dashpots.
fn slabs(kinds: &[Dashpots], failure: Failure) -> Setup {
    let law = |dashpots| JointLaw {
        strength: Some(strength(0.0, FRICTION, 0.0)),
        behaviour: Default::default(),
        failure,
        damping: DAMPING,
        contact_damping: DAMPING,
        dashpots,
        ..elastic()
    };
    let mut blocks = vec![brick(Vec3::new(0.0, 0.0, -0.5), Vec3::new(3.0, 20.0, 0.5))];
    for (k, kind) in kinds.iter().enumerate() {
        let mut slab =
            brick(Vec3::new(0.0, 2.0 * k as f64, 0.5 * THICK), Vec3::new(0.5, 0.5, 0.5 * THICK));
        slab.material = match kind {
            Dashpots::Sticking => 0,
            Dashpots::Closed => 1,
        };
        blocks.push(slab);
    }
    let mut setup = rock(blocks, law(Dashpots::Sticking));
    setup.materials.push(Material { name: "other rock".into(), ..setup.materials[0].clone() });
    setup.interfaces.push(InterfaceLaw {
        name: "closed".into(),
        bond: None,
        friction: None,
        joint: law(Dashpots::Closed),
    });
    setup.pair_table = vec![0, 1, 1, 1];
    let (sine, cosine) = SLOPE.to_radians().sin_cos();
    setup.gravity = G * Vec3::new(sine, 0.0, -cosine);
    setup.in_situ = Some(InSitu {
        stress: [0.0; 6],
        gradient: [0.0, 0.0, -DENSITY * G * cosine, 0.0, 0.0, 0.0],
        datum: THICK,
    });
    setup.supports.push(Support {
        blocks: vec![0],
        motion: Motion::Fixed { translation: [true; 3], rotation: [true; 3] },
    });
    setup
}

fn speed(run: &Run, slab: usize) -> f64 {
    run.world.bodies.velocity(slab).x
}

/// Mean acceleration of the first slab down the plane from 0.1 s to 0.3 s, m/s².
fn acceleration(run: &mut Run) -> f64 {
    run.steps(2000, DT);
    let early = speed(run, 1);
    run.steps(4000, DT);
    (speed(run, 1) - early) / (4000.0 * DT)
}

/// With dashpots on sliding points the slab crept at the speed at which they carry the excess of its weight.
#[test]
fn default_dashpots_do_not_hold_a_slab_that_slides() {
    for failure in [Failure::Point, Failure::Face] {
        let mut run = Run::new(slabs(&[Dashpots::default()], failure));
        let found = acceleration(&mut run);
        println!("{failure:?}: {found:.6} m/s2 of {:.6}", excess());
        assert!((found / excess() - 1.0).abs() < 1e-3, "{failure:?} {found}");
        let balance = run.balance();
        let error = balance.residual() / balance.works.friction;
        println!("friction {:.4e} J, residual {error:.1e}", balance.works.friction);
        assert!(balance.works.damping > 0.0 && error.abs() < 1e-3, "{error:e}");

        let mut run = Run::new(slabs(&[Dashpots::Closed], failure));
        run.steps(6000, DT);
        let shear = 2.0 * 7.2e9 / DISTANCE;
        let creep = DENSITY * THICK * excess() / (DAMPING * DISTANCE / CP * shear);
        let found = speed(&run, 1);
        assert!((found / creep - 1.0).abs() < 0.01, "{found:e} {creep:e}");
    }
}

/// A patch alone is done point by point, several side by side eight at a time; both kinds of dashpots may meet there.
#[test]
fn patches_side_by_side_slide_as_alone() {
    let kinds = [Dashpots::Sticking, Dashpots::Closed];
    let alone = kinds.map(|kind| {
        let mut run = Run::new(slabs(&[kind], Failure::Point));
        run.steps(4000, DT);
        run.world.bodies.displacement(1)
    });
    let many = [0, 1, 1, 0, 0, 1, 0, 0, 0];
    let mut run = Run::new(slabs(&many.map(|k| kinds[k]), Failure::Point));
    run.steps(4000, DT);
    for (slab, kind) in many.into_iter().enumerate() {
        let found = run.world.bodies.displacement(slab + 1);
        let error = (found - alone[kind]).length() / alone[kind].length();
        assert!(error < 1e-9, "slab {slab}: {error:e}");
    }
}

/// Laws are applied anew, without motion, after each edit and at the start of a phase: what slides still does.
#[test]
fn laws_applied_anew_do_not_brake_what_slides() {
    for count in [1, 3] {
        let kinds = vec![Dashpots::Sticking; count];
        let mut run = Run::new(slabs(&kinds, Failure::Point));
        run.steps(2000, DT);
        let early = speed(&run, 1);
        for _ in 0..1000 {
            run.evaluate(DT);
            run.scratch.invalidate(&mut run.world);
            run.evaluate(DT);
            assert!(run.world.patches.flags.iter().all(|f| f & flag::SLIDING != 0));
            advance(&mut run.world, &mut run.scratch, DT);
        }
        let found = (speed(&run, 1) - early) / (1000.0 * DT);
        assert!((found / excess() - 1.0).abs() < 1e-3, "{count}: {found}");
    }
}

/// A slab that starts with a speed has friction against it from the first instant.
#[test]
fn a_slab_that_starts_with_a_speed_slides_at_once() {
    for count in [1, 3] {
        let mut setup = slabs(&vec![Dashpots::Sticking; count], Failure::Point);
        for slab in &mut setup.blocks[1..] {
            slab.velocity = Vec3::new(0.0, 2.0, 0.0);
        }
        let mut run = Run::new(setup);
        run.steps(1, DT);
        // Half a step down the slope; dashpots would have taken 2 % of the speed.
        let lost = 2.0 - run.world.bodies.velocity(1).y;
        assert!(lost.abs() < 1e-3, "{count}: {lost}");
    }
}
