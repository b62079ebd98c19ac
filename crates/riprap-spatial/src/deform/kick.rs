//! Velocity changes of nodes and the works that go with them.
//!
//! Nodes on which nothing is prescribed and no dashpot acts go eight at a time, with the same arithmetic and the same
//! order of all sums as one by one.

use riprap_geom::{Mat3, Vec3};

use crate::dynamics::damping::Damping;
use crate::dynamics::kick;
use crate::dynamics::kick::Support;
use crate::lanes::{LANES, Lanes, Vectors, Width, dot, minus, plus, scaled, vectors, write};
use crate::state::hold::Hold;
use crate::state::workspace::{Dashpot, KickSums};

/// What is the same for all nodes, and lists by node.
#[derive(Clone, Copy)]
pub(crate) struct Kick<'a> {
    /// m/s².
    pub gravity: Vec3,
    /// Damping.
    pub damping: Damping,
    /// Halves of the step before and after the present time, s.
    pub half: [f64; 2],
    /// Time between the two half-step velocities, s.
    pub span: f64,
    /// Middle of the coming step, s, and what prescribed velocities are multiplied by there.
    pub drive: (f64, f64),
    /// Velocities half a step ago, m/s.
    pub velocity: &'a [[f64; 3]],
    /// Masses, kg.
    pub masses: &'a [f64],
    /// What the span is divided by: masses, or fictitious ones, kg.
    pub inertias: &'a [f64],
    /// External loads without gravity, N; empty without any.
    pub loads: &'a [[f64; 3]],
    /// What cavities push with, N; empty without any.
    pub pushes: &'a [[f64; 3]],
    /// Prescribed motion, by node.
    pub holds: &'a [Hold],
    /// Places of the nodes at the start, m (local), and of the local origin, m.
    pub places: (&'a [Vec3], Vec3),
    /// Dashpots, by node.
    pub dashpots: &'a [Dashpot],
    /// Instruction set.
    pub width: Width,
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

/// A node in a kick if nothing holds it.
struct Free {
    /// Local damping, N.
    drag: Vec3,
    /// Velocity change, m/s.
    change: Vec3,
}

/// What holds or drives a node in a kick.
pub(crate) struct Held {
    /// Velocity change, m/s.
    change: Vec3,
    /// Its force and its blow.
    pub(crate) support: Support<Vec3>,
}

impl Kick<'_> {
    /// Turns the forces (N) of bodies and bonds on the nodes `first` and following into net forces, finds their velocity
    /// changes (m/s), and adds to the sums.
    pub(crate) fn run(
        &self,
        first: usize,
        net: &mut [[f64; 3]],
        change: &mut [[f64; 3]],
        sums: &mut KickSums,
    ) {
        self.width.run(
            #[inline(always)]
            || self.nodes(first, net, change, sums),
        );
    }

    #[inline(always)]
    fn nodes(
        &self,
        first: usize,
        net: &mut [[f64; 3]],
        change: &mut [[f64; 3]],
        sums: &mut KickSums,
    ) {
        let mut hold = self.holds.partition_point(|h| (h.node as usize) < first);
        let mut dashpot = self.dashpots.partition_point(|d| (d.node as usize) < first);
        let runs = net.chunks_mut(LANES).zip(change.chunks_mut(LANES));
        for (k, (net, change)) in runs.enumerate() {
            let node = first + k * LANES;
            let end = node + net.len();
            let held = self.holds.get(hold).is_some_and(|h| (h.node as usize) < end);
            let drawn = self.dashpots.get(dashpot).is_some_and(|d| (d.node as usize) < end);
            if let (false, Ok(net), Ok(change)) = (
                held || drawn,
                <&mut [[f64; 3]; LANES]>::try_from(&mut *net),
                <&mut [[f64; 3]; LANES]>::try_from(&mut *change),
            ) && self.eight(node, net, change, sums)
            {
                continue;
            }
            self.singly(node, net, change, (&mut hold, &mut dashpot), sums);
        }
    }

    /// Eight free nodes; false, and nothing done, where a force is not finite.
    #[inline(always)]
    fn eight(
        &self,
        node: usize,
        net: &mut [[f64; 3]; LANES],
        change: &mut [[f64; 3]; LANES],
        sums: &mut KickSums,
    ) -> bool {
        let all = |v: Vec3| v.to_array().map(Lanes::all);
        let mass = Lanes::at(self.masses, node);
        let weight = scaled(mass, &all(self.gravity));
        let (load, push, v) = (
            eight_of(self.loads, node),
            eight_of(self.pushes, node),
            eight_of(self.velocity, node),
        );
        let force = plus(&plus(&plus(&vectors(net), &weight), &load), &push);
        let square = dot(&force, &force);
        // Which node it is, `singly` finds out; nothing has been written yet.
        if !square.0.iter().all(|x| x.is_finite()) {
            return false;
        }
        let (local, alpha) = (self.damping.local, self.damping.mass);
        let mut drag = Vectors::default();
        if local != 0.0 {
            for axis in 0..3 {
                drag[axis] = force[axis].with(v[axis], |f, v| kick::local_drag(local, f, v));
            }
        }
        let fade = kick::fade(alpha, self.span);
        // Factor by factor as `dynamics::kick::change` for a single node: the same bits.
        let impulse =
            scaled(Lanes::all(self.span) / Lanes::at(self.inertias, node), &plus(&force, &drag));
        let kept = minus(&impulse, &scaled(Lanes::all(2.0 * fade), &v));
        let dv = kept.map(|x| x / Lanes::all(1.0 + fade));
        write(&force, net);
        write(&dv, change);
        add(&mut sums.squares[0], square);
        self.book(node, [&weight, &load, &push], [&v, &dv, &drag], sums);
        true
    }

    /// Adds the works of eight free nodes, with their weight, loads and pushes (N), velocity and its change (m/s), and local damping (N).
    #[inline(always)]
    fn book(
        &self,
        node: usize,
        [weight, load, push]: [&Vectors; 3],
        [v, dv, drag]: [&Vectors; 3],
        sums: &mut KickSums,
    ) {
        let (local, alpha) = (self.damping.local, self.damping.mass);
        let after = plus(v, dv);
        let [before, behind] = self.half.map(Lanes::all);
        let (arrival, departure) = (&mut sums.arrival, &mut sums.departure);
        let loaded = !self.loads.is_empty();
        if loaded || !self.pushes.is_empty() || self.gravity != Vec3::ZERO {
            let external = plus(&plus(weight, load), push);
            add(&mut sums.squares[2], dot(&external, &external));
            add(&mut arrival.gravity, before * dot(weight, v));
            add(&mut departure.gravity, behind * dot(weight, &after));
        }
        if loaded {
            add(&mut arrival.loads, before * dot(load, v));
            add(&mut departure.loads, behind * dot(load, &after));
        }
        if local != 0.0 || alpha != 0.0 {
            let mean = plus(v, &scaled(Lanes::all(0.5), dv));
            let inertia = Lanes::at(self.inertias, node);
            let damping = minus(drag, &scaled(Lanes::all(alpha) * inertia, &mean));
            add(&mut arrival.damping, -(before * dot(&damping, v)));
            add(&mut departure.damping, -(behind * dot(&damping, &after)));
        }
        if local != 0.0 {
            add(&mut arrival.local, -(before * dot(drag, v)));
            add(&mut departure.local, -(behind * dot(drag, &after)));
        }
    }

    /// Some nodes, one by one; counts on in the holds and dashpots.
    #[inline(never)]
    fn singly(
        &self,
        first: usize,
        net: &mut [[f64; 3]],
        change: &mut [[f64; 3]],
        (hold, dashpot): (&mut usize, &mut usize),
        sums: &mut KickSums,
    ) {
        for (k, (f, change)) in net.iter_mut().zip(change).enumerate() {
            let node = first + k;
            let own = self.holds.get(*hold).filter(|h| h.node as usize == node);
            *hold += usize::from(own.is_some());
            let drag = self.dashpots.get(*dashpot).filter(|d| d.node as usize == node);
            *dashpot += usize::from(drag.is_some());
            // The weight is that of the true mass, whatever mass moves the node.
            let weight = self.masses[node] * self.gravity;
            let of =
                |list: &[[f64; 3]]| list.get(node).map_or(Vec3::ZERO, |l| Vec3::from_array(*l));
            let (load, push) = (of(self.loads), of(self.pushes));
            let net = Vec3::from_array(*f) + weight + load + push;
            *f = net.to_array();
            if !net.is_finite() && sums.bad.is_none() {
                sums.bad = Some(node as u32);
            }
            let acting = Acting { node, mass: self.inertias[node], weight, load, push, net };
            *change = self.one(&acting, own, drag, sums).to_array();
        }
    }

    /// Velocity change of a node, with its works.
    fn one(
        &self,
        node: &Acting,
        hold: Option<&Hold>,
        dashpot: Option<&Dashpot>,
        sums: &mut KickSums,
    ) -> Vec3 {
        let v = Vec3::from_array(self.velocity[node.node]);
        let Free { drag, change: free } = self.free(node.node, node.net, dashpot);
        let mut change = free;
        let mut support = Support::default();
        let [of_free, of_held, of_loads] = &mut sums.squares;
        *of_loads += (node.weight + node.load + node.push).length_squared();
        match hold {
            None => *of_free += node.net.length_squared(),
            Some(hold) => {
                let held = self.hold(hold, dashpot, free);
                (change, support) = (held.change, held.support);
                let part = hold.free * node.net;
                *of_free += part.length_squared();
                *of_held += (node.net - part).length_squared();
            }
        }
        let alpha = self.damping.mass;
        let damping = drag - kick::mass_drag(alpha, node.mass, v, change);
        let absorbed = dashpot.map_or(Vec3::ZERO, |d| d.matrix * (v + 0.5 * change));
        for (half, v, works) in
            [(self.half[0], v, &mut sums.arrival), (self.half[1], v + change, &mut sums.departure)]
        {
            works.gravity += half * node.weight.dot(v);
            works.loads += half * node.load.dot(v);
            works.damping -= half * damping.dot(v);
            works.local -= half * drag.dot(v);
            works.absorbed += half * absorbed.dot(v);
        }
        let [before, after] = support.works(self.half, [v, v + change], Vec3::dot);
        sums.arrival.supports += before;
        sums.departure.supports += after;
        change
    }

    /// What the kick would do to a node with the net force `net` (N) if nothing held it.
    fn free(&self, node: usize, net: Vec3, dashpot: Option<&Dashpot>) -> Free {
        let (v, mass) = (Vec3::from_array(self.velocity[node]), self.inertias[node]);
        let local = self.damping.local;
        let drag = Vec3::from_array([0, 1, 2].map(|k| kick::local_drag(local, net[k], v[k])));
        let fade = kick::fade(self.damping.mass, self.span);
        let push = net + drag;
        let change = match dashpot {
            None => kick::change(self.span / mass, push, fade, v),
            Some(d) => {
                // Dashpots act on the mean of the velocities before and after, as
                // mass damping does: no step is too long for them.
                let inertia = mass * (1.0 + fade) * Mat3::IDENTITY + 0.5 * self.span * d.matrix;
                let impulse = self.span * (push - d.matrix * v) - 2.0 * fade * mass * v;
                inertia.inverse() * impulse
            }
        };
        Free { drag, change }
    }

    /// What holds or drives a node whose velocity would change by `free` (m/s) without it.
    fn hold(&self, hold: &Hold, dashpot: Option<&Dashpot>, free: Vec3) -> Held {
        let node = hold.node as usize;
        let (v, mass) = (Vec3::from_array(self.velocity[node]), self.inertias[node]);
        let place = self.places.0[node] + self.places.1;
        let target = self.drive.1 * hold.velocity(self.drive.0, place);
        let change = hold.free * free + (target - (v - hold.free * v));
        let mut support = Support::default();
        if self.span > 0.0 {
            let fade = kick::fade(self.damping.mass, self.span);
            let gap = change - free;
            let mut reaction = kick::reaction(mass, fade, self.span, gap);
            // The dashpot feels half of what the hold changes, and what it makes of that the hold must bear.
            if let Some(d) = dashpot {
                reaction += 0.5 * (d.matrix * gap);
            }
            // In the held directions alone: there the velocity jumps now, whatever the span.
            let blow = mass * (change - hold.free * change);
            support = Support::of(reaction, blow, self.span);
        }
        Held { change, support }
    }

    /// What holds or drives a node on which the net force (N) acts.
    pub(crate) fn held(&self, hold: &Hold, net: [f64; 3]) -> Held {
        let place = self.dashpots.binary_search_by_key(&hold.node, |d| d.node);
        let dashpot = place.ok().map(|k| &self.dashpots[k]);
        let free = self.free(hold.node as usize, Vec3::from_array(net), dashpot);
        self.hold(hold, dashpot, free.change)
    }
}

/// Eight vectors of a list by node; zero where the list is empty.
#[inline(always)]
fn eight_of(list: &[[f64; 3]], node: usize) -> Vectors {
    match list.get(node..).and_then(|l| l.first_chunk()) {
        Some(eight) => vectors(eight),
        None => Vectors::default(),
    }
}

/// Adds the lanes to a sum, in their order.
#[inline(always)]
fn add(sum: &mut f64, lanes: Lanes) {
    for x in lanes.0 {
        *sum += x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Velocity changes and sums of some nodes with a hold on node 12 and a dashpot on node 30.
    fn kicked(width: Option<Width>, damping: Damping, loaded: bool) -> (Vec<[f64; 3]>, KickSums) {
        let mut seed = 3_u64;
        let mut draw = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let count = 45;
        let mut list =
            || -> Vec<[f64; 3]> { (0..count).map(|_| [draw(), draw(), draw()]).collect() };
        let (mut net, velocity, loads, pushes) = (list(), list(), list(), list());
        let masses: Vec<f64> = velocity.iter().map(|r| 1.5 + r[0]).collect();
        let mut hold = Hold::new(12);
        hold.add(Vec3::X, None, None);
        let dashpot = Dashpot { node: 30, matrix: Mat3::from_diagonal(Vec3::new(0.1, 0.2, 0.3)) };
        let kick = Kick {
            gravity: Vec3::new(0.0, 0.5, -9.81),
            damping,
            half: [0.05, 0.06],
            span: 0.11,
            drive: (0.0, 1.0),
            velocity: &velocity,
            masses: &masses,
            inertias: &masses,
            loads: if loaded { &loads } else { &[] },
            pushes: if loaded { &pushes } else { &[] },
            holds: &[hold],
            places: (&vec![Vec3::ZERO; count], Vec3::ZERO),
            dashpots: &[dashpot],
            width: width.unwrap_or(Width::PLAIN),
        };
        let (mut change, mut sums) = (vec![[0.0; 3]; count], KickSums::default());
        match width {
            Some(_) => kick.run(0, &mut net, &mut change, &mut sums),
            None => kick.singly(0, &mut net, &mut change, (&mut 0, &mut 0), &mut sums),
        }
        change.extend(net);
        (change, sums)
    }

    #[test]
    fn eight_at_a_time_gives_the_bits_of_one_by_one() {
        let none = Damping::default();
        let mass = Damping { mass: 0.7, ..none };
        let local = Damping { local: 0.8, ..none };
        for (damping, loaded) in [(none, false), (mass, true), (local, true), (mass, false)] {
            let single = kicked(None, damping, loaded);
            for width in [Width::PLAIN, Width::detect()] {
                let eight = kicked(Some(width), damping, loaded);
                assert_eq!(format!("{single:?}"), format!("{eight:?}"));
            }
        }
    }
}
