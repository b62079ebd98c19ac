//! Moduli and density of a material that change in the midst of a run: the stiffness and the mass of all that is made of it follow, displacements and
//! velocities stay.
//!
//! Forces jump with the stiffness, and what is stored changes, as momentum and kinetic energy do with the mass: that is the work of who changes the material, an edit.

use std::collections::BTreeMap;

use crate::contact::change_laws;
use crate::deform::build::stiffness;
use crate::setup::Material;
use crate::state::bodies::SolidClass;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::topology::renew_laws;

/// What keeps a material from being changed to another one, in words.
#[must_use]
pub fn obstacle(world: &World, row: u16, to: &Material) -> Option<String> {
    let now = &world.setup.materials[usize::from(row)];
    if world.deform.as_deref().is_some_and(|deform| deform.relax.is_some()) {
        return Some(
            "the phase relaxes deformable blocks; change it in a dynamic phase".to_owned(),
        );
    }
    if (now.young, now.poisson) == (to.young, to.poisson) {
        return None;
    }
    let made_of =
        |b: u32| world.alive[b as usize] && world.setup.blocks[b as usize].material == row;
    let behind = world.faces.iter().find(|face| {
        face.half_block.is_some() && made_of(face.block) && !world.deforms(face.block as usize)
    });
    if let Some(face) = behind {
        let block = world.name(face.block as usize);
        return Some(format!(
            "a boundary holds, moves or damps faces of block {block:?}, with springs behind them that were made of its moduli"
        ));
    }
    let deform = world.deform.as_deref()?;
    let history = deform.facets.iter().zip(&deform.has_history).find(|(facet, has_history)| {
        **has_history && !facet.parted && facet.blocks.into_iter().any(made_of)
    });
    history.map(|(facet, _)| {
        let [a, b] = facet.blocks.map(|b| world.name(b as usize));
        format!(
            "the bond between {a:?} and {b:?} has softened, broken, or was joined under load, by the stiffness it had"
        )
    })
}

/// Gives a material other moduli and another density; blocks whose mass the scene gives keep it. Forces must be known, and evaluated anew afterwards with a workspace that is laid out anew; what the ledger is
/// left with between the two is the energy of the edit.
///
/// # Errors
/// A law that lacks moduli, in words.
pub fn change(
    world: &mut World,
    scratch: &Scratch,
    row: u16,
    material: Material,
) -> Result<(), String> {
    let by = material.density / world.setup.materials[usize::from(row)].density;
    if by != 1.0 {
        change_masses(world, row, by);
    }
    change_laws(world, scratch, |world| world.setup.materials[usize::from(row)] = material);
    renew_laws(world);
    let World { deform, setup, reference, .. } = world;
    for facet in deform.iter_mut().flat_map(|deform| &mut deform.facets) {
        let blocks = facet.blocks.map(|b| b as usize);
        let materials = blocks.map(|b| usize::from(setup.blocks[b].material));
        let Some(law) = &setup.interfaces[usize::from(facet.row)].bond else {
            continue;
        };
        let n = facet.frame[0];
        let depths = [
            (facet.centre - reference[blocks[0]]).dot(n),
            (reference[blocks[1]] - facet.centre).dot(n),
        ];
        if materials.contains(&usize::from(row)) {
            facet.stiffness = stiffness(setup, law, materials, facet.rigid, depths)
                .map_err(|wrong| wrong.to_string())?;
        }
    }
    Ok(())
}

/// Multiplies the masses of the living blocks of a material, and what their viscous faces stand for. Equal blocks share a class: each class has its heavier twin.
fn change_masses(world: &mut World, row: u16, by: f64) {
    let mut given = vec![false; world.alive.len()];
    for body in &world.setup.bodies {
        given[body.block as usize] = true;
    }
    let mut twins = BTreeMap::new();
    // What a viscous face stands for beyond it is rock as heavy as before it.
    for face in
        world.faces.iter_mut().filter(|f| world.setup.blocks[f.block as usize].material == row)
    {
        if let Some(half) = &mut face.half_block {
            half.impedance = half.impedance.map(|impedance| by.sqrt() * impedance);
        }
    }
    for (b, given) in given.into_iter().enumerate() {
        if given || !world.alive[b] || world.setup.blocks[b].material != row {
            continue;
        }
        let class = world.solid[b];
        let solids = &mut world.solids;
        world.solid[b] = *twins.entry(class).or_insert_with(|| {
            let of = solids[class as usize];
            let (mass, inertia, inverse) = (by * of.mass, by * of.inertia, (1.0 / by) * of.inverse);
            solids.push(SolidClass { mass, inertia, inverse, ..of });
            solids.len() as u32 - 1
        });
        if let Some(turned) = &mut world.turned[b] {
            // The spin stays.
            turned.momentum *= by;
        }
    }
}
