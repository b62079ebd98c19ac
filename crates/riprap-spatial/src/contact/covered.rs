//! Faces that other blocks cover.
//!
//! Two blocks of a floor are one body to what slides over them, and so their faces in the joint between them are no surface of it
//! ([`crate::kernel::surface`]). A face counts only where others cover all of it: at a step in the floor, or beside a block that has been taken
//! out, its rim is one that others can meet.
//!
//! Explicit phases know held blocks alone: between the searches a joint that gives would hide what comes down beside it. An implicit step looks at each
//! instant which blocks lie flush on each other, by joints in place and by contact.

use riprap_geom::Vec3;
use riprap_geom::face_overlap::face_overlap;

use crate::broad::covered::{Cover, Covered};
use crate::kernel::Shape;
use crate::state::contact_scratch::{ContactScratch, Seat, Seats};
use crate::state::patches::flag;
use crate::state::world::World;

/// Share of a face that joints may leave bare by round-off.
const BARE: f64 = 1e-6;
/// Normals of a joint and of the face that it lies on differ by less than this, and their places by as much over the radius of the block.
const SAME: f64 = 1e-6;
/// The same of two faces in contact, and the share of a face that they may leave bare: as far as a joint may slide whose neighbours hold each other.
const FLUSH: f64 = 1e-3;
/// Two blocks touch where they share the most; where they share less than this part of that, they have an edge in common.
const MAIN: f64 = 0.1;
/// The same over the smaller of two faces: blocks that have sunk into what they stand on share as much with what stands beside it.
const EDGE: f64 = 1e-5;

/// Those that joints in place between held blocks cover.
pub(super) fn covered(world: &World, shapes: &[Shape]) -> Covered {
    let held = |b: u32| has_faces(world, b) && !world.is_free(b as usize);
    let joints = of_joints(world, shapes, |p| world.patches.ends[p].iter().all(|b| held(*b)));
    let covers = joints.into_iter().map(|(_, cover)| cover).collect();
    Covered::new(covers, world.alive.len(), |b, face| area(world, shapes, b, face), BARE)
}

/// What may cover faces until the next search.
pub(super) fn seats(world: &World, desk: &ContactScratch) -> Seats {
    let (shapes, search) = (&desk.shapes, &world.found.search);
    let joints =
        of_joints(world, shapes, |p| world.patches.ends[p].iter().all(|b| has_faces(world, *b)));
    let mut contacts = Vec::new();
    for (k, candidate) in desk.candidates.pairs.iter().enumerate() {
        let key = candidate.key();
        if key.ends[0] == key.ends[1] || !key.ends.iter().all(|b| has_faces(world, *b)) {
            continue;
        }
        let pair = key.ends.map(|b| &shapes[world.solid[b as usize] as usize]);
        let way: f64 = key.ends.iter().map(|b| search.margin[*b as usize]).sum();
        let radius = pair[0].radius.min(pair[1].radius);
        let pose = |side: usize| {
            let pose = search.pose[key.ends[side] as usize];
            (key.place(side, pose.position, &world.setup.periodic), pose.rotation)
        };
        let poses = [pose(0), pose(1)];
        let plane = |side: usize, face: u16| {
            let (at, turn) = poses[side];
            let n = turn * pair[side].normals[usize::from(face)];
            (n, pair[side].offsets[usize::from(face)] + n.dot(at))
        };
        let [of_first, of_second] = candidate.faces(&desk.candidates.lists);
        for &f in of_first {
            let (n, d) = plane(0, f);
            for &g in of_second {
                let (m, e) = plane(1, g);
                let turned = (n + m).length() < FLUSH + way / radius;
                if turned && (d + e).abs() < FLUSH * radius + way {
                    contacts.push(Seat { pair: k as u32, faces: [f, g] });
                }
            }
        }
    }
    Seats { joints, contacts }
}

/// Faces covered now, where `desk` has the blocks where they are, before a step of `dt` (s).
pub(crate) fn at_present(world: &World, desk: &ContactScratch, dt: f64) -> Covered {
    let Seats { joints, contacts } = &desk.seats;
    let in_place = |p: &u32| world.patches.flags[*p as usize] & flag::DISPLACED == 0;
    let held = joints.iter().filter(|(p, _)| in_place(p));
    let mut covers: Vec<Cover> = held.map(|(_, cover)| *cover).collect();
    let mut flush = Vec::new();
    for of_pair in contacts.chunk_by(|a, b| a.pair == b.pair) {
        flush.clear();
        flush.extend(of_pair.iter().filter_map(|seat| flush_at(world, desk, seat, dt)));
        let most = flush.iter().map(|flush| flush.coming).fold(0.0, f64::max);
        let [i, j] = desk.candidates.pairs[of_pair[0].pair as usize].ends;
        for Flush { faces, area, coming, least } in &flush {
            let touch = *coming >= (MAIN * most).max(*least);
            for (ends, face) in [([i, j], faces[0]), ([j, i], faces[1])] {
                covers.push(Cover { ends, face, area: *area, touch });
            }
        }
    }
    Covered::new(covers, world.alive.len(), |b, face| area(world, &desk.shapes, b, face), FLUSH)
}

/// Two faces that lie flush.
struct Flush {
    faces: [usize; 2],
    /// What they share, m².
    area: f64,
    /// The same at the end of the step if that is more, m²: a block that slides onto the next one shares nothing with it yet.
    coming: f64,
    /// What is as little as an edge, m².
    least: f64,
}

/// How flush faces lie on each other; `None` where they do not.
fn flush_at(world: &World, desk: &ContactScratch, seat: &Seat, dt: f64) -> Option<Flush> {
    let key = desk.candidates.pairs[seat.pair as usize].key();
    let at = key.ends.map(|b| desk.place[b as usize] as usize);
    let shapes = key.ends.map(|b| &desk.shapes[world.solid[b as usize] as usize]);
    let faces = seat.faces.map(usize::from);
    let place = |side: usize| {
        let position = desk.poses[at[side]].position;
        key.place(side, position, &world.setup.periodic)
    };
    let positions = [place(0), place(1)];
    let normals =
        [0, 1].map(|side| desk.normals[desk.first_normal[at[side]] as usize + faces[side]]);
    let offset =
        |side: usize| shapes[side].offsets[faces[side]] + normals[side].dot(positions[side]);
    let radius = shapes[0].radius.min(shapes[1].radius);
    let parallel = (normals[0] + normals[1]).length() < FLUSH;
    if !parallel || (offset(0) + offset(1)).abs() >= FLUSH * radius {
        return None;
    }
    let outline = |side: usize, shift: Vec3| -> Vec<Vec3> {
        let (turn, shape, by) = (&desk.turns[at[side]], shapes[side], positions[side] + shift);
        let corner = |v: &u16| by + *turn * shape.vertices[*v as usize];
        shape.outline(faces[side]).iter().map(corner).collect()
    };
    let first = outline(0, Vec3::ZERO);
    let shared = |second: &[Vec3]| {
        face_overlap(&first, second, normals[0], 0.0).map_or(0.0, |shared| shared.area)
    };
    let area = shared(&outline(1, Vec3::ZERO));
    let smaller = shapes[0].areas[faces[0]].min(shapes[1].areas[faces[1]]);
    let [v, w] = key.ends.map(|b| world.bodies.velocity(b as usize));
    // Where they lie on each other already, a step changes nothing of it.
    let coming = match area >= MAIN * smaller {
        true => area,
        false => area.max(shared(&outline(1, dt * (w - v)))),
    };
    Some(Flush { faces, area, coming, least: EDGE * smaller })
}

/// Whether a block is one convex body with faces of its own.
fn has_faces(world: &World, b: u32) -> bool {
    let b = b as usize;
    !(world.deforms(b) || world.is_glued(b) || world.is_terrain(b))
}

fn area(world: &World, shapes: &[Shape], b: u32, face: usize) -> f64 {
    shapes[world.solid[b as usize] as usize].areas[face]
}

/// What joints in place cover of the faces of their blocks, and which.
fn of_joints(world: &World, shapes: &[Shape], which: impl Fn(usize) -> bool) -> Vec<(u32, Cover)> {
    let patches = &world.patches;
    let in_place = |p: &usize| patches.flags[*p] & flag::DISPLACED == 0 && which(*p);
    let mut covers = Vec::new();
    for p in (0..patches.len()).filter(in_place) {
        let class = &world.classes[patches.class[p] as usize];
        let [i, j] = patches.ends[p];
        let normal = class.frame[0];
        for (ends, normal, arm) in
            [([i, j], normal, class.arms[0]), ([j, i], -normal, class.arms[1])]
        {
            let shape = &shapes[world.solid[ends[0] as usize] as usize];
            if let Some(face) = face_of(shape, normal, arm) {
                covers.push((p as u32, Cover { ends, face, area: class.area, touch: true }));
            }
        }
    }
    covers
}

/// The face with this outward normal through the point `arm` (m, from the centroid).
fn face_of(shape: &Shape, normal: Vec3, arm: Vec3) -> Option<usize> {
    let on = |face: &usize| {
        (shape.normals[*face] - normal).length() < SAME
            && (shape.offsets[*face] - normal.dot(arm)).abs() < SAME * shape.radius
    };
    (0..shape.faces()).find(on)
}
