//! A block that falls: runs to the end, resumed, paused.

use super::*;
use crate::Vec2;
use crate::laws::parameters::{ContactLaw, FrictionLaw, NormalLaw, Reflex};
use crate::plan::{Damping, Every, Gauge, History, Integration, Phase, PhaseKind, TimeStep, Until};
use crate::plan::{Expected, Window};
use crate::planar::setup::{self, BlockSpec, Interface, Motion, Support};
use crate::record::table::Table;
use crate::run::checks::Status;

/// A block that falls onto a fixed one.
fn falling() -> Job {
    let square = |name: &str, y: f64| BlockSpec {
        name: name.to_owned(),
        vertices: [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .map(|[x, dy]| Vec2::new(x, y + dy))
            .to_vec(),
        material: 0,
        density: 2000.0,
        velocity: Vec2::ZERO,
        spin: 0.0,
    };
    let contact = ContactLaw {
        normal: NormalLaw::DistancePotential,
        reflex: Reflex::Min,
        normal_stiffness: 1e8,
        shear_stiffness: 5e7,
        friction: 0.5,
        cohesion: 0.0,
        friction_law: FrictionLaw::ShearSpring,
        clip_speed: 0.0,
        damping_ratio: 0.2,
    };
    let setup = setup::Setup {
        gravity: [0.0, -10.0],
        materials: vec!["rock".to_owned()],
        blocks: vec![square("base", 0.0), square("top", 1.02)],
        interfaces: vec![Interface { name: "default".to_owned(), contact, bond: None }],
        pair_table: vec![0],
        supports: vec![Support {
            blocks: vec![0],
            motion: Motion::Fixed { x: true, y: true, rotation: true },
        }],
        ..setup::Setup::default()
    };
    let phase = Phase {
        name: "fall".to_owned(),
        kind: PhaseKind::Dynamic,
        until: Until { time: Some(0.2), ..Until::default() },
        integration: Integration::Explicit,
        time_step: TimeStep::Given { dt: 1e-4 },
        step_error: None,
        levels: 0,
        damping: Damping::default(),
        remove: Vec::new(),
        fix: Vec::new(),
        release: Vec::new(),
        install: Vec::new(),
        gravity: None,
        gravity_ramp: None,
        removal_ramp: None,
        leavers: None,
        water: None,
        contacts: Vec::new(),
        joints: Vec::new(),
        reduction: None,
        zero_velocities: false,
        zero_displacements: false,
        deform: None,
        max_residual: 0.1,
    };
    let history = History {
        name: "drop".to_owned(),
        gauge: Gauge { field: "block.displacement.y".to_owned(), of: vec![1], ..Gauge::default() },
        every: Every::Time(1e-2),
    };
    let check = Check {
        name: "falls freely at first".to_owned(),
        gauge: Gauge { field: "block.displacement.y".to_owned(), of: vec![1], ..Gauge::default() },
        unit: "m".to_owned(),
        shown: None,
        window: Window::At(0.05),
        expected: Expected::Value(-0.0125),
        relative: Some(1e-9),
        absolute: None,
        known: None,
    };
    Job {
        setup: setup.into(),
        plan: Plan {
            title: "falling".to_owned(),
            phases: vec![phase],
            histories: vec![history],
            ..Plan::default()
        },
        checks: vec![check],
        resolved: "riprap = 1\n".to_owned(),
        manifest: Manifest::default(),
        folder: std::path::PathBuf::new(),
    }
}

fn go(_: &mut Look<'_>) -> Control {
    Control::Continue
}

#[test]
fn a_run_leaves_a_folder_and_its_checks() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("a.run");
    let outcome = run(falling(), &folder, Existing::Refuse, 1, &mut go).unwrap();
    assert_eq!(outcome.ending, Ending::Finished);
    assert_eq!(outcome.checks[0].status, Status::Passed, "{:?}", outcome.checks);
    assert_eq!((outcome.manifest.ended, outcome.manifest.steps), (Ended::Finished, 2000));
    assert_eq!(Manifest::read(&folder).unwrap(), outcome.manifest);
    for file in ["histories.csv", "energy.csv", "checks.jsonl", "scenario.resolved.toml"] {
        assert!(folder.join(file).is_file(), "{file}");
    }
    let again = run(falling(), &folder, Existing::Refuse, 1, &mut go).unwrap_err();
    assert!(matches!(again, JobError::Folder(FolderError::Run { .. })) && !again.is_output());
    let done = resume(&folder, 1, &mut go).unwrap_err();
    assert!(matches!(done, JobError::Ended { .. }), "{done}");
    let alone = watch_only(falling(), 2, &mut go).unwrap();
    assert_eq!(alone.manifest.state_hash, outcome.manifest.state_hash);
}

#[test]
fn a_run_that_died_goes_on_to_the_same_bits() {
    let dir = tempfile::tempdir().unwrap();
    let (whole, died) = (dir.path().join("whole.run"), dir.path().join("died.run"));
    let wanted = run(falling(), &whole, Existing::Refuse, 1, &mut go).unwrap();
    // What is on disk after a kill: the checkpoint of the start and half-written files.
    let mut half = falling();
    half.plan.phases[0].until.time = Some(0.1);
    run(half, &died, Existing::Refuse, 1, &mut go).unwrap();
    for (_, file) in checkpoint::all(&died).unwrap().into_iter().skip(1) {
        std::fs::remove_file(file).unwrap();
    }
    let mut manifest = Manifest::read(&died).unwrap();
    manifest.ended = Ended::Running;
    manifest.write(&died).unwrap();
    let mut start: Checkpoint = checkpoint::latest(&died, KIND).unwrap().value;
    start.snapshot.plan = falling().plan;
    checkpoint::write(&checkpoint::path_for(&died, 0), KIND, &start).unwrap();
    let resumed = resume(&died, 1, &mut go).unwrap();
    assert_eq!(resumed.manifest.state_hash, wanted.manifest.state_hash);
    assert_eq!(resumed.checks, wanted.checks);
    for file in [
        "histories.csv",
        "energy.csv",
        "events.jsonl",
        "checks.jsonl",
        "run.pvd",
        "names.json",
        "conditions.json",
    ] {
        let bytes = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
        assert_eq!(bytes(&whole), bytes(&died), "{file}");
    }
}

#[test]
fn pauses_change_no_bit() {
    let dir = tempfile::tempdir().unwrap();
    let (whole, bits) = (dir.path().join("whole.run"), dir.path().join("bits.run"));
    let wanted = run(falling(), &whole, Existing::Refuse, 1, &mut go).unwrap();
    let mut live = Live::begin(falling(), &bits, Existing::Refuse, 1).unwrap();
    let mut steps = Vec::new();
    for step in [0, 0, 1, 500, 500] {
        let pause = Pause { step: Some(step), time: None };
        assert_eq!(live.advance(pause, &mut go).unwrap(), None);
        steps.push(live.simulation().steps());
    }
    assert_eq!(steps, [0, 0, 1, 500, 500]);
    let left = live.close().unwrap();
    assert_eq!(left.ending, Ending::Stopped);
    let mut live = Live::reopen(&bits, 1).unwrap();
    let pause = Pause { step: None, time: Some(0.15) };
    assert_eq!(live.advance(pause, &mut go).unwrap(), None);
    assert!((live.simulation().time() - 0.15).abs() < 1.1e-4);
    let outcome = live.finish(&mut go).unwrap();
    assert_eq!(outcome.manifest.state_hash, wanted.manifest.state_hash);
    assert_eq!(outcome.checks, wanted.checks);
    for file in ["histories.csv", "energy.csv", "events.jsonl", "run.pvd"] {
        let read = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
        assert!(read(&whole) == read(&bits), "{file} differs");
    }
}

/// Rows that are due at the end alone: where a run was stopped they are there all the same, and are gone once it goes on.
#[test]
fn a_stopped_run_tells_of_its_last_state_and_goes_on_to_the_same_bits() {
    let job = || {
        let mut job = falling();
        job.plan.energy = Some(Every::Never);
        for history in &mut job.plan.histories {
            history.every = Every::Phase;
        }
        job
    };
    let dir = tempfile::tempdir().unwrap();
    let (whole, bits) = (dir.path().join("whole.run"), dir.path().join("bits.run"));
    let wanted = run(job(), &whole, Existing::Refuse, 1, &mut go).unwrap();
    // Looks come by the clock, but the first one after the first step.
    let mut stop = |_: &mut Look<'_>| Control::Stop;
    let stopped = run(job(), &bits, Existing::Refuse, 1, &mut stop).unwrap();
    assert_eq!(stopped.ending, Ending::Stopped);
    let tables = ["histories.csv", "energy.csv"];
    for file in tables {
        let table = Table::read(&bits.join(file)).unwrap();
        let last = |column: usize| table.columns[column].values.last().copied();
        assert_eq!(last(0), Some(stopped.manifest.steps as f64), "{file}");
        assert_eq!(last(1), Some(stopped.manifest.time), "{file}");
    }
    let table = Table::read(&bits.join("energy.csv")).unwrap();
    let row = table.columns[2..].iter().map(|c| c.values.last().copied());
    let terms = stopped.energies.unwrap().terms;
    assert!(row.eq(terms.iter().map(|(_, term)| Some(*term))));
    // A run that is reopened and closed where it was has nothing to add.
    let rows = || tables.map(|file| std::fs::read(bits.join(file)).unwrap());
    let before = rows();
    Live::reopen(&bits, 1).unwrap().close().unwrap();
    assert!(rows() == before);
    let resumed = resume(&bits, 1, &mut go).unwrap();
    assert_eq!(resumed.manifest.state_hash, wanted.manifest.state_hash);
    assert!(rows() == tables.map(|file| std::fs::read(whole.join(file)).unwrap()));
}

#[test]
fn a_run_without_a_place_to_write_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("file");
    std::fs::write(&file, "x").unwrap();
    let wrong = run(falling(), &file.join("a.run"), Existing::Refuse, 1, &mut go).unwrap_err();
    assert!(wrong.is_output(), "{wrong}");
    let none = resume(dir.path(), 1, &mut go).unwrap_err();
    assert!(matches!(none, JobError::Manifest(_)) && !none.is_output());
}

/// A check that names a phase sees the states of that phase only, its first and its last included.
#[test]
fn checks_of_a_phase() {
    use crate::plan::{Part, Reduce};
    let mut job = falling();
    let lasting = |name: &str, time: f64| Phase {
        name: name.to_owned(),
        until: Until { time: Some(time), ..Until::default() },
        ..job.plan.phases[0].clone()
    };
    // It lands after 0.063 s.
    job.plan.phases = vec![lasting("first", 0.05), lasting("second", 0.01)];
    let of = |phase: u32, part: Part, velocity: f64| Check {
        gauge: Gauge { field: "block.velocity.y".to_owned(), of: vec![1], ..Gauge::default() },
        unit: "m/s".to_owned(),
        shown: None,
        window: Window::Phase { phase, part },
        expected: Expected::Value(velocity),
        absolute: Some(1e-9),
        ..job.checks[0].clone()
    };
    job.checks = vec![
        of(0, Part::Start, 0.0),
        of(0, Part::End, -0.5),
        of(0, Part::Whole(Reduce::Min), -0.5),
        of(1, Part::Start, -0.5),
        of(1, Part::Whole(Reduce::Max), -0.5),
        of(1, Part::Whole(Reduce::Range), 0.1),
        of(1, Part::End, -0.6),
        of(1, Part::End, -0.5),
    ];
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("phases.run");
    let outcome = run(job, &folder, Existing::Refuse, 1, &mut go).unwrap();
    let (wrong, right) = outcome.checks.split_last().unwrap();
    assert!(right.iter().all(|c| c.status == Status::Passed), "{right:?}");
    assert_eq!(wrong.status, Status::Failed);
}

/// A pause within a phase has found the forces of its instant: found again after a restart they began with what the first time had left, and
/// a blast that was closed there went on with other bits.
#[cfg(feature = "scenario")]
#[test]
fn a_run_that_is_closed_at_a_pause_goes_on_with_the_same_bits() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let changes = [
        ("phases.0.until.time".to_owned(), "0.1 ms".to_owned()),
        ("outputs.1.history.every".to_owned(), "1 us".to_owned()),
    ];
    let scene = crate::run::scene::Scene::load(&root.join("scenes/spatial/blast.toml"), &changes)
        .unwrap_or_else(|wrong| panic!("{}", wrong.render()));
    let folder = tempfile::tempdir().unwrap();
    let run = |name: &str, pauses: &[u64]| {
        let folder = folder.path().join(name);
        let job = scene.prepare(&scene.plain()).unwrap_or_else(|w| panic!("{}", w.render())).job();
        let mut live = Live::begin(job, &folder, Existing::Refuse, 1).unwrap();
        for step in pauses {
            let pause = Pause { step: Some(*step), time: None };
            assert!(live.advance(pause, &mut |_| Control::Continue).unwrap().is_none());
            live.close().unwrap();
            live = Live::reopen(&folder, 1).unwrap();
        }
        let outcome = live.finish(&mut |_| Control::Continue).unwrap();
        let read = |file: &str| std::fs::read_to_string(folder.join(file)).unwrap_or_default();
        (
            outcome.manifest.state_hash,
            read("histories.csv"),
            read("events.jsonl"),
            read("energy.csv"),
        )
    };
    let whole = run("whole", &[]);
    assert!(whole.1.lines().count() > 20, "{}", whole.1);
    assert_eq!(run("one", &[1]), whole);
    assert_eq!(run("three", &[3, 11, 20]), whole);
}

/// A rank with another model, or that ends, is named, and what was saved before stays whole.
#[test]
fn a_rank_that_differs_or_ends_stops_the_run() {
    let dir = tempfile::tempdir().unwrap();
    let heavier = |rank: usize| {
        let mut job = falling();
        if let (2, Setup::Planar(setup)) = (rank, &mut job.setup) {
            setup.blocks[1].velocity.y = -1e-12;
        }
        job
    };
    let folder = dir.path().join("differs.run");
    let wrong = ranks::run_each(&heavier, &folder, Existing::Refuse, [3, 1], &mut go).unwrap_err();
    let words = wrong.to_string();
    assert!(
        words.starts_with("rank 2 of 3 differs from the others: the state at step 0"),
        "{words}"
    );
    assert!(wrong.ranks().is_some() && !wrong.is_output());
    assert!(!folder.join("checkpoints").read_dir().unwrap().any(|file| file.is_ok()));

    let folder = dir.path().join("gone.run");
    let lead =
        |peers| run_among(falling(), &folder, Existing::Refuse, peers, 1, &mut go).map(|_| ());
    let (led, _) = crate::exec::ranks(2, lead, |peers| {
        let exec = Exec::among(peers, 1).unwrap();
        let mut live = Live::begin_on(falling(), dir.path(), Existing::Refuse, exec).unwrap();
        live.advance(Pause { step: Some(50), time: None }, &mut go).unwrap();
    });
    let words = led.unwrap_err().to_string();
    assert!(words.starts_with("rank 1 of 2 no longer answers"), "{words}");
    assert_eq!(Manifest::read(&folder).unwrap().ended, Ended::Running);
    let done = resume(&folder, 1, &mut go).unwrap();
    assert_eq!(done.ending, Ending::Finished);
    let whole = watch_only(falling(), 1, &mut go).unwrap();
    assert_eq!(done.manifest.state_hash, whole.manifest.state_hash);

    // What rank 0 meets is told, not what the others make of its end.
    let again = run_ranks(falling(), &folder, Existing::Refuse, [3, 1], &mut go).unwrap_err();
    assert!(matches!(again, JobError::Folder(FolderError::Run { .. })), "{again}");
}
