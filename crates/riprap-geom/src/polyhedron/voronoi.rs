//! A box, or another convex solid, divided into Voronoi cells of random points.
//!
//! Each cell starts as the whole and is cut by the planes halfway to other sites, nearest first, until no site farther
//! away can reach it. Faces of neighbours lie in one plane to round-off and have the same corners to round-off.

mod convex;
mod edges;
mod graded;
mod grading;
mod near;

pub use graded::graded_cells;
pub use grading::{Charge, Finest, Grading};

use super::{Polyhedron, Sliced, slice};
use crate::error::demand;
use crate::random::Chance;
use crate::shapes::capped;
use crate::{GeomError, Vec3};

/// Cells of a box from `min` to `max` (m), about `cell_size` (m) wide; `relax` Lloyd iterations make them more equal.
///
/// *Errors*: a box without volume, a size that is not above 0, more than 1000 iterations, too many cells.
pub fn voronoi(
    min: Vec3,
    max: Vec3,
    cell_size: f64,
    seed: u64,
    relax: usize,
) -> Result<Vec<Polyhedron>, GeomError> {
    let half = half_extent(min, max)?;
    demand("cell_size", cell_size, cell_size > 0.0, "above 0")?;
    let count = 8.0 * half.element_product() / (cell_size * cell_size * cell_size);
    capped("Voronoi cells", count)?;
    let mut chance = Chance::new(seed);
    let sites = (0..(count.round() as usize).max(1))
        .map(|_| Vec3::from_array([0, 1, 2].map(|a| chance.between(-half[a], half[a]))))
        .collect();
    relaxed(&Polyhedron::brick(Vec3::ZERO, half), 0.5 * (min + max), sites, relax, 0.0)
}

/// Cells of a box from `min` to `max` (m) around given sites (m); those outside the box are left out. `relax` Lloyd
/// iterations make the cells more equal.
///
/// *Errors*: a box without volume, no site in it, more than 1000 iterations, too many cells.
pub fn cells_around(
    min: Vec3,
    max: Vec3,
    sites: &[Vec3],
    relax: usize,
) -> Result<Vec<Polyhedron>, GeomError> {
    let half = half_extent(min, max)?;
    let whole = Polyhedron::brick(0.5 * (min + max), half);
    cells_within(&whole, sites, relax, 0.0)
}

/// Cells of a convex solid around given sites (m); those outside are left out. `relax` Lloyd iterations make the cells
/// more equal; after them the sites are moved until no edge of a cell is shorter than `smallest_edge` (m; 0 moves none).
///
/// *Errors*: a solid without extent, no site in it, more than 1000 iterations, too many cells, edges that stay shorter.
pub fn cells_within(
    solid: &Polyhedron,
    sites: &[Vec3],
    relax: usize,
    smallest_edge: f64,
) -> Result<Vec<Polyhedron>, GeomError> {
    let (min, max) = solid.bounds();
    half_extent(min, max)?;
    capped("Voronoi cells", sites.len() as f64)?;
    let middle = 0.5 * (min + max);
    let mut whole = solid.clone();
    whole.vertices.iter_mut().for_each(|v| *v -= middle);
    let planes: Vec<(Vec3, f64)> = (0..whole.faces.len()).map(|f| whole.plane(f)).collect();
    let holds = |s: &Vec3| planes.iter().all(|(n, d)| n.dot(*s) < *d);
    let inside = sites.iter().map(|s| *s - middle);
    let sites: Vec<Vec3> = inside.filter(holds).collect();
    demand("the number of sites inside", sites.len() as f64, !sites.is_empty(), "above 0")?;
    demand("smallest_edge", smallest_edge, smallest_edge >= 0.0, "0 or more")?;
    relaxed(&whole, middle, sites, relax, smallest_edge)
}

/// A right prism about z that is as high as the box from `min` to `max` (m) and has `sides` equal sides, which touch the circle
/// within the shorter horizontal edge; one side is the face with the largest y. Many sides make a disk.
///
/// *Errors*: a box without volume, less than 3 sides or more than 1000.
pub fn regular_prism(min: Vec3, max: Vec3, sides: u32) -> Result<Polyhedron, GeomError> {
    let half = half_extent(min, max)?;
    let allowed = (3..=1000).contains(&sides);
    demand("sides", f64::from(sides), allowed, "3 to 1000")?;
    let (middle, step) = (0.5 * (min + max), 2.0 * std::f64::consts::PI / f64::from(sides));
    let corner = half.x.min(half.y) / libm::cos(0.5 * step);
    let vertices = [-half.z, half.z].into_iter().flat_map(|z| {
        (0..sides).map(move |k| {
            let angle = 0.5 * std::f64::consts::PI + (f64::from(k) - 0.5) * step;
            middle + Vec3::new(corner * libm::cos(angle), corner * libm::sin(angle), z)
        })
    });
    let mut faces = vec![(0..sides).rev().collect(), (sides..2 * sides).collect()];
    faces.extend((0..sides).map(|k| {
        let next = (k + 1) % sides;
        vec![k, next, sides + next, sides + k]
    }));
    Ok(Polyhedron { vertices: vertices.collect(), faces })
}

/// Half the edges of a box, m.
fn half_extent(min: Vec3, max: Vec3) -> Result<Vec3, GeomError> {
    let shortest = (max - min).min_element();
    demand("the shortest edge of the box", shortest, shortest > 0.0, "above 0")?;
    Ok(0.5 * (max - min))
}

/// Cells of a solid around sites, both given from `middle`, where coordinates are small.
fn relaxed(
    whole: &Polyhedron,
    middle: Vec3,
    mut sites: Vec<Vec3>,
    relax: usize,
    smallest_edge: f64,
) -> Result<Vec<Polyhedron>, GeomError> {
    demand("relax", relax as f64, relax <= 1000, "at most 1000")?;
    for _ in 0..relax {
        let cells = cells(&sites, whole);
        sites = cells.iter().map(|c| c.moments().centroid).collect();
    }
    let mut cells = match smallest_edge > 0.0 {
        true => edges::lengthened(whole, sites, smallest_edge)?,
        false => cells(&sites, whole),
    };
    for vertex in cells.iter_mut().flat_map(|c| &mut c.vertices) {
        *vertex += middle;
    }
    Ok(cells)
}

/// Random sites in a box (m), one in each `cell`³ (m³) on average. Along an edge of the box that is shorter than 1.5 cells they lie
/// in the middle, so that the cells of a plate are prisms.
#[must_use]
pub fn random_sites(min: Vec3, max: Vec3, cell: f64, seed: u64) -> Vec<Vec3> {
    let (extent, middle) = (max - min, 0.5 * (min + max));
    let flat = [0, 1, 2].map(|a: usize| extent[a] < 1.5 * cell);
    let count: f64 = (0..3).filter(|a| !flat[*a]).map(|a| extent[a] / cell).product();
    let mut chance = Chance::new(seed);
    (0..(count.round() as usize).max(1))
        .map(|_| {
            Vec3::from_array([0, 1, 2].map(|a| {
                let at = chance.between(min[a], max[a]);
                if flat[a] { middle[a] } else { at }
            }))
        })
        .collect()
}

/// Sites of a square lattice in a box (m): edge `cell` (m), one site at `origin` (m), rows turned by `angle` (rad) about z;
/// whole layers along z.
#[must_use]
pub fn lattice_sites(min: Vec3, max: Vec3, cell: f64, origin: Vec3, angle: f64) -> Vec<Vec3> {
    let (extent, middle) = (max - min, 0.5 * (min + max));
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    // The site of the lattice that lies nearest to the middle.
    let away = middle - origin;
    let steps = [cosine * away.x + sine * away.y, cosine * away.y - sine * away.x];
    let [a, b] = steps.map(|s| (s / cell).round() * cell);
    let origin = origin + Vec3::new(cosine * a - sine * b, sine * a + cosine * b, 0.0);
    // Half the diagonal: turned rows reach into the corners.
    let reach = (0.5 * extent.truncate().length() / cell).ceil() + 1.0;
    let layers = (extent.z / cell).round().max(1.0);
    let mut sites = Vec::new();
    for k in 0..layers as usize {
        let z = min.z + (k as f64 + 0.5) * extent.z / layers;
        for j in -(reach as i64)..=reach as i64 {
            for i in -(reach as i64)..=reach as i64 {
                let (a, b) = (i as f64 * cell, j as f64 * cell);
                let at = Vec3::new(
                    origin.x + cosine * a - sine * b,
                    origin.y + sine * a + cosine * b,
                    z,
                );
                if at.cmpgt(min).all() && at.cmplt(max).all() {
                    sites.push(at);
                }
            }
        }
    }
    sites
}

/// The cell of each site.
fn cells(sites: &[Vec3], whole: &Polyhedron) -> Vec<Polyhedron> {
    let bins = Bins::new(sites, whole);
    (0..sites.len()).map(|k| bins.cell(sites, k).0).collect()
}

/// Sites in a grid of boxes, about one in each.
struct Bins<'a> {
    whole: &'a Polyhedron,
    half: Vec3,
    count: [i64; 3],
    size: Vec3,
    lists: Vec<Vec<u32>>,
}

impl<'a> Bins<'a> {
    fn new(sites: &[Vec3], whole: &'a Polyhedron) -> Self {
        let half = whole.bounds().1;
        let edge = libm::cbrt(8.0 * half.element_product() / sites.len() as f64);
        let count = [0, 1, 2].map(|a| ((2.0 * half[a] / edge).floor() as i64).clamp(1, 1024));
        let size = Vec3::from_array([0, 1, 2].map(|a| 2.0 * half[a] / count[a] as f64));
        let mut bins = Self {
            whole,
            half,
            count,
            size,
            lists: vec![Vec::new(); (count[0] * count[1] * count[2]) as usize],
        };
        for (k, &site) in sites.iter().enumerate() {
            let at = bins.index(bins.place(site));
            bins.lists[at].push(k as u32);
        }
        bins
    }

    fn place(&self, p: Vec3) -> [i64; 3] {
        [0, 1, 2].map(|a| {
            let at = (p[a] + self.half[a]) / self.size[a];
            (at as i64).clamp(0, self.count[a] - 1)
        })
    }

    fn index(&self, at: [i64; 3]) -> usize {
        ((at[2] * self.count[1] + at[1]) * self.count[0] + at[0]) as usize
    }

    /// Sites in the shell of boxes `ring` away from a box.
    fn shell(&self, centre: [i64; 3], ring: i64, out: &mut Vec<u32>) {
        let range =
            |a: usize| (centre[a] - ring).max(0)..=(centre[a] + ring).min(self.count[a] - 1);
        for z in range(2) {
            for y in range(1) {
                for x in range(0) {
                    let at = [x, y, z];
                    if (0..3).any(|a| (at[a] - centre[a]).abs() == ring) {
                        out.extend(&self.lists[self.index(at)]);
                    }
                }
            }
        }
    }

    /// The cell of a site, and the sites whose planes have cut it.
    fn cell(&self, sites: &[Vec3], k: usize) -> (Polyhedron, Vec<u32>) {
        let mut cutters = Vec::new();
        let site = sites[k];
        let mut cell = self.whole.clone();
        let (home, mut near) = (self.place(site), Vec::new());
        let last = self.count.into_iter().max().unwrap_or(1);
        for ring in 0..=last {
            // The plane between two sites is half way: one farther than twice the farthest corner cuts nothing.
            let distances = cell.vertices.iter().map(|v| v.distance(site));
            let reach = distances.fold(0.0, f64::max);
            // Sites of this shell and beyond are at least this far away.
            if (ring - 1) as f64 * self.size.min_element() > 2.0 * reach {
                break;
            }
            near.clear();
            self.shell(home, ring, &mut near);
            // The nearest first, which leave little to the others; equal ones by number, for the same bits.
            near.sort_by(|&a, &b| {
                let far = |s: u32| sites[s as usize].distance_squared(site);
                far(a).total_cmp(&far(b)).then(a.cmp(&b))
            });
            for &other in &near {
                let away = sites[other as usize] - site;
                let length = away.length();
                if length == 0.0 {
                    continue;
                }
                let normal = away / length;
                let offset = normal.dot(0.5 * (site + sites[other as usize]));
                match slice(&cell, normal, offset) {
                    Sliced::Part(part) => {
                        cell = part;
                        cutters.push(other);
                    }
                    Sliced::Whole | Sliced::Nothing => {}
                }
            }
        }
        (cell, cutters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        /// Cells are solids, fill the box, hold their sites' share of space, and repeat with the seed.
        #[test]
        fn cells_fill_the_box(
            seed in any::<u64>(),
            edges in prop::array::uniform3(1.0..4.0f64),
            far in prop::sample::select(vec![0.0, 1e5]),
            relax in 0usize..3,
        ) {
            let min = Vec3::splat(far);
            let max = min + Vec3::from_array(edges);
            let cells = voronoi(min, max, 0.8, seed, relax).unwrap();
            prop_assert_eq!(&cells, &voronoi(min, max, 0.8, seed, relax).unwrap());
            let whole = (max - min).element_product();
            let mut sum = 0.0;
            for cell in &cells {
                prop_assert_eq!(cell.validate(), Ok(()));
                let (low, high) = cell.bounds();
                prop_assert!((low - min).min_element() > -1e-9 && (max - high).min_element() > -1e-9);
                sum += cell.moments().volume;
            }
            prop_assert!((sum / whole - 1.0).abs() < 1e-9, "{} {}", sum, whole);
        }
    }

    /// A turned square lattice gives squares of its edge wherever the box does not end them, and fills the box; a plate
    /// gets prisms.
    #[test]
    fn lattices_and_plates() {
        let (min, max) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(3.0, 1.0, 0.1));
        for angle in [0.0, 0.3, 0.7] {
            let sites = lattice_sites(min, max, 0.1, Vec3::new(1.93, 0.41, 0.0), angle);
            let cells = cells_around(min, max, &sites, 0).unwrap();
            assert_eq!(cells.len(), sites.len());
            let volumes: Vec<f64> = cells.iter().map(|c| c.moments().volume).collect();
            let whole = volumes.iter().filter(|v| (**v - 1e-3).abs() < 1e-12).count();
            assert!(whole > 100, "{whole}");
            assert!((volumes.iter().sum::<f64>() - 0.2).abs() < 1e-12);
            assert!(cells.iter().all(|c| c.validate().is_ok()));
        }
        let sites = random_sites(min, max, 0.1, 3);
        assert_eq!(sites.len(), 200);
        for cell in cells_around(min, max, &sites, 5).unwrap() {
            let flat = |z: f64| z.abs() < 1e-9 || (z - 0.1).abs() < 1e-9;
            assert!(cell.vertices.iter().all(|v| flat(v.z)));
        }
        assert!(cells_around(min, max, &[Vec3::ZERO], 0).is_err());
    }

    /// Cells of a disk fill it and end at its sides.
    #[test]
    fn cells_of_a_disk() {
        let (min, max) = (Vec3::new(2.0, -1.0, 0.0), Vec3::new(4.0, 1.0, 0.6));
        let disk = regular_prism(min, max, 36).unwrap();
        assert_eq!(disk.validate(), Ok(()));
        let area = 36.0 * libm::tan(std::f64::consts::PI / 36.0);
        assert!((disk.moments().volume - 0.6 * area).abs() < 1e-12);
        let sites = random_sites(min, max, 0.25, 3);
        let cells = cells_within(&disk, &sites, 5, 0.0).unwrap();
        assert!(cells.iter().all(|c| c.validate().is_ok()));
        let sum: f64 = cells.iter().map(|c| c.moments().volume).sum();
        assert!((sum - 0.6 * area).abs() < 1e-9, "{sum}");
        let top = cells.iter().map(|c| c.bounds().1.y).fold(0.0, f64::max);
        assert!((top - 1.0).abs() < 1e-9);
        assert!(regular_prism(min, max, 2).is_err());
        assert!(regular_prism(min, Vec3::splat(f64::NAN), 36).is_err());
    }

    #[test]
    fn neighbours_share_their_faces() {
        let cells = voronoi(Vec3::ZERO, Vec3::splat(3.0), 1.0, 5, 3).unwrap();
        assert_eq!(cells.len(), 27);
        // Every inner face has a partner with the same middle and the opposite area vector.
        let mut faces: Vec<(Vec3, Vec3)> = Vec::new();
        for cell in &cells {
            for f in 0..cell.faces.len() {
                let outline = cell.outline(f);
                let middle = outline.iter().sum::<Vec3>() / outline.len() as f64;
                let edge = middle.min_element().min(3.0 - middle.max_element());
                if edge > 1e-9 {
                    faces.push((middle, cell.area_vector(f)));
                }
            }
        }
        for (middle, area) in &faces {
            let partner = faces
                .iter()
                .any(|(m, a)| m.distance(*middle) < 1e-6 && (*a + *area).length() < 1e-6);
            assert!(partner || area.length() < 1e-6, "{middle} {area}");
        }
    }

    #[test]
    fn silly_numbers_are_errors_at_once() {
        for size in [0.0, -1.0, f64::NAN, 1e-6] {
            assert!(voronoi(Vec3::ZERO, Vec3::ONE, size, 1, 0).is_err(), "{size}");
        }
        assert!(voronoi(Vec3::ZERO, Vec3::new(1.0, 0.0, 1.0), 0.5, 1, 0).is_err());
        assert_eq!(voronoi(Vec3::ZERO, Vec3::ONE, 50.0, 1, 0).unwrap().len(), 1);
    }
}
