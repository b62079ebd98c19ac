//! Pairs shared out among ranks: each evaluates a run of groups of pairs, and tells the others what came of it.
//!
//! What a pair remembers, what it exerts and the sums of its group travel to all, so that all do the rest alike: sums on blocks, limit
//! of the step, search, records. Of pairs that stay apart the gap is enough.

use std::ops::Range;
use std::time::Duration;

use riprap_core::peers::{Trouble, bytes_of, put, take};
use riprap_core::sums::GROUP;
use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::kernel::Memory;
use crate::kernel::friction::Wrench;
use crate::kernel::offset::Offset;
use crate::state::clock::Clock;
use crate::state::contact_scratch::{Exerted, Impact, PairGroup, PairSums, Slot, Workspace};
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::share::Share;

/// What a rank reports of its pairs. The numbers of pairs and of what they exert follow as they lie in memory, group by group: reading them
/// field by field takes as long as a sixth of the contacts.
#[derive(Serialize, Deserialize)]
struct Head {
    /// What it took, s.
    spent: f64,
    groups: Vec<Group>,
    /// What few pairs have.
    rare: Vec<Rare>,
    /// Blocks that it saw beside all terrain.
    beside: Vec<u32>,
}

/// What a group of pairs has besides their numbers.
#[derive(Serialize, Deserialize)]
struct Group {
    /// Pairs that exert something.
    exerted: u32,
    impacts: Vec<Impact>,
    sums: PairSums,
}

/// What few pairs have.
#[derive(Serialize, Deserialize)]
struct Rare {
    /// The pair, counted from the first of its rank.
    pair: u32,
    offset: Option<Box<Offset>>,
    clock: Option<Box<Clock>>,
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
    let mut times = vec![spent.as_secs_f64(); size];
    let own = part(share, rank, pairs.len());
    let beside = workspaces.iter().flat_map(|work| work.beside.iter().copied()).collect();
    let of = &groups[share.pairs.part(rank)];
    let message = message(times[rank], &pairs[own.clone()], &slots[own], of, beside);
    for (from, message) in share.others(share.peers.gather(message).unwrap_or_default()) {
        let theirs = part(share, from, pairs.len());
        let (pairs, slots) = (&mut pairs[theirs.clone()], &mut slots[theirs]);
        let found = split(&message).and_then(|(head, numbers)| {
            let head: Head = share.peers.read(from, head)?;
            let whole = read(&head, numbers, pairs, slots, &mut groups[share.pairs.part(from)]);
            whole.then_some(head)
        });
        let Some(head) = found else {
            share.peers.note(Trouble::Unreadable { rank: from });
            continue;
        };
        times[from] = head.spent;
        for rare in head.rare {
            if let Some(pair) = pairs.get_mut(rare.pair as usize) {
                (pair.offset, pair.clock) = (rare.offset, rare.clock);
            }
        }
        if let Some(work) = workspaces.first_mut() {
            work.beside.extend(head.beside);
        }
    }
    if let Some(bounds) = share.pairs.book(&times) {
        share.pairs.cut_at(bounds);
    }
}

fn message(
    spent: f64,
    pairs: &[FoundPair],
    slots: &[Slot],
    groups: &[PairGroup],
    beside: Vec<u32>,
) -> Vec<u8> {
    let of_group = |of: &PairGroup| Group {
        exerted: of.exerted.len() as u32,
        impacts: of.impacts.clone(),
        sums: of.sums,
    };
    let rare = |(k, pair): (usize, &FoundPair)| {
        let FoundPair { offset, clock, .. } = pair;
        let has = is_near(pair) && (offset.is_some() || clock.is_some());
        has.then(|| Rare { pair: k as u32, offset: offset.clone(), clock: clock.clone() })
    };
    let head = bytes_of(&Head {
        spent,
        groups: groups.iter().map(of_group).collect(),
        rare: pairs.iter().enumerate().filter_map(rare).collect(),
        beside,
    });
    let mut message = (head.len() as u64).to_le_bytes().to_vec();
    message.extend(head);
    let near = pairs.iter().filter(|pair| is_near(pair)).count();
    message.reserve(8 * (3 * pairs.len() + near * (NEAR + PATCH + EXERTED)));
    for ((pairs, slots), group) in pairs.chunks(GROUP).zip(slots.chunks(GROUP)).zip(groups) {
        for (pair, slot) in pairs.iter().zip(slots) {
            put_pair(&mut message, pair, slot);
        }
        for exerted in &group.exerted {
            put(&mut message, &numbers_of_exerted(exerted));
        }
    }
    message
}

/// The two parts of a message.
fn split(message: &[u8]) -> Option<(&[u8], &[u8])> {
    let (length, rest) = message.split_first_chunk()?;
    rest.split_at_checked(u64::from_le_bytes(*length) as usize)
}

/// Reads the numbers of the pairs of another rank; whether there are as many as must be.
fn read(
    head: &Head,
    mut numbers: &[u8],
    pairs: &mut [FoundPair],
    slots: &mut [Slot],
    groups: &mut [PairGroup],
) -> bool {
    let rest = &mut numbers;
    let of = pairs.chunks_mut(GROUP).zip(slots.chunks_mut(GROUP));
    for (((pairs, slots), group), found) in of.zip(groups).zip(&head.groups) {
        for (pair, slot) in pairs.iter_mut().zip(slots) {
            if take_pair(rest, pair, slot).is_none() {
                return false;
            }
        }
        group.begin();
        group.sums = found.sums;
        group.impacts.extend_from_slice(&found.impacts);
        for _ in 0..found.exerted {
            let Some(exerted) = next(rest) else {
                return false;
            };
            group.push(exerted_of(exerted));
        }
    }
    rest.is_empty()
}

/// Whether more is known of a pair than that it is apart. One that has just parted still winds up its clock.
fn is_near(pair: &FoundPair) -> bool {
    pair.gap <= 0.0 || pair.clock.is_some()
}

const IS_NEAR: u32 = 1;
const SEATED: u32 = 2;
const TOUCHING: u32 = 4;
const NEGLIGIBLE: u32 = 8;
/// Numbers of a pair that is near, after its first three.
const NEAR: usize = 9;
/// Numbers of a patch.
const PATCH: usize = 25;
/// Numbers of what a pair exerts.
const EXERTED: usize = 27;

fn put_pair(message: &mut Vec<u8>, pair: &FoundPair, slot: &Slot) {
    // The blocks are known, and what few have is written elsewhere.
    let FoundPair {
        ends: _,
        image: _,
        offset: _,
        clock: _,
        start,
        next,
        depth,
        gap,
        seated,
        patches,
    } = pair;
    let Slot { at, touching, area, nearing, negligible_impact, weight, late, every } = slot;
    let near = is_near(pair);
    let bit = |set: bool, bit: u32| if set { bit } else { 0 };
    let state = bit(near, IS_NEAR)
        | bit(*seated, SEATED)
        | bit(*touching, TOUCHING)
        | bit(*negligible_impact, NEGLIGIBLE);
    put(message, &[state.into(), *gap, *nearing]);
    if !near {
        return;
    }
    let count = patches.len() as f64;
    let at = at.map_or(0.0, |at| f64::from(at) + 1.0);
    let [start, next] = [start, next].map(number_of_faces);
    put(message, &[count, start, next, *depth, at, *area, *weight, *late, f64::from(*every)]);
    for patch in patches {
        put(message, &numbers_of_patch(patch));
    }
}

/// Of a pair that stays apart the gap is enough: everything else is that of a pair of which nothing is known.
fn take_pair(rest: &mut &[u8], pair: &mut FoundPair, slot: &mut Slot) -> Option<()> {
    let [state, gap, nearing] = next(rest)?;
    let is = |bit: u32| state as u32 & bit != 0;
    (pair.offset, pair.clock) = (None, None);
    (pair.gap, pair.seated) = (gap, is(SEATED));
    pair.patches.clear();
    if !is(IS_NEAR) {
        (pair.start, pair.next, pair.depth) = (None, None, 0.0);
        *slot = Slot { nearing, ..Slot::default() };
        return Some(());
    }
    let [count, start, after, depth, at, area, weight, late, every] = next(rest)?;
    (pair.start, pair.next, pair.depth) = (faces_of(start), faces_of(after), depth);
    for _ in 0..count as usize {
        pair.push(patch_of(next(rest)?));
    }
    *slot = Slot {
        at: (at > 0.0).then_some((at - 1.0) as u8),
        touching: is(TOUCHING),
        area,
        nearing,
        negligible_impact: is(NEGLIGIBLE),
        weight,
        late,
        every: every as u32,
    };
    Some(())
}

/// The next numbers of a message, if it has as many.
fn next<const N: usize>(rest: &mut &[u8]) -> Option<[f64; N]> {
    let mut numbers = [0.0; N];
    (rest.len() >= 8 * N).then(|| take(rest, &mut numbers))?;
    Some(numbers)
}

/// 0 for none.
fn number_of_faces(faces: &Option<[u16; 2]>) -> f64 {
    faces.map_or(0.0, |[a, b]| 1.0 + f64::from(a) + f64::from(b) * 65536.0)
}

fn faces_of(number: f64) -> Option<[u16; 2]> {
    let both = (number as u64).checked_sub(1)?;
    Some([both as u16, (both >> 16) as u16])
}

fn numbers_of_patch(patch: &ContactPatch) -> [f64; PATCH] {
    let ContactPatch { key, memory, stored, force: f, pressed, depth, area } = patch;
    let Memory { shear: s, torsion, normal: n, area: of, polar, sliding, arms: [a, b] } = memory;
    let [piece, facet] = key.map(f64::from);
    let sliding = f64::from(u8::from(*sliding));
    [
        piece, facet, s.x, s.y, s.z, *torsion, n.x, n.y, n.z, *of, *polar, sliding, a.x, a.y, a.z,
        b.x, b.y, b.z, *stored, f.x, f.y, f.z, *pressed, *depth, *area,
    ]
}

fn patch_of(numbers: [f64; PATCH]) -> ContactPatch {
    let [piece, facet, rest @ ..] = numbers;
    let [sx, sy, sz, torsion, nx, ny, nz, of, polar, sliding, rest @ ..] = rest;
    let [ax, ay, az, bx, by, bz, stored, fx, fy, fz, pressed, depth, area] = rest;
    let memory = Memory {
        shear: Vec3::new(sx, sy, sz),
        torsion,
        normal: Vec3::new(nx, ny, nz),
        area: of,
        polar,
        sliding: sliding != 0.0,
        arms: [Vec3::new(ax, ay, az), Vec3::new(bx, by, bz)],
    };
    let key = [piece as u32, facet as u32];
    ContactPatch { key, memory, stored, force: Vec3::new(fx, fy, fz), pressed, depth, area }
}

fn numbers_of_exerted(exerted: &Exerted) -> [f64; EXERTED] {
    let Exerted { elastic, spring, drag } = exerted;
    let mut numbers = [0.0; EXERTED];
    let vectors = [elastic, spring, drag].map(|w| [w.force, w.moment_a, w.moment_b]);
    for (to, vector) in numbers.as_chunks_mut().0.iter_mut().zip(vectors.as_flattened()) {
        *to = vector.to_array();
    }
    numbers
}

fn exerted_of(numbers: [f64; EXERTED]) -> Exerted {
    let vector = |k: usize| Vec3::new(numbers[k], numbers[k + 1], numbers[k + 2]);
    let wrench =
        |k: usize| Wrench { force: vector(k), moment_a: vector(k + 3), moment_b: vector(k + 6) };
    Exerted { elastic: wrench(0), spring: wrench(9), drag: wrench(18) }
}

#[cfg(test)]
mod tests {
    use riprap_core::peers::value_of;

    use super::*;
    use crate::kernel::PairKey;
    use crate::kernel::offset::Carried;

    /// Numbers that differ, among them those that a sum or a comparison would change.
    fn numbers<const N: usize>() -> [f64; N] {
        std::array::from_fn(|k| match k {
            2 => -0.0,
            5 => f64::NAN,
            9 => f64::MIN_POSITIVE / 8.0,
            // What is no number in its struct.
            _ => k as f64,
        })
    }

    fn bits<const N: usize>(numbers: [f64; N]) -> [u64; N] {
        numbers.map(f64::to_bits)
    }

    #[test]
    fn every_number_comes_back() {
        let mut patch = numbers::<PATCH>();
        patch[11] = 1.0;
        assert_eq!(bits(numbers_of_patch(&patch_of(patch))), bits(patch));
        let exerted = numbers();
        assert_eq!(bits(numbers_of_exerted(&exerted_of(exerted))), bits(exerted));
        for faces in [None, Some([0, 0]), Some([1, 0]), Some([65535, 65535]), Some([7, 300])] {
            assert_eq!(faces_of(number_of_faces(&faces)), faces);
        }
    }

    fn near(ends: [u32; 2]) -> FoundPair {
        let mut pair = FoundPair::new(PairKey { ends, ..PairKey::default() });
        (pair.start, pair.next, pair.depth, pair.seated) = (Some([1, 2]), Some([3, 4]), 0.5, true);
        for key in 1..3 {
            pair.push(ContactPatch { key: [key, 0], depth: 0.25, ..ContactPatch::default() });
        }
        pair
    }

    #[test]
    fn another_rank_knows_what_it_is_sent() {
        let apart = FoundPair {
            gap: 2.0,
            ..FoundPair::new(PairKey { ends: [4, 5], ..PairKey::default() })
        };
        let rich =
            FoundPair { offset: Some(Box::new(Offset::new(Carried::default()))), ..near([2, 3]) };
        let pairs = [near([0, 1]), rich, apart];
        let slot = Slot { at: Some(0), touching: true, every: 8, late: -1.0, ..Slot::default() };
        let slots = [
            slot,
            Slot { nearing: 3.0, ..Slot::default() },
            Slot { nearing: 4.0, ..Slot::default() },
        ];
        let mut group = PairGroup::default();
        group.push(exerted_of(std::array::from_fn(|k| k as f64)));
        group.note(Impact { square: 1.0, energy: 2.0, pair: 0 });
        let groups = [group];
        let message = message(1.0, &pairs, &slots, &groups, vec![9]);
        // What the other rank knew before is that of another step: the second pair was near, the third too.
        let keys = pairs.each_ref().map(FoundPair::key);
        let mut theirs = [FoundPair::new(keys[0]), near(keys[1].ends), near(keys[2].ends)];
        let (mut their_slots, mut their_groups) = ([slot; 3], [PairGroup::default()]);
        let (head, numbers) = split(&message).expect("a head");
        let head: Head = value_of(head).expect("a head");
        assert!(read(&head, numbers, &mut theirs, &mut their_slots, &mut their_groups));
        for rare in head.rare {
            (theirs[rare.pair as usize].offset, theirs[rare.pair as usize].clock) =
                (rare.offset, rare.clock);
        }
        assert_eq!(theirs, pairs);
        assert_eq!(their_slots, slots);
        assert_eq!(their_groups[0].exerted, groups[0].exerted);
        assert_eq!(
            (their_groups[0].impacts.clone(), their_groups[0].sums),
            (groups[0].impacts.clone(), groups[0].sums)
        );
        assert_eq!(head.beside, [9]);
    }

    #[test]
    fn a_message_that_is_cut_short_is_no_message() {
        let message =
            message(1.0, &[near([0, 1])], &[Slot::default()], &[PairGroup::default()], Vec::new());
        for length in [0, 4, 12, message.len() - 8] {
            let whole = split(&message[..length]).and_then(|(head, numbers)| {
                let head: Head = value_of(head)?;
                let (mut pair, mut slot) = ([near([0, 1])], [Slot::default()]);
                Some(read(&head, numbers, &mut pair, &mut slot, &mut [PairGroup::default()]))
            });
            assert_ne!(whole, Some(true), "{length}");
        }
    }
}
