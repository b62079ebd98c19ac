//! What must not change a result: threads, a stop in between, the frame of reference.
//!
//! Catalogue entries H4 (order of the scheme), H6, H7 and H8.

use std::path::{Path, PathBuf};

use riprap::Vec2;
use riprap::exec::Exec;
use riprap::model::{self, Model};
use riprap::plan::{Plan, TimeStep, Until};
use riprap::planar::fields::INFOS;
use riprap::planar::setup::Setup;
use riprap::record::folder::Existing;
use riprap::run::drive::{Control, Drive, Ending, Look, Pause};
use riprap::run::job::{self, Job};
use riprap::run::simulation::Simulation;
use riprap::scenario::{Source, parse};

/// A heap of polygons that falls on a floor, with friction and joints: everything that has a memory.
fn heap() -> Model {
    build(
        r#"
riprap = 1
title = "heap"
space.planar.gravity = ["0 m/s2", "-9.81 m/s2"]
materials.rock.density = "2500 kg/m3"
materials.ground.density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "200 MPa/m"
friction_angle = "30 deg"
[interfaces.joint]
between = ["rock", "rock"]
normal_stiffness = "200 MPa/m"
friction_angle = "30 deg"
bond = { tension = "5 kPa", cohesion = "10 kPa" }
[[blocks]]
name = "floor"
material = "ground"
rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
[[blocks]]
name = "column"
material = "rock"
voronoi = { region = [["-2 m", "0.5 m"], ["0 m", "0.5 m"], ["0 m", "3 m"], ["-2 m", "3 m"]], cell_size = "0.5 m", seed = 5, smallest_edge = "5 cm" }
[[blocks]]
name = "rubble"
material = "rock"
pour = { region = [["0.2 m", "0.1 m"], ["3 m", "3 m"]], count = 30, size = ["0.3 m", "0.4 m"], seed = 2 }
spin = "1 rad/s"
[[supports]]
on = { block = "floor" }
fixed = {}
[[phases]]
name = "fall"
until = { steps = 10_000 }
"#,
    )
}

fn build(text: &str) -> Model {
    let parsed = parse(Source::new("test.toml", text)).unwrap_or_else(|e| panic!("{e}"));
    model::build(&parsed, "default", INFOS).unwrap_or_else(|e| panic!("{e}"))
}

fn run(setup: impl Into<riprap::model::Setup>, plan: Plan, threads: usize) -> Simulation {
    let simulation = Simulation::new(setup, plan, Exec::new(threads).unwrap()).unwrap();
    let mut drive = Drive::new(simulation, None, Vec::new()).unwrap();
    let ending = drive.advance(Pause::NEVER, &mut on).unwrap();
    assert_eq!(ending, Some(Ending::Finished));
    drive.into_simulation()
}

fn on(_: &mut Look<'_>) -> Control {
    Control::Continue
}

/// H6: the number of threads does not change a bit of the state after 10 000 steps.
#[test]
fn threads_do_not_matter() {
    let model = heap();
    let hash = |threads| {
        let done = run(model.setup.clone(), model.plan.clone(), threads);
        done.engine().hash()
    };
    let one = hash(1);
    for threads in [2, 8, 16] {
        assert_eq!(one, hash(threads), "{threads} threads");
    }
}

/// H7: a run that is stopped half way and resumed from its folder ends in the same bits, broken joints
/// and friction memory included.
#[test]
fn a_resumed_run_ends_in_the_same_bits() {
    let mut model = heap();
    model.plan.phases[0].until.steps = Some(30_000);
    let job = || Job {
        setup: model.setup.clone(),
        plan: model.plan.clone(),
        checks: Vec::new(),
        resolved: String::new(),
        manifest: riprap::record::Manifest::default(),
        folder: std::path::PathBuf::new(),
    };
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| -> PathBuf { Path::join(folder.path(), name) };
    let whole = job::run(job(), &at("whole"), Existing::Refuse, 1, &mut on).unwrap();
    // The first look comes after one step, the next one as soon as 100 ms have gone.
    let mut looks = 0;
    let mut stop = |_: &mut Look<'_>| {
        looks += 1;
        if looks == 2 {
            return Control::Stop;
        }
        std::thread::sleep(std::time::Duration::from_millis(150));
        Control::Continue
    };
    let half = job::run(job(), &at("half"), Existing::Refuse, 1, &mut stop).unwrap();
    assert_eq!(half.ending, Ending::Stopped);
    assert!((1..30_000).contains(&half.manifest.steps), "{}", half.manifest.steps);
    let resumed = job::resume(&at("half"), 2, &mut on).unwrap();
    assert_eq!(resumed.manifest.steps, 30_000);
    assert_eq!(whole.manifest.state_hash, resumed.manifest.state_hash);
}

/// Three blocks that hit each other with friction, spin and damping, and slide on a moving plate.
const HIT: &str = r#"
riprap = 1
title = "hit"
space.planar.gravity = ["0 m/s2", "-9.81 m/s2"]
materials.rock.density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "500 MPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "plate"
material = "rock"
rectangle = { size = ["6 m", "0.5 m"], corner = ["-3 m", "-0.5 m"] }
[[blocks]]
name = "slider"
material = "rock"
rectangle = { size = ["1 m", "0.5 m"], corner = ["-1 m", "0.0 m"] }
velocity = ["1 m/s", "0 m/s"]
[[blocks]]
name = "square"
material = "rock"
rectangle = { size = ["1 m", "1 m"], centre = ["0.3 m", "1.5 m"] }
rotate = { angle = "30 deg" }
velocity = ["0 m/s", "-2 m/s"]
[[supports]]
on = { block = "plate" }
motion = { velocity = { x = { constant = "0 m/s" }, y = { constant = "0 m/s" }, spin = { constant = "0 rad/s" } } }
[[phases]]
name = "go"
until = { time = "0.4 s" }
time_step = "50 us"
"#;

/// Displacements and rotations of all blocks at the end of a run.
fn ends(setup: Setup, plan: Plan) -> Vec<(Vec2, f64)> {
    let done = run(setup, plan, 1);
    let view = done.view().planar().unwrap();
    view.living().map(|b| (view.displacement(b), view.rotation(b))).collect()
}

fn moved(change: impl Fn(&mut Setup)) -> Vec<(Vec2, f64)> {
    let model = build(HIT);
    let mut setup = model.setup.planar().unwrap().clone();
    change(&mut setup);
    ends(setup, model.plan)
}

fn assert_close(a: &[(Vec2, f64)], b: &[(Vec2, f64)], tolerance: f64) {
    for (block, ((da, ra), (db, rb))) in a.iter().zip(b).enumerate() {
        let (shift, turn) = ((*da - *db).length(), (ra - rb).abs());
        assert!(shift < tolerance && turn < tolerance, "block {block}: {shift:e} m, {turn:e} rad");
    }
}

/// H8: a scene turned by an arbitrary angle.
#[test]
fn a_turned_scene_does_the_same() {
    let (sin, cos) = 1.234_f64.sin_cos();
    let turn = |v: Vec2| Vec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
    let turned = moved(|setup| {
        setup.gravity = turn(Vec2::from(setup.gravity)).into();
        for block in &mut setup.blocks {
            block.vertices.iter_mut().for_each(|v| *v = turn(*v));
            block.velocity = turn(block.velocity);
        }
    });
    let expected: Vec<(Vec2, f64)> = moved(|_| {}).iter().map(|(d, r)| (turn(*d), *r)).collect();
    assert!(expected[2].0.length() > 0.3, "something happens: {expected:?}");
    assert_close(&turned, &expected, 1e-8);
}

/// H8: a scene 10 km away.
#[test]
fn a_shifted_scene_does_the_same() {
    let shift = Vec2::new(1e4, -7e3);
    let shifted = moved(|setup| {
        for block in &mut setup.blocks {
            block.vertices.iter_mut().for_each(|v| *v += shift);
        }
    });
    assert_close(&shifted, &moved(|_| {}), 1e-6);
}

/// H8: a scene seen from a train at 100 m/s.
#[test]
fn a_moving_frame_does_not_matter() {
    use riprap::dynamics::TimeFunction;
    use riprap::planar::setup::Motion;
    let boost = Vec2::new(100.0, 0.0);
    let model = build(HIT);
    let mut setup = model.setup.planar().unwrap().clone();
    for block in &mut setup.blocks {
        block.velocity += boost;
    }
    for support in &mut setup.supports {
        support.motion = Motion::Velocity {
            x: Some(TimeFunction::Constant(boost.x)),
            y: Some(TimeFunction::Constant(0.0)),
            spin: Some(TimeFunction::Constant(0.0)),
            about: None,
        };
    }
    let boosted: Vec<(Vec2, f64)> =
        ends(setup, model.plan).into_iter().map(|(d, r)| (d - 0.4 * boost, r)).collect();
    assert_close(&boosted, &moved(|_| {}), 1e-8);
}

/// H4: the error of an undamped swing falls with the square of the step.
#[test]
fn the_scheme_is_of_second_order() {
    let model = build(
        r#"
riprap = 1
title = "swing"
space.planar.gravity = ["0 m/s2", "-1 mm/s2"]
materials.rock.density = "1000 kg/m3"
[interfaces.default]
normal_stiffness = "10 MPa/m"
friction_coefficient = 0.0
damping_ratio = 0.0
[[blocks]]
name = "floor"
material = "rock"
rectangle = { size = ["3 m", "1 m"], corner = ["-1.5 m", "-1 m"] }
[[blocks]]
name = "block"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["-0.5 m", "0 m"] }
[[supports]]
on = { block = "floor" }
fixed = {}
[[phases]]
name = "swing"
until = { time = "0.1 s" }
"#,
    );
    // omega = 100 rad/s, static depth 1e-7 m.
    let exact = -1e-7 * (1.0 - 10.0_f64.cos());
    let error = |steps: u64| {
        let mut plan = model.plan.clone();
        plan.phases[0].time_step = TimeStep::Given { dt: 0.1 / steps as f64 };
        plan.phases[0].until = Until { steps: Some(steps), ..Until::default() };
        let done = run(model.setup.clone(), plan, 1);
        (done.view().planar().unwrap().displacement(1).y - exact).abs()
    };
    let [coarse, middle, fine] = [100, 200, 400].map(error);
    for (a, b) in [(coarse, middle), (middle, fine)] {
        let order = (a / b).log2();
        assert!((order - 2.0).abs() < 0.1, "order {order}: {coarse:e} {middle:e} {fine:e}");
    }
}
