//! The first steps of a run, and how the rest of it will go on by them.
//!
//! A model whose blocks stay where they are costs the same in every step, and a few steps tell all. One whose blocks are loose does
//! not: they meet and rest on each other, steps become shorter and each costs more. Such a model is tried longer, and what is left is
//! reckoned from the last part of what was tried:
//!
//! ```text
//!   |<--- tried --->|<------------- rest of the phase ------------->|<- later phases ->|
//!   .......|<- own ->|  own cost and steps of a share of the phase,    own cost of a step,
//!           share     times the shares that are left                    steps of the plan
//! ```

use std::time::Duration;

use super::super::cpu::Work;
use super::super::simulation::{RunError, Simulation, Stage};

/// Most CPU time spent on the first trial steps, and on all where more than those are done; four steps are done in any case.
const TRIAL: [Duration; 2] = [Duration::from_millis(300), Duration::from_millis(100)];
/// The same where the first steps do not speak for the later ones.
pub(super) const LOOSE: Duration = Duration::from_millis(2000);
/// Parts of that time between two marks.
const MARKS: u32 = 40;
/// Steps that are not timed, where there are more.
const WARM: u64 = 2;
/// The first trial steps. Where the physics stops one of the first phase it is an error; what comes later is left to the run.
const FIRST: u64 = 200;

/// Where a trial was at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mark {
    /// CPU time so far, s.
    pub(super) cpu: f64,
    /// Steps so far.
    pub(super) steps: u64,
    /// Time of the model, s.
    pub(super) time: f64,
    /// Index of the phase.
    pub(super) phase: usize,
    /// Share of the phase that is done by its time or its count of steps.
    pub(super) share: Option<f64>,
    /// Unbalanced force, where the phase ends by it.
    pub(super) unbalanced: Option<f64>,
    /// Touching contacts.
    pub(super) contacts: usize,
}

impl Mark {
    fn of(simulation: &Simulation, cpu: Duration) -> Self {
        let phase = simulation.phase();
        let ends_by_force = phase.is_some_and(|phase| phase.until.unbalanced.is_some());
        Self {
            cpu: cpu.as_secs_f64(),
            steps: simulation.steps(),
            time: simulation.time(),
            phase: simulation.cursor().phase,
            share: simulation.progress(),
            unbalanced: ends_by_force.then(|| simulation.view().unbalanced()),
            contacts: simulation.view().contacts(),
        }
    }
}

/// The first steps of a run.
#[derive(Debug)]
pub(super) struct Trial {
    /// Steps per second of CPU time.
    pub(super) rate: f64,
    /// Steps done.
    pub(super) steps: u64,
    /// Steps of the run, where the trial came to its end.
    pub(super) end: Option<u64>,
    /// Where it was, from its first step to its last.
    pub(super) marks: Vec<Mark>,
}

impl Trial {
    /// Goes on as long as there is time, from a state that has been prepared; four steps at least. The first two are not timed where there
    /// are more: they touch memory for the first time and are guarded more closely, in a model of a million blocks eight and two times as
    /// long as the others. `loose`: CPU time where what is tried first does not speak for the rest.
    pub(super) fn of(
        simulation: &mut Simulation,
        stage: Stage,
        loose: Option<Duration>,
    ) -> Result<Self, RunError> {
        let work = Work::begin();
        let (mut steps, mut end) = (0, None);
        let mut warm = Duration::ZERO;
        let mut stage = Ok(stage);
        let mut marks = vec![Mark::of(simulation, Duration::ZERO)];
        let most = |steps| loose.unwrap_or(TRIAL[usize::from(steps >= FIRST)]);
        let pause = most(0) / MARKS;
        let mut next = pause;
        while steps < 2 * WARM || work.done() < most(steps) {
            stage = match stage {
                Ok(Stage::Within) => {
                    simulation.step();
                    steps += 1;
                    let next = simulation.prepare();
                    if steps == WARM {
                        warm = work.done();
                    }
                    next
                }
                Ok(Stage::PhaseEnd) => {
                    simulation.note_unconverged();
                    simulation.note_end();
                    simulation.next_phase();
                    simulation.prepare()
                }
                Ok(Stage::Done) => {
                    end = Some(simulation.steps());
                    break;
                }
                Err(error) if steps < FIRST && simulation.cursor().phase == 0 => return Err(error),
                Err(_) => break,
            };
            if work.done() >= next {
                marks.push(Mark::of(simulation, work.done()));
                next = work.done() + pause;
            }
        }
        marks.push(Mark::of(simulation, work.done()));
        let (timed, time) = if steps > WARM {
            (steps - WARM, work.done() - warm)
        } else {
            (steps.max(1), work.done())
        };
        Ok(Self { rate: timed as f64 / time.as_secs_f64().max(1e-9), steps, end, marks })
    }

    /// CPU time, s.
    pub(super) fn cpu(&self) -> f64 {
        self.marks.last().map_or(0.0, |mark| mark.cpu)
    }
}
