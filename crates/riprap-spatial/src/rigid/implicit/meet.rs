//! Pairs of found contact for the implicit step: the one place that knows both.

use riprap_core::sums::GROUP;
use riprap_geom::Vec3;

use crate::broad::covered::{Covered, has};
use crate::contact;
use crate::implicit::geometry::{Reach, reach, reach_ground};
use crate::implicit::glued::{reach_glued, reach_ground_glued};
use crate::implicit::memory::{Implicit, sprung};
use crate::implicit::pair::{Pair, Reply};
use crate::implicit::patch::Twist;
use crate::kernel::friction::Wrench;
use crate::kernel::glued::Placed;
use crate::kernel::surface;
use crate::kernel::{Body, Memory, PairKey, Pose, Role, Terrain, turn};
use crate::state::contact_scratch::{
    ContactScratch, Deepest, Exerted, PairGroup, PairKind, Pressed, Slot, Workspace,
};
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::scratch::{NearPair, Scratch};
use crate::state::world::World;

/// Gap that every pair is looked at within, m.
const NEAR: f64 = 2e-5;
/// Way of the blocks in a step, over that at their present speeds, that pieces are made for.
const AHEAD: f64 = 0.7;
/// Way of two blocks towards each other in a step at most, over the smaller inscribed radius.
const TRANSIT: f64 = 0.5;
/// Faces that are listed for a candidate hold as long as faces are moved outward by at most so much of the sum of the margins.
const LISTED: f64 = 0.25;
/// Blocks cover each other's faces in steps in which they move by no more than this share of the smaller inscribed radius.
const COVERED: f64 = 0.02;
/// What rounding may take from a gap, over the gap.
const ROUNDING: f64 = 1e-9;
/// Way of a block in a step at most, over the largest margin that the search gives it.
const FLIGHT: f64 = 0.9;
/// That margin over the radius of the block.
const MARGIN: f64 = 0.4;

/// Finds the pairs within reach of a step of `dt` (s).
pub(super) fn find(world: &mut World, scratch: &mut Scratch, dt: f64) {
    contact::place(world, &mut scratch.desk, &scratch.exec, None);
    let mut pairs = std::mem::take(&mut world.found.pairs);
    let mut workspaces = std::mem::take(&mut scratch.desk.workspaces);
    let desk = &mut scratch.implicit;
    desk.begin(world.alive.len(), pairs.len());
    let covered = contact::covered::at_present(world, &scratch.desk, dt);
    let looking = Looking {
        world,
        memory: world.implicit.as_deref(),
        contacts: &scratch.desk,
        covered: &covered,
        dt,
    };
    let width = scratch.width;
    let mut nothing = vec![(); pairs.len().div_ceil(GROUP)];
    scratch.exec.groups2(
        &mut pairs,
        &mut desk.found,
        &mut nothing,
        &mut workspaces,
        |first, pairs, found, (), workspace| {
            let Workspace { walker, gluer, .. } = &mut *workspace;
            for walker in [walker, &mut gluer.walker, &mut gluer.other] {
                walker.cutter.limit_width(width);
            }
            workspace.under.limit_width(width);
            for (k, (pair, found)) in pairs.iter_mut().zip(found).enumerate() {
                looking.at(first + k, pair, found, workspace);
            }
        },
    );
    let mut longest = flight(world, &scratch.desk);
    let mut spare = Vec::new();
    for (k, found) in desk.found.iter_mut().enumerate() {
        let way = pairs[k].gap.max(0.0) + TRANSIT * scratch.desk.constants[k].inradius;
        if found.slot.nearing > 0.0 {
            longest = longest.min(way / found.slot.nearing);
        }
        scratch.desk.slots[k] = found.slot;
        if found.lost {
            desk.lost.push(k as u32);
        }
        for pair in &mut found.patches[..found.near] {
            desk.stored[0] += pair.stored(&mut spare);
            desk.stored[1] += sprung(&pair.law, pair);
            desk.pairs.push(k as u32);
            desk.solver.pairs.push(std::mem::take(pair));
        }
    }
    contact::note_left(world, &mut workspaces);
    scratch.desk.workspaces = workspaces;
    world.found.pairs = pairs;
    world.found.longest_step = Some(longest);
}

/// Longest step in which no block outruns the search, s.
fn flight(world: &World, desk: &ContactScratch) -> f64 {
    let smallest = desk.shapes.iter().map(|shape| shape.radius).fold(f64::INFINITY, f64::min);
    let search = &world.found.search;
    let mut longest = f64::INFINITY;
    let roles = world.found.roles.iter().enumerate();
    for b in roles.filter(|(_, role)| **role != Role::Absent).map(|(b, _)| b) {
        let size = world.solid_of(b).radius.min(2.0 * smallest);
        let way = FLIGHT * search.margin[b].max(MARGIN * size);
        let speed = speed(world, b);
        if speed > 0.0 {
            longest = longest.min(way / speed);
        }
    }
    longest
}

/// Bound of the speed of the points of a block, m/s.
fn speed(world: &World, b: usize) -> f64 {
    world.bodies.velocity(b).length() + world.bodies.spin(b).length() * world.solid_of(b).radius
}

/// What a look at the pairs needs.
struct Looking<'a> {
    world: &'a World,
    memory: Option<&'a Implicit>,
    /// Its blocks are where they are now.
    contacts: &'a ContactScratch,
    /// Faces that blocks which lie flush on each other cover.
    covered: &'a Covered,
    /// Length of the coming step, s.
    dt: f64,
}

impl Looking<'_> {
    fn body(&self, key: &PairKey, side: usize) -> Body<'_> {
        let (desk, b) = (self.contacts, key.ends[side]);
        let at = desk.place[b as usize] as usize;
        let normals = desk.first_normal[at] as usize..desk.first_normal[at + 1] as usize;
        Body {
            shape: &desk.shapes[self.world.solid[b as usize] as usize],
            normals: &desk.normals[normals],
            turn: desk.turns[at],
            position: key.place(side, desk.poses[at].position, &self.world.setup.periodic),
        }
    }

    /// Bound of the speed at which points of two bodies come nearer to each other, m/s.
    fn nearing(&self, [i, j]: [u32; 2], on_ground: bool) -> f64 {
        let world = self.world;
        if on_ground {
            return speed(world, j as usize);
        }
        let [i, j] = [i, j].map(|b| b as usize);
        let apart = world.bodies.velocity(i) - world.bodies.velocity(j);
        let turning = |b: usize| world.bodies.spin(b).length() * world.solid_of(b).radius;
        apart.length() + turning(i) + turning(j)
    }

    /// Looks at pair `k`.
    fn at(&self, k: usize, pair: &mut FoundPair, found: &mut NearPair, work: &mut Workspace) {
        let Self { world, contacts, dt, .. } = self;
        (found.slot, found.near, found.lost) = (Slot::default(), 0, false);
        let constants = &contacts.constants[k];
        let on_ground = matches!(constants.kind, PairKind::Terrain(_));
        let [i, j] = pair.ends.map(|b| b as usize);
        let speeds = [if on_ground { 0.0 } else { speed(world, i) }, speed(world, j)];
        let fall = world.gravity.length() * dt;
        found.slot.nearing = self.nearing(pair.ends, on_ground);
        let most = TRANSIT * constants.inradius;
        let out = (NEAR + AHEAD * dt * (speeds[0] + speeds[1] + fall)).min(most);
        if pair.gap > 0.0 {
            pair.gap -= found.slot.nearing * world.pending;
            if pair.gap > 2.0 * out {
                return;
            }
        }
        if world.pending > 0.0 {
            pair.start = pair.next;
        }
        let (reached, count) = match constants.kind {
            PairKind::Terrain(ground) => self.on_ground(ground.into(), k, pair, out, found, work),
            PairKind::Convex => self.convex(k, pair, out, found, work),
            PairKind::Glued => self.glued(k, pair, out, found, work),
        };
        match reached {
            Reach::Apart(gap) => {
                *pair = FoundPair { gap: gap - ROUNDING * gap, ..FoundPair::new(pair.key()) };
            }
            Reach::Lost => {
                found.lost = true;
                pair.depth = 2.0 * constants.inradius;
            }
            Reach::Near(next) => {
                pair.gap = 0.0;
                pair.offset = None;
                pair.next = next;
                for patch in &mut found.patches[..count] {
                    let kept = self.memory.and_then(|memory| memory.of(pair.key(), patch.key));
                    if let Some(kept) = kept {
                        kept.recall(patch, &mut Vec::new());
                        self.follow(pair.ends, kept.arm, patch, on_ground);
                    }
                }
                found.near = count;
            }
        }
    }

    /// Corrects a contact for the turns of its blocks in the last step; `arm` is that of the first one at its start, m.
    fn follow(&self, ends: [u32; 2], arm: Vec3, patch: &mut Pair, on_ground: bool) {
        let (world, dt) = (self.world, self.world.last_dt);
        let [i, j] = ends.map(|b| b as usize);
        let still = [Vec3::ZERO; 2];
        let motion = |b: usize| [world.bodies.velocity(b), world.bodies.spin(b)];
        let [first, second] = [if on_ground { still } else { motion(i) }, motion(j)];
        // On terrain arms are those from the centroid of the block.
        let between = match on_ground {
            true => Vec3::ZERO,
            false => patch.centres[0] - patch.centres[1] - dt * (first[0] - second[0]),
        };
        patch.follow([first[1], second[1]].map(|w| dt * w), [arm, arm + between]);
    }

    /// Two convex blocks; how many patches they share.
    fn convex(
        &self,
        k: usize,
        pair: &FoundPair,
        out: f64,
        found: &mut NearPair,
        work: &mut Workspace,
    ) -> (Reach, usize) {
        let contacts = self.contacts;
        let bodies = [0, 1].map(|side| self.body(&pair.key(), side));
        let candidate = &contacts.candidates.pairs[k];
        let margins: f64 =
            pair.ends.map(|b| self.world.found.search.margin[b as usize]).iter().sum();
        let listed = out <= LISTED * margins;
        let held = contacts.covered.of_pair(pair.ends);
        // In longer steps a wedge that slides on two blocks was caught by it.
        let near = out <= COVERED * contacts.constants[k].inradius;
        let flush = if near { self.covered.of_pair(pair.ends) } else { [0; 2] };
        let covered = [held[0] | flush[0], held[1] | flush[1]];
        let as_listed = candidate.faces(&contacts.candidates.lists);
        let all: [Vec<u16>; 2] = [0, 1].map(|side: usize| {
            let bare = |face: &u16| !has(covered[side], usize::from(*face));
            match listed {
                true if flush[side] == 0 => Vec::new(),
                true => as_listed[side].iter().copied().filter(bare).collect(),
                false => (0..bodies[side].shape.faces() as u16).filter(bare).collect(),
            }
        });
        let faces = [0, 1].map(|side: usize| match listed && flush[side] == 0 {
            true => as_listed[side],
            false => &all[side][..],
        });
        let place =
            |side: usize, face: u16| faces[side].binary_search(&face).ok().map(|k| k as u16);
        let hint = pair.start.and_then(|[f, g]| Some([place(0, f)?, place(1, g)?]));
        let law = contacts.constants[k].law(&contacts.rows);
        let ties = candidate.ties || !listed;
        let surface =
            surface::Pair { bodies: bodies.each_ref(), faces, ties, hint, covered, witnesses: &[] };
        if found.patches.is_empty() {
            found.patches.push(Pair::default());
        }
        let reached = reach(&mut work.walker, &surface, out, law, &mut found.patches[0]);
        match reached {
            Reach::Near(hint) => {
                let next = hint.map(|[f, g]| [faces[0][f as usize], faces[1][g as usize]]);
                (Reach::Near(next), 1)
            }
            Reach::Apart(_) | Reach::Lost => (reached, 0),
        }
    }

    /// Two blocks of which one at least is made of glued parts; how many patches they share.
    fn glued(
        &self,
        k: usize,
        pair: &FoundPair,
        out: f64,
        found: &mut NearPair,
        work: &mut Workspace,
    ) -> (Reach, usize) {
        let (world, contacts, key) = (self.world, self.contacts, pair.key());
        let pose = |side: usize| {
            let at = contacts.place[key.ends[side] as usize] as usize;
            let Pose { position, rotation } = contacts.poses[at];
            Pose { position: key.place(side, position, &world.setup.periodic), rotation }
        };
        let placed = Placed {
            blocks: key.ends.map(|b| &contacts.glued[world.solid[b as usize] as usize]),
            poses: [pose(0), pose(1)],
        };
        let law = contacts.constants[k].law(&contacts.rows);
        reach_glued(&mut work.gluer, &placed, out, law, &mut found.patches)
    }

    /// A block on terrain; on how many facets it has patches.
    fn on_ground(
        &self,
        ground: usize,
        k: usize,
        pair: &FoundPair,
        out: f64,
        found: &mut NearPair,
        work: &mut Workspace,
    ) -> (Reach, usize) {
        let (world, contacts) = (self.world, self.contacts);
        let b = pair.ends[1] as usize;
        let pose = world.pose(b);
        let shape = &contacts.shapes[world.solid[b] as usize];
        let grounds = &contacts.terrain.grounds;
        work.normals.clear();
        let turn = turn(shape, pose.rotation, &mut work.normals);
        let beside = |ground: &Terrain| ground.depth(pose.position).is_none();
        if !world.found.left_terrain[b] && grounds.iter().all(beside) {
            work.beside.push(b as u32);
        }
        let body = Body { shape, normals: &work.normals, turn, position: pose.position };
        let law = contacts.constants[k].law(&contacts.rows);
        let glued = contacts.glued.get(world.solid[b] as usize).filter(|glued| !glued.is_convex());
        if let Some(glued) = glued {
            let (under, block) = (&mut work.under, (glued, &pose));
            let terrain = &grounds[ground];
            return reach_ground_glued(under, terrain, block, out, law, &mut found.patches);
        }
        reach_ground(&mut work.under, &grounds[ground], &body, out, law, &mut found.patches)
    }
}

/// Hands what the pairs exert to the blocks and to those who read contacts.
pub(super) fn hand_over(world: &mut World, scratch: &mut Scratch) {
    let desk = &mut scratch.desk;
    desk.groups.iter_mut().for_each(PairGroup::begin);
    let implicit = &scratch.implicit;
    let unknown =
        Exerted { elastic: Wrench { force: Vec3::NAN, ..Wrench::default() }, ..Exerted::default() };
    let mut deepest = None;
    let solver = &implicit.solver;
    let mut near = implicit.pairs.iter().zip(&solver.pairs).zip(&solver.replies).peekable();
    let mut lost = implicit.lost.iter().peekable();
    for (k, pair) in world.found.pairs.iter_mut().enumerate() {
        let (group, slot) = (&mut desk.groups[k / GROUP], &mut desk.slots[k]);
        let reach = desk.constants[k].inradius;
        if lost.next_if(|at| **at as usize == k).is_some() {
            // No force can be given: not a number stops the run, and the deepest contact is to blame.
            slot.at = group.push(unknown);
            let deep = Deepest::new(pair.ends, Pressed::NoSurface, pair.depth, reach);
            deepest = Deepest::deeper(deepest, Some(deep));
            continue;
        }
        pair.depth = 0.0;
        pair.patches.clear();
        let mut all: Option<Exerted> = None;
        while let Some(((_, of), reply)) = near.next_if(|((at, _), _)| **at as usize == k) {
            if of.pressure.force <= 0.0 {
                continue;
            }
            let exerted = Exerted {
                elastic: about_centroids(&reply.elastic, of),
                spring: about_centroids(&reply.spring, of),
                drag: Wrench::default(),
            };
            pair.depth = pair.depth.max(reply.depth);
            pair.push(ContactPatch {
                key: of.key,
                memory: told(of, reply),
                stored: sprung(&of.law, of),
                force: exerted.elastic.force + exerted.spring.force,
                pressed: exerted.elastic.force.length(),
                depth: reply.depth,
                area: of.pressure.area,
            });
            slot.area += of.pressure.area;
            all = Some(all.map_or(exerted, |mut sum| {
                sum.add(&exerted);
                sum
            }));
        }
        let Some(exerted) = all else { continue };
        slot.at = group.push(exerted);
        slot.touching = true;
        let deep = Deepest::new(pair.ends, Pressed::Contact, pair.depth, reach);
        deepest = Deepest::deeper(deepest, Some(deep));
    }
    desk.deepest = deepest;
    contact::sum(desk, &scratch.exec);
}

/// The memory of an explicit contact in the same state, for who reads contacts and for an explicit phase that comes next.
fn told(of: &Pair, reply: &Reply) -> Memory {
    let pressure = &of.pressure;
    Memory {
        shear: reply.shear,
        torsion: reply.torsion,
        normal: of.direction,
        area: pressure.area,
        polar: pressure.area * pressure.radius * pressure.radius,
        sliding: reply.sliding,
        arms: of.centres.map(|centre| pressure.centre - centre),
    }
}

/// A wrench on the second block about the origin of a pair as what both blocks feel.
fn about_centroids(wrench: &Twist, of: &Pair) -> Wrench {
    let [fx, fy, fz, mx, my, mz] = *wrench;
    let (force, moment) = (Vec3::new(fx, fy, fz), Vec3::new(mx, my, mz));
    let [a, b] = of.centres;
    Wrench { force, moment_a: a.cross(force) - moment, moment_b: moment - b.cross(force) }
}
