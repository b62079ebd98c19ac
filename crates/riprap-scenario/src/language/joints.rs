//! Joints that divide blocks: sets of them, and one by one in space.

use riprap_keys::Keys;
use serde::Deserialize;

use super::points::Point3;
use crate::quantity::{
    Angle, Length, Name, NotNegativeAngle, NotNegativeLength, PositiveLength, Quantity, Share,
};

/// A set of parallel joints.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct JointSet {
    /// In the plane the angle of the traces, anticlockwise from the x axis; in space the angle of the planes below the
    /// horizontal.
    pub dip: Quantity<Angle>,
    /// Bearing of the line of dip: clockwise from north (y) seen from above.
    #[key(space = "spatial", instead = "give `dip` alone")]
    #[key(required(
        space = "spatial",
        help = "write for example dip_direction = \"90 deg\": dipping to the east (x)"
    ))]
    pub dip_direction: Option<Quantity<Angle>>,
    /// Distance between neighbours, measured across the joints, m.
    pub spacing: Quantity<PositiveLength>,
    /// Standard deviation of the spacing, m.
    #[key(default = "0 m")]
    pub spacing_scatter: Option<Quantity<NotNegativeLength>>,
    /// Standard deviation of the angle; in space of the normal about each of two axes.
    #[key(default = "0 deg")]
    pub angle_scatter: Option<Quantity<NotNegativeAngle>>,
    /// Share of the length of a trace that is cut, in space chance of each block that a joint meets to be cut; 1 is fully persistent.
    #[key(default = "1")]
    pub persistence: Option<Quantity<Share>>,
    /// Mean length of one cut piece when `persistence` is less than 1, m.
    #[key(space = "planar", instead = "give `persistence` alone: joints end at others")]
    pub trace_length: Option<Quantity<PositiveLength>>,
    /// A point [x, y, z] through which a joint of the set goes, m. Default the origin.
    #[key(space = "spatial", instead = "use `offset`")]
    pub origin: Option<Point3>,
    /// Shifts the whole set across the joints, in space upwards, m.
    #[key(default = "0 m")]
    pub offset: Option<Quantity<Length>>,
}

/// Joints in space.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("csv", "fab", "dfnworks", "itasca"))]
pub struct JointPlanes {
    /// Path of a CSV file, a joint in each row (`x_m`, `y_m`, `z_m`, `dip_deg`, `dip_direction_deg`, perhaps `radius_m`) or a corner
    /// of a polygon (`fracture`, `x_m`, `y_m`, `z_m`); others: `coming-from-3dec.md`. Disks and polygons cut the blocks that they
    /// touch, all through; others every block.
    pub csv: Option<Name>,
    /// Path of a network of FracMan (`.fab`): its polygons; surfaces of triangles are left out.
    pub fab: Option<Name>,
    /// Path of `polygons.dat` of dfnWorks; or of its `radii_Final.dat`, `radii.dat`, `normal_vectors.dat` or `translations.dat`,
    /// which are then read together, as ellipses and rectangles; or of their folder, whose `polygons.dat` goes first.
    pub dfnworks: Option<Name>,
    /// Path of a network in space as 3DEC and PFC3D write it with `fracture export` (`.dat`): disks and polygons.
    pub itasca: Option<Name>,
    /// What the length 1 in the file stands for, m. Default as the file says (`Length_Unit`), else 1 m.
    #[key(excludes("csv", help = "the columns of a CSV file have their units in their names"))]
    pub unit: Option<Quantity<PositiveLength>>,
    /// Interface of rock bridges, the parts of cuts beyond disks and polygons.
    pub bridges: Option<Name>,
}

/// Surfaces of excavations along which rock is cut.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct CutAlong {
    /// Groups with `excavation`, `box`, `half_space` or `prism`.
    pub groups: Vec<Name>,
    /// Interface of the cuts, which is rock that is still whole: of the surfaces, and of their planes beyond, so far as blocks
    /// there are cut through. Default that of the materials.
    pub interface: Option<Name>,
}
