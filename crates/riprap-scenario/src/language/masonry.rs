//! Masonry in space: walls with openings and buttresses, vaults, domes.

use riprap_keys::{Keys, Words};
use serde::Deserialize;

use super::blocks::MAX_BLOCKS;
use super::points::Point3;
use crate::quantity::{HalfAngle, NotNegativeLength, PositiveLength, Quantity};

/// A wall of bricks along x, with its thickness along y; `rotate` turns it.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Masonry {
    /// Lowest corner of the wall [x, y, z], m. Default the origin.
    pub corner: Option<Point3>,
    /// Length of the wall, m. The bricks at its ends are cut to it.
    pub length: Quantity<PositiveLength>,
    /// Length, thickness and height of a brick along x, y, z, m.
    pub brick: [Quantity<PositiveLength>; 3],
    /// Number of rows, at least 1.
    #[key(min = 1, max = MAX_BLOCKS)]
    pub courses: u64,
    /// Number of bricks through the wall.
    #[key(default = 1, min = 1, max = 100)]
    pub leaves: Option<u64>,
    /// How the rows stand on each other.
    #[key(default)]
    pub bond: Option<MasonryBond>,
    /// Doors and windows.
    #[serde(default)]
    pub openings: Vec<WallOpening>,
    /// Piers that lean against it, on its side y = 0; in the group `NAME_buttresses` of a wall NAME.
    #[serde(default)]
    pub buttresses: Vec<Buttress>,
}

/// A pier against a wall, one stone in a row: every second stone reaches through the wall.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Buttress {
    /// Distance of its left side from the corner of the wall, m.
    pub left: Quantity<NotNegativeLength>,
    /// Width along the wall, m.
    pub width: Quantity<PositiveLength>,
    /// Depth at its foot, from the wall outward, m.
    pub foot: Quantity<PositiveLength>,
    /// Depth at its top, m: at most that of the foot. Its outer face is plane between them.
    pub top: Quantity<PositiveLength>,
    /// Height, m: whole rows. Default that of the wall.
    pub height: Option<Quantity<PositiveLength>>,
}

/// How rows of a wall in space stand on each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Words)]
pub enum MasonryBond {
    #[default]
    /// Every second row is shifted by half a brick.
    Running,
    /// Bricks stand exactly on each other.
    Stack,
    /// Rows of stretchers, whose leaves nothing joins, and rows of headers, which reach through the wall, take turns.
    English,
}

/// A door or a window.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(at_most_one("lintel", "arch"))]
pub struct WallOpening {
    /// Distance of its left side from the corner of the wall, m.
    pub left: Quantity<NotNegativeLength>,
    /// Height of its sill above the foot of the wall, m: whole rows. Default 0 m, a door.
    pub sill: Option<Quantity<NotNegativeLength>>,
    /// Width, m.
    pub width: Quantity<PositiveLength>,
    /// Height, m: whole rows.
    pub height: Quantity<PositiveLength>,
    /// The beam above it, in the group `NAME_lintels` of a wall NAME. Default none.
    pub lintel: Option<Lintel>,
    /// The arch above it, in the group `NAME_arches` of a wall NAME. Default none.
    pub arch: Option<OpeningArch>,
}

/// An arch over an opening, as thick as the wall, of stones between joints that point to the centre of its underside.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct OpeningArch {
    /// Height of its underside over the springing, m. Up to 0.38 of the width: segmental with a level top, bricks cut to its skewbacks. Half of the width: round;
    /// more: pointed; both stepped by whole rows, no brick is cut.
    pub rise: Quantity<PositiveLength>,
    /// Height from the springing to its top, m: whole rows, more than the rise.
    pub height: Quantity<PositiveLength>,
    /// Number of stones: odd with a keystone; even in a pointed arch.
    #[key(min = 1, max = 1_000)]
    pub voussoirs: u32,
}

/// A beam over an opening, as thick as the wall.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Lintel {
    /// Height, m: whole rows.
    pub height: Quantity<PositiveLength>,
    /// Length of its support on either side, m.
    pub bearing: Quantity<PositiveLength>,
}

/// A barrel vault, or an arch that is as long as one stone: stones around a level line.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Vault {
    /// One end of the axis [x, y, z], m.
    pub from: Point3,
    /// Other end of the axis, m.
    pub to: Point3,
    /// Radius of the middle of the ring, m.
    pub radius: Quantity<PositiveLength>,
    /// Thickness of the ring, m; less than twice the radius.
    pub thickness: Quantity<PositiveLength>,
    /// Angle from the crown to a springing: 90 deg is a half circle.
    pub half_angle: Quantity<HalfAngle>,
    /// Number of stones around, at least 1.
    #[key(min = 1, max = 100_000)]
    pub voussoirs: u32,
    /// Number of stones along the axis.
    #[key(default = 1, min = 1, max = 100_000)]
    pub rings: Option<u32>,
    /// How the rows along the axis lie beside each other.
    #[key(default)]
    pub bond: Option<VaultBond>,
}

/// How rows of a vault lie beside each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Words)]
pub enum VaultBond {
    #[default]
    /// As rings that nothing joins.
    Rings,
    /// Every second row is shifted by half a stone.
    Running,
}

/// A spherical dome of wedge-shaped stones between rays from its centre, in rings; joints between the stones of a ring go on in the next.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Dome {
    /// Centre of the sphere [x, y, z], m. Default the origin.
    pub centre: Option<Point3>,
    /// Radius of the sphere between inner and outer corners, m.
    pub radius: Quantity<PositiveLength>,
    /// Thickness, m; less than twice the radius.
    pub thickness: Quantity<PositiveLength>,
    /// Angle from the crown to the springing: 90 deg is a half sphere.
    pub half_angle: Quantity<HalfAngle>,
    /// Angle from the crown to the rim of an oculus. Default none: one stone of as many sides as a ring has stones closes the dome, half a ring wide.
    pub oculus: Option<Quantity<HalfAngle>>,
    /// Number of rings.
    #[key(min = 1, max = 10_000)]
    pub rings: u32,
    /// Number of stones in a ring.
    #[key(min = 3, max = 1_000)]
    pub voussoirs: u32,
}
