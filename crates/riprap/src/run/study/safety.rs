//! Factor of safety by reduction of strengths.
//!
//! The factor F divides all strengths of the chosen interfaces at once: cohesion, tension and the tangent of the friction angle, before
//! and after failure; never stiffness or density (Zienkiewicz, Humpheson and Lewis 1975; Dawson, Roth and Drescher 1999). Every
//! trial is a static phase that goes on from the last stable state with its stresses:
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
//!
//! Models in space that implicit steps can take seek their equilibrium by Newton's method, some tens of steps in place of thousands. A trial then is *failing* when
//! blocks move on and on: as far as steps allow, or under unbalanced forces that do not fall. What is not decided so is tried again by relaxation.

mod record;
mod rules;
mod scope;
mod trial;
mod verdict;

use std::time::Instant;

use super::bracket::{Found, Search, Task, drive};
#[cfg(feature = "scenario")]
use super::range::Source;
use super::{Executor, StudyError};
use crate::plan::shown::Shown;
use crate::plan::{Every, Integration, Plan, Until};
use crate::run::job::Job;
#[cfg(feature = "scenario")]
use crate::run::scene::Scene;
#[cfg(feature = "scenario")]
use crate::scenario::Case;
use crate::setup::Setup;

pub use super::bracket::State;
#[cfg(feature = "scenario")]
pub use super::range::Quantity;
pub use rules::{Answer, Rules, Trial};
use scope::{Scope, scope};
use trial::{Done, Maker};
pub use trial::{left_open, reduced_from_start, trial_phase};
pub use verdict::Mechanism;

/// Largest factor that is tried; above it strength does not decide. Its inverse is the smallest.
const MOST: f64 = 64.0;

/// Frames of the run of the mechanism.
const FRAMES: u64 = 20;

/// Searches for the factor of safety of a model; `report` is told every trial.
///
/// # Errors
/// A model that cannot be built or has no strength, rules that are no numbers, the user.
/// # Examples
///
/// ```
/// use riprap::run::scene::Scene;
/// use riprap::run::study::Executor;
/// use riprap::run::study::safety::{Rules, search};
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
/// let answer = search(&job.setup, &job.plan, &Rules::default(), &Executor::ALONE, &mut |_| {})?;
/// let exact = 40f64.to_radians().tan() / 30f64.to_radians().tan();
/// assert!((answer.stable_at.unwrap() / exact - 1.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn search(
    setup: &Setup,
    plan: &Plan,
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> Result<Answer, StudyError> {
    sound(rules)?;
    let search = Search::from_one(MOST, rules.width).map_err(|_| StudyError::NotANumber)?;
    let Scope { setup, plan, rows } = scope(setup, plan, rules)?;
    let one = |task: &Task<'_, Done>| {
        let maker = Maker { rules, rows: &rows, task, begun: Instant::now() };
        let factor = task.value;
        if let Some((from, Done { state: Some(state), .. })) = task.from {
            return maker.weaker(state, &plan, factor / from);
        }
        let plan =
            if factor == 1.0 { plan.clone() } else { reduced_from_start(&plan, &rows, factor) };
        maker.anew((setup.clone(), plan), factor != 1.0)
    };
    answer(search, !rules.from_start, executor, rules.width, one, report)
}

/// Searches for the value of a quantity at which a case of a scene begins to fail; `report` is told every trial. Every trial runs the
/// scene from its start.
///
/// # Errors
/// Values that the scene cannot have, models that cannot be built, rules that are no numbers, the user.
#[cfg(feature = "scenario")]
pub fn over_quantity(
    scene: &Scene,
    case: &Case,
    quantity: &Quantity,
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> Result<Answer, StudyError> {
    over_changed(&Source::plain(scene, case), quantity, rules, executor, report)
}

/// The same of a case whose jobs are changed.
#[cfg(feature = "scenario")]
pub(super) fn over_changed(
    of: &Source<'_>,
    quantity: &Quantity,
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> Result<Answer, StudyError> {
    let rules = Rules { width: quantity.width, ..rules.clone() };
    sound(&rules)?;
    let search = quantity.search().map_err(|_| StudyError::NotANumber)?;
    for end in [quantity.low, quantity.high] {
        of.job(Some((quantity, end)))?;
    }
    let one = |task: &Task<'_, Done>| {
        let maker = Maker { rules: &rules, rows: &[], task, begun: Instant::now() };
        let job = of.job(Some((quantity, task.value)))?;
        maker.anew((job.setup, job.plan), true)
    };
    let answer = answer(search, false, executor, quantity.width, one, report)?;
    Ok(Answer {
        quantity: Some(quantity.key.clone()),
        unit: quantity.unit.clone(),
        shown: quantity.shown.clone(),
        ..answer
    })
}

/// The factor of safety of the model of `job`, or with `over` the limit of a quantity of the case that it is of; and the job
/// whose mechanism [`mechanism_job`] shows.
///
/// # Errors
/// As [`search`] and [`over_quantity`].
#[cfg(feature = "scenario")]
pub fn find(
    job: Job,
    over: Option<(&Scene, &Case, &Quantity)>,
    rules: &Rules,
    executor: &Executor<'_>,
    report: &mut dyn FnMut(&Trial),
) -> Result<(Answer, Job), StudyError> {
    let Some((scene, case, quantity)) = over else {
        let answer = search(&job.setup, &job.plan, rules, executor, report)?;
        return Ok((answer, job));
    };
    let answer = over_quantity(scene, case, quantity, rules, executor, report)?;
    let value = answer.fails_at.unwrap_or(quantity.low);
    Ok((answer, quantity.prepare(scene, case, value)?.job()))
}

/// Whether the rules are numbers above 0.
///
/// # Errors
/// They are not.
pub fn sound(rules: &Rules) -> Result<(), StudyError> {
    let sound = |x: f64| x.is_finite() && x > 0.0;
    if !sound(rules.width) || !sound(rules.balance) || !rules.moved.is_none_or(sound) {
        return Err(StudyError::NotANumber);
    }
    Ok(())
}

/// Makes the trials of a search and says what they found, of a factor of safety.
fn answer(
    search: Search,
    chained: bool,
    executor: &Executor<'_>,
    width: f64,
    one: impl Fn(&Task<'_, Done>) -> Result<Done, StudyError> + Sync,
    report: &mut dyn FnMut(&Trial),
) -> Result<Answer, StudyError> {
    let mut trials = Vec::new();
    let work = |task: &Task<'_, Done>| one(task).map(|done| (done.trial.state, done));
    let Found { search, failing, .. } =
        drive(search, chained, executor, work, |_, _, done: &Done| {
            report(&done.trial);
            trials.push(done.trial.clone());
        })?;
    let (moving, mechanism) = failing.map_or((Vec::new(), None), |f| (f.moving, f.mechanism));
    Ok(Answer {
        quantity: None,
        unit: String::new(),
        shown: Shown::si(""),
        width,
        stable_at: search.holds_at(),
        fails_at: search.fails_at(),
        undecided: search.undecided(),
        trials,
        moving,
        mechanism,
    })
}

/// The job of a run that shows the mechanism, of the model `job` is of: that of the scene, or for a quantity that of the value at which it
/// fails. It has the phases of the scene and one of as many steps as the trial that fails nearest to the limit had, with about
/// twenty frames; `None` where nothing failed.
///
/// # Errors
/// As [`search`] for the names of interfaces, materials and groups.
pub fn mechanism_job(
    mut job: Job,
    rules: &Rules,
    answer: &Answer,
) -> Result<Option<Job>, StudyError> {
    let failing = |t: &&Trial| t.state == State::Failing && Some(t.value) == answer.fails_at;
    let Some(trial) = answer.trials.iter().find(failing) else {
        return Ok(None);
    };
    let steps = trial.steps.max(1);
    // As that trial sought its equilibrium.
    let rules = &Rules {
        integration: match trial.integration {
            Integration::Explicit => Integration::Explicit,
            Integration::Implicit | Integration::Automatic => rules.integration,
        },
        ..rules.clone()
    };
    job.plan = left_open(&job.plan, rules);
    let (mut rows_of, mut factor) = (Vec::new(), 1.0);
    if answer.quantity.is_none() {
        let Scope { setup, plan, rows } = scope(&job.setup, &job.plan, rules)?;
        (job.setup, job.plan, rows_of) = (setup, plan, rows);
        // Below 1 the scene needs its greater strength from the start, or it has failed before.
        if (rules.from_start && trial.value != 1.0) || trial.value < 1.0 {
            job.plan = reduced_from_start(&job.plan, &rows_of, trial.value);
        } else {
            factor = trial.value;
        }
    }
    // It ends when it has been seen, not when it is at rest.
    let seen = Until { steps: Some(steps), ..Until::default() };
    if let Some(phase) = trial.phase {
        job.plan.phases.truncate(phase + 1);
        for last in job.plan.phases.iter_mut().skip(phase) {
            last.until = seen;
        }
    } else {
        let mut phase = trial_phase(&job.plan, rules, &rows_of, factor);
        phase.name = "mechanism".to_owned();
        phase.until = seen;
        job.plan.phases.push(phase);
    }
    // In time where steps are long ones: the phases of the scene before have many more of them.
    job.plan.frames = Some(match trial.integration {
        Integration::Implicit if trial.span > 0.0 => Every::Time(trial.span / FRAMES as f64),
        _ => Every::Steps(steps.div_ceil(FRAMES).max(1)),
    });
    job.checks.clear();
    Ok(Some(job))
}
