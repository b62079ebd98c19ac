//! Bars of bolts one by one: for pictures and for the table `bolts.csv`.

use crate::frame::bars::BoltBar;
use crate::query::view::View;
use crate::state::bolts::Bolt;

/// All bars of the bolts that are in the rock, bolt after bolt, from the head to the toe.
#[must_use]
pub fn bars(view: &View<'_>) -> Vec<BoltBar> {
    let world = view.world;
    let freedoms = world.all_freedoms();
    let mut all = Vec::new();
    for bolt in &world.bolts {
        let place = |k: usize| {
            let pin = &bolt.pins[k];
            (pin.place + pin.displacement(&freedoms) + world.setup.origin).to_array()
        };
        for k in 0..bolt.chain.bars.len() {
            all.push(BoltBar {
                bolt: bolt.number,
                bar: k as u32,
                blocks: [bolt.pins[k].block, bolt.pins[k + 1].block],
                ends: [place(k), place(k + 1)],
                force: bolt.chain.force[k],
                shear: shear(bolt, k),
                slip: bolt.chain.slip_at(k),
                state: bolt.chain.state(k),
            });
        }
    }
    all
}

fn shear(bolt: &Bolt, k: usize) -> f64 {
    let of = bolt.dowels.iter().filter(|d| d.bar as usize == k);
    of.map(|d| d.force.length()).fold(0.0, f64::max)
}
