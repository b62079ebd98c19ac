//! Figures of a run: SVG, PNG and PDF, each with the numbers behind it as CSV.
//!
//! `out` decides what is written: `a.svg` the SVG, `a.png` the PNG, `a.pdf` the PDF, `a` SVG and PNG; the numbers go into `a_data.csv` in
//! each case. Every function returns the files it wrote.

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
#![allow(
    clippy::disallowed_methods,
    reason = "pictures only: no result depends on the functions of the platform here"
)]

mod along;
mod arrows;
mod blocks;
mod bolts;
mod chart;
mod colour;
mod compare;
mod crosses;
mod drawing;
pub mod fits;
mod foot;
mod frames;
mod isolines;
mod lettering;
mod lines;
mod load;
mod net;
pub mod paraview;
mod partition;
mod pdf;
mod planes;
mod ppv;
mod rose;
mod run;
mod samples;
mod section;
mod shot;
mod sieve;
mod signals;
mod solid;
mod surface;
mod svg;
mod ticks;

pub use along::{Along, along};
pub use colour::ColourMap;
pub use compare::{Labels, Line, compare};
pub use drawing::{BlockOptions, Normal, Vectors};
pub use frames::{blocks, section, strip, unit_of};
pub use lines::{energy, histories};
pub(crate) use load::crack_surfaces;
pub use load::{Which, load_frame};
pub use net::{Projection, stereonet};
pub use partition::{Share, partition};
pub use ppv::ppv;
/// How choices are named: [`Normal`], [`Projection`], [`Vectors`].
pub use riprap_keys::Words;
pub use rose::rose;
pub use run::Run;
pub use samples::{Sampled, Tornado, histograms, tornado, tornado_with};
pub use shot::{Asked, CHANGED, Cut, Eye, Note, Shot, Trails, is_film, shots};
pub use sieve::{blocks as block_sizes, fits as fits_of_sizes, fragments, passing};
pub use signals::{cavity, spectrum};
pub use surface::{CraterOptions, crater, heave};

use self::svg::Page;
use fits::FitError;
use riprap_record::field::number;
use riprap_record::field::{FieldError, with_unit};
use riprap_record::manifest::{Manifest, ManifestError, Source};
use riprap_record::names::NamesError;
use riprap_record::table::{Series, TableError};
use riprap_record::vtu::ReadError;
use riprap_record::{OutputError, write_whole};
use std::path::{Path, PathBuf};

/// How a picture is written, besides its format.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Look {
    /// What stands over it in place of the title of the scene.
    pub title: Option<String>,
    /// Its width on paper, m. Default: a pixel of the SVG is 1/96 inch.
    pub width: Option<f64>,
    /// Pixels of the PNG per inch. Default 192.
    pub dpi: Option<f64>,
    /// Family of the letters of the SVG; those of PNG and PDF are outlines of DejaVu Sans.
    pub font: Option<String>,
}

/// Where a picture goes, and how it looks: a path alone has the usual look.
#[derive(Clone, Debug)]
pub struct Target<'a> {
    /// File to write; its extension is the format.
    pub path: &'a Path,
    /// How it looks.
    pub look: Look,
}

impl<'a, P: AsRef<Path> + ?Sized> From<&'a P> for Target<'a> {
    fn from(path: &'a P) -> Self {
        Self { path: path.as_ref(), look: Look::default() }
    }
}

/// What a [`PlotError`] is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The disk.
    Output,
    /// The run folder and its files.
    Folder,
    /// What was asked for.
    Request,
}

/// Why a plot was not made.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// Histories or energies.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Frames.
    #[error(transparent)]
    Frame(#[from] ReadError),
    /// Names of blocks.
    #[error(transparent)]
    Names(#[from] NamesError),
    /// Not a run folder.
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    /// No such field.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// The disk.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The run has no frames.
    #[error("{} has no frames; request them in the scene: [[outputs]] with frames = {{ every = \"50 ms\" }}", folder.display())]
    NoFrames {
        /// The run folder.
        folder: PathBuf,
    },
    /// No frame of that number.
    #[error("there is no frame {index}; the run has frames 1 to {count}")]
    NoSuchFrame {
        /// What was asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// No frame at that time.
    #[error(
        "there is no frame at t = {time} s; the frames of the run span t = {first} s to {last} s"
    )]
    OutsideTheRun {
        /// What was asked for in s.
        time: f64,
        /// Time of the first frame in s.
        first: f64,
        /// Time of the last frame in s.
        last: f64,
    },
    /// Nothing to draw.
    #[error("nothing to plot: {what}")]
    NothingToDraw {
        /// What is missing.
        what: String,
    },
    /// The run is not of the kind that the picture needs.
    #[error("cannot draw {picture}: {reason}")]
    Unsuitable {
        /// Which picture.
        picture: &'static str,
        /// What the run lacks, and what to do.
        reason: String,
    },
    /// An option that no picture can be drawn by.
    #[error("{option} cannot be {given}; {wanted}")]
    Option {
        /// Its name.
        option: &'static str,
        /// What was given.
        given: String,
        /// What to give.
        wanted: &'static str,
    },
    /// A file of saved views, or what is in it.
    #[error("{}: {reason}", path.display())]
    View {
        /// The file.
        path: PathBuf,
        /// What is wrong, and what to do.
        reason: String,
    },
    /// Too few or useless numbers for a fit.
    #[error("cannot fit {what}: {reason}")]
    Fit {
        /// What was to be fitted.
        what: String,
        /// Why not.
        reason: FitError,
    },
    /// Neither SVG nor PNG nor PDF.
    #[error("{}: plots are written as .svg, .png or .pdf (SVG and PNG: give a name without extension)", path.display())]
    Ending {
        /// What was asked for.
        path: PathBuf,
    },
    /// The SVG could not be turned into a picture: a fault of ours.
    #[error("could not draw the picture: {reason}; use the extension .svg to get the SVG")]
    Render {
        /// What the renderer said.
        reason: String,
    },
}

impl PlotError {
    /// What it is about.
    #[must_use]
    pub fn fault(&self) -> Fault {
        match self {
            Self::Output(_) => Fault::Output,
            Self::Table(_) | Self::Frame(_) | Self::Names(_) | Self::Manifest(_) => Fault::Folder,
            Self::Field(_)
            | Self::NoFrames { .. }
            | Self::NoSuchFrame { .. }
            | Self::OutsideTheRun { .. }
            | Self::NothingToDraw { .. }
            | Self::Unsuitable { .. }
            | Self::Option { .. }
            | Self::View { .. }
            | Self::Fit { .. }
            | Self::Ending { .. }
            | Self::Render { .. } => Fault::Request,
        }
    }
}

/// The sources of a run, or why the picture cannot be drawn without.
fn sources<'a>(manifest: &'a Manifest, picture: &'static str) -> Result<&'a [Source], PlotError> {
    if manifest.sources.is_empty() {
        let reason = "the run has no sources; this picture needs a blast".to_owned();
        return Err(PlotError::Unsuitable { picture, reason });
    }
    Ok(&manifest.sources)
}

/// The source of that name, or the first.
fn source<'a>(
    manifest: &'a Manifest,
    name: Option<&str>,
    picture: &'static str,
) -> Result<&'a Source, PlotError> {
    let all = sources(manifest, picture)?;
    let Some(name) = name else {
        return Ok(&all[0]);
    };
    all.iter().find(|s| s.name == name).ok_or_else(|| {
        let known: Vec<&str> = all.iter().map(|s| s.name.as_str()).collect();
        let reason = format!("unknown source `{name}`; valid sources: {}", known.join(", "));
        PlotError::Unsuitable { picture, reason }
    })
}

/// The end of a title: after a comma if there is something before it.
fn suffix(manifest: &Manifest, text: &str) -> String {
    let comma = if manifest.title.is_empty() || text.is_empty() { "" } else { ", " };
    format!("{comma}{text}")
}

/// A number for people, with so many digits that count.
fn digits(v: f64, count: usize) -> String {
    if v == 0.0 || !v.is_finite() {
        return format!("{v}");
    }
    let power = v.abs().log10().floor() as i32;
    let text = if (-4..6).contains(&power) {
        format!("{v:.*}", (count as i32 - 1 - power).max(0) as usize)
    } else {
        format!("{v:.*e}", count - 1)
    };
    text.replacen('-', "\u{2212}", 1)
}

fn table_csv(columns: &[&Series]) -> String {
    let head: Vec<String> = columns
        .iter()
        .map(|c| format!("\"{}\"", with_unit(&c.name, &c.unit).replace('"', "\"\"")))
        .collect();
    let mut out = head.join(",");
    out.push('\n');
    let rows = columns.iter().map(|c| c.values.len()).max().unwrap_or(0);
    for i in 0..rows {
        let cells: Vec<String> = columns
            .iter()
            .map(|c| match c.values.get(i) {
                Some(v) if !v.is_nan() => number(*v),
                Some(_) | None => String::new(),
            })
            .collect();
        out.push_str(&cells.join(","));
        out.push('\n');
    }
    out
}

/// A column for [`table_csv`].
fn column(name: &str, unit: &str, values: Vec<f64>) -> Series {
    Series { name: name.to_owned(), unit: unit.to_owned(), values }
}

fn write<'a>(
    page: &Page,
    csv: &str,
    out: impl Into<Target<'a>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let Target { path: out, look } = out.into();
    let ending = out.extension().map(|e| e.to_string_lossy().to_lowercase());
    let formats: &[&str] = match ending.as_deref() {
        None => &["svg", "png"],
        Some("svg") => &["svg"],
        Some("png") => &["png"],
        Some("pdf") => &["pdf"],
        Some(_other) => {
            return Err(PlotError::Ending { path: out.to_owned() });
        }
    };
    let mut files = Vec::new();
    for format in formats {
        let path = if ending.is_some() { out.to_owned() } else { out.with_extension(format) };
        let bytes = match *format {
            "svg" => page.svg(&look).into_bytes(),
            "png" => page.png(&look)?,
            _ => page.pdf(&look)?,
        };
        write_whole(&path, &bytes)?;
        files.push(path);
    }
    // Not `a.csv`: a plot called `energy` inside a run folder would overwrite the run's own table.
    let stem = out.file_stem().unwrap_or_default().to_string_lossy();
    let path = out.with_file_name(format!("{stem}_data.csv"));
    write_whole(&path, csv.as_bytes())?;
    files.push(path);
    Ok(files)
}

#[cfg(test)]
mod tests;
