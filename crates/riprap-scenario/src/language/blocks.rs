//! Blocks and generators of blocks.

use riprap_keys::{Keys, Words};
use schemars::JsonSchema;
use serde::Deserialize;

use super::files::{Polygons, Traces};
use super::joints::{CutAlong, JointPlanes, JointSet};
use super::masonry::{Dome, Masonry, Vault};
use super::points::Point;
use super::solids::{Brick, Grid, Mechanics, Mesh, Part, Polyhedron, Terrain};
use crate::quantity::{
    Angle, Axial, HalfAngle, InertiaPerLength, Length, MassPerLength, Moments, Name,
    NotNegativeLength, Plain, PositiveLength, Quantity, Spin, Vector, Velocity,
};

/// Most blocks that one generator may make.
pub(crate) const MAX_BLOCKS: u64 = 1_000_000;

/// One block or a generator of blocks.
#[expect(clippy::duplicated_attributes, reason = "two rules hold under one condition")]
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of(
    "polygon",
    "polygons",
    "rectangle",
    "regular",
    "wall",
    "arch",
    "cut@planar",
    "voronoi",
    "pour",
    "brick",
    "grid",
    "polyhedron",
    "parts",
    "mesh",
    "terrain",
    "masonry",
    "vault",
    "dome"
))]
#[keys(excludes(
    "cut",
    "copies",
    "mechanics",
    "rotate",
    "velocity",
    "spin",
    "mass",
    "inertia",
    when = "terrain",
    help = "terrain is one fixed body: leave them out"
))]
#[keys(excludes(
    "cut",
    "mechanics",
    when = "parts | mesh.glued",
    help = "a block of glued parts is rigid and stays whole: leave them out"
))]
#[keys(excludes(
    "mass",
    "inertia",
    when = "polygons | wall | arch | cut | voronoi | pour | grid | masonry | vault | dome | mesh & !mesh.glued",
    help = "they are those of one body: give the material its density, or write a [[blocks]] for each shape"
))]
#[keys(excludes(
    "mass",
    "inertia",
    when = "mechanics.deformable",
    help = "they are those of a rigid body: give the material its density"
))]
#[keys(excludes(
    "copies",
    when = "polygons | wall | arch | cut | voronoi | pour | grid | masonry | vault | dome | mesh & !mesh.glued",
    help = "`copies` is for single shapes; write another [[blocks]] with `shift`"
))]
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
    #[key(space = "planar", instead = "use `brick`, `grid` or `polyhedron`")]
    pub polygon: Option<Polygon>,
    /// Polygons of a drawing or a tessellation, each a block.
    #[key(space = "planar", instead = "use `mesh`")]
    pub polygons: Option<Polygons>,
    /// A rectangle with sides along x and y.
    #[key(space = "planar", instead = "use `brick`, `grid` or `polyhedron`")]
    pub rectangle: Option<Rectangle>,
    /// A regular polygon.
    #[key(space = "planar", instead = "use `brick`, `grid` or `polyhedron`")]
    pub regular: Option<Regular>,
    /// A wall of rectangular blocks.
    #[key(space = "planar", instead = "use `brick`, `grid` or `polyhedron`")]
    pub wall: Option<Wall>,
    /// A circular arch of wedge-shaped blocks.
    #[key(space = "planar", instead = "use `brick`, `grid` or `polyhedron`")]
    pub arch: Option<Arch>,
    /// Joints that divide: in the plane a region, in space every block of the shape beside it (`brick`,
    /// `grid`, `polyhedron` or `mesh`).
    pub cut: Option<Cut>,
    /// A region divided into random cells.
    #[key(space = "planar", instead = "use `brick`, `grid` or `polyhedron`")]
    pub voronoi: Option<Voronoi>,
    /// Random convex blocks, apart from each other, to be poured: polygons, in space Voronoi cells.
    pub pour: Option<Pour>,
    /// A box with faces normal to the axes.
    #[key(space = "spatial", instead = "use a polygon, for example `rectangle`")]
    pub brick: Option<Brick>,
    /// A region filled with equal bricks.
    #[key(space = "spatial", instead = "use `wall`, `cut` or `voronoi`")]
    pub grid: Option<Grid>,
    /// A convex polyhedron.
    #[key(space = "spatial", instead = "use `polygon`")]
    pub polyhedron: Option<Polyhedron>,
    /// One block that is not convex: convex parts that touch by faces.
    #[key(space = "spatial", instead = "use `polygon`")]
    pub parts: Option<Vec<Part>>,
    /// Cells of a mesh of Gmsh, a tessellation of Neper or surfaces in STL.
    #[key(space = "spatial", instead = "use `voronoi` or `cut`")]
    pub mesh: Option<Mesh>,
    /// A wall of bricks with openings.
    #[key(space = "spatial", instead = "use `wall`")]
    pub masonry: Option<Masonry>,
    /// A barrel vault or an arch of wedge-shaped stones.
    #[key(space = "spatial", instead = "use `arch`")]
    pub vault: Option<Vault>,
    /// A spherical dome of wedge-shaped stones.
    #[key(space = "spatial", instead = "use `arch`")]
    pub dome: Option<Dome>,
    /// Fixed ground with one height per place.
    #[key(space = "spatial", instead = "use a fixed `polygon`")]
    pub terrain: Option<Terrain>,
    /// How the blocks deform. Default rigid.
    #[key(space = "spatial", instead = "leave it out: blocks of the plane are rigid")]
    pub mechanics: Option<Mechanics>,
    /// Mass of a single rigid shape in place of density times volume, kg; in the plane kg/m. Its centre stays the centroid.
    pub mass: Option<Quantity<MassPerLength>>,
    /// Moments of inertia of a single rigid shape about its centroid, kg m2; in the plane one number, kg m. In space [xx, yy, zz, yz, zx, xy] with xx the sum of
    /// m (y^2 + z^2) and yz that of -m y z, in the axes of the scene before `rotate`, which turns them too. Default: those of the shape, times
    /// its mass.
    pub inertia: Option<Moments<InertiaPerLength>>,
    /// Repeats a single shape at equal steps.
    pub copies: Option<Copies>,
    /// Turns the shape after it was made; in space before `cut`.
    pub rotate: Option<Rotate>,
    /// Moves the shape after it was made and turned, m. Default no shift.
    pub shift: Option<Vector<Length>>,
    /// Velocity of the centroid at the start, m/s. Default at rest.
    pub velocity: Option<Vector<Velocity>>,
    /// Spin at the start, rad/s: in the plane anticlockwise, in space right-handed about x, y, z. Several blocks turn as one body about
    /// their common centroid, but for `copies` and `pour`, where each turns about its own. Default 0 rad/s.
    pub spin: Option<Axial<Spin>>,
}

/// The one geometry of a block, for a `match` without loose ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Geometry<'a> {
    /// `polygon`
    Polygon(&'a Polygon),
    /// `polygons`
    Polygons(&'a Polygons),
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
    /// `brick`
    Brick(&'a Brick),
    /// `grid`
    Grid(&'a Grid),
    /// `polyhedron`
    Polyhedron(&'a Polyhedron),
    /// `parts`
    Parts(&'a [Part]),
    /// `mesh`
    Mesh(&'a Mesh),
    /// `terrain`
    Terrain(&'a Terrain),
    /// `masonry`
    Masonry(&'a Masonry),
    /// `vault`
    Vault(&'a Vault),
    /// `dome`
    Dome(&'a Dome),
}

impl Geometry<'_> {
    /// Whether it makes several blocks.
    pub fn is_many(self) -> bool {
        match self {
            Geometry::Polygon(_)
            | Geometry::Rectangle(_)
            | Geometry::Regular(_)
            | Geometry::Brick(_)
            | Geometry::Polyhedron(_)
            | Geometry::Parts(_)
            | Geometry::Terrain(_) => false,
            Geometry::Wall(_)
            | Geometry::Arch(_)
            | Geometry::Cut(_)
            | Geometry::Voronoi(_)
            | Geometry::Pour(_)
            | Geometry::Polygons(_)
            | Geometry::Masonry(_)
            | Geometry::Vault(_)
            | Geometry::Dome(_)
            | Geometry::Grid(_) => true,
            Geometry::Mesh(mesh) => mesh.glued != Some(true),
        }
    }
}

impl Block {
    /// All geometry keys that were given; after a check without errors exactly one.
    pub fn geometries(&self) -> Vec<(&'static str, Geometry<'_>)> {
        [
            self.polygon.as_ref().map(|g| ("polygon", Geometry::Polygon(g))),
            self.polygons.as_ref().map(|g| ("polygons", Geometry::Polygons(g))),
            self.rectangle.as_ref().map(|g| ("rectangle", Geometry::Rectangle(g))),
            self.regular.as_ref().map(|g| ("regular", Geometry::Regular(g))),
            self.wall.as_ref().map(|g| ("wall", Geometry::Wall(g))),
            self.arch.as_ref().map(|g| ("arch", Geometry::Arch(g))),
            // In space it is no shape of its own.
            self.cut.as_ref().filter(|cut| cut.region.is_some()).map(|g| ("cut", Geometry::Cut(g))),
            self.voronoi.as_ref().map(|g| ("voronoi", Geometry::Voronoi(g))),
            self.pour.as_ref().map(|g| ("pour", Geometry::Pour(g))),
            self.brick.as_ref().map(|g| ("brick", Geometry::Brick(g))),
            self.grid.as_ref().map(|g| ("grid", Geometry::Grid(g))),
            self.polyhedron.as_ref().map(|g| ("polyhedron", Geometry::Polyhedron(g))),
            self.parts.as_ref().map(|g| ("parts", Geometry::Parts(g))),
            self.mesh.as_ref().map(|g| ("mesh", Geometry::Mesh(g))),
            self.terrain.as_ref().map(|g| ("terrain", Geometry::Terrain(g))),
            self.masonry.as_ref().map(|g| ("masonry", Geometry::Masonry(g))),
            self.vault.as_ref().map(|g| ("vault", Geometry::Vault(g))),
            self.dome.as_ref().map(|g| ("dome", Geometry::Dome(g))),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// Whether it makes blocks called name.1, name.2, ... instead of one called name.
    pub fn is_generator(&self) -> bool {
        self.geometry().is_some_and(Geometry::is_many)
            || self.copies.is_some()
            || self.cut.is_some()
    }

    /// The geometry, if exactly one was given.
    pub fn geometry(&self) -> Option<Geometry<'_>> {
        match self.geometries()[..] {
            [(_, geometry)] => Some(geometry),
            _ => None,
        }
    }
}

/// Corners of a polygon, in either sense of rotation.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Polygon {
    /// Corners [x, y], m, in order along the boundary; the last is joined to the first.
    Points(Vec<Point>),
    /// Path of a CSV file, with columns `x_m` and `y_m`.
    Csv(Name),
}

/// A rectangle with sides along x and y.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("corner", "centre"))]
pub struct Rectangle {
    /// Width and height, m.
    pub size: [Quantity<PositiveLength>; 2],
    /// Lower left corner [x, y], m.
    pub corner: Option<Point>,
    /// Centre [x, y], m.
    pub centre: Option<Point>,
}

/// A regular polygon standing on an edge.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Regular {
    /// Number of sides, 3 to 1000.
    #[key(min = 3, max = 1000)]
    pub sides: u32,
    /// Distance of the corners from the centre, m.
    pub radius: Quantity<PositiveLength>,
    /// Centre [x, y], m.
    pub centre: Point,
}

/// A wall of rectangular blocks.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// Lower left corner of the wall [x, y], m.
    pub corner: Point,
    /// Width and height of one block, m.
    pub block: [Quantity<PositiveLength>; 2],
    /// Number of rows, at least 1.
    #[key(min = 1, max = MAX_BLOCKS)]
    pub courses: u32,
    /// Number of whole blocks in a row, at least 1.
    #[key(min = 1, max = MAX_BLOCKS)]
    pub per_course: u32,
    /// How the rows stand on each other.
    #[key(default)]
    pub bond: Option<WallBond>,
    /// Whether every second row of a `running` wall is closed by half blocks at its ends.
    /// Default false.
    #[serde(default)]
    pub half_blocks: bool,
}

/// How rows of a wall stand on each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Words)]
pub enum WallBond {
    #[default]
    /// Every second row is shifted by half a block.
    Running,
    /// Blocks stand exactly on each other.
    Stack,
}

/// A circular arch.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
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
    #[key(min = 1, max = 100_000)]
    pub voussoirs: u32,
}

/// Joints that divide a region of the plane, or blocks in space: sets of them, or one by one.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(required(
    "region",
    space = "planar",
    help = "give the corners of the region to cut: region = [[\"0 m\", \"0 m\"], ...]"
))]
#[keys(any_of(
    "joint_sets",
    "traces",
    "joints",
    space = "planar",
    help = "add joint_sets = [{ dip = \"60 deg\", spacing = \"1 m\" }]"
))]
#[keys(any_of(
    "joint_sets",
    "joints",
    "along",
    space = "spatial",
    help = "add joint_sets = [{ dip = \"60 deg\", dip_direction = \"90 deg\", spacing = \"1 m\" }]"
))]
pub struct Cut {
    /// Corners of the region [x, y], m.
    #[key(
        space = "planar",
        instead = "give the shape beside `cut`: `brick`, `grid`, `polyhedron` or `mesh`"
    )]
    pub region: Option<Vec<Point>>,
    /// The sets of joints.
    #[serde(default)]
    pub joint_sets: Vec<JointSet>,
    /// Joints one by one, as they were mapped.
    #[key(space = "planar", instead = "use `joints`")]
    pub traces: Option<Traces>,
    /// Joints one by one: planes, or disks. They cut before the sets do.
    #[key(space = "spatial", instead = "use `traces`")]
    pub joints: Option<JointPlanes>,
    /// Excavations along whose surfaces the blocks are cut, after the joints, so that what is taken out leaves smooth walls.
    #[key(space = "spatial", instead = "use `traces`")]
    pub along: Option<CutAlong>,
    /// Seed of the random numbers: the same seed gives the same blocks.
    #[key(default = 1)]
    pub seed: Option<u64>,
    /// Blocks with a shorter edge are reported as slivers and healed where possible, m. In space a joint does not
    /// cut a block of which a thinner part would come off. Default: only reported, at 1/50 of the median edge.
    pub smallest_edge: Option<Quantity<NotNegativeLength>>,
}

/// A region divided into random (Voronoi) cells.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Voronoi {
    /// Corners of the region [x, y], m.
    pub region: Vec<Point>,
    /// Side of a square with the mean area of a cell, m.
    pub cell_size: Quantity<PositiveLength>,
    /// Seed of the random numbers: the same seed gives the same cells.
    #[key(default = 1)]
    pub seed: Option<u64>,
    /// Rounds of moving each seed point to the centroid of its cell: more rounds, more regular
    /// cells.
    #[key(default = 2, max = 1000)]
    pub relax: Option<u32>,
    /// Shorter edges are reported and healed where possible, m. Default: only reported.
    pub smallest_edge: Option<Quantity<NotNegativeLength>>,
}

/// Random convex blocks without overlap in a rectangle or a box, filled from below.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Pour {
    /// Lowest and highest corner, m.
    pub region: [Vector<Length>; 2],
    /// Number of blocks, at least 1.
    #[key(min = 1, max = MAX_BLOCKS)]
    pub count: u32,
    /// Smallest and largest diameter of a block, m.
    pub size: [Quantity<PositiveLength>; 2],
    /// Smallest and largest number of corners, each 3 to 100.
    #[key(default = [4, 7], space = "planar", instead = "leave it out: the cells have about 15 faces")]
    pub vertices: Option<[u32; 2]>,
    /// Seed of the random numbers: the same seed gives the same blocks.
    #[key(default = 1)]
    pub seed: Option<u64>,
}

/// Repeats a single shape.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Copies {
    /// Number of blocks in all, at least 1.
    #[key(min = 1, max = MAX_BLOCKS)]
    pub count: u32,
    /// From one block to the next, m.
    pub step: Vector<Length>,
}

/// Turns a shape by an angle; a brick whose edges leave the axes is a polyhedron.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("angle", "quaternion"))]
#[keys(one_of("axis", "dip_direction", when = "angle"))]
#[keys(excludes(
    "axis",
    "dip_direction",
    when = "quaternion",
    help = "a quaternion contains its axis: leave the others out"
))]
pub struct Rotate {
    /// Angle: in the plane anticlockwise, in space right-handed about `axis`.
    pub angle: Option<Quantity<Angle>>,
    /// The rotation as a quaternion [w, x, y, z], of any length: w is the cosine of half the angle, x, y and z are the axis times its
    /// sine.
    #[key(space = "spatial", instead = "use `angle`")]
    pub quaternion: Option<[Quantity<Plain>; 4]>,
    /// Axis [x, y, z], of any length.
    #[key(space = "spatial", instead = "leave it out: shapes turn in the plane")]
    pub axis: Option<[Quantity<Plain>; 3]>,
    /// Bearing, clockwise from north (y), to which what was level dips by `angle`.
    #[key(space = "spatial", instead = "leave it out: shapes turn in the plane")]
    pub dip_direction: Option<Quantity<Angle>>,
    /// Point that stays in place, m. Default: the centroid of the shape (of all blocks of a generator).
    pub about: Option<Vector<Length>>,
}
