//! The contacts of a step of implicit phases: what the world gives to [`crate::implicit`], and what comes back.
//!
//! ```text
//!   evaluate:  pairs within reach  ->  velocities with all other forces  ->  Newton's method  ->  what each pair exerts
//!   advance:   what the pairs have become is remembered
//! ```
//!
//! What pairs exert is handed on as that of explicit contacts is, so that the kick, the ledger and all fields take it from there. Evaluating an
//! instant again changes nothing: the memory belongs to the step that is made.

mod bolts;
pub(crate) mod conditions;
pub(crate) mod joints;
mod meet;
pub(crate) mod obstacle;
pub(crate) mod settling;
#[cfg(test)]
mod tests;

use riprap_geom::Vec3;

use crate::contact;
use crate::implicit::memory::{Books, Implicit, Kept};
use crate::implicit::patch::Stepping;
use crate::implicit::solve::{Body, Solver, Unsolved};
use crate::joint::patch::turned_inertia;
use crate::kernel::offset::Offset;
use crate::profile::Begun;
use crate::rigid::kick::Acting;
use crate::state::contact_scratch::Acting as Felt;
use crate::state::found::FoundPair;
use crate::state::scratch::{ImplicitDesk, NotSolved, Scratch};
use crate::state::world::World;

/// What the last round of Newton's method may change of the velocities of a step, over the motion that gravity makes in it.
const TOLERANCE: f64 = 1e-3;
/// Share of the velocities of the blocks that counts beside that motion: the faster they are, the less a part of it matters.
const MOVING: f64 = 0.1;
/// The same in steps that seek an equilibrium.
const AT_REST: f64 = 1e-7;
/// Mass damping over the inverse of the step from which on a step has forgotten the velocities before it.
const FORGETTING: f64 = 1.9;
/// Speed that is nothing, m/s: the accuracy without gravity.
const STILL: f64 = 1e-4;

/// Turns to implicit contacts, or back to explicit ones.
///
/// Joints that nothing but friction holds become contacts, since those are all that an implicit phase knows.
pub fn choose(world: &mut World, scratch: &mut Scratch, implicit: bool) {
    if implicit == world.implicit.is_some() {
        if implicit {
            // Blocks may move now that were held; joints that have failed in the phase before stay what they are.
            contact::release_loose(world, scratch, contact::is_dry);
        }
        return;
    }
    if implicit {
        contact::release_loose(world, scratch, contact::is_loose);
    }
    let before = std::mem::replace(&mut world.implicit, implicit.then(Box::default));
    adopt(world, |_| true);
    if let Some(before) = before {
        keep_hidden(world, &before);
    }
    world.fresh = true;
}

/// Lets explicit contacts hide the depth of those that have hidden a part of it: they press again with what comes on top. What the rest pressed with
/// is lost, as little as it is beside what the whole depth would give.
fn keep_hidden(world: &mut World, before: &Implicit) {
    for pair in &mut world.found.pairs {
        if before.of(pair.key(), [0; 2]).is_some_and(|kept| kept.hidden > 0.0) {
            pair.offset = Some(Box::new(Offset::begin([1.0, 1.0])));
        }
    }
}

/// Takes over what joints have given to found contact since the last step.
pub(crate) fn adopt_released(world: &mut World) {
    if world.implicit.is_some() && world.found.pairs.iter().any(|pair| pair.offset.is_some()) {
        adopt(world, |pair| pair.offset.is_some());
    }
}

/// Makes the contacts of these pairs implicit ones, or those of all pairs explicit ones again.
fn adopt(world: &mut World, which: impl Fn(&FoundPair) -> bool) {
    let World { implicit, works, found, .. } = world;
    for pair in found.pairs.iter_mut().filter(|pair| which(pair)) {
        if let Some(implicit) = implicit {
            let of = pair.key();
            // What a joint has pressed with it has not yet as a contact.
            let joint = pair.offset.as_ref().and_then(|offset| offset.joint);
            let hides = |offset: &Offset| offset.joint.is_some() || offset.hidden > 0.0;
            let hides = pair.offset.as_deref().is_some_and(hides);
            let pressed = pair.patches.iter().filter(|patch| patch.memory.area > 0.0);
            implicit.kept.extend(pressed.map(|patch| {
                let force = joint.map_or_else(
                    || patch.force.dot(patch.memory.normal),
                    |carried| carried.normal.max(0.0),
                );
                let due = hides.then_some(force.max(0.0));
                Kept { due, ..Kept::of_explicit(of, patch.key, &patch.memory, force) }
            }));
            if hides && pair.patches.is_empty() {
                implicit.kept.push(Kept::without_force(of));
            }
        }
        // Looked at in the first step, whatever the other kind knew.
        pair.gap = 0.0;
        // From here on the overlap presses but for what is hidden of it, so that nothing of the load of a joint goes on beside it.
        works.contact_path += contact::left(pair);
        if let Some(offset) = pair.offset.take() {
            works.contact_path -= offset.stored;
            works.edit_defect -= offset.stored;
        }
    }
    if let Some(implicit) = implicit {
        implicit.kept.sort_unstable_by_key(Kept::place);
    }
}

/// Finds what all pairs exert in the coming step.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch, meet: bool) {
    scratch.implicit.failed = None;
    if !meet {
        scratch.implicit.begin(world.alive.len(), world.found.pairs.len());
        if world.patches.is_empty() && world.bolts.is_empty() && !conditions::are_there(world) {
            return;
        }
    }
    let dt = match scratch.coming_dt {
        // An end of a motion: its last kick is that of a step that is not made.
        0.0 => world.last_dt,
        dt => dt,
    };
    let step = Stepping { span: 0.5 * (world.last_dt + scratch.coming_dt), dt };
    let begun = Begun::now(&scratch.exec);
    if meet {
        meet::find(world, scratch, dt);
    }
    joints::find(world, scratch);
    conditions::find(world, scratch, dt);
    bolts::find(world, scratch);
    scratch.profile.add("pieces", begun.spent(&scratch.exec));
    let begun = Begun::now(&scratch.exec);
    lay_out(world, scratch, &step);
    let solver = &mut scratch.implicit.solver;
    let fall = world.gravity.length() * dt + STILL;
    let exact = if scratch.damping.mass * step.span >= FORGETTING {
        // The longer the step the more gravity would do in it: what is sought is an equilibrium.
        AT_REST * fall
    } else {
        TOLERANCE * (fall + MOVING * solver.mean_speed())
    };
    scratch.implicit.failed = match solver.solve(&step, fall, exact) {
        Ok(effort) => {
            scratch.implicit.unsettled = !effort.settled;
            None
        }
        Err(Unsolved::NotFinite(body)) => {
            let block = scratch.implicit.blocks[body];
            Some(NotSolved { blocks: [block; 2], rounds: 0 })
        }
        Err(Unsolved::Rounds(pair, rounds)) => {
            let of = |k: usize| ends(world, &scratch.implicit, k);
            Some(NotSolved { blocks: pair.map_or([0; 2], of), rounds })
        }
    };
    scratch.profile.add("implicit step", begun.spent(&scratch.exec));
    if scratch.implicit.failed.is_none() {
        if meet {
            meet::hand_over(world, scratch);
        }
        joints::hand_over(world, scratch);
        conditions::hand_over(world, scratch);
        bolts::hand_over(scratch);
        if step.span > 0.0 {
            make_exact(scratch, step.span);
        }
    }
}

/// The blocks of pair `k` of the solver.
fn ends(world: &World, desk: &ImplicitDesk, k: usize) -> [u32; 2] {
    match desk.pairs.get(k) {
        Some(pair) => world.found.pairs[*pair as usize].ends,
        None => match desk.joints.get(k - desk.pairs.len()) {
            Some(patch) => world.patches.ends[*patch as usize],
            None => {
                let held = &desk.faces[k - desk.pairs.len() - desk.joints.len()];
                [world.faces[held.face as usize].block; 2]
            }
        },
    }
}

/// Gives each block the wrench that makes its velocities those of the solution: that of its pairs, and what Newton's method has left over. In
/// stiff directions a tiny rest of the velocities is a large force, and a kick from the forces alone would be off by that.
fn make_exact(scratch: &mut Scratch, span: f64) {
    let Scratch { implicit, desk, net, .. } = scratch;
    let Solver { bodies, motion, .. } = &implicit.solver;
    let mut net = net.whole();
    for (k, b) in implicit.blocks.iter().enumerate() {
        let (body, b) = (&bodies[k], *b as usize);
        let [x, y, z, p, q, r] = motion[k];
        let [v, w] = body.free;
        let force = body.mass / span * (Vec3::new(x, y, z) - v);
        let moment = body.inertia * (Vec3::new(p, q, r) - w) / span;
        let free = body.held.map(|held| f64::from(u8::from(!held)));
        let [along, about] = [0, 3].map(|k| Vec3::new(free[k], free[k + 1], free[k + 2]));
        let tied = implicit.tied[k];
        if tied {
            let of_contacts = desk.on_block(b).unwrap_or_default();
            let (joined, turning) = net.get(b);
            let known = [of_contacts.elastic, of_contacts.spring];
            let [pushed, turned] = known.into_iter().fold([joined, turning], |sum, wrench| {
                [sum[0] + wrench.force, sum[1] + wrench.moment]
            });
            net.add(b, along * (force - pushed), about * (moment - turned));
            continue;
        }
        let Some(acting) = desk.acting.get_mut(desk.place[b] as usize) else { continue };
        let Felt { elastic, spring, .. } = acting;
        elastic.force += along * (force - elastic.force - spring.force);
        elastic.moment += about * (moment - elastic.moment - spring.moment);
    }
}

/// The blocks of the pairs within reach: those that answer, and the motion of those that do not.
fn lay_out(world: &World, scratch: &mut Scratch, step: &Stepping) {
    let kick = scratch.kick(world);
    let tractions = conditions::given(world, scratch);
    let mut desk = std::mem::take(&mut scratch.implicit);
    let all = (0..desk.solver.pairs.len()).map(|k| ends(world, &desk, k));
    let all = all.flatten().chain(bolts::blocks(&desk));
    let mut blocks: Vec<u32> = all.filter(|b| !world.is_terrain(*b as usize)).collect();
    blocks.sort_unstable();
    blocks.dedup();
    for &b in &blocks {
        let b = b as usize;
        let solid = world.solid_of(b);
        let mut other = Acting { force: solid.mass * kick.gravity, ..Acting::default() };
        for list in [&scratch.pushes.loads.blocks, &scratch.pushes.own.blocks, &tractions] {
            let push = list.get(b).copied().unwrap_or_default();
            other.force += push.force;
            other.moment += push.moment;
        }
        let moving = world.moving(b);
        let change = kick.change(b, &moving, &other);
        let turning = world.turning(b);
        let free = [moving.velocity + change.velocity, turning.spin + change.spin];
        desk.given[b] = free;
        let freedoms = world.freedoms(b);
        if freedoms == [Vec3::ZERO; 2] {
            continue;
        }
        desk.place[b] = Some(desk.blocks.len() as u32);
        desk.blocks.push(b as u32);
        let attitude = world.turned[b].as_ref().map(|turned| turned.attitude);
        let inertia = attitude.map_or(solid.inertia, |q| turned_inertia(&solid.inertia, q));
        let [along, about] = freedoms.map(|free| free.to_array());
        let held = std::array::from_fn(|k| [along, about][k / 3][k % 3] == 0.0);
        let [mass, turn] = kick.inertia_factors(b, moving.velocity);
        desk.solver.bodies.push(Body {
            mass: mass * solid.mass,
            inertia: inertia * turn,
            free,
            held,
        });
        let [v, w] = [moving.velocity, moving.spin];
        let motion = [v.x, v.y, v.z, w.x, w.y, w.z];
        let [v, w] = free;
        let given = [v.x, v.y, v.z, w.x, w.y, w.z];
        desk.solver
            .motion
            .push(std::array::from_fn(|k| if held[k] { given[k] } else { motion[k] }));
    }
    desk.tied.resize(desk.blocks.len(), false);
    for k in 0..desk.solver.pairs.len() {
        let ends = ends(world, &desk, k);
        let pair = &mut desk.solver.pairs[k];
        pair.ends = ends.map(|b| desk.place[b as usize]);
        pair.given = ends.map(|b| desk.given[b as usize]);
        if pair.hold.is_some() {
            // From outside: what does not move.
            (pair.ends[0], pair.given[0]) = (None, [Vec3::ZERO; 2]);
        }
    }
    bolts::attach(&mut desk, step);
    scratch.implicit = desk;
}

/// Books the energy of the contacts of an instant, once all works before it are: what the integration has taken.
pub(crate) fn book(world: &mut World, scratch: &mut Scratch) {
    if world.implicit.is_none() {
        return;
    }
    conditions::book(world, scratch);
    let joints = joints::stored(world, scratch) + world.bolt_energy() + conditions::stored(world);
    let Some(implicit) = world.implicit.as_deref_mut() else { return };
    let lost_in_joints = std::mem::take(&mut implicit.lost_in_joints);
    let [normal, shear] = scratch.implicit.stored;
    let path = &mut world.works.contact_path;
    match implicit.books {
        None => implicit.books = Some(Books { offset: *path - normal, normal, shear, joints }),
        Some(mut books) => {
            if world.pending > 0.0 {
                // What the forces have taken up along both directions, less what is stored and what was rubbed away.
                let taken = *path - books.offset - books.normal;
                let lost = taken - (normal - books.normal) - (shear - books.shear);
                let in_joints = joints - books.joints + lost_in_joints;
                world.works.integrator += lost - implicit.rubbed - in_joints;
                implicit.rubbed = 0.0;
            }
            *path = books.offset + normal;
            books.normal = normal;
            books.shear = shear;
            books.joints = joints;
            implicit.books = Some(books);
        }
    }
}

/// Remembers what the pairs have become in the step that is made.
pub(crate) fn remember(world: &mut World, scratch: &mut Scratch) {
    if world.implicit.is_none() {
        return;
    }
    let torn = joints::remember(world, scratch);
    let snapped = bolts::remember(world, scratch);
    world.works.bolts += snapped;
    let Some(implicit) = world.implicit.as_deref_mut() else { return };
    implicit.lost_in_joints += torn + snapped + conditions::taken(scratch);
    implicit.kept.clear();
    let mut heat = 0.0;
    let solver = &scratch.implicit.solver;
    for ((k, pair), reply) in scratch.implicit.pairs.iter().zip(&solver.pairs).zip(&solver.replies)
    {
        let key = world.found.pairs[*k as usize].key();
        implicit.kept.extend(Kept::of(key, pair, reply.shear, reply.torsion));
        heat += reply.heat;
    }
    // Pairs with terrain come last, whatever their numbers.
    implicit.kept.sort_unstable_by_key(Kept::place);
    implicit.rubbed = heat;
    world.works.friction += heat;
    world.works.fracture += torn;
    world.found.unsettled[0] += u64::from(scratch.implicit.unsettled);
    world.found.unsettled[1] += 1;
}
