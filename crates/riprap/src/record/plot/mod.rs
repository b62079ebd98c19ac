//! Figures of a run: SVG and PNG, each with the numbers behind it as CSV.
//!
//! `out` decides what is written: `a.svg` the SVG, `a.png` the PNG, `a` both; the numbers go into `a_data.csv` in
//! each case. Every function returns the files it wrote.

mod blocks;
mod chart;
mod colour;
mod svg;
mod ticks;

pub use blocks::BlockOptions;
pub use colour::ColourMap;

use self::chart::{Curve, Panel};
use self::svg::Page;
use super::disk::{OutputError, write_whole};
use super::field::{FieldError, with_unit};
use super::folder::number;
use super::frame::Frame;
use super::manifest::{Manifest, ManifestError};
use super::table::{Series, Table, TableError};
use super::vtu::{self, ReadError};
use std::path::{Path, PathBuf};

/// Why a plot was not made.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// Histories or energies.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Frames.
    #[error(transparent)]
    Frame(#[from] ReadError),
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
    #[error("{} has no frames; ask for some in the scene: [[outputs]] with frames = {{ every = \"50 ms\" }}", folder.display())]
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
    /// Nothing to draw.
    #[error("nothing to plot: {what}")]
    NothingToDraw {
        /// What is missing.
        what: String,
    },
    /// Neither SVG nor PNG.
    #[error("{}: plots are written as .svg or .png (or both: give a name without an ending)", path.display())]
    Ending {
        /// What was asked for.
        path: PathBuf,
    },
    /// The SVG could not be turned into a PNG: a mistake of ours.
    #[error("could not draw the PNG: {reason}; the SVG can be had with an .svg ending")]
    Render {
        /// What the renderer said.
        reason: String,
    },
}

/// Which frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Which {
    /// The last one.
    Last,
    /// By its number, from 1, as in its file name.
    Index(usize),
    /// The one nearest to a model time in s.
    Time(f64),
}

/// Draws columns of `histories.csv` over time, those of one unit in one panel. No names: all columns.
///
/// Ratios that fall over decades (a column named `...unbalanced...`, no value negative) get a logarithmic axis.
///
/// # Errors
/// Unknown columns (with the nearest name), files that cannot be read or written.
pub fn histories(folder: &Path, columns: &[String], out: &Path) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let table = Table::read(&folder.join("histories.csv"))?;
    let chosen: Vec<&Series> = if columns.is_empty() {
        table
            .columns
            .iter()
            .filter(|c| !["step", "time"].contains(&c.name.as_str()))
            .collect()
    } else {
        columns
            .iter()
            .map(|c| table.column(c))
            .collect::<Result<_, _>>()?
    };
    let time = table.column("time")?;
    need_rows(&table, &chosen)?;
    let mut panels: Vec<Panel> = Vec::new();
    for series in &chosen {
        let log = series.name.contains("unbalanced")
            && series.values.iter().any(|v| *v > 0.0)
            && series.values.iter().all(|v| *v >= 0.0 || v.is_nan());
        let curve = curve(series, &time.values);
        match panels
            .iter_mut()
            .find(|p| p.unit == series.unit && p.log == log)
        {
            Some(panel) => panel.curves.push(curve),
            None => panels.push(Panel {
                name: series.name.clone(),
                unit: series.unit.clone(),
                curves: vec![curve],
                log,
                height: 0.0,
            }),
        }
    }
    let height = if panels.len() == 1 { 360.0 } else { 200.0 };
    for panel in &mut panels {
        panel.height = height;
        if panel.curves.len() > 1 {
            panel.name = quantity(&panel.curves);
        }
    }
    let page = chart::draw(&manifest.title, ("time", "s"), &panels);
    let mut columns = vec![time];
    columns.extend(chosen);
    write(&page, &table_csv(&columns), out)
}

/// Draws the terms of `energy.csv` over time, the residual in a panel of its own.
///
/// # Errors
/// Files that cannot be read or written.
pub fn energy(folder: &Path, out: &Path) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let table = Table::read(&folder.join("energy.csv"))?;
    let time = table.column("time")?;
    let terms: Vec<&Series> = table
        .columns
        .iter()
        .filter(|c| !["step", "time"].contains(&c.name.as_str()) && !c.name.contains("residual"))
        .collect();
    need_rows(&table, &terms)?;
    // Terms that are nil throughout only fill the legend; the numbers still have them.
    let alive = |s: &&&Series| s.values.iter().any(|v| *v != 0.0);
    let mut curves: Vec<Curve> = terms
        .iter()
        .filter(alive)
        .map(|s| curve(s, &time.values))
        .collect();
    if curves.is_empty() {
        curves = terms
            .iter()
            .take(1)
            .map(|s| curve(s, &time.values))
            .collect();
    }
    let unit = terms[0].unit.clone();
    let mut panels = vec![Panel {
        name: "energy".to_owned(),
        unit,
        curves,
        log: false,
        height: 320.0,
    }];
    let mut columns = vec![time];
    columns.extend(&terms);
    for series in table.columns.iter().filter(|c| c.name.contains("residual")) {
        panels.push(Panel {
            name: series.name.replace('_', " "),
            unit: series.unit.clone(),
            curves: vec![curve(series, &time.values)],
            log: false,
            height: 110.0,
        });
        columns.push(series);
    }
    let page = chart::draw(&manifest.title, ("time", "s"), &panels);
    write(&page, &table_csv(&columns), out)
}

/// Draws the block outlines of one frame coloured by a field (`displacement`, `velocity.x`, `rotation`...).
///
/// # Errors
/// Unknown fields (with the nearest name), frames that do not exist, files that cannot be read or written.
pub fn blocks(
    folder: &Path,
    frame: Which,
    field: &str,
    options: BlockOptions,
    out: &Path,
) -> Result<Vec<PathBuf>, PlotError> {
    strip(folder, &[frame], field, options, out)
}

/// Draws several frames with one colour bar.
///
/// # Errors
/// As [`blocks()`].
pub fn strip(
    folder: &Path,
    frames: &[Which],
    field: &str,
    options: BlockOptions,
    out: &Path,
) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let loaded: Vec<Frame> = frames
        .iter()
        .map(|w| load_frame(folder, *w))
        .collect::<Result<_, _>>()?;
    let fields = loaded
        .iter()
        .map(|f| blocks::choose(f, field))
        .collect::<Result<Vec<_>, _>>()?;
    let time = loaded.first().map_or(0.0, |f| f.time);
    let suffix = match (manifest.title.is_empty(), loaded.len()) {
        (_, 2..) => String::new(),
        (true, _) => format!("t = {} s", blocks::short(time)),
        (false, _) => format!(", t = {} s", blocks::short(time)),
    };
    let page = blocks::draw((&manifest.title, &suffix), &loaded, &fields, options)?;
    let name = fields
        .first()
        .map_or_else(String::new, |f| with_unit(&f.name, &f.unit));
    let mut csv = format!("time [s],block,x [m],y [m],\"{name}\"\n");
    for (frame, field) in loaded.iter().zip(&fields) {
        // Removed blocks leave no gap in a frame, so the place in it is not always the block's number.
        let ids = frame
            .block_columns
            .iter()
            .find(|c| c.name == "block" && c.components == 1);
        for (i, value) in field.values.iter().enumerate() {
            let id = ids.map_or(i as f64, |c| c.data[i]);
            let [x, y] = middle(frame.outline(i));
            let cells = [frame.time, id, x, y, *value].map(number).join(",");
            csv.push_str(&cells);
            csv.push('\n');
        }
    }
    write(&page, &csv, out)
}

/// A line for [`compare`].
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its name in the legend.
    pub name: String,
    /// Abscissae, ascending in a reference.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
}

/// Words around a [`compare`] plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Labels {
    /// Title.
    pub title: String,
    /// Name and unit of the abscissa.
    pub x: (String, String),
    /// Name and unit of the ordinate.
    pub y: (String, String),
}

/// Draws computed values (dots) over a reference (line), and their difference below.
///
/// The reference is interpolated linearly at the computed abscissae; outside its range there is no difference.
///
/// # Errors
/// Empty lines, files that cannot be written.
pub fn compare(
    computed: &Line,
    reference: &Line,
    labels: &Labels,
    out: &Path,
) -> Result<Vec<PathBuf>, PlotError> {
    for line in [computed, reference] {
        if line.x.is_empty() || line.x.len() != line.y.len() {
            let what = format!(
                "`{}` has {} abscissae and {} values",
                line.name,
                line.x.len(),
                line.y.len()
            );
            return Err(PlotError::NothingToDraw { what });
        }
    }
    let at: Vec<f64> = computed
        .x
        .iter()
        .map(|x| interpolated(reference, *x))
        .collect();
    let difference: Vec<f64> = computed.y.iter().zip(&at).map(|(a, b)| a - b).collect();
    let line = |l: &Line, dots| Curve {
        name: l.name.clone(),
        x: l.x.clone(),
        y: l.y.clone(),
        dots,
    };
    let (name, unit) = labels.y.clone();
    let panels = [
        Panel {
            name,
            unit: unit.clone(),
            curves: vec![line(reference, false), line(computed, true)],
            log: false,
            height: 320.0,
        },
        Panel {
            name: "difference".to_owned(),
            unit,
            curves: vec![Curve {
                name: String::new(),
                x: computed.x.clone(),
                y: difference.clone(),
                dots: false,
            }],
            log: false,
            height: 110.0,
        },
    ];
    let page = chart::draw(&labels.title, (&labels.x.0, &labels.x.1), &panels);
    let series = |name: &str, (_, unit): &(String, String), values: &[f64]| Series {
        name: name.to_owned(),
        unit: unit.clone(),
        values: values.to_vec(),
    };
    let columns = [
        series(&labels.x.0, &labels.x, &computed.x),
        series(&computed.name, &labels.y, &computed.y),
        series(&reference.name, &labels.y, &at),
        series("difference", &labels.y, &difference),
    ];
    let columns: Vec<&Series> = columns.iter().collect();
    write(&page, &table_csv(&columns), out)
}

/// Reads a frame of a run folder.
///
/// # Errors
/// No frames, no such frame, files that cannot be read.
pub fn load_frame(folder: &Path, which: Which) -> Result<Frame, PlotError> {
    let list = vtu::read_pvd(&folder.join("run.pvd"))?;
    if list.is_empty() {
        return Err(PlotError::NoFrames {
            folder: folder.to_owned(),
        });
    }
    let at = match which {
        Which::Last => list.len() - 1,
        Which::Index(index) => match index.checked_sub(1) {
            Some(i) if i < list.len() => i,
            Some(_) | None => {
                return Err(PlotError::NoSuchFrame {
                    index,
                    count: list.len(),
                });
            }
        },
        Which::Time(t) => {
            let gap = |i: &usize| (list[*i].time - t).abs();
            (0..list.len())
                .min_by(|a, b| gap(a).total_cmp(&gap(b)))
                .unwrap_or(0)
        }
    };
    let contacts = vtu::read_pvd(&folder.join("contacts.pvd"))?;
    let contacts = contacts.get(at).map(|c| folder.join(&c.file));
    Ok(vtu::read_frame(
        &folder.join(&list[at].file),
        contacts.as_deref(),
    )?)
}

fn curve(series: &Series, time: &[f64]) -> Curve {
    Curve {
        name: series.name.replace('_', " "),
        x: time.to_vec(),
        y: series.values.clone(),
        dots: false,
    }
}

/// The name of a panel of several curves: what their names share at the end, or nothing but the unit.
fn quantity(curves: &[Curve]) -> String {
    let tail = |c: &Curve| c.name.rsplit('.').next().unwrap_or_default().to_owned();
    let first = curves.first().map(tail).unwrap_or_default();
    if curves.iter().all(|c| tail(c) == first) {
        first
    } else {
        "value".to_owned()
    }
}

fn need_rows(table: &Table, chosen: &[&Series]) -> Result<(), PlotError> {
    let what = if chosen.is_empty() {
        "columns besides step and time"
    } else if chosen[0].values.is_empty() {
        "complete rows"
    } else {
        return Ok(());
    };
    let what = format!("{} has no {what}", table.path.display());
    Err(PlotError::NothingToDraw { what })
}

fn interpolated(line: &Line, x: f64) -> f64 {
    let i = line.x.partition_point(|v| *v < x);
    if i < line.x.len() && line.x[i] == x {
        return line.y[i];
    }
    if i == 0 || i == line.x.len() {
        return f64::NAN;
    }
    let (x0, x1, y0, y1) = (line.x[i - 1], line.x[i], line.y[i - 1], line.y[i]);
    y0 + (y1 - y0) * (x - x0) / (x1 - x0)
}

fn middle(outline: &[[f64; 3]]) -> [f64; 2] {
    // Centroid by triangles from the first vertex, which keeps its digits far from the origin.
    let [ox, oy, _] = outline.first().copied().unwrap_or_default();
    let (mut area, mut x, mut y) = (0.0, 0.0, 0.0);
    for pair in outline.windows(2) {
        let (ax, ay, bx, by) = (
            pair[0][0] - ox,
            pair[0][1] - oy,
            pair[1][0] - ox,
            pair[1][1] - oy,
        );
        let cross = ax * by - bx * ay;
        area += cross;
        x += cross * (ax + bx) / 3.0;
        y += cross * (ay + by) / 3.0;
    }
    if area == 0.0 {
        [ox, oy]
    } else {
        [ox + x / area, oy + y / area]
    }
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

fn write(page: &Page, csv: &str, out: &Path) -> Result<Vec<PathBuf>, PlotError> {
    let ending = out.extension().map(|e| e.to_string_lossy().to_lowercase());
    let (svg, png) = match ending.as_deref() {
        None => (
            Some(out.with_extension("svg")),
            Some(out.with_extension("png")),
        ),
        Some("svg") => (Some(out.to_owned()), None),
        Some("png") => (None, Some(out.to_owned())),
        Some(_other) => {
            return Err(PlotError::Ending {
                path: out.to_owned(),
            });
        }
    };
    let text = page.svg();
    let mut files = Vec::new();
    if let Some(path) = svg {
        write_whole(&path, text.as_bytes())?;
        files.push(path);
    }
    if let Some(path) = png {
        write_whole(&path, &svg::png(&text)?)?;
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
