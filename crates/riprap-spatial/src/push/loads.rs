//! Given forces, moments and accelerations on blocks.

use riprap_geom::Vec3;

use crate::laws::transfer;
use crate::setup::{Load, LoadKind};
use crate::state::deform::{Body, Deform};
use crate::state::push::{Account, Wrench};
use crate::state::workspace::{BlockClass, Workspace};
use crate::state::world::World;

/// What a load pushes, and how.
pub(crate) enum Pushed {
    /// A rigid block.
    Block(u32, Wrench),
    /// A node, with a force (N).
    Node(u32, Vec3),
}

/// Pushes blocks with all loads at the world's present time but those that are found later in the evaluation.
pub(crate) fn apply(world: &World, work: Option<&Workspace>, half: [f64; 2], loads: &mut Account) {
    let nodes = world.deform.as_deref().map_or(0, |d| d.nodes.len());
    each(world, work, half, |load, pushed| match pushed {
        _ if matches!(load.kind, LoadKind::Own { .. }) => {}
        Pushed::Block(b, push) => {
            loads.need_blocks(world.alive.len());
            loads.on_block(b, push.force, push.moment);
        }
        Pushed::Node(node, force) => {
            loads.need_nodes(nodes);
            loads.on_node(node, force);
        }
    });
}

/// Pushes blocks with what laws of code have found.
pub(crate) fn apply_own(world: &World, loads: &mut Account) {
    for load in &world.setup.loads {
        let LoadKind::Own { wrenches } = &load.kind else {
            continue;
        };
        loads.need_blocks(world.alive.len());
        for (b, [force, moment]) in (0..world.alive.len() as u32).zip(wrenches) {
            if world.alive[b as usize] {
                loads.on_block(b, *force, *moment);
            }
        }
    }
}

/// Hands over every load with what it pushes, in the kick that spans the `half` steps (s) before and after the world's present time.
pub(crate) fn each(
    world: &World,
    work: Option<&Workspace>,
    half: [f64; 2],
    mut put: impl FnMut(&Load, Pushed),
) {
    for load in &world.setup.loads {
        let factor = load.time.in_kick(world.time, half);
        // What was released by and by is gone.
        if factor == 0.0 {
            continue;
        }
        for &b in load.blocks.iter().filter(|b| world.alive[**b as usize]) {
            let deformable = world.deform.as_deref().zip(work);
            let deformable = deformable
                .and_then(|(deform, work)| Some((deform, deform.body(b as usize)?, work)));
            match deformable {
                None => put(load, Pushed::Block(b, on_rigid(world, &load.kind, factor, b))),
                Some((deform, body, work)) => {
                    let kind = work.class(body);
                    on_nodes(deform, body, kind, &load.kind, factor, |node, force| {
                        put(load, Pushed::Node(node, force));
                    });
                }
            }
        }
    }
}

/// A load on a rigid block.
fn on_rigid(world: &World, load: &LoadKind, factor: f64, b: u32) -> Wrench {
    let mut push = Wrench::default();
    match load {
        LoadKind::Point { force, at } => {
            push.force = factor * *force;
            if let Some(at) = at {
                let arm = world.all_freedoms().arm(b, *at - world.reference[b as usize]);
                push.moment = arm.cross(push.force);
            }
        }
        LoadKind::Moment { moment } => push.moment = factor * *moment,
        LoadKind::BodyForce { acceleration } => {
            push.force = factor * world.solid_of(b as usize).mass * *acceleration;
        }
        // A rigid block has none.
        LoadKind::Nodes { .. } => {}
        LoadKind::Own { wrenches } => {
            let [force, moment] = wrenches.get(b as usize).copied().unwrap_or_default();
            push = Wrench { force, moment };
        }
    }
    push
}

/// A load on a deformable block: an acceleration or a force without a point is shared by mass, a force at a point goes
/// to the tetrahedron that holds it.
fn on_nodes(
    deform: &Deform,
    body: &Body,
    kind: &BlockClass,
    load: &LoadKind,
    factor: f64,
    mut put: impl FnMut(u32, Vec3),
) {
    let (first, masses) = (body.first, kind.masses());
    match load {
        LoadKind::BodyForce { acceleration } => {
            for (node, m) in (first..).zip(masses) {
                put(node, factor * *m * *acceleration);
            }
        }
        LoadKind::Point { force, at: None } => {
            let total: f64 = masses.iter().sum();
            for (node, m) in (first..).zip(masses) {
                put(node, factor * *m / total * *force);
            }
        }
        LoadKind::Point { force, at: Some(at) } => {
            let centre = deform.nodes.place[first as usize + kind.mesh.nodes.len() - 1];
            let all = 0..kind.mesh.tets.len();
            let (place, _) = transfer::nearest(&kind.mesh, *at - centre, all);
            for (node, weight) in place.nodes.into_iter().zip(place.weights) {
                put(first + node, factor * weight * *force);
            }
        }
        LoadKind::Nodes { forces } => {
            for (node, force) in forces {
                put(first + node, factor * *force);
            }
        }
        // Refused when the model is made: nodes take no moment, and laws of code act between rigid blocks.
        LoadKind::Moment { .. } | LoadKind::Own { .. } => {}
    }
}
