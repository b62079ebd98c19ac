//! Which blocks touch or hold a place, and how large the finest cells there are.

use riprap_geom::Vec3;

use super::shapes::volume;
use crate::model::builder::Builder;
use crate::spatial::charge;
use crate::spatial::divisible::Divisible;
use crate::spatial::region::{Bounds, Extent};
use crate::spatial::setup::{Place, Region, Shape};

/// Places nearer than this share of a block's size are in it.
const NEAR: f64 = 1e-9;
/// Cells of one block that are looked at around one charge.
const MOST_CELLS: usize = 2_000_000;

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
            let extent = Extent::of(shape);
            let Bounds { centre, half } = *extent.bounds();
            let slack = NEAR * half.max_element();
            if ((point - centre).abs() - half).max_element() > slack {
                return false;
            }
            match &extent {
                Extent::Box(_) => !shape.is_terrain(),
                Extent::Solid(solid, _) => (0..solid.faces.len()).all(|face| {
                    let (normal, offset) = solid.plane(face);
                    normal.dot(point) <= offset + slack
                }),
            }
        };
        blocks.find(|(_, block)| holds(&block.shape)).map(|(block, _)| block)
    }

    /// Given blocks that touch a region.
    pub(super) fn touching(&self, region: &Region) -> Vec<u32> {
        (0u32..)
            .zip(&self.spatial.blocks)
            .filter(|(_, block)| {
                !block.shape.is_terrain() && Extent::of(&block.shape).touches(region)
            })
            .map(|(block, _)| block)
            .collect()
    }

    /// Number and volume (m³) of the finest cells that a place touches after the splitting before the
    /// first step. Cells that are split only to keep neighbours alike are not followed: they do not
    /// touch the place unless it lies in a region of its own.
    pub(super) fn removed(&self, place: &Place) -> (usize, f64) {
        let Some(region) = region_of(place) else {
            let Place::Blocks { blocks } = place else {
                return (0, 0.0);
            };
            let volumes = blocks.iter().map(|&b| volume(&self.spatial.blocks[b as usize].shape));
            return (blocks.len(), volumes.sum());
        };
        let split: Vec<(&Region, u8)> = self
            .spatial
            .refinements
            .iter()
            .filter(|refinement| refinement.during.is_none())
            .map(|refinement| (&refinement.around, refinement.levels))
            .collect();
        let mut volumes = Vec::new();
        for b in self.touching(&region) {
            let shape = &self.spatial.blocks[b as usize].shape;
            let Some(whole) = Divisible::of(shape) else {
                volumes.push(volume(shape));
                continue;
            };
            let mut stack = vec![(whole, 0u8)];
            while let Some((cell, level)) = stack.pop() {
                let extent = cell.extent();
                if !extent.touches(&region) || volumes.len() > MOST_CELLS {
                    continue;
                }
                let goes_on =
                    split.iter().any(|(around, levels)| *levels > level && extent.touches(around));
                if goes_on {
                    stack.extend((0..8).map(|octant| (cell.part(octant), level + 1)));
                } else {
                    volumes.push(extent.volume());
                }
            }
        }
        // As the engine takes them: of cells of any size a line touches, the smallest alone.
        let smallest = volumes.iter().copied().fold(f64::INFINITY, f64::min);
        let finest = volumes.iter().filter(|v| **v <= (1.0 + charge::EQUAL) * smallest);
        finest.fold((0, 0.0), |(count, total), v| (count + 1, total + v))
    }
}
