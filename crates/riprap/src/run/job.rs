//! One run with everything around it: the folder, the manifest, the checks, how it ended.
//!
//! [`run`] begins in a new folder, [`resume`] goes on in an old one, [`watch_only`] leaves no files; each advances a
//! [`Live`] run, which can also be advanced bit by bit.

use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use thiserror::Error;

use super::checks::{Check, CheckResult, Watch};
use super::drive::{Control, Drive, DriveError, Ending, Pause, Progress};
use super::engine::{BuildError, Kind};
use super::given_step::{self, TooLong};
use super::plan::Plan;
use super::recorder::{Checkpoint, KIND, RecordError, Recorder};
use super::simulation::{RunError, Simulation, Unconverged};
use crate::exec::{Exec, ExecError};
use crate::model::Setup;
use crate::record::checkpoint::{self, CheckpointError};
use crate::record::folder::{Existing, FolderError};
use crate::record::manifest::{Machine, ManifestError, StageTime, utc};
use crate::record::{Ended, Manifest, OutputError, RunFolder};

/// What is run.
#[derive(Clone, Debug)]
pub struct Job {
    /// The model.
    pub setup: Setup,
    /// The plan.
    pub plan: Plan,
    /// Checks to watch.
    pub checks: Vec<Check>,
    /// The scene with all changes made, as it is written into the folder.
    pub resolved: String,
    /// What the manifest says of the input: scenario, hash, variant, case, overrides, warnings.
    pub manifest: Manifest,
}

/// How a run came out.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub ending: Ending,
    /// The manifest at the end.
    pub manifest: Manifest,
    /// One result a check, in the order of the scene.
    pub checks: Vec<CheckResult>,
    /// Relaxing phases that ended without equilibrium.
    pub unconverged: Vec<Unconverged>,
}

/// Why a run could not be carried out.
#[derive(Debug, Error)]
pub enum JobError {
    /// The folder cannot be used.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// The manifest of a run to go on with.
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    /// No checkpoint to go on from.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
    /// Nothing is left to do.
    #[error("{} has ended already: {ended}", path.display())]
    Ended {
        /// The folder.
        path: PathBuf,
        /// How.
        ended: String,
    },
    /// Writing or reading fields failed.
    #[error(transparent)]
    Drive(#[from] DriveError),
    /// Recording could not start.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The disk.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The engine cannot build the model.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A time step of the scene is too long.
    #[error(transparent)]
    Step(#[from] TooLong),
    /// No threads.
    #[error(transparent)]
    Exec(#[from] ExecError),
}

impl JobError {
    /// Whether results could not be written, as opposed to input that cannot be used.
    #[must_use]
    pub fn is_output(&self) -> bool {
        match self {
            JobError::Output(_)
            | JobError::Folder(FolderError::Output(_))
            | JobError::Drive(DriveError::Output(_) | DriveError::Record(RecordError::Output(_)))
            | JobError::Record(RecordError::Output(_)) => true,
            JobError::Folder(_)
            | JobError::Manifest(_)
            | JobError::Checkpoint(_)
            | JobError::Ended { .. }
            | JobError::Drive(DriveError::Record(RecordError::Field(_)) | DriveError::Field(_))
            | JobError::Record(RecordError::Field(_))
            | JobError::Build(_)
            | JobError::Step(_)
            | JobError::Exec(_) => false,
        }
    }
}

/// Runs a job in `folder`.
///
/// # Errors
/// A folder that `existing` does not allow, the disk, unknown fields.
pub fn run(
    job: Job,
    folder: &Path,
    existing: Existing,
    threads: usize,
    look: &mut dyn FnMut(&Progress) -> Control,
) -> Result<Outcome, JobError> {
    Live::begin(job, folder, existing, threads)?.finish(look)
}

/// Goes on with the run in `folder` from its last good checkpoint.
///
/// # Errors
/// A folder without a run or a checkpoint, a run that has ended, the disk.
pub fn resume(
    folder: &Path,
    threads: usize,
    look: &mut dyn FnMut(&Progress) -> Control,
) -> Result<Outcome, JobError> {
    Live::reopen(folder, threads)?.finish(look)
}

/// Runs a job for its checks alone; nothing is written.
///
/// # Errors
/// Unknown fields.
pub fn watch_only(
    job: Job,
    threads: usize,
    look: &mut dyn FnMut(&Progress) -> Control,
) -> Result<Outcome, JobError> {
    Live::unrecorded(job, threads)?.finish(look)
}

/// A run under way, to be advanced bit by bit.
#[derive(Debug)]
pub struct Live {
    drive: Drive,
    manifest: Manifest,
    ending: Option<Ending>,
}

impl Live {
    /// Begins a job in `folder`.
    ///
    /// # Errors
    /// A folder that `existing` does not allow, the disk, unknown fields.
    pub fn begin(
        job: Job,
        folder: &Path,
        existing: Existing,
        threads: usize,
    ) -> Result<Self, JobError> {
        let exec = Exec::new(threads)?;
        let mut manifest = job.manifest;
        manifest.threads = exec.threads();
        manifest.machine = Machine::this();
        manifest.started = utc(SystemTime::now());
        manifest.title.clone_from(&job.plan.title);
        let kind = Kind::of(&job.setup);
        manifest.fields = kind.fields().iter().map(Into::into).collect();
        manifest.ended = Ended::Running;
        // A model that cannot be built leaves no folder behind.
        let simulation = Simulation::new(job.setup, job.plan, exec)?;
        given_step::check(&simulation)?;
        manifest.sources = simulation.view().sources();
        let folder = RunFolder::create(folder, existing, &manifest)?;
        folder.write_scenario(&job.resolved)?;
        let recorder = Recorder::new(folder, kind, simulation.plan(), None)?;
        let watches: Vec<Watch> = job.checks.into_iter().map(Watch::new).collect();
        let mut live = Self::new(simulation, Some(recorder), watches, manifest)?;
        // Whatever happens from now on, there is something to resume from.
        live.drive.checkpoint()?;
        Ok(live)
    }

    /// Reopens the run in `folder` at its last good checkpoint.
    ///
    /// # Errors
    /// A folder without a run or a checkpoint, a run that has ended, the disk.
    pub fn reopen(folder: &Path, threads: usize) -> Result<Self, JobError> {
        let mut manifest = Manifest::read(folder)?;
        let ended = match manifest.ended {
            Ended::Running | Ended::Interrupted => None,
            Ended::Finished => Some("all its phases are done".to_owned()),
            Ended::Stopped | Ended::Unstable => Some(manifest.message.clone()),
        };
        if let Some(ended) = ended {
            return Err(JobError::Ended {
                path: folder.to_owned(),
                ended,
            });
        }
        let latest = checkpoint::latest::<Checkpoint>(folder, KIND)?;
        let broken = latest
            .broken
            .iter()
            .map(|why| format!("skipped a checkpoint: {why}"));
        manifest.warnings.extend(broken);
        let exec = Exec::new(threads)?;
        manifest.threads = exec.threads();
        let Checkpoint {
            snapshot,
            marks,
            counts,
            watches,
        } = latest.value;
        let folder = RunFolder::reopen(folder, &marks)?;
        manifest.ended = Ended::Running;
        folder.write_manifest(&manifest)?;
        let simulation = Simulation::resume(snapshot, exec);
        let recorder = Recorder::new(folder, simulation.kind(), simulation.plan(), Some(counts))?;
        Self::new(simulation, Some(recorder), watches, manifest)
    }

    /// Begins a job that leaves no files.
    ///
    /// # Errors
    /// Unknown fields.
    pub fn unrecorded(job: Job, threads: usize) -> Result<Self, JobError> {
        let exec = Exec::new(threads)?;
        let simulation = Simulation::new(job.setup, job.plan, exec)?;
        given_step::check(&simulation)?;
        let watches: Vec<Watch> = job.checks.into_iter().map(Watch::new).collect();
        Self::new(simulation, None, watches, job.manifest)
    }

    fn new(
        simulation: Simulation,
        recorder: Option<Recorder>,
        watches: Vec<Watch>,
        manifest: Manifest,
    ) -> Result<Self, JobError> {
        let drive = Drive::new(simulation, recorder, watches).map_err(DriveError::from)?;
        Ok(Self {
            drive,
            manifest,
            ending: None,
        })
    }

    /// The simulation; between two calls of [`Live::advance`] its forces are those of the present positions.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        self.drive.simulation()
    }

    /// How it ended, once it has.
    #[must_use]
    pub fn ending(&self) -> Option<&Ending> {
        self.ending.as_ref()
    }

    /// Goes on to the pause; `None` there, how it ended otherwise. What has ended stays as it is, but one that the
    /// caller stopped goes on.
    ///
    /// # Errors
    /// The disk.
    pub fn advance(
        &mut self,
        pause: Pause,
        look: &mut dyn FnMut(&Progress) -> Control,
    ) -> Result<Option<Ending>, JobError> {
        if let Some(Ending::Finished | Ending::Unstable(_)) = self.ending {
            return Ok(self.ending.clone());
        }
        let begun = Instant::now();
        self.ending = self.drive.advance(pause, look)?;
        self.manifest.wall_time += begun.elapsed().as_secs_f64();
        Ok(self.ending.clone())
    }

    /// Goes on to the end, or until `look` stops it, and closes the books.
    ///
    /// # Errors
    /// The disk.
    pub fn finish(
        mut self,
        look: &mut dyn FnMut(&Progress) -> Control,
    ) -> Result<Outcome, JobError> {
        self.advance(Pause::NEVER, look)?;
        self.close()
    }

    /// Closes the books where they are: a run that has not ended can be resumed.
    ///
    /// # Errors
    /// The disk.
    pub fn close(mut self) -> Result<Outcome, JobError> {
        let ending = match self.ending.take() {
            Some(ending) => ending,
            None => {
                self.drive.checkpoint()?;
                Ending::Stopped
            }
        };
        let mut manifest = self.manifest;
        close(&mut manifest, self.drive.simulation(), &ending);
        let watches = self.drive.watches();
        let result = |watch: &Watch| watch.finish(&manifest.scenario, &manifest.case, false);
        let checks: Vec<CheckResult> = watches.iter().map(result).collect();
        if let Some(recorder) = self.drive.recorder() {
            if !checks.is_empty() {
                let lines: Result<Vec<String>, _> =
                    checks.iter().map(serde_json::to_string).collect();
                let text = lines.unwrap_or_default().join("\n") + "\n";
                recorder
                    .folder
                    .write_file("checks.jsonl", text.as_bytes())?;
            }
            recorder.folder.write_manifest(&manifest)?;
        }
        let unconverged = self.drive.simulation().cursor().unconverged.clone();
        Ok(Outcome {
            ending,
            manifest,
            checks,
            unconverged,
        })
    }
}

/// Writes into the manifest how the run ended.
fn close(manifest: &mut Manifest, simulation: &Simulation, ending: &Ending) {
    let view = simulation.view();
    (manifest.ended, manifest.message) = match ending {
        Ending::Finished => (Ended::Finished, String::new()),
        Ending::Stopped => (
            Ended::Interrupted,
            "stopped by the user; it can be resumed".to_owned(),
        ),
        Ending::Unstable(error) => (Ended::Unstable, RunError::to_string(error)),
    };
    for note in &simulation.cursor().unconverged {
        let text = note.to_string();
        if !manifest.warnings.contains(&text) {
            manifest.warnings.push(text);
        }
    }
    manifest.dt = view.last_dt();
    manifest.steps = view.step();
    manifest.time = view.time();
    manifest.state_hash = simulation.engine().hash();
    let stage = |(name, seconds): (String, f64)| StageTime {
        name,
        seconds,
        calls: view.step(),
    };
    manifest.profile = simulation
        .engine()
        .profile()
        .seconds()
        .into_iter()
        .map(stage)
        .collect();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec2;
    use crate::laws::parameters::{ContactLaw, FrictionLaw, NormalLaw};
    use crate::planar::setup::{self, BlockSpec, Interface, Motion, Support};
    use crate::run::checks::{Expected, Status, Window};
    use crate::run::plan::{Damping, Every, Gauge, History, Phase, PhaseKind, TimeStep, Until};

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
            normal_stiffness: 1e8,
            shear_stiffness: 5e7,
            friction: 0.5,
            cohesion: 0.0,
            friction_law: FrictionLaw::ShearSpring,
            damping_ratio: 0.2,
        };
        let setup = setup::Setup {
            gravity: [0.0, -10.0],
            materials: vec!["rock".to_owned()],
            blocks: vec![square("base", 0.0), square("top", 1.02)],
            interfaces: vec![Interface {
                name: "default".to_owned(),
                contact,
                bond: None,
            }],
            pair_table: vec![0],
            supports: vec![Support {
                blocks: vec![0],
                motion: Motion::Fixed {
                    x: true,
                    y: true,
                    rotation: true,
                },
            }],
            ..setup::Setup::default()
        };
        let phase = Phase {
            name: "fall".to_owned(),
            kind: PhaseKind::Dynamic,
            until: Until {
                time: Some(0.2),
                ..Until::default()
            },
            time_step: TimeStep::Given { dt: 1e-4 },
            damping: Damping::default(),
            remove: Vec::new(),
            fix: Vec::new(),
            release: Vec::new(),
            gravity: None,
            gravity_ramp: None,
            contacts: Vec::new(),
            joints: Vec::new(),
            zero_velocities: false,
            zero_displacements: false,
            deform: None,
        };
        let history = History {
            name: "drop".to_owned(),
            gauge: Gauge {
                field: "block.displacement.y".to_owned(),
                of: vec![1],
                ..Gauge::default()
            },
            every: Every::Time(1e-2),
        };
        let check = Check {
            name: "falls freely at first".to_owned(),
            gauge: Gauge {
                field: "block.displacement.y".to_owned(),
                of: vec![1],
                ..Gauge::default()
            },
            unit: "m".to_owned(),
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
        }
    }

    fn go(_: &Progress) -> Control {
        Control::Continue
    }

    #[test]
    fn a_run_leaves_a_folder_and_its_checks() {
        let dir = tempfile::tempdir().unwrap();
        let folder = dir.path().join("a.run");
        let outcome = run(falling(), &folder, Existing::Refuse, 1, &mut go).unwrap();
        assert_eq!(outcome.ending, Ending::Finished);
        assert_eq!(
            outcome.checks[0].status,
            Status::Passed,
            "{:?}",
            outcome.checks
        );
        assert_eq!(
            (outcome.manifest.ended, outcome.manifest.steps),
            (Ended::Finished, 2000)
        );
        assert_eq!(Manifest::read(&folder).unwrap(), outcome.manifest);
        for file in [
            "histories.csv",
            "energy.csv",
            "checks.jsonl",
            "scenario.resolved.toml",
        ] {
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
            let pause = Pause {
                step: Some(step),
                time: None,
            };
            assert_eq!(live.advance(pause, &mut go).unwrap(), None);
            steps.push(live.simulation().steps());
        }
        assert_eq!(steps, [0, 0, 1, 500, 500]);
        let left = live.close().unwrap();
        assert_eq!(left.ending, Ending::Stopped);
        let mut live = Live::reopen(&bits, 1).unwrap();
        let pause = Pause {
            step: None,
            time: Some(0.15),
        };
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
}
