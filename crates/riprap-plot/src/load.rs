//! Frames of a run folder, read from its files.

use super::PlotError;
use riprap_record::frame::{Frame, Surfaces};
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

/// The frames of a run folder, at least one.
pub(super) fn listed(folder: &Path) -> Result<Vec<PvdEntry>, PlotError> {
    let list = vtu::read_pvd(&folder.join("run.pvd"))?;
    if list.is_empty() {
        return Err(PlotError::NoFrames { folder: folder.to_owned() });
    }
    Ok(list)
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
