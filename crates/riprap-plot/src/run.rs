//! A run folder, or some of the blocks in it.

use super::load::{Which, load_frame};
use super::{PlotError, drawing::short, suffix};
use riprap_record::frame::{Column, Frame, Solids, Surfaces};
use riprap_record::manifest::Manifest;
use riprap_record::names::Names;
use std::path::Path;

/// A run folder, and which of its blocks are drawn: a path alone means all.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    /// The folder.
    pub folder: &'a Path,
    /// A group, a block or a condition of them, as `rock and not ore`: what a block is split into belongs to what it was.
    pub of: Option<&'a str>,
}

impl<'a, P: AsRef<Path> + ?Sized> From<&'a P> for Run<'a> {
    fn from(folder: &'a P) -> Self {
        Self { folder: folder.as_ref(), of: None }
    }
}

impl Run<'_> {
    /// Reads a frame with the blocks that are drawn, and the contacts, cracks and bolts between them.
    ///
    /// # Errors
    /// As [`load_frame`]; a condition that is none, or that holds for no block of the frame.
    pub fn frame(&self, which: Which) -> Result<Frame, PlotError> {
        let frame = load_frame(self.folder, which)?;
        let Some(of) = self.of else { return Ok(frame) };
        let names = Names::read(self.folder)?;
        let chosen = names.chosen(of).map_err(|what| PlotError::NothingToDraw { what })?;
        let time = frame.time;
        let frame = only(frame, &|block| chosen.has(block));
        if frame.blocks() == 0 {
            let what = format!("at t = {} s there is no block of {of:?}", short(time));
            return Err(PlotError::NothingToDraw { what });
        }
        Ok(frame)
    }

    /// The end of a title, with what is left out.
    pub(super) fn suffix(&self, manifest: &Manifest, text: &str) -> String {
        match self.of {
            Some(of) if text.is_empty() => suffix(manifest, &format!("only {of}")),
            Some(of) => suffix(manifest, &format!("{text}, only {of}")),
            None => suffix(manifest, text),
        }
    }
}

/// The numbers of the blocks of a frame: removed ones leave no gap in it.
pub(super) fn numbers(frame: &Frame) -> Vec<u32> {
    match frame.column("block").filter(|c| c.components == 1) {
        Some(column) => column.data.iter().map(|n| *n as u32).collect(),
        None => (0..frame.blocks() as u32).collect(),
    }
}

/// The blocks of a frame of which `has` holds, and what lies between two of them; bars of bolts with an end in one.
fn only(mut frame: Frame, has: &dyn Fn(u32) -> bool) -> Frame {
    let all = numbers(&frame);
    let kept: Vec<usize> =
        all.iter().enumerate().filter(|(_, n)| has(**n)).map(|(i, _)| i).collect();
    if kept.len() < all.len() && frame.column("block").is_none() {
        // What is left must not take the numbers of others.
        let numbers = all.iter().map(|n| f64::from(*n)).collect();
        frame.block_columns.push(Column::scalar("block", "-", numbers));
    }
    let (mut points, mut offsets) = (Vec::new(), vec![0]);
    for &i in &kept {
        points.extend_from_slice(frame.outline(i));
        offsets.push(points.len() as u32);
    }
    frame.solids = frame.solids.as_ref().map(|solids| some_solids(solids, &kept));
    (frame.points, frame.offsets) = (points, offsets);
    frame.block_columns.iter_mut().for_each(|column| pick(column, &kept));
    let between =
        rows(&frame.contact_columns, frame.contact_points.len(), &|[a, b]| has(a) && has(b));
    frame.contact_points = between.iter().map(|&k| frame.contact_points[k]).collect();
    frame.contact_columns.iter_mut().for_each(|column| pick(column, &between));
    frame.bolts = frame.bolts.map(|bars| some_cells(&bars, &|[a, b]| has(a) || has(b)));
    frame
}

/// Rows whose two blocks are wanted; all where the columns do not tell the blocks.
fn rows(columns: &[Column], count: usize, wanted: &dyn Fn([u32; 2]) -> bool) -> Vec<usize> {
    let side = |name: &str| columns.iter().find(|c| c.name == name && c.components == 1);
    match (side("block_a"), side("block_b")) {
        (Some(a), Some(b)) => {
            (0..count).filter(|&k| wanted([a.data[k] as u32, b.data[k] as u32])).collect()
        }
        _ => (0..count).collect(),
    }
}

fn pick(column: &mut Column, kept: &[usize]) {
    let n = column.components;
    column.data = kept.iter().flat_map(|&k| &column.data[n * k..n * (k + 1)]).copied().collect();
}

fn some_solids(solids: &Solids, kept: &[usize]) -> Solids {
    let mut out = Solids { faces: vec![0], ends: vec![0], corners: Vec::new() };
    for &i in kept {
        for face in solids.faces[i] as usize..solids.faces[i + 1] as usize {
            let corners = solids.ends[face] as usize..solids.ends[face + 1] as usize;
            out.corners.extend_from_slice(&solids.corners[corners]);
            out.ends.push(out.corners.len() as u32);
        }
        out.faces.push(out.ends.len() as u32 - 1);
    }
    out
}

fn some_cells(cells: &Surfaces, wanted: &dyn Fn([u32; 2]) -> bool) -> Surfaces {
    let kept = rows(&cells.columns, cells.ends.len(), wanted);
    let mut out = Surfaces { columns: cells.columns.clone(), ..Surfaces::default() };
    for &k in &kept {
        let first = k.checked_sub(1).map_or(0, |before| cells.ends[before] as usize);
        out.points.extend_from_slice(&cells.points[first..cells.ends[k] as usize]);
        out.ends.push(out.points.len() as u32);
    }
    out.columns.iter_mut().for_each(|column| pick(column, &kept));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_testkit::{sample, solid_sample};

    #[test]
    fn chosen_blocks_keep_their_shapes_numbers_and_what_lies_between_them() {
        for frame in [sample(), solid_sample()] {
            assert_eq!(only(frame.clone(), &|_| true), frame);
            let last = numbers(&frame).len() - 1;
            let number = numbers(&frame)[last];
            let mut with = frame.clone();
            let count = frame.contact_points.len();
            for (name, block) in [("block_a", number), ("block_b", numbers(&frame)[0])] {
                let data = vec![f64::from(block); count];
                with.contact_columns.push(Column::scalar(name, "-", data));
            }
            let one = only(with, &|n| n == number);
            assert_eq!(one.fault(), None);
            assert_eq!((one.blocks(), numbers(&one)), (1, vec![number]));
            assert_eq!(one.outline(0), frame.outline(last));
            if let (Some(one), Some(all)) = (&one.solids, &frame.solids) {
                assert_eq!(one.of(0), all.of(last));
            }
            assert!(one.contact_points.is_empty(), "a contact has two blocks");
        }
    }

    #[test]
    fn bars_stay_with_either_block() {
        let side = |name: &str, data: &[f64]| Column::scalar(name, "-", data.to_vec());
        let bars = Surfaces {
            ends: vec![2, 4],
            points: (0..4).map(|k| [f64::from(k), 0.0, 0.0]).collect(),
            columns: vec![side("block_a", &[1.0, 2.0]), side("block_b", &[2.0, 3.0])],
        };
        let kept = some_cells(&bars, &|[a, b]| a == 3 || b == 3);
        assert_eq!((kept.ends, kept.points[0][0], kept.columns[0].data[0]), (vec![2], 2.0, 2.0));
    }
}
