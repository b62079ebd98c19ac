//! States of blocks at the start, from a table: place, attitude, velocity and spin by name.
//!
//! A state moves the shape that the scene draws, before joints, supports and all else look at it: blocks that lie apart by then have no joint.

use std::collections::BTreeMap;

use riprap_geom::{Quat, Vec2, Vec3};

use super::builder::Builder;
use super::solid::put_solid;
use crate::numbers::counted;
use crate::scenario::Name;
use crate::scenario::csv_columns::{Column, csv_labels};
use crate::scenario::diagnostic::list;
use crate::scenario::language::Start;
use crate::scenario::read::Provenance;
use crate::scenario::units::Dim;
use crate::scenario::vectors::InSpace;

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

/// Parts of a state: place, attitude, velocity, spin.
const PARTS: usize = 4;
/// Rows of each part that a table has, SI.
type Parts = [Option<Vec<Vec<f64>>>; PARTS];

/// Columns of a state in the plane, and how many of them each part has.
const PLANAR: ([Column; 6], [usize; PARTS]) = (
    [
        Column::optional(&["x"], Dim::LENGTH, "m"),
        Column::optional(&["y"], Dim::LENGTH, "m"),
        // Degrees are as usual as radians.
        Column::optional(&["angle"], Dim::ANGLE, "rad").with_unit(),
        Column::optional(&["vx"], Dim::VELOCITY, "m/s"),
        Column::optional(&["vy"], Dim::VELOCITY, "m/s"),
        Column::optional(&["spin"], Dim::SPIN, "rad/s"),
    ],
    [2, 1, 2, 1],
);

/// Columns of a state in space, and how many of them each part has.
const SPATIAL: ([Column; 13], [usize; PARTS]) = (
    [
        Column::optional(&["x"], Dim::LENGTH, "m"),
        Column::optional(&["y"], Dim::LENGTH, "m"),
        Column::optional(&["z"], Dim::LENGTH, "m"),
        Column::optional(&["qw"], Dim::NONE, ""),
        Column::optional(&["qx"], Dim::NONE, ""),
        Column::optional(&["qy"], Dim::NONE, ""),
        Column::optional(&["qz"], Dim::NONE, ""),
        Column::optional(&["vx"], Dim::VELOCITY, "m/s"),
        Column::optional(&["vy"], Dim::VELOCITY, "m/s"),
        Column::optional(&["vz"], Dim::VELOCITY, "m/s"),
        Column::optional(&["wx"], Dim::SPIN, "rad/s"),
        Column::optional(&["wy"], Dim::SPIN, "rad/s"),
        Column::optional(&["wz"], Dim::SPIN, "rad/s"),
    ],
    [3, 4, 3, 3],
);

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
                    "`{csv}` gives two states for block `{name}`, in rows {} and {}",
                    first + 1,
                    row + 1
                );
                self.error_at("file.csv", csv, message, "remove one of the rows");
                return;
            }
            states.push((block, *state));
        }
        if let [first, ..] = unknown[..] {
            let message = format!(
                "{} of the {} rows of `{csv}` name blocks that this scene does not have; the first is `{first}`",
                unknown.len(),
                rows.len()
            );
            let help = "the column `block` holds the names of single blocks, with their number for a generator (`rock.3`); remove the other rows";
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
                let message = format!("`{csv}` gives a state for `{name}`, which is terrain");
                self.error_at("file.csv", csv, message, "terrain cannot move; remove its row");
                return;
            }
        }
        let why = format!(
            "{} from the rows, {} as given in the scene",
            counted(states.len(), "block"),
            count - states.len()
        );
        self.explain("start.csv", format!("\"{csv}\""), Provenance::Given, &why);
    }

    /// Names and states of the table; `None` after an error.
    fn state_rows(&mut self, csv: &Name) -> Option<Vec<(String, State)>> {
        let (labels, [place, attitude, velocity, spin]) = match self.space {
            InSpace::Planar => self.state_columns(csv, &PLANAR)?,
            InSpace::Spatial => self.state_columns(csv, &SPATIAL)?,
        };
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
                            "`{csv}`: the quaternion of `{label}` has length {}",
                            quaternion.length()
                        );
                        let help = "an orientation is a unit quaternion: the squares of qw, qx, qy and qz add up to 1";
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

    /// Names of the blocks and the columns of each part of their states that the table has, SI; `None` after an error.
    fn state_columns<const N: usize>(
        &mut self,
        csv: &Name,
        (columns, parts): &([Column; N], [usize; PARTS]),
    ) -> Option<(Vec<String>, Parts)> {
        let labels = match csv_labels(&self.parsed.folder.join(csv.as_str()), "block") {
            Ok(labels) => labels,
            Err(error) => {
                let help = error.help.unwrap_or_default();
                self.error_at("file.csv", csv, error.message, &help);
                return None;
            }
        };
        let heads: Vec<String> = columns.iter().map(head).collect();
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let table = self.table(csv, columns)?;
        // A row of units has a text in every column, but no state.
        let of_states =
            labels.into_iter().filter(|(line, _)| table.lines.binary_search(line).is_ok());
        let mut names = Vec::with_capacity(table.lines.len());
        for (line, name) in of_states {
            if name.is_empty() {
                let message = format!("`{csv}`, line {line}: the column `block` is empty");
                let help = "give the name of a block, or remove the row";
                self.error_at("file.csv", csv, message, help);
                return None;
            }
            names.push(name);
        }
        let mut found = table.columns.into_iter();
        let mut first = 0;
        let mut states = [const { None }; PARTS];
        for (state, count) in states.iter_mut().zip(parts) {
            let of_part: Vec<_> = found.by_ref().take(*count).collect();
            let wanted = &heads[first..first + count];
            first += count;
            if let Some(missing) = of_part.iter().position(Option::is_none) {
                if of_part.iter().any(Option::is_some) {
                    let message = format!("`{csv}` has no column `{}`", wanted[missing]);
                    let help = format!("give all of {}, or none", wanted.join(", "));
                    self.error_at("file.csv", csv, message, &help);
                    return None;
                }
                continue;
            }
            *state = Some(of_part.into_iter().flatten().map(|c| c.values).collect());
        }
        if states.iter().all(Option::is_none) {
            let message = format!("`{csv}` has no column with a state of blocks");
            let help = format!("valid columns besides `block`: {}", list(&heads));
            self.error_at("file.csv", csv, message, &help);
            return None;
        }
        Some((names, states))
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

/// How a column is named with its usual unit.
fn head(column: &Column) -> String {
    let name = column.names[0];
    match column.usual.unwrap_or("rad") {
        "" => name.to_owned(),
        unit => format!("{name}_{}", unit.replace('/', "_")),
    }
}
