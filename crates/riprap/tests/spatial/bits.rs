//! The same bits for any number of threads, and over a checkpoint.

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::spatial::lanes::Width;
use riprap::spatial::setup::{
    Boundary, BoundaryKind, FaceSet, Kinematics, Refinement, Region, Setup,
};
use riprap::spatial::step::Scratch;
use riprap::spatial::world::World;

use crate::rock::{Draws, Run, elastic, lattice, rock, strength};

/// A body with everything: sizes, failure, damping, viscous and held faces, gravity, finite rotations.
fn everything() -> Setup {
    let law = riprap::spatial::setup::JointLaw {
        strength: Some(strength(0.1e6, 30.0, 0.0)),
        damping: 0.1,
        ..elastic()
    };
    let mut setup = rock(lattice([16, 14, 12], 1.0), law);
    let mut draws = Draws::new(11);
    for block in &mut setup.blocks {
        block.velocity = 0.5 * draws.vector();
        block.spin = 5.0 * draws.vector();
    }
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    setup.kinematics = Kinematics::Automatic { bound: 0.0003 };
    setup.refinements = vec![Refinement {
        around: Region::Ball(Vec3::splat(6.0), 3.0),
        levels: 2,
        during: None,
    }];
    let side = |name: &str, normal: Vec3, offset: f64, kind: BoundaryKind| Boundary {
        name: name.into(),
        on: FaceSet::Plane { normal, offset },
        kind,
        in_situ: false,
    };
    setup.boundaries = vec![
        side(
            "west",
            -Vec3::X,
            0.0,
            BoundaryKind::Viscous { half_cell: true },
        ),
        side(
            "east",
            Vec3::X,
            16.0,
            BoundaryKind::Viscous { half_cell: false },
        ),
        side(
            "base",
            -Vec3::Z,
            0.0,
            BoundaryKind::Held {
                normal: true,
                shear: true,
            },
        ),
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
    let expected = run(Width::Plain);
    assert!(run(Width::Four) == expected && run(Width::Eight) == expected);
}

#[test]
fn a_checkpoint_goes_on_with_the_same_bits() {
    let mut whole = Run::on(everything(), Exec::serial());
    whole.steps(20, DT);
    let saved = bytes(&whole.world);
    let mut world: World = postcard::from_bytes(&saved).expect("a world can be read");
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut second = Run {
        world,
        scratch,
        damping: whole.damping,
    };
    whole.steps(20, DT);
    second.steps(20, DT);
    assert!(bytes(&whole.world) == bytes(&second.world));
}
