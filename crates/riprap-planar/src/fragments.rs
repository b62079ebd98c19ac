//! Fragments of a planar model: blocks that joints hold together.

use super::search::is_held;
use super::view::View;
use crate::frame::fragments::{Fragments, Member};

impl View<'_> {
    /// Fragments now, the largest first. A joint holds while a point of it has not failed; one without tensile
    /// strength and cohesion holds nothing.
    #[must_use]
    pub fn fragments(&self) -> Fragments {
        let world = self.world;
        let blocks: Vec<_> = (0..world.alive.len())
            .map(|b| {
                let size = self.scratch.shapes.mass[b] / world.setup.blocks[b].density;
                let at = world.bodies[b].position;
                world.alive[b].then(|| Member {
                    size,
                    centre: [at.x, at.y, 0.0],
                    held: is_held(world.motion[b].as_deref()),
                })
            })
            .collect();
        let holds = |row: u16| {
            let law = world.setup.interfaces[usize::from(row)].bond.as_ref();
            law.is_some_and(|l| l.strength.tension > 0.0 || l.strength.cohesion > 0.0)
        };
        let joined = world.bonds.iter().filter_map(|bond| {
            let whole = bond.active && !bond.torn && bond.points.iter().any(|p| !p.failed);
            (whole && holds(bond.row)).then_some([bond.i, bond.j])
        });
        Fragments::new(&blocks, joined, true)
    }
}
