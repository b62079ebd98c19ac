//! One run with everything around it: the folder, the manifest, the checks, how it ended.
//!
//! [`run`] begins in a new folder, [`resume`] goes on in an old one, [`watch_only`] leaves no files; each advances a
//! [`Live`] run, which can also be advanced bit by bit.

mod ranks;
mod steer;
mod still;
#[cfg(test)]
mod tests;
mod times;

pub use ranks::{resume_among, resume_ranks, run_among, run_ranks};
pub(super) use still::picture;
pub use still::preview;

use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use thiserror::Error;

use super::checks::{CheckResult, Watch};
use super::drive::{Control, Drive, DriveError, Ending, Look, Pause};
use super::engine::{BuildError, Kind};
use super::given_step::{self, RefusedStep};
use super::origin::Origin;
use super::recorder::{Checkpoint, KIND, RecordError, Recorder};
use super::simulation::{PhaseEnd, RunError, Simulation, Unconverged};
use crate::exec::{Exec, ExecError};
use crate::ledger::{Balance, COLUMNS};
use crate::peers::Traffic;
use crate::plan::{Check, Plan};
use crate::record::checkpoint::{self, CheckpointError};
use crate::record::folder::{Existing, FolderError};
use crate::record::manifest::{Machine, ManifestError, utc};
use crate::record::{Ended, Manifest, OutputError, RunFolder};
use crate::setup::Setup;

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
    /// The folder from which relative paths in the scene are seen.
    pub folder: PathBuf,
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
    /// What should be known besides the results, in words.
    pub warnings: Vec<String>,
    /// How the phases have ended.
    pub ends: Vec<PhaseEnd>,
    /// The ledger where a run stopped before its end, if its forces are known there.
    pub energies: Option<Energies>,
    /// What this rank has sent to others, where there are any.
    pub sent: Option<Sent>,
}

/// What a rank has sent since it began or went on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent {
    /// Messages and bytes.
    pub traffic: Traffic,
    /// Steps.
    pub steps: u64,
    /// Wall time, s.
    pub wall_time: f64,
}

/// The ledger at one state.
#[derive(Clone, Debug, PartialEq)]
pub struct Energies {
    /// Model time, s.
    pub time: f64,
    /// Unit of the terms.
    pub unit: &'static str,
    /// Terms with their names, in the order of the ledger.
    pub terms: Vec<(&'static str, f64)>,
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
    #[error("{} has already ended: {ended}", path.display())]
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
    /// A step that the scene asks for cannot be made.
    #[error(transparent)]
    Step(#[from] RefusedStep),
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
            | JobError::Drive(
                DriveError::Record(RecordError::Field(_))
                | DriveError::Field(_)
                | DriveError::Steer(_)
                | DriveError::Change(_)
                | DriveError::Law(_)
                | DriveError::Ranks(_),
            )
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
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
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
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
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
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
) -> Result<Outcome, JobError> {
    Live::unrecorded(job, threads)?.finish(look)
}

/// A run under way, to be advanced bit by bit.
#[derive(Debug)]
pub struct Live {
    drive: Drive,
    manifest: Manifest,
    ending: Option<Ending>,
    notes: Vec<String>,
    /// Steps and wall time (s) of the run when this began.
    begun: (u64, f64),
    /// The scene, for what code changes.
    #[cfg(feature = "scenario")]
    scene: Option<super::change::SceneText>,
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
        Self::begin_on(job, folder, existing, Exec::new(threads)?)
    }

    /// As [`Live::begin`] on these threads, as one of several ranks where there are others; rank 0 alone writes into `folder`.
    ///
    /// # Errors
    /// As [`Live::begin`]; ranks that differ.
    pub fn begin_on(
        job: Job,
        folder: &Path,
        existing: Existing,
        exec: Exec,
    ) -> Result<Self, JobError> {
        ranks::greet(&exec, &job)?;
        let silent = ranks::follows(&exec);
        #[cfg(feature = "scenario")]
        let scene = super::change::SceneText::of(&job);
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
        let folder = match silent {
            true => RunFolder::silent(Vec::new()),
            false => RunFolder::create(folder, existing, &manifest)?,
        };
        folder.write_scenario(&job.resolved)?;
        let origin = Origin::new(&manifest, &job.resolved);
        let recorder = Recorder::new(folder, origin, kind, simulation.plan(), None)?;
        let watches: Vec<Watch> = job.checks.into_iter().map(Watch::new).collect();
        let mut live = Self::new(simulation, Some(recorder), watches, manifest)?;
        #[cfg(feature = "scenario")]
        {
            live.scene = Some(scene);
        }
        // Whatever happens from now on, there is something to resume from.
        live.drive.checkpoint()?;
        Ok(live)
    }

    /// Reopens the run in `folder` at its last good checkpoint.
    ///
    /// # Errors
    /// A folder without a run or a checkpoint, a run that has ended, the disk.
    pub fn reopen(folder: &Path, threads: usize) -> Result<Self, JobError> {
        Self::reopen_on(folder, Exec::new(threads)?)
    }

    /// As [`Live::reopen`] on these threads, as one of several ranks where there are others; rank 0 alone reads and writes `folder`.
    ///
    /// # Errors
    /// As [`Live::reopen`]; ranks that differ.
    pub fn reopen_on(folder: &Path, exec: Exec) -> Result<Self, JobError> {
        if ranks::follows(&exec) {
            return Self::follow(exec);
        }
        let mut manifest = Manifest::read(folder)?;
        let ended = match manifest.ended {
            Ended::Running | Ended::Interrupted => None,
            Ended::Finished => Some("all phases are complete".to_owned()),
            Ended::Stopped | Ended::Unstable => Some(manifest.message.clone()),
        };
        if let Some(ended) = ended {
            return Err(JobError::Ended { path: folder.to_owned(), ended });
        }
        let admit = |path: &Path, found: &Checkpoint| {
            found.origin.admit(path, &manifest)?;
            // Its sum says that it is as it was written, not who wrote it.
            let sound = found.snapshot.sound();
            sound.map_err(|reason| CheckpointError::Decode { path: path.to_owned(), reason })
        };
        let latest = checkpoint::latest_of(folder, KIND, admit)?;
        let broken = latest.broken.iter();
        let mut notes: Vec<String> =
            broken.map(|why| format!("skipped a checkpoint: {why}")).collect();
        manifest.threads = exec.threads();
        let found = ranks::hand_out(&exec, latest.value)?;
        let Checkpoint { origin, snapshot, marks, counts, watches } = found;
        notes.extend(origin.edits(folder, &manifest));
        let others: Vec<&Path> = latest.broken.iter().filter_map(|e| e.of_another()).collect();
        let (folder, aside) = RunFolder::reopen_beside(folder, &marks, &others)?;
        notes.extend(
            (aside.iter()).map(|name| format!("the skipped file is kept as {}", name.display())),
        );
        for note in &notes {
            if !manifest.warnings.contains(note) {
                manifest.warnings.push(note.clone());
            }
        }
        manifest.ended = Ended::Running;
        folder.write_manifest(&manifest)?;
        let simulation = Simulation::resume(snapshot, exec);
        let (kind, plan) = (simulation.kind(), simulation.plan());
        let recorder = Recorder::new(folder, origin, kind, plan, Some(counts))?;
        let mut live = Self::new(simulation, Some(recorder), watches, manifest)?;
        live.notes = notes;
        Ok(live)
    }

    /// What was found when the run was reopened: checkpoints that were skipped, what was edited since. The manifest has it too.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Begins a job that leaves no files.
    ///
    /// # Errors
    /// Unknown fields.
    /// # Examples
    ///
    /// A scene run to its end, with its checks.
    ///
    /// ```
    /// use riprap::run::checks::Status;
    /// use riprap::run::drive::Control;
    /// use riprap::run::job::Live;
    /// use riprap::run::scene::Scene;
    /// use riprap::scenario::Source;
    ///
    /// // A stone on a slope of 30 degrees, friction angle 40 degrees.
    /// # let text = r#"
    /// # riprap = 1
    /// # title = "a stone on a slope"
    /// # [space.planar]
    /// # gravity = ["0 m/s2", "-9.81 m/s2"]
    /// # tilt = "30 deg"
    /// # [materials.rock]
    /// # density = "2500 kg/m3"
    /// # [interfaces.default]
    /// # normal_stiffness = "1 GPa/m"
    /// # friction_angle = "40 deg"
    /// # [[blocks]]
    /// # name = "slope"
    /// # material = "rock"
    /// # rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
    /// # [[blocks]]
    /// # name = "stone"
    /// # material = "rock"
    /// # rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
    /// # [[supports]]
    /// # on = { block = "slope" }
    /// # fixed = {}
    /// # [[phases]]
    /// # name = "settle"
    /// # kind = "static"
    /// # until = { unbalanced = 1e-6, steps = 50000 }
    /// # [[checks]]
    /// # name = "the stone stays"
    /// # field = "block.speed"
    /// # of = "stone"
    /// # at = "end"
    /// # between = ["0 m/s", "1 mm/s"]
    /// # "#;
    /// let scene = Scene::parse(Source::new("slope.toml", text), ".".into(), &[])?;
    /// let job = scene.prepare(&scene.plain())?.job();
    /// let outcome = Live::unrecorded(job, 1)?.finish(&mut |_| Control::Continue)?;
    /// assert!(outcome.checks.iter().all(|check| check.status == Status::Passed));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn unrecorded(job: Job, threads: usize) -> Result<Self, JobError> {
        let exec = Exec::new(threads)?;
        #[cfg(feature = "scenario")]
        let scene = super::change::SceneText::of(&job);
        let simulation = Simulation::new(job.setup, job.plan, exec)?;
        given_step::check(&simulation)?;
        let watches: Vec<Watch> = job.checks.into_iter().map(Watch::new).collect();
        let live = Self::new(simulation, None, watches, job.manifest)?;
        #[cfg(feature = "scenario")]
        let live = Self { scene: Some(scene), ..live };
        Ok(live)
    }

    fn new(
        simulation: Simulation,
        recorder: Option<Recorder>,
        watches: Vec<Watch>,
        manifest: Manifest,
    ) -> Result<Self, JobError> {
        let drive = Drive::new(simulation, recorder, watches).map_err(DriveError::from)?;
        let begun = (drive.simulation().steps(), manifest.wall_time);
        Ok(Self {
            drive,
            manifest,
            ending: None,
            notes: Vec::new(),
            begun,
            #[cfg(feature = "scenario")]
            scene: None,
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
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Option<Ending>, JobError> {
        if let Some(Ending::Finished | Ending::Unstable(_)) = self.ending {
            return Ok(self.ending.clone());
        }
        let begun = Instant::now();
        self.ending = self.drive.advance(pause, look)?;
        self.manifest.wall_time += begun.elapsed().as_secs_f64();
        Ok(self.ending.clone())
    }

    /// Goes on to the end, or until `look` stops it, and closes the ledger.
    ///
    /// # Errors
    /// The disk.
    pub fn finish(
        mut self,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Outcome, JobError> {
        self.advance(Pause::NEVER, look)?;
        self.close()
    }

    /// Closes the ledger where it is: a run that has not ended can be resumed.
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
        // Code may have charged holes.
        for (said, is) in manifest.sources.iter_mut().zip(self.drive.simulation().view().sources())
        {
            (said.mass, said.delay, said.charge_volume) = (is.mass, is.delay, is.charge_volume);
        }
        close(&mut manifest, self.drive.simulation(), &ending);
        let watches = self.drive.watches();
        let result = |watch: &Watch| watch.finish(&manifest.scenario, &manifest.case, false);
        let mut checks: Vec<CheckResult> = watches.iter().map(result).collect();
        for check in &mut checks {
            match ending {
                Ending::Finished => {}
                Ending::Stopped => check.left_open(manifest.time),
                Ending::Unstable(_) => check.cut_short(manifest.time),
            }
        }
        if let Some(recorder) = self.drive.recorder() {
            if !checks.is_empty() {
                let lines: Result<Vec<String>, _> =
                    checks.iter().map(serde_json::to_string).collect();
                let text = lines.unwrap_or_default().join("\n") + "\n";
                recorder.folder.write_file("checks.jsonl", text.as_bytes())?;
            }
            recorder.folder.write_manifest(&manifest)?;
        }
        let simulation = self.drive.simulation();
        let (unconverged, warnings, ends) = (
            simulation.cursor().unconverged.clone(),
            simulation.warnings(),
            simulation.cursor().ends.clone(),
        );
        let balance = self.drive.stopped(&ending)?;
        let simulation = self.drive.simulation();
        let peers = simulation.engine().exec().peers();
        Ok(Outcome {
            sent: peers.map(|peers| Sent {
                traffic: peers.traffic(),
                steps: manifest.steps - self.begun.0,
                wall_time: manifest.wall_time - self.begun.1,
            }),
            energies: balance.map(|balance| energies(simulation, &balance)),
            ending,
            checks,
            unconverged,
            warnings,
            ends,
            manifest,
        })
    }
}

/// The ledger where a run was stopped.
fn energies(simulation: &Simulation, balance: &Balance) -> Energies {
    let terms = COLUMNS.iter().map(|(name, get)| (*name, get(balance)));
    Energies {
        time: simulation.time(),
        unit: simulation.kind().energy_unit(),
        terms: terms.collect(),
    }
}

/// Writes into the manifest how the run ended.
fn close(manifest: &mut Manifest, simulation: &Simulation, ending: &Ending) {
    let view = simulation.view();
    (manifest.ended, manifest.message) = match ending {
        Ending::Finished => (Ended::Finished, String::new()),
        Ending::Stopped => {
            (Ended::Interrupted, "stopped by the user; the run can be resumed".to_owned())
        }
        Ending::Unstable(error) => (Ended::Unstable, RunError::to_string(error)),
    };
    for text in simulation.warnings() {
        if !manifest.warnings.contains(&text) {
            manifest.warnings.push(text);
        }
    }
    manifest.works = view.works();
    manifest.gas = view.gas();
    manifest.dt = view.last_dt();
    manifest.steps = view.step();
    manifest.time = view.time();
    manifest.state_hash = simulation.engine().hash();
    manifest.profile = times::stages(simulation.engine(), view.step());
    manifest.pooled_time = simulation.engine().exec().pooled().as_secs_f64();
}
