//! Static phases: dynamic relaxation with a fictitious mass for each node.
//!
//! The step is 1 and `m_i = 1.05/4 sum_j |K_ij|` (rows of blocks and bonds, the largest of the three components): by Gershgorin's
//! theorem every mode is stable, and all of them converge at a like pace whatever the size of the blocks. Damping is
//! adaptive: every 25 iterations `c = min(1.5, 2 sqrt(-du.dr / du.M du))`, nearly critical for the mode that still moves.
//! Converged when the net force on free nodes is below a share of the external forces or the reactions,
//! whichever are larger.

use crate::state::deform::{Deform, Facet};
pub use crate::state::relax::{Breaks, Relax, Relaxation, Seen};
use crate::state::workspace::{BlockClass, Workspace};
use riprap_geom::Vec3;

/// Iterations between two looks at convergence and damping.
pub const CHECK_INTERVAL: u32 = 25;
/// Share by which the masses exceed the limit of stability.
pub(crate) const MARGIN: f64 = 1.05;
/// Largest damping.
const MOST: f64 = 1.5;
/// Forces below this share of the largest so far are none: a body in two parts would never be at rest by round-off.
const REST: f64 = 1e-6;
/// Masses on bonds, over those that keep a linear model stable, where bonds break in every iteration under little damping. A broken
/// bond is a contact. One that is closed from step `a` to step `b` makes `k/2 (d_b g_(b+1) - d_a g_(a-1))` (depths `d` inside, gaps `g`
/// beside): with the masses of the linear model a node comes back with three times its energy, in the mean over where the step falls,
/// and at most eight times; with four times these masses with 1.002 times.
const CONTACT: f64 = 4.0;
/// Damping before the first look.
const FIRST: f64 = 0.5;

impl Relax {
    /// The start of a phase.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self { damping: FIRST, tolerance, ratio: f64::INFINITY, ..Self::default() }
    }

    /// Begins anew: loads or bonds have changed.
    pub fn disturb(&mut self) {
        self.since = 0;
        self.iterations = 0;
        self.converged = false;
        self.settled = false;
        self.ratio = f64::INFINITY;
        self.last = None;
        self.energy = None;
    }

    /// Looks at convergence and damping where it is time; to be called once an iteration, after the forces are
    /// known.
    pub fn look(
        &mut self,
        nodes: &crate::state::deform::Nodes,
        work: &Workspace,
        loads: &[[f64; 3]],
    ) {
        let [net, reactions, external] = work.norms;
        self.largest = self.largest.max(reactions).max(external);
        let scale = reactions.max(external).max(REST * self.largest);
        let ratio = if net == 0.0 { 0.0 } else { net / scale };
        self.iterations += 1;
        self.since += 1;
        if self.since < CHECK_INTERVAL {
            return;
        }
        self.since = 0;
        self.settled = false;
        self.ratio = ratio;
        self.converged = match self.relaxation.energy {
            None => ratio <= self.tolerance,
            Some(share) => {
                let energy = elastic(nodes, work, loads);
                let before = self.energy.replace(energy);
                before.is_some_and(|before| (energy - before).abs() <= share * energy.abs())
            }
        };
        if let Some(damping) = self.relaxation.damping {
            self.damping = damping;
            return;
        }
        // Nothing to compare with after a disturbance: the damping stays that of before.
        if let Some(last) = &self.last {
            let (mut stiff, mut heavy) = (0.0, 0.0);
            for k in 0..nodes.displacement.len() {
                let mass = work.fictitious[k];
                for axis in 0..3 {
                    let du = nodes.displacement[k][axis] - last.displacement[k][axis];
                    // A net force falls as its node moves on: du.K du is minus du.dr.
                    stiff -= du * (work.net[k][axis] - last.net[k][axis]);
                    heavy += mass * du * du;
                }
            }
            if heavy > 0.0 {
                self.damping = MOST.min(2.0 * (stiff / heavy).max(0.0).sqrt());
            }
        }
        self.last = Some(Seen { displacement: nodes.displacement.clone(), net: work.net.clone() });
    }
}

/// Elastic energy, J: half the work of the internal forces, exact for small strain without friction.
fn elastic(nodes: &crate::state::deform::Nodes, work: &Workspace, loads: &[[f64; 3]]) -> f64 {
    let mut sum = 0.0;
    for (k, (u, net)) in nodes.displacement.iter().zip(&work.net).enumerate() {
        let load = loads.get(k).copied().unwrap_or_default();
        for axis in 0..3 {
            sum += u[axis] * (load[axis] - net[axis]);
        }
    }
    0.5 * sum
}

/// Fictitious masses of all nodes.
#[must_use]
pub fn masses(deform: &Deform, classes: &[BlockClass]) -> Vec<f64> {
    let always = (deform.relax.as_ref()).is_some_and(|r| r.relaxation.breaks == Breaks::Always);
    let share = if always { CONTACT } else { 1.0 };
    let mut sums = row_sums(deform, classes, share);
    for sum in &mut sums {
        *sum *= MARGIN / 4.0;
    }
    sums
}

/// Adds to fictitious masses what further row sums of the stiffness (N/m) need, by node.
pub fn add(masses: &mut [f64], row_sums: &[f64]) {
    for (mass, sum) in masses.iter_mut().zip(row_sums) {
        *mass += MARGIN / 4.0 * sum;
    }
}

/// Row sums `sum_j |K_ij|` of the stiffness of blocks and bonds, the largest component of each node, N/m; those of bonds times `share`.
#[must_use]
pub fn row_sums(deform: &Deform, classes: &[BlockClass], share: f64) -> Vec<f64> {
    let mut sums = vec![0.0; deform.nodes.len()];
    for body in &deform.bodies {
        let own = &classes[body.class as usize].row_sums;
        sums[body.nodes()].copy_from_slice(own);
    }
    let mut bonds = vec![Vec3::ZERO; deform.nodes.len()];
    for facet in &deform.facets {
        let rows = rows(facet);
        for point in &deform.points[facet.points()] {
            let of = |side: usize| {
                if facet.rigid[side] {
                    1.0
                } else {
                    point.anchors[side].nodes().map(|(_, w)| w.abs()).sum()
                }
            };
            let all = of(0) + of(1);
            for side in (0..2).filter(|s| !facet.rigid[*s]) {
                let anchor = &point.anchors[side];
                for (node, weight) in anchor.nodes() {
                    // K_ij of a bond is the product of the weights at i and at j,
                    // so a row has its own weight times all of them.
                    bonds[node as usize] += weight.abs() * all * point.area * rows;
                }
            }
        }
    }
    for (sum, bond) in sums.iter_mut().zip(&bonds) {
        *sum += share * bond.max_element();
    }
    sums
}

/// Row sums of `kn n n^T + ks (1 - n n^T)`, Pa/m.
fn rows(facet: &Facet) -> Vec3 {
    let n = facet.frame[0];
    let [kn, ks] = facet.stiffness;
    Vec3::from_array([0, 1, 2].map(|i| {
        (0..3)
            .map(|j| {
                let one = if i == j { ks } else { 0.0 };
                (one + (kn - ks) * n[i] * n[j]).abs()
            })
            .sum()
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Energy after a bounce off a spring that only presses, over that before, and what the depths and gaps at its ends say; `share`
    /// of the masses of the linear model, the spring at the bound of Gershgorin; `depth` of the first step inside, over the way of a step.
    fn bounce(share: f64, depth: f64) -> [f64; 2] {
        let stiffness = 4.0 / (MARGIN * share);
        let (mut at, mut speed) = (-depth, -1.0);
        loop {
            let last = at;
            speed += stiffness * f64::max(-at, 0.0);
            at += speed;
            if at >= 0.0 && last < 0.0 {
                let made = stiffness * (-last * at - depth * (1.0 - depth));
                return [speed * speed, 1.0 + made];
            }
        }
    }

    /// Why breaking in every iteration asks for heavier nodes: the literal beam of the fracture paper made energy without bound.
    #[test]
    fn a_bounce_off_a_broken_bond_makes_less_energy_than_damping_takes() {
        let energies = |share: f64| {
            let all = (1..1000).map(|k| {
                let [energy, told] = bounce(share, f64::from(k) * 1e-3);
                assert!((energy - told).abs() < 1e-12, "{energy} {told}");
                energy
            });
            all.collect::<Vec<f64>>()
        };
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len() as f64;
        let light = energies(1.0);
        assert!((mean(&light) - 3.0).abs() < 0.05, "{}", mean(&light));
        assert!(light.iter().copied().fold(0.0, f64::max) > 7.8);
        // The paper's damping takes 2 % of the speed in a step, and a bounce has two steps at least.
        assert!(mean(&energies(CONTACT)) < 1.005);
    }
}
