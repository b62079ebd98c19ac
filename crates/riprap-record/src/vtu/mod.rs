//! VTK files: `.vtu` per frame and `.pvd` over time, written and read back.
//!
//! Own writer, because vtkio 0.6.3 dates from 2021 (nom 3), 0.7 is still a release candidate, and neither can read
//! the polyhedra (`faces`, `faceoffsets`) that the 3D engine will write; its xz2 dependency also clashes with other
//! crates. The format needed here is small: one piece, raw appended data, zlib blocks.
//!
//! Choices, tried with VTK 9.7:
//! - blocks are polygons (cell type 7) at z = 0, hexahedra (12) or polyhedra (42), with cell data; contacts are vertices (cell type 1) with point data,
//!   in a file of their own, and so are cracks (polygons in space), since ParaView glyphs want points and a threshold on blocks must not touch contacts;
//! - vectors in the plane get a zero third component, so that *Warp* and *Glyph* take them;
//! - an array is named after its quantity alone (`displacement`), because names with blanks and brackets cannot be
//!   typed into ParaView's calculator. The unit stands in the array's information key `UNITS_LABEL`, which VTK
//!   reads back, and in the field list of `manifest.json`;
//! - `TimeValue` (s), `step` and `phase` are field data of each file.
//!
//! The reader is for our own files only (plots, tests, comparison of runs). Every length is checked against the
//! size of the file before memory is taken.

mod moment;
mod pvd;
mod read;
mod write;

pub use moment::{Moment, read_moment};
pub use pvd::{PVD_END, PvdEntry, pvd_entry, read_pvd, write_pvd};
pub use read::{ReadError, Vtu, Wanted, parse, read, read_some};
pub use write::escape;
pub use write::{blocks, bolts, contacts, cracks, tetrahedra};

use super::frame::{Frame, Solids};
use std::path::Path;

/// Reads a frame back from its two files; `contacts` may be missing.
///
/// # Errors
/// Files that are missing, foreign or damaged.
pub fn read_frame(blocks: &Path, contacts: Option<&Path>) -> Result<Frame, ReadError> {
    let frame = read_blocks(blocks, Wanted::ALL)?;
    let Some(path) = contacts else {
        return Ok(frame);
    };
    let c = read(path)?;
    let frame = Frame { contact_points: c.points, contact_columns: c.point_columns, ..frame };
    checked(frame, path)
}

/// Reads the blocks of a frame, with the wanted columns; without its geometry it has no blocks to which they belong.
///
/// # Errors
/// As [`read_frame`].
pub fn read_blocks(blocks: &Path, wanted: Wanted<'_>) -> Result<Frame, ReadError> {
    let b = read_some(blocks, wanted)?;
    let solids =
        solids(&b).map_err(|reason| ReadError::Damaged { path: blocks.to_owned(), reason })?;
    let mut frame = Frame {
        solids,
        step: b.step,
        time: b.time,
        phase: b.phase,
        offsets: Vec::new(),
        points: b.points,
        block_columns: b.cell_columns,
        contact_points: Vec::new(),
        contact_columns: Vec::new(),
        cracks: None,
        bolts: None,
        tetrahedra: None,
    };
    if !b.offsets.is_empty() {
        frame.offsets.push(0);
        frame.offsets.extend(b.offsets);
    }
    if wanted.geometry { checked(frame, blocks) } else { Ok(frame) }
}

fn checked(frame: Frame, path: &Path) -> Result<Frame, ReadError> {
    match frame.fault() {
        None => Ok(frame),
        Some(reason) => Err(ReadError::Damaged { path: path.to_owned(), reason }),
    }
}

/// Faces of the cells of a file in space.
fn solids(file: &Vtu) -> Result<Option<Solids>, String> {
    if file.dimension != 3 {
        return Ok(None);
    }
    let mut out = Solids { faces: vec![0], ends: vec![0], corners: Vec::new() };
    let bad = || "its faces cannot be read".to_owned();
    let mut at = 0;
    let mut first = 0_i64;
    for (cell, end) in file.offsets.iter().enumerate() {
        if let Some(&stop) = file.face_ends.get(cell).filter(|e| **e >= 0) {
            let stop = usize::try_from(stop).map_err(|_| bad())?;
            let mut rest = file.faces.get(at..stop).ok_or_else(bad)?.iter();
            // The number of faces, which the end of the cell tells as well.
            rest.next().ok_or_else(bad)?;
            while let Some(&count) = rest.next() {
                let count = usize::try_from(count).map_err(|_| bad())?;
                let corners = rest.as_slice().get(..count).ok_or_else(bad)?;
                // Over the whole file there, from the first of the cell here.
                for c in corners {
                    let c = c.checked_sub(first).ok_or_else(bad)?;
                    out.corners.push(u32::try_from(c).map_err(|_| bad())?);
                }
                out.ends.push(out.corners.len() as u32);
                rest = rest.as_slice()[count..].iter();
            }
            at = stop;
        }
        out.faces.push(out.ends.len() as u32 - 1);
        first = i64::from(*end);
    }
    Ok(Some(out))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damaged_corners_of_faces_are_an_error() {
        for corner in [i64::MIN, -1, i64::MAX] {
            let file = Vtu {
                dimension: 3,
                offsets: vec![4, 8],
                face_ends: vec![-1, 3],
                faces: vec![1, 1, corner],
                ..Vtu::default()
            };
            assert!(solids(&file).is_err(), "{corner}");
        }
    }
}
