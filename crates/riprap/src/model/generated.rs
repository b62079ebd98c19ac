//! What tables and files give before it becomes blocks of the plane.

use std::collections::BTreeMap;

use riprap_geom::Vec2;

use super::summary::Region;
use crate::scenario::foreign::Place;

/// What one table makes.
pub(super) struct Generated {
    pub(super) outlines: Vec<Vec<Vec2>>,
    /// Whether the blocks are called name.1, name.2, ...
    pub(super) numbered: bool,
    pub(super) region: Option<Region>,
    /// Groups of the file it comes from, by places among `outlines`.
    pub(super) groups: Vec<(String, Vec<u32>)>,
}

impl Generated {
    pub(super) fn single(outline: Vec<Vec2>) -> Self {
        Generated { outlines: vec![outline], numbered: false, region: None, groups: Vec::new() }
    }

    pub(super) fn several(outlines: Vec<Vec<Vec2>>) -> Self {
        Generated { outlines, numbered: true, region: None, groups: Vec::new() }
    }
}

/// Polygons of a file in the coordinates of the scenario, m.
#[derive(Clone, Debug, Default)]
pub(super) struct Drawn {
    pub(super) outlines: Vec<Vec<Vec2>>,
    /// Places in the file.
    pub(super) places: Vec<Place>,
    /// Groups of outlines by name.
    pub(super) groups: BTreeMap<String, Vec<u32>>,
}
