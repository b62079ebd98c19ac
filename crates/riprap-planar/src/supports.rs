//! What supports bear: forces and moments on the blocks that they hold or drive.

use riprap_geom::Vec2;

use super::view::View;
use super::world::World;
use crate::accounts::Holder;

impl World {
    /// Living blocks on which support number `k` acts: the last support of a block alone acts on it, unless a phase releases it.
    pub fn held_by(&self, k: usize) -> impl Iterator<Item = usize> + '_ {
        let (own, later) = self.setup.supports[k..].split_at(1);
        let blocks = own.iter().flat_map(|s| &s.blocks);
        let acts = blocks.filter(move |b| !later.iter().any(|s| s.blocks.contains(b)));
        let numbers = acts.map(|b| *b as usize);
        numbers.filter(|b| self.alive[*b] && self.motion[*b].is_some())
    }
}

impl View<'_> {
    /// Force of the support on account number `account` on all blocks that it holds, N/m, and its moment (N) about their centre of mass: the
    /// reaction in the prescribed freedoms, inertia of a driven motion included, without damping of the phase.
    #[must_use]
    pub fn on_support(&self, account: usize) -> (Vec2, f64) {
        let (world, scratch) = (self.world, self.scratch);
        let Some(Holder::Support(k)) = world.setup.accounts.get(account).map(|c| c.holder) else {
            return (Vec2::ZERO, 0.0);
        };
        let span = 0.5 * (world.last_dt + scratch.coming_dt);
        let mut parts = Vec::new();
        let (mut middle, mut mass, mut moment) = (Vec2::ZERO, 0.0, 0.0);
        for number in world.held_by(usize::from(k)) {
            let Some(motion) = world.motion[number].as_deref() else {
                continue;
            };
            let [x, y, spin] = motion.targets().map(|t| f64::from(!t.is_free()));
            let (net, change) = (&scratch.net[number], &scratch.changes[number]);
            let rate = if span > 0.0 { 1.0 / span } else { 0.0 };
            let [m, i] = [scratch.shapes.mass[number], scratch.shapes.inertia[number]];
            let force = Vec2::new(x, y) * (m * rate * change.velocity - net.force);
            moment += spin * (i * rate * change.spin - net.moment);
            let place = world.bodies[number].position;
            middle += m * place;
            mass += m;
            parts.push((place, force));
        }
        let middle = middle / f64::max(mass, f64::MIN_POSITIVE);
        let force = parts.iter().map(|(_, force)| *force).sum();
        let about = parts.iter().map(|(at, f)| (*at - middle).perp_dot(*f));
        (force, moment + about.sum::<f64>())
    }
}
