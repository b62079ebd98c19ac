//! Answers as words and tables.

use std::path::Path;

use super::rules::{Answer, Trial};
use super::verdict::Mechanism;
use crate::plan::shown::digits_for;
use crate::record::{OutputError, write_whole};
use crate::run::study::bracket::State;
use crate::scenario::read::with_unit;

/// Blocks of the mechanism that are named in words.
const NAMED: usize = 5;

impl State {
    /// As it is written.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Failing => "failing",
            Self::Undecided => "undecided",
        }
    }
}

impl Answer {
    /// Whether a limit was found.
    #[must_use]
    pub fn is_found(&self) -> bool {
        self.stable_at.is_some() && self.fails_at.is_some()
    }

    /// A value as it is shown: with its unit, and one digit more than the width has.
    #[must_use]
    pub fn text(&self, value: f64) -> String {
        if self.quantity.is_some() {
            return self.shown.text(value, digits_for(self.width / value.abs()));
        }
        let mut digits = 1;
        let mut width = self.width;
        while width < 1.0 && digits < 9 {
            width *= 10.0;
            digits += 1;
        }
        format!("{value:.digits$}")
    }

    /// The answer in one line.
    #[must_use]
    pub fn words(&self) -> String {
        let ends = [self.stable_at, self.fails_at].map(|end| end.map(|value| self.text(value)));
        if let Some(key) = &self.quantity {
            return match ends {
                [Some(stable), Some(failing)] => {
                    format!("{key}: stable at {stable}, fails at {failing}")
                }
                [Some(stable), None] if self.undecided => {
                    format!("{key}: stable at {stable}, and no other trial was conclusive")
                }
                [None, Some(failing)] if self.undecided => {
                    format!("{key}: fails at {failing}, and no other trial was conclusive")
                }
                [Some(_), None] => format!("{key}: no failure in this range"),
                [None, Some(_)] => format!("{key}: not stable anywhere in this range"),
                [None, None] => format!("{key}: unknown, no trial was conclusive"),
            };
        }
        match ends {
            [Some(low), Some(high)] => format!("factor of safety: {low} .. {high}"),
            [Some(low), None] if self.undecided => {
                format!("factor of safety: above {low}; no trial at a larger one was conclusive")
            }
            [None, Some(high)] if self.undecided => {
                format!("factor of safety: below {high}; no trial at a smaller one was conclusive")
            }
            [Some(low), None] => format!(
                "factor of safety: above {low}: the model is stable with almost no strength in these interfaces"
            ),
            [None, Some(high)] => {
                format!("factor of safety: below {high}: the model fails at every strength tried")
            }
            [None, None] => "factor of safety: unknown, no trial was conclusive".to_owned(),
        }
    }

    /// What moves, and how.
    #[must_use]
    pub fn mechanism_words(&self) -> Option<String> {
        let count = self.moving.len();
        let (noun, s) = if count == 1 { ("block", "s") } else { ("blocks", "") };
        let how = match self.mechanism? {
            Mechanism::Sliding => format!("slide{s} or fall{s} without rotation"),
            Mechanism::Turning => format!("turn{s}"),
            Mechanism::Both => format!("slide{s} and rotate{s}"),
        };
        let names: Vec<&str> =
            (self.moving.iter().take(NAMED)).map(|(name, _)| name.as_str()).collect();
        let more =
            if count > NAMED { format!(" and {} more", count - NAMED) } else { String::new() };
        Some(format!("mechanism: {count} {noun} {how}: {}{more}", names.join(", ")))
    }

    /// How far a block went before it stood, where that is more than what counts as moved.
    #[must_use]
    pub fn far_words(&self) -> Option<String> {
        let at = |trial: &&Trial| trial.far && Some(trial.value) == self.stable_at;
        let trial = self.trials.iter().rfind(at)?;
        let (value, moved) = (self.text(trial.value), with_unit(trial.moved, "m"));
        Some(format!(
            "at {value} block `{}` came to rest only after {moved}, more than what counts as moved (`--moved`): it is stable at that \
             displacement, not before",
            trial.block
        ))
    }

    /// How many points of joints had failed before the first trial that counts.
    #[must_use]
    pub fn lost_words(&self) -> Option<String> {
        // Of a factor the first one, from which the others go on; of a quantity each begins anew.
        let trial = match self.quantity {
            None => self.trials.first(),
            Some(_) => self.trials.iter().find(|trial| Some(trial.value) == self.stable_at),
        };
        let lost = trial?.lost_before;
        let s = if lost == 1 { "" } else { "s" };
        (lost > 0).then(|| {
            format!(
                "{lost} point{s} of joints had failed before the first trial, in the phases of the scene, and what they lost is not in this answer: \
                 gravity that is there at once breaks joints that bear it when it comes slowly; give the first phase a `gravity_ramp`"
            )
        })
    }

    /// Writes `safety.json` and `safety.csv` into `folder`.
    ///
    /// # Errors
    /// The disk.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        let json = format!("{}\n", serde_json::json!(self));
        for (name, text) in [("safety.json", json), ("safety.csv", self.table())] {
            write_whole(&folder.join(name), text.as_bytes())?;
        }
        Ok(())
    }

    /// The trials as CSV: value (SI), state, displacement, block, unbalanced ratio, steps, seconds.
    #[must_use]
    pub fn table(&self) -> String {
        let head = match (&self.quantity, self.unit.as_str()) {
            (None, _) => "factor".to_owned(),
            (Some(_), "") => "value".to_owned(),
            (Some(_), unit) => format!("value ({unit})"),
        };
        let mut text = format!("{head},state,moved (m),block,unbalanced,steps,seconds\n");
        for t in &self.trials {
            text.push_str(&format!(
                "{},{},{:e},{},{:e},{},{:.3}\n",
                t.value,
                t.state.word(),
                t.moved,
                t.block,
                t.unbalanced,
                t.steps,
                t.seconds
            ));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::shown::Shown;

    #[test]
    fn an_answer_claims_no_more_than_was_tried() {
        let answer = |stable_at, fails_at, undecided, quantity: bool| Answer {
            quantity: quantity.then(|| "depth".to_owned()),
            unit: String::new(),
            shown: Shown::si(""),
            width: 0.01,
            stable_at,
            fails_at,
            undecided,
            trials: Vec::new(),
            moving: Vec::new(),
            mechanism: None,
        };
        let words =
            |stable, fails, undecided, quantity| answer(stable, fails, undecided, quantity).words();
        assert!(words(Some(64.0), None, false, false).contains("almost no strength"));
        assert!(
            words(Some(1.0), None, true, false).contains("no trial at a larger one was conclusive")
        );
        assert!(words(None, Some(0.1), false, false).contains("at every strength tried"));
        assert!(words(None, Some(1.0), true, false).contains("no trial at a smaller one"));
        assert!(words(Some(1.0), None, false, true).contains("no failure in this range"));
        assert!(words(Some(1.0), None, true, true).contains("no other trial was conclusive"));
    }
}
