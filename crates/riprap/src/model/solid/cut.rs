//! Blocks in space divided by joints.

use riprap_geom::polyhedron::joints::{Divided, Joint, PlaneSet, divide, normal_of_dip, planes};
use riprap_geom::{GeomError, Vec3};

use super::boundaries::has_face;
use super::global;
use super::mesh::{Made, shape_of};
use super::shapes::{bounds, solid};
use crate::model::builder::Builder;
use crate::scenario::csv_columns::csv_quantities;
use crate::scenario::language::{Block, Cut};
use crate::scenario::read::Provenance;
use crate::scenario::units::Dim;
use crate::scenario::{Diagnostic, Name};

/// Most joints one by one.
const MOST_JOINTS: usize = 20_000;

impl Builder<'_> {
    /// What joints make of the blocks of a table. `shift` brings coordinates of the file to the blocks. `None` after an
    /// error.
    pub(super) fn divide(
        &mut self,
        block: &Block,
        cut: &Cut,
        made: Made,
        shift: Vec3,
    ) -> Option<Made> {
        let key = format!("blocks.{}.cut", block.name);
        let mut read = self.reading(key.as_str(), cut);
        let seed = read.seed();
        let thinnest = read.smallest_edge_or(0.0, Provenance::Default, "");
        let sets: Vec<PlaneSet> = (0..)
            .zip(&cut.joint_sets)
            .map(|(number, set)| {
                let mut read = read.within(&format!("joint_sets.{number}"), set);
                let direction = read.dip_direction().unwrap_or(0.0);
                let normal = normal_of_dip(read.dip(), direction);
                let at = set.origin.as_ref().map_or(Vec3::ZERO, global) + shift;
                PlaneSet {
                    normal,
                    at: at + read.offset() * normal,
                    spacing: read.spacing(),
                    spacing_scatter: read.spacing_scatter(),
                    angle_scatter: read.angle_scatter(),
                }
            })
            .collect();
        let mut joints = match &cut.joints {
            Some(said) => self.joints_of_csv(&said.csv, shift)?,
            None => Vec::new(),
        };
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let boxes = made.shapes.iter().map(bounds);
        let (min, max) = boxes.fold(start, |(a, b), (min, max)| (a.min(min), b.max(max)));
        let solids = made.shapes.iter().map(solid).collect();
        let divided = planes(&sets, min, max, seed).and_then(|more| {
            joints.extend(more);
            divide(solids, &joints, thinnest)
        });
        match divided {
            Ok(divided) => {
                let why = format!(
                    "{} joints; {} cuts spared because a part would be too thin",
                    joints.len(),
                    divided.spared
                );
                let count = divided.solids.len().to_string();
                self.explain(format!("{key}.blocks"), count, Provenance::Derived, &why);
                Some(handed_on(made, divided))
            }
            Err(error) => {
                let help = match error {
                    GeomError::TooMany { .. } => "make the spacing larger, or the blocks smaller",
                    _ => "change the value",
                };
                let message = format!("block `{}`: {error}", block.name);
                self.error_at("geometry.joints", &block.name, message, help);
                None
            }
        }
    }

    /// Joints one by one in local coordinates; `None` after an error.
    fn joints_of_csv(&mut self, file: &Name, shift: Vec3) -> Option<Vec<Joint>> {
        let path = self.parsed.folder.join(file.as_str());
        let needed = [
            ("x", Dim::LENGTH),
            ("y", Dim::LENGTH),
            ("z", Dim::LENGTH),
            ("dip", Dim::ANGLE),
            ("dip_direction", Dim::ANGLE),
        ];
        let columns = match csv_quantities(&path, &needed, &[("radius", Dim::LENGTH)]) {
            Ok(columns) => columns,
            Err(error) => {
                let mut found = Diagnostic::error("file.csv", error.message);
                found.help = error.help;
                self.found.push(found.at(file.span.clone()));
                return None;
            }
        };
        let of = |column: usize, row: usize| {
            let column = columns.get(column).and_then(Option::as_ref);
            column.and_then(|c| c.get(row).copied())
        };
        let count = columns.first().and_then(Option::as_ref).map_or(0, Vec::len);
        if count > MOST_JOINTS {
            let message = format!("`{file}` has {count} joints");
            let help =
                format!("at most {MOST_JOINTS} joints one by one; use `joint_sets` for more");
            self.error_at("file.csv", file, message, &help);
            return None;
        }
        let mut joints = Vec::with_capacity(count);
        for row in 0..count {
            let number = |column: usize| of(column, row).unwrap_or(0.0);
            let radius = of(5, row).filter(|radius| *radius != 0.0);
            if radius.is_some_and(|radius| radius < 0.0) {
                let message = format!("`{file}`: joint {} has a negative radius", row + 1);
                self.error_at("file.csv", file, message, "0 or no radius is a plane");
                return None;
            }
            joints.push(Joint {
                normal: normal_of_dip(number(3), number(4)),
                at: Vec3::new(number(0), number(1), number(2)) + shift,
                radius,
            });
        }
        Some(joints)
    }
}

/// The parts with the groups and surfaces of the blocks they come from.
fn handed_on(made: Made, divided: Divided) -> Made {
    let mut children: Vec<Vec<u32>> = vec![Vec::new(); made.shapes.len()];
    for (part, parent) in (0u32..).zip(&divided.parents) {
        children[*parent as usize].push(part);
    }
    let of = |blocks: Vec<u32>| -> Vec<u32> {
        let parts = blocks.iter().flat_map(|b| &children[*b as usize]);
        parts.copied().collect()
    };
    let shapes: Vec<_> = divided.solids.into_iter().map(shape_of).collect();
    let groups = made.groups.into_iter();
    let groups = groups.map(|(name, blocks)| (name, of(blocks)));
    let mut surfaces = Vec::with_capacity(made.surfaces.len());
    for (name, faces) in made.surfaces {
        let mut own = Vec::with_capacity(faces.len());
        for (block, normal, offset) in faces {
            let parts = children[block as usize].iter();
            let there = parts.filter(|p| has_face(&shapes[**p as usize], normal, offset));
            own.extend(there.map(|p| (*p, normal, offset)));
        }
        surfaces.push((name, own));
    }
    let groups = groups.collect();
    Made {
        shapes,
        groups,
        surfaces,
    }
}
