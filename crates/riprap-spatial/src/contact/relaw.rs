//! Stiffness that changes under found contacts: what they store grows with it, and no work has put that in.
//!
//! Pressures and their energy are proportional to the normal stiffness. What springs along a contact remember is their force, so their energy
//! falls as they grow stiffer. Both are the work of who changes the law, an edit: neither friction nor the ledger of the contact may have it.

use crate::contact::constants::present;
use crate::contact::deformable::between;
use crate::contact::stored;
use crate::contact::stored::at_most;
use crate::kernel::ContactLaw;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// The laws of all found contacts, in the order of their lists.
struct Laws {
    pairs: Vec<ContactLaw>,
    deformable: Vec<ContactLaw>,
}

impl Laws {
    fn of(world: &World, scratch: &Scratch) -> Self {
        let pairs = world.found.pairs.iter();
        Self {
            pairs: pairs.map(|pair| present(world, &scratch.desk, pair)).collect(),
            deformable: scratch
                .deformable
                .constants
                .iter()
                .map(|c| {
                    let two = c.members.map(|m| &scratch.deformable.members[m as usize]);
                    let (ends, peaks) = (two.map(|m| m.block), two.map(|m| m.peak));
                    let rigid = two.map(|m| m.body.is_none());
                    // Looked at when the model was built.
                    between(&world.setup, ends, rigid, peaks).unwrap_or(c.law)
                })
                .collect(),
        }
    }
}

/// Changes laws by `change`, and what found contacts store with them. Forces must be known, and evaluated anew afterwards; what the ledger is left
/// with between the two is the energy of the edit.
pub fn change_laws(world: &mut World, scratch: &Scratch, change: impl FnOnce(&mut World)) {
    let desk = &scratch.desk;
    let known = desk.slots.len() == world.found.pairs.len();
    let before = known.then(|| Laws::of(world, scratch));
    let energies = known.then(|| at_most(world, desk));
    let whole = stored::stored(world, desk, &scratch.exec) + world.found.at_start;
    change(world);
    let (Some(before), Some(energies)) = (before, energies) else {
        return;
    };
    let after = Laws::of(world, scratch);
    let normal = |laws: [&ContactLaw; 2]| laws[1].normal_stiffness / laws[0].normal_stiffness - 1.0;
    let all: f64 = energies.iter().sum();
    let pairs = energies.iter().zip(before.pairs.iter().zip(&after.pairs));
    let added: f64 = pairs.map(|(energy, (old, new))| energy * normal([old, new])).sum();
    // Where faces meet flat what each stores is known, else its share of what all of them do.
    if all > 0.0 && whole > 0.0 {
        world.works.contact_path += added * (whole / all).min(1.0);
    }
    let laws = before.deformable.iter().zip(&after.deformable);
    for (pair, (old, new)) in world.found.deformable.pairs.iter_mut().zip(laws) {
        pair.stored *= old.shear_stiffness / new.shear_stiffness;
    }
}
