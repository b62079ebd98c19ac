//! Fragments of a spatial model: blocks that patches and bonds hold together.

use crate::frame::fragments::{Fragments, Member};
use crate::query::view::View;
use crate::state::patches::flag;

impl View<'_> {
    /// Fragments now, the largest first. A patch or facet holds while a point of it has not failed; one without tensile
    /// strength and cohesion holds nothing, an elastic one always.
    #[must_use]
    pub fn fragments(&self) -> Fragments {
        let world = self.world;
        let blocks: Vec<_> = (0..world.alive.len())
            .map(|b| {
                let at = self.position(b) + world.setup.origin;
                world.alive[b].then(|| Member {
                    size: world.solid_of(b).volume,
                    centre: at.to_array(),
                    held: !world.is_free(b),
                })
            })
            .collect();
        let list = &world.patches;
        let patches = (0..list.len()).filter_map(|p| {
            let joint = &world.setup.interfaces[self.patch_class(p).row as usize].joint;
            let holds = joint.strength.as_ref().is_none_or(|s| s.tension > 0.0 || s.cohesion > 0.0);
            let whole = list.flags[p] & flag::BROKEN != flag::BROKEN;
            (holds && whole).then_some(list.ends[p])
        });
        let facets = self.deformables().into_iter().flat_map(|(deform, _)| {
            deform.facets.iter().filter_map(|facet| {
                let law = world.setup.interfaces[usize::from(facet.row)].bond.as_ref()?;
                let holds =
                    law.strength.as_ref().is_none_or(|s| s.tension > 0.0 || s.cohesion > 0.0);
                let points = &deform.memory[facet.points()];
                let whole = points.iter().any(|m| !m.state.is_broken());
                (holds && whole).then_some(facet.blocks)
            })
        });
        Fragments::new(&blocks, patches.chain(facets), false)
    }
}
