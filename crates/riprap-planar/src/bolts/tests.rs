//! Bolts between polygons: closed form, momentum and energy, the stable step, blocks that go.

use riprap_geom::Vec2;

use super::{follow, install, read};
use crate::exec::Exec;
use crate::laws::bolt::{Design, pull_out_stiffness};
use crate::laws::parameters::{ContactLaw, FrictionLaw, NormalLaw, Reflex};
use crate::setup::{BlockSpec, Bolt, Interface, Setup};
use crate::stable::stable_step;
use crate::step::{Damping, Scratch, advance, evaluate};
use crate::view::View;
use crate::world::World;

const AXIAL: f64 = 98.174_770e6;

fn design() -> Design {
    Design {
        axial: AXIAL,
        yields: 250e3,
        hardening: 0.0,
        breaks: f64::INFINITY,
        grout: 1e9,
        bond: 200e3,
        grouted: f64::INFINITY,
        plate: None,
        pretension: 0.0,
        dowel: None,
        piece: 0.05,
    }
}

/// Blocks of 1 x 2 m above each other with gaps of 1 mm, the first at the bottom; bolts through all of them.
fn stack(count: usize, bolts: &[(f64, Design)]) -> Setup {
    let block = |k: usize| {
        let low = 2.001 * k as f64;
        let corners = [[-0.5, low], [0.5, low], [0.5, low + 2.0], [-0.5, low + 2.0]];
        BlockSpec {
            name: format!("rock.{}", k + 1),
            vertices: corners.map(Vec2::from).to_vec(),
            material: 0,
            density: 2600.0,
            velocity: Vec2::ZERO,
            spin: 0.0,
        }
    };
    let contact = ContactLaw {
        normal: NormalLaw::DistancePotential,
        reflex: Reflex::Min,
        normal_stiffness: 1e9,
        shear_stiffness: 1e9,
        friction: 0.6,
        cohesion: 0.0,
        friction_law: FrictionLaw::ShearSpring,
        clip_speed: 0.0,
        damping_ratio: 0.0,
    };
    Setup {
        materials: vec!["rock".to_owned()],
        blocks: (0..count).map(block).collect(),
        interfaces: vec![Interface { name: "default".to_owned(), contact, bond: None }],
        pair_table: vec![0],
        bolts: (bolts.iter().enumerate())
            .map(|(k, (x, design))| Bolt {
                name: format!("bolt.{}", k + 1),
                head: Vec2::new(x + 0.1, count as f64 * 2.001 - 0.001),
                toe: Vec2::new(*x, 0.0),
                design: *design,
                spacing: 2.0,
            })
            .collect(),
        ..Setup::default()
    }
}

fn world(setup: Setup) -> (World, Scratch) {
    let (mut world, mut scratch) = World::new(setup, Exec::serial());
    let all: Vec<u32> = (0..world.setup.bolts.len() as u32).collect();
    install(&mut world, &scratch.shapes, &all).unwrap();
    scratch.invalidate(&mut world);
    (world, scratch)
}

fn run(world: &mut World, scratch: &mut Scratch, dt: f64, steps: usize) {
    for _ in 0..steps {
        evaluate(world, scratch, &Damping::default(), dt).unwrap();
        advance(world, scratch, dt);
    }
    evaluate(world, scratch, &Damping::default(), dt).unwrap();
}

#[test]
fn a_joint_opens_against_the_closed_form() {
    let (mut world, mut scratch) = world(stack(2, &[(0.0, design())]));
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-6).unwrap();
    assert_eq!(world.bolts[0].chain.largest_force(), 0.0);
    // Half of 0.1 mm along the bolt; the two sides of the joint are alike.
    let shift = 1e-4 * world.bolts[0].axis;
    world.bodies[1].position -= shift;
    world.pending = 1e-6;
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-6).unwrap();
    let length = 2.0 * world.bolts[0].axis.y.abs().recip();
    let wanted = 1e-4 * 0.5 * pull_out_stiffness(1e9, AXIAL, length);
    let force = world.bolts[0].chain.largest_force();
    // 0.3 % of the pieces, 0.2 % of the gap.
    assert!((force / wanted - 1.0).abs() < 6e-3, "{force} {wanted}");
    let view = View { world: &world, scratch: &scratch };
    let bars = read::bars(&view);
    let most = bars.iter().map(|b| b.force).fold(0.0, f64::max);
    // Of one bolt: two metres of thickness.
    assert_eq!(most, 2.0 * force);
    let crossing = bars.iter().find(|b| b.blocks == [1, 0]).unwrap();
    assert_eq!(crossing.force, most);
    assert_eq!(read::largest(&view, &[0], 0.0, read::force), most);
    assert!(read::largest(&view, &[1], 0.0, read::force).is_nan());
}

#[test]
fn blocks_on_bolts_keep_momentum_and_energy_while_the_bolts_yield_and_slip() {
    let dowel = Some([5e7, 30e3]);
    let bolts = [(-0.3, design()), (0.2, Design { dowel, ..design() })];
    let (mut world, mut scratch) = world(stack(3, &bolts));
    world.bodies[2].velocity = Vec2::new(0.3, 1.5);
    world.bodies[2].spin = 0.2;
    let look = |world: &World, scratch: &Scratch| {
        let view = View { world, scratch };
        let momentum: Vec2 =
            (view.living()).map(|b| scratch.shapes.mass[b] * view.velocity(b)).sum();
        (momentum, view.angular_momentum(), view.balance())
    };
    evaluate(&mut world, &mut scratch, &Damping::default(), 2e-6).unwrap();
    let before = look(&world, &scratch);
    world.start_energy = Some(before.2.total());
    run(&mut world, &mut scratch, 2e-6, 3000);
    let after = look(&world, &scratch);
    let size = before.0.length();
    assert!((after.0 - before.0).length() < 1e-11 * size, "{after:?}");
    // But for the dowels, whose two sides move apart along the bolt.
    assert!((after.1 - before.1).abs() < 1e-3 * before.1.abs());
    let balance = after.2;
    assert!(balance.works.bolts > 0.1 * before.2.kinetic, "{balance:?}");
    let left = balance.residual_relative();
    assert!(left.abs() < 2e-4, "{left} {balance:?}");
    assert!(world.bolts.iter().any(|b| b.chain.largest_slip() > 0.0));
    assert!(world.bolts[1].dowels.iter().any(|d| d.slip != Vec2::ZERO));
    // Evaluated twice nothing changes.
    let hash = world.hash();
    evaluate(&mut world, &mut scratch, &Damping::default(), 2e-6).unwrap();
    assert_eq!(world.hash(), hash);
}

#[test]
fn the_stable_step_knows_of_bolts() {
    let elastic = Design {
        yields: f64::INFINITY,
        bond: f64::INFINITY,
        dowel: Some([2e8, f64::INFINITY]),
        ..design()
    };
    let (mut world, mut scratch) = world(stack(2, &[(0.0, elastic), (0.3, elastic)]));
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-9).unwrap();
    let bare = World::new(stack(2, &[]), Exec::serial());
    let stable = |world: &World, scratch: &Scratch| {
        stable_step(world, &scratch.shapes, &scratch.candidates, 0.0).dt
    };
    let dt = stable(&world, &scratch);
    let start = 0.5 * 2600.0 * 2.0 * 2e-4;
    assert!(dt < stable(&bare.0, &bare.1));
    world.bodies[1].velocity = Vec2::new(0.01, 0.01);
    world.start_energy = Some(start);
    run(&mut world, &mut scratch, dt, 20_000);
    let view = View { world: &world, scratch: &scratch };
    let balance = view.balance();
    assert!(balance.residual_relative().abs() < 1e-2, "{balance:?}");
    // Three times the bound is too long: the bound is not far from the truth.
    let (mut world, mut scratch) = self::world(stack(2, &[(0.0, elastic), (0.3, elastic)]));
    world.bodies[1].velocity = Vec2::new(0.01, 0.01);
    let energy = |world: &World, scratch: &Scratch| View { world, scratch }.kinetic_energy();
    run(&mut world, &mut scratch, 3.0 * dt, 2000);
    assert!(energy(&world, &scratch) > 2.0 * start);
}

#[test]
fn bolts_lose_what_sits_in_blocks_that_go() {
    let dowel = Some([5e7, 30e3]);
    let (mut world, mut scratch) = world(stack(3, &[(0.0, Design { dowel, ..design() })]));
    let nodes = world.bolts[0].pins.len();
    assert_eq!((nodes, world.bolts[0].dowels.len()), (120, 2));
    world.alive[0] = false;
    follow(&mut world);
    scratch.invalidate(&mut world);
    let bolt = &world.bolts[0];
    assert_eq!((bolt.pins.len(), bolt.chain.bars.len()), (80, 79));
    assert_eq!(bolt.dowels.len(), 1);
    assert!(bolt.stretches(bolt.dowels[0].bar as usize));
    run(&mut world, &mut scratch, 1e-6, 3);
    world.alive[1] = false;
    world.alive[2] = false;
    follow(&mut world);
    assert!(world.bolts.is_empty());
}

#[test]
fn bolts_outside_the_rock_are_refused() {
    let mut setup = stack(2, &[(0.0, design())]);
    setup.bolts[0].head.y += 0.5;
    let (mut world, scratch) = World::new(setup, Exec::serial());
    let wrong = install(&mut world, &scratch.shapes, &[0]).unwrap_err();
    assert!(wrong.to_string().contains("lies outside the rock"), "{wrong}");
}
