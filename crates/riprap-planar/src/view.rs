//! What can be read from a planar model: the field table and its getters.

use riprap_geom::Vec2;

use super::convex::Side;
use super::energy;
use super::scratch::{Change, Scratch};
use super::search::Candidate;
use super::setup::NormalLaw;
use super::water;
use super::world::{Bond, BondPoint, Contact, World, Wrench};
use crate::dynamics::kick::past;
use crate::ledger::Balance;

/// A world with its forces evaluated, ready to be read.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// State.
    pub world: &'a World,
    /// Forces and velocity changes at the same time.
    pub scratch: &'a Scratch,
}

impl View<'_> {
    /// Share of the coming kick that lies before the present time.
    fn past(&self) -> f64 {
        past(self.world.last_dt, self.scratch.coming_dt)
    }

    /// Velocity of block `b` at the present time, m/s.
    #[must_use]
    pub fn velocity(&self, b: usize) -> Vec2 {
        self.world.bodies[b].velocity + self.past() * self.scratch.changes[b].velocity
    }

    /// Angular velocity of block `b` at the present time, rad/s.
    #[must_use]
    pub fn spin(&self, b: usize) -> f64 {
        self.world.bodies[b].spin + self.past() * self.scratch.changes[b].spin
    }

    /// Displacement of the centroid, m.
    #[must_use]
    pub fn displacement(&self, b: usize) -> Vec2 {
        self.world.bodies[b].position - self.world.reference[b]
    }

    /// Rotation, rad.
    #[must_use]
    pub fn rotation(&self, b: usize) -> f64 {
        self.world.bodies[b].angle - self.world.reference_angle[b]
    }

    /// Change of velocity (m/s) and spin (rad/s) of block `b` in the coming kick, without freedoms whose velocity is given.
    fn ungiven_change(&self, b: usize) -> Change {
        let change = self.scratch.changes[b];
        let Some(motion) = &self.world.motion[b] else {
            return change;
        };
        let targets = motion.targets();
        let [x, y, spin] = targets.map(|t| if t.gives_velocity() { 0.0 } else { 1.0 });
        Change { velocity: change.velocity * Vec2::new(x, y), spin: change.spin * spin }
    }

    /// Sum over the blocks of `m dv² + I dw²` of the coming kick: what the ledger needs where the step changes.
    #[must_use]
    pub fn half_kick(&self) -> f64 {
        let shapes = &self.scratch.shapes;
        let one = |b: usize| {
            let change = self.ungiven_change(b);
            shapes.mass[b] * change.velocity.length_squared()
                + shapes.inertia[b] * change.spin * change.spin
        };
        let alive = &self.world.alive;
        let of = |b: usize| if alive[b] { one(b) } else { 0.0 };
        self.scratch.exec.sum(alive.len(), of)
    }

    /// Kinetic energy of block `b`, J/m: `m v(n-1/2).v(n+1/2)/2`, with the second velocity taken half a
    /// step as long as the last one after the present time. A given velocity stays until then ([`crate::dynamics::kick::Support`]).
    #[must_use]
    pub fn kinetic(&self, b: usize) -> f64 {
        let (body, change) = (&self.world.bodies[b], self.ungiven_change(b));
        let (mass, inertia) = (self.scratch.shapes.mass[b], self.scratch.shapes.inertia[b]);
        // By the last step, which has been made: the coming one may be another when this is read again.
        let whole = 2.0 * self.past();
        0.5 * mass * body.velocity.dot(body.velocity + whole * change.velocity)
            + 0.5 * inertia * body.spin * (body.spin + whole * change.spin)
    }

    /// Kinetic energy of all blocks, J/m.
    #[must_use]
    pub fn kinetic_energy(&self) -> f64 {
        let alive = &self.world.alive;
        let one = |b: usize| if alive[b] { self.kinetic(b) } else { 0.0 };
        self.scratch.exec.sum(alive.len(), one)
    }

    /// Speed of the fastest centroid (m/s) and its block.
    #[must_use]
    pub fn fastest(&self) -> Option<(f64, usize)> {
        let alive = &self.world.alive;
        let one = |b: usize| alive[b].then(|| (self.velocity(b).length(), b));
        self.scratch.exec.largest(alive.len(), one)
    }

    /// 1 for each freedom of block `b` that is left to it, 0 for those that are prescribed: x and y, and rotation.
    fn freedoms(&self, b: usize) -> (Vec2, f64) {
        let Some(motion) = &self.world.motion[b] else {
            return (Vec2::ONE, 1.0);
        };
        let [x, y, rotation] = motion.targets().map(|t| if t.is_free() { 1.0 } else { 0.0 });
        (Vec2::new(x, y), rotation)
    }

    /// Whether block `b` has a freedom that is not prescribed.
    fn is_free(&self, b: usize) -> bool {
        self.freedoms(b) != (Vec2::ZERO, 0.0)
    }

    /// Acceleration (m/s²) and angular acceleration (rad/s²) of block `b`, of freedoms that are not prescribed.
    #[must_use]
    pub fn acceleration(&self, b: usize) -> (Vec2, f64) {
        let (net, shapes) = (&self.scratch.net[b], &self.scratch.shapes);
        let (along, about) = self.freedoms(b);
        (along * net.force / shapes.mass[b], about * net.moment / shapes.inertia[b])
    }

    /// Angular momentum of all blocks about the origin, N s (N m s per m).
    #[must_use]
    pub fn angular_momentum(&self) -> f64 {
        let shapes = &self.scratch.shapes;
        self.living()
            .map(|b| {
                let orbit = self.world.bodies[b].position.perp_dot(self.velocity(b));
                shapes.mass[b] * orbit + shapes.inertia[b] * self.spin(b)
            })
            .sum()
    }

    /// Living blocks.
    pub fn living(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.world.alive.len()).filter(|&b| self.world.alive[b])
    }

    /// Push of the standing water on all faces of a block, N/m; nothing on one that was removed.
    #[must_use]
    pub fn water_force(&self, b: usize) -> Vec2 {
        if !self.world.alive[b] {
            return Vec2::ZERO;
        }
        let scratch = self.scratch;
        water::on_block(self.world, &scratch.shapes, &scratch.turned, b).force
    }

    /// Unbalanced-force ratio: sum of |net force| of the free blocks over the sum of the forces that
    /// act on them. Of a block with prescribed motion only the freedoms count that are left to it.
    #[must_use]
    pub fn unbalanced(&self) -> f64 {
        let (world, scratch) = (self.world, self.scratch);
        let free = |b: u32| self.is_free(b as usize);
        let of_block = |b: usize| {
            if !world.alive[b] || !free(b as u32) {
                return [0.0; 2];
            }
            let (n, (along, about)) = (&scratch.net[b], self.freedoms(b));
            let net =
                (along * n.force).length() + (about * n.moment).abs() / scratch.shapes.radius[b];
            let weight = scratch.shapes.mass[b] * world.gravity.length();
            [net, weight + scratch.applied[b].force.length()]
        };
        let of_slot = |k: usize| {
            let (i, j) = self.ends(k);
            // It pushes both blocks, but what a driven one bears is no measure for the free ones.
            scratch.slots[k].force.length() * f64::from(u8::from(free(i)) + u8::from(free(j)))
        };
        let [net, own] = scratch.exec.sums(world.alive.len(), of_block);
        let all = own + scratch.exec.sum(scratch.slots.len(), of_slot);
        if all > 0.0 { net / all } else { 0.0 }
    }

    /// The block whose net force, as far as it is free to follow it, is the largest share of the forces that act on it, and that share.
    #[must_use]
    pub fn least_balanced(&self) -> Option<(f64, u32)> {
        let (world, scratch) = (self.world, self.scratch);
        let mut all: Vec<f64> = (0..world.alive.len())
            .map(|b| {
                scratch.shapes.mass[b] * world.gravity.length() + scratch.applied[b].force.length()
            })
            .collect();
        for (k, slot) in scratch.slots.iter().enumerate() {
            let (i, j) = self.ends(k);
            all[i as usize] += slot.force.length();
            all[j as usize] += slot.force.length();
        }
        self.living()
            .filter(|&b| self.is_free(b) && all[b] > 0.0)
            .map(|b| {
                let net = self.freedoms(b).0 * scratch.net[b].force;
                (net.length() / all[b], b as u32)
            })
            .max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Blocks of a slot: those of convex pairs come first, then general pairs, then bonds, then ties of bolts.
    fn ends(&self, slot: usize) -> (u32, u32) {
        let world = self.world;
        let (convex, general) = (world.pairs.len(), world.general.len());
        if let Some(pair) = world.pairs.get(slot) {
            (pair.i, pair.j)
        } else if let Some(pair) = world.general.get(slot - convex) {
            (pair.i, pair.j)
        } else if let Some(bond) = world.bonds.get(slot - convex - general) {
            (bond.i, bond.j)
        } else {
            self.scratch.ties[slot - convex - general - world.bonds.len()]
        }
    }

    /// Touching found contacts: blocks and state, in slot order.
    pub fn contacts(&self) -> impl Iterator<Item = (u32, u32, &Contact)> + '_ {
        let pairs = self.world.pairs.iter().map(|p| (p.i, p.j, &p.contact));
        let general = self
            .world
            .general
            .iter()
            .flat_map(|g| g.regions.iter().map(move |r| (g.i, g.j, &r.contact)));
        pairs.chain(general).filter(|(_, _, c)| c.touches())
    }

    /// Largest overlap, or closing of a joint, over the smaller inradius of the pair, with the pair.
    #[must_use]
    pub fn worst_overlap(&self) -> Option<(f64, u32, u32)> {
        let (world, exec) = (self.world, &self.scratch.exec);
        let inradius = &self.scratch.shapes.inradius;
        let ratio = |i: u32, j: u32, c: &Contact| {
            let smaller = inradius[i as usize].min(inradius[j as usize]);
            c.touches().then(|| (c.depth / smaller, (i, j)))
        };
        let convex = exec.largest(world.pairs.len(), |k| {
            let p = &world.pairs[k];
            ratio(p.i, p.j, &p.contact)
        });
        let general = exec.largest(world.general.len(), |k| {
            let g = &world.general[k];
            let regions = g.regions.iter();
            regions.filter_map(|r| ratio(g.i, g.j, &r.contact)).max_by(|a, b| a.0.total_cmp(&b.0))
        });
        // Joints keep their blocks from meeting: how far they are closed beyond where they were built is the same depth.
        let joined = exec.largest(world.bonds.len(), |k| {
            let bond = &world.bonds[k];
            let smaller = inradius[bond.i as usize].min(inradius[bond.j as usize]);
            let depth = self.closed_by(bond);
            (bond.active && depth > 0.0).then(|| (depth / smaller, (bond.i, bond.j)))
        });
        let both = convex.into_iter().chain(general).chain(joined);
        let (ratio, (i, j)) = both.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((ratio, i, j))
    }

    /// How far a joint is closed at its most closed point beyond where its blocks were built, m: what the stress at the start closes it by is not
    /// in it.
    fn closed_by(&self, bond: &Bond) -> f64 {
        let centroid = &self.scratch.shapes.centroid;
        let [a, b] = [bond.i, bond.j].map(|k| centroid[k as usize]);
        let start = |p: &BondPoint| (b + p.on_j - a - p.on_i).dot(bond.normal);
        let closed = bond.points.iter().map(|p| start(p) - p.opening);
        closed.fold(0.0, f64::max)
    }

    /// Sum of all wrenches (found contacts and joints) between two blocks, on the first.
    #[must_use]
    pub fn pair_wrench(&self, a: u32, b: u32) -> Wrench {
        let mut sum = Wrench::default();
        // Ties of bolts stand last and are no contacts.
        let contacts = self.scratch.slots.len() - self.scratch.ties.len();
        for (k, slot) in self.scratch.slots[..contacts].iter().enumerate() {
            let (i, j) = self.ends(k);
            if (i, j) == (a, b) {
                sum = sum.plus(slot);
            } else if (i, j) == (b, a) {
                sum = sum.plus(&Wrench {
                    force: -slot.force,
                    moment_i: slot.moment_j,
                    moment_j: slot.moment_i,
                });
            }
        }
        sum
    }

    /// The energy ledger at the present time.
    #[must_use]
    pub fn balance(&self) -> Balance {
        let mut out = Balance { works: self.world.works, ..Balance::default() };
        let (world, scratch) = (self.world, self.scratch);
        let exec = &scratch.exec;
        out.kinetic = self.kinetic_energy();
        out.gravity = -world.works.gravity;
        let shear = |c: &Contact| if c.touches() { c.shear_energy } else { 0.0 };
        out.contact_shear = exec.sum(world.pairs.len(), |k| shear(&world.pairs[k].contact))
            + exec.sum(world.general.len(), |k| {
                let regions = &world.general[k].regions;
                regions.iter().map(|r| shear(&r.contact)).sum()
            });
        out.bond = exec.sum(world.bonds.len(), |k| world.bonds[k].energy);
        out.bolts = world.bolt_energy();
        let normal = |list: &[Candidate]| {
            exec.sum(list.len(), |k| candidate_energy(world, scratch, &list[k]))
        };
        out.contact_normal =
            normal(&scratch.candidates.convex) + normal(&scratch.candidates.general);
        // Laws without potential: their pairs store nothing that the place alone could tell.
        out.contact_normal += self.world.works.contact_path;
        out.start = self.world.start_energy.unwrap_or_else(|| out.at_start());
        out
    }
}

/// Stored normal energy of a candidate pair under the distance potential, J/m; 0 for other laws.
fn candidate_energy(world: &World, scratch: &Scratch, c: &Candidate) -> f64 {
    let law = &world.setup.interfaces[c.row as usize].contact;
    if law.normal != NormalLaw::DistancePotential {
        return 0.0;
    }
    let (i, j) = (c.i as usize, c.j as usize);
    let (shapes, lists) = (&scratch.shapes, c.lists(&scratch.candidates.lists));
    let side = |b: usize, active, nearest| Side {
        turned: &scratch.turned[shapes.range(b)],
        active,
        nearest,
    };
    let shift = world.bodies[i].position - world.bodies[j].position;
    let convex = [shapes.convex[i], shapes.convex[j]];
    0.5 * law.normal_stiffness
        * energy::overlap_potential(
            side(i, lists[0], lists[3]),
            side(j, lists[2], lists[1]),
            shift,
            convex,
        )
}

/// Stored normal energy between two blocks, J/m; 0 when they are no candidates.
#[must_use]
pub fn pair_energy(world: &World, scratch: &Scratch, pair: (u32, u32)) -> f64 {
    let c = &scratch.candidates;
    c.convex
        .iter()
        .chain(&c.general)
        .find(|c| (c.i, c.j) == pair)
        .map_or(0.0, |c| candidate_energy(world, scratch, c))
}
