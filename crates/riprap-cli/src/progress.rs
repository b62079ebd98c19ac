//! The live display of a run: three lines with a bar on a terminal, one plain line every few
//! seconds elsewhere. It goes to stderr, so that stdout holds results alone.

use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::numbers::{duration, grouped, ratio, si};

/// Time between two plain lines.
const PLAIN_EVERY: Duration = Duration::from_secs(3);
/// Time between two drawings on a terminal.
const DRAW_EVERY: Duration = Duration::from_millis(100);

/// What the display shows of a run at one moment. SI numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Name of the phase.
    pub phase: String,
    /// Number of the phase, from 0.
    pub phase_index: usize,
    /// How many phases there are.
    pub phase_count: usize,
    /// Steps since the start of the run.
    pub step: u64,
    /// Model time, s.
    pub time: f64,
    /// Time step, s.
    pub dt: f64,
    /// Share of the whole run that is done, 0 to 1, where it can be known.
    pub share: Option<f64>,
    /// Contacts now.
    pub contacts: usize,
    /// Kinetic energy, J/m.
    pub kinetic: f64,
    /// Energy residual over the energy moved so far.
    pub residual: f64,
    /// Largest overlap now, m.
    pub worst_overlap: f64,
    /// Unbalanced-force ratio.
    pub unbalanced: f64,
}

/// Where and how progress is shown.
pub struct Display {
    form: Form,
    begun: Instant,
    last: Instant,
    /// First reading since the start or a resume: what rates and ETA count from.
    first: Option<(u64, f64)>,
    shown_phase: Option<usize>,
}

enum Form {
    Bar(ProgressBar),
    Lines,
    Silent,
}

impl Display {
    /// The display that suits stderr.
    pub fn new(quiet: bool) -> Self {
        let form = if quiet {
            Form::Silent
        } else if std::io::stderr().is_terminal() {
            let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::stderr());
            // The template is a constant; a mistake in it shows in the first run by hand.
            if let Ok(style) = ProgressStyle::with_template("{prefix}\n[{bar:40}] {msg}") {
                bar.set_style(style.progress_chars("=> "));
            }
            Form::Bar(bar)
        } else {
            Form::Lines
        };
        let now = Instant::now();
        Display {
            form,
            begun: now,
            last: now - PLAIN_EVERY,
            first: None,
            shown_phase: None,
        }
    }

    /// Shows `reading` if it is time for it.
    pub fn show(&mut self, reading: &Reading) {
        let (first_step, first_share) = *self
            .first
            .get_or_insert((reading.step, reading.share.unwrap_or(0.0)));
        let wait = match self.form {
            Form::Bar(_) => DRAW_EVERY,
            Form::Lines => PLAIN_EVERY,
            Form::Silent => return,
        };
        let new_phase = self.shown_phase != Some(reading.phase_index);
        if self.last.elapsed() < wait && !new_phase {
            return;
        }
        self.last = Instant::now();
        self.shown_phase = Some(reading.phase_index);
        let seconds = self.begun.elapsed().as_secs_f64();
        let rate = (reading.step - first_step.min(reading.step)) as f64 / seconds.max(1e-9);
        let eta = reading.share.and_then(|share| {
            let gained = share - first_share;
            (gained > 0.0 && seconds > 1.0).then(|| seconds * (1.0 - share) / gained)
        });
        match &self.form {
            Form::Bar(bar) => {
                let share = reading.share.unwrap_or(0.0).clamp(0.0, 1.0);
                bar.set_position((share * 1000.0) as u64);
                bar.set_prefix(format!("{}\n{}", head(reading, rate), state(reading)));
                bar.set_message(percent(reading.share, eta));
            }
            Form::Lines => {
                let line = format!(
                    "{}  {}  {}",
                    head(reading, rate),
                    percent(reading.share, eta),
                    state(reading)
                );
                // A log that cannot be written must not stop the run.
                let _ = writeln!(std::io::stderr(), "{line}");
            }
            Form::Silent => {}
        }
    }

    /// Takes the bar away; the last words follow on a clean line.
    pub fn close(&self) {
        if let Form::Bar(bar) = &self.form {
            bar.finish_and_clear();
        }
    }

    /// One line of its own, above the bar where there is one.
    pub fn say(&self, line: &str) {
        match &self.form {
            Form::Bar(bar) => bar.println(line),
            Form::Lines => {
                let _ = writeln!(std::io::stderr(), "{line}");
            }
            Form::Silent => {}
        }
    }
}

fn head(r: &Reading, rate: f64) -> String {
    let steps_per_second = if rate > 0.0 {
        grouped(rate as u64)
    } else {
        "?".to_owned()
    };
    format!(
        "phase {}/{} {:?}  step {}  t = {}  dt = {}  {steps_per_second} steps/s",
        r.phase_index + 1,
        r.phase_count,
        r.phase,
        grouped(r.step),
        si(r.time, "s"),
        si(r.dt, "s"),
    )
}

fn state(r: &Reading) -> String {
    format!(
        "contacts {}  kinetic {}  unbalanced {}  energy residual {} %  worst overlap {}",
        grouped(r.contacts as u64),
        si(r.kinetic, "J/m"),
        ratio(r.unbalanced),
        ratio(100.0 * r.residual),
        si(r.worst_overlap, "m"),
    )
}

fn percent(share: Option<f64>, eta: Option<f64>) -> String {
    let share = share.map_or("  ? %".to_owned(), |s| format!("{:3.0} %", 100.0 * s));
    let eta = eta.map_or("?".to_owned(), duration);
    format!("{share}  ETA {eta}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lines_say_what_matters() {
        let reading = Reading {
            phase: "excavate".to_owned(),
            phase_index: 1,
            phase_count: 3,
            step: 41_200,
            time: 0.412,
            dt: 1e-5,
            share: Some(0.51),
            contacts: 9412,
            kinetic: 12_400.0,
            residual: 3e-4,
            worst_overlap: 4e-4,
            unbalanced: 3.1e-4,
        };
        assert_eq!(
            head(&reading, 6120.4),
            "phase 2/3 \"excavate\"  step 41 200  t = 412 ms  dt = 10 us  6 120 steps/s"
        );
        assert_eq!(
            state(&reading),
            "contacts 9 412  kinetic 12.4 kJ/m  unbalanced 3.1e-4  energy residual 0.03 %  \
             worst overlap 400 um"
        );
        assert_eq!(percent(reading.share, Some(400.0)), " 51 %  ETA 6 min 40 s");
        assert_eq!(percent(None, None), "  ? %  ETA ?");
    }
}
