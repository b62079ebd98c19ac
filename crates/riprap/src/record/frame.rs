//! One picture of the model: block outlines and columns of numbers on blocks and contacts.

use super::field::Part;
use serde::{Deserialize, Serialize};

/// Numbers on blocks or contacts, one or two for each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Quantity, for example `displacement`.
    pub name: String,
    /// Unit, `-` for none.
    pub unit: String,
    /// 1 (number) or 2 (vector: x, y, x, y, ...).
    pub components: usize,
    /// Shape: `[items * components]`.
    pub data: Vec<f64>,
}

impl Column {
    /// One number per item.
    pub fn scalar(name: &str, unit: &str, data: Vec<f64>) -> Self {
        Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            components: 1,
            data,
        }
    }

    /// One vector per item.
    pub fn vector(name: &str, unit: &str, data: &[[f64; 2]]) -> Self {
        Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            components: 2,
            data: data.as_flattened().to_vec(),
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
        if self.components == 2 {
            let part = if part == Part::Whole {
                Part::Magnitude
            } else {
                part
            };
            self.data
                .as_chunks::<2>()
                .0
                .iter()
                .map(|v| part.of(*v).unwrap_or(f64::NAN))
                .collect()
        } else {
            self.data.clone()
        }
    }
}

/// Block outlines and contact points at one time, with their numbers.
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
    /// Vertices in m, anticlockwise, global axes, current positions.
    pub points: Vec<[f64; 2]>,
    /// Numbers on blocks.
    pub block_columns: Vec<Column>,
    /// Contact positions in m.
    pub contact_points: Vec<[f64; 2]>,
    /// Numbers on contacts.
    pub contact_columns: Vec<Column>,
}

impl Frame {
    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Outline of block `i`, anticlockwise.
    pub fn outline(&self, i: usize) -> &[[f64; 2]] {
        &self.points[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// Checks that offsets and columns fit together; the text says what does not.
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
        } else if !self.points.is_empty() {
            return Some("points without block offsets".to_owned());
        }
        let sides = [
            ("block", &self.block_columns, self.blocks()),
            ("contact", &self.contact_columns, self.contact_points.len()),
        ];
        for (what, columns, items) in sides {
            for c in columns {
                if !(1..=2).contains(&c.components) || c.data.len() != items * c.components {
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
pub(crate) mod tests {
    use super::*;

    /// Two blocks and one contact, for tests of writers and plots.
    pub(crate) fn sample() -> Frame {
        Frame {
            step: 120,
            time: 0.125,
            phase: "slide".to_owned(),
            offsets: vec![0, 4, 7],
            points: vec![
                [0.0, 0.0],
                [2.0, 0.0],
                [2.0, 1.0],
                [0.0, 1.0],
                [2.0, 0.0],
                [3.0, 0.0],
                [2.0, 1.0],
            ],
            block_columns: vec![
                Column::vector("displacement", "m", &[[0.1, 0.0], [0.3, -0.4]]),
                Column::scalar("rotation", "rad", vec![-0.01, 0.02]),
            ],
            contact_points: vec![[2.0, 0.5]],
            contact_columns: vec![Column::vector("force", "N/m", &[[1e5, -2e4]])],
        }
    }

    #[test]
    fn faults_are_named() {
        assert_eq!(sample().fault(), None);
        assert_eq!(Frame::default().fault(), None);
        let mut f = sample();
        f.offsets[2] = 6;
        assert!(f.fault().is_some());
        let mut f = sample();
        f.block_columns[1].data.pop();
        assert!(f.fault().unwrap().contains("rotation"));
    }

    #[test]
    fn parts_of_columns() {
        let f = sample();
        assert_eq!(f.block_columns[0].numbers(Part::X), vec![0.1, 0.3]);
        assert_eq!(f.block_columns[0].numbers(Part::Whole), vec![0.1, 0.5]);
        assert_eq!(f.block_columns[1].numbers(Part::Whole), vec![-0.01, 0.02]);
        assert_eq!(f.outline(1).len(), 3);
    }
}
