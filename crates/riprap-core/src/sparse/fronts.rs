//! What the graph of a matrix determines: the sequence of elimination, the fronts and where all numbers are stored.

use std::ops::Range;

use super::SIZE;
use crate::lanes::LANES;

/// A front is joined to the next one, its parent, while no more than this share of its blocks is zero: longer loops
/// outweigh some sums of zeros.
const ZEROS: [(usize, f64); 3] = [(4, 0.6), (12, 0.2), (usize::MAX, 0.05)];

/// Columns that are eliminated together.
#[derive(Clone, Debug, Default)]
pub(super) struct Front {
    /// Its columns in the order of elimination.
    pub columns: Range<usize>,
    /// Its rows below its columns, in [`Fronts::rows`].
    pub rows: Range<usize>,
    /// Its children, in [`Fronts::children`].
    pub children: Range<usize>,
    /// Its place in the factor.
    pub factor: Range<usize>,
    /// Its place among what is left over for the fronts of this parity of depth.
    pub left: Range<usize>,
    pub parity: usize,
}

impl Front {
    /// Strips of eight rows that hold so many blocks.
    pub(super) fn strips(blocks: usize) -> usize {
        (SIZE * blocks).div_ceil(LANES)
    }
}

/// Where the block of a pair is added.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot {
    pub entry: u32,
    pub transposed: bool,
}

/// See the head of the module.
#[derive(Clone, Debug, Default)]
pub(super) struct Fronts {
    pairs: Vec<[u32; 2]>,
    pub slots: Vec<Slot>,
    /// Body of each column.
    pub order: Vec<u32>,
    /// Column of each body.
    pub place: Vec<u32>,
    /// Children before parents.
    pub list: Vec<Front>,
    pub rows: Vec<u32>,
    /// The place of each of `rows` in the parent: its columns, then its rows.
    pub in_parent: Vec<u32>,
    pub children: Vec<u32>,
    /// Pairs of each column ([n + 1] ends) and the place of their rows in the front of the column.
    pub pairs_of: Vec<u32>,
    pub in_front: Vec<u32>,
    pub factor_len: usize,
    pub left_len: [usize; 2],
}

impl Fronts {
    /// Analyses a graph.
    pub(super) fn new(bodies: usize, pairs: &[[u32; 2]]) -> Self {
        let (order, place, lower, parents) = sequence(bodies, pairs);
        let (starts, below) = structure(&lower, &parents);
        let size = |column: usize| (starts[column + 1] - starts[column]) as usize;
        let groups = join(&parents, size);
        let mut fronts = Self { pairs: pairs.to_vec(), order, place, ..Self::default() };
        let mut front_of = vec![0; bodies];
        for (k, columns) in groups.into_iter().enumerate() {
            front_of[columns.clone()].fill(k);
            let first = fronts.rows.len();
            let last = columns.end - 1;
            fronts.rows.extend(&below[starts[last] as usize..starts[last + 1] as usize]);
            fronts.list.push(Front { columns, rows: first..fronts.rows.len(), ..Front::default() });
        }
        fronts.place_rows(&front_of);
        fronts.place_numbers();
        fronts.place_pairs(&lower, &front_of);
        fronts
    }

    /// Whether this is the analysis of this graph.
    pub(super) fn fit(&self, bodies: usize, pairs: &[[u32; 2]]) -> bool {
        self.order.len() == bodies && self.pairs == pairs
    }

    /// Blocks on the diagonal and of different pairs.
    pub(super) fn entries_len(&self) -> usize {
        self.order.len() + self.in_front.len()
    }

    /// Blocks of the factor.
    pub(super) fn filled(&self) -> usize {
        let blocks = |f: &Front| f.columns.len() * (f.columns.len() + 1 + 2 * f.rows.len()) / 2;
        self.list.iter().map(blocks).sum()
    }

    pub(super) fn bytes(&self) -> usize {
        let numbers = self.order.len() * 3 + self.rows.len() * 2 + self.in_front.len();
        8 * (self.pairs.len() + self.slots.len())
            + 4 * numbers
            + (size_of::<Front>() + 4) * self.list.len()
    }

    /// Finds the parents of fronts, their children, and the places of rows in parents.
    fn place_rows(&mut self, front_of: &[usize]) {
        let parent = |f: &Front| self.rows.get(f.rows.clone()).and_then(|rows| rows.first());
        let parents: Vec<_> =
            self.list.iter().map(|f| parent(f).map(|&row| front_of[row as usize])).collect();
        let mut children = vec![Vec::new(); self.list.len()];
        self.in_parent = vec![0; self.rows.len()];
        for (k, p) in parents.iter().enumerate() {
            let Some(p) = *p else { continue };
            children[p].push(k as u32);
            for at in self.list[k].rows.clone() {
                self.in_parent[at] = self.place_in(p, self.rows[at]);
            }
        }
        for (k, of) in children.into_iter().enumerate() {
            let first = self.children.len();
            self.children.extend(of);
            self.list[k].children = first..self.children.len();
        }
        // Parents come after children: from the roots down.
        for k in (0..self.list.len()).rev() {
            self.list[k].parity = parents[k].map_or(0, |p| 1 - self.list[p].parity);
        }
    }

    /// The place of a row in a front: its columns, then its rows.
    fn place_in(&self, front: usize, row: u32) -> u32 {
        let f = &self.list[front];
        let column = row as usize - f.columns.start;
        if column < f.columns.len() {
            return column as u32;
        }
        let at = self.rows[f.rows.clone()].partition_point(|&r| r < row);
        (f.columns.len() + at) as u32
    }

    /// Places the numbers of fronts: what is left over forms two stacks, because the children of a front have the other parity
    /// and are the last ones of theirs.
    fn place_numbers(&mut self) {
        let mut tops = [0; 2];
        for k in 0..self.list.len() {
            let (columns, rows) = (self.list[k].columns.len(), self.list[k].rows.len());
            let lanes = (Front::strips(columns) + Front::strips(rows)) * SIZE * columns;
            let first = self.list[k].children.clone().next().map(|c| self.children[c] as usize);
            if let Some(child) = first {
                tops[self.list[child].parity] = self.list[child].left.start;
            }
            let f = &mut self.list[k];
            f.factor = self.factor_len..self.factor_len + lanes;
            self.factor_len += lanes;
            f.left = tops[f.parity]..tops[f.parity] + Front::strips(rows) * SIZE * rows;
            tops[f.parity] = f.left.end;
            self.left_len[f.parity] = self.left_len[f.parity].max(f.left.end);
        }
    }

    /// Gives each pair its entry.
    fn place_pairs(&mut self, lower: &Rows, front_of: &[usize]) {
        let bodies = self.order.len();
        self.pairs_of.clone_from(&lower.0);
        for column in 0..bodies {
            for &row in lower.of(column) {
                let at = self.place_in(front_of[column], row);
                self.in_front.push(at);
            }
        }
        for [a, b] in &self.pairs {
            let [a, b] = [a, b].map(|body| self.place[*body as usize]);
            let (column, row) = (a.min(b), a.max(b));
            let at = lower.of(column as usize).partition_point(|&r| r < row);
            let entry = bodies as u32 + lower.0[column as usize] + at as u32;
            // Entries are by columns, so a block whose rows are those of the column comes as it is.
            self.slots.push(Slot { entry, transposed: a > b });
        }
    }
}

/// Lists of rows, one after the other: their ends and their members.
struct Rows(Vec<u32>, Vec<u32>);

impl Rows {
    /// From members with the number of their list, which are sorted and made unique.
    fn new(lists: usize, mut members: Vec<[u32; 2]>) -> Self {
        members.sort_unstable();
        members.dedup();
        let mut ends = vec![0; lists + 1];
        for [list, _] in &members {
            ends[*list as usize + 1] += 1;
        }
        for k in 0..lists {
            ends[k + 1] += ends[k];
        }
        Self(ends, members.into_iter().map(|[_, row]| row).collect())
    }

    fn of(&self, list: usize) -> &[u32] {
        &self.1[self.0[list] as usize..self.0[list + 1] as usize]
    }
}

/// No parent.
const NONE: u32 = u32::MAX;

/// The sequence of elimination and its inverse, the rows of pairs below the diagonal by columns, and the parents in the elimination tree, in
/// which the members of each subtree follow one another.
fn sequence(bodies: usize, pairs: &[[u32; 2]]) -> (Vec<u32>, Vec<u32>, Rows, Vec<u32>) {
    assert!(
        pairs.iter().all(|[a, b]| a != b && (*a.max(b) as usize) < bodies),
        "a pair of bodies that are not two of {bodies}"
    );
    // With the diagonal: `amd` subtracts its length from that of the list.
    let diagonal = (0..bodies as u32).map(|k| [k, k]);
    let both = pairs.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).chain(diagonal);
    let both = Rows::new(bodies, both.collect());
    let [ends, rows] = [&both.0, &both.1].map(|list| list.iter().map(|&k| k as isize).collect());
    let (ends, rows): (Vec<isize>, Vec<isize>) = (ends, rows);
    let (order, ..) = amd::order(bodies as isize, &ends, &rows, &amd::Control::default())
        .expect("sorted lists of different rows are valid");
    let order: Vec<u32> = order.into_iter().map(|body| body as u32).collect();
    let place = inverse(&order);
    let parents = tree(&order, &place, &both);
    let steps = postorder(&parents);
    let step_of = inverse(&steps);
    let order: Vec<u32> = steps.iter().map(|&k| order[k as usize]).collect();
    let parent_of = |k: &u32| match parents[*k as usize] {
        NONE => NONE,
        p => step_of[p as usize],
    };
    let parents = steps.iter().map(parent_of).collect();
    let place = inverse(&order);
    let lower = pairs.iter().map(|pair| {
        let [a, b] = pair.map(|body| place[body as usize]);
        [a.min(b), a.max(b)]
    });
    let lower = Rows::new(bodies, lower.collect());
    (order, place, lower, parents)
}

fn inverse(order: &[u32]) -> Vec<u32> {
    let mut place = vec![0; order.len()];
    for (k, &of) in order.iter().enumerate() {
        place[of as usize] = k as u32;
    }
    place
}

/// Parents in the elimination tree: the first row below the diagonal in each column of the factor. Source: Liu (1986), with
/// shortcuts to the highest ancestor known.
fn tree(order: &[u32], place: &[u32], both: &Rows) -> Vec<u32> {
    let mut parents = vec![NONE; order.len()];
    let mut shortcut = parents.clone();
    for (k, &body) in order.iter().enumerate() {
        let k = k as u32;
        for &other in both.of(body as usize) {
            let mut at = place[other as usize];
            while at < k {
                let next = std::mem::replace(&mut shortcut[at as usize], k);
                if next == NONE {
                    parents[at as usize] = k;
                    break;
                }
                at = next;
            }
        }
    }
    parents
}

/// The tree, children before parents and each subtree in one piece.
fn postorder(parents: &[u32]) -> Vec<u32> {
    let mut first_child = vec![NONE; parents.len()];
    let mut next = first_child.clone();
    let mut open = Vec::new();
    for (k, &parent) in parents.iter().enumerate().rev() {
        let list = match parent {
            NONE => {
                open.push(k as u32);
                continue;
            }
            p => &mut first_child[p as usize],
        };
        next[k] = std::mem::replace(list, k as u32);
    }
    let mut order = Vec::with_capacity(parents.len());
    while let Some(&top) = open.last() {
        let child = std::mem::replace(&mut first_child[top as usize], NONE);
        if child == NONE {
            order.push(top);
            open.pop();
            continue;
        }
        // Siblings wait in the place of the first child.
        first_child[top as usize] = next[child as usize];
        open.push(child);
    }
    order
}

/// Rows below the diagonal in each column of the factor: those of its pairs and of its children in the tree.
fn structure(lower: &Rows, parents: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let columns = parents.len();
    let mut starts = vec![0];
    let mut rows: Vec<u32> = Vec::new();
    let mut last_child = vec![NONE; columns];
    let mut previous = last_child.clone();
    let mut seen = last_child.clone();
    for k in 0..columns {
        let first = rows.len();
        seen[k] = k as u32;
        let mut take = |rows: &mut Vec<u32>, row: u32| {
            if seen[row as usize] != k as u32 {
                seen[row as usize] = k as u32;
                rows.push(row);
            }
        };
        for &row in lower.of(k) {
            take(&mut rows, row);
        }
        let mut child = last_child[k];
        while child != NONE {
            for at in starts[child as usize]..starts[child as usize + 1] {
                let row = rows[at as usize];
                take(&mut rows, row);
            }
            child = previous[child as usize];
        }
        rows[first..].sort_unstable();
        starts.push(rows.len() as u32);
        if let Some(list) = last_child.get_mut(parents[k] as usize) {
            previous[k] = std::mem::replace(list, k as u32);
        }
    }
    (starts, rows)
}

/// Joins columns to fronts: a front and its parent that follows at once, where that adds few zeros ([`ZEROS`]).
fn join(parents: &[u32], rows: impl Fn(usize) -> usize) -> Vec<Range<usize>> {
    let mut groups: Vec<Range<usize>> = Vec::new();
    // Blocks of the last group that are not zero.
    let mut full = 0;
    for k in 0..parents.len() {
        let own = 1 + rows(k);
        if let Some(group) = groups.last_mut().filter(|g| parents[g.end - 1] as usize == k) {
            let width = group.len() + 1;
            let all = width * (width + 1) / 2 + width * rows(k);
            let limit =
                ZEROS.iter().find(|(most, _)| width <= *most).map_or(0.0, |(_, zeros)| *zeros);
            if all - full - own <= (limit * all as f64) as usize {
                group.end = k + 1;
                full += own;
                continue;
            }
        }
        groups.push(k..k + 1);
        full = own;
    }
    groups
}
