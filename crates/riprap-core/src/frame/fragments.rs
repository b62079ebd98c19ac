//! Fragments: blocks that unbroken joints hold together.

use crate::sets::Sets;

/// Blocks joined to one another, directly or through others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// Number of its blocks.
    pub blocks: u32,
    /// Volume, m³; in the plane area, m².
    pub size: f64,
    /// Centre of volume, m, global axes.
    pub centre: [f64; 3],
    /// Whether it holds a block all of whose freedoms are prescribed: it is ground, or joined to it, and no fragment of a muckpile.
    pub held: bool,
}

/// A block, as fragments are made of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// Volume, m³; in the plane area, m².
    pub size: f64,
    /// Centroid, m, global axes.
    pub centre: [f64; 3],
    /// Whether all its freedoms are prescribed.
    pub held: bool,
}

/// Fragments of one moment, the largest first (equal ones in the order of their first blocks), then what is held.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fragments {
    /// The list.
    pub list: Vec<Fragment>,
    /// Place in the list of the fragment of each block; `None` of blocks that are gone.
    pub of: Vec<Option<u32>>,
    /// Whether sizes are areas and places have two coordinates.
    pub planar: bool,
}

impl Fragments {
    /// Gathers blocks; `None` for those that are gone. `joined` are pairs of blocks held together.
    #[must_use]
    pub fn new(
        blocks: &[Option<Member>],
        joined: impl Iterator<Item = [u32; 2]>,
        planar: bool,
    ) -> Self {
        let mut sets = Sets::new(blocks.len());
        for two in joined {
            sets.join(two);
        }
        let mut place = vec![u32::MAX; blocks.len()];
        let mut list: Vec<Fragment> = Vec::new();
        let mut of = vec![None; blocks.len()];
        for (b, block) in blocks.iter().enumerate() {
            let Some(block) = block else {
                continue;
            };
            let lead = sets.leader(b as u32) as usize;
            if place[lead] == u32::MAX {
                place[lead] = list.len() as u32;
                list.push(Fragment { blocks: 0, size: 0.0, centre: [0.0; 3], held: false });
            }
            of[b] = Some(place[lead]);
            let fragment = &mut list[place[lead] as usize];
            fragment.blocks += 1;
            fragment.size += block.size;
            fragment.held |= block.held;
            for (sum, x) in fragment.centre.iter_mut().zip(block.centre) {
                *sum += block.size * x;
            }
        }
        for fragment in &mut list {
            fragment.centre = fragment.centre.map(|x| x / fragment.size);
        }
        let mut order: Vec<u32> = (0..list.len() as u32).collect();
        order.sort_by(|a, b| {
            let [a, b] = [a, b].map(|k| &list[*k as usize]);
            a.held.cmp(&b.held).then(b.size.total_cmp(&a.size))
        });
        let mut rank = vec![0; list.len()];
        for (k, from) in order.iter().enumerate() {
            rank[*from as usize] = k as u32;
        }
        for fragment in of.iter_mut().flatten() {
            *fragment = rank[*fragment as usize];
        }
        let list = order.iter().map(|k| list[*k as usize]).collect();
        Self { list, of, planar }
    }

    /// Those that nothing holds, the largest first.
    pub fn loose(&self) -> impl Iterator<Item = &Fragment> {
        self.list.iter().filter(|f| !f.held)
    }

    /// Those that nothing holds and that have one of these blocks, the largest first.
    #[must_use]
    pub fn loose_with(&self, blocks: impl Iterator<Item = usize>) -> Vec<&Fragment> {
        let mut wanted: Vec<u32> = blocks.filter_map(|b| *self.of.get(b)?).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let all = wanted.iter().map(|k| &self.list[*k as usize]);
        all.filter(|f| !f.held).collect()
    }

    /// The table `fragments.csv`.
    #[must_use]
    pub fn csv(&self) -> String {
        let number = crate::field::number;
        let mut text = String::from(if self.planar {
            "fragment,blocks,area_m2,x_m,y_m,held\n"
        } else {
            "fragment,blocks,volume_m3,x_m,y_m,z_m,held\n"
        });
        for (k, fragment) in self.list.iter().enumerate() {
            text.push_str(&format!("{},{}", k + 1, fragment.blocks));
            let places = if self.planar { 2 } else { 3 };
            for x in std::iter::once(&fragment.size).chain(&fragment.centre[..places]) {
                text.push(',');
                text.push_str(&number(*x));
            }
            text.push_str(if fragment.held { ",1\n" } else { ",0\n" });
        }
        text
    }

    /// The table `fragment_blocks.csv`: which fragment each block is in.
    #[must_use]
    pub fn members_csv(&self) -> String {
        let mut text = String::from("block,fragment\n");
        for (b, fragment) in self.of.iter().enumerate() {
            if let Some(fragment) = fragment {
                text.push_str(&format!("{b},{}\n", fragment + 1));
            }
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(size: f64, centre: [f64; 3], held: bool) -> Option<Member> {
        Some(Member { size, centre, held })
    }

    #[test]
    fn joined_blocks_are_one_fragment() {
        let at = |x: f64| block(2.0, [x, 0.0, 1.0], false);
        let blocks = [at(0.0), at(1.0), None, at(5.0), at(2.0), block(7.0, [9.0; 3], false)];
        let pairs = [[4, 1], [0, 1]];
        let found = Fragments::new(&blocks, pairs.into_iter(), false);
        let other = Fragments::new(&blocks, pairs.into_iter().rev(), false);
        assert_eq!(found, other);
        let sizes: Vec<(u32, f64)> = found.list.iter().map(|f| (f.blocks, f.size)).collect();
        assert_eq!(sizes, [(1, 7.0), (3, 6.0), (1, 2.0)]);
        assert_eq!(found.list[1].centre, [1.0, 0.0, 1.0]);
        let text = found.csv();
        assert!(text.starts_with(
            "fragment,blocks,volume_m3,x_m,y_m,z_m,held\n1,1,7,9,9,9,0\n2,3,6,1,0,1,0\n"
        ));
        assert_eq!(found.members_csv(), "block,fragment\n0,2\n1,2\n3,3\n4,2\n5,1\n");
    }

    #[test]
    fn what_is_held_is_no_fragment_nor_what_is_joined_to_it() {
        let at = |size: f64, held| block(size, [0.0; 3], held);
        let blocks = [at(100.0, true), at(1.0, false), at(3.0, false), at(2.0, false)];
        let found = Fragments::new(&blocks, [[0, 3]].into_iter(), false);
        let sizes: Vec<(f64, bool)> = found.list.iter().map(|f| (f.size, f.held)).collect();
        assert_eq!(sizes, [(3.0, false), (1.0, false), (102.0, true)]);
        assert_eq!(found.loose().count(), 2);
        assert_eq!(found.of, [Some(2), Some(1), Some(0), Some(2)]);
        let with = found.loose_with([0, 1, 3, 1].into_iter());
        assert_eq!(with.iter().map(|f| f.size).collect::<Vec<_>>(), [1.0]);
    }

    #[test]
    fn in_the_plane_sizes_are_areas() {
        let blocks = [block(1.5, [1.0, 2.0, 0.0], false)];
        let found = Fragments::new(&blocks, std::iter::empty(), true);
        assert_eq!(found.csv(), "fragment,blocks,area_m2,x_m,y_m,held\n1,1,1.5,1,2,0\n");
    }
}
