//! A bolt in an implicit step: a chain and its dowels, which pull on blocks along lengths that their motion changes.
//!
//! ```text
//!   q(end) = q + dt (s1 . V1 + s2 . V2)      each length: along a bar, along a joint that a dowel crosses
//!   Phi    = span/dt W(q(end))               W: what the chain and its dowels store and lose from here on, convex
//! ```
//!
//! The chain has no mass: it is in equilibrium for each motion that is tried ([`crate::laws::bolt`]). Directions are those of the start of the step; a bar
//! that is pulled holds against what moves its ends across it by its force over its length. A bar that tears is no convex law: bars hold while the step is
//! solved, then the first that is stretched beyond its rupture tears, and the step is solved again.

use riprap_core::sparse::{Block, Matrix};
use riprap_geom::Vec3;

use crate::implicit::patch::{Stepping, Twist, dot};
use crate::laws::bolt::{Ahead, Chain};
use crate::laws::norm;

/// A length that the motion of two blocks changes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Length {
    /// The blocks.
    pub blocks: [u32; 2],
    /// Its rate for motions of both.
    pub screws: [Twist; 2],
    /// Where bodies that move keep what they are given, m.
    pub value: f64,
    /// Places of the blocks in the list of the tie, and the rate for what is free of them.
    places: [Option<u16>; 2],
    free: [Twist; 2],
}

/// A shear spring that gives way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shear {
    /// Number of the bar of the chain without which it holds nothing.
    pub bar: u32,
    /// N/m.
    pub stiffness: f64,
    /// N.
    pub limit: f64,
}

/// One bolt in a step. Its lengths are those along bars that can stretch, two across each of the bars that hold by being pulled, and two for each dowel.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tie {
    pub lengths: Vec<Length>,
    pub chain: Chain,
    /// Bars of the chain that can stretch.
    pub bars: Vec<u32>,
    /// Stiffness across bars, of each length behind those, N/m.
    pub across: Vec<f64>,
    pub dowels: Vec<Shear>,
    /// Bars that tear in the step.
    pub torn: Vec<u32>,
    /// Places among the bodies that move.
    bodies: Vec<u32>,
    /// Number of the first of its pairs of bodies among the edges of the matrix.
    edge: usize,
    ahead: Ahead,
    apart: Vec<f64>,
    values: Vec<f64>,
    /// Rates of the lengths in a search along a direction, m/s.
    changes: Vec<f64>,
    /// Forces by which the lengths pull together, N, and their rates with each other, N/m.
    pub forces: Vec<f64>,
    rates: Vec<f64>,
    row: Vec<f64>,
}

impl Length {
    /// Along `direction` between points `arms` (m) from the centroids of two blocks, of which the second one parts from the first one.
    pub(crate) fn new(blocks: [u32; 2], arms: [Vec3; 2], direction: Vec3, value: f64) -> Self {
        let screw = |sign: f64, arm: Vec3| {
            let (along, about) = (sign * direction, sign * arm.cross(direction));
            [along.x, along.y, along.z, about.x, about.y, about.z]
        };
        let screws = [screw(-1.0, arms[0]), screw(1.0, arms[1])];
        Self { blocks, screws, value, ..Self::default() }
    }
}

impl Tie {
    /// With a chain, without lengths yet.
    pub(crate) fn new(chain: &Chain) -> Self {
        Self {
            chain: chain.clone(),
            ahead: Ahead::new(chain),
            apart: vec![0.0; chain.bars.len()],
            row: vec![0.0; chain.bars.len()],
            ..Self::default()
        }
    }

    /// Finds its blocks among those that move: `place` of each, its `given` motion, and which of its freedoms are held.
    pub(crate) fn attach(
        &mut self,
        step: &Stepping,
        place: impl Fn(u32) -> Option<u32>,
        given: impl Fn(u32) -> Twist,
        held: impl Fn(u32) -> [bool; 6],
    ) {
        let all = self.lengths.iter().flat_map(|length| length.blocks);
        self.bodies = all.filter_map(&place).collect();
        self.bodies.sort_unstable();
        self.bodies.dedup();
        for length in &mut self.lengths {
            for side in 0..2 {
                let at = place(length.blocks[side]);
                let free = at.map_or([false; 6], |at| held(at).map(|held| !held));
                let given = given(length.blocks[side]);
                for k in 0..6 {
                    let rate = length.screws[side][k];
                    (length.free[side][k], length.value) = match free[k] {
                        true => (rate, length.value),
                        false => (0.0, length.value + step.dt * rate * given[k]),
                    };
                }
                let of = |at: u32| self.bodies.binary_search(&at).ok().map(|k| k as u16);
                length.places[side] = at.and_then(of);
            }
        }
        let count = self.lengths.len();
        self.forces.resize(count, 0.0);
        self.rates.resize(count * count, 0.0);
    }

    /// Adds its pairs of bodies to the edges of the matrix.
    pub(crate) fn add_edges(&mut self, edges: &mut Vec<[u32; 2]>) {
        self.edge = edges.len();
        for (k, a) in self.bodies.iter().enumerate() {
            edges.extend(self.bodies[k + 1..].iter().map(|b| [*a, *b]));
        }
    }

    /// Rates of its lengths for motions of the bodies, m/s.
    fn rates_of(&self, motion: &[[f64; 6]], to: &mut Vec<f64>) {
        to.clear();
        for length in &self.lengths {
            let mut rate = 0.0;
            for (place, free) in length.places.iter().zip(&length.free) {
                if let Some(place) = place {
                    rate += dot(free, &motion[self.bodies[usize::from(*place)] as usize]);
                }
            }
            to.push(rate);
        }
    }

    /// Lengths at the end of a step with these motions.
    fn stretch(&mut self, motion: &[[f64; 6]], step: &Stepping) {
        let mut values = std::mem::take(&mut self.values);
        self.rates_of(motion, &mut values);
        for (value, length) in values.iter_mut().zip(&self.lengths) {
            *value = length.value + step.dt * *value;
        }
        self.values = values;
    }

    /// Finds its forces at lengths, and how they change with these where `with_rates`.
    fn pull(&mut self, values: &[f64], soft: f64, with_rates: bool) {
        let count = values.len();
        for (k, value) in self.bars.iter().zip(values) {
            self.apart[*k as usize] = *value;
        }
        let forces = self.ahead.forces(&self.chain, &self.apart);
        for (force, k) in self.forces.iter_mut().zip(&self.bars) {
            *force = soft * forces[*k as usize];
        }
        if with_rates {
            self.rates.fill(0.0);
            for (a, k) in self.bars.iter().enumerate() {
                self.ahead.rate(&self.chain, *k as usize, &mut self.row);
                for (b, other) in self.bars.iter().enumerate() {
                    self.rates[b * count + a] = soft * self.row[*other as usize];
                }
            }
        }
        let mut at = self.bars.len();
        for stiffness in &self.across {
            self.forces[at] = soft * stiffness * values[at];
            if with_rates {
                self.rates[at * count + at] = soft * stiffness;
            }
            at += 1;
        }
        for dowel in &self.dowels {
            let holds = self.chain.bars[dowel.bar as usize].stiffness > 0.0;
            let limit = if holds { dowel.limit } else { 0.0 };
            let trial = [0, 1].map(|k| dowel.stiffness * values[at + k]);
            let size = norm(trial[0], trial[1]);
            let share = if size > limit { limit / size } else { 1.0 };
            for k in 0..2 {
                self.forces[at + k] = soft * share * trial[k];
                for l in 0..2 {
                    if with_rates {
                        let mut along = if k == l { 1.0 } else { 0.0 };
                        if share < 1.0 {
                            along -= trial[k] * trial[l] / (size * size);
                        }
                        self.rates[(at + k) * count + at + l] =
                            soft * dowel.stiffness * share * along;
                    }
                }
            }
            at += 2;
        }
    }

    /// Finds its forces at the end of a step with these motions.
    pub(crate) fn look(&mut self, motion: &[[f64; 6]], step: &Stepping, soft: f64, rates: bool) {
        self.stretch(motion, step);
        let values = std::mem::take(&mut self.values);
        self.pull(&values, soft, rates);
        self.values = values;
    }

    /// Adds what it exerts in a step to the slope of the impulse potential, and its second derivative to the matrix.
    pub(crate) fn add(
        &mut self,
        motion: &[[f64; 6]],
        step: &Stepping,
        soft: f64,
        slope: &mut [[f64; 6]],
        matrix: &mut Matrix,
    ) {
        self.look(motion, step, soft, true);
        for (length, force) in self.lengths.iter().zip(&self.forces) {
            for (place, free) in length.places.iter().zip(&length.free) {
                let Some(place) = place else { continue };
                let on = &mut slope[self.bodies[usize::from(*place)] as usize];
                for k in 0..6 {
                    on[k] += step.span * force * free[k];
                }
            }
        }
        let scale = step.span * step.dt;
        let mut edge = self.edge;
        for a in 0..self.bodies.len() {
            matrix.add_diagonal(self.bodies[a] as usize, &self.block(a, a, scale));
            for b in a + 1..self.bodies.len() {
                matrix.add_pair(edge, &self.block(a, b, scale));
                edge += 1;
            }
        }
    }

    /// Second derivative between two of its bodies.
    fn block(&self, a: usize, b: usize, scale: f64) -> Block {
        let mut block = Block::default();
        let count = self.lengths.len();
        let sides = |length: &Length, of: usize| -> Option<Twist> {
            let mut sum: Option<Twist> = None;
            for (place, free) in length.places.iter().zip(&length.free) {
                if place.is_some_and(|place| usize::from(place) == of) {
                    let sum = sum.get_or_insert([0.0; 6]);
                    (0..6).for_each(|k| sum[k] += free[k]);
                }
            }
            sum
        };
        for (i, first) in self.lengths.iter().enumerate() {
            let Some(left) = sides(first, a) else { continue };
            for (j, second) in self.lengths.iter().enumerate() {
                let rate = scale * self.rates[i * count + j];
                if rate == 0.0 {
                    continue;
                }
                let Some(right) = sides(second, b) else { continue };
                for r in 0..6 {
                    for c in 0..6 {
                        block[r][c] += rate * left[r] * right[c];
                    }
                }
            }
        }
        block
    }

    /// Begins a search from motions along a direction.
    pub(crate) fn begin_search(
        &mut self,
        motion: &[[f64; 6]],
        along: &[[f64; 6]],
        step: &Stepping,
    ) {
        self.stretch(motion, step);
        let mut changes = std::mem::take(&mut self.changes);
        self.rates_of(along, &mut changes);
        self.changes = changes;
    }

    /// Slope of the impulse potential along the direction of the search at a share of it.
    pub(crate) fn slope(&mut self, share: f64, step: &Stepping, soft: f64) -> f64 {
        let both = self.values.iter().zip(&self.changes);
        let values: Vec<f64> = both.map(|(q, rate)| q + share * step.dt * rate).collect();
        self.pull(&values, soft, false);
        let mut sum = 0.0;
        for (force, rate) in self.forces.iter().zip(&self.changes) {
            sum += step.span * force * rate;
        }
        sum
    }

    /// Lets the first bar tear that is stretched beyond its rupture at the end of a step with these motions; whether there is any.
    pub(crate) fn tear(&mut self, motion: &[[f64; 6]], step: &Stepping) -> bool {
        self.look(motion, step, 1.0, false);
        let torn = self.ahead.torn(&self.chain, &self.apart);
        if let Some(k) = torn {
            self.chain.bars[k].stiffness = 0.0;
            self.torn.push(k as u32);
            self.ahead.refresh(&self.chain);
        }
        torn.is_some()
    }
}
