//! Detonation gas on a two-stage adiabat.
//!
//! Source: Tian & Li, eqs. (19)-(22): `P V^g = P0 V0^g` down to `Pk`, then `P V^g' = Pk Vk^g'`. `Pk`
//! follows from the closure of Jones and Miller: the work of an infinite expansion is the heat of explosion,
//! `W Q = P0 V0/(g-1) - Pk Vk/(g-1) + Pk Vk/(g'-1)`.

use serde::{Deserialize, Serialize};

use crate::laws::jwl::{Isentrope, Jwl};

/// An explosive by the equation of state of its gas.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Products {
    /// A two-stage adiabat.
    TwoStage(Explosive),
    /// That of Jones, Wilkins and Lee.
    Jwl(Jwl),
}

impl From<Explosive> for Products {
    fn from(explosive: Explosive) -> Self {
        Self::TwoStage(explosive)
    }
}

impl Products {
    /// Density of the charge, kg/m³.
    #[must_use]
    pub fn density(&self) -> f64 {
        match self {
            Self::TwoStage(explosive) => explosive.density,
            Self::Jwl(jwl) => jwl.density,
        }
    }

    /// Velocity of detonation, m/s.
    #[must_use]
    pub fn detonation_velocity(&self) -> f64 {
        match self {
            Self::TwoStage(explosive) => explosive.detonation_velocity,
            Self::Jwl(jwl) => jwl.chapman_jouguet().velocity,
        }
    }

    /// Whether the constants make an adiabat.
    ///
    /// # Errors
    /// As [`Explosive::validate`]; constants that do not detonate.
    pub fn validate(&self) -> Result<(), ExplosiveError> {
        match self {
            Self::TwoStage(explosive) => explosive.validate(),
            Self::Jwl(jwl) => jwl.is_sound().then_some(()).ok_or(ExplosiveError::Jwl),
        }
    }

    /// The adiabat of a charge of `mass` (kg).
    ///
    /// # Errors
    /// As [`Products::validate`], and a mass that is not positive.
    pub fn adiabat(&self, mass: f64) -> Result<Adiabat, ExplosiveError> {
        match self {
            Self::TwoStage(explosive) => explosive.adiabat(mass).map(Adiabat::TwoStage),
            Self::Jwl(jwl) => {
                self.validate()?;
                positive("the mass of the charge", mass)?;
                Ok(Adiabat::Jwl(jwl.isentrope(mass / jwl.density)))
            }
        }
    }
}

/// Pressure of a fixed amount of gas as a function of its volume.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Adiabat {
    /// In two stages.
    TwoStage(TwoStage),
    /// Of Jones, Wilkins and Lee.
    Jwl(Isentrope),
}

impl Adiabat {
    /// Volume of the charge, m³.
    #[must_use]
    pub fn v0(&self) -> f64 {
        match self {
            Self::TwoStage(gas) => gas.v0,
            Self::Jwl(gas) => gas.v0,
        }
    }

    /// Pressure at `volume` (m³), Pa.
    #[must_use]
    pub fn pressure(&self, volume: f64) -> f64 {
        match self {
            Self::TwoStage(gas) => gas.pressure(volume),
            Self::Jwl(gas) => gas.pressure(volume),
        }
    }

    /// Exponent at `volume` (m³): the tangent bulk modulus of the gas is this times the pressure.
    #[must_use]
    pub fn exponent(&self, volume: f64) -> f64 {
        match self {
            Self::TwoStage(gas) => gas.exponent(volume),
            Self::Jwl(gas) => gas.exponent(volume),
        }
    }

    /// Work of the gas from the volume of the charge to `volume` (m³), the integral of `P dV`, J.
    #[must_use]
    pub fn work(&self, volume: f64) -> f64 {
        match self {
            Self::TwoStage(gas) => gas.work(volume),
            Self::Jwl(gas) => gas.work(volume),
        }
    }

    /// Work that is left at `volume` (m³) in an expansion without end: the internal energy of the gas, J.
    #[must_use]
    pub fn held(&self, volume: f64) -> f64 {
        self.held_at(volume, self.pressure(volume))
    }

    /// [`Adiabat::held`] where the pressure (Pa) is known.
    #[must_use]
    pub fn held_at(&self, volume: f64, pressure: f64) -> f64 {
        match self {
            Self::TwoStage(gas) => gas.held(volume, pressure),
            Self::Jwl(gas) => gas.held(volume),
        }
    }

    /// The integral of `dP/V` from an expansion without end to `volume` (m³), Pa/m³: times the mass it is the potential of a flow that friction
    /// resists (`crate::flow`).
    #[must_use]
    pub fn drive(&self, volume: f64) -> f64 {
        self.drive_at(volume, self.pressure(volume))
    }

    /// [`Adiabat::drive`] where the pressure (Pa) is known.
    #[must_use]
    pub fn drive_at(&self, volume: f64, pressure: f64) -> f64 {
        match self {
            Self::TwoStage(gas) => gas.drive(volume, pressure),
            Self::Jwl(gas) => gas.drive(volume),
        }
    }
}

fn positive(what: &'static str, value: f64) -> Result<(), ExplosiveError> {
    let fits = value.is_finite() && value > 0.0;
    if fits { Ok(()) } else { Err(ExplosiveError::NotPositive { what, value }) }
}

/// An explosive, with the constants of its two-stage adiabat.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Explosive {
    /// Density of the charge, kg/m³.
    pub density: f64,
    /// Velocity of detonation, m/s.
    pub detonation_velocity: f64,
    /// Heat of explosion, J/kg.
    pub heat: f64,
    /// Exponent above the transition pressure (3).
    pub gamma: f64,
    /// Exponent below it (4/3).
    pub gamma_low: f64,
}

/// What can be wrong with an explosive.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ExplosiveError {
    /// A number that is not positive or not finite.
    #[error("{what} is {value}; it must be above 0")]
    NotPositive {
        /// Which number.
        what: &'static str,
        /// Its value in SI units.
        value: f64,
    },
    /// Exponents in the wrong order.
    #[error(
        "the exponents are gamma = {gamma} and gamma_low = {gamma_low}; they must be gamma > gamma_low > 1"
    )]
    Exponents {
        /// Exponent at high pressure.
        gamma: f64,
        /// Exponent at low pressure.
        gamma_low: f64,
    },
    /// The heat does not fit density and velocity of detonation.
    #[error(
        "the heat of explosion is {heat:.4e} J/kg; with this density and detonation velocity it must be above {above:.4e} J/kg (otherwise the second \
         stage has no energy) and at most {at_most:.4e} J/kg (otherwise the transition pressure exceeds the initial pressure)"
    )]
    Heat {
        /// Heat given, J/kg.
        heat: f64,
        /// Lower bound (excluded), J/kg.
        above: f64,
        /// Upper bound (included), J/kg.
        at_most: f64,
    },
    /// Constants of an equation of state of Jones, Wilkins and Lee that do not detonate.
    #[error("the constants of the JWL equation of state have no state of Chapman and Jouguet")]
    Jwl,
}

impl Explosive {
    /// Initial pressure (21): half the Chapman-Jouguet pressure, `P0 = rho D²/(2 (g + 1))`, Pa.
    #[must_use]
    pub fn initial_pressure(&self) -> f64 {
        self.density * self.detonation_velocity * self.detonation_velocity
            / (2.0 * (self.gamma + 1.0))
    }

    /// Heats of explosion between which the closure has a meaning, J/kg: `P0/((g-1) rho) < Q <= P0/((g'-1) rho)`.
    #[must_use]
    pub fn heat_bounds(&self) -> (f64, f64) {
        let specific = self.initial_pressure() / self.density;
        (specific / (self.gamma - 1.0), specific / (self.gamma_low - 1.0))
    }

    /// Whether the constants make an adiabat.
    ///
    /// # Errors
    /// Numbers that are not positive, exponents out of order, a heat outside [`Explosive::heat_bounds`].
    pub fn validate(&self) -> Result<(), ExplosiveError> {
        for (what, value) in [
            ("the density of the explosive", self.density),
            ("the detonation velocity", self.detonation_velocity),
            ("the heat of explosion", self.heat),
        ] {
            positive(what, value)?;
        }
        let (gamma, gamma_low) = (self.gamma, self.gamma_low);
        if !(gamma.is_finite() && gamma > gamma_low && gamma_low > 1.0) {
            return Err(ExplosiveError::Exponents { gamma, gamma_low });
        }
        let (above, at_most) = self.heat_bounds();
        if !(self.heat > above && self.heat <= at_most) {
            return Err(ExplosiveError::Heat { heat: self.heat, above, at_most });
        }
        Ok(())
    }

    /// The adiabat of a charge of `mass` (kg).
    ///
    /// # Errors
    /// As [`Explosive::validate`], and a mass that is not positive.
    pub fn adiabat(&self, mass: f64) -> Result<TwoStage, ExplosiveError> {
        self.validate()?;
        positive("the mass of the charge", mass)?;
        let (g, low) = (self.gamma, self.gamma_low);
        let p0 = self.initial_pressure();
        // (22): Pk/P0 = { (g'-1)/(g-g') [ (g-1) rho Q/P0 - 1 ] }^(g/(g-1)), V0 = W/rho.
        let bracket = (g - 1.0) * self.density * self.heat / p0 - 1.0;
        let ratio = libm::pow((low - 1.0) / (g - low) * bracket, g / (g - 1.0));
        Ok(TwoStage {
            p0,
            v0: mass / self.density,
            pk: p0 * ratio,
            vk: mass / self.density * libm::pow(ratio, -1.0 / g),
            gamma: g,
            gamma_low: low,
        })
    }
}

/// A two-stage adiabat.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TwoStage {
    /// Initial pressure, Pa.
    pub p0: f64,
    /// Initial volume (that of the charge), m³.
    pub v0: f64,
    /// Pressure at the transition, Pa.
    pub pk: f64,
    /// Volume at the transition, m³.
    pub vk: f64,
    /// Exponent above the transition pressure.
    pub gamma: f64,
    /// Exponent below it.
    pub gamma_low: f64,
}

impl TwoStage {
    /// Pressure (19), (20) at `volume` (m³), Pa. Below `v0` the first branch goes on.
    #[must_use]
    pub fn pressure(&self, volume: f64) -> f64 {
        if volume <= self.vk {
            self.p0 * libm::pow(self.v0 / volume, self.gamma)
        } else {
            self.pk * libm::pow(self.vk / volume, self.gamma_low)
        }
    }

    /// Exponent of the branch at `volume` (m³): the tangent bulk modulus of the gas is this times the pressure.
    #[must_use]
    pub fn exponent(&self, volume: f64) -> f64 {
        if volume <= self.vk { self.gamma } else { self.gamma_low }
    }

    /// Work of the gas from `v0` to `volume` (m³), the integral of `P dV`, J; negative below `v0`.
    #[must_use]
    pub fn work(&self, volume: f64) -> f64 {
        let stage = |p: f64, from: f64, to: f64, g: f64| {
            // 1 - (from/to)^(g-1) without cancellation near from = to.
            -p * from / (g - 1.0) * libm::expm1((g - 1.0) * libm::log(from / to))
        };
        if volume <= self.vk {
            stage(self.p0, self.v0, volume, self.gamma)
        } else {
            stage(self.p0, self.v0, self.vk, self.gamma)
                + stage(self.pk, self.vk, volume, self.gamma_low)
        }
    }

    /// Work that is left at `volume` (m³), where the pressure (Pa) is known, in an expansion without end, J.
    fn held(&self, volume: f64, pressure: f64) -> f64 {
        let left = pressure * volume / (self.exponent(volume) - 1.0);
        if volume <= self.vk {
            let (g, low) = (self.gamma - 1.0, self.gamma_low - 1.0);
            left + self.pk * self.vk * (1.0 / low - 1.0 / g)
        } else {
            left
        }
    }

    /// The integral of `dP/V` from an expansion without end to `volume` (m³), where the pressure (Pa) is known, Pa/m³.
    fn drive(&self, volume: f64, pressure: f64) -> f64 {
        // Of P V^g = const: g/(g + 1) P/V.
        let share = |g: f64| g / (g + 1.0);
        let here = pressure / volume;
        if volume <= self.vk {
            let passed = self.pk / self.vk;
            share(self.gamma) * (here - passed) + share(self.gamma_low) * passed
        } else {
            share(self.gamma_low) * here
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AMMONIUM: Explosive = Explosive {
        density: 1000.0,
        detonation_velocity: 4000.0,
        heat: 4.18e6,
        gamma: 3.0,
        gamma_low: 4.0 / 3.0,
    };

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a / b - 1.0).abs() <= tolerance, "{a} {b}");
    }

    /// F1 of the verification catalogue, made by a separate program: `V/V0 = 10^(k/50)`, nine digits.
    const F1: &str = include_str!("../../../../scenes/verify/spatial/data/f1_gas_eos.csv");

    #[test]
    fn table_of_the_catalogue_to_all_its_digits() {
        let gas = AMMONIUM.adiabat(0.03).unwrap();
        let mut rows = 0;
        for (k, line) in F1.lines().skip(1).enumerate() {
            let (_, printed) = line.split_once(',').unwrap();
            let printed: f64 = printed.parse().unwrap();
            let pressure = gas.pressure(gas.v0 * 10f64.powf(k as f64 / 50.0));
            // Half a unit of the ninth digit, and the 1e-10 of the catalogue.
            let unit = 10f64.powf(printed.log10().floor() - 8.0);
            assert!(
                (pressure - printed).abs() <= 0.5 * unit + 1e-10 * printed,
                "{pressure} {printed}"
            );
            rows += 1;
        }
        assert_eq!(rows, 101);
    }

    #[test]
    fn values_of_the_catalogue() {
        let gas = AMMONIUM.adiabat(0.03).unwrap();
        near(gas.v0, 3e-5, 1e-15);
        near(gas.p0, 2e9, 1e-15);
        // By hand: the factor of (22) is 0.2 and the bracket 3.18.
        near(gas.pk, 2e9 * 0.636 * 0.636_f64.sqrt(), 1e-14);
        near(gas.pk, 1.014_42e9, 1e-5);
        near(gas.vk / gas.v0, 1.253_925, 1e-6);
        for (ratio, pressure) in [
            (1.5, 7.988_33e8),
            (2.0, 5.443_41e8),
            (3.0, 3.170_17e8),
            (5.0, 1.604_30e8),
            (10.0, 6.366_65e7),
        ] {
            // Six digits are printed.
            near(gas.pressure(ratio * gas.v0), pressure, 3.2e-6);
        }
        near(gas.pressure(100.0 * gas.v0), 2_955_136.81, 1e-8);
        near(gas.work(1e15 * gas.v0), 125_400.0, 1.1e-5);
        near(gas.work(10.0 * gas.v0), 0.543 * 125_400.0, 1e-3);
        near(gas.work(100.0 * gas.v0), 0.788 * 125_400.0, 1e-3);
        let weaker = Explosive { heat: 3.688e6, ..AMMONIUM };
        let gas = weaker.adiabat(8.0).unwrap();
        near(gas.pk, 7.8835e8, 1e-5);
        near(gas.vk / gas.v0, 1.363_862, 1e-6);
    }

    #[test]
    fn tnt_lies_in_the_textbook_range() {
        let tnt =
            Explosive { density: 1630.0, detonation_velocity: 6930.0, heat: 4.52e6, ..AMMONIUM };
        let gas = tnt.adiabat(1.0).unwrap();
        near(gas.pk, 315e6, 5e-3);
        assert!((3.135..3.145).contains(&(gas.vk / gas.v0)));
    }

    #[test]
    fn work_is_the_integral_of_the_pressure() {
        let gas = AMMONIUM.adiabat(2.0).unwrap();
        // Simpson's rule in log V, on both sides of the transition and across it.
        for (from, to) in [(0.5, 1.0), (1.0, 1.2), (1.26, 40.0), (0.8, 1.253_925_4)] {
            let n = 4000;
            let (a, b) = (f64::ln(from), f64::ln(to));
            let h = (b - a) / f64::from(n);
            let f = |k: i32| {
                let v = gas.v0 * f64::exp(a + h * f64::from(k));
                gas.pressure(v) * v
            };
            let sum: f64 = (0..n).step_by(2).map(|k| f(k) + 4.0 * f(k + 1) + f(k + 2)).sum();
            let work = gas.work(to * gas.v0) - gas.work(from * gas.v0);
            near(work, sum * h / 3.0, 1e-6);
        }
        near(gas.pressure(gas.vk), gas.pk, 1e-14);
        near(gas.pressure(gas.vk * (1.0 + 1e-14)), gas.pk, 1e-12);
        assert_eq!(gas.work(gas.v0), 0.0);
    }

    #[test]
    fn what_is_held_is_the_rest_of_the_work_and_the_drive_an_integral() {
        let jwl = Products::Jwl(Jwl::ANFO).adiabat(2.0).unwrap();
        let two = Products::TwoStage(AMMONIUM).adiabat(2.0).unwrap();
        // All of the heat of explosion is work in an expansion without end.
        near(two.held(two.v0()), 2.0 * AMMONIUM.heat, 1e-12);
        for gas in [two, jwl] {
            let v0 = gas.v0();
            for (from, to) in [(0.9, 1.1), (1.1, 2.0), (0.7, 30.0)] {
                let done = gas.work(to * v0) - gas.work(from * v0);
                near(gas.held(from * v0) - gas.held(to * v0), done, 1e-10);
                // By the trapezoid in the pressure, of second order.
                let n = 20_000;
                let at = |k: i32| v0 * from * (to / from).powf(f64::from(k) / f64::from(n));
                let sum: f64 = (0..n)
                    .map(|k| {
                        let [a, b] = [at(k), at(k + 1)];
                        0.5 * (1.0 / a + 1.0 / b) * (gas.pressure(a) - gas.pressure(b))
                    })
                    .sum();
                near(gas.drive(from * v0) - gas.drive(to * v0), sum, 1e-6);
            }
        }
    }

    #[test]
    fn a_heat_out_of_bounds_names_both_bounds() {
        for heat in [1.0e6, 0.5e6, 6.1e6] {
            let text = Explosive { heat, ..AMMONIUM }.validate().unwrap_err().to_string();
            assert!(text.contains("1.0000e6") && text.contains("6.0000e6"), "{text}");
        }
        assert_eq!(Explosive { heat: 5.999_999e6, ..AMMONIUM }.validate(), Ok(()));
        assert!(Explosive { gamma: 1.2, ..AMMONIUM }.validate().is_err());
        assert!(AMMONIUM.adiabat(f64::NAN).is_err());
    }
}
