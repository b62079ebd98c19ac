//! All found contacts of a model in one evaluation: who is near, who touches, what acts on each block.
//!
//! [`Contacts`] is state. [`Room`] can be dropped at any time: it is made again from the state and the present poses.
//! Every pair writes its answer to its own slot; each block adds its slots in the order of the pairs. So the result is the
//! same bits for any number of threads.
//!
//! **Energy.** The pressure has a potential. What it stores is counted along the path, `- sum (W_old + W_new)/2 . dx` of
//! the wrench of each contact, which is what the leapfrog does to the kinetic energy to the last bit but round-off; a contact
//! that has ended stores nothing, and what the count has left then is the error of the time step.

use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use super::friction::{ContactLaw, Memory, Motion, Question, Reply, Wrench, respond};
use super::limits::{self, Depth};
use super::search::{Blocks, Candidates, Search, moved};
use super::shape::{Body, Pose};
use super::surface::{Found, Pair, Walker};
use crate::exec::{CHUNK, Exec};

/// State of a pair of blocks that can touch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// First block; the smaller number.
    pub i: u32,
    /// Second block.
    pub j: u32,
    /// Faces of both that carried most when last evaluated; `None` if they did not touch.
    pub hint: Option<[u16; 2]>,
    /// Springs along the contact.
    pub memory: Memory,
    /// What the pressure did when last evaluated, N and N m.
    pub elastic: Wrench,
    /// Energy of the pressure, along the path, J.
    pub stored: f64,
}

/// State of all found contacts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Contacts {
    /// What the candidate list is made of.
    pub search: Search,
    /// One entry per candidate, sorted by pair.
    pub list: Vec<Contact>,
}

impl Contacts {
    /// Energy of the pressure of all contacts and of the springs along them, J. `law(i, j)` is the law between two blocks.
    #[must_use]
    pub fn stored(&self, law: impl Fn(u32, u32) -> ContactLaw) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for contact in self.list.iter().filter(|c| c.hint.is_some()) {
            sums[0] += contact.stored;
            sums[1] += contact.memory.stored(&law(contact.i, contact.j));
        }
        sums
    }
}

/// Where a block stands and how it moves (half a step ago).
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// Pose.
    pub pose: Pose,
    /// Motion.
    pub motion: Motion,
}

/// What was found of a pair in the last evaluation.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// Forces, and the place where they act.
    pub reply: Reply,
    /// How far the blocks lie in each other, m; 0 apart.
    pub depth: f64,
    /// While the way of both blocks is not above this, they cannot touch, m.
    until: f64,
}

impl Default for Slot {
    fn default() -> Self {
        Self {
            reply: Reply::default(),
            depth: 0.0,
            until: f64::NEG_INFINITY,
        }
    }
}

/// Force (N) and moment (N m) of found contacts on a block: pressure and springs, then dashpots.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OnBlock {
    /// Force of pressure and springs.
    pub force: Vec3,
    /// Their moment about the centroid.
    pub moment: Vec3,
    /// Force of dashpots.
    pub drag: Vec3,
    /// Their moment about the centroid.
    pub drag_moment: Vec3,
}

/// Why a run with found contacts cannot go on.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Trouble {
    /// More than the smaller inradius.
    #[error(
        "blocks {} and {} lie {depth:.3e} m in each other, and the largest ball in the thinner one has a radius of {inradius:.3e} m",
        .pair[0], .pair[1]
    )]
    TooDeep {
        /// The blocks.
        pair: [u32; 2],
        /// Depth, m.
        depth: f64,
        /// The smaller inradius, m.
        inradius: f64,
    },
    /// More than a tenth of the smaller inradius in one step.
    #[error(
        "blocks {} and {} have moved against each other by {way:.3e} m in one step, and the largest ball in the thinner one has \
         a radius of {inradius:.3e} m: they could pass through each other; give a shorter `time_step`",
        .pair[0], .pair[1]
    )]
    TooFast {
        /// The blocks.
        pair: [u32; 2],
        /// Way, m.
        way: f64,
        /// The smaller inradius, m.
        inradius: f64,
    },
    /// Faces are missing in the list of a pair: our fault.
    #[error("the surface of contact of blocks {} and {} is not closed", .pair[0], .pair[1])]
    Open {
        /// The blocks.
        pair: [u32; 2],
    },
}

/// What an evaluation has found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Heat of friction since the last evaluation, J.
    pub friction: f64,
    /// Whether the candidate list was made anew.
    pub renewed: bool,
    /// Pairs that touch.
    pub touching: u32,
    /// Largest depth over the smaller inradius.
    pub deepest: f64,
    /// First trouble in the order of the pairs.
    pub trouble: Option<Trouble>,
}

/// Workspace.
#[derive(Debug, Default)]
pub struct Room {
    /// Pairs that can touch.
    pub candidates: Candidates,
    /// What was found of each.
    pub slots: Vec<Slot>,
    /// Where the blocks stand.
    pub standing: Vec<Standing>,
    /// Turned normals of all blocks, and where those of each block start.
    normals: Vec<Vec3>,
    first: Vec<u32>,
    /// Pairs of each block: 2 k for the first block of pair k, 2 k + 1 for the second.
    incident: Vec<u32>,
    start: Vec<u32>,
    partials: Vec<Partial>,
    none: Vec<()>,
    /// Whether `candidates` belong to the state.
    ready: bool,
}

#[derive(Debug, Default)]
struct Partial {
    walker: Walker,
    outcome: Outcome,
}

/// What an evaluation is about.
pub struct Scene<'a, B, L, X> {
    /// The blocks.
    pub blocks: Blocks<'a>,
    /// Where block b stands and how it moves.
    pub standing: B,
    /// Law between blocks i and j.
    pub law: L,
    /// Whether the pair i, j is looked after by another part of the engine.
    pub excluded: X,
    /// Time since the last evaluation, s; 0 when nothing has moved.
    pub elapsed: f64,
    /// Coming step, s.
    pub coming: f64,
    /// Time over which fast blocks shall not force the search to look anew, s.
    pub lookahead: f64,
    /// Threads.
    pub exec: &'a Exec,
}

impl Room {
    /// Drops what was found, so that it is made again from the state: after edits, or when joints have let go.
    pub fn forget(&mut self) {
        self.ready = false;
    }

    /// Forces of all found contacts at the present poses.
    ///
    /// Calling it again without moving (`elapsed` 0) changes nothing.
    pub fn evaluate<B, L, X>(&mut self, state: &mut Contacts, scene: &Scene<B, L, X>) -> Outcome
    where
        B: Fn(usize) -> Standing + Sync,
        L: Fn(u32, u32) -> ContactLaw + Sync,
        X: Fn(u32, u32) -> bool + Sync,
    {
        self.stand(scene);
        let mut outcome = self.refresh(state, scene);
        self.turn(&scene.blocks, scene.exec);
        let pairs = &self.candidates.pairs;
        let context = Context {
            candidates: &self.candidates,
            blocks: &scene.blocks,
            standing: &self.standing,
            normals: &self.normals,
            first: &self.first,
            elapsed: scene.elapsed,
        };
        let chunks = pairs.len().div_ceil(CHUNK);
        if self.partials.len() < chunks {
            self.partials.resize_with(chunks, Partial::default);
        }
        let partials = &mut self.partials[..chunks];
        scene.exec.chunks2(
            &mut state.list,
            &mut self.slots,
            partials,
            |first, contacts, slots, partial| {
                partial.outcome = Outcome::default();
                for (at, (contact, slot)) in contacts.iter_mut().zip(slots).enumerate() {
                    let law = || (scene.law)(contact.i, contact.j);
                    context.pair(first + at, law(), contact, slot, partial);
                }
            },
        );
        for partial in partials {
            outcome.friction += partial.outcome.friction;
            outcome.touching += partial.outcome.touching;
            outcome.deepest = outcome.deepest.max(partial.outcome.deepest);
            outcome.trouble = outcome.trouble.or(partial.outcome.trouble);
        }
        outcome
    }

    /// What acts on block `b`.
    #[must_use]
    pub fn on_block(&self, b: usize) -> OnBlock {
        let mut sum = OnBlock::default();
        for &at in &self.incident[self.start[b] as usize..self.start[b + 1] as usize] {
            let reply = &self.slots[at as usize / 2].reply;
            let (all, drag) = (&reply.wrench, &reply.dashpots);
            if at % 2 == 0 {
                sum.force -= all.force - drag.force;
                sum.moment += all.moment_a - drag.moment_a;
                sum.drag -= drag.force;
                sum.drag_moment += drag.moment_a;
            } else {
                sum.force += all.force - drag.force;
                sum.moment += all.moment_b - drag.moment_b;
                sum.drag += drag.force;
                sum.drag_moment += drag.moment_b;
            }
        }
        sum
    }

    /// Takes over the present poses and counts the ways.
    fn stand<B, L, X>(&mut self, scene: &Scene<B, L, X>)
    where
        B: Fn(usize) -> Standing + Sync,
        L: Sync,
        X: Sync,
    {
        let count = scene.blocks.roles.len();
        let ways = &mut self.candidates.travelled;
        if self.standing.len() == count && ways.len() == count {
            let partials = &mut self.none;
            partials.resize(count.div_ceil(CHUNK), ());
            scene.exec.chunks2(
                &mut self.standing,
                ways,
                partials,
                |first, standing, ways, ()| {
                    for (b, (old, way)) in (first..).zip(standing.iter_mut().zip(ways)) {
                        let new = (scene.standing)(b);
                        *way += moved(&old.pose, &new.pose, scene.blocks.shape(b).radius);
                        *old = new;
                    }
                },
            );
        } else {
            self.standing.clear();
            self.standing.extend((0..count).map(&scene.standing));
            self.ready = false;
        }
    }

    /// Makes the candidate list where there is none or where a block leaves its margin.
    fn refresh<B, L, X>(&mut self, state: &mut Contacts, scene: &Scene<B, L, X>) -> Outcome
    where
        B: Fn(usize) -> Standing + Sync,
        L: Fn(u32, u32) -> ContactLaw + Sync,
        X: Fn(u32, u32) -> bool + Sync,
    {
        let (blocks, standing) = (&scene.blocks, &self.standing);
        let speed = |b: usize| {
            let motion = &standing[b].motion;
            motion.velocity.length() + motion.spin.length() * blocks.shape(b).radius
        };
        let outdated = self.candidates.outdated(
            blocks,
            &state.search,
            |b| standing[b].pose,
            |b| speed(b) * scene.coming,
            scene.exec,
        );
        if !outdated && self.ready {
            return Outcome::default();
        }
        if outdated {
            state.search.renew(
                blocks,
                |b| standing[b].pose,
                speed,
                [scene.lookahead, scene.coming],
            );
        }
        self.candidates
            .rebuild(blocks, &state.search, &scene.excluded, scene.exec);
        let mut friction = 0.0;
        let old = std::mem::take(&mut state.list);
        state.list = self.candidates.carry(
            old.into_iter().map(|c| ([c.i, c.j], c)),
            |pair| Contact {
                i: pair.i,
                j: pair.j,
                ..Contact::default()
            },
            |[i, j], contact| friction += contact.memory.stored(&(scene.law)(i, j)),
        );
        self.slots.clear();
        self.slots.resize(state.list.len(), Slot::default());
        self.find_incident(blocks.roles.len());
        self.ready = true;
        Outcome {
            friction,
            renewed: outdated,
            ..Outcome::default()
        }
    }

    /// Lists the pairs of each block.
    fn find_incident(&mut self, count: usize) {
        self.start.clear();
        self.start.resize(count + 1, 0);
        let pairs = &self.candidates.pairs;
        for pair in pairs {
            self.start[pair.i as usize + 1] += 1;
            self.start[pair.j as usize + 1] += 1;
        }
        for b in 0..count {
            self.start[b + 1] += self.start[b];
        }
        self.incident.clear();
        self.incident.resize(2 * pairs.len(), 0);
        let mut next = self.start.clone();
        for (k, pair) in pairs.iter().enumerate() {
            for (side, b) in [pair.i, pair.j].into_iter().enumerate() {
                let at = &mut next[b as usize];
                self.incident[*at as usize] = (2 * k + side) as u32;
                *at += 1;
            }
        }
    }

    /// Turns the normals of all blocks.
    fn turn(&mut self, blocks: &Blocks, exec: &Exec) {
        let count = blocks.roles.len();
        if self.first.len() != count + 1 || !self.ready {
            self.first.clear();
            self.first.push(0);
            for b in 0..count {
                let faces = blocks.shape(b).faces() as u32;
                self.first.push(self.first[b] + faces);
            }
            self.normals.resize(self.first[count] as usize, Vec3::ZERO);
        }
        self.none.resize(count.div_ceil(CHUNK), ());
        exec.ragged(
            &mut self.standing,
            &mut self.normals,
            &self.first,
            &mut self.none,
            |first, standing, normals, ()| {
                let mut rest = normals;
                for (b, standing) in (first..).zip(standing) {
                    let shape = blocks.shape(b);
                    let (own, others) = rest.split_at_mut(shape.faces());
                    rest = others;
                    let turn = Mat3::from_quat(standing.pose.rotation);
                    for (to, n) in own.iter_mut().zip(&shape.normals) {
                        *to = turn * *n;
                    }
                }
            },
        );
    }
}

/// What the evaluation of a pair reads.
struct Context<'a> {
    candidates: &'a Candidates,
    blocks: &'a Blocks<'a>,
    standing: &'a [Standing],
    normals: &'a [Vec3],
    first: &'a [u32],
    elapsed: f64,
}

impl<'a> Context<'a> {
    fn body(&self, b: u32) -> Body<'a> {
        let b = b as usize;
        let pose = &self.standing[b].pose;
        Body {
            shape: self.blocks.shape(b),
            normals: &self.normals[self.first[b] as usize..self.first[b + 1] as usize],
            turn: Mat3::from_quat(pose.rotation),
            position: pose.position,
        }
    }

    fn pair(
        &self,
        k: usize,
        law: ContactLaw,
        contact: &mut Contact,
        slot: &mut Slot,
        partial: &mut Partial,
    ) {
        let pair = &self.candidates.pairs[k];
        if self.candidates.way(pair) <= slot.until {
            return;
        }
        let (a, b) = (self.body(pair.i), self.body(pair.j));
        let faces = pair.faces(&self.candidates.lists);
        let place = |side: usize, face: u16| faces[side].binary_search(&face).ok();
        let hint = contact
            .hint
            .and_then(|[f, g]| Some([place(0, f)? as u16, place(1, g)? as u16]));
        let found = partial.walker.find(&Pair {
            bodies: [&a, &b],
            faces,
            ties: pair.ties,
            hint,
        });
        let ends = [pair.i, pair.j];
        let motion = ends.map(|b| self.standing[b as usize].motion);
        let inradius = a.shape.inradius.min(b.shape.inradius);
        let outcome = &mut partial.outcome;
        let turning =
            motion[0].spin.length() * a.shape.radius + motion[1].spin.length() * b.shape.radius;
        let way = self.elapsed * ((motion[1].velocity - motion[0].velocity).length() + turning);
        if limits::passes_through(way, inradius) {
            outcome.trouble = outcome.trouble.or(Some(Trouble::TooFast {
                pair: ends,
                way,
                inradius,
            }));
        }
        let sums = match found {
            Found::Apart(gap) => {
                outcome.friction += contact.memory.stored(&law);
                *contact = Contact {
                    i: contact.i,
                    j: contact.j,
                    ..Contact::default()
                };
                *slot = Slot {
                    until: self.candidates.sleep(pair, gap),
                    ..Slot::default()
                };
                return;
            }
            Found::Touching(sums) => sums,
            Found::Swallowed(depth) => {
                outcome.trouble = outcome.trouble.or(Some(Trouble::TooDeep {
                    pair: ends,
                    depth: 2.0 * depth,
                    inradius,
                }));
                return;
            }
        };
        let question = Question {
            sums: &sums,
            largest: (&partial.walker.largest, &partial.walker.largest_frame),
            origin: super::planes::origin(&a, &b),
            centres: [a.position, b.position],
            motion,
            radius: a.shape.radius.min(b.shape.radius),
            dt: self.elapsed,
        };
        let reply = respond(&law, &question, &mut contact.memory);
        let mean = reply.elastic.plus(&contact.elastic);
        contact.stored -= 0.5 * self.elapsed * mean.power(&motion);
        contact.elastic = reply.elastic;
        contact.hint = sums
            .hint
            .map(|[f, g]| [faces[0][f as usize], faces[1][g as usize]]);
        *slot = Slot {
            reply,
            depth: sums.depth,
            until: f64::NEG_INFINITY,
        };
        outcome.friction += reply.friction;
        outcome.touching += 1;
        outcome.deepest = outcome.deepest.max(sums.depth / inradius);
        let trouble = if sums.unlabelled > 0 {
            Some(Trouble::Open { pair: ends })
        } else {
            match limits::judge(sums.depth, inradius) {
                Depth::Fine | Depth::Deep => None,
                Depth::TooDeep => Some(Trouble::TooDeep {
                    pair: ends,
                    depth: sums.depth,
                    inradius,
                }),
            }
        };
        outcome.trouble = outcome.trouble.or(trouble);
    }
}

#[cfg(test)]
mod tests;
