//! Forces of found contacts: geometry -> law -> slots.
//!
//! The normal force is the resultant of the pressures of the region. Dashpots and friction act on
//! the region as a whole, along and across that resultant, at its centre of pressure: dashpots on
//! each boundary piece would plough (the tiny side pieces are as steep as the block is tall).

use riprap_geom::Vec2;

use super::convex::{self, Side, Turned};
use super::depths;
use super::handover;
use super::initial_overlap;
use super::pieces;
use super::scratch::{Scratch, Workspace};
use super::search::Candidate;
use super::setup::{ContactLaw, FrictionLaw, NormalLaw};
use super::shapes::Shapes;
use super::world::{Body, Contact, GeneralState, PairState, Region, World, Wrench};
use crate::laws::bounds::{not_negative, within};
use crate::laws::mohr_coulomb::shear_limit;
use crate::laws::{coulomb, potential as closed};
use crate::ledger::Works;

/// What the pair kernels read.
pub(crate) struct Context<'a> {
    /// Body geometry.
    pub shapes: &'a Shapes,
    /// Edges at the present angles.
    pub turned: &'a [Turned],
    /// Present motion.
    pub bodies: &'a [Body],
    /// Laws by row.
    pub laws: &'a [ContactLaw],
    /// Edge lists of the candidates.
    pub lists: &'a [u16],
    /// Time moved since the last evaluation, s.
    pub elapsed: f64,
    /// Stiffness-proportional damping of the phase, s.
    pub stiffness_damping: f64,
    /// Whether the model begins here: overlaps found now were there before.
    pub begins: bool,
}

impl<'a> Context<'a> {
    fn sides(&self, candidate: &Candidate) -> (Side<'a>, Side<'a>) {
        let (i, j) = (candidate.i as usize, candidate.j as usize);
        let [edges_i, nearest_j, edges_j, nearest_i] = candidate.lists(self.lists);
        let side = |b: usize, active: &'a [u16], nearest: &'a [u16]| Side {
            turned: &self.turned[self.shapes.range(b)],
            active,
            nearest,
        };
        (side(i, edges_i, nearest_i), side(j, edges_j, nearest_j))
    }
}

/// Relative placement and motion of a pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relative {
    /// Centroid of i minus centroid of j, m.
    pub shift: Vec2,
    /// Velocity of i's centroid minus that of j's, m/s.
    pub velocity: Vec2,
    /// Spin of i, rad/s.
    pub spin_i: f64,
    /// Spin of j, rad/s.
    pub spin_j: f64,
}

impl Relative {
    /// Of blocks i and j.
    #[must_use]
    pub(crate) fn of(bodies: &[Body], i: u32, j: u32) -> Self {
        let (i, j) = (&bodies[i as usize], &bodies[j as usize]);
        Self {
            shift: i.position - j.position,
            velocity: i.velocity - j.velocity,
            spin_i: i.spin,
            spin_j: j.spin,
        }
    }

    /// Velocity of i relative to j at a point `x` from i's centroid, m/s.
    pub(crate) fn at(&self, x: Vec2) -> Vec2 {
        self.velocity + self.spin_i * x.perp() - self.spin_j * (x + self.shift).perp()
    }

    /// Power of a wrench, W/m.
    pub(crate) fn power_of(&self, w: &Wrench) -> f64 {
        w.power(self.velocity, self.spin_i, self.spin_j)
    }
}

/// Geometry of a region in force units, ready for the law.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pressed {
    /// Elastic normal wrench.
    pub normal: Wrench,
    /// Centre of pressure from i's centroid, m.
    pub centre: Vec2,
    /// Contact length, m.
    pub length: f64,
    /// Largest depth, m.
    pub depth: f64,
    /// Friction already found piece by piece (source's law); replaces the shear spring.
    pub friction: Option<Wrench>,
}

/// Forces of the convex pairs in one chunk.
pub(crate) fn convex_chunk(
    context: &Context<'_>,
    candidates: &[Candidate],
    states: &mut [PairState],
    slots: &mut [Wrench],
    works: &mut Works,
) {
    for ((candidate, state), slot) in candidates.iter().zip(states).zip(slots) {
        let relative = Relative::of(context.bodies, candidate.i, candidate.j);
        let law = &context.laws[candidate.row as usize];
        *slot = if let Some(pressed) = press_convex(context, candidate, &relative) {
            apply(law, candidate.dashpots, context, &relative, &pressed, &mut state.contact, works)
        } else {
            if state.contact != Contact::default() {
                end(law, &relative, context.elapsed, &mut state.contact, works);
            }
            Wrench::default()
        };
    }
}

/// Pressure resultant of two convex blocks; `None` when they do not touch.
#[inline]
pub(crate) fn press_convex(
    context: &Context<'_>,
    candidate: &Candidate,
    relative: &Relative,
) -> Option<Pressed> {
    let (i, j) = context.sides(candidate);
    let overlap = convex::overlap(i, j, relative.shift);
    if overlap.weight == 0.0 {
        return None;
    }
    let half = 0.5 * context.laws[candidate.row as usize].normal_stiffness;
    let force = half * overlap.force;
    let moment_i = half * overlap.moment;
    Some(Pressed {
        // Same points for both: the moment about j's centroid follows from that about i's.
        normal: Wrench { force, moment_i, moment_j: -moment_i - relative.shift.perp_dot(force) },
        centre: overlap.weighted / overlap.weight,
        length: 0.5 * overlap.chord.length(),
        depth: overlap.depth,
        friction: None,
    })
}

/// Forces of the general pairs in one group.
pub(crate) fn general_chunk(
    context: &Context<'_>,
    candidates: &[Candidate],
    states: &mut [GeneralState],
    slots: &mut [Wrench],
    workspace: &mut Workspace,
    works: &mut Works,
) {
    for ((candidate, state), slot) in candidates.iter().zip(states).zip(slots) {
        *slot = general_pair(context, candidate, state, workspace, works);
    }
}

fn general_pair(
    context: &Context<'_>,
    candidate: &Candidate,
    state: &mut GeneralState,
    workspace: &mut Workspace,
    works: &mut Works,
) -> Wrench {
    let relative = Relative::of(context.bodies, candidate.i, candidate.j);
    let law = &context.laws[candidate.row as usize];
    workspace.old.clear();
    workspace.old.append(&mut state.regions);
    let mut total = Wrench::default();
    let by_path = matches!(law.normal, NormalLaw::PenetrationPotential);
    let stored = if context.begins && by_path && workspace.old.is_empty() {
        initial_overlap::energies(context, candidate, &relative)
    } else {
        Vec::new()
    };
    let count = cut(context, candidate, &relative, workspace);
    for region in 0..count {
        let (pressed, edges) = press(context, candidate, &relative, region, workspace);
        if pressed.normal.force == Vec2::ZERO {
            continue;
        }
        let mut contact = take_matching(&mut workspace.old, edges);
        if let Some((_, energy)) = stored.iter().find(|(e, _)| *e == edges) {
            contact.path_energy += energy;
            works.contact_path += energy;
        }
        let wrench =
            apply(law, candidate.dashpots, context, &relative, &pressed, &mut contact, works);
        total = total.plus(&wrench);
        state.regions.push(Region { edges, contact });
    }
    for region in &mut workspace.old {
        end(law, &relative, context.elapsed, &mut region.contact, works);
    }
    total
}

/// Finds the boundary pieces of a pair and returns the number of regions.
fn cut(
    context: &Context<'_>,
    candidate: &Candidate,
    relative: &Relative,
    workspace: &mut Workspace,
) -> u16 {
    let (i, j) = context.sides(candidate);
    pieces::find(i, j, relative.shift, &mut workspace.pieces, &mut workspace.cuts);
    let regions = pieces::regions(&mut workspace.pieces, i, j) as u16;
    if context.laws[candidate.row as usize].normal == NormalLaw::PenetrationPotential {
        pieces::straighten(&mut workspace.pieces, i, j);
    }
    regions
}

/// Pressure resultants of all regions of a pair, with the bits of their edges.
pub(crate) fn press_general(
    context: &Context<'_>,
    candidate: &Candidate,
    relative: &Relative,
    workspace: &mut Workspace,
) -> Vec<(Pressed, u64)> {
    (0..cut(context, candidate, relative, workspace))
        .map(|region| press(context, candidate, relative, region, workspace))
        .collect()
}

/// The old region with most edges in common, taken out of the list; a new contact if none has any.
fn take_matching(old: &mut Vec<Region>, edges: u64) -> Contact {
    let mut best = None;
    let mut most = 0;
    for (k, region) in old.iter().enumerate() {
        let common = (region.edges & edges).count_ones();
        if common > most {
            (best, most) = (Some(k), common);
        }
    }
    best.map_or_else(Contact::default, |k| old.remove(k).contact)
}

/// Pressure resultant of one region and the bits of its edges.
fn press(
    context: &Context<'_>,
    candidate: &Candidate,
    relative: &Relative,
    region: u16,
    workspace: &mut Workspace,
) -> (Pressed, u64) {
    let law = &context.laws[candidate.row as usize];
    let (i, j) = context.sides(candidate);
    let mut out = Pressed::default();
    let (mut weight, mut weighted, mut chord, mut edges) = (0.0, Vec2::ZERO, Vec2::ZERO, 0u64);
    let mut friction = Wrench::default();
    if law.normal == NormalLaw::PenetrationPotential {
        workspace.local.look(&workspace.pieces, region, i, j, relative.shift);
    }
    for piece in workspace.pieces.iter().filter(|p| p.region == region) {
        let bit = u32::from(piece.edge % 32) + if piece.second { 32 } else { 0 };
        edges |= 1 << bit;
        let sign = if piece.second { -1.0 } else { 1.0 };
        chord += sign * (piece.ends[1] - piece.ends[0]);
        let (own, other) = if piece.second { (j, i) } else { (i, j) };
        // From the first centroid to the centroid of the block the piece is inside of.
        let shift = if piece.second { Vec2::ZERO } else { relative.shift };
        let normal = own.turned[piece.edge as usize].normal;
        let mut add = |force: f64, x: Vec2, p: Vec2, q: Vec2| {
            let push = -sign * force * normal;
            out.normal = out.normal.plus(&Wrench::at(push, x, x + relative.shift));
            weight += force;
            weighted += force * x;
            if let Some(share) = sliding_share(law, relative, p, q) {
                let drag = share * law.friction * force * (q - p).normalize_or_zero();
                friction = friction.plus(&Wrench::at(drag, x, x + relative.shift));
            }
        };
        match law.normal {
            NormalLaw::DistancePotential => {
                let [p, q] = piece.ends;
                let d = depths::along(other, p + shift, q + shift, &mut workspace.kinks);
                if d.integral > 0.0 {
                    let xi = d.first_moment / d.integral;
                    let force = 0.5 * law.normal_stiffness * (q - p).length() * d.integral;
                    add(force, p + xi * (q - p), p, q);
                    out.depth = out.depth.max(d.peak);
                }
            }
            NormalLaw::PenetrationPotential => {
                let apart = if piece.second { -relative.shift } else { relative.shift };
                let (parts, n) = workspace.local.parts(piece, own, other, law.reflex, apart);
                for part in &parts[..n] {
                    let length = (part.q - part.p).length();
                    let (area, xi) = closed::linear_piece(length, part.at_p, part.at_q);
                    let force = law.normal_stiffness * area;
                    add(force, part.p + xi * (part.q - part.p), part.p, part.q);
                    out.depth = out.depth.max(part.at_p).max(part.at_q);
                }
            }
        }
    }
    if weight > 0.0 {
        out.centre = weighted / weight;
    }
    out.length = 0.5 * chord.length();
    out.friction = (law.friction_law != FrictionLaw::ShearSpring).then_some(friction);
    (out, edges)
}

/// Share of full friction on the first block along the piece `p q` under the rate laws: minus the
/// sign of its sliding velocity. `None` for the shear spring.
///
/// Source: mutual penetration potentials, S45 (direction from the velocity of the middle of the
/// piece; nothing is said for zero velocity, taken as no friction).
fn sliding_share(law: &ContactLaw, relative: &Relative, p: Vec2, q: Vec2) -> Option<f64> {
    let rate = || relative.at(0.5 * (p + q)).dot((q - p).normalize_or_zero());
    match law.friction_law {
        FrictionLaw::ShearSpring => None,
        FrictionLaw::RateSign => {
            let v = rate();
            Some(if v > 0.0 {
                -1.0
            } else if v < 0.0 {
                1.0
            } else {
                0.0
            })
        }
        FrictionLaw::Clipped => Some((-rate() / law.clip_speed).clamp(-1.0, 1.0)),
    }
}

/// Applies dashpots and friction to a pressed region; returns the total wrench and books the works.
fn apply(
    law: &ContactLaw,
    dashpots: [f64; 2],
    context: &Context<'_>,
    relative: &Relative,
    pressed: &Pressed,
    contact: &mut Contact,
    works: &mut Works,
) -> Wrench {
    let (x, length) = (pressed.centre, pressed.length);
    let arm_j = x + relative.shift;
    let elastic = pressed.normal.force.length();
    if elastic == 0.0 {
        // Opposite pressures that cancel: no direction to press or slide along.
        end(law, relative, context.elapsed, contact, works);
        return pressed.normal;
    }
    let normal = pressed.normal.force / elastic;
    let tangent = normal.perp();
    let velocity = relative.at(x);
    // Dashpots: along the resultant, and against relative rotation of the contact length.
    let stiffness = law.normal_stiffness * length;
    let root = length.sqrt();
    let c = dashpots[0] * root + context.stiffness_damping * stiffness;
    let slip = velocity.dot(tangent) * context.elapsed;
    let handed = handover::offset(contact, elastic, slip);
    let pressing = elastic + handed;
    let total_normal = not_negative(pressing - c * velocity.dot(normal));
    let mut damp = Wrench::at((total_normal - pressing) * normal, x, arm_j);
    // A pressure that nowhere pulls acts within the contact: half its length off the middle at most.
    let most = 0.5 * total_normal * length;
    let twist = -c * length * length / 12.0 * (relative.spin_i - relative.spin_j);
    let twist = within(twist, most);
    damp.moment_i += twist;
    damp.moment_j -= twist;

    let (shear, slipping) = match pressed.friction {
        // The dashpot presses on the sliding face too.
        Some(wrench) => (wrench.times(total_normal / elastic), true),
        None => {
            contact.springs = contact.springs.max(length);
            let spring = law.shear_stiffness * contact.springs;
            let limit = shear_limit(law.cohesion * length, law.friction, -total_normal);
            let rate = velocity.dot(tangent);
            let before = contact.shear;
            let slid = coulomb::shear_spring(before, spring, slip, limit);
            contact.shear = slid.force;
            let mut force = slid.force;
            if slid.slipping {
                renew(law, contact, before, slip, length);
            } else {
                let stiffness = law.shear_stiffness * length;
                let c = dashpots[1] * root + context.stiffness_damping * stiffness;
                force = within(force - c * rate, limit);
            }
            (Wrench::at(force * tangent, x, arm_j), slid.slipping)
        }
    };

    book(law, relative, context.elapsed, contact, &pressed.normal, &shear, &damp, works);
    let energy = shear_energy(law, contact);
    works.friction += contact.shear_energy - energy;
    contact.shear_energy = energy;
    contact.length = length;
    contact.depth = pressed.depth;
    contact.centre = x;
    contact.slipping = slipping;
    let total = pressed.normal.plus(&shear).plus(&damp);
    if handed == 0.0 && contact.handed == Wrench::default() {
        return total;
    }
    let handed = Wrench::at(handed * normal, x, arm_j);
    book_handed(relative, context.elapsed, contact, handed, works);
    total.plus(&handed)
}

/// Lets the spring of a contact that slides stand for its present length, as far as sliding pays for it; `before` is its force before the
/// slip of this step (m).
///
/// The springs that slide are those that touch now. They are softer than those of a longer contact and store more at the same
/// force, which comes out of what friction takes in this step.
fn renew(law: &ContactLaw, contact: &mut Contact, before: f64, slip: f64, length: f64) {
    let stored = shear_energy(law, contact);
    let paid = contact.shear_energy - stored - 0.5 * (before + contact.shear) * slip;
    if stored > 0.0 && paid > 0.0 && contact.springs > length {
        let softest = contact.springs * stored / (stored + paid);
        contact.springs = softest.max(length);
    }
}

/// Elastic energy of a shear spring, J/m.
pub(crate) fn shear_energy(law: &ContactLaw, contact: &Contact) -> f64 {
    if contact.shear == 0.0 {
        0.0
    } else {
        0.5 * contact.shear * contact.shear / (law.shear_stiffness * contact.springs)
    }
}

/// Replaces laws of found contacts by rows of the interface table. What shear springs store at the force that they remember, and contacts
/// without potential at their depth, changes with the stiffness: that is the energy of the edit, no work of friction and no defect of the law.
pub fn change_laws(world: &mut World, scratch: &Scratch, laws: &[(u16, ContactLaw)]) {
    let before: Vec<ContactLaw> = world.setup.interfaces.iter().map(|i| i.contact).collect();
    for (row, law) in laws {
        world.setup.interfaces[usize::from(*row)].contact = *law;
    }
    let World { pairs, general, setup, works, .. } = world;
    let mut renew = |row: u16, contact: &mut Contact| {
        let [old, new] = [&before[usize::from(row)], &setup.interfaces[usize::from(row)].contact];
        contact.shear_energy = shear_energy(new, contact);
        if [old, new].map(|law| law.normal) == [NormalLaw::PenetrationPotential; 2] {
            let grown = new.normal_stiffness / old.normal_stiffness - 1.0;
            works.contact_path += grown * contact.path_energy;
            contact.path_energy += grown * contact.path_energy;
        }
    };
    let changed = |row: u16| laws.iter().any(|(of, _)| *of == row);
    let candidates = &scratch.candidates;
    for (pair, c) in pairs.iter_mut().zip(&candidates.convex) {
        if changed(c.row) {
            renew(c.row, &mut pair.contact);
        }
    }
    for (pair, c) in general.iter_mut().zip(&candidates.general) {
        for region in pair.regions.iter_mut().filter(|_| changed(c.row)) {
            renew(c.row, &mut region.contact);
        }
    }
}

/// Books the trapezoidal works of the three parts over the elapsed time and remembers the parts.
#[expect(clippy::too_many_arguments, reason = "the three parts of one contact and what moves them")]
fn book(
    law: &ContactLaw,
    relative: &Relative,
    elapsed: f64,
    contact: &mut Contact,
    normal: &Wrench,
    shear: &Wrench,
    damp: &Wrench,
    works: &mut Works,
) {
    let half = 0.5 * elapsed;
    works.friction -= half * relative.power_of(&contact.tangential.plus(shear));
    works.damping -= half * relative.power_of(&contact.damping.plus(damp));
    if law.normal == NormalLaw::PenetrationPotential {
        let stored = -half * relative.power_of(&contact.normal.plus(normal));
        contact.path_energy += stored;
        works.contact_path += stored;
    }
    contact.normal = *normal;
    contact.tangential = *shear;
    contact.damping = *damp;
}

/// Books the work of the offset taken over from a joint: it is no energy of the contact.
fn book_handed(
    relative: &Relative,
    elapsed: f64,
    contact: &mut Contact,
    handed: Wrench,
    works: &mut Works,
) {
    works.edit_defect += 0.5 * elapsed * relative.power_of(&contact.handed.plus(&handed));
    contact.handed = handed;
}

/// Ends a contact: its shear energy is dissipated, what a law without potential still holds is a
/// defect of the law.
fn end(
    law: &ContactLaw,
    relative: &Relative,
    elapsed: f64,
    contact: &mut Contact,
    works: &mut Works,
) {
    let zero = Wrench::default();
    book(law, relative, elapsed, contact, &zero, &zero, &zero, works);
    book_handed(relative, elapsed, contact, zero, works);
    works.friction += contact.shear_energy;
    works.law_defect -= contact.path_energy;
    works.contact_path -= contact.path_energy;
    *contact = Contact::default();
}
