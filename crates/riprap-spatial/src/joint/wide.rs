//! Forces of eight patches at a time.
//!
//! The four points of a patch normal to an axis of space stand in a rectangle about its centre. While every point is
//! elastic, their springs add up to
//!
//! ```text
//!         c ^                      D = (u_j + th_j x a_j) - (u_i + th_i x a_i)   displacement of the centre
//!    3 o----|----o 2               W = th_j - th_i                               relative rotation
//!      |    |    |
//!      |    +----|---> b           F = k D      k  = A (kn, ks, ks)              along n, b, c
//!      |         |                 M = kr W     kr = A (ks (rb^2 + rc^2), kn rc^2, kn rb^2)
//!    0 o---------o 1
//!       2 rb wide, 2 rc high       on i: F and a_i x F + M;   on j: -F and -(a_j x F + M)
//! ```
//!
//! without products of b and c, because the points are symmetric about the centre. The normal is an axis, so n, b, c are
//! x, y, z in turn, and force and moment follow component by component in space: no frames, no points. [`springs`] does
//! that for the eight patches of a packet, and where a law has a strength it bounds the largest tension and shear that any
//! of the four points can have (`|W|` times the half_spacing on top of the centre's): a patch within its strength by these bounds is
//! *certainly elastic*; the others are left to [`points`], which does the law of [`face_joint::plain_point`] point after
//! point in all lanes, or to [`crate::joint::forces`] one by one.
//!
//! A packet is up to eight patches of one axis; mostly they are neighbours of one class, whose blocks lie side by side in
//! the lists (`runs`), so that lanes are loaded and stored as they lie. No lane reads another: a patch has the same bits
//! whatever stands beside it.

use crate::joint::forces::{Memory, Shared};
use crate::joint::patch::Resultant;
use crate::lanes::{LANES, Lanes, Vectors, cross, minus, plus, same, scaled, times};
use crate::laws::face_joint;
use crate::laws::face_joint::{Plain, PlainLaw, SIGNS};
use crate::laws::mohr_coulomb::shear_limit;
use crate::state::patches::flag;
use crate::state::sums::Part;
use crate::state::tiles::Packet;
use crate::state::wide::Wide;

/// Where the lanes of a packet find their blocks.
pub(crate) enum Places {
    /// From these on, side by side.
    Runs([usize; 2]),
    /// One by one; lanes beyond the count repeat the first.
    Each([[usize; LANES]; 2]),
}

impl Places {
    /// Those of a packet.
    #[inline(always)]
    #[must_use]
    pub(crate) fn of(shared: &Shared, packet: &Packet) -> Self {
        let (first, count) = (packet.first as usize, usize::from(packet.count));
        let ends = &shared.ends[first..first + count];
        if packet.runs {
            return Self::Runs(ends[0].map(|b| b as usize));
        }
        let mut index = [[0; LANES]; 2];
        for k in 0..LANES {
            let [i, j] = ends[if k < count { k } else { 0 }];
            index[0][k] = i as usize;
            index[1][k] = j as usize;
        }
        Self::Each(index)
    }
}

/// Force on block i (N) and moment about the centre (N m) of every lane, along x, y, z.
#[derive(Clone, Copy, Default)]
pub(crate) struct Force {
    force: Vectors,
    moment: Vectors,
}

impl Force {
    /// Adds a traction (n, b, c) at a point with these coordinates along b and c; the moment is about the centre.
    #[inline(always)]
    fn add(&mut self, t: &Vectors, b: Lanes, c: Lanes) {
        self.force = plus(&self.force, t);
        let [x, y, z] = self.moment;
        self.moment = [x + (b * t[2] - c * t[1]), y + c * t[0], z - b * t[0]];
    }
}

/// Forces of the springs and of the dashpots of a packet.
#[derive(Clone, Copy, Default)]
pub(crate) struct Response(pub [Force; 2]);

impl Response {
    /// Takes the lanes `chosen` over from another.
    #[inline(always)]
    pub(crate) fn take(&mut self, chosen: u8, other: &Self) {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            for k in 0..3 {
                for lane in 0..LANES {
                    if chosen & (1 << lane) != 0 {
                        own.force[k].0[lane] = other.force[k].0[lane];
                        own.moment[k].0[lane] = other.moment[k].0[lane];
                    }
                }
            }
        }
    }
}

/// What a packet adds to both blocks of each lane: forces (x, y, z), N, then moments about the centroids, N m.
#[derive(Clone, Copy, Default)]
pub(crate) struct Shares {
    on: [[Lanes; 6]; 2],
}

impl Shares {
    /// Of forces and moments at the centres of the patches.
    #[inline(always)]
    #[must_use]
    pub(crate) fn new(class: &Class, at: &Force) -> Self {
        let [x, y, z] = at.force;
        let [a, b, c] = plus(&cross(&class.arms[0], &at.force), &at.moment);
        let [d, e, f] = plus(&cross(&class.arms[1], &at.force), &at.moment);
        Self { on: [[x, y, z, a, b, c], [-x, -y, -z, -d, -e, -f]] }
    }

    /// Sets one lane.
    #[inline(always)]
    pub(crate) fn set(&mut self, lane: usize, resultant: &Resultant) {
        let [i, j] = &mut self.on;
        for k in 0..3 {
            i[k].0[lane] = resultant.force[k];
            j[k].0[lane] = -resultant.force[k];
            i[k + 3].0[lane] = resultant.moments[0][k];
            j[k + 3].0[lane] = resultant.moments[1][k];
        }
    }
}

/// Sums that packets add to.
pub(crate) struct Targets<'a, 'b> {
    /// Sums of the tile's blocks: elastic, dashpots.
    pub net: &'b mut [Part<'a>; 2],
    /// Slots of its patches that have some.
    pub slots: &'b mut [Part<'a>; 2],
    /// First block of the tile.
    pub base: usize,
    /// Slot of the packet's first patch, if its patches have slots.
    pub slot: Option<usize>,
}

impl Targets<'_, '_> {
    /// Adds to both blocks of each lane, as if patch after patch were added.
    #[inline(always)]
    pub(crate) fn add(&mut self, kind: usize, packet: &Packet, places: &Places, shares: &Shares) {
        let (base, count) = (self.base, usize::from(packet.count));
        let net = &mut self.net[kind].0;
        let slots = &mut self.slots[kind].0;
        let [on_i, on_j] = &shares.on;
        match (places, self.slot) {
            (Places::Runs([i, _]), Some(slot)) => six(
                #[inline(always)]
                |k| {
                    put_run(slots[k], slot, count, on_j[k]);
                    add_run(net[k], i - base, count, on_i[k]);
                },
            ),
            // A block that is j of one lane and i of another gets the part of the earlier lane first.
            (Places::Runs([i, j]), None) if i <= j => six(
                #[inline(always)]
                |k| {
                    add_run(net[k], j - base, count, on_j[k]);
                    add_run(net[k], i - base, count, on_i[k]);
                },
            ),
            (Places::Runs([i, j]), None) => six(
                #[inline(always)]
                |k| {
                    add_run(net[k], i - base, count, on_i[k]);
                    add_run(net[k], j - base, count, on_j[k]);
                },
            ),
            (Places::Each([i, _]), Some(slot)) => six(
                #[inline(always)]
                |k| {
                    put_run(slots[k], slot, count, on_j[k]);
                    add_each(net[k], base, i, count, on_i[k]);
                },
            ),
            (Places::Each([i, j]), None) => six(
                #[inline(always)]
                |k| add_pairs(net[k], base, [i, j], count, [on_i[k], on_j[k]]),
            ),
        }
    }
}

/// Does something for each component. Written out, so that components are known to the compiler and stay in registers.
#[inline(always)]
fn six(mut f: impl FnMut(usize)) {
    f(0);
    f(1);
    f(2);
    f(3);
    f(4);
    f(5);
}

/// Adds the first `count` lanes to neighbours of a list. Lanes are taken by value here and below: a number of lanes that the
/// compiler does not know must not force all lanes through memory.
#[inline(always)]
fn add_run(list: &mut [f64], first: usize, count: usize, lanes: Lanes) {
    if count == LANES {
        for (x, y) in list[first..first + LANES].iter_mut().zip(lanes.0) {
            *x += y;
        }
    } else {
        let some = lanes.0;
        for (x, y) in list[first..first + count].iter_mut().zip(&some) {
            *x += y;
        }
    }
}

/// Writes the first `count` lanes to neighbours of a list.
#[inline(always)]
fn put_run(list: &mut [f64], first: usize, count: usize, lanes: Lanes) {
    if count == LANES {
        list[first..first + LANES].copy_from_slice(&lanes.0);
    } else {
        let some = lanes.0;
        list[first..first + count].copy_from_slice(&some[..count]);
    }
}

/// Adds the first `count` lanes to entries of a list.
#[inline(always)]
fn add_each(list: &mut [f64], base: usize, at: &[usize; LANES], count: usize, lanes: Lanes) {
    let some = lanes.0;
    for (x, at) in some.iter().zip(at).take(count) {
        list[at - base] += x;
    }
}

/// Adds the first `count` lanes to entries on both sides, lane by lane.
#[inline(always)]
fn add_pairs(
    list: &mut [f64],
    base: usize,
    [i, j]: [&[usize; LANES]; 2],
    count: usize,
    [on_i, on_j]: [Lanes; 2],
) {
    let (on_i, on_j) = (on_i.0, on_j.0);
    for lane in 0..count {
        list[j[lane] - base] += on_j[lane];
        list[i[lane] - base] += on_i[lane];
    }
}

/// Forces of the springs of a packet as if all were elastic, and the bits of the patches that may not be.
#[inline(always)]
pub(crate) fn springs(
    shared: &Shared,
    packet: &Packet,
    places: &Places,
    class: &Class,
) -> (Force, u8) {
    let bodies = shared.poses.bodies;
    let (d, w) = relative(&bodies.displacement, places, &class.arms);
    let mut force = times(&class.stiffness, &d);
    let mut moment = times(&class.turning, &w);
    let start = in_situ(shared, packet);
    if !shared.prestress.is_empty() {
        let load = scaled(class.area, &start);
        force = plus(&force, &load);
        moment = plus(&moment, &class.moment);
    }
    let mut doubtful = 0;
    if shared.strong {
        doubtful = class.doubtful(usize::from(packet.axis), &start, &d, &w) & packet.all();
    }
    (Force { force, moment }, doubtful)
}

/// Forces of the dashpots of a packet where all patches are elastic.
#[inline(always)]
pub(crate) fn dashpots(shared: &Shared, places: &Places, class: &Class) -> Force {
    let (v, spin) = relative(&shared.poses.bodies.velocity, places, &class.arms);
    let beta = class.beta + Lanes::all(shared.stiffness_damping);
    Force {
        force: scaled(beta, &times(&class.stiffness, &v)),
        moment: scaled(beta, &times(&class.turning, &spin)),
    }
}

/// `x` in the lanes whose bit is set, 0 in the others.
#[inline(always)]
fn chosen_lanes(bits: u8, x: Lanes) -> Lanes {
    let mut lanes = Lanes::default();
    for (lane, y) in lanes.0.iter_mut().enumerate() {
        *y = if bits & (1 << lane) == 0 { 0.0 } else { x.0[lane] };
    }
    lanes
}

/// In-situ traction at the centres (x, y, z), Pa.
#[inline(always)]
fn in_situ(shared: &Shared, packet: &Packet) -> Vectors {
    let mut start = [Lanes::default(); 3];
    if shared.prestress.is_empty() {
        return start;
    }
    let first = packet.first as usize;
    for lane in 0..usize::from(packet.count) {
        let t = shared.prestress[first + lane];
        start[0].0[lane] = t.x;
        start[1].0[lane] = t.y;
        start[2].0[lane] = t.z;
    }
    start
}

/// Forces of the lanes `chosen` of a packet point by point, with [`face_joint::plain_point`], and their losses by friction
/// and fracture, J (zero in the other lanes). Their law and their memory must be those that [`Wide::plain`] and the flags
/// allow; the packet's memory begins at `at`.
#[inline(always)]
pub(crate) fn points(
    shared: &Shared,
    packet: &Packet,
    chosen: u8,
    (memory, at): (&mut Memory, usize),
    (places, class): (&Places, &Class),
) -> (Response, [Lanes; 2]) {
    let count = usize::from(packet.count);
    let bodies = shared.poses.bodies;
    let axis = usize::from(packet.axis);
    let local = |v: &Vectors| [v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]];
    let (d, w) = relative(&bodies.displacement, places, &class.arms);
    let (v, spin) = relative(&bodies.velocity, places, &class.arms);
    let [d, w, v, spin] = [local(&d), local(&w), local(&v), local(&spin)];
    let start = local(&in_situ(shared, packet));
    let (slope_b, slope_c) = class.slopes(shared, packet);
    let law = PlainLanes::of(class, shared, packet);
    let elapsed = shared.elapsed.unwrap_or(0.0);
    let beta = class.beta + Lanes::all(shared.stiffness_damping);
    let [kn, ks] = class.springs;
    let mut sums = [Force::default(); 2];
    let mut lost = [Lanes::default(); 2];
    for (q, (sign_b, sign_c)) in SIGNS[0].into_iter().zip(SIGNS[1]).enumerate() {
        let b = Lanes::all(sign_b) * class.half_spacing[0];
        let c = Lanes::all(sign_c) * class.half_spacing[1];
        let here = |d: &Vectors, w: &Vectors| {
            [d[0] + (w[1] * c - w[2] * b), d[1] - w[0] * c, d[2] + w[0] * b]
        };
        let (place, velocity) = (here(&d, &w), here(&v, &spin));
        let first = [0, 1, 2].map(|k| start[k] + (b * slope_b[k] + c * slope_c[k]));
        let before = PlainState::read(memory, at, count, q);
        let (t, mut after, loss) = law.answer(&first, &place, &velocity, elapsed, &before);
        // The law takes a point that sees no motion for one that sticks.
        if elapsed == 0.0 {
            after.slide_on(memory, at, count, q);
        }
        after.write(memory, at, count, q, chosen);
        lost = [lost[0] + loss[0], lost[1] + loss[1]];
        let closed = Lanes::all(1.0) - after.open;
        let along = closed - law.sticking * after.sliding;
        let drag = [
            closed * (beta * (kn * velocity[0])),
            along * (beta * (ks * velocity[1])),
            along * (beta * (ks * velocity[2])),
        ];
        sums[0].add(&t, b, c);
        sums[1].add(&drag, b, c);
    }
    let share = Lanes::all(0.25) * class.area;
    let springs = to_space(axis, share, &sums[0]);
    let mut dashpots = Force::default();
    if shared.damped {
        dashpots = to_space(axis, share, &sums[1]);
    }
    let lost = [chosen_lanes(chosen, share * lost[0]), chosen_lanes(chosen, share * lost[1])];
    (Response([springs, dashpots]), lost)
}

/// Back to the axes of space, where component `axis` is the normal one, times the share of the area of a point.
#[inline(always)]
fn to_space(axis: usize, share: Lanes, local: &Force) -> Force {
    let back = (3 - axis) % 3;
    let turned = |v: &Vectors| [0, 1, 2].map(|k| share * v[(back + k) % 3]);
    Force { force: turned(&local.force), moment: turned(&local.moment) }
}

/// Laws of the lanes.
struct PlainLanes {
    springs: [Lanes; 2],
    peak: Vectors,
    residual: [Lanes; 2],
    sticking: Lanes,
}

impl PlainLanes {
    #[inline(always)]
    fn of(class: &Class, shared: &Shared, packet: &Packet) -> Self {
        let first = shared.wide_of(packet, 0);
        let mut residual = first.residual.map(Lanes::all);
        let mut sticking = Lanes::all(first.sticking);
        if !packet.one_class {
            for lane in 0..LANES {
                let wide = shared.wide_of(packet, lane);
                residual[0].0[lane] = wide.residual[0];
                residual[1].0[lane] = wide.residual[1];
                sticking.0[lane] = wide.sticking;
            }
        }
        Self { springs: class.springs, peak: class.strength, residual, sticking }
    }

    /// The law on every lane: tractions, state, and losses by friction and fracture.
    #[inline(always)]
    fn answer(
        &self,
        start: &Vectors,
        place: &Vectors,
        velocity: &Vectors,
        elapsed: f64,
        before: &PlainState,
    ) -> (Vectors, PlainState, [Lanes; 2]) {
        let mut t = [Lanes::default(); 3];
        let mut after = PlainState::default();
        let mut loss = [Lanes::default(); 2];
        // Lane by lane in the text alone: the law has no branches, so that the compiler does eight at once.
        for l in 0..LANES {
            let law = PlainLaw {
                springs: [self.springs[0].0[l], self.springs[1].0[l]],
                peak: [self.peak[0].0[l], self.peak[1].0[l], self.peak[2].0[l]],
                residual: [self.residual[0].0[l], self.residual[1].0[l]],
            };
            let three = |v: &Vectors| [v[0].0[l], v[1].0[l], v[2].0[l]];
            let velocity = three(velocity);
            let moved = [velocity[0] * elapsed, velocity[1] * elapsed, velocity[2] * elapsed];
            let old = Plain {
                slip: [before.slip[0].0[l], before.slip[1].0[l]],
                broken: before.broken.0[l],
                open: before.open.0[l],
                sliding: 0.0,
            };
            let (traction, new, lost) =
                face_joint::plain_point(&law, &three(start), &three(place), &moved, &old);
            for k in 0..3 {
                t[k].0[l] = traction[k];
            }
            for k in 0..2 {
                after.slip[k].0[l] = new.slip[k];
            }
            after.broken.0[l] = new.broken;
            after.open.0[l] = new.open;
            after.sliding.0[l] = new.sliding;
            loss[0].0[l] = lost.friction;
            loss[1].0[l] = lost.fracture;
        }
        (t, after, loss)
    }
}

/// State of one point of each lane.
#[derive(Default)]
struct PlainState {
    slip: [Lanes; 2],
    broken: Lanes,
    open: Lanes,
    sliding: Lanes,
}

impl PlainState {
    #[inline(always)]
    fn read(memory: &Memory, at: usize, count: usize, q: usize) -> Self {
        let mut state = Self::default();
        for lane in 0..count {
            let (slip, flags) = (&memory.slip[at + lane], memory.flags[at + lane]);
            state.slip[0].0[lane] = slip[0][q];
            state.slip[1].0[lane] = slip[1][q];
            let bit = |group: u16| f64::from(flags >> (group.trailing_zeros() as usize + q) & 1);
            state.broken.0[lane] = bit(flag::BROKEN);
            state.open.0[lane] = bit(flag::OPEN);
        }
        state
    }

    /// Points that slid still do where nothing has moved since: see [`flag::slide_on`].
    fn slide_on(&mut self, memory: &Memory, at: usize, count: usize, q: usize) {
        for lane in 0..count {
            let slid = memory.flags[at + lane] & flag::of(flag::SLIDING, q) != 0;
            if slid && self.open.0[lane] == 0.0 {
                self.sliding.0[lane] = 1.0;
            }
        }
    }

    #[inline(always)]
    fn write(&self, memory: &mut Memory, at: usize, count: usize, q: usize, chosen: u8) {
        for lane in 0..count {
            if chosen & (1 << lane) == 0 {
                continue;
            }
            let (slip, flags) = (&mut memory.slip[at + lane], &mut memory.flags[at + lane]);
            slip[0][q] = self.slip[0].0[lane];
            slip[1][q] = self.slip[1].0[lane];
            let mut bits = *flags;
            for (group, set) in [
                (flag::BROKEN, self.broken.0[lane]),
                (flag::OPEN, self.open.0[lane]),
                (flag::SLIDING, self.sliding.0[lane]),
            ] {
                let bit = flag::of(group, q);
                bits = (bits & !bit) | (u16::from(set != 0.0) << bit.trailing_zeros());
            }
            *flags = bits;
        }
    }
}

/// Constants of the classes, lane by lane.
pub(crate) struct Class {
    arms: [Vectors; 2],
    stiffness: Vectors,
    turning: Vectors,
    area: Lanes,
    moment: Vectors,
    beta: Lanes,
    springs: [Lanes; 2],
    half_spacing: [Lanes; 2],
    spread: Vectors,
    strength: Vectors,
}

impl Class {
    /// Those of a packet.
    #[inline(always)]
    #[must_use]
    pub(crate) fn load(shared: &Shared, packet: &Packet) -> Self {
        let wide = shared.wide;
        let first = packet.first as usize;
        let count = usize::from(packet.count);
        if packet.one_class {
            let k = &wide[shared.class[first] as usize];
            let two = |v: &[f64; 2]| [Lanes::all(v[0]), Lanes::all(v[1])];
            return Self {
                arms: [same(&k.arms[0]), same(&k.arms[1])],
                stiffness: same(&k.stiffness),
                turning: same(&k.turning),
                area: Lanes::all(k.area),
                moment: same(&k.moment),
                beta: Lanes::all(k.beta),
                springs: two(&k.springs),
                half_spacing: two(&k.half_spacing),
                spread: same(&k.spread),
                strength: same(&k.strength),
            };
        }
        let index: [usize; LANES] =
            std::array::from_fn(|k| shared.class[first + if k < count { k } else { 0 }] as usize);
        let of = |f: &dyn Fn(&Wide) -> f64| Lanes(index.map(|k| f(&wide[k])));
        Self {
            arms: [0, 1].map(|s| [0, 1, 2].map(|k| of(&|w| w.arms[s][k]))),
            stiffness: [0, 1, 2].map(|k| of(&|w| w.stiffness[k])),
            turning: [0, 1, 2].map(|k| of(&|w| w.turning[k])),
            area: of(&|w| w.area),
            moment: [0, 1, 2].map(|k| of(&|w| w.moment[k])),
            beta: of(&|w| w.beta),
            springs: [0, 1].map(|k| of(&|w| w.springs[k])),
            half_spacing: [0, 1].map(|k| of(&|w| w.half_spacing[k])),
            spread: [0, 1, 2].map(|k| of(&|w| w.spread[k])),
            strength: [0, 1, 2].map(|k| of(&|w| w.strength[k])),
        }
    }

    /// Slopes of the in-situ traction along b and along c.
    #[inline(always)]
    fn slopes(&self, shared: &Shared, packet: &Packet) -> (Vectors, Vectors) {
        let (mut b, mut c) = ([Lanes::default(); 3], [Lanes::default(); 3]);
        if shared.prestress.is_empty() {
            return (b, c);
        }
        // All lanes, so that those beyond the count have the slopes of the first as they have its place.
        for lane in 0..LANES {
            let wide = shared.wide_of(packet, lane);
            for k in 0..3 {
                b[k].0[lane] = wide.slope[0][k];
                c[k].0[lane] = wide.slope[1][k];
            }
        }
        (b, c)
    }

    /// Bits of the lanes in which a point may be beyond its strength: by bounds over the four points.
    #[inline(always)]
    fn doubtful(&self, axis: usize, start: &Vectors, d: &Vectors, w: &Vectors) -> u8 {
        let [n, b, c] = [axis, (axis + 1) % 3, (axis + 2) % 3];
        let [kn, ks] = self.springs;
        let [rb, rc] = self.half_spacing;
        let tension = start[n] + kn * (d[n] + (w[b].abs() * rc + w[c].abs() * rb)) + self.spread[0];
        let shear_b = (start[b] + ks * d[b]).abs() + ks * (w[n].abs() * rc) + self.spread[1];
        let shear_c = (start[c] + ks * d[c]).abs() + ks * (w[n].abs() * rb) + self.spread[2];
        let [cohesion, cut, friction] = self.strength;
        // Strength falls with tension: taken at the largest one of the four points it is the least of them.
        let limit = shear_limit(cohesion, friction, tension);
        let shear = shear_b * shear_b + shear_c * shear_c;
        let limit2 = limit * limit;
        let mut bits = 0;
        for k in 0..LANES {
            // A negative limit has a square too. Written so that what is not a number is in doubt.
            let fine = tension.0[k] <= cut.0[k] && limit.0[k] >= 0.0 && shear.0[k] <= limit2.0[k];
            bits |= u8::from(!fine) << k;
        }
        bits
    }
}

/// Relative displacement of the patch centres and relative rotation (or their rates).
#[inline(always)]
fn relative(lists: &[Vec<f64>; 6], places: &Places, arms: &[Vectors; 2]) -> (Vectors, Vectors) {
    let turn = [load(lists, places, 0, 3), load(lists, places, 1, 3)];
    let move_i = plus(&load(lists, places, 0, 0), &cross(&turn[0], &arms[0]));
    let move_j = plus(&load(lists, places, 1, 0), &cross(&turn[1], &arms[1]));
    (minus(&move_j, &move_i), minus(&turn[1], &turn[0]))
}

/// Components `first` to `first + 2` of the blocks on a side.
#[inline(always)]
fn load(lists: &[Vec<f64>; 6], places: &Places, side: usize, first: usize) -> Vectors {
    let [x, y, z] = [&lists[first], &lists[first + 1], &lists[first + 2]];
    match places {
        Places::Runs(from) => {
            let at = from[side];
            [Lanes::at(x, at), Lanes::at(y, at), Lanes::at(z, at)]
        }
        Places::Each(index) => {
            let at = &index[side];
            [Lanes::pick(x, at), Lanes::pick(y, at), Lanes::pick(z, at)]
        }
    }
}
