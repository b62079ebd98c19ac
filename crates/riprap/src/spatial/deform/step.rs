//! One step of the deformable blocks: forces on nodes, velocity changes, motion.
//!
//! The same leapfrog and the same books as for rigid blocks: works are trapezoidal with the half-step velocities, so that their
//! sum is exactly the change of `m v(n-1/2).v(n+1/2)/2`. While relaxing the masses are fictitious, the step is 1 s of no
//! meaning, and model time stands still.

use riprap_geom::{Mat3, Vec3};

use super::elements;
use super::hold::Hold;
use super::loads::Dashpot;
use super::store::{Body, Deform};
use super::workspace::{BODIES, Workspace};
use crate::dynamics::damping::Damping;
use crate::exec::Divide;
use crate::ledger::Works;
use crate::spatial::lanes::Width;
use crate::spatial::step::{NonFinite, Scratch};
use crate::spatial::world::World;

/// Sums of one piece of work.
#[derive(Clone, Copy, Debug, Default)]
pub struct Partial {
    arrival: Works,
    departure: Works,
    bad: Option<u32>,
    /// Sums of squares of the free part of net forces, of reactions and of external forces, N².
    squares: [f64; 3],
}

/// What is the same for all nodes.
struct Context<'a> {
    world: &'a World,
    deform: &'a Deform,
    work: &'a Workspace,
    damping: Damping,
    /// Halves of the step before and after the present time, s.
    half: [f64; 2],
    /// Time between the two half-step velocities, s.
    span: f64,
    /// Middle of the coming step, s, and what prescribed velocities are multiplied by there.
    drive: (f64, f64),
    width: Width,
}

/// Nodes of a run of bodies.
struct Piece<'a> {
    bodies: &'a [Body],
    first: usize,
    net: &'a mut [[f64; 3]],
    change: &'a mut [[f64; 3]],
    partial: &'a mut [Partial],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.bodies.split_at(middle * BODIES);
        let nodes = b[0].first as usize - a[0].first as usize;
        let (net, change) = (
            self.net.split_at_mut(nodes),
            self.change.split_at_mut(nodes),
        );
        let partial = self.partial.split_at_mut(middle);
        (
            Self {
                bodies: a,
                first: self.first,
                net: net.0,
                change: change.0,
                partial: partial.0,
            },
            Self {
                bodies: b,
                first: self.first + middle * BODIES,
                net: net.1,
                change: change.1,
                partial: partial.1,
            },
        )
    }
}

/// Finds the forces on nodes (those of bonds are in their slots) and the velocity changes for a step of `dt` (s).
pub(in crate::spatial) fn evaluate(
    world: &mut World,
    scratch: &mut Scratch,
    dt: f64,
) -> Result<(), NonFinite> {
    let Some(mut work) = scratch.deform.take() else {
        return Ok(());
    };
    let Some(deform) = world.deform.take() else {
        scratch.deform = Some(work);
        return Ok(());
    };
    super::loads::apply(world, &deform, &mut work);
    let result = forces(world, &deform, scratch, &mut work, dt);
    world.works.add(&result.0);
    world.deform = Some(deform);
    scratch.deform = Some(work);
    result.1.map_or(Ok(()), |block| Err(NonFinite { block }))
}

fn forces(
    world: &World,
    deform: &Deform,
    scratch: &Scratch,
    work: &mut Workspace,
    dt: f64,
) -> (Works, Option<u32>) {
    let mut net = std::mem::take(&mut work.net);
    let mut change = std::mem::take(&mut work.change);
    let mut partial = std::mem::take(&mut work.partial);
    let mut damping = scratch.damping;
    let mut drive = (world.time + 0.5 * dt, 1.0);
    if let Some(relax) = &deform.relax {
        damping.mass = relax.damping;
        damping.local = 0.0;
        drive = (world.time + 0.5 * relax.increment, relax.increment);
    }
    let context = Context {
        world,
        deform,
        work,
        damping,
        half: [0.5 * world.pending, 0.5 * dt],
        span: 0.5 * (world.last_dt + dt),
        drive,
        width: scratch.width,
    };
    let piece = Piece {
        bodies: &deform.bodies,
        first: 0,
        net: &mut net,
        change: &mut change,
        partial: &mut partial,
    };
    let count = deform.bodies.len().div_ceil(BODIES);
    scratch
        .exec
        .divided(piece, count, |_, piece| context.piece(piece));
    let (mut arrival, mut departure, mut bad) = (Works::default(), Works::default(), None);
    let mut squares = [0.0; 3];
    for p in &partial {
        arrival.add(&p.arrival);
        departure.add(&p.departure);
        bad = bad.or(p.bad);
        for (sum, x) in squares.iter_mut().zip(p.squares) {
            *sum += x;
        }
    }
    work.net = net;
    work.change = change;
    work.partial = partial;
    work.departure = departure;
    work.norms = squares.map(f64::sqrt);
    (arrival, bad)
}

impl Context<'_> {
    fn piece(&self, piece: Piece) {
        let mut partial = Partial::default();
        let base = piece.bodies[0].first as usize;
        let width = self.width;
        width.run(
            #[inline(always)]
            || {
                for (k, body) in piece.bodies.iter().enumerate() {
                    let nodes = body.nodes();
                    let here = nodes.start - base..nodes.end - base;
                    let f = &mut piece.net[here];
                    match self.work.start_forces.get(nodes.clone()) {
                        Some(start) => f.copy_from_slice(start),
                        None => f.fill([0.0; 3]),
                    }
                    if body.alive {
                        let u = &self.deform.nodes.moved[nodes];
                        let start = self.work.start_of(piece.first + k);
                        elements::add_forces(self.work.kind(body), body.strain, start, u, f);
                    }
                }
            },
        );
        let holds = &self.deform.holds;
        let mut hold = holds.partition_point(|h| (h.node as usize) < base);
        let dashpots = &self.work.dashpots;
        let mut dashpot = dashpots.partition_point(|d| (d.node as usize) < base);
        for (k, body) in piece.bodies.iter().enumerate() {
            let nodes = body.nodes();
            let here = nodes.start - base..nodes.end - base;
            if !body.alive {
                piece.change[here].fill([0.0; 3]);
                continue;
            }
            let f = &mut piece.net[here.clone()];
            self.gather(piece.first + k, body, f);
            let masses = self.work.kind(body).masses(self.deform.masses);
            for (at, node) in nodes.enumerate() {
                let own = holds.get(hold).filter(|h| h.node as usize == node);
                hold += usize::from(own.is_some());
                let drag = dashpots.get(dashpot).filter(|d| d.node as usize == node);
                dashpot += usize::from(drag.is_some());
                let weight = masses[at] * self.world.gravity;
                let of =
                    |list: &[[f64; 3]]| list.get(node).map_or(Vec3::ZERO, |l| Vec3::from_array(*l));
                let (load, push) = (of(&self.work.loads), of(&self.work.pushes));
                let net = Vec3::from_array(f[at]) + weight + load + push;
                f[at] = net.to_array();
                if !net.is_finite() && partial.bad.is_none() {
                    partial.bad = Some(body.block);
                }
                let mass = match self.work.fictitious.get(node) {
                    Some(mass) => *mass,
                    None => masses[at],
                };
                let acting = Acting {
                    node,
                    mass,
                    weight,
                    load,
                    push,
                    net,
                };
                piece.change[here.start + at] =
                    self.kick(&acting, own, drag, &mut partial).to_array();
            }
        }
        piece.partial[0] = partial;
    }

    /// Adds the forces of bonds to the nodes of body number `k`.
    fn gather(&self, k: usize, body: &Body, f: &mut [[f64; 3]]) {
        for hook in self.work.hooks_of(k) {
            let force = self.work.slots[hook.point as usize];
            let anchor = &self.deform.points[hook.point as usize].anchors[hook.side as usize];
            let sign = if hook.side == 0 { 1.0 } else { -1.0 };
            for (node, weight) in anchor.nodes.iter().zip(anchor.weights) {
                if weight == 0.0 {
                    continue;
                }
                let to = &mut f[(node - body.first) as usize];
                for axis in 0..3 {
                    to[axis] += sign * weight * force[axis];
                }
            }
        }
    }

    /// Velocity change of a node, with its works.
    fn kick(
        &self,
        node: &Acting,
        hold: Option<&Hold>,
        dashpot: Option<&Dashpot>,
        partial: &mut Partial,
    ) -> Vec3 {
        let v = Vec3::from_array(self.deform.nodes.rate[node.node]);
        let local = self.damping.local;
        let against = |k: usize| {
            if v[k] == 0.0 || local == 0.0 {
                0.0
            } else {
                -local * node.net[k].abs() * v[k].signum()
            }
        };
        let drag = Vec3::new(against(0), against(1), against(2));
        let alpha = self.damping.mass;
        let fade = 0.5 * alpha * self.span;
        let push = node.net + drag;
        let free = match dashpot {
            None => (self.span / node.mass * push - 2.0 * fade * v) / (1.0 + fade),
            Some(d) => {
                let inertia =
                    node.mass * (1.0 + fade) * Mat3::IDENTITY + 0.5 * self.span * d.matrix;
                let impulse = self.span * (push - d.matrix * v) - 2.0 * fade * node.mass * v;
                inertia.inverse() * impulse
            }
        };
        let mut change = free;
        let mut support = Vec3::ZERO;
        let [of_free, of_held, of_loads] = &mut partial.squares;
        *of_loads += (node.weight + node.load + node.push).length_squared();
        match hold {
            None => *of_free += node.net.length_squared(),
            Some(hold) => {
                let target = self.drive.1 * hold.velocity(self.drive.0);
                change = hold.free * free + (target - (v - hold.free * v));
                if self.span > 0.0 {
                    let gap = change - free;
                    support = node.mass * (1.0 + fade) / self.span * gap;
                    if let Some(d) = dashpot {
                        support += 0.5 * (d.matrix * gap);
                    }
                }
                let part = hold.free * node.net;
                *of_free += part.length_squared();
                *of_held += (node.net - part).length_squared();
            }
        }
        let damping = drag - alpha * node.mass * (v + 0.5 * change);
        let absorbed = dashpot.map_or(Vec3::ZERO, |d| d.matrix * (v + 0.5 * change));
        for (half, v, works) in [
            (self.half[0], v, &mut partial.arrival),
            (self.half[1], v + change, &mut partial.departure),
        ] {
            works.gravity += half * node.weight.dot(v);
            works.loads += half * node.load.dot(v);
            works.damping -= half * damping.dot(v);
            works.supports += half * support.dot(v);
            works.absorbed += half * absorbed.dot(v);
        }
        change
    }
}

/// What acts on a node.
struct Acting {
    node: usize,
    mass: f64,
    weight: Vec3,
    load: Vec3,
    push: Vec3,
    net: Vec3,
}

/// Pieces of the motion.
struct Moving<'a> {
    bodies: &'a [Body],
    moved: &'a mut [[f64; 3]],
    rate: &'a mut [[f64; 3]],
    change: &'a [[f64; 3]],
}

impl Divide for Moving<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.bodies.split_at(middle * BODIES);
        let nodes = b[0].first as usize - a[0].first as usize;
        let (moved, rate) = (
            self.moved.split_at_mut(nodes),
            self.rate.split_at_mut(nodes),
        );
        let change = self.change.split_at(nodes);
        (
            Self {
                bodies: a,
                moved: moved.0,
                rate: rate.0,
                change: change.0,
            },
            Self {
                bodies: b,
                moved: moved.1,
                rate: rate.1,
                change: change.1,
            },
        )
    }
}

/// Applies the velocity changes and moves the nodes by `dt` (s); returns the model time that passes, s.
pub(in crate::spatial) fn advance(world: &mut World, scratch: &mut Scratch, dt: f64) -> f64 {
    let (Some(deform), Some(work)) = (world.deform.as_deref_mut(), scratch.deform.as_deref_mut())
    else {
        return dt;
    };
    if let Some(relax) = &mut deform.relax {
        relax.look(&deform.nodes, work);
    }
    let moving = Moving {
        bodies: &deform.bodies,
        moved: &mut deform.nodes.moved,
        rate: &mut deform.nodes.rate,
        change: &work.change,
    };
    let count = deform.bodies.len().div_ceil(BODIES);
    scratch.exec.divided(moving, count, |_, piece| {
        for ((u, v), dv) in piece.moved.iter_mut().zip(piece.rate).zip(piece.change) {
            for k in 0..3 {
                v[k] += dv[k];
                u[k] += dt * v[k];
            }
        }
    });
    scratch.departure.add(&std::mem::take(&mut work.departure));
    match &mut deform.relax {
        Some(relax) => std::mem::take(&mut relax.increment),
        None => {
            note_peaks(deform, work, &mut world.peak_speed_squared);
            dt
        }
    }
}

/// Largest speed of each body's centroid so far.
fn note_peaks(deform: &Deform, work: &Workspace, peaks: &mut [f64]) {
    for body in deform.living() {
        let masses = work.kind(body).masses(deform.masses);
        let (mut sum, mut mass) = (Vec3::ZERO, 0.0);
        for (v, m) in deform.nodes.rate[body.nodes()].iter().zip(masses) {
            sum += *m * Vec3::from_array(*v);
            mass += m;
        }
        let peak = &mut peaks[body.block as usize];
        *peak = peak.max((sum / mass).length_squared());
    }
}
