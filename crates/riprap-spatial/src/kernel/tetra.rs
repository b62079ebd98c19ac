//! Two tetrahedra that carry a depth each: their share of the equal-pressure law.
//!
//! A block that is no set of planes (deformable, or the partner of one) carries its depth `phi` on tetrahedra: linear in each,
//! continuous, nil on its surface. Two such blocks store `U = 2 kn int_O min(phi_1, phi_2) dV`; the overlap O is the sum of those
//! of their tetrahedra. In each of them the surface of equal depth is a plane: it cuts the overlap into a half where `phi_1` is
//! the smaller one and a half where `phi_2` is. `phi` being linear, volume and centroid of both halves are all that energy and
//! forces need:
//!
//! ```text
//!    U += 2 kn sum_i V_i phi_i(c_i)        f_a += 2 kn grad(phi_i) V_i N_a(c_i)   on corner a of tetrahedron i
//! ```
//!
//! The depth moves with the material: at a fixed point it changes by `-grad(phi) . du`, and `min(phi_1, phi_2)` is nil on the boundary of
//! O, so the forces are minus the gradient of U, over all pairs of tetrahedra of two blocks together.

use riprap_geom::Vec3;

/// Edges that a face of an overlap of two tetrahedra, cut once more, can have: four, and one more for each of the four planes and
/// the cut, as round-off may order them.
const EDGES: usize = 12;

/// Corners that are nearer to a plane than this, over the size of the terms of their distance, lie in it: the corners of a face in the
/// plane of a cut have distances of either sign by round-off, and would be cut more than twice.
const FLAT: f64 = 1e-14;

/// A tetrahedron that carries a depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    /// Corners, m.
    pub corners: [Vec3; 4],
    /// Gradients of the shape functions of the corners, 1/m.
    pub gradients: [Vec3; 4],
    /// The shape functions at the origin.
    pub offsets: [f64; 4],
    /// Gradient of the depth.
    pub slope: Vec3,
    /// The depth at the origin, m.
    pub level: f64,
}

impl Cell {
    /// The cell of these corners (m) with these depths (m) there; `None` where it is turned inside out.
    #[must_use]
    pub fn new(corners: [Vec3; 4], depths: [f64; 4]) -> Option<Self> {
        let [e1, e2, e3] = [1, 2, 3].map(|k| corners[k] - corners[0]);
        let normals = [e2.cross(e3), e3.cross(e1), e1.cross(e2)];
        let det = e1.dot(normals[0]);
        if det.is_nan() || det <= 0.0 {
            return None;
        }
        let [g1, g2, g3] = normals.map(|n| n / det);
        let gradients = [-(g1 + g2 + g3), g1, g2, g3];
        let at = corners[0];
        let offsets = [0, 1, 2, 3].map(|k| f64::from(k == 0) - gradients[k].dot(at));
        let [a, b, c, d] = depths;
        Some(Self {
            corners,
            gradients,
            offsets,
            slope: a * gradients[0] + b * gradients[1] + c * gradients[2] + d * gradients[3],
            level: a * offsets[0] + b * offsets[1] + c * offsets[2] + d * offsets[3],
        })
    }

    /// The cell of these corners (m) in any order, with a depth of this gradient, and of this size (m) at the origin.
    #[must_use]
    pub fn with_depth([a, b, c, d]: [Vec3; 4], slope: Vec3, level: f64) -> Option<Self> {
        let flat = [0.0; 4];
        let cell = Self::new([a, b, c, d], flat).or_else(|| Self::new([a, c, b, d], flat))?;
        Some(Self { slope, level, ..cell })
    }

    /// The same cell about an origin that lies at `-by` (m).
    #[must_use]
    pub fn shifted(&self, by: Vec3) -> Self {
        Self {
            corners: self.corners.map(|c| c + by),
            offsets: [0, 1, 2, 3].map(|k| self.offsets[k] - self.gradients[k].dot(by)),
            level: self.level - self.slope.dot(by),
            ..*self
        }
    }

    /// Shape functions of the corners at a point (m).
    #[must_use]
    pub fn weights(&self, at: Vec3) -> [f64; 4] {
        [0, 1, 2, 3].map(|k| self.gradients[k].dot(at) + self.offsets[k])
    }

    /// The depth at a point (m), m.
    #[must_use]
    pub fn depth(&self, at: Vec3) -> f64 {
        self.slope.dot(at) + self.level
    }

    /// Whether a face of the cell has all corners of the other one beyond it.
    fn misses(&self, other: &Self) -> bool {
        // Two that only edges keep apart pass; the cuts find nothing of them.
        (0..4).any(|k| {
            let (g, offset) = (self.gradients[k], self.offsets[k]);
            other.corners.iter().all(|c| g.dot(*c) + offset <= 0.0)
        })
    }
}

/// The part of an overlap in which one of the two depths is the smaller one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Half {
    /// Volume, m³.
    pub volume: f64,
    /// Centroid, m.
    pub centroid: Vec3,
}

/// The piece of the surface of equal depth in an overlap, with its integrals over the depth phi and over the area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Piece {
    /// Vector area, from the first block to the second, m².
    pub vector: Vec3,
    /// Integral of phi, m³.
    pub weight: f64,
    /// Integral of phi x, m⁴.
    pub weight_first: Vec3,
    /// Integral of phi x², m⁵.
    pub weight_second: f64,
    /// Area, m².
    pub area: f64,
    /// Integral of x, m³.
    pub area_first: Vec3,
    /// Integral of x², m⁴.
    pub area_second: f64,
    /// Largest phi, m.
    pub depth: f64,
}

impl Piece {
    /// Adds another piece.
    pub fn add(&mut self, other: &Self) {
        self.vector += other.vector;
        self.weight += other.weight;
        self.weight_first += other.weight_first;
        self.weight_second += other.weight_second;
        self.area += other.area;
        self.area_first += other.area_first;
        self.area_second += other.area_second;
        self.depth = self.depth.max(other.depth);
    }
}

/// What two cells have in common.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overlap {
    /// Where the depth of the first, of the second cell is the smaller one.
    pub halves: [Half; 2],
    /// Surface of equal depth.
    pub surface: Piece,
}

/// Workspace for the overlap of two cells; kept, so that nothing is allocated.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    solid: Solid,
    spare: Solid,
    distances: Vec<f64>,
    /// New number of a corner.
    kept: Vec<u8>,
    /// Corner inside, corner outside, number of the point where the edge between them is cut.
    crossings: Vec<[u8; 3]>,
}

/// A convex solid by its corners and the directed edges of its faces, in any order.
#[derive(Clone, Debug, Default)]
struct Solid {
    points: Vec<Vec3>,
    faces: Vec<Face>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Face {
    edges: [[u8; 2]; EDGES],
    count: usize,
}

impl Face {
    fn push(&mut self, edge: [u8; 2]) {
        // More than there is room for would be an edge of no length.
        if let Some(to) = self.edges.get_mut(self.count) {
            *to = edge;
            self.count += 1;
        }
    }

    fn edges(&self) -> &[[u8; 2]] {
        &self.edges[..self.count]
    }
}

/// What a plane leaves of a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Left {
    All,
    Part,
    None,
}

impl Workspace {
    /// The overlap of two cells; `None` where they have no volume in common.
    pub fn overlap(&mut self, [a, b]: [&Cell; 2]) -> Option<Overlap> {
        if a.misses(b) || b.misses(a) {
            return None;
        }
        self.solid.tetrahedron(&a.corners);
        for (g, offset) in b.gradients.iter().zip(b.offsets) {
            if self.cut(*g, offset) == Left::None {
                return None;
            }
        }
        let (volume, first) = self.solid.moments();
        if volume.is_nan() || volume <= 0.0 {
            return None;
        }
        let half = |volume: f64, first: Vec3| {
            if volume > 0.0 {
                let centroid = first / volume;
                Half { volume, centroid }
            } else {
                Half::default()
            }
        };
        let mut overlap = Overlap::default();
        // What stays is where the second depth less the first is positive: there the first one is the smaller.
        match self.cut(b.slope - a.slope, b.level - a.level) {
            Left::All => overlap.halves[0] = half(volume, first),
            Left::None => overlap.halves[1] = half(volume, first),
            Left::Part => {
                let (own, own_first) = self.solid.moments();
                // The other half is the rest of the whole: no second cut, and both add up to it.
                overlap.halves = [half(own, own_first), half(volume - own, first - own_first)];
                overlap.surface = self.solid.last_face(a);
            }
        }
        Some(overlap)
    }

    /// Leaves of the solid what lies where `gradient . x + offset` is positive. The face made by the cut is the last one.
    fn cut(&mut self, gradient: Vec3, offset: f64) -> Left {
        let solid = &self.solid;
        self.distances.clear();
        self.distances.extend(solid.points.iter().map(|p| {
            let beyond = gradient.dot(*p) + offset;
            let size = gradient.abs().dot(p.abs()) + offset.abs();
            if beyond.abs() <= FLAT * size { 0.0 } else { beyond }
        }));
        let distances = &self.distances;
        if distances.iter().all(|d| *d >= 0.0) {
            return Left::All;
        }
        if distances.iter().all(|d| *d <= 0.0) {
            return Left::None;
        }
        let new = &mut self.spare;
        new.points.clear();
        new.faces.clear();
        self.kept.clear();
        self.crossings.clear();
        for (point, d) in solid.points.iter().zip(distances) {
            self.kept.push(new.points.len() as u8);
            if *d >= 0.0 {
                new.points.push(*point);
            }
        }
        let inside = |k: u8| distances[k as usize] >= 0.0;
        let crossings = &mut self.crossings;
        let mut crossing = |points: &mut Vec<Vec3>, [within, beyond]: [u8; 2]| -> u8 {
            // Two faces share the edge and must share its crossing, or the solid would have a gap there.
            let known = crossings.iter().find(|c| c[0] == within && c[1] == beyond);
            if let Some(&[_, _, number]) = known {
                return number;
            }
            let (d0, d1) = (distances[within as usize], distances[beyond as usize]);
            let [p0, p1] = [within, beyond].map(|k| solid.points[k as usize]);
            let number = points.len() as u8;
            points.push(p0 + d0 / (d0 - d1) * (p1 - p0));
            crossings.push([within, beyond, number]);
            number
        };
        let mut lid = Face::default();
        for face in &solid.faces {
            let mut left = Face::default();
            let (mut exit, mut entry) = (None, None);
            for &[from, to] in face.edges() {
                match (inside(from), inside(to)) {
                    (true, true) => {
                        left.push([self.kept[from as usize], self.kept[to as usize]]);
                    }
                    (true, false) => {
                        let at = crossing(&mut new.points, [from, to]);
                        left.push([self.kept[from as usize], at]);
                        exit = Some(at);
                    }
                    (false, true) => {
                        let at = crossing(&mut new.points, [to, from]);
                        left.push([at, self.kept[to as usize]]);
                        entry = Some(at);
                    }
                    (false, false) => {}
                }
            }
            if let (Some(exit), Some(entry)) = (exit, entry) {
                left.push([exit, entry]);
                // Each edge of a closed solid is run through once in either direction.
                lid.push([entry, exit]);
            }
            if left.count > 0 {
                new.faces.push(left);
            }
        }
        new.faces.push(lid);
        std::mem::swap(&mut self.solid, &mut self.spare);
        Left::Part
    }
}

impl Solid {
    fn tetrahedron(&mut self, corners: &[Vec3; 4]) {
        self.points.clear();
        self.points.extend_from_slice(corners);
        self.faces.clear();
        for [a, b, c] in [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]] {
            let mut face = Face::default();
            for edge in [[a, b], [b, c], [c, a]] {
                face.push(edge);
            }
            self.faces.push(face);
        }
    }

    /// Volume (m³) and integral of x (m⁴).
    fn moments(&self) -> (f64, Vec3) {
        // About one of its own corners: far from the origin volumes would be small differences of large numbers.
        let origin = self.points[0];
        let (mut six, mut first) = (0.0, Vec3::ZERO);
        for face in &self.faces {
            let Some(&[start, _]) = face.edges().first() else {
                continue;
            };
            let q = self.points[start as usize] - origin;
            for &[from, to] in face.edges() {
                if from == start || to == start {
                    continue;
                }
                let [p, r] = [from, to].map(|k| self.points[k as usize] - origin);
                let det = q.dot(p.cross(r));
                six += det;
                first += det * (q + p + r);
            }
        }
        (six / 6.0, first / 24.0 + six / 6.0 * origin)
    }

    /// Integrals over the last face, with the depth of a cell.
    fn last_face(&self, cell: &Cell) -> Piece {
        let mut piece = Piece::default();
        let Some(face) = self.faces.last() else {
            return piece;
        };
        let Some(&[start, _]) = face.edges().first() else {
            return piece;
        };
        let q = self.points[start as usize];
        for &[from, to] in face.edges() {
            let [p, r] = [from, to].map(|k| self.points[k as usize]);
            piece.depth = piece.depth.max(cell.depth(p));
            if from == start || to == start {
                continue;
            }
            // The lid looks out of the half of the first block: to that block's inside.
            let doubled = (r - q).cross(p - q);
            let t = doubled.length();
            let x = [q, p, r];
            let phi = x.map(|x| cell.depth(x));
            let sum: f64 = phi.iter().sum();
            let sum_x = q + p + r;
            let (mut phi_x, mut squares, mut phi_squares) = (Vec3::ZERO, 0.0, 0.0);
            for (phi, x) in phi.iter().zip(x) {
                let square = x.length_squared();
                phi_x += *phi * x;
                squares += square;
                phi_squares += phi * square;
            }
            let around = sum_x.length_squared();
            piece.vector += 0.5 * doubled;
            piece.weight += t * sum / 6.0;
            piece.weight_first += t / 24.0 * (sum * sum_x + phi_x);
            piece.weight_second += t / 120.0
                * (sum * around + 2.0 * sum_x.dot(phi_x) + sum * squares + 2.0 * phi_squares);
            piece.area += 0.5 * t;
            piece.area_first += t / 6.0 * sum_x;
            piece.area_second += t / 24.0 * (around + squares);
        }
        piece
    }
}

#[cfg(test)]
mod tests;
