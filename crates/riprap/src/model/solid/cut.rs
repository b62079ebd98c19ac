//! Blocks in space divided by joints.

use riprap_geom::polyhedron::joints::{
    Divided, Extent, Joint, PlaneSet, divide, normal_of_dip, planes,
};
use riprap_geom::{GeomError, Vec3};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::boundaries::has_face;
use super::global;
use super::mesh::{Made, shape_of};
use super::shapes::{bounds, solid};
use crate::model::builder::Builder;
use crate::numbers::counted;
use crate::scenario::Name;
use crate::scenario::csv_columns::Column;
use crate::scenario::foreign::dfn::{Network, Shape, parse_fab};
use crate::scenario::foreign::dfnworks::read_dfnworks;
use crate::scenario::foreign::itasca::parse_itasca;
use crate::scenario::language::{Block, Cut, JointPlanes, JointSet};
use crate::scenario::read::{Provenance, Read};
use crate::scenario::units::Dim;
use crate::spatial::setup::{Bridges, Ended};

/// Most joints one by one.
const MOST_JOINTS: usize = 20_000;

/// Columns of a list of joints; what programs that make networks of fractures write without a unit is in m and degrees.
const COLUMNS: [Column; 11] = [
    length(&["x", "center_x", "centre_x", "x_center", "x_centre", "easting", "east"]),
    length(&["y", "center_y", "centre_y", "y_center", "y_centre", "northing", "north"]),
    length(&["z", "center_z", "centre_z", "z_center", "z_centre", "elevation", "elev"]),
    length(&["radius", "equiv_radius", "equivalent_radius"]),
    length(&["diameter"]),
    angle(&["dip"]),
    angle(&["dip_direction", "dip_dir", "dip_dirn", "dip_azimuth", "dd"]),
    angle(&["strike"]),
    angle(&["trend", "pole_trend"]),
    angle(&["plunge", "pole_plunge"]),
    Column::optional(
        &["fracture", "fracture_id", "frac_id", "fracture_no", "polygon", "polygon_id", "id"],
        Dim::NONE,
        "",
    ),
];

const fn length(names: &'static [&'static str]) -> Column<'static> {
    Column::optional(names, Dim::LENGTH, "m")
}

const fn angle(names: &'static [&'static str]) -> Column<'static> {
    Column::optional(names, Dim::ANGLE, "deg")
}

fn joint_set(mut read: Read<'_, JointSet>, set: &JointSet, shift: Vec3) -> PlaneSet {
    let direction = read.dip_direction().unwrap_or(0.0);
    let normal = normal_of_dip(read.dip(), direction);
    let at = set.origin.as_ref().map_or(Vec3::ZERO, global) + shift;
    PlaneSet {
        normal,
        at: at + read.offset() * normal,
        spacing: read.spacing(),
        spacing_scatter: read.spacing_scatter(),
        angle_scatter: read.angle_scatter(),
        persistence: read.persistence(),
    }
}

/// Dips and dip directions (rad) by the columns dip, dip direction, strike, and trend and plunge of the pole.
fn attitudes(columns: [Option<&Vec<f64>>; 5]) -> Option<(Vec<f64>, Vec<f64>)> {
    let shifted = |angles: &[f64], by: f64| angles.iter().map(|a| a + by).collect();
    // Strike has the dip to its right; the pole points down.
    match columns {
        [Some(dip), Some(direction), ..] => Some((dip.clone(), direction.clone())),
        [Some(dip), _, Some(strike), ..] => Some((dip.clone(), shifted(strike, FRAC_PI_2))),
        [.., Some(trend), Some(plunge)] => {
            let dips = plunge.iter().map(|p| FRAC_PI_2 - p).collect();
            Some((dips, shifted(trend, PI)))
        }
        _ => None,
    }
}

/// What is wrong with the radius (m) or dip (rad) of a joint, and the remedy.
fn wrong_joint(radius: f64, dip: f64) -> Option<(&'static str, &'static str)> {
    if radius < 0.0 {
        Some(("has a negative radius", "a radius of 0, or none, means an unbounded plane"))
    } else if !(0.0..=FRAC_PI_2).contains(&dip) {
        let help = "dip ranges from 0 deg (horizontal) to 90 deg (vertical)";
        Some(("has a dip out of range", help))
    } else {
        None
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
        let sets = (0..).zip(&cut.joint_sets).map(|(number, set)| {
            joint_set(read.within(&format!("joint_sets.{number}"), set), set, shift)
        });
        let sets: Vec<PlaneSet> = sets.collect();
        let mut joints = match &cut.joints {
            Some(said) => self.joints_of_file(&key, said, shift)?,
            None => Vec::new(),
        };
        let bridges = cut.joints.as_ref().and_then(|said| said.bridges.as_ref());
        if let Some(name) = bridges {
            self.bridge(name, &joints);
        }
        // After the joints: rock is excavated that has them.
        let walls = match &cut.along {
            Some(said) => self.joints_along(said, shift)?,
            None => Vec::new(),
        };
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        // Of all blocks of the table: a plane goes on from one to the next, and must reach through all of them.
        let boxes = made.shapes.iter().map(bounds);
        let (min, max) = boxes.fold(start, |(a, b), (min, max)| (a.min(min), b.max(max)));
        let solids = made.shapes.iter().map(solid).collect();
        let divided = planes(&sets, min, max, seed).and_then(|of_sets| {
            joints.extend(of_sets.iter().flatten().cloned());
            joints.extend(walls);
            let divided = divide(solids, &joints, thinnest, seed);
            self.sets.insert(block.name.text.clone(), of_sets);
            divided
        });
        match divided {
            Ok(divided) => {
                let why = format!(
                    "{}; {} skipped because a part would be too thin",
                    counted(joints.len(), "joint"),
                    counted(divided.spared, "cut")
                );
                let count = divided.solids.len().to_string();
                self.note_intensity(block, &divided, bridges);
                self.explain(format!("{key}.blocks"), count, Provenance::Derived, &why);
                Some(handed_on(made, divided))
            }
            Err(error) => {
                let help = match error {
                    GeomError::TooMany { .. } => "use a larger spacing, or smaller blocks",
                    _ => "change the value",
                };
                let message = format!("block `{}`: {error}", block.name);
                self.error_at("geometry.joints", &block.name, message, help);
                None
            }
        }
    }

    /// Gives the parts of cuts beyond the ends of joints an interface of their own.
    fn bridge(&mut self, name: &Name, joints: &[Joint]) {
        let Some(row) = self.interface_row(name) else { return };
        let ended = joints.iter().filter_map(|joint| {
            let (radius, corners) = match &joint.extent {
                Extent::Whole | Extent::Partly(_) => return None,
                Extent::Disk(radius) => (*radius, Vec::new()),
                Extent::Polygon(corners) => {
                    let arms = corners.iter().map(|c| (*c - joint.at).length());
                    (arms.fold(0.0, f64::max), corners.clone())
                }
            };
            Some(Ended { normal: joint.normal, at: joint.at, radius, corners })
        });
        let bridges = Bridges::new(row, ended.collect());
        self.spatial.bridges.push(bridges);
    }

    /// Tells the area of joints per volume (P32), measured on the cuts that were made.
    fn note_intensity(&mut self, block: &Block, divided: &Divided, bridges: Option<&Name>) {
        let volume: f64 = divided.solids.iter().map(|s| s.moments().volume).sum();
        let [all, within] = [divided.area, divided.within].map(|area| area / volume);
        let mut words = format!("{}: P32 {within:.3} m2/m3 by joints", block.name);
        if all - within > 1e-9 * all {
            let beyond = all - within;
            words.push_str(&format!(
                ", and {beyond:.3} by joints that end inside a block, extended to its faces"
            ));
            if let Some(name) = bridges {
                words.push_str(&format!(", as rock bridges with interfaces.{name}"));
            }
        }
        if divided.spared > 0 {
            words.push_str(&format!(
                "; {} skipped because a part would be thinner than `smallest_edge`",
                counted(divided.spared, "cut")
            ));
        }
        self.summary.joints.push(words);
    }

    /// Joints one by one in local coordinates; `None` after an error.
    fn joints_of_file(&mut self, key: &str, said: &JointPlanes, shift: Vec3) -> Option<Vec<Joint>> {
        if let Some(csv) = &said.csv {
            return self.joints_of_csv(csv, shift);
        }
        let (file, network) = self.network(said)?;
        let (own, from, why) = match network.unit {
            Some(unit) => (unit, Provenance::Derived, "Length_Unit of the file"),
            None => (1.0, Provenance::Default, "the file specifies no unit"),
        };
        let key = format!("{key}.joints");
        let unit = self.reading(key, said).unit_or(own, from, why);
        let count = network.fractures.len();
        self.note_import(file, &network.note());
        if self.too_many(file, count) {
            return None;
        }
        let mut joints = Vec::with_capacity(count);
        for (shape, line) in network.fractures {
            match joint(shape, unit, shift) {
                Ok(joint) => joints.push(joint),
                Err(what) => {
                    let number = joints.len() + 1;
                    let part = network.files.first().map(|part| format!(" ({part})"));
                    let part = part.unwrap_or_default();
                    let message = format!("`{file}`{part}, line {line}: fracture {number} {what}");
                    let help = "a fracture must be a flat convex polygon with its corners in order";
                    self.error_at("file.shape", file, message, help);
                    return None;
                }
            }
        }
        Some(joints)
    }

    /// The file of a network that another program wrote, and what is in it; `None` after an error.
    fn network<'s>(&mut self, said: &'s JointPlanes) -> Option<(&'s Name, Network)> {
        if let Some(fab) = &said.fab {
            let help = "FracMan saves such a file as ASCII `.fab`";
            return Some((fab, self.foreign_file(fab, parse_fab, help)?));
        }
        if let Some(itasca) = &said.itasca {
            let help = "3DEC and PFC3D write such a file with `fracture export`";
            return Some((itasca, self.foreign_file(itasca, parse_itasca, help)?));
        }
        let file = said.dfnworks.as_ref()?;
        let help = "give polygons.dat of dfnWorks, or its radii_Final.dat with normal_vectors.dat and translations.dat in the same folder";
        let read = read_dfnworks(&self.parsed.folder.join(file.as_str()));
        Some((file, self.as_read(file, read, help)?))
    }

    fn joints_of_csv(&mut self, file: &Name, shift: Vec3) -> Option<Vec<Joint>> {
        let table = self.table(file, &COLUMNS)?;
        let values = table.columns.each_ref().map(|c| c.as_ref().map(|c| &c.values));
        let [x, y, z, radius, diameter, dip, direction, strike, trend, plunge, polygon] = values;
        let places: Option<Vec<Vec3>> = match (x, y, z) {
            (Some(x), Some(y), Some(z)) => {
                let places = x.iter().zip(y).zip(z);
                Some(places.map(|((x, y), z)| Vec3::new(*x, *y, *z) + shift).collect())
            }
            _ => None,
        };
        // A number of the fracture beside an attitude is that of a disk.
        if let (Some(polygon), Some(places), [None, None, None, None]) =
            (polygon, &places, [dip, strike, trend, plunge])
        {
            return self.polygonal_joints(file, polygon, places);
        }
        let Some((dips, directions)) = attitudes([dip, direction, strike, trend, plunge]) else {
            let message = format!("`{file}` has no columns with the orientation of the joints");
            let help = "give columns dip_deg and dip_direction_deg; or dip_deg and strike_deg (the dip is to its right); or \
                        trend_deg and plunge_deg of the pole; or fracture, its number, with a corner of a polygon in each row";
            self.error_at("file.csv", file, message, help);
            return None;
        };
        let Some(places) = places else {
            let message = format!("`{file}` has no columns with the position of the joints");
            self.error_at("file.csv", file, message, "give columns x_m, y_m and z_m");
            return None;
        };
        let count = places.len();
        if self.too_many(file, count) {
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
            if let Some((what, help)) = wrong_joint(given, dip) {
                let line = table.lines[row];
                let message = format!("`{file}`, line {line}: joint {} {what}", row + 1);
                self.error_at("file.csv", file, message, help);
                return None;
            }
            joints.push(Joint {
                normal: normal_of_dip(dip, direction),
                at: places[row],
                extent: match given > 0.0 {
                    true => Extent::Disk(given),
                    false => Extent::Whole,
                },
            });
        }
        Some(joints)
    }

    /// Joints that are polygons: the number of the fracture of each row, and a corner in each.
    fn polygonal_joints(
        &mut self,
        file: &Name,
        numbers: &[f64],
        corners: &[Vec3],
    ) -> Option<Vec<Joint>> {
        let mut places: BTreeMap<u64, usize> = BTreeMap::new();
        let mut outlines: Vec<(f64, Vec<Vec3>)> = Vec::new();
        for (number, corner) in numbers.iter().zip(corners) {
            let place = *places.entry(number.to_bits()).or_insert(outlines.len());
            if place == outlines.len() {
                outlines.push((*number, Vec::new()));
            }
            outlines[place].1.push(*corner);
        }
        if self.too_many(file, outlines.len()) {
            return None;
        }
        let mut joints = Vec::with_capacity(outlines.len());
        for (number, mut outline) in outlines {
            // Some programs write the first corner again as the last.
            if outline.len() > 3 && outline.first() == outline.last() {
                outline.pop();
            }
            match Joint::polygon(&outline) {
                Ok(joint) => joints.push(joint),
                Err(what) => {
                    let message = format!("`{file}`: fracture {number} {what}");
                    let help = "a fracture must be a flat convex polygon with its corners in order, one in each row";
                    self.error_at("file.csv", file, message, help);
                    return None;
                }
            }
        }
        Some(joints)
    }

    /// Whether a list has more joints than can be.
    fn too_many(&mut self, file: &Name, count: usize) -> bool {
        let most = count > MOST_JOINTS;
        if most {
            let message = format!("`{file}` has {count} joints");
            let help = format!(
                "at most {MOST_JOINTS} individual joints are allowed; use `joint_sets` for more"
            );
            self.error_at("file.csv", file, message, &help);
        }
        most
    }
}

/// A fracture of another program as a joint, its lengths times `unit`.
fn joint(shape: Shape, unit: f64, shift: Vec3) -> Result<Joint, &'static str> {
    let mut corners = match shape {
        Shape::Corners(corners) => corners,
        Shape::Ellipse { at, arms, corners } => {
            let corner = |k: u32| {
                let angle = TAU * f64::from(k) / f64::from(corners);
                at + libm::cos(angle) * arms[0] + libm::sin(angle) * arms[1]
            };
            (0..corners).map(corner).collect()
        }
        Shape::Disk { at, normal, radius } => {
            let (at, radius) = (unit * at + shift, unit * radius);
            if !at.is_finite() || at.abs().max_element().max(radius) > 1e150 {
                return Err("has a non-finite centre or radius");
            }
            let extent = Extent::Disk(radius);
            return Ok(Joint { normal, at, extent });
        }
    };
    for corner in &mut corners {
        *corner = unit * *corner + shift;
    }
    if corners.len() > 3 && corners.first() == corners.last() {
        corners.pop();
    }
    Joint::polygon(&corners)
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
    Made { shapes, groups, surfaces }
}
