//! A convex block as the contact law sees it: planes, vertices and face outlines in the frame of the body.

use std::collections::BTreeMap;

use riprap_geom::polyhedron::{FLAT, Polyhedron};
use riprap_geom::{Mat3, Quat, Vec3};
use serde::{Deserialize, Serialize};

use crate::kernel::peak::{Peak, peak};
use crate::kernel::planes::Planes;

/// Faces whose normals differ by more (cosine) are never taken for one, however small they are.
const SAME_SIDE: f64 = 0.9;

/// Where the frame of a body stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Its origin, the centroid of the block, m.
    pub position: Vec3,
    /// Turns the frame of the body into that of space.
    pub rotation: Quat,
}

impl Pose {
    /// A pose that is not turned.
    #[must_use]
    pub fn at(position: Vec3) -> Self {
        Self { position, rotation: Quat::IDENTITY }
    }

    /// A point of the body in space, m.
    #[must_use]
    pub fn place(&self, body: Vec3) -> Vec3 {
        self.position + self.rotation * body
    }
}

/// Why a solid cannot take part in found contact.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// The origin of the body must lie inside it.
    #[error("the centroid lies {distance:.3e} m outside face {face} of the block")]
    CentreOutside {
        /// Face of the solid, counted from 0.
        face: usize,
        /// Distance, m.
        distance: f64,
    },
    /// No ball fits into it.
    #[error("the block has no inscribed sphere")]
    NoRoom,
}

/// A convex solid in the frame of its body, about its centroid. Faces in one plane count as one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Unit outward normal of each face.
    pub normals: Vec<Vec3>,
    /// Distance of each face from the centroid, m: inside is `normals[k] . x <= offsets[k]`.
    pub offsets: Vec<f64>,
    /// Area of each face, m².
    pub areas: Vec<f64>,
    /// Corners, m.
    pub vertices: Vec<Vec3>,
    /// Largest distance of a corner from the centroid, m.
    pub radius: f64,
    /// Radius of the largest ball inside, m.
    pub inradius: f64,
    /// Corners of face `k`: `corners[first[k]..first[k + 1]]`.
    corners: Vec<u16>,
    first: Vec<u32>,
}

impl Shape {
    /// The shape of a solid about `centre`; both in a frame parallel to that of the body.
    ///
    /// # Errors
    /// The centre is outside, or there is no room inside.
    pub fn new(solid: &Polyhedron, centre: Vec3) -> Result<Self, ShapeError> {
        let vertices: Vec<Vec3> = solid.vertices.iter().map(|v| *v - centre).collect();
        let mut shape = Self {
            radius: vertices.iter().map(|v| v.length()).fold(0.0, f64::max),
            vertices,
            normals: Vec::new(),
            offsets: Vec::new(),
            areas: Vec::new(),
            inradius: 0.0,
            corners: Vec::new(),
            first: vec![0],
        };
        for group in groups(solid) {
            let sum: Vec3 = group.iter().map(|&f| solid.area_vector(f)).sum();
            let normal = sum.normalize_or_zero();
            let outline = outline(solid, &group);
            let height = |v: &u16| normal.dot(shape.vertices[*v as usize]);
            // Faces are flat only within a tolerance: the mean leaves no corner farther out than needed.
            let offset = outline.iter().map(height).sum::<f64>() / outline.len() as f64;
            if offset <= 0.0 {
                return Err(ShapeError::CentreOutside { face: group[0], distance: -offset });
            }
            shape.normals.push(normal);
            shape.offsets.push(offset);
            shape.areas.push(sum.length());
            shape.corners.extend(outline);
            shape.first.push(shape.corners.len() as u32);
        }
        shape.inradius = shape.largest_ball()?;
        // Kept for the whole run: what lists have grown beyond their length is given back.
        shape.normals.shrink_to_fit();
        shape.offsets.shrink_to_fit();
        shape.areas.shrink_to_fit();
        shape.corners.shrink_to_fit();
        shape.first.shrink_to_fit();
        Ok(shape)
    }

    /// Way that counts for the energy of an edge or a corner of it in a face, over the diameter of the largest ball in what both have in common: of the
    /// sharpest one, at least 1. An edge of the half angle b goes in by `(1 + 1/sin b)/2` of that ball, a corner likewise, but stores half as much.
    #[must_use]
    pub fn sharpness(&self) -> f64 {
        let way = |sine: f64| 0.5 * (1.0 + 1.0 / sine.max(1e-3));
        let mut sharpest = 1.0_f64;
        for f in 0..self.faces() {
            for g in 0..f {
                let shared = self.outline(f).iter().filter(|v| self.outline(g).contains(v));
                if shared.count() >= 2 {
                    let sine = 0.5 * (self.normals[f] + self.normals[g]).length();
                    sharpest = sharpest.max(way(sine));
                }
            }
        }
        for vertex in 0..self.vertices.len() as u16 {
            let around = || (0..self.faces()).filter(|f| self.outline(*f).contains(&vertex));
            let inward = -around().map(|f| self.normals[f]).sum::<Vec3>().normalize_or_zero();
            let sine = around().map(|f| -inward.dot(self.normals[f])).fold(1.0, f64::min);
            sharpest = sharpest.max(0.5 * way(sine));
        }
        sharpest
    }

    /// Memory that it takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<Self>()
            + size_of::<Vec3>() * (self.normals.capacity() + self.vertices.capacity())
            + size_of::<f64>() * (self.offsets.capacity() + self.areas.capacity())
            + size_of::<u16>() * self.corners.capacity()
            + size_of::<u32>() * self.first.capacity()
    }

    /// A box with faces normal to the axes; half its edge lengths, m.
    ///
    /// # Errors
    /// A length that is not positive.
    pub fn brick(half: Vec3) -> Result<Self, ShapeError> {
        Self::new(&Polyhedron::brick(Vec3::ZERO, half), Vec3::ZERO)
    }

    /// Number of faces.
    #[must_use]
    pub fn faces(&self) -> usize {
        self.normals.len()
    }

    /// Numbers of the corners of a face, in order about it.
    #[must_use]
    pub fn outline(&self, face: usize) -> &[u16] {
        &self.corners[self.first[face] as usize..self.first[face + 1] as usize]
    }

    fn largest_ball(&self) -> Result<f64, ShapeError> {
        let body = Body {
            shape: self,
            normals: &self.normals,
            turn: Mat3::IDENTITY,
            position: Vec3::ZERO,
        };
        let mut planes = Planes::default();
        planes.begin();
        for face in 0..self.faces() {
            planes.push(&body, face as u16, Vec3::ZERO);
        }
        planes.split = self.faces();
        // Four times the sum of two radii, as for a pair.
        match peak(&planes, 8.0 * self.radius) {
            Peak::Overlap { depth, .. } => Ok(depth),
            Peak::Apart { .. } | Peak::Unsure => Err(ShapeError::NoRoom),
        }
    }
}

/// A block at its present place, as the kernel sees it.
#[derive(Clone, Copy, Debug)]
pub struct Body<'a> {
    /// Its shape.
    pub shape: &'a Shape,
    /// Normals of all faces, turned into space.
    pub normals: &'a [Vec3],
    /// Turns the frame of the body into that of space.
    pub turn: Mat3,
    /// Its centroid, m.
    pub position: Vec3,
}

/// Appends the normals of a shape, turned into space; returns the rotation as a matrix.
pub fn turn(shape: &Shape, rotation: Quat, normals: &mut Vec<Vec3>) -> Mat3 {
    let turn = Mat3::from_quat(rotation);
    normals.extend(shape.normals.iter().map(|n| turn * *n));
    turn
}

/// Faces of the solid in sets that lie in one plane, in the order of the first face of each.
///
/// A face joins the largest face near it when all its corners lie in that one's plane within [`FLAT`] of the size of the
/// solid, and only over shared edges.
fn groups(solid: &Polyhedron) -> Vec<Vec<usize>> {
    let count = solid.faces.len();
    let tolerance = FLAT * solid.size();
    let mut owner: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    for (face, corners) in solid.faces.iter().enumerate() {
        for (k, &from) in corners.iter().enumerate() {
            owner.insert((from, corners[(k + 1) % corners.len()]), face);
        }
    }
    let area: Vec<f64> = (0..count).map(|f| solid.area_vector(f).length()).collect();
    let mut seeds: Vec<usize> = (0..count).collect();
    // The largest first, so that slivers join it and not the other way;
    // equal ones by number, for one order on all machines.
    seeds.sort_by(|&a, &b| area[b].total_cmp(&area[a]).then(a.cmp(&b)));
    let mut taken = vec![false; count];
    let mut groups = Vec::new();
    for seed in seeds {
        if taken[seed] {
            continue;
        }
        taken[seed] = true;
        let (normal, offset) = solid.plane(seed);
        let flat = |f: usize| {
            solid.plane(f).0.dot(normal) > SAME_SIDE
                && solid.faces[f]
                    .iter()
                    .all(|&v| (normal.dot(solid.vertices[v as usize]) - offset).abs() <= tolerance)
        };
        let mut group = vec![seed];
        let mut next = 0;
        while next < group.len() {
            let corners = &solid.faces[group[next]];
            next += 1;
            for (k, &from) in corners.iter().enumerate() {
                let twin = owner.get(&(corners[(k + 1) % corners.len()], from));
                if let Some(&other) = twin
                    && !taken[other]
                    && flat(other)
                {
                    taken[other] = true;
                    group.push(other);
                }
            }
        }
        group.sort_unstable();
        groups.push(group);
    }
    groups.sort_by_key(|group| group[0]);
    groups
}

/// Corners about the faces of one plane: their edges without those that two of them share, chained.
fn outline(solid: &Polyhedron, group: &[usize]) -> Vec<u16> {
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    let mut edges: Vec<(u32, u32)> = Vec::new();
    for &face in group {
        let corners = &solid.faces[face];
        for (k, &from) in corners.iter().enumerate() {
            edges.push((from, corners[(k + 1) % corners.len()]));
        }
    }
    let start = edges[0];
    edges.sort_unstable();
    for &(from, to) in &edges {
        if edges.binary_search(&(to, from)).is_err() {
            next.insert(from, to);
        }
    }
    // The order of a single face is kept, so that a brick is the same brick bit for bit.
    let first = if next.contains_key(&start.0) {
        start.0
    } else {
        next.keys().next().copied().unwrap_or(start.0)
    };
    let mut around = vec![first as u16];
    let mut at = first;
    while let Some(&to) = next.get(&at)
        && to != first
        && around.len() < next.len()
    {
        around.push(to as u16);
        at = to;
    }
    around
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_brick_has_six_faces_about_its_centre() {
        let shape = Shape::brick(Vec3::new(0.5, 1.0, 0.25)).unwrap();
        assert_eq!(shape.faces(), 6);
        assert_eq!(shape.offsets, [0.5, 0.5, 1.0, 1.0, 0.25, 0.25]);
        assert_eq!(shape.areas, [1.0, 1.0, 0.5, 0.5, 2.0, 2.0]);
        assert!((shape.inradius - 0.25).abs() < 1e-15);
        assert!((0..6).all(|f| shape.outline(f).len() == 4));
    }

    #[test]
    fn triangles_in_one_plane_become_one_face() {
        let whole = Polyhedron::brick(Vec3::ZERO, Vec3::new(0.5, 0.4, 0.3));
        let faces = whole
            .faces
            .iter()
            .flat_map(|f| [vec![f[0], f[1], f[2]], vec![f[0], f[2], f[3]]])
            .collect();
        let solid = Polyhedron::new(whole.vertices.clone(), faces).unwrap();
        let shape = Shape::new(&solid, Vec3::ZERO).unwrap();
        let plain = Shape::new(&whole, Vec3::ZERO).unwrap();
        assert_eq!(shape.normals, plain.normals);
        assert_eq!(shape.offsets, plain.offsets);
        assert!((0..6).all(|f| shape.outline(f).len() == 4));
    }

    #[test]
    fn a_centre_outside_is_refused() {
        let solid = Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5));
        let shape = Shape::new(&solid, Vec3::new(2.0, 0.0, 0.0));
        assert!(matches!(shape, Err(ShapeError::CentreOutside { .. })));
    }
}
