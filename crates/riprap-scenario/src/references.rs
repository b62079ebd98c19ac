//! Names that refer to something: materials, blocks, groups, interfaces, variants, keys.

use std::collections::{BTreeMap, BTreeSet};

use riprap_core::condition::Condition;
use toml::de::DeTable;

use super::diagnostic::{Diagnostic, short};
use super::language::{Around, Geometry, Grid, Output, Scenario, Source, Target};
use super::load::key_si;
use super::quantity::{Name, Names, Raw, Span};
use super::words::WordOr;

/// The word of a phase in which no water stands.
pub const NO_WATER: &str = "none";

/// What stands for nothing, or twice.
pub(super) fn check(scenario: &Scenario, root: &DeTable<'_>, found: &mut Vec<Diagnostic>) {
    let blocks: BTreeMap<&str, bool> =
        scenario.blocks.iter().map(|block| (block.name.as_str(), block.is_generator())).collect();
    let mut groups: BTreeSet<&str> = blocks.keys().copied().collect();
    groups.extend(scenario.blocks.iter().flat_map(|block| &block.groups).map(Name::as_str));
    groups.extend(scenario.groups.names());
    let mut references = References { scenario, blocks, groups, found };
    references.unique();
    references.materials();
    references.targets();
    references.ground();
    references.sources();
    references.checks(root);
}

struct References<'a> {
    scenario: &'a Scenario,
    /// Names as written, and whether each stands for many blocks.
    blocks: BTreeMap<&'a str, bool>,
    groups: BTreeSet<&'a str>,
    found: &'a mut Vec<Diagnostic>,
}

impl<'a> References<'a> {
    fn unknown<'b>(
        &mut self,
        what: &str,
        name: &Name,
        known: impl IntoIterator<Item = &'b str> + Clone,
    ) {
        self.found.push(Diagnostic::unknown(what, name, known));
    }

    fn error(&mut self, code: &'static str, at: impl Into<Span>, message: String, help: &str) {
        self.found.push(Diagnostic::error(code, message).at(at.into()).help(help));
    }

    fn twice<'b>(&mut self, what: &str, names: impl Iterator<Item = &'b Name>) {
        let mut seen = BTreeSet::new();
        for name in names {
            if !seen.insert(name.as_str()) {
                let message = format!("there are two {what} called `{}`", short(&name.text));
                self.error("name.twice", name, message, "give each its own name");
            }
        }
    }

    fn unique(&mut self) {
        let scenario = self.scenario;
        self.twice("blocks", scenario.blocks.iter().map(|block| &block.name));
        self.twice("phases", scenario.phases.iter().map(|phase| &phase.name));
        let boundaries = scenario.boundaries.iter().filter_map(|b| b.name.as_ref());
        self.twice("boundaries", boundaries);
        let supports = scenario.supports.iter().filter_map(|s| s.name.as_ref());
        self.twice("supports", supports);
        let loads = scenario.loads.iter().filter_map(|l| l.name.as_ref());
        self.twice("loads", loads);
        self.twice("bolts", scenario.bolts.iter().map(|bolt| &bolt.name));
        self.twice("checks", scenario.checks.iter().map(|check| &check.name));
        let histories = scenario.outputs.iter().filter_map(|output| match output {
            Output::History(history) => Some(&history.name),
            Output::Frames(_) | Output::Checkpoints(_) => None,
        });
        self.twice("histories", histories);
        let mut pairs: BTreeMap<[&str; 2], &Name> = BTreeMap::new();
        for (name, interface) in scenario.interfaces.iter() {
            let Some([a, b]) = &interface.between else {
                continue;
            };
            let mut pair = [a.as_str(), b.as_str()];
            // Between a and b is between b and a.
            pair.sort_unstable();
            if let Some(first) = pairs.insert(pair, name) {
                let message = format!(
                    "interfaces.{first} and interfaces.{name} are between the same materials"
                );
                self.error("name.twice", name, message, "keep one of them");
            }
        }
    }

    fn materials(&mut self) {
        let scenario = self.scenario;
        let known: BTreeSet<&str> = scenario.materials.names().collect();
        let between = scenario.interfaces.iter().filter_map(|(_, one)| one.between.as_ref());
        let used = scenario.blocks.iter().map(|block| &block.material).chain(between.flatten());
        for name in used {
            if !known.contains(name.as_str()) {
                self.unknown("material", name, known.iter().copied());
            }
        }
    }

    /// Names of blocks as written; generated ones are known by their generator.
    fn is_block(&self, name: &str) -> bool {
        self.blocks.contains_key(name)
            // At the last dot: the name of the generator may have some too.
            || name.rsplit_once('.').is_some_and(|(generator, number)| {
                self.blocks.get(generator) == Some(&true)
                    && number.parse::<u32>().is_ok_and(|number| number > 0)
            })
    }

    fn block(&mut self, name: &Name) {
        if !self.is_block(name.as_str()) {
            let known: Vec<&str> = self.blocks.keys().copied().collect();
            self.unknown("block", name, known);
        }
    }

    /// Whether it is a group, or may be one: the groups of meshes and drawings are in their files, and the model looks there.
    fn is_group(&self, name: &str) -> bool {
        self.groups.contains(name)
            || name.rsplit_once('.').is_some_and(|(of, number)| {
                let group = self.scenario.groups.get(of);
                let rounds = group.and_then(|g| g.excavation.as_ref()?.rounds);
                number.parse().is_ok_and(|k: u64| k > 0 && rounds.is_some_and(|n| k <= n))
            })
            || self.scenario.blocks.iter().any(|block| {
                let part = name.strip_prefix(block.name.as_str());
                block.masonry.as_ref().is_some_and(|wall| {
                    part == Some("_lintels") && !wall.openings.is_empty()
                        || part == Some("_arches")
                            && wall.openings.iter().any(|opening| opening.arch.is_some())
                        || part == Some("_buttresses") && !wall.buttresses.is_empty()
                })
            })
            || self.scenario.blocks.iter().any(|b| b.mesh.is_some() || b.polygons.is_some())
    }

    /// Whether a text is meant as a condition on blocks; what is wrong with it is reported.
    fn is_condition(&mut self, text: &Name) -> bool {
        if !Condition::is_meant(text.as_str()) {
            return false;
        }
        let words = match Condition::read(text.as_str()) {
            Ok(condition) => condition.names,
            Err(fault) => {
                self.found.push(Diagnostic::no_condition(text, &fault));
                return true;
            }
        };
        let materials: Vec<&str> = self.scenario.materials.names().collect();
        for word in words {
            let of = word.text.as_str();
            if !self.is_block(of) && !self.is_group(of) && !materials.contains(&of) {
                let name = Name { span: text.within(&word.at), text: word.text };
                let known: Vec<&str> =
                    self.groups.iter().copied().chain(materials.iter().copied()).collect();
                self.unknown("group, block or material", &name, known);
            }
        }
        true
    }

    fn block_or_group(&mut self, name: &Name) {
        if !self.is_block(name.as_str())
            && !self.is_group(name.as_str())
            && !self.is_condition(name)
        {
            let known: Vec<&str> = self.groups.iter().copied().collect();
            self.unknown("block or group", name, known);
        }
    }

    fn source_block_or_group(&mut self, name: &Name) {
        let found = self.is_source(name.as_str())
            || self.is_block(name.as_str())
            || self.is_group(name.as_str())
            || self.is_condition(name);
        if !found {
            let known: Vec<&str> =
                self.scenario.sources.names().chain(self.groups.iter().copied()).collect();
            self.unknown("source, block or group", name, known);
        }
    }

    fn target(&mut self, target: &Target) {
        match target {
            Target::Block(name) => self.block(name),
            Target::Blocks(names) => {
                for name in names {
                    self.block(name);
                }
            }
            Target::Group(name) => self.group(name),
            Target::Box(_) => {}
            Target::Nodes(nodes) => {
                if let Some(name) = &nodes.block {
                    self.block(name);
                }
                if let Some(name) = &nodes.group {
                    self.group(name);
                }
            }
        }
    }

    fn group(&mut self, name: &Name) {
        if !self.is_block(name.as_str())
            && !self.is_group(name.as_str())
            && !self.is_condition(name)
        {
            let known: Vec<&str> = self.groups.iter().copied().collect();
            self.unknown("group", name, known);
        }
    }

    /// Names of bolts; of several alike those with a number too.
    fn is_bolt(&self, name: &str) -> bool {
        let known = |name: &str| self.scenario.bolts.iter().any(|b| b.name.as_str() == name);
        known(name) || name.rsplit_once('.').is_some_and(|(many, _)| known(many))
    }

    /// Blocks, groups, sources, bolts, boundaries, supports or loads: which of them a field wants, the model knows.
    fn of(&mut self, names: Option<&Names>) {
        for name in names.iter().flat_map(|names| &names.0) {
            let scene = self.scenario;
            let boundaries = scene.boundaries.iter().map(|b| &b.name);
            let supports = scene.supports.iter().map(|s| &s.name);
            let loads = scene.loads.iter().map(|l| &l.name);
            let mut named = boundaries.chain(supports).chain(loads).flatten();
            if !self.is_source(name.as_str())
                && !self.is_bolt(name.as_str())
                && !named.any(|b| b.as_str() == name.as_str())
            {
                self.block_or_group(name);
            }
        }
    }

    /// Names of sources; those of a pattern are called name.1, name.2, ...
    fn is_source(&self, name: &str) -> bool {
        let sources = &self.scenario.sources;
        sources.get(name).is_some()
            || name.rsplit_once('.').is_some_and(|(pattern, number)| {
                let many = match sources.get(pattern) {
                    Some(Source::GasCavity(gas)) => gas.pattern.is_some(),
                    Some(Source::PressureCavity(_)) | None => false,
                };
                many && number.parse::<u32>().is_ok_and(|number| number > 0)
            })
    }

    fn ground(&mut self) {
        let scenario = self.scenario;
        for (name, group) in scenario.groups.iter() {
            if let Some(&many) = self.blocks.get(name.as_str()) {
                let what = if many { "a generator of blocks" } else { "a block" };
                let message = format!("`{}` is the name of {what} already", short(&name.text));
                self.error("name.twice", name, message, "give the group another name");
            }
            for block in &group.blocks {
                self.block(block);
            }
            if let Some(set) = &group.joint_set {
                self.block(&set.of);
            }
        }
        for boundary in &scenario.boundaries {
            let on = &boundary.on;
            for name in on.block.iter().chain(on.blocks.iter().flatten()) {
                self.block(name);
            }
            if let Some(name) = &on.group {
                self.block_or_group(name);
            }
        }
    }

    fn sources(&mut self) {
        let scenario = self.scenario;
        let explosives: Vec<&str> = scenario.explosives.names().collect();
        for (_, source) in scenario.sources.iter() {
            let group = match source {
                Source::GasCavity(gas) => {
                    if let WordOr::Word(name, _) = &gas.explosive
                        && !explosives.contains(&name.as_str())
                    {
                        self.unknown("explosive", name, explosives.iter().copied());
                    }
                    &gas.group
                }
                Source::PressureCavity(cavity) => &cavity.group,
            };
            if let Some(name) = group {
                self.block_or_group(name);
            }
        }
        let graded = scenario.blocks.iter().filter_map(|block| {
            let Some(Geometry::Grid(Grid::Cells(cells))) = block.geometry() else { return None };
            cells.graded.as_ref()?.at.as_ref()
        });
        for refine in &scenario.refine {
            if let Around::Source(name) = &refine.octree.around {
                self.source_block_or_group(name);
            }
        }
        for around in graded {
            if let Around::Source(name) = around
                && !self.is_source(name.as_str())
            {
                let known: Vec<&str> = scenario.sources.names().collect();
                self.unknown("source", name, known);
            }
        }
    }

    fn targets(&mut self) {
        let scenario = self.scenario;
        for support in &scenario.supports {
            self.target(&support.on);
        }
        for load in &scenario.loads {
            self.target(&load.on);
        }
        let interfaces: Vec<&str> = scenario.interfaces.names().collect();
        for phase in &scenario.phases {
            for name in phase.remove.iter().chain(&phase.fix).chain(&phase.release) {
                self.block_or_group(name);
            }
            for name in phase.water.iter().flat_map(|names| &names.0) {
                if name.as_str() != NO_WATER && scenario.water.get(name.as_str()).is_none() {
                    let mut known: Vec<&str> = scenario.water.names().collect();
                    known.push(NO_WATER);
                    self.unknown("water table", name, known);
                }
            }
            for (name, _) in phase.interfaces.iter() {
                if !interfaces.contains(&name.as_str()) {
                    self.unknown("interface", name, interfaces.iter().copied());
                }
            }
        }
        for name in scenario.interfaces_of_bridges() {
            if !interfaces.contains(&name.as_str()) {
                self.unknown("interface", name, interfaces.iter().copied());
            }
        }
        let phases: Vec<&str> = scenario.phases.iter().map(|p| p.name.as_str()).collect();
        for phase in scenario.bolts.iter().filter_map(|bolt| bolt.phase.as_ref()) {
            if !phases.contains(&phase.as_str()) {
                self.unknown("phase", phase, phases.iter().copied());
            }
        }
        for output in &scenario.outputs {
            match output {
                Output::History(history) => self.of(history.of.as_ref()),
                Output::Frames(_) | Output::Checkpoints(_) => {}
            }
        }
        let of_samples = scenario.monte_carlo.as_ref().and_then(|of| of.fails_when.as_ref());
        for criterion in scenario.bisect.iter().map(|of| &of.fails_when).chain(of_samples) {
            self.of(criterion.of.as_ref());
        }
    }

    fn checks(&mut self, root: &DeTable<'_>) {
        let scenario = self.scenario;
        for check in &scenario.checks {
            self.of(check.of.as_ref());
            for name in &check.only {
                if name.as_str() != "default" && scenario.variants.get(name.as_str()).is_none() {
                    let known: Vec<&str> =
                        scenario.variants.names().chain(std::iter::once("default")).collect();
                    self.unknown("variant", name, known);
                }
            }
            for (name, value) in check.names.iter() {
                let Raw::Text(key) = &value.raw else { continue };
                let is_key = key.starts_with(|c: char| c.is_alphabetic()) && key.contains('.');
                if is_key && let Err(reason) = key_si(root, key) {
                    let message = format!("`{name}` in `let`: {reason}");
                    let help = "name a key of this file whose value is a number";
                    self.error("key.path", value.span.clone(), message, help);
                }
            }
        }
    }
}
