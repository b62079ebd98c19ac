//! The order in which a model is made, and the blocks of the plane.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::{Vec2, polygon};

use super::assertions::{LIMIT, PROBABILITY};
use super::builder::Builder;
use super::generated::Generated;
use super::names::{Directory, Entry};
use super::summary::Summary;
use super::{Model, inspect};
use crate::plan::{Check, Plan};
use crate::planar::setup::{BlockSpec, Group, Setup};
use crate::record::field::FieldInfo;
use crate::scenario::language::{Block, Planar, Space};
use crate::scenario::quantity::{Axial, Moments};
use crate::scenario::read::Provenance;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Diagnostics, Parsed, Quantity};
use crate::spatial::setup as spatial;

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
        space: match parsed.scenario.space {
            Space::Planar(_) => InSpace::Planar,
            Space::Spatial(_) => InSpace::Spatial,
        },
        origin: Vec2::ZERO,
        setup: Setup::default(),
        spatial: spatial::Setup::default(),
        fitted_levels: BTreeMap::new(),
        plan: Plan { title: parsed.scenario.title.clone(), ..Plan::default() },
        directory: Directory::default(),
        drawn: BTreeMap::new(),
        profiles: BTreeMap::new(),
        surfaces: BTreeMap::new(),
        sets: BTreeMap::new(),
        found: parsed.warnings.clone(),
        explained: Vec::new(),
        summary: Summary::default(),
    };
    let sound = match &parsed.scenario.space {
        Space::Planar(space) => b.planar(space),
        Space::Spatial(space) => b.solid(space),
    };
    let (mut checks, mut bisect, mut monte_carlo) = (Vec::new(), None, None);
    if sound {
        b.water();
        b.phases();
        b.reduce_strength();
        b.outputs();
        b.controls();
        let (of_limit, others): (Vec<Check>, Vec<Check>) =
            b.checks().into_iter().partition(|c| c.gauge.field == LIMIT);
        let (of_samples, of_run) = others.into_iter().partition(|c| c.gauge.field == PROBABILITY);
        checks = of_run;
        bisect = b.bisect(of_limit);
        monte_carlo = b.monte_carlo(of_samples);
        if b.errors() == 0 {
            b.inspect();
        }
    }
    let diagnostics = Diagnostics::new(parsed.source.clone(), b.found);
    if diagnostics.errors() > 0 {
        return Err(diagnostics);
    }
    // What several tables name (an explosive of many charges) is read for each of them.
    let mut told = BTreeSet::new();
    b.explained.retain(|line| told.insert(line.key.clone()));
    Ok(Model {
        setup: match b.space {
            InSpace::Planar => b.setup.into(),
            InSpace::Spatial => b.spatial.into(),
        },
        plan: b.plan,
        checks,
        bisect,
        monte_carlo,
        explained: b.explained,
        summary: b.summary,
        warnings: diagnostics.list,
    })
}

impl Builder<'_> {
    /// Looks at a model without errors for what is probably not meant.
    fn inspect(&mut self) {
        self.unused();
        self.loose();
        self.dry_tables();
        match self.space {
            InSpace::Planar => {
                inspect::inspect(self);
                self.stress_balance();
            }
            InSpace::Spatial => {
                self.unused_in_space();
                self.inspect_solid();
            }
        }
    }

    /// Everything of the plane up to the loads; whether names and sizes are known.
    fn planar(&mut self, space: &Planar) -> bool {
        self.planar_gravity(space);
        self.setup.thickness = space.thickness.as_ref().map(Quantity::si);
        self.draw();
        self.find_origin();
        self.blocks();
        if self.errors() == 0 {
            self.start_states();
        }
        // Names and sizes of blocks that could not be made would only give follow-up errors.
        if self.errors() > 0 {
            return false;
        }
        self.groups();
        self.setup.groups = self
            .directory
            .groups()
            .into_iter()
            .map(|(name, blocks)| Group { name, blocks })
            .collect();
        self.supports();
        self.interfaces();
        self.loads();
        self.in_situ();
        self.bolts();
        true
    }

    fn planar_gravity(&mut self, planar: &Planar) {
        let mut read = self.reading("space.planar", planar);
        let [x, y] = read.gravity().each_ref().map(Quantity::si);
        let tilt = read.tilt();
        let (sin, cos) = (libm::sin(tilt), libm::cos(tilt));
        self.setup.gravity = [x * cos + y * sin, y * cos - x * sin];
    }

    /// Far from the origin, coordinates lose digits: then the model gets an origin of its own.
    fn find_origin(&mut self) {
        let mut points: Vec<Vec2> = Vec::new();
        for block in &self.parsed.scenario.blocks {
            let shift = block.shift.as_ref().map_or(Vec2::ZERO, |s| s.xy().into());
            let drawn = self.drawn.get(block.name.as_str());
            let drawn = drawn.iter().flat_map(|d| d.outlines.iter().flatten().copied());
            points.extend(super::blocks::places(block).into_iter().chain(drawn).map(|p| p + shift));
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
            "the model lies far from the origin; it is computed relative to ({x} m, {y} m)"
        );
        let note = Diagnostic::warning("geometry.far", message);
        self.found.push(note.help("no action needed; outputs are in the coordinates of the scene"));
        self.explain(
            "origin",
            format!("[{x} m, {y} m]"),
            Provenance::Derived,
            "distant coordinates",
        );
    }

    fn blocks(&mut self) {
        let scenario = &self.parsed.scenario;
        self.setup.materials = scenario.materials.names().map(str::to_owned).collect();
        for (name, material) in scenario.materials.iter() {
            let density = self.reading(format!("materials.{name}"), material).density();
            self.setup.densities.push(density);
        }
        for block in &scenario.blocks {
            let Some(generated) = self.generate(block) else {
                continue;
            };
            self.enter(block, generated);
        }
        if self.setup.blocks.is_empty() && self.errors() == 0 {
            let message = "the model has no blocks";
            self.found.push(Diagnostic::error("model.empty", message));
        }
    }

    /// Adds the blocks of one table to the setup.
    fn enter(&mut self, block: &Block, generated: Generated) {
        let scenario = &self.parsed.scenario;
        let material = scenario.materials.names().position(|name| name == block.material.as_str());
        let density = scenario.materials.get(block.material.as_str()).map(|m| m.density.si());
        let (Some(material), Some(density)) = (material, density) else {
            let known: Vec<&str> = scenario.materials.names().collect();
            self.found.push(Diagnostic::unknown("material", &block.material, known));
            return;
        };
        let entry = Entry {
            name: block.name.text.clone(),
            first: self.setup.blocks.len() as u32,
            count: generated.outlines.len() as u32,
            numbered: generated.numbered,
        };
        let first = entry.first;
        self.directory.add(entry, &block.groups);
        for (name, members) in generated.groups {
            let members = members.into_iter().map(|k| first + k).collect();
            self.directory.extend(&name, members);
        }
        let velocity = block.velocity.as_ref().map_or(Vec2::ZERO, |v| v.xy().into());
        let spin = block.spin.as_ref().and_then(Axial::single).unwrap_or(0.0);
        if let Some(mass) = &block.mass {
            self.explain(
                format!("blocks.{}.mass", block.name),
                mass.raw.to_string(),
                Provenance::Given,
                "in place of density times area",
            );
        }
        // Copies and poured blocks are stones of their own, everything else that a table makes spins as one body.
        let loose = block.copies.is_some() || block.pour.is_some();
        let one = !loose && generated.outlines.len() > 1 && spin != 0.0;
        let about = one.then(|| common_centroid(&generated.outlines));
        for vertices in generated.outlines {
            let number = self.setup.blocks.len() as u32;
            let moments = polygon::mass_properties(&vertices);
            let centroid = moments.centroid;
            let swing = about.map_or(Vec2::ZERO, |about| spin * (centroid - about).perp());
            let density = block.mass.as_ref().map_or(density, |m| m.si() / moments.area);
            if let Some(inertia) = block.inertia.as_ref().and_then(Moments::single) {
                self.setup.inertias.push((number, inertia));
            }
            self.directory.centroids.push([centroid.x, centroid.y, 0.0]);
            self.setup.blocks.push(BlockSpec {
                name: self.directory.name(number),
                vertices,
                material: material as u16,
                density,
                velocity: velocity + swing,
                spin,
            });
        }
        self.summary.regions.extend(generated.region);
    }
}

/// Centroid of the areas of outlines, m.
fn common_centroid(outlines: &[Vec<Vec2>]) -> Vec2 {
    let (mut sum, mut all) = (Vec2::ZERO, 0.0);
    for outline in outlines {
        let of = polygon::mass_properties(outline);
        sum += of.area * of.centroid;
        all += of.area;
    }
    sum / all
}
