//! Gas of charges that enters cracks, pushes their sides and vents ([`crate::flow`]).
//!
//! A crack whose sides have moved farther from each other than the smaller block is large encloses nothing any more: what flows into it is in the air.
//!
//! The network (`network`) is that of the joints between living blocks as they were built. A joint conducts once two of its four points have failed;
//! its aperture is what it is when its sides touch plus the opening in its middle. At each evaluation apertures and volumes follow from the present positions, the gas
//! flows for the time that has passed, and its pressures push both sides until the next one. The sides of a crack are pushed at their own places by opposite forces,
//! so that momentum is kept; the work of a step is that of the mean of the forces at its ends on the way between them, as for all forces of the leapfrog.
//!
//! Blocks carry no pressure of the air, so that gas pushes with what it has above that. A cavity shares the adiabat with its cracks by density: as long
//! as none of them conducts, it is the sealed one.

mod network;

use riprap_geom::Vec3;

use crate::exec::{CHUNK, Exec};
use crate::flow::{Cells, Desk, Fluid};
use crate::push::charge::hole;
use crate::setup::{CavityPressure, Cracks, Source, Venting};
use crate::state::anchor::{Anchor, Freedoms};
use crate::state::cavity::Cavity;
use crate::state::event::EditKind;
use crate::state::gas::{Crack, CrackGas, GasBooks};
use crate::state::patches::flag;
use crate::state::push::Account;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Failed points of a patch from which on gas enters: two of four, a half of it.
const FAILED: u32 = 2;
/// Share of the gas that has left when it counts as leaving: less is round-off.
const LEAVES: f64 = 1e-9;
/// Work that the gas could still do against the air, over the energy released, at which it has nothing more to do: what is left goes into the air.
const SPENT: f64 = 1e-5;
/// Share of the gas in cracks, by pressure times volume, that a step of the flow may change: steps become longer below it, shorter above it.
const CHANGE: f64 = 0.02;
/// Most steps of the rock in a step of the flow.
const LONGEST: u32 = 32;
/// Steps of Newton's method from which on steps of the flow become no longer.
const MANY_TURNS: usize = 6;
/// Relative change of a density up to which the pressure follows it by a parabola: exact to 1e-9.
const NEAR: f64 = 1e-3;
/// Step over the inverse of the frequency of blocks on the gas in cracks, as if it could not flow: 2 would be the limit of stability, and
/// joints have theirs beside it.
const CRACK_STEP: f64 = 0.8;

/// How the gas of a source flows in cracks, if it does.
pub(crate) fn rules(source: &Source) -> Option<&Cracks> {
    match &source.push {
        CavityPressure::Gas { venting: Some(Venting::Cracks(cracks)), .. } => Some(cracks),
        CavityPressure::Gas { .. } | CavityPressure::Pressure { .. } => None,
    }
}

impl World {
    /// How the gas of a cavity flows in cracks, if it does.
    pub(crate) fn cracks_of(&self, cavity: &Cavity) -> Option<&Cracks> {
        rules(&self.setup.sources[cavity.source as usize])
    }

    /// The gas in the cracks between two blocks: number of each.
    fn cracks_between(&self, pair: [u32; 2]) -> impl Iterator<Item = (usize, &Crack)> {
        let key = [pair[0].min(pair[1]), pair[0].max(pair[1])];
        let list = self.gas.as_ref().map_or(&[][..], |gas| &gas.cracks);
        let first = list.partition_point(|crack| crack.blocks < key);
        (first..).zip(list[first..].iter().take_while(move |c| c.blocks == key))
    }

    /// Largest of a number over the cracks between two blocks that gas may enter.
    pub(crate) fn largest_in_cracks(
        &self,
        pair: [u32; 2],
        get: impl Fn(&Crack, f64) -> f64,
    ) -> f64 {
        let Some(gas) = &self.gas else { return 0.0 };
        let open = self.cracks_between(pair).filter(|(_, crack)| crack.open);
        open.map(|(k, crack)| get(crack, gas.masses[k])).fold(0.0, f64::max)
    }
}

/// Lets the gas of all cavities that have gone off flow, and pushes walls and cracks with it; volumes of cavities are known.
pub(super) fn act(world: &mut World, scratch: &mut Scratch, dt: f64) {
    let off = |c: &Cavity| c.ignited.is_some() && world.cracks_of(c).is_some();
    if !world.cavities.iter().any(off) || is_gone(world) {
        return;
    }
    let Some(mut gas) = network::current(world) else { return };
    release(world, &mut gas);
    if world.pending > 0.0 {
        gas.waits += world.pending;
        gas.passed += 1;
    }
    let due = gas.passed >= gas.every;
    let new = open(world, &mut gas);
    follow(world, &mut gas, &scratch.exec);
    if new {
        world.gas = Some(gas);
        // Who is pushed now is done one by one from here on.
        scratch.tiles.make_rows(world);
        let Some(again) = world.gas.take() else { return };
        gas = again;
    }
    if due {
        flow(world, &mut gas, (&scratch.exec, &mut scratch.flow));
        end(world, &mut gas);
    }
    if due || gas.limit == 0.0 {
        gas.limit = limit(world, &gas);
    }
    if gas.books.vented > LEAVES * gas.books.mass {
        note_venting(world, &gas);
    }
    let pushes = &mut scratch.pushes.own;
    pushes.need_blocks(world.alive.len());
    push_cracks(world, &mut gas, pushes);
    for k in 0..gas.cavities.len() {
        push_walls(world, &mut gas, k, dt, pushes);
    }
    world.gas = Some(gas);
}

/// Whether all charges have gone off and none of their gas is left.
fn is_gone(world: &World) -> bool {
    let Some(gas) = &world.gas else { return false };
    gas.masses.iter().all(|mass| *mass == 0.0) && all_is_out(world, gas)
}

/// Whether nothing comes any more: all charges have burned, and no stemming is on its way.
fn all_is_out(world: &World, gas: &CrackGas) -> bool {
    gas.cavities.iter().map(|k| &world.cavities[*k as usize]).all(|cavity| {
        let burned = cavity.burn.is_none_or(|burn| burn.given >= 1.0);
        let open = cavity.column.is_none_or(|column| column.out.is_some());
        cavity.ignited.is_some_and(|time| time < world.time) && burned && open
    })
}

/// Lets out what is left of gas that can do no work any more that counts: it would cost as much as before.
fn end(world: &World, gas: &mut CrackGas) {
    if !all_is_out(world, gas) {
        return;
    }
    let CrackGas { cracks, cavities, masses, fluid, rules, books, .. } = gas;
    let volumes = cracks.iter().map(|crack| crack.volume);
    let volumes = volumes.chain(cavities.iter().map(|k| world.cavities[*k as usize].volume));
    let filled = || masses.iter().copied().zip(volumes.clone()).filter(|(mass, _)| *mass > 0.0);
    let air = fluid.density(rules.air);
    let lowest = fluid.energy(air);
    let work = |(mass, volume): (f64, f64)| {
        let density = mass / volume;
        if density <= air {
            return 0.0;
        }
        let against = if air > 0.0 { rules.air * (mass / air - volume) } else { 0.0 };
        mass * (fluid.energy(density) - lowest) - against
    };
    // No part of it is negative: most of the time the first ones are too much.
    let enough = SPENT * books.released;
    let left = filled().map(work).try_fold(0.0, |sum, part| {
        let sum = sum + part;
        (sum <= enough).then_some(sum)
    });
    if left.is_none() {
        return;
    }
    books.carried += filled().map(|(mass, volume)| mass * fluid.energy(mass / volume)).sum::<f64>();
    books.vented += masses.iter().sum::<f64>();
    masses.fill(0.0);
    for crack in cracks {
        crack.pressure = 0.0;
        crack.known = [0.0; 3];
    }
}

/// Notes that the gas of charges that have gone off has begun to leave.
fn note_venting(world: &mut World, gas: &CrackGas) {
    for &k in &gas.cavities {
        let cavity = &mut world.cavities[k as usize];
        if cavity.ignited.is_some() && cavity.venting.is_none() {
            cavity.venting = Some(world.time);
            let event = world.event(EditKind::Vented, k);
            world.events.push(event);
        }
    }
}

/// Puts the gas of what has burned of charges into their cavities, and takes out what leaves through open holes.
fn release(world: &mut World, gas: &mut CrackGas) {
    for k in 0..gas.cavities.len() {
        let cell = gas.cracks.len() + k;
        let number = gas.cavities[k] as usize;
        let cavity = &mut world.cavities[number];
        let (Some(own), Some(ignited)) = (cavity.gas, cavity.ignited) else { continue };
        let charge = gas.fluid.mass * own.adiabat.v0() / gas.fluid.adiabat.v0();
        let begins = ignited == world.time && gas.masses[cell] == 0.0 && cavity.pressure == 0.0;
        let given = match &mut cavity.burn {
            Some(burn) => {
                let share = burn.share();
                share - std::mem::replace(&mut burn.given, share)
            }
            None if begins => 1.0,
            None => 0.0,
        };
        if begins {
            gas.every = 1;
        }
        let mass = given * charge;
        if mass > 0.0 {
            let released = given * own.adiabat.held(own.start);
            let (old, volume) = (gas.masses[cell], cavity.volume - given * own.start);
            gas.masses[cell] += mass;
            gas.books.mass += mass;
            gas.books.released += released;
            if old > 0.0 {
                // The adiabat holds less than its parts: what mixes comes to one density.
                let energy = |m: f64, v: f64| m * gas.fluid.energy(m / v);
                let now = energy(gas.masses[cell], cavity.volume);
                gas.books.numerical += energy(old, volume) + released - now;
            }
        }
        let source = &world.setup.sources[cavity.source as usize];
        let held = gas.masses[cell];
        let rate = hole::outflow(source, cavity, &gas.fluid, held / cavity.volume);
        if rate > 0.0 && world.pending > 0.0 {
            let left = held * -libm::expm1(-rate * world.pending / held);
            let [energy, enthalpy, _] = gas.fluid.energies(held / cavity.volume);
            gas.masses[cell] -= left;
            let now = gas.masses[cell] * gas.fluid.energy(gas.masses[cell] / cavity.volume);
            gas.books.vented += left;
            gas.books.carried += enthalpy * left;
            gas.books.numerical += held * energy - now - enthalpy * left;
            if let Some(column) = &mut cavity.column {
                column.vented += left;
            }
        }
    }
}

/// Opens the cracks whose joints have failed; whether there is a new one.
fn open(world: &World, gas: &mut CrackGas) -> bool {
    let mut new = false;
    let list = &world.patches;
    let failed = |flags: &&u16| (*flags & flag::BROKEN).count_ones() >= FAILED;
    // Joints fail one by one, and go one by one where found contact takes over.
    let known = [list.len(), list.flags.iter().filter(failed).count()];
    if std::mem::replace(&mut gas.failed, known) == known {
        return false;
    }
    for (ends, flags) in list.ends.iter().zip(&list.flags) {
        if (flags & flag::BROKEN).count_ones() < FAILED {
            continue;
        }
        let key = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let first = gas.cracks.partition_point(|crack| crack.blocks < key);
        for crack in gas.cracks[first..].iter_mut().take_while(|c| c.blocks == key) {
            new |= !crack.open;
            crack.open = true;
        }
    }
    new
}

/// Takes the cracks along to where their blocks are, and their pressures to their volumes.
fn follow(world: &World, gas: &mut CrackGas, exec: &Exec) {
    let CrackGas { cracks, masses, rules, fluid, books, .. } = gas;
    let freedoms = world.all_freedoms();
    let mut went = vec![Went::default(); cracks.len()];
    let mut nothing = vec![(); cracks.len().div_ceil(CHUNK)];
    exec.chunks2(cracks, &mut went, &mut nothing, |from, cracks, went, ()| {
        for (k, (crack, went)) in cracks.iter_mut().zip(went).enumerate() {
            if crack.open && !crack.gone {
                *went = crack.go(world, &freedoms, (fluid, masses[from + k]), rules);
            }
        }
    });
    for ((crack, mass), went) in cracks.iter_mut().zip(masses.iter_mut()).zip(went) {
        books.air += went.air;
        books.work += went.work;
        books.in_cracks += went.work;
        if crack.gone || went.parted {
            crack.gone = true;
            crack.drain(mass, fluid, rules, books);
        }
    }
}

/// What the way of a crack since the evaluation before has done.
#[derive(Clone, Copy, Debug, Default)]
struct Went {
    /// Work against the air, J.
    air: f64,
    /// The first half of the work of this step, J; the other follows with the new force.
    work: f64,
    /// Whether its sides no longer face each other.
    parted: bool,
}

impl Crack {
    /// Goes to where its blocks are, with this mass (kg) of gas in it.
    fn go(
        &mut self,
        world: &World,
        freedoms: &Freedoms,
        (fluid, mass): (&Fluid, f64),
        rules: &Cracks,
    ) -> Went {
        let mut went = Went::default();
        let (jump, opening) = place(world, freedoms, self);
        let before = self.volume;
        // What presses its sides together takes nothing from the aperture that they have then.
        let aperture = rules.aperture + opening.max(0.0);
        self.volume = self.area * aperture;
        self.aperture = aperture.min(rules.widest);
        if mass > 0.0 {
            let old = self.pressure;
            self.follow(fluid, mass);
            let air = 0.5 * (old.min(rules.air) + self.pressure.min(rules.air));
            went.air = air * (self.volume - before);
        }
        // One that has just opened has no way behind it.
        let moved = if before > 0.0 { jump - self.jump } else { Vec3::ZERO };
        self.jump = jump;
        went.work = 0.5 * self.push.dot(moved);
        self.moved = moved;
        let size = self.blocks.map(|b| world.solid_of(b as usize).radius);
        went.parted = jump.length() > size[0].min(size[1]);
        went
    }

    /// Lets out what is in a crack whose sides no longer face each other. Its aperture stays the widest, so that what reaches it goes the same way.
    fn drain(&mut self, mass: &mut f64, fluid: &Fluid, rules: &Cracks, books: &mut GasBooks) {
        if *mass > 0.0 {
            books.vented += *mass;
            books.carried += *mass * fluid.energy(*mass / self.volume);
            *mass = 0.0;
        }
        self.aperture = rules.widest;
        self.volume = self.area * rules.widest;
        self.pressure = 0.0;
        self.known = [0.0; 3];
    }

    /// Takes the pressure to the present density: by a parabola as long as it is near the one at which it was found last.
    fn follow(&mut self, fluid: &Fluid, mass: f64) {
        let density = mass / self.volume;
        let off = density / self.known[0] - 1.0;
        // What was not found yet has a density of 0.
        if off.abs() > NEAR || off.is_nan() {
            return self.find(fluid, mass);
        }
        let [_, pressure, bulk] = self.known;
        // p ~ rho^g with g = K/p.
        self.pressure = pressure + bulk * off * (1.0 + 0.5 * (bulk / pressure - 1.0) * off);
    }

    /// Finds pressure and bulk modulus at the present density.
    fn find(&mut self, fluid: &Fluid, mass: f64) {
        self.take(fluid, mass, fluid.pressure(mass / self.volume));
    }

    /// Takes over the pressure (Pa) at the present density.
    fn take(&mut self, fluid: &Fluid, mass: f64, pressure: f64) {
        let density = mass / self.volume;
        self.pressure = pressure;
        self.known = [density, pressure, fluid.bulk_at(density, pressure)];
    }
}

/// Displacement of the second side of a crack against the first (m), and its part along the normal.
fn place(world: &World, freedoms: &Freedoms, crack: &Crack) -> (Vec3, f64) {
    let [first, second] = crack
        .blocks
        .map(|block| Anchor::Block { block, arm: crack.centre - world.reference[block as usize] });
    let jump = freedoms.jump(&[first, second]);
    (jump, jump.dot(normal(freedoms, crack)))
}

/// Outward normal of the first block of a crack now.
fn normal(freedoms: &Freedoms, crack: &Crack) -> Vec3 {
    freedoms.arm(crack.blocks[0], crack.normal)
}

/// Displacements of the second sides of all cracks against the first, m.
pub(crate) fn jumps(world: &World) -> Vec<Vec3> {
    let freedoms = world.all_freedoms();
    let cracks = world.gas.iter().flat_map(|gas| &gas.cracks);
    cracks.map(|crack| place(world, &freedoms, crack).0).collect()
}

/// Takes off what the change over to finite rotations adds to the displacements of cracks, which were `before`: it is no motion, and does no work.
pub(crate) fn change_over(world: &mut World, before: &[Vec3]) {
    let after = jumps(world);
    let Some(gas) = &mut world.gas else { return };
    for ((crack, before), after) in gas.cracks.iter_mut().zip(before).zip(after) {
        if crack.open {
            crack.jump += after - *before;
        }
    }
}

/// Lets the gas flow for the time since it flowed last.
fn flow(world: &World, gas: &mut CrackGas, (exec, desk): (&Exec, &mut Desk)) {
    let cavities = gas.cavities.iter().map(|k| &world.cavities[*k as usize]);
    let volume = |c: &Cavity| if c.ignited.is_some() { c.volume } else { 0.0 };
    let volumes: Vec<f64> =
        gas.cracks.iter().map(|c| c.volume).chain(cavities.map(volume)).collect();
    let span = std::mem::take(&mut gas.waits);
    gas.passed = 0;
    if !gas.cracks.iter().any(|c| c.open) {
        return;
    }
    let CrackGas { network, fluid, rules, masses, fluxes, cracks, books, stuck, .. } = gas;
    let of = |c: &Crack| if c.open { c.aperture } else { 0.0 };
    let mut apertures: Vec<f64> = cracks.iter().map(of).collect();
    apertures.resize(masses.len(), 0.0);
    let mut cells = Cells { volumes: &volumes, apertures: &apertures, masses, fluxes };
    let how = (&rules.friction, rules.air);
    match network.advance(fluid, how, &mut cells, span, (exec, desk)) {
        Ok(flowed) => {
            books.friction += flowed.friction;
            books.numerical += flowed.numerical;
            books.carried += flowed.carried;
            books.vented += flowed.vented;
        }
        Err(failed) => {
            let c = failed.cell as usize;
            let whose = |c: usize| [(c - cracks.len()) as u32; 2];
            let blocks = cracks.get(c).map_or_else(|| whose(c), |crack| crack.blocks);
            *stuck = Some((blocks, failed.left));
            return;
        }
    }
    pace(gas, desk);
    speeds(gas, &volumes);
}

/// Finds the pressures after a flow, and how many steps of the rock the next one may take.
///
/// The measure is the energy of the gas in cracks, not the crack that changes most: a front fills one for the first time in every step.
fn pace(gas: &mut CrackGas, desk: &Desk) {
    let CrackGas { cracks, masses, fluid, .. } = gas;
    let [mut changed, mut all] = [0.0; 2];
    let cells = cracks.iter_mut().zip(masses.iter()).zip(desk.pressures());
    for ((crack, mass), &pressure) in cells.filter(|((c, m), _)| **m > 0.0 && !c.gone) {
        let before = crack.pressure;
        crack.take(fluid, *mass, pressure);
        changed += crack.volume * (crack.pressure - before).abs();
        all += crack.volume * crack.pressure;
    }
    // Until gas is in a crack, the first one waits for no more than a step.
    let wanted = if all > 0.0 { CHANGE / (changed / all) } else { 0.0 };
    let longest = if desk.turns() < MANY_TURNS { 2.0 } else { 1.0 };
    let next = f64::from(gas.every) * wanted.clamp(1.0 / f64::from(LONGEST), longest);
    gas.every = (next as u32).clamp(1, LONGEST);
}

/// Finds the largest speed of the flow in each crack.
fn speeds(gas: &mut CrackGas, volumes: &[f64]) {
    let CrackGas { network, cracks, masses, fluxes, .. } = gas;
    cracks.iter_mut().for_each(|crack| crack.speed = 0.0);
    for (port, flux) in network.ports.iter().zip(fluxes.iter()).filter(|(_, flux)| **flux != 0.0) {
        if let Some(crack) = cracks.get_mut(port.cell as usize) {
            crack.speed = crack.speed.max(flux.abs());
        }
    }
    for ((crack, mass), volume) in cracks.iter_mut().zip(masses.iter()).zip(volumes) {
        crack.speed = if *mass > 0.0 && crack.open { crack.speed * volume / mass } else { 0.0 };
    }
}

/// Pushes the sides of all cracks with gas in them.
fn push_cracks(world: &mut World, gas: &mut CrackGas, pushes: &mut Account) {
    let CrackGas { cracks, rules, books, .. } = gas;
    let freedoms = world.all_freedoms();
    let mut work = 0.0;
    for crack in cracks.iter_mut().filter(|c| c.open) {
        let before = crack.push;
        let above = (crack.pressure - rules.air).max(0.0);
        crack.push = above * crack.area * normal(&freedoms, crack);
        let second = 0.5 * crack.push.dot(crack.moved);
        books.work += second;
        books.in_cracks += second;
        work += second + 0.5 * before.dot(crack.moved);
        crack.moved = Vec3::ZERO;
        if above > 0.0 {
            for (block, sign) in [(crack.blocks[0], -1.0), (crack.blocks[1], 1.0)] {
                let arm = crack.centre - world.reference[block as usize];
                freedoms.push(pushes, &Anchor::Block { block, arm }, sign * crack.push);
            }
        }
    }
    world.works.gas += work;
}

/// Pressure and work of cavity number `k` of the network, and its push on its walls.
fn push_walls(world: &mut World, gas: &mut CrackGas, k: usize, dt: f64, pushes: &mut Account) {
    let (cell, number) = (gas.cracks.len() + k, gas.cavities[k] as usize);
    let cavity = &mut world.cavities[number];
    let (Some(own), Some(ignited)) = (cavity.gas, cavity.ignited) else { return };
    let before = (cavity.known, cavity.pressure);
    let room = hole::room(&world.setup.sources[cavity.source as usize], cavity, &own);
    let grown = cavity.volume - room;
    let mass = gas.masses[cell];
    cavity.kept = mass / (gas.fluid.mass * own.adiabat.v0() / gas.fluid.adiabat.v0());
    cavity.pressure =
        if mass > 0.0 { own.adiabat.pressure(cavity.volume / cavity.kept) } else { 0.0 };
    cavity.known = grown;
    let above = |pressure: f64| (pressure - gas.rules.air).max(0.0);
    // It has no pressure before the evaluation in which it goes off.
    let old = if ignited == world.time { cavity.pressure } else { before.1 };
    let moved = grown - if ignited == world.time { grown } else { before.0 };
    let work = 0.5 * (above(old) + above(cavity.pressure)) * moved;
    let air = 0.5 * (old.min(gas.rules.air) + cavity.pressure.min(gas.rules.air)) * moved;
    cavity.work += work;
    gas.books.work += work;
    gas.books.air += air;
    world.works.gas += work;
    let first = ignited == world.time && cavity.burn.is_none() && dt > 0.0;
    let share = if first { dt / (world.last_dt + dt) } else { 1.0 };
    let (now, above) = (cavity.pressure, above(cavity.pressure));
    gas.books.stemming += hole::speed_up(world, number, [old, now]);
    super::cavity::press(world, number, share * above * own.factor, dt, pushes);
}

impl CrackGas {
    /// What the sides of cracks carry now: block, present arm (m), force (N).
    pub fn forces<'a>(
        &'a self,
        world: &'a World,
    ) -> impl Iterator<Item = (usize, Vec3, Vec3)> + 'a {
        let freedoms = world.all_freedoms();
        self.cracks.iter().filter(|c| c.push != Vec3::ZERO).flat_map(move |crack| {
            [(crack.blocks[0], -1.0), (crack.blocks[1], 1.0)].map(|(block, sign)| {
                let b = block as usize;
                (b, freedoms.arm(block, crack.centre - world.reference[b]), sign * crack.push)
            })
        })
    }
}

/// Largest step that the gas in cracks allows, s; found when it flowed last.
pub(crate) fn step_limit(world: &World) -> f64 {
    world.gas.as_ref().map_or(f64::INFINITY, |gas| gas.limit)
}

/// Largest step that the gas in cracks allows now, s.
fn limit(world: &World, gas: &CrackGas) -> f64 {
    let mut stiffness = vec![0.0; world.alive.len()];
    for (crack, _) in
        gas.cracks.iter().zip(&gas.masses).filter(|(c, m)| c.open && !c.gone && **m > 0.0)
    {
        let spring = crack.known[2] * crack.area * crack.area / crack.volume;
        for block in crack.blocks {
            let b = block as usize;
            let solid = world.solid_of(b);
            let lever = (crack.centre - world.reference[b]).cross(crack.normal);
            stiffness[b] += spring * (1.0 / solid.mass + lever.dot(solid.inverse * lever));
        }
    }
    // Both sides of a crack may move against each other.
    let squared = 2.0 * stiffness.into_iter().fold(0.0, f64::max);
    if squared > 0.0 { CRACK_STEP / squared.sqrt() } else { f64::INFINITY }
}
