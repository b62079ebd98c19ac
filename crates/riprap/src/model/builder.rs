//! The order in which a model is made.

use riprap_geom::Vec2;

use super::assertions::LIMIT;
use super::blocks::Generated;
use super::explain::{Explained, Provenance, with_unit};
use super::names::{Directory, Entry};
use super::{Model, Summary, inspect};
use crate::planar::setup::{BlockSpec, Setup};
use crate::record::field::FieldInfo;
use crate::run::plan::Plan;
use crate::scenario::language::{Block, Point, Space};
use crate::scenario::quantity::Kind;
use crate::scenario::{Diagnostic, Diagnostics, Name, Parsed, Quantity, Severity};

/// What the parts of the model builder share.
pub(super) struct Builder<'a> {
    pub(super) parsed: &'a Parsed,
    pub(super) fields: &'a [FieldInfo],
    pub(super) variant: &'a str,
    pub(super) origin: Vec2,
    pub(super) setup: Setup,
    pub(super) plan: Plan,
    pub(super) directory: Directory,
    pub(super) found: Vec<Diagnostic>,
    pub(super) explained: Vec<Explained>,
    pub(super) summary: Summary,
}

/// Builds the model of one case.
///
/// `variant` is the name of the case's variant (`default` for the scene as it stands), `fields` the
/// field table of the engine, against which histories and checks are held.
///
/// # Errors
/// Everything that is wrong with it, with places in the scenario text.
pub fn build(parsed: &Parsed, variant: &str, fields: &[FieldInfo]) -> Result<Model, Diagnostics> {
    let mut b = Builder {
        parsed,
        fields,
        variant,
        origin: Vec2::ZERO,
        setup: Setup::default(),
        plan: Plan {
            title: parsed.scenario.title.clone(),
            ..Plan::default()
        },
        directory: Directory::default(),
        found: parsed.warnings.clone(),
        explained: Vec::new(),
        summary: Summary::default(),
    };
    b.space();
    b.find_origin();
    b.blocks();
    // Names and sizes of blocks that could not be made would only give follow-up errors.
    let sound = b.errors() == 0;
    if sound {
        b.setup.groups = b.directory.groups();
        b.supports();
        b.interfaces();
        b.loads();
        b.phases();
        b.reduce_strength();
        b.outputs();
    }
    let (mut checks, mut bisect) = (Vec::new(), None);
    if sound {
        let (of_limit, of_run) = b.checks().into_iter().partition(|c| c.gauge.field == LIMIT);
        checks = of_run;
        bisect = b.bisect(of_limit);
        if b.errors() == 0 {
            inspect::inspect(&mut b);
        }
    }
    let diagnostics = Diagnostics::new(parsed.source.clone(), b.found);
    if diagnostics.errors() > 0 {
        return Err(diagnostics);
    }
    Ok(Model {
        setup: b.setup.into(),
        plan: b.plan,
        checks,
        bisect,
        explained: b.explained,
        summary: b.summary,
        warnings: diagnostics.list,
    })
}

impl Builder<'_> {
    pub(super) fn errors(&self) -> usize {
        self.found
            .iter()
            .filter(|d| d.severity == Severity::Error)
            .count()
    }

    /// Keeps the value, or the reasons why there is none.
    pub(super) fn take<T>(&mut self, result: Result<T, Vec<Diagnostic>>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(reasons) => {
                self.found.extend(reasons);
                None
            }
        }
    }

    pub(super) fn explain(
        &mut self,
        key: impl Into<String>,
        value: impl Into<String>,
        from: Provenance,
        why: &str,
    ) {
        self.explained.push(Explained {
            key: key.into(),
            value: value.into(),
            from,
            why: why.to_owned(),
        });
    }

    /// SI value of a key that has a default; written down.
    pub(super) fn or<K: Kind>(
        &mut self,
        key: &str,
        given: Option<&Quantity<K>>,
        default: f64,
        unit: &str,
    ) -> f64 {
        match given {
            Some(quantity) => {
                self.explain(key, quantity.raw.to_string(), Provenance::Given, "");
                quantity.si()
            }
            None => {
                self.explain(key, with_unit(default, unit), Provenance::Default, "");
                default
            }
        }
    }

    /// A point in local coordinates.
    pub(super) fn point(&self, point: &Point) -> Vec2 {
        global(point) - self.origin
    }

    fn space(&mut self) {
        let Space::Planar(planar) = &self.parsed.scenario.space;
        let [x, y] = [planar.gravity[0].si(), planar.gravity[1].si()];
        let raw = format!("[{}, {}]", planar.gravity[0].raw, planar.gravity[1].raw);
        self.explain("space.planar.gravity", raw, Provenance::Given, "");
        let tilt = self.or("space.planar.tilt", planar.tilt.as_ref(), 0.0, "deg");
        let (sin, cos) = (libm::sin(tilt), libm::cos(tilt));
        self.setup.gravity = [x * cos + y * sin, y * cos - x * sin];
    }

    /// Far from the origin, coordinates lose digits: then the model gets an origin of its own.
    fn find_origin(&mut self) {
        let mut points: Vec<Vec2> = Vec::new();
        for block in &self.parsed.scenario.blocks {
            let shift = block.shift.as_ref().map_or(Vec2::ZERO, global);
            points.extend(super::blocks::places(block).into_iter().map(|p| p + shift));
        }
        let bounds = riprap_geom::polygon::Aabb::of(&points);
        let far = bounds.min.abs().max(bounds.max.abs()).max_element();
        let size = bounds.size();
        if points.is_empty() || !size.is_finite() || far < 1e4 || far < 100.0 * size {
            return;
        }
        // A whole number of powers of two near the size: subtracting it loses no digit.
        let unit = libm::exp2(libm::floor(libm::log2(size.max(1.0))));
        self.origin = (bounds.centre() / unit).round() * unit;
        self.setup.origin = self.origin.into();
        let [x, y] = self.setup.origin;
        let message = format!(
            "the model lies far from the origin: it is calculated relative to ({x} m, {y} m)"
        );
        let note = Diagnostic::warning("geometry.far", message);
        self.found
            .push(note.help("nothing to do: outputs are in the coordinates of the file"));
        self.explain(
            "origin",
            format!("[{x} m, {y} m]"),
            Provenance::Derived,
            "far coordinates",
        );
    }

    fn blocks(&mut self) {
        let scenario = &self.parsed.scenario;
        self.setup.materials = scenario.materials.names().map(str::to_owned).collect();
        for (name, material) in scenario.materials.iter() {
            let density = material.density.raw.to_string();
            self.explain(
                format!("materials.{name}.density"),
                density,
                Provenance::Given,
                "",
            );
        }
        for block in &scenario.blocks {
            let Some(generated) = self.generate(block) else {
                continue;
            };
            self.enter(block, generated);
        }
        if self.setup.blocks.is_empty() && self.errors() == 0 {
            let message = "the model is empty: no block was made";
            self.found.push(Diagnostic::error("model.empty", message));
        }
    }

    /// Adds the blocks of one table to the setup.
    fn enter(&mut self, block: &Block, generated: Generated) {
        let scenario = &self.parsed.scenario;
        let material = scenario
            .materials
            .names()
            .position(|name| name == block.material.as_str());
        let density = scenario
            .materials
            .get(block.material.as_str())
            .map(|m| m.density.si());
        let (Some(material), Some(density)) = (material, density) else {
            let message = format!("there is no material `{}`", block.material);
            let mut error = Diagnostic::error("name.unknown", message);
            let known: Vec<&str> = scenario.materials.names().collect();
            error.help = crate::scenario::diagnostic::suggest(block.material.as_str(), known);
            self.found.push(error.at(block.material.span.clone()));
            return;
        };
        let entry = Entry {
            name: block.name.text.clone(),
            first: self.setup.blocks.len() as u32,
            count: generated.outlines.len() as u32,
            numbered: generated.numbered,
        };
        let names = self.directory.add(entry, &block.groups);
        let velocity = block
            .velocity
            .as_ref()
            .map_or(Vec2::ZERO, |v| Vec2::new(v[0].si(), v[1].si()));
        let spin = block.spin.as_ref().map_or(0.0, Quantity::si);
        for (name, vertices) in names.into_iter().zip(generated.outlines) {
            self.setup.blocks.push(BlockSpec {
                name,
                vertices,
                material: material as u16,
                density,
                velocity,
                spin,
            });
        }
        self.summary.regions.extend(generated.region);
    }

    /// An error at a name.
    pub(super) fn error_at(
        &mut self,
        code: &'static str,
        name: &Name,
        message: String,
        help: &str,
    ) {
        self.found.push(
            Diagnostic::error(code, message)
                .at(name.span.clone())
                .help(help),
        );
    }
}

/// A point in the coordinates of the file.
pub(super) fn global(point: &Point) -> Vec2 {
    Vec2::new(point[0].si(), point[1].si())
}
