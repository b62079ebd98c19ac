//! One picture of the model: block outlines or solids, and columns of numbers on blocks and contacts.

use super::field::Part;
use serde::{Deserialize, Serialize};

pub mod bars;
pub mod conditions;
pub mod fragments;
pub mod states;
pub mod stress;

/// Column of contacts: flow of water through the joint at each, a vector along it.
pub const SEEPAGE_FLOW: &str = "seepage_flow";

/// Numbers on blocks or contacts, one to three for each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Quantity, for example `displacement`.
    pub name: String,
    /// Unit, `-` for none.
    pub unit: String,
    /// 1 (number), 2 (vector: x, y, x, y, ...) or 3 (x, y, z, ...).
    pub components: usize,
    /// Shape: `[items * components]`.
    pub data: Vec<f64>,
}

impl Column {
    /// One number per item.
    pub fn scalar(name: &str, unit: &str, data: Vec<f64>) -> Self {
        Column { name: name.to_owned(), unit: unit.to_owned(), components: 1, data }
    }

    /// One vector per item.
    pub fn vector(name: &str, unit: &str, data: impl Into<Vec<[f64; 2]>>) -> Self {
        Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            components: 2,
            data: data.into().into_flattened(),
        }
    }

    /// One vector in space per item.
    pub fn vector3(name: &str, unit: &str, data: impl Into<Vec<[f64; 3]>>) -> Self {
        Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            components: 3,
            data: data.into().into_flattened(),
        }
    }

    /// Number of blocks or contacts.
    pub fn len(&self) -> usize {
        self.data.len() / self.components.max(1)
    }

    /// No blocks or contacts.
    pub fn is_empty(&self) -> bool {
        self.data.is_empty()
    }

    /// One number per item: a part of a vector, or the number itself. [`Part::Whole`] of a vector is its length.
    pub fn numbers(&self, part: Part) -> Vec<f64> {
        if self.components == 1 {
            return self.data.clone();
        }
        let part = if part == Part::Whole { Part::Magnitude } else { part };
        self.data.chunks(self.components).map(|v| part.of(v).unwrap_or(f64::NAN)).collect()
    }
}

/// Share of the blocks that [`usual`] leaves out: one that flies off must not make points of the arrows of all others.
const STRAY: f64 = 0.005;
/// Fewer numbers than this have no strays.
const FEW: usize = 20;

/// The size to which marks of sizes (arrows, crosses) are drawn: the largest, or that of most blocks where the rest are more than
/// twice as large. What is not finite does not count; 0 for nothing.
#[must_use]
pub fn usual(sizes: &[f64]) -> f64 {
    let mut finite: Vec<f64> = sizes.iter().copied().filter(|v| v.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    let Some(largest) = finite.last().copied() else {
        return 0.0;
    };
    if finite.len() < FEW {
        return largest;
    }
    let left_out = (STRAY * finite.len() as f64).ceil() as usize;
    let most = finite[finite.len() - 1 - left_out];
    if most > 0.0 && largest > 2.0 * most { most } else { largest }
}

/// Faces of solid blocks.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Solids {
    /// Shape `[blocks + 1]`: block `i` owns the faces `faces[i]..faces[i + 1]`. A block without faces is a brick of
    /// eight corners in the order of [`BRICK`].
    pub faces: Vec<u32>,
    /// Shape `[faces + 1]`: face `f` owns `corners[ends[f]..ends[f + 1]]`.
    pub ends: Vec<u32>,
    /// Corners of the faces, anticlockwise seen from outside, counted from the first point of their block.
    pub corners: Vec<u32>,
}

/// Corners of a brick as -1 or +1 along x, y, z, in the order of a VTK hexahedron.
pub const BRICK: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Faces of a brick with corners as in [`BRICK`], anticlockwise seen from outside: -z, +z, -y, +y, -x, +x.
pub const BRICK_FACES: [[u32; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [3, 7, 6, 2], [0, 4, 7, 3], [1, 2, 6, 5]];

impl Solids {
    /// Faces of block `i`, which has `points` corners; corners counted from its first point.
    pub fn of(&self, i: usize) -> Vec<&[u32]> {
        let (first, last) = (self.faces[i] as usize, self.faces[i + 1] as usize);
        if first == last {
            return BRICK_FACES.iter().map(<[u32; 4]>::as_slice).collect();
        }
        (first..last)
            .map(|f| &self.corners[self.ends[f] as usize..self.ends[f + 1] as usize])
            .collect()
    }

    fn fault(&self, blocks: &[u32]) -> Option<&'static str> {
        let covers = |list: &[u32], count: usize| {
            list.first() == Some(&0)
                && list.is_sorted()
                && list.last().is_some_and(|l| *l as usize == count)
        };
        if self.faces.len() != blocks.len()
            || !covers(&self.faces, self.ends.len().saturating_sub(1))
            || !covers(&self.ends, self.corners.len())
        {
            return Some("the lists of faces are inconsistent");
        }
        for (i, range) in blocks.windows(2).enumerate() {
            let points = range[1] - range[0];
            if self.faces[i] == self.faces[i + 1] && points != 8 {
                return Some("a brick does not have eight corners");
            }
            let faces = self.faces[i] as usize..self.faces[i + 1] as usize;
            for f in faces {
                let corners = &self.corners[self.ends[f] as usize..self.ends[f + 1] as usize];
                if corners.iter().any(|&c| c >= points) {
                    return Some("a face names a corner that its block does not have");
                }
            }
        }
        None
    }
}

/// Cells in space with numbers: polygons of cracks, tetrahedra, bars of bolts.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Surfaces {
    /// Shape `[cells]`: end of each cell's run of points.
    pub ends: Vec<u32>,
    /// Corners, m, global axes.
    pub points: Vec<[f64; 3]>,
    /// Numbers on cells.
    pub columns: Vec<Column>,
}

/// Blocks and contact points at one time, with their numbers.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// Step count.
    pub step: u64,
    /// Model time in s.
    pub time: f64,
    /// Name of the phase that was running.
    pub phase: String,
    /// Shape `[blocks + 1]`: block `i` owns `points[offsets[i]..offsets[i + 1]]`. Empty means no blocks.
    pub offsets: Vec<u32>,
    /// Vertices in m, global axes, current positions; in the plane anticlockwise with z = 0.
    pub points: Vec<[f64; 3]>,
    /// Faces in space; `None` in the plane.
    pub solids: Option<Solids>,
    /// Numbers on blocks.
    pub block_columns: Vec<Column>,
    /// Contact positions in m.
    pub contact_points: Vec<[f64; 3]>,
    /// Numbers on contacts.
    pub contact_columns: Vec<Column>,
    /// Cracks between deformable blocks; `None` where there are no such blocks. Not read back.
    pub cracks: Option<Surfaces>,
    /// Bars of bolts (two points each); `None` where no bolt is in the rock. Not read back.
    pub bolts: Option<Surfaces>,
    /// Tetrahedra of deformable blocks (four points each), where they are asked for. Not read back.
    pub tetrahedra: Option<Surfaces>,
}

/// What frames hold besides the blocks, their numbers and materials.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Content {
    /// Columns of the blocks; `None`: all.
    pub fields: Option<Vec<String>>,
    /// Whether contacts are written, with their columns.
    pub contacts: bool,
    /// Whether the tetrahedra of deformable blocks are.
    pub tetrahedra: bool,
}

impl Default for Content {
    fn default() -> Self {
        Self { fields: None, contacts: true, tetrahedra: false }
    }
}

/// Columns that say which block a row is and of what: frames always hold them.
const ALWAYS: [&str; 2] = ["block", "material"];

impl Content {
    /// Whether this column of the blocks is wanted.
    #[must_use]
    pub fn wants(&self, column: &str) -> bool {
        let asked = |fields: &Vec<String>| fields.iter().any(|field| field == column);
        ALWAYS.contains(&column) || self.fields.as_ref().is_none_or(asked)
    }
}

impl Frame {
    /// Bytes of its arrays, before they are compressed.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let columns = self.block_columns.iter().chain(&self.contact_columns);
        let numbers: usize = columns.map(|column| column.data.len()).sum();
        // Three numbers and the number of each point; end and kind of each cell.
        let points = self.points.len() + self.contact_points.len();
        let cells = self.blocks() + self.contact_points.len();
        let faces = self.solids.as_ref().map_or(0, |s| s.corners.len() + 2 * s.ends.len());
        8 * (numbers + 4 * points + faces) + 9 * cells
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Vertices of block `i`; in the plane its outline, anticlockwise.
    pub fn outline(&self, i: usize) -> &[[f64; 3]] {
        &self.points[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// Numbers of a block column by name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.block_columns.iter().find(|c| c.name == name)
    }

    /// Checks that offsets, faces and columns fit together; the text says what does not.
    pub fn fault(&self) -> Option<String> {
        if let Some(first) = self.offsets.first() {
            let last = self.offsets.last().copied().unwrap_or(0) as usize;
            let ordered = self.offsets.is_sorted();
            if *first != 0 || !ordered || last != self.points.len() {
                return Some(format!(
                    "block offsets do not run from 0 to the number of points {}",
                    self.points.len()
                ));
            }
            if let Some(fault) = self.solids.as_ref().and_then(|s| s.fault(&self.offsets)) {
                return Some(fault.to_owned());
            }
        } else if !self.points.is_empty() {
            return Some("points without block offsets".to_owned());
        }
        let sides = [
            ("block", &self.block_columns, self.blocks()),
            ("contact", &self.contact_columns, self.contact_points.len()),
        ];
        for (what, columns, items) in sides {
            for c in columns {
                if !(1..=3).contains(&c.components) || c.data.len() != items * c.components {
                    return Some(format!(
                        "{what} column `{}` has {} numbers for {items} {what}s of {} components",
                        c.name,
                        c.data.len(),
                        c.components
                    ));
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strays_do_not_set_the_size_of_marks() {
        let mut sizes = vec![1.0; 199];
        sizes.push(1e9);
        assert_eq!(usual(&sizes), 1.0);
        sizes[198] = 1e9;
        assert_eq!(usual(&sizes), 1e9);
        assert_eq!(usual(&[1.0, 1e9]), 1e9);
        // Nothing else moves.
        sizes[..199].fill(0.0);
        assert_eq!(usual(&sizes), 1e9);
        assert_eq!(usual(&[f64::NAN]), 0.0);
        // Almost twice is usual.
        let near: Vec<f64> = (0..100).map(|i| 1.0 + 0.009 * f64::from(i)).collect();
        assert_eq!(usual(&near), near[99]);
    }
}
