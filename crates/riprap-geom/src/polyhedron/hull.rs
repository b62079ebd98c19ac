//! Convex hull of points in space.
//!
//! Incremental, with the exact sign of the volume of four points, so that the triangles always make a closed surface;
//! then triangles in one plane (within `FLAT`) become one face. Quadratic: made for the corners of blocks.

use robust::{Coord3D, orient3d};

use super::{FLAT, MAX_VERTICES, Polyhedron, SolidError, ZERO_VOLUME, edges_of, flatten, frame};
use crate::{Vec2, Vec3};

/// The smallest convex solid that holds all points; points inside or in the middle of faces are dropped.
///
/// # Errors
/// Too few or too many points, a point that is no place, points in one plane.
pub fn hull(points: &[Vec3]) -> Result<Polyhedron, SolidError> {
    let count = points.len();
    if count < 4 {
        return Err(SolidError::TooFewVertices { count });
    }
    if count > MAX_VERTICES {
        return Err(SolidError::TooManyVertices { count });
    }
    if let Some(vertex) = points.iter().position(|p| !p.length_squared().is_finite()) {
        return Err(SolidError::NonFinite { vertex, at: points[vertex] });
    }
    let triangles = triangles(points)?;
    let solid = join(points, &triangles);
    if solid.validate().is_ok() {
        return Ok(solid);
    }
    // Corners about as far off their faces as what counts as flat: which of them make a face depends on the one that is asked
    // first, and such faces do not close. Triangles always do; contact takes those in one plane for one face.
    let solid = compact(points, triangles.iter().map(|t| t.to_vec()).collect());
    solid.validate()?;
    Ok(solid)
}

/// Six times the volume of the tetrahedron, with exact sign: positive when d lies on the side of the triangle
/// (a, b, c) from which it looks clockwise.
fn side(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> f64 {
    let coord = |p: Vec3| Coord3D { x: p.x, y: p.y, z: p.z };
    orient3d(coord(a), coord(b), coord(c), coord(d))
}

fn triangles(points: &[Vec3]) -> Result<Vec<[u32; 3]>, SolidError> {
    let first = start(points)?;
    let [a, b, c, d] = first;
    // `side` is positive for a point below the triangle: the first tetrahedron looks outward.
    let mut surface: Vec<[u32; 3]> = vec![[a, b, c], [a, c, d], [a, d, b], [b, d, c]];
    let at = |k: u32| points[k as usize];
    for p in 0..points.len() as u32 {
        if first.contains(&p) {
            continue;
        }
        let sees = |t: &[u32; 3]| side(at(t[0]), at(t[1]), at(t[2]), at(p)) < 0.0;
        let (seen, mut kept): (Vec<[u32; 3]>, Vec<[u32; 3]>) =
            surface.iter().partition(|t| sees(t));
        if seen.is_empty() {
            continue;
        }
        let mut rim: Vec<(u32, u32)> = seen.iter().flat_map(|t| edges_of(&t[..])).collect();
        let all = rim.clone();
        rim.retain(|&(from, to)| !all.contains(&(to, from)));
        kept.extend(rim.iter().map(|&(from, to)| [from, to, p]));
        surface = kept;
    }
    Ok(surface)
}

/// Four points that make a large tetrahedron, in the order in which `[a, b, c]` looks away from d.
fn start(points: &[Vec3]) -> Result<[u32; 4], SolidError> {
    let far = |measure: &dyn Fn(Vec3) -> f64| {
        let mut best = (0, f64::NEG_INFINITY);
        for (k, &p) in points.iter().enumerate() {
            let value = measure(p);
            if value > best.1 {
                best = (k, value);
            }
        }
        best.0
    };
    let a = far(&|p| -p.x);
    let b = far(&|p| p.distance_squared(points[a]));
    let along = points[b] - points[a];
    let c = far(&|p| (p - points[a]).cross(along).length_squared());
    let normal = along.cross(points[c] - points[a]);
    let d = far(&|p| (p - points[a]).dot(normal).abs());
    let volume = (points[d] - points[a]).dot(normal) / 6.0;
    let size = along.length();
    if volume.abs() <= ZERO_VOLUME * (size * size * size) {
        return Err(SolidError::ZeroVolume { volume });
    }
    let [mut x, mut y] = [a as u32, b as u32];
    if side(points[a], points[b], points[c], points[d]) < 0.0 {
        (x, y) = (y, x);
    }
    Ok([x, y, c as u32, d as u32])
}

/// Joins triangles of one plane and drops vertices that are no corners.
fn join(points: &[Vec3], triangles: &[[u32; 3]]) -> Polyhedron {
    let mut used: Vec<u32> = triangles.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let at = |k: u32| points[k as usize];
    let size = {
        let corners: Vec<Vec3> = used.iter().map(|&k| at(k)).collect();
        Polyhedron { vertices: corners, faces: Vec::new() }.size()
    };
    // Large triangles first: they know their plane best.
    let normal = |t: &[u32; 3]| (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    let mut order: Vec<&[u32; 3]> = triangles.iter().collect();
    order.sort_by(|a, b| normal(b).length_squared().total_cmp(&normal(a).length_squared()));
    let mut taken = vec![false; order.len()];
    let mut faces = Vec::new();
    for k in 0..order.len() {
        if taken[k] {
            continue;
        }
        let n = normal(order[k]).normalize_or_zero();
        let origin = at(order[k][0]);
        let near = |v: u32| n.dot(at(v) - origin).abs() <= 0.5 * FLAT * size;
        for (other, t) in order.iter().enumerate() {
            taken[other] |= t.iter().all(|&v| near(v));
        }
        taken[k] = true;
        let in_plane: Vec<u32> = used.iter().copied().filter(|&v| near(v)).collect();
        let [_, b, c] = frame(n);
        let corners: Vec<Vec3> = in_plane.iter().map(|&v| at(v)).collect();
        let ring = ring(&flatten(&corners, origin, b, c), FLAT * size);
        if ring.len() >= 3 {
            faces.push(ring.iter().map(|&r| in_plane[r]).collect::<Vec<u32>>());
        }
    }
    compact(points, faces)
}

/// Corners of the convex hull of points in a plane, anticlockwise (Andrew's chains); a point within `tolerance` of
/// the line through its neighbours is no corner.
fn ring(points: &[Vec2], tolerance: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let (p, q) = (points[a], points[b]);
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
    });
    // Whether the way from a over b to c turns left at b by more than the tolerance.
    let turns = |a: usize, b: usize, c: usize| {
        let along = points[c] - points[a];
        along.perp_dot(points[b] - points[a]) < -tolerance * along.length()
    };
    let mut chain: Vec<usize> = Vec::new();
    for pass in 0..2 {
        let base = chain.len();
        for &k in &order {
            while chain.len() >= base + 2
                && !turns(chain[chain.len() - 2], chain[chain.len() - 1], k)
            {
                chain.pop();
            }
            chain.push(k);
        }
        chain.pop();
        if pass == 0 {
            order.reverse();
        }
    }
    // The ends of the chains are the first and the last in x. Where a side is upright but for rounding, that can be a
    // point in its middle, which the chains do not look at.
    for end in [order[order.len() - 1], order[0]] {
        let count = chain.len();
        if let Some(k) = chain.iter().position(|&c| c == end)
            && count > 2
            && !turns(chain[(k + count - 1) % count], end, chain[(k + 1) % count])
        {
            chain.remove(k);
        }
    }
    chain
}

/// A solid with only the vertices that its faces use.
pub(super) fn compact(points: &[Vec3], mut faces: Vec<Vec<u32>>) -> Polyhedron {
    let mut used: Vec<u32> = faces.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    for v in faces.iter_mut().flatten() {
        // Every vertex of a face is in the list of used ones.
        *v = used.partition_point(|u| u < v) as u32;
    }
    Polyhedron { vertices: used.iter().map(|&v| points[v as usize]).collect(), faces }
}
