//! Bolts, cables, dowels and plates.

use riprap_keys::Keys;
use serde::Deserialize;

use crate::quantity::{
    BondStiffness, BondStrength, Length, Modulus, Name, NotNegativeAngle, PositiveArea,
    PositiveForce, PositiveLength, Quantity, ShareBelowOne, SpringStiffness, Vector,
};

/// A bolt, anchor or cable, or many alike: an axial bar in grout.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("head", "csv", "pattern", when = "!toe"))]
pub struct Bolt {
    /// Name; several are called name.1, name.2, ...
    pub name: Name,
    /// Where it enters the rock, on a face where it has a plate, m.
    #[key(needs("toe", help = "give both ends"))]
    pub head: Option<Vector<Length>>,
    /// Its end in the rock, m.
    #[key(needs("head", help = "give both ends"))]
    pub toe: Option<Vector<Length>>,
    /// Repeats it: rows of it, and rows of these.
    #[serde(default)]
    pub repeat: Vec<Repeat>,
    /// CSV file with columns `head_x`, `head_y`, `head_z`, `toe_x`, `toe_y`, `toe_z` (no z in the plane), each with its unit behind an underscore.
    #[key(excludes("repeat", help = "write all ends into the file"))]
    pub csv: Option<Name>,
    /// Bolts across the walls of an excavation.
    #[key(space = "spatial", instead = "use `repeat`")]
    #[key(excludes("repeat", help = "a pattern has rows of its own"))]
    pub pattern: Option<BoltPattern>,
    /// Only those whose collar lies in a block of this group or condition: `roof and not portal`.
    #[serde(rename = "where")]
    pub condition: Option<Name>,
    /// Distance of such bolts out of the plane, m; all numbers are those of one bolt.
    #[key(space = "planar")]
    #[key(default = "1 m")]
    pub spacing: Option<Quantity<PositiveLength>>,
    /// The bar.
    pub steel: Steel,
    /// What joins it to the rock.
    pub grout: Grout,
    /// Plate at the head: ties it to the rock.
    pub plate: Option<Plate>,
    /// Force to which the bar is stretched when it is installed, N.
    #[key(needs("plate", help = "a plate holds the stretched bar: add plate = {}"))]
    pub pretension: Option<Quantity<PositiveForce>>,
    /// Shear where it crosses joints. Default none.
    pub dowel: Option<Dowel>,
    /// Length of the pieces it is calculated in, m.
    #[key(default = "5 cm")]
    pub piece: Option<Quantity<PositiveLength>>,
    /// Phase at whose start it is installed, on the rock as it is then. Default the first.
    pub phase: Option<Name>,
}

/// A row of copies.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Repeat {
    /// From one to the next, m.
    pub step: Vector<Length>,
    /// How many there are in all.
    #[key(min = 1, max = 10_000)]
    pub count: u64,
}

/// Bolts at right angles to the walls of an excavation, in rows around its profile.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct BoltPattern {
    /// Name of a group with `excavation`.
    pub group: Name,
    /// Length of a bolt, m.
    pub length: Quantity<PositiveLength>,
    /// Distance between the bolts of a row along the wall, m.
    pub spacing: Quantity<PositiveLength>,
    /// Distance between rows along the line, m; the first is half of it from `from`, or in the middle of an opening that is shorter.
    pub rows: Quantity<PositiveLength>,
    /// Largest angle between the upward direction and a bolt: walls that face further down have none. Of benches only the faces have bolts.
    #[key(default = "135 deg")]
    pub half_angle: Option<Quantity<NotNegativeAngle>>,
}

/// The bar of a bolt.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("diameter", "area"))]
pub struct Steel {
    /// Diameter, m.
    pub diameter: Option<Quantity<PositiveLength>>,
    /// Cross-section, m2.
    pub area: Option<Quantity<PositiveArea>>,
    /// Young's modulus, Pa.
    #[key(default = "200 GPa")]
    pub young: Option<Quantity<Modulus>>,
    /// Axial force at which it yields, N. Default: it does not.
    pub yield_force: Option<Quantity<PositiveForce>>,
    /// Plastic modulus over Young's modulus; 0 for perfect plasticity.
    #[key(default = "0")]
    pub hardening: Option<Quantity<ShareBelowOne>>,
    /// Plastic elongation at one place at which it breaks, m. Default: it does not.
    #[key(needs("yield_force"))]
    pub rupture: Option<Quantity<PositiveLength>>,
}

/// The grout of a bolt.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Grout {
    /// Shear force per length of bolt and slip, N/m2.
    pub stiffness: Quantity<BondStiffness>,
    /// Largest shear force per length of bolt, N/m. Default: it does not slip.
    pub strength: Option<Quantity<BondStrength>>,
    /// Grouted length from the toe, m; the rest is free. Default all.
    pub length: Option<Quantity<PositiveLength>>,
}

/// The plate of a bolt.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Plate {
    /// Force at which it gives way, N. Default: it does not.
    pub capacity: Option<Quantity<PositiveForce>>,
}

/// Shear of a bolt across a joint.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Dowel {
    /// Shear force over shear displacement, N/m.
    pub stiffness: Quantity<SpringStiffness>,
    /// Largest shear force, N. Default: no limit.
    pub strength: Option<Quantity<PositiveForce>>,
}
