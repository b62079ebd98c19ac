//! Deformable blocks against closed answers.

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::spatial::deform::phase::{self, Rules};
use riprap::spatial::deform::relax::Relaxation;
use riprap::spatial::setup::deform::{
    BondFailure, BondLaw, BondSprings, DeformableSet, Deformables, Notch, Strain, Strength,
};
use riprap::spatial::setup::{Boundary, BoundaryKind, FaceSet, Setup};
use riprap::spatial::stable::stable_step;
use riprap::spatial::topology::fracture;

use crate::spatial::rock::{Run, brick, elastic, lattice, rock};

/// Young's modulus of `rock`, Pa.
const YOUNG: f64 = 18e9;

pub fn bonds(thickness: f64) -> BondLaw {
    BondLaw {
        springs: BondSprings::Thickness { thickness, moduli: None },
        strength: None,
        cohesive: None,
        failure: BondFailure::Spring,
    }
}

/// Makes all blocks of a model deformable.
pub fn deformable(setup: Setup, strain: Strain, thickness: f64) -> Setup {
    let blocks = (0..setup.blocks.len() as u32).collect();
    let mut interfaces = setup.interfaces;
    for law in &mut interfaces {
        law.bond = Some(bonds(thickness));
    }
    Setup {
        interfaces,
        deform: Deformables {
            sets: vec![DeformableSet {
                blocks,
                strain,
                displacement: [None, None, None],
                velocity: [None, None, None],
            }],
            ..Deformables::default()
        },
        ..setup
    }
}

/// A condition on the faces of a plane.
pub fn on_plane(normal: Vec3, offset: f64, kind: BoundaryKind) -> Boundary {
    Boundary {
        name: format!("{normal}"),
        on: FaceSet::Plane { normal, offset },
        kind,
        in_situ: false,
    }
}

pub fn roller() -> BoundaryKind {
    BoundaryKind::Held { normal: true, shear: false }
}

pub fn pull(traction: Vec3) -> BoundaryKind {
    BoundaryKind::Traction {
        traction,
        pressure: 0.0,
        gradient: 0.0,
        datum: 0.0,
        time: riprap::dynamics::TimeFunction::Constant(1.0),
    }
}

/// Begins a phase.
pub fn begin(run: &mut Run, rules: &Rules) {
    phase::enter(&mut run.world, Some(rules));
    run.scratch.invalidate(&mut run.world);
}

/// Relaxes until converged; returns the number of iterations.
pub fn relax(run: &mut Run, tolerance: f64) -> u64 {
    let rules = Rules { relax: Some(tolerance), breaking: false, strain: None };
    begin(run, &rules);
    let start = run.world.step;
    for _ in 0..100_000 {
        run.steps(1, 1.0);
        let relax = run.world.deform.as_ref().and_then(|d| d.relax.as_ref());
        if relax.is_some_and(|r| r.converged) {
            run.evaluate(1.0);
            return run.world.step - start;
        }
    }
    panic!("did not converge");
}

/// A bar of `n` cubes along x, held by rollers on three sides, pulled at its end.
fn bar(n: usize, edge: f64, thickness: f64, stress: f64) -> Run {
    let half = 0.5 * edge;
    let blocks = (0..n)
        .map(|k| brick(Vec3::new(edge * k as f64 + half, half, half), Vec3::splat(half)))
        .collect();
    let setup = deformable(rock(blocks, elastic()), Strain::Small, thickness);
    let length = edge * n as f64;
    Run::new(Setup {
        boundaries: vec![
            on_plane(-Vec3::X, 0.0, roller()),
            on_plane(-Vec3::Y, 0.0, roller()),
            on_plane(-Vec3::Z, 0.0, roller()),
            on_plane(Vec3::X, length, pull(Vec3::new(stress, 0.0, 0.0))),
        ],
        ..setup
    })
}

#[test]
fn a_bar_stretches_by_its_blocks_and_bonds() {
    for (n, ratio) in [(5, 0.1), (5, 0.01), (3, 0.001)] {
        let (edge, stress) = (0.03, 1e6);
        let mut run = bar(n, edge, ratio * edge, stress);
        relax(&mut run, 1e-11);
        let view = run.view();
        let end = view.on_boundary(3).0.x;
        let exact = stress / YOUNG * edge * n as f64 * (1.0 + (n - 1) as f64 / n as f64 * ratio);
        assert!((end / exact - 1.0).abs() < 1e-6, "{n} {ratio}: {}", end / exact);
        for b in 0..n {
            let s = view.deformable(b).expect("a deformable block").stress();
            let off = (s - riprap_geom::Mat3::from_diagonal(Vec3::new(stress, 0.0, 0.0)))
                .to_cols_array()
                .into_iter()
                .fold(0.0, |m: f64, x| m.max(x.abs()));
            assert!(off < 1e-8 * stress, "{off}");
        }
        // What the load has done is in the blocks and bonds, and what is lacking was damped.
        let balance = view.balance();
        assert!(balance.residual().abs() < 1e-9 * balance.works.loads, "{balance:?}");
    }
}

#[test]
fn the_bits_do_not_depend_on_threads() {
    let hash = |threads: usize| {
        let mut run = bar(300, 0.03, 3e-4, 1e6);
        run.scratch.exec = Exec::new(threads).expect("threads");
        begin(&mut run, &Rules { relax: Some(1e-6), breaking: false, strain: None });
        run.steps(60, 1.0);
        let nodes = &run.world.deform.as_ref().expect("nodes").nodes;
        let bits =
            |list: &[[f64; 3]]| list.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        (bits(&nodes.displacement), bits(&nodes.velocity))
    };
    assert_eq!(hash(1), hash(2));
}

/// A single cube that turns freely.
fn spinning(strain: Strain) -> Run {
    let half = 0.015;
    let mut spec = brick(Vec3::splat(half), Vec3::splat(half));
    spec.spin = Vec3::new(300.0, 200.0, 500.0);
    Run::new(deformable(rock(vec![spec], elastic()), strain, 3e-4))
}

#[test]
fn a_free_cube_turns_without_swelling() {
    let rules = Rules { relax: None, breaking: false, strain: None };
    let size = |run: &Run| {
        let deformable = run.view().deformable(0).expect("a deformable block");
        let first = deformable.body.first as usize;
        deformable.place(first).distance(deformable.place(first + 7))
    };
    let mut run = spinning(Strain::Large);
    begin(&mut run, &rules);
    let (start, turns) = (size(&run), 3.0);
    let spin = Vec3::new(300.0, 200.0, 500.0).length();
    let dt = 0.25 * stable_step(&run.world, &run.scratch, 0.0).dt;
    let steps = (turns * std::f64::consts::TAU / spin / dt) as usize;
    run.evaluate(dt);
    let (momentum, energy) = (run.view().angular_momentum(), run.view().balance().total());
    run.steps(steps, dt);
    run.evaluate(dt);
    let change = run.view().angular_momentum() - momentum;
    assert!(change.length() < 1e-12 * momentum.length(), "{change}");
    assert!((size(&run) / start - 1.0).abs() < 1e-3, "{}", size(&run) / start);
    let balance = run.view().balance();
    assert!((balance.total() / energy - 1.0).abs() < 1e-4, "{balance:?}");
    // Small strain: no force keeps the nodes on their circles.
    let mut run = spinning(Strain::Small);
    begin(&mut run, &rules);
    run.steps(steps, dt);
    run.evaluate(dt);
    assert!(size(&run) > 5.0 * start);
}

#[test]
fn momentum_stays_and_a_bar_rings_at_its_frequency() {
    // A free bar let go stretched: c/2L for the first mode of free ends.
    let (n, edge) = (10, 0.03);
    let half = 0.5 * edge;
    let blocks = (0..n)
        .map(|k| brick(Vec3::new(edge * f64::from(k) + half, half, half), Vec3::splat(half)))
        .collect();
    let mut setup = deformable(rock(blocks, elastic()), Strain::Small, 3e-4);
    let length = edge * f64::from(n);
    let shape = format!("1e-6*cos(pi*x/{length})");
    setup.deform.sets[0].displacement[0] =
        Some(riprap::dynamics::Formula::new(&shape, &["x", "y", "z"]).expect("a formula"));
    let mut run = Run::new(setup);
    let rules = Rules { relax: None, breaking: false, strain: None };
    begin(&mut run, &rules);
    let dt = 0.5 * stable_step(&run.world, &run.scratch, 0.0).dt;
    // Velocity of bars: sqrt(E/rho) with the compliance of the bonds.
    let speed = (YOUNG / 1.01 / crate::spatial::rock::DENSITY).sqrt();
    let period = 2.0 * length / speed;
    let mut crossings = Vec::new();
    let mut before = 0.0;
    for step in 0..(2.6 * period / dt) as usize {
        run.steps(1, dt);
        let u = run.world.deform.as_ref().expect("nodes").nodes.displacement[14][0];
        if step > 0 && before > 0.0 && u <= 0.0 {
            crossings.push((step as f64 + before / (before - u)) * dt);
        }
        before = u;
    }
    run.evaluate(dt);
    let measured = crossings[1] - crossings[0];
    assert!((measured / period - 1.0).abs() < 0.02, "{}", measured / period);
    let view = run.view();
    let scale = run.world.solid_of(0).mass * 10.0 * 1e-6 * speed / length;
    assert!(view.momentum().length() < 1e-11 * scale, "{}", view.momentum());
    assert!(view.balance().residual_relative().abs() < 1e-9);
}

/// Two cubes that are pulled apart until their bond breaks.
fn pair_of(failure: BondFailure) -> Run {
    let half = 0.5;
    let blocks = [0.5, 1.5].map(|x| brick(Vec3::new(x, half, half), Vec3::splat(half))).to_vec();
    let mut setup = deformable(rock(blocks, elastic()), Strain::Small, 0.01);
    setup.interfaces[0].bond = Some(BondLaw {
        strength: Some(Strength {
            tension: 1e6,
            cohesion: 4e6,
            friction: 0.5,
            residual_friction: 0.5,
            ..Strength::default()
        }),
        failure,
        ..bonds(0.01)
    });
    let velocity = [Some(riprap::dynamics::TimeFunction::Constant(1e-5)), None, None];
    Run::new(Setup {
        boundaries: vec![
            on_plane(-Vec3::X, 0.0, roller()),
            on_plane(-Vec3::Y, 0.0, roller()),
            on_plane(-Vec3::Z, 0.0, roller()),
            on_plane(Vec3::X, 2.0, BoundaryKind::Moved { velocity }),
        ],
        ..setup
    })
}

#[test]
fn a_bond_breaks_at_its_strength_and_gives_its_energy_back() {
    for failure in [BondFailure::Spring, BondFailure::Facet, BondFailure::BlockStress] {
        let mut run = pair_of(failure);
        let rules = Rules { relax: Some(1e-8), breaking: true, strain: None };
        begin(&mut run, &rules);
        let mut last = 0.0;
        let mut broken = 0;
        // 10 um a load step on 2 m of rock and a bond: 1 MPa is reached at 111.67 um.
        'steps: for _ in 0..16 {
            phase::load_step(&mut run.world, 1.0);
            run.evaluate(1.0);
            loop {
                run.steps(1, 1.0);
                run.evaluate(1.0);
                let relax = run.world.deform.as_ref().and_then(|d| d.relax.clone());
                if !relax.is_some_and(|r| r.converged) {
                    continue;
                }
                let force = run.view().on_boundary(3).1.x;
                broken = fracture::step(&mut run.world, &mut run.scratch, 1.0).expect("finite");
                if broken > 0 {
                    break 'steps;
                }
                last = force;
                break;
            }
        }
        assert_eq!(broken, 1, "{failure:?}");
        // The step before carried less than the strength, the next one would carry more.
        let per_step = YOUNG * 1e-5 / (2.0 * (1.0 + 0.005));
        assert!(last < 1e6 && last + per_step > 1e6, "{failure:?}: {last}");
        // Relaxed again, nothing is left and the ledger closes.
        loop {
            run.steps(1, 1.0);
            run.evaluate(1.0);
            let relax = run.world.deform.as_ref().and_then(|d| d.relax.clone());
            if relax.is_some_and(|r| r.converged || r.iterations > 20_000) {
                break;
            }
        }
        let view = run.view();
        assert!(view.on_boundary(3).1.x.abs() < 1.0);
        let deform = run.world.deform.as_ref().expect("nodes");
        assert!((deform.broken_area[0] - 1.0).abs() < 1e-12 && deform.broken_area[1] == 0.0);
        assert_eq!(deform.broken.len(), 1);
        let balance = view.balance();
        let scale = balance.works.supports.abs();
        assert!(balance.residual().abs() < 1e-8 * scale, "{balance:?}");
        // A released bond held t^2 L/2E, all else was damped away.
        assert!(balance.works.fracture > 0.0 && balance.works.fracture < 0.01 * scale);
    }
}

/// The notch of whole facets ends with them; that of springs takes those at its tip along, which carry a third of the next facet and
/// hold the faces across it together.
#[test]
fn a_notch_of_springs_is_a_third_of_a_block_longer() {
    let broken = |springs: bool| {
        let mut setup = deformable(rock(lattice([2, 2, 1], 1.0), elastic()), Strain::Small, 0.01);
        let corners = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 1.0)];
        setup.deform.notches = vec![Notch { corners, springs }];
        let run = Run::new(setup);
        let deform = run.world.deform.as_ref().unwrap();
        let points = deform.points.iter().zip(&deform.memory);
        let broken = points.filter(|(_, m)| m.state.is_broken());
        broken.map(|(p, _)| p.area).collect::<Vec<f64>>()
    };
    let facets = broken(false);
    assert_eq!(facets.len(), 5);
    assert!((facets.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    let springs = broken(true);
    assert_eq!(springs.len(), 5 + 2 + 4);
    assert!((springs.iter().sum::<f64>() - (1.0 + 1.0 / 3.0 + 2.0 / 3.0)).abs() < 1e-12);
}

/// Constant damping and the change of energy as a measure of rest lead to the same equilibrium, more slowly.
#[test]
fn the_relaxation_of_the_source_finds_the_same_equilibrium() {
    let end = |way: Option<Relaxation>| {
        let mut run = bar(4, 0.03, 3e-4, 1e6);
        let rules = Rules { relax: Some(1e-8), breaking: false, strain: None };
        begin(&mut run, &rules);
        if let Some(way) = way {
            phase::relax_by(&mut run.world, way);
        }
        let converged = |run: &Run| {
            let relax = run.world.deform.as_ref().and_then(|d| d.relax.as_ref());
            relax.is_some_and(|r| r.converged)
        };
        while !converged(&run) {
            assert!(run.world.step < 100_000);
            run.steps(1, 1.0);
        }
        run.evaluate(1.0);
        (run.view().strain_energy(), run.world.step)
    };
    let (energy, steps) = end(None);
    let way = Relaxation { damping: Some(0.05), energy: Some(1e-9), ..Relaxation::default() };
    let (same, more) = end(Some(way));
    assert!((same / energy - 1.0).abs() < 1e-5, "{same} {energy}");
    assert!(more > 0 && steps > 0);
}

#[test]
fn a_stretched_bond_turns_with_its_blocks() {
    let half = 0.5;
    let blocks = [0.5, 1.5].map(|x| brick(Vec3::new(x, half, half), Vec3::splat(half))).to_vec();
    let mut run = Run::new(deformable(rock(blocks, elastic()), Strain::Large, 0.01));
    let rules = Rules { relax: None, breaking: false, strain: None };
    begin(&mut run, &rules);
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.3, -0.8, 1.9));
    let gap = Vec3::new(1e-6, 2e-6, 0.0);
    let deform = run.world.deform.as_mut().expect("nodes");
    let nodes = deform.nodes.len();
    for (k, (u, x)) in deform.nodes.displacement.iter_mut().zip(&deform.nodes.place).enumerate() {
        let apart = if k < nodes / 2 { Vec3::ZERO } else { gap };
        *u = (turn * (*x + apart) - *x).to_array();
    }
    run.evaluate(1e-9);
    let force = run.view().facet_force((0, 1));
    let shear = YOUNG / 2.5;
    let wanted = turn * Vec3::new(YOUNG / 0.01 * gap.x, shear / 0.01 * gap.y, 0.0);
    assert!((force - wanted).length() < 1e-9 * wanted.length(), "{force} {wanted}");
}

#[test]
fn the_measure_of_strain_can_change_with_the_phase() {
    let mut run = spinning(Strain::Small);
    let large = Rules { relax: None, breaking: false, strain: Some(Strain::Large) };
    begin(&mut run, &large);
    let dt = 0.25 * stable_step(&run.world, &run.scratch, 0.0).dt;
    run.steps(2000, dt);
    let deformable = run.view().deformable(0).expect("a deformable block");
    assert_eq!(deformable.body.strain, Strain::Large);
    let first = deformable.body.first as usize;
    let size = deformable.place(first).distance(deformable.place(first + 7));
    assert!((size / (0.03 * 3f64.sqrt()) - 1.0).abs() < 1e-3, "{size}");
}
