//! The words of the scenario language, one struct a table.
//!
//! The doc comments are what the user reads: `riprap explain KEY`, the JSON schema that editors
//! use and the reference page are made from them. Every comment says what the key means, its
//! unit, its default and its range. A key without a value in the file is `None` here: defaults
//! belong to `model`, which can say where a number came from.
//!
//! Variants are keys (externally tagged), unknown keys are denied, nothing is flattened or
//! untagged: only so an error can point at the right place.

mod blocks;
mod bolts;
mod checks;
mod files;
mod ground;
mod interfaces;
mod joints;
mod loads;
mod masonry;
mod outputs;
mod phases;
mod points;
mod regions;
mod samples;
mod solids;
mod sources;
mod space;
mod water;

use riprap_keys::{Keys, Words};
use serde::Deserialize;

pub(crate) use blocks::MAX_BLOCKS;
pub use blocks::{
    Arch, Block, Copies, Cut, Geometry, Polygon, Pour, Rectangle, Regular, Rotate, Voronoi, Wall,
    WallBond,
};
pub use bolts::{Bolt, BoltPattern, Dowel, Grout, Plate, Repeat, Steel};
pub use checks::{Bisect, Check, Criterion, Reduce};
pub use files::{Polygons, Traces};
pub use ground::{
    Boundary, Compressive, FacePlane, FacePressure, FaceTraction, Faces, GravityK0, InSitu, Moved,
    Side, TensionPositive, Viscous,
};
pub use interfaces::{
    BartonBandis, Bond, BrittleBond, Closure, Cohesive, Interface, InterfaceChange, JointSoftening,
    curve,
};
pub use joints::{CutAlong, JointPlanes, JointSet};
pub use loads::{
    BodyLoad, Control, EdgeLoad, Fixed, Load, Motion, MotionComponents, Nodes, PointLoad, Support,
    Target,
};
pub use masonry::{
    Buttress, Dome, Lintel, Masonry, MasonryBond, OpeningArch, Vault, VaultBond, WallOpening,
};
pub use outputs::{Every, History, Moment, Output, Period, Pictures, Schedule};
pub use phases::{CutAxis, Cutting, Damping, Leavers, Phase, Relaxation, Reset, Rest, Until};
pub use points::{Point, Point3};
pub use regions::{
    AlongSet, BenchRamp, BenchesProfile, CircleProfile, Cylinder, DrawnProfile, Excavation, Group,
    HalfSpace, HorseshoeProfile, Near, NearFace, Prism, SizeRange, Sphere, SurfaceFile,
};
pub use samples::{Beta, Correlation, MeasuredValues, Moments, MonteCarlo, RandomValue, Sampling};
pub use solids::{
    Ball, BoxRegion, Brick, Deformable, Empty, Graded, Grid, GridBox, GridCells, Mechanics, Mesh,
    Notch, NotchBreaks, Part, Plane, Polyhedron, Segment, Terrain, span_of,
};
pub use sources::{
    Around, CouplingScale, CouplingWord, Deck, Detonation, During, Explosive, GasCavity,
    JwlConstants, JwlSet, Octree, Pattern, PatternGrid, Place, PressureCavity, Primer, Refine,
    Source, Stemming, Venting, VentingCracks, VentingTime,
};
pub use space::{Air, Material, Planar, Space, Spatial, Start, Tilt};
pub use water::{Drain, Seepage, Water};

use super::quantity::{PositivePlain, Quantity, Table};

/// A scenario: everything that riprap needs to build, run and check one model.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Version of the scenario language. Write `riprap = 1`.
    pub riprap: u32,
    /// What the scene shows, in one line; stands over plots and reports.
    pub title: String,
    /// Longer text about the scene.
    pub description: Option<String>,
    /// Who made it; stands in reports.
    pub author: Option<String>,
    /// What it belongs to; stands in reports.
    pub project: Option<String>,
    /// `"SI"`: bare numbers are allowed and are SI (m, kg, s, N, Pa, rad). Without this key every
    /// value needs its unit.
    pub units: Option<Units>,
    /// All strengths of interfaces and joints (cohesion, tension, tangents of friction angles) are
    /// divided by this number. The one at which
    /// the model fails (`riprap bisect`) is its factor of safety.
    #[key(default = "1")]
    pub strength_factor: Option<Quantity<PositivePlain>>,
    /// The space in which the blocks move and the gravity that acts there.
    pub space: Space,
    /// Materials by name: density and, if wanted, elastic constants.
    pub materials: Table<Material>,
    /// Laws of contact by name. `default` is used by every pair of materials that no other
    /// interface names.
    #[serde(default)]
    pub interfaces: Table<Interface>,
    /// Blocks and generators of blocks.
    #[serde(default)]
    pub blocks: Vec<Block>,
    /// States of blocks at the start, from a table.
    pub start: Option<Start>,
    /// Blocks that are held or moved.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// Bolts, anchors, cables and dowels.
    #[serde(default)]
    pub bolts: Vec<Bolt>,
    /// Named sets of blocks by place or by name.
    #[serde(default)]
    pub groups: Table<Group>,
    /// Splitting of bricks and parallelepipeds into eight.
    #[key(space = "spatial")]
    #[serde(default)]
    pub refine: Vec<Refine>,
    /// Conditions on free faces: held, moved, absorbing or loaded; in the plane the stress of the rock outside.
    #[serde(default)]
    pub boundaries: Vec<Boundary>,
    /// Cracks that are there at the start.
    #[key(space = "spatial")]
    #[serde(default)]
    pub notches: Vec<Notch>,
    /// Stress at the start.
    pub in_situ: Option<InSitu>,
    /// Explosives by name.
    #[key(space = "spatial")]
    #[serde(default)]
    pub explosives: Table<Explosive>,
    /// Charges and other cavities by name.
    #[key(space = "spatial")]
    #[serde(default)]
    pub sources: Table<Source>,
    /// Forces, pressures and moments on blocks.
    #[serde(default)]
    pub loads: Vec<Load>,
    /// Water tables by name, of which one at a time stands.
    #[serde(default)]
    pub water: Table<Water>,
    /// The parts of the run, one after the other.
    #[serde(default)]
    pub phases: Vec<Phase>,
    /// What is written to the run folder besides the energy table.
    #[serde(default)]
    pub outputs: Vec<Output>,
    /// Values of keys: the scene is run for every combination (`riprap sweep`).
    /// Keys stand in quotes, values in a list, for example
    /// `"interfaces.default.friction_angle" = ["0 deg", "5 deg"]`.
    #[serde(default)]
    #[schemars(with = "std::collections::BTreeMap<String, Vec<serde_json::Value>>")]
    pub sweep: Table<Vec<toml::Value>>,
    /// Named sets of changed keys: the scene is run once for each. The scene as it stands is the
    /// variant `default`.
    #[serde(default)]
    #[schemars(
        with = "std::collections::BTreeMap<String, std::collections::BTreeMap<String, serde_json::Value>>"
    )]
    pub variants: Table<Table<toml::Value>>,
    /// Random values of keys (`riprap monte-carlo`). Keys stand in quotes, for example
    /// `"interfaces.default.friction_angle" = { normal = { mean = "35 deg", deviation = "2 deg" } }`.
    #[serde(default)]
    pub distributions: Table<RandomValue>,
    /// How many samples of `[distributions]` are run, and what counts as failure.
    pub monte_carlo: Option<MonteCarlo>,
    /// Search for the value of a key at which the scene fails (`riprap bisect`).
    pub bisect: Option<Bisect>,
    /// Numbers that the run must reproduce (`riprap verify`).
    #[serde(default)]
    pub checks: Vec<Check>,
}

impl Scenario {
    /// Names of the interfaces that rock bridges and cuts along excavations have.
    pub(crate) fn interfaces_of_bridges(&self) -> impl Iterator<Item = &crate::quantity::Name> {
        self.blocks.iter().filter_map(|block| block.cut.as_ref()).flat_map(|cut| {
            let bridges = cut.joints.as_ref().and_then(|joints| joints.bridges.as_ref());
            let along = cut.along.as_ref().and_then(|along| along.interface.as_ref());
            bridges.into_iter().chain(along)
        })
    }
}

/// System of units of bare numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Words)]
pub enum Units {
    /// m, kg, s, N, Pa, rad.
    #[word("SI")]
    Si,
}
