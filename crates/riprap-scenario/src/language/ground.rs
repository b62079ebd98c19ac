//! Conditions on free faces, and the stress at the start.

use riprap_keys::{Keys, Words};
use schemars::JsonSchema;
use serde::Deserialize;

use super::loads::MotionComponents;
use super::points::Point3;
use super::solids::{BoxRegion, Empty};
use crate::quantity::{
    Angle, Density, Length, Name, NotNegativePlain, Plain, Pressure, PressureGradient, Quantity,
    Spin, Tensor, Velocity,
};
use crate::time_function::TimeFunction;
use crate::words::{OneWord, WordOr};

/// A condition on free faces: faces, or parts of them, on which no other block lies. Of several conditions for one face
/// the last counts, and a condition left without a face is an error.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of(
    "held",
    "roller",
    "moved",
    "viscous",
    "pressure",
    "traction",
    when = "!in_situ",
    help = "keep one; or in_situ = true for the stress alone"
))]
pub struct Boundary {
    /// Name for messages. Default the plane or the blocks.
    pub name: Option<Name>,
    /// Which faces.
    pub on: Faces,
    /// Holds the faces, along the normal and along the face, through the stiffness of the half
    /// blocks behind them. Write `held = {}`.
    #[key(space = "spatial", instead = "use [[supports]] and [[loads]]")]
    pub held: Option<Empty>,
    /// Holds the faces along their normal only: a roller or a plane of symmetry. Write
    /// `roller = {}`.
    #[key(space = "spatial", instead = "use [[supports]] and [[loads]]")]
    pub roller: Option<Empty>,
    /// Moves the faces as prescribed, through the stiffness of the half blocks behind them.
    #[key(space = "spatial", instead = "use [[supports]] and [[loads]]")]
    pub moved: Option<Moved>,
    /// Absorbs waves (Lysmer and Kuhlemeyer).
    #[key(space = "spatial", instead = "use [[supports]] and [[loads]]")]
    pub viscous: Option<Viscous>,
    /// A pressure that pushes into the blocks.
    #[key(space = "spatial", instead = "use [[supports]] and [[loads]]")]
    pub pressure: Option<FacePressure>,
    /// A force per area with a fixed direction.
    #[key(space = "spatial", instead = "use [[supports]] and [[loads]]")]
    pub traction: Option<FaceTraction>,
    /// Whether the in-situ stress acts on these faces from outside.
    /// Default true for `held`, `roller`, `moved` and `viscous` if there is
    /// `[in_situ]`, else false.
    #[key(required(
        space = "planar",
        help = "write in_situ = true: the stress of the rock outside acts on this side"
    ))]
    pub in_situ: Option<bool>,
}

/// Which free faces; in the plane `plane` with a word.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("plane", "block", "blocks", "group", "box", "surface"))]
pub struct Faces {
    /// The faces on a plane: a side of the whole model, or a normal and an offset.
    pub plane: Option<WordOr<Side, FacePlane>>,
    /// Faces of one block, or of all blocks of a generator.
    pub block: Option<Name>,
    /// Faces of several blocks.
    pub blocks: Option<Vec<Name>>,
    /// Faces of all blocks of a group.
    pub group: Option<Name>,
    /// Faces whose centre lies in a box.
    #[serde(rename = "box")]
    pub region: Option<BoxRegion>,
    /// The faces of a physical surface of a mesh of Gmsh, by its name.
    pub surface: Option<Name>,
    /// Only faces that look to this side. Default all.
    #[key(excludes(
        "plane",
        "surface",
        help = "these faces have normals already: leave `side` out"
    ))]
    pub side: Option<OneWord<Side>>,
}

/// A side of the model or of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Words)]
pub enum Side {
    /// The side with the lowest x.
    #[word("x-min")]
    XMin,
    /// The side with the highest x.
    #[word("x-max")]
    XMax,
    /// The side with the lowest y.
    #[word("y-min")]
    YMin,
    /// The side with the highest y.
    #[word("y-max")]
    YMax,
    /// The lower side.
    #[word("z-min")]
    ZMin,
    /// The upper side.
    #[word("z-max")]
    ZMax,
}

/// A plane by its outward normal.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct FacePlane {
    /// Outward normal [x, y, z] of the faces, of any length.
    pub normal: [Quantity<Plain>; 3],
    /// A point of the plane [x, y, z], m.
    pub at: Point3,
}

/// Prescribed motion of faces.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Moved {
    /// Velocity along x, y, z over time; a direction that is not given is free. Formulas know x, y, z, the place at the start.
    pub velocity: MotionComponents<Velocity, Spin>,
}

/// An absorbing face.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Viscous {
    /// Whether the dashpot stands behind the half block between centroid and face, which reflects
    /// less.
    #[key(default = true)]
    pub half_cell: Option<bool>,
}

/// A pressure on faces.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct FacePressure {
    /// Pressure into the blocks, Pa; at the height `datum` if there is a gradient.
    pub value: Quantity<Pressure>,
    /// What is added for each metre of depth below `datum`, Pa/m.
    #[key(default = "0 Pa/m")]
    pub gradient: Option<Quantity<PressureGradient>>,
    /// Height at which `value` holds, m.
    #[key(default = "0 m")]
    #[key(only_with("gradient"))]
    pub datum: Option<Quantity<Length>>,
    /// Factor over time. Default constant 1.
    pub time: Option<TimeFunction<Plain>>,
}

/// A traction on faces.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct FaceTraction {
    /// Force per area [x, y, z], Pa.
    pub value: [Quantity<Pressure>; 3],
    /// Factor over time. Default constant 1.
    pub time: Option<TimeFunction<Plain>>,
}

/// Stress that all joints carry at the start. The sign stands in its name. Heights are along z, in the plane along y.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InSitu {
    /// The weight of the rock above, and a share of it sideways.
    GravityK0(GravityK0),
    /// Principal stresses along the axes; compression is positive.
    Compressive(Box<Compressive>),
    /// All components; tension is positive.
    TensionPositive(TensionPositive),
}

/// Stress from gravity: vertical density times g times depth, horizontal `k0` times that.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct GravityK0 {
    /// Height of the ground surface, m. Default the top of the model.
    pub surface: Option<Quantity<Length>>,
    /// Horizontal over vertical stress. 1/3 belongs to Poisson's ratio 0.25.
    pub k0: Quantity<NotNegativePlain>,
    /// Density of the rock, kg/m3. Default that of the material; needed with several densities.
    pub density: Option<Quantity<Density>>,
}

/// Stress along the axes, compression positive.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(any_of(
    "vertical",
    "vertical_gradient",
    "x",
    "x_gradient",
    "y",
    "y_gradient",
    help = "write for example vertical = \"2 MPa\"; or use gravity_k0 = { k0 = 0.333 } for the weight of the rock"
))]
pub struct Compressive {
    /// Height at which the stresses hold, m. Default the top of the model.
    pub surface: Option<Quantity<Length>>,
    /// Vertical stress, Pa.
    #[key(default = "0 Pa")]
    pub vertical: Option<Quantity<Pressure>>,
    /// Its growth with depth, Pa/m.
    #[key(default = "0 Pa/m")]
    pub vertical_gradient: Option<Quantity<PressureGradient>>,
    /// Stress along x, Pa. Default `k0` times `vertical`.
    pub x: Option<Quantity<Pressure>>,
    /// Its growth with depth, Pa/m. Default `k0` times `vertical_gradient`.
    pub x_gradient: Option<Quantity<PressureGradient>>,
    /// Stress along y, Pa. Default `k0` times `vertical`.
    #[key(space = "spatial", instead = "use `vertical`")]
    pub y: Option<Quantity<Pressure>>,
    /// Its growth with depth, Pa/m. Default `k0` times `vertical_gradient`.
    #[key(space = "spatial", instead = "use `vertical_gradient`")]
    pub y_gradient: Option<Quantity<PressureGradient>>,
    /// Horizontal over vertical stress where a horizontal one is not given.
    #[key(default = "0")]
    pub k0: Option<Quantity<NotNegativePlain>>,
    /// Bearing of `x`, clockwise from north (y); `y` is at right angles to it. Default 90 deg.
    #[key(space = "spatial", instead = "use `angle`")]
    pub azimuth: Option<Quantity<Angle>>,
    /// Angle of `x`, anticlockwise from the horizontal; `vertical` is at right angles to it. Default 0 deg.
    #[key(space = "planar", instead = "use `azimuth`")]
    pub angle: Option<Quantity<Angle>>,
}

/// Stress by its components, tension positive.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct TensionPositive {
    /// Height at which the stresses hold, m. Default the top of the model.
    pub surface: Option<Quantity<Length>>,
    /// Stress [xx, yy, zz, yz, zx, xy], in the plane [xx, yy, xy], Pa.
    pub stress: Tensor<Pressure>,
    /// Change for each metre of depth, Pa/m. Default none.
    pub gradient: Option<Tensor<PressureGradient>>,
}
