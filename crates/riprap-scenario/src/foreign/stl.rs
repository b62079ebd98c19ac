//! Surfaces in STL, text or binary: each connected part that is closed and convex is a solid.
//!
//! Source: 3D Systems, "StereoLithography Interface Specification" (1988).

use std::collections::BTreeMap;

use riprap_core::sets::Sets;
use riprap_geom::Vec3;
use riprap_geom::polyhedron::MAX_VERTICES;

use super::{FileError, Place, at_byte, at_line, without_mark};

/// Bytes before the triangles of a binary file, and of one triangle.
const HEAD: usize = 84;
const RECORD: usize = 50;
/// A corner farther than this, times the size of its part, beyond a triangle makes the part not convex: coordinates
/// have the six digits of 32 bits.
const CONVEX: f64 = 1e-6;

/// A closed convex surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Different corners, in the length unit of the file.
    pub points: Vec<[f64; 3]>,
    /// Place of its first triangle.
    pub place: Place,
}

/// The parts of the surface that the bytes of a file describe, in the order of their first triangles.
///
/// # Errors
/// The first thing that is wrong, with its line or byte.
pub fn parse_stl(bytes: &[u8]) -> Result<Vec<Part>, FileError> {
    let triangles = match binary(bytes)? {
        Some(triangles) => triangles,
        None => text(bytes)?,
    };
    parts(&triangles)
}

/// A surface that need not be closed: different corners in the length unit of the file, those of each triangle, and the number of
/// triangles without an area, which are left out.
pub type Surface = (Vec<[f64; 3]>, Vec<[u32; 3]>, usize);

/// The triangles that the bytes of a file describe as one surface. Triangles without an area are left out.
///
/// # Errors
/// The first thing that is wrong, with its line or byte.
pub fn parse_surface(bytes: &[u8]) -> Result<Surface, FileError> {
    let triangles = match binary(bytes)? {
        Some(triangles) => triangles,
        None => text(bytes)?,
    };
    if triangles.corners.is_empty() {
        return Err(triangles.wrong(0, "there are no triangles".to_owned()));
    }
    Ok(surface(&triangles.corners))
}

/// Triangles as one surface. Those without an area are left out.
#[must_use]
pub fn surface(corners: &[[Vec3; 3]]) -> Surface {
    let (points, mut rings) = joined(corners);
    let all = rings.len();
    rings.retain(|[a, b, c]| a != b && b != c && c != a);
    let flat = all - rings.len();
    (points.iter().map(Vec3::to_array).collect(), rings, flat)
}

/// Triangles and where they are.
#[derive(Default)]
pub(super) struct Triangles {
    pub(super) corners: Vec<[Vec3; 3]>,
    /// Line of the last corner in a text file; none in a binary one.
    pub(super) lines: Vec<usize>,
}

impl Triangles {
    fn place(&self, triangle: usize) -> Place {
        match self.lines.get(triangle) {
            Some(line) => Place::Line(*line),
            None => Place::Byte(HEAD + RECORD * triangle),
        }
    }

    fn wrong(&self, triangle: usize, text: String) -> FileError {
        FileError { place: self.place(triangle), text }
    }
}

/// A binary file: one whose length is that of its triangles.
fn binary(bytes: &[u8]) -> Result<Option<Triangles>, FileError> {
    let count = bytes.get(80..HEAD).and_then(|b| b.try_into().ok());
    let count = count.map(u32::from_le_bytes);
    let whole = count.map(|count| HEAD as u64 + RECORD as u64 * u64::from(count));
    // Only the length tells: the head of a binary file may begin with `solid` too.
    if whole != Some(bytes.len() as u64) {
        // No text has the byte 0, which the count of a binary file nearly always has.
        let is_text = without_mark(bytes).trim_ascii_start().starts_with(b"solid")
            && !bytes[..bytes.len().min(HEAD)].contains(&0);
        let length = bytes.len() as u64;
        return match count.zip(whole) {
            _ if is_text => Ok(None),
            Some((count, whole)) if length > whole => Err(at_byte(
                whole as usize,
                format!(
                    "{count} triangles end here, but {} more bytes follow: this is not an STL file, or data were appended",
                    length - whole
                ),
            )),
            Some((count, whole)) => Err(at_byte(
                bytes.len(),
                format!(
                    "{count} triangles need {whole} bytes: this is not an STL file, or it is truncated"
                ),
            )),
            None => Err(at_byte(bytes.len(), "this is not an STL file, or it is truncated")),
        };
    }
    let mut triangles =
        Triangles { corners: Vec::with_capacity((bytes.len() - HEAD) / RECORD), lines: Vec::new() };
    for (k, record) in bytes[HEAD..].chunks_exact(RECORD).enumerate() {
        // The normal stands before the corners; it follows from them.
        let mut numbers = record[12..48].chunks_exact(4).map(|b| {
            let b = [b[0], b[1], b[2], b[3]];
            // -0 is 0.
            f64::from(f32::from_le_bytes(b)) + 0.0
        });
        let mut next = || numbers.next().unwrap_or(f64::NAN);
        let corners = [(); 3].map(|()| Vec3::new(next(), next(), next()));
        if corners.iter().any(|c| !c.is_finite()) {
            let text = format!("triangle {} has non-finite coordinates", k + 1);
            return Err(triangles.wrong(k, text));
        }
        triangles.corners.push(corners);
    }
    Ok(Some(triangles))
}

/// A text file: its lines `vertex x y z`.
fn text(bytes: &[u8]) -> Result<Triangles, FileError> {
    let mut triangles = Triangles { corners: Vec::new(), lines: Vec::new() };
    let (mut ring, mut ends) = (Vec::new(), false);
    for (line, words) in (1..).zip(bytes.split(|b| *b == b'\n')) {
        let words = String::from_utf8_lossy(words);
        let mut words = words.split_whitespace();
        match words.next() {
            Some("vertex") => {
                // All words: one that is no number between three that are would be passed over.
                let numbers = words.map(|word| word.parse().ok().filter(|x: &f64| x.is_finite()));
                let numbers: Option<Vec<f64>> = numbers.collect();
                let Some(&[x, y, z]) = numbers.as_deref() else {
                    let text = "`vertex` and three finite numbers are expected";
                    return Err(at_line(line, text));
                };
                ring.push(Vec3::new(x + 0.0, y + 0.0, z + 0.0));
            }
            Some("endloop") => {
                let Ok(corners) = <[Vec3; 3]>::try_from(std::mem::take(&mut ring)) else {
                    return Err(at_line(line, "a loop needs three vertices"));
                };
                triangles.corners.push(corners);
                triangles.lines.push(line);
            }
            Some("endsolid") => ends = true,
            Some(_) | None => {}
        }
    }
    if !ends || !ring.is_empty() {
        let text = "the file ends without `endsolid`: it is truncated";
        return Err(at_byte(bytes.len(), text));
    }
    Ok(triangles)
}

/// Connected parts, checked.
pub(super) fn parts(triangles: &Triangles) -> Result<Vec<Part>, FileError> {
    if triangles.corners.is_empty() {
        return Err(triangles.wrong(0, "there are no triangles".to_owned()));
    }
    let (points, rings) = joined(&triangles.corners);
    let mut sets = Sets::new(points.len());
    for ring in &rings {
        for k in 1..3 {
            sets.join([ring[0], ring[k]]);
        }
    }
    // Triangles of each part; parts in the order of their first triangle.
    let mut order: BTreeMap<u32, usize> = BTreeMap::new();
    let mut lists: Vec<Vec<usize>> = Vec::new();
    for (triangle, ring) in rings.iter().enumerate() {
        let part = *order.entry(sets.leader(ring[0])).or_insert(lists.len());
        if part == lists.len() {
            lists.push(Vec::new());
        }
        lists[part].push(triangle);
    }
    let lists = lists.iter().enumerate();
    lists.map(|(number, list)| part(triangles, &points, &rings, number, list)).collect()
}

/// Different corners, and those of each triangle.
fn joined(corners: &[[Vec3; 3]]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let flat: Vec<Vec3> = corners.iter().flatten().copied().collect();
    let mut order: Vec<u32> = (0..flat.len() as u32).collect();
    let compare = |a: &Vec3, b: &Vec3| {
        let pairs = a.to_array().into_iter().zip(b.to_array());
        pairs.fold(std::cmp::Ordering::Equal, |so_far, (x, y)| so_far.then(x.total_cmp(&y)))
    };
    order.sort_unstable_by(|a, b| compare(&flat[*a as usize], &flat[*b as usize]).then(a.cmp(b)));
    let mut points: Vec<Vec3> = Vec::new();
    let mut number = vec![0_u32; flat.len()];
    for k in order {
        let p = flat[k as usize];
        if points.last() != Some(&p) {
            points.push(p);
        }
        number[k as usize] = points.len() as u32 - 1;
    }
    let rings = number.chunks_exact(3).map(|c| [c[0], c[1], c[2]]);
    (points, rings.collect())
}

/// One part: closed and convex.
fn part(
    triangles: &Triangles,
    points: &[Vec3],
    rings: &[[u32; 3]],
    number: usize,
    list: &[usize],
) -> Result<Part, FileError> {
    let number = number + 1;
    let mut own: Vec<u32> = list.iter().flat_map(|t| rings[*t]).collect();
    own.sort_unstable();
    own.dedup();
    // First of all, since convexity looks at every corner from every triangle.
    if own.len() > MAX_VERTICES {
        let text =
            format!("part {number} has {} corners; a block has at most {MAX_VERTICES}", own.len());
        return Err(triangles.wrong(list[0], text));
    }
    let mut edges: Vec<(u32, u32, usize)> = Vec::with_capacity(3 * list.len());
    for &t in list {
        let [a, b, c] = rings[t];
        let ring = [(a, b, t), (b, c, t), (c, a, t)];
        edges.extend(ring.into_iter().filter(|(a, b, _)| a != b));
    }
    edges.sort_unstable();
    // A closed surface of one piece has 2 V - 4 triangles with different corners.
    if edges.len() > 6 * own.len() {
        let text = format!("part {number} is not a simple surface: it has duplicate triangles");
        return Err(triangles.wrong(list[0], text));
    }
    // Two triangles that turn alike run along their common edge in opposite directions.
    let there = |a: u32, b: u32| {
        let k = edges.partition_point(|e| (e.0, e.1) < (b, a));
        edges.get(k).is_some_and(|e| (e.0, e.1) == (b, a))
    };
    let lone: Vec<usize> =
        edges.iter().filter(|(a, b, _)| !there(*a, *b)).map(|(_, _, t)| *t).collect();
    if let Some(&t) = lone.iter().min() {
        let text = format!(
            "part {number} is not closed: {} edges have a triangle on only one side",
            lone.len()
        );
        return Err(triangles.wrong(t, text));
    }
    let corners: Vec<Vec3> = own.iter().map(|k| points[*k as usize]).collect();
    let faces = list.iter().map(|t| rings[*t].map(|k| points[k as usize]));
    if let Some(k) = beyond(&corners, faces) {
        let text = format!(
            "part {number} is not convex, or its triangles face inwards; divide it into convex parts, which `mesh.glued` joins to one block"
        );
        return Err(triangles.wrong(list[k], text));
    }
    Ok(Part {
        points: corners.iter().map(Vec3::to_array).collect(),
        place: triangles.place(list[0]),
    })
}

/// The first of the triangles that a corner lies beyond.
fn beyond(corners: &[Vec3], mut triangles: impl Iterator<Item = [Vec3; 3]>) -> Option<usize> {
    let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let (low, high) = corners.iter().fold(start, |(low, high), p| (low.min(*p), high.max(*p)));
    let slack = CONVEX * (high - low).length();
    triangles.position(|[a, b, c]| {
        let normal = (b - a).cross(c - a);
        let length = normal.length();
        // Corners on one line span no plane that others could lie beyond.
        let normal = normal / length;
        length != 0.0 && corners.iter().any(|p| (*p - a).dot(normal) > slack)
    })
}
