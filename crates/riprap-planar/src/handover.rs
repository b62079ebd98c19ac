//! Hand-over from joints that have given way to found contact.
//!
//! The force stays what it was: found contact starts with the joint's shear force, and an offset
//! makes up the difference between the joint's compression and the pressure of the overlap, both
//! ways. A pair that has turned about one end of its joint overlaps there where no point of the joint
//! felt it; that pressure is held back by a negative offset, which the contact never gets back: it
//! shrinks as the blocks part and fades with slip.
//!
//! Books: the energy that found contact stores beyond that of the joint, and the work of the offset, are
//! booked as `edit_defect`. Both forces meet in the middle of a step, so that each has done half a
//! step's work that no later evaluation sees; that is booked here too.

use super::contact::{self, Context, Pressed, Relative};
use super::scratch::{Scratch, Workspace};
use super::setup::{ContactLaw, NormalLaw};
use super::view;
use super::world::{Contact, PairState, Region, World, Wrench};

/// Share of the joint's length over which the offset fades with slip.
const FADE: f64 = 0.1;

/// What the joints of one pair have borne.
struct Borne {
    pair: (u32, u32),
    /// N/m.
    compression: f64,
    /// On the first block along the left-hand side of the joint's normal, N/m.
    shear: f64,
    /// m.
    length: f64,
}

/// Lets found contact take over from the joints that have given way. To be called once after each
/// move: the forces at the end of the move are then those of found contact alone.
pub(crate) fn hand_over(world: &mut World, scratch: &mut Scratch) {
    let borne = close(world);
    if borne.is_empty() {
        return;
    }
    scratch.invalidate(world);
    for pair in &borne {
        open(world, scratch, pair);
    }
}

/// Closes the joints and their accounts. A pair goes over as a whole: its joints are skipped by the
/// search until then.
fn close(world: &mut World) -> Vec<Borne> {
    let waiting: Vec<(u32, u32)> =
        world.bonds.iter().filter(|b| b.active && !b.gives_way()).map(|b| (b.i, b.j)).collect();
    let half = 0.5 * world.pending;
    let mut borne: Vec<Borne> = Vec::new();
    for bond in &mut world.bonds {
        let pair = (bond.i, bond.j);
        if !bond.gives_way() || waiting.contains(&pair) {
            continue;
        }
        let relative = Relative::of(&world.bodies, bond.i, bond.j);
        world.works.edit_defect += half * relative.power_of(&bond.stress) - bond.energy;
        world.works.damping -= half * relative.power_of(&bond.damping);
        let (compression, shear, length) = (bond.compression(), bond.shear(), bond.length);
        bond.active = false;
        bond.energy = 0.0;
        (bond.stress, bond.damping) = (Wrench::default(), Wrench::default());
        match borne.last_mut() {
            Some(last) if last.pair == pair => {
                last.compression += compression;
                last.shear += shear;
                last.length += length;
            }
            _ => borne.push(Borne { pair, compression, shear, length }),
        }
    }
    borne
}

/// Opens found contact with the forces of the joints, shared between its regions as their pressures
/// are, and its accounts.
fn open(world: &mut World, scratch: &Scratch, borne: &Borne) {
    let (i, j) = borne.pair;
    let candidates = &scratch.candidates;
    let convex = candidates.convex.binary_search_by_key(&(i, j), |c| (c.i, c.j));
    let general = candidates.general.binary_search_by_key(&(i, j), |c| (c.i, c.j));
    let candidate = match (convex, general) {
        (Ok(k), _) => &candidates.convex[k],
        (_, Ok(k)) => &candidates.general[k],
        // Further apart than found contact looks.
        _ => return,
    };
    let law = world.setup.interfaces[candidate.row as usize].contact;
    let relative = Relative::of(&world.bodies, i, j);
    let context = Context {
        shapes: &scratch.shapes,
        turned: &scratch.turned,
        bodies: &world.bodies,
        laws: &scratch.laws,
        lists: &candidates.lists,
        elapsed: world.pending,
        stiffness_damping: 0.0,
        begins: world.begins(),
    };
    let regions: Vec<(Pressed, u64)> = if convex.is_ok() {
        let pressed = contact::press_convex(&context, candidate, &relative);
        pressed.map(|p| (p, 0)).into_iter().collect()
    } else {
        contact::press_general(&context, candidate, &relative, &mut Workspace::default())
    };
    let elastic: f64 = regions.iter().map(|(p, _)| p.normal.force.length()).sum();
    let mut stored = 0.0;
    let mut work = Wrench::default();
    let mut opened = Vec::new();
    for (pressed, edges) in regions {
        let force = pressed.normal.force.length();
        if force == 0.0 {
            continue;
        }
        let contact = taken_over(&law, &pressed, borne, force / elastic);
        stored += contact.shear_energy;
        work = work.plus(&pressed.normal);
        opened.push(Region { edges, contact });
    }
    if law.normal == NormalLaw::DistancePotential {
        // The normal energy of other laws is taken by path and starts with nothing.
        let half = 0.5 * world.pending;
        stored += view::pair_energy(world, scratch, borne.pair) + half * relative.power_of(&work);
    }
    world.works.edit_defect += stored;
    if let Ok(k) = convex {
        if let (Some(region), Some(state)) = (opened.pop(), world.pairs.get_mut(k)) {
            *state = PairState { contact: region.contact, ..*state };
        }
    } else if let Some(state) = general.ok().and_then(|k| world.general.get_mut(k)) {
        state.regions = opened;
    }
}

/// A contact with this share of the forces of the joints.
fn taken_over(law: &ContactLaw, pressed: &Pressed, borne: &Borne, share: f64) -> Contact {
    let mut contact = Contact {
        shear: -share * borne.shear,
        springs: pressed.length,
        offset: share * borne.compression - pressed.normal.force.length(),
        offset_left: FADE * borne.length,
        ..Contact::default()
    };
    contact.shear_energy = contact::shear_energy(law, &contact);
    contact
}

/// Normal force beyond the elastic one that a contact has taken over, N/m: it fades with slip and
/// never pulls in sum. 0 for ordinary contacts.
pub(crate) fn offset(contact: &mut Contact, elastic: f64, slip: f64) -> f64 {
    if contact.offset == 0.0 {
        return 0.0;
    }
    let left = (contact.offset_left - slip.abs()).max(0.0);
    contact.offset *= if contact.offset_left > 0.0 { left / contact.offset_left } else { 0.0 };
    contact.offset_left = left;
    contact.offset = contact.offset.max(-elastic);
    contact.offset
}
