//! The frame of every edit: end of the motion, the edit itself, evaluation, what it makes of the energy.

use crate::query::view::View;
use crate::state::scratch::{NonFinite, Scratch};
use crate::state::world::World;
use crate::step;
use crate::topology::error::EditError;

/// Carries out an edit between `evaluate` and `advance`: ends the motion, so that what comes new begins with half a kick of forces
/// of its own, changes the world by `act`, which lays out the scratch data, and re-evaluates for a step of `dt` (s). The change of
/// the ledger's residual is edit defect.
///
/// # Errors
/// Those of `act`, forces that are not finite.
pub fn transact<T>(
    world: &mut World,
    scratch: &mut Scratch,
    dt: f64,
    act: impl FnOnce(&mut World, &mut Scratch) -> Result<T, EditError>,
) -> Result<T, EditError> {
    step::end_motion(world, scratch, &scratch.damping.clone())?;
    booked(world, scratch, dt, act)
}

/// Does `act` and re-evaluates; the change of the residual is edit defect, as nothing moves meanwhile.
pub(super) fn booked<T, E: From<NonFinite>>(
    world: &mut World,
    scratch: &mut Scratch,
    dt: f64,
    act: impl FnOnce(&mut World, &mut Scratch) -> Result<T, E>,
) -> Result<T, E> {
    let before = View { world, scratch }.balance().residual();
    let done = act(world, scratch)?;
    step::evaluate(world, scratch, &scratch.damping.clone(), dt)?;
    let after = View { world, scratch }.balance().residual();
    world.works.edit_defect += after - before;
    Ok(done)
}
