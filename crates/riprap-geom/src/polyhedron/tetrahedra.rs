//! Nodes and tetrahedra inside a convex solid.
//!
//! Every triangle (face centre, a, b) of a face and the centroid of the solid make one tetrahedron: the shape of a
//! deformable block. Nodes stand in the order `[vertices | face centres | centroid]`, tetrahedra face by face, edge
//! by edge of each face.
//!
//! Source: Han, Liu & Li (2010), section 2; the shares of areas and of inertia are derived here.

use super::{Polyhedron, edges_of};
use crate::Vec3;

/// Nodes, tetrahedra and shares of areas of a convex solid.
#[derive(Clone, Debug, PartialEq)]
pub struct Tetrahedra {
    /// Vertices, then the centroid of the area of each face, then the centroid of the volume, m.
    pub nodes: Vec<Vec3>,
    /// Nodes (centroid, face centre, a, b) of each, with (a, b) an edge of the face. *Shape* `[n_tets]`.
    pub tets: Vec<[u32; 4]>,
    /// First tetrahedron of each face, and the number of all. *Shape* `[n_faces + 1]`.
    pub first: Vec<u32>,
    /// Volume of each, m³. *Shape* `[n_tets]`.
    pub volumes: Vec<f64>,
    /// Gradients of the shape functions of nodes 1, 2, 3 of each, 1/m; that of node 0 is minus their sum.
    pub gradients: Vec<[Vec3; 3]>,
}

/// A tetrahedron without volume: the solid is too thin there, or not convex.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "the tetrahedron on face {face} over the edge from vertex {from} to vertex {to} has the volume {volume:e} m3; \
     it must be above 0"
)]
pub struct FlatTetrahedron {
    /// Face number.
    pub face: usize,
    /// First vertex of the edge.
    pub from: u32,
    /// Second vertex of the edge.
    pub to: u32,
    /// Volume found, m³.
    pub volume: f64,
}

impl Tetrahedra {
    /// Divides a convex solid whose faces point outward.
    ///
    /// # Errors
    /// A tetrahedron whose volume is not positive.
    pub fn new(solid: &Polyhedron) -> Result<Self, FlatTetrahedron> {
        let corners = solid.vertices.len();
        let centroid = solid.moments().centroid;
        let faces = solid.faces.len();
        let tets = solid.faces.iter().map(Vec::len).sum();
        let mut nodes = Vec::with_capacity(corners + faces + 1);
        nodes.extend_from_slice(&solid.vertices);
        nodes.extend((0..faces).map(|f| solid.face_centre(f)));
        nodes.push(centroid);
        let centre = nodes.len() as u32 - 1;
        let mut mesh = Self {
            nodes,
            tets: Vec::with_capacity(tets),
            first: Vec::with_capacity(faces + 1),
            volumes: Vec::with_capacity(tets),
            gradients: Vec::with_capacity(tets),
        };
        mesh.first.push(0);
        for (face, outline) in solid.faces.iter().enumerate() {
            let middle = (corners + face) as u32;
            for (from, to) in edges_of(outline) {
                let at = |k: u32| mesh.nodes[k as usize];
                let (volume, gradients) = element(centroid, [at(middle), at(from), at(to)]);
                // Not `<= 0`: NaN is refused too.
                if !(volume > 0.0 && gradients.iter().all(|g| g.is_finite())) {
                    return Err(FlatTetrahedron { face, from, to, volume });
                }
                mesh.tets.push([centre, middle, from, to]);
                mesh.volumes.push(volume);
                mesh.gradients.push(gradients);
            }
            mesh.first.push(mesh.tets.len() as u32);
        }
        Ok(mesh)
    }

    /// Node of the centroid: the last.
    #[must_use]
    pub fn centre(&self) -> u32 {
        self.nodes.len() as u32 - 1
    }

    /// Least distance of the centroid from a face, m.
    #[must_use]
    pub fn height(&self) -> f64 {
        let heights = self.gradients.iter().map(|[a, b, c]| 1.0 / (*a + *b + *c).length());
        heights.fold(f64::INFINITY, f64::min)
    }

    /// Volume of the solid, m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.volumes.iter().sum()
    }

    /// Triangles (face centre, a, b) of a face, as nodes, anticlockwise seen from outside.
    pub fn fan(&self, face: usize) -> impl Iterator<Item = [u32; 3]> + '_ {
        let (start, end) = (self.first[face] as usize, self.first[face + 1] as usize);
        self.tets[start..end].iter().map(|&[_, m, a, b]| [m, a, b])
    }

    /// Nodes of a face (its centre, then its corners in order) and the area that each stands for, m².
    ///
    /// A third of every triangle goes to each of its nodes: the only shares with which a uniform traction gives the
    /// exact nodal forces. The centre has a third of the face.
    #[must_use]
    pub fn tributary(&self, face: usize) -> Vec<(u32, f64)> {
        let at = |k: u32| self.nodes[k as usize];
        let thirds: Vec<([u32; 3], f64)> = self
            .fan(face)
            .map(|t| {
                let [m, a, b] = t.map(at);
                (t, (a - m).cross(b - m).length() / 6.0)
            })
            .collect();
        let count = thirds.len();
        let mut shares = Vec::with_capacity(count + 1);
        if let Some(([middle, _, _], _)) = thirds.first() {
            shares.push((*middle, thirds.iter().map(|(_, third)| third).sum()));
        }
        for k in 0..count {
            let ([_, corner, _], right) = thirds[k];
            shares.push((corner, thirds[(k + count - 1) % count].1 + right));
        }
        shares
    }

    /// Volume that each node stands for, m³: a quarter of every tetrahedron at each of its nodes.
    ///
    /// Times the density it is a mass with the exact total and centroid; the moment of inertia is too large (1.75
    /// times that of a cube). *Shape* `[n_nodes]`.
    #[must_use]
    pub fn lumped(&self) -> Vec<f64> {
        let mut shares = vec![0.0; self.nodes.len()];
        for (tet, volume) in self.tets.iter().zip(&self.volumes) {
            for &node in tet {
                shares[node as usize] += 0.25 * volume;
            }
        }
        shares
    }

    /// As [`Tetrahedra::lumped`], with the inertia tensor of the solid.
    ///
    /// First what vertices and face centres stand for is reduced by one factor (4/7 for a cube, never above 1) and the
    /// centroid gets the rest: that gives the trace. Then shares are changed by the least amounts, relative to
    /// themselves, that give the whole tensor; if one of them would fall below a third, only so far. *Shape* `[n_nodes]`.
    #[must_use]
    pub fn inertial(&self) -> Vec<f64> {
        let mut shares = self.lumped();
        let centre = self.nodes[self.nodes.len() - 1];
        let exact = self.second_moments(centre);
        let arms: Vec<Vec3> = self.nodes.iter().map(|x| *x - centre).collect();
        let polar = |shares: &[f64]| -> f64 {
            let each = shares.iter().zip(&arms);
            each.map(|(share, r)| share * r.length_squared()).sum()
        };
        let factor = (exact[0] + exact[1] + exact[2]) / polar(&shares);
        let last = shares.len() - 1;
        for share in &mut shares[..last] {
            *share *= factor;
        }
        let rest: f64 = shares[..last].iter().sum();
        shares[last] = self.volume() - rest;
        correct(&mut shares, &arms, &exact);
        shares
    }

    /// Integrals of xx, yy, zz, yz, zx, xy over the volume, about a point, m⁵.
    fn second_moments(&self, about: Vec3) -> [f64; 6] {
        let mut sums = [0.0; 6];
        for (tet, volume) in self.tets.iter().zip(&self.volumes) {
            let arms = tet.map(|k| self.nodes[k as usize] - about);
            let all = arms[0] + arms[1] + arms[2] + arms[3];
            // int x x^T = V/20 (sum of x x^T over the corners + sum sum^T).
            for r in arms.into_iter().chain([all]) {
                for (sum, product) in sums.iter_mut().zip(products(r)) {
                    *sum += volume / 20.0 * product;
                }
            }
        }
        sums
    }
}

/// xx, yy, zz, yz, zx, xy.
fn products(r: Vec3) -> [f64; 6] {
    [r.x * r.x, r.y * r.y, r.z * r.z, r.y * r.z, r.z * r.x, r.x * r.y]
}

/// Changes shares by factors `1 + a . (1, x, y, z, xx, ...)` so that sum and first moments stay and the second moments
/// are `exact`, or go that way until a share is a third of what it was.
fn correct(shares: &mut [f64], arms: &[Vec3], exact: &[f64; 6]) {
    const LEAST: f64 = 1.0 / 3.0;
    let size = arms.iter().map(|r| r.length()).fold(0.0, f64::max);
    let basis = |r: Vec3| {
        let (r, mut phi) = (r / size, [1.0; 10]);
        phi[1..4].copy_from_slice(&r.to_array());
        phi[4..].copy_from_slice(&products(r));
        phi
    };
    let mut matrix = [[0.0; 11]; 10];
    for (row, target) in matrix[4..].iter_mut().zip(exact) {
        row[10] = target / (size * size);
    }
    for (share, r) in shares.iter().zip(arms) {
        let phi = basis(*r);
        for (k, row) in matrix.iter_mut().enumerate() {
            for (sum, other) in row.iter_mut().zip(phi) {
                *sum += share * phi[k] * other;
            }
            if k >= 4 {
                row[10] -= share * phi[k];
            }
        }
    }
    // A tetrahedron has nine nodes, too few for ten functions; it is an image of the
    // regular one, and one factor has given it the whole tensor.
    let Some(solution) = solve(matrix) else {
        return;
    };
    let change = |r: Vec3| -> f64 { basis(r).iter().zip(solution).map(|(p, a)| p * a).sum() };
    let lowest = arms.iter().map(|r| change(*r)).fold(0.0, f64::min);
    let part = if lowest < LEAST - 1.0 { (LEAST - 1.0) / lowest } else { 1.0 };
    for (share, r) in shares.iter_mut().zip(arms) {
        *share *= 1.0 + part * change(*r);
    }
}

/// Solution of ten linear equations (right-hand sides in the last column), if there is one.
fn solve(mut m: [[f64; 11]; 10]) -> Option<[f64; 10]> {
    let scale = m.iter().flat_map(|row| &row[..10]).fold(0.0, |s: f64, x| s.max(x.abs()));
    for k in 0..10 {
        let pivot = (k..10).max_by(|&i, &j| m[i][k].abs().total_cmp(&m[j][k].abs()))?;
        if m[pivot][k].abs() <= 1e-12 * scale {
            return None;
        }
        m.swap(k, pivot);
        let row = m[k];
        for (i, other) in m.iter_mut().enumerate() {
            if i != k {
                let factor = other[k] / row[k];
                for (x, y) in other.iter_mut().zip(row) {
                    *x -= factor * y;
                }
            }
        }
    }
    let x = std::array::from_fn(|k| m[k][10] / m[k][k]);
    x.iter().all(|x| f64::is_finite(*x)).then_some(x)
}

impl Polyhedron {
    /// Centroid of the area of a face, m; of a slightly crooked one that of the triangles from the mean of its corners,
    /// whichever corner comes first.
    #[must_use]
    pub fn face_centre(&self, face: usize) -> Vec3 {
        let corners = &self.faces[face];
        let at = |k: u32| self.vertices[k as usize];
        let mean = corners.iter().map(|&k| at(k)).sum::<Vec3>() / corners.len() as f64;
        let normal = self.area_vector(face);
        let (mut weight, mut first) = (0.0, Vec3::ZERO);
        for (from, to) in edges_of(corners) {
            let (a, b) = (at(from) - mean, at(to) - mean);
            let w = a.cross(b).dot(normal);
            weight += w;
            first += w * (a + b);
        }
        mean + first / (3.0 * weight)
    }
}

/// Volume (m³) and gradients (1/m) of the shape functions of nodes 1, 2, 3 of a tetrahedron with the nodes `p0` and
/// `[p1, p2, p3]` (m).
///
/// Differences are taken between nodes that may be close, so that tiny faces keep their digits.
#[must_use]
pub fn element(p0: Vec3, [p1, p2, p3]: [Vec3; 3]) -> (f64, [Vec3; 3]) {
    let (a, b, c) = (p1 - p0, p2 - p0, p3 - p0);
    let six = a.dot((p2 - p1).cross(p3 - p1));
    let scale = 1.0 / six;
    let gradients = [scale * b.cross(p3 - p2), scale * c.cross(p1 - p3), scale * a.cross(p2 - p1)];
    (six / 6.0, gradients)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polyhedron::hull;
    use crate::random::Chance;

    fn stone(seed: u64, corners: usize) -> Polyhedron {
        let mut chance = Chance::new(seed);
        let points: Vec<Vec3> = (0..corners)
            .map(|_| {
                let p = Vec3::new(chance.normal(), chance.normal(), chance.normal());
                p.normalize() + Vec3::new(3.0, -2.0, 1.0)
            })
            .collect();
        hull(&points).unwrap()
    }

    #[test]
    fn a_cube_has_15_nodes_and_24_tetrahedra() {
        let half = 0.015;
        let mesh = Tetrahedra::new(&Polyhedron::brick(Vec3::new(1.0, 2.0, 3.0), Vec3::splat(half)))
            .unwrap();
        assert_eq!((mesh.nodes.len(), mesh.tets.len()), (15, 24));
        assert_eq!(mesh.first, [0, 4, 8, 12, 16, 20, 24]);
        let volume = (2.0 * half).powi(3);
        assert!((mesh.volume() / volume - 1.0).abs() < 1e-13);
        let lumped = mesh.lumped();
        // Shares of a cube: centroid 1/4, six face centres 1/24 each, eight vertices 1/16 each.
        for (node, share) in lumped.iter().enumerate() {
            let expected =
                [1.0 / 16.0, 1.0 / 24.0, 0.25][usize::from(node >= 8) + usize::from(node == 14)];
            assert!((share / volume - expected).abs() < 1e-13, "{node}");
        }
        let inertial = mesh.inertial();
        assert!((inertial[0] / lumped[0] - 4.0 / 7.0).abs() < 1e-12);
        assert!((inertial[9] / lumped[9] - 4.0 / 7.0).abs() < 1e-12);
        for face in 0..6 {
            let shares = mesh.tributary(face);
            let area = 4.0 * half * half;
            assert_eq!(shares.len(), 5);
            assert!((shares[0].1 / area - 1.0 / 3.0).abs() < 1e-12);
            assert!(shares[1..].iter().all(|s| (s.1 / area - 1.0 / 6.0).abs() < 1e-12));
        }
    }

    #[test]
    fn shares_have_the_moments_of_the_solid() {
        for seed in 0..40 {
            let solid = stone(seed, 6 + seed as usize % 20);
            let mesh = Tetrahedra::new(&solid).unwrap();
            let exact = solid.moments();
            let trace = |m: &crate::Mat3| m.x_axis.x + m.y_axis.y + m.z_axis.z;
            let c = exact.centroid;
            assert!((mesh.volume() / exact.volume - 1.0).abs() < 1e-13);
            for shares in [mesh.lumped(), mesh.inertial()] {
                assert!(shares.iter().all(|s| *s > 0.0));
                let total: f64 = shares.iter().sum();
                assert!((total / exact.volume - 1.0).abs() < 1e-13);
                let pairs = || shares.iter().zip(&mesh.nodes);
                let first: Vec3 = pairs().map(|(s, x)| *s * (*x - c)).sum();
                assert!(first.length() < 1e-14 * exact.volume * 10.0, "{first}");
            }
            // The whole inertia tensor.
            let inertial = mesh.inertial();
            let mut tensor = crate::Mat3::ZERO;
            for (share, x) in inertial.iter().zip(&mesh.nodes) {
                let r = *x - c;
                let outer = crate::Mat3::from_cols(r.x * r, r.y * r, r.z * r);
                tensor += (crate::Mat3::IDENTITY * r.length_squared() - outer) * *share;
            }
            let error = (tensor - exact.inertia).to_cols_array();
            let worst = error.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            assert!(worst < 1e-12 * trace(&exact.inertia), "{worst:e}");
            // Gradients of a linear field are exact.
            let field = |x: Vec3| 3.0 * x.x - 2.0 * x.y + 0.5 * x.z;
            for (tet, g) in mesh.tets.iter().zip(&mesh.gradients) {
                let value = |k: usize| field(mesh.nodes[tet[k] as usize]);
                let sum: Vec3 = (0..3).map(|k| (value(k + 1) - value(0)) * g[k]).sum();
                assert!(sum.distance(Vec3::new(3.0, -2.0, 0.5)) < 1e-9, "{sum}");
            }
        }
    }

    #[test]
    fn a_uniform_traction_gives_force_and_moment_of_the_face() {
        let solid = stone(7, 14);
        let mesh = Tetrahedra::new(&solid).unwrap();
        for face in 0..solid.faces.len() {
            let area = solid.area_vector(face).length();
            let shares = mesh.tributary(face);
            let sum: f64 = shares.iter().map(|s| s.1).sum();
            let first: Vec3 = shares.iter().map(|s| s.1 * mesh.nodes[s.0 as usize]).sum();
            assert!((sum / area - 1.0).abs() < 1e-12);
            assert!((first / area).distance(solid.face_centre(face)) < 1e-12);
        }
    }

    #[test]
    fn a_flat_solid_is_refused() {
        let mut brick = Polyhedron::brick(Vec3::ZERO, Vec3::ONE);
        for v in &mut brick.vertices {
            v.z = 0.0;
        }
        let error = Tetrahedra::new(&brick).unwrap_err();
        assert!(error.to_string().contains("it must be above 0"), "{error}");
    }
}
