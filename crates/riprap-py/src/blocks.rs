//! Removable blocks of a scene, and the run-out of rocks of runs.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::exec::Exec;
use riprap::run::removable::{RemovableError, Rules, removable as blocks_of};
use riprap::run::runout::{Line, Rules as Asked, runout as way_of};

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
        RemovableError::Build(_) | RemovableError::Run(_) => errors::run(py, &wrong.to_string()),
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
