//! Where boxes touch: rectangles shared by opposite faces, and what is left of the faces.
//!
//! Faces are grouped by the plane they lie in; within a plane a grid of bins finds the pairs. Equal
//! neighbours, 1:2 neighbours and any other offset come out alike.

use riprap_geom::Vec3;

use crate::faces::region::{Bins, Bounds};

/// A box with faces normal to the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    /// Index of the block.
    pub block: u32,
    /// Centre, m.
    pub centre: Vec3,
    /// Half the edge lengths, m.
    pub half: Vec3,
}

impl Cell {
    fn low(&self, axis: usize) -> f64 {
        self.centre[axis] - self.half[axis]
    }

    fn high(&self, axis: usize) -> f64 {
        self.centre[axis] + self.half[axis]
    }
}

/// A rectangle normal to an axis, in the coordinates of the next two axes (b, c), m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rectangle {
    /// Lowest corner.
    pub min: [f64; 2],
    /// Highest corner.
    pub max: [f64; 2],
}

impl Rectangle {
    fn of(cell: &Cell, axis: usize) -> Self {
        let next = [(axis + 1) % 3, (axis + 2) % 3];
        Self { min: next.map(|a| cell.low(a)), max: next.map(|a| cell.high(a)) }
    }

    fn common(&self, other: &Self) -> Self {
        Self {
            min: [0, 1].map(|k| self.min[k].max(other.min[k])),
            max: [0, 1].map(|k| self.max[k].min(other.max[k])),
        }
    }

    /// Centre, m.
    #[must_use]
    pub(crate) fn centre(&self) -> [f64; 2] {
        [0, 1].map(|k| 0.5 * (self.min[k] + self.max[k]))
    }

    /// As a box without thickness, in the coordinates of its plane.
    fn flat(&self) -> Bounds {
        let in_plane = |[b, c]: [f64; 2]| Vec3::new(b, c, 0.0);
        Bounds { centre: in_plane(self.centre()), half: 0.5 * in_plane(self.size()) }
    }

    /// Edge lengths, m.
    #[must_use]
    pub(crate) fn size(&self) -> [f64; 2] {
        [0, 1].map(|k| self.max[k] - self.min[k])
    }
}

/// A rectangle that two cells share; the first lies on the lower side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shared {
    /// Position in the list of cells, lower side.
    pub low: usize,
    /// Position in the list of cells, upper side.
    pub high: usize,
    /// Axis of the normal.
    pub axis: usize,
    /// The rectangle.
    pub part: Rectangle,
}

/// A part of a face that nobody shares.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Free {
    /// Position in the list of cells.
    pub cell: usize,
    /// Axis of the normal.
    pub axis: usize,
    /// Whether the outward normal points along the axis.
    pub upward: bool,
    /// The rectangle.
    pub part: Rectangle,
}

/// Finds all shared rectangles and free parts of faces; `tolerance` (m) is the largest gap between
/// faces that touch.
#[must_use]
pub(crate) fn meet(
    cells: &[Cell],
    periodic: [Option<f64>; 3],
    tolerance: f64,
) -> (Vec<Shared>, Vec<Free>) {
    let (mut shared, mut free) = (Vec::new(), Vec::new());
    for (axis, period) in periodic.into_iter().enumerate() {
        let lowest = cells.iter().map(|c| c.low(axis)).fold(f64::INFINITY, f64::min);
        let wrap = |x: f64| match period {
            Some(period) if x > lowest + period - tolerance => x - period,
            _ => x,
        };
        // (plane, cell, upward)
        let mut sides: Vec<(f64, usize, bool)> = Vec::with_capacity(2 * cells.len());
        for (k, cell) in cells.iter().enumerate() {
            sides.push((cell.low(axis), k, false));
            sides.push((wrap(cell.high(axis)), k, true));
        }
        sides.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut rest = sides.as_slice();
        while let Some(first) = rest.first() {
            // Faces of one plane lie closer together than the tolerance, planes farther apart.
            let end = (1..rest.len())
                .find(|&k| rest[k].0 - rest[k - 1].0 > tolerance)
                .unwrap_or(rest.len());
            debug_assert!(first.0.is_finite());
            plane(cells, &rest[..end], axis, tolerance, &mut shared, &mut free);
            rest = &rest[end..];
        }
    }
    (shared, free)
}

/// Pairs the faces of one plane.
fn plane(
    cells: &[Cell],
    sides: &[(f64, usize, bool)],
    axis: usize,
    tolerance: f64,
    shared: &mut Vec<Shared>,
    free: &mut Vec<Free>,
) {
    let of = |upward: bool| -> Vec<usize> {
        let mut found: Vec<usize> = sides.iter().filter(|s| s.2 == upward).map(|s| s.1).collect();
        found.sort_unstable();
        found
    };
    let (ups, downs) = (of(true), of(false));
    let rectangle = |k: usize| Rectangle::of(&cells[k], axis);
    let boxes: Vec<Bounds> = downs.iter().map(|&k| rectangle(k).flat()).collect();
    let bins = Bins::new(&boxes, &(0..boxes.len() as u32).collect::<Vec<u32>>());
    let mut found = Vec::new();
    let mut on_down: Vec<Vec<Rectangle>> = vec![Vec::new(); downs.len()];
    let mut own = Vec::new();
    for &up in &ups {
        own.clear();
        let whole = rectangle(up);
        bins.near(&whole.flat(), &mut found);
        for at in found.iter().map(|at| *at as usize) {
            let part = whole.common(&rectangle(downs[at]));
            if part.size().iter().all(|s| *s > tolerance) {
                own.push((at, part));
            }
        }
        for (at, part) in &own {
            shared.push(Shared { low: up, high: downs[*at], axis, part: *part });
            on_down[*at].push(*part);
        }
        let covers: Vec<Rectangle> = own.iter().map(|o| o.1).collect();
        push_free(free, &whole, &covers, (up, axis, true), tolerance);
    }
    for (down, covers) in downs.iter().zip(&on_down) {
        push_free(free, &rectangle(*down), covers, (*down, axis, false), tolerance);
    }
}

fn push_free(
    free: &mut Vec<Free>,
    whole: &Rectangle,
    covers: &[Rectangle],
    (cell, axis, upward): (usize, usize, bool),
    tolerance: f64,
) {
    for part in uncovered(whole, covers, tolerance) {
        free.push(Free { cell, axis, upward, part });
    }
}

/// Parts of `whole` that none of `covers` covers, as few rectangles as strips along the first axis give.
fn uncovered(whole: &Rectangle, covers: &[Rectangle], tolerance: f64) -> Vec<Rectangle> {
    if covers.is_empty() {
        return vec![*whole];
    }
    let mut cuts: Vec<f64> = covers.iter().flat_map(|r| [r.min[0], r.max[0]]).collect();
    cuts.extend([whole.min[0], whole.max[0]]);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|a, b| *a - *b <= tolerance);
    let mut parts: Vec<Rectangle> = Vec::new();
    let mut before: Vec<usize> = Vec::new();
    for strip in cuts.windows(2) {
        let middle = 0.5 * (strip[0] + strip[1]);
        let mut spans: Vec<[f64; 2]> = covers
            .iter()
            .filter(|r| r.min[0] < middle && middle < r.max[0])
            .map(|r| [r.min[1], r.max[1]])
            .collect();
        spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
        spans.push([whole.max[1]; 2]);
        let mut at = whole.min[1];
        let mut now = Vec::new();
        for [from, to] in spans {
            if from - at > tolerance {
                let same = |k: &usize| {
                    let p: &Rectangle = &parts[*k];
                    (p.min[1] - at).abs() <= tolerance && (p.max[1] - from).abs() <= tolerance
                };
                let joined = before.iter().copied().find(|k| same(k));
                if let Some(k) = joined {
                    parts[k].max[0] = strip[1];
                    now.push(k);
                } else {
                    now.push(parts.len());
                    parts.push(Rectangle { min: [strip[0], at], max: [strip[1], from] });
                }
            }
            at = at.max(to);
        }
        before = now;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(block: u32, centre: [f64; 3], half: [f64; 3]) -> Cell {
        Cell { block, centre: centre.into(), half: half.into() }
    }

    fn lattice(n: [usize; 3], edge: f64) -> Vec<Cell> {
        let mut cells = Vec::new();
        for z in 0..n[2] {
            for y in 0..n[1] {
                for x in 0..n[0] {
                    let at = [x, y, z].map(|k| (k as f64 + 0.5) * edge);
                    cells.push(cell(cells.len() as u32, at, [0.5 * edge; 3]));
                }
            }
        }
        cells
    }

    #[test]
    fn a_lattice_has_one_rectangle_a_face() {
        let (shared, free) = meet(&lattice([4, 5, 6], 0.3), [None; 3], 1e-7);
        assert_eq!(shared.len(), 3 * 120 - (4 * 5 + 5 * 6 + 6 * 4));
        assert_eq!(free.len(), 2 * (4 * 5 + 5 * 6 + 6 * 4));
        let (shared, free) = meet(&lattice([4, 1, 2], 0.3), [Some(1.2), Some(0.3), None], 1e-7);
        assert_eq!((shared.len(), free.len()), (8 + 8 + 4, 8));
        assert!(shared.iter().any(|s| s.low == s.high && s.axis == 1));
    }

    #[test]
    fn a_large_face_meets_four_small_ones_and_what_is_left_is_free() {
        let mut cells = vec![cell(0, [0.5, 0.5, 0.5], [0.5; 3])];
        for (k, (x, y)) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75)].iter().enumerate() {
            cells.push(cell(k as u32 + 1, [*x, *y, 1.25], [0.25; 3]));
        }
        let (shared, free) = meet(&cells, [None; 3], 1e-7);
        let above: Vec<_> = shared.iter().filter(|s| s.axis == 2).collect();
        assert_eq!(above.len(), 3);
        let gap: Vec<_> = free.iter().filter(|f| f.cell == 0 && f.axis == 2 && f.upward).collect();
        assert_eq!(gap.len(), 1);
        assert_eq!(gap[0].part.min, [0.5, 0.5]);
        assert_eq!(gap[0].part.max, [1.0, 1.0]);
    }

    #[test]
    fn areas_add_up_whatever_the_offset() {
        let mut cells = vec![cell(0, [0.0, 0.0, -1.0], [3.0, 2.0, 1.0])];
        for (k, (x, y)) in [(-2.6, 0.3), (-0.2, -1.4), (1.7, 0.9)].iter().enumerate() {
            cells.push(cell(k as u32 + 1, [*x, *y, 0.5], [0.7, 0.4, 0.5]));
        }
        let (shared, free) = meet(&cells, [None; 3], 1e-7);
        let area = |r: &Rectangle| r.size()[0] * r.size()[1];
        let covered: f64 = shared.iter().map(|s| area(&s.part)).sum();
        let open: f64 = free
            .iter()
            .filter(|f| f.cell == 0 && f.axis == 2 && f.upward)
            .map(|f| area(&f.part))
            .sum();
        assert!((covered + open - 24.0).abs() < 1e-12, "{covered} {open}");
    }
}
