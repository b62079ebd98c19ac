//! Pins: points of blocks, as on the walls of a tunnel, and where they go.

use riprap_geom::Vec2;

use super::view::View;

impl View<'_> {
    /// Where a point of a block (m, local, at the start) was when displacements began to be measured, where it is (m, local), and its velocity
    /// (m/s). `None`: the block is gone.
    #[must_use]
    pub fn pinned(&self, block: u32, at: Vec2) -> Option<[Vec2; 3]> {
        let b = block as usize;
        if !self.world.alive[b] {
            return None;
        }
        let body = self.world.bodies[b];
        let arm = at - self.scratch.shapes.centroid[b];
        let mut first = body;
        (first.position, first.angle) = (self.world.reference[b], self.world.reference_angle[b]);
        let velocity = self.velocity(b) + self.spin(b) * body.turned(arm).perp();
        Some([first.place(arm), body.place(arm), velocity])
    }
}
