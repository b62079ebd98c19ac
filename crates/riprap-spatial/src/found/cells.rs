//! What the evaluation of contacts between blocks of cells works with; can be dropped and laid out anew without changing a result.
//!
//! A block is a star of [`Cell`]s: tetrahedra from its centre to the triangles of its surface. Its depth is nil on the surface
//! and `peak`, the least distance of the centre from a face at the start, at the centre. So faces of a cube have slope one and
//! press like those of rigid blocks; a face that lies twice as far from the centre as the nearest one has half the slope.
//! Deviation from a depth over several layers of elements: these blocks have one.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;

use super::friction::ContactLaw;
use super::grid::{Box3, Grid};
use super::tetra::{Cell, Piece, Workspace as Overlapping};

/// A block now.
#[derive(Clone, Debug)]
pub struct Star {
    /// Its centre, m; cells are about it.
    pub origin: Vec3,
    /// Box around it.
    pub bounds: Box3,
    /// Its cells in the order of the tetrahedra; one that is inside out meets nothing.
    pub cells: Vec<Cell>,
    /// Boxes of the cells.
    pub boxes: Vec<Box3>,
    /// Whether all cells are sound.
    pub sound: bool,
}

impl Default for Star {
    fn default() -> Self {
        Self {
            origin: Vec3::ZERO,
            bounds: Box3::EMPTY,
            cells: Vec::new(),
            boxes: Vec::new(),
            sound: true,
        }
    }
}

impl Star {
    /// Puts the cells of a mesh, whose nodes are at `place` (m) now, in their places.
    pub fn put(&mut self, tets: &[[u32; 4]], peak: f64, origin: Vec3, place: impl Fn(u32) -> Vec3) {
        self.origin = origin;
        self.bounds = Box3::EMPTY;
        self.cells.clear();
        self.boxes.clear();
        self.sound = true;
        for tet in tets {
            let places = tet.map(&place);
            let cell = Cell::new(places.map(|at| at - origin), peak);
            self.push(places, cell);
        }
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
        self.sound &= cell.is_some();
        self.cells.push(cell.unwrap_or_default());
    }
}

/// Least distance of the centre of a mesh from its faces, m.
#[must_use]
pub fn peak(mesh: &Tetrahedra) -> f64 {
    let heights = mesh
        .gradients
        .iter()
        .map(|[a, b, c]| 1.0 / (*a + *b + *c).length());
    heights.fold(f64::INFINITY, f64::min)
}

/// What is the same in all steps for a block that is in a pair.
#[derive(Debug)]
pub struct Member {
    /// The block.
    pub block: u32,
    /// Its place among the deformable ones; `None` for a rigid one.
    pub body: Option<u32>,
    /// Mesh of a rigid block about its centroid.
    pub mesh: Option<Tetrahedra>,
    /// Depth at its centre, m.
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
    /// The smaller one of the depths of the centres, m; on terrain that of the block.
    pub peak: f64,
    /// Place of the terrain among all, of a block on it.
    pub ground: Option<u32>,
}

/// A point at which friction and dashpots of a contact act.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// Tetrahedra of both blocks.
    pub tets: [u32; 2],
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

/// What a pair exerts.
#[derive(Clone, Debug, Default)]
pub struct PairSlot {
    /// Forces (N) on the nodes of a deformable block; force (N) and moment (N m) about the centroid on a rigid one.
    pub forces: [Vec<Vec3>; 2],
    /// Where friction and dashpots act.
    pub spots: Vec<Spot>,
    /// Whether the blocks touch.
    pub touching: bool,
    /// Area across the normal, m².
    pub area: f64,
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
    /// Surface of equal depth of the pair at hand.
    pub surface: Piece,
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
pub struct CellDesk {
    /// Whether the list of pairs is that of the state.
    pub ready: bool,
    /// Blocks that are in a pair, ascending, then terrain.
    pub members: Vec<Member>,
    /// Where they are; of terrain, which has a member for each block near it, what is near that.
    pub stars: Vec<Star>,
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
