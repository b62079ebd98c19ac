//! Whole runs into run folders.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

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

/// Makes a folder, if it is not there.
pub fn make(py: Python<'_>, folder: &Path) -> PyResult<()> {
    std::fs::create_dir_all(folder).map_err(|e| {
        let text = format!("could not make {}: {e}", folder.display());
        errors::output(py, &text)
    })
}

/// Time between two looks for signals.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);

/// What came of a study, and what was raised while it went on.
pub struct Reported<R> {
    pub result: R,
    /// The study has been stopped for it.
    pub raised: Option<PyErr>,
}

/// Works without the interpreter on a thread of its own; `work` is given whether to stop and passes on what it has done, of which
/// `tell` tells Python. A signal, an exception and the answer not to go on stop it.
pub fn reported<T: Send, R: Send>(
    py: Python<'_>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync), &mut dyn FnMut(T)) -> R + Send,
    mut tell: impl FnMut(Python<'_>, &T) -> PyResult<bool> + Send,
) -> Reported<R> {
    let (stop, mut raised) = (AtomicBool::new(false), None);
    let work = || {
        std::thread::scope(|scope| {
            let (send, receive) = channel();
            let stop = &stop;
            // The receiver lives until the work is done.
            let work = scope.spawn(move || {
                work(&|| stop.load(Ordering::Relaxed), &mut |done| drop(send.send(done)))
            });
            // This thread stays the interpreter's: signals arrive here.
            loop {
                let done = match receive.recv_timeout(CHECK_INTERVAL) {
                    Ok(done) => Some(done),
                    Err(RecvTimeoutError::Timeout) => None,
                    Err(RecvTimeoutError::Disconnected) => break,
                };
                let answer = Python::attach(|py| {
                    let goes_on = done.as_ref().map_or(Ok(true), |done| tell(py, done))?;
                    py.check_signals().map(|()| goes_on)
                });
                if !matches!(answer, Ok(true)) {
                    stop.store(true, Ordering::Relaxed);
                }
                raised = raised.take().or(answer.err());
            }
            work.join()
        })
    };
    let result = py.detach(work);
    Reported { result: result.unwrap_or_else(|panic| std::panic::resume_unwind(panic)), raised }
}
