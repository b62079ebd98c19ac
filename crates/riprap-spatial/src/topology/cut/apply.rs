//! New blocks in the lists of the world, their nodes, and the end of the parents.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::cut::Part;

use crate::setup::BlockSpec;
use crate::state::bodies::SolidClass;
use crate::state::deform::{Body, Deform, Start};
use crate::state::lineage::Origin;
use crate::state::world::World;
use crate::topology::cut::plan::{Cut, Family};

/// Appends the parts of all families to the lists of the world, their nodes to those of `deform`.
pub(super) fn append(world: &mut World, deform: &mut Deform, families: &[Family]) {
    for family in families {
        let handed = &family.cut.handed;
        let mut first = 0;
        deform.start.resize(deform.bodies.len(), Start::default());
        for (k, part) in family.cut.parts.iter().enumerate() {
            block(world, family.cut, k);
            body(world, deform, family, part);
            let nodes = first..first + part.mesh.nodes.len();
            let (displacement, velocity) =
                (&handed.displacement[nodes.clone()], &handed.velocity[nodes.clone()]);
            deform.nodes.displacement.extend_from_slice(displacement);
            deform.nodes.velocity.extend_from_slice(velocity);
            deform.start.push(handed.starts[k].clone());
            first = nodes.end;
        }
        for set in &mut world.setup.deform.sets {
            if set.blocks.binary_search(&family.cut.block).is_ok() {
                set.blocks.extend(family.children());
            }
        }
    }
}

fn block(world: &mut World, cut: &Cut, number: usize) {
    let (parent, part) = (cut.block as usize, &cut.parts[number]);
    let centre = world.reference[parent];
    let spec = &world.setup.blocks[parent];
    let spec = BlockSpec {
        shape: cut.shapes[number].clone(),
        name: spec.name,
        material: spec.material,
        velocity: spec.velocity,
        spin: spec.spin,
    };
    let density = world.setup.materials[usize::from(spec.material)].density;
    let moments = part.solid.moments();
    let (mut half, mut radius) = (Vec3::ZERO, 0.0_f64);
    for corner in &part.solid.vertices {
        let arm = *corner - moments.centroid;
        half = half.max(arm.abs());
        radius = radius.max(arm.length());
    }
    // Of crooked faces the tetrahedra decide: they carry the mass, and together have the volume of the block.
    let volume = part.mesh.volume();
    let inertia = density * volume / moments.volume * moments.inertia;
    world.solids.push(SolidClass {
        mass: density * volume,
        volume,
        inertia,
        inverse: inertia.inverse(),
        half,
        radius,
        diagonal: false,
    });
    world.solid.push(world.solids.len() as u32 - 1);
    world.setup.blocks.push(spec);
    let level = world.lineage[parent].level + 1;
    world.lineage.push(Origin { parent: parent as u32, octant: number as u8, level });
    world.reference.push(centre + moments.centroid);
    world.turned.push(None);
    world.alive.push(true);
    world.motion.push(world.motion[parent].clone());
    world.peak_speed_squared.push(world.peak_speed_squared[parent]);
    let child = world.bodies.push(
        [world.bodies.displacement(parent), world.bodies.rotation(parent)],
        [world.bodies.velocity(parent), world.bodies.spin(parent)],
    );
    if !world.datum.is_empty() {
        let datum = world.datum(parent);
        world.datum.resize(child, [Vec3::ZERO; 2]);
        world.datum.push(datum);
    }
}

fn body(world: &World, deform: &mut Deform, family: &Family, part: &Part) {
    let block = deform.slot.len() as u32;
    deform.slot.push(deform.bodies.len() as u32);
    deform.classes.push(block);
    deform.bodies.push(Body {
        block,
        class: deform.classes.len() as u32 - 1,
        first: deform.nodes.len() as u32,
        count: part.mesh.nodes.len() as u32,
        alive: true,
        ..deform.bodies[family.slot as usize]
    });
    let centre = world.reference[family.cut.block as usize];
    for node in &part.mesh.nodes {
        deform.nodes.place.push(*node + centre);
    }
}

/// Ends the life of a parent; its facets and surfaces are gone already.
pub(super) fn retire(world: &mut World, deform: &mut Deform, family: &Family) {
    world.alive[family.cut.block as usize] = false;
    let body = &mut deform.bodies[family.slot as usize];
    body.alive = false;
    let nodes = body.nodes();
    deform.nodes.velocity[nodes].fill([0.0; 3]);
}
