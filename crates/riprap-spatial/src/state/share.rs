//! How a step is shared out among ranks, and what travels.
//!
//! Each rank has the whole model and computes a run of whole pieces ([`crate::state::tiles`]): joints, sums, kick and motion of
//! their blocks. Three messages a step go from each rank to each other one:
//!
//! 1. slots: what its patches exert on blocks of that rank, and its share of the losses;
//! 2. sums of its blocks, memory of its patches and faces that have any, and its share of the works;
//! 3. motion of its blocks.
//!
//! Pairs of found contact are shared out by themselves (`contact/shared.rs`) in one message more. Then every rank knows all of the state,
//! and whatever else there is (search, gas, bolts, seepage, splitting, records,
//! guards) is done by all alike from the same numbers. Where nobody reads the state of a step, only what lies at the cut travels
//! ([`apart`]). Shares of sums over the model are whole branches of the fixed tree
//! ([`riprap_core::sums::Shared`]). So bits are those of one rank, wherever the model is cut.
//!
//! What a rank that is gone has not sent stays as it was: the run ends before anybody looks at it ([`crate::exec::Exec::peers`]).

pub(crate) mod apart;

use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

use riprap_core::peers::{Message, Peers, bytes_of, put, take};
use riprap_core::sums::Shared;
use riprap_geom::{Quat, Vec3};

use crate::accounts::Account;
use crate::ledger::Works;
use crate::setup::rotation::rotation_vector;
use crate::state::bodies::{Bodies, Turned};
use crate::state::cuts::Cuts;
use crate::state::face::Face;
use crate::state::patches::Patches;
use crate::state::scratch::{FaceEntry, Lost, Partial};
use crate::state::sums::Sums;
use crate::state::tiles::{Tile, Tiles};
use crate::state::world::World;

/// What of a model one rank computes, and what it sends to others.
#[derive(Debug)]
pub(crate) struct Share {
    pub(crate) peers: Arc<Peers>,
    /// The pieces.
    cuts: Cuts,
    /// Groups of pairs of found contact.
    pub(crate) pairs: Cuts,
    /// The groups of blocks.
    groups: Shared,
    /// Slots of this rank that each rank adds to its blocks, and of each rank that this one does.
    slots: [Vec<Vec<Range<usize>>>; 2],
    /// Blocks of this rank with slots of each rank's patches, which must know their motion, and of each rank with slots of this one.
    near: [Vec<Vec<Range<usize>>>; 2],
    /// Set where only what lies at the cut travels in this step: the longest one that the search for contacts allows, s.
    apart: Option<f64>,
    /// Whether this rank knows of the others' blocks only those at the cut as they are now.
    behind: bool,
    /// Whether its patches remembered anything before the laws were applied.
    before: Vec<bool>,
    /// Time that its pieces have taken in this step.
    spent: Duration,
}

impl Share {
    /// The share of one of several ranks in a model that is cut like this; `old`: its share until now.
    pub(crate) fn new(tiles: &Tiles, peers: &Arc<Peers>, old: Option<Self>) -> Self {
        let (size, count) = (peers.size(), tiles.list.len());
        let (cuts, pairs) = match old {
            Some(Self { mut cuts, pairs, .. }) => {
                cuts.fit(count);
                (cuts, pairs)
            }
            None => (Cuts::new(size, count), Cuts::new(size, 0)),
        };
        let mut share = Self {
            peers: peers.clone(),
            cuts,
            pairs,
            groups: Shared::default(),
            slots: [Vec::new(), Vec::new()],
            near: [Vec::new(), Vec::new()],
            apart: None,
            behind: false,
            before: Vec::new(),
            spent: Duration::ZERO,
        };
        share.list(tiles);
        share
    }

    /// Lists what travels.
    fn list(&mut self, tiles: &Tiles) {
        let group = |tile: usize| tiles.list[..tile].iter().map(Tile::groups).sum();
        self.groups = Shared::new(self.cuts.bounds().iter().map(|tile| group(*tile)).collect());
        self.slots = [0, 1].map(|_| vec![Vec::new(); self.peers.size()]);
        self.near = self.slots.clone();
        self.list_slots(tiles);
        for list in self.near.iter_mut().flatten() {
            apart::merge(list);
        }
    }

    /// Books what a stage of its pieces has taken.
    pub(crate) fn book(&mut self, spent: Duration) {
        self.spent += spent;
    }

    fn list_slots(&mut self, tiles: &Tiles) {
        let rank = self.peers.rank();
        for to in 0..self.peers.size() {
            let incoming =
                self.pieces(to).flat_map(|t| &tiles.incoming[tiles.list[t].incoming.clone()]);
            let runs = incoming.map(|run| {
                (run.slot as usize..(run.slot + run.count) as usize, run.block as usize)
            });
            for (run, first) in runs.collect::<Vec<_>>() {
                // Slots in a row may be of several pieces.
                let mut at = run.start;
                while at < run.end {
                    let tile = tiles.list.partition_point(|tile| tile.slots.end <= at);
                    let from = self.cuts.bounds().partition_point(|first| *first <= tile) - 1;
                    let end = run.end.min(tiles.list[tile].slots.end);
                    let blocks = first + at - run.start..first + end - run.start;
                    if from != to && from == rank {
                        self.slots[0][to].push(at..end);
                        self.near[1][to].push(blocks.clone());
                    }
                    if from != to && to == rank {
                        self.slots[1][from].push(at..end);
                        self.near[0][from].push(blocks);
                    }
                    at = end;
                }
            }
        }
    }

    fn pieces(&self, rank: usize) -> Range<usize> {
        self.cuts.part(rank)
    }

    /// Pieces of this rank.
    pub(crate) fn own(&self) -> Range<usize> {
        self.pieces(self.peers.rank())
    }

    /// Items of the pieces of a rank, of which each piece has the run that `of` says.
    fn items(
        &self,
        tiles: &Tiles,
        rank: usize,
        of: impl Fn(&crate::state::tiles::Tile) -> &Range<usize>,
    ) -> Range<usize> {
        match &tiles.list[self.pieces(rank)] {
            [] => 0..0,
            [first, .., last] => of(first).start..of(last).end,
            [one] => of(one).clone(),
        }
    }

    /// What the others have sent, with their numbers.
    pub(crate) fn others(&self, all: Vec<Message>) -> impl Iterator<Item = (usize, Message)> {
        let rank = self.peers.rank();
        all.into_iter().enumerate().filter(move |(from, _)| *from != rank)
    }

    /// The part of this rank of a list that all ranks go through alike.
    pub(crate) fn equal_part(&self, count: usize) -> Range<usize> {
        let (rank, size) = (self.peers.rank(), self.peers.size());
        rank * count / size..(rank + 1) * count / size
    }

    /// The smallest number that any rank has found.
    pub(crate) fn smallest(&self, own: f64) -> f64 {
        let mut message = Vec::new();
        put(&mut message, &[own]);
        let all = self.peers.gather(message).unwrap_or_default();
        all.iter().fold(own, |smallest, message| {
            let mut theirs = [own];
            take(&mut &message[..], &mut theirs);
            smallest.min(theirs[0])
        })
    }

    /// Keeps what the patches of this rank remember before the laws are applied, as the others know it.
    pub(crate) fn begin(&mut self, tiles: &Tiles, patches: &Patches) {
        if self.behind {
            return;
        }
        let own = self.items(tiles, self.peers.rank(), |tile| &tile.patches);
        self.before.clear();
        self.before.extend(own.map(|p| patches.remembers(p)));
    }

    /// Exchanges slots and losses; the losses of all are in the first of the list then.
    pub(crate) fn slots(&self, slots: &mut [Sums; 2], lost: &mut [Lost]) {
        let rank = self.peers.rank();
        self.groups.add_own(rank, lost, Lost::add);
        let mut losses = Vec::new();
        for top in self.groups.tops(rank) {
            put(&mut losses, &[lost[top].friction, lost[top].fracture]);
        }
        let message = |to: usize| {
            let mut message = losses.clone();
            for list in slots.iter().filter(|s| !s.is_empty()).flat_map(|s| &s.lists) {
                for run in &self.slots[0][to] {
                    put(&mut message, &list[run.clone()]);
                }
            }
            Arc::new(message)
        };
        let to = (0..self.peers.size()).map(message).collect();
        for (from, message) in self.others(self.peers.exchange(to).unwrap_or_default()) {
            let mut message = &message[..];
            for top in self.groups.tops(from) {
                let mut pair = [0.0; 2];
                take(&mut message, &mut pair);
                [lost[top].friction, lost[top].fracture] = pair;
            }
            for list in slots.iter_mut().filter(|s| !s.is_empty()).flat_map(|s| &mut s.lists) {
                for run in &self.slots[1][from] {
                    take(&mut message, &mut list[run.clone()]);
                }
            }
        }
        self.groups.add_all(lost, Lost::add);
    }

    /// Gives the sums of all blocks, the memory of all patches and faces, and the works to all; the works of all are in the
    /// first of the list then. The first block whose forces are not finite.
    ///
    /// Of a step that nobody reads sums and the memory of patches stay where they are.
    pub(crate) fn sums(&mut self, tiles: &Tiles, of: &mut Gathered<'_>) -> Option<u32> {
        self.behind |= self.apart.is_some();
        let rank = self.peers.rank();
        let own = &mut *of.partial;
        let groups = self.items(tiles, rank, |tile| &tile.blocks);
        let groups = groups.start / super::tiles::GROUP..groups.end.div_ceil(super::tiles::GROUP);
        let bad = own[groups].iter().find_map(|p| p.bad);
        self.groups.add_own(rank, own, Partial::add);
        let tops = self.groups.tops(rank);
        let tops: Vec<[Works; 2]> = tops.map(|k| [own[k].arrival, own[k].departure]).collect();
        let faces_of = |rank: usize| tiles.conditioned(self.items(tiles, rank, |tile| &tile.faces));
        let (faces, entries) = of.own_faces(faces_of(rank));
        let all = self.apart.is_none();
        let patches = if all { self.changed(tiles, of.patches) } else { Vec::new() };
        let told = Told { bad, tops, patches, faces, entries };
        let mut message = bytes_of(&told);
        let blocks = self.items(tiles, rank, |tile| &tile.blocks);
        let mut head = (message.len() as u64).to_le_bytes().to_vec();
        head.append(&mut message);
        for list in of.sums.iter().filter(|s| all && !s.is_empty()).flat_map(|s| &s.lists) {
            put(&mut head, &list[blocks.clone()]);
        }
        let mut first = [bad].into_iter().collect::<Vec<_>>();
        first.resize(self.peers.size(), None);
        first.swap(0, rank);
        for (from, message) in self.others(self.peers.gather(head).unwrap_or_default()) {
            let Some((told, mut rest)) = self.told(from, &message) else {
                continue;
            };
            first[from] = told.bad;
            for (top, [arrival, departure]) in self.groups.tops(from).zip(told.tops) {
                of.partial[top] = Partial { arrival, departure, ..Partial::default() };
            }
            for memory in told.patches {
                memory.put(of.patches);
            }
            of.put_faces(faces_of(from), &told.faces, &told.entries);
            let blocks = self.items(tiles, from, |tile| &tile.blocks);
            let sums = of.sums.iter_mut().filter(|s| all && !s.is_empty());
            for list in sums.flat_map(|s| &mut s.lists) {
                take(&mut rest, &mut list[blocks.clone()]);
            }
        }
        self.groups.add_all(of.partial, Partial::add);
        first.into_iter().flatten().next()
    }

    fn told<'m>(&self, from: usize, message: &'m [u8]) -> Option<(Told, &'m [u8])> {
        let (head, rest) = message.split_first_chunk()?;
        let (told, rest) = rest.split_at_checked(u64::from_le_bytes(*head) as usize)?;
        Some((self.peers.read(from, told)?, rest))
    }

    /// What the patches of this rank remember that do or did.
    fn changed(&self, tiles: &Tiles, patches: &Patches) -> Vec<Remembered> {
        let own = self.items(tiles, self.peers.rank(), |tile| &tile.patches);
        let remembers = |(p, before): &(usize, &bool)| **before || patches.remembers(*p);
        let list = own.zip(&self.before).filter(remembers);
        list.map(|(p, _)| Remembered::of(patches, p)).collect()
    }

    /// Gives the motion of all blocks in a step of `dt` (s) to all, of a step that nobody reads that of the blocks at the cut to those who
    /// need it, and ends the step: the model is cut again where ranks are out of balance.
    /// Whether a block has turned far. Velocities travel; what follows from them is found again, by the operations of
    /// [`crate::rigid::integrate`].
    pub(crate) fn motion(
        &mut self,
        tiles: &Tiles,
        world: &mut World,
        sums: [&mut Sums; 2],
        (dt, turning): (f64, bool),
    ) -> bool {
        let (rank, size) = (self.peers.rank(), self.peers.size());
        let spent = std::mem::take(&mut self.spent).as_secs_f64();
        let mut times = vec![spent; size];
        let mut head = vec![u8::from(turning)];
        put(&mut head, &[spent]);
        let all = std::slice::from_ref;
        let parts: Vec<_> = (0..size).map(|r| self.items(tiles, r, |tile| &tile.blocks)).collect();
        let apart = self.apart.is_some();
        let messages = if apart {
            let of = |to: usize| {
                let mut message = head.clone();
                put_rates(&mut message, world, &self.near[0][to]);
                Arc::new(message)
            };
            self.peers.exchange((0..size).map(of).collect())
        } else {
            put_rates(&mut head, world, all(&parts[rank]));
            self.peers.gather(head)
        };
        let mut any = turning;
        for (from, message) in self.others(messages.unwrap_or_default()) {
            let Some((turning, mut rest)) = message.split_first() else {
                continue;
            };
            any |= *turning != 0;
            take(&mut rest, std::slice::from_mut(&mut times[from]));
            if apart {
                let blocks = &self.near[1][from];
                take_rates(&mut rest, world, blocks);
                for b in blocks.iter().cloned().flatten() {
                    follow_block(world, b, dt);
                }
                continue;
            }
            take_rates(&mut rest, world, all(&parts[from]));
            for tile in &tiles.list[self.pieces(from)] {
                for row in &tiles.rows[tile.rows.clone()] {
                    follow_row(world, row.blocks.clone(), dt);
                }
                for b in &tiles.special[tile.special.clone()] {
                    follow_block(world, *b as usize, dt);
                }
            }
        }
        if let Some(bounds) = self.cuts.book(&times) {
            // Whoever takes over a block must know it.
            self.settle(tiles, world, sums);
            self.cuts.cut_at(bounds);
            self.list(tiles);
        }
        any
    }
}

/// Appends the velocities of blocks, and the attitude of those that have turned far.
fn put_rates(message: &mut Vec<u8>, world: &World, blocks: &[Range<usize>]) {
    for list in &world.bodies.velocity {
        for run in blocks {
            put(message, &list[run.clone()]);
        }
    }
    let turned = blocks.iter().flat_map(|run| &world.turned[run.clone()]).flatten();
    for Turned { attitude: q, momentum: l } in turned.map(|t| &**t) {
        put(message, &[q.x, q.y, q.z, q.w, l.x, l.y, l.z]);
    }
}

/// Takes what [`put_rates`] has appended.
fn take_rates(rest: &mut &[u8], world: &mut World, blocks: &[Range<usize>]) {
    for list in &mut world.bodies.velocity {
        for run in blocks {
            take(rest, &mut list[run.clone()]);
        }
    }
    for run in blocks {
        for turned in world.turned[run.clone()].iter_mut().flatten() {
            let mut x = [0.0; 7];
            take(rest, &mut x);
            let [a, b, c, d, momentum @ ..] = x;
            let attitude = Quat::from_xyzw(a, b, c, d);
            **turned = Turned { attitude, momentum: Vec3::from_array(momentum) };
        }
    }
}

/// Moves a row of blocks of another rank.
fn follow_row(world: &mut World, row: Range<usize>, dt: f64) {
    let Bodies { displacement, velocity } = &mut world.bodies;
    for (u, v) in displacement.iter_mut().zip(&*velocity) {
        for (u, v) in u[row.clone()].iter_mut().zip(&v[row.clone()]) {
            *u += dt * *v;
        }
    }
    let [x, y, z, ..] = velocity;
    for b in row {
        let square = x[b] * x[b] + y[b] * y[b] + z[b] * z[b];
        let peak = &mut world.peak_speed_squared[b];
        *peak = if square > *peak { square } else { *peak };
    }
}

/// Moves a single block of another rank.
fn follow_block(world: &mut World, b: usize, dt: f64) {
    let (v, w) = (world.bodies.velocity(b), world.bodies.spin(b));
    let u = world.bodies.displacement(b) + dt * v;
    let th = match &world.turned[b] {
        Some(turned) => rotation_vector(turned.attitude),
        None => world.bodies.rotation(b) + dt * w,
    };
    world.bodies.set_displacement(b, u, th);
    let peak = &mut world.peak_speed_squared[b];
    *peak = peak.max(v.length_squared());
}

/// What one of several ranks computes of a model at the start, and sends in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// Blocks.
    pub blocks: usize,
    /// Joints between rigid blocks (patches).
    pub patches: usize,
    /// Those of them whose second block another rank has: the surface of the cut.
    pub cut: usize,
    /// Messages in a step.
    pub messages: usize,
    /// Bytes in them in a step that nobody reads, without what joints, contacts and conditions remember.
    pub bytes: usize,
}

/// How a model is shared out among so many ranks at the start, one part for each.
#[must_use]
pub fn parts(world: &World, ranks: usize) -> Vec<Part> {
    let ranks = ranks.max(1);
    let tiles = Tiles::new(world, super::tiles::Cut::of(world.alive.len(), ranks));
    let cuts = Cuts::new(ranks, tiles.list.len());
    let mut owner = vec![0; world.alive.len()];
    for rank in 0..ranks {
        for tile in &tiles.list[cuts.part(rank)] {
            owner[tile.blocks.clone()].fill(rank);
        }
    }
    let damped = world.classes.iter().any(|class| class.beta > 0.0);
    let sums = if damped { 12 } else { 6 };
    // Velocity and spin.
    let motion = 6;
    let contacts = usize::from(!world.found.pairs.is_empty());
    let mut near: Vec<_> =
        world.patches.ends.iter().map(|[i, j]| (owner[*i as usize], *j)).collect();
    near.sort_unstable();
    near.dedup();
    let apart = apart::feels_neighbours_alone(world);
    (0..ranks)
        .map(|rank| {
            let own = &tiles.list[cuts.part(rank)];
            let blocks = own.iter().map(|tile| tile.blocks.len()).sum();
            let patches = own.iter().flat_map(|tile| tile.patches.clone());
            let cut = patches.clone().filter(|p| owner[world.patches.ends[*p][1] as usize] != rank);
            let (patches, cut) = (patches.clone().count(), cut.count());
            let others = ranks - 1;
            let needed = |(to, b): &&(usize, u32)| *to != rank && owner[*b as usize] == rank;
            let gathered = match apart {
                true => motion * near.iter().filter(needed).count(),
                false => others * blocks * (sums + motion),
            };
            Part {
                blocks,
                patches,
                cut,
                messages: others * (3 + 2 * contacts),
                bytes: 8 * (cut * sums + gathered),
            }
        })
        .collect()
}

/// What is gathered of a kick.
pub(crate) struct Gathered<'a> {
    /// Sums of the blocks.
    pub(crate) sums: [&'a mut Sums; 2],
    pub(crate) patches: &'a mut Patches,
    pub(crate) faces: &'a mut [Face],
    /// Empty where nobody keeps accounts.
    pub(crate) entries: &'a mut [FaceEntry],
    pub(crate) partial: &'a mut [Partial],
}

impl Gathered<'_> {
    /// What the conditions on these faces remember and have done.
    fn own_faces(&self, own: &[u32]) -> (Vec<[Vec3; 4]>, Vec<[Account; 2]>) {
        let own = own.iter().map(|f| *f as usize);
        let (faces, entries) = (&self.faces, &self.entries);
        let anchors = own.clone().filter_map(|f| faces[f].half_block.as_ref()).map(|h| h.anchor);
        let anchors = anchors.collect();
        (anchors, own.filter_map(|f| entries.get(f)).map(|entry| entry.halves).collect())
    }

    fn put_faces(&mut self, of: &[u32], anchors: &[[Vec3; 4]], entries: &[[Account; 2]]) {
        let (mut anchors, mut entries) = (anchors.iter(), entries.iter());
        for f in of.iter().map(|f| *f as usize) {
            if let Some(half) = &mut self.faces[f].half_block
                && let Some(anchor) = anchors.next()
            {
                half.anchor = *anchor;
            }
            if let Some(entry) = self.entries.get_mut(f)
                && let Some(halves) = entries.next()
            {
                entry.halves = *halves;
            }
        }
    }
}

/// What a rank tells of its part besides the sums of its blocks.
#[derive(serde::Serialize, serde::Deserialize)]
struct Told {
    /// The first block whose forces are not finite.
    bad: Option<u32>,
    /// Works before and after the present time, by branches of the tree.
    tops: Vec<[Works; 2]>,
    patches: Vec<Remembered>,
    faces: Vec<[Vec3; 4]>,
    entries: Vec<[Account; 2]>,
}

/// What a patch remembers: as far as any does, by the lists of [`Patches`].
#[derive(serde::Serialize, serde::Deserialize)]
struct Remembered {
    patch: u32,
    flags: u16,
    slip: Option<[[f64; 4]; 2]>,
    normal_offset: Option<[f64; 4]>,
    accumulated_slip: Option<[f64; 4]>,
    wear: Option<[[f64; 4]; 2]>,
}

impl Remembered {
    fn of(patches: &Patches, p: usize) -> Self {
        Self {
            patch: p as u32,
            flags: patches.flags[p],
            slip: patches.slip.get(p).copied(),
            normal_offset: patches.normal_offset.get(p).copied(),
            accumulated_slip: patches.accumulated_slip.get(p).copied(),
            wear: patches.wear.get(p).copied(),
        }
    }

    fn put(&self, patches: &mut Patches) {
        fn put<T: Copy>(list: &mut [T], p: usize, value: Option<T>) {
            if let (Some(to), Some(value)) = (list.get_mut(p), value) {
                *to = value;
            }
        }
        let p = self.patch as usize;
        put(&mut patches.flags, p, Some(self.flags));
        put(&mut patches.slip, p, self.slip);
        put(&mut patches.normal_offset, p, self.normal_offset);
        put(&mut patches.accumulated_slip, p, self.accumulated_slip);
        put(&mut patches.wear, p, self.wear);
    }
}
