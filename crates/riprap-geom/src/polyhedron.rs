//! Convex solids with flat faces: checking them, moments, hull of points, cutting by planes.
//!
//! Faces are listed anticlockwise seen from outside. All lengths are compared with the size of the solid (diagonal of
//! its box) times a named tolerance.

pub mod cut;
mod depth;
pub mod glued;
mod hull;
pub mod joints;
mod mass;
mod parallelepiped;
pub mod pour;
mod slice;
mod tetrahedra;
mod touch;
mod voronoi;

pub use depth::{DepthCells, DepthPoint, GluedCells};
pub use glued::GluedError;
pub use hull::hull;
pub use mass::{Moments, principal};
pub use parallelepiped::Parallelepiped;
pub use slice::{Sliced, from_half_spaces, slice};
pub use tetrahedra::{FlatTetrahedron, Tetrahedra, element};
pub use voronoi::{
    Charge, Finest, Grading, cells_around, cells_within, graded_cells, lattice_sites, random_sites,
    regular_prism, voronoi,
};

use std::collections::BTreeMap;

use crate::{Vec2, Vec3};

/// A vertex farther than this, times the size, from the plane of its face makes the face crooked, and one farther
/// than this beyond a face makes the solid not convex. Coordinates given with six digits pass.
pub const FLAT: f64 = 1e-6;
/// Corners of the faces of a brick, anticlockwise seen from outside: two for each axis, the one at the smaller coordinate first.
/// Bit k of the number of a corner says whether it has the larger coordinate along axis k.
pub const BRICK_FACES: [[u8; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
/// A solid whose volume is below this, times its size cubed, has none.
pub const ZERO_VOLUME: f64 = 1e-12;
/// No solid may have more vertices.
pub const MAX_VERTICES: usize = 10_000;

/// A solid with flat faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polyhedron {
    /// Corners, m.
    pub vertices: Vec<Vec3>,
    /// Corners of each face, anticlockwise seen from outside.
    pub faces: Vec<Vec<u32>>,
}

/// What can be wrong with a solid. Vertices and faces are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolidError {
    /// Four corners at least.
    #[error("the solid has {count} distinct vertices; it needs at least 4")]
    TooFewVertices {
        /// Vertices found.
        count: usize,
    },
    /// Refused so that quadratic tests end.
    #[error("the solid has {count} vertices; at most {MAX_VERTICES} are allowed")]
    TooManyVertices {
        /// Vertices found.
        count: usize,
    },
    /// NaN, infinite or too large to be squared.
    #[error("vertex {vertex} has non-finite coordinates ({}, {}, {})", .at.x, .at.y, .at.z)]
    NonFinite {
        /// Vertex number.
        vertex: usize,
        /// Where.
        at: Vec3,
    },
    /// A face names a vertex that is not there.
    #[error("face {face} names vertex {vertex}, but there are only {count} (counted from 0)")]
    NoSuchVertex {
        /// Face number.
        face: usize,
        /// Vertex named.
        vertex: u32,
        /// Number of vertices.
        count: usize,
    },
    /// A face needs three different corners.
    #[error("face {face} has fewer than 3 distinct corners, or no area")]
    FlatFace {
        /// Face number.
        face: usize,
    },
    /// A face is not plane.
    #[error("face {face} is not flat: vertex {vertex} lies {distance:.3e} m off its plane")]
    CrookedFace {
        /// Face number.
        face: usize,
        /// Vertex number.
        vertex: u32,
        /// Distance, m.
        distance: f64,
    },
    /// An edge with a face on one side only.
    #[error(
        "the surface is open: the edge from vertex {from} to vertex {to} (face {face}) has no face on its other side"
    )]
    Open {
        /// First vertex.
        from: u32,
        /// Second vertex.
        to: u32,
        /// Face that has the edge.
        face: usize,
    },
    /// Two faces run along an edge in the same direction.
    #[error(
        "faces {face} and {other} both run from vertex {from} to vertex {to}: one of them has the wrong orientation, or three faces share this edge"
    )]
    WrongWay {
        /// First vertex.
        from: u32,
        /// Second vertex.
        to: u32,
        /// One face.
        face: usize,
        /// The other face.
        other: usize,
    },
    /// Something lies beyond a face.
    #[error(
        "the solid is not convex: vertex {vertex} lies {distance:.3e} m outside the plane of face {face}"
    )]
    NotConvex {
        /// Face number.
        face: usize,
        /// Vertex beyond it.
        vertex: u32,
        /// Distance, m.
        distance: f64,
    },
    /// All vertices in a plane, or nearly.
    #[error("the solid has no volume ({volume:e} m3): its vertices lie in one plane")]
    ZeroVolume {
        /// Volume found, m³.
        volume: f64,
    },
    /// A vertex that no face uses.
    #[error("vertex {vertex} belongs to no face")]
    Unused {
        /// Vertex number.
        vertex: usize,
    },
    /// Half spaces that enclose nothing finite.
    #[error("the planes do not enclose a solid: it extends beyond {reach:e} m")]
    Unbounded {
        /// Limit, m.
        reach: f64,
    },
    /// Half spaces without a common point.
    #[error("the planes enclose no volume: plane {plane} removes the remaining solid")]
    Nothing {
        /// Number of the plane.
        plane: usize,
    },
}

impl Polyhedron {
    /// A solid that has passed all tests. Faces that all point inward are turned round.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    /// # Examples
    ///
    /// ```
    /// use riprap_geom::Vec3;
    /// use riprap_geom::polyhedron::Polyhedron;
    ///
    /// // A tetrahedron with three edges of 1 m along the axes.
    /// let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    /// let faces = vec![vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
    /// let solid = Polyhedron::new(corners, faces)?;
    /// assert!((solid.moments().volume - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok::<(), riprap_geom::polyhedron::SolidError>(())
    /// ```
    pub fn new(vertices: Vec<Vec3>, faces: Vec<Vec<u32>>) -> Result<Self, SolidError> {
        let mut solid = Self { vertices, faces };
        solid.check_numbers()?;
        solid.check_closed()?;
        // Only of a closed surface that is turned one way everywhere does the volume have a sign.
        if solid.moments().volume < 0.0 {
            for face in &mut solid.faces {
                face.reverse();
            }
        }
        solid.check_shape()?;
        Ok(solid)
    }

    /// A box with faces normal to the axes.
    #[must_use]
    pub fn brick(centre: Vec3, half: Vec3) -> Self {
        let vertices = (0..8)
            .map(|k| {
                let sign = |bit: u32| if k & bit == 0 { -1.0 } else { 1.0 };
                centre + half * Vec3::new(sign(1), sign(2), sign(4))
            })
            .collect();
        Self { vertices, faces: BRICK_FACES.iter().map(|f| f.map(u32::from).to_vec()).collect() }
    }

    /// Whether all is right.
    ///
    /// # Errors
    /// As [`Polyhedron::new`]; faces that point inward are not convex.
    pub fn validate(&self) -> Result<(), SolidError> {
        self.check_numbers()?;
        self.check_closed()?;
        self.check_shape()
    }

    /// Lowest and highest corner of the box around it, m.
    #[must_use]
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for &v in &self.vertices {
            min = min.min(v);
            max = max.max(v);
        }
        (min, max)
    }

    /// Diagonal of the box around it, m: the measure of all tolerances.
    #[must_use]
    pub fn size(&self) -> f64 {
        let (min, max) = self.bounds();
        (max - min).length()
    }

    /// Corners of a face, m.
    #[must_use]
    pub fn outline(&self, face: usize) -> Vec<Vec3> {
        self.faces[face].iter().map(|&v| self.vertices[v as usize]).collect()
    }

    /// Outward normal of a face times its area (Newell's sum: the best plane of a slightly crooked face), m².
    #[must_use]
    pub fn area_vector(&self, face: usize) -> Vec3 {
        let corners = &self.faces[face];
        let Some(&first) = corners.first() else {
            return Vec3::ZERO;
        };
        // Far from the origin of coordinates, products of places would lose the digits of the face.
        let origin = self.vertices[first as usize];
        let arm = |k: u32| self.vertices[k as usize] - origin;
        let mut sum = Vec3::ZERO;
        for pair in corners.windows(2) {
            sum += arm(pair[0]).cross(arm(pair[1]));
        }
        0.5 * sum
    }

    /// Unit outward normal of a face and its distance from the origin along it, m.
    #[must_use]
    pub fn plane(&self, face: usize) -> (Vec3, f64) {
        let normal = self.area_vector(face).normalize_or_zero();
        let corners = &self.faces[face];
        // The mean: of a slightly crooked face no single corner is on the plane.
        let sum = corners.iter().map(|&v| self.vertices[v as usize]).sum::<Vec3>();
        (normal, normal.dot(sum / corners.len() as f64))
    }

    fn check_numbers(&self) -> Result<(), SolidError> {
        let count = self.vertices.len();
        if count < 4 || self.faces.len() < 4 {
            return Err(SolidError::TooFewVertices { count });
        }
        if count > MAX_VERTICES {
            return Err(SolidError::TooManyVertices { count });
        }
        for (vertex, &at) in self.vertices.iter().enumerate() {
            // The square, since distances are made of it.
            if !at.length_squared().is_finite() {
                return Err(SolidError::NonFinite { vertex, at });
            }
        }
        let mut used = vec![false; count];
        for (face, corners) in self.faces.iter().enumerate() {
            for &vertex in corners {
                if vertex as usize >= count {
                    return Err(SolidError::NoSuchVertex { face, vertex, count });
                }
                used[vertex as usize] = true;
            }
            let mut sorted = corners.clone();
            sorted.sort_unstable();
            sorted.dedup();
            if sorted.len() < 3 || sorted.len() < corners.len() {
                return Err(SolidError::FlatFace { face });
            }
        }
        match used.iter().position(|u| !u) {
            Some(vertex) => Err(SolidError::Unused { vertex }),
            None => Ok(()),
        }
    }

    fn check_closed(&self) -> Result<(), SolidError> {
        let mut edges: BTreeMap<(u32, u32), usize> = BTreeMap::new();
        for (face, corners) in self.faces.iter().enumerate() {
            for (from, to) in edges_of(corners) {
                if let Some(&other) = edges.get(&(from, to)) {
                    return Err(SolidError::WrongWay { from, to, face: other, other: face });
                }
                edges.insert((from, to), face);
            }
        }
        match edges.iter().find(|((a, b), _)| !edges.contains_key(&(*b, *a))) {
            Some((&(from, to), &face)) => Err(SolidError::Open { from, to, face }),
            None => Ok(()),
        }
    }

    fn check_shape(&self) -> Result<(), SolidError> {
        let size = self.size();
        let volume = self.moments().volume;
        if volume.abs() < ZERO_VOLUME * (size * size * size) {
            return Err(SolidError::ZeroVolume { volume });
        }
        let tolerance = FLAT * size;
        for (face, corners) in self.faces.iter().enumerate() {
            let (normal, offset) = self.plane(face);
            if normal == Vec3::ZERO {
                return Err(SolidError::FlatFace { face });
            }
            let height = |v: u32| normal.dot(self.vertices[v as usize]) - offset;
            for &vertex in corners {
                let distance = height(vertex).abs();
                if distance > tolerance {
                    return Err(SolidError::CrookedFace { face, vertex, distance });
                }
            }
            for vertex in 0..self.vertices.len() as u32 {
                let distance = height(vertex);
                if distance > tolerance {
                    return Err(SolidError::NotConvex { face, vertex, distance });
                }
            }
        }
        Ok(())
    }
}

/// Directed edges of a face.
pub(crate) fn edges_of(corners: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    let n = corners.len();
    (0..n).map(move |k| (corners[k], corners[(k + 1) % n]))
}

/// Normal times area of a closed outline, anticlockwise about it, m².
#[must_use]
pub fn area_vector(outline: &[Vec3]) -> Vec3 {
    let Some(&origin) = outline.first() else {
        return Vec3::ZERO;
    };
    let mut sum = Vec3::ZERO;
    for pair in outline.windows(2) {
        sum += (pair[0] - origin).cross(pair[1] - origin);
    }
    0.5 * sum
}

/// Two unit vectors that make a right-handed frame (n, b, c) with the unit vector `n`.
///
/// For `n` along an axis, b and c are the next two axes.
#[must_use]
pub fn frame(n: Vec3) -> [Vec3; 3] {
    let size = n.abs();
    let main = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let mut next = Vec3::ZERO;
    // At least 45 deg away from n, so that what is left across n is not small.
    next[(main + 1) % 3] = 1.0;
    let b = (next - n.dot(next) * n).normalize();
    [n, b, n.cross(b)]
}

/// Coordinates of points in a plane with the axes b and c, relative to `origin`.
pub(crate) fn flatten(points: &[Vec3], origin: Vec3, b: Vec3, c: Vec3) -> Vec<Vec2> {
    points.iter().map(|&p| Vec2::new((p - origin).dot(b), (p - origin).dot(c))).collect()
}

#[cfg(test)]
mod tests;
