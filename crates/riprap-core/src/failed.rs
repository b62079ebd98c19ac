//! Failed points of joints that are no longer in the lists of joints.
//!
//! A share of failed points falls when found contact takes a joint over or a block is removed: the joint leaves the list. What had failed
//! by then is kept here, so that a count never falls. It is reported and decides nothing, so it is state and in no hash.

use serde::{Deserialize, Serialize};

/// Number of failed points by the two blocks of their joints, sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct FailedPoints(Vec<([u32; 2], u64)>);

impl FailedPoints {
    /// Adds the failed points of a joint that goes.
    pub fn add(&mut self, [i, j]: [u32; 2], count: u64) {
        if count == 0 {
            return;
        }
        let ends = [i.min(j), i.max(j)];
        match self.0.binary_search_by_key(&ends, |(ends, _)| *ends) {
            Ok(k) => self.0[k].1 += count,
            Err(k) => self.0.insert(k, (ends, count)),
        }
    }

    /// Sum over the joints between blocks that `chosen` takes; the smaller number first.
    #[must_use]
    pub fn count(&self, chosen: impl Fn([u32; 2]) -> bool) -> u64 {
        let such = self.0.iter().filter(|(ends, _)| chosen(*ends));
        such.map(|(_, count)| count).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::FailedPoints;

    #[test]
    fn counts_add_up_in_either_order_of_the_blocks() {
        let mut failed = FailedPoints::default();
        for (ends, count) in [([3, 1], 4), ([0, 2], 1), ([1, 3], 2), ([5, 6], 0)] {
            failed.add(ends, count);
        }
        assert_eq!(failed.count(|_| true), 7);
        assert_eq!(failed.count(|ends| ends == [1, 3]), 6);
        assert_eq!(failed.count(|ends| ends.contains(&5)), 0);
    }
}
