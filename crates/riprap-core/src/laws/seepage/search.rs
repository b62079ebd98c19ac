//! The search for the flow: one unknown a node, turns of Newton's method, sweeps in between.
//!
//! The unknown `v` says all of a node: its pressure (m) where it is full; below zero, over the height of the highest pipe that leaves it downward, what its
//! films lack of a full share; above the pressure of an outlet, what runs out. What flows out of the nodes is continuous and piecewise linear in all `v`,
//! grows with the `v` of the node itself and falls with those of others (an M-function).
//!
//! A turn solves the equations of the linear piece at hand. Its step ends where a dry node fills up, at the highest head and at no films: beyond them the piece
//! means nothing. Sweeps then solve for one node after the other, exactly and nonlinearly; they settle what a few neighbours are among themselves, about which turns go in circles.
//!
//! **Why it ends.** A sweep never adds to the sum of the residuals: what leaves one node goes to others or out. Turns in which this sum gets no smaller
//! are undone after [`PATIENCE`] of them, and ever more sweeps are made on the best values. Sweeps alone find the one answer from any start (Rheinboldt
//! 1970, theorem of Gauss-Seidel on M-functions). Only their speed has no bound: what is not found within [`TURNS`] is told ([`super::Flow::is_found`]).

use super::linear::Equations;
use super::{Edge, FOUND, Flow, Network};

/// Share of a pipe that conducts whatever hinders it.
const LEAK: f64 = 1e-6;
/// Share of a dry node's films that is lost: no node is without a way out.
const LOST: f64 = 1e-12;
/// Residual, over the largest possible rate, at which the search ends.
const SMALL: f64 = 1e-12;
/// Pressure over the range of heads with which a node that fills up begins.
const FILLED: f64 = 1e-9;
/// Most turns.
const TURNS: usize = 300;
/// Turns without a smaller sum of residuals after which they are undone.
pub(super) const PATIENCE: usize = 25;
/// What a sum must fall to for the turns to count, as a share of the smallest one.
const SMALLER: f64 = 0.9;
/// Sweeps after a turn, and at first after turns that were undone; most.
const SWEEPS: [usize; 3] = [2, 64, 4096];
/// Parts of a step that are made in turn, from the third turn in vain on: they leave circles.
const PARTS: [f64; 3] = [0.5, 1.0, 0.25];
/// Residual of the linear equations over that before the turn: while pieces change, and later.
const LINEAR: [f64; 2] = [1e-2, 1e-4];
/// Most evaluations of the equation of one node.
const TRIES: usize = 60;

/// A pipe that water can reach, from its upper to its lower node.
#[derive(Clone, Copy)]
struct Fall {
    /// Number of the pipe, and whether its first node is the upper one.
    pipe: usize,
    is_first_upper: bool,
    /// In the order of the search.
    upper: usize,
    lower: usize,
    /// Height between them, m.
    drop: f64,
    conductance: f64,
}

impl Fall {
    /// Rate: `p_u + min(s_u d, d - p_l)`, and the leak.
    fn rate(&self, upper: Water, lower: f64) -> f64 {
        let falling = upper.share * self.drop;
        let least = falling.min(self.drop - lower);
        let films = (1.0 - LEAK) * least + LEAK * (falling - lower);
        self.conductance * (films + upper.pressure)
    }

    /// Whether it carries a film as far as the water of the lower node.
    fn is_film(&self, upper: Water, lower: f64) -> bool {
        upper.share * self.drop < self.drop - lower
    }
}

/// What a node is.
#[derive(Clone, Copy, PartialEq)]
enum State {
    /// The head is given.
    Held,
    /// An outlet that runs.
    Runs,
    Full,
    Dry,
}

/// What the pipes of a node see.
#[derive(Clone, Copy)]
struct Water {
    /// m; below zero only on the way.
    pressure: f64,
    /// Share of films.
    share: f64,
}

/// What of a node does not change.
#[derive(Clone, Copy)]
struct Place {
    is_held: bool,
    /// Pressure that is given, or at which water leaves, m; no bound inside.
    given: f64,
    can_dry: bool,
    /// Height of the highest pipe that leaves it downward, m.
    height: f64,
    /// Sum of the conductances of its pipes.
    conductance: f64,
    /// Pressure under the highest head, m.
    top: f64,
}

impl Place {
    /// Of node `n` where the highest head is `high`, m, and water comes to it or does not.
    fn without_pipes(network: &Network, n: usize, reached: bool, high: f64) -> Self {
        let z = network.heights[n];
        let head = match network.edges[n] {
            _ if !reached => Some(z),
            Edge::Head(head) | Edge::Outlet(head) => Some(head),
            Edge::Inside => None,
        };
        Self {
            is_held: !reached || matches!(network.edges[n], Edge::Head(_)),
            given: head.map_or(f64::INFINITY, |h| (h - z).max(0.0)),
            can_dry: false,
            height: 0.0,
            conductance: 0.0,
            top: (high - z).max(0.0),
        }
    }
}

/// The search; nodes are numbered from the highest to the lowest.
pub(super) struct Search<'a> {
    network: &'a Network,
    /// Node of the network of each of the search.
    order: Vec<usize>,
    falls: Vec<Fall>,
    places: Vec<Place>,
    /// Pipes of node `n`: `links[first[n]..first[n + 1]]`.
    first: Vec<usize>,
    links: Vec<u32>,
    values: Vec<f64>,
    equations: Equations,
    /// Range of heads, m.
    range: f64,
    /// Largest possible rate.
    most: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(network: &'a Network) -> Self {
        let z = &network.heights;
        let mut order: Vec<usize> = (0..z.len()).collect();
        order.sort_by(|a, b| z[*b].total_cmp(&z[*a]).then(a.cmp(b)));
        let mut rank = vec![0; z.len()];
        for (k, n) in order.iter().enumerate() {
            rank[*n] = k;
        }
        let reached = network.reached();
        let falls = falls(network, &reached, &rank);
        let (range, high) = heads(network, &reached);
        let place = |n: &usize| Place::without_pipes(network, *n, reached[*n], high);
        let mut places: Vec<Place> = order.iter().map(place).collect();
        let mut first = vec![0; z.len() + 1];
        for f in &falls {
            let upper = &mut places[f.upper];
            upper.height = upper.height.max(f.drop);
            for n in [f.upper, f.lower] {
                places[n].conductance += f.conductance;
                first[n + 1] += 1;
            }
        }
        for n in 0..z.len() {
            first[n + 1] += first[n];
            let p = &mut places[n];
            // An outlet that holds a pressure has it or less, but it does not fall dry.
            let is_free = p.given == 0.0 || p.given.is_infinite();
            p.can_dry = p.height > 0.0 && !p.is_held && is_free;
        }
        let (mut next, mut links) = (first.clone(), vec![0; 2 * falls.len()]);
        for (k, f) in (0..).zip(&falls) {
            for n in [f.upper, f.lower] {
                links[next[n]] = k;
                next[n] += 1;
            }
        }
        let widest = falls.iter().map(|f| f.conductance).fold(0.0, f64::max);
        // At first all is full, and all outlets run.
        let full = |p: &Place| match (p.is_held, p.given.is_finite()) {
            (true, _) => p.given,
            (false, true) => p.given + FILLED * range,
            (false, false) => FILLED * range,
        };
        Self {
            network,
            values: places.iter().map(full).collect(),
            equations: Equations::new(z.len(), falls.iter().map(|f| [f.upper, f.lower])),
            order,
            falls,
            places,
            first,
            links,
            range,
            most: widest * range,
        }
    }

    fn state(&self, n: usize, v: f64) -> State {
        let p = &self.places[n];
        if p.is_held {
            State::Held
        } else if v > p.given {
            State::Runs
        } else if v >= 0.0 || !p.can_dry {
            State::Full
        } else {
            State::Dry
        }
    }

    fn water(&self, n: usize, v: f64) -> Water {
        let p = &self.places[n];
        let (pressure, share) = match self.state(n, v) {
            State::Held | State::Runs => (p.given, 1.0),
            State::Full => (v, 1.0),
            State::Dry => (0.0, 1.0 + v / p.height),
        };
        Water { pressure, share }
    }

    fn present(&self, n: usize) -> Water {
        self.water(n, self.values[n])
    }

    /// What leaves a node of its own, and how that grows with `v`: through an outlet, or lost.
    fn own(&self, n: usize, v: f64) -> [f64; 2] {
        let p = &self.places[n];
        match self.state(n, v) {
            State::Held | State::Full => [0.0, 0.0],
            State::Runs => [p.conductance * (v - p.given), p.conductance],
            State::Dry => {
                let lost = LOST * p.conductance;
                [lost * (p.height + v), lost]
            }
        }
    }

    /// How the rate of a pipe grows with the `v` of its upper node, and falls with that of its lower one.
    fn slopes(&self, f: &Fall, states: [State; 2], is_film: bool) -> [f64; 2] {
        let share = if is_film { 1.0 } else { LEAK };
        let upper = match states[0] {
            State::Held | State::Runs => 0.0,
            State::Full => 1.0,
            State::Dry => share * f.drop / self.places[f.upper].height,
        };
        let lower = match (states[1], is_film) {
            (State::Held | State::Runs | State::Dry, _) => 0.0,
            (State::Full, true) => LEAK,
            (State::Full, false) => 1.0,
        };
        [f.conductance * upper, f.conductance * lower]
    }

    /// What flows out of each node more than in; nothing where the head is given.
    fn residual(&self) -> Vec<f64> {
        let water: Vec<Water> = (0..self.values.len()).map(|n| self.present(n)).collect();
        let mut out: Vec<f64> =
            (0..self.values.len()).map(|n| self.own(n, self.values[n])[0]).collect();
        for f in &self.falls {
            let rate = f.rate(water[f.upper], water[f.lower].pressure);
            out[f.upper] += rate;
            out[f.lower] -= rate;
        }
        for (out, place) in out.iter_mut().zip(&self.places) {
            if place.is_held {
                *out = 0.0;
            }
        }
        out
    }

    /// The flow; `patience`: turns in vain after which they are undone.
    pub(super) fn find(mut self, patience: usize) -> Flow {
        let mut best = (f64::INFINITY, self.values.clone());
        let (mut vain, mut more, mut turns) = (0, SWEEPS[1], 0);
        let mut tolerance = LINEAR[0];
        while turns < TURNS {
            let rest = self.residual();
            let largest = rest.iter().fold(0.0, |a: f64, r| a.max(r.abs()));
            let sum = size(&rest);
            if largest <= SMALL * self.most || vain > patience / 2 && largest <= FOUND * self.most {
                return self.flow(turns);
            }
            if sum < SMALLER * best.0 {
                best = (sum, self.values.clone());
                vain = 0;
            } else {
                vain += 1;
            }
            turns += 1;
            if vain >= patience {
                self.values = best.1;
                self.sweep(more);
                more = (2 * more).min(SWEEPS[2]);
                best = (size(&self.residual()), self.values.clone());
                vain = 0;
            } else {
                let part = match vain {
                    0..3 => 1.0,
                    _ => PARTS[vain % PARTS.len()],
                };
                let same = self.turn(&rest, tolerance, part);
                tolerance = LINEAR[usize::from(same)];
                // The longer in vain, the more.
                self.sweep(SWEEPS[0] << (vain / 3).min(6));
            }
        }
        if size(&self.residual()) > best.0 {
            self.values = best.1;
        }
        self.flow(turns)
    }

    /// Solves the equations of the piece at hand and goes a part of the way; whether the nodes are then what they were.
    fn turn(&mut self, rest: &[f64], tolerance: f64, part: f64) -> bool {
        let nodes = self.values.len();
        let states: Vec<State> = (0..nodes).map(|n| self.state(n, self.values[n])).collect();
        let weight = |f: &Fall| {
            let is_film = f.is_film(self.present(f.upper), self.present(f.lower).pressure);
            self.slopes(f, [states[f.upper], states[f.lower]], is_film)
        };
        let weights: Vec<[f64; 2]> = self.falls.iter().map(weight).collect();
        let own = |n: usize| match states[n] {
            State::Held => 1.0,
            State::Full if self.first[n] == self.first[n + 1] => 1.0,
            _ => self.own(n, self.values[n])[1],
        };
        let own: Vec<f64> = (0..nodes).map(own).collect();
        self.equations.fill(&weights, &own, |n| states[n] == State::Full);
        let step = self.equations.solve(rest, tolerance);
        let mut same = true;
        for (n, step) in step.iter().enumerate() {
            let place = self.places[n];
            if place.is_held {
                continue;
            }
            let filled = FILLED * self.range;
            let mut v = self.values[n] - part * step;
            if place.can_dry {
                v = v.max(-place.height);
            }
            match states[n] {
                State::Dry => v = v.min(filled),
                State::Full => v = v.min(place.top.max(filled)),
                State::Held | State::Runs => {}
            }
            same &= self.state(n, v) == states[n];
            self.values[n] = v;
        }
        same
    }

    /// Solves for one node after the other, down and up again.
    fn sweep(&mut self, times: usize) {
        for k in 0..times {
            for n in 0..self.values.len() {
                let n = if k % 2 == 0 { n } else { self.values.len() - 1 - n };
                if !self.places[n].is_held {
                    self.values[n] = self.balanced(n);
                }
            }
        }
    }

    /// What flows out of a node more than in if it had the value `v`, and how that grows with `v`.
    fn out(&self, n: usize, v: f64) -> [f64; 2] {
        let (state, water) = (self.state(n, v), self.water(n, v));
        let [mut out, mut slope] = self.own(n, v);
        for &k in &self.links[self.first[n]..self.first[n + 1]] {
            let f = &self.falls[k as usize];
            if f.upper == n {
                let below = self.present(f.lower).pressure;
                out += f.rate(water, below);
                slope += self.slopes(f, [state, State::Held], f.is_film(water, below))[0];
            } else {
                let above = self.present(f.upper);
                out -= f.rate(above, water.pressure);
                slope += self.slopes(f, [State::Held, state], f.is_film(above, water.pressure))[1];
            }
        }
        [out, slope]
    }

    /// The value with which as much flows out of a node as in: Newton's method between bounds.
    fn balanced(&self, n: usize) -> f64 {
        let small = f64::EPSILON * self.places[n].conductance * self.range;
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut v = self.values[n];
        for _ in 0..TRIES {
            let [out, slope] = self.out(n, v);
            if out.abs() <= small || slope <= 0.0 {
                break;
            }
            if out > 0.0 {
                high = v;
            } else {
                low = v;
            }
            let next = v - out / slope;
            v = if next > low && next < high { next } else { 0.5 * (low + high) };
        }
        v
    }

    /// What was found.
    fn flow(&self, turns: usize) -> Flow {
        let pipes = self.network.pipes.len();
        let mut flow = Flow {
            pressures: vec![0.0; self.values.len()],
            ends: vec![[0.0; 2]; pipes],
            rates: vec![0.0; pipes],
            turns,
            left: 0.0,
        };
        for (n, of) in self.order.iter().enumerate() {
            flow.pressures[*of] = self.present(n).pressure.max(0.0);
        }
        for f in &self.falls {
            let (upper, below) = (self.present(f.upper), self.present(f.lower).pressure);
            let above = match self.state(f.upper, self.values[f.upper]) {
                State::Held | State::Runs | State::Full => upper.pressure,
                // With a film the pressure falls to nothing on the way up.
                State::Dry => (below - (1.0 - upper.share) * f.drop).min(0.0),
            };
            let rate = f.rate(upper, below);
            (flow.ends[f.pipe], flow.rates[f.pipe]) =
                if f.is_first_upper { ([above, below], rate) } else { ([below, above], -rate) };
        }
        if self.most > 0.0 {
            for rest in self.residual() {
                let missed = rest.abs() / self.most;
                flow.left = flow.left.max(if missed.is_nan() { f64::INFINITY } else { missed });
            }
        }
        flow
    }
}

/// Pipes that water can reach.
fn falls(network: &Network, reached: &[bool], rank: &[usize]) -> Vec<Fall> {
    let z = &network.heights;
    let fall = |(pipe, p): (usize, &super::Pipe)| {
        let [a, b] = p.ends.map(|n| n as usize);
        let is_first_upper = z[a] >= z[b];
        let (upper, lower) = if is_first_upper { (a, b) } else { (b, a) };
        let is_wet = a != b && reached[a] && p.conductance > 0.0;
        is_wet.then(|| Fall {
            pipe,
            is_first_upper,
            upper: rank[upper],
            lower: rank[lower],
            drop: z[upper] - z[lower],
            conductance: p.conductance,
        })
    };
    network.pipes.iter().enumerate().filter_map(fall).collect()
}

/// Range of the heads that water can have, and the highest, m.
fn heads(network: &Network, reached: &[bool]) -> (f64, f64) {
    let heads = network.edges.iter().zip(&network.heights).zip(reached);
    let heads = heads.filter(|(_, r)| **r).map(|((edge, z), _)| match edge {
        Edge::Head(head) => head.max(*z),
        Edge::Inside | Edge::Outlet(_) => *z,
    });
    let (low, high) =
        heads.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
    if high > low { (high - low, high) } else { (1.0, high) }
}

fn size(rest: &[f64]) -> f64 {
    rest.iter().map(|r| r.abs()).sum()
}
