//! Shapes in the files of other tools, as the library reads them for scenarios. Lengths are in the unit of the file.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::scenario::foreign::dxf::parse_dxf;
use riprap::scenario::foreign::stl::parse_stl;
use riprap::scenario::foreign::tess::{Cells, parse_tess};
use riprap::scenario::foreign::{FileError, read};

use crate::errors;

/// A line of a drawing: its layer, whether it is closed, its points.
type Line = (String, bool, Vec<[f64; 2]>);
/// A cell: its number, its corners, in space its faces by the places of their corners.
type Cell = (i64, Vec<Vec<f64>>, Option<Vec<Vec<u32>>>);

/// The lines of a DXF drawing, and the length of its unit in m if it names one.
#[pyfunction]
pub fn read_dxf(
    py: Python<'_>,
    path: PathBuf,
    sagitta: Option<f64>,
) -> PyResult<(Option<f64>, Vec<Line>)> {
    if let Some(sagitta) = sagitta.filter(|s| !(s.is_finite() && *s > 0.0)) {
        let text =
            format!("sagitta is {sagitta}; it must be a length above 0 in units of the drawing");
        return Err(PyValueError::new_err(text));
    }
    let drawing = file(py, path, |bytes| parse_dxf(bytes, sagitta))?;
    let lines = drawing.lines.into_iter();
    let lines = lines.map(|line| (line.layer, line.closed, line.points));
    Ok((drawing.unit, lines.collect()))
}

/// The cells of a tessellation of Neper.
#[pyfunction]
pub fn read_tess(py: Python<'_>, path: PathBuf) -> PyResult<Vec<Cell>> {
    let cells = file(py, path, parse_tess)?;
    Ok(match cells {
        Cells::Plane(cells) => {
            let cells = cells.into_iter();
            cells.map(|cell| (cell.number, lists(cell.points), None)).collect()
        }
        Cells::Space(cells) => {
            let cells = cells.into_iter();
            cells.map(|cell| (cell.number, lists(cell.vertices), Some(cell.faces))).collect()
        }
    })
}

/// The corners of each part of a surface in STL.
#[pyfunction]
pub fn read_stl(py: Python<'_>, path: PathBuf) -> PyResult<Vec<Vec<[f64; 3]>>> {
    let parts = file(py, path, parse_stl)?;
    Ok(parts.into_iter().map(|part| part.points).collect())
}

/// What a file holds; lets go of the interpreter while it is read.
fn file<T: Send>(
    py: Python<'_>,
    path: PathBuf,
    parse: impl FnOnce(&[u8]) -> Result<T, FileError> + Send,
) -> PyResult<T> {
    py.detach(|| read(&path, parse)).map_err(|refused| errors::shape(py, &refused.message))
}

fn lists<const N: usize>(points: Vec<[f64; N]>) -> Vec<Vec<f64>> {
    points.into_iter().map(Vec::from).collect()
}
