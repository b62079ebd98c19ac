//! One outline: mass properties, clean-up, validation, shape measures.
//!
//! An outline is a slice of vertices, the last joined to the first, without repetition of the first.
//! Everything is computed from vertices relative to the first one, so an outline at 1e6 m keeps the
//! digits that its coordinates have.

use crate::{GeomError, Vec2, tol};

/// Axis-parallel box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    /// Lower left corner.
    pub min: Vec2,
    /// Upper right corner.
    pub max: Vec2,
}

impl Aabb {
    /// Box around points; of no points, an inverted box that touches nothing.
    pub fn of(points: &[Vec2]) -> Aabb {
        let mut bounds =
            Aabb { min: Vec2::splat(f64::INFINITY), max: Vec2::splat(f64::NEG_INFINITY) };
        for &p in points {
            bounds.min = bounds.min.min(p);
            bounds.max = bounds.max.max(p);
        }
        bounds
    }

    /// Whether the boxes overlap or touch.
    pub fn touches(&self, other: &Aabb) -> bool {
        self.min.x <= other.max.x
            && other.min.x <= self.max.x
            && self.min.y <= other.max.y
            && other.min.y <= self.max.y
    }

    /// The box moved outwards by `margin` on every side.
    pub fn grown(&self, margin: f64) -> Aabb {
        Aabb { min: self.min - Vec2::splat(margin), max: self.max + Vec2::splat(margin) }
    }

    /// Length of the diagonal.
    pub fn size(&self) -> f64 {
        (self.max - self.min).length()
    }

    /// Middle of the box.
    pub fn centre(&self) -> Vec2 {
        self.min + 0.5 * (self.max - self.min)
    }
}

/// Mass properties for density 1, thickness 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    /// Signed area, positive anticlockwise, m2.
    pub area: f64,
    /// Centroid, m.
    pub centroid: Vec2,
    /// Polar second moment of area about the centroid, m4; has the sign of the area.
    pub second_moment: f64,
}

/// Area, centroid and second moment, exact for any simple polygon (sums over signed triangles).
///
/// A polygon without area gets the mean of its vertices as centroid.
/// # Examples
///
/// ```
/// use riprap_geom::Vec2;
/// use riprap_geom::polygon::mass_properties;
///
/// let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(Vec2::from);
/// let properties = mass_properties(&square);
/// assert_eq!((properties.area, properties.centroid), (4.0, Vec2::new(1.0, 1.0)));
/// ```
pub fn mass_properties(vertices: &[Vec2]) -> MassProperties {
    let Some(&origin) = vertices.first() else {
        return MassProperties { area: 0.0, centroid: Vec2::ZERO, second_moment: 0.0 };
    };
    let mut twice_area = 0.0;
    let mut first = Vec2::ZERO;
    for (a, b) in edges(vertices) {
        let (a, b) = (a - origin, b - origin);
        let cross = a.perp_dot(b);
        twice_area += cross;
        first += cross * (a + b);
    }
    let local = if twice_area == 0.0 {
        vertices.iter().map(|&v| v - origin).sum::<Vec2>() / vertices.len() as f64
    } else {
        first / (3.0 * twice_area)
    };
    // A second pass about the centroid: moving the moment by -A c^2 would cancel digits.
    let mut second = 0.0;
    for (a, b) in edges(vertices) {
        let (a, b) = (a - origin - local, b - origin - local);
        second += a.perp_dot(b) * (a.dot(a) + a.dot(b) + b.dot(b));
    }
    MassProperties {
        area: 0.5 * twice_area,
        centroid: origin + local,
        second_moment: second / 12.0,
    }
}

/// The edges `(from, to)`, the closing one last.
pub fn edges(vertices: &[Vec2]) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    let n = vertices.len();
    (0..n).map(move |i| (vertices[i], vertices[if i + 1 == n { 0 } else { i + 1 }]))
}

/// Signed area, positive anticlockwise, m2.
pub fn signed_area(vertices: &[Vec2]) -> f64 {
    let Some(&origin) = vertices.first() else {
        return 0.0;
    };
    0.5 * edges(vertices).map(|(a, b)| (a - origin).perp_dot(b - origin)).sum::<f64>()
}

/// Centroid of the area.
pub fn centroid(vertices: &[Vec2]) -> Vec2 {
    mass_properties(vertices).centroid
}

/// Sign of the turn a -> b -> c, decided exactly: positive to the left.
pub fn turn(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    let coord = |p: Vec2| robust::Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}

/// What `normalise` changed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Changes {
    /// Vertices dropped because they repeat the one before.
    pub repeated: usize,
    /// Vertices dropped because they lie on a straight edge.
    pub collinear: usize,
    /// The outline ran clockwise and was turned round.
    pub reversed: bool,
}

/// What to do with vertices on a straight edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Collinear {
    /// Leave them.
    Keep,
    /// Drop those within `tol::COLLINEAR` of the line through their neighbours.
    Drop,
}

/// Clean outline, anticlockwise, starting at the first vertex that is kept; does not validate.
///
/// Vertices within `tol::DRAWN` of the size from the one before are dropped. A spike (the outline running
/// back on itself) is not a straight edge and stays, for `validate` to find.
pub fn normalise(vertices: &[Vec2], collinear: Collinear) -> (Vec<Vec2>, Changes) {
    let size = Aabb::of(vertices).size();
    if !size.is_finite() {
        // Nothing can be compared; `validate` names the coordinate.
        return (vertices.to_vec(), Changes::default());
    }
    let same = tol::DRAWN * size;
    let mut changes = Changes::default();
    let mut out: Vec<Vec2> = Vec::with_capacity(vertices.len());
    for &v in vertices {
        if out.last().is_some_and(|&w| w.distance(v) <= same) {
            changes.repeated += 1;
        } else {
            out.push(v);
        }
    }
    while out.len() > 1 && out[0].distance(out[out.len() - 1]) <= same {
        out.pop();
        changes.repeated += 1;
    }
    if collinear == Collinear::Drop {
        let before = out.len();
        out = drop_collinear(&out, tol::COLLINEAR * size);
        changes.collinear = before - out.len();
    }
    if signed_area(&out) < 0.0 {
        // The first vertex stays first.
        out[1..].reverse();
        changes.reversed = true;
    }
    (out, changes)
}

/// The outline without the vertices that lie within `distance` of the line through their neighbours
/// and between them. Never returns fewer than three vertices of an outline that had three.
pub fn drop_collinear(vertices: &[Vec2], distance: f64) -> Vec<Vec2> {
    let n = vertices.len();
    let mut kept: Vec<Vec2> = Vec::with_capacity(n);
    for (i, &v) in vertices.iter().enumerate() {
        let before = kept.last().copied().unwrap_or(vertices[n - 1]);
        let after = if i + 1 < n { vertices[i + 1] } else { kept.first().copied().unwrap_or(v) };
        if n - i + kept.len() <= 3 || !between(before, v, after, distance) {
            kept.push(v);
        }
    }
    if kept.len() > 3 && between(kept[kept.len() - 1], kept[0], kept[1], distance) {
        kept.remove(0);
    }
    kept
}

fn between(a: Vec2, v: Vec2, b: Vec2, distance: f64) -> bool {
    let chord = b - a;
    let length = chord.length();
    length > 0.0
        && chord.perp_dot(v - a).abs() <= distance * length
        && (v - a).dot(chord) > 0.0
        && (b - v).dot(chord) > 0.0
}

/// Whether the outline is a simple polygon with area: finite, at least three vertices, no spike, no
/// two edges that meet elsewhere than at their common vertex. Orientation does not matter.
///
/// *Cost*: a sweep over edges sorted by x, at worst quadratic; hence the cap on vertices.
pub fn validate(vertices: &[Vec2]) -> Result<(), GeomError> {
    for (vertex, v) in vertices.iter().enumerate() {
        // 1e150 squared is still finite.
        if !(v.x.abs() < 1e150 && v.y.abs() < 1e150) {
            return Err(GeomError::NonFinite { vertex, x: v.x, y: v.y });
        }
    }
    let n = vertices.len();
    if n < 3 {
        return Err(GeomError::TooFewVertices { count: n });
    }
    if n > tol::MAX_VERTICES {
        return Err(GeomError::TooManyVertices { count: n, cap: tol::MAX_VERTICES });
    }
    let size = Aabb::of(vertices).size();
    let thin = || {
        let along = (1..n)
            .map(|i| vertices[i] - vertices[0])
            .fold(Vec2::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a });
        let width = vertices.iter().map(|&v| along.perp_dot(v - vertices[0]).abs());
        width.fold(0.0, f64::max) <= tol::ZERO_AREA * size * along.length()
    };
    if size == 0.0 || thin() {
        return Err(GeomError::ZeroArea { area: signed_area(vertices) });
    }
    for i in 0..n {
        let (a, v, b) = (vertices[(i + n - 1) % n], vertices[i], vertices[(i + 1) % n]);
        if turn(a, v, b) == 0.0 && (v - a).dot(b - v) <= 0.0 {
            return Err(GeomError::Spike { vertex: i, at: v });
        }
    }
    self_intersection(vertices).map_or(Ok(()), Err)
}

fn self_intersection(vertices: &[Vec2]) -> Option<GeomError> {
    let n = vertices.len();
    let edge = |i: usize| (vertices[i], vertices[(i + 1) % n]);
    let low = |i: usize| edge(i).0.x.min(edge(i).1.x);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| low(i).total_cmp(&low(j)));
    let mut active: Vec<usize> = Vec::new();
    let mut found: Option<(usize, usize)> = None;
    for &i in &order {
        let (a, b) = edge(i);
        active.retain(|&j| edge(j).0.x.max(edge(j).1.x) >= a.x.min(b.x));
        for &j in &active {
            let neighbours = (i + 1) % n == j || (j + 1) % n == i;
            let (c, d) = edge(j);
            if !neighbours && segments_meet(a, b, c, d) {
                let pair = (i.min(j), i.max(j));
                found = Some(found.map_or(pair, |f| f.min(pair)));
            }
        }
        // The first crossings met are reported; a tangle need not be searched to its end.
        if found.is_some() {
            break;
        }
        active.push(i);
    }
    found.map(|(edge_a, edge_b)| {
        let ((a, b), (c, d)) = (edge(edge_a), edge(edge_b));
        let cross = (b - a).perp_dot(d - c);
        let at = if cross == 0.0 {
            0.25 * (a + b + c + d)
        } else {
            a + (b - a) * ((c - a).perp_dot(d - c) / cross).clamp(0.0, 1.0)
        };
        GeomError::SelfIntersecting { edge_a, edge_b, at }
    })
}

/// Whether two closed segments have a point in common, decided exactly.
pub fn segments_meet(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> bool {
    let apart = |p: f64, q: f64, r: f64, s: f64| p.max(q) < r.min(s) || r.max(s) < p.min(q);
    if apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y) {
        return false;
    }
    let (abc, abd) = (turn(a, b, c), turn(a, b, d));
    if (abc > 0.0 && abd > 0.0) || (abc < 0.0 && abd < 0.0) {
        return false;
    }
    let (cda, cdb) = (turn(c, d, a), turn(c, d, b));
    !((cda > 0.0 && cdb > 0.0) || (cda < 0.0 && cdb < 0.0))
}

/// Whether an anticlockwise outline has no reflex corner.
pub fn is_convex(vertices: &[Vec2]) -> bool {
    let n = vertices.len();
    n >= 3 && (0..n).all(|i| turn(vertices[i], vertices[(i + 1) % n], vertices[(i + 2) % n]) >= 0.0)
}

/// Where a point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Inside.
    Inside,
    /// On an edge or vertex, exactly.
    Boundary,
    /// Outside.
    Outside,
}

/// Where `p` is with respect to a simple outline of either orientation, decided exactly.
pub fn locate(vertices: &[Vec2], p: Vec2) -> Side {
    let mut inside = false;
    for (a, b) in edges(vertices) {
        if (a.y > p.y) == (b.y > p.y) {
            // No proper crossing of the ray; only an edge along it can still hold the point.
            if a.y == p.y && b.y == p.y && a.x.min(b.x) <= p.x && p.x <= a.x.max(b.x) {
                return Side::Boundary;
            }
            if p == a || p == b {
                return Side::Boundary;
            }
            continue;
        }
        let side = turn(a, b, p);
        if side == 0.0 {
            return Side::Boundary;
        }
        if (side > 0.0) == (b.y > a.y) {
            inside = !inside;
        }
    }
    if inside { Side::Inside } else { Side::Outside }
}

/// Whether `p` is inside or on the boundary.
pub fn contains(vertices: &[Vec2], p: Vec2) -> bool {
    locate(vertices, p) != Side::Outside
}

/// Distance from `p` to the segment a-b.
pub fn distance_to_segment(p: Vec2, a: Vec2, b: Vec2) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    let t = if squared > 0.0 { ((p - a).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + t * along)
}

/// Distance from `p` to the boundary of the outline.
pub fn distance_to_boundary(vertices: &[Vec2], p: Vec2) -> f64 {
    edges(vertices).map(|(a, b)| distance_to_segment(p, a, b)).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
