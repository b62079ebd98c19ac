//! Scenarios: read, changed, checked.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riprap::record::FieldInfo;
use riprap::record::RunFolder;
use riprap::run::engine::Kind;
use riprap::run::forecast::{ForecastError, forecast};
use riprap::run::scene::{self, Prepared};
use riprap::run::study::{StudyError, monte_carlo};
use riprap::scenario::{self, Source, units};

use crate::errors;

/// A scenario with its cases.
#[pyclass(frozen, module = "riprap._riprap")]
pub struct Scene(pub scene::Scene);

impl Scene {
    /// Builds the model of a case; lets go of the interpreter meanwhile.
    pub fn prepare(&self, py: Python<'_>, case: Option<&str>) -> PyResult<Prepared> {
        let case = self.case(case)?;
        py.detach(|| self.0.prepare(&case)).map_err(|wrong| errors::scenario(py, &wrong))
    }

    /// The case of that name, the plain one without.
    pub fn case(&self, name: Option<&str>) -> PyResult<scenario::Case> {
        let Some(name) = name else {
            return Ok(self.0.plain());
        };
        self.0.case(name).ok_or_else(|| {
            let known: Vec<&str> = self.0.cases.iter().map(|c| c.name.as_str()).collect();
            PyValueError::new_err(format!(
                "{} has no case {name:?}; valid cases: {}",
                self.0.path.display(),
                known.join(", ")
            ))
        })
    }
}

#[pymethods]
impl Scene {
    /// Reads a file.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf, changes: Vec<(String, String)>) -> PyResult<Self> {
        py.detach(|| scene::Scene::load(&path, &changes))
            .map(Self)
            .map_err(|wrong| errors::scenario(py, &wrong))
    }

    /// Reads a text; relative paths in it are seen from `folder`.
    #[staticmethod]
    fn parse(
        py: Python<'_>,
        text: String,
        name: String,
        folder: PathBuf,
        changes: Vec<(String, String)>,
    ) -> PyResult<Self> {
        py.detach(|| scene::Scene::parse(Source::new(name, text), folder, &changes))
            .map(Self)
            .map_err(|wrong| errors::scenario(py, &wrong))
    }

    /// Title.
    #[getter]
    fn title(&self) -> &str {
        &self.0.parsed.scenario.title
    }

    /// File, or the name that was given to the text.
    #[getter]
    fn name(&self) -> String {
        self.0.path.display().to_string()
    }

    /// Folder from which relative paths are seen.
    #[getter]
    fn folder(&self) -> PathBuf {
        self.0.parsed.folder.clone()
    }

    /// TOML text with all changes.
    #[getter]
    fn text(&self) -> &str {
        &self.0.parsed.source.text
    }

    /// TOML text of the scene as it stands: without sweep, variants and the checks of these.
    #[getter]
    fn plain_text(&self, py: Python<'_>) -> PyResult<String> {
        let source = &self.0.parsed.source;
        let plain = self.0.plain().source(source, &[]);
        plain.map(|source| source.text).map_err(|wrong| errors::scenario(py, &wrong))
    }

    /// `planar` or `spatial`.
    #[getter]
    fn space(&self) -> &'static str {
        match self.0.parsed.scenario.space {
            scenario::language::Space::Planar(_) => "planar",
            scenario::language::Space::Spatial(_) => "spatial",
        }
    }

    /// Names of the cases: variants and combinations of swept values.
    #[getter]
    fn cases(&self) -> Vec<&str> {
        self.0.cases.iter().map(|case| case.name.as_str()).collect()
    }

    /// The user's changes, key and TOML value.
    #[getter]
    fn changes(&self) -> Vec<(String, String)> {
        self.0.changes.clone()
    }

    /// The scene with the random samples of a case as its cases.
    #[pyo3(signature = (case=None))]
    fn sampled(&self, py: Python<'_>, case: Option<&str>) -> PyResult<Self> {
        let case = self.case(case)?;
        match py.detach(|| monte_carlo::sampled(&self.0, &case)) {
            Ok(sampled) => Ok(Self(sampled)),
            Err(StudyError::Scene(wrong)) => Err(errors::scenario(py, &wrong)),
            Err(wrong) => Err(errors::run(py, &wrong.to_string())),
        }
    }

    /// Builds the model of a case and says what it holds: JSON text, warnings, resolved text.
    #[pyo3(signature = (case=None))]
    fn check<'py>(&self, py: Python<'py>, case: Option<&str>) -> PyResult<Bound<'py, PyDict>> {
        let prepared = self.prepare(py, case)?;
        let model = &prepared.model;
        let expected = py.detach(|| forecast(&model.setup, &model.plan)).map_err(|e| match e {
            ForecastError::Build(e) => errors::run(py, &e.to_string()),
            ForecastError::Step(e) => errors::scenario(py, &e.at(&prepared.parsed)),
            ForecastError::Physics(e) => errors::run(py, &e.to_string()),
        })?;
        let out = PyDict::new(py);
        out.set_item("model", json(&model.summary)?)?;
        out.set_item("expected", json(&expected)?)?;
        out.set_item("input_hash", &prepared.manifest.input_hash)?;
        out.set_item("resolved", &prepared.resolved)?;
        let warnings = errors::list(py, &prepared.parsed.source, &model.warnings)?;
        out.set_item("warnings", warnings)?;
        Ok(out)
    }
}

/// As JSON text; the Python half reads it.
pub fn json(value: &impl serde::Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|e| PyValueError::new_err(e.to_string()))
}

/// Version of riprap.
#[pyfunction]
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// The JSON schema of the scenario language.
#[pyfunction]
pub fn schema() -> String {
    scenario::schema_text()
}

/// What a key of a scenario means.
#[pyfunction]
pub fn explain(key: &str) -> PyResult<String> {
    scenario::explain_key(key).map_err(PyValueError::new_err)
}

/// All fields of `planar` or `spatial` models: (name, unit, components, meaning).
#[pyfunction]
pub fn fields(space: &str) -> PyResult<Vec<(&'static str, &'static str, usize, &'static str)>> {
    let kind = match space {
        "planar" => Kind::Planar,
        "spatial" => Kind::Spatial,
        _ => {
            return Err(PyValueError::new_err(format!(
                "unknown space {space:?}; valid values: planar, spatial"
            )));
        }
    };
    let row = |f: &FieldInfo| (f.name, f.unit, f.shape.components(), f.meaning);
    Ok(kind.fields().iter().map(row).collect())
}

/// SI value of a quantity with its unit, such as `16 GPa`; with `unit` only of what can be measured in it.
#[pyfunction]
#[pyo3(signature = (quantity, unit=None))]
pub fn si(quantity: &str, unit: Option<&str>) -> PyResult<f64> {
    let read = |text: &str| {
        units::parse(text).map_err(|e| {
            let help = e.help.map_or_else(String::new, |h| format!("; {h}"));
            PyValueError::new_err(format!("{text:?}: {}{help}", e.message))
        })
    };
    let (value, dimension) = read(quantity)?;
    let Some(unit) = unit else { return Ok(value) };
    if read(&format!("1 {unit}"))?.1 == dimension {
        return Ok(value);
    }
    Err(PyValueError::new_err(format!(
        "{quantity:?} cannot be converted to {unit}; write for example \"2 {unit}\""
    )))
}

/// The first of `hill.run`, `hill-2.run`, ... that is not taken.
#[pyfunction]
pub fn free_folder(wanted: PathBuf) -> PathBuf {
    RunFolder::free_name(&wanted)
}
