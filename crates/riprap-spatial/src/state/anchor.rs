//! Points of blocks: how they follow the freedoms, and what forces on them do to the freedoms.
//!
//! An anchor is a linear map B from the freedoms of its block to a point. A point of a rigid block has the velocity `v + w x r` and
//! hands a force on as force and moment; a point of a deformable block has the weighted mean of the velocities of up to three nodes
//! and shares a force among them with the same weights, a point in its inside that of the four of a tetrahedron. Therefore `f . (B q) = (B^T f) . q`, and what acts through anchors
//! does the same work on the point as on the freedoms.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::state::bodies::{Bodies, Turned};
use crate::state::deform;
use crate::state::push::Account;

/// A point of a block.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Anchor {
    /// On a rigid block.
    Block {
        /// Its index.
        block: u32,
        /// From its centroid to the point at the start, m.
        arm: Vec3,
    },
    /// On a deformable block.
    Nodes {
        /// Up to three of its nodes.
        nodes: [u32; 3],
        /// Their weights; they sum to one, those of nodes that are not needed are 0.
        weights: [f64; 3],
    },
}

impl Anchor {
    /// A node.
    #[must_use]
    pub fn node(node: u32) -> Self {
        Self::Nodes {
            // Those of weight 0 are read too, and have to be there.
            nodes: [node; 3],
            weights: [1.0, 0.0, 0.0],
        }
    }

    /// The node that it is, if it is a single one.
    #[inline]
    #[must_use]
    pub fn single(&self) -> Option<u32> {
        match self {
            Self::Nodes { nodes, weights } if *weights == [1.0, 0.0, 0.0] => Some(nodes[0]),
            Self::Nodes { .. } | Self::Block { .. } => None,
        }
    }

    /// Its nodes with their weights; none on a rigid block.
    #[inline]
    pub fn nodes(&self) -> impl Iterator<Item = (u32, f64)> + use<> {
        let (nodes, weights) = match *self {
            Self::Nodes { nodes, weights } => (nodes, weights),
            Self::Block { .. } => ([0; 3], [0.0; 3]),
        };
        let count = match self {
            Self::Nodes { .. } => 3,
            Self::Block { .. } => 0,
        };
        nodes.into_iter().zip(weights).take(count)
    }
}

/// A point in the inside of a block.
///
/// Points of facets, which are many, need three nodes; this one has room for the four of a tetrahedron.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Inside {
    /// Of a rigid block.
    Block {
        /// Its index.
        block: u32,
        /// From its centroid to the point at the start, m.
        arm: Vec3,
    },
    /// Of a deformable block.
    Tetrahedron {
        /// Nodes of the tetrahedron that holds the point.
        nodes: [u32; 4],
        /// Their weights; they sum to one.
        weights: [f64; 4],
    },
}

impl Inside {
    /// Its nodes with their weights; none in a rigid block.
    #[inline]
    pub fn nodes(&self) -> impl Iterator<Item = (u32, f64)> + use<> {
        let (nodes, weights, count) = match *self {
            Self::Tetrahedron { nodes, weights } => (nodes, weights, 4),
            Self::Block { .. } => ([0; 4], [0.0; 4], 0),
        };
        nodes.into_iter().zip(weights).take(count)
    }

    /// Whether it lies in a deformable block.
    #[inline]
    #[must_use]
    pub fn deforms(&self) -> bool {
        match self {
            Self::Tetrahedron { .. } => true,
            Self::Block { .. } => false,
        }
    }
}

/// The freedoms of all blocks: where they are and how they move.
#[derive(Clone, Copy)]
pub struct Freedoms<'a> {
    /// Rigid blocks.
    pub bodies: &'a Bodies,
    /// Those with finite rotations.
    pub turned: &'a [Option<Box<Turned>>],
    /// Displacements of nodes, m.
    pub displacement: &'a [[f64; 3]],
    /// Velocities of nodes half a step ago, m/s.
    pub velocity: &'a [[f64; 3]],
}

impl<'a> Freedoms<'a> {
    /// Of the rigid blocks, and of the nodes of deformable ones if there are any.
    #[must_use]
    pub fn new(
        bodies: &'a Bodies,
        turned: &'a [Option<Box<Turned>>],
        nodes: Option<&'a deform::Nodes>,
    ) -> Self {
        Self {
            bodies,
            turned,
            displacement: nodes.map_or(&[], |n| &n.displacement),
            velocity: nodes.map_or(&[], |n| &n.velocity),
        }
    }

    /// Present arm of a point of a rigid block from its arm at the start, m.
    #[inline]
    #[must_use]
    pub fn arm(&self, block: u32, arm: Vec3) -> Vec3 {
        match &self.turned[block as usize] {
            Some(turned) => turned.attitude * arm,
            None => arm,
        }
    }

    /// Displacement of a point, m.
    #[inline(always)]
    #[must_use]
    pub fn displacement(&self, anchor: &Anchor) -> Vec3 {
        match anchor {
            Anchor::Nodes { nodes, weights } => weighted(self.displacement, nodes, weights),
            Anchor::Block { block, arm } => self.displacement_on_block(*block as usize, *arm),
        }
    }

    // A call of its own, so that the loops over the points of bonds, nearly all on nodes, take in the rest.
    #[inline(never)]
    fn displacement_on_block(&self, b: usize, arm: Vec3) -> Vec3 {
        let turning = match &self.turned[b] {
            Some(turned) => turned.attitude * arm - arm,
            None => self.bodies.rotation(b).cross(arm),
        };
        self.bodies.displacement(b) + turning
    }

    /// Velocity of a point half a step ago, m/s.
    #[inline]
    #[must_use]
    pub fn velocity(&self, anchor: &Anchor) -> Vec3 {
        match anchor {
            Anchor::Nodes { nodes, weights } => weighted(self.velocity, nodes, weights),
            Anchor::Block { block, arm } => {
                let b = *block as usize;
                let arm = self.arm(*block, *arm);
                self.bodies.velocity(b) + self.bodies.spin(b).cross(arm)
            }
        }
    }

    /// Displacement of the second point less that of the first, m.
    #[inline(always)]
    #[must_use]
    pub fn jump(&self, [a, b]: &[Anchor; 2]) -> Vec3 {
        self.displacement(b) - self.displacement(a)
    }

    /// Velocity of the second point less that of the first, m/s.
    #[must_use]
    pub fn jump_velocity(&self, [a, b]: &[Anchor; 2]) -> Vec3 {
        self.velocity(b) - self.velocity(a)
    }

    /// Displacement of a point in the inside of a block, m.
    #[inline]
    #[must_use]
    pub fn displacement_inside(&self, inside: &Inside) -> Vec3 {
        match *inside {
            Inside::Block { block, arm } => self.displacement(&Anchor::Block { block, arm }),
            Inside::Tetrahedron { nodes, weights } => {
                let u = nodes.map(|n| self.displacement[n as usize]);
                Vec3::from_array([0, 1, 2].map(|k| {
                    let term = |n: usize| weights[n] * u[n][k];
                    term(0) + term(1) + term(2) + term(3)
                }))
            }
        }
    }

    /// Adds a force (N) on a point in the inside of a block to what pushes its freedoms.
    pub fn push_inside(&self, to: &mut Account, inside: &Inside, force: Vec3) {
        match *inside {
            Inside::Block { block, arm } => self.push(to, &Anchor::Block { block, arm }, force),
            Inside::Tetrahedron { .. } => {
                for (node, weight) in inside.nodes() {
                    to.on_node(node, weight * force);
                }
            }
        }
    }

    /// Adds a force (N) on a point to what pushes its freedoms.
    pub fn push(&self, to: &mut Account, anchor: &Anchor, force: Vec3) {
        match anchor {
            Anchor::Block { block, arm } => {
                to.on_block(*block, force, self.arm(*block, *arm).cross(force));
            }
            Anchor::Nodes { .. } => {
                for (node, weight) in anchor.nodes().filter(|(_, w)| *w != 0.0) {
                    to.on_node(node, weight * force);
                }
            }
        }
    }
}

#[inline(always)]
fn weighted(lists: &[[f64; 3]], nodes: &[u32; 3], weights: &[f64; 3]) -> Vec3 {
    let [i, j, k] = *nodes;
    let a = &lists[i as usize];
    if *weights == [1.0, 0.0, 0.0] {
        return Vec3::from_array(*a);
    }
    let (b, c) = (&lists[j as usize], &lists[k as usize]);
    let [p, q, r] = *weights;
    // Written out: `map` of arrays became a call in the loop over the points of bonds.
    Vec3::new(
        p * a[0] + q * b[0] + r * c[0],
        p * a[1] + q * b[1] + r * c[1],
        p * a[2] + q * b[2] + r * c[2],
    )
}

#[cfg(test)]
mod tests {
    use riprap_geom::Quat;

    use super::*;
    use crate::state::push::Wrench;

    type Rotations = Vec<Option<Box<Turned>>>;

    /// A rigid block that has hardly turned, one that has turned far, and velocities of six nodes.
    fn moving() -> (Bodies, Rotations, Vec<[f64; 3]>) {
        let mut bodies = Bodies::at_rest(2);
        for b in 0..2 {
            let x = 1.0 + b as f64;
            bodies.set_displacement(b, Vec3::new(0.1, -0.2, 0.3) * x, Vec3::new(0.0, 1e-3, 0.0));
            bodies.set_velocity(b, Vec3::new(-1.0, 2.0, 0.7) * x, Vec3::new(0.4, 0.1, -3.0));
        }
        let turned = Turned {
            attitude: Quat::from_scaled_axis(Vec3::new(0.3, -1.2, 0.9)),
            momentum: Vec3::ZERO,
        };
        let nodes = (0..6).map(|k| [0.3 * k as f64 - 1.0, 0.5, -0.1 * k as f64]);
        (bodies, vec![None, Some(Box::new(turned))], nodes.collect())
    }

    #[test]
    fn a_force_does_the_same_work_on_a_point_as_on_its_freedoms() {
        let (bodies, turned, velocity) = moving();
        let freedoms = Freedoms {
            bodies: &bodies,
            turned: &turned,
            displacement: &velocity,
            velocity: &velocity,
        };
        let arm = Vec3::new(0.7, 0.2, -0.4);
        let f = Vec3::new(3.0, -1.0, 5.0);
        for anchor in [
            Anchor::Block { block: 0, arm },
            Anchor::Block { block: 1, arm },
            Anchor::node(4),
            Anchor::Nodes { nodes: [1, 5, 2], weights: [0.2, 0.5, 0.3] },
        ] {
            let mut to = Account { blocks: vec![Wrench::default(); 2], nodes: vec![[0.0; 3]; 6] };
            freedoms.push(&mut to, &anchor, f);
            let on_blocks = (0..2).map(|b| to.blocks[b].power(bodies.velocity(b), bodies.spin(b)));
            let on_nodes = to.nodes.iter().zip(&velocity);
            let on_nodes = on_nodes.map(|(f, v)| Vec3::from_array(*f).dot(Vec3::from_array(*v)));
            let power: f64 = on_blocks.chain(on_nodes).sum();
            let expected = f.dot(freedoms.velocity(&anchor));
            assert!((power - expected).abs() < 1e-14 * (1.0 + expected.abs()));
        }
    }

    #[test]
    fn a_force_in_a_tetrahedron_does_the_work_of_its_nodes() {
        let (bodies, turned, nodes) = moving();
        let freedoms =
            Freedoms { bodies: &bodies, turned: &turned, displacement: &nodes, velocity: &nodes };
        let inside = Inside::Tetrahedron { nodes: [5, 0, 3, 2], weights: [0.1, 0.4, 0.3, 0.2] };
        let mut to = Account { blocks: Vec::new(), nodes: vec![[0.0; 3]; 6] };
        let force = Vec3::new(2.0, -7.0, 1.0);
        freedoms.push_inside(&mut to, &inside, force);
        let each = to.nodes.iter().zip(&nodes);
        let work: f64 = each.map(|(f, u)| Vec3::from_array(*f).dot(Vec3::from_array(*u))).sum();
        assert!((work - force.dot(freedoms.displacement_inside(&inside))).abs() < 1e-14);
        let sum: Vec3 = to.nodes.iter().map(|f| Vec3::from_array(*f)).sum();
        assert!((sum - force).length() < 1e-14);
        // In a rigid block it is the point of an anchor.
        let arm = Vec3::new(0.7, 0.2, -0.4);
        let (inside, anchor) = (Inside::Block { block: 1, arm }, Anchor::Block { block: 1, arm });
        assert_eq!(freedoms.displacement_inside(&inside), freedoms.displacement(&anchor));
    }

    #[test]
    fn the_displacement_of_a_point_grows_with_its_velocity() {
        let (mut bodies, turned, nodes) = moving();
        let arm = Vec3::new(0.7, 0.2, -0.4);
        for anchor in [Anchor::Block { block: 0, arm }, Anchor::node(3)] {
            let at = |bodies: &Bodies, nodes: &[[f64; 3]]| {
                Freedoms { bodies, turned: &turned, displacement: nodes, velocity: &[] }
                    .displacement(&anchor)
            };
            let before = at(&bodies, &nodes);
            let freedoms = Freedoms {
                bodies: &bodies,
                turned: &turned,
                displacement: &nodes,
                velocity: &nodes,
            };
            let v = freedoms.velocity(&anchor);
            let dt = 1e-3;
            let (u, th) = (bodies.displacement(0), bodies.rotation(0));
            let (du, dth) = (dt * bodies.velocity(0), dt * bodies.spin(0));
            bodies.set_displacement(0, u + du, th + dth);
            let later: Vec<[f64; 3]> = nodes.iter().map(|v| v.map(|x| x + dt * x)).collect();
            assert!((at(&bodies, &later) - before - dt * v).length() < 1e-15);
        }
    }
}
