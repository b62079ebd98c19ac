//! States of the blocks, as a scene reads them for its start.

use super::view::View;
use crate::frame::states::BlockState;

impl View<'_> {
    /// The states of all blocks that are there.
    #[must_use]
    pub fn states(&self) -> Vec<BlockState> {
        let setup = &self.world.setup;
        let one = |b: usize| {
            let (body, velocity) = (&self.world.bodies[b], self.velocity(b));
            let start = setup.angles.get(b).copied().unwrap_or(0.0);
            BlockState {
                name: setup.blocks[b].name.clone(),
                numbers: vec![
                    body.position.x + setup.origin[0],
                    body.position.y + setup.origin[1],
                    body.angle + start,
                    velocity.x,
                    velocity.y,
                    self.spin(b),
                ],
            }
        };
        self.living().map(one).collect()
    }
}
