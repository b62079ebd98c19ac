//! All cases of a scenario side by side.

use std::path::PathBuf;

use pyo3::prelude::*;
use riprap::run::study::Executor;
use riprap::run::study::monte_carlo::Summary;
use riprap::run::study::sweep as sweeps;

use crate::errors;
use crate::look::goes_on;
use crate::runs::{existing, make, reported};
use crate::scene::{Scene, json};

/// Runs all cases into sub-folders of `folder`, `jobs` at a time; `report(case, ended, steps)` is called after each
/// and stops the rest by returning False or raising. Writes the table of what was done as `sweep.csv` and gives it as text.
///
/// With `only`, the number of a case, that case is run alone and no table is written: others may be run by other processes.
#[pyfunction]
#[pyo3(signature = (scene, folder, existing_folder, jobs, report, only=None))]
pub fn sweep(
    py: Python<'_>,
    scene: &Scene,
    folder: PathBuf,
    existing_folder: &str,
    jobs: usize,
    report: Option<Py<PyAny>>,
    only: Option<usize>,
) -> PyResult<String> {
    let existing = existing(existing_folder)?;
    let scene = &scene.0;
    let here = only.map(|k| {
        let cases = scene.cases.get(k).cloned().into_iter().collect();
        riprap::run::scene::Scene { cases, ..scene.clone() }
    });
    let here = here.as_ref().unwrap_or(scene);
    py.detach(|| sweeps::check_all(here)).map_err(|wrong| errors::scenario(py, &wrong))?;
    let earlier = sweeps::earlier(&folder, existing);
    let mut rows = Vec::new();
    let ran = reported(
        py,
        |stop, pass_on| {
            let executor = Executor { threads: jobs, stop };
            sweeps::sweep(here, &folder, existing, &executor, pass_on);
        },
        |py, row: &sweeps::Row| {
            rows.push(row.clone());
            match &report {
                Some(report) => {
                    goes_on(&report.bind(py).call1((&row.case, &row.ended, row.steps))?)
                }
                None => Ok(true),
            }
        },
    );
    if only.is_some() {
        return ran.raised.map_or(Ok(String::new()), Err);
    }
    // What was done is written whatever was raised.
    let written = make(py, &folder).and_then(|()| {
        let table = sweeps::write_table(&rows, earlier.as_deref(), &folder);
        table.map_err(|e| errors::output(py, &e.to_string()))
    });
    match ran.raised {
        Some(raised) => Err(raised),
        None => written,
    }
}

/// The table of what other processes have run into `folder`, written as `sweep.csv`; and, of a scene with random values, the numbers
/// of all samples as JSON text, written as `monte_carlo.json`. Runs nothing.
#[pyfunction]
pub fn merged(py: Python<'_>, scene: &Scene, folder: PathBuf) -> PyResult<(String, String)> {
    let scene = &scene.0;
    let rows = py.detach(|| sweeps::merged(scene, &folder));
    let rows = rows.map_err(|wrong| errors::scenario(py, &wrong))?;
    make(py, &folder)?;
    let table = sweeps::write_table(&rows, None, &folder);
    let table = table.map_err(|e| errors::output(py, &e.to_string()))?;
    if scene.parsed.scenario.distributions.is_empty() {
        return Ok((table, String::new()));
    }
    let summary = Summary::of(scene, &rows);
    summary.write(&folder).map_err(|e| errors::output(py, &e.to_string()))?;
    Ok((table, json(&summary)?))
}
