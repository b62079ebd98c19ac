//! Factor of safety by reduction of strengths.
//!
//! The factor F divides all strengths of the chosen interfaces at once: cohesion, tension and the tangent of the friction angle, before
//! and after failure; never stiffness or density (Zienkiewicz, Humpheson and Lewis 1975; Dawson, Roth and Drescher 1999). Every
//! trial is a static phase with local damping that goes on from the last stable state with its stresses:
//!
//! ```text
//!   scene's phases        F = 1       F = 2          F = 1.5       F = 1.25      ...
//!   ------------------> settle -+--> fails      +--> fails    +--> settles -+-->
//!                               +---------------+-------------+             last stable state
//! ```
//!
//! A trial is *stable* when the unbalanced forces have become a small share of all forces. It is *failing* when it is not, some
//! block has moved more than a stated length, and its kinetic energy goes on growing: its mean over the last quarter of the
//! trial is well above that of the third, and that above the second. A model that only settles to its new stresses swings and calms
//! down, at any displacement; one with a mechanism is pulled on by a force that does not go. So the answer does
//! not hang on the stated length, which only says from when on it is worth asking. A trial that is neither when its steps are used up is
//! *undecided*, and never counts as stable: the answer is then a wider range.

mod verdict;

use std::time::Instant;

use serde::Serialize;
use thiserror::Error;

use super::engine::BuildError;
use super::simulation::{Cursor, RunError, Simulation, Snapshot, Stage};
use crate::exec::{Exec, ExecError};
use crate::plan::{Damping, Deforming, Phase, Plan, Reduction, TimeStep};
use crate::setup::Setup;
use verdict::{Look, Watch};
pub use verdict::{Mechanism, State};

/// Largest factor that is tried; above it strength does not decide. Its inverse is the smallest.
const MOST: f64 = 64.0;
/// Steps between two looks at a trial.
const LOOK: u64 = 50;
/// Share of the size of the middle one of the blocks that counts as moved where nothing else is said.
const MOVED: f64 = 1e-3;

/// How the search is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// Width of the answer.
    pub width: f64,
    /// Interfaces whose strength is reduced, by name; empty: all.
    pub interfaces: Vec<String>,
    /// Displacement in a trial from which on it may count as failing, m; `None`: a thousandth of the size of the middle one of the blocks.
    pub moved: Option<f64>,
    /// Ratio of unbalanced forces at which a trial is stable.
    pub balance: f64,
    /// Steps of a trial after which it is undecided.
    pub steps: u64,
    /// Whether every trial runs the scene from its start with the reduced strengths, instead of going on from the last stable state.
    pub from_start: bool,
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            width: 0.01,
            interfaces: Vec::new(),
            moved: None,
            balance: 1e-5,
            steps: 100_000,
            from_start: false,
        }
    }
}

/// One trial.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// Factor that strengths are divided by.
    pub factor: f64,
    /// What came of it.
    pub state: State,
    /// Largest displacement of a block in the trial, m.
    pub moved: f64,
    /// The block that has it.
    pub block: String,
    /// Unbalanced forces over all forces at the end.
    pub unbalanced: f64,
    /// Steps.
    pub steps: u64,
    /// Wall time, s.
    pub seconds: f64,
    /// Why the physics stopped it, if it did.
    pub note: String,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// Largest factor found stable; `None`: the model fails at the smallest one tried.
    pub stable_at: Option<f64>,
    /// Smallest factor found failing; `None`: nothing fails at the largest one tried.
    pub fails_at: Option<f64>,
    /// Whether there is an undecided trial between both, so that the range is wider than was asked for.
    pub undecided: bool,
    /// All trials, in order.
    pub trials: Vec<Trial>,
    /// Blocks that move at `fails_at`, the farthest first, with their displacement in m.
    pub moving: Vec<(String, f64)>,
    /// How they move.
    pub mechanism: Option<Mechanism>,
}

/// Why there is no answer.
#[derive(Debug, Error)]
pub enum SafetyError {
    /// The engine cannot build the model.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// No threads.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// An unknown interface.
    #[error("no interface is called `{name}`; there are: {known}")]
    Interface {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// Nothing can be reduced.
    #[error(
        "none of the chosen interfaces has a strength that could be reduced (friction angle, cohesion or tension): {0}"
    )]
    NoStrength(String),
    /// A number that is none.
    #[error("the width, the ratio of balance and the displacement must be numbers above zero")]
    NotANumber,
    /// The user stopped it.
    #[error("stopped by the user")]
    Stopped,
}

/// Searches for the factor of safety of a model; `report` is told every trial, `stop` asked every few steps.
///
/// # Errors
/// A model that cannot be built or has no strength, rules that are no numbers, the user.
/// # Examples
///
/// ```
/// use riprap::run::safety::{Rules, search};
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
/// let answer = search(&job.setup, &job.plan, &Rules::default(), 1, &|| false, &mut |_| {})?;
/// let exact = 40f64.to_radians().tan() / 30f64.to_radians().tan();
/// assert!((answer.stable_at.unwrap() / exact - 1.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn search(
    setup: &Setup,
    plan: &Plan,
    rules: &Rules,
    threads: usize,
    stop: &dyn Fn() -> bool,
    report: &mut dyn FnMut(&Trial),
) -> Result<Answer, SafetyError> {
    let sound = |x: f64| x.is_finite() && x > 0.0;
    if !sound(rules.width) || !sound(rules.balance) || !rules.moved.is_none_or(sound) {
        return Err(SafetyError::NotANumber);
    }
    let mut search = Search {
        setup,
        plan,
        rules,
        rows: rows(setup, rules)?,
        threads,
        stop,
        report,
        trials: Vec::new(),
        stable: None,
        failed: None,
    };
    search.bracket()?;
    let (stable_at, undecided) = search.narrow()?;
    let failed = search.failed;
    Ok(Answer {
        stable_at,
        fails_at: failed.as_ref().map(|f| f.factor),
        undecided,
        trials: search.trials,
        moving: failed.as_ref().map_or_else(Vec::new, |f| f.moving.clone()),
        mechanism: failed.and_then(|f| f.mechanism),
    })
}

/// Rows of the interface table whose strength is reduced.
fn rows(setup: &Setup, rules: &Rules) -> Result<Vec<u16>, SafetyError> {
    // Name and whether it has a strength.
    let table: Vec<(&str, bool)> = match setup {
        Setup::Planar(setup) => {
            let all = setup.interfaces.iter();
            all.map(|i| {
                (
                    i.name.as_str(),
                    i.contact.has_strength() || i.bond.is_some(),
                )
            })
            .collect()
        }
        Setup::Spatial(setup) => {
            let all = setup.interfaces.iter();
            all.map(|i| {
                let bond =
                    (i.bond.as_ref()).is_some_and(|b| b.strength.is_some() || b.cohesive.is_some());
                (i.name.as_str(), i.joint.strength.is_some() || bond)
            })
            .collect()
        }
    };
    for name in &rules.interfaces {
        if !table.iter().any(|(known, _)| known == name) {
            let known: Vec<&str> = table.iter().map(|(known, _)| *known).collect();
            return Err(SafetyError::Interface {
                name: name.clone(),
                known: known.join(", "),
            });
        }
    }
    let chosen =
        |name: &str| rules.interfaces.is_empty() || rules.interfaces.iter().any(|n| n == name);
    let picked: Vec<usize> = (0..table.len())
        .filter(|row| chosen(table[*row].0))
        .collect();
    if !picked.iter().any(|row| table[*row].1) {
        let names: Vec<&str> = picked.iter().map(|row| table[*row].0).collect();
        return Err(SafetyError::NoStrength(names.join(", ")));
    }
    Ok(picked
        .iter()
        .filter_map(|row| u16::try_from(*row).ok())
        .collect())
}

/// A plan whose first phase begins with reduced strengths, those that later phases give too.
#[must_use]
pub fn reduced_from_start(plan: &Plan, rows: &[u16], factor: f64) -> Plan {
    let mut plan = plan.clone();
    for phase in &mut plan.phases {
        for (_, law) in phase
            .contacts
            .iter_mut()
            .filter(|(row, _)| rows.contains(row))
        {
            *law = law.reduced(factor);
        }
        for (_, law) in phase
            .joints
            .iter_mut()
            .filter(|(row, _)| rows.contains(row))
        {
            *law = law.reduced(factor);
        }
    }
    if let Some(first) = plan.phases.first_mut() {
        first.reduction = Some(Reduction {
            factor,
            rows: rows.to_vec(),
        });
    }
    plan
}

/// The phase of a trial: static, from the present state, with strengths divided by `factor`.
#[must_use]
pub fn trial_phase(plan: &Plan, rules: &Rules, rows: &[u16], factor: f64) -> Phase {
    let last = plan.phases.last();
    let deform = last.and_then(|phase| phase.deform).map(|deform| Deforming {
        breaking: true,
        ..deform
    });
    let time_step = last.map(|phase| phase.time_step);
    let mut phase = Phase::settle("safety", rules.balance);
    phase.until.steps = Some(rules.steps);
    phase.time_step = match time_step {
        Some(rule @ TimeStep::Auto { .. }) => rule,
        Some(TimeStep::Given { .. }) | None => phase.time_step,
    };
    phase.damping = Damping::default();
    phase.zero_displacements = true;
    phase.zero_velocities = true;
    phase.deform = deform;
    phase.max_residual = f64::INFINITY;
    // A factor of one changes nothing, not even the last bit.
    phase.reduction = (factor != 1.0).then(|| Reduction {
        factor,
        rows: rows.to_vec(),
    });
    phase
}

/// The plan of a run that shows the mechanism: the phases of the scene and one of `steps` steps at the factor at which it fails.
///
/// # Errors
/// As [`search`] for the names of interfaces.
pub fn plan_of_mechanism(
    setup: &Setup,
    plan: &Plan,
    rules: &Rules,
    factor: f64,
    steps: u64,
) -> Result<Plan, SafetyError> {
    let rows = rows(setup, rules)?;
    // Below 1 the scene needs its greater strength from the start, or it has failed before.
    let whole = rules.from_start || factor < 1.0;
    let (mut shown, factor) = if whole {
        (reduced_from_start(plan, &rows, factor), 1.0)
    } else {
        (plan.clone(), factor)
    };
    let mut phase = trial_phase(plan, rules, &rows, factor);
    phase.name = "mechanism".to_owned();
    // It ends when it has been seen, not when it is at rest.
    phase.until.unbalanced = None;
    phase.until.steps = Some(steps.max(1));
    shown.phases.push(phase);
    Ok(shown)
}

/// A failing trial.
struct Failed {
    factor: f64,
    moving: Vec<(String, f64)>,
    mechanism: Option<Mechanism>,
}

struct Search<'a> {
    setup: &'a Setup,
    plan: &'a Plan,
    rules: &'a Rules,
    rows: Vec<u16>,
    threads: usize,
    stop: &'a dyn Fn() -> bool,
    report: &'a mut dyn FnMut(&Trial),
    trials: Vec<Trial>,
    /// The largest stable factor so far, with the state it came to.
    stable: Option<(f64, Snapshot)>,
    /// The smallest failing factor so far.
    failed: Option<Failed>,
}

impl Search<'_> {
    /// Finds a stable and a failing factor by doubling or halving from 1.
    fn bracket(&mut self) -> Result<(), SafetyError> {
        let mut factor = 1.0;
        match self.trial(factor)? {
            State::Stable => {
                while self.failed.is_none() && factor < MOST {
                    factor *= 2.0;
                    self.trial(factor)?;
                }
            }
            State::Failing | State::Undecided => {
                while self.stable.is_none() && factor > 1.0 / MOST {
                    factor *= 0.5;
                    self.trial(factor)?;
                }
            }
        }
        Ok(())
    }

    /// Halves what lies between; the largest stable factor, and whether something undecided lies between it and the failing one.
    fn narrow(&mut self) -> Result<(Option<f64>, bool), SafetyError> {
        let stable = |search: &Self| search.stable.as_ref().map(|(factor, _)| *factor);
        let failing = |search: &Self| search.failed.as_ref().map(|failed| failed.factor);
        loop {
            let (Some(low), Some(high)) = (stable(self), failing(self)) else {
                return Ok((
                    stable(self),
                    self.trials.iter().any(|t| t.state == State::Undecided),
                ));
            };
            // Undecided trials divide the range in up to three: of the outer two, the wider one is halved.
            let between = self
                .trials
                .iter()
                .filter(|t| t.state == State::Undecided && t.factor > low && t.factor < high);
            let (first, last) = between.fold((high, low), |(first, last), t| {
                (first.min(t.factor), last.max(t.factor))
            });
            let undecided = first < high;
            let (left, right) = (first - low, if undecided { high - last } else { 0.0 });
            if left.max(right) <= self.rules.width {
                return Ok((Some(low), undecided));
            }
            let [below, above] = if left >= right {
                [low, first]
            } else {
                [last, high]
            };
            let middle = 0.5 * (below + above);
            if middle <= below || middle >= above {
                // The width is finer than the numbers themselves.
                return Ok((Some(low), undecided));
            }
            self.trial(middle)?;
        }
    }

    /// Makes a trial and keeps what it tells.
    fn trial(&mut self, factor: f64) -> Result<State, SafetyError> {
        let begun = Instant::now();
        let (mut simulation, ran) = match &self.stable {
            Some((from, state)) if !self.rules.from_start => {
                (self.weaker(state, factor / from)?, Ok(()))
            }
            _ => {
                let plan = if factor == 1.0 {
                    self.plan.clone()
                } else {
                    reduced_from_start(self.plan, &self.rows, factor)
                };
                let mut simulation =
                    Simulation::new(self.setup.clone(), plan, Exec::new(self.threads)?)?;
                let ran = self.run(&mut simulation)?;
                (self.weaker(&simulation.snapshot(), 1.0)?, ran)
            }
        };
        let begin = simulation.steps();
        let mut watch = Watch::new(self.rules.moved);
        let mut ended = ran.err();
        let state = loop {
            if ended.is_some() {
                break watch.stopped();
            }
            match simulation.prepare() {
                Ok(Stage::Within) => {}
                Ok(Stage::PhaseEnd | Stage::Done) => {
                    let balanced = simulation.view().unbalanced() <= self.rules.balance
                        || simulation
                            .engine()
                            .relaxing()
                            .is_some_and(|now| now.converged);
                    watch.look(Look::of(&simulation, begin));
                    break if balanced {
                        State::Stable
                    } else {
                        watch.stopped()
                    };
                }
                Err(why) => {
                    ended = Some(why);
                    continue;
                }
            }
            if (simulation.steps() - begin).is_multiple_of(LOOK) {
                if (self.stop)() {
                    return Err(SafetyError::Stopped);
                }
                watch.look(Look::of(&simulation, begin));
                if watch.is_failing() {
                    break State::Failing;
                }
            }
            simulation.step();
        };
        let (moved, block) = watch.farthest().unwrap_or((0.0, 0));
        let trial = Trial {
            factor,
            state,
            moved,
            block: simulation.view().name(block),
            unbalanced: simulation.view().unbalanced(),
            steps: simulation.steps() - begin,
            seconds: begun.elapsed().as_secs_f64(),
            note: ended.map_or_else(String::new, |why: RunError| why.to_string()),
        };
        (self.report)(&trial);
        self.trials.push(trial);
        match state {
            State::Stable if self.stable.as_ref().is_none_or(|(f, _)| factor > *f) => {
                self.stable = Some((factor, simulation.snapshot()));
            }
            State::Failing if self.failed.as_ref().is_none_or(|f| factor < f.factor) => {
                let moving = watch.moving();
                let view = simulation.view();
                self.failed = Some(Failed {
                    factor,
                    mechanism: verdict::mechanism(&moving),
                    moving: moving
                        .iter()
                        .map(|m| (view.name(m.block), verdict::length(m.shift)))
                        .collect(),
                });
            }
            State::Stable | State::Failing | State::Undecided => {}
        }
        Ok(state)
    }

    /// A trial that goes on from `state` with strengths divided by `factor`.
    fn weaker(&self, state: &Snapshot, factor: f64) -> Result<Simulation, SafetyError> {
        let phase = trial_phase(self.plan, self.rules, &self.rows, factor);
        let cursor = Cursor {
            gravity_before: state.cursor.gravity_after,
            gravity_after: state.cursor.gravity_after,
            ..Cursor::default()
        };
        let plan = Plan {
            title: self.plan.title.clone(),
            phases: vec![phase],
            ..Plan::default()
        };
        let snapshot = Snapshot {
            plan,
            cursor,
            state: state.state.clone(),
        };
        Ok(Simulation::resume(snapshot, Exec::new(self.threads)?))
    }

    /// Runs the phases of the scene; inside: why the physics stopped them.
    fn run(&self, simulation: &mut Simulation) -> Result<Result<(), RunError>, SafetyError> {
        use super::simulation::Reached;
        loop {
            match simulation.advance(20 * LOOK) {
                Ok(Reached::End) => return Ok(Ok(())),
                Ok(Reached::Asked) if (self.stop)() => return Err(SafetyError::Stopped),
                Ok(Reached::Asked) => {}
                Err(why) => return Ok(Err(why)),
            }
        }
    }
}
