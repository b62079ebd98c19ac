//! What the gas of charges in cracks is and remembers: plain data, part of a checkpoint.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::flow::{Fluid, Network};
use crate::setup::Cracks;

/// Joints that gas may enter, with the gas in them and in its cavities.
///
/// Cells of the network are the cracks, then the cavities.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CrackGas {
    /// The gas.
    pub fluid: Fluid,
    /// How it flows.
    pub rules: Cracks,
    /// Joints and the lines along which they meet.
    pub network: Network,
    /// Joints between living blocks, by pairs of blocks, ascending.
    pub cracks: Vec<Crack>,
    /// Cavities whose gas may leave, as numbers in `World::cavities`.
    pub cavities: Vec<u32>,
    /// Mass of the gas in each cell, kg.
    pub masses: Vec<f64>,
    /// Flux through each port of the network when gas flowed last, kg/(m² s).
    pub fluxes: Vec<f64>,
    /// Numbers of joints, and of those that had failed, when cracks were opened last.
    pub failed: [usize; 2],
    /// Steps of the rock between two of the flow, and those that have passed since the last.
    pub every: u32,
    /// See there.
    pub passed: u32,
    /// Time since then, s.
    pub waits: f64,
    /// Largest step that it allowed then, s; 0 before it is found.
    pub limit: f64,
    /// Numbers of blocks and of living ones for which it was built.
    pub blocks: [usize; 2],
    /// Where the energy of the gas has gone.
    pub books: GasBooks,
    /// The blocks of a crack (of a cavity: its number, twice) where the flow was not found, and what is left there over what flows.
    pub stuck: Option<([u32; 2], f64)>,
}

/// A joint that gas may enter once it has failed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crack {
    /// The blocks on its sides; the smaller number first.
    pub blocks: [u32; 2],
    /// Corners at the start, anticlockwise about the outward normal of the first block, local, m.
    pub outline: Vec<Vec3>,
    /// Centroid, m.
    pub centre: Vec3,
    /// Outward normal of the first block.
    pub normal: Vec3,
    /// Area, m².
    pub area: f64,
    /// Whether gas may enter.
    pub open: bool,
    /// Whether its sides have gone so far from each other that it encloses nothing any more.
    pub gone: bool,
    /// Displacement of its second side against the first, m, at the last evaluation.
    pub jump: Vec3,
    /// How far that has moved since the evaluation before it, m; nothing once its work is booked.
    pub moved: Vec3,
    /// Volume, m³, at the last evaluation.
    pub volume: f64,
    /// Hydraulic aperture then, m.
    pub aperture: f64,
    /// Pressure then, Pa.
    pub pressure: f64,
    /// Density (kg/m³), pressure and bulk modulus (Pa) at which the pressure was found last; nothing where it was not found yet.
    pub known: [f64; 3],
    /// Force on its second block then, N: of the pressure above that of the air.
    pub push: Vec3,
    /// Largest speed of the flow then, m/s.
    pub speed: f64,
}

/// Where the energy of gas that enters cracks has gone, J; its mass, kg.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GasBooks {
    /// Energy of the charges that have gone off.
    pub released: f64,
    /// Their mass.
    pub mass: f64,
    /// Work on the rock, by walls and by cracks.
    pub work: f64,
    /// The part of it in cracks.
    pub in_cracks: f64,
    /// Work against the air.
    pub air: f64,
    /// Work on columns of stemming, the air before them included.
    pub stemming: f64,
    /// Friction of the flow.
    pub friction: f64,
    /// What backward Euler loses in the flow, and what new gas loses that mixes with gas that has expanded.
    pub numerical: f64,
    /// Taken along by what has left.
    pub carried: f64,
    /// Mass that has left.
    pub vented: f64,
}

impl CrackGas {
    /// The cell of a cavity, by its number in `World::cavities`.
    #[must_use]
    pub fn cell_of_cavity(&self, cavity: usize) -> Option<usize> {
        let place = self.cavities.iter().position(|k| *k as usize == cavity)?;
        Some(self.cracks.len() + place)
    }

    /// Mass of the gas in all cracks, kg.
    #[must_use]
    pub fn in_cracks(&self) -> f64 {
        self.masses[..self.cracks.len()].iter().sum()
    }
}
