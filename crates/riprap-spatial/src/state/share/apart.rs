//! Steps that nobody reads: ranks keep to themselves, and what they know of each other is brought up to date when somebody reads again.
//!
//! In such a step a rank needs of the others what its own blocks feel: the motion of the blocks across the cut, and what the patches
//! there exert. Everything else of theirs stays behind ([`Share::behind`]): motion, sums, memory of patches. Shares of the ledger are
//! a few numbers and travel in every step. Whoever drives the run says that nobody reads ([`Scratch::unread`]); whether the engine itself reads
//! all blocks, in this module.

use std::ops::Range;

use riprap_core::peers::{bytes_of, put, take};

use super::{Remembered, Share, put_rates, take_rates};
use crate::accounts::Holder;
use crate::kernel::Role;
use crate::state::patches::{Patches, flag};
use crate::state::scratch::Scratch;
use crate::state::sums::Sums;
use crate::state::tiles::{Tile, Tiles};
use crate::state::world::World;

/// What a rank computes of a model.
pub(crate) struct Own {
    /// Blocks.
    pub(crate) blocks: Range<usize>,
    /// Joints between rigid blocks.
    pub(crate) patches: Range<usize>,
}

/// Decides whether ranks keep to themselves in the coming evaluation; if not, all know everything when it begins. `quiet`: how long a step the
/// search for contacts allows in what is a rank's own, s; 0 where it would have to be brought up to date, which it is asked for where
/// blocks seek contact, and for joints (`true`) every `rhythm` steps.
pub(crate) fn begin(
    world: &mut World,
    scratch: &mut Scratch,
    rhythm: u64,
    quiet: impl FnOnce(&World, &Scratch, Own, bool) -> f64,
) {
    let mut longest = if scratch.unread && may(world, scratch) { f64::INFINITY } else { 0.0 };
    let looks = world.step.is_multiple_of(rhythm);
    let asks = world.setup.found_contacts && (looks || world.found.roles.contains(&Role::Active));
    if longest > 0.0
        && asks
        && let Some(share) = scratch.share(world)
    {
        let own =
            |of: fn(&Tile) -> &Range<usize>| share.items(&scratch.tiles, share.peers.rank(), of);
        let own = Own { blocks: own(|tile| &tile.blocks), patches: own(|tile| &tile.patches) };
        let broke = looks && some_broke(world, own.patches.clone(), &scratch.desk.who.whole);
        longest = share.smallest(if broke { 0.0 } else { quiet(world, scratch, own, looks) });
    }
    let apart = longest > 0.0;
    if !apart {
        settle(world, scratch);
    }
    if let Some(share) = &mut scratch.share {
        share.apart = apart.then_some(longest);
    }
}

/// Lets all ranks know the whole state again; nothing where they do, or for a model that is not shared out.
pub fn settle(world: &mut World, scratch: &mut Scratch) {
    let Scratch { share, tiles, net, drag, .. } = scratch;
    if let Some(share) = share {
        share.settle(tiles, world, [net, drag]);
    }
}

impl Scratch {
    /// Longest step that the search for contacts allows, s, where ranks keep to themselves in this one.
    pub(crate) fn apart(&self) -> Option<f64> {
        self.share.as_ref()?.apart
    }
}

/// Whether this evaluation and the step after it read only what a rank knows in any case, looks at joints apart.
fn may(world: &World, scratch: &Scratch) -> bool {
    let during = world.setup.refinements.iter().filter_map(|one| one.during);
    let splits = |every: u64| every > 0 && world.step.is_multiple_of(every);
    let splitting = during.map(|one| one.every).any(splits);
    let moved = world.pending > 0.0 && !world.fresh && !scratch.turning;
    moved && !splitting && scratch.share(world).is_some() && feels_neighbours_alone(world)
}

/// Whether only joints and the conditions on them move blocks.
pub(super) fn feels_neighbours_alone(world: &World) -> bool {
    let setup = &world.setup;
    let rigid = world.deform.is_none() && world.bolts.is_empty();
    let dry = setup.water.is_empty() && world.seepage.is_none();
    let blown = !world.cavities.is_empty() || world.gas.is_some();
    // What single loads and supports do is booked by all alike.
    let silent = setup.accounts.iter().all(|one| matches!(one.holder, Holder::Boundary(_)));
    let meets = world.has_terrain() || !world.found.pairs.is_empty();
    rigid && dry && silent && !blown && !meets
}

/// Sorts ranges, and joins those that touch or overlap.
pub(super) fn merge(list: &mut Vec<Range<usize>>) {
    list.sort_by_key(|run| run.start);
    list.dedup_by(|later, run| {
        let joined = later.start <= run.end;
        if joined {
            run.end = run.end.max(later.end);
        }
        joined
    });
}

/// Whether a joint of these patches has failed or given way since the last look at joints, after which all joints of the blocks that are `whole`
/// were in place. What the others know of it does not matter: they may have learnt it between two looks.
fn some_broke(world: &World, own: Range<usize>, whole: &[bool]) -> bool {
    let fails = |p: usize| {
        let of_whole = || world.patches.ends[p].iter().any(|b| whole[*b as usize]);
        world.patches.flags[p] & (flag::BROKEN | flag::DISPLACED) != 0 && of_whole()
    };
    // Nobody has looked yet.
    whole.len() != world.alive.len() || own.into_iter().any(fails)
}

impl Share {
    /// Gives what the others do not know of the blocks and patches of this rank to all.
    pub(super) fn settle(&mut self, tiles: &Tiles, world: &mut World, mut sums: [&mut Sums; 2]) {
        if !std::mem::take(&mut self.behind) {
            return;
        }
        let rank = self.peers.rank();
        let memory = bytes_of(&self.changed(tiles, &world.patches));
        let mut message = (memory.len() as u64).to_le_bytes().to_vec();
        message.extend(memory);
        let own = self.items(tiles, rank, |tile| &tile.blocks);
        put_rates(&mut message, world, std::slice::from_ref(&own));
        for list in lists(world, &mut sums) {
            put(&mut message, &list[own.clone()]);
        }
        for (from, message) in self.others(self.peers.gather(message).unwrap_or_default()) {
            let Some((head, rest)) = message.split_first_chunk() else {
                continue;
            };
            let Some((memory, mut rest)) =
                rest.split_at_checked(u64::from_le_bytes(*head) as usize)
            else {
                continue;
            };
            self.remember(from, memory, &mut world.patches);
            let theirs = self.items(tiles, from, |tile| &tile.blocks);
            take_rates(&mut rest, world, std::slice::from_ref(&theirs));
            for list in lists(world, &mut sums) {
                take(&mut rest, &mut list[theirs.clone()]);
            }
        }
    }

    fn remember(&self, from: usize, memory: &[u8], patches: &mut Patches) {
        for one in self.peers.read::<Vec<Remembered>>(from, memory).unwrap_or_default() {
            one.put(patches);
        }
    }
}

/// What blocks have besides velocities: displacement, largest speed, sums.
fn lists<'a>(
    world: &'a mut World,
    sums: &'a mut [&mut Sums; 2],
) -> impl Iterator<Item = &'a mut Vec<f64>> {
    let sums = sums.iter_mut().filter(|s| !s.is_empty()).flat_map(|s| &mut s.lists);
    let moved = world.bodies.displacement.iter_mut().chain([&mut world.peak_speed_squared]);
    moved.chain(sums)
}

#[cfg(test)]
mod tests {
    #[test]
    fn runs_are_joined() {
        let mut list = vec![8..9, 0..2, 1..4, 4..5, 7..8, 11..12];
        super::merge(&mut list);
        assert_eq!(list, [0..5, 7..9, 11..12]);
    }
}
