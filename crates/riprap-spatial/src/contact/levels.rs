//! Steps by level: pairs of slow blocks are evaluated once in several steps.
//!
//! All blocks move at each step. A pair that touches is evaluated at every 2^k-th step, as long as both of its blocks allow a step of that length, and acts by impulses: each
//! evaluation gives the force for half of the time since the last one and half of the time until the next one,
//!
//! ```text
//!   step      0   1   2   3   4   5   6   7   8
//!   k = 0     F   F   F   F   F   F   F   F   F        weight 1
//!   k = 1     2F      2F      2F      2F      2F
//!   k = 2     4F              4F              4F       impulse on B: 4 dt F, on A: -4 dt F
//! ```
//!
//! the impulse method (Verlet-I, r-RESPA), which is a composition of kicks and drifts and so symplectic and, for steps of one length, reversible. Both blocks get opposite impulses at one
//! point: momentum and angular momentum are exact. Pairs of one k share their instants (multiples of 2^k), so that every 2^K-th step is common to all.
//!
//! What has been given in advance is remembered ([`Clock`]): where steps change their length, or a pair is evaluated before its time, the next evaluation gives what is missing,
//! so that the impulse of a constant force is exact whatever happens.
//!
//! The method is unstable where a kick comes at half a period of a motion (or a multiple) that it moves. A pair is evaluated at least as often as each of its blocks asks for with all
//! its springs, of contacts and joints, and these steps are half of the stable ones, a sixth of the shortest period of its own
//! motion. What a block takes part in of the faster motion of its neighbours is small as their mass beside its own.
//!
//! A pair that parts is evaluated after half of the time until it has, and so on: no impulse that it is given in advance goes far beyond the parting.
//!
//! Energies: memory, friction and path energy go by the way since the last evaluation. The kick books the work of impulses on velocities: the difference of both is the error of
//! the method, in the energy of the pressure here, so that it comes to light as a residual.
//!
//! Sources: Grubmueller, Heller, Windemuth & Schulten (1991), Mol. Simul. 6, 121-142; Tuckerman, Berne & Martyna (1992), J. Chem. Phys. 97, 1990-2001, section III; Biesiadecki & Skeel
//! (1993), J. Comput. Phys. 109, 318-328 (instability at half a period).

use crate::contact::felt::{AreaMoments, ContactStiffness};
use crate::contact::limit;
use crate::contact::limit::{InverseInertia, Speeds};
use crate::kernel::{ContactLaw, Motion, Pose, Shape};
use crate::setup::rotation::rotation_vector;
use crate::state::clock::{Clock, Levels};
use crate::state::contact_scratch::{
    Between, Constants, ContactScratch, Deepest, Exerted, PairGroup, PairKind, Pressed, Slot,
    exerted,
};
use crate::state::found::FoundPair;
use crate::state::scratch::Scratch;
use crate::state::world::World;

impl World {
    /// From here on pairs are evaluated once in up to 2 to the power `most` steps; 0: at each step. Between motions only.
    pub fn step_by_levels(&mut self, most: u8) {
        if self.found.levels.as_ref().map_or(0, |levels| levels.most) == most {
            return;
        }
        let levels = Levels { most, ..Levels::default() };
        self.found.levels = (most > 0).then(|| Box::new(levels));
        self.fresh = true;
    }
}

/// A pair whose time has not come: its forces as they were, which nothing in the coming kick asks for.
pub(super) fn waiting(
    pair: &FoundPair,
    constants: &Constants,
    nearing: f64,
    group: &mut PairGroup,
) -> Slot {
    let deep = Deepest::new(pair.ends, Pressed::Contact, pair.depth, constants.inradius);
    group.sums.deepest = Deepest::deeper(group.sums.deepest, Some(deep));
    let [elastic, spring, drag] = pair.clock.as_ref().map_or_else(Default::default, |c| c.forces);
    Slot {
        at: group.push(Exerted { elastic, spring, drag }),
        touching: true,
        area: pair.patches.iter().map(|patch| patch.area).sum(),
        nearing,
        weight: 0.0,
        ..Slot::default()
    }
}

/// Mean motion of both blocks since the last evaluation `passed` (s) ago.
pub(super) fn mean_motion(clock: &Clock, now: [Pose; 2], passed: f64, motion: &mut [Motion; 2]) {
    for (motion, (now, then)) in motion.iter_mut().zip(now.iter().zip(&clock.poses)) {
        motion.velocity = (now.position - then.position) / passed;
        motion.spin = rotation_vector(now.rotation * then.rotation.conjugate()) / passed;
    }
}

/// Chooses when each pair that was evaluated is evaluated again, and what part of the coming kick each has; the longest step, s.
pub(super) fn plan(world: &mut World, scratch: &mut Scratch) -> f64 {
    let Scratch { desk, exec, coming_dt, .. } = scratch;
    let dt = *coming_dt;
    let Some(levels) = world.found.levels.as_deref_mut() else {
        return f64::INFINITY;
    };
    let (step, last) = (world.step, world.last_dt);
    let plannable = levels.plannable(step);
    let common = u64::from(plannable) == levels.cycle();
    if common || world.fresh || levels.joints.len() != world.alive.len() {
        let joints = of_joints(world, &desk.shapes);
        if let Some(levels) = &mut world.found.levels {
            levels.joints = joints;
        }
    }
    // What a block allows beyond that changes no plan now.
    let cap = if dt > 0.0 { 2.0 * f64::from(plannable) * dt } else { f64::INFINITY };
    let mut limits = std::mem::take(&mut desk.limits);
    let longest = limit::of_blocks(world, desk, exec, cap, &mut limits);
    with_joints(world, desk, &mut limits);
    let mut pairs = std::mem::take(&mut world.found.pairs);
    let planning = Planning {
        world,
        limits: &limits,
        plannable,
        gravity: world.gravity.length(),
        step,
        dt,
        span: 0.5 * (last + dt),
    };
    let (mut wrong, mut counts) = (0.0, [0, 0]);
    let mut slots = std::mem::take(&mut desk.slots);
    for (k, (pair, slot)) in pairs.iter_mut().zip(&mut slots).enumerate() {
        wrong += planning.pair(desk, k, pair, slot);
        counts[0] += u64::from(slot.touching && slot.weight != 0.0);
        counts[1] += u64::from(slot.touching);
    }
    // Another look at an instant is none of one level either.
    let count = world.pending > 0.0;
    desk.slots = slots;
    desk.limits = limits;
    between(desk);
    world.found.pairs = pairs;
    world.works.contact_path -= wrong;
    if let Some(levels) = world.found.levels.as_mut().filter(|_| count) {
        levels.evaluated += counts[0];
        levels.touching += counts[1];
    }
    longest
}

/// Shortens what each block allows by its joints.
fn with_joints(world: &World, desk: &ContactScratch, limits: &mut [f64]) {
    let Some(levels) = &world.found.levels else { return };
    for (b, own) in desk.blocks.iter().zip(limits) {
        let [a, b] = [*own, levels.joints[*b as usize]].map(|step| 1.0 / (step * step));
        *own = 1.0 / (a + b).sqrt();
    }
}

/// Step that the joints of each block allow, s: that of the block alone on twice their springs.
fn of_joints(world: &World, shapes: &[Shape]) -> Vec<f64> {
    let mut joints: Vec<Vec<(u32, usize)>> = vec![Vec::new(); world.alive.len()];
    for (p, ends) in (0..).zip(&world.patches.ends) {
        for (side, b) in ends.iter().enumerate() {
            joints[*b as usize].push((p, side));
        }
    }
    let mut felt = ContactStiffness::default();
    let of_block = |(b, joints): (usize, &Vec<(u32, usize)>)| {
        if joints.is_empty() {
            return f64::INFINITY;
        }
        let ease = InverseInertia::of(world, shapes, b);
        felt.clear();
        for (p, side) in joints {
            let class = &world.classes[world.patches.class[*p as usize] as usize];
            let [rb, rc] = class.half_spacing;
            let spread = AreaMoments {
                normal: class.frame[0],
                arm: class.arms[*side],
                area: class.area,
                polar: rb * rb + rc * rc,
                held: 0.0,
            };
            felt.add(&ease, &ContactLaw::default().with_stiffness(class.stiffness), &spread);
        }
        limit::BOUNDED * limit::step_of(felt.bound(&ease))
    };
    joints.iter().enumerate().map(of_block).collect()
}

/// Time for which a pair that parts may do without an evaluation, s: half of that until it has, so that its last impulses grow ever shorter. (What is given
/// in advance beyond the parting would be energy from nothing in each impact.)
fn until_parting(world: &World, pair: &FoundPair) -> f64 {
    let Some(patch) = pair.leading().filter(|patch| patch.memory.area > 0.0) else {
        return 0.0;
    };
    let opening = -Speeds::of(world).across(pair.ends, &patch.memory);
    if opening > 0.0 { 0.5 * patch.depth / opening } else { f64::INFINITY }
}

/// The coming step for all pairs.
struct Planning<'a> {
    /// But for its pairs.
    world: &'a World,
    /// Step that each block of a pair allows, s.
    limits: &'a [f64],
    /// Steps that can be planned.
    plannable: u32,
    /// m/s².
    gravity: f64,
    step: u64,
    /// The coming step, s.
    dt: f64,
    /// Time between the two half-step velocities, s.
    span: f64,
}

impl Planning<'_> {
    /// Plans a pair; what of the work of its pressure is not that on its way, J.
    fn pair(&self, desk: &ContactScratch, k: usize, pair: &mut FoundPair, slot: &mut Slot) -> f64 {
        let passed = pair.clock.as_ref().map(|clock| self.world.time - clock.at);
        if !slot.touching && passed.is_none() {
            return 0.0;
        }
        let allowed = self.allowed(desk, k, pair, slot);
        if let Some(clock) = pair.clock.as_mut().filter(|clock| clock.left > 0) {
            if allowed < clock.every {
                clock.every = allowed;
                let due = u64::from(allowed) - self.step % u64::from(allowed);
                clock.left = clock.left.min(due as u32);
            }
            slot.late = passed.unwrap_or_default() - clock.given;
            return 0.0;
        }
        slot.every = allowed.min(self.plannable);
        let last = self.world.last_dt;
        let before = match (&pair.clock, passed) {
            (Some(clock), Some(passed)) => passed - clock.given,
            _ => 0.5 * last,
        };
        let whole = before + 0.5 * f64::from(slot.every) * self.dt;
        slot.weight = if self.span > 0.0 { whole / self.span } else { 1.0 };
        let past = if last > 0.0 { last / (last + self.dt) } else { 0.0 };
        slot.late = before - past * whole;
        self.wrong(desk, k, pair, slot, passed)
    }

    /// Steps for which a pair may do without an evaluation, a power of two.
    fn allowed(&self, desk: &ContactScratch, k: usize, pair: &FoundPair, slot: &Slot) -> u32 {
        let constants = &desk.constants[k];
        if self.dt == 0.0 || !slot.touching || matches!(constants.kind, PairKind::Terrain(_)) {
            return 1;
        }
        let of = |b: u32| self.limits[desk.place[b as usize] as usize];
        let transit = limit::pair_transit(pair, slot, constants.inradius, self.gravity);
        let alone = transit.min(until_parting(self.world, pair));
        let limit = of(pair.ends[0]).min(of(pair.ends[1])).min(alone);
        let mut steps = 1;
        while f64::from(2 * steps) * self.dt <= limit && steps < 1 << 16 {
            steps *= 2;
        }
        steps
    }

    /// Work of the pressure of a pair up to now on its way less that on the velocities between which it kicks, J.
    fn wrong(
        &self,
        desk: &ContactScratch,
        k: usize,
        pair: &FoundPair,
        slot: &Slot,
        passed: Option<f64>,
    ) -> f64 {
        let world = self.world;
        if world.pending == 0.0 {
            return 0.0;
        }
        let now = exerted(&desk.groups, slot, k).map(|by| by.elastic).unwrap_or_default();
        let mut motion = moving(world, pair.ends);
        let kicked = 0.5 * world.pending * now.power(&motion);
        let (Some(clock), Some(passed)) = (&pair.clock, passed) else {
            return (1.0 - slot.weight) * kicked;
        };
        let poses = pair.ends.map(|b| desk.poses[desk.place[b as usize] as usize]);
        mean_motion(clock, poses, passed, &mut motion);
        let on_way = 0.5 * passed * (clock.forces[0].power(&motion) + now.power(&motion));
        on_way - clock.booked - slot.weight * kicked
    }
}

/// Motion of the blocks of a pair, half a step ago or from now on.
fn moving(world: &World, ends: [u32; 2]) -> [Motion; 2] {
    ends.map(|b| Motion {
        velocity: world.bodies.velocity(b as usize),
        spin: world.bodies.spin(b as usize),
        inverse_mass: 0.0,
    })
}

/// How blocks stand between the evaluations of their pairs.
fn between(desk: &mut ContactScratch) {
    let ContactScratch { between, first_pair, incidence, slots, groups, .. } = desk;
    for (ends, between) in first_pair.windows(2).zip(between) {
        *between = Between::default();
        for &(k, second) in &incidence[ends[0] as usize..ends[1] as usize] {
            let k = k as usize;
            let slot = &slots[k];
            let Some(by) = exerted(groups, slot, k) else { continue };
            let steady = by.elastic.plus(&by.spring);
            between.lag.add(&steady.times(1.0 - slot.weight), second);
            between.late.add(&steady.plus(&by.drag).times(slot.late), second);
        }
    }
}

/// Winds the clocks of all pairs for a step of `dt` (s), whose kick has been made; 0 ends a motion.
pub(crate) fn depart(world: &mut World, desk: &ContactScratch, dt: f64) {
    if world.found.levels.is_none() || desk.slots.len() != world.found.pairs.len() {
        return;
    }
    let mut pairs = std::mem::take(&mut world.found.pairs);
    let mut wrong = 0.0;
    for (k, (pair, slot)) in pairs.iter_mut().zip(&desk.slots).enumerate() {
        if let Some(clock) = pair.clock.as_mut().filter(|clock| clock.left > 0) {
            clock.left -= 1;
            continue;
        }
        pair.clock = None;
        let Some(by) = exerted(&desk.groups, slot, k) else { continue };
        let kicked = 0.5 * dt * by.elastic.power(&moving(world, pair.ends));
        if slot.every == 1 || dt == 0.0 {
            wrong += (1.0 - slot.weight) * kicked;
            continue;
        }
        pair.clock = Some(Box::new(Clock {
            left: slot.every - 1,
            every: slot.every,
            at: world.time,
            given: 0.5 * f64::from(slot.every) * dt,
            poses: pair.ends.map(|b| desk.poses[desk.place[b as usize] as usize]),
            forces: [by.elastic, by.spring, by.drag],
            booked: slot.weight * kicked,
        }));
    }
    world.found.pairs = pairs;
    world.works.contact_path -= wrong;
}
