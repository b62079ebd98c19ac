//! Names of blocks and groups to block numbers.

use std::collections::BTreeMap;

use crate::planar::setup::Group;
use crate::scenario::diagnostic::suggest;
use crate::scenario::language::Target;
use crate::scenario::{Diagnostic, Name};

/// One `[[blocks]]` table after generation.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) name: String,
    pub(super) first: u32,
    pub(super) count: u32,
    /// Whether its blocks are called name.1, name.2, ...
    pub(super) numbered: bool,
}

/// All names of a model.
#[derive(Clone, Debug, Default)]
pub(super) struct Directory {
    entries: Vec<Entry>,
    blocks: BTreeMap<String, u32>,
    groups: BTreeMap<String, Vec<u32>>,
}

impl Directory {
    /// Enters the blocks of one table; returns their names.
    pub(super) fn add(&mut self, entry: Entry, groups: &[Name]) -> Vec<String> {
        let name = |k: u32| {
            if entry.numbered {
                format!("{}.{}", entry.name, k + 1)
            } else {
                entry.name.clone()
            }
        };
        let names: Vec<String> = (0..entry.count).map(name).collect();
        let numbers = || entry.first..entry.first + entry.count;
        self.blocks.extend(names.iter().cloned().zip(numbers()));
        let own = entry.numbered.then_some(entry.name.as_str());
        for group in groups.iter().map(Name::as_str).chain(own) {
            self.groups
                .entry(group.to_owned())
                .or_default()
                .extend(numbers());
        }
        self.entries.push(entry);
        names
    }

    /// Groups by name, their blocks ascending.
    pub(super) fn groups(&self) -> Vec<Group> {
        let group = |(name, blocks): (&String, &Vec<u32>)| {
            let mut blocks = blocks.clone();
            blocks.sort_unstable();
            blocks.dedup();
            Group {
                name: name.clone(),
                blocks,
            }
        };
        self.groups.iter().map(group).collect()
    }

    fn lookup(&self, name: &str) -> Option<Vec<u32>> {
        if let Some(&block) = self.blocks.get(name) {
            return Some(vec![block]);
        }
        let mut blocks = self.groups.get(name)?.clone();
        blocks.sort_unstable();
        blocks.dedup();
        Some(blocks)
    }

    /// Blocks of a block, generator or group name.
    pub(super) fn blocks(&self, name: &Name) -> Result<Vec<u32>, Box<Diagnostic>> {
        self.lookup(name.as_str())
            .ok_or_else(|| Box::new(self.unknown(name, "block or group")))
    }

    /// Blocks of a target, ascending.
    pub(super) fn target(&self, target: &Target) -> Result<Vec<u32>, Vec<Diagnostic>> {
        let names = match target {
            Target::Block(name) | Target::Group(name) => std::slice::from_ref(name),
            Target::Blocks(names) => names,
        };
        self.all(names)
    }

    /// Blocks of several names, ascending.
    pub(super) fn all(&self, names: &[Name]) -> Result<Vec<u32>, Vec<Diagnostic>> {
        let (mut blocks, mut wrong) = (Vec::new(), Vec::new());
        for name in names {
            match self.blocks(name) {
                Ok(more) => blocks.extend(more),
                Err(error) => wrong.push(*error),
            }
        }
        blocks.sort_unstable();
        blocks.dedup();
        if wrong.is_empty() {
            Ok(blocks)
        } else {
            Err(wrong)
        }
    }

    fn unknown(&self, name: &Name, what: &str) -> Diagnostic {
        let error = Diagnostic::error("name.unknown", format!("there is no {what} `{name}`"))
            .at(name.span.clone());
        let numbered = self.entries.iter().filter(|e| e.numbered).find(|e| {
            let rest = name.as_str().strip_prefix(e.name.as_str());
            rest.and_then(|rest| rest.strip_prefix('.')).is_some()
        });
        if let Some(entry) = numbered {
            let (name, count) = (&entry.name, entry.count);
            return error.help(format!(
                "`{name}` has the blocks {name}.1 to {name}.{count}"
            ));
        }
        let known: Vec<&str> = self
            .entries
            .iter()
            .map(|e| e.name.as_str())
            .chain(self.groups.keys().map(String::as_str))
            .collect();
        match suggest(name.as_str(), known) {
            Some(help) => error.help(help),
            None => error,
        }
    }
}
