//! State of bolts that are in the rock.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::laws::bolt;
use crate::laws::bolt::{Chain, Toll};
use crate::setup::Bolt as Spec;
use crate::state::anchor::{Freedoms, Inside};

/// A bolt in the rock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bolt {
    /// Index into `Setup::bolts`.
    pub number: u32,
    /// Bar, grout and plate with all that they remember.
    pub chain: Chain,
    /// Where each node of the chain sits in the rock.
    pub pins: Vec<Pin>,
    /// Shear springs where it crosses joints.
    pub dowels: Vec<Dowel>,
    /// Unit direction from the head to the toe when it was installed.
    pub axis: Vec3,
    /// What it has gone through so far.
    pub toll: Toll,
}

/// A point of the rock that a bolt holds on to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pin {
    /// The block.
    pub block: u32,
    /// Where in it.
    pub anchor: Inside,
    /// Distance from the head, m.
    pub along: f64,
    /// Place when the bolt was installed, m.
    pub place: Vec3,
    /// Displacement then, m.
    pub base: Vec3,
}

/// A bolt as a dowel between the two sides of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dowel {
    /// The bar that crosses the joint.
    pub bar: u32,
    /// The same point on both sides.
    pub sides: [Pin; 2],
    /// What has slipped, m, across the axis.
    pub slip: Vec3,
    /// Force on the side behind, N.
    pub force: Vec3,
}

impl Pin {
    /// Displacement since the bolt was installed, m.
    #[inline]
    #[must_use]
    pub fn displacement(&self, freedoms: &Freedoms) -> Vec3 {
        freedoms.displacement_inside(&self.anchor) - self.base
    }
}

/// Present chord (m) from one pin to another, and by how much it is longer than when the bolt was installed, m.
#[inline]
#[must_use]
pub(crate) fn chord(from: &Pin, to: &Pin, freedoms: &Freedoms) -> (Vec3, f64) {
    let moved = to.displacement(freedoms) - from.displacement(freedoms);
    bolt::chord(to.place - from.place, moved, Vec3::dot)
}

impl Bolt {
    /// Energy in bar, grout, plate and dowels, J; `spec` is what it was built from.
    #[must_use]
    pub fn stored(&self, spec: &Spec) -> f64 {
        let squares = self.dowels.iter().map(|d| d.force.length_squared());
        self.chain.stored_with(spec.design.dowel, squares)
    }

    /// Whether the rock at the ends of bar `k` can move apart: it lies in two blocks, or in one that deforms.
    #[must_use]
    pub fn stretches(&self, k: usize) -> bool {
        self.pins[k].block != self.pins[k + 1].block || self.pins[k].anchor.deforms()
    }

    /// All points of the rock that it holds on to, those of its dowels last.
    pub fn points(&self) -> impl Iterator<Item = &Pin> {
        self.pins.iter().chain(self.dowels.iter().flat_map(|d| &d.sides))
    }

    /// Blocks that it holds on to, with repeats.
    pub fn blocks(&self) -> impl Iterator<Item = u32> + '_ {
        self.points().map(|pin| pin.block)
    }
}
