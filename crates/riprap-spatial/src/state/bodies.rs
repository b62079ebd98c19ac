//! Motion and mass properties of blocks.

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Mat3, Quat, Vec3};
use serde::{Deserialize, Serialize};

/// Motion of all blocks, one list per component, so that neighbours load side by side.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Bodies {
    /// Displacement of the centroid (x, y, z), m, then rotation vector about x, y, z, rad (for
    /// blocks with finite rotations the vector of the total rotation).
    pub displacement: [Vec<f64>; 6],
    /// Velocity of the centroid (x, y, z), m/s, then spin about x, y, z, rad/s.
    pub velocity: [Vec<f64>; 6],
}

impl Bodies {
    /// `n` blocks at rest.
    #[must_use]
    pub fn at_rest(n: usize) -> Self {
        let zeros = || std::array::from_fn(|_| vec![0.0; n]);
        Self { displacement: zeros(), velocity: zeros() }
    }

    /// Number of blocks.
    #[must_use]
    pub fn len(&self) -> usize {
        self.displacement[0].len()
    }

    /// Whether there are no blocks.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Displacement of the centroid, m.
    #[must_use]
    pub fn displacement(&self, b: usize) -> Vec3 {
        vec3(&self.displacement, 0, b)
    }

    /// Rotation vector, rad.
    #[must_use]
    pub fn rotation(&self, b: usize) -> Vec3 {
        vec3(&self.displacement, 3, b)
    }

    /// Velocity of the centroid half a step ago, m/s.
    #[must_use]
    pub fn velocity(&self, b: usize) -> Vec3 {
        vec3(&self.velocity, 0, b)
    }

    /// Spin half a step ago, rad/s.
    #[must_use]
    pub fn spin(&self, b: usize) -> Vec3 {
        vec3(&self.velocity, 3, b)
    }

    /// Sets displacement (m) and rotation vector (rad).
    pub fn set_displacement(&mut self, b: usize, displacement: Vec3, rotation: Vec3) {
        put(&mut self.displacement, 0, b, displacement);
        put(&mut self.displacement, 3, b, rotation);
    }

    /// Sets velocity (m/s) and spin (rad/s).
    pub fn set_velocity(&mut self, b: usize, velocity: Vec3, spin: Vec3) {
        put(&mut self.velocity, 0, b, velocity);
        put(&mut self.velocity, 3, b, spin);
    }

    /// Appends a block; returns its index.
    pub fn push(&mut self, displacement: [Vec3; 2], velocity: [Vec3; 2]) -> usize {
        let b = self.len();
        for list in self.displacement.iter_mut().chain(&mut self.velocity) {
            list.push(0.0);
        }
        self.set_displacement(b, displacement[0], displacement[1]);
        self.set_velocity(b, velocity[0], velocity[1]);
        b
    }
}

/// Vector at components `first`, `first + 1`, `first + 2` of item `b`.
#[inline]
#[must_use]
pub fn vec3(lists: &[Vec<f64>; 6], first: usize, b: usize) -> Vec3 {
    Vec3::new(lists[first][b], lists[first + 1][b], lists[first + 2][b])
}

#[inline]
fn put(lists: &mut [Vec<f64>; 6], first: usize, b: usize, v: Vec3) {
    lists[first][b] = v.x;
    lists[first + 1][b] = v.y;
    lists[first + 2][b] = v.z;
}

/// Mass properties of equal blocks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolidClass {
    /// Mass, kg.
    pub mass: f64,
    /// Volume, m³.
    pub volume: f64,
    /// Inertia tensor about the centroid in the frame of the start, kg m².
    pub inertia: Mat3,
    /// Its inverse, 1/(kg m²).
    pub inverse: Mat3,
    /// Half the edge lengths of the bounding box about the centroid, m.
    pub half: Vec3,
    /// Largest distance of a corner from the centroid, m.
    pub radius: f64,
    /// Whether the axes are principal axes (bricks): `inertia` is diagonal.
    pub diagonal: bool,
}

impl SolidClass {
    /// That of what a closed surface bounds, and its centroid. Another `volume` (m³), that of tetrahedra within crooked faces, scales mass and inertia.
    pub(crate) fn bounded_by(body: &Polyhedron, density: f64, volume: Option<f64>) -> (Vec3, Self) {
        let moments = body.moments();
        let scale = volume.map_or(density, |volume| density * volume / moments.volume);
        let volume = volume.unwrap_or(moments.volume);
        let inertia = scale * moments.inertia;
        let (mut half, mut radius) = (Vec3::ZERO, 0.0_f64);
        for corner in &body.vertices {
            let arm = *corner - moments.centroid;
            half = half.max(arm.abs());
            radius = radius.max(arm.length());
        }
        let class = Self {
            mass: density * volume,
            volume,
            inertia,
            inverse: inertia.inverse(),
            half,
            radius,
            diagonal: false,
        };
        (moments.centroid, class)
    }
}

/// State of a block with finite rotations.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turned {
    /// Turns the frame of the start into the present one.
    pub attitude: Quat,
    /// Angular momentum about the centroid half a step ago, space frame, N m s.
    pub momentum: Vec3,
}
