//! Who can touch before the next look: the list of pairs, a function of the state of the last look.
//!
//! Blocks of the largest lattice whose joints and bonds are whole are targets, and two targets never make a pair; all others are seekers.
//! A look is due when a point of a block will have left the block's margin by the end of the coming step. Terrain is met by seekers and
//! targets alike; it has a member of its own for each block that is near it, with the prisms below that block's box.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use riprap_core::sets::Sets;
use riprap_geom::polyhedron::{DepthCells, GluedCells, Polyhedron, Tetrahedra};
use riprap_geom::{Mat3, Vec3};

use crate::broad::search::{Search, any_leaves, carry};
use crate::contact::LOOKAHEAD;
use crate::deform::relax;
use crate::exec::Exec;
use crate::faces::deformable::centred;
use crate::kernel::Terrain;
use crate::kernel::cells::{
    Member, PairConstants, PairSlot, PairWorkspace, TetContactScratch, TetFan,
};
use crate::kernel::grid::{Box3, Role};
use crate::setup::{Shape, Solid};
use crate::state::contact_scratch::Grounds;
use crate::state::deform::Deform;
use crate::state::deformable::{DeformableContacts, DeformablePair, DeformableSearch};
use crate::state::event::EditKind;
use crate::state::patches::flag;
use crate::state::scratch::Scratch;
use crate::state::workspace::{BlockClass, Workspace};
use crate::state::world::World;

/// Largest sum of magnitudes in a row of a spring that is as stiff in all directions, or across only: between 1 and root 3.
const ROWS: f64 = 1.7321;

/// Brings the list of pairs up to date; whether there is any. Calling it again without moving changes nothing.
pub(crate) fn refresh(world: &mut World, scratch: &mut Scratch) -> bool {
    if !world.setup.found_contacts || world.deform.is_none() {
        return false;
    }
    let known = world.found.deformable.roles.len() == world.alive.len();
    let look = world.pending > 0.0 && world.step.is_multiple_of(super::CHECK_INTERVAL);
    let mut renew = false;
    if !known || world.fresh || look {
        let roles = roles(world);
        renew = roles != world.found.deformable.roles;
        world.found.deformable.roles = roles;
    }
    if world.fresh {
        scratch.deformable.ready = false;
    }
    if !world.found.deformable.roles.contains(&Role::Active) && !world.has_terrain() {
        if !world.found.deformable.pairs.is_empty() {
            super::leave(world, scratch);
        }
        world.found.deformable.longest_step = Some(f64::INFINITY);
        return false;
    }
    renew |= outdated(world, &mut scratch.deformable.outside, scratch.coming_dt, &scratch.exec);
    if renew {
        take_over(world);
        scratch.deformable.ready = false;
    }
    if !scratch.deformable.ready {
        rebuild(world, scratch, renew);
        if renew {
            note_left(world, &scratch.desk.terrain.grounds);
        }
    }
    world.found.deformable.longest_step = Some(f64::INFINITY);
    !world.found.deformable.pairs.is_empty()
}

/// Who can meet whom.
fn roles(world: &World) -> Vec<Role> {
    let n = world.alive.len();
    let Some(deform) = world.deform.as_deref() else {
        return vec![Role::Absent; n];
    };
    let mut sets = Sets::new(n);
    let mut torn: Vec<[u32; 2]> = Vec::new();
    let patches = &world.patches;
    for (&ends, flags) in patches.ends.iter().zip(&patches.flags) {
        sets.join(ends);
        if flags & flag::BROKEN != 0 {
            torn.push(ends);
        }
    }
    for (facet, has_history) in deform.facets.iter().zip(&deform.has_history) {
        if facet.parted {
            torn.push(facet.blocks);
            continue;
        }
        sets.join(facet.blocks);
        let memory = &deform.memory[facet.points()];
        if *has_history && memory.iter().any(|m| m.state.is_broken()) {
            torn.push(facet.blocks);
        }
    }
    let mut whole = vec![true; n];
    for b in torn.into_iter().flatten() {
        whole[b as usize] = false;
    }
    let lattice = sets.largest(|b| world.alive[b]);
    let lattice = lattice.filter(|(_, members)| *members > 1).map(|(leader, _)| leader);
    let role = |b: usize| {
        if !world.alive[b] || world.is_terrain(b) {
            Role::Absent
        } else if whole[b] && lattice == Some(sets.leader(b as u32)) {
            Role::Passive
        } else {
            Role::Active
        }
    };
    (0..n).map(role).collect()
}

/// Whether deformable blocks can meet others.
pub(crate) fn can_meet(world: &World) -> bool {
    world.deform.is_some() && roles(world).contains(&Role::Active)
}

/// Whether a point of a block will have left the margin of its block by the end of the coming step.
fn outdated(world: &World, outside: &mut Vec<bool>, dt: f64, exec: &Exec) -> bool {
    let Some(deform) = world.deform.as_deref() else {
        return false;
    };
    let DeformableContacts { search: DeformableSearch { displacement, blocks }, roles, .. } =
        &world.found.deformable;
    if blocks.margin.len() != roles.len() || displacement.len() != deform.nodes.len() {
        return true;
    }
    let leaves = |b: usize| match deform.body(b) {
        Some(body) => body.nodes().any(|n| {
            let now = Vec3::from_array(deform.nodes.displacement[n]);
            let velocity = Vec3::from_array(deform.nodes.velocity[n]);
            let then = Vec3::from_array(displacement[n]);
            blocks.is_beyond(b, (now - then).length() + dt * velocity.length())
        }),
        None => {
            let radius = world.solid_of(b).radius;
            blocks.leaves(b, radius, &world.pose(b), dt * speed(world, b))
        }
    };
    any_leaves(roles, outside, leaves, exec)
}

/// Bound of the speed of the points of a rigid block, m/s.
pub(super) fn speed(world: &World, b: usize) -> f64 {
    world.bodies.velocity(b).length() + world.bodies.spin(b).length() * world.solid_of(b).radius
}

/// Largest speed of the points of a block, m/s.
pub(super) fn fastest(world: &World, deform: &Deform, b: usize) -> f64 {
    match deform.body(b) {
        Some(body) => deform.nodes.velocity[body.nodes()]
            .iter()
            .map(|v| Vec3::from_array(*v).length())
            .fold(0.0, f64::max),
        None => speed(world, b),
    }
}

/// Takes over where everything is now.
fn take_over(world: &mut World) {
    let Some(deform) = world.deform.as_deref() else {
        return;
    };
    let lookahead = LOOKAHEAD * world.last_dt;
    let mut blocks = Search::default();
    blocks.take(
        &world.found.deformable.roles,
        |b| world.solid_of(b).radius,
        |b| world.pose(b),
        |b| fastest(world, deform, b) * lookahead,
    );
    let displacement = deform.nodes.displacement.clone();
    world.found.deformable.search = DeformableSearch { displacement, blocks };
}

/// Box of a block at the last look, grown by its margin.
fn grown_box(world: &World, deform: &Deform, b: usize) -> Box3 {
    let search = &world.found.deformable.search;
    let mut around = Box3::EMPTY;
    let mut add = |at: Vec3| {
        around.low = around.low.min(at);
        around.high = around.high.max(at);
    };
    match deform.body(b) {
        Some(body) => {
            for n in body.nodes() {
                add(deform.nodes.place[n] + Vec3::from_array(search.displacement[n]));
            }
        }
        None => {
            let pose = &search.blocks.pose[b];
            let turn = Mat3::from_quat(pose.rotation);
            let half = world.solid_of(b).half;
            let reach = turn.x_axis.abs() * half.x
                + turn.y_axis.abs() * half.y
                + turn.z_axis.abs() * half.z;
            add(pose.position - reach);
            add(pose.position + reach);
        }
    }
    let margin = Vec3::splat(search.blocks.margin[b]);
    Box3 { low: around.low - margin, high: around.high + margin }
}

/// Notes the blocks that have gone over the rim of all terrain since the last look.
fn note_left(world: &mut World, grounds: &[Terrain]) {
    if grounds.is_empty() {
        return;
    }
    for b in 0..world.found.left_terrain.len() {
        let Some(deform) = world.deform.as_deref() else {
            return;
        };
        let Some(body) = deform.body(b).filter(|_| world.alive[b]) else {
            continue;
        };
        let centre = (body.first + body.count - 1) as usize;
        let at = deform.nodes.place[centre] + Vec3::from_array(deform.nodes.displacement[centre]);
        if !world.found.left_terrain[b] && grounds.iter().all(|ground| ground.depth(at).is_none()) {
            world.found.left_terrain[b] = true;
            let event = world.event(EditKind::LeftTerrain, b as u32);
            world.events.push(event);
        }
    }
}

/// Makes the list of pairs of the state, and what follows from it.
///
/// `renewed`: the state of the last look has changed, so that the masses there are now are those before.
fn rebuild(world: &mut World, scratch: &mut Scratch, renewed: bool) {
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref_mut())
    else {
        return;
    };
    let desk = &mut scratch.deformable;
    let terrain = &scratch.desk.terrain;
    let roles = &world.found.deformable.roles;
    desk.boxes.clear();
    desk.boxes.extend((0..roles.len()).map(|b| match roles[b] {
        Role::Absent => Box3::EMPTY,
        Role::Passive | Role::Active => grown_box(world, deform, b),
    }));
    let facets = deform.facets.iter().filter(|f| !f.parted);
    let ends = facets.map(|f| f.blocks).chain(world.patches.ends.iter().copied());
    let mut joined: Vec<[u32; 2]> = ends.map(|[i, j]| [i.min(j), i.max(j)]).collect();
    joined.sort_unstable();
    let close = desk.grid.close_pairs(
        &desk.boxes,
        roles,
        |i, j| {
            let ends = [i, j].map(|b| b as usize);
            ends.iter().all(|b| deform.body(*b).is_none())
                || ends.iter().all(|b| !world.is_free(*b))
                || joined.binary_search(&[i, j]).is_ok()
        },
        &scratch.exec,
    );
    let mut close = close.to_vec();
    for (&ground, surface) in terrain.blocks.iter().zip(&terrain.grounds) {
        let bodies = (0..roles.len()).filter(|b| deform.body(*b).is_some());
        let over = bodies.filter(|b| roles[*b] != Role::Absent && surface.meets(&desk.boxes[*b]));
        close.extend(over.map(|b| [ground.min(b as u32), ground.max(b as u32)]));
    }
    if !terrain.blocks.is_empty() {
        close.sort_unstable();
    }
    let old = std::mem::take(&mut world.found.deformable.pairs).into_iter();
    let works = &mut world.works;
    world.found.deformable.pairs = carry(
        &close,
        |ends| *ends,
        old.map(|pair| (pair.ends, pair)),
        |ends| DeformablePair { ends: *ends, ..DeformablePair::default() },
        |_, pair| super::drop_pair(works, &pair),
    );
    lay_out(world, work, desk, terrain);
    let count = world.found.deformable.pairs.len();
    desk.workspaces.resize_with(scratch.exec.workspaces(count), PairWorkspace::default);
    if deform.relax.is_some() {
        let masses = relax::masses(deform, &work.classes);
        let before = std::mem::replace(&mut work.fictitious, masses);
        weigh(deform, desk, &mut work.fictitious);
        if renewed && world.start_energy.is_some() && before.len() == work.fictitious.len() {
            // The same velocities are another energy of motion with other masses.
            let masses = before.iter().zip(&work.fictitious);
            let changes = masses
                .zip(&deform.nodes.velocity)
                .map(|((m, now), v)| 0.5 * (now - m) * Vec3::from_array(*v).length_squared());
            world.works.edit_defect += changes.sum::<f64>();
        }
    }
    // Rigid blocks that are no longer in a pair keep nothing of what pushed them.
    scratch.pushes.own.blocks.clear();
    scratch.tiles.make_rows(world);
    scratch.deformable.ready = true;
}

/// What follows from the list of pairs.
fn lay_out(world: &World, work: &Workspace, desk: &mut TetContactScratch, terrain: &Grounds) {
    let Some(deform) = world.deform.as_deref() else {
        return;
    };
    let pairs = &world.found.deformable.pairs;
    let ground = |b: u32| terrain.blocks.binary_search(&b).ok();
    let ends = pairs.iter().flat_map(|p| p.ends);
    let mut blocks: Vec<u32> = ends.filter(|b| ground(*b).is_none()).collect();
    blocks.sort_unstable();
    blocks.dedup();
    // Many blocks are of one class: what follows from it is found once.
    let mut bounds: BTreeMap<u32, f64> = BTreeMap::new();
    // So is what follows from glued parts, which takes long.
    let mut glued = std::mem::take(&mut desk.members);
    glued.retain(|member| !member.pieces.is_empty());
    let member = |b: &u32| match deform.body(*b as usize) {
        Some(body) => {
            soft_member(*b, deform.slot[*b as usize], work.class(body), bounds.entry(body.class))
        }
        None => rigid_member(world, *b, &mut glued),
    };
    desk.members = blocks.iter().map(member).collect();
    desk.stars.clear();
    let star = |member: &Member| TetFan { keys: member.pieces.clone(), ..TetFan::default() };
    desk.stars.extend(desk.members.iter().map(star));
    let place = |b: u32| blocks.partition_point(|other| *other < b) as u32;
    let (members, stars, boxes) = (&mut desk.members, &mut desk.stars, &desk.boxes);
    desk.constants = pairs
        .iter()
        .map(|pair| {
            let [i, j] = pair.ends;
            let on = ground(i).map(|k| (k, 0)).or(ground(j).map(|k| (k, 1)));
            let mut places = pair.ends.map(place);
            if let Some((k, side)) = on {
                let block = pair.ends[1 - side];
                let over = &members[places[1 - side] as usize];
                let ground = below(pair.ends[side], over);
                places[side] = members.len() as u32;
                members.push(ground);
                stars.push(terrain.grounds[k].prisms(&boxes[block as usize]));
            }
            let two = places.map(|k| &members[k as usize]);
            let peaks = two.map(|m| m.peak);
            let rigid = two.map(|m| m.body.is_none());
            // Looked at when the model was built; NaN would stop the run at once.
            let halves = two.map(|m| m.half);
            let law = super::between(&world.setup, pair.ends, rigid, halves).unwrap_or(
                crate::kernel::ContactLaw {
                    normal_stiffness: f64::NAN,
                    shear_stiffness: f64::NAN,
                    friction: 0.0,
                    cohesion: 0.0,
                    damping_ratio: 0.0,
                    rebound: 0.0,
                    growth: 0.0,
                },
            );
            PairConstants {
                law,
                members: places,
                peak: peaks[0].min(peaks[1]),
                ground: on.map(|(k, _)| k as u32),
            }
        })
        .collect();
    desk.slots.clear();
    desk.slots.extend(desk.constants.iter().map(|c| {
        let room = |k: u32| {
            let body = members[k as usize].body;
            let count = body.map_or(2, |k| deform.bodies[k as usize].count);
            vec![Vec3::ZERO; count as usize]
        };
        PairSlot { forces: c.members.map(room), ..PairSlot::default() }
    }));
}

/// Terrain under a block: it has no far side, and counts as deep as the block.
fn below(terrain: u32, block: &Member) -> Member {
    Member {
        block: terrain,
        body: None,
        rigid: None,
        pieces: Vec::new(),
        half: block.half,
        peak: block.peak,
        largest: f64::INFINITY,
        areas: Vec::new(),
        ease: 0.0,
        own: 0.0,
    }
}

/// A deformable block; `own`: the bound of the frequency of its class, found once.
fn soft_member(block: u32, body: u32, class: &BlockClass, own: Entry<'_, u32, f64>) -> Member {
    let (areas, largest) = shown(class);
    let ratios = areas.iter().zip(class.masses()).map(|(a, m)| a / m);
    let ease = ratios.fold(0.0, f64::max);
    Member {
        block,
        body: Some(body),
        rigid: None,
        pieces: Vec::new(),
        half: class.mesh.height(),
        peak: class.depths().peak(),
        largest,
        areas,
        ease,
        own: *own.or_insert_with(|| own_frequency(class)),
    }
}

/// A rigid block: convex, or of glued parts. `glued`: the blocks of glued parts that are already known.
fn rigid_member(world: &World, block: u32, glued: &mut Vec<Member>) -> Member {
    let b = block as usize;
    let ease = world.freedoms(b)[0].max_element() / world.solid_of(b).mass;
    if let Some(at) = glued.iter().position(|member| member.block == block) {
        return Member { ease, ..glued.swap_remove(at) };
    }
    let areas = |solid: &Polyhedron| -> Vec<f64> {
        (0..solid.faces.len()).map(|f| solid.area_vector(f).length()).collect()
    };
    let mut made = Member {
        block,
        body: None,
        rigid: None,
        pieces: Vec::new(),
        half: f64::NAN,
        peak: f64::NAN,
        largest: f64::NAN,
        areas: Vec::new(),
        ease,
        own: 0.0,
    };
    let shape = &world.setup.blocks[b].shape;
    if let Shape::Glued(parts) = shape {
        let parts = about(parts, world.reference[b]);
        made.largest = 0.5 * parts.iter().flat_map(areas).sum::<f64>();
        if let Some(cells) = GluedCells::new(&parts) {
            (made.half, made.peak) = (cells.height, cells.peak);
            (made.rigid, made.pieces) = (Some((cells.field, cells.nodes)), cells.pieces);
        }
    } else {
        let (solid, _) = centred(shape);
        made.largest = areas(&solid).into_iter().fold(0.0, f64::max);
        if let Ok(mesh) = Tetrahedra::new(&solid) {
            let field = DepthCells::new(&mesh);
            (made.half, made.peak) = (mesh.height(), field.peak());
            made.rigid = Some((field, mesh.nodes));
        }
    }
    made
}

/// Parts about a place (m).
pub(super) fn about(parts: &[Solid], place: Vec3) -> Vec<Polyhedron> {
    let moved = |part: &Solid| {
        let mut solid = part.polyhedron();
        solid.vertices.iter_mut().for_each(|v| *v -= place);
        solid
    };
    parts.iter().map(moved).collect()
}

/// Area that each node stands for and that of the largest face, m².
pub(crate) fn shown(class: &BlockClass) -> (Vec<f64>, f64) {
    let mut areas = vec![0.0; class.mesh.nodes.len()];
    let mut largest = 0.0_f64;
    for face in 0..class.faces.len() {
        let mut whole = 0.0;
        for (node, area) in class.mesh.tributary(face) {
            areas[node as usize] += area;
            whole += area;
        }
        largest = largest.max(whole);
    }
    (areas, largest)
}

/// Bound of the square of the highest frequency of a block by itself (Gershgorin), 1/s².
fn own_frequency(class: &BlockClass) -> f64 {
    let sums = crate::laws::tetrahedron::row_sums(&class.mesh, &class.law);
    let ratios = sums.iter().zip(class.masses()).map(|(sum, m)| sum / m);
    ratios.fold(0.0, f64::max)
}

/// Adds to the fictitious masses of a relaxing phase (kg) what contacts ask for: as bonds of the same stiffness on all of the surface
/// would, with the largest sum in a row of `kn n nᵀ + ks (1 - n nᵀ)`.
fn weigh(deform: &Deform, desk: &TetContactScratch, fictitious: &mut [f64]) {
    let mut stiffness = vec![0.0_f64; desk.members.len()];
    for constants in &desk.constants {
        let law = &constants.law;
        for member in constants.members {
            let most = &mut stiffness[member as usize];
            *most = most.max(law.normal_stiffness.max(law.shear_stiffness));
        }
    }
    for (member, stiffness) in desk.members.iter().zip(stiffness) {
        let Some(body) = member.body else {
            continue;
        };
        let nodes = deform.bodies[body as usize].nodes();
        for (mass, area) in fictitious[nodes].iter_mut().zip(&member.areas) {
            *mass += relax::MARGIN / 4.0 * 2.0 * ROWS * stiffness * area;
        }
    }
}
