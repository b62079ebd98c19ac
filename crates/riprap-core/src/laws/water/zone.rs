//! Where a water table acts.

use riprap_geom::{Vec2, Vec3};
use serde::{Deserialize, Serialize};

use super::{Start, keep};

/// A box: the table presses on what of the faces of blocks lies in it at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Zone {
    /// Lowest coordinates, m; in the plane y is without bounds and z the height.
    pub low: Vec3,
    /// Highest coordinates, m.
    pub high: Vec3,
}

/// What of a block lies in a zone.
pub(super) enum Share {
    Nothing,
    All,
    Part(Zone),
}

impl Zone {
    /// Whether a place lies in it, its faces included.
    #[must_use]
    pub fn holds(&self, at: Vec3) -> bool {
        at.cmpge(self.low).all() && at.cmple(self.high).all()
    }

    /// What two zones have in common, if anything.
    #[must_use]
    pub fn common(&self, other: &Zone) -> Option<Zone> {
        let (low, high) = (self.low.max(other.low), self.high.min(other.high));
        low.cmple(high).all().then_some(Zone { low, high })
    }

    /// What of a block of this radius about a place it holds.
    pub(super) fn share(&self, centre: Vec3, radius: f64) -> Share {
        let reach = Vec3::splat(radius);
        if self.holds(centre - reach) && self.holds(centre + reach) {
            return Share::All;
        }
        let misses =
            (centre + reach).cmplt(self.low).any() || (centre - reach).cmpgt(self.high).any();
        if misses { Share::Nothing } else { Share::Part(*self) }
    }

    /// The part of a flat convex polygon that lay in it at the start.
    #[must_use]
    pub fn clip(&self, face: &[Vec3], start: Start<'_, Vec3>) -> Vec<Vec3> {
        let mut part = face.to_vec();
        for axis in 0..3 {
            for (bound, sign) in [(self.low[axis], 1.0), (self.high[axis], -1.0)] {
                if bound.is_finite() && part.len() > 2 {
                    part = keep(&part, &|r: Vec3| sign * (start(r)[axis] - bound));
                }
            }
        }
        part
    }

    /// The stretch of an edge that it holds in the plane, as shares of its length; the second below the first where there is none.
    #[must_use]
    pub fn shares(&self, from: Vec2, to: Vec2) -> [f64; 2] {
        let (mut s, mut t) = (0.0_f64, 1.0_f64);
        for (low, high, a, b) in
            [(self.low.x, self.high.x, from.x, to.x), (self.low.z, self.high.z, from.y, to.y)]
        {
            let run = b - a;
            // Along a bound it is in or out as a whole.
            if run == 0.0 {
                if a < low || a > high {
                    return [1.0, 0.0];
                }
                continue;
            }
            let (p, q) = ((low - a) / run, (high - a) / run);
            s = s.max(p.min(q));
            t = t.min(p.max(q));
        }
        [s, t]
    }
}
