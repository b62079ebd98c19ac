//! Blocks that touch nothing at the start, where that is probably not meant.
//!
//! A block that falls is a scene like any other, and so is a heap that is poured. Told are the exceptions of a model in which
//! other free blocks touch something: blocks that are apart from their neighbours by less than a hundredth of their width, a slip of
//! the pen, and blocks apart from all others where the first phase looks for rest. What has nothing below it and falls for ever is
//! told in any static phase. Blocks of grids, cells and pours are left out: they are made side by side, or apart on purpose.
//!
//! Whether blocks touch is judged by their boxes: a block that is reported touches nothing for certain, but not every such block is reported.

use std::collections::BTreeSet;

use riprap_geom::{Vec2, Vec3, polygon};

use super::builder::Builder;
use crate::plan::PhaseKind;
use crate::scenario::language::Geometry;
use crate::scenario::read::with_unit;
use crate::scenario::vectors::InSpace;
use crate::spatial::setup::{FaceSet, Shape};

/// Gap between two blocks that touch, over the width of the smaller one.
const TOUCHING: f64 = 1e-6;
/// Gap below which they were meant to, over the width of the smaller one.
const NEAR: f64 = 0.01;
/// Blocks named.
const NAMED: usize = 5;
/// Pairs of boxes after which nothing is said.
const MOST_LOOKS: usize = 200_000_000;

/// A box along the axes, m; in the plane all have the same z, wider than all else.
#[derive(Clone, Copy)]
struct Extent {
    min: Vec3,
    max: Vec3,
}

impl Extent {
    /// Narrowest measure, m.
    fn width(&self) -> f64 {
        (self.max - self.min).min_element()
    }

    /// Distance along each axis; negative where the boxes lie side by side.
    fn gaps(&self, other: &Self) -> Vec3 {
        (self.min - other.max).max(other.min - self.max)
    }

    /// Whether the other box can be in the way of this one as it falls along axis `axis`, in the direction `sign`.
    fn is_above(&self, other: &Self, axis: usize, sign: f64) -> bool {
        let gaps = self.gaps(other);
        let aside = (0..3).any(|k| k != axis && gaps[k] > TOUCHING * self.width());
        let behind = if sign < 0.0 {
            other.min[axis] >= self.max[axis]
        } else {
            other.max[axis] <= self.min[axis]
        };
        !aside && !behind
    }
}

/// What is around a block that may be loose.
struct Around {
    block: u32,
    touched: bool,
    /// Whether something is there on which it could fall.
    below: bool,
    /// The nearest of the blocks that it was probably meant to touch, and the gap between them, m.
    near: Option<(u32, f64)>,
}

impl Builder<'_> {
    /// Warns of blocks that touch nothing at the start.
    pub(super) fn loose(&mut self) {
        let candidates = self.candidates();
        let extents = self.extents();
        // Through a period a block touches one on the far side, of which boxes know nothing.
        let periodic = self.spatial.periodic.iter().any(Option::is_some);
        if candidates.is_empty() || periodic || candidates.len() * extents.len() > MOST_LOOKS {
            return;
        }
        let down = self.down();
        let around: Vec<Around> =
            candidates.iter().map(|&block| self.around(block, &extents, down)).collect();
        let touched = around.iter().filter(|a| a.touched).count();
        // Blocks of generators touch each other: they too say that this is a model of blocks that touch.
        let touched = touched + self.side_by_side();
        let apart: Vec<&Around> = around.iter().filter(|a| !a.touched).collect();
        let settles = self.plan.phases.first().filter(|p| p.kind == PhaseKind::Static);
        let settles = settles.map(|phase| phase.name.clone());
        if let (Some(phase), true) = (&settles, down.is_some() && self.falls_freely()) {
            let falls = |a: &&&Around| !a.below && !self.on_boundary(a.block, &extents);
            let lost: Vec<u32> = apart.iter().filter(falls).map(|a| a.block).collect();
            if let Some(first) = lost.first() {
                let (names, verb) = self.named(&lost);
                let message = format!(
                    "{names} {verb} nothing and {} nothing below; the static phase `{phase}` cannot reach equilibrium",
                    if lost.len() == 1 { "has" } else { "have" }
                );
                let help = "hold it by [[supports]], or place a block or terrain under it";
                self.warn_at("model.falls", self.table_span(*first), message, help);
            }
        }
        let near = apart.iter().filter_map(|a| Some((a.block, a.near?)));
        let near: Vec<(u32, (u32, f64))> = near.collect();
        if let Some((block, (other, gap))) = near.first()
            // Where most blocks are apart, that is what the scene means.
            && near.len() < touched
        {
            let (names, verb) = self.named(&near.iter().map(|(b, _)| *b).collect::<Vec<_>>());
            let message = format!(
                "{names} {verb} nothing at the start, and `{}` is {} away from `{}`",
                self.directory.name(*block),
                with_unit(*gap, "m"),
                self.directory.name(*other)
            );
            let help = "if they should touch, move one of them";
            self.warn_at("model.gap", self.table_span(*block), message, help);
        }
        let far = apart.iter().filter(|a| a.near.is_none() && a.below);
        let far: Vec<u32> = far.map(|a| a.block).collect();
        if let (Some(phase), Some(first), true) = (&settles, far.first(), down.is_some())
            && far.len() < touched
            && !self.hangs_or_floats()
        {
            let (names, verb) = self.named(&far);
            let message =
                format!("{names} {verb} nothing at the start of the static phase `{phase}`");
            let help = "it falls until it lands, in a phase whose time is not physical; if it should touch another block, move it";
            self.warn_at("model.gap", self.table_span(*first), message, help);
        }
    }

    /// Blocks that are not made side by side or apart by a generator, that nothing holds, drives or loads, and that start at rest.
    fn candidates(&self) -> Vec<u32> {
        let supports = self.setup.supports.iter().map(|s| &s.blocks);
        let loads = self.setup.loads.iter().map(|l| &l.blocks);
        let in_space = self.spatial.supports.iter().map(|s| &s.blocks);
        let loads_in_space = self.spatial.loads.iter().map(|l| &l.blocks);
        let nodes = self.spatial.deform.holds.iter();
        // A hold that names no blocks is on the nodes of all of them.
        if nodes.clone().any(|hold| hold.blocks.is_none()) {
            return Vec::new();
        }
        let nodes = nodes.filter_map(|hold| hold.blocks.as_ref());
        let first = self.plan.phases.first();
        let first = first.into_iter().flat_map(|p| [&p.fix, &p.remove]);
        let mut bound = vec![false; self.directory.centroids.len()];
        let all = supports.chain(loads).chain(in_space).chain(loads_in_space);
        let all = all.chain(nodes).chain(first);
        all.flatten().for_each(|b| bound[*b as usize] = true);
        let single = self.single();
        let tables = self.directory.tables();
        let tables = tables.filter(|(table, _)| single.contains(table));
        let blocks = tables.flat_map(|(_, blocks)| blocks);
        blocks.filter(|b| !bound[*b as usize]).collect()
    }

    /// Tables that make one shape, or copies of one, that start at rest.
    fn single(&self) -> BTreeSet<&str> {
        let blocks = self.parsed.scenario.blocks.iter();
        let single = blocks.filter(|said| {
            said.geometry().is_some_and(|geometry| {
                !geometry.is_many() && !matches!(geometry, Geometry::Terrain(_))
            }) && said.cut.is_none()
                && said.velocity.is_none()
                && said.spin.is_none()
        });
        single.map(|said| said.name.as_str()).collect()
    }

    /// Blocks of generators: they touch each other.
    fn side_by_side(&self) -> usize {
        let single = self.single();
        let tables = self.directory.tables();
        let many = tables.filter(|(table, _)| !single.contains(table));
        many.filter(|(_, blocks)| blocks.len() > 1).map(|(_, blocks)| blocks.len()).sum()
    }

    fn extents(&self) -> Vec<Extent> {
        match self.space {
            InSpace::Planar => {
                let blocks = self.setup.blocks.iter();
                let boxes = blocks.map(|b| polygon::Aabb::of(&b.vertices));
                boxes
                    .map(|b| Extent {
                        min: b.min.extend(0.0),
                        // So z is never the narrowest measure nor the largest gap.
                        max: b.max.extend(f64::MAX),
                    })
                    .collect()
            }
            InSpace::Spatial => {
                let blocks = self.spatial.blocks.iter();
                let boxes = blocks.map(|b| super::solid::bounds(&b.shape));
                boxes.map(|(min, max)| Extent { min, max }).collect()
            }
        }
    }

    /// Axis and sign of gravity in the first phase, where it is along an axis.
    fn down(&self) -> Option<(usize, f64)> {
        let own = match self.space {
            InSpace::Planar => {
                let [x, y] = self.setup.gravity;
                [x, y, 0.0]
            }
            InSpace::Spatial => self.spatial.gravity.into(),
        };
        let first = self.plan.phases.first().and_then(|p| p.gravity);
        let gravity = first.unwrap_or(own);
        let axis = (0..3).max_by(|a, b| gravity[*a].abs().total_cmp(&gravity[*b].abs()))?;
        let most = gravity[axis].abs();
        let along = (0..3).all(|k| k == axis || gravity[k].abs() <= TOUCHING * most);
        (most > 0.0 && along).then(|| (axis, gravity[axis].signum()))
    }

    /// Whether nothing but blocks that are held below can stop a fall, and something is held at all.
    fn falls_freely(&self) -> bool {
        let terrain = self.spatial.blocks.iter().any(|b| b.shape.is_terrain());
        let held = !self.setup.supports.is_empty()
            || !self.spatial.supports.is_empty()
            || !self.spatial.boundaries.is_empty()
            || terrain;
        held && !self.hangs_or_floats()
    }

    /// Whether a boundary may hold or press a face of this block: it does for certain not where its faces are away from the block's box.
    fn on_boundary(&self, block: u32, extents: &[Extent]) -> bool {
        let own = &extents[block as usize];
        let half = 0.5 * (own.max - own.min);
        self.spatial.boundaries.iter().any(|boundary| match &boundary.on {
            FaceSet::Plane { normal, offset } => {
                let middle = normal.dot(0.5 * (own.min + own.max)) - offset;
                middle.abs() <= normal.abs().dot(half) + TOUCHING * own.width()
            }
            FaceSet::Blocks { blocks, .. } | FaceSet::Surface { blocks, .. } => {
                blocks.contains(&block)
            }
            FaceSet::Box { min, max, .. } => {
                let there = Extent { min: *min, max: *max };
                own.gaps(&there).max_element() <= TOUCHING * own.width()
            }
        })
    }

    /// Whether bolts or water can carry a block.
    fn hangs_or_floats(&self) -> bool {
        let wet = !self.setup.water.is_empty() || !self.spatial.water.is_empty();
        let tied = !self.setup.bolts.is_empty() || !self.spatial.bolts.is_empty();
        wet || tied
    }

    fn around(&self, block: u32, extents: &[Extent], down: Option<(usize, f64)>) -> Around {
        let own = extents[block as usize];
        let mut around = Around { block, touched: false, below: down.is_none(), near: None };
        for (other, extent) in (0u32..).zip(extents).filter(|(other, _)| *other != block) {
            let width = own.width().min(extent.width());
            let gap = own.gaps(extent).max_element();
            around.touched |= gap <= TOUCHING * width;
            around.below |= down.is_some_and(|(axis, sign)| own.is_above(extent, axis, sign));
            if !around.touched
                && gap <= NEAR * width
                && let Some(gap) = self.gap(block, other).filter(|gap| *gap <= NEAR * width)
                && around.near.is_none_or(|(_, least)| gap < least)
            {
                around.near = Some((other, gap));
            }
        }
        around
    }

    /// Distance of two blocks whose boxes are apart, m: of polygons, and of bricks face to face.
    fn gap(&self, i: u32, j: u32) -> Option<f64> {
        let (i, j) = (i as usize, j as usize);
        match self.space {
            InSpace::Planar => {
                let [p, q] = [i, j].map(|b| &self.setup.blocks[b].vertices[..]);
                let to = |corners: &[Vec2], outline: &[Vec2]| {
                    let gaps = corners.iter().map(|c| polygon::distance_to_boundary(outline, *c));
                    gaps.fold(f64::INFINITY, f64::min)
                };
                // Outlines that are apart are nearest at a corner of one of them, of whichever.
                Some(to(p, q).min(to(q, p)))
            }
            InSpace::Spatial => {
                let shapes = [i, j].map(|b| &self.spatial.blocks[b].shape);
                let [Shape::Brick { .. }, Shape::Brick { .. }] = shapes else {
                    return None;
                };
                let [a, b] = shapes.map(|shape| {
                    let (min, max) = super::solid::bounds(shape);
                    Extent { min, max }
                });
                let gaps = a.gaps(&b);
                // Past an edge or a corner the largest gap is less than the distance.
                let beside = (0..3).filter(|k| gaps[*k] < 0.0).count();
                (beside == 2).then(|| gaps.max_element())
            }
        }
    }

    /// `block x touches` or `3 blocks touch`, the latter with names.
    fn named(&self, blocks: &[u32]) -> (String, &'static str) {
        let names: Vec<String> =
            blocks.iter().take(NAMED).map(|b| format!("`{}`", self.directory.name(*b))).collect();
        let names = names.join(", ");
        match blocks.len() {
            1 => (format!("block {names}"), "touches"),
            n if n <= NAMED => (format!("{n} blocks ({names})"), "touch"),
            n => (format!("{n} blocks ({names}, ...)"), "touch"),
        }
    }
}
