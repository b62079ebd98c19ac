//! What the 3D engine is built from: plain SI data, no behaviour.
//!
//! Written by `model`, kept in checkpoints. Axes x (east), y (north), z (up); stress is
//! tension-positive; a patch's normal points from its block `i` to its block `j`. Rotations are vectors, rad,
//! right-handed.

pub mod error;

mod bridges;
pub mod deform;
pub(crate) mod rotation;
mod solid;

use riprap_geom::height_field::HeightField;
use riprap_geom::{Mat3, Quat, Vec3};
use serde::{Deserialize, Serialize};

use crate::accounts::Condition;
use crate::dynamics::TimeFunction;
use crate::dynamics::kick::Target;
use crate::flow::Friction;
use crate::laws::bolt::Design;
pub use crate::laws::explosive::{Explosive, Products};
pub use crate::laws::in_situ::InSitu;
pub use crate::laws::mohr_coulomb::Strength;
pub use crate::laws::parameters::{
    Dashpots, Failure, JointLaw, Kinematics, Points, Stiffness, StiffnessRule,
};
pub use crate::laws::water::WaterTable;
pub use crate::setup::bridges::{Bridges, Ended};
use crate::setup::rotation::rotation;

/// A complete 3D model at its start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Setup {
    /// Acceleration of gravity, m/s².
    pub gravity: Vec3,
    /// Global position of the local origin that all coordinates here are relative to, m.
    pub origin: Vec3,
    /// Periods of the model along the axes, m; blocks at opposite ends are neighbours.
    pub periodic: [Option<f64>; 3],
    /// Materials; a block's `material` is an index into this list.
    pub materials: Vec<Material>,
    /// First words of block names; see [`BlockName`].
    pub names: Vec<String>,
    /// The blocks, in scenario order.
    pub blocks: Vec<BlockSpec>,
    /// Attitude of each block at the start against the shape that the scene draws; empty where a table of states turned none.
    pub attitudes: Vec<Quat>,
    /// Blocks with a mass and moments of inertia of their own, ascending.
    pub bodies: Vec<GivenBody>,
    /// Joint laws of patches built along faces that blocks share at the start.
    pub interfaces: Vec<InterfaceLaw>,
    /// Row of `interfaces` for materials (a, b), at `a * materials.len() + b`; symmetric.
    pub pair_table: Vec<u16>,
    /// Rock bridges, whose faces have a row of their own.
    pub bridges: Vec<Bridges>,
    /// Fixed and driven blocks; a later entry wins over an earlier one for the same block.
    pub supports: Vec<Support>,
    /// Conditions on free faces; a later entry wins over an earlier one for the same face.
    pub boundaries: Vec<Boundary>,
    /// Stress at the start.
    pub in_situ: Option<InSitu>,
    /// Forces on blocks.
    pub loads: Vec<Load>,
    /// Charges and other cavities that push on the faces around them.
    pub sources: Vec<Source>,
    /// Bolts, those of later phases too.
    pub bolts: Vec<Bolt>,
    /// Splitting of blocks 1 to 8, in order: before the first step and while running.
    pub refinements: Vec<Refinement>,
    /// Named sets of blocks.
    pub groups: Vec<Group>,
    /// How blocks turn.
    pub kinematics: Kinematics,
    /// Angle at which a block changes over to finite rotations, rad, by automatic kinematics; `None` takes
    /// [`ROTATION_BOUND`].
    pub rotation_bound: Option<f64>,
    /// Half the density of the air times the drag coefficient of rigid blocks, kg/m³; 0: no air.
    pub air: f64,
    /// Deformable blocks and their bonds.
    pub deform: deform::Deformables,
    /// Whether blocks that no patch joins are watched for contact.
    pub found_contacts: bool,
    /// Boundaries, supports and loads whose work is told.
    pub accounts: Vec<Condition>,
    /// Water tables, of which one at a time stands ([`World::water`](crate::state::world::World::water)).
    pub water: Vec<WaterTable>,
}

/// Angle at which a block changes over to finite rotations where none is given, rad.
pub const ROTATION_BOUND: f64 = 0.01;

impl Setup {
    /// Angle at which a block changes over to finite rotations, rad.
    #[must_use]
    pub fn rotation_bound(&self) -> f64 {
        self.rotation_bound.unwrap_or(ROTATION_BOUND)
    }

    /// Row of `interfaces` for the face that blocks of two materials share, with its centre (m, local) and unit normal.
    #[must_use]
    pub fn row_at(&self, materials: [usize; 2], at: Vec3, normal: Vec3) -> u16 {
        let bridge = self.bridges.iter().find(|bridges| bridges.hold(at, normal));
        bridge.map_or_else(|| self.row_of(materials), |bridges| bridges.row)
    }

    /// Row of `interfaces` for two materials.
    #[must_use]
    pub fn row_of(&self, materials: [usize; 2]) -> u16 {
        self.pair_table[materials[0] * self.materials.len() + materials[1]]
    }

    /// The lists of whole blocks in groups, supports, boundaries and sources. Whoever names a block that is divided names
    /// its parts from then on; loads are shared out by what they are and are not among these.
    pub fn block_lists(&mut self) -> impl Iterator<Item = &mut Vec<u32>> {
        let groups = self.groups.iter_mut().map(|g| &mut g.blocks);
        let supports = self.supports.iter_mut().map(|s| &mut s.blocks);
        let boundaries = self.boundaries.iter_mut().filter_map(|b| match &mut b.on {
            FaceSet::Blocks { blocks, .. } | FaceSet::Surface { blocks, .. } => Some(blocks),
            FaceSet::Plane { .. } | FaceSet::Box { .. } => None,
        });
        let sources = self.sources.iter_mut().filter_map(|s| match &mut s.place {
            Place::Blocks { blocks } => Some(blocks),
            Place::Point { .. } | Place::Line { .. } => None,
        });
        let holds = self.deform.holds.iter_mut();
        let holds = holds.filter_map(|h| h.blocks.as_mut());
        let lists = groups.chain(supports).chain(boundaries).chain(sources);
        lists.chain(holds)
    }
}

/// A named set of blocks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Name used in the scenario.
    pub name: String,
    /// Indices of the blocks, ascending.
    pub blocks: Vec<u32>,
}

/// A material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Name used in the scenario.
    pub name: String,
    /// Mass density, kg/m³.
    pub density: f64,
    /// Young's modulus, Pa; needed by stiffness from the material, viscous faces and gas couplings.
    pub young: Option<f64>,
    /// Poisson's ratio.
    pub poisson: Option<f64>,
}

impl Material {
    /// Shear modulus G = E/(2(1+nu)), Pa.
    #[must_use]
    pub fn shear_modulus(&self) -> Option<f64> {
        Some(self.young? / (2.0 * (1.0 + self.poisson?)))
    }

    /// Constrained modulus M = E(1-nu)/((1+nu)(1-2nu)), Pa.
    #[must_use]
    pub fn constrained_modulus(&self) -> Option<f64> {
        let (e, nu) = (self.young?, self.poisson?);
        Some(e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)))
    }
}

/// Name of a block, kept small because there are millions: `rock`, `rock.17`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BlockName {
    /// Index into [`Setup::names`].
    pub base: u16,
    /// Number behind the dot, from 1; 0 for a name without number.
    pub number: u32,
}

/// One block.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BlockSpec {
    /// Unique name.
    pub name: BlockName,
    /// Shape and place.
    pub shape: Shape,
    /// Index into `Setup::materials`.
    pub material: u16,
    /// Initial velocity of the centroid, m/s.
    pub velocity: Vec3,
    /// Initial angular velocity, rad/s.
    pub spin: Vec3,
}

/// A rigid block that is not as heavy, or turns not as heavily, as its shape and material say.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GivenBody {
    /// Index of the block.
    pub block: u32,
    /// kg.
    pub mass: f64,
    /// Tensor of inertia about the centroid, kg m².
    pub inertia: Mat3,
}

/// Shape of a block at its start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// A box with faces normal to the axes.
    Brick {
        /// Centre, m.
        centre: Vec3,
        /// Half the edge lengths, m.
        half: Vec3,
    },
    /// A convex polyhedron.
    Polyhedron(Box<Solid>),
    /// Ground with one height per place, which nothing moves.
    Terrain(Box<Surface>),
    /// One body of convex polyhedra that touch each other by faces.
    Glued(Vec<Solid>),
}

impl Shape {
    /// Numbers that bricks of one size and the same `of` share; `None` for other shapes, which count as all different.
    pub(crate) fn key(&self, of: u64) -> Option<[u64; 4]> {
        match self {
            Self::Brick { half, .. } => {
                let [x, y, z] = half.to_array().map(f64::to_bits);
                Some([x, y, z, of])
            }
            Self::Polyhedron(_) | Self::Terrain(_) | Self::Glued(_) => None,
        }
    }

    /// Whether it is terrain.
    #[must_use]
    pub fn is_terrain(&self) -> bool {
        match self {
            Self::Terrain(_) => true,
            Self::Brick { .. } | Self::Polyhedron(_) | Self::Glued(_) => false,
        }
    }

    /// Whether it is made of glued parts.
    #[must_use]
    pub fn is_glued(&self) -> bool {
        matches!(self, Self::Glued(_))
    }
}

/// A surface with one height per place, checked by [`HeightField::new`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Corners, m.
    pub points: Vec<Vec3>,
    /// Corners of each triangle, anticlockwise seen from above.
    pub triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// The surface as geometry knows it.
    #[must_use]
    pub fn field(&self) -> HeightField {
        HeightField { points: self.points.clone(), triangles: self.triangles.clone() }
    }

    /// The closed body under it, as it is shown: corners and faces.
    #[must_use]
    pub fn body(&self) -> Solid {
        let (vertices, faces) = self.field().body();
        Solid { vertices, faces }
    }
}

/// A convex polyhedron: corners and faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Solid {
    /// Corners, m.
    pub vertices: Vec<Vec3>,
    /// Corners of each face, anticlockwise seen from outside.
    pub faces: Vec<Vec<u32>>,
}

/// Laws between two materials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InterfaceLaw {
    /// Name used in the scenario.
    pub name: String,
    /// Law of the patches.
    pub joint: JointLaw,
    /// Law of the bonds where at least one of the blocks is deformable; `None` where no deformable block meets.
    pub bond: Option<deform::BondLaw>,
    /// Tangent of the friction angle of found contacts where patches are elastic, if one is given.
    pub friction: Option<f64>,
}

/// Fixes or drives some blocks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Support {
    /// Blocks concerned.
    pub blocks: Vec<u32>,
    /// What they do.
    pub motion: Motion,
}

/// Prescribed motion of a block, by component; a component that is not prescribed is free.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// Held still in the chosen freedoms.
    Fixed {
        /// Translation along x, y, z.
        translation: [bool; 3],
        /// Rotation about x, y, z.
        rotation: [bool; 3],
    },
    /// Velocity of the centroid (m/s) and spin (rad/s) as functions of time.
    Velocity {
        /// Along x, y, z, m/s.
        translation: [Option<TimeFunction>; 3],
        /// About x, y, z, rad/s.
        spin: [Option<TimeFunction>; 3],
        /// Point (local, m) about which the spin turns all blocks of the support as one body, and of which the translation is the velocity;
        /// without one each turns about its own centroid.
        about: Option<Vec3>,
    },
    /// Acceleration of the centroid (m/s²) as functions of time; rotation is held.
    Acceleration {
        /// Along x, y, z, m/s².
        translation: [Option<TimeFunction>; 3],
    },
}

impl Motion {
    /// Whether it moves blocks, rather than holding them.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        match self {
            Self::Fixed { .. } => false,
            Self::Velocity { .. } | Self::Acceleration { .. } => true,
        }
    }
}

impl Motion {
    /// What is prescribed for translation along, and rotation about x, y, z.
    #[must_use]
    pub fn targets(&self) -> [[Target<'_>; 3]; 2] {
        match self {
            Self::Fixed { translation, rotation } => {
                [translation, rotation].map(|held| held.map(Target::held))
            }
            Self::Velocity { translation, spin, .. } => {
                [translation, spin].map(|f| f.each_ref().map(|f| Target::velocity(f.as_ref())))
            }
            Self::Acceleration { translation } => [
                translation.each_ref().map(|f| Target::acceleration(f.as_ref())),
                [Target::Still; 3],
            ],
        }
    }

    /// 1 for each freedom whose velocity it gives, else 0: translation along, and rotation about x, y, z.
    #[must_use]
    pub fn given(&self) -> [Vec3; 2] {
        let one = |t: Target| f64::from(t.gives_velocity());
        self.targets().map(|of| Vec3::from_array(of.map(one)))
    }

    /// Point about which it turns blocks as one body, if it does.
    #[must_use]
    pub fn about(&self) -> Option<Vec3> {
        match self {
            Self::Velocity { about, .. } => *about,
            Self::Fixed { .. } | Self::Acceleration { .. } => None,
        }
    }

    /// Velocity (m/s) beside that of the translation of a block that turns about a point with others, as one body. `place` (m) is that
    /// of its centroid at the start; with an `attitude` it goes along the chord of its step of `dt` (s) from `time` (s) on and
    /// so stays on its circle, without one (small rotations) its arm stays as it was.
    #[must_use]
    pub fn swing(&self, place: Vec3, attitude: Option<Quat>, time: f64, dt: f64) -> Vec3 {
        let Some(about) = self.about() else {
            return Vec3::ZERO;
        };
        let [_, spin] = self.targets();
        let rate = Vec3::from_array(spin.map(|target| target.at(time + 0.5 * dt, 0.0)));
        let arm = place - about;
        match attitude {
            Some(q) if dt > 0.0 => {
                let arm = q * arm;
                (rotation(dt * rate) * arm - arm) / dt
            }
            Some(q) => rate.cross(q * arm),
            None => rate.cross(arm),
        }
    }

    /// Which freedoms it prescribes: translation along, and rotation about x, y, z.
    #[must_use]
    pub fn prescribes(&self) -> [[bool; 3]; 2] {
        self.targets().map(|of| of.map(|t| !t.is_free()))
    }
}

/// A condition on free faces: faces, or parts of faces, that no patch covers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Boundary {
    /// Name for messages.
    pub name: String,
    /// Which faces.
    pub on: FaceSet,
    /// What happens there.
    pub kind: BoundaryKind,
    /// Whether the in-situ stress acts on these faces from outside, so that the start is in equilibrium.
    pub in_situ: bool,
}

/// A choice of free faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum FaceSet {
    /// Faces on a plane `normal . x = offset` whose outward normal is `normal`.
    Plane {
        /// Unit outward normal.
        normal: Vec3,
        /// Distance from the local origin along the normal, m.
        offset: f64,
    },
    /// Faces of some blocks with an outward normal, or with any.
    Blocks {
        /// Indices of the blocks.
        blocks: Vec<u32>,
        /// Unit outward normal; `None` takes all free faces.
        normal: Option<Vec3>,
    },
    /// Faces whose centre is inside a box and whose outward normal is `normal`.
    Box {
        /// Lowest corner, m.
        min: Vec3,
        /// Highest corner, m.
        max: Vec3,
        /// Unit outward normal; `None` takes all.
        normal: Option<Vec3>,
    },
    /// A named surface of a mesh: faces of some blocks on some planes.
    Surface {
        /// Indices of the blocks, ascending.
        blocks: Vec<u32>,
        /// Unit outward normals and distances from the local origin along them, m; ascending by the x of the normal.
        planes: Vec<(Vec3, f64)>,
    },
}

/// Kinds of face condition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum BoundaryKind {
    /// Held through the stiffness of the half block behind the face (`2M/L`, `4G/L` per area).
    Held {
        /// Against motion along the normal: alone it is a roller or a plane of symmetry.
        normal: bool,
        /// Against motion along the face.
        shear: bool,
    },
    /// Face moved with a velocity (m/s along x, y, z) through the same half-block stiffness; formulas know the place of each
    /// point of it at the start.
    Moved {
        /// Along x, y, z; `None` leaves that direction free.
        velocity: [Option<TimeFunction>; 3],
    },
    /// Absorbs waves (Lysmer & Kuhlemeyer 1969): `sigma = -rho c_P v_n`, `tau = -rho c_S v_s`.
    Viscous {
        /// Dashpot in series with the half block between centroid and face (second order); without it the
        /// dashpot takes the velocity of the face of the rigid block (the source; first order).
        half_cell: bool,
    },
    /// A stress that acts on the face.
    Traction {
        /// Force per area with a fixed direction, Pa.
        traction: Vec3,
        /// Pressure into the block, along the face normal, Pa.
        pressure: f64,
        /// Pressure that is added for each metre below `datum`, Pa/m.
        gradient: f64,
        /// Height at which `pressure` holds, m (local z).
        datum: f64,
        /// Multiplier over time.
        time: TimeFunction,
    },
}

/// A force on blocks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Load {
    /// Blocks it acts on.
    pub blocks: Vec<u32>,
    /// What acts.
    pub kind: LoadKind,
    /// Multiplier over time.
    pub time: TimeFunction,
    /// Index into `Setup::accounts` of the account that its work is booked on, if any.
    pub account: Option<u16>,
}

/// Kinds of load.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum LoadKind {
    /// A force at a material point.
    Point {
        /// Force, N.
        force: Vec3,
        /// Initial position of the point, m; `None` is the centroid. It travels with the block.
        at: Option<Vec3>,
    },
    /// A moment, N m.
    Moment {
        /// Moment about x, y, z, N m.
        moment: Vec3,
    },
    /// An acceleration acting on the mass, m/s².
    BodyForce {
        /// Acceleration, m/s².
        acceleration: Vec3,
    },
    /// Forces on nodes of one deformable block.
    Nodes {
        /// Numbers of nodes in the block, and the force on each, N.
        forces: Vec<(u32, Vec3)>,
    },
    /// Forces of a law of code, which finds them in an evaluation once contacts are known. It acts on all blocks there are.
    Own {
        /// Force (N) and moment about the centroid (N m) by number of block; none on those beyond.
        wrenches: Vec<[Vec3; 2]>,
    },
}

/// A bolt, from its head into the rock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bolt {
    /// Name used in the scenario, with a number for those of a pattern.
    pub name: String,
    /// Head, m.
    pub head: Vec3,
    /// Toe, m.
    pub toe: Vec3,
    /// What it is made of.
    pub design: Design,
}

/// Something inside the rock that pushes on the faces around it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// Name used in the scenario.
    pub name: String,
    /// Where the charge lies. The blocks that touch it are removed at the start, after refinement; the faces they
    /// shared with the others are pushed.
    pub place: Place,
    /// Time at which it goes off, s.
    pub delay: f64,
    /// What pushes.
    pub push: CavityPressure,
    /// What a charge along a line has of its hole.
    pub hole: Hole,
}

/// What a charge along a line has of its hole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Hole {
    /// How it burns; at once without.
    pub detonation: Option<Detonation>,
    /// What stands above it; the hole stays closed without.
    pub stemming: Option<Stemming>,
}

/// A detonation that runs along a charge, both ways from its primer.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Detonation {
    /// Distance of the primer from the end of the charge towards the collar, m.
    pub primer: f64,
    /// m/s.
    pub velocity: f64,
}

/// A column of stemming above a charge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stemming {
    /// m.
    pub length: f64,
    /// Of the hole, m.
    pub diameter: f64,
    /// kg/m³.
    pub density: f64,
    /// Shear stress at its side, Pa.
    pub friction: f64,
    /// Pressure of the air on it, Pa.
    pub air: f64,
}

/// Where a charge lies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Place {
    /// Concentrated: the finest blocks that touch the point (8 around a grid corner).
    Point {
        /// Centre, m.
        centre: Vec3,
    },
    /// Elongated: the finest blocks that touch the line.
    Line {
        /// One end (collar side), m.
        from: Vec3,
        /// Other end (toe), m.
        to: Vec3,
    },
    /// All blocks of a group.
    Blocks {
        /// Indices.
        blocks: Vec<u32>,
    },
}

/// What pushes on the faces of a cavity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum CavityPressure {
    /// Detonation gas on its adiabat, in balance with the volume of the cavity.
    Gas {
        /// The explosive.
        explosive: Products,
        /// Mass of the charge, kg.
        mass: f64,
        /// How charge volume and cavity volume are matched.
        coupling: Coupling,
        /// Rule by which the gas escapes; `None` seals it in.
        venting: Option<Venting>,
    },
    /// A pressure history that does not depend on the volume, Pa; argument is the time since `delay`.
    Pressure {
        /// Pressure, Pa.
        time: TimeFunction,
    },
}

/// How charge volume V0 and the volume Vc of the removed blocks are matched.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Coupling {
    /// Faces count with the factor `(V0/Vc)^exponent`: 2/3 keeps the wall force, 1/2 the elastic plateau, 1 keeps P V.
    Scaled {
        /// Exponent.
        exponent: f64,
    },
    /// The gas starts at V0 whatever the faces are.
    Coupled,
    /// The gas starts expanded to Vc.
    Decoupled,
}

/// Rule by which gas escapes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Venting {
    /// At once, when the mean displacement of the blocks `above` the charge (the free surface over it) has
    /// reached this height, m.
    Heave {
        /// Displacement against gravity, m.
        height: f64,
    },
    /// At a time after the detonation, s, fading over `span`.
    Time {
        /// Start, s.
        start: f64,
        /// Time over which the pressure falls to zero, s.
        span: f64,
    },
    /// Through the cracks that it has made: broken joints are a network ([`crate::flow`]).
    Cracks(Cracks),
}

/// Cracks that gas enters.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cracks {
    /// Friction of the flow.
    pub friction: Friction,
    /// Aperture of a crack whose walls touch, m; what it opens adds to it.
    pub aperture: f64,
    /// Largest aperture that counts for the flow, m; the volume has no such limit.
    pub widest: f64,
    /// Pressure of the air, Pa: gas leaves against it.
    pub air: f64,
}

/// Splitting of blocks 1 to 8 (bricks and parallelepipeds). Neighbours never differ by more than one level: the planner splits
/// more blocks where needed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Refinement {
    /// Where.
    pub around: Region,
    /// Number of levels below the blocks as given.
    pub levels: u8,
    /// When: `None` before the first step.
    pub during: Option<During>,
}

/// A place in space, closed: a block belongs to it when it touches it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Region {
    /// A point.
    Point(Vec3),
    /// A segment.
    Line(Vec3, Vec3),
    /// A plane through a point with a unit normal.
    Plane(Vec3, Vec3),
    /// A sphere (solid): centre, radius.
    Ball(Vec3, f64),
    /// A solid box: lowest and highest corner.
    Box(Vec3, Vec3),
    /// Everywhere.
    All,
}

/// Criterion of splitting during a run; looked at every `every` steps for blocks in the region.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct During {
    /// What is compared.
    pub criterion: Criterion,
    /// Limit, Pa, 1/s or a share.
    pub above: f64,
    /// Steps between two looks.
    pub every: u64,
}

/// What splits a block during a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Criterion {
    /// Largest magnitude of a principal value of the block's average stress, Pa.
    Stress,
    /// Largest relative velocity over a patch of the block, over the distance of centroids, 1/s.
    StrainRate,
    /// Share of the block's points that have failed.
    Broken,
}
