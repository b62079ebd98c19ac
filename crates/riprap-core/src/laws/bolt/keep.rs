//! What is left of a chain when nodes of it go, what the solution of a bolt works with, and what it has cost.

use serde::{Deserialize, Serialize};

use super::{Bar, Chain, Factors, Losses};

/// A chain of which nodes have gone.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// The chain.
    pub chain: Chain,
    /// Its nodes, by their numbers before.
    nodes: Vec<usize>,
}

impl Kept {
    /// The bar that has become of bar `k`: the one behind the last node that is left up to it.
    #[must_use]
    pub fn bar(&self, k: usize) -> Option<usize> {
        let bar = self.nodes.partition_point(|n| *n <= k).checked_sub(1);
        bar.filter(|bar| bar + 1 < self.nodes.len())
    }
}

impl Chain {
    /// The chain of the nodes that stay, with bars one behind the other as one.
    #[must_use]
    pub fn keep(&self, stays: &[bool]) -> Kept {
        let nodes: Vec<usize> = (0..stays.len()).filter(|k| stays[*k]).collect();
        let of = |list: &[f64]| nodes.iter().map(|k| list[*k]).collect::<Vec<f64>>();
        let holds = nodes.iter().map(|k| self.holds[*k]).collect();
        let mut chain = Chain::new(holds, Vec::new());
        (chain.motion, chain.slip) = (of(&self.motion), of(&self.slip));
        for ends in nodes.windows(2) {
            let bars = ends[0]..ends[1];
            let plastic = &self.plastic[bars.clone()];
            let mut bar = in_series(&self.bars[bars.clone()]);
            chain.plastic.push(plastic.iter().sum());
            bar.breaks = breaks(&self.bars[bars.clone()], plastic);
            chain.bars.push(bar);
            chain.yielded.push(self.yielded[bars.clone()].iter().sum());
            chain.force.push(self.force[bars.start]);
        }
        Kept { chain, nodes }
    }
}

/// Plastic elongation (m) at which bars one behind the other break as one that has all of theirs, `plastic` (m).
///
/// `breaks` is the elongation of one place, whatever the length of the bar: the joined bar breaks when what is still to come
/// has broken that of them which has the least left. Their sum alone would tear two bars of which neither has come so far.
fn breaks(bars: &[Bar], plastic: &[f64]) -> f64 {
    // To the bit where nothing is joined.
    if let [bar] = bars {
        return bar.breaks;
    }
    let left = bars.iter().zip(plastic).map(|(bar, p)| bar.breaks - p);
    plastic.iter().sum::<f64>() + left.fold(f64::INFINITY, f64::min)
}

/// Bars one behind the other as one.
fn in_series(bars: &[Bar]) -> Bar {
    let mut all = bars[0];
    // One broken bar of a row lets go of all of it.
    if bars.iter().any(|bar| bar.stiffness == 0.0) {
        all.stiffness = 0.0;
        return all;
    }
    all.stiffness = 1.0 / bars.iter().map(|bar| 1.0 / bar.stiffness).sum::<f64>();
    // Pieces of one bolt: all of them harden, or none.
    if all.hardening > 0.0 {
        all.hardening = 1.0 / bars.iter().map(|bar| 1.0 / bar.hardening).sum::<f64>();
    }
    all
}

/// What the solution of one bolt works with.
#[derive(Clone, Debug, Default)]
pub struct BoltScratch {
    /// Room and factors for the chain.
    pub factors: Factors,
    /// Bars whose ends can part.
    pub stretching: Vec<u32>,
    /// Parting of the rock along each bar, m.
    pub apart: Vec<f64>,
    /// What the last step has cost.
    pub losses: Losses,
    /// The same of its dowels, J.
    pub sheared: f64,
}

impl BoltScratch {
    /// Room for a chain; `stretches` says whether the rock at the ends of a bar can part.
    #[must_use]
    pub fn new(chain: &Chain, stretches: impl Fn(usize) -> bool) -> Self {
        let bars = chain.bars.len();
        Self {
            factors: chain.factors(),
            stretching: (0..bars as u32).filter(|k| stretches(*k as usize)).collect(),
            apart: vec![0.0; bars],
            losses: Losses::default(),
            sheared: 0.0,
        }
    }

    /// Finds the equilibrium of the chain where the rock has parted by `parting(k)` (m) along bar `k`; its dowels have cost nothing yet.
    pub fn solve(&mut self, chain: &mut Chain, parting: impl Fn(usize) -> f64) {
        for &k in &self.stretching {
            self.apart[k as usize] = parting(k as usize);
        }
        self.losses = chain.solve(&self.apart, &mut self.factors);
        self.sheared = 0.0;
    }
}

/// What a bolt has gone through so far. A checkpoint holds these three numbers as if they stood in the bolt itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Toll {
    /// Yield, slip and rupture, J.
    pub lost: f64,
    /// Bars that have broken.
    pub breaks: u32,
    /// The worst that was left of its equilibrium, over its largest force.
    pub left: f64,
}

impl Toll {
    /// Adds what the last step of a bolt has cost; gives the energy it has lost, J.
    pub fn add(&mut self, desk: &BoltScratch) -> f64 {
        let lost = desk.losses.all() + desk.sheared;
        self.lost += lost;
        self.breaks += desk.losses.breaks as u32;
        self.left = self.left.max(desk.losses.left);
        lost
    }
}
