//! Solids as lists of corners and faces.

use riprap_geom::polyhedron::Polyhedron;

use crate::setup::Solid;

impl Solid {
    /// Corners and faces of several solids in one list, glued faces among them: volume, centroid, inertia and what acts on
    /// all of the surface add up.
    #[must_use]
    pub fn all(parts: &[Self]) -> Self {
        let mut all = Self::default();
        for part in parts {
            let first = all.vertices.len() as u32;
            all.vertices.extend_from_slice(&part.vertices);
            let faces = part.faces.iter();
            all.faces.extend(faces.map(|face| face.iter().map(|v| first + v).collect()));
        }
        all
    }

    /// The solid as geometry knows it.
    #[must_use]
    pub fn polyhedron(&self) -> Polyhedron {
        Polyhedron { vertices: self.vertices.clone(), faces: self.faces.clone() }
    }
}
