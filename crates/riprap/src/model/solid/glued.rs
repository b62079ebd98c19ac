//! Blocks that are not convex, of convex parts.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{GluedError, Polyhedron, glued};

use super::mesh::shape_of;
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

    /// One block of convex shapes that touch by faces; a plain one where all of it is convex.
    pub(super) fn glued(&mut self, block: &Block, shapes: &[Shape]) -> Option<Shape> {
        let parts: Vec<Polyhedron> = shapes.iter().map(solid).collect();
        let terms = match glued::terms(&parts) {
            Ok(terms) => terms,
            Err(error) => {
                let message = format!("block `{}`: {error}", block.name);
                let help = match error {
                    GluedError::Overlap { .. } => {
                        "parts share faces, no volume: cut one of them back"
                    }
                    GluedError::Apart { .. } => {
                        "parts touch by a part of a face at least; make two blocks, or close the gap"
                    }
                    GluedError::Part { .. } => "parts are convex: divide this one",
                    GluedError::TooMany { .. } | GluedError::Unsure { .. } => {
                        "give fewer and larger convex parts"
                    }
                };
                self.error_at("geometry.parts", &block.name, message, help);
                return None;
            }
        };
        if let [only] = &terms[..] {
            return Some(shape_of(only.solid.clone()));
        }
        let solids = parts.into_iter().map(|part| Solid {
            vertices: part.vertices,
            faces: part.faces,
        });
        Some(Shape::Glued(solids.collect()))
    }
}
