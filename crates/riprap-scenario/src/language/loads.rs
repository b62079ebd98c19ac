//! Supports and loads: what holds, moves and pushes blocks.

use riprap_keys::Keys;
use schemars::JsonSchema;
use serde::Deserialize;

use super::points::Point;
use super::solids::BoxRegion;
use crate::quantity::{
    Acceleration, Any, Axial, Direction, ForcePerLength, Kind, Length, MomentPerLength, Name,
    Names, Plain, PositivePlain, PositiveTime, Pressure, Quantity, Spin, SpinAcceleration, Vector,
    Velocity,
};
use crate::time_function::TimeFunction;

/// Which blocks.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Target {
    /// One block by name, or all blocks of a generator.
    Block(Name),
    /// All blocks of a group.
    Group(Name),
    /// Several blocks by name.
    Blocks(Vec<Name>),
    /// The blocks whose centroid lies in a box at the start.
    Box(BoxRegion),
    /// Nodes of deformable blocks in a box at the start, its surface included: corners, centres of faces, centroids.
    /// For supports in space; formulas of velocities know x, y, z, the place at the start.
    Nodes(Nodes),
}

/// Nodes in a box.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(at_most_one("block", "group", help = "keep one of them; a group may name the block"))]
pub struct Nodes {
    /// Corner with the lowest coordinates, m.
    pub min: Vector<Length>,
    /// Corner with the highest coordinates, m.
    pub max: Vector<Length>,
    /// Only those of this block or generator: one side of a joint.
    pub block: Option<Name>,
    /// Only those of this group.
    pub group: Option<Name>,
}

/// Blocks that are held or moved.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("fixed", "motion"))]
pub struct Support {
    /// Name for its work. Default the blocks.
    pub name: Option<Name>,
    /// Which blocks.
    pub on: Target,
    /// Holds the blocks; `fixed = {}` holds all directions.
    pub fixed: Option<Fixed>,
    /// Moves the blocks as prescribed.
    pub motion: Option<Motion>,
    /// A servo: the velocity, which must be constant, acts by the share that keeps a field at a value, for example a platen that
    /// holds a confining stress. It is the velocity that takes the field from nothing to the value.
    #[key(needs("motion", help = "a servo moves: give motion.velocity, at most as fast"))]
    pub control: Option<Control>,
}

/// A servo: what it multiplies acts fully as long as the field is far from its target, in proportion within a band about it, and backwards beyond.
/// It ends where a phase removes, releases or fixes all that it acts on.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// Field that is kept at a value, for example `pair.normal_force`; `riprap fields` lists them.
    pub field: Name,
    /// Block, two blocks of a pair, group or source; not for fields of the whole model.
    pub of: Option<Names>,
    /// Direction in which a vector is measured, as in a history.
    pub along: Option<Direction>,
    /// The value, not zero, in a unit of the field.
    pub target: Quantity<Any>,
    /// Width of the band to either side of the target, as a share of it.
    #[key(default = "0.05")]
    pub band: Option<Quantity<PositivePlain>>,
    /// Of a load: time in which it grows from nothing to its full size while the field is far from the target, s.
    pub rise: Option<Quantity<PositiveTime>>,
}

/// Directions that are held.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Fixed {
    /// Held along x.
    #[key(default = true)]
    pub x: Option<bool>,
    /// Held along y.
    #[key(default = true)]
    pub y: Option<bool>,
    /// Held along z.
    #[key(space = "spatial")]
    #[key(default = true)]
    pub z: Option<bool>,
    /// Kept from turning.
    #[key(default = true)]
    pub rotation: Option<bool>,
    /// Kept from turning about x. Default as `rotation`.
    #[key(space = "spatial", instead = "use `rotation`")]
    pub rotation_x: Option<bool>,
    /// Kept from turning about y. Default as `rotation`.
    #[key(space = "spatial", instead = "use `rotation`")]
    pub rotation_y: Option<bool>,
    /// Kept from turning about z. Default as `rotation`.
    #[key(space = "spatial", instead = "use `rotation`")]
    pub rotation_z: Option<bool>,
}

/// Prescribed motion.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// Velocity over time.
    Velocity(MotionComponents<Velocity, Spin>),
    /// Acceleration over time, starting from the velocity at the start (shaking). In
    /// `[space.spatial]` the blocks do not turn.
    Acceleration(MotionComponents<Acceleration, SpinAcceleration>),
}

/// Components of a prescribed motion; a component that is not given is free.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields, bound(deserialize = "L: Kind, R: Kind"))]
#[keys(any_of(
    "x",
    "y",
    "z",
    "spin",
    "spin_x",
    "spin_y",
    "spin_z",
    help = "write for example x = { constant = \"0.1 m/s\" }"
))]
#[keys(at_most_one(
    "about",
    "each",
    help = "keep `about` for one body, or `each` for every block by itself"
))]
#[keys(only_with("about", "each", when = "spin | spin_x | spin_y | spin_z"))]
pub struct MotionComponents<L: Kind, R: Kind> {
    /// Along x.
    pub x: Option<TimeFunction<L>>,
    /// Along y.
    pub y: Option<TimeFunction<L>>,
    /// Along z.
    #[key(space = "spatial")]
    pub z: Option<TimeFunction<L>>,
    /// Turning, anticlockwise.
    #[key(space = "planar", instead = "use `spin_x`, `spin_y`, `spin_z`")]
    pub spin: Option<TimeFunction<R>>,
    /// Turning about x, right-handed; for `velocity` only.
    #[key(space = "spatial", instead = "use `spin`")]
    pub spin_x: Option<TimeFunction<R>>,
    /// Turning about y, right-handed; for `velocity` only.
    #[key(space = "spatial", instead = "use `spin`")]
    pub spin_y: Option<TimeFunction<R>>,
    /// Turning about z, right-handed; for `velocity` only.
    #[key(space = "spatial", instead = "use `spin`")]
    pub spin_z: Option<TimeFunction<R>>,
    /// Point about which a velocity with a spin turns the blocks as one body; x, y, z are its velocity then, and components that are
    /// not given are held. Default the centroid of the group; one block alone turns about its own, and what is not given is free.
    pub about: Option<Vector<Length>>,
    /// Each block of a group turns about its own centroid.
    #[key(default = false)]
    pub each: Option<bool>,
}

/// A load.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("point", "edge", "moment", "body"))]
pub struct Load {
    /// Name for its work. Default the blocks.
    pub name: Option<Name>,
    /// Which blocks.
    pub on: Target,
    /// A force at a point.
    pub point: Option<PointLoad>,
    /// A pressure or traction along a part of the boundary, for example water in a joint.
    #[key(space = "planar", instead = "use [[boundaries]] with `pressure` or `traction`")]
    pub edge: Option<EdgeLoad>,
    /// A moment: in the plane per metre of thickness, N, anticlockwise; in space about x, y, z, N m.
    pub moment: Option<Axial<MomentPerLength>>,
    /// A force on the mass, given as an acceleration.
    pub body: Option<BodyLoad>,
    /// Factor over time, a number without unit. Default constant 1.
    pub time: Option<TimeFunction<Plain>>,
    /// A servo in place of `time`: the factor, from 0, that keeps a field at a value.
    pub control: Option<Control>,
}

/// A force at a point.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct PointLoad {
    /// Force: in the plane per metre of thickness, N/m; in space N.
    pub force: Vector<ForcePerLength>,
    /// Where it acts at the start, m; the point travels with the block. Default the centroid.
    pub at: Option<Vector<Length>>,
    /// Whether the direction turns with the block. Default false.
    #[key(space = "planar")]
    #[serde(default)]
    pub follows: bool,
}

/// A pressure or traction between two points of the boundary.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("pressure", "traction"))]
pub struct EdgeLoad {
    /// First point on the boundary at the start [x, y], m.
    pub from: Point,
    /// Second point, on the same edge, at the start [x, y], m.
    pub to: Point,
    /// Pressure at `from` and at `to`, linear between, Pa; positive pushes into the block and
    /// follows the edge.
    pub pressure: Option<[Quantity<Pressure>; 2]>,
    /// Force per area [x, y], Pa; keeps its direction.
    pub traction: Option<[Quantity<Pressure>; 2]>,
}

/// A force on the mass.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct BodyLoad {
    /// Force per mass, m/s2.
    pub acceleration: Vector<Acceleration>,
}
