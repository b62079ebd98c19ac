//! States of blocks at the start, from a table: place, attitude, velocity and spin by name.
//!
//! A state moves the shape that the scene draws, before joints, supports and all else look at it: blocks that lie apart by then have no joint.

use std::collections::BTreeMap;

use riprap_geom::{Quat, Vec2, Vec3};

use super::builder::Builder;
use super::solid::put_solid;
use crate::scenario::csv_columns::{Column, CsvError, csv_labels, csv_table};
use crate::scenario::diagnostic::list;
use crate::scenario::language::Start;
use crate::scenario::read::Provenance;
use crate::scenario::units::Dim;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name};

/// Farthest that the length of a quaternion of the table may be from 1: what is off by more was meant as something else.
const LENGTH: f64 = 1e-3;

/// The state of a block; `None` leaves what the scene says.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct State {
    /// Centroid, m, coordinates of the file; z is 0 in the plane.
    pub(super) place: Option<Vec3>,
    /// Against the shape of the scene; in the plane about z.
    pub(super) attitude: Option<Attitude>,
    /// m/s.
    pub(super) velocity: Option<Vec3>,
    /// rad/s; in the plane along z.
    pub(super) spin: Option<Vec3>,
}

/// Rotation of a block.
#[derive(Clone, Copy, Debug)]
pub(super) enum Attitude {
    /// In the plane, rad, anticlockwise.
    Angle(f64),
    /// In space.
    Quaternion(Quat),
}

/// Columns of one part of a state.
type Part = (&'static [&'static str], Dim, &'static str);

const PLANAR: [Part; 4] = [
    (&["x", "y"], Dim::LENGTH, "m"),
    (&["angle"], Dim::ANGLE, "rad"),
    (&["vx", "vy"], Dim::VELOCITY, "m_s"),
    (&["spin"], Dim::SPIN, "rad_s"),
];

const SPATIAL: [Part; 4] = [
    (&["x", "y", "z"], Dim::LENGTH, "m"),
    (&["qw", "qx", "qy", "qz"], Dim::NONE, ""),
    (&["vx", "vy", "vz"], Dim::VELOCITY, "m_s"),
    (&["wx", "wy", "wz"], Dim::SPIN, "rad_s"),
];

impl Builder<'_> {
    /// Puts the blocks of the table `start.csv` where it says.
    pub(super) fn start_states(&mut self) {
        let Some(Start { csv }) = &self.parsed.scenario.start else {
            return;
        };
        let Some(rows) = self.state_rows(csv) else {
            return;
        };
        let mut seen: BTreeMap<u32, usize> = BTreeMap::new();
        let (mut unknown, mut states) = (Vec::new(), Vec::new());
        for (row, (name, state)) in rows.iter().enumerate() {
            let Some(block) = self.directory.single(name) else {
                unknown.push(name.as_str());
                continue;
            };
            if let Some(first) = seen.insert(block, row) {
                let message = format!(
                    "`{csv}` has two states of the block `{name}`, in its rows {} and {}",
                    first + 1,
                    row + 1
                );
                self.error_at("file.csv", csv, message, "keep one of the rows");
                return;
            }
            states.push((block, *state));
        }
        if let [first, ..] = unknown[..] {
            let message = format!(
                "{} of the {} rows of `{csv}` name no block of this scene, `{first}` first",
                unknown.len(),
                rows.len()
            );
            let help = "the column `block` has the names of single blocks, those of a generator with their number, as `rock.3`; \
                        take the other rows out";
            self.error_at("name.unknown", csv, message, help);
            return;
        }
        let count = match self.space {
            InSpace::Planar => self.setup.blocks.len(),
            InSpace::Spatial => self.spatial.blocks.len(),
        };
        for (block, state) in &states {
            let put = match self.space {
                InSpace::Planar => self.put_outline(*block as usize, state),
                InSpace::Spatial => put_solid(self, *block as usize, state),
            };
            if !put {
                let name = self.directory.name(*block);
                let message = format!("`{csv}` has a state of `{name}`, which is terrain");
                self.error_at(
                    "file.csv",
                    csv,
                    message,
                    "terrain stays where it is: take its row out",
                );
                return;
            }
        }
        let why = format!(
            "{} blocks start by their rows, {} as the scene draws them",
            states.len(),
            count - states.len()
        );
        self.explain("start.csv", format!("\"{csv}\""), Provenance::Given, &why);
    }

    /// Names and states of the table; `None` after an error.
    fn state_rows(&mut self, csv: &Name) -> Option<Vec<(String, State)>> {
        let path = self.parsed.folder.join(csv.as_str());
        let parts = match self.space {
            InSpace::Planar => PLANAR,
            InSpace::Spatial => SPATIAL,
        };
        let read = csv_labels(&path, "block").and_then(|labels| {
            let found = parts.map(|part| of_part(&path, part));
            let [place, attitude, velocity, spin] = found;
            Ok((labels, place?, attitude?, velocity?, spin?))
        });
        let (labels, place, attitude, velocity, spin) = match read {
            Ok(read) => read,
            Err(error) => {
                let mut found = Diagnostic::error("file.csv", error.message);
                found.help = error.help;
                self.found.push(found.at(csv.span.clone()));
                return None;
            }
        };
        if [&place, &attitude, &velocity, &spin]
            .iter()
            .all(|p| p.is_none())
        {
            let columns: Vec<String> = parts.iter().flat_map(heads).collect();
            let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
            let message = format!("`{csv}` says nothing of its blocks");
            let help = format!("its columns beside `block` can be {}", list(&columns));
            self.error_at("file.csv", csv, message, &help);
            return None;
        }
        let vector = |columns: &Option<Vec<Vec<f64>>>, row: usize| {
            columns.as_ref().map(|c| {
                let part = |k: usize| c.get(k).map_or(0.0, |column| column[row]);
                Vec3::new(part(0), part(1), part(2))
            })
        };
        let mut rows = Vec::with_capacity(labels.len());
        for (row, label) in labels.into_iter().enumerate() {
            let attitude = match attitude.as_deref() {
                None => None,
                Some([angle]) => Some(Attitude::Angle(angle[row])),
                Some(parts) => {
                    let [w, x, y, z] = [0, 1, 2, 3].map(|k| parts[k][row]);
                    let quaternion = Quat::from_xyzw(x, y, z, w);
                    if (quaternion.length() - 1.0).abs() > LENGTH {
                        let message = format!(
                            "`{csv}`: the quaternion of `{label}` has the length {}",
                            quaternion.length()
                        );
                        let help = "an attitude is a unit quaternion: qw, qx, qy, qz with squares that add up to 1";
                        self.error_at("file.csv", csv, message, help);
                        return None;
                    }
                    Some(Attitude::Quaternion(quaternion.normalize()))
                }
            };
            let spin = match self.space {
                InSpace::Planar => spin.as_ref().map(|c| Vec3::new(0.0, 0.0, c[0][row])),
                InSpace::Spatial => vector(&spin, row),
            };
            let state = State {
                place: vector(&place, row),
                attitude,
                velocity: vector(&velocity, row),
                spin,
            };
            rows.push((label, state));
        }
        Some(rows)
    }

    /// Puts a block of the plane; always possible.
    fn put_outline(&mut self, block: usize, state: &State) -> bool {
        let count = self.setup.blocks.len();
        let spec = &mut self.setup.blocks[block];
        let [x, y, _] = self.directory.centroids[block];
        let centre = Vec2::new(x, y);
        if let Some(Attitude::Angle(angle)) = state.attitude {
            let (sin, cos) = libm::sincos(angle);
            for v in &mut spec.vertices {
                let arm = *v - centre;
                *v = centre + Vec2::new(cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y);
            }
            self.setup.angles.resize(count, 0.0);
            self.setup.angles[block] = angle;
        }
        if let Some(place) = state.place {
            let place = place.truncate() - self.origin;
            spec.vertices.iter_mut().for_each(|v| *v += place - centre);
            self.directory.centroids[block] = [place.x, place.y, 0.0];
        }
        if let Some(velocity) = state.velocity {
            spec.velocity = velocity.truncate();
        }
        if let Some(spin) = state.spin {
            spec.spin = spin.z;
        }
        true
    }
}

/// Heads of the columns of a part.
fn heads((names, _, unit): &Part) -> Vec<String> {
    let head = |name: &&str| match unit.is_empty() {
        true => (*name).to_owned(),
        false => format!("{name}_{unit}"),
    };
    names.iter().map(head).collect()
}

/// The columns of a part, SI, if the table has it.
fn of_part(path: &std::path::Path, part: Part) -> Result<Option<Vec<Vec<f64>>>, CsvError> {
    let (names, dim, unit) = part;
    let mut found = Vec::new();
    let mut missing = None;
    for (name, head) in names.iter().zip(heads(&part)) {
        let column = Column {
            names: &[*name],
            dim,
            bare: unit.is_empty().then_some(""),
        };
        match csv_table(path, &[column])? {
            [Some(column)] => found.push(column.values),
            [None] => missing = missing.or(Some(head)),
        }
    }
    match missing {
        None => Ok(Some(found)),
        Some(_) if found.is_empty() => Ok(None),
        Some(head) => Err(CsvError {
            message: format!("`{}`: there is no column `{head}`", path.display()),
            help: Some(format!(
                "give all of {}, or none of them",
                heads(&part).join(", ")
            )),
        }),
    }
}
