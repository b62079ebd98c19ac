//! Standing water: its push on blocks, and its pressure at contacts and joints ([`crate::laws::water`]).

use riprap_geom::{Vec2, Vec3};

use super::convex::Turned;
use super::loads::Applied;
use super::scratch::Scratch;
use super::seepage;
use super::setup::WaterTable;
use super::shapes::Shapes;
use super::world::World;

impl World {
    /// The water table that stands now.
    #[must_use]
    pub fn table(&self) -> Option<&WaterTable> {
        self.setup.water.get(usize::from(self.water?))
    }

    /// Pressure of the water at a place (local, m), Pa; 0 above the table and without one.
    #[must_use]
    pub fn pore_pressure(&self, at: Vec2) -> f64 {
        let table = self.table();
        table.map_or(0.0, |table| table.pressure(-self.gravity.y, Vec3::new(at.x, 0.0, at.y)))
    }
}

/// Force (N/m) and moment about the centroid (N) of the water on a block; nothing without a table.
#[must_use]
pub(crate) fn on_block(world: &World, shapes: &Shapes, turned: &[Turned], b: usize) -> Applied {
    let Some(table) = world.table() else {
        return Applied::default();
    };
    if table.seepage.is_some() {
        return seepage::on_block(world, b);
    }
    let edges = &turned[shapes.range(b)];
    let (force, moment) = table.on_polygon(
        -world.gravity.y,
        world.bodies[b].position,
        shapes.radius[b],
        shapes.mass[b] / world.setup.blocks[b].density,
        edges.len(),
        |k| edges[k].start,
        &|r| {
            let (s, c) = libm::sincos(world.bodies[b].angle);
            shapes.centroid[b] + Vec2::new(c * r.x + s * r.y, c * r.y - s * r.x)
        },
    );
    Applied { force, moment }
}

/// Adds the push of the water to what is applied to the blocks; its work counts as that of loads.
pub(super) fn apply(world: &World, scratch: &mut Scratch) {
    if world.water.is_none() {
        return;
    }
    if world.seeping().is_some() {
        seepage::apply(world, &mut scratch.applied);
        return;
    }
    let (shapes, turned) = (&scratch.shapes, &scratch.turned);
    scratch.exec.chunks(&mut scratch.applied, |first, applied| {
        for (k, applied) in applied.iter_mut().enumerate() {
            if world.alive[first + k] {
                let push = on_block(world, shapes, turned, first + k);
                applied.force += push.force;
                applied.moment += push.moment;
            }
        }
    });
}
