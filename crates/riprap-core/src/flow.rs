//! Flow of gas through a network of cracks, with the mass in each of them as the state.
//!
//! A cell is a crack (area `A`, aperture `w`, volume `V`, mass `m`) or a cavity. Cells meet in junctions without volume: lines along which cracks meet or
//! end. With the potential `Psi(rho) = int rho dp` the mass flux `G = rho v` between the middle of a cell and a junction at a distance `d` obeys
//!
//! ```text
//!     -grad Psi = 12 mu/w^2 G + f/w G |G|        f = 0.1 (e/w)^0.5, |G| <= rho c of the cell that it leaves
//! ```
//!
//! for every law p(rho): laminar flow between plates, fast flow between rough ones, and flow that has reached the velocity of sound `c`. The potential of
//! a junction is that for which its fluxes add up to nothing. A step is backward Euler in the masses, solved by Newton's method on
//!
//! ```text
//!     R = m - m_old + dt (sum of what flows out),      (1 + dt S^1/2 L S^1/2) y = -S^1/2 R,      dm = -R - dt L S^1/2 y
//! ```
//!
//! `S = (dPsi/drho)/V`, `L` the symmetric matrix of the tangents with junctions eliminated; by conjugate gradients. Dry cells need no case of their own
//! (`S = 0`: the row is that of the unit matrix), and since `dm` is made of fluxes a closed network keeps its mass to round-off whatever the tolerances.
//!
//! With inertia backward Euler adds `rho/dt (G - G_old)` to the right of this law, with the density at the start of the step; it stays monotone. Without it the flux follows its gradient at once, and wide cracks become even within a step, for which Newton's method and the conjugate
//! gradients need hundreds of turns.
//!
//! Deviation: what the gas carries along of its momentum (`div G v`) is left out, and its kinetic energy is told as friction. The path from the middle of a cell
//! to a junction is the distance from the line: exact for rectangles; in random triangles about 3 % too much flows, in parallelograms of 60 degrees 33 %.
//!
//! Sources: cubic law as in [`crate::laws::seepage`]; friction of fast flow in the form of Nilson, Proffer & Duff (1985), Int. J. Rock Mech. 22, 3-19, whose
//! coefficient and exponent are constants that can be set; elimination of junctions, limits and order of solution are ours.

mod fluid;
mod junction;
mod rows;
mod solve;
mod stage;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

use crate::exec::Exec;

pub use fluid::Fluid;
pub use solve::Desk;

/// Parts of a step that did not converge are halved at most so often.
const MOST_HALVINGS: u32 = 10;

/// What holds at a junction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum End {
    /// What comes in goes out.
    Inside,
    /// It has the potential of a cell, a cavity; as inside while that cell has no volume.
    Cell(u32),
    /// Open to the air: gas flows out, never in.
    Air,
}

/// Where a crack reaches a junction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Port {
    /// The crack.
    pub cell: u32,
    /// Length of the junction, m.
    pub length: f64,
    /// Distance of the middle of the crack from the line of the junction, m.
    pub path: f64,
}

/// Cracks, cavities and the junctions between them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Network {
    /// Number of cells.
    pub cells: u32,
    /// What holds at each junction.
    pub ends: Vec<End>,
    /// Ports of junction `j`: `first[j]` to `first[j + 1]`.
    pub first: Vec<u32>,
    /// See there.
    pub ports: Vec<Port>,
}

/// Friction of flow between two walls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Friction {
    /// Viscosity of the gas, Pa s.
    pub viscosity: f64,
    /// Roughness e of the walls, m; 0: laminar at any speed, without inertia beyond that of sound, too.
    pub roughness: f64,
    /// Whether the gas has inertia.
    pub inertia: bool,
}

/// Coefficient of the friction of fast flow; its exponent, of roughness over aperture, is 1/2.
const ROUGH: f64 = 0.1;

impl Friction {
    /// `12 mu/w^2` (Pa s/m²) and `f/w` (1/m) at an aperture (m).
    fn at(&self, w: f64) -> [f64; 2] {
        let rough = ROUGH * (self.roughness / w).sqrt();
        [12.0 * self.viscosity / (w * w), rough / w]
    }
}

/// The cells of a network in a step.
#[derive(Debug)]
pub struct Cells<'a> {
    /// Volumes, m³.
    pub volumes: &'a [f64],
    /// Hydraulic apertures, m; 0 where nothing flows. Not used for cavities.
    pub apertures: &'a [f64],
    /// Masses, kg.
    pub masses: &'a mut [f64],
    /// Mass flux out of its crack through each port at the end of the last step, kg/(m² s).
    pub fluxes: &'a mut [f64],
}

/// What has flowed in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flowed {
    /// Mass that has left into the air, kg.
    pub vented: f64,
    /// Energy that it has taken along, its flow work included, J.
    pub carried: f64,
    /// Energy lost by friction of flow, J.
    pub friction: f64,
    /// Energy lost by backward Euler, J: never below 0, of first order in the step.
    pub numerical: f64,
}

/// A step that did not converge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stuck {
    /// The cell that is farthest out of balance.
    pub cell: u32,
    /// By how much, over what it holds and what flows through it in the step.
    pub left: f64,
}

impl Network {
    /// Lets gas flow for `dt` (s) against air of this pressure (Pa). A step that does not converge is made in two halves.
    ///
    /// # Errors
    /// The worst cell of a part of the step that is short and does not converge; masses are what they were before the step.
    pub fn advance(
        &self,
        fluid: &Fluid,
        (friction, air): (&Friction, f64),
        cells: &mut Cells,
        dt: f64,
        (exec, desk): (&Exec, &mut Desk),
    ) -> Result<Flowed, Stuck> {
        let (mut done, mut part, mut all) = (0.0, 1.0, Flowed::default());
        let shortest = 1.0 / (1_u64 << MOST_HALVINGS) as f64;
        desk.prepare(self, friction, cells);
        let air = [air, fluid.density(air)];
        while done < 1.0 {
            match solve::step(self, fluid, air[1], cells, part * dt, (exec, desk)) {
                Ok(()) => {
                    desk.book(exec, fluid, air, (cells, &mut all));
                    done += part;
                }
                Err(stuck) => {
                    desk.restore_masses(cells);
                    if part == 1.0 {
                        desk.start.keep(cells);
                    }
                    part *= 0.5;
                    if part < shortest {
                        desk.start.restore(cells);
                        return Err(stuck);
                    }
                }
            }
        }
        Ok(all)
    }
}
