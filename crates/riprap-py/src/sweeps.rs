//! All cases of a scenario side by side.

use std::path::PathBuf;

use pyo3::prelude::*;
use riprap::run::study::Executor;
use riprap::run::study::sweep as sweeps;

use crate::errors;
use crate::look::goes_on;
use crate::runs::{existing, make, reported};
use crate::scene::Scene;

/// Runs all cases into sub-folders of `folder`, `jobs` at a time; `report(case, ended, steps)` is called after each
/// and stops the rest by returning False or raising. Writes the table of what was done as `sweep.csv` and gives it as text.
#[pyfunction]
pub fn sweep(
    py: Python<'_>,
    scene: &Scene,
    folder: PathBuf,
    existing_folder: &str,
    jobs: usize,
    report: Option<Py<PyAny>>,
) -> PyResult<String> {
    let existing = existing(existing_folder)?;
    let scene = &scene.0;
    py.detach(|| sweeps::check_all(scene)).map_err(|wrong| errors::scenario(py, &wrong))?;
    let earlier = sweeps::earlier(&folder, existing);
    let mut rows = Vec::new();
    let ran = reported(
        py,
        |stop, pass_on| {
            let executor = Executor { threads: jobs, stop };
            sweeps::sweep(scene, &folder, existing, &executor, pass_on);
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
