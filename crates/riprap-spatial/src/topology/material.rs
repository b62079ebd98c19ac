//! Moduli of a material that change in the midst of a run: the stiffness of all that is made of them follows, displacements stay.
//!
//! Forces jump with the stiffness, and what is stored changes: that is the work of who changes the material, an edit. Masses do not change.

use crate::contact::change_laws;
use crate::deform::build::stiffness;
use crate::setup::Material;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::topology::renew_laws;

/// What keeps moduli of a material from being changed, in words.
#[must_use]
pub fn obstacle(world: &World, row: u16) -> Option<String> {
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
    if deform.relax.is_some() {
        return Some(
            "the phase relaxes deformable blocks; change it in a dynamic phase".to_owned(),
        );
    }
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

/// Gives a material other moduli. Forces must be known, and evaluated anew afterwards with a workspace that is laid out anew; what the ledger is
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
