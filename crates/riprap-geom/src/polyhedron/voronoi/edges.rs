//! Cells without short edges: sites are moved until every edge is long enough.
//!
//! Putting the ends of a short edge together, as in the plane, would leave faces that are not flat. Moved sites give
//! Voronoi cells again, with flat faces that neighbours share. In each round every edge that is too short asks the sites whose
//! planes meet at its ends for the smallest motion that makes it long enough to first order (a step of the method of
//! Kaczmarz); the motions of all edges are added up and capped.

use std::collections::BTreeMap;

use super::Bins;
use crate::polyhedron::{Polyhedron, edges_of};
use crate::{GeomError, Mat3, Vec3};

/// Most rounds.
const ROUNDS: usize = 300;
/// A short edge is to become as long as this, times the shortest length that is accepted.
const BEYOND: f64 = 1.2;
/// A site moves by no more than this, times the mean spacing of sites, in a round.
const STRIDE: f64 = 0.05;
/// A vertex nearer than this, times the size of the solid, to a plane lies on it.
const ON_PLANE: f64 = 1e-9;
/// Planes whose normals span less than this share of a unit cube do not make a vertex.
const INDEPENDENT: f64 = 1e-9;

/// A plane of a cell `row . x = const`, halfway to another site or a face of the whole.
#[derive(Clone, Copy)]
struct Plane {
    /// Normal: unit, or to the other site, m.
    row: Vec3,
    offset: f64,
    site: Option<u32>,
}

/// How long an edge is and whose motion changes that.
struct Slope {
    length: f64,
    /// Change of the length with the place of each site.
    by_site: Vec<(u32, Vec3)>,
}

/// Cells of `whole` around `sites`, which are moved until no edge is shorter than `smallest` (m); edges of the whole itself do not count.
///
/// *Errors*: the number of edges that are still shorter after [`ROUNDS`] rounds, and the shortest of them.
pub(super) fn lengthened(
    whole: &Polyhedron,
    mut sites: Vec<Vec3>,
    smallest: f64,
) -> Result<Vec<Polyhedron>, GeomError> {
    let walls: Vec<(Vec3, f64)> = (0..whole.faces.len()).map(|f| whole.plane(f)).collect();
    let free = Vec3::from_array([0, 1, 2].map(|a| {
        // Sites of a plate stay in its middle.
        let flat = sites.iter().all(|s| s[a] == sites[0][a]);
        f64::from(u8::from(!flat || sites.len() == 1))
    }));
    let spacing = libm::cbrt(whole.moments().volume / sites.len() as f64);
    let mut last = (0, f64::INFINITY);
    for _ in 0..=ROUNDS {
        let bins = Bins::new(&sites, whole);
        let mut moves = vec![Vec3::ZERO; sites.len()];
        last = (0, f64::INFINITY);
        let mut cells = Vec::with_capacity(sites.len());
        for k in 0..sites.len() {
            let (cell, near) = bins.cell(&sites, k);
            let planes = planes(&sites, k, &near, &walls);
            for slope in short(&sites, &cell, &planes, k, smallest) {
                last = (last.0 + 1, last.1.min(slope.length));
                let by_site = slope.by_site.iter().map(|(site, g)| (*site, free * *g));
                let square: f64 = by_site.clone().map(|(_, g)| g.length_squared()).sum();
                for (site, g) in by_site.filter(|_| square > 0.0) {
                    moves[site as usize] += (BEYOND * smallest - slope.length) / square * g;
                }
            }
            cells.push(cell);
        }
        if last.0 == 0 {
            return Ok(cells);
        }
        for (site, by) in sites.iter_mut().zip(moves) {
            let to = *site + by.clamp_length_max(STRIDE * spacing);
            if walls.iter().all(|(n, d)| n.dot(to) < *d) {
                *site = to;
            }
        }
    }
    Err(GeomError::ShortEdges { count: last.0, shortest: last.1, wanted: smallest, rounds: ROUNDS })
}

/// The planes that can bound the cell of site `k`: halfway to the sites `near`, and the faces of the whole.
fn planes(sites: &[Vec3], k: usize, near: &[u32], walls: &[(Vec3, f64)]) -> Vec<Plane> {
    let site = sites[k];
    let halfway = near.iter().map(|&other| {
        let row = sites[other as usize] - site;
        Plane { row, offset: row.dot(0.5 * (site + sites[other as usize])), site: Some(other) }
    });
    let faces = walls.iter().map(|&(row, offset)| Plane { row, offset, site: None });
    halfway.chain(faces).collect()
}

/// The edges of a cell that are too short, each in the cell with the lowest number of those it belongs to.
fn short(
    sites: &[Vec3],
    cell: &Polyhedron,
    planes: &[Plane],
    own: usize,
    smallest: f64,
) -> Vec<Slope> {
    let near = ON_PLANE * cell.size();
    let on = |v: Vec3| -> Vec<usize> {
        let off = |p: &Plane| (p.row.dot(v) - p.offset).abs() / p.row.length();
        (0..planes.len()).filter(|k| off(&planes[*k]) <= near).collect()
    };
    let all = cell.faces.iter().flat_map(|f| edges_of(f));
    let ends = all
        .filter(|(a, b)| a < b)
        .map(|(a, b)| [cell.vertices[a as usize], cell.vertices[b as usize]]);
    let mut found = Vec::new();
    for [from, to] in ends.filter(|[from, to]| from.distance(*to) < smallest) {
        let at = [on(from), on(to)];
        let both: Vec<usize> = at[0].iter().filter(|k| at[1].contains(k)).copied().collect();
        let mut others = both.iter().filter_map(|k| planes[*k].site);
        if others.any(|other| (other as usize) < own) {
            continue;
        }
        if let Some(slope) = slope(sites, planes, own as u32, [from, to], &at, &both) {
            found.push(slope);
        }
    }
    found
}

/// How the length of the edge between two vertices changes with the sites; `None` for an edge of the whole, which no site moves.
fn slope(
    sites: &[Vec3],
    planes: &[Plane],
    own: u32,
    ends: [Vec3; 2],
    at: &[Vec<usize>; 2],
    both: &[usize],
) -> Option<Slope> {
    let of_whole = |k: &usize| planes[*k].site.is_none();
    if at.iter().flatten().all(of_whole) {
        return None;
    }
    let length = ends[0].distance(ends[1]);
    let along = (ends[1] - ends[0]) / length;
    let mut by_site: BTreeMap<u32, Vec3> = BTreeMap::new();
    for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
        let v = ends[side];
        // Where planes cannot be told apart the edge waits for others to move.
        let Some(three) = corner(planes, &at[side], both) else {
            by_site.clear();
            break;
        };
        // Of the vertex: rows . dv = (x_other - v) . dx_other - (x_own - v) . dx_own; a wall stays.
        let [a, b, c] = three.map(|k| planes[k].row);
        let weights = Mat3::from_cols(a, b, c).inverse() * (sign * along);
        for (k, weight) in three.into_iter().zip(weights.to_array()) {
            if let Some(other) = planes[k].site {
                *by_site.entry(other).or_default() += weight * (sites[other as usize] - v);
                *by_site.entry(own).or_default() -= weight * (sites[own as usize] - v);
            }
        }
    }
    let by_site = by_site.into_iter().collect();
    Some(Slope { length, by_site })
}

/// Three planes that make a vertex out of those that lie at it: two of the edge, and the one that is most across them.
fn corner(planes: &[Plane], at: &[usize], both: &[usize]) -> Option<[usize; 3]> {
    let [a, b] = *both.first_chunk::<2>()?;
    let unit = |k: usize| planes[k].row.normalize();
    let edge = unit(a).cross(unit(b));
    let across = |k: &usize| unit(*k).dot(edge).abs();
    let others = at.iter().copied().filter(|k| !both.contains(k));
    let third = others.max_by(|j, k| across(j).total_cmp(&across(k)))?;
    (across(&third) > INDEPENDENT).then_some([a, b, third])
}

#[cfg(test)]
mod tests {
    use super::super::{cells_within, random_sites, regular_prism};
    use super::*;

    fn shortest(cells: &[Polyhedron]) -> f64 {
        let edges = cells.iter().flat_map(|c| {
            let all = c.faces.iter().flat_map(|f| edges_of(f));
            all.map(|(a, b)| c.vertices[a as usize].distance(c.vertices[b as usize]))
        });
        edges.fold(f64::INFINITY, f64::min)
    }

    /// No edge is short, the cells are convex with flat faces and fill the solid.
    #[test]
    fn edges_are_as_long_as_asked_for() {
        for (seed, share) in [(1, 0.05), (2, 0.05), (3, 0.1), (4, 0.15)] {
            let (min, max) = (Vec3::splat(-1.0), Vec3::new(2.0, 1.0, 1.5));
            let whole = Polyhedron::brick(0.5 * (min + max), 0.5 * (max - min));
            let sites = random_sites(min, max, 0.4, seed);
            let before = cells_within(&whole, &sites, 10, 0.0).unwrap();
            let cells = cells_within(&whole, &sites, 10, share * 0.4).unwrap();
            assert_eq!(cells.len(), before.len());
            assert!(shortest(&before) < 0.01 * 0.4, "{}", shortest(&before));
            assert!(shortest(&cells) >= share * 0.4, "{}", shortest(&cells));
            assert!(cells.iter().all(|c| c.validate().is_ok()));
            let sum: f64 = cells.iter().map(|c| c.moments().volume).sum();
            assert!((sum / (max - min).element_product() - 1.0).abs() < 1e-12, "{sum}");
            shared(&cells, min, max);
        }
    }

    /// Every face inside has a partner with the same middle and the opposite area vector.
    fn shared(cells: &[Polyhedron], min: Vec3, max: Vec3) {
        let mut faces: Vec<(Vec3, Vec3)> = Vec::new();
        for cell in cells {
            for f in 0..cell.faces.len() {
                let outline = cell.outline(f);
                let middle = outline.iter().sum::<Vec3>() / outline.len() as f64;
                let inside = (middle - min).min_element().min((max - middle).min_element());
                if inside > 1e-9 {
                    faces.push((middle, cell.area_vector(f)));
                }
            }
        }
        for (middle, area) in &faces {
            let partner =
                |(m, a): &(Vec3, Vec3)| m.distance(*middle) < 1e-9 && (*a + *area).length() < 1e-9;
            assert!(faces.iter().any(partner), "{middle} {area}");
        }
    }

    /// A plate stays one of prisms, edges of a disk's own count for nothing.
    #[test]
    fn plates_and_disks() {
        let (min, max) = (Vec3::new(2.0, -1.0, 0.0), Vec3::new(4.0, 1.0, 0.1));
        let disk = regular_prism(min, max, 12).unwrap();
        let sites = random_sites(min, max, 0.25, 3);
        let cells = cells_within(&disk, &sites, 5, 0.025).unwrap();
        let flat = |z: f64| z.abs() < 1e-12 || (z - 0.1).abs() < 1e-12;
        assert!(cells.iter().flat_map(|c| &c.vertices).all(|v| flat(v.z)));
        assert!(shortest(&cells) >= 0.025);
    }

    #[test]
    fn too_much_is_told_with_its_numbers() {
        let (min, max) = (Vec3::ZERO, Vec3::splat(1.0));
        let whole = Polyhedron::brick(0.5 * max, 0.5 * max);
        let sites = random_sites(min, max, 0.34, 1);
        let error = cells_within(&whole, &sites, 2, 0.3).unwrap_err();
        assert!(matches!(error, GeomError::ShortEdges { count, .. } if count > 3), "{error}");
        assert!(cells_within(&whole, &sites, 2, f64::NAN).is_err());
    }
}
