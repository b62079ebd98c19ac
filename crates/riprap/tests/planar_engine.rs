//! The planar engine against closed answers, without scenario files.

use riprap::Vec2;
use riprap::exec::Exec;
use riprap::planar::setup::{
    BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Reflex, Setup, Support,
};
use riprap::planar::step::{Damping, evaluate};
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
        interfaces: vec![Interface { name: "default".into(), contact: law, bond: None }],
        pair_table: vec![0],
        supports: vec![Support {
            blocks: fixed.to_vec(),
            motion: Motion::Fixed { x: true, y: true, rotation: true },
        }],
        ..Setup::default()
    }
}

/// Round-off decides whether the short sides of the overlap are found; the energy must not care.
#[test]
fn equal_faces_store_the_energy_of_their_overlap() {
    for k in 0..40 {
        let angle = f64::from(k) * 0.17;
        let (s, c) = angle.sin_cos();
        let turned = |x: f64, y: f64| Vec2::new(c * x - s * y, s * x + c * y);
        let square =
            |y: f64| [turned(0.3, y), turned(1.3, y), turned(1.3, y + 1.0), turned(0.3, y + 1.0)];
        let depth = 1e-5;
        let blocks = vec![block("low", &square(0.0)), block("high", &square(1.0 - depth))];
        let law = law(NormalLaw::DistancePotential, 30.0);
        let stiffness = law.normal_stiffness;
        let (mut world, mut scratch) = World::new(setup(blocks, law, &[0]), Exec::serial());
        evaluate(&mut world, &mut scratch, &Damping::default(), 1e-9).unwrap();
        let view = View { world: &world, scratch: &scratch };
        // Force kn (L d - d^2), both ends of the contact being free.
        let stored = stiffness * (0.5 * depth * depth - depth.powi(3) / 3.0);
        let error = view.balance().contact_normal / stored - 1.0;
        assert!(error.abs() < 1e-9, "{angle}: {error:e}");
    }
}

#[test]
fn a_block_that_is_held_in_part_counts_with_what_is_left_to_it() {
    let square = [[0.0, 5.0], [1.0, 5.0], [1.0, 6.0], [0.0, 6.0]].map(Vec2::from);
    let mut model =
        setup(vec![block("falls", &square)], law(NormalLaw::DistancePotential, 30.0), &[0]);
    for (y, unbalanced) in [(false, 1.0), (true, 0.0)] {
        model.supports[0].motion = Motion::Fixed { x: true, y, rotation: true };
        let (mut world, mut scratch) = World::new(model.clone(), Exec::serial());
        evaluate(&mut world, &mut scratch, &Damping::default(), 1e-4).unwrap();
        let view = View { world: &world, scratch: &scratch };
        assert_eq!(view.unbalanced(), unbalanced);
        assert_eq!(view.acceleration(0), (Vec2::new(0.0, -10.0 * unbalanced), 0.0));
    }
}
