//! The junctions that gas reaches, with the ports through which it can flow: what flows at the present potentials, and the matrix of its tangents.

use super::End;
use super::junction::{Conduit, Flux, inside};
use super::stage::{State, Step};
use crate::exec::{CHUNK, Exec};

/// Junctions that gas reaches.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    rows: Vec<Row>,
    /// Open ports of row `k`: `first[k]` to `first[k + 1]`.
    first: Vec<u32>,
    conduits: Vec<Conduit>,
    fluxes: Vec<Flux>,
    /// Crack of each port, and the tangent of what flows through it, m s.
    links: Vec<(u32, f64)>,
    /// Change of the potential of each row.
    changes: Vec<f64>,
    /// Potential of each junction of the network where the rows were others in this step.
    heads: Vec<f64>,
    /// What chunks of rows leave beside it: nothing.
    nothing: Vec<()>,
}

/// A junction that gas reaches.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// Its number in the network.
    junction: u32,
    /// What holds there: a cell that holds nothing does not count.
    end: End,
    /// Its potential, found last in this step; not a number before.
    head: f64,
    /// Sum of the tangents of its ports, m s.
    sum: f64,
}

/// What cells were when the step began.
#[derive(Clone, Copy)]
pub(super) struct Before<'a> {
    /// Friction of each.
    pub friction: &'a [[f64; 2]],
    /// Density of each, kg/m³; none without inertia.
    pub density: Option<&'a [f64]>,
}

impl Rows {
    /// Begins a step of a network with so many junctions: nothing is remembered.
    pub(super) fn begin(&mut self, junctions: usize) {
        self.rows.clear();
        self.heads.clear();
        self.heads.resize(junctions, f64::NAN);
    }

    /// Takes over the junctions that gas reaches, ascending; `old` flowed in the step before, kg/(m² s).
    pub(super) fn gather(
        &mut self,
        step: &Step,
        junctions: impl Iterator<Item = u32>,
        before: Before,
        old: &[f64],
    ) {
        for row in self.rows.drain(..) {
            self.heads[row.junction as usize] = row.head;
        }
        self.first.clear();
        self.conduits.clear();
        self.first.push(0);
        for junction in junctions {
            let j = junction as usize;
            let holder = step.holder(junction);
            let end = match (holder, step.network.ends[j]) {
                (Some(c), _) => End::Cell(c as u32),
                (None, End::Air) => End::Air,
                (None, End::Cell(_) | End::Inside) => End::Inside,
            };
            let begin = self.conduits.len();
            let open = step.network.ports_of(junction).filter(|p| step.section(*p) > 0.0);
            self.conduits.extend(open.map(|p| Conduit::of(p, step.network.ports[p].cell)));
            // Nothing flows where only one crack ends.
            if end == End::Inside && self.conduits.len() < begin + 2 {
                self.conduits.truncate(begin);
                continue;
            }
            self.rows.push(Row { junction, end, head: self.heads[j], sum: 0.0 });
            self.first.push(self.conduits.len() as u32);
        }
        self.fluxes.clear();
        self.fluxes.resize_with(self.conduits.len(), Flux::default);
        self.links.clear();
        self.links.extend(self.conduits.iter().map(|conduit| (conduit.cell, 0.0)));
        self.changes.resize(self.rows.len(), 0.0);
        self.nothing.resize(self.rows.len().div_ceil(CHUNK), ());
        let Self { rows, first, conduits, nothing, .. } = self;
        step.exec.ragged(rows, conduits, first, nothing, |from, rows, conduits, ()| {
            let mut rest = conduits;
            for (row, ends) in rows.iter().zip(first[from..].windows(2)) {
                let (own, others) = rest.split_at_mut((ends[1] - ends[0]) as usize);
                rest = others;
                for conduit in own {
                    step.lay(conduit, row.end, before, old[conduit.port as usize]);
                }
            }
        });
    }

    /// Numbers of the junctions at which gas flows.
    pub(super) fn junctions(&self) -> impl Iterator<Item = u32> {
        self.rows.iter().map(|row| row.junction)
    }

    /// Rows with the numbers of their ports.
    fn ranges(&self) -> impl Iterator<Item = (&Row, std::ops::Range<usize>)> {
        let ranges = self.first.windows(2).map(|ends| ends[0] as usize..ends[1] as usize);
        self.rows.iter().zip(ranges)
    }

    /// What flows through all ports, and its tangents; `out` gets what flows out of each cell, and the size of all that flows through it, kg/s.
    pub(super) fn flow(
        &mut self,
        exec: &Exec,
        states: &[State],
        (air, secant): (f64, bool),
        out: &mut [[f64; 2]],
    ) {
        let Self { rows, first, conduits, fluxes, nothing, .. } = self;
        exec.ragged(rows, fluxes, first, nothing, |from, rows, fluxes, ()| {
            let begin = first[from] as usize;
            for (row, ends) in rows.iter_mut().zip(first[from..].windows(2)) {
                let range = ends[0] as usize..ends[1] as usize;
                let own = &mut fluxes[range.start - begin..range.end - begin];
                row.flow(&conduits[range], states, (air, secant), own);
            }
        });
        for (link, flux) in self.links.iter_mut().zip(&self.fluxes) {
            link.1 = flux.tangent;
        }
        for (row, range) in self.ranges() {
            for (link, flux) in self.links[range.clone()].iter().zip(&self.fluxes[range]) {
                let size = flux.rate.abs();
                let crack = &mut out[link.0 as usize];
                *crack = [crack[0] + flux.rate, crack[1] + size];
                if let End::Cell(c) = row.end {
                    let holder = &mut out[c as usize];
                    *holder = [holder[0] - flux.rate, holder[1] + size];
                }
            }
        }
    }

    /// Finds the changes of the potentials of junctions when those of cells change by `x`.
    fn change(&mut self, exec: &Exec, x: &[f64]) {
        let Self { rows, first, links, changes, .. } = self;
        exec.chunks(changes, |from, changes| {
            let ranges = first[from..].windows(2);
            for ((change, row), ends) in changes.iter_mut().zip(&rows[from..]).zip(ranges) {
                let links = &links[ends[0] as usize..ends[1] as usize];
                *change = match row.end {
                    End::Cell(c) => x[c as usize],
                    End::Inside if row.sum > 0.0 => {
                        links.iter().map(|(c, t)| t * x[*c as usize]).sum::<f64>() / row.sum
                    }
                    End::Inside | End::Air => 0.0,
                };
            }
        });
    }

    /// Adds `L x` to `to`.
    pub(super) fn product(&mut self, exec: &Exec, x: &[f64], to: &mut [f64]) {
        self.change(exec, x);
        for ((row, range), at) in self.ranges().zip(&self.changes) {
            for (c, t) in &self.links[range] {
                let rate = t * (x[*c as usize] - at);
                to[*c as usize] += rate;
                if let End::Cell(h) = row.end {
                    to[h as usize] -= rate;
                }
            }
        }
    }

    /// Adds the diagonal of `L` to `to`.
    pub(super) fn diagonal(&self, to: &mut [f64]) {
        for (row, range) in self.ranges() {
            let over = if row.end == End::Inside { row.sum } else { 0.0 };
            for (c, t) in &self.links[range] {
                let share = if over > 0.0 { t / over } else { 0.0 };
                to[*c as usize] += t * (1.0 - share);
                if let End::Cell(h) = row.end {
                    to[h as usize] += t;
                }
            }
        }
    }

    /// Adds `L x` to `to`, and lets what flows and the potentials of junctions follow the tangents when those of cells change by `x`.
    pub(super) fn follow(&mut self, exec: &Exec, x: &[f64], to: &mut [f64]) {
        self.product(exec, x, to);
        let Self { rows, first, links, fluxes, changes, .. } = self;
        for ((row, ends), at) in rows.iter_mut().zip(first.windows(2)).zip(changes) {
            row.head += *at;
            let range = ends[0] as usize..ends[1] as usize;
            for ((c, t), flux) in links[range.clone()].iter().zip(&mut fluxes[range]) {
                flux.rate += t * (x[*c as usize] - *at);
            }
        }
    }

    /// Hands on what flows through ports, kg/(m² s); nothing does at junctions that gas reaches, `reached`, but through those that are open.
    pub(super) fn keep(&self, step: &Step, reached: impl Iterator<Item = u32>, fluxes: &mut [f64]) {
        for j in reached {
            fluxes[step.network.ports_of(j)].fill(0.0);
        }
        for (conduit, flux) in self.conduits.iter().zip(&self.fluxes) {
            fluxes[conduit.port as usize] = flux.rate / conduit.section;
        }
    }
}

impl Row {
    /// Finds its fluxes between cracks in these states.
    fn flow(
        &mut self,
        conduits: &[Conduit],
        states: &[State],
        (air, secant): (f64, bool),
        fluxes: &mut [Flux],
    ) {
        let given = match self.end {
            End::Cell(c) => [states[c as usize].potential, states[c as usize].sound],
            End::Air => [air, 0.0],
            End::Inside => {
                inside(conduits, states, secant, &mut self.head, fluxes);
                self.sum = fluxes.iter().map(|flux| flux.tangent).sum();
                return;
            }
        };
        for (flux, conduit) in fluxes.iter_mut().zip(conduits) {
            let state = states[conduit.cell as usize];
            let blocked = self.end == End::Air && state.potential + conduit.lead <= air;
            *flux = if blocked { Flux::default() } else { conduit.flux(state, given, secant) };
        }
    }
}

impl Step<'_> {
    /// Makes a conduit what it is in this step; `flux` is what flowed in the step before, kg/(m² s).
    fn lay(&self, conduit: &mut Conduit, end: End, before: Before, flux: f64) {
        let port = conduit.port as usize;
        let path = self.network.ports[port].path;
        let c = conduit.cell as usize;
        let [a, b] = before.friction[c];
        let inertia = before.density.map_or(0.0, |density| {
            let between = match end {
                End::Cell(h) => 0.5 * (density[c] + density[h as usize]),
                End::Inside | End::Air => density[c],
            };
            between / self.dt
        });
        conduit.section = self.section(port);
        conduit.per_path = 1.0 / path;
        conduit.friction = [a + inertia, b];
        conduit.guess = conduit.section * conduit.per_path / (a + inertia + b * flux.abs());
        conduit.lead = path * inertia * flux;
    }
}
