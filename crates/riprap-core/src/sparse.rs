//! Sparse symmetric positive definite systems of 6x6 blocks, solved by Cholesky's method.
//!
//! A body has six unknowns, and two bodies are coupled where they share a contact. So the matrix `A` has a block
//! on the diagonal for each body and one for each pair, and is factored as `P A P' = L L'` in three stages:
//!
//! 1. order: the sequence `P` of elimination, chosen so that little is filled in (approximate minimum degree);
//! 2. fronts: which blocks of `L` are not zero, from the elimination tree; columns with the same rows below
//!    them are joined to a front (`fronts`);
//! 3. numbers: the multifrontal method. A front collects its entries of `A` and what its children left over, `F = [D, .; B, U]`;
//!    then `D = L1 L1'`, `L2 = B L1^-T` (`Shape::factor`), and `U - L2 L2'` is left over for the parent
//!    (`Shape::remainder`). All arithmetic is in dense kernels of eight rows by six columns.
//!
//! `A x = b` then is `L y = P b`, `L' P x = y` ([`Matrix::solve`]).
//!
//! Stages 1 and 2 depend on the graph alone and are kept until it changes ([`Matrix::fit`]); the numbers change several
//! times a step. Each number is a sum in an order that the graph sets, without fused multiply-add, so results
//! are the same bits on any machine.
//!
//! Sources: George & Liu (1981), Computer solution of large sparse positive definite systems; Duff & Reid (1983), ACM
//! Trans. Math. Softw. 9, 302-325 (fronts); Amestoy, Davis & Duff (1996), SIAM J. Matrix Anal. Appl. 17, 886-905 (order);
//! Davis (2006), Direct methods for sparse linear systems (elimination tree).

#![expect(clippy::needless_range_loop, reason = "indices are rows and columns of several matrices")]

mod dense;
mod fronts;
#[cfg(test)]
mod tests;

use crate::lanes::{Lanes, Width};
use fronts::Fronts;

/// Unknowns of a body.
pub const SIZE: usize = 6;

/// What couples the unknowns of two bodies: `block[r][c]` is in the row of unknown `r` of the first.
pub type Block = [[f64; SIZE]; SIZE];

/// The matrix is not positive definite (or not finite): elimination found no positive pivot here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the matrix is not positive definite at unknown {unknown} of body {body}")]
pub struct NotPositive {
    /// Number of the body.
    pub body: usize,
    /// Which of its unknowns, from 0.
    pub unknown: usize,
}

/// A matrix, the analysis of its graph, and its factor.
#[derive(Clone, Debug, Default)]
pub struct Matrix {
    fronts: Fronts,
    /// Entries by columns: blocks on the diagonal in the order of elimination, then pairs as in [`Fronts`].
    entries: Vec<Block>,
    /// The columns of the fronts in `L`, in strips of eight rows; reciprocals on the diagonal.
    factor: Vec<Lanes>,
    /// Left over by fronts for their parents, which are at even and at odd depth.
    left: [Vec<Lanes>; 2],
    rooms: dense::Rooms,
    width: Width,
}

impl Matrix {
    /// Takes the matrix to so many bodies, coupled by these pairs; entries are zero then. The analysis is kept if bodies
    /// and pairs are as before, and else depends on them alone. Pairs may repeat.
    ///
    /// # Panics
    /// When a pair names a body that does not exist, or one body twice.
    pub fn fit(&mut self, bodies: usize, pairs: &[[u32; 2]]) {
        if !self.fronts.fit(bodies, pairs) {
            self.fronts = Fronts::new(bodies, pairs);
            self.factor.resize(self.fronts.factor_len, Lanes::default());
            for (list, len) in self.left.iter_mut().zip(self.fronts.left_len) {
                list.resize(len, Lanes::default());
            }
            // With registers of eight the compiler shuffles: four to nine times slower.
            self.width = Width::detect().at_most(4);
        }
        self.clear();
    }

    /// Sets all entries to zero.
    pub fn clear(&mut self) {
        self.entries.clear();
        self.entries.resize(self.fronts.entries_len(), Block::default());
    }

    /// Adds a symmetric block on the diagonal.
    pub fn add_diagonal(&mut self, body: usize, block: &Block) {
        add(&mut self.entries[self.fronts.place[body] as usize], block);
    }

    /// Adds the block of pair number `k` of [`Matrix::fit`], in the rows of its first body and the columns of its second, and its
    /// transpose opposite.
    pub fn add_pair(&mut self, k: usize, block: &Block) {
        let slot = self.fronts.slots[k];
        let entry = &mut self.entries[slot.entry as usize];
        if slot.transposed {
            add(entry, &std::array::from_fn(|r| std::array::from_fn(|c| block[c][r])));
        } else {
            add(entry, block);
        }
    }

    /// Factors the matrix.
    ///
    /// # Errors
    /// When it is not positive definite.
    pub fn factor(&mut self) -> Result<(), NotPositive> {
        let Self { fronts, entries, factor, left, rooms, width } = self;
        let done = width.run(
            #[inline(always)]
            || dense::factor_all(fronts, entries, factor, left, rooms),
        );
        done.map_err(|row| NotPositive {
            body: self.fronts.order[row / SIZE] as usize,
            unknown: row % SIZE,
        })
    }

    /// Solves for a right-hand side with the last factor. Shape: `[bodies]`.
    pub fn solve(&mut self, x: &mut [[f64; SIZE]]) {
        let Self { fronts, factor, rooms, width, .. } = self;
        width.run(
            #[inline(always)]
            || dense::solve_all(fronts, factor, rooms, x),
        );
    }

    /// Blocks that the factor stores, those on the diagonal included.
    #[must_use]
    pub fn filled(&self) -> usize {
        self.fronts.filled()
    }

    /// Bytes of the matrix, its analysis and its factor.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let lanes = self.factor.capacity() + self.left.iter().map(Vec::capacity).sum::<usize>();
        size_of::<Lanes>() * lanes
            + size_of::<Block>() * self.entries.capacity()
            + self.fronts.bytes()
    }
}

#[inline]
fn add(to: &mut Block, block: &Block) {
    for (to, from) in to.iter_mut().zip(block) {
        for (to, from) in to.iter_mut().zip(from) {
            *to += from;
        }
    }
}
