//! One step of the planar engine.
//!
//! Leapfrog in two halves, so that a caller can look at the state in between, when positions and
//! forces belong to the same time: [`evaluate`] finds forces and the velocity changes they will
//! make, [`advance`] applies them and moves the blocks.

mod entries;
mod kick;

use riprap_geom::Vec2;

use super::bolts;
use super::bond;
use super::contact::{self, Context};
use super::convex::Turned;
use super::handover;
use super::loads::{self, Applied};
pub use super::scratch::{Change, Net, NonFinite, Scratch};
use super::scratch::{Partial, Workspace};
use super::search::{self, Candidates};
use super::seepage;
use super::setup::LoadKind;
use super::setup::Setup;
use super::shapes::Shapes;
use super::view::View;
use super::water;
use super::world::{Body, World, Wrench};
use crate::accounts::{Account, Entries};
use crate::exec::{Exec, piece};
use crate::failed::FailedPoints;
use crate::ledger::{Left, Works};
use crate::sums::{self, GROUP};
use kick::kicks;
use riprap_core::profile::{Begun, Profile};

/// Damping of a phase besides that of the contacts.
pub use crate::dynamics::damping::Damping;

impl World {
    /// A world at rest at time zero, with joints built; the scratch data come with it.
    #[must_use]
    pub fn new(setup: Setup, exec: Exec) -> (Self, Scratch) {
        let shapes = Shapes::new(&setup);
        let n = shapes.len();
        let bodies: Vec<Body> = setup
            .blocks
            .iter()
            .zip(&shapes.centroid)
            .map(|(b, &position)| Body { position, velocity: b.velocity, angle: 0.0, spin: b.spin })
            .collect();
        let mut motion = vec![None; n];
        for support in &setup.supports {
            for &b in &support.blocks {
                motion[b as usize] = Some(Box::new(support.motion.clone()));
            }
        }
        let mut world = Self {
            gravity: Vec2::from(setup.gravity),
            water: None,
            seepage: None,
            time: 0.0,
            step: 0,
            last_dt: 0.0,
            pending: 0.0,
            reference: bodies.iter().map(|b| b.position).collect(),
            reference_angle: vec![0.0; n],
            search_pose: bodies.iter().map(|b| (b.position, b.angle)).collect(),
            bodies,
            alive: vec![true; n],
            motion,
            pairs: Vec::new(),
            general: Vec::new(),
            bonds: Vec::new(),
            failed: FailedPoints::default(),
            bolts: Vec::new(),
            works: Works::default(),
            left: Left::default(),
            accounts: vec![Account::default(); setup.accounts.len()],
            start_energy: None,
            setup,
        };
        hold_driven(&mut world, &shapes);
        let close = search::near_pairs(&world, &shapes);
        world.bonds = bond::build(&world.setup, &shapes, &close);
        // What a joint stores at the start, by round-off of its corners, is no work of friction.
        for bond in &mut world.bonds {
            if let Some(law) = &world.setup.interfaces[bond.row as usize].bond {
                bond::force(bond, law, &world.bodies, 0.0, 0.0, &mut Works::default());
            }
        }
        let scratch = Scratch::new(&mut world, exec);
        (world, scratch)
    }
}

/// Gives driven blocks their prescribed velocity at the present time.
pub fn hold_driven(world: &mut World, shapes: &Shapes) {
    let t = world.time;
    let bodies = world.bodies.iter_mut().zip(&world.motion);
    for ((body, motion), centroid) in bodies.zip(&shapes.centroid) {
        if let Some(motion) = motion.as_deref() {
            let [x, y, spin] = motion.targets();
            body.velocity.x = x.at(t, body.velocity.x);
            body.velocity.y = y.at(t, body.velocity.y);
            body.spin = spin.at(t, body.spin);
            body.velocity += motion.swing(*centroid, body.angle, t, 0.0);
        }
    }
}

impl Scratch {
    /// Scratch data for a world, as new or as read from a checkpoint.
    #[must_use]
    pub fn new(world: &mut World, exec: Exec) -> Self {
        let shapes = Shapes::new(&world.setup);
        let n = shapes.len();
        let mut scratch = Self {
            exec,
            profile: Profile::default(),
            candidates: Candidates::default(),
            turned: shapes.edges.iter().map(|e| Turned::new(e, 1.0, 0.0)).collect(),
            slots: Vec::new(),
            ties: Vec::new(),
            bolts: Vec::new(),
            first_entry: Vec::new(),
            incidence: Vec::new(),
            changes: vec![Change::default(); n],
            coming_dt: 0.0,
            net: vec![Net::default(); n],
            applied: vec![Applied::default(); n],
            departure: Works::default(),
            entries: Entries::default(),
            laws: Vec::new(),
            partial: Vec::new(),
            workspaces: Vec::new(),
            stale: false,
            rebuilds: 0,
            transit: f64::INFINITY,
            shapes,
        };
        for b in 0..n {
            let range = scratch.shapes.range(b);
            turn(scratch.shapes.of(b), world.bodies[b].angle, &mut scratch.turned[range]);
        }
        scratch.rebuild(world);
        scratch.watch(world);
        scratch
    }

    /// Makes room for the last block of a setup, which is new.
    pub(crate) fn grow(&mut self, setup: &Setup) {
        let Some(block) = setup.blocks.last() else {
            return;
        };
        self.shapes.push(block);
        let b = self.shapes.len() - 1;
        self.turned.extend(self.shapes.of(b).iter().map(|e| Turned::new(e, 1.0, 0.0)));
        self.changes.push(Change::default());
        self.net.push(Net::default());
        self.applied.push(Applied::default());
    }

    /// Looks at the ways and the speeds of blocks: what the last step would have left behind.
    pub(crate) fn watch(&mut self, world: &World) {
        self.transit = f64::INFINITY;
        for (b, body) in world.bodies.iter().enumerate().filter(|(b, _)| world.alive[*b]) {
            let (moved, transit) = self.travel(world, b, body);
            self.stale |= moved;
            self.transit = self.transit.min(transit);
        }
    }

    /// Whether a block has left its margin, and the time it takes to cross its reach, s.
    fn travel(&self, world: &World, b: usize, body: &Body) -> (bool, f64) {
        travel(&self.shapes, &self.candidates, world.search_pose[b], b, body)
    }

    /// Marks the candidate list as out of date: blocks removed, supports or laws changed.
    pub fn invalidate(&mut self, world: &mut World) {
        world.search_pose = world.bodies.iter().map(|b| (b.position, b.angle)).collect();
        self.rebuild(world);
    }

    /// Rebuilds the candidate list from the world's search poses, and all that depends on it.
    fn rebuild(&mut self, world: &mut World) {
        search::rebuild(world, &self.shapes, &mut self.candidates);
        bond::set_masses(world, &self.shapes);
        self.laws = world.setup.interfaces.iter().map(|i| i.contact).collect();
        let (c, g, b) =
            (self.candidates.convex.len(), self.candidates.general.len(), world.bonds.len());
        self.ties = world.bolt_ties();
        self.bolts.clear();
        self.slots = vec![Wrench::default(); c + g + b + self.ties.len()];
        // The number of a slot says when it is added on its blocks, so that no thread has a say in it.
        let ends = self
            .candidates
            .convex
            .iter()
            .chain(&self.candidates.general)
            .map(|c| (c.i, c.j))
            .chain(world.bonds.iter().map(|b| (b.i, b.j)))
            .chain(self.ties.iter().copied());
        (self.first_entry, self.incidence) = incidence(self.shapes.len(), ends);
        let groups = [c, g, b, self.shapes.len()].into_iter().max().unwrap_or(0).div_ceil(GROUP);
        self.partial = vec![Partial::default(); groups.max(1)];
        self.workspaces.resize_with(self.exec.workspaces(g).max(1), Workspace::default);
        self.stale = false;
        self.rebuilds += 1;
    }
}

/// Compressed rows of (slot, side) per block, slots ascending.
fn incidence(
    blocks: usize,
    ends: impl Iterator<Item = (u32, u32)> + Clone,
) -> (Vec<u32>, Vec<u32>) {
    let mut first = vec![0u32; blocks + 1];
    for (i, j) in ends.clone() {
        first[i as usize + 1] += 1;
        first[j as usize + 1] += 1;
    }
    for b in 0..blocks {
        first[b + 1] += first[b];
    }
    let mut next = first.clone();
    let mut entries = vec![0u32; first[blocks] as usize];
    for (slot, (i, j)) in ends.enumerate() {
        for (side, b) in [(0, i), (1, j)] {
            entries[next[b as usize] as usize] = 2 * slot as u32 + side;
            next[b as usize] += 1;
        }
    }
    (first, entries)
}

fn turn(edges: &[super::shapes::Edge], angle: f64, turned: &mut [Turned]) {
    let (s, c) = libm::sincos(angle);
    for (edge, out) in edges.iter().zip(turned) {
        out.turn(edge, c, s);
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
    evaluate_with(world, scratch, damping, dt, &mut |_, _| {})
}

/// As [`evaluate`]; `own` may change the loads of laws of code ([`LoadKind::Own`]) once joints and contacts of the instant are known.
///
/// # Errors
/// A block with forces that are not finite.
pub fn evaluate_with(
    world: &mut World,
    scratch: &mut Scratch,
    damping: &Damping,
    dt: f64,
    own: &mut dyn FnMut(&mut World, &Scratch),
) -> Result<(), NonFinite> {
    if !world.setup.water.is_empty() {
        stage(scratch, "seepage", |scratch| {
            seepage::update(world, &scratch.shapes);
        });
    }
    stage(scratch, "loads", |scratch| {
        // A table that no longer stands leaves nothing behind.
        if !world.setup.loads.is_empty() || !world.setup.water.is_empty() {
            loads::apply(world, &scratch.shapes, dt, &mut scratch.applied);
        }
        water::apply(world, scratch);
    });
    stage(scratch, "search", |scratch| refresh(world, scratch));
    stage(scratch, "contacts", |scratch| {
        found_contacts(world, scratch, damping);
    });
    stage(scratch, "bonds", |scratch| bonds(world, scratch, damping));
    if !world.bolts.is_empty() {
        let first = world.pairs.len() + world.general.len() + world.bonds.len();
        stage(scratch, "bolts", |scratch| {
            bolts::act(world, &mut scratch.bolts, &mut scratch.slots[first..]);
        });
    }
    if world.setup.loads.iter().any(|load| matches!(load.kind, LoadKind::Own { .. })) {
        stage(scratch, "laws of code", |scratch| {
            own(world, scratch);
            loads::apply_own(world, &mut scratch.applied);
        });
    }
    let result = stage(scratch, "gather", |scratch| kicks(world, scratch, damping, dt));
    if !world.accounts.is_empty() {
        stage(scratch, "accounts", |scratch| {
            entries::book(world, scratch, damping, dt);
        });
    }
    // From here on the instant is done: another evaluation without a move books nothing twice.
    world.works.settle();
    world.pending = 0.0;
    scratch.coming_dt = dt;
    result
}

/// Applies the velocity changes and moves the blocks by `dt`.
pub fn advance(world: &mut World, scratch: &mut Scratch, dt: f64) {
    stage(scratch, "integrate", |scratch| {
        integrate(world, scratch, dt);
    });
    // Not booked by `evaluate`: that may be called again before this step is taken.
    world.works.depart(&mut scratch.departure);
    scratch.entries.depart(&mut world.accounts);
    world.time += dt;
    world.step += 1;
    world.last_dt = dt;
    world.pending = dt;
}

/// Ends a motion with the half kick of the forces that act now: velocities become those of the present time, as at the start, and whatever
/// comes next, an edit or other forces, begins with half a kick of its own.
///
/// # Errors
/// A block with forces that are not finite.
pub fn end_motion(
    world: &mut World,
    scratch: &mut Scratch,
    damping: &Damping,
) -> Result<(), NonFinite> {
    if world.last_dt == 0.0 {
        return Ok(());
    }
    evaluate(world, scratch, damping, 0.0)?;
    let before = View { world, scratch }.balance().residual();
    integrate(world, scratch, 0.0);
    world.works.depart(&mut scratch.departure);
    scratch.entries.depart(&mut world.accounts);
    world.last_dt = 0.0;
    // With the kick of nothing that is left to be read.
    evaluate(world, scratch, damping, 0.0)?;
    let after = View { world, scratch }.balance().residual();
    world.works.step_change += after - before;
    Ok(())
}

/// Does a stage and books its time.
fn stage<T>(scratch: &mut Scratch, name: &'static str, work: impl FnOnce(&mut Scratch) -> T) -> T {
    let begun = Begun::now(&scratch.exec);
    let result = work(scratch);
    scratch.profile.add(name, begun.spent(&scratch.exec));
    result
}

/// Rebuilds the candidate list when a block has moved more than its margin, or a joint gives way.
fn refresh(world: &mut World, scratch: &mut Scratch) {
    // Only once the blocks have moved: evaluating twice changes nothing.
    if world.pending > 0.0 && world.bonds.iter().any(bond::Bond::gives_way) {
        handover::hand_over(world, scratch);
    }
    if scratch.stale {
        scratch.invalidate(world);
    }
}

fn found_contacts(world: &mut World, scratch: &mut Scratch, damping: &Damping) {
    let begins = world.begins();
    let World { pairs, general, bodies, works: all_works, pending, .. } = world;
    let c = pairs.len();
    let (convex_slots, rest) = scratch.slots.split_at_mut(c);
    let general_slots = &mut rest[..general.len()];
    let context = Context {
        shapes: &scratch.shapes,
        turned: &scratch.turned,
        bodies,
        laws: &scratch.laws,
        lists: &scratch.candidates.lists,
        elapsed: *pending,
        stiffness_damping: damping.stiffness,
        begins,
    };
    scratch.partial.fill(Partial::default());
    let candidates = &scratch.candidates;
    scratch.exec.groups2(
        pairs,
        convex_slots,
        &mut scratch.partial,
        &mut nobody(c),
        |at, p, s, partial, ()| {
            let list = &candidates.convex[at..at + p.len()];
            contact::convex_chunk(&context, list, p, s, &mut partial.arrival);
        },
    );
    let mut works = arrivals(&mut scratch.partial, c);
    if !general.is_empty() {
        let count = general.len();
        scratch.partial.fill(Partial::default());
        scratch.exec.groups2(
            general,
            general_slots,
            &mut scratch.partial,
            &mut scratch.workspaces,
            |at, g, s, partial, workspace| {
                let list = &candidates.general[at..at + g.len()];
                contact::general_chunk(&context, list, g, s, workspace, &mut partial.arrival);
            },
        );
        works.add(&arrivals(&mut scratch.partial, count));
    }
    all_works.add(&works);
}

fn bonds(world: &mut World, scratch: &mut Scratch, damping: &Damping) {
    if world.bonds.is_empty() {
        return;
    }
    let World { bonds, bodies, setup, works: all_works, .. } = world;
    let (elapsed, step) = (world.pending, world.step);
    let first = world.pairs.len() + world.general.len();
    let count = bonds.len();
    let slots = &mut scratch.slots[first..first + count];
    scratch.partial.fill(Partial::default());
    scratch.exec.groups2(
        bonds,
        slots,
        &mut scratch.partial,
        &mut nobody(count),
        |_, b, s, partial, ()| {
            for (bond, slot) in b.iter_mut().zip(s) {
                *slot = match &setup.interfaces[bond.row as usize].bond {
                    Some(law) => {
                        let works = &mut partial.arrival;
                        let wrench =
                            bond::force(bond, law, bodies, damping.stiffness, elapsed, works);
                        if bond.broken_at.is_none() && bond.broken() {
                            bond.broken_at = Some(step);
                        }
                        wrench
                    }
                    None => Wrench::default(),
                };
            }
        },
    );
    all_works.add(&arrivals(&mut scratch.partial, count));
}

/// Rooms for work on `count` items that needs none.
fn nobody(count: usize) -> Vec<()> {
    vec![(); count.div_ceil(piece(count))]
}

/// Sum of the works of `count` items, one partial sum for each group of them.
fn arrivals(partial: &mut [Partial], count: usize) -> Works {
    let groups = &mut partial[..count.div_ceil(GROUP)];
    sums::tree(groups, |sum, other| sum.arrival.add(&other.arrival));
    groups.first().map_or(Works::default(), |all| all.arrival)
}

fn integrate(world: &mut World, scratch: &mut Scratch, dt: f64) {
    scratch.partial.fill(Partial::default());
    let (shapes, changes, candidates) = (&scratch.shapes, &scratch.changes, &scratch.candidates);
    let (alive, poses) = (&world.alive, &world.search_pose);
    scratch.exec.ragged(
        &mut world.bodies,
        &mut scratch.turned,
        &shapes.first,
        &mut scratch.partial,
        |at, bodies, turned, partial| {
            let base = shapes.first[at] as usize;
            for (k, body) in bodies.iter_mut().enumerate() {
                let b = at + k;
                if !alive[b] {
                    continue;
                }
                body.velocity += changes[b].velocity;
                body.spin += changes[b].spin;
                body.position += dt * body.velocity;
                let turning = dt * body.spin;
                body.angle += turning;
                let range = shapes.range(b);
                if turning != 0.0 {
                    let own = range.start - base..range.end - base;
                    turn(&shapes.edges[range], body.angle, &mut turned[own]);
                }
                let (moved, transit) = travel(shapes, candidates, poses[b], b, body);
                partial.moved |= moved;
                partial.transit = partial.transit.min(transit);
            }
        },
    );
    scratch.transit = scratch.partial.iter().fold(f64::INFINITY, |t, p| t.min(p.transit));
    scratch.stale |= scratch.partial.iter().any(|p| p.moved);
}

/// Whether block `b` has left its margin since `pose`, and the time it takes to cross its reach, s.
fn travel(
    shapes: &Shapes,
    candidates: &Candidates,
    pose: (Vec2, f64),
    b: usize,
    body: &Body,
) -> (bool, f64) {
    let moved = (body.position - pose.0).length() + (body.angle - pose.1).abs() * shapes.radius[b];
    let speed = body.velocity.length() + body.spin.abs() * shapes.radius[b];
    (moved > candidates.margin[b], candidates.reach[b] / speed)
}
