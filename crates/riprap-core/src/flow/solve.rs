//! One backward Euler step of a network.

use super::rows::{Before, Rows};
use super::stage::{State, Step};
use super::{Cells, End, Flowed, Fluid, Friction, Network, Stuck};
use crate::exec::{CHUNK, Exec};

/// What may be left of the balance of a cell before the last step of Newton's method, over what it holds and what flows through it: that step leaves a third.
const BALANCED: f64 = 0.03;
/// What may be left of all balances together, over all that flows.
const ALL_BALANCED: f64 = 2e-3;
/// A cell that holds less than this share of all gas, and lets less through, may be out of balance.
const LITTLE: f64 = 1e-9;
/// All that flows may be out of balance when it is less than this share of all gas: in the first steps of Newton's method, and in later ones, which only
/// round-off in potentials that are nearly even can ask for.
const STILL: [f64; 2] = [1e-9, 1e-6];
/// Most steps of Newton's method.
const MOST_STEPS: usize = 200;
/// Steps with tangents, and then with secants, and so on: tangents may cycle where neighbours equalise in one step, secants are slow near the end.
const TURNS: usize = 8;
/// The share of a change that is made once each has had its turns: what overshoots by as much as it was off comes to rest.
const RELAXED: f64 = 0.7;
/// What conjugate gradients leave of a right-hand side in the first steps of Newton's method, and where it takes more.
const SOLVED: [f64; 2] = [1e-5, 1e-8];
/// Most of their turns.
const MOST_TURNS: usize = 2000;

/// Room for the steps of one network, with nothing that is remembered: a network that has changed needs a new one.
#[derive(Clone, Debug, Default)]
pub struct Desk {
    /// Friction of each cell.
    friction: Vec<[f64; 2]>,
    state: Vec<State>,
    /// Density (kg/m³) and pressure (Pa) of each cell at the start of the step.
    density: Vec<f64>,
    pressure: Vec<f64>,
    /// What each cell holds more than at the start of the step (J), and its enthalpy (J/kg).
    kept: Vec<[f64; 2]>,
    /// Whether nothing flows faster than sound.
    limited: bool,
    /// Whether the gas has inertia.
    inert: bool,
    /// Cells that are not dry, ascending.
    wet: Vec<u32>,
    /// Those, and cells that share a junction with them.
    near: Vec<u32>,
    /// Whether each cell is among `near`.
    reached: Vec<bool>,
    /// Junctions of cell `c`: `first[c]` to `first[c + 1]` of `touching`.
    first: Vec<u32>,
    touching: Vec<u32>,
    /// Whether a cell that is not dry reaches each junction.
    marks: Vec<bool>,
    /// Those among them at which gas flows.
    rows: Rows,
    /// What flows out of each cell, and the size of all that flows through it, kg/s.
    out: Vec<[f64; 2]>,
    residual: Vec<f64>,
    /// Vectors of the conjugate gradients.
    vectors: [Vec<f64>; 6],
    /// Masses at the start of the step done last, kg.
    before: Vec<f64>,
    /// What a step that is made in parts began with.
    pub(super) start: Kept,
    /// Steps of Newton's method in the step done last.
    turns: usize,
}

/// What a step that is made in parts began with.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    masses: Vec<f64>,
    fluxes: Vec<f64>,
}

impl Kept {
    /// Remembers masses and fluxes.
    pub(super) fn keep(&mut self, cells: &Cells) {
        self.masses.clear();
        self.masses.extend_from_slice(cells.masses);
        self.fluxes.clear();
        self.fluxes.extend_from_slice(cells.fluxes);
    }

    /// Gives it back.
    pub(super) fn restore(&self, cells: &mut Cells) {
        cells.masses.copy_from_slice(&self.masses);
        cells.fluxes.copy_from_slice(&self.fluxes);
    }
}

impl Desk {
    /// Steps of Newton's method in the step done last.
    #[must_use]
    pub fn turns(&self) -> usize {
        self.turns
    }

    /// Makes room, and takes over the apertures.
    pub(super) fn prepare(&mut self, network: &Network, friction: &Friction, cells: &Cells) {
        let n = cells.masses.len();
        self.friction.clear();
        self.limited = friction.roughness > 0.0 || friction.inertia;
        self.inert = friction.inertia;
        let of = |w: &f64| if *w > 0.0 { friction.at(*w) } else { [0.0; 2] };
        self.friction.extend(cells.apertures.iter().map(of));
        self.state.resize(n, State::default());
        self.density.resize(n, 0.0);
        self.pressure.resize(n, 0.0);
        self.kept.resize(n, [0.0; 2]);
        self.out.resize(n, [0.0; 2]);
        self.reached.resize(n, false);
        self.residual.resize(n, 0.0);
        self.vectors.iter_mut().for_each(|v| v.resize(n, 0.0));
        self.marks.resize(network.ends.len(), false);
        if self.first.len() != n + 1 {
            self.reach(network);
        }
    }

    /// Gives masses back that a step has not found.
    pub(super) fn restore_masses(&self, cells: &mut Cells) {
        cells.masses.copy_from_slice(&self.before);
    }

    /// Pressure in each cell after the step done last, Pa.
    #[must_use]
    pub fn pressures(&self) -> &[f64] {
        &self.pressure
    }

    /// Books the step done last; pressure (Pa) of the air, and density (kg/m³) of the gas at it.
    pub(super) fn book(
        &mut self,
        exec: &Exec,
        fluid: &Fluid,
        air: [f64; 2],
        (cells, flowed): (&Cells, &mut Flowed),
    ) {
        let Self { near, before, density, pressure, kept, .. } = self;
        let mut nothing = vec![(); pressure.len().div_ceil(CHUNK)];
        exec.chunks2(pressure, kept, &mut nothing, |from, pressures, kept, ()| {
            for (k, (pressure, kept)) in pressures.iter_mut().zip(kept).enumerate() {
                let c = from + k;
                let (m, old, volume) = (cells.masses[c], before[c], cells.volumes[c]);
                let was = old * fluid.energy_at(density[c], *pressure);
                let [energy, enthalpy, now] = fluid.energies(m / volume);
                *pressure = now;
                *kept = [m * energy - was, enthalpy];
            }
        });
        let (mut gone, mut flow, mut internal) = (0.0, 0.0, 0.0);
        for c in near.iter().map(|c| *c as usize) {
            let (m, old) = (cells.masses[c], before[c]);
            if m == old {
                continue;
            }
            let [more, enthalpy] = kept[c];
            gone += old - m;
            flow -= (m - old) * enthalpy;
            internal += more;
        }
        let leaves = if air[0] > 0.0 { fluid.enthalpy(air[1]) } else { 0.0 };
        flowed.vented += gone;
        flowed.carried += leaves * gone;
        flowed.friction += flow - leaves * gone;
        // Of first order in the step, and positive since the energy is convex in the mass.
        flowed.numerical += -internal - flow;
    }

    /// Finds which junctions each cell reaches; once for a network.
    fn reach(&mut self, network: &Network) {
        let mut all: Vec<(u32, u32)> = Vec::with_capacity(network.ports.len());
        for (j, end) in (0..).zip(&network.ends) {
            all.extend(network.ports[network.ports_of(j)].iter().map(|port| (port.cell, j)));
            if let End::Cell(c) = *end {
                all.push((c, j));
            }
        }
        all.sort_unstable();
        let first = |c: u32| all.partition_point(|pair| pair.0 < c) as u32;
        self.first = (0..=network.cells).map(first).collect();
        self.touching = all.into_iter().map(|(_, j)| j).collect();
    }
}

impl Network {
    /// Ports of a junction.
    #[must_use]
    pub fn ports_of(&self, junction: u32) -> std::ops::Range<usize> {
        let j = junction as usize;
        self.first[j] as usize..self.first[j + 1] as usize
    }
}

/// Lets gas flow for `dt` (s); `air` is the density of the gas at the pressure of the air.
pub(super) fn step(
    network: &Network,
    fluid: &Fluid,
    air: f64,
    cells: &mut Cells,
    dt: f64,
    (exec, desk): (&Exec, &mut Desk),
) -> Result<(), Stuck> {
    desk.before.clear();
    desk.before.extend_from_slice(cells.masses);
    let all: f64 = desk.before.iter().sum();
    let air = fluid.potential(air);
    let (volumes, apertures) = (cells.volumes, cells.apertures);
    let step = Step { exec, network, air, dt, volumes, apertures };
    for ((density, m), volume) in desk.density.iter_mut().zip(&desk.before).zip(volumes) {
        *density = if *volume > 0.0 { m / volume } else { 0.0 };
    }
    desk.rows.begin(network.ends.len());
    let mut worst = Stuck { cell: 0, left: 0.0 };
    for turn in 0..MOST_STEPS {
        step.look(fluid, cells, desk, turn == 0);
        step.flow(desk, turn / TURNS % 2 == 1);
        let [off, flows];
        (worst, [off, flows]) = step.weigh(cells.masses, all, desk);
        if !off.is_finite() {
            return Err(worst);
        }
        step.solve(desk, SOLVED[usize::from(turn >= TURNS)]);
        let flows = flows.max(STILL[usize::from(turn >= TURNS)] * all);
        let near_enough = worst.left <= BALANCED && off <= ALL_BALANCED * flows;
        if near_enough && settle(cells.masses, dt, desk) {
            desk.turns = turn + 1;
            desk.rows.keep(&step, numbers(&desk.marks), cells.fluxes);
            return Ok(());
        }
        let share = if turn < 2 * TURNS { 1.0 } else { RELAXED };
        let outflow = &desk.vectors[0];
        for c in desk.near.iter().map(|c| *c as usize) {
            let m = &mut cells.masses[c];
            let change = -share * (desk.residual[c] + dt * outflow[c]);
            // Below nothing only in steps that are too long: the next one makes up for it.
            *m = if *m + change < 0.0 { 0.5 * *m } else { *m + change };
        }
    }
    Err(worst)
}

/// Makes the masses what fluxes between cells have left, and nothing else, so that none is made; whether that leaves none below nothing.
fn settle(masses: &mut [f64], dt: f64, desk: &Desk) -> bool {
    let near = || desk.near.iter().map(|c| *c as usize);
    let left = |c: usize| desk.before[c] - dt * (desk.out[c][0] + desk.vectors[0][c]);
    let settles = near().all(|c| left(c) >= 0.0);
    if settles {
        near().for_each(|c| masses[c] = left(c));
    }
    settles
}

/// Numbers of what is marked, ascending.
fn numbers(marks: &[bool]) -> impl Iterator<Item = u32> {
    (0..).zip(marks).filter(|(_, mark)| **mark).map(|(k, _)| k)
}

impl Step<'_> {
    /// Potentials of the cells, and the junctions that gas reaches; `anew` with the first look of a step.
    fn look(&self, fluid: &Fluid, cells: &Cells, desk: &mut Desk, anew: bool) {
        let limited = desk.limited;
        self.exec.chunks(&mut desk.state, |from, states| {
            let cells = cells.masses[from..].iter().zip(&self.volumes[from..]);
            for (state, (&mass, &volume)) in states.iter_mut().zip(cells) {
                *state = State::of(fluid, (mass, volume), limited);
            }
        });
        if anew {
            for (pressure, state) in desk.pressure.iter_mut().zip(&desk.state) {
                *pressure = state.pressure;
            }
        }
        let wet = || (0..).zip(&desk.state).filter(|(_, state)| state.root != 0.0).map(|(c, _)| c);
        if !anew && wet().eq(desk.wet.iter().copied()) {
            return;
        }
        let mut list = std::mem::take(&mut desk.wet);
        list.clear();
        list.extend(wet());
        desk.wet = list;
        desk.marks.fill(false);
        for &c in &desk.wet {
            let range = desk.first[c as usize] as usize..desk.first[c as usize + 1] as usize;
            for &j in &desk.touching[range] {
                desk.marks[j as usize] = true;
            }
        }
        let Desk { rows, marks, friction, density, .. } = desk;
        let density = desk.inert.then_some(&density[..]);
        rows.gather(self, numbers(marks), Before { friction, density }, cells.fluxes);
        self.gather(desk);
    }

    /// Finds the cells that share a junction with those that are not dry.
    fn gather(&self, desk: &mut Desk) {
        let Desk { near, reached, wet, rows, .. } = desk;
        for c in near.drain(..) {
            reached[c as usize] = false;
        }
        let of = |j: u32| {
            let ports = &self.network.ports[self.network.ports_of(j)];
            let holder = self.holder(j).map(|c| c as u32);
            ports.iter().map(|port| port.cell).chain(holder)
        };
        for c in wet.iter().copied().chain(rows.junctions().flat_map(of)) {
            if !std::mem::replace(&mut reached[c as usize], true) {
                near.push(c);
            }
        }
    }

    /// What flows through all ports, and out of all cells.
    fn flow(&self, desk: &mut Desk, secant: bool) {
        let Desk { rows, near, out, state, .. } = desk;
        for c in near {
            out[*c as usize] = [0.0; 2];
        }
        rows.flow(self.exec, state, (self.air, secant), out);
    }

    /// What is left of the balance of each cell: the worst, and all of it beside all that flows, kg.
    fn weigh(&self, masses: &[f64], all: f64, desk: &mut Desk) -> (Stuck, [f64; 2]) {
        let mut worst = Stuck { cell: 0, left: 0.0 };
        let [mut off, mut flows] = [0.0; 2];
        for c in desk.near.iter().map(|c| *c as usize) {
            let [out, size] = desk.out[c];
            let residual = masses[c] - desk.before[c] + self.dt * out;
            desk.residual[c] = residual;
            let scale = masses[c].max(self.dt * size).max(LITTLE * all);
            let left = if scale > 0.0 { residual.abs() / scale } else { 0.0 };
            off += residual.abs();
            flows += self.dt * size;
            // Numbers that are none are the worst.
            if left > worst.left || left.is_nan() {
                worst = Stuck { cell: c as u32, left };
            }
        }
        (worst, [off, flows])
    }

    /// What flows out of each cell beside `out` when all are in balance along the tangents, into the first vector of the desk; rows follow.
    /// Conjugate gradients leave the share `solved`.
    fn solve(&self, desk: &mut Desk, solved: f64) {
        let [mut y, mut r, mut p, mut image, mut scaled, mut diagonal] =
            std::mem::take(&mut desk.vectors);
        let wet = std::mem::take(&mut desk.wet);
        let over = || wet.iter().map(|c| *c as usize);
        for c in desk.near.iter().map(|c| *c as usize) {
            y[c] = 0.0;
            scaled[c] = 0.0;
            image[c] = 0.0;
            diagonal[c] = 0.0;
        }
        desk.rows.diagonal(&mut diagonal);
        let mut product = 0.0;
        for c in over() {
            diagonal[c] =
                1.0 / (1.0 + self.dt * desk.state[c].root * desk.state[c].root * diagonal[c]);
            r[c] = -desk.state[c].root * desk.residual[c];
            p[c] = r[c] * diagonal[c];
            product += r[c] * p[c];
        }
        let enough = solved * solved * product;
        for _ in 0..MOST_TURNS {
            if product <= enough || product == 0.0 {
                break;
            }
            for c in over() {
                scaled[c] = desk.state[c].root * p[c];
            }
            for c in &desk.near {
                image[*c as usize] = 0.0;
            }
            desk.rows.product(self.exec, &scaled, &mut image);
            let mut along = 0.0;
            for c in over() {
                image[c] = p[c] + self.dt * desk.state[c].root * image[c];
                along += p[c] * image[c];
            }
            let length = product / along;
            let mut next = 0.0;
            for c in over() {
                y[c] += length * p[c];
                r[c] -= length * image[c];
                next += r[c] * r[c] * diagonal[c];
            }
            let share = next / product;
            for c in over() {
                p[c] = r[c] * diagonal[c] + share * p[c];
            }
            product = next;
        }
        for c in over() {
            scaled[c] = desk.state[c].root * y[c];
        }
        for c in desk.near.iter().map(|c| *c as usize) {
            y[c] = 0.0;
        }
        desk.rows.follow(self.exec, &scaled, &mut y);
        desk.wet = wet;
        desk.vectors = [y, r, p, image, scaled, diagonal];
    }
}
