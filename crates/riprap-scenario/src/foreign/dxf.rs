//! Lines and polylines of DXF drawings, text or binary: outlines of blocks and traces of joints.
//!
//! Read are LINE, LWPOLYLINE and POLYLINE of the model space with their layers; arcs become straight pieces. What
//! stands in blocks (INSERT) and in the paper space is passed over, as is every other entity.
//!
//! Source: Autodesk, "DXF Reference"; arcs by their bulge, places by the arbitrary axis algorithm.

use riprap_geom::Vec3;

use super::dxf_pairs::{Pairs, Value};
use super::{FileError, Place};

/// Most points that the lines of a drawing may have, arcs in pieces.
pub const MAX_POINTS: usize = 4_000_000;
/// Distance of an arc from its pieces where none is given, times its radius.
pub const SAGITTA: f64 = 0.01;
/// Most pieces of one arc.
const MOST_PIECES: f64 = 1000.0;
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
}

/// What is read of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Length of a unit of the drawing, m, if it says so (`$INSUNITS`).
    pub unit: Option<f64>,
    /// Lines in their order.
    pub lines: Vec<Polyline>,
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
    let mut room = MAX_POINTS;
    loop {
        let Some((code, value)) = pairs.next()? else {
            return Err(pairs.cut_off());
        };
        if code != 0 {
            if code == 999 {
                continue;
            }
            return Err(pairs.wrong("a section should begin here: this is no DXF drawing"));
        }
        match value.text().as_ref() {
            "EOF" => return Ok(drawing),
            "SECTION" => {}
            _ => return Err(pairs.wrong("a section should begin here: this is no DXF drawing")),
        }
        let name = match pairs.next()? {
            Some((2, name)) => name.text().into_owned(),
            Some(_) => return Err(pairs.wrong("a section has no name")),
            None => return Err(pairs.cut_off()),
        };
        match name.as_str() {
            "HEADER" => header(&mut pairs, &mut drawing)?,
            "ENTITIES" => entities(&mut pairs, &mut drawing, sagitta, &mut room)?,
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
    Other,
}

/// A point of a line: x, y, z and the bulge of the piece behind it.
type Point = [f64; 4];

/// An entity that is being read.
struct Entity {
    kind: Kind,
    layer: String,
    flags: i64,
    paper: bool,
    points: Vec<Point>,
    normal: Vec3,
    elevation: f64,
    place: Place,
}

impl Entity {
    fn new(name: &str, place: Place) -> Self {
        let kind = match name {
            "LINE" => Kind::Line,
            "LWPOLYLINE" => Kind::LwPolyline,
            "POLYLINE" => Kind::Polyline,
            "VERTEX" => Kind::Vertex,
            _ => Kind::Other,
        };
        Self {
            kind,
            layer: "0".to_owned(),
            flags: 0,
            paper: false,
            points: Vec::new(),
            normal: Vec3::Z,
            elevation: 0.0,
            place,
        }
    }

    /// Takes one pair.
    fn take(&mut self, pairs: &Pairs, code: i32, value: Value) -> Result<(), FileError> {
        if self.kind == Kind::Other {
            return Ok(());
        }
        let axis = (code / 10 - 1) as usize;
        match (code, self.kind) {
            (8, _) => self.layer = pairs.name(value),
            (67, _) => self.paper = pairs.whole(value)? != 0,
            (70, _) => self.flags = pairs.whole(value)?,
            (38, _) => self.elevation = pairs.real(value)?,
            (210 | 220 | 230, _) => {
                self.normal[(code / 10 - 21) as usize] = pairs.real(value)?;
            }
            (10, _) => self.points.push([pairs.real(value)?, 0.0, 0.0, 0.0]),
            (11, Kind::Line) => self.points.push([pairs.real(value)?, 0.0, 0.0, 0.0]),
            (20 | 30, _) | (21 | 31, Kind::Line) => {
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
            _ => {}
        }
        Ok(())
    }

    /// Whether it is a line of the kind that is drawn: no mesh.
    fn is_line(&self) -> bool {
        match self.kind {
            Kind::Line | Kind::LwPolyline => true,
            // 16: a mesh of polygons, 64: faces.
            Kind::Polyline => self.flags & (16 | 64) == 0,
            Kind::Vertex | Kind::Other => false,
        }
    }
}

fn entities(
    pairs: &mut Pairs,
    drawing: &mut Drawing,
    sagitta: Option<f64>,
    room: &mut usize,
) -> Result<(), FileError> {
    let mut current = Entity::new("", pairs.place());
    // A POLYLINE whose points are being read.
    let mut open: Option<Entity> = None;
    loop {
        let pair = section_goes_on(pairs)?;
        let Some((code, value)) = pair else {
            finish(pairs, drawing, current, &mut open, sagitta, room)?;
            return close(pairs, drawing, open, sagitta, room);
        };
        if code != 0 {
            current.take(pairs, code, value)?;
            continue;
        }
        let next = Entity::new(&value.text(), pairs.place());
        // Whatever follows the points ends a POLYLINE, its SEQEND or not.
        let ended = next.kind != Kind::Vertex;
        let last = std::mem::replace(&mut current, next);
        finish(pairs, drawing, last, &mut open, sagitta, room)?;
        if ended {
            close(pairs, drawing, open.take(), sagitta, room)?;
        }
    }
}

/// Puts an entity where it belongs.
fn finish(
    pairs: &Pairs,
    drawing: &mut Drawing,
    entity: Entity,
    open: &mut Option<Entity>,
    sagitta: Option<f64>,
    room: &mut usize,
) -> Result<(), FileError> {
    match entity.kind {
        Kind::Line | Kind::LwPolyline => close(pairs, drawing, Some(entity), sagitta, room),
        Kind::Polyline => {
            let mut entity = entity;
            // The point of a POLYLINE is its elevation.
            let own = entity.points.drain(..).next();
            entity.elevation = own.map_or(0.0, |p| p[2]);
            *open = Some(entity);
            Ok(())
        }
        Kind::Vertex => {
            // 16: a point of the frame of a spline, not of the curve.
            if let Some(line) = open.as_mut().filter(|_| entity.flags & 16 == 0) {
                line.points.extend(entity.points.first());
            }
            Ok(())
        }
        Kind::Other => Ok(()),
    }
}

/// Adds a line to the drawing.
fn close(
    pairs: &Pairs,
    drawing: &mut Drawing,
    entity: Option<Entity>,
    sagitta: Option<f64>,
    room: &mut usize,
) -> Result<(), FileError> {
    let Some(entity) = entity.filter(|e| e.is_line() && !e.paper && e.points.len() > 1) else {
        return Ok(());
    };
    let in_space = match entity.kind {
        Kind::Line => true,
        Kind::Polyline => entity.flags & 8 != 0,
        Kind::LwPolyline | Kind::Vertex | Kind::Other => false,
    };
    let flagged = entity.kind != Kind::Line && entity.flags & 1 != 0;
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(entity.points.len());
    let count = entity.points.len();
    for (k, &[x, y, _, bulge]) in entity.points.iter().enumerate() {
        points.push([x, y]);
        // A bulge lies in the plane of its polyline; a line in space has none.
        if (k + 1 < count || flagged) && bulge != 0.0 && !in_space {
            let [to_x, to_y, ..] = entity.points[(k + 1) % count];
            arc([x, y], [to_x, to_y], bulge, sagitta, &mut points);
        }
        if points.len() > *room {
            return Err(pairs.wrong(format!(
                "the lines of the drawing have more than {MAX_POINTS} points, arcs in pieces: use a larger sagitta"
            )));
        }
    }
    *room -= points.len();
    if !in_space && entity.normal != Vec3::Z {
        let [a, b, n] = axes(entity.normal)
            .ok_or_else(|| pairs.wrong("a polyline has an extrusion without direction"))?;
        for p in &mut points {
            let place = p[0] * a + p[1] * b + entity.elevation * n;
            *p = [place.x, place.y];
        }
    }
    let size = extent(&points);
    let ends = points.first().zip(points.last());
    // Drawn back to its start, a line is closed without the flag.
    let joined = ends.is_some_and(|(a, b)| (0..2).all(|k| (a[k] - b[k]).abs() <= CLOSED * size));
    if joined {
        points.pop();
    }
    let closed = (flagged || joined) && points.len() > 2;
    if points.len() > 1 {
        drawing.lines.push(Polyline {
            layer: entity.layer,
            closed,
            points,
            place: entity.place,
        });
    }
    Ok(())
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

/// Points of an arc between its ends. The bulge is the tangent of a quarter of its angle, positive anticlockwise.
fn arc(from: [f64; 2], to: [f64; 2], bulge: f64, sagitta: Option<f64>, out: &mut Vec<[f64; 2]>) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    // With t = tan(angle/4): sin(angle/2) = 2 t/(1 + t^2), cos(angle/2) = (1 - t^2)/(1 + t^2).
    let radius = libm::hypot(dx, dy) * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    let angle = 4.0 * libm::atan(bulge);
    let share = sagitta.map_or(SAGITTA, |s| s / radius);
    // At most half a circle: a sagitta above the radius would have no angle.
    let piece = 2.0 * libm::acos(1.0 - share.clamp(0.0, 1.0));
    let pieces = (angle.abs() / piece).ceil();
    let to_centre = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = [
        0.5 * (from[0] + to[0]) - to_centre * dy,
        0.5 * (from[1] + to[1]) + to_centre * dx,
    ];
    // A bulge of next to nothing has its centre at infinity: the arc is the straight piece.
    if !(radius.is_finite() && centre.iter().all(|x| x.is_finite())) {
        return;
    }
    let pieces = pieces.clamp(1.0, MOST_PIECES) as u32;
    let arm = [from[0] - centre[0], from[1] - centre[1]];
    for k in 1..pieces {
        let turn = angle * f64::from(k) / f64::from(pieces);
        let (sin, cos) = (libm::sin(turn), libm::cos(turn));
        out.push([
            centre[0] + cos * arm[0] - sin * arm[1],
            centre[1] + sin * arm[0] + cos * arm[1],
        ]);
    }
}
