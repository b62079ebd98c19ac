//! Times the step of the spatial engine on lattices of cubes and prints CSV: `bench_spatial [EDGE]...`.
//!
//! Run by `cargo xtask bench`. Each lattice has EDGE³ blocks of rock with random velocities, once elastic, once
//! with Mohr-Coulomb joints under in-situ stress that hold ("intact") and once with joints of no strength that open and
//! slide everywhere ("broken", the smallest lattice only). Times are medians over repeats with the smallest and
//! largest beside; both thread counts end at the same state.

#![allow(clippy::disallowed_methods, reason = "no result of a model: inputs of a timing")]

use std::time::Instant;

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::record::manifest::Machine;
use riprap::spatial::setup::{
    BlockName, BlockSpec, InSitu, InterfaceLaw, JointLaw, Kinematics, Material, Points, Setup,
    Shape, Strength,
};
use riprap::spatial::step::{Damping, Scratch, advance, evaluate};
use riprap::spatial::world::World;

const REPEATS: usize = 5;
/// Block-steps per repeat: long enough to time, short enough to wait for.
const WORK: usize = 5_000_000;
const DT: f64 = 5e-5;

/// How the joints behave.
#[derive(Clone, Copy)]
enum Joints {
    Elastic,
    Intact,
    Broken,
}

impl Joints {
    fn name(self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::Intact => "mohr-coulomb-intact",
            Self::Broken => "mohr-coulomb-broken",
        }
    }
}

fn lattice(edge: usize, joints: Joints) -> Setup {
    let mut blocks = Vec::with_capacity(edge * edge * edge);
    let mut seed = 1u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    for k in 0..edge * edge * edge {
        let at = [k % edge, k / edge % edge, k / (edge * edge)].map(|n| n as f64 + 0.5);
        blocks.push(BlockSpec {
            name: BlockName { base: 0, number: k as u32 + 1 },
            shape: Shape::Brick { centre: Vec3::from_array(at), half: Vec3::splat(0.5) },
            material: 0,
            velocity: 1e-3 * Vec3::new(draw(), draw(), draw()),
            spin: 1e-3 * Vec3::new(draw(), draw(), draw()),
        });
    }
    let cohesion = match joints {
        Joints::Elastic | Joints::Intact => 4.16e6,
        Joints::Broken => 0.0,
    };
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
                strength: match joints {
                    Joints::Elastic => None,
                    Joints::Intact | Joints::Broken => Some(strength),
                },
                points: Points::Quarter,
                ..JointLaw::default()
            },
        }],
        pair_table: vec![0],
        in_situ: match joints {
            Joints::Elastic | Joints::Broken => None,
            Joints::Intact => Some(InSitu {
                stress: [0.0; 6],
                gradient: [-8e3, -8e3, -24e3, 0.0, 0.0, 0.0],
                datum: edge as f64,
            }),
        },
        periodic: [Some(edge as f64); 3],
        kinematics: Kinematics::Small,
        ..Setup::default()
    }
}

fn run(world: &mut World, scratch: &mut Scratch, steps: usize) -> Result<(), String> {
    for _ in 0..steps {
        evaluate(world, scratch, &Damping::default(), DT).map_err(|e| e.to_string())?;
        advance(world, scratch, DT);
    }
    Ok(())
}

/// Memory in use by this process, kB; 0 where the system does not tell.
fn resident_kb() -> f64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find(|l| l.starts_with("VmRSS:"));
    line.and_then(|l| l.split_whitespace().nth(1)?.parse().ok()).unwrap_or(0.0)
}

fn measure(edge: usize, joints: Joints, threads: usize) -> Result<String, String> {
    let before = resident_kb();
    let exec = Exec::new(threads).map_err(|e| e.to_string())?;
    let start = Instant::now();
    let setup = lattice(edge, joints);
    let (mut world, mut scratch) = World::new(setup, exec).map_err(|e| e.to_string())?;
    let build = start.elapsed().as_secs_f64();
    run(&mut world, &mut scratch, 3)?;
    let memory = resident_kb() - before;
    let count = world.alive.len();
    let steps = (WORK / count).max(5);
    let stages = scratch.profile.seconds();
    let mut times = Vec::new();
    for _ in 0..REPEATS {
        let start = Instant::now();
        run(&mut world, &mut scratch, steps)?;
        times.push(start.elapsed().as_secs_f64() / steps as f64);
    }
    times.sort_by(f64::total_cmp);
    let median = times[REPEATS / 2];
    let spent: Vec<(String, f64)> = scratch
        .profile
        .seconds()
        .into_iter()
        .zip(stages)
        .map(|((name, after), (_, before))| (name, after - before))
        .collect();
    let all: f64 = spent.iter().map(|(_, s)| s).sum();
    let split: Vec<String> =
        spent.iter().map(|(name, s)| format!("{name} {:.0} %", 100.0 * s / all)).collect();
    Ok(format!(
        "{},{count},{},{threads},{steps},{:.3},{:.3},{:.3},{:.2},{:.2},{build:.2},{}",
        joints.name(),
        world.patches.len(),
        1e3 * median,
        1e3 * times[0],
        1e3 * times[REPEATS - 1],
        1e-6 * count as f64 / median,
        memory / count as f64,
        split.join(" | "),
    ))
}

fn main() -> Result<(), String> {
    let edges: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let edges = if edges.is_empty() { vec![32, 64, 100] } else { edges };
    let machine = Machine::this();
    println!("# {} ({} cores), {} {}", machine.cpu, machine.cores, machine.os, machine.arch);
    println!(
        "joints,blocks,patches,threads,steps,median_ms_per_step,min_ms,max_ms,\
         million_block_updates_per_s,kb_per_block,build_s,stages"
    );
    for &edge in &edges {
        for joints in [Joints::Elastic, Joints::Intact, Joints::Broken] {
            if matches!(joints, Joints::Broken) && edge != edges[0] {
                continue;
            }
            for threads in [1, 2] {
                println!("{}", measure(edge, joints, threads)?);
            }
        }
    }
    Ok(())
}
