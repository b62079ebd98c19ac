//! The depth below the surface of a convex solid, linear on tetrahedra that move with its material.
//!
//! The depth of a point is its distance from the nearest face, `phi = min_k (d_k - n_k . x)`: of slope one whatever the shape. Every face has
//! a region where it is the nearest one; two regions meet in a piece of the plane that halves the angle between their faces, so the
//! regions are a roof over each face and fill the solid. Each is cut into tetrahedra from the centre of its face to the triangles of
//! those pieces: every triangle (face centre, a, b) of the surface is a side of one of them.
//!
//! ```text
//!      ._______________.          two long and two short regions of a flat block:
//!      |\_____________/|          the depth is linear in each, and 1 m deep 1 m below any face
//!      |/             \|
//!      '---------------'
//! ```
//!
//! Corners are nodes of [`Tetrahedra`], or points between four of its nodes that follow them. A solid all of whose faces touch one ball about its
//! centroid (a cube) has its own tetrahedra as regions.

use super::Tetrahedra;
use crate::Vec3;

mod glued;

pub use glued::GluedCells;

/// Faces at nearly one distance from the centroid, relative to it: the regions are the tetrahedra of the solid.
const ROUND: f64 = 1e-9;
/// Points nearer than this, times the size, are one: more than round-off, and if that does not do, more than what crooked faces
/// ([`super::FLAT`]) move the corners of regions by.
const MERGED: [f64; 2] = [1e-8, 1e-5];
/// Corners nearer to a plane than this, times the size, lie in it.
const ON: f64 = 1e-9;
/// Unit normals that differ by less are of faces that no edge joins in one plane, with others in between: their regions do not meet.
const PARALLEL: f64 = 1e-3;
/// The regions may miss this share of the volume.
const COMPLETE: f64 = 1e-6;

/// A point that four nodes of a solid carry along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthPoint {
    /// Where it is in the solid, m.
    pub at: Vec3,
    /// Its nodes.
    pub nodes: [u32; 4],
    /// Their shape functions there.
    pub weights: [f64; 4],
}

/// Tetrahedra on which the depth below the surface is linear.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DepthCells {
    /// Corners that are no nodes of the solid.
    pub points: Vec<DepthPoint>,
    /// Depth at the nodes, then at the points, m.
    pub depths: Vec<f64>,
    /// Corners: nodes, then points. *Shape* `[n_cells]`.
    pub cells: Vec<[u32; 4]>,
    /// Whether the depth has slope one everywhere. Otherwise the regions of so crooked a solid could not be found, and it is
    /// linear from the surface to the centroid.
    pub even: bool,
}

impl DepthCells {
    /// The cells of a solid.
    #[must_use]
    pub fn new(mesh: &Tetrahedra) -> Self {
        let planes = planes(mesh);
        let centre = mesh.nodes[mesh.centre() as usize];
        let heights: Vec<f64> = planes.iter().map(|p| p.depth(centre)).collect();
        let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let most = heights.iter().copied().fold(0.0, f64::max);
        if most <= least * (1.0 + ROUND) {
            return Self::star(mesh, true);
        }
        let regions = Regions::new(mesh, planes);
        MERGED
            .into_iter()
            .find_map(|merged| regions.fill(merged))
            .unwrap_or_else(|| Self::star(mesh, false))
    }

    /// The tetrahedra of the solid, with the least distance of its centroid from a face at the centroid.
    fn star(mesh: &Tetrahedra, even: bool) -> Self {
        let mut depths = vec![0.0; mesh.nodes.len()];
        depths[mesh.centre() as usize] = mesh.height();
        Self { points: Vec::new(), depths, cells: mesh.tets.clone(), even }
    }

    /// The largest depth, m: the radius of the largest ball inside.
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.depths.iter().copied().fold(0.0, f64::max)
    }

    /// Hands out the nodes of a cell with their shares of what its corners have with these weights.
    #[inline]
    pub fn share(&self, cell: u32, weights: &[f64; 4], mut to: impl FnMut(u32, f64)) {
        let nodes = self.depths.len() - self.points.len();
        for (corner, weight) in self.cells[cell as usize].into_iter().zip(weights) {
            match (corner as usize).checked_sub(nodes) {
                None => to(corner, *weight),
                Some(k) => {
                    let point = &self.points[k];
                    for (node, share) in point.nodes.into_iter().zip(point.weights) {
                        to(node, *weight * share);
                    }
                }
            }
        }
    }
}

/// A plane `normal . x = offset`; of a face, the normal points outward.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: Vec3,
    offset: f64,
}

impl Plane {
    fn depth(&self, at: Vec3) -> f64 {
        self.offset - self.normal.dot(at)
    }

    fn turned(self) -> Self {
        Self { normal: -self.normal, offset: -self.offset }
    }
}

/// The planes of the faces.
fn planes(mesh: &Tetrahedra) -> Vec<Plane> {
    let at = |k: u32| mesh.nodes[k as usize];
    (0..mesh.first.len() - 1)
        .map(|face| {
            let (mut area, mut sum, mut count) = (Vec3::ZERO, Vec3::ZERO, 0.0);
            for [middle, a, b] in mesh.fan(face) {
                area += (at(a) - at(middle)).cross(at(b) - at(middle));
                sum += at(a);
                count += 1.0;
            }
            let normal = area.normalize_or_zero();
            let offset = normal.dot(sum / count);
            Plane { normal, offset }
        })
        .collect()
}

/// What the regions are made from.
struct Regions<'a> {
    mesh: &'a Tetrahedra,
    planes: Vec<Plane>,
    /// Where the region of one face (row) ends before that of another: the plane that halves their angle, out of the first.
    walls: Vec<Option<Plane>>,
    size: f64,
}

impl<'a> Regions<'a> {
    fn new(mesh: &'a Tetrahedra, planes: Vec<Plane>) -> Self {
        let count = planes.len();
        let mut walls = vec![None; count * count];
        for i in 0..count {
            for j in i + 1..count {
                let difference = planes[i].normal - planes[j].normal;
                let length = difference.length();
                if length > PARALLEL {
                    // Smaller depth of the first: `d_i - n_i . x < d_j - n_j . x`.
                    let wall = Plane {
                        normal: -difference / length,
                        offset: (planes[j].offset - planes[i].offset) / length,
                    };
                    walls[i * count + j] = Some(wall);
                }
            }
        }
        // Through the edge itself where two faces share one: also where they lie in one plane.
        let mut edges: Vec<([u32; 2], usize)> = Vec::with_capacity(mesh.tets.len());
        for face in 0..count {
            edges.extend(mesh.fan(face).map(|[_, a, b]| ([a.min(b), a.max(b)], face)));
        }
        edges.sort_unstable();
        for two in edges.windows(2).filter(|two| two[0].0 == two[1].0) {
            let ([a, b], i, j) = (two[0].0.map(|k| mesh.nodes[k as usize]), two[0].1, two[1].1);
            let mut normal = (b - a).cross(planes[i].normal + planes[j].normal).normalize_or_zero();
            let middle = mesh.nodes[mesh.tets[mesh.first[i] as usize][1] as usize];
            if normal.dot(middle - a) > 0.0 {
                normal = -normal;
            }
            let offset = normal.dot(0.5 * (a + b));
            walls[i * count + j] = Some(Plane { normal, offset });
        }
        for i in 0..count {
            for j in i + 1..count {
                walls[j * count + i] = walls[i * count + j].map(Plane::turned);
            }
        }
        let centre = mesh.nodes[mesh.centre() as usize];
        let radii = mesh.nodes.iter().map(|at| (*at - centre).length());
        let size = 2.0 * radii.fold(0.0, f64::max);
        Self { mesh, planes, walls, size }
    }

    fn wall(&self, from: usize, to: usize) -> Option<Plane> {
        self.walls[from * self.planes.len() + to]
    }

    /// All cells, with points nearer than `merged` times the size as one; `None` where they do not fill the solid.
    fn fill(&self, merged: f64) -> Option<DepthCells> {
        let count = self.planes.len();
        let mut filling = Filling::new(self, merged);
        for i in 0..count {
            for j in i + 1..count {
                if let Some(wall) = self.wall(i, j) {
                    filling.part([i, j], self.outline(i, j, wall));
                }
            }
        }
        let volume = self.mesh.volume();
        ((filling.volume - volume).abs() <= COMPLETE * volume).then_some(filling.made)
    }

    fn depth(&self, at: Vec3) -> f64 {
        let depths = self.planes.iter().map(|plane| plane.depth(at));
        depths.fold(f64::INFINITY, f64::min).max(0.0)
    }

    /// What the regions of two faces have in common.
    fn outline(&self, i: usize, j: usize, wall: Plane) -> Vec<Vec3> {
        let [u, v] = across(wall.normal);
        let origin = self.mesh.nodes[self.mesh.centre() as usize];
        let middle = origin + wall.depth(origin) * wall.normal;
        let mut ring: Vec<Vec3> = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[a, b]: [f64; 2]| middle + 2.0 * self.size * (a * u + b * v))
            .to_vec();
        let mut spare = Vec::new();
        let faces = [i, j].map(|k| self.planes[k]).into_iter();
        let others = (0..self.planes.len()).filter(|l| *l != i && *l != j);
        let walls = others.flat_map(|l| [self.wall(i, l), self.wall(j, l)]);
        for plane in faces.chain(walls.flatten()) {
            cut(&mut ring, &mut spare, &plane, ON * self.size);
            if ring.len() < 3 {
                return Vec::new();
            }
        }
        ring
    }
}

/// The cells as they are made.
struct Filling<'a> {
    regions: &'a Regions<'a>,
    /// Points nearer than this are one, m.
    reach: f64,
    made: DepthCells,
    /// Volume so far, m³.
    volume: f64,
}

impl<'a> Filling<'a> {
    fn new(regions: &'a Regions<'a>, merged: f64) -> Self {
        let mesh = regions.mesh;
        let mut depths = vec![0.0; mesh.nodes.len()];
        let centre = mesh.centre() as usize;
        depths[centre] = regions.depth(mesh.nodes[centre]);
        let made = DepthCells { depths, even: true, ..DepthCells::default() };
        Self { regions, reach: merged * regions.size, made, volume: 0.0 }
    }

    /// Adds the cells of two faces on what their regions have in common, anticlockwise seen from the region of the second.
    fn part(&mut self, [i, j]: [usize; 2], outline: Vec<Vec3>) {
        let mut ring: Vec<u32> = Vec::with_capacity(outline.len());
        for at in outline {
            let corner = self.corner(at);
            if ring.last() != Some(&corner) && ring.first() != Some(&corner) {
                ring.push(corner);
            }
        }
        for k in 2..ring.len() {
            let [a, b, c] = [ring[0], ring[k - 1], ring[k]];
            self.cell(i, [a, b, c]);
            self.cell(j, [a, c, b]);
        }
    }

    /// The corner at a place: a vertex or the centroid of the solid, or a point.
    fn corner(&mut self, at: Vec3) -> u32 {
        let mesh = self.regions.mesh;
        let nodes = mesh.nodes.len();
        let near = |other: Vec3| (at - other).length_squared() < self.reach * self.reach;
        // Centres of faces are corners of the cells on the surface only.
        let vertices = (0..nodes - 1 - self.regions.planes.len()).chain([nodes - 1]);
        if let Some(node) = vertices.into_iter().find(|k| near(mesh.nodes[*k])) {
            return node as u32;
        }
        if let Some(k) = self.made.points.iter().position(|p| near(p.at)) {
            return (nodes + k) as u32;
        }
        self.made.points.push(anchored(mesh, at));
        self.made.depths.push(self.regions.depth(at));
        (nodes + self.made.points.len() - 1) as u32
    }

    /// Adds the cell from the centre of a face to a triangle.
    fn cell(&mut self, face: usize, [a, b, c]: [u32; 3]) {
        let Regions { mesh, size, .. } = self.regions;
        let middle = mesh.tets[mesh.first[face] as usize][1];
        let at = |k: u32| match (k as usize).checked_sub(mesh.nodes.len()) {
            None => mesh.nodes[k as usize],
            Some(k) => self.made.points[k].at,
        };
        let origin = at(middle);
        let [p, q, r] = [a, b, c].map(|k| at(k) - origin);
        let volume = p.dot(q.cross(r)) / 6.0;
        // Round-off: two corners of the triangle and the centre are in line.
        if volume > f64::EPSILON * size * size * size {
            self.made.cells.push([middle, a, b, c]);
        }
        self.volume += volume;
    }
}

/// Two unit vectors across a unit vector and each other, right-handed with it.
fn across(n: Vec3) -> [Vec3; 2] {
    let u = n.any_orthonormal_vector();
    [u, n.cross(u)]
}

/// Keeps what of a convex outline lies inside a plane.
fn cut(ring: &mut Vec<Vec3>, spare: &mut Vec<Vec3>, plane: &Plane, slack: f64) {
    let depth = |at: Vec3| {
        let depth = plane.depth(at);
        if depth.abs() <= slack { 0.0 } else { depth }
    };
    if ring.iter().all(|at| depth(*at) >= 0.0) {
        return;
    }
    spare.clear();
    for k in 0..ring.len() {
        let (here, next) = (ring[k], ring[(k + 1) % ring.len()]);
        let [a, b] = [here, next].map(depth);
        if a >= 0.0 {
            spare.push(here);
        }
        if a * b < 0.0 {
            spare.push(here + a / (a - b) * (next - here));
        }
    }
    std::mem::swap(ring, spare);
}

/// A place in a solid between the corners of the tetrahedron that it lies in.
fn anchored(mesh: &Tetrahedra, at: Vec3) -> DepthPoint {
    let weights = |k: usize| {
        let [a, b, c] = mesh.gradients[k];
        let arm = at - mesh.nodes[mesh.tets[k][0] as usize];
        let [a, b, c] = [a, b, c].map(|g| g.dot(arm));
        [1.0 - a - b - c, a, b, c]
    };
    let (mut best, mut inside) = (0, f64::NEG_INFINITY);
    for k in 0..mesh.tets.len() {
        let least = weights(k).into_iter().fold(f64::INFINITY, f64::min);
        if least > inside {
            (best, inside) = (k, least);
        }
    }
    DepthPoint { at, nodes: mesh.tets[best], weights: weights(best) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Quat;
    use crate::polyhedron::{Polyhedron, hull};
    use crate::random::Chance;

    fn mesh(solid: &Polyhedron) -> Tetrahedra {
        Tetrahedra::new(solid).unwrap()
    }

    /// Whether all cells have slope one, fill the solid, and are right side out.
    fn check(mesh: &Tetrahedra) -> DepthCells {
        let field = DepthCells::new(mesh);
        assert!(field.even);
        let nodes = mesh.nodes.len();
        let at = |k: u32| {
            let k = k as usize;
            if k < nodes { mesh.nodes[k] } else { field.points[k - nodes].at }
        };
        let (mut sum, mut uneven) = (0.0, 0.0);
        for cell in &field.cells {
            let places = cell.map(at);
            let [p, q, r] = [1, 2, 3].map(|k| places[k] - places[0]);
            let det = p.dot(q.cross(r));
            assert!(det > 0.0);
            sum += det / 6.0;
            let [g, h, k] = [q.cross(r), r.cross(p), p.cross(q)].map(|n| n / det);
            let [b, c, d] = [1, 2, 3].map(|k| field.depths[cell[k] as usize]);
            let a = field.depths[cell[0] as usize];
            let slope = (b - a) * g + (c - a) * h + (d - a) * k;
            uneven += det / 6.0 * (slope.length() - 1.0).abs();
        }
        assert!((sum / mesh.volume() - 1.0).abs() < 1e-6, "{sum}");
        assert!(uneven < 1e-4 * sum, "{uneven:e} of {sum:e}");
        for point in &field.points {
            let along = point.nodes.iter().zip(point.weights);
            let there: Vec3 = along.map(|(n, w)| w * mesh.nodes[*n as usize]).sum();
            assert!((there - point.at).length() < 1e-12 * there.length().max(1.0));
        }
        field
    }

    #[test]
    fn a_cube_has_its_own_tetrahedra_and_a_long_brick_a_ridge() {
        let cube = mesh(&Polyhedron::brick(Vec3::ONE, Vec3::splat(0.5)));
        let field = check(&cube);
        assert_eq!(field.cells, cube.tets);
        assert_eq!(field.peak(), 0.5);
        for half in [[0.5, 0.5, 4.0], [0.5, 3.0, 4.0], [2.0, 2.0, 0.01]] {
            let brick = mesh(&Polyhedron::brick(Vec3::ONE, Vec3::from_array(half)));
            let field = check(&brick);
            let least = half[0].min(half[2]);
            assert!((field.peak() - least).abs() < 1e-12, "{}", field.peak());
            // The ends of the ridge, or of the flat top.
            let wanted = if half[0] == half[1] && half[0] < half[2] { 2 } else { 4 };
            assert!(field.points.len() <= wanted + 2, "{:?}", field.points.len());
        }
    }

    #[test]
    fn hulls_needles_slabs_and_wedges_have_slope_one() {
        let mut chance = Chance::new(7);
        for round in 0..200 {
            let count = 4 + round % 20;
            let stretch = [Vec3::ONE, Vec3::new(10.0, 1.0, 1.0), Vec3::new(5.0, 8.0, 0.2)];
            let points: Vec<Vec3> = (0..count)
                .map(|_| {
                    let mut next = || chance.unit() - 0.5;
                    stretch[round % 3] * Vec3::new(next(), next(), next())
                })
                .collect();
            let Ok(solid) = hull(&points) else { continue };
            let Ok(mesh) = Tetrahedra::new(&solid) else {
                continue;
            };
            check(&mesh);
        }
    }

    /// As an OBJ file gives a brick: twelve triangles, two in each plane; and a face that is cut in two.
    #[test]
    fn faces_in_one_plane_are_one() {
        let brick = Polyhedron::brick(Vec3::ZERO, Vec3::new(0.5, 1.0, 2.0));
        let triangles = brick
            .faces
            .iter()
            .flat_map(|f| [[f[0], f[1], f[2]].to_vec(), [f[0], f[2], f[3]].to_vec()]);
        let solid = Polyhedron::new(brick.vertices.clone(), triangles.collect()).unwrap();
        let field = check(&mesh(&solid));
        assert!((field.peak() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn crooked_faces_are_taken() {
        let turn = Quat::from_scaled_axis(Vec3::new(0.3, -0.8, 0.4));
        let mut solid = Polyhedron::brick(Vec3::ZERO, Vec3::new(0.5, 1.0, 2.0));
        let mut chance = Chance::new(3);
        for v in &mut solid.vertices {
            *v = turn * *v + 1e-6 * Vec3::new(chance.unit(), chance.unit(), chance.unit());
        }
        let solid = Polyhedron::new(solid.vertices, solid.faces).unwrap();
        check(&mesh(&solid));
    }
}
