//! `names.json`: names of blocks and groups, by the numbers that frames carry.
//!
//! A model of a million blocks has few names: blocks of a generator are counted (`rock.1` to `rock.4000`), and such
//! a run of numbers is one entry.

use super::disk::{OutputError, write_whole};
use riprap_core::condition::{Condition, Word};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// File of the names in a run folder.
pub const FILE: &str = "names.json";

/// Blocks with consecutive numbers, and what they are called.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Run {
    /// Number of the first block.
    pub first: u32,
    /// Its name; with `from` what stands before the dot.
    pub name: String,
    /// Number in the name of the first block: they are called `name.from`, `name.(from + 1)`, ...
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<u32>,
    /// How many blocks.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub count: u32,
}

fn one() -> u32 {
    1
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn is_one(n: &u32) -> bool {
    *n == 1
}

/// A group.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// First and last numbers of its blocks, ascending.
    pub blocks: Vec<[u32; 2]>,
}

impl Group {
    fn has(&self, block: u32) -> bool {
        let after = self.blocks.partition_point(|r| r[0] <= block);
        after > 0 && self.blocks[after - 1][1] >= block
    }
}

/// All names of a model.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Names {
    /// Ascending by number.
    pub blocks: Vec<Run>,
    /// In the order of the scene.
    pub groups: Vec<Group>,
}

impl Names {
    /// Packs names given block by block, and the members of groups (ascending).
    pub fn pack<'a>(
        names: impl IntoIterator<Item = String>,
        groups: impl IntoIterator<Item = (&'a str, &'a [u32])>,
    ) -> Self {
        let mut out = Names::default();
        for (i, name) in names.into_iter().enumerate() {
            let (base, number) = split(&name);
            if let (Some(last), Some(number)) = (out.blocks.last_mut(), number)
                && last.name == base
                && last.from.and_then(|f| f.checked_add(last.count)) == Some(number)
            {
                last.count += 1;
                continue;
            }
            out.blocks.push(Run { first: i as u32, name: base.to_owned(), from: number, count: 1 });
        }
        for (name, members) in groups {
            let mut blocks: Vec<[u32; 2]> = Vec::new();
            for &b in members {
                match blocks.last_mut() {
                    Some(range) if range[1].checked_add(1) == Some(b) => range[1] = b,
                    Some(_) | None => blocks.push([b, b]),
                }
            }
            let name = name.to_owned();
            out.groups.push(Group { name, blocks });
        }
        out
    }

    /// Name of a block.
    #[must_use]
    pub fn block(&self, number: u32) -> Option<String> {
        let after = self.blocks.partition_point(|r| r.first <= number);
        let run = &self.blocks[after.checked_sub(1)?];
        let offset = number - run.first;
        (offset < run.count).then(|| match run.from {
            Some(from) => format!("{}.{}", run.name, from.saturating_add(offset)),
            None => run.name.clone(),
        })
    }

    /// Number of a block.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<u32> {
        let (base, number) = split(name);
        self.blocks.iter().find_map(|r| {
            if r.name != base {
                return None;
            }
            match (r.from, number) {
                (None, None) => Some(r.first),
                (Some(from), Some(n)) => {
                    let offset = n.checked_sub(from).filter(|o| *o < r.count)?;
                    r.first.checked_add(offset)
                }
                (None, Some(_)) | (Some(_), None) => None,
            }
        })
    }

    /// Whether a block was split from another one.
    fn is_part(&self, number: u32) -> bool {
        let after = self.blocks.partition_point(|r| r.first <= number);
        after > 0 && self.blocks[after - 1].name.contains('/')
    }

    /// A block and those that it was split from: `rock.17/3` comes of `rock.17`.
    pub fn stem(&self, number: u32) -> impl Iterator<Item = u32> + '_ {
        let mut name = self.block(number);
        let above = std::iter::from_fn(move || {
            let parent = name.as_ref()?.rsplit_once('/')?.0.to_owned();
            let number = self.number(&parent);
            name = Some(parent);
            number
        });
        std::iter::once(number).chain(above)
    }

    /// Groups a block is in.
    #[must_use]
    pub fn groups_of(&self, number: u32) -> Vec<&str> {
        let found = self.groups.iter().filter(|g| g.has(number));
        found.map(|g| g.name.as_str()).collect()
    }

    /// What a text names: a block, a group, or what a condition makes of them.
    ///
    /// # Errors
    /// A name of nothing, or a condition that is none: what is wrong.
    pub fn chosen(&self, text: &str) -> Result<Chosen<'_>, String> {
        let known =
            |name: &str| self.number(name).is_some() || self.groups.iter().any(|g| g.name == name);
        let condition = if !known(text) && Condition::is_meant(text) {
            Condition::read(text).map_err(|fault| {
                let (before, here) = (&text[..fault.at.start], &text[fault.at.clone()]);
                format!("the condition {text:?}: {} (`{here}` behind {before:?})", fault.why)
            })?
        } else {
            Condition::name(text)
        };
        let of = |name: &Word| {
            let group = self.groups.iter().find(|g| g.name == name.text);
            (self.number(&name.text), group)
        };
        match condition.names.iter().find(|name| !known(&name.text)) {
            None => {
                let of = condition.names.iter().map(of).collect();
                Ok(Chosen { names: self, condition, of })
            }
            Some(name) => {
                let all: Vec<&str> = self.groups.iter().map(|g| g.name.as_str()).collect();
                let known = match all.is_empty() {
                    true => "the run has no groups, name a block".to_owned(),
                    false => format!("valid groups: {}", all.join(", ")),
                };
                Err(format!("unknown block or group {:?}; {known}", name.text))
            }
        }
    }

    /// Reads the names of a run folder; one without them (of an earlier riprap) has none.
    ///
    /// # Errors
    /// A file that cannot be read or is damaged: its path and why.
    pub fn read(folder: &Path) -> Result<Self, NamesError> {
        let path = folder.join(FILE);
        let text = match crate::read_plain_text(&path) {
            Ok(text) => text,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Names::default()),
            Err(e) => {
                let reason = e.to_string();
                return Err(NamesError { path, reason });
            }
        };
        let names: Names = serde_json::from_str(&text)
            .map_err(|e| NamesError { path: path.clone(), reason: e.to_string() })?;
        let ordered = names.blocks.is_sorted_by_key(|r| r.first)
            && names.groups.iter().all(|g| g.blocks.is_sorted());
        if ordered {
            return Ok(names);
        }
        let reason = "its numbers are not ascending".to_owned();
        Err(NamesError { path, reason })
    }

    /// Writes the file; the old one stays until the new one is complete.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        let path = folder.join(FILE);
        let mut text = serde_json::to_string(self)
            .map_err(|e| OutputError { path: path.clone(), source: e.into() })?;
        text.push('\n');
        write_whole(&path, text.as_bytes())
    }
}

/// Blocks that a text names.
#[derive(Debug)]
pub struct Chosen<'a> {
    names: &'a Names,
    condition: Condition,
    /// The block or the group of each name of the condition.
    of: Vec<(Option<u32>, Option<&'a Group>)>,
}

impl Chosen<'_> {
    /// Whether a block is one of them: a name holds for what it was split from too.
    #[must_use]
    pub fn has(&self, block: u32) -> bool {
        let is = |k: usize, block: u32| {
            let (number, group) = self.of[k];
            number == Some(block) || group.is_some_and(|g| g.has(block))
        };
        if !self.names.is_part(block) {
            return self.condition.holds_by(&|k| is(k, block));
        }
        let stem: Vec<u32> = self.names.stem(block).collect();
        self.condition.holds_by(&|k| stem.iter().any(|b| is(k, *b)))
    }
}

/// Why the names of a run cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{} cannot be used: {reason}", path.display())]
pub struct NamesError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub reason: String,
}

/// `rock.17` is `rock` and 17; numbers are written without leading zeros.
fn split(name: &str) -> (&str, Option<u32>) {
    let parts = name.rsplit_once('.');
    match parts.and_then(|(base, tail)| Some((base, tail, tail.parse::<u32>().ok()?))) {
        Some((base, tail, number)) if number.to_string() == tail => (base, Some(number)),
        Some(_) | None => (name, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Names {
        let mut names: Vec<String> = vec!["base".to_owned()];
        names.extend((1..=4).map(|k| format!("rock.{k}")));
        names.extend(["rock.2/1", "rock.2/1.5", "v.01", "rock.9"].map(str::to_owned));
        let groups = [("rock", &[1_u32, 2, 3, 4, 8][..]), ("all", &[0, 1, 2])];
        Names::pack(names, groups)
    }

    #[test]
    fn every_block_has_its_name_and_every_name_its_block() {
        let names = sample();
        assert_eq!(names.blocks.len(), 6);
        let wanted = [
            "base",
            "rock.1",
            "rock.2",
            "rock.3",
            "rock.4",
            "rock.2/1",
            "rock.2/1.5",
            "v.01",
            "rock.9",
        ];
        for (k, want) in wanted.iter().enumerate() {
            assert_eq!(names.block(k as u32).as_deref(), Some(*want));
            assert_eq!(names.number(want), Some(k as u32));
        }
        assert_eq!(names.block(9), None);
        assert_eq!(names.number("rock.5"), None);
        assert_eq!(names.number("rock"), None);
        assert_eq!(names.stem(6).collect::<Vec<_>>(), [6, 2]);
        assert_eq!(names.stem(2).collect::<Vec<_>>(), [2]);
        assert_eq!(names.groups_of(2), ["rock", "all"]);
        assert_eq!(names.groups_of(8), ["rock"]);
        assert!(names.groups_of(5).is_empty());
    }

    #[test]
    fn blocks_are_chosen_by_name_group_and_condition() {
        let names = sample();
        let of = |text: &str| -> Vec<u32> {
            let chosen = names.chosen(text).expect(text);
            (0..9).filter(|b| chosen.has(*b)).collect()
        };
        // With what was split from it.
        assert_eq!(of("rock.2"), [2, 5, 6]);
        assert_eq!(of("all"), [0, 1, 2, 5, 6]);
        assert_eq!(of("rock and not (all or rock.9)"), [3, 4]);
        let wrong = |text: &str| names.chosen(text).expect_err(text);
        assert!(
            wrong("rocks").contains("unknown block or group \"rocks\"; valid groups: rock, all")
        );
        assert!(wrong("rock and ore").contains("\"ore\""));
        assert!(wrong("rock or or all").contains("a name is missing (`or` behind \"rock or \")"));
    }

    #[test]
    fn files() {
        let dir = tempfile::tempdir().unwrap();
        assert_eq!(Names::read(dir.path()).unwrap(), Names::default());
        sample().write(dir.path()).unwrap();
        assert_eq!(Names::read(dir.path()).unwrap(), sample());
        for text in ["{", "[1]", r#"{"blocks":[{"first":4,"name":"a"},{"first":0,"name":"b"}]}"#] {
            std::fs::write(dir.path().join(FILE), text).unwrap();
            assert!(Names::read(dir.path()).is_err(), "{text}");
        }
        let huge =
            r#"{"blocks":[{"first":4294967295,"name":"a","from":4294967295,"count":4294967295}]}"#;
        std::fs::write(dir.path().join(FILE), huge).unwrap();
        let names = Names::read(dir.path()).unwrap();
        assert_eq!(names.number("a.4294967295"), Some(u32::MAX));
        assert_eq!(names.block(u32::MAX).unwrap(), "a.4294967295");
    }
}
