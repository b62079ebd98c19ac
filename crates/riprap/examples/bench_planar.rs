//! Times the step of a settled running-bond wall and prints CSV: `bench_planar [BLOCKS]...`.
//!
//! Run by `cargo xtask bench`. One row per size and number of threads; times are medians over
//! repeats with the smallest and largest beside them. The courses stand on each other with the static
//! overlap that their load needs, so that the wall is at rest from the start.

use std::time::Instant;

use riprap::Vec2;
use riprap::exec::Exec;
use riprap::planar::fields::View;
use riprap::planar::setup::{
    BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Setup, Support,
};
use riprap::planar::step::{Damping, Scratch, advance, evaluate};
use riprap::planar::world::World;
use riprap::record::manifest::Machine;
use riprap::run::hash;

const DENSITY: f64 = 2600.0;
const GRAVITY: f64 = 9.81;
const STIFFNESS: f64 = 1e10;
const DT: f64 = 2e-5;
const SETTLE: usize = 300;
const REPEATS: usize = 5;
/// Block-steps per repeat: long enough to time, short enough to wait for.
const WORK: usize = 1_000_000;

/// A running-bond wall of about `blocks` blocks of 1 m x 0.5 m on a fixed base.
fn wall(blocks: usize) -> Setup {
    let rows = (blocks as f64 / 2.0).sqrt().round().max(1.0) as usize;
    let per_row = blocks.div_ceil(rows);
    let rectangle = |x: f64, y: f64, w: f64, h: f64| {
        [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
            .map(Vec2::from)
            .to_vec()
    };
    let mut outlines = vec![rectangle(-5.0, -1.0, per_row as f64 + 10.0, 1.0)];
    let mut sunk = 0.0;
    for r in 0..rows {
        sunk += (rows - r) as f64 * 0.5 * DENSITY * GRAVITY / STIFFNESS;
        for c in 0..per_row {
            let x = c as f64 + 0.5 * (r % 2) as f64;
            outlines.push(rectangle(x, 0.5 * r as f64 - sunk, 1.0, 0.5));
        }
    }
    Setup {
        gravity: [0.0, -GRAVITY],
        materials: vec!["rock".into()],
        blocks: outlines
            .into_iter()
            .enumerate()
            .map(|(k, vertices)| BlockSpec {
                name: k.to_string(),
                vertices,
                material: 0,
                density: DENSITY,
                velocity: Vec2::ZERO,
                spin: 0.0,
            })
            .collect(),
        interfaces: vec![Interface {
            name: "default".into(),
            contact: ContactLaw {
                normal: NormalLaw::DistancePotential,
                normal_stiffness: STIFFNESS,
                shear_stiffness: 0.5 * STIFFNESS,
                friction: 0.6,
                cohesion: 0.0,
                friction_law: FrictionLaw::ShearSpring,
                damping_ratio: 0.2,
            },
            bond: None,
        }],
        pair_table: vec![0],
        supports: vec![Support {
            blocks: vec![0],
            motion: Motion::Fixed {
                x: true,
                y: true,
                rotation: true,
            },
        }],
        ..Setup::default()
    }
}

fn run(world: &mut World, scratch: &mut Scratch, steps: usize) -> Result<(), String> {
    let damping = Damping {
        local: 0.7,
        ..Damping::default()
    };
    for _ in 0..steps {
        evaluate(world, scratch, &damping, DT).map_err(|e| e.to_string())?;
        advance(world, scratch, DT);
    }
    evaluate(world, scratch, &damping, DT).map_err(|e| e.to_string())
}

/// Memory in use by this process, kB; 0 where the system does not tell.
fn resident_kb() -> f64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find(|l| l.starts_with("VmRSS:"));
    line.and_then(|l| l.split_whitespace().nth(1)?.parse().ok())
        .unwrap_or(0.0)
}

fn measure(blocks: usize, threads: usize) -> Result<String, String> {
    let before = resident_kb();
    let exec = Exec::new(threads).map_err(|e| e.to_string())?;
    let (mut world, mut scratch) = World::new(wall(blocks), exec);
    run(&mut world, &mut scratch, SETTLE)?;
    let memory = resident_kb() - before;
    let count = world.bodies.len();
    let contacts = View {
        world: &world,
        scratch: &scratch,
    }
    .contacts()
    .count();
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
    let split: Vec<String> = spent
        .iter()
        .map(|(name, s)| format!("{name} {:.0} %", 100.0 * s / all))
        .collect();
    Ok(format!(
        "wall,{count},{contacts},{threads},{steps},{:.4},{:.4},{:.4},{:.3},{:.1},{:.2},{},{}",
        1e3 * median,
        1e3 * times[0],
        1e3 * times[REPEATS - 1],
        1e-6 * contacts as f64 / median,
        1e9 * median / count as f64,
        memory / count as f64,
        split.join(" | "),
        &hash::planar(&world)[..16],
    ))
}

fn main() -> Result<(), String> {
    let sizes: Vec<usize> = std::env::args()
        .skip(1)
        .filter_map(|a| a.parse().ok())
        .collect();
    let sizes = if sizes.is_empty() {
        vec![1_000, 10_000, 100_000]
    } else {
        sizes
    };
    let machine = Machine::this();
    println!(
        "# {} ({} cores), {} {}",
        machine.cpu, machine.cores, machine.os, machine.arch
    );
    println!(
        "scene,blocks,contacts,threads,steps,median_ms_per_step,min_ms,max_ms,\
         million_contacts_per_s,ns_per_block_step,kb_per_block,stages,state_hash"
    );
    for &blocks in &sizes {
        for threads in [1, 2] {
            println!("{}", measure(blocks, threads)?);
        }
    }
    Ok(())
}
