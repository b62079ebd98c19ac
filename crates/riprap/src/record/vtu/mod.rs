//! VTK files: `.vtu` per frame and `.pvd` over time, written and read back.
//!
//! Own writer, because vtkio 0.6.3 dates from 2021 (nom 3), 0.7 is still a release candidate, and neither can read
//! the polyhedra (`faces`, `faceoffsets`) that the 3D engine will write; its xz2 dependency also clashes with other
//! crates. The format needed here is small: one piece, raw appended data, zlib blocks.
//!
//! Choices, tried with VTK 9.7:
//! - blocks are polygons (cell type 7) at z = 0 with cell data; contacts are vertices (cell type 1) with point data,
//!   in a file of their own, since ParaView glyphs want points and a threshold on blocks must not touch contacts;
//! - vectors get a zero third component, so that *Warp* and *Glyph* take them;
//! - an array is named after its quantity alone (`displacement`), because names with blanks and brackets cannot be
//!   typed into ParaView's calculator. The unit stands in the array's information key `UNITS_LABEL`, which VTK
//!   reads back, and in the field list of `manifest.json`;
//! - `TimeValue` (s), `step` and `phase` are field data of each file.
//!
//! The reader is for our own files only (plots, tests, comparison of runs). Every length is checked against the
//! size of the file before memory is taken.

mod pvd;
mod read;
mod write;

pub use pvd::{PvdEntry, read_pvd, write_pvd};
pub use read::{ReadError, Vtu, parse, read};
pub(crate) use write::escape;
pub use write::{blocks, contacts};

use super::frame::Frame;
use std::path::Path;

/// Reads a frame back from its two files; `contacts` may be missing.
///
/// # Errors
/// Files that are missing, foreign or damaged.
pub fn read_frame(blocks: &Path, contacts: Option<&Path>) -> Result<Frame, ReadError> {
    let b = read(blocks)?;
    let mut frame = Frame {
        step: b.step,
        time: b.time,
        phase: b.phase,
        offsets: Vec::new(),
        points: b.points,
        block_columns: b.cell_columns,
        contact_points: Vec::new(),
        contact_columns: Vec::new(),
    };
    if !b.offsets.is_empty() {
        frame.offsets.push(0);
        frame.offsets.extend(b.offsets);
    }
    if let Some(path) = contacts {
        let c = read(path)?;
        frame.contact_points = c.points;
        frame.contact_columns = c.point_columns;
    }
    match frame.fault() {
        None => Ok(frame),
        Some(reason) => Err(ReadError::Damaged {
            path: blocks.to_owned(),
            reason,
        }),
    }
}
