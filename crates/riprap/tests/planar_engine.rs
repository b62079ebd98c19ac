//! The planar engine against closed answers, without scenario files.

#![allow(
    clippy::disallowed_methods,
    reason = "tests may compare with the functions of the platform"
)]

use riprap::Vec2;
use riprap::exec::Exec;
use riprap::planar::setup::{
    BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Reflex, Setup, Support,
};
use riprap::planar::step::{Damping, Scratch, advance, evaluate};
use riprap::planar::view::View;
use riprap::planar::world::World;

fn law(normal: NormalLaw, phi_deg: f64) -> ContactLaw {
    ContactLaw {
        normal,
        reflex: Reflex::Min,
        normal_stiffness: 3e11,
        shear_stiffness: 3e11,
        friction: phi_deg.to_radians().tan(),
        cohesion: 0.0,
        friction_law: FrictionLaw::ShearSpring,
        clip_speed: 0.0,
        damping_ratio: 0.2,
    }
}

fn block(name: &str, points: &[Vec2]) -> BlockSpec {
    BlockSpec {
        name: name.into(),
        vertices: points.to_vec(),
        material: 0,
        density: 1000.0,
        velocity: Vec2::ZERO,
        spin: 0.0,
    }
}

fn setup(blocks: Vec<BlockSpec>, law: ContactLaw, fixed: &[u32]) -> Setup {
    Setup {
        gravity: [0.0, -10.0],
        materials: vec!["rock".into()],
        blocks,
        interfaces: vec![Interface {
            name: "default".into(),
            contact: law,
            bond: None,
        }],
        pair_table: vec![0],
        supports: vec![Support {
            blocks: fixed.to_vec(),
            motion: Motion::Fixed {
                x: true,
                y: true,
                rotation: true,
            },
        }],
        ..Setup::default()
    }
}

/// Block 1.0 x 0.5 m on a 35 degree slope, long side down.
fn incline(law: ContactLaw) -> Setup {
    let (s, c) = 35f64.to_radians().sin_cos();
    // x down the slope, y normal to it.
    let at = |x: f64, y: f64| Vec2::new(c * x + s * y, -s * x + c * y);
    let slope = [at(-2.0, -1.0), at(10.0, -1.0), at(10.0, 0.0), at(-2.0, 0.0)];
    let rock = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 0.5), at(0.0, 0.5)];
    setup(
        vec![block("slope", &slope), block("rock", &rock)],
        law,
        &[0],
    )
}

fn run(setup: Setup, dt: f64, time: f64) -> (World, Scratch) {
    let (mut world, mut scratch) = World::new(setup, Exec::serial());
    let steps = (time / dt).round() as u64;
    let damping = Damping::default();
    for _ in 0..steps {
        evaluate(&mut world, &mut scratch, &damping, dt).unwrap();
        if world.start_energy.is_none() {
            let view = View {
                world: &world,
                scratch: &scratch,
            };
            world.start_energy = Some(view.balance().total());
        }
        advance(&mut world, &mut scratch, dt);
    }
    evaluate(&mut world, &mut scratch, &damping, dt).unwrap();
    (world, scratch)
}

#[test]
fn slides_down_the_incline() {
    for (normal, phi, exact) in [
        (NormalLaw::DistancePotential, 0.0, 6.452_735),
        (NormalLaw::DistancePotential, 20.0, 3.098_582),
        (NormalLaw::PenetrationPotential, 15.0, 3.983_460),
    ] {
        let (world, scratch) = run(incline(law(normal, phi)), 1e-5, 1.5);
        let view = View {
            world: &world,
            scratch: &scratch,
        };
        let moved = view.displacement(1).length();
        let balance = view.balance();
        eprintln!(
            "{normal:?} phi {phi}: {moved} ({:+.1e}), residual {:.2e} of {:?}",
            moved / exact - 1.0,
            balance.residual_relative(),
            balance
        );
        assert!(
            (moved / exact - 1.0).abs() < 1e-4,
            "{moved} against {exact}"
        );
        assert!(balance.residual_relative().abs() < 1e-6);
    }
}

#[test]
fn one_degree_flatter_stands_still() {
    let (world, scratch) = run(incline(law(NormalLaw::DistancePotential, 36.0)), 1e-5, 1.5);
    let view = View {
        world: &world,
        scratch: &scratch,
    };
    eprintln!("creep {:e}", view.displacement(1).length());
    assert!(view.displacement(1).length() < 1e-6);
}

/// Round-off decides whether the short sides of the overlap are found; the energy must not care.
#[test]
fn equal_faces_store_the_energy_of_their_overlap() {
    for k in 0..40 {
        let angle = f64::from(k) * 0.17;
        let (s, c) = angle.sin_cos();
        let turned = |x: f64, y: f64| Vec2::new(c * x - s * y, s * x + c * y);
        let square = |y: f64| {
            [
                turned(0.3, y),
                turned(1.3, y),
                turned(1.3, y + 1.0),
                turned(0.3, y + 1.0),
            ]
        };
        let depth = 1e-5;
        let blocks = vec![
            block("low", &square(0.0)),
            block("high", &square(1.0 - depth)),
        ];
        let law = law(NormalLaw::DistancePotential, 30.0);
        let stiffness = law.normal_stiffness;
        let (mut world, mut scratch) = World::new(setup(blocks, law, &[0]), Exec::serial());
        evaluate(&mut world, &mut scratch, &Damping::default(), 1e-9).unwrap();
        let view = View {
            world: &world,
            scratch: &scratch,
        };
        // Force kn (L d - d^2), both ends of the contact being free.
        let stored = stiffness * (0.5 * depth * depth - depth.powi(3) / 3.0);
        let error = view.balance().contact_normal / stored - 1.0;
        assert!(error.abs() < 1e-9, "{angle}: {error:e}");
    }
}
