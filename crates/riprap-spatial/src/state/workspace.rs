//! Everything of the deformable blocks that can be dropped and laid out anew without changing a result.

use std::sync::OnceLock;

use riprap_geom::polyhedron::{DepthCells, Tetrahedra};
use riprap_geom::{Mat3, Vec3};

use crate::laws::tetrahedron::{Elastic, Groups, StartStress, Stiffness};
use crate::ledger::Works;
use crate::state::cutting::Effort;
use crate::state::deform::Body;
use crate::state::links::Links;

/// Bodies per piece of work; sums run over a piece and then over a fixed tree of pieces.
pub(crate) const BODIES: usize = 64;
/// Facets per piece of work, likewise.
pub(crate) const FACETS: usize = 64;

/// Shape, elements and masses of congruent bodies of one material.
#[derive(Debug)]
pub struct BlockClass {
    /// Nodes and tetrahedra about the centroid.
    pub mesh: Tetrahedra,
    /// Its depth; found when it first meets another block.
    pub(crate) depths: OnceLock<DepthCells>,
    /// Its faces: corners, anticlockwise seen from outside.
    pub faces: Vec<Vec<u32>>,
    /// The tetrahedra, eight at a time.
    pub groups: Groups,
    /// Dense small-strain stiffness where several bodies share the class.
    pub stiffness: Option<Stiffness>,
    /// Elasticity.
    pub law: Elastic,
    /// Lumped masses of the nodes, kg.
    pub lumped: Vec<f64>,
    /// Masses with the true moment of inertia, kg; `None` in phases with lumped ones.
    pub(crate) inertial: Option<Vec<f64>>,
    /// Row sums of the stiffness matrix, N/m; empty outside relaxing phases.
    pub row_sums: Vec<f64>,
    /// Place in `Workspace::slopes`.
    pub(crate) first_slope: usize,
}

impl BlockClass {
    /// Masses of the nodes in the phase that it was made for, kg.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        self.inertial.as_deref().unwrap_or(&self.lumped)
    }

    /// The cells that carry its depth.
    pub(crate) fn depths(&self) -> &DepthCells {
        self.depths.get_or_init(|| DepthCells::new(&self.mesh))
    }
}

/// Scratch data of the deformable blocks.
#[derive(Debug, Default)]
pub struct Workspace {
    /// Shapes and elements, as `Deform::classes`.
    pub classes: Vec<BlockClass>,
    /// What displacements of the nodes are multiplied with in the mean displacement gradient, 1/m, one class after another.
    pub(crate) slopes: Vec<Vec3>,
    /// What a step reads of bonds.
    pub links: Links,
    /// Masses of the nodes, kg. *Shape* `[n_nodes]`.
    pub masses: Vec<f64>,
    /// Force of each point on A, N.
    pub slots: Vec<[f64; 3]>,
    /// Rotations of the bodies with large strain; empty without any.
    pub turns: Vec<Mat3>,
    /// Start stresses of the bodies; empty without any.
    pub starts: Vec<StartStress>,
    /// Forces of the start stresses of small-strain bodies on nodes, N; empty without any.
    pub start_forces: Vec<[f64; 3]>,
    /// Net forces on nodes without damping and supports, N.
    pub net: Vec<[f64; 3]>,
    /// Velocity change of the coming kick, m/s.
    pub change: Vec<[f64; 3]>,
    /// Fictitious masses of the nodes, kg; empty outside relaxing phases.
    pub fictitious: Vec<f64>,
    /// Dashpots on nodes of viscous faces, by node.
    pub dashpots: Vec<Dashpot>,
    /// Works of the coming half step.
    pub departure: Works,
    /// Norms of the net forces along free directions, of the reactions and of the external forces, N.
    pub norms: [f64; 3],
    /// Whether a point broke in the last evaluation.
    pub broke: bool,
    /// Squares of the highest frequencies of the bodies, each alone, 1/s²; empty where nothing has been cut in the phase or it
    /// relaxes.
    pub alone: Vec<f64>,
    /// What the last cut had to make.
    pub effort: Effort,
    pub(crate) partial: Vec<KickSums>,
    /// Squares of the speeds of the centroids of bodies after the last step, m²/s².
    pub(crate) speeds: Vec<f64>,
    pub(crate) bond_works: Vec<BondWorks>,
}

impl Workspace {
    /// Start stress of body number `k`.
    #[must_use]
    pub fn start_of(&self, k: usize) -> &StartStress {
        start_of(&self.starts, k)
    }

    /// What displacements of nodes are multiplied with in mean displacement gradients.
    #[must_use]
    pub fn slopes(&self) -> Slopes<'_> {
        Slopes { classes: &self.classes, slopes: &self.slopes }
    }

    /// BlockClass of a body.
    #[must_use]
    pub fn class(&self, body: &Body) -> &BlockClass {
        &self.classes[body.class as usize]
    }
}

/// Start stress of body number `k` in a list that is shorter or empty where bodies have none.
#[must_use]
pub(crate) fn start_of(starts: &[StartStress], k: usize) -> &StartStress {
    static NONE: StartStress = StartStress::none();
    starts.get(k).unwrap_or(&NONE)
}

/// What displacements of the nodes are multiplied with in the mean displacement gradient of a body, 1/m.
#[derive(Clone, Copy)]
pub struct Slopes<'a> {
    pub(crate) classes: &'a [BlockClass],
    pub(crate) slopes: &'a [Vec3],
}

impl<'a> Slopes<'a> {
    /// Those of a body. *Shape* `[n_nodes_of_body]`.
    #[must_use]
    pub fn of(&self, body: &Body) -> &'a [Vec3] {
        let first = self.classes[body.class as usize].first_slope;
        &self.slopes[first..first + body.count as usize]
    }
}

/// Dashpots on a node: the force is minus this matrix times the velocity.
#[derive(Clone, Copy, Debug)]
pub struct Dashpot {
    /// The node.
    pub node: u32,
    /// N s/m.
    pub matrix: Mat3,
}

/// Dissipation of one piece of facets, J.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BondWorks {
    /// What the sliders and softening have taken.
    pub works: Works,
    /// Whether a point has broken.
    pub broke: bool,
}

/// Sums over the nodes of a piece of work.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct KickSums {
    /// Works of the half step before the present time.
    pub arrival: Works,
    /// Works of the half step after it.
    pub departure: Works,
    /// Sums of squares of the free part of net forces, of reactions and of external forces, N².
    pub squares: [f64; 3],
    /// First node whose net force is not finite.
    pub bad: Option<u32>,
}
