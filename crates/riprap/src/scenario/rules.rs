//! What the schema cannot say about one table: exactly one of several keys, keys that need each
//! other, numbers that must be in order. References between tables are in [`super::references`].

use toml::de::DeTable;

use super::diagnostic::{Diagnostic, list};
use super::language::{
    Block, Check, Copies, Criterion, Cut, EdgeLoad, FrictionLaw, Geometry, Interface, Load, Motion,
    NormalLaw, Output, Phase, Polygon, Reduce, Scenario, Support, Target,
};
use super::quantity::{Kind, Name, Quantity, Span};
use super::references;
use super::time_function::TimeFunction;
use super::units::Dim;
use crate::dynamics::Formula;

/// Most blocks that one generator may make.
const MAX_BLOCKS: u64 = 1_000_000;

/// What is wrong beyond keys and values. `values_sound`: no quantity was refused, so that numbers
/// may be compared.
pub(super) fn check(
    scenario: &Scenario,
    root: &DeTable<'_>,
    values_sound: bool,
) -> Vec<Diagnostic> {
    let mut rules = Rules {
        found: Vec::new(),
        values_sound,
    };
    rules.head(scenario, root);
    rules.scenario(scenario);
    references::check(scenario, root, &mut rules.found);
    rules.found
}

struct Rules {
    found: Vec<Diagnostic>,
    values_sound: bool,
}

impl Rules {
    fn error(&mut self, code: &'static str, span: &Span, message: String, help: &str) {
        self.found
            .push(Diagnostic::error(code, message).at(span.clone()).help(help));
    }

    /// Exactly one of the keys must be there.
    fn one_of(&mut self, span: &Span, of: &str, keys: &[(&str, bool)]) {
        let given: Vec<&str> = keys
            .iter()
            .filter(|(_, there)| *there)
            .map(|(k, _)| *k)
            .collect();
        let all: Vec<&str> = keys.iter().map(|(key, _)| *key).collect();
        match given.len() {
            1 => {}
            0 => {
                let help = format!("give one of {}", list(&all));
                let message = format!("{of} needs one of {}", list(&all));
                self.error("key.one_of", span, message, &help);
            }
            _ => {
                let message = format!("{of} has {}: only one is possible", list(&given));
                self.error(
                    "key.one_of",
                    span,
                    message,
                    "keep one and remove the others",
                );
            }
        }
    }

    /// A whole number of things must lie in a range.
    fn count(&mut self, span: &Span, of: &str, key: &str, value: u64, low: u64, high: u64) {
        if value < low || value > high {
            let message = format!("`{key}` of {of} is {value}");
            self.error(
                "value.range",
                span,
                message,
                &format!("from {low} to {high} is possible"),
            );
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
            self.error(
                "title",
                &place("title"),
                "the title is empty".to_owned(),
                help,
            );
        }
    }

    fn scenario(&mut self, scenario: &Scenario) {
        if scenario.materials.is_empty() {
            self.found.push(
                Diagnostic::error("model.empty", "there is no material")
                    .help("add [materials.rock] with density = \"2600 kg/m3\""),
            );
        }
        if scenario.blocks.is_empty() {
            self.found.push(
                Diagnostic::error("model.empty", "the model is empty: there are no blocks")
                    .help("add [[blocks]] with name, material and a shape such as rectangle"),
            );
        }
        if scenario.phases.is_empty() {
            self.found.push(
                Diagnostic::error("model.empty", "there is no phase: nothing would happen")
                    .help("add [[phases]] with name and until = { time = \"1 s\" }"),
            );
        }
        if scenario.interfaces.get("default").is_none() {
            self.found.push(
                Diagnostic::error("key.missing", "there is no [interfaces.default]").help(
                    "add [interfaces.default] with friction_angle and normal_stiffness; it is \
                     used by all pairs of materials that no other interface names",
                ),
            );
        }
        for (name, interface) in scenario.interfaces.iter() {
            self.interface(name, interface, scenario);
        }
        for block in &scenario.blocks {
            self.block(block);
        }
        for support in &scenario.supports {
            self.support(support);
        }
        for load in &scenario.loads {
            self.load(load);
        }
        for phase in &scenario.phases {
            self.phase(phase);
        }
        for output in &scenario.outputs {
            if let Output::History(history) = output {
                self.name(&history.name, "a history");
            }
        }
        if let Some(bisect) = &scenario.bisect {
            let [low, high, width] =
                [&bisect.low, &bisect.high, &bisect.tolerance].map(Quantity::si);
            if self.values_sound && (low == high || width <= 0.0) {
                let span = &bisect.tolerance.span;
                let message = "there is nothing to search between these ends".to_owned();
                let help = "`low` and `high` must differ and `tolerance` be greater than zero";
                self.error("value.order", span, message, help);
            }
            if self.values_sound {
                self.same_dimension(&[&bisect.low, &bisect.high, &bisect.tolerance], "bisect");
            }
            self.criterion(&bisect.fails_when);
        }
        for check in &scenario.checks {
            self.check(check);
        }
    }

    fn name(&mut self, name: &Name, of: &str) {
        let length = name.text.chars().count();
        if name.text.trim().is_empty() || length > 200 || name.text.chars().any(char::is_control) {
            let message = format!("the name of {of} is empty, too long or has control characters");
            self.error("name.form", &name.span, message, "give a short name");
        }
    }

    fn interface(&mut self, name: &Name, interface: &Interface, scenario: &Scenario) {
        let span = &name.span;
        let of = format!("interfaces.{name}");
        match (&interface.between, name.as_str() == "default") {
            (Some([first, _]), true) => {
                let message = "interfaces.default cannot have `between`".to_owned();
                let help = "it is used by all pairs that no other interface names; call this \
                            interface otherwise";
                self.error("key.forbidden", &first.span, message, help);
            }
            (None, false) => {
                let message = format!("the key `between` is missing in {of}");
                self.error(
                    "key.missing",
                    span,
                    message,
                    "say which materials meet: between = [\"rock\", \"steel\"]",
                );
            }
            (Some(_), false) | (None, true) => {}
        }
        self.one_of(
            span,
            &of,
            &[
                ("friction_angle", interface.friction_angle.is_some()),
                (
                    "friction_coefficient",
                    interface.friction_coefficient.is_some(),
                ),
            ],
        );
        self.friction_law(
            span,
            &of,
            interface.friction_law,
            interface.clip_speed.is_some(),
        );
        if interface.reflex.is_some() && interface.law != Some(NormalLaw::PenetrationPotential) {
            let message = format!("`reflex` in {of} has no effect");
            let help = "it belongs to law = \"penetration_potential\"";
            self.found.push(
                Diagnostic::warning("key.unused", message)
                    .at(span.clone())
                    .help(help),
            );
        }
        if interface.normal_stiffness.is_none() {
            let lacking = scenario.materials.iter().find(|(material, properties)| {
                let meant = match &interface.between {
                    Some(pair) => pair.iter().any(|one| one.text == material.text),
                    None => true,
                };
                meant && (properties.young.is_none() || properties.poisson.is_none())
            });
            if let Some((material, _)) = lacking {
                let message = format!("{of} has no normal stiffness");
                let help = format!(
                    "write for example normal_stiffness = \"10 GPa/m\", or give materials.{material} \
                     `young` and `poisson`, from which it is estimated"
                );
                self.error("key.missing", span, message, &help);
            }
        }
        if let Some(points) = interface.bond.as_ref().and_then(|bond| bond.points) {
            self.count(
                span,
                &format!("{of}.bond"),
                "points",
                u64::from(points),
                1,
                8,
            );
        }
    }

    fn friction_law(&mut self, span: &Span, of: &str, law: Option<FrictionLaw>, speed: bool) {
        match (law == Some(FrictionLaw::Clipped), speed) {
            (true, false) => {
                let message = format!("the key `clip_speed` is missing in {of}");
                self.error(
                    "key.missing",
                    span,
                    message,
                    "write for example clip_speed = \"1 mm/s\"",
                );
            }
            (false, true) => {
                let message = format!("`clip_speed` in {of} has no effect");
                let help = "it belongs to friction_law = \"clipped\"";
                self.found.push(
                    Diagnostic::warning("key.unused", message)
                        .at(span.clone())
                        .help(help),
                );
            }
            (true, true) | (false, false) => {}
        }
    }

    fn block(&mut self, block: &Block) {
        let span = &block.name.span;
        let of = format!("block `{}`", super::values::short(block.name.as_str()));
        self.name(&block.name, "a block");
        let given = block.geometries();
        let all = [
            "polygon",
            "rectangle",
            "regular",
            "wall",
            "arch",
            "cut",
            "voronoi",
            "pour",
        ];
        let flags = all.map(|key| (key, given.iter().any(|(other, _)| *other == key)));
        self.one_of(span, &of, &flags);
        for (key, geometry) in given {
            self.geometry(span, &of, geometry);
            let single = match geometry {
                Geometry::Polygon(_) | Geometry::Rectangle(_) | Geometry::Regular(_) => true,
                Geometry::Wall(_)
                | Geometry::Arch(_)
                | Geometry::Cut(_)
                | Geometry::Voronoi(_)
                | Geometry::Pour(_) => false,
            };
            if let Some(Copies { count, .. }) = &block.copies {
                self.count(span, &of, "copies.count", u64::from(*count), 1, MAX_BLOCKS);
                if !single {
                    let message = format!("{of}: `{key}` cannot be copied");
                    let help = "`copies` is for polygon, rectangle and regular; write another \
                                [[blocks]] with `shift`";
                    self.error("key.forbidden", span, message, help);
                }
            }
        }
    }

    fn geometry(&mut self, span: &Span, of: &str, geometry: Geometry<'_>) {
        match geometry {
            Geometry::Polygon(Polygon::Points(points)) => self.corners(span, of, points.len()),
            Geometry::Polygon(Polygon::Csv(_)) => {}
            Geometry::Rectangle(shape) => self.one_of(
                span,
                &format!("the rectangle of {of}"),
                &[
                    ("corner", shape.corner.is_some()),
                    ("centre", shape.centre.is_some()),
                ],
            ),
            Geometry::Regular(shape) => {
                self.count(span, of, "sides", u64::from(shape.sides), 3, 1000);
            }
            Geometry::Wall(wall) => {
                let (rows, columns) = (u64::from(wall.courses), u64::from(wall.per_course));
                self.count(span, of, "courses", rows, 1, MAX_BLOCKS);
                self.count(span, of, "per_course", columns, 1, MAX_BLOCKS);
                self.count(
                    span,
                    of,
                    "courses x per_course",
                    rows * columns,
                    0,
                    MAX_BLOCKS,
                );
            }
            Geometry::Arch(arch) => {
                self.count(span, of, "voussoirs", u64::from(arch.voussoirs), 1, 100_000);
                if self.values_sound && arch.thickness.si() >= 2.0 * arch.radius.si() {
                    let message = format!("the arch of {of} is thicker than its diameter");
                    let help = "thickness must be less than twice the radius of the centre line";
                    self.error("value.order", &arch.thickness.span, message, help);
                }
            }
            Geometry::Cut(cut) => self.cut(span, of, cut),
            Geometry::Voronoi(voronoi) => {
                self.corners(span, of, voronoi.region.len());
                self.count(
                    span,
                    of,
                    "relax",
                    u64::from(voronoi.relax.unwrap_or(0)),
                    0,
                    1000,
                );
            }
            Geometry::Pour(pour) => {
                self.count(span, of, "count", u64::from(pour.count), 1, MAX_BLOCKS);
                let [low, high] = pour.vertices.unwrap_or([4, 7]);
                self.count(span, of, "vertices", u64::from(low), 3, 100);
                self.count(span, of, "vertices", u64::from(high), u64::from(low), 100);
                self.in_order(
                    &pour.size[0],
                    &pour.size[1],
                    true,
                    "`size` is [smallest, largest]",
                );
                for axis in 0..2 {
                    let [low, high] = [&pour.region[0][axis], &pour.region[1][axis]];
                    let help = "`region` is [lower left corner, upper right corner]";
                    self.in_order(low, high, false, help);
                }
            }
        }
    }

    fn corners(&mut self, span: &Span, of: &str, count: usize) {
        if count < 3 {
            let message = format!("the polygon of {of} has {count} corners");
            self.error(
                "polygon.corners",
                span,
                message,
                "a polygon has at least three corners",
            );
        }
    }

    fn cut(&mut self, span: &Span, of: &str, cut: &Cut) {
        self.corners(span, of, cut.region.len());
        if cut.joint_sets.is_empty() {
            let message = format!("{of} is cut by no joint sets");
            let help = "add joint_sets = [{ dip = \"60 deg\", spacing = \"1 m\" }]";
            self.error("key.missing", span, message, help);
        }
        for set in &cut.joint_sets {
            let partial = set.persistence.as_ref().filter(|share| share.si() < 1.0);
            if let (Some(share), None) = (partial, &set.trace_length) {
                let message =
                    "a joint set with persistence below 1 needs `trace_length`".to_owned();
                let help = "write for example trace_length = \"5 m\"";
                self.error("key.missing", &share.span, message, help);
            }
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
        if self.values_sound && (first > second || (first == second && !may_be_equal)) {
            let than = if may_be_equal {
                "is larger than"
            } else {
                "is not less than"
            };
            let message = format!("\"{}\" {than} \"{}\"", low.raw, high.raw);
            self.error("value.order", &high.span, message, help);
        }
    }

    fn support(&mut self, support: &Support) {
        let span = target_span(&support.on);
        let keys = [
            ("fixed", support.fixed.is_some()),
            ("motion", support.motion.is_some()),
        ];
        self.one_of(&span, "a support", &keys);
        let components = match &support.motion {
            Some(Motion::Velocity(motion)) => {
                self.time_function(&span, motion.x.as_ref());
                self.time_function(&span, motion.y.as_ref());
                self.time_function(&span, motion.spin.as_ref());
                motion.x.is_some() || motion.y.is_some() || motion.spin.is_some()
            }
            Some(Motion::Acceleration(motion)) => {
                self.time_function(&span, motion.x.as_ref());
                self.time_function(&span, motion.y.as_ref());
                self.time_function(&span, motion.spin.as_ref());
                motion.x.is_some() || motion.y.is_some() || motion.spin.is_some()
            }
            None => true,
        };
        if !components {
            let message = "a motion needs at least one of `x`, `y`, `spin`".to_owned();
            let help = "write for example x = { constant = \"0.1 m/s\" }";
            self.error("key.one_of", &span, message, help);
        }
    }

    fn time_function<K: Kind>(&mut self, span: &Span, function: Option<&TimeFunction<K>>) {
        match function {
            Some(TimeFunction::Formula(formula)) => self.formula(formula, &["t"]),
            Some(TimeFunction::Ramp(ramp)) => {
                let start = ramp.start.as_ref().map_or(0.0, Quantity::si);
                self.end_after(start, ramp.end.si(), &ramp.end.span);
            }
            Some(TimeFunction::Pulse(pulse)) => {
                let start = pulse.start.as_ref().map_or(0.0, Quantity::si);
                self.end_after(start, pulse.end.si(), &pulse.end.span);
            }
            Some(TimeFunction::Csv(csv)) => {
                if csv.file.as_str().is_empty() {
                    self.error(
                        "name.form",
                        span,
                        "the CSV file has no name".to_owned(),
                        "give a path",
                    );
                }
            }
            Some(TimeFunction::Constant(_) | TimeFunction::Sine(_)) | None => {}
        }
    }

    fn end_after(&mut self, start: f64, end: f64, span: &Span) {
        if self.values_sound && end <= start {
            let message = "`end` does not come after `start`".to_owned();
            self.error(
                "value.order",
                span,
                message,
                "`start` is 0 s if it is not given",
            );
        }
    }

    fn formula(&mut self, formula: &Name, known: &[&str]) {
        if let Err(error) = Formula::new(formula.as_str(), known) {
            let help = "for example \"0.5*g*t^2\"; functions: sin, cos, tan, sqrt, exp, ln, abs, \
                        ...; `pi` and `deg` are known, angles are in radians";
            self.error("formula", &formula.span, error.to_string(), help);
        }
    }

    fn load(&mut self, load: &Load) {
        let span = target_span(&load.on);
        self.one_of(
            &span,
            "a load",
            &[
                ("point", load.point.is_some()),
                ("edge", load.edge.is_some()),
                ("moment", load.moment.is_some()),
                ("body", load.body.is_some()),
            ],
        );
        if let Some(EdgeLoad {
            pressure, traction, ..
        }) = &load.edge
        {
            let keys = [
                ("pressure", pressure.is_some()),
                ("traction", traction.is_some()),
            ];
            self.one_of(&span, "an edge load", &keys);
        }
        self.time_function(&span, load.time.as_ref());
    }

    fn phase(&mut self, phase: &Phase) {
        let span = &phase.name.span;
        let of = format!("phase `{}`", super::values::short(phase.name.as_str()));
        self.name(&phase.name, "a phase");
        let until = &phase.until;
        if until.time.is_none()
            && until.unbalanced.is_none()
            && until.kinetic.is_none()
            && until.steps.is_none()
        {
            let message = format!("{of} never ends");
            let help = "give `until` at least one of `time`, `unbalanced`, `kinetic`, `steps`";
            self.error("key.one_of", span, message, help);
        }
        if until.steps == Some(0) {
            let message = format!("{of} has no steps");
            self.error("value.range", span, message, "`steps` is at least 1");
        }
        if let (Some(_), Some(safety)) = (&phase.time_step, &phase.safety) {
            self.found.push(
                Diagnostic::warning("key.unused", format!("`safety` of {of} has no effect"))
                    .at(safety.span.clone())
                    .help("it belongs to the automatic time step; here `time_step` is given"),
            );
        }
        for (name, change) in phase.interfaces.iter() {
            let of = format!("phases.{}.interfaces.{name}", phase.name);
            if let (Some(_), Some(second)) = (&change.friction_angle, &change.friction_coefficient)
            {
                let message = format!("{of} has `friction_angle` and `friction_coefficient`");
                self.error("key.one_of", &second.span, message, "keep one of them");
            }
            if change.friction_law == Some(FrictionLaw::Clipped) && change.clip_speed.is_none() {
                self.friction_law(&name.span, &of, change.friction_law, false);
            }
        }
    }

    fn criterion(&mut self, criterion: &Criterion) {
        let keys = [
            ("above", criterion.above.is_some()),
            ("below", criterion.below.is_some()),
        ];
        self.one_of(&criterion.field.span, "fails_when", &keys);
        if let Some(Reduce::FirstAbove | Reduce::ShareAbove) = criterion.reduce {
            let message = "fails_when cannot use `first_above` or `share_above`".to_owned();
            self.error(
                "value.word",
                &criterion.field.span,
                message,
                "use max, min, mean or range",
            );
        }
    }

    fn check(&mut self, check: &Check) {
        let span = &check.name.span;
        let of = format!("check `{}`", super::values::short(check.name.as_str()));
        self.name(&check.name, "a check");
        self.one_of(
            span,
            &of,
            &[
                ("value", check.value.is_some()),
                ("formula", check.formula.is_some()),
                ("csv", check.csv.is_some()),
                ("between", check.between.is_some()),
            ],
        );
        if check.at.is_some() && check.over.is_some() {
            let message = format!("{of} has `at` and `over`");
            self.error("key.one_of", span, message, "keep one of them");
        }
        if check.over.is_some() && check.reduce.is_none() {
            let message = format!("{of} has `over` without `reduce`");
            let help = "say how the values become one number, for example reduce = \"max\"";
            self.error("key.missing", span, message, help);
        }
        if let Some([first, last]) = &check.over {
            self.in_order(first, last, false, "`over` is [first time, last time]");
        }
        let needs = match check.reduce {
            Some(Reduce::FirstAbove | Reduce::ShareAbove) => true,
            Some(Reduce::Max | Reduce::Min | Reduce::Mean | Reduce::Range) | None => false,
        };
        if needs != check.threshold.is_some() {
            let message = if needs {
                format!("the key `threshold` is missing in {of}")
            } else {
                format!("{of} has a `threshold` that nothing uses")
            };
            let help = "`threshold` belongs to reduce = \"first_above\" and \"share_above\"";
            self.error("key.missing", span, message, help);
        }
        if let Some([low, high]) = &check.between {
            self.in_order(low, high, true, "`between` is [lowest, highest]");
            self.same_dimension(&[low, high], "between");
        } else if check.relative.is_none() && check.absolute.is_none() {
            let message = format!("{of} has no tolerance");
            self.error(
                "key.missing",
                span,
                message,
                "write for example relative = 1e-3",
            );
        }
        if check.known.is_some() && check.exact {
            let message = format!("{of} is exact and cannot be marked as known to fail");
            self.error(
                "key.forbidden",
                span,
                message,
                "remove `known` and mend the cause",
            );
        }
        if let Some(reason) = check
            .known
            .as_ref()
            .filter(|reason| reason.text.trim().is_empty())
        {
            let message = "a known failure needs its reason".to_owned();
            self.error(
                "name.form",
                &reason.span,
                message,
                "say in one line why it fails",
            );
        }
        let mut known = vec!["t"];
        for (name, _) in check.names.iter() {
            let plain = name
                .text
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || c == '_')
                && name.text.starts_with(|c: char| c.is_ascii_alphabetic());
            if !plain || ["t", "pi", "deg", "e", "E", "PI", "TAU"].contains(&name.as_str()) {
                let message = format!(
                    "`{}` cannot be a name in `let`",
                    super::values::short(&name.text)
                );
                let help = "use letters, digits and _; t, pi, deg, E, PI and TAU have a meaning";
                self.error("name.form", &name.span, message, help);
            }
            known.push(name.as_str());
        }
        if let Some(formula) = &check.formula {
            self.formula(formula, &known);
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

/// The place of a target.
pub(super) fn target_span(target: &Target) -> Span {
    match target {
        Target::Block(name) | Target::Group(name) => name.span.clone(),
        Target::Blocks(names) => names.first().map_or(0..0, |name| name.span.clone()),
    }
}
