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
use super::loads;
use super::patch::{self, Poses};
use super::setup::Kinematics;
use super::sums::{Part, Sums};
use super::tiles::{Tile, Tiles};
use super::world::{Turned, World, flag};
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
            world,
            damping: self.damping,
            half: [0.5 * world.pending, 0.5 * self.coming_dt],
            span: 0.5 * (world.last_dt + self.coming_dt),
        }
    }

    /// Velocity change of block `b` in the coming kick.
    #[must_use]
    pub fn change(&self, world: &World, b: usize) -> Change {
        if world.alive[b] {
            self.kick(world).change(b, &self.acting(b))
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
        boundary: boundary::Context::new(world),
        kick,
        incoming: &scratch.tiles.incoming,
        slots: &scratch.slots,
        applied: &scratch.applied,
        pushed: &scratch.pushed,
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
    boundary: boundary::Context<'a>,
    kick: Kick<'a>,
    incoming: &'a [[u32; 2]],
    slots: &'a [Sums; 2],
    applied: &'a [Push],
    pushed: &'a [Push],
}

impl Gathering<'_> {
    fn tile(&self, mut work: Second) {
        let tile = work.tiles[0].clone();
        let partial = &mut work.partial[0];
        *partial = Partial::default();
        let base = tile.blocks.start;
        for &[slot, j] in &self.incoming[tile.incoming] {
            for (net, slots) in work.net.iter_mut().zip(self.slots) {
                if !slots.is_empty() {
                    let slot = slot as usize;
                    net.add(j as usize - base, slots.force(slot), slots.moment(slot));
                }
            }
        }
        let damped = !work.net[1].0[0].is_empty();
        let mut faces = work.faces.iter_mut().peekable();
        let world = self.kick.world;
        for b in tile.blocks {
            let mut load = self.applied.get(b).copied().unwrap_or_default();
            let mut dashpots = None;
            let mut other = self.pushed.get(b).copied().unwrap_or_default();
            while let Some(face) = faces.next_if(|f| f.block as usize == b) {
                let pushes = self.boundary.act(face, &mut partial.arrival, &mut dashpots);
                for (sum, push) in [(&mut other, pushes.spring), (&mut load, pushes.dead)] {
                    sum.force += push.force;
                    sum.moment += push.moment;
                }
            }
            if !world.alive[b] {
                continue;
            }
            let weight = world.solid_of(b).mass * world.gravity;
            work.net[0].add(
                b - base,
                weight + load.force + other.force,
                load.moment + other.moment,
            );
            let (v, w) = (world.bodies.velocity(b), world.bodies.spin(b));
            let dashpot = dashpots.map(|d| {
                let (force, moment) = work.net[0].get(b - base);
                let acting = Push { force, moment };
                d.push(world.solid_of(b), [v, w], &acting, self.kick.span)
            });
            if let Some(dashpot) = &dashpot {
                work.net[0].add(b - base, dashpot.force, dashpot.moment);
            }
            let (force, moment) = work.net[0].get(b - base);
            let (drag, drag_moment) = if damped {
                work.net[1].get(b - base)
            } else {
                (Vec3::ZERO, Vec3::ZERO)
            };
            if !(force + moment + drag + drag_moment).is_finite() && partial.bad.is_none() {
                partial.bad = Some(b as u32);
            }
            let acting = Acting {
                force,
                moment,
                drag,
                drag_moment,
            };
            let (arrival, departure) = (&mut partial.arrival, &mut partial.departure);
            let loads = (load.force, load.moment);
            let change = self.kick.works(b, &acting, loads, arrival, departure);
            if let Some(dashpot) = &dashpot {
                let [before, after] = self.kick.half;
                arrival.absorbed -= before * dashpot.power(v, w);
                departure.absorbed -= after * dashpot.power(v + change.velocity, w + change.spin);
            }
        }
    }
}

/// Piece of work of the integration.
struct Moving<'a> {
    tiles: &'a [Tile],
    pose: Part<'a>,
    rate: Part<'a>,
    turned: &'a mut [Option<Box<Turned>>],
    peak: &'a mut [f64],
    partial: &'a mut [Partial],
}

impl Divide for Moving<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.tiles.split_at(middle);
        let blocks = b[0].blocks.start - a[0].blocks.start;
        let (pose, rate) = (self.pose.split(blocks), self.rate.split(blocks));
        let turned = self.turned.split_at_mut(blocks);
        let peak = self.peak.split_at_mut(blocks);
        let partial = self.partial.split_at_mut(middle);
        let part = |tiles, pose, rate, turned, peak, partial| Self {
            tiles,
            pose,
            rate,
            turned,
            peak,
            partial,
        };
        (
            part(a, pose.0, rate.0, turned.0, peak.0, partial.0),
            part(b, pose.1, rate.1, turned.1, peak.1, partial.1),
        )
    }
}

fn integrate(world: &mut World, scratch: &mut Scratch, dt: f64) {
    // The kick reads what the loop writes: rates and attitudes are taken out, changes found first per block.
    let changes: Vec<Change> = (0..world.alive.len())
        .map(|b| scratch.change(world, b))
        .collect();
    let bound = match world.setup.kinematics {
        Kinematics::Automatic { bound } => bound * bound,
        Kinematics::Small | Kinematics::Finite => f64::INFINITY,
    };
    let (alive, solids, solid) = (&world.alive, &world.solids, &world.solid);
    let work = Moving {
        tiles: &scratch.tiles.list,
        pose: Part(world.bodies.pose.each_mut().map(Vec::as_mut_slice)),
        rate: Part(world.bodies.rate.each_mut().map(Vec::as_mut_slice)),
        turned: &mut world.turned,
        peak: &mut world.peak_speed_squared,
        partial: &mut scratch.partial,
    };
    let count = scratch.tiles.list.len();
    scratch.exec.divided(work, count, |_, mut work| {
        let partial = &mut work.partial[0];
        partial.turning = false;
        for b in work.tiles[0].blocks.clone() {
            let at = b - work.tiles[0].blocks.start;
            if !alive[b] {
                continue;
            }
            let change = &changes[b];
            let (mut v, mut w) = work.rate.get(at);
            v += change.velocity;
            let (mut u, mut th) = work.pose.get(at);
            u += dt * v;
            if let Some(turned) = &mut work.turned[at] {
                turned.momentum += change.momentum;
                let inverse = &solids[solid[b] as usize].inverse;
                (turned.attitude, w) = kick::turn(turned.attitude, turned.momentum, inverse, dt);
                th = patch::rotation_vector(turned.attitude);
            } else {
                w += change.spin;
                th += dt * w;
                partial.turning |= th.length_squared() > bound;
            }
            work.rate.set(at, v, w);
            work.pose.set(at, u, th);
            work.peak[at] = work.peak[at].max(v.length_squared());
        }
    });
    scratch.turning |= scratch.partial.iter().any(|p| p.turning);
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
    for p in 0..world.patches.len() {
        let ends = world.patches.ends[p];
        let finite = ends.iter().any(|b| world.turned[*b as usize].is_some());
        if finite && world.patches.flags[p] & flag::FINITE == 0 {
            world.make_finite(p);
        }
    }
}

impl World {
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
