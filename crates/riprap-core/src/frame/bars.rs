//! Bars of bolts one by one: for pictures and for the table `bolts.csv`.

use super::{Column, Surfaces};
use crate::field::number;
use crate::laws::bolt::BarState;

/// A bar between two nodes of a bolt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoltBar {
    /// Number of the bolt in the setup of its engine.
    pub bolt: u32,
    /// Number of the bar in its bolt, from the head, from 0.
    pub bar: u32,
    /// Blocks of its two ends.
    pub blocks: [u32; 2],
    /// Its two ends now, m, global axes; in the plane with z = 0.
    pub ends: [[f64; 3]; 2],
    /// Axial force of one bolt, N, tension positive.
    pub force: f64,
    /// Shear force across the joint that it crosses, N.
    pub shear: f64,
    /// Larger slip of the grout at its ends, m.
    pub slip: f64,
    /// What has given way.
    pub state: BarState,
}

/// Bars as cells of two points; `None` without any.
#[must_use]
pub fn surfaces(bars: &[BoltBar]) -> Option<Surfaces> {
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
            column("state", "-", &|b| f64::from(b.state.number())),
        ],
    })
}

/// The table `bolts.csv` with the names of the bolts; `None` without any bar. Positions are the middles of the bars.
#[must_use]
pub fn csv<'a>(bars: &[BoltBar], name: impl Fn(u32) -> &'a str) -> Option<String> {
    if bars.is_empty() {
        return None;
    }
    let mut text =
        String::from("name,element,x_m,y_m,z_m,axial_force_N,shear_force_N,slip_m,state\n");
    for bar in bars {
        text.push_str(&format!("{},{}", name(bar.bolt), bar.bar + 1));
        let [a, b] = bar.ends;
        let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
        for x in middle.iter().chain(&[bar.force, bar.shear, bar.slip]) {
            text.push(',');
            text.push_str(&number(*x));
        }
        text.push_str(&format!(",{}\n", bar.state.word()));
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_lines_of_the_table_and_cells_of_two_points() {
        assert_eq!((surfaces(&[]), csv(&[], |_| "")), (None, None));
        let bar = |k: u32, force: f64, state| BoltBar {
            bolt: 3,
            bar: k,
            blocks: [7, 8],
            ends: [[0.0, 0.0, f64::from(k)], [1.0, 0.5, f64::from(k)]],
            force,
            shear: 2.5e3,
            slip: 1e-6,
            state,
        };
        let states = [BarState::Elastic, BarState::Yielded, BarState::Slipped, BarState::Broken];
        let bars: Vec<BoltBar> = (0..).zip(states).map(|(k, s)| bar(k, 1e5, s)).collect();
        let text = csv(&bars, |bolt| ["", "", "", "roof.2"][bolt as usize]).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "name,element,x_m,y_m,z_m,axial_force_N,shear_force_N,slip_m,state");
        assert_eq!(lines[1], "roof.2,1,0.5,0.25,0,100000,2500,1e-6,elastic");
        let words: Vec<&str> = lines[1..].iter().filter_map(|l| l.rsplit(',').next()).collect();
        assert_eq!(words, ["elastic", "yielded", "slipped", "broken"]);
        let cells = surfaces(&bars).unwrap();
        assert_eq!(cells.ends, [2, 4, 6, 8]);
        assert_eq!(cells.points[3], [1.0, 0.5, 1.0]);
        let column = |name: &str| {
            let found = cells.columns.iter().find(|c| c.name == name);
            found.map(|c| c.data.clone()).unwrap()
        };
        assert_eq!(column("state"), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(column("axial_force"), [1e5; 4]);
        assert_eq!(column("block_b"), [8.0; 4]);
    }
}
