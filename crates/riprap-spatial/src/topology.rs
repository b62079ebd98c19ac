//! Changes of topology between two steps: splitting blocks 1 to 8, cutting deformable ones, breaking bonds, taking blocks out and adding some.
//!
//! One transaction for all ([`transact`]), between `step::evaluate` and `step::advance`, when forces and positions belong to one instant:
//!
//! ```text
//!            forces known at t                                             forces known at t, new blocks
//!   ---- evaluate ----+                                                       +---- advance ---->
//!                     |                                                       |
//!                   plan   ->   apply   ->   audit   ->   lay out   ->   evaluate   ->   book
//!                 reads only    world        refuses      scratch       no time goes    edit defect =
//!                 stress of     alone:       what was     made anew     by: works and   residual after
//!                 parents,      children,    not kept:                  slips stay      - residual before
//!                 old slips     patches,     mass,
//!                               faces,       momenta,
//!                               conditions   volume
//! ```
//!
//! Why in this order. The plan reads forces, so it must come before anything moves, and it changes nothing, so a plan that is
//! refused (too many blocks) leaves the run whole. Apply touches the `World` alone: whatever `Scratch` holds (pieces, slots, packets) is
//! a function of the world and is made anew, never patched, and so cannot disagree with it. The audit compares sums of children with
//! their parent before the first force is found with them: a wrong mass is named at the block, not met as a strange motion later.
//! Evaluating again books no work, because no time has gone by (`World::pending` is 0 after the first call).
//!
//! What is kept, and how:
//!
//! ```text
//!     parent                 children          rigid motion  v + w x r, w      mass, momentum, angular momentum, kinetic energy
//!   +---------+             +----+----+        outer patches displacement and  tractions at the new stiffness; what this does to the
//!   |    o-> v|     ->      | o->| o->|        +             slip              energy of springs is edit defect
//!   |    w    |             +----+----+        inner patches start with the parent's average stress (1/V) sum r (x) f, symmetrised:
//!   +---------+             | o->| o->|        ##            the block that carried a load goes on carrying it
//!                           +----+----+        groups, names, supports, loads, walls of cavities go on to the parts they touch
//! ```
//!
//! New forces on new masses also change the time-centred kinetic energy. Both changes are the difference of the ledger's residual before
//! and after, booked as one line, so the residual itself is the same before and after: an edit can neither hide nor make a fault of the steps.

pub mod add;
pub mod bolts;
pub mod cut;
pub mod fracture;
pub mod material;
pub(crate) mod refine;

pub(crate) mod audit;
pub(super) mod error;
mod family;
mod gradual;
mod measure;
mod patches;
mod remove;
mod split;
mod transaction;

pub use error::EditError;
pub use gradual::take_out_gradually;
pub use remove::remove;
pub use transaction::transact;

use crate::faces::region::Extent;
use crate::joint::classes::stiffness;
use crate::query::view::View;
use crate::setup::During;
use crate::setup::error::{MAX_LEVELS, RefineError};
pub use crate::state::event::{EditEvent, EditKind};
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::topology::refine::Forest;

/// Gives patches stiffness and dashpots of the laws as they are now. Displacements and slip stay, so
/// that tractions change with the stiffness.
pub fn renew_laws(world: &mut World) {
    for class in &mut world.classes {
        let n = class.frame[0];
        // Both positive: the arm of j looks against the normal.
        let depths = [class.arms[0].dot(n), -class.arms[1].dot(n)];
        let materials = class.materials.map(usize::from);
        // Laws of materials without moduli are given as numbers, at the start and later.
        if let Ok((stiffness, travel)) = stiffness(&world.setup, class.row, materials, depths) {
            let joint = &world.setup.interfaces[class.row as usize].joint;
            class.stiffness = stiffness;
            class.beta = joint.damping * travel;
        }
    }
}

/// Divides the strengths of the given rows of the interface table by `factor`: of patches, found contacts and bonds of
/// deformable blocks. Nothing else changes; what is beyond the new strength slides or breaks in the next step.
pub fn reduce_strengths(world: &mut World, rows: &[u16], factor: f64) {
    for &row in rows {
        let law = &mut world.setup.interfaces[row as usize];
        law.joint = law.joint.reduced(factor);
        law.bond = law.bond.map(|bond| bond.reduced(factor));
    }
}

/// Splits and cuts the blocks whose criterion is met now. Call it between `evaluate` and `advance` with the same `dt` (s); a
/// second call at the same step does nothing.
///
/// # Errors
/// Too many blocks, no bond law, forces that are not finite, a failed audit.
pub fn divide(world: &mut World, scratch: &mut Scratch, dt: f64) -> Result<(), EditError> {
    refine_running(world, scratch, dt)?;
    cut::step(world, scratch, dt)?;
    Ok(())
}

/// Splits the blocks whose criterion is met now; returns how many. As [`divide`].
///
/// # Errors
/// Too many blocks, a failed audit.
pub fn refine_running(
    world: &mut World,
    scratch: &mut Scratch,
    dt: f64,
) -> Result<usize, EditError> {
    if world.last_check_step == world.step {
        return Ok(0);
    }
    world.last_check_step = world.step;
    let splits = plan(world, scratch)?;
    if !splits.is_empty() {
        split(world, scratch, &splits, dt)?;
    }
    Ok(splits.len())
}

/// Blocks to split at the present step, coarser neighbours before the blocks that need them.
///
/// # Errors
/// Too many blocks.
pub fn plan(world: &World, scratch: &Scratch) -> Result<Vec<u32>, EditError> {
    let due = |during: &During| {
        during.every > 0 && world.step > 0 && world.step.is_multiple_of(during.every)
    };
    let mut hits: Vec<u32> = Vec::new();
    for refinement in &world.setup.refinements {
        let Some(during) = refinement.during.filter(due) else {
            continue;
        };
        let levels = refinement.levels.min(MAX_LEVELS);
        let measure = measure::of(&View { world, scratch }, during.criterion);
        for (b, value) in measure.iter().enumerate() {
            if world.alive[b]
                && *value > during.above
                && world.lineage[b].level < levels
                && Extent::of(&world.setup.blocks[b].shape).touches(&refinement.around)
            {
                hits.push(b as u32);
            }
        }
    }
    hits.sort_unstable();
    hits.dedup();
    if hits.is_empty() {
        return Ok(hits);
    }
    let mut forest = Forest::new(&world.setup, &world.lineage, &world.alive);
    // What bonds join to a block that bends stays as it is: bonds are not divided.
    let facets = world.deform.iter().flat_map(|deform| &deform.facets);
    facets.for_each(|facet| facet.blocks.iter().for_each(|&b| forest.keep_whole(b)));
    for b in hits {
        match forest.split(b) {
            Ok(()) => {}
            // It has no eight parts similar to it, and stays.
            Err(Some(_)) => {}
            Err(None) => return Err(RefineError::TooMany.into()),
        }
    }
    Ok(forest.into_splits())
}

/// Splits blocks (in this order; children may be split again by their future number) and re-evaluates.
///
/// # Errors
/// A failed audit.
pub fn split(
    world: &mut World,
    scratch: &mut Scratch,
    splits: &[u32],
    dt: f64,
) -> Result<(), EditError> {
    transact(world, scratch, dt, |world, scratch| {
        let plan = split::Plan::new(&View { world, scratch }, splits);
        split::apply(world, &plan)?;
        bolts::follow(world);
        audit::splits(world, plan.blocks)?;
        scratch.invalidate(world);
        Ok(())
    })
}
