//! The shapes of a table turned as a whole, and repeated.

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Mat3, Quat, Vec3};

use super::mesh::{Made, shape_of};
use crate::model::builder::Builder;
use crate::model::start::{Attitude, State};
use crate::scenario::Quantity;
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
        if let Some(quaternion) = &said.quaternion {
            let [w, x, y, z] = quaternion.each_ref().map(Quantity::si);
            return Self::by(Quat::from_xyzw(x, y, z, w), about);
        }
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
        let angle = said.angle.as_ref().map_or(0.0, Quantity::si);
        Self::of_matrix(rotation(axis, angle), about)
    }

    /// A quaternion of any length but none.
    pub(super) fn by(quaternion: Quat, about: Vec3) -> Self {
        // Its largest part first, so that the square of no part is nothing or infinite.
        let size = quaternion.to_array().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let quaternion = (quaternion * (1.0 / size)).normalize();
        Self::of_matrix(Mat3::from_quat(quaternion), about)
    }

    fn of_matrix(exact: Mat3, about: Vec3) -> Self {
        let near = exact.to_cols_array();
        let keeps_axes = near.iter().all(|x| (x - x.round()).abs() < ROUND);
        let matrix = if keeps_axes { Mat3::from_cols_array(&near.map(f64::round)) } else { exact };
        Turn { matrix, about, keeps_axes }
    }

    /// A point turned.
    pub(super) fn of(&self, point: Vec3) -> Vec3 {
        self.about + self.matrix * (point - self.about)
    }

    /// The point that is turned into this one.
    pub(super) fn back(&self, point: Vec3) -> Vec3 {
        self.about + self.matrix.transpose() * (point - self.about)
    }

    /// A plane `normal . x = offset` turned.
    pub(super) fn of_plane(&self, normal: Vec3, offset: f64) -> (Vec3, f64) {
        let turned = self.matrix * normal;
        (turned, offset + (turned - normal).dot(self.about))
    }

    /// A symmetric tensor turned.
    pub(super) fn of_tensor(&self, tensor: &Mat3) -> Mat3 {
        let turned = self.matrix * *tensor * self.matrix.transpose();
        0.5 * (turned + turned.transpose())
    }

    /// Shapes, and the faces that are named among them.
    pub(super) fn of_all(&self, made: Made) -> Made {
        let shapes = made.shapes.into_iter().map(|shape| self.of_shape(shape));
        let face = |(block, normal, offset)| {
            let (normal, offset) = self.of_plane(normal, offset);
            (block, normal, offset)
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

    /// A shape turned.
    pub(super) fn of_shape(&self, shape: Shape) -> Shape {
        match shape {
            Shape::Brick { centre, half } if self.keeps_axes => {
                Shape::Brick { centre: self.of(centre), half: (self.matrix * half).abs() }
            }
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

/// Puts a block where a state says; `false` where it is terrain, which nothing moves.
pub(in crate::model) fn put_solid(builder: &mut Builder, block: usize, state: &State) -> bool {
    let count = builder.spatial.blocks.len();
    let spec = &mut builder.spatial.blocks[block];
    if spec.shape.is_terrain() {
        return false;
    }
    let mut faces = builder.surfaces.values_mut().flatten();
    let mut own: Vec<_> = faces.by_ref().filter(|f| f.0 as usize == block).collect();
    let centre = Vec3::from(builder.directory.centroids[block]);
    if let Some(Attitude::Quaternion(attitude)) = state.attitude {
        // What is not turned keeps its bits, and a brick its kind.
        if attitude != Quat::IDENTITY {
            let turn = Turn::by(attitude, centre);
            spec.shape = turn.of_shape(spec.shape.clone());
            for (_, normal, offset) in &mut own {
                (*normal, *offset) = turn.of_plane(*normal, *offset);
            }
            let bodies = builder.spatial.bodies.iter_mut();
            for body in bodies.filter(|body| body.block as usize == block) {
                body.inertia = turn.of_tensor(&body.inertia);
            }
        }
        builder.spatial.attitudes.resize(count, Quat::IDENTITY);
        builder.spatial.attitudes[block] = attitude;
    }
    if let Some(place) = state.place {
        let place = place - builder.spatial.origin;
        let shift = place - centre;
        spec.shape = moved(&spec.shape, shift);
        for (_, normal, offset) in &mut own {
            *offset += normal.dot(shift);
        }
        builder.directory.centroids[block] = place.into();
    }
    spec.velocity = state.velocity.unwrap_or(spec.velocity);
    spec.spin = state.spin.unwrap_or(spec.spin);
    true
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
        groups: groups.map(|(name, all)| (name.clone(), members(all))).collect(),
        surfaces: surfaces.map(|(name, all)| (name.clone(), faces(all))).collect(),
    }
}

/// A shape moved.
pub(super) fn moved(shape: &Shape, shift: Vec3) -> Shape {
    match shape {
        Shape::Brick { centre, half } => Shape::Brick { centre: *centre + shift, half: *half },
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
