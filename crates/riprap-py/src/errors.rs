//! Errors of the library as exceptions of `riprap.errors`.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use riprap::plot::{Fault, PlotError};
use riprap::run::job::JobError;
use riprap::scenario::{Diagnostic, Diagnostics, Parsed, Severity, Source};

/// An exception of `riprap.errors`, made of a text and named extras.
fn raise<'py>(
    py: Python<'py>,
    name: &str,
    text: &str,
    extras: Option<&Bound<'py, PyDict>>,
) -> PyErr {
    let made = py
        .import("riprap.errors")
        .and_then(|module| module.getattr(name))
        .and_then(|class| class.call((text,), extras));
    match made {
        Ok(exception) => PyErr::from_value(exception),
        // Without the Python half: the text is what matters.
        Err(_) => PyRuntimeError::new_err(text.to_owned()),
    }
}

/// `ScenarioError` with one entry for each remark.
pub fn scenario(py: Python<'_>, wrong: &Diagnostics) -> PyErr {
    let build = || -> PyResult<Bound<'_, PyDict>> {
        let extras = PyDict::new(py);
        extras.set_item("diagnostics", list(py, &wrong.source, &wrong.list)?)?;
        Ok(extras)
    };
    match build() {
        Ok(extras) => raise(py, "ScenarioError", wrong.render().trim_end(), Some(&extras)),
        Err(error) => error,
    }
}

/// Remarks as a list of dictionaries with severity, code, message, help, label, file, line and column.
pub fn list<'py>(
    py: Python<'py>,
    source: &Source,
    remarks: &[Diagnostic],
) -> PyResult<Bound<'py, PyList>> {
    let out = PyList::empty(py);
    for remark in remarks {
        let entry = PyDict::new(py);
        let severity = match remark.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let place = remark.span.as_ref().map(|s| source.line_column(s.start));
        let text = Diagnostics::new(source.clone(), vec![remark.clone()]).render();
        entry.set_item("severity", severity)?;
        entry.set_item("code", remark.code)?;
        entry.set_item("message", &remark.message)?;
        entry.set_item("help", &remark.help)?;
        entry.set_item("label", &remark.label)?;
        entry.set_item("file", &source.name)?;
        entry.set_item("line", place.map(|(line, _)| line))?;
        entry.set_item("column", place.map(|(_, column)| column))?;
        entry.set_item("text", text.trim_end())?;
        out.append(entry)?;
    }
    Ok(out)
}

/// A run that could not be carried out: `OutputError` when results could not be written, else `RunError`.
pub fn job(py: Python<'_>, error: &JobError) -> PyErr {
    raise(py, job_name(error), &error.to_string(), None)
}

/// As [`job`], with what is there all the same.
pub fn job_after(py: Python<'_>, error: &JobError, there: &str) -> PyErr {
    raise(py, job_name(error), &format!("{error}; {there}"), None)
}

fn job_name(error: &JobError) -> &'static str {
    if error.is_output() { "OutputError" } else { "RunError" }
}

/// A file that could not be written.
pub fn output(py: Python<'_>, text: &str) -> PyErr {
    raise(py, "OutputError", text, None)
}

/// As [`job`], at its place in the scenario where it has one.
pub fn job_of(py: Python<'_>, error: &JobError, scene: &Parsed) -> PyErr {
    match error {
        JobError::Step(step) => scenario(py, &step.at(scene)),
        _ => job(py, error),
    }
}

/// A picture that could not be drawn.
pub fn plot(py: Python<'_>, error: &PlotError) -> PyErr {
    let name = match error.fault() {
        Fault::Output => "OutputError",
        Fault::Folder => "FolderError",
        Fault::Request => "PlotError",
    };
    raise(py, name, &error.to_string(), None)
}

/// A file of a run folder that cannot be read.
pub fn folder(py: Python<'_>, error: &dyn std::fmt::Display) -> PyErr {
    raise(py, "FolderError", &error.to_string(), None)
}

/// A file of shapes that cannot be read; the text has its name and the line or the byte.
pub fn shape(py: Python<'_>, text: &str) -> PyErr {
    raise(py, "ShapeError", text, None)
}

/// A question that has no answer in this run.
pub fn run(py: Python<'_>, text: &str) -> PyErr {
    raise(py, "RunError", text, None)
}
