//! Random blocks, pairs at a given depth and evaluations of them, for the tests of this room.

use riprap_geom::polyhedron::{Polyhedron, from_half_spaces};
use riprap_geom::{Quat, Vec3};

use crate::kernel::peak::{Peak, peak};
use crate::kernel::planes::{Planes, origin};
use crate::kernel::surface::Walker;
use crate::kernel::{Body, Found, Pair, Pose, Shape, Sums, turn};

/// A stream of random numbers (a linear congruence: good enough to place blocks).
pub struct Chance(u64);

impl Chance {
    pub fn new(seed: u64) -> Self {
        let mut chance = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        for _ in 0..8 {
            chance.unit();
        }
        chance
    }

    pub fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number from 0 to `n - 1`.
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - Vec3::ONE;
            let squared = v.length_squared();
            if squared > 0.01 && squared < 1.0 {
                return v / squared.sqrt();
            }
        }
    }

    pub fn rotation(&mut self) -> Quat {
        Quat::from_axis_angle(self.direction(), self.between(-3.0, 3.0))
    }
}

/// Kinds of random blocks of about a metre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Boxes,
    Tetrahedra,
    /// At most so many faces.
    Planes(usize),
}

pub const KINDS: [Kind; 3] = [Kind::Boxes, Kind::Tetrahedra, Kind::Planes(14)];

/// A block about its centroid, with the solid it was made from.
pub fn block(kind: Kind, chance: &mut Chance) -> (Shape, Polyhedron) {
    loop {
        let solid = match kind {
            Kind::Boxes => {
                let mut half = || chance.between(0.3, 0.6);
                Polyhedron::brick(Vec3::ZERO, Vec3::new(half(), half(), half()))
            }
            Kind::Tetrahedra => {
                let vertices: Vec<Vec3> = (0..4).map(|_| 0.9 * chance.direction()).collect();
                let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![1, 3, 2], vec![0, 2, 3]];
                match Polyhedron::new(vertices, faces) {
                    Ok(solid) if solid.moments().volume > 0.08 => solid,
                    _ => continue,
                }
            }
            Kind::Planes(count) => {
                let planes: Vec<(Vec3, f64)> =
                    (0..count).map(|_| (chance.direction(), chance.between(0.4, 0.6))).collect();
                match from_half_spaces(&planes, 2.0) {
                    Ok(solid) => solid,
                    Err(_) => continue,
                }
            }
        };
        let centre = solid.moments().centroid;
        if let Ok(shape) = Shape::new(&solid, centre) {
            let vertices = solid.vertices.iter().map(|v| *v - centre).collect();
            let faces = solid.faces;
            return (shape, Polyhedron { vertices, faces });
        }
    }
}

/// Two bodies with their turned normals.
pub struct Placed<'a> {
    shapes: [&'a Shape; 2],
    poses: [Pose; 2],
    normals: [Vec<Vec3>; 2],
}

impl<'a> Placed<'a> {
    pub fn new(shapes: [&'a Shape; 2], poses: [Pose; 2]) -> Self {
        let mut normals = [Vec::new(), Vec::new()];
        for s in 0..2 {
            turn(shapes[s], poses[s].rotation, &mut normals[s]);
        }
        Self { shapes, poses, normals }
    }

    pub fn bodies(&self) -> [Body<'_>; 2] {
        [0, 1].map(|s| Body {
            shape: self.shapes[s],
            normals: &self.normals[s],
            turn: riprap_geom::Mat3::from_quat(self.poses[s].rotation),
            position: self.poses[s].position,
        })
    }

    pub fn origin(&self) -> Vec3 {
        let [a, b] = self.bodies();
        origin(&a, &b)
    }

    pub fn peak(&self) -> Peak {
        let [a, b] = self.bodies();
        let mut planes = Planes::default();
        planes.gather_all([&a, &b], origin(&a, &b));
        peak(&planes, 4.0 * (a.shape.radius + b.shape.radius))
    }

    pub fn find(&self, walker: &mut Walker, faces: [&[u16]; 2], hint: Option<[u16; 2]>) -> Found {
        let [a, b] = self.bodies();
        walker.find(&Pair {
            bodies: [&a, &b],
            faces,
            ties: true,
            hint,
            covered: [0; 2],
            witnesses: &[],
        })
    }

    /// With all faces of both.
    pub fn find_all(&self, walker: &mut Walker) -> Found {
        let lists = self.shapes.map(all_faces);
        self.find(walker, [&lists[0], &lists[1]], None)
    }

    /// With all faces of both, which must touch.
    pub fn touch(&self, walker: &mut Walker) -> Sums {
        match self.find_all(walker) {
            Found::Touching(sums) => sums,
            other => panic!("{other:?}"),
        }
    }
}

pub fn all_faces(shape: &Shape) -> Vec<u16> {
    (0..shape.faces() as u16).collect()
}

/// Two blocks turned at random that lie `depth` deep in each other (twice the radius of the largest ball in both).
pub fn overlapping(kind: Kind, depth: f64, chance: &mut Chance) -> ([Shape; 2], [Pose; 2]) {
    loop {
        let shapes = [block(kind, chance).0, block(kind, chance).0];
        let rotations = [chance.rotation(), chance.rotation()];
        let direction = chance.direction();
        let sideways = 0.4 * chance.direction();
        let poses = |distance: f64| {
            [
                Pose { position: Vec3::ZERO, rotation: rotations[0] },
                Pose { position: sideways + distance * direction, rotation: rotations[1] },
            ]
        };
        let room =
            |distance: f64| match Placed::new([&shapes[0], &shapes[1]], poses(distance)).peak() {
                Peak::Apart { .. } | Peak::Unsure => 0.0,
                Peak::Overlap { depth, .. } => 2.0 * depth,
            };
        let (mut near, mut far) = (0.0, 3.0);
        if room(near) < depth {
            continue;
        }
        for _ in 0..45 {
            let middle = 0.5 * (near + far);
            if room(middle) > depth {
                near = middle;
            } else {
                far = middle;
            }
        }
        let at = poses(near);
        return (shapes, at);
    }
}
