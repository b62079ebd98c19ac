//! Cavities push on their walls: ignition, volumes, pressures and their work.

use crate::push::charge::hole;
use crate::push::charge::walls;
use crate::push::charge::walls::Spot;
use crate::push::charge::{EARLY, upward};
use crate::push::gas;
use crate::setup::{CavityPressure, Hole, Venting};
use crate::state::event::EditKind;
use crate::state::push::Account;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Finds volumes and pressures at the present positions and pushes the walls with them; `dt` is the coming step (s).
///
/// Calling it again without moving changes nothing.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch, dt: f64) {
    let pushes = &mut scratch.pushes.own;
    if world.cavities.iter().any(|c| !c.walls.is_empty()) {
        pushes.need_blocks(world.alive.len());
    }
    if let Some(deform) = world.deform.as_ref()
        && world.cavities.iter().any(|c| c.nodal.area > 0.0)
    {
        pushes.need_nodes(deform.nodes.len());
    }
    for k in 0..world.cavities.len() {
        walls::follow(world, k);
        ignite(world, k, dt);
        match world.cavities[k].ignited {
            None => hold(world, k, pushes),
            Some(_) => expand(world, k, dt, pushes),
        }
    }
    gas::act(world, scratch, dt);
}

fn ignite(world: &mut World, k: usize, dt: f64) {
    let swept = walls::swept(world, &world.cavities[k]);
    let cavity = &mut world.cavities[k];
    let delay = world.setup.sources[cavity.source as usize].delay;
    if cavity.ignited.is_some() || world.time + EARLY * dt < delay {
        return;
    }
    cavity.ignited = Some(world.time);
    match &cavity.gas {
        Some(gas) => {
            cavity.base = swept;
            cavity.volume = gas.start;
        }
        None => cavity.volume = cavity.removed + swept,
    }
    let event = world.event(EditKind::Ignited, k as u32);
    world.events.push(event);
}

/// Before the ignition: walls carry what the charge carried.
fn hold(world: &mut World, k: usize, pushes: &mut Account) {
    let cavity = &world.cavities[k];
    for wall in &cavity.walls {
        pushes.on_block(wall.block, wall.hold, wall.hold_moment);
    }
    for (node, force) in walls::held_nodes(world, cavity) {
        pushes.on_node(node, force);
    }
    let work = walls::held(world, cavity);
    let cavity = &mut world.cavities[k];
    world.works.gas += work - cavity.held;
    cavity.held = work;
}

/// After the ignition: volume, pressure, work, venting.
fn expand(world: &mut World, k: usize, dt: f64, pushes: &mut Account) {
    hole::run_on(world, k);
    hole::push_out(world, k);
    let cavity = &world.cavities[k];
    for wall in cavity.walls.iter().filter(|wall| cavity.holds(wall)) {
        pushes.on_block(wall.block, wall.hold, wall.hold_moment);
    }
    let swept = walls::swept(world, &world.cavities[k]);
    if begins_to_vent(world, k) {
        world.cavities[k].venting = Some(world.time);
        let event = world.event(EditKind::Vented, k as u32);
        world.events.push(event);
    }
    let cavity = &mut world.cavities[k];
    let source = &world.setup.sources[cavity.source as usize];
    let before = (cavity.volume, cavity.pressure);
    if let Some(gas) = &cavity.gas {
        cavity.volume = hole::room(source, cavity, gas) + gas.factor * (swept - cavity.base);
    }
    let work = match (&source.push, &cavity.gas) {
        // The rest is done with the gas in its cracks.
        (CavityPressure::Gas { venting: Some(Venting::Cracks(_)), .. }, Some(_)) => return,
        (CavityPressure::Gas { mass, .. }, Some(gas)) if source.hole != Hole::default() => {
            let gas = *gas;
            cavity.keep(source, &gas, *mass, world.pending);
            let grown = gas.factor * (swept - cavity.base);
            let moved = grown - std::mem::replace(&mut cavity.known, grown);
            0.5 * (before.1 + cavity.pressure) * moved
        }
        (CavityPressure::Gas { venting, .. }, Some(gas)) => {
            cavity.pressure =
                cavity.sealed(*venting, world.time) * gas.adiabat.pressure(cavity.volume);
            if cavity.venting.is_some() {
                0.5 * (before.1 + cavity.pressure) * (cavity.volume - before.0)
            } else {
                gas.adiabat.work(cavity.volume) - gas.adiabat.work(before.0)
            }
        }
        (CavityPressure::Pressure { time }, _) => {
            let ignited = cavity.ignited.unwrap_or(world.time);
            cavity.volume = cavity.removed + swept - cavity.base;
            cavity.pressure = time.at(world.time - ignited);
            0.5 * (before.1 + cavity.pressure) * (cavity.volume - before.0)
        }
        (CavityPressure::Gas { .. }, None) => return,
    };
    cavity.work += work;
    world.works.gas += work;
    let pressures = [before.1, cavity.pressure];
    hole::speed_up(world, k, pressures);
    let cavity = &world.cavities[k];
    // A push that begins now acts on the part of the kick after the present time only.
    let begins = cavity.ignited == Some(world.time) && cavity.burn.is_none() && dt > 0.0;
    let share = if begins { dt / (world.last_dt + dt) } else { 1.0 };
    let pressure = share * cavity.pressure * cavity.gas.map_or(1.0, |g| g.factor);
    press(world, k, pressure, dt, pushes);
}

/// Pushes the walls of cavity `k` with a pressure (Pa), the factor on the faces included; `dt` is the coming step (s).
pub(super) fn press(world: &World, k: usize, pressure: f64, dt: f64, pushes: &mut Account) {
    let cavity = &world.cavities[k];
    let freedoms = world.all_freedoms();
    let on_nodes = walls::on_nodes(world, cavity.source).map(|spot| (spot, 0.0));
    for (Spot { anchor, area, normal }, after) in walls::on_blocks(cavity).chain(on_nodes) {
        let share = hole::share_of_kick(world, cavity, after, dt);
        freedoms.push(pushes, &anchor, -(share * pressure) * area * normal);
    }
}

/// Whether the gas of a cavity that has gone off begins to escape now.
fn begins_to_vent(world: &World, k: usize) -> bool {
    let cavity = &world.cavities[k];
    let CavityPressure::Gas { venting, .. } = &world.setup.sources[cavity.source as usize].push
    else {
        return false;
    };
    if cavity.venting.is_some() {
        return false;
    }
    if cavity.column.is_some_and(|column| column.out.is_some()) {
        return true;
    }
    match venting {
        None | Some(Venting::Cracks(_)) => false,
        Some(Venting::Time { start, .. }) => {
            world.time >= cavity.ignited.unwrap_or(world.time) + start
        }
        Some(Venting::Heave { height }) => {
            let (up, freedoms) = (upward(world.gravity), world.all_freedoms());
            let living: Vec<f64> = cavity
                .above
                .iter()
                .filter(|b| world.alive[**b as usize])
                .map(|b| freedoms.displacement(&world.centroid(*b)).dot(up))
                .collect();
            let mean = living.iter().sum::<f64>() / living.len() as f64;
            mean >= *height
        }
    }
}
