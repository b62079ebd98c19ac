//! The linear equations of a network whose active set is known: stabilised biconjugate gradients.
//!
//! Each column of the matrix has a diagonal above zero, nothing above zero beside it and a sum of zero or more. The incomplete factor keeps the matrix but
//! for its diagonal and, nearly, the sums of its columns (Gustafsson 1978, BIT 18, 142-156); the iteration is that of van der Vorst (1992),
//! SIAM J. Sci. Stat. Comput. 13, 631-644. Everything is done in the order of the nodes: the same bits on every machine.

/// Residual over the first one at which a solution is taken.
const SMALL: f64 = 1e-12;
/// Share of what the factor drops that its diagonal takes up.
const KEPT: f64 = 0.97;
/// Most iterations.
const STEPS: usize = 4000;
/// Iterations without a smaller residual after which there is none: round-off.
const IN_VAIN: usize = 100;

/// The matrix of a network: a row for each node.
pub(super) struct Matrix {
    /// Entries of row `n`: `first[n]..first[n + 1]`.
    first: Vec<u32>,
    /// Neighbour, ascending in each row.
    column: Vec<u32>,
    /// Twice the pipe, and one more where the neighbour is its lower node.
    weight: Vec<u32>,
    /// Minus the weight of the neighbour.
    value: Vec<f64>,
    /// Sum of the own weights of a row.
    diagonal: Vec<f64>,
    /// Inverse of the diagonal of the incomplete factor; 0 where the value is held.
    factor: Vec<f64>,
}

impl Matrix {
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
            first,
            column: entries.iter().map(|e| e[1]).collect(),
            weight: entries.iter().map(|e| e[2]).collect(),
            value: vec![0.0; entries.len()],
            diagonal: vec![0.0; nodes],
            factor: vec![0.0; nodes],
        }
    }

    fn range(&self, n: usize) -> std::ops::Range<usize> {
        self.first[n] as usize..self.first[n + 1] as usize
    }

    fn row(&self, n: usize) -> impl DoubleEndedIterator<Item = (usize, f64)> + '_ {
        let range = self.range(n);
        let columns = self.column[range.clone()].iter().map(|c| *c as usize);
        columns.zip(self.value[range].iter().copied())
    }

    /// Gives each pipe the weights of its upper and lower node, and makes the factor for the nodes that are not held.
    pub(super) fn fill(&mut self, weights: &[[f64; 2]], held: &[bool]) {
        let of = |w: u32| weights[w as usize / 2][w as usize % 2];
        for (value, weight) in self.value.iter_mut().zip(&self.weight) {
            *value = -of(*weight);
        }
        let own = |e: usize| of(self.weight[e] ^ 1);
        let nodes = self.diagonal.len();
        // What of a column lies below its diagonal, magnitudes.
        let mut below = vec![0.0; nodes];
        for (n, below) in below.iter_mut().enumerate() {
            let entries = self.range(n);
            self.diagonal[n] = entries.clone().map(own).sum();
            let later = entries.filter(|e| {
                let c = self.column[*e] as usize;
                c > n && !held[c]
            });
            *below = later.map(own).sum();
        }
        for (n, held) in held.iter().enumerate() {
            let mut gone = 0.0;
            for e in self.range(n) {
                let c = self.column[e] as usize;
                if c > n {
                    break;
                }
                let here = -self.value[e];
                gone += own(e) * self.factor[c] * (here + KEPT * (below[c] - here).max(0.0));
            }
            let free = !held && self.diagonal[n] > 0.0;
            self.factor[n] = if free {
                1.0 / (self.diagonal[n] - gone)
            } else {
                0.0
            };
        }
    }

    /// A row times a vector.
    fn times(&self, n: usize, x: &[f64]) -> f64 {
        let others: f64 = self.row(n).map(|(c, v)| v * x[c]).sum();
        self.diagonal[n] * x[n] + others
    }

    fn all_times(&self, x: &[f64], out: &mut [f64]) {
        for (n, out) in out.iter_mut().enumerate() {
            *out = if self.factor[n] == 0.0 {
                0.0
            } else {
                self.times(n, x)
            };
        }
    }

    /// Finds the values that are not held: each row times them and its constant make nothing.
    pub(super) fn solve(&self, constant: &[f64], x: &mut [f64]) {
        let count = x.len();
        for (x, factor) in x.iter_mut().zip(&self.factor) {
            if *factor != 0.0 {
                *x = 0.0;
            }
        }
        let rest = |n: usize| match self.factor[n] == 0.0 {
            true => 0.0,
            false => -constant[n] - self.times(n, x),
        };
        let mut r: Vec<f64> = (0..count).map(rest).collect();
        let end = SMALL * SMALL * dot(&r, &r);
        let shadow = r.clone();
        let (mut rho, mut p) = (dot(&shadow, &r), r.clone());
        let [mut ph, mut v, mut sh, mut t] = [(); 4].map(|()| vec![0.0; count]);
        let (mut least, mut since) = (f64::INFINITY, 0);
        for step in 0..STEPS {
            let left = dot(&r, &r);
            if left < least {
                (least, since) = (left, step);
            }
            // Whether a residual that gets no smaller is small enough, the balance of the flow tells.
            if left <= end || rho == 0.0 || step - since > IN_VAIN {
                return;
            }
            self.precondition(&p, &mut ph);
            self.all_times(&ph, &mut v);
            let alpha = rho / dot(&shadow, &v);
            for n in 0..count {
                x[n] += alpha * ph[n];
                r[n] -= alpha * v[n];
            }
            if dot(&r, &r) <= end {
                return;
            }
            self.precondition(&r, &mut sh);
            self.all_times(&sh, &mut t);
            let omega = dot(&t, &r) / dot(&t, &t);
            for n in 0..count {
                x[n] += omega * sh[n];
                r[n] -= omega * t[n];
            }
            let next = dot(&shadow, &r);
            let beta = next / rho * alpha / omega;
            for n in 0..count {
                p[n] = r[n] + beta * (p[n] - omega * v[n]);
            }
            rho = next;
        }
    }

    /// `z` with `(D + L) D^-1 (D + U) z = r`, D the diagonal of the factor, L and U what of the matrix lies below and above its diagonal.
    fn precondition(&self, r: &[f64], z: &mut [f64]) {
        for n in 0..r.len() {
            let earlier = self.row(n).take_while(|(c, _)| *c < n);
            let known: f64 = earlier.map(|(c, v)| v * z[c]).sum();
            z[n] = self.factor[n] * (r[n] - known);
        }
        for n in (0..r.len()).rev() {
            let later = self.row(n).rev().take_while(|(c, _)| *c > n);
            let known: f64 = later.map(|(c, v)| v * z[c]).sum();
            z[n] -= self.factor[n] * known;
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
