//! Found contacts of a model: which bodies may touch; what they exert is in `acting`.
//!
//! The kernel knows two bodies at two poses; here are all of the model. Blocks of the largest lattice whose joints are whole
//! cannot come together: they are passive, and two passive blocks never make a pair. All others are active: separate bodies, and
//! blocks with a joint that has failed at any of its points or has slid along. Pairs that a patch joins are left to it, and two blocks whose
//! motion is prescribed never act on each other. Terrain acts on every rigid block that can move: these pairs need no search, and stand
//! behind those of the search in one list.
//!
//! ```text
//!   refresh (pairs) -> act: narrow (patches with keys) -> law and memory of each patch -> sums on blocks -> limit of the step
//! ```

pub(crate) mod deformable;

use crate::setup::rotation::rotation;
use riprap_core::sums::GROUP;
use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Polyhedron, hull};

mod acting;
pub(crate) mod clear;
pub(crate) mod constants;
pub(crate) mod covered;
mod facing;
mod felt;
pub(crate) mod glued;
mod held;
pub(crate) mod levels;
pub(crate) mod limit;
mod narrow;
mod quiet;
mod relaw;
mod release;
mod shared;
mod stored;
pub(crate) mod terrain;

use std::collections::BTreeMap;

use crate::broad::covered::NO_FACE;
use crate::broad::search::Blocks;
use crate::joint::classes::stiffness;
use crate::kernel::glued::Glued;
use crate::kernel::offset::{Carried, Offset};
use crate::kernel::{PairKey, Pose, Role, Shape};
use crate::ledger::Works;
use crate::setup;
use crate::setup::InterfaceLaw;
use crate::setup::error::BuildError;
use crate::state::bodies::{Bodies, Turned};
use crate::state::contact_scratch::{
    Acting, Between, ContactScratch, PairGroup, RoleScratch, Slot, Workspace,
};
use crate::state::found::FoundPair;
use crate::state::lineage::Origin;
use crate::state::patches::flag;
use crate::state::scratch::Scratch;
use crate::state::world::World;
pub(crate) use acting::{act, note_left, place, sum};
use held::Joints;
pub(crate) use quiet::quiet_for;
pub use relaw::change_laws;
pub(crate) use release::{is_dry, is_loose, release, release_loose};
use stored::drop_pair;
pub(crate) use stored::{begin, left, stored};

/// Steps between two looks at joints that have failed since.
pub(crate) const CHECK_INTERVAL: u64 = 16;
/// Way in steps of the present length that margins are made for.
const LOOKAHEAD: f64 = 50.0;

/// What of a model can meet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Meeting {
    /// Whether blocks that no joint joins are watched for contact at all.
    pub on: bool,
    /// Rigid blocks that can come together with all others: they belong to another body than most, or a joint of theirs has failed.
    pub seekers: usize,
    /// Whether deformable blocks can meet others.
    pub deformable: bool,
    /// Interfaces under which blocks can meet that have no friction of their own: `interfaces.NAME`.
    pub sticking: Vec<String>,
    /// Interfaces under which blocks can meet whose cohesion or tension no joint of the model has and no contact takes: `interfaces.NAME`.
    pub unread: Vec<String>,
}

/// What of a model can meet now.
#[must_use]
pub fn meeting(world: &World) -> Meeting {
    let roles = roles(world);
    let setup = &world.setup;
    let mut used = vec![[false; 2]; setup.materials.len()];
    let mut meeting = Meeting {
        on: setup.found_contacts,
        deformable: deformable::can_meet(world),
        ..Meeting::default()
    };
    for (b, role) in roles.iter().enumerate().filter(|(b, _)| world.alive[*b]) {
        let material = setup.blocks[b].material as usize;
        match role {
            Role::Absent => {}
            Role::Passive => used[material][0] = true,
            Role::Active => {
                meeting.seekers += 1;
                used[material] = [true; 2];
            }
        }
    }
    let mut rows = vec![false; setup.interfaces.len()];
    for a in (0..used.len()).filter(|a| used[*a][1]) {
        for b in (0..used.len()).filter(|b| used[*b][0]) {
            rows[setup.pair_table[a * used.len() + b] as usize] = true;
        }
    }
    let sticks = |row: &usize| {
        let interface = &setup.interfaces[*row];
        interface.joint.strength.is_none() && interface.friction.is_none()
    };
    let joint_of = joined(world);
    let unread = |row: &usize| {
        let InterfaceLaw { joint, bond, .. } = &setup.interfaces[*row];
        let holds = joint
            .strength
            .is_some_and(|s| s.residual_cohesion == 0.0 && (s.cohesion > 0.0 || s.tension > 0.0));
        holds && bond.is_none() && !joint_of[*row]
    };
    let name = |row: usize| format!("interfaces.{}", setup.interfaces[row].name);
    let meets = || (0..rows.len()).filter(|row| rows[*row]);
    meeting.sticking = meets().filter(sticks).map(name).collect();
    meeting.unread = meets().filter(unread).map(name).collect();
    meeting
}

/// Brings the candidate list up to date; whether any pair can touch.
///
/// Calling it again without moving changes nothing.
pub(crate) fn refresh(world: &mut World, scratch: &mut Scratch) -> bool {
    if !world.setup.found_contacts {
        return false;
    }
    let n = world.alive.len();
    let known = world.found.roles.len() == n;
    // Not without a move: what is found must not hang on how often an instant is evaluated.
    if let Some(longest) = scratch.apart() {
        // Nothing has changed in who may meet whom, or the ranks would not keep to themselves ([`quiet`]).
        scratch.desk.deepest = None;
        world.found.longest_step = Some(longest);
        return false;
    }
    let look = world.pending > 0.0 && world.step.is_multiple_of(CHECK_INTERVAL);
    let looked = !known || world.fresh || look && others_are_whole(world, &mut scratch.desk.who);
    let mut renew = false;
    // Lent by the desk, so that a look takes no memory.
    let mut were = Vec::new();
    if looked {
        find_roles(world, &mut scratch.desk.who);
        were = std::mem::take(&mut scratch.desk.who.roles);
        std::mem::swap(&mut were, &mut world.found.roles);
        renew = were != world.found.roles;
    }
    if world.fresh {
        scratch.desk.ready = false;
    }
    scratch.desk.deepest = None;
    let meet = world.found.roles.contains(&Role::Active);
    if meet || world.has_terrain() {
        make_shapes(world, &mut scratch.desk);
        terrain::prepare(world, &mut scratch.desk);
        search(world, scratch, renew && meet);
        if !scratch.desk.ready {
            rebuild(world, scratch, &were);
        }
    } else if !world.found.pairs.is_empty() {
        leave(world, scratch);
    }
    if looked {
        scratch.desk.who.roles = were;
    }
    let all = 0..world.alive.len();
    let reach = || limit::reach(world, &scratch.exec, all);
    world.found.longest_step = Some(if meet { reach() } else { f64::INFINITY });
    !world.found.pairs.is_empty()
}

/// Bound of the speed of the points of a block, m/s.
fn speed(world: &World, b: usize) -> f64 {
    world.bodies.velocity(b).length() + world.bodies.spin(b).length() * world.solid_of(b).radius
}

/// Takes over the present poses where blocks have left their margins, or where `renew` asks for it.
fn search(world: &mut World, scratch: &mut Scratch, mut renew: bool) {
    let desk = &mut scratch.desk;
    if !world.found.roles.contains(&Role::Active) {
        // Pairs that were searched for stand before those with terrain.
        let searched = |pair: &FoundPair| !world.is_terrain(pair.ends[0] as usize);
        if world.found.pairs.first().is_some_and(searched) {
            world.found.search = Default::default();
            desk.ready = false;
        }
        return;
    }
    // A renewal asks for no faces.
    let (shapes, roles) = (&desk.shapes, &world.found.roles);
    let blocks = Blocks { shapes, shape: &world.solid, roles, covered: &NO_FACE };
    let pose = |b: usize| world.pose(b);
    let speed = |b: usize| speed(world, b);
    let next = |b: usize| speed(b) * scratch.coming_dt;
    renew |= desk.candidates.outdated(&blocks, &world.found.search, pose, next, &scratch.exec);
    if renew {
        let lookahead = LOOKAHEAD * world.last_dt;
        // A copy, since its renewal reads poses of the world that it belongs to.
        let mut search = world.found.search.clone();
        search.renew(&blocks, pose, speed, lookahead);
        world.found.search = search;
        desk.ready = false;
    }
}

/// Ends all found contacts: what their springs still hold is friction.
fn leave(world: &mut World, scratch: &mut Scratch) {
    for pair in std::mem::take(&mut world.found.pairs) {
        drop_pair(&mut world.works, &pair);
    }
    world.found.search = Default::default();
    world.found.held.clear();
    scratch.desk = ContactScratch::default();
    scratch.tiles.make_rows(world);
}

/// What pairs of which a block has been split hide of their pressure ([`Offset::of_parts`]), by their blocks.
fn hidden_of_split(world: &World, pairs: &[FoundPair]) -> BTreeMap<PairKey, [f64; 2]> {
    let split = |pair: &&FoundPair| pair.ends.iter().any(|b| !world.alive[*b as usize]);
    let of = |pair: &FoundPair| Some((pair.key(), pair.offset.as_ref()?.of_parts()?));
    pairs.iter().filter(split).filter_map(of).collect()
}

/// Whether other blocks have all of their joints than at the last look. Who is joined to whom changes with an edit alone.
fn others_are_whole(world: &World, desk: &mut RoleScratch) -> bool {
    let RoleScratch { whole, were_whole, .. } = desk;
    std::mem::swap(whole, were_whole);
    find_whole(world, whole);
    whole != were_whole
}

/// Whether all joints of a block are whole and in place, for each of them.
fn find_whole(world: &World, whole: &mut Vec<bool>) {
    whole.clear();
    whole.resize(world.alive.len(), true);
    let patches = &world.patches;
    for (ends, flags) in patches.ends.iter().zip(&patches.flags) {
        if flags & (flag::BROKEN | flag::DISPLACED) != 0 {
            for b in ends {
                whole[*b as usize] = false;
            }
        }
    }
}

/// Who can meet whom.
pub(crate) fn roles(world: &World) -> Vec<Role> {
    let mut desk = RoleScratch::default();
    find_roles(world, &mut desk);
    desk.roles
}

/// As [`roles`], into a desk.
fn find_roles(world: &World, desk: &mut RoleScratch) {
    let RoleScratch { roles, whole, joined, .. } = desk;
    let n = world.alive.len();
    roles.clear();
    roles.extend((0..n).map(|b| {
        if !world.alive[b] || world.deforms(b) || world.is_terrain(b) {
            Role::Absent
        } else {
            Role::Active
        }
    }));
    find_whole(world, whole);
    joined.renew(n);
    for ends in &world.patches.ends {
        joined.join(*ends);
    }
    // The largest set that patches join, if it has at least two blocks.
    let Some((lattice, 2..)) = joined.largest(|b| world.alive[b]) else {
        return;
    };
    for b in 0..n {
        if whole[b] && roles[b] == Role::Active && joined.leader(b as u32) == lattice {
            roles[b] = Role::Passive;
        }
    }
}

/// Looks at all that found contacts will ask of blocks and materials, so that nothing is missing in the middle of a run.
///
/// # Errors
/// A block that is no convex body with its centroid inside; a stiffness without modulus.
pub(crate) fn check(world: &World) -> Result<(), BuildError> {
    if !world.setup.found_contacts {
        return Ok(());
    }
    let roles = roles(world);
    let count = roles.iter().filter(|role| **role != Role::Absent).count();
    if count < 2 || !roles.contains(&Role::Active) {
        return Ok(());
    }
    let mut used = vec![[false; 2]; world.setup.materials.len()];
    let mut seen = vec![false; world.solids.len()];
    for (b, role) in roles.iter().enumerate().filter(|(_, r)| **r != Role::Absent) {
        let spec = &world.setup.blocks[b];
        used[spec.material as usize][usize::from(*role == Role::Active)] = true;
        if std::mem::replace(&mut seen[world.solid[b] as usize], true) {
            continue;
        }
        let shape = shape_of(&spec.shape, world.reference[b]);
        let parts = glued_of(&spec.shape, world.reference[b]);
        if let Err(reason) = shape.and(parts) {
            let block = world.name(b);
            return Err(BuildError::Shape { block, reason });
        }
    }
    let materials = || (0..used.len()).filter(|m| used[*m] != [false; 2]);
    for a in materials().filter(|a| used[*a][1]) {
        for b in materials() {
            let row = world.setup.pair_table[a * used.len() + b];
            // Any depths will do: it is asked only whether the moduli are there.
            stiffness(&world.setup, row, [a, b], [1.0; 2])?;
        }
    }
    Ok(())
}

/// The shape of a block about its centroid at the start.
///
/// # Errors
/// What is wrong with it, in words.
pub(crate) fn shape_of(shape: &setup::Shape, centre: Vec3) -> Result<Shape, String> {
    match shape {
        // What is searched for, and where steps count faces: the convex hull.
        setup::Shape::Glued(parts) => {
            let hull = hull(&setup::Solid::all(parts).vertices).map_err(|e| e.to_string())?;
            Shape::new(&hull, centre)
        }
        setup::Shape::Brick { half, .. } => Shape::brick(*half),
        setup::Shape::Polyhedron(solid) => {
            let (vertices, faces) = (solid.vertices.clone(), solid.faces.clone());
            Shape::new(&Polyhedron { vertices, faces }, centre)
        }
        // A stand-in that nobody asks for: terrain has no part in the search of blocks.
        setup::Shape::Terrain(_) => Shape::brick(Vec3::ONE),
    }
    .map_err(|error| error.to_string())
}

/// A block of glued parts by its terms about its centroid at the start; `None` for all others.
///
/// # Errors
/// What is wrong with the parts, in words.
pub(crate) fn glued_of(shape: &setup::Shape, centre: Vec3) -> Result<Option<Glued>, String> {
    let setup::Shape::Glued(parts) = shape else {
        return Ok(None);
    };
    let parts: Vec<Polyhedron> = parts.iter().map(setup::Solid::polyhedron).collect();
    let glued = Glued::new(&parts, centre).map_err(|error| error.to_string())?;
    Ok(Some(glued))
}

/// Makes the shapes of the mass classes that have none yet. A class whose blocks take no part, or whose shape is refused (a block
/// that building let pass is none of these), has that of a small cube, which nothing asks for.
pub(crate) fn make_shapes(world: &World, desk: &mut ContactScratch) {
    if desk.shapes.len() == world.solids.len() {
        return;
    }
    let mut chosen: Vec<Option<usize>> = vec![None; world.solids.len()];
    // Blocks that have been taken out count in the margins of the state, after a restart too.
    for b in taken_out(world) {
        chosen[world.solid[b] as usize] = Some(b);
    }
    // From the last on, so that the first block of a class stands for it.
    for b in (0..world.alive.len()).rev() {
        if world.found.roles[b] != Role::Absent {
            chosen[world.solid[b] as usize] = Some(b);
        }
    }
    let made = desk.shapes.len();
    for block in &chosen[made..] {
        let shape =
            block.and_then(|b| shape_of(&world.setup.blocks[b].shape, world.reference[b]).ok());
        desk.shapes.push(shape.unwrap_or_else(|| Shape::brick(Vec3::ONE).unwrap_or_default()));
    }
    if (0..world.alive.len()).any(|b| world.is_glued(b)) {
        let of_class = |(block, shape): (&Option<usize>, &Shape)| {
            let parts = |b: usize| glued_of(&world.setup.blocks[b].shape, world.reference[b]);
            let glued = block.and_then(|b| parts(b).ok().flatten());
            glued.unwrap_or_else(|| Glued::convex(shape))
        };
        desk.glued = chosen.iter().zip(&desk.shapes).map(of_class).collect();
    }
}

/// Rigid blocks that have been taken out since the run began: they are gone, have not been divided, and no charge has their place.
fn taken_out(world: &World) -> Vec<usize> {
    let mut out: Vec<bool> = world.alive.iter().map(|alive| !alive).collect();
    let parents = world.lineage.iter().map(|origin| origin.parent);
    let charged = world.cavities.iter().flat_map(|cavity| cavity.blocks.iter().copied());
    for b in parents.filter(|parent| *parent != Origin::NONE).chain(charged) {
        out[b as usize] = false;
    }
    let rigid = |b: &usize| out[*b] && !world.deforms(*b) && !world.is_terrain(*b);
    (0..out.len()).filter(rigid).collect()
}

impl World {
    /// Where the frame of block `b` stands now; at the start it was parallel to the axes.
    #[must_use]
    pub fn pose(&self, b: usize) -> Pose {
        pose(&self.bodies, &self.turned, &self.reference, b)
    }
}

/// [`World::pose`] from the parts of the world that it needs.
pub(crate) fn pose(
    bodies: &Bodies,
    turned: &[Option<Box<Turned>>],
    reference: &[Vec3],
    b: usize,
) -> Pose {
    let rotation = match &turned[b] {
        Some(turned) => turned.attitude,
        None => rotation(bodies.rotation(b)),
    };
    Pose { position: reference[b] + bodies.displacement(b), rotation }
}

/// Makes the list of pairs of the state, and what follows from it. `were`: the roles until now, where they have been found again.
fn rebuild(world: &mut World, scratch: &mut Scratch, were: &[Role]) {
    let desk = &mut scratch.desk;
    desk.covered = covered::covered(world, &desk.shapes);
    let (shapes, roles) = (&desk.shapes, &world.found.roles);
    let blocks = Blocks { shapes, shape: &world.solid, roles, covered: &desk.covered };
    let joints = Joints::new(world);
    if roles.contains(&Role::Active) {
        desk.candidates.rebuild(
            &blocks,
            &world.found.search,
            &world.setup.periodic,
            |pair| joints.joins(pair) || !pair.ends.iter().any(|b| world.is_free(*b as usize)),
            |pair| joints.hold(world, shapes, pair),
            &scratch.exec,
        );
    } else {
        desk.candidates = Default::default();
    }
    desk.seats = match world.implicit {
        Some(_) => covered::seats(world, desk),
        None => Default::default(),
    };
    let before = std::mem::replace(&mut world.found.held, desk.candidates.held.clone());
    let old = std::mem::take(&mut world.found.pairs);
    let (grounded, old): (Vec<_>, Vec<_>) =
        old.into_iter().partition(|pair| world.is_terrain(pair.ends[0] as usize));
    let earlier = Earlier {
        lineage: &world.lineage,
        roles: were,
        held: &before,
        hidden: hidden_of_split(world, &old),
    };
    let mut dropped = Works::default();
    let mut pairs = desk.candidates.carry(
        old.into_iter().map(|pair| (pair.key(), pair)),
        |candidate| earlier.begin(candidate.key()),
        |_, pair| drop_pair(&mut dropped, &pair),
    );
    terrain::add_pairs(world, &desk.terrain.blocks, grounded, &mut pairs, &mut dropped);
    world.found.pairs = pairs;
    world.works.add(&dropped);
    constants::find(world, desk, &scratch.exec);
    let pairs = &world.found.pairs;
    desk.slots = vec![Slot::default(); pairs.len()];
    desk.groups = vec![PairGroup::default(); pairs.len().div_ceil(GROUP)];
    desk.workspaces.resize_with(scratch.exec.workspaces(pairs.len()), Workspace::default);
    incidence(world, desk);
    desk.ready = true;
    scratch.tiles.make_rows(world);
}

/// What was known of blocks before they became a pair.
struct Earlier<'a> {
    lineage: &'a [Origin],
    /// Roles until now, where they have been found again.
    roles: &'a [Role],
    /// Pairs that joints held; sorted.
    held: &'a [PairKey],
    /// See [`hidden_of_split`].
    hidden: BTreeMap<PairKey, [f64; 2]>,
}

impl Earlier<'_> {
    /// A block and those that it was split from.
    fn up(&self, b: u32) -> impl Iterator<Item = u32> + '_ {
        let parent = |b: &u32| Some(self.lineage[*b as usize].parent);
        std::iter::successors(Some(b), move |b| parent(b).filter(|p| *p != Origin::NONE))
    }

    fn was_passive(&self, b: u32) -> bool {
        let role = self.up(b).find_map(|b| self.roles.get(b as usize));
        role == Some(&Role::Passive)
    }

    /// A pair that becomes a candidate.
    fn begin(&self, key: PairKey) -> FoundPair {
        let of_parents = |PairKey { ends: [i, j], image }: PairKey| {
            let pair = |i: u32, j: u32| self.hidden.get(&PairKey::sorted([i, j], image).0).copied();
            self.up(i).find_map(|i| self.up(j).find_map(|j| pair(i, j)))
        };
        // It was not looked at as long as joints held it, or both blocks in the largest lattice: what it overlaps by presses from now on
        // only with what comes on top.
        let seated = self.held.binary_search(&key).is_ok();
        let offset = if seated || key.ends.iter().all(|b| self.was_passive(*b)) {
            Some(Offset::new(Carried::default()))
        } else if self.hidden.is_empty() {
            None
        } else {
            of_parents(key).map(Offset::begin)
        };
        FoundPair { offset: offset.map(Box::new), seated, ..FoundPair::new(key) }
    }
}

/// Which pairs each block is in; terrain itself is in none.
fn incidence(world: &World, desk: &mut ContactScratch) {
    let pairs = &world.found.pairs;
    let searched = desk.candidates.pairs.len();
    let ends = |k: usize| {
        let ends = pairs[k].ends.into_iter().zip([false, true]);
        ends.skip(usize::from(k >= searched))
    };
    let all = || (0..pairs.len()).flat_map(|k| ends(k).map(move |(b, second)| (k, b, second)));
    desk.blocks = all().map(|(_, b, _)| b).collect();
    desk.blocks.sort_unstable();
    desk.blocks.dedup();
    desk.place = vec![u32::MAX; world.alive.len()];
    for (k, &b) in desk.blocks.iter().enumerate() {
        desk.place[b as usize] = k as u32;
    }
    let mut counts = vec![0u32; desk.blocks.len() + 1];
    for (_, b, _) in all() {
        counts[desk.place[b as usize] as usize + 1] += 1;
    }
    for k in 1..counts.len() {
        counts[k] += counts[k - 1];
    }
    desk.incidence = vec![(0, false); counts.last().map_or(0, |all| *all as usize)];
    let mut next = counts.clone();
    for (k, b, second) in all() {
        let at = &mut next[desk.place[b as usize] as usize];
        desk.incidence[*at as usize] = (k as u32, second);
        *at += 1;
    }
    desk.first_normal = vec![0];
    let mut normals = 0;
    for (k, &b) in desk.blocks.iter().enumerate() {
        // Its pairs with terrain come last, and ask for no normals here.
        let (first, _) = desk.incidence[counts[k] as usize];
        if (first as usize) < searched {
            normals += desk.shapes[world.solid[b as usize] as usize].faces() as u32;
        }
        desk.first_normal.push(normals);
    }
    desk.first_pair = counts;
    desk.acting = vec![Acting::default(); desk.blocks.len()];
    let between = if world.found.levels.is_some() { desk.blocks.len() } else { 0 };
    desk.between = vec![Between::default(); between];
}

/// Largest step that found contacts allow, s: stability of those that can touch, and no step in which two blocks could pass through
/// each other. Infinite before the first evaluation and where none can touch.
#[must_use]
pub fn step_limit(world: &World) -> f64 {
    let longest = [world.found.longest_step, world.found.deformable.longest_step];
    (longest.into_iter().flatten()).fold(f64::INFINITY, f64::min)
}

/// Whether a joint of the model has the interface, for each of them.
pub(crate) fn joined(world: &World) -> Vec<bool> {
    let mut joined = vec![false; world.setup.interfaces.len()];
    for class in &world.patches.class {
        joined[usize::from(world.classes[*class as usize].row)] = true;
    }
    joined
}

#[cfg(test)]
pub(crate) mod tests;
