//! What holds, moves and loads a model, as a picture of it shows this: places at the start, global axes, SI.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::water::WaterTable;

/// Faces beyond which only their numbers are told: what they would take in a file is more than a picture can show.
pub const MANY_FACES: usize = 100_000;

/// Conditions on a model. In the plane third components are 0, and forces are those per metre of thickness.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Conditions {
    /// How many blocks it speaks of, those that are gone counted too: the numbers from 0 on.
    pub blocks: usize,
    /// Conditions on faces, in the order of the scene.
    pub faces: Vec<FaceCondition>,
    /// Given forces, moments and accelerations.
    pub loads: Vec<GivenLoad>,
    /// Prescribed motions of blocks.
    pub supports: Vec<Support>,
    /// Water tables.
    pub water: Vec<Table>,
    /// Names of the phases, each with the place in `water` of the table that stands in it.
    pub standing: Vec<(String, Option<u16>)>,
    /// Names of the laws of interfaces.
    pub interfaces: Vec<String>,
    /// Place in `interfaces` for materials (a, b), at `a * materials + b`; symmetric.
    pub pairs: Vec<u16>,
}

/// What a condition does to its faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FaceKind {
    /// Held in all directions.
    Held,
    /// Held along the normal alone.
    Roller,
    /// Held along the face alone.
    HeldAlong,
    /// Moved with a velocity.
    Moved,
    /// Absorbs waves.
    Viscous,
    /// A stress acts.
    Loaded,
}

/// Faces under one condition.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FaceCondition {
    /// Name for messages.
    pub name: String,
    /// What happens there.
    pub kind: FaceKind,
    /// Number of the faces, or parts of faces.
    pub count: usize,
    /// Shape `[faces]`: the block of each; empty where all conditions together have more than [`MANY_FACES`].
    pub blocks: Vec<u32>,
    /// Shape `[faces]`: centres, m.
    pub centres: Vec<[f64; 3]>,
    /// Shape `[faces]`: what acts at the centres, Pa, before its function of time; empty unless something does.
    pub tractions: Vec<[f64; 3]>,
}

/// What a load is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LoadKind {
    /// N; in the plane N/m.
    Force,
    /// N m, about the axes; in the plane N.
    Moment,
    /// m/s².
    Acceleration,
    /// Pa.
    Pressure,
}

/// A load before its function of time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GivenLoad {
    /// What it is.
    pub kind: LoadKind,
    /// Unit of `vector`.
    pub unit: String,
    /// The block that it acts on; of an acceleration the first one.
    pub block: u32,
    /// Where, m; of an acceleration the mean of the centroids.
    pub at: [f64; 3],
    /// How much.
    pub vector: [f64; 3],
}

/// Blocks whose motion is prescribed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Support {
    /// Whether they are driven, as opposed to held.
    pub driven: bool,
    /// Their numbers.
    pub blocks: Vec<u32>,
}

/// A water table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Name in the scene.
    pub name: String,
    /// Horizontal direction of distances: x and y in space, `[1, 0]` in the plane.
    pub along: [f64; 2],
    /// Distance and height of each corner, m; it goes on level beyond both ends. Empty where it is a grid or several tables.
    pub points: Vec<[f64; 2]>,
    /// Lines along x, along y and the heights by lines of y, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grid: Option<[Vec<f64>; 3]>,
    /// Lowest and highest coordinates of where it acts, m; in the plane the height is the second one. Everywhere if it is not there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<[Vec<f64>; 2]>,
    /// The tables of which it is made.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Table>,
    /// Whether water seeps through joints from it, so that frames have the flow.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub seeps: bool,
}

impl Table {
    /// A table whose coordinates are from `origin` (m; in the plane y is nothing and z the height).
    #[must_use]
    pub fn of(table: &WaterTable, origin: Vec3, is_flat: bool) -> Self {
        let [x, y] = table.along;
        let far = x * origin.x + y * origin.y;
        let from = |list: &[f64], by: f64| list.iter().map(|v| v + by).collect();
        let corner = |at: Vec3| match is_flat {
            true => vec![at.x + origin.x, at.z + origin.z],
            false => (at + origin).to_array().to_vec(),
        };
        Self {
            name: table.name.clone(),
            along: table.along,
            points: table.points.iter().map(|p| [p[0] + far, p[1] + origin.z]).collect(),
            grid: table
                .grid
                .as_ref()
                .map(|g| [from(&g.x, origin.x), from(&g.y, origin.y), from(&g.z, origin.z)]),
            within: table.zone.map(|zone| [zone.low, zone.high].map(corner)),
            parts: table.parts.iter().map(|part| Self::of(part, origin, is_flat)).collect(),
            seeps: table.seepage.is_some(),
        }
    }
}

impl Conditions {
    /// Takes in what another picture of the same model says of blocks that this one does not know.
    pub fn extend(&mut self, later: Conditions) {
        if self.blocks == 0 {
            *self = later;
            return;
        }
        self.blocks = self.blocks.max(later.blocks);
        for condition in later.faces {
            match self.faces.iter_mut().find(|c| c.name == condition.name) {
                Some(known) => {
                    known.count += condition.count;
                    known.blocks.extend(condition.blocks);
                    known.centres.extend(condition.centres);
                    known.tractions.extend(condition.tractions);
                }
                None => self.faces.push(condition),
            }
        }
        self.thin();
    }

    /// Keeps numbers alone of more faces than a picture can show.
    pub fn thin(&mut self) {
        if self.faces.iter().map(|c| c.count).sum::<usize>() <= MANY_FACES {
            return;
        }
        for condition in &mut self.faces {
            condition.blocks.clear();
            condition.centres.clear();
            condition.tractions.clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(blocks: usize, on: &[u32]) -> Conditions {
        let faces = on.iter();
        Conditions {
            blocks,
            faces: vec![FaceCondition {
                name: "floor".to_owned(),
                kind: FaceKind::Roller,
                count: on.len(),
                blocks: on.to_vec(),
                centres: faces.map(|b| [f64::from(*b), 0.0, 0.0]).collect(),
                tractions: Vec::new(),
            }],
            ..Conditions::default()
        }
    }

    #[test]
    fn parts_of_blocks_come_after_the_blocks() {
        let mut all = Conditions::default();
        all.extend(picture(4, &[0, 3]));
        all.extend(picture(12, &[5, 6]));
        assert_eq!(all.blocks, 12);
        assert_eq!(all.faces.len(), 1);
        assert_eq!(all.faces[0].blocks, [0, 3, 5, 6]);
        assert_eq!(all.faces[0].count, 4);
    }

    #[test]
    fn of_too_many_faces_the_number_is_left() {
        let many: Vec<u32> = (0..=MANY_FACES as u32).collect();
        let mut all = picture(4, &[0, 3]);
        all.extend(picture(MANY_FACES + 1, &many));
        assert_eq!(all.faces[0].count, MANY_FACES + 3);
        assert!(all.faces[0].blocks.is_empty() && all.faces[0].centres.is_empty());
    }
}
