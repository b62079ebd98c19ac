//! Equilibrium of a chain: Newton's method on the convex potential of springs that give way.

use serde::{Deserialize, Serialize};

use super::{Bar, Hold};

/// Tangents of springs that slip count as this share of the elastic ones, in the matrix only: where both sides of a joint begin to slip,
/// all tangents are zero.
const FLOOR: f64 = 1e-6;
/// What is left of the equilibrium, over the largest force in the chain.
const CLOSE: f64 = 1e-11;
/// Round-off of the elongations, over the stiffest spring times the largest motion.
const ROUND: f64 = 1e-14;
/// Newton steps: 3 to 6 are usual from rest, 11 the most that shocks took.
const STEPS: usize = 60;
/// Steps of the search along a direction, and the share of the slope at its start that ends it.
const SEARCH: (usize, f64) = (40, 0.1);

/// A bar in its grout: what it is made of and its state.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Chain {
    /// What holds each node.
    pub holds: Vec<Hold>,
    /// Bars between the nodes, one fewer.
    pub bars: Vec<Bar>,
    /// Motion of the bar against the rock along the bolt, by node, m.
    pub motion: Vec<f64>,
    /// What of it the grout has slipped, m.
    pub slip: Vec<f64>,
    /// Plastic elongation of each bar, m.
    pub plastic: Vec<f64>,
    /// Length by which each bar has yielded, back and forth, m.
    pub yielded: Vec<f64>,
    /// Force in each bar, N; tension positive.
    pub force: Vec<f64>,
}

impl Chain {
    /// Force (N) of the bar nearest to yielding again among those that have yielded, and the force at which it does; `None` where none has.
    #[must_use]
    pub fn hardened(&self) -> Option<[f64; 2]> {
        let yielded =
            (0..self.bars.len()).filter(|&k| self.yielded[k] > 0.0 && self.bars[k].stiffness > 0.0);
        let forces = yielded.map(|k| {
            let bar = &self.bars[k];
            [self.force[k].abs(), bar.yields + bar.hardening * self.yielded[k]]
        });
        forces.max_by(|[a, b], [c, d]| (a / b).total_cmp(&(c / d)))
    }
}

/// What a step of a chain has cost, J, and how well it is in equilibrium.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Losses {
    /// Yield of bars.
    pub yielded: f64,
    /// Slip of grout and plates.
    pub slipped: f64,
    /// Rupture: what was stored and is nowhere any more.
    pub ruptured: f64,
    /// Bars that have broken.
    pub breaks: usize,
    /// What is left of the equilibrium over the largest force, where the search has not come to its end; else 0.
    pub left: f64,
}

impl Losses {
    /// All of it, J.
    #[must_use]
    pub fn all(&self) -> f64 {
        self.yielded + self.slipped + self.ruptured
    }

    /// Adds another.
    pub fn add(&mut self, other: &Self) {
        self.yielded += other.yielded;
        self.slipped += other.slipped;
        self.ruptured += other.ruptured;
        self.breaks += other.breaks;
        self.left = self.left.max(other.left);
    }
}

/// Room for the solution of a chain, and the factors of its elastic matrix.
#[derive(Clone, Debug, Default)]
pub struct Factors {
    /// Reciprocal pivots of the elastic matrix.
    pivot: Vec<f64>,
    /// Its factors below the diagonal.
    below: Vec<f64>,
    /// What was found at the present motion, and at one that is tried.
    here: Looked,
    there: Looked,
    direction: Vec<f64>,
    trial: Vec<f64>,
}

/// A chain at one motion.
#[derive(Clone, Debug, Default)]
struct Looked {
    /// What is left of the equilibrium at each node, N.
    residual: Vec<f64>,
    /// Tangents of what holds the nodes and of the bars, N/m.
    tangent: [Vec<f64>; 2],
    /// Force in each bar, N.
    force: Vec<f64>,
    /// Largest force, N, and the stiffest bar times the largest motion, N.
    scale: (f64, f64),
    /// Whether anything gives way.
    gives: bool,
}

impl Chain {
    /// A chain at rest.
    #[must_use]
    pub fn new(holds: Vec<Hold>, bars: Vec<Bar>) -> Self {
        let (nodes, pieces) = (holds.len(), bars.len());
        Self {
            holds,
            bars,
            motion: vec![0.0; nodes],
            slip: vec![0.0; nodes],
            plastic: vec![0.0; pieces],
            yielded: vec![0.0; pieces],
            force: vec![0.0; pieces],
        }
    }

    /// All numbers of its state that change, for the hash: by nodes, then by bars.
    #[must_use]
    pub fn memory(&self) -> [&[f64]; 5] {
        [&self.motion, &self.slip, &self.plastic, &self.yielded, &self.force]
    }

    /// Room to solve it, with the factors of the elastic matrix.
    #[must_use]
    pub fn factors(&self) -> Factors {
        let mut found = Factors::default();
        found.refresh(self);
        found
    }

    /// Energy in bars, grout and plate, J.
    #[must_use]
    pub fn stored(&self) -> f64 {
        let bars = self.bars.iter().zip(&self.force);
        let bars: f64 = bars.map(|(bar, n)| bar.stored(*n)).sum();
        let nodes = self.holds.iter().zip(self.motion.iter().zip(&self.slip));
        let held = nodes.map(|(hold, (r, slip))| hold.stored(hold.map(r - slip).force));
        bars + held.sum::<f64>()
    }

    /// The same and that of dowels of `[stiffness, limit]` (N/m, N), if it has any, J; `squares` are those of their forces, N².
    #[must_use]
    pub fn stored_with(&self, dowel: Option<[f64; 2]>, squares: impl Iterator<Item = f64>) -> f64 {
        let stiffness = dowel.map_or(0.0, |d| d[0]);
        let squares: f64 = squares.sum();
        let sheared = if stiffness > 0.0 { 0.5 * squares / stiffness } else { 0.0 };
        self.stored() + sheared
    }

    /// Force by which the rock holds node `k` back, N.
    #[must_use]
    pub fn held(&self, k: usize) -> f64 {
        self.holds[k].map(self.motion[k] - self.slip[k]).force
    }

    /// Finds the equilibrium for the given parting of the rock along each bar since the start (m) and remembers what has yielded,
    /// slipped and broken on the way there.
    pub fn solve(&mut self, apart: &[f64], work: &mut Factors) -> Losses {
        let mut losses = self.balance(apart, None, work);
        loop {
            let torn =
                |k: usize| self.bars[k].stiffness > 0.0 && self.plastic[k] >= self.bars[k].breaks;
            let Some(k) = (0..self.bars.len()).find(|k| torn(*k)) else {
                return losses;
            };
            let before = self.stored();
            self.bars[k].stiffness = 0.0;
            self.force[k] = 0.0;
            work.refresh(self);
            let after = self.balance(apart, None, work);
            losses.add(&after);
            losses.breaks += 1;
            losses.ruptured += before - self.stored() - after.yielded - after.slipped;
        }
    }

    /// Pulls at the head, whose plate does not act, with a force (N), and ties the plate there: the chain then carries this force.
    pub fn stretch(&mut self, force: f64, work: &mut Factors) -> Losses {
        let still = vec![0.0; self.bars.len()];
        let losses = self.balance(&still, Some(force), work);
        let plate = self.holds[0];
        self.slip[0] = self.motion[0] - force / plate.stiffness;
        losses
    }

    /// Equilibrium from the present state; `pull` (N) takes the place of what the plate at node 0 holds.
    fn balance(&mut self, apart: &[f64], pull: Option<f64>, work: &mut Factors) -> Losses {
        let mut losses = Losses::default();
        let mut r = std::mem::take(&mut self.motion);
        losses.left = self.seek(&mut r, apart, pull, work);
        if !work.here.gives && pull.is_none() {
            std::mem::swap(&mut self.force, &mut work.here.force);
            self.motion = r;
            return losses;
        }
        for k in 0..self.bars.len() {
            let along = r[k + 1] - r[k] + apart[k];
            let found = self.bars[k].map(along - self.plastic[k], self.yielded[k]);
            self.plastic[k] += found.plastic;
            self.yielded[k] += found.plastic.abs();
            self.force[k] = found.force;
            losses.yielded += found.force * found.plastic;
        }
        // The plate of a head that is pulled at does not act.
        let first = usize::from(pull.is_some());
        for (k, r) in r.iter().enumerate().skip(first) {
            let found = self.holds[k].map(r - self.slip[k]);
            self.slip[k] += found.plastic;
            losses.slipped += found.force * found.plastic;
        }
        self.motion = r;
        losses
    }

    /// Goes from the motion `r` (m) to equilibrium; what is left of it over the largest force, where the search has not come to its end.
    pub(super) fn seek(
        &self,
        r: &mut Vec<f64>,
        apart: &[f64],
        pull: Option<f64>,
        work: &mut Factors,
    ) -> f64 {
        let mut elastic = true;
        let mut left = f64::INFINITY;
        self.look(r, apart, pull, &mut work.here);
        for step in 0..STEPS {
            let (residual, scale) = (&work.here.residual, work.here.scale);
            left = residual.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            if left <= CLOSE * scale.0 + ROUND * scale.1 {
                left = 0.0;
                break;
            }
            left /= scale.0.max(f64::MIN_POSITIVE);
            if elastic && pull.is_none() {
                work.elastic_direction();
            } else {
                work.tangent_direction(self);
            }
            elastic = false;
            if step + 1 == STEPS {
                break;
            }
            // The last motion that was tried is the one that is taken: what was found there holds.
            self.search(r, apart, pull, work);
            std::mem::swap(r, &mut work.trial);
            std::mem::swap(&mut work.here, &mut work.there);
        }
        left
    }

    /// Looks at the chain where its bar has moved by `r`.
    fn look(&self, r: &[f64], apart: &[f64], pull: Option<f64>, found: &mut Looked) {
        let (mut largest, mut round) = (0.0_f64, 0.0_f64);
        let mut before = 0.0;
        let mut gives = false;
        for k in 0..r.len() {
            let held = match (k, pull) {
                (0, Some(pull)) => super::Mapped { force: pull, tangent: 0.0, plastic: 0.0 },
                _ => self.holds[k].map(r[k] - self.slip[k]),
            };
            let mut force = 0.0;
            if k < self.bars.len() {
                let bar = &self.bars[k];
                let along = r[k + 1] - r[k] + apart[k];
                let mapped = bar.map(along - self.plastic[k], self.yielded[k]);
                force = mapped.force;
                found.tangent[1][k] = mapped.tangent;
                found.force[k] = force;
                gives |= mapped.plastic != 0.0;
                round = round.max(bar.stiffness * (r[k].abs() + apart[k].abs()));
            }
            gives |= held.plastic != 0.0;
            found.tangent[0][k] = held.tangent;
            found.residual[k] = held.force + before - force;
            largest = largest.max(held.force.abs()).max(force.abs());
            before = force;
        }
        found.scale = (largest, round);
        found.gives = gives;
    }

    /// Slope of the potential along the direction at a share of it; what is found there stays in `work.there`.
    fn slope(
        &self,
        r: &[f64],
        share: f64,
        apart: &[f64],
        pull: Option<f64>,
        work: &mut Factors,
    ) -> f64 {
        for (t, (r, d)) in work.trial.iter_mut().zip(r.iter().zip(&work.direction)) {
            *t = r + share * d;
        }
        self.look(&work.trial, apart, pull, &mut work.there);
        let both = work.there.residual.iter().zip(&work.direction);
        both.map(|(x, d)| x * d).sum()
    }

    /// Goes along the direction to where its slope is nearly nil, all of it unless that goes too far: there is `work.trial` then.
    fn search(&self, r: &[f64], apart: &[f64], pull: Option<f64>, work: &mut Factors) {
        let start: f64 = (work.here.residual.iter().zip(&work.direction)).map(|(x, d)| x * d).sum();
        let enough = SEARCH.1 * start.abs();
        let end = self.slope(r, 1.0, apart, pull, work);
        if end <= enough {
            return;
        }
        // Between a falling and a rising end: the secant, with halves of the weight of an end that stays (Illinois).
        let (mut low, mut high) = ((0.0, start), (1.0, end));
        let mut last = 0;
        for _ in 0..SEARCH.0 {
            let share = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let here = self.slope(r, share, apart, pull, work);
            if here.abs() <= enough {
                return;
            }
            if here < 0.0 {
                low = (share, here);
                high.1 *= if last < 0 { 0.5 } else { 1.0 };
                last = -1;
            } else {
                high = (share, here);
                low.1 *= if last > 0 { 0.5 } else { 1.0 };
                last = 1;
            }
        }
        self.slope(r, low.0.max(f64::MIN_POSITIVE), apart, pull, work);
    }
}

impl Factors {
    /// Factors of the elastic matrix of a chain as it is now.
    pub fn refresh(&mut self, chain: &Chain) {
        let nodes = chain.holds.len();
        for list in [&mut self.direction, &mut self.trial] {
            list.resize(nodes, 0.0);
        }
        for looked in [&mut self.here, &mut self.there] {
            looked.residual.resize(nodes, 0.0);
            looked.tangent[0].resize(nodes, 0.0);
            looked.tangent[1].resize(chain.bars.len(), 0.0);
            looked.force.resize(chain.bars.len(), 0.0);
        }
        self.pivot.resize(nodes, 0.0);
        self.below.resize(chain.bars.len(), 0.0);
        let mut carried = 0.0;
        for k in 0..nodes {
            let ahead = chain.bars.get(k).map_or(0.0, |bar| bar.stiffness);
            self.pivot[k] = 1.0 / (chain.holds[k].stiffness + carried + ahead);
            if let Some(below) = self.below.get_mut(k) {
                *below = ahead * self.pivot[k];
                carried = ahead - ahead * *below;
            }
        }
    }

    /// `-A^-1 R` with the elastic matrix.
    #[inline(always)]
    fn elastic_direction(&mut self) {
        let nodes = self.direction.len();
        let mut carried = 0.0;
        for k in 0..nodes {
            let y = -self.here.residual[k] + carried;
            self.direction[k] = y;
            if k + 1 < nodes {
                carried = self.below[k] * y;
            }
        }
        let mut ahead = 0.0;
        for k in (0..nodes).rev() {
            let below = if k + 1 < nodes { self.below[k] } else { 0.0 };
            ahead = self.direction[k] * self.pivot[k] + below * ahead;
            self.direction[k] = ahead;
        }
    }

    /// `-A^-1 R` with the tangents that were found last.
    fn tangent_direction(&mut self, chain: &Chain) {
        let nodes = self.direction.len();
        let floor = |tangent: f64, elastic: f64| tangent.max(FLOOR * elastic);
        let mut carried = (0.0, 0.0);
        for k in 0..nodes {
            let bar = chain.bars.get(k);
            let ahead = bar.map_or(0.0, |bar| floor(self.here.tangent[1][k], bar.stiffness));
            let held = floor(self.here.tangent[0][k], chain.holds[k].stiffness);
            let pivot = 1.0 / (held + carried.0 + ahead);
            let y = -self.here.residual[k] + carried.1;
            // The factors stand where nothing of this step is needed any more.
            self.trial[k] = ahead * pivot;
            self.direction[k] = y * pivot;
            carried = (ahead - ahead * self.trial[k], self.trial[k] * y);
        }
        for k in (0..nodes - 1).rev() {
            self.direction[k] += self.trial[k] * self.direction[k + 1];
        }
    }

    /// Force in each bar where a chain was looked at last, N.
    pub(super) fn found(&self) -> &[f64] {
        &self.here.force
    }

    /// Change of the force in each bar with the parting along bar `k` where a chain was looked at last, N/m.
    pub(super) fn rates(&mut self, chain: &Chain, k: usize, rates: &mut [f64]) {
        let tangent = self.here.tangent[1][k];
        self.here.residual.fill(0.0);
        (self.here.residual[k], self.here.residual[k + 1]) = (-tangent, tangent);
        self.tangent_direction(chain);
        for (b, rate) in rates.iter_mut().enumerate() {
            let own = if b == k { 1.0 } else { 0.0 };
            let along = self.direction[b + 1] - self.direction[b] + own;
            *rate = self.here.tangent[1][b] * along;
        }
    }

    /// Force in each bar of the elastic chain for a parting of the rock along it (m): the stiffness of a bolt as it was built.
    pub fn elastic_forces(&mut self, chain: &Chain, apart: &[f64], forces: &mut [f64]) {
        let nodes = chain.holds.len();
        for k in 0..nodes {
            let before = if k > 0 { chain.bars[k - 1].stiffness * apart[k - 1] } else { 0.0 };
            let after = if k + 1 < nodes { chain.bars[k].stiffness * apart[k] } else { 0.0 };
            self.here.residual[k] = before - after;
        }
        self.elastic_direction();
        for (k, force) in forces.iter_mut().enumerate() {
            let along = self.direction[k + 1] - self.direction[k] + apart[k];
            *force = chain.bars[k].stiffness * along;
        }
    }
}
