//! What all pairs exert in a step, and the sums on each block.
//!
//! Every pair adds what it exerts to its group, and each block adds that of its pairs in their order: the same bits for
//! any number of threads.

use riprap_core::sums::tree;
use riprap_geom::{Mat3, Vec3};

use crate::broad::search::Candidates;
use crate::contact::glued::Asked;
use crate::contact::limit;
use crate::contact::limit::{Known, Speeds};
use crate::contact::{glued, left};
use crate::exec::{CHUNK, Exec};
use crate::kernel::glued::{Glued, Placed};
use crate::kernel::{Body, ContactInput, Found, Motion, Pair, Pose, Shape, part, planes, respond};
use crate::state::contact_scratch::{
    Acting, ContactScratch, Deepest, Exerted, PairGroup, PairSums, Pressed, Slot, Workspace,
    exerted,
};
use crate::state::found::FoundPair;
use crate::state::scratch::Scratch;
use crate::state::world::{Bodies, World};

/// What rounding may take from a gap, over the gap.
const ROUNDING: f64 = 1e-9;
/// Gap over the smaller inscribed radius beyond which blocks no longer lie in place: that at which a joint of a cube lets go.
const SEATED: f64 = 0.02;

/// Finds what all pairs exert, and the sums on each block.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch) {
    let desk = &mut scratch.desk;
    place(world, desk, &scratch.exec);
    let ContactScratch { slots, groups, workspaces, sums, .. } = desk;
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
        },
        motions: &world.bodies,
        candidates: &desk.candidates,
        known: Known {
            constants: &desk.constants,
            rows: &desk.rows,
            facings: &desk.facings,
            inverse_masses: &desk.inverse_masses,
        },
        gravity: world.gravity.length(),
        dt: world.pending,
        last_dt: world.last_dt,
    };
    let width = scratch.width;
    scratch.exec.groups2(
        &mut world.found.pairs,
        slots,
        groups,
        workspaces,
        |first, pairs, slots, group, workspace| {
            group.begin();
            workspace.walker.cutter.limit_width(width);
            let gluer = &mut workspace.glued.gluer;
            gluer.walker.cutter.limit_width(width);
            gluer.other.cutter.limit_width(width);
            for (k, (pair, slot)) in pairs.iter_mut().zip(slots).enumerate() {
                let k = first + k;
                evaluation.pair(k, pair, slot, group, workspace);
                slot.negligible_impact = false;
                if let Some(impact) = evaluation.known.impact(k, pair, slot, evaluation.gravity) {
                    group.note(impact);
                }
            }
        },
    );
    sums.clear();
    sums.extend(groups.iter().map(|group| group.sums));
    tree(sums, PairSums::add);
    let sums = sums.first().copied().unwrap_or_default();
    world.found.unlabelled += u64::from(sums.unlabelled);
    world.works.friction += sums.friction;
    // What pairs store from here on without work is made by an edit, less
    // what the joints stored that they take over from.
    world.works.contact_path += sums.booked;
    world.works.edit_defect += sums.booked - sums.left;
    desk.deepest = sums.deepest;
    limit::find_negligible_impacts(world, desk, sums.impacts);
    sum(desk, &scratch.exec);
    let stable = limit::longest_step(world, desk, &scratch.exec);
    world.found.longest_step = world.found.longest_step.map(|reach| reach.min(stable));
}

/// Turns the blocks that are in a pair to where they are now.
fn place(world: &World, desk: &mut ContactScratch, exec: &Exec) {
    let ContactScratch { blocks, shapes, poses, turns, normals, first_normal, turning, .. } = desk;
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
    exec.chunks2(poses, turns, nothing, |first, poses, turns, ()| {
        let chunk = &blocks[first..];
        for ((b, pose), turn) in chunk.iter().zip(poses).zip(turns) {
            *pose = world.pose(*b as usize);
            *turn = Mat3::from_quat(pose.rotation);
        }
    });
    exec.ragged(turns, normals, first_normal, nothing, |first, turns, normals, ()| {
        let mut left = normals;
        for (b, turn) in blocks[first..].iter().zip(turns) {
            let of = &shapes[world.solid[*b as usize] as usize].normals;
            let (own, rest) = left.split_at_mut(of.len());
            for (to, n) in own.iter_mut().zip(of) {
                *to = *turn * *n;
            }
            left = rest;
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
}

impl BodiesInPairs<'_> {
    /// Two blocks by their terms.
    fn placed(&self, ends: [u32; 2]) -> Placed<'_> {
        Placed {
            blocks: ends.map(|b| &self.glued[self.solid[b as usize] as usize]),
            poses: ends.map(|b| self.poses[self.place[b as usize] as usize]),
        }
    }

    fn body(&self, b: u32) -> Body<'_> {
        let at = self.place[b as usize] as usize;
        let normals = self.first_normal[at] as usize..self.first_normal[at + 1] as usize;
        Body {
            shape: &self.shapes[self.solid[b as usize] as usize],
            normals: &self.normals[normals],
            turn: self.turns[at],
            position: self.poses[at].position,
        }
    }
}

struct Evaluation<'a> {
    bodies: BodiesInPairs<'a>,
    motions: &'a Bodies,
    candidates: &'a Candidates,
    known: Known<'a>,
    /// m/s².
    gravity: f64,
    /// Time moved since the last evaluation, s.
    dt: f64,
    /// Length of the last step, s.
    last_dt: f64,
}

impl Evaluation<'_> {
    /// Motion of both blocks of a pair, half a step ago.
    fn motion(&self, ends: [u32; 2]) -> [Motion; 2] {
        ends.map(|b| Motion {
            velocity: self.motions.velocity(b as usize),
            spin: self.motions.spin(b as usize),
            inverse_mass: self.known.inverse_masses[b as usize],
        })
    }

    /// Bound of the speed at which points of two blocks come nearer to each other, m/s.
    fn nearing(&self, [i, j]: [u32; 2]) -> f64 {
        let apart = self.motions.velocity(i as usize) - self.motions.velocity(j as usize);
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
        let candidate = &self.candidates.pairs[k];
        let nearing = self.nearing(pair.ends);
        slot.nearing = nearing;
        if pair.gap > 0.0 {
            pair.gap -= nearing * self.dt;
            if pair.gap > 0.0 {
                return;
            }
        }
        let constants = &self.known.constants[k];
        let bodies = pair.ends.map(|b| self.bodies.body(b));
        let radius = bodies[0].shape.radius.min(bodies[1].shape.radius);
        if constants.glued {
            let asked = Asked {
                placed: self.bodies.placed(pair.ends),
                law: &constants.law(self.known.rows),
                motion: self.motion(pair.ends),
                radius,
                inradius: constants.inradius,
                dt: self.dt,
                last_dt: self.last_dt,
                nearing,
            };
            glued::act(&asked, pair, slot, &mut workspace.glued, group);
            return;
        }
        let sums = &mut group.sums;
        let faces = candidate.faces(&self.candidates.lists);
        // The walk begins where the step before has ended, also where this instant
        // is evaluated again: its order makes the bits.
        if self.dt > 0.0 {
            pair.start = pair.next;
        }
        let place =
            |side: usize, face: u16| faces[side].binary_search(&face).ok().map(|k| k as u16);
        let hint = pair.start.and_then(|[f, g]| Some([place(0, f)?, place(1, g)?]));
        let found = workspace.walker.find(&Pair {
            bodies: [&bodies[0], &bodies[1]],
            faces,
            ties: candidate.ties,
            hint,
        });
        let surface = match found {
            Found::Touching(surface) => surface,
            Found::Apart(gap) => {
                let motion = self.motion(pair.ends);
                sums.friction += pair.memory.work(&motion, self.dt) + pair.stored;
                sums.left += left(pair);
                sums.booked += part(pair.offset.take(), &motion, &pair.memory, self.dt);
                *pair = FoundPair {
                    ends: pair.ends,
                    gap: gap - ROUNDING * gap,
                    seated: pair.seated && gap <= SEATED * constants.inradius,
                    ..FoundPair::default()
                };
                *slot = Slot { nearing, ..Slot::default() };
                return;
            }
            Found::FullyPenetrated(radius) => {
                // No force can be given: not a number stops the run, and the deepest contact is to blame.
                let mut unknown = Exerted::default();
                unknown.elastic.force = Vec3::NAN;
                *slot = Slot { at: group.push(unknown), nearing, ..Slot::default() };
                let sums = &mut group.sums;
                pair.depth = 2.0 * radius;
                let reach = constants.inradius;
                let deep = Deepest::new(pair.ends, Pressed::NoSurface, pair.depth, reach);
                sums.deepest = Deepest::deeper(sums.deepest, Some(deep));
                return;
            }
        };
        sums.unlabelled += surface.unlabelled;
        pair.next = surface.hint.map(|[f, g]| [faces[0][f as usize], faces[1][g as usize]]);
        let law = constants.law(self.known.rows);
        let handed_over = pair.offset.as_ref().is_some_and(|o| o.joint.is_some());
        let before = left(pair) + pair.stored;
        let falls = workspace.walker.falling(&law, &surface);
        let reply = respond(
            &law,
            &ContactInput {
                sums: &surface,
                pieces: &|show| workspace.walker.rubbing(show),
                origin: planes::origin(&bodies[0], &bodies[1]),
                centres: bodies.map(|b| b.position),
                motion: self.motion(pair.ends),
                radius,
                dt: self.dt,
                last_dt: self.last_dt,
                shared: None,
                falls,
            },
            &mut pair.memory,
            &mut pair.offset,
        );
        sums.friction += reply.friction;
        sums.booked += reply.booked;
        if handed_over {
            // The springs along the contact have the stiffness of its law from now on, and act at its point.
            sums.left += before - reply.sprung;
        }
        pair.stored = pair.memory.stored(law.shear_stiffness);
        pair.force = reply.wrench.force;
        pair.depth = surface.depth;
        pair.gap = 0.0;
        let reach = constants.inradius;
        let deep = Deepest::new(pair.ends, Pressed::Contact, surface.depth, reach);
        sums.deepest = Deepest::deeper(sums.deepest, Some(deep));
        let exerted = Exerted {
            elastic: reply.elastic.plus(&reply.offset),
            spring: reply.spring,
            drag: reply.drag,
        };
        *slot = Slot {
            at: group.push(exerted),
            touching: true,
            area: reply.area,
            nearing,
            negligible_impact: false,
        };
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
                if let Some(by) = exerted(groups, &slots[k], k) {
                    acting.elastic.add(&by.elastic, second);
                    acting.spring.add(&by.spring, second);
                    acting.drag.add(&by.drag, second);
                }
            }
        }
    });
}
