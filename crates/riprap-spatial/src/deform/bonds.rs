//! Forces of bonds: jump across each point, law, force to its slot.
//!
//! Tension positive, the normal points from A to B, the jump is `u_B - u_A`. A point pulls A with `A t` and B with
//! the opposite, so momentum is kept; both anchors stand in the same spot, so angular momentum is too.

use riprap_core::cut;
use riprap_geom::Vec3;

use crate::deform::relax::Breaks;
use crate::exec::Divide;
use crate::lanes::{LANES, Lanes, Vectors, Width, same, scaled};
use crate::laws::bond;
use crate::ledger::Works;
use crate::setup::InterfaceLaw;
use crate::setup::deform::{BondFailure, BondLaw, Strength};
use crate::state::anchor::Freedoms;
use crate::state::deform::{Facet, Memory, Point, State};
use crate::state::links::{Link, PackedFacet};
use crate::state::push::Account;
use crate::state::scratch::Scratch;
use crate::state::sums;
use crate::state::workspace::{BondWorks, FACETS, Workspace};
use crate::state::world::World;

/// Facets of a piece of work.
struct Piece<'a> {
    facets: &'a mut [Facet],
    sheets: &'a mut [PackedFacet],
    first: usize,
    has_history: &'a mut [bool],
    memory: &'a mut [Memory],
    slots: &'a mut [[f64; 3]],
    works: &'a mut [BondWorks],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let at = middle * FACETS;
        let points = (self.facets[at].first - self.facets[0].first) as usize;
        cut!(
            self,
            facets: at,
            sheets: at,
            first: points,
            has_history: at,
            memory: points,
            slots: points,
            works: middle,
        )
    }
}

/// Finds the forces of all points, and what they push rigid blocks with.
pub(crate) fn update(world: &mut World, scratch: &mut Scratch) {
    let (Some(deform), Some(work)) = (world.deform.as_deref_mut(), scratch.deform.as_deref_mut())
    else {
        return;
    };
    super::turn::look(deform, work, &scratch.exec, scratch.width);
    let relax = deform.relax.as_ref();
    let context = Context {
        freedoms: Freedoms::new(&world.bodies, &world.turned, Some(&deform.nodes)),
        turning: super::turn::Turning::new(&world.turned, &deform.slot, &work.turns),
        points: &deform.points,
        links: &work.links.links,
        interfaces: &world.setup.interfaces,
        // Nothing has moved since the last evaluation otherwise: what laws do then must not be done twice.
        live: (world.pending > 0.0 || world.fresh).then_some(world.pending),
        relaxing: relax.is_some(),
        waits: relax.is_some_and(|r| r.relaxation.breaks != Breaks::Always),
        breaking: deform.breaking,
        time: world.time,
        step: world.step,
        width: scratch.width,
    };
    let count = deform.facets.len().div_ceil(FACETS);
    let piece = Piece {
        facets: &mut deform.facets,
        sheets: &mut work.links.sheets,
        first: 0,
        has_history: &mut deform.has_history,
        memory: &mut deform.memory,
        slots: &mut work.slots,
        works: &mut work.bond_works,
    };
    scratch.exec.divided(piece, count, |_, piece| context.piece(piece));
    work.broke = false;
    sums::tree(&mut work.bond_works, |sum, other| {
        sum.works.add(&other.works);
        sum.broke |= other.broke;
    });
    if let Some(all) = work.bond_works.first() {
        world.works.add(&all.works);
        work.broke = all.broke;
    }
    push_rigid(world, work, &mut scratch.pushes.own);
}

/// How bonds behave in the present evaluation.
struct Context<'a> {
    freedoms: Freedoms<'a>,
    /// How facets turn with their blocks; `None` where none does.
    turning: Option<super::turn::Turning<'a>>,
    points: &'a [Point],
    links: &'a [Link],
    interfaces: &'a [InterfaceLaw],
    /// Time moved since the last evaluation, s, if the laws must be applied.
    live: Option<f64>,
    /// Whether softening waits for convergence.
    relaxing: bool,
    /// Whether breaking and slip do.
    waits: bool,
    breaking: bool,
    time: f64,
    step: u64,
    width: Width,
}

impl Context<'_> {
    fn piece(&self, mut piece: Piece) {
        if let Some(turning) = &self.turning {
            turning.turn(piece.facets, self.width);
            for (facet, sheet) in piece.facets.iter().zip(&mut *piece.sheets) {
                sheet.normal = facet.now[0].to_array();
            }
        }
        self.width.run(
            #[inline(always)]
            || self.whole(&mut piece),
        );
        let mut works = BondWorks::default();
        for (k, facet) in piece.facets.iter().enumerate() {
            let Some(law) = self.interfaces[usize::from(facet.row)].bond.as_ref() else {
                continue;
            };
            if !piece.has_history[k] && law.cohesive.is_none() {
                continue;
            }
            let here = facet.first as usize - piece.first
                ..(facet.first + facet.count) as usize - piece.first;
            let points = &self.points[facet.points()];
            let (memory, slots) = (&mut piece.memory[here.clone()], &mut piece.slots[here]);
            if facet.parted {
                slots.fill([0.0; 3]);
                continue;
            }
            self.with_history(facet, law, points, memory, slots, &mut works);
        }
        piece.works[0] = works;
    }

    /// Forces of the points of facets without memory; facets with a point that breaks now have a history from now on.
    #[inline(always)]
    fn whole(&self, piece: &mut Piece) {
        for (k, sheet) in piece.sheets.iter().enumerate() {
            let law = self.interfaces[usize::from(sheet.row)].bond.as_ref();
            if piece.has_history[k] || law.is_some_and(|l| l.cohesive.is_some()) {
                continue;
            }
            // Points break one by one while they move; a relaxing phase breaks only what has converged.
            let strength = law
                .filter(|l| l.failure == BondFailure::Spring)
                .and_then(|l| l.strength.as_ref())
                .filter(|_| self.live.is_some() && self.breaks_at_once(sheet.intact_until_step));
            let from = sheet.first as usize - piece.first;
            let slots = &mut piece.slots[from..from + sheet.count as usize];
            let facet = &piece.facets[k];
            let near = self.elastic(sheet, strength, slots);
            if let Some(strength) = strength
                && near
            {
                piece.has_history[k] = fails(strength, facet, &self.points[sheet.points()], slots);
            }
        }
    }

    /// Whether points of a facet that is whole until a step may break in the step in which they fail.
    fn breaks_at_once(&self, intact_until_step: u64) -> bool {
        self.breaking && !self.waits && self.step >= intact_until_step
    }

    /// Forces of the points of a facet that have no memory; whether one may be beyond the strength.
    #[inline(always)]
    fn elastic(
        &self,
        sheet: &PackedFacet,
        strength: Option<&Strength>,
        slots: &mut [[f64; 3]],
    ) -> bool {
        let (n, springs) = (same(&sheet.normal), sheet.stiffness.map(Lanes::all));
        let mut near = false;
        for (eight, slots) in slots.chunks_mut(LANES).enumerate() {
            let first = sheet.first as usize + eight * LANES;
            let points = first..first + slots.len().min(LANES);
            let (jump, area) = if sheet.plain {
                self.jumps(&self.links[points])
            } else {
                self.far_jumps(&self.points[points])
            };
            let t = bond::connect_eight(springs, &n, &jump);
            if let Some(strength) = strength {
                near |= bond::near_eight(strength, &n, &t);
            }
            let force = scaled(area, &t);
            for (k, slot) in slots.iter_mut().enumerate().take(LANES) {
                *slot = [force[0].0[k], force[1].0[k], force[2].0[k]];
            }
        }
        near
    }

    /// Jumps (m) across up to eight points between nodes, and their areas; zero in the other lanes.
    #[inline(always)]
    fn jumps(&self, links: &[Link]) -> (Vectors, Lanes) {
        let (mut jump, mut area) = (Vectors::default(), Lanes::default());
        let moved = self.freedoms.displacement;
        for (k, link) in links.iter().enumerate().take(LANES) {
            let (a, b) = (moved[link.nodes[0] as usize], moved[link.nodes[1] as usize]);
            for axis in 0..3 {
                jump[axis].0[k] = b[axis] - a[axis];
            }
            area.0[k] = link.area;
        }
        (jump, area)
    }

    /// As [`Context::jumps`], for any anchors.
    #[inline(never)]
    fn far_jumps(&self, points: &[Point]) -> (Vectors, Lanes) {
        let (mut jump, mut area) = (Vectors::default(), Lanes::default());
        for (k, point) in points.iter().enumerate().take(LANES) {
            let across = self.freedoms.jump(&point.anchors);
            for axis in 0..3 {
                jump[axis].0[k] = across[axis];
            }
            area.0[k] = point.area;
        }
        (jump, area)
    }

    /// Points with a memory.
    fn with_history(
        &self,
        facet: &Facet,
        law: &BondLaw,
        points: &[Point],
        memory: &mut [Memory],
        slots: &mut [[f64; 3]],
        works: &mut BondWorks,
    ) {
        let at_once =
            self.breaks_at_once(facet.intact_until_step) && law.failure == BondFailure::Spring;
        // Softening and slip in an iteration that overshoots would be for good.
        let waits = self.relaxing && (self.waits || law.cohesive.is_some());
        let respond = |memory: &Memory, at: &[f64; 3], breaks: bool| {
            respond(law, facet.stiffness, memory, at, breaks)
        };
        for ((point, memory), slot) in points.iter().zip(memory).zip(slots) {
            let jump = self.freedoms.jump(&point.anchors);
            let at = facet.now.map(|e| e.dot(jump));
            let (t, after) = respond(memory, &at, at_once && self.live.is_some());
            let global = t[0] * facet.now[0] + t[1] * facet.now[1] + t[2] * facet.now[2];
            *slot = (point.area * global).to_array();
            let Some(pending) = self.live else { continue };
            let velocity = self.freedoms.jump_velocity(&point.anchors);
            let before = facet.now.map(|e| e.dot(jump - pending * velocity));
            let (t_before, old) = respond(memory, &before, false);
            let mut lost = bond::loss(
                facet.stiffness,
                &memory.start,
                (&before, &t_before, &old),
                (&at, &t, &after),
            );
            if waits && old.damage != after.damage {
                // A load step can take a point over its peak in one iteration. What the ledger has of the loads is a trapezoid.
                let exact = softened(law, facet, memory, [&before, &at]);
                works.works.edit_defect -= point.area * (lost - exact);
                lost = exact;
            }
            // Opening or closing within a step is an error of the time integration, no friction.
            let defect = across(facet, memory, [&before, &at], [t_before[0], t[0]]);
            works.works.law_defect -= point.area * defect;
            memory.unbooked += lost - defect;
            if waits {
                continue;
            }
            if commit(memory, after, point.area, &mut works.works) {
                record_failure(memory, law, &t_before, self.time);
                works.broke = true;
            }
        }
    }
}

/// Pieces of the way of a softening point in one iteration.
const PIECES: u32 = 32;

/// Energy that leaves the springs of a softening point on a straight way, J/m²: with the tractions along its curve, while what it remembers
/// waits for the equilibrium.
fn softened(law: &BondLaw, facet: &Facet, memory: &Memory, [from, to]: [&[f64; 3]; 2]) -> f64 {
    let at = |k: u32| {
        let share = f64::from(k) / f64::from(PIECES);
        [0, 1, 2].map(|axis| from[axis] + share * (to[axis] - from[axis]))
    };
    let of = |k: u32| {
        let at = at(k);
        let (t, state) = respond(law, facet.stiffness, memory, &at, false);
        (at, t, state)
    };
    let mut lost = 0.0;
    let mut before = of(0);
    for k in 1..=PIECES {
        let after = of(k);
        let ends = [&before, &after].map(|(at, t, state)| (at, t, state));
        lost += bond::loss(facet.stiffness, &memory.start, ends[0], ends[1]);
        before = after;
    }
    lost
}

/// Work of the normal traction of a broken point in a step less what it stores, J/m²; nil for others, which are linear.
fn across(facet: &Facet, memory: &Memory, at: [&[f64; 3]; 2], t: [f64; 2]) -> f64 {
    if memory.law.damage < 1.0 {
        return 0.0;
    }
    let start = [memory.start[0], 0.0, 0.0];
    let still = bond::State { slip: [0.0; 2], ..memory.law };
    let stored = |at: &[f64; 3]| bond::stored(facet.stiffness, &start, &[at[0], 0.0, 0.0], &still);
    let work = 0.5 * (t[0] + t[1]) * (at[1][0] - at[0][0]);
    work - (stored(at[1]) - stored(at[0]))
}

/// Takes a new state of a point with this area (m²) over and books what has been lost on the way to it; whether it has broken just now.
pub fn commit(memory: &mut Memory, after: bond::State, area: f64, works: &mut Works) -> bool {
    let breaks = after.damage >= 1.0 && memory.law.damage < 1.0;
    let lost = area * std::mem::take(&mut memory.unbooked);
    if after.damage > memory.law.damage {
        works.dissipate(0.0, lost);
    } else {
        works.dissipate(lost, 0.0);
    }
    memory.law = after;
    breaks
}

/// Notes that a point has broken; `t` is the traction (Pa) that tells how.
pub fn record_failure(memory: &mut Memory, law: &BondLaw, t: &bond::Traction, time: f64) {
    let mode = law.strength.map(|s| s.utilisation(t).1);
    memory.state = match mode {
        Some(bond::FailureMode::Tension) | None => State::Opened,
        Some(bond::FailureMode::Shear) => State::Sheared,
    };
    memory.broken_at = time;
    memory.unreported = true;
}

/// Traction (n, b, c) of a point at a jump (m) and its state there; `breaks`: whether a brittle one may break.
#[must_use]
pub fn respond(
    law: &BondLaw,
    springs: bond::Springs,
    memory: &Memory,
    at: &[f64; 3],
    breaks: bool,
) -> (bond::Traction, bond::State) {
    match (&law.strength, &law.cohesive) {
        // A notch in an elastic model.
        (None, _) if memory.law.damage >= 1.0 => {
            bond::contact(springs, &Strength::default(), &memory.start, at, &memory.law)
        }
        (None, _) => (bond::connect(springs, &memory.start, at), memory.law),
        (Some(_), Some(cohesive)) => {
            bond::cohesive(springs, cohesive, &memory.start, at, &memory.law)
        }
        (Some(strength), None) if breaks => {
            bond::brittle(springs, strength, &memory.start, at, &memory.law)
        }
        (Some(strength), None) if memory.law.damage >= 1.0 => {
            bond::contact(springs, strength, &memory.start, at, &memory.law)
        }
        (Some(_), None) => (bond::connect(springs, &memory.start, at), memory.law),
    }
}

/// Whether a linear facet has a point beyond its strength.
fn fails(strength: &Strength, facet: &Facet, points: &[Point], slots: &[[f64; 3]]) -> bool {
    let n = facet.now[0];
    points.iter().zip(slots).any(|(point, slot)| {
        let t = Vec3::from_array(*slot) / point.area;
        let sigma = t.dot(n);
        let shear = (t.length_squared() - sigma * sigma).max(0.0).sqrt();
        strength.failure(&[sigma, shear, 0.0]).is_some()
    })
}

/// Pushes rigid blocks with the forces of points, in the order of the facets.
fn push_rigid(world: &World, work: &Workspace, pushes: &mut Account) {
    let Some(deform) = world.deform.as_deref().filter(|_| !work.links.on_rigid.is_empty()) else {
        return;
    };
    pushes.need_blocks(world.alive.len());
    let freedoms = world.all_freedoms();
    for &k in &work.links.on_rigid {
        let facet = &deform.facets[k as usize];
        for (side, sign) in [(0, 1.0), (1, -1.0)] {
            if !facet.rigid[side] {
                continue;
            }
            for p in facet.points() {
                let force = sign * Vec3::from_array(work.slots[p]);
                freedoms.push(pushes, &deform.points[p].anchors[side], force);
            }
        }
    }
}
