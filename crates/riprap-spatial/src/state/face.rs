//! Free faces of rigid blocks.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::face_joint::SIGNS;

/// A face, or a part of one, that no patch covers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Face {
    /// Block it belongs to.
    pub block: u32,
    /// Index into `Setup::boundaries` of the condition that acts on it, if any.
    pub boundary: Option<u16>,
    /// Unit outward normal n at the start, then b and c: right-handed.
    pub frame: [Vec3; 3],
    /// Centre from the centroid of the block at the start, m.
    pub arm: Vec3,
    /// Area, m².
    pub area: f64,
    /// Distance of the four points from the centre along b and c, m.
    pub half_spacing: [f64; 2],
    /// What a condition acts through (boxed: of a million free faces few have one); `None` without a condition and under given tractions.
    pub half_block: Option<Box<HalfBlock>>,
    /// Whether it lay in a joint that has given way: nothing covers it, but it is inside the rock and no part of its surface.
    pub parted: bool,
}

/// Faces that a condition has lost to one that stands later in the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Overruled {
    /// Indices into `Setup::boundaries`: of the condition that lost them, of the one that has them.
    pub boundaries: [u16; 2],
    /// How many.
    pub faces: u32,
    /// Faces that the first one means in all.
    pub of: u32,
}

/// The half block between a face and the centroid behind it, through which a condition acts on the block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HalfBlock {
    /// Normal and shear stiffness, Pa/m.
    pub stiffness: [f64; 2],
    /// Impedances rho c_P and rho c_S, Pa s/m.
    pub impedance: [f64; 2],
    /// Displacement of the far end of the face spring at the four points, m.
    pub anchor: [Vec3; 4],
}

impl Face {
    /// What a condition acts through: nothing where there is none.
    #[must_use]
    pub fn behind(&self) -> HalfBlock {
        self.half_block.as_deref().copied().unwrap_or_default()
    }

    /// Place of point `p` from the centroid of the block at the start, m.
    #[must_use]
    pub fn place(&self, p: usize) -> Vec3 {
        let [_, b, c] = self.frame;
        self.arm + SIGNS[0][p] * self.half_spacing[0] * b + SIGNS[1][p] * self.half_spacing[1] * c
    }
}
