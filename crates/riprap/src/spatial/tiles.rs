//! Fixed pieces of the model that threads work on.
//!
//! A tile is a range of `TILE` blocks with the patches whose block i is among them: first those with j in the
//! same tile too, added to the sums of the tile at once, then those that cross into another tile, whose
//! part for j goes to a slot. A second pass adds the slots, in patch order. The cut does not depend on the
//! number of threads, so sums are the same bits for any.

use std::ops::Range;

use super::world::World;

/// Blocks per tile.
pub const TILE: usize = 2048;

/// Tile of a block.
#[must_use]
pub fn tile_of(block: u32) -> u32 {
    block / TILE as u32
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
                incoming: 0..0,
                faces: first_face..face,
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
        tiles
    }
}
