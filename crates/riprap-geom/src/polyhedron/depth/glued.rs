//! The depth below the surface of a solid of glued parts, linear on tetrahedra.
//!
//! It is the largest one of the depths in the convex pieces of the solid ([`crate::polyhedron::glued`]): `phi = max phi_K`. The cells of a piece
//! keep what no other piece is deeper in. `phi_L` is the smallest distance from a plane of L, so a cell of K loses a convex part to L,
//! plane by plane; where both are nearest to one plane that they share, the first of them has it. What remains of all cells fills the
//! solid once, and `phi` is nil on its true surface alone: on a glued face another piece is deeper.
//!
//! ```text
//!     ._____.
//!     |  K  |          an L: the bars K and L share the corner; the line from its outer to its inner edge
//!     |   / |______.   parts what either is deeper in
//!     | /     L    |
//!     '------------'
//! ```

use super::{COMPLETE, DepthCells, ON, Plane, planes};
use crate::Vec3;
use crate::polyhedron::{Polyhedron, Sliced, Tetrahedra, glued, slice};

/// The cells of a solid of glued parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GluedCells {
    /// Cells and depths at their corners; all of these are nodes.
    pub field: DepthCells,
    /// Places of the nodes, m.
    pub nodes: Vec<Vec3>,
    /// Convex piece of each cell.
    pub pieces: Vec<u32>,
    /// Least distance of the centre of a piece from one of its faces, m.
    pub height: f64,
    /// Largest depth of the thinnest piece, m.
    pub peak: f64,
}

impl GluedCells {
    /// The cells of a solid of these parts; `None` where they make no solid, or the cells of their convex pieces do not fill it.
    #[must_use]
    pub fn new(parts: &[Polyhedron]) -> Option<Self> {
        let mut pieces: Vec<Polyhedron> = Vec::new();
        for term in glued::terms(parts).ok()? {
            // The first term of a piece is the piece.
            if usize::from(term.piece) == pieces.len() {
                pieces.push(term.solid);
            }
        }
        let meshes: Vec<Tetrahedra> =
            pieces.iter().map(Tetrahedra::new).collect::<Result<_, _>>().ok()?;
        let sides: Vec<Vec<Plane>> = meshes.iter().map(planes).collect();
        let size = pieces.iter().map(Polyhedron::size).fold(0.0, f64::max);
        let mut made = Self { height: f64::INFINITY, peak: f64::INFINITY, ..Self::default() };
        made.field.even = true;
        let mut found = 0.0;
        for (piece, mesh) in meshes.iter().enumerate() {
            let field = DepthCells::new(mesh);
            made.field.even &= field.even;
            made.height = made.height.min(mesh.height());
            made.peak = made.peak.min(field.peak());
            for cell in &field.cells {
                let corners = cell.map(|k| field.place(mesh, k));
                let depth = Linear::new(corners, cell.map(|k| field.depths[k as usize]));
                let mut kept = vec![tetrahedron(corners)];
                for (other, planes) in sides.iter().enumerate().filter(|(k, _)| *k != piece) {
                    kept = (kept.iter())
                        .flat_map(|part| without(part, &depth, planes, other < piece, ON * size))
                        .collect();
                }
                for part in &kept {
                    found += made.add(part, &depth, piece as u32, size);
                }
            }
        }
        let volume: f64 = parts.iter().map(|part| part.moments().volume).sum();
        let filled = (found - volume).abs() <= COMPLETE * volume;
        (made.field.even && filled).then_some(made)
    }

    /// Adds the tetrahedra of a convex part of a cell; their volume, m³.
    fn add(&mut self, part: &Polyhedron, depth: &Linear, piece: u32, size: f64) -> f64 {
        let first = self.nodes.len() as u32;
        self.nodes.extend(&part.vertices);
        self.field.depths.extend(part.vertices.iter().map(|at| depth.at(*at).max(0.0)));
        let mut sum = 0.0;
        let at = |k: u32| part.vertices[k as usize];
        // From a corner to the triangles of all faces that it is not on.
        let apex = part.faces.first().and_then(|face| face.first()).copied().unwrap_or(0);
        for face in part.faces.iter().filter(|face| !face.contains(&apex)) {
            for k in 2..face.len() {
                let corners = [apex, face[0], face[k - 1], face[k]];
                let [a, b, c] = [1, 2, 3].map(|k: usize| at(corners[k]) - at(apex));
                let volume = a.dot(b.cross(c)) / 6.0;
                sum += volume;
                // Round-off.
                if volume > f64::EPSILON * size * size * size {
                    self.field.cells.push(corners.map(|k| first + k));
                    self.pieces.push(piece);
                }
            }
        }
        sum
    }
}

impl DepthCells {
    /// Where a corner of a cell is in the solid, m.
    fn place(&self, mesh: &Tetrahedra, corner: u32) -> Vec3 {
        match (corner as usize).checked_sub(mesh.nodes.len()) {
            None => mesh.nodes[corner as usize],
            Some(k) => self.points[k].at,
        }
    }
}

/// A linear depth.
struct Linear {
    origin: Vec3,
    slope: Vec3,
    /// At the origin, m.
    level: f64,
}

impl Linear {
    fn new(corners: [Vec3; 4], depths: [f64; 4]) -> Self {
        let [p, q, r] = [1, 2, 3].map(|k| corners[k] - corners[0]);
        let det = p.dot(q.cross(r));
        let [a, b, c] = [1, 2, 3].map(|k| (depths[k] - depths[0]) / det);
        let slope = a * q.cross(r) + b * r.cross(p) + c * p.cross(q);
        Self { origin: corners[0], slope, level: depths[0] }
    }

    fn at(&self, place: Vec3) -> f64 {
        self.level + self.slope.dot(place - self.origin)
    }
}

fn tetrahedron(corners: [Vec3; 4]) -> Polyhedron {
    let faces = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]].map(|face| face.to_vec());
    Polyhedron { vertices: corners.to_vec(), faces: faces.to_vec() }
}

/// What of a convex part with a depth is not deeper below the planes of another piece; `first`: that one has what both are equally deep in.
/// Depths nearer to each other than `slack` (m) are equal.
fn without(
    part: &Polyhedron,
    depth: &Linear,
    planes: &[Plane],
    first: bool,
    slack: f64,
) -> Vec<Polyhedron> {
    let mut inside = part.clone();
    let mut kept = Vec::new();
    for plane in planes {
        let deeper = |at: Vec3| plane.depth(at) - depth.at(at);
        let heights = || inside.vertices.iter().map(|at| deeper(*at));
        let shared = heights().all(|height| height.abs() <= slack);
        if shared && first || !shared && heights().all(|height| height >= -slack) {
            continue;
        }
        if heights().all(|height| height <= slack) {
            kept.push(inside);
            return kept;
        }
        // `deeper` is linear: the other piece may have it where it is positive.
        let gradient = plane.normal + depth.slope;
        let length = gradient.length();
        let normal = gradient / length;
        let offset = normal.dot(depth.origin) + deeper(depth.origin) / length;
        match (slice(&inside, normal, offset), slice(&inside, -normal, -offset)) {
            (Sliced::Part(within), Sliced::Part(beyond)) => {
                kept.push(beyond);
                inside = within;
            }
            (Sliced::Nothing, _) => {
                kept.push(inside);
                return kept;
            }
            _ => {}
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Chance;

    fn brick(low: [f64; 3], high: [f64; 3]) -> Polyhedron {
        let (low, high) = (Vec3::from(low), Vec3::from(high));
        Polyhedron::brick(0.5 * (low + high), 0.5 * (high - low))
    }

    /// An L, a U of walls that differ, a table, and a brick with a wedge on top: each point is in one cell alone, at the depth of the
    /// deepest piece.
    #[test]
    fn cells_have_the_depth_of_the_deepest_piece() {
        let wedge = Polyhedron {
            vertices: [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0]]
                .into_iter()
                .chain([[0.0, 0.0, 1.8], [0.0, 1.0, 1.8]])
                .map(Vec3::from)
                .collect(),
            faces: vec![
                vec![0, 2, 3, 1],
                vec![0, 4, 5, 2],
                vec![1, 3, 5, 4],
                vec![0, 1, 4],
                vec![2, 5, 3],
            ],
        };
        let l = vec![brick([0.0; 3], [3.0, 1.0, 1.0]), brick([0.0, 0.0, 1.0], [1.0, 1.0, 3.0])];
        let u = vec![
            brick([0.0; 3], [3.0, 1.0, 0.7]),
            brick([0.0, 0.0, 0.7], [0.5, 1.0, 2.0]),
            brick([2.2, 0.0, 0.7], [3.0, 1.0, 1.6]),
        ];
        let mut table = vec![brick([0.0, 0.0, 1.0], [3.0, 2.0, 1.2])];
        for (x, y) in [(0.0, 0.0), (2.8, 0.0), (0.0, 1.8), (2.8, 1.8)] {
            table.push(brick([x, y, 0.0], [x + 0.2, y + 0.2, 1.0]));
        }
        let capped = vec![brick([0.0; 3], [2.0, 1.0, 1.0]), wedge];
        for parts in [l, u, table, capped] {
            let terms = glued::terms(&parts).unwrap();
            let count = usize::from(terms.last().unwrap().piece) + 1;
            assert!(count > 1);
            let first = |k: usize| terms.iter().find(|term| usize::from(term.piece) == k);
            let pieces: Vec<Polyhedron> =
                (0..count).map(|k| first(k).unwrap().solid.clone()).collect();
            let made = GluedCells::new(&parts).unwrap();
            let sides: Vec<Vec<Plane>> =
                pieces.iter().map(|p| planes(&Tetrahedra::new(p).unwrap())).collect();
            let least = |planes: &Vec<Plane>, at: Vec3| {
                planes.iter().map(|plane| plane.depth(at)).fold(f64::INFINITY, f64::min)
            };
            let mut chance = Chance::new(7);
            let mut inside = 0;
            for _ in 0..2000 {
                let at = 3.0 * Vec3::new(chance.unit(), chance.unit(), chance.unit());
                let exact = sides.iter().map(|s| least(s, at)).fold(0.0, f64::max);
                let mut cells = 0;
                for cell in &made.field.cells {
                    let places = cell.map(|k| made.nodes[k as usize]);
                    let depths = cell.map(|k| made.field.depths[k as usize]);
                    let [p, q, r] = [1, 2, 3].map(|k| places[k] - places[0]);
                    let det = p.dot(q.cross(r));
                    let arm = at - places[0];
                    let weights = [q.cross(r), r.cross(p), p.cross(q)].map(|g| g.dot(arm) / det);
                    let rest = 1.0 - weights.iter().sum::<f64>();
                    if rest.min(weights.into_iter().fold(1.0, f64::min)) > 1e-9 {
                        cells += 1;
                        let depth = Linear::new(places, depths).at(at);
                        assert!((depth - exact).abs() < 1e-9, "{at}: {depth} {exact}");
                    }
                }
                inside += cells;
                assert_eq!(cells, i32::from(exact > 0.0), "{at}");
            }
            assert!(inside > 60, "{inside}");
        }
    }
}
