//! What can be read from a planar model: the field table and its getters.

use riprap_geom::Vec2;

use super::convex::Side;
use super::energy;
use super::search::Candidate;
use super::setup::NormalLaw;
use super::step::Scratch;
use super::world::{Contact, World, Wrench};
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
    /// Share of the coming kick that lies before the present time: velocities are those of half a
    /// step before, the kick spans both halves.
    fn past(&self) -> f64 {
        let (before, after) = (self.world.last_dt, self.scratch.coming_dt);
        if before > 0.0 {
            before / (before + after)
        } else {
            0.0
        }
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

    /// Kinetic energy of block `b`, J/m: `m v(n-1/2).v(n+1/2)/2`, with the second velocity taken half a
    /// step as long as the last one after the present time.
    #[must_use]
    pub fn kinetic(&self, b: usize) -> f64 {
        let (body, change) = (&self.world.bodies[b], &self.scratch.changes[b]);
        let (mass, inertia) = (self.scratch.shapes.mass[b], self.scratch.shapes.inertia[b]);
        let whole = 2.0 * self.past();
        0.5 * mass * body.velocity.dot(body.velocity + whole * change.velocity)
            + 0.5 * inertia * body.spin * (body.spin + whole * change.spin)
    }

    /// Acceleration (m/s²) and angular acceleration (rad/s²) of block `b`.
    #[must_use]
    pub fn acceleration(&self, b: usize) -> (Vec2, f64) {
        let net = &self.scratch.net[b];
        if self.world.motion[b].is_some() {
            return (Vec2::ZERO, 0.0);
        }
        let shapes = &self.scratch.shapes;
        (net.force / shapes.mass[b], net.moment / shapes.inertia[b])
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

    /// Unbalanced-force ratio: sum of |net force| of the free blocks over the sum of the forces that
    /// act on them.
    #[must_use]
    pub fn unbalanced(&self) -> f64 {
        let (mut net, mut all) = (0.0, 0.0);
        let free = |b: u32| self.world.motion[b as usize].is_none();
        for b in self.living().filter(|&b| free(b as u32)) {
            let n = &self.scratch.net[b];
            net += n.force.length() + n.moment.abs() / self.scratch.shapes.radius[b];
            all += self.scratch.shapes.mass[b] * self.world.gravity.length()
                + self.scratch.applied[b].force.length();
        }
        for (slot, (i, j)) in self.scratch.slots.iter().zip(self.ends()) {
            all += slot.force.length() * f64::from(u8::from(free(i)) + u8::from(free(j)));
        }
        if all > 0.0 { net / all } else { 0.0 }
    }

    /// Blocks of each slot, in slot order.
    fn ends(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        let pairs = self.world.pairs.iter().map(|p| (p.i, p.j));
        let general = self.world.general.iter().map(|p| (p.i, p.j));
        pairs
            .chain(general)
            .chain(self.world.bonds.iter().map(|b| (b.i, b.j)))
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

    /// Largest overlap over the smaller inradius of the pair, with the pair.
    #[must_use]
    pub fn worst_overlap(&self) -> Option<(f64, u32, u32)> {
        let inradius = &self.scratch.shapes.inradius;
        self.contacts()
            .map(|(i, j, c)| {
                (
                    c.depth / inradius[i as usize].min(inradius[j as usize]),
                    i,
                    j,
                )
            })
            .max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Sum of all wrenches (found contacts and joints) between two blocks, on the first.
    #[must_use]
    pub fn pair_wrench(&self, a: u32, b: u32) -> Wrench {
        let mut sum = Wrench::default();
        for (slot, (i, j)) in self.scratch.slots.iter().zip(self.ends()) {
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
        let mut out = Balance {
            works: self.world.works,
            ..Balance::default()
        };
        out.kinetic = self.living().map(|b| self.kinetic(b)).sum();
        out.gravity = -self.world.works.gravity;
        for (_, _, c) in self.contacts() {
            out.contact_shear += c.shear_energy;
        }
        out.bond = self.world.bonds.iter().map(|b| b.energy).sum();
        let s = self.scratch;
        for c in s.candidates.convex.iter().chain(&s.candidates.general) {
            out.contact_normal += candidate_energy(self.world, s, c);
        }
        out.contact_normal += self.world.works.contact_path;
        out.start = self.world.start_energy.unwrap_or_else(|| out.total());
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
