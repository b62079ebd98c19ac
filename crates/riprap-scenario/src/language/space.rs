//! The space of a scene and its materials.

use riprap_core::laws::parameters::Kinematics;
use riprap_keys::Keys;
use schemars::JsonSchema;
use serde::Deserialize;

use super::outputs::Period;
use crate::quantity::{
    Acceleration, Angle, Density, Down, Modulus, Name, NotNegativeLength, Plain, Poisson,
    PositiveAngle, PositiveLength, PositivePlain, Quantity, Vector,
};

/// The space in which the blocks move.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[expect(clippy::large_enum_variant, reason = "a scene has one space")]
pub enum Space {
    /// Two dimensions: polygons of unit thickness, x to the right, y up; forces per metre.
    Planar(Planar),
    /// Three dimensions: bricks and convex polyhedra, x east, y north, z up.
    Spatial(Spatial),
}

/// Two dimensions.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Planar {
    /// Acceleration of gravity [x, y], m/s2; usually `["0 m/s2", "-9.81 m/s2"]`.
    #[key(told)]
    pub gravity: [Quantity<Acceleration>; 2],
    /// The gravity vector is turned clockwise by this angle: a tilting table.
    #[key(default = "0 deg")]
    pub tilt: Option<Quantity<Angle>>,
    /// Thickness of the slice that results are of, m: forces, masses and energies are then in N, kg and J. Inputs stay per metre.
    /// Default: results per metre.
    pub thickness: Option<Quantity<PositiveLength>>,
    /// Deepest overlap of two blocks at the start that is accepted, m. Default 1e-6 of the smaller
    /// block, or what the weight of the whole model could press in (up to 1 % of the block).
    pub allow_overlap: Option<Quantity<NotNegativeLength>>,
}

/// Three dimensions.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Spatial {
    /// Acceleration of gravity, m/s2: one value that points down (against z), usually
    /// `"9.81 m/s2"`, or a vector.
    #[key(told)]
    pub gravity: Down<Acceleration>,
    /// Gravity is turned: a tilting table. The drawing stays level.
    pub tilt: Option<Tilt>,
    /// How blocks turn.
    #[key(default)]
    pub kinematics: Option<Kinematics>,
    /// Angle at which a block changes over to finite rotations, rad.
    #[key(default = "0.01 rad")]
    #[key(only_with("!kinematics", "kinematics = automatic"))]
    pub rotation_bound: Option<Quantity<PositiveAngle>>,
    /// Air that resists the motion of rigid blocks: flying fragments. `air = {}` has the defaults. Default none.
    pub air: Option<Air>,
    /// Periods of the model along x, y, z: a length, or `"none"`. Blocks at opposite ends are
    /// neighbours. Default none.
    #[key(told)]
    pub periodic: Option<[Period; 3]>,
    /// Whether blocks that no joint joins meet: press, slide, rebound.
    #[key(default = true)]
    pub found_contacts: Option<bool>,
    /// Deepest overlap of two blocks at the start that is accepted, m. Default 1e-6 of the smaller
    /// block.
    pub allow_overlap: Option<Quantity<NotNegativeLength>>,
}

/// A turn of the gravity vector. The blocks stay as they are drawn; phases that give their own `gravity` are not tilted.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Tilt {
    /// By how much gravity turns about the axis, by the rule of the right hand. About y gravity that points down comes to pull against x, as the tilt of the
    /// plane.
    pub angle: Quantity<Angle>,
    /// Axis, of any length. Default `[0, 1, 0]`.
    pub axis: Option<Vector<Plain>>,
}

/// Air: a force against the velocity of each rigid block, half the density times the drag coefficient, the square of the speed and the cross-section of a
/// ball of the same volume.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Air {
    /// Density, kg/m3.
    #[key(default = "1.2 kg/m3")]
    pub density: Option<Quantity<Density>>,
    /// Drag coefficient: 0.5 of a ball, about 1 of a cube or a fragment.
    #[key(default = "1")]
    pub drag: Option<Quantity<PositivePlain>>,
}

/// States of blocks at the start.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Start {
    /// Path of a CSV file with a block in each row, by its name in the column `block`: a block stands there with its centroid, attitude, velocity and
    /// spin as the row says. Columns in `[space.planar]`: `x_m`, `y_m`, `angle_rad`, `vx_m_s`, `vy_m_s`, `spin_rad_s`; in `[space.spatial]`: `x_m`, `y_m`,
    /// `z_m`, `qw`, `qx`, `qy`, `qz`, `vx_m_s`, `vy_m_s`, `vz_m_s`, `wx_rad_s`, `wy_rad_s`, `wz_rad_s`. Angle and quaternion turn the shape of the scene about its
    /// centroid. Place, attitude, velocity and spin may each be left out; blocks without a row start as the scene says. A run writes such a
    /// table at the end of each phase, `final_states.csv`.
    pub csv: Name,
}

/// A material.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Mass per volume, kg/m3. Not the unit weight in kN/m3.
    pub density: Quantity<Density>,
    /// Young's modulus, Pa. Needed for stiffnesses that are not given, and in `[space.spatial]` for deformable blocks and
    /// held, moved and viscous boundaries; where it is given, the damping of joints goes by it too.
    pub young: Option<Quantity<Modulus>>,
    /// Poisson's ratio, greater than -1 and less than 0.5. Used as `young` is.
    pub poisson: Option<Quantity<Poisson>>,
}
