//! State of the 3D engine: what a checkpoint holds.
//!
//! Leapfrog: velocities and spins belong to half a step before `time`, except before the first
//! step, when they belong to `time` itself (`last_dt` is 0). Positions are reference positions plus
//! displacements; with small kinematics lever arms and frames stay as they were at the start.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::accounts::{Account, Holder, of};
use crate::failed::FailedPoints;
use crate::implicit::memory::Implicit;
use crate::ledger::{Left, Works};
use crate::setup::{Motion, Setup};
use crate::state::anchor::{Anchor, Freedoms};
pub use crate::state::bodies::{Bodies, SolidClass, Turned, vec3};
use crate::state::bolts::Bolt;
use crate::state::cavity::Cavity;
use crate::state::deform::Deform;
use crate::state::event::{EditEvent, EditKind};
use crate::state::face::{Face, Overruled};
use crate::state::found::FoundContacts;
use crate::state::gas::CrackGas;
use crate::state::lineage::Origin;
pub use crate::state::patches::{PatchClass, Patches, flag};
use crate::state::seepage::Seepage;

/// Whole state of a spatial model.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct World {
    /// The model as built (interfaces, supports and boundaries as changed by phases since). A block
    /// that was split or removed stays in `setup.blocks`; children are appended.
    pub setup: Setup,
    /// Model time, s.
    pub time: f64,
    /// Steps done.
    pub step: u64,
    /// Length of the last step, s; 0 before the first.
    pub last_dt: f64,
    /// Time moved since the forces were last evaluated, s.
    pub pending: f64,
    /// Whether the laws must be applied in the next evaluation although no time has passed: after
    /// building, an edit or a change of laws.
    pub fresh: bool,
    /// Gravity now, m/s².
    pub gravity: Vec3,
    /// The water table that stands now, an index into `setup.water`.
    pub water: Option<u16>,
    /// The network of joints through which the table seeps that stands now, if it does.
    pub seepage: Option<Box<Seepage>>,
    /// The gas of charges that enters cracks, once the first of them has gone off.
    pub gas: Option<Box<CrackGas>>,
    /// Motion of the blocks.
    pub bodies: Bodies,
    /// Centroids that displacements are measured from, m.
    pub reference: Vec<Vec3>,
    /// Displacement (m) and rotation vector (rad) of each block at which outputs begin to measure; shorter or
    /// empty where they measure from the start.
    pub datum: Vec<[Vec3; 2]>,
    /// Displacement (m) of each node at which pins begin to measure; shorter or empty as `datum`.
    pub node_datum: Vec<[f64; 3]>,
    /// Index into `solids`, per block.
    pub solid: Vec<u32>,
    /// Mass properties, shared by equal blocks.
    pub solids: Vec<SolidClass>,
    /// Blocks that use finite rotations (boxed: few do).
    pub turned: Vec<Option<Box<Turned>>>,
    /// Removed and split blocks stay in the lists, so that numbers keep their meaning.
    pub alive: Vec<bool>,
    /// Where each block comes from.
    pub lineage: Vec<Origin>,
    /// Prescribed motion of each block, if any (boxed: few blocks have one).
    pub motion: Vec<Option<Box<Motion>>>,
    /// Square of the largest speed of each block's centroid so far, m²/s².
    pub peak_speed_squared: Vec<f64>,
    /// Patches between blocks.
    pub patches: Patches,
    /// Geometry and stiffness of patches, shared by equal ones.
    pub classes: Vec<PatchClass>,
    /// Free faces, or parts of faces, sorted by block.
    pub faces: Vec<Face>,
    /// Faces that conditions have lost to later ones when the model was built, to be told.
    pub overruled: Vec<Overruled>,
    /// Charges and other pressures inside the rock.
    pub cavities: Vec<Cavity>,
    /// Bolts that have been installed.
    pub bolts: Vec<Bolt>,
    /// Nodes, bonds and conditions of deformable blocks; `None` if all blocks are rigid.
    pub deform: Option<Box<Deform>>,
    /// Contacts that are found anew in each step.
    pub found: FoundContacts,
    /// Memory of the contacts of an implicit phase; `None` in explicit ones.
    pub implicit: Option<Box<Implicit>>,
    /// Failed points of patches that found contact has taken over, and of patches and facets whose blocks were removed.
    pub failed: FailedPoints,
    /// Step at which the criteria of splitting were last looked at: once a step is enough.
    pub last_check_step: u64,
    /// What has happened to blocks and cavities and has not been recorded yet; the recorder takes them out.
    pub events: Vec<EditEvent>,
    /// Running sums of the energy ledger.
    pub works: Works,
    /// Blocks that have left the model.
    pub left: Left,
    /// Work of the conditions in `setup.accounts`.
    pub accounts: Vec<Account>,
    /// Kinetic and stored energy at the start, J; set by the first evaluation.
    pub start_energy: Option<f64>,
}

impl World {
    /// Mass properties of a block.
    #[must_use]
    pub fn solid_of(&self, b: usize) -> &SolidClass {
        &self.solids[self.solid[b] as usize]
    }

    /// Whether block `b` is terrain.
    #[must_use]
    pub fn is_terrain(&self, b: usize) -> bool {
        self.setup.blocks[b].shape.is_terrain()
    }

    /// Whether block `b` is deformable.
    #[must_use]
    pub fn deforms(&self, b: usize) -> bool {
        self.deform.as_ref().is_some_and(|d| d.body(b).is_some())
    }

    /// Work of the condition on account number `k` since the start, J.
    #[must_use]
    pub fn work(&self, k: usize) -> f64 {
        self.accounts.get(k).map_or(f64::NAN, Account::work)
    }

    /// Work of boundary number `k` since the start, J.
    #[must_use]
    pub fn work_of_boundary(&self, k: usize) -> f64 {
        let account = of(&self.setup.accounts, Holder::Boundary(k as u16));
        account.map_or(f64::NAN, |account| self.work(usize::from(account)))
    }

    /// An event at the present time, without children.
    #[must_use]
    pub fn event(&self, kind: EditKind, subject: u32) -> EditEvent {
        EditEvent {
            step: self.step,
            time: self.time,
            kind,
            subject,
            children: Vec::new(),
            patches: [0; 2],
            cut: None,
        }
    }

    /// The freedoms of all blocks, with the nodes of `deform`, the deformable part.
    #[must_use]
    pub fn freedoms_with<'a>(&'a self, deform: &'a Deform) -> Freedoms<'a> {
        Freedoms::new(&self.bodies, &self.turned, Some(&deform.nodes))
    }

    /// The freedoms of all blocks.
    #[must_use]
    pub fn all_freedoms(&self) -> Freedoms<'_> {
        let nodes = self.deform.as_deref().map(|d| &d.nodes);
        Freedoms::new(&self.bodies, &self.turned, nodes)
    }

    /// The centroid of a block.
    #[must_use]
    pub fn centroid(&self, block: u32) -> Anchor {
        let body = self.deform.as_deref().and_then(|d| d.body(block as usize));
        match body {
            // The last node is the centroid.
            Some(body) => Anchor::node(body.first + body.count - 1),
            None => Anchor::Block { block, arm: Vec3::ZERO },
        }
    }
}
