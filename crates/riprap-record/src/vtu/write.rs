//! The writer: header text with offsets, then the blocks of compressed bytes.

use std::io;
use std::ops::Range;

use flate2::{Compress, Compression, FlushCompress, Status};
use riprap_core::exec::Exec;

use crate::frame::{Column, Frame, Solids, Surfaces};

/// Uncompressed bytes per zlib block, as VTK's own writer uses.
const BLOCK: usize = 1 << 15;
/// Blocks that one thread compresses in a row.
const RUN: usize = 4;
/// Cells in a piece of a file, which a reader can have without the others. Most models have one.
const PIECE: usize = 1 << 17;
/// Of 9. Level 5 makes files 2 to 4 % smaller (frames of bricks) and takes a quarter more time.
const LEVEL: u32 = 3;
/// VTK cell types.
pub(super) const VERTEX: u8 = 1;
pub(super) const POLYGON: u8 = 7;
const TETRAHEDRON: u8 = 10;
const LINE: u8 = 3;
pub(super) const HEXAHEDRON: u8 = 12;
pub(super) const POLYHEDRON: u8 = 42;

/// The blocks of a frame as a `.vtu` file; the bytes are the same for any number of threads.
///
/// # Errors
/// A frame whose parts do not fit together is `InvalidData`: a mistake of the engine.
pub fn blocks(frame: &Frame, exec: &Exec) -> io::Result<Vec<u8>> {
    blocks_in_pieces(frame, exec, PIECE)
}

/// As [`blocks`], with so many in a piece.
pub(super) fn blocks_in_pieces(frame: &Frame, exec: &Exec, piece: usize) -> io::Result<Vec<u8>> {
    check(frame)?;
    let ends: Vec<i64> = frame.offsets.iter().skip(1).map(|o| i64::from(*o)).collect();
    let kinds = match &frame.solids {
        None => vec![POLYGON; ends.len()],
        Some(solids) => solids
            .faces
            .windows(2)
            .map(|f| if f[0] == f[1] { HEXAHEDRON } else { POLYHEDRON })
            .collect(),
    };
    let mesh = Mesh {
        points: &frame.points,
        ends: &ends,
        kinds: &kinds,
        faces: frame.solids.as_ref().map(|solids| Faces { solids, offsets: &frame.offsets }),
        on_cells: &frame.block_columns,
        on_points: &[],
    };
    file(frame, &mesh, exec, piece)
}

/// The contacts of a frame as a `.vtu` file of vertices.
///
/// # Errors
/// As [`blocks`].
pub fn contacts(frame: &Frame, exec: &Exec) -> io::Result<Vec<u8>> {
    check(frame)?;
    let ends: Vec<i64> = (1..).take(frame.contact_points.len()).collect();
    let mesh = Mesh {
        points: &frame.contact_points,
        ends: &ends,
        kinds: &vec![VERTEX; ends.len()],
        faces: None,
        on_cells: &[],
        on_points: &frame.contact_columns,
    };
    file(frame, &mesh, exec, PIECE)
}

/// The cracks of a frame as a `.vtu` file of polygons; `None` where no block is deformable.
///
/// # Errors
/// Columns that do not fit the polygons are `InvalidData`: a mistake of the engine.
pub fn cracks(frame: &Frame, exec: &Exec) -> io::Result<Option<Vec<u8>>> {
    let cracks = frame.cracks.as_ref();
    cracks.map(|c| cells(frame, c, POLYGON, exec)).transpose()
}

/// The bars of the bolts of a frame as a `.vtu` file of lines; `None` where there are none.
///
/// # Errors
/// As [`cracks`].
pub fn bolts(frame: &Frame, exec: &Exec) -> io::Result<Option<Vec<u8>>> {
    let list = frame.bolts.as_ref();
    list.map(|c| cells(frame, c, LINE, exec)).transpose()
}

/// The tetrahedra of a frame as a `.vtu` file; `None` where they are not asked for.
///
/// # Errors
/// As [`cracks`].
pub fn tetrahedra(frame: &Frame, exec: &Exec) -> io::Result<Option<Vec<u8>>> {
    let list = frame.tetrahedra.as_ref();
    list.map(|c| cells(frame, c, TETRAHEDRON, exec)).transpose()
}

fn cells(frame: &Frame, cells: &Surfaces, kind: u8, exec: &Exec) -> io::Result<Vec<u8>> {
    let count = cells.ends.len();
    let last = cells.ends.last().map_or(0, |e| *e as usize);
    if last != cells.points.len() || cells.columns.iter().any(|c| c.len() != count) {
        let text = "the lists of cracks, tetrahedra or bolts are inconsistent";
        return Err(io::Error::new(io::ErrorKind::InvalidData, text));
    }
    let ends: Vec<i64> = cells.ends.iter().map(|e| i64::from(*e)).collect();
    let mesh = Mesh {
        points: &cells.points,
        ends: &ends,
        kinds: &vec![kind; count],
        faces: None,
        on_cells: &cells.columns,
        on_points: &[],
    };
    file(frame, &mesh, exec, PIECE)
}

fn check(frame: &Frame) -> io::Result<()> {
    match frame.fault() {
        None => Ok(()),
        Some(text) => Err(io::Error::new(io::ErrorKind::InvalidData, text)),
    }
}

struct Mesh<'a> {
    points: &'a [[f64; 3]],
    /// Shape `[cells]`: end of each cell's run of points.
    ends: &'a [i64],
    /// Shape `[cells]`: VTK cell types.
    kinds: &'a [u8],
    /// Where there are polyhedra.
    faces: Option<Faces<'a>>,
    on_cells: &'a [Column],
    on_points: &'a [Column],
}

/// The blocks of a frame with their faces.
#[derive(Clone, Copy)]
struct Faces<'a> {
    solids: &'a Solids,
    /// First point of each block.
    offsets: &'a [u32],
}

impl Faces<'_> {
    /// Of each polyhedron: number of faces, then for each face its number of corners and their points; and where each cell ends in that. `None`
    /// where there is no polyhedron.
    fn stream(&self, cells: &Range<usize>) -> Option<(Vec<i64>, Vec<i64>)> {
        let (mut stream, mut ends) = (Vec::new(), Vec::new());
        for i in cells.clone() {
            if self.solids.faces[i] == self.solids.faces[i + 1] {
                ends.push(-1);
                continue;
            }
            let faces = self.solids.of(i);
            let first = self.offsets[i] - self.offsets[cells.start];
            stream.push(faces.len() as i64);
            for face in faces {
                stream.push(face.len() as i64);
                stream.extend(face.iter().map(|&c| i64::from(first + c)));
            }
            ends.push(stream.len() as i64);
        }
        (!stream.is_empty()).then_some((stream, ends))
    }
}

fn file(frame: &Frame, mesh: &Mesh, exec: &Exec, piece: usize) -> io::Result<Vec<u8>> {
    let mut w = Writer { head: String::new(), data: Vec::new(), exec };
    w.put("<?xml version=\"1.0\"?>\n");
    w.put(
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n<FieldData>\n",
    );
    let dimension = if frame.solids.is_some() { 3 } else { 2 };
    for (kind, name, value) in [
        ("Float64", "TimeValue", format!("{:?}", frame.time)),
        ("Int64", "step", frame.step.to_string()),
        ("Int64", "dimension", dimension.to_string()),
    ] {
        w.put(&format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfTuples=\"1\" format=\"ascii\">{value}</DataArray>\n"
        ));
    }
    // VTK writes text as the codes of its bytes, with a 0 at the end.
    let codes: Vec<String> = frame.phase.bytes().chain([0]).map(|b| b.to_string()).collect();
    let codes = codes.join(" ");
    w.put(&format!(
        "<Array type=\"String\" Name=\"phase\" NumberOfTuples=\"1\" format=\"ascii\">{codes}</Array>\n</FieldData>\n"
    ));
    for first in (0..mesh.ends.len().max(1)).step_by(piece) {
        w.piece(mesh, first..mesh.ends.len().min(first + piece))?;
    }
    w.put("</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    let mut out = w.head.into_bytes();
    out.extend_from_slice(&w.data);
    out.extend_from_slice(b"\n</AppendedData>\n</VTKFile>\n");
    Ok(out)
}

/// Numbers of an array, asked for one by one: a copy of all of them would be as large as the model.
struct Items<F> {
    count: usize,
    /// Bytes of number `k`.
    item: F,
}

/// Each less `base`.
fn integers(list: &[i64], base: usize) -> Items<impl Fn(usize) -> [u8; 8] + Sync> {
    Items { count: list.len(), item: move |k: usize| (list[k] - base as i64).to_le_bytes() }
}

fn numbers(list: &[f64]) -> Items<impl Fn(usize) -> [u8; 8] + Sync> {
    Items { count: list.len(), item: |k: usize| list[k].to_le_bytes() }
}

struct Writer<'a> {
    head: String,
    data: Vec<u8>,
    exec: &'a Exec,
}

impl Writer<'_> {
    fn put(&mut self, text: &str) {
        self.head.push_str(text);
    }

    /// Cells that a reader can have alone: ParaView shares pieces out among its servers. Numbers of points begin anew in each.
    fn piece(&mut self, mesh: &Mesh<'_>, cells: Range<usize>) -> io::Result<()> {
        let end = |cell: usize| cell.checked_sub(1).map_or(0, |before| mesh.ends[before] as usize);
        let points = end(cells.start)..end(cells.end);
        self.put(&format!(
            "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            points.len(),
            cells.len()
        ));
        let sides = [("PointData", mesh.on_points, &points), ("CellData", mesh.on_cells, &cells)];
        for (tag, columns, of) in sides {
            self.put(&format!("<{tag}>\n"));
            for c in columns {
                self.column(c, of)?;
            }
            self.put(&format!("</{tag}>\n"));
        }
        self.put("<Points>\n");
        let places = mesh.points[points.clone()].as_flattened();
        let more = "NumberOfComponents=\"3\"";
        self.array("Float64", "Points", more, "m", numbers(places))?;
        self.put("</Points>\n<Cells>\n");
        // No two cells share a point: each has its own run of them.
        let ids = Items { count: points.len(), item: |k: usize| (k as i64).to_le_bytes() };
        self.array("Int64", "connectivity", "", "-", ids)?;
        self.array("Int64", "offsets", "", "-", integers(&mesh.ends[cells.clone()], points.start))?;
        let kinds = &mesh.kinds[cells.clone()];
        let kinds = Items { count: kinds.len(), item: |k: usize| [kinds[k]] };
        self.array("UInt8", "types", "", "-", kinds)?;
        if let Some(faces) = mesh.faces.and_then(|solids| solids.stream(&cells)) {
            self.array("Int64", "faces", "", "-", integers(&faces.0, 0))?;
            self.array("Int64", "faceoffsets", "", "-", integers(&faces.1, 0))?;
        }
        self.put("</Cells>\n</Piece>\n");
        Ok(())
    }

    fn column(&mut self, c: &Column, of: &Range<usize>) -> io::Result<()> {
        let names = "NumberOfComponents=\"3\" ComponentName0=\"x\" ComponentName1=\"y\" ComponentName2=\"z\"";
        let data = &c.data[c.components * of.start..c.components * of.end];
        // Vectors of VTK have three components.
        if c.components == 2 {
            let padded = Items {
                count: data.len() / 2 * 3,
                item: |k: usize| match k % 3 {
                    2 => 0.0_f64.to_le_bytes(),
                    axis => data[k / 3 * 2 + axis].to_le_bytes(),
                },
            };
            self.array("Float64", &c.name, names, &c.unit, padded)
        } else {
            let more = if c.components == 3 { names } else { "" };
            self.array("Float64", &c.name, more, &c.unit, numbers(data))
        }
    }

    fn array<const N: usize>(
        &mut self,
        kind: &str,
        name: &str,
        more: &str,
        unit: &str,
        items: Items<impl Fn(usize) -> [u8; N] + Sync>,
    ) -> io::Result<()> {
        let gap = if more.is_empty() { "" } else { " " };
        let label = if unit.is_empty() || unit == "-" {
            String::new()
        } else {
            format!(
                "\n<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>\n",
                escape(unit)
            )
        };
        self.put(&format!(
            "<DataArray type=\"{kind}\" Name=\"{}\"{gap}{more} format=\"appended\" offset=\"{}\">{label}</DataArray>\n",
            escape(name),
            self.data.len()
        ));
        append(&mut self.data, self.exec, &items)
    }
}

/// vtkZLibDataCompressor layout: number of blocks, block size, size of a partial last block (0 if full), compressed
/// sizes; then the blocks.
fn append<const N: usize>(
    out: &mut Vec<u8>,
    exec: &Exec,
    items: &Items<impl Fn(usize) -> [u8; N] + Sync>,
) -> io::Result<()> {
    let firsts: Vec<usize> = (0..items.count).step_by(BLOCK / N).collect();
    let runs = exec.map(&firsts, RUN, |firsts| pack(firsts, items));
    let runs: Vec<Packed> = runs.into_iter().collect::<io::Result<_>>()?;
    let sizes = runs.iter().flat_map(|run| run.sizes.iter().copied());
    let head = [firsts.len(), BLOCK, items.count * N % BLOCK];
    for n in head.into_iter().chain(sizes) {
        out.extend_from_slice(&(n as u64).to_le_bytes());
    }
    for run in &runs {
        out.extend_from_slice(&run.bytes);
    }
    Ok(())
}

/// Compressed blocks one after the other.
#[derive(Default)]
struct Packed {
    bytes: Vec<u8>,
    sizes: Vec<usize>,
}

/// Compresses the blocks that begin with these items.
fn pack<const N: usize>(
    firsts: &[usize],
    items: &Items<impl Fn(usize) -> [u8; N]>,
) -> io::Result<Packed> {
    // One for all blocks of a run: making it takes as long as to compress half a block.
    let mut zlib = Compress::new(Compression::new(LEVEL), true);
    let mut plain = Vec::with_capacity(BLOCK);
    // Apart: all the room that is given is cleared for each block.
    let mut block = Vec::with_capacity(BLOCK);
    let mut packed = Packed::default();
    for &first in firsts {
        plain.clear();
        for k in first..items.count.min(first + BLOCK / N) {
            plain.extend_from_slice(&(items.item)(k));
        }
        zlib.reset();
        block.clear();
        let mut status = Status::Ok;
        while status != Status::StreamEnd {
            block.reserve(BLOCK);
            let rest = &plain[zlib.total_in() as usize..];
            status = zlib.compress_vec(rest, &mut block, FlushCompress::Finish)?;
        }
        packed.bytes.extend_from_slice(&block);
        packed.sizes.push(block.len());
    }
    Ok(packed)
}

/// Text inside XML, attributes included. Control characters, which XML cannot hold, become blanks.
#[must_use]
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
