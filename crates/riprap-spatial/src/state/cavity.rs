//! State of charges and other pressures inside the rock.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::explosive::Adiabat;

/// A cavity and what pushes in it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cavity {
    /// Index into `Setup::sources`.
    pub source: u16,
    /// Blocks that were removed.
    pub blocks: Vec<u32>,
    /// Their volume Vc, m³.
    pub removed: f64,
    /// Walls, sorted by block.
    pub walls: Vec<Wall>,
    /// The gas, for charges.
    pub gas: Option<Gas>,
    /// Time of ignition once it has gone off, s.
    pub ignited: Option<f64>,
    /// Time at which the gas began to escape, s.
    pub venting: Option<f64>,
    /// Swept volume `sum A n.u` at which the volume is the one at the start, m³.
    pub base: f64,
    /// Volume of the gas (of the cavity, for a pressure history) now, m³.
    pub volume: f64,
    /// Pressure now, Pa.
    pub pressure: f64,
    /// Share of the charge that is gas in the cavity: less than 1 before all of it has burned, and where gas has left.
    pub kept: f64,
    /// Volume, what has burned and the way of stemming left out, for which works were booked last, m³.
    pub known: f64,
    /// Work done since the ignition, J.
    pub work: f64,
    /// Work of the in-situ tractions before the ignition, J.
    pub held: f64,
    /// Blocks at the free surface above, for venting by heave.
    pub above: Vec<u32>,
    /// Walls on deformable blocks.
    pub nodal: NodalWalls,
    /// The detonation, where it takes its time.
    pub burn: Option<Burn>,
    /// The column of stemming that the gas may blow out.
    pub column: Option<Column>,
}

/// A detonation on its way along a charge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Burn {
    /// Times after the ignition at which it is at the ends of the charge, s.
    pub ends: [f64; 2],
    /// Time since the ignition, s; below 0 before it.
    pub reached: f64,
    /// Share of the charge that has become gas in the cavity.
    pub given: f64,
}

impl Burn {
    /// Share of the charge that has burned.
    #[must_use]
    pub fn share(&self) -> f64 {
        let [a, b] = self.ends;
        let t = self.reached.max(0.0);
        if t >= a.max(b) { 1.0 } else { (t.min(a) + t.min(b)) / (a + b) }
    }
}

/// A column of stemming on its way out of the hole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// How far it has moved, m.
    pub way: f64,
    /// What of it is not booked yet, m; nothing after an evaluation.
    pub passed: f64,
    /// m/s, outwards.
    pub speed: f64,
    /// m/s², at the last evaluation.
    pub acceleration: f64,
    /// Time at which its foot came to the collar, s.
    pub out: Option<f64>,
    /// Work that the gas has done on it, J.
    pub work: f64,
    /// Heat of its friction, J.
    pub friction: f64,
    /// Mass of the gas that has left through the open hole, kg.
    pub vented: f64,
}

/// Gas of a charge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gas {
    /// Pressure over volume.
    pub adiabat: Adiabat,
    /// Volume at the ignition, m³.
    pub start: f64,
    /// Factor on the faces.
    pub factor: f64,
}

/// A face that a removed block shared with one that stays, or a part of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// Block that is pushed.
    pub block: u32,
    /// The removed block behind the face.
    pub behind: u32,
    /// Unit outward normal of the block, into the cavity, at the start.
    pub normal: Vec3,
    /// Area, m².
    pub area: f64,
    /// Centre from the centroid of the block at the start, m.
    pub arm: Vec3,
    /// Force that the removed block carried at the start, N.
    pub hold: Vec3,
    /// Moment of the same about the centroid, N m.
    pub hold_moment: Vec3,
    /// Where it has got to once its block uses finite rotations.
    pub turned: Option<TurnedWall>,
    /// Time from the ignition until the detonation is at its centre, s.
    pub after: f64,
}

/// A wall that turns with its block, at the last evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TurnedWall {
    /// Unit outward normal of the block.
    pub normal: Vec3,
    /// Area that the gas still finds, m²: less than that of the wall where it has turned away.
    pub area: f64,
    /// Displacement of its centre, m.
    pub displacement: Vec3,
    /// Volume that it has swept since the start, m³.
    pub swept: f64,
}

/// Walls of a cavity on deformable blocks, in sum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct NodalWalls {
    /// Area, m².
    pub area: f64,
    /// Sum of `A_i²/m_i` over the nodes, with the masses of dynamic phases, m⁴/kg.
    pub mobility: f64,
    /// Volume that they had swept when they were last made anew, m³.
    pub swept: f64,
    /// Work of their in-situ tractions until then, J.
    pub held: f64,
}
