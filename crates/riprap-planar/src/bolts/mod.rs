//! Bolts, cables and dowels in the plane: writers of slots that tie blocks together.
//!
//! As in space a bolt is a chain without masses ([`crate::laws::bolt`]) between points of the rock. In each evaluation the points part or
//! close along the bars, the chain finds its equilibrium, and every bar between two blocks pulls the points at its ends together, along the line
//! between them. A bar and a dowel have a slot each, so that blocks sum them with their contacts, in a fixed order. Everything is per metre of
//! thickness: a bolt stands for its spacing out of the plane.

mod install;
pub mod place;
pub mod read;
mod stiffness;

use riprap_geom::Vec2;

use crate::laws::bolt::{self, BoltScratch, Sheared};
use crate::setup::Bolt as Spec;
use crate::world::{Body, Bolt, Pin, World, Wrench};

pub use install::{InstallError, follow, install};

impl Pin {
    /// Its present place from the centroid of its block, m, global axes.
    pub(crate) fn lever(&self, bodies: &[Body]) -> Vec2 {
        let body = &bodies[self.block as usize];
        body.place(self.arm) - body.position
    }

    /// Displacement since the bolt was installed, m.
    #[must_use]
    pub fn displacement(&self, bodies: &[Body]) -> Vec2 {
        bodies[self.block as usize].place(self.arm) - self.place
    }
}

/// Present chord (m) from one pin to another, and by how much it is longer than when the bolt was installed, m.
fn chord(from: &Pin, to: &Pin, bodies: &[Body]) -> (Vec2, f64) {
    let moved = to.displacement(bodies) - from.displacement(bodies);
    bolt::chord(to.place - from.place, moved, Vec2::dot)
}

impl Bolt {
    /// Energy in bar, grout, plate and dowels, J/m; `spec` is what it was built from.
    #[must_use]
    pub fn stored(&self, spec: &Spec) -> f64 {
        let squares = self.dowels.iter().map(|d| d.force.length_squared());
        self.chain.stored_with(spec.design.dowel, squares)
    }

    /// Whether the rock at the ends of bar `k` can move apart: it lies in two blocks.
    #[must_use]
    pub fn stretches(&self, k: usize) -> bool {
        self.pins[k].block != self.pins[k + 1].block
    }

    /// Blocks that its bars and dowels tie together, in the order of their slots.
    fn ties(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        let bars = (0..self.chain.bars.len()).filter(|k| self.stretches(*k));
        let bars = bars.map(|k| (self.pins[k].block, self.pins[k + 1].block));
        let dowels = self.dowels.iter().map(|d| &d.sides);
        bars.chain(dowels.map(|[a, b]| (a.block, b.block)))
    }
}

impl Bolt {
    /// Hands over the forces (N/m) of bars and dowels on the first of two pins, in the order of the slots; the second gets the opposite.
    pub(crate) fn pulls(&self, bodies: &[Body], put: &mut dyn FnMut(&Pin, &Pin, Vec2)) {
        for k in (0..self.chain.bars.len()).filter(|k| self.stretches(*k)) {
            let (from, to) = (&self.pins[k], &self.pins[k + 1]);
            let (now, _) = chord(from, to, bodies);
            put(from, to, self.chain.force[k] / now.length() * now);
        }
        for dowel in &self.dowels {
            let [behind, ahead] = &dowel.sides;
            put(behind, ahead, dowel.force);
        }
    }
}

impl World {
    /// Pairs of blocks that bolts tie together, one for each slot of a bolt, in their order.
    pub(crate) fn bolt_ties(&self) -> Vec<(u32, u32)> {
        self.bolts.iter().flat_map(Bolt::ties).collect()
    }

    /// Energy in bolts, J/m.
    #[must_use]
    pub fn bolt_energy(&self) -> f64 {
        let stored = |bolt: &Bolt| bolt.stored(&self.setup.bolts[bolt.number as usize]);
        self.bolts.iter().map(stored).sum()
    }
}

/// Finds the forces of all bolts at the present positions and writes their slots; `desks` is room for them.
///
/// Calling it again without moving changes nothing.
pub(crate) fn act(world: &mut World, desks: &mut Vec<BoltScratch>, slots: &mut [Wrench]) {
    let World { bolts, bodies, setup, works, pending, .. } = world;
    if desks.len() != bolts.len() {
        let desk = |bolt: &Bolt| BoltScratch::new(&bolt.chain, |k| bolt.stretches(k));
        *desks = bolts.iter().map(desk).collect();
    }
    let mut slots = slots.iter_mut();
    for (bolt, desk) in bolts.iter_mut().zip(desks) {
        if *pending > 0.0 {
            solve(bolt, desk, &setup.bolts[bolt.number as usize], bodies);
            works.bolts += bolt.toll.add(desk);
        }
        bolt.pulls(bodies, &mut |from, to, force| {
            let arm = |pin: &Pin| pin.lever(bodies);
            if let Some(slot) = slots.next() {
                *slot = Wrench::at(force, arm(from), arm(to));
            }
        });
    }
}

/// Equilibrium of one bolt and forces of its dowels.
fn solve(bolt: &mut Bolt, desk: &mut BoltScratch, spec: &Spec, bodies: &[Body]) {
    let pins = &bolt.pins;
    desk.solve(&mut bolt.chain, |k| chord(&pins[k], &pins[k + 1], bodies).1);
    let Some(dowel) = spec.design.dowel else {
        return;
    };
    for one in &mut bolt.dowels {
        let [behind, ahead] = &one.sides;
        let jump = ahead.displacement(bodies) - behind.displacement(bodies);
        let broken = bolt.chain.bars[one.bar as usize].stiffness <= 0.0;
        let before = Sheared { slip: one.slip.to_array(), force: one.force.to_array() };
        let (now, lost) = before.after(dowel, broken, bolt.axis.to_array(), jump.to_array());
        (one.slip, one.force) = (now.slip.into(), now.force.into());
        desk.sheared += lost;
    }
}

#[cfg(test)]
mod tests;
