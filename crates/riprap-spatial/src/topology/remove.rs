//! Taking blocks out.

use crate::faces::overlap::bare;
use crate::push::charge;
use crate::state::event::EditKind;
use crate::state::patches::flag;
use crate::state::world::World;
use crate::topology::bolts;

/// Removes blocks, with what they share with others: joints, bonds, bolts, walls of cavities. Faces that they shared become free. Lay out
/// and evaluate anew afterwards.
pub fn remove(world: &mut World, blocks: &[u32]) {
    for &b in blocks {
        if std::mem::replace(&mut world.alive[b as usize], false) {
            let event = world.event(EditKind::Removed, b);
            world.events.push(event);
        }
    }
    let gone = orphans(world);
    let mut bared = Vec::new();
    for &p in &gone {
        let ends = world.patches.ends[p];
        let broken = (world.patches.flags[p] & flag::BROKEN).count_ones();
        world.failed.add(ends, u64::from(broken));
        if let Some(side) = ends.iter().position(|b| world.alive[*b as usize]) {
            bared.push(bare(world, p, side));
        }
    }
    world.patches.drop_some(&gone);
    let World { faces, alive, .. } = &mut *world;
    faces.retain(|f| alive[f.block as usize]);
    faces.extend(bared);
    faces.sort_by_key(|f| f.block);
    charge::drop_walls(world);
    charge::renew_surfaces(world);
    let walls = charge::walls::state(world);
    if let Some(deform) = world.deform.as_deref_mut() {
        for &block in blocks {
            for facet in deform.facets.iter().filter(|f| f.blocks.contains(&block)) {
                world.failed.add(facet.blocks, deform.failed_points(facet));
            }
            deform.retire(block);
        }
        if !blocks.is_empty() {
            charge::walls::renew(world, &walls);
        }
    }
    bolts::follow(world);
}

/// Patches of blocks that are gone.
pub(super) fn orphans(world: &World) -> Vec<usize> {
    let ends = world.patches.ends.iter().enumerate();
    let gone = ends.filter(|(_, ends)| ends.iter().any(|b| !world.alive[*b as usize]));
    gone.map(|(p, _)| p).collect()
}
