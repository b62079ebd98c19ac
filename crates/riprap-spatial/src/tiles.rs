//! Fixed pieces of the model that threads work on.
//!
//! A tile is a range of `TILE` blocks with the patches whose block i is among them: first those with j in the
//! same tile too, added to the sums of the tile at once, then those that cross into another tile, whose
//! part for j goes to a slot. A second pass adds the slots, in patch order. The cut does not depend on the
//! number of threads, so sums are the same bits for any.

use std::ops::Range;

use super::lanes::LANES;
use super::world::{PatchClass, Patches, World};

/// Blocks per tile.
pub const TILE: usize = 2048;

/// Tile of a block.
#[must_use]
pub fn tile_of(block: u32) -> u32 {
    block / TILE as u32
}

/// Up to eight patches of one axis, or patches that are done one by one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Packet {
    /// First patch.
    pub first: u32,
    /// Number of patches.
    pub count: u8,
    /// Axis of their normals; 3 for patches that are done one by one.
    pub axis: u8,
    /// Whether it has eight patches, whose blocks i lie side by side in the lists and their blocks j too.
    pub runs: bool,
    /// Whether all are of one class.
    pub one_class: bool,
}

/// Blocks in a row that are alike and free: same mass, no support, no load, no wall of a cavity, no face with a
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
    /// Its blocks.
    pub blocks: Range<usize>,
    /// Its patches; those from `crossing` on end in another tile.
    pub patches: Range<usize>,
    /// First patch that ends in another tile.
    pub crossing: usize,
    /// Slots of its crossing patches, in patch order.
    pub slots: Range<usize>,
    /// Entries of [`Tiles::incoming`] for its blocks.
    pub incoming: Range<usize>,
    /// Its faces.
    pub faces: Range<usize>,
    /// Its packets; those from `crossing_packet` on end in another tile.
    pub packets: Range<usize>,
    /// First packet that ends in another tile.
    pub crossing_packet: usize,
    /// Entries of [`Tiles::rows`] with its blocks.
    pub rows: Range<usize>,
    /// Entries of [`Tiles::special`] with its blocks.
    pub special: Range<usize>,
}

/// How the model is cut.
#[derive(Clone, Debug, Default)]
pub struct Tiles {
    /// The pieces, in block order.
    pub list: Vec<Tile>,
    /// Number of slots.
    pub slots: usize,
    /// Slot and block j of the crossing patches that end in a tile, by tile and then by slot.
    pub incoming: Vec<[u32; 2]>,
    /// Packets of all tiles.
    pub packets: Vec<Packet>,
    /// Blocks that are done in rows.
    pub rows: Vec<Row>,
    /// Living blocks that are done one by one, ascending.
    pub special: Vec<u32>,
}

impl Tiles {
    /// Cuts a world whose patches are sorted (see [`super::world::Patches::sort`]).
    #[must_use]
    pub fn new(world: &World) -> Self {
        let blocks = world.alive.len();
        let ends = &world.patches.ends;
        let count = blocks.div_ceil(TILE);
        let mut tiles = Self::default();
        let (mut patch, mut slot, mut face) = (0, 0, 0);
        for t in 0..count {
            let first = patch;
            let of_tile = |p: usize| tile_of(ends[p][0]) as usize == t;
            while patch < ends.len() && of_tile(patch) && tile_of(ends[patch][1]) as usize == t {
                patch += 1;
            }
            let crossing = patch;
            while patch < ends.len() && of_tile(patch) {
                patch += 1;
            }
            let first_face = face;
            while face < world.faces.len() && tile_of(world.faces[face].block) as usize == t {
                face += 1;
            }
            tiles.list.push(Tile {
                blocks: t * TILE..((t + 1) * TILE).min(blocks),
                patches: first..patch,
                crossing,
                slots: slot..slot + (patch - crossing),
                faces: first_face..face,
                ..Tile::default()
            });
            slot += patch - crossing;
        }
        tiles.slots = slot;
        let mut counts = vec![0usize; count + 1];
        let crossing = || {
            tiles.list.iter().flat_map(|tile| {
                (tile.crossing..tile.patches.end)
                    .zip(tile.slots.clone())
                    .map(|(p, slot)| (slot as u32, ends[p][1]))
            })
        };
        for (_, j) in crossing() {
            counts[tile_of(j) as usize + 1] += 1;
        }
        for t in 0..count {
            counts[t + 1] += counts[t];
        }
        let mut next = counts.clone();
        let mut incoming = vec![[0; 2]; slot];
        for (slot, j) in crossing() {
            let at = &mut next[tile_of(j) as usize];
            incoming[*at] = [slot, j];
            *at += 1;
        }
        tiles.incoming = incoming;
        for (t, tile) in tiles.list.iter_mut().enumerate() {
            tile.incoming = counts[t]..counts[t + 1];
        }
        tiles.make_packets(world);
        tiles.make_rows(world);
        tiles
    }

    fn make_packets(&mut self, world: &World) {
        for tile in &mut self.list {
            let first = self.packets.len();
            pack(world, tile.patches.start..tile.crossing, &mut self.packets);
            tile.crossing_packet = self.packets.len();
            pack(world, tile.crossing..tile.patches.end, &mut self.packets);
            tile.packets = first..self.packets.len();
        }
    }

    /// Sorts the blocks into rows and special ones; to be called again when supports or kinematics change.
    pub fn make_rows(&mut self, world: &World) {
        self.rows.clear();
        self.special.clear();
        let pushed = world.pushed();
        let mut faces = world
            .faces
            .iter()
            .filter(|f| f.boundary.is_some())
            .peekable();
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
                    && world.solid_of(b).diagonal;
                if !plain {
                    self.special.push(b as u32);
                    continue;
                }
                let solid = world.solid[b];
                match self.rows[rows..].last_mut() {
                    Some(row) if row.blocks.end == b && row.solid == solid => row.blocks.end += 1,
                    _ => self.rows.push(Row {
                        blocks: b..b + 1,
                        solid,
                    }),
                }
            }
            tile.rows = rows..self.rows.len();
            tile.special = special..self.special.len();
        }
    }
}

impl Patches {
    /// Puts patches in the order that tiles need: by tile of block i, patches within the tile first, then by
    /// axis, block i and block j.
    pub fn sort(&mut self, classes: &[PatchClass]) {
        let mut order: Vec<u32> = (0..self.len() as u32).collect();
        order.sort_by_key(|&p| {
            let [i, j] = self.ends[p as usize];
            let axis = classes[self.class[p as usize] as usize].axis;
            (tile_of(i), tile_of(j) != tile_of(i), axis, i, j)
        });
        self.keep(&order);
    }
}

/// Cuts a range of patches into packets.
fn pack(world: &World, patches: Range<usize>, packets: &mut Vec<Packet>) {
    let list = &world.patches;
    let axis = |p: usize| world.classes[list.class[p] as usize].axis;
    let mut p = patches.start;
    while p < patches.end {
        let end = (p..patches.end.min(p + LANES))
            .find(|q| axis(*q) != axis(p))
            .unwrap_or(patches.end.min(p + LANES));
        let [i, j] = list.ends[p];
        let side_by_side = |q: usize| list.ends[q] == [i + (q - p) as u32, j + (q - p) as u32];
        packets.push(Packet {
            first: p as u32,
            count: (end - p) as u8,
            axis: axis(p),
            runs: end - p == LANES && (p..end).all(side_by_side),
            one_class: (p..end).all(|q| list.class[q] == list.class[p]),
        });
        p = end;
    }
}
