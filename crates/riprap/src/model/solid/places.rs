//! Which blocks touch or hold a place, and how large the finest cells there are.

use riprap_geom::Vec3;

use super::shapes::volume;
use crate::model::builder::Builder;
use crate::scenario::read::with_unit;
use crate::scenario::{Name, Span};
use crate::spatial::charge;
use crate::spatial::divisible::Divisible;
use crate::spatial::region::{Bounds, Extent};
use crate::spatial::setup::{CavityPressure, Place, Region, Shape};

/// Places nearer than this share of a block's size are in it.
const NEAR: f64 = 1e-9;
/// By this share a cell is taken smaller where its neighbours shall not touch it.
const APART: f64 = 1e-6;
/// Share of a hole that may be in no block without a word: coordinates that are given in whole centimetres.
const IN_AIR: f64 = 0.005;
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
    /// The boxes around blocks, smaller by a share.
    pub(super) fn boxes_of(&self, blocks: &[u32], smaller: f64) -> Vec<Region> {
        let cell = |b: &u32| {
            let Bounds { centre, half } = Bounds::of(&self.spatial.blocks[*b as usize].shape);
            let half = (1.0 - smaller) * half;
            Region::Box(centre - half, centre + half)
        };
        blocks.iter().map(cell).collect()
    }

    /// The cells of a group, a block or a condition, without their neighbours; `None` after an error.
    pub(super) fn cells_of_group(&mut self, name: &Name) -> Option<Vec<Region>> {
        let of_source = |source: &Name| {
            let rest = name.as_str().strip_prefix(source.as_str());
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        if self.parsed.scenario.sources.iter().any(|(source, _)| of_source(source)) {
            return None; // the source has an error of its own
        }
        let blocks = self.directory.blocks(name).map_err(|error| vec![*error]);
        let blocks = self.take(blocks)?;
        Some(self.boxes_of(&blocks, APART))
    }

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

    /// Where the source that a charge comes from stands in the scene.
    pub(super) fn span_of_source(&self, name: &str) -> Span {
        let said = self.parsed.scenario.sources.iter().map(|(said, _)| said);
        let of_name = |said: &&Name| name == said.text || name.starts_with(&format!("{said}."));
        said.into_iter().find(of_name).map_or(0..0, |said| said.span.clone())
    }

    /// Says so where a part of a hole is in no block: its charge acts in the blocks all the same.
    pub(super) fn warn_of_air(&mut self, name: &str, place: &Place, push: &CavityPressure) {
        let Place::Line { from, to } = place else { return };
        let length = from.distance(*to);
        let outside = self.outside(*from, *to);
        if outside <= IN_AIR * length {
            return;
        }
        let help = match push {
            CavityPressure::Gas { mass, .. } => format!(
                "all of its charge, {}, acts in the blocks that the rest touches; check its coordinates, or give the charge of the part in the rock",
                with_unit(*mass, "kg")
            ),
            CavityPressure::Pressure { .. } => {
                "it pushes on the blocks that the rest touches; check its coordinates".to_owned()
            }
        };
        let message = format!(
            "{} of the {} of `{name}` lie outside all blocks",
            with_unit(outside, "m"),
            with_unit(length, "m")
        );
        self.warn_at("source.air", self.span_of_source(name), message, help);
    }

    /// Length of a segment that is in no block, m; glued parts count as their box.
    fn outside(&self, from: Vec3, to: Vec3) -> f64 {
        let slack = NEAR * from.distance(to);
        let blocks = self.touching(&Region::Line(from, to));
        let mut parts: Vec<[f64; 2]> = blocks
            .iter()
            .filter_map(|&b| {
                let solid = Extent::of(&self.spatial.blocks[b as usize].shape).solid(Vec3::ZERO);
                solid.part_of_segment(from, to, slack)
            })
            .collect();
        parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut reached, mut outside) = (0.0_f64, 0.0);
        for [enter, leave] in parts {
            outside += (enter - reached).max(0.0);
            reached = reached.max(leave);
        }
        (outside + (1.0 - reached)) * from.distance(to)
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
