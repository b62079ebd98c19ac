//! Conditions on faces for the implicit step: what the boundaries give to it, and what comes back.
//!
//! Springs and dashpots of a face are terms of the step, since an explicit step that follows them is as short as that of the block they stand for. Far ends
//! are moved on once the step is solved: an instant may be looked at again.

use riprap_geom::Vec3;

use crate::accounts::Account;
use crate::implicit::hold::{Hold, Point};
use crate::implicit::pair::Pair;
use crate::joint::patch::Poses;
use crate::push::boundary::Context;
use crate::state::push::Wrench;
use crate::state::scratch::{HeldFace, Scratch};
use crate::state::world::World;

/// Whether any face has a condition.
pub(super) fn are_there(world: &World) -> bool {
    !world.setup.boundaries.is_empty()
}

fn context<'a>(world: &'a World, scratch: &Scratch) -> Context<'a> {
    Context { half: scratch.kick_halves(world), ..Context::new(world) }
}

/// Gives the faces that springs or dashpots hold to the solver, behind the joints.
pub(super) fn find(world: &World, scratch: &mut Scratch, dt: f64) {
    scratch.implicit.faces.clear();
    if !are_there(world) {
        return;
    }
    let context = context(world, scratch);
    let desk = &mut scratch.implicit;
    for (f, face) in world.faces.iter().enumerate() {
        let Some((ahead, dashpots)) = context.ahead(face, dt) else { continue };
        let points = ahead.map(|at| Point { arm: at.arm, pull: at.pull, drag: at.drag });
        desk.faces.push(HeldFace { face: f as u32, ..HeldFace::default() });
        let hold = Some(Box::new(Hold { points, dashpots }));
        desk.solver.pairs.push(Pair { hold, ..Pair::default() });
    }
}

/// Given tractions on each block; empty where there are none.
pub(super) fn given(world: &World, scratch: &Scratch) -> Vec<Wrench> {
    if !are_there(world) {
        return Vec::new();
    }
    let mut all = vec![Wrench::default(); world.alive.len()];
    let context = context(world, scratch);
    for face in world.faces.iter().filter(|face| face.boundary.is_some()) {
        let Wrench { force, moment } = context.given(face);
        let to = &mut all[face.block as usize];
        to.force += force;
        to.moment += moment;
    }
    all
}

/// Adds what the faces exert in the step to the sums of their blocks, moves their far ends on and books what that does.
pub(super) fn hand_over(world: &mut World, scratch: &mut Scratch) {
    let mut works = std::mem::take(&mut world.works);
    let mut lost = 0.0;
    {
        let mut faces = std::mem::take(&mut world.faces);
        let context = Context {
            poses: Poses { bodies: &world.bodies, turned: &world.turned },
            ..context(world, scratch)
        };
        let (desk, mut net) = (&mut scratch.implicit, scratch.net.whole());
        let first = desk.pairs.len() + desk.joints.len();
        let solver = &desk.solver;
        let replies = solver.pairs[first..].iter().zip(&solver.replies[first..]);
        let twists = &solver.twists()[first..];
        for ((held, (pair, reply)), twist) in desk.faces.iter_mut().zip(replies).zip(twists) {
            let face = &mut faces[held.face as usize];
            let b = face.block as usize;
            let [fx, fy, fz, mx, my, mz] = reply.elastic;
            net.add(b, Vec3::new(fx, fy, fz), Vec3::new(mx, my, mz));
            if let Some(at) = desk.place[b] {
                desk.tied[at as usize] = true;
            }
            held.booked = context.move_on(face, &mut works);
            lost += held.booked.absorbed - held.booked.supports;
            held.taken = pair.hold.as_ref().map_or(0.0, |hold| hold.taken(twist));
        }
        world.faces = faces;
    }
    world.works = works;
    if let Some(implicit) = world.implicit.as_deref_mut() {
        implicit.lost_in_joints += lost;
    }
}

/// Books what the faces have done since the last instant, and what dashpots will take in the coming step.
pub(super) fn book(world: &World, scratch: &mut Scratch) {
    let dt = scratch.coming_dt;
    for held in &scratch.implicit.faces {
        let taken = dt * held.taken;
        scratch.departure.absorbed += taken;
        if let Some(entry) = scratch.face_entries.get_mut(held.face as usize) {
            add(&mut entry.halves[0], &held.booked);
            entry.halves[1].absorbed += taken;
        }
    }
    debug_assert!(scratch.implicit.faces.is_empty() || are_there(world));
}

fn add(to: &mut Account, other: &Account) {
    to.loads += other.loads;
    to.supports += other.supports;
    to.absorbed += other.absorbed;
}

/// What dashpots have taken in the step that is made, J.
pub(super) fn taken(scratch: &Scratch) -> f64 {
    scratch.implicit.faces.iter().map(|held| scratch.coming_dt * held.taken).sum()
}

/// Energy in the springs of all faces, J.
pub(super) fn stored(world: &World) -> f64 {
    if !are_there(world) {
        return 0.0;
    }
    let context = Context::new(world);
    world.faces.iter().map(|face| context.stored(face)).sum()
}
