//! What pictures, tables and fields ask of bolts. Forces are those of one bolt: what acts on a metre of thickness times the spacing.

use crate::frame::bars::BoltBar;
use crate::laws::bolt;
use crate::setup::Bolt as Spec;
use crate::view::View;
use crate::world::Bolt;
use riprap_geom::Vec2;

/// All bars of the bolts that are in the rock, bolt after bolt, from the head to the toe.
#[must_use]
pub fn bars(view: &View<'_>) -> Vec<BoltBar> {
    let world = view.world;
    let origin = Vec2::from(world.setup.origin);
    let mut all = Vec::new();
    for bolt in &world.bolts {
        let spacing = world.setup.bolts[bolt.number as usize].spacing;
        let place = |k: usize| {
            let pin = &bolt.pins[k];
            let at = world.on_body(pin.block, pin.arm) + origin;
            [at.x, at.y, 0.0]
        };
        for k in 0..bolt.chain.bars.len() {
            let dowels = bolt.dowels.iter().filter(|d| d.bar as usize == k);
            let shear = dowels.map(|d| d.force.length()).fold(0.0, f64::max);
            all.push(BoltBar {
                bolt: bolt.number,
                bar: k as u32,
                blocks: [bolt.pins[k].block, bolt.pins[k + 1].block],
                ends: [place(k), place(k + 1)],
                force: spacing * bolt.chain.force[k],
                shear: spacing * shear,
                slip: bolt.chain.slip_at(k),
                state: bolt.chain.state(k),
            });
        }
    }
    all
}

impl View<'_> {
    /// The bolt that has been drawn out by most of its length: its number, by how much farther its points in the rock lie apart along it than when
    /// it was installed (m; bars that have broken do not count), its length (m), and the largest force that it pulls with (N/m).
    #[must_use]
    pub fn most_drawn(&self) -> Option<(u32, [f64; 3])> {
        let bodies = &self.world.bodies;
        let one = |bolt: &Bolt| {
            let bars = (0..bolt.chain.bars.len())
                .filter(|k| bolt.stretches(*k) && bolt.chain.state(*k) != bolt::BarState::Broken);
            let by = bars.map(|k| super::chord(&bolt.pins[k], &bolt.pins[k + 1], bodies).1).sum();
            let [head, toe] = [bolt.pins.first()?, bolt.pins.last()?].map(|pin| pin.along);
            Some((bolt.number, [by, toe - head, bolt.chain.largest_force()]))
        };
        let all = self.world.bolts.iter().filter_map(one);
        all.max_by(|(_, [a, m, _]), (_, [b, n, _])| (a / m).total_cmp(&(b / n)))
    }

    /// Bolts that tie nothing to anything, with the block that all of them lies in: those that are installed, and those that would be if the
    /// rock stayed as it is.
    #[must_use]
    pub fn idle_bolts(&self) -> Vec<(u32, u32)> {
        let world = self.world;
        let idle = |bolt: &Bolt| {
            let block = bolt.pins.first().map(|pin| pin.block)?;
            bolt.ties().next().is_none().then_some((bolt.number, block))
        };
        let installed = world.bolts.iter().filter_map(idle);
        let later = (0..world.setup.bolts.len() as u32)
            .filter(|n| world.bolts.iter().all(|bolt| bolt.number != *n))
            .filter_map(|n| idle(&super::install::as_it_is(world, &self.scratch.shapes, n)?));
        let mut all: Vec<_> = installed.chain(later).collect();
        all.sort_unstable();
        all
    }
}

/// The largest of a number over the installed ones among bolts of the setup (ascending), at least `least`; not a number where none is installed.
#[must_use]
pub fn largest(v: &View, numbers: &[u32], least: f64, get: impl Fn(&Spec, &Bolt) -> f64) -> f64 {
    let spec = |bolt: &Bolt| &v.world.setup.bolts[bolt.number as usize];
    bolt::largest(of(v, numbers).map(|bolt| get(spec(bolt), bolt)), least)
}

/// The installed ones among bolts of the setup (ascending).
pub fn of<'a>(v: &View<'a>, numbers: &'a [u32]) -> impl Iterator<Item = &'a Bolt> {
    let bolts = v.world.bolts.iter();
    bolts.filter(|bolt| numbers.contains(&bolt.number))
}

/// Largest axial force, N.
#[must_use]
pub fn force(spec: &Spec, bolt: &Bolt) -> f64 {
    spec.spacing * bolt.chain.largest_force()
}

/// Force of the plate, N; not a number without one.
#[must_use]
pub fn plate(spec: &Spec, bolt: &Bolt) -> f64 {
    spec.spacing * bolt.chain.plate_force(&spec.design)
}

/// Largest shear force, N.
#[must_use]
pub fn shear(spec: &Spec, bolt: &Bolt) -> f64 {
    let forces = bolt.dowels.iter().map(|d| d.force.length());
    spec.spacing * forces.fold(0.0, f64::max)
}

impl View<'_> {
    /// The bolt whose equilibrium was missed by most so far: its name, and the force that was left over its largest one; `None` as long as
    /// every search came to its end.
    #[must_use]
    pub fn unbalanced_bolt(&self) -> Option<(&str, f64)> {
        let missed = self.world.bolts.iter().filter(|bolt| bolt.toll.left > 0.0);
        let worst = missed.max_by(|a, b| a.toll.left.total_cmp(&b.toll.left))?;
        let spec = &self.world.setup.bolts[worst.number as usize];
        Some((&spec.name, worst.toll.left))
    }
}
