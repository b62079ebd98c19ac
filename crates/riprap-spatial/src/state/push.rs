//! What pushes blocks from outside, by account.

use riprap_geom::Vec3;

/// Force (N) and moment (N m) about the centroid on a rigid block.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force, N.
    pub force: Vec3,
    /// Moment, N m.
    pub moment: Vec3,
}

impl Wrench {
    /// Adds a force (N) at an arm (m) from the centroid.
    pub fn add(&mut self, force: Vec3, arm: Vec3) {
        self.force += force;
        self.moment += arm.cross(force);
    }

    /// Power (W) on a block with this velocity and spin.
    #[must_use]
    pub fn power(&self, velocity: Vec3, spin: Vec3) -> f64 {
        self.force.dot(velocity) + self.moment.dot(spin)
    }
}

/// Forces whose work is booked in the same way.
#[derive(Clone, Debug, Default)]
pub struct Account {
    /// On rigid blocks. *Shape* `[n_blocks]`, empty as long as nobody pushes one.
    pub blocks: Vec<Wrench>,
    /// On nodes, N. *Shape* `[n_nodes]`, empty as long as nobody pushes one.
    pub nodes: Vec<[f64; 3]>,
}

impl Account {
    /// Adds a force (N) and a moment (N m) about the centroid to those on a rigid block; there must be room.
    #[inline]
    pub fn on_block(&mut self, block: u32, force: Vec3, moment: Vec3) {
        let to = &mut self.blocks[block as usize];
        to.force += force;
        to.moment += moment;
    }

    /// Adds a force (N) to that on a node; there must be room.
    #[inline]
    pub fn on_node(&mut self, node: u32, force: Vec3) {
        for (to, f) in self.nodes[node as usize].iter_mut().zip(force.to_array()) {
            *to += f;
        }
    }

    /// Makes room for pushes on all `count` blocks.
    pub fn need_blocks(&mut self, count: usize) {
        self.blocks.resize(count, Wrench::default());
    }

    /// Makes room for pushes on all `count` nodes.
    pub fn need_nodes(&mut self, count: usize) {
        self.nodes.resize(count, [0.0; 3]);
    }

    /// Sets what is on the `pushed` blocks and on all nodes to nothing.
    pub fn clear(&mut self, pushed: &[u32]) {
        if !self.blocks.is_empty() {
            for &b in pushed {
                self.blocks[b as usize] = Wrench::default();
            }
        }
        self.nodes.fill([0.0; 3]);
    }
}

/// All that pushes blocks and nodes from outside in one evaluation: the one buffer that writers share (see [`crate::push`]).
#[derive(Clone, Debug, Default)]
pub struct Pushes {
    /// Given forces; the kick finds their work and books it as that of loads.
    pub loads: Account,
    /// Forces of what books its work itself.
    pub own: Account,
    /// Whether water pushes in this evaluation: all blocks, those in rows too, by `loads`.
    pub wet: bool,
}
