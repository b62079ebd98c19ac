//! Named sets of blocks by place, size, material and name.

use riprap_keys::Keys;
use serde::Deserialize;

use super::points::{Point, Point3};
use super::solids::BoxRegion;
use crate::quantity::{
    Angle, Length, Name, NotNegativeLength, Plain, PositiveLength, PositivePlain, Quantity, Vector,
};

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
    #[key(space = "spatial", instead = "use `sphere`, in the plane a circle, or `near`")]
    pub cylinder: Option<Cylinder>,
    /// The blocks over a polygon in plan; in the plane in it.
    pub prism: Option<Prism>,
    /// The blocks near a straight line.
    pub near: Option<Near>,
    /// The blocks in a tunnel, a shaft or a pit: a profile along a line. `blocks.*.cut.along` cuts the rock along its surface.
    #[key(space = "spatial", instead = "use `prism`")]
    pub excavation: Option<Excavation>,
    /// The blocks inside a closed surface of a file: an ore body. In the plane inside closed outlines.
    pub inside: Option<SurfaceFile>,
    /// The blocks above a surface of a file: those with the nearest part of it on the vertical through the centroid below them.
    pub above: Option<SurfaceFile>,
    /// The blocks below a surface of a file: those with the nearest part of it on the vertical through the centroid above them.
    pub below: Option<SurfaceFile>,
    /// The blocks near a face, which is a polygon.
    #[key(space = "spatial", instead = "use `near`")]
    pub near_face: Option<NearFace>,
    /// The blocks with a face along a set of joints; in the plane with an edge inside the region in its direction, up to three times its scatter.
    pub joint_set: Option<AlongSet>,
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

/// A surface of a file; in the plane lines of a drawing.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("asc", "csv", "dxf", "obj", "stl"))]
pub struct SurfaceFile {
    /// Path of an ASCII grid of ESRI: an open surface.
    #[key(space = "spatial", instead = "give the lines of a drawing, `dxf`")]
    pub asc: Option<Name>,
    /// Path of a CSV file with `x_m`, `y_m`, `z_m` of a rectangular grid: an open surface.
    #[key(space = "spatial", instead = "give the lines of a drawing, `dxf`")]
    pub csv: Option<Name>,
    /// Path of a DXF drawing: its faces in space (3DFACE), in the plane its lines.
    pub dxf: Option<Name>,
    /// Path of an OBJ file: all its faces.
    #[key(space = "spatial", instead = "give the lines of a drawing, `dxf`")]
    pub obj: Option<Name>,
    /// Path of an STL file.
    #[key(space = "spatial", instead = "give the lines of a drawing, `dxf`")]
    pub stl: Option<Name>,
    /// Name of the layer of a drawing that is taken. Default all.
    #[key(only_with("dxf"))]
    pub layer: Option<Name>,
    /// Length of 1 in the file, m. Default 1 m, of a drawing as it says (`$INSUNITS`).
    #[key(excludes("csv", help = "the columns of a CSV file have their units in their names"))]
    pub unit: Option<Quantity<PositiveLength>>,
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

/// What lies near a polygon.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct NearFace {
    /// Corners [x, y, z] of a flat convex polygon in order, m.
    pub points: Vec<Point3>,
    /// Largest distance from it, m.
    pub distance: Quantity<PositiveLength>,
}

/// Blocks between joints of a set.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct AlongSet {
    /// Name of the `[[blocks]]` with the set.
    pub of: Name,
    /// Number of the set in its `cut.joint_sets`, from 1.
    #[key(min = 1, max = 1000)]
    pub number: u64,
}

/// A profile along a straight line. In the profile `u` points to the right of who looks from `from` to `to`, and `v` up; along an upright
/// line `v` points north (y).
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("circle", "horseshoe", "polygon", "benches", "profile"))]
pub struct Excavation {
    /// One end of the line [x, y, z], m.
    pub from: Point3,
    /// Other end of the line, m.
    pub to: Point3,
    /// A circle about the line.
    pub circle: Option<CircleProfile>,
    /// Upright walls under half a circle; the line is the middle of the floor.
    pub horseshoe: Option<HorseshoeProfile>,
    /// Corners [u, v] in order, from the line, m.
    pub polygon: Option<Vec<Point>>,
    /// A pit with benches that rise to the left of the line, which is the toe of the lowest one.
    pub benches: Option<BenchesProfile>,
    /// A closed outline of a drawing.
    pub profile: Option<DrawnProfile>,
    /// Number of equal parts along the line, the groups name.1, name.2, ... from `from` on.
    #[key(default = 1, min = 1, max = 1000)]
    pub rounds: Option<u64>,
}

/// A circle of straight sides, as large as the circle.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct CircleProfile {
    /// Radius, m.
    pub radius: Quantity<PositiveLength>,
    /// Number of sides.
    #[key(default = 24, min = 3, max = 360)]
    pub sides: Option<u64>,
}

/// Upright walls under half a circle.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct HorseshoeProfile {
    /// Width, m.
    pub width: Quantity<PositiveLength>,
    /// Height from the floor to the crown, m; at least half of the width.
    pub height: Quantity<PositiveLength>,
    /// Number of straight sides of the arch, whose corners lie on the half circle.
    #[key(default = 12, min = 2, max = 180)]
    pub sides: Option<u64>,
}

/// A closed outline of a drawing: x of the drawing is `u`, y is `v`.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct DrawnProfile {
    /// Path of a DXF drawing (text or binary) with one closed outline, whose lines may be single ones; arcs become straight pieces.
    pub dxf: Name,
    /// Name of the layer that is taken. Default all.
    pub layer: Option<Name>,
    /// Where the line of the excavation goes through the drawing [x, y], m. Default its origin.
    pub origin: Option<Point>,
    /// What the length 1 in the drawing stands for, m. Default as the drawing says (`$INSUNITS`), else 1 m.
    pub unit: Option<Quantity<PositiveLength>>,
    /// Largest distance of an arc from the straight pieces it becomes, m. Default a hundredth of its radius.
    pub sagitta: Option<Quantity<PositiveLength>>,
}

/// Faces with berms between them.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct BenchesProfile {
    /// Height of a bench, m.
    pub height: Quantity<PositiveLength>,
    /// Angle of the faces, up to 90 deg.
    pub face_angle: Quantity<Angle>,
    /// Width of the berms between faces, m.
    pub berm: Quantity<PositiveLength>,
    /// Number of benches.
    #[key(min = 1, max = 100)]
    pub count: u64,
    /// Width of the floor to the right of the line, m.
    pub floor: Quantity<PositiveLength>,
    /// Ramps, as rock that is left along the foot of a face.
    #[serde(default)]
    pub ramps: Vec<BenchRamp>,
}

/// A way down a bench, along its face: from the beginning of the line to `start` it is as high as the bench, then it falls to its foot.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct BenchRamp {
    /// Number of the bench that it leads down, 1 the lowest.
    #[key(default = 1, min = 1, max = 100)]
    pub bench: Option<u64>,
    /// Where it begins to fall, from the beginning of the line, m. Default 0 m.
    pub start: Option<Quantity<NotNegativeLength>>,
    /// Width, m: at most that of the berm (of the floor for the lowest bench).
    pub width: Quantity<PositiveLength>,
    /// Fall over length along the line: 0.1 is 10 %.
    pub grade: Quantity<PositivePlain>,
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
