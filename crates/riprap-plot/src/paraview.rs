//! `paraview_state.py`: a script that opens a run in ParaView with sensible colours, camera, arrows and cuts.

use crate::{PlotError, Which, load_frame};
use riprap_record::field::Part;
use riprap_record::frame::Frame;
use riprap_record::manifest::Manifest;
use riprap_record::vtu;
use riprap_record::write_whole;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The script without its numbers.
const STATE: &str = include_str!("paraview/state.py");
/// Name of the file in the run folder. Not `paraview.py`: Python would take it for ParaView itself.
const FILE: &str = "paraview_state.py";

/// What the script is to show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View<'a> {
    /// Column of the frames that colours the blocks.
    pub by: &'a str,
    /// Factor on displacements, 1 or more.
    pub exaggeration: f64,
}

/// Writes `paraview_state.py` into a run folder; the file written.
///
/// Ranges of colours and lengths are those of the last frame, so that one legend holds for all times.
///
/// # Errors
/// A run without frames, a column the frames do not have, the disk.
pub fn write(folder: &Path, view: View<'_>) -> Result<PathBuf, PlotError> {
    Manifest::read(folder)?;
    let frame = load_frame(folder, Which::Last)?;
    if frame.column(view.by).is_none() {
        let known: Vec<&str> = frame.block_columns.iter().map(|c| c.name.as_str()).collect();
        let reason =
            format!("the frames have no column `{}`; valid columns: {}", view.by, known.join(", "));
        return Err(PlotError::Unsuitable { picture: "ParaView's view", reason });
    }
    let text = STATE.replace("#SETTINGS#", settings(folder, &frame, view)?.trim_end());
    let path = folder.join(FILE);
    write_whole(&path, text.as_bytes())?;
    Ok(path)
}

/// Constants of the script, as Python.
fn settings(folder: &Path, frame: &Frame, view: View<'_>) -> Result<String, PlotError> {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in &frame.points {
        for k in 0..3 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    let centre = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
    let (mut ranges, mut units, mut vectors) = (String::new(), String::new(), String::new());
    let mut put = |name: &str, unit: &str, values: &[f64]| {
        let finite = values.iter().filter(|v| v.is_finite());
        let [a, b] =
            finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
        if a <= b {
            let _ = write!(ranges, "{}: ({a:?}, {b:?}), ", quoted(name));
        }
        let _ = write!(units, "{}: {}, ", quoted(name), quoted(unit));
    };
    for column in &frame.block_columns {
        put(&column.name, &column.unit, &column.numbers(Part::Whole));
        if column.components > 1 {
            let _ = write!(vectors, "{}, ", quoted(&column.name));
        }
    }
    let cracks = crate::crack_surfaces(folder, Which::Last)?;
    let mut cracked = false;
    if cracks.exists() {
        for column in vtu::read(&cracks)?.cell_columns {
            // Blocks have columns of the same names.
            if frame.column(&column.name).is_none() {
                put(&column.name, &column.unit, &column.data);
            }
            cracked |= column.name == "opening" && !column.data.is_empty();
        }
    }
    let force = frame.contact_columns.iter().find(|c| c.name == "force_on_a");
    let longest = force.map_or(0.0, |c| {
        let sizes = c.numbers(Part::Whole).into_iter();
        sizes.filter(|v| v.is_finite()).fold(0.0, f64::max)
    });
    let list = vtu::read_pvd(&folder.join("run.pvd"))?;
    let still = list.windows(2).any(|w| w[0].time == w[1].time);
    // Only where they are used: a long run has thousands.
    let [numbers, moments] = if still { self::moments(folder, &list)? } else { Default::default() };
    let python = |yes: bool| if yes { "True" } else { "False" };
    let (planar, by_step, cracked) =
        (python(frame.solids.is_none()), python(still), python(cracked));
    Ok(format!(
        "BY_STEP = {by_step}\nFRAMES = [{numbers}]\nMOMENTS = [{moments}]\nCRACKED = {cracked}\nCOLOUR = {}\nEXAGGERATION = {:?}\nPLANAR = {planar}\nSIZE = {size:?}\nCENTRE = {centre:?}\n\
         RANGES = {{{ranges}}}\nUNITS = {{{units}}}\nVECTORS = [{vectors}]\nLONGEST_FORCE = {longest:?}\n",
        quoted(view.by),
        view.exaggeration
    ))
}

/// Numbers and words of all frames, for lists of Python.
fn moments(folder: &Path, list: &[vtu::PvdEntry]) -> Result<[String; 2], PlotError> {
    let (mut numbers, mut moments) = (String::new(), String::new());
    for entry in list {
        let digits: String = entry.file.chars().filter(char::is_ascii_digit).collect();
        let _ = write!(numbers, "{}, ", digits.parse::<u32>().unwrap_or(0));
        let moment = vtu::read_moment(&folder.join(&entry.file))?;
        let said = match moment.time {
            0.0 => format!("{}, step {}", moment.phase, moment.step),
            t => format!("t = {t:?} s, {}, step {}", moment.phase, moment.step),
        };
        let _ = write!(moments, "{}, ", quoted(&said));
    }
    Ok([numbers, moments])
}

/// A Python string.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_record::exec::Exec;
    use riprap_record::folder::{Existing, RunFolder};
    use riprap_testkit::{sample, solid_sample};

    #[test]
    fn the_script_has_the_numbers_of_the_run() {
        for (frame, planar) in [(sample(), "PLANAR = True"), (solid_sample(), "PLANAR = False")] {
            let dir = tempfile::tempdir().unwrap();
            let folder = dir.path().join("a.run");
            let mut run =
                RunFolder::create(&folder, Existing::Refuse, &Manifest::default()).unwrap();
            let view = View { by: "velocity", exaggeration: 10.0 };
            assert!(matches!(write(&folder, view), Err(PlotError::NoFrames { .. })));
            let by = frame.block_columns[0].name.clone();
            run.frame(&frame, &Exec::serial()).unwrap();
            let path = write(&folder, View { by: &by, ..view }).unwrap();
            let text = std::fs::read_to_string(path).unwrap();
            assert!(text.contains(planar) && text.contains("EXAGGERATION = 10.0"));
            assert!(text.contains("BY_STEP = False") && text.contains("CRACKED = False"));
            // A second frame at the same time: frames are counted.
            run.frame(&frame, &Exec::serial()).unwrap();
            let path = write(&folder, View { by: &by, ..view }).unwrap();
            let text = std::fs::read_to_string(path).unwrap();
            let said =
                format!("\"t = {:?} s, {}, step {}\", ", frame.time, frame.phase, frame.step);
            assert!(text.contains("BY_STEP = True") && text.contains("FRAMES = [1, 2, ]"));
            assert!(text.contains(&said.repeat(2)), "{text}");
            assert!(text.contains(&format!("COLOUR = \"{by}\"")) && !text.contains("#SETTINGS#"));
            let missing = write(&folder, View { by: "speed", ..view }).unwrap_err();
            assert!(missing.to_string().contains(&by), "{missing}");
        }
    }

    #[test]
    fn texts_cannot_end_their_string() {
        assert_eq!(quoted("a\"b\\c\nd"), "\"a\\\"b\\\\c d\"");
    }
}
