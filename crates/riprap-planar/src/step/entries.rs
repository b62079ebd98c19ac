//! Work of single supports and loads ([`riprap_core::accounts`]).

use super::Damping;
use super::kick;
use crate::accounts::{Entries, Holder, Line, add};
use crate::loads;
use crate::scratch::Scratch;
use crate::setup::Motion;
use crate::world::World;

/// Books what each condition does in the halves of the kick that was just found for a step of `dt` (s).
pub(super) fn book(world: &mut World, scratch: &mut Scratch, damping: &Damping, dt: f64) {
    let mut entries = std::mem::take(&mut scratch.entries);
    entries.clear(world.accounts.len());
    let half = [0.5 * world.pending, 0.5 * dt];
    loads::each(world, &scratch.shapes, dt, |load, b, push| {
        let Some(account) = load.account else {
            return;
        };
        let (body, change) = (&world.bodies[b], &scratch.changes[b]);
        let work = [
            (half[0], body.velocity, body.spin),
            (half[1], body.velocity + change.velocity, body.spin + change.spin),
        ];
        let work = work.map(|(half, v, w)| half * (push.force.dot(v) + push.moment * w));
        entries.book(account, Line::Loads, work);
    });
    driven(world, scratch, damping, dt, &mut entries);
    add(&mut world.accounts, &entries.arrival);
    scratch.entries = entries;
}

/// Books the work of blocks whose motion is given; what is held does none.
fn driven(world: &World, scratch: &Scratch, damping: &Damping, dt: f64, entries: &mut Entries) {
    let supports = &world.setup.supports;
    for (account, condition) in (0..).zip(&world.setup.accounts) {
        let Holder::Support(number) = condition.holder else {
            continue;
        };
        let (own, later) = supports[usize::from(number)..].split_at(1);
        // The last support of a block alone acts on it, unless a phase fixes or releases it.
        let moves = |b: &&u32| match world.motion[**b as usize].as_deref() {
            Some(Motion::Velocity { .. } | Motion::Acceleration { .. }) => {
                world.alive[**b as usize]
                    && !later.iter().any(|s| s.blocks.binary_search(b).is_ok())
            }
            Some(Motion::Fixed { .. }) | None => false,
        };
        for &b in own.iter().flat_map(|s| &s.blocks).filter(moves) {
            let work = kick::of_support(world, scratch, damping, dt, b as usize);
            entries.book(account, Line::Supports, work);
        }
    }
}
