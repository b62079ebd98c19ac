//! Spherical waves in a narrow pyramid of layers between rollers.
//!
//! With nu = 0 the layers are exact: a layer that moves out by u stretches the springs behind its slanted sides by
//! u sin(angle), whose stress is E u/r, the hoop stress; their resultant along the axis is that of the continuum. So
//! the answers of the spherical cavity can be met with a few hundred blocks. Entries D6, F2 and F5 of the catalogue.

use riprap::Vec3;
use riprap::dynamics::TimeFunction;
use riprap::spatial::charge;
use riprap::spatial::setup::{
    BlockSpec, Boundary, BoundaryKind, CavityPressure, Coupling, FaceSet, JointLaw, Place, Setup,
    Shape, Solid, Source,
};
use riprap::spatial::stable::stable_step;
use riprap::spatial::step::advance;

use crate::spatial::blast::AMMONIUM;
use crate::spatial::rock::{DENSITY, Run, brick, elastic, rock};

/// Half the angle of the pyramid, rad.
const ANGLE: f64 = 0.1;

/// The layer between two distances from the apex, along z.
fn layer(from: f64, to: f64) -> BlockSpec {
    let at = |r: f64, x: f64, y: f64| r * Vec3::new(x * ANGLE.tan(), y * ANGLE.tan(), 1.0);
    let square =
        |r: f64| [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| at(r, x, y));
    let sides = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    let ends = [[0, 3, 2, 1], [4, 5, 6, 7]];
    let mut block = brick(Vec3::ZERO, Vec3::ONE);
    block.shape = Shape::Polyhedron(Box::new(Solid {
        vertices: [square(from), square(to)].concat(),
        faces: ends.iter().chain(&sides).map(|f| f.to_vec()).collect(),
    }));
    block
}

fn side(normal: Vec3, offset: f64, kind: BoundaryKind) -> Boundary {
    Boundary { name: "side".into(), on: FaceSet::Plane { normal, offset }, kind, in_situ: false }
}

/// Layers between the given distances, rollers on their sides; Young's modulus (Pa), Poisson's ratio nil.
fn sector(radii: &[f64], young: f64) -> Setup {
    let blocks = radii.windows(2).map(|r| layer(r[0], r[1])).collect();
    let law = JointLaw { damping: 0.01, contact_damping: 0.01, ..elastic() };
    let mut setup = rock(blocks, law);
    for (b, block) in setup.blocks.iter_mut().enumerate() {
        block.name.number = b as u32 + 1;
    }
    setup.materials[0].young = Some(young);
    setup.materials[0].poisson = Some(0.0);
    let roller = BoundaryKind::Held { normal: true, shear: false };
    let (sin, cos) = ANGLE.sin_cos();
    for out in [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y] {
        let normal = cos * out - sin * Vec3::Z;
        setup.boundaries.push(side(normal, 0.0, roller.clone()));
    }
    setup
}

/// Linear interpolation of `y` over ascending `x`.
fn between(x: &[f64], y: &[f64], at: f64) -> f64 {
    let k = x.partition_point(|v| *v < at).clamp(1, x.len() - 1);
    let share = (at - x[k - 1]) / (x[k] - x[k - 1]);
    y[k - 1] + share * (y[k] - y[k - 1])
}

/// Cavity of 0.5 m, E = 18 GPa, nu = 0, pressure 100 MPa (exp(-1500 t) - exp(-6000 t)): peak velocities 1.42391, 0.65344,
/// 0.31338, 0.15350 m/s at 1, 2, 4 and 8 m, and the arrival of half the peak at three places.
#[test]
fn the_wave_of_a_spherical_cavity() {
    let (inner, cell, count) = (0.5, 1.0 / 48.0, 432);
    let radii: Vec<f64> = (0..=count).map(|k| inner + cell * f64::from(k)).collect();
    let mut setup = sector(&radii, 18e9);
    let push = BoundaryKind::Traction {
        traction: Vec3::ZERO,
        pressure: 100e6,
        gradient: 0.0,
        datum: 0.0,
        time: TimeFunction::Duvall { amplitude: 1.0, decay: 1500.0, rise: 6000.0 },
    };
    setup.boundaries.push(side(-Vec3::Z, -inner, push));
    let mut run = Run::new(setup);
    let dt = 0.5 * stable_step(&run.world, &run.scratch, 0.0).dt;
    let n = run.world.alive.len();
    let mut speeds: Vec<Vec<f64>> = vec![Vec::new(); n];
    let mut times = Vec::new();
    while run.world.time < 3.4e-3 {
        run.steps(1, dt);
        // Velocities belong to half a step ago.
        times.push(run.world.time - 0.5 * dt);
        for (b, speed) in speeds.iter_mut().enumerate() {
            speed.push(run.world.bodies.velocity(b).z);
        }
    }
    let place: Vec<f64> = run.world.reference.iter().map(|x| x.z).collect();
    let peak = |v: &Vec<f64>| v.iter().copied().fold(0.0, f64::max);
    let peaks: Vec<f64> = speeds.iter().map(peak).collect();
    let expected = [1.42391, 0.65344, 0.31338, 0.15350];
    let found = [1.0, 2.0, 4.0, 8.0].map(|r| between(&place, &peaks, r));
    let octaves = |v: [f64; 4]| [0, 1, 2].map(|k: usize| (v[k] / v[k + 1]).log2());
    println!("peaks {found:.5?} m/s ({expected:.5?})");
    println!("exponents {:.4?} ({:.4?})", octaves(found), octaves(expected));
    for (a, b) in found.iter().zip(expected) {
        assert!((a / b - 1.0).abs() < 0.05, "{a} {b}");
    }
    for (a, b) in octaves(found).iter().zip(octaves(expected)) {
        assert!((a - b).abs() < 0.08, "{a} {b}");
    }
    let arrivals: Vec<f64> = speeds
        .iter()
        .zip(&peaks)
        .map(|(v, top)| {
            let k = v.iter().position(|v| *v > 0.5 * top).unwrap_or(0).max(1);
            between(&[v[k - 1], v[k]], &[times[k - 1], times[k]], 0.5 * top)
        })
        .collect();
    for (r, expected) in [(0.9796, 0.200829e-3), (1.9592, 0.556332e-3), (3.9588, 1.28546e-3)] {
        let found = between(&place, &arrivals, r);
        println!("arrival at {r} m: {:.6} ms ({:.6})", 1e3 * found, 1e3 * expected);
        assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
    }
}

/// Gas of 0.03 kg in a spherical hole of its own volume, no failure: the plateau solves V/V0 = 1 + 3 P/(4 G) with the
/// linear volume, 1.348 GPa for G = 7.2 GPa. The wall starts with P0/(rho c_P).
#[test]
fn gas_in_a_spherical_cavity_comes_to_its_plateau() {
    let volume = 0.03 / AMMONIUM.density;
    let inner = libm::cbrt(3.0 * volume / (4.0 * std::f64::consts::PI));
    let radii: Vec<f64> =
        std::iter::once(1e-3 * inner).chain((0..=80).map(|k| inner * 1.06f64.powi(k))).collect();
    let mut setup = sector(&radii, 14.4e9);
    let end = *radii.last().expect("layers");
    setup.boundaries.push(side(Vec3::Z, end, BoundaryKind::Viscous { half_cell: true }));
    // The share of the charge in the pyramid.
    let part = 4.0 * ANGLE.tan().powi(2) * inner.powi(3) / 3.0;
    setup.sources.push(Source {
        name: "charge".into(),
        place: Place::Blocks { blocks: vec![0] },
        delay: 0.0,
        hole: Default::default(),
        push: CavityPressure::Gas {
            explosive: AMMONIUM.into(),
            mass: AMMONIUM.density * part,
            coupling: Coupling::Coupled,
            venting: None,
        },
    });
    let mut run = Run::new(setup);
    assert!((run.world.cavities[0].volume_ratio() - 1.0).abs() < 1e-6);
    let stable = 0.5 * stable_step(&run.world, &run.scratch, 0.0).dt;
    let c_p = (14.4e9 / DENSITY).sqrt();
    let (mut first, mut top) = (0.0f64, 0.0f64);
    while run.world.time < 1e-3 {
        let dt = stable.min(charge::step_limit(&run.world));
        run.evaluate(dt);
        advance(&mut run.world, &mut run.scratch, dt);
        if run.world.time < 1e-6 {
            first = first.max(run.world.bodies.velocity(1).z);
        }
        top = top.max(run.world.bodies.displacement(1).z);
    }
    run.evaluate(stable);
    let found = run.world.cavities[0].pressure;
    let balance = run.balance();
    let defect = balance.residual() / run.world.cavities[0].work;
    println!(
        "plateau {:.4} GPa (1.348), first speed {first:.1} m/s (below {:.1}), largest u {:.3e} m, residual {defect:.1e}",
        1e-9 * found,
        2e9 / (DENSITY * c_p),
        top
    );
    assert!((found / 1.348e9 - 1.0).abs() < 0.02, "{found:e}");
    assert!(defect.abs() < 1e-2, "{defect:e}");
}
