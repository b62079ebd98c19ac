//! Taking blocks out gradually: what they did to each of those that stay goes on acting as a load that fades to nothing.
//!
//! It is what a block, or a node of a deformable one, loses when they are gone, found by evaluating before and after, so that it
//! holds for joints, bonds and contacts alike and the state is the same at first.

use riprap_geom::Vec3;

use crate::dynamics::TimeFunction;
use crate::setup::{Load, LoadKind};
use crate::state::scratch::{NonFinite, Scratch};
use crate::state::world::World;
use crate::step;
use crate::step::Damping;
use crate::topology::remove::remove;

/// Share of the largest force that was lost up to which a difference is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Force (N) and moment (N m) on each rigid block, and force on each node.
fn forces(world: &World, scratch: &Scratch) -> [Vec<[Vec3; 2]>; 2] {
    let rigid = |b: usize| match world.alive[b] && !world.deforms(b) {
        true => [scratch.net.force(b), scratch.net.moment(b)],
        false => [Vec3::ZERO; 2],
    };
    let nodes = scratch.deform.iter().flat_map(|work| &work.net);
    let nodes = nodes.map(|f| [Vec3::from(*f), Vec3::ZERO]);
    [(0..world.alive.len()).map(rigid).collect(), nodes.collect()]
}

/// Removes blocks; the forces that they gave to others fade over `span` (s). Call it between [`step::evaluate`] and
/// [`step::advance`]; lay out and evaluate anew afterwards.
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
    let before = forces(world, scratch);
    remove(world, blocks);
    scratch.invalidate(world);
    step::evaluate(world, scratch, damping, 0.0)?;
    let after = forces(world, scratch);
    let lost = |kind: usize, k: usize| [0, 1].map(|x| before[kind][k][x] - after[kind][k][x]);
    let rigid = (0..world.alive.len()).filter(|b| world.alive[*b] && !world.deforms(*b));
    let rigid = rigid.map(|b| (b as u32, None, lost(0, b)));
    let nodes = world.deform.iter().flat_map(|deform| {
        let all = deform.living().flat_map(|body| body.nodes().map(|n| (body.block, n)));
        all.map(|(block, n)| (block, Some(deform.nodes.place[n]), lost(1, n)))
    });
    let fade = TimeFunction::fade(world.time, span);
    let mut loads = Vec::new();
    for some in [rigid.collect::<Vec<_>>(), nodes.collect()] {
        let size = |block: u32, [force, moment]: [Vec3; 2]| {
            force.length() + moment.length() / world.solid_of(block as usize).radius
        };
        let largest = some.iter().map(|(b, _, lost)| size(*b, *lost)).fold(0.0, f64::max);
        for (block, at, lost) in some {
            if size(block, lost) <= ROUND_OFF * largest {
                continue;
            }
            let [force, moment] = lost;
            let moment = at.is_none().then_some(LoadKind::Moment { moment });
            let kinds = std::iter::once(LoadKind::Point { force, at }).chain(moment);
            let load = |kind| Load { blocks: vec![block], kind, time: fade.clone(), account: None };
            loads.extend(kinds.map(load));
        }
    }
    world.setup.loads.extend(loads);
    Ok(())
}
