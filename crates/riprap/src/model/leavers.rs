//! Where blocks leave the model.

use riprap_geom::Vec3;

use super::builder::Builder;
use crate::plan::Leavers;
use crate::scenario::language::Phase;
use crate::scenario::vectors::InSpace;

impl Builder<'_> {
    /// Bounds of a phase for blocks that leave, in local coordinates.
    pub(super) fn leavers(&mut self, said: &Phase) -> Option<Leavers> {
        let bounds = said.leavers.as_ref()?;
        let local = |place: [f64; 3]| Vec3::from(self.local3(place));
        let outside = bounds.outside.as_ref();
        let beyond = bounds.beyond.as_ref();
        let found = Leavers {
            outside: outside.map(|of| [local(of.min.xyz()), local(of.max.xyz())]),
            beyond: beyond.map(|of| [local(of.at.xyz()), Vec3::from(of.normal.xyz())]),
        };
        let span = outside.map(|of| &of.min.span).or(beyond.map(|of| &of.at.span))?.clone();
        let of = &said.name;
        if found.beyond.is_some_and(|[_, normal]| normal.length() == 0.0) {
            let message =
                format!("the normal of the plane that blocks of phase `{of}` leave over is zero");
            self.error_at(
                "phase.leavers",
                span.clone(),
                message,
                "give it a direction: out of the model",
            );
        }
        let first = self.parsed.scenario.phases.first();
        let (held, deforms) = (self.with_support(), self.deforming_blocks());
        let places = self.directory.centroids.iter().map(|c| Vec3::from(*c));
        let gone = |(b, place): &(usize, Vec3)| {
            !held[*b] && !deforms.get(*b).is_some_and(|is| *is) && found.take(*place)
        };
        let gone: Vec<usize> = places.enumerate().filter(gone).map(|(b, _)| b).collect();
        if let Some(&b) =
            gone.first().filter(|_| first.is_some_and(|first| std::ptr::eq(first, said)))
        {
            let name = self.directory.name(b as u32).to_owned();
            let message = format!(
                "blocks ({}) leave the model in phase `{of}` before anything moves, `{name}` first",
                gone.len()
            );
            let help = "give `outside` a box that holds the whole model, and `beyond` a normal that points out of it";
            self.error_at("phase.leavers", span.clone(), message, help);
        }
        if deforms.contains(&true) {
            let message =
                format!("`leavers` of phase `{of}` take rigid blocks alone: deformable ones stay");
            self.warn_at("phase.leavers", span, message, "let blocks that are thrown be rigid");
        }
        Some(found)
    }

    /// Whether each block has a support.
    fn with_support(&self) -> Vec<bool> {
        let mut held = match self.space {
            InSpace::Planar => vec![false; self.directory.centroids.len()],
            InSpace::Spatial => self.wholly_driven(&[]),
        };
        let planar = self.setup.supports.iter().flat_map(|support| &support.blocks);
        let spatial = self.spatial.supports.iter().flat_map(|support| &support.blocks);
        planar.chain(spatial).for_each(|b| held[*b as usize] = true);
        held
    }
}
