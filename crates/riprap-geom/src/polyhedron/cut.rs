//! Dividing a convex solid by planes into parts that fit together.
//!
//! The level set `phi = n . x - d` of each vertex has three states: below, on, above. A vertex within the snap length of
//! the plane is on it and is not moved, so no edge gets shorter than about that length; the face of the cut may
//! then be crooked by as much, but both parts have the same one and a solid with flat faces keeps its volume to
//! round-off. (Parts with crooked faces that are cut again lose or gain up to half a percent with the default snap:
//! divide the mass of the parent in the ratio of the volumes.) Faces are divided by these states alone, points on edges are found once per edge (from the lower vertex number), and the face of the
//! cut is the chain of the edges that are left open: no angles are compared, no point is made twice.
//!
//! Every part is checked: each edge has its twin, `V - E + F = 2`, convex within the snap length, all tetrahedra
//! of positive volume.
//!
//! Source: Han, Liu & Li (2010), equations (18) to (20). Deviation: their two states fail where the plane meets a
//! vertex, an edge or a face.

use super::{FLAT, FlatTetrahedron, Polyhedron, Tetrahedra, edges_of};
use crate::Vec3;

/// Planes of [`Planes::Anchored`] nearer than this, times their spacing, to the ends of the solid are dropped.
pub const NEAR_END: f64 = 0.12;
/// Least snap length, times the size of the solid and its distance from the origin: round-off of heights.
pub const ROUND_OFF: f64 = 1.5e-14;
/// Most planes of one cut.
pub const MAX_PLANES: u32 = 7;

/// Parallel planes that divide a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Planes {
    /// `count` planes at equal distances between the ends of the solid.
    Spaced {
        /// How many, 1 to 7.
        count: u32,
    },
    /// A plane through a point and `count - 1` others beside it, alternating above and below, at the distance that
    /// `Spaced` would have.
    Anchored {
        /// How many, 1 to 7.
        count: u32,
        /// The point, m.
        at: Vec3,
    },
}

/// What is too small to be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Vertices nearer than this, times the spacing of the planes, to a plane are on it.
    pub snap: f64,
    /// A plane that would leave a part with less than this share of the volume is not cut.
    pub sliver: f64,
}

impl Default for Limits {
    /// Snap 0.03: the smallest stable step of random cuts of a cube is then 1/80 of the cube's, not 1/25,000.
    fn default() -> Self {
        Self { snap: 0.03, sliver: 1e-3 }
    }
}

/// Where a face of a part comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaceOrigin {
    /// It is (part of) this face of the parent.
    Parent(u32),
    /// It was made by this plane, numbered as in [`Parts::offsets`].
    Plane(u32),
}

/// A part of a solid.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its shape.
    pub solid: Polyhedron,
    /// Where each face comes from.
    pub origins: Vec<FaceOrigin>,
    /// Its nodes and tetrahedra.
    pub mesh: Tetrahedra,
}

/// What planes have made of a solid.
#[derive(Clone, Debug, PartialEq)]
pub struct Parts {
    /// The parts, in the direction of the normal; part k and k + 1 meet at plane k. One part: nothing was cut.
    pub parts: Vec<Part>,
    /// Offsets `n . x` of the planes that were cut, ascending, m.
    pub offsets: Vec<f64>,
    /// Offsets of those that were not, m, and why.
    pub refused: Vec<(f64, Refusal)>,
}

/// Why a plane is not cut.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// All of the solid is on one side.
    #[error("the plane does not meet the solid")]
    Beside,
    /// A part would be too small.
    #[error("it would leave a part of {volume:e} m3")]
    Sliver {
        /// Its volume, m³.
        volume: f64,
    },
    /// A part would be thinner than the snap length: its surface does not close.
    #[error("it would leave a part with an open surface")]
    Open,
    /// As [`Refusal::Open`]: a tetrahedron of a part would have no volume.
    #[error("it would leave a part that is too thin: {0}")]
    Flat(FlatTetrahedron),
    /// A part would not be convex.
    #[error("it would leave a part that is not convex: {distance:e} m beyond its face {face}")]
    NotConvex {
        /// Face of the part.
        face: usize,
        /// How far something is beyond it, m.
        distance: f64,
    },
}

/// What can be wrong with a cut.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CutError {
    /// Not a direction.
    #[error("the normal of the cut ({}, {}, {}) has zero length", .normal.x, .normal.y, .normal.z)]
    Normal {
        /// Normal given.
        normal: Vec3,
    },
    /// Too few or too many planes.
    #[error("a cut has {count} planes; it must be 1 to {MAX_PLANES}")]
    Count {
        /// Number given.
        count: u32,
    },
    /// The solid to be cut is not sound.
    #[error("the solid to be cut is invalid: {0}")]
    Solid(FlatTetrahedron),
    /// The solid to be cut, of which no plane was cut, is not sound.
    #[error("the solid to be cut is invalid: {0}")]
    Rest(Refusal),
}

/// Divides a convex solid by parallel planes with the normal `normal` (any length).
///
/// # Errors
/// A normal without direction, a number of planes out of range, a solid without volume.
pub fn cut(
    solid: &Polyhedron,
    normal: Vec3,
    planes: Planes,
    limits: &Limits,
) -> Result<Parts, CutError> {
    let n = normal.normalize_or_zero();
    if n == Vec3::ZERO {
        return Err(CutError::Normal { normal });
    }
    let heights = || solid.vertices.iter().map(|v| n.dot(*v));
    let low = heights().fold(f64::INFINITY, f64::min);
    let high = heights().fold(f64::NEG_INFINITY, f64::max);
    let (offsets, spacing) = offsets(planes, n, low, high)?;
    let snap = (limits.snap * spacing).max(least_snap(solid));
    let whole = Shape {
        solid: solid.clone(),
        origins: (0..solid.faces.len() as u32).map(FaceOrigin::Parent).collect(),
    };
    let volume = Tetrahedra::new(solid).map_err(CutError::Solid)?.volume();
    let job = Job { n, snap, tolerance: tolerance(solid, snap), smallest: limits.sliver * volume };
    // What is left above a plane is nearly always sound: it is looked at when all planes are done, and only if it
    // is not, once more after each.
    let parts = match job.all(&whole, volume, &offsets, false) {
        Ok(parts) => Ok(parts),
        Err(_) => job.all(&whole, volume, &offsets, true),
    };
    parts.map_err(CutError::Rest)
}

/// What all planes of a cut share.
struct Job {
    n: Vec3,
    snap: f64,
    /// Distance beyond a face at which a part is not convex, m.
    tolerance: f64,
    smallest: f64,
}

impl Job {
    /// Cuts plane after plane; `Err` when the part above the last one is not sound.
    fn all(
        &self,
        whole: &Shape,
        volume: f64,
        offsets: &[f64],
        careful: bool,
    ) -> Result<Parts, Refusal> {
        let mut made = Parts {
            parts: Vec::with_capacity(offsets.len() + 1),
            offsets: Vec::with_capacity(offsets.len()),
            refused: Vec::new(),
        };
        let (mut rest, mut left) = (whole.clone(), volume);
        for &offset in offsets {
            match self.one(&rest, left, offset, made.offsets.len() as u32, careful) {
                Ok((below, above)) => {
                    left -= below.mesh.volume();
                    made.parts.push(below);
                    made.offsets.push(offset);
                    rest = above;
                }
                Err(why) => made.refused.push((offset, why)),
            }
        }
        made.parts.push(rest.finish(self.tolerance)?);
        Ok(made)
    }

    /// The part below a plane and what is left of the volume `left` above it.
    fn one(
        &self,
        rest: &Shape,
        left: f64,
        offset: f64,
        plane: u32,
        careful: bool,
    ) -> Result<(Part, Shape), Refusal> {
        let [below, above] = halve_shape(rest, self.n, offset, self.snap, plane)?;
        let below = below.finish(self.tolerance)?;
        if careful {
            above.clone().finish(self.tolerance)?;
        }
        let volume = below.mesh.volume();
        let volume = volume.min(left - volume);
        if volume < self.smallest {
            return Err(Refusal::Sliver { volume });
        }
        Ok((below, above))
    }
}

/// Least snap length of a solid, m: vertices nearer than this to a plane cannot be told from ones on it.
#[must_use]
pub fn least_snap(solid: &Polyhedron) -> f64 {
    let (low, high) = solid.bounds();
    ROUND_OFF * (solid.size() + low.abs().max(high.abs()).max_element())
}

/// Offsets of planes, ascending, and their spacing.
fn offsets(planes: Planes, n: Vec3, low: f64, high: f64) -> Result<(Vec<f64>, f64), CutError> {
    let (Planes::Spaced { count } | Planes::Anchored { count, .. }) = planes;
    if count == 0 || count > MAX_PLANES {
        return Err(CutError::Count { count });
    }
    let spacing = (high - low) / f64::from(count + 1);
    let list = match planes {
        Planes::Spaced { .. } => (1..=count).map(|k| low + f64::from(k) * spacing).collect(),
        Planes::Anchored { at, .. } => {
            let (first, near) = (n.dot(at), NEAR_END * spacing);
            // 0, +1, -1, +2, -2, ... in ascending order.
            let below = f64::from((count - 1) / 2);
            (0..count)
                .map(|k| first + (f64::from(k) - below) * spacing)
                .filter(|d| *d >= low + near && *d <= high - near)
                .collect()
        }
    };
    Ok((list, spacing))
}

/// The parts of a solid below and above the plane `n . x = offset` (unit normal), whose faces get the number `plane`.
///
/// # Errors
/// A part would be empty or not sound.
pub fn halve(
    part: &Part,
    n: Vec3,
    offset: f64,
    snap: f64,
    plane: u32,
) -> Result<[Part; 2], Refusal> {
    let shape = Shape { solid: part.solid.clone(), origins: part.origins.clone() };
    let [below, above] = halve_shape(&shape, n, offset, snap, plane)?;
    let tolerance = tolerance(&part.solid, snap);
    Ok([below.finish(tolerance)?, above.finish(tolerance)?])
}

/// A closed surface with the topology of a ball, not yet known to be convex.
#[derive(Clone)]
struct Shape {
    solid: Polyhedron,
    origins: Vec<FaceOrigin>,
}

fn halve_shape(
    shape: &Shape,
    n: Vec3,
    offset: f64,
    snap: f64,
    plane: u32,
) -> Result<[Shape; 2], Refusal> {
    let solid = &shape.solid;
    let signs: Vec<f64> = solid
        .vertices
        .iter()
        .map(|v| {
            let phi = n.dot(*v) - offset;
            if phi.abs() <= snap { 0.0 } else { phi }
        })
        .collect();
    if signs.iter().all(|s| *s <= 0.0) || signs.iter().all(|s| *s >= 0.0) {
        return Err(Refusal::Beside);
    }
    let mut points = Crossings { vertices: solid.vertices.clone(), edges: Vec::new() };
    let mut sides = [Side::default(), Side::default()];
    for (corners, origin) in solid.faces.iter().zip(&shape.origins) {
        let pieces = halve_face(corners, &signs, &mut points);
        for (side, piece) in sides.iter_mut().zip(pieces) {
            if let Some(piece) = piece {
                side.faces.push(piece);
                side.origins.push(*origin);
            }
        }
    }
    let cap = open_chain(&sides[0].faces).ok_or(Refusal::Open)?;
    // The open edges above are those of the cap turned round, or the parts do not fit.
    if open_chain(&sides[1].faces).is_none_or(|other| !turned(&cap, &other)) {
        return Err(Refusal::Open);
    }
    let mut back = cap.clone();
    back.reverse();
    let [mut below, mut above] = sides;
    below.faces.push(cap);
    above.faces.push(back);
    let finish = |mut side: Side| {
        side.origins.push(FaceOrigin::Plane(plane));
        side.finish(&points.vertices)
    };
    Ok([finish(below)?, finish(above)?])
}

/// The parts of a face below and above the plane; `None` where no corner lies there.
fn halve_face(corners: &[u32], signs: &[f64], points: &mut Crossings) -> [Option<Vec<u32>>; 2] {
    let room = corners.len() + 2;
    let (mut below, mut above) = (Vec::with_capacity(room), Vec::with_capacity(room));
    let mut strictly = [false; 2];
    for (from, to) in edges_of(corners) {
        let (s, t) = (signs[from as usize], signs[to as usize]);
        strictly[0] |= s < 0.0;
        strictly[1] |= s > 0.0;
        if s <= 0.0 {
            below.push(from);
        }
        if s >= 0.0 {
            above.push(from);
        }
        if (s < 0.0 && t > 0.0) || (s > 0.0 && t < 0.0) {
            let crossing = points.on_edge(from, to, signs);
            below.push(crossing);
            above.push(crossing);
        }
    }
    [strictly[0].then_some(below), strictly[1].then_some(above)]
}

/// Whether a ring runs through the same vertices as another, the other way.
fn turned(a: &[u32], b: &[u32]) -> bool {
    let Some(start) = b.iter().position(|k| *k == a[0]) else {
        return false;
    };
    let n = b.len();
    a.len() == n && (0..n).all(|k| a[k] == b[(start + n - k) % n])
}

/// Vertices of a solid and the points where its edges meet the plane.
struct Crossings {
    vertices: Vec<Vec3>,
    edges: Vec<((u32, u32), u32)>,
}

impl Crossings {
    /// Number of the point on an edge, the same from both of its faces.
    fn on_edge(&mut self, from: u32, to: u32, signs: &[f64]) -> u32 {
        let edge = (from.min(to), from.max(to));
        if let Some((_, known)) = self.edges.iter().find(|(e, _)| *e == edge) {
            return *known;
        }
        let (a, b) = (edge.0 as usize, edge.1 as usize);
        let (p, q, s, t) = (self.vertices[a], self.vertices[b], signs[a], signs[b]);
        let number = self.vertices.len() as u32;
        self.vertices.push(p + (s / (s - t)) * (q - p));
        self.edges.push((edge, number));
        number
    }
}

/// Faces on one side of the plane.
#[derive(Default)]
struct Side {
    faces: Vec<Vec<u32>>,
    origins: Vec<FaceOrigin>,
}

impl Side {
    fn finish(mut self, points: &[Vec3]) -> Result<Shape, Refusal> {
        const UNUSED: u32 = u32::MAX;
        let mut number = vec![UNUSED; points.len()];
        for &corner in self.faces.iter().flatten() {
            number[corner as usize] = 0;
        }
        let mut vertices = Vec::with_capacity(points.len());
        for (slot, point) in number.iter_mut().zip(points) {
            if *slot != UNUSED {
                *slot = vertices.len() as u32;
                vertices.push(*point);
            }
        }
        for corner in self.faces.iter_mut().flatten() {
            *corner = number[*corner as usize];
        }
        let solid = Polyhedron { vertices, faces: self.faces };
        let edges: usize = solid.faces.iter().map(Vec::len).sum();
        if 2 * (solid.vertices.len() + solid.faces.len()) != edges + 4 {
            return Err(Refusal::Open);
        }
        Ok(Shape { solid, origins: self.origins })
    }
}

impl Shape {
    /// The part, if all its tetrahedra have a volume and it is convex within `tolerance`.
    fn finish(self, tolerance: f64) -> Result<Part, Refusal> {
        let mesh = Tetrahedra::new(&self.solid).map_err(Refusal::Flat)?;
        let (distance, face) = beyond(&self.solid);
        if distance > tolerance {
            return Err(Refusal::NotConvex { face, distance });
        }
        Ok(Part { solid: self.solid, origins: self.origins, mesh })
    }
}

/// Distance beyond a face at which a part of a solid is not convex, m: what snapping and the solid itself bring about.
fn tolerance(solid: &Polyhedron, snap: f64) -> f64 {
    2.0 * (snap + beyond(solid).0) + FLAT * solid.size()
}

/// Largest distance (m) of a vertex beyond a face, and the face.
fn beyond(solid: &Polyhedron) -> (f64, usize) {
    let mut worst = (0.0, 0);
    for face in 0..solid.faces.len() {
        let (normal, offset) = solid.plane(face);
        for v in &solid.vertices {
            let distance = normal.dot(*v) - offset;
            if distance > worst.0 {
                worst = (distance, face);
            }
        }
    }
    worst
}

/// Directed edges, sorted; empty when one occurs twice.
fn directed_edges(faces: &[Vec<u32>]) -> Vec<(u32, u32)> {
    let mut edges = Vec::with_capacity(faces.iter().map(Vec::len).sum());
    for face in faces {
        edges.extend(edges_of(face));
    }
    edges.sort_unstable();
    if edges.windows(2).any(|pair| pair[0] == pair[1]) {
        edges.clear();
    }
    edges
}

/// The face that closes the open edges of a surface, if they make one ring.
fn open_chain(faces: &[Vec<u32>]) -> Option<Vec<u32>> {
    let edges = directed_edges(faces);
    // The ring runs against the open edges: (to, from), sorted by its start.
    let mut next: Vec<(u32, u32)> = edges
        .iter()
        .map(|&(from, to)| (to, from))
        .filter(|back| edges.binary_search(back).is_err())
        .collect();
    next.sort_unstable();
    if next.len() < 3 || next.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return None;
    }
    let start = next[0].0;
    let mut ring = Vec::with_capacity(next.len());
    let mut at = start;
    loop {
        ring.push(at);
        let found = next.binary_search_by_key(&at, |(from, _)| *from).ok()?;
        at = next[found].1;
        if at == start {
            break;
        }
        if ring.len() >= next.len() {
            return None;
        }
    }
    (ring.len() == next.len()).then_some(ring)
}

#[cfg(test)]
mod tests;
