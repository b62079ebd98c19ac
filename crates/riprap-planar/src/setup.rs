//! What the 2D engine is built from: plain SI data, no behaviour.
//!
//! Written by `model`, kept in checkpoints. Everything is per metre of thickness, so a force is in
//! N/m, a moment in N (N m per m), an energy in J/m; `thickness` alone says of how thick a slice results are told. x points right, y up; angles are radians,
//! anticlockwise.

use riprap_geom::Vec2;
use serde::{Deserialize, Serialize};

use crate::accounts::Condition;
use crate::dynamics::TimeFunction;
use crate::dynamics::kick::Target;
pub use crate::laws::bolt::Design;
pub use crate::laws::in_situ::InSitu;
pub use crate::laws::mohr_coulomb::Strength;
pub use crate::laws::parameters::{BondLaw, ContactLaw, FrictionLaw, NormalLaw, Reflex};
pub use crate::laws::water::WaterTable;

/// A complete 2D model at its start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Setup {
    /// Acceleration of gravity, m/s².
    pub gravity: [f64; 2],
    /// Global position of the local origin that all coordinates here are relative to, m.
    ///
    /// Far coordinates (UTM) are shifted before the engine sees them; records add this back.
    pub origin: [f64; 2],
    /// Names of the materials; a block's `material` is an index into this list.
    pub materials: Vec<String>,
    /// Their densities, kg/m³, for blocks that are added while the model runs; shorter or empty where nobody adds any.
    pub densities: Vec<f64>,
    /// The blocks, in scenario order.
    pub blocks: Vec<BlockSpec>,
    /// Angle of each block at the start against the outline that the scene draws, rad; empty where a table of states turned none.
    pub angles: Vec<f64>,
    /// Moments of inertia of blocks that do not have that of their shape, kg m.
    pub inertias: Vec<(u32, f64)>,
    /// Contact and bond laws.
    pub interfaces: Vec<Interface>,
    /// Row of `interfaces` for materials (a, b), at `a * materials.len() + b`; symmetric.
    pub pair_table: Vec<u16>,
    /// Fixed and driven blocks; a later entry wins over an earlier one for the same block.
    pub supports: Vec<Support>,
    /// External loads.
    pub loads: Vec<Load>,
    /// Stress that all joints carry at the start.
    pub in_situ: Option<InSitu>,
    /// Named sets of blocks, each sorted.
    pub groups: Vec<Group>,
    /// Water tables, of which one at a time stands ([`World::water`](super::world::World::water)).
    pub water: Vec<WaterTable>,
    /// Bolts; phases install them.
    pub bolts: Vec<Bolt>,
    /// Boundaries, supports and loads whose work is told.
    pub accounts: Vec<Condition>,
    /// Thickness of the slice that results are of, m; `None` tells them per metre.
    pub thickness: Option<f64>,
}

impl Setup {
    /// What results per metre of thickness are multiplied by when they are told.
    #[must_use]
    pub fn slice(&self) -> f64 {
        self.thickness.unwrap_or(1.0)
    }
}

/// A bolt, from its head into the rock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bolt {
    /// Name used in the scenario, with a number for those of a pattern.
    pub name: String,
    /// Head, m.
    pub head: Vec2,
    /// Toe, m.
    pub toe: Vec2,
    /// What it is made of, per metre of thickness.
    pub design: Design,
    /// Distance of such bolts out of the plane, m.
    pub spacing: f64,
}

/// A named set of blocks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Name used in the scenario.
    pub name: String,
    /// Indices of the blocks, ascending.
    pub blocks: Vec<u32>,
}

/// One rigid polygon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BlockSpec {
    /// Unique name.
    pub name: String,
    /// Corners, anticlockwise, m.
    pub vertices: Vec<Vec2>,
    /// Index into `Setup::materials`.
    pub material: u16,
    /// Mass over area, kg/m³: the density of the material, or that of a given mass.
    pub density: f64,
    /// Initial velocity of the centroid, m/s.
    pub velocity: Vec2,
    /// Initial angular velocity, rad/s.
    pub spin: f64,
}

/// Laws between two materials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interface {
    /// Name used in the scenario.
    pub name: String,
    /// Law of contacts found from geometry.
    pub contact: ContactLaw,
    /// Law of the patches built along edges shared at the start; `None` builds none.
    pub bond: Option<BondLaw>,
}

/// Fixes or drives some blocks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Support {
    /// Blocks concerned.
    pub blocks: Vec<u32>,
    /// What they do.
    pub motion: Motion,
}

/// Prescribed motion of a block, by component; a component that is not prescribed is free.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// Held still in the chosen freedoms.
    Fixed {
        /// Horizontal.
        x: bool,
        /// Vertical.
        y: bool,
        /// Rotation.
        rotation: bool,
    },
    /// Velocity of the centroid (m/s) and spin (rad/s) as functions of time.
    Velocity {
        /// Horizontal, m/s.
        x: Option<TimeFunction>,
        /// Vertical, m/s.
        y: Option<TimeFunction>,
        /// Angular, rad/s.
        spin: Option<TimeFunction>,
        /// Point (local, m) about which the spin turns all blocks of the support as one body, and of which x and y are the velocity; without
        /// one each turns about its own centroid.
        about: Option<Vec2>,
    },
    /// Acceleration of the centroid (m/s²) and of rotation (rad/s²) as functions of time.
    Acceleration {
        /// Horizontal, m/s².
        x: Option<TimeFunction>,
        /// Vertical, m/s².
        y: Option<TimeFunction>,
        /// Angular, rad/s².
        spin: Option<TimeFunction>,
    },
}

impl Motion {
    /// Whether it moves blocks, rather than holding them.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        match self {
            Self::Fixed { .. } => false,
            Self::Velocity { .. } | Self::Acceleration { .. } => true,
        }
    }
}

impl Motion {
    /// What is prescribed along x, along y and for rotation.
    #[must_use]
    pub fn targets(&self) -> [Target<'_>; 3] {
        match self {
            Self::Fixed { x, y, rotation } => [*x, *y, *rotation].map(Target::held),
            Self::Velocity { x, y, spin, .. } => [x, y, spin].map(|f| Target::velocity(f.as_ref())),
            Self::Acceleration { x, y, spin } => {
                [x, y, spin].map(|f| Target::acceleration(f.as_ref()))
            }
        }
    }

    /// Velocity (m/s) beside that of x and y of a block that turns about a point with others, as one body: along the chord of its step of
    /// `dt` (s) from `time` (s) on, so that it stays on its circle. `centroid` (m) is that of the start, `angle` (rad) its rotation since.
    #[must_use]
    pub fn swing(&self, centroid: Vec2, angle: f64, time: f64, dt: f64) -> Vec2 {
        let (spin, about) = match self {
            Self::Velocity { spin: Some(spin), about: Some(about), .. } => (spin, *about),
            Self::Fixed { .. } | Self::Velocity { .. } | Self::Acceleration { .. } => {
                return Vec2::ZERO;
            }
        };
        let rate = spin.at(time + 0.5 * dt);
        let half = 0.5 * dt * rate;
        // From 1e-9 down the sine is its angle to the last bit.
        let chord = if half.abs() > 1e-9 { libm::sin(half) / half } else { 1.0 };
        let (s, c) = libm::sincos(angle + half);
        let arm = centroid - about;
        let arm = Vec2::new(c * arm.x - s * arm.y, s * arm.x + c * arm.y);
        rate * chord * arm.perp()
    }
}

/// An external load.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Load {
    /// Blocks it acts on.
    pub blocks: Vec<u32>,
    /// What acts.
    pub kind: LoadKind,
    /// Multiplier over time.
    pub time: TimeFunction,
    /// Index into `Setup::accounts` of the account that its work is booked on, if any.
    pub account: Option<u16>,
}

/// Kinds of load.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum LoadKind {
    /// A force at a material point.
    Point {
        /// Force, N/m.
        force: Vec2,
        /// Initial global position of the point, m; `None` is the centroid. It travels with the block.
        at: Option<Vec2>,
        /// Whether the force turns with the block.
        follows: bool,
    },
    /// Pressure or traction on a straight part of the boundary.
    Edge {
        /// Start of the loaded segment, initial global position, m.
        from: Vec2,
        /// End of the loaded segment, m.
        to: Vec2,
        /// Tractions with a fixed direction at `from` and `to`, linear between, Pa.
        traction: [Vec2; 2],
        /// Pressure at `from` and `to`, Pa, positive into the block; follows the edge normal.
        pressure: [f64; 2],
    },
    /// A moment, N (N m per m), anticlockwise.
    Moment {
        /// Moment, N.
        moment: f64,
    },
    /// An acceleration acting on the mass, m/s².
    BodyForce {
        /// Acceleration, m/s².
        acceleration: Vec2,
    },
    /// Forces of a law of code, which finds them in an evaluation once contacts are known. It acts on all blocks there are.
    Own {
        /// Force (N/m) and moment about the centroid (N) by number of block; none on those beyond.
        wrenches: Vec<(Vec2, f64)>,
    },
}
