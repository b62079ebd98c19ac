//! One step of the spatial engine.
//!
//! Leapfrog in two halves, so that a caller can look at the state in between, when positions and
//! forces belong to the same time: [`evaluate`] finds forces and the velocity changes they will
//! make, [`advance`] applies them and moves the blocks.

use riprap_geom::Vec3;

use super::boundary::{self, Face, Push};
use super::cavity;
use super::forces::{self, First, Memory, Shared};
use super::kick::{self, Acting, Change, Kick};
use super::lanes::{LANES, Lanes, Width};
use super::loads;
use super::patch::{self, Poses};
use super::setup::Kinematics;
use super::sums::{Part, Sums};
use super::tiles::{Row, Tile, Tiles};
use super::wide::Wide;
use super::world::{PatchClass, Turned, World, flag};
use crate::exec::{Divide, Exec};
use crate::ledger::Works;
use crate::profile::Profile;

/// Damping of a phase besides that of the contacts.
pub use crate::dynamics::damping::Damping;

/// Everything that can be dropped and rebuilt without changing a result.
#[derive(Debug)]
pub struct Scratch {
    /// Thread pool.
    pub exec: Exec,
    /// Stage timers.
    pub profile: Profile,
    /// Pieces of the model.
    pub tiles: Tiles,
    /// Sums of forces and moments on blocks, without damping and supports.
    pub net: Sums,
    /// Sums of contact dashpots; empty without any.
    pub drag: Sums,
    /// External loads; empty without any.
    pub applied: Vec<Push>,
    /// Pushes of cavities, whose work the cavities book themselves; empty without any.
    pub pushed: Vec<Push>,
    /// Length of the step that the kick was found for, s.
    pub coming_dt: f64,
    /// Damping that the kick was found with.
    pub damping: Damping,
    /// Number of times the patches were laid out; whoever keeps something derived from them looks here.
    pub rebuilds: u64,
    slots: [Sums; 2],
    wide: Vec<Wide>,
    strong: bool,
    width: Width,
    /// Works of the half step after the present time, booked by `advance`.
    departure: Works,
    works: Vec<Works>,
    partial: Vec<Partial>,
    /// Whether a block has turned beyond the bound of small kinematics.
    turning: bool,
}

/// Sums of one tile.
#[derive(Clone, Copy, Debug, Default)]
struct Partial {
    arrival: Works,
    departure: Works,
    bad: Option<u32>,
    turning: bool,
}

/// A block whose state is no longer finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the forces on block {block} are not finite")]
pub struct NonFinite {
    /// Index of the block.
    pub block: u32,
}

impl Scratch {
    /// Scratch data for a world, as new or as read from a checkpoint.
    #[must_use]
    pub fn new(world: &mut World, exec: Exec) -> Self {
        let mut scratch = Self {
            exec,
            profile: Profile::default(),
            tiles: Tiles::default(),
            net: Sums::default(),
            drag: Sums::default(),
            applied: Vec::new(),
            pushed: Vec::new(),
            coming_dt: 0.0,
            damping: Damping::default(),
            rebuilds: 0,
            slots: [Sums::default(), Sums::default()],
            wide: Vec::new(),
            strong: false,
            width: Width::detect(),
            departure: Works::default(),
            works: Vec::new(),
            partial: Vec::new(),
            turning: true,
        };
        scratch.rebuild(world);
        scratch
    }

    /// Lays out everything anew: blocks or patches have come or gone, or laws have changed.
    pub fn invalidate(&mut self, world: &mut World) {
        world.fresh = true;
        self.rebuild(world);
    }

    fn rebuild(&mut self, world: &World) {
        self.tiles = Tiles::new(world);
        let (blocks, count) = (world.alive.len(), self.tiles.list.len());
        self.net = Sums::zeros(blocks);
        self.drag = Sums::default();
        self.pushed = Vec::new();
        self.slots = [Sums::zeros(self.tiles.slots), Sums::default()];
        let interfaces = &world.setup.interfaces;
        let strength = |c: &PatchClass| interfaces[c.row as usize].joint.strength.as_ref();
        let classes = world.classes.iter();
        self.wide = classes.map(|c| Wide::new(c, strength(c))).collect();
        self.strong = world.classes.iter().any(|c| strength(c).is_some());
        self.works = vec![Works::default(); count];
        self.partial = vec![Partial::default(); count];
        self.turning = true;
        self.rebuilds += 1;
    }

    /// Makes room for the sums of dashpots when there are any.
    fn need_drag(&mut self, world: &World, stiffness_damping: f64) {
        let damped = stiffness_damping > 0.0 || world.classes.iter().any(|c| c.beta > 0.0);
        if damped == self.drag.is_empty() {
            let (n, slots) = if damped {
                (world.alive.len(), self.tiles.slots)
            } else {
                (0, 0)
            };
            self.drag = Sums::zeros(n);
            self.slots[1] = Sums::zeros(slots);
        }
    }

    /// Whether nothing but patches and gravity acts on blocks in rows.
    fn plain(&self) -> bool {
        let d = &self.damping;
        let undamped = d.mass == 0.0 && d.rotation.unwrap_or(0.0) == 0.0 && d.local == 0.0;
        undamped && self.applied.is_empty() && self.pushed.is_empty()
    }

    /// Forces on block `b`.
    #[must_use]
    pub fn acting(&self, b: usize) -> Acting {
        let damped = !self.drag.is_empty();
        Acting {
            force: self.net.force(b),
            moment: self.net.moment(b),
            drag: if damped {
                self.drag.force(b)
            } else {
                Vec3::ZERO
            },
            drag_moment: if damped {
                self.drag.moment(b)
            } else {
                Vec3::ZERO
            },
        }
    }

    /// The coming kick.
    #[must_use]
    pub fn kick<'a>(&self, world: &'a World) -> Kick<'a> {
        Kick {
            solids: &world.solids,
            solid: &world.solid,
            motion: &world.motion,
            gravity: world.gravity,
            time: world.time,
            damping: self.damping,
            half: [0.5 * world.pending, 0.5 * self.coming_dt],
            span: 0.5 * (world.last_dt + self.coming_dt),
        }
    }

    /// Velocity change of block `b` in the coming kick.
    #[must_use]
    pub fn change(&self, world: &World, b: usize) -> Change {
        if world.alive[b] {
            self.kick(world)
                .change(b, &world.moving(b), &self.acting(b))
        } else {
            Change::default()
        }
    }
}

/// Finds all forces at the present positions and the velocity changes for a step of `dt`.
///
/// Calling it again without moving changes nothing.
///
/// # Errors
/// A block with forces that are not finite.
pub fn evaluate(
    world: &mut World,
    scratch: &mut Scratch,
    damping: &Damping,
    dt: f64,
) -> Result<(), NonFinite> {
    let mut profile = std::mem::take(&mut scratch.profile);
    scratch.damping = *damping;
    scratch.coming_dt = dt;
    profile.stage("loads", || {
        if !world.setup.loads.is_empty() {
            scratch.applied.resize(world.alive.len(), Push::default());
            loads::apply(world, &mut scratch.applied);
        }
    });
    profile.stage("kinematics", || change_over(world, scratch));
    profile.stage("cavities", || cavity::act(world, scratch, dt));
    profile.stage("patches", || patches(world, scratch));
    let result = profile.stage("gather", || gather(world, scratch));
    world.pending = 0.0;
    world.fresh = false;
    scratch.profile = profile;
    result
}

/// Applies the velocity changes and moves the blocks by `dt`.
pub fn advance(world: &mut World, scratch: &mut Scratch, dt: f64) {
    let mut profile = std::mem::take(&mut scratch.profile);
    profile.stage("integrate", || integrate(world, scratch, dt));
    let departure = std::mem::take(&mut scratch.departure);
    world.works.add(&departure);
    world.works.note_peak();
    world.time += dt;
    world.step += 1;
    world.last_dt = dt;
    world.pending = dt;
    scratch.profile = profile;
}

/// First pass: forces of patches.
fn patches(world: &mut World, scratch: &mut Scratch) {
    scratch.need_drag(world, scratch.damping.stiffness);
    let live = world.pending > 0.0 || world.fresh;
    let (list, tiles) = (&mut world.patches, &scratch.tiles);
    let shared = Shared {
        poses: Poses {
            bodies: &world.bodies,
            turned: &world.turned,
        },
        interfaces: &world.setup.interfaces,
        classes: &world.classes,
        ends: &list.ends,
        class: &list.class,
        prestress: &list.prestress,
        tiles,
        elapsed: live.then_some(world.pending),
        stiffness_damping: scratch.damping.stiffness,
        damped: !scratch.drag.is_empty(),
        strong: scratch.strong,
        wide: &scratch.wide,
        width: scratch.width,
    };
    let [slots, drag_slots] = &mut scratch.slots;
    let work = First {
        tiles: &tiles.list,
        memory: Memory {
            flags: &mut list.flags,
            slip: &mut list.slip,
            lift: &mut list.lift,
            path: &mut list.path,
        },
        net: [scratch.net.whole(), scratch.drag.whole()],
        slots: [slots.whole(), drag_slots.whole()],
        works: &mut scratch.works,
    };
    let count = tiles.list.len();
    scratch
        .exec
        .divided(work, count, |_, piece| forces::tile(&shared, piece));
    for works in &scratch.works {
        world.works.add(works);
    }
}

/// Piece of work of the second pass.
struct Second<'a> {
    tiles: &'a [Tile],
    net: [Part<'a>; 2],
    faces: &'a mut [Face],
    partial: &'a mut [Partial],
}

impl Divide for Second<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.tiles.split_at(middle);
        let blocks = b[0].blocks.start - a[0].blocks.start;
        let [n0, n1] = self.net.map(|part| part.split(blocks));
        let faces = self.faces.split_at_mut(b[0].faces.start - a[0].faces.start);
        let partial = self.partial.split_at_mut(middle);
        (
            Self {
                tiles: a,
                net: [n0.0, n1.0],
                faces: faces.0,
                partial: partial.0,
            },
            Self {
                tiles: b,
                net: [n0.1, n1.1],
                faces: faces.1,
                partial: partial.1,
            },
        )
    }
}

/// Second pass: slots, faces, loads, gravity; works of the kick.
fn gather(world: &mut World, scratch: &mut Scratch) -> Result<(), NonFinite> {
    let mut faces = std::mem::take(&mut world.faces);
    let kick = scratch.kick(world);
    let gathering = Gathering {
        world,
        boundary: boundary::Context::new(world),
        kick,
        tiles: &scratch.tiles,
        slots: &scratch.slots,
        applied: &scratch.applied,
        pushed: &scratch.pushed,
        plain: scratch.plain(),
        width: scratch.width,
    };
    let work = Second {
        tiles: &scratch.tiles.list,
        net: [scratch.net.whole(), scratch.drag.whole()],
        faces: &mut faces,
        partial: &mut scratch.partial,
    };
    let count = scratch.tiles.list.len();
    scratch
        .exec
        .divided(work, count, |_, piece| gathering.tile(piece));
    world.faces = faces;
    let (mut departure, mut bad) = (Works::default(), None);
    for partial in &scratch.partial {
        world.works.add(&partial.arrival);
        departure.add(&partial.departure);
        bad = bad.or(partial.bad);
    }
    scratch.departure = departure;
    bad.map_or(Ok(()), |block| Err(NonFinite { block }))
}

struct Gathering<'a> {
    world: &'a World,
    boundary: boundary::Context<'a>,
    kick: Kick<'a>,
    tiles: &'a Tiles,
    slots: &'a [Sums; 2],
    applied: &'a [Push],
    pushed: &'a [Push],
    /// Whether blocks in rows need nothing but gravity.
    plain: bool,
    width: Width,
}

impl Gathering<'_> {
    fn tile(&self, mut work: Second) {
        let tile = &work.tiles[0];
        let mut partial = Partial::default();
        let base = tile.blocks.start;
        for (net, slots) in work.net.iter_mut().zip(self.slots) {
            if slots.is_empty() {
                continue;
            }
            for (list, slots) in net.0.iter_mut().zip(&slots.lists) {
                for &[slot, j] in &self.tiles.incoming[tile.incoming.clone()] {
                    list[j as usize - base] += slots[slot as usize];
                }
            }
        }
        for row in &self.tiles.rows[tile.rows.clone()] {
            if self.plain {
                let width = self.width;
                width.run(
                    #[inline(always)]
                    || self.row(row, base, &mut work.net, &mut partial),
                );
            } else {
                for b in row.blocks.clone() {
                    self.block(b, base, &mut [], &mut work.net, &mut partial);
                }
            }
        }
        let first_face = tile.faces.start;
        let mut face = 0;
        for &b in &self.tiles.special[tile.special.clone()] {
            // Faces of other blocks have no condition.
            while face < work.faces.len() && work.faces[face].block < b {
                face += 1;
            }
            let mut end = face;
            while end < work.faces.len() && work.faces[end].block == b {
                end += 1;
            }
            debug_assert!(first_face + end <= tile.faces.end);
            let faces = &mut work.faces[face..end];
            self.block(b as usize, base, faces, &mut work.net, &mut partial);
            face = end;
        }
        work.partial[0] = partial;
    }

    /// Gravity and its works for a row of free blocks.
    #[inline(always)]
    fn row(&self, row: &Row, base: usize, net: &mut [Part; 2], partial: &mut Partial) {
        let solid = &self.kick.solids[row.solid as usize];
        let here = row.blocks.start - base..row.blocks.end - base;
        let [net, drag] = net;
        let damped = !drag.0[0].is_empty();
        let [before, after] = self.kick.half;
        let rates = &self.world.bodies.rate;
        let change = self.kick.span / solid.mass;
        let mut sum = Lanes::default();
        for k in 0..3 {
            let weight = solid.mass * self.kick.gravity[k];
            let list = &mut net.0[k][here.clone()];
            if weight != 0.0 {
                let v = &rates[k][row.blocks.clone()];
                let (mut early, mut late) = (Lanes::default(), Lanes::default());
                let chunks = list.chunks_mut(LANES).zip(v.chunks(LANES));
                for (at, (f, v)) in chunks.enumerate() {
                    for (l, (f, v)) in f.iter_mut().zip(v).enumerate() {
                        *f += weight;
                        let at = here.start + LANES * at + l;
                        let push = if damped { *f + drag.0[k][at] } else { *f };
                        early.0[l] += v;
                        late.0[l] += v + change * push;
                    }
                }
                partial.arrival.gravity += before * weight * early.sum();
                partial.departure.gravity += after * weight * late.sum();
            }
        }
        for list in net.0.iter().chain(&drag.0) {
            if list.is_empty() {
                continue;
            }
            for chunk in list[here.clone()].chunks(LANES) {
                for (s, x) in sum.0.iter_mut().zip(chunk) {
                    // Nil for what is finite, else not a number.
                    *s += 0.0 * x;
                }
            }
        }
        if damped {
            self.row_drag(row, base, net, drag, partial);
        }
        if sum.sum() != 0.0 && partial.bad.is_none() {
            let finite = |b: usize| {
                let (force, moment) = net.get(b - base);
                (force + moment).is_finite()
            };
            let bad = row.blocks.clone().find(|b| !finite(*b));
            partial.bad = Some(bad.unwrap_or(row.blocks.start) as u32);
        }
    }

    /// Works of dashpots on a row of free blocks.
    #[inline(always)]
    fn row_drag(&self, row: &Row, base: usize, net: &Part, drag: &Part, partial: &mut Partial) {
        let solid = &self.kick.solids[row.solid as usize];
        let [before, after] = self.kick.half;
        for k in 0..6 {
            let ease = if k < 3 {
                1.0 / solid.mass
            } else {
                solid.inverse.col(k - 3)[k - 3]
            };
            let change = self.kick.span * ease;
            let here = row.blocks.start - base..row.blocks.end - base;
            let v = self.world.bodies.rate[k][row.blocks.clone()].chunks(LANES);
            let (f, d) = (&net.0[k][here.clone()], &drag.0[k][here]);
            let (mut early, mut late) = (Lanes::default(), Lanes::default());
            for ((v, f), d) in v.zip(f.chunks(LANES)).zip(d.chunks(LANES)) {
                for (l, ((v, f), d)) in v.iter().zip(f).zip(d).enumerate() {
                    early.0[l] += d * v;
                    late.0[l] += d * (v + change * (f + d));
                }
            }
            partial.arrival.damping -= before * early.sum();
            partial.departure.damping -= after * late.sum();
        }
    }

    /// All that can act on a block, and its works.
    fn block(
        &self,
        b: usize,
        base: usize,
        faces: &mut [Face],
        net: &mut [Part; 2],
        partial: &mut Partial,
    ) {
        let mut load = self.applied.get(b).copied().unwrap_or_default();
        let mut dashpots = None;
        let mut other = self.pushed.get(b).copied().unwrap_or_default();
        for face in faces {
            let pushes = self.boundary.act(face, &mut partial.arrival, &mut dashpots);
            for (sum, push) in [(&mut other, pushes.spring), (&mut load, pushes.dead)] {
                sum.force += push.force;
                sum.moment += push.moment;
            }
        }
        let weight = self.kick.solid_of(b).mass * self.kick.gravity;
        net[0].add(
            b - base,
            weight + load.force + other.force,
            load.moment + other.moment,
        );
        let moving = self.world.moving(b);
        let (v, w) = (moving.velocity, moving.spin);
        let dashpot = dashpots.map(|d| {
            let (force, moment) = net[0].get(b - base);
            let acting = Push { force, moment };
            d.push(self.kick.solid_of(b), [v, w], &acting, self.kick.span)
        });
        if let Some(dashpot) = &dashpot {
            net[0].add(b - base, dashpot.force, dashpot.moment);
        }
        let acting = acting(net, b - base);
        let all = acting.force + acting.moment + acting.drag + acting.drag_moment;
        if !all.is_finite() && partial.bad.is_none() {
            partial.bad = Some(b as u32);
        }
        let (arrival, departure) = (&mut partial.arrival, &mut partial.departure);
        let loads = (load.force, load.moment);
        let change = self
            .kick
            .works(b, &moving, &acting, loads, arrival, departure);
        if let Some(dashpot) = &dashpot {
            let [before, after] = self.kick.half;
            arrival.absorbed -= before * dashpot.power(v, w);
            departure.absorbed -= after * dashpot.power(v + change.velocity, w + change.spin);
        }
    }
}

/// Forces on entry `at` of the sums.
fn acting(net: &[Part; 2], at: usize) -> Acting {
    let (force, moment) = net[0].get(at);
    let (drag, drag_moment) = if net[1].0[0].is_empty() {
        (Vec3::ZERO, Vec3::ZERO)
    } else {
        net[1].get(at)
    };
    Acting {
        force,
        moment,
        drag,
        drag_moment,
    }
}

/// Piece of work of the integration.
struct Piece<'a> {
    tiles: &'a [Tile],
    net: [Part<'a>; 2],
    pose: Part<'a>,
    rate: Part<'a>,
    turned: &'a mut [Option<Box<Turned>>],
    peak: &'a mut [f64],
    partial: &'a mut [Partial],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.tiles.split_at(middle);
        let blocks = b[0].blocks.start - a[0].blocks.start;
        let [n0, n1] = self.net.map(|part| part.split(blocks));
        let (pose, rate) = (self.pose.split(blocks), self.rate.split(blocks));
        let turned = self.turned.split_at_mut(blocks);
        let peak = self.peak.split_at_mut(blocks);
        let partial = self.partial.split_at_mut(middle);
        (
            Self {
                tiles: a,
                net: [n0.0, n1.0],
                pose: pose.0,
                rate: rate.0,
                turned: turned.0,
                peak: peak.0,
                partial: partial.0,
            },
            Self {
                tiles: b,
                net: [n0.1, n1.1],
                pose: pose.1,
                rate: rate.1,
                turned: turned.1,
                peak: peak.1,
                partial: partial.1,
            },
        )
    }
}

fn integrate(world: &mut World, scratch: &mut Scratch, dt: f64) {
    let plain = scratch.plain();
    let moving = Integration {
        kick: Kick {
            solids: &world.solids,
            solid: &world.solid,
            motion: &world.motion,
            gravity: world.gravity,
            time: world.time,
            damping: scratch.damping,
            half: [0.5 * world.pending, 0.5 * scratch.coming_dt],
            span: 0.5 * (world.last_dt + scratch.coming_dt),
        },
        tiles: &scratch.tiles,
        dt,
        bound: match world.setup.kinematics {
            Kinematics::Automatic { bound } => bound * bound,
            Kinematics::Small | Kinematics::Finite => f64::INFINITY,
        },
        plain,
        width: scratch.width,
    };
    let work = Piece {
        tiles: &scratch.tiles.list,
        net: [scratch.net.whole(), scratch.drag.whole()],
        pose: Part(world.bodies.pose.each_mut().map(Vec::as_mut_slice)),
        rate: Part(world.bodies.rate.each_mut().map(Vec::as_mut_slice)),
        turned: &mut world.turned,
        peak: &mut world.peak_speed_squared,
        partial: &mut scratch.partial,
    };
    let count = scratch.tiles.list.len();
    scratch
        .exec
        .divided(work, count, |_, piece| moving.tile(piece));
    scratch.turning |= scratch.partial.iter().any(|p| p.turning);
}

struct Integration<'a> {
    kick: Kick<'a>,
    tiles: &'a Tiles,
    dt: f64,
    /// Square of the angle at which a block changes over to finite rotations.
    bound: f64,
    plain: bool,
    width: Width,
}

impl Integration<'_> {
    fn tile(&self, mut work: Piece) {
        let tile = work.tiles[0].clone();
        work.partial[0].turning = false;
        for row in &self.tiles.rows[tile.rows] {
            if self.plain {
                let width = self.width;
                width.run(
                    #[inline(always)]
                    || self.row(row, tile.blocks.start, &mut work),
                );
            } else {
                for b in row.blocks.clone() {
                    self.block(b, tile.blocks.start, &mut work);
                }
            }
        }
        for &b in &self.tiles.special[tile.special] {
            self.block(b as usize, tile.blocks.start, &mut work);
        }
    }

    /// Kicks and moves a row of free blocks.
    #[inline(always)]
    fn row(&self, row: &Row, base: usize, work: &mut Piece) {
        let solid = &self.kick.solids[row.solid as usize];
        let here = row.blocks.start - base..row.blocks.end - base;
        let dt = self.dt;
        let damped = !work.net[1].0[0].is_empty();
        for k in 0..6 {
            let ease = if k < 3 {
                1.0 / solid.mass
            } else {
                solid.inverse.col(k - 3)[k - 3]
            };
            let change = self.kick.span * ease;
            let v = &mut work.rate.0[k][here.clone()];
            let u = &mut work.pose.0[k][here.clone()];
            let f = &work.net[0].0[k][here.clone()];
            if damped {
                let d = &work.net[1].0[k][here.clone()];
                for (((v, u), f), d) in v.iter_mut().zip(u).zip(f).zip(d) {
                    *v += change * (f + d);
                    *u += dt * *v;
                }
            } else {
                for ((v, u), f) in v.iter_mut().zip(u).zip(f) {
                    *v += change * f;
                    *u += dt * *v;
                }
            }
        }
        let [x, y, z, ..] = &work.rate.0;
        let speeds = x[here.clone()]
            .iter()
            .zip(&y[here.clone()])
            .zip(&z[here.clone()]);
        for (peak, ((x, y), z)) in work.peak[here.clone()].iter_mut().zip(speeds) {
            let square = x * x + y * y + z * z;
            *peak = if square > *peak { square } else { *peak };
        }
        let [.., a, b, c] = &work.pose.0;
        let mut most = Lanes::default();
        let angles = a[here.clone()]
            .chunks(LANES)
            .zip(b[here.clone()].chunks(LANES))
            .zip(c[here].chunks(LANES));
        for ((a, b), c) in angles {
            for (l, ((a, b), c)) in a.iter().zip(b).zip(c).enumerate() {
                let square = a * a + b * b + c * c;
                most.0[l] = if square > most.0[l] {
                    square
                } else {
                    most.0[l]
                };
            }
        }
        work.partial[0].turning |= most.0.into_iter().any(|m| m > self.bound);
    }

    /// Kicks and moves any block.
    fn block(&self, b: usize, base: usize, work: &mut Piece) {
        let at = b - base;
        let (mut v, mut w) = work.rate.get(at);
        let moving = kick::Moving {
            velocity: v,
            spin: w,
            turned: work.turned[at].as_deref(),
        };
        let change = self.kick.change(b, &moving, &acting(&work.net, at));
        v += change.velocity;
        let (mut u, mut th) = work.pose.get(at);
        u += self.dt * v;
        if let Some(turned) = &mut work.turned[at] {
            turned.momentum += change.momentum;
            let inverse = &self.kick.solid_of(b).inverse;
            (turned.attitude, w) = kick::turn(turned.attitude, turned.momentum, inverse, self.dt);
            th = patch::rotation_vector(turned.attitude);
        } else {
            w += change.spin;
            th += self.dt * w;
            work.partial[0].turning |= th.length_squared() > self.bound;
        }
        work.rate.set(at, v, w);
        work.pose.set(at, u, th);
        work.peak[at] = work.peak[at].max(v.length_squared());
    }
}

/// Lets blocks that have turned beyond the bound, and the patches they touch, use finite rotations from
/// now on; patches store an offset so that their tractions go on.
fn change_over(world: &mut World, scratch: &mut Scratch) {
    if !std::mem::take(&mut scratch.turning) {
        return;
    }
    let bound = match world.setup.kinematics {
        Kinematics::Small => return,
        Kinematics::Automatic { bound } => bound,
        Kinematics::Finite => -1.0,
    };
    let mut changed = false;
    for b in 0..world.alive.len() {
        let vector = world.bodies.rotation(b);
        if !world.alive[b] || world.turned[b].is_some() || vector.length() <= bound {
            continue;
        }
        let attitude = patch::rotation(vector);
        let inertia = patch::turned_inertia(&world.solid_of(b).inertia, attitude);
        world.turned[b] = Some(Box::new(Turned {
            attitude,
            momentum: inertia * world.bodies.spin(b),
        }));
        changed = true;
    }
    if !changed {
        return;
    }
    scratch.tiles.make_rows(world);
    for p in 0..world.patches.len() {
        let ends = world.patches.ends[p];
        let finite = ends.iter().any(|b| world.turned[*b as usize].is_some());
        if finite && world.patches.flags[p] & flag::FINITE == 0 {
            world.make_finite(p);
        }
    }
}

impl World {
    /// Motion of block `b` half a step ago.
    #[must_use]
    pub fn moving(&self, b: usize) -> kick::Moving<'_> {
        kick::Moving {
            velocity: self.bodies.velocity(b),
            spin: self.bodies.spin(b),
            turned: self.turned[b].as_deref(),
        }
    }

    /// Changes a patch over to finite rotations with the tractions it has.
    fn make_finite(&mut self, p: usize) {
        let (class, ends) = (
            self.classes[self.patches.class[p] as usize],
            self.patches.ends[p],
        );
        let poses = Poses {
            bodies: &self.bodies,
            turned: &self.turned,
        };
        let [before, after] = [false, true].map(|finite| poses.points(&class, ends, finite));
        let shifts: [[f64; 3]; 4] =
            std::array::from_fn(|q| [0, 1, 2].map(|k| after.at[q][k] - before.at[q][k]));
        self.patches.flags[p] |= flag::FINITE;
        if shifts.as_flattened().iter().all(|s| *s == 0.0) {
            return;
        }
        self.patches.need_slip();
        self.patches.need_lift();
        self.patches.flags[p] |= flag::OFFSET;
        for (q, shift) in shifts.iter().enumerate() {
            self.patches.lift[p][q] += shift[0];
            self.patches.slip[p][0][q] += shift[1];
            self.patches.slip[p][1][q] += shift[2];
        }
    }
}
