//! What supports bear: forces and moments on the blocks and nodes that they hold or drive.

use riprap_geom::Vec3;

use crate::accounts::Holder;
use crate::query::view::View;
use crate::state::world::World;

impl World {
    /// Living blocks on which support number `k` acts: the last support of a block alone acts on it, unless a phase releases the block.
    pub fn held_by(&self, k: usize) -> impl Iterator<Item = usize> + '_ {
        let (own, later) = self.setup.supports[k..].split_at(1);
        let overruled = |b: u32| later.iter().any(|s| s.blocks.binary_search(&b).is_ok());
        let blocks = own.iter().flat_map(|s| s.blocks.iter().copied());
        let blocks = blocks.filter(move |b| !overruled(*b)).map(|b| b as usize);
        blocks.filter(|b| self.alive[*b] && self.motion[*b].is_some())
    }
}

impl View<'_> {
    /// Force of the support on account number `account` on all that it holds, N, and its moment (N m) about the centre of mass of its blocks, of a
    /// support of nodes about their middle: the reaction in the prescribed freedoms, inertia of a driven motion included, without damping.
    #[must_use]
    pub fn on_support(&self, account: usize) -> [Vec3; 2] {
        let mut forces = Vec::new();
        let (mut turning, mut middle, mut weight) = (Vec3::ZERO, Vec3::ZERO, 0.0);
        let holder = self.world.setup.accounts.get(account).map(|c| c.holder);
        if let Some(Holder::Support(k)) = holder {
            for b in self.world.held_by(usize::from(k)) {
                let (place, mass) = (self.position(b), self.world.solid_of(b).mass);
                middle += mass * place;
                weight += mass;
                if !self.world.deforms(b) {
                    let [force, moment] = self.reaction(b);
                    forces.push((place, force));
                    turning += moment;
                }
            }
        }
        for (place, force) in self.held_nodes(account) {
            if let Some(Holder::Nodes(_)) = holder {
                middle += place;
                weight += 1.0;
            }
            forces.push((place, force));
        }
        let middle = middle / f64::max(weight, f64::MIN_POSITIVE);
        forces.iter().fold([Vec3::ZERO, turning], |[f, m], (at, force)| {
            [f + *force, m + (*at - middle).cross(*force)]
        })
    }

    /// Reaction of what holds or drives a rigid block: force and moment about its centroid.
    fn reaction(&self, b: usize) -> [Vec3; 2] {
        let (world, scratch) = (self.world, self.scratch);
        let (acting, change) = (scratch.acting(b), scratch.change(world, b));
        let span = scratch.no_workspace(world).span;
        let rate = |change: Vec3| {
            if span > 0.0 { change / span } else { Vec3::ZERO }
        };
        let [along, about] = world.freedoms(b).map(|free| Vec3::ONE - free);
        let mass = world.solid_of(b).mass;
        [
            along * (mass * rate(change.velocity) - acting.force - acting.drag),
            about * (rate(change.momentum) - acting.moment - acting.drag_moment),
        ]
    }

    /// Places (m, local) of the nodes that the condition on an account holds, and the force of it on each.
    fn held_nodes(&self, account: usize) -> Vec<(Vec3, Vec3)> {
        let Some((deform, work)) = self.deformables() else {
            return Vec::new();
        };
        let span = self.scratch.no_workspace(self.world).span;
        let mut found = Vec::new();
        for hold in &deform.holds {
            let node = hold.node as usize;
            let [net, change] = [work.net[node], work.change[node]].map(Vec3::from_array);
            let held = |v: Vec3| v - hold.free * v;
            // The masses of a relaxation are no inertia.
            let inertia = if deform.relax.is_none() && span > 0.0 {
                work.masses[node] / span * held(change)
            } else {
                Vec3::ZERO
            };
            let place =
                deform.nodes.place[node] + Vec3::from_array(deform.nodes.displacement[node]);
            let parts = hold.parts(inertia - held(net));
            for (_, force) in parts.filter(|(of, _)| of.map(usize::from) == Some(account)) {
                found.push((place, force));
            }
        }
        found
    }
}
