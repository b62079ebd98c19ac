//! Narrow phase: the surface of equal pressure that two bodies share, patch by patch.
//!
//! ```text
//!   two convex blocks      one patch
//!   glued parts            one patch for each two pieces
//!   terrain and a block    one patch for each facet of the ground and piece of the block
//! ```
//!
//! Patches have keys that last from step to step; what acts on them, and what they remember, is the same for all
//! ([`super::acting`]). A new kind of body is a new function here.

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
use crate::kernel::friction::Pieces;
use crate::kernel::glued::{Glued, Gluer, Placed, Touch};
use crate::kernel::piece::Polygon;
use crate::kernel::ridges::Ridges;
use crate::kernel::surface::Walker;
use crate::kernel::terrain::Under;
use crate::kernel::{
    Body, ContactInput, ContactLaw, Found, Pair, Pose, Reached, Sums, Terrain, planes,
};

/// What rounding may take from a gap, over the gap.
const ROUNDING: f64 = 1e-9;
/// How far a block looks for terrain, over its radius.
const REACH: f64 = 1.0;

/// A patch of the surface that two bodies share.
pub(super) struct Patch<'a> {
    /// Which it is among those of the pair.
    pub(super) key: [u32; 2],
    pub(super) sums: &'a Sums,
    /// Origin of the planes in space, m.
    pub(super) origin: Vec3,
    /// Shows the polygons that rub.
    pub(super) pieces: &'a Pieces<'a>,
    /// Negative stiffness of the pressure along the patch, over the normal stiffness of the law, m².
    pub(super) falls: f64,
    /// Faces of both from which the walk of the next evaluation begins.
    pub(super) next: Option<[u16; 2]>,
    /// Its share of the area over which the dashpots of the law are spread.
    pub(super) share: f64,
    /// What dashpots across add to its pressure, over it, where it shares them with others.
    pub(super) shared: Option<f64>,
    /// Edges that no plane has made.
    pub(super) unlabelled: u32,
}

impl<'a> Patch<'a> {
    pub(super) fn new(key: [u32; 2], sums: &'a Sums, origin: Vec3, pieces: &'a Pieces<'a>) -> Self {
        Self {
            key,
            sums,
            origin,
            pieces,
            falls: 0.0,
            next: None,
            share: 1.0,
            shared: None,
            unlabelled: 0,
        }
    }
}

/// Two convex blocks, walked from faces `hint` on.
pub(super) fn convex(
    walker: &mut Walker,
    pair: &Pair,
    law: &ContactLaw,
    mut each: impl FnMut(&Patch),
) -> Reached {
    walker.growth = law.growth;
    let surface = match walker.find(pair) {
        Found::Touching(surface) => surface,
        Found::Apart(gap) => return Reached::Apart(gap - ROUNDING * gap),
        Found::FullyPenetrated(radius) => return Reached::FullyPenetrated(2.0 * radius),
    };
    let falls = walker.falling(law, &surface);
    let [of_first, of_second] = pair.faces;
    let next = surface.hint.map(|[f, g]| [of_first[f as usize], of_second[g as usize]]);
    let origin = planes::origin(pair.bodies[0], pair.bodies[1]);
    let pieces = |show: &mut dyn FnMut(&Polygon, &Frame)| walker.rubbing(show);
    let unlabelled = surface.unlabelled;
    each(&Patch { falls, next, unlabelled, ..Patch::new([0; 2], &surface, origin, &pieces) });
    Reached::Touching
}

/// Two blocks of which one at least is made of glued parts.
///
/// The pressure of all pieces together is that of the whole blocks; what divides it among pieces only says where friction and dashpots act.
pub(super) fn glued(
    gluer: &mut Gluer,
    placed: &Placed,
    law: &ContactLaw,
    mut each: impl FnMut(&Patch),
) -> Reached {
    let mut gap = f64::INFINITY;
    let mut touching = false;
    (gluer.walker.growth, gluer.other.growth) = (law.growth, law.growth);
    gluer.place(placed);
    for a in 0..placed.blocks[0].pieces() {
        for b in 0..placed.blocks[1].pieces() {
            let (surface, origin) = match gluer.find(placed, [a, b]) {
                Touch::Apart(found) => {
                    gap = gap.min(found);
                    continue;
                }
                Touch::Covered => {
                    gap = 0.0;
                    continue;
                }
                Touch::FullyPenetrated(radius) => return Reached::FullyPenetrated(2.0 * radius),
                Touch::Touching(surface, origin) => (surface, origin),
            };
            touching = true;
            let falls = gluer.walker.falling(law, &surface);
            let pieces = |show: &mut dyn FnMut(&Polygon, &Frame)| gluer.walker.rubbing(show);
            let (key, unlabelled) = ([a as u32, b as u32], surface.unlabelled);
            each(&Patch { falls, unlabelled, ..Patch::new(key, &surface, origin, &pieces) });
        }
    }
    if touching { Reached::Touching } else { Reached::Apart(gap - ROUNDING * gap) }
}

/// A block on terrain.
pub(super) struct OnGround<'a> {
    pub(super) terrain: &'a Terrain,
    pub(super) body: Body<'a>,
    pub(super) pose: Pose,
    /// Its pieces, if it has several.
    pub(super) glued: Option<&'a Glued>,
}

impl OnGround<'_> {
    /// What the block has on each facet. `asked`: all but the sums of a patch. Dashpots of ridges stay in `ridges`.
    pub(super) fn find(
        &self,
        under: &mut Under,
        ridges: &mut Ridges,
        (law, asked): (&ContactLaw, &ContactInput),
        mut each: impl FnMut(&Patch),
    ) -> Reached {
        under.stiffen(law.growth);
        let reached = match self.glued {
            Some(glued) => under.find_glued(self.terrain, glued, &self.pose, REACH),
            None => under.find(self.terrain, &self.body, REACH),
        };
        let facets = &under.facets;
        if !matches!(reached, Reached::Touching) {
            return reached;
        }
        ridges.find(law, asked, facets);
        let whole: f64 = facets.iter().map(|on| on.sums.vector_area.length()).sum();
        for (k, on) in facets.iter().enumerate() {
            let pieces = |show: &mut dyn FnMut(&Polygon, &Frame)| under.rubbing(on, show);
            let key = [u32::from(on.piece), on.facet];
            each(&Patch {
                share: on.sums.vector_area.length() / whole,
                shared: ridges.shared(k),
                ..Patch::new(key, &on.sums, self.body.position, &pieces)
            });
        }
        reached
    }
}
