//! The stage of the step: ignition, volumes, pressures, work, and the limit of the step.

use super::{Cavity, EARLY, soft, upward};
use crate::setup::{Push as Kind, Venting};
use crate::state::event::EditKind;
use crate::state::push::Account;
use crate::state::scratch::Scratch;
use crate::world::World;

/// Largest step that cavities allow at the present state, s; the run loop takes the smallest of all limits, every step.
///
/// A charge that has not gone off yet is met on time, and its first step is already limited.
#[must_use]
pub fn step_limit(world: &World) -> f64 {
    let mut limit = f64::INFINITY;
    for cavity in &world.cavities {
        let remaining = match cavity.ignited {
            Some(_) => 0.0,
            None => world.setup.sources[cavity.source as usize].delay - world.time,
        };
        let gas = cavity.gas_limit(world);
        let own = if remaining <= EARLY * world.last_dt {
            gas
        } else if gas.is_finite() {
            remaining.max(gas)
        } else {
            remaining
        };
        limit = limit.min(own);
    }
    limit
}

/// Finds volumes and pressures at the present positions and what they push with; `dt` is the coming step (s).
///
/// Calling it again without moving changes nothing.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch, dt: f64) {
    if world.cavities.is_empty() {
        return;
    }
    let pushes = &mut scratch.pushes.own;
    let mut cavities = std::mem::take(&mut world.cavities);
    pushes.need_blocks(world.alive.len());
    if let Some(deform) = world.deform.as_ref()
        && cavities.iter().any(|c| c.soft.area > 0.0)
    {
        pushes.need_nodes(deform.nodes.len());
    }
    for (k, cavity) in cavities.iter_mut().enumerate() {
        ignite(world, k, cavity, dt);
        match cavity.ignited {
            None => {
                soft::hold(world, cavity.source, pushes);
                hold(world, cavity, pushes);
            }
            Some(at) => {
                // A push that begins now acts on the part of the kick after the present time only.
                let share = if at == world.time && dt > 0.0 {
                    dt / (world.last_dt + dt)
                } else {
                    1.0
                };
                expand(world, k, cavity, share, pushes);
                let factor = cavity.gas.map_or(1.0, |g| g.factor);
                let pressure = share * cavity.pressure * factor;
                soft::push(world, cavity.source, pressure, pushes);
            }
        }
    }
    world.cavities = cavities;
}

fn ignite(world: &mut World, k: usize, cavity: &mut Cavity, dt: f64) {
    let delay = world.setup.sources[cavity.source as usize].delay;
    if cavity.ignited.is_some() || world.time + EARLY * dt < delay {
        return;
    }
    cavity.ignited = Some(world.time);
    let swept = swept(world, cavity);
    match &cavity.gas {
        Some(gas) => {
            cavity.base = swept;
            cavity.volume = gas.start;
        }
        None => cavity.volume = cavity.removed + swept,
    }
    world.events.push(world.event(EditKind::Ignited, k as u32));
}

fn swept(world: &World, cavity: &Cavity) -> f64 {
    let rigid: f64 = cavity.walls.iter().map(|w| w.swept(world)).sum();
    rigid + soft::swept(world, cavity.source)
}

/// Before the ignition: walls carry what the charge carried.
fn hold(world: &mut World, cavity: &mut Cavity, pushes: &mut Account) {
    for wall in &cavity.walls {
        pushes.on_block(wall.block, wall.hold, wall.hold_moment);
    }
    let work = cavity.held_now(world);
    world.works.gas += work - cavity.held;
    cavity.held = work;
}

/// After the ignition: volume, pressure, work, venting.
fn expand(world: &mut World, k: usize, cavity: &mut Cavity, share: f64, pushes: &mut Account) {
    let source = &world.setup.sources[cavity.source as usize];
    let ignited = cavity.ignited.unwrap_or(world.time);
    let swept = swept(world, cavity);
    let before = (cavity.volume, cavity.pressure);
    let (factor, work);
    match (&source.push, &cavity.gas) {
        (Kind::Gas { venting, .. }, Some(gas)) => {
            let began = begins_to_vent(world, cavity, *venting, ignited);
            if began {
                cavity.venting = Some(world.time);
                let event = world.event(EditKind::Vented, k as u32);
                world.events.push(event);
            }
            factor = gas.factor;
            cavity.volume = gas.start + factor * (swept - cavity.base);
            cavity.pressure =
                cavity.sealed(*venting, world.time) * gas.adiabat.pressure(cavity.volume);
            work = if cavity.venting.is_some() {
                0.5 * (before.1 + cavity.pressure) * (cavity.volume - before.0)
            } else {
                gas.adiabat.work(cavity.volume) - gas.adiabat.work(before.0)
            };
        }
        (Kind::Pressure { time }, _) => {
            factor = 1.0;
            cavity.volume = cavity.removed + swept - cavity.base;
            cavity.pressure = time.at(world.time - ignited);
            work = 0.5 * (before.1 + cavity.pressure) * (cavity.volume - before.0);
        }
        (Kind::Gas { .. }, None) => return,
    }
    cavity.work += work;
    world.works.gas += work;
    for wall in &cavity.walls {
        let force = share * cavity.pressure * factor * wall.area * wall.normal;
        pushes.on_block(wall.block, force, wall.motion(world).1.cross(force));
    }
}

/// Whether the gas begins to escape now.
fn begins_to_vent(world: &World, cavity: &Cavity, venting: Option<Venting>, ignited: f64) -> bool {
    if cavity.venting.is_some() {
        return false;
    }
    match venting {
        None => false,
        Some(Venting::Time { start, .. }) => world.time >= ignited + start,
        Some(Venting::Heave { height }) => {
            let up = upward(world.gravity);
            let living: Vec<f64> = cavity
                .above
                .iter()
                .map(|&b| b as usize)
                .filter(|&b| world.alive[b])
                .map(|b| soft::displacement(world, b).dot(up))
                .collect();
            let mean = living.iter().sum::<f64>() / living.len() as f64;
            mean >= height
        }
    }
}
