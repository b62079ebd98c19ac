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
                    if 0.5 * (v0 + value) > threshold {
                        self.sum += time - t0;
                    }
                    self.span += time - t0;
                }
            }
        }
    }

    /// Time and value of the reading, or why there is none.
    fn reading(&self) -> Result<(f64, f64), String> {
        let (end, last) = self.last.ok_or("the field was never read")?;
        match self.check.window.within() {
            Window::Start => self
                .found
                .ok_or_else(|| "the field was never read".to_owned()),
            Window::End | Window::Phase { .. } => Ok((end, last)),
            Window::At(at) => self
                .found
                .ok_or_else(|| format!("the run ended at {end} s, before {at} s")),
            Window::Over { from, to, reduce } => {
                let at = end.min(to);
                let seen = self.high >= self.low || self.high.is_nan();
                if !seen {
                    return Err(format!("the run ended at {end} s, before {from} s"));
                }
                let one = if self.span > 0.0 {
                    self.sum / self.span
                } else {
                    last
                };
                match reduce {
                    Reduce::Max => Ok((at, self.high)),
                    Reduce::Min => Ok((at, self.low)),
                    Reduce::Range => Ok((at, self.high - self.low)),
                    Reduce::Mean => Ok((at, one)),
                    Reduce::Rms if self.span > 0.0 => Ok((at, one.sqrt())),
                    Reduce::Rms => Ok((at, last.abs())),
                    Reduce::FirstBelow(threshold) => self
                        .found
                        .ok_or_else(|| format!("it never came below {threshold}")),
                    Reduce::FirstAbove(threshold) => self
                        .found
                        .ok_or_else(|| format!("it never came above {threshold}")),
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
                at = time;
                result.expected = self.expected_text(time, &unit);
                if let Some(why) = self.no_number(time, value) {
                    result.note = why;
                }
                self.agrees(time, value)
            }
        };
        result.words = self.words(at, result.measured, &unit);
        result.status = match (&self.check.known, agrees) {
            (None, true) => Status::Passed,
            (None, false) => Status::Failed,
            (Some(reason), true) => {
                result.note = format!("passes, but is marked known: {reason}");
                Status::Failed
            }
            (Some(reason), false) => {
                result.note.clone_from(reason);
                if strict {
                    Status::Failed
                } else {
                    Status::Skipped
                }
            }
        };
        result
    }

    fn result_unit(&self) -> &str {
        match self.check.window.within() {
            Window::Over {
                reduce: Reduce::FirstAbove(_) | Reduce::FirstBelow(_),
                ..
            } => "s",
            Window::Over {
                reduce: Reduce::ShareAbove(_),
                ..
            } => "-",
            Window::Start
            | Window::At(_)
            | Window::End
            | Window::Over { .. }
            | Window::Phase { .. } => &self.check.unit,
        }
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
            || difference == 0.0
    }

    /// Why nothing can be compared, if what is expected or what came out is no finite number. An infinite value within an
    /// open bound can: some fields are infinite where there is nothing (`block.crack_distance`).
    fn no_number(&self, time: f64, value: f64) -> Option<String> {
        let expected = self.expected_at(time).filter(|x| !x.is_finite());
        match (&self.check.expected, expected) {
            (Expected::Formula { formula, .. }, Some(x)) => Some(format!(
                "what is expected is not finite: the formula `{}` gives {x} at t = {time} s",
                formula.text()
            )),
            (_, Some(x)) => Some(format!("what is expected is not finite: {x}")),
            (Expected::Between(..), None) if !value.is_nan() => None,
            (_, None) if value.is_finite() => None,
            (_, None) => Some(format!("what came out is not finite: {value}")),
        }
    }

    fn expected_text(&self, time: f64, unit: &str) -> String {
        let unit = if unit == "-" {
            String::new()
        } else {
            format!(" {unit}")
        };
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
        let relative = self
            .check
            .relative
            .map(|r| format!("{} relative", number(r, MOST_GIVEN)));
        let absolute = self.check.absolute.map(|a| shown.text(a, MOST_GIVEN));
        let allowed: Vec<String> = relative.into_iter().chain(absolute).collect();
        if !allowed.is_empty() {
            words.push_str(&format!(" ({})", allowed.join(" or ")));
        }
        words
    }

    fn tolerance(&self, unit: &str) -> String {
        let unit = if unit == "-" {
            String::new()
        } else {
            format!(" {unit}")
        };
        let relative = self.check.relative.map(|r| format!("{r} relative"));
        let absolute = self.check.absolute.map(|a| format!("{a}{unit}"));
        relative
            .into_iter()
            .chain(absolute)
            .collect::<Vec<_>>()
            .join(" or ")
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
mod tests {
    use super::*;
    use crate::dynamics::Formula;
    use crate::plan::Gauge;

    fn check(window: Window, expected: Expected) -> Check {
        Check {
            name: "c".to_owned(),
            gauge: Gauge {
                field: "block.displacement.x".to_owned(),
                of: vec![0],
                ..Gauge::default()
            },
            unit: "m".to_owned(),
            shown: None,
            window,
            expected,
            relative: None,
            absolute: Some(1e-9),
            known: None,
        }
    }

    /// Feeds x(t) = 10 t^2 at 0, 0.1, … 1.
    fn fed(window: Window, expected: Expected) -> CheckResult {
        let mut watch = Watch::new(check(window, expected));
        for i in 0..=10 {
            let t = f64::from(i) * 0.1;
            if watch.wants(t) {
                watch.observe(t, 10.0 * t * t);
            }
        }
        watch.finish("s.toml", "", false)
    }

    fn over(reduce: Reduce) -> Window {
        Window::Over {
            from: 0.2,
            to: 0.8,
            reduce,
        }
    }

    #[test]
    fn moments_are_found_and_interpolated() {
        for (window, value) in [
            (Window::Start, 0.0),
            (Window::End, 10.0),
            (Window::At(0.5), 2.5),
            (Window::At(0.55), 0.5 * (2.5 + 3.6)),
            (over(Reduce::Max), 6.4),
            (over(Reduce::Min), 0.4),
            (over(Reduce::Range), 6.0),
            (over(Reduce::FirstAbove(3.0)), 0.6),
            (over(Reduce::FirstBelow(1.0)), 0.2),
            // Trapezoids on x^4: mean of 100 t^4 over 0.2 to 0.8, as summed.
            (over(Reduce::Rms), root_mean_square()),
            // Trapezoids on x^2: exact mean 2.8 plus h^2/12 (f'(b) - f'(a))/(b - a) = 1/60.
            (over(Reduce::Mean), 2.8 + 1.0 / 60.0),
            (over(Reduce::ShareAbove(3.0)), 0.3 / 0.6),
        ] {
            let result = fed(window, Expected::Value(value));
            assert_eq!(result.status, Status::Passed, "{window:?} {result:?}");
        }
    }

    /// Root of the mean of (10 t^2)^2 at 0.2, 0.3, ... 0.8 by trapezoids.
    fn root_mean_square() -> f64 {
        let squares: Vec<f64> = (2..=8).map(|i| 0.01 * f64::from(i * i * i * i)).collect();
        let ends = 0.5 * (squares[0] + squares[6]);
        ((ends + squares[1..6].iter().sum::<f64>()) / 6.0).sqrt()
    }

    #[test]
    fn words_are_in_the_unit_of_the_scene() {
        let words = |unit: &str, given: Option<(&str, f64)>, expected, relative, value| {
            let mut one = check(Window::End, expected);
            unit.clone_into(&mut one.unit);
            (one.absolute, one.relative) = (None, relative);
            one.shown = given.map(|(unit, one)| Shown {
                unit: unit.to_owned(),
                one,
            });
            let mut watch = Watch::new(one);
            watch.observe(1.0, value);
            watch.finish("", "", false).words
        };
        let deg = std::f64::consts::PI / 180.0;
        let said = words(
            "rad",
            Some(("deg", deg)),
            Expected::Value(2.0 * deg),
            Some(0.01),
            2.01 * deg,
        );
        assert_eq!(said, "2.01 deg, expected 2 deg (0.01 relative)");
        let said = words(
            "rad",
            None,
            Expected::Value(2.0 * deg),
            Some(1e-6),
            2.0 * deg,
        );
        assert_eq!(said, "2 deg, expected 2 deg (1e-6 relative)");
        let said = words(
            "Pa",
            None,
            Expected::Between(1.0e6, 2.5e6),
            None,
            1.234_567e6,
        );
        assert_eq!(said, "1.2346 MPa, expected 1 to 2.5 MPa");
        let band = Expected::Between(f64::NEG_INFINITY, 300.0);
        let said = words("N", Some(("kN", 1e3)), band, None, 250.0);
        assert_eq!(said, "0.25 kN, expected at most 0.3 kN");
    }

    #[test]
    fn a_reading_that_never_came_fails_with_its_reason() {
        let result = fed(Window::At(2.0), Expected::Value(0.0));
        assert_eq!((result.status, result.measured), (Status::Failed, None));
        assert!(
            result.note.contains("ended at 1 s, before 2 s"),
            "{}",
            result.note
        );
        let result = fed(over(Reduce::FirstAbove(99.0)), Expected::Value(0.0));
        assert!(
            result.note.contains("never came above 99"),
            "{}",
            result.note
        );
        let late = Window::Over {
            from: 3.0,
            to: 4.0,
            reduce: Reduce::Max,
        };
        assert_eq!(fed(late, Expected::Value(0.0)).status, Status::Failed);
    }

    #[test]
    fn what_is_not_a_number_never_agrees() {
        for window in [
            Window::End,
            over(Reduce::Max),
            over(Reduce::Min),
            over(Reduce::Mean),
        ] {
            let mut watch = Watch::new(check(window, Expected::Between(-1e300, 1e300)));
            for (t, v) in [(0.2, 0.0), (0.3, f64::NAN), (0.4, 1.0), (0.8, f64::NAN)] {
                watch.observe(t, v);
            }
            assert_eq!(
                watch.finish("", "", false).status,
                Status::Failed,
                "{window:?}"
            );
        }
    }

    #[test]
    fn what_is_infinite_agrees_with_nothing_but_an_open_bound() {
        let result = |expected: Expected, relative, value: f64| {
            let mut one = check(Window::End, expected);
            (one.relative, one.absolute) = (relative, Some(1.0));
            let mut watch = Watch::new(one);
            watch.observe(0.5, value);
            watch.finish("", "", false)
        };
        let formula = |text: &str| Expected::Formula {
            formula: Formula::new(text, &["t"]).unwrap(),
            names: Vec::new(),
        };
        // The share of an infinite value was infinite too, and every difference within it.
        let said = result(formula("exp(1000)"), Some(1e-6), 2.0);
        assert_eq!(said.status, Status::Failed, "{said:?}");
        assert!(
            said.note.contains("`exp(1000)` gives inf at t = 0.5 s"),
            "{}",
            said.note
        );
        let said = result(formula("sqrt(t - 1)"), Some(1e-6), 2.0);
        assert!(said.note.contains("gives NaN"), "{}", said.note);
        let said = result(Expected::Value(1.0), Some(1e-6), f64::INFINITY);
        assert_eq!(said.status, Status::Failed, "{said:?}");
        assert!(said.note.contains("what came out"), "{}", said.note);
        let open = Expected::Between(1.0, f64::INFINITY);
        let said = result(open.clone(), None, f64::INFINITY);
        assert_eq!((said.status, &said.note[..]), (Status::Passed, ""));
        let said = result(open, None, f64::NAN);
        assert_eq!(said.status, Status::Failed, "{said:?}");
        assert!(said.note.contains("NaN"), "{}", said.note);
    }

    #[test]
    fn tables_formulas_and_bands() {
        let formula = Formula::new("0.5*g*t^2", &["t", "g"]).unwrap();
        let names = vec![("g".to_owned(), 20.0)];
        let expected = Expected::Formula { formula, names };
        assert_eq!(fed(Window::At(0.5), expected).status, Status::Passed);
        let table = Expected::Table {
            t: vec![0.0, 1.0],
            v: vec![0.0, 5.0],
        };
        assert_eq!(fed(Window::At(0.5), table).status, Status::Passed);
        assert_eq!(
            fed(Window::End, Expected::Between(9.0, 11.0)).status,
            Status::Passed
        );
        assert_eq!(
            fed(Window::End, Expected::Between(9.0, 9.5)).status,
            Status::Failed
        );
        assert!(interpolate(&[], &[], 1.0).is_nan());
        assert_eq!(interpolate(&[0.0, 1.0], &[2.0, 3.0], 9.0), 3.0);
        assert_eq!(interpolate(&[0.0, 1.0], &[2.0, 3.0], -9.0), 2.0);
    }

    #[test]
    fn relative_or_absolute_is_enough() {
        let mut one = check(Window::End, Expected::Value(9.95));
        one.absolute = None;
        one.relative = Some(0.01);
        let mut watch = Watch::new(one.clone());
        watch.observe(1.0, 10.0);
        assert_eq!(watch.finish("", "", false).status, Status::Passed);
        one.relative = Some(0.001);
        one.absolute = Some(0.1);
        let mut watch = Watch::new(one);
        watch.observe(1.0, 10.0);
        assert_eq!(watch.finish("", "", false).status, Status::Passed);
    }

    #[test]
    fn known_failures_are_skipped_and_unexpected_passes_fail() {
        let result = |expected: f64, strict| {
            let mut one = check(Window::End, Expected::Value(expected));
            one.known = Some("no reason at all".to_owned());
            let mut watch = Watch::new(one);
            watch.observe(1.0, 10.0);
            watch.finish("", "", strict)
        };
        assert_eq!(result(9.0, false).status, Status::Skipped);
        assert_eq!(result(9.0, true).status, Status::Failed);
        let surprise = result(10.0, false);
        assert_eq!(surprise.status, Status::Failed);
        assert!(surprise.note.contains("marked known"), "{}", surprise.note);
    }
}
