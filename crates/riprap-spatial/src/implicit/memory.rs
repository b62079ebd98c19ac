//! What an implicit phase remembers from step to step.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::implicit::pair::{Pair, Pressure};
use crate::kernel::{ContactLaw, Memory, PairKey};

/// Memory of all pairs that press, and of the ledger.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Implicit {
    /// Pairs that pressed at the end of the last step, sorted by their blocks and patches.
    pub kept: Vec<Kept>,
    /// The ledger at the last evaluation; `None` before the first.
    pub books: Option<Books>,
    /// Heat of friction in the last step, J.
    pub rubbed: f64,
    /// What the laws of joints, bolts and conditions have booked as lost since the last evaluation, J.
    pub lost_in_joints: f64,
}

/// A pair at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Kept {
    /// The blocks, or terrain and a block.
    pub pair: PairKey,
    /// Which patch of theirs it is: the piece and the facet on terrain, else 0.
    pub key: [u32; 2],
    /// Friction on the second block, N, and its torsion about the normal, N m.
    pub shear: Vec3,
    /// N m.
    pub torsion: f64,
    /// Normal force, N.
    pub force: f64,
    /// Where it acts, from the centroid of the first block, m.
    pub arm: Vec3,
    /// Wet area, m².
    pub area: f64,
    /// Mean arm of friction against spinning, m.
    pub radius: f64,
    /// Pressure of the overlap that stays hidden, Pa: of the depth that the blocks had while nothing pressed there, or pressed softer
    /// ([`crate::kernel::offset`] says why). Never more than the deepest point would press.
    pub hidden: f64,
    /// Normal force that the contact has to begin with, N, where it takes over from a joint; `None` once it has.
    pub due: Option<f64>,
}

/// What of the ledger belongs to implicit contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Books {
    /// Energy in the normal direction that is of no implicit contact, J.
    pub offset: f64,
    /// Energy in the pressure, J.
    pub normal: f64,
    /// Energy in the springs along the contacts, J.
    pub shear: f64,
    /// Energy in the springs of joints and of faces with a condition, and in bolts, J.
    pub joints: f64,
}

impl Implicit {
    /// What is known of a patch of two blocks.
    pub(crate) fn of(&self, pair: PairKey, key: [u32; 2]) -> Option<&Kept> {
        let at = self.kept.binary_search_by_key(&(pair, key), Kept::place).ok()?;
        Some(&self.kept[at])
    }
}

impl Kept {
    pub(crate) fn place(&self) -> (PairKey, [u32; 2]) {
        (self.pair, self.key)
    }

    /// Of a pair after its step; `None` where it hides nothing, and does not press or has rebounded.
    pub(crate) fn of(of: PairKey, pair: &Pair, shear: Vec3, torsion: f64) -> Option<Self> {
        let Pressure { force, centre, area, radius } = pair.pressure;
        let nothing = Self { hidden: pair.hidden, ..Self::nothing(of, pair.key) };
        if force > 0.0 && !pair.strikes {
            let arm = centre - pair.centres[0];
            return Some(Self { shear, torsion, force, arm, area, radius, ..nothing });
        }
        (pair.hidden > 0.0).then_some(nothing)
    }

    /// Of a patch that does not press.
    fn nothing(pair: PairKey, key: [u32; 2]) -> Self {
        Self {
            pair,
            key,
            shear: Vec3::ZERO,
            torsion: 0.0,
            force: 0.0,
            arm: Vec3::ZERO,
            area: 0.0,
            radius: 0.0,
            hidden: 0.0,
            due: None,
        }
    }

    /// Of two blocks that lie in each other without any force until now.
    pub(crate) fn without_force(pair: PairKey) -> Self {
        Self { due: Some(0.0), ..Self::nothing(pair, [0; 2]) }
    }

    /// Of a patch of an explicit contact, or of a joint that is released, that presses with a normal force (N).
    pub(crate) fn of_explicit(pair: PairKey, key: [u32; 2], memory: &Memory, force: f64) -> Self {
        Self {
            shear: memory.shear,
            torsion: memory.torsion,
            force,
            arm: memory.arms[0],
            area: memory.area,
            radius: if memory.area > 0.0 { (memory.polar / memory.area).sqrt() } else { 0.0 },
            ..Self::nothing(pair, key)
        }
    }

    /// Puts it into the pair of the coming step.
    pub(crate) fn recall(&self, pair: &mut Pair, spare: &mut Vec<[f64; 2]>) {
        if self.hidden > 0.0 || self.due.is_some() {
            pair.hide(self.hidden, self.due, spare);
        }
        let pressure = Pressure {
            force: self.force,
            centre: self.arm + pair.centres[0],
            area: self.area,
            radius: self.radius,
        };
        pair.recall(self.shear, self.torsion, pressure);
    }
}

/// Energy in springs of this stiffness (Pa/m) on an area (m²), J.
pub(crate) fn sprung(law: &ContactLaw, pair: &Pair) -> f64 {
    let stiffness = law.shear_stiffness * pair.area_before;
    if stiffness <= 0.0 {
        return 0.0;
    }
    let arm = pair.pressure.radius;
    let spin = if arm > 0.0 { pair.torsion / arm } else { 0.0 };
    0.5 * (pair.shear.length_squared() + spin * spin) / stiffness
}
