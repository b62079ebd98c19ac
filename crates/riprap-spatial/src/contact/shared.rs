//! Pairs shared out among ranks: each evaluates a run of groups of pairs, and tells the others what came of it.
//!
//! What a pair remembers, what it exerts and the sums of its group travel to all, so that all do the rest alike: sums on blocks, limit
//! of the step, search, records. Of pairs that stay apart the gap is enough.

use std::ops::Range;
use std::time::Duration;

use riprap_core::peers::bytes_of;
use riprap_core::sums::GROUP;
use serde::{Deserialize, Serialize};

use crate::state::contact_scratch::{PairGroup, Slot, Workspace};
use crate::state::found::FoundPair;
use crate::state::share::Share;

/// What a rank tells of its pairs.
#[derive(Serialize, Deserialize)]
struct Told {
    /// What it took, s.
    spent: f64,
    groups: Vec<PairGroup>,
    pairs: Vec<Pair>,
    /// Blocks that it saw beside all terrain.
    beside: Vec<u32>,
}

/// A pair after its evaluation.
#[derive(Serialize, Deserialize)]
enum Pair {
    /// Apart: everything else is that of a pair of which nothing is known.
    Apart {
        gap: f64,
        seated: bool,
        nearing: f64,
    },
    Near(FoundPair, Slot),
}

/// Pairs of a rank among so many.
pub(super) fn part(share: &Share, rank: usize, count: usize) -> Range<usize> {
    let groups = share.pairs.part(rank);
    (groups.start * GROUP).min(count)..(groups.end * GROUP).min(count)
}

/// Gives what this rank has found, in the time `spent`, to all.
pub(super) fn exchange(
    share: &mut Share,
    pairs: &mut [FoundPair],
    slots: &mut [Slot],
    groups: &mut [PairGroup],
    workspaces: &mut [Workspace],
    spent: Duration,
) {
    let (rank, size) = (share.peers.rank(), share.peers.size());
    let own = part(share, rank, pairs.len());
    // One that has just parted still winds up its clock.
    let tell = |(pair, slot): (&FoundPair, &Slot)| match pair.gap > 0.0 && pair.clock.is_none() {
        true => Pair::Apart { gap: pair.gap, seated: pair.seated, nearing: slot.nearing },
        false => Pair::Near(pair.clone(), *slot),
    };
    let told = Told {
        spent: spent.as_secs_f64(),
        groups: groups[share.pairs.part(rank)].to_vec(),
        pairs: pairs[own.clone()].iter().zip(&slots[own]).map(tell).collect(),
        beside: workspaces.iter().flat_map(|work| work.beside.iter().copied()).collect(),
    };
    let mut times = vec![told.spent; size];
    for (from, message) in share.others(share.peers.gather(bytes_of(&told)).unwrap_or_default()) {
        let Some(told) = share.peers.read::<Told>(from, &message) else {
            continue;
        };
        times[from] = told.spent;
        for (group, found) in groups[share.pairs.part(from)].iter_mut().zip(told.groups) {
            *group = found;
        }
        let theirs = part(share, from, pairs.len());
        let all = pairs[theirs.clone()].iter_mut().zip(&mut slots[theirs]);
        for ((pair, slot), found) in all.zip(told.pairs) {
            (*pair, *slot) = match found {
                Pair::Near(pair, slot) => (pair, slot),
                Pair::Apart { gap, seated, nearing } => (
                    FoundPair { gap, seated, ..FoundPair::new(pair.key()) },
                    Slot { nearing, ..Slot::default() },
                ),
            };
        }
        if let Some(work) = workspaces.first_mut() {
            work.beside.extend(told.beside);
        }
    }
    if let Some(bounds) = share.pairs.book(&times) {
        share.pairs.cut_at(bounds);
    }
}
