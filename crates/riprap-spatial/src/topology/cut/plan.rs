//! What is to be cut.

use riprap_geom::polyhedron::cut::Part;

use crate::setup::Shape;
use crate::state::event::Note;
use crate::state::workspace::BlockClass;
use crate::topology::cut::transfer::Handed;

/// A block to be cut.
pub(super) struct Cut {
    pub(super) block: u32,
    pub(super) note: Note,
    /// Parts, about the centroid of the block.
    pub(super) parts: Vec<Part>,
    /// Their shapes in the frame of the model.
    pub(super) shapes: Vec<Shape>,
    /// Their classes.
    pub(super) classes: Vec<BlockClass>,
    /// What they take over.
    pub(super) handed: Handed,
}

/// A cut block and its parts.
pub(super) struct Family<'a> {
    pub(super) cut: &'a Cut,
    /// Block number of the first part.
    pub(super) first: u32,
    /// Place of the parent in `Deform::bodies`.
    pub(super) slot: u32,
}

impl Family<'_> {
    pub(super) fn children(&self) -> std::ops::Range<u32> {
        self.first..self.first + self.cut.parts.len() as u32
    }
}
