//! Faces of two convex blocks that can come flat onto each other before the next rebuild of the search.

use riprap_geom::Vec3;

use crate::kernel::{Pose, Shape};
use crate::state::contact_scratch::FacePair;

/// Cosine between normals of faces that can come flat onto each other before the next look of the search.
const FACING: f64 = -0.98;

/// Smaller one of the largest listed faces of both blocks, m².
pub(super) fn largest_area(shapes: [&Shape; 2], faces: [&[u16]; 2]) -> f64 {
    let [a, b] = [0, 1].map(|s| {
        let areas = faces[s].iter().map(|f| shapes[s].areas[*f as usize]);
        areas.fold(0.0, f64::max)
    });
    a.min(b)
}

/// Where a face lies along each of two axes: from, to, m.
fn extent(shape: &Shape, pose: Pose, face: u16, axes: [Vec3; 2]) -> [[f64; 2]; 2] {
    let back = pose.rotation.conjugate();
    // Axes are turned into the body, instead of every corner into space.
    let own = [back * axes[0], back * axes[1]];
    let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for v in shape.outline(face as usize) {
        let at = shape.vertices[*v as usize];
        for ([low, high], axis) in extent.iter_mut().zip(own) {
            let along = axis.dot(at);
            *low = low.min(along);
            *high = high.max(along);
        }
    }
    let from = [axes[0].dot(pose.position), axes[1].dot(pose.position)];
    [0, 1].map(|k| extent[k].map(|along| from[k] + along))
}

/// The two of these faces with the largest area that can come flat onto each other, if any: they face each other, and have moved by
/// `margin` (m) at most along themselves from these poses.
pub(super) fn facing<F: IntoIterator<Item = u16> + Clone>(
    shapes: [&Shape; 2],
    poses: [Pose; 2],
    margin: f64,
    faces: [F; 2],
) -> Option<FacePair> {
    let mut most = 0.0;
    let mut found = None;
    let [of_first, of_second] = faces;
    for f in of_first {
        let n = poses[0].rotation * shapes[0].normals[f as usize];
        // Seen from the second body.
        let own = poses[1].rotation.conjugate() * n;
        // Along axes of the first face, for the first one that faces it.
        let mut along = None;
        for g in of_second.clone() {
            let areas = [shapes[0].areas[f as usize], shapes[1].areas[g as usize]];
            // They share no more than the smaller one has.
            if areas[0].min(areas[1]) <= most {
                continue;
            }
            if own.dot(shapes[1].normals[g as usize]) > FACING {
                continue;
            }
            let (axes, first) = *along.get_or_insert_with(|| {
                let [_, e, h] = riprap_geom::polyhedron::frame(n);
                ([e, h], extent(shapes[0], poses[0], f, [e, h]))
            });
            let second = extent(shapes[1], poses[1], g, axes);
            let sides = [0, 1].map(|axis| {
                let ([low, high], [from, to]) = (first[axis], second[axis]);
                (high.min(to) - low.max(from) + margin).max(0.0)
            });
            let area = areas[0].min(areas[1]).min(sides[0] * sides[1]);
            if area > most {
                most = area;
                found = Some((area, usize::from(areas[1] < areas[0]), [f, g]));
            }
        }
    }
    found.map(|(area, side, faces)| FacePair::new(area, side, shapes[side], faces[side] as usize))
}
