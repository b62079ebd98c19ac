//! What all pairs exert in a step, and the sums on each block.
//!
//! One machine for all kinds of bodies: the narrow phase finds the patches that a pair shares, each finds its memory by its key and answers by one
//! law ([`contact_force`]), and what all of them exert is added to the group of the pair. Each block adds that of its pairs in their order: the same bits for
//! any number of threads.

use std::ops::Range;
use std::time::Instant;

use riprap_core::sums::{GROUP, tree};
use riprap_geom::{Mat3, Vec3};

use crate::broad::covered::Covered;
use crate::broad::search::Candidates;
use crate::contact::limit::{Known, Speeds};
use crate::contact::narrow::{self, OnGround, Patch};
use crate::contact::{left, levels, limit, shared};
use crate::exec::{CHUNK, Exec};
use crate::kernel::glued::{Glued, Placed};
use crate::kernel::{
    Body, ContactInput, ContactLaw, Memory, Motion, Pair, PairKey, Periods, Pose, Reached, Shape,
    Sums, Terrain, contact_force, part, turn,
};
use crate::state::contact_scratch::{
    Acting, Constants, ContactScratch, Deepest, Exerted, PairGroup, PairKind, PairSums, Pressed,
    Slot, Workspace, exerted,
};
use crate::state::event::EditKind;
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Gap over the smaller inscribed radius beyond which blocks no longer lie in place: that at which a joint of a cube is released.
const SEATED: f64 = 0.02;

/// Finds what all pairs exert, and the sums on each block.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch) {
    let own = own_pairs(world, scratch);
    place(world, &mut scratch.desk, &scratch.exec, own.clone());
    let mut pairs = std::mem::take(&mut world.found.pairs);
    let own = own.unwrap_or(0..pairs.len());
    let sums = evaluate(world, scratch, &mut pairs, own);
    world.found.pairs = pairs;
    let desk = &mut scratch.desk;
    note_left(world, &mut desk.workspaces);
    world.found.unlabelled += u64::from(sums.unlabelled);
    world.works.friction += sums.friction;
    // What pairs store from here on without work is made by an edit, less
    // what the joints stored that they take over from.
    world.works.contact_path += sums.booked;
    world.works.edit_defect += sums.booked - sums.left;
    desk.deepest = sums.deepest;
    limit::find_negligible_impacts(world, desk, sums.impacts);
    let stable = match world.found.levels.is_some() {
        true => levels::plan(world, scratch),
        false => limit::longest_step(world, desk, &scratch.exec, scratch.share.as_ref()),
    };
    sum(&mut scratch.desk, &scratch.exec);
    world.found.longest_step = world.found.longest_step.map(|reach| reach.min(stable));
}

/// The pairs of this rank, of several.
fn own_pairs(world: &World, scratch: &mut Scratch) -> Option<Range<usize>> {
    let count = world.found.pairs.len();
    let share = scratch.sharing(world)?;
    share.pairs.fit(count.div_ceil(GROUP));
    Some(shared::part(share, share.peers.rank(), count))
}

/// Evaluates the pairs `own` and learns of all others; their sums.
fn evaluate(
    world: &World,
    scratch: &mut Scratch,
    pairs: &mut [FoundPair],
    own: Range<usize>,
) -> PairSums {
    let begun = Instant::now();
    let desk = &mut scratch.desk;
    let evaluation = Evaluation {
        bodies: BodiesInPairs {
            shapes: &desk.shapes,
            glued: &desk.glued,
            solid: &world.solid,
            place: &desk.place,
            first_normal: &desk.first_normal,
            normals: &desk.normals,
            turns: &desk.turns,
            poses: &desk.poses,
            turning: &desk.turning,
            periods: &world.setup.periodic,
            covered: &desk.covered,
        },
        world,
        candidates: &desk.candidates,
        grounds: &desk.terrain.grounds,
        known: Known {
            constants: &desk.constants,
            rows: &desk.rows,
            facings: &desk.facings,
            inverse_masses: &desk.inverse_masses,
        },
        gravity: world.gravity.length(),
        dt: world.pending,
        last_dt: world.last_dt,
        ends: scratch.coming_dt == 0.0,
    };
    let width = scratch.width;
    let ContactScratch { slots, groups, workspaces, sums, .. } = desk;
    let these = (&mut pairs[own.clone()], &mut slots[own.clone()]);
    let of = &mut groups[own.start / GROUP..own.end.div_ceil(GROUP)];
    scratch.exec.groups2(these.0, these.1, of, workspaces, |at, pairs, slots, group, work| {
        let first = own.start + at;
        group.begin();
        let Workspace { walker, gluer, under, .. } = &mut *work;
        for walker in [walker, &mut gluer.walker, &mut gluer.other] {
            walker.cutter.limit_width(width);
        }
        under.limit_width(width);
        for (k, (pair, slot)) in (first..).zip(pairs.iter_mut().zip(slots)) {
            evaluation.pair(k, pair, slot, group, work);
            slot.negligible_impact = false;
            if let Some(impact) = evaluation.known.impact(k, pair, slot, evaluation.gravity) {
                group.note(impact);
            }
        }
    });
    if let (Some(share), None) = (&mut scratch.share, &world.implicit) {
        shared::exchange(share, pairs, slots, groups, workspaces, begun.elapsed());
    }
    sums.clear();
    sums.extend(groups.iter().map(|group| group.sums));
    tree(sums, PairSums::add);
    sums.first().copied().unwrap_or_default()
}

/// Notes the blocks that have gone over the rim of all terrain since the last evaluation.
pub(crate) fn note_left(world: &mut World, workspaces: &mut [Workspace]) {
    let left = workspaces.iter_mut().flat_map(|workspace| workspace.beside.drain(..));
    let mut left: Vec<u32> = left.collect();
    // Which thread has seen which of them is chance.
    left.sort_unstable();
    for b in left {
        // Each pair with a terrain finds it.
        if !std::mem::replace(&mut world.found.left_terrain[b as usize], true) {
            let event = world.event(EditKind::LeftTerrain, b);
            world.events.push(event);
        }
    }
}

/// Turns the blocks that are in a pair to where they are now, with the normals of those that are in one of the pairs `own` alone where it is
/// given: an evaluation reads no others.
pub(crate) fn place(
    world: &World,
    desk: &mut ContactScratch,
    exec: &Exec,
    own: Option<Range<usize>>,
) {
    let ContactScratch { blocks, shapes, poses, turns, normals, first_normal, turning, .. } = desk;
    let of_own = own.map(|own| {
        let mut of_own = vec![false; blocks.len()];
        for b in world.found.pairs[own].iter().flat_map(|pair| pair.ends) {
            if let Some(of_own) = of_own.get_mut(desk.place[b as usize] as usize) {
                *of_own = true;
            }
        }
        of_own
    });
    if poses.len() != blocks.len() || normals.len() != first_normal[blocks.len()] as usize {
        *poses = vec![Pose::at(Vec3::ZERO); blocks.len()];
        *turns = vec![Mat3::IDENTITY; blocks.len()];
        *turning = vec![0.0; blocks.len()];
        *normals = vec![Vec3::ZERO; first_normal[blocks.len()] as usize];
    }
    let speeds = Speeds::of(world);
    exec.chunks(turning, |first, turning| {
        for (b, turning) in blocks[first..].iter().zip(turning) {
            *turning = speeds.turning(*b as usize);
        }
    });
    let nothing = &mut vec![(); blocks.len().div_ceil(CHUNK)];
    // Blocks that only terrain acts on are turned when they come near it.
    let placed = |k: usize| first_normal[k + 1] > first_normal[k];
    exec.chunks2(poses, turns, nothing, |first, poses, turns, ()| {
        let chunk = (first..).zip(&blocks[first..]).zip(poses.iter_mut().zip(turns));
        for ((_, b), (pose, turn)) in chunk.filter(|((k, _), _)| placed(*k)) {
            *pose = world.pose(*b as usize);
            *turn = Mat3::from_quat(pose.rotation);
        }
    });
    exec.ragged(turns, normals, first_normal, nothing, |first, turns, normals, ()| {
        let mut left = normals;
        let chunk = (first..).zip(&blocks[first..]).zip(turns);
        for ((k, b), turn) in chunk.filter(|((k, _), _)| placed(*k)) {
            let of = &shapes[world.solid[*b as usize] as usize].normals;
            let (own, rest) = left.split_at_mut(of.len());
            left = rest;
            if of_own.as_ref().is_some_and(|of_own| !of_own[k]) {
                continue;
            }
            for (to, n) in own.iter_mut().zip(of) {
                *to = *turn * *n;
            }
        }
    });
}

/// The blocks that are in a pair, turned to where they are now.
struct BodiesInPairs<'a> {
    shapes: &'a [Shape],
    /// As `shapes`; empty where no block has parts.
    glued: &'a [Glued],
    solid: &'a [u32],
    place: &'a [u32],
    first_normal: &'a [u32],
    normals: &'a [Vec3],
    turns: &'a [Mat3],
    poses: &'a [Pose],
    turning: &'a [f64],
    periods: &'a Periods,
    covered: &'a Covered,
}

impl BodiesInPairs<'_> {
    /// Two blocks by their terms.
    fn placed(&self, key: &PairKey) -> Placed<'_> {
        let pose = |side: usize| {
            let Pose { position, rotation } =
                self.poses[self.place[key.ends[side] as usize] as usize];
            Pose { position: key.place(side, position, self.periods), rotation }
        };
        Placed {
            blocks: key.ends.map(|b| &self.glued[self.solid[b as usize] as usize]),
            poses: [pose(0), pose(1)],
        }
    }

    /// The first (0) or second (1) block of a pair.
    fn body(&self, key: &PairKey, side: usize) -> Body<'_> {
        let b = key.ends[side];
        let at = self.place[b as usize] as usize;
        let normals = self.first_normal[at] as usize..self.first_normal[at + 1] as usize;
        Body {
            shape: self.shape(b),
            normals: &self.normals[normals],
            turn: self.turns[at],
            position: key.place(side, self.poses[at].position, self.periods),
        }
    }

    fn shape(&self, b: u32) -> &Shape {
        &self.shapes[self.solid[b as usize] as usize]
    }
}

struct Evaluation<'a> {
    bodies: BodiesInPairs<'a>,
    /// But for its pairs.
    world: &'a World,
    candidates: &'a Candidates,
    grounds: &'a [Terrain],
    known: Known<'a>,
    /// m/s².
    gravity: f64,
    /// Time moved since the last evaluation, s.
    dt: f64,
    /// Length of the last step, s.
    last_dt: f64,
    /// Whether the motion ends here, so that no pair waits.
    ends: bool,
}

impl Evaluation<'_> {
    /// Motion of a block, half a step ago.
    fn motion(&self, b: u32) -> Motion {
        Motion {
            velocity: self.world.bodies.velocity(b as usize),
            spin: self.world.bodies.spin(b as usize),
            inverse_mass: self.known.inverse_masses[b as usize],
        }
    }

    /// Bound of the speed at which points of two bodies come nearer to each other, m/s.
    fn nearing(&self, kind: PairKind, [i, j]: [u32; 2]) -> f64 {
        let bodies = &self.world.bodies;
        if let PairKind::Terrain(_) = kind {
            let j = j as usize;
            let radius = self.bodies.shape(j as u32).radius;
            return bodies.velocity(j).length() + bodies.spin(j).length() * radius;
        }
        let apart = bodies.velocity(i as usize) - bodies.velocity(j as usize);
        let turning = |b: u32| self.bodies.turning[self.bodies.place[b as usize] as usize];
        apart.length() + turning(i) + turning(j)
    }

    fn pair(
        &self,
        k: usize,
        pair: &mut FoundPair,
        slot: &mut Slot,
        group: &mut PairGroup,
        workspace: &mut Workspace,
    ) {
        let constants = &self.known.constants[k];
        let nearing = self.nearing(constants.kind, pair.ends);
        slot.nearing = nearing;
        if pair.gap > 0.0 {
            pair.gap -= nearing * self.dt;
            if pair.gap > 0.0 {
                return;
            }
        }
        let (mut motion, mut passed) = (pair.ends.map(|b| self.motion(b)), self.last_dt);
        if let Some(clock) = &mut pair.clock {
            if clock.left > 0 && !self.ends {
                *slot = levels::waiting(pair, constants, nearing, group);
                return;
            }
            // Another look at this instant finds it again.
            clock.left = 0;
            passed = self.world.time - clock.at;
            let now = pair.ends.map(|b| self.bodies.poses[self.bodies.place[b as usize] as usize]);
            levels::mean_motion(clock, now, passed, &mut motion);
        }
        let mut acting = InPair {
            law: constants.law(self.known.rows),
            centres: [Vec3::ZERO; 2],
            motion,
            radius: 0.0,
            dt: if self.dt > 0.0 && pair.clock.is_some() { passed } else { self.dt },
            last_dt: passed,
            old: std::mem::take(&mut workspace.old),
            exerted: Exerted::default(),
            area: 0.0,
            sums: &mut group.sums,
            pair,
        };
        acting.old.clear();
        acting.old.append(&mut acting.pair.patches);
        acting.pair.depth = 0.0;
        let before = acting.old.first().map_or(Memory::default(), |patch| patch.memory);
        let reached = match constants.kind {
            PairKind::Convex => self.convex(k, &mut acting, workspace),
            PairKind::Glued => self.glued(&mut acting, workspace),
            PairKind::Terrain(ground) => self.on_ground(ground.into(), &mut acting, workspace),
        };
        acting.part();
        workspace.old = std::mem::take(&mut acting.old);
        *slot = Slot { nearing, ..acting.end(reached, constants, &before) };
        let exerted = acting.exerted;
        if !matches!(reached, Reached::Apart(_)) {
            slot.at = group.push(exerted);
        }
    }

    fn convex(&self, k: usize, acting: &mut InPair, workspace: &mut Workspace) -> Reached {
        let candidate = &self.candidates.pairs[k];
        let key = acting.pair.key();
        let bodies = [0, 1].map(|side| self.bodies.body(&key, side));
        acting.centres = [0, 1].map(|side: usize| bodies[side].position);
        acting.radius = bodies[0].shape.radius.min(bodies[1].shape.radius);
        // The walk begins where the step before has ended, also where this instant
        // is evaluated again: its order makes the bits.
        if self.dt > 0.0 {
            acting.pair.start = acting.pair.next;
        }
        let faces = candidate.faces(&self.candidates.lists);
        let place =
            |side: usize, face: u16| faces[side].binary_search(&face).ok().map(|k| k as u16);
        let hint = acting.pair.start.and_then(|[f, g]| Some([place(0, f)?, place(1, g)?]));
        let pair = Pair {
            bodies: [&bodies[0], &bodies[1]],
            faces,
            ties: candidate.ties,
            hint,
            covered: self.bodies.covered.of_pair(key.ends),
            witnesses: candidate.witnesses(&self.candidates.witnesses),
        };
        let law = acting.law;
        narrow::convex(&mut workspace.walker, &pair, &law, |patch| acting.patch(patch))
    }

    fn glued(&self, acting: &mut InPair, workspace: &mut Workspace) -> Reached {
        let key = acting.pair.key();
        let placed = self.bodies.placed(&key);
        let [a, b] = key.ends.map(|b| self.bodies.shape(b).radius);
        acting.radius = a.min(b);
        acting.centres = placed.poses.map(|pose| pose.position);
        let law = acting.law;
        narrow::glued(&mut workspace.gluer, &placed, &law, |patch| acting.patch(patch))
    }

    fn on_ground(&self, ground: usize, acting: &mut InPair, workspace: &mut Workspace) -> Reached {
        let b = acting.pair.ends[1];
        let shape = self.bodies.shape(b);
        let pose = self.world.pose(b as usize);
        let Workspace { under, ridges, normals, beside, .. } = workspace;
        normals.clear();
        let turn = turn(shape, pose.rotation, normals);
        let rim = |ground: &Terrain| ground.depth(pose.position).is_none();
        if !self.world.found.left_terrain[b as usize] && self.grounds.iter().all(rim) {
            beside.push(b);
        }
        acting.motion[0] = Motion::default();
        acting.centres = [pose.position; 2];
        acting.radius = shape.radius;
        let glued = self.bodies.glued.get(self.bodies.solid[b as usize] as usize);
        let on = OnGround {
            terrain: &self.grounds[ground],
            body: Body { shape, normals, turn, position: pose.position },
            pose,
            glued: glued.filter(|glued| !glued.is_convex()),
        };
        let (law, nothing) = (acting.law, Sums::default());
        let asked = acting.input(&Patch::new([0; 2], &nothing, pose.position, &|_| ()));
        let reached = on.find(under, ridges, (&law, &asked), |patch| acting.patch(patch));
        if let Reached::Touching = reached {
            for rocking in ridges.rocking() {
                acting.exerted.drag = acting.exerted.drag.plus(rocking);
            }
        }
        reached
    }
}

/// A pair that is evaluated: what its patches answer, and their sums.
struct InPair<'a> {
    law: ContactLaw,
    /// Centroids of both, m.
    centres: [Vec3; 2],
    /// Motion of both, half a step ago.
    motion: [Motion; 2],
    /// Radius of the smaller block, m.
    radius: f64,
    dt: f64,
    last_dt: f64,
    /// Patches of the last evaluation that have not been found again.
    old: Vec<ContactPatch>,
    exerted: Exerted,
    /// m².
    area: f64,
    sums: &'a mut PairSums,
    pair: &'a mut FoundPair,
}

impl InPair<'_> {
    /// What the law is asked of a patch.
    fn input<'q>(&self, patch: &Patch<'q>) -> ContactInput<'q> {
        ContactInput {
            sums: patch.sums,
            pieces: patch.pieces,
            origin: patch.origin,
            centres: self.centres,
            motion: self.motion,
            radius: self.radius,
            dt: self.dt,
            last_dt: self.last_dt,
            shared: patch.shared,
            falls: patch.falls,
        }
    }

    /// Evaluates a patch, with what it remembers.
    fn patch(&mut self, found: &Patch) {
        let key = found.key;
        let old = self.old.iter().position(|patch| patch.key == key);
        let mut patch = old.map_or_else(
            || ContactPatch { key, ..ContactPatch::default() },
            |k| self.old.remove(k),
        );
        let law = self.law.part(found.share);
        let handed_over = self.pair.offset.as_ref().is_some_and(|o| o.joint.is_some());
        let before = left(self.pair) + patch.stored;
        let input = self.input(found);
        let output = contact_force(&law, &input, &mut patch.memory, &mut self.pair.offset);
        self.sums.unlabelled += found.unlabelled;
        self.sums.friction += output.friction;
        self.sums.booked += output.booked;
        if handed_over {
            // The springs along the contact have the stiffness of its law from now on, and act at its point.
            self.sums.left += before - output.sprung;
        }
        let exerted = Exerted {
            elastic: output.elastic.plus(&output.offset),
            spring: output.spring,
            drag: output.drag,
        };
        patch.stored = patch.memory.stored(law.shear_stiffness);
        patch.force = exerted.elastic.force + exerted.spring.force;
        patch.pressed = exerted.elastic.force.length();
        (patch.depth, patch.area) = (found.sums.depth, output.area);
        self.exerted.add(&exerted);
        self.area += output.area;
        // What is not a number must not pass for shallow.
        if patch.depth > self.pair.depth || patch.depth.is_nan() {
            self.pair.depth = patch.depth;
        }
        self.pair.next = found.next;
        self.pair.push(patch);
    }

    /// Ends the evaluation; how the pair touches. `before`: what its first patch remembered until now.
    fn end(&mut self, reached: Reached, constants: &Constants, before: &Memory) -> Slot {
        let Self { sums, pair, .. } = self;
        let reach = constants.inradius;
        let pressed = match (reached, constants.kind) {
            (Reached::Apart(gap), _) => {
                sums.left += left(pair);
                sums.booked += part(pair.offset.take(), &self.motion, before, self.dt);
                let seated = pair.seated && gap <= SEATED * reach;
                let clock = pair.clock.take();
                **pair = FoundPair { gap, seated, clock, ..FoundPair::new(pair.key()) };
                return Slot::default();
            }
            (Reached::Touching, _) => Pressed::Contact,
            (Reached::FullyPenetrated(depth), kind) => {
                // No force can be given: not a number stops the run, and the deepest contact is to blame.
                self.exerted.elastic.force = Vec3::NAN;
                pair.depth = depth;
                let on_ground = matches!(kind, PairKind::Terrain(_));
                if on_ground { Pressed::Contact } else { Pressed::NoSurface }
            }
        };
        pair.gap = 0.0;
        let deep = Deepest::new(pair.ends, pressed, pair.depth, reach);
        sums.deepest = Deepest::deeper(sums.deepest, Some(deep));
        Slot { touching: !pair.patches.is_empty(), area: self.area, ..Slot::default() }
    }

    /// What has not been found again has parted: what its springs held is friction.
    fn part(&mut self) {
        for gone in self.old.drain(..) {
            self.sums.friction += gone.memory.work(&self.motion, self.dt) + gone.stored;
        }
    }
}

/// Adds what the pairs exert, block by block in the order of the pairs.
pub(crate) fn sum(desk: &mut ContactScratch, exec: &Exec) {
    let ContactScratch { acting, first_pair, incidence, slots, groups, .. } = desk;
    exec.chunks(acting, |first, chunk| {
        for (ends, acting) in first_pair[first..].windows(2).zip(chunk) {
            *acting = Acting::default();
            let pairs = ends[0] as usize..ends[1] as usize;
            for &(k, second) in &incidence[pairs] {
                let k = k as usize;
                let slot = &slots[k];
                if let Some(by) = exerted(groups, slot, k).filter(|_| slot.weight == 1.0) {
                    acting.elastic.add(&by.elastic, second);
                    acting.spring.add(&by.spring, second);
                    acting.drag.add(&by.drag, second);
                } else if let Some(by) = exerted(groups, slot, k).filter(|_| slot.weight != 0.0) {
                    acting.elastic.add(&by.elastic.times(slot.weight), second);
                    acting.spring.add(&by.spring.times(slot.weight), second);
                    acting.drag.add(&by.drag.times(slot.weight), second);
                }
            }
        }
    });
}
