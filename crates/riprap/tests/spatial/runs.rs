//! The spatial engine through the run loop: phases, histories, frames, checkpoints, run folders.

use std::path::Path;

use riprap::Vec3;
use riprap::plan::{Check, Expected, Window};
use riprap::plan::{
    Damping, Deforming, Every, Gauge, History, Integration, Phase, PhaseKind, Plan, Relaxation,
    Relaxing, TimeStep, Until,
};
use riprap::record::folder::Existing;
use riprap::record::table::Table;
use riprap::record::{Manifest, vtu};
use riprap::run::checks::Status;
use riprap::run::drive::{Control, Ending, Look};
use riprap::run::job::{self, Job};
use riprap::spatial::setup::deform::Strain;
use riprap::spatial::setup::{Boundary, BoundaryKind, FaceSet, Setup};

use crate::spatial::deform::deformable;
use crate::spatial::rock::{elastic, lattice, rock};

fn gauge(field: &str, of: &[u32], at: Option<[f64; 3]>) -> Gauge {
    Gauge { field: field.to_owned(), of: of.to_vec(), at, ..Gauge::default() }
}

/// A column of three cubes on a held face that settles under its weight.
fn column() -> Job {
    column_of(|setup| setup)
}

/// The column of a changed model.
fn column_of(change: impl Fn(Setup) -> Setup) -> Job {
    let mut setup = rock(lattice([1, 1, 3], 1.0), elastic());
    setup.gravity = Vec3::new(0.0, 0.0, -10.0);
    setup.boundaries = vec![Boundary {
        name: "floor".to_owned(),
        on: FaceSet::Plane { normal: -Vec3::Z, offset: 0.0 },
        kind: BoundaryKind::Held { normal: true, shear: true },
        in_situ: false,
    }];
    let phase = Phase {
        name: "settle".to_owned(),
        kind: PhaseKind::Static,
        until: Until { unbalanced: Some(1e-9), time: Some(1.0), ..Until::default() },
        integration: Integration::Explicit,
        time_step: TimeStep::Auto { safety: 0.5 },
        damping: Damping::default(),
        remove: Vec::new(),
        fix: Vec::new(),
        release: Vec::new(),
        install: Vec::new(),
        gravity: None,
        step_error: None,
        levels: 0,
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
    // M = 21.6 GPa: the half block under the lowest centroid carries 3 blocks, then whole ones 2 and 1.
    let weight = 2400.0 * 10.0;
    let settled = -weight * (1.5 + 2.0 + 1.0) / 21.6e9;
    let check = Check {
        name: "settlement of the top block".to_owned(),
        gauge: gauge("block.displacement.z", &[2], None),
        unit: "m".to_owned(),
        shown: None,
        window: Window::End,
        expected: Expected::Value(settled),
        relative: Some(1e-6),
        absolute: None,
        known: None,
    };
    let history = History {
        name: "top".to_owned(),
        gauge: gauge("block.displacement.z", &[], Some([0.5, 0.5, 2.7])),
        every: Every::Steps(1),
    };
    Job {
        setup: change(setup).into(),
        plan: Plan {
            title: "column".to_owned(),
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
fn a_column_settles_and_leaves_a_folder() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("column.run");
    let outcome = job::run(column(), &folder, Existing::Refuse, 1, &mut go).unwrap();
    assert_eq!(outcome.ending, Ending::Finished);
    let check = &outcome.checks[0];
    assert_eq!(check.status, Status::Passed, "{check:?}");
    assert!(outcome.manifest.time < 1.0, "settled: {outcome:?}");

    let table = Table::read(&folder.join("histories.csv")).unwrap();
    let top = &table.column("top").unwrap().values;
    assert_eq!(top.last().copied(), check.measured);

    let frames = vtu::read_pvd(&folder.join("run.pvd")).unwrap();
    let last = vtu::read_frame(&folder.join(&frames.last().unwrap().file), None).unwrap();
    assert_eq!((last.blocks(), last.points.len()), (3, 24));
    let stress = last.column("sigma1_compressive").unwrap();
    // Averages: the block carries half its weight in the middle.
    for (block, above) in [(0, 2.5), (1, 1.5), (2, 0.5)] {
        let expected = 2400.0 * 10.0 * above;
        assert!((stress.data[block] / expected - 1.0).abs() < 1e-6, "{stress:?}");
    }
}

#[test]
fn a_spatial_run_that_was_stopped_ends_in_the_same_bits() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| Path::join(dir.path(), name);
    let mut long = column();
    // Half a second and more: it must not be over before the second look.
    let steps = 300_000;
    long.plan.phases[0].until = Until { steps: Some(steps), ..Until::default() };
    long.plan.histories.clear();
    let whole = job::run(long.clone(), &at("whole"), Existing::Refuse, 1, &mut go).unwrap();
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
    let half = job::run(long, &at("half"), Existing::Refuse, 1, &mut stop).unwrap();
    assert_eq!(half.ending, Ending::Stopped);
    let resumed = job::resume(&at("half"), 2, &mut go).unwrap();
    assert_eq!(resumed.manifest.steps, steps);
    assert_eq!(whole.manifest.state_hash, resumed.manifest.state_hash);
    assert_eq!(whole.checks, resumed.checks);
}

#[test]
fn a_static_phase_without_equilibrium_says_so() {
    let mut job = column_of(|setup| deformable(setup, Strain::Small, 0.01));
    job.checks.clear();
    let phase = &mut job.plan.phases[0];
    phase.until.time = None;
    phase.deform = Some(Deforming {
        breaking: true,
        strain: None,
        relax: Some(Relaxing {
            tolerance: 1e-9,
            load_steps: 1,
            iterations: 50,
            relaxation: Relaxation::default(),
        }),
        cut: None,
    });
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("column.run");
    let outcome = job::run(job, &folder, Existing::Refuse, 1, &mut go).unwrap();
    assert_eq!(outcome.ending, Ending::Finished);
    let [note] = &outcome.unconverged[..] else {
        panic!("{:?}", outcome.unconverged);
    };
    assert_eq!((note.phase.as_str(), note.iterations), ("settle", 50));
    assert!(note.ratio > 1e-9);
    assert_eq!(outcome.manifest.warnings, vec![note.to_string()]);
    let events = std::fs::read_to_string(folder.join("events.jsonl")).unwrap();
    assert!(events.contains("\"not_converged\""), "{events}");
}
