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
    /// Sizes, as above, m: blocks without supports up to them hold a fifth, half and four fifths of the rock.
    pub passing: [f64; 3],
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
    /// Files that the scene names, in words: how much of each was read, what was left out and why, units that it does not name.
    pub imports: Vec<String>,
    /// Blocks in space that joints divide, in words: area of joints per volume, cuts that were not made.
    pub joints: Vec<String>,
    /// Terrain, in words: extent, triangles, steepest place.
    pub terrain: Vec<String>,
    /// Charges and other cavities.
    pub charges: Vec<Charge>,
    /// Sum of the durations of all phases, s, if each has one.
    pub duration: Option<f64>,
}

/// Sizes (m) up to which blocks hold a fifth, half and four fifths of the rock, as a sieve would tell; `sizes` are roots of this `power` of their areas or
/// volumes, ascending.
pub(super) fn passing(sizes: &[f64], power: i32) -> [f64; 3] {
    let content = |size: &f64| (0..power).fold(1.0, |all, _| all * size);
    let whole: f64 = sizes.iter().map(content).sum();
    [0.2, 0.5, 0.8].map(|share| {
        let mut below = 0.0;
        let reaches = |size: &&f64| {
            below += content(size);
            below >= share * whole
        };
        sizes.iter().find(reaches).or(sizes.last()).copied().unwrap_or_default()
    })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sieve_counts_rock_and_not_blocks() {
        // Nine blocks of 1 m3 and one of 27: a quarter of the rock is in the small ones.
        let mut sizes = vec![1.0; 9];
        sizes.push(3.0);
        assert_eq!(passing(&sizes, 3), [1.0, 3.0, 3.0]);
        assert_eq!(passing(&sizes, 2), [1.0, 1.0, 3.0]);
        assert_eq!(passing(&[], 3), [0.0; 3]);
    }
}
