//! A bolt that the scene does not have, installed in the midst of a run.
//!
//! Its keys are put into the text of the scene as a table of `[[bolts]]` that the phase of a change installs: so units, defaults and messages are those of a
//! scene, and its number is the next one.

use toml::{Table, Value};

use super::{NAME, SceneText};
use crate::plan::Phase;
use crate::record::field::nearest;
use crate::run::engine::NewBolt;
use crate::run::simulation::{Change, ChangeError, Simulation};
use crate::setup::Setup;

/// Keys of a bolt that code installs.
const KEYS: [&str; 11] = [
    "name",
    "like",
    "head",
    "toe",
    "spacing",
    "steel",
    "grout",
    "plate",
    "pretension",
    "dowel",
    "piece",
];

/// Keys that say where and when a bolt of the scene is, which one that is like it does not take over.
const OF_PLACE: [&str; 8] = ["name", "head", "toe", "repeat", "csv", "pattern", "phase", "where"];

/// A bolt by code.
pub(in crate::run) struct Installed {
    pub(in crate::run) name: String,
    pub(in crate::run) bolt: NewBolt,
    pub(in crate::run) change: Change,
    pub(in crate::run) scene: SceneText,
}

impl SceneText {
    /// A bolt in numbers, the change that installs it, and the text with both.
    pub(in crate::run) fn read_bolt(
        &self,
        keys: &Table,
        simulation: &Simulation,
    ) -> Result<Installed, ChangeError> {
        if let Some(key) = keys.keys().find(|key| !KEYS.contains(&key.as_str())) {
            let known = KEYS.join(", ");
            return Err(ChangeError::Forbidden { key: format!("bolts.{key}"), known });
        }
        let now = simulation.cursor().phase;
        let present = simulation.plan().phases.get(now).ok_or(ChangeError::Ended)?;
        let known = simulation.view().bolts();
        let name = named(keys, &known)?;
        let phase = format!("{NAME} {}", self.count + 1);
        let mut root = self.root()?;
        let table = self.table(keys, &root, (&name, &phase))?;
        let bolts = root.entry("bolts").or_insert_with(|| Value::Array(Vec::new()));
        bolts.as_array_mut().ok_or(ChangeError::NoScene)?.push(Value::Table(table));
        let at = now + self.count + 1;
        let with_bolt = Self { text: self.written(root), ..self.clone() };
        let text = with_bolt.with(&Table::new(), at, &present.name)?;
        let (_, model) = self.built(&text)?;
        let wrong = || bolt(&name, "its number is not the next one".to_owned());
        let all: Vec<NewBolt> = match model.setup {
            Setup::Planar(setup) => setup.bolts.into_iter().map(NewBolt::Planar).collect(),
            Setup::Spatial(setup) => setup.bolts.into_iter().map(NewBolt::Spatial).collect(),
        };
        let number = known.len();
        let new = all.into_iter().enumerate().find(|(k, _)| *k == number).ok_or_else(wrong)?.1;
        let mut phases = model.plan.phases.into_iter().skip(at);
        let said = phases.next().ok_or(ChangeError::NoScene)?;
        let later: Vec<Phase> = phases.collect();
        let edits = Phase {
            name: NAME.to_owned(),
            install: vec![number as u32],
            gravity_ramp: present.gravity_ramp,
            kind: present.kind,
            integration: present.integration,
            damping: present.damping,
            time_step: present.time_step,
            deform: present.deform,
            reduction: None,
            ..said
        };
        let change = Change { edits, rules: present.clone(), later };
        let scene = Self { text, count: self.count + 1, ..self.clone() };
        Ok(Installed { name, bolt: new, change, scene })
    }

    /// The table of the bolt: what is said, on what that of another bolt says of steel and grout.
    fn table(
        &self,
        keys: &Table,
        root: &Table,
        (name, phase): (&str, &str),
    ) -> Result<Table, ChangeError> {
        let mut table = match keys.get("like").map(|like| like.as_str().unwrap_or_default()) {
            Some(like) => {
                let there = root.get("bolts").and_then(Value::as_array);
                let tables: Vec<&Table> =
                    there.into_iter().flatten().filter_map(Value::as_table).collect();
                fn of<'t>(table: &&'t Table) -> Option<&'t str> {
                    table.get("name").and_then(Value::as_str)
                }
                let is = |wanted: &str| tables.iter().find(|table| of(table) == Some(wanted));
                let many = like.rsplit_once('.').and_then(|(many, _)| is(many));
                let Some(found) = is(like).or(many) else {
                    let names = tables.iter().filter_map(of);
                    let near = nearest(like, names)
                        .map_or_else(String::new, |near| format!("; did you mean {near:?}?"));
                    return Err(bolt(name, format!("there is no bolt {like:?} to be like{near}")));
                };
                let mut table = (*found).clone();
                table.retain(|key, _| !OF_PLACE.contains(&key));
                table
            }
            None => Table::new(),
        };
        let own = keys.iter().filter(|(key, _)| *key != "like");
        table.extend(own.map(|(key, value)| (key.clone(), value.clone())));
        table.insert("name".to_owned(), name.into());
        table.insert("phase".to_owned(), phase.into());
        Ok(table)
    }
}

/// Its name: one that no bolt has.
fn named(keys: &Table, known: &[String]) -> Result<String, ChangeError> {
    let taken = |name: &str| {
        let many = format!("{name}.");
        known.iter().any(|one| one == name || one.starts_with(&many))
    };
    match keys.get("name") {
        Some(Value::String(name)) if taken(name) => {
            Err(bolt(name, "a bolt has this name".to_owned()))
        }
        Some(Value::String(name)) if !name.trim().is_empty() => Ok(name.clone()),
        Some(_) => Err(bolt("", "its name is no text".to_owned())),
        None => {
            let free = (1..).map(|k| format!("bolt by code {k}")).find(|name| !taken(name));
            free.ok_or(ChangeError::NoScene)
        }
    }
}

fn bolt(name: &str, why: String) -> ChangeError {
    ChangeError::Bolt { key: format!("bolt {name:?}"), why }
}
