//! Blocks that are not convex, of convex parts.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{GluedError, Polyhedron, glued};

use super::mesh::{Made, shape_of};
use super::shapes::{brick, solid};
use crate::model::builder::Builder;
use crate::scenario::language::{self, Block};
use crate::spatial::setup::{Shape, Solid};

impl Builder<'_> {
    /// One block of the parts of a table.
    pub(super) fn parts(
        &mut self,
        block: &Block,
        said: &[language::Part],
        shift: Vec3,
    ) -> Option<Shape> {
        let mut shapes = Vec::with_capacity(said.len());
        for part in said {
            if let Some(said) = &part.brick {
                let (centre, half) = brick(said);
                if !self.with_volume(block, 8.0 * half.element_product()) {
                    return None;
                }
                let centre = centre + shift;
                shapes.push(Shape::Brick { centre, half });
            } else if let Some(said) = &part.polyhedron {
                let solid = self.polyhedron(block, said, shift)?;
                shapes.push(Shape::Polyhedron(Box::new(solid)));
            }
        }
        self.glued(block, &shapes)
    }

    /// One block of all cells of a mesh. What the file names stays named: a group that holds a cell holds the block.
    pub(super) fn glued_mesh(&mut self, block: &Block, made: Made) -> Option<Made> {
        let cells = made.shapes.len();
        for (name, members) in &made.groups {
            let of_faces = made.surfaces.iter().any(|(surface, _)| surface == name);
            if members.len() < cells && !of_faces {
                let message = format!(
                    "group `{name}` of the mesh contains {} of the {cells} cells glued into block `{}`; the whole block joins the group",
                    members.len(),
                    block.name
                );
                let help = "select only its cells with `mesh.volume`, or do not use the group";
                self.warn_at("geometry.parts", block.name.span.clone(), message, help);
            }
        }
        let groups = made.groups.into_iter().map(|(name, _)| (name, vec![0]));
        let surfaces = made.surfaces.into_iter().map(|(name, mut faces)| {
            faces.iter_mut().for_each(|face| face.0 = 0);
            (name, faces)
        });
        Some(Made {
            shapes: vec![self.glued(block, &made.shapes)?],
            groups: groups.collect(),
            surfaces: surfaces.collect(),
        })
    }

    /// One block of convex shapes that touch by faces; a plain one where all of it is convex.
    pub(super) fn glued(&mut self, block: &Block, shapes: &[Shape]) -> Option<Shape> {
        let parts: Vec<Polyhedron> = shapes.iter().map(solid).collect();
        let terms = match glued::terms(&parts) {
            Ok(terms) => terms,
            Err(error) => {
                let message = format!("block `{}`: {error}", block.name);
                let help = match error {
                    GluedError::Count { parts: 0, .. } => {
                        "list the convex parts of the block; for a single part use `brick` or `polyhedron`"
                    }
                    GluedError::Overlap { .. } => {
                        "parts may share faces but no volume; trim one of them"
                    }
                    GluedError::Apart { .. } => {
                        "parts must share at least part of a face; make two blocks, or close the gap"
                    }
                    GluedError::Part { .. } => "parts must be convex; divide this one",
                    GluedError::Count { .. }
                    | GluedError::TooMany { .. }
                    | GluedError::Unsure { .. } => "use fewer, larger convex parts",
                };
                self.error_at("geometry.parts", &block.name, message, help);
                return None;
            }
        };
        if let [only] = &terms[..] {
            return Some(shape_of(only.solid.clone()));
        }
        let solids =
            parts.into_iter().map(|part| Solid { vertices: part.vertices, faces: part.faces });
        Some(Shape::Glued(solids.collect()))
    }
}
