//! State of the 3D engine: what a checkpoint holds.
//!
//! Leapfrog: velocities and spins belong to half a step before `time`, except before the first
//! step, when they belong to `time` itself (`last_dt` is 0). Positions are reference positions plus
//! displacements; with small kinematics lever arms and frames stay as they were at the start.

use riprap_geom::{Mat3, Quat, Vec3};
use serde::{Deserialize, Serialize};

use super::boundary::Face;
use super::cavity::Cavity;
use super::deform::Deform;
use super::edit::EditEvent;
use super::refine::Origin;
use super::setup::{Motion, Setup};
use super::tiles::tile_of;
use crate::ledger::Works;

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
    /// Motion of the blocks.
    pub bodies: Bodies,
    /// Centroids that displacements are measured from, m.
    pub reference: Vec<Vec3>,
    /// Displacement (m) and rotation vector (rad) of each block at which outputs begin to measure; shorter or
    /// empty where they measure from the start.
    pub datum: Vec<[Vec3; 2]>,
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
    /// Charges and other pressures inside the rock.
    pub cavities: Vec<Cavity>,
    /// Nodes, bonds and conditions of deformable blocks; `None` if all blocks are rigid.
    pub deform: Option<Box<Deform>>,
    /// Step at which the criteria of splitting were last looked at: once a step is enough.
    pub looked: u64,
    /// What has happened to blocks and cavities and has not been recorded yet; the recorder takes them out.
    pub events: Vec<EditEvent>,
    /// Running sums of the energy ledger.
    pub works: Works,
    /// Kinetic and stored energy at the start, J; set by the first evaluation.
    pub start_energy: Option<f64>,
}

/// Motion of all blocks, one list per component, so that neighbours load side by side.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Bodies {
    /// Displacement of the centroid (x, y, z), m, then rotation vector about x, y, z, rad (for
    /// blocks with finite rotations the vector of the total rotation).
    pub pose: [Vec<f64>; 6],
    /// Velocity of the centroid (x, y, z), m/s, then spin about x, y, z, rad/s.
    pub rate: [Vec<f64>; 6],
}

impl Bodies {
    /// `n` blocks at rest.
    #[must_use]
    pub fn at_rest(n: usize) -> Self {
        let zeros = || std::array::from_fn(|_| vec![0.0; n]);
        Self {
            pose: zeros(),
            rate: zeros(),
        }
    }

    /// Number of blocks.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pose[0].len()
    }

    /// Whether there are no blocks.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Displacement of the centroid, m.
    #[must_use]
    pub fn displacement(&self, b: usize) -> Vec3 {
        vec3(&self.pose, 0, b)
    }

    /// Rotation vector, rad.
    #[must_use]
    pub fn rotation(&self, b: usize) -> Vec3 {
        vec3(&self.pose, 3, b)
    }

    /// Velocity of the centroid half a step ago, m/s.
    #[must_use]
    pub fn velocity(&self, b: usize) -> Vec3 {
        vec3(&self.rate, 0, b)
    }

    /// Spin half a step ago, rad/s.
    #[must_use]
    pub fn spin(&self, b: usize) -> Vec3 {
        vec3(&self.rate, 3, b)
    }

    /// Sets displacement (m) and rotation vector (rad).
    pub fn set_pose(&mut self, b: usize, displacement: Vec3, rotation: Vec3) {
        put(&mut self.pose, 0, b, displacement);
        put(&mut self.pose, 3, b, rotation);
    }

    /// Sets velocity (m/s) and spin (rad/s).
    pub fn set_rate(&mut self, b: usize, velocity: Vec3, spin: Vec3) {
        put(&mut self.rate, 0, b, velocity);
        put(&mut self.rate, 3, b, spin);
    }

    /// Appends a block; returns its index.
    pub fn push(&mut self, pose: [Vec3; 2], rate: [Vec3; 2]) -> usize {
        let b = self.len();
        for list in self.pose.iter_mut().chain(&mut self.rate) {
            list.push(0.0);
        }
        self.set_pose(b, pose[0], pose[1]);
        self.set_rate(b, rate[0], rate[1]);
        b
    }
}

/// Vector at components `first`, `first + 1`, `first + 2` of item `b`.
#[inline]
#[must_use]
pub fn vec3(lists: &[Vec<f64>; 6], first: usize, b: usize) -> Vec3 {
    Vec3::new(lists[first][b], lists[first + 1][b], lists[first + 2][b])
}

#[inline]
fn put(lists: &mut [Vec<f64>; 6], first: usize, b: usize, v: Vec3) {
    lists[first][b] = v.x;
    lists[first + 1][b] = v.y;
    lists[first + 2][b] = v.z;
}

/// Mass properties of equal blocks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolidClass {
    /// Mass, kg.
    pub mass: f64,
    /// Volume, m³.
    pub volume: f64,
    /// Inertia tensor about the centroid in the frame of the start, kg m².
    pub inertia: Mat3,
    /// Its inverse, 1/(kg m²).
    pub inverse: Mat3,
    /// Half the edge lengths of the bounding box about the centroid, m.
    pub half: Vec3,
    /// Largest distance of a corner from the centroid, m.
    pub radius: f64,
    /// Whether the axes are principal axes (bricks): `inertia` is diagonal.
    pub diagonal: bool,
}

/// State of a block with finite rotations.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turned {
    /// Turns the frame of the start into the present one.
    pub attitude: Quat,
    /// Angular momentum about the centroid half a step ago, space frame, N m s.
    pub momentum: Vec3,
}

/// Patches: rectangles or polygons where two blocks share a face. Lists of equal length, except
/// those that are empty when no patch needs them.
///
/// Stress is tension-positive; the normal points from block `i` to block `j`; the traction is that
/// on block `i`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Patches {
    /// Blocks i and j; may be the same block in a periodic model one block wide.
    pub ends: Vec<[u32; 2]>,
    /// Index into `World::classes`.
    pub class: Vec<u32>,
    /// State bits, see [`flag`].
    pub flags: Vec<u16>,
    /// Traction at the centre at zero displacement, Pa, global axes at the start; empty without
    /// in-situ stress.
    pub prestress: Vec<Vec3>,
    /// Irrecoverable shear displacement along b and c of the four points, m; empty while all is
    /// elastic.
    pub slip: Vec<[[f64; 4]; 2]>,
    /// Opening at which the normal spring of each point is relaxed, m: dilation, edits and changes of
    /// kinematics; empty when there is none.
    pub lift: Vec<[f64; 4]>,
    /// Length of the path of plastic shear of each point, m; empty without dilation.
    pub path: Vec<[f64; 4]>,
}

impl Patches {
    /// Number of patches.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Puts patches in the order that tiles need: by tile of block i, patches within the tile first, then by
    /// axis, block i and block j.
    pub fn sort(&mut self, classes: &[PatchClass]) {
        let mut order: Vec<u32> = (0..self.len() as u32).collect();
        order.sort_by_key(|&p| {
            let [i, j] = self.ends[p as usize];
            let axis = classes[self.class[p as usize] as usize].axis;
            (tile_of(i), tile_of(j) != tile_of(i), axis, i, j)
        });
        self.keep(&order);
    }

    /// Keeps the patches `chosen`, in that order.
    pub fn keep(&mut self, chosen: &[u32]) {
        fn pick<T: Copy>(list: &mut Vec<T>, chosen: &[u32]) {
            if !list.is_empty() {
                *list = chosen.iter().map(|&p| list[p as usize]).collect();
            }
        }
        pick(&mut self.ends, chosen);
        pick(&mut self.class, chosen);
        pick(&mut self.flags, chosen);
        pick(&mut self.prestress, chosen);
        pick(&mut self.slip, chosen);
        pick(&mut self.lift, chosen);
        pick(&mut self.path, chosen);
    }

    /// Makes room for slip where there is none yet.
    pub fn need_slip(&mut self) {
        self.slip.resize(self.ends.len(), [[0.0; 4]; 2]);
    }

    /// Makes room for lifts where there is none yet.
    pub fn need_lift(&mut self) {
        self.lift.resize(self.ends.len(), [0.0; 4]);
    }

    /// Makes room for slip paths where there is none yet.
    pub fn need_path(&mut self) {
        self.path.resize(self.ends.len(), [0.0; 4]);
    }
}

/// Bits of [`Patches::flags`]; bits 0 to 11 are one per point.
pub mod flag {
    /// The four points have failed (bits 0 to 3).
    pub const BROKEN: u16 = 0x000f;
    /// The four points are open now (bits 4 to 7).
    pub const OPEN: u16 = 0x00f0;
    /// The four points slid in the last step (bits 8 to 11).
    pub const SLIDING: u16 = 0x0f00;
    /// The patch uses finite rotations.
    pub const FINITE: u16 = 0x1000;
    /// `slip` or `lift` are in use.
    pub const OFFSET: u16 = 0x2000;

    /// Bits of points that slid by `before`, and go on doing so by `after`: a law that is applied again at the same instant
    /// sees no motion, but closed points have not come to rest.
    #[must_use]
    pub const fn slide_on(before: u16, after: u16) -> u16 {
        before & SLIDING & !((after & OPEN) << 4)
    }

    /// Bit of `point` (0 to 3) in the group that starts at the lowest bit of `group`.
    #[must_use]
    pub const fn of(group: u16, point: usize) -> u16 {
        (1 << point) << group.trailing_zeros()
    }
}

/// Geometry and stiffness shared by equal patches, at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PatchClass {
    /// Unit vectors n (from i to j), b and c: right-handed.
    pub frame: [Vec3; 3],
    /// Area, m².
    pub area: f64,
    /// Distance of the points from the centre along b and c, m.
    pub reach: [f64; 2],
    /// Centre of the patch from the centroids of i and j, m.
    pub arms: [Vec3; 2],
    /// Normal and shear stiffness, Pa/m.
    pub stiffness: [f64; 2],
    /// Dashpot over spring of closed points, s.
    pub beta: f64,
    /// Materials of i and j.
    pub materials: [u16; 2],
    /// Index into `Setup::interfaces`.
    pub row: u16,
    /// Axis of the normal, 0 to 2, with b and c the next two axes; 3 for any other direction.
    pub axis: u8,
    /// Distance of the centroids across the patch, m.
    pub distance: f64,
    /// In-situ traction (n, b, c) per metre along b and along c, Pa/m; scaled so that four points have
    /// its exact moment.
    pub slope: [[f64; 3]; 2],
}
