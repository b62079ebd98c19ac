//! Sums in a fixed order: items are added up over [`GROUP`] consecutive keys and then over a fixed tree of groups, so that
//! bits depend on the keys alone, whatever the threads and however the work is cut into pieces of whole groups.

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
    use super::{Tree, tree};

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
        tree(&mut [], |a: &mut f64, b| *a += b);
        assert_eq!(Tree::<1>::default().sum(), [0.0]);
    }
}
