//! Bolts between rigid blocks: momentum, turning, the stable step, bits.

mod deformable;

use riprap_geom::{Quat, Vec3};

use crate::exec::Exec;
use crate::laws::bolt::{BarState, Design, pull_out_stiffness};
use crate::laws::parameters::{JointLaw, Stiffness};
use crate::push::bolts::install::install;
use crate::query::view::View;
use crate::setup::{BlockName, BlockSpec, Bolt, InterfaceLaw, Kinematics, Material, Setup, Shape};
use crate::stable::stable_step;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::step::{Damping, advance, evaluate};
use crate::topology::bolts::follow;
use crate::topology::take_out_gradually;

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

/// Bricks of 1 x 1 x 2 m above each other with gaps of 1 mm, the first at the bottom; bolts through all of them.
fn stack(count: usize, bolts: &[(f64, Design)], kinematics: Kinematics) -> Setup {
    let height = count as f64 * 2.001;
    let brick = |k: usize| BlockSpec {
        name: BlockName { base: 0, number: k as u32 + 1 },
        shape: Shape::Brick {
            centre: Vec3::new(0.0, 0.0, 1.0 + 2.001 * k as f64),
            half: Vec3::new(0.5, 0.5, 1.0),
        },
        material: 0,
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    };
    Setup {
        materials: vec![Material {
            name: "rock".to_owned(),
            density: 2600.0,
            young: Some(20e9),
            poisson: Some(0.25),
        }],
        names: vec!["rock".to_owned()],
        blocks: (0..count).map(brick).collect(),
        interfaces: vec![InterfaceLaw {
            name: "default".to_owned(),
            joint: JointLaw {
                stiffness: Stiffness::Given { normal: 1e9, shear: 1e9 },
                ..JointLaw::default()
            },
            friction: None,
            bond: None,
        }],
        pair_table: vec![0],
        bolts: (bolts.iter().enumerate())
            .map(|(k, (x, design))| Bolt {
                name: format!("bolt.{}", k + 1),
                head: Vec3::new(*x, 0.1, height - 0.001),
                toe: Vec3::new(*x, 0.0, 0.0),
                design: *design,
            })
            .collect(),
        kinematics,
        ..Setup::default()
    }
}

fn world(setup: Setup, exec: Exec) -> (World, Scratch) {
    let (mut world, mut scratch) = World::new(setup, exec).unwrap();
    let all: Vec<u32> = (0..world.setup.bolts.len() as u32).collect();
    install(&mut world, &all).unwrap();
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
fn blocks_on_bolts_keep_momentum_and_energy_while_the_bolts_yield_and_slip() {
    let dowel = Some([5e7, 30e3]);
    let bolts = [(-0.3, design()), (0.2, Design { dowel, ..design() })];
    let (mut world, mut scratch) = world(stack(3, &bolts, Kinematics::Automatic), Exec::serial());
    let v = Vec3::new(0.3, -0.1, 1.5);
    world.bodies.set_velocity(2, v, Vec3::new(0.1, 0.2, 0.3));
    let view = |w: &World, s: &Scratch| {
        let view = View { world: w, scratch: s };
        (view.momentum(), view.balance())
    };
    evaluate(&mut world, &mut scratch, &Damping::default(), 2e-5).unwrap();
    let (p, before) = view(&world, &scratch);
    world.start_energy = Some(before.total());
    run(&mut world, &mut scratch, 2e-5, 1500);
    let (q, after) = view(&world, &scratch);
    assert!((q - p).length() < 1e-11 * p.length());
    assert!(after.works.bolts > 0.05 * before.kinetic, "{after:?}");
    assert!(world.bolts.iter().all(|b| b.toll.left == 0.0));
    let residual = after.residual() / before.kinetic;
    assert!(residual.abs() < 1e-3, "{residual}");
}

#[test]
fn blocks_that_turn_together_strain_no_bolt() {
    let (mut world, mut scratch) =
        world(stack(2, &[(0.2, design())], Kinematics::Finite), Exec::serial());
    let turn = Quat::from_scaled_axis(Vec3::new(0.4, -0.3, 0.7));
    for b in 0..2 {
        let place = world.reference[b];
        world.bodies.set_displacement(b, turn * place - place, Vec3::ZERO);
        world.turned[b] =
            Some(Box::new(crate::state::bodies::Turned { attitude: turn, momentum: Vec3::ZERO }));
    }
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-5).unwrap();
    let most = world.bolts[0].chain.force.iter().fold(0.0, |m: f64, n| m.max(n.abs()));
    assert!(most < 1e-3, "{most}");
}

#[test]
fn the_stable_step_is_that_of_the_elastic_bolt() {
    let elastic = Design { bond: f64::INFINITY, yields: f64::INFINITY, ..design() };
    let plated = Design { plate: Some(f64::INFINITY), grouted: 1.8, ..elastic };
    for design in [elastic, plated] {
        let mut setup = stack(2, &[(0.0, design)], Kinematics::Small);
        setup.bolts[0].head.y = 0.0;
        setup.supports = vec![crate::setup::Support {
            blocks: vec![0],
            motion: crate::setup::Motion::Fixed { translation: [true; 3], rotation: [true; 3] },
        }];
        let grows = |share: f64| {
            let (mut world, mut scratch) = world(setup.clone(), Exec::serial());
            let dt = stable_step(&world, &scratch, 0.0).dt;
            if design.plate.is_none() {
                let k = 0.5 * pull_out_stiffness(1e9, AXIAL, 2.0);
                let closed = 2.0 / (k / 5200.0).sqrt();
                assert!((dt / closed - 1.0).abs() < 5e-3, "{dt} {closed}");
            }
            // Up, where the plate holds.
            world.bodies.set_velocity(1, 1e-6 * Vec3::Z, Vec3::ZERO);
            run(&mut world, &mut scratch, share * dt, 400);
            world.bodies.velocity(1).length() > 1e-4
        };
        assert!(!grows(0.98));
        assert!(grows(1.02) || design.plate.is_some());
    }
}

#[test]
fn threads_and_a_fresh_start_in_between_change_no_bit() {
    same_bits(&on_forty_bolts());
}

/// Four bricks on bolts that slip and shear as the uppermost one flies off.
fn on_forty_bolts() -> Setup {
    let bolts: Vec<(f64, Design)> = (0..40)
        .map(|k| {
            let dowel = Some([5e7, 3e3]);
            (0.02 * f64::from(k) - 0.4, Design { dowel, ..design() })
        })
        .collect();
    stack(4, &bolts, Kinematics::Automatic)
}

/// Runs a model of four blocks on one thread, and on two and then one from a fresh start.
fn same_bits(setup: &Setup) {
    let start = |threads: usize| {
        let (mut world, scratch) = world(setup.clone(), Exec::new(threads).unwrap());
        let v = Vec3::new(0.5, 0.2, 4.0);
        world.bodies.set_velocity(3, v, Vec3::ZERO);
        (world, scratch)
    };
    let (mut one, mut scratch) = start(1);
    run(&mut one, &mut scratch, 1e-5, 300);
    let (mut two, mut scratch) = start(2);
    run(&mut two, &mut scratch, 1e-5, 150);
    let mut two: World = two.clone();
    scratch = Scratch::new(&mut two, Exec::serial());
    advance_to(&mut two, &mut scratch, 300);
    assert!(one.works.bolts > 0.0);
    assert_eq!(one.hash(), two.hash());
    assert_eq!(one.works.bolts.to_bits(), two.works.bolts.to_bits());
}

fn advance_to(world: &mut World, scratch: &mut Scratch, steps: u64) {
    while world.step < steps {
        evaluate(world, scratch, &Damping::default(), 1e-5).unwrap();
        advance(world, scratch, 1e-5);
    }
    evaluate(world, scratch, &Damping::default(), 1e-5).unwrap();
}

#[test]
fn a_block_that_is_taken_out_leaves_a_free_length() {
    let (mut world, mut scratch) =
        world(stack(3, &[(0.1, design())], Kinematics::Small), Exec::serial());
    let nodes = world.bolts[0].pins.len();
    world.alive[1] = false;
    follow(&mut world);
    scratch.invalidate(&mut world);
    let bolt = &world.bolts[0];
    assert!(bolt.pins.iter().all(|p| p.block != 1));
    assert_eq!(bolt.pins.len(), nodes - 40);
    assert_eq!(bolt.chain.bars.len(), bolt.pins.len() - 1);
    let longest = bolt.chain.bars.iter().map(|b| AXIAL / b.stiffness);
    let longest = longest.fold(0.0, f64::max);
    assert!((longest - 2.052).abs() < 0.01, "{longest}");
    world.bodies.set_displacement(2, 1e-4 * Vec3::Z, Vec3::ZERO);
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-5).unwrap();
    let n = world.bolts[0].chain.force[39];
    let closed = 1e-4 / (2.0 / AXIAL + 2.0 / pull_out_stiffness(1e9, AXIAL, 2.0));
    assert!((n / closed - 1.0).abs() < 0.01, "{n} {closed}");
}

/// What a bolt carried across the boundary of blocks that are taken out gradually fades with the rest: at first nothing changes.
#[test]
fn the_force_of_a_bolt_fades_with_the_blocks_that_are_taken_out() {
    let (mut world, mut scratch) =
        world(stack(2, &[(0.1, design())], Kinematics::Small), Exec::serial());
    world.bodies.set_displacement(1, 1e-4 * Vec3::Z, Vec3::ZERO);
    let damping = Damping::default();
    evaluate(&mut world, &mut scratch, &damping, 0.0).unwrap();
    let before = scratch.net.force(0);
    assert!(before.z > 1e3, "{before}");
    take_out_gradually(&mut world, &mut scratch, &[1], 1.0, &damping).unwrap();
    follow(&mut world);
    scratch.invalidate(&mut world);
    evaluate(&mut world, &mut scratch, &damping, 0.0).unwrap();
    assert!(world.bolts.iter().all(|bolt| bolt.pins.iter().all(|pin| pin.block == 0)));
    let after = scratch.net.force(0);
    assert!((after - before).length() < 1e-9 * before.length(), "{before} {after}");
    // Forces after the span are those without block and load.
    world.time = 2.0;
    evaluate(&mut world, &mut scratch, &damping, 0.0).unwrap();
    assert!(scratch.net.force(0).length() < 1e-6 * before.length());
}

/// Bars as pictures and `bolts.csv` show them: every one between two nodes, at its place now, with its force and what has given way.
#[test]
fn bars_are_told_one_by_one() {
    let weak = Design { yields: 20e3, breaks: 1e-4, ..design() };
    let dowel = Some([5e7, 30e3]);
    let bolts = [(-0.3, weak), (0.2, Design { dowel, ..design() })];
    let (mut world, mut scratch) = world(stack(2, &bolts, Kinematics::Automatic), Exec::serial());
    let told = |world: &World, scratch: &Scratch| {
        let view = View { world, scratch };
        let bars = crate::read::bars::bars(&view);
        let name = |bolt: u32| world.setup.bolts[bolt as usize].name.as_str();
        let text = crate::frame::bars::csv(&bars, name);
        (bars, text.unwrap())
    };
    run(&mut world, &mut scratch, 1e-7, 1);
    let (bars, text) = told(&world, &scratch);
    let count: usize = world.bolts.iter().map(|b| b.chain.bars.len()).sum();
    assert_eq!((bars.len(), text.lines().count()), (count, count + 1));
    assert!(text.starts_with("name,element,x_m,") && text.contains("\nbolt.2,1,"));
    assert!(text.lines().skip(1).all(|line| line.ends_with(",elastic")));
    for pair in bars.windows(2).filter(|p| p[0].bolt == p[1].bolt) {
        assert_eq!((pair[0].ends[1], pair[0].bar + 1), (pair[1].ends[0], pair[1].bar));
    }
    // The upper block goes up and to the side: the weak bolt breaks at the joint, the other one slips and shears.
    let v = Vec3::new(0.4, 0.0, 1.0);
    world.bodies.set_velocity(1, v, Vec3::ZERO);
    run(&mut world, &mut scratch, 1e-6, 700);
    let (bars, text) = told(&world, &scratch);
    let at_joint = |bolt: u32| {
        let crossing = |b: &&crate::frame::bars::BoltBar| b.bolt == bolt && b.blocks == [1, 0];
        *bars.iter().find(crossing).unwrap()
    };
    let (broken, slipped) = (at_joint(0), at_joint(1));
    assert_eq!((broken.state, broken.force), (BarState::Broken, 0.0));
    assert_eq!(slipped.state, BarState::Slipped);
    assert!(slipped.slip > 0.0 && slipped.force > 50e3 && slipped.shear > 1e3);
    assert_eq!(text.matches(",broken\n").count(), 1);
    let line = text.lines().find(|l| l.ends_with(",broken")).unwrap();
    let numbers: Vec<f64> = line.split(',').skip(2).filter_map(|x| x.parse().ok()).collect();
    let [a, b] = broken.ends;
    assert_eq!(numbers[..3], [0, 1, 2].map(|k| 0.5 * (a[k] + b[k])));
    // The end in the upper block has gone with it and turned with it, by a few millionths.
    let pin = world.bolts[0].pins.iter().rfind(|p| p.block == 1).unwrap();
    let arm = pin.place - Vec3::new(0.0, 0.0, 3.001);
    let moved = world.bodies.displacement(1) + world.bodies.rotation(1).cross(arm);
    let place = pin.place + moved + world.setup.origin;
    assert!((Vec3::from_array(a) - place).length() < 1e-10, "{a:?} {place:?}");
}
