//! Rules of steady seepage under a water table.

use serde::{Deserialize, Serialize};

/// Steady seepage: the table gives the heads on open faces, the flow through the joints those inside.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Steady {
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Hydraulic aperture of joints at the start, m; what they open adds to it.
    pub aperture: f64,
    /// Smallest and largest hydraulic aperture, m.
    pub limits: [f64; 2],
    /// Steps after which heads are found anew.
    pub every: u64,
    /// Sides of the model through which no water goes.
    pub closed: Vec<Side>,
    /// Drains in the plane.
    pub drains: Vec<Drain>,
    /// Drains in space.
    pub curtains: Vec<Curtain>,
}

/// A side of a model: the line or plane on which one coordinate has a value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Side {
    /// 0 for x, 1 for y, 2 for z.
    pub axis: usize,
    /// m.
    pub at: f64,
}

impl Side {
    /// Whether a place lies on it, within `slack` (m).
    #[must_use]
    pub fn holds<const N: usize>(&self, place: [f64; N], slack: f64) -> bool {
        (place[self.axis] - self.at).abs() <= slack
    }
}

/// A line of drain holes: water leaves joints where it crosses them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drain {
    /// One end, m.
    pub from: [f64; 2],
    /// The other, m.
    pub to: [f64; 2],
    /// Head that it holds, m; where it is not given the drain is open: no pressure.
    pub head: Option<f64>,
}

impl Drain {
    /// Distance of a place from it, m.
    #[must_use]
    pub fn distance(&self, place: [f64; 2]) -> f64 {
        let along = [self.to[0] - self.from[0], self.to[1] - self.from[1]];
        let out = [place[0] - self.from[0], place[1] - self.from[1]];
        let squared = along[0] * along[0] + along[1] * along[1];
        // A drain without length is its one end.
        let share = (out[0] * along[0] + out[1] * along[1]) / squared.max(f64::MIN_POSITIVE);
        let share = share.clamp(0.0, 1.0);
        super::super::norm(out[0] - share * along[0], out[1] - share * along[1])
    }
}

/// A row of drain holes in space, side by side like a curtain: the parallelogram between the first and the last.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curtain {
    /// Mouth of the first hole, m.
    pub from: [f64; 3],
    /// From its mouth to its end, m.
    pub hole: [f64; 3],
    /// From it to the last one, m.
    pub row: [f64; 3],
    /// Head that it holds, m; where it is not given the drain is open: no pressure.
    pub head: Option<f64>,
}
