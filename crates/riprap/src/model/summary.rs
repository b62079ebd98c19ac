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
    /// Mass of the blocks per metre of thickness, kg/m.
    pub mass: f64,
    /// Square root of the area of the smallest, the median and the largest block, m.
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
    /// Sum of the durations of all phases, s, if each has one.
    pub duration: Option<f64>,
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
