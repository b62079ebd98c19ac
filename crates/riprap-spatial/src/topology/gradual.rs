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
use crate::topology::remove;

/// Share of the largest force that was lost up to which a difference is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Forces on blocks and nodes.
struct Forces {
    /// Force (N) and moment (N m) of each rigid block.
    blocks: Vec<[Vec3; 2]>,
    /// Force on each node, N.
    nodes: Vec<Vec3>,
}

impl Forces {
    fn of(world: &World, scratch: &Scratch) -> Self {
        let rigid = |b: usize| match world.alive[b] && !world.deforms(b) {
            true => [scratch.net.force(b), scratch.net.moment(b)],
            false => [Vec3::ZERO; 2],
        };
        let nodes = scratch.deform.iter().flat_map(|work| &work.net);
        Self {
            blocks: (0..world.alive.len()).map(rigid).collect(),
            nodes: nodes.map(|f| Vec3::from(*f)).collect(),
        }
    }
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
    let before = Forces::of(world, scratch);
    remove(world, blocks);
    scratch.invalidate(world);
    step::evaluate(world, scratch, damping, 0.0)?;
    let after = Forces::of(world, scratch);
    let fade = TimeFunction::fade(world.time, span);
    let mut loads = Vec::new();
    let mut push = |block: usize, kind: LoadKind| {
        loads.push(Load { blocks: vec![block as u32], kind, time: fade.clone(), account: None });
    };
    let lost = |b: usize| [0, 1].map(|k| before.blocks[b][k] - after.blocks[b][k]);
    let size = |b: usize, [force, moment]: [Vec3; 2]| {
        force.length() + moment.length() / world.solid_of(b).radius
    };
    let rigid: Vec<usize> =
        (0..world.alive.len()).filter(|b| world.alive[*b] && !world.deforms(*b)).collect();
    let largest = rigid.iter().map(|&b| size(b, lost(b))).fold(0.0, f64::max);
    for b in rigid {
        let [force, moment] = lost(b);
        if size(b, [force, moment]) > ROUND_OFF * largest {
            push(b, LoadKind::Point { force, at: None });
            push(b, LoadKind::Moment { moment });
        }
    }
    if let Some(deform) = world.deform.as_deref() {
        let lost = |n: usize| before.nodes[n] - after.nodes[n];
        let nodes = deform.bodies.iter().filter(|body| body.alive);
        let nodes: Vec<(usize, usize)> =
            nodes.flat_map(|body| body.nodes().map(|n| (body.block as usize, n))).collect();
        let all = nodes.iter().map(|(_, n)| lost(*n).length());
        let largest = all.fold(0.0, f64::max);
        for (block, n) in nodes {
            let force = lost(n);
            if force.length() > ROUND_OFF * largest {
                let at = Some(deform.nodes.place[n]);
                push(block, LoadKind::Point { force, at });
            }
        }
    }
    world.setup.loads.extend(loads);
    Ok(())
}
