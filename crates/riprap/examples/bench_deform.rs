//! Times the deformable blocks of the spatial engine and prints CSV: `bench_deform [CELLS]`, or `bench_deform cut [congruent|Voronoi]
//! [CELLS]` for cutting alone, `bench_deform save [CELLS]` for checkpoints alone.
//!
//! Run by `cargo xtask bench`. A beam of CELLS (default 46 x 9 x 10) cubes of 24 tetrahedra, joined by bonds, rings: with one
//! matrix for congruent blocks, tetrahedron by tetrahedron, and with large strain. Then the kernels alone, and the cut of
//! every block of a model beside the time that it took to build, and checkpoints of 100,000 blocks. Rates are the best of several repeats.

#![allow(clippy::disallowed_methods, reason = "no result of a model: inputs of a timing")]

use std::time::Instant;

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::geom::polyhedron::cut::{Limits, Planes, cut};
use riprap::geom::polyhedron::{Polyhedron, Tetrahedra};
use riprap::lanes::Width;
use riprap::laws::fracture::{Criterion, Margins};
use riprap::laws::tetrahedron::{Elastic, Groups, StartStress, Stiffness, Strain, forces};
use riprap::record::checkpoint::Packing;
use riprap::record::folder::Existing;
use riprap::record::manifest::Machine;
use riprap::record::{Manifest, RunFolder};
use riprap::run::scene::Scene;
use riprap::run::simulation::Simulation;
use riprap::scenario::Source;
use riprap::spatial::deform::phase::{self, Rules};
use riprap::spatial::setup::deform::{
    BondFailure, BondLaw, BondSprings, DeformableSet, Deformables, Strength,
};
use riprap::spatial::setup::{
    BlockName, BlockSpec, InterfaceLaw, JointLaw, Kinematics, Material, Points, Setup, Shape,
    Solid, Stiffness as Springs, StiffnessRule,
};
use riprap::spatial::step::{Damping, Scratch, advance, evaluate};
use riprap::spatial::topology::cut as cutting;
use riprap::spatial::world::World;

const REPEATS: usize = 5;
const STEPS: usize = 40;
const EDGE: f64 = 0.03;
/// Steps of the beam of the acceptance numbers.
const LONG: f64 = 10_000.0;

fn main() {
    let machine = Machine::this();
    println!("# {} {} {} cores", machine.os, machine.cpu, machine.cores);
    println!("case,threads,value,unit,asked");
    if std::env::args().nth(1).as_deref() == Some("cut") {
        let words: Vec<String> = std::env::args().skip(2).collect();
        let cells = words.iter().filter_map(|w| w.parse().ok()).collect();
        let only = words.iter().find(|w| w.parse::<usize>().is_err());
        return cut_both(cells, only.map(String::as_str));
    }
    let save = std::env::args().nth(1).as_deref() == Some("save");
    let words: Vec<usize> = std::env::args().skip(1).filter_map(|w| w.parse().ok()).collect();
    if save {
        return save_all(words);
    }
    let cells = match words[..] {
        [x, y, z] => [x, y, z],
        _ => [46, 9, 10],
    };
    kernels();
    for (name, own, strain, asked) in [
        ("beam, congruent blocks", false, Strain::Small, "<= 25"),
        ("beam, tetrahedron by tetrahedron", true, Strain::Small, "<= 40"),
        ("beam, total Lagrangian", true, Strain::Large, ""),
    ] {
        let mut rates = [0.0; 2];
        let mut hashes = [0; 2];
        for threads in [1, 2] {
            let (seconds, hash, springs) = beam(cells, own, strain, threads);
            rates[threads - 1] = seconds;
            hashes[threads - 1] = hash;
            println!("\"{name}\",{threads},{:.4e},s for 10000 steps,{asked}", LONG * seconds);
            if let Some(rate) = springs {
                println!("\"{name}: bonds\",{threads},{rate:.3e},springs/s,>= 8e7");
            }
        }
        println!("\"{name}: speed-up\",2,{:.2},-,>= 1.6", rates[0] / rates[1]);
        assert_eq!(hashes[0], hashes[1], "the bits depend on the number of threads");
    }
    cut_both(Vec::new(), None);
    save_all(Vec::new());
}

/// What is timed: number of a block, displacements and forces of its nodes.
type Work<'a> = &'a dyn Fn(usize, &[[f64; 3]], &mut [[f64; 3]]);

/// Tetrahedra per second of the kernels, and blocks cut by the geometry alone.
fn kernels() {
    let cube = Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5 * EDGE));
    let mesh = Tetrahedra::new(&cube).expect("a cube");
    let law = Elastic::new(30e9, 0.25);
    let blocks = 10_000;
    let own: Vec<Groups> = (0..blocks).map(|_| Groups::new(&mesh)).collect();
    let matrix = Stiffness::new(&mesh, &law);
    let count = mesh.nodes.len();
    let mut draw = draws();
    let u: Vec<[f64; 3]> =
        (0..blocks * count).map(|_| [0, 1, 2].map(|_| 1e-4 * EDGE * draw())).collect();
    let mut f = vec![[0.0; 3]; u.len()];
    let none = StartStress::none();
    let width = Width::detect();
    let mut time = |what: &str, asked: &str, work: Work<'_>| {
        let mut best = f64::INFINITY;
        for _ in 0..REPEATS {
            let start = Instant::now();
            for (k, (u, f)) in u.chunks(count).zip(f.chunks_mut(count)).enumerate() {
                work(k, u, f);
            }
            best = best.min(start.elapsed().as_secs_f64());
        }
        let rate = (blocks * mesh.tets.len()) as f64 / best;
        println!("\"{what}\",1,{rate:.3e},tetrahedra/s,{asked}");
    };
    time("kernel, small strain, own shapes", ">= 6e7", &|k, u, f| {
        forces(width, &own[k], &law, Strain::Small, &none, u, f);
    });
    time("kernel, total Lagrangian, own shapes", ">= 4e7", &|k, u, f| {
        forces(width, &own[k], &law, Strain::Large, &none, u, f);
    });
    time("kernel, shared matrix", ">= 1.2e8", &|_, u, f| {
        matrix.forces(width, u, f);
    });
    let mut best = f64::INFINITY;
    for _ in 0..20 {
        let normals: Vec<Vec3> =
            (0..500).map(|_| Vec3::new(draw(), draw(), draw()).normalize()).collect();
        let start = Instant::now();
        let parts: usize = normals
            .iter()
            .filter_map(|n| cut(&cube, *n, Planes::Spaced { count: 3 }, &Limits::default()).ok())
            .map(|made| made.parts.len())
            .sum();
        assert!(parts >= 1500);
        best = best.min(start.elapsed().as_secs_f64() / 500.0);
    }
    println!(
        "\"planes through a cube, 4 parts\",1,{:.2},us/block,<= 60 with interfaces",
        1e6 * best
    );
}

/// Numbers between -1 and 1.
fn draws() -> impl FnMut() -> f64 {
    let mut seed = 1u64;
    move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Cubes in a box, joined by bonds with a strength; `own` gives each a shape of its own in memory.
fn model(cells: [usize; 3], own: bool, strain: Strain) -> Setup {
    let mut blocks = Vec::new();
    for k in 0..cells.iter().product::<usize>() {
        let [nx, ny, _] = cells;
        let at = [k % nx, k / nx % ny, k / (nx * ny)].map(|n| n as f64 + 0.5);
        let (centre, half) = (EDGE * Vec3::from_array(at), Vec3::splat(0.5 * EDGE));
        let shape = if own {
            let solid = Polyhedron::brick(centre, half);
            Shape::Polyhedron(Box::new(Solid { vertices: solid.vertices, faces: solid.faces }))
        } else {
            Shape::Brick { centre, half }
        };
        blocks.push(BlockSpec {
            name: BlockName { base: 0, number: k as u32 + 1 },
            shape,
            material: 0,
            velocity: Vec3::ZERO,
            spin: Vec3::ZERO,
        });
    }
    let all = (0..blocks.len() as u32).collect();
    Setup {
        materials: vec![Material {
            name: "rock".into(),
            density: 2500.0,
            young: Some(30e9),
            poisson: Some(0.25),
        }],
        names: vec!["rock".into()],
        blocks,
        interfaces: vec![InterfaceLaw {
            name: "default".into(),
            bond: Some(BondLaw {
                springs: BondSprings::Thickness { thickness: 0.01 * EDGE, moduli: None },
                strength: Some(Strength {
                    tension: 5e6,
                    cohesion: 8e6,
                    friction: 0.5,
                    residual_friction: 0.5,
                    ..Strength::default()
                }),
                cohesive: None,
                failure: BondFailure::Spring,
            }),
            friction: None,
            joint: JointLaw {
                stiffness: Springs::Rule(StiffnessRule::Material),
                points: Points::Quarter,
                ..JointLaw::default()
            },
        }],
        pair_table: vec![0],
        kinematics: Kinematics::Small,
        deform: Deformables {
            sets: vec![DeformableSet {
                blocks: all,
                strain,
                displacement: [None, None, None],
                velocity: [None, None, None],
            }],
            ..Deformables::default()
        },
        ..Setup::default()
    }
}

/// Enters a dynamic phase and gives nodes a displacement.
fn begin(world: &mut World, scratch: &mut Scratch, breaking: bool, field: impl Fn(Vec3) -> Vec3) {
    let rules = Rules { relax: None, breaking, strain: None };
    phase::enter(world, Some(&rules));
    if let Some(deform) = world.deform.as_deref_mut() {
        for (u, place) in deform.nodes.displacement.iter_mut().zip(&deform.nodes.place) {
            *u = field(*place).to_array();
        }
    }
    scratch.invalidate(world);
}

/// Seconds per step of a ringing beam, a hash of where it ends, and springs per second of its bonds.
fn beam(cells: [usize; 3], own: bool, strain: Strain, threads: usize) -> (f64, u64, Option<f64>) {
    let exec = Exec::new(threads).expect("threads");
    let (mut world, mut scratch) = World::new(model(cells, own, strain), exec).expect("a beam");
    let length = EDGE * cells[0] as f64;
    let bend = |at: Vec3| 1e-6 * (std::f64::consts::PI * at.x / length).cos() * Vec3::X;
    begin(&mut world, &mut scratch, true, bend);
    let damping = Damping::default();
    let mut best = f64::INFINITY;
    let mut bonds = f64::INFINITY;
    let clock = |scratch: &Scratch| {
        let stages = scratch.profile.seconds();
        let stage = stages.iter().find(|(name, _)| name == "bonds");
        stage.map_or(0.0, |(_, seconds)| *seconds)
    };
    for _ in 0..REPEATS {
        let (start, before) = (Instant::now(), clock(&scratch));
        for _ in 0..STEPS {
            evaluate(&mut world, &mut scratch, &damping, 2e-7).expect("finite");
            advance(&mut world, &mut scratch, 2e-7);
        }
        best = best.min(start.elapsed().as_secs_f64() / STEPS as f64);
        bonds = bonds.min((clock(&scratch) - before) / STEPS as f64);
    }
    let deform = world.deform.as_deref().expect("deformable blocks");
    let nodes = deform.nodes.displacement.iter().flatten();
    let hash = nodes.fold(0u64, |h, x| h.rotate_left(5) ^ x.to_bits());
    let rate = (bonds > 0.0).then(|| deform.points.len() as f64 / bonds);
    (best, hash, rate)
}

/// Congruent blocks and cells of own shapes, or `only` the ones so called; `cells` (default 20 x 20 x 25) along the axes.
fn cut_both(cells: Vec<usize>, only: Option<&str>) {
    let cells: [usize; 3] = cells.try_into().unwrap_or([20, 20, 25]);
    let all = [("congruent", "box"), ("Voronoi", "cells")];
    for (name, grid) in all.into_iter().filter(|a| only.is_none_or(|o| o == a.0)) {
        for threads in [1, 2] {
            cut_all(name, grid, cells, threads);
        }
    }
}

/// A box of blocks as a scene.
fn scene(grid: &str, cells: [usize; 3]) -> Scene {
    let size = cells.map(|n| format!("\"{} mm\"", 30 * n)).join(", ");
    let text = format!(
        r#"
riprap = 1
title = "blocks to be cut"

[space.spatial]
gravity = "0 m/s2"

[materials.rock]
density = "2500 kg/m3"
young = "30 GPa"
poisson = 0.25

[interfaces.default.brittle_bond]
thickness = "0.3 mm"
tension = "5 MPa"
cohesion = "8 MPa"
friction_angle = "26.565051177 deg"

[[blocks]]
name = "rock"
material = "rock"
grid.{grid} = {{ size = [{size}], cell = "30 mm" }}
mechanics.deformable = {{}}

[[phases]]
name = "run"
until = {{ time = "1 ms" }}
"#
    );
    let source = Source { name: "bench".into(), text };
    Scene::parse(source, ".".into(), &[]).expect("a sound scene")
}

/// Builds a model, strains it beyond its strength, and cuts every block once.
fn cut_all(name: &str, grid: &str, cells: [usize; 3], threads: usize) {
    let exec = || Exec::new(threads).expect("threads");
    let parsed = scene(grid, cells);
    let start = Instant::now();
    let model = parsed.prepare(&parsed.plain()).expect("a model").model;
    let setup = model.setup.clone();
    let simulation = Simulation::new(model.setup, model.plan, exec()).expect("a simulation");
    let library = start.elapsed().as_secs_f64();
    drop(simulation);
    let riprap::model::Setup::Spatial(setup) = setup else { panic!("the scene is in space") };
    let start = Instant::now();
    let (mut world, mut scratch) = World::new(*setup, exec()).expect("a model");
    let engine = start.elapsed().as_secs_f64();
    let blocks = world.alive.len();
    let strain = Vec3::new(3e-4, 1e-5, 0.0);
    begin(&mut world, &mut scratch, false, |at| Vec3::new(strain.x * at.x, strain.y * at.x, 0.0));
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-9).expect("finite");
    let rules = cutting::Rules {
        planes: 3,
        criterion: Criterion::Larger,
        margins: Margins { tension: 0.0, shear: 0.0 },
        generations: 1,
        smallest: 0.0,
        anchor: cutting::Anchor::Spacing,
        only_cut: false,
        along: None,
        snap: 0.03,
        stages: 1,
        step_floor: 0.0,
    };
    cutting::allow(&mut world, Some(&rules));
    world.step = 10;
    let start = Instant::now();
    let count = cutting::step(&mut world, &mut scratch, 1e-9).expect("a sound cut");
    let seconds = start.elapsed().as_secs_f64();
    let start = Instant::now();
    evaluate(&mut world, &mut scratch, &Damping::default(), 1e-9).expect("finite");
    let once = start.elapsed().as_secs_f64();
    let row = |what: &str, value: f64, unit: &str, asked: &str| {
        println!("\"{name}: {what}\",{threads},{value:.4},{unit},{asked}");
    };
    row(&format!("building {blocks} blocks from the parsed scene"), library, "s", "");
    row(&format!("building {blocks} blocks in the engine"), engine, "s", "");
    row(&format!("cutting {count} of them"), seconds, "s", "<= building");
    row("one cut with its interfaces", 1e6 * seconds / count as f64, "us", "<= 60");
    row("forces of all parts once", 1e6 * once / count as f64, "us/cut", "");
}

/// Saves a model of `cells` (default 50 x 50 x 40) that moves: the larger part of what someone waits for after Ctrl-C, and what the
/// checkpoints by the clock take. Nothing but the state is in them.
fn save_all(cells: Vec<usize>) {
    let cells: [usize; 3] = cells.try_into().unwrap_or([50, 50, 40]);
    let parsed = scene("box", cells);
    let setup = parsed.prepare(&parsed.plain()).expect("a model").model.setup;
    let riprap::model::Setup::Spatial(setup) = setup else { panic!("the scene is in space") };
    let exec = Exec::new(1).expect("a thread");
    let (mut world, mut scratch) = World::new(*setup, exec).expect("a model");
    begin(&mut world, &mut scratch, false, |at| {
        Vec3::new(at.y * at.z, at.z * at.x, at.x * at.y) * 1e-6
    });
    for _ in 0..3 {
        evaluate(&mut world, &mut scratch, &Damping::default(), 1e-7).expect("finite");
        advance(&mut world, &mut scratch, 1e-7);
    }
    let blocks = world.alive.len();
    // Not in memory, where many systems have their temporary files.
    let place = tempfile::tempdir_in("target").expect("a folder in target");
    let folder = RunFolder::create(place.path(), Existing::Refuse, &Manifest::default())
        .expect("a run folder");
    for (what, packing, asked) in [
        ("the last checkpoint", Packing::Quick, "<= 1"),
        ("a checkpoint by the clock", Packing::Small, ""),
    ] {
        let mut best = f64::INFINITY;
        let mut bytes = 0;
        for _ in 0..REPEATS {
            let start = Instant::now();
            let file = folder.checkpoint_as("bench", 0, &world, packing).expect("a checkpoint");
            best = best.min(start.elapsed().as_secs_f64());
            bytes = file.metadata().expect("its length").len();
        }
        let megabytes = bytes as f64 / 1e6;
        println!("\"{what} of {blocks} blocks\",1,{best:.3},s,{asked}");
        println!("\"{what} of {blocks} blocks\",1,{megabytes:.1},MB,");
    }
}
