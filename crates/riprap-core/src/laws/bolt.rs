//! Bolts, cables and dowels: an axial bar in grout, a plate at its head, a shear spring where it crosses a joint.
//!
//! A bolt is a chain of nodes with bars between them. `r_i` is how far the bar has moved along the bolt against the rock at node `i`
//! (positive towards the toe), and a bar between two nodes elongates by `r_(i+1) - r_i + D_i`, where `D_i` is by how much the
//! points of the rock at its ends have moved apart. The chain has no mass: at each step it is in equilibrium,
//!
//! ```text
//! h_i(r_i) + N_(i-1) - N_i = 0,    N_i = B_i (r_(i+1) - r_i + D_i - p_i),    h_i = G_i (r_i - slip_i)
//! ```
//!
//! with a bar that yields (`p_i` plastic elongation) and hardens and breaks, grout that slips and a plate that lifts or gives way, by return
//! mapping from the state of the last step. Rock at the ends of a bar is pulled together by `N_i`: no force is lost whatever is left of the
//! equation above.
//!
//! Sources: the cable element of UDEC and 3DEC (elastic-plastic bar in elastic-plastic grout); Lorig (1985). The form without masses in terms
//! of `r` is ours. Deviation: rupture by elongation and not by strain, since a perfectly plastic bar yields in one element only,
//! whatever its length; grout strength does not grow with confinement.

mod ahead;
mod closed;
mod keep;
mod lay;
pub mod place;
mod seen;
mod solve;

use std::ops::{Add, Mul};

use serde::{Deserialize, Serialize};

pub use ahead::Ahead;
pub use closed::{
    dowel_limit, dowel_stiffness, pull_out_load, pull_out_stiffness, transfer_length,
};
pub use keep::{BoltScratch, Kept, Toll};
pub use lay::{Design, Laid, bar, lay};
pub use seen::{BarState, largest};
pub use solve::{Chain, Factors, Losses};

/// What holds a node of a bar in the rock: a spring that gives way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hold {
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Least force, N.
    pub low: f64,
    /// Largest force, N.
    pub high: f64,
    /// Whether it lets go at the least force without slipping: a plate that lifts off.
    pub lifts: bool,
}

/// Force of a spring that gives way, its tangent, and what it slips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapped {
    /// Force, N.
    pub force: f64,
    /// Tangent, N/m.
    pub tangent: f64,
    /// What has slipped or yielded, m.
    pub plastic: f64,
}

impl Hold {
    /// Grout around a piece of a bar: `stiffness` (N/m) and `strength` (N) of the piece.
    #[must_use]
    pub fn grout(stiffness: f64, strength: f64) -> Self {
        Self { stiffness, low: -strength, high: strength, lifts: false }
    }

    /// A plate at the head: it holds the head against being pulled in, up to its `capacity` (N), and lifts off where nothing pulls.
    #[must_use]
    pub fn plate(stiffness: f64, capacity: f64) -> Self {
        Self { stiffness, low: 0.0, high: capacity, lifts: true }
    }

    /// The force for a motion of the bar against the rock (m) beyond what has slipped.
    #[inline(always)]
    #[must_use]
    pub fn map(&self, elastic: f64) -> Mapped {
        let trial = self.stiffness * elastic;
        if trial > self.high {
            return Mapped {
                force: self.high,
                tangent: 0.0,
                plastic: (trial - self.high) / self.stiffness,
            };
        }
        if trial < self.low {
            let plastic = if self.lifts { 0.0 } else { (trial - self.low) / self.stiffness };
            return Mapped { force: self.low, tangent: 0.0, plastic };
        }
        Mapped { force: trial, tangent: self.stiffness, plastic: 0.0 }
    }

    /// Energy stored at a force (N), J.
    #[must_use]
    pub fn stored(&self, force: f64) -> f64 {
        0.5 * force * force / self.stiffness
    }
}

/// A piece of the bar between two nodes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bar {
    /// Stiffness `EA/l`, N/m; 0 once it is broken.
    pub stiffness: f64,
    /// Force at which it begins to yield, N; infinite for a bar that does not.
    pub yields: f64,
    /// Growth of that force with the yielded length, N/m.
    pub hardening: f64,
    /// Plastic elongation at which it breaks, m; infinite for a bar that does not.
    pub breaks: f64,
}

impl Bar {
    /// The force for an elongation (m) beyond the plastic one, of a bar that has yielded by `yielded` (m) in all.
    #[inline(always)]
    #[must_use]
    pub fn map(&self, elastic: f64, yielded: f64) -> Mapped {
        let trial = self.stiffness * elastic;
        let limit = self.yields + self.hardening * yielded;
        let over = trial.abs() - limit;
        if over > 0.0 && self.stiffness > 0.0 {
            // So that what the spring loses and what the limit gains meet: trial - k p = limit + h p.
            let plastic = over / (self.stiffness + self.hardening);
            return Mapped {
                force: (limit + self.hardening * plastic).copysign(trial),
                tangent: self.stiffness * self.hardening / (self.stiffness + self.hardening),
                plastic: plastic.copysign(trial),
            };
        }
        Mapped { force: trial, tangent: self.stiffness, plastic: 0.0 }
    }

    /// Energy stored at a force (N), J.
    #[must_use]
    pub fn stored(&self, force: f64) -> f64 {
        if self.stiffness > 0.0 { 0.5 * force * force / self.stiffness } else { 0.0 }
    }
}

/// Present chord (m) between two points of the rock that were `start` (m) apart and have moved by `moved` (m) against each other since, and
/// by how much it is longer than then, m. V is a vector of the plane or of space, `dot` its scalar product.
#[inline(always)]
#[must_use]
pub fn chord<V>(start: V, moved: V, dot: impl Fn(V, V) -> f64) -> (V, f64)
where
    V: Copy + Add<Output = V> + Mul<f64, Output = V>,
{
    let now = start + moved;
    // Without the difference of two lengths.
    let lengths = dot(now, now).sqrt() + dot(start, start).sqrt();
    (now, dot(moved, start * 2.0 + moved) / lengths)
}

/// Force (N) of a dowel on the side behind against a jump (m) across the bolt, and what it has slipped by then.
///
/// An elastic spring of `stiffness` (N/m) up to `limit` (N) in any direction.
#[must_use]
fn dowel<const N: usize>(
    stiffness: f64,
    limit: f64,
    jump: [f64; N],
    slip: [f64; N],
) -> ([f64; N], [f64; N]) {
    let trial: [f64; N] = std::array::from_fn(|k| stiffness * (jump[k] - slip[k]));
    let size = trial.iter().map(|f| f * f).sum::<f64>().sqrt();
    if size <= limit {
        return (trial, slip);
    }
    let force = trial.map(|f| f * (limit / size));
    let slip = std::array::from_fn(|k| jump[k] - force[k] / stiffness);
    (force, slip)
}

/// What a dowel remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheared<const N: usize> {
    /// What has slipped, m, across the axis.
    pub slip: [f64; N],
    /// Force on the side behind, N.
    pub force: [f64; N],
}

impl<const N: usize> Sheared<N> {
    /// A dowel of `[stiffness, limit]` (N/m, N) after the sides of its joint have parted by `jump` (m), of which what is along the unit
    /// direction `axis` does not count; a `broken` one, whose bar is gone, loses what it holds. Then the energy lost, J.
    #[must_use]
    pub fn after(
        &self,
        [stiffness, limit]: [f64; 2],
        broken: bool,
        axis: [f64; N],
        jump: [f64; N],
    ) -> (Self, f64) {
        let along: f64 = (0..N).map(|k| jump[k] * axis[k]).sum();
        let across = std::array::from_fn(|k| jump[k] - along * axis[k]);
        let limit = if broken { 0.0 } else { limit };
        let (force, slip) = dowel(stiffness, limit, across, self.slip);
        // What slips under its force; with the bar gone, all that it stored.
        let lost = if limit > 0.0 {
            (0..N).map(|k| force[k] * (slip[k] - self.slip[k])).sum()
        } else {
            0.5 * self.force.iter().map(|f| f * f).sum::<f64>() / stiffness
        };
        (Self { slip, force }, lost)
    }
}

#[cfg(test)]
mod tests;
