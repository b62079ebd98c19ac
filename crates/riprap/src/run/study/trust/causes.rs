//! What is varied, and the keys that it has in a scene.

use serde::{Deserialize, Serialize};
use toml::Value;

use super::{Question, Rules};
use crate::plan::{Phase, PhaseKind, Plan, TimeStep};
use crate::run::job::Job;
use crate::run::scene::Prepared;
use crate::scenario::units;
use crate::setup::Setup;
use crate::spatial::setup::deform::BondSprings;
use crate::spatial::setup::{Shape, Stiffness};

/// A cause of error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Cause {
    /// Length of the time step, number of load steps.
    Step,
    /// Limits at which static phases end.
    Equilibrium,
    /// Stiffness of contacts and joints.
    Stiffness,
    /// Dashpots, and damping of phases.
    Damping,
    /// Size of generated cells.
    Size,
    /// Seeds of generated blocks.
    Seed,
    /// Width of the range that a search leaves.
    Search,
}

impl Cause {
    /// All of them, in the order of tables.
    pub const ALL: [Cause; 7] = [
        Self::Step,
        Self::Equilibrium,
        Self::Stiffness,
        Self::Damping,
        Self::Size,
        Self::Seed,
        Self::Search,
    ];

    /// As it is written.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Equilibrium => "equilibrium",
            Self::Stiffness => "stiffness",
            Self::Damping => "damping",
            Self::Size => "size",
            Self::Seed => "seed",
            Self::Search => "search",
        }
    }

    /// Reads a word.
    ///
    /// # Errors
    /// A text for the user.
    pub fn read(text: &str) -> Result<Self, String> {
        let known = Self::ALL.map(Self::word).join(", ");
        let of = Self::ALL.into_iter().find(|cause| cause.word() == text);
        of.ok_or_else(|| format!("{text:?} is no cause of error; valid names: {known}"))
    }
}

/// A step that is this much shorter shows what is chaotic.
pub(super) const JITTER: f64 = 0.999;
/// Realisations of random blocks besides the one of the scene.
const SEEDS: u64 = 5;

/// One variant of the scene.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    /// What it changes.
    pub cause: Option<Cause>,
    /// By what it multiplies it; of a seed the number of the realisation.
    pub factor: f64,
    /// Its run time over that of the scene, about.
    pub cost: f64,
    /// Keys that it sets.
    pub keys: Vec<(String, String)>,
}

impl Variant {
    /// The scene as it stands.
    pub(super) const NONE: Variant =
        Variant { cause: None, factor: 1.0, cost: 1.0, keys: Vec::new() };

    fn new(cause: Cause, factor: f64, cost: f64) -> Self {
        Self { cause: Some(cause), factor, cost, keys: Vec::new() }
    }

    /// Changes what has no key that could be set for all of the model at once.
    pub(super) fn apply(&self, job: &mut Job) {
        match self.cause {
            Some(Cause::Step) => {
                shorten(&mut job.plan, self.factor);
            }
            Some(Cause::Equilibrium) => {
                tighten(&mut job.plan, self.factor);
            }
            Some(Cause::Stiffness) => {
                stiffen(job, self.factor);
            }
            Some(Cause::Damping) => {
                damp(job, self.factor);
            }
            Some(Cause::Size | Cause::Seed | Cause::Search) | None => {}
        }
    }
}

/// The variants of a scene, the most useful ones first, and the causes that it has not.
pub(super) fn variants(
    prepared: &Prepared,
    question: Question<'_>,
    rules: &Rules,
) -> (Vec<Variant>, Vec<(Cause, String)>) {
    let mut all = vec![
        Variant::new(Cause::Step, 0.5, 2.0),
        Variant::new(Cause::Stiffness, 2.0, 1.5),
        Variant::new(Cause::Damping, 0.5, 1.0),
        Variant::new(Cause::Equilibrium, 0.25, 1.5),
        Variant::new(Cause::Step, JITTER, 1.0),
        Variant::new(Cause::Step, 0.25, 4.0),
        Variant::new(Cause::Stiffness, 4.0, 2.0),
    ];
    let text: Value =
        toml::from_str(&prepared.resolved).unwrap_or_else(|_| Value::Table(toml::Table::new()));
    let cells = Cells::of(&text);
    let mut left_out = Vec::new();
    // The width of a search is known without further runs.
    for cause in Cause::ALL.into_iter().filter(|cause| *cause != Cause::Search) {
        let mut job = prepared.clone().job();
        let why = match cause {
            _ if rules.without.contains(&cause) => Some("it was left out".to_owned()),
            // Each trial would be made again.
            Cause::Step if question.is_of_rest() && !has_steps(&job.plan) => Some(
                "trials seek equilibrium, and all phases are static: no time step counts"
                    .to_owned(),
            ),
            Cause::Step if shorten(&mut job.plan, 0.5) == 0 => {
                Some("no phase has steps".to_owned())
            }
            Cause::Equilibrium if tighten(&mut job.plan, 0.5) == 0 => {
                Some("no phase ends in equilibrium".to_owned())
            }
            Cause::Stiffness if stiffen(&mut job, 2.0) == 0 => Some(
                "no interface has a stiffness of its own: it comes from the materials".to_owned(),
            ),
            Cause::Damping if damp(&mut job, 0.5) == 0 => Some("nothing is damped".to_owned()),
            Cause::Size => cells.reason(&cells.sizes, "no cells of a size are generated"),
            Cause::Seed => cells.reason(&cells.seeds, "no blocks are generated at random"),
            Cause::Step
            | Cause::Equilibrium
            | Cause::Stiffness
            | Cause::Damping
            | Cause::Search => None,
        };
        match why {
            Some(why) => {
                all.retain(|one| one.cause != Some(cause));
                left_out.push((cause, why));
            }
            None if cause == Cause::Size => {
                // In space a half makes eight times as many, each with half the step.
                let fine = if matches!(job.setup, Setup::Planar(_)) { 8.0 } else { 16.0 };
                all.extend([(2.0, 0.5), (0.5, fine)].map(|(factor, cost)| Variant {
                    keys: cells.sized(factor),
                    ..Variant::new(cause, factor, cost)
                }));
            }
            None if cause == Cause::Seed => {
                all.extend((1..=SEEDS).map(|k| Variant {
                    keys: cells.seeded(k),
                    ..Variant::new(cause, k as f64, 1.0)
                }));
            }
            None => {}
        }
    }
    (all, left_out)
}

/// More runs whose step is a little shorter: samples of what is chaotic.
pub(super) fn samples() -> Vec<Variant> {
    (2..8).map(|k| Variant::new(Cause::Step, libm::pow(JITTER, f64::from(k)), 1.0)).collect()
}

/// Whether a phase goes on in time, or applies its loads step by step.
fn has_steps(plan: &Plan) -> bool {
    let loads = |phase: &Phase| phase.deform.is_some_and(|deform| deform.relax.is_some());
    plan.phases.iter().any(|phase| phase.kind != PhaseKind::Static || loads(phase))
}

/// Shortens the steps of all phases. Returns how many numbers changed, as the others here do.
pub(super) fn shorten(plan: &mut Plan, factor: f64) -> usize {
    let more = |count: u64| (count as f64 / factor).round().max(1.0) as u64;
    for phase in &mut plan.phases {
        match &mut phase.time_step {
            TimeStep::Auto { safety } => *safety *= factor,
            TimeStep::Given { dt } => *dt *= factor,
        }
        phase.until.steps = phase.until.steps.map(more);
        if let Some(relax) = phase.deform.as_mut().and_then(|deform| deform.relax.as_mut()) {
            relax.load_steps = more(relax.load_steps);
        }
    }
    plan.phases.len()
}

fn tighten(plan: &mut Plan, factor: f64) -> usize {
    let mut count = 0;
    for phase in &mut plan.phases {
        let until = &mut phase.until;
        let limits = [until.unbalanced.as_mut(), until.kinetic.as_mut()];
        let rest = until.rest.as_mut().map(|rest| &mut rest.share);
        let relax = phase.deform.as_mut().and_then(|deform| deform.relax.as_mut());
        let relax = relax.map(|relax| &mut relax.tolerance);
        for limit in limits.into_iter().chain([rest, relax]).flatten() {
            *limit *= factor;
            count += 1;
        }
    }
    count
}

/// Multiplies numbers that are not zero.
fn scaled<'a>(numbers: impl IntoIterator<Item = &'a mut f64>, factor: f64) -> usize {
    let mut count = 0;
    for number in numbers.into_iter().filter(|number| **number != 0.0) {
        *number *= factor;
        count += 1;
    }
    count
}

fn stiffen(job: &mut Job, factor: f64) -> usize {
    let mut count = 0;
    match &mut job.setup {
        Setup::Planar(setup) => {
            for one in &mut setup.interfaces {
                let law = &mut one.contact;
                count += scaled([&mut law.normal_stiffness, &mut law.shear_stiffness], factor);
                if let Some(law) = &mut one.bond {
                    count += scaled([&mut law.normal_stiffness, &mut law.shear_stiffness], factor);
                }
            }
        }
        Setup::Spatial(setup) => {
            for one in &mut setup.interfaces {
                if let Stiffness::Given { normal, shear } = &mut one.joint.stiffness {
                    count += scaled([normal, shear], factor);
                }
                match one.bond.as_mut().map(|bond| &mut bond.springs) {
                    Some(BondSprings::Given(springs)) => count += scaled(springs, factor),
                    Some(BondSprings::Thickness { thickness, .. }) => {
                        count += scaled([thickness], 1.0 / factor);
                    }
                    None => {}
                }
            }
        }
    }
    for phase in &mut job.plan.phases {
        for (_, law) in &mut phase.contacts {
            scaled([&mut law.normal_stiffness, &mut law.shear_stiffness], factor);
        }
        for (_, law) in &mut phase.joints {
            if let Stiffness::Given { normal, shear } = &mut law.stiffness {
                scaled([normal, shear], factor);
            }
        }
    }
    count
}

fn damp(job: &mut Job, factor: f64) -> usize {
    let mut count = 0;
    match &mut job.setup {
        Setup::Planar(setup) => {
            for one in &mut setup.interfaces {
                count += scaled([&mut one.contact.damping_ratio], factor);
                count += scaled(one.bond.iter_mut().map(|law| &mut law.damping_ratio), factor);
            }
        }
        Setup::Spatial(setup) => {
            for one in &mut setup.interfaces {
                let law = &mut one.joint;
                count += scaled([&mut law.damping, &mut law.contact_damping], factor);
            }
        }
    }
    for phase in &mut job.plan.phases {
        scaled(phase.contacts.iter_mut().map(|(_, law)| &mut law.damping_ratio), factor);
        for (_, law) in &mut phase.joints {
            scaled([&mut law.damping, &mut law.contact_damping], factor);
        }
        let damping = &mut phase.damping;
        let all = [&mut damping.mass, &mut damping.stiffness, &mut damping.local];
        count += scaled(all, factor);
        count += scaled(damping.rotation.iter_mut(), factor);
    }
    count
}

/// Generators of blocks, the key of their size, and whether they are random unless a lattice or joints one by one are given.
const GENERATORS: [(&str, &str, bool); 5] = [
    ("voronoi", "cell_size", true),
    ("grid.cells", "cell", true),
    ("grid.box", "cell", false),
    ("cut", "", true),
    ("pour", "", true),
];

/// Keys of generators of blocks.
struct Cells {
    /// Keys of sizes, with their values as they are written.
    sizes: Vec<(String, Value)>,
    /// Keys of seeds, with the seeds.
    seeds: Vec<(String, u64)>,
    /// A block that the scene names by its number.
    numbered: Option<String>,
}

impl Cells {
    fn of(text: &Value) -> Self {
        let mut cells = Cells { sizes: Vec::new(), seeds: Vec::new(), numbered: None };
        let blocks = text.get("blocks").and_then(Value::as_array);
        for (k, entry) in blocks.into_iter().flatten().enumerate() {
            let name = entry.get("name").and_then(Value::as_str).unwrap_or_default();
            let known = (cells.sizes.len(), cells.seeds.len());
            for (generator, size, random) in GENERATORS {
                let table = generator.split('.').try_fold(entry, |table, word| table.get(word));
                let Some(table) = table else {
                    continue;
                };
                let key = |word: &str| format!("blocks.{k}.{generator}.{word}");
                if let Some(value) = table.get(size) {
                    cells.sizes.push((key(size), value.clone()));
                }
                let lattice = ["turned", "site"].iter().any(|word| table.get(word).is_some());
                let drawn = generator == "cut" && table.get("joint_sets").is_none();
                if random && !lattice && !drawn {
                    let seed = table.get("seed").and_then(Value::as_integer).unwrap_or(1);
                    cells.seeds.push((key("seed"), seed.unsigned_abs()));
                }
            }
            if known != (cells.sizes.len(), cells.seeds.len()) {
                cells.numbered = cells.numbered.take().or_else(|| numbered(text, name));
            }
        }
        cells
    }

    /// Why they cannot be varied, if they cannot.
    fn reason<T>(&self, keys: &[T], none: &str) -> Option<String> {
        let numbered = |name: &String| format!("the scene names block `{name}` by its number");
        if keys.is_empty() { Some(none.to_owned()) } else { self.numbered.as_ref().map(numbered) }
    }

    fn sized(&self, factor: f64) -> Vec<(String, String)> {
        let of =
            |(key, value): &(String, Value)| Some((key.clone(), times(value, factor)?.to_string()));
        self.sizes.iter().filter_map(of).collect()
    }

    fn seeded(&self, by: u64) -> Vec<(String, String)> {
        self.seeds.iter().map(|(key, seed)| (key.clone(), (seed + by).to_string())).collect()
    }
}

/// A name such as `wall.17` of a block of a generator, in any text of the scene.
fn numbered(value: &Value, generator: &str) -> Option<String> {
    match value {
        Value::String(text) => {
            let number = text.strip_prefix(generator)?.strip_prefix('.')?;
            let is = !generator.is_empty() && number.parse::<u64>().is_ok();
            is.then(|| text.clone())
        }
        Value::Array(items) => items.iter().find_map(|item| numbered(item, generator)),
        Value::Table(table) => table.values().find_map(|item| numbered(item, generator)),
        Value::Integer(_) | Value::Float(_) | Value::Boolean(_) | Value::Datetime(_) => None,
    }
}

/// A quantity, or several, multiplied.
fn times(value: &Value, factor: f64) -> Option<Value> {
    match value {
        Value::String(text) => {
            let (unit, one) = units::unit_of(text)?;
            let (number, _) = units::parse(text).ok()?;
            Some(Value::String(format!("{} {unit}", factor * number / one)))
        }
        Value::Array(items) => {
            let all: Option<Vec<Value>> = items.iter().map(|item| times(item, factor)).collect();
            all.map(Value::Array)
        }
        Value::Float(number) => Some(Value::Float(factor * number)),
        Value::Integer(_) | Value::Boolean(_) | Value::Datetime(_) | Value::Table(_) => None,
    }
}

/// The keys by which a user changes a cause, with their values now.
pub(super) struct Keys(Vec<(Cause, String, Now)>);

/// A value as it is shown, and whether a smaller one is the better.
enum Now {
    Less(f64, &'static str),
    More(f64, &'static str),
    Text(Value),
}

impl Keys {
    pub(super) fn of(prepared: &Prepared) -> Self {
        let (setup, plan) = (&prepared.model.setup, &prepared.model.plan);
        let mut keys = Vec::new();
        let of_phase = |phase: &Phase, key: &str| format!("phases.{}.{key}", word(&phase.name));
        let moving = plan.phases.iter().find(|phase| phase.kind == PhaseKind::Dynamic);
        if let Some(phase) = moving.or(plan.phases.first()) {
            keys.push(match phase.time_step {
                TimeStep::Auto { safety } => {
                    (Cause::Step, of_phase(phase, "safety"), Now::Less(safety, ""))
                }
                TimeStep::Given { dt } => {
                    (Cause::Step, of_phase(phase, "time_step"), Now::Less(dt, "s"))
                }
            });
        }
        for phase in plan.phases.iter().rev() {
            let until = &phase.until;
            let limits = [
                ("until.unbalanced", until.unbalanced, ""),
                ("until.kinetic", until.kinetic, "J"),
                ("until.rest.share", until.rest.map(|rest| rest.share), ""),
            ];
            for (key, value, unit) in limits {
                if let Some(value) = value {
                    keys.push((Cause::Equilibrium, of_phase(phase, key), Now::Less(value, unit)));
                }
            }
        }
        keys.extend(of_interfaces(setup));
        for phase in &plan.phases {
            let damping = &phase.damping;
            let all = [
                ("mass", damping.mass, "1/s"),
                ("stiffness", damping.stiffness, "s"),
                ("local", damping.local, ""),
            ];
            for (key, value, unit) in all.into_iter().filter(|(_, value, _)| *value > 0.0) {
                let key = of_phase(phase, &format!("damping.{key}"));
                keys.push((Cause::Damping, key, Now::Less(value, unit)));
            }
        }
        if let Ok(text) = toml::from_str::<Value>(&prepared.resolved) {
            let cells = Cells::of(&text);
            keys.extend(
                cells.sizes.into_iter().map(|(key, now)| (Cause::Size, key, Now::Text(now))),
            );
        }
        Self(keys)
    }

    /// `phases.slide.time_step: 10 us -> 5 us`: the first key of a cause, and what halves its error where that goes with the power
    /// `order` of it.
    pub(super) fn halving(&self, cause: Cause, order: f64) -> Option<String> {
        let (_, key, now) = self.0.iter().find(|(of, _, _)| *of == cause)?;
        let factor = libm::pow(0.5, 1.0 / order);
        let shown =
            |value: f64, unit: &str| crate::plan::shown::Shown::suited(unit, value).text(value, 2);
        let (now, then) = match now {
            Now::Less(value, unit) => (shown(*value, unit), shown(value * factor, unit)),
            Now::More(value, unit) => (shown(*value, unit), shown(value / factor, unit)),
            Now::Text(value) => (value.to_string(), times(value, factor)?.to_string()),
        };
        Some(format!("{key}: {now} -> {then}"))
    }
}

/// The largest coordinate of a centroid or a corner, m: places have round-off of this size.
pub(super) fn reach(setup: &Setup) -> f64 {
    let largest = |all: f64, v: f64| all.max(v.abs());
    match setup {
        Setup::Planar(setup) => {
            let corners = setup.blocks.iter().flat_map(|block| &block.vertices);
            corners.flat_map(|v| [v.x, v.y]).fold(0.0, largest)
        }
        Setup::Spatial(setup) => {
            let of = |shape: &Shape| match shape {
                Shape::Brick { centre, half } => (centre.abs() + half.abs()).max_element(),
                Shape::Polyhedron(solid) => of_corners(&solid.vertices),
                Shape::Terrain(surface) => of_corners(&surface.points),
                Shape::Glued(parts) => {
                    parts.iter().map(|part| of_corners(&part.vertices)).fold(0.0, f64::max)
                }
            };
            setup.blocks.iter().map(|block| of(&block.shape)).fold(0.0, f64::max)
        }
    }
}

fn of_corners(corners: &[crate::Vec3]) -> f64 {
    corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max)
}

/// Keys of stiffness and of dashpots.
fn of_interfaces(setup: &Setup) -> Vec<(Cause, String, Now)> {
    let key = |name: &str, last: &str| format!("interfaces.{}.{last}", word(name));
    let (stiff, damped) = ("normal_stiffness", "damping_ratio");
    let numbers: Vec<(&str, Option<f64>, f64)> = match setup {
        Setup::Planar(setup) => {
            let of = |one: &crate::planar::setup::Interface| one.contact;
            setup
                .interfaces
                .iter()
                .map(|one| (&one.name[..], Some(of(one).normal_stiffness), of(one).damping_ratio))
                .collect()
        }
        Setup::Spatial(setup) => {
            let given = |stiffness: Stiffness| match stiffness {
                Stiffness::Given { normal, .. } => Some(normal),
                Stiffness::Rule(_) => None,
            };
            setup
                .interfaces
                .iter()
                .map(|one| (&one.name[..], given(one.joint.stiffness), one.joint.contact_damping))
                .collect()
        }
    };
    let mut keys = Vec::new();
    for (name, stiffness, damping) in numbers {
        if let Some(value) = stiffness {
            keys.push((Cause::Stiffness, key(name, stiff), Now::More(value, "Pa/m")));
        }
        if damping > 0.0 {
            keys.push((Cause::Damping, key(name, damped), Now::Less(damping, "")));
        }
    }
    keys
}

/// A word of a key, in quotes where it has dots.
fn word(name: &str) -> String {
    if name.contains('.') { format!("\"{name}\"") } else { name.to_owned() }
}
