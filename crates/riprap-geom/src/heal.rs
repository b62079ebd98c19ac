//! Merging of blocks that are too small for their neighbours.
//!
//! A block is a *sliver* if its width (twice the area over the diameter) is below the smallest edge;
//! it is *notched* if one of its edges is shorter. Slivers, and notched blocks less wide than four
//! smallest edges, are merged with the neighbour with the longest shared edge, those first with which
//! the result is sound. Wide notched blocks stay and are reported: three joints that cross nearly at
//! one point must not weld the large blocks round that point into one.
//! No vertex is moved, so joints stay straight and the area stays what it was.

use std::collections::{BTreeMap, BTreeSet};

use crate::Vec2;
use crate::arrangement::{Removed, Subdivision};
use crate::measure::{Shape, SliverReport, shape};
use crate::polygon;

/// Finished blocks of a region.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks {
    /// Outlines, anticlockwise, from bottom to top and left to right.
    pub polygons: Vec<Vec<Vec2>>,
    /// Cracks that separate nothing and were left out.
    pub removed: Removed,
    /// Blocks merged into a neighbour; `block` numbers count before merging.
    pub merged: Vec<SliverReport>,
    /// Short edges shrunk to a point (Voronoi cells only).
    pub collapsed: usize,
    /// Bad blocks that stayed; `block` numbers are those of `polygons`.
    pub left: Vec<SliverReport>,
}

/// Merge bad blocks of a subdivision; `smallest_edge` 0 merges nothing.
pub(crate) fn heal(mut parts: Subdivision, smallest_edge: f64) -> Blocks {
    let mut merged = Vec::new();
    if smallest_edge > 0.0 {
        let reports = Merging::new(&parts, smallest_edge).run();
        merged = reports.1;
        parts.faces = reports.0;
        parts.sort();
    }
    let polygons = parts.polygons();
    let shapes: Vec<Shape> = polygons.iter().map(|p| shape(p)).collect();
    let median = median_width(&shapes);
    let left = shapes
        .iter()
        .enumerate()
        .filter(|(_, s)| s.width.min(s.shortest_edge) < smallest_edge)
        .map(|(block, s)| report(block, s, median, &polygons[block]))
        .collect();
    Blocks { polygons, removed: parts.removed, merged, collapsed: 0, left }
}

fn median_width(shapes: &[Shape]) -> f64 {
    let mut widths: Vec<f64> = shapes.iter().map(|s| s.width).collect();
    widths.sort_by(f64::total_cmp);
    widths.get(widths.len() / 2).copied().unwrap_or(1.0)
}

fn report(block: usize, s: &Shape, median: f64, outline: &[Vec2]) -> SliverReport {
    SliverReport {
        block,
        edge: s.shortest_edge,
        ratio: s.width.min(s.shortest_edge) / median,
        at: polygon::centroid(outline).into(),
    }
}

/// Shrink edges below `smallest` to a point where that leaves the region and all faces what they are;
/// how many. For cells, whose sides are nobody's joints; the sides of joints must stay straight.
///
/// Inner points meet half way, a point on the outline stays on its side, a corner of the region (the
/// first `corners` points) stays where it is.
pub(crate) fn collapse(parts: &mut Subdivision, corners: usize, smallest: f64) -> usize {
    let mut faces_at: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for (f, face) in parts.faces.iter().enumerate() {
        for &p in face {
            faces_at.entry(p).or_default().insert(f as u32);
        }
    }
    let (short, outline) = short_sides(parts, smallest);
    let mut count = 0;
    for (_, a, b, at_outline) in short {
        let (corner_a, corner_b) = ((a as usize) < corners, (b as usize) < corners);
        let (on_a, on_b) = (outline[a as usize], outline[b as usize]);
        // Two points on different sides of the outline, or two corners, cannot become one.
        if (corner_a && corner_b) || (on_a && on_b && !at_outline) {
            continue;
        }
        let (keep, gone) = if corner_b || (on_b && !on_a) { (b, a) } else { (a, b) };
        let (Some(of_keep), Some(of_gone)) = (faces_at.get(&keep), faces_at.get(&gone)) else {
            continue;
        };
        let old = parts.points[keep as usize];
        if !on_a && !on_b {
            parts.points[keep as usize] = 0.5 * (old + parts.points[gone as usize]);
        }
        let touched: Vec<u32> = of_keep.union(of_gone).copied().collect();
        let renamed = |f: &u32| renamed(&parts.faces[*f as usize], gone, keep);
        let new: Vec<Vec<u32>> = touched.iter().map(renamed).collect();
        let sound = |face: &Vec<u32>| {
            let corners = parts.corners(face);
            polygon::validate(&corners).is_ok() && polygon::signed_area(&corners) > 0.0
        };
        if !new.iter().all(sound) {
            parts.points[keep as usize] = old;
            continue;
        }
        for (&f, face) in touched.iter().zip(new) {
            parts.faces[f as usize] = face;
        }
        let moved = faces_at.remove(&gone).unwrap_or_default();
        faces_at.entry(keep).or_default().extend(moved);
        count += 1;
    }
    count
}

/// A side: length, ends, and whether it lies on the outline.
type Side = (f64, u32, u32, bool);

/// Sides below `smallest`, the shortest first; and which points lie on the outline.
fn short_sides(parts: &Subdivision, smallest: f64) -> (Vec<Side>, Vec<bool>) {
    let directed: BTreeSet<(u32, u32)> = parts.faces.iter().flat_map(|face| sides(face)).collect();
    let mut outline = vec![false; parts.points.len()];
    let mut short: Vec<Side> = Vec::new();
    for &(a, b) in &directed {
        // An inner side is run through once in either direction.
        let at_outline = !directed.contains(&(b, a));
        if at_outline {
            outline[a as usize] = true;
            outline[b as usize] = true;
        }
        let length = parts.points[a as usize].distance(parts.points[b as usize]);
        if length < smallest && (at_outline || a < b) {
            short.push((length, a, b, at_outline));
        }
    }
    short.sort_by(|x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
    (short, outline)
}

/// A face with one point in place of another.
fn renamed(face: &[u32], gone: u32, keep: u32) -> Vec<u32> {
    let mut face: Vec<u32> = face.iter().map(|&p| if p == gone { keep } else { p }).collect();
    face.dedup();
    if face.len() > 1 && face[0] == face[face.len() - 1] {
        face.pop();
    }
    face
}

struct Merging<'a> {
    parts: &'a Subdivision,
    smallest: f64,
    /// Emptied when merged into another.
    faces: Vec<Vec<u32>>,
    /// Face to the left of a directed edge.
    left_of: BTreeMap<(u32, u32), u32>,
}

impl<'a> Merging<'a> {
    fn new(parts: &'a Subdivision, smallest: f64) -> Self {
        let faces = parts.faces.clone();
        let mut left_of = BTreeMap::new();
        for (f, face) in faces.iter().enumerate() {
            left_of.extend(sides(face).map(|side| (side, f as u32)));
        }
        Merging { parts, smallest, faces, left_of }
    }

    fn shape_of(&self, face: &[u32]) -> Shape {
        shape(&self.parts.corners(face))
    }

    fn is_sound(&self, s: &Shape) -> bool {
        s.width.min(s.shortest_edge) >= self.smallest
    }

    fn is_small(&self, s: &Shape) -> bool {
        s.width < self.smallest
            || (s.shortest_edge < self.smallest && s.width < 4.0 * self.smallest)
    }

    /// Remaining faces and reports, smallest block first.
    fn run(mut self) -> (Vec<Vec<u32>>, Vec<SliverReport>) {
        let shapes: Vec<Shape> = self.faces.iter().map(|f| self.shape_of(f)).collect();
        let median = median_width(&shapes);
        // Widths are not negative, so their bits sort like the numbers.
        let key = |s: &Shape| s.width.to_bits();
        let mut bad: BTreeSet<(u64, u32)> = shapes
            .iter()
            .enumerate()
            .filter(|(_, s)| self.is_small(s))
            .map(|(f, s)| (key(s), f as u32))
            .collect();
        let mut reports = Vec::new();
        while let Some((_, f)) = bad.pop_first() {
            if self.faces[f as usize].is_empty() {
                continue;
            }
            let s = self.shape_of(&self.faces[f as usize]);
            // It may have become sound by what has been merged into it since it was listed.
            if !self.is_small(&s) {
                continue;
            }
            let Some((into, union)) = self.partner(f) else {
                continue;
            };
            let outline = self.parts.corners(&self.faces[f as usize]);
            reports.push(report(f as usize, &s, median, &outline));
            self.replace(f, into, union);
            let s = self.shape_of(&self.faces[into as usize]);
            if self.is_small(&s) {
                bad.insert((key(&s), into));
            }
        }
        (self.faces.into_iter().filter(|f| !f.is_empty()).collect(), reports)
    }

    /// The neighbour to merge with, and the outline of both.
    fn partner(&self, f: u32) -> Option<(u32, Vec<u32>)> {
        let mut shared: BTreeMap<u32, f64> = BTreeMap::new();
        for (a, b) in sides(&self.faces[f as usize]) {
            if let Some(&other) = self.left_of.get(&(b, a)) {
                let p = &self.parts.points;
                *shared.entry(other).or_insert(0.0) += p[a as usize].distance(p[b as usize]);
            }
        }
        let mut order: Vec<(u32, f64)> = shared.into_iter().collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        let mut second = None;
        for (other, _) in order {
            let Some(union) = union(&self.faces[f as usize], &self.faces[other as usize]) else {
                continue;
            };
            if self.is_sound(&self.shape_of(&union)) {
                return Some((other, union));
            }
            if second.is_none() {
                second = Some((other, union));
            }
        }
        second
    }

    fn replace(&mut self, gone: u32, into: u32, union: Vec<u32>) {
        for f in [gone, into] {
            for side in sides(&std::mem::take(&mut self.faces[f as usize])) {
                self.left_of.remove(&side);
            }
        }
        self.left_of.extend(sides(&union).map(|side| (side, into)));
        self.faces[into as usize] = union;
    }
}

fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()]))
}

/// One loop round two neighbouring faces; `None` if they would enclose a third one or pinch.
fn union(a: &[u32], b: &[u32]) -> Option<Vec<u32>> {
    let of_a: BTreeSet<(u32, u32)> = sides(a).collect();
    let of_b: BTreeSet<(u32, u32)> = sides(b).collect();
    let mut next = BTreeMap::new();
    let outer_a = sides(a).filter(|&(p, q)| !of_b.contains(&(q, p)));
    let outer_b = sides(b).filter(|&(p, q)| !of_a.contains(&(q, p)));
    for (p, q) in outer_a.chain(outer_b) {
        if next.insert(p, q).is_some() {
            return None;
        }
    }
    let (&start, _) = next.first_key_value()?;
    let mut outline = vec![start];
    let mut at = *next.get(&start)?;
    while at != start {
        outline.push(at);
        at = *next.get(&at)?;
    }
    (outline.len() == next.len()).then_some(outline)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::{Cut, cut_region};
    use crate::shapes::rectangle;

    fn lines(list: &[(f64, f64, f64, f64)]) -> Vec<Cut> {
        let cut = |&(a, b, c, d): &(f64, f64, f64, f64)| Cut {
            from: Vec2::new(a, b),
            to: Vec2::new(c, d),
            family: None,
        };
        list.iter().map(cut).collect()
    }

    fn area(blocks: &Blocks) -> f64 {
        blocks.polygons.iter().map(|p| polygon::signed_area(p)).sum()
    }

    #[test]
    fn thin_strips_go_to_a_neighbour() {
        let cuts = lines(&[(-1., 2., 9., 2.), (-1., 2.01, 9., 2.01), (2., -1., 2., 9.)]);
        let parts = cut_region(&rectangle(Vec2::ZERO, Vec2::splat(4.0)), &cuts).unwrap();
        assert_eq!(parts.faces.len(), 6);
        let plain = heal(parts.clone(), 0.0);
        assert_eq!((plain.polygons.len(), plain.merged.len(), plain.left.len()), (6, 0, 0));
        let healed = heal(parts, 0.05);
        assert_eq!((healed.polygons.len(), healed.merged.len(), healed.left.len()), (4, 2, 0));
        assert!(healed.polygons.iter().all(|p| p.len() == 4));
        assert_eq!(area(&healed), 16.0);
    }

    #[test]
    fn what_has_become_sound_is_merged_no_further() {
        // Strips of 29 and 31 mm are slivers, both together are none.
        let cuts = lines(&[(0.029, -1., 0.029, 9.), (0.06, -1., 0.06, 9.), (1., -1., 1., 9.)]);
        let parts = cut_region(&rectangle(Vec2::ZERO, Vec2::new(2.0, 1.0)), &cuts).unwrap();
        assert_eq!(parts.faces.len(), 4);
        let healed = heal(parts, 0.05);
        assert_eq!((healed.merged.len(), healed.left.len()), (1, 0));
        let mut widths: Vec<f64> =
            healed.polygons.iter().map(|p| polygon::signed_area(p)).collect();
        widths.sort_by(f64::total_cmp);
        assert_eq!(widths.len(), 3);
        for (width, exact) in widths.iter().zip([0.06, 0.94, 1.0]) {
            assert!((width - exact).abs() < 1e-12, "{width}");
        }
    }

    #[test]
    fn three_nearly_concurrent_joints_weld_nothing_large() {
        let cuts = lines(&[(-1., 2., 9., 2.), (2., -1., 2., 9.), (-1., -1.02, 9., 8.98)]);
        let parts = cut_region(&rectangle(Vec2::ZERO, Vec2::splat(4.0)), &cuts).unwrap();
        assert_eq!(parts.faces.len(), 7);
        let healed = heal(parts, 0.05);
        assert_eq!((healed.merged.len(), healed.polygons.len(), healed.left.len()), (1, 6, 2));
        assert!((area(&healed) - 16.0).abs() < 1e-12);
    }

    #[test]
    fn unions_that_would_enclose_are_refused() {
        // Two halves of a frame 0..7 round a hole: merging both would leave a hole.
        assert_eq!(union(&[0, 1, 5, 4], &[1, 2, 6, 5]), Some(vec![0, 1, 2, 6, 5, 4]));
        let (half, rest) = ([0, 1, 2, 6, 5, 4], [2, 3, 0, 4, 7, 6]);
        assert_eq!(union(&half, &rest), None);
    }
}
