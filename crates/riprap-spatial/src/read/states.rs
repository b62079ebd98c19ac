//! States of the blocks, as a scene reads them for its start.

use crate::setup::rotation::rotation;
use riprap_geom::Quat;

use crate::frame::states::BlockState;
use crate::query::view::View;
use crate::state::lineage::Origin;

impl View<'_> {
    /// The states of the blocks of the scene that are there, without terrain. What blocks were split into has no name in the scene and is left out.
    #[must_use]
    pub fn states(&self) -> Vec<BlockState> {
        let world = self.world;
        let of_scene = |b: &usize| {
            let own = world.lineage.get(*b).is_none_or(|o| o.parent == Origin::NONE);
            own && !world.is_terrain(*b)
        };
        let one = |b: usize| {
            let start = world.setup.attitudes.get(b).copied();
            let turned = match self.deformable(b) {
                Some(deformable) => rotation(deformable.rotation()),
                None => self.poses().attitude(b),
            };
            let now = turned * start.unwrap_or(Quat::IDENTITY);
            // One of the two quaternions of the attitude, of unit length.
            let now = if now.w < 0.0 { -now } else { now }.normalize();
            let place = self.position(b) + world.setup.origin;
            let mut numbers = place.to_array().to_vec();
            numbers.extend([now.w, now.x, now.y, now.z]);
            numbers.extend(self.velocity(b).to_array());
            numbers.extend(self.spin(b).to_array());
            BlockState { name: world.name(b), numbers }
        };
        self.living().filter(of_scene).map(one).collect()
    }
}
