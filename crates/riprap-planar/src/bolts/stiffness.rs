//! What bolts add to the springs of the model, for the stable time step: the elastic chain as it was built.

use crate::world::{Bolt, Pin, World};

impl World {
    /// Springs of bolts: block, square of the distance from its centroid (m²), stiffness (N/m per metre).
    ///
    /// The stiffness matrix of a chain between the blocks that it ties together is at most the diagonal of the sums of the sizes in its rows
    /// (Gershgorin); yield, slip, lifting plates and rupture only make it softer.
    pub(crate) fn bolt_springs(&self) -> Vec<(usize, f64, f64)> {
        let mut all = Vec::new();
        for bolt in &self.bolts {
            let mut add = |pins: [&Pin; 2], k: f64| {
                for pin in pins {
                    all.push((pin.block as usize, pin.arm.length_squared(), k));
                }
            };
            for (bar, k) in rows(bolt) {
                add([&bolt.pins[bar], &bolt.pins[bar + 1]], k);
            }
            let design = &self.setup.bolts[bolt.number as usize].design;
            if let Some([stiffness, _]) = design.dowel {
                for dowel in &bolt.dowels {
                    let [behind, ahead] = &dowel.sides;
                    add([behind, ahead], stiffness);
                }
            }
        }
        all
    }
}

/// Bars between two blocks with the sum of the sizes in their row of the stiffness matrix, N/m per metre.
fn rows(bolt: &Bolt) -> Vec<(usize, f64)> {
    let bars = bolt.chain.bars.len();
    let ties: Vec<usize> = (0..bars).filter(|k| bolt.stretches(*k)).collect();
    let mut factors = bolt.chain.factors();
    let mut sums = vec![0.0; ties.len()];
    let (mut apart, mut forces) = (vec![0.0; bars], vec![0.0; bars]);
    for &tie in &ties {
        apart[tie] = 1.0;
        factors.elastic_forces(&bolt.chain, &apart, &mut forces);
        apart[tie] = 0.0;
        for (sum, k) in sums.iter_mut().zip(&ties) {
            *sum += forces[*k].abs();
        }
    }
    ties.into_iter().zip(sums).collect()
}
