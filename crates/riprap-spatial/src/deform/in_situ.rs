//! Deformable blocks under the stress of the rock from the start.
//!
//! Each tetrahedron has the in-situ stress at its centroid as start stress, which for a stress linear in z is exact:
//! `V sigma(c) g_k` is the integral of `sigma g_k`. Tractions on faces are lumped to nodes, so that a traction linear in z
//! must be taken where it has its mean over the share of the node ([`levers`]); then stress, tractions and weight are in
//! balance at every node.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;

use crate::faces::deformable::face_of;
use crate::faces::overlap::Overlap;
use crate::laws::bond::Traction;
use crate::setup::InSitu;
use crate::state::deform::{Deform, Point, Start};
use crate::state::workspace::BlockClass;
use crate::state::world::World;

/// Start stresses of a block with the centroid `centre` (m, local).
#[must_use]
pub fn start(in_situ: &InSitu, mesh: &Tetrahedra, centre: Vec3) -> Start {
    let stress = |nodes: &[u32; 4]| {
        let sum: f64 = nodes.iter().map(|n| mesh.nodes[*n as usize].z).sum();
        let s = in_situ.at(centre.z + 0.25 * sum);
        let [x, y, z] = [s.x_axis, s.y_axis, s.z_axis];
        [x.x, y.y, z.z, y.z, z.x, x.y]
    };
    Start { stresses: mesh.tets.iter().map(stress).collect(), energy: 0.0 }
}

/// Places (from the centroid, m) at which a linear field has its mean weighted with the shape function of each node of a
/// face, triangle by triangle: `(2 x_i + x_j + x_k)/4`, by area.
#[must_use]
pub fn levers(mesh: &Tetrahedra, face: usize) -> BTreeMap<u32, Vec3> {
    let mut sums: BTreeMap<u32, (Vec3, f64)> = BTreeMap::new();
    for triangle in mesh.fan(face) {
        let [m, a, b] = triangle.map(|k| mesh.nodes[k as usize]);
        let area = (a - m).cross(b - m).length();
        for (node, at) in triangle.into_iter().zip([m, a, b]) {
            let sum = sums.entry(node).or_insert((Vec3::ZERO, 0.0));
            sum.0 += 0.25 * area * (m + a + b + at);
            sum.1 += area;
        }
    }
    let mean = |(node, (sum, area)): (u32, (Vec3, f64))| (node, sum / area);
    sums.into_iter().map(mean).collect()
}

/// Tractions (n, b, c, Pa) of the points of a facet at zero jump.
#[must_use]
pub fn tractions(
    world: &World,
    deform: &Deform,
    classes: &[BlockClass],
    overlap: &Overlap,
    points: &[Point],
) -> Vec<Traction> {
    let Some(in_situ) = &world.setup.in_situ else {
        return vec![[0.0; 3]; points.len()];
    };
    let n = overlap.frame[0];
    let side = usize::from(deform.body(overlap.blocks[0] as usize).is_none());
    let Some(body) = deform.body(overlap.blocks[side] as usize) else {
        return vec![[0.0; 3]; points.len()];
    };
    let outward = if side == 0 { n } else { -n };
    let mesh = &classes[body.class as usize].mesh;
    let face = face_of(&classes[body.class as usize], outward, overlap.arms[side]);
    let levers = levers(mesh, face);
    let centre = deform.nodes.place[body.nodes().end - 1].z;
    let height = |point: &Point| {
        let anchor = &point.anchors[side];
        let pairs = || anchor.nodes();
        // A point that is a node stands for the node's share of the face.
        let single = pairs().find(|(_, w)| (w - 1.0).abs() < 1e-12);
        if let Some(at) = single.and_then(|(n, _)| levers.get(&(n - body.first))) {
            return centre + at.z;
        }
        pairs().map(|(n, w)| w * deform.nodes.place[n as usize].z).sum()
    };
    points
        .iter()
        .map(|point| {
            let t = in_situ.at(height(point)) * n;
            overlap.frame.map(|e| e.dot(t))
        })
        .collect()
}
