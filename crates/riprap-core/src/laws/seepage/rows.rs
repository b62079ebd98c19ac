//! A matrix by rows, and unknowns of it joined to fewer.

use std::ops::Range;

/// Unknown without a counterpart.
pub(super) const NONE: u32 = u32::MAX;
/// Share of the strongest tie of an unknown from which a tie joins it to another.
const STRONG: f64 = 0.25;
/// Most unknowns that become one at a time.
const MOST: u8 = 3;

/// A square matrix by rows.
#[derive(Default)]
pub(super) struct Rows {
    /// Entries beside the diagonal of row `n`: `first[n]..first[n + 1]`.
    pub(super) first: Vec<u32>,
    pub(super) column: Vec<u32>,
    pub(super) value: Vec<f64>,
    pub(super) diagonal: Vec<f64>,
}

impl Rows {
    pub(super) fn len(&self) -> usize {
        self.diagonal.len()
    }

    pub(super) fn range(&self, n: usize) -> Range<usize> {
        self.first[n] as usize..self.first[n + 1] as usize
    }

    pub(super) fn row(&self, n: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.range(n);
        let columns = self.column[range.clone()].iter().map(|c| *c as usize);
        columns.zip(self.value[range].iter().copied())
    }

    /// What lies beside the diagonal of row `n`, times a vector.
    fn beside(&self, n: usize, x: &[f64]) -> f64 {
        self.row(n).map(|(c, v)| v * x[c]).sum()
    }

    /// Row `n` times a vector.
    pub(super) fn dot(&self, n: usize, x: &[f64]) -> f64 {
        self.diagonal[n] * x[n] + self.beside(n, x)
    }

    /// Solves its equations one after the other.
    pub(super) fn sweep(&self, order: impl Iterator<Item = usize>, b: &[f64], x: &mut [f64]) {
        for n in order {
            x[n] = (b[n] - self.beside(n, x)) / self.diagonal[n];
        }
    }

    /// Joins pairs with the strongest ties, a third one where it would be left alone; unknowns that may not (`may`) or have no tie go nowhere.
    pub(super) fn pairs(&self, may: impl Fn(usize) -> bool) -> Join {
        let mut of = vec![NONE; self.len()];
        let mut sizes: Vec<u8> = Vec::new();
        for n in 0..self.len() {
            if of[n] != NONE || !may(n) {
                continue;
            }
            let (mut strongest, mut free, mut taken) = (0.0, (0.0, NONE), (0.0, NONE));
            for (c, v) in self.row(n) {
                if !may(c) {
                    continue;
                }
                // Entries beside the diagonal of a network are negative.
                let tie = -v;
                strongest = tie.max(strongest);
                if of[c] == NONE && tie > free.0 {
                    free = (tie, c as u32);
                } else if of[c] != NONE && tie > taken.0 && sizes[of[c] as usize] < MOST {
                    taken = (tie, of[c]);
                }
            }
            if strongest == 0.0 {
                continue;
            }
            let one = sizes.len() as u32;
            if free.1 != NONE && free.0 >= STRONG * strongest {
                (of[n], of[free.1 as usize]) = (one, one);
                sizes.push(2);
            } else if taken.1 != NONE {
                of[n] = taken.1;
                sizes[taken.1 as usize] += 1;
            } else {
                of[n] = one;
                sizes.push(1);
            }
        }
        Join { of, count: sizes.len() }
    }

    /// The matrix of joined unknowns: sums of rows and columns.
    pub(super) fn joined(&self, join: &Join) -> Rows {
        let (starts, members) = join.members();
        let mut out = Rows { first: vec![0], ..Rows::default() };
        // Where the entry of a column is in the row at hand.
        let mut place = vec![NONE; join.count];
        for k in 0..join.count {
            let begin = out.column.len();
            let mut diagonal = 0.0;
            for &n in &members[starts[k] as usize..starts[k + 1] as usize] {
                diagonal += self.diagonal[n as usize];
                for (c, v) in self.row(n as usize) {
                    let to = join.of[c];
                    if to == NONE {
                        continue;
                    }
                    let at = place[to as usize] as usize;
                    if to as usize == k {
                        diagonal += v;
                    // What earlier rows have left in the table lies before `begin`.
                    } else if at >= begin && at < out.column.len() {
                        out.value[at] += v;
                    } else {
                        place[to as usize] = out.column.len() as u32;
                        out.column.push(to);
                        out.value.push(v);
                    }
                }
            }
            out.diagonal.push(diagonal);
            out.first.push(out.column.len() as u32);
        }
        out
    }
}

/// Which unknowns are one.
pub(super) struct Join {
    /// Number of what each becomes a part of; [`NONE`] where of nothing.
    pub(super) of: Vec<u32>,
    /// How many these are.
    pub(super) count: usize,
}

impl Join {
    /// Parts of joined unknown `k`: `members[starts[k]..starts[k + 1]]`.
    fn members(&self) -> (Vec<u32>, Vec<u32>) {
        let joined = || (0..).zip(&self.of).filter(|(_, of)| **of != NONE);
        let mut starts = vec![0u32; self.count + 1];
        for (_, of) in joined() {
            starts[*of as usize + 1] += 1;
        }
        for k in 0..self.count {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut members = vec![0u32; starts[self.count] as usize];
        for (n, of) in joined() {
            members[next[*of as usize] as usize] = n;
            next[*of as usize] += 1;
        }
        (starts, members)
    }

    /// First this, then another.
    pub(super) fn then(&self, other: &Join) -> Join {
        let after = |of: &u32| other.of.get(*of as usize).copied().unwrap_or(NONE);
        Join { of: self.of.iter().map(after).collect(), count: other.count }
    }
}
