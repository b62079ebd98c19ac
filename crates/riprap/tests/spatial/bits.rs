//! The same bits for any number of threads, and over a checkpoint; the same motion in another frame.

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::spatial::charge;
use riprap::spatial::lanes::Width;
use riprap::spatial::setup::{
    Boundary, BoundaryKind, CavityPressure, Coupling, Criterion, During, FaceSet, Kinematics,
    Place, Refinement, Region, Setup, Shape, Source, Venting,
};
use riprap::spatial::step::{Scratch, advance};
use riprap::spatial::tiles::Cut;
use riprap::spatial::topology;
use riprap::spatial::topology::EditKind;
use riprap::spatial::world::{World, flag};

use crate::spatial::blast::{AMMONIUM, CRACKS};
use crate::spatial::rock::{Draws, Run, elastic, lattice, rock, strength};

/// A body with everything: sizes, failure, damping, viscous and held faces, gravity, finite rotations.
fn everything() -> Setup {
    let law = riprap::spatial::setup::JointLaw {
        strength: Some(strength(0.1e6, 30.0, 0.0)),
        damping: 0.1,
        contact_damping: 0.1,
        ..elastic()
    };
    let mut setup = rock(lattice([16, 14, 12], 1.0), law);
    let mut draws = Draws::new(11);
    for block in &mut setup.blocks {
        block.velocity = 0.5 * draws.vector();
        block.spin = 5.0 * draws.vector();
    }
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    setup.kinematics = Kinematics::Automatic;
    setup.rotation_bound = Some(0.0003);
    setup.refinements =
        vec![Refinement { around: Region::Ball(Vec3::splat(6.0), 3.0), levels: 2, during: None }];
    let side = |name: &str, normal: Vec3, offset: f64, kind: BoundaryKind| Boundary {
        name: name.into(),
        on: FaceSet::Plane { normal, offset },
        kind,
        in_situ: false,
    };
    setup.boundaries = vec![
        side("west", -Vec3::X, 0.0, BoundaryKind::Viscous { half_cell: true }),
        side("east", Vec3::X, 16.0, BoundaryKind::Viscous { half_cell: false }),
        side("base", -Vec3::Z, 0.0, BoundaryKind::Held { normal: true, shear: true }),
    ];
    setup
}

const DT: f64 = 1e-5;

fn bytes(world: &World) -> Vec<u8> {
    postcard::to_stdvec(world).expect("a world can be written")
}

#[test]
fn threads_do_not_change_a_bit() {
    let run = |threads: usize| {
        let mut run = Run::on(everything(), Exec::new(threads).expect("threads"));
        run.steps(40, DT);
        run
    };
    let one = run(1);
    let works = one.world.works;
    assert!(works.friction > 0.0 && works.damping > 0.0 && works.absorbed > 0.0);
    let finite = one.world.turned.iter().flatten().count();
    println!("{} blocks, {finite} finite", one.world.alive.len());
    assert!(finite > 0 && one.scratch.tiles.list.len() > 2);
    let expected = bytes(&one.world);
    for threads in [2, 3, 7] {
        assert!(bytes(&run(threads).world) == expected, "{threads} threads");
    }
}

#[test]
fn the_width_of_instructions_does_not_change_a_bit() {
    let run = |width: Width| {
        let mut run = Run::on(everything(), Exec::serial());
        run.scratch.limit_width(width);
        run.steps(20, DT);
        bytes(&run.world)
    };
    let expected = run(Width::PLAIN);
    assert!(run(Width::detect().at_most(4)) == expected && run(Width::detect()) == expected);
}

/// Each patch alone or beside any others in its packet, and pieces of any size.
#[test]
fn the_cut_of_the_work_does_not_change_a_bit() {
    let run = |kinematics: Kinematics, cut: Option<Cut>| {
        let mut setup = everything();
        setup.kinematics = kinematics;
        let mut run = Run::on(setup, Exec::new(2).expect("threads"));
        for _ in 0..2 {
            if let Some(cut) = cut {
                run.scratch.set_cut(&run.world, cut);
            }
            run.steps(20, DT);
        }
        println!("{} pieces", run.scratch.tiles.list.len());
        let flags = run.world.patches.flags.iter();
        let slide = flags.filter(|f| **f & flag::SLIDING != 0).count();
        assert!(slide > 100 && run.world.works.fracture > 0.0, "{slide}");
        (run.world.hash(), bytes(&run.world))
    };
    for kinematics in [Kinematics::Small, everything().kinematics] {
        let expected = run(kinematics, None);
        for (piece, packet) in [(64, 8), (192, 3), (2048, 1)] {
            let found = run(kinematics, Some(Cut { piece, packet }));
            assert_eq!(found.0, expected.0, "{piece} {packet}");
            assert!(found.1 == expected.1, "{piece} {packet}");
        }
    }
}

#[test]
fn a_checkpoint_goes_on_with_the_same_bits() {
    let mut whole = Run::on(everything(), Exec::serial());
    whole.steps(20, DT);
    let saved = bytes(&whole.world);
    let mut world: World = postcard::from_bytes(&saved).expect("a world can be read");
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut second = Run { world, scratch, damping: whole.damping };
    whole.steps(20, DT);
    second.steps(20, DT);
    assert!(bytes(&whole.world) == bytes(&second.world));
}

/// As above with a charge that fires after ten steps, and blocks that split where the stress is high.
fn blasted(venting: Option<Venting>) -> Setup {
    let mut setup = everything();
    setup.refinements.push(Refinement {
        around: Region::All,
        levels: 1,
        during: Some(During { criterion: Criterion::Stress, above: 4e6, every: 4 }),
    });
    setup.sources.push(Source {
        name: "charge".into(),
        place: Place::Point { centre: Vec3::splat(6.0) },
        delay: 10.0 * DT,
        hole: Default::default(),
        push: CavityPressure::Gas {
            explosive: AMMONIUM.into(),
            mass: 40.0,
            coupling: Coupling::Scaled { exponent: 0.5 },
            venting,
        },
    });
    setup
}

/// Gas that stays in, and gas that enters cracks.
fn both() -> [Option<Venting>; 2] {
    [None, Some(Venting::Cracks(CRACKS))]
}

/// Steps with the limit of the gas and with splitting.
fn run_on(run: &mut Run, steps: u64) {
    for _ in 0..steps {
        let dt = DT.min(charge::step_limit(&run.world));
        run.evaluate(dt);
        topology::refine_running(&mut run.world, &mut run.scratch, dt).expect("exact");
        advance(&mut run.world, &mut run.scratch, dt);
    }
    run.evaluate(DT);
}

fn splits(run: &Run) -> usize {
    let events = run.world.events.iter();
    events.filter(|e| e.kind == EditKind::Split).count()
}

#[test]
fn threads_do_not_change_a_bit_of_a_blast() {
    for venting in both() {
        let run = |threads: usize| {
            let mut run = Run::on(blasted(venting), Exec::new(threads).expect("threads"));
            run_on(&mut run, 60);
            run
        };
        let one = run(1);
        let cavity = &one.world.cavities[0];
        println!("{} splits, gas work {:.3e} J", splits(&one), cavity.work);
        assert!(cavity.work > 0.0 && splits(&one) >= 8);
        let late = one.world.events.iter().filter(|e| e.step > 10);
        assert!(late.count() > 0, "splits after the gas has begun to push");
        assert_eq!(one.view().gas_cracks() > 0, venting.is_some());
        let expected = bytes(&one.world);
        for threads in [2, 3, 7] {
            assert!(bytes(&run(threads).world) == expected, "{threads} threads");
        }
    }
}

#[test]
fn a_checkpoint_in_a_blast_goes_on_with_the_same_bits() {
    for venting in both() {
        let mut whole = Run::on(blasted(venting), Exec::serial());
        run_on(&mut whole, 30);
        assert!(whole.world.cavities[0].ignited.is_some() && splits(&whole) > 0);
        let saved = bytes(&whole.world);
        let mut world: World = postcard::from_bytes(&saved).expect("a world can be read");
        assert_eq!(world.sound(), Ok(()));
        let scratch = Scratch::new(&mut world, Exec::serial());
        let mut second = Run { world, scratch, damping: whole.damping };
        let before = splits(&whole);
        run_on(&mut whole, 30);
        run_on(&mut second, 30);
        assert!(splits(&whole) > before);
        assert_eq!(whole.view().gas_cracks() > 0, venting.is_some());
        assert!(bytes(&whole.world) == bytes(&second.world));
    }
}

/// A free body of two sizes with joints that fail.
fn free(kinematics: Kinematics) -> Setup {
    let law = riprap::spatial::setup::JointLaw {
        strength: Some(strength(0.05e6, 30.0, 0.02e6)),
        damping: 0.1,
        contact_damping: 0.1,
        ..elastic()
    };
    let mut draws = Draws::new(21);
    let mut blocks = lattice([4, 3, 3], 1.0);
    for block in &mut blocks {
        block.velocity = 0.02 * draws.vector();
        block.spin = 0.02 * draws.vector();
    }
    Setup {
        kinematics,
        refinements: vec![Refinement { around: Region::Point(Vec3::ONE), levels: 1, during: None }],
        ..rock(blocks, law)
    }
}

/// A body that falls apart, with contacts of three levels.
fn by_levels(exec: Exec) -> Run {
    let mut setup = free(Kinematics::Finite);
    setup.found_contacts = true;
    for block in &mut setup.blocks {
        block.velocity *= 100.0;
    }
    let mut run = Run::on(setup, exec);
    run.world.step_by_levels(3);
    run
}

fn waiting(run: &Run) -> usize {
    run.world.found.pairs.iter().filter(|pair| pair.clock.is_some()).count()
}

/// Over a checkpoint between two instants that all levels share, too.
#[test]
fn steps_by_level_have_the_same_bits() {
    let whole = |threads: usize| {
        let mut run = by_levels(Exec::new(threads).expect("threads"));
        run.steps(403, 2e-6);
        run
    };
    let one = whole(1);
    assert!(waiting(&one) > 4, "{} pairs wait", waiting(&one));
    let expected = bytes(&one.world);
    for threads in [2, 3] {
        assert!(bytes(&whole(threads).world) == expected, "{threads} threads");
    }
    let mut first = by_levels(Exec::serial());
    first.steps(201, 2e-6);
    assert!(waiting(&first) > 0);
    let mut world: World = postcard::from_bytes(&bytes(&first.world)).expect("a world can be read");
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut second = Run { world, scratch, damping: first.damping };
    second.steps(202, 2e-6);
    assert_eq!(second.world.hash(), one.world.hash());
}

/// Momentum and angular momentum to round-off while pairs act by impulses, and the energy books.
#[test]
fn steps_by_level_keep_momentum() {
    let mut run = by_levels(Exec::serial());
    run.evaluate(2e-6);
    let before = [run.view().momentum(), run.view().angular_momentum()];
    run.steps(800, 2e-6);
    let after = [run.view().momentum(), run.view().angular_momentum()];
    let scale: f64 = (run.view().living())
        .map(|b| run.world.solid_of(b).mass * run.view().velocity(b).length())
        .sum();
    for (k, (before, after)) in before.into_iter().zip(after).enumerate() {
        let error = (after - before).length() / scale;
        assert!(error < [1e-12, 1e-9][k], "{k}: {error:e}");
    }
    let residual = run.balance().residual_relative();
    assert!(residual.abs() < 1e-3, "{residual:e}");
}

/// Catalogue entry H8: shifted by 10 km, or boosted by 100 m/s. (Turned in space: `solids.rs`.)
#[test]
fn another_frame_sees_the_same_motion() {
    let dt = 2e-5;
    for kinematics in [Kinematics::Small, Kinematics::Finite] {
        let mut here = Run::new(free(kinematics));
        here.steps(200, dt);
        assert!(here.world.works.friction + here.world.works.fracture > 0.0);
        let shift = 1e4 * Vec3::new(0.6, -0.8, 0.3);
        let boost = 100.0 * Vec3::new(0.3, 0.5, -0.8);
        for (shift, boost, bound) in [(shift, Vec3::ZERO, 1e-6), (Vec3::ZERO, boost, 1e-8)] {
            let mut setup = free(kinematics);
            for block in &mut setup.blocks {
                block.velocity += boost;
                if let Shape::Brick { centre, .. } = &mut block.shape {
                    *centre += shift;
                }
            }
            for refinement in &mut setup.refinements {
                refinement.around = Region::Point(Vec3::ONE + shift);
            }
            let mut there = Run::new(setup);
            there.steps(200, dt);
            let mut worst = 0.0f64;
            let view = here.view();
            let way = |b: usize| here.world.bodies.displacement(b);
            let scale = view.living().map(|b| way(b).length()).fold(0.0, f64::max);
            for b in view.living() {
                let u = there.world.bodies.displacement(b) - there.world.time * boost;
                worst = worst.max((u - way(b)).length() / scale);
            }
            println!("{kinematics:?}: {worst:.1e} ({bound:.0e})");
            assert!(worst < bound, "{kinematics:?}: {worst:e}");
        }
    }
}
