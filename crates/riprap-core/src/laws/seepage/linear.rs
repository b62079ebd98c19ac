//! The linear equations of a turn: generalised conjugate residuals on levels of ever fewer unknowns.
//!
//! Each column of the matrix has a diagonal above zero, nothing above zero beside it and a sum of zero or more. On each level unknowns that hang together most are
//! joined two times by two, with one correction for all of them; a level is solved by at most two steps of the same residuals, each with a cycle of the levels
//! below (K-cycle). Nodes that are not full stay on the first level: what falls goes down, and a sweep in the order of the nodes, which descend, finds it.
//! Everything is done in that order: the same bits on every machine.
//!
//! Sources: Eisenstat, Elman & Schultz (1983), SIAM J. Numer. Anal. 20, 345-357 (conjugate residuals); Notay (2010), Electron. Trans. Numer. Anal. 37,
//! 123-146 (levels by pairs, K-cycle).

use super::rows::{Join, NONE, Rows};

/// Unknowns of a level below which there is none.
const FEW: usize = 40;
/// Reduction of a residual with which one step on a level is enough.
const ENOUGH: f64 = 0.25;
/// Most steps, and steps whose directions are kept.
const STEPS: usize = 300;
const KEPT: usize = 30;
/// Sweeps on the last level.
const LAST: usize = 20;

/// A level below the first.
struct Level {
    /// How the unknowns of the level above are joined.
    join: Join,
    rows: Rows,
}

/// The equations of a turn, on all levels.
pub(super) struct Equations {
    /// Of each entry of the first level: twice the pipe, and one more where the neighbour is its lower node.
    pipe: Vec<u32>,
    rows: Rows,
    levels: Vec<Level>,
}

impl Equations {
    /// The places of the entries; `pipes` are upper and lower nodes.
    pub(super) fn new(nodes: usize, pipes: impl Iterator<Item = [usize; 2]>) -> Self {
        let mut entries: Vec<[u32; 3]> = Vec::new();
        for (k, [upper, lower]) in (0..).zip(pipes) {
            let (upper, lower) = (upper as u32, lower as u32);
            entries.extend([[upper, lower, 2 * k + 1], [lower, upper, 2 * k]]);
        }
        entries.sort_unstable();
        let mut first = vec![0u32; nodes + 1];
        for [row, ..] in &entries {
            first[*row as usize + 1] += 1;
        }
        for n in 0..nodes {
            first[n + 1] += first[n];
        }
        Self {
            pipe: entries.iter().map(|e| e[2]).collect(),
            rows: Rows {
                first,
                column: entries.iter().map(|e| e[1]).collect(),
                value: vec![0.0; entries.len()],
                diagonal: vec![0.0; nodes],
            },
            levels: Vec::new(),
        }
    }

    /// Gives each pipe the weights of its upper and lower node, each diagonal what it has more, and makes the levels; `may`: whether a node is joined to others.
    pub(super) fn fill(&mut self, weights: &[[f64; 2]], own: &[f64], may: impl Fn(usize) -> bool) {
        let of = |w: u32| weights[w as usize / 2][w as usize % 2];
        for (value, pipe) in self.rows.value.iter_mut().zip(&self.pipe) {
            *value = -of(*pipe);
        }
        for (n, own) in own.iter().enumerate() {
            let weights = self.rows.range(n).map(|e| of(self.pipe[e] ^ 1));
            self.rows.diagonal[n] = own + weights.sum::<f64>();
        }
        self.levels.clear();
        let mut once = self.rows.pairs(may);
        let mut half = self.rows.joined(&once);
        loop {
            let twice = half.pairs(|_| true);
            let rows = half.joined(&twice);
            let (few, above) = (rows.len(), once.of.len());
            let join = once.then(&twice);
            self.levels.push(Level { join, rows });
            // Each level is gone through up to twice as often as the one above, and has to be much smaller.
            if few <= FEW || 10 * few > 9 * above {
                return;
            }
            let rows = &self.levels[self.levels.len() - 1].rows;
            once = rows.pairs(|_| true);
            half = rows.joined(&once);
        }
    }

    /// Matrix of a level; 0 is the first.
    fn rows(&self, level: usize) -> &Rows {
        match level {
            0 => &self.rows,
            _ => &self.levels[level - 1].rows,
        }
    }

    /// About what solves the equations of a level.
    fn cycle(&self, level: usize, b: &[f64]) -> Vec<f64> {
        let rows = self.rows(level);
        let nodes = rows.len();
        let mut x = vec![0.0; nodes];
        let Some(below) = self.levels.get(level) else {
            for _ in 0..LAST {
                rows.sweep(0..nodes, b, &mut x);
                rows.sweep((0..nodes).rev(), b, &mut x);
            }
            return x;
        };
        rows.sweep((0..nodes).rev(), b, &mut x);
        let mut rest = vec![0.0; below.join.count];
        for (n, of) in below.join.of.iter().enumerate() {
            if *of != NONE {
                rest[*of as usize] += b[n] - rows.dot(n, &x);
            }
        }
        let correction = self.two_steps(level + 1, &rest);
        for (x, of) in x.iter_mut().zip(&below.join.of) {
            if *of != NONE {
                *x += correction[*of as usize];
            }
        }
        rows.sweep(0..nodes, b, &mut x);
        x
    }

    /// At most two steps of conjugate residuals on a level.
    fn two_steps(&self, level: usize, b: &[f64]) -> Vec<f64> {
        let mut x = self.cycle(level, b);
        if level == self.levels.len() {
            return x;
        }
        let q = self.times(level, &x);
        let qq = dot(&q, &q);
        if qq == 0.0 {
            return x;
        }
        let alpha = dot(&q, b) / qq;
        let r: Vec<f64> = b.iter().zip(&q).map(|(b, q)| b - alpha * q).collect();
        let is_enough = dot(&r, &r) <= ENOUGH * ENOUGH * dot(b, b);
        let z = if is_enough { Vec::new() } else { self.cycle(level, &r) };
        if is_enough {
            x.iter_mut().for_each(|x| *x *= alpha);
            return x;
        }
        let mut s = self.times(level, &z);
        let beta = dot(&s, &q) / qq;
        add(&mut s, -beta, &q);
        let ss = dot(&s, &s);
        let gamma = if ss > 0.0 { dot(&s, &r) / ss } else { 0.0 };
        for (x, z) in x.iter_mut().zip(&z) {
            *x = (alpha - gamma * beta) * *x + gamma * z;
        }
        x
    }

    fn times(&self, level: usize, x: &[f64]) -> Vec<f64> {
        let rows = self.rows(level);
        (0..rows.len()).map(|n| rows.dot(n, x)).collect()
    }

    /// `x` with `A x = b` but for a residual of `small` times `b`.
    pub(super) fn solve(&self, b: &[f64], small: f64) -> Vec<f64> {
        let (mut x, mut r) = (vec![0.0; b.len()], b.to_vec());
        let end = small * small * dot(b, b);
        let mut kept: Vec<(Vec<f64>, Vec<f64>, f64)> = Vec::new();
        for _ in 0..STEPS {
            if dot(&r, &r) <= end {
                break;
            }
            let mut p = self.cycle(0, &r);
            let mut q = self.times(0, &p);
            for (other, of_other, size) in &kept {
                let beta = dot(&q, of_other) / size;
                add(&mut q, -beta, of_other);
                add(&mut p, -beta, other);
            }
            let qq = dot(&q, &q);
            if !(qq > 0.0 && qq.is_finite()) {
                break;
            }
            let alpha = dot(&q, &r) / qq;
            add(&mut x, alpha, &p);
            add(&mut r, -alpha, &q);
            // Each is as long as the model, so that only the last ones are kept.
            if kept.len() == KEPT {
                kept.remove(0);
            }
            kept.push((p, q, qq));
        }
        x
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds a multiple of another vector.
fn add(a: &mut [f64], by: f64, b: &[f64]) {
    for (a, b) in a.iter_mut().zip(b) {
        *a += by * b;
    }
}
