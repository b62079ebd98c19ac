//! Times how long it takes to let joints go between two steps: `bench_drop [EDGE [BLOCKS]]`.
//!
//! A lattice of EDGE³ cubes (46: 97,336) of which BLOCKS (167: 1,002 joints), apart from each other, are pushed aside by more than their
//! joints can follow. Prints the time of the evaluation in which all of these joints give way to found contact, that of
//! the evaluation after it, and that of a usual one before.

#![allow(
    clippy::disallowed_methods,
    reason = "no result of a model: inputs of a timing"
)]

use std::time::Instant;

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::spatial::setup::{
    BlockName, BlockSpec, Dashpots, Failure, InterfaceLaw, JointLaw, Kinematics, Material, Points,
    Setup, Shape, Stiffness, StiffnessRule, Strength,
};
use riprap::spatial::step::{Damping, Scratch, advance, evaluate};
use riprap::spatial::world::{World, flag};

const DT: f64 = 5e-6;

fn lattice(edge: usize) -> Setup {
    let mut blocks = Vec::with_capacity(edge * edge * edge);
    let mut seed = 1u64;
    let mut draw = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    for k in 0..edge * edge * edge {
        let at = [k % edge, k / edge % edge, k / (edge * edge)].map(|n| n as f64 + 0.5);
        blocks.push(BlockSpec {
            name: BlockName {
                base: 0,
                number: k as u32 + 1,
            },
            shape: Shape::Brick {
                centre: Vec3::from_array(at),
                half: Vec3::splat(0.5),
            },
            material: 0,
            velocity: 1e-3 * Vec3::new(draw(), draw(), draw()),
            spin: 1e-3 * Vec3::new(draw(), draw(), draw()),
        });
    }
    let cohesion = 4.16e6;
    let friction = 30f64.to_radians().tan();
    let strength = Strength {
        cohesion,
        tension: 0.25 * cohesion,
        friction,
        residual_friction: friction,
        residual_cohesion: 0.0,
        dilation: 0.0,
        dilation_end: 0.0,
    };
    Setup {
        materials: vec![Material {
            name: "rock".into(),
            density: 2400.0,
            young: Some(18e9),
            poisson: Some(0.25),
        }],
        names: vec!["rock".into()],
        blocks,
        interfaces: vec![InterfaceLaw {
            name: "joint".into(),
            bond: None,
            friction: None,
            joint: JointLaw {
                stiffness: Stiffness::Rule(StiffnessRule::Material),
                strength: Some(strength),
                behaviour: Default::default(),
                failure: Failure::Point,
                points: Points::Quarter,
                damping: 0.0,
                contact_damping: 0.0,
                dashpots: Dashpots::Sticking,
            },
        }],
        pair_table: vec![0],
        found_contacts: true,
        kinematics: Kinematics::Small,
        ..Setup::default()
    }
}

fn timed(world: &mut World, scratch: &mut Scratch) -> Result<f64, String> {
    let start = Instant::now();
    evaluate(world, scratch, &Damping::default(), DT).map_err(|e| e.to_string())?;
    Ok(1e3 * start.elapsed().as_secs_f64())
}

fn main() -> Result<(), String> {
    let given: Vec<usize> = std::env::args()
        .skip(1)
        .filter_map(|a| a.parse().ok())
        .collect();
    let edge = given.first().copied().unwrap_or(46);
    let count = given.get(1).copied().unwrap_or(167);
    println!("blocks,joints,gone,usual_ms,giving_way_ms,after_ms");
    for _ in 0..3 {
        let built = World::new(lattice(edge), Exec::serial());
        let (mut world, mut scratch) = built.map_err(|e| e.to_string())?;
        for _ in 0..15 {
            evaluate(&mut world, &mut scratch, &Damping::default(), DT)
                .map_err(|e| e.to_string())?;
            advance(&mut world, &mut scratch, DT);
        }
        let mut usual: Vec<f64> = Vec::new();
        for _ in 0..5 {
            usual.push(timed(&mut world, &mut scratch)?);
        }
        usual.sort_by(f64::total_cmp);
        // Every third block along each axis, inside.
        let inside = |k: &usize| {
            [k % edge, k / edge % edge, k / (edge * edge)]
                .iter()
                .all(|n| n % 3 == 1 && n + 1 < edge)
        };
        let loose: Vec<usize> = (0..edge * edge * edge).filter(inside).take(count).collect();
        for &b in &loose {
            let moved = world.bodies.displacement(b) + Vec3::new(0.06, 0.06, 0.06);
            let turned = world.bodies.rotation(b);
            world.bodies.set_displacement(b, moved, turned);
        }
        for p in 0..world.patches.len() {
            if world.patches.ends[p]
                .iter()
                .any(|b| loose.binary_search(&(*b as usize)).is_ok())
            {
                world.patches.flags[p] |= flag::BROKEN;
            }
        }
        let joints = world.patches.len();
        advance(&mut world, &mut scratch, DT);
        assert!(
            world.step.is_multiple_of(16),
            "joints are looked at every 16 steps"
        );
        let giving = timed(&mut world, &mut scratch)?;
        let gone = joints - world.patches.len();
        advance(&mut world, &mut scratch, DT);
        let after = timed(&mut world, &mut scratch)?;
        println!(
            "{},{joints},{gone},{:.2},{giving:.2},{after:.2}",
            edge * edge * edge,
            usual[2]
        );
    }
    Ok(())
}
