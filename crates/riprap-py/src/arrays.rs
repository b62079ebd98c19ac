//! Frames and tables as NumPy arrays. The arrays take over the memory: nothing is copied.

use std::path::PathBuf;

use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use riprap::record::table::Table;
use riprap::record::{Column, Frame, vtu};
use riprap::run::engine::Nodes;

use crate::errors;

/// Numbers of a vector as an array.
fn vector<T: Element>(py: Python<'_>, data: Vec<T>) -> Bound<'_, PyAny> {
    PyArray1::from_vec(py, data).into_any()
}

/// Numbers as an array of rows.
pub fn rows(py: Python<'_>, data: Vec<f64>, width: usize) -> PyResult<Bound<'_, PyAny>> {
    let count = data.len() / width.max(1);
    Ok(PyArray1::from_vec(py, data).reshape([count, width])?.into_any())
}

fn columns(py: Python<'_>, columns: Vec<Column>) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    for column in columns {
        let array = if column.components == 1 {
            vector(py, column.data)
        } else {
            rows(py, column.data, column.components)?
        };
        out.set_item(column.name, (array, column.unit))?;
    }
    Ok(out)
}

/// A frame as a dictionary of arrays.
pub fn frame(py: Python<'_>, frame: Frame) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("step", frame.step)?;
    out.set_item("time", frame.time)?;
    out.set_item("phase", frame.phase)?;
    out.set_item("offsets", vector(py, frame.offsets))?;
    out.set_item("points", rows(py, frame.points.into_flattened(), 3)?)?;
    out.set_item("blocks", columns(py, frame.block_columns)?)?;
    out.set_item("contact_points", rows(py, frame.contact_points.into_flattened(), 3)?)?;
    out.set_item("contacts", columns(py, frame.contact_columns)?)?;
    let solids = match frame.solids {
        None => None,
        Some(s) => Some((vector(py, s.faces), vector(py, s.ends), vector(py, s.corners))),
    };
    out.set_item("solids", solids)?;
    Ok(out)
}

/// Nodes as arrays: places, displacements, velocities, masses.
pub fn nodes(py: Python<'_>, nodes: Nodes) -> PyResult<[Bound<'_, PyAny>; 4]> {
    let Nodes { points, displacements, velocities, masses } = nodes;
    let three = |of: Vec<[f64; 3]>| rows(py, of.into_flattened(), 3);
    Ok([three(points)?, three(displacements)?, three(velocities)?, vector(py, masses)])
}

/// Reads a frame of a run folder from its two files.
#[pyfunction]
#[pyo3(signature = (blocks, contacts=None))]
pub fn read_frame(
    py: Python<'_>,
    blocks: PathBuf,
    contacts: Option<PathBuf>,
) -> PyResult<Bound<'_, PyDict>> {
    let read = py
        .detach(|| vtu::read_frame(&blocks, contacts.as_deref()))
        .map_err(|e| errors::folder(py, &e))?;
    frame(py, read)
}

/// Reads a CSV file of a run: a list of (name, unit, values).
#[pyfunction]
pub fn read_table(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyList>> {
    let table = py.detach(|| Table::read(&path)).map_err(|e| errors::folder(py, &e))?;
    let out = PyList::empty(py);
    for column in table.columns {
        out.append((column.name, column.unit, vector(py, column.values)))?;
    }
    Ok(out)
}
