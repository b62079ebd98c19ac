//! Checks of the finished model in space: overlaps, who carries the in-situ stress, motion.

use std::borrow::Cow;

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Polyhedron, Sliced, slice};

use super::grid::grid_of;
use super::shapes::{bounds, solid, volume};
use super::triple;
use super::turn::moved;
use crate::model::builder::Builder;
use crate::model::summary::passing;
use crate::scenario::language::Space;
use crate::scenario::read::with_unit;
use crate::scenario::{Diagnostic, Quantity, Span};
use crate::spatial::setup::{BlockSpec, BoundaryKind, FaceSet, Shape, Solid};

/// Overlap at the start that needs no reason, as a share of the smaller block.
const ACCEPTED: f64 = 1e-6;
/// Pairs named one by one.
const NAMED: usize = 10;
/// Overlapping pairs after which the search for more of them ends.
const MOST_BAD: usize = 1000;
/// Looks at pairs of boxes (some seconds) after which the search for overlaps is given up, with a warning.
const MOST_LOOKS: usize = 2_000_000_000;
/// Two blocks that lie in each other.
struct Overlap {
    depth: f64,
    blocks: [u32; 2],
    /// Whether one of them does as an image of itself, across the ends of a periodic model.
    across: bool,
    at: Vec3,
}

/// A block at the start, or an image of one across the ends of a periodic model.
struct Placed<'a> {
    block: u32,
    shape: Cow<'a, Shape>,
    image: bool,
}

impl Builder<'_> {
    pub(in crate::model) fn inspect_solid(&mut self) {
        self.join_terrain();
        self.solid_summary();
        self.solid_overlaps();
        self.glued_without_joints();
        self.on_terrain();
        self.stress_balance();
        self.solid_motion();
    }

    fn solid_summary(&mut self) {
        let blocks = &self.spatial.blocks;
        let alone = blocks.iter().all(|b| b.shape.is_terrain());
        let counts = |b: &&BlockSpec| alone || !b.shape.is_terrain();
        let mut sizes: Vec<f64> =
            blocks.iter().filter(counts).map(|b| libm::cbrt(volume(&b.shape))).collect();
        let mass = blocks
            .iter()
            .filter(counts)
            .map(|b| volume(&b.shape) * self.spatial.materials[usize::from(b.material)].density)
            .sum();
        sizes.sort_by(f64::total_cmp);
        let corners = |shape: &Shape| match shape {
            Shape::Brick { .. } => 8,
            Shape::Polyhedron(solid) => solid.vertices.len(),
            Shape::Glued(parts) => parts.iter().map(|part| part.vertices.len()).sum(),
            Shape::Terrain(surface) => surface.points.len(),
        };
        let vertices = blocks.iter().map(|b| corners(&b.shape)).sum();
        let held = blocks.iter().map(|b| b.shape.is_terrain());
        let mut supported: Vec<bool> = held.collect();
        for support in &self.spatial.supports {
            for &block in &support.blocks {
                supported[block as usize] = true;
            }
        }
        // What is held stands for the rock around.
        let free = blocks.iter().zip(&supported).filter(|(_, held)| !**held);
        let mut free: Vec<f64> = free.map(|(b, _)| libm::cbrt(volume(&b.shape))).collect();
        free.sort_by(f64::total_cmp);
        let (min, max) = self.model_bounds();
        let origin = self.spatial.origin;
        let s = &mut self.summary;
        s.blocks = supported.len();
        s.vertices = vertices;
        s.supported = supported.iter().filter(|held| **held).count();
        s.materials = self.spatial.materials.len();
        s.interfaces = self.spatial.interfaces.len();
        s.phases = self.plan.phases.len();
        s.origin = [origin.x, origin.y];
        s.solid_bounds = Some([(min + origin).into(), (max + origin).into()]);
        s.mass = mass;
        s.passing = passing(&free, 3);
        s.size = [sizes[0], sizes[sizes.len() / 2], sizes[sizes.len() - 1]];
    }

    fn solid_overlaps(&mut self) {
        let said = match &self.parsed.scenario.space {
            Space::Spatial(space) => space.allow_overlap.as_ref().map_or(0.0, Quantity::si),
            Space::Planar(_) => 0.0,
        };
        let blocks = self.placed(said);
        let boxes: Vec<(Vec3, Vec3)> = blocks.iter().map(|b| bounds(&b.shape)).collect();
        let hull = |b: &Placed| match &*b.shape {
            Shape::Polyhedron(_) => Some(Hull::of(&b.shape)),
            // Two bricks are their boxes; a brick among polyhedra is rare. What lies in terrain is reported by `on_terrain`.
            // Glued parts are looked at part by part.
            Shape::Brick { .. } | Shape::Terrain(_) | Shape::Glued(_) => None,
        };
        let hulls: Vec<Option<Hull>> = blocks.iter().map(hull).collect();
        let mut bad: Vec<Overlap> = Vec::new();
        let searched = deep_pairs(&boxes, said, |pair| {
            let [i, j] = pair.map(|k| k as usize);
            let hulls = [hulls[i].as_ref(), hulls[j].as_ref()];
            // Two images lie in each other as what they are images of.
            if !(blocks[i].image && blocks[j].image) {
                bad.extend(self.overlap([&blocks[i], &blocks[j]], hulls, said));
            }
            bad.len() < MOST_BAD
        });
        if searched == Search::GivenUp {
            let message =
                "not all pairs of blocks were tested for overlap: too many bounding boxes overlap";
            let note = Diagnostic::warning("geometry.overlap", message);
            self.found
                .push(note.help("check the blocks in the viewer before you rely on the model"));
        }
        bad.sort_by(|a, b| b.depth.total_cmp(&a.depth).then(a.blocks.cmp(&b.blocks)));
        if let Some(worst) = bad.first() {
            let names = worst.blocks.map(|b| self.directory.name(b));
            self.summary.deepest_overlap = Some((worst.depth, names));
        }
        let deepest = bad.first().map_or(0.0, |worst| worst.depth);
        for overlap in bad.iter().take(NAMED) {
            let [first, second] = overlap.blocks.map(|b| self.directory.name(b));
            let across = if overlap.across { " across a periodic boundary" } else { "" };
            let place = format!(
                "by {}{across} at the start, near {}",
                with_unit(overlap.depth, "m"),
                triple(overlap.at + self.spatial.origin, "m")
            );
            let span = self.table_span(overlap.blocks[1]);
            if first == second {
                let message = format!("block `{first}` overlaps itself {place}");
                let help = "make the period longer, or the block shorter";
                self.error_at("geometry.overlap", span, message, help);
                continue;
            }
            let message = format!("blocks `{first}` and `{second}` overlap {place}");
            let help = format!(
                "move one of them; or accept the overlap with allow_overlap = \"{}\" in [space.spatial] and let a first phase with kind = \"static\" \
                 separate them; if it ejects them, use a smaller `normal_stiffness`",
                with_unit(1.05 * deepest, "m")
            );
            self.error_at("geometry.overlap", span, message, help);
        }
        if bad.len() > NAMED {
            let least = if bad.len() == MOST_BAD { "at least " } else { "" };
            let message =
                format!("{least}{} more pairs of blocks overlap at the start", bad.len() - NAMED);
            self.found.push(Diagnostic::error("geometry.overlap", message));
        }
    }

    /// What may lie in others: blocks, and in periodic models that are longer than a period images of them.
    fn placed(&self, said: f64) -> Vec<Placed<'_>> {
        let blocks = &self.spatial.blocks;
        let own = |block: u32| Placed {
            block,
            shape: Cow::Borrowed(&blocks[block as usize].shape),
            image: false,
        };
        let (low, high) = self.model_bounds();
        let size = high - low;
        // How many images of a block there are along each axis on either side.
        let counts = self.spatial.periodic.map(|period| period.unwrap_or(f64::INFINITY));
        let counts = [0, 1, 2].map(|k| ((1.0 - ACCEPTED) * size[k] / counts[k]).floor() as i32);
        if counts == [0; 3] || !self.spatial.found_contacts {
            return self.doubtful(said).into_iter().map(own).collect();
        }
        let each = |k: usize| -counts[k]..=counts[k];
        let steps = each(0)
            .flat_map(|x| each(1).flat_map(move |y| each(2).map(move |z| [x, y, z])))
            .filter(|step| *step > [0; 3]);
        let shift = |step: [i32; 3]| {
            let along = |k: usize| f64::from(step[k]) * self.spatial.periodic[k].unwrap_or(0.0);
            Vec3::new(along(0), along(1), along(2))
        };
        let there = (0..blocks.len() as u32).filter(|b| !blocks[*b as usize].shape.is_terrain());
        let mut all: Vec<Placed> = there.clone().map(own).collect();
        for shift in steps.map(shift) {
            for block in there.clone() {
                let shape = &blocks[block as usize].shape;
                let (from, to) = bounds(shape);
                if (from + shift).cmple(high).all() && (to + shift).cmpge(low).all() {
                    let shape = Cow::Owned(moved(shape, shift));
                    all.push(Placed { block, shape, image: true });
                }
            }
        }
        all
    }

    /// Blocks that may lie in others: not those of a grid that no other table reaches into.
    fn doubtful(&self, said: f64) -> Vec<u32> {
        let tables: Vec<(std::ops::Range<u32>, (Vec3, Vec3), bool)> = self
            .directory
            .tables()
            // What lies in terrain is reported by `on_terrain`.
            .filter(|(_, blocks)| {
                !blocks.clone().any(|b| self.spatial.blocks[b as usize].shape.is_terrain())
            })
            .map(|(name, blocks)| {
                let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
                let shapes = blocks.clone().map(|b| &self.spatial.blocks[b as usize].shape);
                let around = shapes
                    .map(bounds)
                    .fold(start, |(low, high), (min, max)| (low.min(min), high.max(max)));
                let mut said = self.parsed.scenario.blocks.iter();
                let said = said.find(|said| said.name.as_str() == name);
                let ordered = blocks.len() == 1
                    || said.is_some_and(|b| grid_of(b).is_some() && b.copies.is_none());
                (blocks, around, ordered)
            })
            .collect();
        let boxes: Vec<(Vec3, Vec3)> = tables.iter().map(|(_, around, _)| *around).collect();
        let mut reached: Vec<bool> = tables.iter().map(|(_, _, ordered)| !ordered).collect();
        let searched = deep_pairs(&boxes, said, |pair| {
            pair.into_iter().for_each(|t| reached[t as usize] = true);
            true
        });
        if searched == Search::GivenUp {
            reached.fill(true);
        }
        let doubtful = tables.into_iter().zip(reached).filter(|(_, reached)| *reached);
        doubtful.flat_map(|((blocks, _, _), _)| blocks).collect()
    }

    /// Warns of strengths that do not act, because blocks of glued parts have no joints to the blocks that they touch.
    fn glued_without_joints(&mut self) {
        let setup = &self.spatial;
        let acts = |row: u16| {
            let strength = setup.interfaces[row as usize].joint.strength;
            strength.is_some_and(|s| s.cohesion > 0.0 || s.tension > 0.0)
        };
        let glued = |block: u32| setup.blocks[block as usize].shape.is_glued();
        let some = (0..setup.blocks.len() as u32).any(glued);
        if !some || !setup.pair_table.iter().any(|row| acts(*row)) {
            return;
        }
        let boxes: Vec<_> = setup.blocks.iter().map(|b| bounds(&b.shape)).collect();
        let meets = |pair: [u32; 2]| {
            let [(min_a, max_a), (min_b, max_b)] = pair.map(|k| boxes[k as usize]);
            let slack = ACCEPTED * (max_a - min_a).min(max_b - min_b).min_element();
            (max_a.min(max_b) - min_a.max(min_b)).min_element() >= -slack
        };
        let acts_between = |pair: [u32; 2]| {
            let [a, b] = pair.map(|k| setup.blocks[k as usize].material as usize);
            acts(setup.pair_table[a * setup.materials.len() + b])
        };
        // A little larger: two boxes with a common plane overlap then.
        let slack = |(min, max): &(Vec3, Vec3)| 3.0 * ACCEPTED * (*max - *min).min_element();
        let wider = boxes.iter().map(|b| (b.0 - slack(b), b.1 + slack(b))).collect::<Vec<_>>();
        let mut first: Vec<Option<u32>> = vec![None; boxes.len()];
        // Where it gives up, `solid_overlaps` has said that not all pairs were looked at.
        deep_pairs(&wider, 0.0, |pair| {
            let [a, b] = pair;
            for [a, b] in [[a, b], [b, a]] {
                if glued(a) && meets(pair) && acts_between([a, b]) {
                    let known = first[a as usize].get_or_insert(b);
                    *known = b.min(*known);
                }
            }
            true
        });
        let found = (0u32..).zip(first).filter_map(|(a, other)| Some([a, other?]));
        for [block, other] in found.take(NAMED).collect::<Vec<_>>() {
            let [name, other] = [block, other].map(|b| self.directory.name(b));
            let message = format!(
                "cohesion and tension do not act between `{name}` and `{other}`, which touch at the start: blocks of glued parts have no joints"
            );
            let help = "they interact by contact with the residual strength of their interface";
            self.warn_at("geometry.parts", self.table_span(block), message, help);
        }
    }

    /// How deep two blocks lie in each other, if that is too deep.
    fn overlap(
        &self,
        placed: [&Placed; 2],
        hulls: [Option<&Hull>; 2],
        said: f64,
    ) -> Option<Overlap> {
        let ([i, j], [a, b]) = (placed.map(|p| p.block), placed.map(|p| &*p.shape));
        let ((min_a, max_a), (min_b, max_b)) = (bounds(a), bounds(b));
        let (low, high) = (min_a.max(min_b), max_a.min(max_b));
        let accepted = said.max(ACCEPTED * libm::cbrt(volume(a).min(volume(b))));
        let mut depth = (high - low).min_element();
        let both_bricks = matches!((a, b), (Shape::Brick { .. }, Shape::Brick { .. }));
        if depth > accepted && !both_bricks {
            let [first, second] = hulls;
            let apart = match (first, second) {
                (Some(first), Some(second)) => {
                    first.is_beyond(second, accepted) || second.is_beyond(first, accepted)
                }
                (Some(_), None) | (None, Some(_)) | (None, None) => false,
            };
            if apart {
                return None;
            }
            let (ours, theirs) = (convex_parts(a), convex_parts(b));
            let widths = ours.iter().flat_map(|a| theirs.iter().map(|b| common_width(a, b)));
            depth = depth.min(widths.fold(0.0, f64::max));
        }
        // What is held may lie in other blocks that are, but no block can be longer than the period.
        let held = i != j && self.held(i) && self.held(j);
        (depth > accepted && !held).then(|| Overlap {
            depth,
            blocks: [i.min(j), i.max(j)],
            across: placed.iter().any(|p| p.image),
            at: 0.5 * (low + high),
        })
    }

    /// Place of the table that made a block.
    pub(in crate::model) fn table_span(&self, block: u32) -> Span {
        let table = self.directory.table(block);
        let mut blocks = self.parsed.scenario.blocks.iter();
        blocks.find(|said| said.name.as_str() == table).map_or(0..0, |said| said.name.span.clone())
    }

    /// Whether a condition or fixed blocks take the stress on a side of the model.
    pub(in crate::model) fn carried(&self, normal: Vec3, offset: f64) -> bool {
        let by_condition = self.spatial.boundaries.iter().any(|boundary| {
            let holds = match boundary.kind {
                BoundaryKind::Held { normal, .. } => normal,
                BoundaryKind::Moved { .. } | BoundaryKind::Viscous { .. } => false,
                BoundaryKind::Traction { .. } => false,
            };
            let here = match &boundary.on {
                FaceSet::Plane { normal: n, offset: d } => {
                    n.dot(normal) > 1.0 - 1e-9 && (d - offset).abs() <= 1e-6 * offset.abs().max(1.0)
                }
                FaceSet::Surface { planes, .. } => planes.iter().any(|(n, d)| {
                    n.dot(normal) > 1.0 - 1e-9 && (d - offset).abs() <= 1e-6 * offset.abs().max(1.0)
                }),
                // Faces of single blocks and boxes may add up to a side; the engine knows.
                FaceSet::Blocks { normal: n, .. } | FaceSet::Box { normal: n, .. } => {
                    n.is_none_or(|n| n.dot(normal) > 1.0 - 1e-9)
                }
            };
            here && (boundary.in_situ || holds || loaded(&boundary.kind))
        });
        if by_condition {
            return true;
        }
        let mut side = (0u32..).zip(&self.spatial.blocks).filter(|(_, block)| {
            if block.shape.is_terrain() {
                return false;
            }
            let (min, max) = bounds(&block.shape);
            let reach = if normal.max_element() > 0.5 { normal.dot(max) } else { normal.dot(min) };
            (reach - offset).abs() <= 1e-6 * (max - min).max_element()
        });
        side.all(|(block, _)| self.held(block))
    }

    fn solid_motion(&mut self) {
        let all_held = (0..self.spatial.blocks.len() as u32).all(|block| self.held(block));
        let released = self.plan.phases.iter().any(|p| !p.release.is_empty());
        if all_held && !released {
            let message = "all blocks are fixed; nothing can move";
            let note = Diagnostic::warning("model.fixed", message);
            self.found.push(note.help("check [[supports]]"));
        }
    }
}

/// Whether a face condition is a load that the user may mean as the stress from outside.
fn loaded(kind: &BoundaryKind) -> bool {
    match kind {
        BoundaryKind::Traction { traction, pressure, gradient, .. } => {
            *traction != Vec3::ZERO || *pressure != 0.0 || *gradient != 0.0
        }
        BoundaryKind::Held { .. } | BoundaryKind::Moved { .. } | BoundaryKind::Viscous { .. } => {
            false
        }
    }
}

/// Corners and outward planes of a convex block: most of those whose boxes overlap lie on both sides of a face.
struct Hull {
    vertices: Vec<Vec3>,
    planes: Vec<(Vec3, f64)>,
}

impl Hull {
    fn of(shape: &Shape) -> Self {
        let solid = solid(shape);
        let planes = (0..solid.faces.len()).map(|face| solid.plane(face));
        Hull { planes: planes.collect(), vertices: solid.vertices }
    }

    /// Whether a face of this one has the other one on its other side, to within a depth (m).
    fn is_beyond(&self, other: &Hull, depth: f64) -> bool {
        self.planes.iter().any(|(normal, offset)| {
            let mut heights = other.vertices.iter().map(|v| normal.dot(*v) - offset);
            heights.all(|height| height >= -depth)
        })
    }
}

/// How a search for pairs ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Search {
    /// All pairs were found, or as many as were wanted.
    Done,
    /// There were too many to look at.
    GivenUp,
}

/// Calls `found` with pairs of boxes that overlap by more than their allowance, by a sweep along x, until it is false.
fn deep_pairs(
    boxes: &[(Vec3, Vec3)],
    said: f64,
    mut found: impl FnMut([u32; 2]) -> bool,
) -> Search {
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    let low = |k: u32| boxes[k as usize].0.x;
    order.sort_by(|&a, &b| low(a).total_cmp(&low(b)).then(a.cmp(&b)));
    let allowance = |k: u32| {
        let (min, max) = boxes[k as usize];
        said.max(ACCEPTED * (max - min).min_element())
    };
    // A little smaller, so that neighbours that only touch do not meet in a bin.
    let all = 0..boxes.len() as u32;
    let shrink = 0.25 * all.map(allowance).fold(f64::INFINITY, f64::min);
    // Columns across the sweep keep the lists short: y and z are sorted into bins of the largest box.
    let start = (Vec3::INFINITY, Vec3::NEG_INFINITY, Vec3::ZERO);
    let (floor, top, widest) = boxes.iter().fold(start, |(low, high, wide), (min, max)| {
        (low.min(*min), high.max(*max), wide.max(*max - *min))
    });
    let bins = |k: usize| {
        let count = (top[k] - floor[k]) / widest[k].max(f64::MIN_POSITIVE);
        (count.clamp(1.0, 2000.0) as usize).max(1)
    };
    let (ny, nz) = (bins(1), bins(2));
    let bin = |x: f64, k: usize, n: usize| {
        let share = (x - floor[k]) / (top[k] - floor[k]).max(f64::MIN_POSITIVE);
        ((share * n as f64) as usize).min(n - 1)
    };
    let mut open: Vec<Vec<u32>> = vec![Vec::new(); ny * nz];
    let mut looks = 0;
    for &b in &order {
        let (min, max) = boxes[b as usize];
        let (inner, outer) = (min + shrink, max - shrink);
        for row in bin(inner.y, 1, ny)..=bin(outer.y, 1, ny) {
            for column in bin(inner.z, 2, nz)..=bin(outer.z, 2, nz) {
                let list = &mut open[row * nz + column];
                list.retain(|&a| boxes[a as usize].1.x > min.x + allowance(b));
                looks += list.len();
                for &a in list.iter() {
                    let (other_min, other_max) = boxes[a as usize];
                    let depth = (max.min(other_max) - min.max(other_min)).min_element();
                    // A pair in several bins is taken in the bin of its common corner.
                    let corner = min.max(other_min) + shrink;
                    let own = (bin(corner.y, 1, ny), bin(corner.z, 2, nz)) == (row, column);
                    if own && depth > allowance(a).min(allowance(b)) && !found([a.min(b), a.max(b)])
                    {
                        return Search::Done;
                    }
                }
                list.push(b);
            }
        }
        if looks > MOST_LOOKS {
            return Search::GivenUp;
        }
    }
    Search::Done
}

/// The convex parts of a shape.
fn convex_parts(shape: &Shape) -> Vec<Polyhedron> {
    match shape {
        Shape::Glued(parts) => parts.iter().map(Solid::polyhedron).collect(),
        Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Terrain(_) => vec![solid(shape)],
    }
}

/// Smallest width along the coordinate axes and the face normals of what two convex shapes share, m; 0
/// if they share no volume.
fn common_width(a: &Polyhedron, other: &Polyhedron) -> f64 {
    let mut rest = a.clone();
    let mut normals = vec![Vec3::X, Vec3::Y, Vec3::Z];
    normals.extend((0..rest.faces.len()).map(|face| rest.plane(face).0));
    for face in 0..other.faces.len() {
        let (normal, offset) = other.plane(face);
        normals.push(normal);
        match slice(&rest, normal, offset) {
            Sliced::Whole => {}
            Sliced::Nothing => return 0.0,
            Sliced::Part(part) => rest = part,
        }
    }
    let width = |n: &Vec3| {
        let along = rest.vertices.iter().map(|v| v.dot(*n));
        let (low, high) =
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    normals.iter().map(width).fold(f64::INFINITY, f64::min)
}
