//! Points of a facet: the area overlay of two faces, hung on nodes or on rigid blocks.

use riprap_geom::Vec3;
use riprap_geom::face_overlay::{self, Fan};
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
    face_overlay::overlay(&a, &b, n, SLIVER * overlap.area)
        .into_iter()
        .map(|point| {
            let anchor = |side: usize| {
                if rigid[side] {
                    let centroid = world.reference[overlap.blocks[side] as usize];
                    Anchor::Block {
                        block: overlap.blocks[side],
                        arm: point.at - shifts[side] - centroid,
                    }
                } else {
                    Anchor::Nodes {
                        nodes: point.sides[side].nodes,
                        weights: point.sides[side].weights,
                    }
                }
            };
            Point { anchors: [anchor(0), anchor(1)], area: point.area }
        })
        .collect()
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
    let (mut fan, centroid, first) = match deform.body(block) {
        Some(body) => {
            let class = &classes[body.class as usize];
            let face = face_of(class, outward, arm);
            let centroid = deform.nodes.place[body.nodes().end - 1];
            (class.mesh.face_fan(face), centroid, body.first)
        }
        None => {
            let (solid, centroid) = centred(&world.setup.blocks[block].shape);
            let mesh = Tetrahedra::new(&solid).ok()?;
            let face = face_with(&mesh, solid.faces.len(), outward, arm);
            (mesh.face_fan(face), centroid, 0)
        }
    };
    fan.at.iter_mut().for_each(|at| *at += centroid);
    fan.nodes.iter_mut().for_each(|node| *node += first);
    Some(fan)
}
