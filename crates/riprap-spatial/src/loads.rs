//! External loads: forces and moments on blocks, per step.

use riprap_geom::Vec3;

use super::setup::LoadKind;
use super::state::push::Push;
use super::world::World;

/// Sums all loads at the world's present time into `applied` (one entry per block).
pub fn apply(world: &World, applied: &mut [Push]) {
    applied.fill(Push::default());
    for load in &world.setup.loads {
        let factor = load.time.at(world.time);
        for &b in &load.blocks {
            let b = b as usize;
            if !world.alive[b] || world.deforms(b) {
                continue;
            }
            let slot = &mut applied[b];
            match &load.kind {
                LoadKind::Point { force, at } => {
                    let force = factor * *force;
                    slot.force += force;
                    if let Some(at) = at {
                        let arm = *at - world.reference[b];
                        let arm: Vec3 = match &world.turned[b] {
                            Some(turned) => turned.attitude * arm,
                            None => arm,
                        };
                        slot.moment += arm.cross(force);
                    }
                }
                LoadKind::Moment { moment } => slot.moment += factor * *moment,
                LoadKind::BodyForce { acceleration } => {
                    slot.force += factor * world.solid_of(b).mass * *acceleration;
                }
            }
        }
    }
}
