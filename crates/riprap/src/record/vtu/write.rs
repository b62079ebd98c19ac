//! The writer: header text with offsets, then the blocks of compressed bytes.

use crate::record::frame::{Column, Frame};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::fmt::Write as _;
use std::io::{self, Write as _};

/// Uncompressed bytes per zlib block, as VTK's own writer uses.
const BLOCK: usize = 1 << 15;
const POLYGON: u8 = 7;
const VERTEX: u8 = 1;

/// The blocks of a frame as a `.vtu` file.
///
/// # Errors
/// A frame whose parts do not fit together is `InvalidData`: a mistake of the engine.
pub fn blocks(frame: &Frame) -> io::Result<Vec<u8>> {
    check(frame)?;
    let ends: Vec<i64> = frame
        .offsets
        .iter()
        .skip(1)
        .map(|o| i64::from(*o))
        .collect();
    let mesh = Mesh {
        points: &frame.points,
        ends: &ends,
        kind: POLYGON,
        on_cells: &frame.block_columns,
        on_points: &[],
    };
    file(frame, &mesh)
}

/// The contacts of a frame as a `.vtu` file of vertices.
///
/// # Errors
/// As [`blocks`].
pub fn contacts(frame: &Frame) -> io::Result<Vec<u8>> {
    check(frame)?;
    let ends: Vec<i64> = (1..).take(frame.contact_points.len()).collect();
    let mesh = Mesh {
        points: &frame.contact_points,
        ends: &ends,
        kind: VERTEX,
        on_cells: &[],
        on_points: &frame.contact_columns,
    };
    file(frame, &mesh)
}

fn check(frame: &Frame) -> io::Result<()> {
    match frame.fault() {
        None => Ok(()),
        Some(text) => Err(io::Error::new(io::ErrorKind::InvalidData, text)),
    }
}

struct Mesh<'a> {
    points: &'a [[f64; 2]],
    /// Shape `[cells]`: end of each cell's run of points.
    ends: &'a [i64],
    kind: u8,
    on_cells: &'a [Column],
    on_points: &'a [Column],
}

fn file(frame: &Frame, mesh: &Mesh) -> io::Result<Vec<u8>> {
    let mut w = Writer {
        head: String::new(),
        data: Vec::new(),
    };
    w.put("<?xml version=\"1.0\"?>\n");
    w.put(
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n<FieldData>\n",
    );
    w.put(&format!(
        "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{:?}</DataArray>\n",
        frame.time
    ));
    w.put(&format!(
        "<DataArray type=\"Int64\" Name=\"step\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
        frame.step
    ));
    let codes: String = frame.phase.bytes().fold(String::new(), |mut s, b| {
        // Writing into a String cannot fail.
        let _ = write!(s, "{b} ");
        s
    });
    w.put(&format!(
        "<Array type=\"String\" Name=\"phase\" NumberOfTuples=\"1\" format=\"ascii\">{codes}0</Array>\n</FieldData>\n"
    ));
    w.put(&format!(
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        mesh.points.len(),
        mesh.ends.len()
    ));
    for (tag, columns) in [("PointData", mesh.on_points), ("CellData", mesh.on_cells)] {
        w.put(&format!("<{tag}>\n"));
        for c in columns {
            w.column(c)?;
        }
        w.put(&format!("</{tag}>\n"));
    }
    w.put("<Points>\n");
    let flat: Vec<u8> = mesh
        .points
        .iter()
        .flat_map(|p| [p[0], p[1], 0.0])
        .flat_map(f64::to_le_bytes)
        .collect();
    w.array("Float64", "Points", "NumberOfComponents=\"3\"", "m", &flat)?;
    w.put("</Points>\n<Cells>\n");
    let ids: Vec<u8> = (0i64..)
        .take(mesh.points.len())
        .flat_map(i64::to_le_bytes)
        .collect();
    w.array("Int64", "connectivity", "", "-", &ids)?;
    let ends: Vec<u8> = mesh.ends.iter().flat_map(|e| e.to_le_bytes()).collect();
    w.array("Int64", "offsets", "", "-", &ends)?;
    w.array("UInt8", "types", "", "-", &vec![mesh.kind; mesh.ends.len()])?;
    w.put("</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    let mut out = w.head.into_bytes();
    out.extend_from_slice(&w.data);
    out.extend_from_slice(b"\n</AppendedData>\n</VTKFile>\n");
    Ok(out)
}

struct Writer {
    head: String,
    data: Vec<u8>,
}

impl Writer {
    fn put(&mut self, text: &str) {
        self.head.push_str(text);
    }

    fn column(&mut self, c: &Column) -> io::Result<()> {
        if c.components == 2 {
            let padded: Vec<u8> = c
                .data
                .as_chunks::<2>()
                .0
                .iter()
                .flat_map(|v| [v[0], v[1], 0.0])
                .flat_map(f64::to_le_bytes)
                .collect();
            let names = "NumberOfComponents=\"3\" ComponentName0=\"x\" ComponentName1=\"y\" ComponentName2=\"z\"";
            self.array("Float64", &c.name, names, &c.unit, &padded)
        } else {
            let flat: Vec<u8> = c.data.iter().flat_map(|v| v.to_le_bytes()).collect();
            self.array("Float64", &c.name, "", &c.unit, &flat)
        }
    }

    fn array(
        &mut self,
        kind: &str,
        name: &str,
        more: &str,
        unit: &str,
        bytes: &[u8],
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
        append(&mut self.data, bytes)
    }
}

/// vtkZLibDataCompressor layout: number of blocks, block size, size of a partial last block (0 if full), compressed
/// sizes; then the blocks.
fn append(out: &mut Vec<u8>, bytes: &[u8]) -> io::Result<()> {
    let parts: Vec<Vec<u8>> = bytes
        .chunks(BLOCK)
        .map(|chunk| {
            let mut zlib = ZlibEncoder::new(Vec::new(), Compression::new(5));
            zlib.write_all(chunk)?;
            zlib.finish()
        })
        .collect::<io::Result<_>>()?;
    let head = [parts.len(), BLOCK, bytes.len() % BLOCK];
    for n in head.into_iter().chain(parts.iter().map(Vec::len)) {
        out.extend_from_slice(&(n as u64).to_le_bytes());
    }
    for p in parts {
        out.extend_from_slice(&p);
    }
    Ok(())
}

/// Text inside XML, attributes included. Control characters, which XML cannot hold, become blanks.
pub(crate) fn escape(text: &str) -> String {
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
