//! The gas of a charge by its density.

use serde::{Deserialize, Serialize};

use crate::laws::explosive::Adiabat;

/// Density below which there is no gas, kg/m³.
const NOTHING: f64 = 1e-30;
/// Halvings of the search for a throat.
const HALVINGS: usize = 50;
/// Turns of the search for a density.
const SEARCH: usize = 200;

/// A gas on its adiabat: all of its numbers follow from its density.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fluid {
    /// Pressure of the charge over its volume.
    pub adiabat: Adiabat,
    /// Its mass, kg.
    pub mass: f64,
}

impl Fluid {
    /// Pressure at a density (kg/m³), Pa.
    #[must_use]
    pub fn pressure(&self, density: f64) -> f64 {
        if density > NOTHING { self.adiabat.pressure(self.mass / density) } else { 0.0 }
    }

    /// The potential `int rho dp` at a density (kg/m³), Pa kg/m³.
    #[must_use]
    pub fn potential(&self, density: f64) -> f64 {
        if density > NOTHING { self.mass * self.adiabat.drive(self.mass / density) } else { 0.0 }
    }

    /// Its slope `dPsi/drho = rho c²` at a density (kg/m³): the bulk modulus, Pa.
    #[must_use]
    pub fn bulk(&self, density: f64) -> f64 {
        self.stiffness(density)[1]
    }

    /// Pressure (Pa), potential and its slope ([`Fluid::potential`], [`Fluid::bulk`]) at a density (kg/m³).
    #[must_use]
    pub fn look(&self, density: f64) -> [f64; 3] {
        if density <= NOTHING {
            return [0.0; 3];
        }
        let [pressure, bulk] = self.stiffness(density);
        [pressure, self.mass * self.adiabat.drive_at(self.mass / density, pressure), bulk]
    }

    /// Pressure and bulk modulus ([`Fluid::pressure`], [`Fluid::bulk`]) at a density (kg/m³), Pa.
    #[must_use]
    pub fn stiffness(&self, density: f64) -> [f64; 2] {
        if density <= NOTHING {
            return [0.0; 2];
        }
        let volume = self.mass / density;
        let pressure = self.adiabat.pressure(volume);
        [pressure, self.adiabat.exponent(volume) * pressure]
    }

    /// Internal energy and enthalpy ([`Fluid::energy`], [`Fluid::enthalpy`]) at a density (kg/m³), J/kg, and the pressure, Pa.
    #[must_use]
    pub fn energies(&self, density: f64) -> [f64; 3] {
        if density <= NOTHING || density.is_nan() {
            return [0.0; 3];
        }
        let pressure = self.adiabat.pressure(self.mass / density);
        let energy = self.energy_at(density, pressure);
        [energy, energy + pressure / density, pressure]
    }

    /// [`Fluid::bulk`] where the pressure (Pa) is known.
    #[must_use]
    pub fn bulk_at(&self, density: f64, pressure: f64) -> f64 {
        if density > NOTHING { self.adiabat.exponent(self.mass / density) * pressure } else { 0.0 }
    }

    /// [`Fluid::energy`] where the pressure (Pa) is known.
    #[must_use]
    pub fn energy_at(&self, density: f64, pressure: f64) -> f64 {
        if density <= NOTHING {
            return 0.0;
        }
        self.adiabat.held_at(self.mass / density, pressure) / self.mass
    }

    /// Internal energy at a density (kg/m³), J/kg: the work that is left in an expansion without end.
    #[must_use]
    pub fn energy(&self, density: f64) -> f64 {
        if density > NOTHING { self.adiabat.held(self.mass / density) / self.mass } else { 0.0 }
    }

    /// Enthalpy `e + p/rho` at a density (kg/m³), J/kg.
    #[must_use]
    pub fn enthalpy(&self, density: f64) -> f64 {
        if density > NOTHING {
            self.energy(density) + self.pressure(density) / density
        } else {
            0.0
        }
    }

    /// Mass flux through the throat of a nozzle from gas at rest at a density (kg/m³) into air of this pressure (Pa), without friction, kg/(m² s): the largest
    /// of `rho sqrt(2 (h0 - h))`, which is where the speed is that of sound, or that at the pressure of the air.
    #[must_use]
    pub fn nozzle(&self, density: f64, air: f64) -> f64 {
        if self.pressure(density) <= air {
            return 0.0;
        }
        let start = self.enthalpy(density);
        let flux = |rho: f64| rho * (2.0 * (start - self.enthalpy(rho)).max(0.0)).sqrt();
        // Above the throat the gas is slower than sound.
        let slow = |rho: f64| {
            let square = 2.0 * (start - self.enthalpy(rho));
            square < self.bulk(rho) / rho
        };
        let (mut low, mut high) = (0.0, density);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if slow(middle) { high = middle } else { low = middle }
        }
        flux(if air > 0.0 { high.max(self.density(air)) } else { high })
    }

    /// Density at a pressure (Pa), kg/m³.
    #[must_use]
    pub fn density(&self, pressure: f64) -> f64 {
        if pressure <= 0.0 {
            return 0.0;
        }
        // The pressure grows with the density, by less than its tenth power and more than its first.
        let mut density = self.mass / self.adiabat.v0();
        for _ in 0..SEARCH {
            let here = self.pressure(density);
            let off = libm::log(pressure / here);
            density *= libm::exp(off / self.adiabat.exponent(self.mass / density));
            if off.abs() <= 4.0 * f64::EPSILON {
                break;
            }
        }
        density
    }
}
