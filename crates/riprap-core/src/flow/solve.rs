//! One backward Euler step of a network.

use super::junction::{Conduit, Flux, inside};
use super::{Cells, End, Fluid, Friction, Network, Stuck};

/// What may be left of the balance of a cell, over what it holds and what flows through it.
const BALANCED: f64 = 1e-10;
/// Most steps of Newton's method.
const MOST_STEPS: usize = 200;
/// Steps with tangents, and then with secants, and so on: tangents may cycle where neighbours equalise in one step, secants are slow near the end.
const TURNS: usize = 8;
/// The share of a change that is made once each has had its turns: what overshoots by as much as it was off comes to rest.
const RELAXED: f64 = 0.7;
/// What conjugate gradients leave of a right-hand side.
const SOLVED: f64 = 1e-9;
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
    /// Root of `(dPsi/drho)/V` of each cell.
    root: Vec<f64>,
    /// Whether nothing flows faster than sound.
    limited: bool,
    /// Cells that are not dry, ascending.
    wet: Vec<u32>,
    /// Junctions that a cell which is not dry reaches, ascending.
    active: Vec<u32>,
    /// Junctions of cell `c`: `first[c]` to `first[c + 1]` of `touching`.
    first: Vec<u32>,
    touching: Vec<u32>,
    marks: Vec<bool>,
    conduits: Vec<Conduit>,
    /// Flow through each port in the step done last.
    fluxes: Vec<Flux>,
    /// Sum of the tangents of each junction; 0 where its potential is given.
    sums: Vec<f64>,
    /// What flows out of each cell, and the size of all that flows through it, kg/s.
    out: Vec<[f64; 2]>,
    residual: Vec<f64>,
    /// Vectors of the conjugate gradients.
    vectors: [Vec<f64>; 6],
}

impl Desk {
    /// What flows out of its crack through a port in the step done last, kg/s.
    #[must_use]
    pub fn rate(&self, port: usize) -> f64 {
        self.fluxes.get(port).map_or(0.0, |f| f.rate)
    }

    /// Makes room, and takes over the apertures.
    pub(super) fn prepare(&mut self, network: &Network, friction: &Friction, cells: &Cells) {
        let n = cells.masses.len();
        self.friction.clear();
        self.limited = friction.roughness > 0.0;
        let of = |w: &f64| if *w > 0.0 { friction.at(*w) } else { [0.0; 2] };
        self.friction.extend(cells.apertures.iter().map(of));
        self.state.resize(n, [0.0; 2]);
        self.root.resize(n, 0.0);
        self.out.resize(n, [0.0; 2]);
        self.residual.resize(n, 0.0);
        self.vectors.iter_mut().for_each(|v| v.resize(n, 0.0));
        self.fluxes.clear();
        self.fluxes.resize_with(network.ports.len(), Flux::default);
        self.sums.resize(network.ends.len(), 0.0);
        self.marks.resize(network.ends.len(), false);
        if self.first.len() != n + 1 {
            self.reach(network);
        }
    }
}

impl Desk {
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
    let old = cells.masses.to_vec();
    let all: f64 = old.iter().sum();
    let air = fluid.potential(air);
    let (volumes, apertures) = (cells.volumes, cells.apertures);
    let step = Step { network, air, dt, volumes, apertures };
    let mut worst = Stuck { cell: 0, left: 0.0 };
    for turn in 0..MOST_STEPS {
        step.look(fluid, cells.masses, desk);
        step.flow(desk, turn / TURNS % 2 == 1);
        worst = Stuck { cell: 0, left: 0.0 };
        for (c, &old) in old.iter().enumerate() {
            let [out, size] = desk.out[c];
            desk.residual[c] = cells.masses[c] - old + dt * out;
            let scale = cells.masses[c].max(dt * size).max(NOTHING * all);
            let left = if scale > 0.0 { desk.residual[c].abs() / scale } else { 0.0 };
            // Numbers that are none are the worst.
            if left > worst.left || left.is_nan() {
                worst = Stuck { cell: c as u32, left };
            }
        }
        if worst.left <= BALANCED {
            return Ok(());
        }
        if !worst.left.is_finite() {
            return Err(worst);
        }
        step.solve(desk);
        let share = if turn < 2 * TURNS { 1.0 } else { RELAXED };
        for (c, m) in cells.masses.iter_mut().enumerate() {
            let change = share * desk.vectors[0][c];
            // Below nothing only in steps that are too long: the next one makes up for it.
            *m = if *m + change < 0.0 { 0.5 * *m } else { *m + change };
        }
    }
    Err(worst)
}

impl Step<'_> {
    /// Potentials of the cells, and the junctions that gas reaches.
    fn look(&self, fluid: &Fluid, masses: &[f64], desk: &mut Desk) {
        desk.marks.fill(false);
        desk.wet.clear();
        for (c, &m) in masses.iter().enumerate() {
            if m <= 0.0 || self.volumes[c] <= 0.0 {
                desk.state[c] = [0.0; 2];
                desk.root[c] = 0.0;
                continue;
            }
            let density = m / self.volumes[c];
            let bulk = fluid.bulk(density);
            let sound = if desk.limited { (density * bulk).sqrt() } else { f64::INFINITY };
            desk.state[c] = [fluid.potential(density), sound];
            desk.root[c] = (bulk / self.volumes[c]).sqrt();
            desk.wet.push(c as u32);
            let range = desk.first[c] as usize..desk.first[c + 1] as usize;
            for &j in &desk.touching[range] {
                desk.marks[j as usize] = true;
            }
        }
        desk.active.clear();
        desk.active.extend((0..).zip(&desk.marks).filter(|(_, m)| **m).map(|(j, _)| j));
    }

    /// The cell whose potential a junction has.
    fn holder(&self, junction: u32) -> Option<usize> {
        match self.network.ends[junction as usize] {
            End::Cell(c) if self.volumes[c as usize] > 0.0 => Some(c as usize),
            End::Cell(_) | End::Inside | End::Air => None,
        }
    }

    /// What flows through all ports, and out of all cells.
    fn flow(&self, desk: &mut Desk, secant: bool) {
        desk.out.fill([0.0; 2]);
        let active = std::mem::take(&mut desk.active);
        let mut conduits = std::mem::take(&mut desk.conduits);
        for &j in &active {
            let range = self.network.ports_of(j);
            conduits.clear();
            conduits.extend(self.network.ports[range.clone()].iter().map(|port| {
                let c = port.cell as usize;
                let [potential, sound] = desk.state[c];
                let section = port.length * self.apertures[c];
                Conduit { section, path: port.path, friction: desk.friction[c], potential, sound }
            }));
            let fluxes = &mut desk.fluxes[range.clone()];
            let holder = self.holder(j);
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
                inside(&conduits, secant, fluxes);
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

    /// `to = L x`.
    fn product(&self, desk: &Desk, x: &[f64], to: &mut [f64]) {
        to.fill(0.0);
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
        to.fill(0.0);
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
        for (d, root) in to.iter_mut().zip(&desk.root) {
            *d = 1.0 + self.dt * root * root * *d;
        }
    }

    /// The change of the masses, into the first vector of the desk.
    fn solve(&self, desk: &mut Desk) {
        let [mut y, mut r, mut p, mut image, mut scaled, mut diagonal] =
            std::mem::take(&mut desk.vectors);
        self.diagonal(desk, &mut diagonal);
        let wet = std::mem::take(&mut desk.wet);
        let over = || wet.iter().map(|c| *c as usize);
        y.fill(0.0);
        scaled.fill(0.0);
        for c in over() {
            r[c] = -desk.root[c] * desk.residual[c];
            p[c] = r[c] / diagonal[c];
        }
        let mut product: f64 = over().map(|c| r[c] * p[c]).sum();
        let enough = SOLVED * SOLVED * product;
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
        for (c, change) in y.iter_mut().enumerate() {
            *change = -desk.residual[c] - self.dt * image[c];
        }
        desk.wet = wet;
        desk.vectors = [y, r, p, image, scaled, diagonal];
    }
}
