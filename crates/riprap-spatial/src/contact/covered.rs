//! Faces of held blocks that other held blocks cover.
//!
//! Two blocks of a floor that nothing moves are one body to what slides over them, and so their faces in the joint between them are no surface of it
//! ([`crate::kernel::surface`]). A face counts only where joints cover all of it: at a step in the floor, or beside a block that has been taken
//! out, its rim is one that others can meet.
//!
//! Not so faces between blocks that move: two of them that meet at an edge overlap there by slivers when their joints give, and below faces far away
//! a sliver is deep.

use riprap_geom::Vec3;

use crate::broad::covered::{Cover, Covered};
use crate::kernel::Shape;
use crate::state::patches::flag;
use crate::state::world::World;

/// Share of a face that joints may leave bare by round-off.
const BARE: f64 = 1e-6;
/// Normals of a joint and of the face that it lies on differ by less than this, and their places by as much over the radius of the block.
const SAME: f64 = 1e-6;

/// Those that joints in place between held blocks cover.
pub(super) fn covered(world: &World, shapes: &[Shape]) -> Covered {
    let patches = &world.patches;
    let held = |b: u32| {
        let b = b as usize;
        !(world.is_free(b) || world.deforms(b) || world.is_glued(b) || world.is_terrain(b))
    };
    let in_place = |p: &usize| {
        patches.flags[*p] & flag::DISPLACED == 0 && patches.ends[*p].iter().all(|b| held(*b))
    };
    let mut covers = Vec::new();
    for p in (0..patches.len()).filter(in_place) {
        let class = &world.classes[patches.class[p] as usize];
        let [i, j] = patches.ends[p];
        let normal = class.frame[0];
        for (block, normal, arm) in [(i, normal, class.arms[0]), (j, -normal, class.arms[1])] {
            let shape = &shapes[world.solid[block as usize] as usize];
            if let Some(face) = face_of(shape, normal, arm) {
                covers.push(Cover { block, face, area: class.area });
            }
        }
    }
    let area = |b: u32, face: usize| shapes[world.solid[b as usize] as usize].areas[face];
    Covered::new(covers, world.alive.len(), area, BARE)
}

/// The face with this outward normal through the point `arm` (m, from the centroid).
fn face_of(shape: &Shape, normal: Vec3, arm: Vec3) -> Option<usize> {
    let on = |face: &usize| {
        (shape.normals[*face] - normal).length() < SAME
            && (shape.offsets[*face] - normal.dot(arm)).abs() < SAME * shape.radius
    };
    (0..shape.faces()).find(on)
}
