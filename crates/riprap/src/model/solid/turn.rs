//! The shapes of a table turned as a whole, and repeated.

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Mat3, Vec3};

use super::mesh::{Made, shape_of};
use crate::scenario::language::{Block, Rotate};
use crate::scenario::vectors::unit;
use crate::spatial::setup::Shape;

/// An entry of a rotation matrix nearer than this to -1, 0 or 1 is that number.
const ROUND: f64 = 1e-12;

/// A rotation about a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    matrix: Mat3,
    about: Vec3,
    /// Whether axes become axes, so that bricks stay bricks.
    keeps_axes: bool,
}

impl Turn {
    /// What `rotate` says, about a point in the coordinates of the shapes.
    pub(super) fn new(said: &Rotate, about: Vec3) -> Self {
        let axis = match (&said.axis, &said.dip_direction) {
            (Some(axis), _) => unit(axis).map_or(Vec3::Z, Vec3::from),
            // Along the strike: about it, the upward normal leans in the direction of dip.
            (None, Some(direction)) => {
                let direction = direction.si();
                Vec3::new(-libm::cos(direction), libm::sin(direction), 0.0)
            }
            // Reported by the rules of the language.
            (None, None) => Vec3::Z,
        };
        let exact = rotation(axis, said.angle.si());
        let near = exact.to_cols_array();
        let keeps_axes = near.iter().all(|x| (x - x.round()).abs() < ROUND);
        let matrix = if keeps_axes {
            Mat3::from_cols_array(&near.map(f64::round))
        } else {
            exact
        };
        Turn {
            matrix,
            about,
            keeps_axes,
        }
    }

    /// A point turned.
    pub(super) fn of(&self, point: Vec3) -> Vec3 {
        self.about + self.matrix * (point - self.about)
    }

    /// The point that is turned into this one.
    pub(super) fn back(&self, point: Vec3) -> Vec3 {
        self.about + self.matrix.transpose() * (point - self.about)
    }

    /// Shapes, and the faces that are named among them.
    pub(super) fn of_all(&self, made: Made) -> Made {
        let shapes = made.shapes.into_iter().map(|shape| self.of_shape(shape));
        let face = |(block, normal, offset): (u32, Vec3, f64)| {
            let turned = self.matrix * normal;
            (block, turned, offset + (turned - normal).dot(self.about))
        };
        let surfaces = made.surfaces.into_iter();
        Made {
            shapes: shapes.collect(),
            groups: made.groups,
            surfaces: surfaces
                .map(|(name, faces)| (name, faces.into_iter().map(face).collect()))
                .collect(),
        }
    }

    fn of_shape(&self, shape: Shape) -> Shape {
        match shape {
            Shape::Brick { centre, half } if self.keeps_axes => Shape::Brick {
                centre: self.of(centre),
                half: (self.matrix * half).abs(),
            },
            Shape::Brick { centre, half } => {
                let mut solid = Polyhedron::brick(centre, half);
                solid.vertices.iter_mut().for_each(|v| *v = self.of(*v));
                shape_of(solid)
            }
            Shape::Polyhedron(mut solid) => {
                solid.vertices.iter_mut().for_each(|v| *v = self.of(*v));
                Shape::Polyhedron(solid)
            }
            Shape::Glued(mut parts) => {
                let corners = parts.iter_mut().flat_map(|part| &mut part.vertices);
                corners.for_each(|v| *v = self.of(*v));
                Shape::Glued(parts)
            }
            // Refused by the rules of the language.
            Shape::Terrain(surface) => Shape::Terrain(surface),
        }
    }
}

/// Matrix of a rotation about a unit axis by an angle (rad), right-handed: the formula of Rodrigues.
fn rotation(axis: Vec3, angle: f64) -> Mat3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let column = |e: Vec3| cos * e + sin * axis.cross(e) + (1.0 - cos) * axis.dot(e) * axis;
    Mat3::from_cols(column(Vec3::X), column(Vec3::Y), column(Vec3::Z))
}

/// Repeats the shapes of a table, and what is named among them.
pub(super) fn copies(block: &Block, made: Made) -> Made {
    let Some(said) = &block.copies else {
        return made;
    };
    let (step, own) = (Vec3::from(said.step.xyz()), made.shapes.len() as u32);
    let shifts = || (0..said.count).map(|k| (k * own, f64::from(k) * step));
    let shapes = shifts().flat_map(|(_, shift)| {
        let shapes = made.shapes.iter();
        shapes.map(move |shape| moved(shape, shift))
    });
    let members = |all: &[u32]| -> Vec<u32> {
        let of = |(first, _)| all.iter().map(move |b| first + b);
        shifts().flat_map(of).collect()
    };
    let faces = |all: &[(u32, Vec3, f64)]| -> Vec<(u32, Vec3, f64)> {
        let of = |(first, shift)| {
            let faces = all.iter();
            faces.map(move |(b, n, d)| (first + b, *n, d + n.dot(shift)))
        };
        shifts().flat_map(of).collect()
    };
    let (groups, surfaces) = (made.groups.iter(), made.surfaces.iter());
    Made {
        shapes: shapes.collect(),
        groups: groups
            .map(|(name, all)| (name.clone(), members(all)))
            .collect(),
        surfaces: surfaces
            .map(|(name, all)| (name.clone(), faces(all)))
            .collect(),
    }
}

fn moved(shape: &Shape, shift: Vec3) -> Shape {
    match shape {
        Shape::Brick { centre, half } => Shape::Brick {
            centre: *centre + shift,
            half: *half,
        },
        Shape::Polyhedron(solid) => {
            let mut solid = solid.clone();
            solid.vertices.iter_mut().for_each(|v| *v += shift);
            Shape::Polyhedron(solid)
        }
        Shape::Glued(parts) => {
            let mut parts = parts.clone();
            let corners = parts.iter_mut().flat_map(|part| &mut part.vertices);
            corners.for_each(|v| *v += shift);
            Shape::Glued(parts)
        }
        // It has no copies.
        Shape::Terrain(surface) => Shape::Terrain(surface.clone()),
    }
}
