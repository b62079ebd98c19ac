//! Contact laws that are Python functions.

use std::sync::{Arc, Mutex};

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riprap::run::simulation::{ContactLaw, Contacts};

use crate::arrays;

/// What a function raised.
pub type Raised = Arc<Mutex<Option<PyErr>>>;

/// A function that is called with a dictionary of arrays and gives tractions and memory.
#[derive(Debug)]
pub struct Law {
    function: Py<PyAny>,
    width: usize,
    raised: Raised,
}

impl Law {
    /// One that puts what `function` raises into `raised`.
    pub fn new(function: Py<PyAny>, width: usize, raised: Raised) -> Self {
        Self { function, width, raised }
    }

    fn call(&self, py: Python<'_>, contacts: &mut Contacts) -> PyResult<Vec<[f64; 3]>> {
        let shown = PyDict::new(py);
        let three = |of: &[[f64; 3]]| arrays::rows(py, of.as_flattened().to_vec(), 3);
        shown.set_item("time", contacts.time)?;
        let blocks: Vec<i64> = contacts.blocks.iter().flatten().map(|b| i64::from(*b)).collect();
        shown.set_item(
            "blocks",
            PyArray1::from_vec(py, blocks).reshape([contacts.blocks.len(), 2])?,
        )?;
        shown.set_item("joint", PyArray1::from_vec(py, contacts.joint.clone()))?;
        shown.set_item("area", PyArray1::from_vec(py, contacts.area.clone()))?;
        for (name, of) in [
            ("point", &contacts.point),
            ("normal", &contacts.normal),
            ("displacement", &contacts.displacement),
            ("velocity", &contacts.velocity),
            ("force_on_a", &contacts.force),
        ] {
            shown.set_item(name, three(of)?)?;
        }
        shown.set_item("memory", PyArray1::from_slice(py, &contacts.memory))?;
        let answer = self.function.bind(py).call1((shown,))?;
        let (tractions, memory): (PyReadonlyArray2<'_, f64>, PyReadonlyArray1<'_, f64>) =
            answer.extract()?;
        contacts.memory = memory.as_array().to_vec();
        let rows = tractions.as_array();
        Ok(rows.rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect())
    }
}

impl ContactLaw for Law {
    fn memory(&self) -> usize {
        self.width
    }

    fn tractions(&mut self, contacts: &mut Contacts) -> Result<Vec<[f64; 3]>, String> {
        Python::attach(|py| {
            self.call(py, contacts).map_err(|error| {
                let why = format!("it raised {error}");
                if let Ok(mut raised) = self.raised.lock() {
                    *raised = Some(error);
                }
                why
            })
        })
    }
}
