//! Random cells whose size grows with the distance from places, with room for charges.
//!
//! ```text
//! sites as dense as cells are small, those of charges fixed --> relax --> fit rooms to charges --> lengthen edges --> cells
//! ```
//!
//! Relaxing moves a site to the centroid of its cell under a density `size^-5`, with which Lloyd's iteration keeps the sizes; to first
//! order that centroid is off that of the volume by `-5 C grad(size)/size`, C being the covariance of the cell.

use std::collections::BTreeMap;

use super::convex::{Cell, Plane, Whole};
use super::grading::{Charge, Grading};
use super::near::{Search, Tree};
use crate::error::demand;
use crate::polyhedron::{Polyhedron, Sliced, slice};
use crate::shapes::capped;
use crate::{GeomError, Mat3, Vec3};

/// Most rounds of moving sites for longer edges.
const ROUNDS: usize = 300;
/// A short edge is to become as long as this, times the shortest length that is accepted.
const EXTRA: f64 = 1.2;
/// A site moves by no more than this, times the edge of cells there, in a round.
const STRIDE: f64 = 0.05;
/// The weighted centroid is off that of the volume by no more than this, times the edge of cells there.
const OFF: f64 = 0.25;
/// The volume of a room is that of its charge to this share, or the best of so many tries.
const FITS: f64 = 1e-12;
const TRIES: usize = 20;

/// Random cells of a convex solid whose corners are on three faces each; `smallest_edge` (m) is that of the finest cells and grows with
/// them. Each charge gets room of its volume: the cells that its axis touches.
///
/// *Errors*: sizes that are not above 0 or shrink, more than 1000 iterations, too many cells, edges that stay shorter.
pub fn graded_cells(
    solid: &Polyhedron,
    grading: &Grading,
    charges: &[Charge],
    seed: u64,
    relax: usize,
    smallest_edge: f64,
) -> Result<Vec<Polyhedron>, GeomError> {
    let (min, max) = solid.bounds();
    super::half_extent(min, max)?;
    demand("the finest size", grading.from, grading.from > 0.0, "above 0")?;
    demand("the largest size", grading.to, grading.to >= grading.from, "at least the finest")?;
    demand("the distance", grading.over, grading.over > 0.0, "above 0")?;
    demand("relax", relax as f64, relax <= 1000, "at most 1000")?;
    demand("smallest_edge", smallest_edge, smallest_edge >= 0.0, "0 or more")?;
    let most = 2.0 * crate::tol::MAX_BLOCKS as f64;
    capped("Voronoi cells", grading.count(min, max, most))?;
    let whole = Whole::new(solid);
    let faces = solid.faces.len() as f64;
    demand("faces of the solid", faces, whole.is_some(), "three at each corner")?;
    let Some(whole) = whole else { return Ok(Vec::new()) };
    let mut work = Work::new(whole, grading, charges, seed, (min, max));
    let inside = work.sites.len() as f64;
    demand("the number of sites inside", inside, inside > 0.0, "above 0")?;
    for _ in 0..relax {
        work.relax();
    }
    work.fit(charges);
    if smallest_edge > 0.0 {
        work.lengthen(smallest_edge)?;
        work.fit(charges);
    }
    Ok(work.solids(solid))
}

/// Sites on their way to their places.
struct Work<'a> {
    whole: Whole,
    grading: &'a Grading,
    sites: Vec<Vec3>,
    /// Sites before this one belong to charges and stay.
    fixed: usize,
    /// Of each charge: its width, the sites of its room, and those around it.
    rooms: Vec<(f64, std::ops::Range<usize>)>,
    /// Along which axes sites move: those of a plate stay in its middle.
    free: Vec3,
    search: Search,
    removed: Vec<[u16; 3]>,
}

impl<'a> Work<'a> {
    fn new(
        whole: Whole,
        grading: &'a Grading,
        charges: &[Charge],
        seed: u64,
        (min, max): (Vec3, Vec3),
    ) -> Self {
        let mut rooms = Vec::with_capacity(charges.len());
        let mut sites: Vec<Vec3> = Vec::new();
        for charge in charges {
            let first = sites.len();
            let [own, walls] = charge.room(charge.width(), grading.from);
            sites.extend(own);
            rooms.push((charge.width(), first..sites.len()));
            sites.extend(walls.into_iter().filter(|site| whole.holds(*site)));
        }
        let fixed = sites.len();
        let random = grading.sites(min, max, charges, seed);
        sites.extend(random.into_iter().filter(|site| whole.holds(*site)));
        let free = Vec3::from_array([0, 1, 2].map(|a: usize| {
            let flat = sites.len() > 1 && sites.iter().all(|s| s[a] == sites[0][a]);
            f64::from(u8::from(!flat))
        }));
        let (search, removed) = (Search::default(), Vec::new());
        Self { whole, grading, sites, fixed, rooms, free, search, removed }
    }

    fn tree(&self) -> Tree {
        Tree::new(&self.sites, 0..self.sites.len() as u32)
    }

    /// The cell of a site.
    fn cell(&mut self, tree: &Tree, k: usize, cell: &mut Cell) {
        let site = self.sites[k];
        cell.start(&self.whole, site);
        let (sites, removed) = (&self.sites, &mut self.removed);
        tree.by_distance(site, &mut self.search, |other, square| {
            // The plane between two sites is half way.
            if square > 4.0 * cell.reach {
                return false;
            }
            if square > 0.0 {
                let normal = sites[other as usize] - site;
                cell.cut(Plane { normal, offset: 0.5 * square, site: Some(other) }, removed);
            }
            true
        });
    }

    /// One iteration towards equal cells.
    fn relax(&mut self) {
        let (tree, mut cell) = (self.tree(), Cell::default());
        let mut to = self.sites.clone();
        for (k, to) in to.iter_mut().enumerate().skip(self.fixed) {
            self.cell(&tree, k, &mut cell);
            let spread = cell.spread();
            let at = self.sites[k] + spread.centroid;
            let (size, slope) = self.grading.size_and_slope(at);
            let off = spread.second * (-5.0 / (size * spread.volume) * slope);
            let moved = at + self.free * off.clamp_length_max(OFF * size);
            *to = if self.whole.holds(moved) { moved } else { at };
        }
        self.sites = to;
    }

    /// Moves the walls of rooms until each has the volume of its charge.
    fn fit(&mut self, charges: &[Charge]) {
        let mut cell = Cell::default();
        for _ in 0..TRIES {
            let tree = self.tree();
            let mut worst: f64 = 0.0;
            for (number, charge) in charges.iter().enumerate() {
                let (width, own) = self.rooms[number].clone();
                let mut volume = 0.0;
                for k in own.clone() {
                    self.cell(&tree, k, &mut cell);
                    volume += cell.spread().volume;
                }
                let ratio = volume / charge.volume;
                worst = worst.max((ratio - 1.0).abs());
                let new = width * libm::pow(ratio, -1.0 / charge.power());
                let [_, walls] = charge.room(new, self.grading.from);
                let end = self.rooms.get(number + 1).map_or(self.fixed, |(_, next)| next.start);
                // As many sides as before: their number follows the width.
                let same = own.end + walls.iter().filter(|w| self.whole.holds(**w)).count() == end;
                if new.is_finite() && same {
                    self.rooms[number].0 = new;
                    let inside = walls.into_iter().filter(|w| self.whole.holds(*w));
                    self.sites.splice(own.end..end, inside);
                }
            }
            if worst <= FITS {
                break;
            }
        }
    }

    /// Moves sites until no edge is shorter than `smallest` (m) times the size of cells there over the finest. In each round every edge
    /// that is too short asks the sites whose planes meet at its ends for the smallest motion that makes it long enough to
    /// first order, as for cells of one size; here only cells near sites that moved are made again.
    fn lengthen(&mut self, smallest: f64) -> Result<(), GeomError> {
        let count = self.sites.len();
        let mut cells = vec![Cell::default(); count];
        let mut asks: Vec<Vec<Short>> = vec![Vec::new(); count];
        let mut stale = vec![true; count];
        let mut last = (0, f64::INFINITY);
        for _ in 0..=ROUNDS {
            let tree = self.tree();
            for k in (0..count).filter(|k| stale[*k]) {
                self.cell(&tree, k, &mut cells[k]);
                let wanted = smallest * self.grading.size(self.sites[k]) / self.grading.from;
                asks[k] = self.short(&cells[k], k, wanted);
            }
            let short = || asks.iter().flatten();
            last = (short().count(), short().fold(f64::INFINITY, |least, s| least.min(s.length)));
            if last.0 == 0 {
                return Ok(());
            }
            let mut moves = vec![Vec3::ZERO; count];
            for Short { length, wanted, by_site } in short() {
                let square: f64 = by_site.iter().map(|(_, g)| g.length_squared()).sum();
                for (site, g) in by_site {
                    moves[*site as usize] += (EXTRA * wanted - length) / square * *g;
                }
            }
            let moved = self.shift(&moves);
            self.mark(&mut stale, &cells, &moved);
        }
        Err(GeomError::ShortEdges {
            count: last.0,
            shortest: last.1,
            wanted: smallest,
            rounds: ROUNDS,
        })
    }

    /// Moves sites within the solid; which have moved.
    fn shift(&mut self, moves: &[Vec3]) -> Vec<bool> {
        let mut moved = vec![false; moves.len()];
        for (k, by) in moves.iter().enumerate().filter(|(_, by)| **by != Vec3::ZERO) {
            let stride = STRIDE * self.grading.size(self.sites[k]);
            let to = self.sites[k] + by.clamp_length_max(stride);
            if self.whole.holds(to) {
                self.sites[k] = to;
                moved[k] = true;
            }
        }
        moved
    }

    /// Marks cells that sites which moved bound, or can bound now.
    fn mark(&mut self, stale: &mut [bool], cells: &[Cell], moved: &[bool]) {
        let numbers = (0u32..).zip(moved).filter(|(_, moved)| **moved).map(|(k, _)| k);
        let tree = Tree::new(&self.sites, numbers);
        for (k, stale) in stale.iter_mut().enumerate() {
            let cell = &cells[k];
            let bounds = |plane: &Plane| plane.site.is_some_and(|site| moved[site as usize]);
            *stale = moved[k] || cell.planes.iter().any(bounds);
            if !*stale {
                tree.by_distance(self.sites[k], &mut self.search, |_, square| {
                    *stale = square <= 4.0 * cell.reach;
                    false
                });
            }
        }
    }

    /// The edges of a cell that are too short and that a site can change, each in the cell with the lowest number of those it belongs to.
    fn short(&self, cell: &Cell, own: usize, wanted: f64) -> Vec<Short> {
        let mut found = Vec::new();
        for (face, beside, from, to) in cell.edges() {
            let [a, b] = [from, to].map(|k| cell.corners[k]);
            let length = a.at.distance(b.at);
            if from > to || length >= wanted {
                continue;
            }
            let plane = |p: u16| cell.planes[usize::from(p)];
            let lower = |p: u16| plane(p).site.is_some_and(|other| (other as usize) < own);
            if lower(face) || lower(beside) {
                continue;
            }
            // In the face, anticlockwise.
            let along = plane(face).normal.cross(plane(beside).normal).normalize_or_zero();
            let by_site =
                self.slope(cell, own, [(a, -along), (b, along)].map(|(c, s)| (c.planes, c.at, s)));
            if by_site.iter().any(|(_, g)| *g != Vec3::ZERO) {
                found.push(Short { length, wanted, by_site });
            }
        }
        found
    }

    /// How the length of an edge changes with the sites that are free to move.
    fn slope(
        &self,
        cell: &Cell,
        own: usize,
        ends: [([u16; 3], Vec3, Vec3); 2],
    ) -> Vec<(u32, Vec3)> {
        let mut by_site: BTreeMap<u32, Vec3> = BTreeMap::new();
        for (planes, at, along) in ends {
            let planes = planes.map(|p| cell.planes[usize::from(p)]);
            let [a, b, c] = planes.map(|plane| plane.normal);
            // Of the corner: rows . dv = (x_other - v) . dx_other - (x_own - v) . dx_own; a face of the whole stays.
            let weights = Mat3::from_cols(a, b, c).inverse() * along;
            if !weights.is_finite() {
                return Vec::new();
            }
            for (plane, weight) in planes.iter().zip(weights.to_array()) {
                if let Some(other) = plane.site {
                    *by_site.entry(other).or_default() += weight * (plane.normal - at);
                    *by_site.entry(own as u32).or_default() += weight * at;
                }
            }
        }
        by_site.retain(|site, _| *site as usize >= self.fixed);
        by_site.into_iter().map(|(site, g)| (site, self.free * g)).collect()
    }

    /// The cells as solids: those of neighbours share their corners to round-off.
    fn solids(&mut self, solid: &Polyhedron) -> Vec<Polyhedron> {
        let (tree, mut cell) = (self.tree(), Cell::default());
        let count = self.sites.len();
        let mut solids = Vec::with_capacity(count);
        for k in 0..count {
            self.cell(&tree, k, &mut cell);
            let mut used = vec![false; cell.planes.len()];
            for plane in cell.corners.iter().flat_map(|corner| corner.planes) {
                used[usize::from(plane)] = true;
            }
            let mut made = solid.clone();
            for (plane, _) in cell.planes.iter().zip(used).filter(|(_, used)| *used) {
                if plane.site.is_none() {
                    continue;
                }
                let length = plane.normal.length();
                let normal = plane.normal / length;
                let offset = normal.dot(self.sites[k]) + plane.offset / length;
                if let Sliced::Part(part) = slice(&made, normal, offset) {
                    made = part;
                }
            }
            solids.push(made);
        }
        solids
    }
}

/// An edge that is too short, and how its length changes with sites.
#[derive(Clone, Debug)]
struct Short {
    length: f64,
    wanted: f64,
    by_site: Vec<(u32, Vec3)>,
}

#[cfg(test)]
mod tests {
    use super::super::grading::Finest;
    use super::*;
    use crate::polyhedron::edges_of;

    fn graded() -> (Polyhedron, Grading) {
        let solid = Polyhedron::brick(Vec3::new(0.5, 0.0, 0.0), Vec3::new(2.0, 1.5, 1.0));
        let at = vec![Finest::Segment(Vec3::ZERO, Vec3::ZERO)];
        (solid, Grading { from: 0.1, to: 0.4, over: 1.0, at })
    }

    fn shortest(cell: &Polyhedron) -> f64 {
        let all = cell.faces.iter().flat_map(|f| edges_of(f));
        let lengths =
            all.map(|(a, b)| cell.vertices[a as usize].distance(cell.vertices[b as usize]));
        lengths.fold(f64::INFINITY, f64::min)
    }

    /// Cells fill the solid, are as large as asked for, have no short edges, and repeat.
    #[test]
    fn cells_grow_with_the_distance() {
        let (solid, grading) = graded();
        for seed in 1..4 {
            let cells = graded_cells(&solid, &grading, &[], seed, 5, 0.006).unwrap();
            assert_eq!(cells, graded_cells(&solid, &grading, &[], seed, 5, 0.006).unwrap());
            let mut sum = 0.0;
            let (mut fine, mut coarse) = (Vec::new(), Vec::new());
            for cell in &cells {
                assert_eq!(cell.validate(), Ok(()));
                let moments = cell.moments();
                sum += moments.volume;
                let size = grading.size(moments.centroid);
                assert!(shortest(cell) > 0.6 * 0.06 * size, "{} {size}", shortest(cell));
                let ratio = libm::cbrt(moments.volume) / size;
                if size < 0.2 { fine.push(ratio) } else { coarse.push(ratio) }
            }
            assert!((sum / 24.0 - 1.0).abs() < 1e-9, "{sum}");
            for ratios in [fine, coarse] {
                let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
                assert!(
                    ratios.len() > 25 && (0.9..1.15).contains(&mean),
                    "{mean} {}",
                    ratios.len()
                );
            }
        }
        let (min, max) = solid.bounds();
        let said = grading.count(min, max, 1e9);
        let made = graded_cells(&solid, &grading, &[], 1, 0, 0.0).unwrap().len() as f64;
        assert!((made / said - 1.0).abs() < 0.02, "{made} {said}");
    }

    /// The cells that a charge touches have its volume, whatever its shape.
    #[test]
    fn rooms_have_the_volume_of_their_charges() {
        let (solid, mut grading) = graded();
        let ball = Charge { from: Vec3::ZERO, to: Vec3::ZERO, volume: 1e-3 };
        let hole =
            Charge { from: Vec3::new(1.2, 0.3, -0.4), to: Vec3::new(1.0, 0.3, 0.4), volume: 6e-3 };
        grading.at.push(Finest::Segment(hole.from, hole.to));
        let cells = graded_cells(&solid, &grading, &[ball, hole], 3, 4, 0.004).unwrap();
        for (charge, most) in [(ball, 1), (hole, 12)] {
            let touched =
                cells.iter().filter(|cell| cell.meets_segment(charge.from, charge.to, 1e-6));
            let volumes: Vec<f64> = touched.map(|cell| cell.moments().volume).collect();
            let sum: f64 = volumes.iter().sum();
            assert!((sum / charge.volume - 1.0).abs() < 1e-9, "{sum}");
            assert!(volumes.len() <= most, "{}", volumes.len());
        }
        let sum: f64 = cells.iter().map(|c| c.moments().volume).sum();
        assert!((sum / 24.0 - 1.0).abs() < 1e-9, "{sum}");
    }

    #[test]
    fn silly_numbers_are_errors() {
        let (solid, grading) = graded();
        for (from, to, over) in [(0.0, 1.0, 1.0), (0.5, 0.1, 1.0), (0.1, 0.5, f64::NAN)] {
            let grading = Grading { from, to, over, ..grading.clone() };
            assert!(graded_cells(&solid, &grading, &[], 1, 0, 0.0).is_err());
        }
        let fine = Grading { from: 1e-4, to: 1e-4, ..grading };
        assert!(graded_cells(&solid, &fine, &[], 1, 0, 0.0).is_err());
    }
}
