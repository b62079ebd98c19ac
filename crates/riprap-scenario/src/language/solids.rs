//! Shapes of blocks in space, and places there.

use riprap_keys::{Keys, Words};
use schemars::JsonSchema;
use serde::Deserialize;

use super::points::Point3;
use super::sources::Around;
use crate::quantity::{
    Angle, Edges, Length, Name, NotNegativeLength, Plain, PositiveLength, Quantity, Span, Vector,
};
use riprap_core::laws::tetrahedron::Strain;

/// A box with faces normal to the axes.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("corner", "centre"))]
pub struct Brick {
    /// Lengths of the edges along x, y, z, m.
    pub size: [Quantity<PositiveLength>; 3],
    /// Corner with the lowest coordinates [x, y, z], m.
    pub corner: Option<Point3>,
    /// Centre [x, y, z], m.
    pub centre: Option<Point3>,
}

/// A region filled with equal bricks.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Grid {
    /// A box of bricks; x runs fastest, then y, then z.
    Box(Box<GridBox>),
    /// A box or a disk divided into convex cells: a turned lattice, or random ones.
    Cells(Box<GridCells>),
}

/// A box divided into the Voronoi cells of points: of a square lattice with `turned` or `site`, random ones otherwise. A box
/// about one cell thick has one layer: the cells of a plate are prisms.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(excludes(
    "seed",
    "relax",
    "smallest_edge",
    when = "turned | site",
    help = "`turned` and `site` make a lattice; the others belong to random cells"
))]
#[keys(excludes(
    "turned",
    "site",
    when = "graded",
    help = "`turned` and `site` make a lattice, `graded` random cells: leave one of them out"
))]
pub struct GridCells {
    /// Lengths of the edges of the whole box along x, y, z, m.
    pub size: [Quantity<PositiveLength>; 3],
    /// Edge of a cell, about, m.
    #[key(excludes(
        "graded",
        help = "cells have one size, or sizes that `graded` gives: leave one of them out"
    ))]
    #[key(required("!graded"))]
    pub cell: Option<Quantity<PositiveLength>>,
    /// Random cells that grow with the distance from charges or other places.
    pub graded: Option<Graded>,
    /// Corner with the lowest coordinates [x, y, z], m. Default the origin.
    pub corner: Option<Point3>,
    /// Angle by which the rows of a square lattice are turned about z.
    pub turned: Option<Quantity<Angle>>,
    /// Centre [x, y, z] of one cell of the lattice, m. Default the middle of the box.
    pub site: Option<Point3>,
    /// Seed of the random points.
    #[key(default = 1)]
    pub seed: Option<u64>,
    /// Lloyd iterations that make random cells more equal.
    #[key(default = 10, max = 1000)]
    pub relax: Option<u64>,
    /// Shortest edge of random cells, m: after `relax` points are moved until none is shorter. A tenth of `cell` can be had. Of `graded`
    /// cells it is that of the finest, and grows with them.
    #[key(default = "0 m")]
    pub smallest_edge: Option<Quantity<NotNegativeLength>>,
    /// Equal sides (3 to 1000) of a prism about z that touches the sides of the box and takes its place; many make a disk. One side is
    /// `y-max`; x and y edges of the box are equal. Default the box.
    #[key(min = 3, max = 1000)]
    pub sides: Option<u64>,
}

/// Random cells that are small at charges and other places and grow evenly with the distance from them. A charge among them gets room of
/// its volume, whose walls are regular: the cells along its axis, which the gas takes the place of.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Graded {
    /// Where cells are finest: the name of a source, a point [x, y, z], or a place. Default all sources that have a place of their own.
    pub at: Option<Around>,
    /// Edge of the finest cells, about, m. Default at charges: the diameter of the thinnest.
    pub from: Option<Quantity<PositiveLength>>,
    /// Edge of the other cells, about, m.
    pub to: Quantity<PositiveLength>,
    /// Distance over which it grows from one to the other, m.
    pub over: Quantity<PositiveLength>,
}

/// A box of bricks. The size must be whole cells.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(at_most_one("corner", "centre"))]
pub struct GridBox {
    /// Lengths of the edges of the whole box along x, y, z, m.
    pub size: [Quantity<PositiveLength>; 3],
    /// Edge of a cubic cell, or the three edges of a cell, m.
    pub cell: Edges<PositiveLength>,
    /// Corner with the lowest coordinates [x, y, z], m. Default the origin, without `centre`.
    pub corner: Option<Point3>,
    /// Centre of the box [x, y, z], m.
    pub centre: Option<Point3>,
}

/// A convex polyhedron: corners with faces, corners alone (their convex hull), or a file.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("vertices", "obj"))]
pub struct Polyhedron {
    /// Corners [x, y, z], m.
    pub vertices: Option<Vec<Point3>>,
    /// Corners of each face by their place in `vertices`, from 0, in order along its boundary.
    /// Default: the faces of the convex hull.
    #[key(needs("vertices", help = "give the corners too"))]
    pub faces: Option<Vec<Vec<u32>>>,
    /// Path of an OBJ file; coordinates in metres. Several closed parts are several blocks, as with `mesh.obj`.
    pub obj: Option<Name>,
}

/// A convex part of a block.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("brick", "polyhedron"))]
pub struct Part {
    /// A box with faces normal to the axes.
    pub brick: Option<Brick>,
    /// A convex polyhedron.
    pub polyhedron: Option<Polyhedron>,
}

/// Cells of a file, each a block.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("msh", "tess", "stl", "obj"))]
pub struct Mesh {
    /// A .msh file of Gmsh (4.1 or 2.2, text or binary): volume elements of first order (tetrahedra, hexahedra, prisms,
    /// pyramids). Physical volumes become groups of their blocks, physical surfaces groups of the blocks with a face in them and sets of
    /// faces (`on.surface`).
    pub msh: Option<Name>,
    /// Path of a tessellation of Neper in three dimensions.
    pub tess: Option<Name>,
    /// Path of an STL file (text or binary): each closed convex part is a block.
    pub stl: Option<Name>,
    /// Path of an OBJ file: each closed convex part of each object is a block. Names of objects (`o`), else of groups (`g`), become groups
    /// of their blocks.
    pub obj: Option<Name>,
    /// What the length 1 in the file stands for, m. Default 1 m.
    pub unit: Option<Quantity<PositiveLength>>,
    /// Name of the physical volume whose elements are taken. Default all.
    #[key(needs("msh", help = "only meshes of Gmsh have it: leave it out"))]
    pub volume: Option<Name>,
    /// Whether all cells are one block (`parts`).
    #[key(default = false)]
    pub glued: Option<bool>,
}

/// Fixed ground with one height per place; upright walls are bricks.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("asc", "csv", "stl"))]
pub struct Terrain {
    /// Path of an ASCII grid of ESRI.
    pub asc: Option<Name>,
    /// Path of a CSV file: `x_m`, `y_m`, `z_m` of a rectangular grid.
    pub csv: Option<Name>,
    /// Path of an STL file: one open surface.
    pub stl: Option<Name>,
    /// Length of 1 in the file.
    #[key(default = "1 m")]
    #[key(excludes("csv", help = "the columns of a CSV file have their units in their names"))]
    pub unit: Option<Quantity<PositiveLength>>,
}

/// How blocks deform.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mechanics {
    /// They do not: all deformation is in the joints. Write `rigid = {}`.
    Rigid(Empty),
    /// Each block is divided into tetrahedra and joined to its neighbours by bonds
    /// (`brittle_bond` of the interface). Write `deformable = {}`.
    Deformable(Box<Deformable>),
}

/// Deformable blocks.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Deformable {
    /// Measure of strain.
    #[key(default)]
    pub strain: Option<Strain>,
    /// Displacement of the nodes at the start along x, y, z: formulas in x, y, z (m), for
    /// example `["1e-4*x", "0", "0"]`. Default none.
    pub displacement: Option<[Name; 3]>,
    /// Velocity of the nodes at the start along x, y, z: formulas in x, y, z (m), m/s, added
    /// to `velocity` and `spin` of the block. Default none.
    pub velocity: Option<[Name; 3]>,
}

/// A table without keys: `{}`.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Empty {}

/// A box with sides along the axes.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct BoxRegion {
    /// Corner with the lowest coordinates, m.
    pub min: Vector<Length>,
    /// Corner with the highest coordinates, m.
    pub max: Vector<Length>,
}

/// A crack along faces of deformable blocks that is there at the start: a contact without strength, whose friction is that of
/// broken bonds.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Notch {
    /// What lies in this box, its surface included.
    #[serde(rename = "box")]
    pub region: BoxRegion,
    /// What is broken there.
    #[key(default)]
    pub breaks: Option<NotchBreaks>,
}

/// What a notch breaks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Words)]
pub enum NotchBreaks {
    /// The shared parts of faces whose centre lies in the box: the crack ends with them.
    #[default]
    Facets,
    /// Single springs in the box, those at the tip of the crack included, which belong to the next facets: about a third
    /// of a block longer.
    Springs,
}

/// A straight piece of a line.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Segment {
    /// One end [x, y, z], m; of a hole the side of the collar.
    pub from: Point3,
    /// Other end [x, y, z], m; of a hole the toe.
    pub to: Point3,
}

/// A plane.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// A point of it [x, y, z], m.
    pub at: Point3,
    /// Its normal [x, y, z], of any length.
    pub normal: [Quantity<Plain>; 3],
}

/// A ball.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Ball {
    /// Centre [x, y, z], m.
    pub centre: Point3,
    /// Radius, m.
    pub radius: Quantity<PositiveLength>,
}

/// Place of a point in the text.
pub fn span_of(point: &Point3) -> Span {
    point[0].span.start..point[2].span.end
}
