//! Joints that soften, are rough, close along a hyperbola or dilate: one law for points and faces, in the plane and in space.
//!
//! Stress is tension-positive; tractions are (n, b, c) on the first side. The plane uses b alone. Everything follows from the
//! place of a point and from what it remembers, so that forces forget no step: the normal traction is a function of the
//! opening, and its energy the integral of it.
//!
//! Where nothing of this is asked ([`JointModel::is_plain`], no dilation) the kernels of [`super::face_joint`] and
//! [`super::joint_point`] hold.
//!
//! Sources: Barton & Choubey (1977), Rock Mech. 10, 1-54; Barton, Bandis & Bakhtar (1985), Int. J. Rock Mech. Min. Sci. 22,
//! 121-140; Bandis, Lumsden & Barton (1983), ibid. 20, 249-268.

mod face;
mod point;
mod rough;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

use super::face_joint::{Loss, Memory, Springs, Traction};
use super::mohr_coulomb::{Strength, shear_strength};
use super::norm;
use super::softening_curve::Curve;

pub use rough::{BartonBandis, LAB_LENGTH, closure_of, scaled, slip_at_peak};

/// What a joint does beyond Mohr-Coulomb with brittle failure and a linear normal spring.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointModel {
    /// How strength changes with slip and opening.
    pub weakening: Weakening,
    /// How the joint closes under pressure.
    pub closure: Closure,
}

/// How the strength of a joint changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Weakening {
    /// From the peak to the residual values at once.
    #[default]
    Brittle,
    /// Linearly from the peak to the residual values.
    Softening(Softening),
    /// Friction of rough surfaces.
    BartonBandis(BartonBandis),
}

/// Softening along a line, or a curve by points. `x = slip/slip_0 + opening/opening_0`, at most 1, takes cohesion and friction from their
/// peak to their residual values and the tensile strength to nothing: the share `1 - x` is left of what they lose, or that of the curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Softening {
    /// Plastic slip at which only residual strength is left, m.
    pub slip: f64,
    /// Opening beyond the elastic one at which no tensile strength is left, m.
    pub opening: f64,
    /// What is left on the way; `None` for a line.
    pub curve: Option<Curve>,
}

impl Softening {
    /// Damage, 0 to 1, after a slip and an opening (m).
    fn damage(&self, slip: f64, parted: f64) -> f64 {
        let x = (slip / self.slip + parted / self.opening).min(1.0);
        self.curve.map_or(x, |curve| 1.0 - curve.at(x))
    }

    /// Opening (m) beyond the elastic one at which a spring of the stiffness `k` (Pa/m) that is drawn out to `w` (m) bears what is left
    /// of a tensile strength (Pa), after a slip (m).
    fn parted(&self, w: f64, [tension, k]: [f64; 2], slip: f64) -> f64 {
        let Some(curve) = &self.curve else {
            let left = (1.0 - slip / self.slip) * tension;
            return (w - left / k) / (1.0 - tension / (k * self.opening));
        };
        let slid = slip / self.slip;
        for two in curve.points().windows(2) {
            let [[from, high], [to, low]] = [two[0], two[1]];
            let fall = (high - low) / (to - from);
            // k (w - p) = tension (high - fall (slid + p/opening - from)).
            let left = tension * (high - fall * (slid - from));
            let parted = (w - left / k) / (1.0 - fall * tension / (k * self.opening));
            if slid + parted / self.opening <= to {
                return parted;
            }
        }
        w
    }
}

/// Pressure as a function of closure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Closure {
    /// A linear spring.
    #[default]
    Linear,
    /// `s = k V / (1 - V/V_m)` (Bandis et al. 1983, k the initial stiffness), up to where its slope is `stiffest` k; from there on a
    /// straight line.
    ///
    /// Deviation: the source has no end of the curve; a stable step needs one.
    Hyperbolic {
        /// Largest closure V_m, m.
        limit: f64,
        /// Largest stiffness over the initial one, 1 or more.
        stiffest: f64,
    },
}

impl JointModel {
    /// Whether it is Mohr-Coulomb with brittle failure and a linear spring.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.weakening == Weakening::Brittle && self.closure == Closure::Linear
    }

    /// The behaviour with the strength that is not in [`Strength`] divided by `factor`: that of rough surfaces as a whole, not its
    /// parameters.
    #[must_use]
    pub fn reduced(mut self, factor: f64) -> Self {
        if let Weakening::BartonBandis(rough) = &mut self.weakening {
            rough.share /= factor;
        }
        self
    }
}

impl Closure {
    /// Largest stiffness over the initial one.
    #[must_use]
    pub fn stiffest(&self) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Hyperbolic { stiffest, .. } => *stiffest,
        }
    }

    /// Closure and pressure where the hyperbola ends, for the initial stiffness `k` (Pa/m).
    fn end(k: f64, limit: f64, stiffest: f64) -> [f64; 2] {
        let root = stiffest.sqrt();
        // The slope of the curve is k / (1 - V/V_m)²: there it is `stiffest` times k.
        let v = limit * (1.0 - 1.0 / root);
        [v, k * v * root]
    }

    /// Pressure (Pa) at the closure `v >= 0` (m) of a joint with the initial stiffness `k` (Pa/m).
    #[must_use]
    pub fn pressure(&self, k: f64, v: f64) -> f64 {
        match *self {
            Self::Linear => k * v,
            Self::Hyperbolic { limit, stiffest } => {
                let [end, most] = Self::end(k, limit, stiffest);
                if v <= end { k * v / (1.0 - v / limit) } else { most + stiffest * k * (v - end) }
            }
        }
    }

    /// Closure (m) under the pressure `s >= 0` (Pa).
    #[must_use]
    pub fn closed(&self, k: f64, s: f64) -> f64 {
        match *self {
            Self::Linear => s / k,
            Self::Hyperbolic { limit, stiffest } => {
                let [end, most] = Self::end(k, limit, stiffest);
                if s <= most { s / (k + s / limit) } else { end + (s - most) / (stiffest * k) }
            }
        }
    }

    /// Energy (J/m²) stored at the closure `v >= 0` (m): the integral of [`Closure::pressure`].
    #[must_use]
    pub fn energy(&self, k: f64, v: f64) -> f64 {
        match *self {
            Self::Linear => 0.5 * k * v * v,
            Self::Hyperbolic { limit, stiffest } => {
                let [end, most] = Self::end(k, limit, stiffest);
                let on = v.min(end);
                // The integral from 0; `log1p` keeps its digits where the closure is small against the largest.
                let curve = -k * limit * (on + limit * libm::log1p(-on / limit));
                let more = (v - end).max(0.0);
                curve + more * (most + 0.5 * stiffest * k * more)
            }
        }
    }
}

/// The law of a joint: what [`Law::point`] and [`Law::face`] evaluate.
#[derive(Clone, Copy, Debug)]
pub struct Law<'a> {
    /// `None` never fails.
    strength: Option<&'a Strength>,
    behaviour: &'a JointModel,
    /// Initial normal and shear stiffness, Pa/m.
    springs: Springs,
}

impl<'a> Law<'a> {
    /// A law with the largest normal stiffness that it can reach and the shear stiffness `stiffest`, Pa/m.
    #[must_use]
    pub fn new(
        strength: Option<&'a Strength>,
        behaviour: &'a JointModel,
        stiffest: Springs,
    ) -> Self {
        let initial = stiffest[0] / behaviour.closure.stiffest();
        Self { strength, behaviour, springs: [initial, stiffest[1]] }
    }

    /// Initial stiffness, Pa/m: that of dashpots.
    #[must_use]
    pub fn initial(&self) -> Springs {
        self.springs
    }

    /// Opening (m) of a whole joint under the normal traction `sigma`, negative under pressure.
    #[must_use]
    pub fn opening(&self, sigma: f64) -> f64 {
        if sigma > 0.0 {
            sigma / self.springs[0]
        } else {
            -self.behaviour.closure.closed(self.springs[0], -sigma)
        }
    }

    /// Damage of a point with this memory, 0 to 1.
    fn damage(&self, memory: &Memory, accumulated: f64) -> f64 {
        if memory.broken {
            return 1.0;
        }
        match &self.behaviour.weakening {
            Weakening::Softening(s) => s.damage(accumulated, memory.parted),
            Weakening::Brittle | Weakening::BartonBandis(_) => 0.0,
        }
    }

    /// Shear strength (Pa) under the normal traction `sigma` after the plastic slip `accumulated` (m).
    fn limit(&self, sigma: f64, damage: f64, accumulated: f64) -> f64 {
        let Some(s) = self.strength else {
            return f64::INFINITY;
        };
        if let Weakening::BartonBandis(rough) = &self.behaviour.weakening {
            return rough.strength(s.residual_friction, -sigma, accumulated);
        }
        let between = |peak: f64, residual: f64| peak + damage * (residual - peak);
        let friction = between(s.friction, s.residual_friction);
        shear_strength(between(s.cohesion, s.residual_cohesion), friction, sigma)
    }

    /// Shear strength (Pa) that a joint without memory has under the normal traction `sigma`.
    #[must_use]
    pub fn first_limit(&self, sigma: f64) -> f64 {
        self.limit(sigma, 0.0, 0.0)
    }

    /// Whether strength falls at once.
    fn is_brittle(&self) -> bool {
        self.behaviour.weakening == Weakening::Brittle
    }

    /// Shear strength above the residual one, Pa: work against it is work of separation. Rough surfaces have friction alone.
    fn above_residual(&self, sigma: f64, damage: f64, accumulated: f64) -> f64 {
        match &self.behaviour.weakening {
            Weakening::BartonBandis(_) => 0.0,
            Weakening::Brittle | Weakening::Softening(_) => {
                self.limit(sigma, damage, accumulated) - self.limit(sigma, 1.0, accumulated)
            }
        }
    }

    /// Normal traction (Pa) at the opening `w` (m).
    fn normal(&self, w: f64, damage: f64, parted: f64) -> f64 {
        let k = self.springs[0];
        if w <= 0.0 {
            return -self.behaviour.closure.pressure(k, -w);
        }
        // Unloading goes back to the origin: a crack that closes is closed.
        let tension = self.strength.map_or(f64::INFINITY, |s| s.tension);
        // The secant to the point of the softening line that the joint has come to.
        let hold = if parted > 0.0 {
            let left = (1.0 - damage) * tension;
            left / (left + k * parted)
        } else if damage < 1.0 {
            1.0
        } else {
            0.0
        };
        hold * k * w
    }

    /// Stored energy (J/m²) at the opening `w` with the traction `t`.
    fn stored(&self, w: f64, t: &Traction) -> f64 {
        let [kn, ks] = self.springs;
        let normal = if w > 0.0 { 0.5 * t[0] * w } else { self.behaviour.closure.energy(kn, -w) };
        normal + 0.5 * (t[1] * t[1] + t[2] * t[2]) / ks
    }

    /// How far dilation has parted the two sides (m) at the irrecoverable slip `slip`. It closes again where the joint slides back.
    fn dilated(&self, slip: [f64; 2], memory: &Memory) -> f64 {
        match self.strength {
            Some(s) if s.dilation > 0.0 => {
                s.dilating() * norm(slip[0], slip[1]).min(s.dilation_end)
            }
            Some(_) | None => memory.dilated,
        }
    }

    /// Lets tension part a joint at the opening `w`.
    fn part(&self, w: f64, memory: &mut Memory) {
        let Some(strength) = self.strength.filter(|_| w > 0.0 && !memory.broken) else {
            return;
        };
        let k = self.springs[0];
        match &self.behaviour.weakening {
            Weakening::Brittle => memory.broken = k * w > strength.tension,
            Weakening::BartonBandis(_) => memory.broken = true,
            Weakening::Softening(s) => {
                let parted = s.parted(w, [strength.tension, k], memory.accumulated_slip);
                memory.parted = memory.parted.max(parted);
                memory.broken = self.damage(memory, memory.accumulated_slip) >= 1.0;
            }
        }
    }

    /// Books the slip `plastic` (m) along `direction`: accumulated slip, dilation of rough surfaces, and whether nothing but residual strength
    /// is left.
    fn slid(&self, plastic: f64, memory: &mut Memory, dilated: f64) {
        memory.sliding = true;
        memory.accumulated_slip += plastic;
        match &self.behaviour.weakening {
            Weakening::Brittle => memory.broken = true,
            Weakening::Softening(_) => {
                memory.broken = self.damage(memory, memory.accumulated_slip) >= 1.0;
            }
            Weakening::BartonBandis(rough) => {
                memory.dilated = dilated;
                memory.broken |= rough.is_past_peak(memory.accumulated_slip);
            }
        }
    }

    /// Plastic slip (m) that brings the shear traction `tau` (Pa) back to the strength, and the dilation (m) it ends with; `sigma` is the
    /// normal traction at a dilation and a damage.
    fn flow(
        &self,
        tau: f64,
        (slip, direction): ([f64; 2], [f64; 2]),
        memory: &Memory,
        sigma: impl Fn(f64, f64) -> f64,
    ) -> [f64; 2] {
        let accumulated = memory.accumulated_slip;
        let from = norm(slip[0], slip[1]);
        let angle = match (&self.behaviour.weakening, self.strength) {
            (Weakening::BartonBandis(rough), Some(s)) => {
                let now = sigma(memory.dilated, self.damage(memory, accumulated));
                rough.dilation(s.residual_friction, -now, accumulated)
            }
            (Weakening::Brittle | Weakening::Softening(_), _) | (_, None) => 0.0,
        };
        let dilated = |x: f64| {
            let to = [0, 1].map(|k| slip[k] + x * direction[k]);
            let rise = angle * (norm(to[0], to[1]) - from);
            let risen = Memory { dilated: (memory.dilated + rise).max(0.0), ..*memory };
            self.dilated(to, &risen)
        };
        let beyond = |x: f64| {
            let damage = self.damage(memory, accumulated + x);
            let limit = self.limit(sigma(dilated(x), damage), damage, accumulated + x);
            tau - self.springs[1] * x - limit
        };
        // Not more than that: with it the traction is nothing, and no strength is below that.
        let x = root(beyond, tau / self.springs[1], RETURN * tau);
        [x, dilated(x)]
    }
}

/// Share of the shear traction up to which a point lies on its strength.
const RETURN: f64 = 1e-13;
/// Share of the strength beyond which a point slides: the return leaves round-off, which must not slide again where nothing has moved.
const BEYOND: f64 = 1.0 + 1e-12;
/// Most iterations of [`root`]: bisection alone would need half of them.
const ITERATIONS: usize = 100;

/// Zero of a function that is positive at 0 and at most 0 at `high`, to `small`: regula falsi (Illinois).
fn root(f: impl Fn(f64) -> f64, high: f64, small: f64) -> f64 {
    let [mut a, mut b] = [0.0, high];
    let [mut fa, mut fb] = [f(a), f(b)];
    let mut side = 0;
    let mut x = b;
    for _ in 0..ITERATIONS {
        if fa <= small {
            return a;
        }
        if fb >= -small {
            return b;
        }
        x = (a * fb - b * fa) / (fb - fa);
        let fx = f(x);
        // A step that round-off puts on or past an end of the bracket is as near as numbers go.
        if fx.abs() <= small || x <= a || x >= b {
            return x;
        }
        if fx > 0.0 {
            (a, fa) = (x, fx);
            if side == 1 {
                // An end that stays twice counts half: the plain rule would creep up to the zero from one side.
                fb *= 0.5;
            }
            side = 1;
        } else {
            (b, fb) = (x, fx);
            if side == -1 {
                fa *= 0.5;
            }
            side = -1;
        }
    }
    x
}

/// Energy that left a point whose traction went from `before` to `after` while it moved: work (trapezoidal rule) less the growth of
/// what it stores, J/m².
fn lost(before: (&Traction, f64), after: (&Traction, f64), moved: &[f64; 3]) -> f64 {
    let work: f64 = (0..3).map(|k| 0.5 * (before.0[k] + after.0[k]) * moved[k]).sum();
    work - (after.1 - before.1)
}

/// Divides a loss: what was lost above the residual strength is the work of separation.
fn divided(all: f64, separation: f64) -> Loss {
    // The two are found by rules of their own, each with its error: no part is more than the whole.
    let fracture = separation.min(all).max(0.0);
    Loss { friction: all - fracture, fracture }
}
