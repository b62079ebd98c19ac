//! Nodes of deformable blocks, for code between two steps.

use super::Engine;
use super::steer::account_of;
use crate::Vec3;
use crate::dynamics::TimeFunction;
use crate::spatial::setup::{Load, LoadKind};

/// Nodes of a deformable block by their numbers: its corners, then the centres of its faces, last the centroid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nodes {
    /// Present places, m, in the coordinates of the scene.
    pub points: Vec<[f64; 3]>,
    /// Displacements since the start, m.
    pub displacements: Vec<[f64; 3]>,
    /// Velocities at the present time, m/s.
    pub velocities: Vec<[f64; 3]>,
    /// Masses, kg.
    pub masses: Vec<f64>,
}

impl Engine {
    /// Nodes of a block; `None` of one that does not deform.
    pub(in crate::run) fn nodes(&self, block: u32) -> Option<Nodes> {
        let view = self.view().spatial()?;
        let one = view.deformable(block as usize)?;
        let numbers = || one.body.nodes();
        let origin = view.world.setup.origin;
        Some(Nodes {
            points: numbers().map(|n| (one.place(n) + origin).to_array()).collect(),
            displacements: numbers().map(|n| one.node_displacement(n).to_array()).collect(),
            velocities: numbers().map(|n| one.node_velocity(n).to_array()).collect(),
            masses: one.kind.masses().to_vec(),
        })
    }

    /// Puts forces (N) on nodes of a deformable block, in place of those that had this name; forces must be re-evaluated afterwards.
    pub(in crate::run) fn push_nodes(
        &mut self,
        name: &str,
        block: u32,
        forces: &[(u32, [f64; 3])],
    ) {
        let Self::Spatial(e) = self else {
            return;
        };
        let (setup, works) = (&mut e.world.setup, &mut e.world.accounts);
        let account = Some(account_of(&mut setup.accounts, works, name));
        setup.loads.retain(|load| load.account != account);
        let forces = forces.iter().map(|(node, force)| (*node, Vec3::from(*force))).collect();
        setup.loads.push(Load {
            blocks: vec![block],
            kind: LoadKind::Nodes { forces },
            time: TimeFunction::Constant(1.0),
            account,
        });
    }
}
