//! Sets of things that hang together.

/// Things by number, joined to sets; the lowest number of a set leads it.
#[derive(Clone, Debug, Default)]
pub struct Sets {
    above: Vec<u32>,
    /// Workspace: numbers of members, by leader.
    members: Vec<u32>,
}

impl Sets {
    /// `count` things, each a set of its own.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let mut sets = Self::default();
        sets.renew(count);
        sets
    }

    /// As [`Sets::new`], in the memory that is there.
    pub fn renew(&mut self, count: usize) {
        self.above.clear();
        self.above.extend(0..count as u32);
    }

    /// The leader of the set of `k`; paths are halved on the way.
    pub fn leader(&mut self, mut k: u32) -> u32 {
        while self.above[k as usize] != k {
            let up = self.above[self.above[k as usize] as usize];
            self.above[k as usize] = up;
            k = up;
        }
        k
    }

    /// Makes one set of those of two things.
    pub fn join(&mut self, two: [u32; 2]) {
        let [a, b] = two.map(|k| self.leader(k));
        self.above[a.max(b) as usize] = a.min(b);
    }

    /// The leader of the set that has most of the things that count, and how many those are; of equal sets the lowest leader. `None`
    /// where none counts.
    pub fn largest(&mut self, counts: impl Fn(usize) -> bool) -> Option<(u32, u32)> {
        let count = self.above.len();
        self.members.clear();
        self.members.resize(count, 0);
        for k in (0..count).filter(|k| counts(*k)) {
            let leader = self.leader(k as u32);
            self.members[leader as usize] += 1;
        }
        let members = || self.members.iter().copied();
        let most = members().max().filter(|most| *most > 0)?;
        let leader = members().position(|count| count == most)?;
        Some((leader as u32, most))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_number_leads() {
        let mut sets = Sets::new(6);
        sets.join([4, 5]);
        sets.join([1, 4]);
        sets.join([0, 2]);
        assert_eq!([0, 1, 2, 3, 4, 5].map(|k| sets.leader(k)), [0, 1, 0, 3, 1, 1]);
        assert_eq!(sets.largest(|_| true), Some((1, 3)));
        // Without one of its members the larger set is no larger than the first.
        assert_eq!(sets.largest(|k| k != 5), Some((0, 2)));
        assert_eq!(sets.largest(|_| false), None);
    }
}
