//! Velocity changes of blocks: mass, damping, prescribed motion, finite rotations.

use riprap_geom::{Mat3, Vec3};

use crate::dynamics::damping::Damping;
use crate::dynamics::kick;
use crate::dynamics::kick::{Support, Target};
use crate::joint::patch::turned_inertia;
use crate::ledger::Works;
use crate::rigid::bound::Bound;
use crate::setup::Motion;
use crate::state::bodies::{SolidClass, Turned};
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Velocity change of one block in the coming kick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Change {
    /// m/s.
    pub velocity: Vec3,
    /// rad/s; for a block with finite rotations at its present attitude.
    pub spin: Vec3,
    /// Change of angular momentum, N m s.
    pub momentum: Vec3,
}

/// Forces on a block: all but damping and supports, then contact dashpots.
#[derive(Clone, Copy, Debug, Default)]
pub struct Acting {
    /// Force, N.
    pub force: Vec3,
    /// Moment about the centroid, N m.
    pub moment: Vec3,
    /// Force of contact dashpots, N.
    pub drag: Vec3,
    /// Moment of contact dashpots, N m.
    pub drag_moment: Vec3,
}

/// The kick: what is the same for all blocks.
#[derive(Clone, Copy)]
pub struct Kick<'a> {
    /// Mass properties.
    pub solids: &'a [SolidClass],
    /// Index into `solids`, per block.
    pub solid: &'a [u32],
    /// Prescribed motion of the blocks.
    pub motion: &'a [Option<Box<Motion>>],
    /// Places of their centroids at the start, m.
    pub reference: &'a [Vec3],
    /// Gravity, m/s².
    pub gravity: Vec3,
    /// Present time, s.
    pub time: f64,
    /// Damping of the phase.
    pub damping: Damping,
    /// Half the density of the air times the drag coefficient, kg/m³.
    pub air: f64,
    /// Halves of the step before and after the present time, s.
    pub half: [f64; 2],
    /// Time between the two half-step velocities, s.
    pub span: f64,
}

/// Motion of one block before the kick.
#[derive(Clone, Copy)]
pub struct Moving<'a> {
    /// Velocity, m/s.
    pub velocity: Vec3,
    /// Spin, rad/s.
    pub spin: Vec3,
    /// State of finite rotations, if it has them.
    pub turned: Option<&'a Turned>,
}

/// Forces that are not in [`Acting`], for the works.
#[derive(Clone, Copy, Debug, Default)]
struct Extra {
    damping: Vec3,
    damping_moment: Vec3,
    local: Vec3,
    local_moment: Vec3,
    support: Support<Vec3>,
    support_moment: Support<Vec3>,
    /// What prescribes rotations has given the block on the way here, to keep them while its tensor of inertia turned, J.
    on_the_way: f64,
}

/// Spin (rad/s) and angular momentum (N m s) of a block at its present attitude before the kick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turning {
    pub(crate) spin: Vec3,
    pub(crate) momentum: Vec3,
}

impl Moving<'_> {
    /// The present tensor of inertia.
    fn inertia(&self, solid: &SolidClass) -> Mat3 {
        self.turned.map_or(solid.inertia, |t| turned_inertia(&solid.inertia, t.attitude))
    }

    /// Its inverse.
    pub(crate) fn inverse(&self, solid: &SolidClass) -> Mat3 {
        self.turned.map_or(solid.inverse, |t| turned_inertia(&solid.inverse, t.attitude))
    }

    /// Its rotation at the present attitude, `inverse` being the present inverse of its tensor. A turned block is carried on by its momentum; its
    /// spin is read off that at each attitude, but for what is prescribed.
    fn turning(&self, solid: &SolidClass, inverse: &Mat3, bound: Option<&Bound>) -> Turning {
        match (self.turned, bound) {
            (None, _) => Turning { spin: self.spin, momentum: solid.inertia * self.spin },
            (Some(turned), None) => {
                Turning { spin: *inverse * turned.momentum, momentum: turned.momentum }
            }
            (Some(turned), Some(bound)) => {
                let spin = bound.spin(self.spin, turned.momentum);
                let momentum = self.inertia(solid) * spin;
                Turning { spin, momentum }
            }
        }
    }
}

impl Kick<'_> {
    /// Mass properties of block `b`.
    #[must_use]
    pub fn solid_of(&self, b: usize) -> &SolidClass {
        &self.solids[self.solid[b] as usize]
    }

    /// By what mass damping and air make mass and moments of inertia of block `b` larger for forces that are not known yet.
    pub(crate) fn inertia_factors(&self, b: usize, velocity: Vec3) -> [f64; 2] {
        let [along, about] = self.rates(b, velocity);
        [along, about].map(|alpha| 1.0 + kick::fade(alpha, self.span))
    }

    /// Rates of damping proportional to mass and to inertia, 1/s. Air is damping with a rate that grows with the speed, `k A |v|/m`, so that it
    /// acts on the mean of the velocities before and after: A is the cross-section of a ball of the same volume.
    fn rates(&self, b: usize, velocity: Vec3) -> [f64; 2] {
        let Damping { mass, rotation, .. } = self.damping;
        let turn = rotation.unwrap_or(mass);
        if self.air == 0.0 {
            return [mass, turn];
        }
        let solid = self.solid_of(b);
        let radius = libm::cbrt(0.75 * solid.volume / std::f64::consts::PI);
        let area = std::f64::consts::PI * radius * radius;
        [mass + self.air * area * velocity.length() / solid.mass, turn]
    }

    /// Velocity change of block `b`.
    #[must_use]
    pub fn change(&self, b: usize, moving: &Moving, acting: &Acting) -> Change {
        self.full(b, moving, acting).0
    }

    /// Velocity change, and the forces that came in on the way.
    fn full(&self, b: usize, moving: &Moving, acting: &Acting) -> (Change, Extra) {
        let solid = self.solid_of(b);
        let (v, w) = (moving.velocity, moving.spin);
        let mass = solid.mass;
        let motion = self.motion[b].as_deref();
        let inverse = moving.inverse(solid);
        // Only what is prescribed asks for the tensor itself.
        let held = motion.map(|motion| (motion, moving.inertia(solid)));
        let bound = held.and_then(|(motion, inertia)| Bound::of(motion, inertia));
        // Spin belongs to the attitude now; a turned block's spin of half a step ago does not.
        let Turning { spin: now, momentum: before } =
            moving.turning(solid, &inverse, bound.as_ref());
        let local = self.damping.local;
        let against = |f: Vec3, v: Vec3| -> Vec3 {
            Vec3::from_array([0, 1, 2].map(|k| kick::local_drag(local, f[k], v[k])))
        };
        let drag = against(acting.force, v);
        let twist = against(acting.moment, w);
        let [alpha, alpha_turn] = self.rates(b, v);
        let fade = kick::fade(alpha, self.span);
        let fade_turn = kick::fade(alpha_turn, self.span);
        let push = acting.force + acting.drag + drag;
        let torque = acting.moment + acting.drag_moment + twist;
        let mut dv = kick::change(self.span / mass, push, fade, v);
        // Of the momentum and not of the spin: torques change that alike with small and with finite rotations.
        let mut dl = kick::change(self.span, torque, fade_turn, before);
        let mut dw = inverse * dl;
        let mut extra = Extra::default();
        if let Some((motion, inertia)) = held {
            let free = (dv, dl);
            (dv, dw) = self.prescribed(motion, v, now, dv, dw);
            let attitude = moving.turned.map(|t| t.attitude);
            dv += motion.swing(self.reference[b], attitude, self.time, 2.0 * self.half[1]);
            let [along, about] = motion.given();
            let mut blow = Vec3::ZERO;
            if let Some(bound) = &bound {
                let coupled = bound.couples();
                let given = dw;
                if coupled {
                    dw = bound.spin(given, free.1);
                }
                dl = inertia * dw;
                // What is given jumps at the present time, and takes the free part with it.
                blow = match coupled {
                    true => about * (inertia * bound.spin(given, Vec3::ZERO)),
                    false => about * dl,
                };
                if let Some(turned) = moving.turned {
                    extra.on_the_way = (bound.axes() * w).dot(before - turned.momentum);
                }
            } else {
                dl = inertia * dw;
            }
            // Before the first step the span may be nil; nothing needs to be held for no time.
            if self.span > 0.0 {
                let force = kick::reaction(mass, fade, self.span, dv - free.0);
                extra.support = Support::of(force, along * mass * dv, self.span);
                let moment = kick::reaction(1.0, fade_turn, self.span, dl - free.1);
                extra.support_moment = Support::of(moment, blow, self.span);
            }
        }
        (extra.local, extra.local_moment) = (drag, twist);
        extra.damping = acting.drag + drag - kick::mass_drag(alpha, mass, v, dv);
        extra.damping_moment =
            acting.drag_moment + twist - kick::mass_drag(alpha_turn, 1.0, before, dl);
        let change = Change { velocity: dv, spin: dw, momentum: dl };
        (change, extra)
    }

    /// Works on block `b` before and after the present time, each half with its velocity; `load` is the part of
    /// the force and moment that loads make.
    pub fn works(
        &self,
        b: usize,
        moving: &Moving,
        acting: &Acting,
        load: (Vec3, Vec3),
        arrival: &mut Works,
        departure: &mut Works,
    ) -> Change {
        let (change, extra) = self.full(b, moving, acting);
        let (v, w) = (moving.velocity, moving.spin);
        let weight = self.solid_of(b).mass * self.gravity;
        let after = [v + change.velocity, w + change.spin];
        if self.motion[b].is_some() {
            let along = (extra.support).works(self.half, [v, after[0]], Vec3::dot);
            let about = (extra.support_moment).works(self.half, [w, after[1]], Vec3::dot);
            arrival.supports += along[0] + about[0];
            // Seen again at the same instant, it has been booked.
            if self.half[0] > 0.0 {
                arrival.supports += extra.on_the_way;
            }
            departure.supports += along[1] + about[1];
        }
        for (half, v, w, works) in
            [(self.half[0], v, w, arrival), (self.half[1], after[0], after[1], departure)]
        {
            works.gravity += half * weight.dot(v);
            works.loads += half * (load.0.dot(v) + load.1.dot(w));
            works.damping -= half * (extra.damping.dot(v) + extra.damping_moment.dot(w));
            works.local -= half * (extra.local.dot(v) + extra.local_moment.dot(w));
        }
        change
    }

    /// Velocity change of a block whose motion is prescribed in some freedoms: a prescribed velocity is met
    /// in the middle of the step.
    fn prescribed(&self, motion: &Motion, v: Vec3, w: Vec3, dv: Vec3, dw: Vec3) -> (Vec3, Vec3) {
        let [along, about] = motion.targets();
        let of = |targets: &[Target; 3], v: Vec3, free: Vec3| {
            Vec3::from_array(
                [0, 1, 2]
                    .map(|k| targets[k].change(v[k], free[k], self.time, self.half[1], self.span)),
            )
        };
        (of(&along, v, dv), of(&about, w, dw))
    }
}

impl Scratch {
    /// Forces on block `b`.
    #[must_use]
    pub fn acting(&self, b: usize) -> Acting {
        let damped = !self.drag.is_empty();
        Acting {
            force: self.net.force(b),
            moment: self.net.moment(b),
            drag: if damped { self.drag.force(b) } else { Vec3::ZERO },
            drag_moment: if damped { self.drag.moment(b) } else { Vec3::ZERO },
        }
    }

    /// The coming kick.
    #[must_use]
    pub fn kick<'a>(&self, world: &'a World) -> Kick<'a> {
        Kick {
            solids: &world.solids,
            solid: &world.solid,
            motion: &world.motion,
            reference: &world.reference,
            ..self.no_workspace(world)
        }
    }

    /// The coming kick without the lists of blocks: who changes other parts of the world while it lasts adds them himself.
    #[must_use]
    pub fn no_workspace(&self, world: &World) -> Kick<'static> {
        Kick {
            solids: &[],
            solid: &[],
            motion: &[],
            reference: &[],
            gravity: world.gravity,
            time: world.time,
            damping: self.damping,
            air: world.setup.air,
            // `pending` and not the last step: seen again at the same instant, the half before it has been booked.
            half: [0.5 * world.pending, 0.5 * self.coming_dt],
            // Velocities belong to the middles of steps: a kick leads from the one to the next.
            // Half of each step. Before the first one (`last_dt` is 0) velocities are those
            // of now, and half a kick makes them those of its middle.
            span: 0.5 * (world.last_dt + self.coming_dt),
        }
    }

    /// Halves of the steps before and after the present time that the coming kick spans, s; nil in a relaxation, in which no time passes.
    #[must_use]
    pub(crate) fn kick_halves(&self, world: &World) -> [f64; 2] {
        match world.deform.as_ref().is_some_and(|d| d.relax.is_some()) {
            true => [0.0; 2],
            false => [0.5 * world.last_dt, 0.5 * self.coming_dt],
        }
    }

    /// Velocity change of block `b` in the coming kick.
    #[must_use]
    pub fn change(&self, world: &World, b: usize) -> Change {
        if world.alive[b] && !world.deforms(b) {
            self.kick(world).change(b, &world.moving(b), &self.acting(b))
        } else {
            Change::default()
        }
    }
}

impl World {
    /// Motion of block `b` half a step ago.
    #[must_use]
    pub fn moving(&self, b: usize) -> Moving<'_> {
        Moving {
            velocity: self.bodies.velocity(b),
            spin: self.bodies.spin(b),
            turned: self.turned[b].as_deref(),
        }
    }

    /// 1 for each freedom along, and about, x, y, z that is not prescribed, else 0.
    #[must_use]
    pub fn freedoms(&self, b: usize) -> [Vec3; 2] {
        let prescribed = self.motion[b].as_ref().map(|m| m.prescribes());
        prescribed.unwrap_or_default().map(|held| {
            let free = held.map(|held| if held { 0.0 } else { 1.0 });
            Vec3::from_array(free)
        })
    }

    /// The change `change` of block `b` without the freedoms whose velocity is given.
    #[must_use]
    pub fn ungiven(&self, b: usize, change: Change) -> Change {
        let Some(motion) = &self.motion[b] else {
            return change;
        };
        let [along, about] = motion.given().map(|given| Vec3::ONE - given);
        let velocity = along * change.velocity;
        let inertia = self.moving(b).inertia(self.solid_of(b));
        match Bound::of(motion, inertia).filter(Bound::couples) {
            // Without the jump of what is given, which takes the free part with it.
            Some(bound) => {
                let spin = bound.spin(Vec3::ZERO, change.momentum);
                Change { velocity, spin, momentum: inertia * spin }
            }
            None => {
                Change { velocity, spin: about * change.spin, momentum: about * change.momentum }
            }
        }
    }

    /// Rotation of block `b` at its present attitude before the kick.
    #[must_use]
    pub(crate) fn turning(&self, b: usize) -> Turning {
        let moving = self.moving(b);
        let solid = self.solid_of(b);
        let motion = self.motion[b].as_deref();
        let bound = motion.and_then(|motion| Bound::of(motion, moving.inertia(solid)));
        moving.turning(solid, &moving.inverse(solid), bound.as_ref())
    }

    /// Whether block `b` can move in any freedom by forces.
    #[must_use]
    pub fn is_free(&self, b: usize) -> bool {
        self.freedoms(b) != [Vec3::ZERO; 2]
    }

    /// Gives driven blocks their prescribed velocity at the present time.
    pub fn hold_driven(&mut self) {
        let t = self.time;
        for (b, motion) in self.motion.iter().enumerate() {
            let Some(motion) = motion.as_deref() else {
                continue;
            };
            let [along, about] = motion.targets();
            let now = |targets: &[Target; 3], v: Vec3| {
                Vec3::from_array([0, 1, 2].map(|k| targets[k].at(t, v[k])))
            };
            let attitude = self.turned[b].as_ref().map(|t| t.attitude);
            let v = now(&along, self.bodies.velocity(b))
                + motion.swing(self.reference[b], attitude, t, 0.0);
            let w = now(&about, self.bodies.spin(b));
            self.bodies.set_velocity(b, v, w);
            let solid = &self.solids[self.solid[b] as usize];
            // It is the momentum that moves a turned block: without this it would go on with its old one.
            if let Some(turned) = &mut self.turned[b] {
                turned.momentum = turned_inertia(&solid.inertia, turned.attitude) * w;
            }
        }
    }
}

/// Attitude after `dt` (s) with constant angular momentum, and the spin on the way (space frame).
///
/// Implicit midpoint with the Cayley map: the body-frame momentum follows from the constant one in space, and the
/// rotational energy is conserved to round-off (Austin, Krishnaprasad & Wang 1993, J. Comput. Phys. 107,
/// 105-117).
#[must_use]
pub(crate) fn turn(
    attitude: riprap_geom::Quat,
    momentum: Vec3,
    inverse: &Mat3,
    dt: f64,
) -> (riprap_geom::Quat, Vec3) {
    let body = attitude.conjugate() * momentum;
    let mut omega = *inverse * body;
    // Each round gains a factor of about dt |omega|, the angle of the step.
    for _ in 0..50 {
        let after = cayley(-dt * omega) * body;
        let next = *inverse * (0.5 * (body + after));
        // With `<=`, a block without momentum ends at once.
        let close = (next - omega).length() <= 1e-15 * next.length();
        omega = next;
        if close {
            break;
        }
    }
    // Products of rotations lose their length by round-off, step after step.
    let after = (attitude * cayley(dt * omega)).normalize();
    // The mean of both attitudes turns the body-frame spin into space.
    (after, 0.5 * (attitude * omega + after * omega))
}

/// Rotation of the Cayley map of a rotation vector.
fn cayley(vector: Vec3) -> riprap_geom::Quat {
    let half = 0.5 * vector;
    riprap_geom::Quat::from_xyzw(half.x, half.y, half.z, 1.0).normalize()
}
