//! Python values as TOML: a scenario can be a dictionary.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, Value};

/// Deepest nesting: more than any scenario needs, less than a dictionary that contains itself.
const DEPTH: usize = 32;

/// The TOML text of a dictionary; keys keep their order, keys whose value is None are left out.
#[pyfunction]
pub fn to_toml(document: &Bound<'_, PyDict>) -> PyResult<String> {
    let table = table(document, "", 0)?;
    Ok(DocumentMut::from(table).to_string())
}

/// The TOML text of one value, as `--set` takes it.
#[pyfunction]
pub fn to_value(value: &Bound<'_, PyAny>) -> PyResult<String> {
    match inline(value, "the value", 0)? {
        Some(value) => Ok(value.to_string()),
        None => Err(PyValueError::new_err("None is not a valid value in a scenario")),
    }
}

/// The text of a scenario with one of its tables replaced, such as `[sweep]`: keys with dots and the lists of their values.
#[pyfunction]
pub fn with_table(text: &str, name: &str, of: &Bound<'_, PyDict>) -> PyResult<String> {
    let mut document: DocumentMut =
        text.parse().map_err(|e: toml_edit::TomlError| PyValueError::new_err(e.to_string()))?;
    document.insert(name, Item::Table(table(of, name, 0)?));
    Ok(document.to_string())
}

fn table(dict: &Bound<'_, PyDict>, path: &str, depth: usize) -> PyResult<Table> {
    deep(path, depth)?;
    let mut out = Table::new();
    for (key, value) in dict.iter() {
        let key = key_of(&key, path)?;
        let place = joined(path, &key);
        let value = plain(value)?;
        if let Ok(inner) = value.cast::<PyDict>() {
            let mut inner = table(inner, &place, depth + 1)?;
            inner.set_implicit(!inner.is_empty());
            out.insert(&key, Item::Table(inner));
        } else if let Some(rows) = rows(&value) {
            let mut tables = ArrayOfTables::new();
            for (i, row) in rows.iter().enumerate() {
                tables.push(table(row, &format!("{place}[{i}]"), depth + 1)?);
            }
            out.insert(&key, Item::ArrayOfTables(tables));
        } else if let Some(value) = inline(&value, &place, depth + 1)? {
            out.insert(&key, Item::Value(value));
        }
    }
    Ok(out)
}

/// A non-empty list of dictionaries.
fn rows<'py>(value: &Bound<'py, PyAny>) -> Option<Vec<Bound<'py, PyDict>>> {
    let items = items(value)?;
    let rows: Vec<Bound<'py, PyDict>> =
        items.iter().map_while(|item| item.cast::<PyDict>().ok().cloned()).collect();
    (!rows.is_empty() && rows.len() == items.len()).then_some(rows)
}

fn items<'py>(value: &Bound<'py, PyAny>) -> Option<Vec<Bound<'py, PyAny>>> {
    if let Ok(list) = value.cast::<PyList>() {
        Some(list.iter().collect())
    } else if let Ok(tuple) = value.cast::<PyTuple>() {
        Some(tuple.iter().collect())
    } else {
        None
    }
}

fn inline(value: &Bound<'_, PyAny>, path: &str, depth: usize) -> PyResult<Option<Value>> {
    deep(path, depth)?;
    let value = plain(value.clone())?;
    if value.is_none() {
        return Ok(None);
    }
    // True is an int in Python.
    if let Ok(flag) = value.cast::<PyBool>() {
        return Ok(Some(flag.is_true().into()));
    }
    if value.is_instance_of::<PyInt>() {
        let number: i64 = value
            .extract()
            .map_err(|_| PyValueError::new_err(format!("{path}: the number is too large")))?;
        return Ok(Some(number.into()));
    }
    if let Ok(number) = value.cast::<PyFloat>() {
        return Ok(Some(number.value().into()));
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(Some(text.to_str()?.into()));
    }
    if let Ok(dict) = value.cast::<PyDict>() {
        let mut out = InlineTable::new();
        for (key, value) in dict.iter() {
            let key = key_of(&key, path)?;
            if let Some(value) = inline(&value, &joined(path, &key), depth + 1)? {
                out.insert(&key, value);
            }
        }
        return Ok(Some(Value::InlineTable(out)));
    }
    if let Some(items) = items(&value) {
        let mut out = Array::new();
        for (i, item) in items.iter().enumerate() {
            let place = format!("{path}[{i}]");
            match inline(item, &place, depth + 1)? {
                Some(value) => out.push(value),
                None => return Err(PyValueError::new_err(format!("{place} is None"))),
            }
        }
        return Ok(Some(Value::Array(out)));
    }
    let kind = value.get_type().name()?;
    Err(PyTypeError::new_err(format!(
        "{path}: a {kind} is not allowed in a scenario; use strings, numbers, lists and dictionaries"
    )))
}

/// Paths as texts, NumPy numbers and arrays as numbers and lists.
fn plain(value: Bound<'_, PyAny>) -> PyResult<Bound<'_, PyAny>> {
    // Texts and floats of NumPy are of Python's own kinds already.
    let known = value.is_instance_of::<PyString>() || value.is_instance_of::<PyFloat>();
    if !known && value.hasattr("__fspath__")? {
        return value.call_method0("__fspath__");
    }
    if !known && value.hasattr("tolist")? {
        return value.call_method0("tolist");
    }
    Ok(value)
}

fn key_of(key: &Bound<'_, PyAny>, path: &str) -> PyResult<String> {
    match key.cast::<PyString>() {
        Ok(text) => Ok(text.to_str()?.to_owned()),
        Err(_) => {
            let place = if path.is_empty() { "the scenario" } else { path };
            Err(PyTypeError::new_err(format!(
                "{place}: the key {} is not a string",
                key.repr()?.to_str()?
            )))
        }
    }
}

fn joined(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

fn deep(path: &str, depth: usize) -> PyResult<()> {
    if depth > DEPTH {
        return Err(PyValueError::new_err(format!(
            "{path}: nested too deeply (does it contain itself?)"
        )));
    }
    Ok(())
}
