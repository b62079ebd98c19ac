//! Tessellations of Neper (`.tess`): cells as polyhedra in space, as polygons in the plane.
//!
//! Read are the vertices, faces and polyhedra; seeds, orientations, the domain and periodicity are passed over.
//!
//! Source: Neper reference manual, "Tessellation File (.tess)", formats 2.0 to 4.5.

use std::collections::BTreeMap;

use riprap_geom::polyhedron::MAX_VERTICES;

use super::{FileError, at_byte, at_line, shown, without_mark};

/// A cell in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Its number in Neper.
    pub number: i64,
    /// Corners in order along the boundary, in the length unit of the file.
    pub points: Vec<[f64; 2]>,
    /// Its line in the file.
    pub line: usize,
}

/// A cell in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Its number in Neper.
    pub number: i64,
    /// Corners, in the length unit of the file.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of each face by their place in `vertices`.
    pub faces: Vec<Vec<u32>>,
    /// Its line in the file.
    pub line: usize,
}

/// A face as the file lists it.
struct Face {
    /// Its corners by their numbers.
    ring: Vec<i64>,
    line: usize,
    /// How often polyhedra have named it.
    uses: u8,
}

/// Sides of a face, each that of one polyhedron at most.
const SIDES: u8 = 2;

/// The cells of a tessellation.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Of dimension 2.
    Plane(Vec<Polygon>),
    /// Of dimension 3.
    Space(Vec<Solid>),
}

/// The cells that the bytes of a file describe.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_tess(bytes: &[u8]) -> Result<Cells, FileError> {
    let words = without_mark(bytes);
    let text = std::str::from_utf8(words).map_err(|error| {
        let mark = bytes.len() - words.len();
        at_byte(mark + error.valid_up_to(), "this is not a text file")
    })?;
    let mut reader = Reader::new(text);
    if reader.lines.first().map(|line| line.trim()) != Some("***tess") {
        return Err(at_line(1, "`***tess` is expected: this is not a Neper tessellation"));
    }
    reader.section("**general")?;
    let general = reader.next()?;
    let plane = match general.split_whitespace().next() {
        Some("2") => true,
        Some("3") => false,
        other => {
            let other = shown(other.unwrap_or_default());
            return Err(reader.wrong(format!("cells of dimension {other} cannot be blocks")));
        }
    };
    let vertices = vertices(&mut reader)?;
    let faces = faces(&mut reader, &vertices, plane)?;
    let cells = if plane {
        // In the plane the faces are the cells.
        let polygon = |(number, face): (i64, Face)| Polygon {
            number,
            points: face.ring.iter().map(|k| [vertices[k][0], vertices[k][1]]).collect(),
            line: face.line,
        };
        Cells::Plane(faces.into_iter().map(polygon).collect())
    } else {
        Cells::Space(polyhedra(&mut reader, &vertices, faces)?)
    };
    some(cells, &reader)
}

/// Vertices by their numbers, which a file may give as large and as scattered as it likes.
type Vertices = BTreeMap<i64, [f64; 3]>;

fn vertices(reader: &mut Reader) -> Result<Vertices, FileError> {
    let mut vertices = Vertices::new();
    for _ in 0..reader.entries("**vertex")? {
        let mut words = reader.row()?;
        let number = reader.integer(words.next())?;
        let mut place = [0.0; 3];
        for x in &mut place {
            *x = reader.number(words.next())?;
        }
        vertices.insert(number, place);
    }
    Ok(vertices)
}

/// Faces by their numbers.
fn faces(
    reader: &mut Reader,
    vertices: &Vertices,
    plane: bool,
) -> Result<BTreeMap<i64, Face>, FileError> {
    let mut faces = BTreeMap::new();
    for _ in 0..reader.entries("**face")? {
        let mut words = reader.row()?;
        let number = reader.integer(words.next())?;
        let ring = reader.list(&mut words)?;
        if let Some(corner) = ring.iter().find(|k| !vertices.contains_key(k)) {
            return Err(reader.wrong(format!("there is no vertex {corner}")));
        }
        if !plane && ring.len() > MAX_VERTICES {
            return Err(reader.wrong(format!(
                "face {number} has {} corners; a block has at most {MAX_VERTICES}",
                ring.len()
            )));
        }
        let face = Face { ring, line: reader.at, uses: 0 };
        faces.insert(number, face);
        // Edges, equation and state.
        for _ in 0..3 {
            reader.next()?;
        }
    }
    Ok(faces)
}

fn polyhedra(
    reader: &mut Reader,
    vertices: &Vertices,
    mut faces: BTreeMap<i64, Face>,
) -> Result<Vec<Solid>, FileError> {
    let mut cells = Vec::new();
    for _ in 0..reader.entries("**polyhedron")? {
        let mut words = reader.row()?;
        let number = reader.integer(words.next())?;
        let signed = reader.list(&mut words)?;
        let mut cell = Solid {
            number,
            vertices: Vec::new(),
            faces: Vec::with_capacity(signed.len()),
            line: reader.at,
        };
        let mut places: BTreeMap<i64, u32> = BTreeMap::new();
        for signed in signed {
            // The lowest number has no opposite.
            let number = signed.saturating_abs();
            let Some(face) = faces.get_mut(&number) else {
                return Err(reader.wrong(format!("there is no face {number}")));
            };
            face.uses += 1;
            // Each use copies all corners: without a limit a small file could ask for any memory.
            if face.uses > SIDES {
                return Err(reader.wrong(format!(
                    "face {number} is used for the third time; it can lie between two polyhedra at most"
                )));
            }
            let mut place = |corner: &i64| {
                *places.entry(*corner).or_insert_with(|| {
                    cell.vertices.push(vertices[corner]);
                    cell.vertices.len() as u32 - 1
                })
            };
            let mut corners: Vec<u32> = face.ring.iter().map(&mut place).collect();
            // A negative number: the face looks inwards.
            if signed < 0 {
                corners.reverse();
            }
            cell.faces.push(corners);
        }
        cells.push(cell);
    }
    Ok(cells)
}

/// The cells, if there are any.
fn some(cells: Cells, reader: &Reader) -> Result<Cells, FileError> {
    let none = match &cells {
        Cells::Plane(cells) => cells.is_empty(),
        Cells::Space(cells) => cells.is_empty(),
    };
    if none {
        return Err(reader.wrong("the tessellation has no cells"));
    }
    Ok(cells)
}

/// Lines by sections.
struct Reader<'a> {
    lines: Vec<&'a str>,
    /// First line of each section.
    sections: BTreeMap<&'a str, usize>,
    /// Lines read so far.
    at: usize,
}

impl<'a> Reader<'a> {
    fn new(text: &'a str) -> Self {
        let lines: Vec<&str> = text.lines().collect();
        // From the end, so that of several sections of one name the first counts.
        let named = lines.iter().enumerate().rev();
        let sections = named
            .filter(|(_, line)| line.trim_start().starts_with("**"))
            .map(|(at, line)| (line.trim(), at + 1))
            .collect();
        Self { lines, sections, at: 0 }
    }

    /// An error at the line read last.
    fn wrong(&self, text: impl Into<String>) -> FileError {
        at_line(self.at.clamp(1, self.lines.len().max(1)), text)
    }

    /// Goes to the line behind the name of a section.
    fn section(&mut self, name: &str) -> Result<(), FileError> {
        match self.sections.get(name) {
            Some(at) => {
                self.at = *at;
                Ok(())
            }
            None => {
                self.at = self.lines.len();
                let why = "the file is truncated, or its cells are not polyhedra (a raster)";
                Err(self.wrong(format!("there is no section {name}: {why}")))
            }
        }
    }

    /// The next line that is not empty.
    fn next(&mut self) -> Result<&'a str, FileError> {
        while let Some(line) = self.lines.get(self.at) {
            self.at += 1;
            if !line.trim().is_empty() {
                return Ok(line);
            }
        }
        Err(self.wrong("the file ends here: it is truncated"))
    }

    /// Number of entries of a section, which is not larger than the file.
    fn entries(&mut self, name: &str) -> Result<usize, FileError> {
        self.section(name)?;
        let line = self.next()?;
        let count = self.integer(line.split_whitespace().next())?;
        let most = self.lines.len();
        match usize::try_from(count).ok().filter(|count| *count <= most) {
            Some(count) => Ok(count),
            None => Err(self.wrong(format!("{count} entries in a file of {most} lines"))),
        }
    }

    /// The words of the next entry.
    fn row(&mut self) -> Result<std::str::SplitWhitespace<'a>, FileError> {
        let line = self.next()?;
        if line.trim_start().starts_with('*') {
            return Err(self.wrong("more entries were declared, but the next section begins"));
        }
        Ok(line.split_whitespace())
    }

    /// A number of three or more, and as many whole numbers.
    fn list(&self, words: &mut std::str::SplitWhitespace<'a>) -> Result<Vec<i64>, FileError> {
        let count = self.integer(words.next())?;
        // A line has only so many words, whatever its count says.
        let list = words.take(usize::try_from(count).unwrap_or(0));
        let list: Vec<i64> = list.map(|word| self.integer(Some(word))).collect::<Result<_, _>>()?;
        if list.len() as i64 != count {
            return Err(self.wrong(format!("{count} numbers are expected, not {}", list.len())));
        }
        if count < 3 {
            return Err(self.wrong("at least three are expected"));
        }
        Ok(list)
    }

    fn integer(&self, word: Option<&str>) -> Result<i64, FileError> {
        let word = word.unwrap_or_default();
        word.parse()
            .map_err(|_| self.wrong(format!("an integer is expected, not {:?}", shown(word))))
    }

    fn number(&self, word: Option<&str>) -> Result<f64, FileError> {
        let word = word.unwrap_or_default();
        let number = word.parse::<f64>().ok().filter(|x| x.is_finite());
        number.ok_or_else(|| self.wrong(format!("a number is expected, not {:?}", shown(word))))
    }
}
