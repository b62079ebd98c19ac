//! What the parts of the model builder share.

use std::collections::BTreeMap;

use riprap_geom::polyhedron::joints::Joint;
use riprap_geom::{Vec2, Vec3};

use super::generated::Drawn;
use super::names::Directory;
use super::summary::Summary;
use crate::plan::Plan;
use crate::planar::setup::Setup;
use crate::record::field::FieldInfo;
use crate::scenario::csv_columns::{Column, Table, csv_table};
use crate::scenario::language::{BoxRegion, Point, Target};
use crate::scenario::quantity::{Acceleration, Down};
use crate::scenario::read::{Explained, Provenance, Read};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Parsed, Severity, Span};
use crate::spatial::setup as spatial;

/// A model that is being made.
pub(super) struct Builder<'a> {
    pub(super) parsed: &'a Parsed,
    pub(super) fields: &'a [FieldInfo],
    pub(super) variant: &'a str,
    pub(super) space: InSpace,
    /// Global position of the local origin in the plane, m; the setup in space has its own.
    pub(super) origin: Vec2,
    /// What the planar engine is built from; empty in space.
    pub(super) setup: Setup,
    /// What the spatial engine is built from; empty in the plane.
    pub(super) spatial: spatial::Setup,
    /// Levels around charges to which a grid was fitted.
    pub(super) fitted_levels: BTreeMap<String, u8>,
    pub(super) plan: Plan,
    pub(super) directory: Directory,
    /// Polygons of files, by the name of their table, until they become blocks.
    pub(super) drawn: BTreeMap<String, Drawn>,
    /// Profiles of drawings, by what the scene says of them; `None` after an error.
    pub(super) profiles: BTreeMap<String, Option<Vec<Vec2>>>,
    /// Named faces of meshes: block, unit outward normal, distance from the local origin along it (m).
    pub(super) surfaces: BTreeMap<String, Vec<(u32, Vec3, f64)>>,
    /// The joints of each set by which the blocks of a table in space were cut, local.
    pub(super) sets: BTreeMap<String, Vec<Vec<Joint>>>,
    pub(super) found: Vec<Diagnostic>,
    pub(super) explained: Vec<Explained>,
    pub(super) summary: Summary,
}

impl Builder<'_> {
    pub(super) fn errors(&self) -> usize {
        self.found.iter().filter(|d| d.severity == Severity::Error).count()
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

    /// A table to be read.
    pub(super) fn reading<'b, T>(
        &'b mut self,
        path: impl Into<String>,
        said: &'b T,
    ) -> Read<'b, T> {
        Read::new(said, self.space, path, &mut self.explained)
    }

    /// Columns of a CSV file of the scene, and a note of what was read; `None` after an error.
    pub(super) fn table<const N: usize>(
        &mut self,
        file: &Name,
        columns: &[Column; N],
    ) -> Option<Table<N>> {
        match csv_table(&self.parsed.folder.join(file.as_str()), columns) {
            Ok(table) => {
                self.note_import(file, &table.note());
                Some(table)
            }
            Err(error) => {
                let mut found = Diagnostic::error("file.csv", error.message);
                found.help = error.help;
                self.found.push(found.at(file.span.clone()));
                None
            }
        }
    }

    /// Notes what was read of a file, once: a file may be read for several keys.
    pub(super) fn note_import(&mut self, file: &Name, words: &str) {
        let words = format!("{file}: {words}");
        if !self.summary.imports.contains(&words) {
            self.summary.imports.push(words);
        }
    }

    /// A point in local coordinates.
    pub(super) fn point(&self, point: &Point) -> Vec2 {
        global(point) - self.origin
    }

    /// Blocks whose centroid lies in a box.
    pub(super) fn inside(&self, region: &BoxRegion) -> Vec<u32> {
        let (min, max) = (self.local3(region.min.xyz()), self.local3(region.max.xyz()));
        self.directory.inside(min, max)
    }

    /// Blocks of a target, ascending.
    pub(super) fn target(&mut self, target: &Target) -> Option<Vec<u32>> {
        let names = match target {
            Target::Block(name) | Target::Group(name) => std::slice::from_ref(name),
            Target::Blocks(names) => names,
            Target::Box(region) => {
                let blocks = self.inside(region);
                if blocks.is_empty() {
                    let error =
                        Diagnostic::error("target.empty", "no block centroid lies in this box");
                    let help = "check the box and its units";
                    self.found.push(error.at(region.min.span.clone()).help(help));
                    return None;
                }
                return Some(blocks);
            }
            // Refused by the rules of the language, or taken by `node_support`.
            Target::Nodes(_) => return None,
        };
        let blocks = self.directory.all(names);
        self.take(blocks)
    }

    /// A place in local coordinates; in the plane z stays.
    pub(super) fn local3(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self.space {
            InSpace::Planar => [x - self.origin.x, y - self.origin.y, z],
            InSpace::Spatial => (Vec3::new(x, y, z) - self.spatial.origin).into(),
        }
    }

    /// Gravity as the scenario gives it.
    pub(super) fn gravity(&self, said: &Down<Acceleration>) -> [f64; 3] {
        match said.single() {
            Some(down) => [0.0, 0.0, -down],
            None => said.xyz(),
        }
    }

    /// An error at a name or another place.
    pub(super) fn error_at(
        &mut self,
        code: &'static str,
        at: impl Into<Span>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.found.push(Diagnostic::error(code, message).at(at.into()).help(help));
    }

    pub(super) fn warn_at(
        &mut self,
        code: &'static str,
        at: impl Into<Span>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.found.push(Diagnostic::warning(code, message).at(at.into()).help(help));
    }
}

/// A point in the coordinates of the file.
pub(super) fn global(point: &Point) -> Vec2 {
    Vec2::new(point[0].si(), point[1].si())
}
