//! What bolts add to the springs of the model, for the stable time step: the elastic chain as it was built.
//!
//! A chain in equilibrium is a spring between all points that it holds; yield, slip, lifting plates and rupture only make it softer.
//! Among rigid blocks that spring counts as it is ([`BoltSprings`]). For nodes of deformable blocks, of which a bolt holds many, bounds do: with
//! grout `G = diag(k_g l)` and bars `B` the stiffness `S = (G^-1 + B^-1)^-1` is at most `G`, and at most `B` where a plate ties the head.
//! Shares of springs go to nodes by their weights, since `(sum w u)^2 <= sum w u^2`.

use riprap_geom::{Mat3, Vec3};

use crate::laws::bolt::Factors;
use crate::state::anchor::Inside;
use crate::state::bolts::{Bolt, Pin};
use crate::state::world::World;

/// The elastic springs of all bolts between rigid blocks; points of deformable ones are held.
pub struct BoltSprings<'a> {
    world: &'a World,
    factors: Vec<Factors>,
}

impl<'a> BoltSprings<'a> {
    /// Those of a world.
    #[must_use]
    pub fn new(world: &'a World) -> Self {
        let factors = world.bolts.iter().map(|b| b.chain.factors()).collect();
        Self { world, factors }
    }

    /// Adds forces and moments on blocks for a motion of them (translation and rotation of each).
    pub fn pull(&mut self, at: &[[Vec3; 2]], sum: &mut [[Vec3; 2]]) {
        let world = self.world;
        for (bolt, factors) in world.bolts.iter().zip(&mut self.factors) {
            let bars = bolt.chain.bars.len();
            // Deformable blocks do not move in `at`.
            let displacement = |pin: &Pin| -> Vec3 {
                let [u, turn] = at[pin.block as usize];
                u + turn.cross(arm(world, pin))
            };
            let mut add = |pin: &Pin, force: Vec3| {
                let to = &mut sum[pin.block as usize];
                to[0] += force;
                to[1] += arm(world, pin).cross(force);
            };
            let ends = |k: usize| (&bolt.pins[k], &bolt.pins[k + 1]);
            let apart: Vec<f64> = (0..bars)
                .map(|k| {
                    let (from, to) = ends(k);
                    if from.block == to.block {
                        0.0
                    } else {
                        bolt.axis.dot(displacement(to) - displacement(from))
                    }
                })
                .collect();
            if apart.iter().any(|x| *x != 0.0) {
                let mut forces = vec![0.0; bars];
                factors.elastic_forces(&bolt.chain, &apart, &mut forces);
                for (k, force) in forces.into_iter().enumerate() {
                    let (from, to) = ends(k);
                    if from.block != to.block {
                        // As a patch: the force that holds the motion up.
                        add(from, -force * bolt.axis);
                        add(to, force * bolt.axis);
                    }
                }
            }
            let Some([stiffness, _]) = dowel(world, bolt) else {
                continue;
            };
            for dowel in &bolt.dowels {
                let [behind, ahead] = &dowel.sides;
                let jump = displacement(ahead) - displacement(behind);
                let force = stiffness * (jump - jump.dot(bolt.axis) * bolt.axis);
                add(behind, -force);
                add(ahead, force);
            }
        }
    }
}

/// Largest sum of a row of `t t^T` and of `1 - t t^T`, all entries positive, for unit vectors t of any direction: `(1 + sqrt(3))/2`.
const ROWS: f64 = 1.366_025_403_784_438_6;

/// Rows of the stiffness of bolts on the nodes of deformable blocks, all entries positive, at most this, N/m; empty where no bolt
/// hangs on a node.
#[must_use]
pub fn row_sums(world: &World) -> Vec<f64> {
    let chain = |bolt: &Bolt, k: usize| {
        let (held, bars) = held(bolt, k);
        // What pulls a node to one side pulls all others to the other one.
        2.0 * ROWS * held * bars / (held + bars)
    };
    on_nodes(world, chain, 2.0 * ROWS)
}

/// Bound of the squared frequency (1/s²) of nodes of deformable blocks with these masses (kg) on bolts alone, rigid blocks held, and the node
/// that sets it.
#[must_use]
pub fn on_masses(world: &World, masses: &[f64]) -> (f64, Option<u32>) {
    let chain = |bolt: &Bolt, k: usize| {
        let (held, bars) = held(bolt, k);
        match k == 0 && bolt.chain.holds[0].lifts {
            true => bars,
            false => held,
        }
    };
    let mut springs = on_nodes(world, chain, 2.0);
    if let Some(deform) = world.deform.as_deref() {
        for hold in deform.holds.iter().filter(|h| h.free == Mat3::ZERO) {
            if let Some(spring) = springs.get_mut(hold.node as usize) {
                *spring = 0.0;
            }
        }
    }
    let mut most = (0.0, None);
    for (n, (spring, mass)) in (0u32..).zip(springs.iter().zip(masses)) {
        if spring / mass > most.0 {
            most = (spring / mass, Some(n));
        }
    }
    most
}

/// Stiffness of what holds node `k` of a bolt in the rock, and that of the bars at it, N/m.
fn held(bolt: &Bolt, k: usize) -> (f64, f64) {
    let bars = &bolt.chain.bars;
    let of = |k: Option<usize>| k.and_then(|k| bars.get(k)).map_or(0.0, |b| b.stiffness);
    (bolt.chain.holds[k].stiffness, of(k.checked_sub(1)) + of(Some(k)))
}

/// Springs of nodes of chains and of dowels, `times` the stiffness of these, on the nodes of deformable blocks, N/m.
fn on_nodes(world: &World, chain: impl Fn(&Bolt, usize) -> f64, times: f64) -> Vec<f64> {
    let Some(deform) = world.deform.as_deref() else {
        return Vec::new();
    };
    let mut sums = Vec::new();
    for bolt in &world.bolts {
        let mut add = |pin: &Pin, stiffness: f64| {
            for (node, weight) in pin.anchor.nodes() {
                sums.resize(deform.nodes.len(), 0.0);
                sums[node as usize] += weight.abs() * stiffness;
            }
        };
        for (k, pin) in bolt.pins.iter().enumerate() {
            add(pin, chain(bolt, k));
        }
        let stiffness = dowel(world, bolt).map_or(0.0, |d| d[0]);
        for side in bolt.dowels.iter().flat_map(|d| &d.sides) {
            add(side, times * stiffness);
        }
    }
    sums
}

/// Stiffness and limit of the dowels of a bolt.
fn dowel(world: &World, bolt: &Bolt) -> Option<[f64; 2]> {
    world.setup.bolts[bolt.number as usize].design.dowel
}

/// Present arm of a pin on a rigid block, m.
fn arm(world: &World, pin: &Pin) -> Vec3 {
    match pin.anchor {
        Inside::Block { block, arm } => world.all_freedoms().arm(block, arm),
        Inside::Tetrahedron { .. } => Vec3::ZERO,
    }
}
