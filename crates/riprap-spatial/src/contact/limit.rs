//! How long a step may be for the contacts that are there, and for those that can form in it.
//!
//! A spring between two blocks holds no more energy than twice what it holds as a spring of each of them against a fixed wall. So no motion is faster than that of the stiffest block on twice its own springs: the largest eigenvalue of a matrix
//! of six rows, bounded by the norm of its fourth power (`felt`). A contact of the area A gives it the stiffness `kn A` across and `ks A` along at its place, and the
//! couples of its polar second moment J. No part of a face is stiffer than the face: where two faces can come flat onto each other, the
//! whole of the smaller one stands for them until most of it is in touch. Where nothing of that is known, the larger stiffness times
//! `A (1/m + (h² + 2 A/3)/I)` comes on top, with the distance h of the farthest face. No point is farther away than the radius of the block.
//!
//! An impact in the middle of a step, and parting in it, does wrong to the energy by a share that grows with the square of the step. So
//! faces that are about to meet flat allow, until they have parted, the smaller share of a stable step that counts with any place of the contact; where blocks lie in
//! place since a joint of theirs has let go (`seated`), that of joints, which open and close in such steps too. So it does for
//! the stiffest pairs whose impacts together are [`NEGLIGIBLE`], which would make the shortest steps: the sand between rocks that fly. With one degree of freedom and steps of half the stable one the energy after an impact is off
//! by up to 0.12 of it (one standard deviation) but by less than 0.005 in the mean over its phase, so that the errors of many impacts do not add up.
//!
//! Contacts of edges and corners grow: A is what makes the present area as safe as a share of the stable step for growing springs asks, and no
//! more than what the pair can have before the next look of the search.
//! Pairs that do not touch yet count only with what can happen in the coming step: two faces that can come flat onto each other from
//! the moment they meet, edges and corners with the area that the way of the blocks makes.
//!
//! On terrain what is near counts with its largest face flat on the ground, and what falls with a share of the time until it can touch.
//!
//! No step may let two blocks pass through each other: those of a pair come nearer by no more than their gap and a tenth of
//! the smaller inscribed radius, and no block outruns the search that finds its pairs.

use std::collections::BinaryHeap;
use std::ops::Range;

use riprap_geom::Vec3;

use crate::contact::felt::{AreaMoments, ContactStiffness};
use crate::exec::Exec;
use crate::kernel::{ContactLaw, Memory, Role, Shape};
use crate::laws::damping::stable_share;
use crate::state::bodies::{Bodies, SolidClass};
use crate::state::contact_scratch::{Constants, ContactScratch, FacePair, Impact, PairKind, Slot};
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::share::Share;
use crate::state::world::World;

/// Share of the stable step: the stiffness grows with the area.
const SAFETY: f64 = 0.2;
/// Share of the stable step for the largest area that a contact can have: that of joints, whose springs do not grow either.
pub(super) const BOUNDED: f64 = 0.5;
/// Share of the stable step on terrain. In the square not much more than half of that of pairs (0.56), since a block may lie on terrain and on
/// others at once and both limits are found apart.
const ON_GROUND: f64 = 0.15;
/// Share of the step that is stable with strong dashpots for what meets, as on terrain: flat impacts give back 0.312 and 0.091 of their speed where
/// 0.3 and 0.1 are asked for.
const DAMPED: f64 = 0.375;
/// Part of these shares by which an edge goes into another block in its first step, which may be twice as long as it is allowed when it begins:
/// with all of it that would be 0.4 of the depth to which the impact goes, and the energy of an impact is off by 2 %.
const EDGE: f64 = 0.5;
/// Faces of which less than this is in touch may come to touch anywhere.
const MOSTLY: f64 = 0.5;
/// Energy of all impacts of faces at one instant, over the largest energy that has moved in the run: at most this is negligible. The errors of n
/// impacts, each of a tenth of its energy and of either sign, are then `1e-4 sqrt(n)` of the scale by which the residual is judged.
const NEGLIGIBLE: f64 = 1e-3;
/// Share of the time until two blocks can meet that a step may take. The kick of a step spans half of the step before it too, and
/// the limit is that of the last evaluation: steps shrink with the gap, so that the first kick of a contact is a short one.
const APPROACH: f64 = 0.25;
/// Share of the smaller inscribed radius by which two blocks that touch may approach in one step.
const TRANSIT: f64 = 0.1;
/// Share of the time in which a block uses up its margin that a step may take.
const FLIGHT: f64 = 0.25;

/// Longest step, s.
/// Of several ranks each asks a part of the blocks.
pub(super) fn longest_step(
    world: &World,
    desk: &mut ContactScratch,
    exec: &Exec,
    share: Option<&Share>,
) -> f64 {
    let transit = transit(world, desk, exec);
    let limit =
        StepLimit { world, desk, speeds: Speeds::of(world), gravity: world.gravity.length() };
    let count = desk.blocks.len();
    let own = share.map_or(0..count, |share| share.equal_part(count));
    let of_blocks = |blocks: Range<usize>| {
        let mut felt = ContactStiffness::default();
        let of_block = |longest, at: usize| limit.of_block(longest, own.start + at, &mut felt);
        blocks.fold(transit, of_block)
    };
    let longest = exec.smallest(own.len(), of_blocks).min(transit);
    share.map_or(longest, |share| share.smallest(longest))
}

/// Longest step, s, and of each block the one that it allows, up to `cap` (s), to `limits`; infinite beyond.
pub(super) fn of_blocks(
    world: &World,
    desk: &ContactScratch,
    exec: &Exec,
    cap: f64,
    limits: &mut Vec<f64>,
) -> f64 {
    let limit =
        StepLimit { world, desk, speeds: Speeds::of(world), gravity: world.gravity.length() };
    limits.clear();
    limits.resize(desk.blocks.len(), cap);
    exec.chunks(limits, |first, chunk| {
        let mut felt = ContactStiffness::default();
        for (at, longest) in (first..).zip(chunk) {
            *longest = limit.of_block(cap, at, &mut felt);
        }
    });
    let longest = limits.iter().copied().fold(cap, f64::min);
    for own in limits.iter_mut().filter(|own| **own >= cap) {
        *own = f64::INFINITY;
    }
    longest.min(transit(world, desk, exec))
}

/// Longest step in which a pair comes nearer by no more than its gap and a share of its size, s.
pub(super) fn pair_transit(pair: &FoundPair, slot: &Slot, inradius: f64, gravity: f64) -> f64 {
    time_for(pair.gap.max(0.0) + TRANSIT * inradius, slot.nearing, gravity)
}

/// What the pairs of a block allow.
struct StepLimit<'a> {
    world: &'a World,
    desk: &'a ContactScratch,
    speeds: Speeds<'a>,
    /// m/s².
    gravity: f64,
}

impl<'a> StepLimit<'a> {
    /// The smaller of `longest` (s) and the longest step of a block, by its place in the list of those that are in a pair; `felt` is memory.
    fn of_block(&'a self, longest: f64, at: usize, felt: &mut ContactStiffness) -> f64 {
        let Self { world, desk, .. } = self;
        felt.clear();
        let block = desk.blocks[at] as usize;
        let mut of = OfBlock {
            limit: self,
            block,
            at,
            ease: InverseInertia::of(world, &desk.shapes, block),
            felt,
            damping: 0.0,
            longest,
            ground: [f64::INFINITY; 2],
        };
        let pairs = desk.first_pair[at] as usize..desk.first_pair[at + 1] as usize;
        for &(k, second) in &desk.incidence[pairs] {
            of.pair(k as usize, second);
        }
        of.finish()
    }
}

/// What a block allows, pair by pair.
struct OfBlock<'a, 'f> {
    limit: &'a StepLimit<'a>,
    block: usize,
    /// Its place in the list of those that are in a pair.
    at: usize,
    ease: InverseInertia,
    /// Of all that touches it.
    felt: &'f mut ContactStiffness,
    /// Largest damping ratio of what touches it.
    damping: f64,
    /// Longest step so far, s.
    longest: f64,
    /// How far terrain is away at least, m, and the step that is stable on it, s.
    ground: [f64; 2],
}

/// A pair, as one of its blocks feels it.
struct Side<'a> {
    /// Whether the block is the second.
    second: bool,
    pair: &'a FoundPair,
    slot: &'a Slot,
    constants: &'a Constants,
    law: ContactLaw,
    /// Faces that can come flat onto each other.
    flat: Option<&'a FacePair>,
    /// Twice the larger stiffness, Pa/m.
    stiffness: f64,
    /// Normal stiffness over that of a contact without depth.
    grown: f64,
    /// What dashpots leave of the undamped stable step.
    loss: f64,
    negligible_impact: bool,
    /// Share of the stable step while it grows.
    share: f64,
    /// Step until it meets or parts, s.
    change: f64,
    /// Largest area that it can have, m².
    most: f64,
}

impl Side<'_> {
    /// Area that stands for a present one, in the root: from the bound of all that touches to the step of what grows.
    fn growth(&self) -> f64 {
        let growth = BOUNDED * self.loss / meeting(self.share, self.loss);
        growth * growth
    }

    /// Where the springs of a patch are, which count with this area (m²).
    fn spread(&self, patch: &ContactPatch, area: f64) -> AreaMoments {
        let memory = &patch.memory;
        AreaMoments {
            normal: memory.normal,
            arm: memory.arms[usize::from(self.second)],
            area,
            polar: memory.polar / memory.area,
            held: held(&self.law, memory, patch.area),
        }
    }
}

impl<'a> OfBlock<'a, '_> {
    fn pair(&mut self, k: usize, second: bool) {
        let StepLimit { world, desk, gravity, .. } = self.limit;
        let (pair, slot, constants) = (&world.found.pairs[k], &desk.slots[k], &desk.constants[k]);
        // As stiff as it can be at the end of a step like the last one.
        let coming = pair.depth + slot.nearing * world.last_dt;
        let law = constants.law(&desk.rows).at_depth(coming);
        let most = match constants.kind {
            PairKind::Terrain(_) => {
                let [near, stable] = self.ground;
                self.ground = [near.min(pair.gap), stable.min(self.on_ground(&law))];
                return;
            }
            PairKind::Convex => desk.candidates.pairs[k].area,
            PairKind::Glued => {
                let of = |b: u32| desk.glued[world.solid[b as usize] as usize].half_surface;
                of(pair.ends[0]).min(of(pair.ends[1]))
            }
        };
        let change = until_change(pair, slot, *gravity);
        if !slot.touching && change >= self.longest {
            // Most of what is near: whatever it allows is longer than this.
            return;
        }
        let negligible_impact = desk.all_negligible || slot.negligible_impact;
        let side = Side {
            second,
            pair,
            slot,
            constants,
            law,
            flat: constants.facing(&desk.facings),
            stiffness: 2.0 * law.normal_stiffness.max(law.shear_stiffness),
            grown: law.tangent(coming),
            loss: stable_share(law.damping_ratio),
            negligible_impact,
            share: if negligible_impact { BOUNDED } else { SAFETY },
            change,
            most,
        };
        self.faces(&side);
        if slot.touching {
            self.touching(&side);
        } else {
            self.edge(&side);
        }
    }

    fn allow(&mut self, step: f64) {
        self.longest = self.longest.min(step);
    }

    /// Faces that can come flat onto each other, from the moment they meet.
    fn faces(&mut self, side: &Side) {
        let as_joint = side.pair.seated || side.negligible_impact;
        let alone = side.flat.map_or(f64::INFINITY, |flat| {
            if as_joint {
                BOUNDED * 2.0 * side.loss / (side.grown * flat.square).sqrt()
            } else {
                let square = side.stiffness * flat.area * self.ease.of_area(flat.area);
                meeting(SAFETY, side.loss) * 2.0 / square.sqrt()
            }
        });
        let at_once = side.slot.touching && !as_joint;
        self.allow(if at_once { alone } else { side.change.max(alone) });
    }

    /// What touches: patch by patch where places are known.
    fn touching(&mut self, side: &Side<'a>) {
        self.damping = self.damping.max(side.law.damping_ratio);
        let Side { pair, slot, flat, law, most, .. } = side;
        let known = pair.leading().filter(|patch| patch.memory.area > 0.0);
        if let (Some(patch), None) = (known, flat) {
            self.growing(side, &patch.memory);
        }
        let glued = side.constants.kind == PairKind::Glued;
        if let (Some(_), true) = (known, glued) {
            // Each piece has a place of its own.
            let face = flat.map_or(0.0, |flat| flat.face);
            for patch in pair.patches.iter().filter(|p| p.memory.area > 0.0) {
                let area = (side.growth() * patch.area).min(*most).max(face);
                self.felt.add(&self.ease, law, &side.spread(patch, area));
            }
            return;
        }
        let mostly = flat.is_none_or(|flat| slot.area >= MOSTLY * flat.area);
        if let Some(patch) = known.filter(|_| side.negligible_impact || mostly) {
            let area = if side.negligible_impact {
                slot.area
            } else {
                let grown = side.growth() * slot.area;
                grown.min(*most).max(flat.map_or(slot.area, |f| f.area))
            };
            self.felt.add(&self.ease, law, &side.spread(patch, area));
        } else if let Some(flat) = flat {
            let desk = self.limit.desk;
            let of = desk.place[pair.ends[flat.side] as usize] as usize;
            let placed = |side: usize, at: usize| {
                let periods = &self.limit.world.setup.periodic;
                pair.key().place(side, desk.poses[at].position, periods)
            };
            let arm = placed(flat.side, of) - placed(usize::from(side.second), self.at);
            self.felt.add(&self.ease, law, &flat.spread(desk.turns[of], arm));
        } else {
            self.felt.anywhere += side.stiffness * slot.area * self.ease.of_area(slot.area);
        }
    }

    /// Edges and corners that touch, and grow.
    fn growing(&mut self, side: &Side, memory: &Memory) {
        let Side { slot, stiffness, loss, most, law, .. } = side;
        let square = |area: f64| stiffness * area * self.ease.of_area(area);
        let small = meeting(side.share, *loss) * step_of(square(slot.area));
        let whole = BOUNDED * loss * step_of(square(*most));
        let closing = self.limit.speeds.closing(side.pair.ends, memory);
        let held = 2.0 * held(law, memory, slot.area) * law.shear_stiffness;
        let held = BOUNDED * loss * step_of(held * self.ease.of_area(slot.area));
        self.allow(whole.max(growing(small, closing, side.pair.depth)).min(held));
    }

    /// Edges and corners that may come to touch.
    fn edge(&mut self, side: &Side) {
        let Constants { largest, .. } = side.constants;
        let edge = side.stiffness * largest.sqrt() * self.ease.of_area(*largest);
        let allowed = 2.0 * EDGE * meeting(side.share, side.loss);
        let nearing = side.slot.nearing;
        self.allow(side.change + of_edge(allowed, edge, nearing, self.limit.gravity));
    }

    /// Longest stable step on ground with this law, s.
    fn on_ground(&self, law: &ContactLaw) -> f64 {
        let StepLimit { world, desk, .. } = self.limit;
        let pairs = desk.first_pair[self.at] as usize..desk.first_pair[self.at + 1] as usize;
        let on = desk.incidence[pairs].iter().map(|(k, _)| *k as usize);
        let on = on.filter(|k| matches!(desk.constants[*k].kind, PairKind::Terrain(_)));
        let touching = on.flat_map(|k| &world.found.pairs[k].patches).map(|patch| patch.area).sum();
        let class = world.solid[self.block] as usize;
        let area = desk.shapes[class].areas.iter().copied().fold(touching, f64::max);
        // Faces in a hollow are no faces of the hull.
        let area = desk.glued.get(class).map_or(area, |glued| area.max(glued.largest));
        let stiffness = 2.0 * law.normal_stiffness.max(law.shear_stiffness);
        share_on_ground(law) * 2.0 / (stiffness * area * self.ease.of_area(area)).sqrt()
    }

    /// The longest step with all pairs, s.
    fn finish(self) -> f64 {
        let StepLimit { world, desk, speeds, gravity } = self.limit;
        let mut longest = self.longest;
        let allowed = BOUNDED * 2.0 * stable_share(self.damping);
        // Most blocks allow more than something else does, and a rough bound shows it.
        if allowed < longest * self.felt.rough_bound().sqrt() {
            let square = self.felt.bound(&self.ease);
            if square > 0.0 {
                longest = longest.min(allowed / square.sqrt());
            }
        }
        // What cannot touch the ground yet may go a share of the way there, however stiff it is.
        let [near, stable] = self.ground;
        let radius = desk.shapes[world.solid[self.block] as usize].radius;
        let (bodies, b) = (speeds.bodies, self.block);
        let nearing = bodies.velocity(b).length() + bodies.spin(b).length() * radius;
        let meet = if near > 0.0 { APPROACH * time_for(near, nearing, *gravity) } else { 0.0 };
        longest.min(stable.max(meet))
    }
}

/// Area that the springs along a contact stand for where it is stiffer along than across, m²; 0 elsewhere.
fn held(law: &ContactLaw, memory: &Memory, area: f64) -> f64 {
    let across = law.normal_stiffness.max(law.shear_stiffness) * area;
    if law.shear_stiffness * memory.area > across { memory.area } else { 0.0 }
}

/// A share of the undamped stable step that keeps the energy of what meets. Dashpots take energy and make none, so they shorten it only where the
/// step would come too near to what is stable with them, `loss` of the undamped one.
fn meeting(share: f64, loss: f64) -> f64 {
    share.min(DAMPED.max(share) * loss)
}

/// Share of the undamped stable step on ground with this law: dashpots shorten it where it would come too near to what is stable with them.
pub(crate) fn share_on_ground(law: &ContactLaw) -> f64 {
    ON_GROUND.min(DAMPED * stable_share(law.damping_ratio))
}

/// Step that the edge of a block may go into another one, s: `dt² K = allowed²`, where the squared frequency K is `edge` (1/(m s²)) times the
/// way, that of the speed `v` (m/s) and of the acceleration `g` (m/s²) from rest: less than either allows alone by as much as the other adds.
fn of_edge(allowed: f64, edge: f64, v: f64, g: f64) -> f64 {
    let square = allowed * allowed;
    let by_speed = libm::cbrt(edge * v / square);
    let by_fall = (0.5 * edge * g / square).sqrt().sqrt();
    1.0 / (by_speed + by_fall)
}

/// Step that a pair may make before it meets or parts, s.
fn until_change(pair: &FoundPair, slot: &Slot, gravity: f64) -> f64 {
    let way = if slot.touching { pair.depth } else { pair.gap.max(0.0) };
    APPROACH * time_for(way, slot.nearing, gravity)
}

/// Says of each pair whether its impact is negligible: the stiffest ones, whose steps would be the shortest, as long as all of them together
/// are. Their energy is that of the approach, by its bound, and of the pressure; pairs that cannot meet in a step that is as long as joints
/// allow have none, and those that lie in place are left out. `energy`: that of all impacts, J.
pub(super) fn find_negligible_impacts(world: &World, desk: &mut ContactScratch, energy: f64) {
    let most = NEGLIGIBLE * world.works.peak;
    desk.all_negligible = energy <= most;
    if desk.all_negligible {
        return;
    }
    let mut impacts = std::mem::take(&mut desk.impacts);
    impacts.clear();
    impacts.extend(desk.groups.iter().flat_map(|group| &group.impacts));
    // Few of many are negligible: a heap gives the stiffest ones without sorting all.
    let mut impacts = BinaryHeap::from(impacts);
    let mut so_far = 0.0;
    while let Some(impact) = impacts.pop() {
        so_far += impact.energy;
        if so_far > most {
            break;
        }
        desk.slots[impact.pair as usize].negligible_impact = true;
    }
    desk.impacts = impacts.into_vec();
}

/// What is the same in all steps for all pairs, as in [`ContactScratch`].
pub(super) struct Known<'a> {
    pub(super) constants: &'a [Constants],
    pub(super) rows: &'a [ContactLaw],
    pub(super) facings: &'a [FacePair],
    pub(super) inverse_masses: &'a [f64],
}

impl Known<'_> {
    /// The impact of pair `k`: `None` where it lies in place or cannot meet in a step that is as long as joints allow.
    pub(super) fn impact(
        &self,
        k: usize,
        pair: &FoundPair,
        slot: &Slot,
        gravity: f64,
    ) -> Option<Impact> {
        let constants = &self.constants[k];
        if pair.seated || matches!(constants.kind, PairKind::Terrain(_)) {
            return None;
        }
        let law = constants.law(self.rows);
        let (grown, more) = (law.tangent(pair.depth), law.more_energy(pair.depth));
        let kn = grown * law.normal_stiffness;
        let [i, j] = pair.ends.map(|b| self.inverse_masses[b as usize]);
        let ease = i + j;
        let flat = constants.facing(self.facings);
        let edge = 2.0 * kn * constants.largest.sqrt() * ease;
        let square = flat.map_or(edge * constants.largest.sqrt(), |flat| grown * flat.square);
        let mut energy = 0.5 * slot.nearing * slot.nearing / ease;
        if slot.touching {
            energy += 0.5 * law.normal_stiffness * slot.area * pair.depth * pair.depth * more;
        } else {
            // An edge that is about to come down is let into the other block for longer than a face is.
            let longest = BOUNDED * 2.0 / square.sqrt();
            let longest = match flat {
                Some(_) => longest,
                None => longest.max(of_edge(2.0 * BOUNDED, edge, slot.nearing, gravity)),
            };
            if until_change(pair, slot, gravity) > longest {
                return None;
            }
        }
        Some(Impact { square, energy, pair: k as u32 })
    }
}

/// How fast rigid blocks move.
pub(super) struct Speeds<'a> {
    pub(super) bodies: &'a Bodies,
    /// Index into `solids`, per block.
    pub(super) solid: &'a [u32],
    pub(super) solids: &'a [SolidClass],
}

impl<'a> Speeds<'a> {
    pub(super) fn of(world: &'a World) -> Self {
        Self { bodies: &world.bodies, solid: &world.solid, solids: &world.solids }
    }

    /// Speed at which two blocks come nearer to each other across their contact, m/s; 0 where they part.
    fn closing(&self, ends: [u32; 2], memory: &Memory) -> f64 {
        self.across(ends, memory).max(0.0)
    }

    /// The same, below 0 where they part.
    pub(super) fn across(&self, ends: [u32; 2], memory: &Memory) -> f64 {
        let [a, b] = [0, 1].map(|side| {
            let of = ends[side] as usize;
            self.bodies.velocity(of) + self.bodies.spin(of).cross(memory.arms[side])
        });
        (a - b).dot(memory.normal)
    }

    /// Bound of the speed of the points of a block against its centroid, m/s.
    pub(super) fn turning(&self, b: usize) -> f64 {
        self.bodies.spin(b).length() * self.solids[self.solid[b] as usize].radius
    }
}

/// Longest stable step of a squared frequency (1/s²), s.
pub(super) fn step_of(square: f64) -> f64 {
    2.0 / square.sqrt()
}

/// Longest step of a contact whose stiffness grows with the square of its depth (m), that allows `small` (s) as it is, while its
/// sides close at `speed` (m/s): `dt (1 + speed dt/depth) = small` in the form without cancellation, s.
fn growing(small: f64, speed: f64, depth: f64) -> f64 {
    2.0 * small / (1.0 + (1.0 + 4.0 * small * speed / depth).sqrt())
}

/// Time that a way (m) takes from the speed `v` (m/s) on under the acceleration `g` (m/s²): `v t + g t²/2 = way` in the form without
/// cancellation, s.
fn time_for(way: f64, v: f64, g: f64) -> f64 {
    if way > 0.0 { 2.0 * way / (v + (v * v + 2.0 * g * way).sqrt()) } else { 0.0 }
}

/// Longest step in which no pair can pass through each other, s.
fn transit(world: &World, desk: &ContactScratch, exec: &Exec) -> f64 {
    let g = world.gravity.length();
    // On terrain no block can pass through: it stops the run when it lies below the surface.
    exec.smallest(desk.candidates.pairs.len(), |pairs| {
        let times = pairs.map(|k| {
            pair_transit(&world.found.pairs[k], &desk.slots[k], desk.constants[k].inradius, g)
        });
        times.fold(f64::INFINITY, f64::min)
    })
}

/// Longest step in which no block uses up more than a share of its margin: whom it can run into is known before, s.
///
/// A quarter of the time, because what the ledger takes for the kinetic energy of a falling block, `m v(n-1/2).v(n+1/2)/2`, is less than its own by
/// `m g² dt²/8`: where steps grow short before a contact that comes to light as a residual.
pub(super) fn reach(world: &World, exec: &Exec, blocks: Range<usize>) -> f64 {
    let g = world.gravity.length();
    let (roles, margins) = (&world.found.roles, &world.found.search.margin);
    let time = |b: usize| FLIGHT * time_for(margins[b], speed(world, b), g);
    let start = blocks.start;
    exec.smallest(blocks.len(), |chunk| {
        let blocks = chunk.map(|k| start + k).filter(|b| roles[*b] != Role::Absent);
        blocks.map(time).fold(f64::INFINITY, f64::min)
    })
}

/// How easily forces move and turn a block.
pub(crate) struct InverseInertia {
    /// 1/kg.
    pub(super) mass: f64,
    /// 1/(kg m²).
    pub(super) inertia: f64,
    /// Square of the distance of its farthest face, m².
    pub(super) height: f64,
    /// Square of its radius, m².
    pub(super) reach: f64,
}

impl InverseInertia {
    pub(crate) fn of(world: &World, shapes: &[Shape], b: usize) -> Self {
        let [free, turns] = world.freedoms(b);
        let solid = world.solid_of(b);
        let diagonal =
            Vec3::new(solid.inverse.x_axis.x, solid.inverse.y_axis.y, solid.inverse.z_axis.z);
        let offsets = &shapes[world.solid[b] as usize].offsets;
        let height = offsets.iter().copied().fold(0.0, f64::max);
        Self {
            mass: free.max_element() / solid.mass,
            inertia: turns.max_element() * diagonal.max_element(),
            height: height * height,
            reach: solid.radius * solid.radius,
        }
    }

    /// `1/m + (h² + 2 A/3)/I`.
    pub(crate) fn of_area(&self, area: f64) -> f64 {
        self.mass + (self.height + 2.0 * area / 3.0).min(self.reach) * self.inertia
    }
}

/// Bound of the speed of the points of a block, m/s.
fn speed(world: &World, b: usize) -> f64 {
    world.bodies.velocity(b).length() + Speeds::of(world).turning(b)
}
