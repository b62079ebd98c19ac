//! All cases of a scenario side by side.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::record::folder::Existing;
use riprap::run::sweep as sweeps;

use crate::errors;
use crate::runs::existing;
use crate::scene::Scene;

/// Time between two looks for signals.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);

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
    // Of an earlier sweep into this folder: what has finished is kept.
    let earlier = (existing == Existing::Refuse)
        .then(|| riprap::record::read_plain_text(&folder.join("sweep.csv")).ok())
        .flatten();
    let (stop, mut raised, mut rows) = (AtomicBool::new(false), None, Vec::new());
    py.detach(|| {
        std::thread::scope(|scope| {
            let (send, receive) = channel();
            let (stop, folder) = (&stop, &folder);
            scope.spawn(move || {
                let asked = || stop.load(Ordering::Relaxed);
                // The receiver lives until all rows are there.
                let pass_on = |row| drop(send.send(row));
                sweeps::sweep(scene, folder, existing, jobs, &asked, pass_on);
            });
            // This thread stays the interpreter's: signals arrive here.
            loop {
                let row = match receive.recv_timeout(CHECK_INTERVAL) {
                    Ok(row) => Some(row),
                    Err(RecvTimeoutError::Timeout) => None,
                    Err(RecvTimeoutError::Disconnected) => return,
                };
                if let Err(error) = told(row.as_ref(), report.as_ref(), stop) {
                    stop.store(true, Ordering::Relaxed);
                    raised.get_or_insert(error);
                }
                rows.extend(row);
            }
        });
    });
    // What was done is written whatever was raised.
    let written = written(py, &folder, &rows, earlier.as_deref());
    match raised {
        Some(raised) => Err(raised),
        None => written,
    }
}

/// Writes the table.
fn written(
    py: Python<'_>,
    folder: &Path,
    rows: &[sweeps::Row],
    earlier: Option<&str>,
) -> PyResult<String> {
    let table =
        sweeps::table_with(rows, earlier).map_err(|e| PyValueError::new_err(e.to_string()))?;
    std::fs::create_dir_all(folder).map_err(|e| {
        let text = format!("could not make {}: {e}", folder.display());
        errors::output(py, &text)
    })?;
    riprap::record::write_whole(&folder.join("sweep.csv"), &table)
        .map_err(|e| errors::output(py, &e.to_string()))?;
    Ok(String::from_utf8_lossy(&table).into_owned())
}

fn told(row: Option<&sweeps::Row>, report: Option<&Py<PyAny>>, stop: &AtomicBool) -> PyResult<()> {
    Python::attach(|py| {
        py.check_signals()?;
        if let (Some(row), Some(report)) = (row, report) {
            let said = report.bind(py).call1((&row.case, &row.ended, row.steps))?;
            if !said.is_none() && !said.is_truthy()? {
                stop.store(true, Ordering::Relaxed);
            }
        }
        Ok(())
    })
}
