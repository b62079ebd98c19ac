//! The gas of a charge by its density.

use serde::{Deserialize, Serialize};

use crate::laws::explosive::Adiabat;

/// Density below which there is no gas, kg/m³.
const NOTHING: f64 = 1e-30;
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
        if density > NOTHING {
            let volume = self.mass / density;
            self.adiabat.exponent(volume) * self.adiabat.pressure(volume)
        } else {
            0.0
        }
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
