//! Turns a simulation into a run folder: what is written when.

use serde::{Deserialize, Serialize};
use serde_json::json;

use super::plan::{Every, Plan};
use super::simulation::{Simulation, Snapshot};
use crate::planar::readings::{self, Reading};
use crate::record::{FieldError, Marks, OutputError, RunFolder};

/// Columns of `energy.csv`: field of the table and column name.
pub const ENERGY: [&str; 13] = [
    "energy.kinetic",
    "energy.gravity",
    "energy.contact_normal",
    "energy.contact_shear",
    "energy.joints",
    "energy.loads",
    "energy.supports",
    "energy.friction",
    "energy.damping",
    "energy.fracture",
    "energy.law_defect",
    "energy.edit_defect",
    "energy.residual",
];

/// Records written so far, per rhythm; part of a checkpoint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Counts {
    frames: u64,
    energy: u64,
    checkpoints: u64,
    histories: Vec<u64>,
    last_step: Option<u64>,
}

/// Checkpoint of a recorded run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The simulation.
    pub snapshot: Snapshot,
    /// How far the files had come.
    pub marks: Marks,
    /// How far the rhythms had come.
    pub counts: Counts,
}

/// Kind word of checkpoints of the planar engine.
pub const KIND: &str = "planar";

/// Writes a run folder while a simulation goes on.
#[derive(Debug)]
pub struct Recorder {
    /// The folder.
    pub folder: RunFolder,
    readings: Vec<(Reading, Every)>,
    frames: Option<Every>,
    energy: Option<Every>,
    checkpoints: Option<Every>,
    counts: Counts,
    last_frame: Option<u64>,
}

impl Recorder {
    /// Starts (or, with `counts` of a checkpoint, continues) recording into `folder`.
    ///
    /// # Errors
    /// Histories of unknown fields; the disk.
    pub fn new(
        mut folder: RunFolder,
        plan: &Plan,
        counts: Option<Counts>,
    ) -> Result<Self, RecordError> {
        let mut readings = Vec::new();
        let mut columns = Vec::new();
        for history in &plan.histories {
            let reading = Reading::new(&history.field, &history.of, history.along)?;
            columns.push((history.name.clone(), reading.info().unit.to_owned()));
            readings.push((reading, history.every));
        }
        if !columns.is_empty() {
            folder.begin_histories(&columns)?;
        }
        let names: Vec<(&str, &str)> = ENERGY
            .iter()
            .map(|name| (name.trim_start_matches("energy."), "J/m"))
            .collect();
        folder.begin_energy(&names)?;
        let mut counts = counts.unwrap_or_default();
        counts.histories.resize(readings.len(), 0);
        let last_frame = folder.frames().last().map(|f| f.step);
        Ok(Self {
            folder,
            readings,
            frames: plan.frames,
            energy: plan.energy.or(plan.frames),
            checkpoints: plan.checkpoints,
            counts,
            last_frame,
        })
    }

    /// Writes what is due at the present, prepared state.
    ///
    /// # Errors
    /// The disk.
    pub fn record(&mut self, simulation: &Simulation, phase_end: bool) -> Result<(), OutputError> {
        let view = simulation.view();
        let (step, time) = (view.world.step, view.world.time);
        if self.counts.last_step == Some(step) {
            // The first look of a phase is the last one of the phase before.
            return Ok(());
        }
        self.counts.last_step = Some(step);
        let (half, first) = (0.5 * simulation.dt(), step == 0);
        let due = |every: &Every, count: &mut u64| {
            let hit = match every {
                Every::Time(span) => time + half >= *count as f64 * span,
                Every::Steps(n) => step.is_multiple_of((*n).max(1)),
                Every::Phase => phase_end || first,
            };
            if hit {
                *count = match every {
                    Every::Time(span) => ((time + half) / span).floor() as u64 + 1,
                    Every::Steps(_) | Every::Phase => *count + 1,
                };
            }
            hit
        };
        let mut row = vec![None; self.readings.len()];
        for (k, (reading, every)) in self.readings.iter().enumerate() {
            if due(every, &mut self.counts.histories[k]) || phase_end {
                row[k] = Some(reading.value(&view));
            }
        }
        if row.iter().any(Option::is_some) {
            self.folder.history_row(step, time, &row)?;
        }
        let edge = first || phase_end;
        let energy = self
            .energy
            .as_ref()
            .is_some_and(|every| due(every, &mut self.counts.energy));
        if energy || edge {
            self.energy_row(simulation)?;
        }
        let frame = self
            .frames
            .as_ref()
            .is_some_and(|every| due(every, &mut self.counts.frames));
        if (frame || edge) && self.last_frame != Some(step) {
            let phase = simulation.phase().map_or("", |p| p.name.as_str());
            self.folder.frame(&readings::frame(&view, phase))?;
            self.last_frame = Some(step);
        }
        self.events(simulation)
    }

    fn energy_row(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let view = simulation.view();
        let b = view.balance();
        let w = &b.works;
        let row = [
            b.kinetic,
            b.gravity,
            b.contact_normal,
            b.contact_shear,
            b.bond,
            w.loads,
            w.supports,
            w.friction,
            w.damping,
            w.fracture,
            w.law_defect,
            w.edit_defect,
            b.residual(),
        ];
        self.folder
            .energy_row(view.world.step, view.world.time, &row)
    }

    /// Joints that have broken since the last look.
    fn events(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let world = simulation.view().world;
        for bond in world
            .bonds
            .iter()
            .filter(|b| b.broken_at == Some(world.step))
        {
            let name = |b: u32| &world.setup.blocks[b as usize].name;
            self.folder.event(&json!({
                "event": "joint_broken",
                "step": world.step,
                "time": world.time,
                "blocks": [name(bond.i), name(bond.j)],
                "length": bond.length,
            }))?;
        }
        Ok(())
    }

    /// Notes the start or end of a phase.
    ///
    /// # Errors
    /// The disk.
    pub fn phase_event(&mut self, simulation: &Simulation, what: &str) -> Result<(), OutputError> {
        let world = simulation.view().world;
        let phase = simulation.phase().map_or("", |p| p.name.as_str());
        self.folder.event(&json!({
            "event": what, "phase": phase, "step": world.step, "time": world.time,
        }))
    }

    /// Whether a checkpoint is due after the step just made.
    pub fn checkpoint_due(&mut self, simulation: &Simulation) -> bool {
        let world = simulation.view().world;
        let count = &mut self.counts.checkpoints;
        match self.checkpoints {
            Some(Every::Time(span)) => {
                let due = world.time >= (*count + 1) as f64 * span;
                if due {
                    *count = (world.time / span).floor() as u64;
                }
                due
            }
            Some(Every::Steps(n)) => world.step.is_multiple_of(n.max(1)),
            Some(Every::Phase) | None => false,
        }
    }

    /// Writes a checkpoint of the present state.
    ///
    /// # Errors
    /// The disk.
    pub fn checkpoint(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let snapshot = simulation.snapshot();
        let step = snapshot.world.step;
        let marks = self.folder.marks(step);
        let value = Checkpoint {
            snapshot,
            marks,
            counts: self.counts.clone(),
        };
        self.folder.checkpoint(KIND, step, &value)?;
        Ok(())
    }
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
