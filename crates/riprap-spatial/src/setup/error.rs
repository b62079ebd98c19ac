//! Why a model cannot be built.

use crate::laws::explosive::ExplosiveError;

/// Why a model cannot be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// A stiffness from the material needs moduli that it lacks.
    #[error("material `{material}` needs `young` and `poisson` for {need}")]
    NoModulus {
        /// Name of the material.
        material: String,
        /// What needs them.
        need: &'static str,
    },
    /// A block has no volume.
    #[error("block `{block}` has no volume: {reason}")]
    Shape {
        /// Name of the block.
        block: String,
        /// What is wrong.
        reason: String,
    },
    /// A block of glued parts beside something that does not know such blocks.
    #[error("block `{block}`, made of glued parts, {reason}")]
    Glued {
        /// Name of the block.
        block: String,
        /// What it cannot do.
        reason: &'static str,
    },
    /// The blocks cannot be split as asked for.
    #[error("{0}")]
    Refine(#[from] RefineError),
    /// A source cannot be built.
    #[error("{0}")]
    Source(#[from] CavityError),
    /// Deformable blocks that touch need a bond law.
    #[error(
        "blocks `{}` and `{}` touch and one of them is deformable, but interface `{interface}` defines no bonds; give it `brittle_bond`", .blocks[0], .blocks[1]
    )]
    NoBond {
        /// Name of the interface.
        interface: String,
        /// Names of the blocks.
        blocks: [String; 2],
    },
    /// A notch that is not on a face.
    #[error(
        "the box of a notch, with lowest corner ({}, {}, {}) m, contains no centre of a face shared by deformable blocks: initial cracks lie on \
         faces between blocks", .at[0], .at[1], .at[2]
    )]
    NoFacet {
        /// Lowest corner of the box, m (global).
        at: [f64; 3],
    },
    /// A support for nodes finds none.
    #[error(
        "the box of a support, with lowest corner ({}, {}, {}) m, contains no node of its deformable blocks: nodes are the corners, the face centres \
         and the centroid of a block", .at[0], .at[1], .at[2]
    )]
    NoNode {
        /// Lowest corner of the box, m (global).
        at: [f64; 3],
    },
    /// A condition for faces finds none.
    #[error(
        "boundary `{boundary}` selects no free face; check its plane, its blocks or its box, and the outward normal"
    )]
    NoFace {
        /// Name of the boundary.
        boundary: String,
    },
    /// A condition whose faces all have a later one.
    #[error(
        "boundary `{boundary}` has no effect: later boundaries (`{later}`) override it on all its faces; remove it, or select other faces"
    )]
    Overruled {
        /// Name of the boundary.
        boundary: String,
        /// Names of the later boundaries.
        later: String,
    },
}

/// Why a hole cannot be charged by code.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ChargeError {
    /// Too late.
    #[error("it has gone off")]
    Gone,
    /// A pressure over time.
    #[error("it is a pressure over time and takes no charge")]
    Pressure,
    /// No adiabat.
    #[error("{0}")]
    Explosive(ExplosiveError),
}

/// Why a source cannot be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CavityError {
    /// Nothing there.
    #[error("source `{source}` touches no block; move it into the model", source = .name)]
    NoBlock {
        /// Name of the source.
        name: String,
    },
    /// Two sources on one block.
    #[error(
        "sources `{name}` and `{other}` remove the same block {block}; move them apart or refine around them"
    )]
    Shared {
        /// Name of one source.
        name: String,
        /// Name of the other.
        other: String,
        /// Name of the block.
        block: String,
    },
    /// Nobody to push.
    #[error("the blocks of source `{name}` share no face with any other block")]
    NoWall {
        /// Name of the source.
        name: String,
    },
    /// Heave needs a surface.
    #[error("source `{name}` vents by heave, but no free face lies above it (against gravity)")]
    NoSurface {
        /// Name of the source.
        name: String,
    },
    /// No adiabat.
    #[error("source `{name}`: {reason}")]
    Explosive {
        /// Name of the source.
        name: String,
        /// What is wrong.
        reason: ExplosiveError,
    },
}

/// Most levels below the blocks as given: with more, the smallest edges come near the round-off of coordinates.
pub(crate) const MAX_LEVELS: u8 = 16;
/// Most blocks that splitting may make.
pub(crate) const MAX_BLOCKS: usize = 100_000_000;

/// Why blocks cannot be split.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RefineError {
    /// Only bricks and parallelepipeds have eight similar parts.
    #[error(
        "block {name} does not have six faces in three parallel pairs; only such blocks can be split 1 to 8 (make the region smaller)"
    )]
    Indivisible {
        /// Its name.
        name: String,
    },
    /// More levels than coordinates can resolve.
    #[error("{levels} levels are requested; at most {MAX_LEVELS} are allowed")]
    TooDeep {
        /// Levels asked for.
        levels: u8,
    },
    /// Too many blocks.
    #[error(
        "the refinement makes more than {MAX_BLOCKS} blocks; use fewer levels or a smaller region"
    )]
    TooMany,
}
