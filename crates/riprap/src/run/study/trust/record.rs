//! Answers as tables, words and files.

use std::path::Path;

use super::{Answer, Cause, Result};
use crate::plan::shown::digits_for;
use crate::record::{OutputError, write_whole};

/// The table of the results, in the folder of the study.
pub const TABLE: &str = "trust.csv";
/// The table of the runs.
pub const TRIALS: &str = "trials.csv";
/// All numbers.
pub const SUMMARY: &str = "trust.json";

/// Digits of an error.
const ERROR_DIGITS: usize = 2;
/// Digits of a value whose error is not known.
const UNKNOWN_DIGITS: usize = 4;

impl Result {
    /// A value in the unit of the scene, with the digits that the error leaves.
    #[must_use]
    pub fn text(&self, value: f64) -> String {
        let share = self.error / value.abs();
        self.shown.text(value, if share.is_finite() { digits_for(share) } else { ERROR_DIGITS })
    }

    /// The error in the unit of the scene.
    #[must_use]
    pub fn error_text(&self) -> String {
        self.shown.text(self.error, ERROR_DIGITS)
    }

    /// Share of a cause in the error, 0 to 1.
    #[must_use]
    pub fn share(&self, cause: Cause) -> Option<f64> {
        let part = self.parts.iter().find(|part| part.cause == cause)?;
        let all: f64 = self.parts.iter().map(|part| part.error).sum();
        Some(if all > 0.0 { part.error / all } else { 0.0 })
    }
}

impl Answer {
    /// The results as CSV, SI: value, error, ends of the interval, what each cause adds, what the scene expects.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn table(&self) -> std::result::Result<Vec<u8>, csv::Error> {
        let mut out = csv::Writer::from_writer(Vec::new());
        let heads = ["result", "unit", "as_run", "value", "error", "low", "high"];
        let causes = Cause::ALL.map(|cause| format!("error_{}", cause.word()));
        let more = ["order_step", "order_size", "samples", "expected", "inside", "advice"];
        out.write_record(heads.into_iter().chain(causes.iter().map(String::as_str)).chain(more))?;
        for result in &self.results {
            let number = |value: f64| value.to_string();
            let maybe = |value: Option<f64>| value.map_or_else(String::new, number);
            let part = |cause: Cause| result.parts.iter().find(|part| part.cause == cause);
            let mut row = vec![result.name.clone(), result.unit.clone()];
            let (value, error) = (result.value, result.error);
            row.extend([result.as_run, value, error, value - error, value + error].map(number));
            row.extend(Cause::ALL.map(|cause| maybe(part(cause).map(|part| part.error))));
            row.extend([Cause::Step, Cause::Size].map(|of| maybe(part(of).and_then(|p| p.order))));
            row.push(result.chaotic.map_or_else(String::new, |of| of.samples.to_string()));
            row.push(maybe(result.expected));
            row.push(
                result.holds().map_or("", |holds| if holds { "yes" } else { "no" }).to_owned(),
            );
            row.push(result.advice.clone());
            out.write_record(row)?;
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }

    /// The runs as CSV, SI.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn trials_table(&self) -> std::result::Result<Vec<u8>, csv::Error> {
        let mut out = csv::Writer::from_writer(Vec::new());
        let heads = ["cause", "factor", "steps", "seconds", "note"];
        let names = self.results.iter().map(|result| result.name.as_str());
        out.write_record(heads.into_iter().chain(names))?;
        for trial in &self.trials {
            let cause = trial.cause.map_or("as it stands", Cause::word);
            let mut row = vec![cause.to_owned(), trial.factor.to_string()];
            row.extend([trial.steps.to_string(), format!("{:.2}", trial.seconds)]);
            row.push(trial.note.clone());
            let value = |value: &Option<f64>| value.map_or_else(String::new, |v| v.to_string());
            row.extend(trial.values.iter().map(value));
            out.write_record(row)?;
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }

    /// Writes both tables and all numbers into `folder`.
    ///
    /// # Errors
    /// The disk.
    pub fn write(&self, folder: &Path) -> std::result::Result<(), OutputError> {
        let at =
            |name: &str, source: std::io::Error| OutputError { path: folder.join(name), source };
        let table = self.table().map_err(|wrong| at(TABLE, wrong.into()))?;
        write_whole(&folder.join(TABLE), &table)?;
        let trials = self.trials_table().map_err(|wrong| at(TRIALS, wrong.into()))?;
        write_whole(&folder.join(TRIALS), &trials)?;
        let text = self.json().and_then(|json| serde_json::to_string_pretty(&json));
        let text = text.map_err(|wrong| at(SUMMARY, std::io::Error::other(wrong.to_string())))?;
        write_whole(&folder.join(SUMMARY), text.as_bytes())
    }

    /// All numbers, with what a reader is shown of each result.
    fn json(&self) -> serde_json::Result<serde_json::Value> {
        let mut json = serde_json::to_value(self)?;
        let results = json["results"].as_array_mut().into_iter().flatten();
        for (result, of) in results.zip(&self.results).filter(|(_, of)| of.error.is_finite()) {
            result["shown"] = format!("{} +- {}", of.text(of.value), of.error_text()).into();
            result["shares"] = of.shares().into();
        }
        Ok(json)
    }

    /// `sliding distance: 0.7071 m +- 0.0003 m (step 80 %, stiffness 20 %)`, a line a result, with its advice below.
    #[must_use]
    pub fn words(&self) -> String {
        let mut text = String::new();
        for result in &self.results {
            text.push_str(&result.words());
            text.push('\n');
        }
        for (cause, why) in &self.left_out {
            text.push_str(&format!("not varied: {} ({why})\n", cause.word()));
        }
        text
    }
}

impl Result {
    /// The result in words.
    #[must_use]
    pub fn words(&self) -> String {
        if !self.as_run.is_finite() {
            return format!("{}: {}", self.name, self.advice);
        }
        if !self.error.is_finite() {
            let value = self.shown.text(self.as_run, UNKNOWN_DIGITS);
            return format!("{}: {value}\n  {}", self.name, self.advice);
        }
        let mut text = format!("{}: {} +- {}", self.name, self.text(self.value), self.error_text());
        if let Some(spread) = self.chaotic {
            text.push_str(&format!(
                " (distribution of {} runs: {} to {})",
                spread.samples,
                self.text(spread.least),
                self.text(spread.largest)
            ));
        }
        let shares = self.shares();
        if !shares.is_empty() {
            text.push_str(&format!(" ({shares})"));
        }
        if let (Some(expected), Some(holds)) = (self.expected, self.holds()) {
            // The closed form of a check may be that of another model, to its tolerance.
            let word = match (holds, (self.as_run - expected).abs() <= self.tolerance) {
                (true, _) => "inside",
                (false, true) => "outside, within the tolerance of the check",
                (false, false) => "OUTSIDE",
            };
            text.push_str(&format!("; expected {}: {word}", self.text(expected)));
        }
        if !self.advice.is_empty() {
            text.push_str(&format!("\n    {}", self.advice));
        }
        text
    }

    /// `step 80 %, order 2.0; stiffness 20 %`: what the causes add to the error.
    #[must_use]
    pub fn shares(&self) -> String {
        let shares = self.parts.iter().filter(|part| part.error > 0.0).map(|part| {
            let share = 100.0 * self.share(part.cause).unwrap_or(0.0);
            let order = part.order.map_or_else(String::new, |order| format!(", order {order:.1}"));
            format!("{} {share:.0} %{order}", part.cause.word())
        });
        shares.collect::<Vec<String>>().join("; ")
    }
}
