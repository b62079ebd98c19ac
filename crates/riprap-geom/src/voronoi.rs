//! A region divided into Voronoi cells of random points.
//!
//! Points fill the box round the region, are spread by Lloyd's iteration there, and those inside the
//! region make the cells. The sides of the cells then cut the region like joints (`arrangement`), so
//! that concave regions work and neighbours share vertices bit for bit. Where a concave region
//! leaves a cell in several parts, each part is a block.

use crate::arrangement::{Cut, cut_region};
use crate::error::demand;
use crate::heal::{Blocks, collapse, heal};
use crate::polygon::{self, Aabb, Side};
use crate::random::Chance;
use crate::shapes::capped;
use crate::{GeomError, Vec2};

/// How to divide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cells {
    /// Side of the square with the mean area of a cell, m.
    pub cell_size: f64,
    /// Seed.
    pub seed: u64,
    /// Lloyd iterations: 0 leaves random cells, 10 makes them nearly equal. At most 1000.
    pub relax: usize,
    /// Shorter edges are shrunk to a point, and cells that stay too thin merged into a neighbour (0:
    /// none), m.
    pub smallest_edge: f64,
}

/// Divide a simple anticlockwise region.
///
/// *Errors*: as `cut::cut`.
/// # Examples
///
/// ```
/// use riprap_geom::Vec2;
/// use riprap_geom::polygon::signed_area;
/// use riprap_geom::voronoi::{Cells, voronoi};
///
/// let region = [[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [0.0, 5.0]].map(Vec2::from);
/// let cells = Cells { cell_size: 1.0, seed: 1, relax: 5, smallest_edge: 0.0 };
/// let blocks = voronoi(&region, &cells)?;
/// let area: f64 = blocks.polygons.iter().map(|cell| signed_area(cell)).sum();
/// assert!((area - 50.0).abs() < 1e-9);
/// # Ok::<(), riprap_geom::GeomError>(())
/// ```
pub fn voronoi(region: &[Vec2], cells: &Cells) -> Result<Blocks, GeomError> {
    polygon::validate(region)?;
    demand("cell_size", cells.cell_size, cells.cell_size > 0.0, "above 0")?;
    demand("relax", cells.relax as f64, cells.relax <= 1000, "at most 1000")?;
    demand("smallest_edge", cells.smallest_edge, cells.smallest_edge >= 0.0, "0 or more")?;
    let bounds = Aabb::of(region);
    let extent = bounds.max - bounds.min;
    let count = (extent.x / cells.cell_size) * (extent.y / cells.cell_size);
    capped("Voronoi cells", count)?;
    // Work relative to the box's middle, in which the coordinates are small.
    let origin = bounds.centre();
    let local = Aabb { min: bounds.min - origin, max: bounds.max - origin };
    let mut chance = Chance::new(cells.seed);
    let mut sites: Vec<Vec2> = (0..(count.round() as usize).max(1))
        .map(|_| {
            let x = chance.between(local.min.x, local.max.x);
            Vec2::new(x, chance.between(local.min.y, local.max.y))
        })
        .collect();
    for _ in 0..cells.relax {
        let grid = Grid::new(&sites, local, cells.cell_size);
        sites = (0..sites.len()).map(|i| polygon::centroid(&grid.cell(i).outline())).collect();
    }
    let inside: Vec<Vec2> = sites
        .iter()
        .copied()
        .filter(|&p| polygon::locate(region, p + origin) == Side::Inside)
        .collect();
    let grid = Grid::new(
        &inside,
        // So that sides of cells cross the outline and do not end on it.
        local.grown(cells.cell_size.min(0.1 * local.size())),
        cells.cell_size,
    );
    let mut cuts = Vec::new();
    for i in 0..inside.len() {
        let cell = grid.cell(i);
        for (k, &(from, neighbour)) in cell.corners.iter().enumerate() {
            // Each side once, from the cell with the lower number; those of the box are none.
            if neighbour > i && neighbour < usize::MAX {
                let to = cell.corners[(k + 1) % cell.corners.len()].0;
                cuts.push(Cut { from: from + origin, to: to + origin, family: None });
            }
        }
    }
    let mut parts = cut_region(region, &cuts)?;
    let collapsed = collapse(&mut parts, region.len(), cells.smallest_edge);
    let blocks = heal(parts, cells.smallest_edge);
    Ok(Blocks { collapsed, ..blocks })
}

/// A cell: corners, each with the site beyond the side that starts there (`usize::MAX`: the box).
struct Cell {
    corners: Vec<(Vec2, usize)>,
}

impl Cell {
    fn outline(&self) -> Vec<Vec2> {
        self.corners.iter().map(|c| c.0).collect()
    }

    /// Keep what is nearer to `site` than to `other`, number `j`.
    fn clip(&mut self, site: Vec2, other: Vec2, j: usize) {
        let middle = 0.5 * (site + other);
        let away = other - site;
        let height = |p: Vec2| (p - middle).dot(away);
        if self.corners.iter().all(|&(p, _)| height(p) <= 0.0) {
            return;
        }
        let n = self.corners.len();
        let mut kept = Vec::with_capacity(n + 1);
        for k in 0..n {
            let ((a, side), (b, _)) = (self.corners[k], self.corners[(k + 1) % n]);
            let (ha, hb) = (height(a), height(b));
            if ha <= 0.0 {
                kept.push((a, side));
            }
            if (ha <= 0.0) != (hb <= 0.0) {
                let p = a + (ha / (ha - hb)) * (b - a);
                // Leaving: the new side starts here. Entering: the old side goes on from here.
                kept.push((p, if ha <= 0.0 { j } else { side }));
            }
        }
        self.corners = kept;
    }
}

/// Sites in squares.
struct Grid<'a> {
    sites: &'a [Vec2],
    bounds: Aabb,
    side: f64,
    columns: i64,
    rows: i64,
    /// Sites of every square, row by row.
    squares: Vec<Vec<u32>>,
}

impl<'a> Grid<'a> {
    fn new(sites: &'a [Vec2], bounds: Aabb, cell_size: f64) -> Self {
        let extent = bounds.max - bounds.min;
        // About as many squares as sites, whatever the shape of the box and the cell size.
        let n = sites.len() as f64;
        let side = cell_size
            .max((extent.x * extent.y / (2.0 * n + 4.0)).sqrt())
            .max(extent.max_element() / (4.0 * n + 4.0));
        let number = |length: f64| ((length / side).ceil() as i64).max(1);
        let (columns, rows) = (number(extent.x), number(extent.y));
        let mut grid = Grid {
            sites,
            bounds,
            side,
            columns,
            rows,
            squares: vec![Vec::new(); (columns * rows) as usize],
        };
        for (i, &p) in sites.iter().enumerate() {
            let (cx, cy) = grid.square(p);
            grid.squares[(cy * columns + cx) as usize].push(i as u32);
        }
        grid
    }

    fn square(&self, p: Vec2) -> (i64, i64) {
        let at = (p - self.bounds.min) / self.side;
        ((at.x as i64).clamp(0, self.columns - 1), (at.y as i64).clamp(0, self.rows - 1))
    }

    fn cell(&self, i: usize) -> Cell {
        let site = self.sites[i];
        let corners = crate::shapes::rectangle(self.bounds.min, self.bounds.max - self.bounds.min);
        let mut cell = Cell { corners: corners.into_iter().map(|p| (p, usize::MAX)).collect() };
        let (cx, cy) = self.square(site);
        for ring in 0..=self.columns.max(self.rows) {
            let reach = cell.corners.iter().map(|c| c.0.distance(site)).fold(0.0, f64::max);
            // The line between two sites is half way: one farther than twice the farthest corner cuts nothing.
            if (ring - 1) as f64 * self.side > 2.0 * reach {
                break;
            }
            for y in (cy - ring).max(0)..=(cy + ring).min(self.rows - 1) {
                let whole_row = (y - cy).abs() == ring;
                let step = if whole_row { 1 } else { (2 * ring).max(1) };
                let mut x = cx - ring;
                while x <= cx + ring {
                    if (0..self.columns).contains(&x) {
                        for &j in &self.squares[(y * self.columns + x) as usize] {
                            let other = self.sites[j as usize];
                            if other != site {
                                cell.clip(site, other, j as usize);
                            }
                        }
                    }
                    x += step;
                }
            }
        }
        cell
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::rectangle;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    fn area(blocks: &Blocks) -> f64 {
        blocks.polygons.iter().map(|p| polygon::signed_area(p)).sum()
    }

    fn cells(cell_size: f64, seed: u64) -> Cells {
        Cells { cell_size, seed, relax: 2, smallest_edge: 0.0 }
    }

    #[test]
    fn inner_vertices_are_shared_to_the_bit() {
        let region = rectangle(Vec2::ZERO, Vec2::new(10.0, 10.0));
        let blocks = voronoi(&region, &cells(1.0, 7)).unwrap();
        assert_eq!(blocks.polygons.len(), 100);
        let mut uses: BTreeMap<[u64; 2], usize> = BTreeMap::new();
        for p in blocks.polygons.iter().flatten() {
            *uses.entry([p.x.to_bits(), p.y.to_bits()]).or_insert(0) += 1;
        }
        for (bits, count) in uses {
            let p = Vec2::new(f64::from_bits(bits[0]), f64::from_bits(bits[1]));
            let inner = polygon::distance_to_boundary(&region, p) > 1e-6;
            assert!(if inner { count == 3 } else { count <= 2 }, "{p} {count}");
        }
        assert!((area(&blocks) / 100.0 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn relaxing_makes_cells_equal() {
        let region = rectangle(Vec2::ZERO, Vec2::new(12.0, 8.0));
        let spread = |relax| {
            let blocks = voronoi(&region, &Cells { relax, ..cells(0.8, 2) }).unwrap();
            let mean = area(&blocks) / blocks.polygons.len() as f64;
            let square = |p: &Vec<Vec2>| (polygon::signed_area(p) / mean - 1.0).powi(2);
            blocks.polygons.iter().map(square).sum::<f64>() / blocks.polygons.len() as f64
        };
        assert!(spread(10) < 0.2 * spread(0), "{} {}", spread(10), spread(0));
    }

    #[test]
    fn short_edges_are_shrunk() {
        let region = rectangle(Vec2::ZERO, Vec2::new(12.0, 8.0));
        let what = Cells { smallest_edge: 0.08, ..cells(0.8, 2) };
        let blocks = voronoi(&region, &what).unwrap();
        let plain = voronoi(&region, &Cells { smallest_edge: 0.0, ..what }).unwrap();
        assert_eq!(blocks.polygons.len(), plain.polygons.len());
        assert!(
            blocks.collapsed > 5 && blocks.left.is_empty(),
            "{} {:?}",
            blocks.collapsed,
            blocks.left
        );
        assert!((area(&blocks) / 96.0 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn silly_numbers_are_errors_at_once() {
        let region = rectangle(Vec2::ZERO, Vec2::splat(1000.0));
        for size in [1e-12, 0.0, f64::NAN, -1.0, 1e-300] {
            assert!(voronoi(&region, &cells(size, 1)).is_err(), "{size}");
        }
        assert!(voronoi(&region, &Cells { relax: usize::MAX, ..cells(1.0, 1) }).is_err());
        assert_eq!(voronoi(&region, &cells(1e12, 1)).unwrap().polygons.len(), 1);
        let strip = rectangle(Vec2::ZERO, Vec2::new(1e6, 1e-3));
        assert!(voronoi(&strip, &cells(1e-1, 1)).is_ok());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn concave_regions_are_filled(
            seed in any::<u64>(),
            size in 0.5..4.0f64,
            smallest in 0.0..0.15f64,
            far in prop::sample::select(vec![0.0, 1e6]),
        ) {
            let region: Vec<Vec2> = [(0., 0.), (12., 0.), (12., 9.), (9., 9.), (8., 2.), (5., 2.5), (3., 10.), (0., 9.)]
                .map(|(x, y)| Vec2::new(x + far, y - far)).to_vec();
            let what = Cells { smallest_edge: smallest, ..cells(size, seed) };
            let blocks = voronoi(&region, &what).unwrap();
            prop_assert_eq!(&blocks, &voronoi(&region, &what).unwrap());
            let tolerance = if far > 0.0 { 1e-9 } else { 1e-12 };
            prop_assert!((area(&blocks) / polygon::signed_area(&region) - 1.0).abs() < tolerance);
            let boxes: Vec<Aabb> = blocks.polygons.iter().map(|b| Aabb::of(b)).collect();
            for b in &blocks.polygons {
                prop_assert_eq!(polygon::validate(b), Ok(()));
            }
            for (i, j) in crate::pairs::touching_boxes(&boxes, 1_000_000).unwrap() {
                let (a, b) = (&blocks.polygons[i as usize], &blocks.polygons[j as usize]);
                prop_assert!(crate::clip::overlap_depth(a, b).depth < 1e-8);
            }
        }
    }
}
