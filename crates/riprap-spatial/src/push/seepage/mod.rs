//! Steady seepage through the joints ([`crate::laws::seepage`]), and the push of its pressures on rigid blocks.
//!
//! Where a table seeps it gives the heads on open faces alone. The network (`network`) is that of the blocks as they were built; apertures are those of
//! the moment, so that the flow is found anew every so many steps. In each joint the pressure is linear, as far as it is positive; it pushes
//! both sides at their own places, so that momentum is kept. Open faces carry the pressure of the table where they are now: what standing water would do
//! to the whole block, less what it would do in its joints.

pub(crate) mod network;

use riprap_geom::Vec3;

use crate::kernel::shape::Pose;
use crate::laws::seepage::{FOUND, Network, Pipe, Steady};
use crate::laws::water::{WaterTable, pressed_where_positive};
use crate::push::water;
use crate::state::seepage::{Joint, Seepage};
use crate::state::world::World;

impl Seepage {
    /// Whether the wet part was found.
    #[must_use]
    pub fn is_found(&self) -> bool {
        self.left <= FOUND
    }
}

impl World {
    /// The table that stands now and its rules of seepage, if it seeps.
    #[must_use]
    pub fn seeping(&self) -> Option<(&WaterTable, &Steady)> {
        let table = self.table()?;
        Some((table, table.seepage.as_ref()?))
    }

    /// What rates of the network are multiplied by, 1/(m s).
    fn conductivity(&self) -> f64 {
        self.seeping().map_or(0.0, |(table, rules)| {
            table.density * -self.gravity.z / (12.0 * rules.viscosity)
        })
    }

    /// Rate at which water comes in from the open, m³/s.
    #[must_use]
    pub fn seepage_inflow(&self) -> f64 {
        let inflow = self.seepage.as_ref().map_or(0.0, |found| found.inflow);
        self.conductivity() * inflow
    }

    /// Joints between two blocks.
    fn joints_between(&self, pair: [u32; 2]) -> impl Iterator<Item = (usize, &Joint)> {
        let key = [pair[0].min(pair[1]), pair[0].max(pair[1])];
        let list = self.seepage.as_ref().map_or(&[][..], |found| &found.joints);
        let first = list.partition_point(|joint| joint.blocks < key);
        let of_pair = list[first..].iter().take_while(move |j| j.blocks == key);
        (first..).zip(of_pair)
    }

    /// Largest rate of flow through a joint between two blocks, m³/s.
    #[must_use]
    pub fn seepage_between(&self, pair: [u32; 2]) -> f64 {
        let flows = self.seepage.as_ref().map_or(&[][..], |found| &found.flows);
        let rates = self.joints_between(pair).filter_map(|(k, _)| flows.get(k));
        self.conductivity() * rates.map(|flow| flow[0]).fold(0.0, f64::max)
    }

    /// Mean flow, per metre across it, of the joint between two blocks that is nearest to a place (m, local), m²/s.
    #[must_use]
    pub fn seepage_flow(&self, pair: [u32; 2], at: Vec3) -> Vec3 {
        let flows = self.seepage.as_ref().map_or(&[][..], |found| &found.flows);
        let flow = self.nearest_joint(pair, at).and_then(|(k, _, _)| flows.get(k));
        flow.map_or(Vec3::ZERO, |[_, x, y, z]| self.conductivity() * Vec3::new(*x, *y, *z))
    }

    /// The joint between two blocks that is nearest to a place, and where in it that is at the start, m.
    fn nearest_joint(&self, pair: [u32; 2], at: Vec3) -> Option<(usize, &Joint, Vec3)> {
        let start = |joint: &Joint| {
            let b = joint.blocks[0] as usize;
            let pose = self.pose(b);
            self.reference[b] + pose.rotation.conjugate() * (at - pose.position)
        };
        let all = self.joints_between(pair);
        let all = all.map(|(k, joint)| (k, joint, start(joint)));
        all.min_by(|a, b| {
            let apart = |(_, joint, at): &(usize, &Joint, Vec3)| joint.centre.distance(*at);
            apart(a).total_cmp(&apart(b))
        })
    }

    /// Pressure (Pa) at a place (local, m) in a joint between two blocks: of the nearest joint between them, or of standing water.
    #[must_use]
    pub fn pressure_between(&self, pair: [u32; 2], at: Vec3) -> f64 {
        let Some((table, found)) = self.seeping().map(|s| s.0).zip(self.seepage.as_deref()) else {
            return self.pore_pressure(at);
        };
        let weight = table.density * -self.gravity.z;
        self.nearest_joint(pair, at).map_or(0.0, |(k, joint, start)| {
            weight * pressure(joint, &found.pressures[k], start).max(0.0)
        })
    }
}

/// Finds the flow where it is due: of a network that is new, and every so many steps.
pub(crate) fn update(world: &mut World) {
    let Some((table, rules)) = world.seeping() else {
        world.seepage = None;
        return;
    };
    // Edits append blocks or take them out: each changes one of the two numbers, so that no network outlives them.
    let blocks = [world.alive.len(), world.alive.iter().filter(|a| **a).count()];
    let known = world.seepage.as_ref().filter(|found| found.blocks == blocks);
    if known.is_some_and(|found| world.step < found.found_at.saturating_add(rules.every)) {
        return;
    }
    let mut found = match known {
        // A copy, since solving reads the world that it is part of.
        Some(found) => found.clone(),
        None => Box::new(network::build(world, table, rules)),
    };
    solve(world, rules, &mut found);
    world.seepage = Some(found);
}

/// The flow under the present apertures.
fn solve(world: &World, rules: &Steady, found: &mut Seepage) {
    let mut pipes = Vec::new();
    for joint in &found.joints {
        let [low, high] = rules.limits;
        let w = (rules.aperture + opening(world, joint)).clamp(low, high);
        pipes.extend(joint.pipes.iter().map(|&(a, b, conductance)| Pipe {
            ends: [a, b].map(|k| joint.rim[usize::from(k)].0),
            // The cubic law of laminar flow between two plates.
            conductance: w * w * w * conductance,
        }));
    }
    let network = Network {
        heights: found.nodes.iter().map(|n| n.place.z).collect(),
        edges: found.nodes.iter().map(|n| n.edge).collect(),
        pipes,
    };
    let flow = network.steady();
    found.pressures.clear();
    found.flows.clear();
    let mut into = vec![0.0; found.nodes.len()];
    let mut first = 0;
    for joint in &found.joints {
        let n = joint.rim.len();
        // Pressures at the stretches as the pipes of this joint have them (below nothing where it falls dry on the way), and rates into it.
        let (mut heads, mut weights, mut rates) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        for (k, &(a, b, _)) in joint.pipes.iter().enumerate() {
            let pipe = first + k;
            let conductance = network.pipes[pipe].conductance;
            for (side, place) in [(0, usize::from(a)), (1, usize::from(b))] {
                heads[place] += conductance * flow.ends[pipe][side];
                weights[place] += conductance;
            }
            rates[usize::from(a)] += flow.rates[pipe];
            rates[usize::from(b)] -= flow.rates[pipe];
        }
        first += joint.pipes.len();
        let (mut middle, mut slope) = (0.0, Vec3::ZERO);
        let (mut rate, mut through) = (0.0, Vec3::ZERO);
        for k in 0..n {
            let (node, lever) = joint.rim[k];
            let node = node as usize;
            let head = if weights[k] > 0.0 { heads[k] / weights[k] } else { flow.pressures[node] };
            middle += joint.shares[k] * head;
            slope += head * lever;
            rate += rates[k].max(0.0);
            through -= rates[k] * (found.nodes[node].place - joint.centre);
            into[node] += rates[k];
        }
        let through = through / area(joint);
        found.pressures.push([middle, slope.x, slope.y, slope.z]);
        found.flows.push([rate, through.x, through.y, through.z]);
    }
    let open = into.iter().zip(&found.nodes);
    let open = open.filter(|(_, node)| node.edge != crate::laws::seepage::Edge::Inside);
    found.inflow = open.map(|(rate, _)| rate.max(0.0)).sum();
    found.left = flow.left;
    found.found_at = world.step;
}

fn area(joint: &Joint) -> f64 {
    riprap_geom::polyhedron::area_vector(&joint.outline).length()
}

/// How far the sides of a joint have moved apart in its middle since the start, m.
fn opening(world: &World, joint: &Joint) -> f64 {
    let [i, j] = joint.blocks.map(|b| b as usize);
    let poses = [i, j].map(|b| world.pose(b));
    let [at_i, at_j] = [(i, poses[0]), (j, poses[1])]
        .map(|(b, pose)| pose.position + pose.rotation * (joint.centre - world.reference[b]));
    (at_j - at_i).dot(poses[0].rotation * joint.normal)
}

/// Pressure at a place of a joint at the start (m), m of water; below nothing where it is dry.
fn pressure(joint: &Joint, [middle, x, y, z]: &[f64; 4], at: Vec3) -> f64 {
    middle + Vec3::new(*x, *y, *z).dot(at - joint.centre)
}

/// Force (N) and moment about the centroid (N m) of the water on a rigid block.
pub(crate) fn on_block(world: &World, table: &WaterTable, b: usize) -> (Vec3, Vec3) {
    let Some(found) = &world.seepage else {
        return (Vec3::ZERO, Vec3::ZERO);
    };
    let weight = table.density * -world.gravity.z;
    let (reference, pose) = (world.reference[b], world.pose(b));
    let open = found.open.get(b).copied().unwrap_or(true);
    let (mut force, mut moment) =
        if open { water::on_rigid(world, table, b) } else { (Vec3::ZERO, Vec3::ZERO) };
    let joints = found.joints.len();
    let range = found.first[b] as usize..found.first[b + 1] as usize;
    for entry in &found.entries[range] {
        let (k, second) = ((entry / 2) as usize, entry % 2 == 1);
        let outline = match found.joints.get(k) {
            Some(joint) => &joint.outline,
            None => &found.bare[k - joints].outline,
        };
        let mut arms: Vec<Vec3> = outline.iter().map(|at| *at - reference).collect();
        if second {
            arms.reverse();
        }
        if open {
            let (f, m) = standing(world, table, &arms, pose, reference);
            force -= f;
            moment -= m;
        }
        if let Some(joint) = found.joints.get(k) {
            let field = &found.pressures[k];
            let at = |arm: Vec3| weight * pressure(joint, field, reference + arm);
            let (f, m) = pressed_where_positive(&arms, &at);
            force -= pose.rotation * f;
            moment -= pose.rotation * m;
        }
    }
    (force, moment)
}

/// Force (N) and moment (N m) of standing water on a part of a face; `arms` from the centroid at the start, anticlockwise seen from outside, m.
fn standing(
    world: &World,
    table: &WaterTable,
    arms: &[Vec3],
    pose: Pose,
    reference: Vec3,
) -> (Vec3, Vec3) {
    let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
    let turned: Vec<Vec3> = arms.iter().map(|arm| pose.rotation * *arm).collect();
    for k in 2..arms.len() {
        let corners = [0, k - 1, k];
        let now = corners.map(|c| pose.position + turned[c]);
        let start = corners.map(|c| reference + arms[c]);
        let pushes = table.on_triangle(-world.gravity.z, now, start);
        for (c, push) in corners.into_iter().zip(pushes) {
            force += push;
            moment += turned[c].cross(push);
        }
    }
    (force, moment)
}
