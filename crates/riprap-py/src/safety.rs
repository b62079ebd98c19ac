//! Factors of safety and limits of other numbers.

use std::path::{Path, PathBuf};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::record::folder::Existing;
use riprap::run::job;
use riprap::run::study::safety::{self as factor, Quantity, Rules, Trial};
use riprap::run::study::{Executor, StudyError};
use riprap::scenario::units::{self, Dim};

use crate::errors;
use crate::look::goes_on;
use crate::runs::{existing, make, reported, with_look};
use crate::scene::{Scene, json};

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
        ..Rules::default()
    };
    let threads = options.threads;
    let job = prepared.job();
    let found = reported(
        py,
        |stop, pass_on| {
            let executor = Executor { threads, stop };
            let over = over.as_ref().map(|quantity| (scene, &case, quantity));
            factor::find(job, over, &rules, &executor, &mut |trial: &Trial| pass_on(trial.clone()))
        },
        |py, trial| match &report {
            Some(report) => goes_on(&report.bind(py).call1((json(trial)?,))?),
            None => Ok(true),
        },
    );
    if let Some(raised) = found.raised {
        return Err(raised);
    }
    let (answer, job) = found.result.map_err(|wrong| error(py, &wrong))?;
    let (text, table) = (json(&answer)?, answer.table());
    // Before the mechanism is run, which takes as long again and may be stopped.
    make(py, &folder)?;
    answer.write(&folder).map_err(|e| errors::output(py, &e.to_string()))?;
    let kept = format!("the answer is in {}, without the mechanism", folder.display());
    let shown = factor::mechanism_job(job, &rules, &answer);
    if let Some(job) = shown.map_err(|wrong| errors::run(py, &format!("{wrong}; {kept}")))? {
        let target = folder.join("mechanism.run");
        let ran = with_look(py, None, |look| job::run(job, &target, existing, threads, look))?;
        ran.map_err(|wrong| errors::job_after(py, &wrong, &kept))?;
    }
    let more = [answer.mechanism_words(), answer.far_words(), answer.lost_words()];
    let words = more.into_iter().flatten().fold(answer.words(), |all, one| format!("{all}\n{one}"));
    Ok((text, table, words))
}

/// Refuses a folder with something in it that is not to be replaced.
pub fn vacant(py: Python<'_>, folder: &Path, existing: Existing) -> PyResult<()> {
    if folder.exists() && !folder.is_dir() {
        let text = format!(
            "{} is a file, but the answer needs a folder; choose another name",
            folder.display()
        );
        return Err(errors::run(py, &text));
    }
    let occupied = std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some());
    if occupied && existing == Existing::Refuse {
        let text = format!(
            "{} is not empty; choose another folder, or replace its contents with existing=\"replace\"",
            folder.display()
        );
        return Err(errors::run(py, &text));
    }
    Ok(())
}

pub fn error(py: Python<'_>, wrong: &StudyError) -> PyErr {
    match wrong {
        StudyError::Scene(wrong) => errors::scenario(py, wrong),
        StudyError::Job(wrong) => errors::job(py, wrong),
        StudyError::Stopped | StudyError::Ended(_) => errors::run(py, &wrong.to_string()),
        StudyError::Unknown { .. }
        | StudyError::NoStrength(_)
        | StudyError::Range(_)
        | StudyError::NotANumber
        | StudyError::NoBisect { .. }
        | StudyError::OneLaw { .. }
        | StudyError::NoLimit(_)
        | StudyError::NoResults { .. }
        | StudyError::Outside(_)
        | StudyError::Compare(_) => PyValueError::new_err(wrong.to_string()),
    }
}
