//! Cutting of deformable blocks: what must stay, and where the source's examples cut.

use riprap::Vec3;
use riprap::laws::fracture::{Criterion, Margins};
use riprap::spatial::deform::cut::{self, Anchor};
use riprap::spatial::deform::phase::Rules;
use riprap::spatial::deform::store::Masses;
use riprap::spatial::edit::EditKind;
use riprap::spatial::setup::deform::{BondFailure, NodeHold, Strain, Strength};
use riprap::spatial::setup::{Boundary, BoundaryKind, FaceSet, Setup};

use crate::deform::{begin, bonds, on_plane, pull, roller, soft};
use crate::rock::{Draws, Run, brick, elastic, lattice, rock};

/// Momentum, angular momentum, kinetic energy and mass of all nodes.
fn sums(run: &Run) -> (Vec3, Vec3, f64, f64) {
    let (deform, work) = run.view().softs().unwrap();
    let (mut p, mut h, mut t, mut mass) = (Vec3::ZERO, Vec3::ZERO, 0.0, 0.0);
    for body in deform.living() {
        let masses = work.kind(body).masses(deform.masses);
        for (n, m) in body.nodes().zip(masses) {
            let at = deform.nodes.place[n] + Vec3::from_array(deform.nodes.moved[n]);
            let v = Vec3::from_array(deform.nodes.rate[n]);
            p += *m * v;
            h += *m * at.cross(v);
            t += 0.5 * m * v.length_squared();
            mass += m;
        }
    }
    (p, h, t, mass)
}

#[test]
fn a_cut_keeps_mass_and_momenta_and_makes_no_energy() {
    let mut draws = Draws::new(5);
    let (mut worst_kinetic, mut worst_strain) = (0.0_f64, 0.0_f64);
    for _ in 0..60 {
        let half = 0.015;
        let block = brick(Vec3::new(1.0, 2.0, -1.0), Vec3::splat(half));
        let mut run = Run::new(soft(rock(vec![block], elastic()), Strain::Small, 3e-4));
        let dynamic = Rules {
            relax: None,
            breaking: false,
            strain: None,
        };
        begin(&mut run, &dynamic);
        let deform = run.world.deform.as_mut().unwrap();
        assert_eq!(deform.masses, Masses::Inertia);
        let mut draw = || draws.vector();
        let (a, b, c, spin, slide) = (draw(), draw(), draw(), draw(), draw());
        for n in 0..deform.nodes.len() {
            let r = (deform.nodes.place[n] - Vec3::new(1.0, 2.0, -1.0)) / half;
            let u = 1e-6 * (a * r.x + b * r.y + c * r.z + 0.3 * r * r.x);
            let v = slide + spin.cross(r) + 0.1 * draw();
            deform.nodes.moved[n] = u.to_array();
            deform.nodes.rate[n] = v.to_array();
        }
        run.evaluate(1e-9);
        let normal = draw();
        let (p, h, t, mass) = sums(&run);
        let strain = run.view().strain_energy();
        let residual = run.balance().residual();
        let parts = cut::one(&mut run.world, &mut run.scratch, (0, normal, 3), 1e-9).unwrap();
        assert!(parts.len() >= 2, "{parts:?}");
        let (p1, h1, t1, mass1) = sums(&run);
        assert!((mass1 / mass - 1.0).abs() < 1e-14);
        // Crooked faces: the blocks are as heavy as their nodes.
        let listed = parts.iter().map(|b| run.world.solid_of(*b as usize).mass);
        assert!((listed.sum::<f64>() / mass - 1.0).abs() < 1e-13);
        let scale = mass * (2.0 * t / mass).sqrt();
        assert!((p1 - p).length() < 1e-13 * scale);
        assert!(
            (h1 - h).length() < 1e-12 * scale,
            "{}",
            (h1 - h).length() / scale
        );
        assert!((run.balance().residual() - residual).abs() < 1e-12 * t);
        worst_kinetic = worst_kinetic.max(t1 / t);
        worst_strain = worst_strain.max(run.view().strain_energy() / strain);
    }
    println!("T {worst_kinetic}, W {worst_strain}");
    assert!(worst_kinetic <= 1.005, "{worst_kinetic}");
    assert!(worst_strain <= 1.0, "{worst_strain}");
}

/// The specimen of section 4.1 of the source.
fn specimen() -> Run {
    let edge = 0.03;
    let mut setup = soft(
        rock(lattice([10, 10, 1], edge), elastic()),
        Strain::Small,
        3e-4,
    );
    setup.materials[0].young = Some(30e9);
    let friction = 30_f64.to_radians().tan();
    setup.deform.bonds[0] = Some(riprap::spatial::setup::deform::BondLaw {
        strength: Some(Strength {
            tension: 5e6,
            cohesion: 8e6,
            friction,
            residual_friction: friction,
        }),
        failure: BondFailure::BlockStress,
        ..bonds(3e-4)
    });
    let held = |min: Vec3, max: Vec3, velocity: [bool; 3]| NodeHold {
        min,
        max,
        velocity: velocity.map(|v| v.then_some(riprap::dynamics::TimeFunction::Constant(0.0))),
    };
    setup.deform.holds = vec![held(
        Vec3::new(0.0, 0.3, 0.0),
        Vec3::new(0.3, 0.3, edge),
        [true, false, true],
    )];
    Run::new(Setup {
        boundaries: vec![
            on_plane(-Vec3::Z, 0.0, roller()),
            on_plane(Vec3::Z, edge, roller()),
            Boundary {
                name: "bottom".into(),
                on: FaceSet::Plane {
                    normal: -Vec3::Y,
                    offset: 0.0,
                },
                kind: BoundaryKind::Held {
                    normal: true,
                    shear: true,
                },
                in_situ: false,
            },
            on_plane(Vec3::Y, 0.3, pull(Vec3::new(0.0, -30e6, 0.0))),
        ],
        ..setup
    })
}

/// Relaxes to the tolerance without breaking; the number of blocks cut on the way.
fn relax(run: &mut Run, tolerance: f64, rules: Option<&cut::Rules>) -> usize {
    let phase = Rules {
        relax: Some(tolerance),
        breaking: false,
        strain: None,
    };
    begin(run, &phase);
    cut::allow(&mut run.world, rules);
    let mut count = 0;
    for _ in 0..50_000 {
        run.steps(1, 1.0);
        count += cut::step(&mut run.world, &mut run.scratch, 1.0).unwrap();
        let relax = run.world.deform.as_ref().and_then(|d| d.relax.as_ref());
        if relax.is_some_and(|r| r.converged) {
            return count;
        }
    }
    panic!("did not converge");
}

fn rules(margin: f64) -> cut::Rules {
    cut::Rules {
        planes: 3,
        criterion: Criterion::Source,
        margins: Margins {
            tension: 0.0,
            shear: margin,
        },
        generations: 1,
        smallest: 0.0,
        anchor: Anchor::Spacing,
        along: Some(Vec3::Z),
        snap: 0.03,
        stages: 1,
        step_floor: 0.1,
    }
}

#[test]
fn blocks_under_compression_are_cut_along_an_x() {
    let (margin, count, slack) = (2e6, 70, 4);
    let mut run = specimen();
    relax(&mut run, 1e-5, None);
    let settled = |run: &Run| run.view().on_boundary(3).0.y;
    let before = settled(&run);
    assert!((before / -2.760e-4 - 1.0).abs() < 5e-3, "{before}");
    let cut = relax(&mut run, 1e-5, Some(&rules(margin)));
    println!(
        "margin {margin}: {cut} cut, drift {}",
        settled(&run) / before - 1.0
    );
    assert!(cut.abs_diff(count) <= slack, "{cut}");
    assert!((settled(&run) / before - 1.0).abs() < 2e-3);
    assert_eq!(
        run.world.alive.iter().filter(|a| **a).count(),
        100 + 3 * cut
    );
    for event in run.world.events.iter().filter(|e| e.kind == EditKind::Cut) {
        let place = run.world.reference[event.subject as usize];
        let n = event.cut.unwrap().normal;
        // Angle of the plane from the x axis.
        let mut angle = (-n.x).atan2(n.y).to_degrees();
        if angle > 90.0 {
            angle -= 180.0;
        }
        if angle < -90.0 {
            angle += 180.0;
        }
        assert!(
            n.z.abs() < 1e-12 && (angle.abs() - 60.0).abs() < 7.0,
            "{angle} at {place}"
        );
        let (across, up) = (place.x - 0.15, place.y - 0.15);
        if up.abs() > 0.02 {
            assert!(angle * across * up > 0.0, "{angle} at {place}");
        }
    }
    assert!(run.balance().residual_relative().abs() < 1e-9);
}
