//! Sums in a fixed order: items are added up over [`GROUP`] consecutive keys and then over a fixed tree of groups, so that
//! bits depend on the keys alone, whatever the threads and however the work is cut into pieces of whole groups.

use std::ops::Range;

/// Consecutive keys whose items are added one after another.
pub const GROUP: usize = 64;

/// Adds up a list over a fixed tree and leaves the sum in its first item (the others hold parts of it): items `0` and
/// `1`, `2` and `3` and so on, then the sums of these pairs, and so on. Parts of `2^k` items can be added by themselves.
pub fn tree<T: Copy>(list: &mut [T], add: impl Fn(&mut T, &T)) {
    let mut stride = 1;
    while stride < list.len() {
        for k in (0..list.len() - stride).step_by(2 * stride) {
            let other = list[k + stride];
            add(&mut list[k], &other);
        }
        stride *= 2;
    }
}

/// A list that is added up by several ranks, each its own part of it, over the fixed tree of the whole list.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shared {
    /// Where the parts begin; one entry more, the length of the list.
    bounds: Vec<usize>,
}

impl Shared {
    /// A list with these parts.
    #[must_use]
    pub fn new(bounds: Vec<usize>) -> Self {
        Self { bounds }
    }

    fn part(&self, rank: usize) -> Range<usize> {
        self.bounds[rank]..self.bounds[rank + 1]
    }

    fn len(&self) -> usize {
        self.bounds.last().copied().unwrap_or(0)
    }

    /// Adds up the branches of the tree that lie in the part of a rank.
    pub fn add_own<T: Copy>(&self, rank: usize, list: &mut [T], add: impl Fn(&mut T, &T)) {
        let own = self.part(rank);
        self.climb(list, add, |branch| own.start <= branch.start && branch.end <= own.end);
    }

    /// Where the sums of these branches stand in the list: what the others must know.
    pub fn tops(&self, rank: usize) -> impl Iterator<Item = usize> {
        let (own, len) = (self.part(rank), self.len());
        let mut next = own.start;
        std::iter::from_fn(move || {
            let at = next;
            let fits = |size: usize| at.is_multiple_of(size) && len.min(at + size) <= own.end;
            let mut size = 1;
            while at + size < len && fits(2 * size) {
                size *= 2;
            }
            next += size;
            (at < own.end).then_some(at)
        })
    }

    /// Adds up what all have added up to the sum of the list, in its first item.
    pub fn add_all<T: Copy>(&self, list: &mut [T], add: impl Fn(&mut T, &T)) {
        let of_one = |branch: &Range<usize>| {
            let rank = self.bounds.partition_point(|first| *first <= branch.start);
            branch.end <= self.bounds.get(rank).copied().unwrap_or(0)
        };
        self.climb(list, add, |branch| !of_one(branch));
    }

    fn climb<T: Copy>(
        &self,
        list: &mut [T],
        add: impl Fn(&mut T, &T),
        mine: impl Fn(&Range<usize>) -> bool,
    ) {
        let (len, mut stride) = (self.len(), 1);
        while stride < len {
            for k in (0..len - stride).step_by(2 * stride) {
                if mine(&(k..len.min(k + 2 * stride))) {
                    let other = list[k + stride];
                    add(&mut list[k], &other);
                }
            }
            stride *= 2;
        }
    }
}

/// [`tree`] of numbers that come one after another, without a list of them.
#[derive(Clone, Debug)]
pub struct Tree<const N: usize> {
    /// Sums of `2^k` items, for the bits `k` of the count.
    levels: [[f64; N]; 48],
    count: u64,
}

impl<const N: usize> Default for Tree<N> {
    fn default() -> Self {
        Self { levels: [[0.0; N]; 48], count: 0 }
    }
}

impl<const N: usize> Tree<N> {
    /// Adds the next item.
    pub fn push(&mut self, item: [f64; N]) {
        let mut sum = item;
        let mut level = 0;
        while self.count >> level & 1 == 1 {
            sum = add(&self.levels[level], &sum);
            level += 1;
        }
        self.levels[level] = sum;
        self.count += 1;
    }

    /// The sum of all items.
    #[must_use]
    pub fn sum(&self) -> [f64; N] {
        let mut levels = (0..self.levels.len()).filter(|k| self.count >> k & 1 == 1);
        let Some(first) = levels.next() else {
            return [0.0; N];
        };
        // What was left over is added last, the largest part first in each sum.
        levels.fold(self.levels[first], |sum, k| add(&self.levels[k], &sum))
    }
}

fn add<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|k| a[k] + b[k])
}

#[cfg(test)]
mod tests {
    use super::{Shared, Tree, tree};

    #[test]
    fn the_tree_does_not_depend_on_how_a_list_is_cut() {
        let sum = |list: &[f64]| {
            let mut list = list.to_vec();
            tree(&mut list, |a, b| *a += b);
            list[0]
        };
        let list: Vec<f64> = (0..1000).map(|k| 1.0 / (1.0 + f64::from(k))).collect();
        for length in [1, 2, 3, 7, 64, 100, 999, 1000] {
            let whole = sum(&list[..length]);
            assert!((whole - list[..length].iter().sum::<f64>()).abs() < 1e-13 * whole);
            for part in [1, 2, 8, 64, 512] {
                let parts: Vec<f64> = list[..length].chunks(part).map(sum).collect();
                assert_eq!(sum(&parts).to_bits(), whole.to_bits(), "{length} {part}");
            }
            let mut one_by_one = Tree::default();
            for x in &list[..length] {
                one_by_one.push([*x]);
            }
            assert_eq!(one_by_one.sum()[0].to_bits(), whole.to_bits(), "{length}");
        }
        for (length, bounds) in [
            (1000, vec![0, 1000]),
            (1000, vec![0, 333, 334, 334, 900, 1000]),
            (7, vec![0, 0, 3, 7]),
            (64, vec![0, 32, 63, 64]),
            (5, vec![0, 1, 2, 3, 4, 5, 5, 5]),
        ] {
            let ranks = bounds.len() - 1;
            let shared = Shared::new(bounds);
            let mut all = vec![f64::NAN; length];
            let mut sent = 0;
            for rank in 0..ranks {
                let mut own = list[..length].to_vec();
                shared.add_own(rank, &mut own, |a, b| *a += b);
                for top in shared.tops(rank) {
                    all[top] = own[top];
                    sent += 1;
                }
            }
            shared.add_all(&mut all, |a, b| *a += b);
            assert_eq!(all[0].to_bits(), sum(&list[..length]).to_bits(), "{length} {ranks}");
            assert!(sent <= 2 * 10 * ranks, "{sent} of {length} by {ranks}");
        }
        tree(&mut [], |a: &mut f64, b| *a += b);
        assert_eq!(Tree::<1>::default().sum(), [0.0]);
    }
}
