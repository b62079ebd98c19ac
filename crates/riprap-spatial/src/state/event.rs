//! What has happened to blocks and cavities.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::fracture::FractureMode;

/// What has happened to blocks and cavities, for the record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EditEvent {
    /// Step number.
    pub step: u64,
    /// Time, s.
    pub time: f64,
    /// What.
    pub kind: EditKind,
    /// Block that was split or removed; number of the cavity otherwise.
    pub subject: u32,
    /// Children of a split block, in octant order.
    pub children: Vec<u32>,
    /// Patches or facets of the block before, and of its children (inner ones included) after.
    pub patches: [u32; 2],
    /// How a block was cut.
    pub cut: Option<Note>,
}

/// Kinds of event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum EditKind {
    /// A block was split 1 to 8.
    Split,
    /// A deformable block was cut by planes.
    Cut,
    /// A block was taken out.
    Removed,
    /// A cavity went off.
    Ignited,
    /// The gas of a cavity began to escape.
    Vented,
    /// A block went over the rim of the terrain.
    LeftTerrain,
}

/// How a block was cut.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Note {
    /// Unit normal of the planes.
    pub normal: Vec3,
    /// FractureMode of breaking.
    pub mode: FractureMode,
    /// Stress beyond the limit, Pa.
    pub excess: f64,
}
