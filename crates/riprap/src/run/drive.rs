//! Drives a simulation to its end: records, watches checks, reports progress, can be stopped.

mod look;
mod order;
mod repeat;

use std::time::{Duration, Instant};

use look::Clock;
pub use look::{Look, Measured, Progress};
use order::Order;

use thiserror::Error;

use super::checks::Watch;
use super::engine::Reading;
use super::engine::steer::{SteerError, Steered};
use super::recorder::{RecordError, Recorded, Recorder};
use super::simulation::{ChangeError, ContactLaw, RunError, Simulation, Snapshot, Stage};
use crate::ledger::{Balance, COLUMNS};
use crate::peers::Trouble;
use crate::plan::Window;
use crate::record::checkpoint::Packing;
use crate::record::{FieldError, OutputError};

/// What the caller wants after a look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// Go on.
    Continue,
    /// Stop cleanly with a checkpoint.
    Stop,
}

impl Control {
    /// Stops where somebody wants to.
    #[must_use]
    pub fn stop_if(asked: bool) -> Self {
        if asked { Self::Stop } else { Self::Continue }
    }
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// All phases are done.
    Finished,
    /// The caller stopped it.
    Stopped,
    /// The physics stopped it.
    Unstable(RunError),
}

/// Why a run could not be carried out.
#[derive(Debug, Error)]
pub enum DriveError {
    /// Something could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Recording could not start.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// A check asks for a field that is not there.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// A load or a support that cannot be steered.
    #[error(transparent)]
    Steer(#[from] SteerError),
    /// What code wants to change.
    #[error(transparent)]
    Change(#[from] ChangeError),
    /// A law of code has failed.
    #[error("{0}; the run can be resumed from its checkpoint")]
    Law(Box<RunError>),
    /// The ranks cannot go on together.
    #[error(transparent)]
    Ranks(#[from] Trouble),
}

/// Wall time between two checkpoints besides those that the scene asks for; longer where writing one takes so long that
/// it would cost more than a run can afford.
const AUTOSAVE: Duration = Duration::from_secs(30);

/// A check with its field.
#[derive(Debug)]
struct Watched {
    watch: Watch,
    reading: Reading,
    /// For costly fields over an interval: model time between two readings, s.
    rhythm: f64,
}

impl Watched {
    /// Feeds the value at the present state if it can matter: the last one of the run, of its phase.
    fn look(&mut self, simulation: &Simulation, last: bool, phase_ends: bool) {
        if self.is_due(simulation, last, phase_ends) {
            let view = simulation.view();
            let time = view.time();
            self.watch.observe(time, self.reading.value(&view));
            self.watch.next = time + self.rhythm;
        }
    }

    /// Whether the value at the present state can matter.
    fn is_due(&self, simulation: &Simulation, mut last: bool, phase_ends: bool) -> bool {
        let window = self.watch.check().window;
        let mut first = simulation.steps() == 0;
        if let Some(phase) = window.phase() {
            if simulation.cursor().phase != phase as usize {
                return false;
            }
            // A phase has a start and an end of its own: its first state is the first that is looked at.
            (first, last) = (true, phase_ends);
        }
        let (time, dt) = (simulation.time(), simulation.dt());
        // Of a relaxing phase only equilibria count.
        let (relaxes, settled) = (simulation.relaxes(), simulation.settled());
        let near = match window.within() {
            Window::Start => first,
            Window::End | Window::Phase { .. } => last,
            Window::At(_) | Window::Over { .. } if relaxes => last || settled,
            // One state on either side of the instant is enough to interpolate, and the step may change in between.
            Window::At(at) => last || (time - at).abs() <= 1.5 * dt,
            Window::Over { .. } => last || time >= self.watch.next,
        };
        near && self.watch.wants(time)
    }
}

/// Where to pause: at the first state that has come so far. The steps are those of a run without pauses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pause {
    /// Step count since the start of the run.
    pub step: Option<u64>,
    /// Model time since the start of the run, s.
    pub time: Option<f64>,
}

impl Pause {
    /// To the end.
    pub const NEVER: Self = Self { step: None, time: None };

    fn reached(&self, simulation: &Simulation) -> bool {
        // Times are sums of steps: without it a pause at a whole number of steps could come one step late.
        let early = 1e-9 * simulation.dt();
        self.step.is_some_and(|n| simulation.steps() >= n)
            || self.time.is_some_and(|t| simulation.time() >= t - early)
    }
}

/// What a checkpoint of a pause holds: everything as it was before the forces of that instant were found and anything of it was recorded.
#[derive(Debug)]
struct Paused {
    snapshot: Snapshot,
    watches: Vec<Watch>,
    recorded: Option<Recorded>,
}

/// A simulation under way, with its recorder and its checks.
#[derive(Debug)]
pub struct Drive {
    simulation: Simulation,
    recorder: Option<Recorder>,
    watched: Vec<Watched>,
    clock: Clock,
    saved: Instant,
    /// What the last checkpoint by the clock took.
    saving: Duration,
    /// Set during a pause: the present state has been prepared, looked at and recorded.
    standing: bool,
    /// During a pause: the state before its forces were found. A run goes on from it with the same bits; from the prepared one it would not,
    /// because forces that are found a second time at one instant begin with what the first time left.
    paused: Option<Box<Paused>>,
    /// Events of the present instant have been recorded: they come again with forces that are found again.
    told: bool,
    keeper: repeat::Keeper,
}

impl Drive {
    /// Without a recorder nothing is written.
    ///
    /// # Errors
    /// Checks of fields that do not exist.
    pub fn new(
        simulation: Simulation,
        recorder: Option<Recorder>,
        watches: Vec<Watch>,
    ) -> Result<Self, FieldError> {
        let watched = watch_list(&simulation, watches)?;
        let clock = Clock::new(simulation.steps());
        Ok(Self {
            simulation,
            recorder,
            watched,
            clock,
            saved: Instant::now(),
            saving: Duration::ZERO,
            standing: false,
            paused: None,
            told: false,
            keeper: repeat::Keeper::default(),
        })
    }

    /// The simulation; during a pause its forces are those of the present positions.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// The stable time step of the present contacts, s; infinite where nothing bounds it.
    pub(super) fn stable(&mut self) -> f64 {
        self.simulation.stable().dt
    }

    /// Gives a load or a support that the scene names another value from the present instant on; an event of the run says so.
    ///
    /// # Errors
    /// The name or the value ([`SteerError`]), the disk.
    pub fn steer(&mut self, name: &str, to: Steered) -> Result<(), DriveError> {
        self.simulation.steer(name, to)?;
        let (step, time) = (self.simulation.steps(), self.simulation.time());
        if let Some(recorder) = &mut self.recorder {
            let mut event = serde_json::json!({
                "step": step, "time": time, "event": "steered", "name": name,
            });
            match to {
                Steered::Factor(factor) => event["factor"] = factor.into(),
                Steered::Velocity(velocity) => event["velocity"] = velocity.to_vec().into(),
            }
            recorder.folder.event(&event)?;
        }
        // The present forces are those of the value before: they are found again from where they were found first.
        if let Some(mut paused) = self.paused.take() {
            paused.snapshot.steer(name, to)?;
            self.simulation.restore(paused.snapshot);
            self.paused = Some(self.pause());
            self.told = true;
        }
        self.standing = false;
        Ok(())
    }

    /// Edits the simulation at the present instant; an event of the run says what was edited. Where it fails everything is as it was.
    ///
    /// # Errors
    /// What the edit says, the disk.
    pub(super) fn edit(
        &mut self,
        mut event: serde_json::Value,
        edit: impl Fn(&mut Simulation) -> Result<(), ChangeError>,
    ) -> Result<(), DriveError> {
        event["step"] = self.simulation.steps().into();
        event["time"] = self.simulation.time().into();
        // The present forces are those before the edit: they are found again from where they were found first.
        let found = self.paused.take();
        let (held, before) = match found {
            Some(paused) => (true, paused.snapshot),
            None => (false, self.simulation.snapshot()),
        };
        if held {
            self.simulation.restore(before.clone());
        }
        let edited = edit(&mut self.simulation);
        if edited.is_err() {
            self.simulation.restore(before);
        } else if let Some(recorder) = &mut self.recorder {
            recorder.folder.event(&event)?;
        }
        if held {
            self.paused = Some(self.pause());
            self.told = true;
        }
        self.standing = false;
        Ok(edited?)
    }

    /// Gives the function of a law of code, or takes it away.
    pub(super) fn set_law(
        &mut self,
        name: &str,
        law: Option<Box<dyn ContactLaw>>,
    ) -> Result<(), DriveError> {
        match law {
            Some(law) => Ok(self.simulation.attach_law(name, law)?),
            None => {
                self.simulation.detach_law(name);
                Ok(())
            }
        }
    }

    /// The simulation alone.
    #[must_use]
    pub fn into_simulation(self) -> Simulation {
        self.simulation
    }

    /// The recorder.
    pub fn recorder(&mut self) -> Option<&mut Recorder> {
        self.recorder.as_mut()
    }

    /// The checks as they stand.
    #[must_use]
    pub fn watches(&self) -> Vec<Watch> {
        self.watched.iter().map(|w| w.watch.clone()).collect()
    }

    /// Writes a checkpoint, if there is a recorder.
    ///
    /// # Errors
    /// The disk; ranks that do not agree.
    pub fn checkpoint(&mut self) -> Result<(), DriveError> {
        self.save(Packing::Small)
    }

    fn save(&mut self, packing: Packing) -> Result<(), DriveError> {
        self.simulation.settle();
        self.agree()?;
        let Some(recorder) = &mut self.recorder else {
            return Ok(());
        };
        if let Some(Paused { snapshot, watches, recorded: Some(recorded) }) = self.paused.as_deref()
        {
            return Ok(recorder.checkpoint(snapshot.as_ref(), watches, recorded, packing)?);
        }
        let watches: Vec<Watch> = self.watched.iter().map(|w| w.watch.clone()).collect();
        let recorded = recorder.recorded(self.simulation.steps());
        Ok(recorder.checkpoint(self.simulation.snapshot_ref(), &watches, &recorded, packing)?)
    }

    fn pause(&self) -> Box<Paused> {
        let step = self.simulation.steps();
        Box::new(Paused {
            snapshot: self.simulation.snapshot(),
            watches: self.watches(),
            recorded: self.recorder.as_ref().map(|recorder| recorder.recorded(step)),
        })
    }

    /// Goes on to the pause (then `None`), to the end of the plan, until stopped, or until the physics gives up.
    ///
    /// `look` is called after the first step, about ten times a second, and at the end. With a recorder a checkpoint is
    /// written at the end of each phase, every 30 s of wall time (or after 100 times what writing one takes), when
    /// stopped, and when the physics stops the run.
    ///
    /// # Errors
    /// The disk.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::drive::{Control, Drive, Pause};
    /// use riprap::run::simulation::Simulation;
    ///
    /// let simulation = Simulation::from_toml(
    ///     r#"
    ///     riprap = 1
    ///     title = "a stone falls"
    ///     [space.planar]
    ///     gravity = ["0 m/s2", "-10 m/s2"]
    ///     [materials.rock]
    ///     density = "2500 kg/m3"
    ///     [interfaces.default]
    ///     normal_stiffness = "1 GPa/m"
    ///     friction_angle = "30 deg"
    ///     [[blocks]]
    ///     name = "stone"
    ///     material = "rock"
    ///     rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "5 m"] }
    ///     [[phases]]
    ///     name = "fall"
    ///     until = { time = "1 s" }
    ///     "#,
    /// )?;
    /// let mut drive = Drive::new(simulation, None, Vec::new())?;
    /// let halfway = Pause { time: Some(0.5), ..Pause::NEVER };
    /// assert!(drive.advance(halfway, &mut |_| Control::Continue)?.is_none());
    /// assert!((drive.simulation().time() - 0.5).abs() < drive.simulation().dt());
    /// let ending = drive.advance(Pause::NEVER, &mut |look| {
    ///     println!("step {}", look.progress.step);
    ///     Control::Continue
    /// })?;
    /// assert!(ending.is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn advance(
        &mut self,
        pause: Pause,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Option<Ending>, DriveError> {
        self.clock = Clock::new(self.simulation.steps());
        loop {
            if self.standing {
                // The pause was within a phase.
                if pause.reached(&self.simulation) {
                    return Ok(None);
                }
                self.standing = false;
            } else {
                // Before the forces: what they set up for the coming step would have to be kept else.
                self.keeper.keep(&mut self.simulation);
                let reached = pause.reached(&self.simulation);
                // A law of code may fail, and the run goes on from here then.
                let may_fail = reached || self.simulation.has_laws();
                if may_fail {
                    self.simulation.settle();
                }
                self.paused = may_fail.then(|| self.pause());
                let prepared = match !may_fail && self.passes_unread() {
                    true => self.simulation.prepare_unread(),
                    false => self.simulation.prepare(),
                };
                if prepared.is_err() {
                    self.simulation.settle();
                }
                self.sound()?;
                let stage = match prepared {
                    Ok(stage) => stage,
                    Err(error @ RunError::Law { .. }) => {
                        self.checkpoint()?;
                        if let Some(paused) = &self.paused {
                            self.simulation.restore(paused.snapshot.clone());
                        }
                        return Err(DriveError::Law(Box::new(error)));
                    }
                    Err(mut error) => {
                        self.checkpoint()?;
                        let keeper = std::mem::take(&mut self.keeper);
                        // A repetition would ask laws of code again.
                        if self.writes()
                            && !self.simulation.has_laws()
                            && let Some(found) = keeper.judge(&mut self.simulation, &error)
                        {
                            error.add(&found);
                        }
                        return Ok(Some(Ending::Unstable(error)));
                    }
                };
                if std::mem::take(&mut self.told) {
                    self.simulation.take_events(true);
                }
                self.observe(stage)?;
                if stage != Stage::Within {
                    self.paused = None;
                    if self.phase_end(stage, look)? {
                        return Ok(Some(Ending::Finished));
                    }
                    continue;
                }
                if reached {
                    self.standing = true;
                    return Ok(None);
                }
            }
            self.paused = None;
            self.simulation.step();
            self.sound()?;
            if self.after_step(look)? == Control::Stop {
                return Ok(Some(Ending::Stopped));
            }
        }
    }

    /// The ledger where a run has stopped before its end, if its forces are known and finite there; the last rows of its tables are of
    /// that state then. It is left afterwards: nothing else may be asked of it, and its checkpoint must have been written.
    ///
    /// # Errors
    /// The disk.
    pub(super) fn stopped(&mut self, ending: &Ending) -> Result<Option<Balance>, OutputError> {
        let simulation = &mut self.simulation;
        let known = match ending {
            Ending::Finished => false,
            // A step has moved the blocks, or a pause has found their forces already.
            Ending::Stopped => simulation.prepare().is_ok(),
            Ending::Unstable(why) => why.knows_forces(),
        };
        if !known {
            return Ok(None);
        }
        let balance = simulation.balance();
        if !COLUMNS.iter().all(|(_, get)| get(&balance).is_finite()) {
            return Ok(None);
        }
        // States on the way to an equilibrium are not recorded.
        if let Some(recorder) = self.recorder.as_mut().filter(|_| simulation.settled()) {
            recorder.stopped(simulation, &balance)?;
        }
        Ok(Some(balance))
    }

    fn last_phase(&self) -> bool {
        self.simulation.cursor().phase + 1 >= self.simulation.plan().phases.len()
    }

    /// Checks and records of the prepared state.
    fn observe(&mut self, stage: Stage) -> Result<(), DriveError> {
        let last = stage == Stage::Done || (stage == Stage::PhaseEnd && self.last_phase());
        for w in &mut self.watched {
            w.look(&self.simulation, last, stage != Stage::Within);
        }
        if let Some(r) = &mut self.recorder {
            let simulation = &mut self.simulation;
            if stage == Stage::Within {
                r.phase_started(simulation)?;
            }
            r.record(simulation, stage != Stage::Within)?;
        }
        Ok(())
    }

    /// Goes to the next phase; true at the end of the plan.
    fn phase_end(
        &mut self,
        stage: Stage,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<bool, DriveError> {
        if stage == Stage::Done {
            self.show(look);
            return Ok(true);
        }
        let last = self.last_phase();
        let unconverged = self.simulation.note_unconverged();
        let end = self.simulation.note_end();
        if let Some(r) = &mut self.recorder {
            if let Some(note) = unconverged {
                r.unconverged(&self.simulation, &note)?;
            }
            r.phase_ended(&self.simulation, end.as_ref())?;
        }
        if last {
            self.show(look);
        }
        // Before the checkpoint: a run that goes on begins with the next phase and does not end this one again.
        self.simulation.next_phase();
        self.checkpoint()?;
        Ok(last)
    }

    /// Checkpoints that are due, and the look of the caller.
    fn after_step(
        &mut self,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Control, DriveError> {
        let due = match &mut self.recorder {
            Some(r) => r.checkpoint_due(&self.simulation),
            None => false,
        };
        if due {
            self.checkpoint()?;
        }
        let order = self.order(look)?;
        match order {
            Order::GoOn => return Ok(Control::Continue),
            // Somebody waits for the run to stop.
            Order::Stop => self.save(Packing::Quick)?,
            Order::Save => {
                let begun = Instant::now();
                self.checkpoint()?;
                self.saved = Instant::now();
                self.saving = self.saved - begun;
            }
        }
        Ok(Control::stop_if(order == Order::Stop))
    }
}

fn watch_list(simulation: &Simulation, watches: Vec<Watch>) -> Result<Vec<Watched>, FieldError> {
    let kind = simulation.kind();
    let total: f64 = simulation.plan().phases.iter().filter_map(|p| p.until.time).sum();
    watches
        .into_iter()
        .map(|watch| {
            let check = watch.check();
            let reading = Reading::new(kind, &check.gauge)?;
            let rhythm = match check.window.within() {
                Window::Over { from, to, .. } if reading.costly() => {
                    // An interval may be open to the end: what counts is the part of it that the phases can reach.
                    (to.min(total.max(from)) - from).max(0.0) / 500.0
                }
                Window::Start
                | Window::At(_)
                | Window::End
                | Window::Over { .. }
                | Window::Phase { .. } => 0.0,
            };
            Ok(Watched { watch, reading, rhythm })
        })
        .collect()
}
