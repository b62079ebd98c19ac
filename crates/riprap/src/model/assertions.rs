//! Checks, the search of `[bisect]` and the criterion of `[monte_carlo]`.

use super::builder::Builder;
use super::fields::{FieldUse, Said as Place};
use crate::plan::shown::Shown;
use crate::plan::{Check, Expected, Part, Reduce, Window};
use crate::scenario::language::{self, Criterion, Reduce as Said};
use crate::scenario::quantity::{Any, Raw, When};
use crate::scenario::units::Dim;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Quantity, units};

/// A search for the value of a key at which the scene fails.
#[derive(Clone, Debug)]
pub struct Bisection {
    /// Key to be changed.
    pub key: String,
    /// One end of the interval, SI.
    pub low: f64,
    /// Other end, SI.
    pub high: f64,
    /// Width at which to stop, SI.
    pub tolerance: f64,
    /// SI unit of the three, as it is written behind a number in a scenario; empty for none.
    pub unit: String,
    /// Unit in which the author gave them; `None` for plain numbers.
    pub shown: Option<Shown>,
    /// What to read at the end of each trial; its expectation is the allowed band, so that the scene
    /// fails when the check does.
    pub holds: Check,
    /// Checks of this case on the limit that the search finds.
    pub checks: Vec<Check>,
}

/// What the samples of `[monte_carlo]` are asked.
#[derive(Clone, Debug)]
pub struct Failing {
    /// Passed by samples that hold.
    pub holds: Check,
    /// Checks of this case on the probability of failure.
    pub checks: Vec<Check>,
}

/// The name under which a check asks for the limit that `[bisect]` finds.
pub const LIMIT: &str = "bisect.limit";
/// The name under which a check asks for the probability of failure of `[monte_carlo]`.
pub const PROBABILITY: &str = "monte_carlo.probability";

impl Builder<'_> {
    /// The checks that apply to this case.
    pub(super) fn checks(&mut self) -> Vec<Check> {
        let parsed = self.parsed;
        let mut checks = Vec::new();
        for said in &parsed.scenario.checks {
            let here = said.only.is_empty() || said.only.iter().any(|v| v.as_str() == self.variant);
            // Checks of other cases are resolved too: their errors should not wait for their case.
            if let Some(check) = self.check(said)
                && here
                && parsed.check_applies(said)
            {
                checks.push(check);
            }
        }
        checks
    }

    /// A number of all runs of a study as a field, read once it is found: the limit, in the unit of the interval that is searched, or
    /// the probability of failure.
    fn study_use(&mut self, said: &language::Check) -> Option<(FieldUse, String)> {
        let scenario = &self.parsed.scenario;
        let (name, unit, table) = if said.field.as_str() == LIMIT {
            (LIMIT, scenario.bisect.as_ref().map(searched_unit), "bisect")
        } else {
            let criterion = scenario.monte_carlo.as_ref().and_then(|of| of.fails_when.as_ref());
            (PROBABILITY, criterion.map(|_| String::new()), "monte_carlo")
        };
        let Some(unit) = unit else {
            let lacks =
                if table == "bisect" { "[bisect] table" } else { "`fails_when` in [monte_carlo]" };
            let message =
                format!("check `{}` reads `{name}`, but the scene has no {lacks}", said.name);
            let help = format!("add it; `riprap explain {table}` says what to write");
            self.error_at("field.study", &said.field, message, help);
            return None;
        };
        if said.of.is_some()
            || said.at_point.is_some()
            || said.pins.is_some()
            || said.along.is_some()
            || said.at.is_some()
            || said.reduce.is_some()
        {
            let message = format!("`{name}` is one number of all runs");
            let help = "leave out `of`, `along`, `at`, `over` and `reduce`";
            self.error_at("field.study", &said.field, message, help);
            return None;
        }
        let used = FieldUse {
            field: name.to_owned(),
            unit: "",
            of: Vec::new(),
            groups: Vec::new(),
            at: None,
            along: None,
            against: None,
            pins: None,
            suffixes: &[""],
        };
        Some((used, if unit.is_empty() { "-".to_owned() } else { unit }))
    }

    fn check(&mut self, said: &language::Check) -> Option<Check> {
        let (used, unit) = if [LIMIT, PROBABILITY].contains(&said.field.as_str()) {
            self.study_use(said)?
        } else {
            let place = Place {
                of: said.of.as_ref(),
                point: said.at_point.as_ref(),
                pins: said.pins.as_ref(),
                along: said.along.as_ref(),
                relative_to: said.relative_to.as_ref(),
            };
            let used = self.number(&said.field, place)?;
            let unit = used.unit.to_owned();
            (used, unit)
        };
        let field_unit = unit.clone();
        let unit = unit.as_str();
        if let (Some(reason), true) = (&said.known, said.exact) {
            let message = format!("check `{}` is exact and cannot be marked known", said.name);
            self.error_at("check.known", reason, message, "remove `known` or `exact`");
        }
        let reduce = match said.reduce {
            Some(reduce) => Some(self.reduce(reduce, said.threshold.as_ref(), unit, &said.name)?),
            None => None,
        };
        let window = self.window(said, reduce);
        let window = match &said.phase {
            Some(name) => self.in_phase(name, window)?,
            None => window,
        };
        // What comes out may have another unit than the field.
        let unit = window.unit(unit);
        let expected = self.expected(said, unit)?;
        let absolute = match &said.absolute {
            Some(absolute) => Some(self.in_unit(absolute, unit, "`absolute`")?),
            None => None,
        };
        Some(Check {
            name: said.name.text.clone(),
            gauge: used.gauge(),
            unit: field_unit,
            shown: shown(
                said.value.iter().chain(said.between.iter().flatten()).chain(&said.absolute),
            ),
            window,
            expected,
            relative: said.relative.as_ref().map(Quantity::si),
            absolute,
            known: said.known.as_ref().map(|reason| reason.text.clone()),
        })
    }

    /// When a check reads its field.
    fn window(&mut self, said: &language::Check, reduce: Option<Reduce>) -> Window {
        match (&said.at, &said.over, reduce) {
            (_, Some([from, to]), Some(reduce)) => {
                self.in_run(from.si(), from.span.clone(), &said.name);
                Window::Over { from: from.si(), to: to.si(), reduce }
            }
            (None, None, Some(reduce)) => Window::Over { from: 0.0, to: f64::INFINITY, reduce },
            (Some(moment), _, _) => match moment.read() {
                When::Time(time) => {
                    self.in_run(time, moment.span.clone(), &said.name);
                    Window::At(time)
                }
                When::Start => Window::Start,
                When::End => Window::End,
            },
            (None, _, _) => Window::End,
        }
    }

    /// A field that is one number.
    fn number(&mut self, field: &Name, place: Place<'_>) -> Option<FieldUse> {
        let used = self.field(field, place)?;
        if used.is_vector() {
            let message = format!("`{field}` is a vector");
            let parts: Vec<String> = used.suffixes.iter().map(|s| format!("`{s}`")).collect();
            let parts = parts[1..].join(", ");
            let help = format!("write `{field}.x`, {parts} or `.magnitude`, or give `along`");
            self.error_at("field.direction", field, message, &help);
            return None;
        }
        Some(used)
    }

    fn reduce(
        &mut self,
        said: Said,
        threshold: Option<&Quantity<Any>>,
        unit: &str,
        name: &Name,
    ) -> Option<Reduce> {
        let limit = |b: &mut Self| match threshold {
            Some(threshold) => b.in_unit(threshold, unit, "`threshold`"),
            None => {
                let message = format!("check `{name}` needs a `threshold`");
                b.error_at("key.missing", name, message, "write for example threshold = \"0.1 m\"");
                None
            }
        };
        Some(match said {
            Said::Max => Reduce::Max,
            Said::Min => Reduce::Min,
            Said::Mean => Reduce::Mean,
            Said::Range => Reduce::Range,
            Said::Rms => Reduce::Rms,
            Said::FirstAbove => Reduce::FirstAbove(limit(self)?),
            Said::FirstBelow => Reduce::FirstBelow(limit(self)?),
            Said::ShareAbove => Reduce::ShareAbove(limit(self)?),
        })
    }

    /// The same window within a phase.
    fn in_phase(&mut self, name: &Name, window: Window) -> Option<Window> {
        let phases = &self.plan.phases;
        let Some(phase) = phases.iter().position(|phase| phase.name == name.text) else {
            let known = phases.iter().map(|p| p.name.as_str());
            self.found.push(Diagnostic::unknown("phase", name, known));
            return None;
        };
        let part = match window {
            Window::Start => Part::Start,
            // The rules of the language refuse a time beside a phase.
            Window::End | Window::At(_) | Window::Phase { .. } => Part::End,
            Window::Over { reduce, .. } => Part::Whole(reduce),
        };
        Some(Window::Phase { phase: phase as u32, part })
    }

    /// A moment after the end of the run is never reached.
    fn in_run(&mut self, time: f64, span: crate::scenario::Span, name: &Name) {
        let Some(total) = self.summary.duration else {
            return;
        };
        if time > total * (1.0 + 1e-9) {
            let message = format!(
                "check `{name}` reads at {time} s, after the end of the last phase ({total} s)"
            );
            self.error_at("check.late", span, message, "choose an earlier time, or a longer phase");
        }
    }

    fn expected(&mut self, said: &language::Check, unit: &str) -> Option<Expected> {
        if let Some(value) = &said.value {
            return self.in_unit(value, unit, "the field").map(Expected::Value);
        }
        if let Some([low, high]) = &said.between {
            let ends =
                (self.in_unit(low, unit, "the field"), self.in_unit(high, unit, "the field"));
            let (Some(low), Some(high_value)) = ends else {
                return None;
            };
            if low > high_value {
                let message = "the lower bound exceeds the upper bound";
                let help = "between = [lowest, highest]";
                self.error_at("value.order", high.span.clone(), message, help);
            }
            return Some(Expected::Between(low, high_value));
        }
        if let Some(csv) = &said.csv {
            let dim = units::dimension(unit).unwrap_or(Dim::NONE);
            let (t, v) = self.csv_function(csv, dim)?;
            return Some(Expected::Table { t, v });
        }
        let Some(text) = &said.formula else {
            let message = format!("check `{}` has no expected value", said.name);
            let help = "give `value`, `formula`, `csv` or `between`";
            self.error_at("key.one_of", &said.name, message, help);
            return None;
        };
        let mut names: Vec<(String, f64)> = Vec::new();
        for (name, value) in said.names.iter() {
            let number = match &value.raw {
                Raw::Number(number) => Ok(*number),
                Raw::Text(word) => match units::parse(word) {
                    Ok((number, _)) => Ok(number),
                    Err(_) => self.parsed.key_si(word),
                },
            };
            match number {
                Ok(number) => names.push((name.text.clone(), number)),
                Err(reason) => {
                    let help = "give a number, a value with a unit, or a key of this scene";
                    let message = format!("`{name}` in `let`: {reason}");
                    self.error_at("key.path", value.span.clone(), message, help);
                    return None;
                }
            }
        }
        let mut known: Vec<&str> = names.iter().map(|(name, _)| name.as_str()).collect();
        known.push("t");
        let formula = self.formula(text, &known)?;
        Some(Expected::Formula { formula, names })
    }

    /// The search; `checks` are those on its limit.
    pub(super) fn bisect(&mut self, checks: Vec<Check>) -> Option<Bisection> {
        let said = self.parsed.scenario.bisect.as_ref()?;
        let holds = self.criterion(&said.fails_when)?;
        let unit = searched_unit(said);
        Some(Bisection {
            key: said.key.text.clone(),
            low: said.low.si(),
            high: said.high.si(),
            tolerance: said.tolerance.si(),
            unit,
            shown: shown([&said.low, &said.high, &said.tolerance].into_iter()),
            holds,
            checks,
        })
    }

    /// What samples are asked; `checks` are those on the probability of failure.
    pub(super) fn monte_carlo(&mut self, checks: Vec<Check>) -> Option<Failing> {
        let said = self.parsed.scenario.monte_carlo.as_ref()?;
        let holds = self.criterion(said.fails_when.as_ref()?)?;
        Some(Failing { holds, checks })
    }

    /// A check that fails where the criterion is met.
    fn criterion(&mut self, criterion: &Criterion) -> Option<Check> {
        let place = Place {
            of: criterion.of.as_ref(),
            point: criterion.at_point.as_ref(),
            pins: criterion.pins.as_ref(),
            along: criterion.along.as_ref(),
            relative_to: criterion.relative_to.as_ref(),
        };
        let used = self.number(&criterion.field, place)?;
        if self.space == InSpace::Spatial && criterion.field.as_str() == "pair.broken" {
            let message = "`pair.broken` is 0 again once a broken joint has been released";
            let help =
                "`pair.broken_points` never decreases: field = \"pair.broken_points\", above = 0.5";
            self.warn_at("check.released", &criterion.field, message, help);
        }
        let window = match criterion.reduce {
            Some(reduce) => {
                let reduce = self.reduce(reduce, None, used.unit, &criterion.field)?;
                Window::Over { from: 0.0, to: f64::INFINITY, reduce }
            }
            None => Window::End,
        };
        let limit = |b: &mut Self, q: Option<&Quantity<Any>>, none: f64| match q {
            Some(q) => b.in_unit(q, used.unit, "the field"),
            None => Some(none),
        };
        let above = limit(self, criterion.above.as_ref(), f64::INFINITY)?;
        let below = limit(self, criterion.below.as_ref(), f64::NEG_INFINITY)?;
        Some(Check {
            name: format!("holds ({})", criterion.field),
            unit: used.unit.to_owned(),
            shown: shown(criterion.above.iter().chain(&criterion.below)),
            gauge: used.gauge(),
            window,
            expected: Expected::Between(below, above),
            relative: None,
            absolute: None,
            known: None,
        })
    }
}

/// The unit that the author of a scene wrote first.
fn shown<'a>(said: impl Iterator<Item = &'a Quantity<Any>>) -> Option<Shown> {
    let mut units = said.filter_map(Quantity::unit);
    let (unit, one) = units.next()?;
    Some(Shown { unit: unit.to_owned(), one })
}

/// SI unit of the searched interval; empty for plain numbers.
fn searched_unit(bisect: &language::Bisect) -> String {
    let dim = bisect.low.read().ok().and_then(|(_, dim)| dim);
    dim.filter(|d| *d != units::Dim::NONE).map_or_else(String::new, |d| d.to_string())
}
