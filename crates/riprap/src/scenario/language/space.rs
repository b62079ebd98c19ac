//! The space of a scene and its materials.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scenario::quantity::{
    Acceleration, Angle, Density, Modulus, NotNegativeLength, Poisson, Quantity,
};

/// The space in which the blocks move. Exactly one form.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Space {
    /// Two dimensions: polygons of unit thickness, x to the right, y up; forces per metre.
    Planar(Planar),
}

/// Two dimensions.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Planar {
    /// Acceleration of gravity [x, y], m/s2; usually `["0 m/s2", "-9.81 m/s2"]`.
    pub gravity: [Quantity<Acceleration>; 2],
    /// The gravity vector is turned clockwise by this angle: a tilting table. Default 0 deg.
    pub tilt: Option<Quantity<Angle>>,
    /// Deepest overlap of two blocks at the start that is accepted, m. Default 1e-6 of the smaller
    /// block, or what the weight of the whole model could press in (up to 1 % of the block).
    pub allow_overlap: Option<Quantity<NotNegativeLength>>,
}

/// A material.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Mass per volume, kg/m3; greater than zero. Not the unit weight in kN/m3.
    pub density: Quantity<Density>,
    /// Young's modulus, Pa. Used only for the default contact stiffness.
    pub young: Option<Quantity<Modulus>>,
    /// Poisson's ratio, greater than -1 and less than 0.5. Used only for the default contact
    /// stiffness.
    pub poisson: Option<Quantity<Poisson>>,
}
