//! One backward Euler step of a network.

use super::junction::{Conduit, Flux, inside};
use super::{Cells, End, Flowed, Fluid, Friction, Network, Port, Stuck};

/// What may be left of the balance of a cell, over what it holds and what flows through it.
const BALANCED: f64 = 1e-8;
/// Most steps of Newton's method.
const MOST_STEPS: usize = 200;
/// Steps with tangents, and then with secants, and so on: tangents may cycle where neighbours equalise in one step, secants are slow near the end.
const TURNS: usize = 8;
/// The share of a change that is made once each has had its turns: what overshoots by as much as it was off comes to rest.
const RELAXED: f64 = 0.7;
/// What conjugate gradients leave of a right-hand side in the first steps of Newton's method, and where it takes more.
const SOLVED: [f64; 2] = [1e-5, 1e-9];
/// Most of their turns.
const MOST_TURNS: usize = 2000;
/// Masses below this share of all of it are nothing.
const NOTHING: f64 = 1e-15;

/// Room for the steps of one network, with nothing that is remembered: a network that has changed needs a new one.
#[derive(Clone, Debug, Default)]
pub struct Desk {
    /// Friction of each cell.
    friction: Vec<[f64; 2]>,
    /// Potential and `rho c` of each cell.
    state: Vec<[f64; 2]>,
    /// Density of each cell at the start of the step, kg/m³.
    density: Vec<f64>,
    /// Root of `(dPsi/drho)/V` of each cell.
    root: Vec<f64>,
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
    /// Junctions that a cell which is not dry reaches, ascending.
    active: Vec<u32>,
    /// Junctions of cell `c`: `first[c]` to `first[c + 1]` of `touching`.
    first: Vec<u32>,
    touching: Vec<u32>,
    marks: Vec<bool>,
    conduits: Vec<Conduit>,
    /// Flow through each port of the active junctions in the step done last.
    fluxes: Vec<Flux>,
    /// Sum of the tangents of each junction; 0 where its potential is given.
    sums: Vec<f64>,
    /// Potential of each junction inside, found last in this step.
    heads: Vec<f64>,
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

/// State of cells.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    masses: Vec<f64>,
    fluxes: Vec<f64>,
}

impl Kept {
    /// Remembers the state of cells.
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
        self.state.resize(n, [0.0; 2]);
        self.density.resize(n, 0.0);
        self.root.resize(n, 0.0);
        self.out.resize(n, [0.0; 2]);
        self.reached.resize(n, false);
        self.residual.resize(n, 0.0);
        self.vectors.iter_mut().for_each(|v| v.resize(n, 0.0));
        self.fluxes.resize_with(network.ports.len(), Flux::default);
        self.sums.resize(network.ends.len(), 0.0);
        self.marks.resize(network.ends.len(), false);
        self.heads.resize(network.ends.len(), f64::NAN);
        if self.first.len() != n + 1 {
            self.reach(network);
        }
    }

    /// Gives masses back that a step has not found.
    pub(super) fn restore_masses(&self, cells: &mut Cells) {
        cells.masses.copy_from_slice(&self.before);
    }

    /// Books the step done last; pressure (Pa) of the air, and density (kg/m³) of the gas at it.
    pub(super) fn book(&self, fluid: &Fluid, air: [f64; 2], cells: &Cells, flowed: &mut Flowed) {
        let (mut gone, mut flow, mut internal) = (0.0, 0.0, 0.0);
        for c in self.near.iter().map(|c| *c as usize) {
            let (m, old, volume) = (cells.masses[c], self.before[c], cells.volumes[c]);
            if m == old {
                continue;
            }
            let [energy, enthalpy] = fluid.energies(m / volume);
            gone += old - m;
            flow -= (m - old) * enthalpy;
            internal += m * energy - old * fluid.energies(old / volume)[0];
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

/// A step in numbers.
struct Step<'a> {
    network: &'a Network,
    /// Potential of the air.
    air: f64,
    dt: f64,
    volumes: &'a [f64],
    apertures: &'a [f64],
}

/// Lets gas flow for `dt` (s); `air` is the density of the gas at the pressure of the air.
pub(super) fn step(
    network: &Network,
    fluid: &Fluid,
    air: f64,
    cells: &mut Cells,
    dt: f64,
    desk: &mut Desk,
) -> Result<(), Stuck> {
    desk.before.clear();
    desk.before.extend_from_slice(cells.masses);
    let all: f64 = desk.before.iter().sum();
    let air = fluid.potential(air);
    let (volumes, apertures) = (cells.volumes, cells.apertures);
    let step = Step { network, air, dt, volumes, apertures };
    for ((density, m), volume) in desk.density.iter_mut().zip(&desk.before).zip(volumes) {
        *density = if *volume > 0.0 { m / volume } else { 0.0 };
    }
    // Nothing is remembered from another step.
    desk.heads.fill(f64::NAN);
    let mut worst = Stuck { cell: 0, left: 0.0 };
    for turn in 0..MOST_STEPS {
        step.look(fluid, cells.masses, desk, turn == 0);
        step.flow(cells.fluxes, desk, turn / TURNS % 2 == 1);
        worst = step.weigh(cells.masses, all, desk);
        if worst.left <= BALANCED && settle(cells.masses, desk) {
            desk.turns = turn;
            step.keep_fluxes(cells.fluxes, desk);
            return Ok(());
        }
        if !worst.left.is_finite() {
            return Err(worst);
        }
        step.solve(desk, SOLVED[usize::from(turn >= TURNS)]);
        let share = if turn < 2 * TURNS { 1.0 } else { RELAXED };
        for c in desk.near.iter().map(|c| *c as usize) {
            let (m, change) = (&mut cells.masses[c], share * desk.vectors[0][c]);
            // Below nothing only in steps that are too long: the next one makes up for it.
            *m = if *m + change < 0.0 { 0.5 * *m } else { *m + change };
        }
    }
    Err(worst)
}

/// Makes the masses what fluxes between cells have left, and nothing else, so that none is made; whether that leaves none below nothing.
fn settle(masses: &mut [f64], desk: &Desk) -> bool {
    let near = || desk.near.iter().map(|c| *c as usize);
    let settles = near().all(|c| masses[c] >= desk.residual[c]);
    if settles {
        for c in near() {
            masses[c] -= desk.residual[c];
        }
    }
    settles
}

impl Step<'_> {
    /// Potentials of the cells, and the junctions that gas reaches; `anew` with the first look of a step.
    fn look(&self, fluid: &Fluid, masses: &[f64], desk: &mut Desk, anew: bool) {
        let (mut known, mut same) = (0, !anew);
        for (c, &m) in masses.iter().enumerate() {
            if m <= 0.0 || self.volumes[c] <= 0.0 {
                desk.state[c] = [0.0; 2];
                desk.root[c] = 0.0;
                continue;
            }
            let density = m / self.volumes[c];
            let [potential, bulk] = fluid.look(density);
            let sound = if desk.limited { (density * bulk).sqrt() } else { f64::INFINITY };
            desk.state[c] = [potential, sound];
            desk.root[c] = (bulk / self.volumes[c]).sqrt();
            if same && desk.wet.get(known) != Some(&(c as u32)) {
                same = false;
            }
            if !same {
                desk.wet.truncate(known);
                desk.wet.push(c as u32);
            }
            known += 1;
        }
        if same && known == desk.wet.len() {
            return;
        }
        desk.wet.truncate(known);
        desk.marks.fill(false);
        for &c in &desk.wet {
            let range = desk.first[c as usize] as usize..desk.first[c as usize + 1] as usize;
            for &j in &desk.touching[range] {
                desk.marks[j as usize] = true;
            }
        }
        desk.active.clear();
        desk.active.extend((0..).zip(&desk.marks).filter(|(_, m)| **m).map(|(j, _)| j));
        self.gather(desk);
    }

    /// Finds the cells that share a junction with those that are not dry.
    fn gather(&self, desk: &mut Desk) {
        let Desk { near, reached, wet, active, .. } = desk;
        for c in near.drain(..) {
            reached[c as usize] = false;
        }
        let of = |j: &u32| {
            let ports = &self.network.ports[self.network.ports_of(*j)];
            let holder = self.holder(*j).map(|c| c as u32);
            ports.iter().map(|port| port.cell).chain(holder)
        };
        for c in wet.iter().copied().chain(active.iter().flat_map(of)) {
            if !std::mem::replace(&mut reached[c as usize], true) {
                near.push(c);
            }
        }
    }

    /// The cell whose potential a junction has.
    fn holder(&self, junction: u32) -> Option<usize> {
        match self.network.ends[junction as usize] {
            End::Cell(c) if self.volumes[c as usize] > 0.0 => Some(c as usize),
            End::Cell(_) | End::Inside | End::Air => None,
        }
    }

    /// A port as it is with the present potentials; `flux` is what flowed through it in the step before, kg/(m² s).
    fn conduit(&self, desk: &Desk, port: usize, flux: f64, holder: Option<usize>) -> Conduit {
        let Port { cell, length, path } = self.network.ports[port];
        let c = cell as usize;
        let [potential, sound] = desk.state[c];
        let section = length * self.apertures[c];
        let [a, b] = desk.friction[c];
        if !desk.inert {
            return Conduit { section, path, friction: [a, b], potential, sound };
        }
        let density = desk.density[c];
        let between = holder.map_or(density, |h| 0.5 * (density + desk.density[h]));
        let inertia = between / self.dt;
        let friction = [a + inertia, b];
        Conduit { section, path, friction, potential: potential + path * inertia * flux, sound }
    }

    /// What flows through all ports, and out of all cells; `old` flowed in the step before, kg/(m² s).
    fn flow(&self, old: &[f64], desk: &mut Desk, secant: bool) {
        for c in &desk.near {
            desk.out[*c as usize] = [0.0; 2];
        }
        let active = std::mem::take(&mut desk.active);
        let mut conduits = std::mem::take(&mut desk.conduits);
        for &j in &active {
            let range = self.network.ports_of(j);
            let holder = self.holder(j);
            conduits.clear();
            conduits.extend(range.clone().map(|p| self.conduit(desk, p, old[p], holder)));
            let fluxes = &mut desk.fluxes[range.clone()];
            let open = self.network.ends[j as usize] == End::Air;
            let given = match holder {
                Some(c) => Some(desk.state[c]),
                None if open => Some([self.air, 0.0]),
                None => None,
            };
            if let Some([potential, sound]) = given {
                for (flux, conduit) in fluxes.iter_mut().zip(&conduits) {
                    let blocked = conduit.section == 0.0 || open && conduit.potential <= self.air;
                    *flux = Flux::default();
                    if !blocked {
                        *flux = conduit.flux(potential, sound, secant);
                    }
                }
                desk.sums[j as usize] = 0.0;
            } else {
                inside(&conduits, secant, &mut desk.heads[j as usize], fluxes);
                desk.sums[j as usize] = fluxes.iter().map(|f| f.tangent).sum();
            }
            for port in range {
                let rate = desk.fluxes[port].rate;
                let cell = self.network.ports[port].cell as usize;
                for (c, sign) in [(Some(cell), 1.0), (holder, -1.0)] {
                    if let Some(c) = c {
                        desk.out[c][0] += sign * rate;
                        desk.out[c][1] += rate.abs();
                    }
                }
            }
        }
        desk.active = active;
        desk.conduits = conduits;
    }

    /// What is left of the balance of each cell, and the worst.
    fn weigh(&self, masses: &[f64], all: f64, desk: &mut Desk) -> Stuck {
        let mut worst = Stuck { cell: 0, left: 0.0 };
        for c in desk.near.iter().map(|c| *c as usize) {
            let [out, size] = desk.out[c];
            let residual = masses[c] - desk.before[c] + self.dt * out;
            desk.residual[c] = residual;
            let scale = masses[c].max(self.dt * size).max(NOTHING * all);
            let left = if scale > 0.0 { residual.abs() / scale } else { 0.0 };
            // Numbers that are none are the worst.
            if left > worst.left || left.is_nan() {
                worst = Stuck { cell: c as u32, left };
            }
        }
        worst
    }

    /// Takes over what flows through the ports of active junctions, kg/(m² s).
    fn keep_fluxes(&self, fluxes: &mut [f64], desk: &Desk) {
        for port in desk.active.iter().flat_map(|j| self.network.ports_of(*j)) {
            let Port { cell, length, .. } = self.network.ports[port];
            let section = length * self.apertures[cell as usize];
            fluxes[port] = if section > 0.0 { desk.fluxes[port].rate / section } else { 0.0 };
        }
    }

    /// `to = L x`.
    fn product(&self, desk: &Desk, x: &[f64], to: &mut [f64]) {
        for c in &desk.near {
            to[*c as usize] = 0.0;
        }
        for &j in &desk.active {
            let range = self.network.ports_of(j);
            let ports =
                || range.clone().map(|p| (self.network.ports[p].cell, desk.fluxes[p].tangent));
            let sum = desk.sums[j as usize];
            let holder = self.holder(j);
            let at = match holder {
                Some(c) => x[c],
                None if sum > 0.0 => ports().map(|(c, t)| t * x[c as usize]).sum::<f64>() / sum,
                None => 0.0,
            };
            for (c, t) in ports() {
                let rate = t * (x[c as usize] - at);
                to[c as usize] += rate;
                if let Some(h) = holder {
                    to[h] -= rate;
                }
            }
        }
    }

    /// Diagonal of `1 + dt S^1/2 L S^1/2`.
    fn diagonal(&self, desk: &Desk, to: &mut [f64]) {
        for c in &desk.near {
            to[*c as usize] = 0.0;
        }
        for &j in &desk.active {
            let sum = desk.sums[j as usize];
            let holder = self.holder(j);
            for p in self.network.ports_of(j) {
                let t = desk.fluxes[p].tangent;
                let share = if sum > 0.0 { t / sum } else { 0.0 };
                to[self.network.ports[p].cell as usize] += t * (1.0 - share);
                if let Some(h) = holder {
                    to[h] += t;
                }
            }
        }
        for c in desk.wet.iter().map(|c| *c as usize) {
            to[c] = 1.0 + self.dt * desk.root[c] * desk.root[c] * to[c];
        }
    }

    /// The change of the masses, into the first vector of the desk; conjugate gradients leave the share `solved`.
    fn solve(&self, desk: &mut Desk, solved: f64) {
        let [mut y, mut r, mut p, mut image, mut scaled, mut diagonal] =
            std::mem::take(&mut desk.vectors);
        self.diagonal(desk, &mut diagonal);
        let wet = std::mem::take(&mut desk.wet);
        let over = || wet.iter().map(|c| *c as usize);
        for c in desk.near.iter().map(|c| *c as usize) {
            y[c] = 0.0;
            scaled[c] = 0.0;
        }
        for c in over() {
            r[c] = -desk.root[c] * desk.residual[c];
            p[c] = r[c] / diagonal[c];
        }
        let mut product: f64 = over().map(|c| r[c] * p[c]).sum();
        let enough = solved * solved * product;
        for _ in 0..MOST_TURNS {
            if product <= enough || product == 0.0 {
                break;
            }
            for c in over() {
                scaled[c] = desk.root[c] * p[c];
            }
            self.product(desk, &scaled, &mut image);
            for c in over() {
                image[c] = p[c] + self.dt * desk.root[c] * image[c];
            }
            let length = product / over().map(|c| p[c] * image[c]).sum::<f64>();
            for c in over() {
                y[c] += length * p[c];
                r[c] -= length * image[c];
            }
            let next: f64 = over().map(|c| r[c] * r[c] / diagonal[c]).sum();
            let share = next / product;
            for c in over() {
                p[c] = r[c] / diagonal[c] + share * p[c];
            }
            product = next;
        }
        for c in over() {
            scaled[c] = desk.root[c] * y[c];
        }
        self.product(desk, &scaled, &mut image);
        for c in desk.near.iter().map(|c| *c as usize) {
            y[c] = -desk.residual[c] - self.dt * image[c];
        }
        desk.wet = wet;
        desk.vectors = [y, r, p, image, scaled, diagonal];
    }
}
