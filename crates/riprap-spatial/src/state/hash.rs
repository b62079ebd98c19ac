//! The state hash of a spatial model.

use riprap_core::state_hash::StateHash;

use crate::implicit::memory::Implicit;
use crate::kernel::offset::Offset;
use crate::kernel::{Image, Memory, Pose};
use crate::state::clock::Clock;
use crate::state::deform::{Deform, State};
use crate::state::deformable::DeformableContact;
use crate::state::found::FoundContacts;
use crate::state::patches::{Patches, flag};
use crate::state::world::World;

impl World {
    /// blake3 of motion and memory: equal hashes mean that two models go on alike, bit for bit.
    ///
    /// Covers what moves (blocks, nodes), everything that interfaces, contacts, faces with a condition, cavities, bolts and relaxing
    /// phases remember, and the poses from which the candidates were found, since the length of steps hangs on what is listed.
    /// Interfaces come in the order of their blocks, however they are stored, and lists that are empty because nothing is
    /// remembered yet count as zeros. What is only told (works, peaks, events, places that displacements are measured from) and
    /// what follows from the rest is not in it.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut hash = StateHash::default();
        hash.numbers(&[self.time, self.last_dt]);
        hash.count(self.step);
        for list in self.bodies.displacement.iter().chain(&self.bodies.velocity) {
            hash.numbers(list);
        }
        for (alive, turned) in self.alive.iter().zip(&self.turned) {
            hash.count(u64::from(*alive) | u64::from(turned.is_some()) << 1);
            if let Some(t) = turned {
                hash.numbers(&t.attitude.to_array());
                hash.numbers(&t.momentum.to_array());
            }
        }
        if let Some(found) = &self.seepage {
            hash.numbers(found.pressures.as_flattened());
        }
        if let Some(gas) = &self.gas {
            hash.numbers(&gas.masses);
            hash.numbers(&gas.fluxes);
            hash.numbers(&[gas.waits]);
            hash.count(u64::from(gas.every) << 32 | u64::from(gas.passed));
            hash.count(gas.cracks.iter().filter(|crack| crack.open).count() as u64);
        }
        self.patches(&mut hash);
        for cavity in &self.cavities {
            hash.numbers(&[
                cavity.volume,
                cavity.pressure,
                cavity.work,
                cavity.base,
                cavity.removed,
                cavity.held,
                cavity.ignited.unwrap_or(-1.0),
                cavity.venting.unwrap_or(-1.0),
            ]);
            if let Some(burn) = &cavity.burn {
                hash.numbers(&[burn.reached, burn.given, cavity.kept, cavity.known]);
            }
            if let Some(column) = &cavity.column {
                hash.numbers(&[column.way, column.speed, column.acceleration, cavity.kept]);
                hash.numbers(&[column.out.unwrap_or(-1.0), cavity.known]);
            }
            for wall in &cavity.walls {
                hash.numbers(&wall.hold.to_array());
                hash.numbers(&wall.hold_moment.to_array());
                if let Some(turned) = &wall.turned {
                    hash.numbers(&turned.normal.to_array());
                    hash.numbers(&turned.displacement.to_array());
                    hash.numbers(&[turned.area, turned.swept]);
                }
            }
        }
        for anchor in self.faces.iter().flat_map(|f| f.behind().anchor) {
            hash.numbers(&anchor.to_array());
        }
        contacts(&mut hash, &self.found);
        if let Some(memory) = &self.implicit {
            implicit(&mut hash, memory);
        }
        for bolt in &self.bolts {
            hash.count(u64::from(bolt.number));
            for list in bolt.chain.memory() {
                hash.numbers(list);
            }
            for dowel in &bolt.dowels {
                hash.numbers(&dowel.slip.to_array());
                hash.numbers(&dowel.force.to_array());
            }
        }
        if let Some(deform) = &self.deform {
            bodies(&mut hash, deform);
            bonds(&mut hash, deform);
        }
        hash.finish()
    }

    /// Patches by block i, block j, axis of the normal, and place in the lists where all these are equal.
    fn patches(&self, hash: &mut StateHash) {
        let list = &self.patches;
        let axis = |p: usize| self.classes[list.class[p] as usize].axis;
        let mut order: Vec<u32> = (0..list.len() as u32).collect();
        order.sort_by_key(|p| (list.ends[*p as usize], axis(*p as usize)));
        hash.count(order.len() as u64);
        for p in order {
            let p = p as usize;
            hash.pair(list.ends[p]);
            let memory = memory(list, p);
            // `OFFSET` only says that numbers are in use.
            let flags = u64::from(list.flags[p] & !flag::OFFSET);
            let any = memory.iter().any(|x| x.to_bits() != 0);
            hash.count(flags << 8 | u64::from(axis(p)) << 1 | u64::from(any));
            if any {
                hash.numbers(&memory);
            }
            if let Some(wear) = list.wear.get(p) {
                hash.numbers(wear.as_flattened());
            }
        }
    }
}

/// When a pair is evaluated again, and what it has got until then.
fn winding(hash: &mut StateHash, clock: &Clock) {
    hash.count(u64::from(clock.left) << 32 | u64::from(clock.every));
    hash.numbers(&[clock.at, clock.given, clock.booked]);
    for pose in &clock.poses {
        hash.numbers(&pose.position.to_array());
        hash.numbers(&pose.rotation.to_array());
    }
    for force in &clock.forces {
        for vector in [force.force, force.moment_a, force.moment_b] {
            hash.numbers(&vector.to_array());
        }
    }
}

/// Found contacts, in the order of their lists, which follows from the numbers of blocks.
fn contacts(hash: &mut StateHash, found: &FoundContacts) {
    poses(hash, &found.search.pose, &found.search.margin);
    hash.number(found.longest_step.unwrap_or(-1.0));
    hash.count(found.pairs.len() as u64);
    for pair in &found.pairs {
        hash.pair(pair.ends);
        image(hash, pair.image);
        let touches = pair.depth > 0.0;
        hash.count(
            u64::from(touches)
                | u64::from(pair.seated) << 1
                | u64::from(pair.offset.is_some()) << 2,
        );
        for faces in [pair.start, pair.next] {
            hash.count(faces.map_or(u64::MAX, |[a, b]| u64::from(a) << 16 | u64::from(b)));
        }
        hash.number(pair.gap);
        // Those of two convex blocks have no number.
        for patch in pair.patches.iter().filter(|_| touches) {
            if patch.key != [0; 2] {
                hash.pair(patch.key);
            }
            remember(hash, &patch.memory);
        }
        if let Some(offset) = &pair.offset {
            carried_on(hash, offset);
        }
        if let Some(clock) = &pair.clock {
            winding(hash, clock);
        }
    }
    for step in found.levels.iter().flat_map(|levels| &levels.joints) {
        hash.number(*step);
    }
    let deformable = &found.deformable;
    let blocks = &deformable.search.blocks;
    poses(hash, &blocks.pose, &blocks.margin);
    hash.numbers(deformable.search.displacement.as_flattened());
    hash.number(deformable.longest_step.unwrap_or(-1.0));
    hash.count(deformable.pairs.len() as u64);
    // A pair that does not touch counts as one contact without memory.
    let apart = [DeformableContact::default()];
    for pair in &deformable.pairs {
        hash.pair(pair.ends);
        let contacts = if pair.contacts.is_empty() { &apart } else { pair.contacts.as_slice() };
        for DeformableContact { key, memory: m } in contacts {
            let flags = u64::from(pair.known) | u64::from(m.sliding) << 1;
            hash.count(u64::from(*key) << 2 | flags);
            hash.numbers(&m.shear.to_array());
            hash.numbers(&m.normal.to_array());
            hash.numbers(&[m.torsion, m.area, m.polar]);
        }
    }
    for left in &found.left_terrain {
        hash.count(u64::from(*left));
    }
}

/// Which image of its second block a pair has; nothing for the block itself.
fn image(hash: &mut StateHash, image: Image) {
    if image != Image::SELF {
        for periods in image.0 {
            hash.count(periods as u64);
        }
    }
}

/// Pairs that press in an implicit phase.
fn implicit(hash: &mut StateHash, memory: &Implicit) {
    hash.count(memory.kept.len() as u64);
    for kept in &memory.kept {
        hash.pair(kept.pair.ends);
        image(hash, kept.pair.image);
        if kept.key != [0; 2] {
            hash.pair(kept.key);
        }
        hash.numbers(&kept.shear.to_array());
        hash.numbers(&kept.arm.to_array());
        hash.numbers(&[kept.torsion, kept.force, kept.area, kept.radius]);
        if kept.hidden > 0.0 || kept.due.is_some() {
            hash.numbers(&[kept.hidden, kept.due.unwrap_or(-1.0)]);
        }
    }
}

/// Where blocks were at the last search, and how far they may go until the next.
fn poses(hash: &mut StateHash, poses: &[Pose], margins: &[f64]) {
    hash.count(poses.len() as u64);
    for pose in poses {
        hash.numbers(&pose.position.to_array());
        hash.numbers(&pose.rotation.to_array());
    }
    hash.numbers(margins);
}

/// Springs of a contact.
fn remember(hash: &mut StateHash, memory: &Memory) {
    hash.numbers(&memory.shear.to_array());
    hash.numbers(&memory.normal.to_array());
    hash.numbers(&[memory.torsion, memory.area, memory.polar]);
    for arm in memory.arms {
        hash.numbers(&arm.to_array());
    }
    hash.count(u64::from(memory.sliding));
}

/// What goes on of the load of a joint.
fn carried_on(hash: &mut StateHash, offset: &Offset) {
    if let Some(joint) = &offset.joint {
        hash.numbers(&joint.rocking.to_array());
        hash.numbers(&joint.at.to_array());
        hash.numbers(&[joint.normal, joint.energy]);
    }
    hash.numbers(&offset.begins.unwrap_or([-1.0; 2]));
    hash.numbers(&offset.rocking.to_array());
    hash.numbers(&[offset.normal, offset.hidden, offset.softness, offset.energy]);
    hash.numbers(&[offset.rocks, offset.overlap, offset.slip, offset.turned]);
    hash.number(offset.stored);
}

/// Slip, offset along the normal and accumulated slip of the points of a patch, m.
fn memory(list: &Patches, p: usize) -> [f64; 16] {
    let mut memory = [0.0; 16];
    if let Some(slip) = list.slip.get(p) {
        memory[..8].copy_from_slice(slip.as_flattened());
    }
    if let Some(normal_offset) = list.normal_offset.get(p) {
        memory[8..12].copy_from_slice(normal_offset);
    }
    if let Some(accumulated_slip) = list.accumulated_slip.get(p) {
        memory[12..].copy_from_slice(accumulated_slip);
    }
    memory
}

fn bodies(hash: &mut StateHash, deform: &Deform) {
    for body in &deform.bodies {
        hash.count(u64::from(body.block) << 1 | u64::from(body.alive));
    }
    for list in [&deform.nodes.displacement, &deform.nodes.velocity] {
        hash.numbers(list.as_flattened());
    }
    if let Some(relax) = &deform.relax {
        hash.numbers(&[relax.damping, relax.ratio, relax.increment, relax.largest]);
        hash.number(relax.energy.unwrap_or(-1.0));
        hash.count(
            relax.iterations << 2 | u64::from(relax.converged) << 1 | u64::from(relax.settled),
        );
        hash.count(u64::from(relax.since));
        if let Some(seen) = &relax.last {
            hash.numbers(seen.displacement.as_flattened());
            hash.numbers(seen.net.as_flattened());
        }
    }
    for start in &deform.start {
        hash.number(start.energy);
        for stress in &start.stresses {
            hash.numbers(stress);
        }
    }
}

/// Bonds by their blocks, and by place in the lists where these are equal.
fn bonds(hash: &mut StateHash, deform: &Deform) {
    let mut order: Vec<u32> = (0..deform.facets.len() as u32).collect();
    order.sort_by_key(|f| deform.facets[*f as usize].blocks);
    hash.count(order.len() as u64);
    for f in order {
        let facet = &deform.facets[f as usize];
        hash.pair(facet.blocks);
        hash.count(facet.intact_until_step << 1 | u64::from(deform.has_history[f as usize]));
        if facet.parted {
            hash.count(1);
        }
        for memory in &deform.memory[facet.points()] {
            hash.numbers(&memory.start);
            hash.numbers(&memory.law.slip);
            hash.numbers(&[memory.law.damage, memory.unbooked, memory.broken_at]);
            hash.count(match memory.state {
                State::Bonded => 0,
                State::Opened => 1,
                State::Sheared => 2,
            });
        }
    }
}
