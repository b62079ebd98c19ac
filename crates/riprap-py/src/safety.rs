//! Factors of safety and limits of other numbers.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::record::folder::Existing;
use riprap::run::job;
use riprap::run::safety::{self as factor, Answer, Quantity, Rules, SafetyError, Trial};
use riprap::scenario::units::{self, Dim};

use crate::errors;
use crate::runs::{existing, with_look};
use crate::scene::{Scene, json};

/// Time between two looks for signals.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);
/// Frames of the run of the mechanism.
const FRAMES: u64 = 20;

/// How a search is made; names as in `riprap.safety`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    width: Option<String>,
    interfaces: Vec<String>,
    materials: Vec<String>,
    groups: Vec<String>,
    moved: Option<String>,
    balance: f64,
    steps: u64,
    from_start: bool,
    quantity: Option<(String, String)>,
    threads: usize,
}

/// Searches for the factor of safety, or the limit of a quantity, writes the answer as `safety.json` and `safety.csv` into `folder` and runs
/// the mechanism into `mechanism.run` there; gives the answer as JSON, the table as CSV, and both in words.
#[pyfunction]
pub fn safety(
    py: Python<'_>,
    scene: &Scene,
    case: Option<&str>,
    folder: PathBuf,
    existing_folder: &str,
    options: Options,
    report: Option<Py<PyAny>>,
) -> PyResult<(String, String, String)> {
    let existing = existing(existing_folder)?;
    // Before the search, which may take hours.
    vacant(py, &folder, existing)?;
    let prepared = scene.prepare(py, case)?;
    let case = scene.case(case)?;
    let scene = &scene.0;
    let range = options.quantity.as_ref().map(|(key, range)| {
        let read = Quantity::read(key, range, options.width.as_deref());
        read.map_err(|wrong| PyValueError::new_err(wrong.to_string()))
    });
    let over = range.transpose()?;
    let width = match (&over, &options.width) {
        (Some(quantity), _) => quantity.width,
        (None, None) => Rules::default().width,
        (None, Some(text)) => text
            .parse()
            .map_err(|_| PyValueError::new_err(format!("width={text}; write a number")))?,
    };
    let moved = options.moved.map(|text| match units::parse(&text) {
        Ok((length, Dim::LENGTH)) => Ok(length),
        Ok(_) | Err(_) => {
            Err(PyValueError::new_err(format!("moved={text:?}; write a length such as '5 mm'")))
        }
    });
    let rules = Rules {
        width,
        interfaces: options.interfaces,
        materials: options.materials,
        groups: options.groups,
        moved: moved.transpose()?,
        balance: options.balance,
        steps: options.steps,
        from_start: options.from_start,
    };
    let (rules, over) = (&rules, over.as_ref());
    let search = |stop: &AtomicBool, report: &mut dyn FnMut(&Trial)| {
        let asked = || stop.load(Ordering::Relaxed);
        let threads = options.threads;
        match over {
            Some(quantity) => {
                let found =
                    factor::over_quantity(scene, &case, quantity, rules, threads, &asked, report)?;
                let value = found.fails_at.unwrap_or(quantity.low);
                let prepared = quantity.prepare(scene, &case, value);
                Ok((found, prepared.map_err(SafetyError::Scene)?.job()))
            }
            None => {
                let job = prepared.job();
                let (setup, plan) = (&job.setup, &job.plan);
                let found = factor::search(setup, plan, rules, threads, &asked, report)?;
                Ok((found, job))
            }
        }
    };
    let (stop, mut raised) = (AtomicBool::new(false), None);
    let found = py.detach(|| {
        std::thread::scope(|scope| {
            let (send, receive) = channel();
            let stop = &stop;
            // The receiver lives until the search is over.
            let work = scope.spawn(move || search(stop, &mut |t| drop(send.send(t.clone()))));
            // This thread stays the interpreter's: signals arrive here.
            loop {
                let trial = match receive.recv_timeout(CHECK_INTERVAL) {
                    Ok(trial) => Some(trial),
                    Err(RecvTimeoutError::Timeout) => None,
                    Err(RecvTimeoutError::Disconnected) => break,
                };
                if let Err(error) = told(trial.as_ref(), report.as_ref(), stop) {
                    stop.store(true, Ordering::Relaxed);
                    raised.get_or_insert(error);
                }
            }
            work.join()
        })
    });
    if let Some(raised) = raised {
        return Err(raised);
    }
    let found = found.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
    let (answer, job): (Answer, _) = found.map_err(|wrong| error(py, &wrong))?;
    let (text, table) = (json(&answer)?, answer.table());
    // Before the mechanism is run, which takes as long again and may be stopped.
    std::fs::create_dir_all(&folder).map_err(|e| {
        let text = format!("could not make {}: {e}", folder.display());
        errors::output(py, &text)
    })?;
    let files = [("safety.json", format!("{text}\n")), ("safety.csv", table.clone())];
    for (name, text) in files {
        let written = riprap::record::write_whole(&folder.join(name), text.as_bytes());
        written.map_err(|e| errors::output(py, &e.to_string()))?;
    }
    let kept = format!("the answer is in {}, without the mechanism", folder.display());
    let shown = factor::mechanism_job(job, rules, &answer, FRAMES);
    if let Some(job) = shown.map_err(|wrong| errors::run(py, &format!("{wrong}; {kept}")))? {
        let target = folder.join("mechanism.run");
        let ran =
            with_look(py, None, |look| job::run(job, &target, existing, options.threads, look))?;
        ran.map_err(|wrong| errors::job_after(py, &wrong, &kept))?;
    }
    let mut words = answer.words();
    if let Some(mechanism) = answer.mechanism_words() {
        words = format!("{words}\n{mechanism}");
    }
    Ok((text, table, words))
}

/// Refuses a folder with something in it that is not to be replaced.
fn vacant(py: Python<'_>, folder: &Path, existing: Existing) -> PyResult<()> {
    if folder.exists() && !folder.is_dir() {
        let text = format!(
            "{} is a file; the answer needs a folder: choose another name",
            folder.display()
        );
        return Err(errors::run(py, &text));
    }
    let occupied = std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some());
    if occupied && existing == Existing::Refuse {
        let text = format!(
            "{} is not empty; choose another folder, or replace what is there with existing=\"replace\"",
            folder.display()
        );
        return Err(errors::run(py, &text));
    }
    Ok(())
}

fn error(py: Python<'_>, wrong: &SafetyError) -> PyErr {
    match wrong {
        SafetyError::Scene(wrong) => errors::scenario(py, wrong),
        SafetyError::Unknown { .. }
        | SafetyError::NoStrength(_)
        | SafetyError::Range(_)
        | SafetyError::NotANumber => PyValueError::new_err(wrong.to_string()),
        SafetyError::Build(_) | SafetyError::Exec(_) | SafetyError::Stopped => {
            errors::run(py, &wrong.to_string())
        }
    }
}

fn told(trial: Option<&Trial>, report: Option<&Py<PyAny>>, stop: &AtomicBool) -> PyResult<()> {
    Python::attach(|py| {
        py.check_signals()?;
        if let (Some(trial), Some(report)) = (trial, report) {
            let said = report.bind(py).call1((json(trial)?,))?;
            if !said.is_none() && !said.is_truthy()? {
                stop.store(true, Ordering::Relaxed);
            }
        }
        Ok(())
    })
}
