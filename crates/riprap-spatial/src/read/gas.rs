//! The gas of charges in cracks, in numbers.

use crate::query::view::View;
use crate::state::cavity::Cavity;
use crate::state::gas::{CrackGas, GasBooks};

impl View<'_> {
    fn gas(&self) -> Option<&CrackGas> {
        self.world.gas.as_deref()
    }

    /// Where the energy of gas that enters cracks has gone.
    #[must_use]
    pub fn gas_books(&self) -> GasBooks {
        self.gas().map_or_else(GasBooks::default, |gas| gas.books)
    }

    /// Mass of the gas in a cavity, kg; NaN for a pressure history.
    #[must_use]
    pub fn gas_mass(&self, cavity: &Cavity) -> f64 {
        let charge = self.world.charge_mass(cavity);
        charge.map_or(f64::NAN, |mass| cavity.kept * mass)
    }

    /// Energy left in the gas that may enter cracks, J.
    #[must_use]
    pub fn gas_internal(&self) -> f64 {
        let Some(gas) = self.gas() else { return 0.0 };
        let in_cavities = gas.cavities.iter().map(|k| self.world.cavities[*k as usize].volume);
        let volumes = gas.cracks.iter().map(|c| c.volume).chain(in_cavities);
        let cells = gas.masses.iter().zip(volumes).filter(|(m, _)| **m > 0.0);
        // A sum of nothing is -0.
        cells.map(|(m, volume)| m * gas.fluid.energy(m / volume)).fold(0.0, |sum, e| sum + e)
    }

    /// Energy of this gas that its books do not explain, over the energy released.
    #[must_use]
    pub fn gas_residual(&self) -> f64 {
        let b = self.gas_books();
        let gone = b.work + b.air + b.stemming + b.friction + b.numerical + b.carried;
        if b.released > 0.0 { (b.released - self.gas_internal() - gone) / b.released } else { 0.0 }
    }

    /// Number of cracks with gas in them.
    #[must_use]
    pub fn gas_cracks(&self) -> usize {
        let gas = self.gas();
        gas.map_or(0, |gas| gas.masses[..gas.cracks.len()].iter().filter(|m| **m > 0.0).count())
    }

    /// Largest distance from the centre of the nearest charge at which a crack holds gas above the pressure of the air, m.
    #[must_use]
    pub fn gas_reach(&self) -> f64 {
        let Some(gas) = self.gas() else { return 0.0 };
        let cavities = gas.cavities.iter().map(|k| &self.world.cavities[*k as usize]);
        let centres: Vec<_> = cavities.map(|c| self.charge_centre(c)).collect();
        let filled = gas.cracks.iter().filter(|c| c.pressure > gas.rules.air);
        let distance = |at| centres.iter().map(|c| c.distance(at)).fold(f64::INFINITY, f64::min);
        filled.map(|c| distance(c.centre)).fold(0.0, f64::max)
    }

    /// Where the flow of gas was not found, and what is left there over what flows.
    #[must_use]
    pub fn stuck_gas(&self) -> Option<(String, f64)> {
        let (blocks, left) = self.gas()?.stuck?;
        let [a, b] = blocks.map(|b| b as usize);
        if a != b {
            let names = [a, b].map(|b| self.world.name(b));
            return Some((format!("the crack between `{}` and `{}`", names[0], names[1]), left));
        }
        let cavity = self.world.cavities.get(*self.gas()?.cavities.get(a)? as usize)?;
        let source = &self.world.setup.sources[cavity.source as usize];
        Some((format!("the cavity of `{}`", source.name), left))
    }
}
