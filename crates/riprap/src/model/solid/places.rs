//! Which blocks touch or hold a place, and how large the finest cells there are.

use riprap_geom::Vec3;

use super::shapes::{bounds, solid, volume};
use crate::model::builder::Builder;
use crate::spatial::setup::{Place, Region, Shape};

/// Places nearer than this share of a block's size touch it.
pub(super) const TOUCH: f64 = 1e-9;
/// Cells of one block that are looked at around one charge.
const MOST_CELLS: usize = 2_000_000;

/// A box by its centre and half its edges, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) centre: Vec3,
    pub(super) half: Vec3,
}

impl Cell {
    /// The box around a shape.
    pub(super) fn of(shape: &Shape) -> Self {
        let (min, max) = bounds(shape);
        Cell {
            centre: 0.5 * (min + max),
            half: 0.5 * (max - min),
        }
    }

    fn octant(self, octant: u8) -> Self {
        let sign = |bit: u8| if octant & bit == 0 { -0.5 } else { 0.5 };
        let side = Vec3::new(sign(1), sign(2), sign(4));
        Cell {
            centre: self.centre + side * self.half,
            half: 0.5 * self.half,
        }
    }

    fn volume(self) -> f64 {
        8.0 * self.half.element_product()
    }

    /// Whether it touches a region.
    pub(super) fn touches(self, region: &Region, slack: f64) -> bool {
        match region {
            Region::Point(p) => within((*p - self.centre).abs(), self.half, slack),
            Region::Line(a, b) => self.touches_line(*a, *b, slack),
            Region::Plane(at, normal) => {
                let reach = normal.abs().dot(self.half);
                normal.dot(*at - self.centre).abs() <= reach + slack
            }
            Region::Ball(centre, radius) => {
                let outside = ((*centre - self.centre).abs() - self.half).max(Vec3::ZERO);
                outside.length() <= radius + slack
            }
            Region::Box(min, max) => {
                let (centre, half) = (0.5 * (*min + *max), 0.5 * (*max - *min));
                within((centre - self.centre).abs(), self.half + half, slack)
            }
            Region::All => true,
        }
    }

    /// Slabs: the stretch of the segment inside all three pairs of planes.
    fn touches_line(self, a: Vec3, b: Vec3, slack: f64) -> bool {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for k in 0..3 {
            let (start, way) = (a[k] - self.centre[k], b[k] - a[k]);
            let reach = self.half[k] + slack;
            if way == 0.0 {
                if start.abs() > reach {
                    return false;
                }
                continue;
            }
            let (first, second) = ((-reach - start) / way, (reach - start) / way);
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        enter <= leave
    }
}

fn within(distance: Vec3, reach: Vec3, slack: f64) -> bool {
    (0..3).all(|k| distance[k] <= reach[k] + slack)
}

/// The region of a place that is a point or a line.
pub(super) fn region_of(place: &Place) -> Option<Region> {
    match place {
        Place::Point { centre } => Some(Region::Point(*centre)),
        Place::Line { from, to } => Some(Region::Line(*from, *to)),
        Place::Blocks { .. } => None,
    }
}

impl Builder<'_> {
    /// The first block whose volume holds a point (local coordinates).
    pub(in crate::model) fn holder(&self, point: Vec3) -> Option<u32> {
        let mut blocks = (0u32..).zip(&self.spatial.blocks);
        let holds = |shape: &Shape| {
            let cell = Cell::of(shape);
            let slack = TOUCH * cell.half.max_element();
            if !within((point - cell.centre).abs(), cell.half, slack) {
                return false;
            }
            match shape {
                Shape::Brick { .. } => true,
                Shape::Polyhedron(_) => {
                    let solid = solid(shape);
                    (0..solid.faces.len()).all(|face| {
                        let (normal, offset) = solid.plane(face);
                        normal.dot(point) <= offset + slack
                    })
                }
                Shape::Terrain(_) => false,
            }
        };
        blocks
            .find(|(_, block)| holds(&block.shape))
            .map(|(block, _)| block)
    }

    /// Given blocks that touch a region.
    pub(super) fn touching(&self, region: &Region) -> Vec<u32> {
        let smallest = self.smallest_half();
        (0u32..)
            .zip(&self.spatial.blocks)
            .filter(|(_, block)| {
                !block.shape.is_terrain()
                    && Cell::of(&block.shape).touches(region, TOUCH * smallest)
            })
            .map(|(block, _)| block)
            .collect()
    }

    fn smallest_half(&self) -> f64 {
        let blocks = self.spatial.blocks.iter().filter(|b| !b.shape.is_terrain());
        let halves = blocks.map(|b| Cell::of(&b.shape).half);
        halves.fold(f64::INFINITY, |least, half| least.min(half.min_element()))
    }

    /// Number and volume (m³) of the finest cells that a place touches after the splitting before the
    /// first step. Cells that are split only to keep neighbours alike are not followed: they do not
    /// touch the place unless it lies in a region of its own.
    pub(super) fn removed(&self, place: &Place) -> (usize, f64) {
        let Some(region) = region_of(place) else {
            let Place::Blocks { blocks } = place else {
                return (0, 0.0);
            };
            let volumes = blocks
                .iter()
                .map(|&b| volume(&self.spatial.blocks[b as usize].shape));
            return (blocks.len(), volumes.sum());
        };
        let split: Vec<(&Region, u8)> = self
            .spatial
            .refinements
            .iter()
            .filter(|refinement| refinement.during.is_none())
            .map(|refinement| (&refinement.around, refinement.levels))
            .collect();
        let (mut count, mut total) = (0, 0.0);
        for b in self.touching(&region) {
            let shape = &self.spatial.blocks[b as usize].shape;
            if let Shape::Polyhedron(_) = shape {
                count += 1;
                total += volume(shape);
                continue;
            }
            let mut stack = vec![(Cell::of(shape), 0u8)];
            while let Some((cell, level)) = stack.pop() {
                let slack = TOUCH * cell.half.min_element();
                if !cell.touches(&region, slack) || count > MOST_CELLS {
                    continue;
                }
                let goes_on = split
                    .iter()
                    .any(|(around, levels)| *levels > level && cell.touches(around, slack));
                if goes_on {
                    stack.extend((0..8).map(|octant| (cell.octant(octant), level + 1)));
                } else {
                    count += 1;
                    total += cell.volume();
                }
            }
        }
        (count, total)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Cell = Cell {
        centre: Vec3::ZERO,
        half: Vec3::ONE,
    };

    #[test]
    fn boxes_touch_regions_at_their_faces() {
        for (region, touches) in [
            (Region::Point(Vec3::new(1.0, 1.0, 1.0)), true),
            (Region::Point(Vec3::new(1.1, 0.0, 0.0)), false),
            (
                Region::Line(Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 2.0, 0.0)),
                true,
            ),
            (
                Region::Line(Vec3::new(2.1, 0.0, 0.0), Vec3::new(0.0, 2.1, 0.0)),
                false,
            ),
            (
                Region::Line(Vec3::new(3.0, 0.0, 0.0), Vec3::new(2.0, 0.0, 0.0)),
                false,
            ),
            (Region::Plane(Vec3::new(0.0, 0.0, 1.0), Vec3::Z), true),
            (Region::Plane(Vec3::new(0.0, 0.0, 1.1), Vec3::Z), false),
            (Region::Ball(Vec3::new(2.0, 0.0, 0.0), 1.0), true),
            (Region::Ball(Vec3::new(2.0, 2.0, 0.0), 1.4), false),
            (Region::Box(Vec3::ONE, 2.0 * Vec3::ONE), true),
            (Region::Box(1.1 * Vec3::ONE, 2.0 * Vec3::ONE), false),
            (Region::All, true),
        ] {
            assert_eq!(UNIT.touches(&region, 1e-9), touches, "{region:?}");
        }
    }
}
