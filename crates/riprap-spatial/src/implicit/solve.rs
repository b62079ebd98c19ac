//! The implicit step: velocities at its end as the minimum of a convex function, by Newton's method.
//!
//! ```text
//!   L(V) = 1/2 (V - V*)' M (V - V*) + sum over pairs Phi(T V)
//!
//!   V*      velocities with all other forces         M   masses and moments of inertia
//!   T V     twist of a pair at its origin            Phi impulse potential of its pressure and friction
//! ```
//!
//! Each round solves `(M + sum T' K T) dV = -grad L`, and a line search on the slope of L along dV finds how much of it. Friction
//! takes its normal force from the solution before (lagged), and the step is solved again until forces have settled.
//! Where the rounds do not settle, pairs are softened and hardened again by factors of ten: the start of a whole wall at first touch.

#![expect(clippy::needless_range_loop, reason = "indices are rows and columns of several matrices")]

use riprap_core::sparse::{Block, Matrix};
use riprap_geom::{Mat3, Vec3};

use crate::implicit::pair::{Answer, Pair, Pressure, Reply};
use crate::implicit::patch::{Stepping, Twist, dot};
use crate::implicit::tie::Tie;

/// Rounds of Newton's method before pairs are softened.
const ROUNDS: usize = 14;
/// Most rounds in a step.
const MOST: usize = 200;
/// Solutions with new normal forces in friction.
const LAGS: usize = 4;
/// Share of the normal forces that may still change from one solution to the next.
const SETTLED: f64 = 0.02;
/// Of the points of joints that are beyond their strength those fail first whose utilisation is at least this share of the largest; solutions of a step
/// from which on the next share holds.
const FAILING: [(usize, f64); 3] = [(0, 0.98), (8, 0.8), (16, 0.0)];
/// First stiffness of softened pairs, over theirs.
const SOFTEST: f64 = 1e-4;
/// Softened pairs need not settle better than this, over what is asked for.
const ROUGH: f64 = 1e6;

/// A block that moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Body {
    /// kg
    pub mass: f64,
    /// About the centroid, axes of space, kg m².
    pub inertia: Mat3,
    /// Velocity and spin with all other forces.
    pub free: [Vec3; 2],
    /// Freedoms along and about x, y, z that keep these.
    pub held: [bool; 6],
}

/// One step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solver {
    pub bodies: Vec<Body>,
    pub pairs: Vec<Pair>,
    /// Bolts.
    pub ties: Vec<Tie>,
    /// Velocities and spins: those to start from, then the solution.
    pub motion: Vec<[f64; 6]>,
    /// What the pairs have done.
    pub replies: Vec<Reply>,
    next: Vec<Pressure>,
    matrix: Matrix,
    edges: Vec<[u32; 2]>,
    /// Which edge each pair is; those with one block that moves have none.
    edge: Vec<Option<u32>>,
    step: Vec<[f64; 6]>,
    slope: Vec<[f64; 6]>,
    twists: Vec<Twist>,
    /// Twists at the start of the step, where any pair rebounds.
    starts: Vec<Twist>,
    changes: Vec<Twist>,
    spare: Vec<[f64; 2]>,
}

/// How a step was solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Effort {
    /// Factorisations.
    pub rounds: usize,
    /// Solutions with new friction limits.
    pub lags: usize,
    /// Whether pairs were softened on the way.
    pub softened: bool,
    /// Whether the pressure that limits friction came to rest.
    pub settled: bool,
}

/// The rounds have come to no end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unsolved {
    /// Something of this body is not a number.
    NotFinite(usize),
    /// The pair whose force changed most in the last round, and rounds in all.
    Rounds(Option<usize>, usize),
}

impl Solver {
    /// Empties the lists.
    pub(crate) fn begin(&mut self) {
        self.bodies.clear();
        self.pairs.clear();
        self.ties.clear();
        self.motion.clear();
        self.replies.clear();
    }

    /// Twists of the pairs in the solution.
    pub(crate) fn twists(&self) -> &[Twist] {
        &self.twists
    }

    /// Mean speed of the bodies as their energy has it, those that turn included, m/s.
    pub(crate) fn mean_speed(&self) -> f64 {
        let (mut energy, mut mass) = (0.0, 0.0);
        for (body, motion) in self.bodies.iter().zip(&self.motion) {
            energy += dot(&body.momentum_of(motion), motion);
            mass += body.mass;
        }
        if mass > 0.0 { (energy / mass).sqrt() } else { 0.0 }
    }

    /// Solves the step. The last round may change velocities by `exact` (m/s) in the mean; blocks that come together more slowly than `rest` (m/s) do not
    /// rebound.
    pub(crate) fn solve(
        &mut self,
        step: &Stepping,
        rest: f64,
        exact: f64,
    ) -> Result<Effort, Unsolved> {
        self.lay_out();
        self.find_twists();
        self.starts.clear();
        if self.pairs.iter().any(|pair| pair.law.rebound > 0.0) {
            self.starts.extend_from_slice(&self.twists);
        }
        let mut effort = Effort::default();
        self.solve_with_friction(step, exact, &mut effort)?;
        if self.strike(step, rest) {
            self.solve_with_friction(step, exact, &mut effort)?;
        }
        let mut solutions = 0;
        while self.fail(step, solutions) || self.tear(step) {
            self.solve_with_friction(step, exact, &mut effort)?;
            solutions += 1;
        }
        Ok(effort)
    }

    /// Lets bars of bolts tear that are stretched beyond their rupture; whether there are any. Leaves the forces of all bolts at the solution.
    fn tear(&mut self, step: &Stepping) -> bool {
        let mut any = false;
        for tie in &mut self.ties {
            any |= tie.tear(&self.motion, step);
        }
        any
    }

    /// Lets the points of joints fail that are most beyond their strength after so many solutions of this step; whether there are any.
    fn fail(&mut self, step: &Stepping, solutions: usize) -> bool {
        let joints = || self.pairs.iter().zip(&self.twists);
        let used = |(pair, twist): (&Pair, &Twist)| {
            pair.joint.as_ref().map_or(0.0, |joint| joint.weakest(twist, step))
        };
        let most = joints().map(used).fold(0.0, f64::max);
        if most <= 1.0 {
            return false;
        }
        let share = FAILING.iter().rev().find(|(from, _)| solutions >= *from);
        // What is just within its strength holds.
        let from = (share.map_or(0.0, |(_, share)| *share) * most).max(1.0_f64.next_up());
        for (pair, twist) in self.pairs.iter_mut().zip(&self.twists) {
            if let Some(joint) = &mut pair.joint {
                joint.fail(twist, step, from);
            }
        }
        true
    }

    /// Makes impacts of the pairs that have come to press in the solution, and approached each other faster than gravity makes them in a
    /// step; whether there are any.
    fn strike(&mut self, step: &Stepping, rest: f64) -> bool {
        let mut any = false;
        for (k, start) in self.starts.iter().enumerate() {
            let pair = &mut self.pairs[k];
            let comes = pair.area_before == 0.0 && pair.pressure.force > 0.0;
            if pair.law.rebound <= 0.0 || !comes || pair.approach(start) <= rest {
                continue;
            }
            let masses = pair.ends.into_iter().flatten().map(|b| self.bodies[b as usize].mass);
            let mass = masses.fold(f64::INFINITY, f64::min);
            pair.strike(&self.twists[k], start, mass, step, &mut self.spare);
            any = true;
        }
        any
    }

    fn solve_with_friction(
        &mut self,
        step: &Stepping,
        exact: f64,
        effort: &mut Effort,
    ) -> Result<(), Unsolved> {
        for lag in 1..=LAGS {
            effort.lags = lag;
            self.settle(step, exact, effort)?;
            let (mut all, mut changed) = (0.0, 0.0);
            self.next.clear();
            for (pair, twist) in self.pairs.iter_mut().zip(&self.twists) {
                if let Some(joint) = &mut pair.joint {
                    let [force, change] = joint.press(twist, step);
                    all += force;
                    changed += change;
                    self.next.push(Pressure::default());
                    continue;
                }
                let new = pair.pressure_at(twist, step, &mut self.spare);
                all += new.force;
                changed += (new.force - pair.pressure.force).abs();
                self.next.push(new);
            }
            effort.settled = changed <= SETTLED * all;
            let last = effort.settled || lag == LAGS;
            if last {
                // With the limits of friction that the solution was found with: momentum is exact.
                self.reply(step);
            }
            for (pair, new) in self.pairs.iter_mut().zip(&self.next) {
                pair.pressure = *new;
                if let Some(joint) = &mut pair.joint {
                    joint.take_pressure();
                }
            }
            if last {
                break;
            }
        }
        Ok(())
    }

    fn reply(&mut self, step: &Stepping) {
        self.replies.clear();
        for ((pair, twist), next) in self.pairs.iter_mut().zip(&self.twists).zip(&self.next) {
            if let Some(joint) = &mut pair.joint {
                joint.look_open(twist, step);
            }
            let mut reply = pair.reply(twist, step, &mut self.spare);
            let left = pair.left(next.area);
            reply.shear *= left;
            reply.torsion *= left;
            self.replies.push(reply);
        }
    }

    fn lay_out(&mut self) {
        self.edges.clear();
        self.edge.clear();
        for pair in &self.pairs {
            let edge = match pair.ends {
                // A block that meets its own image has a block on the diagonal alone.
                [Some(a), Some(b)] if a != b => {
                    self.edges.push([a, b]);
                    Some(self.edges.len() as u32 - 1)
                }
                _ => None,
            };
            self.edge.push(edge);
        }
        for tie in &mut self.ties {
            tie.add_edges(&mut self.edges);
        }
        self.matrix.fit(self.bodies.len(), &self.edges);
        self.slope.resize(self.bodies.len(), [0.0; 6]);
        self.step.resize(self.bodies.len(), [0.0; 6]);
    }

    /// Newton's method at the friction limits of now.
    fn settle(&mut self, step: &Stepping, exact: f64, effort: &mut Effort) -> Result<(), Unsolved> {
        let mass: f64 = self.bodies.iter().map(|b| b.mass).sum();
        let enough = mass * exact * exact;
        let mut soft = 1.0_f64;
        let mut rounds = 0;
        self.find_twists();
        loop {
            let decrement = self.newton(step, soft)?;
            effort.rounds += 1;
            rounds += 1;
            let done = decrement <= enough;
            // What is known of the last direction is worth a whole step.
            let share = if done { 1.0 } else { self.search(step, soft, decrement) };
            for (v, dv) in self.motion.iter_mut().zip(&self.step) {
                for k in 0..6 {
                    v[k] += share * dv[k];
                }
            }
            self.find_twists();
            if soft < 1.0 && decrement <= ROUGH * enough {
                soft = (10.0 * soft).min(1.0);
                continue;
            }
            if done {
                return Ok(());
            }
            if rounds == ROUNDS && !effort.softened {
                effort.softened = true;
                soft = SOFTEST;
            }
            if rounds > MOST {
                return Err(Unsolved::Rounds(self.restless(step), effort.rounds));
            }
        }
    }

    /// Finds the direction of Newton's method; the decrement `-g dV`.
    fn newton(&mut self, step: &Stepping, soft: f64) -> Result<f64, Unsolved> {
        self.matrix.clear();
        for (k, body) in self.bodies.iter().enumerate() {
            self.matrix.add_diagonal(k, &body.block());
            self.slope[k] = body.momentum_of(&minus(&self.motion[k], &body.free()));
        }
        for (k, pair) in self.pairs.iter().enumerate() {
            let Answer { acts, wrench, rate } =
                pair.answer(&self.twists[k], step, soft, true, &mut self.spare);
            if !acts {
                continue;
            }
            let shifts = pair.centres;
            for side in 0..2 {
                let Some(at) = pair.ends[side] else { continue };
                let sign = [1.0, -1.0][side];
                let on = carry(&wrench, shifts[side]);
                for i in 0..6 {
                    // The wrench pushes the second block, and the slope is that of the impulse potential.
                    self.slope[at as usize][i] += sign * step.span * on[i];
                }
                let held = self.bodies[at as usize].held;
                let block = freed(moved(&rate, shifts[side], shifts[side]), [held, held]);
                self.matrix.add_diagonal(at as usize, &block);
            }
            if let [Some(a), Some(b)] = pair.ends {
                let held = [a, b].map(|at| self.bodies[at as usize].held);
                let mut block = freed(moved(&rate, shifts[0], shifts[1]), held);
                block.iter_mut().flatten().for_each(|x| *x = -*x);
                match self.edge[k] {
                    Some(edge) => self.matrix.add_pair(edge as usize, &block),
                    None => self.matrix.add_diagonal(a as usize, &with_transpose(&block)),
                }
            }
        }
        for tie in &mut self.ties {
            tie.add(&self.motion, step, soft, &mut self.slope, &mut self.matrix);
        }
        for (slope, body) in self.slope.iter_mut().zip(&self.bodies) {
            for (g, held) in slope.iter_mut().zip(body.held) {
                *g = if held { 0.0 } else { *g };
            }
        }
        self.matrix.factor().map_err(|bad| Unsolved::NotFinite(bad.body))?;
        for (to, g) in self.step.iter_mut().zip(&self.slope) {
            *to = g.map(|x| -x);
        }
        self.matrix.solve(&mut self.step);
        let mut decrement = 0.0;
        for (dv, g) in self.step.iter().zip(&self.slope) {
            decrement -= dot(dv, g);
        }
        Ok(decrement)
    }

    /// The pair whose force the last direction changes most.
    fn restless(&self, step: &Stepping) -> Option<usize> {
        let mut spare = Vec::new();
        let mut most = (0.0, None);
        for (k, (pair, twist)) in self.pairs.iter().zip(&self.twists).enumerate() {
            let change = pair.twist(|b| self.step[b as usize], false);
            let Answer { rate, .. } = pair.answer(twist, step, 1.0, true, &mut spare);
            let energy: f64 = rate.iter().zip(&change).map(|(row, x)| x * dot(row, &change)).sum();
            if energy > most.0 {
                most = (energy, Some(k));
            }
        }
        most.1
    }

    /// How much of the direction is gone: where the slope along it is small.
    fn search(&mut self, step: &Stepping, soft: f64, decrement: f64) -> f64 {
        self.changes.clear();
        for pair in &self.pairs {
            self.changes.push(pair.twist(|k| self.step[k as usize], false));
        }
        for tie in &mut self.ties {
            tie.begin_search(&self.motion, &self.step, step);
        }
        let (mut constant, mut linear) = (0.0, 0.0);
        for (k, body) in self.bodies.iter().enumerate() {
            let own = body.momentum_of(&self.step[k]);
            constant += dot(&own, &minus(&self.motion[k], &body.free()));
            linear += dot(&own, &self.step[k]);
        }
        let mut spare = std::mem::take(&mut self.spare);
        let mut ties = std::mem::take(&mut self.ties);
        let mut slope = |share: f64| {
            let mut sum = constant + share * linear;
            for ((pair, twist), change) in self.pairs.iter().zip(&self.twists).zip(&self.changes) {
                let mut at = *twist;
                for k in 0..6 {
                    at[k] += share * change[k];
                }
                let answer = pair.answer(&at, step, soft, false, &mut spare);
                if answer.acts {
                    sum -= step.span * dot(&answer.wrench, change);
                }
            }
            for tie in &mut ties {
                sum += tie.slope(share, step, soft);
            }
            sum
        };
        let share = illinois(&mut slope, decrement);
        (self.spare, self.ties) = (spare, ties);
        share
    }

    fn find_twists(&mut self) {
        self.twists.clear();
        for pair in &self.pairs {
            self.twists.push(pair.twist(|k| self.motion[k as usize], true));
        }
    }
}

/// The root of an increasing slope that is `-decrement` at 0, roughly.
fn illinois(slope: &mut impl FnMut(f64) -> f64, decrement: f64) -> f64 {
    let at_one = slope(1.0);
    if at_one < 0.3 * decrement {
        return 1.0;
    }
    let (mut low, mut high) = ((0.0, -decrement), (1.0, at_one));
    let mut side = 0;
    for round in 1..40 {
        let share = if round % 4 == 0 {
            0.5 * (low.0 + high.0)
        } else {
            (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1)
        };
        let here = slope(share);
        if here.abs() < 0.2 * decrement {
            return share;
        }
        if here > 0.0 {
            high = (share, here);
            if side == 1 {
                low.1 *= 0.5;
            }
            side = 1;
        } else {
            low = (share, here);
            if side == -1 {
                high.1 *= 0.5;
            }
            side = -1;
        }
    }
    low.0.max(1e-3)
}

impl Body {
    /// Its mass and moments of inertia; 1 where a freedom is held.
    fn block(&self) -> Block {
        let mut block = Block::default();
        for i in 0..3 {
            block[i][i] = self.mass;
            for j in 0..3 {
                block[3 + i][3 + j] = self.inertia.col(j)[i];
            }
        }
        let mut block = freed(block, [self.held; 2]);
        for (k, held) in self.held.into_iter().enumerate() {
            if held {
                block[k][k] = 1.0;
            }
        }
        block
    }

    fn free(&self) -> [f64; 6] {
        let [v, w] = self.free;
        [v.x, v.y, v.z, w.x, w.y, w.z]
    }

    fn momentum_of(&self, motion: &[f64; 6]) -> [f64; 6] {
        let [x, y, z, a, b, c] = *motion;
        let turn = self.inertia * Vec3::new(a, b, c);
        [self.mass * x, self.mass * y, self.mass * z, turn.x, turn.y, turn.z]
    }
}

impl Pair {
    /// Twist of the pair for motions of the blocks; `with_given`: that of blocks that do not answer counts.
    fn twist(&self, motion: impl Fn(u32) -> [f64; 6], with_given: bool) -> Twist {
        let mut twist = [0.0; 6];
        for side in 0..2 {
            let [v, w] = match self.ends[side] {
                Some(k) => {
                    let [x, y, z, a, b, c] = motion(k);
                    [Vec3::new(x, y, z), Vec3::new(a, b, c)]
                }
                None if with_given => self.given[side],
                None => continue,
            };
            // At the origin of the pair, which is `-centre` from the centroid.
            let v = v + w.cross(-self.centres[side]);
            let sign = [-1.0, 1.0][side];
            for (k, x) in [v.x, v.y, v.z, w.x, w.y, w.z].into_iter().enumerate() {
                twist[k] += sign * x;
            }
        }
        twist
    }
}

/// A block without the rows and columns of held freedoms.
fn freed(mut block: Block, [rows, columns]: [[bool; 6]; 2]) -> Block {
    for (row, held) in block.iter_mut().zip(rows) {
        for (x, beside) in row.iter_mut().zip(columns) {
            if held || beside {
                *x = 0.0;
            }
        }
    }
    block
}

/// A block and its transpose.
fn with_transpose(block: &Block) -> Block {
    std::array::from_fn(|r| std::array::from_fn(|c| block[r][c] + block[c][r]))
}

fn minus(a: &[f64; 6], b: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// A wrench about the origin of a pair, about a centroid at `centre`.
fn carry(wrench: &Twist, centre: Vec3) -> Twist {
    let [fx, fy, fz, mx, my, mz] = *wrench;
    let moment = Vec3::new(mx, my, mz) - centre.cross(Vec3::new(fx, fy, fz));
    [fx, fy, fz, moment.x, moment.y, moment.z]
}

/// `C1 K C2'` for the shifts of wrenches to two centroids.
fn moved(rate: &[Twist; 6], first: Vec3, second: Vec3) -> Block {
    let mut rows: Block = [[0.0; 6]; 6];
    for (to, row) in rows.iter_mut().zip(rate) {
        // Columns: how a twist at the second centroid is seen from the origin.
        *to = carry(row, second);
    }
    let mut out = rows;
    for c in 0..6 {
        let column: Twist = std::array::from_fn(|r| rows[r][c]);
        let column = carry(&column, first);
        for r in 0..6 {
            out[r][c] = column[r];
        }
    }
    out
}
