//! Steady flow of water through a network of joints, with the part of it that is wet.
//!
//! Nodes are the places where joints meet, pipes the stretches of joints between them. Pressures `p >= 0` are in metres of water. A node under pressure is
//! full, `s = 1`; one without carries a share `0 <= s <= 1` of what falls freely through the pipes below it. From the upper node `u` of a pipe to the lower
//! one `l`, `d >= 0` below it, flows
//!
//! ```text
//! q = C (p_u + min(s_u d, d - p_l))
//! ```
//!
//! `C` its conductance when full (cubic law: `rho g w^3/(12 mu l)` for each metre of width, `w` the hydraulic aperture): the exact rate in a pipe that is full where there
//! is pressure and carries a film where there is none. The film reaches the water of the lower node (`s_u d`), or the pipe is full to its upper end. In a
//! level pipe it is `C (p_u - p_l)`. What flows into a node flows out of it again. Since `q` grows with what the upper node has and
//! falls with what the lower one has, all together have one answer (an M-function).
//!
//! Where water can leave, the pressure is nothing as long as it does; where it would have to come in, nothing flows (seepage face). Which nodes are full,
//! which pipes carry films and which outlets run is part of the answer, which `search` finds by Newton's method and sweeps that end at it from any start. If it is
//! not reached within the turns that there are, the flow is not found ([`Flow::is_found`]), and it is for the caller to say so.
//!
//! Deviation: a millionth of a pipe conducts as if films and pressures did not hinder each other, `s_u d - p_l`. Without it the water that stands in a
//! bowl above which nothing flows would be any amount. Of the films of a dry node a share of 1e-12 is lost.
//!
//! Sources: Witherspoon et al. (1980), Water Resour. Res. 16, 1016-1024 (cubic law); Brezis, Kinderlehrer & Stampacchia (1978), C. R. Acad. Sci. A 287,
//! 711-714 (full or dry as part of the answer); Rheinboldt (1970), J. Math. Anal. Appl. 32, 274-307 (one answer, and sweeps that
//! find it).

mod linear;
mod rows;
mod rules;
mod search;
pub mod sheet;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

pub use rules::{Curtain, Drain, Side, Steady};
use search::{PATIENCE, Search};

/// What of the rates may not add up at a node, as a share of the largest possible rate, where the flow counts as found.
pub const FOUND: f64 = 1e-8;
/// A stretch of a joint between two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// Its nodes.
    pub ends: [u32; 2],
    /// Rate for each metre of difference in head when it is full; any unit, zero or more.
    pub conductance: f64,
}

/// What holds at a node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Edge {
    /// What comes in goes out.
    #[default]
    Inside,
    /// The head is given, m, not below the node.
    Head(f64),
    /// Water leaves at this head (m, not below the node) or not at all: a seepage face, a drain.
    Outlet(f64),
}

/// A network of joints.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// Height of each node, m.
    pub heights: Vec<f64>,
    /// What holds there.
    pub edges: Vec<Edge>,
    /// Pipes between nodes.
    pub pipes: Vec<Pipe>,
}

/// Steady flow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Flow {
    /// Pressure of each node, m of water; nothing where no water reaches it.
    pub pressures: Vec<f64>,
    /// Pressures at the ends of each pipe, m of water: linear between them and nothing where that is below zero.
    pub ends: Vec<[f64; 2]>,
    /// Rate in each pipe from its first to its second node, in the unit of the conductances times m.
    pub rates: Vec<f64>,
    /// Turns of the search.
    pub turns: usize,
    /// Largest part of a rate that does not add up at a node, over the largest possible rate.
    pub left: f64,
}

impl Flow {
    /// Whether the wet part was found.
    #[must_use]
    pub fn is_found(&self) -> bool {
        self.left <= FOUND
    }
}

impl Network {
    /// The steady flow.
    #[must_use]
    pub fn steady(&self) -> Flow {
        Search::new(self).find(PATIENCE)
    }

    /// Which nodes hang together with a given head.
    fn reached(&self) -> Vec<bool> {
        let heads = self.edges.iter().map(|e| matches!(e, Edge::Head(_)));
        let mut reached: Vec<bool> = heads.collect();
        let mut neighbours = vec![Vec::new(); self.heights.len()];
        for pipe in self.pipes.iter().filter(|p| p.conductance > 0.0) {
            let [a, b] = pipe.ends;
            neighbours[a as usize].push(b);
            neighbours[b as usize].push(a);
        }
        let open = (0..).zip(&reached).filter(|(_, r)| **r);
        let mut open: Vec<u32> = open.map(|(n, _)| n).collect();
        while let Some(n) = open.pop() {
            for &other in &neighbours[n as usize] {
                if !std::mem::replace(&mut reached[other as usize], true) {
                    open.push(other);
                }
            }
        }
        reached
    }
}
