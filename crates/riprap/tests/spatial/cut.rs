//! Cutting of deformable blocks: what must stay, and where the source's examples cut.

use riprap::Vec3;
use riprap::laws::bond::{Cohesive, Softening};
use riprap::laws::fracture::{Criterion, Margins};
use riprap::spatial::deform::phase::Rules;
use riprap::spatial::deform::store::Masses;
use riprap::spatial::setup::deform::{BondFailure, NodeHold, Strain, Strength};
use riprap::spatial::setup::{Boundary, BoundaryKind, FaceSet, Setup};
use riprap::spatial::topology::EditKind;
use riprap::spatial::topology::cut;
use riprap::spatial::topology::cut::Anchor;

use crate::spatial::deform::{begin, bonds, deformable, on_plane, pull, roller};
use crate::spatial::rock::{Draws, Run, brick, elastic, lattice, rock};

/// Momentum, angular momentum, kinetic energy and mass of all nodes.
fn sums(run: &Run) -> (Vec3, Vec3, f64, f64) {
    let (deform, work) = run.view().deformables().unwrap();
    let (mut p, mut h, mut t, mut mass) = (Vec3::ZERO, Vec3::ZERO, 0.0, 0.0);
    for body in deform.living() {
        let masses = work.class(body).masses();
        for (n, m) in body.nodes().zip(masses) {
            let at = deform.nodes.place[n] + Vec3::from_array(deform.nodes.displacement[n]);
            let v = Vec3::from_array(deform.nodes.velocity[n]);
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
        let mut run = Run::new(deformable(rock(vec![block], elastic()), Strain::Small, 3e-4));
        let dynamic = Rules { relax: None, breaking: false, strain: None };
        begin(&mut run, &dynamic);
        let deform = run.world.deform.as_mut().unwrap();
        assert_eq!(deform.masses, Masses::Inertia);
        let mut draw = || draws.vector();
        let (a, b, c, spin, slide) = (draw(), draw(), draw(), draw(), draw());
        for n in 0..deform.nodes.len() {
            let r = (deform.nodes.place[n] - Vec3::new(1.0, 2.0, -1.0)) / half;
            let u = 1e-6 * (a * r.x + b * r.y + c * r.z + 0.3 * r * r.x);
            let v = slide + spin.cross(r) + 0.1 * draw();
            deform.nodes.displacement[n] = u.to_array();
            deform.nodes.velocity[n] = v.to_array();
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
        assert!((h1 - h).length() < 1e-12 * scale, "{}", (h1 - h).length() / scale);
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
    let mut setup = deformable(rock(lattice([10, 10, 1], edge), elastic()), Strain::Small, 3e-4);
    setup.materials[0].young = Some(30e9);
    let friction = 30_f64.to_radians().tan();
    setup.interfaces[0].bond = Some(riprap::spatial::setup::deform::BondLaw {
        strength: Some(Strength {
            tension: 5e6,
            cohesion: 8e6,
            friction,
            residual_friction: friction,
            ..Strength::default()
        }),
        failure: BondFailure::BlockStress,
        ..bonds(3e-4)
    });
    let held = |min: Vec3, max: Vec3, velocity: [bool; 3]| NodeHold {
        min,
        max,
        blocks: None,
        velocity: velocity.map(|v| v.then_some(riprap::dynamics::TimeFunction::Constant(0.0))),
    };
    setup.deform.holds =
        vec![held(Vec3::new(0.0, 0.3, 0.0), Vec3::new(0.3, 0.3, edge), [true, false, true])];
    Run::new(Setup {
        boundaries: vec![
            on_plane(-Vec3::Z, 0.0, roller()),
            on_plane(Vec3::Z, edge, roller()),
            Boundary {
                name: "bottom".into(),
                on: FaceSet::Plane { normal: -Vec3::Y, offset: 0.0 },
                kind: BoundaryKind::Held { normal: true, shear: true },
                in_situ: false,
            },
            on_plane(Vec3::Y, 0.3, pull(Vec3::new(0.0, -30e6, 0.0))),
        ],
        ..setup
    })
}

/// Relaxes to the tolerance without breaking; the number of blocks cut on the way.
fn relax(run: &mut Run, tolerance: f64, rules: Option<&cut::Rules>) -> usize {
    let phase = Rules { relax: Some(tolerance), breaking: false, strain: None };
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
        margins: Margins { tension: 0.0, shear: margin },
        generations: 1,
        smallest: 0.0,
        anchor: Anchor::Spacing,
        only_cut: false,
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
    println!("margin {margin}: {cut} cut, drift {}", settled(&run) / before - 1.0);
    assert!(cut.abs_diff(count) <= slack, "{cut}");
    assert!((settled(&run) / before - 1.0).abs() < 2e-3);
    assert_eq!(run.world.alive.iter().filter(|a| **a).count(), 100 + 3 * cut);
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
        assert!(n.z.abs() < 1e-12 && (angle.abs() - 60.0).abs() < 7.0, "{angle} at {place}");
        let (across, up) = (place.x - 0.15, place.y - 0.15);
        if up.abs() > 0.02 {
            assert!(angle * across * up > 0.0, "{angle} at {place}");
        }
    }
    assert!(run.balance().residual_relative().abs() < 1e-9);
}

/// A dynamic phase of cubes that fly apart a little.
fn dynamic(counts: [usize; 3]) -> Run {
    let mut setup = deformable(rock(lattice(counts, 0.03), elastic()), Strain::Small, 3e-4);
    setup.materials[0].young = Some(30e9);
    let mut run = Run::new(setup);
    let rules = Rules { relax: None, breaking: false, strain: None };
    begin(&mut run, &rules);
    run.evaluate(1e-9);
    run
}

#[test]
fn the_effort_of_a_cut_does_not_grow_with_the_model() {
    let effort = |counts: [usize; 3]| {
        let mut run = dynamic(counts);
        let centre = (1 + counts[0] * (1 + counts[1])) as u32;
        // The first cut finds the frequencies of all blocks.
        let mut efforts = [0, centre].map(|block| {
            let normal = Vec3::new(1.0, 0.4, 0.2);
            let given = (block, normal, 3);
            cut::one(&mut run.world, &mut run.scratch, given, 1e-9).unwrap();
            run.scratch.deform.as_ref().unwrap().effort
        });
        let blocks: usize = counts.iter().product();
        assert_eq!(efforts[0].frequencies, blocks + 3);
        efforts[0].frequencies = 0;
        efforts
    };
    let small = effort([3, 3, 3]);
    assert_eq!((small[0].classes, small[1].classes), (4, 4));
    // Four parts and six neighbours.
    assert_eq!(small[1].frequencies, 10);
    // At least one facet to each neighbour, and three between the parts.
    assert!((9..=27).contains(&small[1].facets), "{small:?}");
    assert_eq!(effort([5, 4, 6]), small);
}

/// The bound of the highest frequency block by block, over what power iteration finds.
#[test]
fn the_stable_step_after_a_cut_is_safe_and_not_much_too_short() {
    let mut draws = Draws::new(11);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for _ in 0..12 {
        let mut run = dynamic([3, 3, 3]);
        for block in [13, 14, 4] {
            let given = (block, draws.vector(), 3);
            cut::one(&mut run.world, &mut run.scratch, given, 1e-9).unwrap();
        }
        let exec = riprap::exec::Exec::serial();
        let highest = |run: &Run| {
            let (deform, work) = run.view().deformables().unwrap();
            riprap::spatial::stable::deformable::highest(&run.world, deform, work, &exec).0
        };
        let kept = highest(&run);
        // As after a restart: nothing is known.
        run.scratch.invalidate(&mut run.world);
        assert_eq!(highest(&run), kept);
        run.world.deform.as_mut().unwrap().given = None;
        let ratio = kept / highest(&run);
        (least, most) = (least.min(ratio), most.max(ratio));
    }
    println!("squared frequencies by blocks over power iteration: {least} to {most}");
    assert!(least > 0.999, "{least}");
    assert!(most < 1.2, "{most}");
}

#[test]
fn softening_bonds_keep_traction_and_damage_and_new_ones_are_whole() {
    let strength = Strength {
        tension: 2e6,
        cohesion: 10e6,
        friction: 0.5,
        residual_friction: 0.5,
        ..Strength::default()
    };
    let mut setup = deformable(rock(lattice([2, 1, 1], 0.03), elastic()), Strain::Small, 3e-4);
    setup.materials[0].young = Some(30e9);
    setup.interfaces[0].bond = Some(riprap::spatial::setup::deform::BondLaw {
        strength: Some(strength),
        cohesive: Some(Cohesive {
            strength,
            energy: [20.0, 80.0],
            softening: Softening::Munjiza,
            curve: None,
        }),
        ..bonds(3e-4)
    });
    let mut run = Run::new(setup);
    let rules = Rules { relax: None, breaking: true, strain: None };
    begin(&mut run, &rules);
    // The second block comes off, more and more towards +y.
    let deform = run.world.deform.as_mut().unwrap();
    for n in deform.bodies[1].nodes() {
        let opening = 4e-6 * (1.0 + 0.5 * (deform.nodes.place[n].y / 0.03));
        deform.nodes.displacement[n] = [opening, 0.0, 0.0];
    }
    run.scratch.invalidate(&mut run.world);
    run.evaluate(1e-9);
    // Area, force on A and mean damage of facets, by whether they join parts of one block.
    let sums = |run: &Run, inside: bool| {
        let (deform, work) = run.view().deformables().unwrap();
        let (mut area, mut force, mut damage) = (0.0, Vec3::ZERO, 0.0);
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for facet in deform.facets.iter().filter(|f| inside != f.blocks.contains(&1)) {
            for p in facet.points() {
                let d = deform.memory[p].law.damage;
                area += deform.points[p].area;
                force += Vec3::from_array(work.slots[p]);
                damage += deform.points[p].area * d;
                (least, most) = (least.min(d), most.max(d));
            }
        }
        (area, force, damage / area, [least, most])
    };
    let before = sums(&run, false);
    assert!(before.3[0] > 0.5 && before.3[1] < 1.0, "{before:?}");
    let normal = Vec3::new(0.1, 1.0, 0.2);
    let parts = cut::one(&mut run.world, &mut run.scratch, (0, normal, 3), 1e-9).unwrap();
    assert_eq!(parts.len(), 4);
    let after = sums(&run, false);
    assert!((after.0 / before.0 - 1.0).abs() < 1e-12);
    // Each new point goes on as the nearest old one.
    assert!((after.1.x / before.1.x - 1.0).abs() < 0.05, "{before:?} {after:?}");
    assert!((after.2 - before.2).abs() < 0.01, "{before:?} {after:?}");
    assert!(after.3[0] >= before.3[0] && after.3[1] <= before.3[1]);
    let inside = sums(&run, true);
    assert!(inside.0 > 0.0 && inside.3 == [0.0, 0.0], "{inside:?}");
    let deform = run.world.deform.as_ref().unwrap();
    let new = deform.facets.iter().filter(|f| f.blocks.contains(&1));
    assert!(new.count() >= 3);
}
