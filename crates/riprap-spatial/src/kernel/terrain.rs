//! A convex block on terrain: the equal-pressure law with a height field in the place of the first block.
//!
//! The cell of a triangle is the upright prism below it, and the depth in it is counted straight down: `phi = c (z_s - z)` with one
//! constant `c` for all terrain. So the depth is continuous from cell to cell, and an edge between triangles in one plane has no effect at
//! all. Piece (t, g) of triangle t and face g of the block is the plane `{phi_t = phi_g}`, cut by `phi >= 0`, by the planes of the
//! block and by the three walls of the prism. There is no far side: the deeper, the larger the depth.
//!
//! Pressed flat onto a slope with the upright component `n_z` of its normal, a block meets `2 c/(n_z + c)` times the stiffness of a
//! brick: 1 on the flat, 1.17 at 45 degrees (`c` = 1).
//!
//! **Facets.** Triangles that hang together in one plane are a facet. The surface of a block is summed up per facet, and each has springs
//! and a sliding limit of its own, since Coulomb's limit belongs to a place: in a notch both flanks resist. A
//! flat floor is one facet, however it is divided.
//!
//! **Rim.** A depth that ended at the rim would jump there: a block that comes from outside, below the surface, would find its energy made of
//! nothing. So a wall goes down from the rim all round (`HeightField::walled`), steep and continuous with the surface: a block meets the side
//! of terrain as a cliff.
//!
//! All triangles near a block are looked at, no walk is needed: the surface can have any number of parts, and no order depends on what
//! was before.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_geom::height_field::{Bins, HeightField};

use crate::kernel::frame::Frame;
use crate::kernel::piece::{Cutter, Polygon, UNTIED};
use crate::kernel::planes::Planes;
use crate::kernel::shape::Body;
use crate::kernel::sums::Sums;

mod prisms;
mod under;

pub(crate) use under::Under;

/// Depth over height below the surface.
pub(crate) const DEPTH: f64 = 1.0;
/// Triangles belong to one facet if they lie in the plane of its first one within this share of that one's longest edge.
const FLAT: f64 = 1e-9;
/// Way of a corner over that of the faces that meet there, where all go outward: none is sharper than that.
const SHARPEST: f64 = 20.0;
/// Workspace for rounding in a test that leaves faces out.
const SLACK: f64 = 1.0 + 1e-9;

/// A height field made ready for contact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Terrain {
    /// The surface.
    pub field: HeightField,
    /// Its triangles by place.
    pub bins: Bins,
    /// Lowest and highest coordinates of the surface, m.
    pub bounds: (Vec3, Vec3),
    /// Prisms by place.
    near: Bins,
    /// Prisms below the surface, and then below the wall round it.
    cells: Vec<Cell>,
    facets: u32,
}

/// The prism below a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cell {
    corners: [Vec3; 3],
    /// `phi = slope . (corner - x)`: the normal with an upright component of `c`.
    slope: Vec3,
    /// Its length.
    steepness: f64,
    facet: u32,
}

impl Terrain {
    /// Prepares a surface.
    #[must_use]
    pub fn new(field: HeightField) -> Self {
        let walled = field.walled();
        let facet = facets(&walled);
        let cells = (0..walled.triangles.len())
            .map(|t| {
                let corners = walled.corners(t);
                let [a, b, c] = corners;
                let normal = (b - a).cross(c - a);
                let slope = normal * (DEPTH / normal.z);
                Cell { corners, slope, steepness: slope.length(), facet: facet[t] }
            })
            .collect();
        Self {
            bins: Bins::new(&field),
            near: Bins::new(&walled),
            bounds: field.bounds(),
            cells,
            facets: facet[..field.triangles.len()].iter().max().map_or(0, |last| last + 1),
            field,
        }
    }

    /// Number of facets of the surface; those of the wall round it have higher numbers.
    #[must_use]
    pub fn facets(&self) -> u32 {
        self.facets
    }

    /// How far a place lies below the surface, m; negative above, `None` beside it.
    #[must_use]
    pub fn depth(&self, at: Vec3) -> Option<f64> {
        self.field.height(&self.bins, at.x, at.y).map(|height| height - at.z)
    }
}

/// Facet of each triangle, numbered by their first triangles.
fn facets(field: &HeightField) -> Vec<u32> {
    let mut owner: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for (t, [a, b, c]) in (0..).zip(&field.triangles) {
        for edge in [(*a, *b), (*b, *c), (*c, *a)] {
            owner.insert(edge, t);
        }
    }
    let mut facet = vec![u32::MAX; field.triangles.len()];
    let mut count = 0;
    let mut group = Vec::new();
    for seed in 0..facet.len() {
        if facet[seed] != u32::MAX {
            continue;
        }
        let [a, b, c] = field.corners(seed);
        let normal = (b - a).cross(c - a).normalize();
        let longest = [b - a, c - b, a - c].map(Vec3::length);
        let slack = FLAT * longest.into_iter().fold(0.0, f64::max);
        facet[seed] = count;
        group.clear();
        group.push(seed);
        while let Some(t) = group.pop() {
            let [a, b, c] = field.triangles[t];
            for edge in [(b, a), (c, b), (a, c)] {
                let Some(&other) = owner.get(&edge) else {
                    continue;
                };
                let other = other as usize;
                let flat = |p: &Vec3| normal.dot(*p - field.corners(seed)[0]).abs() <= slack;
                if facet[other] == u32::MAX && field.corners(other).iter().all(flat) {
                    facet[other] = count;
                    group.push(other);
                }
            }
        }
        count += 1;
    }
    facet
}

/// What was found of a block on terrain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reached {
    /// It does not touch; at least so far away, m.
    Apart(f64),
    /// It touches: see [`Treader::facets`].
    Touching,
    /// It lies below the surface as a whole: no force can be given. How deep its centroid is, m.
    FullyPenetrated(f64),
}

/// The surface on one facet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OnFacet {
    /// Number of the facet.
    pub facet: u32,
    /// Number of the piece of a block of glued parts; 0 for a convex block.
    pub piece: u16,
    /// Sums about the centroid of the block, from the terrain to the block.
    pub sums: Sums,
    /// Integral of the depth of all terms whose sum with signs this is, m³; 0 for a convex block.
    pub all: f64,
    /// Depth below its plane at a place x from the centroid of the block is `offset - slope . x`, m.
    pub slope: Vec3,
    /// The same.
    pub offset: f64,
}

impl OnFacet {
    /// How far `at` (m from the centroid of the block) lies below the plane, m.
    #[must_use]
    pub fn depth(&self, at: Vec3) -> f64 {
        self.offset - self.slope.dot(at)
    }
}

/// A piece that was found.
#[derive(Clone, Debug, Default)]
struct Kept {
    facet: u32,
    face: u16,
    weight: f64,
    polygon: Polygon,
    frame: Frame,
}

/// Workspace for evaluating blocks one after the other; kept, so that a block takes no memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct Treader {
    /// What the block evaluated last has on each facet, by number.
    pub facets: Vec<OnFacet>,
    near: Vec<u32>,
    /// The triangle, then all faces of the block.
    planes: Planes,
    /// Makes the pieces.
    pub cutter: Cutter,
    /// Workspace: a piece.
    polygon: Polygon,
    /// Corners of the block from its centroid, m.
    corners: Vec<Vec3>,
    /// How high each is above the plane of the triangle, times `c`, m.
    above: Vec<f64>,
    kept: Vec<Kept>,
    pieces: usize,
    /// How fast pressures grow beyond the depth, 1/m².
    pub growth: f64,
    /// How far the surface and all faces of the block are moved outward, m.
    inflation: f64,
}

impl Treader {
    /// As [`Treader::find`] with the surface and all faces of the block `by` (m) further out: depths are larger by as much, and a block that is near
    /// has a surface too.
    pub(crate) fn find_inflated(
        &mut self,
        terrain: &Terrain,
        body: &Body,
        reach: f64,
        by: f64,
    ) -> Reached {
        self.inflation = by;
        let found = self.find(terrain, body, reach);
        self.inflation = 0.0;
        found
    }

    /// The pieces on a facet: the face of the block, the plane and the polygon.
    pub(crate) fn pieces(&self, facet: u32) -> impl Iterator<Item = (usize, &Frame, &Polygon)> {
        let pieces = self.kept[..self.pieces].iter().filter(move |p| p.facet == facet);
        pieces.map(|p| (usize::from(p.face), &p.frame, &p.polygon))
    }

    /// Finds the surface of a block. Of what is apart, nothing farther than `reach` (m) is looked at.
    pub(crate) fn find(&mut self, terrain: &Terrain, body: &Body, reach: f64) -> Reached {
        self.facets.clear();
        self.pieces = 0;
        let (low, high) = self.place(body);
        let clear = (body.position.z + low.z) - terrain.bounds.1.z;
        if clear > reach {
            return Reached::Apart(clear);
        }
        let (from, to) = (body.position + low, body.position + high);
        terrain.near.near(
            [from.x - reach, from.y - reach],
            [to.x + reach, to.y + reach],
            &mut self.near,
        );
        self.planes.begin();
        // Room for the plane of a triangle, which is set for one after the other.
        self.planes.push_plane(Vec3::ZERO, 0.0);
        self.planes.split = 1;
        for face in 0..body.shape.faces() {
            self.planes.push(body, face as u16, body.position);
        }
        self.planes.inflate(self.inflation);
        // So far a corner goes when the faces that meet there go outward.
        let outward = SHARPEST * self.inflation;
        let mut gap = reach;
        for k in 0..self.near.len() {
            let cell = &terrain.cells[self.near[k] as usize];
            let corners = cell.corners.map(|c| c - body.position);
            let [a, b, c] = corners;
            let (min, max) = (a.min(b).min(c), a.max(b).max(c));
            // Sideways alone: prisms go down without an end.
            let beside = (min - high).max(low - max).truncate().max_element();
            let offset = cell.slope.dot(a);
            let least = self.heights(cell.slope, offset);
            // Heights are c times those straight up: over the length of the slope they are distances from the plane.
            gap = gap.min(beside.max(least / cell.steepness));
            let way = outward * (1.0 + cell.steepness);
            if beside <= way && least < way {
                self.tread(cell, &corners, offset, way - least, body);
            }
        }
        if self.pieces > 0 {
            // Which of them is met first hangs on where the block is; sums and state have one order.
            self.facets.sort_by_key(|on| on.facet);
            return Reached::Touching;
        }
        match terrain.depth(body.position) {
            Some(depth) if depth > 0.0 => Reached::FullyPenetrated(depth),
            Some(_) | None => Reached::Apart(gap.max(0.0)),
        }
    }

    /// Shows the pieces that rub on a facet: those of the face of the block that carries most there.
    pub(crate) fn rubbing(&self, facet: u32, show: &mut dyn FnMut(&Polygon, &Frame)) {
        let pieces = || self.kept[..self.pieces].iter().filter(|p| p.facet == facet);
        let weight = |face: u16| -> f64 {
            let own = pieces().filter(|p| p.face == face);
            own.map(|p| p.weight).sum()
        };
        let mut largest = (0, f64::NEG_INFINITY);
        for face in 0..self.planes.len() as u16 {
            let all = weight(face);
            if all > largest.1 {
                largest = (face, all);
            }
        }
        for piece in pieces().filter(|p| p.face == largest.0) {
            show(&piece.polygon, &piece.frame);
        }
    }

    /// Corners of the block; the box around it, from its centroid.
    fn place(&mut self, body: &Body) -> (Vec3, Vec3) {
        self.corners.clear();
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for vertex in &body.shape.vertices {
            let at = body.turn * *vertex;
            low = low.min(at);
            high = high.max(at);
            self.corners.push(at);
        }
        (low, high)
    }

    /// Heights of the corners above a plane; the least of them.
    fn heights(&mut self, slope: Vec3, offset: f64) -> f64 {
        self.above.clear();
        self.above.extend(self.corners.iter().map(|v| slope.dot(*v) - offset));
        self.above.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The pieces of a triangle with all faces of the block that can be nearest there; `deepest` is the largest depth of a corner.
    fn tread(&mut self, cell: &Cell, corners: &[Vec3; 3], offset: f64, deepest: f64, body: &Body) {
        self.planes.set(0, cell.slope, offset + self.inflation);
        // Where face g is nearest at the depth p <= deepest, its point below that place is no farther than p: it is no more than
        // that above the plane.
        let highest = deepest * cell.steepness * SLACK;
        for face in 0..body.shape.faces() {
            let outline = body.shape.outline(face);
            if outline.iter().all(|v| self.above[*v as usize] > highest) {
                continue;
            }
            self.visit(cell, corners, face, body.shape.radius);
        }
    }

    fn visit(&mut self, cell: &Cell, corners: &[Vec3; 3], face: usize, radius: f64) {
        let numbers = [0, 1 + face];
        let Some(frame) = Frame::between(&self.planes, 0, numbers[1], radius) else {
            return;
        };
        if !self.cutter.make(&self.planes, &frame, numbers, radius, UNTIED, &mut self.polygon) {
            return;
        }
        for k in 0..3 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            let outward = Vec3::new(to.y - from.y, from.x - to.x, 0.0);
            if !self.cutter.clip(&frame, outward, outward.dot(from), &mut self.polygon) {
                return;
            }
        }
        let place = self.facets.iter().position(|on| on.facet == cell.facet);
        let place = place.unwrap_or_else(|| {
            self.facets.push(OnFacet {
                facet: cell.facet,
                piece: 0,
                sums: Sums::default(),
                all: 0.0,
                slope: cell.slope,
                offset: self.planes.d[0] - self.inflation,
            });
            self.facets.len() - 1
        });
        let polygon = &self.polygon;
        let sums = &mut self.facets[place].sums;
        let mut weight = sums.add(polygon, &frame, 1.0);
        if self.growth > 0.0 {
            weight += sums.stiffen(self.growth, polygon, &frame, 1.0);
        }
        if self.kept.len() == self.pieces {
            self.kept.push(Kept::default());
        }
        let kept = &mut self.kept[self.pieces];
        self.pieces += 1;
        kept.polygon.copy(polygon);
        (kept.facet, kept.face) = (cell.facet, face as u16);
        (kept.weight, kept.frame) = (weight, frame);
    }
}

#[cfg(test)]
mod tests;
