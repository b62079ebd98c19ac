//! What a run will take: stable step, number of steps, CPU time, memory; told by trying a few.

mod ahead;
#[cfg(test)]
mod tests;
mod trial;

use std::time::Duration;

use serde::Serialize;
use thiserror::Error;

use self::ahead::Known;
use self::trial::Trial;
use super::cpu::Work;
use super::engine::{BuildError, Kind, View};
use super::given_step::{self, RefusedStep};
use super::meeting::{self, Outlook, Toe};
use super::overruled;
use super::simulation::{RunError, Simulation};
use crate::dynamics::TimeFunction;
use crate::exec::Exec;
use crate::model::memory::{self, Parts};
use crate::plan::{
    Integration, Phase, PhaseKind, Plan, Relaxing, SAFETY_IN_SPACE, STATIC_STEP, TimeStep,
};
use crate::planar;
use crate::setup::Setup;
use crate::spatial::read::outlook::can_give_way;
use crate::spatial::setup::{BoundaryKind, Shape};

/// Why nothing can be said.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ForecastError {
    /// The engine cannot build the model.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A step that the scene asks for cannot be made.
    #[error(transparent)]
    Step(#[from] RefusedStep),
    /// The physics stops it at once.
    #[error(transparent)]
    Physics(#[from] RunError),
}

/// What to expect of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Forecast {
    /// Stable time step at the start (safety 1), s; absent when nothing can touch, and in an implicit phase.
    pub stable_time_step: Option<f64>,
    /// Block that sets it.
    pub governing_block: Option<String>,
    /// Time step of the first phase as it will be used, s.
    pub time_step: f64,
    /// Longest step that the first phase takes as it nears its equilibrium, s, where that is another: in a static implicit phase.
    pub longest_step: Option<f64>,
    /// `time_step` over the stable one; absent in a static phase of deformable blocks, whose iterations have no length, and in an implicit phase.
    pub share_of_stable: Option<f64>,
    /// Blocks at the start, after splitting and the removal of charges.
    pub blocks: usize,
    /// Touching contacts at the start; patches in space.
    pub contacts: usize,
    /// Fastest block at the start and its speed, m/s.
    pub fastest: Option<(String, f64)>,
    /// Whether blocks are so fast that the tunnelling guard shortens the first steps.
    pub guard_shortens: bool,
    /// Most steps of all phases that end at a time or a step count, as if blocks that can meet in space touched all the time; absent
    /// if a phase has no such end.
    pub steps: Option<u64>,
    /// Fewest steps: with nothing that shortens the step of the start, none of phases that may be at rest before their end.
    pub least_steps: Option<u64>,
    /// Whether a phase may end before its time or step count, because it is at rest: `steps` is then the most.
    pub at_most: bool,
    /// Whether the trial came to the end of the run: `steps` are those that it took.
    pub tried_to_end: bool,
    /// Most iterations of a load step of static phases of deformable blocks; absent without such phases. How many it
    /// takes, and how often bonds break between them, shows the run alone.
    pub iterations: Option<u64>,
    /// Steps per second of CPU time on one thread without records, measured on the first steps, of small models on all.
    pub steps_per_second: f64,
    /// There are fewer contacts than half the blocks: once these meet, a step costs more than those timed.
    pub apart: bool,
    /// Joints can give way: once blocks come loose, steps are shorter and cost more than those timed.
    pub gives_way: bool,
    /// Where the first steps do not speak for the later ones: what the trial lets expect.
    pub reckoned: Option<Reckoned>,
    /// CPU time on one thread without records, s; absent where nothing is known of the number of steps.
    pub cpu_time: Option<f64>,
    /// CPU time for joints, lists and the state before the first step, s; the blocks are there before.
    pub build_time: f64,
    /// Most memory at a time, B.
    pub memory: f64,
    /// A frame before it is compressed, B; 0 where none is written.
    pub frame: usize,
    /// Blocks in space that can meet.
    pub found: Option<Outlook>,
    /// Where in space free blocks lose most of a tilting load to the softness of the joint on which they stand; absent where none stand so.
    pub toe: Option<Toe>,
    /// What is probably not meant, in words.
    pub warnings: Vec<String>,
}

/// Steps and time of a run whose blocks are or become loose, or which may be at rest early: from the later half of its trial.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reckoned {
    /// Steps.
    pub steps: u64,
    /// CPU time on one thread without records, s.
    pub cpu_time: f64,
    /// Whether a phase may end before, because it is at rest: both are then the most.
    pub at_most: bool,
    /// CPU time of the trial, s.
    pub tried: f64,
    /// Time of the model that it reached, s.
    pub reached: f64,
    /// The phase that it reached.
    pub phase: String,
    /// When phases that go on until the model rests are taken to end, s after their beginning; absent without such phases.
    pub rest: Option<f64>,
}

/// A model that falls to pieces rests after so many times of a free fall from its height. Three blasts of benches and a heap rested after 4.8 to 6.9.
const FALLS: f64 = 6.0;

/// When the pieces of a model are taken to rest, s, where a phase waits for that.
fn rest(view: &View<'_>, plan: &Plan, gravity: [f64; 3]) -> Option<f64> {
    plan.phases.iter().find(|phase| phase.until.rest.is_some())?;
    let pull = gravity.iter().map(|g| g * g).sum::<f64>().sqrt();
    let height = view.free_height(gravity.map(|g| -g / pull));
    (pull > 0.0 && height > 0.0).then(|| FALLS * (2.0 * height / pull).sqrt())
}

/// Advances a copy of the model by a few steps, of one whose blocks are loose for two seconds.
///
/// # Errors
/// The engine cannot build it, a given step is too long, or the physics stops it at once.
/// # Examples
///
/// ```
/// use riprap::run::forecast::forecast;
/// use riprap::run::scene::Scene;
/// use riprap::scenario::Source;
///
/// // A stone on a slope of 30 degrees, friction angle 40 degrees.
/// # let text = r#"
/// # riprap = 1
/// # title = "a stone on a slope"
/// # [space.planar]
/// # gravity = ["0 m/s2", "-9.81 m/s2"]
/// # tilt = "30 deg"
/// # [materials.rock]
/// # density = "2500 kg/m3"
/// # [interfaces.default]
/// # normal_stiffness = "1 GPa/m"
/// # friction_angle = "40 deg"
/// # [[blocks]]
/// # name = "slope"
/// # material = "rock"
/// # rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
/// # [[blocks]]
/// # name = "stone"
/// # material = "rock"
/// # rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
/// # [[supports]]
/// # on = { block = "slope" }
/// # fixed = {}
/// # [[phases]]
/// # name = "settle"
/// # kind = "static"
/// # until = { unbalanced = 1e-6, steps = 50000 }
/// # [[checks]]
/// # name = "the stone stays"
/// # field = "block.speed"
/// # of = "stone"
/// # at = "end"
/// # between = ["0 m/s", "1 mm/s"]
/// # "#;
/// let scene = Scene::parse(Source::new("slope.toml", text), ".".into(), &[])?;
/// let job = scene.prepare(&scene.plain())?.job();
/// let forecast = forecast(&job.setup, &job.plan)?;
/// # let _ = forecast;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn forecast(setup: &Setup, plan: &Plan) -> Result<Forecast, ForecastError> {
    within(setup, plan, trial::LOOSE)
}

/// The same with so much CPU time for the trial of loose blocks.
fn within(setup: &Setup, plan: &Plan, most: Duration) -> Result<Forecast, ForecastError> {
    let work = Work::begin();
    let mut simulation = Simulation::new(setup.clone(), plan.clone(), Exec::serial())?;
    given_step::check(&simulation)?;
    let stage = simulation.prepare()?;
    let build_time = work.done().as_secs_f64();
    let stable = simulation.stable();
    let dt = simulation.dt();
    let view = simulation.view();
    let fastest = view.fastest().filter(|(_, speed)| *speed > 0.0);
    let (blocks, contacts) = (view.blocks(), view.contacts());
    let gives_way = view.spatial().is_some_and(|of| can_give_way(of.world));
    let found = meeting::outlook(&view);
    let toe = meeting::toe(&view, simulation.cursor().gravity_after);
    // Blocks that are apart have no stable step: what steps become once they touch is a better guess than none.
    let touching = found.as_ref().and_then(|found| found.steps);
    let touching = touching.map_or(f64::INFINITY, |[step, _]| step);
    // What bounds explicit steps bounds no implicit one.
    let bounded = !simulation.engine().is_implicit();
    let governing_block = stable.block.filter(|_| bounded).map(|b| view.name(b));
    let guard_shortens = simulation.cursor().shortened > 0;
    let timed = bounded && stable.dt.is_finite() && !simulation.relaxes();
    let at_most = plan.phases.iter().any(may_rest);
    let relaxed = plan.phases.iter().filter_map(relaxing);
    let iterations = relaxed.map(|relax| relax.iterations).max();
    let mut warnings = doubts(&simulation, plan, stable.dt);
    let meets = touching.min(simulation.engine().contact_step_limit(USUAL));
    warnings.extend((plan.phases.iter()).filter_map(|p| idle_safety(p, stable.dt, meets)));
    let memory = memory::expected(&parts(&simulation.view(), setup, contacts, found.as_ref()));
    let frame = simulation.view().frame_bytes(plan);
    let rest = rest(&simulation.view(), plan, simulation.cursor().gravity_after);
    let apart = 2 * contacts < blocks;
    let loose = apart || gives_way || at_most;
    let trial = Trial::of(&mut simulation, stage, loose.then_some(most))?;
    let wanted =
        |phase: &Phase| phase.time_step.wanted(stable.dt, &phase.until, phase.gravity_ramp);
    let pulled = simulation.cursor().gravity_after != [0.0; 3];
    let falling = found.as_ref().filter(|_| apart && pulled).map_or(0, |found| found.blocks);
    let limit = simulation.engine().contact_step_limit(USUAL);
    let known = Known { falling, contacts: limit, rest };
    let ahead = ahead::ahead(plan, &trial.marks, &wanted, known);
    let reckoned = ahead.filter(|_| loose && trial.end.is_none()).map(|ahead| Reckoned {
        steps: trial.steps + ahead.steps.ceil() as u64,
        cpu_time: trial.cpu() + ahead.cpu,
        at_most: ahead.at_most,
        tried: trial.cpu(),
        reached: simulation.time(),
        phase: simulation.phase().map_or_else(String::new, |phase| phase.name.clone()),
        rest,
    });
    let [least_steps, steps] = match trial.end {
        Some(taken) => [Some(taken); 2],
        None => total_steps(plan, stable.dt, touching).map(|n| n.map(|n| n.max(trial.steps))),
    };
    Ok(Forecast {
        stable_time_step: Some(stable.dt).filter(|dt| bounded && dt.is_finite()),
        governing_block,
        time_step: dt,
        longest_step: longest(&simulation).filter(|longest| *longest > dt),
        share_of_stable: timed.then(|| dt / stable.dt),
        blocks,
        contacts,
        fastest,
        guard_shortens,
        steps,
        least_steps,
        at_most: at_most && trial.end.is_none(),
        tried_to_end: trial.end.is_some(),
        iterations,
        steps_per_second: trial.rate,
        apart: apart && trial.end.is_none(),
        gives_way: gives_way && trial.end.is_none(),
        cpu_time: match &reckoned {
            Some(reckoned) => Some(reckoned.cpu_time),
            None => steps.map(|n| n as f64 / trial.rate),
        },
        reckoned,
        build_time,
        memory,
        frame,
        found,
        toe,
        warnings,
    })
}

/// Steps of a phase below which no motion is followed.
const FEW_STEPS: f64 = 20.0;

/// Whether gravity (m/s²) pulls against the upper side of pictures, y in the plane and z in space, more than along other axes.
fn points_up([x, y, z]: [f64; 3], kind: Kind) -> bool {
    match kind {
        Kind::Planar | Kind::Slice => y > x.abs(),
        Kind::Spatial => z > x.abs().max(y.abs()),
    }
}

/// What a scene holds that is probably not meant, in words that name blocks in backticks. The first step must be prepared; `stable`
/// is the stable step at the start, s, infinite where nothing bounds it.
pub(super) fn doubts(simulation: &Simulation, plan: &Plan, stable: f64) -> Vec<String> {
    let view = simulation.view();
    let mut found = overruled::words(&view);
    found.extend(meeting::words(&view));
    found.extend(meeting::undamped(&view, plan));
    let gravity = simulation.cursor().gravity_after;
    let pulled = gravity != [0.0; 3];
    if points_up(gravity, simulation.kind()) {
        found.push(
            "gravity points up: in [space.planar] it is a vector, usually [\"0 m/s2\", \"-9.81 m/s2\"]; one value in [space.spatial] points down without a sign"
                .to_owned(),
        );
    }
    if pulled && !view.holds_something() {
        found.push(
            "no block is held or supported, so the whole model falls under gravity; add `[[supports]]`, in space also `[[boundaries]]`"
                .to_owned(),
        );
    }
    found.extend(meeting::only_dashpots(&view));
    found.extend(meeting::idle_bolts(&view));
    found.extend((plan.phases.iter()).filter_map(|p| gravity_cut_off(p, stable)));
    for phase in plan.phases.iter().filter(|p| relaxing(p).is_none()) {
        let dt = phase.time_step.wanted(stable, &phase.until, phase.gravity_ramp);
        let steps = phase.until.time.map_or(f64::INFINITY, |time| time / dt);
        if stable.is_finite() && steps < FEW_STEPS {
            found.push(format!(
                "phase `{}` has only {} steps of {dt:.3e} s, too few to resolve any motion; check stiffness, density and sizes, `time_step` and \
                 `until.time`",
                phase.name,
                steps.ceil()
            ));
        }
    }
    found.extend(plan.phases.iter().filter_map(|p| near_limit(&view, p, stable)));
    let quiet = plan.phases.iter().find(|p| p.kind == PhaseKind::Static && relaxing(p).is_none());
    if let (Some(phase), Some(what)) = (quiet, moved(&view)) {
        found.push(format!(
            "{what} is driven in the static phase `{}`, whose time is not physical: the phase may not reach equilibrium",
            phase.name
        ));
    }
    found.extend(simulation.shorter());
    let dt = simulation.dt();
    let explicit = !simulation.relaxes() && !simulation.engine().is_implicit();
    if explicit && stable.is_finite() && dt > stable {
        found.push(format!(
            "the time step of the first phase is {:.1} times the stable step ({stable:.3e} s); leave `time_step` out or shorten it",
            dt / stable
        ));
    }
    found
}

/// The rule under which found contacts in space have the longest steps that any rule gives them.
const USUAL: TimeStep = TimeStep::Auto { safety: SAFETY_IN_SPACE };

/// That a `safety` above the usual one has no effect, in words; `stable` is the stable step at the start, s, `contacts` what found contacts
/// in space allow, s, infinite where there are none.
fn idle_safety(phase: &Phase, stable: f64, contacts: f64) -> Option<String> {
    let TimeStep::Auto { safety } = phase.time_step else {
        return None;
    };
    let wanted = |rule: TimeStep| rule.wanted(stable, &phase.until, phase.gravity_ramp);
    let rules = contacts < wanted(USUAL) && relaxing(phase).is_none();
    (safety > SAFETY_IN_SPACE && rules).then(|| {
        format!(
            "`safety` = {safety} in phase `{}` gives no longer steps than {SAFETY_IN_SPACE}: contacts limit the step to {contacts:.3e} s, which a \
             smaller `safety` reduces and a larger one does not increase",
            phase.name
        )
    })
}

/// Share of the stable step up to which bonds that break make no energy worth a word. A bar that spalls (`spall.toml`) makes 0.05 % of what moves at
/// 0.8, 1 % at 0.9, 18 % at 0.99 and 95 % at 1: near the limit the fastest motion turns round in every step, and a bond that breaks
/// between two kicks leaves its blocks with the first one alone. Joints of rigid blocks make 1 % at 0.99 there.
const MOST_WITH_BREAKING: f64 = 0.8;

/// Times that differ by less than this share are the same, written in other units: 700 ms are 0.7000000000000001 s.
const SAME_TIME: f64 = 1e-9;

/// That a phase ends before its gravity is there in full, in words; `stable` is the stable step at the start, s.
fn gravity_cut_off(phase: &Phase, stable: f64) -> Option<String> {
    let ramp = phase.gravity_ramp?;
    let dt = phase.time_step.wanted(stable, &phase.until, phase.gravity_ramp);
    // Steps of a relaxing phase are iterations, in which no time passes.
    let steps = phase.until.steps.filter(|_| relaxing(phase).is_none());
    let stepped = steps.map(|steps| steps as f64 * dt);
    let time = phase.until.time.into_iter().chain(stepped);
    let time = time.reduce(f64::min).filter(|time| *time < ramp * (1.0 - SAME_TIME))?;
    Some(format!(
        "phase `{}` ends after {time:.3e} s, before its gravity has reached the full value (`gravity_ramp`, {ramp} s): the next phase applies all of \
         it at once",
        phase.name
    ))
}

/// That a phase with bonds that can break steps near the limit, in words; `stable` is the stable step at the start, s.
fn near_limit(view: &View<'_>, phase: &Phase, stable: f64) -> Option<String> {
    phase.deform.filter(|rules| rules.breaking && rules.relax.is_none())?;
    let laws = &view.spatial()?.world.setup.interfaces;
    let breaks =
        laws.iter().filter_map(|law| law.bond.as_ref()).any(|bond| bond.strength.is_some());
    let share = match phase.time_step {
        TimeStep::Auto { safety } => safety,
        TimeStep::Given { dt } => dt / stable,
    };
    (breaks && share > MOST_WITH_BREAKING * (1.0 + 1e-9)).then(|| {
        format!(
            "the steps of phase `{}` are {:.0} % of the stable step, and bonds can break: above {:.0} % breaking may create energy (in a spalling \
             bar 1 % of the largest energy at 90 %, a fifth at 99 %); a smaller `safety` or `time_step` avoids it",
            phase.name,
            100.0 * share,
            100.0 * MOST_WITH_BREAKING
        )
    })
}

/// The first block that is driven, or the first boundary that moves with a constant velocity, in words.
fn moved(view: &View<'_>) -> Option<String> {
    if let Some(block) = view.driven() {
        return Some(format!("block `{}`", view.name(block)));
    }
    let mut boundaries = view.spatial()?.world.setup.boundaries.iter();
    let moves = |velocity: &Option<TimeFunction>| matches!(velocity, Some(TimeFunction::Constant(speed)) if speed.abs() > 0.0);
    let found = boundaries.find(|boundary| match &boundary.kind {
        BoundaryKind::Moved { velocity } => velocity.iter().any(moves),
        BoundaryKind::Held { .. }
        | BoundaryKind::Viscous { .. }
        | BoundaryKind::Traction { .. } => false,
    })?;
    Some(format!("the boundary `{}`", found.name))
}

/// The longest step of the first phase where steps grow on the way to its equilibrium, s.
fn longest(simulation: &Simulation) -> Option<f64> {
    let phase = simulation.plan().phases.first()?;
    let grow = phase.kind == PhaseKind::Static && simulation.engine().is_implicit();
    let step = match phase.time_step {
        TimeStep::Given { dt } => dt,
        TimeStep::Auto { .. } => STATIC_STEP,
    };
    grow.then_some(step)
}

/// How a phase relaxes, if it does.
fn relaxing(phase: &Phase) -> Option<Relaxing> {
    phase.deform.as_ref().and_then(|deform| deform.relax)
}

/// Whether a phase may end before its time or step count.
fn may_rest(phase: &Phase) -> bool {
    let until = &phase.until;
    until.unbalanced.is_some()
        || until.kinetic.is_some()
        || until.rest.is_some()
        || relaxing(phase).is_some()
}

/// Fewest and most steps of all phases; absent if one has no end. `stable` is the stable step at the start, s, `touching` that of blocks that
/// touch all the time.
fn total_steps(plan: &Plan, stable: f64, touching: f64) -> [Option<u64>; 2] {
    let wanted = |phase: &Phase| phase.time_step.wanted(stable, &phase.until, phase.gravity_ramp);
    let least = total(plan, |phase| (!may_rest(phase)).then(|| wanted(phase)));
    let most = |phase: &Phase| {
        let contacts = match phase.integration {
            Integration::Implicit => f64::INFINITY,
            Integration::Explicit | Integration::Automatic => touching,
        };
        Some(wanted(phase).min(phase.time_step.of_contacts() * contacts))
    };
    [least, total(plan, most)]
}

/// Steps of all phases; absent if one has no end. `step` is the length of the steps of a phase, s, `None` where it may have none.
fn total(plan: &Plan, step: impl Fn(&Phase) -> Option<f64>) -> Option<u64> {
    let steps = plan.phases.iter().map(|phase| {
        let Some(step) = step(phase) else {
            return Some(0.0);
        };
        // Where it relaxes, the time is that of the loads, not of steps.
        let span = phase.until.time.filter(|_| relaxing(phase).is_none());
        let by_time = span.map(|span| (span / step * (1.0 - 1e-9)).ceil());
        let by_count = phase.until.steps.map(|n| n as f64);
        match (by_time, by_count) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    });
    let steps = steps.sum::<Option<f64>>().filter(|n| n.is_finite());
    steps.map(|n| n as u64)
}

/// Corners of a shape; `None` for a brick, which needs none.
fn corners(shape: &Shape) -> Option<usize> {
    match shape {
        Shape::Brick { .. } => None,
        Shape::Polyhedron(solid) => Some(solid.vertices.len()),
        Shape::Glued(parts) => Some(parts.iter().map(|part| part.vertices.len()).sum()),
        Shape::Terrain(surface) => Some(surface.points.len()),
    }
}

/// What of a model takes memory.
fn parts(view: &View<'_>, setup: &Setup, contacts: usize, found: Option<&Outlook>) -> Parts {
    let setup = match setup {
        Setup::Planar(setup) => {
            let pieces =
                |bolt: &planar::setup::Bolt| (bolt.toe - bolt.head).length() / bolt.design.piece;
            return Parts {
                bolt_pieces: setup.bolts.iter().map(pieces).sum(),
                flat: setup.blocks.len(),
                flat_corners: setup.blocks.iter().map(|b| b.vertices.len()).sum(),
                flat_near: (view.planar())
                    .map_or(0, |v| v.world.pairs.len() + v.world.general.len()),
                ..Parts::default()
            };
        }
        Setup::Spatial(setup) => setup,
    };
    let mut deforms = vec![false; setup.blocks.len()];
    for b in setup.deform.sets.iter().flat_map(|set| &set.blocks) {
        deforms[*b as usize] = true;
    }
    let deformable = deforms.iter().filter(|deforms| **deforms).count();
    let corners_of = |wanted: bool| {
        let blocks = setup.blocks.iter().zip(&deforms);
        let those = blocks.filter(move |(_, deforms)| **deforms == wanted);
        those.filter_map(|(block, _)| corners(&block.shape))
    };
    let rigid: Vec<usize> = corners_of(false).collect();
    Parts {
        // With those that others were split into.
        bricks: view.blocks().saturating_sub(deformable + rigid.len()),
        solids: rigid.len(),
        corners: rigid.iter().sum(),
        joints: contacts,
        meeting: found.map_or(0, |found| found.rigid),
        near: (view.spatial()).map_or(0, |v| v.world.near_pairs()),
        deformable,
        deformable_corners: corners_of(true).sum(),
        bonds: (view.spatial())
            .and_then(|v| v.world.deform.as_ref())
            .map_or(0, |deform| deform.facets.len()),
        bolt_pieces: (setup.bolts.iter())
            .map(|bolt| bolt.head.distance(bolt.toe) / bolt.design.piece)
            .sum(),
        ..Parts::default()
    }
}
