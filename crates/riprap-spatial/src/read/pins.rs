//! Pins: points of blocks, as on the walls of a tunnel, and where they go.

use riprap_geom::{Quat, Vec3};

use crate::faces::region::holds;
use crate::push::bolts::inside::TetFan;
use crate::query::view::View;
use crate::state::anchor::Inside;
use crate::state::lineage::Origin;

impl View<'_> {
    /// Where a point of a block (m, local, at the start) was when displacements began to be measured, where it is (m, local), and its velocity
    /// (m/s). It moves with its block rigidly, in a deformable one as the tetrahedron that holds it, and goes on in the part of a block that was
    /// split. `None`: the block is gone.
    #[must_use]
    pub fn pinned(&self, block: u32, at: Vec3) -> Option<[Vec3; 3]> {
        let b = self.heir(block, at)?;
        let [shift, turn] = self.world.datum(b);
        let arm = at - self.world.reference[b];
        if self.deformable(b).is_some() {
            return self.in_tetrahedron(b, at, shift + turn.cross(arm));
        }
        let inside = Inside::Block { block: b as u32, arm };
        let now = at + self.world.all_freedoms().displacement_inside(&inside);
        let turned = match &self.world.turned[b] {
            Some(_) => Quat::from_scaled_axis(turn) * arm - arm,
            None => turn.cross(arm),
        };
        let velocity = self.velocity(b) + self.spin(b).cross(self.turned_arm(b, arm));
        Some([at + shift + turned, now, velocity])
    }

    fn turned_arm(&self, b: usize, arm: Vec3) -> Vec3 {
        self.world.all_freedoms().arm(b as u32, arm)
    }

    /// The same in a deformable block; `rigid`: displacement when displacements began to be measured, of nodes that are newer.
    fn in_tetrahedron(&self, b: usize, at: Vec3, rigid: Vec3) -> Option<[Vec3; 3]> {
        let deformable = self.deformable(b)?;
        let (inside, _) = TetFan::at_start(self.world, b)?.point(at)?;
        let before = |n: usize| {
            let known = self.world.node_datum.get(n).map(|u| Vec3::from_array(*u));
            known.unwrap_or(rigid)
        };
        let mut sums = [at, at, Vec3::ZERO];
        for (node, weight) in inside.nodes() {
            let n = node as usize;
            sums[0] += weight * before(n);
            sums[1] += weight * deformable.node_displacement(n);
            sums[2] += weight * deformable.node_velocity(n);
        }
        Some(sums)
    }

    /// The block, or the part of it that holds a point.
    fn heir(&self, block: u32, at: Vec3) -> Option<usize> {
        let world = self.world;
        if world.alive[block as usize] {
            return Some(block as usize);
        }
        let comes = |b: usize| {
            let mut ancestor = b as u32;
            while ancestor != block && ancestor != Origin::NONE {
                ancestor = world.lineage[ancestor as usize].parent;
            }
            ancestor == block
        };
        // Blocks that were added or split later have larger numbers.
        let later = block as usize + 1..world.alive.len();
        let mut parts = later.filter(|&b| world.alive[b] && comes(b));
        parts.find(|&b| holds(&world.setup.blocks[b].shape, at))
    }
}
