//! State of deformable blocks and their bonds: what a checkpoint holds.

use std::ops::Range;

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::bond;
use crate::laws::bond::Traction;
use crate::laws::tetrahedron::Symmetric;
use crate::setup::deform::Strain;
pub use crate::state::anchor::Anchor;
use crate::state::cutting::Cutting;
use crate::state::hold::Hold;
use crate::state::interface::Origin;
use crate::state::relax::Relax;

/// Not a deformable block.
pub const RIGID: u32 = u32::MAX;

/// All deformable blocks, their bonds, and what holds and loads them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Deform {
    /// Place of each block of the world in `bodies`; [`RIGID`] for rigid ones.
    pub slot: Vec<u32>,
    /// Deformable blocks in the order of their nodes.
    pub bodies: Vec<Body>,
    /// Blocks of the world whose shape and material a class of bodies has; congruent blocks of one material share a class.
    pub classes: Vec<u32>,
    /// Motion of the nodes.
    pub nodes: Nodes,
    /// Prescribed motion of nodes, by node.
    pub holds: Vec<Hold>,
    /// Free parts of faces with a condition, and walls of cavities.
    pub surfaces: Vec<Surface>,
    /// Stress that the bodies have before they deform; shorter or empty where they have none.
    pub start: Vec<Start>,
    /// Shared parts of faces.
    pub facets: Vec<Facet>,
    /// Points of all facets, in the order of the facets.
    pub points: Vec<Point>,
    /// State of the points.
    pub memory: Vec<Memory>,
    /// Facets with a point that has broken or softened, or was joined under load; others are linear.
    pub has_history: Vec<bool>,
    /// Which masses the nodes have.
    pub masses: Masses,
    /// Whether bonds may break in the present phase.
    pub breaking: bool,
    /// State of a relaxing phase; `None` in dynamic phases.
    pub relax: Option<Relax>,
    /// Cutting in the present phase; `None` where it does not cut.
    pub cutting: Option<Cutting>,
    /// Number of blocks before the first cut.
    pub given: Option<u32>,
    /// Step at which breaking was last looked at.
    pub last_check_step: u64,
    /// Facets that have broken since the last record.
    pub broken: Vec<Break>,
    /// Area of bonds broken so far by mode (tension, shear), m².
    pub broken_area: [f64; 2],
    /// Events of breaking in static phases so far.
    pub breaks: u64,
    /// Largest of 1/utilisation over these events.
    pub peak_share: f64,
    /// Blocks cut so far.
    pub cut_blocks: u64,
    /// Largest ratio of net to external forces just after a cut.
    pub cut_unbalanced: f64,
}

/// One deformable block.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Index of the block in the world.
    pub block: u32,
    /// Index into `classes`.
    pub class: u32,
    /// Its first node.
    pub first: u32,
    /// Number of its nodes.
    pub count: u32,
    /// Measure of strain.
    pub strain: Strain,
    /// Cut or removed blocks stay in the lists.
    pub alive: bool,
}

impl Body {
    /// Its nodes.
    #[must_use]
    pub fn nodes(&self) -> std::ops::Range<usize> {
        self.first as usize..(self.first + self.count) as usize
    }
}

/// Motion of all nodes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Nodes {
    /// Place at the start, m (local).
    pub place: Vec<Vec3>,
    /// Displacement, m.
    pub displacement: Vec<[f64; 3]>,
    /// Velocity half a step ago, m/s (fictitious while relaxing).
    pub velocity: Vec<[f64; 3]>,
}

impl Nodes {
    /// Number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.place.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.place.is_empty()
    }
}

/// Which masses the nodes have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Masses {
    /// A quarter of each tetrahedron to each of its nodes.
    #[default]
    Lumped,
    /// Lumped ones scaled so that the block has its true moment of inertia; the rest sits on the centroid node.
    Inertia,
}

/// Stress of a body before it deforms: in-situ stress, or what it had when it was cut from another.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Start {
    /// Second Piola-Kirchhoff stress of each tetrahedron, Pa; empty for none.
    pub stresses: Vec<Symmetric>,
    /// Energy stored without displacements, J.
    pub energy: f64,
}

/// What acts on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Acts {
    /// Index into `Setup::boundaries`.
    Boundary(u16),
    /// Index into `Setup::sources`.
    Cavity(u16),
}

/// A free part of a face with a condition, or a wall of a cavity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Place of the block in `bodies`.
    pub body: u32,
    /// What acts on it.
    pub acts: Acts,
    /// Unit outward normal at the start.
    pub normal: Vec3,
    /// Nodes and the area of each that is free, m².
    pub nodes: Vec<(u32, f64)>,
    /// Heights at which a traction that is linear in z has its mean over the area of each node, m (local).
    pub heights: Vec<f64>,
}

impl Surface {
    /// The condition on it; `None` for walls of cavities.
    #[must_use]
    pub fn boundary(&self) -> Option<usize> {
        match self.acts {
            Acts::Boundary(k) => Some(usize::from(k)),
            Acts::Cavity(_) => None,
        }
    }
}

/// The shared part of two faces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Facet {
    /// Blocks A and B of the world, at least one of them deformable.
    pub blocks: [u32; 2],
    /// Unit normal n from A to B, then b and c: right-handed, at the start.
    pub frame: [Vec3; 3],
    /// The same now: turned with its blocks where they use large strain or finite rotations.
    pub now: [Vec3; 3],
    /// Centre, m (local, on the side of A).
    pub centre: Vec3,
    /// Area, m².
    pub area: f64,
    /// First point.
    pub first: u32,
    /// Number of points.
    pub count: u32,
    /// Normal and shear stiffness per area, Pa/m.
    pub stiffness: [f64; 2],
    /// Index into `Setup::interfaces`.
    pub row: u16,
    /// Which sides are rigid blocks.
    pub rigid: [bool; 2],
    /// Where it comes from.
    pub origin: Origin,
    /// Step before which it does not break: a facet made by a cut in a dynamic phase waits for the next look.
    pub intact_until_step: u64,
    /// Whether its blocks have slid or come apart so far that it carries nothing any more: they find each other anew.
    pub parted: bool,
}

impl Facet {
    /// One without points between two blocks, with the row of the table of interfaces and the stiffness of its law.
    pub(crate) fn new(
        blocks: [u32; 2],
        frame: [Vec3; 3],
        (row, stiffness): (u16, [f64; 2]),
        rigid: [bool; 2],
    ) -> Self {
        Self {
            blocks,
            frame,
            now: frame,
            centre: Vec3::ZERO,
            area: 0.0,
            first: 0,
            count: 0,
            stiffness,
            row,
            rigid,
            origin: Origin::Built,
            intact_until_step: 0,
            parted: false,
        }
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> std::ops::Range<usize> {
        self.first as usize..(self.first + self.count) as usize
    }
}

/// A point of a facet: a spring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// On A and on B.
    pub anchors: [Anchor; 2],
    /// Its share of the area, m².
    pub area: f64,
}

/// State of a point. Components along n, b, c of its facet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    /// Traction at zero jump, Pa: bonds inserted under load.
    pub start: Traction,
    /// Damage and slip at the last committed instant.
    pub law: bond::State,
    /// What the states since then, on the way to an equilibrium, have lost, J/m²: still counted as stored, because only the
    /// state that is committed tells what has taken it.
    pub unbooked: f64,
    /// How it is.
    pub state: State,
    /// Time at which it broke, s.
    pub broken_at: f64,
    /// Whether it has broken and no event tells of it yet.
    pub unreported: bool,
}

/// How a point is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum State {
    /// Joined.
    #[default]
    Bonded,
    /// Broken by tension.
    Opened,
    /// Broken by shear.
    Sheared,
}

impl State {
    /// Whether it is broken.
    #[must_use]
    pub fn is_broken(self) -> bool {
        match self {
            Self::Bonded => false,
            Self::Opened | Self::Sheared => true,
        }
    }
}

/// Points of a facet that broke in one event.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Break {
    /// Step number.
    pub step: u64,
    /// Time, s.
    pub time: f64,
    /// The facet.
    pub facet: u32,
    /// Broken by tension and by shear, m².
    pub area: [f64; 2],
    /// Utilisation at which it broke.
    pub utilisation: f64,
    /// Energy that the points held and no longer hold, J.
    pub released: f64,
}

impl Deform {
    /// The deformable block `b` of the world, if it is one.
    #[must_use]
    pub fn body(&self, b: usize) -> Option<&Body> {
        match self.slot.get(b) {
            Some(&slot) if slot != RIGID => self.bodies.get(slot as usize),
            Some(_) | None => None,
        }
    }

    /// Number of points of a facet that have broken.
    #[must_use]
    pub fn failed_points(&self, facet: &Facet) -> u64 {
        let points = &self.memory[facet.points()];
        points.iter().filter(|m| m.state.is_broken()).count() as u64
    }

    /// Living bodies.
    pub fn living(&self) -> impl Iterator<Item = &Body> {
        self.bodies.iter().filter(|b| b.alive)
    }

    /// Takes a block out, a rigid one too: its facets and surfaces go, its nodes stay in the lists at rest.
    pub fn retire(&mut self, block: u32) {
        if let Some(nodes) = self.still(block) {
            let slot = self.slot[block as usize];
            self.holds.retain(|h| !nodes.contains(&(h.node as usize)));
            self.surfaces.retain(|s| s.body != slot);
        }
        self.drop_facets(|facet| facet.blocks.contains(&block));
    }

    /// Ends the life of a deformable block and the motion of its nodes, which it returns.
    pub(crate) fn still(&mut self, block: u32) -> Option<Range<usize>> {
        let slot = self.slot.get(block as usize).filter(|s| **s != RIGID)?;
        let body = &mut self.bodies[*slot as usize];
        body.alive = false;
        self.nodes.velocity[body.nodes()].fill([0.0; 3]);
        Some(body.nodes())
    }

    /// Takes facets with their points out of the lists; the others close up.
    pub(crate) fn drop_facets(&mut self, goes: impl Fn(&Facet) -> bool) {
        let (mut to, mut point) = (0, 0);
        for k in 0..self.facets.len() {
            let facet = self.facets[k];
            if goes(&facet) {
                continue;
            }
            self.facets[to] = Facet { first: point as u32, ..facet };
            self.has_history[to] = self.has_history[k];
            self.points.copy_within(facet.points(), point);
            self.memory.copy_within(facet.points(), point);
            to += 1;
            point += facet.count as usize;
        }
        self.facets.truncate(to);
        self.has_history.truncate(to);
        self.points.truncate(point);
        self.memory.truncate(point);
    }
}
