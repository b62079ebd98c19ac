//! Bolts in deformable blocks: as in rigid ones where these move as a whole, momentum and energy, the stable step, cuts, bits.

use riprap_geom::Vec3;

use crate::exec::Exec;
use crate::laws::bolt::Design;
use crate::push::bolts::install::install;
use crate::push::bolts::stiffness::{on_masses, row_sums};
use crate::push::bolts::tests::{AXIAL, design, on_forty_bolts, run, same_bits, stack, world};
use crate::query::view::View;
use crate::setup::deform::{BondFailure, BondLaw, BondSprings, DeformableSet, Deformables, Strain};
use crate::setup::{Kinematics, Setup};
use crate::stable::stable_step;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::step::{Damping, advance, evaluate};
use crate::topology::cut;

const DOWEL: Option<[f64; 2]> = Some([5e7, 30e3]);

/// Lets some blocks deform; cuts bond them.
fn soft(mut setup: Setup, blocks: &[u32]) -> Setup {
    setup.deform = Deformables {
        sets: vec![DeformableSet {
            blocks: blocks.to_vec(),
            strain: Strain::Small,
            displacement: [None, None, None],
            velocity: [None, None, None],
        }],
        ..Deformables::default()
    };
    setup.interfaces[0].bond = Some(BondLaw {
        springs: BondSprings::Thickness { thickness: 1e-3, moduli: None },
        strength: None,
        cohesive: None,
        failure: BondFailure::Spring,
    });
    setup
}

/// Moves a block by `u`, nodes and all.
fn shift(world: &mut World, block: u32, u: Vec3) {
    let body = world.deform.as_deref().and_then(|d| d.body(block as usize));
    match body.copied() {
        None => {
            let now = world.bodies.displacement(block as usize);
            world.bodies.set_displacement(block as usize, now + u, Vec3::ZERO);
        }
        Some(body) => {
            let nodes = &mut world.deform.as_mut().unwrap().nodes;
            for n in body.nodes() {
                let now = Vec3::from_array(nodes.displacement[n]);
                nodes.displacement[n] = (now + u).to_array();
            }
        }
    }
}

fn look(world: &mut World, scratch: &mut Scratch) {
    evaluate(world, scratch, &Damping::default(), 1e-6).unwrap();
}

/// Forces of bars and dowels of all bolts, N.
fn forces(world: &World) -> Vec<f64> {
    let mut all = Vec::new();
    for bolt in &world.bolts {
        all.extend_from_slice(&bolt.chain.force);
        all.extend(bolt.dowels.iter().flat_map(|d| d.force.to_array()));
    }
    all
}

fn differ(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let each = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    each.fold(0.0, f64::max)
}

#[test]
fn blocks_that_move_as_a_whole_hold_a_bolt_as_rigid_ones() {
    let plated = Design { dowel: DOWEL, plate: Some(f64::INFINITY), pretension: 40e3, ..design() };
    let bolts = [(-0.3, plated), (0.2, Design { dowel: DOWEL, ..design() })];
    let moved = |blocks: &[u32]| {
        let mut setup = stack(3, &bolts, Kinematics::Automatic);
        // A plate lies on the face.
        setup.bolts[0].head.z += 1e-3;
        let (mut world, mut scratch) = world(soft(setup, blocks), Exec::serial());
        shift(&mut world, 2, Vec3::new(1e-4, -2e-4, 8e-4));
        shift(&mut world, 0, Vec3::new(0.0, 3e-4, -1e-4));
        look(&mut world, &mut scratch);
        let lost = world.works.bolts;
        (forces(&world), lost, world.bolt_energy())
    };
    let (rigid, lost, stored) = moved(&[]);
    assert!(rigid.iter().any(|f| f.abs() > 60e3) && lost > 1.0);
    for blocks in [vec![0, 1, 2], vec![1], vec![0, 2]] {
        let (soft, soft_lost, soft_stored) = moved(&blocks);
        assert!(differ(&rigid, &soft) < 1e-3, "{blocks:?} {}", differ(&rigid, &soft));
        assert!((soft_lost / lost - 1.0).abs() < 1e-7);
        assert!((soft_stored / stored - 1.0).abs() < 1e-7);
    }
}

/// A bar of rock between two ends that part, all of it strained alike: a bolt in stiff grout goes along, `N = EA_b (1 - cosh(l x)/cosh(l L/2)) u/L`.
#[test]
fn a_bolt_shares_the_strain_of_the_rock_around_it() {
    let elastic = Design { bond: f64::INFINITY, yields: f64::INFINITY, piece: 0.02, ..design() };
    let (mut world, mut scratch) =
        world(soft(stack(1, &[(0.0, elastic)], Kinematics::Small), &[0]), Exec::serial());
    let strain = 1e-4;
    let nodes = &mut world.deform.as_mut().unwrap().nodes;
    for (u, x) in nodes.displacement.iter_mut().zip(&nodes.place) {
        *u = [0.0, 0.0, strain * x.z];
    }
    look(&mut world, &mut scratch);
    let bolt = &world.bolts[0];
    let lambda = (1e9 / AXIAL).sqrt();
    for x in [0.0, 0.3, 0.6, 0.8] {
        let bar = (0..bolt.chain.bars.len())
            .min_by(|a, b| {
                let off = |k: usize| {
                    let along = 0.5 * (bolt.pins[k].along + bolt.pins[k + 1].along);
                    (along - 1.0 - x).abs()
                };
                off(*a).total_cmp(&off(*b))
            })
            .unwrap();
        let at = 0.5 * (bolt.pins[bar].along + bolt.pins[bar + 1].along) - 1.0;
        let closed = AXIAL * strain * (1.0 - libm::cosh(lambda * at) / libm::cosh(lambda));
        let found = bolt.chain.force[bar];
        // The bolt leans by 5 cm in 2 m.
        assert!((found / closed - 1.0).abs() < 1e-2, "{x} {found} {closed}");
    }
    // What the bolt does to the rock is in balance.
    let sum: Vec3 = world.bolt_forces().iter().map(|f| f.2).sum();
    assert!(sum.length() < 1e-9 * AXIAL * strain);
}

#[test]
fn rigid_and_deformable_blocks_on_bolts_keep_momentum_and_energy() {
    let bolts = [(-0.3, design()), (0.2, Design { dowel: DOWEL, ..design() })];
    let setup = soft(stack(4, &bolts, Kinematics::Automatic), &[1, 2]);
    let (mut world, mut scratch) = world(setup, Exec::serial());
    let v = Vec3::new(0.3, -0.1, 1.5);
    world.bodies.set_velocity(3, v, Vec3::new(0.1, 0.2, 0.3));
    let view = |w: &World, s: &Scratch| {
        let view = View { world: w, scratch: s };
        (view.momentum(), view.balance())
    };
    let dt = 0.5 * stable_step(&world, &scratch, 0.0).dt;
    evaluate(&mut world, &mut scratch, &Damping::default(), dt).unwrap();
    let (p, before) = view(&world, &scratch);
    world.start_energy = Some(before.total());
    run(&mut world, &mut scratch, dt, (0.02 / dt) as usize);
    let (q, after) = view(&world, &scratch);
    assert!((q - p).length() < 1e-11 * p.length());
    assert!(after.works.bolts > 0.05 * before.kinetic, "{after:?}");
    assert!(after.bond > 1e-4 * before.kinetic, "{after:?}");
    assert!(world.bolts.iter().all(|b| b.toll.left == 0.0));
    let residual = after.residual() / before.kinetic;
    assert!(residual.abs() < 1e-3, "{residual}");
}

#[test]
fn a_bolt_is_straight_and_without_force_in_the_rock_as_it_is_then() {
    let setup = soft(stack(2, &[(0.2, design())], Kinematics::Small), &[0, 1]);
    let (mut world, scratch) = World::new(setup, Exec::serial()).unwrap();
    let mut scratch = scratch;
    let bend = |x: Vec3| 1e-3 * Vec3::new(x.z * x.z - 2.0, x.x * x.y, 0.3 * x.x);
    let nodes = &mut world.deform.as_mut().unwrap().nodes;
    for (u, x) in nodes.displacement.iter_mut().zip(&nodes.place) {
        *u = bend(*x).to_array();
    }
    install(&mut world, &[0]).unwrap();
    scratch.invalidate(&mut world);
    look(&mut world, &mut scratch);
    assert!(forces(&world).iter().all(|f| f.abs() < 1e-6));
    let spec = world.setup.bolts[0].clone();
    let freedoms = world.all_freedoms();
    let deform = world.deform.as_deref().unwrap();
    let mut bent = 0.0;
    for pin in &world.bolts[0].pins {
        // The point hangs where the rock was before it moved: on the line it is now.
        let start: Vec3 =
            (pin.anchor.nodes()).map(|(n, w)| w * deform.nodes.place[n as usize]).sum();
        let now = start + freedoms.displacement_inside(&pin.anchor);
        let line = spec.head + pin.along * (spec.toe - spec.head).normalize();
        assert!((now - line).length() < 1e-12, "{now} {line}");
        bent += (start - line).length();
    }
    assert!(bent / world.bolts[0].pins.len() as f64 > 3e-4, "{bent}");
}

/// Soft rock on stiff grout: what the bolt adds sets the step, which would be too long without it.
#[test]
fn the_stable_step_counts_bolts_on_nodes() {
    let plated = Design {
        bond: f64::INFINITY,
        yields: f64::INFINITY,
        plate: Some(f64::INFINITY),
        dowel: Some([5e8, f64::INFINITY]),
        ..design()
    };
    let mut setup = soft(stack(2, &[(0.1, plated)], Kinematics::Small), &[0, 1]);
    setup.bolts[0].head.z += 1e-3;
    setup.materials[0].young = Some(2e7);
    let steps = |installed: bool| {
        let (mut world, mut scratch) = World::new(setup.clone(), Exec::serial()).unwrap();
        if installed {
            install(&mut world, &[0]).unwrap();
            scratch.invalidate(&mut world);
        }
        let stable = stable_step(&world, &scratch, 0.0);
        (world, scratch, stable)
    };
    let (_, _, free) = steps(false);
    let (_, _, bolted) = steps(true);
    assert_eq!(bolted.why, "nodes on the springs of bolts");
    assert!(bolted.dt < 0.5 * free.dt, "{bolted:?} {free:?}");
    let grows = |dt: f64| {
        let (mut world, mut scratch, _) = steps(true);
        let nodes = &mut world.deform.as_mut().unwrap().nodes;
        for (k, v) in nodes.velocity.iter_mut().enumerate() {
            *v = [0.3, 1.1, 2.7].map(|c| 1e-6 * libm::sin(c * (k as f64 + 1.0)));
        }
        for _ in 0..400 {
            if evaluate(&mut world, &mut scratch, &Damping::default(), dt).is_err() {
                return true;
            }
            advance(&mut world, &mut scratch, dt);
        }
        let nodes = &world.deform.as_ref().unwrap().nodes;
        let fast = nodes.velocity.as_flattened().iter();
        fast.fold(0.0, |m: f64, v| m.max(v.abs())) > 1e-4
    };
    assert!(!grows(bolted.dt));
    assert!(grows(0.98 * free.dt));
    // The bound is not far from it.
    assert!(grows(4.0 * bolted.dt));
}

#[test]
fn fictitious_masses_count_bolts_on_nodes() {
    let setup = soft(stack(2, &[(0.1, design())], Kinematics::Small), &[1]);
    let (world, scratch) = world(setup, Exec::serial());
    let sums = row_sums(&world);
    let nodes = world.deform.as_deref().unwrap().nodes.len();
    assert_eq!(sums.len(), nodes);
    // 40 pieces of 5 cm hold with 50 MN/m each against bars of 1963 MN/m on both sides.
    let each = 50e6 * 2.0 / (1.0 + 50e6 / (2.0 * AXIAL / 0.05)) * 1.3660254;
    let all: f64 = sums.iter().sum();
    assert!((all / (40.0 * each) - 1.0).abs() < 2e-3, "{all} {each}");
    let masses = &scratch.deform.as_deref().unwrap().masses;
    let (square, node) = on_masses(&world, masses);
    assert!(square > 0.0 && node.is_some());
}

/// A cut through the rock on a bolt: the bolt goes on with the forces it had, hangs on the parts, and dowels the crack.
#[test]
fn a_bolt_goes_on_through_a_block_that_is_cut() {
    let all = Design { dowel: DOWEL, ..design() };
    let setup = soft(stack(2, &[(0.1, all)], Kinematics::Small), &[0, 1]);
    let (mut world, mut scratch) = world(setup, Exec::serial());
    let nodes = &mut world.deform.as_mut().unwrap().nodes;
    for (u, x) in nodes.displacement.iter_mut().zip(&nodes.place) {
        *u = (1e-4 * Vec3::new(0.3 * x.x * x.z, 0.0, 0.5 * x.z + x.x)).to_array();
    }
    shift(&mut world, 1, Vec3::new(1e-4, 0.0, 3e-4));
    look(&mut world, &mut scratch);
    let (before, dowels) = (world.bolts[0].clone(), world.bolts[0].dowels.len());
    assert!(before.chain.largest_force() > 20e3 && dowels == 1);
    let normal = Vec3::new(0.2, 0.1, 1.0).normalize();
    let parts = cut::one(&mut world, &mut scratch, (1, normal, 1), 1e-9).unwrap();
    assert_eq!(parts.len(), 2);
    let after = &world.bolts[0];
    assert_eq!(after.chain.bars.len(), before.chain.bars.len());
    let most = before.chain.largest_force();
    assert!(differ(&after.chain.force, &before.chain.force) < 1e-9 * most);
    assert!(after.pins.iter().all(|p| world.alive[p.block as usize]));
    let on = |block: u32| after.pins.iter().filter(|p| p.block == block).count();
    assert_eq!(on(0), 40);
    assert!(on(parts[0]) > 10 && on(parts[1]) > 10);
    // The dowel at the joint stays, that of the crack begins without force where it crosses the bolt.
    assert_eq!(after.dowels.len(), 2);
    let [crack, joint] = [&after.dowels[0], &after.dowels[1]];
    assert_eq!(joint.force, before.dowels[0].force);
    assert_eq!(crack.force, Vec3::ZERO);
    let blocks = crack.sides.map(|side| side.block);
    assert!(parts.iter().all(|p| blocks.contains(p)));
    let bars = [0, 1].map(|k| after.pins[crack.bar as usize + k].along);
    assert!(bars[0] < crack.sides[0].along && crack.sides[0].along < bars[1]);
    // One part moves along the crack and away from it: bar and dowel hold it.
    shift(&mut world, blocks[0], Vec3::new(2e-4, 0.0, 1e-4));
    world.fresh = true;
    look(&mut world, &mut scratch);
    let bolt = &world.bolts[0];
    let crack = &bolt.dowels[0];
    assert!((crack.force.length() / (5e7 * 2e-4) - 1.0).abs() < 0.05);
    let grown = bolt.chain.force[crack.bar as usize] - before.chain.force[crack.bar as usize];
    assert!(grown > 10e3, "{grown}");
}

#[test]
fn a_deformable_block_that_is_taken_out_leaves_a_free_length() {
    let setup = soft(stack(3, &[(0.1, design())], Kinematics::Small), &[0, 1, 2]);
    let (mut world, mut scratch) = world(setup, Exec::serial());
    let nodes = world.bolts[0].pins.len();
    crate::topology::remove(&mut world, &[1]);
    scratch.invalidate(&mut world);
    let bolt = &world.bolts[0];
    assert!(bolt.pins.iter().all(|p| p.block != 1));
    assert_eq!(bolt.pins.len(), nodes - 40);
    look(&mut world, &mut scratch);
}

#[test]
fn threads_and_a_fresh_start_in_deformable_blocks_change_no_bit() {
    same_bits(&soft(on_forty_bolts(), &[0, 2]));
}
