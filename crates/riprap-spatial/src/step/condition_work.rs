//! Works of single conditions ([`crate::accounts`]): what each boundary, support and load does in a kick.
//!
//! Faces of rigid blocks tell theirs in the gathering; all else is found here again after the kick, on what its condition pushes
//! or drives alone, in the order of the setup.

use riprap_geom::Vec3;

use crate::accounts;
use crate::accounts::{Entries, Holder, Line, add};
use crate::deform::step;
use crate::dynamics::kick::Support;
use crate::ledger::Works;
use crate::push::loads;
use crate::push::loads::Pushed;
use crate::push::surface;
use crate::setup::Motion;
use crate::state::deform::Deform;
use crate::state::scratch::Scratch;
use crate::state::workspace::Workspace;
use crate::state::world::World;

/// Books what each condition does in the halves of the kick that was just found.
pub(crate) fn book(world: &mut World, scratch: &mut Scratch) {
    let mut entries = std::mem::take(&mut scratch.entries);
    entries.clear(world.accounts.len());
    let booking = Booking {
        world,
        scratch,
        half: [0.5 * world.pending, 0.5 * scratch.coming_dt],
        boundaries: (0..world.setup.boundaries.len())
            .map(|k| accounts::of(&world.setup.accounts, Holder::Boundary(k as u16)))
            .collect(),
    };
    booking.faces(&mut entries);
    booking.loads(&mut entries);
    booking.supports(&mut entries);
    if let Some((deform, work)) = world.deform.as_deref().zip(scratch.deform.as_deref()) {
        booking.surfaces(deform, work, &mut entries);
        booking.holds(deform, work, &mut entries);
    }
    add(&mut world.accounts, &entries.arrival);
    scratch.entries = entries;
}

struct Booking<'a> {
    world: &'a World,
    scratch: &'a Scratch,
    /// Halves of the step before and after the present time, s.
    half: [f64; 2],
    /// Accounts of the boundaries.
    boundaries: Vec<Option<u16>>,
}

impl Booking<'_> {
    /// Faces of rigid blocks.
    fn faces(&self, entries: &mut Entries) {
        let faces = &self.world.faces;
        for f in self.scratch.tiles.conditioned(0..faces.len()).iter().map(|f| *f as usize) {
            let account = faces[f].boundary.and_then(|k| self.boundaries[usize::from(k)]);
            if let Some((account, entry)) = account.zip(self.scratch.face_entries.get(f)) {
                entries.add(account, &entry.halves);
            }
        }
    }

    /// Loads on blocks and nodes.
    fn loads(&self, entries: &mut Entries) {
        let (world, scratch) = (self.world, self.scratch);
        let kick = scratch.kick(world);
        let work = scratch.deform.as_deref();
        loads::each(world, work, scratch.kick_halves(world), |load, pushed| {
            let Some(account) = load.account else {
                return;
            };
            let work = match pushed {
                Pushed::Block(b, push) => {
                    let b = b as usize;
                    let (v, w) = (world.bodies.velocity(b), world.bodies.spin(b));
                    let change = kick.change(b, &world.moving(b), &scratch.acting(b));
                    let [before, after] = self.half;
                    [
                        before * push.power(v, w),
                        after * push.power(v + change.velocity, w + change.spin),
                    ]
                }
                Pushed::Node(node, force) => self.on_node(node, force),
            };
            entries.book(account, Line::Loads, work);
        });
    }

    /// Supports that drive rigid blocks: what they hold still does no work.
    fn supports(&self, entries: &mut Entries) {
        let (world, scratch) = (self.world, self.scratch);
        let kick = scratch.kick(world);
        for (account, condition) in (0..).zip(&world.setup.accounts) {
            let Holder::Support(number) = condition.holder else {
                continue;
            };
            let (own, later) = world.setup.supports[usize::from(number)..].split_at(1);
            // The last support of a block alone acts on it, unless a phase fixes or releases it.
            let driven = |b: &&u32| match world.motion[**b as usize].as_deref() {
                Some(Motion::Velocity { .. } | Motion::Acceleration { .. }) => {
                    world.alive[**b as usize]
                        && !world.deforms(**b as usize)
                        && !later.iter().any(|s| s.blocks.binary_search(b).is_ok())
                }
                Some(Motion::Fixed { .. }) | None => false,
            };
            for &b in own.iter().flat_map(|s| &s.blocks).filter(driven) {
                let b = b as usize;
                let (mut arrival, mut departure) = (Works::default(), Works::default());
                let (moving, acting) = (world.moving(b), scratch.acting(b));
                let no_load = (Vec3::ZERO, Vec3::ZERO);
                kick.works(b, &moving, &acting, no_load, &mut arrival, &mut departure);
                let work = [arrival.supports, departure.supports];
                entries.book(account, Line::Supports, work);
            }
        }
    }

    /// Tractions and dashpots on faces of deformable blocks.
    fn surfaces(&self, deform: &Deform, work: &Workspace, entries: &mut Entries) {
        let half = self.scratch.kick_halves(self.world);
        surface::each(self.world, deform, half, |boundary, node, force| {
            if let Some(account) = self.boundaries[boundary] {
                entries.book(account, Line::Loads, self.on_node(node, force));
            }
        });
        surface::each_dashpot(&self.world.setup, deform, |boundary, dashpot| {
            if let Some(account) = self.boundaries[boundary] {
                let [v, dv] = rates(deform, work, dashpot.node);
                let drag = dashpot.matrix * (v + 0.5 * dv);
                let work = self.on_node(dashpot.node, drag);
                entries.book(account, Line::Absorbed, work);
            }
        });
    }

    /// Conditions that drive nodes.
    fn holds(&self, deform: &Deform, work: &Workspace, entries: &mut Entries) {
        let kick = step::kick(self.world, deform, work, self.scratch, self.scratch.coming_dt);
        for hold in deform.holds.iter().filter(|hold| hold.drives()) {
            let node = hold.node as usize;
            let held = kick.held(hold, work.net[node]);
            let [v, dv] = rates(deform, work, hold.node);
            let blows = hold.parts(held.support.blow);
            for ((account, steady), (_, blow)) in hold.parts(held.support.steady).zip(blows) {
                let Some(account) = account else { continue };
                let work = Support { steady, blow }.works(self.half, [v, v + dv], Vec3::dot);
                entries.book(account, Line::Supports, work);
            }
        }
    }

    /// Works of a force (N) on a node.
    fn on_node(&self, node: u32, force: Vec3) -> [f64; 2] {
        let both = self.world.deform.as_deref().zip(self.scratch.deform.as_deref());
        both.map_or([0.0; 2], |(deform, work)| {
            let [v, dv] = rates(deform, work, node);
            let [before, after] = self.half;
            [before * force.dot(v), after * force.dot(v + dv)]
        })
    }
}

/// Velocity of a node half a step ago and its change in the kick, m/s.
fn rates(deform: &Deform, work: &Workspace, node: u32) -> [Vec3; 2] {
    let node = node as usize;
    [deform.nodes.velocity[node], work.change[node]].map(Vec3::from_array)
}
