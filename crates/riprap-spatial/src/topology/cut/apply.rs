//! New blocks in the lists of the world, and their nodes.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::cut::Part;

use crate::state::bodies::SolidClass;
use crate::state::deform::{Body, Deform, Start};
use crate::state::world::World;
use crate::topology::cut::transfer::Cut;
use crate::topology::family::{self, Family, Moving};

/// Appends the parts of all families to the lists of the world, their nodes to those of `deform`.
pub(super) fn append(world: &mut World, deform: &mut Deform, families: &[Family], cuts: &[Cut]) {
    deform.start.resize(deform.bodies.len(), Start::default());
    for (family, cut) in families.iter().zip(cuts) {
        let parts = cut.parts.iter().zip(&cut.shapes);
        for (octant, (part, shape)) in (0..).zip(parts) {
            let spec = &world.setup.blocks[family.parent as usize];
            let velocity = spec.velocity;
            let (setup, lineage) = (&mut world.setup, &mut world.lineage);
            family::describe(setup, lineage, (family.parent, octant), (shape.clone(), velocity));
            block(world, family.parent as usize, part);
            body(world, deform, family.parent, part);
        }
        let handed = &cut.handed;
        deform.nodes.displacement.extend_from_slice(&handed.displacement);
        deform.nodes.velocity.extend_from_slice(&handed.velocity);
        deform.start.extend_from_slice(&handed.starts);
        for set in &mut world.setup.deform.sets {
            if set.blocks.binary_search(&family.parent).is_ok() {
                set.blocks.extend(family.children());
            }
        }
    }
}

fn block(world: &mut World, parent: usize, part: &Part) {
    let density = world.setup.materials[usize::from(world.setup.blocks[parent].material)].density;
    // Of crooked faces the tetrahedra decide: they carry the mass, and together have the volume of the block.
    let (centroid, solid) = SolidClass::bounded_by(&part.solid, density, Some(part.mesh.volume()));
    world.solids.push(solid);
    let bodies = &world.bodies;
    let part = Moving {
        solid: world.solids.len() - 1,
        lever: Vec3::ZERO,
        centre: world.reference[parent] + centroid,
        displacement: [bodies.displacement(parent), bodies.rotation(parent)],
        velocity: [bodies.velocity(parent), bodies.spin(parent)],
        turned: None,
    };
    family::append(world, parent, part);
}

fn body(world: &World, deform: &mut Deform, parent: u32, part: &Part) {
    let block = deform.slot.len() as u32;
    let whole = deform.bodies[deform.slot[parent as usize] as usize];
    deform.slot.push(deform.bodies.len() as u32);
    deform.classes.push(block);
    deform.bodies.push(Body {
        block,
        class: deform.classes.len() as u32 - 1,
        first: deform.nodes.len() as u32,
        count: part.mesh.nodes.len() as u32,
        alive: true,
        ..whole
    });
    let centre = world.reference[parent as usize];
    deform.nodes.place.extend(part.mesh.nodes.iter().map(|node| *node + centre));
}
