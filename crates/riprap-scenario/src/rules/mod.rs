//! What the attributes of keys cannot say: values that depend on each other, and rules about several tables. Rules about
//! keys of one table are in [`super::rule`], references between tables in [`super::references`].

mod behaviour;
mod blocks;
mod bolts;
mod bonds;
mod checks;
mod ground;
mod interfaces;
mod joints;
mod motion;
mod samples;
mod sources;
#[cfg(test)]
mod tests;
mod water;

use toml::de::DeTable;

use super::diagnostic::Diagnostic;
use super::language::{Bisect, Output, Scenario, Space, Target};
use super::quantity::{Density, Kind, Name, Quantity, Span};
use super::references;
use super::units::Dim;
use super::vectors::InSpace;
use riprap_core::dynamics::Formula;
use riprap_core::dynamics::formula::FUNCTIONS;

/// What is wrong beyond keys and values. `values_sound`: no quantity was refused, so that numbers
/// may be compared.
pub(super) fn check(
    scenario: &Scenario,
    root: &DeTable<'_>,
    values_sound: bool,
) -> Vec<Diagnostic> {
    let mut rules = Rules {
        found: Vec::new(),
        space: match scenario.space {
            Space::Planar(_) => InSpace::Planar,
            Space::Spatial(_) => InSpace::Spatial,
        },
        values_sound,
    };
    rules.head(scenario, root);
    rules.scenario(scenario);
    references::check(scenario, root, &mut rules.found);
    rules.found
}

/// Lightest solid that a block may be made of without a word, kg/m3.
const LIGHTEST: f64 = 20.0;

/// Values that differ by less than this share are the same, written in other units: 700 ms are 0.7000000000000001 s.
const SAME: f64 = 1e-9;

/// Whether one value is larger than another, and not only by the rounding of their units.
fn above(value: f64, other: f64) -> bool {
    value - other > SAME * value.abs().max(other.abs())
}

struct Rules {
    found: Vec<Diagnostic>,
    space: InSpace,
    values_sound: bool,
}

impl Rules {
    fn error(&mut self, code: &'static str, span: &Span, message: String, help: &str) {
        self.found.push(Diagnostic::error(code, message).at(span.clone()).help(help));
    }

    /// A whole number of things must lie in a range.
    fn count(&mut self, span: &Span, of: &str, key: &str, value: u64, low: u64, high: u64) {
        if value < low || value > high {
            let message = format!("`{key}` of {of} is {value}");
            self.error("value.range", span, message, &format!("from {low} to {high} is possible"));
        }
    }

    fn head(&mut self, scenario: &Scenario, root: &DeTable<'_>) {
        let place = |key: &str| root.get(key).map_or(0..0, toml::Spanned::span);
        if scenario.riprap != 1 {
            let message = format!("language version {} is not known", scenario.riprap);
            self.error("version", &place("riprap"), message, "write riprap = 1");
        }
        if scenario.title.trim().is_empty() {
            let help = "say in one line what the scene shows";
            self.error("title", &place("title"), "the title is empty".to_owned(), help);
        }
    }

    /// Tables without which there is no model.
    fn needed(&mut self, scenario: &Scenario) {
        let mut lacks = |code, message, help: &str| {
            self.found.push(Diagnostic::error(code, message).help(help));
        };
        if scenario.materials.is_empty() {
            let help = "add [materials.rock] with density = \"2600 kg/m3\"";
            lacks("model.empty", "there is no material", help);
        }
        if scenario.blocks.is_empty() {
            let shape = match self.space {
                InSpace::Planar => "rectangle",
                InSpace::Spatial => "brick",
            };
            let help = format!("add [[blocks]] with name, material and a shape such as {shape}");
            lacks("model.empty", "the model is empty: there are no blocks", &help);
        }
        if scenario.phases.is_empty() {
            let help = "add [[phases]] with name and until = { time = \"1 s\" }";
            lacks("model.empty", "there is no phase: nothing would happen", help);
        }
        if scenario.interfaces.get("default").is_none() {
            let help = "add [interfaces.default] with friction_angle and normal_stiffness; it is \
                        used by all pairs of materials that no other interface names";
            lacks("key.missing", "there is no [interfaces.default]", help);
        }
    }

    fn scenario(&mut self, scenario: &Scenario) {
        self.needed(scenario);
        for (name, material) in scenario.materials.iter() {
            self.density(name.as_str(), &material.density);
        }
        for (name, interface) in scenario.interfaces.iter() {
            self.interface(name, interface, scenario);
        }
        for block in &scenario.blocks {
            self.block(block);
            self.deformable(block, scenario);
        }
        for (_, group) in scenario.groups.iter() {
            self.group(group);
        }
        self.ground(scenario);
        self.sources(scenario);
        self.bolts(scenario);
        for notch in &scenario.notches {
            self.region(&notch.region);
        }
        for support in &scenario.supports {
            self.support(support);
        }
        for load in &scenario.loads {
            self.load(load);
        }
        self.water(scenario);
        for phase in &scenario.phases {
            self.phase(phase);
        }
        if self.space == InSpace::Planar {
            self.clip_speeds(scenario);
        }
        for output in &scenario.outputs {
            if let Output::History(history) = output {
                self.name(&history.name, "a history");
            }
        }
        if let Some(bisect) = &scenario.bisect {
            self.bisect(bisect);
        }
        self.samples(scenario);
        for check in &scenario.checks {
            self.check(check);
        }
    }

    fn bisect(&mut self, bisect: &Bisect) {
        let ends = [&bisect.low, &bisect.high, &bisect.tolerance];
        let [low, high, width] = ends.map(Quantity::si);
        if self.values_sound && (low == high || width <= 0.0) {
            let span = &bisect.tolerance.span;
            let message = "there is nothing to search between these ends".to_owned();
            let help = "`low` and `high` must differ and `tolerance` be greater than zero";
            self.error("value.order", span, message, help);
        }
        if self.values_sound {
            self.same_dimension(&ends, "bisect");
        }
        self.criterion(&bisect.fails_when);
    }

    /// A number in other units reads as a density that no solid has.
    fn density(&mut self, name: &str, density: &Quantity<Density>) {
        let given = density.si();
        if self.values_sound && given < LIGHTEST {
            let message = format!(
                "`{name}` has a density of \"{}\", less than any rock, brick or foam",
                density.raw
            );
            let warning = Diagnostic::warning("value.unlikely", message).at(density.span.clone());
            let help = "rock has 2000 to 3000 kg/m3; a density in g/cm3 is written with that unit";
            self.found.push(warning.help(help));
        }
    }

    fn name(&mut self, name: &Name, of: &str) {
        let length = name.text.chars().count();
        if name.text.trim().is_empty() || length > 200 || name.text.chars().any(char::is_control) {
            let message = format!("the name of {of} is empty, too long or has control characters");
            self.error("name.form", &name.span, message, "give a short name");
        }
    }

    /// The first value must not be larger (or must be smaller) than the second.
    fn in_order<K: Kind>(
        &mut self,
        low: &Quantity<K>,
        high: &Quantity<K>,
        may_be_equal: bool,
        help: &str,
    ) {
        let (first, second) = (low.si(), high.si());
        // Not `SAME`: places far from the origin may lie nearer to each other.
        let round = 4.0 * f64::EPSILON * first.abs().max(second.abs());
        let wrong = if may_be_equal { first - second > round } else { second - first <= round };
        if self.values_sound && wrong {
            let than = if may_be_equal { "is larger than" } else { "is not less than" };
            let message = format!("\"{}\" {than} \"{}\"", low.raw, high.raw);
            self.error("value.order", &high.span, message, help);
        }
    }

    fn formula(&mut self, formula: &Name, known: &[&str]) {
        if let Err(error) = read_formula(formula, known) {
            self.found.push(error);
        }
    }

    fn same_dimension<K: Kind>(&mut self, quantities: &[&Quantity<K>], of: &str) {
        let mut first: Option<Dim> = None;
        for quantity in quantities {
            let Ok((_, Some(dim))) = quantity.read() else {
                continue;
            };
            if first.is_some_and(|first| first != dim) {
                let message = format!("the values of `{of}` have different dimensions");
                self.error(
                    "unit.dimension",
                    &quantity.span,
                    message,
                    "give them all the same kind of unit",
                );
                return;
            }
            first = Some(dim);
        }
    }
}

/// A formula of the scene; `known` lists the names that it may use.
///
/// # Errors
/// What is wrong with it, at its place.
pub fn read_formula(text: &Name, known: &[&str]) -> Result<Formula, Diagnostic> {
    Formula::new(text.as_str(), known).map_err(|error| {
        let place = error.at().map_or(text.span.clone(), |at| text.place(at));
        Diagnostic::error("formula", error.to_string())
            .at(place)
            .help(format!(
                "for example \"0.5*g*t^2\" or \"if(t < 2, 1, 0)\"; functions: {FUNCTIONS}; `pi` and `deg` are known, angles \
                 are in radians"
            ))
    })
}

/// The place of a target.
#[must_use]
pub fn target_span(target: &Target) -> Span {
    match target {
        Target::Block(name) | Target::Group(name) => name.span.clone(),
        Target::Blocks(names) => names.first().map_or(0..0, |name| name.span.clone()),
        Target::Box(region) => region.min.span.clone(),
        Target::Nodes(nodes) => nodes.min.span.clone(),
    }
}
