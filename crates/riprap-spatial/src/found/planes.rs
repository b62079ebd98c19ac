//! Planes of a pair of blocks about a common origin.

use riprap_geom::Vec3;

use super::shape::Body;

/// Planes `n . x <= d` of two blocks about one origin, as lists of components; those of the first block come first.
///
/// The lists keep their room, so that filling them again takes no memory.
#[derive(Clone, Debug, Default)]
pub struct Planes {
    /// Unit outward normals, x.
    pub x: Vec<f64>,
    /// y.
    pub y: Vec<f64>,
    /// z.
    pub z: Vec<f64>,
    /// Distance from the origin along the normal, m.
    pub d: Vec<f64>,
    /// How many planes belong to the first block.
    pub split: usize,
}

impl Planes {
    /// Empties the lists.
    pub fn begin(&mut self) {
        self.x.clear();
        self.y.clear();
        self.z.clear();
        self.d.clear();
        self.split = 0;
    }

    /// Appends one face of a body.
    pub fn push(&mut self, body: &Body, face: u16, origin: Vec3) {
        let n = body.normals[face as usize];
        self.x.push(n.x);
        self.y.push(n.y);
        self.z.push(n.z);
        self.d
            .push(body.shape.offsets[face as usize] + n.dot(body.position - origin));
    }

    /// The listed faces of both bodies.
    pub fn gather(&mut self, bodies: [&Body; 2], faces: [&[u16]; 2], origin: Vec3) {
        self.begin();
        for (body, faces) in bodies.into_iter().zip(faces) {
            self.split = self.len();
            for &face in faces {
                self.push(body, face, origin);
            }
        }
    }

    /// All faces of both bodies.
    pub fn gather_all(&mut self, bodies: [&Body; 2], origin: Vec3) {
        self.begin();
        for body in bodies {
            self.split = self.len();
            for face in 0..body.shape.faces() {
                self.push(body, face as u16, origin);
            }
        }
    }

    /// Number of planes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.d.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.d.is_empty()
    }

    /// Normal of plane `k`.
    #[must_use]
    #[inline]
    pub fn normal(&self, k: usize) -> Vec3 {
        Vec3::new(self.x[k], self.y[k], self.z[k])
    }
}

/// Where planes of a pair are counted from: the centroid of the smaller block, so that no digits are lost to the larger one.
#[must_use]
pub fn origin(a: &Body, b: &Body) -> Vec3 {
    if b.shape.radius < a.shape.radius {
        b.position
    } else {
        a.position
    }
}
