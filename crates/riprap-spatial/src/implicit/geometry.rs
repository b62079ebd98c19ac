//! From two blocks to the pieces of their implicit step.
//!
//! Faces are moved outward by a way that both can go in the step, so that pieces cover gaps too: where the blocks are apart the depth is below 0.

use riprap_geom::Vec3;

use crate::implicit::pair::Pair;
use crate::implicit::patch::Piece;
use crate::kernel::frame::Frame;
use crate::kernel::friction::hold;
use crate::kernel::piece::Polygon;
use crate::kernel::planes::origin;
use crate::kernel::surface::{self, Walker};
use crate::kernel::terrain::Under;
use crate::kernel::{Body, ContactLaw, Found, Reached, Terrain};

/// Faces that look less than this along the direction of their pair are left out: strips at the edges of bricks.
const GLANCING: f64 = 0.02;

/// What two blocks have in common within reach.
pub(crate) enum Reach {
    /// They are at least so far apart, m.
    Apart(f64),
    /// They may press within the step; places in the lists of the faces of the piece to start from next time.
    Near(Option<[u16; 2]>),
    /// No surface can be found.
    Lost,
}

/// Pieces of two blocks with faces `out` (m) further out, put into `near`.
pub(crate) fn reach(
    walker: &mut Walker,
    pair: &surface::Pair,
    out: f64,
    mut law: ContactLaw,
    near: &mut Pair,
) -> Reach {
    let sums = match walker.find_inflated(pair, out) {
        Found::Apart(gap) => return Reach::Apart(gap + 2.0 * out),
        Found::FullyPenetrated(_) => return Reach::Lost,
        Found::Touching(sums) => sums,
    };
    let Some(direction) = sums.normal(0.0) else { return Reach::Lost };
    // Edges and tips that stick do not slip past each other. The share of the area does not depend on how far out the faces are.
    let area = sums.across(sums.vector_area, direction);
    if area > 0.0 {
        law.shear_stiffness *= hold(&law, walker.falling(&law, &sums) / area);
    }
    let from = origin(pair.bodies[0], pair.bodies[1]);
    near.begin(direction, pair.bodies.map(|body| body.position - from), law);
    for ([f, g], frame, polygon, share) in walker.kept() {
        let planes = &walker.planes;
        let facing = [planes.normal(f).dot(direction), -planes.normal(g).dot(direction)];
        near.add(facing, share, frame, polygon, out);
    }
    Reach::Near(sums.hint)
}

/// Pieces of a block on each facet of terrain near it, the surface and its faces `out` (m) further out: a pair each, put into `near`, and how many
/// there are. A facet is a plane, so that its pieces push along its normal.
pub(crate) fn reach_ground(
    under: &mut Under,
    terrain: &Terrain,
    body: &Body,
    out: f64,
    law: ContactLaw,
    near: &mut Vec<Pair>,
) -> (Reach, usize) {
    match under.find_inflated(terrain, body, out) {
        Reached::Apart(gap) => return (Reach::Apart(gap), 0),
        Reached::FullyPenetrated(_) => return (Reach::Lost, 0),
        Reached::Touching => {}
    }
    let mut count = 0;
    for on in &under.facets {
        if near.len() == count {
            near.push(Pair::default());
        }
        let pair = &mut near[count];
        let direction = on.slope.normalize();
        pair.begin(direction, [Vec3::ZERO; 2], law);
        pair.key = [u32::from(on.piece), on.facet];
        for (face, frame, polygon) in under.pieces(on.facet) {
            let facing = [on.slope.dot(direction), -body.normals[face].dot(direction)];
            pair.add(facing, 1.0, frame, polygon, out);
        }
        count += usize::from(!pair.pieces.is_empty());
    }
    (Reach::Near(None), count)
}

impl Pair {
    /// Adds a piece of faces whose normals have the components `facing` along and against the direction of the pair, as it was found with
    /// faces `out` (m) further out.
    fn add(&mut self, facing: [f64; 2], share: f64, frame: &Frame, polygon: &Polygon, out: f64) {
        let corners = polygon.s().iter().zip(polygon.t()).map(|(s, t)| [*s, *t]);
        self.add_piece(facing, share, frame, polygon.slope, corners, out);
    }

    /// The same of a polygon by its corners, and the depth in it; whether it counts.
    pub(super) fn add_piece(
        &mut self,
        facing: [f64; 2],
        share: f64,
        frame: &Frame,
        [w, u, v]: [f64; 3],
        corners: impl Iterator<Item = [f64; 2]>,
        out: f64,
    ) -> bool {
        if facing.iter().any(|c| *c < GLANCING) {
            return false;
        }
        let from = self.corners.len();
        self.corners.extend(corners);
        self.pieces.push(Piece::new(
            &self.basis(),
            self.law.normal_stiffness,
            facing,
            share * frame.normal.dot(self.direction),
            (frame.foot, frame.axes),
            [w - out, -u, -v],
            from..self.corners.len(),
        ));
        true
    }

    /// Makes it a pair in this direction, with centroids at `centres` (m) from its origin, without pieces and memory.
    pub(super) fn begin(&mut self, direction: Vec3, centres: [Vec3; 2], law: ContactLaw) {
        let first = farthest_axis(direction).cross(direction).normalize();
        let (mut pieces, mut corners) =
            (std::mem::take(&mut self.pieces), std::mem::take(&mut self.corners));
        pieces.clear();
        corners.clear();
        let across = [first, direction.cross(first)];
        *self = Self { centres, direction, across, pieces, corners, law, ..Self::default() };
    }
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
