//! Points of a facet: the area overlay of two faces, hung on nodes or on rigid blocks.

use riprap_geom::Vec3;
use riprap_geom::face_overlay::{self, Fan, JointPoint};
use riprap_geom::polyhedron::Tetrahedra;

use crate::faces::deformable::{centred, face_of, face_with};
use crate::faces::overlap::Overlap;
use crate::state::anchor::Anchor;
use crate::state::deform::{Deform, Point};
use crate::state::workspace::BlockClass;
use crate::state::world::World;

/// Share of the overlap below which faces share nothing.
const SLIVER: f64 = 1e-9;

/// The points of the overlap of two faces, at least one of them on a deformable block.
#[must_use]
pub fn points(
    world: &World,
    deform: &Deform,
    classes: &[BlockClass],
    overlap: &Overlap,
) -> Vec<Point> {
    let n = overlap.frame[0];
    // Of the image in a periodic model the arms tell the shift.
    let centres = [0, 1].map(|s| world.reference[overlap.blocks[s] as usize] + overlap.arms[s]);
    let shifts = [Vec3::ZERO, centres[0] - centres[1]];
    let fan = |side: usize| {
        let outward = if side == 0 { n } else { -n };
        let block = overlap.blocks[side] as usize;
        let fan = fan(world, deform, classes, block, outward, overlap.arms[side]);
        let mut fan = fan?;
        fan.at.iter_mut().for_each(|at| *at += shifts[side]);
        Some(fan)
    };
    // Rigid blocks were checked when they were built; one too thin for a fan has no points.
    let (Some(a), Some(b)) = (fan(0), fan(1)) else {
        return Vec::new();
    };
    let rigid = overlap.blocks.map(|b| deform.body(b as usize).is_none());
    let joints = face_overlay::overlay(&a, &b, n, SLIVER * overlap.area);
    hang(world, (overlap.blocks, rigid), shifts[1], &joints)
}

/// Points of a facet between two blocks, rigid or not, at the points of an overlay on the side of A; B is an image moved by `shift` (m).
pub(crate) fn hang(
    world: &World,
    (blocks, rigid): ([u32; 2], [bool; 2]),
    shift: Vec3,
    joints: &[JointPoint],
) -> Vec<Point> {
    let anchor = |joint: &JointPoint, side: usize| {
        if rigid[side] {
            let back = if side == 0 { Vec3::ZERO } else { shift };
            // On B it is where the block is itself, not its image.
            let arm = joint.at - back - world.reference[blocks[side] as usize];
            return Anchor::Block { block: blocks[side], arm };
        }
        let face_overlay::Anchor { nodes, weights, .. } = joint.sides[side];
        Anchor::Nodes { nodes, weights }
    };
    let point = |j: &JointPoint| Point { anchors: [anchor(j, 0), anchor(j, 1)], area: j.area };
    joints.iter().map(point).collect()
}

/// Fan of the face of a block with an outward normal, near `arm` (m from the centroid); places in the local frame, nodes of
/// the world's list where the block is deformable.
fn fan(
    world: &World,
    deform: &Deform,
    classes: &[BlockClass],
    block: usize,
    outward: Vec3,
    arm: Vec3,
) -> Option<Fan> {
    let Some(body) = deform.body(block) else {
        return rigid_fan(world, block, outward, arm);
    };
    let class = &classes[body.class as usize];
    let face = face_of(class, outward, arm);
    let centroid = deform.nodes.place[body.nodes().end - 1];
    Some(moved(class.mesh.face_fan(face), centroid, body.first))
}

/// The same of a rigid block.
pub(crate) fn rigid_fan(world: &World, block: usize, outward: Vec3, arm: Vec3) -> Option<Fan> {
    let (solid, centroid) = centred(&world.setup.blocks[block].shape);
    let mesh = Tetrahedra::new(&solid).ok()?;
    let face = face_with(&mesh, solid.faces.len(), outward, arm);
    Some(moved(mesh.face_fan(face), centroid, 0))
}

/// A fan in another place, with nodes counted from `first`.
pub(crate) fn moved(mut fan: Fan, by: Vec3, first: u32) -> Fan {
    fan.at.iter_mut().for_each(|at| *at += by);
    fan.nodes.iter_mut().for_each(|n| *n += first);
    fan
}
