//! What a patch carries and stores, for any patch at any time.

use crate::joint::patch::{self, Points, Poses, Resultant};
use crate::laws::face_joint::{Memory, Traction};
use crate::setup::JointLaw;
use crate::state::patches::{PatchClass, flag};
use crate::state::world::World;

/// One patch of a world.
#[derive(Clone, Copy)]
pub(crate) struct Reading<'a> {
    /// State.
    pub world: &'a World,
    /// The patch.
    pub p: usize,
}

impl<'a> Reading<'a> {
    /// Its class.
    pub(crate) fn class(&self) -> &'a PatchClass {
        &self.world.classes[self.world.patches.class[self.p] as usize]
    }

    /// Its law.
    pub(crate) fn joint(&self) -> &'a JointLaw {
        patch::joint(&self.world.setup.interfaces, self.class())
    }

    /// Tractions (n, b, c) at its points without displacement, Pa.
    pub(crate) fn start(&self) -> [Traction; 4] {
        patch::start(self.class(), self.world.patches.prestress.get(self.p))
    }

    /// Openings of its points, m, where its law is not plain.
    pub(crate) fn openings(&self) -> Option<[f64; 4]> {
        let (points, start) = (self.points(), self.start());
        patch::openings(self.joint(), self.class(), &points, &start, &self.memory())
    }

    /// Its kinematics.
    pub(crate) fn points(&self) -> Points {
        let list = &self.world.patches;
        let finite = list.flags[self.p] & flag::FINITE != 0;
        let poses = Poses { bodies: &self.world.bodies, turned: &self.world.turned };
        poses.points(self.class(), list.ends[self.p], finite)
    }

    /// Tractions on block i at the four points (n, b, c), Pa, without dashpots.
    pub(crate) fn tractions(&self, points: &Points) -> [Traction; 4] {
        patch::carried(self.joint(), self.class(), points, &self.start(), &self.memory())
    }

    /// What its points remember.
    pub(crate) fn memory(&self) -> [Memory; 4] {
        let (list, p) = (&self.world.patches, self.p);
        patch::memories(
            list.flags[p],
            list.slip.get(p),
            list.normal_offset.get(p),
            list.accumulated_slip.get(p),
            list.wear.get(p),
        )
    }

    /// Its forces on its blocks, without dashpots.
    pub(crate) fn resultant(&self) -> Resultant {
        let points = self.points();
        points.resultant(self.class(), &self.tractions(&points))
    }

    /// Energy in its normal and shear springs, J.
    pub(crate) fn energy(&self) -> [f64; 2] {
        let (class, points) = (self.class(), self.points());
        let mut sum = [0.0; 2];
        for stored in patch::stored(self.joint(), class, &points, &self.start(), &self.memory()) {
            for k in 0..2 {
                sum[k] += 0.25 * class.area * stored[k];
            }
        }
        sum
    }
}
