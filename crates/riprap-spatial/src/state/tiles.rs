//! How the model is cut for threads, and the order in which each block's forces are added.
//!
//! **Groups** of [`GROUP`] consecutive blocks are part of the model: patches are stored by the group of their block i,
//! then by axis, i and j, and partial sums of works run over a group and then over a fixed tree of groups
//! ([`crate::state::sums::tree`]). **Pieces** are whole groups in a row, so many that the threads have enough of them
//! ([`Cut::of`]); they may be of any size and never enter a result.
//!
//! Forces on a block are added one patch after another, and floating-point sums depend on their order. It is given by
//! the numbers of the blocks alone. With block `b` in group `g` (drawn for six groups in two pieces; `i` is the first
//! block of a patch, and nearly always the smaller number):
//!
//! ```text
//!            piece 0                  piece 1
//!    [ 0 ]   [ 1 ]   [ 2 ] | [ 3 ]   [ 4 ]   [ 5 ]      groups of block i
//!      5       4       3   |   2       1 (g)   6        their turn in the sum of b
//!      slots: second pass  | first pass        slots
//! ```
//!
//! 1. the patches whose i is in group `g`, by axis, then i, then j;
//! 2. those whose i is in an earlier group, the nearest group first;
//! 3. those whose i is in a later group (periodic models), the last group first.
//!
//! A piece works through its groups from the last to the first, so that it can add 1. and its share of 2. to the sums of
//! its blocks at once. What comes from another piece, and all of 3., goes to a **slot**, and a second pass adds the slots
//! in the order above. Wherever the pieces are cut, each block sees the same numbers in the same order; ranks or a device
//! can follow the list too.

use std::ops::Range;

pub use riprap_core::sums::GROUP;

use crate::lanes::LANES;
use crate::state::patches::{PatchClass, Patches};
use crate::state::world::World;

/// Most blocks in a piece. Larger ones than a cache holds pay: fewer patches reach into another piece and send their parts through slots
/// (a lattice of 262,144 blocks takes a fifth more time with 2048).
const LARGEST_PIECE: usize = 16384;

/// Fewest pieces that a model should have, and pieces for each thread: more of them would send more patches through slots.
const PIECES: usize = 16;
const PIECES_A_THREAD: usize = 4;

/// Group of a block.
#[inline]
#[must_use]
pub fn group_of(block: u32) -> u32 {
    block / GROUP as u32
}

/// How the work on a model is cut; results are the same bits for any.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// Blocks per piece: a multiple of [`GROUP`].
    pub piece: usize,
    /// Most patches in a packet: 1 to [`LANES`].
    pub packet: usize,
}

impl Cut {
    /// The cut that suits a model of so many blocks on so many threads.
    #[must_use]
    pub fn of(blocks: usize, threads: usize) -> Self {
        let pieces = PIECES.max(PIECES_A_THREAD * threads);
        let piece = blocks.div_ceil(pieces).next_multiple_of(GROUP);
        Self { piece: piece.clamp(GROUP, LARGEST_PIECE), packet: LANES }
    }
}

/// Up to eight patches of one axis and one group.
#[derive(Clone, Copy, Debug, Default)]
pub struct Packet {
    /// First patch.
    pub first: u32,
    /// Slot of the first patch where the parts for blocks j go to slots, or [`Packet::DIRECT`].
    slot: u32,
    /// Number of patches.
    pub count: u8,
    /// Axis of their normals; 3 for any other direction.
    pub axis: u8,
    /// Whether blocks i lie side by side in the lists and blocks j too, and eight can be read from the first on.
    pub runs: bool,
    /// Whether all are of one class.
    pub one_class: bool,
}

impl Packet {
    const DIRECT: u32 = u32::MAX;

    /// Bits of its patches.
    #[inline(always)]
    #[must_use]
    pub fn all(&self) -> u8 {
        u8::MAX >> (LANES - usize::from(self.count))
    }

    /// Slot of its first patch; `None` where the parts for blocks j are added at once.
    #[inline(always)]
    #[must_use]
    pub fn slot(&self) -> Option<usize> {
        (self.slot != Self::DIRECT).then_some(self.slot as usize)
    }
}

/// Blocks in a row, of one group, that are alike and free: same mass, no support, no load, no wall of a cavity, no found contact near, no face with a
/// condition, small rotations.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// The blocks.
    pub blocks: Range<usize>,
    /// Their mass properties, an index into `World::solids`.
    pub solid: u32,
}

/// One piece.
#[derive(Clone, Debug, Default)]
pub struct Tile {
    /// Its blocks: whole groups, but for the last of the model.
    pub blocks: Range<usize>,
    /// Its patches: those whose block i it has.
    pub patches: Range<usize>,
    /// Slots of those of its patches that have one.
    pub slots: Range<usize>,
    /// Entries of [`Tiles::incoming`] for its blocks.
    pub incoming: Range<usize>,
    /// Its faces.
    pub faces: Range<usize>,
    /// Its packets, from its last group to its first.
    pub packets: Range<usize>,
    /// Entries of [`Tiles::rows`] with its blocks.
    pub rows: Range<usize>,
    /// Entries of [`Tiles::special`] with its blocks.
    pub special: Range<usize>,
}

impl Tile {
    /// Number of its groups.
    #[must_use]
    pub fn groups(&self) -> usize {
        self.blocks.len().div_ceil(GROUP)
    }

    /// Number within the piece of the group of one of its blocks.
    #[inline(always)]
    #[must_use]
    pub fn group(&self, block: usize) -> usize {
        (block - self.blocks.start) / GROUP
    }
}

/// Slots in a row that belong to blocks j in a row.
#[derive(Clone, Copy, Debug, Default)]
pub struct Incoming {
    /// First slot.
    pub slot: u32,
    /// First block.
    pub block: u32,
    /// Number of both.
    pub count: u32,
}

/// How the model is cut.
#[derive(Clone, Debug, Default)]
pub struct Tiles {
    /// The pieces, in block order.
    pub list: Vec<Tile>,
    /// Number of slots.
    pub slots: usize,
    /// Slots by the piece of block j, in the order of the sums.
    pub incoming: Vec<Incoming>,
    /// Packets of all tiles.
    pub packets: Vec<Packet>,
    /// Blocks that are done in rows.
    pub rows: Vec<Row>,
    /// Living blocks that are done one by one, ascending.
    pub special: Vec<u32>,
    /// Faces with a condition, ascending: few of all.
    conditioned: Vec<u32>,
}

impl Tiles {
    /// Cuts a world whose patches are sorted (see [`crate::state::patches::Patches::sort`]).
    ///
    /// # Panics
    /// When the pieces are no whole groups, or the packets too large or empty.
    #[must_use]
    pub fn new(world: &World, cut: Cut) -> Self {
        let piece = cut.piece;
        assert!(piece > 0 && piece.is_multiple_of(GROUP) && (1..=LANES).contains(&cut.packet));
        let blocks = world.alive.len();
        let ends = &world.patches.ends;
        let with = (0..).zip(&world.faces).filter(|(_, face)| face.boundary.is_some());
        let mut tiles = Self { conditioned: with.map(|(f, _)| f).collect(), ..Self::default() };
        let (mut patch, mut face) = (0, 0);
        for first in (0..blocks).step_by(piece) {
            let end = (first + piece).min(blocks);
            let (first_patch, first_face) = (patch, face);
            while patch < ends.len() && (ends[patch][0] as usize) < end {
                patch += 1;
            }
            while face < world.faces.len() && (world.faces[face].block as usize) < end {
                face += 1;
            }
            tiles.list.push(Tile {
                blocks: first..end,
                patches: first_patch..patch,
                faces: first_face..face,
                ..Tile::default()
            });
        }
        tiles.make_packets(world, cut);
        tiles.make_incoming(ends, piece);
        tiles.make_rows(world);
        tiles
    }

    /// Those of a run of faces that have a condition.
    #[must_use]
    pub fn conditioned(&self, of: Range<usize>) -> &[u32] {
        let [first, end] =
            [of.start, of.end].map(|at| self.conditioned.partition_point(|f| (*f as usize) < at));
        &self.conditioned[first..end]
    }

    /// Number of groups of the model.
    #[must_use]
    pub fn groups(&self) -> usize {
        self.list.iter().map(Tile::groups).sum()
    }

    /// Cuts the patches into packets and gives out slots.
    fn make_packets(&mut self, world: &World, cut: Cut) {
        let (list, piece) = (&world.patches, cut.piece);
        let by_groups = |p: &u32, q: &u32| {
            let group = |p: &u32| group_of(list.ends[*p as usize][0]);
            group(p) == group(q)
        };
        let slotted = |p: usize| {
            let [i, j] = list.ends[p];
            // Also where block i is in a later group of the same piece: its group is worked
            // off first, but its turn in the sum of j comes last.
            i as usize / piece != j as usize / piece || group_of(i) > group_of(j)
        };
        for tile in &mut self.list {
            let (first_packet, first_slot) = (self.packets.len(), self.slots);
            let patches: Vec<u32> = tile.patches.clone().map(|p| p as u32).collect();
            let groups: Vec<&[u32]> = patches.chunk_by(by_groups).collect();
            // The nearest of the earlier groups comes first in the sum of a block.
            for group in groups.into_iter().rev() {
                let first = group[0] as usize;
                let patches = first..first + group.len();
                pack(world, patches, cut.packet, slotted, &mut self.packets);
            }
            tile.packets = first_packet..self.packets.len();
            // Numbered in the order of the work, so that the slots of a piece lie in a row and can be lent to it.
            for packet in &mut self.packets[tile.packets.clone()] {
                if packet.slot != Packet::DIRECT {
                    packet.slot = self.slots as u32;
                    self.slots += usize::from(packet.count);
                }
            }
            tile.slots = first_slot..self.slots;
        }
    }

    /// Lists the slots by the piece of block j, in the order in which they are added.
    fn make_incoming(&mut self, ends: &[[u32; 2]], piece: usize) {
        let (tiles, packets) = (&self.list, &self.packets);
        // From the last group to the first: once for patches from earlier groups, then for those from later ones.
        let slots = |late: bool| {
            let packets = tiles.iter().rev().flat_map(|t| &packets[t.packets.clone()]);
            packets
                .filter_map(|packet| Some((packet, packet.slot()?)))
                .flat_map(|(packet, slot)| {
                    let first = packet.first as usize;
                    (0..usize::from(packet.count)).map(move |k| (slot + k, ends[first + k]))
                })
                .filter(move |(_, [i, j])| (group_of(*i) > group_of(*j)) == late)
                .map(|(slot, [_, j])| (slot as u32, j))
        };
        // Sorted by counting, which keeps the order within a piece.
        let mut counts = vec![0usize; tiles.len() + 1];
        for (_, j) in slots(false).chain(slots(true)) {
            counts[j as usize / piece + 1] += 1;
        }
        for t in 0..tiles.len() {
            counts[t + 1] += counts[t];
        }
        let mut next = counts.clone();
        let mut incoming = vec![[0; 2]; self.slots];
        for (slot, j) in slots(false).chain(slots(true)) {
            let at = &mut next[j as usize / piece];
            incoming[*at] = [slot, j];
            *at += 1;
        }
        for (t, tile) in self.list.iter_mut().enumerate() {
            let first = self.incoming.len();
            for &[slot, block] in &incoming[counts[t]..counts[t + 1]] {
                match self.incoming[first..].last_mut() {
                    Some(r)
                        if [slot.wrapping_sub(r.slot), block.wrapping_sub(r.block)]
                            == [r.count; 2] =>
                    {
                        r.count += 1;
                    }
                    _ => self.incoming.push(Incoming { slot, block, count: 1 }),
                }
            }
            tile.incoming = first..self.incoming.len();
        }
    }

    /// Sorts the blocks into rows and special ones; to be called again when supports or kinematics change.
    pub fn make_rows(&mut self, world: &World) {
        self.rows.clear();
        self.special.clear();
        let mut pushed = world.pushed();
        let deformable = world.found.deformable.pairs.iter().flat_map(|pair| pair.ends);
        for b in (world.found.pairs.iter().flat_map(|pair| pair.ends)).chain(deformable) {
            pushed[b as usize] = true;
        }
        // Anyone may come down on it, and rows are not laid out again when one does.
        if world.has_terrain() {
            pushed.fill(true);
        }
        let mut faces = self.conditioned.iter().map(|f| &world.faces[*f as usize]).peekable();
        for tile in &mut self.list {
            let (rows, special) = (self.rows.len(), self.special.len());
            for b in tile.blocks.clone() {
                let mut touched = false;
                while faces.next_if(|f| f.block as usize == b).is_some() {
                    touched = true;
                }
                if !world.alive[b] || world.deforms(b) {
                    continue;
                }
                let plain = !touched
                    && !pushed[b]
                    && world.motion[b].is_none()
                    && world.turned[b].is_none()
                    // Rows take the moments about x, y and z each by itself.
                    && world.solid_of(b).diagonal;
                if !plain {
                    self.special.push(b as u32);
                    continue;
                }
                let solid = world.solid[b];
                match self.rows[rows..].last_mut() {
                    Some(row)
                        if row.blocks.end == b
                            && row.solid == solid
                            // A row ends with its group, over which works are summed.
                            && !b.is_multiple_of(GROUP) =>
                    {
                        row.blocks.end += 1;
                    }
                    _ => self.rows.push(Row { blocks: b..b + 1, solid }),
                }
            }
            tile.rows = rows..self.rows.len();
            tile.special = special..self.special.len();
        }
    }
}

impl Patches {
    /// Puts patches in their order: by group of block i, then by axis, block i and block j.
    pub fn sort(&mut self, classes: &[PatchClass]) {
        let mut order: Vec<u32> = (0..self.len() as u32).collect();
        order.sort_by_key(|&p| {
            let [i, j] = self.ends[p as usize];
            let axis = classes[self.class[p as usize] as usize].axis;
            (group_of(i), axis, i, j)
        });
        self.keep(&order);
    }
}

/// Cuts the patches of a group into packets, which need slots (their numbers come later) or do not.
fn pack(
    world: &World,
    patches: Range<usize>,
    most: usize,
    slotted: impl Fn(usize) -> bool,
    packets: &mut Vec<Packet>,
) {
    let (list, blocks) = (&world.patches, world.alive.len());
    let axis = |p: usize| world.classes[list.class[p] as usize].axis;
    let mut p = patches.start;
    while p < patches.end {
        let most = patches.end.min(p + most);
        let alike = |q: &usize| axis(*q) == axis(p) && slotted(*q) == slotted(p);
        let end = (p..most).find(|q| !alike(q)).unwrap_or(most);
        let [i, j] = list.ends[p];
        let side_by_side = |q: usize| list.ends[q] == [i + (q - p) as u32, j + (q - p) as u32];
        packets.push(Packet {
            first: p as u32,
            slot: if slotted(p) { 0 } else { Packet::DIRECT },
            count: (end - p) as u8,
            axis: axis(p),
            // Eight lanes are read even where fewer count, and must not go beyond the lists.
            runs: i.max(j) as usize + LANES <= blocks && (p..end).all(side_by_side),
            one_class: (p..end).all(|q| list.class[q] == list.class[p]),
        });
        p = end;
    }
}
