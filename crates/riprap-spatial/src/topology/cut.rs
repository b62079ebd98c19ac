//! Cutting deformable blocks by planes where they are about to break.
//!
//! One transaction, as splitting 1 to 8: plan (read only) -> apply -> audit -> lay out and evaluate anew. It happens
//! between `step::evaluate` and `step::advance`, in static phases at a converged state only. Displacements and velocities
//! are those of the tetrahedra of the parent; mass, momentum and angular momentum stay. The bonds of a cut block
//! are made anew by overlay: those with neighbours keep the stretch (and with it traction, breaks, softening and slip) that they
//! had, those between parts begin with the traction that the parent's stress has on the plane. Nothing is tested for
//! failure before the forces have converged again. What a cut does to the energy is booked as edit defect.
//!
//! Source: Han, Liu & Li (2010), section 3. Deviations: the criterion, the direction and the planes are those of
//! `laws::fracture` and `riprap_geom::polyhedron::cut`; bonds start under load and by overlay.

mod apply;
mod facets;
mod pressed;
mod select;
mod stretch;
pub mod tip;
mod transfer;

use crate::topology::family::{self, Family};
use transfer::{Cut, Handed};

use riprap_geom::Vec3;

use crate::deform;
use crate::exec::Exec;
use crate::laws::fracture::FractureMode;
use crate::push::charge;
use crate::query::view::View;
pub use crate::setup::deform::{CutAnchor as Anchor, CutRules as Rules};
use crate::setup::error::RefineError;
use crate::stable::deformable::alone;
pub use crate::state::cutting::{Cutting, Effort};
use crate::state::deform::Deform;
pub use crate::state::event::Note;
use crate::state::scratch::Scratch;
use crate::state::workspace::Workspace;
use crate::state::world::World;
use crate::topology::audit;
use crate::topology::bolts;
use crate::topology::error::EditError;
use crate::topology::fracture::CHECK_INTERVAL;
use crate::topology::transaction::transact;

/// Most blocks that a model may have after a cut.
const MAX_BLOCKS: usize = 4_000_000;
/// Share by which sums may change.
const EXACT: f64 = 1e-11;

/// Lets the present phase cut blocks, or not.
pub fn allow(world: &mut World, rules: Option<&Rules>) {
    let blocks = world.alive.len() as u32;
    let step = world.step;
    let Some(deform) = world.deform.as_deref_mut() else {
        return;
    };
    deform.given.get_or_insert(blocks);
    deform.cutting = rules.map(|rules| Cutting {
        rules: *rules,
        // The state that a phase begins with may not have been relaxed by its rules.
        last_check_step: step,
        stages: 0,
    });
}

/// Cuts the blocks whose criterion is met now; returns how many. Call it between `evaluate` and `advance` with the same
/// `dt` (s); a second call at the same step does nothing.
///
/// # Errors
/// Too many blocks, no bond law, forces that are not finite, a failed audit.
pub fn step(world: &mut World, scratch: &mut Scratch, dt: f64) -> Result<usize, EditError> {
    let now = world.step;
    let Some(deform) = world.deform.as_deref_mut() else {
        return Ok(0);
    };
    // The state on the way to an equilibrium says nothing of what the rock bears.
    let ready = match &deform.relax {
        Some(relax) => relax.converged,
        None => now.is_multiple_of(CHECK_INTERVAL) && now > 0,
    };
    let Some(cutting) = deform.cutting.as_mut().filter(|_| ready) else {
        return Ok(0);
    };
    if cutting.last_check_step == now || cutting.stages >= cutting.rules.stages {
        return Ok(0);
    }
    cutting.last_check_step = now;
    let rules = cutting.rules;
    // What bonds have lost on the way here is booked while they are there: those of cut blocks are replaced.
    crate::topology::fracture::settle(world);
    let cuts = select::plan(&View { world, scratch }, &rules);
    if cuts.is_empty() {
        return Ok(0);
    }
    let new: usize = cuts.iter().map(|c| c.parts.len()).sum();
    if world.alive.len() + new > MAX_BLOCKS {
        return Err(RefineError::TooMany.into());
    }
    let count = cuts.len();
    transact(world, scratch, dt, |world, scratch| {
        carry_out(world, scratch, cuts)?;
        if let Some(deform) = world.deform.as_deref_mut() {
            if let Some(cutting) = &mut deform.cutting {
                cutting.stages += 1;
            }
            if let Some(relax) = &mut deform.relax {
                relax.disturb();
            }
        }
        Ok(())
    })?;
    let ratio = View { world, scratch }.deformable_unbalanced();
    if let Some(deform) = world.deform.as_deref_mut() {
        deform.cut_blocks += count as u64;
        deform.cut_unbalanced = deform.cut_unbalanced.max(ratio.unwrap_or(0.0));
    }
    Ok(count)
}

/// Number of blocks that meet the criterion of cutting now and stay whole, because an earlier cut has left their faces crooked: their parts
/// would have another mass.
#[must_use]
pub fn crooked(view: &View<'_>) -> usize {
    let cutting = view.deformables().and_then(|(deform, _)| deform.cutting.as_ref());
    cutting.map_or(0, |cutting| select::crooked(view, &cutting.rules))
}

/// Cuts one block as told and evaluates anew, for tests and tools; returns its parts.
///
/// # Errors
/// As [`step()`].
pub fn one(
    world: &mut World,
    scratch: &mut Scratch,
    (block, normal, planes): (u32, Vec3, u32),
    dt: f64,
) -> Result<Vec<u32>, EditError> {
    let blocks = world.alive.len() as u32;
    if let Some(deform) = world.deform.as_deref_mut() {
        deform.given.get_or_insert(blocks);
    }
    let planned = |view: &View<'_>| {
        let (deform, work) = view.deformables()?;
        let body = deform.body(block as usize)?;
        let whole = (block, work.class(body).mesh.volume());
        let parts = select::divide(view.world, whole, normal, planes, (0.03, 0.0), None).ok()?;
        let note = Note { normal, mode: FractureMode::Tension, excess: 0.0 };
        Some(select::cut(view.world, (deform, work), body, note, parts))
    };
    let Some(cut) = planned(&View { world, scratch }) else {
        return Ok(Vec::new());
    };
    transact(world, scratch, dt, |world, scratch| carry_out(world, scratch, vec![cut]))?;
    Ok((blocks..world.alive.len() as u32).collect())
}

/// Does it all but the evaluation.
fn carry_out(world: &mut World, scratch: &mut Scratch, cuts: Vec<Cut>) -> Result<(), EditError> {
    let Some(work) = scratch.deform.as_deref() else {
        return Ok(());
    };
    let (whole, walls) = (world.clone(), charge::walls::state(world));
    let made =
        deform::beside(world, |world, deform| edit(world, deform, (work, &scratch.exec), &cuts));
    // A cut that fails half-way leaves the run as it was, to be saved and resumed from there.
    let made = made.transpose().inspect_err(|_| *world = whole)?.unwrap_or(0);
    charge::walls::renew(world, &walls);
    bolts::follow(world);
    let classes = cuts.iter().map(|cut| cut.classes.len()).sum();
    scratch.extend(world, cuts.into_iter().flat_map(|cut| cut.classes));
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref_mut())
    else {
        return Ok(());
    };
    let mut frequencies = 0;
    // Frequencies are for the time step, and a relaxation has none.
    if deform.relax.is_none() {
        let mut known = std::mem::take(&mut work.alone);
        // The facets that were made stand last.
        let made = deform.facets[deform.facets.len() - made..].iter();
        for block in made.flat_map(|facet| facet.blocks) {
            if let Some(known) = known.get_mut(deform.slot[block as usize] as usize) {
                *known = f64::NAN;
            }
        }
        (work.alone, frequencies) = alone::each(deform, work, known, &scratch.exec);
    }
    work.effort = Effort { classes, facets: made, frequencies };
    Ok(())
}

/// Cuts in the lists of blocks, bodies and facets; returns the number of facets made.
fn edit(
    world: &mut World,
    deform: &mut Deform,
    (work, exec): (&Workspace, &Exec),
    cuts: &[Cut],
) -> Result<usize, EditError> {
    let mut families: Vec<Family> = Vec::with_capacity(cuts.len());
    for Cut { block, note, parts, .. } in cuts {
        let first = families.last().map_or(world.alive.len() as u32, |f| f.children().end);
        families.push(Family { parent: *block, first, parts, note: Some(*note) });
    }
    apply::append(world, deform, &families, cuts);
    family::follow(&mut world.setup, &families);
    for Cut { block, handed: Handed { before, after, .. }, .. } in cuts {
        // That they have no more energy of motion is seen to before.
        let reach = world.solid_of(*block as usize).radius + before.centre.length();
        audit::motion(world, *block, [before, after], EXACT, reach)?;
    }
    let (counts, made) = facets::rebuild(world, deform, work, &families, exec)?;
    for (family, counts) in families.iter().zip(counts) {
        world.alive[family.parent as usize] = false;
        deform.still(family.parent);
        family::record(world, family, counts);
    }
    crate::deform::build::hold_anew(world, deform);
    Ok(made)
}
