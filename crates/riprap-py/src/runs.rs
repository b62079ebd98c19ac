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
    let job = scene.prepare(py, case)?.job();
    with_look(py, callback, |look| {
        job::run(job, &folder, existing, threads, look)
    })
}

/// Goes on with a run that was stopped; gives the manifest at the end as JSON text.
#[pyfunction]
pub fn resume(
    py: Python<'_>,
    folder: PathBuf,
    threads: usize,
    callback: Option<Py<PyAny>>,
) -> PyResult<String> {
    with_look(py, callback, |look| job::resume(&folder, threads, look))
}

/// Works without the interpreter; what a callback raised comes out when the run has been stopped for it.
fn with_look(
    py: Python<'_>,
    callback: Option<Py<PyAny>>,
    work: impl FnOnce(&mut dyn FnMut(&drive::Progress) -> drive::Control) -> Result<Outcome, JobError>
    + Send,
) -> PyResult<String> {
    let mut look = Look::new(callback);
    let outcome = py.detach(|| work(&mut |progress| look.ask(progress)));
    if let Some(raised) = look.raised {
        return Err(raised);
    }
    let outcome = outcome.map_err(|e| errors::job(py, &e))?;
    json(&outcome.manifest)
}
