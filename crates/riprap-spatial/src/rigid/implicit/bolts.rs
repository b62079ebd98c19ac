//! Bolts for the implicit step: what the bolts of the world give to it, and what comes back.
//!
//! As with joints, the law of a bolt is applied in every evaluation and keeps its memory; what it pushes the blocks with is that of the end of the step.

use riprap_geom::Vec3;

use crate::implicit::patch::Stepping;
use crate::implicit::tie::{Length, Shear, Tie};
use crate::state::anchor::Inside;
use crate::state::bolts::{Bolt, Pin, chord};
use crate::state::scratch::{ImplicitDesk, Scratch};
use crate::state::world::World;

/// Gives the bolts to the solver.
pub(super) fn find(world: &World, scratch: &mut Scratch) {
    let ties = &mut scratch.implicit.solver.ties;
    ties.extend(world.bolts.iter().map(|bolt| tie(world, bolt)));
}

fn tie(world: &World, bolt: &Bolt) -> Tie {
    let freedoms = world.all_freedoms();
    let arm = |pin: &Pin| match pin.anchor {
        Inside::Block { block, arm } => freedoms.arm(block, arm),
        // Those of deformable blocks are refused.
        Inside::Tetrahedron { .. } => Vec3::ZERO,
    };
    let length = |[from, to]: [&Pin; 2], direction: Vec3, value: f64| {
        Length::new([from.block, to.block], [arm(from), arm(to)], direction, value)
    };
    let mut tie = Tie::new(&bolt.chain);
    let mut across = Vec::new();
    for k in (0..bolt.chain.bars.len()).filter(|k| bolt.stretches(*k)) {
        let ends = [&bolt.pins[k], &bolt.pins[k + 1]];
        let (now, longer) = chord(ends[0], ends[1], &freedoms);
        let size = now.length();
        let direction = now / size;
        tie.bars.push(k as u32);
        tie.lengths.push(length(ends, direction, longer));
        let force = bolt.chain.force[k];
        if force > 0.0 {
            let (first, second) = direction.any_orthonormal_pair();
            across.extend([first, second].map(|beside| length(ends, beside, 0.0)));
            tie.across.extend([force / size; 2]);
        }
    }
    tie.lengths.append(&mut across);
    let design = &world.setup.bolts[bolt.number as usize].design;
    for dowel in design.dowel.iter().flat_map(|_| &bolt.dowels) {
        let [stiffness, limit] = design.dowel.unwrap_or_default();
        tie.dowels.push(Shear { bar: dowel.bar, stiffness, limit });
        let [behind, ahead] = &dowel.sides;
        let jump = ahead.displacement(&freedoms) - behind.displacement(&freedoms);
        let (first, second) = bolt.axis.any_orthonormal_pair();
        for beside in [first, second] {
            let value = beside.dot(jump - dowel.slip);
            tie.lengths.push(length([behind, ahead], beside, value));
        }
    }
    tie
}

/// Blocks that bolts hold on to, with repeats.
pub(super) fn blocks(desk: &ImplicitDesk) -> impl Iterator<Item = u32> + '_ {
    desk.solver.ties.iter().flat_map(|tie| &tie.lengths).flat_map(|length| length.blocks)
}

/// Tells the bolts which blocks move.
pub(super) fn attach(desk: &mut ImplicitDesk, step: &Stepping) {
    let ImplicitDesk { solver, place, given, .. } = desk;
    let bodies = &solver.bodies;
    for tie in &mut solver.ties {
        let given = |b: u32| {
            let [v, w] = given[b as usize];
            [v.x, v.y, v.z, w.x, w.y, w.z]
        };
        tie.attach(step, |b| place[b as usize], given, |at| bodies[at as usize].held);
    }
}

/// Adds what the bolts exert in the step to the sums of their blocks.
pub(super) fn hand_over(scratch: &mut Scratch) {
    let (desk, mut net) = (&mut scratch.implicit, scratch.net.whole());
    for tie in &desk.solver.ties {
        for (length, force) in tie.lengths.iter().zip(&tie.forces) {
            for (b, [x, y, z, p, q, r]) in length.blocks.into_iter().zip(length.screws) {
                let (along, about) = (Vec3::new(x, y, z), Vec3::new(p, q, r));
                net.add(b as usize, -*force * along, -*force * about);
                if let Some(at) = desk.place[b as usize] {
                    desk.tied[at as usize] = true;
                }
            }
        }
    }
}

/// Tears the bars that have torn in the step that is made: it is made without them; what they had stored, J.
pub(super) fn remember(world: &mut World, scratch: &mut Scratch) -> f64 {
    let mut all = 0.0;
    let ties = &scratch.implicit.solver.ties;
    for ((bolt, tie), desk) in world.bolts.iter_mut().zip(ties).zip(&mut scratch.bolts) {
        let Bolt { chain, toll, .. } = bolt;
        for k in tie.torn.iter().map(|k| *k as usize) {
            let before = chain.stored();
            (chain.bars[k].stiffness, chain.force[k]) = (0.0, 0.0);
            desk.factors.refresh(chain);
            let losses = chain.solve(&desk.apart, &mut desk.factors);
            let lost = before - chain.stored();
            toll.lost += lost;
            toll.breaks += 1 + losses.breaks as u32;
            all += lost;
        }
    }
    all
}
