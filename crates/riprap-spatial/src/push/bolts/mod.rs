//! Bolts, cables and dowels: writers of pushes that tie blocks together.
//!
//! A bolt is a chain without masses ([`crate::laws::bolt`]) between points of the rock. In each evaluation the points part or close along
//! the bars, the chain finds its equilibrium, and every bar pulls the points at its ends together along the line between them. So
//! momentum and angular momentum are kept whatever the chain does, and a block that turns with its bolt strains nothing. Bars within one rigid
//! block push nothing. A point of a deformable block hangs on the tetrahedron that holds it ([`inside`]). Stored energy is read from the chain; what yields, slips and breaks is booked here.

pub mod inside;
pub mod install;
pub mod place;
pub mod stiffness;

use crate::exec::Divide;
use crate::laws::bolt::{BoltScratch, Sheared};
use crate::setup::Bolt as Spec;
use crate::state::anchor::Freedoms;
use crate::state::bolts::{Bolt, Pin, chord};
use crate::state::scratch::Scratch;
use crate::state::world::World;
use riprap_core::cut;
use riprap_geom::Vec3;

/// Bolts that are solved by one thread in one go.
const CHUNK: usize = 16;

/// Some bolts and what they work with.
struct Piece<'a> {
    bolts: &'a mut [Bolt],
    desks: &'a mut [BoltScratch],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        cut!(self, bolts: middle * CHUNK, desks: middle * CHUNK)
    }
}

/// Finds the forces of all bolts at the present positions and pushes the blocks with them.
///
/// Calling it again without moving changes nothing. Implicit steps find what they push with themselves.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch) {
    if world.bolts.is_empty() {
        return;
    }
    let changes = world.pending > 0.0 || world.fresh;
    let World { bolts, bodies, turned, deform, setup, .. } = world;
    let freedoms = Freedoms::new(bodies, turned, deform.as_deref().map(|d| &d.nodes));
    if changes {
        if scratch.bolts.len() != bolts.len() {
            let desk = |bolt: &Bolt| BoltScratch::new(&bolt.chain, |k| bolt.stretches(k));
            scratch.bolts = bolts.iter().map(desk).collect();
        }
        let work = Piece { bolts: &mut *bolts, desks: &mut scratch.bolts };
        let specs = &setup.bolts;
        let chunks = work.bolts.len().div_ceil(CHUNK);
        scratch.exec.divided(work, chunks, |_, piece| {
            for (bolt, desk) in piece.bolts.iter_mut().zip(piece.desks) {
                solve(bolt, desk, &specs[bolt.number as usize], &freedoms);
            }
        });
    }
    if changes {
        for (bolt, desk) in bolts.iter_mut().zip(&scratch.bolts) {
            let lost = bolt.toll.add(desk);
            world.works.bolts += lost;
            if let Some(implicit) = world.implicit.as_deref_mut() {
                implicit.lost_in_joints += lost;
            }
        }
    }
    if world.implicit.is_some() {
        // What they push with in an implicit step is that of its end.
        return;
    }
    let pushes = &mut scratch.pushes.own;
    pushes.need_blocks(world.alive.len());
    let on_nodes = |bolt: &Bolt| bolt.points().any(|pin| pin.anchor.deforms());
    if pushes.nodes.is_empty() && bolts.iter().any(on_nodes) {
        pushes.need_nodes(freedoms.displacement.len());
    }
    for bolt in &*bolts {
        for k in (0..bolt.chain.bars.len()).filter(|k| bolt.stretches(*k)) {
            let (from, to) = (&bolt.pins[k], &bolt.pins[k + 1]);
            let (now, _) = chord(from, to, &freedoms);
            let pull = bolt.chain.force[k] / now.length() * now;
            freedoms.push_inside(pushes, &from.anchor, pull);
            freedoms.push_inside(pushes, &to.anchor, -pull);
        }
        for dowel in &bolt.dowels {
            let [behind, ahead] = &dowel.sides;
            freedoms.push_inside(pushes, &behind.anchor, dowel.force);
            freedoms.push_inside(pushes, &ahead.anchor, -dowel.force);
        }
    }
}

/// Equilibrium of one bolt and forces of its dowels.
fn solve(bolt: &mut Bolt, desk: &mut BoltScratch, spec: &Spec, freedoms: &Freedoms) {
    let pins = &bolt.pins;
    desk.solve(&mut bolt.chain, |k| chord(&pins[k], &pins[k + 1], freedoms).1);
    let Some(dowel) = spec.design.dowel else {
        return;
    };
    for one in &mut bolt.dowels {
        let [behind, ahead] = &one.sides;
        let jump = ahead.displacement(freedoms) - behind.displacement(freedoms);
        let broken = bolt.chain.bars[one.bar as usize].stiffness <= 0.0;
        let before = Sheared { slip: one.slip.to_array(), force: one.force.to_array() };
        let (now, lost) = before.after(dowel, broken, bolt.axis.to_array(), jump.to_array());
        (one.slip, one.force) = (now.slip.into(), now.force.into());
        desk.sheared += lost;
    }
}

impl World {
    /// Energy in bolts, J.
    #[must_use]
    pub fn bolt_energy(&self) -> f64 {
        let stored = |bolt: &Bolt| bolt.stored(&self.setup.bolts[bolt.number as usize]);
        self.bolts.iter().map(stored).sum()
    }

    /// Forces of bolts on the rock: block, arm from its centroid at present (m), force (N); one for each node and each side of a joint.
    #[must_use]
    pub fn bolt_forces(&self) -> Vec<(u32, Vec3, Vec3)> {
        let freedoms = self.all_freedoms();
        let mut all = Vec::new();
        for bolt in &self.bolts {
            let first = all.len();
            let centre = |block: u32| {
                self.reference[block as usize] + freedoms.displacement(&self.centroid(block))
            };
            let pin = |pin: &Pin, force: Vec3| {
                let place = pin.place + pin.displacement(&freedoms);
                (pin.block, place - centre(pin.block), force)
            };
            all.extend(bolt.pins.iter().map(|p| pin(p, Vec3::ZERO)));
            for k in 0..bolt.chain.bars.len() {
                let (now, _) = chord(&bolt.pins[k], &bolt.pins[k + 1], &freedoms);
                let pull = bolt.chain.force[k] / now.length() * now;
                all[first + k].2 += pull;
                all[first + k + 1].2 -= pull;
            }
            for dowel in &bolt.dowels {
                all.push(pin(&dowel.sides[0], dowel.force));
                all.push(pin(&dowel.sides[1], -dowel.force));
            }
        }
        all
    }
}

#[cfg(test)]
mod tests;
