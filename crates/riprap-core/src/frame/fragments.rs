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
}

/// Fragments of one moment, the largest first (equal ones in the order of their first blocks).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fragments {
    /// The list.
    pub list: Vec<Fragment>,
    /// Whether sizes are areas and places have two coordinates.
    pub planar: bool,
}

impl Fragments {
    /// Gathers blocks, each with size (m³ or m²) and centre (m); `None` for those that are gone. `joined` are pairs of blocks
    /// held together.
    #[must_use]
    pub fn new(
        blocks: &[Option<(f64, [f64; 3])>],
        joined: impl Iterator<Item = [u32; 2]>,
        planar: bool,
    ) -> Self {
        let mut sets = Sets::new(blocks.len());
        for two in joined {
            sets.join(two);
        }
        let mut place = vec![u32::MAX; blocks.len()];
        let mut list: Vec<Fragment> = Vec::new();
        for (b, block) in blocks.iter().enumerate() {
            let Some((size, centre)) = block else {
                continue;
            };
            let lead = sets.leader(b as u32) as usize;
            if place[lead] == u32::MAX {
                place[lead] = list.len() as u32;
                list.push(Fragment {
                    blocks: 0,
                    size: 0.0,
                    centre: [0.0; 3],
                });
            }
            let fragment = &mut list[place[lead] as usize];
            fragment.blocks += 1;
            fragment.size += size;
            for (sum, x) in fragment.centre.iter_mut().zip(centre) {
                *sum += size * x;
            }
        }
        for fragment in &mut list {
            fragment.centre = fragment.centre.map(|x| x / fragment.size);
        }
        list.sort_by(|a, b| b.size.total_cmp(&a.size));
        Self { list, planar }
    }

    /// The table `fragments.csv`.
    #[must_use]
    pub fn csv(&self) -> String {
        let number = crate::field::number;
        let mut text = String::from(if self.planar {
            "fragment,blocks,area_m2,x_m,y_m\n"
        } else {
            "fragment,blocks,volume_m3,x_m,y_m,z_m\n"
        });
        for (k, fragment) in self.list.iter().enumerate() {
            text.push_str(&format!("{},{}", k + 1, fragment.blocks));
            let places = if self.planar { 2 } else { 3 };
            for x in std::iter::once(&fragment.size).chain(&fragment.centre[..places]) {
                text.push(',');
                text.push_str(&number(*x));
            }
            text.push('\n');
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_blocks_are_one_fragment() {
        let at = |x: f64| Some((2.0, [x, 0.0, 1.0]));
        let blocks = [
            at(0.0),
            at(1.0),
            None,
            at(5.0),
            at(2.0),
            Some((7.0, [9.0; 3])),
        ];
        let pairs = [[4, 1], [0, 1]];
        let found = Fragments::new(&blocks, pairs.into_iter(), false);
        let other = Fragments::new(&blocks, pairs.into_iter().rev(), false);
        assert_eq!(found, other);
        let sizes: Vec<(u32, f64)> = found.list.iter().map(|f| (f.blocks, f.size)).collect();
        assert_eq!(sizes, [(1, 7.0), (3, 6.0), (1, 2.0)]);
        assert_eq!(found.list[1].centre, [1.0, 0.0, 1.0]);
        let text = found.csv();
        assert!(
            text.starts_with("fragment,blocks,volume_m3,x_m,y_m,z_m\n1,1,7,9,9,9\n2,3,6,1,0,1\n")
        );
    }

    #[test]
    fn in_the_plane_sizes_are_areas() {
        let found = Fragments::new(&[Some((1.5, [1.0, 2.0, 0.0]))], std::iter::empty(), true);
        assert_eq!(
            found.csv(),
            "fragment,blocks,area_m2,x_m,y_m\n1,1,1.5,1,2\n"
        );
    }
}
