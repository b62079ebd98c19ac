//! Faces that other blocks in place cover.
//!
//! Two blocks whose joint holds them in place are one body to what slides over them, and so their faces in the joint are no surface of it
//! ([`crate::kernel::surface`]). A face counts only where others cover all of it: at a step in the floor, or where a joint has
//! slid or opened (`flag::DISPLACED`), its rim is one that others can meet. Implicit phases have made contacts of joints that nothing but friction
//! holds: there blocks cover each other that lie flush at the last search.

use riprap_geom::Vec3;
use riprap_geom::face_overlap::face_overlap;

use crate::broad::covered::{Cover, Covered};
use crate::broad::search::Candidates;
use crate::kernel::{PairKey, Pose, Shape};
use crate::state::patches::flag;
use crate::state::world::World;

/// Share of a face that joints may leave bare by round-off.
const BARE: f64 = 1e-6;
/// Normals of a joint and of the face that it lies on differ by less than this, and their places by as much over the radius of the block.
const SAME: f64 = 1e-6;
/// The same where contacts cover: what a joint may slide until its neighbours no longer hold each other.
const FLUSH: f64 = 1e-3;

/// Those that joints in place cover, and flush `contacts`.
pub(super) fn covered(world: &World, shapes: &[Shape], contacts: Vec<Cover>) -> Covered {
    let bare = if contacts.is_empty() { BARE } else { FLUSH };
    let mut covers = contacts;
    let patches = &world.patches;
    let in_place = (0..patches.len()).filter(|p| patches.flags[*p] & flag::DISPLACED == 0);
    for p in in_place {
        let class = &world.classes[patches.class[p] as usize];
        let [i, j] = patches.ends[p];
        let normal = class.frame[0];
        for (ends, normal, arm) in
            [([i, j], normal, class.arms[0]), ([j, i], -normal, class.arms[1])]
        {
            if has_faces(world, ends[0])
                && let Some(face) =
                    face_of(&shapes[world.solid[ends[0] as usize] as usize], normal, arm)
            {
                covers.push(Cover { ends, face, area: class.area });
            }
        }
    }
    let area = |b: u32, face: usize| shapes[world.solid[b as usize] as usize].areas[face];
    Covered::new(covers, world.alive.len(), area, bare)
}

/// Whether a block is one convex body with faces of its own.
fn has_faces(world: &World, b: u32) -> bool {
    let b = b as usize;
    !(world.deforms(b) || world.is_glued(b) || world.is_terrain(b))
}

/// The face with this outward normal through the point `arm` (m, from the centroid).
fn face_of(shape: &Shape, normal: Vec3, arm: Vec3) -> Option<usize> {
    let on = |face: &usize| {
        (shape.normals[*face] - normal).length() < SAME
            && (shape.offsets[*face] - normal.dot(arm)).abs() < SAME * shape.radius
    };
    (0..shape.faces()).find(on)
}

/// Faces of candidates that lie flush on each other, where the last search has found their blocks.
pub(super) fn flush(world: &World, shapes: &[Shape], candidates: &Candidates) -> Vec<Cover> {
    let mut covers = Vec::new();
    for candidate in &candidates.pairs {
        let key = candidate.key();
        if key.ends.iter().all(|b| has_faces(world, *b)) {
            let pair = key.ends.map(|b| &shapes[world.solid[b as usize] as usize]);
            flush_pair(world, &key, pair, candidate.faces(&candidates.lists), &mut covers);
        }
    }
    covers
}

fn flush_pair(
    world: &World,
    key: &PairKey,
    shapes: [&Shape; 2],
    faces: [&[u16]; 2],
    covers: &mut Vec<Cover>,
) {
    let poses = [0, 1].map(|side: usize| {
        let Pose { position, rotation } = world.found.search.pose[key.ends[side] as usize];
        Pose { position: key.place(side, position, &world.setup.periodic), rotation }
    });
    let radius = shapes[0].radius.min(shapes[1].radius);
    let plane = |side: usize, face: u16| {
        let (face, pose) = (usize::from(face), &poses[side]);
        let n = pose.rotation * shapes[side].normals[face];
        (n, shapes[side].offsets[face] + n.dot(pose.position))
    };
    let outline = |side: usize, face: u16| -> Vec<Vec3> {
        let corner = |v: &u16| poses[side].place(shapes[side].vertices[*v as usize]);
        shapes[side].outline(usize::from(face)).iter().map(corner).collect()
    };
    for &f in faces[0] {
        let (n, d) = plane(0, f);
        for &g in faces[1] {
            let (m, e) = plane(1, g);
            if (n + m).length() >= FLUSH || (d + e).abs() >= FLUSH * radius {
                continue;
            }
            let (a, b) = (outline(0, f), outline(1, g));
            // Beside each other they share nothing yet, but until the next search they may.
            let area = face_overlap(&a, &b, n, 0.0).map_or(0.0, |shared| shared.area);
            let [i, j] = key.ends;
            for (ends, face) in [([i, j], f), ([j, i], g)] {
                covers.push(Cover { ends, face: face.into(), area });
            }
        }
    }
}
