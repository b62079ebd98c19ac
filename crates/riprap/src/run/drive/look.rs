//! Looks at a run while it goes on, at a price that does not depend on the model.

use std::time::{Duration, Instant};

use super::Control;
use crate::run::simulation::Simulation;

/// Time between two looks.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);
/// Share of the wall time that measuring for a display, and saving by the clock, may take: one part in this many.
const SHARE: u32 = 100;
/// Most steps between two questions to the clock of the operating system, so that a run is stopped soon even where
/// steps become slower all at once.
const STRIDE: u64 = 64;

/// Pause after something that took `cost`, so that it takes no more than its share of the time.
pub(super) fn afford(cost: Duration) -> Duration {
    SHARE * cost
}

/// Where a run is. Costs nothing to know.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Progress {
    /// Name of the phase.
    pub phase: String,
    /// Number of the phase, from 1.
    pub phase_number: usize,
    /// Number of phases.
    pub phases: usize,
    /// Share of the phase that is done, 0..1, where its end is known.
    pub share: Option<f64>,
    /// Steps done.
    pub step: u64,
    /// Model time, s.
    pub time: f64,
    /// Time step, s.
    pub dt: f64,
    /// Steps per second of wall time since the last look.
    pub steps_per_second: f64,
    /// Expected wall time to the end of the phase, s.
    pub remaining: Option<f64>,
    /// Unit of energies: J, or J/m in the plane.
    pub energy_unit: &'static str,
}

/// What has to be summed over the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measured {
    /// Kinetic energy, in the unit of [`Progress::energy_unit`].
    pub kinetic: f64,
    /// Energy residual over the largest energy exchanged, as the ledger was last drawn up; `None` before.
    pub residual: Option<f64>,
    /// Unbalanced-force ratio.
    pub unbalanced: f64,
    /// Number of contacts.
    pub contacts: usize,
    /// Largest overlap over the smaller inscribed radius of its pair.
    pub worst_overlap: f64,
    /// Largest speed, m/s, and the block that has it.
    pub fastest: Option<(String, f64)>,
}

impl Measured {
    fn of(simulation: &Simulation) -> Self {
        let view = simulation.view();
        Self {
            kinetic: view.kinetic() * view.slice(),
            residual: simulation.residual(),
            unbalanced: view.unbalanced(),
            contacts: view.contacts(),
            worst_overlap: view.worst_overlap().map_or(0.0, |(x, _, _)| x),
            fastest: view.fastest(),
        }
    }
}

/// A look at a run, for progress displays.
#[derive(Debug)]
pub struct Look<'a> {
    /// Where the run is.
    pub progress: Progress,
    simulation: &'a Simulation,
    meter: &'a mut Meter,
}

impl Look<'_> {
    /// Sums over the model: new ones, or the last ones as long as new ones would take more than 1 % of the time. Ask only
    /// for what is shown.
    pub fn measured(&mut self) -> &Measured {
        self.meter.read(self.simulation)
    }
}

/// Measures the model, and what measuring takes.
#[derive(Debug, Default)]
struct Meter {
    last: Option<(Instant, Duration)>,
    value: Measured,
    /// Of several ranks: whether the present look may measure, and what it has taken to know the whole state for that.
    permit: Option<Option<Duration>>,
}

impl Meter {
    fn may_read(&self) -> bool {
        let due = |(at, cost): (Instant, Duration)| at.elapsed() >= afford(cost);
        self.last.is_none_or(due)
    }

    fn read(&mut self, simulation: &Simulation) -> &Measured {
        let before = match self.permit {
            Some(permit) => permit,
            None => self.may_read().then_some(Duration::ZERO),
        };
        if let Some(before) = before {
            let begun = Instant::now();
            self.value = Measured::of(simulation);
            let end = Instant::now();
            self.last = Some((end, end - begun + before));
        }
        &self.value
    }
}

/// Wall time of a phase from which on its rest is foretold, s: the first steps fill lists and memory.
const SETTLED: f64 = 2.0;
/// Time over which progress is averaged, at least, s.
const AVERAGE: f64 = 20.0;

/// Foretells the end of a phase from how its share has grown.
#[derive(Debug, Default)]
struct Forecast {
    phase: usize,
    /// Wall time (s since the start) and share at the begin of the average, and of the next one.
    marks: Option<[(f64, f64); 2]>,
}

impl Forecast {
    /// Wall time to the end of a phase, s; `None` as long as nobody can know.
    fn remaining(&mut self, now: f64, phase: usize, share: Option<f64>) -> Option<f64> {
        let share = share?;
        if self.phase != phase {
            *self = Self { phase, marks: None };
        }
        let [begin, next] = self.marks.get_or_insert([(now, share); 2]);
        if now - next.0 > AVERAGE {
            *begin = std::mem::replace(next, (now, share));
        }
        let (passed, grown) = (now - begin.0, share - begin.1);
        (passed >= SETTLED && grown > 0.0).then(|| passed * (1.0 - share).max(0.0) / grown)
    }
}

/// Wall clock of a run; asks the operating system for the time only every few steps.
#[derive(Debug)]
pub(super) struct Clock {
    last: Instant,
    step: u64,
    stride: u64,
    next: u64,
    rate: f64,
    meter: Meter,
    begun: Instant,
    forecast: Forecast,
}

impl Clock {
    pub(super) fn new(step: u64) -> Self {
        Self {
            last: Instant::now(),
            step,
            stride: 1,
            next: step,
            rate: 0.0,
            meter: Meter::default(),
            begun: Instant::now(),
            forecast: Forecast::default(),
        }
    }

    /// Step before which it is not asked again.
    pub(super) fn next(&self) -> u64 {
        self.next
    }

    /// Takes over from another rank when it is asked next.
    pub(super) fn set_next(&mut self, step: u64) {
        self.next = step;
    }

    /// Whether a look that came now would measure the model.
    pub(super) fn may_measure(&self) -> bool {
        self.meter.may_read()
    }

    /// Of several ranks: lets the next look measure, where knowing the whole state has taken so long, or not.
    pub(super) fn permit(&mut self, cost: Option<Duration>) {
        self.meter.permit = Some(cost);
        if let Some(cost) = cost {
            // Also where the look measures nothing.
            self.meter.last = Some((Instant::now(), cost));
        }
    }

    /// Whether it is time for a look.
    pub(super) fn due(&mut self, step: u64) -> bool {
        if step < self.next {
            return false;
        }
        let spent = self.last.elapsed();
        if spent < CHECK_INTERVAL && self.rate > 0.0 {
            // Asked too early: steps are faster than they were, and the clock is asked less often.
            self.stride = (self.stride * 2).min(STRIDE);
            self.next = step + self.stride;
            return false;
        }
        self.rate = (step - self.step) as f64 / spent.as_secs_f64().max(1e-9);
        true
    }

    /// Shows the run to the caller; the time until the next look is counted from the end of this one.
    pub(super) fn look(
        &mut self,
        simulation: &Simulation,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Control {
        let control = look(&mut Look {
            progress: self.progress(simulation),
            simulation,
            meter: &mut self.meter,
        });
        let step = simulation.steps();
        // An eighth of the steps of a pause: so a look is late by about that
        // much of it, if all at once steps take longer.
        self.stride = ((self.rate * CHECK_INTERVAL.as_secs_f64() / 8.0) as u64).clamp(1, STRIDE);
        self.next = step + self.stride;
        self.last = Instant::now();
        self.step = step;
        control
    }

    fn progress(&mut self, simulation: &Simulation) -> Progress {
        let cursor = simulation.cursor();
        let (step, share) = (simulation.steps(), simulation.progress());
        let now = self.begun.elapsed().as_secs_f64();
        let remaining = self.forecast.remaining(now, cursor.phase + 1, share);
        Progress {
            phase: simulation.phase().map_or_else(String::new, |p| p.name.clone()),
            phase_number: cursor.phase + 1,
            phases: simulation.plan().phases.len(),
            share,
            step,
            time: simulation.time(),
            dt: simulation.dt(),
            steps_per_second: self.rate,
            remaining,
            energy_unit: simulation.kind().energy_unit(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_is_foretold_when_it_can_be() {
        let mut forecast = Forecast::default();
        // A slow first second (lists, memory, first touch), then 1 % a second.
        assert_eq!(forecast.remaining(0.0, 1, Some(0.0)), None);
        assert_eq!(forecast.remaining(1.0, 1, Some(0.0001)), None);
        for second in 2..80 {
            let share = 0.01 * f64::from(second - 1);
            let left = forecast.remaining(f64::from(second), 1, Some(share));
            let told = left.unwrap_or_else(|| panic!("nothing after {second} s"));
            let true_left = 100.0 * (1.0 - share);
            assert!(told > 0.999 * true_left && told < 2.1 * true_left, "{second}: {told}");
            assert!(second < 45 || told < 1.01 * true_left, "{second}: {told}");
        }
        // Another phase starts over, one without an end in sight says nothing.
        assert_eq!(forecast.remaining(80.0, 2, Some(0.5)), None);
        assert_eq!(forecast.remaining(83.0, 2, None), None);
        // A run that was resumed counts what it has done itself.
        assert_eq!(forecast.remaining(90.0, 2, Some(0.75)), Some(10.0));
    }
}
