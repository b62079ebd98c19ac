//! Blocks that can slide from one block onto the next.
//!
//! Convex blocks that lie flush on each other cover each other's faces, in implicit steps in which they move little. In others, and
//! always among glued parts, a block ends at its own faces, also where they lie on those of its neighbour (unless both are held): what slides over the
//! seam between two blocks of one plane presses against their edges, by the depth to which it lies in them. Explicit steps lose there what dashpots
//! take of that; an implicit step, in which a block moves by far more than that depth, is braked by the edge, and friction seems larger than it is.

use riprap_geom::Vec3;

use crate::contact::is_loose;
use crate::state::world::World;

/// Normals of one plane differ by less than this.
const PARALLEL: f64 = 1e-6;
/// Distance of two faces of one plane over that from the centroid.
const COPLANAR: f64 = 1e-6;

/// A face on another block, as the block sees it.
struct Seat {
    block: u32,
    partner: u32,
    /// Outward normal, at the start.
    normal: Vec3,
    /// Distance of the plane from the centroid, m.
    offset: f64,
}

/// A block that can move and lies, without strength, on two others in one plane: it and these two. In steps as `long` as those to an equilibrium one of the
/// two can move too, in others one of the three has glued parts.
#[must_use]
pub fn seam(world: &World, long: bool) -> Option<[u32; 3]> {
    let loose = (0..world.patches.len()).filter(|p| is_loose(world, *p));
    let both = loose.flat_map(|p| {
        let class = &world.classes[world.patches.class[p] as usize];
        let [i, j] = world.patches.ends[p];
        let [first, second] = class.arms;
        let n = class.frame[0];
        let seat = |block, partner, normal: Vec3, arm: Vec3| Seat {
            block,
            partner,
            normal,
            offset: normal.dot(arm),
        };
        [seat(i, j, n, first), seat(j, i, -n, second)]
    });
    let mut seats: Vec<Seat> = both.filter(|seat| world.is_free(seat.block as usize)).collect();
    // The order of patches stays within a block.
    seats.sort_by_key(|seat| seat.block);
    let mut of_block = seats.chunk_by(|a, b| a.block == b.block);
    of_block.find_map(|seats| {
        seats.iter().enumerate().find_map(|(k, seat)| {
            let beside = seats[k + 1..].iter().find(|other| {
                other.partner != seat.partner
                    && match long {
                        true => [other, seat].iter().any(|on| world.is_free(on.partner as usize)),
                        false => [seat.block, seat.partner, other.partner]
                            .iter()
                            .any(|b| world.is_glued(*b as usize)),
                    }
                    && (other.normal - seat.normal).length() < PARALLEL
                    && (other.offset - seat.offset).abs() < COPLANAR * seat.offset.abs()
            })?;
            Some([seat.block, seat.partner, beside.partner])
        })
    })
}
