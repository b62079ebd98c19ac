//! Conditions on free faces.

use riprap_geom::Vec3;

use super::global;
use super::shapes::{bounds, solid};
use crate::accounts::Holder;
use crate::dynamics::TimeFunction;
use crate::model::builder::Builder;
use crate::scenario::language::{self, Faces, Side};
use crate::scenario::read::Provenance;
use crate::scenario::vectors::unit;
use crate::scenario::words::WordOr;
use crate::scenario::{Diagnostic, Name, Quantity};
use crate::spatial::setup::{BlockSpec, Boundary, BoundaryKind, FaceSet, Shape};

/// A face lies on a plane if it is nearer than this share of its block.
const ON_PLANE: f64 = 1e-6;

/// Planes whose normals and offsets (m) differ by less than about this are one.
const SAME_PLANE: f64 = 1e-8;

/// Axis and sign of the outward normal of a side, and its word.
fn side(side: Side) -> (usize, f64, &'static str) {
    match side {
        Side::XMin => (0, -1.0, "x-min"),
        Side::XMax => (0, 1.0, "x-max"),
        Side::YMin => (1, -1.0, "y-min"),
        Side::YMax => (1, 1.0, "y-max"),
        Side::ZMin => (2, -1.0, "z-min"),
        Side::ZMax => (2, 1.0, "z-max"),
    }
}

fn normal_of(said: Side) -> Vec3 {
    let (axis, sign, _) = side(said);
    sign * Vec3::AXES[axis]
}

impl Builder<'_> {
    /// Lowest and highest corner of the whole model, local coordinates, m.
    pub(in crate::model) fn model_bounds(&self) -> (Vec3, Vec3) {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let blocks = &self.spatial.blocks;
        let alone = blocks.iter().all(|b| b.shape.is_terrain());
        let counts = |b: &&BlockSpec| alone || !b.shape.is_terrain();
        let boxes = blocks.iter().filter(counts).map(|b| bounds(&b.shape));
        boxes.fold(start, |(low, high), (min, max)| (low.min(min), high.max(max)))
    }

    pub(super) fn boundaries(&mut self) {
        let in_situ = self.parsed.scenario.in_situ.is_some();
        for (number, said) in self.parsed.scenario.boundaries.iter().enumerate() {
            let (Some(on), Some((kind, held))) =
                (self.faces(&said.on), self.boundary_kind(said, number))
            else {
                continue;
            };
            let name = boundary_name(said, number);
            let mut read = self.reading(format!("boundaries.{name}"), said);
            let in_situ = read.in_situ_or(in_situ && held, Provenance::Default, "");
            let count = self.spatial.boundaries.len() as u16;
            self.account(name.clone(), Holder::Boundary(count));
            self.spatial.boundaries.push(Boundary { name, on, kind, in_situ });
        }
    }

    /// Which faces; `None` after an error.
    fn faces(&mut self, on: &Faces) -> Option<FaceSet> {
        let normal = on.side.as_ref().map(|side| normal_of(side.0));
        if let Some(plane) = &on.plane {
            return self.plane(plane);
        }
        if let Some(region) = &on.region {
            return Some(FaceSet::Box {
                min: self.local(region.min.xyz()),
                max: self.local(region.max.xyz()),
                normal,
            });
        }
        if let Some(name) = &on.surface {
            return self.mesh_surface(name);
        }
        let names: Vec<_> =
            on.block.iter().chain(&on.group).chain(on.blocks.iter().flatten()).cloned().collect();
        let blocks = self.directory.all(&names);
        let blocks = self.take(blocks)?;
        Some(FaceSet::Blocks { blocks, normal })
    }

    /// The faces of a physical surface of a mesh.
    fn mesh_surface(&mut self, name: &Name) -> Option<FaceSet> {
        let Some(faces) = self.surfaces.get(name.as_str()) else {
            let known = self.surfaces.keys().map(String::as_str);
            let mut error = Diagnostic::unknown("surface", name, known);
            let help = || "valid names are the physical surfaces of `mesh.msh`".to_owned();
            error.help.get_or_insert_with(help);
            self.found.push(error);
            return None;
        };
        let mut blocks: Vec<u32> = faces.iter().map(|(block, ..)| *block).collect();
        blocks.sort_unstable();
        blocks.dedup();
        // Planes of one flat surface differ by round-off: they are kept once.
        let rounded = |(n, d): &(Vec3, f64)| [n.x, n.y, n.z, *d].map(|x| (x / SAME_PLANE).round());
        let mut planes: Vec<(Vec3, f64)> = faces.iter().map(|(_, n, d)| (*n, *d)).collect();
        planes.sort_by(|a, b| {
            let pairs = rounded(a).into_iter().zip(rounded(b));
            pairs.fold(std::cmp::Ordering::Equal, |so_far, (x, y)| so_far.then(x.total_cmp(&y)))
        });
        planes.dedup_by_key(|plane| rounded(plane));
        Some(FaceSet::Surface { blocks, planes })
    }

    fn plane(&mut self, plane: &WordOr<Side, language::FacePlane>) -> Option<FaceSet> {
        let (normal, offset) = match plane {
            WordOr::Word(word, span) => {
                let (axis, sign, text) = side(*word);
                if self.spatial.periodic[axis].is_some() {
                    let message = format!(
                        "`{text}` cannot have a boundary condition: the model is periodic there"
                    );
                    let help = "remove the boundary, or the period";
                    self.error_at("boundary.periodic", span.clone(), message, help);
                    return None;
                }
                let (min, max) = self.model_bounds();
                // The distance from the origin along the outward normal, which points down the axis at the low side.
                let offset = if sign > 0.0 { max[axis] } else { -min[axis] };
                (normal_of(*word), offset)
            }
            WordOr::Table(said, _) => {
                // No direction is reported by the rules of the language.
                let normal = Vec3::from(unit(&said.normal)?);
                let at = global(&said.at) - self.spatial.origin;
                (normal, normal.dot(at))
            }
        };
        let lies = self.spatial.blocks.iter().any(|block| has_face(&block.shape, normal, offset));
        if !lies {
            let help = "give a point on the faces and their outward normal";
            let message = "no block face lies on this plane";
            self.error_at("boundary.no_face", plane.span().clone(), message, help);
            return None;
        }
        Some(FaceSet::Plane { normal, offset })
    }

    /// What happens there, and whether it holds the faces.
    fn boundary_kind(
        &mut self,
        said: &language::Boundary,
        number: usize,
    ) -> Option<(BoundaryKind, bool)> {
        let path = format!("boundaries.{}", boundary_name(said, number));
        let constant = TimeFunction::Constant(1.0);
        if said.held.is_some() || said.roller.is_some() {
            let kind = BoundaryKind::Held { normal: true, shear: said.held.is_some() };
            return Some((kind, true));
        }
        if let Some(moved) = &said.moved {
            let velocity = self.point_velocity(&moved.velocity);
            return Some((BoundaryKind::Moved { velocity }, true));
        }
        if let Some(viscous) = &said.viscous {
            let mut read = self.reading(format!("{path}.viscous"), viscous);
            let half_cell = read.half_cell();
            return Some((BoundaryKind::Viscous { half_cell }, true));
        }
        let mut traction = Vec3::ZERO;
        let (mut pressure, mut gradient, mut datum) = (0.0, 0.0, 0.0);
        let mut time = constant;
        if let Some(face) = &said.pressure {
            let origin = self.spatial.origin.z;
            let mut read = self.reading(format!("{path}.pressure"), face);
            pressure = read.value();
            gradient = read.gradient();
            datum = read.datum() - origin;
            if let Some(f) = &face.time {
                time = self.time_function(f)?;
            }
        } else if let Some(face) = &said.traction {
            traction = face.value.each_ref().map(Quantity::si).into();
            if let Some(f) = &face.time {
                time = self.time_function(f)?;
            }
        }
        let kind = BoundaryKind::Traction { traction, pressure, gradient, datum, time };
        Some((kind, false))
    }
}

/// Name for messages; its number in the file, as in `--set boundaries.0...`, where nothing else tells it.
pub(in crate::model) fn boundary_name(said: &language::Boundary, number: usize) -> String {
    let on = &said.on;
    if let Some(name) = &said.name {
        return name.text.clone();
    }
    let names = on.block.iter().chain(&on.group).chain(&on.surface);
    let mut names = names.chain(on.blocks.iter().flatten());
    match (&on.plane, names.next()) {
        (Some(WordOr::Word(word, _)), _) => side(*word).2.to_owned(),
        (_, Some(name)) => name.text.clone(),
        (Some(WordOr::Table(..)) | None, None) => number.to_string(),
    }
}

/// Whether a shape has a face on the plane `normal . x = offset` that looks along the normal.
pub(in crate::model) fn has_face(shape: &Shape, normal: Vec3, offset: f64) -> bool {
    let (min, max) = bounds(shape);
    let slack = ON_PLANE * (max - min).max_element();
    // 1 minus the cosine is half the square of the angle: within 4.5e-5 rad.
    let along = |n: Vec3| n.dot(normal) > 1.0 - 1e-9;
    match shape {
        Shape::Brick { .. } => (0..3).any(|k| {
            let axis = Vec3::AXES[k];
            (along(axis) && (max[k] - offset).abs() <= slack)
                || (along(-axis) && (-min[k] - offset).abs() <= slack)
        }),
        Shape::Polyhedron(_) | Shape::Glued(_) => {
            let solid = solid(shape);
            (0..solid.faces.len()).any(|face| {
                let (n, d) = solid.plane(face);
                along(n) && (d - offset).abs() <= slack
            })
        }
        Shape::Terrain(_) => false,
    }
}
