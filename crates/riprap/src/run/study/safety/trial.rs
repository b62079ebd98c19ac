//! One trial: a model with the strengths or with the value that is tried, run until it is seen to stand or to fail.

use std::time::Instant;

use super::rules::{Rules, Trial};
use super::verdict::{self, Look, Mechanism, Watch, seeks};
use crate::exec::Exec;
use crate::plan::{
    Damping, Deforming, Integration, Phase, PhaseKind, Plan, Reduction, STATIC_STEP, TimeStep,
};
use crate::run::engine::State as EngineState;
use crate::run::job::JobError;
use crate::run::simulation::{Cursor, Reached, RunError, Simulation, Snapshot, Spent};
use crate::run::study::StudyError;
use crate::run::study::bracket::{State, Task};
use crate::setup::Setup;

/// Steps between two looks at a trial by relaxation; steps of Newton's method are looked at one by one.
const CHECK_INTERVAL: u64 = 50;
/// Displacement over the size of the middle one of the blocks from which on they are not where they were any more: what comes to rest then has not stood.
const FAR: f64 = 0.1;
/// Steps of Newton's method after which relaxation takes its place.
const MOST_SOUGHT: u64 = 500;

/// Share of the stable step that trials take at least: what they pass through on the way to rest need not be exact.
const SHARE: f64 = 0.5;

/// What a trial leaves.
pub(super) struct Done {
    /// As it is told.
    pub trial: Trial,
    /// The state, where it is stable.
    pub state: Option<Snapshot>,
    /// Blocks that move, the farthest first, with their displacement (m), where it fails.
    pub moving: Vec<(String, f64)>,
    /// How they move.
    pub mechanism: Option<Mechanism>,
    /// Whether Newton's method had a part in it, and has moved blocks by more than their springs.
    sought: bool,
    strays: bool,
}

/// Makes a trial.
pub(super) struct Maker<'a> {
    /// Rules of the search.
    pub rules: &'a Rules,
    /// Rows of the interface table whose strength is reduced.
    pub rows: &'a [u16],
    /// The trial.
    pub task: &'a Task<'a, Done>,
    /// When it was begun.
    pub begun: Instant,
}

/// How the phases of a scene came out.
#[derive(Default)]
struct Before {
    /// Why the physics stopped them.
    ended: Option<RunError>,
    /// What was seen, where they fail.
    failing: Option<Watch>,
    /// The farthest displacement in them (m), the block, and whether it is far from where it began.
    farthest: (f64, u32),
    far: bool,
    /// Whether Newton's method had a part in them, has moved blocks by more than their springs, and came to no end.
    sought: bool,
    strays: bool,
    endless: bool,
}

impl Maker<'_> {
    /// A trial of a model from its start; `changed` says that it is not the scene as it stands.
    pub(super) fn anew(
        &self,
        (setup, plan): (Setup, Plan),
        changed: bool,
    ) -> Result<Done, StudyError> {
        let in_space = matches!(setup, Setup::Spatial(_));
        self.either(in_space, |rules| self.whole((setup.clone(), &plan), rules, changed))
    }

    /// Makes a trial by the rules, and by relaxation where Newton's method does not decide it: it has come to no end, or blocks have slid in its long steps before
    /// they stood, and may be wedged between others. Such a trial decides nothing where only Newton's method is asked for.
    fn either(
        &self,
        in_space: bool,
        trial: impl Fn(&Rules) -> Result<Done, StudyError>,
    ) -> Result<Done, StudyError> {
        let relaxing = Rules { integration: Integration::Explicit, ..self.rules.clone() };
        let leaves_open = self.rules.integration == Integration::Automatic;
        if leaves_open && !in_space {
            return trial(&relaxing);
        }
        let done = trial(self.rules)?;
        let decided = match done.trial.state {
            State::Stable => !done.strays,
            State::Failing => true,
            State::Undecided => false,
        };
        let mut done =
            if decided || !(leaves_open && done.sought) { done } else { trial(&relaxing)? };
        let by_newton = done.trial.integration == Integration::Implicit;
        if by_newton && done.strays && done.trial.state == State::Stable {
            done.trial.state = State::Undecided;
            done.trial.note = "blocks slid in the long steps of an implicit static phase, and friction may hold more than the weight asks for; use \
                 `integration = \"explicit\"`"
                .to_owned();
            done.state = None;
        }
        Ok(done)
    }

    /// Runs the phases of a scene by the rules, and one more.
    fn whole(
        &self,
        (setup, plan): (Setup, &Plan),
        rules: &Rules,
        changed: bool,
    ) -> Result<Done, StudyError> {
        let last = trial_phase(plan, rules, self.rows, 1.0);
        let exec = Exec::new(self.task.threads).map_err(JobError::from)?;
        let plan = left_open(plan, rules);
        let mut simulation = Simulation::new(setup, plan, exec).map_err(JobError::from)?;
        let before = self.run(&mut simulation)?;
        let lost = simulation.view().lost_points();
        let Some(watch) = before.failing else {
            let stopped = before.ended.is_some() || before.endless;
            let mut done =
                self.judge(self.after(&simulation.snapshot(), last)?, before.ended, stopped)?;
            done.sought |= before.sought;
            done.strays |= before.strays;
            done.trial.lost_before = lost;
            if changed && before.far && done.trial.state == State::Stable {
                // Rubble at rest is no model that stands.
                done.trial.state = State::Undecided;
                let (moved, block) = before.farthest;
                done.trial.note = format!(
                    "it came to rest after `{}` had moved by {moved:.3e} m in the phases of the scene, and dynamic phases are not monitored; make \
                     the phase static or end it earlier",
                    simulation.view().name(block)
                );
                done.state = None;
            }
            return Ok(done);
        };
        let (phase, from) = (simulation.cursor().phase, simulation.cursor().start_step);
        let name = simulation.phase().map_or("", |phase| phase.name.as_str());
        let note = format!("in phase `{name}` of the scene");
        let mut done = self.told(&simulation, &watch, State::Failing, from, note);
        done.trial.phase = Some(phase);
        done.trial.lost_before = lost;
        done.sought |= before.sought;
        Ok(done)
    }

    /// A trial that goes on from `state` with strengths divided by `by`.
    pub(super) fn weaker(
        &self,
        state: &Snapshot,
        plan: &Plan,
        by: f64,
    ) -> Result<Done, StudyError> {
        let one = |rules: &Rules| {
            let phase = trial_phase(plan, rules, self.rows, by);
            self.judge(self.after(state, phase)?, None, false)
        };
        self.either(matches!(state.state, EngineState::Spatial(_)), one)
    }

    /// A simulation that goes on from a state with one more phase.
    fn after(&self, state: &Snapshot, phase: Phase) -> Result<Simulation, StudyError> {
        let cursor = Cursor {
            gravity_before: state.cursor.gravity_after,
            gravity_after: state.cursor.gravity_after,
            ..Cursor::default()
        };
        let plan = Plan { title: state.plan.title.clone(), phases: vec![phase], ..Plan::default() };
        let snapshot = Snapshot { plan, cursor, state: state.state.clone() };
        let exec = Exec::new(self.task.threads).map_err(JobError::from)?;
        Ok(Simulation::resume(snapshot, exec))
    }

    /// Runs a trial to its verdict.
    fn judge(
        &self,
        mut simulation: Simulation,
        mut ended: Option<RunError>,
        stopped: bool,
    ) -> Result<Done, StudyError> {
        let begin = simulation.steps();
        let mut watch = Watch::new(self.rules.moved);
        let (mut steps, mut sought) = (0, false);
        let mut from = None;
        let state = loop {
            sought |= seeks(&simulation);
            let endless = seeks(&simulation) && simulation.steps() - begin > MOST_SOUGHT;
            if stopped || endless || ended.is_some() {
                break watch.stopped();
            }
            match simulation.advance(steps) {
                Ok(Reached::Asked) => {
                    self.task.goes_on()?;
                    from.get_or_insert_with(|| Spent::of(&simulation.view().balance().works));
                    watch.look(Look::of(&simulation, begin));
                    if watch.is_failing() {
                        break State::Failing;
                    }
                }
                Ok(Reached::End) => {
                    // The phase may have ended by its steps instead.
                    let balanced = simulation.view().unbalanced() <= self.rules.balance
                        || simulation.engine().relaxing().is_some_and(|now| now.converged);
                    watch.look(Look::of(&simulation, begin));
                    break if balanced { State::Stable } else { watch.stopped() };
                }
                Err(why) => ended = Some(why),
            }
            steps = interval(&simulation);
        };
        let note = ended.map_or_else(String::new, |why| why.to_string());
        let mut done = self.told(&simulation, &watch, state, begin, note);
        done.sought |= sought;
        let spent = from.map(|from| Spent::of(&simulation.view().balance().works).since(from));
        done.strays = sought && spent.is_some_and(|spent| watch.has_strayed(spent));
        Ok(done)
    }

    /// Runs the phases of a scene and watches the static ones.
    fn run(&self, simulation: &mut Simulation) -> Result<Before, StudyError> {
        let mut before = Before::default();
        let mut watch: Option<Watch> = None;
        let (mut of_phase, mut begin) = (usize::MAX, 0);
        let mut steps = 0;
        loop {
            match simulation.advance(steps) {
                Ok(Reached::End) => return Ok(before),
                Ok(Reached::Asked) => {}
                Err(why) => {
                    let sought = before.sought || seeks(simulation);
                    return Ok(Before { ended: Some(why), sought, ..before });
                }
            }
            self.task.goes_on()?;
            steps = interval(simulation);
            let cursor = simulation.cursor();
            if seeks(simulation) {
                before.sought = true;
                if simulation.steps() - cursor.start_step > MOST_SOUGHT {
                    return Ok(Before { endless: true, ..before });
                }
            }
            if of_phase != cursor.phase {
                of_phase = cursor.phase;
                // Displacements of a phase are judged against its own beginning.
                watch = None;
            }
            // This one from the beginning of the run, through dynamic phases
            // as well, which are not watched for failure.
            let mut all = Watch::new(self.rules.moved);
            all.look(Look::of(simulation, 0));
            before.strays |=
                seeks(simulation) && all.has_strayed(Spent::of(&simulation.view().balance().works));
            if let Some((moved, block)) = all.farthest()
                && moved > before.farthest.0
            {
                before.farthest = (moved, block);
                before.far = all.has_moved(Some(FAR));
            }
            // What falls while its weight still grows is seen afterwards, from there.
            let elapsed = simulation.time() - cursor.start_time;
            let watched = simulation.phase().is_some_and(|phase| {
                phase.kind == PhaseKind::Static && elapsed > phase.gravity_ramp.unwrap_or(0.0)
            });
            if !watched {
                continue;
            }
            let Some(seen) = &mut watch else {
                begin = simulation.steps();
                watch = Some(Watch::from(self.rules.moved, &Look::of(simulation, begin)));
                continue;
            };
            seen.look(Look::of(simulation, begin));
            if seen.is_failing() {
                before.failing = watch;
                return Ok(before);
            }
        }
    }

    /// What a trial that has come to its end leaves.
    fn told(
        &self,
        simulation: &Simulation,
        watch: &Watch,
        state: State,
        begin: u64,
        note: String,
    ) -> Done {
        let view = simulation.view();
        let (moved, block) = watch.farthest().unwrap_or((0.0, 0));
        let moving = match state {
            State::Failing => watch.moving(),
            State::Stable | State::Undecided => Vec::new(),
        };
        Done {
            trial: Trial {
                value: self.task.value,
                state,
                moved,
                block: view.name(block),
                unbalanced: view.unbalanced(),
                steps: simulation.steps() - begin,
                integration: match simulation.engine().is_implicit() {
                    true => Integration::Implicit,
                    false => Integration::Explicit,
                },
                span: simulation.time() - simulation.cursor().start_time,
                seconds: self.begun.elapsed().as_secs_f64(),
                note,
                far: state == State::Stable && watch.has_moved(None),
                lost_before: 0,
                phase: None,
            },
            sought: seeks(simulation),
            strays: false,
            state: (state == State::Stable).then(|| simulation.snapshot()),
            mechanism: verdict::mechanism(&moving),
            moving: moving.iter().map(|m| (view.name(m.block), verdict::length(m.shift))).collect(),
        }
    }
}

/// Steps until the next look at a trial.
fn interval(simulation: &Simulation) -> u64 {
    if seeks(simulation) { 1 } else { CHECK_INTERVAL }
}

/// The plan with the integration of its static phases left open where they are by default and the rules leave it open.
#[must_use]
pub fn left_open(plan: &Plan, rules: &Rules) -> Plan {
    let mut plan = plan.clone();
    let plain = |phase: &Phase| {
        let auto = matches!(phase.time_step, TimeStep::Auto { .. });
        auto && phase.kind == PhaseKind::Static
            && phase.integration == Integration::Explicit
            && phase.damping == Damping::default()
            && phase.deform.is_none()
    };
    if rules.integration == Integration::Automatic {
        for phase in plan.phases.iter_mut().filter(|phase| plain(phase)) {
            phase.integration = Integration::Automatic;
        }
    }
    plan
}

/// The phase of a trial: static, from the present state, with strengths divided by `factor`.
#[must_use]
pub fn trial_phase(plan: &Plan, rules: &Rules, rows: &[u16], factor: f64) -> Phase {
    let last = plan.phases.last();
    let deform =
        last.and_then(|phase| phase.deform).map(|deform| Deforming { breaking: true, ..deform });
    let time_step = last.map(|phase| phase.time_step);
    let mut phase = Phase::settle("safety", rules.balance);
    phase.until.steps = Some(rules.steps);
    phase.integration = match last.map(|last| last.integration) {
        Some(Integration::Implicit) => Integration::Implicit,
        _ => rules.integration,
    };
    phase.time_step = match time_step {
        _ if phase.integration == Integration::Implicit => TimeStep::Given { dt: STATIC_STEP },
        Some(TimeStep::Auto { safety }) => TimeStep::Auto { safety: safety.max(SHARE) },
        Some(TimeStep::Given { .. }) | None => phase.time_step,
    };
    phase.damping = Damping::default();
    phase.zero_displacements = true;
    phase.zero_velocities = true;
    phase.deform = deform;
    // A trial is judged by what moves, and the ledger of the way there must not stop it.
    phase.max_residual = f64::INFINITY;
    // A factor of one changes nothing, not even the last bit.
    phase.reduction = (factor != 1.0).then(|| Reduction { factor, rows: rows.to_vec() });
    phase
}

/// A plan whose first phase begins with reduced strengths, those that later phases give too.
#[must_use]
pub fn reduced_from_start(plan: &Plan, rows: &[u16], factor: f64) -> Plan {
    let mut plan = plan.clone();
    for phase in &mut plan.phases {
        for (_, law) in phase.contacts.iter_mut().filter(|(row, _)| rows.contains(row)) {
            *law = law.reduced(factor);
        }
        for (_, law) in phase.joints.iter_mut().filter(|(row, _)| rows.contains(row)) {
            *law = law.reduced(factor);
        }
    }
    if let Some(first) = plan.phases.first_mut() {
        first.reduction = Some(Reduction { factor, rows: rows.to_vec() });
    }
    plan
}
