//! Keys of a phase as a change in the midst of a run.
//!
//! The keys are put into the text of the scene as a phase of their own behind the present one, and the model is built: so names, units, laws and
//! messages are those of a scene, and phases to come keep what they change beside what the change has changed. Only what that phase
//! edits, and the rules that may change, are taken from it.

mod bolt;

use std::path::PathBuf;

use riprap_core::condition::Condition;
use toml::de::DeTable;
use toml::{Table, Value};

use super::engine::Kind;
use super::job::Job;
use super::scene::build;
use super::simulation::{Change, ChangeError, Simulation};
use crate::model::Model;
use crate::plan::Phase;
use crate::record::field::nearest;
use crate::scenario::{self, Diagnostics, Parsed, Source};
use crate::setup::Setup;
use crate::spatial::setup::Material;

/// Keys that edit.
const EDITS: [&str; 9] = [
    "remove",
    "removal_ramp",
    "fix",
    "release",
    "gravity",
    "water",
    "reset",
    "interfaces",
    "install",
];

/// Keys of rules that hold from then on.
const RULES: [&str; 5] = ["until", "time_step", "safety", "damping", "max_residual"];

/// Keys that list blocks.
const LISTS: [&str; 3] = ["remove", "fix", "release"];

/// Keys of a material that can change; the moduli in space.
const OF_MATERIALS: [&str; 3] = ["density", "young", "poisson"];

/// Why materials of the plane do not change.
const IN_PLANE: &str = "in the plane its moduli only set the stiffness of interfaces that give none; change `interfaces.NAME.normal_stiffness`";

/// Name of the phase that stands for a change in the text.
const NAME: &str = "change by code";

/// The scene of a run, with the changes that were made so far.
#[derive(Clone, Debug)]
pub(super) struct SceneText {
    text: String,
    name: String,
    folder: PathBuf,
    variant: String,
    /// Number of changes; each stands behind the phase in which it was made.
    count: usize,
    /// Names of blocks that were added, which the text does not know.
    added: Vec<String>,
}

impl SceneText {
    /// That of a job.
    pub(super) fn of(job: &Job) -> Self {
        Self {
            text: job.resolved.clone(),
            name: job.manifest.scenario.clone(),
            folder: job.folder.clone(),
            variant: job.manifest.variant.clone(),
            count: 0,
            added: Vec::new(),
        }
    }

    /// Notes a block that the text does not know.
    pub(super) fn added(&mut self, name: &str) {
        self.added.push(name.to_owned());
    }

    /// A change in numbers, and the text with it.
    pub(super) fn read(
        &self,
        keys: &Table,
        simulation: &Simulation,
    ) -> Result<(Change, Self), ChangeError> {
        allowed(keys)?;
        names_are_there(keys, simulation)?;
        let install = bolts(keys, simulation)?;
        let now = simulation.cursor().phase;
        let present = simulation.plan().phases.get(now).ok_or(ChangeError::Ended)?;
        // Each change before stands behind a phase before this place.
        let at = now + self.count + 1;
        let text = self.with(keys, at, &present.name)?;
        let (parsed, model) = self.built(&text)?;
        without_effect(&parsed, &model.warnings, self.count + 1)?;
        let mut phases = model.plan.phases.into_iter().skip(at);
        let said = phases.next().ok_or(ChangeError::NoScene)?;
        let mut later: Vec<Phase> = phases.collect();
        for phase in &mut later {
            phase.install.retain(|bolt| !install.contains(bolt));
        }
        let rules = rules(keys, present, &said, simulation);
        let ramp = if said.gravity.is_some() { None } else { rules.gravity_ramp };
        let edits = Phase {
            name: NAME.to_owned(),
            remove: listed("remove", keys, &said.remove, simulation),
            fix: listed("fix", keys, &said.fix, simulation),
            release: listed("release", keys, &said.release, simulation),
            install,
            gravity_ramp: ramp,
            ..said
        };
        let edits = Phase {
            kind: rules.kind,
            integration: rules.integration,
            damping: rules.damping,
            time_step: rules.time_step,
            deform: rules.deform,
            reduction: None,
            ..edits
        };
        let change = Change { edits, rules, later };
        Ok((change, Self { text, count: self.count + 1, ..self.clone() }))
    }

    /// A material with another density or other moduli: its number, and the text with it.
    pub(super) fn read_material(
        &self,
        name: &str,
        keys: &Table,
        simulation: &Simulation,
    ) -> Result<(u16, Material, Self), ChangeError> {
        let wrong =
            |why: &str| ChangeError::Material { name: name.to_owned(), why: why.to_owned() };
        if simulation.phase().is_none() {
            return Err(ChangeError::Ended);
        }
        if let Some(key) = keys.keys().find(|key| !OF_MATERIALS.contains(&key.as_str())) {
            let key = format!("materials.{name}.{key}");
            return Err(ChangeError::Forbidden { key, known: OF_MATERIALS.join(", ") });
        }
        if keys.is_empty() {
            return Err(wrong("no key is given; valid keys: density, young, poisson"));
        }
        let in_plane = simulation.kind() != Kind::Spatial;
        if in_plane && keys.keys().any(|key| key != "density") {
            return Err(wrong(IN_PLANE));
        }
        let mut root = self.root()?;
        let there = root.get_mut("materials").and_then(Value::as_table_mut);
        let there = there.ok_or(ChangeError::NoScene)?;
        let Some(material) = there.get_mut(name).and_then(Value::as_table_mut) else {
            let near = nearest(name, there.keys().map(String::as_str))
                .map(|near| format!("; did you mean {near:?}?"));
            return Err(wrong(&format!("there is none of this name{}", near.unwrap_or_default())));
        };
        material.extend(keys.clone());
        let text = self.written(root);
        let (_, model) = self.built(&text)?;
        let materials: Vec<Material> = match model.setup {
            Setup::Spatial(setup) => setup.materials,
            Setup::Planar(setup) => {
                let one = |(name, density)| Material { name, density, young: None, poisson: None };
                setup.materials.into_iter().zip(setup.densities).map(one).collect()
            }
        };
        let mut numbered = (0..).zip(materials);
        let found = numbered.find(|(_, material)| material.name == name);
        let (row, material) = found.ok_or_else(|| wrong("no block is made of it"))?;
        Ok((row, material, Self { text, ..self.clone() }))
    }

    /// The text of a table, in which named tables keep their order: interfaces, materials and water tables are numbered by it.
    fn written(&self, mut root: Table) -> String {
        let Ok(before) = DeTable::parse(&self.text) else { return root.to_string() };
        let named: Vec<String> = root.keys().cloned().collect();
        let mut behind = String::new();
        for key in named {
            let Some((_, of)) = before.get_ref().iter().find(|(one, _)| *one.get_ref() == key)
            else {
                continue;
            };
            let is_named = |value: &Value| {
                value.as_table().is_some_and(|all| all.values().all(Value::is_table))
            };
            let Some(order) = of.get_ref().as_table() else { continue };
            if !root.get(&key).is_some_and(is_named) {
                continue;
            }
            let Some(Value::Table(all)) = root.remove(&key) else { continue };
            let place = |name: &str| {
                let found = order.iter().find(|(one, _)| *one.get_ref() == name);
                found.map_or(usize::MAX, |(one, _)| one.span().start)
            };
            let mut all: Vec<(String, Value)> = all.into_iter().collect();
            all.sort_by_key(|(name, _)| place(name));
            for one in all {
                let table =
                    Table::from_iter([(key.clone(), Value::Table(Table::from_iter([one])))]);
                behind.push_str(&format!("\n{table}"));
            }
        }
        format!("{root}{behind}")
    }

    /// The model of a text.
    fn built(&self, text: &str) -> Result<(Parsed, Model), ChangeError> {
        let source = Source::new(format!("{} (with a change)", self.name), text.to_owned());
        let mut parsed = scenario::parse_with(source, Vec::new()).map_err(ChangeError::Keys)?;
        parsed.folder.clone_from(&self.folder);
        parsed.has_moved = true;
        let model = build(&parsed, &self.variant).map_err(ChangeError::Keys)?;
        Ok((parsed, model))
    }

    fn root(&self) -> Result<Table, ChangeError> {
        toml::from_str(&self.text).map_err(|error: toml::de::Error| {
            let found = scenario::Diagnostic::error("toml", error.message().to_owned());
            ChangeError::Keys(Diagnostics::new(Source::new(&self.name[..], ""), vec![found]))
        })
    }

    /// The text with the keys as phase number `at`, in the phase `present`.
    fn with(&self, keys: &Table, at: usize, present: &str) -> Result<String, ChangeError> {
        let mut root = self.root()?;
        let phases = root.get_mut("phases").and_then(Value::as_array_mut);
        let phases = phases.ok_or(ChangeError::NoScene)?;
        let mut phase = keys.clone();
        phase.remove("install");
        for list in LISTS {
            if let Some(names) = phase.get_mut(list).and_then(Value::as_array_mut) {
                let is_added = |name: &Value| {
                    name.as_str().is_some_and(|name| self.added.iter().any(|one| one == name))
                };
                names.retain(|name| !is_added(name));
                if names.is_empty() {
                    phase.remove(list);
                }
            }
        }
        phase.insert("name".to_owned(), format!("{NAME} {}", self.count + 1).into());
        if !phase.contains_key("until") {
            phase.insert(
                "until".to_owned(),
                Table::from_iter([("steps".to_owned(), 1.into())]).into(),
            );
        }
        // A change keeps the integration, whose keys it may have.
        let is_present =
            |phase: &&Value| phase.get("name").and_then(Value::as_str) == Some(present);
        if let Some(present) = phases.iter().find(is_present) {
            for key in ["kind", "integration"] {
                if let Some(value) = present.get(key) {
                    phase.insert(key.to_owned(), value.clone());
                }
            }
        }
        phases.insert(at.min(phases.len()), Value::Table(phase));
        Ok(self.written(root))
    }
}

/// Reads the keys of a change.
pub(super) fn parse(text: &str) -> Result<Table, ChangeError> {
    toml::from_str(text).map_err(|error| {
        let found = scenario::Diagnostic::error("toml", error.message().to_owned());
        let found = error.span().map_or(found.clone(), |span| found.at(span));
        ChangeError::Keys(Diagnostics::new(Source::new("the change", text), vec![found]))
    })
}

/// Keys of a change that have no effect are wrong: nobody would see the warning.
fn without_effect(
    parsed: &scenario::Parsed,
    warnings: &[scenario::Diagnostic],
    count: usize,
) -> Result<(), ChangeError> {
    let text = &parsed.source.text;
    let name = format!("name = \"{NAME} {count}\"");
    let Some(at) = text.find(&name) else {
        return Ok(());
    };
    let begin = text[..at].rfind("[[phases]]").unwrap_or(0);
    let end = text[at..].find("\n[[").map_or(text.len(), |more| at + more);
    let idle = |one: &&scenario::Diagnostic| {
        one.code == "key.unused"
            && one.span.as_ref().is_some_and(|span| begin <= span.start && span.end <= end)
    };
    let found: Vec<_> = warnings.iter().filter(idle).cloned().collect();
    if found.is_empty() {
        return Ok(());
    }
    Err(ChangeError::Keys(Diagnostics::new(parsed.source.clone(), found)))
}

/// Whether all keys can change.
fn allowed(keys: &Table) -> Result<(), ChangeError> {
    let known = || EDITS.iter().chain(&RULES);
    match keys.keys().find(|key| !known().any(|one| one == key)) {
        None => Ok(()),
        Some(key) => Err(ChangeError::Forbidden {
            key: key.clone(),
            known: known().copied().collect::<Vec<_>>().join(", "),
        }),
    }
}

/// Whether each block and group is there and has not been removed.
fn names_are_there(keys: &Table, simulation: &Simulation) -> Result<(), ChangeError> {
    for list in LISTS {
        let names = keys.get(list).and_then(Value::as_array);
        for (k, name) in names.into_iter().flatten().enumerate() {
            let Some(name) = name.as_str() else { continue };
            match simulation.blocks_of(&format!("{list}.{k}"), name) {
                // A condition may name materials, which the scene knows.
                Err(ChangeError::Unknown { .. }) if Condition::is_meant(name) => {}
                other => drop(other?),
            }
        }
    }
    Ok(())
}

/// Numbers of the bolts to be installed: those of a name, or of the pattern of that name.
fn bolts(keys: &Table, simulation: &Simulation) -> Result<Vec<u32>, ChangeError> {
    let there = simulation.engine().installed();
    let known = simulation.view().bolts();
    let mut all = Vec::new();
    let names = keys.get("install").and_then(Value::as_array);
    for (k, name) in names.into_iter().flatten().enumerate() {
        let name = name.as_str().unwrap_or_default();
        let key = format!("install.{k}");
        let of = |bolt: &str| {
            bolt == name || bolt.strip_prefix(name).is_some_and(|s| s.starts_with('.'))
        };
        let found: Vec<u32> =
            (0..).zip(&known).filter(|(_, bolt)| of(bolt)).map(|(n, _)| n).collect();
        let why = match found.iter().find(|bolt| there.contains(bolt) || all.contains(*bolt)) {
            _ if found.is_empty() => format!("there is no bolt {name:?} in the scene"),
            Some(bolt) => format!("bolt {:?} is installed already", known[*bolt as usize]),
            None => {
                all.extend(found);
                continue;
            }
        };
        return Err(ChangeError::Bolt { key, why });
    }
    all.sort_unstable();
    Ok(all)
}

/// Blocks of a list of names that have not been removed: those that the scene means by them, and those that were added.
fn listed(list: &str, keys: &Table, said: &[u32], simulation: &Simulation) -> Vec<u32> {
    let names = keys.get(list).and_then(Value::as_array).into_iter().flatten();
    let now = names.filter_map(Value::as_str).filter_map(|n| simulation.blocks_of(list, n).ok());
    let mut all: Vec<u32> = said.iter().copied().chain(now.flatten()).collect();
    all.retain(|b| simulation.engine().is_alive(*b));
    all.sort_unstable();
    all.dedup();
    all
}

/// The present phase with what the keys say of its rules.
fn rules(keys: &Table, present: &Phase, said: &Phase, simulation: &Simulation) -> Phase {
    let has = |key: &str| keys.contains_key(key);
    let mut rules = present.clone();
    if has("until") {
        rules.until = said.until;
    }
    if has("time_step") || has("safety") {
        rules.time_step = said.time_step;
    }
    if has("damping") {
        rules.damping = said.damping;
    }
    if has("max_residual") {
        rules.max_residual = said.max_residual;
    }
    if has("gravity") {
        // The ramp of the phase would go on to another end.
        rules.gravity_ramp = None;
    }
    if let Some(span) = said.removal_ramp {
        let elapsed = simulation.time() - simulation.cursor().start_time;
        rules.removal_ramp = Some(elapsed + span);
    }
    rules
}

#[cfg(test)]
mod tests;
