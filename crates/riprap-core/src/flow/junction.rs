//! One junction: its potential, what flows through its ports, and the tangents of that.

use super::stage::State;

/// Turns of the search for the potential of a junction.
const SEARCH: usize = 100;
/// What the search leaves of the balance of a junction, over all that flows through it; the rest goes by the tangents.
const BALANCED: f64 = 1e-3;

/// A port through which gas can flow, with what stays in a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Conduit {
    /// Its crack.
    pub cell: u32,
    /// Its number.
    pub port: u32,
    /// Length of the junction times aperture, m².
    pub section: f64,
    /// The inverse of the distance of the middle of the crack, 1/m.
    pub per_path: f64,
    /// `12 mu/w^2` (with inertia `+ rho/dt`) and `f/w` of the crack.
    pub friction: [f64; 2],
    /// What is added to the potential of the crack: with inertia what would keep up the flow of the step before, Pa kg/m³.
    pub lead: f64,
    /// What flows per difference of potential when it flows as in the step before, m s.
    pub guess: f64,
}

/// What flows out of a crack through a port.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Flux {
    /// kg/s.
    pub rate: f64,
    /// Its derivative by the potential of the crack, m s.
    pub tangent: f64,
    /// The derivative less what the limit of sound takes from it.
    slope: f64,
}

impl Conduit {
    /// A port of a crack, of which the rest is found in each step.
    pub(super) fn of(port: usize, cell: u32) -> Self {
        let port = port as u32;
        Self { cell, port, section: 0.0, per_path: 0.0, friction: [0.0; 2], lead: 0.0, guess: 0.0 }
    }

    /// Flow from a crack in this state to a junction of this potential; `limit` is `rho c` of what comes from there.
    /// `secant`: rate over difference in place of the tangent.
    pub(super) fn flux(&self, state: State, [junction, limit]: [f64; 2], secant: bool) -> Flux {
        let [a, b] = self.friction;
        let gradient = (state.potential + self.lead - junction) * self.per_path;
        let root = (a * a + 4.0 * b * gradient.abs()).sqrt();
        // 1/root and 2/(a + root) with one division.
        let both = 1.0 / (root * (a + root));
        let [steep, mean] = [(a + root) * both, 2.0 * root * both];
        let flux = gradient * mean;
        let most = if gradient > 0.0 { state.sound } else { limit };
        let per = self.section * self.per_path;
        let tangent = per * if secant { mean } else { steep };
        if flux.abs() > most {
            let rate = self.section * most.copysign(flux);
            return Flux { rate, tangent: most / flux.abs() * tangent, slope: 0.0 };
        }
        Flux { rate: self.section * flux, tangent, slope: per * steep }
    }
}

/// Fluxes of a junction where what comes in goes out, among cracks in these states; `head` is a guess at its potential (not a number: none), which is
/// found.
pub(super) fn inside(
    conduits: &[Conduit],
    states: &[State],
    secant: bool,
    head: &mut f64,
    fluxes: &mut [Flux],
) {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let [mut weighted, mut weights] = [0.0; 2];
    for conduit in conduits {
        let potential = states[conduit.cell as usize].potential + conduit.lead;
        low = low.min(potential);
        high = high.max(potential);
        weighted += conduit.guess * potential;
        weights += conduit.guess;
    }
    if low >= high {
        for (flux, conduit) in fluxes.iter_mut().zip(conduits) {
            let state = states[conduit.cell as usize];
            *flux = conduit.flux(state, [state.potential + conduit.lead, f64::INFINITY], secant);
        }
        *head = low;
        return;
    }
    let mut at = *head;
    if !(low < at && at < high) {
        at = weighted / weights;
    }
    if !(low < at && at < high) {
        at = 0.5 * (low + high);
    }
    let mut last = f64::INFINITY;
    let mut left = 0.0;
    for _ in 0..SEARCH {
        let [mut sum, mut size, mut slope] = [0.0; 3];
        for (flux, conduit) in fluxes.iter_mut().zip(conduits) {
            *flux = conduit.flux(states[conduit.cell as usize], [at, f64::INFINITY], secant);
            sum += flux.rate;
            size += flux.rate.abs();
            slope += flux.slope;
        }
        left = sum;
        if sum.abs() <= BALANCED * size {
            break;
        }
        if sum > 0.0 {
            low = at;
        } else {
            high = at;
        }
        // Newton's method goes to and fro about the root of a square root.
        let next = at + sum / slope;
        let serves = next > low && next < high && sum.abs() < 0.5 * last;
        let next = if serves { next } else { 0.5 * (low + high) };
        last = sum.abs();
        if next == at || next == low || next == high {
            break;
        }
        at = next;
    }
    let tangents: f64 = fluxes.iter().map(|f| f.tangent).sum();
    if tangents > 0.0 {
        let off = left / tangents;
        at += off;
        for flux in fluxes.iter_mut() {
            flux.rate -= flux.tangent * off;
        }
    }
    *head = at;
    // What round-off leaves of the balance goes to the largest, so that no mass is made.
    let left: f64 = fluxes.iter().map(|f| f.rate).sum();
    if let Some(largest) = fluxes.iter_mut().max_by(|a, b| a.rate.abs().total_cmp(&b.rate.abs())) {
        largest.rate -= left;
    }
}
