//! Pictures of frames: block outlines in the plane, cuts through solids in space.

use super::blocks::{self, Words};
use super::drawing::{BlockOptions, Chosen, Vectors, choose, middle, short};
use super::load::{Which, load_frame};
use super::run::Run;
use super::section::{self, need_space};
use super::{PlotError, Target, write};
use riprap_record::field::number;
use riprap_record::field::with_unit;
use riprap_record::frame::{Frame, stress};
use riprap_record::manifest::Manifest;
use riprap_record::vtu;
use std::path::{Path, PathBuf};

/// Unit of a field of blocks, as the frames of a run have it; `-` without.
///
/// # Errors
/// Unknown fields (with the nearest name), frames that do not exist or cannot be read.
pub fn unit_of(folder: &Path, frame: Which, field: &str) -> Result<String, PlotError> {
    let frame = load_frame(folder, frame)?;
    Ok(choose(&frame, field)?.unit)
}

/// Draws the blocks of one frame coloured by a field (`displacement`, `velocity.x`, `rotation`...).
///
/// # Errors
/// As [`strip`].
pub fn blocks<'r, 't>(
    run: impl Into<Run<'r>>,
    frame: Which,
    field: &str,
    options: BlockOptions,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    strip(run, &[frame], field, options, out)
}

/// Draws several frames with one colour bar: outlines of a run in the plane, cuts of a run in space.
///
/// # Errors
/// Unknown fields (with the nearest name), frames that do not exist, a cut that meets no block, files that cannot be
/// read or written.
pub fn strip<'r, 't>(
    run: impl Into<Run<'r>>,
    frames: &[Which],
    field: &str,
    options: BlockOptions,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    drawn(run, load_frames(run, frames)?, field, options, out)
}

/// Draws cuts through frames of a run in space; as [`strip`], which takes runs in the plane too.
///
/// # Errors
/// A run in the plane, and as [`strip`].
pub fn section<'r, 't>(
    run: impl Into<Run<'r>>,
    frames: &[Which],
    field: &str,
    options: BlockOptions,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let loaded = load_frames(run, frames)?;
    for frame in &loaded {
        need_space(frame, "a section")?;
    }
    drawn(run, loaded, field, options, out)
}

/// Refuses a column of tensor components asked for as a whole: the root of their squares is no stress of the block and
/// turns with the axes.
fn whole_tensor(frame: &Frame, field: &str) -> Result<(), PlotError> {
    let bare = field.strip_prefix("block.").unwrap_or(field);
    let space = frame.solids.is_some();
    let parts: &[(&str, &str)] = match (bare, space) {
        (stress::NORMAL, false) => &[("x", "xx"), ("y", "yy")],
        (stress::NORMAL, true) => &[("x", "xx"), ("y", "yy"), ("z", "zz")],
        (stress::SHEAR, true) => &[("x", "yz"), ("y", "zx"), ("z", "xy")],
        _ => return Ok(()),
    };
    if choose(frame, field).is_err() {
        // That it is not there is said by what draws it.
        return Ok(());
    }
    let principal: Vec<&str> = frame
        .block_columns
        .iter()
        .map(|column| column.name.as_str())
        .filter(|name| name.starts_with("sigma"))
        .collect();
    let principal = match principal[..] {
        [] => String::new(),
        _ => format!(", or for a principal stress: {}", principal.join(", ")),
    };
    let parts: Vec<String> =
        parts.iter().map(|(part, means)| format!("`{bare}.{part}` ({means})")).collect();
    Err(PlotError::Unsuitable {
        picture: "several stress components in one picture",
        reason: format!(
            "choose one of {}{principal}; --stress draws principal stresses as crosses",
            parts.join(", ")
        ),
    })
}

/// Draws loaded frames.
fn drawn<'t>(
    run: Run<'_>,
    loaded: Vec<Frame>,
    field: &str,
    options: BlockOptions,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    options.checked()?;
    let manifest = Manifest::read(run.folder)?;
    let fields = loaded
        .iter()
        .map(|f| {
            whole_tensor(f, field)?;
            Ok(choose(f, field)?)
        })
        .collect::<Result<Vec<_>, PlotError>>()?;
    // Flows are no field of blocks.
    if let Some(vectors) = options.vectors.filter(|v| *v != Vectors::Flow) {
        for frame in &loaded {
            choose(frame, vectors.column())?;
        }
    }
    if options.stress {
        for frame in &loaded {
            choose(frame, stress::SHEAR)?;
        }
    }
    let picture = section::flattened(loaded, fields, &manifest, options)?;
    let mut said = picture.suffix;
    if let Some(factor) = options.exaggeration.filter(|f| *f != 1.0) {
        said.push(format!("displacements \u{d7} {}", short(factor)));
    }
    let moments =
        picture.frames.iter().map(|f| moment(run.folder, f)).collect::<Result<Vec<_>, _>>()?;
    if let [only] = &moments[..] {
        said.push(only.clone());
    }
    let suffix = run.suffix(&manifest, &said.join(", "));
    // Runs of earlier versions do not name their materials.
    let kinds = ["material", "block.material"].contains(&field) && !manifest.materials.is_empty();
    let words = Words {
        kinds: kinds.then_some(&manifest.materials[..]),
        title: &manifest.title,
        suffix: &suffix,
        moments: &moments,
        axes: picture.axes,
        sources: picture.sources,
    };
    let page = blocks::draw(&words, &picture.frames, &picture.fields, options)?;
    let csv = numbers(&picture.frames, &picture.fields, picture.axes);
    write(&page, &csv, out)
}

fn numbers(frames: &[Frame], fields: &[Chosen], axes: [&str; 2]) -> String {
    let name = fields.first().map_or_else(String::new, |f| with_unit(&f.name, &f.unit));
    let mut csv = format!("time [s],block,{} [m],{} [m],\"{name}\",step\n", axes[0], axes[1]);
    for (frame, field) in frames.iter().zip(fields) {
        // Removed blocks leave no gap in a frame, so the place in it is not always the block's number.
        let ids = frame.column("block").filter(|c| c.components == 1);
        for (i, value) in field.values.iter().enumerate() {
            let id = ids.map_or(i as f64, |c| c.data[i]);
            let [x, y] = middle(frame.outline(i));
            let cells = [frame.time, id, x, y, *value, frame.step as f64];
            let cells = cells.map(number).join(",");
            csv.push_str(&cells);
            csv.push('\n');
        }
    }
    csv
}

/// When a frame is, in words. Model time stands still in static phases: where several frames have one time, phase and
/// step tell them apart.
pub(super) fn moment(folder: &Path, frame: &Frame) -> Result<String, PlotError> {
    let list = vtu::read_pvd(&folder.join("run.pvd"))?;
    let time = format!("t = {} s", short(frame.time));
    if list.iter().filter(|e| e.time == frame.time).count() < 2 {
        return Ok(time);
    }
    let mut parts = Vec::new();
    if frame.time != 0.0 {
        parts.push(time);
    }
    if !frame.phase.is_empty() {
        parts.push(format!("phase {}", frame.phase));
    }
    parts.push(format!("step {}", frame.step));
    Ok(parts.join(", "))
}

/// Reads frames of a run.
fn load_frames(run: Run<'_>, frames: &[Which]) -> Result<Vec<Frame>, PlotError> {
    frames.iter().map(|w| run.frame(*w)).collect()
}
