//! Where a list of pieces is cut among ranks, by the time that each rank takes for its part.

use std::ops::Range;

/// Steps between two looks at how the ranks are in balance.
const LOOK: u32 = 64;
/// What the slowest rank may take beyond the mean before the list is cut again.
const BALANCE: f64 = 1.1;

/// A list of pieces, cut among ranks. Bits of results do not depend on it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cuts {
    /// Where the part of each rank begins; one entry more, the length of the list.
    bounds: Vec<usize>,
    /// Time that each has taken since the last look, s.
    spent: Vec<f64>,
    steps: u32,
}

impl Cuts {
    /// Equal parts.
    pub(crate) fn new(size: usize, count: usize) -> Self {
        let bounds = (0..=size).map(|rank| rank * count / size).collect();
        Self { bounds, spent: vec![0.0; size], steps: 0 }
    }

    /// The part of a rank.
    pub(crate) fn part(&self, rank: usize) -> Range<usize> {
        self.bounds[rank]..self.bounds[rank + 1]
    }

    /// All bounds.
    pub(crate) fn bounds(&self) -> &[usize] {
        &self.bounds
    }

    fn count(&self) -> usize {
        self.bounds.last().copied().unwrap_or(0)
    }

    /// Follows a list that has become longer or shorter.
    pub(crate) fn fit(&mut self, count: usize) {
        let old = self.count();
        if old == count {
            return;
        }
        let size = self.spent.len();
        *self = match old {
            0 => Self::new(size, count),
            _ => Self {
                bounds: self.bounds.iter().map(|at| at * count / old).collect(),
                spent: vec![0.0; size],
                steps: 0,
            },
        };
    }

    /// Books what a step has taken each rank (s), the same numbers on all of them; where the list should be cut from now on ([`Self::cut_at`]),
    /// if that is elsewhere.
    pub(crate) fn book(&mut self, times: &[f64]) -> Option<Vec<usize>> {
        for (sum, time) in self.spent.iter_mut().zip(times) {
            *sum += time;
        }
        self.steps += 1;
        if self.steps < LOOK {
            return None;
        }
        let bounds = self.balanced();
        self.spent.fill(0.0);
        self.steps = 0;
        (bounds != self.bounds).then_some(bounds)
    }

    /// Cuts the list there.
    pub(crate) fn cut_at(&mut self, bounds: Vec<usize>) {
        self.bounds = bounds;
    }

    /// Where each part would have taken the same time, if each rank had taken the same for all of its pieces.
    fn balanced(&self) -> Vec<usize> {
        let mut bounds = self.bounds.clone();
        let size = self.spent.len();
        let mean = self.spent.iter().sum::<f64>() / size as f64;
        let most = self.spent.iter().copied().fold(0.0, f64::max);
        let judged = mean > 0.0 && mean.is_finite();
        if !judged || most <= BALANCE * mean {
            return bounds;
        }
        let old = &self.bounds;
        let (mut rank, mut before) = (0, 0.0);
        for cut in 1..size {
            let wanted = cut as f64 * mean;
            while rank + 1 < size && before + self.spent[rank] < wanted {
                before += self.spent[rank];
                rank += 1;
            }
            let (part, time) = (old[rank]..old[rank + 1], self.spent[rank]);
            let share = if time > 0.0 { ((wanted - before) / time).clamp(0.0, 1.0) } else { 0.0 };
            let at = part.start + (share * part.len() as f64).round() as usize;
            bounds[cut] = at.clamp(bounds[cut - 1], self.count());
        }
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::{Cuts, LOOK};

    #[test]
    fn a_list_is_cut_where_all_take_the_same_time() {
        // The first hundred pieces cost ten times as much as the others.
        let cost = |piece: usize| if piece < 100 { 10.0 } else { 1.0 };
        let mut cuts = Cuts::new(4, 1000);
        let times = |cuts: &Cuts| [0, 1, 2, 3].map(|rank| cuts.part(rank).map(cost).sum::<f64>());
        let mut renewed = 0;
        for _ in 0..20 * LOOK {
            let taken = times(&cuts);
            if let Some(bounds) = cuts.book(&taken) {
                cuts.cut_at(bounds);
                renewed += 1;
            }
        }
        let taken = times(&cuts);
        assert!(taken.iter().all(|t| *t < 1.11 * 475.0), "{taken:?} {cuts:?}");
        assert!(renewed > 0 && renewed < 10, "{renewed}");
        cuts.fit(500);
        assert_eq!((cuts.part(0).start, cuts.part(3).end), (0, 500));
        // More ranks than pieces, and times of nothing.
        let mut few = Cuts::new(8, 3);
        for _ in 0..3 * LOOK {
            if let Some(bounds) = few.book(&[1.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0]) {
                few.cut_at(bounds);
            }
        }
        assert_eq!((few.part(0).start, few.part(7).end), (0, 3));
        assert!((0..8).all(|rank| few.part(rank).start <= few.part(rank).end));
        few.fit(0);
        few.fit(7);
        assert_eq!(few.part(7).end, 7);
    }
}
