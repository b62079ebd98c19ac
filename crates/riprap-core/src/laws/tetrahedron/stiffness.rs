//! Dense stiffness of a small-strain block, shared by congruent ones, and row sums for stable steps.

use super::Elastic;
use crate::Vec3;
use crate::geom::Mat3;
use crate::geom::polyhedron::Tetrahedra;
use crate::lanes::{LANES, Lanes, Width};

/// Packets of rows that are summed at a time: 48 rows, the 45 of a brick.
const TILE: usize = 6;

/// Stiffness matrix of a block, column by column.
#[derive(Clone, Debug)]
pub struct Stiffness {
    /// Entry `[column * packets + packet]`: rows `8 packet` to `8 packet + 7`, N/m.
    columns: Vec<Lanes>,
    packets: usize,
    /// Degrees of freedom: three per node.
    size: usize,
}

impl Stiffness {
    /// Matrix of a shape: `K_ij = V (lambda g_i g_j^T + mu g_j g_i^T + mu (g_i . g_j) 1)`, summed.
    #[must_use]
    pub fn new(mesh: &Tetrahedra, law: &Elastic) -> Self {
        let size = 3 * mesh.nodes.len();
        let packets = size.div_ceil(LANES);
        let mut all = Self { columns: vec![Lanes::default(); size * packets], packets, size };
        entries(mesh, law, |row, column, block| {
            all.add([row, column], block);
        });
        all
    }

    /// Adds a spring from a point of the block, the mean of `nodes` with `weights`, to a fixed place: `k[0]` along the unit
    /// vector `n`, `k[1]` across it, N/m.
    #[inline]
    pub fn add_spring(&mut self, nodes: &[u32], weights: &[f64], n: Vec3, k: [f64; 2]) {
        let diagonal = Mat3::from_diagonal(Vec3::splat(k[1]));
        let n_k = (k[0] - k[1]) * n;
        let tensor = diagonal + Mat3::from_cols(n.x * n_k, n.y * n_k, n.z * n_k);
        let pairs = || nodes.iter().zip(weights).filter(|(_, w)| **w != 0.0);
        for (column, v) in pairs() {
            for (row, w) in pairs() {
                self.add([*row, *column], tensor * (v * w));
            }
        }
    }

    /// Multiplies rows and columns of each node with a factor. *Shape* `[n_nodes]`.
    #[inline]
    pub fn scale(&mut self, factors: &[f64]) {
        let mut rows = vec![Lanes::default(); self.packets];
        for row in 0..self.size {
            rows[row / LANES].0[row % LANES] = factors[row / 3];
        }
        for (column, entries) in self.columns.chunks_exact_mut(self.packets).enumerate() {
            let factor = Lanes::all(factors[column / 3]);
            for (entry, row) in entries.iter_mut().zip(&rows) {
                *entry = *entry * (*row * factor);
            }
        }
    }

    /// Adds to the entries of two nodes: row, column.
    #[inline]
    fn add(&mut self, [row, column]: [u32; 2], block: Mat3) {
        let places: [(usize, usize); 3] = std::array::from_fn(|i| {
            let row = 3 * row as usize + i;
            (row / LANES, row % LANES)
        });
        for j in 0..3 {
            let first = (3 * column as usize + j) * self.packets;
            let entries = &mut self.columns[first..first + self.packets];
            for ((packet, lane), value) in places.into_iter().zip(block.col(j).to_array()) {
                entries[packet].0[lane] += value;
            }
        }
    }

    /// Degrees of freedom: three per node.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Subtracts `K u` (N) from `f`: the forces on the nodes of a block with displacements `u` (m).
    ///
    /// To be called inside [`Width::run`], once for many blocks; [`Stiffness::forces`] does that.
    #[inline(always)]
    pub fn add_forces(&self, u: &[[f64; 3]], f: &mut [[f64; 3]]) {
        let u = &u.as_flattened()[..self.size];
        let f = &mut f.as_flattened_mut()[..self.size];
        let mut first = 0;
        while first + TILE <= self.packets {
            self.tile::<TILE>(first, u, f);
            first += TILE;
        }
        for packet in first..self.packets {
            self.tile::<1>(packet, u, f);
        }
    }

    /// `y = K x`. *Shapes* `[size]`. To be called inside [`Width::run`].
    #[inline(always)]
    pub fn times(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        self.add_forces(x.as_chunks().0, y.as_chunks_mut().0);
        y.iter_mut().for_each(|y| *y = -*y);
    }

    #[inline(always)]
    fn tile<const N: usize>(&self, first: usize, u: &[f64], f: &mut [f64]) {
        let mut sums = [Lanes::default(); N];
        for (column, x) in self.columns.chunks_exact(self.packets).zip(u) {
            let rows = &column[first..first + N];
            let x = Lanes::all(*x);
            for k in 0..N {
                sums[k] = sums[k] + rows[k] * x;
            }
        }
        let rows = f[first * LANES..].chunks_mut(LANES);
        for (rows, sum) in rows.zip(&sums) {
            for (row, x) in rows.iter_mut().zip(sum.0) {
                *row -= x;
            }
        }
    }

    /// As [`Stiffness::add_forces`], at a width.
    #[inline]
    pub fn forces(&self, width: Width, u: &[[f64; 3]], f: &mut [[f64; 3]]) {
        width.run(
            #[inline(always)]
            || self.add_forces(u, f),
        );
    }
}

/// Sum of the magnitudes in the rows of the stiffness matrix, the largest of the three of each node, N/m.
///
/// With masses m the largest frequency is at most `sqrt(max(sum/m))` (Gershgorin); add the row sums of the springs
/// at the node (twice their stiffness). *Shape* `[n_nodes]`.
#[must_use]
pub fn row_sums(mesh: &Tetrahedra, law: &Elastic) -> Vec<f64> {
    let size = 3 * mesh.nodes.len();
    // Whole, since what several tetrahedra add to one entry cancels in part before its magnitude counts.
    let mut matrix = vec![0.0; size * size];
    entries(mesh, law, |row, column, block| {
        for i in 0..3 {
            for j in 0..3 {
                matrix[(3 * row as usize + i) * size + 3 * column as usize + j] += block.col(j)[i];
            }
        }
    });
    let sums: Vec<f64> =
        matrix.chunks_exact(size).map(|row| row.iter().map(|x| x.abs()).sum()).collect();
    sums.chunks_exact(3).map(|xyz| xyz[0].max(xyz[1]).max(xyz[2])).collect()
}

/// Visits the contributions of all tetrahedra: nodes of row and column, their block of the matrix.
fn entries(mesh: &Tetrahedra, law: &Elastic, mut add: impl FnMut(u32, u32, Mat3)) {
    for ((tet, volume), [g1, g2, g3]) in mesh.tets.iter().zip(&mesh.volumes).zip(&mesh.gradients) {
        // The four shape functions add up to one, their gradients to nothing.
        let g = [-(*g1 + *g2 + *g3), *g1, *g2, *g3];
        for (a, ga) in g.iter().enumerate() {
            for (b, gb) in g.iter().enumerate() {
                let dot = law.mu * ga.dot(*gb);
                let column = |j: usize| {
                    let mut value = law.lambda * *ga * gb[j] + law.mu * *gb * ga[j];
                    value[j] += dot;
                    *volume * value
                };
                add(tet[a], tet[b], Mat3::from_cols(column(0), column(1), column(2)));
            }
        }
    }
}
