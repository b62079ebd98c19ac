//! A check while the run goes on: takes values, reduces them, compares.

use serde::{Deserialize, Serialize};

use super::{CheckResult, Status};
use crate::plan::shown::{Shown, digits_for, number};
use crate::plan::{Check, Expected, Reduce, Window};

/// Digits of numbers that the author of the scene gave: enough to give them back.
const MOST_GIVEN: usize = 7;

/// A check while the run goes on; part of checkpoints.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Watch {
    check: Check,
    /// Model time before which the field need not be read again, s; kept by whoever reads it.
    pub next: f64,
    last: Option<(f64, f64)>,
    first_time: f64,
    sum: f64,
    span: f64,
    low: f64,
    high: f64,
    found: Option<(f64, f64)>,
}

impl Watch {
    /// Nothing seen yet.
    #[must_use]
    pub fn new(check: Check) -> Self {
        Self {
            check,
            next: 0.0,
            last: None,
            first_time: f64::NAN,
            sum: 0.0,
            span: 0.0,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            found: None,
        }
    }

    /// The check.
    #[must_use]
    pub fn check(&self) -> &Check {
        &self.check
    }

    /// Whether a value at `time` can still matter; lets the loop leave out reading the field.
    #[must_use]
    pub fn wants(&self, time: f64) -> bool {
        match self.check.window.within() {
            Window::Start => self.last.is_none(),
            Window::At(_) => self.found.is_none(),
            Window::End | Window::Phase { .. } => true,
            Window::Over { from, to, .. } => time >= from && self.last.is_none_or(|(t, _)| t < to),
        }
    }

    /// Takes the value of the field at a model time; times ascend.
    pub fn observe(&mut self, time: f64, value: f64) {
        let before = self.last.replace((time, value));
        if before.is_none() {
            self.first_time = time;
        }
        match self.check.window.within() {
            Window::Start => self.found = self.found.or(Some((time, value))),
            Window::At(at) => {
                // A state that misses the instant by round-off alone is taken for it, not the one after it.
                if self.found.is_none() && time >= at - 1e-12 * at.abs() {
                    let there = match before {
                        Some((t0, v0)) if time > at && time > t0 => {
                            v0 + (value - v0) * (at - t0) / (time - t0)
                        }
                        _ => value,
                    };
                    self.found = Some((at, there));
                }
            }
            Window::End | Window::Phase { .. } => {}
            Window::Over { from, to, reduce } => {
                if time >= from && time <= to {
                    self.reduce(reduce, before.filter(|(t, _)| *t >= from), time, value);
                }
            }
        }
    }

    fn reduce(&mut self, reduce: Reduce, before: Option<(f64, f64)>, time: f64, value: f64) {
        // A value that is no number must show in every reduction, not vanish in a comparison.
        if value.is_nan() {
            self.low = f64::NAN;
            self.high = f64::NAN;
        }
        if value < self.low {
            self.low = value;
        }
        if value > self.high {
            self.high = value;
        }
        match reduce {
            Reduce::Max | Reduce::Min | Reduce::Range => {}
            Reduce::Mean => {
                if let Some((t0, v0)) = before {
                    // Steps differ in length, so that a mean of readings would not be one over time.
                    self.sum += 0.5 * (v0 + value) * (time - t0);
                    self.span += time - t0;
                }
            }
            Reduce::Rms => {
                if let Some((t0, v0)) = before {
                    self.sum += 0.5 * (v0 * v0 + value * value) * (time - t0);
                    self.span += time - t0;
                }
            }
            Reduce::FirstBelow(threshold) => {
                if value < threshold && self.found.is_none() {
                    self.found = Some((time, time));
                }
            }
            Reduce::FirstAbove(threshold) => {
                if value > threshold && self.found.is_none() {
                    self.found = Some((time, time));
                }
            }
            Reduce::ShareAbove(threshold) => {
                if let Some((t0, v0)) = before {
                    // Of the span between two readings the middle decides.
                    if 0.5 * (v0 + value) > threshold {
                        self.sum += time - t0;
                    }
                    self.span += time - t0;
                }
            }
        }
    }

    /// Time between two readings of an interval where not every step was read, s: what lies between was not seen.
    fn rhythm(&self) -> Option<f64> {
        let (time, _) = self.last?;
        let over = matches!(self.check.window.within(), Window::Over { .. });
        (over && self.next > time).then_some(self.next - time)
    }

    /// Time and value of the reading, or why there is none.
    fn reading(&self) -> Result<(f64, f64), String> {
        let (end, last) = self.last.ok_or("the field was never read")?;
        match self.check.window.within() {
            Window::Start => self.found.ok_or_else(|| "the field was never read".to_owned()),
            Window::End | Window::Phase { .. } => Ok((end, last)),
            Window::At(at) => {
                self.found.ok_or_else(|| format!("the run ended at {end} s, before {at} s"))
            }
            Window::Over { from, to, reduce } => {
                let at = end.min(to);
                let seen = self.high >= self.low || self.high.is_nan();
                if !seen {
                    return Err(format!("the run ended at {end} s, before {from} s"));
                }
                let one = if self.span > 0.0 { self.sum / self.span } else { last };
                match reduce {
                    Reduce::Max => Ok((at, self.high)),
                    Reduce::Min => Ok((at, self.low)),
                    Reduce::Range => Ok((at, self.high - self.low)),
                    Reduce::Mean => Ok((at, one)),
                    Reduce::Rms if self.span > 0.0 => Ok((at, one.sqrt())),
                    Reduce::Rms => Ok((at, last.abs())),
                    Reduce::FirstBelow(threshold) => {
                        self.found.ok_or_else(|| format!("it never fell below {threshold}"))
                    }
                    Reduce::FirstAbove(threshold) => {
                        self.found.ok_or_else(|| format!("it never rose above {threshold}"))
                    }
                    Reduce::ShareAbove(_) => Ok((at, if self.span > 0.0 { one } else { 0.0 })),
                }
            }
        }
    }

    /// Compares. `scene` and `case` are only passed on; `strict` counts known failures as failed.
    #[must_use]
    pub fn finish(&self, scene: &str, case: &str, strict: bool) -> CheckResult {
        let unit = self.result_unit().to_owned();
        let mut result = CheckResult {
            scene: scene.to_owned(),
            case: case.to_owned(),
            check: self.check.name.clone(),
            status: Status::Failed,
            measured: None,
            target: None,
            expected: String::new(),
            tolerance: self.tolerance(&unit),
            unit: unit.clone(),
            words: String::new(),
            note: String::new(),
        };
        let mut at = f64::NAN;
        let agrees = match self.reading() {
            Err(why) => {
                result.note = why;
                result.expected = self.expected_text(f64::NAN, &unit);
                false
            }
            Ok((time, value)) => {
                result.measured = Some(value);
                result.target = self.expected_at(time);
                at = time;
                result.expected = self.expected_text(time, &unit);
                if let Some(why) = self.no_number(time, value) {
                    result.note = why;
                }
                self.agrees(time, value)
            }
        };
        result.words = self.words(at, result.measured, &unit);
        if let Some(rhythm) = self.rhythm() {
            let every = Shown::suited("s", rhythm).text(rhythm, 2);
            result.words.push_str(&format!("; read every {every}"));
        }
        result.status = match (&self.check.known, agrees) {
            (None, true) => Status::Passed,
            (None, false) => Status::Failed,
            (Some(reason), true) => {
                result.note = format!("passes, but is marked as a known failure: {reason}");
                Status::Failed
            }
            (Some(reason), false) => {
                result.note.clone_from(reason);
                if strict { Status::Failed } else { Status::Skipped }
            }
        };
        result
    }

    fn result_unit(&self) -> &str {
        self.check.window.unit(&self.check.unit)
    }

    fn expected_at(&self, time: f64) -> Option<f64> {
        match &self.check.expected {
            Expected::Value(value) => Some(*value),
            Expected::Formula { formula, names } => {
                let mut values: Vec<(&str, f64)> = vec![("t", time)];
                values.extend(names.iter().map(|(name, value)| (name.as_str(), *value)));
                Some(formula.value(&values))
            }
            Expected::Table { t, v } => Some(interpolate(t, v, time)),
            Expected::Between(..) => None,
        }
    }

    fn agrees(&self, time: f64, value: f64) -> bool {
        if let Expected::Between(low, high) = self.check.expected {
            return value >= low && value <= high;
        }
        let Some(expected) = self.expected_at(time) else {
            return false;
        };
        if !value.is_finite() || !expected.is_finite() {
            // A share of an infinite value allows every difference.
            return false;
        }
        let difference = (value - expected).abs();
        self.check
            .relative
            .is_some_and(|r| difference <= r * expected.abs())
            || self.check.absolute.is_some_and(|a| difference <= a)
            // A check with neither tolerance asks for equality.
            || difference == 0.0
    }

    /// Why nothing can be compared, if what is expected or what came out is no finite number. An infinite value within an
    /// open bound can: some fields are infinite where there is nothing (`block.crack_distance`).
    fn no_number(&self, time: f64, value: f64) -> Option<String> {
        let expected = self.expected_at(time).filter(|x| !x.is_finite());
        match (&self.check.expected, expected) {
            (Expected::Formula { formula, .. }, Some(x)) => Some(format!(
                "the expected value is not finite: the formula `{}` gives {x} at t = {time} s",
                formula.text()
            )),
            (_, Some(x)) => Some(format!("the expected value is not finite: {x}")),
            (Expected::Between(..), None) if !value.is_nan() => None,
            (_, None) if value.is_finite() => None,
            (_, None) => Some(format!("the result is not finite: {value}")),
        }
    }

    fn expected_text(&self, time: f64, unit: &str) -> String {
        let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
        match (&self.check.expected, self.expected_at(time)) {
            (Expected::Between(low, high), _) => format!("{low} to {high}{unit}"),
            (_, Some(value)) if value.is_finite() => format!("{value:.6e}{unit}"),
            (Expected::Formula { .. } | Expected::Table { .. } | Expected::Value(_), _) => {
                String::new()
            }
        }
    }

    /// `40.02 deg, expected 40 deg (0.01 relative)`.
    fn words(&self, time: f64, measured: Option<f64>, unit: &str) -> String {
        let expected = self.expected_at(time).filter(|value| value.is_finite());
        let size = match self.check.expected {
            Expected::Between(low, high) if high.is_finite() => low.abs().max(high.abs()),
            Expected::Between(low, _) => low.abs(),
            Expected::Value(_) | Expected::Formula { .. } | Expected::Table { .. } => {
                expected.or(measured).unwrap_or(0.0).abs()
            }
        };
        let of_field = unit == self.check.unit;
        let given = self.check.shown.clone().filter(|_| of_field);
        let shown = given.unwrap_or_else(|| Shown::suited(unit, size));
        let share = self.check.absolute.map(|a| a / size);
        let tolerance = match (share.filter(|s| s.is_finite()), self.check.relative) {
            (Some(a), Some(r)) => a.min(r),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => f64::NAN,
        };
        let digits = digits_for(tolerance);
        let mut words = measured.map_or_else(String::new, |v| shown.text(v, digits));
        let expected = match (&self.check.expected, expected) {
            (Expected::Between(low, high), _) => Some(match (low.is_finite(), high.is_finite()) {
                (true, false) => format!("at least {}", shown.text(*low, MOST_GIVEN)),
                (false, true) => format!("at most {}", shown.text(*high, MOST_GIVEN)),
                (true, true) | (false, false) => format!(
                    "{} to {}",
                    shown.number(*low, MOST_GIVEN),
                    shown.text(*high, MOST_GIVEN)
                ),
            }),
            (_, Some(value)) => Some(shown.text(value, digits)),
            (Expected::Value(_) | Expected::Formula { .. } | Expected::Table { .. }, None) => None,
        };
        if let Some(expected) = expected {
            let comma = if words.is_empty() { "" } else { ", " };
            words.push_str(&format!("{comma}expected {expected}"));
        }
        let relative = self.check.relative.map(|r| format!("{} relative", number(r, MOST_GIVEN)));
        let absolute = self.check.absolute.map(|a| shown.text(a, MOST_GIVEN));
        let allowed: Vec<String> = relative.into_iter().chain(absolute).collect();
        if !allowed.is_empty() {
            words.push_str(&format!(" ({})", allowed.join(" or ")));
        }
        words
    }

    fn tolerance(&self, unit: &str) -> String {
        let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
        let relative = self.check.relative.map(|r| format!("{r} relative"));
        let absolute = self.check.absolute.map(|a| format!("{a}{unit}"));
        relative.into_iter().chain(absolute).collect::<Vec<_>>().join(" or ")
    }
}

/// Linear between the points, constant outside; NaN for an empty table.
fn interpolate(t: &[f64], v: &[f64], at: f64) -> f64 {
    let after = t.partition_point(|x| *x <= at);
    match (after.checked_sub(1).and_then(|i| v.get(i)), v.get(after)) {
        (Some(v0), Some(v1)) => {
            let (t0, t1) = (t[after - 1], t[after]);
            v0 + (v1 - v0) * (at - t0) / (t1 - t0)
        }
        (Some(v0), None) => *v0,
        (None, Some(v1)) => *v1,
        (None, None) => f64::NAN,
    }
}

#[cfg(test)]
mod tests;
