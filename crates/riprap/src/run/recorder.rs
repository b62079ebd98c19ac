//! Turns a simulation into a run folder: what is written when.

use serde::{Deserialize, Serialize};
use serde_json::json;

use super::checks::Watch;
use super::engine::{Kind, Reading, View};
use super::origin::Origin;
use super::simulation::{PhaseEnd, Simulation, Snapshot, SnapshotRef, Unconverged};
use crate::ledger::{Balance, COLUMNS};
use crate::plan::{Every, Plan};
use crate::record::checkpoint::Packing;
use crate::record::conditions::{self, Conditions};
use crate::record::frame::Content;
use crate::record::{FieldError, Marks, OutputError, RunFolder};

/// Records written so far, per rhythm; part of a checkpoint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Counts {
    frames: u64,
    energy: u64,
    checkpoints: u64,
    histories: Vec<u64>,
    last_step: Option<u64>,
    /// Phases whose start has been noted.
    phases: usize,
}

/// Checkpoint of a recorded run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    /// Which scene it is of.
    pub origin: Origin,
    /// The simulation.
    pub snapshot: Snapshot,
    /// How far the files had come.
    pub marks: Marks,
    /// How far the rhythms had come.
    pub counts: Counts,
    /// How far the checks had come.
    pub watches: Vec<Watch>,
}

/// A [`Checkpoint`] to be written, of which nothing is copied: the same fields in the same order.
#[derive(Serialize)]
struct CheckpointRef<'a> {
    origin: &'a Origin,
    snapshot: SnapshotRef<'a>,
    marks: &'a Marks,
    counts: &'a Counts,
    watches: &'a [Watch],
}

/// Kind word of checkpoints of runs.
pub const KIND: &str = "run";

/// Writes a run folder while a simulation goes on.
#[derive(Debug)]
pub struct Recorder {
    /// The folder.
    pub folder: RunFolder,
    origin: Origin,
    readings: Vec<(Reading, Every)>,
    frames: Option<Every>,
    pictures: Content,
    energy: Option<Every>,
    checkpoints: Option<Every>,
    counts: Counts,
    last_frame: Option<u64>,
    /// Steps of the last rows of histories and energies. What a run that goes on had looked at counts as written.
    last_rows: [Option<u64>; 2],
    /// Number of blocks whose names are written.
    named: usize,
    /// What holds, moves and loads the blocks that are known.
    conditions: Conditions,
}

impl Recorder {
    /// Starts (or, with `counts` of a checkpoint, continues) recording into `folder`.
    ///
    /// # Errors
    /// Histories of unknown fields; the disk.
    pub fn new(
        mut folder: RunFolder,
        origin: Origin,
        kind: Kind,
        plan: &Plan,
        counts: Option<Counts>,
    ) -> Result<Self, RecordError> {
        let mut readings = Vec::new();
        let mut columns = Vec::new();
        for history in &plan.histories {
            let reading = Reading::new(kind, &history.gauge)?;
            columns.push((history.name.clone(), reading.info().unit.to_owned()));
            readings.push((reading, history.every));
        }
        if !columns.is_empty() {
            folder.begin_histories(&columns)?;
        }
        let names: Vec<(&str, &str)> =
            COLUMNS.iter().map(|(name, _)| (*name, kind.energy_unit())).collect();
        folder.begin_energy(&names)?;
        let mut conditions = match &counts {
            // Blocks that are gone by now are in the file alone. It is drawn from and nothing else: where it cannot be read
            // the blocks of the present have to do.
            Some(_) if !folder.is_silent() => conditions::read(folder.path()).ok().flatten(),
            Some(_) | None => None,
        }
        .unwrap_or_default();
        conditions.standing = standing(plan);
        let mut counts = counts.unwrap_or_default();
        counts.histories.resize(readings.len(), 0);
        let last_frame = folder.frames().last().map(|f| f.step);
        let last_rows = [counts.last_step; 2];
        Ok(Self {
            folder,
            origin,
            readings,
            frames: plan.frames,
            pictures: plan.pictures.clone(),
            energy: plan.energy.or(plan.frames),
            checkpoints: plan.checkpoints,
            counts,
            last_frame,
            last_rows,
            named: 0,
            conditions,
        })
    }

    /// Writes what is due at the present, prepared state.
    ///
    /// # Errors
    /// The disk.
    pub fn record(
        &mut self,
        simulation: &mut Simulation,
        phase_end: bool,
    ) -> Result<(), OutputError> {
        let (step, time) = (simulation.steps(), simulation.time());
        let again = self.counts.last_step == Some(step);
        for event in simulation.take_events(again) {
            self.folder.event(&event)?;
        }
        if again {
            // The first look of a phase is the last one of the phase before.
            return Ok(());
        }
        self.counts.last_step = Some(step);
        let now = Now::of(simulation, phase_end);
        let silent = self.folder.is_silent();
        let view = simulation.view();
        if !silent {
            self.record_names(&view)?;
        }
        let mut row = vec![None; self.readings.len()];
        for (k, (reading, every)) in self.readings.iter().enumerate() {
            // Asked in any case, so that the rhythm goes on where the end of a phase writes the row.
            if (now.is_due(every, &mut self.counts.histories[k]) || phase_end) && !silent {
                row[k] = Some(reading.value(&view));
            }
        }
        if row.iter().any(Option::is_some) {
            self.folder.history_row(step, time, &row)?;
            self.last_rows[0] = Some(step);
        }
        let due = |every: &Option<Every>, count: &mut u64| {
            every.as_ref().is_some_and(|every| now.is_due(every, count))
        };
        let energy = due(&self.energy, &mut self.counts.energy);
        let frame = due(&self.frames, &mut self.counts.frames);
        if (energy || now.edge) && !silent {
            let balance = simulation.balance();
            self.energy_row(simulation, &balance)?;
        }
        let wanted = frame || (now.edge && self.frames != Some(Every::Never));
        if wanted && self.last_frame != Some(step) {
            self.last_frame = Some(step);
            if silent {
                self.folder.count_frame(step, time);
                return Ok(());
            }
            let phase = simulation.phase().map_or("", |p| p.name.as_str());
            let view = simulation.view();
            let picture = view.picture(phase, &self.pictures);
            self.folder.frame(&picture, view.exec())?;
        }
        Ok(())
    }

    /// Whether [`Recorder::record`] would read the present state, whose forces are still to be found for a step as long as the last one,
    /// within a phase.
    pub(in crate::run) fn is_due(&self, simulation: &Simulation) -> bool {
        let now = Now::of(simulation, false);
        let reached = |every: &Every, mut count: u64| now.is_due(every, &mut count);
        let counts = &self.counts;
        let histories = self.readings.iter().zip(&counts.histories);
        let tables = [(&self.energy, counts.energy), (&self.frames, counts.frames)];
        now.edge
            || histories.into_iter().any(|((_, every), count)| reached(every, *count))
            || tables
                .iter()
                .any(|(every, count)| every.is_some_and(|every| reached(&every, *count)))
    }

    /// Writes the names of blocks and their conditions, where there are more than were written.
    fn record_names(&mut self, view: &View<'_>) -> Result<(), OutputError> {
        let blocks = view.all_blocks();
        if blocks == self.named {
            return Ok(());
        }
        self.folder.write_names(&view.names())?;
        // A run that goes on finds what was written of the blocks that it has.
        if self.conditions.blocks < blocks {
            let mut later = view.conditions(self.conditions.blocks);
            later.standing.clone_from(&self.conditions.standing);
            self.conditions.extend(later);
            self.folder.write_conditions(&self.conditions)?;
        }
        self.named = blocks;
        Ok(())
    }

    fn energy_row(
        &mut self,
        simulation: &Simulation,
        balance: &Balance,
    ) -> Result<(), OutputError> {
        let row = COLUMNS.map(|(_, get)| get(balance));
        let step = simulation.steps();
        self.folder.energy_row(step, simulation.time(), &row)?;
        self.last_rows[1] = Some(step);
        Ok(())
    }

    /// Writes the rows of the present, prepared state, at which a run has stopped before its end, as far as it has none yet. They
    /// stand behind what the last checkpoint counts: a run that goes on cuts them off.
    ///
    /// # Errors
    /// The disk.
    pub fn stopped(
        &mut self,
        simulation: &Simulation,
        balance: &Balance,
    ) -> Result<(), OutputError> {
        if self.folder.is_silent() {
            return Ok(());
        }
        let (step, time) = (simulation.steps(), simulation.time());
        let [history, energy] = self.last_rows.map(|last| last != Some(step));
        if history && !self.readings.is_empty() {
            let view = simulation.view();
            let values = self.readings.iter().map(|(r, _)| Some(r.value(&view)));
            let row: Vec<_> = values.collect();
            self.folder.history_row(step, time, &row)?;
            self.last_rows[0] = Some(step);
        }
        if energy {
            self.energy_row(simulation, balance)?;
        }
        Ok(())
    }

    /// Notes the start of the present phase, once.
    ///
    /// # Errors
    /// The disk.
    pub fn phase_started(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let phase = simulation.cursor().phase;
        if self.counts.phases > phase {
            return Ok(());
        }
        self.counts.phases = phase + 1;
        let view = simulation.view();
        let name = simulation.phase().map_or("", |p| p.name.as_str());
        self.folder.event(&json!({
            "event": "phase_started", "phase": name, "step": view.step(), "time": view.time(),
        }))
    }

    /// Notes the end of the present phase, why it has ended, and the fragments there are.
    ///
    /// # Errors
    /// The disk.
    pub fn phase_ended(
        &mut self,
        simulation: &Simulation,
        end: Option<&PhaseEnd>,
    ) -> Result<(), OutputError> {
        if self.folder.is_silent() {
            return Ok(());
        }
        let view = simulation.view();
        let phase = simulation.phase().map_or("", |p| p.name.as_str());
        let mut event = json!({
            "event": "phase_ended", "phase": phase, "step": view.step(), "time": view.time(),
        });
        if let Some(end) = end {
            event["reason"] = json!(end.reason);
            event["why"] = json!(end.words());
            event["unbalanced"] = json!(end.unbalanced);
            for (key, block) in [("least_balanced", &end.worst), ("moving", &end.moving)] {
                if let Some((name, value)) = block {
                    event[key] = json!({ "block": name, "ratio": value });
                }
            }
            event["warning"] = json!(end.warning());
        }
        self.folder.event(&event)?;
        if let Some(fragments) = simulation.view().fragments() {
            self.folder.write_file("fragments.csv", fragments.csv().as_bytes())?;
            let members = fragments.members_csv();
            self.folder.write_file("fragment_blocks.csv", members.as_bytes())?;
        }
        self.folder.write_file("final_states.csv", view.states().as_bytes())?;
        if let Some(bolts) = view.bolt_table() {
            self.folder.write_file("bolts.csv", bolts.as_bytes())?;
        }
        Ok(())
    }

    /// Notes that the present phase ends without equilibrium.
    ///
    /// # Errors
    /// The disk.
    pub fn unconverged(
        &mut self,
        simulation: &Simulation,
        note: &Unconverged,
    ) -> Result<(), OutputError> {
        let view = simulation.view();
        self.folder.event(&json!({
            "event": "not_converged", "phase": note.phase, "step": view.step(), "time": view.time(),
            "iterations": note.iterations, "unbalanced": note.ratio, "wanted": note.wanted,
        }))
    }

    /// Whether a checkpoint is due after the step just made.
    pub fn checkpoint_due(&mut self, simulation: &Simulation) -> bool {
        let (step, time) = (simulation.steps(), simulation.time());
        let count = &mut self.counts.checkpoints;
        match self.checkpoints {
            Some(Every::Time(span)) => {
                // Times are sums of steps: a mark that is missed by round-off alone is met.
                let marks = (time / span + 1e-9).floor() as u64;
                let due = marks > *count;
                *count = marks.max(*count);
                due
            }
            Some(Every::Steps(n)) => step.is_multiple_of(n.max(1)),
            Some(Every::Phase | Every::Never) | None => false,
        }
    }

    /// What has been recorded until now, as a checkpoint of a step holds it.
    #[must_use]
    pub fn recorded(&self, step: u64) -> Recorded {
        Recorded { marks: self.folder.marks(step), counts: self.counts.clone() }
    }

    /// Writes a checkpoint of a state and of the checks.
    ///
    /// # Errors
    /// The disk.
    pub fn checkpoint(
        &mut self,
        snapshot: SnapshotRef<'_>,
        watches: &[Watch],
        recorded: &Recorded,
        packing: Packing,
    ) -> Result<(), OutputError> {
        if self.folder.is_silent() {
            return Ok(());
        }
        let Recorded { marks, counts } = recorded;
        let value = CheckpointRef { origin: &self.origin, snapshot, marks, counts, watches };
        self.folder.checkpoint_as(KIND, marks.step, &value, packing)?;
        Ok(())
    }
}

/// How far the records of a run have come.
#[derive(Clone, Debug)]
pub struct Recorded {
    marks: Marks,
    counts: Counts,
}

/// The phases, each with the water table that stands in it: one that a phase sets stays until another one is set.
fn standing(plan: &Plan) -> Vec<(String, Option<u16>)> {
    let mut now = None;
    let phases = plan.phases.iter();
    phases
        .map(|phase| {
            now = phase.water.unwrap_or(now);
            (phase.name.clone(), now)
        })
        .collect()
}

/// Why recording could not start.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// A history asks for a field that is not there.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// The disk.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// A state that may be recorded.
struct Now {
    step: u64,
    time: f64,
    /// Half the coming step, s: of the states on both sides of a mark the nearer one is written, the first that is within half a step of it.
    half: f64,
    /// States on the way to an equilibrium are not recorded.
    settled: bool,
    /// The first state of the run, or the last one of a phase.
    edge: bool,
}

impl Now {
    fn of(simulation: &Simulation, phase_end: bool) -> Self {
        let step = simulation.steps();
        Self {
            step,
            time: simulation.time(),
            // In a relaxing phase time passes in load steps.
            half: if simulation.relaxes() { 0.0 } else { 0.5 * simulation.dt() },
            settled: simulation.settled(),
            edge: step == 0 || phase_end,
        }
    }

    /// Whether a mark has been reached, `count` of which have been.
    fn is_due(&self, every: &Every, count: &mut u64) -> bool {
        let (hit, next) = match every {
            Every::Time(span) => {
                // Load steps sum up to a mark but for round-off, and half a step does not make up for it there.
                let reached = self.time + self.half.max(1e-9 * span) >= *count as f64 * span;
                // Marks that one long step has gone past are left out, not made up for.
                let marks = ((self.time + self.half) / span + 1e-9).floor() as u64;
                (self.settled && reached, marks.saturating_add(1))
            }
            Every::Steps(n) => (self.step.is_multiple_of((*n).max(1)), *count + 1),
            Every::Phase => (self.edge, *count + 1),
            Every::Never => (false, *count),
        };
        if hit {
            *count = next;
        }
        hit
    }
}
