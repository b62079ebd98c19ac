//! Any number of a scene in place of the factor of safety: a load, a water level, an angle, a thickness.

use super::record::in_unit;
use super::rules::{Answer, RangeError, Rules, SafetyError, Trial};
use super::trial::{Made, Maker};
use super::{answer, sound};
use crate::plan::shown::Shown;
use crate::run::bracket::{Search, Task};
use crate::run::scene::{Prepared, Scene};
use crate::scenario::units::{self, Dim};
use crate::scenario::{Case, Diagnostics};

/// Share of the range that the answer is wide where nobody says anything.
const WIDTH: f64 = 0.01;

/// A range of values of a key.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Key with dots.
    pub key: String,
    /// One end, SI; either end may be the one that stands.
    pub low: f64,
    /// The other end, SI.
    pub high: f64,
    /// Width of the answer, SI.
    pub width: f64,
    /// SI unit; empty for plain numbers.
    pub unit: String,
    /// The unit in which the range was given.
    pub shown: Shown,
}

impl Quantity {
    /// Reads a range such as `20 deg..45 deg`, and the width of the answer; without one it is a hundredth of the range.
    ///
    /// # Errors
    /// What cannot be read, ends in different units of measure or equal ones.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::safety::Quantity;
    ///
    /// let range = Quantity::read("interfaces.default.friction_angle", "20 deg..45 deg", Some("0.1 deg"))?;
    /// assert!((range.high - 45f64.to_radians()).abs() < 1e-15 && range.unit == "rad");
    /// assert!(Quantity::read("loads.push.time.ramp.to", "0.5..3 kN", None).is_err());
    /// # Ok::<(), riprap::run::safety::RangeError>(())
    /// ```
    pub fn read(key: &str, range: &str, width: Option<&str>) -> Result<Self, RangeError> {
        let wrong = || RangeError::Range(range.to_owned());
        let (first, last) = range.split_once("..").ok_or_else(wrong)?;
        let [low, high] = [first, last].map(units::parse);
        let ((low, dim), (high, other)) = (low.map_err(|_| wrong())?, high.map_err(|_| wrong())?);
        if dim != other || low == high {
            return Err(wrong());
        }
        let unit = if dim == Dim::NONE { String::new() } else { dim.to_string() };
        let said = units::unit_of(first).or_else(|| units::unit_of(last));
        let shown = match said {
            Some((unit, one)) => Shown { unit: unit.to_owned(), one },
            None => Shown::si(&unit),
        };
        let share = WIDTH * (high - low).abs();
        let width = match width.map(|text| (text, units::parse(text))) {
            None => share,
            Some((_, Ok((width, of)))) if of == dim && width > 0.0 => width,
            Some((text, Ok(_) | Err(_))) => {
                return Err(RangeError::Width {
                    given: text.to_owned(),
                    example: in_unit(&shown, share, share),
                });
            }
        };
        Ok(Self { key: key.to_owned(), low, high, width, unit, shown })
    }

    /// The scene with a value of the key (SI), after the changes of the case, which may name the key themselves.
    ///
    /// # Errors
    /// A key that leads nowhere, a value that it cannot have.
    pub fn prepare(&self, scene: &Scene, case: &Case, value: f64) -> Result<Prepared, Diagnostics> {
        scene.prepare(&with_value(case, &self.key, value, &self.unit))
    }
}

/// A case in which a key has a value, given in SI with the unit of that name (empty for plain numbers).
pub(in crate::run) fn with_value(case: &Case, key: &str, value: f64, unit: &str) -> Case {
    let mut changed = case.clone();
    let text = if unit.is_empty() {
        format!("{value:?}")
    } else {
        format!("{:?}", format!("{value} {unit}"))
    };
    changed.trial.push((key.to_owned(), text));
    changed
}

/// Searches for the value of a quantity at which a case of a scene begins to fail; `report` is told every trial, `stop` asked every few
/// steps. Every trial runs the scene from its start.
///
/// # Errors
/// Values that the scene cannot have, models that cannot be built, rules that are no numbers, the user.
pub fn over_quantity(
    scene: &Scene,
    case: &Case,
    quantity: &Quantity,
    rules: &Rules,
    threads: usize,
    stop: &(dyn Fn() -> bool + Sync),
    report: &mut dyn FnMut(&Trial),
) -> Result<Answer, SafetyError> {
    let rules = Rules { width: quantity.width, ..rules.clone() };
    sound(&rules)?;
    let search = Search::between(quantity.low, quantity.high, quantity.width)
        .map_err(|_| SafetyError::NotANumber)?;
    for end in [quantity.low, quantity.high] {
        quantity.prepare(scene, case, end).map_err(SafetyError::Scene)?;
    }
    let maker = Maker { rules: &rules, rows: &[], stop };
    let one = |task: &Task<'_, _>| -> Made {
        let prepared = quantity.prepare(scene, case, task.value);
        let job = prepared.map_err(SafetyError::Scene)?.job();
        let model = (job.setup, job.plan);
        maker.anew(model, task.value, true, task.threads, task.useless)
    };
    let answer = answer(search, threads, false, quantity.width, one, report)?;
    Ok(Answer {
        quantity: Some(quantity.key.clone()),
        unit: quantity.unit.clone(),
        shown: quantity.shown.clone(),
        ..answer
    })
}
