//! The reader of our own `.vtu` files.

use crate::frame::Column;
use flate2::read::ZlibDecoder;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Deflate cannot expand more than 1032:1.
const MAX_RATIO: u64 = 1100;
/// Arrays that unpack to more than this many times the bytes of their file, and to more than [`SMALL`], are refused: frames of blocks at
/// rest, whose numbers are all zero but for the points, stay below a third of it.
const FILE_RATIO: u64 = 100;
/// Arrays of a file that unpack to less than this are never refused, bytes.
const SMALL: u64 = 64 << 20;
/// Entries of the stream of faces per point and per cell at most: a polyhedron with V corners has at most 6 V corners of faces and 2 V faces.
const FACES: u64 = 16;

/// Why a VTK file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The system would not let us read it.
    #[error("could not read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Not a file of ours.
    #[error("{} is not a VTK file written by riprap", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// Cut off or changed.
    #[error("{} is damaged: {reason}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
}

/// Contents of one `.vtu` file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Vtu {
    /// Model time in s.
    pub time: f64,
    /// Step count.
    pub step: u64,
    /// Phase name.
    pub phase: String,
    /// 2 or 3: vectors of files in the plane have two components.
    pub dimension: u8,
    /// Points in m.
    pub points: Vec<[f64; 3]>,
    /// Shape `[cells]`: end of each cell's run of points.
    pub offsets: Vec<u32>,
    /// Shape `[cells]`: VTK cell types.
    pub kinds: Vec<u8>,
    /// VTK's stream of polyhedron faces.
    pub faces: Vec<i64>,
    /// Shape `[cells]` or empty: where each cell ends in `faces`, -1 where it is no polyhedron.
    pub face_ends: Vec<i64>,
    /// Numbers on cells.
    pub cell_columns: Vec<Column>,
    /// Numbers on points.
    pub point_columns: Vec<Column>,
}

/// Which arrays of a file to unpack; the others are passed over, which saves most of the time.
#[derive(Clone, Copy)]
pub struct Wanted<'a> {
    /// Points, cells and faces.
    pub geometry: bool,
    /// Whether the numbers of this name are wanted.
    pub column: &'a dyn Fn(&str) -> bool,
}

impl Wanted<'_> {
    /// Everything.
    pub const ALL: Wanted<'static> = Wanted { geometry: true, column: &|_| true };
}

/// Reads a `.vtu` file of ours.
///
/// # Errors
/// Missing, foreign or damaged files; never panics.
pub fn read(path: &Path) -> Result<Vtu, ReadError> {
    read_some(path, Wanted::ALL)
}

/// Reads what is wanted of a `.vtu` file of ours.
///
/// # Errors
/// As [`read`].
pub fn read_some(path: &Path, wanted: Wanted<'_>) -> Result<Vtu, ReadError> {
    let bytes = crate::read_plain(path)
        .map_err(|source| ReadError::Read { path: path.to_owned(), source })?;
    parse_some(&bytes, path, wanted)
}

/// Reads the bytes of a `.vtu` file; `path` is only for the messages.
///
/// # Errors
/// As [`read`].
pub fn parse(bytes: &[u8], path: &Path) -> Result<Vtu, ReadError> {
    parse_some(bytes, path, Wanted::ALL)
}

fn parse_some(bytes: &[u8], path: &Path, wanted: Wanted<'_>) -> Result<Vtu, ReadError> {
    let damaged = |reason: String| ReadError::Damaged { path: path.to_owned(), reason };
    if !bytes.starts_with(b"<?xml") {
        return Err(ReadError::Foreign { path: path.to_owned() });
    }
    let mark = b"<AppendedData encoding=\"raw\">\n_";
    let at = bytes.windows(mark.len()).position(|w| w == mark).ok_or_else(|| {
        damaged("it is truncated before its data, or was not written by riprap".to_owned())
    })?;
    let head =
        str::from_utf8(&bytes[..at]).map_err(|_| damaged("its header is not text".to_owned()))?;
    let end = b"\n</AppendedData>\n</VTKFile>\n";
    let data = bytes[at + mark.len()..]
        .strip_suffix(end)
        .ok_or_else(|| damaged("it is truncated: its end is missing".to_owned()))?;
    let tags = tags(head).ok_or_else(|| damaged("its header is not well-formed XML".to_owned()))?;
    fits(&tags, bytes.len() as u64, wanted).map_err(damaged)?;
    contents(&tags, data, wanted).map_err(damaged)
}

fn contents(tags: &[Tag], data: &[u8], wanted: Wanted<'_>) -> Result<Vtu, String> {
    let file = tags.iter().find(|t| t.name == "VTKFile").ok_or("it has no VTKFile element")?;
    for (key, value) in [
        ("type", "UnstructuredGrid"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
        ("compressor", "vtkZLibDataCompressor"),
    ] {
        if file.attribute(key).as_deref() != Some(value) {
            return Err(format!("{key} is not {value}"));
        }
    }
    let mut whole = Vtu { dimension: 2, ..Vtu::default() };
    let mut out = Vtu::default();
    let (mut points, mut cells) = (0, 0);
    let mut section = "";
    let mut i = 0;
    while i < tags.len() {
        let t = &tags[i];
        match t.name {
            "Piece" => {
                points = t.count("NumberOfPoints")?;
                cells = t.count("NumberOfCells")?;
                out = Vtu { dimension: whole.dimension, ..Vtu::default() };
            }
            "/Piece" => {
                if wanted.geometry {
                    whole_piece(&out, points, cells)?;
                }
                whole.append(std::mem::take(&mut out))?;
            }
            "FieldData" | "PointData" | "CellData" | "Points" | "Cells" => section = t.name,
            "DataArray" | "Array" => {
                i += 1;
                if !t.wanted(section, wanted) {
                    continue;
                }
                // The unit, if any, is the element inside.
                let unit = tags
                    .get(i)
                    .filter(|u| u.name == "InformationKey")
                    .map_or_else(|| "-".to_owned(), |u| unescape(u.text.trim()));
                let to = if section == "FieldData" { &mut whole } else { &mut out };
                array(to, t, section, unit, data, (points, cells))?;
                continue;
            }
            _other => {}
        }
        i += 1;
    }
    Ok(whole)
}

/// Checks that a piece has its points, cells and faces.
fn whole_piece(piece: &Vtu, points: usize, cells: usize) -> Result<(), String> {
    if piece.points.len() != points || piece.offsets.len() != cells {
        return Err("it has no points or no cells".to_owned());
    }
    let end = piece.offsets.last().map_or(0, |o| *o as usize);
    if !piece.offsets.is_sorted() || end != points || piece.kinds.len() != cells {
        return Err("its cells do not match its points".to_owned());
    }
    if !piece.face_ends.is_empty() && piece.face_ends.len() != cells {
        return Err("its faces do not match its cells".to_owned());
    }
    Ok(())
}

impl Vtu {
    /// Appends a piece, whose points and faces are counted from its own first.
    fn append(&mut self, piece: Self) -> Result<(), String> {
        let many = || "it has more points than can be numbered".to_owned();
        if self.kinds.is_empty() && self.cell_columns.is_empty() && self.point_columns.is_empty() {
            let Self { time, step, dimension, .. } = *self;
            let phase = std::mem::take(&mut self.phase);
            *self = Self { time, step, phase, dimension, ..piece };
            return Ok(());
        }
        let base = u32::try_from(self.points.len()).map_err(|_| many())?;
        for end in piece.offsets {
            self.offsets.push(end.checked_add(base).ok_or_else(many)?);
        }
        self.append_faces(piece.faces, piece.face_ends, piece.kinds.len(), i64::from(base))?;
        self.points.extend(piece.points);
        self.kinds.extend(piece.kinds);
        for (to, from) in [
            (&mut self.cell_columns, piece.cell_columns),
            (&mut self.point_columns, piece.point_columns),
        ] {
            if to.len() != from.len() {
                return Err("its pieces do not have the same arrays".to_owned());
            }
            for (to, from) in to.iter_mut().zip(from) {
                if to.name != from.name || to.components != from.components {
                    return Err("its pieces do not have the same arrays".to_owned());
                }
                to.data.extend(from.data);
            }
        }
        Ok(())
    }

    /// Appends the faces of a piece of so many cells, whose points are counted from `base` on.
    fn append_faces(
        &mut self,
        mut faces: Vec<i64>,
        ends: Vec<i64>,
        cells: usize,
        base: i64,
    ) -> Result<(), String> {
        if self.face_ends.is_empty() && ends.is_empty() {
            return Ok(());
        }
        let bad = || "its faces cannot be read".to_owned();
        let mut rest = &mut faces[..];
        while let Some((count, more)) = rest.split_first_mut() {
            rest = more;
            for _ in 0..*count {
                let (corners, more) = rest.split_first_mut().ok_or_else(bad)?;
                let corners = usize::try_from(*corners).map_err(|_| bad())?;
                let (corners, more) = more.split_at_mut_checked(corners).ok_or_else(bad)?;
                for corner in corners {
                    *corner = corner.checked_add(base).ok_or_else(bad)?;
                }
                rest = more;
            }
        }
        let before = self.faces.len() as i64;
        // A piece of bricks alone has no faces.
        self.face_ends.resize(self.kinds.len(), -1);
        let end = |end: i64| if end < 0 { Some(-1) } else { end.checked_add(before) };
        match ends.is_empty() {
            true => self.face_ends.resize(self.kinds.len() + cells, -1),
            false => {
                for of in ends {
                    self.face_ends.push(end(of).ok_or_else(bad)?);
                }
            }
        }
        self.faces.extend(faces);
        Ok(())
    }
}

/// Refuses a file whose counts say that what is wanted of it unpacks to far more than it can hold, before anything is unpacked.
fn fits(tags: &[Tag], length: u64, wanted: Wanted<'_>) -> Result<(), String> {
    let (mut counts, mut section, mut total) = ((0, 0), "", 0u64);
    for t in tags {
        match t.name {
            "Piece" => counts = (t.count("NumberOfPoints")?, t.count("NumberOfCells")?),
            "FieldData" | "PointData" | "CellData" | "Points" | "Cells" => section = t.name,
            "DataArray" | "Array" if t.wanted(section, wanted) => {
                total = total.saturating_add(t.bytes(section, counts).unwrap_or(0));
            }
            _other => {}
        }
    }
    if total > SMALL.max(FILE_RATIO.saturating_mul(length)) {
        return Err(format!(
            "its counts imply {} MiB of numbers, which do not fit in a file of {} KiB",
            total >> 20,
            length >> 10
        ));
    }
    Ok(())
}

pub(super) fn array(
    out: &mut Vtu,
    t: &Tag,
    section: &str,
    unit: String,
    data: &[u8],
    (points, cells): (usize, usize),
) -> Result<(), String> {
    let name = t.attribute("Name").ok_or("an array has no name")?;
    let bad = || format!("field data `{name}` cannot be read");
    let most = t.bytes(section, (points, cells));
    let load = || {
        let most = most.unwrap_or(u64::MAX);
        unpack(data, t.count("offset")?, most).map_err(|e| format!("array `{name}`: {e}"))
    };
    match (section, name.as_str()) {
        ("FieldData", "TimeValue") => out.time = t.text.trim().parse().map_err(|_| bad())?,
        ("FieldData", "step") => out.step = t.text.trim().parse().map_err(|_| bad())?,
        ("FieldData", "dimension") => out.dimension = t.text.trim().parse().map_err(|_| bad())?,
        ("FieldData", "phase") => {
            let codes: Result<Vec<u8>, _> = t.text.split_whitespace().map(str::parse).collect();
            let mut codes = codes.map_err(|_| bad())?;
            codes.pop();
            out.phase = String::from_utf8(codes).map_err(|_| bad())?;
        }
        ("Points", "Points") => out.points = triples(&numbers(&load()?)?, points, &name)?,
        ("Cells", "types") => out.kinds = load()?,
        ("Cells", "faces") => out.faces = integers(&load()?)?,
        ("Cells", "faceoffsets") => out.face_ends = integers(&load()?)?,
        ("Cells", "offsets") => {
            let bytes = load()?;
            let (ends, rest) = bytes.as_chunks::<8>();
            if !rest.is_empty() || ends.len() != cells {
                return Err("its cells are incomplete".to_owned());
            }
            out.offsets = ends
                .iter()
                .map(|e| u32::try_from(i64::from_le_bytes(*e)))
                .collect::<Result<_, _>>()
                .map_err(|_| "a cell ends at an impossible point".to_owned())?;
        }
        ("PointData" | "CellData", _) => {
            let on_points = section == "PointData";
            let items = if on_points { points } else { cells };
            let vectors = t.attribute("NumberOfComponents").as_deref() == Some("3");
            let components = match (vectors, out.dimension) {
                (false, _) => 1,
                (true, 3) => 3,
                (true, _) => 2,
            };
            let column = column(&name, &unit, numbers(&load()?)?, items, components)?;
            if on_points { &mut out.point_columns } else { &mut out.cell_columns }.push(column);
        }
        // Connectivity is the same in all our files.
        (_, _) => {}
    }
    Ok(())
}

/// A column of one, two or three components; VTK gives vectors of two components a third.
fn column(
    name: &str,
    unit: &str,
    values: Vec<f64>,
    items: usize,
    components: u8,
) -> Result<Column, String> {
    if components == 1 {
        return if values.len() == items {
            Ok(Column::scalar(name, unit, values))
        } else {
            Err(format!("array `{name}` has {} numbers for {items} items", values.len()))
        };
    }
    let vectors = triples(&values, items, name)?;
    if components == 3 {
        return Ok(Column::vector3(name, unit, vectors));
    }
    let flat: Vec<[f64; 2]> = vectors.iter().map(|v| [v[0], v[1]]).collect();
    Ok(Column::vector(name, unit, flat))
}

fn numbers(bytes: &[u8]) -> Result<Vec<f64>, String> {
    let (values, rest) = bytes.as_chunks::<8>();
    if !rest.is_empty() {
        return Err("an array ends inside a number".to_owned());
    }
    Ok(values.iter().map(|v| f64::from_le_bytes(*v)).collect())
}

fn integers(bytes: &[u8]) -> Result<Vec<i64>, String> {
    let (values, rest) = bytes.as_chunks::<8>();
    if !rest.is_empty() {
        return Err("an array ends inside a number".to_owned());
    }
    Ok(values.iter().map(|v| i64::from_le_bytes(*v)).collect())
}

fn triples(values: &[f64], items: usize, name: &str) -> Result<Vec<[f64; 3]>, String> {
    let (triples, rest) = values.as_chunks::<3>();
    if !rest.is_empty() || triples.len() != items {
        return Err(format!("array `{name}` has {} numbers for {items} vectors", values.len()));
    }
    Ok(triples.to_vec())
}

/// One array out of the appended data, of at most `most` bytes. Memory: never more than that, nor than its compressed bytes times
/// [`MAX_RATIO`].
fn unpack(data: &[u8], offset: usize, most: u64) -> Result<Vec<u8>, String> {
    let cut = || "its data are truncated".to_owned();
    let mut rest = data.get(offset..).ok_or_else(cut)?;
    let mut word = || -> Result<u64, String> {
        let (head, tail) = rest.split_first_chunk::<8>().ok_or_else(cut)?;
        rest = tail;
        Ok(u64::from_le_bytes(*head))
    };
    let (blocks, size, partial) = (word()?, word()?, word()?);
    // The head has eight bytes for the size of each block: more blocks than that cannot be there.
    if blocks > (data.len() / 8) as u64 {
        return Err(cut());
    }
    let sizes: Vec<u64> = (0..blocks).map(|_| word()).collect::<Result<_, _>>()?;
    let whole = if partial == 0 { blocks } else { blocks.saturating_sub(1) };
    if whole.saturating_mul(size).saturating_add(partial) > most {
        return Err("it decompresses to more than the counts of the file allow".to_owned());
    }
    let mut out = Vec::new();
    for (i, packed) in sizes.iter().enumerate() {
        let last = i + 1 == sizes.len();
        let plain = if last && partial != 0 { partial } else { size };
        let n = usize::try_from(*packed).map_err(|_| cut())?;
        let bytes = rest.get(..n).ok_or_else(cut)?;
        rest = &rest[n..];
        if plain > packed.saturating_mul(MAX_RATIO) {
            return Err("a block claims an impossible size".to_owned());
        }
        let before = out.len() as u64;
        ZlibDecoder::new(bytes)
            // One byte more than it should have, so that a longer one is seen.
            .take(plain + 1)
            .read_to_end(&mut out)
            .map_err(|e| format!("a block cannot be decompressed: {e}"))?;
        if out.len() as u64 - before != plain {
            return Err("a block has the wrong size".to_owned());
        }
    }
    Ok(out)
}

/// One XML tag: its name (`/name` for a closing one), attributes and the text after it.
#[derive(Debug)]
pub(super) struct Tag<'a> {
    pub(super) name: &'a str,
    attributes: Vec<(&'a str, &'a str)>,
    text: &'a str,
}

impl Tag<'_> {
    /// Whether this array of a section is asked for. Arrays without a name are, so that they are complained about.
    fn wanted(&self, section: &str, wanted: Wanted<'_>) -> bool {
        match section {
            "Points" | "Cells" => wanted.geometry,
            "PointData" | "CellData" => {
                self.attribute("Name").is_none_or(|name| (wanted.column)(&name))
            }
            _other => true,
        }
    }

    pub(super) fn attribute(&self, key: &str) -> Option<String> {
        self.attributes.iter().find(|a| a.0 == key).map(|a| unescape(a.1))
    }

    /// Bytes that an array unpacks to at most, by the counts of points and cells; `None` where they do not tell.
    fn bytes(&self, section: &str, (points, cells): (usize, usize)) -> Option<u64> {
        let (points, cells) = (points as u64, cells as u64);
        let items = match (section, self.attribute("Name")?.as_str()) {
            ("Points", _) => points.saturating_mul(3),
            ("Cells", "types") => return Some(cells),
            ("Cells", "offsets" | "faceoffsets") => cells,
            ("Cells", "faces") => FACES.saturating_mul(points.saturating_add(cells)),
            ("PointData", _) => points.saturating_mul(self.components()),
            ("CellData", _) => cells.saturating_mul(self.components()),
            (_, _) => return None,
        };
        Some(items.saturating_mul(8))
    }

    fn components(&self) -> u64 {
        let said = self.attribute("NumberOfComponents");
        said.and_then(|n| n.parse().ok()).unwrap_or(1)
    }

    fn count(&self, key: &str) -> Result<usize, String> {
        self.attribute(key)
            .and_then(|v| v.parse().ok())
            .ok_or_else(|| format!("`{}` has no usable {key}", self.name))
    }
}

/// Takes XML apart, as far as our own files need it: no comments, no CDATA. `None` if it is not well formed.
pub(super) fn tags(text: &str) -> Option<Vec<Tag<'_>>> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some(open) = rest.find('<') {
        rest = &rest[open + 1..];
        let close = rest.find('>')?;
        let body = rest[..close].trim_end_matches(['/', '?']);
        rest = &rest[close + 1..];
        let text = &rest[..rest.find('<').unwrap_or(rest.len())];
        let (name, mut more) = body.split_once(char::is_whitespace).unwrap_or((body, ""));
        let mut attributes = Vec::new();
        while let Some((key, value)) = more.split_once('=') {
            let value = value.strip_prefix('"')?;
            let (value, tail) = value.split_once('"')?;
            attributes.push((key.trim(), value));
            more = tail;
        }
        if !more.trim().is_empty() {
            return None;
        }
        out.push(Tag { name, attributes, text });
    }
    Some(out)
}

fn unescape(text: &str) -> String {
    // `&amp;` last: what it leaves must not be taken for the beginning of another one.
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

#[cfg(test)]
mod tests;
