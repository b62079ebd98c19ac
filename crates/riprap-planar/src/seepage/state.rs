//! What a network of joints is and remembers: plain data, part of a checkpoint.

use riprap_geom::Vec2;
use serde::{Deserialize, Serialize};

use crate::laws::seepage::Edge;

/// The network of joints under a table that seeps, with the heads found last.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Seepage {
    /// Places where joints meet or end.
    pub nodes: Vec<Node>,
    /// Stretches of joints between two nodes, by pairs of blocks, ascending.
    pub conduits: Vec<Conduit>,
    /// Stretches of free edges through which water goes.
    pub faces: Vec<OpenFace>,
    /// Pressures at the ends of each conduit, m of water: linear between them, nothing where that is below zero.
    pub ends: Vec<[f64; 2]>,
    /// `w^3/l` times the difference in head of each conduit, m³: its rate but for a factor that all have.
    pub rates: Vec<f64>,
    /// Step at which they were found.
    pub found_at: u64,
    /// Largest part of a rate that does not add up at a node, over the largest possible rate.
    pub left: f64,
}

/// A place where joints meet or end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Node {
    /// At the start, local, m.
    pub place: Vec2,
    /// What holds there.
    pub edge: Edge,
}

/// A stretch of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Conduit {
    /// The blocks on its sides; the smaller number first.
    pub blocks: [u32; 2],
    /// Its ends, anticlockwise around the first block.
    pub nodes: [u32; 2],
    /// Its ends on either block, from the centroid in the frame of the block, m.
    pub on: [[Vec2; 2]; 2],
}

/// A stretch of a free edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OpenFace {
    /// Its block.
    pub block: u32,
    /// Its ends, anticlockwise around the block.
    pub nodes: [u32; 2],
    /// Its ends, from the centroid in the frame of the block, m.
    pub on: [Vec2; 2],
}
