//! What lies behind a state that is no number: what was looked at, and what was ruled out.

use super::Simulation;
use crate::Vec3;
use crate::accounts::Condition;
use crate::dynamics::TimeFunction;
use crate::run::engine::View;
use crate::{planar, spatial};

/// Words for directions.
const AXES: [&str; 3] = ["along x", "along y", "along z"];

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

/// Looks at all functions of time of the model, those of the block first, and at the time step.
pub(super) fn of_block(simulation: &Simulation, block: u32) -> Cause {
    let courses = courses(&simulation.view(), block);
    if let Some(cause) = blamed(simulation, &courses) {
        return cause;
    }
    let mut kinds: Vec<&str> = Vec::new();
    for course in &courses {
        if !kinds.contains(&course.kind) {
            kinds.push(course.kind);
        }
    }
    let functions = if kinds.is_empty() {
        "the model has no functions of time".to_owned()
    } else {
        let kinds = kinds.join(", ");
        format!("the functions of time ({kinds}) have finite values")
    };
    Cause { words: format!("{functions}. {}", of_step(simulation)), formula: None }
}

/// The function of time that is no number now, of whatever block, if there is one.
pub(super) fn of_functions(simulation: &Simulation) -> Option<Cause> {
    blamed(simulation, &courses(&simulation.view(), u32::MAX))
}

/// The first function that is no number about now.
fn blamed(simulation: &Simulation, courses: &[TimeDependentInput<'_>]) -> Option<Cause> {
    let (now, dt) = (simulation.time(), simulation.dt());
    // Loads are asked for at whole steps and prescribed motions at half
    // steps, of the step before and of the coming one.
    let times = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|k| now + k * dt);
    let bad = courses.iter().find(|course| course.is_bad(&times))?;
    Some(blame(&bad.what, bad.function))
}

/// Something that a scene gives as a function of time.
struct TimeDependentInput<'a> {
    /// What all of its kind are called.
    kind: &'static str,
    /// What it is, with its name.
    what: String,
    function: &'a TimeFunction,
    /// The instant from which on its time is counted, s.
    since: f64,
    /// Places at which a function of time and place is taken, m (global); none where it is one of time alone.
    places: Vec<[f64; 3]>,
}

impl<'a> TimeDependentInput<'a> {
    fn new(kind: &'static str, what: String, function: &'a TimeFunction) -> Self {
        Self { kind, what, function, since: 0.0, places: Vec::new() }
    }

    /// Whether it is no number at any of some times; before its start nobody asks for it.
    fn is_bad(&self, times: &[f64]) -> bool {
        let times = times.iter().map(|t| t - self.since);
        let mut times = times.filter(|t| t.is_finite() && *t >= 0.0);
        times.any(|t| match &self.places[..] {
            [] => !self.function.at(t).is_finite(),
            places => (places.iter()).any(|at| !self.function.at_place(t, *at).is_finite()),
        })
    }
}

/// All functions of time of a model, those of a block first.
fn courses<'a>(view: &View<'a>, block: u32) -> Vec<TimeDependentInput<'a>> {
    let blocks = view.all_blocks();
    let of = |b: usize, whose: &str| -> Vec<TimeDependentInput<'a>> {
        let course = |(what, f): (String, &'a TimeFunction)| {
            TimeDependentInput::new("prescribed motions", format!("{whose} {what}"), f)
        };
        prescribed(view, b).into_iter().map(course).collect()
    };
    let first = block as usize;
    let mut found = Vec::new();
    if first < blocks {
        found.extend(of(first, "its prescribed"));
    }
    let (own, others): (Vec<_>, Vec<_>) =
        loads(view).into_iter().partition(|(on, _)| on.contains(&block));
    found.extend(own.into_iter().chain(others).map(|(_, course)| course));
    for b in (0..blocks).filter(|b| *b != first) {
        let name = || view.name(u32::try_from(b).unwrap_or(u32::MAX));
        // Few blocks are driven, and many can be there: names are made for those alone.
        if !prescribed(view, b).is_empty() {
            found.extend(of(b, &format!("block `{}`: its prescribed", name())));
        }
    }
    if let View::Spatial(v) = view {
        found.extend(boundaries(v.world));
        found.extend(nodes(v.world));
        found.extend(sources(v.world));
    }
    found
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
    let text = formula.as_ref().map_or(String::new(), |text| format!(", formula `{text}`,"));
    Cause { words: format!("{what}{text} is not finite at this time"), formula }
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
                Some(Motion::Velocity { x, y, spin, .. }) => {
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
            match v.world.motion[b].as_deref() {
                Some(Motion::Velocity { translation, spin, .. }) => {
                    for (axis, f) in AXES.iter().zip(translation) {
                        found.extend(named("velocity", axis, f));
                    }
                    for (axis, f) in ["about x", "about y", "about z"].iter().zip(spin) {
                        found.extend(named("spin", axis, f));
                    }
                }
                Some(Motion::Acceleration { translation }) => {
                    for (axis, f) in AXES.iter().zip(translation) {
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
fn loads<'a>(view: &View<'a>) -> Vec<(&'a [u32], TimeDependentInput<'a>)> {
    let what = |accounts: &[Condition], account: Option<u16>| {
        let condition = account.and_then(|k| accounts.get(usize::from(k)));
        match condition {
            Some(Condition { name, holder }) => {
                format!("the {} `{name}` (`loads.*.time`)", holder.word())
            }
            None => "a load (`loads.*.time`)".to_owned(),
        }
    };
    match view {
        View::Planar(v) => {
            let setup = &v.world.setup;
            let course = |load: &'a planar::setup::Load| {
                let what = what(&setup.accounts, load.account);
                (&load.blocks[..], TimeDependentInput::new("loads", what, &load.time))
            };
            setup.loads.iter().map(course).collect()
        }
        View::Spatial(v) => {
            let setup = &v.world.setup;
            let course = |load: &'a spatial::setup::Load| {
                let what = what(&setup.accounts, load.account);
                (&load.blocks[..], TimeDependentInput::new("loads", what, &load.time))
            };
            setup.loads.iter().map(course).collect()
        }
    }
}

/// Pressures, tractions and velocities of faces.
fn boundaries(world: &spatial::world::World) -> Vec<TimeDependentInput<'_>> {
    use spatial::setup::BoundaryKind;
    let mut found = Vec::new();
    for (number, boundary) in world.setup.boundaries.iter().enumerate() {
        let name = &boundary.name;
        match &boundary.kind {
            BoundaryKind::Traction { traction, time, .. } => {
                let key = if *traction == Vec3::ZERO { "pressure" } else { "traction" };
                let what = format!("the boundary `{name}` (`boundaries.*.{key}.time`)");
                found.push(TimeDependentInput::new("boundaries", what, time));
            }
            BoundaryKind::Moved { velocity } => {
                let faces = (world.faces.iter())
                    .filter(|face| face.boundary.map(usize::from) == Some(number));
                let places: Vec<[f64; 3]> = faces
                    .flat_map(|face| {
                        let centre = world.setup.origin + world.reference[face.block as usize];
                        (0..4).map(move |p| (centre + face.place(p)).to_array())
                    })
                    .collect();
                if places.is_empty() {
                    // On deformable blocks alone: their nodes have it.
                    continue;
                }
                for (axis, f) in AXES.iter().zip(velocity) {
                    let Some(f) = f else { continue };
                    let what = format!("the boundary `{name}`, its velocity {axis}");
                    found.push(TimeDependentInput {
                        places: places.clone(),
                        ..TimeDependentInput::new("boundaries", what, f)
                    });
                }
            }
            BoundaryKind::Held { .. } | BoundaryKind::Viscous { .. } => {}
        }
    }
    found
}

/// Velocities of nodes of deformable blocks, whatever prescribes them.
fn nodes(world: &spatial::world::World) -> Vec<TimeDependentInput<'_>> {
    let Some(deform) = world.deform.as_deref() else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for hold in &deform.holds {
        let place = deform.nodes.place[hold.node as usize] + world.setup.origin;
        for (f, account) in hold.prescribed() {
            let condition = account.and_then(|k| world.setup.accounts.get(usize::from(k)));
            let what = match condition {
                Some(Condition { name, holder }) => {
                    format!("the {} `{name}`, its velocity of nodes", holder.word())
                }
                None => "the prescribed velocity of a node".to_owned(),
            };
            found.push(TimeDependentInput {
                places: vec![place.to_array()],
                ..TimeDependentInput::new("driven nodes", what, f)
            });
        }
    }
    found
}

/// Pressures inside the rock that have begun.
fn sources(world: &spatial::world::World) -> Vec<TimeDependentInput<'_>> {
    use spatial::setup::CavityPressure;
    let mut found = Vec::new();
    for cavity in &world.cavities {
        let source = &world.setup.sources[usize::from(cavity.source)];
        if let (CavityPressure::Pressure { time }, Some(since)) = (&source.push, cavity.ignited) {
            let what = format!("the source `{}` (`sources.*.pressure`)", source.name);
            found.push(TimeDependentInput {
                since,
                ..TimeDependentInput::new("sources", what, time)
            });
        }
    }
    found
}

/// What is known of the time step before a shorter one has been tried: its share of the stable one.
pub(super) fn of_step(simulation: &Simulation) -> String {
    if simulation.relaxes() {
        return "a relaxing phase has no time step".to_owned();
    }
    let dt = simulation.dt();
    if simulation.engine().is_implicit() {
        return format!("steps are implicit, and {dt:.3e} s long");
    }
    let damping = simulation.phase().map_or(0.0, |p| p.damping.stiffness);
    let stable = simulation.engine().stable(damping).dt;
    let share = dt / stable;
    if !stable.is_finite() {
        // Found contacts have steps of their own, as short as they were when it was chosen.
        let rule = simulation.phase().map(|phase| phase.time_step);
        let contacts = rule.map(|rule| simulation.engine().contact_step_limit(rule));
        match contacts.filter(|limit| limit.is_finite()) {
            Some(limit) => {
                format!("the time step is {dt:.3e} s; contacts now allow {limit:.3e} s")
            }
            None => format!("nothing limits the time step ({dt:.3e} s): no two blocks interact"),
        }
    } else if share > 1.0 {
        format!("the time step, {dt:.3e} s, is {share:.2} times the stable step ({stable:.3e} s)")
    } else {
        format!("the time step, {dt:.3e} s, is {share:.2} of the stable step")
    }
}
