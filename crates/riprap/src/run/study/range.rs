//! Variants of a scene by the value of a key: a load, a water level, an angle, a thickness.

use super::bracket::{NotANumber, Search};
use super::error::RangeError;
use crate::model::Bisection;
use crate::plan::shown::{Shown, digits_for};
use crate::run::job::Job;
use crate::run::scene::{Prepared, Scene};
use crate::scenario::units;
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
    /// use riprap::run::study::range::Quantity;
    ///
    /// let range = Quantity::read("interfaces.default.friction_angle", "20 deg..45 deg", Some("0.1 deg"))?;
    /// assert!((range.high - 45f64.to_radians()).abs() < 1e-15 && range.unit == "rad");
    /// assert!(Quantity::read("loads.push.time.ramp.to", "0.5..3 kN", None).is_err());
    /// # Ok::<(), riprap::run::study::RangeError>(())
    /// ```
    pub fn read(key: &str, range: &str, width: Option<&str>) -> Result<Self, RangeError> {
        let wrong = || RangeError::Range(range.to_owned());
        let (first, last) = range.split_once("..").ok_or_else(wrong)?;
        let [low, high] = [first, last].map(units::parse);
        let ((low, dim), (high, other)) = (low.map_err(|_| wrong())?, high.map_err(|_| wrong())?);
        if dim != other || low == high {
            return Err(wrong());
        }
        let unit = dim.unit();
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
                    example: shown.text(share, digits_for(1.0)),
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
        let mut variant = case.clone();
        let text = match &self.unit[..] {
            "" => format!("{value:?}"),
            unit => format!("{:?}", format!("{value} {unit}")),
        };
        variant.trial.push((self.key.clone(), text));
        let mut made = scene.prepare(&variant);
        if let Err(wrong) = &mut made {
            // The number stands in the range, not in the scene.
            for one in wrong.list.iter_mut().filter(|one| one.code == "unit.missing") {
                one.help = Some(
                    "give both ends of the range their unit, for example '20 deg..45 deg'"
                        .to_owned(),
                );
            }
        }
        made
    }

    /// The search for the limit in it.
    pub(super) fn search(&self) -> Result<Search, NotANumber> {
        Search::between(self.low, self.high, self.width)
    }
}

/// A case of a scene whose jobs are changed besides in numbers that no key holds for the whole model at once: steps, stiffness.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub(super) scene: &'a Scene,
    pub(super) case: &'a Case,
    pub(super) edit: &'a (dyn Fn(&mut Job) + Sync),
}

impl<'a> Source<'a> {
    /// As it stands.
    pub(super) fn plain(scene: &'a Scene, case: &'a Case) -> Self {
        Self { scene, case, edit: &|_| {} }
    }

    /// The job, with a value of a key.
    pub(super) fn job(&self, of: Option<(&Quantity, f64)>) -> Result<Job, Diagnostics> {
        let prepared = match of {
            Some((quantity, value)) => quantity.prepare(self.scene, self.case, value)?,
            None => self.scene.prepare(self.case)?,
        };
        let mut job = prepared.job();
        (self.edit)(&mut job);
        Ok(job)
    }
}

impl From<&Bisection> for Quantity {
    fn from(said: &Bisection) -> Self {
        let (low, high, unit) = (said.low, said.high, said.unit.clone());
        let suited = || Shown::suited(&unit, low.abs().max(high.abs()));
        let shown = said.shown.clone().unwrap_or_else(suited);
        Self { key: said.key.clone(), low, high, width: said.tolerance, unit, shown }
    }
}
