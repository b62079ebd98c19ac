//! Adding rigid blocks: the planner for code between two steps.
//!
//! An added block is at its place of the start where it is put: displacements count from there, and its weight does no work before. It has no joints:
//! those of the model are found from shapes of the start, where nothing has moved. All others meet it by found contact, under the interface
//! of the two materials, and supports, loads and faces with a condition stay with the blocks of the start. It stays whole where bricks split, since
//! their balance is one of neighbours of the start.
//!
//! As for parts of a block, all lists of the world grow by one at their ends: a number keeps its meaning, and a checkpoint holds what it needs.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Polyhedron, SolidError, hull};

use crate::contact::clear;
use crate::faces::overlap;
use crate::faces::overlap::GAP;
use crate::joint::classes::stiffness;
use crate::kernel::Shape as ContactShape;
use crate::query::view::View;
use crate::setup::error::{BuildError, MAX_BLOCKS};
use crate::setup::{BlockName, BlockSpec, Shape, Solid};
use crate::state::bodies::SolidClass;
use crate::state::lineage::Origin;
use crate::state::world::World;

/// A rigid convex block to be added.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NewBlock {
    /// A name that no block has; `stone.17` is number 17 of the name `stone`.
    pub name: String,
    /// Corners, and faces in any one direction (none: the convex hull of the corners), m, local.
    pub solid: Solid,
    /// Index into `Setup::materials`.
    pub material: u16,
    /// Of the centroid, m/s.
    pub velocity: Vec3,
    /// rad/s.
    pub spin: Vec3,
    /// Indices into `Setup::groups`.
    pub groups: Vec<u16>,
}

/// Why a block cannot be added.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AddError {
    /// It would pass through all others.
    #[error(
        "contact detection is switched off (`space.spatial.found_contacts`): it would pass through all other blocks"
    )]
    NoContacts,
    /// The network of the joints is that of the blocks of the start.
    #[error("water seeps through the joints, which are those of the start")]
    Seeping,
    /// No convex solid.
    #[error("{0}")]
    Solid(#[from] SolidError),
    /// No shape for contact.
    #[error("{0}")]
    Shape(String),
    /// In another block.
    #[error("it lies {depth:.3e} m inside block {other:?}; move it away by as much")]
    Overlap {
        /// Name of that block.
        other: String,
        /// How deep, m.
        depth: f64,
    },
    /// In its own image.
    #[error("it lies {depth:.3e} m inside its own periodic image; make it shorter than the period")]
    Image {
        /// How deep, m.
        depth: f64,
    },
    /// A contact without stiffness.
    #[error("{0}")]
    Build(#[from] BuildError),
    /// No number is left.
    #[error("the model would have more than {MAX_BLOCKS} blocks, or {} names of blocks", u16::MAX)]
    TooMany,
}

/// A block that can be added: it has been looked at, and nothing has changed.
#[derive(Clone, Debug)]
pub struct Addition {
    spec: BlockSpec,
    /// Name that the setup has not yet, if there is one.
    base: Option<String>,
    groups: Vec<u16>,
    centre: Vec3,
    class: SolidClass,
}

impl Addition {
    /// Looks at a block in the present state.
    ///
    /// # Errors
    /// A block that is not convex, that lies in another one, or whose contacts have no stiffness.
    pub fn plan(view: &View, new: NewBlock) -> Result<Self, AddError> {
        let world = view.world;
        if !world.setup.found_contacts {
            return Err(AddError::NoContacts);
        }
        if world.seepage.is_some() {
            return Err(AddError::Seeping);
        }
        let Solid { vertices, faces } = new.solid;
        let body = match faces.is_empty() {
            true => hull(&vertices)?,
            false => Polyhedron::new(vertices, faces)?,
        };
        let density = world.setup.materials[usize::from(new.material)].density;
        let (centre, class) = SolidClass::bounded_by(&body, density, None);
        let shape = ContactShape::new(&body, centre).map_err(|e| AddError::Shape(e.to_string()))?;
        meets(world, new.material)?;
        let (number, volume) = (world.alive.len() as u32, class.volume);
        match clear::deepest(world, view.scratch, (&shape, volume), centre, number) {
            Some((other, depth)) if other == number => return Err(AddError::Image { depth }),
            Some((other, depth)) => {
                return Err(AddError::Overlap { other: world.name(other as usize), depth });
            }
            None => {}
        }
        let (name, base) = named(world, new.name).ok_or(AddError::TooMany)?;
        let shape =
            Shape::Polyhedron(Box::new(Solid { vertices: body.vertices, faces: body.faces }));
        let NewBlock { material, velocity, spin, groups, .. } = new;
        let spec = BlockSpec { name, shape, material, velocity, spin };
        Ok(Self { spec, base, groups, centre, class })
    }

    /// Its mass, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.class.mass
    }

    /// Adds the block; its number. Velocities of the state must be those of the present instant. Lay out and evaluate anew afterwards.
    pub fn apply(self, world: &mut World) -> u32 {
        let Self { spec, base, groups, centre, class } = self;
        let (velocity, spin) = (spec.velocity, spec.spin);
        world.setup.names.extend(base);
        world.setup.blocks.push(spec);
        world.lineage.push(Origin::ADDED);
        let b = world.bodies.push([Vec3::ZERO; 2], [velocity, spin]);
        if !world.datum.is_empty() {
            world.datum.resize(b + 1, [Vec3::ZERO; 2]);
        }
        world.reference.push(centre);
        world.solids.push(class);
        world.solid.push(world.solids.len() as u32 - 1);
        world.turned.push(None);
        world.alive.push(true);
        world.motion.push(None);
        world.peak_speed_squared.push(velocity.length_squared());
        if !world.found.left_terrain.is_empty() {
            world.found.left_terrain.resize(b + 1, false);
        }
        let number = b as u32;
        for group in groups {
            // The largest number of all: the list stays ascending.
            world.setup.groups[usize::from(group)].blocks.push(number);
        }
        // With its number these are the last ones of the list.
        let (_, faces) = overlap::touching(world, &[number], GAP * class.half.min_element());
        world.faces.extend(faces);
        number
    }
}

/// Whether contacts of a material with those of all living blocks have a stiffness.
fn meets(world: &World, material: u16) -> Result<(), BuildError> {
    let mut known = vec![false; world.setup.materials.len()];
    known[usize::from(material)] = true;
    for (spec, _) in world.setup.blocks.iter().zip(&world.alive).filter(|(_, alive)| **alive) {
        known[usize::from(spec.material)] = true;
    }
    for other in (0..known.len()).filter(|m| known[*m]) {
        let both = [usize::from(material), other];
        // Any depths will do: it is asked only whether the moduli are there.
        stiffness(&world.setup, world.setup.row_of(both), both, [1.0; 2])?;
    }
    Ok(())
}

/// A name as the setup keeps it, and the first word of it where that is new; `None` where no more fit in.
fn named(world: &World, name: String) -> Option<(BlockName, Option<String>)> {
    if world.alive.len() >= MAX_BLOCKS {
        return None;
    }
    let (base, number) = match name.rsplit_once('.') {
        Some((base, digits)) => match digits.parse::<u32>() {
            Ok(number) if number > 0 && number.to_string() == digits => (base.to_owned(), number),
            Ok(_) | Err(_) => (name, 0),
        },
        None => (name, 0),
    };
    let names = &world.setup.names;
    if let Some(k) = names.iter().position(|known| *known == base) {
        return Some((BlockName { base: u16::try_from(k).ok()?, number }, None));
    }
    let k = u16::try_from(names.len()).ok()?;
    Some((BlockName { base: k, number }, Some(base)))
}
