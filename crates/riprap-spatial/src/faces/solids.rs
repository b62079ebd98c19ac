//! Where convex polyhedra (and bricks among them) touch: polygons shared by opposite faces, and what is left of
//! the faces.
//!
//! Two faces touch when they lie in one plane back to back. What is left of a face enters by
//! its area, centroid and second moments, which is all that four points of a boundary need.

use riprap_geom::face_overlap::{self, face_overlap};
use riprap_geom::polyhedron::{Polyhedron, area_vector, frame};
use riprap_geom::{Mat3, Vec3};

use crate::exec::Exec;
use crate::faces::overlap::{Overlap, axis_frame};
use crate::faces::region::Extent;
use crate::kernel::grid::{Box3, Grid, Role};
use crate::setup::BlockSpec;
use crate::state::face::Face;

/// Largest sine between opposite faces that touch.
const PARALLEL: f64 = 1e-6;
/// Share of a face below which an overlap, or what is left, does not count.
const SLIVER: f64 = 1e-9;

/// One face of a block, or its image in a periodic model.
struct Side {
    block: u32,
    outline: Vec<Vec3>,
    normal: Vec3,
    min: Vec3,
    max: Vec3,
    /// What the image is shifted by, m; zero for the face itself.
    shift: Vec3,
    /// The whole face.
    whole: face_overlap::Overlap,
    /// Number of the face itself.
    face: usize,
}

/// Finds all shared polygons and free parts of the faces of the blocks `chosen`, whose centroids are
/// `reference`; `tolerance` (m) is the largest gap between faces that touch.
#[must_use]
pub(crate) fn meet_solids(
    blocks: &[BlockSpec],
    chosen: &[u32],
    reference: &[Vec3],
    periodic: [Option<f64>; 3],
    tolerance: f64,
) -> (Vec<Overlap>, Vec<Face>) {
    let sides = sides(blocks, chosen, periodic, tolerance);
    let count = sides.iter().filter(|s| s.shift == Vec3::ZERO).count();
    let mut covered: Vec<Vec<face_overlap::Overlap>> = vec![Vec::new(); count];
    let mut overlaps = Vec::new();
    each_touch(&sides, tolerance, |pair, shared| {
        overlaps.push(joined(pair, &shared, reference));
        let mut back = shared.clone();
        back.centroid -= pair[1].shift;
        covered[pair[0].face].push(shared);
        covered[pair[1].face].push(back);
    });
    overlaps.sort_by_key(|o| o.blocks);
    let originals = sides.iter().filter(|s| s.shift == Vec3::ZERO);
    let free = originals.filter_map(|s| left(s, &covered[s.face], reference));
    (overlaps, free.collect())
}

/// The shared polygons alone, in a model that is not periodic: blocks, and corners anticlockwise seen from the side of the second one (m).
#[must_use]
pub(crate) fn outlines(
    blocks: &[BlockSpec],
    chosen: &[u32],
    tolerance: f64,
) -> Vec<([u32; 2], Vec<Vec3>)> {
    let sides = sides(blocks, chosen, [None; 3], tolerance);
    let mut outlines = Vec::new();
    each_touch(&sides, tolerance, |[a, b], shared| {
        outlines.push(([a.block, b.block], shared.outline));
    });
    outlines
}

/// Calls `found` with all faces that touch and the polygon that they share.
fn each_touch(
    sides: &[Side],
    tolerance: f64,
    mut found: impl FnMut([&Side; 2], face_overlap::Overlap),
) {
    // Along x, which is the order of the sums: pairs by their farther face, then by the nearer one.
    let mut order: Vec<usize> = (0..sides.len()).collect();
    order.sort_by(|&a, &b| sides[a].min.x.total_cmp(&sides[b].min.x).then(a.cmp(&b)));
    let boxes: Vec<Box3> = order
        .iter()
        .map(|&k| Box3 { low: sides[k].min, high: sides[k].max + Vec3::splat(tolerance) })
        .collect();
    let apart = |a: u32, b: u32| {
        let [a, b] = [a, b].map(|k| &sides[order[k as usize]]);
        !back_to_back([a, b])
    };
    let seekers = vec![Role::Active; boxes.len()];
    let mut grid = Grid::default();
    let mut pairs = grid.close_pairs(&boxes, &seekers, apart, &Exec::serial()).to_vec();
    pairs.sort_unstable_by_key(|&[a, b]| [b, a]);
    for pair in pairs {
        let [a, b] = pair.map(|k| order[k as usize]);
        // The lower number first, the image last.
        let key = |k: usize| (sides[k].shift != Vec3::ZERO, sides[k].block, k);
        let (first, second) = if key(a) < key(b) { (a, b) } else { (b, a) };
        let pair = [&sides[first], &sides[second]];
        if let Some(shared) = touch(pair, tolerance) {
            found(pair, shared);
        }
    }
}

/// All faces, then the images of those at the lower end of a periodic axis.
fn sides(
    blocks: &[BlockSpec],
    chosen: &[u32],
    periodic: [Option<f64>; 3],
    tolerance: f64,
) -> Vec<Side> {
    let mut sides = Vec::new();
    for &block in chosen {
        let shape = &blocks[block as usize].shape;
        if shape.is_terrain() {
            continue;
        }
        let solid = Extent::of(shape).solid(Vec3::ZERO);
        for face in 0..solid.faces.len() {
            let outline = solid.outline(face);
            let (normal, _) = solid.plane(face);
            if let Some(whole) = face_overlap(&outline, &outline, normal, 0.0) {
                let face = sides.len();
                sides.push(Side::new(block, outline, normal, Vec3::ZERO, whole, face));
            }
        }
    }
    let lowest = sides.iter().fold(Vec3::MAX, |m, s| m.min(s.min));
    for (axis, period) in periodic.into_iter().enumerate() {
        let Some(period) = period else { continue };
        let shift = period * Vec3::AXES[axis];
        let at_end = |s: &Side| s.shift == Vec3::ZERO && s.max[axis] - lowest[axis] <= tolerance;
        let images: Vec<Side> = sides
            .iter()
            .filter(|s| at_end(s))
            .map(|s| {
                let outline = s.outline.iter().map(|p| *p + shift).collect();
                Side::new(s.block, outline, s.normal, shift, s.whole.clone(), s.face)
            })
            .collect();
        sides.extend(images);
    }
    sides
}

impl Side {
    fn new(
        block: u32,
        outline: Vec<Vec3>,
        normal: Vec3,
        shift: Vec3,
        whole: face_overlap::Overlap,
        face: usize,
    ) -> Self {
        let min = outline.iter().fold(Vec3::MAX, |m, p| m.min(*p));
        let max = outline.iter().fold(Vec3::MIN, |m, p| m.max(*p));
        Self { block, outline, normal, min, max, shift, whole, face }
    }
}

/// Whether two faces lie back to back, not both of them images: their planes are parallel.
fn back_to_back([a, b]: [&Side; 2]) -> bool {
    let images = a.shift != Vec3::ZERO && b.shift != Vec3::ZERO;
    !images && (a.normal + b.normal).length() <= PARALLEL
}

/// Shared polygon of two faces whose planes are parallel, where they lie in one plane; its normal is that of the first.
fn touch([a, b]: [&Side; 2], tolerance: f64) -> Option<face_overlap::Overlap> {
    let gap = a.normal.dot(b.whole.centroid + b.shift - a.whole.centroid - a.shift);
    if gap.abs() > tolerance {
        return None;
    }
    let smallest = SLIVER * a.whole.area.min(b.whole.area);
    face_overlap(&a.outline, &b.outline, a.normal, smallest)
}

/// Whether a face of one solid and a face of another lie back to back, nowhere farther apart than `gap` (m), and share a part.
#[must_use]
pub(crate) fn share_face(a: &Polyhedron, b: &Polyhedron, gap: f64) -> bool {
    let whole = |solid: &Polyhedron, face: usize| {
        let outline = solid.outline(face);
        let (normal, offset) = solid.plane(face);
        (outline, normal, offset)
    };
    let others: Vec<_> = (0..b.faces.len()).map(|face| whole(b, face)).collect();
    (0..a.faces.len()).any(|face| {
        let (outline, normal, offset) = whole(a, face);
        others.iter().any(|(other, back, behind)| {
            if (normal + *back).length() > PARALLEL || (offset + behind).abs() > gap {
                return false;
            }
            let area = |outline: &[Vec3]| area_vector(outline).length();
            let smallest = SLIVER * area(&outline).min(area(other));
            face_overlap(&outline, other, normal, smallest).is_some()
        })
    })
}

/// The overlap in the terms of the engine; along an axis block i lies on the lower side.
fn joined(pair: [&Side; 2], shared: &face_overlap::Overlap, reference: &[Vec3]) -> Overlap {
    let mut sides = pair;
    let mut axes = frame_of(shared);
    let normal = axes[0];
    if axes[0].min_element() == -1.0 {
        sides.reverse();
        axes = [-axes[0], axes[2], axes[1]];
    }
    let reversed = axes[0] != normal;
    let mut gyration = shared.gyration;
    if reversed {
        gyration.reverse();
    }
    let axis = (0..3).find(|&k| axes == axis_frame(k)).unwrap_or(3);
    Overlap {
        blocks: sides.map(|s| s.block),
        frame: axes,
        axis: axis as u8,
        arms: sides.map(|s| shared.centroid - s.shift - reference[s.block as usize]),
        area: shared.area,
        gyration,
    }
}

/// Frame of an overlap. Where all axes in its plane are principal, b follows the longest edge: the points then turn with
/// the model.
fn frame_of(shared: &face_overlap::Overlap) -> [Vec3; 3] {
    let [n, b, c] = shared.frame;
    let [g, h] = shared.gyration;
    if (g - h).abs() > 1e-9 * (g + h) {
        return shared.frame;
    }
    let corners = &shared.outline;
    let edges = (0..corners.len()).map(|k| corners[(k + 1) % corners.len()] - corners[k]);
    // The first of those that are longest up to round-off.
    let longest = edges.clone().map(Vec3::length).fold(0.0, f64::max);
    let edge = edges.into_iter().find(|e| e.length() >= (1.0 - 1e-9) * longest).unwrap_or(b);
    let along = (edge - n * n.dot(edge)).normalize_or(b);
    if along.dot(b).abs().max(along.dot(c).abs()) > 1.0 - 1e-12 {
        return shared.frame;
    }
    [n, along, n.cross(along)]
}

/// What is left of a face: area, centroid and second moments of the whole less those of what is covered.
fn left(side: &Side, covered: &[face_overlap::Overlap], reference: &[Vec3]) -> Option<Face> {
    let whole = &side.whole;
    let outer = |v: Vec3| Mat3::from_cols(v.x * v, v.y * v, v.z * v);
    let second = |o: &face_overlap::Overlap| {
        let [_, b, c] = o.frame;
        let own =
            o.gyration[0] * o.gyration[0] * outer(b) + o.gyration[1] * o.gyration[1] * outer(c);
        o.area * (own + outer(o.centroid - whole.centroid))
    };
    let (mut area, mut first, mut moments) = (whole.area, Vec3::ZERO, second(whole));
    for part in covered {
        area -= part.area;
        first -= part.area * (part.centroid - whole.centroid);
        moments -= second(part);
    }
    if area <= SLIVER * whole.area {
        return None;
    }
    let n = side.normal;
    let [_, e, f] = if covered.is_empty() { frame_of(whole) } else { frame(n) };
    // In the plane, about the centroid of what is left.
    let offset = first / area;
    let offset = offset - n * n.dot(offset);
    let own = (1.0 / area) * moments - outer(offset);
    let (xx, yy, xy) = (e.dot(own * e), f.dot(own * f), e.dot(own * f));
    let turned = xy.abs() > 1e-12 * (xx + yy);
    let angle = if turned { 0.5 * libm::atan2(2.0 * xy, xx - yy) } else { 0.0 };
    let (s, c) = libm::sincos(angle);
    let along = c * e + s * f;
    let first_moment = c * c * xx + 2.0 * s * c * xy + s * s * yy;
    let radii = [first_moment, xx + yy - first_moment].map(|m| m.max(0.0).sqrt());
    Some(Face {
        block: side.block,
        boundary: None,
        frame: [n, along, n.cross(along)],
        arm: whole.centroid + offset - reference[side.block as usize],
        area,
        half_spacing: radii,
        half_block: None,
        parted: false,
    })
}
