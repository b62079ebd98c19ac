//! Images of blocks in a periodic model: who meets whom across its ends.
//!
//! Every box is moved by whole periods into the first cell. Images of it are added in those cells of which a part lies within
//! the box of all: for two boxes of the first cell, either can be moved towards the other, so images with a positive first component other
//! than 0 find each pair once. Blocks may have left their cell by any number of periods: a pair is named by where its blocks are.

use crate::exec::Exec;
use crate::kernel::grid::{Box3, Grid, Role};
use crate::kernel::image::{Image, PairKey, Periods};

/// Boxes of blocks and of their images; scratch that keeps its room.
#[derive(Debug, Default)]
pub(super) struct Images {
    /// One for each block in the first cell, then those of images.
    boxes: Vec<Box3>,
    roles: Vec<Role>,
    /// The block of each box, and which image of it stands there.
    of: Vec<(u32, Image)>,
}

impl Images {
    /// The pairs of blocks whose boxes meet in any cell, sorted, but for those that `excluded` rules out.
    pub(super) fn close_pairs(
        &mut self,
        grid: &mut Grid,
        boxes: &[Box3],
        roles: &[Role],
        periods: &Periods,
        excluded: impl Fn(&PairKey) -> bool + Sync,
        exec: &Exec,
    ) -> Vec<PairKey> {
        self.enter(boxes, roles, periods);
        let of = &self.of;
        let key = |pair: [u32; 2]| {
            let [(i, first), (j, second)] = pair.map(|k| of[k as usize]);
            PairKey::sorted([i, j], first.to(second)).0
        };
        // Two images meet as two others do, of which one is in the first cell.
        let out = |a: u32, b: u32| a as usize >= boxes.len() || excluded(&key([a, b]));
        let close = grid.close_pairs(&self.boxes, &self.roles, out, exec);
        let mut keys: Vec<PairKey> = close.iter().map(|pair| key(*pair)).collect();
        keys.sort_unstable();
        keys
    }

    fn enter(&mut self, boxes: &[Box3], roles: &[Role], periods: &Periods) {
        let Self { boxes: all, roles: all_roles, of } = self;
        all.clear();
        of.clear();
        let mut around = Box3::EMPTY;
        for (b, own) in (0u32..).zip(boxes) {
            let home = match own.is_finite() {
                true => Image::cell(own.centre(), periods).to(Image::SELF),
                false => Image::SELF,
            };
            let moved = own.moved(home.shift(periods));
            if moved.is_finite() {
                around = around.with(&moved);
            }
            all.push(moved);
            of.push((b, home));
        }
        all_roles.clear();
        all_roles.extend_from_slice(roles);
        for b in 0..boxes.len() {
            let (own, (block, home)) = (all[b], of[b]);
            if !own.is_finite() {
                continue;
            }
            // Along each axis: the cells from which the block reaches into the box of all.
            let cells: [std::ops::RangeInclusive<i16>; 3] = std::array::from_fn(|k| {
                periods[k].map_or(0..=0, |period| {
                    let first = ((around.low[k] - own.high[k]) / period).ceil() as i16;
                    first..=((around.high[k] - own.low[k]) / period).floor() as i16
                })
            });
            for x in cells[0].clone() {
                for y in cells[1].clone() {
                    for image in cells[2].clone().map(|z| Image([x, y, z])) {
                        if image > Image::SELF {
                            all.push(own.moved(image.shift(periods)));
                            all_roles.push(roles[b]);
                            of.push((block, home.plus(image)));
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use super::*;
    use crate::kernel::kit::Chance;

    #[test]
    fn finds_the_pairs_of_all_images() {
        let mut chance = Chance::new(5);
        for periods in [[Some(4.0), None, None], [Some(4.0), Some(3.0), None], [Some(2.0); 3]] {
            let count = 60;
            // Some are as wide as a cell, some have left it by many of them.
            let boxes: Vec<Box3> = (0..count)
                .map(|k| {
                    let far = if k % 3 == 0 { 12.0 } else { 4.0 };
                    let wide = periods.map(|p| if p.is_some() { far } else { 1.0 });
                    let mut one = |by: [f64; 3]| Vec3::from_array(by.map(|x| x * chance.unit()));
                    let size = if k % 7 == 0 { 2.0 } else { 0.6 };
                    let low = one(wide.map(|x| 2.0 * x)) - Vec3::from_array(wide);
                    Box3 { low, high: low + one([size; 3]) }
                })
                .collect();
            let roles: Vec<Role> = (0..count)
                .map(|k| [Role::Active, Role::Passive, Role::Active, Role::Absent][k % 4])
                .collect();
            let odd = |key: &PairKey| (key.ends[0] + key.ends[1]).is_multiple_of(5);
            let reach = periods.map(|period| if period.is_some() { 14 } else { 0 });
            let mut wanted = Vec::new();
            for i in 0..count {
                for j in i..count {
                    let of = [roles[i], roles[j]];
                    if of.contains(&Role::Absent) || !of.contains(&Role::Active) {
                        continue;
                    }
                    for x in -reach[0]..=reach[0] {
                        for y in -reach[1]..=reach[1] {
                            for z in -reach[2]..=reach[2] {
                                let image = Image([x, y, z]);
                                let key = PairKey { ends: [i as u32, j as u32], image };
                                let own = i == j && image <= Image::SELF;
                                let there = boxes[j].moved(image.shift(&periods));
                                if !own && boxes[i].meets(&there) && !odd(&key) {
                                    wanted.push(key);
                                }
                            }
                        }
                    }
                }
            }
            wanted.sort_unstable();
            let across = wanted.iter().filter(|key| key.image != Image::SELF).count();
            assert!(across > 5, "{across} of {}", wanted.len());
            let mut images = Images::default();
            for threads in [1, 2] {
                let (mut grid, exec) = (Grid::default(), Exec::new(threads).unwrap());
                let found = images.close_pairs(&mut grid, &boxes, &roles, &periods, odd, &exec);
                assert_eq!(found, wanted);
            }
        }
    }
}
