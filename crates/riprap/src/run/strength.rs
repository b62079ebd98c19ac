//! Stiffness and strength from the histories of laboratory tests: modulus, peak, residual strength; cohesion and friction of several tests.
//!
//! | test | peak | of several tests with other confining or normal stresses |
//! |---|---|---|
//! | compression | uniaxial or triaxial strength s1 | `s1 = a + b s3`: `sin(phi) = (b - 1)/(b + 1)`, `c = a/(2 sqrt(b))` |
//! | disk | `2 P/(pi D t)` (ISRM 1978), in the plane with the load per thickness `2 P/(pi D)` | |
//! | shear | shear strength | `tau = c + s tan(phi)` |
//!
//! The sign of a history does not matter: the one with the largest magnitude is positive. The modulus is the slope of the line of least squares
//! through the samples before the peak between two shares of it. Errors of cohesion and friction are those of the line through the tests.

mod record;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::record::table::{Series, Table, TableError};
use crate::scenario::units::{self, Dim};

/// What kind of test it is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Test {
    /// A specimen pressed or pulled along its axis.
    Axial,
    /// A disk pressed across its diameter (m), with its thickness (m) in space.
    Disk {
        /// Diameter, m.
        diameter: f64,
        /// Thickness, m; `None` in the plane, where loads are per thickness.
        thickness: Option<f64>,
    },
    /// A joint that is sheared.
    Shear,
}

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// The test.
    pub test: Test,
    /// History of the stress, or of the load.
    pub load: String,
    /// Area (m², in the plane m) by which the load is divided; `None` where the history is a stress.
    pub area: Option<f64>,
    /// History of strain, or of shortening; `None` gives no modulus.
    pub strain: Option<String>,
    /// Length (m) by which the shortening is divided; `None` where the history is a strain.
    pub length: Option<f64>,
    /// History or value (Pa) of the confining stress, in shear of the normal stress; there a force is divided by the area.
    pub confining: Option<Confining>,
    /// Shares of the peak between which the modulus is measured.
    pub between: [f64; 2],
}

/// Where a confining stress comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Confining {
    /// A history.
    History(String),
    /// A value, Pa.
    Value(f64),
}

impl Confining {
    /// A stress with its unit, or else the name of a history.
    #[must_use]
    pub fn read(text: &str) -> Self {
        match units::parse(text) {
            Ok((value, dim)) if dim == Dim::PRESSURE => Self::Value(value),
            Ok(_) | Err(_) => Self::History(text.to_owned()),
        }
    }
}

/// Shares of the peak between which the modulus is measured where nothing is given.
pub const BETWEEN: [f64; 2] = [0.2, 0.5];
/// Unit of a stress in histories.
const STRESS: &str = "Pa";
/// Units of a load in histories, in space and in the plane.
const FORCES: &[&str] = &["N", "N/m"];
/// Share of the samples, the last ones, whose mean is the residual stress.
const LAST: f64 = 0.05;

/// One test.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Tested {
    /// Run folder.
    pub run: String,
    /// Largest stress, Pa.
    pub peak: f64,
    /// Whether the largest stress is that of the last sample: the specimen has not failed.
    pub at_end: bool,
    /// Strain at the peak.
    pub strain_at_peak: Option<f64>,
    /// Modulus, Pa (of shear over shortening in m: Pa/m).
    pub modulus: Option<f64>,
    /// Share of the variance of the stress that the line of the modulus explains.
    pub fit: Option<f64>,
    /// Mean stress over the last twentieth of the samples, Pa.
    pub residual: f64,
    /// Confining or normal stress at the peak, Pa, compression positive.
    pub confining: Option<f64>,
}

/// A value with its standard error; `None` where two tests give no error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fitted {
    /// The value.
    pub value: f64,
    /// Its standard error.
    pub error: Option<f64>,
}

/// Mohr and Coulomb's line through several tests.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Envelope {
    /// Cohesion, Pa.
    pub cohesion: Fitted,
    /// Friction angle, deg.
    pub friction: Fitted,
    /// Strength without confining stress, Pa: uniaxial, in shear the cohesion.
    pub unconfined: Fitted,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The kind of test.
    pub test: Test,
    /// The tests, in the order of the folders.
    pub tests: Vec<Tested>,
    /// Of tests with two and more different confining stresses.
    pub envelope: Option<Envelope>,
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum StrengthError {
    /// Nothing to read.
    #[error(
        "{} holds no run with histories; give run folders whose scenes have `history` in [[outputs]], or the folder of a sweep", .0.display()
    )]
    NoRun(PathBuf),
    /// No numbers.
    #[error("the history `{name}` of {} has no values", run.display())]
    Empty {
        /// The run.
        run: PathBuf,
        /// The history.
        name: String,
    },
    /// Nothing is loaded.
    #[error("the history `{name}` of {} is zero all the time", run.display())]
    Zero {
        /// The run.
        run: PathBuf,
        /// The history.
        name: String,
    },
    /// A number that is none.
    #[error("{0}")]
    Number(String),
    /// The table of the histories.
    #[error(transparent)]
    Table(#[from] TableError),
}

/// Stiffness and strength from the histories of runs. A folder that holds runs stands for all of them.
///
/// # Errors
/// Folders without histories, unknown names, histories without values, shares or sizes that are none.
pub fn strength(folders: &[PathBuf], rules: &Rules) -> Result<Answer, StrengthError> {
    check(rules)?;
    let mut tests = Vec::new();
    for folder in folders {
        for run in runs_in(folder)? {
            tests.push(tested(&run, rules)?);
        }
    }
    let points: Vec<[f64; 2]> =
        tests.iter().filter_map(|test| Some([test.confining?, test.peak])).collect();
    let envelope = envelope(rules.test, &points);
    Ok(Answer { test: rules.test, tests, envelope })
}

fn check(rules: &Rules) -> Result<(), StrengthError> {
    let [low, high] = rules.between;
    if !(0.0 <= low && low < high && high <= 1.0) {
        let text = format!("{low}..{high} are no shares of the peak; write for example 0.2..0.5");
        return Err(StrengthError::Number(text));
    }
    let disk = match rules.test {
        Test::Disk { diameter, thickness } => [Some(diameter), thickness],
        Test::Axial | Test::Shear => [None; 2],
    };
    let sizes = [rules.area, rules.length].into_iter().chain(disk).flatten();
    match sizes.into_iter().find(|size| !(*size > 0.0 && size.is_finite())) {
        Some(size) => {
            Err(StrengthError::Number(format!("{size} is no size; it must be above zero")))
        }
        None => Ok(()),
    }
}

/// Run folders with histories in a folder: itself, or those in it, in the order of their names.
fn runs_in(folder: &Path) -> Result<Vec<PathBuf>, StrengthError> {
    let has = |folder: &Path| folder.join("histories.csv").is_file();
    if has(folder) {
        return Ok(vec![folder.to_owned()]);
    }
    let entries = std::fs::read_dir(folder).map_err(|_| StrengthError::NoRun(folder.to_owned()))?;
    let mut found: Vec<PathBuf> =
        entries.flatten().map(|entry| entry.path()).filter(|path| has(path)).collect();
    found.sort();
    if found.is_empty() {
        return Err(StrengthError::NoRun(folder.to_owned()));
    }
    Ok(found)
}

/// What one test gives.
fn tested(run: &Path, rules: &Rules) -> Result<Tested, StrengthError> {
    let table = Table::read(&run.join("histories.csv"))?;
    let loads = table.column(&rules.load)?;
    let strains = rules.strain.as_deref().map(|name| table.column(name)).transpose()?;
    let confining = match &rules.confining {
        Some(Confining::History(name)) => Some(table.column(name)?),
        Some(Confining::Value(_)) | None => None,
    };
    // Samples at which all that is asked for was due.
    let all = [Some(loads), strains, confining];
    let due: Vec<usize> = (0..loads.values.len())
        .filter(|k| all.iter().flatten().all(|series| series.values[*k].is_finite()))
        .collect();
    let of = |series: &Series, scale: f64| -> Vec<f64> {
        due.iter().map(|k| scale * series.values[*k]).collect()
    };
    let scale = match rules.test {
        Test::Disk { diameter, thickness } => {
            2.0 / (std::f64::consts::PI * diameter * thickness.unwrap_or(1.0))
        }
        Test::Axial | Test::Shear => 1.0 / rules.area.unwrap_or(1.0),
    };
    let stress = of(loads, scale);
    let sized = stress.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let name = rules.load.clone();
    let Some((at, peak)) = sized.map(|(at, peak)| (at, *peak)) else {
        return Err(StrengthError::Empty { run: run.to_owned(), name });
    };
    if peak == 0.0 {
        return Err(StrengthError::Zero { run: run.to_owned(), name });
    }
    let divided = rules.area.is_some() || matches!(rules.test, Test::Disk { .. });
    match divided {
        true => is_in(loads, FORCES, "a load that is divided by an area")?,
        false => is_in(loads, &[STRESS], "a stress")?,
    }
    // Of sheared joints and of disks the way itself is reported as often.
    if let Some(series) = strains.filter(|_| rules.test == Test::Axial) {
        match rules.length {
            Some(_) => is_in(series, &["m"], "a shortening that is divided by a length")?,
            None => is_in(series, &["", "-"], "a strain")?,
        }
    }
    let stress: Vec<f64> = stress.iter().map(|s| s * peak.signum()).collect();
    let side = match (confining.filter(|series| series.unit != STRESS), rules.test, rules.area) {
        (None, ..) => 1.0,
        // The normal force of a joint acts on the area that shears.
        (Some(_), Test::Shear, Some(area)) => 1.0 / area,
        (Some(series), ..) => {
            let Series { name, unit, .. } = series;
            return Err(StrengthError::Number(format!(
                "the history `{name}` is in {unit}, but a confining stress is asked for in {STRESS}"
            )));
        }
    };
    let strain = strains.map(|series| of(series, 1.0 / rules.length.unwrap_or(1.0)));
    let strain = strain.map(|strain| {
        let sign = strain[at].signum();
        strain.into_iter().map(|e| sign * e).collect::<Vec<f64>>()
    });
    let line = strain.as_ref().and_then(|strain| modulus(strain, &stress[..=at], rules.between));
    let last = ((LAST * stress.len() as f64).ceil() as usize).clamp(1, stress.len());
    let tail = &stress[stress.len() - last..];
    Ok(Tested {
        run: run.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned()),
        peak: peak.abs(),
        at_end: at + 1 == stress.len(),
        strain_at_peak: strain.as_ref().map(|strain| strain[at]),
        modulus: line.map(|line| line.slope),
        fit: line.map(|line| line.explained),
        residual: tail.iter().sum::<f64>() / tail.len() as f64,
        confining: match (&rules.confining, confining) {
            (Some(Confining::Value(value)), _) => Some(*value),
            (_, Some(series)) => Some(of(series, side)[at].abs()),
            (Some(Confining::History(_)) | None, None) => None,
        },
    })
}

/// Whether a history is in one of these units.
fn is_in(series: &Series, units: &[&str], what: &str) -> Result<(), StrengthError> {
    if units.contains(&series.unit.as_str()) {
        return Ok(());
    }
    let Series { name, unit, .. } = series;
    let unit = if unit.is_empty() { "no unit" } else { unit.as_str() };
    let asked = units.iter().find(|unit| !unit.is_empty()).filter(|unit| **unit != "-");
    let asked = asked.map_or("a plain number".to_owned(), |_| units.join(" or "));
    Err(StrengthError::Number(format!(
        "the history `{name}` is in {unit}, but {what} is in {asked}"
    )))
}

/// The line through the samples before the peak whose stress lies between two shares of it.
fn modulus(strain: &[f64], rising: &[f64], [low, high]: [f64; 2]) -> Option<Fit> {
    let peak = *rising.last()?;
    // From the last time that it was below the lower share on: what swings at the start does not count.
    let from = rising.iter().rposition(|s| *s < low * peak).map_or(0, |k| k + 1);
    let points = strain.iter().zip(rising).skip(from);
    let points: Vec<[f64; 2]> =
        points.take_while(|(_, s)| **s <= high * peak).map(|(e, s)| [*e, *s]).collect();
    Fit::through(&points)
}

/// A line of least squares `y = at + slope x`.
#[derive(Clone, Copy, Debug)]
struct Fit {
    at: f64,
    slope: f64,
    /// Variances of `at` and `slope`, and their covariance; unknown of two points.
    errors: Option<[f64; 3]>,
    explained: f64,
}

impl Fit {
    /// `None` where the points do not differ in x.
    fn through(points: &[[f64; 2]]) -> Option<Self> {
        let n = points.len() as f64;
        let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / n;
        let (x, y) = (mean(0), mean(1));
        let sum = |k: usize, l: usize| {
            points.iter().map(|p| (p[k] - [x, y][k]) * (p[l] - [x, y][l])).sum::<f64>()
        };
        let (xx, xy, yy) = (sum(0, 0), sum(0, 1), sum(1, 1));
        if points.len() < 2 || xx.is_nan() || xx <= 0.0 {
            return None;
        }
        let slope = xy / xx;
        let left = (yy - slope * xy).max(0.0);
        let variance = left / (n - 2.0);
        let errors = (points.len() > 2)
            .then(|| [variance * (1.0 / n + x * x / xx), variance / xx, -variance * x / xx]);
        let explained = if yy > 0.0 { 1.0 - left / yy } else { 1.0 };
        Some(Self { at: y - slope * x, slope, errors, explained })
    }

    /// Standard error of a function of the line with these derivatives to `at` and `slope`.
    fn error(&self, by_at: f64, by_slope: f64) -> Option<f64> {
        self.errors.map(|[a, b, both]| {
            let square =
                by_at * by_at * a + by_slope * by_slope * b + 2.0 * by_at * by_slope * both;
            square.max(0.0).sqrt()
        })
    }
}

/// Cohesion and friction of tests given by confining stress and strength, Pa.
fn envelope(test: Test, points: &[[f64; 2]]) -> Option<Envelope> {
    let line = Fit::through(points)?;
    let (a, b) = (line.at, line.slope);
    let unconfined = Fitted { value: a, error: line.error(1.0, 0.0) };
    let (cohesion, friction) = match test {
        Test::Disk { .. } => return None,
        Test::Shear => {
            let angle = Fitted {
                value: libm::atan(b).to_degrees(),
                error: line.error(0.0, (1.0 / (1.0 + b * b)).to_degrees()),
            };
            (unconfined, angle)
        }
        Test::Axial => {
            // Without a slope of its own the strength has no friction angle.
            let root = if b > 0.0 { b.sqrt() } else { return None };
            let cohesion = Fitted {
                value: 0.5 * a / root,
                error: line.error(0.5 / root, -0.25 * a / (b * root)),
            };
            let angle = Fitted {
                value: libm::asin((b - 1.0) / (b + 1.0)).to_degrees(),
                error: line.error(0.0, (1.0 / ((b + 1.0) * root)).to_degrees()),
            };
            (cohesion, angle)
        }
    };
    Some(Envelope { cohesion, friction, unconfined })
}
