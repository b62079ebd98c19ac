//! What pairs of blocks of cells exert on each other in a step.

use riprap_core::sums::{GROUP, tree};
use riprap_geom::{Mat3, Vec3};

use crate::contact::deformable::law::{Asked, Sides, respond};
use crate::contact::deformable::limit;
use crate::contact::pose;
use crate::kernel::cells::{
    CellPatch, Member, PairConstants, PairSlot, PairWorkspace, Spot, TetFan,
};
use crate::kernel::grid::Box3;
use crate::kernel::springs::stored;
use crate::kernel::{Pose, Terrain};
use crate::state::bodies::Bodies;
use crate::state::deform::Deform;
use crate::state::deformable::{DeformableMemory, DeformablePair};
use crate::state::scratch::Scratch;
use crate::state::workspace::Workspace;
use crate::state::world::World;

/// Finds what all pairs exert and pushes blocks and nodes with it, in the order of the pairs.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch) {
    let Scratch { deformable: desk, desk: rigid, deform: work, exec, pushes, .. } = scratch;
    let World {
        found, deform, bodies, turned, reference, alive, works, pending, start_energy, ..
    } = &mut *world;
    let (Some(deform), Some(work)) = (deform.as_deref(), work.as_deref()) else {
        return;
    };
    let members = &desk.members;
    exec.chunks(&mut desk.stars, |first, stars| {
        for (k, star) in stars.iter_mut().enumerate() {
            let member = &members[first + k];
            let pose = || pose(bodies, turned, reference, member.block as usize);
            put(pose, deform, work, member, star);
        }
    });
    let evaluation = Evaluation {
        bodies,
        deform,
        work,
        members,
        stars: &desk.stars,
        constants: &desk.constants,
        grounds: &rigid.terrain.grounds,
        dt: *pending,
        relaxing: deform.relax.is_some(),
    };
    desk.sums.clear();
    desk.sums.resize(desk.slots.len().div_ceil(GROUP), [0.0; 3]);
    exec.groups2(
        &mut found.deformable.pairs,
        &mut desk.slots,
        &mut desk.sums,
        &mut desk.workspaces,
        |first, pairs, slots, sums, workspace| {
            [workspace.friction, workspace.damping, workspace.brought] = [0.0; 3];
            for (k, (pair, slot)) in pairs.iter_mut().zip(slots).enumerate() {
                evaluation.pair(first + k, pair, slot, workspace);
            }
            *sums = [workspace.friction, workspace.damping, workspace.brought];
        },
    );
    let own = &mut pushes.own;
    own.need_blocks(alive.len());
    own.need_nodes(deform.nodes.len());
    for (slot, constants) in desk.slots.iter().zip(&desk.constants) {
        if !slot.touching {
            continue;
        }
        for (forces, member) in slot.forces.iter().zip(constants.members) {
            let member = &desk.members[member as usize];
            match member.body {
                Some(k) => {
                    let first = deform.bodies[k as usize].first;
                    for (node, f) in forces.iter().enumerate() {
                        own.on_node(first + node as u32, *f);
                    }
                }
                None => own.on_block(member.block, forces[0], forces[1]),
            }
        }
    }
    tree(&mut desk.sums, |sum, other| {
        for (sum, other) in sum.iter_mut().zip(other) {
            *sum += other;
        }
    });
    let [friction, damping, brought] = desk.sums.first().copied().unwrap_or_default();
    works.friction += friction;
    works.damping += damping;
    // What stands pressed at the start of a run is part of the energy that it starts with.
    if start_energy.is_some() {
        works.edit_defect += brought;
    }
    let longest = limit::longest_step(world, desk);
    let deformable = &mut world.found.deformable;
    deformable.longest_step = deformable.longest_step.map(|limit| limit.min(longest));
}

/// Puts a star where its block is now.
fn put(
    pose: impl Fn() -> Pose,
    deform: &Deform,
    work: &Workspace,
    member: &Member,
    star: &mut TetFan,
) {
    match member.body {
        Some(k) => {
            let body = &deform.bodies[k as usize];
            let place = |n: u32| {
                let n = (body.first + n) as usize;
                deform.nodes.place[n] + Vec3::from_array(deform.nodes.displacement[n])
            };
            let class = work.class(body);
            star.put(class.depths(), &class.mesh.tets, place(body.count - 1), place);
        }
        None => {
            let Some((field, nodes)) = &member.rigid else {
                return;
            };
            let pose = pose();
            let turn = Mat3::from_quat(pose.rotation);
            let place = |n: u32| pose.position + turn * nodes[n as usize];
            star.put(field, &[], pose.position, place);
        }
    }
}

struct Evaluation<'a> {
    bodies: &'a Bodies,
    deform: &'a Deform,
    work: &'a Workspace,
    members: &'a [Member],
    stars: &'a [TetFan],
    constants: &'a [PairConstants],
    grounds: &'a [Terrain],
    dt: f64,
    relaxing: bool,
}

impl Evaluation<'_> {
    /// Whether the centre of a block lies below terrain.
    fn is_below(&self, constants: &PairConstants) -> bool {
        let Some(ground) = constants.ground else {
            return false;
        };
        let blocks = constants.members.iter().map(|m| *m as usize);
        let mut blocks = blocks.filter(|m| self.members[*m].body.is_some());
        let depth = |m: usize| self.grounds[ground as usize].depth(self.stars[m].origin);
        blocks.any(|m| depth(m).is_some_and(|depth| depth > 0.0))
    }

    fn pair(
        &self,
        k: usize,
        pair: &mut DeformablePair,
        slot: &mut PairSlot,
        workspace: &mut PairWorkspace,
    ) {
        let constants = &self.constants[k];
        let stars = constants.members.map(|m| &self.stars[m as usize]);
        let sides = Sides {
            deform: self.deform,
            bodies: self.bodies,
            work: self.work,
            members: constants.members.map(|m| &self.members[m as usize]),
        };
        let known = std::mem::replace(&mut pair.known, true);
        let before = std::mem::take(&mut pair.energy);
        if stars[0].bounds.meets(&stars[1].bounds) {
            press(stars, &sides, constants.law.normal_stiffness, pair, slot, workspace);
        } else {
            slot.touching = false;
        }
        let surfaceless = slot.patches.iter().all(|patch| patch.surface.weight == 0.0);
        if !stars.iter().all(|star| star.sound)
            || slot.touching && surfaceless && self.is_below(constants)
        {
            // How deep they lie cannot be found: a stop, with their names.
            pair.depth = f64::INFINITY;
        }
        if !known {
            // Pairs that meet on their way are listed before they touch.
            workspace.brought += pair.energy - before;
        }
        if !slot.touching {
            workspace.friction += pair.stored;
            let depth = if pair.depth == f64::INFINITY { pair.depth } else { 0.0 };
            *pair =
                DeformablePair { ends: pair.ends, known: true, depth, ..DeformablePair::default() };
            slot.spots.clear();
            slot.patches.clear();
            return;
        }
        let mut law = constants.law;
        // A relaxation damps by itself, and its velocities are none in time.
        if self.relaxing {
            law.damping_ratio = 0.0;
        }
        let stored = pair.stored;
        for patch in &slot.patches {
            pair.contact(patch.key);
        }
        pair.contacts.retain(|c| slot.patches.iter().any(|patch| patch.key == c.key));
        let reply = respond(
            &law,
            &Asked { sides, facets: constants.ground.is_some(), dt: self.dt },
            slot,
            &mut workspace.shares,
            &mut pair.contacts,
        );
        pair.stored = reply.stored;
        // What the springs store of the work on them is not lost yet.
        workspace.friction += reply.friction - (reply.stored - stored);
        workspace.damping += reply.damping;
        for spot in &slot.spots {
            let force = spot.spring + spot.drag;
            pair.force += spot.spring;
            for (side, forces) in slot.forces.iter_mut().enumerate() {
                let (weights, arm) = (&spot.weights[side], spot.arms[side]);
                let own = [-force, force][side];
                sides.add(side, forces, spot.cells[side], weights, arm, own);
            }
        }
    }
}

/// Pressure of a pair: forces, energy, the surface of equal depth and the spots of friction on it.
fn press(
    stars: [&TetFan; 2],
    sides: &Sides,
    stiffness: f64,
    pair: &mut DeformablePair,
    slot: &mut PairSlot,
    workspace: &mut PairWorkspace,
) {
    let common = Box3 {
        low: stars[0].bounds.low.max(stars[1].bounds.low),
        high: stars[0].bounds.high.min(stars[1].bounds.high),
    };
    for (list, star) in workspace.lists.iter_mut().zip(stars) {
        list.clear();
        let boxes = star.boxes.iter().enumerate();
        list.extend(boxes.filter(|(_, b)| b.meets(&common)).map(|(k, _)| k as u32));
    }
    // About the centre of the first block: far from the origin overlaps would lose their digits.
    let shift = stars[1].origin - stars[0].origin;
    workspace.shifted.clear();
    let second = workspace.lists[1].iter().map(|k| stars[1].cells[*k as usize].shifted(shift));
    workspace.shifted.extend(second);
    slot.forces.iter_mut().for_each(|list| list.fill(Vec3::ZERO));
    slot.spots.clear();
    slot.patches.clear();
    slot.touching = false;
    pair.force = Vec3::ZERO;
    pair.depth = 0.0;
    let scale = 2.0 * stiffness;
    for &i in &workspace.lists[0] {
        let (first, around) = (&stars[0].cells[i as usize], &stars[0].boxes[i as usize]);
        for (&j, second) in workspace.lists[1].iter().zip(&workspace.shifted) {
            if !around.meets(&stars[1].boxes[j as usize]) {
                continue;
            }
            let Some(overlap) = workspace.overlapping.overlap([first, second]) else {
                continue;
            };
            slot.touching = true;
            let keys = [stars[0].keys.get(i as usize), stars[1].keys.get(j as usize)];
            let key = keys[0].or(keys[1]).copied().unwrap_or(0);
            let patch = patch_of(&mut slot.patches, key);
            let keyed = if keys[0].is_some() { first } else { second };
            patch.plane = (keyed.slope, keyed.level);
            for (side, (cell, number)) in [(first, i), (second, j)].into_iter().enumerate() {
                let half = &overlap.halves[side];
                if half.volume == 0.0 {
                    continue;
                }
                pair.energy += scale * half.volume * cell.depth(half.centroid);
                let force = scale * half.volume * cell.slope;
                if side == 1 {
                    pair.force += force;
                }
                let arm = [half.centroid, half.centroid - shift][side];
                let weights = cell.weights(half.centroid);
                sides.add(side, &mut slot.forces[side], number, &weights, arm, force);
            }
            let surface = &overlap.surface;
            if surface.weight > 0.0 {
                patch.surface.add(surface);
                let pressure = scale * surface.weight;
                patch.elastic += pressure / surface.vector.length() * surface.vector;
                let at = surface.weight_first / surface.weight;
                slot.spots.push(Spot {
                    key,
                    cells: [i, j],
                    weights: [first.weights(at), second.weights(at)],
                    arms: [at, at - shift],
                    pressure,
                    ..Spot::default()
                });
                let slopes = [first, second].map(|c| c.slope.length());
                // A depth over its slope is a length, and the blocks lie in each other by both.
                let deep = surface.depth * (1.0 / slopes[0] + 1.0 / slopes[1]);
                patch.depth = patch.depth.max(deep);
                pair.depth = pair.depth.max(deep);
            }
        }
    }
    if let [only] = slot.patches.as_mut_slice() {
        // As exact as the nodal forces, which it has to agree with.
        only.elastic = pair.force;
    }
    sort(slot);
}

/// The contact with this key, a new one where there is none.
fn patch_of(patches: &mut Vec<CellPatch>, key: u32) -> &mut CellPatch {
    let known = patches.iter().position(|patch| patch.key == key).unwrap_or_else(|| {
        patches.push(CellPatch { key, ..CellPatch::default() });
        patches.len() - 1
    });
    &mut patches[known]
}

/// Puts contacts in the order of their keys, and the spots of each together.
fn sort(slot: &mut PairSlot) {
    let PairSlot { patches, spots, .. } = slot;
    if patches.len() > 1 {
        patches.sort_by_key(|patch| patch.key);
        spots.sort_by_key(|spot| spot.key);
    }
    let mut first = 0;
    for patch in patches {
        let end = first + spots[first..].iter().take_while(|s| s.key == patch.key).count();
        patch.spots = first..end;
        first = end;
    }
}

/// Books what friction and dashpots do in the half step after the present time, with the velocities that the kick has made.
pub(crate) fn depart(world: &mut World, scratch: &Scratch, dt: f64) {
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref()) else {
        return;
    };
    let desk = &scratch.deformable;
    let [mut friction, mut damping] = [0.0; 2];
    for (slot, constants) in desk.slots.iter().zip(&desk.constants) {
        if slot.spots.is_empty() {
            continue;
        }
        let sides = Sides {
            deform,
            bodies: &world.bodies,
            work,
            members: constants.members.map(|m| &desk.members[m as usize]),
        };
        for spot in &slot.spots {
            let velocity = sides.relative_velocity(spot);
            friction -= 0.5 * dt * spot.spring.dot(velocity);
            damping -= 0.5 * dt * spot.drag.dot(velocity);
        }
    }
    world.works.friction += friction;
    world.works.damping += damping;
}

impl DeformableMemory {
    /// A contact without memory.
    pub(super) fn forget(&mut self) {
        *self = Self::default();
    }

    /// Energy in shear springs of this stiffness (Pa/m), J.
    pub(super) fn stored(&self, stiffness: f64) -> f64 {
        stored(stiffness, self.shear, self.torsion, [self.area, self.polar])
    }
}
