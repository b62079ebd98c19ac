//! Blocks of glued parts: their largest faces, and what they cannot stand beside yet.

use crate::contact::facing;
use crate::faces::region::{Bounds, Extent};
use crate::kernel::Pose;
use crate::kernel::glued::Glued;
use crate::setup::error::BuildError;
use crate::setup::{Bolt, FaceSet, Region, Setup, Shape, Solid};
use crate::state::contact_scratch::FacePair;
use crate::state::world::World;

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
            let Some(mut found) = facing::facing(shapes, at, margin, faces) else {
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
pub(super) mod tests;
