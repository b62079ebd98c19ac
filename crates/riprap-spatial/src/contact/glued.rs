//! Blocks of glued parts in a step: each two convex pieces of a pair have springs of their own.
//!
//! The pressure of all of them together is that of the whole blocks; what divides it among pieces only says where friction and
//! dashpots act.

use riprap_geom::Vec3;

use crate::contact::limit;
use crate::faces::region::{Bounds, Extent};
use crate::kernel::glued::{Glued, Placed, Touch};
use crate::kernel::{ContactInput, ContactLaw, Motion, Pose, respond};
use crate::setup::error::BuildError;
use crate::setup::{Bolt, FaceSet, Region, Setup, Shape, Solid};
use crate::state::contact_scratch::{
    Deepest, Exerted, FacePair, GluedWorkspace, PairGroup, Pressed, Slot,
};
use crate::state::found::{FoundPair, PieceContact};
use crate::state::world::World;

/// What rounding may take from a gap, over the gap.
const ROUNDING: f64 = 1e-9;

/// What is asked of a pair.
pub(super) struct Asked<'a> {
    /// Both blocks where they are.
    pub(super) placed: Placed<'a>,
    pub(super) law: &'a ContactLaw,
    /// Motion of both, half a step ago.
    pub(super) motion: [Motion; 2],
    /// Smaller radius, m.
    pub(super) radius: f64,
    /// Smaller inradius, m.
    pub(super) inradius: f64,
    /// Time moved since the last evaluation, s.
    pub(super) dt: f64,
    /// Length of the last step, s.
    pub(super) last_dt: f64,
    /// Bound of the speed at which points of the two blocks come nearer to each other, m/s.
    pub(super) nearing: f64,
}

/// Evaluates a pair with a block of glued parts.
pub(super) fn act(
    asked: &Asked,
    pair: &mut FoundPair,
    slot: &mut Slot,
    workspace: &mut GluedWorkspace,
    group: &mut PairGroup,
) {
    let sums = &mut group.sums;
    let mut exerted = Exerted::default();
    let GluedWorkspace { gluer, old } = workspace;
    let Asked { placed, law, motion, dt, .. } = asked;
    let mut new = Slot { nearing: asked.nearing, ..Slot::default() };
    old.clear();
    old.append(&mut pair.pieces);
    (pair.force, pair.depth, pair.stored) = (Vec3::ZERO, 0.0, 0.0);
    pair.memory = Default::default();
    let mut gap = f64::INFINITY;
    let mut most = f64::NEG_INFINITY;
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
                Touch::FullyPenetrated(radius) => {
                    // No force can be given: not a number stops the run, and the deepest contact is to blame.
                    exerted.elastic.force = Vec3::NAN;
                    pair.depth = 2.0 * radius;
                    let deep =
                        Deepest::new(pair.ends, Pressed::NoSurface, pair.depth, asked.inradius);
                    sums.deepest = Deepest::deeper(sums.deepest, Some(deep));
                    new.at = group.push(exerted);
                    *slot = new;
                    return;
                }
                Touch::Touching(surface, origin) => (surface, origin),
            };
            gap = 0.0;
            sums.unlabelled += surface.unlabelled;
            let pieces = [a as u16, b as u16];
            let known = old.iter().position(|contact| contact.pieces == pieces);
            let mut contact = known.map_or_else(
                || PieceContact { pieces, ..PieceContact::default() },
                |k| old.remove(k),
            );
            let falls = gluer.walker.falling(law, &surface);
            let reply = respond(
                law,
                &ContactInput {
                    sums: &surface,
                    pieces: &|show| gluer.walker.rubbing(show),
                    origin,
                    centres: placed.poses.map(|pose| pose.position),
                    motion: *motion,
                    radius: asked.radius,
                    dt: *dt,
                    last_dt: asked.last_dt,
                    shared: None,
                    falls,
                },
                &mut contact.memory,
                &mut None,
            );
            sums.friction += reply.friction;
            contact.stored = contact.memory.stored(law.shear_stiffness);
            contact.force = reply.elastic.force + reply.spring.force;
            contact.depth = surface.depth;
            contact.area = reply.area;
            exerted.elastic = exerted.elastic.plus(&reply.elastic);
            exerted.spring = exerted.spring.plus(&reply.spring);
            exerted.drag = exerted.drag.plus(&reply.drag);
            new.area += reply.area;
            new.touching = true;
            pair.force += reply.wrench.force;
            pair.stored += contact.stored;
            pair.depth = pair.depth.max(contact.depth);
            // What is asked of the pair as a whole, its normal and how fast
            // it closes, the piece answers that presses most.
            let pressed = reply.elastic.force.length();
            if pressed > most {
                most = pressed;
                pair.memory = contact.memory;
            }
            pair.pieces.push(contact);
        }
    }
    // What is left has parted.
    for gone in old.drain(..) {
        sums.friction += gone.memory.work(motion, *dt) + gone.stored;
    }
    pair.gap = gap - ROUNDING * gap;
    if new.touching {
        let deep = Deepest::new(pair.ends, Pressed::Contact, pair.depth, asked.inradius);
        sums.deepest = Deepest::deeper(sums.deepest, Some(deep));
        new.at = group.push(exerted);
    }
    *slot = new;
}

/// The faces of two blocks with the largest area that can come flat onto each other, with the area of all that can.
pub(super) fn facing(
    blocks: [&Glued; 2],
    poses: [Pose; 2],
    margin: f64,
    with_square: impl Fn(FacePair) -> FacePair,
) -> Option<FacePair> {
    let mut best: Option<FacePair> = None;
    let mut all = 0.0;
    for a in blocks[0].convex_pieces() {
        for b in blocks[1].convex_pieces() {
            let terms = [a, b];
            let shapes = terms.map(|term| &term.shape);
            let at = [0, 1].map(|side| terms[side].pose(&poses[side]));
            let faces = shapes.map(|shape| 0..shape.faces() as u16);
            let Some(mut found) = limit::facing(shapes, at, margin, faces) else {
                continue;
            };
            found.centre += terms[found.side].centre;
            all += found.area;
            if best.is_none_or(|best| found.area > best.area) {
                best = Some(found);
            }
        }
    }
    let mut found = with_square(best?);
    // Stiffness goes with the area: as if all that can touch were where the largest part is.
    found.square *= all / found.area;
    found.area = all;
    Some(found)
}

/// Refuses, by name, what takes no blocks of glued parts.
///
/// # Errors
/// The first block and what it cannot stand beside.
pub(crate) fn check(setup: &Setup, name: impl Fn(usize) -> String) -> Result<(), BuildError> {
    let blocks = || setup.blocks.iter().enumerate();
    let Some((first, _)) = blocks().find(|(_, block)| block.shape.is_glued()) else {
        return Ok(());
    };
    let refused =
        |block: usize, reason: &'static str| BuildError::Glued { block: name(block), reason };
    let model = [
        (!setup.found_contacts, "interacts only by contact: set `found_contacts = true`"),
        (
            !setup.sources.is_empty(),
            "cannot be loaded by [[sources]] yet: remove them, or make the block convex",
        ),
        (
            setup.in_situ.is_some(),
            "has no joints to carry in-situ stress: remove the stress, or make the block convex",
        ),
        (
            !setup.refinements.is_empty(),
            "cannot be combined with split blocks yet: remove `refine`",
        ),
        (setup.periodic.iter().any(Option::is_some), "cannot be in a periodic model"),
    ];
    if let Some((_, reason)) = model.into_iter().find(|(refuses, _)| *refuses) {
        return Err(refused(first, reason));
    }
    let reason =
        "has no free faces for [[boundaries]] yet: hold it by [[supports]] or load it by [[loads]]";
    for (b, block) in blocks() {
        let Shape::Glued(parts) = &block.shape else {
            continue;
        };
        let crossed = |bolt: &Bolt| {
            let line = Region::Line(bolt.head, bolt.toe);
            let bounds = |part: &Solid| Bounds::around(&part.vertices);
            parts.iter().any(|part| Extent::Solid(part.polyhedron(), bounds(part)).touches(&line))
        };
        if setup.bolts.iter().any(crossed) {
            let reason = "cannot be bolted yet: move the bolts out of it, or make the block convex";
            return Err(refused(b, reason));
        }
        let listed = |blocks: &[u32]| blocks.binary_search(&(b as u32)).is_ok();
        if setup.deform.sets.iter().any(|set| set.blocks.contains(&(b as u32))) {
            let reason = "cannot deform yet: make it rigid, or bond convex blocks to each other";
            return Err(refused(b, reason));
        }
        let size = Solid::all(parts).polyhedron().size();
        let on = |set: &FaceSet| match set {
            FaceSet::Blocks { blocks, .. } | FaceSet::Surface { blocks, .. } => listed(blocks),
            FaceSet::Plane { normal, offset } => parts.iter().any(|part| {
                let solid = part.polyhedron();
                (0..solid.faces.len()).any(|face| {
                    let (n, d) = solid.plane(face);
                    n.dot(*normal) > 1.0 - 1e-9 && (d - offset).abs() <= 1e-6 * size
                })
            }),
            FaceSet::Box { min, max, .. } => {
                let mut corners = parts.iter().flat_map(|part| &part.vertices);
                let first = corners.next().copied().unwrap_or_default();
                let (low, high) =
                    corners.fold((first, first), |(low, high), v| (low.min(*v), high.max(*v)));
                low.cmple(*max).all() && high.cmpge(*min).all()
            }
        };
        if setup.boundaries.iter().any(|boundary| on(&boundary.on)) {
            return Err(refused(b, reason));
        }
    }
    Ok(())
}

impl World {
    /// Whether block `b` is made of glued parts.
    #[must_use]
    pub fn is_glued(&self, b: usize) -> bool {
        self.setup.blocks[b].shape.is_glued()
    }
}

#[cfg(test)]
mod tests;
