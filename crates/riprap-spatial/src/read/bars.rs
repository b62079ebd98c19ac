//! Bolts bar by bar: for pictures and for the table `bolts.csv`.

use crate::field::number;
use crate::frame::{Column, Surfaces};
use crate::read::view::View;
use crate::state::bolts::Bolt;

/// States of bars, as numbers in outputs.
const ELASTIC: u8 = 0;
/// The bar has yielded.
const YIELDED: u8 = 1;
/// The grout at one of its ends has slipped.
const SLIPPED: u8 = 2;
/// The bar has broken.
const BROKEN: u8 = 3;

/// A bar between two nodes of a bolt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoltBar {
    /// Index into `Setup::bolts`.
    pub bolt: u32,
    /// Number of the bar in its bolt, from the head, from 0.
    pub bar: u32,
    /// Blocks of its two ends.
    pub blocks: [u32; 2],
    /// Its two ends now, m, global axes.
    pub ends: [[f64; 3]; 2],
    /// Axial force, N, tension positive.
    pub force: f64,
    /// Shear force across the joint that it crosses, N.
    pub shear: f64,
    /// Larger slip of the grout at its ends, m.
    pub slip: f64,
    /// 0 elastic, 1 yielded, 2 its grout has slipped, 3 broken.
    pub state: u8,
}

/// All bars of the bolts that are in the rock, bolt after bolt, from the head to the toe.
#[must_use]
pub fn bars(view: &View<'_>) -> Vec<BoltBar> {
    let world = view.world;
    let freedoms = world.all_freedoms();
    let mut all = Vec::new();
    for bolt in &world.bolts {
        let place = |k: usize| {
            let pin = &bolt.pins[k];
            (pin.place + pin.moved(&freedoms) + world.setup.origin).to_array()
        };
        for k in 0..bolt.chain.bars.len() {
            all.push(BoltBar {
                bolt: bolt.number,
                bar: k as u32,
                blocks: [bolt.pins[k].block, bolt.pins[k + 1].block],
                ends: [place(k), place(k + 1)],
                force: bolt.chain.force[k],
                shear: shear(bolt, k),
                slip: slip(bolt, k),
                state: state(bolt, k),
            });
        }
    }
    all
}

fn shear(bolt: &Bolt, k: usize) -> f64 {
    let of = bolt.dowels.iter().filter(|d| d.bar as usize == k);
    of.map(|d| d.force.length()).fold(0.0, f64::max)
}

fn slip(bolt: &Bolt, k: usize) -> f64 {
    let chain = &bolt.chain;
    let grout = [k, k + 1].into_iter().filter(|n| !chain.holds[*n].lifts);
    grout.map(|n| chain.slip[n].abs()).fold(0.0, f64::max)
}

fn state(bolt: &Bolt, k: usize) -> u8 {
    if bolt.chain.bars[k].stiffness == 0.0 {
        BROKEN
    } else if bolt.chain.plastic[k] != 0.0 {
        YIELDED
    } else if slip(bolt, k) > 0.0 {
        SLIPPED
    } else {
        ELASTIC
    }
}

/// The bars as cells of two points; `None` where no bolt is in the rock.
#[must_use]
pub fn surfaces(view: &View<'_>) -> Option<Surfaces> {
    let bars = bars(view);
    if bars.is_empty() {
        return None;
    }
    let column = |name: &str, unit: &str, get: &dyn Fn(&BoltBar) -> f64| {
        Column::scalar(name, unit, bars.iter().map(get).collect())
    };
    Some(Surfaces {
        ends: (1..=bars.len() as u32).map(|k| 2 * k).collect(),
        points: bars.iter().flat_map(|b| b.ends).collect(),
        columns: vec![
            column("bolt", "-", &|b| f64::from(b.bolt)),
            column("element", "-", &|b| f64::from(b.bar)),
            column("block_a", "-", &|b| f64::from(b.blocks[0])),
            column("block_b", "-", &|b| f64::from(b.blocks[1])),
            column("axial_force", "N", &|b| b.force),
            column("shear_force", "N", &|b| b.shear),
            column("slip", "m", &|b| b.slip),
            column("state", "-", &|b| f64::from(b.state)),
        ],
    })
}

/// The table `bolts.csv`; `None` where no bolt is in the rock. Positions are the middles of the bars.
#[must_use]
pub fn csv(view: &View<'_>) -> Option<String> {
    let bars = bars(view);
    if bars.is_empty() {
        return None;
    }
    let mut text =
        String::from("name,element,x_m,y_m,z_m,axial_force_N,shear_force_N,slip_m,state\n");
    for bar in &bars {
        let name = &view.world.setup.bolts[bar.bolt as usize].name;
        text.push_str(&format!("{name},{}", bar.bar + 1));
        let [a, b] = bar.ends;
        let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
        for x in middle.iter().chain(&[bar.force, bar.shear, bar.slip]) {
            text.push(',');
            text.push_str(&number(*x));
        }
        let state = match bar.state {
            BROKEN => "broken",
            YIELDED => "yielded",
            SLIPPED => "slipped",
            _ => "elastic",
        };
        text.push_str(&format!(",{state}\n"));
    }
    Some(text)
}
