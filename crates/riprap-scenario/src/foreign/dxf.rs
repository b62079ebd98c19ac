//! Lines of DXF drawings, text or binary: outlines of blocks and traces of joints.
//!
//! Read are LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE and ELLIPSE of the model space with their layers; arcs become straight
//! pieces. Blocks of the drawing are put where they are inserted. All else is counted by kind ([`Drawing::left_out`]).
//!
//! Source: Autodesk, "DXF Reference"; arcs by their bulge, places by the arbitrary axis algorithm.

use std::collections::BTreeMap;

use riprap_geom::Vec3;

use super::dxf_pairs::{Pairs, Value};
use super::{FileError, Place, shown};

mod curve;
mod insert;
mod outline;

use curve::{Curve, arc, pieces};
use insert::Insert;
pub use outline::Outlines;

/// Most points that the lines of a drawing may have, arcs in pieces.
pub const MAX_POINTS: usize = 4_000_000;
/// Distance of an arc from its pieces where none is given, times its radius.
pub const SAGITTA: f64 = 0.01;
/// Most kinds of entity that are counted one by one.
const MOST_KINDS: usize = 100;
/// Ends nearer than this, times the size of a line, close it.
const CLOSED: f64 = 1e-9;

/// A line of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline {
    /// Name of its layer.
    pub layer: String,
    /// Whether its last point is joined to its first.
    pub closed: bool,
    /// Points x, y in the length unit of the drawing.
    pub points: Vec<[f64; 2]>,
    /// Where it begins in the file.
    pub place: Place,
    /// Kind of entity: `LINE`, `LWPOLYLINE`, ...
    pub kind: &'static str,
}

/// A face in space (3DFACE).
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Name of its layer.
    pub layer: String,
    /// Corners x, y, z in the length unit of the drawing; the last two of a triangle are the same.
    pub corners: [[f64; 3]; 4],
}

/// Why an entity is not among the lines.
pub type Why = &'static str;

/// What is read of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Length of a unit of the drawing, m, if it says so (`$INSUNITS`).
    pub unit: Option<f64>,
    /// Lines in their order.
    pub lines: Vec<Polyline>,
    /// Faces in space of three or four corners, outside of blocks. They are among `left_out` too, as they are no lines.
    pub faces: Vec<Face>,
    /// Inserted blocks of the drawing whose lines are among `lines`.
    pub inserted: usize,
    /// How many entities of a kind are not among the lines, and why.
    pub left_out: BTreeMap<(String, Why), usize>,
}

/// Lines of a drawing, or of one of its blocks, before blocks are inserted.
#[derive(Default)]
struct Content {
    lines: Vec<Polyline>,
    inserts: Vec<Insert>,
    faces: Vec<Face>,
    left_out: BTreeMap<(String, Why), usize>,
}

impl Content {
    fn leave_out(&mut self, kind: &str, why: Why) {
        // Kinds are words of the file, which may have any number of them.
        let full = self.left_out.len() >= MOST_KINDS;
        let kind = if full { "other" } else { kind };
        *self.left_out.entry((shown(kind), why)).or_default() += 1;
    }
}

/// What reading needs beside the content.
struct Reading {
    sagitta: Option<f64>,
    /// Points that there is room for.
    room: usize,
}

impl Drawing {
    /// Names of the layers with lines, in the order of their first line.
    #[must_use]
    pub fn layers(&self) -> Vec<&str> {
        let mut seen = std::collections::BTreeSet::new();
        let layers = self.lines.iter().map(|line| line.layer.as_str());
        layers.filter(|layer| seen.insert(*layer)).collect()
    }
}

/// The lines that the bytes of a file describe. `sagitta`: largest distance of an arc from its pieces, in units of the
/// drawing; without it [`SAGITTA`] of the radius.
///
/// # Errors
/// The first thing that is wrong, with its line or byte.
pub fn parse_dxf(bytes: &[u8], sagitta: Option<f64>) -> Result<Drawing, FileError> {
    let mut pairs = Pairs::new(bytes);
    let mut drawing = Drawing::default();
    let (mut content, mut blocks) = (Content::default(), BTreeMap::new());
    let mut reading = Reading { sagitta, room: MAX_POINTS };
    loop {
        let Some((code, value)) = pairs.next()? else {
            return Err(pairs.cut_off());
        };
        if code != 0 {
            if code == 999 {
                continue;
            }
            return Err(pairs.wrong("a section should begin here: this is not a DXF drawing"));
        }
        match value.text().as_ref() {
            "EOF" => {
                insert::expand(&mut drawing, content, &blocks, &mut reading)?;
                return Ok(drawing);
            }
            "SECTION" => {}
            _ => return Err(pairs.wrong("a section should begin here: this is not a DXF drawing")),
        }
        let name = match pairs.next()? {
            Some((2, name)) => name.text().into_owned(),
            Some(_) => return Err(pairs.wrong("a section has no name")),
            None => return Err(pairs.cut_off()),
        };
        match name.as_str() {
            "HEADER" => header(&mut pairs, &mut drawing)?,
            "BLOCKS" => insert::blocks(&mut pairs, &mut blocks, &mut reading)?,
            "ENTITIES" => {
                entities(&mut pairs, &mut content, &mut reading, "")?;
            }
            _ => while section_goes_on(&mut pairs)?.is_some() {},
        }
    }
}

/// The next pair of a section; nothing at its end.
fn section_goes_on<'a>(pairs: &mut Pairs<'a>) -> Result<Option<(i32, Value<'a>)>, FileError> {
    match pairs.next()? {
        Some((0, value)) if value.text() == "ENDSEC" => Ok(None),
        Some(pair) => Ok(Some(pair)),
        None => Err(pairs.cut_off()),
    }
}

fn header(pairs: &mut Pairs, drawing: &mut Drawing) -> Result<(), FileError> {
    let mut name = String::new();
    while let Some((code, value)) = section_goes_on(pairs)? {
        match (code, name.as_str()) {
            (9, _) => name = value.text().into_owned(),
            (70, "$INSUNITS") => drawing.unit = unit(pairs.whole(value)?),
            (3, "$DWGCODEPAGE") => pairs.code_page(value),
            _ => {}
        }
    }
    Ok(())
}

/// Metres of the unit with a number of `$INSUNITS`.
fn unit(number: i64) -> Option<f64> {
    Some(match number {
        1 => 0.0254,
        2 => 0.3048,
        3 => 1609.344,
        4 => 1e-3,
        5 => 1e-2,
        6 => 1.0,
        7 => 1e3,
        8 => 2.54e-8,
        9 => 2.54e-5,
        10 => 0.9144,
        11 => 1e-10,
        12 => 1e-9,
        13 => 1e-6,
        14 => 0.1,
        15 => 10.0,
        16 => 100.0,
        17 => 1e9,
        // Survey feet, inches, yards and miles of the United States.
        21 => 1200.0 / 3937.0,
        22 => 100.0 / 3937.0,
        23 => 3600.0 / 3937.0,
        24 => 5280.0 * 1200.0 / 3937.0,
        _ => return None,
    })
}

/// Kinds of entity that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Line,
    LwPolyline,
    /// Its points follow as entities of their own.
    Polyline,
    Vertex,
    Arc,
    Circle,
    Ellipse,
    Insert,
    Face,
    /// Ends or describes other entities.
    Mark,
    Other,
}

impl Kind {
    fn of(name: &str) -> Self {
        match name {
            "LINE" => Kind::Line,
            "LWPOLYLINE" => Kind::LwPolyline,
            "POLYLINE" => Kind::Polyline,
            "VERTEX" => Kind::Vertex,
            "ARC" => Kind::Arc,
            "CIRCLE" => Kind::Circle,
            "ELLIPSE" => Kind::Ellipse,
            "INSERT" => Kind::Insert,
            "3DFACE" => Kind::Face,
            "" | "SEQEND" | "ATTRIB" | "ATTDEF" | "BLOCK" | "ENDBLK" | "VIEWPORT" => Kind::Mark,
            _ => Kind::Other,
        }
    }

    fn word(self) -> &'static str {
        match self {
            Kind::Line => "LINE",
            Kind::LwPolyline => "LWPOLYLINE",
            Kind::Polyline | Kind::Vertex => "POLYLINE",
            Kind::Arc => "ARC",
            Kind::Circle => "CIRCLE",
            Kind::Ellipse => "ELLIPSE",
            Kind::Insert => "INSERT",
            Kind::Face => "3DFACE",
            Kind::Mark | Kind::Other => "",
        }
    }
}

/// A point of a line: x, y, z and the bulge of the piece behind it.
type Point = [f64; 4];

/// An entity that is being read.
struct Entity {
    kind: Kind,
    /// As the file calls it.
    word: String,
    layer: String,
    /// Name of the block of an INSERT.
    name: String,
    flags: i64,
    paper: bool,
    points: Vec<Point>,
    normal: Vec3,
    elevation: f64,
    place: Place,
    /// Numbers of the group codes 40 to 51, 70 and 71 as they came.
    numbers: BTreeMap<i32, f64>,
}

impl Entity {
    fn new(name: &str, place: Place) -> Self {
        Self {
            kind: Kind::of(name),
            word: shown(name),
            layer: "0".to_owned(),
            name: String::new(),
            flags: 0,
            paper: false,
            points: Vec::new(),
            normal: Vec3::Z,
            elevation: 0.0,
            place,
            numbers: BTreeMap::new(),
        }
    }

    /// Takes one pair.
    fn take(&mut self, pairs: &Pairs, code: i32, value: Value) -> Result<(), FileError> {
        let axis = (code / 10 - 1) as usize;
        match (code, self.kind) {
            (8, _) => self.layer = pairs.name(value),
            (67, _) => self.paper = pairs.whole(value)? != 0,
            (_, Kind::Mark | Kind::Other) => {}
            (2, Kind::Insert) => self.name = pairs.name(value),
            (70 | 71, Kind::Insert) => {
                self.numbers.insert(code, pairs.whole(value)? as f64);
            }
            (70, _) => self.flags = pairs.whole(value)?,
            (38, _) => self.elevation = pairs.real(value)?,
            (210 | 220 | 230, _) => {
                self.normal[(code / 10 - 21) as usize] = pairs.real(value)?;
            }
            (10, _) => self.points.push([pairs.real(value)?, 0.0, 0.0, 0.0]),
            (11, Kind::Line | Kind::Ellipse) | (11..=13, Kind::Face) => {
                self.points.push([pairs.real(value)?, 0.0, 0.0, 0.0]);
            }
            (20 | 30, _)
            | (21 | 31, Kind::Line | Kind::Ellipse)
            | (21..=23 | 31..=33, Kind::Face) => {
                let x = pairs.real(value)?;
                if let Some(point) = self.points.last_mut() {
                    point[axis] = x;
                }
            }
            (42, Kind::LwPolyline | Kind::Vertex) => {
                let bulge = pairs.real(value)?;
                if let Some(point) = self.points.last_mut() {
                    point[3] = bulge;
                }
            }
            (40..=51, Kind::Arc | Kind::Circle | Kind::Ellipse | Kind::Insert) => {
                self.numbers.insert(code, pairs.real(value)?);
            }
            _ => {}
        }
        Ok(())
    }

    fn number(&self, code: i32, missing: f64) -> f64 {
        self.numbers.get(&code).copied().unwrap_or(missing)
    }

    /// Whether it is a mesh of polygons (16) or faces (64), not a line.
    fn is_mesh(&self) -> bool {
        self.kind == Kind::Polyline && self.flags & (16 | 64) != 0
    }
}

/// Reads entities up to the end of the section, or of the block; whether the section goes on. `first` is the word of an entity that
/// has begun.
fn entities(
    pairs: &mut Pairs,
    content: &mut Content,
    reading: &mut Reading,
    first: &str,
) -> Result<bool, FileError> {
    let mut current = Entity::new(first, pairs.place());
    // A POLYLINE whose points are being read.
    let mut open: Option<Entity> = None;
    loop {
        let pair = section_goes_on(pairs)?;
        let (next, more) = match pair {
            Some((0, value)) if value.text() == "ENDBLK" => (None, true),
            Some((0, value)) => (Some(Entity::new(&value.text(), pairs.place())), true),
            Some((code, value)) => {
                current.take(pairs, code, value)?;
                continue;
            }
            None => (None, false),
        };
        // Whatever follows the points ends a POLYLINE, its SEQEND or not.
        let ended = next.as_ref().is_none_or(|next| next.kind != Kind::Vertex);
        let last = std::mem::replace(&mut current, Entity::new("", pairs.place()));
        finish(pairs, content, last, &mut open, reading)?;
        if ended && let Some(line) = open.take() {
            close(pairs, content, line, reading)?;
        }
        match next {
            Some(next) => current = next,
            None => return Ok(more),
        }
    }
}

/// Puts an entity where it belongs.
fn finish(
    pairs: &Pairs,
    content: &mut Content,
    entity: Entity,
    open: &mut Option<Entity>,
    reading: &mut Reading,
) -> Result<(), FileError> {
    if entity.paper && !matches!(entity.kind, Kind::Mark | Kind::Vertex) {
        content.leave_out(&entity.word, "in the paper space");
        return Ok(());
    }
    match entity.kind {
        Kind::Line | Kind::LwPolyline => close(pairs, content, entity, reading)?,
        Kind::Arc | Kind::Circle | Kind::Ellipse => round(pairs, content, &entity, reading)?,
        Kind::Polyline => {
            let mut entity = entity;
            // The point of a POLYLINE is its elevation.
            let own = entity.points.drain(..).next();
            entity.elevation = own.map_or(0.0, |p| p[2]);
            *open = Some(entity);
        }
        Kind::Vertex => {
            // 16: a point of the frame of a spline, not of the curve.
            if let Some(line) = open.as_mut().filter(|_| entity.flags & 16 == 0) {
                line.points.extend(entity.points.first());
            }
        }
        Kind::Insert => content.inserts.push(Insert::of(&entity)),
        Kind::Mark => {}
        Kind::Face => {
            content.leave_out(&entity.word, "no lines");
            let corner = |k: usize| entity.points.get(k).map(|[x, y, z, _]| [*x, *y, *z]);
            let last = entity.points.len().saturating_sub(1);
            if let [Some(a), Some(b), Some(c), Some(d)] =
                [0, 1, 2, 3].map(|k: usize| corner(k.min(last)))
            {
                reading.check(content.faces.len(), &|text| pairs.wrong(text))?;
                content.faces.push(Face { layer: entity.layer, corners: [a, b, c, d] });
            }
        }
        Kind::Other => content.leave_out(&entity.word, "no lines"),
    }
    Ok(())
}

/// Adds a line to the content.
fn close(
    pairs: &Pairs,
    content: &mut Content,
    entity: Entity,
    reading: &mut Reading,
) -> Result<(), FileError> {
    if entity.is_mesh() {
        content.leave_out(entity.kind.word(), "meshes");
        return Ok(());
    }
    let in_space =
        entity.kind == Kind::Line || (entity.kind == Kind::Polyline && entity.flags & 8 != 0);
    let flagged = entity.kind != Kind::Line && entity.flags & 1 != 0;
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(entity.points.len());
    let count = entity.points.len();
    for (k, &[x, y, _, bulge]) in entity.points.iter().enumerate() {
        points.push([x, y]);
        // A bulge lies in the plane of its polyline; a line in space has none.
        if (k + 1 < count || flagged) && bulge != 0.0 && !in_space {
            let [to_x, to_y, ..] = entity.points[(k + 1) % count];
            arc([x, y], [to_x, to_y], bulge, reading.sagitta, &mut points);
        }
        reading.check(points.len(), &|text| pairs.wrong(text))?;
    }
    if !in_space {
        flatten(pairs, &entity, &mut points)?;
    }
    add(content, &entity, points, flagged, reading);
    Ok(())
}

/// Adds a circle, an ellipse or an arc as straight pieces.
fn round(
    pairs: &Pairs,
    content: &mut Content,
    entity: &Entity,
    reading: &mut Reading,
) -> Result<(), FileError> {
    let Some(curve) = Curve::of(entity) else {
        content.leave_out(entity.kind.word(), "without a radius");
        return Ok(());
    };
    let mut points = pieces(&curve, reading.sagitta);
    reading.check(points.len(), &|text| pairs.wrong(text))?;
    // An ellipse lies where it is drawn; circles and arcs in the plane of their normal.
    if entity.kind != Kind::Ellipse {
        flatten(pairs, entity, &mut points)?;
    }
    add(content, entity, points, curve.whole, reading);
    Ok(())
}

impl Reading {
    /// Whether there is room for more points.
    fn check(&self, points: usize, wrong: &dyn Fn(String) -> FileError) -> Result<(), FileError> {
        if points > self.room {
            return Err(wrong(format!(
                "the lines of the drawing have more than {MAX_POINTS} points, with divided arcs and expanded blocks; use a larger sagitta"
            )));
        }
        Ok(())
    }
}

/// Brings points from the plane of an entity with an extrusion to x and y.
fn flatten(pairs: &Pairs, entity: &Entity, points: &mut [[f64; 2]]) -> Result<(), FileError> {
    if entity.normal == Vec3::Z {
        return Ok(());
    }
    let [a, b, n] = axes(entity.normal)
        .ok_or_else(|| pairs.wrong("a polyline has an extrusion vector of zero length"))?;
    let elevation = if matches!(entity.kind, Kind::Arc | Kind::Circle) {
        entity.points.first().map_or(0.0, |p| p[2])
    } else {
        entity.elevation
    };
    for p in points {
        let place = p[0] * a + p[1] * b + elevation * n;
        *p = [place.x, place.y];
    }
    Ok(())
}

/// Adds the points of an entity, if they are a line.
fn add(
    content: &mut Content,
    entity: &Entity,
    mut points: Vec<[f64; 2]>,
    flagged: bool,
    reading: &mut Reading,
) {
    let size = extent(&points);
    let ends = points.first().zip(points.last());
    // Drawn back to its start, a line is closed without the flag.
    let joined = ends.is_some_and(|(a, b)| (0..2).all(|k| (a[k] - b[k]).abs() <= CLOSED * size));
    if joined && points.len() > 1 {
        points.pop();
    }
    let closed = (flagged || joined) && points.len() > 2;
    if points.len() < 2 {
        content.leave_out(entity.kind.word(), "without a length");
        return;
    }
    reading.room -= points.len().min(reading.room);
    content.lines.push(Polyline {
        layer: entity.layer.clone(),
        closed,
        points,
        place: entity.place,
        kind: entity.kind.word(),
    });
}

/// Axes x and y of the plane with a normal, and its direction; `None` if it has none.
fn axes(normal: Vec3) -> Option<[Vec3; 3]> {
    let n = normal.try_normalize()?;
    // The bound of the algorithm itself: with another one some entities would lie otherwise than where they were drawn.
    let near_z = n.x.abs() < 1.0 / 64.0 && n.y.abs() < 1.0 / 64.0;
    let a = if near_z { Vec3::Y } else { Vec3::Z }.cross(n).normalize();
    Some([a, n.cross(a), n])
}

/// Larger edge of the box around points.
fn extent(points: &[[f64; 2]]) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        for k in 0..2 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    (high[0] - low[0]).max(high[1] - low[1])
}
