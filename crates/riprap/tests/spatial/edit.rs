//! Splitting and removing blocks during a run: what stays, what follows, what is booked.

use riprap::Vec3;
use riprap::spatial::setup::{
    Boundary, BoundaryKind, Criterion, During, FaceSet, Failure, InSitu, JointLaw, Kinematics,
    Points, Refinement, Region, Setup,
};
use riprap::spatial::step::advance;
use riprap::spatial::topology;
use riprap::spatial::topology::EditKind;
use riprap::spatial::world::flag;

use crate::spatial::rock::{CP, Draws, Run, elastic, lattice, rock, strength};

const DT: f64 = 0.1 * 0.6325 * 0.25 / CP;

fn split(run: &mut Run, blocks: &[u32], dt: f64) {
    topology::split(&mut run.world, &mut run.scratch, blocks, dt).expect("the split is exact");
}

/// A free body with random motion after some steps.
fn moving(joint: JointLaw, kinematics: Kinematics, speed: f64, steps: usize) -> Run {
    let mut run = Run::new(Setup { kinematics, ..rock(lattice([4, 3, 3], 1.0), joint) });
    let mut draws = Draws::new(3);
    for b in 0..run.world.alive.len() {
        run.world.bodies.set_velocity(b, speed * draws.vector(), speed * draws.vector());
        let spin = run.world.bodies.spin(b);
        let inertia = run.world.solid_of(b).inertia;
        if let Some(turned) = &mut run.world.turned[b] {
            turned.momentum = inertia * spin;
        }
    }
    run.evaluate(DT);
    for _ in 0..steps {
        run.evaluate(DT);
        advance(&mut run.world, &mut run.scratch, DT);
    }
    run.evaluate(DT);
    run
}

#[test]
fn momenta_stay_and_the_defect_is_booked() {
    for kinematics in [Kinematics::Small, Kinematics::Finite] {
        for points in [Points::Quarter, Points::Gauss] {
            let joint = JointLaw { points, ..elastic() };
            let mut run = moving(joint, kinematics, 0.5, 40);
            let (p, l, residual) = {
                let view = run.view();
                let balance = view.balance();
                (view.momentum(), view.angular_momentum(), balance.residual())
            };
            let stored = run.balance().contact_normal + run.balance().contact_shear;
            let before = run.world.patches.len();
            // A block inside, its neighbour, and a child of the first.
            split(&mut run, &[17, 18, 36 + 5], DT);
            // 12 inner patches each; of the 6 + 5 outer ones, one is shared.
            assert!(run.world.patches.len() > before + 36);
            let view = run.view();
            let mass: f64 = view.living().map(|b| run.world.solid_of(b).mass).sum();
            assert!((mass / (36.0 * 2400.0) - 1.0).abs() < 1e-14);
            let scale = mass * 0.5;
            assert!((view.momentum() - p).length() < 1e-13 * scale);
            let turned = (view.angular_momentum() - l).length() / (4.0 * scale);
            assert!(turned < 1e-12, "{turned:e}");
            let after = view.balance();
            let share = after.works.edit_defect / stored;
            println!("{kinematics:?} {points:?}: edit defect / stored {share:.3}");
            assert!((after.residual() - residual).abs() < 1e-9 * after.total());
            assert!(share.abs() < 1.0);
            // It goes on from there without losing energy or momenta.
            let total = run.beginning(DT);
            for _ in 0..400 {
                advance(&mut run.world, &mut run.scratch, DT);
                run.evaluate(DT);
            }
            let view = run.view();
            assert!((view.momentum() - p).length() < 1e-12 * scale);
            let turned = (view.angular_momentum() - l).length() / (4.0 * scale);
            assert!(turned < 1e-11, "{turned:e}");
            let drift = view.balance().total() / total - 1.0;
            assert!(drift.abs() < 1e-4, "{kinematics:?} {points:?}: {drift:e}");
        }
    }
}

/// Uniform stress: the split block is in equilibrium as before, so nothing moves and the force on the others stays.
#[test]
fn a_split_under_uniform_stress_changes_nothing() {
    for points in [Points::Quarter, Points::Gauss] {
        let joint = JointLaw { points, strength: Some(strength(5e6, 30.0, 1e6)), ..elastic() };
        let mut setup = rock(lattice([3, 3, 3], 1.0), joint);
        setup.in_situ = Some(InSitu {
            stress: [-3e6, -2e6, -1e6, 0.2e6, 0.1e6, -0.3e6],
            gradient: [0.0; 6],
            datum: 0.0,
        });
        for normal in [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z] {
            setup.boundaries.push(Boundary {
                name: "side".into(),
                on: FaceSet::Plane {
                    normal,
                    offset: if normal.max_element() > 0.0 { 3.0 } else { 0.0 },
                },
                kind: BoundaryKind::Held { normal: true, shear: true },
                in_situ: true,
            });
        }
        let mut run = Run::new(setup);
        run.steps(3, DT);
        // The middle one, a corner with three held faces, and a child.
        split(&mut run, &[13, 0, 27 + 3], DT);
        let view = run.view();
        for b in view.living() {
            let force = run.scratch.net.force(b).length();
            let moment = run.scratch.net.moment(b).length();
            let area = run.world.solid_of(b).half.max_element().powi(2) * 4.0;
            assert!(force < 1e-9 * 3e6 * area, "{b}: {force}");
            assert!(moment < 1e-9 * 3e6 * area, "{b}: {moment}");
        }
        run.steps(200, DT);
        let view = run.view();
        let moved = view.living().map(|b| view.displacement(b).length()).fold(0.0, f64::max);
        assert!(moved < 1e-15, "{moved:e}");
        let share = run.balance().works.edit_defect
            / (run.balance().contact_normal + run.balance().contact_shear);
        println!("{points:?}: edit defect / stored {share:.3}");
    }
}

/// Faces of a loaded cube: forces of held and viscous springs pass to the children.
#[test]
fn springs_of_boundaries_follow() {
    for kind in [
        BoundaryKind::Held { normal: true, shear: true },
        BoundaryKind::Viscous { half_cell: true },
    ] {
        let mut setup = rock(lattice([2, 2, 2], 1.0), elastic());
        setup.boundaries.push(Boundary {
            name: "bottom".into(),
            on: FaceSet::Plane { normal: -Vec3::Z, offset: 0.0 },
            kind,
            in_situ: false,
        });
        setup.gravity = Vec3::new(0.3, 0.0, -9.81);
        let mut run = Run::new(setup);
        run.steps(60, DT);
        let force = |run: &Run| -> Vec3 {
            let view = run.view();
            view.living().map(|b| run.scratch.net.force(b)).sum()
        };
        let before = force(&run);
        split(&mut run, &[0, 1], DT);
        let after = force(&run);
        assert!(
            (after - before).length() < 1e-9 * before.length().max(2400.0 * 8.0 * 9.81),
            "{before} {after}"
        );
    }
}

/// Broken points stay broken, open ones open, and none carries more than its limit.
#[test]
fn failed_points_hand_on_their_state() {
    for failure in [Failure::Point, Failure::Face] {
        let joint = JointLaw {
            strength: Some(strength(1e5, 30.0, 1e5)),
            behaviour: Default::default(),
            failure,
            ..elastic()
        };
        let mut run = moving(joint, Kinematics::Small, 1.0, 300);
        let count = |run: &Run, group: u16| -> u32 {
            let flags = run.world.patches.flags.iter();
            flags.map(|f| (f & group).count_ones()).sum()
        };
        let share = |run: &Run, group| {
            f64::from(count(run, group)) / f64::from(4 * run.world.patches.len() as u32)
        };
        assert!(share(&run, flag::BROKEN) > 0.9, "{}", share(&run, flag::BROKEN));
        let p = run.view().momentum();
        let residual = run.balance().residual();
        let (patches, open) = (run.world.patches.len(), count(&run, flag::OPEN));
        split(&mut run, &[17], DT);
        let grown = run.world.patches.len() - patches;
        assert_eq!(grown, 12 + 6 * 3);
        assert!(count(&run, flag::OPEN) >= open);
        assert!((run.view().momentum() - p).length() < 1e-9);
        let scale = run.balance().works.peak;
        assert!((run.balance().residual() - residual).abs() < 1e-9 * scale);
        run.steps(200, DT);
    }
}

#[test]
fn blocks_above_a_limit_are_split_and_reported() {
    let joint = JointLaw { strength: Some(strength(1e5, 30.0, 1e5)), ..elastic() };
    for (criterion, above) in
        [(Criterion::Stress, 1e6), (Criterion::StrainRate, 0.5), (Criterion::Broken, 0.2)]
    {
        // Pressed blocks break nothing, pulled ones do.
        let speed = if criterion == Criterion::Broken { -2.0 } else { 2.0 };
        let mut setup = rock(lattice([6, 2, 2], 1.0), joint);
        setup.refinements.push(Refinement {
            around: Region::Box(Vec3::ZERO, Vec3::new(2.5, 2.0, 2.0)),
            levels: 2,
            during: Some(During { criterion, above, every: 5 }),
        });
        for (b, block) in setup.blocks.iter_mut().enumerate() {
            if b % 6 == 0 {
                block.velocity = Vec3::new(speed, 0.0, 0.0);
            }
        }
        let mut run = Run::new(setup);
        let mut count = 0;
        for _ in 0..60 {
            run.evaluate(DT);
            count += topology::refine_running(&mut run.world, &mut run.scratch, DT)
                .expect("an exact edit");
            advance(&mut run.world, &mut run.scratch, DT);
        }
        run.evaluate(DT);
        assert!(count >= 4, "{criterion:?} {count}");
        let events = &run.world.events;
        assert_eq!(events.len(), count);
        let first = &events[0];
        assert_eq!((first.kind, first.children.len()), (EditKind::Split, 8));
        assert!(first.step.is_multiple_of(5) && first.patches[1] >= first.patches[0] + 12);
        let named = run.world.name(first.children[6] as usize);
        let parent = run.world.name(first.subject as usize);
        assert_eq!(named, format!("{parent}/6"));
        let volume: f64 = run.view().living().map(|b| run.world.solid_of(b).volume).sum();
        assert!((volume - 24.0).abs() < 1e-12);
        let p = run.view().momentum();
        assert!((p - Vec3::new(4.0 * 2400.0 * speed, 0.0, 0.0)).length() < 1e-8, "{p}");
        let balance = run.balance();
        println!(
            "{criterion:?}: {count} splits, residual {:.1e} of {:.1e} J",
            balance.residual(),
            balance.total()
        );
        assert!(balance.residual().abs() < 0.02 * balance.start.abs().max(balance.total()));
    }
}

#[test]
fn a_removed_block_bares_the_faces_around_it() {
    let mut run = moving(elastic(), Kinematics::Small, 0.5, 40);
    let faces = run.world.faces.len();
    let residual = run.balance().residual();
    topology::transact(&mut run.world, &mut run.scratch, DT, |world, scratch| {
        topology::remove(world, &[17]);
        scratch.invalidate(world);
        Ok(())
    })
    .expect("finite forces");
    // A lattice of 4 x 3 x 3 whose block 17 = (1, 1, 1) has six neighbours.
    assert_eq!(run.world.faces.len(), faces + 6);
    assert_eq!(run.world.patches.len(), 3 * 36 - (9 + 12 + 12) - 6);
    assert!(run.world.events.iter().any(|e| e.kind == EditKind::Removed));
    assert!((run.balance().residual() - residual).abs() < 1e-9 * run.balance().total());
    let total = run.beginning(DT);
    run.steps(300, DT);
    assert!((run.balance().total() / total - 1.0).abs() < 1e-4);
    // Splitting beside the hole keeps the bared faces.
    split(&mut run, &[16], DT);
    run.steps(10, DT);
}
