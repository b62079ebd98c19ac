//! Found contacts of deformable blocks: with each other, and with rigid ones.
//!
//! Every block is a star of tetrahedra that carry a depth (`found::cells`), whatever it is joined to: nil on its whole surface. Two blocks that
//! no facet joins store `2 kn` times the integral of the smaller depth over their overlap (`found::tetra`). A facet that has failed, and has slid
//! or opened too far for what it knows, parts (`part`): from then on its blocks find each other here; nothing counts twice.
//! Deviation: where bonds hold, faces count as surface too. So a pair of blocks is all that a contact depends on: breaking frees
//! nothing that was not there, and energy and force have no jump. Pressure on a joined body dips along its joints over the width of the depth.
//!
//! The list of pairs is a function of the state of the last look (`search`); what a pair exerts depends on the pair alone (`act`,
//! `law`), and forces go to nodes in the order of the pairs: the same bits for any number of threads. The energy of the pressure is found
//! exactly, so that the ledger shows what the integration in time makes of it.

mod act;
mod law;
mod limit;
mod part;
pub(crate) mod search;

pub(crate) use act::{act, depart};
pub(crate) use part::part;
pub(crate) use search::{can_meet, refresh};

use riprap_geom::polyhedron::GluedCells;

use crate::contact::CHECK_INTERVAL;
use crate::joint::classes::stiffness;
use crate::kernel::ContactLaw;
use crate::ledger::Works;
use crate::setup::error::BuildError;
use crate::setup::{InterfaceLaw, Setup, Shape};
use crate::state::deformable::DeformablePair;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// The law between two blocks: that of the bonds of their interface, or of its joints where it has none. `depths` are the
/// distances of their centres from the surface, m; `rigid` says which are rigid.
///
/// # Errors
/// A material that lacks moduli.
pub(crate) fn between(
    setup: &Setup,
    ends: [u32; 2],
    rigid: [bool; 2],
    depths: [f64; 2],
) -> Result<ContactLaw, BuildError> {
    let materials = ends.map(|b| usize::from(setup.blocks[b as usize].material));
    let row = setup.pair_table[materials[0] * setup.materials.len() + materials[1]];
    let InterfaceLaw { joint, bond, friction, .. } = &setup.interfaces[usize::from(row)];
    // What is elastic neither opens nor slides; a found contact under its law must open, and slides if it is told when.
    let elastic = friction.unwrap_or(f64::INFINITY);
    let (springs, friction, cohesion) = match bond {
        Some(bond) => (
            crate::deform::build::stiffness(setup, bond, materials, rigid, depths)?,
            bond.strength.map_or(elastic, |s| s.residual_friction),
            bond.strength.map_or(0.0, |s| s.residual_cohesion),
        ),
        None => (
            stiffness(setup, row, materials, depths)?.0,
            joint.strength.map_or(elastic, |s| s.residual_friction),
            joint.strength.map_or(0.0, |s| s.residual_cohesion),
        ),
    };
    Ok(ContactLaw {
        normal_stiffness: springs[0],
        shear_stiffness: springs[1],
        friction,
        cohesion,
        damping_ratio: joint.contact_damping,
        rebound: 0.0,
        growth: 0.0,
    })
}

/// Looks at all laws that found contacts of deformable blocks can ask for, so that none is missing in the middle of a run.
///
/// # Errors
/// A stiffness without modulus; glued parts whose depth cannot be found on tetrahedra.
pub(crate) fn check(world: &World) -> Result<(), BuildError> {
    if !world.setup.found_contacts || world.deform.is_none() {
        return Ok(());
    }
    for (b, spec) in world.setup.blocks.iter().enumerate() {
        if let Shape::Glued(parts) = &spec.shape
            && GluedCells::new(&search::about(parts, world.reference[b])).is_none()
        {
            let reason = "cannot touch deformable blocks: the tetrahedra of its depth do not fill it; \
                          use fewer, larger parts with planar faces, or make all blocks rigid";
            return Err(BuildError::Glued { block: world.name(b), reason });
        }
    }
    let count = world.setup.materials.len();
    // A block of each material, deformable and rigid.
    let mut some = vec![[None; 2]; count];
    for (b, spec) in world.setup.blocks.iter().enumerate() {
        if world.alive[b] {
            some[usize::from(spec.material)][usize::from(world.deforms(b))] = Some(b as u32);
        }
    }
    for a in some.iter().filter_map(|s| s[1]) {
        for s in &some {
            for (deformable, b) in s.iter().enumerate() {
                if let Some(b) = *b {
                    between(&world.setup, [a, b], [false, deformable == 0], [1.0; 2])?;
                }
            }
        }
    }
    Ok(())
}

/// Books what a pair still holds that is no longer looked at: friction what its springs, an edit what its pressure.
fn drop_pair(works: &mut Works, pair: &DeformablePair) {
    works.friction += pair.stored;
    works.edit_defect -= pair.energy;
}

/// Ends all of these contacts.
fn leave(world: &mut World, scratch: &mut Scratch) {
    for pair in std::mem::take(&mut world.found.deformable.pairs) {
        drop_pair(&mut world.works, &pair);
    }
    world.found.deformable.search = Default::default();
    scratch.deformable = Default::default();
    scratch.pushes.own.blocks.clear();
    scratch.tiles.make_rows(world);
}

#[cfg(test)]
mod tests;
