//! Planes of a pair of blocks about a common origin.

use riprap_geom::Vec3;

use crate::kernel::shape::Body;
use crate::lanes::LANES;

/// Planes `n . x <= d` of two blocks about one origin, as lists of components; those of the first block come first.
///
/// The lists keep their room, so that filling them again takes no memory, and are longer than there are planes: those of a pair can be read
/// in whole registers.
#[derive(Clone, Debug, Default)]
pub struct Planes {
    len: usize,
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
        self.len = 0;
        self.split = 0;
    }

    /// Appends one face of a body.
    #[inline]
    pub fn push(&mut self, body: &Body, face: u16, origin: Vec3) {
        let n = body.normals[face as usize];
        let d = body.shape.offsets[face as usize] + n.dot(body.position - origin);
        self.push_plane(n, d);
    }

    /// Appends the plane `n . x <= d`.
    #[inline]
    pub fn push_plane(&mut self, n: Vec3, d: f64) {
        if self.d.len() < self.len + LANES {
            self.make_room();
        }
        self.len += 1;
        self.set(self.len - 1, n, d);
    }

    #[cold]
    fn make_room(&mut self) {
        for list in [&mut self.x, &mut self.y, &mut self.z, &mut self.d] {
            list.resize(self.len + 3 * LANES, 0.0);
        }
    }

    /// Changes plane `k`.
    #[inline]
    pub fn set(&mut self, k: usize, n: Vec3, d: f64) {
        (self.x[k], self.y[k], self.z[k], self.d[k]) = (n.x, n.y, n.z, d);
    }

    /// The listed faces of both bodies.
    pub fn gather(&mut self, bodies: [&Body; 2], faces: [&[u16]; 2], origin: Vec3) {
        self.len = faces[0].len() + faces[1].len();
        self.split = faces[0].len();
        if self.d.len() < self.len + LANES {
            self.make_room();
        }
        let lists = [&mut self.x, &mut self.y, &mut self.z, &mut self.d];
        let [mut x, mut y, mut z, mut d] = lists.map(|list| list.iter_mut());
        for (body, faces) in bodies.into_iter().zip(faces) {
            let shift = body.position - origin;
            let (normals, offsets) = (body.normals, &body.shape.offsets);
            for (face, ((x, y), (z, d))) in
                faces.iter().zip(x.by_ref().zip(y.by_ref()).zip(z.by_ref().zip(d.by_ref())))
            {
                let n = normals[usize::from(*face)];
                (*x, *y, *z) = (n.x, n.y, n.z);
                *d = offsets[usize::from(*face)] + n.dot(shift);
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

    /// Moves all planes outward by `by` (m).
    pub fn inflate(&mut self, by: f64) {
        if by != 0.0 {
            self.d[..self.len].iter_mut().for_each(|d| *d += by);
        }
    }

    /// Number of planes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
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
pub(crate) fn origin(a: &Body, b: &Body) -> Vec3 {
    if b.shape.radius < a.shape.radius { b.position } else { a.position }
}
