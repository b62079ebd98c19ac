//! One junction: its potential, what flows through its ports, and the tangents of that.

/// Turns of the search for the potential of a junction.
const SEARCH: usize = 100;
/// What may be left of the balance of a junction, over all that flows through it.
const BALANCED: f64 = 1e-10;

/// A port with the state of its crack.
#[derive(Clone, Copy, Debug)]
pub(super) struct Conduit {
    /// Length of the junction times aperture, m².
    pub section: f64,
    /// Distance of the middle of the crack, m.
    pub path: f64,
    /// `12 mu/w^2` (with inertia `+ rho/dt`) and `f/w` of the crack.
    pub friction: [f64; 2],
    /// Potential in the crack, Pa kg/m³; with inertia and what would keep up the flow of the step before.
    pub potential: f64,
    /// `rho c` in the crack, kg/(m² s).
    pub sound: f64,
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
    /// Flow to a junction of this potential; `limit` is `rho c` of what comes from there. `secant`: rate over difference in place of the tangent.
    pub(super) fn flux(&self, junction: f64, limit: f64, secant: bool) -> Flux {
        let [a, b] = self.friction;
        let gradient = (self.potential - junction) / self.path;
        let root = (a * a + 4.0 * b * gradient.abs()).sqrt();
        let flux = 2.0 * gradient / (a + root);
        let most = if gradient > 0.0 { self.sound } else { limit };
        let per = self.section / self.path;
        let (rate, share) = if flux.abs() > most {
            (self.section * most.copysign(flux), most / flux.abs())
        } else {
            (self.section * flux, 1.0)
        };
        let tangent = per * share * if secant { 2.0 / (a + root) } else { 1.0 / root };
        Flux { rate, tangent, slope: if share < 1.0 { 0.0 } else { per / root } }
    }
}

/// Fluxes of a junction where what comes in goes out; `guess` at its potential (not a number: none), which is found.
pub(super) fn inside(conduits: &[Conduit], secant: bool, guess: &mut f64, fluxes: &mut [Flux]) {
    let open = || conduits.iter().filter(|c| c.section > 0.0);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for conduit in open() {
        low = low.min(conduit.potential);
        high = high.max(conduit.potential);
    }
    if low >= high {
        for (flux, conduit) in fluxes.iter_mut().zip(conduits) {
            *flux = Flux::default();
            if conduit.section > 0.0 {
                *flux = conduit.flux(conduit.potential, f64::INFINITY, secant);
            }
        }
        return;
    }
    let mut at = *guess;
    if !(low < at && at < high) {
        let [mut weighted, mut weights] = [0.0; 2];
        for conduit in open() {
            let weight = conduit.flux(0.5 * (low + high), f64::INFINITY, true).tangent;
            weighted += weight * conduit.potential;
            weights += weight;
        }
        at = if weights > 0.0 { weighted / weights } else { 0.5 * (low + high) };
    }
    let mut last = f64::INFINITY;
    for _ in 0..SEARCH {
        let [mut sum, mut size, mut slope] = [0.0; 3];
        for (flux, conduit) in fluxes.iter_mut().zip(conduits) {
            *flux = Flux::default();
            if conduit.section > 0.0 {
                *flux = conduit.flux(at, f64::INFINITY, secant);
            }
            sum += flux.rate;
            size += flux.rate.abs();
            slope += flux.slope;
        }
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
    *guess = at;
    // What is left of the balance goes to the largest, so that no mass is made.
    let left: f64 = fluxes.iter().map(|f| f.rate).sum();
    if let Some(largest) = fluxes.iter_mut().max_by(|a, b| a.rate.abs().total_cmp(&b.rate.abs())) {
        largest.rate -= left;
    }
}
