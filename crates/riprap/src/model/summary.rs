//! Counts and sizes of a model.

use riprap_geom::measure::SliverReport;
use serde::Serialize;

/// What `riprap check` prints about a model without stepping it.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// Number of blocks.
    pub blocks: usize,
    /// Number of corners of all blocks.
    pub vertices: usize,
    /// Blocks that a support holds or drives in at least one freedom.
    pub supported: usize,
    /// Number of materials, interfaces and phases.
    pub materials: usize,
    /// Number of interface rows.
    pub interfaces: usize,
    /// Number of phases.
    pub phases: usize,
    /// Lower left and upper right corner of the model, global, m.
    pub bounds: [[f64; 2]; 2],
    /// Origin of the local coordinates, global, m.
    pub origin: [f64; 2],
    /// In space: lowest and highest corner of the model, global, m.
    pub solid_bounds: Option<[[f64; 3]; 2]>,
    /// Mass of the blocks, kg; in the plane per metre of thickness, kg/m.
    pub mass: f64,
    /// Square root of the area (in space cube root of the volume) of the smallest, the median and the
    /// largest block, m.
    pub size: [f64; 3],
    /// Shortest edge, m, and the block that has it.
    pub shortest_edge: (f64, String),
    /// Pairs of blocks that touch or nearly do at the start.
    pub near_pairs: usize,
    /// Deepest overlap at the start, m, and the two blocks.
    pub deepest_overlap: Option<(f64, [String; 2])>,
    /// Blocks that are thin or have a short edge, worst first; `block` numbers are those of the setup.
    pub slivers: Vec<SliverReport>,
    /// What generators made and left out.
    pub regions: Vec<Region>,
    /// Grids whose cells were fitted to a charge, in words.
    pub fitted: Vec<String>,
    /// Blocks in space that joints divide, in words: area of joints per volume, units that their lists do not name.
    pub joints: Vec<String>,
    /// Terrain, in words: extent, triangles, steepest place.
    pub terrain: Vec<String>,
    /// Charges and other cavities.
    pub charges: Vec<Charge>,
    /// Sum of the durations of all phases, s, if each has one.
    pub duration: Option<f64>,
}

/// A charge or another cavity, and the blocks that it replaces.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Charge {
    /// Name in the scenario.
    pub name: String,
    /// Mass of explosive, kg; absent for a given pressure.
    pub mass: Option<f64>,
    /// Volume of the charge, m³.
    pub volume: Option<f64>,
    /// Blocks that it replaces, after splitting.
    pub blocks: usize,
    /// Their volume, m³.
    pub cavity: f64,
    /// Volume of the blocks over that of the charge.
    pub ratio: Option<f64>,
}

/// Report of one generator of blocks.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Region {
    /// Name in the scenario.
    pub name: String,
    /// Blocks made.
    pub blocks: usize,
    /// Slivers merged into a neighbour.
    pub merged: Vec<SliverReport>,
    /// Short edges of cells shrunk to a point.
    pub collapsed: usize,
    /// Joint pieces left out because they end inside a block.
    pub dead_ends: usize,
    /// Joint pieces left out because they enclose nothing that is connected.
    pub islands: usize,
}
