//! Breaking of bonds: at once while they move, event by event while they relax.
//!
//! In a static phase nothing is tested before the forces have converged. Then the facet (or spring) that is used most breaks, together
//! with those used nearly as much (0.95), and everything is relaxed again; and so on until none is beyond its
//! strength. In a dynamic phase springs break in the step in which they fail (`bonds`), facets are looked at every few
//! steps. What a point held and no longer holds is booked as fracture.

use std::collections::BTreeMap;

use riprap_geom::{Mat3, Vec3};

use crate::deform::bonds;
use crate::deform::relax::Breaks;
use crate::laws::bond;
use crate::laws::bond::Traction;
use crate::ledger::Works;
use crate::query::view::View;
use crate::setup::deform::{BondFailure, BondLaw};
use crate::state::anchor::Freedoms;
use crate::state::deform::{Break, Deform, Facet, State};
use crate::state::relax::Relax;
use crate::state::scratch::{NonFinite, Scratch};
use crate::state::workspace::Workspace;
use crate::state::world::World;
use crate::topology::cut::tip;
use crate::topology::transaction::booked;

/// Facets used at least this share of the most used one break with it.
pub const TOGETHER: f64 = 0.95;
/// Steps between two looks at facets in a dynamic phase.
pub const CHECK_INTERVAL: u64 = 10;

/// A facet, or one of its points, that is beyond its strength.
#[derive(Clone, Copy, Debug)]
struct Due {
    facet: u32,
    /// A single point; `None` breaks all points of the facet.
    point: Option<u32>,
    utilisation: f64,
    mode: bond::FailureMode,
}

/// Breaks what is due at the present state, after `evaluate` with the same damping and `dt` (s); evaluates anew and books
/// it. Returns the number of facets that lost points. A second call at the same step does nothing.
///
/// # Errors
/// Forces that are not finite.
pub fn step(world: &mut World, scratch: &mut Scratch, dt: f64) -> Result<usize, NonFinite> {
    let Some(deform) = world.deform.as_deref_mut() else {
        return Ok(0);
    };
    if scratch.deform.as_ref().is_some_and(|w| w.broke) {
        record_failure(deform, world.step, world.time, 1.0, 0.0);
    }
    if deform.last_check_step == world.step {
        return Ok(0);
    }
    let ready = match &deform.relax {
        Some(relax) => relax.converged,
        None => world.step.is_multiple_of(CHECK_INTERVAL) && world.step > 0,
    };
    if !ready {
        return Ok(0);
    }
    deform.last_check_step = world.step;
    let breaking = deform.breaking;
    settle(world);
    if !breaking {
        return Ok(0);
    }
    let due = due(&View { world, scratch });
    if due.is_empty() {
        return Ok(0);
    }
    booked(world, scratch, dt, |world, _| Ok(apply(world, &due)))
}

/// Commits softening and slip of a converged state of a relaxing phase, once, and books what they have taken since the last one.
pub(crate) fn settle(world: &mut World) {
    let Some(deform) = world.deform.as_deref_mut() else {
        return;
    };
    let due = |relax: &mut Relax| relax.converged && !std::mem::replace(&mut relax.settled, true);
    if !deform.relax.as_mut().is_some_and(due) {
        return;
    }
    let freedoms = Freedoms::new(&world.bodies, &world.turned, Some(&deform.nodes));
    let memory = &mut deform.memory;
    let (mut broke, mut works) = (false, Works::default());
    for (k, facet) in deform.facets.iter().enumerate() {
        let law = world.setup.interfaces[usize::from(facet.row)].bond.as_ref();
        // Bonds that may not break do not soften for good.
        let changes = |l: &&BondLaw| match l.cohesive {
            Some(_) => deform.breaking,
            None => deform.has_history[k],
        };
        let Some(law) = law.filter(changes) else {
            continue;
        };
        for p in facet.points() {
            let jump = freedoms.jump(&deform.points[p].anchors);
            let at = facet.now.map(|e| e.dot(jump));
            let held = bond::connect(facet.stiffness, &memory[p].start, &at);
            let (_, after) = bonds::respond(law, facet.stiffness, &memory[p], &at, false);
            let area = deform.points[p].area;
            if bonds::commit(&mut memory[p], after, area, &mut works) {
                bonds::record_failure(&mut memory[p], law, &held, world.time);
                broke = true;
            }
        }
    }
    world.works.add(&works);
    if broke {
        record_failure(deform, world.step, world.time, 1.0, 0.0);
    }
}

/// What breaks now.
fn due(view: &View<'_>) -> Vec<Due> {
    let Some((deform, work)) = view.deformables() else {
        return Vec::new();
    };
    let relax = deform.relax.as_ref();
    let breaks = relax.map_or(Breaks::Always, |r| r.relaxation.breaks);
    let mut stresses = Stresses::default();
    let mut found: Vec<Due> = Vec::new();
    for (k, facet) in (0..).zip(&deform.facets) {
        let law = view.world.setup.interfaces[usize::from(facet.row)].bond.as_ref();
        let Some((law, strength)) = law.and_then(|l| Some((l, l.strength?))) else {
            continue;
        };
        // Softening points look after themselves, and so do those of dynamic phases.
        let alone = law.failure == BondFailure::Spring
            && (law.cohesive.is_some() || breaks == Breaks::Always);
        if alone || view.world.step < facet.intact_until_step {
            continue;
        }
        let each = |point, t: &Traction| {
            let (utilisation, mode) = strength.utilisation(t);
            if utilisation > 1.0 {
                found.push(Due { facet: k, point, utilisation, mode });
            }
        };
        stresses.judge(deform, work, facet, law.failure, each);
    }
    if let Some(chosen) = tip::may_break(view.world, deform) {
        // From each tip a crack goes on in one direction.
        let of = |d: &Due| chosen.get(&d.facet).cloned().unwrap_or_default();
        let mut best = BTreeMap::new();
        for due in &found {
            for tip in of(due) {
                let most: &mut f64 = best.entry(tip).or_insert(0.0);
                *most = most.max(due.utilisation);
            }
        }
        found.retain(|d| of(d).iter().any(|tip| d.utilisation >= best[tip]));
    }
    // While everything moves each facet fails when it fails.
    if breaks == Breaks::Most {
        let most = most(&found);
        found.retain(|d| d.utilisation >= TOGETHER * most);
    }
    found
}

/// The largest utilisation.
fn most(due: &[Due]) -> f64 {
    due.iter().map(|d| d.utilisation).fold(0.0, f64::max)
}

/// Points of a facet that are not broken.
fn whole<'a>(deform: &'a Deform, facet: &Facet) -> impl Iterator<Item = usize> + 'a {
    facet.points().filter(|p| !deform.memory[*p].state.is_broken())
}

/// Largest utilisation of the facets for which `chosen` holds (their two blocks), each by `failure`.
#[must_use]
pub fn largest(view: &View<'_>, failure: BondFailure, chosen: impl Fn([u32; 2]) -> bool) -> f64 {
    let Some((deform, _)) = view.deformables() else {
        return 0.0;
    };
    let facets = deform.facets.iter().enumerate();
    let facets = facets.filter(|(_, f)| chosen(f.blocks));
    let used = facets.filter_map(|(k, _)| utilisation(view, k, failure));
    used.fold(0.0, f64::max)
}

/// Utilisation of facet `k` by `failure`; `None` if it is broken or never breaks.
#[must_use]
pub fn utilisation(view: &View<'_>, k: usize, failure: BondFailure) -> Option<f64> {
    let (deform, work) = view.deformables()?;
    let facet = &deform.facets[k];
    let law = view.world.setup.interfaces[usize::from(facet.row)].bond.as_ref()?;
    let strength = law.strength?;
    let mut most: Option<f64> = None;
    Stresses::default().judge(deform, work, facet, failure, |_, t| {
        let used = strength.utilisation(t).0;
        most = Some(most.map_or(used, |most| most.max(used)));
    });
    most
}

/// Average stresses of bodies, found when they are asked for.
#[derive(Default)]
struct Stresses {
    known: BTreeMap<u32, Mat3>,
}

impl Stresses {
    /// Calls `each` with the tractions (n, b, c, Pa) by which a facet fails: of its points, or one for all; with none for what is broken.
    fn judge(
        &mut self,
        deform: &Deform,
        work: &Workspace,
        facet: &Facet,
        failure: BondFailure,
        mut each: impl FnMut(Option<u32>, &Traction),
    ) {
        let force = |p: usize| Vec3::from_array(work.slots[p]);
        let along = |t: Vec3, area: f64| facet.now.map(|e| e.dot(t) / area);
        match failure {
            BondFailure::Spring => whole(deform, facet)
                .for_each(|p| each(Some(p as u32), &along(force(p), deform.points[p].area))),
            BondFailure::Facet => {
                let (mut sum, mut area) = (Vec3::ZERO, 0.0);
                for p in whole(deform, facet) {
                    sum += force(p);
                    area += deform.points[p].area;
                }
                if area > 0.0 {
                    each(None, &along(sum, area));
                }
            }
            BondFailure::BlockStress => {
                if whole(deform, facet).next().is_some() {
                    each(None, &self.on(deform, work, facet));
                }
            }
        }
    }

    /// Traction (n, b, c) on a facet by the mean of the average stresses of its deformable blocks, Pa.
    fn on(&mut self, deform: &Deform, work: &Workspace, facet: &Facet) -> Traction {
        let (mut sum, mut count) = (Mat3::ZERO, 0.0);
        for b in facet.blocks {
            if let Some(body) = deform.body(b as usize) {
                let stress = self.known.entry(b);
                sum += *stress.or_insert_with(|| deform.average(work, body).0);
                count += 1.0;
            }
        }
        let t = sum * facet.now[0] / count;
        facet.now.map(|e| e.dot(t))
    }
}

/// Breaks what is due; returns the number of facets.
fn apply(world: &mut World, due: &[Due]) -> usize {
    let Some(deform) = world.deform.as_deref_mut() else {
        return 0;
    };
    let freedoms = Freedoms::new(&world.bodies, &world.turned, Some(&deform.nodes));
    let mut released = 0.0;
    let mut facets: Vec<u32> = Vec::new();
    for one in due {
        let facet = &deform.facets[one.facet as usize];
        let law = world.setup.interfaces[usize::from(facet.row)].bond.as_ref();
        let Some((law, strength)) = law.and_then(|l: &BondLaw| Some((l, l.strength?))) else {
            continue;
        };
        let points = match one.point {
            Some(p) => p as usize..p as usize + 1,
            None => facet.points(),
        };
        for p in points {
            let m = &mut deform.memory[p];
            if m.state.is_broken() {
                continue;
            }
            let jump = freedoms.jump(&deform.points[p].anchors);
            let at = facet.now.map(|e| e.dot(jump));
            let springs = facet.stiffness;
            let (_, held) = bonds::respond(law, springs, m, &at, false);
            let (_, after) = bond::contact(springs, &strength, &m.start, &at, &held);
            let stored = |state| bond::stored(springs, &m.start, &at, state);
            let unbooked = std::mem::take(&mut m.unbooked);
            released += deform.points[p].area * (stored(&held) + unbooked - stored(&after));
            m.law = after;
            m.state = match one.mode {
                bond::FailureMode::Tension => State::Opened,
                bond::FailureMode::Shear => State::Sheared,
            };
            m.broken_at = world.time;
            m.unreported = true;
        }
        if facets.last() != Some(&one.facet) {
            facets.push(one.facet);
        }
    }
    for &k in &facets {
        deform.has_history[k as usize] = true;
    }
    world.works.fracture += released;
    let most = most(due);
    record_failure(deform, world.step, world.time, most, released);
    if let Some(relax) = &mut deform.relax {
        relax.disturb();
        deform.breaks += 1;
        deform.peak_share = deform.peak_share.max(1.0 / most);
    }
    facets.len()
}

/// Writes down which facets have lost points since the last time. `utilisation` and `released` (J) belong to the event as a
/// whole and stand with its first facet.
fn record_failure(deform: &mut Deform, step: u64, time: f64, utilisation: f64, released: f64) {
    let mut released = released;
    for (k, facet) in deform.facets.iter().enumerate() {
        if !deform.has_history[k] {
            // Softening facets are linear until they are not.
            let points = &deform.memory[facet.points()];
            if !points.iter().any(|m| m.unreported) {
                continue;
            }
        }
        let mut area = [0.0; 2];
        for p in facet.points() {
            let m = &mut deform.memory[p];
            if std::mem::take(&mut m.unreported) {
                area[usize::from(m.state == State::Sheared)] += deform.points[p].area;
            }
        }
        if area != [0.0; 2] {
            deform.broken_area[0] += area[0];
            deform.broken_area[1] += area[1];
            deform.broken.push(Break {
                step,
                time,
                facet: k as u32,
                area,
                utilisation,
                released: std::mem::take(&mut released),
            });
        }
    }
}
