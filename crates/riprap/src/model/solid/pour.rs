//! Loose blocks in space, to be poured.

use riprap_geom::polyhedron::pour::{Pour, pour};
use riprap_geom::{GeomError, Vec3};

use super::mesh::shape_of;
use crate::model::builder::Builder;
use crate::scenario::language::{self, Block};
use crate::spatial::setup::Shape;

impl Builder<'_> {
    /// Blocks ready to be poured, in local coordinates; `None` after an error.
    pub(super) fn pour(
        &mut self,
        block: &Block,
        said: &language::Pour,
        shift: Vec3,
    ) -> Option<Vec<Shape>> {
        if !self.has_memory(block, f64::from(said.count), &block.name.span) {
            return None;
        }
        let mut read = self.reading(format!("blocks.{}.pour", block.name), said);
        let seed = read.seed();
        let [low, high] = said.region.each_ref().map(|c| Vec3::from(c.xyz()) + shift);
        let poured = pour(&Pour {
            region: (low, high),
            count: said.count as usize,
            size: (said.size[0].si(), said.size[1].si()),
            seed,
        });
        match poured {
            Ok(solids) => Some(solids.into_iter().map(shape_of).collect()),
            Err(error) => {
                let (code, help) = if matches!(error, GeomError::DoesNotFit { .. }) {
                    let help = "use a larger region, or a smaller `count` or `size`";
                    ("geometry.fit", help)
                } else {
                    ("value.range", "check `region`, `size` and their units")
                };
                let message = format!("block `{}`: {error}", block.name);
                self.error_at(code, &block.name, message, help);
                None
            }
        }
    }
}
