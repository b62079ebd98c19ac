//! What the evaluation of contacts between blocks of cells works with; can be dropped and laid out anew without changing a result.
//!
//! A block is a set of [`Cell`]s: tetrahedra that carry its depth, which at the start is the distance from the nearest face
//! ([`DepthCells`]). So every face has slope one and presses like that of a rigid block, whatever the shape of the block. The corners of the cells
//! move with the material, and the depth at them stays.
//! Deviation from a depth over several layers of elements: these blocks have one.

use std::ops::Range;

use riprap_geom::Vec3;
use riprap_geom::polyhedron::DepthCells;

use crate::kernel::friction::ContactLaw;
use crate::kernel::grid::{Box3, Grid};
use crate::kernel::tetra::{Cell, Piece, Workspace as Overlapping};

/// A block now.
#[derive(Clone, Debug)]
pub struct TetFan {
    /// Its centre, m; cells are about it.
    pub origin: Vec3,
    /// Box around it.
    pub bounds: Box3,
    /// Its cells in their order; one that is inside out meets nothing.
    pub cells: Vec<Cell>,
    /// Boxes of the cells.
    pub boxes: Vec<Box3>,
    /// Key of the contact that each cell belongs to: the facet of terrain. Empty where the block has one contact with another.
    pub keys: Vec<u32>,
    /// Whether no tetrahedron of the block is inside out.
    pub sound: bool,
    /// Where the points of the cells are that are no nodes, m.
    pub(super) points: Vec<Vec3>,
}

impl Default for TetFan {
    fn default() -> Self {
        Self {
            origin: Vec3::ZERO,
            bounds: Box3::EMPTY,
            cells: Vec::new(),
            boxes: Vec::new(),
            keys: Vec::new(),
            sound: true,
            points: Vec::new(),
        }
    }
}

impl TetFan {
    /// Puts the cells of a block, whose nodes are at `place` (m) now, in their places; of one that bends, `tets` are the tetrahedra.
    pub fn put(
        &mut self,
        field: &DepthCells,
        tets: &[[u32; 4]],
        origin: Vec3,
        place: impl Fn(u32) -> Vec3,
    ) {
        self.origin = origin;
        self.bounds = Box3::EMPTY;
        self.cells.clear();
        self.boxes.clear();
        self.points.clear();
        for point in &field.points {
            let shares = point.nodes.into_iter().zip(point.weights);
            self.points.push(shares.map(|(node, w)| w * place(node)).sum());
        }
        let nodes = field.depths.len() - field.points.len();
        for corners in &field.cells {
            let places = corners.map(|k| match (k as usize).checked_sub(nodes) {
                None => place(k),
                Some(point) => self.points[point],
            });
            let depths = corners.map(|k| field.depths[k as usize]);
            let cell = Cell::new(places.map(|at| at - origin), depths);
            self.push(places, cell);
        }
        // A thin cell may fold where its block is only bent: what counts is the block.
        self.sound = tets.iter().all(|tet| {
            let [a, b, c, d] = tet.map(&place);
            (b - a).dot((c - a).cross(d - a)) > 0.0
        });
    }

    /// Adds a cell with these corners (m); `None` where it is inside out.
    pub fn push(&mut self, places: [Vec3; 4], cell: Option<Cell>) {
        let mut around = Box3::EMPTY;
        for at in places {
            around.low = around.low.min(at);
            around.high = around.high.max(at);
        }
        self.bounds.low = self.bounds.low.min(around.low);
        self.bounds.high = self.bounds.high.max(around.high);
        self.boxes.push(around);
        self.cells.push(cell.unwrap_or_default());
    }
}

/// What is the same in all steps for a block that is in a pair.
#[derive(Debug)]
pub struct Member {
    /// The block.
    pub block: u32,
    /// Its place among the deformable ones; `None` for a rigid one.
    pub body: Option<u32>,
    /// Cells of a rigid block about its centroid, and the places of their nodes, m.
    pub rigid: Option<(DepthCells, Vec<Vec3>)>,
    /// Least distance of its centre from a face, m: the half cell of its stiffness.
    pub half: f64,
    /// Largest depth in it, m.
    pub peak: f64,
    /// Area of its largest face, m².
    pub largest: f64,
    /// Area that each node of a deformable block stands for, m².
    pub areas: Vec<f64>,
    /// Of a deformable block the largest ratio of such an area to the mass of the node, m²/kg; of a rigid one 1 over its mass, 1/kg, 0
    /// where nothing can move it.
    pub ease: f64,
    /// Bound of the square of the frequency of a deformable block by itself, 1/s².
    pub own: f64,
}

/// What is the same in all steps for a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairConstants {
    /// The law.
    pub law: ContactLaw,
    /// Places of the blocks among the members.
    pub members: [u32; 2],
    /// The smaller one of the largest depths in the blocks, m; on terrain that of the block.
    pub peak: f64,
    /// Place of the terrain among all, of a block on it.
    pub ground: Option<u32>,
}

/// A point at which friction and dashpots of a contact act.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// Key of the contact that it belongs to.
    pub key: u32,
    /// Cells of both blocks.
    pub cells: [u32; 2],
    /// Shape functions of their corners there.
    pub weights: [[f64; 4]; 2],
    /// From the centres of both blocks, m.
    pub arms: [Vec3; 2],
    /// Share of the pressure, N.
    pub pressure: f64,
    /// Force of the springs along the contact on the second block, N.
    pub spring: Vec3,
    /// Force of dashpots on the second block, N.
    pub drag: Vec3,
}

/// One contact of a pair: that of a block with a facet of terrain, or the only one.
#[derive(Clone, Debug, Default)]
pub struct CellPatch {
    /// Its key among those of the pair.
    pub key: u32,
    /// Surface of equal depth, about the centre of the first block.
    pub surface: Piece,
    /// Its spots among those of the pair.
    pub spots: Range<usize>,
    /// Force of the pressure on the second block, N.
    pub elastic: Vec3,
    /// The same with the springs along the contact, N.
    pub force: Vec3,
    /// How far the blocks lie in each other there, m.
    pub depth: f64,
    /// Area across the normal, m²; 0 without a normal.
    pub area: f64,
    /// Gradient of the depth of the facet and that depth (m) at the centre of the first block.
    pub plane: (Vec3, f64),
    /// Place of the first contact that it shares dashpots across with.
    pub ridge: usize,
}

/// What a pair exerts.
#[derive(Clone, Debug, Default)]
pub struct PairSlot {
    /// Forces (N) on the nodes of a deformable block; force (N) and moment (N m) about the centroid on a rigid one.
    pub forces: [Vec<Vec3>; 2],
    /// Where friction and dashpots act, contact by contact.
    pub spots: Vec<Spot>,
    /// The contacts of the pair by their keys.
    pub patches: Vec<CellPatch>,
    /// Whether the blocks touch.
    pub touching: bool,
}

/// Workspace of a piece of the pairs, and sums of the group at hand.
#[derive(Debug, Default)]
pub struct PairWorkspace {
    /// For overlaps of cells.
    pub overlapping: Overlapping,
    /// Cells of both blocks that can take part.
    pub lists: [Vec<u32>; 2],
    /// Those of the second about the centre of the first.
    pub shifted: Vec<Cell>,
    /// Shares of the nodes of both blocks in the pressure.
    pub shares: [Vec<f64>; 2],
    /// Heat of friction in this step, J.
    pub friction: f64,
    /// Heat of dashpots in this step, J.
    pub damping: f64,
    /// Energy that pairs brought along, J.
    pub brought: f64,
}

/// Workspace for all found contacts of deformable blocks.
#[derive(Debug, Default)]
pub struct TetContactScratch {
    /// Whether the list of pairs is that of the state.
    pub ready: bool,
    /// Blocks that are in a pair, ascending, then terrain.
    pub members: Vec<Member>,
    /// Where they are; of terrain, which has a member for each block near it, what is near that.
    pub stars: Vec<TetFan>,
    /// Per pair.
    pub constants: Vec<PairConstants>,
    /// Per pair.
    pub slots: Vec<PairSlot>,
    /// Per piece of the pairs.
    pub workspaces: Vec<PairWorkspace>,
    /// Per group of pairs: heat of friction, heat of dashpots, energy that pairs brought along, J.
    pub sums: Vec<[f64; 3]>,
    /// For the search.
    pub grid: Grid,
    /// For the search: boxes of all blocks.
    pub boxes: Vec<Box3>,
    /// Whether a block of a run has left its margin.
    pub outside: Vec<bool>,
}
