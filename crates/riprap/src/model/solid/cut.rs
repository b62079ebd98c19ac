//! Blocks in space divided by joints.

use riprap_geom::polyhedron::joints::{Divided, Joint, PlaneSet, divide, normal_of_dip, planes};
use riprap_geom::{GeomError, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

use super::boundaries::has_face;
use super::global;
use super::mesh::{Made, shape_of};
use super::shapes::{bounds, solid};
use crate::model::builder::Builder;
use crate::scenario::csv_columns::{Column, Found, csv_table};
use crate::scenario::language::{Block, Cut};
use crate::scenario::read::Provenance;
use crate::scenario::units::Dim;
use crate::scenario::{Diagnostic, Name};

/// Most joints one by one.
const MOST_JOINTS: usize = 20_000;

/// Columns of a list of joints; what programs that make networks of fractures write without a unit is in m and degrees.
const COLUMNS: [Column; 10] = [
    length(&["x", "center_x", "centre_x", "x_center", "x_centre"]),
    length(&["y", "center_y", "centre_y", "y_center", "y_centre"]),
    length(&["z", "center_z", "centre_z", "z_center", "z_centre"]),
    length(&["radius", "equiv_radius", "equivalent_radius"]),
    length(&["diameter"]),
    angle(&["dip"]),
    angle(&["dip_direction", "dip_dir", "dip_azimuth"]),
    angle(&["strike"]),
    angle(&["trend", "pole_trend"]),
    angle(&["plunge", "pole_plunge"]),
];

const fn length(names: &'static [&'static str]) -> Column<'static> {
    Column {
        names,
        dim: Dim::LENGTH,
        bare: Some("m"),
    }
}

const fn angle(names: &'static [&'static str]) -> Column<'static> {
    Column {
        names,
        dim: Dim::ANGLE,
        bare: Some("deg"),
    }
}

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
                self.note_intensity(block, &divided);
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

    /// Tells the area of joints per volume (P32), measured on the cuts that were made.
    fn note_intensity(&mut self, block: &Block, divided: &Divided) {
        let volume: f64 = divided.solids.iter().map(|s| s.moments().volume).sum();
        let [all, within] = [divided.area, divided.within].map(|area| area / volume);
        let mut words = format!("{}: P32 {within:.3} m2/m3 by joints", block.name);
        if all - within > 1e-9 * all {
            let beyond = all - within;
            words.push_str(&format!(
                ", and {beyond:.3} where joints that end in a block were carried on to its faces"
            ));
        }
        self.summary.joints.push(words);
    }

    /// Joints one by one in local coordinates; `None` after an error.
    fn joints_of_csv(&mut self, file: &Name, shift: Vec3) -> Option<Vec<Joint>> {
        let path = self.parsed.folder.join(file.as_str());
        let columns = match csv_table(&path, &COLUMNS) {
            Ok(columns) => columns,
            Err(error) => {
                let mut found = Diagnostic::error("file.csv", error.message);
                found.help = error.help;
                self.found.push(found.at(file.span.clone()));
                return None;
            }
        };
        self.note_usual_units(file, &columns);
        let values = columns.each_ref().map(|c| c.as_ref().map(|c| &c.values));
        let [
            x,
            y,
            z,
            radius,
            diameter,
            dip,
            direction,
            strike,
            trend,
            plunge,
        ] = values;
        let shifted = |angles: &[f64], by: f64| angles.iter().map(|a| a + by).collect();
        // Strike has the dip to its right; the pole points down.
        let (dips, directions): (Vec<f64>, Vec<f64>) = match [dip, direction, strike, trend, plunge]
        {
            [Some(dip), Some(direction), ..] => (dip.clone(), direction.clone()),
            [Some(dip), _, Some(strike), ..] => (dip.clone(), shifted(strike, FRAC_PI_2)),
            [.., Some(trend), Some(plunge)] => {
                let dips = plunge.iter().map(|p| FRAC_PI_2 - p).collect();
                (dips, shifted(trend, PI))
            }
            _ => {
                let message = format!("`{file}` does not say how its joints lie");
                let help = "give columns dip_deg and dip_direction_deg; or dip_deg and strike_deg (the dip is to its right); or \
                            trend_deg and plunge_deg of the pole";
                self.error_at("file.csv", file, message, help);
                return None;
            }
        };
        let (Some(x), Some(y), Some(z)) = (x, y, z) else {
            let message = format!("`{file}` does not say where its joints are");
            self.error_at("file.csv", file, message, "give columns x_m, y_m and z_m");
            return None;
        };
        let count = x.len();
        if count > MOST_JOINTS {
            let message = format!("`{file}` has {count} joints");
            let help =
                format!("at most {MOST_JOINTS} joints one by one; use `joint_sets` for more");
            self.error_at("file.csv", file, message, &help);
            return None;
        }
        let mut joints = Vec::with_capacity(count);
        for row in 0..count {
            let given = match (radius, diameter) {
                (Some(radius), _) => radius[row],
                (None, Some(diameter)) => 0.5 * diameter[row],
                (None, None) => 0.0,
            };
            let (dip, direction) = (dips[row], directions[row]);
            let wrong = match (given < 0.0, (0.0..=FRAC_PI_2).contains(&dip)) {
                (true, _) => Some(("has a negative radius", "0 or no radius is a plane")),
                (_, false) => Some((
                    "has a dip that no plane has",
                    "a dip is from 0 deg (flat) to 90 deg (vertical)",
                )),
                _ => None,
            };
            if let Some((what, help)) = wrong {
                let message = format!("`{file}`: joint {} {what}", row + 1);
                self.error_at("file.csv", file, message, help);
                return None;
            }
            joints.push(Joint {
                normal: normal_of_dip(dip, direction),
                at: Vec3::new(x[row], y[row], z[row]) + shift,
                radius: Some(given).filter(|radius| *radius > 0.0),
            });
        }
        Some(joints)
    }

    /// Tells which columns name no unit, and what was taken.
    fn note_usual_units(&mut self, file: &Name, columns: &[Option<Found>; COLUMNS.len()]) {
        for (unit, dim) in [("m", Dim::LENGTH), ("deg", Dim::ANGLE)] {
            let bare = columns.iter().zip(&COLUMNS).filter(|(found, column)| {
                column.dim == dim && found.as_ref().is_some_and(|found| found.bare)
            });
            let names: Vec<&str> = bare.map(|(_, column)| column.names[0]).collect();
            if !names.is_empty() {
                let names = names.join(", ");
                let words = format!("{file}: {names} without a unit, read in {unit}");
                self.summary.joints.push(words);
            }
        }
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
