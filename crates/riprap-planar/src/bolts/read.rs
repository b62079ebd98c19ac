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
