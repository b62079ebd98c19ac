//! A step in numbers, and the state of a cell in it.

use super::{End, Fluid, Network, Port};
use crate::exec::Exec;

/// What flow and matrix need of a cell; zeros where there is no gas.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct State {
    /// Potential, Pa kg/m³.
    pub potential: f64,
    /// `rho c`, kg/(m² s).
    pub sound: f64,
    /// Root of `(dPsi/drho)/V`.
    pub root: f64,
    /// Pressure, Pa.
    pub pressure: f64,
}

impl State {
    /// That of a mass (kg) in a volume (m³); `limited`: nothing flows faster than sound.
    pub(super) fn of(fluid: &Fluid, (mass, volume): (f64, f64), limited: bool) -> Self {
        if mass <= 0.0 || volume <= 0.0 {
            return Self::default();
        }
        let density = mass / volume;
        let [pressure, potential, bulk] = fluid.look(density);
        let sound = if limited { (density * bulk).sqrt() } else { f64::INFINITY };
        Self { potential, sound, root: (bulk / volume).sqrt(), pressure }
    }
}

/// A step in numbers.
pub(super) struct Step<'a> {
    pub exec: &'a Exec,
    pub network: &'a Network,
    /// Potential of the air.
    pub air: f64,
    pub dt: f64,
    pub volumes: &'a [f64],
    pub apertures: &'a [f64],
}

impl Step<'_> {
    /// The cell whose potential a junction has.
    pub(super) fn holder(&self, junction: u32) -> Option<usize> {
        match self.network.ends[junction as usize] {
            End::Cell(c) if self.volumes[c as usize] > 0.0 => Some(c as usize),
            End::Cell(_) | End::Inside | End::Air => None,
        }
    }

    /// Length of a junction times aperture at a port, m².
    pub(super) fn section(&self, port: usize) -> f64 {
        let Port { cell, length, .. } = self.network.ports[port];
        length * self.apertures[cell as usize]
    }
}
