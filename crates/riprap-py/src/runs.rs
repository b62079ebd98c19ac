//! Whole runs into run folders.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::record::folder::Existing;
use riprap::run::drive;
use riprap::run::job::{self, JobError, Outcome};

use crate::errors;
use crate::look::Look;
use crate::scene::{Scene, json};

/// What may be replaced.
pub fn existing(word: &str) -> PyResult<Existing> {
    match word {
        "refuse" => Ok(Existing::Refuse),
        "replace" => Ok(Existing::ReplaceRun),
        "force" => Ok(Existing::Force),
        _ => Err(PyValueError::new_err(format!(
            "existing={word:?}; write \"refuse\", \"replace\" or \"force\""
        ))),
    }
}

/// Runs a case of a scenario into `folder`; gives the manifest at the end as JSON text.
#[pyfunction]
pub fn run(
    py: Python<'_>,
    scene: &Scene,
    case: Option<&str>,
    folder: PathBuf,
    existing_folder: &str,
    threads: usize,
    callback: Option<Py<PyAny>>,
) -> PyResult<String> {
    let existing = existing(existing_folder)?;
    let prepared = scene.prepare(py, case)?;
    // Errors have places in it, and the job takes the rest.
    let parsed = prepared.parsed.clone();
    let job = prepared.job();
    let outcome = with_look(py, callback, |look| job::run(job, &folder, existing, threads, look))?;
    json(&outcome.map_err(|e| errors::job_of(py, &e, &parsed))?.manifest)
}

/// Goes on with a run that was stopped; gives the manifest at the end as JSON text.
#[pyfunction]
pub fn resume(
    py: Python<'_>,
    folder: PathBuf,
    threads: usize,
    callback: Option<Py<PyAny>>,
) -> PyResult<String> {
    let outcome = with_look(py, callback, |look| job::resume(&folder, threads, look))?;
    json(&outcome.map_err(|e| errors::job(py, &e))?.manifest)
}

/// Works without the interpreter; what a callback raised comes out when the run has been stopped for it.
pub fn with_look(
    py: Python<'_>,
    callback: Option<Py<PyAny>>,
    work: impl FnOnce(
        &mut dyn FnMut(&mut drive::Look<'_>) -> drive::Control,
    ) -> Result<Outcome, JobError>
    + Send,
) -> PyResult<Result<Outcome, JobError>> {
    let mut look = Look::new(callback);
    let outcome = py.detach(|| work(&mut |here| look.ask(here)));
    match look.raised {
        Some(raised) => Err(raised),
        None => Ok(outcome),
    }
}
