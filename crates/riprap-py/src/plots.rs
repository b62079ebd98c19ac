//! Pictures of a run folder, drawn by the library.

use std::path::{Path, PathBuf};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use riprap::plot as drawn;
use riprap::plot::{
    Along, BlockOptions, CraterOptions, Look, PlotError, Projection, Run, Target, Which, Words,
};
use riprap::scenario::units;

use crate::errors;

/// How a picture is drawn; keywords of `riprap.RunFolder.plot`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    by: String,
    times: Vec<f64>,
    names: Vec<String>,
    against: Option<String>,
    log: bool,
    vectors: Option<String>,
    stress: bool,
    cracks: bool,
    isolines: usize,
    window: Option<[f64; 4]>,
    exaggerate: Option<f64>,
    normal: String,
    at: Option<f64>,
    line: Option<[Vec<f64>; 2]>,
    surface: bool,
    uplift: Option<f64>,
    source: Option<String>,
    of: Option<String>,
    projection: String,
    range: Option<[Bound; 2]>,
    percentiles: Option<[f64; 2]>,
    title: Option<String>,
    size: Option<f64>,
    dpi: Option<f64>,
    font: Option<String>,
}

/// A value of a field: with its unit, or in SI.
#[derive(FromPyObject)]
enum Bound {
    Number(f64),
    Text(String),
}

impl Bound {
    /// The value in the unit of a field.
    fn of(&self, field: &str, unit: &str) -> PyResult<f64> {
        match self {
            Self::Number(value) => Ok(*value),
            Self::Text(text) => units::value_in(text, unit).ok_or_else(|| {
                let of =
                    if unit == "-" { "has no unit".to_owned() } else { format!("is in {unit}") };
                PyValueError::new_err(format!(
                    "range: {text:?} is no value of {field:?}, which {of}"
                ))
            }),
        }
    }
}

/// Draws `what` of a run folder into `out` (`.svg`, `.png`, `.pdf`; SVG and PNG without an ending); gives the files written.
#[pyfunction]
pub fn plot(
    py: Python<'_>,
    folder: PathBuf,
    what: &str,
    out: PathBuf,
    options: Options,
) -> PyResult<Vec<PathBuf>> {
    let (blocks, look) = (options.blocks(py, &folder, what)?, options.look()?);
    let projection = named("projection", &options.projection)?;
    let known = [
        "histories",
        "energy",
        "blocks",
        "section",
        "line",
        "ppv",
        "crater",
        "heave",
        "cavity",
        "spectrum",
        "stereonet",
        "rose",
        "fragments",
    ];
    // Any other word would be drawn as histories.
    if !known.contains(&what) {
        return Err(PyValueError::new_err(format!(
            "unknown picture {what:?}; valid pictures: {}",
            known.join(", ")
        )));
    }
    let whole = ["histories", "energy", "cavity", "spectrum"];
    if options.of.is_some() && whole.contains(&what) {
        return Err(PyValueError::new_err(format!(
            "of= chooses blocks, and {what:?} is of the whole run"
        )));
    }
    if let Some(parent) = out.parent().filter(|p| !p.as_os_str().is_empty()) {
        std::fs::create_dir_all(parent)?;
    }
    py.detach(|| options.draw(&folder, what, (blocks, projection), Target { path: &out, look }))
        .map_err(|e| errors::plot(py, &e))
}

/// The choice that a keyword names.
fn named<T: Words>(keyword: &str, word: &str) -> PyResult<T> {
    T::named(word).ok_or_else(|| {
        let words: Vec<String> = T::NAMES.iter().map(|word| format!("{word:?}")).collect();
        let words = words.join(", ");
        PyValueError::new_err(format!("{keyword}={word:?}; write one of {words}"))
    })
}

/// How blocks in space are drawn; keywords of `riprap.shot`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ShotOptions {
    by: Option<String>,
    times: Vec<f64>,
    all: bool,
    view: Option<[f64; 2]>,
    perspective: Option<f64>,
    saved: Option<String>,
    views: Option<PathBuf>,
    size: Option<[u32; 2]>,
    cut: Option<String>,
    at: Option<f64>,
    log: bool,
    range: Option<[Bound; 2]>,
    percentiles: Option<[f64; 2]>,
    exaggerate: Option<f64>,
    bolts: bool,
    shadows: bool,
    chains: bool,
    contacts: Option<String>,
    trails: Option<String>,
    vectors: Option<String>,
    of: Option<String>,
    fps: Option<f64>,
}

/// Draws blocks in space into `out` (`.png`, `.apng`); gives the files written.
#[pyfunction]
pub fn shot(
    py: Python<'_>,
    folder: PathBuf,
    out: PathBuf,
    options: ShotOptions,
) -> PyResult<Vec<PathBuf>> {
    let mut frames: Vec<Which> = options.times.iter().map(|t| Which::Time(*t)).collect();
    if frames.is_empty() && !options.all && !drawn::is_film(&out) {
        frames.push(Which::Last);
    }
    let shot = options.shot(py, &folder, frames.first().copied().unwrap_or(Which::Last))?;
    if let Some(parent) = out.parent().filter(|p| !p.as_os_str().is_empty()) {
        std::fs::create_dir_all(parent)?;
    }
    let run = Run { folder: &folder, of: options.of.as_deref() };
    py.detach(|| drawn::shots(run, &frames, &shot, options.fps, &out))
        .map_err(|e| errors::plot(py, &e))
}

impl ShotOptions {
    fn shot(&self, py: Python<'_>, folder: &Path, first: Which) -> PyResult<drawn::Shot> {
        let asked = drawn::Asked {
            saved: self.saved.as_deref(),
            views: self.views.as_deref(),
            field: self.by.as_deref(),
            view: self.view,
            perspective: self.perspective,
        };
        let told = |e: &PlotError| errors::plot(py, e);
        let mut shot = drawn::Shot::asked(folder, first, &asked).map_err(|e| told(&e))?;
        if let Some(axis) = &self.cut {
            let at = self.at.ok_or_else(|| {
                PyValueError::new_err("a cut needs its place: cut=\"y\", at=\"2 m\"")
            })?;
            shot.cut = Some(drawn::Cut::nearer(named("cut", axis)?, at, &shot.eye));
        }
        let old = shot.options;
        let range = match &self.range {
            Some([low, high]) => {
                let unit = drawn::unit_of(folder, first, &shot.field).map_err(|e| told(&e))?;
                Some([low.of(&shot.field, &unit)?, high.of(&shot.field, &unit)?])
            }
            None => old.range.filter(|_| self.percentiles.is_none()),
        };
        shot.options = BlockOptions {
            log: old.log || self.log,
            range,
            percentiles: self.percentiles,
            exaggeration: self.exaggerate.or(old.exaggeration),
            ..old
        };
        shot.bolts &= self.bolts;
        shot.shadows &= self.shadows;
        shot.chains |= self.chains;
        match self.contacts.as_deref() {
            None => {}
            Some("changed") => shot.contacts = Some(drawn::CHANGED),
            Some("all") => shot.contacts = Some(drawn::CHANGED.map(|_| true)),
            Some(other) => return Err(unknown("contacts", other, r#""changed", "all""#)),
        }
        match self.trails.as_deref() {
            None => {}
            Some("speed") => shot.trails = Some(drawn::Trails { by_block: false, only: None }),
            Some("block") => shot.trails = Some(drawn::Trails { by_block: true, only: None }),
            Some(other) => return Err(unknown("trails", other, r#""speed", "block""#)),
        }
        if self.vectors.is_some() {
            shot.vectors.clone_from(&self.vectors);
        }
        shot.size = self.size.unwrap_or(shot.size);
        Ok(shot)
    }
}

fn unknown(option: &str, given: &str, known: &str) -> PyErr {
    PyValueError::new_err(format!("{option}={given:?}; write one of {known}"))
}

impl Options {
    /// Values of the first and the last colour, in the unit of the field; only pictures coloured by it read them.
    fn range(&self, py: Python<'_>, folder: &Path, what: &str) -> PyResult<Option<[f64; 2]>> {
        let Some([low, high]) =
            self.range.as_ref().filter(|_| ["blocks", "section"].contains(&what))
        else {
            return Ok(None);
        };
        let frame = self.times.first().map_or(Which::Last, |time| Which::Time(*time));
        let unit = drawn::unit_of(folder, frame, &self.by).map_err(|e| errors::plot(py, &e))?;
        Ok(Some([low.of(&self.by, &unit)?, high.of(&self.by, &unit)?]))
    }

    fn blocks(&self, py: Python<'_>, folder: &Path, what: &str) -> PyResult<BlockOptions> {
        let vectors = self.vectors.as_deref();
        let vectors = vectors.map(|word| named("vectors", word)).transpose()?;
        let normal = named("normal", &self.normal)?;
        Ok(BlockOptions {
            contacts: false,
            log: self.log,
            vectors,
            stress: self.stress,
            cracks: self.cracks,
            isolines: self.isolines,
            window: self.window,
            exaggeration: self.exaggerate,
            normal,
            at: self.at,
            range: self.range(py, folder, what)?,
            percentiles: self.percentiles,
        })
    }

    fn look(&self) -> PyResult<Look> {
        if self.size.is_some_and(|width| !(0.001..=100.0).contains(&width)) {
            let why =
                "size is the width on paper, from 1 mm to 100 m; write for example size=\"160 mm\"";
            return Err(PyValueError::new_err(why));
        }
        if self.dpi.is_some_and(|dpi| !(dpi.is_finite() && dpi > 0.0)) {
            return Err(PyValueError::new_err("dpi is a positive number"));
        }
        let (title, font) = (self.title.clone(), self.font.clone());
        Ok(Look { title, width: self.size, dpi: self.dpi, font })
    }

    fn draw(
        &self,
        folder: &Path,
        what: &str,
        (blocks, projection): (BlockOptions, Projection),
        out: Target<'_>,
    ) -> Result<Vec<PathBuf>, PlotError> {
        let given: Vec<Which> = self.times.iter().map(|t| Which::Time(*t)).collect();
        let frames = if given.is_empty() { vec![Which::Last] } else { given.clone() };
        let source = self.source.as_deref();
        let run = Run { folder, of: self.of.as_deref() };
        match what {
            "energy" => drawn::energy(folder, out),
            "blocks" => drawn::strip(run, &frames, &self.by, blocks, out),
            "section" => drawn::section(run, &frames, &self.by, blocks, out),
            "line" => {
                let nowhere = || PlotError::NothingToDraw {
                    what: "a line needs two ends: line=((0, 3), (0, 12))".to_owned(),
                };
                let [from, to] = self.line.as_ref().ok_or_else(nowhere)?;
                let line = Along { from: from.clone(), to: to.clone() };
                drawn::along(run, &frames, &self.by, &line, out)
            }
            "ppv" => drawn::ppv(run, frames[0], self.surface, out),
            "crater" => {
                let options = CraterOptions { uplift: self.uplift, source };
                drawn::crater(run, frames[0], options, out)
            }
            "heave" => drawn::heave(run, &given, source, blocks.normal, out),
            "cavity" => drawn::cavity(folder, out),
            "stereonet" => drawn::stereonet(run, frames[0], projection, out),
            "rose" => drawn::rose(run, frames[0], out),
            "fragments" => drawn::fragments(run, out),
            "spectrum" => match self.names.first() {
                Some(name) => drawn::spectrum(folder, name, out),
                None => Err(PlotError::NothingToDraw {
                    what: "a spectrum needs exactly one history: names=[\"...\"]".to_owned(),
                }),
            },
            _ => drawn::histories(folder, &self.names, self.against.as_deref(), out),
        }
    }
}
