//! Named sets of blocks by place, size, material and name.

use riprap_keys::Keys;
use serde::Deserialize;

use super::points::Point;
use super::solids::BoxRegion;
use crate::quantity::{Length, Name, Plain, PositiveLength, Quantity, Vector};

/// A named set of blocks, besides the groups that blocks name themselves: all that one of its keys holds. A block lies where its
/// centroid lies at the start.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Group {
    /// The blocks in this box.
    #[serde(rename = "box")]
    pub region: Option<BoxRegion>,
    /// The blocks on the side of a plane (in the plane of a line) to which its normal points.
    pub half_space: Option<HalfSpace>,
    /// The blocks in a ball; in the plane a circle.
    pub sphere: Option<Sphere>,
    /// The blocks in a cylinder with flat ends.
    #[key(space = "spatial", instead = "use `near` or `box`")]
    pub cylinder: Option<Cylinder>,
    /// The blocks over a polygon in plan; in the plane in it.
    pub prism: Option<Prism>,
    /// The blocks near a straight line.
    pub near: Option<Near>,
    /// The blocks of a size: the edge of the cube, in the plane of the square, that is as large.
    pub size: Option<SizeRange>,
    /// The blocks of a material.
    pub material: Option<Name>,
    /// Blocks by name.
    #[serde(default)]
    pub blocks: Vec<Name>,
    /// Names of groups, blocks and materials with `and`, `or`, `not` and parentheses, for example `"roof and not (ore or key)"`; names with
    /// blanks in single quotes.
    #[serde(rename = "where")]
    pub condition: Option<Name>,
}

/// The side of a plane.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct HalfSpace {
    /// A point of the plane, m.
    pub at: Vector<Length>,
    /// To the side that is meant, of any length.
    pub normal: Vector<Plain>,
}

/// What lies within a distance of a point.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Centre, m.
    pub centre: Vector<Length>,
    /// Radius, m.
    pub radius: Quantity<PositiveLength>,
}

/// A cylinder.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Centre of one end, m.
    pub from: Vector<Length>,
    /// Centre of the other end, m.
    pub to: Vector<Length>,
    /// Radius, m.
    pub radius: Quantity<PositiveLength>,
}

/// What lies over a polygon.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Prism {
    /// Corners [x, y] in order, m.
    pub points: Vec<Point>,
    /// Lowest z, m. Default: no bound.
    #[key(space = "spatial", instead = "leave it out: blocks of the plane have no height")]
    pub from: Option<Quantity<Length>>,
    /// Highest z, m. Default: no bound.
    #[key(space = "spatial", instead = "leave it out: blocks of the plane have no height")]
    pub to: Option<Quantity<Length>>,
}

/// What lies near a straight line.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Near {
    /// One end, m.
    pub from: Vector<Length>,
    /// Other end, m.
    pub to: Vector<Length>,
    /// Largest distance from it, m.
    pub distance: Quantity<PositiveLength>,
}

/// Sizes of blocks.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(any_of("above", "below"))]
pub struct SizeRange {
    /// Larger ones than this, m.
    pub above: Option<Quantity<PositiveLength>>,
    /// Smaller ones than this, m.
    pub below: Option<Quantity<PositiveLength>>,
}
