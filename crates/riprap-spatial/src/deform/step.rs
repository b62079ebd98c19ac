//! One step of the deformable blocks: forces on nodes, velocity changes, motion.
//!
//! The same leapfrog and the same ledger as for rigid blocks: works are trapezoidal with the half-step velocities, so that their
//! sum is exactly the change of `m v(n-1/2).v(n+1/2)/2`. While relaxing the masses are fictitious, the step is 1 s of no
//! meaning, and model time stands still.

use riprap_core::cut;
use riprap_geom::Vec3;

use crate::deform::elements;
use crate::deform::kick::Kick;
use crate::dynamics::damping::Damping;
use crate::exec::Divide;
use crate::lanes::Width;
use crate::laws::tetrahedron::StartStress;
use crate::state::deform::{Body, Deform};
use crate::state::links::Links;
use crate::state::push::Pushes;
use crate::state::scratch::{NonFinite, Scratch};
use crate::state::sums;
use crate::state::workspace::{BODIES, BlockClass, Dashpot, KickSums, Workspace, start_of};
use crate::state::world::World;

/// What is the same for all bodies.
struct Context<'a> {
    deform: &'a Deform,
    classes: &'a [BlockClass],
    starts: &'a [StartStress],
    start_forces: &'a [[f64; 3]],
    links: &'a Links,
    slots: &'a [[f64; 3]],
    kick: Kick<'a>,
}

/// Nodes of a run of bodies.
struct Piece<'a> {
    bodies: &'a [Body],
    first: usize,
    net: &'a mut [[f64; 3]],
    change: &'a mut [[f64; 3]],
    partial: &'a mut [KickSums],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let at = middle * BODIES;
        let nodes = (self.bodies[at].first - self.bodies[0].first) as usize;
        cut!(self, bodies: at, first: at, net: nodes, change: nodes, partial: middle)
    }
}

/// Finds the forces on nodes (those of bonds are in their slots) and the velocity changes for a step of `dt` (s).
pub(crate) fn evaluate(world: &mut World, scratch: &mut Scratch, dt: f64) -> Result<(), NonFinite> {
    let Some((deform, work)) = world.deform.as_deref().zip(scratch.deform.as_deref_mut()) else {
        return Ok(());
    };
    let felt = ContactStiffness {
        masses: [&work.masses, &work.fictitious],
        dashpots: &work.dashpots,
        pushes: &scratch.pushes,
    };
    let way = (scratch.damping, scratch.width);
    let context = Context {
        deform,
        classes: &work.classes,
        starts: &work.starts,
        start_forces: &work.start_forces,
        links: &work.links,
        slots: &work.slots,
        kick: felt.kick(world, deform, way, dt),
    };
    let partial = &mut work.partial;
    let piece = Piece {
        bodies: &deform.bodies,
        first: 0,
        net: &mut work.net,
        change: &mut work.change,
        partial: &mut *partial,
    };
    let count = deform.bodies.len().div_ceil(BODIES);
    scratch.exec.divided(piece, count, |_, piece| context.piece(piece));
    let bad = partial.iter().find_map(|p| p.bad);
    sums::tree(partial, |sum, other| {
        sum.arrival.add(&other.arrival);
        sum.departure.add(&other.departure);
        for (sum, x) in sum.squares.iter_mut().zip(other.squares) {
            *sum += x;
        }
    });
    let all = partial.first().copied().unwrap_or_default();
    work.departure = all.departure;
    work.norms = all.squares.map(f64::sqrt);
    world.works.add(&all.arrival);
    let holder = |node| deform.bodies.partition_point(|b| b.first <= node) - 1;
    let bad = bad.map(|node| deform.bodies[holder(node)].block);
    bad.map_or(Ok(()), |block| Err(NonFinite { block }))
}

/// What nodes feel in a kick besides their state.
struct ContactStiffness<'a> {
    /// Masses and fictitious ones, kg.
    masses: [&'a [f64]; 2],
    dashpots: &'a [Dashpot],
    pushes: &'a Pushes,
}

/// The kick of the nodes for a step of `dt` (s).
pub(crate) fn kick<'a>(
    world: &'a World,
    deform: &'a Deform,
    work: &'a Workspace,
    scratch: &'a Scratch,
    dt: f64,
) -> Kick<'a> {
    let (masses, dashpots) = ([&work.masses[..], &work.fictitious], &work.dashpots[..]);
    let pushes = &scratch.pushes;
    let felt = ContactStiffness { masses, dashpots, pushes };
    felt.kick(world, deform, (scratch.damping, scratch.width), dt)
}

impl<'a> ContactStiffness<'a> {
    fn kick(
        self,
        world: &World,
        deform: &'a Deform,
        (mut damping, width): (Damping, Width),
        dt: f64,
    ) -> Kick<'a> {
        let [masses, fictitious] = self.masses;
        let mut drive = (world.time + 0.5 * dt, 1.0);
        // A relaxation has a damping of its own, and driven nodes go by velocity times an increment of model time.
        if let Some(relax) = &deform.relax {
            damping.mass = relax.damping;
            damping.local = 0.0;
            drive = (world.time + 0.5 * relax.increment, relax.increment);
        }
        Kick {
            gravity: world.gravity,
            damping,
            half: [0.5 * world.pending, 0.5 * dt],
            span: 0.5 * (world.last_dt + dt),
            drive,
            velocity: &deform.nodes.velocity,
            masses,
            inertias: match fictitious.is_empty() {
                true => masses,
                false => fictitious,
            },
            loads: &self.pushes.loads.nodes,
            pushes: &self.pushes.own.nodes,
            holds: &deform.holds,
            places: (&deform.nodes.place, world.setup.origin),
            dashpots: self.dashpots,
            width,
        }
    }
}

impl Context<'_> {
    fn piece(&self, piece: Piece) {
        let Piece { bodies, first, net, change, partial } = piece;
        let base = bodies[0].first as usize;
        self.kick.width.run(
            #[inline(always)]
            || self.elements(bodies, first, net),
        );
        let mut sums = KickSums::default();
        let mut number = first;
        for run in bodies.chunk_by(|a, b| a.alive == b.alive) {
            let nodes = run[0].first as usize..run[run.len() - 1].nodes().end;
            let here = nodes.start - base..nodes.end - base;
            // The dead keep their nodes, so that numbers keep their meaning, and stand still.
            if run[0].alive {
                for (k, body) in run.iter().enumerate() {
                    let own = body.first as usize - base;
                    let f = &mut net[own..own + body.count as usize];
                    self.gather(number + k, body, f);
                }
                let (net, change) = (&mut net[here.clone()], &mut change[here]);
                self.kick.run(nodes.start, net, change, &mut sums);
            } else {
                change[here].fill([0.0; 3]);
            }
            number += run.len();
        }
        partial[0] = sums;
    }

    /// Sets the forces of the tetrahedra of the bodies number `first` and following.
    #[inline(always)]
    fn elements(&self, bodies: &[Body], first: usize, net: &mut [[f64; 3]]) {
        let base = bodies[0].first as usize;
        for (k, body) in bodies.iter().enumerate() {
            let nodes = body.nodes();
            let f = &mut net[nodes.start - base..nodes.end - base];
            match self.start_forces.get(nodes.clone()) {
                Some(start) => f.copy_from_slice(start),
                None => f.fill([0.0; 3]),
            }
            if body.alive {
                let u = &self.deform.nodes.displacement[nodes];
                let start = start_of(self.starts, first + k);
                elements::add_forces(&self.classes[body.class as usize], body.strain, start, u, f);
            }
        }
    }

    /// Adds the forces of bonds to the nodes of body number `k`.
    fn gather(&self, k: usize, body: &Body, f: &mut [[f64; 3]]) {
        for hook in self.links.hooks_of(k) {
            let force = self.slots[hook.point as usize];
            // A slot holds the force on the first side.
            let sign = [1.0, -1.0][hook.side()];
            // Most points hang on one node alone: no look at their anchor then.
            if let Some(to) = f.get_mut(hook.node() as usize) {
                for axis in 0..3 {
                    to[axis] += sign * force[axis];
                }
                continue;
            }
            let anchor = &self.deform.points[hook.point as usize].anchors[hook.side()];
            for (node, weight) in anchor.nodes() {
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
}

/// Pieces of the motion.
struct Moving<'a> {
    bodies: &'a [Body],
    displacement: &'a mut [[f64; 3]],
    velocity: &'a mut [[f64; 3]],
    change: &'a [[f64; 3]],
    masses: &'a [f64],
    speeds: &'a mut [f64],
}

impl Divide for Moving<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let at = middle * BODIES;
        let nodes = (self.bodies[at].first - self.bodies[0].first) as usize;
        cut!(
            self,
            bodies: at,
            displacement: nodes,
            velocity: nodes,
            change: nodes,
            masses: nodes,
            speeds: at,
        )
    }
}

/// Applies the velocity changes and moves the nodes by `dt` (s); returns the model time that passes, s.
pub(crate) fn advance(world: &mut World, scratch: &mut Scratch, dt: f64) -> f64 {
    let (Some(deform), Some(work)) = (world.deform.as_deref_mut(), scratch.deform.as_deref_mut())
    else {
        return dt;
    };
    // Before the move: the forces it judges belong to where the nodes are now.
    if let Some(relax) = &mut deform.relax {
        relax.look(&deform.nodes, work, &scratch.pushes.loads.nodes);
    }
    let moving = Moving {
        bodies: &deform.bodies,
        displacement: &mut deform.nodes.displacement,
        velocity: &mut deform.nodes.velocity,
        change: &work.change,
        masses: &work.masses,
        speeds: &mut work.speeds,
    };
    let count = deform.bodies.len().div_ceil(BODIES);
    scratch.exec.divided(moving, count, |_, piece| piece.go(dt, scratch.width));
    scratch.departure.add(&std::mem::take(&mut work.departure));
    match &mut deform.relax {
        Some(relax) => std::mem::take(&mut relax.increment),
        None => {
            // Only here: speeds of a relaxation mean nothing.
            let peaks = &mut world.peak_speed_squared;
            for (body, speed) in deform.bodies.iter().zip(&work.speeds) {
                if body.alive {
                    let peak = &mut peaks[body.block as usize];
                    *peak = peak.max(*speed);
                }
            }
            dt
        }
    }
}

impl Moving<'_> {
    /// Moves the nodes and finds the speeds of the centroids of the bodies.
    fn go(self, dt: f64, width: Width) {
        let displacement = self.displacement.as_flattened_mut().iter_mut();
        let velocity = self.velocity.as_flattened_mut().iter_mut();
        let change = self.change.as_flattened();
        width.run(
            #[inline(always)]
            || {
                for ((u, v), dv) in displacement.zip(velocity).zip(change) {
                    *v += dv;
                    *u += dt * *v;
                }
            },
        );
        let base = self.bodies[0].first as usize;
        for (body, speed) in self.bodies.iter().zip(self.speeds) {
            let nodes = body.nodes();
            let here = nodes.start - base..nodes.end - base;
            let (mut sum, mut mass) = (Vec3::ZERO, 0.0);
            for (v, m) in self.velocity[here.clone()].iter().zip(&self.masses[here]) {
                sum += *m * Vec3::from_array(*v);
                mass += m;
            }
            *speed = (sum / mass).length_squared();
        }
    }
}
