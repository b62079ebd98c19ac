//! What lies behind a state that is no number: what was looked at, and what was ruled out.

use super::Simulation;
use crate::dynamics::TimeFunction;
use crate::run::engine::View;
use crate::{planar, spatial};

/// Why the motion of a block is no number.
pub(super) struct Cause {
    /// In words.
    pub words: String,
    /// Text of the formula that is to blame.
    pub formula: Option<String>,
}

/// The first living block whose position or velocity is no number.
pub(super) fn first_block(view: &View<'_>) -> Option<u32> {
    let found = match view {
        View::Planar(v) => v.living().find(|&b| {
            let body = &v.world.bodies[b];
            let numbers = [
                body.position.x,
                body.position.y,
                body.angle,
                body.velocity.length_squared(),
                body.spin * body.spin,
                v.kinetic(b),
            ];
            !numbers.iter().all(|x| x.is_finite())
        }),
        View::Spatial(v) => v.living().find(|&b| {
            let numbers = [
                v.displacement(b).length_squared(),
                v.rotation(b).length_squared(),
                v.velocity(b).length_squared(),
                v.spin(b).length_squared(),
                v.kinetic(b),
            ];
            !numbers.iter().all(|x| x.is_finite())
        }),
    };
    found.and_then(|b| u32::try_from(b).ok())
}

/// Looks at what is prescribed for a block, at the loads, at gravity and at the time step.
pub(super) fn of_block(simulation: &Simulation, block: u32) -> Cause {
    let (view, dt) = (simulation.view(), simulation.dt());
    let b = block as usize;
    let times = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|k| view.time() + k * dt);
    let bad = |f: &TimeFunction| times.iter().any(|t| t.is_finite() && !f.at(*t).is_finite());
    let prescribed = prescribed(&view, b);
    if let Some((what, f)) = prescribed.iter().find(|(_, f)| bad(f)) {
        return blame(&format!("its prescribed {what}"), f);
    }
    let (of_block, others): (Vec<_>, Vec<_>) = loads(&view)
        .into_iter()
        .partition(|(on, _)| on.contains(&block));
    if let Some((_, f)) = of_block.iter().chain(&others).find(|(_, f)| bad(f)) {
        return blame("a load (`loads.*.time`)", f);
    }
    let motion = if prescribed.is_empty() {
        ""
    } else {
        "its prescribed motion, "
    };
    Cause {
        words: format!(
            "looked at: {motion}loads as functions of time; they are numbers. {}",
            of_step(simulation)
        ),
        formula: None,
    }
}

fn blame(what: &str, f: &TimeFunction) -> Cause {
    let formula = match f {
        TimeFunction::Formula(formula) => Some(formula.text().to_owned()),
        TimeFunction::Constant(_)
        | TimeFunction::Ramp { .. }
        | TimeFunction::Sine { .. }
        | TimeFunction::Pulse { .. }
        | TimeFunction::Table { .. }
        | TimeFunction::Duvall { .. } => None,
    };
    let text = formula
        .as_ref()
        .map_or(String::new(), |text| format!(", the formula `{text}`,"));
    Cause {
        words: format!("{what}{text} is not finite at this time"),
        formula,
    }
}

/// Functions of time that prescribe the motion of a block, with words for them.
fn prescribed<'a>(view: &View<'a>, b: usize) -> Vec<(String, &'a TimeFunction)> {
    let named = |what: &str, axis: &str, f: &'a Option<TimeFunction>| {
        f.as_ref().map(|f| (format!("{what} {axis}"), f))
    };
    let mut found = Vec::new();
    match view {
        View::Planar(v) => {
            use planar::setup::Motion;
            match v.world.motion[b].as_deref() {
                Some(Motion::Velocity { x, y, spin }) => {
                    found.extend(named("velocity", "along x", x));
                    found.extend(named("velocity", "along y", y));
                    found.extend(named("spin", "", spin));
                }
                Some(Motion::Acceleration { x, y, spin }) => {
                    found.extend(named("acceleration", "along x", x));
                    found.extend(named("acceleration", "along y", y));
                    found.extend(named("acceleration", "of rotation", spin));
                }
                Some(Motion::Fixed { .. }) | None => {}
            }
        }
        View::Spatial(v) => {
            use spatial::setup::Motion;
            let axes = ["along x", "along y", "along z"];
            match v.world.motion[b].as_deref() {
                Some(Motion::Velocity { translation, spin }) => {
                    for (axis, f) in axes.iter().zip(translation) {
                        found.extend(named("velocity", axis, f));
                    }
                    for (axis, f) in ["about x", "about y", "about z"].iter().zip(spin) {
                        found.extend(named("spin", axis, f));
                    }
                }
                Some(Motion::Acceleration { translation }) => {
                    for (axis, f) in axes.iter().zip(translation) {
                        found.extend(named("acceleration", axis, f));
                    }
                }
                Some(Motion::Fixed { .. }) | None => {}
            }
        }
    }
    found
}

/// Loads: the blocks they act on, and their course in time.
fn loads<'a>(view: &View<'a>) -> Vec<(&'a [u32], &'a TimeFunction)> {
    match view {
        View::Planar(v) => {
            let loads = v.world.setup.loads.iter();
            loads.map(|l| (&l.blocks[..], &l.time)).collect()
        }
        View::Spatial(v) => {
            let loads = v.world.setup.loads.iter();
            loads.map(|l| (&l.blocks[..], &l.time)).collect()
        }
    }
}

/// What is known of the time step before a shorter one has been tried: its share of the stable one.
pub(super) fn of_step(simulation: &Simulation) -> String {
    if simulation.relaxes() {
        return "in a relaxing phase no time step is involved".to_owned();
    }
    let dt = simulation.dt();
    let damping = simulation.phase().map_or(0.0, |p| p.damping.stiffness);
    let stable = simulation.engine().stable(damping).dt;
    let share = dt / stable;
    if !stable.is_finite() {
        format!("nothing bounds the time step ({dt:.3e} s): no block holds another")
    } else if share > 1.0 {
        format!("the time step, {dt:.3e} s, is {share:.2} times the stable one ({stable:.3e} s)")
    } else {
        format!("the time step, {dt:.3e} s, is {share:.2} of the stable one")
    }
}
