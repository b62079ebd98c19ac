//! What a network of joints in space is and remembers: plain data, part of a checkpoint.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::seepage::Edge;

/// The network of joints under a table that seeps, with the pressures found last.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Seepage {
    /// Stretches of lines along which joints meet or end.
    pub nodes: Vec<Node>,
    /// Pieces of joints, by pairs of blocks, ascending.
    pub joints: Vec<Joint>,
    /// Parts of faces on which nothing presses: on closed sides, and where blocks were taken out.
    pub bare: Vec<Bare>,
    /// What presses on block `b`: entries `first[b]` to `first[b + 1]`, twice the number of a joint and its side, bare parts after the joints.
    pub first: Vec<u32>,
    /// See there.
    pub entries: Vec<u32>,
    /// Whether a part of the surface of each block is in the open.
    pub open: Vec<bool>,
    /// Pressure in the middle of each joint (m of water) and its slope: linear, nothing where that is below zero.
    pub pressures: Vec<[f64; 4]>,
    /// Rate through each joint, m³, and the mean flow in it per metre of width, m²: those in m³/s and m²/s but for a factor that all have.
    pub flows: Vec<[f64; 4]>,
    /// Rate that comes in from the open, m³ in the same sense.
    pub inflow: f64,
    /// Numbers of blocks and of living ones for which it was built.
    pub blocks: [usize; 2],
    /// Largest share of what a joint conducts that its shape leaves out ([`crate::laws::seepage::sheet::Sheet::lost`]), and its blocks.
    pub lost: (f64, [u32; 2]),
    /// Step at which pressures were found.
    pub found_at: u64,
    /// Largest part of a rate that does not add up at a node, over the largest possible rate.
    pub left: f64,
}

/// A stretch of a line along which joints meet or end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Node {
    /// Its middle at the start, local, m.
    pub place: Vec3,
    /// What holds there.
    pub edge: Edge,
}

/// A flat piece of a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Joint {
    /// The blocks on its sides; the smaller number first.
    pub blocks: [u32; 2],
    /// Corners at the start, anticlockwise about the outward normal of the first block, local, m.
    pub outline: Vec<Vec3>,
    /// Centroid, m.
    pub centre: Vec3,
    /// Outward normal of the first block.
    pub normal: Vec3,
    /// Stretches of its rim: node, and length along the outward normal in the plane over the area, 1/m.
    pub rim: Vec<(u32, Vec3)>,
    /// Pipes between stretches of its rim: places in `rim`, conductance over the cube of the aperture.
    pub pipes: Vec<(u16, u16, f64)>,
    /// Shares of the stretches in the pressure at the centroid.
    pub shares: Vec<f64>,
}

/// A part of a face on which no water presses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bare {
    /// Its block.
    pub block: u32,
    /// Corners at the start, anticlockwise seen from outside, local, m.
    pub outline: Vec<Vec3>,
}
