//! Facets that part: found contact takes over what they carry.
//!
//! A facet knows two faces as they lay on each other when it was built. Once all of its points have failed and it has slid, gaped or opened
//! too far for that, it carries nothing any more, and its blocks are a pair that is searched for. What opens and closes in place stays with it. Facets between the
//! same two blocks part together: two convex blocks share one plane.
//!
//! Shear and torsion go on as springs of the found contact, whose stiffness is that of the bonds; its pressure follows from how deep the
//! blocks lie in each other, which is what the bonds were pressed by, but for the share of the area that has slid off, and for the stress
//! that bonds made by a cut began with. Deviation: the offset that would make both equal at that instant and fade with further slip is left out.
//! What energy and springs make of the change is booked with edits.

use riprap_geom::Vec3;

use crate::contact::deformable::CHECK_INTERVAL;
use crate::deform::bonds;
use crate::laws::bond;
use crate::state::deform::{Deform, Facet};
use crate::state::deformable::{DeformableContact, DeformableMemory, DeformablePair};
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Slip over the side of a square of the area of the facet.
const SLID: f64 = 0.05;
/// Opening of all points over the same.
const OPEN: f64 = 0.01;
/// Difference of the openings of its points over the same: the angle by which it gapes.
const GAPES: f64 = 0.02;

/// Lets facets go that no longer describe where their blocks touch: every [`CHECK_INTERVAL`] steps, while relaxing only in equilibrium.
pub(crate) fn part(world: &mut World, scratch: &mut Scratch) {
    let Some(deform) = world.deform.as_deref().filter(|_| world.setup.found_contacts) else {
        return;
    };
    let look = world.pending > 0.0
        && match &deform.relax {
            Some(relax) => relax.converged,
            None => world.step.is_multiple_of(CHECK_INTERVAL),
        };
    if !look {
        return;
    }
    let mut past: Vec<[u32; 2]> = Vec::new();
    let mut holding: Vec<[u32; 2]> = Vec::new();
    for (facet, has_history) in deform.facets.iter().zip(&deform.has_history) {
        let memory = &deform.memory[facet.points()];
        if facet.parted || !has_history {
            continue;
        }
        if !memory.iter().all(|m| m.state.is_broken()) {
            holding.push(sorted(facet.blocks));
        } else if is_past(world, deform, facet) {
            past.push(sorted(facet.blocks));
        }
    }
    if past.is_empty() {
        return;
    }
    for list in [&mut past, &mut holding] {
        list.sort_unstable();
        list.dedup();
    }
    // A facet without wear holds too.
    for (facet, _) in
        (deform.facets.iter().zip(&deform.has_history)).filter(|(f, w)| !**w && !f.parted)
    {
        let ends = sorted(facet.blocks);
        if past.binary_search(&ends).is_ok() {
            holding.push(ends);
        }
    }
    past.retain(|ends| !holding.contains(ends));
    let count = deform.facets.len();
    let mut changed = false;
    for k in 0..count {
        let Some(deform) = world.deform.as_deref() else {
            return;
        };
        let facet = deform.facets[k];
        if facet.parted || past.binary_search(&sorted(facet.blocks)).is_err() {
            continue;
        }
        hand_over(world, &facet);
        if let Some(deform) = world.deform.as_deref_mut() {
            deform.facets[k].parted = true;
        }
        changed = true;
    }
    if !changed {
        return;
    }
    if let Some(relax) = world.deform.as_deref_mut().and_then(|d| d.relax.as_mut()) {
        relax.disturb();
    }
    // The list of pairs is made anew, with these.
    scratch.deformable.ready = false;
    world.found.deformable.roles.clear();
}

fn sorted([i, j]: [u32; 2]) -> [u32; 2] {
    [i.min(j), i.max(j)]
}

/// Whether a broken facet has slid, gaped or opened too far.
fn is_past(world: &World, deform: &Deform, facet: &Facet) -> bool {
    let freedoms = world.freedoms_with(deform);
    let side = facet.area.sqrt();
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut slip = [0.0; 2];
    for point in &deform.points[facet.points()] {
        let jump = freedoms.jump(&point.anchors);
        let [across, b, c] = facet.now.map(|e| e.dot(jump));
        low = low.min(across);
        high = high.max(across);
        slip[0] += point.area / facet.area * b;
        slip[1] += point.area / facet.area * c;
    }
    let slid = slip[0] * slip[0] + slip[1] * slip[1] > (SLID * side) * (SLID * side);
    slid || low > OPEN * side || high - low > GAPES * side
}

/// Gives what a facet carries to the found contact of its blocks.
fn hand_over(world: &mut World, facet: &Facet) {
    let Some(deform) = world.deform.as_deref() else {
        return;
    };
    let freedoms = world.freedoms_with(deform);
    let Some(law) = &world.setup.interfaces[usize::from(facet.row)].bond else {
        return;
    };
    let [n, b, c] = facet.now;
    let points = &deform.points[facet.points()];
    let place = |p: &crate::state::deform::Point| {
        crate::deform::build::place(world, deform, p, 0) + freedoms.displacement(&p.anchors[0])
    };
    let centre: Vec3 = points.iter().map(|p| p.area / facet.area * place(p)).sum();
    let (mut shear, mut torsion, mut polar, mut energy) = (Vec3::ZERO, 0.0, 0.0, 0.0);
    for (point, memory) in points.iter().zip(&deform.memory[facet.points()]) {
        let jump = freedoms.jump(&point.anchors);
        let at = facet.now.map(|e| e.dot(jump));
        let (t, state) = bonds::respond(law, facet.stiffness, memory, &at, false);
        let stored = bond::stored(facet.stiffness, &memory.start, &at, &state);
        energy += point.area * (stored + memory.unbooked);
        // Tractions are those on the first block.
        let force = point.area * (t[1] * b + t[2] * c);
        let arm = place(point) - centre;
        shear -= force;
        torsion -= n.dot(arm.cross(force));
        polar += point.area * (arm - arm.dot(n) * n).length_squared();
    }
    let forward: f64 = if facet.blocks[0] < facet.blocks[1] { 1.0 } else { -1.0 };
    let ends = sorted(facet.blocks);
    let pairs = &mut world.found.deformable.pairs;
    let at = pairs.partition_point(|pair| pair.ends < ends);
    if pairs.get(at).is_none_or(|pair| pair.ends != ends) {
        let fresh = DeformablePair { ends, ..DeformablePair::default() };
        pairs.insert(at, fresh);
    }
    let pair = &mut pairs[at];
    // Both blocks are convex: their pair has one contact.
    let DeformableContact { memory, .. } = pair.contact(0);
    *memory = DeformableMemory {
        shear: memory.shear + forward * shear,
        torsion: memory.torsion + torsion,
        normal: forward * n,
        area: memory.area + facet.area,
        polar: memory.polar + polar,
        sliding: true,
    };
    let stored = memory.stored(facet.stiffness[1]);
    let change = stored - pair.stored;
    pair.stored = stored;
    world.works.edit_defect += change - energy;
}
