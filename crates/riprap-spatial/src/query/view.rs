//! What can be read from a spatial model.

use crate::joint::reading::Reading;
use std::collections::BTreeMap;

use riprap_geom::Vec3;

use crate::contact;
use crate::dynamics::kick::past;
use crate::joint::patch::{Points, Poses, Resultant};
use crate::laws::face_joint::Traction;
use crate::laws::tetrahedron::Strain;
use crate::ledger::Balance;
use crate::push::boundary;
use crate::rigid::kick::Change;
use crate::state::deform::Body;
use crate::state::found::FoundPair;
use crate::state::hold::Hold;
use crate::state::patches::PatchClass;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// A world with its forces evaluated, ready to be read.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// State.
    pub world: &'a World,
    /// Forces at the same time.
    pub scratch: &'a Scratch,
}

impl View<'_> {
    /// Share of the coming kick that lies before the present time.
    pub(crate) fn past(&self) -> f64 {
        past(self.world.last_dt, self.scratch.coming_dt)
    }

    /// Name of block `b`.
    #[must_use]
    pub fn name(&self, b: usize) -> String {
        self.world.name(b)
    }

    /// Living blocks.
    pub fn living(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.world.alive.len()).filter(|&b| self.world.alive[b])
    }

    /// Velocity of the centroid of block `b` at the present time, m/s.
    #[must_use]
    pub fn velocity(&self, b: usize) -> Vec3 {
        if let Some(deformable) = self.deformable(b) {
            return deformable.velocity();
        }
        let change = self.scratch.change(self.world, b);
        let velocity = self.world.bodies.velocity(b) + self.past() * change.velocity;
        match self.late(b) {
            Some(late) => velocity + late.velocity,
            None => velocity,
        }
    }

    /// What contacts whose time has not come have still to change of the velocities of block `b` until now; `None` where all are evaluated at each step.
    fn late(&self, b: usize) -> Option<Change> {
        let late = self.scratch.desk.between(b)?.late;
        let solid = self.world.solid_of(b);
        let velocity = late.force / solid.mass;
        let spin = self.world.moving(b).inverse(solid) * late.moment;
        Some(self.world.ungiven(b, Change { velocity, spin, momentum: late.moment }))
    }

    /// Force and moment on block `b` without damping and supports, N and N m.
    #[must_use]
    pub(crate) fn net(&self, b: usize) -> [Vec3; 2] {
        let net = &self.scratch.net;
        let lag = self.scratch.desk.between(b).map(|between| between.lag);
        match lag {
            Some(lag) => [net.force(b) + lag.force, net.moment(b) + lag.moment],
            None => [net.force(b), net.moment(b)],
        }
    }

    /// Spin of block `b` at the present time, rad/s.
    #[must_use]
    pub fn spin(&self, b: usize) -> Vec3 {
        if let Some(deformable) = self.deformable(b) {
            return deformable.spin(&self.world.solid_of(b).inverse);
        }
        let change = self.scratch.change(self.world, b);
        let spin = self.world.turning(b).spin + self.past() * change.spin;
        match self.late(b) {
            Some(late) => spin + late.spin,
            None => spin,
        }
    }

    /// Displacement of the centroid since the start or the last reset, m.
    #[must_use]
    pub fn displacement(&self, b: usize) -> Vec3 {
        self.shift(b) - self.world.datum(b)[0]
    }

    /// Displacement of the centroid since the start, m.
    fn shift(&self, b: usize) -> Vec3 {
        match self.deformable(b) {
            Some(deformable) => deformable.displacement(),
            None => self.world.bodies.displacement(b),
        }
    }

    /// Position of the centroid, m.
    #[must_use]
    pub fn position(&self, b: usize) -> Vec3 {
        self.world.reference[b] + self.shift(b)
    }

    /// Rotation vector since the start or the last reset (difference of the vectors), rad.
    #[must_use]
    pub fn rotation(&self, b: usize) -> Vec3 {
        let rotation = match self.deformable(b) {
            Some(deformable) => deformable.rotation(),
            None => self.world.bodies.rotation(b),
        };
        rotation - self.world.datum(b)[1]
    }

    /// Largest speed of the centroid so far, m/s.
    #[must_use]
    pub fn peak_speed(&self, b: usize) -> f64 {
        self.world.peak_speed_squared[b].sqrt()
    }

    /// Kinetic energy of block `b`, J: `m v(n-1/2).v(n+1/2)/2` and the same for rotation, with the second
    /// velocity taken half a step as long as the last one after the present time. A given velocity stays until then
    /// ([`crate::dynamics::kick::Support`]).
    #[must_use]
    pub fn kinetic(&self, b: usize) -> f64 {
        if let Some(deformable) = self.deformable(b) {
            return deformable.kinetic();
        }
        let world = self.world;
        let solid = world.solid_of(b);
        let change = world.ungiven(b, self.scratch.change(world, b));
        // By the last step, which has been made: the coming one may be another when this is read again.
        let whole = 2.0 * self.past();
        let v = world.bodies.velocity(b);
        let turning = world.turning(b);
        let turning = turning.spin.dot(turning.momentum + whole * change.momentum);
        0.5 * (solid.mass * v.dot(v + whole * change.velocity) + turning)
    }

    /// Kinetic energy of all blocks, J.
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

    /// Momentum of all blocks, N s.
    #[must_use]
    pub fn momentum(&self) -> Vec3 {
        self.living().map(|b| self.world.solid_of(b).mass * self.velocity(b)).sum()
    }

    /// Angular momentum of all blocks about the local origin, N m s: what the forces between them conserve. Blocks in joints with small
    /// kinematics count at their reference positions, since arms there are frozen, all others where they are: contact acts there.
    #[must_use]
    pub fn angular_momentum(&self) -> Vec3 {
        let frozen = self.with_frozen_arms();
        self.living()
            .map(|b| {
                if let Some(deformable) = self.deformable(b) {
                    return deformable.angular_momentum(deformable.body.strain == Strain::Large);
                }
                let solid = self.world.solid_of(b);
                let place = if frozen[b] { self.world.reference[b] } else { self.position(b) };
                let change = self.scratch.change(self.world, b);
                let late = self.late(b).unwrap_or_default().momentum;
                let own = self.world.turning(b).momentum + self.past() * change.momentum + late;
                place.cross(solid.mass * self.velocity(b)) + own
            })
            .sum()
    }

    /// Whether each block has joints or bonds that act on frozen arms: none once a block has finite rotations.
    fn with_frozen_arms(&self) -> Vec<bool> {
        let world = self.world;
        let mut frozen = vec![false; world.alive.len()];
        if world.turned.iter().any(Option::is_some) {
            return frozen;
        }
        let small = |b: &&u32| {
            let body = world.deform.as_deref().and_then(|deform| deform.body(**b as usize));
            body.is_none_or(|body| body.strain == Strain::Small)
        };
        let facets = world.deform.iter().flat_map(|deform| &deform.facets);
        let bonded = facets.filter(|f| !f.parted && f.blocks.iter().all(|b| small(&b)));
        for b in world.patches.ends.iter().chain(bonded.map(|f| &f.blocks)).flatten() {
            frozen[*b as usize] = true;
        }
        frozen
    }

    /// Unbalanced-force ratio: sum of |net force| of the free blocks over the sum of the forces that
    /// act on them. Of a block with prescribed motion only the freedoms count that are left to it.
    #[must_use]
    pub fn unbalanced(&self) -> f64 {
        let [net, all] = self.net_of_all();
        let rigid = if all > 0.0 { net / all } else { 0.0 };
        let deformable = self.deformable_unbalanced();
        deformable.map_or(rigid, |deformable| deformable.max(rigid))
    }

    /// What dashpots of viscous faces carry over the sum of all forces, with the condition whose faces carry most: forces that are there only
    /// as long as the model moves.
    #[must_use]
    pub fn sinking(&self) -> Option<(f64, u16)> {
        let (carried, boundary) = self.carried_by_dashpots()?;
        let [_, all] = self.net_of_all();
        (all > 0.0).then(|| (carried / all, boundary))
    }

    /// Sum of |net force| of the free rigid blocks, and of the forces that act on them, N.
    fn net_of_all(&self) -> [f64; 2] {
        let (world, exec) = (self.world, &self.scratch.exec);
        let free = |b: usize| world.alive[b] && world.is_free(b) && !world.deforms(b);
        let of_block = |b: usize| {
            if !free(b) {
                return [0.0; 2];
            }
            let solid = world.solid_of(b);
            let [along, about] = world.freedoms(b);
            let [force, moment] = self.net(b);
            let net = (along * force).length() + (about * moment).length() / solid.radius;
            let applied = self.scratch.pushes.loads.blocks.get(b);
            let applied = applied.map_or(0.0, |l| l.force.length());
            [net, solid.mass * world.gravity.length() + applied]
        };
        let of_patch = |p: usize| {
            let blocks = world.patches.ends[p].map(|b| b as usize);
            // It pushes both blocks, but what a held one bears is no measure for the free ones.
            let count = blocks.iter().filter(|b| free(**b)).count() as f64;
            self.patch_resultant(p).force.length() * count
        };
        let [net, own] = exec.sums(world.alive.len(), of_block);
        let mut all = own + exec.sum(world.patches.len(), of_patch);
        for contact in self.contacts() {
            let count = contact.ends.iter().filter(|b| free(**b as usize)).count() as f64;
            all += contact.force.length() * count;
        }
        for (b, _, force) in world.bolt_forces() {
            if free(b as usize) {
                all += force.length();
            }
        }
        for (b, _, force) in self.bond_forces() {
            if free(b) {
                all += force.length();
            }
        }
        [net, all]
    }

    /// The block whose net force, as far as it is free to follow it, is the largest share of the forces that act on it, and that share.
    #[must_use]
    pub fn least_balanced(&self) -> Option<(f64, u32)> {
        let (world, scratch) = (self.world, self.scratch);
        let mut all: Vec<f64> = (0..world.alive.len())
            .map(|b| {
                let applied = scratch.pushes.loads.blocks.get(b);
                let applied = applied.map_or(0.0, |l| l.force.length());
                world.solid_of(b).mass * world.gravity.length() + applied
            })
            .collect();
        for p in 0..world.patches.len() {
            let force = self.patch_resultant(p).force.length();
            for b in world.patches.ends[p] {
                all[b as usize] += force;
            }
        }
        for contact in self.contacts() {
            for b in contact.ends {
                all[b as usize] += contact.force.length();
            }
        }
        for (b, _, force) in world.bolt_forces() {
            all[b as usize] += force.length();
        }
        for (b, _, force) in self.bond_forces() {
            all[b] += force.length();
        }
        let nets = self.add_deformable(&mut all);
        self.living()
            .filter(|&b| world.is_free(b) && all[b] > 0.0)
            .map(|b| {
                let net = nets.get(&b).copied().unwrap_or_else(|| {
                    let [along, _] = world.freedoms(b);
                    along * self.net(b)[0]
                });
                (net.length() / all[b], b as u32)
            })
            .max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Adds what bonds, loads and holds do to deformable blocks to the forces on each block (N), and returns their net forces, as far as
    /// their nodes are free.
    fn add_deformable(&self, all: &mut [f64]) -> BTreeMap<usize, Vec3> {
        let Some((deform, work)) = self.deformables() else {
            return BTreeMap::new();
        };
        for facet in &deform.facets {
            for side in (0..2).filter(|side| !facet.rigid[*side]) {
                let slots = work.slots[facet.points()].iter();
                let forces = slots.map(|f| Vec3::from_array(*f).length());
                all[facet.blocks[side] as usize] += forces.sum::<f64>();
            }
        }
        let holds: BTreeMap<u32, &Hold> = deform.holds.iter().map(|h| (h.node, h)).collect();
        let loads = &self.scratch.pushes.loads.nodes;
        let net = |body: &Body| {
            let (mut net, mut forces) = (Vec3::ZERO, 0.0);
            for k in body.nodes() {
                let force = Vec3::from_array(work.net[k]);
                let free = holds.get(&(k as u32)).map_or(force, |h| h.free * force);
                let load = loads.get(k).copied().map_or(Vec3::ZERO, Vec3::from_array);
                net += free;
                forces += load.length() + (force - free).length();
            }
            (net, forces)
        };
        let bodies = deform.bodies.iter().filter(|b| b.count > 0);
        let mut nets = BTreeMap::new();
        for body in bodies {
            let (net, forces) = net(body);
            all[body.block as usize] += forces;
            nets.insert(body.block as usize, net);
        }
        nets
    }

    pub(crate) fn poses(&self) -> Poses<'_> {
        Poses { bodies: &self.world.bodies, turned: &self.world.turned }
    }

    /// Patch `p`.
    pub(crate) fn patch(&self, p: usize) -> Reading<'_> {
        Reading { world: self.world, p }
    }

    /// Class of patch `p`.
    #[must_use]
    pub fn patch_class(&self, p: usize) -> &PatchClass {
        self.patch(p).class()
    }

    /// Kinematics of patch `p`.
    #[must_use]
    pub fn patch_points(&self, p: usize) -> Points {
        self.patch(p).points()
    }

    /// Tractions on block i at the four points of patch `p` (n, b, c), Pa, without dashpots.
    #[must_use]
    pub fn patch_tractions(&self, p: usize) -> [Traction; 4] {
        self.patch(p).tractions(&self.patch_points(p))
    }

    /// Forces of patch `p` on its blocks, without dashpots.
    #[must_use]
    pub fn patch_resultant(&self, p: usize) -> Resultant {
        self.patch(p).resultant()
    }

    /// Energy in the normal and shear springs of patch `p`, J.
    #[must_use]
    pub fn patch_energy(&self, p: usize) -> [f64; 2] {
        self.patch(p).energy()
    }

    /// Energy in the springs of boundaries, J.
    #[must_use]
    pub fn boundary_energy(&self) -> f64 {
        let (context, faces) = (boundary::Context::new(self.world), &self.world.faces);
        self.scratch.exec.sum(faces.len(), |k| context.stored(&faces[k]))
    }

    /// The energy ledger at the present time: patches and bonds of deformable blocks as contact springs, boundary springs and
    /// strain energy of blocks as bonds.
    #[must_use]
    pub fn balance(&self) -> Balance {
        let mut out = Balance { works: self.world.works, ..Balance::default() };
        out.kinetic = self.kinetic_energy();
        out.gravity = -self.world.works.gravity;
        let patches = self.world.patches.len();
        [out.contact_normal, out.contact_shear] =
            self.scratch.exec.sums(patches, |p| self.patch_energy(p));
        let Scratch { desk, exec, .. } = self.scratch;
        let pressed = contact::stored(self.world, desk, exec);
        out.contact_normal += pressed;
        // Work that has gone in and is not stored, or the other way round, steps have lost or made.
        out.works.law_defect += pressed - self.world.works.contact_path;
        let found = self.world.found.pairs.iter();
        out.contact_shear += found.map(FoundPair::stored).sum::<f64>();
        for pair in &self.world.found.deformable.pairs {
            out.contact_normal += pair.energy;
            out.contact_shear += pair.stored;
        }
        out.bond = self.boundary_energy() + self.strain_energy();
        let [normal, shear] = self.bond_energy();
        out.contact_normal += normal;
        out.contact_shear += shear;
        out.bolts = self.world.bolt_energy();
        // Before the first evaluation nothing has moved: the start is now.
        out.start = self.world.start_energy.unwrap_or_else(|| out.at_start());
        out
    }

    /// What is deepest for its blocks ([`Self::deepest`]), over the radius of the largest ball in the thinner one, with the blocks.
    #[must_use]
    pub fn worst_overlap(&self) -> Option<(f64, u32, u32)> {
        self.deepest().map(|d| (d.ratio, d.ends[0], d.ends[1]))
    }

    /// Blocks that have gone over the rim of the terrain.
    #[must_use]
    pub fn left_terrain(&self) -> Vec<u32> {
        let all = (0..).zip(&self.world.found.left_terrain);
        all.filter(|(_, left)| **left).map(|(b, _)| b).collect()
    }

    /// The bolt whose equilibrium was missed by most so far: its name, and the force that was left over its largest one; `None` as long as
    /// every search came to its end.
    #[must_use]
    pub fn unbalanced_bolt(&self) -> Option<(&str, f64)> {
        let missed = self.world.bolts.iter().filter(|bolt| bolt.toll.left > 0.0);
        let worst = missed.max_by(|a, b| a.toll.left.total_cmp(&b.toll.left))?;
        let spec = &self.world.setup.bolts[worst.number as usize];
        Some((&spec.name, worst.toll.left))
    }

    /// Force of all terrain on a block, N, and how deep it lies in it, m.
    #[must_use]
    pub fn on_terrain(&self, b: usize) -> (Vec3, f64) {
        let grounds = self.contacts_of(b).filter(|(contact, _)| {
            let [i, j] = contact.ends.map(|b| b as usize);
            self.world.is_terrain(if i == b { j } else { i })
        });
        grounds.fold((Vec3::ZERO, 0.0), |(sum, depth), (contact, force)| {
            (sum + force, contact.depth.max(depth))
        })
    }

    /// Height to which the energy of a block would lift its centroid: its height (global) and its kinetic energy over its weight, m. Not a
    /// number without gravity.
    #[must_use]
    pub fn energy_head(&self, b: usize) -> f64 {
        let weight = self.world.solid_of(b).mass * self.world.gravity.length();
        let height = self.up().dot(self.position(b) + self.world.setup.origin);
        if weight > 0.0 { height + self.kinetic(b) / weight } else { f64::NAN }
    }
}
