//! Pictures of frames: block outlines in the plane, cuts through solids in space.

use super::blocks::{self, Words};
use super::drawing::{BlockOptions, Chosen, Vectors, choose, middle, short};
use super::run::Run;
use super::section::{self, need_space};
use super::{PlotError, Target, write};
use riprap_record::field::number;
use riprap_record::field::with_unit;
use riprap_record::frame::{Frame, Surfaces, stress};
use riprap_record::manifest::Manifest;
use riprap_record::vtu::{self, PvdEntry};
use std::path::{Path, PathBuf};

/// Times nearer to each other than this share of them are the same.
const ROUND_OFF: f64 = 1e-9;

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

/// The frames of a run folder, at least one.
pub(super) fn listed(folder: &Path) -> Result<Vec<PvdEntry>, PlotError> {
    let list = vtu::read_pvd(&folder.join("run.pvd"))?;
    if list.is_empty() {
        return Err(PlotError::NoFrames { folder: folder.to_owned() });
    }
    Ok(list)
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

/// Reads a frame of a run folder.
///
/// # Errors
/// No frames, no such frame, files that cannot be read.
pub fn load_frame(folder: &Path, which: Which) -> Result<Frame, PlotError> {
    let list = listed(folder)?;
    let at = found(&list, which)?;
    let contacts = vtu::read_pvd(&folder.join("contacts.pvd"))?;
    let contacts = contacts.get(at).map(|c| folder.join(&c.file));
    let mut frame = vtu::read_frame(&folder.join(&list[at].file), contacts.as_deref())?;
    let bolts = folder.join(list[at].file.replacen("frame_", "bolts_", 1));
    if bolts.exists() {
        let bars = vtu::read(&bolts)?;
        frame.bolts =
            Some(Surfaces { ends: bars.offsets, points: bars.points, columns: bars.cell_columns });
    }
    Ok(frame)
}

/// The crack surfaces that belong to a frame; there only with deformable blocks.
pub(crate) fn crack_surfaces(folder: &Path, which: Which) -> Result<PathBuf, PlotError> {
    let list = listed(folder)?;
    let file = &list[found(&list, which)?].file;
    Ok(folder.join(file.replacen("frame_", "cracks_", 1)))
}

/// Place of a frame in the list.
fn found(list: &[PvdEntry], which: Which) -> Result<usize, PlotError> {
    Ok(match which {
        Which::Last => list.len() - 1,
        Which::Index(index) => match index.checked_sub(1) {
            Some(i) if i < list.len() => i,
            Some(_) | None => {
                return Err(PlotError::NoSuchFrame { index, count: list.len() });
            }
        },
        Which::Time(t) => {
            let (first, last) = (list[0].time, list[list.len() - 1].time);
            // Half a frame beyond an end still means the frame there.
            let before = 0.5 * list.get(1).map_or(0.0, |next| next.time - first);
            let after = 0.5 * list.iter().rev().nth(1).map_or(0.0, |e| last - e.time);
            // A time in other words, such as 1 min 3 s, differs in its last bits.
            let round_off = ROUND_OFF * first.abs().max(last.abs());
            if !(first - before - round_off..=last + after + round_off).contains(&t) {
                return Err(PlotError::OutsideTheRun { time: t, first, last });
            }
            let gap = |i: &usize| (list[*i].time - t).abs();
            (0..list.len()).min_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(0)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_only_frame_is_found_by_its_time_but_for_round_off() {
        let at = |time: f64| PvdEntry { time, file: "frames/frame_000001.vtu".to_owned() };
        let list = [at(0.1 + 0.2)];
        assert_eq!(found(&list, Which::Time(0.3)).unwrap(), 0);
        assert_eq!(found(&list, Which::Time(0.1 + 0.2)).unwrap(), 0);
        for wrong in [0.29999, 0.30001, -0.3, f64::NAN] {
            assert!(found(&list, Which::Time(wrong)).is_err(), "{wrong}");
        }
        assert!(found(&[at(0.0)], Which::Time(1e-9)).is_err());
    }
}
