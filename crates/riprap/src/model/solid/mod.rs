//! Models in space: from `[space.spatial]` to `spatial::setup::Setup`.
//!
//! ```text
//! fit grids to charges --> origin --> blocks --> groups --> joints --> supports, boundaries, loads, bolts
//!                                            --> in-situ stress --> sources --> refinements
//! ```
//!
//! Splitting, patches and free faces are the engine's: what is looked at here is the model as it is
//! given, and the finest cells around charges.

mod bodies;
mod boundaries;
mod cut;
mod deform;
mod fit;
mod glued;
mod graded;
mod grid;
mod holes;
mod inspect;
mod joints;
mod masonry;
mod mesh;
mod opening;
mod pattern;
mod places;
mod pour;
mod seams;
mod shapes;
mod sources;
mod supports;
mod terrain;
mod turn;
mod wall_arch;

pub(super) use boundaries::{boundary_name, has_face};
pub(super) use joints::{change_joint, reduce_joint};
pub(super) use opening::Opening;
pub(super) use shapes::{bounds, volume};
pub(super) use turn::put_solid;

use riprap_geom::Vec3;

use super::builder::Builder;
use crate::scenario::language::{Period, Point3, Spatial, Tilt};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::{Diagnostic, Quantity};
use crate::spatial::setup::{Group, Kinematics, Material};

/// A point in the coordinates of the file.
fn global(point: &Point3) -> Vec3 {
    Vec3::new(point[0].si(), point[1].si(), point[2].si())
}

/// Three numbers with one unit, for explanations.
fn triple(v: Vec3, unit: &str) -> String {
    let parts = [v.x, v.y, v.z].map(|x| with_unit(x, unit));
    format!("[{}]", parts.join(", "))
}

impl Builder<'_> {
    /// Everything of a model in space up to the loads; whether names and sizes are known.
    pub(super) fn solid(&mut self, space: &Spatial) -> bool {
        self.solid_space(space);
        let grids = self.grids();
        if self.errors() > 0 {
            return false;
        }
        self.solid_origin(&grids);
        self.solid_materials();
        self.solid_blocks(&grids);
        if self.errors() == 0 {
            self.start_states();
        }
        if self.errors() > 0 {
            return false;
        }
        self.groups();
        self.spatial.groups = self
            .directory
            .groups()
            .into_iter()
            .map(|(name, blocks)| Group { name, blocks })
            .collect();
        self.joints();
        self.bonds();
        self.solid_supports();
        self.boundaries();
        self.in_situ();
        self.solid_loads();
        self.bolts();
        self.sources();
        self.refinements();
        self.source_volumes();
        true
    }

    /// A place of the file in local coordinates.
    pub(super) fn local(&self, [x, y, z]: [f64; 3]) -> Vec3 {
        Vec3::new(x, y, z) - self.spatial.origin
    }

    /// Gravity on a tilted table, m/s2.
    fn tilted(&mut self, gravity: Vec3, said: Option<&Tilt>) -> Vec3 {
        let Some(said) = said else { return gravity };
        let angle = said.angle.si();
        self.explain("space.spatial.tilt.angle", with_unit(angle, "rad"), Provenance::Given, "");
        let axis = said.axis.as_ref().map_or(Vec3::Y, |axis| Vec3::from(axis.xyz()));
        let Some(axis) = axis.try_normalize() else {
            let at = said.axis.as_ref().map_or(said.angle.span.clone(), |axis| axis.span.clone());
            let help = "give the axis of the table, for example axis = [0, 1, 0]";
            self.error_at("value.direction", at, "the axis of `tilt` has zero length", help);
            return gravity;
        };
        if gravity.cross(axis).length() <= 1e-9 * gravity.length() {
            let message = "gravity along the axis of `tilt` does not turn: it has no effect";
            let help = "give a level axis, for example axis = [0, 1, 0]";
            self.warn_at("tilt.axis", said.angle.span.clone(), message, help);
        }
        // Rodrigues' formula.
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        gravity * cos + axis.cross(gravity) * sin + axis * (axis.dot(gravity) * (1.0 - cos))
    }

    fn solid_space(&mut self, space: &Spatial) {
        let gravity = self.gravity(&space.gravity);
        self.spatial.gravity = self.tilted(gravity.into(), space.tilt.as_ref());
        let mut read = self.reading("space.spatial", space);
        read.gravity();
        let kinematics = read.kinematics();
        let bound = (kinematics == Kinematics::Automatic).then(|| read.rotation_bound());
        let found_contacts = read.found_contacts();
        let periods = read.periodic();
        let periods = periods.map(|periods| periods.each_ref().map(Period::read));
        self.spatial.found_contacts = found_contacts;
        self.spatial.kinematics = kinematics;
        self.spatial.rotation_bound = bound;
        if let Some(air) = &space.air {
            let mut read = self.reading("space.spatial.air", air);
            self.spatial.air = 0.5 * read.density() * read.drag();
        }
        if let Some(periods) = periods {
            self.spatial.periodic = periods;
        }
    }

    fn solid_materials(&mut self) {
        for (name, said) in self.parsed.scenario.materials.iter() {
            let density = self.reading(format!("materials.{name}"), said).density();
            self.spatial.materials.push(Material {
                name: name.text.clone(),
                density,
                young: said.young.as_ref().map(Quantity::si),
                poisson: said.poisson.as_ref().map(Quantity::si),
            });
        }
    }

    /// Far from the origin, coordinates lose digits: then the model gets an origin of its own.
    fn solid_origin(&mut self, grids: &grid::Grids) {
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for block in &self.parsed.scenario.blocks {
            for place in shapes::corners(block, grids) {
                min = min.min(place);
                max = max.max(place);
            }
        }
        let size = (max - min).max_element();
        let far = min.abs().max(max.abs()).max_element();
        if !(min.is_finite() && max.is_finite()) || far < 1e4 || far < 100.0 * size {
            return;
        }
        // A whole number of powers of two near the size: subtracting it loses no digit.
        let unit = libm::exp2(libm::floor(libm::log2(size.max(1.0))));
        self.spatial.origin = (0.5 * (min + max) / unit).round() * unit;
        let origin = self.spatial.origin;
        let message = format!(
            "the model lies far from the origin; it is computed relative to ({} m, {} m, {} m)",
            origin.x, origin.y, origin.z
        );
        let note = Diagnostic::warning("geometry.far", message);
        self.found.push(note.help("no action needed; outputs are in the coordinates of the scene"));
        self.explain("origin", triple(origin, "m"), Provenance::Derived, "distant coordinates");
    }
}
