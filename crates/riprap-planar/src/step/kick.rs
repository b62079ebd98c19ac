//! Sums of the forces on each block, and the change of velocity they make.

use riprap_geom::Vec2;

use super::{Damping, nobody};
use crate::dynamics::kick::{self, Support, Target};
use crate::scratch::{Change, Net, NonFinite, Partial, Scratch};
use crate::setup::Motion;
use crate::sums::{self, GROUP};
use crate::world::World;

/// Gathers the slots of each block and finds its velocity change.
pub(super) fn kicks(
    world: &mut World,
    scratch: &mut Scratch,
    damping: &Damping,
    dt: f64,
) -> Result<(), NonFinite> {
    // What the kick writes is taken out while it reads all else.
    let mut changes = std::mem::take(&mut scratch.changes);
    let mut net = std::mem::take(&mut scratch.net);
    let mut partial = std::mem::take(&mut scratch.partial);
    partial.fill(Partial::default());
    let kick = Kick::new(world, scratch, damping, dt);
    let count = changes.len();
    scratch.exec.groups2(
        &mut changes,
        &mut net,
        &mut partial,
        &mut nobody(count),
        |at, changes, net, partial, ()| {
            for (k, (change, net)) in changes.iter_mut().zip(net).enumerate() {
                kick.block(at + k, change, net, partial);
            }
        },
    );
    (scratch.changes, scratch.net, scratch.partial) = (changes, net, partial);
    let groups = &mut scratch.partial[..count.div_ceil(GROUP)];
    let bad = groups.iter().find_map(|p| p.bad);
    sums::tree(groups, |sum, other| {
        sum.arrival.add(&other.arrival);
        sum.departure.add(&other.departure);
    });
    let all = groups.first().copied().unwrap_or_default();
    world.works.add(&all.arrival);
    scratch.departure = all.departure;
    bad.map_or(Ok(()), |block| Err(NonFinite { block }))
}

/// Works (J/m) of what prescribes the motion of block `b`, before and after the present time, in the kick that was just found.
pub(super) fn of_support(
    world: &World,
    scratch: &Scratch,
    damping: &Damping,
    dt: f64,
    b: usize,
) -> [f64; 2] {
    let kick = Kick::new(world, scratch, damping, dt);
    let mut partial = Partial::default();
    kick.block(b, &mut Change::default(), &mut Net::default(), &mut partial);
    [partial.arrival.supports, partial.departure.supports]
}

/// What the kick of one block reads.
struct Kick<'a> {
    world: &'a World,
    scratch: &'a Scratch,
    damping: &'a Damping,
    /// Halves of the step before and after the present time, s.
    half: [f64; 2],
    /// Time between the two half-step velocities, s.
    span: f64,
}

impl<'a> Kick<'a> {
    fn new(world: &'a World, scratch: &'a Scratch, damping: &'a Damping, dt: f64) -> Self {
        Self {
            world,
            scratch,
            damping,
            half: [0.5 * world.pending, 0.5 * dt],
            span: 0.5 * (world.last_dt + dt),
        }
    }

    fn block(&self, b: usize, change: &mut Change, net: &mut Net, partial: &mut Partial) {
        if !self.world.alive[b] {
            *change = Change::default();
            return;
        }
        let scratch = self.scratch;
        let (mut force, mut moment) = self.gathered(b);
        let (mass, inertia) = (scratch.shapes.mass[b], scratch.shapes.inertia[b]);
        let (weight, load) = (mass * self.world.gravity, scratch.applied[b]);
        force += weight + load.force;
        moment += load.moment;
        *net = Net { force, moment };
        if !(force.x + force.y + moment).is_finite() && partial.bad.is_none() {
            partial.bad = Some(b as u32);
        }
        let body = &self.world.bodies[b];
        let motion = self.world.motion[b].as_deref();

        // Local damping: a share of the unbalanced force, against the motion.
        let local = self.damping.local;
        let against = |f: f64, v: f64| kick::local_drag(local, f, v);
        let drag = Vec2::new(against(force.x, body.velocity.x), against(force.y, body.velocity.y));
        let twist = against(moment, body.spin);
        // Mass damping acts on the mean of the velocities before and after (implicit, stable).
        let fade = kick::fade(self.damping.mass, self.span);
        let kicked =
            |v: f64, f: f64, m: f64| ((v * (1.0 - fade) + self.span * f / m) / (1.0 + fade)) - v;
        let dv = Vec2::new(
            kicked(body.velocity.x, force.x + drag.x, mass),
            kicked(body.velocity.y, force.y + drag.y, mass),
        );
        let dw = kicked(body.spin, moment + twist, inertia);
        let free = Change { velocity: dv, spin: dw };
        *change = motion.map_or(free, |motion| self.prescribed(b, motion, &free));
        let (dv, dw) = (change.velocity, change.spin);

        // Works before and after the present time, with the velocity of each half.
        if let Some(motion) = motion
            && self.span > 0.0
        {
            let [before, after] = self.support_works(b, motion, fade, change, &free);
            partial.arrival.supports += before;
            partial.departure.supports += after;
        }
        let damping = drag - kick::mass_drag(self.damping.mass, mass, body.velocity, dv);
        let slowing = twist - kick::mass_drag(self.damping.mass, inertia, body.spin, dw);
        for (half, v, w, works) in [
            (self.half[0], body.velocity, body.spin, &mut partial.arrival),
            (self.half[1], body.velocity + dv, body.spin + dw, &mut partial.departure),
        ] {
            works.gravity += half * weight.dot(v);
            works.loads += half * (load.force.dot(v) + load.moment * w);
            works.damping -= half * (damping.dot(v) + slowing * w);
            works.local -= half * (drag.dot(v) + twist * w);
        }
    }

    /// Sum of the forces and moments on a block, N/m and N.
    #[inline]
    fn gathered(&self, b: usize) -> (Vec2, f64) {
        let (mut force, mut moment) = (Vec2::ZERO, 0.0);
        let scratch = self.scratch;
        let [first, end] = [b, b + 1].map(|b| scratch.first_entry[b] as usize);
        for &entry in &scratch.incidence[first..end] {
            let slot = &scratch.slots[(entry >> 1) as usize];
            if entry & 1 == 0 {
                force += slot.force;
                moment += slot.moment_i;
            } else {
                force -= slot.force;
                moment += slot.moment_j;
            }
        }
        (force, moment)
    }

    /// Change of velocity of a block with prescribed motion, which were `free` without.
    fn prescribed(&self, b: usize, motion: &Motion, free: &Change) -> Change {
        let body = &self.world.bodies[b];
        let [x, y, spin] = motion.targets();
        let (time, half) = (self.world.time, self.half[1]);
        let of = |t: Target, v: f64, free: f64| t.change(v, free, time, half, self.span);
        let velocity = Vec2::new(
            of(x, body.velocity.x, free.velocity.x),
            of(y, body.velocity.y, free.velocity.y),
        );
        let swing = motion.swing(self.scratch.shapes.centroid[b], body.angle, time, 2.0 * half);
        Change { velocity: velocity + swing, spin: of(spin, body.spin, free.spin) }
    }

    /// Works (J/m) of what prescribes the motion of a block, before and after the present time.
    fn support_works(
        &self,
        b: usize,
        motion: &Motion,
        fade: f64,
        change: &Change,
        free: &Change,
    ) -> [f64; 2] {
        let (body, shapes) = (&self.world.bodies[b], &self.scratch.shapes);
        let (mass, inertia) = (shapes.mass[b], shapes.inertia[b]);
        let (dv, dw) = (change.velocity, change.spin);
        let [x, y, spin] = motion.targets().map(|t| f64::from(t.gives_velocity()));
        let push = Support::of(
            kick::reaction(mass, fade, self.span, dv - free.velocity),
            mass * dv * Vec2::new(x, y),
            self.span,
        );
        let twist = Support::of(
            kick::reaction(inertia, fade, self.span, dw - free.spin),
            inertia * dw * spin,
            self.span,
        );
        let along = push.works(self.half, [body.velocity, body.velocity + dv], Vec2::dot);
        let about = twist.works(self.half, [body.spin, body.spin + dw], |m, w| m * w);
        [along[0] + about[0], along[1] + about[1]]
    }
}
