//! Which boxes of a list meet: grids of doubling cell size in three directions.
//!
//! Every box stands in one cell only, that of its centre, in the grid whose cells are just as large as the box. Who
//! looks for partners looks into the grid of its own size and into all coarser ones, never into finer ones: a floor
//! under a thousand pebbles is found by the pebbles. So the cost grows with the number of boxes and of pairs, however
//! mixed the sizes are.
//!
//! All grids are one sorted list of keys (role, grid, z, y, x); a row of cells along x is a run of it. Nothing depends
//! on the number of threads: pairs are found per run of boxes and then sorted.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::exec::{CHUNK, Exec};

/// Bits of a cell number along one axis; numbers beyond are put into the outermost cells.
const CELL_BITS: u32 = 40;
/// Largest cell number.
const LAST_CELL: i64 = (1 << (CELL_BITS - 1)) - 1;
/// Coarsest grid: its cells are 2^100 times those of the finest.
const LAST_LEVEL: u32 = 100;
/// Bit of the role in a key.
const ROLE_BIT: u32 = 127;

/// What a block is to the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Role {
    /// It is not there: removed, or another part of the engine looks after it.
    Absent,
    /// It can be met by a seeker; two targets never make a pair. For blocks that cannot come together: fixed ones, and
    /// those of a lattice whose joints are whole.
    Passive,
    /// It can meet everybody.
    Active,
}

/// A box with faces normal to the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Box3 {
    /// Smallest coordinates, m.
    pub low: Vec3,
    /// Largest coordinates, m.
    pub high: Vec3,
}

impl Box3 {
    /// The box that holds nothing.
    pub const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    /// Whether the two have a point in common.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The same box elsewhere; `way` in m.
    #[must_use]
    pub fn moved(&self, way: Vec3) -> Self {
        Self { low: self.low + way, high: self.high + way }
    }

    /// Its centre, m.
    #[must_use]
    pub fn centre(&self) -> Vec3 {
        0.5 * self.low + 0.5 * self.high
    }

    fn extent(&self) -> f64 {
        (self.high - self.low).max_element()
    }

    /// Whether all its coordinates are numbers.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }
}

/// Grids over a list of boxes, and the pairs found; reused, so that memory is kept.
#[derive(Clone, Debug, Default)]
pub struct Grid {
    /// Key of the cell and number of each box that is there, sorted.
    entries: Vec<(u128, u32)>,
    /// Runs of `entries`: per role (targets, seekers) and grid that is not empty: grid, start, end.
    runs: [Vec<(u32, usize, usize)>; 2],
    /// Edge of the cells of the finest grid, m.
    finest: f64,
    /// Where the pairs of each box (the smaller number) start among all.
    start: Vec<usize>,
    pairs: Vec<[u32; 2]>,
}

impl Grid {
    /// Pairs `[i, j]`, `i < j`, of boxes that meet, at least one of them a seeker's, and that `excluded(i, j)` does not
    /// rule out; sorted. Boxes that are not finite meet nobody.
    ///
    /// *Cost*: boxes times the number of sizes (powers of two) that occur, plus pairs.
    pub fn close_pairs(
        &mut self,
        boxes: &[Box3],
        roles: &[Role],
        excluded: impl Fn(u32, u32) -> bool + Sync,
        exec: &Exec,
    ) -> &[[u32; 2]] {
        let chunks = boxes.len().div_ceil(CHUNK);
        self.enter(boxes, roles);
        // By runs of boxes; there are several times as many as pairs that can touch, so that none are kept.
        let mut found = vec![Vec::new(); chunks];
        exec.ranges(boxes.len(), &mut found, |range, found| {
            for b in range {
                self.look(b as u32, boxes, roles, &excluded, found);
            }
        });
        self.sort(boxes.len(), &found);
        &self.pairs
    }

    /// Puts every box into the cell of its centre.
    fn enter(&mut self, boxes: &[Box3], roles: &[Role]) {
        self.entries.clear();
        self.runs.iter_mut().for_each(Vec::clear);
        let present = |b: &usize| roles[*b] != Role::Absent && boxes[*b].is_finite();
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0f64);
        for b in (0..boxes.len()).filter(present) {
            let extent = boxes[b].extent();
            smallest = smallest.min(extent);
            largest = largest.max(extent);
        }
        // All boxes may be points, or all of them removed.
        self.finest = smallest
            .min(largest)
            .max(libm::ldexp(largest, -(LAST_LEVEL as i32)))
            .max(f64::MIN_POSITIVE);
        for b in (0..boxes.len()).filter(present) {
            let level = self.level(&boxes[b]);
            let cell = self.cell(level);
            let [x, y, z] = (boxes[b].centre() / cell).to_array().map(number);
            self.entries.push((key(roles[b], level, [x, y, z]), b as u32));
        }
        self.entries.sort_unstable();
        let mut start = 0;
        for run in self.entries.chunk_by(|a, b| a.0 >> (3 * CELL_BITS) == b.0 >> (3 * CELL_BITS)) {
            let head = run[0].0;
            let level = (head >> (3 * CELL_BITS)) as u32 & 0x7f;
            let end = start + run.len();
            self.runs[(head >> ROLE_BIT) as usize].push((level, start, end));
            start = end;
        }
    }

    /// The finest grid whose cells are at least as large as the box.
    fn level(&self, of: &Box3) -> u32 {
        let extent = of.extent();
        let (mut level, mut cell) = (0, self.finest);
        while cell < extent && level < LAST_LEVEL {
            level += 1;
            cell *= 2.0;
        }
        level
    }

    fn cell(&self, level: u32) -> f64 {
        libm::ldexp(self.finest, level as i32)
    }

    /// Partners of box `b` in the grids that it looks into.
    fn look(
        &self,
        b: u32,
        boxes: &[Box3],
        roles: &[Role],
        excluded: &impl Fn(u32, u32) -> bool,
        found: &mut Vec<[u32; 2]>,
    ) {
        let own = &boxes[b as usize];
        self.near(b, boxes, roles, |other, smaller| {
            let pair = [b.min(other), b.max(other)];
            if !smaller && own.meets(&boxes[other as usize]) && !excluded(pair[0], pair[1]) {
                found.push(pair);
            }
        });
    }

    /// Calls `met` for each box in the cells that box `b` looks into, and whether it is for that one to look.
    fn near(&self, b: u32, boxes: &[Box3], roles: &[Role], mut met: impl FnMut(u32, bool)) {
        let own = &boxes[b as usize];
        if roles[b as usize] == Role::Absent || !own.is_finite() {
            return;
        }
        let seeks = roles[b as usize] == Role::Active;
        let level = self.level(own);
        for (role, runs) in [Role::Passive, Role::Active].into_iter().zip(&self.runs) {
            // Of two seekers of one size the smaller number looks; a target leaves its own size to the seekers.
            let both = role == Role::Active && seeks;
            if !seeks && role == Role::Passive {
                continue;
            }
            for &(grid, start, end) in runs {
                if grid < level || (grid == level && !seeks) {
                    continue;
                }
                self.row_by_row((role, grid), &self.entries[start..end], own, |other| {
                    met(other, grid == level && both && other <= b);
                });
            }
        }
    }

    /// How many boxes all of them together look at, those that they leave to the others included: the cost of the last search.
    #[cfg(test)]
    pub fn looks(&self, boxes: &[Box3], roles: &[Role]) -> usize {
        let mut count = 0;
        for b in 0..boxes.len() {
            self.near(b as u32, boxes, roles, |_, _| count += 1);
        }
        count
    }

    /// Calls `met` for each box in those cells of a grid whose boxes can reach `own`.
    fn row_by_row(
        &self,
        (role, grid): (Role, u32),
        entries: &[(u128, u32)],
        own: &Box3,
        mut met: impl FnMut(u32),
    ) {
        let cell = self.cell(grid);
        // A box of this grid reaches at most half a cell from its centre.
        let half = Vec3::splat(0.5 * cell);
        let [x0, y0, z0] = ((own.low - half) / cell).to_array().map(number);
        let [x1, y1, z1] = ((own.high + half) / cell).to_array().map(number);
        for z in z0..=z1 {
            for y in y0..=y1 {
                let (first, last) = (key(role, grid, [x0, y, z]), key(role, grid, [x1, y, z]));
                let from = entries.partition_point(|entry| entry.0 < first);
                entries[from..]
                    .iter()
                    .take_while(|entry| entry.0 <= last)
                    .for_each(|entry| met(entry.1));
            }
        }
    }

    /// Sorts the pairs found: by the smaller number through counting, then each short run.
    fn sort(&mut self, count: usize, found: &[Vec<[u32; 2]>]) {
        self.start.clear();
        self.start.resize(count + 1, 0);
        for pair in found.iter().flatten() {
            self.start[pair[0] as usize + 1] += 1;
        }
        for b in 0..count {
            self.start[b + 1] += self.start[b];
        }
        let mut all = vec![0; self.start[count]];
        // Each start moves on to the next one's place while it is filled.
        for &[i, j] in found.iter().flatten() {
            let at = &mut self.start[i as usize];
            all[*at] = j;
            *at += 1;
        }
        self.pairs.clear();
        let mut start = 0;
        for (i, &end) in self.start[..count].iter().enumerate() {
            let partners = &mut all[start..end];
            partners.sort_unstable();
            self.pairs.extend(partners.iter().map(|&j| [i as u32, j]));
            start = end;
        }
    }
}

/// Number of the cell that a coordinate (in cells) lies in.
fn number(coordinate: f64) -> i64 {
    (coordinate.floor() as i64).clamp(-LAST_CELL, LAST_CELL)
}

fn key(role: Role, level: u32, cell: [i64; 3]) -> u128 {
    let [x, y, z] = cell.map(|c| (c + LAST_CELL) as u128);
    let role = match role {
        Role::Absent | Role::Passive => 0,
        Role::Active => 1,
    };
    let head = role << 7 | u128::from(level);
    ((head << CELL_BITS | z) << CELL_BITS | y) << CELL_BITS | x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::kit::Chance;

    /// Boxes of sizes 1 to `ratio`, as many of each power of two, in a cube that they fill loosely.
    fn boxes(chance: &mut Chance, n: usize, ratio: f64) -> Vec<Box3> {
        let sizes: Vec<f64> = (0..n).map(|_| libm::pow(ratio, chance.unit())).collect();
        let edge = libm::cbrt(n as f64) * libm::sqrt(ratio);
        let mut boxes: Vec<Box3> = Vec::with_capacity(n);
        for &size in &sizes {
            let mut at = |scale: f64| {
                let mut one = || scale * (chance.unit() - 0.5);
                Vec3::new(one(), one(), one())
            };
            // Most sit near an earlier one, so that small ones meet large ones too.
            let low = match boxes.len() {
                k if k % 8 == 0 => at(edge),
                k => boxes[k / 2].low + at(size),
            };
            let shape = at(1.0).abs() + Vec3::splat(0.5);
            boxes.push(Box3 { low, high: low + size * shape });
        }
        boxes
    }

    fn all_pairs(boxes: &[Box3], roles: &[Role]) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        for i in 0..boxes.len() {
            for j in i + 1..boxes.len() {
                let there = roles[i] != Role::Absent && roles[j] != Role::Absent;
                let seeks = roles[i] == Role::Active || roles[j] == Role::Active;
                if there && seeks && boxes[i].meets(&boxes[j]) {
                    pairs.push([i as u32, j as u32]);
                }
            }
        }
        pairs
    }

    fn roles(chance: &mut Chance, n: usize) -> Vec<Role> {
        let role = |r: f64| match r {
            r if r < 0.1 => Role::Absent,
            r if r < 0.5 => Role::Passive,
            _ => Role::Active,
        };
        (0..n).map(|_| role(chance.unit())).collect()
    }

    #[test]
    fn finds_what_the_double_loop_finds() {
        let mut chance = Chance::new(1);
        let mut grid = Grid::default();
        for (n, ratio) in [(0, 1.0), (1, 1.0), (300, 1.0), (1500, 30.0), (1500, 1000.0)] {
            let boxes = boxes(&mut chance, n, ratio);
            for roles in [vec![Role::Active; n], roles(&mut chance, n)] {
                let wanted = all_pairs(&boxes, &roles);
                assert!(n < 300 || wanted.len() > n / 10, "{n}: {}", wanted.len());
                for threads in [1, 3] {
                    let exec = Exec::new(threads).unwrap();
                    let pairs = grid.close_pairs(&boxes, &roles, |_, _| false, &exec);
                    assert_eq!(pairs, wanted, "{n} boxes, sizes 1:{ratio}");
                }
                let odd = |i: u32, j: u32| (i + j) % 2 == 1;
                let pairs = grid.close_pairs(&boxes, &roles, odd, &Exec::serial());
                assert!(
                    pairs.iter().copied().eq(wanted.iter().copied().filter(|p| !odd(p[0], p[1])))
                );
            }
        }
    }

    #[test]
    fn odd_boxes_do_no_harm() {
        let cube = |at: Vec3, size: f64| Box3 { low: at, high: at + Vec3::splat(size) };
        let boxes = [
            cube(Vec3::ZERO, 1.0),
            cube(Vec3::NAN, 1.0),
            cube(Vec3::splat(0.5), 0.0),
            cube(Vec3::splat(1e30), 1.0),
            cube(Vec3::splat(-1e30), 2.0),
            cube(Vec3::splat(-1e30), 1e-300),
            cube(Vec3::splat(f64::INFINITY), 1.0),
            cube(Vec3::splat(-1e40), 2e40),
            Box3::EMPTY,
        ];
        let wanted = [[0, 2], [0, 7], [2, 7], [3, 7], [4, 5], [4, 7], [5, 7]];
        let mut grid = Grid::default();
        let seekers = [Role::Active; 9];
        let pairs = grid.close_pairs(&boxes, &seekers, |_, _| false, &Exec::serial());
        assert_eq!(pairs, wanted);
        // Boxes without extent fall into one cell.
        let points = [cube(Vec3::ONE, 0.0); 3];
        let pairs = grid.close_pairs(&points, &seekers[..3], |_, _| false, &Exec::serial());
        assert_eq!(pairs, [[0, 1], [0, 2], [1, 2]]);
    }
}
