//! Names of blocks and groups to block numbers.

use std::collections::BTreeMap;

use crate::scenario::diagnostic::suggest;
use crate::scenario::{Diagnostic, Name};
use riprap_core::condition::Condition;
use riprap_core::numbers::counted;

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
    /// In the order of their blocks.
    entries: Vec<Entry>,
    /// Place in `entries` by name.
    places: BTreeMap<String, usize>,
    groups: BTreeMap<String, Vec<u32>>,
    /// Groups that could not be made, for a reason that has been told: that they are empty is no second one.
    pub(super) failed: Vec<String>,
    /// Charges and cavities, in the order of the setup.
    pub(super) sources: Vec<String>,
    /// Bolts, in the order of the setup.
    pub(super) bolts: Vec<String>,
    /// Centroid of every block, local coordinates, m; z is 0 in the plane.
    pub(super) centroids: Vec<[f64; 3]>,
    /// Materials and their blocks.
    pub(super) materials: Vec<(String, Vec<u32>)>,
}

impl Directory {
    /// Enters the blocks of one table.
    pub(super) fn add(&mut self, entry: Entry, groups: &[Name]) {
        let numbers = || entry.first..entry.first + entry.count;
        let own = entry.numbered.then_some(entry.name.as_str());
        for group in groups.iter().map(Name::as_str).chain(own) {
            self.groups.entry(group.to_owned()).or_default().extend(numbers());
        }
        self.places.insert(entry.name.clone(), self.entries.len());
        self.entries.push(entry);
    }

    /// Adds blocks to a group, which need not exist yet.
    pub(super) fn extend(&mut self, group: &str, blocks: Vec<u32>) {
        self.groups.entry(group.to_owned()).or_default().extend(blocks);
    }

    /// Numbers of the bolts of a name: one, or all of a pattern.
    pub(super) fn bolts_of(&self, name: &str) -> Vec<u32> {
        let of = |bolt: &String| {
            bolt == name || bolt.rsplit_once('.').is_some_and(|(many, _)| many == name)
        };
        let all = (0u32..).zip(&self.bolts);
        all.filter(|(_, bolt)| of(bolt)).map(|(k, _)| k).collect()
    }

    /// Name of a block.
    pub(super) fn name(&self, block: u32) -> String {
        let k = self.entries.partition_point(|e| e.first <= block);
        match k.checked_sub(1).and_then(|k| self.entries.get(k)) {
            Some(entry) if entry.numbered => {
                format!("{}.{}", entry.name, block - entry.first + 1)
            }
            Some(entry) => entry.name.clone(),
            None => format!("number {block}"),
        }
    }

    /// Name and blocks of each table.
    pub(super) fn tables(&self) -> impl Iterator<Item = (&str, std::ops::Range<u32>)> {
        self.entries.iter().map(|e| (e.name.as_str(), e.first..e.first + e.count))
    }

    /// Name of the table that made a block.
    pub(super) fn table(&self, block: u32) -> &str {
        let k = self.entries.partition_point(|e| e.first <= block);
        k.checked_sub(1).and_then(|k| self.entries.get(k)).map_or("", |entry| entry.name.as_str())
    }

    /// Groups by name, their blocks ascending.
    pub(super) fn groups(&self) -> Vec<(String, Vec<u32>)> {
        let group = |(name, blocks): (&String, &Vec<u32>)| {
            let mut blocks = blocks.clone();
            blocks.sort_unstable();
            blocks.dedup();
            (name.clone(), blocks)
        };
        self.groups.iter().map(group).collect()
    }

    fn lookup(&self, name: &str) -> Option<Vec<u32>> {
        let single = self.places.get(name).map(|&k| &self.entries[k]);
        if let Some(entry) = single.filter(|entry| !entry.numbered) {
            return Some(vec![entry.first]);
        }
        if let Some((table, number)) = name.rsplit_once('.')
            && let Some(entry) = self.places.get(table).map(|&k| &self.entries[k])
            && entry.numbered
            && let Ok(number) = number.parse::<u32>()
            && (1..=entry.count).contains(&number)
        {
            return Some(vec![entry.first + number - 1]);
        }
        let mut blocks = self.groups.get(name)?.clone();
        blocks.sort_unstable();
        blocks.dedup();
        Some(blocks)
    }

    /// Whether a name is that of a group, and not of a block.
    pub(super) fn is_group(&self, name: &str) -> bool {
        self.groups.contains_key(name) && self.single(name).is_none()
    }

    /// Number of the one block of a name.
    pub(super) fn single(&self, name: &str) -> Option<u32> {
        match self.lookup(name)?[..] {
            [block] if self.name(block) == name => Some(block),
            _ => None,
        }
    }

    /// Blocks whose centroid lies in a box, bounds included; ascending.
    pub(super) fn inside(&self, min: [f64; 3], max: [f64; 3]) -> Vec<u32> {
        let inside = |c: &[f64; 3]| (0..3).all(|k| min[k] <= c[k] && c[k] <= max[k]);
        (0u32..).zip(&self.centroids).filter(|(_, c)| inside(c)).map(|(block, _)| block).collect()
    }

    /// Blocks of a block, generator or group name, or of a condition, which holds for at least one.
    pub(super) fn blocks(&self, name: &Name) -> Result<Vec<u32>, Box<Diagnostic>> {
        if let Some(blocks) = self.lookup(name.as_str()) {
            return Ok(blocks);
        }
        if !Condition::is_meant(name.as_str()) {
            return Err(Box::new(self.unknown(name, "block or group")));
        }
        let (blocks, counts) = self.fulfil(name)?;
        if blocks.is_empty() && !self.rests_on_failed(name) {
            let error = Diagnostic::error("group.empty", format!("no block fulfils `{name}`"));
            return Err(Box::new(error.at(name.span.clone()).help(counts)));
        }
        Ok(blocks)
    }

    /// Blocks of a material.
    pub(super) fn of_material(&self, name: &str) -> Option<Vec<u32>> {
        Some(self.materials.iter().find(|(of, _)| of == name)?.1.clone())
    }

    /// Whether a condition names a group that could not be made.
    pub(super) fn rests_on_failed(&self, text: &Name) -> bool {
        let condition = Condition::read(text.as_str());
        condition.is_ok_and(|of| of.names.iter().any(|word| self.failed.contains(&word.text)))
    }

    /// Blocks for which a condition holds, ascending, and how many each of its names has, in words.
    pub(super) fn fulfil(&self, text: &Name) -> Result<(Vec<u32>, String), Box<Diagnostic>> {
        let condition = Condition::read(text.as_str())
            .map_err(|fault| Box::new(Diagnostic::no_condition(text, &fault)))?;
        let (mut sets, mut counts) = (Vec::new(), Vec::new());
        for word in &condition.names {
            let known = self.lookup(&word.text).or_else(|| self.of_material(&word.text));
            let Some(blocks) = known else {
                let name = Name { text: word.text.clone(), span: text.within(&word.at) };
                let all = self.materials.iter().map(|(material, _)| material.as_str());
                return Err(Box::new(self.unknown_of(&name, "group, block or material", all)));
            };
            counts.push(format!("`{}` has {}", word.text, counted(blocks.len(), "block")));
            let mut set = vec![false; self.centroids.len()];
            for block in blocks {
                set[block as usize] = true;
            }
            sets.push(set);
        }
        let holds = |b: &u32| condition.holds_by(&|k| sets[k][*b as usize]);
        let blocks = (0..self.centroids.len() as u32).filter(holds).collect();
        Ok((blocks, counts.join(", ")))
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
        if wrong.is_empty() { Ok(blocks) } else { Err(wrong) }
    }

    fn unknown(&self, name: &Name, what: &str) -> Diagnostic {
        self.unknown_of(name, what, std::iter::empty())
    }

    fn unknown_of<'a>(
        &'a self,
        name: &Name,
        what: &str,
        more: impl Iterator<Item = &'a str>,
    ) -> Diagnostic {
        let error = Diagnostic::error("name.unknown", format!("there is no {what} `{name}`"))
            .at(name.span.clone());
        let numbered = self.entries.iter().filter(|e| e.numbered).find(|e| {
            let rest = name.as_str().strip_prefix(e.name.as_str());
            rest.and_then(|rest| rest.strip_prefix('.')).is_some()
        });
        if let Some(entry) = numbered {
            let (name, count) = (&entry.name, entry.count);
            return error.help(format!("`{name}` has the blocks {name}.1 to {name}.{count}"));
        }
        let known: Vec<&str> = self
            .entries
            .iter()
            .map(|e| e.name.as_str())
            .chain(self.groups.keys().map(String::as_str))
            .chain(more)
            .collect();
        match suggest(name.as_str(), known) {
            Some(help) => error.help(help),
            None => error,
        }
    }
}
