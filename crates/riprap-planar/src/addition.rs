//! Adding blocks while a model runs: what code between two steps asks for.
//!
//! An added block is at its place of the start where it is put: displacements count from there, and its weight does no work before. It has no joints,
//! since joints are those of edges that blocks share at the start; supports and loads stay with the blocks of the start. All lists of the
//! world grow by one at their ends, so that numbers keep their meaning and a checkpoint holds what it needs.

use riprap_geom::clip::overlap_depth;
use riprap_geom::polygon::{self, Collinear};
use riprap_geom::{GeomError, Vec2};

use super::scratch::Scratch;
use super::setup::BlockSpec;
use super::view::View;
use super::world::{Body, World};

/// Depth that round-off of coordinates explains, over the root of the smaller area: that which scenes may have at the start.
const ACCEPTED: f64 = 1e-6;

/// A block to be added.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NewBlock {
    /// A name that no block has.
    pub name: String,
    /// Corners in either direction, m, local.
    pub vertices: Vec<Vec2>,
    /// Index into `Setup::materials`.
    pub material: u16,
    /// Of the centroid, m/s.
    pub velocity: Vec2,
    /// rad/s.
    pub spin: f64,
    /// Indices into `Setup::groups`.
    pub groups: Vec<u16>,
}

/// Why a block cannot be added.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AddError {
    /// No polygon.
    #[error("{0}")]
    Outline(#[from] GeomError),
    /// The network of the joints is that of the blocks of the start.
    #[error("water seeps through the joints, which are those of the start")]
    Seeping,
    /// The setup was written by hand.
    #[error("its material has no density; give `Setup::densities`")]
    NoDensity,
    /// In another block.
    #[error("it lies {depth:.3e} m inside block {other:?}; move it away by as much")]
    Overlap {
        /// Name of that block.
        other: String,
        /// How deep, m.
        depth: f64,
    },
}

/// A block that can be added: it has been looked at, and nothing has changed.
#[derive(Clone, Debug)]
pub struct Addition {
    spec: BlockSpec,
    groups: Vec<u16>,
    mass: f64,
}

impl Addition {
    /// Looks at a block in the present state.
    ///
    /// # Errors
    /// An outline that is none, a block that lies in another one.
    pub fn plan(view: &View<'_>, new: NewBlock) -> Result<Self, AddError> {
        let world = view.world;
        if world.seepage.is_some() {
            return Err(AddError::Seeping);
        }
        let density = world.setup.densities.get(usize::from(new.material)).copied();
        let density = density.ok_or(AddError::NoDensity)?;
        let (vertices, _) = polygon::normalise(&new.vertices, Collinear::Keep);
        polygon::validate(&vertices)?;
        let own = polygon::mass_properties(&vertices);
        let radius = vertices.iter().map(|v| v.distance(own.centroid)).fold(0.0, f64::max);
        let shapes = &view.scratch.shapes;
        let mut deepest: Option<(usize, f64)> = None;
        for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
            let body = &world.bodies[b];
            if body.position.distance(own.centroid) >= radius + shapes.radius[b] {
                continue;
            }
            let other: Vec<Vec2> = shapes.of(b).iter().map(|e| body.place(e.start)).collect();
            let depth = overlap_depth(&vertices, &other).depth;
            let accepted = ACCEPTED * own.area.min(polygon::signed_area(&other)).sqrt();
            if depth > accepted && deepest.is_none_or(|(_, most)| depth > most) {
                deepest = Some((b, depth));
            }
        }
        if let Some((other, depth)) = deepest {
            return Err(AddError::Overlap { other: world.setup.blocks[other].name.clone(), depth });
        }
        let mass = density * own.area;
        let NewBlock { name, material, velocity, spin, groups, .. } = new;
        let spec = BlockSpec { name, vertices, material, density, velocity, spin };
        Ok(Self { spec, groups, mass })
    }

    /// Its mass, kg/m.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Adds the block; its number. Velocities of the state must be those of the present instant. Evaluate anew afterwards.
    pub fn apply(self, world: &mut World, scratch: &mut Scratch) -> u32 {
        let Self { spec, groups, mass: _ } = self;
        let (velocity, spin, number) = (spec.velocity, spec.spin, world.alive.len());
        world.setup.blocks.push(spec);
        scratch.grow(&world.setup);
        let position = scratch.shapes.centroid[number];
        world.bodies.push(Body { position, velocity, angle: 0.0, spin });
        world.reference.push(position);
        world.reference_angle.push(0.0);
        world.alive.push(true);
        world.motion.push(None);
        for group in groups {
            // The largest number of all: the list stays ascending.
            world.setup.groups[usize::from(group)].blocks.push(number as u32);
        }
        scratch.invalidate(world);
        scratch.watch(world);
        number as u32
    }
}
