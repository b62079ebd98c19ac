//! Which scene a checkpoint is of, and what has been edited since.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::record::checkpoint::CheckpointError;
use crate::record::manifest::{InputFile, Manifest};
use crate::record::read_plain_text;

/// The scene of a checkpoint.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// Title of the scene.
    pub title: String,
    /// Scene file as given.
    pub scenario: String,
    /// Named variant.
    pub variant: String,
    /// Sweep case.
    pub case: String,
    /// blake3 of the resolved scene and all files it reads.
    pub input_hash: String,
    /// Files that the scene reads.
    pub files: Vec<InputFile>,
    /// The scene with all changes made.
    pub resolved: String,
}

impl Origin {
    /// Of a run that begins.
    #[must_use]
    pub fn new(manifest: &Manifest, resolved: &str) -> Self {
        Self {
            title: manifest.title.clone(),
            scenario: manifest.scenario.clone(),
            variant: manifest.variant.clone(),
            case: manifest.case.clone(),
            input_hash: manifest.input_hash.clone(),
            files: manifest.files.clone(),
            resolved: resolved.to_owned(),
        }
    }

    /// Whether the run of that manifest may go on from the checkpoint at `path`: the same scene, perhaps edited.
    ///
    /// # Errors
    /// Another scene, another variant or case of it.
    pub fn admit(&self, path: &Path, manifest: &Manifest) -> Result<(), CheckpointError> {
        let of_run = Self::new(manifest, "");
        // Whoever moves or copies a scene still has the same one.
        let same = file_name(&self.scenario) == file_name(&of_run.scenario)
            && self.title == of_run.title
            && self.variant == of_run.variant
            && self.case == of_run.case;
        if same {
            return Ok(());
        }
        Err(CheckpointError::OtherScene {
            path: path.to_owned(),
            found: self.words(),
            wanted: of_run.words(),
        })
    }

    /// The scene in words.
    fn words(&self) -> String {
        let mut words = format!("{:?} ({}", self.title, self.scenario);
        for (what, name) in [("variant", &self.variant), ("case", &self.case)] {
            if !name.is_empty() && name != "default" {
                words += &format!(", {what} {name}");
            }
        }
        words + ")"
    }

    /// What has been edited since the checkpoint was written, in words: the text in the run folder, the scene file where it
    /// still is, and the files that it reads.
    #[must_use]
    pub fn edits(&self, folder: &Path, manifest: &Manifest) -> Vec<String> {
        let goes_on = "a resumed run keeps the values of its checkpoint; to use other values, start a new run";
        let mut found = Vec::new();
        let resolved = folder.join("scenario.resolved.toml");
        if let Ok(text) = read_plain_text(&resolved) {
            let differ = differences(&self.resolved, &text);
            if !differ.is_empty() {
                found.push(format!(
                    "{} differs from the scene of the checkpoint in {}; {goes_on}",
                    resolved.display(),
                    listed(&differ)
                ));
            }
        }
        // Seen from where the command is called, as when the run began; nothing can be said of a scene that is elsewhere.
        let scene = Path::new(&manifest.scenario);
        if let Ok(text) = read_plain_text(scene) {
            match as_run(&text, manifest) {
                Ok(text) => {
                    let differ = differences(&self.resolved, &text);
                    if !differ.is_empty() {
                        found.push(format!(
                            "{} was edited after the run had started: {}; {goes_on}",
                            scene.display(),
                            listed(&differ)
                        ));
                    }
                }
                Err(why) => found.push(format!(
                    "{} was edited after the run had started and cannot be compared: {why}; {goes_on}",
                    scene.display()
                )),
            }
            let beside = scene.parent().unwrap_or(Path::new(""));
            for file in &self.files {
                if InputFile::read(beside, &file.name).is_some_and(|now| now != *file) {
                    found.push(format!(
                        "{}, which the scene reads, was edited after the run had started; {goes_on}",
                        beside.join(&file.name).display()
                    ));
                }
            }
        }
        let program = env!("CARGO_PKG_VERSION");
        if manifest.riprap != program {
            found.push(format!(
                "the run was started by riprap {}, and this is {program}: bitwise identical results are not guaranteed",
                manifest.riprap
            ));
        }
        found
    }
}

fn file_name(path: &str) -> Option<&std::ffi::OsStr> {
    Path::new(path).file_name()
}

/// The first of many.
fn listed(keys: &[String]) -> String {
    const SHOWN: usize = 8;
    let mut text = keys.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    if keys.len() > SHOWN {
        text += &format!(" and {} more", keys.len() - SHOWN);
    }
    text
}

/// The scene as the run with that manifest would read it now.
#[cfg(feature = "scenario")]
fn as_run(text: &str, manifest: &Manifest) -> Result<String, String> {
    use crate::scenario::{Case, Source};
    let changes =
        manifest.overrides.iter().map(|change| (change.key.clone(), change.value.clone()));
    let case = Case {
        name: manifest.case.clone(),
        variant: manifest.variant.clone(),
        changes: changes.collect(),
        trial: Vec::new(),
    };
    let source = Source::new(manifest.scenario.clone(), text);
    let resolved = case.source(&source, &[]).map_err(|errors| {
        let first = errors.list.first();
        first.map_or(String::new(), |error| error.message.clone())
    })?;
    Ok(resolved.text)
}

#[cfg(not(feature = "scenario"))]
fn as_run(_: &str, _: &Manifest) -> Result<String, String> {
    Err("this program cannot read scenes".to_owned())
}

/// Dotted keys that have different values in two scenes, or are in one of them only. Comments and order do not count.
#[cfg(feature = "scenario")]
fn differences(old: &str, new: &str) -> Vec<String> {
    use std::collections::BTreeMap;
    if old == new {
        return Vec::new();
    }
    let read = |text: &str| {
        let root: toml::Table = toml::from_str(text).ok()?;
        let mut leaves = BTreeMap::new();
        collect(&toml::Value::Table(root), "", &mut leaves);
        Some(leaves)
    };
    let (Some(old), Some(new)) = (read(old), read(new)) else {
        return vec!["its text, which is no longer valid TOML".to_owned()];
    };
    let mut keys: Vec<&String> = old.keys().chain(new.keys()).collect();
    keys.sort();
    keys.dedup();
    keys.into_iter().filter(|key| old.get(*key) != new.get(*key)).cloned().collect()
}

#[cfg(not(feature = "scenario"))]
fn differences(old: &str, new: &str) -> Vec<String> {
    if old == new { Vec::new() } else { vec!["its text".to_owned()] }
}

/// The values of a document by their keys, tables of a list by their names as in `--set`.
#[cfg(feature = "scenario")]
fn collect(
    value: &toml::Value,
    path: &str,
    found: &mut std::collections::BTreeMap<String, String>,
) {
    let below = |key: &str| {
        if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
    };
    match value {
        toml::Value::Table(table) => {
            for (key, item) in table {
                collect(item, &below(key), found);
            }
        }
        toml::Value::Array(items) if items.iter().all(toml::Value::is_table) => {
            for (index, item) in items.iter().enumerate() {
                let name = item.get("name").and_then(toml::Value::as_str);
                let name = name.map_or_else(|| index.to_string(), str::to_owned);
                collect(item, &below(&name), found);
            }
        }
        leaf => {
            found.insert(path.to_owned(), leaf.to_string());
        }
    }
}

#[cfg(all(test, feature = "scenario"))]
mod tests {
    use super::*;

    #[test]
    fn keys_that_differ_are_named() {
        let old = "a = 1\n[b]\nc = [1, 2]\n[[d]]\nname = \"x\"\ne = 1\n[[d]]\nname = \"y\"\n";
        let new =
            "# said\n[b]\nc = [1, 3]\nf = 2\n[[d]]\nname = \"y\"\n[[d]]\nname = \"x\"\ne = 2\n";
        assert_eq!(differences(old, new), ["a", "b.c", "b.f", "d.x.e"]);
        assert!(differences(old, &format!("# a word\n{old}")).is_empty());
        assert_eq!(differences(old, "a = "), ["its text, which is no longer valid TOML"]);
    }

    #[test]
    fn a_case_of_its_own_is_another_scene() {
        let of = |case: &str| Manifest {
            title: "hill".to_owned(),
            scenario: "a/hill.toml".to_owned(),
            case: case.to_owned(),
            ..Manifest::default()
        };
        let origin = Origin::new(&of("phi=10"), "");
        let path = Path::new("x.rck");
        assert!(origin.admit(path, &of("phi=10")).is_ok());
        let wrong = origin.admit(path, &of("phi=20")).unwrap_err().to_string();
        assert!(wrong.contains("case phi=10") && wrong.contains("case phi=20"), "{wrong}");
    }
}
