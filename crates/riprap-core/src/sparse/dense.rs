//! The numbers of fronts: dense kernels on strips of eight rows.
//!
//! A front of `w` columns of blocks has `6 w` columns. A strip holds eight rows, column after column. The rows of the columns themselves fill
//! the first strips, and the rows below begin a new strip, so that what is left over has the same strips. Two neighbouring rows never
//! belong to different strips; a block is moved as three such couples.

use std::ops::Range;

use super::fronts::{Front, Fronts};
use super::{Block, SIZE};
use crate::lanes::{LANES, Lanes};

/// Couples of rows in a block and in a strip.
const COUPLES: usize = SIZE / 2;
const IN_STRIP: usize = LANES / 2;

/// Six rows of a front, by columns.
type Six = [f64; SIZE];

/// Scratch.
#[derive(Clone, Debug, Default)]
pub(super) struct Rooms {
    six: Vec<Six>,
    lanes: Vec<Lanes>,
    sums: Vec<Lanes>,
    x: Vec<Six>,
}

/// Factors all fronts; the error is the row without a positive pivot.
#[inline(always)]
pub(super) fn factor_all(
    fronts: &Fronts,
    entries: &[Block],
    factor: &mut [Lanes],
    left: &mut [Vec<Lanes>; 2],
    rooms: &mut Rooms,
) -> Result<(), usize> {
    for f in &fronts.list {
        let panel = &mut factor[f.factor.clone()];
        let [even, odd] = &mut *left;
        let (own, others) = if f.parity == 0 { (even, &*odd) } else { (odd, &*even) };
        let children =
            fronts.children[f.children.clone()].iter().map(|&c| &fronts.list[c as usize]);
        let shape = Shape::new(f);
        panel.fill(Lanes::default());
        collect(fronts, f, entries, panel);
        for child in children.clone() {
            let places = &fronts.in_parent[child.rows.clone()];
            shape.add_child(places, &others[child.left.clone()], panel);
        }
        shape.factor(panel, &mut rooms.six).map_err(|row| SIZE * f.columns.start + row)?;
        let own = &mut own[f.left.clone()];
        shape.remainder(panel, own, &mut rooms.six);
        for child in children {
            let places = &fronts.in_parent[child.rows.clone()];
            shape.pass_child(places, &others[child.left.clone()], own);
        }
    }
    Ok(())
}

/// Adds the entries of a front to its columns.
#[inline(always)]
fn collect(fronts: &Fronts, f: &Front, entries: &[Block], panel: &mut [Lanes]) {
    let shape = Shape::new(f);
    let (diagonal, pairs) = entries.split_at(fronts.order.len());
    for (k, column) in f.columns.clone().enumerate() {
        shape.add_entry(k, k, &diagonal[column], panel);
        let of = fronts.pairs_of[column] as usize..fronts.pairs_of[column + 1] as usize;
        for (&place, block) in fronts.in_front[of.clone()].iter().zip(&pairs[of]) {
            shape.add_entry(place as usize, k, block, panel);
        }
    }
}

/// Blocks of a front.
#[derive(Clone, Copy)]
struct Shape {
    columns: usize,
    rows: usize,
    /// Strips of the columns themselves.
    head: usize,
    /// Numbers in a row.
    width: usize,
}

impl Shape {
    #[inline(always)]
    fn new(f: &Front) -> Self {
        let columns = f.columns.len();
        let (head, width) = (Front::strips(columns), SIZE * columns);
        Self { columns, rows: f.rows.len(), head, width }
    }

    /// The first couple of rows of a place.
    #[inline(always)]
    fn couple(self, place: usize) -> usize {
        if place < self.columns {
            COUPLES * place
        } else {
            IN_STRIP * self.head + COUPLES * (place - self.columns)
        }
    }

    #[inline(always)]
    fn add_entry(self, place: usize, column: usize, block: &Block, panel: &mut [Lanes]) {
        let first = self.couple(place);
        for p in 0..COUPLES {
            let (strip, at) = split(first + p);
            let to = &mut panel[strip * self.width + SIZE * column..][..SIZE];
            for (to, from) in to.iter_mut().zip(block) {
                to.0[at] += from[2 * p];
                to.0[at + 1] += from[2 * p + 1];
            }
        }
    }

    /// Adds what a child left over in the columns of this front.
    #[inline(always)]
    fn add_child(self, places: &[u32], left: &[Lanes], panel: &mut [Lanes]) {
        let width = SIZE * places.len();
        for (j, &column) in places.iter().enumerate() {
            let column = column as usize;
            if column >= self.columns {
                break;
            }
            for (i, &row) in places.iter().enumerate().skip(j) {
                let from = (left, width, COUPLES * i, SIZE * j);
                add_block((panel, self.width, self.couple(row as usize), SIZE * column), from);
            }
        }
    }

    /// Adds what a child left over below the columns of this front to what the front leaves over.
    #[inline(always)]
    fn pass_child(self, places: &[u32], left: &[Lanes], own: &mut [Lanes]) {
        let width = SIZE * places.len();
        let first = places.partition_point(|&p| (p as usize) < self.columns);
        for j in first..places.len() {
            let column = SIZE * (places[j] as usize - self.columns);
            for i in j..places.len() {
                let row = COUPLES * (places[i] as usize - self.columns);
                let from = (left, width, COUPLES * i, SIZE * j);
                add_block((own, SIZE * self.rows, row, column), from);
            }
        }
    }

    /// `D = L1 L1'`, `L2 = B L1^-T`, block after block of columns; the error is the row without a positive pivot.
    #[inline(always)]
    fn factor(self, panel: &mut [Lanes], six: &mut Vec<Six>) -> Result<(), usize> {
        for j in 0..self.columns {
            let known = SIZE * j;
            let first = COUPLES * j / IN_STRIP;
            pack(panel, self.width, known, COUPLES * j, six);
            let strips = &mut panel[first * self.width..];
            if j > 0 {
                subtract(strips, self.width, known, six);
            }
            let mut d = Block::default();
            each(j, |c, at, r, strip| d[c][r] = strips[strip * self.width + known + c].0[at]);
            cholesky(&mut d).map_err(|row| known + row)?;
            divide(strips, self.width, known, &d);
            for column in &mut strips[known..known + SIZE] {
                column.0[..known % LANES].fill(0.0);
            }
            each(j, |c, at, r, strip| strips[strip * self.width + known + c].0[at] = d[c][r]);
        }
        Ok(())
    }

    /// `-L2 L2'`, on and below the diagonal.
    #[inline(always)]
    fn remainder(self, panel: &[Lanes], own: &mut [Lanes], six: &mut Vec<Six>) {
        let below = &panel[self.head * self.width..];
        let width = SIZE * self.rows;
        for j in 0..self.rows {
            pack(below, self.width, self.width, COUPLES * j, six);
            let first = COUPLES * j / IN_STRIP;
            let (below, own) = (&below[first * self.width..], &mut own[first * width..]);
            opposite(below, self.width, six, own, width, SIZE * j);
        }
    }
}

/// The strip of a couple, and its place there.
#[inline(always)]
fn split(couple: usize) -> (usize, usize) {
    (couple / IN_STRIP, 2 * (couple % IN_STRIP))
}

/// Calls `f(column, place in strip, row, strip)` for a block on the diagonal; strips count from its first.
#[inline(always)]
fn each(j: usize, mut f: impl FnMut(usize, usize, usize, usize)) {
    let first = COUPLES * j % IN_STRIP;
    for r in 0..SIZE {
        let (strip, at) = split(first + r / 2);
        for c in 0..SIZE {
            f(c, at + r % 2, r, strip);
        }
    }
}

/// Adds a block: numbers, their width, and the first couple of rows and first column of the block, of both sides.
#[inline(always)]
fn add_block(to: (&mut [Lanes], usize, usize, usize), from: (&[Lanes], usize, usize, usize)) {
    for p in 0..COUPLES {
        let (strip, to_at) = split(to.2 + p);
        let to = &mut to.0[strip * to.1 + to.3..][..SIZE];
        let (strip, from_at) = split(from.2 + p);
        let from = &from.0[strip * from.1 + from.3..][..SIZE];
        for (to, from) in to.iter_mut().zip(from) {
            to.0[to_at] += from.0[from_at];
            to.0[to_at + 1] += from.0[from_at + 1];
        }
    }
}

/// Six rows of the first columns, one column after the other.
#[inline(always)]
fn pack(panel: &[Lanes], width: usize, columns: usize, couple: usize, six: &mut Vec<Six>) {
    six.clear();
    six.resize(columns, Six::default());
    for p in 0..COUPLES {
        let (strip, at) = split(couple + p);
        for (six, from) in six.iter_mut().zip(&panel[strip * width..]) {
            six[2 * p] = from.0[at];
            six[2 * p + 1] = from.0[at + 1];
        }
    }
}

/// Eight rows times the transpose of six.
#[inline(always)]
fn product(eight: &[Lanes], six: &[Six]) -> [Lanes; SIZE] {
    let mut sum = [Lanes::default(); SIZE];
    for (a, b) in eight.iter().zip(six) {
        for c in 0..SIZE {
            sum[c] = sum[c] + *a * Lanes::all(b[c]);
        }
    }
    sum
}

/// Cholesky's factor of a block by columns, with reciprocals on the diagonal and zeros above; the error is the row without a positive pivot.
#[inline(always)]
fn cholesky(d: &mut Block) -> Result<(), usize> {
    for c in 0..SIZE {
        for k in 0..c {
            for r in c..SIZE {
                d[c][r] -= d[k][r] * d[k][c];
            }
            d[c][k] = 0.0;
        }
        let pivot = d[c][c];
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            return Err(c);
        }
        let reciprocal = 1.0 / pivot.sqrt();
        for r in c + 1..SIZE {
            d[c][r] *= reciprocal;
        }
        d[c][c] = reciprocal;
    }
    Ok(())
}

/// Subtracts from six columns the products of those before them.
#[inline(always)]
fn subtract(strips: &mut [Lanes], width: usize, known: usize, six: &[Six]) {
    for strip in strips.chunks_exact_mut(width) {
        let (done, now) = strip.split_at_mut(known);
        let sum = product(done, six);
        for (now, sum) in now.iter_mut().zip(sum) {
            *now = *now - sum;
        }
    }
}

/// Six columns times the inverse transpose of a factor.
#[inline(always)]
fn divide(strips: &mut [Lanes], width: usize, known: usize, d: &Block) {
    for strip in strips.chunks_exact_mut(width) {
        let six = &mut strip[known..known + SIZE];
        for c in 0..SIZE {
            let mut x = six[c];
            for k in 0..c {
                x = x - six[k] * Lanes::all(d[k][c]);
            }
            six[c] = x * Lanes::all(d[c][c]);
        }
    }
}

/// Writes to six columns the opposite of the products of strips.
#[inline(always)]
fn opposite(
    from: &[Lanes],
    width: usize,
    six: &[Six],
    to: &mut [Lanes],
    to_width: usize,
    at: usize,
) {
    for (from, to) in from.chunks_exact(width).zip(to.chunks_exact_mut(to_width)) {
        let sum = product(from, six);
        for (to, sum) in to[at..at + SIZE].iter_mut().zip(sum) {
            *to = -sum;
        }
    }
}

/// Solves `L L' x = b`.
#[inline(always)]
pub(super) fn solve_all(fronts: &Fronts, factor: &[Lanes], rooms: &mut Rooms, b: &mut [Six]) {
    let Rooms { x, lanes, sums, .. } = rooms;
    x.clear();
    x.extend(fronts.order.iter().map(|&body| b[body as usize]));
    for f in &fronts.list {
        let rows = &fronts.rows[f.rows.clone()];
        Shape::new(f).forward(f.columns.clone(), rows, &factor[f.factor.clone()], lanes, x);
    }
    for f in fronts.list.iter().rev() {
        let rows = &fronts.rows[f.rows.clone()];
        let panel = &factor[f.factor.clone()];
        Shape::new(f).backward(f.columns.clone(), rows, panel, [lanes, sums], x);
    }
    for (x, &body) in x.iter().zip(&fronts.order) {
        b[body as usize] = *x;
    }
}

impl Shape {
    /// `y1 = L1^-1 b1`, `b2 -= L2 y1`.
    #[inline(always)]
    fn forward(
        self,
        columns: Range<usize>,
        rows: &[u32],
        panel: &[Lanes],
        lanes: &mut Vec<Lanes>,
        x: &mut [Six],
    ) {
        let (head, below) = panel.split_at(self.head * self.width);
        load(columns.clone(), x, lanes);
        for c in 0..self.width {
            let (own, at) = (c / LANES, c % LANES);
            let y = lanes[own].0[at] * head[own * self.width + c].0[at];
            for k in own..self.head {
                lanes[k] = lanes[k] - head[k * self.width + c] * Lanes::all(y);
            }
            lanes[own].0[at] = y;
        }
        store(columns.clone(), x, lanes);
        let y = &x[columns];
        lanes.clear();
        times(below, self.width, y, lanes);
        for (i, &row) in rows.iter().enumerate() {
            for k in 0..SIZE {
                let at = SIZE * i + k;
                x[row as usize][k] -= lanes[at / LANES].0[at % LANES];
            }
        }
    }

    /// `x1 = L1^-T (y1 - L2' x2)`.
    #[inline(always)]
    fn backward(
        self,
        columns: Range<usize>,
        rows: &[u32],
        panel: &[Lanes],
        [lanes, sums]: [&mut Vec<Lanes>; 2],
        x: &mut [Six],
    ) {
        let (head, below) = panel.split_at(self.head * self.width);
        load(rows.iter().map(|&row| row as usize), x, lanes);
        sums.clear();
        sums.resize(self.width, Lanes::default());
        times_transposed(below, self.width, lanes, sums);
        load(columns.clone(), x, lanes);
        for c in (0..self.width).rev() {
            let (own, at) = (c / LANES, c % LANES);
            // The diagonal itself holds a reciprocal, and what is above it is zero.
            let y = std::mem::take(&mut lanes[own].0[at]);
            let mut sum = sums[c];
            for k in own..self.head {
                sum = sum + head[k * self.width + c] * lanes[k];
            }
            lanes[own].0[at] = (y - sum.sum()) * head[own * self.width + c].0[at];
        }
        store(columns, x, lanes);
    }
}

/// Strips times unknowns.
#[inline(always)]
fn times(strips: &[Lanes], width: usize, y: &[Six], to: &mut Vec<Lanes>) {
    for strip in strips.chunks_exact(width) {
        let mut sum = [Lanes::default(); 2];
        for (a, y) in strip.chunks_exact(SIZE).zip(y) {
            for k in 0..SIZE {
                sum[k % 2] = sum[k % 2] + a[k] * Lanes::all(y[k]);
            }
        }
        to.push(sum[0] + sum[1]);
    }
}

/// The transpose of strips times unknowns; a sum in each lane.
#[inline(always)]
fn times_transposed(strips: &[Lanes], width: usize, x: &[Lanes], sums: &mut [Lanes]) {
    for (strip, x) in strips.chunks_exact(width).zip(x) {
        for (sum, a) in sums.iter_mut().zip(strip) {
            *sum = *sum + *a * *x;
        }
    }
}

/// Takes the unknowns of some columns into strips.
#[inline(always)]
fn load(columns: impl Iterator<Item = usize>, x: &[Six], lanes: &mut Vec<Lanes>) {
    lanes.clear();
    for (i, column) in columns.enumerate() {
        lanes.resize(Front::strips(i + 1), Lanes::default());
        for k in 0..SIZE {
            let at = SIZE * i + k;
            lanes[at / LANES].0[at % LANES] = x[column][k];
        }
    }
}

/// Writes strips to the unknowns of columns.
#[inline(always)]
fn store(columns: Range<usize>, x: &mut [Six], lanes: &[Lanes]) {
    for (i, x) in x[columns].iter_mut().enumerate() {
        for (k, x) in x.iter_mut().enumerate() {
            let at = SIZE * i + k;
            *x = lanes[at / LANES].0[at % LANES];
        }
    }
}
