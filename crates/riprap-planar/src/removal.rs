//! Taking blocks out, at once or gradually.
//!
//! Gradually: what the blocks that go did to each of those that stay, a force and a moment, goes on acting as a load that fades to nothing.
//! It is what the block loses when they are gone, found by evaluating before and after, so that it holds for joints and
//! contacts alike and the state is the same at first.

use super::bolts;
use super::scratch::{Net, NonFinite, Scratch};
use super::setup::{Load, LoadKind};
use super::step::{self, Damping};
use super::world::World;
use crate::dynamics::TimeFunction;

/// Share of the largest force that was lost up to which a difference is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Removes blocks and their joints; candidate lists must be built anew afterwards.
pub fn take_out(world: &mut World, blocks: &[u32]) {
    if !blocks.is_empty() {
        // Their joints are open faces now.
        world.seepage = None;
    }
    for &b in blocks {
        world.alive[b as usize] = false;
    }
    let World { alive, bonds, failed, .. } = world;
    bonds.retain(|k| {
        let stays = alive[k.i as usize] && alive[k.j as usize];
        if !stays {
            failed.add([k.i, k.j], k.failed_points());
        }
        stays
    });
}

/// Removes blocks; the forces that they gave to others fade over `span` (s). Call it between [`step::evaluate`] and
/// [`step::advance`]; evaluate anew afterwards.
///
/// # Errors
/// A block with forces that are not finite.
pub fn take_out_gradually(
    world: &mut World,
    scratch: &mut Scratch,
    blocks: &[u32],
    span: f64,
    damping: &Damping,
) -> Result<(), NonFinite> {
    let before: Vec<Net> = scratch.net.clone();
    take_out(world, blocks);
    bolts::follow(world);
    scratch.invalidate(world);
    step::evaluate(world, scratch, damping, 0.0)?;
    let lost = |b: usize| Net {
        force: before[b].force - scratch.net[b].force,
        moment: before[b].moment - scratch.net[b].moment,
    };
    let size =
        |b: usize, net: &Net| net.force.length() + net.moment.abs() / scratch.shapes.radius[b];
    let living = (0..world.alive.len()).filter(|b| world.alive[*b]);
    let lost: Vec<(usize, Net)> = living.map(|b| (b, lost(b))).collect();
    let largest = lost.iter().map(|(b, net)| size(*b, net)).fold(0.0, f64::max);
    let fade = TimeFunction::fade(world.time, span);
    for (b, net) in lost {
        if size(b, &net) > ROUND_OFF * largest {
            let force = LoadKind::Point { force: net.force, at: None, follows: false };
            let moment = LoadKind::Moment { moment: net.moment };
            world.setup.loads.extend([force, moment].map(|kind| Load {
                blocks: vec![b as u32],
                kind,
                time: fade.clone(),
                account: None,
            }));
        }
    }
    Ok(())
}
