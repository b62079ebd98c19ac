//! Named results: removable blocks of a scene, run-out of rocks and strength of specimens of runs.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::exec::Exec;
use riprap::run::muckpile::{Rules as Blast, muckpile as pile_of};
use riprap::run::removable::{RemovableError, Rules, removable as blocks_of};
use riprap::run::runout::{Line, Rules as Asked, runout as way_of};
use riprap::run::strength::{Confining, Rules as Tests, Test, strength as strength_of};

use crate::errors;
use crate::scene::{Scene, json};

/// Removable blocks of a case, as JSON, and in words.
#[pyfunction]
pub fn removable(
    py: Python<'_>,
    scene: &Scene,
    case: Option<&str>,
    factor: f64,
    rounds: u32,
    phase: Option<String>,
) -> PyResult<(String, String)> {
    let job = scene.prepare(py, case)?.job();
    let rules = Rules { factor, rounds, phase };
    let found = py.detach(|| blocks_of(job.setup, job.plan, &rules, Exec::serial()));
    let answer = found.map_err(|wrong| match wrong {
        RemovableError::Build(_) | RemovableError::Run(_) | RemovableError::Picture(_) => {
            errors::run(py, &wrong.to_string())
        }
        RemovableError::Planar | RemovableError::Phase { .. } | RemovableError::Factor => {
            PyValueError::new_err(wrong.to_string())
        }
    })?;
    Ok((json(&answer)?, answer.words()))
}

/// Run-out of the rocks of run folders, as JSON, and in words.
#[pyfunction]
pub fn runout(
    py: Python<'_>,
    folders: Vec<PathBuf>,
    of: Option<String>,
    lines: Vec<String>,
) -> PyResult<(String, String)> {
    let lines: Result<Vec<Line>, String> = lines.iter().map(|line| Line::read(line)).collect();
    let rules = Asked { of, lines: lines.map_err(PyValueError::new_err)? };
    let found = py.detach(|| way_of(&folders, &rules));
    let answer = found.map_err(|wrong| PyValueError::new_err(wrong.to_string()))?;
    Ok((json(&answer)?, answer.words()))
}

/// How a blast is read; names as in `riprap.muckpile`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Reading {
    moved: Option<String>,
    along: Option<String>,
    cell: Option<String>,
    rock_factor: Option<f64>,
    powder_factor: Option<String>,
    charge: Option<String>,
    strength: f64,
    uniformity: Option<f64>,
    of: Option<String>,
}

/// What the blast of a run has made, as JSON, and in words.
#[pyfunction]
pub fn muckpile(py: Python<'_>, folder: PathBuf, reading: Reading) -> PyResult<(String, String)> {
    let rules = Blast::read(
        [reading.moved.as_deref(), reading.cell.as_deref()],
        reading.along.as_deref(),
        reading.rock_factor,
        [reading.powder_factor.as_deref(), reading.charge.as_deref()],
        reading.strength,
        reading.uniformity,
    );
    let mut rules = rules.map_err(PyValueError::new_err)?;
    rules.of = reading.of;
    let found = py.detach(|| pile_of(&folder, &rules));
    let answer = found.map_err(|wrong| PyValueError::new_err(wrong.to_string()))?;
    Ok((json(&answer)?, answer.words()))
}

/// How tests are read; names as in `riprap.strength`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    load: String,
    area: Option<f64>,
    strain: Option<String>,
    length: Option<f64>,
    confining: Option<String>,
    disk: Option<(f64, Option<f64>)>,
    shear: bool,
    between: [f64; 2],
}

/// Modulus and strength of the tests in run folders, as JSON, and in words.
#[pyfunction]
pub fn strength(
    py: Python<'_>,
    folders: Vec<PathBuf>,
    options: Options,
) -> PyResult<(String, String)> {
    let test = match (options.disk, options.shear) {
        (Some((diameter, thickness)), _) => Test::Disk { diameter, thickness },
        (None, true) => Test::Shear,
        (None, false) => Test::Axial,
    };
    let rules = Tests {
        test,
        load: options.load,
        area: options.area,
        strain: options.strain,
        length: options.length,
        confining: options.confining.as_deref().map(Confining::read),
        between: options.between,
    };
    let found = py.detach(|| strength_of(&folders, &rules));
    let answer = found.map_err(|wrong| PyValueError::new_err(wrong.to_string()))?;
    Ok((json(&answer)?, answer.words()))
}
