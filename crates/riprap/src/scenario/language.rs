//! The words of the scenario language, one struct a table.
//!
//! The doc comments are what the user reads: `riprap explain KEY`, the JSON schema that editors
//! use and the reference page are made from them. Every comment says what the key means, its
//! unit, its default and its range. A key without a value in the file is `None` here: defaults
//! belong to `model`, which can say where a number came from.
//!
//! Variants are keys (externally tagged), unknown keys are denied, nothing is flattened or
//! untagged: only so an error can point at the right place.

use schemars::JsonSchema;
use serde::Deserialize;

use super::quantity::{
    Acceleration, Angle, Any, Density, EnergyPerLength, ForcePerLength, FrictionAngle, HalfAngle,
    Interval, Kind, Length, Modulus, MomentPerLength, Name, Names, NotNegativeAngle,
    NotNegativeLength, NotNegativePlain, NotNegativeTime, NumberOrKey, Plain, Poisson,
    PositiveLength, PositivePlain, PositiveTime, Pressure, Quantity, Rate, Raw, Share,
    ShareBelowOne, Span, Speed, Spin, SpinAcceleration, StiffnessPerArea, Strength, Table,
    TimeStep, Velocity, When,
};
use super::time_function::{CsvFunction, TimeFunction};

/// A point of the plane: [x, y], x to the right, y up, m.
pub type Point = [Quantity<Length>; 2];

/// A scenario: everything that riprap needs to build, run and check one model.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Version of the scenario language. Write `riprap = 1`.
    pub riprap: u32,
    /// What the scene shows, in one line; stands over plots and reports.
    pub title: String,
    /// Longer text about the scene.
    pub description: Option<String>,
    /// `"SI"`: bare numbers are allowed and are SI (m, kg, s, N, Pa, rad). Without this key every
    /// value needs its unit.
    pub units: Option<Units>,
    /// All strengths of interfaces and joints (cohesion, tension, tangents of friction angles) are
    /// divided by this number, those of later phases too; greater than zero. The number at which
    /// the model fails, found by `riprap bisect`, is its factor of safety. Default 1.
    pub strength_factor: Option<Quantity<PositivePlain>>,
    /// The space in which the blocks move and the gravity that acts there.
    pub space: Space,
    /// Materials by name: density and, if wanted, elastic constants.
    pub materials: Table<Material>,
    /// Laws of contact by name. `default` is used by every pair of materials that no other
    /// interface names.
    #[serde(default)]
    pub interfaces: Table<Interface>,
    /// Blocks and generators of blocks.
    #[serde(default)]
    pub blocks: Vec<Block>,
    /// Blocks that are held or moved.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// Forces, pressures and moments on blocks.
    #[serde(default)]
    pub loads: Vec<Load>,
    /// The parts of the run, one after the other.
    #[serde(default)]
    pub phases: Vec<Phase>,
    /// What is written to the run folder besides the energy table.
    #[serde(default)]
    pub outputs: Vec<Output>,
    /// Values of keys to run through: the scene is run for every combination (`riprap sweep`).
    /// Keys are written with dots and in quotes, values in a list, for example
    /// `"interfaces.default.friction_angle" = ["0 deg", "5 deg"]`.
    #[serde(default)]
    #[schemars(with = "std::collections::BTreeMap<String, Vec<serde_json::Value>>")]
    pub sweep: Table<Vec<toml::Value>>,
    /// Named sets of changed keys: the scene is run once for each. The scene as it stands is the
    /// variant `default`.
    #[serde(default)]
    #[schemars(
        with = "std::collections::BTreeMap<String, std::collections::BTreeMap<String, serde_json::Value>>"
    )]
    pub variants: Table<Table<toml::Value>>,
    /// Search for the value of a key at which the scene fails (`riprap bisect`).
    pub bisect: Option<Bisect>,
    /// Numbers that the run must reproduce (`riprap verify`).
    #[serde(default)]
    pub checks: Vec<Check>,
}

/// System of units of bare numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
pub enum Units {
    /// m, kg, s, N, Pa, rad.
    #[serde(rename = "SI")]
    Si,
}

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

/// The law of contact between two materials.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interface {
    /// The two materials that meet, for example `["rock", "steel"]`. Required, except in
    /// `default`, where it is forbidden.
    pub between: Option<[Name; 2]>,
    /// Normal law of found contacts. Default `distance_potential`.
    pub law: Option<NormalLaw>,
    /// How `penetration_potential` treats a reflex (inward) corner. Default `min`.
    pub reflex: Option<Reflex>,
    /// Normal stiffness per area of contact, Pa/m; greater than zero. Default
    /// 10 (K + 4G/3)/L from `young` and `poisson` of the materials, L the median block size.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area of contact, Pa/m; greater than zero. Default half the normal one.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Angle of friction, at least 0 and less than 90 deg. Give this or `friction_coefficient`.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Tangent of the friction angle, zero or more. Give this or `friction_angle`.
    pub friction_coefficient: Option<Quantity<NotNegativePlain>>,
    /// Cohesion of found contacts, Pa; zero or more. Default 0 Pa.
    pub cohesion: Option<Quantity<Strength>>,
    /// Law of friction. Default `shear_spring`.
    pub friction_law: Option<FrictionLaw>,
    /// Slip speed below which `clipped` friction grows linearly, m/s. Needed by `clipped` only.
    pub clip_speed: Option<Quantity<Speed>>,
    /// Damping of the contact as a share of critical damping; zero or more. Default 0.2.
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
    /// Joins blocks that share an edge at the start with patches that can break.
    pub bond: Option<Bond>,
}

/// Normal law of a found contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NormalLaw {
    /// Potential of the true distance to the boundary; conserves energy.
    DistancePotential,
    /// Mutual penetration potentials, as in the source paper.
    PenetrationPotential,
}

/// Reading of the penetration depth at a reflex (inward) corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reflex {
    /// The smaller of the distances to the two edge lines.
    Min,
    /// The larger of the distances to the two edge lines.
    Max,
    /// The true distance to the corner.
    True,
}

/// Law of friction of found contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FrictionLaw {
    /// Shear spring with a Coulomb slider: a block can stand still on a slope.
    ShearSpring,
    /// Full friction against the direction of slip, as in the source paper.
    RateSign,
    /// Like `rate_sign`, but growing linearly up to `clip_speed`.
    Clipped,
}

/// Patches along edges that two blocks share at the start.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bond {
    /// Normal stiffness per area, Pa/m; greater than zero. Default that of the contact.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area, Pa/m; greater than zero. Default that of the contact.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Tensile strength, Pa; zero or more.
    pub tension: Quantity<Strength>,
    /// Cohesion, Pa; zero or more.
    pub cohesion: Quantity<Strength>,
    /// Angle of friction while unbroken, at least 0 and less than 90 deg. Default that of the
    /// contact.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Angle of friction once broken. Default `friction_angle`.
    pub residual_friction_angle: Option<Quantity<FrictionAngle>>,
    /// Cohesion left once broken, Pa; zero or more. Default 0 Pa.
    pub residual_cohesion: Option<Quantity<Strength>>,
    /// Damping as a share of critical damping; zero or more. Default 0.2.
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
    /// Points along a shared edge at which the law is evaluated, 1 to 5. Default 2.
    pub points: Option<u8>,
}

/// One block or a generator of blocks. Exactly one of `polygon`, `rectangle`, `regular`, `wall`,
/// `arch`, `cut`, `voronoi`, `pour`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Block {
    /// Name of the block, once in the file. Blocks of a generator or of `copies` are called
    /// name.1, name.2, ... and form the group `name`.
    pub name: Name,
    /// Further groups to which the block or all generated blocks belong.
    #[serde(default)]
    pub groups: Vec<Name>,
    /// Name of the material, from `[materials]`.
    pub material: Name,
    /// A polygon by its corners, in the file or from a CSV file.
    pub polygon: Option<Polygon>,
    /// A rectangle with sides along x and y.
    pub rectangle: Option<Rectangle>,
    /// A regular polygon.
    pub regular: Option<Regular>,
    /// A wall of rectangular blocks.
    pub wall: Option<Wall>,
    /// A circular arch of wedge-shaped blocks.
    pub arch: Option<Arch>,
    /// A region cut into blocks by sets of joints.
    pub cut: Option<Cut>,
    /// A region divided into random cells.
    pub voronoi: Option<Voronoi>,
    /// Random convex polygons, apart from each other, to be poured.
    pub pour: Option<Pour>,
    /// Repeats a single shape at equal steps.
    pub copies: Option<Copies>,
    /// Turns the shape after it was made.
    pub rotate: Option<Rotate>,
    /// Moves the shape after it was made and turned: [x, y], m. Default no shift.
    pub shift: Option<Point>,
    /// Velocity of the centroid at the start [x, y], m/s. Default at rest.
    pub velocity: Option<[Quantity<Velocity>; 2]>,
    /// Spin at the start, rad/s, anticlockwise. Default 0 rad/s.
    pub spin: Option<Quantity<Spin>>,
}

/// The one geometry of a block, for a `match` without loose ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Geometry<'a> {
    /// `polygon`
    Polygon(&'a Polygon),
    /// `rectangle`
    Rectangle(&'a Rectangle),
    /// `regular`
    Regular(&'a Regular),
    /// `wall`
    Wall(&'a Wall),
    /// `arch`
    Arch(&'a Arch),
    /// `cut`
    Cut(&'a Cut),
    /// `voronoi`
    Voronoi(&'a Voronoi),
    /// `pour`
    Pour(&'a Pour),
}

impl Block {
    /// All geometry keys that were given; after a check without errors exactly one.
    pub fn geometries(&self) -> Vec<(&'static str, Geometry<'_>)> {
        [
            self.polygon
                .as_ref()
                .map(|g| ("polygon", Geometry::Polygon(g))),
            self.rectangle
                .as_ref()
                .map(|g| ("rectangle", Geometry::Rectangle(g))),
            self.regular
                .as_ref()
                .map(|g| ("regular", Geometry::Regular(g))),
            self.wall.as_ref().map(|g| ("wall", Geometry::Wall(g))),
            self.arch.as_ref().map(|g| ("arch", Geometry::Arch(g))),
            self.cut.as_ref().map(|g| ("cut", Geometry::Cut(g))),
            self.voronoi
                .as_ref()
                .map(|g| ("voronoi", Geometry::Voronoi(g))),
            self.pour.as_ref().map(|g| ("pour", Geometry::Pour(g))),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// Whether it makes blocks called name.1, name.2, ... instead of one called name.
    pub fn is_generator(&self) -> bool {
        let many = match self.geometry() {
            Some(Geometry::Polygon(_) | Geometry::Rectangle(_) | Geometry::Regular(_)) | None => {
                false
            }
            Some(
                Geometry::Wall(_)
                | Geometry::Arch(_)
                | Geometry::Cut(_)
                | Geometry::Voronoi(_)
                | Geometry::Pour(_),
            ) => true,
        };
        many || self.copies.is_some()
    }

    /// The geometry, if exactly one was given.
    pub fn geometry(&self) -> Option<Geometry<'_>> {
        match self.geometries()[..] {
            [(_, geometry)] => Some(geometry),
            _ => None,
        }
    }
}

/// Corners of a polygon, in either sense of rotation. Exactly one form.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Polygon {
    /// Corners [x, y], m, in order along the boundary; the last is joined to the first.
    Points(Vec<Point>),
    /// Path of a CSV file, seen from the scenario file, with columns `x_m` and `y_m`.
    Csv(Name),
}

/// A rectangle with sides along x and y. Give `corner` or `centre`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// Width and height, m.
    pub size: [Quantity<PositiveLength>; 2],
    /// Lower left corner [x, y], m.
    pub corner: Option<Point>,
    /// Centre [x, y], m.
    pub centre: Option<Point>,
}

/// A regular polygon standing on an edge.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Regular {
    /// Number of sides, 3 to 1000.
    pub sides: u32,
    /// Distance of the corners from the centre, m.
    pub radius: Quantity<PositiveLength>,
    /// Centre [x, y], m.
    pub centre: Point,
}

/// A wall of rectangular blocks.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// Lower left corner of the wall [x, y], m.
    pub corner: Point,
    /// Width and height of one block, m.
    pub block: [Quantity<PositiveLength>; 2],
    /// Number of rows, at least 1.
    pub courses: u32,
    /// Number of whole blocks in a row, at least 1.
    pub per_course: u32,
    /// How the rows stand on each other. Default `running`.
    pub bond: Option<WallBond>,
    /// Whether every second row of a `running` wall is closed by half blocks at its ends.
    /// Default false.
    #[serde(default)]
    pub half_blocks: bool,
}

/// How rows of a wall stand on each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WallBond {
    /// Every second row is shifted by half a block.
    Running,
    /// Blocks stand exactly on each other.
    Stack,
}

/// A circular arch.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arch {
    /// Centre of the circle [x, y], m.
    pub centre: Point,
    /// Radius of the centre line, m.
    pub radius: Quantity<PositiveLength>,
    /// Thickness of the ring, m; less than twice the radius.
    pub thickness: Quantity<PositiveLength>,
    /// Angle from the crown to a springing: 90 deg is a half circle.
    pub half_angle: Quantity<HalfAngle>,
    /// Number of blocks (voussoirs), at least 1.
    pub voussoirs: u32,
}

/// A region cut into blocks by sets of joints.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cut {
    /// Corners of the region [x, y], m.
    pub region: Vec<Point>,
    /// The sets of joints.
    pub joint_sets: Vec<JointSet>,
    /// Seed of the random numbers: the same seed gives the same blocks. Default 1.
    pub seed: Option<u64>,
    /// Blocks with a shorter edge are reported as slivers and healed where possible, m.
    /// Default: only reported, at 1/50 of the median edge.
    pub smallest_edge: Option<Quantity<NotNegativeLength>>,
}

/// A set of parallel joints.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointSet {
    /// Angle of the traces, anticlockwise from the x axis.
    pub dip: Quantity<Angle>,
    /// Distance between neighbours, measured across the joints, m.
    pub spacing: Quantity<PositiveLength>,
    /// Standard deviation of the spacing, m. Default 0 m.
    pub spacing_scatter: Option<Quantity<NotNegativeLength>>,
    /// Standard deviation of the angle. Default 0 deg.
    pub angle_scatter: Option<Quantity<NotNegativeAngle>>,
    /// Share of the length of a trace that is cut; 1 is fully persistent. Default 1.
    pub persistence: Option<Quantity<Share>>,
    /// Mean length of one cut piece when `persistence` is less than 1, m.
    pub trace_length: Option<Quantity<PositiveLength>>,
    /// Shifts the whole set across the joints, m. Default 0 m.
    pub offset: Option<Quantity<Length>>,
}

/// A region divided into random (Voronoi) cells.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Voronoi {
    /// Corners of the region [x, y], m.
    pub region: Vec<Point>,
    /// Side of a square with the mean area of a cell, m.
    pub cell_size: Quantity<PositiveLength>,
    /// Seed of the random numbers: the same seed gives the same cells. Default 1.
    pub seed: Option<u64>,
    /// Rounds of moving each seed point to the centroid of its cell: more rounds, more regular
    /// cells. Default 2.
    pub relax: Option<u32>,
    /// Shorter edges are reported and healed where possible, m. Default: only reported.
    pub smallest_edge: Option<Quantity<NotNegativeLength>>,
}

/// Random convex polygons without overlap in a rectangle.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pour {
    /// Lower left and upper right corner of the rectangle, m.
    pub region: [Point; 2],
    /// Number of blocks, at least 1.
    pub count: u32,
    /// Smallest and largest diameter of a block, m.
    pub size: [Quantity<PositiveLength>; 2],
    /// Smallest and largest number of corners, each 3 to 100. Default [4, 7].
    pub vertices: Option<[u32; 2]>,
    /// Seed of the random numbers: the same seed gives the same blocks. Default 1.
    pub seed: Option<u64>,
}

/// Repeats a single shape.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Copies {
    /// Number of blocks in all, at least 1.
    pub count: u32,
    /// From one block to the next [x, y], m.
    pub step: Point,
}

/// Turns a shape.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rotate {
    /// Angle, anticlockwise.
    pub angle: Quantity<Angle>,
    /// Point that stays in place [x, y], m. Default: the centroid of the shape (of all blocks of
    /// a generator).
    pub about: Option<Point>,
}

/// Which blocks. Exactly one form.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Target {
    /// One block by name, or all blocks of a generator.
    Block(Name),
    /// All blocks of a group.
    Group(Name),
    /// Several blocks by name.
    Blocks(Vec<Name>),
}

/// Blocks that are held or moved. Exactly one of `fixed` and `motion`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Which blocks.
    pub on: Target,
    /// Holds the blocks; `fixed = {}` holds all directions.
    pub fixed: Option<Fixed>,
    /// Moves the blocks as prescribed.
    pub motion: Option<Motion>,
}

/// Directions that are held.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fixed {
    /// Whether the block is held along x. Default true.
    #[serde(default = "yes")]
    pub x: bool,
    /// Whether the block is held along y. Default true.
    #[serde(default = "yes")]
    pub y: bool,
    /// Whether the block is kept from turning. Default true.
    #[serde(default = "yes")]
    pub rotation: bool,
}

fn yes() -> bool {
    true
}

/// Prescribed motion. Exactly one form.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// Velocity over time.
    Velocity(MotionComponents<Velocity, Spin>),
    /// Acceleration over time, starting from the velocity at the start (shaking).
    Acceleration(MotionComponents<Acceleration, SpinAcceleration>),
}

/// Components of a prescribed motion; a component that is not given is free.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, bound(deserialize = "L: Kind, R: Kind"))]
pub struct MotionComponents<L: Kind, R: Kind> {
    /// Along x.
    pub x: Option<TimeFunction<L>>,
    /// Along y.
    pub y: Option<TimeFunction<L>>,
    /// Turning, anticlockwise.
    pub spin: Option<TimeFunction<R>>,
}

/// A load. Exactly one of `point`, `edge`, `moment`, `body`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Which blocks.
    pub on: Target,
    /// A force at a point.
    pub point: Option<PointLoad>,
    /// A pressure or traction along a part of the boundary, for example water in a joint.
    pub edge: Option<EdgeLoad>,
    /// A moment per metre of thickness, N (= N m/m), anticlockwise.
    pub moment: Option<Quantity<MomentPerLength>>,
    /// A force on the mass, given as an acceleration.
    pub body: Option<BodyLoad>,
    /// Factor over time, a number without unit. Default constant 1.
    pub time: Option<TimeFunction<Plain>>,
}

/// A force at a point.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointLoad {
    /// Force per metre of thickness [x, y], N/m.
    pub force: [Quantity<ForcePerLength>; 2],
    /// Where it acts at the start [x, y], m; the point travels with the block. Default the
    /// centroid.
    pub at: Option<Point>,
    /// Whether the direction turns with the block. Default false.
    #[serde(default)]
    pub follows: bool,
}

/// A pressure or traction between two points of the boundary. Exactly one of `pressure` and
/// `traction`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
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
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyLoad {
    /// Force per mass [x, y], m/s2.
    pub acceleration: [Quantity<Acceleration>; 2],
}

/// A part of the run.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Phase {
    /// Name of the phase, once in the file.
    pub name: Name,
    /// How the phase is calculated. Default `dynamic`.
    pub kind: Option<PhaseKind>,
    /// When the phase ends: the first condition that is reached.
    pub until: Until,
    /// Time step, s. Default automatic: `safety` times the stable one.
    pub time_step: Option<Quantity<TimeStep>>,
    /// Share of the stable time step that is used when `time_step` is not given, greater than 0
    /// and at most 1. Default 0.2.
    pub safety: Option<Quantity<Share>>,
    /// Damping of the motion besides that of the contacts. Default none in a `dynamic` phase.
    pub damping: Option<Damping>,
    /// Groups or blocks that are taken away when the phase begins.
    #[serde(default)]
    pub remove: Vec<Name>,
    /// Groups or blocks that are fixed when the phase begins.
    #[serde(default)]
    pub fix: Vec<Name>,
    /// Groups or blocks whose supports are taken away when the phase begins.
    #[serde(default)]
    pub release: Vec<Name>,
    /// Gravity from this phase on [x, y], m/s2. Default unchanged.
    pub gravity: Option<[Quantity<Acceleration>; 2]>,
    /// Time over which gravity grows from its old value (zero in the first phase), s.
    /// Default 0 s: at once.
    pub gravity_ramp: Option<Quantity<NotNegativeTime>>,
    /// What is set to zero when the phase begins.
    #[serde(default)]
    pub reset: Vec<Reset>,
    /// Interfaces that change from this phase on, by name.
    #[serde(default)]
    pub interfaces: Table<InterfaceChange>,
}

/// How a phase is calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PhaseKind {
    /// Towards rest, with automatic damping (dynamic relaxation); time has no meaning.
    Static,
    /// Motion in time.
    Dynamic,
}

/// End of a phase; at least one condition, the first that is reached counts.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Until {
    /// Duration of the phase in model time, s.
    pub time: Option<Quantity<PositiveTime>>,
    /// Ratio of unbalanced to applied forces, for example 1e-5; greater than zero.
    pub unbalanced: Option<Quantity<PositivePlain>>,
    /// Kinetic energy of all blocks per metre of thickness, J/m.
    pub kinetic: Option<Quantity<EnergyPerLength>>,
    /// Number of steps, at least 1.
    pub steps: Option<u64>,
}

/// Damping of the motion of blocks.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Damping {
    /// Force against the velocity, proportional to mass, 1/s; zero or more. Default 0 1/s.
    pub mass: Option<Quantity<Rate>>,
    /// Proportional to contact stiffness, s; zero or more. Default 0 s.
    pub stiffness: Option<Quantity<NotNegativeTime>>,
    /// Share of the unbalanced force taken off, against the motion; at least 0, less than 1.
    /// Default 0. For static questions.
    pub local: Option<Quantity<ShareBelowOne>>,
}

/// What a phase can set to zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reset {
    /// Velocities and spins of all blocks.
    Velocities,
    /// Displacements and rotations of all blocks as outputs report them.
    Displacements,
}

/// Keys of an interface that change when a phase begins; all others stay.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterfaceChange {
    /// Normal law of found contacts.
    pub law: Option<NormalLaw>,
    /// How `penetration_potential` treats a reflex (inward) corner.
    pub reflex: Option<Reflex>,
    /// Normal stiffness per area of contact, Pa/m; greater than zero.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area of contact, Pa/m; greater than zero.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Angle of friction, at least 0 and less than 90 deg.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Tangent of the friction angle, zero or more.
    pub friction_coefficient: Option<Quantity<NotNegativePlain>>,
    /// Cohesion of found contacts, Pa; zero or more.
    pub cohesion: Option<Quantity<Strength>>,
    /// Law of friction.
    pub friction_law: Option<FrictionLaw>,
    /// Slip speed below which `clipped` friction grows linearly, m/s.
    pub clip_speed: Option<Quantity<Speed>>,
    /// Damping of the contact as a share of critical damping; zero or more.
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
}

/// Something that is written to the run folder. Exactly one form.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Output {
    /// A column of `histories.csv`.
    History(History),
    /// Pictures of the whole model for ParaView.
    Frames(Schedule),
    /// States from which a run can be resumed; there is always one at the end of a phase.
    Checkpoints(Schedule),
}

/// A column of `histories.csv`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct History {
    /// Name of the column, once in the file.
    pub name: Name,
    /// Field, for example `block.displacement`; `riprap fields` lists them.
    pub field: Name,
    /// Block, or the two blocks of a pair, or a group. Not for fields of the whole model.
    pub of: Option<Names>,
    /// Direction in which a vector is measured, anticlockwise from the x axis.
    pub along: Option<Quantity<Angle>>,
    /// How often, for example `"1 ms"` or `"10 steps"`.
    pub every: Every,
}

/// How often.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Schedule {
    /// How often, for example `"50 ms"`, `"10 steps"` or `"1 phase"`.
    pub every: Every,
}

/// An interval: model time (`"1 ms"`), steps (`"10 steps"`), `"1 phase"` or `"never"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Every {
    /// What was written.
    pub raw: Raw,
    /// Where.
    pub span: Span,
}

impl Every {
    /// The interval; `Never` where a check reports an error.
    pub fn read(&self) -> Interval {
        Interval::read(&self.raw).unwrap_or(Interval::Never)
    }
}

/// A moment: model time (`"1.5 s"`), `"start"` or `"end"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// What was written.
    pub raw: Raw,
    /// Where.
    pub span: Span,
}

impl Moment {
    /// The moment; `End` where a check reports an error.
    pub fn read(&self) -> When {
        When::read(&self.raw, true).unwrap_or(When::End)
    }
}

macro_rules! raw_with_place {
    ($name:ident, $description:literal) => {
        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let raw = toml::Spanned::<Raw>::deserialize(deserializer)?;
                let span = raw.span();
                Ok($name { raw: raw.into_inner(), span })
            }
        }
        impl JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!({ "type": ["string", "number"], "description": $description })
            }
        }
    };
}

raw_with_place!(
    Every,
    "A time (\"1 ms\"), a number of steps (\"10 steps\"), \"1 phase\" or \"never\"."
);
raw_with_place!(Moment, "A time (\"1.5 s\"), \"start\" or \"end\".");

/// Search for the value of a key at which the scene begins to fail.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bisect {
    /// Key with dots, for example `interfaces.default.friction_angle`.
    pub key: Name,
    /// One end of the interval, with the unit of the key.
    pub low: Quantity<Any>,
    /// Other end of the interval.
    pub high: Quantity<Any>,
    /// Width of the interval at which the search stops.
    pub tolerance: Quantity<Any>,
    /// What counts as failure, evaluated at the end of the run.
    pub fails_when: Criterion,
}

/// A field compared with a limit. Exactly one of `above` and `below`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Criterion {
    /// Field, for example `model.max_displacement`.
    pub field: Name,
    /// Block, or the two blocks of a pair, or a group. Not for fields of the whole model.
    pub of: Option<Names>,
    /// Direction in which a vector is measured, anticlockwise from the x axis.
    pub along: Option<Quantity<Angle>>,
    /// How values over the whole run become one number. Default: the value at the end.
    pub reduce: Option<Reduce>,
    /// Fails if the number is larger.
    pub above: Option<Quantity<Any>>,
    /// Fails if the number is smaller.
    pub below: Option<Quantity<Any>>,
}

/// A number that the run must reproduce. Exactly one of `value`, `formula`, `csv`, `between`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// What is checked, in words; printed by `riprap verify`.
    pub name: Name,
    /// Field, for example `block.displacement`; `riprap fields` lists them.
    pub field: Name,
    /// Block, or the two blocks of a pair, or a group. Not for fields of the whole model.
    pub of: Option<Names>,
    /// Direction in which a vector is measured, anticlockwise from the x axis.
    pub along: Option<Quantity<Angle>>,
    /// Moment of the check: a time, `"start"` or `"end"`. Default `"end"`. Not with `over`.
    pub at: Option<Moment>,
    /// First and last time of an interval, s. Default the whole run, if `reduce` is given.
    pub over: Option<[Quantity<NotNegativeTime>; 2]>,
    /// How values over an interval become one number. Needed with `over`.
    pub reduce: Option<Reduce>,
    /// Limit for `first_above` and `share_above`, in the unit of the field.
    pub threshold: Option<Quantity<Any>>,
    /// Expected number, in the unit of the field.
    pub value: Option<Quantity<Any>>,
    /// Expected number as a formula, result in SI units. Names: `t` (s), `pi`, `deg`, and those
    /// of `let`. Example: `"0.5*g*t^2"`.
    pub formula: Option<Name>,
    /// Expected numbers from a column of a CSV file.
    pub csv: Option<CsvFunction>,
    /// Lowest and highest allowed number, in the unit of the field.
    pub between: Option<[Quantity<Any>; 2]>,
    /// Names for the formula: a number, a value with unit, or a key of the scenario whose SI
    /// value is taken, for example `{ phi = "interfaces.default.friction_angle", g = 9.81 }`.
    #[serde(default, rename = "let")]
    pub names: Table<Quantity<NumberOrKey>>,
    /// Allowed difference as a share of the expected number. With `absolute`, either is enough.
    pub relative: Option<Quantity<NotNegativePlain>>,
    /// Allowed difference, in the unit of the field.
    pub absolute: Option<Quantity<Any>>,
    /// Only in cases of a sweep where these keys have one of these values.
    #[serde(default)]
    #[schemars(with = "std::collections::BTreeMap<String, Vec<serde_json::Value>>")]
    pub when: Table<Vec<toml::Value>>,
    /// Only in these variants. Default all.
    #[serde(default)]
    pub only: Vec<Name>,
    /// Reason why this check is known to fail: it is run and shown, but does not count as failed.
    pub known: Option<Name>,
    /// The quantity is exact or conserved: the check can't be marked `known`. Default false.
    #[serde(default)]
    pub exact: bool,
}

/// How values over an interval become one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reduce {
    /// Largest value.
    Max,
    /// Smallest value.
    Min,
    /// Mean over time.
    Mean,
    /// Largest less smallest value.
    Range,
    /// First time at which the value is above `threshold`, s.
    FirstAbove,
    /// Share of the time during which the value is above `threshold`.
    ShareAbove,
}
