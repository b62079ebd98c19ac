//! Shared and free parts of faces, in the reference configuration.

use riprap_geom::Vec3;

use crate::faces::bricks;
use crate::faces::bricks::{Cell, Free, Rectangle, Shared};
use crate::faces::solids;
use crate::faces::solids::meet_solids;
use crate::setup::Shape;
use crate::state::face::Face;
use crate::state::world::World;

/// Largest gap between faces that touch, over the shortest half edge of all blocks.
pub(crate) const GAP: f64 = 1e-6;

/// Two blocks that share a part of a face, in the reference configuration.
#[derive(Clone, Copy, Debug)]
pub struct Overlap {
    /// Blocks i and j.
    pub blocks: [u32; 2],
    /// Unit vectors n (from i to j), b and c: right-handed, b and c principal axes of the part.
    pub frame: [Vec3; 3],
    /// Axis of the normal, 0 to 2, with b and c the next two axes; 3 for any other direction.
    pub axis: u8,
    /// Centre of the part from the centroids of i and j, m.
    pub arms: [Vec3; 2],
    /// Area, m².
    pub area: f64,
    /// Radii of gyration of the part along b and along c, m.
    pub gyration: [f64; 2],
}

impl Overlap {
    /// Centre in the reference configuration, m.
    #[must_use]
    pub(crate) fn centre(&self, reference: &[Vec3]) -> Vec3 {
        reference[self.blocks[0] as usize] + self.arms[0]
    }

    /// The same part seen from the other block.
    #[must_use]
    pub(crate) fn reversed(&self) -> Self {
        let ([i, j], [n, b, c]) = (self.blocks, self.frame);
        let ([arm_i, arm_j], [along_b, along_c]) = (self.arms, self.gyration);
        Self {
            blocks: [j, i],
            // Right-handed again with b and c exchanged; no longer that of an axis, which has its normal up it.
            frame: [-n, c, b],
            axis: 3,
            arms: [arm_j, arm_i],
            gyration: [along_c, along_b],
            ..*self
        }
    }

    /// The part as a free face of its block number `side` (0 or 1).
    #[must_use]
    pub(crate) fn side(&self, side: usize) -> Face {
        let of = if side == 0 { *self } else { self.reversed() };
        plain(of.blocks[0], of.frame, of.arms[0], of.area, of.gyration)
    }
}

/// A free face without condition.
fn plain(block: u32, frame: [Vec3; 3], arm: Vec3, area: f64, gyration: [f64; 2]) -> Face {
    Face {
        block,
        boundary: None,
        frame,
        arm,
        area,
        half_spacing: gyration,
        half_block: None,
        parted: false,
    }
}

/// Shared parts and free parts of the faces of the blocks `chosen`; `tolerance` (m) is the largest gap between faces that touch.
pub(crate) fn touching(world: &World, chosen: &[u32], tolerance: f64) -> (Vec<Overlap>, Vec<Face>) {
    let (blocks, periodic) = (&world.setup.blocks, world.setup.periodic);
    // Glued parts have neither joints nor free faces.
    let plain: Vec<u32>;
    let chosen = if chosen.iter().any(|b| world.is_glued(*b as usize)) {
        plain = (chosen.iter().copied()).filter(|b| !world.is_glued(*b as usize)).collect();
        &plain[..]
    } else {
        chosen
    };
    let Some(cells) = cells(world, chosen) else {
        return meet_solids(blocks, chosen, &world.reference, periodic, tolerance);
    };
    let (shared, free) = bricks::meet(&cells, periodic, tolerance);
    let overlaps = shared.iter().map(|s| overlap(&cells, s)).collect();
    (overlaps, free.iter().map(|f| face(&cells, f)).collect())
}

/// Blocks that share a part of a face, and its corners, anticlockwise seen from the second one (m); not in periodic models.
pub(crate) fn outlines(
    world: &World,
    chosen: &[u32],
    tolerance: f64,
) -> Vec<([u32; 2], Vec<Vec3>)> {
    let Some(cells) = cells(world, chosen) else {
        return solids::outlines(&world.setup.blocks, chosen, tolerance);
    };
    let (shared, _) = bricks::meet(&cells, [None; 3], tolerance);
    let outline = |s: &Shared| {
        let (low, [b, c]) = (&cells[s.low], [1, 2].map(|k| (s.axis + k) % 3));
        let Rectangle { min, max } = s.part;
        let corners = [[min[0], min[1]], [max[0], min[1]], [max[0], max[1]], [min[0], max[1]]];
        let place = |[x, y]: [f64; 2]| {
            let mut at = Vec3::ZERO;
            at[s.axis] = low.centre[s.axis] + low.half[s.axis];
            (at[b], at[c]) = (x, y);
            at
        };
        ([low.block, cells[s.high].block], corners.map(place).to_vec())
    };
    shared.iter().map(outline).collect()
}

/// The blocks as boxes along the axes; `None` if one of them is none.
fn cells(world: &World, chosen: &[u32]) -> Option<Vec<Cell>> {
    let cell = |&block: &u32| match world.setup.blocks[block as usize].shape {
        Shape::Brick { .. } => Some(Cell {
            block,
            centre: world.reference[block as usize],
            half: world.solid_of(block as usize).half,
        }),
        Shape::Polyhedron(_) | Shape::Glued(_) | Shape::Terrain(_) => None,
    };
    chosen.iter().map(cell).collect()
}

/// Axis frame: normal along `axis`, b and c the next two axes.
#[must_use]
pub(crate) fn axis_frame(axis: usize) -> [Vec3; 3] {
    [0, 1, 2].map(|k| Vec3::AXES[(axis + k) % 3])
}

/// The overlap of two cells.
fn overlap(cells: &[Cell], shared: &Shared) -> Overlap {
    let (low, high, axis) = (&cells[shared.low], &cells[shared.high], shared.axis);
    let [length_b, length_c] = shared.part.size();
    let to = |cell: &Cell, sign: f64| arm(cell, axis, sign, &shared.part);
    Overlap {
        blocks: [low.block, high.block],
        frame: axis_frame(axis),
        axis: axis as u8,
        arms: [to(low, 1.0), to(high, -1.0)],
        area: length_b * length_c,
        gyration: [length_b / 12f64.sqrt(), length_c / 12f64.sqrt()],
    }
}

/// From the centroid of a cell to the centre of a part of its face.
fn arm(cell: &Cell, axis: usize, sign: f64, part: &Rectangle) -> Vec3 {
    let [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
    let mut arm = Vec3::ZERO;
    arm[axis] = sign * cell.half[axis];
    arm[b] = part.centre()[0] - cell.centre[b];
    arm[c] = part.centre()[1] - cell.centre[c];
    arm
}

/// A free part of a face.
fn face(cells: &[Cell], free: &Free) -> Face {
    let cell = &cells[free.cell];
    let [length_b, length_c] = free.part.size();
    let [n, b, c] = axis_frame(free.axis);
    let sign = if free.upward { 1.0 } else { -1.0 };
    let frame = if free.upward { [n, b, c] } else { [-n, c, b] };
    let mut reach = [length_b / 12f64.sqrt(), length_c / 12f64.sqrt()];
    if !free.upward {
        reach.swap(0, 1);
    }
    let arm = arm(cell, free.axis, sign, &free.part);
    plain(cell.block, frame, arm, length_b * length_c, reach)
}

/// The free face that patch `p` leaves on its block number `side` (0 or 1) when the other block goes.
pub(crate) fn bare(world: &World, p: usize, side: usize) -> Face {
    let class = &world.classes[world.patches.class[p] as usize];
    let [n, b, c] = class.frame;
    let joint = &world.setup.interfaces[class.row as usize].joint;
    let mut reach = class.half_spacing.map(|r| r / joint.points.spread());
    if side == 1 {
        reach.swap(0, 1);
    }
    let frame = if side == 0 { [n, b, c] } else { [-n, c, b] };
    let block = world.patches.ends[p][side];
    plain(block, frame, class.arms[side], class.area, reach)
}
