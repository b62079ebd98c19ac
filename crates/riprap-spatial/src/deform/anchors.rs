//! What points hang on: how it moves, and the jump across a point.

use riprap_geom::Vec3;

use super::links::single;
use super::store::{Anchor, Deform, Facet, Nodes, Point};
use crate::world::{Bodies, Turned, World};

/// What points hang on.
#[derive(Clone, Copy)]
pub struct Anchors<'a> {
    /// Nodes.
    pub nodes: &'a Nodes,
    /// Rigid blocks.
    pub bodies: &'a Bodies,
    /// Those with finite rotations.
    pub turned: &'a [Option<Box<Turned>>],
}

impl<'a> Anchors<'a> {
    /// Those of a world whose deformable part has been taken out.
    #[must_use]
    pub fn new(world: &'a World, deform: &'a Deform) -> Self {
        Self {
            nodes: &deform.nodes,
            bodies: &world.bodies,
            turned: &world.turned,
        }
    }

    /// Displacement of an anchor, m.
    #[inline]
    #[must_use]
    pub fn moved(&self, anchor: &Anchor, rigid: Option<u32>) -> [f64; 3] {
        match rigid {
            None => weighted(&self.nodes.moved, anchor),
            Some(b) => self.rigid(b as usize, Vec3::from_array(anchor.weights)),
        }
    }

    /// Velocity of an anchor half a step ago, m/s.
    #[must_use]
    pub fn rate(&self, anchor: &Anchor, rigid: Option<u32>) -> [f64; 3] {
        match rigid {
            None => weighted(&self.nodes.rate, anchor),
            Some(b) => {
                let b = b as usize;
                let arm = self.arm(b, Vec3::from_array(anchor.weights));
                (self.bodies.velocity(b) + self.bodies.spin(b).cross(arm)).to_array()
            }
        }
    }

    fn rigid(&self, b: usize, arm: Vec3) -> [f64; 3] {
        let moved = match &self.turned[b] {
            Some(turned) => turned.attitude * arm - arm,
            None => self.bodies.rotation(b).cross(arm),
        };
        (self.bodies.displacement(b) + moved).to_array()
    }

    /// Present arm of a point of a rigid block, m.
    #[must_use]
    pub fn arm(&self, b: usize, arm: Vec3) -> Vec3 {
        match &self.turned[b] {
            Some(turned) => turned.attitude * arm,
            None => arm,
        }
    }

    /// Jump across a point, m, global axes.
    #[inline]
    #[must_use]
    pub fn jump(&self, facet: &Facet, point: &Point) -> Vec3 {
        let [a, b] = [0, 1].map(|s| self.moved(&point.anchors[s], rigid(facet, s)));
        Vec3::new(b[0] - a[0], b[1] - a[1], b[2] - a[2])
    }

    /// Rate of the jump, m/s, global axes.
    #[must_use]
    pub fn jump_rate(&self, facet: &Facet, point: &Point) -> Vec3 {
        let [a, b] = [0, 1].map(|s| self.rate(&point.anchors[s], rigid(facet, s)));
        Vec3::new(b[0] - a[0], b[1] - a[1], b[2] - a[2])
    }
}

/// The rigid block on a side, if it is one.
#[inline]
#[must_use]
pub fn rigid(facet: &Facet, side: usize) -> Option<u32> {
    facet.rigid[side].then_some(facet.blocks[side])
}

#[inline]
fn weighted(lists: &[[f64; 3]], anchor: &Anchor) -> [f64; 3] {
    if single(anchor) {
        return lists[anchor.nodes[0] as usize];
    }
    let [a, b, c] = anchor.nodes.map(|n| lists[n as usize]);
    let [p, q, r] = anchor.weights;
    [0, 1, 2].map(|k| p * a[k] + q * b[k] + r * c[k])
}
