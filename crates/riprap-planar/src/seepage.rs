//! Steady seepage through the joints ([`crate::laws::seepage`]), and the push of its pressures on blocks.
//!
//! Where a table seeps it gives the heads on open faces alone. The network (`network`) is that of the blocks as they were built; apertures are those of
//! the moment, so that the flow is found anew every so many steps. Between the ends of a joint the pressure is linear as far as it is positive; it pushes
//! both sides at their own places, so that momentum is kept. Open faces carry the pressure of the table where they are now.

mod network;
pub(crate) mod state;

use riprap_geom::Vec2;

use super::loads::Applied;
use super::setup::WaterTable;
use super::shapes::Shapes;
use super::world::{Body, World};
use crate::laws::seepage::{Edge, FOUND, Flow, Network, Pipe, Steady};
use state::{Conduit, OpenFace, Seepage};

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

    /// Rate (m²/s, for each metre of thickness) of conduit `k` from its first to its second node.
    #[must_use]
    pub fn seepage_rate(&self, k: usize) -> f64 {
        match (self.seeping(), &self.seepage) {
            (Some((table, rules)), Some(found)) => {
                let weight = table.density * -self.gravity.y;
                weight / (12.0 * rules.viscosity) * found.rates.get(k).copied().unwrap_or(0.0)
            }
            _ => 0.0,
        }
    }

    /// Rate at which water comes in through open faces, m²/s for each metre of thickness.
    #[must_use]
    pub fn seepage_inflow(&self) -> f64 {
        let Some(found) = &self.seepage else {
            return 0.0;
        };
        let mut into = vec![0.0; found.nodes.len()];
        for (k, conduit) in found.conduits.iter().enumerate() {
            let rate = self.seepage_rate(k);
            into[conduit.nodes[0] as usize] += rate;
            into[conduit.nodes[1] as usize] -= rate;
        }
        let open = into.iter().zip(&found.nodes);
        let open = open.filter(|(_, node)| node.edge != Edge::Inside);
        open.map(|(rate, _)| rate.max(0.0)).sum()
    }

    /// Conduits between two blocks.
    fn conduits(&self, pair: (u32, u32)) -> impl Iterator<Item = (usize, &Conduit)> {
        let key = [pair.0.min(pair.1), pair.0.max(pair.1)];
        let list = self.seepage.as_ref().map_or(&[][..], |found| &found.conduits);
        let first = list.partition_point(|c| c.blocks < key);
        let of_pair = list[first..].iter().take_while(move |c| c.blocks == key);
        (first..).zip(of_pair)
    }

    /// Pressure (Pa) at a place (local, m) between two blocks: of the nearest conduit between them, or of standing water.
    #[must_use]
    pub fn pressure_between(&self, pair: (u32, u32), at: Vec2) -> f64 {
        let Some((table, found)) = self.seeping().map(|s| s.0).zip(self.seepage.as_deref()) else {
            return self.pore_pressure(at);
        };
        let weight = table.density * -self.gravity.y;
        self.nearest_conduit(pair, at).map_or(0.0, |(k, _, s)| {
            let [p, q] = found.ends[k].map(|p| weight * p);
            (p + s * (q - p)).max(0.0)
        })
    }

    /// Flow (m²/s, for each metre of thickness) through the conduit between two blocks that is nearest to a place (local, m), along it.
    #[must_use]
    pub fn seepage_flow(&self, pair: (u32, u32), at: Vec2) -> Vec2 {
        let nearest = self.nearest_conduit(pair, at);
        nearest.map_or(Vec2::ZERO, |(k, along, _)| self.seepage_rate(k) * along.normalize_or_zero())
    }

    /// The conduit between two blocks that is nearest to a place (local, m), the way from its first to its second node (m), and how far along it that is.
    fn nearest_conduit(&self, pair: (u32, u32), at: Vec2) -> Option<(usize, Vec2, f64)> {
        let place = |(k, c): (usize, &Conduit)| {
            let [a, b] = c.on[0].map(|arm| self.on_body(c.blocks[0], arm));
            let along = b - a;
            let s = ((at - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            ((a + s * along).distance(at), (k, along, s))
        };
        let all = self.conduits(pair).map(place);
        all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|near| near.1)
    }

    /// Largest rate of the conduits between two blocks, m²/s for each metre of thickness.
    #[must_use]
    pub fn seepage_between(&self, pair: (u32, u32)) -> f64 {
        let rates = self.conduits(pair).map(|(k, _)| self.seepage_rate(k).abs());
        rates.fold(0.0, f64::max)
    }
}

/// Finds the flow where it is due: of a network that is new, and every so many steps.
pub(super) fn update(world: &mut World, shapes: &Shapes) {
    let Some((table, rules)) = world.seeping() else {
        world.seepage = None;
        return;
    };
    let due = match &world.seepage {
        None => true,
        Some(found) => world.step >= found.found_at.saturating_add(rules.every),
    };
    if !due {
        return;
    }
    let mut found = match &world.seepage {
        // A copy, since solving reads the world that it is part of.
        Some(found) => found.as_ref().clone(),
        None => network::build(&world.setup, shapes, &world.alive, table),
    };
    let flow = solve(world, rules, &found);
    found.ends = flow.ends;
    found.rates = flow.rates;
    found.left = flow.left;
    found.found_at = world.step;
    world.seepage = Some(Box::new(found));
}

/// The flow under the present apertures.
fn solve(world: &World, rules: &Steady, found: &Seepage) -> Flow {
    let frames = frames(world);
    let pipe = |c: &Conduit| {
        let [i, j] = [0, 1].map(|side| places(&world.bodies, &frames, c.blocks[side], c.on[side]));
        let along = i[1] - i[0];
        // Outward of the first block: to the right of the way around it.
        let normal = -along.perp().normalize_or_zero();
        let opening = 0.5 * ((j[0] - i[0]) + (j[1] - i[1])).dot(normal);
        let [low, high] = rules.limits;
        let w = (rules.aperture + opening).clamp(low, high);
        Pipe {
            ends: c.nodes,
            // The cubic law of laminar flow between two plates.
            conductance: w * w * w / along.length(),
        }
    };
    let network = Network {
        heights: found.nodes.iter().map(|n| n.place.y).collect(),
        edges: found.nodes.iter().map(|n| n.edge).collect(),
        pipes: found.conduits.iter().map(pipe).collect(),
    };
    network.steady()
}

/// Sine and cosine of the angle of each block.
fn frames(world: &World) -> Vec<(f64, f64)> {
    world.bodies.iter().map(|b| libm::sincos(b.angle)).collect()
}

/// Two points of a block from its centroid at its present attitude, m.
fn arms((s, c): (f64, f64), on: [Vec2; 2]) -> [Vec2; 2] {
    on.map(|p| Vec2::new(c * p.x - s * p.y, s * p.x + c * p.y))
}

fn places(bodies: &[Body], frames: &[(f64, f64)], block: u32, on: [Vec2; 2]) -> [Vec2; 2] {
    let b = block as usize;
    arms(frames[b], on).map(|r| bodies[b].position + r)
}

/// Push of a pressure that is linear from the first to the second arm (m, anticlockwise around the block) where it is positive.
fn pressed([a, b]: [Vec2; 2], [p, q]: [f64; 2]) -> Applied {
    if p <= 0.0 && q <= 0.0 {
        return Applied::default();
    }
    // Asked for only where the pressure changes its sign.
    let zero = p / (p - q);
    let (from, to) = match (p < 0.0, q < 0.0) {
        (true, _) => (zero, 1.0),
        (_, true) => (0.0, zero),
        (false, false) => (0.0, 1.0),
    };
    let (p, q) = (p.max(0.0), q.max(0.0));
    let (a, b) = (a + from * (b - a), a + to * (b - a));
    let along = b - a;
    let inward = along.perp();
    let force = 0.5 * (p + q) * inward;
    // Mean part at the middle, slope about it.
    let slope = (q - p) / 12.0 * along.perp_dot(inward);
    Applied { force, moment: (0.5 * (a + b)).perp_dot(force) + slope }
}

/// Calls `push` with each block and what presses on it, in the order of conduits and faces.
fn each(world: &World, mut push: impl FnMut(u32, Applied)) {
    let Some((table, _)) = world.seeping() else {
        return;
    };
    let Some(found) = &world.seepage else {
        return;
    };
    let frames = frames(world);
    let weight = table.density * -world.gravity.y;
    for (c, ends) in found.conduits.iter().zip(&found.ends) {
        let [p, q] = ends.map(|p| weight * p);
        if p <= 0.0 && q <= 0.0 {
            continue;
        }
        let [i, j] = c.blocks;
        push(i, pressed(arms(frames[i as usize], c.on[0]), [p, q]));
        // The way around the second block is the other one.
        let [a, b] = arms(frames[j as usize], c.on[1]);
        push(j, pressed([b, a], [q, p]));
    }
    for OpenFace { block, on, .. } in &found.faces {
        let b = *block as usize;
        let ends = arms(frames[b], *on);
        let pressures = ends.map(|r| {
            let at = world.bodies[b].position + r;
            weight * (table.height(at.x) - at.y)
        });
        push(*block, pressed(ends, pressures));
    }
}

/// Adds the push of the water to what is applied to the blocks.
pub(super) fn apply(world: &World, applied: &mut [Applied]) {
    each(world, |block, push| {
        let to = &mut applied[block as usize];
        to.force += push.force;
        to.moment += push.moment;
    });
}

/// The push on one block.
#[must_use]
pub(super) fn on_block(world: &World, b: usize) -> Applied {
    let mut sum = Applied::default();
    each(world, |block, push| {
        if block as usize == b {
            sum.force += push.force;
            sum.moment += push.moment;
        }
    });
    sum
}
