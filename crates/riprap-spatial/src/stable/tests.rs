//! The step against a power iteration of thousands of sweeps.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::voronoi;

use crate::exec::Exec;
use crate::lanes::Width;
use crate::laws::bolt::Design;
use crate::laws::parameters::{JointLaw, Stiffness};
use crate::setup::{
    BlockName, BlockSpec, Bolt, Boundary, BoundaryKind, FaceSet, InterfaceLaw, Material, Setup,
    Shape, Solid, StiffnessRule,
};
use crate::stable::springs::{PIECE, Part, Springs, Step, Weights, add, of, parts};
use crate::stable::stable_step;
use crate::state::scratch::Scratch;
use crate::state::tiles::GROUP;
use crate::state::world::World;

/// Square of what a motion of all blocks grows by in a step: stable up to 4.
fn limit(world: &World, weights: Weights, sweeps: usize) -> f64 {
    let springs = Springs::new(world);
    let mut bolts = crate::push::bolts::stiffness::BoltSprings::new(world);
    let mut seed = 11_u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut x = parts(world.alive.len());
    for (x, root) in flat(&mut x).zip(springs.root.as_flattened().as_flattened()) {
        let drawn = draw();
        *x = if *root > 0.0 { drawn } else { 0.0 };
    }
    let mut value = 0.0;
    for _ in 0..sweeps {
        let scale = 1.0 / dot(&x, &x).sqrt();
        flat(&mut x).for_each(|x| *x *= scale);
        let mut at = x.clone();
        let roots = springs.root.as_flattened().as_flattened();
        flat(&mut at).zip(roots).for_each(|(at, root)| *at *= root);
        let mut bolted = Vec::new();
        if !world.bolts.is_empty() {
            let moved: Vec<[Vec3; 2]> = (0..world.alive.len() as u32).map(|b| of(&at, b)).collect();
            let mut sum = vec![[Vec3::ZERO; 2]; moved.len()];
            bolts.pull(&moved, &mut sum);
            bolted = parts(sum.len());
            for (b, v) in sum.into_iter().enumerate() {
                add(&mut bolted, b as u32, v);
            }
        }
        let step = Step {
            world,
            springs: &springs,
            weights,
            at: &at,
            bolted: &bolted,
            width: Width::detect(),
        };
        let mut y = parts(world.alive.len());
        let mut products = vec![0.0; y.len()];
        let pieces = y.chunks_mut(PIECE / GROUP).zip(products.chunks_mut(PIECE / GROUP));
        for (number, (y, products)) in pieces.enumerate() {
            step.piece(number, y, products);
        }
        value = dot(&x, &y);
        assert!((products.iter().sum::<f64>() / value - 1.0).abs() < 1e-9);
        x = y;
    }
    value
}

fn flat(parts: &mut [Part]) -> impl Iterator<Item = &mut f64> {
    parts.as_flattened_mut().as_flattened_mut().iter_mut()
}

fn dot(a: &[Part], b: &[Part]) -> f64 {
    let [a, b] = [a, b].map(|parts| parts.as_flattened().as_flattened());
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn joint(stiffness: Stiffness, damping: f64) -> JointLaw {
    JointLaw { stiffness, damping, contact_damping: damping, ..JointLaw::default() }
}

fn rock(shapes: Vec<Shape>, damping: f64) -> Setup {
    let spec = |(k, shape)| BlockSpec {
        name: BlockName { base: 0, number: k as u32 + 1 },
        shape,
        material: 0,
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    };
    Setup {
        materials: vec![Material {
            name: "rock".to_owned(),
            density: 2400.0,
            young: Some(18e9),
            poisson: Some(0.25),
        }],
        names: vec!["rock".to_owned()],
        blocks: shapes.into_iter().enumerate().map(spec).collect(),
        interfaces: vec![InterfaceLaw {
            name: "default".to_owned(),
            joint: joint(Stiffness::Rule(StiffnessRule::Material), damping),
            friction: None,
            bond: None,
        }],
        pair_table: vec![0],
        ..Setup::default()
    }
}

/// Bricks between planes normal to the axes.
fn bricks(planes: [&[f64]; 3]) -> Vec<Shape> {
    let mut shapes = Vec::new();
    for z in planes[2].windows(2) {
        for y in planes[1].windows(2) {
            for x in planes[0].windows(2) {
                let [low, high] = [0, 1].map(|k| Vec3::new(x[k], y[k], z[k]));
                shapes.push(Shape::Brick { centre: 0.5 * (low + high), half: 0.5 * (high - low) });
            }
        }
    }
    shapes
}

fn lattice(n: usize) -> Vec<Shape> {
    let planes: Vec<f64> = (0..=n).map(|k| k as f64).collect();
    bricks([&planes; 3])
}

/// A side of the model.
fn on(normal: Vec3, offset: f64, kind: BoundaryKind) -> Boundary {
    Boundary {
        name: "side".to_owned(),
        on: FaceSet::Plane { normal, offset },
        kind,
        in_situ: false,
    }
}

/// A wall of bricks with one of a five-hundredth of the mass of the others.
fn wall(damping: f64) -> Setup {
    let mut x: Vec<f64> = (0..=30).map(f64::from).collect();
    let mut z = x.clone();
    x.push(30.02);
    z.push(30.1);
    rock(bricks([&x, &[0.0, 1.0], &z]), damping)
}

/// Edges of 1 to 12: no brick like another.
fn uneven(damping: f64) -> Setup {
    let planes = |first: f64| {
        let mut at = 0.0;
        let edges = (0..12).map(|k| {
            at += 1.0 + 11.0 * (0.618 * f64::from(k) + first).fract();
            at
        });
        std::iter::once(0.0).chain(edges).collect::<Vec<f64>>()
    };
    rock(bricks([&planes(0.1), &planes(0.4), &planes(0.8)]), damping)
}

/// Cells of random sites.
fn cells(damping: f64) -> Setup {
    let cells = voronoi(Vec3::ZERO, Vec3::splat(8.0), 1.0, 5, 0).unwrap();
    let solid = |cell: riprap_geom::polyhedron::Polyhedron| {
        Shape::Polyhedron(Box::new(Solid { vertices: cell.vertices, faces: cell.faces }))
    };
    rock(cells.into_iter().map(solid).collect(), damping)
}

fn bolted() -> Setup {
    let mut setup = rock(lattice(6), 0.1);
    setup.bolts.push(Bolt {
        name: "bolt".to_owned(),
        head: Vec3::new(3.3, 3.4, 6.0),
        toe: Vec3::new(3.3, 3.4, 0.5),
        design: Design {
            axial: 5e12,
            yields: 250e3,
            hardening: 0.0,
            breaks: f64::INFINITY,
            grout: 1e13,
            bond: 200e3,
            grouted: f64::INFINITY,
            plate: None,
            pretension: 0.0,
            dowel: None,
            piece: 0.05,
        },
    });
    setup
}

fn build(setup: Setup, threads: usize) -> (World, Scratch) {
    let exec = Exec::new(threads).unwrap();
    let (mut world, mut scratch) = World::new(setup, exec).unwrap();
    let bolts: Vec<u32> = (0..world.setup.bolts.len() as u32).collect();
    if !bolts.is_empty() {
        crate::push::bolts::install::install(&mut world, &bolts).unwrap();
        scratch.invalidate(&mut world);
    }
    (world, scratch)
}

/// Models, with the sweeps that a power iteration takes to 0.1 %, and stiffness-proportional damping (s).
fn models() -> Vec<(&'static str, Setup, usize, f64)> {
    let held = BoundaryKind::Held { normal: true, shear: true };
    let viscous = |half_cell| BoundaryKind::Viscous { half_cell };
    let with = |mut setup: Setup, sides: Vec<Boundary>| {
        setup.boundaries = sides;
        setup
    };
    let dashed = with(
        rock(lattice(12), 0.2),
        vec![
            on(-Vec3::Z, 0.0, held.clone()),
            on(Vec3::X, 12.0, viscous(true)),
            on(-Vec3::X, 0.0, viscous(false)),
        ],
    );
    let fringe = [0.0, 1.0, 2.0, 3.0, 4.0, 4.05];
    let thin = with(
        rock(bricks([&fringe, &fringe, &fringe]), 0.05),
        vec![on(Vec3::X, 4.05, viscous(false)), on(-Vec3::Z, 0.0, held.clone())],
    );
    vec![
        ("lattice", rock(lattice(16), 0.0), 500, 0.0),
        ("lattice with dashpots", rock(lattice(12), 0.3), 500, 0.0),
        ("damped lattice", rock(lattice(12), 0.0), 500, 1e-4),
        ("held lattice", with(rock(lattice(12), 0.0), vec![on(-Vec3::Z, 0.0, held)]), 500, 0.0),
        ("viscous sides", dashed, 500, 0.0),
        ("thin viscous fringe", thin, 1000, 0.0),
        ("wall with a splinter", wall(0.0), 600, 0.0),
        ("wall with a splinter and dashpots", wall(0.2), 600, 0.0),
        ("uneven bricks", uneven(0.0), 1000, 0.0),
        ("uneven bricks with dashpots", uneven(0.3), 1000, 0.0),
        ("cells", cells(0.0), 1000, 0.0),
        ("cells with dashpots", cells(0.3), 1000, 1e-5),
        ("bolted", bolted(), 600, 0.0),
    ]
}

#[test]
fn the_step_is_that_of_a_long_power_iteration() {
    for (name, setup, sweeps, ck) in models() {
        let (world, scratch) = build(setup, 1);
        let stable = stable_step(&world, &scratch, ck);
        let value = limit(&world, Weights::step(stable.dt, ck), sweeps);
        println!("{name}: {:.5} of the limit, {}", 0.25 * value, stable.why);
        assert!(value < 4.0 * 1.005, "{name}: too long, {value}");
        assert!(value > 4.0 * 0.99, "{name}: too short, {value}");
        assert!(!world.deforms(stable.block.unwrap() as usize));
    }
}

#[test]
fn the_step_has_the_same_bits_on_any_threads() {
    for setup in [rock(lattice(18), 0.2), bolted()] {
        let [one, more] = [1, 3].map(|threads| {
            let (world, scratch) = build(setup.clone(), threads);
            stable_step(&world, &scratch, 0.0)
        });
        assert_eq!(one.dt.to_bits(), more.dt.to_bits());
        assert_eq!(one.block, more.block);
    }
}
