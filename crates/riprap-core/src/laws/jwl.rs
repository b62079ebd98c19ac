//! Detonation products by the equation of state of Jones, Wilkins and Lee.
//!
//! With the volume `v` over that of the charge and the energy `E` per volume of the charge
//!
//! ```text
//!   P = A (1 - w/(R1 v)) exp(-R1 v) + B (1 - w/(R2 v)) exp(-R2 v) + w E/v
//! ```
//!
//! and on the isentrope through the Chapman-Jouguet state `P = A exp(-R1 v) + B exp(-R2 v) + C v^-(1+w)`, the energy of which is its
//! integral. `C` is no constant of its own: the state of Chapman and Jouguet is where the velocity of detonation is least on the Hugoniot curve
//! `E = E0 + P (1 - v)/2`, `rho D² = P/(1 - v)`, and its energy gives `C`. So a published velocity of detonation is a check, not an input.
//!
//! Source: Lee, Hornig and Kury (1968), UCRL-50422. Constants: Dobratz and Crawford (1985), UCRL-52997 (TNT); Penn, Helm, Finger and Lee (1975),
//! UCRL-51892 (ANFO); a set in wide use for gassed emulsion, whose first publication was not found.

use serde::{Deserialize, Serialize};

/// Relative volumes between which the state of Chapman and Jouguet is searched for.
const BETWEEN: [f64; 2] = [0.5, 0.95];
/// Steps of the search: each takes 0.618 of what is left.
const SEARCH: usize = 60;
/// A given velocity of detonation must be that of the constants within this share: published ones are within 1 %.
pub const AGREES: f64 = 0.05;

/// An explosive by the constants of its products.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Jwl {
    /// Density of the charge, kg/m³.
    pub density: f64,
    /// A, Pa.
    pub a: f64,
    /// B, Pa.
    pub b: f64,
    /// R1.
    pub r1: f64,
    /// R2.
    pub r2: f64,
    /// w.
    pub omega: f64,
    /// E0: energy of detonation per volume of the charge, J/m³.
    pub energy: f64,
}

/// A state of the products.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChapmanJouguet {
    /// Volume over that of the charge.
    pub volume: f64,
    /// Pa.
    pub pressure: f64,
    /// Velocity of detonation, m/s.
    pub velocity: f64,
}

impl Jwl {
    /// TNT of 1630 kg/m³, 6930 m/s.
    pub const TNT: Self = Self {
        density: 1630.0,
        a: 371.2e9,
        b: 3.231e9,
        r1: 4.15,
        r2: 0.95,
        omega: 0.30,
        energy: 7.0e9,
    };
    /// ANFO of 931 kg/m³, 4160 m/s.
    pub const ANFO: Self = Self {
        density: 931.0,
        a: 49.46e9,
        b: 1.891e9,
        r1: 3.907,
        r2: 1.118,
        omega: 0.333_33,
        energy: 2.484e9,
    };
    /// Emulsion of 1310 kg/m³, 5500 m/s.
    pub const EMULSION: Self = Self {
        density: 1310.0,
        a: 214.4e9,
        b: 0.182e9,
        r1: 4.2,
        r2: 0.9,
        omega: 0.15,
        energy: 4.192e9,
    };

    /// Pressure on the Hugoniot curve of the products at a relative volume, Pa.
    fn hugoniot(&self, v: f64) -> f64 {
        let Self { a, b, r1, r2, omega, energy, .. } = *self;
        let stage = |k: f64, r: f64| k * (1.0 - omega / (r * v)) * libm::exp(-r * v);
        let cold = stage(a, r1) + stage(b, r2) + omega * energy / v;
        cold / (1.0 - 0.5 * omega * (1.0 - v) / v)
    }

    /// The state of Chapman and Jouguet.
    #[must_use]
    pub fn chapman_jouguet(&self) -> ChapmanJouguet {
        let square = |v: f64| self.hugoniot(v) / (self.density * (1.0 - v));
        let share = 0.5 * (5.0_f64.sqrt() - 1.0);
        let [mut low, mut high] = BETWEEN;
        let mut inner = [high - share * (high - low), low + share * (high - low)];
        let mut at = inner.map(square);
        for _ in 0..SEARCH {
            if at[0] < at[1] {
                high = inner[1];
                inner = [high - share * (high - low), inner[0]];
                at = [square(inner[0]), at[0]];
            } else {
                low = inner[0];
                inner = [inner[1], low + share * (high - low)];
                at = [at[1], square(inner[1])];
            }
        }
        let volume = 0.5 * (low + high);
        ChapmanJouguet { volume, pressure: self.hugoniot(volume), velocity: square(volume).sqrt() }
    }

    /// Whether the constants make products that expand: numbers above 0 and a state of Chapman and Jouguet within its bounds.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let Self { density, a, b, r1, r2, omega, energy } = *self;
        let numbers = [density, a, b, r1, r2, omega, energy];
        let ChapmanJouguet { volume, pressure, .. } = self.chapman_jouguet();
        let [low, high] = BETWEEN;
        let inside = low + 1e-3 < volume && volume < high - 1e-3;
        numbers.iter().all(|x| x.is_finite() && *x > 0.0)
            && r1 > r2
            && inside
            && pressure.is_finite()
            && self.isentrope(1.0).c > 0.0
    }

    /// The isentrope of a charge of this volume (m³).
    #[must_use]
    pub fn isentrope(&self, v0: f64) -> Isentrope {
        let Self { a, b, r1, r2, omega, energy, .. } = *self;
        let ChapmanJouguet { volume: v, pressure, .. } = self.chapman_jouguet();
        let at = energy + 0.5 * pressure * (1.0 - v);
        let cold = a / r1 * libm::exp(-r1 * v) + b / r2 * libm::exp(-r2 * v);
        let c = (at - cold) * omega * libm::pow(v, omega);
        Isentrope { v0, a, b, c, r1, r2, omega }
    }
}

/// Pressure of the products of a charge as a function of their volume.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Isentrope {
    /// Volume of the charge, m³.
    pub v0: f64,
    /// A, Pa.
    pub a: f64,
    /// B, Pa.
    pub b: f64,
    /// C, Pa.
    pub c: f64,
    /// R1.
    pub r1: f64,
    /// R2.
    pub r2: f64,
    /// w.
    pub omega: f64,
}

impl Isentrope {
    /// The three terms of the pressure at a volume (m³), Pa.
    fn terms(&self, volume: f64) -> [f64; 3] {
        let v = volume / self.v0;
        [
            self.a * libm::exp(-self.r1 * v),
            self.b * libm::exp(-self.r2 * v),
            self.c * libm::pow(v, -1.0 - self.omega),
        ]
    }

    /// Pressure at `volume` (m³), Pa.
    #[must_use]
    pub fn pressure(&self, volume: f64) -> f64 {
        self.terms(volume).iter().sum()
    }

    /// Exponent at `volume` (m³): the bulk modulus over the pressure.
    #[must_use]
    pub fn exponent(&self, volume: f64) -> f64 {
        let v = volume / self.v0;
        let [a, b, c] = self.terms(volume);
        (self.r1 * v * a + self.r2 * v * b + (1.0 + self.omega) * c) / (a + b + c)
    }

    /// Work from the volume of the charge to `volume` (m³), J.
    #[must_use]
    pub fn work(&self, volume: f64) -> f64 {
        self.held(self.v0) - self.held(volume)
    }

    /// Work that is left at a volume (m³) in an expansion without end, J.
    pub(crate) fn held(&self, volume: f64) -> f64 {
        let v = volume / self.v0;
        let [a, b, c] = self.terms(volume);
        self.v0 * (a / self.r1 + b / self.r2 + c * v / self.omega)
    }

    /// The integral of `dP/V` from an expansion without end to `volume` (m³), Pa/m³.
    pub(crate) fn drive(&self, volume: f64) -> f64 {
        let v = volume / self.v0;
        let term = |k: f64, r: f64| k * r * exponential_integral(r * v);
        let [_, _, c] = self.terms(volume);
        let power = (1.0 + self.omega) / (2.0 + self.omega) * c / v;
        (term(self.a, self.r1) + term(self.b, self.r2) + power) / self.v0
    }
}

/// `E1(x)`, the integral of `exp(-t)/t` from `x > 0` on.
///
/// Source: Abramowitz & Stegun (1964), 5.1.11 (series) and 5.1.22 (continued fraction).
fn exponential_integral(x: f64) -> f64 {
    const EULER: f64 = 0.577_215_664_901_532_9;
    const TERMS: i32 = 60;
    if x > 700.0 {
        return 0.0;
    }
    if x <= 1.0 {
        let (mut sum, mut power) = (-EULER - libm::log(x), 1.0);
        for k in 1..=TERMS {
            power *= -x / f64::from(k);
            let term = power / f64::from(k);
            sum -= term;
            if term.abs() <= f64::EPSILON * sum.abs() {
                break;
            }
        }
        return sum;
    }
    // Lentz's way through 1/(x + 1 - 1/(x + 3 - 4/(x + 5 - ...))).
    let mut b = x + 1.0;
    let (mut c, mut d) = (1.0 / f64::MIN_POSITIVE.sqrt(), 1.0 / b);
    let mut fraction = d;
    for k in 1..=20 * TERMS {
        let a = -f64::from(k) * f64::from(k);
        b += 2.0;
        d = 1.0 / (a * d + b);
        c = b + a / c;
        fraction *= c * d;
        if (c * d - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    fraction * libm::exp(-x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a / b - 1.0).abs() <= tolerance, "{a} {b}");
    }

    /// The published pressures and velocities of Chapman and Jouguet follow from the other constants.
    #[test]
    fn published_detonations_follow_from_the_constants() {
        for (jwl, pressure, velocity) in [
            (Jwl::TNT, 21.0e9, 6930.0),
            (Jwl::ANFO, 5.15e9, 4160.0),
            (Jwl::EMULSION, 9.9e9, 5500.0),
        ] {
            let found = jwl.chapman_jouguet();
            near(found.pressure, pressure, 0.02);
            near(found.velocity, velocity, 0.01);
            assert!(jwl.is_sound());
        }
    }

    /// C of TNT is published: 1.045 GPa. All of the energy of detonation is work in an expansion without end, but for what compresses the products to
    /// the volume of the charge.
    #[test]
    fn the_isentrope_has_the_published_constant_and_the_energy() {
        let gas = Jwl::TNT.isentrope(1.0);
        near(gas.c, 1.045e9, 2e-3);
        let found = Jwl::TNT.chapman_jouguet();
        near(gas.pressure(found.volume), found.pressure, 1e-6);
        let all = gas.held(found.volume);
        near(all, 7.0e9 + 0.5 * found.pressure * (1.0 - found.volume), 1e-12);
        assert!(gas.work(1e12) < all);
    }

    #[test]
    fn work_is_the_integral_of_the_pressure_and_the_exponent_its_slope() {
        for jwl in [Jwl::TNT, Jwl::ANFO, Jwl::EMULSION] {
            let gas = jwl.isentrope(2e-3);
            for (from, to) in [(0.7, 1.0), (1.0, 3.0), (1.0, 40.0)] {
                let n = 4000;
                let (a, b) = (f64::ln(from), f64::ln(to));
                let h = (b - a) / f64::from(n);
                let f = |k: i32| {
                    let v = gas.v0 * f64::exp(a + h * f64::from(k));
                    gas.pressure(v) * v
                };
                let sum: f64 = (0..n).step_by(2).map(|k| f(k) + 4.0 * f(k + 1) + f(k + 2)).sum();
                near(gas.work(to * gas.v0) - gas.work(from * gas.v0), sum * h / 3.0, 1e-6);
            }
            let (v, step) = (2.5 * gas.v0, 1e-6);
            let slope = (gas.pressure(v * (1.0 + step)) - gas.pressure(v * (1.0 - step)))
                / (2.0 * step * gas.pressure(v));
            near(gas.exponent(v), -slope, 1e-6);
        }
    }

    /// Abramowitz & Stegun, tables 5.1 and 5.2.
    #[test]
    fn exponential_integrals_of_the_tables() {
        for (x, value) in [
            (0.5, 0.559_773_595),
            (1.0, 0.219_383_934_395_520),
            (2.0, 0.048_900_510_708),
            (10.0, 4.156_968_929_7e-6),
        ] {
            near(exponential_integral(x), value, 1e-9);
        }
        near(exponential_integral(1.0 + 1e-12), exponential_integral(1.0), 1e-11);
    }

    #[test]
    fn constants_that_do_not_detonate_are_not_sound() {
        assert!(!Jwl { energy: -1.0, ..Jwl::TNT }.is_sound());
        assert!(!Jwl { r1: 0.5, ..Jwl::TNT }.is_sound());
        assert!(!Jwl { a: f64::NAN, ..Jwl::TNT }.is_sound());
        assert!(!Jwl { omega: 0.0, ..Jwl::TNT }.is_sound());
    }
}
