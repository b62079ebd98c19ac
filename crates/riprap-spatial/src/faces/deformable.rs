//! Shapes of deformable blocks about their centroids, and their faces.

use riprap_geom::Vec3;
use riprap_geom::face_overlap::face_overlap;
use riprap_geom::polyhedron::{Polyhedron, Tetrahedra};

use crate::setup::{Shape, Solid};
use crate::state::deform::Facet;
use crate::state::workspace::BlockClass;
use crate::state::world::World;

/// Cosine beyond which two normals are the same.
pub(crate) const PARALLEL: f64 = 1.0 - 1e-9;

fn about_centroid(mut body: Polyhedron) -> (Polyhedron, Vec3) {
    let centroid = body.moments().centroid;
    body.vertices.iter_mut().for_each(|v| *v -= centroid);
    (body, centroid)
}

/// A solid with its centroid at the origin, and that centroid.
#[must_use]
pub(crate) fn centred(shape: &Shape) -> (Polyhedron, Vec3) {
    match shape {
        Shape::Brick { centre, half } => (Polyhedron::brick(Vec3::ZERO, *half), *centre),
        Shape::Polyhedron(solid) => about_centroid(solid.polyhedron()),
        // With all faces of its parts; integrals over glued ones cancel.
        Shape::Glued(parts) => about_centroid(Solid::all(parts).polyhedron()),
        Shape::Terrain(surface) => {
            let body = surface.body();
            let body = Polyhedron { vertices: body.vertices, faces: body.faces };
            (body, Vec3::ZERO)
        }
    }
}

/// Face of a kind with the outward normal `n`, the nearest to `at` (m from the centroid) of several.
#[must_use]
pub(crate) fn face_of(kind: &BlockClass, n: Vec3, at: Vec3) -> usize {
    face_with(&kind.mesh, kind.faces.len(), n, at)
}

/// As [`face_of`], for the first `count` faces of a mesh about its centroid.
#[must_use]
pub(crate) fn face_with(mesh: &Tetrahedra, count: usize, n: Vec3, at: Vec3) -> usize {
    let mut best = (0, f64::NEG_INFINITY, f64::INFINITY);
    for face in 0..count {
        let mut area = Vec3::ZERO;
        for triangle in mesh.fan(face) {
            let [m, a, b] = triangle.map(|k| mesh.nodes[k as usize]);
            area += (a - m).cross(b - m);
        }
        let cosine = area.normalize().dot(n);
        let centre = mesh.nodes[mesh.nodes.len() - 1 - count + face];
        let distance = centre.distance_squared(at);
        let both = cosine > PARALLEL && best.1 > PARALLEL;
        if (both && distance < best.2) || (!both && cosine > best.1) {
            best = (face, cosine, distance);
        }
    }
    best.0
}

/// Corners of the part that the faces of two blocks share at the start, m (local).
pub(crate) fn outline(world: &World, facet: &Facet) -> Vec<Vec3> {
    let n = facet.frame[0];
    let faces = [0, 1].map(|side: usize| {
        let (solid, centroid) = centred(&world.setup.blocks[facet.blocks[side] as usize].shape);
        let outward = if side == 0 { n } else { -n };
        let facing = |f: &usize| solid.plane(*f).0.dot(outward);
        let best = (0..solid.faces.len()).max_by(|a, b| facing(a).total_cmp(&facing(b)));
        let corners = solid.outline(best.unwrap_or(0));
        let places: Vec<Vec3> = corners.into_iter().map(|c| c + centroid).collect();
        places
    });
    // In a periodic model the faces lie a period apart: then the first is as good.
    match face_overlap(&faces[0], &faces[1], n, 0.0) {
        Some(shared) => shared.outline,
        None => faces[0].clone(),
    }
}
