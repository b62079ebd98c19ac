//! The live display of a run: three lines with a bar on a terminal, one plain line every few
//! seconds elsewhere. It goes to stderr, so that stdout holds results alone.

use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use riprap::run::drive::{Look, Measured, Progress};

use crate::numbers::{duration, grouped, ratio, si};

/// Time between two plain lines.
const PLAIN_EVERY: Duration = Duration::from_secs(3);
/// Time between two drawings on a terminal.
const DRAW_EVERY: Duration = Duration::from_millis(100);

/// Where and how progress is shown.
pub struct Display {
    form: Form,
    /// Said in front of each line when several runs share the screen.
    label: String,
    last: Option<Instant>,
    shown_phase: usize,
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
        Display { form, label: String::new(), last: None, shown_phase: 0 }
    }

    /// Puts `label` in front of what follows.
    pub fn label(&mut self, label: &str) {
        if self.label != label {
            label.clone_into(&mut self.label);
            self.shown_phase = 0;
        }
    }

    /// Shows the run if it is time for it; a new phase is always shown.
    pub fn show(&mut self, look: &mut Look<'_>) {
        let wait = match self.form {
            Form::Bar(_) => DRAW_EVERY,
            Form::Lines => PLAIN_EVERY,
            Form::Silent => return,
        };
        let soon = self.last.is_some_and(|last| last.elapsed() < wait);
        if soon && self.shown_phase == look.progress.phase_number {
            return;
        }
        let unit = look.progress.energy_unit;
        let measured = state(look.measured(), unit);
        let progress = &look.progress;
        self.shown_phase = progress.phase_number;
        let (label, head) = (&self.label, head(progress));
        match &self.form {
            Form::Bar(bar) => {
                let share = progress.share.unwrap_or(0.0).clamp(0.0, 1.0);
                bar.set_position((share * 1000.0) as u64);
                bar.set_prefix(format!("{label}{head}\n{measured}"));
                bar.set_message(percent(progress));
            }
            Form::Lines => {
                let line = format!("{label}{head}  {}  {measured}", percent(progress));
                // A log that cannot be written must not stop the run.
                let _ = writeln!(std::io::stderr(), "{line}");
            }
            Form::Silent => {}
        }
        self.last = Some(Instant::now());
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

fn head(p: &Progress) -> String {
    let rate =
        if p.steps_per_second > 0.0 { grouped(p.steps_per_second as u64) } else { "?".to_owned() };
    format!(
        "phase {}/{} {:?}  step {}  t = {}  dt = {}  {rate} steps/s",
        p.phase_number.min(p.phases),
        p.phases,
        p.phase,
        grouped(p.step),
        si(p.time, "s"),
        si(p.dt, "s"),
    )
}

fn state(m: &Measured, energy_unit: &str) -> String {
    let residual = m.residual.map_or("?".to_owned(), |share| ratio(100.0 * share));
    format!(
        "contacts {}  kinetic {}  unbalanced {}  energy residual {residual} %  worst overlap {} %",
        grouped(m.contacts as u64),
        si(m.kinetic, energy_unit),
        ratio(m.unbalanced),
        ratio(100.0 * m.worst_overlap),
    )
}

fn percent(p: &Progress) -> String {
    let share = p.share.map_or("  ? %".to_owned(), |s| format!("{:3.0} %", 100.0 * s));
    let eta = p.remaining.map_or("?".to_owned(), duration);
    format!("{share}  ETA {eta}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lines_say_what_matters() {
        let progress = Progress {
            phase: "excavate".to_owned(),
            phase_number: 2,
            phases: 3,
            share: Some(0.51),
            step: 41_200,
            time: 0.412,
            dt: 1e-5,
            steps_per_second: 6120.4,
            remaining: Some(400.0),
            energy_unit: "J/m",
        };
        let measured = Measured {
            kinetic: 12_400.0,
            residual: Some(3e-4),
            unbalanced: 3.1e-4,
            contacts: 9412,
            worst_overlap: 4e-3,
            fastest: None,
        };
        assert_eq!(
            head(&progress),
            "phase 2/3 \"excavate\"  step 41 200  t = 412 ms  dt = 10 us  6 120 steps/s"
        );
        assert_eq!(
            state(&measured, progress.energy_unit),
            "contacts 9 412  kinetic 12.4 kJ/m  unbalanced 3.1e-4  energy residual 0.03 %  \
             worst overlap 0.4 %"
        );
        assert_eq!(percent(&progress), " 51 %  ETA 6 min 40 s");
        assert_eq!(percent(&Progress::default()), "  ? %  ETA ?");
    }
}
