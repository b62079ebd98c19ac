//! What the deformable part of a spatial model is built from.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::dynamics::{Formula, TimeFunction};
pub use crate::laws::bond::{Cohesive, Softening};
use crate::laws::fracture::{Criterion, Margins};
pub use crate::laws::mohr_coulomb::Strength;
pub use crate::laws::parameters::{BondFailure, CutAnchor};
pub use crate::laws::tetrahedron::Strain;

/// Deformable blocks and what holds single nodes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Deformables {
    /// Sets of deformable blocks; a block is in one set at most.
    pub sets: Vec<DeformableSet>,
    /// Held and driven nodes; a later entry wins over an earlier one for the same direction.
    pub holds: Vec<NodeHold>,
    /// What is broken at the start.
    pub notches: Vec<Notch>,
}

/// A box in which bonds are broken at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Notch {
    /// Lowest and highest corner, m (local).
    pub corners: [Vec3; 2],
    /// Single points in the box; otherwise facets whose centre lies in it.
    pub springs: bool,
}

/// Deformable blocks of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DeformableSet {
    /// Indices of the blocks, ascending.
    pub blocks: Vec<u32>,
    /// Measure of strain.
    pub strain: Strain,
    /// Displacement at the start along x, y, z, m, formulas in x, y, z (m, global).
    pub displacement: [Option<Formula>; 3],
    /// Velocity at the start along x, y, z, m/s, formulas in x, y, z; added to that of the block.
    pub velocity: [Option<Formula>; 3],
}

/// Nodes held or driven in a box.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NodeHold {
    /// Lowest corner of the box, m (local).
    pub min: Vec3,
    /// Highest corner, m.
    pub max: Vec3,
    /// Indices of the blocks whose nodes are meant, ascending; `None` for all.
    pub blocks: Option<Vec<u32>>,
    /// Velocity along x, y, z, m/s, 0 holds; `None` leaves a direction free. Formulas know the place of each node at the start.
    pub velocity: [Option<TimeFunction>; 3],
}

/// Law of the bonds between two materials.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BondLaw {
    /// Where its springs come from.
    pub springs: BondSprings,
    /// Strength; `None` is elastic.
    pub strength: Option<Strength>,
    /// Fracture energies and softening; `None` breaks at once.
    pub cohesive: Option<Cohesive>,
    /// What fails as one.
    pub failure: BondFailure,
}

impl BondLaw {
    /// The law with its strengths divided by `factor`; energies of fracture stay.
    #[must_use]
    pub fn reduced(mut self, factor: f64) -> Self {
        self.strength = self.strength.map(|s| s.reduced(factor));
        if let Some(cohesive) = &mut self.cohesive {
            cohesive.strength = cohesive.strength.reduced(factor);
        }
        self
    }
}

/// Springs of a bond per area.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum BondSprings {
    /// `E/L` and `G/L`.
    Thickness {
        /// Thickness L of the interface, m.
        thickness: f64,
        /// Moduli E and G of the interface, Pa; `None` takes those of the two materials in series.
        moduli: Option<[f64; 2]>,
    },
    /// Normal and shear stiffness, Pa/m.
    Given([f64; 2]),
}

/// Rules of cutting in a phase.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CutRules {
    /// Planes per cut, 1 to 7.
    pub planes: u32,
    /// What decides.
    pub criterion: Criterion,
    /// How much before its strength a block is cut, Pa.
    pub margins: Margins,
    /// How often a block and its parts may be cut.
    pub generations: u8,
    /// Edge of the cube that has the volume of the smallest part, m; 0 for none.
    pub smallest: f64,
    /// Where the planes lie.
    pub anchor: CutAnchor,
    /// With planes through tips: whether only facets between parts of one block break.
    pub only_cut: bool,
    /// Unit vector in all planes of cuts, for plane strain: principal stresses are those across it.
    pub along: Option<Vec3>,
    /// Vertices nearer than this share of the spacing to a plane are on it.
    pub snap: f64,
    /// Most times that blocks are cut in the phase.
    pub stages: u64,
    /// In dynamic phases: blocks whose parts would need a time step below this share of that of the block are not cut.
    pub step_floor: f64,
}
