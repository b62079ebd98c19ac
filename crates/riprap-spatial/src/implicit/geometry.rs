//! From two blocks to the pieces of their implicit step.
//!
//! Faces are moved outward by a way that both can go in the step, so that pieces cover gaps too: where the blocks are apart the depth is below 0.

use riprap_geom::Vec3;

use crate::implicit::pair::{Pair, Pressure};
use crate::implicit::patch::Piece;
use crate::kernel::planes::origin;
use crate::kernel::surface::{self, Walker};
use crate::kernel::{Body, ContactLaw, Found};

/// Faces that look less than this along the direction of their pair are left out: strips at the edges of bricks.
const GLANCING: f64 = 0.02;

/// What two blocks have in common within reach.
pub(crate) enum Reach {
    /// They are at least so far apart, m.
    Apart(f64),
    /// They may press within the step; places in the lists of the faces of the piece to start from next time.
    Near(Box<Pair>, Option<[u16; 2]>),
    /// No surface can be found.
    Lost,
}

/// Pieces of two blocks with faces `out` (m) further out.
pub(crate) fn reach(
    walker: &mut Walker,
    bodies: [&Body; 2],
    faces: [&[u16]; 2],
    ties: bool,
    hint: Option<[u16; 2]>,
    out: f64,
    law: ContactLaw,
) -> Reach {
    let pair = surface::Pair { bodies, faces, ties, hint, witnesses: &[] };
    let sums = match walker.find_inflated(&pair, out) {
        Found::Apart(gap) => return Reach::Apart(gap + 2.0 * out),
        Found::FullyPenetrated(_) => return Reach::Lost,
        Found::Touching(sums) => sums,
    };
    let size = sums.force.length();
    if size == 0.0 {
        return Reach::Lost;
    }
    let direction = sums.force / size;
    let (mut pieces, mut corners) = (Vec::new(), Vec::new());
    walker.show_pieces(|planes, [f, g], frame, polygon, share| {
        let facing = [planes.normal(f).dot(direction), -planes.normal(g).dot(direction)];
        if facing.iter().any(|c| *c < GLANCING) {
            return;
        }
        let [w, u, v] = polygon.slope;
        let from = corners.len();
        corners.extend(polygon.s().iter().zip(polygon.t()).map(|(s, t)| [*s, *t]));
        let weight = share * frame.normal.dot(direction);
        let place = (frame.foot, frame.axes);
        let depth = [w - out, -u, -v];
        pieces.push(Piece::new(
            direction,
            law.normal_stiffness,
            facing,
            weight,
            place,
            depth,
            from..corners.len(),
        ));
    });
    let from = origin(bodies[0], bodies[1]);
    let first = farthest_axis(direction).cross(direction).normalize();
    let near = Pair {
        ends: [None; 2],
        centres: bodies.map(|body| body.position - from),
        given: [[Vec3::ZERO; 2]; 2],
        direction,
        across: [first, direction.cross(first)],
        pieces,
        corners,
        law,
        shear: Vec3::ZERO,
        torsion: 0.0,
        pressure: Pressure::default(),
        area_before: 0.0,
    };
    Reach::Near(Box::new(near), sums.hint)
}

/// The axis of space that is farthest from a direction.
fn farthest_axis(direction: Vec3) -> Vec3 {
    let [x, y, z] = direction.abs().to_array();
    if x <= y && x <= z {
        Vec3::X
    } else if y <= z {
        Vec3::Y
    } else {
        Vec3::Z
    }
}
