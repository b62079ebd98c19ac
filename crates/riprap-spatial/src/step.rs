//! One step of the spatial engine.
//!
//! Leapfrog in two halves, so that a caller can look at the state in between, when positions and
//! forces belong to the same time: [`evaluate`] finds forces and the velocity changes they will
//! make, [`advance`] applies them and moves the blocks.

mod condition_work;
mod halving;

use crate::joint::patch;
use crate::setup::rotation::rotation;
use std::time::Instant;

use riprap_geom::{Quat, Vec3};

use crate::contact;
use crate::deform;
use crate::joint::forces;
use crate::joint::forces::{First, Memory, Shared};
use crate::joint::patch::Poses;
use crate::profile::Begun;
use crate::push;
use crate::push::bolts;
use crate::push::gas;
use crate::query::view::View;
use crate::rigid::bound::Bound;
use crate::rigid::gather;
use crate::rigid::implicit;
use crate::rigid::integrate;
use crate::setup::{Kinematics, LoadKind};
use crate::state::bodies::Turned;
use crate::state::patches::flag;
use crate::state::scratch::Lost;
pub use crate::state::scratch::{NonFinite, Scratch};
use crate::state::share;
use crate::state::sums;
use crate::state::world::World;
pub use halving::error;

/// Damping of a phase besides that of the contacts.
pub use crate::dynamics::damping::Damping;

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
    // Kept, so that `advance`, and whoever reads between the two halves,
    // finds the very kick that the works were booked for.
    scratch.damping = *damping;
    scratch.coming_dt = dt;
    share::apart::begin(world, scratch, contact::CHECK_INTERVAL, contact::quiet_for);
    // Before the loads: what seeping water pushes with follows from the heads that are found here.
    if !world.setup.water.is_empty() {
        stage(scratch, "seepage", |_| push::seepage::update(world));
    }
    stage(scratch, "loads", |scratch| {
        push::begin(scratch);
        let half = scratch.kick_halves(world);
        let (deform, loads) = (scratch.deform.as_deref(), &mut scratch.pushes.loads);
        push::loads::apply(world, deform, half, loads);
        if let Some(deform) = &world.deform {
            push::surface::apply(world, deform, half, loads);
        }
        push::water::apply(world, scratch);
    });
    stage(scratch, "kinematics", |scratch| change_over(world, scratch));
    // Before the search: a pair that its joint lets go must meet in this evaluation,
    // or its force would be missing for a step.
    let [meet, deformable] = stage(scratch, "search", |scratch| {
        contact::release(world, scratch);
        crate::contact::deformable::part(world, scratch);
        let meet = contact::refresh(world, scratch);
        // After the search, which lets pairs that were not looked at begin without force.
        implicit::adopt_released(world);
        [meet, crate::contact::deformable::refresh(world, scratch)]
    });
    stage(scratch, "cavities", |scratch| {
        push::cavity::act(world, scratch, dt);
    });
    if !world.bolts.is_empty() {
        stage(scratch, "bolts", |scratch| bolts::act(world, scratch));
    }
    if world.deform.is_some() {
        stage(scratch, "bonds", |scratch| {
            deform::bonds::update(world, scratch);
        });
    }
    stage(scratch, "patches", |scratch| patches(world, scratch));
    if world.implicit.is_some() {
        implicit::act(world, scratch, meet);
        if let Some(failed) = scratch.implicit.failed {
            // Nothing is booked yet: the instant can be evaluated again with a shorter step.
            return Err(NonFinite { block: failed.blocks[0] });
        }
    } else if meet {
        stage(scratch, "contacts", |scratch| contact::act(world, scratch));
    }
    if deformable {
        stage(scratch, "contacts", |scratch| {
            crate::contact::deformable::act(world, scratch);
        });
    }
    // Only now is it known how deep blocks lie in each other, whose energy is part of that of the start.
    if world.start_energy.is_none() {
        contact::begin(world, &scratch.desk, &scratch.exec);
    }
    if world.setup.loads.iter().any(|load| matches!(load.kind, LoadKind::Own { .. })) {
        stage(scratch, "laws of code", |scratch| {
            own(world, scratch);
            push::loads::apply_own(world, &mut scratch.pushes.loads);
        });
    }
    let mut result = stage(scratch, "gather", |scratch| gather::gather(world, scratch));
    if world.deform.is_some() {
        let nodes = stage(scratch, "nodes", |scratch| deform::step::evaluate(world, scratch, dt));
        result = result.and(nodes);
    }
    implicit::book(world, scratch);
    if !world.accounts.is_empty() {
        stage(scratch, "accounts", |scratch| condition_work::book(world, scratch));
    }
    // From here on the instant is done: another evaluation without a move finds
    // no time to make up for, and books nothing twice.
    world.works.settle();
    world.pending = 0.0;
    world.fresh = false;
    result
}

/// Applies the velocity changes and moves the blocks by `dt`.
pub fn advance(world: &mut World, scratch: &mut Scratch, dt: f64) {
    implicit::remember(world, scratch);
    stage(scratch, "integrate", |scratch| {
        integrate::integrate(world, scratch, dt);
    });
    contact::levels::depart(world, &scratch.desk, dt);
    let mut passed = dt;
    if world.deform.is_some() {
        passed = stage(scratch, "move nodes", |scratch| deform::step::advance(world, scratch, dt));
    }
    crate::contact::deformable::depart(world, scratch, dt);
    // Not booked by `evaluate`: that may be called again with another step or damping before this one is taken.
    world.works.depart(&mut scratch.departure);
    scratch.entries.depart(&mut world.accounts);
    // A step of a relaxation has no length in model time: what passes is the increment of what is driven.
    world.time += passed;
    world.step += 1;
    world.last_dt = dt;
    world.pending = dt;
}

/// Ends a motion with the half kick of the forces that act now: velocities become those of the present time, as at the start, and whatever
/// comes next, an edit or other forces, begins with half a kick of its own. A relaxing phase has no motion.
///
/// # Errors
/// A block with forces that are not finite.
pub fn end_motion(
    world: &mut World,
    scratch: &mut Scratch,
    damping: &Damping,
) -> Result<(), NonFinite> {
    let relaxes = world.deform.as_ref().is_some_and(|d| d.relax.is_some());
    if world.last_dt == 0.0 || relaxes {
        return Ok(());
    }
    evaluate(world, scratch, damping, 0.0)?;
    let before = View { world, scratch }.balance().residual();
    integrate::integrate(world, scratch, 0.0);
    contact::levels::depart(world, &scratch.desk, 0.0);
    if world.deform.is_some() {
        deform::step::advance(world, scratch, 0.0);
    }
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

/// First pass: forces of patches.
fn patches(world: &mut World, scratch: &mut Scratch) {
    scratch.need_drag(world, scratch.damping.stiffness);
    if world.step == 0 && world.fresh && !scratch.drag.is_empty() && scratch.strong {
        start_moving(world, scratch.damping.stiffness);
    }
    // A look between two steps must not age the memory; after an edit
    // the laws have to answer though nothing has moved.
    let live = world.pending > 0.0 || world.fresh;
    let own = scratch.own(world);
    let shared_out = scratch.share(world).is_some();
    if let Some(share) = &mut scratch.share {
        share.begin(&scratch.tiles, &world.patches);
    }
    let (list, tiles) = (&mut world.patches, &scratch.tiles);
    let shared = Shared {
        poses: Poses { bodies: &world.bodies, turned: &world.turned },
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
            normal_offset: &mut list.normal_offset,
            accumulated_slip: &mut list.accumulated_slip,
            wear: &mut list.wear,
        },
        net: [scratch.net.whole(), scratch.drag.whole()],
        slots: [slots.whole(), drag_slots.whole()],
        lost: &mut scratch.lost,
    };
    let count = tiles.list.len();
    let begun = Instant::now();
    scratch.exec.divided_own(work, count, own, |_, piece| forces::tile(&shared, piece));
    match &mut scratch.share {
        Some(share) if shared_out => {
            share.book(begun.elapsed());
            share.slots(&mut scratch.slots, &mut scratch.lost);
        }
        _ => sums::tree(&mut scratch.lost, Lost::add),
    }
    if let Some(all) = scratch.lost.first() {
        world.works.dissipate(all.friction, all.fracture);
        if let Some(implicit) = world.implicit.as_deref_mut() {
            implicit.lost_in_joints += all.friction + all.fracture;
        }
    }
    if world.implicit.is_some() {
        implicit::joints::withdraw(scratch);
    }
}

/// Marks the points that slide or open from the first instant.
fn start_moving(world: &mut World, stiffness_damping: f64) {
    for p in 0..world.patches.len() {
        let list = &world.patches;
        let class = &world.classes[list.class[p] as usize];
        let joint = patch::joint(&world.setup.interfaces, class);
        let poses = Poses { bodies: &world.bodies, turned: &world.turned };
        let points = poses.points(class, list.ends[p], list.flags[p] & flag::FINITE != 0);
        let start = patch::start(class, list.prestress.get(p));
        let beta = class.beta + stiffness_damping;
        world.patches.flags[p] |= patch::starts_moving(joint, class, &points, &start, beta);
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
        Kinematics::Automatic => world.setup.rotation_bound(),
        // Below any angle, so that blocks change over that have not turned at all.
        Kinematics::Finite => -1.0,
    };
    let mut changed = false;
    let cracks = gas::jumps(world);
    for b in 0..world.alive.len() {
        let vector = world.bodies.rotation(b);
        // What turns about a point with others stays on its circle from the first step on.
        let swings = world.motion[b].as_ref().is_some_and(|m| m.about().is_some());
        let bound = if swings { -1.0 } else { bound };
        if !world.alive[b] || world.turned[b].is_some() || vector.length() <= bound {
            continue;
        }
        world.turn_freely(b, rotation(vector));
        changed = true;
    }
    if !changed {
        return;
    }
    gas::change_over(world, &cracks);
    // Rows know small rotations alone: who has changed over is done one by one from now on.
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
    /// Lets a block use finite rotations from `attitude` on. Its angular momentum is what it was with small ones, the spin that of
    /// the turned block with this momentum; energies differ in second order of the rotation.
    fn turn_freely(&mut self, b: usize, attitude: Quat) {
        let (solid, spin) = (*self.solid_of(b), self.bodies.spin(b));
        let momentum = solid.inertia * spin;
        let [inertia, inverse] =
            [solid.inertia, solid.inverse].map(|tensor| patch::turned_inertia(&tensor, attitude));
        // What is prescribed stays as it is, whatever the momentum about other axes says.
        let bound = (self.motion[b].as_deref()).and_then(|motion| Bound::of(motion, inertia));
        let turned = match &bound {
            Some(bound) => bound.spin(spin, momentum),
            None => inverse * momentum,
        };
        let after = if bound.is_some() { inertia * turned } else { momentum };
        // At the switch the energy L.w/2 changes with the spin that belongs to a momentum that stays.
        self.works.edit_defect += 0.5 * (after.dot(turned) - momentum.dot(spin));
        let momentum = after;
        self.bodies.set_velocity(b, self.bodies.velocity(b), turned);
        self.turned[b] = Some(Box::new(Turned { attitude, momentum }));
    }

    /// Sets velocity (m/s) and spin (rad/s) of a rigid block at the present instant, with the angular momentum of that spin.
    pub fn set_spin(&mut self, b: usize, velocity: Vec3, spin: Vec3) {
        self.bodies.set_velocity(b, velocity, spin);
        let inertia = self.solid_of(b).inertia;
        if let Some(turned) = &mut self.turned[b] {
            turned.momentum = patch::turned_inertia(&inertia, turned.attitude) * spin;
        }
    }

    /// Changes a patch over to finite rotations with the tractions it has.
    fn make_finite(&mut self, p: usize) {
        let (class, ends) = (self.classes[self.patches.class[p] as usize], self.patches.ends[p]);
        let poses = Poses { bodies: &self.bodies, turned: &self.turned };
        let [before, after] = [false, true].map(|finite| poses.points(&class, ends, finite));
        let shifts: [[f64; 3]; 4] =
            std::array::from_fn(|q| [0, 1, 2].map(|k| after.at[q][k] - before.at[q][k]));
        self.patches.flags[p] |= flag::FINITE;
        // Most patches change over before they have moved; lists of offsets
        // are made for the first one that needs them.
        if shifts.as_flattened().iter().all(|s| *s == 0.0) {
            return;
        }
        self.patches.need_slip();
        self.patches.need_normal_offset();
        self.patches.flags[p] |= flag::OFFSET;
        for (q, shift) in shifts.iter().enumerate() {
            // The law takes offset and slip off the displacement, so what
            // the other form adds to that is added to these.
            self.patches.normal_offset[p][q] += shift[0];
            self.patches.slip[p][0][q] += shift[1];
            self.patches.slip[p][1][q] += shift[2];
        }
    }
}
