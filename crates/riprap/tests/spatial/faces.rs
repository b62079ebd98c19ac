//! Faces that fail as one (shear, bending, twist), faces that are moved, pressures that grow with depth.

use riprap::Vec3;
use riprap::dynamics::TimeFunction;
use riprap::spatial::setup::{
    Boundary, BoundaryKind, FaceSet, Failure, JointLaw, Load, LoadKind, Motion, Setup, Strength,
    Support,
};
use riprap::spatial::world::flag;

use crate::spatial::rock::{Run, brick, elastic, lattice, rock, strength};

/// Pressure on the face, Pa.
const PRESSURE: f64 = 1e6;
const COHESION: f64 = 0.5e6;
const DT: f64 = 5e-5;

fn boundary(normal: Vec3, offset: f64, kind: BoundaryKind) -> Boundary {
    Boundary { name: "side".into(), on: FaceSet::Plane { normal, offset }, kind, in_situ: false }
}

fn pressure(pressure: f64, gradient: f64, datum: f64) -> BoundaryKind {
    BoundaryKind::Traction {
        traction: Vec3::ZERO,
        pressure,
        gradient,
        datum,
        time: TimeFunction::Constant(1.0),
    }
}

/// A cube of 1 m on a fixed one, pressed by 1 MPa, with points at the middles of the quarters; a load on it
/// grows from zero over 100 ms.
fn loaded(strength: Strength, failure: Failure, load: LoadKind) -> Run {
    let law =
        JointLaw { strength: Some(strength), behaviour: Default::default(), failure, ..elastic() };
    let cubes = [-0.5, 0.5].map(|z| brick(Vec3::new(0.0, 0.0, z), Vec3::splat(0.5)));
    let mut setup = rock(cubes.to_vec(), law);
    setup.supports.push(Support {
        blocks: vec![0],
        motion: Motion::Fixed { translation: [true; 3], rotation: [true; 3] },
    });
    setup.boundaries.push(boundary(Vec3::Z, 1.0, pressure(PRESSURE, 0.0, 0.0)));
    setup.loads.push(Load {
        blocks: vec![1],
        kind: load,
        account: None,
        time: TimeFunction::Ramp { from: 0.0, to: 1.0, start: 0.0, end: 0.1 },
    });
    let mut run = Run::new(setup);
    run.damping.local = 0.8;
    // The weight settles before the load matters.
    run.steps((0.15 / DT) as usize, DT);
    run
}

fn broken(run: &Run) -> u32 {
    (run.world.patches.flags[0] & flag::BROKEN).count_ones()
}

/// Cohesion that is lost at failure, friction 30 deg.
fn bonded() -> Strength {
    strength(COHESION, 30.0, 0.2e6)
}

/// Shear failure when the mean shear stress reaches c + p tan(phi); then the face slides.
#[test]
fn a_face_fails_by_its_shear_force() {
    let limit = COHESION + PRESSURE * 30f64.to_radians().tan();
    for failure in [Failure::Point, Failure::Face] {
        for (share, fails) in [(0.98, false), (1.02, true)] {
            // In the plane of the joint: no bending.
            let load = LoadKind::Point {
                force: share * limit * Vec3::new(0.6, 0.8, 0.0),
                at: Some(Vec3::ZERO),
            };
            let run = loaded(bonded(), failure, load);
            assert_eq!(broken(&run), if fails { 4 } else { 0 }, "{failure:?} {share}");
            let moved = run.world.bodies.displacement(1).truncate();
            if fails {
                assert!(moved.length() > 1e-2, "{moved}");
                assert!((moved.y / moved.x - 4.0 / 3.0).abs() < 0.01, "{moved}");
            } else {
                let spring = share * limit / (2.0 * 7.2e9);
                assert!((moved.length() / spring - 1.0).abs() < 1e-3, "{moved}");
            }
        }
    }
}

/// A twist fails the whole face when the shear it makes at the points reaches the limit.
#[test]
fn a_face_fails_by_torsion() {
    let limit = COHESION + PRESSURE * 30f64.to_radians().tan();
    let reach = 0.25 * 2f64.sqrt();
    for failure in [Failure::Point, Failure::Face] {
        for (share, fails) in [(0.98, false), (1.02, true)] {
            let load = LoadKind::Moment { moment: share * limit * reach * Vec3::Z };
            let run = loaded(bonded(), failure, load);
            assert_eq!(broken(&run), if fails { 4 } else { 0 }, "{failure:?} {share}");
            let turned = run.world.bodies.rotation(1).z;
            if fails {
                assert!(turned > 1e-2, "{turned}");
            } else {
                // Ks a^4/8 with points at the middles of the quarters.
                let spring = share * limit * reach / (2.0 * 7.2e9 / 8.0);
                assert!((turned / spring - 1.0).abs() < 1e-3, "{turned}");
            }
        }
    }
}

/// Bending tears the outer points of a face that fails by points, at sigma = T. The sums of a face know nothing of bending: bonded, it
/// carries three times as much; unbonded it tips when the force leaves the middle of its points, at N a/4.
#[test]
fn bending_tears_points_and_tips_failed_faces() {
    let bend = |moment: f64| LoadKind::Moment { moment: moment * Vec3::X };
    let tears = (PRESSURE + 0.2e6) / 4.0;
    for (share, fails) in [(0.98, false), (1.02, true)] {
        let run = loaded(bonded(), Failure::Point, bend(share * tears));
        assert_eq!(broken(&run) > 0, fails, "{share}");
    }
    let run = loaded(bonded(), Failure::Face, bend(3.0 * tears));
    assert_eq!(broken(&run), 0);
    let spring = 3.0 * tears / (21.6e9 / 16.0);
    let turned = run.world.bodies.rotation(1).x;
    assert!((turned / spring - 1.0).abs() < 1e-3, "{turned}");
    let loose = strength(0.0, 30.0, 0.0);
    for (share, tips) in [(0.97, false), (1.03, true)] {
        let mut run = loaded(loose, Failure::Face, bend(share * PRESSURE / 4.0));
        run.world.patches.flags[0] |= flag::BROKEN;
        run.steps((0.2 / DT) as usize, DT);
        let turned = run.world.bodies.rotation(1).x;
        assert_eq!(turned > 1e-2, tips, "{share}: {turned}");
    }
}

/// The upper end of a column is moved: stress M v t/L, work of the support is what is stored.
#[test]
fn a_moved_face_squeezes_a_column() {
    let (n, speed, time) = (4, 1e-3, 0.1);
    let mut setup = rock(lattice([1, 1, n], 1.0), elastic());
    let moved = |along: f64, across: Option<f64>| BoundaryKind::Moved {
        velocity: [
            across.map(TimeFunction::Constant),
            None,
            Some(TimeFunction::Ramp { from: 0.0, to: along, start: 0.0, end: 0.2 * time }),
        ],
    };
    let held = BoundaryKind::Held { normal: true, shear: true };
    setup.boundaries =
        vec![boundary(Vec3::Z, n as f64, moved(-speed, None)), boundary(-Vec3::Z, 0.0, held)];
    let mut run = Run::new(setup.clone());
    run.steps((time / DT) as usize, DT);
    let pushed = 0.9 * speed * run.world.time;
    let expected = -21.6e9 * pushed / n as f64;
    let stress = run.view().stresses();
    for (b, s) in stress.iter().enumerate() {
        let found = s.col(2).z;
        assert!((found / expected - 1.0).abs() < 0.02, "{b}: {found:e} {expected:e}");
    }
    let balance = run.balance();
    assert!((balance.works.supports / (-0.5 * expected * pushed) - 1.0).abs() < 0.02);
    let defect = balance.residual() / balance.works.supports;
    println!("stress {:.4e} of {expected:.4e} Pa, residual {defect:.1e}", stress[0].col(2).z);
    assert!(defect.abs() < 1e-3, "{defect:e}");
    // A direction without velocity is left alone: a block that is held along z drifts along x and y.
    let mut alone = rock(lattice([1, 1, 1], 1.0), elastic());
    alone.boundaries = vec![boundary(-Vec3::Z, 0.0, moved(0.0, None))];
    alone.blocks[0].velocity = Vec3::new(0.3, -0.2, 0.0);
    let mut run = Run::new(alone);
    run.steps(100, DT);
    let way = run.world.bodies.displacement(0) - run.world.time * Vec3::new(0.3, -0.2, 0.0);
    assert!(way.length() < 1e-12, "{way}");
}

/// Earth pressure: force and moment of a pressure that grows with depth, for small and for turned blocks.
#[test]
fn pressure_grows_with_depth() {
    let (value, gradient, datum, height) = (10e3, 12e3, 2.5, 2.0);
    let body = brick(Vec3::new(0.0, 0.0, 0.5 * height), Vec3::new(0.5, 0.75, 0.5 * height));
    let mut setup: Setup = rock(vec![body], elastic());
    setup.boundaries = vec![boundary(Vec3::X, 0.5, pressure(value, gradient, datum))];
    let mut run = Run::new(setup);
    run.evaluate(0.0);
    let area = 1.5 * height;
    let mean = value + gradient * (datum - 0.5 * height);
    let force = run.scratch.net.force(0);
    assert!((force + area * mean * Vec3::X).length() < 1e-9 * area * mean, "{force}");
    // The larger push is below: it turns the block about -y by g h^2/12 A.
    let moment = run.scratch.net.moment(0);
    let expected = area * gradient * height * height / 12.0;
    assert!((moment.length() / expected - 1.0).abs() < 1e-9, "{moment} {expected}");
    assert!(moment.x.abs() + moment.z.abs() < 1e-9 * expected && moment.y > 0.0, "{moment}");
}
