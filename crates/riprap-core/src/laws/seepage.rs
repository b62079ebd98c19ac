//! Steady flow of water through a network of joints, with the part of it that is wet.
//!
//! Nodes are the places where joints meet, pipes the stretches of joints between them. Pressures `p >= 0` are in metres of water. A node under pressure is
//! full, `s = 1`; one without carries a share `0 <= s <= 1` of what falls freely through the pipes below it. From the upper node `u` of a pipe to the lower
//! one `l`, `d >= 0` below it, flows
//!
//! ```text
//! q = C (p_u + min(s_u d, d - p_l))
//! ```
//!
//! `C` its conductance when full (cubic law: `rho g w^3/(12 mu l)` for each metre of width, `w` the hydraulic aperture): the exact rate in a pipe that is full where there
//! is pressure and carries a film where there is none. The film reaches the water of the lower node (`s_u d`), or the pipe is full to its upper end. In a
//! level pipe it is `C (p_u - p_l)`. What flows into a node flows out of it again. Since `q` grows with what the upper node has and
//! falls with what the lower one has, all together have one answer (an M-function).
//!
//! Where water can leave, the pressure is nothing as long as it does; where it would have to come in, nothing flows (seepage face). Which nodes are full,
//! which pipes carry films and which outlets run is an active set: the equations of a set are linear, the answer says which set comes next, until it stays.
//! From turn `PATIENCE` on only half of the changes is made, drawn by a fixed rule: sets that come again in a circle leave it. If none stays within
//! `TURNS` the flow is not found ([`Flow::is_found`]), and it is for the caller to say so.
//!
//! Deviation: a millionth of a pipe conducts as if films and pressures did not hinder each other, `s_u d - p_l`. Without it the water that stands in a
//! bowl above which nothing flows would be any amount.
//!
//! Sources: Witherspoon et al. (1980), Water Resour. Res. 16, 1016-1024 (cubic law); Brezis, Kinderlehrer & Stampacchia (1978), C. R. Acad. Sci. A 287,
//! 711-714 (full or dry as part of the answer); Rheinboldt (1970), J. Math. Anal. Appl. 32, 274-307 (one answer).

mod linear;
mod rules;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

use linear::Matrix;
pub use rules::{Drain, Side, Steady};

/// Share of a pipe that conducts whatever hinders it.
const LEAK: f64 = 1e-6;
/// Pressure (over the range of heads), share of a film and rate (over the largest possible) that are nothing.
const NOTHING: f64 = 1e-9;
/// What of the rates may not add up at a node, as a share of the largest possible rate, where the flow counts as found.
pub const FOUND: f64 = 1e-8;
/// Most turns.
const TURNS: usize = 300;
/// Turns after which only half of the changes is made.
const PATIENCE: usize = 30;

/// A stretch of a joint between two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// Its nodes.
    pub ends: [u32; 2],
    /// Rate for each metre of difference in head when it is full; any unit, zero or more.
    pub conductance: f64,
}

/// What holds at a node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Edge {
    /// What comes in goes out.
    #[default]
    Inside,
    /// The head is given, m, not below the node.
    Head(f64),
    /// Water leaves at this head (m, not below the node) or not at all: a seepage face, a drain.
    Outlet(f64),
}

/// A network of joints.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// Height of each node, m.
    pub heights: Vec<f64>,
    /// What holds there.
    pub edges: Vec<Edge>,
    /// Pipes between nodes.
    pub pipes: Vec<Pipe>,
}

/// Steady flow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Flow {
    /// Pressure of each node, m of water; nothing where no water reaches it.
    pub pressures: Vec<f64>,
    /// Pressures at the ends of each pipe, m of water: linear between them and nothing where that is below zero.
    pub ends: Vec<[f64; 2]>,
    /// Rate in each pipe from its first to its second node, in the unit of the conductances times m.
    pub rates: Vec<f64>,
    /// Turns until the active set stayed.
    pub turns: usize,
    /// Largest part of a rate that does not add up at a node, over the largest possible rate.
    pub left: f64,
}

impl Flow {
    /// Whether the wet part was found.
    #[must_use]
    pub fn is_found(&self) -> bool {
        self.left <= FOUND
    }
}

impl Network {
    /// The steady flow.
    #[must_use]
    pub fn steady(&self) -> Flow {
        let mut search = Search::new(self);
        let mut turns = 0;
        while turns < TURNS {
            turns += 1;
            search.solve();
            if !search.turn(turns) {
                break;
            }
        }
        search.flow(turns)
    }

    /// Which nodes hang together with a given head.
    fn reached(&self) -> Vec<bool> {
        let heads = self.edges.iter().map(|e| matches!(e, Edge::Head(_)));
        let mut reached: Vec<bool> = heads.collect();
        let mut neighbours = vec![Vec::new(); self.heights.len()];
        for pipe in self.pipes.iter().filter(|p| p.conductance > 0.0) {
            let [a, b] = pipe.ends;
            neighbours[a as usize].push(b);
            neighbours[b as usize].push(a);
        }
        let open = (0..).zip(&reached).filter(|(_, r)| **r);
        let mut open: Vec<u32> = open.map(|(n, _)| n).collect();
        while let Some(n) = open.pop() {
            for &other in &neighbours[n as usize] {
                if !std::mem::replace(&mut reached[other as usize], true) {
                    open.push(other);
                }
            }
        }
        reached
    }
}

/// Where a pipe leads that water reaches.
#[derive(Clone, Copy)]
struct Fall {
    /// Number of the pipe.
    pipe: usize,
    /// Upper and lower node.
    upper: usize,
    lower: usize,
    /// Height between them, m.
    drop: f64,
    conductance: f64,
}

/// The search for the active set.
struct Search<'a> {
    network: &'a Network,
    falls: Vec<Fall>,
    /// Pressure that is given, or held by an outlet that runs, m; not a number inside.
    given: Vec<f64>,
    /// Whether a node can be without pressure: nothing is given and a pipe leads down from it.
    can_dry: Vec<bool>,
    /// Whether an outlet runs; true where a head is given.
    held: Vec<bool>,
    /// Whether a node is full; its unknown is then the pressure (m), else the share of films.
    full: Vec<bool>,
    /// Whether a pipe carries a film.
    film: Vec<bool>,
    /// Unknowns.
    values: Vec<f64>,
    matrix: Matrix,
    /// Range of heads, m.
    range: f64,
    /// Largest possible rate.
    most: f64,
}

impl<'a> Search<'a> {
    fn new(network: &'a Network) -> Self {
        let reached = network.reached();
        let z = &network.heights;
        let fall = |(k, pipe): (usize, &Pipe)| {
            let [a, b] = pipe.ends.map(|n| n as usize);
            let (upper, lower) = if z[a] >= z[b] { (a, b) } else { (b, a) };
            let wet = a != b && reached[a] && pipe.conductance > 0.0;
            wet.then(|| Fall {
                pipe: k,
                upper,
                lower,
                drop: z[upper] - z[lower],
                conductance: pipe.conductance,
            })
        };
        let pipes = network.pipes.iter().enumerate();
        let falls: Vec<Fall> = pipes.filter_map(fall).collect();
        let given = network.edges.iter().zip(z).zip(&reached);
        let given: Vec<f64> = given
            .map(|((edge, z), reached)| match edge {
                Edge::Head(head) | Edge::Outlet(head) if *reached => (head - z).max(0.0),
                Edge::Inside if *reached => f64::NAN,
                Edge::Head(_) | Edge::Outlet(_) | Edge::Inside => 0.0,
            })
            .collect();
        let mut can_dry = vec![false; z.len()];
        for f in falls.iter().filter(|f| f.drop > 0.0) {
            can_dry[f.upper] = given[f.upper].is_nan() || given[f.upper] == 0.0;
        }
        let heads = network.edges.iter().zip(z).zip(&reached);
        let heads = heads.filter(|(_, r)| **r).map(|((edge, z), _)| match edge {
            Edge::Head(head) => *head,
            Edge::Inside | Edge::Outlet(_) => *z,
        });
        let (low, high) = heads.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| {
            (low.min(h), high.max(h))
        });
        let range = if high > low { high - low } else { 1.0 };
        let widest = falls.iter().map(|f| f.conductance).fold(0.0, f64::max);
        Self {
            held: given.iter().map(|g| !g.is_nan()).collect(),
            full: reached,
            film: vec![false; falls.len()],
            values: vec![0.0; z.len()],
            matrix: Matrix::new(z.len(), falls.iter().map(|f| [f.upper, f.lower])),
            most: widest * range,
            network,
            falls,
            given,
            can_dry,
            range,
        }
    }

    /// Pressure of a node, m, as the linear equations have it: below zero where it is not yet dry.
    fn pressure(&self, n: usize) -> f64 {
        if self.full[n] { self.values[n] } else { 0.0 }
    }

    /// Share of films of a node.
    fn share(&self, n: usize) -> f64 {
        if self.full[n] { 1.0 } else { self.values[n] }
    }

    /// Solves the linear equations of the set.
    fn solve(&mut self) {
        let mut constant = vec![0.0; self.values.len()];
        let mut weights = Vec::with_capacity(self.falls.len());
        for (f, film) in self.falls.iter().zip(&self.film) {
            let c = f.conductance;
            let (upper, fixed) = match (self.full[f.upper], *film) {
                (true, _) => (1.0, f.drop),
                (false, true) => (f.drop, 0.0),
                (false, false) => (LEAK * f.drop, (1.0 - LEAK) * f.drop),
            };
            let lower = match (self.full[f.lower], *film) {
                (false, _) => 0.0,
                (true, true) => LEAK,
                (true, false) => 1.0,
            };
            weights.push([c * upper, c * lower]);
            constant[f.upper] += c * fixed;
            constant[f.lower] -= c * fixed;
        }
        for (n, value) in self.values.iter_mut().enumerate() {
            if self.held[n] {
                *value = self.given[n];
            }
        }
        self.matrix.fill(&weights, &self.held);
        self.matrix.solve(&constant, &mut self.values);
    }

    /// Rate of a pipe from its upper to its lower node.
    fn rate(&self, f: &Fall) -> f64 {
        let below = self.pressure(f.lower);
        let falling = self.share(f.upper) * f.drop;
        let least = falling.min(f.drop - below);
        let rate = (1.0 - LEAK) * least + LEAK * (falling - below);
        f.conductance * (rate + self.pressure(f.upper))
    }

    /// What flows out of each node into its pipes.
    fn balance(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.values.len()];
        for f in &self.falls {
            let rate = self.rate(f);
            out[f.upper] += rate;
            out[f.lower] -= rate;
        }
        out
    }

    /// Takes the set that the values say; whether it is another one.
    fn turn(&mut self, turns: usize) -> bool {
        let out = self.balance();
        let nothing = NOTHING * self.range;
        let takes = |n: usize, of: usize| turns < PATIENCE || drawn(n, 2 * turns + of);
        let mut other = false;
        let mut full = self.full.clone();
        for n in 0..full.len() {
            let change = match self.network.edges[n] {
                Edge::Head(_) => false,
                Edge::Outlet(_) if self.held[n] && !self.full[n] => false,
                Edge::Outlet(_) if self.held[n] => out[n] > NOTHING * self.most,
                Edge::Inside if self.held[n] => false,
                Edge::Outlet(_) if self.full[n] && self.values[n] > self.given[n] + nothing => true,
                Edge::Inside | Edge::Outlet(_) if self.full[n] => {
                    self.can_dry[n] && self.values[n] < -nothing
                }
                Edge::Inside | Edge::Outlet(_) => self.values[n] > 1.0 + NOTHING,
            };
            other |= change;
            if !change || !takes(n, 0) {
                continue;
            }
            if matches!(self.network.edges[n], Edge::Outlet(_)) {
                // One that runs dry stops; one that overflows runs.
                let dries = !self.held[n] && self.full[n] && self.values[n] < -nothing;
                if !dries {
                    self.held[n] = !self.held[n];
                }
                full[n] = self.held[n] || !self.can_dry[n];
            } else {
                full[n] = !full[n];
            }
        }
        for (k, f) in self.falls.iter().enumerate() {
            if full[f.upper] || self.held[f.upper] {
                self.film[k] = false;
                continue;
            }
            let below = self.pressure(f.lower);
            if self.full[f.upper] {
                // The upper node has just gone dry.
                self.film[k] = f.drop > below.max(0.0);
                continue;
            }
            let room = f.drop - below - self.values[f.upper] * f.drop;
            let change = if self.film[k] {
                room < -nothing
            } else {
                room > nothing
            };
            other |= change;
            if change && takes(k, 1) {
                self.film[k] = !self.film[k];
            }
        }
        self.full = full;
        other
    }

    /// What was found.
    fn flow(&self, turns: usize) -> Flow {
        let count = self.network.pipes.len();
        let mut flow = Flow {
            pressures: (0..self.values.len())
                .map(|n| self.pressure(n).max(0.0))
                .collect(),
            ends: vec![[0.0; 2]; count],
            rates: vec![0.0; count],
            turns,
            left: 0.0,
        };
        for f in &self.falls {
            let below = self.pressure(f.lower);
            let above = if self.full[f.upper] {
                self.pressure(f.upper)
            } else {
                // With a film the pressure falls to nothing on the way up.
                (below - (1.0 - self.share(f.upper)) * f.drop).min(0.0)
            };
            let rate = self.rate(f);
            let is_first = self.network.pipes[f.pipe].ends[0] as usize == f.upper;
            flow.ends[f.pipe] = if is_first {
                [above, below]
            } else {
                [below, above]
            };
            flow.rates[f.pipe] = if is_first { rate } else { -rate };
        }
        if self.most > 0.0 {
            let out = self.balance();
            for (n, out) in out.iter().enumerate() {
                let missed = match self.network.edges[n] {
                    Edge::Head(_) => 0.0,
                    Edge::Outlet(_) if self.held[n] => out.max(0.0),
                    Edge::Inside | Edge::Outlet(_) => out.abs(),
                };
                let missed = missed / self.most;
                let missed = if missed.is_nan() {
                    f64::INFINITY
                } else {
                    missed
                };
                flow.left = flow.left.max(missed);
            }
        }
        flow
    }
}

/// A fixed draw of half of all numbers, another one in each turn.
fn drawn(number: usize, turn: usize) -> bool {
    let mut x = ((number as u64) << 32) | turn as u64;
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (x ^ (x >> 31)) & 1 == 0
}
