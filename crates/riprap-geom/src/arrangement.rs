//! A region cut by segments into blocks.
//!
//! 1. Every segment is clipped to the region (`clip_to_region`); the ends of its pieces are put on
//!    the region's edges.
//! 2. Pieces that cross or touch are split there. Points nearer than the snapping distance are one
//!    point, and the first one found keeps its place: region corners, then points on region edges,
//!    then the rest. So the outline never moves and the blocks add up to it.
//! 3. Edges that separate nothing are removed: dead ends, groups that hang on nothing (a face must
//!    not have holes), links between such groups, and loops hanging on a single point. In rock words:
//!    a crack that ends inside a block does not cut it, and an island inside a block is part of it.
//! 4. The loops that are left are the faces; neighbours name the same points, so their vertices are
//!    the same bit for bit. A joint that ends on another one leaves a point on the straight side of
//!    the block opposite (a T), which `Subdivision::polygons` leaves out of that block's corners.
//!
//! Crossing coordinates are computed relative to the middle of the region.

mod faces;
mod split;

use std::collections::BTreeMap;

use crate::polygon::{self, Aabb};
use crate::{GeomError, Vec2, tol};

/// A segment that may cut the region; segments of one family are known not to meet each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// One end.
    pub from: Vec2,
    /// Other end.
    pub to: Vec2,
    /// Pairs with the same family are not looked at; `None` is a family of its own.
    pub family: Option<u32>,
}

/// Blocks that fill a region, neighbours naming the same points.
#[derive(Debug, Clone, PartialEq)]
pub struct Subdivision {
    /// All points; the first ones are the region's vertices.
    pub points: Vec<Vec2>,
    /// Anticlockwise loops of point numbers, one per block, ordered by centroid from bottom to top and
    /// left to right; straight-side points included.
    pub faces: Vec<Vec<u32>>,
    /// What was left out because it separates nothing.
    pub removed: Removed,
    /// A point nearer than this to a side is on it: round-off of the region's size and place, m.
    pub straightness: f64,
}

/// Edges left out because they separate nothing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Removed {
    /// Edges of cracks that end inside a block.
    pub dead_ends: usize,
    /// Edges of islands inside a block.
    pub islands: usize,
}

impl Subdivision {
    /// Corners of every block; points on straight sides are left out.
    pub fn polygons(&self) -> Vec<Vec<Vec2>> {
        self.faces.iter().map(|face| self.corners(face)).collect()
    }

    /// Corners of one loop of points.
    pub(crate) fn corners(&self, face: &[u32]) -> Vec<Vec2> {
        let all: Vec<Vec2> = face.iter().map(|&p| self.points[p as usize]).collect();
        polygon::drop_collinear(&all, self.straightness)
    }

    pub(crate) fn sort(&mut self) {
        let key = |face: &Vec<u32>| {
            let all: Vec<Vec2> = face.iter().map(|&p| self.points[p as usize]).collect();
            let c = polygon::centroid(&all);
            (c.y, c.x)
        };
        let mut keyed: Vec<((f64, f64), Vec<u32>)> =
            self.faces.iter().map(|f| (key(f), f.clone())).collect();
        keyed.sort_by(|(a, _), (b, _)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        self.faces = keyed.into_iter().map(|(_, f)| f).collect();
    }
}

/// Cut a simple anticlockwise region; points within `tol::SNAP` of its size are one.
///
/// *Errors*: what `polygon::validate` finds in the region; `TooMany` when segments or crossings
/// exceed the caps; `Arrangement` when cuts are too close together to tell apart.
pub fn cut_region(region: &[Vec2], cuts: &[Cut]) -> Result<Subdivision, GeomError> {
    cut_region_within(region, cuts, tol::SNAP)
}

/// As [`cut_region`], for cuts whose places are known to the share `snap` of the region's size alone.
///
/// *Errors*: as [`cut_region`].
pub(crate) fn cut_region_within(
    region: &[Vec2],
    cuts: &[Cut],
    snap: f64,
) -> Result<Subdivision, GeomError> {
    polygon::validate(region)?;
    for cut in cuts {
        for (vertex, p) in [cut.from, cut.to].into_iter().enumerate() {
            if !(p.x.abs() < 1e150 && p.y.abs() < 1e150) {
                return Err(GeomError::NonFinite { vertex, x: p.x, y: p.y });
            }
        }
    }
    // Each retry tells fewer points apart; cuts at round-off distance are then one cut.
    let mut last = GeomError::Arrangement { at: region[0] };
    for snap in [snap, 30.0 * snap, 900.0 * snap] {
        match attempt(region, cuts, snap) {
            Err(GeomError::Arrangement { at }) => last = GeomError::Arrangement { at },
            other => return other,
        }
    }
    Err(last)
}

fn attempt(region: &[Vec2], cuts: &[Cut], snap: f64) -> Result<Subdivision, GeomError> {
    let bounds = Aabb::of(region);
    let origin = bounds.centre();
    let local: Vec<Vec2> = region.iter().map(|&v| v - origin).collect();
    let moved: Vec<Cut> = cuts
        .iter()
        .map(|c| Cut { from: c.from - origin, to: c.to - origin, family: c.family })
        .collect();
    let mut points = PointStore::new(snap * bounds.size());
    for (vertex, &v) in local.iter().enumerate() {
        if points.place(v) as usize != vertex {
            // Two corners of the region within the snapping distance.
            return Err(GeomError::Arrangement { at: region[vertex] });
        }
    }
    let edges = split::split(&local, &moved, &mut points)?;
    let (faces, removed) = faces::trace(&points.points, edges, local.len())
        .map_err(|at| GeomError::Arrangement { at: at + origin })?;
    if faces.len() > tol::MAX_BLOCKS {
        return Err(GeomError::TooMany {
            what: "blocks",
            count: faces.len() as f64,
            cap: tol::MAX_BLOCKS,
        });
    }
    // Corners of the region keep their bits: the way to the middle and back would round them.
    let global = |(i, &p): (usize, &Vec2)| {
        if i < region.len() { region[i] } else { p + origin }
    };
    let place = bounds.min.abs().max(bounds.max.abs()).max_element();
    let mut result = Subdivision {
        points: points.points.iter().enumerate().map(global).collect(),
        faces,
        removed,
        straightness: (tol::COLLINEAR * bounds.size()).max(2.0 * f64::EPSILON * place),
    };
    audit(&result, polygon::signed_area(region))?;
    result.sort();
    Ok(result)
}

/// Every face a simple outline, and together the region.
fn audit(result: &Subdivision, area: f64) -> Result<(), GeomError> {
    let mut sum = 0.0;
    for face in &result.faces {
        let outline: Vec<Vec2> = face.iter().map(|&p| result.points[p as usize]).collect();
        let corners = result.corners(face);
        if polygon::validate(&corners).is_err() {
            return Err(GeomError::Arrangement { at: outline[0] });
        }
        sum += polygon::signed_area(&outline);
    }
    if (sum / area - 1.0).abs() > 1e-9 {
        return Err(GeomError::Arrangement { at: result.points[0] });
    }
    Ok(())
}

/// Points, merged within a distance.
struct PointStore {
    points: Vec<Vec2>,
    distance: f64,
    cell: f64,
    grid: BTreeMap<(i64, i64), Vec<u32>>,
}

impl PointStore {
    fn new(distance: f64) -> Self {
        PointStore {
            points: Vec::new(),
            distance,
            // A few distances wide, so that most places have to ask one cell alone.
            cell: 4.0 * distance,
            grid: BTreeMap::new(),
        }
    }

    /// Number of the point nearest to `p` within the distance, or a new one.
    fn place(&mut self, p: Vec2) -> u32 {
        let key = |x: f64| (x / self.cell).floor() as i64;
        let (low, high) = (p - Vec2::splat(self.distance), p + Vec2::splat(self.distance));
        let mut nearest: Option<(f64, u32)> = None;
        for cx in key(low.x)..=key(high.x) {
            for cy in key(low.y)..=key(high.y) {
                for &i in self.grid.get(&(cx, cy)).map_or(&[][..], Vec::as_slice) {
                    let d = self.points[i as usize].distance(p);
                    if d <= self.distance && nearest.is_none_or(|n| (d, i) < n) {
                        nearest = Some((d, i));
                    }
                }
            }
        }
        if let Some((_, i)) = nearest {
            return i;
        }
        let new = self.points.len() as u32;
        self.points.push(p);
        self.grid.entry((key(p.x), key(p.y))).or_default().push(new);
        new
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::letter_u;
    use proptest::prelude::*;

    fn cut(from: (f64, f64), to: (f64, f64)) -> Cut {
        Cut { from: from.into(), to: to.into(), family: None }
    }

    fn square(side: f64) -> Vec<Vec2> {
        crate::shapes::rectangle(Vec2::ZERO, Vec2::splat(side))
    }

    fn area(result: &Subdivision) -> f64 {
        result.polygons().iter().map(|p| polygon::signed_area(p)).sum()
    }

    #[test]
    fn a_cross_makes_four() {
        let cuts = [cut((2.0, -1.0), (2.0, 9.0)), cut((-1.0, 1.0), (9.0, 1.0))];
        let s = cut_region(&square(4.0), &cuts).unwrap();
        assert_eq!(s.faces.len(), 4);
        assert!(s.polygons().iter().all(|p| p.len() == 4));
        assert_eq!(area(&s), 16.0);
    }

    #[test]
    fn dead_ends_do_not_cut_and_a_t_does() {
        let s = cut_region(&square(4.0), &[cut((2.0, -1.0), (2.0, 3.0))]).unwrap();
        assert_eq!((s.faces.len(), s.removed.dead_ends), (1, 1));
        let cuts = [cut((-1.0, 2.0), (9.0, 2.0)), cut((2.0, -1.0), (2.0, 3.0))];
        let s = cut_region(&square(4.0), &cuts).unwrap();
        assert_eq!(s.faces.len(), 3);
        // The upper block keeps four corners, though a joint ends on its lower side.
        assert!(s.polygons().iter().all(|p| p.len() == 4));
        assert_eq!(s.faces.iter().map(Vec::len).max(), Some(5));
    }

    #[test]
    fn an_island_belongs_to_its_block() {
        let mut ring: Vec<Cut> = Vec::new();
        for (a, b) in polygon::edges(&square(1.0)) {
            ring.push(Cut { from: a + Vec2::ONE, to: b + Vec2::ONE, family: None });
        }
        let s = cut_region(&square(4.0), &ring).unwrap();
        assert_eq!((s.faces.len(), s.removed.islands), (1, 4));
        // Linked to the outline by one crack: still an island.
        ring.push(cut((2.0, 1.5), (5.0, 1.5)));
        let s = cut_region(&square(4.0), &ring).unwrap();
        assert_eq!(s.faces.len(), 1);
        // Hanging on one point of the outline.
        let fan =
            [cut((0.0, 2.0), (2.0, 1.0)), cut((2.0, 1.0), (2.0, 3.0)), cut((2.0, 3.0), (0.0, 2.0))];
        let s = cut_region(&square(4.0), &fan).unwrap();
        assert_eq!(s.faces.len(), 1);
        // Two cracks link it: it is a block, and its surroundings are two.
        ring.push(cut((-1.0, 1.5), (1.0, 1.5)));
        let s = cut_region(&square(4.0), &ring).unwrap();
        assert_eq!(s.faces.len(), 3);
        assert_eq!(area(&s), 16.0);
    }

    #[test]
    fn concave_regions_are_cut_in_all_their_arms() {
        let u = letter_u();
        let s = cut_region(&u, &[cut((-1.0, 2.0), (9.0, 2.5))]).unwrap();
        assert_eq!(s.faces.len(), 3);
        // Along an edge, through corners: nothing new from the first, a cut from the second.
        let s =
            cut_region(&u, &[cut((-1.0, 1.0), (9.0, 1.0)), cut((1.0, 4.0), (1.0, -1.0))]).unwrap();
        assert_eq!(s.faces.len(), 4);
        assert_eq!(area(&s), polygon::signed_area(&u));
    }

    #[test]
    fn doubled_and_touching_cuts_are_one() {
        let cuts = [
            cut((2.0, -1.0), (2.0, 9.0)),
            cut((2.0, 5.0), (2.0, 0.0)),
            cut((2.0 + 1e-13, -1.0), (2.0, 9.0)),
            cut((0.0, 0.0), (4.0, 4.0)),
            cut((0.0, 4.0), (4.0, 0.0)),
        ];
        let s = cut_region(&square(4.0), &cuts).unwrap();
        assert_eq!(s.faces.len(), 6);
        assert!((area(&s) / 16.0 - 1.0).abs() < 1e-12);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn random_cuts_fill_the_region(
            ends in prop::collection::vec((-1.0..11.0f64, -1.0..11.0f64, -1.0..11.0f64, -1.0..11.0f64), 0..40),
            radii in prop::collection::vec(1.0..5.0f64, 3..12),
        ) {
            let n = radii.len() as f64;
            let region: Vec<Vec2> = radii.iter().enumerate().map(|(i, &r)| {
                Vec2::splat(5.0) + r * Vec2::from_angle(std::f64::consts::TAU * i as f64 / n)
            }).collect();
            let cuts: Vec<Cut> = ends.iter().map(|&(a, b, c, d)| cut((a, b), (c, d))).collect();
            let s = cut_region(&region, &cuts).unwrap();
            prop_assert!((area(&s) / polygon::signed_area(&region) - 1.0).abs() < 1e-12);
            let blocks = s.polygons();
            for i in 0..blocks.len() {
                prop_assert_eq!(polygon::validate(&blocks[i]), Ok(()));
                for j in i + 1..blocks.len() {
                    prop_assert!(crate::clip::overlap_depth(&blocks[i], &blocks[j]).depth < 1e-9);
                }
            }
            // Every inner edge is run through once in each direction.
            let mut directed = std::collections::BTreeMap::new();
            for f in &s.faces {
                for k in 0..f.len() {
                    *directed.entry((f[k], f[(k + 1) % f.len()])).or_insert(0) += 1;
                }
            }
            prop_assert!(directed.values().all(|&c| c == 1));
        }
    }
}
