//! Elastic tetrahedra with linear displacements: forces, stress, energy; small or large strain.
//!
//! The tetrahedra of one block are worked on eight at a time ([`Groups`]). Node displacements are relative to the
//! undeformed block, whose last node is its centroid, and stay in one slice per block: `[n_nodes]` of (x, y, z).
//! Groups know shape only, so that congruent blocks (also shifted ones) share them. All widths of the instruction
//! set give the same bits. `stiffness` has the dense matrix of a small-strain block instead.
//!
//! Small strain: `eps = sym(H)`, `f_k = -V sigma g_k`, exact for small rotations only (a block that turns freely
//! swells). Large strain: total-Lagrangian St. Venant-Kirchhoff, `F = 1 + H`, `E = (F^T F - 1)/2`,
//! `f_k = -V F S(E) g_k`; both agree for small H. Tension is positive.
//!
//! Source: Han, Liu & Li (2010), section 2 (small strain).
//! Deviation: the large-strain element is not in the source.

use std::sync::Arc;

use crate::geom::polyhedron::Tetrahedra;
use crate::lanes::{LANES, Lanes, Width};

mod point;
mod stiffness;
#[cfg(test)]
mod tests;

pub use point::{
    Elastic, Gradient, Strain, Symmetric, energy_density, second_piola, stress, tensor,
};
pub use stiffness::{Stiffness, row_sums};

use point::{density, first_piola, hooke, measure};

/// Eight tetrahedra of a block.
#[derive(Clone, Debug)]
struct Group {
    /// Face centre, a and b of each: nodes of the block. Lanes without a tetrahedron have no volume.
    nodes: [[u16; LANES]; 3],
    /// Gradients of the shape functions of these nodes, 1/m.
    gradients: [[Lanes; 3]; 3],
    /// Volumes, m³.
    volume: Lanes,
}

/// The tetrahedra of a block shape, eight at a time.
#[derive(Clone, Debug)]
pub struct Groups {
    /// Those of this shape are `store[first..first + count]`; see [`Groups::pack`].
    store: Arc<Vec<Group>>,
    first: usize,
    count: usize,
    nodes: usize,
    tets: usize,
    volume: f64,
}

/// Start stresses of the tetrahedra of a block, as [`Groups`] takes them; empty: none.
#[derive(Clone, Debug, Default)]
pub struct StartStress(Vec<[Lanes; 6]>);

impl StartStress {
    /// No stress.
    #[inline]
    #[must_use]
    pub const fn none() -> Self {
        Self(Vec::new())
    }

    /// From one stress per tetrahedron, Pa. *Shape* `[n_tets]`, or empty.
    #[must_use]
    pub fn new(stresses: &[Symmetric]) -> Self {
        let pack = |eight: &[Symmetric]| {
            let mut lanes = [Lanes::default(); 6];
            for (lane, s) in eight.iter().enumerate() {
                for k in 0..6 {
                    lanes[k].0[lane] = s[k];
                }
            }
            lanes
        };
        Self(stresses.chunks(LANES).map(pack).collect())
    }

    #[inline(always)]
    fn of(&self, group: usize) -> [Lanes; 6] {
        if self.0.is_empty() { [Lanes::default(); 6] } else { self.0[group] }
    }

    /// That of one tetrahedron, Pa.
    #[inline]
    #[must_use]
    pub fn one(&self, tet: usize) -> Symmetric {
        self.of(tet / LANES).map(|c| c.0[tet % LANES])
    }
}

impl Groups {
    /// Packs the tetrahedra of a shape. A block has at most 65,536 nodes.
    ///
    /// # Panics
    /// More nodes than that (a solid of `geom` has at most 30,000).
    #[must_use]
    pub fn new(mesh: &Tetrahedra) -> Self {
        assert!(mesh.nodes.len() <= 1 << 16, "{} nodes", mesh.nodes.len());
        let mut groups = Vec::with_capacity(mesh.tets.len().div_ceil(LANES));
        for first in (0..mesh.tets.len()).step_by(LANES) {
            let mut group = Group {
                nodes: [[0; LANES]; 3],
                gradients: [[Lanes::default(); 3]; 3],
                volume: Lanes::default(),
            };
            for lane in 0..LANES.min(mesh.tets.len() - first) {
                let tet = first + lane;
                for k in 0..3 {
                    group.nodes[k][lane] = mesh.tets[tet][k + 1] as u16;
                    for (axis, g) in mesh.gradients[tet][k].to_array().into_iter().enumerate() {
                        group.gradients[k][axis].0[lane] = g;
                    }
                }
                group.volume.0[lane] = mesh.volumes[tet];
            }
            groups.push(group);
        }
        Self {
            first: 0,
            count: groups.len(),
            store: Arc::new(groups),
            nodes: mesh.nodes.len(),
            tets: mesh.tets.len(),
            volume: mesh.volume(),
        }
    }

    /// Puts the tetrahedra of many shapes next to each other in memory, in the order of the shapes: a pass over all of
    /// them then reads one long run.
    pub fn pack<'a>(shapes: impl Iterator<Item = &'a mut Self>) {
        let shapes: Vec<&mut Self> = shapes.collect();
        let mut store = Vec::with_capacity(shapes.iter().map(|s| s.count).sum());
        let mut firsts = Vec::with_capacity(shapes.len());
        for shape in &shapes {
            firsts.push(store.len());
            store.extend_from_slice(shape.list());
        }
        let store = Arc::new(store);
        for (shape, first) in shapes.into_iter().zip(firsts) {
            shape.store = Arc::clone(&store);
            shape.first = first;
        }
    }

    #[inline(always)]
    fn list(&self) -> &[Group] {
        &self.store[self.first..self.first + self.count]
    }

    /// Number of tetrahedra.
    #[inline]
    #[must_use]
    pub fn tets(&self) -> usize {
        self.tets
    }

    /// Number of nodes of the block.
    #[inline]
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// Adds the forces (N) of the tetrahedra on the nodes of a block with displacements `u` (m).
    ///
    /// To be called inside [`Width::run`], once for many blocks; [`forces`] does that. The forces add up to zero to
    /// round-off, and with large strain so do their moments about the displaced nodes.
    #[inline(always)]
    pub fn add_forces(
        &self,
        law: &Elastic,
        strain: Strain,
        start: &StartStress,
        u: &[[f64; 3]],
        f: &mut [[f64; 3]],
    ) {
        match strain {
            Strain::Small => self.add::<false>(law, start, u, f),
            Strain::Large => self.add::<true>(law, start, u, f),
        }
    }

    #[inline(always)]
    fn add<const LARGE: bool>(
        &self,
        law: &Elastic,
        start: &StartStress,
        u: &[[f64; 3]],
        f: &mut [[f64; 3]],
    ) {
        let (u, f) = (&u[..self.nodes], &mut f[..self.nodes]);
        let centre = self.nodes - 1;
        // Every tetrahedron has the centre: its force stays in lanes and
        // is added up once, in one order at every width.
        let mut on_centre = [Lanes::default(); 3];
        for (k, group) in self.list().iter().enumerate() {
            let h = group.gradient(u);
            let s = hooke(law, &measure::<Lanes, LARGE>(&h), &start.of(k));
            let p = first_piola::<Lanes, LARGE>(&h, &s);
            group.spread(&p, f, &mut on_centre);
        }
        for axis in 0..3 {
            f[centre][axis] += on_centre[axis].sum();
        }
    }

    /// Displacement gradient of a tetrahedron.
    #[inline]
    #[must_use]
    pub fn gradient(&self, tet: usize, u: &[[f64; 3]]) -> Gradient {
        let (group, lane) = (&self.list()[tet / LANES], tet % LANES);
        let centre = u[self.nodes - 1];
        let mut h = [[0.0; 3]; 3];
        for (i, row) in h.iter_mut().enumerate() {
            // Less the centre's: its shape function has minus the sum of the
            // three gradients, which is in the differences.
            let d = |k: usize| u[usize::from(group.nodes[k][lane])][i] - centre[i];
            for (j, x) in row.iter_mut().enumerate() {
                let g = |k: usize| group.gradients[k][j].0[lane];
                *x = d(0) * g(0) + d(1) * g(1) + d(2) * g(2);
            }
        }
        h
    }

    /// Volume of a tetrahedron, m³.
    #[inline]
    #[must_use]
    pub fn volume_of(&self, tet: usize) -> f64 {
        self.list()[tet / LANES].volume.0[tet % LANES]
    }

    /// Cauchy stress of each tetrahedron, Pa; zero for one that is turned inside out. *Shape* `[n_tets]`.
    #[inline]
    #[must_use]
    pub fn stresses(
        &self,
        law: &Elastic,
        strain: Strain,
        start: &StartStress,
        u: &[[f64; 3]],
    ) -> Vec<Symmetric> {
        let one = |tet| stress(law, strain, &start.one(tet), &self.gradient(tet, u));
        (0..self.tets).map(|tet| one(tet).unwrap_or_default()).collect()
    }

    /// Mean Cauchy stress (Pa) and mean displacement gradient of the block, weighted with undeformed volumes.
    #[inline]
    #[must_use]
    pub fn average(
        &self,
        law: &Elastic,
        strain: Strain,
        start: &StartStress,
        u: &[[f64; 3]],
    ) -> (Symmetric, Gradient) {
        let (mut mean, mut slope) = ([0.0; 6], [[0.0; 3]; 3]);
        for tet in 0..self.tets {
            let h = self.gradient(tet, u);
            let share = self.volume_of(tet) / self.volume;
            let s = stress(law, strain, &start.one(tet), &h).unwrap_or_default();
            for (sum, x) in mean.iter_mut().zip(s) {
                *sum += share * x;
            }
            for (sum, x) in slope.as_flattened_mut().iter_mut().zip(h.as_flattened()) {
                *sum += share * x;
            }
        }
        (mean, slope)
    }

    /// Strain energy of the block, J.
    #[inline(always)]
    #[must_use]
    pub fn energy(
        &self,
        law: &Elastic,
        strain: Strain,
        start: &StartStress,
        u: &[[f64; 3]],
    ) -> f64 {
        let u = &u[..self.nodes];
        let mut sum = Lanes::default();
        for (k, group) in self.list().iter().enumerate() {
            let h = group.gradient(u);
            let e = match strain {
                Strain::Small => measure::<Lanes, false>(&h),
                Strain::Large => measure::<Lanes, true>(&h),
            };
            sum = sum + group.volume * density(law, &e, &start.of(k));
        }
        sum.sum()
    }
}

impl Group {
    /// Displacement gradients.
    #[inline(always)]
    fn gradient(&self, u: &[[f64; 3]]) -> [[Lanes; 3]; 3] {
        let centre = u[u.len() - 1];
        let mut d = [[Lanes::default(); 3]; 3];
        for k in 0..3 {
            for lane in 0..LANES {
                let at = u[usize::from(self.nodes[k][lane])];
                for axis in 0..3 {
                    d[k][axis].0[lane] = at[axis] - centre[axis];
                }
            }
        }
        let g = &self.gradients;
        let mut h = [[Lanes::default(); 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                h[i][j] = d[0][i] * g[0][j] + d[1][i] * g[1][j] + d[2][i] * g[2][j];
            }
        }
        h
    }

    /// Adds `-V P g_k` to the nodes k, and what balances it to the centre.
    #[inline(always)]
    fn spread(&self, p: &[[Lanes; 3]; 3], f: &mut [[f64; 3]], centre: &mut [Lanes; 3]) {
        let mut scaled = *p;
        for row in &mut scaled {
            for x in row {
                *x = self.volume * *x;
            }
        }
        let g = &self.gradients;
        for k in 0..3 {
            let mut on = [Lanes::default(); 3];
            for i in 0..3 {
                on[i] = scaled[i][0] * g[k][0] + scaled[i][1] * g[k][1] + scaled[i][2] * g[k][2];
                centre[i] = centre[i] + on[i];
            }
            for lane in 0..LANES {
                let to = &mut f[usize::from(self.nodes[k][lane])];
                for i in 0..3 {
                    to[i] -= on[i].0[lane];
                }
            }
        }
    }
}

/// Adds the forces (N) of the tetrahedra of one block with displacements `u` (m) to `f`, at a width.
#[inline]
pub fn forces(
    width: Width,
    groups: &Groups,
    law: &Elastic,
    strain: Strain,
    start: &StartStress,
    u: &[[f64; 3]],
    f: &mut [[f64; 3]],
) {
    width.run(
        #[inline(always)]
        || groups.add_forces(law, strain, start, u, f),
    );
}

/// Forces (N) on the four nodes of one tetrahedron of volume `volume` (m³), with the gradients (1/m) of the shape
/// functions of nodes 1, 2, 3, at displacements `u` (m).
#[inline]
#[must_use]
pub fn one(
    law: &Elastic,
    strain: Strain,
    volume: f64,
    gradients: &[[f64; 3]; 3],
    u: &[[f64; 3]; 4],
) -> [[f64; 3]; 4] {
    let mut h = [[0.0; 3]; 3];
    for (i, row) in h.iter_mut().enumerate() {
        for (j, x) in row.iter_mut().enumerate() {
            let term = |k: usize| (u[k + 1][i] - u[0][i]) * gradients[k][j];
            *x = term(0) + term(1) + term(2);
        }
    }
    let none = [0.0; 6];
    let p = match strain {
        Strain::Small => {
            let s = hooke(law, &measure::<f64, false>(&h), &none);
            first_piola::<f64, false>(&h, &s)
        }
        Strain::Large => {
            let s = hooke(law, &measure::<f64, true>(&h), &none);
            first_piola::<f64, true>(&h, &s)
        }
    };
    let mut f = [[0.0; 3]; 4];
    for (k, g) in gradients.iter().enumerate() {
        for i in 0..3 {
            let on = volume * p[i][0] * g[0] + volume * p[i][1] * g[1] + volume * p[i][2] * g[2];
            f[k + 1][i] = -on;
            f[0][i] += on;
        }
    }
    f
}
