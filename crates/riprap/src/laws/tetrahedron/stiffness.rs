//! Dense stiffness of a small-strain block, shared by congruent ones, and row sums for stable steps.

use super::Elastic;
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
        let mut columns = vec![Lanes::default(); size * packets];
        entries(mesh, law, |row, column, value| {
            columns[column * packets + row / LANES].0[row % LANES] += value;
        });
        Self {
            columns,
            packets,
            size,
        }
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
    let mut matrix = vec![0.0; size * size];
    entries(mesh, law, |row, column, value| {
        matrix[row * size + column] += value;
    });
    let sums: Vec<f64> = matrix
        .chunks_exact(size)
        .map(|row| row.iter().map(|x| x.abs()).sum())
        .collect();
    sums.chunks_exact(3)
        .map(|xyz| xyz[0].max(xyz[1]).max(xyz[2]))
        .collect()
}

/// Visits the contributions of all tetrahedra: row, column, value.
fn entries(mesh: &Tetrahedra, law: &Elastic, mut add: impl FnMut(usize, usize, f64)) {
    for ((tet, volume), [g1, g2, g3]) in mesh.tets.iter().zip(&mesh.volumes).zip(&mesh.gradients) {
        let g = [-(*g1 + *g2 + *g3), *g1, *g2, *g3];
        for (a, ga) in g.iter().enumerate() {
            for (b, gb) in g.iter().enumerate() {
                let dot = law.mu * ga.dot(*gb);
                for i in 0..3 {
                    for j in 0..3 {
                        let diagonal = if i == j { dot } else { 0.0 };
                        let value = law.lambda * ga[i] * gb[j] + law.mu * gb[i] * ga[j] + diagonal;
                        let (row, column) = (3 * tet[a] as usize + i, 3 * tet[b] as usize + j);
                        add(row, column, volume * value);
                    }
                }
            }
        }
    }
}
