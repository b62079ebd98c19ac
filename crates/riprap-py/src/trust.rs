//! The error of each result, and the value of a key at which a result is as wanted.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::run::study::Executor;
use riprap::run::study::find::{self as search, Wanted};
use riprap::run::study::range::Quantity;
use riprap::run::study::safety;
use riprap::run::study::trust::{self as errors_of, Cause, Question, Rules, Trial};
use riprap::scenario::units::{self, Dim};

use crate::errors;
use crate::look::goes_on;
use crate::runs::{existing, make, reported};
use crate::safety::{error, vacant};
use crate::scene::{Scene, json};

fn refused(text: String) -> PyErr {
    PyValueError::new_err(text)
}

/// Runs the variants of a scene and writes the tables into `folder`; gives the answer as JSON, and in words. `options`: the budget, the causes
/// to leave out, the number of threads, and whether the factor of safety is asked for.
#[pyfunction]
pub fn trust(
    py: Python<'_>,
    scene: &Scene,
    case: Option<&str>,
    folder: PathBuf,
    existing_folder: &str,
    options: (String, Vec<String>, usize, bool),
    report: Option<Py<PyAny>>,
) -> PyResult<(String, String)> {
    vacant(py, &folder, existing(existing_folder)?)?;
    let (budget, without, threads, safety) = options;
    let budget = match units::parse(&budget) {
        Ok((seconds, Dim::TIME)) => seconds,
        Ok(_) | Err(_) => {
            return Err(refused(format!("budget={budget:?}; write a time such as '10min'")));
        }
    };
    let without: Result<Vec<Cause>, String> =
        without.iter().map(|word| Cause::read(word)).collect();
    let rules = Rules { budget, without: without.map_err(refused)? };
    let case = scene.case(case)?;
    let scene = &scene.0;
    let search = safety::Rules::default();
    let question = match safety {
        true => Question::Safety { rules: &search, over: None, known: None },
        false => Question::Results,
    };
    let found = reported(
        py,
        |stop, pass_on| {
            let (executor, of) = (Executor { threads, stop }, (scene, &case));
            errors_of::trust_in(of, question, &rules, &executor, &mut |trial: &Trial| {
                pass_on(trial.clone());
            })
        },
        |py, trial| match &report {
            Some(report) => goes_on(&report.bind(py).call1((json(trial)?,))?),
            None => Ok(true),
        },
    );
    if let Some(raised) = found.raised {
        return Err(raised);
    }
    let answer = found.result.map_err(|wrong| error(py, &wrong))?;
    make(py, &folder)?;
    answer.write(&folder).map_err(|e| errors::output(py, &e.to_string()))?;
    Ok((json(&answer)?, answer.words()))
}

/// Searches for the value of a key at which a result is as wanted; `what`: key, range, width, condition. Gives the answer as JSON.
#[pyfunction]
pub fn find(
    py: Python<'_>,
    scene: &Scene,
    case: Option<&str>,
    what: (String, String, Option<String>, String),
    threads: usize,
    report: Option<Py<PyAny>>,
) -> PyResult<String> {
    let (key, range, width, until) = what;
    let range = Quantity::read(&key, &range, width.as_deref());
    let range = range.map_err(|wrong| refused(wrong.to_string()))?;
    let wanted = Wanted::read(&until).map_err(refused)?;
    let case = scene.case(case)?;
    let scene = &scene.0;
    let rules = safety::Rules::default();
    let found = reported(
        py,
        |stop, pass_on| {
            let executor = Executor { threads, stop };
            let over = (&range, &wanted);
            search::find(scene, &case, over, &rules, &executor, &mut |trial| {
                pass_on((trial.value, trial.result));
            })
        },
        |py, trial: &(f64, Option<f64>)| match &report {
            Some(report) => goes_on(&report.bind(py).call1(*trial)?),
            None => Ok(true),
        },
    );
    if let Some(raised) = found.raised {
        return Err(raised);
    }
    let found = found.result.map_err(|wrong| error(py, &wrong))?;
    let answer = serde_json::json!({
        "key": range.key, "unit": range.unit, "at": found.at, "below": found.below,
        "above": found.above, "monotone": found.monotone, "undecided": found.undecided,
    });
    Ok(answer.to_string())
}
